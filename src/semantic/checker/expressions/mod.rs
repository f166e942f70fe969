//! Checks of expressions, and of the values that variables get.

pub(super) mod assign;
mod binary;
pub(super) mod call;
mod construct;
pub(super) mod expression;
mod kept;
pub(super) mod place;
