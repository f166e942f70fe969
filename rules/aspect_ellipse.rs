//! Circles that are drawn as ellipses, and rotations that shear, on a canvas that is not square.

use shaderlint_lint::prelude::*;
use shaderlint_lint::screen::{Along, along};

rule! {
    aspect_ellipse, Look, Info, Recommended,
    Builtin(check_call), Binary(check_comparison), Program(check_rotations)
}

/// Widest ramp of `smoothstep` that still counts as a sharp edge.
const EDGE: f64 = 0.05;
const UNITS: &str =
    "x is a fraction of the width and y of the height, so their units differ in length";
const HELP: &str = "divide both coordinates by the height: \
    `(2.0 * fragCoord - iResolution.xy) / iResolution.y`";

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
    .note(UNITS)
    .help(HELP);
}

/// Whether a distance is computed from x as a fraction of the width and y as one of the height.
fn is_squeezed(cx: &Context, distance: OpId) -> bool {
    let module = cx.facts.module();
    let OpKind::Builtin(_, operands) = module.op(distance).kind else {
        return false;
    };
    let operands = module.operands(operands);
    let is_flat = operands.iter().all(|o| module.ty(*o).components() == 2);
    let of = |op: OpId| shares(cx, op);
    let is_shared = |op: &OpId| !cx.facts.uniformity().varies(Varying::Value(*op));
    let place = match *operands {
        [v] => of(v),
        [a, b] if is_shared(&b) => of(a),
        [a, b] if is_shared(&a) => of(b),
        _ => None,
    };
    is_flat && place.is_some()
}

/// The coordinates of a point: x as a fraction of the width, and y as one of the height.
fn shares(cx: &Context, op: OpId) -> Option<[Along; 2]> {
    let [x, y] = [along(cx.facts, op, 0)?, along(cx.facts, op, 1)?];
    let is_share = x.share_of == Some(0) && y.share_of == Some(1);
    let is_even = (x.axis, y.axis) == (0, 1) && x.scale.abs() == y.scale.abs();
    (is_share && is_even).then_some([x, y])
}

/// Reports points with such coordinates that turn by an angle that changes from frame to frame.
fn check_rotations(cx: &mut Context) {
    let module = cx.facts.module();
    for (op, found) in (0..).map(OpId).zip(&module.ops) {
        let OpKind::MatrixProduct(a, b) = found.kind else {
            continue;
        };
        let (point, matrix) = match module.ty(a).is_matrix() {
            true => (b, a),
            false => (a, b),
        };
        let is_flat = module.ty(point).is_vector() && module.ty(point).components() == 2;
        if !is_flat || !is_rotation(cx, matrix) || shares(cx, point).is_none() {
            continue;
        }
        cx.report_op(
            op,
            "this rotation shears the image unless the canvas is square",
        )
        .note(UNITS)
        .help(HELP);
    }
}

/// Whether a 2x2 matrix rotates by an angle that is the same for all pixels, but not constant.
fn is_rotation(cx: &Context, matrix: OpId) -> bool {
    let facts = cx.facts;
    if facts.module().ty(matrix).components() != 4
        || facts.uniformity().varies(Varying::Value(matrix))
    {
        return false;
    }
    let layout = &facts.reaching_definitions().layout;
    let columns = (0..2).map(|column| layout.lane(facts.module().ty(matrix), column));
    let lanes = columns.flatten().flat_map(|first| [first, first + 1]);
    let entries: Option<Vec<RotationEntry>> = lanes.map(|lane| entry(cx, matrix, lane)).collect();
    let Some(entries) = entries else {
        return false;
    };
    let &[a, b, c, d] = entries.as_slice() else {
        return false;
    };
    let is_form = a.function == BuiltinId::Cos
        && a.is_negative == d.is_negative
        && d.function == BuiltinId::Cos
        && b.function == BuiltinId::Sin
        && c.function == BuiltinId::Sin
        && b.is_negative != c.is_negative;
    let is_number = |op: OpId| facts.ranges().lane(op, 0).single().is_some();
    let is_fixed = match facts.module().op(matrix).kind {
        // Other calls of the function may pass other angles.
        OpKind::Call(_, list) => {
            let mut arguments = facts.module().operands(list).iter();
            arguments.all(|argument| is_number(*argument))
        }
        _ => is_number(a.angle),
    };
    let is_same = [b, c, d]
        .iter()
        .all(|entry| entry.angle == a.angle || facts.is_same_value(entry.angle, a.angle));
    is_form && !is_fixed && is_same
}

/// An entry of a rotation matrix.
#[derive(Clone, Copy)]
struct RotationEntry {
    function: BuiltinId,
    angle: OpId,
    is_negative: bool,
}

fn entry(cx: &Context, matrix: OpId, lane: u32) -> Option<RotationEntry> {
    let module = cx.facts.module();
    let (mut at, mut is_negative) = (cx.facts.origin(matrix, lane)?, false);
    if let Start::Made(op, lane) = at
        && let OpKind::Unary(Unary::Negate, a) = module.op(op).kind
    {
        (at, is_negative) = (cx.facts.origin(a, module.operand_lane(a, lane))?, true);
    }
    let Start::Made(op, _) = at else { return None };
    let OpKind::Builtin(function @ (BuiltinId::Cos | BuiltinId::Sin), list) = module.op(op).kind
    else {
        return None;
    };
    let angle = *module.operands(list).first()?;
    module.ty(angle).is_scalar().then_some(RotationEntry {
        function,
        angle,
        is_negative,
    })
}
