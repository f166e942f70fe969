//! The preprocessor, which works on tokens (GLSL ES 3.00 section 3.4).
//!
//! Reads files in sequence as one text and produces the tokens for the parser. Each token records
//! where it is spelled and which macro call produced it. What the preprocessor removes (comments,
//! skipped groups, definitions) is kept separately.

mod condition;
mod directive;
mod directive_repair;
mod exact;
mod extensions;
mod group;
mod input;
mod lines;
mod macros;
mod number;
mod place;
mod version;

pub use directive_repair::DIRECTIVES;
pub use macros::{Expansion, Macro, MacroId, Piece};

use super::context::{Extensions, GlContext};
use super::language::Feature;
use super::lexer::{Lexer, unsplice};
use super::names::{Name, Names, Version, WordClass};
use super::token::{RawKind, RawToken, Token, TokenKind};
use input::{TokenInput, TokenList};
use lines::LineCount;
use macros::Expander;
use memchr::memchr;
use number::{bad_number, float, integer};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Fix, MacroUse, error};
use shaderlint_text::{Edit, FileId, Role, Sources, Span};
use std::sync::OnceLock;

/// Maximum number of tokens from all macro expansions of one shader.
const MAX_EXPANDED: usize = 1_000_000;
/// Maximum number of tokens copied for calls inside arguments; calls spelled out there are read in
/// place and do not count.
const MAX_GATHERED: usize = 10_000_000;

/// Output of the preprocessor.
#[derive(Default)]
pub struct Tokens {
    /// Tokens for the parser; the last one is `End`.
    pub tokens: Vec<Token>,
    /// Macro calls in order of expansion.
    pub expansions: Vec<Expansion>,
    /// All macro definitions, including undefined ones.
    pub macros: Vec<Macro>,
    /// Spans of all comments.
    pub comments: Vec<Span>,
    /// Spans skipped by conditional directives, from the end of one directive to the start of the
    /// next, in the order of addresses.
    pub inactive: Vec<Span>,
    /// Groups from `#if` to `#endif` whose condition tests an undefined name, in source order, without
    /// those inside another one. Include guards are not listed.
    pub undecided: Vec<Span>,
    /// Each such group, also those inside another one.
    pub forks: Vec<Span>,
    /// The inactive code of such groups, without what other conditions inside them make
    /// inactive, in the order of addresses.
    pub alternatives: Vec<Span>,
    /// All `#extension` directives, in source order.
    pub extensions: Vec<ExtensionUse>,
    /// The extensions that they turn on.
    pub active: Extensions,
    /// Span of the `#version` directive.
    pub version_span: Option<Span>,
    /// Whether `#pragma STDGL invariant(all)` makes every output invariant.
    pub invariant_all: bool,
    /// The NUL character that ends the shader before its text ends; the browser ignores what
    /// follows.
    pub cut: Option<Span>,
    /// The numbers of the tokens that macro calls supplied, in order. Determined on the first
    /// question, when the tokens are final.
    expanded: OnceLock<Vec<u32>>,
}

/// An `#extension NAME : behavior` directive.
#[derive(Clone, Debug)]
pub struct ExtensionUse {
    /// Name of the extension.
    pub name: Name,
    /// `require`, `enable`, `warn` or `disable`.
    pub behavior: Name,
    /// Span of the directive.
    pub span: Span,
}

/// The result of [`preprocess`].
pub struct Preprocessed {
    /// The tokens and everything removed from them.
    pub tokens: Tokens,
    /// All words of the shader.
    pub names: Names,
    /// Version of the language, from `#version`.
    pub version: Version,
    /// Errors and warnings found.
    pub diagnostics: Vec<Diagnostic>,
    /// Whether a limit stopped preprocessing, so that the tokens are incomplete.
    pub gave_up: bool,
}

/// Preprocesses `files` as one text, for a fragment or vertex shader that a context compiles.
pub fn preprocess(
    sources: &Sources,
    files: &[FileId],
    is_fragment: bool,
    context: GlContext,
) -> Preprocessed {
    let mut pp = Preprocessor::new(sources, files, is_fragment, context);
    pp.define_predefined();
    pp.run();
    Preprocessed {
        gave_up: pp.gave_up,
        version: pp.version,
        tokens: Tokens {
            macros: pp.macros,
            undecided: outermost(std::mem::take(&mut pp.out.undecided)),
            // Included files are read in the middle of others.
            inactive: sorted(std::mem::take(&mut pp.out.inactive)),
            alternatives: sorted(std::mem::take(&mut pp.out.alternatives)),
            ..pp.out
        },
        names: pp.names,
        diagnostics: pp.diagnostics,
    }
}

fn sorted(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_unstable();
    spans
}

/// The groups that are not inside other groups, in source order.
fn outermost(mut groups: Vec<Span>) -> Vec<Span> {
    groups.sort_by_key(|g| (g.start, std::cmp::Reverse(g.end)));
    let mut end = 0;
    groups.retain(|group| {
        let is_outer = group.start >= end;
        end = end.max(group.end);
        is_outer
    });
    groups
}

/// The `value` of a `Bad` token: what is wrong with it.
mod bad {
    pub const NUMBER: u32 = 0;
    pub const CHARACTER: u32 = 1;
    pub const HASH: u32 = 2;
    pub const OVERFLOW: u32 = 3;
    /// Placeholder for something already reported.
    pub const REPORTED: u32 = 4;
}

#[derive(Default)]
struct ConditionGroup {
    start: Span,
    /// Whether the whole `#if ... #endif` is inside a skipped group.
    skip_all: bool,
    /// Whether the current branch is skipped.
    skip: bool,
    taken: bool,
    else_at: Option<Span>,
    /// Whether its condition tests an undefined name.
    is_undecided: bool,
    /// The name tested by `#ifndef`; defining it as empty makes the group an include guard.
    guard: Option<Name>,
}

struct Preprocessor<'a> {
    sources: &'a Sources,
    files: std::slice::Iter<'a, FileId>,
    lexer: Lexer<'a>,
    text: &'a str,
    base: u32,
    role: Role,
    /// Whether a host adds text before the user's.
    has_prelude: bool,
    is_fragment: bool,
    context: GlContext,
    names: Names,
    version: Version,
    macros: Vec<Macro>,
    /// By name, the macro's index plus one; 0 for none.
    macro_of: Vec<u32>,
    groups: Vec<ConditionGroup>,
    /// Start of the skipped text, while text is skipped.
    skipped_from: Option<u32>,
    /// Whether the skipped group has a condition that a host decides.
    skips_alternative: bool,
    at_line_start: bool,
    /// End of the line of the current directive.
    line_end: u32,
    seen_directive: bool,
    seen_code: bool,
    expanded: usize,
    /// Number of tokens copied for calls inside arguments of calls.
    gathered: usize,
    gave_up: bool,
    /// Whether a `#` was just seen.
    pasting: bool,
    lines: LineCount,
    bad_words: FxHashSet<Name>,
    /// Names of which a host says that it does not define them.
    undefined: FxHashSet<Name>,
    /// Names that start with a digit, and the index of the error about them.
    numbered_names: FxHashMap<Name, usize>,
    out: Tokens,
    diagnostics: Vec<Diagnostic>,
}

fn error_at(kind: ErrorKind, span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error(kind, span, message)
}

fn end_token(at: u32) -> Token {
    Token {
        kind: TokenKind::End,
        value: 0,
        span: Span::at(at),
        spelled: at,
        expansion: Token::DIRECT,
    }
}

impl<'a> Preprocessor<'a> {
    fn new(
        sources: &'a Sources,
        files: &'a [FileId],
        is_fragment: bool,
        context: GlContext,
    ) -> Preprocessor<'a> {
        Preprocessor {
            sources,
            files: files.iter(),
            lexer: Lexer::new("", 0),
            text: "",
            base: 0,
            role: Role::User,
            has_prelude: false,
            is_fragment,
            context,
            names: Names::default(),
            version: Version::Es100,
            macros: Vec::new(),
            macro_of: Vec::new(),
            groups: Vec::new(),
            skipped_from: None,
            skips_alternative: false,
            at_line_start: true,
            line_end: 0,
            seen_directive: false,
            seen_code: false,
            expanded: 0,
            gathered: 0,
            gave_up: false,
            pasting: false,
            lines: LineCount::default(),
            bad_words: FxHashSet::default(),
            undefined: FxHashSet::default(),
            numbered_names: FxHashMap::default(),
            out: Tokens::default(),
            diagnostics: Vec::new(),
        }
    }

    fn run(&mut self) {
        let codes = self.files.clone().filter_map(|&id| self.sources.code(id));
        // Most texts have at most one token per four characters.
        let length: usize = codes.map(|code| code.text.len()).sum();
        self.out.tokens.reserve(length / 4);
        self.next_file();
        let mut expander = Expander::default();
        while !self.gave_up {
            let piece = self.next_piece();
            if piece.token.kind == TokenKind::End {
                break;
            }
            if self.macro_of_piece(&piece).is_some() {
                expander.put_back(piece);
                if !self.emit_expanded(&mut expander) {
                    break;
                }
            } else {
                self.emit(piece.token);
            }
            if self.expanded > MAX_EXPANDED {
                self.too_much_expansion(piece.token.span);
            }
        }
        self.out
            .tokens
            .push(end_token(self.base + self.text.len() as u32));
        let end = self.base + self.text.len() as u32;
        for group in std::mem::take(&mut self.groups).into_iter().rev().take(1) {
            self.close_group(&group, end);
            let d = error_at(
                error::UNBALANCED_CONDITIONAL,
                group.start,
                "missing `#endif`",
            );
            self.report(d.note("the conditional group extends to the end of the shader"));
        }
    }

    /// Emits the expansion of a macro call and the lookahead needed to find its end; false if the
    /// shader ends inside it.
    #[inline(never)]
    fn emit_expanded(&mut self, expander: &mut Expander) -> bool {
        while !expander.is_idle() {
            let piece = expander.next(self, &mut TokenInput::Files);
            if piece.token.kind == TokenKind::End || self.gave_up {
                return false;
            }
            self.emit(piece.token);
            if self.expanded > MAX_EXPANDED {
                self.too_much_expansion(piece.token.span);
                return false;
            }
        }
        true
    }

    /// Switches to the next file; false if there is none.
    fn next_file(&mut self) -> bool {
        let id = self.files.next();
        let Some(file) = id.and_then(|&id| self.sources.code(id)) else {
            return false;
        };
        self.text = file.text;
        if let Some(nul) = memchr(0, file.text.as_bytes()) {
            self.text = file.text.get(..nul).unwrap_or("");
            self.files = [].iter();
            let at = file.base + nul as u32;
            self.out.cut = Some(Span::new(at, at + 1));
        }
        let is_ended = file.role == Role::User && id.is_some_and(|id| id.is_file());
        let end = file.base + self.text.len() as u32;
        self.lines.go_on(file.base, end, is_ended);
        self.base = file.base;
        self.role = file.role;
        self.has_prelude |= file.role == Role::Prelude;
        self.lexer = Lexer::new(self.text, file.base);
        self.at_line_start = true;
        if self.skipped_from.is_some() {
            self.skipped_from = Some(file.base);
        }
        true
    }

    fn is_skipping(&self) -> bool {
        self.groups.last().is_some_and(|g| g.skip_all || g.skip)
    }

    /// The next token of the files outside whitespace, comments and directives.
    #[inline(always)]
    fn next_piece(&mut self) -> Piece {
        let mut space = false;
        loop {
            space |= self.lexer.skip_blanks();
            let raw = self.lexer.next_token();
            match raw.kind {
                RawKind::Whitespace => space = true,
                RawKind::Newline => {
                    self.at_line_start = true;
                    space = true;
                }
                RawKind::LineComment | RawKind::BlockComment | RawKind::OpenComment => {
                    self.comment(raw);
                    space = true;
                }
                RawKind::Hash if self.at_line_start => {
                    self.directive(raw.span);
                    space = true;
                }
                RawKind::End => {
                    if !self.end_file(raw.span.start) {
                        return Piece {
                            token: end_token(raw.span.start),
                            space,
                            frozen: false,
                        };
                    }
                    space = true;
                }
                _ if self.skipped_from.is_some() => self.at_line_start = false,
                RawKind::Other if self.is_byte_order_mark(raw.span) => {
                    self.byte_order_mark(raw.span)
                }
                _ => {
                    self.at_line_start = false;
                    self.seen_code = true;
                    return self.piece(raw, space);
                }
            }
        }
    }

    /// Ends the current file and switches to the next; false if there is none.
    #[inline(never)]
    fn end_file(&mut self, end: u32) -> bool {
        if let Some(from) = self.skipped_from {
            self.out.inactive.push(Span::new(from, end));
        }
        self.next_file()
    }

    #[inline(never)]
    fn comment(&mut self, raw: RawToken) {
        self.out.comments.push(raw.span);
        if raw.kind == RawKind::OpenComment {
            let start = Span::new(raw.span.start, raw.span.start + 2);
            let d = error_at(error::UNTERMINATED_COMMENT, start, "unterminated comment")
                .mark("comment starts here")
                .note("the comment extends to the end of the file")
                .help("add `*/`");
            self.report(d);
        }
    }

    /// Text of a raw token of the current file.
    fn raw_text(&self, span: Span) -> &'a str {
        let (start, end) = (span.start - self.base, span.end - self.base);
        self.text.get(start as usize..end as usize).unwrap_or("")
    }

    #[inline(always)]
    fn piece(&mut self, raw: RawToken, space: bool) -> Piece {
        let (kind, value) = match raw.kind {
            RawKind::Operator(kind) => (kind, 0),
            _ if raw.spliced => self.classify(raw.kind, &unsplice(self.raw_text(raw.span))),
            _ => self.classify(raw.kind, self.raw_text(raw.span)),
        };
        let spelled = raw.span.start;
        let token = Token {
            kind,
            value,
            span: raw.span,
            spelled,
            expansion: Token::DIRECT,
        };
        Piece {
            token,
            space,
            frozen: false,
        }
    }

    /// Kind and value of a token; at this point every word is an identifier.
    #[inline(always)]
    fn classify(&mut self, kind: RawKind, text: &str) -> (TokenKind, u32) {
        match kind {
            RawKind::Word | RawKind::ForeignWord => {
                let name = self.names.intern(text);
                (TokenKind::Identifier, name.0)
            }
            RawKind::Operator(kind) => (kind, 0),
            RawKind::Integer => integer(text).unwrap_or((TokenKind::Bad, bad::OVERFLOW)),
            RawKind::Float => (TokenKind::Float, float(text).to_bits()),
            RawKind::BadNumber => (TokenKind::Bad, bad::NUMBER),
            RawKind::Hash => (TokenKind::Bad, bad::HASH),
            _ => (TokenKind::Bad, bad::CHARACTER),
        }
    }

    /// The macro that a token names, if it may be expanded.
    #[inline]
    fn macro_of_piece(&self, piece: &Piece) -> Option<MacroId> {
        match piece.token.kind == TokenKind::Identifier && !piece.frozen {
            true => self.macro_named(Name(piece.token.value)),
            false => None,
        }
    }

    fn macro_named(&self, name: Name) -> Option<MacroId> {
        let number = self.macro_of.get(name.0 as usize).copied().unwrap_or(0);
        number.checked_sub(1).map(MacroId)
    }

    /// Passes a fully expanded token to the parser.
    #[inline(always)]
    fn emit(&mut self, mut token: Token) {
        if self.pasting && !self.goes_on_pasting(&token) {
            return;
        }
        match token.kind {
            TokenKind::Identifier => {
                let name = Name(token.value);
                match self.names.class(name, self.version) {
                    WordClass::Plain if self.names.is_odd(name) => self.check_odd(name, &token),
                    WordClass::Plain => {}
                    WordClass::Keyword(kind) => token.kind = kind,
                    WordClass::Type(word) => {
                        token.kind = TokenKind::Type;
                        token.value = word as u32;
                    }
                    WordClass::Reserved => token.kind = self.reserved(name),
                }
            }
            TokenKind::Bad => {
                let Some(kept) = self.emit_bad(token) else {
                    return;
                };
                token = kept;
            }
            _ => {}
        }
        self.out.tokens.push(token);
    }

    /// Reports a name that is too long or contains non-ASCII letters.
    #[cold]
    fn check_odd(&mut self, name: Name, token: &Token) {
        let text = self.names.text(name);
        let limit = self.context.longest_name();
        if self.bad_words.contains(&name) || (text.len() <= limit && text.is_ascii()) {
            return;
        }
        let d = if text.is_ascii() {
            error_at(
                error::BROWSER_LIMIT,
                token.span,
                format!("name has {} characters; the limit is {limit}", text.len()),
            )
            .note(format!(
                "names are limited to {limit} characters in this version of WebGL"
            ))
        } else {
            let foreign = text.chars().find(|c| !c.is_ascii()).unwrap_or(' ');
            error_at(
                error::INVALID_CHARACTER,
                token.span,
                format!("unexpected character `{foreign}` in name `{text}`"),
            )
            .note("names use ASCII letters; other letters are allowed only in comments")
        };
        self.bad_words.insert(name);
        self.report_token(d, token);
    }

    /// Reports an invalid token and returns its replacement for the parser.
    #[cold]
    fn emit_bad(&mut self, token: Token) -> Option<Token> {
        let own = Span::new(token.spelled, token.spelled + 1);
        let file = self.sources.file_at(token.spelled);
        let rest = file
            .and_then(|f| f.text.get((token.spelled - f.base) as usize..))
            .unwrap_or("");
        match token.value {
            bad::OVERFLOW => {
                if self.version.has(Feature::IntegerLimit) {
                    let d = error_at(
                        error::INVALID_NUMBER,
                        token.span,
                        "integer does not fit in 32 bits",
                    )
                    .note("the largest integer is 4294967295, or 0xFFFFFFFF");
                    self.report_token(d, &token);
                }
                Some(Token {
                    kind: TokenKind::Int,
                    value: u32::MAX,
                    ..token
                })
            }
            bad::NUMBER => {
                let len = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '.' && c != '_');
                let text = rest
                    .get(..len.unwrap_or(rest.len()))
                    .unwrap_or("")
                    .to_string();
                if let Some(name) = self.numbered_name(&token, &text) {
                    return Some(name);
                }
                let d = bad_number(&token, &text);
                self.report_token(d, &token);
                Some(token)
            }
            bad::HASH => {
                let again = self
                    .diagnostics
                    .last()
                    .is_some_and(|d| d.is(error::TOKEN_PASTE) && d.span == token.span);
                if !again {
                    let d = error_at(error::TOKEN_PASTE, token.span, "unexpected `#`")
                        .note("GLSL ES has no `##` and no `#x`; a macro that contains them cannot be used")
                        .label(own, "this `#`");
                    self.report_token(d, &token);
                }
                self.start_pasting(token)
            }
            bad::REPORTED => Some(token),
            _ => {
                let c = rest.chars().next().unwrap_or('\0');
                self.report_character(&token, c);
                // Whitespace-like characters are dropped; others become a reported token.
                let is_blank = c.is_whitespace() || c.is_control() || is_invisible(c);
                (!is_blank).then_some(token)
            }
        }
    }

    /// `a ## b` would form one unknown token; returns its replacement for the parser.
    fn start_pasting(&mut self, token: Token) -> Option<Token> {
        if std::mem::replace(&mut self.pasting, true) {
            return None;
        }
        let is_word = |t: &Token| matches!(t.kind, TokenKind::Identifier | TokenKind::Type);
        if self.out.tokens.last().is_some_and(is_word) {
            self.out.tokens.pop();
        }
        Some(token)
    }

    /// Whether a token after `#` is kept: another `#` is reported again, the pasted word is
    /// dropped.
    fn goes_on_pasting(&mut self, token: &Token) -> bool {
        if token.kind == TokenKind::Bad && token.value == bad::HASH {
            return true;
        }
        self.pasting = false;
        !matches!(
            token.kind,
            TokenKind::Identifier | TokenKind::Int | TokenKind::Uint | TokenKind::Float
        )
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Reports an error at a token with the macro calls that produced it.
    fn report_token(&mut self, mut diagnostic: Diagnostic, token: &Token) {
        diagnostic.macros = macro_uses(&self.out.expansions, &self.macros, &self.names, token);
        if !token.is_direct() {
            diagnostic.fix = None;
        }
        self.report(diagnostic);
    }

    /// Reports an invalid character; adjacent ones are reported as one error.
    fn report_character(&mut self, token: &Token, c: char) {
        let d = bad_character(token, c);
        match self.diagnostics.last_mut() {
            Some(last)
                if last.is(error::INVALID_CHARACTER)
                    && last.span.end == d.span.start
                    && token.is_direct() =>
            {
                last.span.end = d.span.end;
                last.message = "unexpected characters".to_string();
                match (&mut last.fix, d.fix) {
                    (Some(fix), Some(more)) if fix.title == more.title => {
                        fix.edits.extend(more.edits);
                    }
                    (fix, _) => *fix = None,
                }
            }
            _ => self.report_token(d, token),
        }
    }

    fn too_much_expansion(&mut self, span: Span) {
        if !self.gave_up {
            self.gave_up = true;
            let d = error_at(error::MACRO_BUDGET, span, "macro expansion is too large").note(
                "the browser stops at 10,000 tokens in one call, shaderlint at 1,000,000 in total",
            );
            self.report(d);
        }
    }

    fn unterminated_call(&mut self, span: Span, id: MacroId) {
        let name = self
            .macros
            .get(id.0 as usize)
            .map_or("", |m| self.names.text(m.name));
        let message = format!("missing `)` in the call of macro `{name}`");
        self.report(error_at(error::MACRO_ARGUMENTS, span, message));
    }

    /// Value of `__LINE__` and `__FILE__` at a token.
    fn magic_value(&self, id: MacroId, token: &Token) -> Option<u32> {
        let definition = self.macros.get(id.0 as usize)?;
        if !definition.predefined {
            return None;
        }
        match self.names.text(definition.name) {
            "__LINE__" => {
                // `__LINE__` in an expansion has the line where the call ends.
                Some(self.lines.at(self.sources, token.span.end) as u32)
            }
            "__FILE__" => Some(self.lines.file as u32),
            _ => None,
        }
    }
}

/// The macro calls that produced a token, innermost first.
pub fn macro_uses(
    expansions: &[Expansion],
    macros: &[Macro],
    names: &Names,
    token: &Token,
) -> Vec<MacroUse> {
    let mut uses = Vec::new();
    let mut at = token.expansion;
    while let Some(expansion) = expansions.get(at as usize) {
        if uses.len() == 16 {
            break;
        }
        if let Some(definition) = macros.get(expansion.definition.0 as usize) {
            uses.push(MacroUse {
                name: names.text(definition.name).to_string(),
                call: expansion.call,
                definition: definition.name_span,
            });
        }
        at = expansion.parent;
    }
    uses
}

fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}' | '\u{feff}' | '\u{ad}')
}

fn bad_character(token: &Token, c: char) -> Diagnostic {
    let shown = if c.is_control() || c.is_whitespace() || is_invisible(c) {
        format!("invisible character U+{:04X}", c as u32)
    } else if c.is_ascii() {
        format!("character `{c}`")
    } else {
        format!("character U+{:04X} `{c}`", c as u32)
    };
    let message = match c {
        '"' | '\'' if token.span.len() > 1 => "GLSL has no strings".to_string(),
        _ => format!("unexpected {shown}"),
    };
    let d = error_at(error::INVALID_CHARACTER, token.span, message);
    let plain = match c {
        '\u{2018}' | '\u{2019}' | '\u{201c}' | '\u{201d}' | '"' | '\'' => {
            return d.note("quotes are allowed only in comments");
        }
        '\u{2013}' | '\u{2014}' | '\u{2212}' => "-",
        '\u{d7}' | '\u{b7}' | '\u{22c5}' => "*",
        '\u{f7}' => "/",
        '\u{2264}' => "<=",
        '\u{2265}' => ">=",
        '\u{2260}' => "!=",
        '\u{ff08}' => "(",
        '\u{ff09}' => ")",
        '\u{ff0c}' => ",",
        '\u{ff1b}' | '\u{37e}' => ";",
        c if c.is_whitespace() || c == '\u{a0}' => " ",
        c if is_invisible(c) => "",
        _ => return d.note(
            "characters outside the GLSL character set are allowed only in comments (section 3.1)",
        ),
    };
    let title = match plain {
        "" => "remove it".to_string(),
        " " => "replace it with a space".to_string(),
        _ => format!("use `{plain}`"),
    };
    d.fix(Fix::safe(title, vec![Edit::replace(token.span, plain)]))
}
