//! `fract(sin(x) * 43758.5453)`: a hash that differs between GPUs.

use shaderlint_lint::formula::factors;
use shaderlint_lint::prelude::*;

rule! { sin_hash, Portability, Info, Strict, [Number(&FACTOR)], Builtin(check) }

static FACTOR: Setting<f64> = Setting::new(
    "factor",
    100.0,
    "Smallest factor of the sine that is reported",
);

/// Name of the function that the fix inserts.
const HASH: &str = "integerHash";
const ADVICE: &str = "use an integer hash: the same input gives the same result on every GPU";

fn check(cx: &mut Context, call: &Builtin) {
    let &[arg] = call.args else { return };
    if call.function != BuiltinId::Fract {
        return;
    }
    let program = cx.program;
    let factors = factors(program, arg);
    let limit = cx.option(&FACTOR);
    let is_large = factors.iter().any(|f| {
        let values = program.values(*f);
        values.iter().any(|v| v.as_float().abs() as f64 >= limit)
    });
    let sine = factors.iter().find_map(|f| sine(program, *f));
    let (Some(sine), true) = (sine, is_large) else {
        return;
    };
    let fix = fix(cx, call.id, sine);
    let finding = cx
        .report_expr(
            call.id,
            "sine hash gives different values on different GPUs",
        )
        .note(
            "the large factor amplifies the rounding error of the sine, which differs between GPUs",
        );
    match fix {
        Some(fix) => finding.fix(fix),
        None => finding.help(ADVICE),
    };
    cx.facts.mark_reported(cx.facts.module().op_of(call.id));
}

/// The argument of `sin` or `cos`.
fn sine(program: &Program, factor: ExprId) -> Option<ExprId> {
    let function = program.builtin_called(factor)?;
    let ExprKind::Call(_, args) = program.tree.expr(factor).kind else {
        return None;
    };
    let first = program.tree.args(args).first().copied();
    first.filter(|_| matches!(function, BuiltinId::Sin | BuiltinId::Cos))
}

/// Calls an integer hash instead, and inserts its definition before the calling function.
fn fix(cx: &Context, call: ExprId, sine: ExprId) -> Option<Fix> {
    let program = cx.program;
    let node = program.tree.expr(call);
    if program.version != Version::Es300 || program.ty(call) != Type::FLOAT {
        return None;
    }
    let key = key(program, sine);
    let function = cx.facts.structure().function_of_expr(call)?;
    let decl = program
        .tree
        .function(program.function(function)?.definition?)?;
    if !program.is_direct(node.extent) || !program.is_direct(Extent::token(decl.extent.first)) {
        return None;
    }
    let ty = program.ty(key);
    let (columns, size) = (ty.scalar_kind(), ty.components());
    if columns != Some(Scalar::Float) || !(1..=4).contains(&size) || ty.is_matrix() {
        return None;
    }
    let mut edits = vec![Edit::replace(
        program.expr_span(call),
        format!("{HASH}({})", program.expr_text(key)),
    )];
    let known = program.functions.iter().enumerate().any(|(i, f)| {
        let is_it =
            program.names.text(f.name) == HASH && f.params.first().map(|p| p.ty) == Some(ty);
        is_it && i < function.0 as usize
    });
    if !known {
        let start = program.token(decl.extent.first)?.span.start;
        edits.push(Edit::insert(start, definition(size)));
    }
    Some(Fix::suggestion(ADVICE, edits))
}

/// The input of the hash: `p` in `dot(p, vec2(12.9898, 78.233))`, or the whole argument of the sine.
fn key(program: &Program, sine: ExprId) -> ExprId {
    let at = program.tree.unparen(sine);
    match (program.builtin_called(at), program.tree.expr(at).kind) {
        (Some(BuiltinId::Dot), ExprKind::Call(_, args)) => match *program.tree.args(args) {
            [p, by] if program.expr(by).is_const => p,
            [by, p] if program.expr(by).is_const => p,
            _ => sine,
        },
        _ => sine,
    }
}

/// The definition of an integer hash of a float or of a vector with `size` components.
fn definition(size: u32) -> String {
    let (ty, bits) = match size {
        1 => ("float".to_string(), "floatBitsToUint(p)".to_string()),
        n => {
            let names = ["x", "y", "z", "w"];
            let factors = ["1597334673u", "3812015801u", "2798796415u", "1979697957u"];
            let parts: Vec<String> = names
                .iter()
                .zip(factors)
                .take(n as usize)
                .map(|(c, by)| format!("floatBitsToUint(p.{c}) * {by}"))
                .collect();
            (format!("vec{n}"), parts.join(" ^ "))
        }
    };
    format!(
        "float {HASH}({ty} p) {{\n    uint h = {bits};\n    h = (h ^ (h >> 16u)) * 2246822507u;\n    \
         h = (h ^ (h >> 13u)) * 3266489909u;\n    return float((h ^ (h >> 16u)) >> 8u) / 16777216.0;\n}}\n\n"
    )
}
