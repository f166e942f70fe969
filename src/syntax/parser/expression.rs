//! Expressions (GLSL ES 3.00 sections 5 and 9).

use super::{MAX_PARENS, Parsed, Parser, Reported, append};
use crate::ast::*;
use crate::names::Name;
use crate::token::TokenKind;
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_text::{Edit, Span};

/// Binding power of an operator; a higher number binds more tightly.
type Power = u8;
const COMMA: Power = 1;
const ASSIGN: Power = 2;
const TERNARY: Power = 3;

/// The operator of a compound assignment; the inner `None` stands for plain `=`.
fn assignment(kind: TokenKind) -> Option<Option<BinaryOp>> {
    use TokenKind as T;
    Some(match kind {
        T::Equal => None,
        T::StarEqual => Some(BinaryOp::Mul),
        T::SlashEqual => Some(BinaryOp::Div),
        T::PercentEqual => Some(BinaryOp::Rem),
        T::PlusEqual => Some(BinaryOp::Add),
        T::MinusEqual => Some(BinaryOp::Sub),
        T::ShiftLeftEqual => Some(BinaryOp::ShiftLeft),
        T::ShiftRightEqual => Some(BinaryOp::ShiftRight),
        T::AndEqual => Some(BinaryOp::BitAnd),
        T::XorEqual => Some(BinaryOp::BitXor),
        T::OrEqual => Some(BinaryOp::BitOr),
        _ => return None,
    })
}

fn unary(kind: TokenKind) -> Option<UnaryOp> {
    Some(match kind {
        TokenKind::Plus => UnaryOp::Plus,
        TokenKind::Minus => UnaryOp::Minus,
        TokenKind::Not => UnaryOp::Not,
        TokenKind::Tilde => UnaryOp::BitNot,
        TokenKind::Increment => UnaryOp::Increment,
        TokenKind::Decrement => UnaryOp::Decrement,
        _ => return None,
    })
}

impl Parser<'_> {
    /// Parses an expression of a statement, including commas. On an error, nothing of it stays in
    /// the tree.
    pub(super) fn root_expression(&mut self) -> Parsed<ExprId> {
        self.root(COMMA)
    }

    /// Parses an expression of a declaration, without commas.
    pub(super) fn root_assignment(&mut self) -> Parsed<ExprId> {
        self.root(ASSIGN)
    }

    fn root(&mut self, min: Power) -> Parsed<ExprId> {
        let mark = self.tree.exprs.len();
        let depth = self.depth;
        let open_args = self.open_args.len();
        let result = self.operators(min);
        if result.is_err() {
            self.tree.exprs.truncate(mark);
            self.depth = depth;
            self.open_args.truncate(open_args);
        }
        result
    }

    /// Adds a placeholder for an expression that could not be parsed.
    pub(super) fn error_expr(&mut self, first: TokenId) -> ExprId {
        let extent = self.extent_from(first);
        self.push_expr(ExprKind::Error, extent)
    }

    fn operators(&mut self, min: Power) -> Parsed<ExprId> {
        let left = self.operand()?;
        self.operators_after(left, min)
    }

    /// Parses the operators after `left` that bind at least as tightly as `min`.
    fn operators_after(&mut self, mut left: ExprId, min: Power) -> Parsed<ExprId> {
        loop {
            let kind = self.peek();
            if let Some(op) = BinaryOp::of(kind) {
                let power = op.precedence();
                if power < min {
                    return Ok(left);
                }
                self.advance();
                self.enter()?;
                let right = self.operators(power + 1)?;
                self.leave();
                left = self.join(left, right, ExprKind::Binary(op, left, right));
            } else if kind == TokenKind::Question && min <= TERNARY {
                left = self.ternary(left)?;
            } else if kind == TokenKind::Comma && min <= COMMA {
                self.advance();
                self.enter()?;
                let right = self.operators(ASSIGN)?;
                self.leave();
                left = self.join(left, right, ExprKind::Comma(left, right));
            } else if let Some(op) = assignment(kind).filter(|_| min <= ASSIGN) {
                self.advance();
                self.enter()?;
                let right = self.operators(ASSIGN)?;
                self.leave();
                left = self.join(left, right, ExprKind::Assign(op, left, right));
            } else {
                return Ok(left);
            }
        }
    }

    fn join(&mut self, left: ExprId, right: ExprId, kind: ExprKind) -> ExprId {
        let extent = self.tree.expr(left).extent.to(self.tree.expr(right).extent);
        self.push_expr(kind, extent)
    }

    fn ternary(&mut self, condition: ExprId) -> Parsed<ExprId> {
        self.advance();
        self.enter()?;
        let yes = self.operators(COMMA)?;
        self.expect(TokenKind::Colon, "`:` of the `?:` operator")?;
        let no = self.operators(ASSIGN)?;
        self.leave();
        Ok(self.join(condition, no, ExprKind::Ternary(condition, yes, no)))
    }

    fn operand(&mut self) -> Parsed<ExprId> {
        let kind = self.peek();
        if kind == TokenKind::LeftParen {
            return if self.is_c_cast() {
                self.c_cast()
            } else {
                self.parens()
            };
        }
        if let Some(op) = unary(kind) {
            let first = self.advance();
            self.enter()?;
            let operand = self.operand()?;
            self.leave();
            let extent = Extent::token(first).to(self.tree.expr(operand).extent);
            return Ok(self.push_expr(ExprKind::Unary(op, operand), extent));
        }
        let primary = self.primary()?;
        self.postfix(primary)
    }

    /// Parses any number of parentheses around an expression, without recursion for directly nested
    /// ones.
    fn parens(&mut self) -> Parsed<ExprId> {
        let (first, mut open) = (self.id(), 0);
        while self.is(TokenKind::LeftParen) && !self.is_c_cast() {
            if open >= MAX_PARENS {
                let d = self.error_here(error::BROWSER_LIMIT, "too many nested parentheses");
                self.report(d.note("the browser's parser stack overflows here"));
                return Err(Reported);
            }
            self.advance();
            open += 1;
        }
        self.enter()?;
        let mut inner = self.operators(COMMA)?;
        self.leave();
        while open > 0 {
            open -= 1;
            let first = first + open;
            self.close_operand(TokenKind::RightParen, first)?;
            let extent = self.extent_from(first);
            inner = self.push_expr(ExprKind::Paren(inner), extent);
            inner = self.postfix(inner)?;
            if open > 0 {
                inner = self.operators_after(inner, COMMA)?;
            }
        }
        Ok(inner)
    }

    fn is_c_cast(&self) -> bool {
        self.kind(0) == TokenKind::LeftParen
            && self.kind(1) == TokenKind::Type
            && self.kind(2) == TokenKind::RightParen
    }

    /// `(float) x`, a cast of C.
    fn c_cast(&mut self) -> Parsed<ExprId> {
        let first = self.advance();
        let ty = self.type_spec()?;
        let close = self.advance();
        let cast = self.span(Extent { first, last: close });
        let name = match self.tree.ty(ty).base {
            TypeBase::Word(word) if self.tree.ty(ty).arrays.len == 0 => word.name().to_string(),
            _ => self
                .sources
                .text(self.span(self.tree.ty(ty).extent))
                .to_string(),
        };
        self.enter()?;
        let operand = self.operand()?;
        self.leave();
        let operand_span = self.span(self.tree.expr(operand).extent);
        let text = self.sources.text(operand_span).to_string();
        let call = format!("{name}({text})");
        let message = "GLSL has no C-style casts";
        let d = Diagnostic::error(error::FOREIGN_SYNTAX, cast, message)
            .note("use a constructor to convert a value (section 5.4)")
            .fix(Fix::safe_replacement(cast.to(operand_span), call.clone()));
        let token = self.token(first as usize);
        self.report_at(d, &token);
        let args = append(&mut self.tree.expr_lists, [operand]);
        let extent = Extent::token(first).to(self.tree.expr(operand).extent);
        Ok(self.push_expr(ExprKind::Construct(ty, args), extent))
    }

    fn primary(&mut self) -> Parsed<ExprId> {
        let token = self.next();
        let kind = match token.kind {
            TokenKind::Identifier => return self.name_or_call(),
            TokenKind::Reserved => return self.reserved_primary(),
            TokenKind::Type => return self.constructor(),
            _ if self.is_qualifier_as_name(&token) => return self.qualifier_as_name(),
            TokenKind::Int => ExprKind::Int(token.value as i32),
            TokenKind::Uint => ExprKind::Uint(token.value),
            TokenKind::Float => ExprKind::Float(f32::from_bits(token.value)),
            TokenKind::True => ExprKind::Bool(true),
            TokenKind::False => ExprKind::Bool(false),
            TokenKind::Bad => {
                let first = self.advance();
                // Probably the arguments of a call.
                if self.is(TokenKind::LeftParen) {
                    self.skip_parens();
                }
                let extent = self.extent_from(first);
                return Ok(self.push_expr(ExprKind::Error, extent));
            }
            _ => return Err(self.no_expression()),
        };
        let id = self.advance();
        Ok(self.push_expr(kind, Extent::token(id)))
    }

    pub(super) fn name_or_call(&mut self) -> Parsed<ExprId> {
        if self.kind(1) == TokenKind::LeftBracket && self.is_array_constructor() {
            return self.constructor();
        }
        let first = self.id();
        let name = Name(self.next().value);
        self.advance();
        if self.is(TokenKind::LeftParen) {
            let args = self.arguments()?;
            let extent = self.extent_from(first);
            return Ok(self.push_expr(ExprKind::Call(name, args), extent));
        }
        Ok(self.push_expr(ExprKind::Name(name), Extent::token(first)))
    }

    /// Whether `name [ ... ] (` follows: the constructor of an array of structs.
    fn is_array_constructor(&self) -> bool {
        self.after_brackets(self.at + 1)
            .is_some_and(|at| self.token(at).kind == TokenKind::LeftParen)
    }

    /// Index of the token after the bracket that closes the one at `at`, if it is closed before the
    /// statement ends.
    pub(super) fn after_brackets(&self, at: usize) -> Option<usize> {
        let mut open = 0_u32;
        for (i, token) in self.tokens.get(at..)?.iter().enumerate() {
            match token.kind {
                TokenKind::LeftBracket => open += 1,
                TokenKind::RightBracket => {
                    open -= 1;
                    if open == 0 {
                        return Some(at + i + 1);
                    }
                }
                TokenKind::Semicolon | TokenKind::LeftBrace | TokenKind::RightBrace => return None,
                _ => {}
            }
        }
        None
    }

    /// Parses `vec3(...)`, `float[2](...)` or `S[](...)`.
    fn constructor(&mut self) -> Parsed<ExprId> {
        let first = self.id();
        let ty = self.type_spec()?;
        if !self.is(TokenKind::LeftParen) {
            return Err(self.type_as_value(ty));
        }
        let args = self.arguments()?;
        let extent = self.extent_from(first);
        Ok(self.push_expr(ExprKind::Construct(ty, args), extent))
    }

    fn arguments(&mut self) -> Parsed<List> {
        let open = self.advance();
        if self.kind(0) == TokenKind::Void && self.kind(1) == TokenKind::RightParen {
            self.advance();
        }
        let mark = self.open_args.len();
        if !self.is(TokenKind::RightParen) {
            self.enter()?;
            loop {
                let arg = self.operators(ASSIGN)?;
                self.open_args.push(arg);
                if self.eat(TokenKind::Comma).is_none() {
                    break;
                }
            }
            self.leave();
        }
        self.close_operand(TokenKind::RightParen, open)?;
        let args = self.open_args.drain(mark..);
        Ok(append(&mut self.tree.expr_lists, args))
    }

    pub(super) fn postfix(&mut self, mut object: ExprId) -> Parsed<ExprId> {
        loop {
            let first = self.tree.expr(object).extent.first;
            let kind = match self.peek() {
                TokenKind::Dot => self.member(object)?,
                TokenKind::LeftBracket => {
                    let open = self.advance();
                    if self.is(TokenKind::RightBracket) {
                        return Err(self.no_expression());
                    }
                    self.enter()?;
                    let index = self.operators(COMMA)?;
                    self.leave();
                    self.close_operand(TokenKind::RightBracket, open)?;
                    ExprKind::Index(object, index)
                }
                TokenKind::Increment | TokenKind::Decrement if !self.starts_statement() => {
                    let is_increment = self.is(TokenKind::Increment);
                    self.advance();
                    let op = if is_increment {
                        PostfixOp::Increment
                    } else {
                        PostfixOp::Decrement
                    };
                    ExprKind::Postfix(op, object)
                }
                _ => return Ok(object),
            };
            let extent = self.extent_from(first);
            object = self.push_expr(kind, extent);
        }
    }

    /// Whether a `++` on a new line belongs to the following operand, so that a `;` is missing
    /// before it.
    fn starts_statement(&self) -> bool {
        matches!(self.kind(1), TokenKind::Identifier) && self.is_on_new_line()
    }

    /// Parses `.field` or `.method(args)`. Any word may follow the dot, even a keyword.
    fn member(&mut self, object: ExprId) -> Parsed<ExprKind> {
        self.advance();
        let token = self.next();
        let name = match token.kind {
            TokenKind::Identifier => Name(token.value),
            TokenKind::Reserved => {
                // A member cannot have a reserved name.
                self.report_reserved(&token);
                self.advance();
                return Ok(ExprKind::Error);
            }
            _ => match self.names.get(self.text(&token)) {
                Some(name) => name,
                None => {
                    let d =
                        self.error_here(error::SYNTAX_ERROR, "expected a member name after `.`");
                    self.report(d);
                    return Err(Reported);
                }
            },
        };
        self.advance();
        if self.is(TokenKind::LeftParen) {
            let args = self.arguments()?;
            return Ok(ExprKind::Method(object, name, args));
        }
        Ok(ExprKind::Member(object, name))
    }

    /// `{1.0, 2.0}` as an initializer, as in C: reports and skips it.
    pub(super) fn initializer_list(&mut self, ty: TypeId, is_array: bool) -> ExprId {
        let first = self.id();
        let mut open = 0_u32;
        let mut is_flat = true;
        loop {
            match self.peek() {
                TokenKind::LeftBrace => open += 1,
                TokenKind::RightBrace => open -= 1,
                TokenKind::End | TokenKind::Semicolon => break,
                _ => {}
            }
            is_flat &= open <= 1;
            self.advance();
            if open == 0 {
                break;
            }
        }
        let span = self.span(self.extent_from(first));
        // A brace inserted by a correction has no place in the text.
        let last = self.token(self.last() as usize);
        is_flat &= last.kind == TokenKind::RightBrace && !last.span.is_empty();
        let name = self
            .sources
            .text(self.span(self.tree.ty(ty).extent))
            .to_string();
        let constructor = if is_array { format!("{name}[]") } else { name };
        let d = Diagnostic::error(
            error::INITIALIZER_LIST,
            span,
            "GLSL ES has no initializer lists",
        )
        .note("arrays, structs and vectors are built with constructors (section 5.4)")
        .help(format!("use `{constructor}(...)`"));
        let start = Span::new(span.start, span.start + 1);
        let mut edits = vec![Edit::replace(start, format!("{constructor}("))];
        let before = self.token(self.last().saturating_sub(1) as usize);
        if before.kind == TokenKind::Comma {
            edits.push(Edit::delete(before.span));
        }
        edits.push(Edit::replace(last.span, ")"));
        let fix = is_flat.then(|| Fix::safe(format!("use `{constructor}(...)`"), edits));
        let token = self.token(first as usize);
        self.report_at(d.fix(fix), &token);
        self.error_expr(first)
    }
}
