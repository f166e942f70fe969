//! One matrix multiplied by vectors from both sides.

use shaderlint_flow::is_same;
use shaderlint_lint::prelude::*;

rule! { vector_times_matrix, Numeric, Info, All, Program(check) }

/// Most products `m * v` that each `v * m` is compared with.
const MOST: usize = 64;

fn check(cx: &mut Context) {
    let module = cx.facts.module();
    let ops = (0..).map(OpId).zip(&module.ops);
    let products: Vec<(OpId, OpId, OpId)> = ops
        .filter_map(|(op, made)| match made.kind {
            OpKind::MatrixProduct(a, b) => Some((op, a, b)),
            _ => None,
        })
        .collect();
    let after = products
        .iter()
        .filter(|(_, _, v)| module.ty(*v).is_vector());
    let after: Vec<(OpId, OpId)> = after.map(|(op, m, _)| (*op, *m)).take(MOST).collect();
    for (op, vector, matrix) in products {
        if !module.ty(vector).is_vector() {
            continue;
        }
        let defs = cx.facts.reaching_definitions();
        let same = after
            .iter()
            .find(|(_, m)| is_same(module, defs, *m, matrix));
        let Some((other, _)) = same else { continue };
        let Some(extent) = module.provenance(*other).extent(&cx.program.tree) else {
            continue;
        };
        let at = cx.program.span(extent);
        cx.report_op(
            op,
            "`v * m` is used together with `m * v` for the same matrix",
        )
        .mark("vector times matrix")
        .label(at, "matrix times vector")
        .note("`v * m` equals `transpose(m) * v`, which is the inverse of a rotation")
        .help("use `m * v`, or `transpose(m) * v` if this is intended");
    }
}
