//! Corrections: inserting, removing or replacing one token so that the rest of the code parses.
//!
//! A shader with syntax errors is parsed a second time. Where parsing fails, the one-token edits
//! that a typo could explain are tried, and those that let the following code parse are kept. If
//! several remain, the checker decides; see `semantic::corrections`.

use super::Parser;
use crate::Search;
use crate::names::{Name, TypeWord, Version, WordClass, classify};
use crate::set;
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{Diagnostic, Fix, Subject, error};
use shaderlint_text::{Edit, Role, Span};

/// Candidates for a missing type, most frequent first.
pub(super) const VALUE_TYPES: [TypeWord; 10] = {
    use TypeWord::*;
    [Float, Vec3, Vec2, Vec4, Int, Bool, Mat2, Mat3, Ivec2, Uint]
};

/// Keywords that a misspelled name is compared with.
const KEYWORDS: &str = "\
    return while else break continue discard switch case const struct uniform void default if for \
    do in out inout";

/// An edit of the token list at one index.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum TokenChange {
    /// Insert a token of this kind and value before the index.
    Insert(TokenKind, u32),
    /// Remove the token at the index.
    Delete,
    /// Replace the token at the index with one of this kind.
    Replace(TokenKind),
}

/// A probable correction of code that cannot be parsed.
#[derive(Clone, Debug)]
pub struct Correction {
    /// Index of the token in the preprocessor's output.
    pub(super) at: usize,
    pub(super) change: TokenChange,
    /// Reported if this correction is chosen.
    pub(super) diagnostic: Diagnostic,
}

impl Correction {
    /// Whether the scopes of names depend on it.
    pub fn moves_scopes(&self) -> bool {
        use TokenKind as T;
        match self.change {
            TokenChange::Insert(kind, _) | TokenChange::Replace(kind) => {
                matches!(kind, T::LeftBrace | T::RightBrace)
            }
            TokenChange::Delete => self.diagnostic.subject.is_brace(),
        }
    }

    /// What is reported if this correction is chosen.
    pub fn diagnostic(&self) -> &Diagnostic {
        &self.diagnostic
    }

    /// Whether it removes a token.
    pub fn is_removal(&self) -> bool {
        self.change == TokenChange::Delete
    }

    /// Whether it inserts a token.
    pub fn is_insertion(&self) -> bool {
        matches!(self.change, TokenChange::Insert(..))
    }
}

/// Alternative corrections that syntax alone cannot decide between, most probable first.
pub type Choice = Vec<Correction>;

/// State of error recovery.
#[derive(Default)]
pub(super) struct Corrections {
    /// Remaining search budget.
    pub search: Search,
    /// For each token its index before any correction; empty if there was none.
    pub origin: Vec<u32>,
    /// The corrections made, with their alternatives.
    pub choices: Vec<Choice>,
    /// Index of the token where parsing failed before the last correction.
    pub reached: Option<usize>,
}

/// Applies an edit to a list of tokens.
pub(super) fn change_tokens(tokens: &mut Vec<Token>, at: usize, change: TokenChange) {
    match change {
        TokenChange::Insert(kind, value) => {
            let before = at.checked_sub(1).and_then(|i| tokens.get(i));
            let address = before.map_or(0, |t| t.span.end);
            let token = Token::direct(kind, value, Span::at(address));
            tokens.insert(at.min(tokens.len()), token);
        }
        TokenChange::Delete if at < tokens.len() => {
            tokens.remove(at);
        }
        TokenChange::Delete => {}
        TokenChange::Replace(kind) => {
            if let Some(token) = tokens.get_mut(at) {
                token.kind = kind;
            }
        }
    }
}

/// Source text of an insertable token of this kind.
pub(super) fn symbol(kind: TokenKind, value: u32) -> &'static str {
    use TokenKind as T;
    match kind {
        T::LeftParen => "(",
        T::RightParen => ")",
        T::LeftBracket => "[",
        T::RightBracket => "]",
        T::LeftBrace => "{",
        T::RightBrace => "}",
        T::Semicolon => ";",
        T::Comma => ",",
        T::Colon => ":",
        T::Equal => "=",
        T::Star => "*",
        T::Plus => "+",
        T::Dot => ".",
        T::Type => VALUE_TYPES
            .into_iter()
            .find(|word| *word as u32 == value)
            .map_or("float", TypeWord::name),
        _ => keywords()
            .find(|(_, keyword)| *keyword == kind)
            .map_or("", |(text, _)| text),
    }
}

impl Parser<'_> {
    /// Index of a token before any correction.
    pub(super) fn original(&self, at: usize) -> usize {
        self.repairs.origin.get(at).map_or(at, |&o| o as usize)
    }

    /// Applies an edit to the parsed tokens and updates the original indices.
    pub(super) fn apply(&mut self, at: usize, change: TokenChange) {
        if self.repairs.origin.is_empty() {
            self.repairs.origin = (0..self.tokens.len() as u32).collect();
        }
        let original = self.original(at) as u32;
        change_tokens(&mut self.tokens, at, change);
        match change {
            TokenChange::Insert(..) => self.repairs.origin.insert(at, original),
            TokenChange::Delete => {
                self.repairs.origin.remove(at);
            }
            TokenChange::Replace(_) => {}
        }
    }

    /// Creates a correction with its diagnostic. `reported` is the error reported without the
    /// correction; `certainty` tells whether other corrections are possible.
    pub(super) fn correction(
        &self,
        at: usize,
        change: TokenChange,
        reported: Option<&Diagnostic>,
        certainty: Confidence,
    ) -> Correction {
        let diagnostic = match change {
            TokenChange::Insert(kind, value) => self.missing(at, kind, value),
            TokenChange::Delete => self.stray(at, reported),
            TokenChange::Replace(kind) => self.exchanged(at, kind),
        };
        let mut diagnostic = diagnostic;
        if let Some(fix) = &mut diagnostic.fix
            && certainty == Confidence::Sure
        {
            fix.applicability = shaderlint_diagnostic::Applicability::Safe;
        }
        Correction {
            at: self.original(at),
            change,
            diagnostic,
        }
    }

    /// The keyword that a name is probably a typo of: few differing letters, two transposed
    /// letters, or wrong capitals.
    pub(super) fn keyword_like(&self, at: usize) -> Option<TokenKind> {
        let word = self.names.text(Name(self.token(at).value));
        keyword_near(word).map(|(_, kind)| kind)
    }

    fn missing(&self, at: usize, kind: TokenKind, value: u32) -> Diagnostic {
        use TokenKind as T;
        let symbol = symbol(kind, value);
        if kind == T::Type || kind == T::Void {
            return self.missing_type(at, symbol);
        }
        let place = self.gap_before(at);
        let (rule, message) = match kind {
            T::Semicolon => (error::MISSING_SEMICOLON, "missing `;`".to_string()),
            T::RightParen | T::RightBracket | T::RightBrace => {
                (error::UNCLOSED_DELIMITER, format!("missing `{symbol}`"))
            }
            T::Star | T::Plus => (error::SYNTAX_ERROR, "missing operator".to_string()),
            _ => (error::SYNTAX_ERROR, format!("missing `{symbol}`")),
        };
        let subject = match kind {
            T::RightBrace => Subject::MissingClose,
            T::LeftBrace => Subject::Brace,
            _ => Subject::Other,
        };
        let mark = match kind {
            T::LeftParen if set::BEFORE_PAREN.contains(self.token(at.saturating_sub(1)).kind) => {
                "expected `(` after this".to_string()
            }
            T::Star | T::Plus => "expected an operator here".to_string(),
            _ => format!("expected `{symbol}` here"),
        };
        let text = match kind {
            T::Star | T::Plus | T::Equal | T::Colon => format!(" {symbol}"),
            _ => symbol.to_string(),
        };
        let title = match kind {
            T::Star | T::Plus => format!("add the missing operator, such as `{symbol}`"),
            _ => format!("add `{symbol}`"),
        };
        let callee = self.token(at.saturating_sub(1));
        let place_reported = match kind == T::LeftParen && set::BEFORE_PAREN.contains(callee.kind) {
            true => callee.span.to(place),
            false => place,
        };
        let mut d = Diagnostic::error(rule, place_reported, message)
            .about(subject)
            .mark(mark)
            .fix(Fix::suggestion(
                title,
                vec![Edit::insert(place.start, text)],
            ));
        let open = self.unclosed_before(at, kind);
        // A bracket inserted by a correction has no place in the text.
        if let Some(open) = open.filter(|&open| !self.token(open).span.is_empty()) {
            let partner = self.text(&self.token(open));
            d = d.label(self.token(open).span, format!("unclosed `{partner}`"));
        }
        d
    }

    fn missing_type(&self, at: usize, word: &str) -> Diagnostic {
        let token = self.token(at);
        let name = self.text(&token);
        let (what, missing, subject) = match self.token(at + 1).kind {
            TokenKind::LeftParen => ("function", "return type", Subject::UntypedFunction),
            _ => ("parameter", "type", Subject::Other),
        };
        Diagnostic::error(
            error::SYNTAX_ERROR,
            token.span,
            format!("{what} `{name}` has no {missing}"),
        )
        .about(subject)
        .fix(Fix::suggestion(
            format!("add the {missing}, such as `{word}`"),
            vec![Edit::insert(token.span.start, format!("{word} "))],
        ))
    }

    fn stray(&self, at: usize, reported: Option<&Diagnostic>) -> Diagnostic {
        let token = self.token(at);
        let text = self.text(&token);
        let is_bracket = matches!(
            token.kind,
            TokenKind::LeftParen
                | TokenKind::RightParen
                | TokenKind::LeftBracket
                | TokenKind::RightBracket
                | TokenKind::LeftBrace
                | TokenKind::RightBrace
        );
        let (message, subject) = match (is_bracket, reported) {
            (true, _) => (format!("unmatched `{text}`"), brace_subject(token.kind)),
            (false, Some(d)) if d.span == token.span => (d.message.clone(), d.subject),
            _ => (format!("unexpected `{text}`"), Subject::Other),
        };
        let rule = match is_bracket {
            true => error::UNCLOSED_DELIMITER,
            false => error::SYNTAX_ERROR,
        };
        let edit = Edit::delete(self.with_blanks(at));
        Diagnostic::error(rule, token.span, message)
            .about(subject)
            .fix(Fix::suggestion(format!("remove `{text}`"), vec![edit]))
    }

    fn exchanged(&self, at: usize, kind: TokenKind) -> Diagnostic {
        let token = self.token(at);
        let text = self.text(&token);
        let symbol = symbol(kind, 0);
        Diagnostic::error(
            error::SYNTAX_ERROR,
            token.span,
            format!("expected `{symbol}`, found `{text}`"),
        )
        .about(match brace_subject(kind) {
            Subject::Other => brace_subject(token.kind),
            subject => subject,
        })
        .fix(Fix::suggested_replacement(token.span, symbol))
    }

    /// The span of a token with the blanks before it on its line, unless it starts the line.
    fn with_blanks(&self, at: usize) -> Span {
        let token = self.token(at).span;
        let before = Span::new(self.token(at.saturating_sub(1)).span.end, token.start);
        match self.is_blank(before) && !self.starts_line(at) {
            true => before.to(token),
            false => token,
        }
    }

    /// Whether a span consists only of blanks on one line.
    pub(super) fn is_blank(&self, span: Span) -> bool {
        let is_blank = |b| matches!(b, b' ' | b'\t');
        span.start <= span.end
            && self.sources.file_id_at(span.start) == self.sources.file_id_at(span.end)
            && self.sources.text(span).bytes().all(is_blank)
    }

    /// The gap between a token and the one before it: the blanks between them, or the end of the
    /// line if the line ends there.
    fn gap_before(&self, at: usize) -> Span {
        let before = at.checked_sub(1).filter(|&before| self.is_user(before));
        let Some(before) = before else {
            return self.token(at).span.before();
        };
        let last = self.token(before).span;
        let between = Span::new(last.end, self.token(at).span.start);
        if self.is_blank(between) {
            return between;
        }
        last.after()
    }

    /// Whether a token is in the user's text rather than in a host's prelude.
    pub(super) fn is_user(&self, at: usize) -> bool {
        let file = self.sources.file_at(self.token(at).span.start);
        file.is_none_or(|f| f.role == Role::User)
    }

    /// The open bracket that a missing closing bracket would match.
    fn unclosed_before(&self, at: usize, kind: TokenKind) -> Option<usize> {
        let open = match kind {
            TokenKind::RightParen => TokenKind::LeftParen,
            TokenKind::RightBracket => TokenKind::LeftBracket,
            _ => return None,
        };
        let mut closed = 0_u32;
        for i in (at.saturating_sub(MAX_LOOK)..at).rev() {
            let token = self.token(i);
            if token.kind == kind {
                closed += 1;
            } else if token.kind == open {
                if closed == 0 {
                    return Some(i);
                }
                closed -= 1;
            }
        }
        None
    }
}

/// The keyword that a word is probably a typo of.
pub fn keyword_near(word: &str) -> Option<(&'static str, TokenKind)> {
    keywords().find(|(keyword, _)| is_typo(word, keyword))
}

/// The [`KEYWORDS`] with their kinds.
fn keywords() -> impl Iterator<Item = (&'static str, TokenKind)> {
    KEYWORDS.split(' ').filter_map(|word| {
        let WordClass::Keyword(kind) = classify(word, Version::Es300) else {
            return None;
        };
        Some((word, kind))
    })
}

/// Whether two words have the same letters, perhaps in another order.
pub fn has_same_letters(one: &str, other: &str) -> bool {
    let letters = |word: &str| {
        let mut letters = word.as_bytes().to_vec();
        letters.sort_unstable();
        letters
    };
    letters(one) == letters(other)
}

fn is_typo(word: &str, keyword: &str) -> bool {
    let most = (keyword.len() - 1) / 3;
    if word.len().abs_diff(keyword.len()) > most {
        return false;
    }
    let word = word.to_ascii_lowercase();
    let distance = strsim::damerau_levenshtein(keyword, &word);
    distance <= most || (distance == 1 && has_same_letters(keyword, &word))
}

/// Maximum distance at which a matching bracket is searched, in tokens.
const MAX_LOOK: usize = 1_000;

/// Whether other corrections are plausible.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Confidence {
    Sure,
    Likely,
}

/// The subject of an error about a token: braces are distinguished from everything else.
pub(super) fn brace_subject(kind: TokenKind) -> Subject {
    match kind {
        TokenKind::LeftBrace | TokenKind::RightBrace => Subject::Brace,
        _ => Subject::Other,
    }
}
