//! The expressions of `#if` and `#elif` (GLSL ES 3.00 section 3.4).

use super::macros::Piece;
use crate::ast::BinaryOp;
use crate::token::TokenKind;
use shaderlint_text::Span;

/// Maximum nesting of parentheses and unary operators.
const MAX_DEPTH: u32 = 1_000;

/// Why an expression cannot be evaluated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ConditionProblem {
    Empty,
    /// A name that is not defined as a macro, in an operand that is evaluated.
    Undefined(Span),
    /// A token that is not allowed here.
    Unexpected(Span),
    /// The expression ends too early.
    Incomplete(Span),
    /// Division or remainder by zero.
    DivisionByZero(Span),
    /// A shift by a negative number or by more than 31.
    Shift(Span),
    /// Nested too deeply.
    TooDeep(Span),
}

/// Evaluates the fully expanded tokens of a condition. Operands skipped by `&&` and `
///
/// ` may contain undefined names and divisions by zero, as in the browser.
pub(super) fn evaluate(pieces: &[Piece]) -> Result<i32, ConditionProblem> {
    let (value, used) = evaluate_prefix(pieces)?;
    match pieces.get(used) {
        None => Ok(value),
        Some(piece) => Err(ConditionProblem::Unexpected(piece.token.span)),
    }
}

/// Evaluates the first expression and returns how many tokens it used; for `#line`, which may have
/// two.
pub(super) fn evaluate_prefix(pieces: &[Piece]) -> Result<(i32, usize), ConditionProblem> {
    if pieces.is_empty() {
        return Err(ConditionProblem::Empty);
    }
    let mut parser = ConditionParser {
        pieces,
        at: 0,
        skipping: 0,
    };
    let value = parser.binary(0, 0)?;
    Ok((value, parser.at))
}

struct ConditionParser<'a> {
    pieces: &'a [Piece],
    at: usize,
    /// Greater than 0 inside an operand that is not evaluated.
    skipping: u32,
}

impl ConditionParser<'_> {
    fn peek(&self) -> Option<&Piece> {
        self.pieces.get(self.at)
    }

    fn end(&self) -> Span {
        self.pieces
            .last()
            .map_or(Span::default(), |p| p.token.span.after())
    }

    fn binary(&mut self, min: u8, depth: u32) -> Result<i32, ConditionProblem> {
        let mut left = self.unary(depth)?;
        while let Some((op, power)) = self.peek().and_then(|p| infix(p.token.kind)) {
            if power < min {
                break;
            }
            let span = self.peek().map_or(Span::default(), |p| p.token.span);
            self.at += 1;
            let decided = match op {
                TokenKind::OrOr => left != 0,
                TokenKind::AndAnd => left == 0,
                _ => false,
            };
            self.skipping += decided as u32;
            let right = self.binary(power + 1, depth + 1)?;
            self.skipping -= decided as u32;
            left = self.apply(op, left, right, span)?;
        }
        Ok(left)
    }

    fn unary(&mut self, depth: u32) -> Result<i32, ConditionProblem> {
        let Some(&piece) = self.peek() else {
            return Err(ConditionProblem::Incomplete(self.end()));
        };
        let span = piece.token.span;
        if depth > MAX_DEPTH {
            return Err(ConditionProblem::TooDeep(span));
        }
        self.at += 1;
        match piece.token.kind {
            TokenKind::Int | TokenKind::Uint => Ok(piece.token.value as i32),
            TokenKind::Identifier if self.skipping > 0 => Ok(0),
            TokenKind::Identifier => Err(ConditionProblem::Undefined(span)),
            TokenKind::Plus => self.unary(depth + 1),
            TokenKind::Minus => Ok(self.unary(depth + 1)?.wrapping_neg()),
            TokenKind::Not => Ok((self.unary(depth + 1)? == 0) as i32),
            TokenKind::Tilde => Ok(!self.unary(depth + 1)?),
            TokenKind::LeftParen => {
                let value = self.binary(0, depth + 1)?;
                match self.peek() {
                    Some(p) if p.token.kind == TokenKind::RightParen => self.at += 1,
                    Some(p) => return Err(ConditionProblem::Unexpected(p.token.span)),
                    None => return Err(ConditionProblem::Incomplete(self.end())),
                }
                Ok(value)
            }
            _ => Err(ConditionProblem::Unexpected(span)),
        }
    }

    fn apply(&self, op: TokenKind, l: i32, r: i32, span: Span) -> Result<i32, ConditionProblem> {
        let counts = self.skipping == 0;
        Ok(match op {
            TokenKind::OrOr => (l != 0 || r != 0) as i32,
            TokenKind::AndAnd => (l != 0 && r != 0) as i32,
            TokenKind::Or => l | r,
            TokenKind::Xor => l ^ r,
            TokenKind::And => l & r,
            TokenKind::EqualEqual => (l == r) as i32,
            TokenKind::NotEqual => (l != r) as i32,
            TokenKind::Less => (l < r) as i32,
            TokenKind::Greater => (l > r) as i32,
            TokenKind::LessEqual => (l <= r) as i32,
            TokenKind::GreaterEqual => (l >= r) as i32,
            TokenKind::ShiftLeft | TokenKind::ShiftRight if !(0..32).contains(&r) => {
                return if counts {
                    Err(ConditionProblem::Shift(span))
                } else {
                    Ok(0)
                };
            }
            TokenKind::ShiftLeft => l.wrapping_shl(r as u32),
            // Browsers shift zeros in, also for negative numbers.
            TokenKind::ShiftRight => (l as u32).wrapping_shr(r as u32) as i32,
            TokenKind::Plus => l.wrapping_add(r),
            TokenKind::Minus => l.wrapping_sub(r),
            TokenKind::Star => l.wrapping_mul(r),
            _ if r == 0 => {
                return if counts {
                    Err(ConditionProblem::DivisionByZero(span))
                } else {
                    Ok(0)
                };
            }
            TokenKind::Slash => l.wrapping_div(r),
            _ => l.wrapping_rem(r),
        })
    }
}

/// Binary operators with their binding power. `^^` is not allowed here.
fn infix(kind: TokenKind) -> Option<(TokenKind, u8)> {
    let operator = BinaryOp::of(kind).filter(|_| kind != TokenKind::XorXor)?;
    Some((kind, operator.precedence()))
}
