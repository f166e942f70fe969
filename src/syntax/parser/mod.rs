//! The parser: recursive descent, with operator precedence for expressions.
//!
//! It never fails. A statement or declaration that cannot be read becomes an `Error` node, one
//! error is reported for it, and reading goes on behind it. Names need no table: `Id Id` is a
//! declaration, whatever the first one means (so `mat mat;` works).

mod attempt;
mod balance;
mod correction;
mod declaration;
mod expression;
mod recovery;
mod reserved;
mod statement;

pub use correction::keyword_near;
pub use correction::{Choice, Correction};

use super::ast::*;
use super::names::{Name, Names, Version};
use super::preprocessor::{Tokens, macro_uses};
use super::search::Search;
use super::token::{Token, TokenKind};
use super::translation::{Translated, translate};
use correction::{Repairs, change_tokens};
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Facet, error};
use shaderlint_text::{Sources, Span};

/// Deepest nesting of statements and of expressions, parentheses not counted. The browser takes
/// trees of a depth up to 256.
const MAX_NESTING: u32 = 300;
/// Most parentheses around an expression; the browser's parser stack ends there.
const MAX_PARENS: u32 = 9_980;
/// Most errors that are looked for in one shader.
const MAX_ERRORS: usize = 200;

/// Tokens that the trials of one shader may read, beside some times its own.
const TRIAL_TOKENS: usize = 40_000;
/// Most that they may read.
const MAX_TRIAL_TOKENS: usize = 70_000;

/// Most places that cannot be read in a shader in which slips are looked for; one lost brace makes
/// many.
const MAX_BROKEN: usize = 80;

/// A shader as the parser understood it.
pub struct Parse {
    /// What was read.
    pub tree: Tree,
    /// What is wrong with the syntax.
    pub diagnostics: Vec<Diagnostic>,
    /// What was corrected so that it can be read; the first correction of each choice was made.
    pub choices: Vec<Choice>,
    /// The tokens before any correction, where there was one.
    pub original: Vec<Token>,
    /// What was put into GLSL before.
    pub translated: Translated,
    /// Whether a name stands in the place of a type that no struct before it has.
    has_unknown_types: bool,
}

/// How a shader is written.
#[derive(Clone, Copy)]
pub struct ParseOptions {
    /// The version that it states.
    pub version: Version,
    /// The stage, which the advice on `varying` needs.
    pub is_fragment: bool,
}

/// Parses what the preprocessor left of a shader.
///
/// Where that cannot be read, the forms of other languages are put into GLSL; where it still
/// cannot, the slips that explain it are searched for. `tokens` are what was probably meant.
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
    let broken = parse.diagnostics.iter().filter(|d| is_broken(d)).count();
    if broken == 0 || broken > MAX_BROKEN {
        return parse;
    }
    let translated = parse.translated;
    let original = std::mem::take(&mut tokens.tokens);
    let mut parser = Parser::new(sources, tokens, names, options, original.clone());
    let most = MAX_TRIAL_TOKENS.min(TRIAL_TOKENS + 4 * parser.tokens.len());
    search.within(most, |part| {
        std::mem::swap(part, &mut parser.repairs.search);
        parser.balance();
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

/// Parses with corrections that [`parse`] proposed, and makes no others. `tokens` become what is
/// meant under them.
pub fn parse_corrected(
    sources: &Sources,
    tokens: &mut Tokens,
    names: &Names,
    options: ParseOptions,
    corrections: &[&Correction],
) -> Parse {
    let mut list = std::mem::take(&mut tokens.tokens);
    let mut sorted = corrections.to_vec();
    // What is put in before a token comes before what happens to the token itself.
    sorted.sort_by_key(|c| (c.at, !c.is_insertion()));
    // Two alternatives may take out the same token, which is not there a second time.
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

/// The code at hand cannot be read; the error has been reported.
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
    /// The next token.
    at: usize,
    depth: u32,
    /// The `{` of the function that is being read.
    function_open: TokenId,
    /// The place behind the last statement that could not be read.
    behind_error: Option<usize>,
    /// Where a missing `}` was reported.
    missing_brace_at: Option<usize>,
    /// The first token that did not fit, since the statement at hand started.
    fault: Option<usize>,
    repairs: Repairs,
    /// Where the last item before the one at hand started.
    item_before: Option<Checkpoint>,
    /// The structs that were declared so far; nothing where not all is read.
    structs: Option<FxHashSet<Name>>,
    has_unknown_types: bool,
    tree: Tree,
    /// The arguments of all calls that are being read, the innermost call's last.
    open_args: Vec<ExprId>,
    /// The statements of all blocks that are being read, the innermost block's last.
    open_stmts: Vec<StmtId>,
    /// Reserved words that have been reported.
    reserved: Vec<Name>,
    diagnostics: Vec<Diagnostic>,
}

/// What a parser goes back to where it reads a statement again.
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
    behind_error: Option<usize>,
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
            behind_error: None,
            missing_brace_at: None,
            fault: None,
            repairs: Repairs::default(),
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
            behind_error: self.behind_error,
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
        self.behind_error = to.behind_error;
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

    /// The token before the next one.
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

    fn error_here(&self, kind: ErrorKind, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(kind, self.next().span, message)
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

/// What was appended to a list of the tree since it had a length of `start`.
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
