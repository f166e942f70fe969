//! What can be folded: bodies, comments, groups of the preprocessor. By tokens alone, so that it
//! holds while a text is being written.

use super::document::Document;
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};
use shaderlint_text::{LineIndex, Span};

/// Something of several lines that can be folded.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct FoldingSpan {
    /// From the place behind which it is folded to the one before which that ends, in the text of
    /// the document.
    pub span: Span,
    /// What it is.
    pub kind: FoldKind,
}

/// What can be folded.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum FoldKind {
    /// Between brackets.
    Block,
    /// A comment, or line comments one below the other.
    Comment,
    /// From `#if` to `#endif`.
    Group,
}

/// What can be folded in a text.
pub fn folds(document: &Document) -> Vec<FoldingSpan> {
    let mut found = Vec::new();
    let mut seen: Vec<u32> = Vec::new();
    let sources = &document.report.sources;
    for (program, _) in document.shaders() {
        let Some(end) = program.tokens.tokens.last() else {
            continue;
        };
        let Some(code) = sources.code_at(end.span.start) else {
            continue;
        };
        if !seen.contains(&code.base) {
            seen.push(code.base);
            in_code(document, code.text, code.base, &mut found);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn in_code(document: &Document, text: &str, base: u32, found: &mut Vec<FoldingSpan>) {
    let lines = LineIndex::new(text);
    let mut add = |start: u32, end: u32, kind| {
        if lines.line(start - base) < lines.line(end - base)
            && let Some(span) = document.report.in_input(Span::new(start, end))
        {
            found.push(FoldingSpan { span, kind });
        }
    };
    let tokens = tokenize(text, base);
    let mut open: Vec<u32> = Vec::new();
    let mut groups: Vec<u32> = Vec::new();
    let mut comments: Option<Span> = None;
    let mut at_start = true;
    for (i, token) in tokens.iter().enumerate() {
        if token.kind == RawKind::LineComment && at_start {
            comments = Some(comments.map_or(token.span, |c| c.to(token.span)));
        } else if !matches!(token.kind, RawKind::Whitespace | RawKind::Newline)
            || (token.kind == RawKind::Newline && at_start)
        {
            // An empty line ends a run of line comments.
            if let Some(run) = comments.take() {
                add(run.start, run.end, FoldKind::Comment);
            }
        }
        match token.kind {
            RawKind::BlockComment => add(token.span.start, token.span.end, FoldKind::Comment),
            RawKind::Operator(TokenKind::LeftBrace | TokenKind::LeftParen) => {
                open.push(token.span.end);
            }
            RawKind::Operator(TokenKind::RightBrace | TokenKind::RightParen) => {
                if let Some(start) = open.pop() {
                    add(start, token.span.start, FoldKind::Block);
                }
            }
            RawKind::Hash if at_start => match directive(text, base, tokens.get(i..)) {
                "if" | "ifdef" | "ifndef" => groups.push(line_end(&lines, text, base, token)),
                "else" | "elif" => {
                    if let Some(start) = groups.pop() {
                        add(start, token.span.start, FoldKind::Group);
                    }
                    groups.push(line_end(&lines, text, base, token));
                }
                "endif" => {
                    if let Some(start) = groups.pop() {
                        add(start, token.span.start, FoldKind::Group);
                    }
                }
                _ => {}
            },
            _ => {}
        }
        at_start = match token.kind {
            RawKind::Newline => true,
            RawKind::Whitespace => at_start,
            RawKind::LineComment => false,
            _ => false,
        };
    }
    if let Some(run) = comments {
        add(run.start, run.end, FoldKind::Comment);
    }
}

/// The name of the directive that tokens begin with.
fn directive<'t>(text: &'t str, base: u32, tokens: Option<&[RawToken]>) -> &'t str {
    let mut words = tokens.unwrap_or(&[]).iter().skip(1).take(2);
    let word = words.find(|t| t.kind == RawKind::Word);
    let span = word.map(|t| (t.span.start - base) as usize..(t.span.end - base) as usize);
    span.and_then(|span| text.get(span)).unwrap_or("")
}

/// The end of the line that a token stands on.
fn line_end(lines: &LineIndex, text: &str, base: u32, token: &RawToken) -> u32 {
    let (start, end) = lines.bounds(token.span.start - base, text.len() as u32);
    let line = text.get(start as usize..end as usize).unwrap_or("");
    base + start + line.trim_end_matches(['\n', '\r']).len() as u32
}
