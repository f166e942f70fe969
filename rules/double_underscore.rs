//! Macro names with two consecutive underscores.

use shaderlint_lint::prelude::*;

rule! { double_underscore, Portability, Info, Recommended, Macro(check) }

fn check(cx: &mut Context, definition: &Macro) {
    let span = definition.name_span;
    let name = cx.program.sources.text(span);
    // Include guards of libraries are empty macros with such names.
    if !name.contains("__") || definition.body.is_empty() {
        return;
    }
    let mut shorter = name.to_string();
    while shorter.contains("__") {
        shorter = shorter.replace("__", "_");
    }
    cx.report_span(
        span,
        format!("macro name `{name}` contains two consecutive underscores"),
    )
    .note("GLSL reserves such names; the browser accepts them for macros, some drivers do not")
    .help(format!("rename it to `{shorter}`"));
}
