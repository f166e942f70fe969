//! Type rules: from the types of operands to the type of the result, or to a type error.
//!
//! Every decision is a function of types only; the messages for a [`TypeMismatch`] are made in `explain`.

mod construct;
mod member;
mod mismatch;
mod operator;
#[cfg(test)]
mod tests;
mod type_context;

pub use construct::{construct, sized};
pub use member::{LENGTH, Member, SWIZZLES, components, element, index, member};
pub use mismatch::{Clash, NonNumber, TypeMismatch};
pub use operator::{assign, binary, choice, compound, condition, returned, sequence, step, unary};
pub use type_context::Types;

use super::types::Type;

/// The common type, if all are equal.
pub fn common(mut types: impl Iterator<Item = Type>) -> Option<Type> {
    let first = types.next()?;
    types.all(|ty| ty == first).then_some(first)
}
