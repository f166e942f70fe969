//! Tokens, before and after the preprocessor.

use shaderlint_text::Span;

/// Kind of a raw token, before preprocessing.
///
/// Concatenating the texts of all raw tokens of a file yields the file.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RawKind {
    /// Blanks, tabs, form feeds, and backslash-newline pairs.
    Whitespace,
    /// `\n`, `\r\n` or `\r`.
    Newline,
    /// `// ...`, without the line break.
    LineComment,
    /// `/* ... */`.
    BlockComment,
    /// `/* ...` up to the end of the file.
    OpenComment,
    /// A word: identifier, keyword or macro name.
    Word,
    /// A word with non-ASCII letters, which GLSL does not allow.
    ForeignWord,
    /// An integer of the grammar in section 4.1.3, including its suffix.
    Integer,
    /// A floating-point number of the grammar in section 4.1.4, including its suffix.
    Float,
    /// Text that starts like a number but is not one: `1f`, `08`, `1.0.0`.
    BadNumber,
    /// An operator or a bracket.
    Operator(TokenKind),
    /// `#`.
    Hash,
    /// A character that GLSL does not allow outside comments.
    Other,
    /// The end of the file; an empty token.
    End,
}

impl RawKind {
    /// Whether it is a comment or blanks within a line.
    pub const fn is_blank(self) -> bool {
        use RawKind::*;
        matches!(self, Whitespace | LineComment | BlockComment | OpenComment)
    }
}

/// A token before preprocessing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RawToken {
    /// Lexical class of the token.
    pub kind: RawKind,
    /// Whether it contains backslash-newline pairs, which must be removed to read it.
    pub spliced: bool,
    /// Range in the address space of all sources.
    pub span: Span,
}

/// Kind of a token after preprocessing.
#[expect(missing_docs, reason = "the variants are standard terms")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum TokenKind {
    /// The end of the last file.
    End,
    /// A name; `value` is its [`Name`](super::Name).
    Identifier,
    /// A reserved word of this version; `value` is its name.
    Reserved,
    /// An invalid number or character, already reported.
    Bad,
    /// A literal; `value` holds its bits.
    Int, Uint, Float,
    /// A built-in type; `value` is a [`TypeWord`](super::names::TypeWord).
    Type,
    True, False,
    // Keywords.
    Attribute, Break, Case, Centroid, Const, Continue, Default, Discard, Do, Else, Flat, For, Highp,
    If, In, Inout, Invariant, Layout, Lowp, Mediump, Out, Precision, Return, Smooth, Struct, Switch,
    Uniform, Varying, Void, While,
    // Brackets and separators.
    LeftParen, RightParen, LeftBracket, RightBracket, LeftBrace, RightBrace, Dot, Comma, Semicolon,
    Colon, Question,
    // Operators.
    Plus, Minus, Star, Slash, Percent, Less, Greater, LessEqual, GreaterEqual, EqualEqual, NotEqual,
    AndAnd, OrOr, XorXor, Not, Tilde, And, Or, Xor, ShiftLeft, ShiftRight, Increment, Decrement,
    Equal, PlusEqual, MinusEqual, StarEqual, SlashEqual, PercentEqual, ShiftLeftEqual,
    ShiftRightEqual, AndEqual, OrEqual, XorEqual,
}

/// A token after preprocessing, with its origin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// Kind as the parser sees it.
    pub kind: TokenKind,
    /// Payload by kind: a name, a type word, or the bits of a number.
    pub value: u32,
    /// Position in the user's text: its own text or, for a token from a macro body, the outermost
    /// macro call.
    pub span: Span,
    /// Address where it is spelled; for a token from a macro body, inside the `#define`.
    pub spelled: u32,
    /// Index of the macro expansion that produced it, or [`Token::DIRECT`].
    pub expansion: u32,
}

/// Source text that supplies some tokens and nothing else.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ExactPlace {
    /// Where it is.
    pub span: Span,
    /// Whether it is in the body of a macro, so that a change affects all calls.
    pub in_body: bool,
    /// Whether it is in a body and has parameters, so that its type may differ between calls.
    pub has_params: bool,
}

// Size limits: a shader has one per word.
const _: () = assert!(size_of::<Token>() <= 24);
const _: () = assert!(size_of::<RawToken>() <= 12);

impl Token {
    /// End of an empty text.
    pub const END: Token = Token::direct(TokenKind::End, 0, Span { start: 0, end: 0 });

    /// The `expansion` of a token that is not produced by a macro.
    pub const DIRECT: u32 = u32::MAX;

    /// A token in the source text, outside any macro call.
    pub const fn direct(kind: TokenKind, value: u32, span: Span) -> Token {
        Token {
            kind,
            value,
            span,
            spelled: span.start,
            expansion: Token::DIRECT,
        }
    }

    /// Whether the token is in the source text, outside any macro call.
    pub fn is_direct(&self) -> bool {
        self.expansion == Token::DIRECT
    }
}
