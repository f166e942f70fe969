//! `x != x` as a test for NaN.

use shaderlint_lint::prelude::*;

rule! { nan_compare, Numeric, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let is_float = program.ty(e.left).scalar_kind() == Some(Scalar::Float);
    let compares = matches!(e.op, BinaryOp::Equal | BinaryOp::NotEqual);
    if !compares || !is_float || !cx.facts.is_same(e.left, e.right) || program.expr(e.id).is_const {
        return;
    }
    let text = program.expr_text(e.left).to_string();
    let test = bit_test(
        e.op == BinaryOp::Equal,
        program.ty(e.left).components(),
        &text,
    );
    let fix = (cx.is_direct(e.id) && program.version == Version::Es300).then(|| {
        let edit = Edit::replace(program.expr_span(e.id), test.clone());
        Fix::suggestion(format!("test the bits: `{test}`"), vec![edit])
    });
    cx.report_expr(e.id, format!("`{text}` is compared with itself"))
        .note(
            "compilers may assume that a value equals itself and remove the test, so NaN can go \
            undetected",
        )
        .fix(fix);
}

/// A test for NaN that compilers cannot remove: `isnan` may be assumed to be false, but bits are integers.
fn bit_test(is_number: bool, components: u32, text: &str) -> String {
    let bits = format!("floatBitsToUint({text}) & 0x7FFFFFFFu");
    let limit = "0x7F800000u";
    match (components, is_number) {
        (1, true) => format!("({bits}) <= {limit}"),
        (1, false) => format!("({bits}) > {limit}"),
        (n, true) => format!("all(lessThanEqual({bits}, uvec{n}({limit})))"),
        (n, false) => format!("any(greaterThan({bits}, uvec{n}({limit})))"),
    }
}
