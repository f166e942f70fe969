//! Sets of kinds of tokens: what may start, end or follow a part of the grammar.

use super::token::TokenKind;

/// A set of kinds of tokens, one bit for each.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TokenSet(u128);

// The last kind has the highest number.
const _: () = assert!((TokenKind::XorEqual as u32) < u128::BITS);

impl TokenSet {
    /// The set of some kinds.
    pub const fn of(kinds: &[TokenKind]) -> TokenSet {
        let mut bits = 0;
        let mut rest = kinds;
        while let [first, behind @ ..] = rest {
            bits |= 1 << (*first as u32);
            rest = behind;
        }
        TokenSet(bits)
    }

    /// This set and some more kinds.
    pub const fn and(self, kinds: &[TokenKind]) -> TokenSet {
        self.or(TokenSet::of(kinds))
    }

    /// What is in one of two sets.
    pub const fn or(self, other: TokenSet) -> TokenSet {
        TokenSet(self.0 | other.0)
    }

    /// This set without some kinds.
    pub const fn without(self, kinds: &[TokenKind]) -> TokenSet {
        TokenSet(self.0 & !TokenSet::of(kinds).0)
    }

    /// Whether a kind is in the set.
    pub const fn contains(self, kind: TokenKind) -> bool {
        self.0 >> (kind as u32) & 1 != 0
    }
}

use TokenKind as T;

/// What alone is an operand.
pub const OPERANDS: TokenSet =
    TokenSet::of(&[T::Identifier, T::Int, T::Uint, T::Float, T::True, T::False]);
/// What an operand may start with.
pub const STARTS_OPERAND: TokenSet =
    OPERANDS.and(&[T::Plus, T::Minus, T::Not, T::Tilde, T::Type, T::LeftParen]);
/// What an operand may end with.
pub const ENDS_OPERAND: TokenSet = OPERANDS.and(&[T::RightParen, T::RightBracket]);
/// What stands between two operands, of which it changes none (section 5.1).
#[rustfmt::skip]
pub const BINARY_OPERATORS: TokenSet = TokenSet::of(&[
    T::Plus, T::Minus, T::Star, T::Slash, T::Percent,
    T::Less, T::Greater, T::LessEqual, T::GreaterEqual, T::EqualEqual, T::NotEqual,
    T::AndAnd, T::OrOr, T::XorXor, T::And, T::Or, T::Xor, T::ShiftLeft, T::ShiftRight,
]);
/// `=`, and the operators that compute and assign in every version.
pub const ASSIGNMENTS: TokenSet = TokenSet::of(&[
    T::Equal,
    T::PlusEqual,
    T::MinusEqual,
    T::StarEqual,
    T::SlashEqual,
]);
/// What is put in by a slip more easily than a word.
#[rustfmt::skip]
pub const PUNCTUATION: TokenSet = BINARY_OPERATORS.or(ASSIGNMENTS).and(&[
    T::LeftParen, T::RightParen, T::LeftBracket, T::RightBracket,
    T::Dot, T::Comma, T::Semicolon, T::Colon, T::Question, T::Not, T::Tilde,
]);
/// What no statement starts with, although it is no word.
pub const CONTINUES: TokenSet = BINARY_OPERATORS.without(&[T::Plus, T::Minus]).and(&[
    T::Dot,
    T::Comma,
    T::RightParen,
    T::RightBracket,
    T::Question,
    T::Colon,
]);
/// Where a statement is over, or another one starts.
pub const ENDS_STATEMENT: TokenSet =
    TokenSet::of(&[T::Semicolon, T::LeftBrace, T::RightBrace, T::End]);
/// What an expression is missing before.
pub const ENDS_EXPRESSION: TokenSet = TokenSet::of(&[
    T::Semicolon,
    T::RightParen,
    T::RightBracket,
    T::Comma,
    T::RightBrace,
    T::End,
]);
/// Words before the parentheses of a statement or layout.
pub const HEADS: TokenSet = TokenSet::of(&[T::If, T::For, T::While, T::Switch, T::Layout]);
/// Words that a `(` may belong to.
pub const BEFORE_PAREN: TokenSet = HEADS.and(&[T::Identifier, T::Type]);
/// Words that start a statement which is no declaration.
pub const STARTS_FLOW: TokenSet = TokenSet::of(&[
    T::If,
    T::For,
    T::While,
    T::Do,
    T::Return,
    T::Break,
    T::Continue,
    T::Discard,
    T::Switch,
]);
/// Words that start a statement wherever they stand.
pub const STARTS_STATEMENT: TokenSet = STARTS_FLOW.and(&[T::Const]);
/// Words that can only be the start of a statement or declaration.
pub const STARTS_AFRESH: TokenSet =
    STARTS_STATEMENT.and(&[T::Uniform, T::Struct, T::Precision, T::Void]);
/// What shows code outside functions to be a statement.
pub const STARTS_OUTER_STATEMENT: TokenSet = STARTS_FLOW
    .without(&[T::Break, T::Continue, T::Discard])
    .and(&[T::LeftBrace, T::Identifier, T::Type, T::Reserved]);
/// Words that start a declaration at global scope.
pub const STARTS_ITEM: TokenSet = TokenSet::of(&[
    T::Const,
    T::Uniform,
    T::Struct,
    T::Precision,
    T::Layout,
    T::In,
    T::Out,
]);
/// Precisions.
pub const PRECISIONS: TokenSet = TokenSet::of(&[T::Lowp, T::Mediump, T::Highp]);
/// Words that start a declaration inside a function.
#[rustfmt::skip]
pub const STARTS_DECLARATION: TokenSet = STARTS_ITEM.or(PRECISIONS).and(&[
    T::Inout, T::Centroid, T::Attribute, T::Varying, T::Flat, T::Smooth, T::Invariant, T::Void,
]);
/// Words that start a parameter, but for types.
pub const QUALIFIES_PARAMETER: TokenSet = TokenSet::of(&[T::In, T::Out, T::Inout, T::Const]);
/// What follows a name that is used or declared.
pub const FOLLOWS_NAME: TokenSet = TokenSet::of(&[
    T::Equal,
    T::Semicolon,
    T::Comma,
    T::LeftParen,
    T::RightParen,
    T::LeftBracket,
    T::LeftBrace,
]);
/// What follows a name that starts a statement and declares nothing.
pub const FOLLOWS_USE: TokenSet =
    ASSIGNMENTS.and(&[T::Dot, T::LeftParen, T::Increment, T::Decrement]);

impl TokenKind {
    /// Whether the token alone is an operand.
    pub fn is_operand(self) -> bool {
        OPERANDS.contains(self)
    }

    /// Whether an operand may start with the token.
    pub fn starts_operand(self) -> bool {
        STARTS_OPERAND.contains(self)
    }

    /// Whether an operand may end with the token.
    pub fn ends_operand(self) -> bool {
        ENDS_OPERAND.contains(self)
    }

    /// Whether the token stands between two operands, of which it changes none (section 5.1).
    pub fn is_binary_operator(self) -> bool {
        BINARY_OPERATORS.contains(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_hold_what_they_are_made_of() {
        let set = TokenSet::of(&[T::End, T::XorEqual]);
        assert!(set.contains(T::End) && set.contains(T::XorEqual));
        assert!(!set.contains(T::OrEqual));
        assert!(!set.without(&[T::End]).contains(T::End));
        assert!(set.and(&[T::Dot]).contains(T::Dot));
    }
}
