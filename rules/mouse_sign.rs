//! The click position in `iMouse.zw`, used without removing its sign, and its sign used as a button.

use shaderlint_lint::prelude::*;

rule! { mouse_sign, Webgl2, Warning, Recommended, Binary(check_binary), Builtin(check_distance) }

fn check_binary(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Greater, GreaterEqual, Less, LessEqual};
    if matches!(e.op, Less | LessEqual | Greater | GreaterEqual) {
        check_held(cx, e);
    }
    if e.op == BinaryOp::Sub && cx.program.ty(e.id).scalar_kind() == Some(Scalar::Float) {
        check(cx, e.left, e.right);
    }
}

/// Reports a test of the sign of `iMouse.w` in an image, which has no memory of the click.
fn check_held(cx: &mut Context, e: &BinaryExpr) {
    if cx.program.dialect != Dialect::ShaderToy(Pass::Image)
        || cx.program.names.get("iMouse").is_none()
    {
        return;
    }
    // `w < 0.0` holds after the first click, and `w >= 0.0` before it.
    let is_limit = |e: ExprId, least: bool| {
        let limit = cx.program.scalar(e).map(|v| v.as_float());
        limit.is_some_and(|limit| limit > 0.0 || least && limit == 0.0)
    };
    let is_strict = matches!(e.op, BinaryOp::Less | BinaryOp::Greater);
    let is_lower = matches!(e.op, BinaryOp::Greater | BinaryOp::GreaterEqual);
    let is_tested = is_mouse(cx, e.left, 3) && is_limit(e.right, is_lower == is_strict)
        || is_mouse(cx, e.right, 3) && is_limit(e.left, is_lower != is_strict);
    if !is_tested || has_button_test(cx, e.id) {
        return;
    }
    cx.report_expr(
        e.id,
        "`iMouse.w` is positive only in the frame of the click",
    )
    .note(
        "an image has no memory, so this is true for one frame, whether the button is held or not",
    )
    .help("use `iMouse.z > 0.0` for a button that is down");
}

/// Whether an expression is a component of `iMouse`.
fn is_mouse(cx: &Context, e: ExprId, lane: u32) -> bool {
    let Some(op) = cx.facts.module().op_of(e) else {
        return false;
    };
    let is_scalar = cx.facts.module().ty(op).is_scalar();
    let origin = cx.facts.origin(op, 0).filter(|_| is_scalar);
    matches!(origin, Some(Start::Given(_, given)) if given == lane)
        && cx.facts.is_given(origin, "iMouse")
}

/// Whether the condition around a comparison tests `iMouse.z`, too: the two states are distinguished.
fn has_button_test(cx: &Context, e: ExprId) -> bool {
    let (structure, tree) = (cx.facts.structure(), &cx.program.tree);
    let mut around = e;
    while let Some(outer) = structure.parent(around) {
        let is_joined = matches!(
            tree.expr(outer).kind,
            ExprKind::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, ..)
                | ExprKind::Paren(_)
                | ExprKind::Unary(..)
        );
        if !is_joined {
            break;
        }
        around = outer;
    }
    let mut todo = vec![around];
    while let Some(next) = todo.pop() {
        if is_mouse(cx, next, 2) {
            return true;
        }
        each_operand(tree, tree.expr(next), |child| todo.push(child));
    }
    false
}

fn check_distance(cx: &mut Context, call: &Builtin) {
    if let (BuiltinId::Distance, &[a, b]) = (call.function, call.args) {
        check(cx, a, b);
    }
}

/// Reports a difference of two positions, one of them `iMouse.zw` with its sign.
fn check(cx: &mut Context, a: ExprId, b: ExprId) {
    let program = cx.program;
    if program.names.get("iMouse").is_none() {
        return;
    }
    let module = cx.facts.module();
    let Some((left, right)) = module.op_of(a).zip(module.op_of(b)) else {
        return;
    };
    let found =
        [(a, left, right), (b, right, left)]
            .into_iter()
            .find_map(|(expr, click, place)| {
                let lanes = 0..module.ty(click).components();
                let lane = lanes
                    .into_iter()
                    .find(|&lane| is_click(cx, click, lane) && is_place(cx, place, lane))?;
                Some((expr, lane))
            });
    let Some((click, _)) = found else { return };
    cx.report_expr(click, "click position `iMouse.zw` is used without `abs`")
        .note(
            "`iMouse.z` is negative while the button is up; `iMouse.w` is negative except in \
            the frame of the click",
        )
        .help("use `abs(iMouse.zw)`");
}

/// The origin of a lane, ignoring scale factors.
fn unscaled(cx: &Context, mut op: OpId, mut lane: u32) -> Option<Start> {
    let module = cx.facts.module();
    for _ in 0..8 {
        let origin = cx.facts.origin(op, lane)?;
        let Start::Made(made, at) = origin else {
            return Some(origin);
        };
        let OpKind::Binary(Binary::Divide | Binary::Multiply, a, _) = module.op(made).kind else {
            return None;
        };
        (op, lane) = (a, module.operand_lane(a, at));
    }
    None
}

/// Whether a lane is `iMouse.z` or `iMouse.w`, and no condition excludes that it is negative.
fn is_click(cx: &Context, op: OpId, lane: u32) -> bool {
    let origin = unscaled(cx, op, lane);
    let is_lane = matches!(origin, Some(Start::Given(_, 2 | 3)));
    is_lane
        && cx.facts.is_given(origin, "iMouse")
        && cx.facts.ranges().lane(op, lane).lo.value < 0.0
}

/// Whether a lane is a pixel or mouse coordinate.
fn is_place(cx: &Context, op: OpId, lane: u32) -> bool {
    let origin = unscaled(cx, op, lane);
    let is_lane = matches!(origin, Some(Start::Given(_, 0 | 1)));
    is_lane && (cx.facts.is_given(origin, "iMouse") || cx.facts.is_given(origin, "gl_FragCoord"))
}
