//! Messages for functions and variables that extensions add.

use super::*;
use shaderlint_semantic::builtins::LEGACY_FUNCTIONS;
use shaderlint_syntax::{ExtensionFacts, GlExtension, WebGl};

impl ExplainContext<'_> {
    /// A function or variable that an extension adds which is not turned on; `None` if there is none, or if
    /// only another version of the language helps.
    pub(crate) fn extension_needed(&self, name: &str, token: TokenId) -> Option<Diagnostic> {
        let facts = GlExtension::that_adds(name, self.version)?.facts();
        let context = self.context;
        if context.has(facts.extension, self.version) {
            let directive = self.directive_for(facts);
            let message = format!("`{name}` needs `{directive}`");
            let d = self.error_at(error::MISSING_EXTENSION, token, message);
            let at = self.start_of_directives();
            let edit = Edit::insert(at, format!("{directive}\n"));
            return Some(d.fix(Fix::safe(format!("add `{directive}`"), vec![edit])));
        }
        // GLSL ES 3.00 may have it without an extension.
        let is_later = Builtins::of(Version::NEWEST, self.stage);
        let is_later = is_later.function(name).is_some() || is_later.variable(name).is_some();
        let exists = facts.exists_in(context.webgl);
        if is_later && !exists {
            return None;
        }
        let message = format!("`{name}` needs the extension `{}`", facts.name);
        let d = self.error_at(error::MISSING_EXTENSION, token, message);
        Some(match exists || !context.is_known {
            true => d.help(self.how_to_enable(facts)),
            false => d.note(match context.webgl {
                WebGl::One => "a WebGL1 context does not have it",
                WebGl::Two => "a WebGL2 context does not have it",
            }),
        })
    }

    /// What to do about something that only GLSL ES 3.00 has without an extension.
    pub(crate) fn help_for_version(&self, name: &str) -> String {
        let facts = GlExtension::that_adds(name, self.version).map(GlExtension::facts);
        let lookups = LEGACY_FUNCTIONS.iter().map(|(old, _)| *old);
        let mut old = ["varying", "attribute", "gl_FragColor", "gl_FragData"]
            .into_iter()
            .chain(lookups);
        let mut is_old = || old.any(|word| self.names.get(word).is_some());
        match facts.filter(|facts| facts.exists_in(WebGl::One) && is_old()) {
            Some(_) if self.context.is_known => {
                "GLSL ES 1.00 in a WebGL2 context has no extensions: convert the shader to `#version 300 es`, which `shaderport` does".to_string()
            }
            Some(facts) => format!(
                "in WebGL1 {}; for WebGL2 convert the shader to `#version 300 es`, which `shaderport` does",
                self.how_to_enable(facts)
            ),
            None => "add `#version 300 es` as the first line".to_string(),
        }
    }

    fn how_to_enable(&self, facts: &ExtensionFacts) -> String {
        let call = format!("call `gl.getExtension('{}')`", facts.name);
        let named = |name: &&str| self.names.get(name).is_some();
        match facts.directives.iter().any(named) {
            true => format!("{call} before the shader is compiled"),
            false => format!("{call} and add `{}`", self.directive_for(facts)),
        }
    }

    fn directive_for(&self, facts: &ExtensionFacts) -> String {
        let name = facts.directives.first().unwrap_or(&"");
        format!("#extension {name} : enable")
    }

    /// Where an `#extension` can be added: after the `#version`, or at the start of the user's text.
    fn start_of_directives(&self) -> u32 {
        let start = self.start_of_shader().start;
        let version = self.tokens.version_span.filter(|span| span.end > start);
        version.map_or(start, |span| span.end + 1)
    }
}
