//! Messages about expressions, and about the values that variables get.

pub(super) mod arguments;
mod assign;
mod call;
mod constant;
mod construct;
mod expression;
mod member;
mod operator;
mod place;
mod resize;
