//! Directives: the lines that start with `#` (GLSL ES 3.00 section 3.4).

use super::condition::{Problem, evaluate, evaluate_prefix};
use super::macros::{Macro, MacroId, Piece};
use super::{ExtensionUse, Preprocessor, bad, error_at};
use crate::diagnostic::{Fix, error};
use crate::syntax::names::{Name, Version};
use crate::syntax::token::{RawKind, Token, TokenKind};
use crate::text::{Edit, Role, Span};

/// Extensions that a WebGL2 context knows without being asked, measured in Chromium.
pub(super) const KNOWN_EXTENSIONS: [&str; 2] = [
    "GL_OES_EGL_image_external",
    "GL_OES_EGL_image_external_essl3",
];

/// Extensions of WebGL1 that became part of GLSL ES 3.00.
const CORE_EXTENSIONS: [&str; 4] = [
    "GL_OES_standard_derivatives",
    "GL_EXT_shader_texture_lod",
    "GL_EXT_frag_depth",
    "GL_EXT_draw_buffers",
];

impl Preprocessor<'_> {
    /// Defines the macros that the language has from the start.
    pub(super) fn define_predefined(&mut self) {
        for (name, value) in [
            ("GL_ES", 1),
            ("__VERSION__", 100),
            ("__LINE__", 0),
            ("__FILE__", 0),
            ("GL_FRAGMENT_PRECISION_HIGH", 1),
        ] {
            self.predefine(name, value);
        }
        self.predefine(KNOWN_EXTENSIONS[0], 1);
    }

    pub(super) fn predefine(&mut self, name: &str, value: u32) {
        let name = self.names.intern(name);
        let mut definition = Macro::new(name, Span::default());
        definition.predefined = true;
        let token = Token {
            kind: TokenKind::Int,
            value,
            span: Span::default(),
            spelled: 0,
            expansion: Token::DIRECT,
        };
        definition.body.push(Piece {
            token,
            space: false,
            frozen: false,
        });
        self.add_macro(definition);
    }

    fn add_macro(&mut self, definition: Macro) {
        let at = definition.name.0 as usize;
        if self.macro_of.len() <= at {
            self.macro_of.resize(at + 64, 0);
        }
        self.macros.push(definition);
        if let Some(slot) = self.macro_of.get_mut(at) {
            *slot = self.macros.len() as u32;
        }
    }

    /// Reads the directive whose `#` stands at `hash`, up to the end of its line.
    #[inline(never)]
    pub(super) fn directive(&mut self, hash: Span) {
        let mut line = Vec::new();
        let mut space = false;
        let end = loop {
            let raw = self.lexer.next_token();
            match raw.kind {
                RawKind::Newline => {
                    self.at_line_start = true;
                    break raw.span.start;
                }
                RawKind::End => break raw.span.start,
                RawKind::Whitespace => space = true,
                RawKind::LineComment | RawKind::BlockComment | RawKind::OpenComment => {
                    self.comment(raw);
                    space = true;
                }
                _ => {
                    line.push(self.piece(raw, space));
                    space = false;
                }
            }
        };
        let last = line.last().map_or(hash.end, |p: &Piece| p.token.span.end);
        self.dispatch(Span::new(hash.start, last), &line, end);
        self.seen_directive = true;
    }

    fn dispatch(&mut self, span: Span, line: &[Piece], end: u32) {
        let Some((first, rest)) = line.split_first() else {
            return;
        };
        let word = match first.token.kind {
            TokenKind::Identifier => self.names.text(Name(first.token.value)).to_string(),
            _ => String::new(),
        };
        let was_skipping = self.is_skipping();
        match word.as_str() {
            "if" | "ifdef" | "ifndef" => self.open_group(&word, span, rest),
            "elif" => self.elif(span, rest),
            "else" => self.else_group(span, rest),
            "endif" => self.endif(span, rest),
            _ if was_skipping => {}
            "define" => self.define(span, rest),
            "undef" => self.undef(span, rest),
            "error" => self.error_directive(span, first, rest),
            "pragma" => self.pragma(span, rest),
            "extension" => self.extension(span, rest),
            "version" => self.version(span, rest),
            "line" => self.line(span, rest),
            _ => self.unknown_directive(span, first),
        }
        match (was_skipping, self.is_skipping()) {
            (false, true) => self.skipped_from = Some(end),
            (true, false) => {
                if let Some(from) = self.skipped_from.take() {
                    self.out.inactive.push(Span::new(from, span.start));
                }
            }
            _ => {}
        }
    }

    fn unknown_directive(&mut self, span: Span, first: &Piece) {
        let text = self.raw_text(first.token.span);
        let text: String = text.chars().take(40).collect();
        let message = format!("there is no directive `#{text}`");
        let mut d = error_at(error::BAD_DIRECTIVE, span, message);
        const KNOWN: [&str; 13] = [
            "define",
            "undef",
            "if",
            "ifdef",
            "ifndef",
            "else",
            "elif",
            "endif",
            "error",
            "pragma",
            "extension",
            "version",
            "line",
        ];
        if text == "include" || text == "import" {
            d = d.note("GLSL ES cannot include files: put the text in before it is compiled");
        } else if let Some(near) = KNOWN
            .iter()
            .find(|k| strsim::damerau_levenshtein(k, &text) <= 2)
        {
            d = d.help(format!("did you mean `#{near}`?"));
        }
        self.report(d);
    }

    pub(super) fn expected(&mut self, span: Span, rest: &[Piece], what: &str) {
        let at = rest.first().map_or(span.after(), |p| p.token.span);
        self.report(error_at(
            error::BAD_DIRECTIVE,
            at,
            format!("expected {what}"),
        ));
    }

    /// Reports what stands behind the end of a directive.
    pub(super) fn expect_end(&mut self, rest: &[Piece], directive: &str) {
        if let Some(first) = rest.first() {
            let last = rest.last().unwrap_or(first);
            let span = first.token.span.to(last.token.span);
            let message = format!("nothing may stand behind `#{directive}`");
            let fix = Fix::safe("make it a comment", vec![Edit::insert(span.start, "// ")]);
            self.report(error_at(error::BAD_DIRECTIVE, span, message).fix(fix));
        }
    }

    fn define(&mut self, span: Span, rest: &[Piece]) {
        let Some((first, rest)) = rest.split_first() else {
            return self.expected(span, &[], "the macro's name behind `#define`");
        };
        if first.token.kind != TokenKind::Identifier {
            return self.expected(
                span,
                std::slice::from_ref(first),
                "the macro's name behind `#define`",
            );
        }
        let name = Name(first.token.value);
        if !self.check_macro_name(name, first.token.span) {
            return;
        }
        let mut definition = Macro::new(name, first.token.span);
        let mut body = rest;
        if let [open, more @ ..] = rest
            && open.token.kind == TokenKind::LeftParen
            && !open.space
        {
            match self.params(span, more) {
                Some((params, behind)) => {
                    definition.params = Some(params);
                    body = behind;
                }
                None => return,
            }
        }
        definition.body = body.to_vec();
        for (i, piece) in definition.body.iter_mut().enumerate() {
            piece.space &= i > 0;
            if let (TokenKind::Identifier, Some(params)) = (piece.token.kind, &definition.params)
                && let Some(index) = params.iter().position(|p| p.0 == piece.token.value)
            {
                piece.token.expansion = index as u32;
            }
        }
        self.define_checked(definition);
    }

    pub(super) fn define_checked(&mut self, definition: Macro) {
        let Some(old) = self.macro_named(definition.name) else {
            return self.add_macro(definition);
        };
        let Some(previous) = self.macros.get(old.0 as usize) else {
            return;
        };
        if previous.same_as(&definition, self.sources) {
            return;
        }
        let name = self.names.text(definition.name);
        let d = error_at(
            error::MACRO_REDEFINITION,
            definition.name_span,
            format!("macro `{name}` is defined again, and differently"),
        )
        .mark("second definition")
        .label(previous.name_span, "first definition")
        .help(format!(
            "put `#undef {name}` before it, or take another name"
        ));
        self.report(d);
    }

    fn check_macro_name(&mut self, name: Name, span: Span) -> bool {
        let text = self.names.text(name).to_string();
        let is_predefined = self
            .macro_named(name)
            .and_then(|id| self.macros.get(id.0 as usize))
            .is_some_and(|m| m.predefined);
        let why = if is_predefined {
            "the language defines it"
        } else if text.starts_with("GL_") {
            "names that start with `GL_` belong to the language"
        } else if text == "defined" {
            "it is the operator of `#if`"
        } else {
            return true;
        };
        let message = format!("`{text}` cannot be defined as a macro");
        self.report(error_at(error::RESERVED_MACRO, span, message).note(why));
        false
    }

    /// Reads `a, b)` and gives the parameters and what stands behind.
    fn params<'p>(
        &mut self,
        span: Span,
        mut rest: &'p [Piece],
    ) -> Option<(Vec<Name>, &'p [Piece])> {
        let mut params = Vec::new();
        if let [close, more @ ..] = rest
            && close.token.kind == TokenKind::RightParen
        {
            return Some((params, more));
        }
        loop {
            let (first, more) = match rest.split_first() {
                Some((first, more)) if first.token.kind == TokenKind::Identifier => (first, more),
                _ => {
                    self.expected(span, rest, "a parameter's name");
                    return None;
                }
            };
            let name = Name(first.token.value);
            if params.contains(&name) {
                let message = format!("parameter `{}` stands twice", self.names.text(name));
                self.report(error_at(error::BAD_DIRECTIVE, first.token.span, message));
                return None;
            }
            params.push(name);
            match more.split_first() {
                Some((p, behind)) if p.token.kind == TokenKind::Comma => rest = behind,
                Some((p, behind)) if p.token.kind == TokenKind::RightParen => {
                    return Some((params, behind));
                }
                _ => {
                    self.expected(span, more, "`,` or `)`");
                    return None;
                }
            }
        }
    }

    fn undef(&mut self, span: Span, rest: &[Piece]) {
        let Some((first, rest)) = rest
            .split_first()
            .filter(|(p, _)| p.token.kind == TokenKind::Identifier)
        else {
            return self.expected(span, rest, "the macro's name behind `#undef`");
        };
        let name = Name(first.token.value);
        if let Some(MacroId(id)) = self.macro_named(name)
            && let Some(definition) = self.macros.get(id as usize)
        {
            let text = self.names.text(name);
            if definition.predefined {
                let message = format!("`{text}` cannot be undefined");
                let d = error_at(error::RESERVED_MACRO, first.token.span, message);
                self.report(d.note("the language defines it"));
            } else if definition.is_open() {
                let message =
                    format!("macro `{text}` is undefined while a call of it is being read");
                self.report(error_at(error::BAD_DIRECTIVE, first.token.span, message));
            } else if let Some(slot) = self.macro_of.get_mut(name.0 as usize) {
                *slot = 0;
            }
        }
        self.expect_end(rest, "undef");
    }

    fn error_directive(&mut self, span: Span, word: &Piece, rest: &[Piece]) {
        let text = match (rest.first(), rest.last()) {
            (Some(a), Some(b)) => self.raw_text(a.token.span.to(b.token.span)).to_string(),
            _ => String::new(),
        };
        let text: String = text.chars().filter(|c| !c.is_control()).take(200).collect();
        let _ = word;
        self.report(error_at(
            error::ERROR_DIRECTIVE,
            span,
            format!("`#error`: {text}"),
        ));
    }

    fn pragma(&mut self, span: Span, rest: &[Piece]) {
        let words: Vec<&str> = rest.iter().map(|p| self.raw_text(p.token.span)).collect();
        let (is_standard, words) = match words.split_first() {
            Some((&"STDGL", more)) => (true, more),
            _ => (false, words.as_slice()),
        };
        let message = match words {
            [] => return,
            ["invariant", "(", "all", ")"] if is_standard => {
                if !(self.is_fragment && self.version == Version::Es300) {
                    return;
                }
                "`#pragma STDGL invariant(all)` cannot stand in a fragment shader"
            }
            _ if is_standard => return,
            ["optimize" | "debug", "(", "on" | "off", ")"] => return,
            ["optimize" | "debug", "(", _, ")"] | ["optimize" | "debug"] => {
                "this pragma takes `on` or `off`"
            }
            [_] | [_, "(", _, ")"] => return,
            [_, ..] => return,
        };
        self.report(error_at(error::BAD_DIRECTIVE, span, message));
    }

    fn extension(&mut self, span: Span, rest: &[Piece]) {
        let [name, colon, behavior] = rest else {
            return self.expected(span, &[], "`#extension NAME : enable`");
        };
        let is_word = |p: &Piece| p.token.kind == TokenKind::Identifier;
        if !is_word(name) || colon.token.kind != TokenKind::Colon || !is_word(behavior) {
            return self.expected(span, &[], "`#extension NAME : enable`");
        }
        let (name, behavior) = (Name(name.token.value), Name(behavior.token.value));
        if self.seen_code && self.role == Role::User {
            let d = error_at(
                error::EXTENSION_PLACEMENT,
                span,
                "`#extension` stands behind code",
            )
            .note("it must come before everything but other directives and comments (section 3.4)");
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
        let message = match how.as_str() {
            "require" if text == "all" => "`all` cannot be required".to_string(),
            "enable" if text == "all" => "`all` cannot be enabled".to_string(),
            "require" if !KNOWN_EXTENSIONS.contains(&text.as_str()) => {
                format!("WebGL2 has no extension `{text}` for shaders")
            }
            "require" | "enable" | "warn" | "disable" => return,
            _ => format!(
                "`{how}` is no behavior; there are `require`, `enable`, `warn` and `disable`"
            ),
        };
        let d = error_at(error::UNKNOWN_EXTENSION, span, message);
        let is_core = self.version == Version::Es300 && CORE_EXTENSIONS.contains(&text.as_str());
        if !is_core {
            return self.report(d);
        }
        let line = Span::new(span.start, span.end + 1);
        let gone = match self.sources.text(line).ends_with('\n') {
            true => line,
            false => span,
        };
        self.report(
            d.note("GLSL ES 3.00 has what it added to WebGL1 built in")
                .fix(Fix::safe("take it out", vec![Edit::delete(gone)])),
        );
    }

    fn line(&mut self, span: Span, rest: &[Piece]) {
        let pieces = self.expand_all(rest.to_vec());
        if pieces
            .iter()
            .any(|p| p.token.kind == TokenKind::Bad && p.token.value != bad::NUMBER)
        {
            let d = error_at(
                error::BAD_DIRECTIVE,
                span,
                "`#line` takes numbers, not a file's name",
            );
            return self.report(d.help("write `#line 10` or `#line 10 1`"));
        }
        let result = evaluate_prefix(&pieces).and_then(|(line, taken)| {
            match pieces.get(taken..).unwrap_or(&[]) {
                [] => Ok(line),
                more => evaluate(more).map(|_| line),
            }
        });
        match result {
            Ok(line) => {
                let here = self
                    .sources
                    .file_at(span.start)
                    .map_or(0, |f| f.position(span.start).line);
                self.line_shift = line as i64 - here as i64 - 1;
            }
            Err(Problem::Empty) => {
                self.report(error_at(
                    error::BAD_DIRECTIVE,
                    span,
                    "`#line` needs a line number",
                ));
            }
            Err(problem) => self.report_condition(span, problem),
        }
    }
}
