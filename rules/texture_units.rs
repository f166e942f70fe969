//! Pixel coordinates passed to `texture`, and normalised coordinates passed to `texelFetch`.

use shaderlint_lint::prelude::*;
use shaderlint_lint::screen::along;

rule! { texture_units, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let &[_, place, ..] = call.args else { return };
    use BuiltinId::{TexelFetch, Texture, Texture2D, TextureLod};
    match call.function {
        Texture | Texture2D | TextureLod if is_in_pixels(cx, place) => {
            let name = call.function.name();
            cx.report_expr(place, format!("`{name}` expects coordinates from 0 to 1, found pixels"))
                .note("neighbouring pixels are an integer number of textures apart, so all read the same texel")
                .help("divide by `iResolution.xy`, or use `texelFetch(…, ivec2(…), 0)`");
        }
        TexelFetch if is_always_zero(cx, place) => {
            cx.report_expr(place, "`texelFetch` expects texels, but these coordinates are always 0")
                .note("conversion to an integer truncates values between -1 and 1 to 0, so all pixels read the same texel")
                .help("multiply by the texture size first, or use `texture`");
        }
        _ => {}
    }
}

/// Whether coordinates change by an integer from each pixel to the next.
fn is_in_pixels(cx: &Context, place: ExprId) -> bool {
    let Some(op) = cx.facts.module().op_of(place) else {
        return false;
    };
    let mut lanes = 0..cx.program.ty(place).components().min(2);
    lanes.all(|lane| {
        along(cx.facts, op, lane)
            .is_some_and(|a| a.share_of.is_none() && a.scale != 0.0 && a.scale.fract() == 0.0)
    })
}

/// Whether floats that vary between pixels are all truncated to 0.
fn is_always_zero(cx: &Context, place: ExprId) -> bool {
    let tree = &cx.program.tree;
    let ExprKind::Construct(_, args) = tree.expr(tree.unparen(place)).kind else {
        return false;
    };
    let args = tree.args(args);
    let module = cx.facts.module();
    let varies = args.iter().any(|arg| {
        let is_float = cx.program.ty(*arg).scalar_kind() == Some(Scalar::Float);
        let op = module
            .op_of(*arg)
            .filter(|op| !matches!(module.op(*op).kind, OpKind::Const(_)));
        is_float && op.is_some_and(|op| cx.facts.uniformity().varies(Varying::Value(op)))
    });
    let mut ranges = cx.facts.range(place).peekable();
    varies && ranges.peek().is_some() && ranges.all(|r| r.single() == Some(0.0))
}
