//! Outputs that a function leaves without a value.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::FunctionRef;

pub static RULE: Rule = Rule {
    name: "output-not-written",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("output_not_written.md"),
    checks: &[Check::Function(check)],
};

/// The bit of the alpha component.
const ALPHA: u8 = 1 << 3;

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let Some(found) = cx.facts.paths().get(function) else {
        return;
    };
    let is_entry = cx.facts.entry() == Some(function);
    // The player shows a picture without its alpha.
    let is_picture = program.dialect.host().hides_alpha && is_entry;
    // A function that returns something tells by it whether the rest has a value.
    let function = program.function(function);
    let tells = function.is_some_and(|f| !f.returns.is_void());
    for unset in found.outputs.iter().filter(|u| u.always || !tells) {
        let ignored = if is_picture { ALPHA } else { 0 };
        let missing = unset.missing & !ignored;
        let Some(variable) = program.variable(unset.variable).filter(|_| missing != 0) else {
            continue;
        };
        let name = program.names.text(variable.name);
        let letters = ["x", "y", "z", "w"].iter().enumerate();
        let parts: String = letters
            .filter(|(i, _)| missing & 1 << i != 0)
            .map(|(_, l)| *l)
            .collect();
        let is_part = variable.ty.is_vector() && parts.len() < variable.ty.components() as usize;
        let what = if is_part {
            format!("{name}.{parts}")
        } else {
            name.to_string()
        };
        let message = match unset.always {
            true => format!("`{what}` is never written to"),
            false => format!("`{what}` may not be written to"),
        };
        let declared = program.declared_at(variable);
        let left = program.span(unset.at);
        let finding = cx.report_span(declared.unwrap_or(left), message);
        let finding = match declared {
            Some(_) if !unset.always => finding.label(left, "left here without it"),
            _ => finding,
        };
        finding.note(
            "the value is undefined: browsers make it zero, other programs leave what was there",
        );
    }
}
