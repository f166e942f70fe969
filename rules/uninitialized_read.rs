//! Variables that are read before they are assigned.

use rustc_hash::FxHashSet;
use shaderlint_flow::{PartMask, UnassignedVariable};
use shaderlint_lint::Finding;
use shaderlint_lint::prelude::*;
use shaderlint_semantic::Variable;

rule! { uninitialized_read, Numeric, Warning, Recommended, Function(check) }

/// The alpha channel of a colour.
const ALPHA: PartMask = 1 << 3;

fn check(cx: &mut Context, function: FunctionRef) {
    let Some(found) = cx.facts.definite_assignment().get(function) else {
        return;
    };
    let certain = |u: &&UnassignedVariable| u.always || !u.guarded;
    // A value in the declaration is the fix for all reads of a variable.
    let mut known = FxHashSet::default();
    let reads = found.reads.iter().filter(certain);
    let reads = reads.filter(|unset| known.insert(unset.variable));
    let reads: Vec<UnassignedVariable> = reads.copied().collect();
    let is_entry = cx.facts.entry() == Some(function);
    let (outputs, others): (Vec<_>, Vec<_>) =
        reads.into_iter().partition(|u| is_entry && is_param(cx, u));
    for output in outputs {
        // An image is opaque whatever its alpha is.
        let is_image = cx.program.dialect == Dialect::ShaderToy(Pass::Image);
        if !(is_image && output.missing == ALPHA) {
            // Many shaders add to the output that they are given.
            report(cx, &[output]).lower().help("assign it first");
        }
    }
    if let Some(first) = others.first() {
        let is_param = is_param(cx, first);
        let is_unseen = others.iter().all(|u| !u.always) && is_unseen(cx);
        let mut finding = report(cx, &others);
        if is_unseen {
            finding = finding.lower().note("no sampled pixel depends on it");
        }
        if is_param {
            finding.help("use `inout` to receive the value of the caller");
        }
    }
}

fn is_param(cx: &Context, unset: &UnassignedVariable) -> bool {
    let variable = cx.program.variable(unset.variable);
    variable.is_some_and(|v| matches!(v.storage, Storage::Param(_)))
}

/// Whether the image was sampled, and no pixel depends on the initial value of a variable: the paths
/// that leave it unset may exclude each other.
fn is_unseen(cx: &Context) -> bool {
    cx.facts.sampled_image().is_some() && cx.facts.changed_by_initial_value(None).is_none()
}

/// Reports the reads of one function as one finding.
fn report<'a>(cx: &'a mut Context, reads: &[UnassignedVariable]) -> Finding<'a> {
    let names: Vec<String> = reads
        .iter()
        .map(|u| cx.name_of_parts(u.variable, u.missing))
        .collect();
    let subject = match names.as_slice() {
        [] => String::new(),
        [one] => format!("`{one}`"),
        [one, two] => format!("`{one}` and `{two}`"),
        [one, others @ ..] => format!("`{one}` and {} other variables", others.len()),
    };
    let (are, they) = match names.len() {
        1 => ("is", "it is"),
        _ => ("are", "they are"),
    };
    let message = match reads.iter().all(|u| u.always) {
        true => format!("{subject} {are} read before {they} assigned"),
        false => format!("{subject} may be read before {they} assigned"),
    };
    let variables: Vec<&Variable> = reads
        .iter()
        .filter_map(|u| cx.program.variable(u.variable))
        .collect();
    let fix = match reads.iter().any(|read| keeps_zero(cx, read)) {
        true => None,
        false => zeros(cx, &variables),
    };
    let at = reads.first().map(|u| u.at).unwrap_or_default();
    let program = cx.program;
    let mut finding = cx.report(at, message).fix(fix);
    for (other, name) in reads.iter().zip(&names).skip(1) {
        finding = finding.label(program.span(other.at), format!("`{name}` is read here"));
    }
    for (variable, name) in variables.iter().zip(&names) {
        if let Some(span) = program.declared_at(variable) {
            let label = match names.len() {
                1 => "declared without a value".to_string(),
                _ => format!("`{name}` has no value"),
            };
            finding = finding.label(span, label);
        }
    }
    finding.note(
        "its value is undefined (section 4.3): browsers set it to zero, other programs do not",
    )
}

/// Whether a variable is read to compute its own next value, and that is zero for zero: `d = min(d, x)`,
/// `d *= x`. Another start is meant, so that zero would only hide the mistake.
fn keeps_zero(cx: &Context, read: &UnassignedVariable) -> bool {
    let tree = &cx.program.tree;
    tree.exprs.iter().any(|expr| {
        let ExprKind::Assign(op, target, value) = expr.kind else {
            return false;
        };
        let keeps = match op {
            None => matches!(tree.expr(value).kind, ExprKind::Call(..)),
            Some(op) => matches!(op, BinaryOp::Mul | BinaryOp::Div),
        };
        keeps
            && expr.extent.contains(read.at)
            && cx.program.variable_of(target) == Some(read.variable)
    })
}

/// Initialises variables with zero, as browsers do; `None` if that is not possible for one of them.
fn zeros(cx: &Context, variables: &[&Variable]) -> Option<Fix> {
    let assigned = variables.iter().map(|v| zero(cx, v));
    let (values, edits): (Vec<String>, Vec<Edit>) = assigned.collect::<Option<_>>()?;
    let title = match values.as_slice() {
        [value] => format!("assign a value: `{value}`"),
        _ => "assign a value in each declaration".to_string(),
    };
    Some(Fix::safe(title, edits))
}

/// A variable with the value zero, and the edit that assigns it in the declaration.
fn zero(cx: &Context, variable: &Variable) -> Option<(String, Edit)> {
    let ty = variable.ty;
    let token = cx.program.token(variable.token?)?;
    if variable.storage != Storage::Local || ty.array != 0 || !token.is_direct() {
        return None;
    }
    let zero = match ty.scalar_kind()? {
        Scalar::Bool => "false",
        Scalar::Int => "0",
        Scalar::Uint => "0u",
        Scalar::Float => "0.0",
    };
    let value = match ty.is_scalar() {
        true => zero.to_string(),
        false => format!("{}({zero})", cx.program.type_name(ty)),
    };
    let name = cx.program.names.text(variable.name);
    let edit = Edit::insert(token.span.end, format!(" = {value}"));
    Some((format!("{name} = {value}"), edit))
}
