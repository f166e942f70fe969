//! The parser: recursive descent with operator precedence for expressions.
//!
//! It never fails. A statement or declaration that cannot be parsed becomes an `Error` node with
//! one reported error, and parsing continues after it. No symbol table is needed: `Id Id` is a
//! declaration whatever the first name means (so `mat mat;` works).

mod brace_repair;
mod correction;
mod declaration;
mod expression;
mod recovery;
mod reserved;
mod statement;
mod token_repair;

pub use correction::{Choice, Correction};
pub use correction::{has_same_letters, keyword_near};

use super::ast::*;
use super::names::{Name, Names, Version};
use super::preprocessor::{Tokens, macro_uses};
use super::search::Search;
use super::token::{Token, TokenKind};
use super::translation::{Translated, translate};
use correction::{Corrections, change_tokens};
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Facet, error};
use shaderlint_text::{Sources, Span};

/// Maximum nesting of statements and expressions, not counting parentheses. The browser accepts
/// trees up to a depth of 256.
const MAX_NESTING: u32 = 300;
/// Maximum nesting of parentheses around an expression, where the browser's parser stack overflows.
const MAX_PARENS: u32 = 9_980;
/// Maximum number of errors reported per shader.
const MAX_ERRORS: usize = 200;

/// Base token budget for trial parses of one shader; a multiple of its length is added.
const SPECULATIVE_TOKENS: usize = 40_000;
/// Upper limit of the token budget for trial parses.
const MAX_SPECULATIVE_TOKENS: usize = 70_000;

/// Maximum number of syntax errors for which corrections are searched; one missing brace causes
/// many.
const MAX_BROKEN_PLACES: usize = 80;

/// Result of parsing a shader.
pub struct Parse {
    /// The syntax tree.
    pub tree: Tree,
    /// Syntax errors.
    pub diagnostics: Vec<Diagnostic>,
    /// Corrections made to parse the shader; the first alternative of each choice was applied.
    pub choices: Vec<Choice>,
    /// The tokens before any correction; empty if there was none.
    pub original: Vec<Token>,
    /// Constructs of other languages that were translated to GLSL first.
    pub translated: Translated,
    /// Whether a type name does not refer to a preceding struct.
    has_unknown_types: bool,
}

/// Version and stage of a shader.
#[derive(Clone, Copy)]
pub struct ParseOptions {
    /// Version from the `#version` directive.
    pub version: Version,
    /// Whether this is a fragment shader; needed for advice on `varying`.
    pub is_fragment: bool,
}

/// Parses the output of the preprocessor.
///
/// If it has syntax errors, constructs of other languages are translated to GLSL; if errors remain,
/// corrections are searched. `tokens` becomes the token list that was parsed.
pub fn parse(
    sources: &Sources,
    tokens: &mut Tokens,
    names: &Names,
    options: ParseOptions,
    search: &mut Search,
) -> Parse {
    let mut parse = parse_corrected(sources, tokens, names, options, &[]);
    if (parse.has_unknown_types || parse.diagnostics.iter().any(|d| d.has(Facet::ForeignForm)))
        && let Some(found) = translate(sources, &tokens.tokens, options.version)
    {
        tokens.tokens = found.tokens;
        parse = parse_corrected(sources, tokens, names, options, &[]);
        parse.translated = found.translated;
        parse.tree.lost.extend(&parse.translated.lost);
    }
    let is_broken = |d: &Diagnostic| d.has(Facet::Grammar) || d.is(error::LOCAL_FUNCTION);
    let broken = || parse.diagnostics.iter().filter(|d| is_broken(d));
    // Where only functions are nested, the braces balance.
    let is_nested = broken().all(|d| d.is(error::LOCAL_FUNCTION));
    if is_nested || broken().count() > MAX_BROKEN_PLACES {
        return parse;
    }
    let translated = parse.translated;
    let original = std::mem::take(&mut tokens.tokens);
    let mut parser = Parser::new(sources, tokens, names, options, original.clone());
    let most = MAX_SPECULATIVE_TOKENS.min(SPECULATIVE_TOKENS + 4 * parser.tokens.len());
    search.within(most, |part| {
        std::mem::swap(part, &mut parser.repairs.search);
        parser.repair_braces();
        parser.translation_unit();
        std::mem::swap(part, &mut parser.repairs.search);
    });
    let (mut parse, list) = parser.finish();
    tokens.tokens = list;
    let corrected = parse.choices.iter().filter_map(|choice| choice.first());
    let corrected: Vec<_> = corrected.map(|c| c.diagnostic.clone()).collect();
    parse.diagnostics.extend(corrected);
    parse.original = original;
    parse.tree.lost.extend(&translated.lost);
    parse.translated = translated;
    parse
}

/// Parses with corrections proposed by [`parse`] and makes no others. `tokens` becomes the
/// corrected token list.
pub fn parse_corrected(
    sources: &Sources,
    tokens: &mut Tokens,
    names: &Names,
    options: ParseOptions,
    corrections: &[&Correction],
) -> Parse {
    let mut list = std::mem::take(&mut tokens.tokens);
    let mut sorted = corrections.to_vec();
    // Insertions before a token come before edits of the token itself.
    sorted.sort_by_key(|c| (c.at, !c.is_insertion()));
    // Two alternatives may remove the same token.
    sorted.dedup_by(|b, a| a.at == b.at && !a.is_insertion() && !b.is_insertion());
    for correction in sorted.iter().rev() {
        change_tokens(&mut list, correction.at, correction.change);
    }
    let mut parser = Parser::new(sources, tokens, names, options, list);
    parser.reserve();
    parser.translation_unit();
    let (mut parse, list) = parser.finish();
    tokens.tokens = list;
    let corrected = sorted.iter().map(|c| c.diagnostic.clone());
    parse.diagnostics.extend(corrected);
    parse
}

/// Parsing failed; the error has been reported.
#[derive(Clone, Copy, Debug)]
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    sources: &'a Sources,
    all: &'a Tokens,
    tokens: Vec<Token>,
    end: Token,
    names: &'a Names,
    version: Version,
    is_fragment: bool,
    /// Index of the next token.
    at: usize,
    depth: u32,
    /// Index of the `{` of the current function.
    function_open: TokenId,
    /// Index after the last statement that could not be parsed.
    after_error: Option<usize>,
    /// Index where a missing `}` was reported.
    missing_brace_at: Option<usize>,
    /// Index of the first unexpected token since the current statement started.
    fault: Option<usize>,
    repairs: Corrections,
    /// Start of the item before the current one.
    item_before: Option<Checkpoint>,
    /// Structs declared so far; `None` if only a part of the shader is parsed.
    structs: Option<FxHashSet<Name>>,
    has_unknown_types: bool,
    tree: Tree,
    /// Arguments of all open calls, the innermost call's last.
    open_args: Vec<ExprId>,
    /// Statements of all open blocks, the innermost block's last.
    open_stmts: Vec<StmtId>,
    /// Reserved words already reported.
    reserved: Vec<Name>,
    diagnostics: Vec<Diagnostic>,
}

/// Parser state restored before a statement is parsed again.
#[derive(Clone, Copy)]
struct Checkpoint {
    at: usize,
    depth: u32,
    exprs: usize,
    open_args: usize,
    lost: usize,
    reserved: usize,
    diagnostics: usize,
    items: usize,
    after_error: Option<usize>,
    missing_brace_at: Option<usize>,
}

impl<'a> Parser<'a> {
    fn new(
        sources: &'a Sources,
        all: &'a Tokens,
        names: &'a Names,
        options: ParseOptions,
        tokens: Vec<Token>,
    ) -> Parser<'a> {
        Parser {
            sources,
            all,
            end: tokens.last().copied().unwrap_or(Token::END),
            tokens,
            names,
            version: options.version,
            is_fragment: options.is_fragment,
            at: 0,
            depth: 0,
            function_open: 0,
            after_error: None,
            missing_brace_at: None,
            fault: None,
            repairs: Corrections::default(),
            item_before: None,
            structs: Some(FxHashSet::default()),
            has_unknown_types: false,
            tree: Tree::default(),
            open_args: Vec::new(),
            open_stmts: Vec::new(),
            reserved: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    fn finish(self) -> (Parse, Vec<Token>) {
        let parse = Parse {
            tree: self.tree,
            diagnostics: self.diagnostics,
            choices: self.repairs.choices,
            original: Vec::new(),
            translated: Translated::default(),
            has_unknown_types: self.has_unknown_types,
        };
        (parse, self.tokens)
    }

    fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            at: self.at,
            depth: self.depth,
            exprs: self.tree.exprs.len(),
            open_args: self.open_args.len(),
            lost: self.tree.lost.len(),
            reserved: self.reserved.len(),
            diagnostics: self.diagnostics.len(),
            items: self.tree.items.len(),
            after_error: self.after_error,
            missing_brace_at: self.missing_brace_at,
        }
    }

    fn go_back(&mut self, to: Checkpoint) {
        self.at = to.at;
        self.depth = to.depth;
        self.tree.exprs.truncate(to.exprs);
        self.open_args.truncate(to.open_args);
        self.tree.lost.truncate(to.lost);
        self.reserved.truncate(to.reserved);
        self.diagnostics.truncate(to.diagnostics);
        self.tree.items.truncate(to.items);
        self.after_error = to.after_error;
        self.missing_brace_at = to.missing_brace_at;
        self.fault = None;
    }

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

    /// Index of the token before the next one.
    fn last(&self) -> TokenId {
        self.at.saturating_sub(1) as TokenId
    }

    fn is(&self, kind: TokenKind) -> bool {
        self.peek() == kind
    }

    fn advance(&mut self) -> TokenId {
        let id = self.id();
        if !self.is(TokenKind::End) {
            self.at += 1;
        }
        id
    }

    fn eat(&mut self, kind: TokenKind) -> Option<TokenId> {
        self.is(kind).then(|| self.advance())
    }

    fn extent_from(&self, first: TokenId) -> Extent {
        Extent::new(first, self.last().max(first))
    }

    fn span(&self, extent: Extent) -> Span {
        self.token(extent.first as usize)
            .span
            .to(self.token(extent.last as usize).span)
    }

    fn token_span(&self, id: TokenId) -> Span {
        self.token(id as usize).span
    }

    /// The text of a token as it appears in the user's source.
    fn text(&self, token: &Token) -> &'a str {
        self.sources.text(token.span)
    }

    /// Enters one nesting level; reports an error if there are too many.
    fn enter(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth <= MAX_NESTING {
            return Ok(());
        }
        self.depth -= 1;
        let d = self.error_here(error::BROWSER_LIMIT, "code is nested too deeply");
        self.report(d.note("the browser accepts a nesting depth of at most 256"));
        Err(Reported)
    }

    fn leave(&mut self) {
        self.depth -= 1;
    }

    fn error_here(&self, kind: ErrorKind, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(kind, self.next().span, message)
    }

    /// Whether the error limit is reached, so that no further error needs to be located.
    fn has_many_errors(&self) -> bool {
        self.diagnostics.len() >= MAX_ERRORS
    }

    /// Reports an error at the next token.
    fn report(&mut self, diagnostic: Diagnostic) {
        let token = self.next();
        self.report_at(diagnostic, &token);
    }

    /// Reports an error at `token` with the macro calls that produced it.
    fn report_at(&mut self, mut diagnostic: Diagnostic, token: &Token) {
        if diagnostic.has(Facet::Grammar) && self.fault.is_none() {
            self.fault = Some(self.at);
        }
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

/// The entries added to a list since its length was `start`.
fn since<T>(all: &[T], start: usize) -> List {
    List {
        start: start as u32,
        len: (all.len() - start) as u32,
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
