//! Macro names with two underscores in a row.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_syntax::Macro;

pub static RULE: Rule = Rule {
    name: "double-underscore",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("double_underscore.md"),
    checks: &[Check::Macro(check)],
};

fn check(cx: &mut Context, definition: &Macro) {
    let span = definition.name_span;
    let name = cx.program.sources.text(span);
    // Libraries mark themselves as read by empty macros of such names.
    if !name.contains("__") || definition.body.is_empty() {
        return;
    }
    let mut shorter = name.to_string();
    while shorter.contains("__") {
        shorter = shorter.replace("__", "_");
    }
    cx.report_span(
        span,
        format!("the macro name `{name}` holds two underscores in a row"),
    )
    .note(
        "GLSL keeps such names for itself: the browser takes them for macros, some drivers do not",
    )
    .help(format!("write `{shorter}`"));
}
