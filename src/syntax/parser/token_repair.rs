//! Error recovery inside one statement or declaration: tries every one-token edit before the point
//! where parsing fails and keeps the edits that let the parser get furthest.

use super::correction::{Choice, Confidence, TokenChange, VALUE_TYPES, change_tokens};
use super::{ParseOptions, Parser};
use crate::set::{self, TokenSet};
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::Diagnostic;

/// Number of tokens parsed after the part that must parse.
const LOOKAHEAD: usize = 20;
/// Longest remainder of a statement that must parse, in tokens.
const MAX_REST: usize = 300;
/// Number of tokens after the error that must parse.
const MUST_FIT: usize = 8;
/// Number of tokens before the error at which edits are tried.
const WINDOW: usize = 120;
/// Longest start of a statement that is parsed again for each candidate, in tokens.
const MAX_HEAD: usize = 600;
/// Number of further corrections that the rest of a statement may need.
const MORE_FAULTS: usize = 2;
/// Maximum number of edits whose further corrections are searched.
const MAX_PARTIAL: usize = 4;
/// Maximum number of corrections per shader.
const MAX_CORRECTIONS: usize = 20;
/// Maximum number of alternatives at one place that the checker compares.
const MAX_ALTERNATIVES: usize = 16;
/// Maximum cost difference to the best candidate for an alternative to be kept.
const MARGIN: u32 = 3;

/// GlContext of the code that cannot be parsed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum FaultScope {
    Global,
    Block,
    /// The single statement that is the body of an `if` or loop.
    Body,
}

/// How far a trial parse must get.
#[derive(Clone, Copy)]
struct ReadGoal {
    /// Index of the last token that must parse.
    goal: usize,
    /// Whether the trial input ends before the shader does.
    is_cut: bool,
}

/// An edit and its cost; lower is more plausible.
#[derive(Clone, Copy)]
struct ChangeCandidate {
    at: usize,
    change: TokenChange,
    cost: u32,
}

impl ChangeCandidate {
    /// Whether it inserts a closing bracket, so that another token may be missing at the same place.
    fn closes(&self) -> bool {
        use TokenKind as T;
        matches!(
            self.change,
            TokenChange::Insert(T::RightParen | T::RightBracket, _)
        )
    }
}

impl<'a> Parser<'a> {
    /// A parser over other tokens that performs no error recovery itself.
    pub(super) fn speculative(&self, tokens: Vec<Token>) -> Parser<'a> {
        let options = ParseOptions {
            version: self.version,
            is_fragment: self.is_fragment,
        };
        let end = tokens.last().copied().unwrap_or(self.end);
        Parser {
            end,
            structs: None,
            ..Parser::new(self.sources, self.all, self.names, options, tokens)
        }
    }

    /// Tries to correct the code that could not be parsed since `start`; returns whether it did, so
    /// that parsing resumes at `start`. `reported` is the error reported without a correction.
    pub(super) fn repair_token(
        &mut self,
        start: usize,
        scope: FaultScope,
        reported: Option<Diagnostic>,
    ) -> bool {
        if self.repairs.search.is_over() {
            return false;
        }
        let Some(fault) = self.fault.take() else {
            return false;
        };
        // Parsing must have passed the point of the last correction.
        let is_stuck = self.repairs.reached.is_some_and(|reached| fault <= reached);
        let is_long = fault.saturating_sub(start) > MAX_HEAD;
        if is_stuck || is_long || self.repairs.choices.len() >= MAX_CORRECTIONS {
            return false;
        }
        let found = self.plausible(start, fault, scope);
        let Some(best) = found.first() else {
            return false;
        };
        let certainty = match found.as_slice() {
            [one] if one.cost == 0 => Confidence::Sure,
            _ => Confidence::Likely,
        };
        let (at, change) = (best.at, best.change);
        let choice: Choice = found
            .iter()
            .map(|c| self.correction(c.at, c.change, reported.as_ref(), certainty))
            .collect();
        self.repairs.choices.push(choice);
        self.apply(at, change);
        self.repairs.reached = match change {
            TokenChange::Insert(..) => Some(fault),
            TokenChange::Delete => fault.checked_sub(1),
            TokenChange::Replace(_) => Some(fault),
        };
        true
    }

    /// The edits with which the code from `start` on parses past `fault`, if need be with further edits
    /// after it.
    fn plausible(&mut self, start: usize, fault: usize, scope: FaultScope) -> Vec<ChangeCandidate> {
        let mut found = self.edits_at((start, fault), scope, MORE_FAULTS, usize::MAX);
        found.sort_by_key(|c| c.cost);
        let best = found.first().map_or(0, |c| c.cost);
        found.retain(|c| c.cost <= best + MARGIN);
        found.truncate(MAX_ALTERNATIVES);
        found
    }

    /// At most `enough` edits with which the code from `start` on parses past `fault`, if need be with
    /// `more` edits after it.
    fn edits_at(
        &mut self,
        (start, fault): (usize, usize),
        scope: FaultScope,
        more: usize,
        enough: usize,
    ) -> Vec<ChangeCandidate> {
        let last = self.tokens.len().saturating_sub(1);
        let goal = self.after_statement(fault).max(fault + MUST_FIT);
        let end = last.min(goal + LOOKAHEAD);
        let reach = ReadGoal {
            goal: goal - start,
            is_cut: end < last,
        };
        let code = self.tokens.get(start..end).unwrap_or(&[]).to_vec();
        let mut found = Vec::new();
        let mut partial = Vec::new();
        for candidate in self.candidates(start, fault, scope) {
            if !self.repairs.search.pays(code.len()) {
                self.repairs.search.give_up();
                break;
            }
            let mut parser = self.edited(&code, start, candidate);
            if parser.reads_past(reach, scope) {
                found.push(candidate);
                if found.len() >= enough {
                    break;
                }
            } else if let Some(next) = parser.fault
                && start + next > fault + usize::from(!candidate.closes())
                && self.is_usual(candidate)
            {
                partial.push((candidate, next));
            }
        }
        // What follows a text that was cut is unknown; candidates end with a part of the text.
        let is_cut = self.structs.is_some() && self.token(fault).kind == TokenKind::End;
        if found.is_empty() && more > 0 && !is_cut {
            found = self.first_of_several((&code, start), partial, scope, more - 1);
        }
        found
    }

    /// Whether an edit is probable enough to be one of several: only brackets and separators are often
    /// superfluous, and a word before another is rarely an array.
    fn is_usual(&self, candidate: ChangeCandidate) -> bool {
        match candidate.change {
            TokenChange::Delete => set::SEPARATES.contains(self.token(candidate.at).kind),
            TokenChange::Insert(kind, _) => kind != TokenKind::LeftBracket,
            TokenChange::Replace(_) => true,
        }
    }

    /// A parser of the code that starts at `start`, with an edit.
    fn edited(&self, code: &[Token], start: usize, candidate: ChangeCandidate) -> Parser<'a> {
        let mut tokens = code.to_vec();
        change_tokens(&mut tokens, candidate.at - start, candidate.change);
        tokens.push(Token {
            kind: TokenKind::End,
            ..self.end
        });
        self.speculative(tokens)
    }

    /// Of edits after which parsing fails again, at the index given, those that need the fewest
    /// corrections there.
    fn first_of_several(
        &mut self,
        (code, start): (&[Token], usize),
        mut partial: Vec<(ChangeCandidate, usize)>,
        scope: FaultScope,
        more: usize,
    ) -> Vec<ChangeCandidate> {
        partial.sort_by_key(|(candidate, _)| candidate.cost);
        partial.truncate(MAX_PARTIAL);
        let mut found = Vec::new();
        for more in 0..=more {
            for &(candidate, next) in &partial {
                let mut rest = self.edited(code, start, candidate);
                std::mem::swap(&mut rest.repairs.search, &mut self.repairs.search);
                if !rest.edits_at((0, next), scope, more, 1).is_empty() {
                    found.push(candidate);
                }
                std::mem::swap(&mut rest.repairs.search, &mut self.repairs.search);
            }
            if !found.is_empty() {
                break;
            }
        }
        found
    }

    /// The end of the statement or header that contains the token at `fault`.
    fn after_statement(&self, fault: usize) -> usize {
        let ends = |&at: &usize| {
            use TokenKind as T;
            matches!(
                self.token(at).kind,
                T::Semicolon | T::LeftBrace | T::RightBrace
            )
        };
        let found = (fault + 1..fault + MAX_REST).find(ends);
        found.map_or(fault, |at| at + 1)
    }

    /// Whether everything up to the goal, or to the end of the block, parses.
    fn reads_past(&mut self, reach: ReadGoal, scope: FaultScope) -> bool {
        let ReadGoal { goal, is_cut } = reach;
        while !self.is(TokenKind::End) && self.at <= goal {
            let ends = match scope {
                FaultScope::Global => false,
                FaultScope::Block => self.is(TokenKind::RightBrace),
                FaultScope::Body => matches!(self.peek(), TokenKind::RightBrace | TokenKind::Else),
            };
            if ends {
                return self.at > 0;
            }
            match scope {
                FaultScope::Block | FaultScope::Body => {
                    self.statement_or_error();
                }
                FaultScope::Global => self.item_or_error(),
            }
            if let Some(fault) = self.fault {
                return fault > goal || is_cut && fault + 1 >= self.tokens.len();
            }
        }
        true
    }

    /// The one-token edits to try between `start` and `fault`.
    fn candidates(&self, start: usize, fault: usize, scope: FaultScope) -> Vec<ChangeCandidate> {
        let mut around = ChangeCollector::of(self, start, fault, scope);
        for at in (start.max(fault.saturating_sub(WINDOW))..=fault).rev() {
            if !self.is_user(at) {
                break;
            }
            let (before, next) = (self.token(at.saturating_sub(1)), self.token(at));
            let is_first = at == start;
            if next.is_direct() || (!is_first && before.is_direct()) {
                around.insertions(at);
            }
            if next.is_direct() && !next.span.is_empty() && next.kind != TokenKind::End {
                around.removals(at);
                around.exchanges(at);
            }
        }
        around.found
    }
}

/// Collects the edits worth trying.
struct ChangeCollector<'p, 'a> {
    parser: &'p Parser<'a>,
    start: usize,
    fault: usize,
    /// For every token from `start` on, the brackets open before it.
    open: Vec<Vec<TokenKind>>,
    scope: FaultScope,
    found: Vec<ChangeCandidate>,
}

impl<'p, 'a> ChangeCollector<'p, 'a> {
    fn of(
        parser: &'p Parser<'a>,
        start: usize,
        fault: usize,
        scope: FaultScope,
    ) -> ChangeCollector<'p, 'a> {
        let mut open = Vec::new();
        let mut now: Vec<TokenKind> = Vec::new();
        for at in start..=fault {
            open.push(now.iter().rev().take(2).copied().collect());
            match parser.token(at).kind {
                kind @ (TokenKind::LeftParen | TokenKind::LeftBracket) => now.push(kind),
                TokenKind::RightParen | TokenKind::RightBracket => {
                    now.pop();
                }
                TokenKind::LeftBrace => now.clear(),
                _ => {}
            }
        }
        ChangeCollector {
            parser,
            start,
            fault,
            open,
            scope,
            found: Vec::new(),
        }
    }

    fn kind(&self, at: usize) -> TokenKind {
        self.parser.token(at).kind
    }

    /// The innermost bracket open before a token.
    fn bracket(&self, at: usize) -> Option<TokenKind> {
        self.open.get(at - self.start)?.first().copied()
    }

    fn add(&mut self, at: usize, change: TokenChange, cost: u32) {
        self.found.push(ChangeCandidate { at, change, cost });
    }

    fn insert(&mut self, at: usize, kind: TokenKind, cost: u32) {
        self.add(at, TokenChange::Insert(kind, 0), cost);
    }

    fn insertions(&mut self, at: usize) {
        use TokenKind as T;
        let next = self.kind(at);
        let before = match at > self.start {
            true => self.kind(at - 1),
            false => T::End,
        };
        let is_last = at == self.fault;
        let starts_line = self.parser.starts_line(at);
        let bracket = self.bracket(at);
        if ends_operand(before) || before == T::RightBrace {
            match (is_last, starts_line) {
                (true, true) => self.insert(at, T::Semicolon, 0),
                (true, false) => self.insert(at, T::Semicolon, 3),
                (false, true) => self.insert(at, T::Semicolon, 1),
                (false, false) if before == T::RightBrace => self.insert(at, T::Semicolon, 1),
                _ => {}
            }
        }
        if ends_operand(before) || before == T::LeftParen {
            let cost = if is_last { 0 } else { 1 };
            match bracket {
                // Adding one more of several closing parentheses is the same edit wherever it is
                // placed.
                Some(T::LeftParen) if next == T::RightParen && !is_last => {}
                Some(T::LeftParen) => self.insert(at, T::RightParen, cost),
                Some(_) => self.insert(at, T::RightBracket, cost),
                None => {}
            }
        }
        if starts_operand(next) || matches!(next, T::RightParen | T::RightBracket) {
            self.openings(at, before);
        }
        if is_last {
            self.separators(at, before, next);
        }
        self.types(at, before, next);
    }

    /// Candidates for a missing `(` or `[`.
    fn openings(&mut self, at: usize, before: TokenKind) {
        use TokenKind as T;
        let is_head = set::HEADS.contains(before);
        let is_callee = matches!(before, T::Identifier | T::Type);
        let closes = matches!(
            self.kind(self.fault),
            T::RightParen | T::RightBracket | T::Comma | T::Semicolon | T::LeftBrace
        );
        // `f((` is less likely than an extra `)`.
        let doubles = is_callee && self.kind(at) == T::LeftParen;
        if (is_head || is_callee) && !doubles {
            self.insert(at, T::LeftParen, 0);
        } else if closes {
            self.insert(at, T::LeftParen, 3);
        }
        if is_callee {
            self.insert(at, T::LeftBracket, 1);
        }
    }

    /// Candidates for a missing token between two operands.
    fn separators(&mut self, at: usize, before: TokenKind, next: TokenKind) {
        use TokenKind as T;
        let starts_type = next == T::Type || set::QUALIFIES_PARAMETER.contains(next);
        if !ends_operand(before) && before != T::RightBrace {
            return;
        }
        let in_brackets = self.bracket(at).is_some();
        if starts_operand(next) || starts_type {
            self.insert(at, T::Comma, if in_brackets { 1 } else { 4 });
        }
        let is_declaration = matches!(self.kind(self.start), T::Type | T::Const);
        let is_loop = self.kind(self.start) == T::For;
        if starts_operand(next) && (!in_brackets || is_loop) && self.scope_allows_assignment() {
            self.insert(at, T::Equal, if is_declaration { 1 } else { 2 });
        }
        if starts_operand(next) && ends_operand(before) {
            self.insert(at, T::Star, 2);
            self.insert(at, T::Plus, 3);
            if next == T::Identifier {
                self.insert(at, T::Dot, 3);
            }
        }
        let has_question = (self.start..at).any(|i| self.kind(i) == T::Question);
        let is_label = matches!(self.kind(self.start), T::Case | T::Default);
        if has_question || is_label {
            self.insert(at, T::Colon, 1);
        }
    }

    /// Whether there is no assignment before the error.
    fn scope_allows_assignment(&self) -> bool {
        (self.start..self.fault).all(|i| self.kind(i) != TokenKind::Equal)
    }

    /// Candidates for a missing type.
    fn types(&mut self, at: usize, before: TokenKind, next: TokenKind) {
        use TokenKind as T;
        let names_function = next == T::Identifier && self.kind(at + 1) == T::LeftParen;
        let names_parameter = next == T::Identifier
            && self.bracket(at) == Some(T::LeftParen)
            && matches!(self.kind(at + 1), T::Comma | T::RightParen);
        if self.scope != FaultScope::Global || at != self.fault || before == T::Type {
            return;
        }
        match (names_function, names_parameter) {
            (true, _) => self.insert(at, T::Void, 1),
            (_, true) => {}
            _ => return,
        }
        for word in VALUE_TYPES {
            self.add(at, TokenChange::Insert(T::Type, word as u32), 2);
        }
    }

    fn removals(&mut self, at: usize) {
        let distance = self.fault - at;
        let is_bracket = matches!(self.kind(at), TokenKind::LeftParen | TokenKind::RightParen);
        // Removing any one of several adjacent brackets has the same effect.
        if is_bracket && distance > 0 && self.kind(at + 1) == self.kind(at) {
            return;
        }
        let ends_before = distance == 1 && self.kind(at) == TokenKind::Semicolon;
        let cost = match (set::PUNCTUATION.contains(self.kind(at)), distance) {
            _ if ends_before => 1,
            (true, 0) => 2,
            (true, _) => 3,
            (false, 0 | 1) => 5,
            _ => return,
        };
        self.add(at, TokenChange::Delete, cost);
    }

    fn exchanges(&mut self, at: usize) {
        use TokenKind as T;
        let bracket = self.bracket(at);
        let is_near = self.fault - at <= 2;
        match self.kind(at) {
            T::Semicolon if bracket.is_some() => self.add(at, TokenChange::Replace(T::Comma), 0),
            T::Comma if is_near || self.kind(self.start) == T::For => {
                self.add(at, TokenChange::Replace(T::Semicolon), 1);
                if (self.start..at).any(|i| self.kind(i) == T::Question) {
                    self.add(at, TokenChange::Replace(T::Colon), 1);
                }
            }
            T::Colon if is_near => {
                self.add(at, TokenChange::Replace(T::Semicolon), 2);
                self.add(at, TokenChange::Replace(T::Comma), 2);
            }
            T::Dot if is_near => self.add(at, TokenChange::Replace(T::Comma), 2),
            T::RightBracket if bracket != Some(T::LeftBracket) => {
                self.add(at, TokenChange::Replace(T::RightParen), 1);
            }
            T::RightParen if bracket == Some(T::LeftBracket) => {
                self.add(at, TokenChange::Replace(T::RightBracket), 1);
            }
            T::LeftBrace if bracket.is_some() || is_near => {
                self.add(at, TokenChange::Replace(T::LeftParen), 3);
            }
            T::LeftBracket => self.add(at, TokenChange::Replace(T::LeftParen), 2),
            T::LeftParen => self.add(at, TokenChange::Replace(T::LeftBracket), 2),
            T::EqualEqual => self.add(at, TokenChange::Replace(T::Equal), 1),
            T::Identifier if is_near || at == self.start => {
                if let Some(keyword) = self.parser.keyword_like(at) {
                    self.add(at, TokenChange::Replace(keyword), 0);
                }
            }
            _ => {}
        }
    }
}

/// Whether an operand can end with such a token, including an invalid one.
fn ends_operand(kind: TokenKind) -> bool {
    use TokenKind as T;
    const FAULTY: TokenSet =
        set::ENDS_OPERAND.and(&[T::Reserved, T::Increment, T::Decrement, T::Bad]);
    FAULTY.contains(kind)
}

/// Whether an operand can start with such a token, including an invalid one.
fn starts_operand(kind: TokenKind) -> bool {
    const FAULTY: TokenSet = set::STARTS_OPERAND.and(&[TokenKind::Reserved, TokenKind::Bad]);
    FAULTY.contains(kind)
}

#[cfg(test)]
mod tests {
    use crate::{ParseOptions, Search, Version, parse, preprocess};
    use shaderlint_text::{Role, Sources, apply_edits};

    /// Checks the only message reported for a text and the text after applying the fixes.
    fn check(text: &str, message: &str, repaired: &str) {
        let mut sources = Sources::new();
        let prelude = sources.add("", None, Role::Prelude, "#version 300 es\n");
        let files: Vec<_> = prelude
            .into_iter()
            .chain(sources.add("a.frag", None, Role::User, text))
            .collect();
        let mut read = preprocess(&sources, &files, true, crate::GlContext::WEBGL2);
        let language = ParseOptions {
            version: Version::Es300,
            is_fragment: true,
        };
        let found = parse(
            &sources,
            &mut read.tokens,
            &read.names,
            language,
            &mut Search::for_text(),
        )
        .diagnostics;
        let stderr: Vec<&str> = found.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(stderr, [message], "{text}");
        let fixes = found.iter().filter_map(|d| d.fix.as_ref());
        let edits: Vec<_> = fixes.flat_map(|f| f.edits.clone()).collect();
        let base = sources.files().last().map_or(0, |f| f.base);
        let found = apply_edits(text, base, &edits);
        assert_eq!(found.as_deref(), Ok(repaired), "{text}");
    }

    /// Each case is a text, the message and the repaired text.
    #[test]
    fn missing_and_wrong_tokens_are_repaired() {
        let cases = include_str!("repairs.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let parts: Vec<String> = case.split(" ⇒ ").map(|p| p.replace('↵', "\n")).collect();
            check(&parts[0], &parts[1], &parts[2]);
        }
    }
}
