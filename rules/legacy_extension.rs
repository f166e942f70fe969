//! `#extension` for features that are built into GLSL ES 3.00.

use shaderlint_lint::prelude::*;
use shaderlint_lint::remove_lines;
use shaderlint_syntax::GlExtension;

rule! { legacy_extension, Webgl2, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    if program.version != Version::Es300 {
        return;
    }
    for used in &program.tokens.extensions {
        let name = program.names.text(used.name);
        let what = GlExtension::of_directive(name).map_or("", |known| known.facts().built_in);
        if what.is_empty() || !program.is_user(used.span) {
            continue;
        }
        let edit = remove_lines(program, used.span);
        cx.report_span(
            used.span,
            format!("extension `{name}` does not exist in WebGL2"),
        )
        .note(format!(
            "{what} part of GLSL ES 3.00; the browser warns about the name"
        ))
        .fix(Fix::safe("remove the directive", vec![edit]));
    }
}
