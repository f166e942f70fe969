//! Circles that are drawn as ellipses on a canvas that is not square.

use shaderlint_diagnostic::Severity;
use shaderlint_flow::Start;
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_lint::screen::{Along, along};
use shaderlint_lint::{BinaryExpr, Builtin, Check, Context, Group, Rule, RulePreset};
use shaderlint_semantic::BuiltinId;
use shaderlint_syntax::ast::{BinaryOp, ExprId};

pub static RULE: Rule = Rule {
    name: "aspect-ellipse",
    group: Group::Look,
    severity: Severity::Info,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("aspect_ellipse.md"),
    checks: &[Check::Builtin(check_call), Check::Binary(check_comparison)],
};

/// Widest ramp of `smoothstep` that still counts as a sharp edge.
const EDGE: f64 = 0.05;

fn check_call(cx: &mut Context, call: &Builtin) {
    match (call.function, call.args) {
        (BuiltinId::Step, &[a, b]) => {
            check(cx, a);
            check(cx, b);
        }
        (BuiltinId::Smoothstep, &[low, high, x]) => {
            let value = |e| cx.program.scalar(e).map(|v| f64::from(v.as_float()));
            let width = value(low).zip(value(high)).map(|(a, b)| (a - b).abs());
            if width.is_some_and(|w| w <= EDGE) {
                check(cx, x);
            }
        }
        _ => {}
    }
}

fn check_comparison(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Greater, GreaterEqual, Less, LessEqual};
    if matches!(e.op, Less | LessEqual | Greater | GreaterEqual) {
        check(cx, e.left);
        check(cx, e.right);
    }
}

/// Reports a compared value that is a squeezed distance, with or without a radius subtracted.
fn check(cx: &mut Context, compared: ExprId) {
    let module = cx.facts.module();
    let Some(op) = module.op_of(compared) else {
        return;
    };
    let mut distance = None;
    let is_all = cx.facts.trace(op, 0, |start| {
        let Start::Made(made, _) = start else {
            return false;
        };
        match module.op(made).kind {
            OpKind::Builtin(BuiltinId::Length | BuiltinId::Distance, _) => {
                distance = distance.or(Some(made));
                false
            }
            OpKind::Unary(Unary::Negate, _) => true,
            OpKind::Binary(Binary::Add | Binary::Subtract, ..) => true,
            _ => false,
        }
    });
    let Some(distance) = distance.filter(|d| is_all && is_squeezed(cx, *d)) else {
        return;
    };
    let Some(extent) = module.provenance(distance).extent(&cx.program.tree) else {
        return;
    };
    cx.report(
        extent,
        "this circle is drawn as an ellipse unless the canvas is square",
    )
    .note("x is a fraction of the width and y of the height, so their units differ in length")
    .help(
        "divide both coordinates by the height: \
        `(2.0 * fragCoord - iResolution.xy) / iResolution.y`",
    );
}

/// Whether a distance is computed from x as a fraction of the width and y as one of the height.
fn is_squeezed(cx: &Context, distance: OpId) -> bool {
    let module = cx.facts.module();
    let OpKind::Builtin(_, operands) = module.op(distance).kind else {
        return false;
    };
    let operands = module.operands(operands);
    let is_flat = operands.iter().all(|o| module.ty(*o).components() == 2);
    let of = |op: OpId| -> Option<[Along; 2]> {
        Some([along(cx.facts, op, 0)?, along(cx.facts, op, 1)?])
    };
    let is_shared = |op: &OpId| {
        !cx.facts
            .uniformity()
            .varies(shaderlint_flow::Varying::Value(*op))
    };
    let place = match *operands {
        [v] => of(v),
        [a, b] if is_shared(&b) => of(a),
        [a, b] if is_shared(&a) => of(b),
        _ => None,
    };
    place.filter(|_| is_flat).is_some_and(|[x, y]| {
        let is_share = x.share_of == Some(0) && y.share_of == Some(1);
        is_share && (x.axis, y.axis) == (0, 1) && x.scale.abs() == y.scale.abs()
    })
}
