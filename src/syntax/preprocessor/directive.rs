//! Directives: the lines that start with `#` (GLSL ES 3.00 section 3.4).

use super::condition::{ConditionProblem, evaluate, evaluate_prefix};
use super::directive_repair::meant;
use super::macros::{Macro, MacroId, Piece};
use super::{Preprocessor, bad, error_at};
use crate::language::Feature;
use crate::names::Name;
use crate::token::{RawKind, Token, TokenKind};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::{Fix, error};
use shaderlint_text::{Edit, Role, SetAt, Span};

impl Preprocessor<'_> {
    /// Defines the predefined macros of the language.
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
        self.predefine_extensions();
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
        self.macro_of.set_at(at, self.macros.len() as u32);
    }

    /// Parses the directive that starts with the `#` at `hash`, up to the end of its line.
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
        self.line_end = end;
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
            (false, true) => {
                self.skipped_from = Some(end);
                self.skips_alternative = self.groups.last().is_some_and(|g| g.is_undecided);
            }
            (true, false) => {
                if let Some(from) = self.skipped_from.take() {
                    let skipped = Span::new(from, span.start);
                    self.out.inactive.push(skipped);
                    let alternative = Some(skipped).filter(|_| self.skips_alternative);
                    self.out.alternatives.extend(alternative);
                }
            }
            _ => {}
        }
    }

    fn unknown_directive(&mut self, span: Span, first: &Piece) {
        let text = self.raw_text(first.token.span);
        let text: String = text.chars().take(40).collect();
        let message = format!("unknown directive `#{text}`");
        let mut d = error_at(error::BAD_DIRECTIVE, span, message);
        if text == "include" || text == "import" {
            d = d.note(
                "GLSL ES cannot include files; insert their text before compiling the shader",
            );
        } else if let Some(near) = meant(&text) {
            let edit = Edit::replace(first.token.span, near);
            d = d.fix(Fix::safe(format!("did you mean `#{near}`?"), vec![edit]));
        }
        self.report(d);
    }

    pub(super) fn expected(&mut self, span: Span, rest: &[Piece], what: &str) {
        self.expected_or(span, rest, what, None);
    }

    /// Reports a missing part of a directive, with an optional fix.
    pub(super) fn expected_or(&mut self, span: Span, rest: &[Piece], what: &str, fix: Option<Fix>) {
        let at = rest.first().map_or(span.after(), |p| p.token.span);
        let message = format!("expected {what}");
        self.report(error_at(error::BAD_DIRECTIVE, at, message).fix(fix));
    }

    /// Reports tokens after the end of a directive.
    pub(super) fn expect_end(&mut self, rest: &[Piece], directive: &str) {
        self.expect_end_or(rest, directive, None);
    }

    /// Reports tokens after the end of a directive, with an optional fix.
    pub(super) fn expect_end_or(&mut self, rest: &[Piece], directive: &str, fix: Option<Fix>) {
        if let Some(first) = rest.first() {
            let last = rest.last().unwrap_or(first);
            let span = first.token.span.to(last.token.span);
            let message = format!("extra tokens at the end of `#{directive}`");
            let fix = fix.unwrap_or_else(|| {
                Fix::safe("comment them out", vec![Edit::insert(span.start, "// ")])
            });
            self.report(error_at(error::BAD_DIRECTIVE, span, message).fix(fix));
        }
    }

    fn define(&mut self, span: Span, rest: &[Piece]) {
        let Some((first, rest)) = rest.split_first() else {
            return self.expected(span, &[], "a macro name after `#define`");
        };
        if first.token.kind != TokenKind::Identifier {
            return self.expected(
                span,
                std::slice::from_ref(first),
                "a macro name after `#define`",
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
                Some((params, after)) => {
                    definition.params = Some(params);
                    body = after;
                }
                None => return,
            }
        }
        definition.body = body.to_vec();
        let params = definition.params.iter().flatten().zip(0..);
        let numbers: FxHashMap<u32, u32> = params.map(|(name, i)| (name.0, i)).collect();
        for (i, piece) in definition.body.iter_mut().enumerate() {
            piece.space &= i > 0;
            if piece.token.kind == TokenKind::Identifier
                && let Some(&index) = numbers.get(&piece.token.value)
            {
                piece.token.expansion = index;
            }
        }
        self.note_definition(&definition);
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
            format!("conflicting definitions of macro `{name}`"),
        )
        .mark("redefined here")
        .label(previous.name_span, "first defined here")
        .fix(self.undefine_before(name, definition.name_span));
        self.report(d);
    }

    fn undefine_before(&self, name: &str, second: Span) -> Fix {
        let before = (second.start - self.base) as usize;
        let before = self.text.get(..before).unwrap_or("");
        let line = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
        let edit = Edit::insert(self.base + line as u32, format!("#undef {name}\n"));
        Fix::suggestion(format!("add `#undef {name}` before it"), vec![edit])
    }

    fn check_macro_name(&mut self, name: Name, span: Span) -> bool {
        let text = self.names.text(name).to_string();
        let is_predefined = self
            .macro_named(name)
            .and_then(|id| self.macros.get(id.0 as usize))
            .is_some_and(|m| m.predefined);
        let why = if is_predefined {
            "it is predefined by the language"
        } else if text.starts_with("GL_") {
            "names that start with `GL_` are reserved"
        } else if text == "defined" {
            "`defined` is an operator of `#if`"
        } else {
            return true;
        };
        let message = format!("`{text}` cannot be defined as a macro");
        self.report(error_at(error::RESERVED_MACRO, span, message).note(why));
        false
    }

    /// Parses `a, b)` and returns the parameters and the tokens after them.
    fn params<'p>(
        &mut self,
        span: Span,
        mut rest: &'p [Piece],
    ) -> Option<(Vec<Name>, &'p [Piece])> {
        let mut params = Vec::new();
        let mut seen = FxHashSet::default();
        let all = rest;
        if let [close, more @ ..] = rest
            && close.token.kind == TokenKind::RightParen
        {
            return Some((params, more));
        }
        loop {
            let (first, more) = match rest.split_first() {
                Some((first, more)) if first.token.kind == TokenKind::Identifier => (first, more),
                _ => {
                    self.expected(span, rest, "a parameter name");
                    return None;
                }
            };
            let name = Name(first.token.value);
            if !seen.insert(name) {
                let message = format!("duplicate macro parameter `{}`", self.names.text(name));
                self.report(error_at(error::BAD_DIRECTIVE, first.token.span, message));
                return None;
            }
            params.push(name);
            match more.split_first() {
                // A comma may precede the `)`.
                Some((p, [close, after @ ..]))
                    if p.token.kind == TokenKind::Comma
                        && close.token.kind == TokenKind::RightParen =>
                {
                    return Some((params, after));
                }
                Some((p, after)) if p.token.kind == TokenKind::Comma => rest = after,
                Some((p, after)) if p.token.kind == TokenKind::RightParen => {
                    return Some((params, after));
                }
                _ => {
                    let close = || Edit::insert(first.token.span.end, ")");
                    let close = || Fix::suggestion("add `)`", vec![close()]);
                    let fix = self.without_types(all).unwrap_or_else(close);
                    self.expected_or(span, more, "`,` or `)`", Some(fix));
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
            return self.expected(span, rest, "a macro name after `#undef`");
        };
        let name = Name(first.token.value);
        if let Some(MacroId(id)) = self.macro_named(name)
            && let Some(definition) = self.macros.get(id as usize)
        {
            let text = self.names.text(name);
            if definition.predefined {
                let message = format!("`{text}` cannot be undefined");
                let d = error_at(error::RESERVED_MACRO, first.token.span, message);
                self.report(d.note("it is predefined by the language"));
            } else if definition.is_open() {
                let message = format!("macro `{text}` is undefined during its own expansion");
                self.report(error_at(error::BAD_DIRECTIVE, first.token.span, message));
            } else if let Some(slot) = self.macro_of.get_mut(name.0 as usize) {
                *slot = 0;
            }
        } else if self.role == Role::Prelude {
            self.undefined.insert(name);
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
        // Other pragmas are implementation-defined and ignored.
        let value = rest
            .get(2)
            .filter(|p| p.token.kind == TokenKind::Identifier);
        let message = match words {
            ["invariant", "(", "all", ")"] if is_standard => {
                self.out.invariant_all = true;
                if !self.is_fragment || self.version.has(Feature::InvariantInputs) {
                    return;
                }
                "`#pragma STDGL invariant(all)` is not allowed in a fragment shader"
            }
            _ if is_standard => return,
            ["optimize" | "debug", "(", "on" | "off", ")"] => return,
            ["optimize" | "debug", "(", _, ")"] if value.is_some() => {
                "this pragma expects `on` or `off`"
            }
            ["optimize" | "debug"] => "this pragma expects `on` or `off`",
            _ => return,
        };
        self.report(error_at(error::BAD_DIRECTIVE, span, message));
    }

    fn line(&mut self, span: Span, rest: &[Piece]) {
        let pieces = self.expand_all(rest.to_vec());
        let is_large = |p: &&Piece| {
            let is_int = matches!(p.token.kind, TokenKind::Int | TokenKind::Uint);
            is_int && p.token.value > i32::MAX as u32
        };
        if let Some(large) = pieces.iter().find(is_large) {
            let message = "number in `#line` is larger than 2147483647";
            let d = error_at(error::INVALID_NUMBER, large.token.span, message);
            return self.report_token(d, &large.token);
        }
        if pieces
            .iter()
            .any(|p| p.token.kind == TokenKind::Bad && p.token.value != bad::NUMBER)
        {
            let d = error_at(
                error::BAD_DIRECTIVE,
                span,
                "`#line` expects numbers, not a file name",
            );
            return self.report(d.help("use `#line 10` or `#line 10 1`"));
        }
        let result = evaluate_prefix(&pieces).and_then(|(line, taken)| {
            match pieces.get(taken..).unwrap_or(&[]) {
                [] => Ok((line, None)),
                more => evaluate(more).map(|file| (line, Some(file))),
            }
        });
        match result {
            Ok((line, file)) => {
                let number = line as i64 - 1;
                self.lines.set(self.sources, span.start, number, file);
                self.check_line_count(span, line);
            }
            Err(ConditionProblem::Empty) => {
                self.report(error_at(
                    error::BAD_DIRECTIVE,
                    span,
                    "expected a line number after `#line`",
                ));
            }
            Err(problem) => self.report_condition(span, &[], problem),
        }
    }

    /// The line number must not exceed the largest `int` before the next `#line`.
    fn check_line_count(&mut self, span: Span, line: i32) {
        let left = (i32::MAX - line.max(0)) as usize;
        let rest = self
            .text
            .get((span.end - self.base) as usize..)
            .unwrap_or("");
        if left >= rest.len() {
            return;
        }
        let sets_it = |l: &str| {
            let directive = l.trim_start().strip_prefix('#').map(str::trim_start);
            directive.is_some_and(|d| d.starts_with("line"))
        };
        let rest = rest.replace("\r\n", "\n").replace('\r', "\n");
        let mut after = rest.split('\n').skip(1);
        let before_next = after.position(sets_it).map(|i| i + 1);
        let count = before_next.unwrap_or_else(|| rest.matches('\n').count());
        if count > left {
            let message = "line numbers after `#line` exceed 2147483647";
            self.report(error_at(error::INVALID_NUMBER, span, message));
        }
    }
}
