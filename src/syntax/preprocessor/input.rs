//! Sources of tokens for macro expansion.

use super::{Piece, Preprocessor, end_token};
use crate::token::TokenKind;
use std::ops::Range;
use std::rc::Rc;

pub(super) enum TokenInput {
    Files,
    /// A range of a token list.
    Pieces(Rc<TokenList>, Range<usize>),
}

/// A token list that nested macro calls read without copying.
pub(super) struct TokenList {
    pub pieces: Vec<Piece>,
    /// For each left parenthesis, the index of the matching right one; 0 for other tokens.
    closing: Vec<u32>,
}

impl TokenList {
    pub fn new(pieces: Vec<Piece>) -> TokenList {
        let mut closing = vec![0; pieces.len()];
        let mut open = Vec::new();
        for (i, piece) in pieces.iter().enumerate() {
            match piece.token.kind {
                TokenKind::LeftParen => open.push(i),
                TokenKind::RightParen => {
                    if let Some(slot) = open.pop().and_then(|o: usize| closing.get_mut(o)) {
                        *slot = i as u32;
                    }
                }
                _ => {}
            }
        }
        TokenList { pieces, closing }
    }

    /// Index of the parenthesis that closes the one at an index, within a range.
    pub fn closing(&self, open: usize, range: &Range<usize>) -> Option<usize> {
        let close = *self.closing.get(open)? as usize;
        (open < close && close < range.end).then_some(close)
    }
}

impl TokenInput {
    /// An input over a whole list.
    pub fn of(pieces: Vec<Piece>) -> TokenInput {
        let all = 0..pieces.len();
        TokenInput::Pieces(Rc::new(TokenList::new(pieces)), all)
    }

    pub fn next(&mut self, pp: &mut Preprocessor) -> Piece {
        match self {
            TokenInput::Files => pp.next_piece(),
            TokenInput::Pieces(list, range) => {
                match range.next().and_then(|at| list.pieces.get(at)) {
                    Some(&piece) => piece,
                    None => Piece {
                        token: end_token(0),
                        space: false,
                        frozen: false,
                    },
                }
            }
        }
    }
}
