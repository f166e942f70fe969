//! String literals of a script that are concatenated: with `+`, with `.concat(...)`, or as elements
//! of an array that is joined.

use super::token::{ScriptToken, ScriptTokenKind, is_literal, is_mark, skip_comments};
use std::ops::Range;

/// Concatenated literals.
pub struct Chain {
    /// Indices of the literals.
    pub parts: Vec<usize>,
    /// Expressions between them: the tokens of each, and the index of the previous literal.
    pub others: Vec<(usize, Range<usize>)>,
    /// Index of the last token that belongs to the chain.
    pub last: usize,
    /// Whether a line break separates the literals: `[...].join('\n')`.
    pub has_lines: bool,
    /// Whether other text precedes or follows.
    pub goes_on: bool,
}

impl Chain {
    fn new(first: usize) -> Chain {
        Chain {
            parts: vec![first],
            others: Vec::new(),
            last: first,
            has_lines: false,
            goes_on: false,
        }
    }

    /// Appends a literal after other expressions.
    fn add(&mut self, others: Range<usize>, literal: usize) {
        if !others.is_empty() {
            let before = self.parts.last().copied().unwrap_or(literal);
            self.others.push((before, others));
        }
        self.parts.push(literal);
        self.last = literal;
    }

    /// The chain that starts with the literal at `first`.
    pub fn of(text: &str, tokens: &[ScriptToken], first: usize) -> Chain {
        let before = first.checked_sub(1);
        let starts_array = before.is_some_and(|b| is_mark(tokens, b, b'['));
        let joined = starts_array.then(|| joined(text, tokens, first)).flatten();
        joined.unwrap_or_else(|| added(text, tokens, first))
    }
}

/// `"..." + x + "..."`, `"...".concat(x, "...")`
fn added(text: &str, tokens: &[ScriptToken], first: usize) -> Chain {
    let mut chain = Chain::new(first);
    let before = tokens.get(..first).unwrap_or(&[]).iter().rev();
    let mut before = before.skip_while(|t| t.kind == ScriptTokenKind::Comment);
    chain.goes_on = before
        .next()
        .is_some_and(|t| t.kind == ScriptTokenKind::Mark(b'+'));
    loop {
        let sign = skip_comments(tokens, chain.last + 1);
        if is_mark(tokens, sign, b'.') {
            if !concat(text, tokens, sign, &mut chain) {
                return chain;
            }
            continue;
        }
        if !is_mark(tokens, sign, b'+') {
            return chain;
        }
        let next = skip_comments(tokens, sign + 1);
        if tokens.get(next).is_some_and(is_literal) {
            chain.add(0..0, next);
            continue;
        }
        let Some(after) = after_operand(tokens, next) else {
            chain.goes_on = true;
            return chain;
        };
        chain.add(next..after, after);
    }
}

/// Continues with the arguments of `.concat(...)`. Returns whether the last is a literal, after
/// which the chain may continue.
fn concat(text: &str, tokens: &[ScriptToken], dot: usize, chain: &mut Chain) -> bool {
    let name = tokens.get(dot + 1).map_or(0..0, |t| t.range.clone());
    if text.get(name) != Some("concat") || !is_mark(tokens, dot + 2, b'(') {
        return false;
    }
    let mut from = dot + 3;
    let mut others = from..from;
    loop {
        let at = skip_comments(tokens, from);
        let end = argument_end(tokens, at);
        let is_complete = end == skip_comments(tokens, at + 1);
        if tokens.get(at).is_some_and(is_literal) && is_complete {
            let between = if others.end > others.start {
                others.clone()
            } else {
                0..0
            };
            chain.add(between, at);
            others = end + 1..end + 1;
        } else {
            others.end = end;
        }
        if !is_mark(tokens, end, b',') {
            chain.goes_on |= !others.is_empty();
            if is_mark(tokens, end, b')') && others.is_empty() {
                chain.last = end;
                return true;
            }
            return false;
        }
        from = end + 1;
    }
}

/// The mark that ends an argument or an element, or the end of the tokens.
fn argument_end(tokens: &[ScriptToken], mut at: usize) -> usize {
    let mut depth = 0_u32;
    while let Some(token) = tokens.get(at) {
        match token.kind {
            ScriptTokenKind::Mark(b'(' | b'[' | b'{') => depth += 1,
            ScriptTokenKind::Mark(b')' | b']' | b'}') if depth == 0 => return at,
            ScriptTokenKind::Mark(b')' | b']' | b'}') => depth -= 1,
            ScriptTokenKind::Mark(b',' | b';') if depth == 0 => return at,
            _ => {}
        }
        at += 1;
    }
    at
}

/// The literal after another operand: `+ (x) + "..."`.
fn after_operand(tokens: &[ScriptToken], mut at: usize) -> Option<usize> {
    /// Maximum length of this operand in tokens.
    const MAX_OPERAND: usize = 64;
    let mut depth = 0_u32;
    for _ in 0..MAX_OPERAND {
        match tokens.get(at)?.kind {
            ScriptTokenKind::Mark(b'(' | b'[') => depth += 1,
            ScriptTokenKind::Mark(b')' | b']') => depth = depth.checked_sub(1)?,
            ScriptTokenKind::Mark(b'+') if depth == 0 => {
                let next = skip_comments(tokens, at + 1);
                if is_literal(tokens.get(next)?) {
                    return Some(next);
                }
            }
            ScriptTokenKind::Mark(b';' | b',' | b'{' | b'}') if depth == 0 => return None,
            _ => {}
        }
        at += 1;
    }
    None
}

/// `["...", x, "..."].join("\n")`
fn joined(text: &str, tokens: &[ScriptToken], first: usize) -> Option<Chain> {
    let mut chain = Chain::new(first);
    let mut at = first;
    let mut from = first;
    loop {
        let end = argument_end(tokens, at);
        let is_complete = end == skip_comments(tokens, at + 1);
        if at > first && tokens.get(at).is_some_and(is_literal) && is_complete {
            let others = if from < at { from..at } else { 0..0 };
            chain.add(others, at);
            from = end + 1;
        } else if at == first {
            // The first element may be a chain itself.
            if !is_complete {
                return None;
            }
            from = end + 1;
        }
        if !is_mark(tokens, end, b',') {
            at = end;
            break;
        }
        at = skip_comments(tokens, end + 1);
        if at == from || from > at {
            from = at;
        }
    }
    let word = |at: usize| {
        let range = tokens.get(at).map_or(0..0, |t| t.range.clone());
        text.get(range).unwrap_or("")
    };
    chain.goes_on = from < at;
    let is_list = is_mark(tokens, at, b']');
    // `filter(Boolean)` only removes empty elements.
    if is_mark(tokens, at + 1, b'.') && word(at + 2) == "filter" && is_mark(tokens, at + 3, b'(') {
        at = argument_end(tokens, at + 4);
    }
    let is_join = is_list
        && is_mark(tokens, at + 1, b'.')
        && word(at + 2) == "join"
        && is_mark(tokens, at + 3, b'(')
        && tokens.get(at + 4).is_some_and(is_literal);
    chain.last = at + 4;
    let separator = word(at + 4);
    chain.has_lines = separator.contains("\\n") || separator.contains('\n');
    is_join.then_some(chain)
}
