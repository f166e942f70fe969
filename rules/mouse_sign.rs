//! The place of a click, taken with its sign.

use shaderlint_diagnostic::Severity;
use shaderlint_flow::Start;
use shaderlint_ir::{Binary, OpId, OpKind};
use shaderlint_lint::{BinaryExpr, Builtin, Check, Context, Group, Rule};
use shaderlint_semantic::{BuiltinId, Scalar};
use shaderlint_syntax::ast::{BinaryOp, ExprId};

pub static RULE: Rule = Rule {
    name: "mouse-sign",
    group: Group::Webgl2,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("mouse_sign.md"),
    checks: &[
        Check::Binary(check_difference),
        Check::Builtin(check_distance),
    ],
};

fn check_difference(cx: &mut Context, e: &BinaryExpr) {
    if e.op == BinaryOp::Sub && cx.program.ty(e.id).scalar_kind() == Some(Scalar::Float) {
        check(cx, e.left, e.right);
    }
}

fn check_distance(cx: &mut Context, call: &Builtin) {
    if let (BuiltinId::Distance, &[a, b]) = (call.function, call.args) {
        check(cx, a, b);
    }
}

/// Two places of which one is that of a click.
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
    cx.report_expr(click, "the place of the click is negative most of the time")
        .note("`iMouse.z` is negative while no button is down, and `iMouse.w` but in the frame of the click")
        .help("take `abs(iMouse.zw)`");
}

/// What a lane is, scaling aside.
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
        (op, lane) = (a, if module.ty(a).is_scalar() { 0 } else { at });
    }
    None
}

/// Whether a lane is `iMouse.z` or `iMouse.w`, and no condition tells that it is not negative.
fn is_click(cx: &Context, op: OpId, lane: u32) -> bool {
    let origin = unscaled(cx, op, lane);
    let is_lane = matches!(origin, Some(Start::Given(_, 2 | 3)));
    is_lane
        && cx.facts.is_given(origin, "iMouse")
        && cx.facts.ranges().lane(op, lane).lo.value < 0.0
}

/// Whether a lane is a place in the picture: that of the pixel, or of the mouse.
fn is_place(cx: &Context, op: OpId, lane: u32) -> bool {
    let origin = unscaled(cx, op, lane);
    let is_lane = matches!(origin, Some(Start::Given(_, 0 | 1)));
    is_lane && (cx.facts.is_given(origin, "iMouse") || cx.facts.is_given(origin, "gl_FragCoord"))
}
