//! `texelFetch` of texels outside the texture.

use shaderlint_flow::reaching_definitions::condition::{each_comparison, each_load};
use shaderlint_lint::prelude::*;
use shaderlint_lint::screen::along;

rule! { texel_out_of_range, Portability, Info, Strict, Program(check) }

/// Reports the first such lookup only; the others read the same neighbours.
fn check(cx: &mut Context) {
    let module = cx.facts.module();
    let ops = (0..).map(OpId).zip(&module.ops);
    let fetches = ops.filter_map(|(op, made)| match made.kind {
        OpKind::Builtin(BuiltinId::TexelFetch, operands) => {
            Some((op, *module.operands(operands).get(1)?))
        }
        _ => None,
    });
    let mut fetches =
        fetches.filter(|(op, _)| matches!(module.provenance(*op), Provenance::Expr(_)));
    let found = fetches.find_map(|(op, place)| {
        let sides = (0..2).find_map(|lane| beyond(cx, place, lane))?;
        (!is_guarded(cx, op)).then_some((place, sides))
    });
    let Some((place, side)) = found else { return };
    cx.report_op(place, format!("`texelFetch` reads outside the texture at the {side} edge"))
        .note("the result is undefined outside the texture (section 8.8): zero on some GPUs, the edge texel on others")
        .help("clamp the coordinates with `clamp`, or wrap them with `(p + size) % size`");
}

/// The edge that a component passes: pixel coordinates plus an offset.
fn beyond(cx: &Context, place: OpId, lane: u32) -> Option<&'static str> {
    let along = along(cx.facts, place, lane)?;
    if along.axis != lane || along.scale != 1.0 || along.share_of.is_some() {
        return None;
    }
    let (first, last) = match lane {
        0 => ("left", "right"),
        _ => ("lower", "upper"),
    };
    if along.offset.reaches_below(-0.6) {
        Some(first)
    } else {
        along.offset.reaches_above(0.6).then_some(last)
    }
}

/// Whether an enclosing condition tests the pixel coordinates.
fn is_guarded(cx: &Context, op: OpId) -> bool {
    let (module, defs) = (cx.facts.module(), cx.facts.reaching_definitions());
    let mut is_guarded = false;
    for (_, guard) in defs.guards(op) {
        each_comparison(module, defs, guard.condition, guard.truth, |premise| {
            each_load(module, defs, premise, |load, lane, _| {
                is_guarded |= along(cx.facts, load, lane).is_some();
            });
        });
    }
    is_guarded
}
