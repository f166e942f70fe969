//! Hashes and time in `mediump` or `lowp`.

use shaderlint_ir::Precision;
use shaderlint_lint::prelude::*;
use shaderlint_syntax::TypeWord;

rule! { mediump_noise, Portability, Warning, Recommended, [Number(&FACTOR)], Program(check) }

static FACTOR: Setting<f64> = Setting::new(
    "factor",
    1000.0,
    "Minimum factor inside `fract` that marks a hash",
);

/// An operation, and what it computes that needs more precision.
type PrecisionUse = (OpId, &'static str);

fn check(cx: &mut Context) {
    let program = cx.program;
    if program.stage != Stage::Fragment {
        return;
    }
    let mut precision: Option<(QualifierKind, Extent)> = None;
    for item in &program.tree.items {
        let Item::Decl(id) = item else { continue };
        if let Some(decl) = program.tree.decl(*id)
            && let DeclKind::Precision {
                precision: kind,
                ty,
            } = decl.kind
            && program.tree.ty(ty).base == TypeBase::Word(TypeWord::Float)
        {
            precision = Some((kind, decl.extent));
        }
    }
    let (qualifier, extent) = match precision {
        Some((QualifierKind::Mediump, extent)) => ("mediump", extent),
        Some((QualifierKind::Lowp, extent)) => ("lowp", extent),
        _ => return,
    };
    let Some((op, what)) = hash(cx).or_else(|| time(cx)) else {
        return;
    };
    let place = cx.facts.module().provenance(op).extent(&program.tree);
    let place = program.span(place.unwrap_or_default());
    cx.report(
        extent,
        format!("`{qualifier}` is not precise enough for {what}"),
    )
    .label(place, "needs `highp`")
    .note(
        "phones keep 10 bits of the fraction: noise turns into stripes, and time advances in \
        visible steps",
    )
    .help("use `precision highp float;`");
}

/// `fract(x * 43758.5453)`
fn hash(cx: &Context) -> Option<PrecisionUse> {
    let module = cx.facts.module();
    let limit = cx.option(&FACTOR);
    let found = periods(module).find(|(_, function, arg)| {
        let is_large = |op: &OpId| {
            let values = module.constant(*op).iter();
            values
                .into_iter()
                .any(|v| v.as_float().abs() as f64 >= limit)
        };
        *function == BuiltinId::Fract && factors(module, *arg).iter().any(is_large)
    });
    found.map(|(op, ..)| (op, "a hash"))
}

/// A time that shifts the phase of a wave or is wrapped by `fract` or `mod`.
fn time(cx: &Context) -> Option<PrecisionUse> {
    use BuiltinId::{Cos, Fract, Mod, Sin};
    let module = cx.facts.module();
    periods(module).find_map(|(_, function, arg)| {
        let terms = parts(module, computed(cx, arg), &[Binary::Add, Binary::Subtract]);
        let is_period = match function {
            Fract | Mod => true,
            Sin | Cos => terms.len() > 1,
            _ => false,
        };
        let mut terms = terms.into_iter();
        let counted = terms.find(|term| is_period && is_time(cx, *term))?;
        Some((counted, "a time in seconds"))
    })
}

/// The operation that computes the value of a variable.
fn computed(cx: &Context, op: OpId) -> OpId {
    match cx.facts.origin(op, 0) {
        Some(Start::Made(made, _)) => made,
        _ => op,
    }
}

/// Whether a value is the time since the start, perhaps scaled.
fn is_time(cx: &Context, op: OpId) -> bool {
    use Binary::{Divide, Multiply};
    let module = cx.facts.module();
    let mut found = false;
    cx.facts.trace(op, 0, |start| match start {
        Start::Given(variable, _) => {
            let variable = cx.program.variable(variable);
            let uniform = variable.filter(|v| v.storage == Storage::Uniform);
            found |= uniform.is_some_and(|v| cx.facts.is_time(v.name));
            false
        }
        Start::Made(op, _) => matches!(
            module.op(op).kind,
            OpKind::Binary(Multiply | Divide, ..)
                | OpKind::Unary(Unary::Negate, _)
                | OpKind::Splat(_)
        ),
    });
    found
}

/// Low-precision calls of built-in functions, and their first arguments.
fn periods(module: &Module) -> impl Iterator<Item = (OpId, BuiltinId, OpId)> {
    let ops = (0..).map(OpId).zip(&module.ops);
    ops.filter_map(|(op, made)| match made.kind {
        OpKind::Builtin(function, list) if is_coarse(module, op) => {
            Some((op, function, *module.operands(list).first()?))
        }
        _ => None,
    })
}

fn is_coarse(module: &Module, op: OpId) -> bool {
    matches!(module.op(op).precision, Precision::Medium | Precision::Low)
}

fn factors(module: &Module, op: OpId) -> Vec<OpId> {
    parts(module, op, &[Binary::Multiply])
}

/// The operands of a nested sum or product, flattened.
fn parts(module: &Module, op: OpId, kinds: &[Binary]) -> Vec<OpId> {
    let mut parts = Vec::new();
    let mut todo = vec![op];
    while let Some(op) = todo.pop() {
        match module.op(op).kind {
            OpKind::Binary(kind, a, b) if kinds.contains(&kind) => todo.extend([b, a]),
            OpKind::Splat(a) => todo.push(a),
            _ => parts.push(op),
        }
    }
    parts
}
