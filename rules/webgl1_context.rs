//! `#version 300 es` in a page that asks for WebGL1.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_syntax::Version;

/// The rule.
pub static RULE: Rule = Rule {
    name: "webgl1-context",
    group: Group::Webgl2,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("webgl1_context.md"),
    checks: &[Check::Program(check)],
};

fn check(cx: &mut Context) {
    let Some(span) = cx.program.tokens.version_span else {
        return;
    };
    if cx.facts.around.embedder.is_webgl1 && cx.program.version == Version::Es300 {
        cx.report_span(
            span,
            "the page asks for WebGL1, which cannot compile `#version 300 es`",
        )
        .note("`getContext(\"webgl\")` gives a context whose compiler knows GLSL ES 1.00 only")
        .help("ask for `getContext(\"webgl2\")`");
    }
}
