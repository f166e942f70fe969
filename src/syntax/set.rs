//! Sets of token kinds: tokens that can start, end or follow a grammar construct.

use super::token::TokenKind;

/// A set of token kinds as a bit mask.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TokenSet(u128);

// All kinds must fit in the mask; this is the last one.
const _: () = assert!((TokenKind::XorEqual as u32) < u128::BITS);

impl TokenSet {
    /// A set of these kinds.
    pub const fn of(kinds: &[TokenKind]) -> TokenSet {
        let mut bits = 0;
        let mut rest = kinds;
        while let [first, after @ ..] = rest {
            bits |= 1 << (*first as u32);
            rest = after;
        }
        TokenSet(bits)
    }

    /// This set with more kinds added.
    pub const fn and(self, kinds: &[TokenKind]) -> TokenSet {
        self.or(TokenSet::of(kinds))
    }

    /// The union of two sets.
    pub const fn or(self, other: TokenSet) -> TokenSet {
        TokenSet(self.0 | other.0)
    }

    /// This set with some kinds removed.
    pub const fn without(self, kinds: &[TokenKind]) -> TokenSet {
        TokenSet(self.0 & !TokenSet::of(kinds).0)
    }

    /// Whether a kind is in the set.
    pub const fn contains(self, kind: TokenKind) -> bool {
        self.0 >> (kind as u32) & 1 != 0
    }
}

use TokenKind as T;

/// Tokens that are operands by themselves.
pub const OPERANDS: TokenSet =
    TokenSet::of(&[T::Identifier, T::Int, T::Uint, T::Float, T::True, T::False]);
/// Tokens that can start an operand.
pub const STARTS_OPERAND: TokenSet =
    OPERANDS.and(&[T::Plus, T::Minus, T::Not, T::Tilde, T::Type, T::LeftParen]);
/// Tokens that can end an operand.
pub const ENDS_OPERAND: TokenSet = OPERANDS.and(&[T::RightParen, T::RightBracket]);
/// Binary operators without side effects (section 5.1).
#[rustfmt::skip]
pub const BINARY_OPERATORS: TokenSet = TokenSet::of(&[
    T::Plus, T::Minus, T::Star, T::Slash, T::Percent,
    T::Less, T::Greater, T::LessEqual, T::GreaterEqual, T::EqualEqual, T::NotEqual,
    T::AndAnd, T::OrOr, T::XorXor, T::And, T::Or, T::Xor, T::ShiftLeft, T::ShiftRight,
]);
/// Assignment operators that exist in every version.
pub const ASSIGNMENTS: TokenSet = TokenSet::of(&[
    T::Equal,
    T::PlusEqual,
    T::MinusEqual,
    T::StarEqual,
    T::SlashEqual,
]);
/// Punctuation that is easily typed by mistake.
#[rustfmt::skip]
pub const PUNCTUATION: TokenSet = BINARY_OPERATORS.or(ASSIGNMENTS).and(&[
    T::LeftParen, T::RightParen, T::LeftBracket, T::RightBracket,
    T::Dot, T::Comma, T::Semicolon, T::Colon, T::Question, T::Not, T::Tilde,
]);
/// Brackets and separators, which are often superfluous.
pub const SEPARATES: TokenSet = TokenSet::of(&[
    T::LeftParen,
    T::RightParen,
    T::LeftBracket,
    T::RightBracket,
    T::Comma,
    T::Semicolon,
]);
/// Punctuation that cannot start a statement.
pub const CONTINUES: TokenSet = BINARY_OPERATORS.without(&[T::Plus, T::Minus]).and(&[
    T::Dot,
    T::Comma,
    T::RightParen,
    T::RightBracket,
    T::Question,
    T::Colon,
]);
/// Tokens at which a statement ends or a new one starts.
pub const ENDS_STATEMENT: TokenSet =
    TokenSet::of(&[T::Semicolon, T::LeftBrace, T::RightBrace, T::End]);
/// Tokens before which an expression may be missing.
pub const ENDS_EXPRESSION: TokenSet = TokenSet::of(&[
    T::Semicolon,
    T::RightParen,
    T::RightBracket,
    T::Comma,
    T::RightBrace,
    T::End,
]);
/// Keywords followed by a parenthesised header.
pub const HEADS: TokenSet = TokenSet::of(&[T::If, T::For, T::While, T::Switch, T::Layout]);
/// Tokens that a `(` can follow.
pub const BEFORE_PAREN: TokenSet = HEADS.and(&[T::Identifier, T::Type]);
/// Keywords that start a statement other than a declaration.
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
/// Keywords that always start a statement.
pub const STARTS_STATEMENT: TokenSet = STARTS_FLOW.and(&[T::Const]);
/// Keywords that always start a statement or declaration.
pub const STARTS_AFRESH: TokenSet =
    STARTS_STATEMENT.and(&[T::Uniform, T::Struct, T::Precision, T::Void]);
/// Tokens that indicate a statement outside a function.
pub const STARTS_OUTER_STATEMENT: TokenSet = STARTS_FLOW
    .without(&[T::Break, T::Continue, T::Discard])
    .and(&[T::LeftBrace, T::Identifier, T::Type, T::Reserved]);
/// Keywords that start a declaration at global scope.
pub const STARTS_ITEM: TokenSet = TokenSet::of(&[
    T::Const,
    T::Uniform,
    T::Struct,
    T::Precision,
    T::Layout,
    T::In,
    T::Out,
]);
/// Precision qualifiers.
pub const PRECISIONS: TokenSet = TokenSet::of(&[T::Lowp, T::Mediump, T::Highp]);
/// Keywords that start a declaration inside a function.
#[rustfmt::skip]
pub const STARTS_DECLARATION: TokenSet = STARTS_ITEM.or(PRECISIONS).and(&[
    T::Inout, T::Centroid, T::Attribute, T::Varying, T::Flat, T::Smooth, T::Invariant, T::Void,
]);
/// Qualifiers that start a parameter.
pub const QUALIFIES_PARAMETER: TokenSet = TokenSet::of(&[T::In, T::Out, T::Inout, T::Const]);
/// Tokens that can follow a used or declared name.
pub const FOLLOWS_NAME: TokenSet = TokenSet::of(&[
    T::Equal,
    T::Semicolon,
    T::Comma,
    T::LeftParen,
    T::RightParen,
    T::LeftBracket,
    T::LeftBrace,
]);
/// Tokens that follow a name at the start of a statement that is not a declaration.
pub const FOLLOWS_USE: TokenSet =
    ASSIGNMENTS.and(&[T::Dot, T::LeftParen, T::Increment, T::Decrement]);

impl TokenKind {
    /// Whether the token is an operand by itself.
    pub fn is_operand(self) -> bool {
        OPERANDS.contains(self)
    }

    /// Whether the token can start an operand.
    pub fn starts_operand(self) -> bool {
        STARTS_OPERAND.contains(self)
    }

    /// Whether the token can end an operand.
    pub fn ends_operand(self) -> bool {
        ENDS_OPERAND.contains(self)
    }

    /// Whether the token is a binary operator without side effects (section 5.1).
    pub fn is_binary_operator(self) -> bool {
        BINARY_OPERATORS.contains(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn token_sets_contain_their_elements() {
        let set = TokenSet::of(&[T::End, T::XorEqual]);
        assert!(set.contains(T::End) && set.contains(T::XorEqual));
        assert!(!set.contains(T::OrEqual));
        assert!(!set.without(&[T::End]).contains(T::End));
        assert!(set.and(&[T::Dot]).contains(T::Dot));
    }
}
