//! Variables that are read before they have a value.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_flow::{Parts, Unset};
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_semantic::{FunctionRef, Scalar, Storage, Variable, VariableId};
use shaderlint_text::Edit;

pub static RULE: Rule = Rule {
    name: "uninitialized-read",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("uninitialized_read.md"),
    checks: &[Check::Function(check)],
};

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let Some(found) = cx.facts.paths().get(function) else {
        return;
    };
    let certain = |u: &&Unset| u.always || !u.guarded;
    for unset in found.reads.iter().filter(certain) {
        let Some(variable) = program.variable(unset.variable) else {
            continue;
        };
        // What the player hands to the entry is zero in all browsers, and many shaders add to it.
        let is_param = matches!(variable.storage, Storage::Param(_));
        if is_param && cx.facts.entry() == Some(function) {
            continue;
        }
        let name = name_of(cx, unset.variable, unset.missing);
        let message = match unset.always {
            true => format!("`{name}` is read before it has a value"),
            false => format!("`{name}` may be read before it has a value"),
        };
        let declared = program.declared_at(variable);
        let fix = zero(cx, variable);
        let finding = cx.report(unset.at, message).fix(fix);
        let finding = match declared {
            Some(span) => finding.label(span, "declared here, without a value"),
            None => finding,
        };
        let finding = finding.note(
            "the value is undefined: browsers make it zero, other programs leave what was there",
        );
        if is_param {
            finding.help("an `out` parameter does not bring the caller's value; `inout` does");
        }
    }
}

/// The value that browsers give the variable, written down.
fn zero(cx: &Context, variable: &Variable) -> Option<Fix> {
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
    let title = format!(
        "give it a value: `{} = {value}`",
        cx.program.names.text(variable.name)
    );
    let edit = Edit::insert(token.span.end, format!(" = {value}"));
    Some(Fix::safe(title, vec![edit]))
}

/// The variable, and those of its components that are missing where it is not all of them.
fn name_of(cx: &Context, id: VariableId, missing: Parts) -> String {
    let Some(variable) = cx.program.variable(id) else {
        return String::new();
    };
    let name = cx.program.names.text(variable.name);
    if let Some(found) = cx.program.struct_of(variable.ty) {
        let only = found.fields.get(missing.trailing_zeros() as usize);
        return match only.filter(|_| missing.count_ones() == 1) {
            Some(field) => format!("{name}.{}", cx.program.names.text(field.name)),
            None => name.to_string(),
        };
    }
    let count = variable.ty.components();
    let letters = ["x", "y", "z", "w"];
    let missing: Vec<&str> = (0..4)
        .filter(|i| missing & 1 << i != 0)
        .filter_map(|i: usize| letters.get(i).copied())
        .collect();
    if variable.ty.is_vector() && missing.len() < count as usize {
        format!("{name}.{}", missing.join(""))
    } else {
        name.to_string()
    }
}
