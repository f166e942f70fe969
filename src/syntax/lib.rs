//! Lexer, preprocessor and parser of GLSL ES 3.00 and 1.00.
//!
//! Parsing never fails: for any text the result is a tree and a list of errors.
#![cfg_attr(test, allow(clippy::string_slice))]

pub mod ast;
mod conditional;
mod context;
mod foreign;
mod language;
mod lexer;
mod lines;
mod names;
mod parser;
mod preprocessor;
mod reduce;
mod search;
pub mod set;
mod token;
mod translation;

pub use conditional::{
    BranchId, ConditionalDirective, ConditionalGroup, ConditionalGroups, GroupBranch,
    GroupDirective, MacroTest, MacroTestKind,
};
pub use context::{
    EXTENSION_BEHAVIORS, EXTENSIONS, ExtensionFacts, Extensions, GlContext, GlExtension, WebGl,
    extensions,
};
pub use foreign::{Foreign, Meaning, foreign, type_in_another_case};
pub use language::{ES_100, ES_300, Feature, LanguageProfile};
pub use lexer::{Lexer, tokenize, unsplice, written_tokens};
pub use lines::{RawItem, is_blank, raw_items};
pub use names::{Name, Names, TypeWord, Version, WordClass, classify};
pub use parser::{
    Choice, Correction, Parse, ParseOptions, has_same_letters, keyword_near, parse, parse_corrected,
};
pub use preprocessor::{
    DIRECTIVES, Expansion, ExtensionUse, Macro, MacroId, Piece, Preprocessed, Tokens, macro_uses,
    preprocess,
};
pub use reduce::{Reduced, reduce};
pub use search::Search;
pub use set::TokenSet;
pub use token::{ExactPlace, RawKind, RawToken, Token, TokenKind};
pub use translation::Translated;
