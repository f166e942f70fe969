//! The parser: recursive descent, with operator precedence for expressions.
//!
//! It never fails. A statement or declaration that cannot be read becomes an `Error` node, one
//! error is reported for it, and reading goes on behind it. Names need no table: `Id Id` is a
//! declaration, whatever the first one means (so `mat mat;` works).

mod declaration;
mod expression;
mod recovery;
mod reserved;
mod statement;

use super::ast::*;
use super::names::{Name, Names, Version};
use super::preprocessor::{Tokens, macro_uses};
use super::token::{Token, TokenKind};
use crate::diagnostic::{Diagnostic, error};
use crate::text::{Sources, Span};

/// Deepest nesting of statements and of expressions, parentheses not counted. The browser takes
/// trees of a depth up to 256.
const MAX_NESTING: u32 = 300;
/// Most parentheses around an expression; the browser's parser stack ends there.
const MAX_PARENS: usize = 9_980;
/// Most errors that are looked for in one shader.
const MAX_ERRORS: usize = 200;

/// Parses what the preprocessor left of a shader.
///
/// `is_fragment` tells the stage, which the advice on `varying` needs. Returns the tree and what is
/// wrong with the syntax.
pub fn parse(
    sources: &Sources,
    tokens: &Tokens,
    names: &Names,
    version: Version,
    is_fragment: bool,
) -> (Tree, Vec<Diagnostic>) {
    let end = Token {
        kind: TokenKind::End,
        value: 0,
        span: Span::default(),
        spelled: 0,
        expansion: Token::DIRECT,
    };
    let mut parser = Parser {
        sources,
        all: tokens,
        tokens: &tokens.tokens,
        end: tokens.tokens.last().copied().unwrap_or(end),
        names,
        version,
        is_fragment,
        at: 0,
        depth: 0,
        function_open: 0,
        behind_error: None,
        missing_brace_at: None,
        tree: Tree::default(),
        open_args: Vec::new(),
        reserved: Vec::new(),
        diagnostics: Vec::new(),
    };
    parser.reserve();
    parser.translation_unit();
    (parser.tree, parser.diagnostics)
}

/// The code at hand cannot be read; the error has been reported.
#[derive(Clone, Copy, Debug)]
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    sources: &'a Sources,
    all: &'a Tokens,
    tokens: &'a [Token],
    end: Token,
    names: &'a Names,
    version: Version,
    is_fragment: bool,
    /// The next token.
    at: usize,
    depth: u32,
    /// The `{` of the function that is being read.
    function_open: TokenId,
    /// The place behind the last statement that could not be read.
    behind_error: Option<usize>,
    /// Where a missing `}` was reported.
    missing_brace_at: Option<usize>,
    tree: Tree,
    /// The arguments of all calls that are being read, the innermost call's last.
    open_args: Vec<ExprId>,
    /// Reserved words that have been reported.
    reserved: Vec<Name>,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Parser<'a> {
    fn reserve(&mut self) {
        self.tree.exprs.reserve(self.tokens.len());
        self.tree.stmts.reserve(self.tokens.len() / 8);
    }

    fn token(&self, id: usize) -> Token {
        self.tokens.get(id).copied().unwrap_or(self.end)
    }

    fn kind(&self, ahead: usize) -> TokenKind {
        self.tokens
            .get(self.at + ahead)
            .map_or(TokenKind::End, |t| t.kind)
    }

    fn peek(&self) -> TokenKind {
        self.kind(0)
    }

    fn next(&self) -> Token {
        self.token(self.at)
    }

    fn id(&self) -> TokenId {
        self.at as TokenId
    }

    /// The token before the next one.
    fn last(&self) -> TokenId {
        self.at.saturating_sub(1) as TokenId
    }

    fn is(&self, kind: TokenKind) -> bool {
        self.peek() == kind
    }

    fn advance(&mut self) -> TokenId {
        let id = self.id();
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        id
    }

    fn eat(&mut self, kind: TokenKind) -> Option<TokenId> {
        self.is(kind).then(|| self.advance())
    }

    fn extent_from(&self, first: TokenId) -> Extent {
        Extent {
            first,
            last: self.last().max(first),
        }
    }

    fn span(&self, extent: Extent) -> Span {
        self.token(extent.first as usize)
            .span
            .to(self.token(extent.last as usize).span)
    }

    fn token_span(&self, id: TokenId) -> Span {
        self.token(id as usize).span
    }

    /// The text of a token as the user sees it.
    fn text(&self, token: &Token) -> &'a str {
        self.sources.text(token.span)
    }

    /// Counts one level of nesting; reports and gives up where there are too many.
    fn enter(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth <= MAX_NESTING {
            return Ok(());
        }
        self.depth -= 1;
        let d = self.error_here(error::BROWSER_LIMIT, "this is nested too deeply");
        self.report(d.note("the browser takes code up to a depth of 256"));
        Err(Reported)
    }

    fn leave(&mut self) {
        self.depth -= 1;
    }

    fn error_here(&self, rule: &'static str, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(rule, self.next().span, message)
    }

    /// Whether no further error is reported, so that none needs its place to be looked for.
    fn has_many_errors(&self) -> bool {
        self.diagnostics.len() >= MAX_ERRORS
    }

    /// Reports an error at the next token.
    fn report(&mut self, diagnostic: Diagnostic) {
        let token = self.next();
        self.report_at(diagnostic, &token);
    }

    /// Reports an error at `token`, with the macros that the token came through.
    fn report_at(&mut self, mut diagnostic: Diagnostic, token: &Token) {
        if self.has_many_errors() {
            return;
        }
        diagnostic.macros = macro_uses(&self.all.expansions, &self.all.macros, self.names, token);
        if !token.is_direct() {
            diagnostic.fix = None;
        }
        self.diagnostics.push(diagnostic);
    }

    fn push_expr(&mut self, kind: ExprKind, extent: Extent) -> ExprId {
        self.tree.exprs.push(Expr { kind, extent });
        ExprId(self.tree.exprs.len() as u32 - 1)
    }

    fn push_stmt(&mut self, kind: StmtKind, first: TokenId) -> StmtId {
        let extent = self.extent_from(first);
        self.tree.stmts.push(Stmt { kind, extent });
        StmtId(self.tree.stmts.len() as u32 - 1)
    }
}

/// Appends `entries` to a list of the tree.
fn append<T>(all: &mut Vec<T>, entries: impl IntoIterator<Item = T>) -> List {
    let start = all.len() as u32;
    all.extend(entries);
    List {
        start,
        len: all.len() as u32 - start,
    }
}
