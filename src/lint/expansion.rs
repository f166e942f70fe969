//! Macro calls and the tokens that they expand to.

use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{Extent, TokenId};
use shaderlint_syntax::{Lexer, Token};
use shaderlint_text::Span;

/// A macro call in the text, and its expansion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expanded {
    /// Index of the macro in `tokens.macros`.
    pub definition: usize,
    /// Span of the call in the text.
    pub call: Span,
    /// The tokens that the parser sees instead.
    pub extent: Extent,
}

/// The macro calls in the text itself, in order, each with its tokens; calls that expand to nothing are
/// left out.
pub fn expanded(program: &Program) -> Vec<Expanded> {
    let mut found: Vec<Expanded> = Vec::new();
    for (token, at) in program.tokens.tokens.iter().zip(0..) {
        if token.is_direct() {
            continue;
        }
        let Some(mut next) = call_of(program, token, at) else {
            continue;
        };
        // The tokens of an argument come before the call that it is passed to.
        let is_one = |last: &Expanded| {
            last.extent.last + 1 == at
                && (last.call.contains(next.call) || next.call.contains(last.call))
        };
        if let Some(last) = found.pop_if(|last| is_one(last)) {
            next = Expanded {
                extent: last.extent.to(next.extent),
                ..match last.call.contains(next.call) {
                    true => last,
                    false => next,
                }
            };
        }
        found.push(next);
    }
    found
}

/// The calls of object-like macros in the bodies of other macros, in order.
pub fn expanded_inside(program: &Program) -> Vec<Expanded> {
    let mut found: Vec<(u32, Expanded)> = Vec::new();
    for (token, at) in program.tokens.tokens.iter().zip(0..) {
        let inner = program.tokens.expansions.get(token.expansion as usize);
        let Some(inner) = inner.filter(|e| e.parent != Token::DIRECT) else {
            continue;
        };
        let definition = inner.definition.0 as usize;
        let called = program.tokens.macros.get(definition);
        if called.is_none_or(|m| m.params.is_some()) {
            continue;
        }
        match found.last_mut() {
            Some((expansion, last))
                if *expansion == token.expansion && last.extent.last + 1 == at =>
            {
                last.extent.last = at;
            }
            _ => found.push((
                token.expansion,
                Expanded {
                    definition,
                    call: inner.call,
                    extent: Extent::token(at),
                },
            )),
        }
    }
    found.into_iter().map(|(_, call)| call).collect()
}

/// The call in the text that a token was expanded from, with the token as its extent. For a token of an
/// argument, this is the outermost call in the text.
fn call_of(program: &Program, token: &Token, at: TokenId) -> Option<Expanded> {
    let all = &program.tokens.expansions;
    let mut expansion = all.get(token.expansion as usize)?;
    while let Some(outer) = all.get(expansion.parent as usize) {
        expansion = outer;
    }
    Some(Expanded {
        definition: expansion.definition.0 as usize,
        call: expansion.call,
        extent: Extent::token(at),
    })
}

/// The text of a token where it was spelled.
pub fn spelling<'p>(program: &'p Program, token: &Token) -> &'p str {
    let text = || {
        let code = program.sources.code_at(token.spelled)?;
        let rest = code.text.get((token.spelled - code.base) as usize..)?;
        let found = Lexer::new(rest, 0).next_token();
        rest.get(..found.span.end as usize)
    };
    text().unwrap_or("")
}
