//! Which tokens of a shader a macro call gave.

use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{Extent, TokenId};
use shaderlint_syntax::{Lexer, Token};
use shaderlint_text::Span;

/// A macro call in the text, and what came of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expanded {
    /// The number of the macro among those of the shader.
    pub definition: usize,
    /// The call, as it is written.
    pub call: Span,
    /// The tokens that the parser sees in its place.
    pub extent: Extent,
}

/// The macro calls that stand in the text itself, in order, each with its tokens; a call that gave
/// nothing is none of them.
pub fn expanded(program: &Program) -> Vec<Expanded> {
    let mut found: Vec<Expanded> = Vec::new();
    for (token, at) in program.tokens.tokens.iter().zip(0..) {
        if token.is_direct() {
            continue;
        }
        let Some(mut next) = call_of(program, token, at) else {
            continue;
        };
        // What comes out of an argument is seen before the call that it was given to.
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

/// The calls of macros without parameters that stand in the text of other macros, in order.
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

/// The call in the text that a token came through, as one that gave it alone. Where it came out of an
/// argument, that is the outermost of all calls that stand in the text.
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

/// How a token is written where it was spelled.
pub fn spelling<'p>(program: &'p Program, token: &Token) -> &'p str {
    let text = || {
        let code = program.sources.code_at(token.spelled)?;
        let rest = code.text.get((token.spelled - code.base) as usize..)?;
        let found = Lexer::new(rest, 0).next_token();
        rest.get(..found.span.end as usize)
    };
    text().unwrap_or("")
}
