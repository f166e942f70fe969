//! The `#extension` directive (GLSL ES 3.00 section 3.5), as WebGL has it.

use super::macros::Piece;
use super::{ExtensionUse, Preprocessor, error_at};
use crate::context::{EXTENSION_BEHAVIORS, GlExtension, KNOWN_EXTENSIONS, WebGl};
use crate::names::{Name, Version};
use crate::token::TokenKind;
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_text::{Edit, Role, Span};

impl Preprocessor<'_> {
    /// Defines the macros of the extensions that a version of the language can use. `GL_OVR_multiview` has
    /// none.
    pub(super) fn predefine_extensions(&mut self) {
        let [both, only_300] = KNOWN_EXTENSIONS;
        let own = match self.version {
            Version::Es100 => both,
            Version::Es300 => only_300,
        };
        let usable = self.context.usable(self.version);
        let names = usable.filter_map(|facts| facts.directives.first().copied());
        for name in names.chain([own]).collect::<Vec<_>>() {
            self.predefine(name, 1);
        }
    }

    pub(super) fn extension(&mut self, span: Span, rest: &[Piece]) {
        let [name, colon, behavior] = rest else {
            return self.expected(span, &[], "`#extension NAME : enable`");
        };
        let is_word = |p: &Piece| p.token.kind == TokenKind::Identifier;
        if !is_word(name) || colon.token.kind != TokenKind::Colon || !is_word(behavior) {
            return self.expected(span, &[], "`#extension NAME : enable`");
        }
        let (name, behavior) = (Name(name.token.value), Name(behavior.token.value));
        // WebGL1 only warns.
        let is_late = self.seen_code && self.context.webgl == WebGl::Two;
        if is_late && self.role == Role::User {
            let d = error_at(
                error::EXTENSION_PLACEMENT,
                span,
                "`#extension` must come before any code",
            )
            .note("only directives and comments may come before it (section 3.4)");
            self.report(d);
        }
        self.out.extensions.push(ExtensionUse {
            name,
            behavior,
            span,
        });
        let (text, how) = (
            self.names.text(name).to_string(),
            self.names.text(behavior).to_string(),
        );
        self.activate(&text, &how);
        let message = match how.as_str() {
            "require" if text == "all" => "`all` cannot be combined with `require`".to_string(),
            "enable" if text == "all" => "`all` cannot be combined with `enable`".to_string(),
            "require" if !self.is_known(&text) => return self.refuse_extension(span, &text),
            how if EXTENSION_BEHAVIORS.contains(&how) => return,
            _ => format!("expected `require`, `enable`, `warn` or `disable`, found `{how}`"),
        };
        self.report(error_at(error::UNKNOWN_EXTENSION, span, message));
    }

    /// Whether a shader here can require an extension.
    fn is_known(&self, name: &str) -> bool {
        let has = |extension| self.context.has(extension, self.version);
        let [both, only_300] = KNOWN_EXTENSIONS;
        let is_always = name == both || name == only_300 && self.version == Version::Es300;
        is_always || GlExtension::of_directive(name).is_some_and(has)
    }

    /// The kind of a reserved word: extensions of WebGL2 make some of them qualifiers that obey the rules of
    /// an older one.
    pub(super) fn reserved(&self, name: Name) -> TokenKind {
        let has = |extension| self.out.active.contains(extension);
        match self.names.text(name) {
            "noperspective" if has(GlExtension::Noperspective) => TokenKind::Smooth,
            "sample" if has(GlExtension::MultisampleInterpolation) => TokenKind::Centroid,
            _ => TokenKind::Reserved,
        }
    }

    /// Notes what a directive turns on or off.
    fn activate(&mut self, name: &str, how: &str) {
        let usable = self.context.usable(self.version);
        let meant = usable.filter(|facts| name == "all" || facts.directives.contains(&name));
        for facts in meant {
            match how {
                "disable" => self.out.active.remove(facts.extension),
                _ => self.out.active.insert(facts.extension),
            }
        }
    }

    /// Reports `require` of an extension that does not exist here.
    fn refuse_extension(&mut self, span: Span, name: &str) {
        let webgl = self.context.webgl;
        let known = GlExtension::of_directive(name).map(GlExtension::facts);
        let message = match (known, webgl) {
            (Some(facts), _) if facts.exists_in(webgl) && facts.extends(self.version) => {
                format!("extension `{name}` is not enabled")
            }
            (_, WebGl::One) => format!("WebGL1 has no shader extension `{name}`"),
            (_, WebGl::Two) => format!("WebGL2 has no shader extension `{name}`"),
        };
        let d = error_at(error::UNKNOWN_EXTENSION, span, message);
        let d = match known {
            None => d,
            Some(facts) if facts.exists_in(webgl) && facts.extends(self.version) => {
                d.help(format!(
                    "call `gl.getExtension('{}')` before the shader is compiled",
                    facts.name
                ))
            }
            Some(facts) if facts.version == Some(Version::Es100) => self.built_in(span, d),
            Some(facts) => d.note(format!(
                "it is `{}`, for `#version 300 es` in WebGL2",
                facts.name
            )),
        };
        self.report(d);
    }

    /// Adds to an error about an extension of WebGL1 in WebGL2 what to do.
    fn built_in(&self, span: Span, d: Diagnostic) -> Diagnostic {
        if self.version == Version::Es100 {
            return d.note("GLSL ES 1.00 in a WebGL2 context cannot use the extensions of WebGL1; `#version 300 es` has their features");
        }
        let line = Span::new(span.start, span.end + 1);
        let removed = match self.sources.text(line).ends_with('\n') {
            true => line,
            false => span,
        };
        d.note("its features are built into GLSL ES 3.00")
            .fix(Fix::safe(
                "remove the directive",
                vec![Edit::delete(removed)],
            ))
    }
}
