//! Texture lookups at the corners of texels.

use shaderlint_lint::prelude::*;

rule! { half_texel, Numeric, Info, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    use BuiltinId::{Texture, Texture2D, TextureLod};
    let (Texture | Texture2D | TextureLod, &[_, place, ..]) = (call.function, call.args) else {
        return;
    };
    let Some(op) = cx.facts.module().op_of(place) else {
        return;
    };
    if cx.program.ty(place).components() != 2 || !(0..2).all(|lane| is_corner(cx, op, lane)) {
        return;
    }
    cx.report_expr(place, "these texture coordinates lie on texel corners")
        .note("four texels meet there: filtering blends them, and without it rounding selects one")
        .help("add half a texel: `(p + 0.5) / size`, or use `texelFetch`");
}

/// Whether a component is an integer divided by the size of the image or of a channel.
fn is_corner(cx: &Context, op: OpId, lane: u32) -> bool {
    let module = cx.facts.module();
    let Some(Start::Made(made, lane)) = cx.facts.origin(op, lane) else {
        return false;
    };
    let OpKind::Binary(Binary::Divide, dividend, size) = module.op(made).kind else {
        return false;
    };
    let lane_of = |op| module.operand_lane(op, lane);
    is_size(cx, size, lane_of(size)) && is_counted(cx, dividend, lane_of(dividend))
}

fn is_size(cx: &Context, op: OpId, lane: u32) -> bool {
    let module = cx.facts.module();
    let start = cx.facts.origin(op, lane);
    if let Some(Start::Made(made, lane)) = start {
        return match module.op(made).kind {
            OpKind::Convert(a) => is_size(cx, a, lane),
            OpKind::Builtin(BuiltinId::TextureSize, _) => true,
            _ => false,
        };
    }
    ["iResolution", "iChannelResolution"]
        .iter()
        .any(|name| cx.facts.is_given(start, name))
}

/// Whether a component is an integer: rounded, or converted from one.
fn is_counted(cx: &Context, op: OpId, lane: u32) -> bool {
    use BuiltinId::{Ceil, Floor, Round, Trunc};
    let module = cx.facts.module();
    let Some(Start::Made(made, _)) = cx.facts.origin(op, lane) else {
        return false;
    };
    match module.op(made).kind {
        OpKind::Builtin(Floor | Ceil | Round | Trunc, _) => true,
        OpKind::Convert(a) => module.scalar(a).is_some_and(Scalar::is_integer),
        _ => false,
    }
}
