//! Extensions that a shader uses and nothing is known to enable.

use shaderlint_lint::prelude::*;
use shaderlint_syntax::{EXTENSIONS, ExtensionFacts, Name};

rule! { extension_not_enabled, Webgl2, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    let context = program.context;
    let is_presumed = |facts: &&ExtensionFacts| {
        let extension = facts.extension;
        context.presumed.contains(extension) && context.has(extension, program.version)
    };
    for facts in EXTENSIONS.iter().filter(is_presumed) {
        let Some((span, what)) = first_use(program, facts) else {
            continue;
        };
        let message = format!("{what} requires `{}` to be enabled", facts.name);
        let found = cx.report_span(span, message);
        let found = match facts.lacking {
            [] => found,
            browsers => found.note(format!(
                "not in every browser: {} lacks it",
                browsers.join(", ")
            )),
        };
        found.help(format!(
            "call `gl.getExtension('{}')` before the shader is compiled; if the page does, list it in `extensions` of shaderlint.toml",
            facts.name
        ));
    }
}

/// The first use of an extension: of a name that it adds, or the directive that fails or has no effect
/// without it.
fn first_use(program: &Program, facts: &ExtensionFacts) -> Option<(Span, String)> {
    let mut tokens = program.tokens.tokens.iter();
    let used = tokens.find(|token| {
        token.kind == TokenKind::Identifier
            && facts.adds.contains(&program.names.text(Name(token.value)))
            && program.is_user(token.span)
    });
    let named = |span: Span| (span, format!("`{}`", program.sources.text(span)));
    if let Some(token) = used {
        return Some(named(token.span));
    }
    let text = |name| program.names.text(name);
    let mut directives = program.tokens.extensions.iter();
    let directive = directives.find(|directive| {
        let is_own = facts.directives.contains(&text(directive.name));
        is_own && (facts.adds.is_empty() || text(directive.behavior) == "require")
    })?;
    Some((directive.span, "this directive".to_string()))
}
