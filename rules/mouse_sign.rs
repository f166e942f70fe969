//! The click position in `iMouse.zw`, used without removing its sign.

use shaderlint_diagnostic::Severity;
use shaderlint_flow::Start;
use shaderlint_ir::{Binary, OpId, OpKind};
use shaderlint_lint::{BinaryExpr, Builtin, Check, Context, Group, Rule, RulePreset};
use shaderlint_semantic::{BuiltinId, Scalar};
use shaderlint_syntax::ast::{BinaryOp, ExprId};

pub static RULE: Rule = Rule {
    name: "mouse-sign",
    group: Group::Webgl2,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
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
