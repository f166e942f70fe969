//! `#extension` for features that are built into GLSL ES 3.00.

use shaderlint_diagnostic::Fix;
use shaderlint_lint::{Context, remove_lines};
use shaderlint_semantic::CORE_EXTENSIONS;
use shaderlint_syntax::Version;

rule! { legacy_extension, Webgl2, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    if program.version != Version::Es300 {
        return;
    }
    for used in &program.tokens.extensions {
        let name = program.names.text(used.name);
        let known = CORE_EXTENSIONS.iter().find(|(known, _)| *known == name);
        let Some((_, what)) = known.filter(|_| program.is_user(used.span)) else {
            continue;
        };
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
