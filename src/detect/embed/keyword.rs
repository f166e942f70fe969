//! GLSL keywords that determine what fits into a hole.

use crate::kind::is_type;

/// Whether a word is a keyword at the start of declarations or statements.
pub(super) fn is_keyword(word: &str) -> bool {
    let is_qualifier = matches!(
        word,
        "uniform"
            | "in"
            | "out"
            | "inout"
            | "varying"
            | "attribute"
            | "const"
            | "flat"
            | "smooth"
            | "centroid"
            | "highp"
            | "mediump"
            | "lowp"
            | "precision"
            | "layout"
            | "invariant"
    );
    let is_statement = matches!(
        word,
        "struct"
            | "if"
            | "else"
            | "for"
            | "while"
            | "do"
            | "return"
            | "break"
            | "continue"
            | "discard"
            | "switch"
    );
    is_qualifier || is_statement || is_type(word)
}
