//! The `#version` directive and its placement (GLSL ES 3.00 section 3.3).

use super::macros::Piece;
use super::{Preprocessor, error_at};
use crate::context::{GlContext, WebGl};
use crate::names::Version;
use crate::token::TokenKind;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, Subject, error};
use shaderlint_text::{Edit, Span};

impl Preprocessor<'_> {
    pub(super) fn version(&mut self, span: Span, rest: &[Piece]) {
        if self.seen_directive || self.seen_code {
            return self.misplaced_version(span);
        }
        self.out.version_span = Some(span);
        let number = rest
            .first()
            .filter(|p| matches!(p.token.kind, TokenKind::Int | TokenKind::Uint))
            .map(|p| p.token.value);
        let Some(number) = number else {
            return self.misspelled_version(span, rest);
        };
        let after = rest.get(1..).unwrap_or(&[]);
        let words: Vec<&str> = after.iter().map(|p| self.raw_text(p.token.span)).collect();
        match (number, words.as_slice()) {
            (100, []) => self.set_version(Version::Es100),
            (300, ["es"]) => {
                self.set_version(Version::Es300);
                match self.context {
                    GlContext {
                        webgl: WebGl::One,
                        is_known: true,
                        ..
                    } => self.refuse_300(span),
                    _ => self.check_first_line(span),
                }
            }
            (300, []) => {
                self.set_version(Version::Es300);
                let fix = Fix::safe("use `#version 300 es`", vec![Edit::insert(span.end, " es")]);
                let d = error_at(
                    error::UNSUPPORTED_VERSION,
                    span,
                    "`#version 300` must be followed by `es`",
                );
                self.report(d.fix(fix));
            }
            (100, _) => {
                self.set_version(Version::Es100);
                self.expect_end(after, "version");
            }
            (300, ["es", ..]) => {
                self.set_version(Version::Es300);
                self.expect_end(after.get(1..).unwrap_or(&[]), "version");
            }
            (300, [word, ..]) => {
                self.set_version(Version::Es300);
                let message = format!("expected `es` after `#version 300`, found `{word}`");
                let edits = vec![Edit::replace(span, "#version 300 es")];
                let fix = Fix::safe("use `#version 300 es`", edits);
                self.report(error_at(error::UNSUPPORTED_VERSION, span, message).fix(fix));
            }
            _ => {
                self.set_version(Version::Es300);
                let message = format!("WebGL2 does not support GLSL version {number}");
                let fix = Fix::safe_replacement(span, "#version 300 es");
                let d = error_at(error::UNSUPPORTED_VERSION, span, message).note(
                    "WebGL2 supports `#version 300 es`, and `#version 100` (or none) as in WebGL1",
                );
                self.report(d.fix(fix));
            }
        }
    }

    fn refuse_300(&mut self, span: Span) {
        let message = "a WebGL1 context does not compile GLSL ES 3.00";
        let d = error_at(error::UNSUPPORTED_VERSION, span, message);
        self.report(d.help("ask for the context with `getContext('webgl2')`"));
    }

    /// `#version 300es`, `#version 3.00 es`: the version that it resembles is assumed.
    fn misspelled_version(&mut self, span: Span, rest: &[Piece]) {
        let digits: String = rest.first().map_or(String::new(), |p| {
            let text = self.raw_text(p.token.span).chars();
            text.filter(char::is_ascii_digit).collect()
        });
        let directive = match digits.as_str() {
            "300" | "30" | "3" => "#version 300 es",
            "100" | "10" | "1" => "#version 100",
            _ => return self.expected(span, rest, "a version, such as `#version 300 es`"),
        };
        self.set_version(match directive.ends_with("es") {
            true => Version::Es300,
            false => Version::Es100,
        });
        let found = self.raw_text(span).trim_start_matches(['#', ' ', '\t']);
        let message = format!("expected `{directive}`, found `#{found}`");
        // The invalid number is the same mistake.
        let of_number = |d: &Diagnostic| span.contains(d.span) && d.is(error::INVALID_NUMBER);
        self.diagnostics.retain(|d| !of_number(d));
        let fix = Fix::safe_replacement(span, directive);
        self.report(error_at(error::UNSUPPORTED_VERSION, span, message).fix(fix));
    }

    pub(super) fn set_version(&mut self, version: Version) {
        self.version = version;
        let value = version.profile().number;
        if let Some(name) = self.names.get("__VERSION__")
            && let Some(id) = self.macro_named(name)
            && let Some(piece) = self
                .macros
                .get_mut(id.0 as usize)
                .and_then(|m| m.body.first_mut())
        {
            piece.token.value = value;
        }
        if version == Version::Es300 {
            self.predefine_extensions();
        }
    }

    /// GLSL ES 3.00 requires `#version` on the first line; comments and blanks may come before it.
    pub(super) fn check_first_line(&mut self, span: Span) {
        let before = self
            .text
            .get(..(span.start - self.base) as usize)
            .unwrap_or("");
        let own = self
            .text
            .get((span.start - self.base) as usize..(self.line_end - self.base) as usize)
            .unwrap_or("");
        let is_first = !before.contains(['\n', '\r']);
        if is_first && own.contains(['\n', '\r']) {
            let d = error_at(
                error::VERSION_PLACEMENT,
                span,
                "`#version 300 es` must end on the first line",
            );
            let line = Span::new(span.start, self.line_end);
            let fix = Fix::safe(
                "write it on one line",
                vec![Edit::replace(line, "#version 300 es")],
            );
            return self.report(d.fix(fix));
        }
        if !is_first {
            let what = if before.trim().is_empty() {
                "a blank line"
            } else {
                "a comment"
            };
            let d = error_at(
                error::VERSION_PLACEMENT,
                span,
                format!("`#version 300 es` must be on the first line, not after {what}"),
            )
            .note("no line may come before `#version 300 es`, not even an empty one")
            .fix(self.move_version(span));
            self.report(match before.trim().is_empty() {
                true => d.about(Subject::BlankFront),
                false => d,
            });
        }
    }

    pub(super) fn misplaced_version(&mut self, span: Span) {
        if self.has_prelude {
            let d = error_at(
                error::VERSION_PLACEMENT,
                span,
                "`#version` is not allowed in a ShaderToy pass",
            )
            .note("ShaderToy adds `#version 300 es` and its own header before the pass")
            .fix(Fix::safe("remove the directive", vec![Edit::delete(span)]));
            return self.report(d);
        }
        let d = error_at(
            error::VERSION_PLACEMENT,
            span,
            "`#version` must come before everything else",
        )
        .note("only whitespace and comments may come before it, and for `300 es` no line break")
        .fix(self.move_version(span));
        self.report(d);
        // Check the rest in the version that it states.
        if self.raw_text(span).contains("300") {
            self.set_version(Version::Es300);
        }
    }

    /// Moves the directive to the start of the file.
    pub(super) fn move_version(&self, span: Span) -> Fix {
        let text = self.raw_text(span);
        let from = (span.end - self.base) as usize;
        let rest = self.text.get(from..).unwrap_or("");
        let newline = if rest.starts_with("\r\n") {
            2
        } else {
            rest.starts_with(['\n', '\r']) as u32
        };
        let before = self
            .text
            .get(..(span.start - self.base) as usize)
            .unwrap_or("");
        if before.trim_start_matches('\u{feff}').trim().is_empty() {
            return Fix::safe(
                "remove everything before it",
                vec![Edit::delete(Span::new(self.base, span.start))],
            );
        }
        Fix::safe(
            "move it to the first line",
            vec![
                Edit::insert(self.base, format!("{text}\n")),
                Edit::delete(Span::new(span.start, span.end + newline)),
            ],
        )
    }

    pub(super) fn is_byte_order_mark(&self, span: Span) -> bool {
        span.start == self.base && self.raw_text(span) == "\u{feff}"
    }

    /// A byte order mark at the start of the text, which the browser treats as code. In a file that
    /// a page fetches as text, `fetch` removes it.
    #[cold]
    pub(super) fn byte_order_mark(&mut self, span: Span) {
        let file = self.sources.file_at(span.start);
        if file.is_some_and(|f| f.base == span.start && f.part.is_none()) {
            let message = "the file starts with a byte order mark";
            let kind = error::INVALID_CHARACTER;
            let d = Diagnostic::of(kind, Severity::Warning, span, message);
            return self.report(
                d.note("U+FEFF is not part of GLSL; `fetch` strips it, other ways to load a file may not")
                    .fix(Fix::safe("remove the byte order mark", vec![Edit::delete(span)])),
            );
        }
        let before_version = self.text.get(span.len() as usize..).is_some_and(|rest| {
            rest.trim_start()
                .strip_prefix('#')
                .is_some_and(|r| r.trim_start().starts_with("version"))
        });
        let d = if before_version {
            error_at(
                error::VERSION_PLACEMENT,
                span,
                "byte order mark before `#version`",
            )
        } else {
            error_at(
                error::INVALID_CHARACTER,
                span,
                "the shader starts with a byte order mark",
            )
        };
        self.report(
            d.note("U+FEFF is not part of GLSL; save the file as UTF-8 without BOM")
                .fix(Fix::safe(
                    "remove the byte order mark",
                    vec![Edit::delete(span)],
                )),
        );
    }
}
