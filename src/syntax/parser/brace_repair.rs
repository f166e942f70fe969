//! Unbalanced braces: finds which brace is missing or superfluous.
//!
//! GLSL has no nested functions, so braces are balanced between two function headers, and the error
//! is in a range where they are not. In that range, each possible insertion and deletion of a brace
//! is rated by the indentation of the following lines, and the best candidates are parsed.

use super::correction::{Choice, TokenChange, change_tokens};
use super::{Correction, Parser};
use crate::set;
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{Diagnostic, Facet, Fix, Subject, error};
use shaderlint_text::{Edit, Span};

/// Maximum number of functions with corrected braces.
const MAX_PIECES: usize = 6;
/// Longest function that is corrected, in tokens.
const MAX_PIECE: usize = 50_000;
/// Maximum number of corrections per function.
const MAX_ROUNDS: usize = 2;
/// Limit for rated candidates times function length in tokens.
const MAX_WORK: usize = 400_000;
/// Maximum number of candidates per function that are parsed.
const MAX_CANDIDATES: usize = 16;
/// Maximum number of alternatives that the checker compares.
const MAX_ALTERNATIVES: usize = 6;
/// Number of braces inspected to detect the brace style.
const MAX_BRACES: usize = 200;
/// Longest function header, in tokens.
const MAX_HEAD: usize = 500;

/// A token with the layout of its line.
#[derive(Clone, Copy)]
struct Laid {
    kind: TokenKind,
    /// Index of the token; for an inserted brace, of the token after it.
    at: usize,
    starts_line: bool,
    /// Line number, counted from the start of the range.
    line: usize,
    indent: usize,
    is_put_in: bool,
}

/// A candidate correction and its cost.
struct Weighed {
    at: usize,
    change: TokenChange,
    /// Number of lines with unexpected indentation, then how unusual the edit is.
    cost: (usize, usize),
    /// The brace that an inserted `}` closes.
    partner: Option<usize>,
    faults: usize,
}

impl Parser<'_> {
    /// Corrects the braces of every function where they are unbalanced.
    pub(super) fn repair_braces(&mut self) {
        for _ in 0..MAX_PIECES * MAX_ROUNDS {
            let Some((first, end, net)) = self.unbalanced_piece() else {
                return;
            };
            // Ranges that are too long or lack too many braces are left unchanged.
            let is_hopeless = net.unsigned_abs() as usize > MAX_PIECES * MAX_ROUNDS;
            let is_long = end - first > MAX_PIECE;
            if is_long || is_hopeless || !self.repair_braces_of_piece(first, end, net) {
                return;
            }
        }
    }

    /// The first range between two function headers with unbalanced braces, and the number of `{`
    /// minus `}` in it.
    fn unbalanced_piece(&self) -> Option<(usize, usize, i64)> {
        let mut first = 0;
        let mut net = 0_i64;
        let end = self.tokens.len().saturating_sub(1);
        let mut skip_to = 0;
        for at in 0..end {
            let token = self.token(at);
            if at >= skip_to
                && let Some(after) = self.head_at(at)
            {
                if net != 0 {
                    return Some((first, at, net));
                }
                first = at;
                skip_to = after;
            }
            match token.kind {
                TokenKind::LeftBrace => net += 1,
                TokenKind::RightBrace => net -= 1,
                _ => {}
            }
        }
        (net != 0).then_some((first, end, net))
    }

    /// Where the header of a function definition ends, if one starts here. Its `{` may be missing.
    pub(super) fn head_at(&self, at: usize) -> Option<usize> {
        use TokenKind as T;
        let is_type = matches!(self.token(at).kind, T::Type | T::Void | T::Identifier);
        let is_head = is_type
            && self.token(at + 1).kind == T::Identifier
            && self.token(at + 2).kind == T::LeftParen;
        let before = match at {
            0 => T::Semicolon,
            _ => self.token(at - 1).kind,
        };
        let is_apart = self.starts_line(at)
            || matches!(before, T::Semicolon | T::RightBrace)
            || set::PRECISIONS.contains(before);
        if !is_head || !is_apart {
            return None;
        }
        let mut open = 0_u32;
        for i in at + 2..at + MAX_HEAD {
            match self.token(i).kind {
                T::LeftParen => open += 1,
                T::RightParen => {
                    open = open.saturating_sub(1);
                    let next = self.token(i + 1).kind;
                    if open == 0 && !self.lists_parameters(at + 3) {
                        return None;
                    }
                    if open == 0 {
                        return (!matches!(next, T::Semicolon | T::Comma)).then_some(i + 1);
                    }
                }
                T::LeftBrace => return Some(i),
                // Another function header starts.
                T::Void if i > at + 3 && self.token(i + 1).kind == T::Identifier => return None,
                T::Semicolon | T::RightBrace | T::End => return None,
                _ => {}
            }
        }
        None
    }

    /// Whether the tokens from `at` on declare parameters rather than pass arguments.
    fn lists_parameters(&self, at: usize) -> bool {
        use TokenKind as T;
        match self.token(at).kind {
            T::RightParen | T::Void => true,
            T::Type => self.token(at + 1).kind != T::LeftParen,
            T::Identifier => matches!(
                self.token(at + 1).kind,
                T::Identifier | T::Comma | T::RightParen
            ),
            kind => set::QUALIFIES_PARAMETER.or(set::PRECISIONS).contains(kind),
        }
    }

    /// Corrects one brace between `first` and `end`.
    fn repair_braces_of_piece(&mut self, first: usize, end: usize, net: i64) -> bool {
        let laid = self.lay(first, end);
        let mut weighed = self.weigh_braces(&laid, net);
        weighed.retain(|w| self.is_user(w.at));
        weighed.sort_by_key(|w| w.cost);
        weighed.truncate(MAX_CANDIDATES);
        let code = self.tokens.get(first..end).unwrap_or(&[]).to_vec();
        for candidate in &mut weighed {
            if !self.repairs.search.pays(code.len()) {
                return false;
            }
            candidate.faults = self.faults_under(&code, candidate.at - first, candidate.change);
        }
        weighed.sort_by_key(|w| (w.faults, w.cost));
        let Some(best) = weighed.first() else {
            return false;
        };
        let (at, change, faults, cost) = (best.at, best.change, best.faults, best.cost.0);
        let choice: Choice = weighed
            .iter()
            .filter(|w| w.faults == faults && w.cost.0 == cost)
            .take(MAX_ALTERNATIVES)
            .map(|w| self.brace_correction(w))
            .collect();
        self.repairs.choices.push(choice);
        self.apply(at, change);
        true
    }

    /// Number of syntax errors in `code` after an edit.
    fn faults_under(&self, code: &[Token], at: usize, change: TokenChange) -> usize {
        let mut tokens = code.to_vec();
        change_tokens(&mut tokens, at, change);
        tokens.push(Token {
            kind: TokenKind::End,
            ..self.end
        });
        let mut speculative = self.speculative(tokens);
        speculative.translation_unit();
        let is_fault = |d: &&Diagnostic| {
            d.has(Facet::Grammar) || d.is(error::STRAY_SEMICOLON) || d.is(error::LOCAL_FUNCTION)
        };
        speculative.diagnostics.iter().filter(is_fault).count()
    }

    fn lay(&self, first: usize, end: usize) -> Vec<Laid> {
        let mut indent = 0;
        let mut line = 0;
        (first..end)
            .map(|at| {
                let starts_line = self.starts_line(at);
                if starts_line || at == first {
                    indent = self.indent(at);
                    line += 1;
                }
                Laid {
                    kind: self.token(at).kind,
                    at,
                    starts_line,
                    line,
                    indent,
                    is_put_in: false,
                }
            })
            .collect()
    }

    /// All edits of one brace that bring `net` closer to 0, with their costs.
    fn weigh_braces(&self, laid: &[Laid], net: i64) -> Vec<Weighed> {
        let changes = match net > 0 {
            true => self.closings(laid),
            false => self.openings(laid),
        };
        let most = (MAX_WORK / laid.len().max(1)).max(4);
        let skip = changes.len().saturating_sub(most);
        let is_indented = laid.iter().any(|l| l.starts_line && l.indent > 0);
        changes
            .into_iter()
            .skip(skip)
            .rev()
            .enumerate()
            .map(|(order, (index, change, oddness))| {
                let (indentation_mismatches, partner) = indentation_mismatches(laid, index, change);
                let cost = if is_indented {
                    indentation_mismatches
                } else {
                    0
                };
                let at = laid.get(index).map_or(self.end_of(laid), |l| l.at);
                Weighed {
                    at,
                    change,
                    cost: (cost, oddness * laid.len() + order),
                    partner,
                    faults: 0,
                }
            })
            .collect()
    }

    fn end_of(&self, laid: &[Laid]) -> usize {
        laid.last().map_or(0, |l| l.at + 1)
    }

    /// Candidates for a missing `}` or an extra `{`.
    fn closings(&self, laid: &[Laid]) -> Vec<(usize, TokenChange, usize)> {
        use TokenKind as T;
        let mut found = Vec::new();
        let mut before = T::End;
        let mut open = 0_u32;
        for (index, now) in laid.iter().enumerate() {
            let ends = matches!(before, T::Semicolon | T::RightBrace | T::LeftBrace);
            if ends && open > 0 {
                let oddness = match now.starts_line || now.kind == T::Else {
                    true => 1,
                    false => 2,
                };
                found.push((index, TokenChange::Insert(T::RightBrace, 0), oddness));
            }
            match now.kind {
                T::LeftBrace => {
                    open += 1;
                    if self.token(now.at).is_direct() {
                        let oddness = if before == T::LeftBrace { 0 } else { 2 };
                        found.push((index, TokenChange::Delete, oddness));
                        if set::BEFORE_PAREN.without(&[T::Layout]).contains(before) {
                            found.push((index, TokenChange::Replace(T::LeftParen), 1));
                        }
                    }
                }
                T::RightBrace => open = open.saturating_sub(1),
                _ => {}
            }
            before = now.kind;
        }
        found.push((laid.len(), TokenChange::Insert(T::RightBrace, 0), 1));
        found
    }

    /// Candidates for a missing `{` or an extra `}`.
    fn openings(&self, laid: &[Laid]) -> Vec<(usize, TokenChange, usize)> {
        use TokenKind as T;
        let mut found = Vec::new();
        let mut before = (T::End, T::End);
        let mut open = 0_u32;
        let mut brackets = OpenBrackets::default();
        for (index, now) in laid.iter().enumerate() {
            let is_head = matches!(before.1, T::RightParen | T::Else | T::Do)
                || (before.0 == T::Struct && before.1 == T::Identifier);
            let starts = !set::CONTINUES.contains(now.kind);
            if is_head && starts && now.kind != T::LeftBrace {
                // At global scope a header must have a body, so a missing `{` is likeliest there.
                let oddness = usize::from(open > 0);
                found.push((index, TokenChange::Insert(T::LeftBrace, 0), oddness));
            }
            if now.kind == T::RightBrace && self.token(now.at).is_direct() {
                found.push((index, TokenChange::Delete, 1));
                if let Some(close) = brackets.close() {
                    found.push((index, TokenChange::Replace(close), 1));
                }
            }
            brackets.read(now.kind);
            match now.kind {
                T::LeftBrace => open += 1,
                T::RightBrace => open = open.saturating_sub(1),
                _ => {}
            }
            before = (before.1, now.kind);
        }
        found
    }

    fn brace_correction(&self, weighed: &Weighed) -> Correction {
        let Weighed { at, change, .. } = *weighed;
        let diagnostic = match change {
            TokenChange::Insert(TokenKind::RightBrace, _) => {
                self.missing_close(at, weighed.partner)
            }
            TokenChange::Insert(..) => self.missing_open(at),
            _ => return self.correction(at, change, None, super::correction::Confidence::Likely),
        };
        Correction {
            at: self.original(at),
            change,
            diagnostic,
        }
    }

    fn missing_open(&self, at: usize) -> Diagnostic {
        let before = self.token(at.saturating_sub(1)).span;
        let between = Span::new(before.end, self.token(at).span.start);
        let empty = self.empty_lines(between);
        let (place, edit) = match empty.first().filter(|_| self.braces_start_lines()) {
            Some(&line) => {
                let blanks = self.blanks_before_line(at.saturating_sub(1));
                (line, Edit::replace(line, format!("{blanks}{{")))
            }
            None if self.is_blank(between) => (between, Edit::insert(before.end, " {")),
            None => (
                self.rest_of_line(before.end),
                Edit::insert(before.end, " {"),
            ),
        };
        Diagnostic::error(error::UNCLOSED_DELIMITER, place, "missing `{`")
            .about(Subject::Brace)
            .mark("expected `{` here")
            .fix(Fix::suggestion("add `{`", vec![edit]))
    }

    /// Whether most `{` are at the start of a line.
    fn braces_start_lines(&self) -> bool {
        let is_open = |&at: &usize| self.token(at).kind == TokenKind::LeftBrace;
        let (mut alone, mut all) = (0, 0);
        for at in (0..self.tokens.len()).filter(is_open).take(MAX_BRACES) {
            all += 1;
            alone += usize::from(self.starts_line(at));
        }
        2 * alone > all
    }

    fn missing_close(&self, at: usize, partner: Option<usize>) -> Diagnostic {
        let blanks = partner.map_or("", |open| self.blanks_before_line(open));
        let (place, edit) = self.place_of_close(at, blanks);
        let d = Diagnostic::error(error::UNCLOSED_DELIMITER, place, "missing `}`")
            .about(Subject::MissingClose)
            .mark("expected `}` here")
            .fix(Fix::suggestion("add `}`", vec![edit]));
        match partner {
            Some(open) => d.label(self.token(open).span, "unclosed `{`"),
            None => d,
        }
    }

    /// Where to insert a `}` before a token: on an empty line before it, or after the preceding
    /// code.
    fn place_of_close(&self, at: usize, blanks: &str) -> (Span, Edit) {
        let before = self.token(at.saturating_sub(1)).span;
        let next = self.token(at);
        let between = self.up_to(before.end, next.span.start);
        let text = self.sources.text(between);
        let lines: Vec<&str> = text.split('\n').collect();
        if lines.len() < 2 {
            let is_same_line = next.kind != TokenKind::End;
            let text = if is_same_line { " } " } else { "\n}" };
            let place = if self.is_blank(between) {
                between
            } else {
                before.after()
            };
            return (place, Edit::insert(before.end, text));
        }
        let empty = self.empty_lines(between);
        let goes_on = matches!(next.kind, TokenKind::Else | TokenKind::Semicolon);
        let empty = if goes_on { empty.last() } else { empty.first() };
        if let Some(&place) = empty {
            return (place, Edit::replace(place, format!("{blanks}}}")));
        }
        if goes_on {
            let blank = lines.last().map_or(0, |l| l.len()) as u32;
            let place = Span::new(next.span.start - blank, next.span.start);
            return (place, Edit::insert(next.span.start, "} "));
        }
        let place = self.rest_of_line(before.end);
        let first = lines.first().map_or("", |l| l.trim_end_matches('\r'));
        let end = before.end + first.len() as u32;
        (place, Edit::insert(end, format!("\n{blanks}}}")))
    }

    /// The text from an address to the next token, or to the end of the file.
    fn up_to(&self, from: u32, next: u32) -> Span {
        let file = self.sources.file_at(from);
        let end = file.map_or(from, |f| f.span().end);
        let is_inside = from <= next && next <= end;
        Span::new(from, if is_inside { next } else { end.max(from) })
    }

    /// The whitespace-only lines in a span.
    fn empty_lines(&self, between: Span) -> Vec<Span> {
        let lines: Vec<&str> = self.sources.text(between).split('\n').collect();
        let mut start = between.start;
        let mut empty = Vec::new();
        for (number, line) in lines.iter().enumerate() {
            let is_inner = number > 0 && number + 1 < lines.len();
            if is_inner && line.trim().is_empty() {
                let len = line.trim_end_matches('\r').len() as u32;
                empty.push(Span::new(start, start + len));
            }
            start += line.len() as u32 + 1;
        }
        empty
    }

    /// The spaces and tabs from an address on.
    fn rest_of_line(&self, from: u32) -> Span {
        let file = self.sources.file_at(from);
        let text = file.and_then(|f| f.text.get((from - f.base) as usize..));
        let is_blank = |c: &char| matches!(c, ' ' | '\t');
        let blanks = text.unwrap_or("").chars().take_while(is_blank).count();
        Span::new(from, from + blanks as u32)
    }
}

/// Number of lines in `laid` whose indentation contradicts an edit of one brace, and the brace that
/// an inserted `}` closes.
fn indentation_mismatches(
    laid: &[Laid],
    index: usize,
    change: TokenChange,
) -> (usize, Option<usize>) {
    let mut layout = BraceLayout::default();
    for (i, token) in laid.iter().enumerate() {
        if i == index
            && let TokenChange::Insert(kind, _) = change
        {
            layout.read(Laid {
                kind,
                is_put_in: true,
                starts_line: false,
                ..*token
            });
        }
        match change {
            TokenChange::Delete if i == index => {}
            TokenChange::Replace(kind) if i == index => layout.read(Laid { kind, ..*token }),
            _ => layout.read(*token),
        }
    }
    if index >= laid.len() {
        layout.partner = layout.open.last().map(|b| b.at);
    }
    (layout.indentation_mismatches, layout.partner)
}

#[derive(Clone, Copy)]
struct UnclosedBlock {
    /// Index of its `{`.
    at: usize,
    line: usize,
    /// Indentation of the line where its header starts.
    outer: usize,
    /// Indentation of its first statement at the start of a line.
    inner: Option<usize>,
}

/// Compares braces with the indentation of the lines.
#[derive(Default)]
struct BraceLayout {
    open: Vec<UnclosedBlock>,
    /// Indentation of the line where the current statement starts.
    head: usize,
    parens: u32,
    before: Option<TokenKind>,
    indentation_mismatches: usize,
    partner: Option<usize>,
}

impl BraceLayout {
    fn read(&mut self, token: Laid) {
        use TokenKind as T;
        let starts_statement = matches!(
            self.before,
            None | Some(T::Semicolon | T::LeftBrace | T::RightBrace)
        ) && self.parens == 0;
        if starts_statement && token.kind != T::LeftBrace {
            self.head = token.indent;
        }
        match token.kind {
            T::RightBrace => self.close(token),
            T::LeftBrace => {
                if token.starts_line && starts_statement {
                    self.line(token, starts_statement);
                }
                let outer = if token.starts_line {
                    token.indent
                } else {
                    self.head
                };
                self.open.push(UnclosedBlock {
                    at: token.at,
                    line: token.line,
                    outer,
                    inner: None,
                });
                self.parens = 0;
            }
            _ => {
                if token.starts_line {
                    self.line(token, starts_statement);
                }
                match token.kind {
                    T::LeftParen => self.parens += 1,
                    T::RightParen => self.parens = self.parens.saturating_sub(1),
                    _ => {}
                }
            }
        }
        self.before = Some(token.kind);
    }

    /// Lines inside a block are indented more than the block, and its statements have equal
    /// indentation.
    fn line(&mut self, token: Laid, starts_statement: bool) {
        let is_label = matches!(token.kind, TokenKind::Case | TokenKind::Default);
        let Some(block) = self.open.last_mut() else {
            self.indentation_mismatches += usize::from(starts_statement && token.indent > 0);
            return;
        };
        if token.indent <= block.outer && !is_label {
            self.indentation_mismatches += 1;
        }
        if !starts_statement || is_label {
            return;
        }
        match block.inner {
            None => block.inner = Some(token.indent),
            Some(inner) if inner != token.indent => self.indentation_mismatches += 1,
            Some(_) => {}
        }
    }

    fn close(&mut self, token: Laid) {
        self.parens = 0;
        let Some(block) = self.open.pop() else {
            self.indentation_mismatches += 2;
            return;
        };
        self.head = token.indent;
        if token.is_put_in {
            self.partner = Some(block.at);
        } else if token.indent != block.outer && token.line != block.line {
            self.indentation_mismatches += if token.starts_line { 2 } else { 1 };
        }
    }
}

/// The open parentheses and square brackets of a statement.
#[derive(Default)]
struct OpenBrackets(Vec<TokenKind>);

impl OpenBrackets {
    fn read(&mut self, kind: TokenKind) {
        use TokenKind as T;
        match kind {
            T::LeftParen => self.0.push(T::RightParen),
            T::LeftBracket => self.0.push(T::RightBracket),
            T::RightParen | T::RightBracket => {
                self.0.pop();
            }
            T::LeftBrace | T::RightBrace => self.0.clear(),
            _ => {}
        }
    }

    /// The token that closes the innermost bracket.
    fn close(&self) -> Option<TokenKind> {
        self.0.last().copied()
    }
}
