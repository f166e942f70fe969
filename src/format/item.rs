//! The items of a text, between which white space is formatted: tokens, comments and whole
//! directives.

use super::request::Unformatted;
use shaderlint_syntax::{
    GroupDirective, RawKind, RawToken, TokenKind, Version, WordClass, classify, tokenize,
};
use shaderlint_text::Span;

/// A piece of text that is not changed.
#[derive(Clone, Copy, Debug)]
pub struct FormatItem {
    pub kind: ItemKind,
    /// The byte range in the text.
    pub span: Span,
    /// The number of line breaks between the previous item and this one.
    pub breaks: u32,
    /// The number of columns between the previous item and this one, on the same line.
    pub blanks: u32,
    /// The line on which it starts.
    pub line: u32,
    /// The column at which it starts, with tabs expanded.
    pub column: u32,
    /// The width in columns; of its last line if it spans several.
    pub width: u32,
    /// Whether it spans several lines.
    pub is_tall: bool,
    /// Whether the white space before it is kept.
    pub keeps: bool,
    /// Whether a line continuation (backslash and line break) precedes it.
    pub is_spliced: bool,
    /// Whether it is a prefix operator.
    pub is_prefix: bool,
    /// In a table: the item with which its rows move.
    pub anchor: Option<u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ItemKind {
    Token(TokenKind),
    LineComment,
    BlockComment,
    /// With its effect on `#if` groups, if it has one.
    Directive(Option<GroupDirective>),
    /// Text that is not code: a branch under `#if 0`.
    Idle,
}

impl FormatItem {
    /// Whether it is a token of this kind.
    pub fn is(&self, kind: TokenKind) -> bool {
        self.kind == ItemKind::Token(kind)
    }

    /// The kind of token; `None` for comments and directives.
    pub fn token(&self) -> Option<TokenKind> {
        match self.kind {
            ItemKind::Token(kind) => Some(kind),
            _ => None,
        }
    }

    pub fn is_comment(&self) -> bool {
        matches!(self.kind, ItemKind::LineComment | ItemKind::BlockComment)
    }

    /// Whether a line break must follow.
    pub fn ends_line(&self) -> bool {
        matches!(
            self.kind,
            ItemKind::LineComment | ItemKind::Directive(_) | ItemKind::Idle
        )
    }

    /// Whether its line cannot be measured by width.
    pub fn parts_lines(&self) -> bool {
        self.ends_line() || self.is_tall
    }
}

/// Comments that disable and enable the formatter.
const OFF: &str = "shaderlint: fmt off";
const ON: &str = "shaderlint: fmt on";

/// Splits a text into items.
///
/// # Errors
/// A comment is unterminated, or a `#` would become a directive by a line break before it.
pub fn items(text: &str, tab: u32) -> Result<Vec<FormatItem>, Unformatted> {
    let raw = tokenize(text, 0);
    // It extends to the end of the text.
    if let Some(open) = raw.last().filter(|t| t.kind == RawKind::OpenComment) {
        return Err(Unformatted {
            span: Span::new(open.span.start, open.span.start + 2),
            message: "unterminated comment".to_string(),
        });
    }
    let mut reader = ItemReader {
        text,
        tab,
        items: Vec::with_capacity(raw.len() / 2),
        line: 0,
        column: 0,
        breaks: 0,
        blanks: 0,
        keeps_next: false,
        splices_next: false,
        is_off: false,
    };
    let mut at = 0;
    while let Some(token) = raw.get(at) {
        if token.kind == RawKind::Hash && !reader.may_direct() {
            return Err(Unformatted {
                span: token.span,
                message: "`#` must be the first character on its line".to_string(),
            });
        }
        at += reader.read(&raw, at, token);
    }
    Ok(reader.items)
}

struct ItemReader<'a> {
    text: &'a str,
    tab: u32,
    items: Vec<FormatItem>,
    line: u32,
    column: u32,
    /// Of the gap before the next item.
    breaks: u32,
    blanks: u32,
    keeps_next: bool,
    splices_next: bool,
    /// Whether the formatter is disabled here.
    is_off: bool,
}

impl<'a> ItemReader<'a> {
    fn text(&self, span: Span) -> &'a str {
        let range = span.start as usize..span.end as usize;
        self.text.get(range).unwrap_or("")
    }

    /// Whether a `#` here starts a directive.
    fn may_direct(&self) -> bool {
        let mut before = self.items.iter().rev();
        let first = before.find(|i| !i.is_comment() || i.breaks > 0);
        self.breaks > 0 || first.is_none_or(FormatItem::is_comment)
    }

    /// Reads the item at `at`. Returns the number of raw tokens consumed.
    fn read(&mut self, raw: &[RawToken], at: usize, token: &RawToken) -> usize {
        let is_first = self.breaks > 0 || self.items.is_empty();
        match token.kind {
            RawKind::Whitespace | RawKind::Newline => self.gap(token),
            RawKind::Hash => {
                let (count, span) = directive(raw, at);
                let directive = self.branch(raw, at, span);
                let is_never =
                    directive == Some(GroupDirective::Opens) && is_never(self.text(span));
                self.keeps_next |= !is_first;
                self.add(ItemKind::Directive(directive), span);
                return match is_never {
                    true => count + self.idle(raw, at + count),
                    false => count,
                };
            }
            RawKind::LineComment => self.comment(ItemKind::LineComment, token.span),
            RawKind::BlockComment => self.comment(ItemKind::BlockComment, token.span),
            kind => {
                let kind = meaning(kind, self.text(token.span));
                self.add(ItemKind::Token(kind), token.span);
            }
        }
        1
    }

    /// The effect on branches of the directive at `at`, which covers `span`.
    fn branch(&self, raw: &[RawToken], at: usize, span: Span) -> Option<GroupDirective> {
        let name = raw.iter().skip(at + 1).find(|t| t.kind == RawKind::Word);
        let name = name.filter(|n| n.span.end <= span.end);
        GroupDirective::of(self.text(name?.span))
    }

    fn gap(&mut self, token: &RawToken) {
        let text = self.text(token.span);
        if text.contains('\\') {
            self.splices_next = true;
        }
        if token.kind == RawKind::Newline {
            self.breaks += 1;
        }
        let before = self.column;
        self.pass(text);
        self.blanks += self.column.saturating_sub(before);
    }

    /// Advances line and column past a text.
    fn pass(&mut self, text: &str) {
        let bytes = text.as_bytes();
        for (i, byte) in bytes.iter().enumerate() {
            match byte {
                b'\r' if bytes.get(i + 1) == Some(&b'\n') => {}
                b'\n' | b'\r' => {
                    self.line += 1;
                    self.column = 0;
                }
                b'\t' => self.column += self.tab - self.column % self.tab.max(1),
                // UTF-8 continuation bytes have no width.
                0x80..0xc0 => {}
                _ => self.column += 1,
            }
        }
    }

    fn comment(&mut self, kind: ItemKind, span: Span) {
        let text = self.text(span);
        let switches_on = text.contains(ON);
        let switches_off = !switches_on && text.contains(OFF);
        self.add(kind, span);
        self.is_off = match (switches_on, switches_off) {
            (true, _) => false,
            (_, true) => true,
            _ => self.is_off,
        };
    }

    fn add(&mut self, kind: ItemKind, span: Span) {
        let (line, column) = (self.line, self.column);
        let text = self.text(span);
        self.pass(text);
        let is_tall = self.line > line;
        let is_prefix = is_prefix(kind, &self.items);
        self.items.push(FormatItem {
            kind,
            span,
            breaks: self.breaks,
            blanks: self.blanks,
            line,
            column,
            width: match is_tall {
                true => self.column,
                false => self.column - column,
            },
            is_tall,
            keeps: self.keeps_next || self.splices_next || self.is_off,
            is_spliced: self.splices_next,
            is_prefix,
            anchor: None,
        });
        // A line break after a backslash would join the lines.
        self.keeps_next = text.ends_with('\\');
        self.splices_next = false;
        (self.breaks, self.blanks) = (0, 0);
    }

    /// Skips to the directive that ends a branch which is never active. Returns the number of raw
    /// tokens consumed.
    fn idle(&mut self, raw: &[RawToken], from: usize) -> usize {
        let mut depth = 0u32;
        let mut at = from;
        let mut is_first = true;
        let (mut first, mut last) = (None, from);
        while let Some(token) = raw.get(at) {
            let mut count = 1;
            if token.kind == RawKind::Hash && is_first {
                let span;
                (count, span) = directive(raw, at);
                match self.branch(raw, at, span) {
                    Some(GroupDirective::Opens) => depth += 1,
                    Some(_) if depth == 0 => break,
                    Some(GroupDirective::Closes) => depth -= 1,
                    _ => {}
                }
            }
            is_first = match token.kind {
                RawKind::Newline => true,
                RawKind::Whitespace => is_first,
                _ => false,
            };
            if !matches!(token.kind, RawKind::Newline | RawKind::Whitespace) {
                first.get_or_insert(at);
                last = at + count;
            }
            at += count;
        }
        let Some(first) = first else {
            return 0;
        };
        let gap = raw.get(from..first).unwrap_or(&[]);
        gap.iter().for_each(|token| self.gap(token));
        let start = raw.get(first).map_or(0, |t| t.span.start);
        let end = last.checked_sub(1).and_then(|i| raw.get(i));
        self.keeps_next = true;
        self.add(
            ItemKind::Idle,
            Span::new(start, end.map_or(start, |t| t.span.end)),
        );
        last - from
    }
}

/// The number of raw tokens of the directive at `at`, and its span.
fn directive(raw: &[RawToken], at: usize) -> (usize, Span) {
    let rest = raw.get(at..).unwrap_or(&[]);
    let line = rest.iter().take_while(|t| t.kind != RawKind::Newline);
    let line = rest.get(..line.count()).unwrap_or(&[]);
    let blank = |t: &&RawToken| t.kind == RawKind::Whitespace;
    let count = line.len() - line.iter().rev().take_while(blank).count();
    let span = |t: &RawToken| t.span;
    let first = line.first().map_or(Span::at(0), span);
    let last = count.checked_sub(1).and_then(|i| line.get(i));
    (count, first.to(last.map_or(first, span)))
}

/// Whether a directive is `#if 0`.
fn is_never(text: &str) -> bool {
    let condition = text.trim_start_matches('#').trim_start();
    let condition = condition.strip_prefix("if").map(str::trim);
    condition.is_some_and(|c| c == "0" || c.starts_with("0 //") || c.starts_with("0 /*"))
}

/// The token kind of a raw token, without macro expansion.
fn meaning(kind: RawKind, text: &str) -> TokenKind {
    match kind {
        RawKind::Operator(kind) => kind,
        RawKind::Integer => TokenKind::Int,
        RawKind::Float => TokenKind::Float,
        RawKind::Word => word(text),
        RawKind::ForeignWord => TokenKind::Identifier,
        _ => TokenKind::Bad,
    }
}

fn word(text: &str) -> TokenKind {
    let class = |version| match classify(text, version) {
        WordClass::Keyword(kind) => Some(kind),
        WordClass::Type(_) => Some(TokenKind::Type),
        WordClass::Plain | WordClass::Reserved => None,
    };
    let kind = class(Version::Es300).or_else(|| class(Version::Es100));
    kind.unwrap_or(TokenKind::Identifier)
}

/// Whether an operator is a prefix operator.
fn is_prefix(kind: ItemKind, before: &[FormatItem]) -> bool {
    use TokenKind::{Decrement, Increment, Minus, Not, Plus, Tilde};
    let ItemKind::Token(Plus | Minus | Increment | Decrement | Not | Tilde) = kind else {
        return false;
    };
    let tokens = before.iter().rev();
    let last = tokens
        .filter(|i| !i.is_comment())
        .find_map(FormatItem::token);
    let ends_operand = |kind: TokenKind| {
        kind.ends_operand() || matches!(kind, Increment | Decrement | TokenKind::Bad)
    };
    !last.is_some_and(ends_operand)
}
