//! Statements (GLSL ES 3.00 section 6).

use super::token_repair::FaultScope;
use super::{Checkpoint, MAX_ERRORS, Parsed, Parser, Reported, append};
use crate::ast::*;
use crate::names::Name;
use crate::token::TokenKind;
use shaderlint_diagnostic::error;

/// Maximum number of tokens before a failing statement that are parsed again.
const MAX_BEFORE: usize = 300;

/// Number of statements that must be parsed again.
struct TakenBack(usize);

impl Parser<'_> {
    /// Parses `{ ... }`.
    pub(super) fn block(&mut self) -> Parsed<StmtId> {
        let first = self.id();
        let body = self.braces()?;
        Ok(self.push_stmt(StmtKind::Block(body), first))
    }

    /// Parses the statements between braces. An error inside does not propagate.
    fn braces(&mut self) -> Parsed<List> {
        let open = self.id();
        self.expect(TokenKind::LeftBrace, "`{`")?;
        self.enter()?;
        let mark = self.open_stmts.len();
        let mut before: [Option<Checkpoint>; 2] = [None; 2];
        loop {
            match self.peek() {
                TokenKind::RightBrace => {
                    self.advance();
                    break;
                }
                TokenKind::End => {
                    self.missing_brace(open);
                    break;
                }
                _ if self.at_function_definition() => {
                    if self.is_left_open(open) {
                        self.missing_brace(open);
                        break;
                    }
                    let statement = self.nested_function();
                    self.open_stmts.push(statement);
                }
                _ => {
                    let start = self.checkpoint();
                    match self.statement_after(&before, FaultScope::Block) {
                        Ok(statement) => {
                            self.open_stmts.push(statement);
                            before = [before[1], Some(start)];
                        }
                        Err(TakenBack(count)) => {
                            let kept = self.open_stmts.len().saturating_sub(count);
                            self.open_stmts.truncate(kept.max(mark));
                            before = [None; 2];
                        }
                    }
                }
            }
        }
        self.leave();
        let body = self.open_stmts.drain(mark.min(self.open_stmts.len())..);
        Ok(append(&mut self.tree.stmt_lists, body))
    }

    /// Parses a statement; on errors, adds an `Error` node and skips the statement.
    pub(super) fn statement_or_error(&mut self) -> StmtId {
        let first = self.id();
        match self.statement_after(&[], FaultScope::Body) {
            Ok(statement) => statement,
            Err(_) => self.push_stmt(StmtKind::Error, first),
        }
    }

    /// Parses a statement after others. If an earlier statement was corrected, parsing resumes
    /// there.
    fn statement_after(
        &mut self,
        before: &[Option<Checkpoint>],
        scope: FaultScope,
    ) -> Result<StmtId, TakenBack> {
        let outer = self.fault.take();
        let start = self.checkpoint();
        loop {
            let statement = self.statement_as_it_is();
            if self.fault.is_none() {
                self.fault = outer;
                return Ok(statement);
            }
            let reported = self.diagnostics.get(start.diagnostics).cloned();
            let from = self.first_to_read(start, before);
            if !self.repair_token(from.at, scope, reported) {
                self.fault = outer.or(self.fault);
                return Ok(statement);
            }
            self.go_back(from);
            if from.at != start.at {
                self.fault = outer;
                let is_again = |b: &&Option<Checkpoint>| b.is_some_and(|b| b.at >= from.at);
                return Err(TakenBack(before.iter().filter(is_again).count()));
            }
        }
    }

    /// Start of a trial parse: if no token of the statement at `start` parses, the error may be in
    /// the statements before it.
    pub(super) fn first_to_read(
        &self,
        start: Checkpoint,
        before: &[Option<Checkpoint>],
    ) -> Checkpoint {
        let is_near = |b: &&Checkpoint| start.at - b.at.min(start.at) <= MAX_BEFORE;
        let earlier = before.iter().flatten().find(is_near);
        match earlier {
            Some(earlier) if self.fault == Some(start.at) => *earlier,
            _ => start,
        }
    }

    fn statement_as_it_is(&mut self) -> StmtId {
        let first = self.id();
        let mark = self.tree.exprs.len();
        let depth = self.depth;
        match self.statement() {
            Ok(stmt) => stmt,
            Err(Reported) => {
                self.depth = depth;
                self.tree.exprs.truncate(mark);
                self.skip_statement(first);
                self.lose_names(first);
                self.after_error = Some(self.at);
                self.push_stmt(StmtKind::Error, first)
            }
        }
    }

    fn statement(&mut self) -> Parsed<StmtId> {
        use TokenKind as T;
        let first = self.id();
        let kind = match self.peek() {
            T::LeftBrace => return self.block(),
            T::If => return self.if_statement(),
            T::Semicolon => {
                self.advance();
                StmtKind::Empty
            }
            T::For => self.for_statement()?,
            T::While => self.while_statement()?,
            T::Do => self.do_statement()?,
            T::Switch => self.switch_statement()?,
            T::Reserved if self.at_newer_statement() => self.newer_statement(),
            T::Case => {
                self.advance();
                let value = self.root_expression()?;
                self.expect(T::Colon, "`:` after the `case` label")?;
                StmtKind::Case(value)
            }
            T::Default => {
                self.advance();
                self.expect(T::Colon, "`:` after `default`")?;
                StmtKind::Default
            }
            T::Break => self.jump(StmtKind::Break)?,
            T::Continue => self.jump(StmtKind::Continue)?,
            T::Discard => self.jump(StmtKind::Discard)?,
            T::Return => self.return_statement()?,
            // The `if` before it could not be parsed.
            T::Else if self.after_error == Some(self.at) => {
                self.advance();
                return self.statement();
            }
            T::Else => return Err(self.else_without_if()),
            T::Identifier if self.at_misspelled_keyword() => {
                return Err(self.misspelled_keyword());
            }
            _ if self.at_declaration() => {
                let decl = self.declaration()?;
                StmtKind::Decl(decl)
            }
            _ => {
                let expr = self.root_expression()?;
                self.semicolon()?;
                StmtKind::Expr(expr)
            }
        };
        Ok(self.push_stmt(kind, first))
    }

    /// Whether a misspelled keyword would parse as the type of a declaration, `retrun x;`, or as a
    /// value before a block, `esle {`.
    fn at_misspelled_keyword(&self) -> bool {
        use TokenKind as T;
        let next = self.kind(1);
        let is_keyword = |kind| match next {
            T::Identifier => matches!(kind, T::Return | T::Else),
            _ => matches!(kind, T::Else | T::Do),
        };
        matches!(next, T::Identifier | T::LeftBrace)
            && self.is_unknown_type(Name(self.next().value))
            && self.diagnostics.len() < MAX_ERRORS
            && self.keyword_like(self.at).is_some_and(is_keyword)
    }

    fn jump(&mut self, kind: StmtKind) -> Parsed<StmtKind> {
        self.advance();
        self.semicolon()?;
        Ok(kind)
    }

    fn return_statement(&mut self) -> Parsed<StmtKind> {
        self.advance();
        let ends = matches!(self.peek(), TokenKind::Semicolon | TokenKind::RightBrace);
        let value = if ends {
            None
        } else {
            Some(self.root_expression()?)
        };
        self.semicolon()?;
        Ok(StmtKind::Return(value))
    }

    /// Parses `if (c) a else if (d) b else e`: a chain of any length, without recursion.
    fn if_statement(&mut self) -> Parsed<StmtId> {
        let mut arms = Vec::new();
        let mut last = None;
        loop {
            let first = self.advance();
            let condition = self.condition_in_parens("if")?;
            let then = self.body()?;
            arms.push((first, condition, then));
            if self.eat(TokenKind::Else).is_none() {
                break;
            }
            if !self.is(TokenKind::If) {
                last = Some(self.body()?);
                break;
            }
        }
        let mut otherwise = last;
        while let Some((first, condition, then)) = arms.pop() {
            otherwise = Some(self.push_stmt(
                StmtKind::If {
                    condition,
                    then,
                    otherwise,
                },
                first,
            ));
        }
        otherwise.ok_or(Reported)
    }

    /// Parses `( expression )`. If the expression cannot be parsed, skips the parentheses so that
    /// the body is still checked.
    fn condition_in_parens(&mut self, keyword: &str) -> Parsed<ExprId> {
        let open = self.id();
        self.expect(TokenKind::LeftParen, &format!("`(` after `{keyword}`"))?;
        let first = self.id();
        let condition = match self.root_expression() {
            Ok(condition) => condition,
            Err(Reported) => {
                self.skip_condition()?;
                return Ok(self.error_expr(first));
            }
        };
        self.close_head(open)?;
        Ok(condition)
    }

    /// Skips the rest of a condition including the `)`. A braced body may follow even if the `)` is
    /// missing.
    fn skip_condition(&mut self) -> Parsed<()> {
        self.skip_to_close();
        let is_closed = self.eat(TokenKind::RightParen).is_some();
        match is_closed || self.is(TokenKind::LeftBrace) {
            true => Ok(()),
            false => Err(Reported),
        }
    }

    /// Parses the body of an `if` or loop.
    fn body(&mut self) -> Parsed<StmtId> {
        if self.is(TokenKind::End) || self.is(TokenKind::RightBrace) {
            let d = self.error_here(error::SYNTAX_ERROR, "expected a statement");
            self.report(d);
            return Err(Reported);
        }
        self.enter()?;
        let body = self.statement_or_error();
        self.leave();
        Ok(body)
    }

    fn for_statement(&mut self) -> Parsed<StmtKind> {
        self.advance();
        let open = self.id();
        self.expect(TokenKind::LeftParen, "`(` after `for`")?;
        let mark = self.tree.exprs.len();
        match self.for_header(open) {
            Ok((init, condition, step)) => {
                let body = self.body()?;
                Ok(StmtKind::For {
                    init,
                    condition,
                    step,
                    body,
                })
            }
            Err(Reported) => {
                // The names it declares are unknown, so its body cannot be checked.
                self.tree.exprs.truncate(mark);
                self.skip_to_close();
                self.eat(TokenKind::RightParen).ok_or(Reported)?;
                if self.is(TokenKind::LeftBrace) {
                    self.skip_braces();
                }
                Ok(StmtKind::Error)
            }
        }
    }

    #[allow(clippy::type_complexity)]
    fn for_header(&mut self, open: TokenId) -> Parsed<(StmtId, Option<StmtId>, Option<ExprId>)> {
        let first = self.id();
        let init = if self.eat(TokenKind::Semicolon).is_some() {
            StmtKind::Empty
        } else if self.at_declaration() {
            StmtKind::Decl(self.declaration()?)
        } else {
            let expr = self.root_expression()?;
            self.expect(TokenKind::Semicolon, "`;` after the loop initializer")?;
            StmtKind::Expr(expr)
        };
        let init = self.push_stmt(init, first);
        let condition = if self.is(TokenKind::Semicolon) {
            None
        } else {
            Some(self.loop_condition()?)
        };
        self.expect(TokenKind::Semicolon, "`;` after the loop condition")?;
        let step = if self.is(TokenKind::RightParen) {
            None
        } else {
            Some(self.root_expression()?)
        };
        self.close_head(open)?;
        Ok((init, condition, step))
    }

    /// Parses an expression or `bool go = ...`.
    fn loop_condition(&mut self) -> Parsed<StmtId> {
        let first = self.id();
        let kind = if self.at_declaration() {
            StmtKind::Decl(self.condition_declaration()?)
        } else {
            StmtKind::Expr(self.root_expression()?)
        };
        Ok(self.push_stmt(kind, first))
    }

    fn while_statement(&mut self) -> Parsed<StmtKind> {
        self.advance();
        let open = self.id();
        self.expect(TokenKind::LeftParen, "`(` after `while`")?;
        let first = self.id();
        let condition = match self.loop_condition() {
            Ok(condition) => {
                self.close_head(open)?;
                condition
            }
            Err(Reported) => {
                self.skip_condition()?;
                let expr = self.error_expr(first);
                self.push_stmt(StmtKind::Expr(expr), first)
            }
        };
        let body = self.body()?;
        Ok(StmtKind::While { condition, body })
    }

    fn do_statement(&mut self) -> Parsed<StmtKind> {
        self.advance();
        let body = self.body()?;
        self.expect(TokenKind::While, "`while` after the `do` body")?;
        let condition = self.condition_in_parens("while")?;
        self.semicolon()?;
        Ok(StmtKind::Do { body, condition })
    }

    fn switch_statement(&mut self) -> Parsed<StmtKind> {
        self.advance();
        let selector = self.condition_in_parens("switch")?;
        let body = self.braces()?;
        Ok(StmtKind::Switch { selector, body })
    }
}
