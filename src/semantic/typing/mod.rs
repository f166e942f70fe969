//! Typing: from the types of operands to the type of a result, or to what does not fit.
//!
//! Nothing here knows of places or words. Every decision is a function of types; what is said of a
//! [`Misfit`] is made in `explain`.

mod construct;
mod meaning;
mod member;
mod misfit;
mod operator;
#[cfg(test)]
mod tests;

pub use construct::{construct, sized};
pub use meaning::Types;
pub use member::{LENGTH, Member, SWIZZLES, components, element, index, member};
pub use misfit::{Clash, Misfit, NonNumber};
pub use operator::{assign, binary, choice, compound, condition, returned, sequence, step, unary};

use super::types::Type;

/// The type that is common to some, if it is.
pub fn common(mut types: impl Iterator<Item = Type>) -> Option<Type> {
    let first = types.next()?;
    types.all(|ty| ty == first).then_some(first)
}
