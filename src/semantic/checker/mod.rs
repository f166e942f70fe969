//! The checker: one walk over the tree, in the order of the text.
//!
//! Expressions are checked in the order in which the tree stores them, children before parents,
//! without recursion. A mistake gives a type that fits everywhere, so that it is reported once.
//!
//! A file holds the rules on one thing, below an enum of what can be wrong with it. The words for
//! that are in the file of the same name in `explain`.

mod array;
mod assign;
mod binary;
mod call;
mod calls;
mod construct;
mod declare;
mod doubt;
mod entry;
mod expression;
mod finish;
mod foreign;
mod function;
mod interface;
mod kept;
mod layout;
mod limits;
mod names;
mod output;
mod place;
mod qualifier;
mod record;
mod statement;
mod switch;
#[cfg(test)]
mod tests;
mod webgl1;

use super::builtins::{Builtins, Stage};
use super::constant::{Constant, Pool};
use super::dialect::{Channels, Dialect};
use super::explain::Explain;
use super::program::*;
use super::scope::{Binding, Scopes};
use super::types::*;
use super::typing::{self, Member, Misfit, Types};
use crate::BuiltinId;
pub(super) use array::ArrayError;
pub(super) use calls::CallError;
pub(super) use declare::DeclarationError;
use doubt::{Doubts, settle};
pub(super) use entry::EntryError;
use finish::LoopCheck;
pub(super) use function::FunctionError;
pub(super) use interface::InterfaceError;
pub(super) use layout::LayoutError;
pub(super) use limits::LimitError;
pub(super) use names::{NameError, Owner};
pub(super) use output::OutputError;
pub(super) use place::{PlaceError, Writer};
use qualifier::Precisions;
pub(super) use qualifier::{QualifierError, Wanted};
pub(super) use record::{Record, RecordError};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::{Diagnostic, ErrorKind, error};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Feature, Name, Names, Token, TokenKind, Tokens, Version, macro_uses};
use shaderlint_text::{Role, Sources, Span};
pub(super) use statement::{Condition, StatementError};
use std::cell::Cell;
use std::sync::Arc;
pub(super) use switch::SwitchError;
pub(super) use webgl1::Restriction;

/// Most errors that are looked for in one shader.
const MAX_ERRORS: usize = 200;
/// Most values that are computed from two constants in a shader.
const MAX_COMPARED: usize = 50_000_000;
/// Most names, tokens and pairs of letters that are looked at for advice, over all errors of a shader.
const MAX_ADVICE: usize = 6_000_000;

/// A parsed shader, on its way to the checker.
pub struct Parsed {
    /// The files.
    pub sources: Arc<Sources>,
    /// The tokens.
    pub tokens: Tokens,
    /// The words.
    pub names: Names,
    /// The tree.
    pub tree: Tree,
    /// The version of the language.
    pub version: Version,
    /// Whether errors were found before.
    pub has_errors: bool,
    /// What it is checked for.
    pub goal: Goal,
}

/// What a shader is checked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Goal {
    /// To tell its errors, with advice such as the name that was probably meant: to look for it among
    /// all names takes longer than the check itself.
    Tell,
    /// To count its errors, as long as there are fewer than this.
    CountBelow(usize),
}

impl Goal {
    /// To count all that would be told.
    pub const COUNT: Goal = Goal::CountBelow(MAX_ERRORS);

    /// How many errors are enough.
    fn most_errors(self) -> usize {
        match self {
            Goal::Tell => MAX_ERRORS,
            Goal::CountBelow(count) => count.min(MAX_ERRORS),
        }
    }
}

/// Checks a parsed shader. `channels` overrides the types of `iChannel0` to `iChannel3`.
///
/// Returns what is known of the shader and what is wrong with it.
pub fn check(
    parsed: Parsed,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
) -> (Program, Vec<Diagnostic>) {
    let run = |doubts, goal| look(&parsed, stage, dialect, channels, doubts, goal);
    let mut checker = run(Doubts::default(), parsed.goal);
    if !checker.doubts.met.is_empty() {
        if checker.gave_up() {
            // Errors behind a doubtful declaration may be gone when it is settled.
            checker = run(Doubts::default(), Goal::COUNT);
        }
        let met = std::mem::take(&mut checker.doubts.met);
        let doubts = settle(
            checker.diagnostics.len(),
            &met,
            parsed.tree.exprs.len(),
            |d| run(d.clone(), Goal::COUNT).diagnostics.len(),
        );
        if !doubts.retyped.is_empty() {
            checker = run(doubts, parsed.goal);
        }
    }
    let mut diagnostics = std::mem::take(&mut checker.diagnostics);
    diagnostics.truncate(MAX_ERRORS);
    let Checker {
        exprs,
        variables,
        functions,
        structs,
        calls,
        declared,
        declared_params,
        pool,
        ..
    } = checker;
    let Parsed {
        sources,
        tokens,
        names,
        tree,
        version,
        has_errors,
        ..
    } = parsed;
    let program = Program {
        sources,
        version,
        stage,
        dialect,
        exprs,
        variables,
        functions,
        structs,
        calls,
        declared,
        declared_params,
        pool,
        had_errors: has_errors,
        tokens,
        names,
        tree,
    };
    (program, diagnostics)
}

/// One look at a shader, by what is taken to be doubtful in it.
fn look(
    parsed: &Parsed,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
    doubts: Doubts,
    goal: Goal,
) -> Checker<'_> {
    let (tree, version) = (&parsed.tree, parsed.version);
    let mut checker = Checker {
        sources: &parsed.sources,
        tokens: &parsed.tokens,
        names: &parsed.names,
        tree,
        version,
        stage,
        dialect,
        channels,
        builtins: Builtins::of(version, stage),
        syntax_errors: parsed.has_errors,
        scopes: Scopes::default(),
        precisions: Precisions::new(stage),
        exprs: Vec::with_capacity(tree.exprs.len()),
        variables: Vec::new(),
        functions: Vec::new(),
        structs: Vec::new(),
        calls: Vec::new(),
        declared: vec![None; tree.declarator_lists.len()],
        declared_params: vec![None; tree.param_lists.len()],
        pool: Pool::default(),
        by_signature: FxHashMap::default(),
        by_name: FxHashMap::default(),
        builtin_names: Vec::new(),
        builtin_variables: FxHashMap::default(),
        current: None,
        whole: ExprId(0),
        wanted: None,
        level: 0,
        flow: Vec::new(),
        undeclared: FxHashMap::default(),
        reported_names: FxHashSet::default(),
        most_errors: goal.most_errors(),
        advice: Cell::new(match goal {
            Goal::Tell => MAX_ADVICE,
            Goal::CountBelow(_) => 0,
        }),
        comparable: MAX_COMPARED,
        missing_precision: Vec::new(),
        deep_reported: None,
        outputs: Vec::new(),
        loops: Vec::new(),
        private_size: 0,
        frag_color: None,
        frag_data: None,
        unknown_functions: FxHashSet::default(),
        always_true: FxHashSet::default(),
        returned: Type::VOID,
        returns_value: false,
        diagnostics: Vec::new(),
        doubts,
        #[cfg(test)]
        rejected: Vec::new(),
    };
    for &name in &tree.lost {
        checker.scopes.declare(name, Binding::Error);
    }
    checker.items();
    checker.finish();
    checker
}

/// What a statement stands in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum FlowKind {
    Block,
    If,
    Loop,
    Switch(Type),
}

/// An open statement, with what the checks of loops and switches need.
struct Flow {
    kind: FlowKind,
    has_break: bool,
    has_return: bool,
    /// Labels of a switch; `None` is `default`.
    labels: FxHashMap<Option<i64>, TokenId>,
    /// The index of a WebGL1 loop, which its body must not change.
    loop_index: Option<VariableId>,
}

pub(super) struct Checker<'a> {
    pub(super) sources: &'a Sources,
    pub(super) tokens: &'a Tokens,
    pub(super) names: &'a Names,
    pub(super) tree: &'a Tree,
    pub(super) version: Version,
    pub(super) stage: Stage,
    pub(super) dialect: Dialect,
    channels: Channels,
    pub(super) builtins: &'static Builtins,
    syntax_errors: bool,
    pub(super) scopes: Scopes,
    precisions: Precisions,
    pub(super) exprs: Vec<ExprInfo>,
    pub(super) variables: Vec<Variable>,
    pub(super) functions: Vec<Function>,
    pub(super) structs: Vec<Struct>,
    calls: Vec<Call>,
    declared: Vec<Option<VariableId>>,
    declared_params: Vec<Option<VariableId>>,
    pool: Pool,
    /// By the hash of name and parameters, the first function that has it.
    by_signature: FxHashMap<u64, FunctionRef>,
    pub(super) by_name: FxHashMap<Name, Vec<FunctionRef>>,
    /// By name: the built-in function, once it was looked up.
    builtin_names: Vec<Option<Option<BuiltinId>>>,
    builtin_variables: FxHashMap<Name, VariableId>,
    pub(super) current: Option<FunctionRef>,
    /// The whole expression at hand, and the type that it should have.
    pub(super) whole: ExprId,
    pub(super) wanted: Option<Type>,
    /// Depth of the statement at hand in the browser's tree.
    level: u32,
    flow: Vec<Flow>,
    /// Undeclared names: the diagnostic that speaks of them, and how often they were used since.
    undeclared: FxHashMap<Name, (usize, u32)>,
    reported_names: FxHashSet<Name>,
    /// How many values may still be computed from two constants.
    comparable: usize,
    /// How many errors are looked for.
    most_errors: usize,
    /// What may still be spent on looking through all names or tokens for advice on an error.
    advice: Cell<usize>,
    /// Types whose missing precision was reported.
    missing_precision: Vec<Base>,
    /// The function in which too deep a tree was reported.
    deep_reported: Option<Option<FunctionRef>>,
    pub(super) outputs: Vec<output::Output>,
    loops: Vec<LoopCheck>,
    private_size: u64,
    frag_color: Option<TokenId>,
    frag_data: Option<TokenId>,
    /// Functions that could not be declared; calls of them are not judged.
    unknown_functions: FxHashSet<Name>,
    /// Variables that start as true.
    always_true: FxHashSet<VariableId>,
    /// What the function at hand returns, and whether a `return` with a value was seen in it.
    returned: Type,
    returns_value: bool,
    diagnostics: Vec<Diagnostic>,
    doubts: Doubts,
    /// What was wrong, before words were made of it.
    #[cfg(test)]
    rejected: Vec<String>,
}

impl<'a> Checker<'a> {
    fn items(&mut self) {
        let tree = self.tree;
        for item in &tree.items {
            if self.gave_up() {
                return;
            }
            match *item {
                Item::Function(id) => self.function_definition(id),
                Item::Decl(id) => self.declaration(id),
            }
        }
    }

    /// Whether so much is wrong that looking on is of no use.
    pub(super) fn gave_up(&self) -> bool {
        self.diagnostics.len() >= self.most_errors
    }

    /// Whether so many names or tokens may still be looked through for advice on an error.
    pub(super) fn affords(&self, looks: usize) -> bool {
        let left = self.advice.get().checked_sub(looks);
        self.advice.set(left.unwrap_or(0));
        left.is_some()
    }

    /// What types mean in this shader.
    pub(super) fn types(&self) -> Types<'_> {
        Types {
            structs: &self.structs,
            version: self.version,
        }
    }

    /// Whether the version of the language has something.
    pub(super) fn has(&self, feature: Feature) -> bool {
        self.version.has(feature)
    }

    pub(super) fn at_global_scope(&self) -> bool {
        self.scopes.depth() == 0
    }

    pub(super) fn text(&self, name: Name) -> &'a str {
        self.names.text(name)
    }

    pub(super) fn token(&self, id: TokenId) -> Token {
        let tokens = &self.tokens.tokens;
        tokens
            .get(id as usize)
            .or(tokens.last())
            .copied()
            .unwrap_or(Token {
                kind: TokenKind::End,
                value: 0,
                span: Span::default(),
                spelled: 0,
                expansion: Token::DIRECT,
            })
    }

    pub(super) fn token_span(&self, id: TokenId) -> Span {
        self.span(Extent::token(id))
    }

    /// Where code stands: in a macro's definition, if its body supplied all of it.
    pub(super) fn span(&self, extent: Extent) -> Span {
        self.tokens.place(self.sources, extent.first, extent.last)
    }

    pub(super) fn expr_span(&self, id: ExprId) -> Span {
        self.span(self.tree.expr(id).extent)
    }

    pub(super) fn expr_text(&self, id: ExprId) -> &'a str {
        self.sources.text(self.expr_span(id))
    }

    pub(super) fn info(&self, id: ExprId) -> ExprInfo {
        self.exprs
            .get(id.0 as usize)
            .copied()
            .unwrap_or(ExprInfo::ERROR)
    }

    pub(super) fn ty(&self, id: ExprId) -> Type {
        self.info(id).ty
    }

    pub(super) fn name_of(&self, ty: Type) -> String {
        type_name(ty, |id| {
            super::program::struct_name(&self.structs, self.names, id)
        })
    }

    /// Whether all tokens of a node stand in the text just so, outside any macro call.
    pub(super) fn is_direct(&self, extent: Extent) -> bool {
        let tokens = self
            .tokens
            .tokens
            .get(extent.first as usize..=extent.last as usize);
        tokens.is_some_and(|all| all.iter().all(Token::is_direct))
    }

    /// Whether a token stands in text that a host put before the user's.
    pub(super) fn is_prelude(&self, token: TokenId) -> bool {
        let span = self.token_span(token);
        self.sources
            .file_at(span.start)
            .is_some_and(|f| f.role == Role::Prelude)
    }

    pub(super) fn error(
        &self,
        rule: ErrorKind,
        extent: Extent,
        message: impl Into<String>,
    ) -> Diagnostic {
        let mut d = Diagnostic::error(rule, self.span(extent), message);
        let first = self.token(extent.first);
        let token = if first.is_direct() {
            self.token(extent.last)
        } else {
            first
        };
        d.macros = macro_uses(
            &self.tokens.expansions,
            &self.tokens.macros,
            self.names,
            &token,
        );
        d
    }

    pub(super) fn error_at(
        &self,
        rule: ErrorKind,
        token: TokenId,
        message: impl Into<String>,
    ) -> Diagnostic {
        self.error(rule, Extent::token(token), message)
    }

    pub(super) fn error_expr(
        &self,
        rule: ErrorKind,
        expr: ExprId,
        message: impl Into<String>,
    ) -> Diagnostic {
        self.error(rule, self.tree.expr(expr).extent, message)
    }

    /// Reports what is wrong at a place, in the words that `explain` has for it.
    pub(super) fn reject(&mut self, at: Extent, problem: impl Explain) {
        #[cfg(test)]
        self.rejected.push(format!("{problem:?}"));
        let d = problem.explain(self, at);
        self.report(d);
    }

    /// Reports an error. A fix whose edits do not stand in the user's own text just so is dropped.
    pub(super) fn report(&mut self, mut diagnostic: Diagnostic) {
        if let Some(fix) = &diagnostic.fix
            && fix.edits.iter().any(|e| !self.is_editable(e.span))
        {
            diagnostic.fix = None;
        }
        if !self.gave_up() {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Whether the text under a span is the user's, and no macro call stands there that would be
    /// torn apart.
    pub(super) fn is_editable(&self, span: Span) -> bool {
        let tokens = &self.tokens.tokens;
        // Tokens are in the order of the text, as each stands where the user sees it.
        let from = tokens.partition_point(|t| t.span.end <= span.start);
        let inside = tokens.get(from..).unwrap_or(&[]);
        let clean = inside
            .iter()
            .take_while(|t| t.span.start < span.end)
            .all(|t| t.is_direct() || span.contains(t.span));
        clean
            && self
                .sources
                .file_at(span.start)
                .is_some_and(|f| f.role == Role::User)
    }

    /// Adds "declared here" where the user's own text declares a name.
    pub(super) fn with_declaration(
        &self,
        d: Diagnostic,
        token: Option<TokenId>,
        what: &str,
    ) -> Diagnostic {
        match token {
            Some(token) if !self.is_prelude(token) => d.label(self.token_span(token), what),
            Some(_) => d.note(format!("{} declares it", self.dialect.host().called)),
            None => d.note("the language declares it"),
        }
    }
}
