//! Tokens, before and after the preprocessor.

use shaderlint_text::Span;

/// What a piece of raw text is, before the preprocessor has looked at it.
///
/// The texts of all raw tokens of a file, put end to end, are the file.
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
    /// A word with letters outside ASCII, which GLSL does not have.
    ForeignWord,
    /// An integer as the grammar of section 4.1.3 has it, suffix included.
    Integer,
    /// A floating point number as section 4.1.4 has it, suffix included.
    Float,
    /// Something that starts like a number and is none: `1f`, `08`, `1.0.0`.
    BadNumber,
    /// An operator or a bracket.
    Operator(TokenKind),
    /// `#`.
    Hash,
    /// A character that GLSL does not use outside comments.
    Other,
    /// The end of the file; an empty token.
    End,
}

/// A piece of raw text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RawToken {
    /// What it is.
    pub kind: RawKind,
    /// Whether backslash-newline pairs lie inside and must be taken out to read it.
    pub spliced: bool,
    /// Where it is.
    pub span: Span,
}

/// What a token means to the parser.
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum TokenKind {
    /// The end of the last file.
    End,
    /// A name; `value` is its [`Name`](super::Name).
    Identifier,
    /// A word that this version of the language keeps for itself; `value` is its name.
    Reserved,
    /// Text that is no token: a bad number or character, already reported.
    Bad,
    /// `value` holds the bits of the number.
    Int, Uint, Float,
    /// A type of the language; `value` is a [`TypeWord`](super::names::TypeWord).
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

/// A token as the parser sees it, with the place it came from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Payload by kind: a name, a type word, or the bits of a number.
    pub value: u32,
    /// Where the user sees it: its own text, or, for a token that a macro's body supplied, the
    /// outermost macro call.
    pub span: Span,
    /// Address of its own text, which for a macro body lies in the `#define`.
    pub spelled: u32,
    /// Index of the macro expansion that it came through, or [`Token::DIRECT`].
    pub expansion: u32,
}

// Every word of a shader is one.
const _: () = assert!(size_of::<Token>() <= 24);
const _: () = assert!(size_of::<RawToken>() <= 12);

impl Token {
    /// The end of no text at all.
    pub const END: Token = Token {
        kind: TokenKind::End,
        value: 0,
        span: Span { start: 0, end: 0 },
        spelled: 0,
        expansion: Token::DIRECT,
    };

    /// The `expansion` of a token that stands in the text as the parser sees it.
    pub const DIRECT: u32 = u32::MAX;

    /// Whether the token stands in the user's text just so, outside any macro call.
    pub fn is_direct(&self) -> bool {
        self.expansion == Token::DIRECT
    }
}
