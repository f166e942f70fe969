//! `#version 300 es` in a page that requests a WebGL1 context.

use shaderlint_lint::prelude::*;
use shaderlint_syntax::WebGl;

// Compares the version of the shader with the `getContext` call of its page. If the page compiles the shader
// itself, `unsupported-version` reports it.
rule! { webgl1_context, Webgl2, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let Some(span) = cx.program.tokens.version_span else {
        return;
    };
    let context = cx.program.context;
    let is_presumed = context.webgl == WebGl::One && !context.is_known;
    if is_presumed && cx.program.version == Version::Es300 {
        cx.report_span(
            span,
            "page requests a WebGL1 context, which rejects `#version 300 es`",
        )
        .note("the context of `getContext(\"webgl\")` supports GLSL ES 1.00 only")
        .help("use `getContext(\"webgl2\")`");
    }
}
