//! Comparison of code token by token, ignoring blanks and comments.

use shaderlint_semantic::Program;
use shaderlint_syntax::Token;
use shaderlint_syntax::ast::Extent;
use std::hash::{Hash, Hasher};

/// Whether two pieces of code have the same tokens. Two different macros differ, even if they expand to
/// the same code.
pub fn same_code(program: &Program, a: Extent, b: Extent) -> bool {
    let (left, right) = (tokens(program, a), tokens(program, b));
    left.len() == right.len()
        && left
            .iter()
            .zip(right)
            .all(|(x, y)| same_token(program, x, y))
}

/// A hash that is equal for code with the same tokens.
pub fn code_hash(program: &Program, extent: Extent) -> u64 {
    let mut hasher = rustc_hash::FxHasher::default();
    for token in tokens(program, extent) {
        token.kind.hash(&mut hasher);
        token.value.hash(&mut hasher);
    }
    hasher.finish()
}

fn tokens(program: &Program, extent: Extent) -> &[Token] {
    let range = extent.first as usize..=extent.last as usize;
    program.tokens.tokens.get(range).unwrap_or(&[])
}

fn same_token(program: &Program, a: &Token, b: &Token) -> bool {
    if (a.kind, a.value) != (b.kind, b.value) || a.is_direct() != b.is_direct() {
        return false;
    }
    a.is_direct() || program.sources.text(a.span) == program.sources.text(b.span)
}
