//! Variables that are read before they are assigned.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_flow::{PartMask, UnassignedVariable};
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};
use shaderlint_semantic::{Dialect, FunctionRef, Pass, Scalar, Storage, Variable, VariableId};
use shaderlint_text::Edit;

pub static RULE: Rule = Rule {
    name: "uninitialized-read",
    group: Group::Numeric,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("uninitialized_read.md"),
    checks: &[Check::Function(check)],
};

/// The alpha channel of a colour.
const ALPHA: PartMask = 1 << 3;

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let Some(found) = cx.facts.definite_assignment().get(function) else {
        return;
    };
    let certain = |u: &&UnassignedVariable| u.always || !u.guarded;
    for unset in found.reads.iter().filter(certain) {
        let Some(variable) = program.variable(unset.variable) else {
            continue;
        };
        let is_param = matches!(variable.storage, Storage::Param(_));
        let is_output = is_param && cx.facts.entry() == Some(function);
        // An image is opaque whatever its alpha is.
        let is_image = program.dialect == Dialect::ShaderToy(Pass::Image);
        if is_output && is_image && unset.missing == ALPHA {
            continue;
        }
        let name = name_of(cx, unset.variable, unset.missing);
        let message = match unset.always {
            true => format!("`{name}` is read before it is assigned"),
            false => format!("`{name}` may be read before it is assigned"),
        };
        let declared = program.declared_at(variable);
        let fix = zero(cx, variable);
        let finding = cx.report(unset.at, message).fix(fix);
        let finding = match declared {
            Some(span) => finding.label(span, "declared without a value"),
            None => finding,
        };
        let finding = finding.note(
            "its value is undefined (section 4.3): browsers set it to zero, other programs do not",
        );
        // Many shaders add to the output that they are given.
        if is_output {
            finding.lower().help("assign it first");
        } else if is_param {
            finding.help("use `inout` to receive the value of the caller");
        }
    }
}

/// Initialises the variable with zero, as browsers do.
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
        "assign a value: `{} = {value}`",
        cx.program.names.text(variable.name)
    );
    let edit = Edit::insert(token.span.end, format!(" = {value}"));
    Some(Fix::safe(title, vec![edit]))
}

/// The name of the variable, with the unassigned components or field if others are assigned.
fn name_of(cx: &Context, id: VariableId, missing: PartMask) -> String {
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
