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
mod problem;
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
use super::parsed::{ParsedView, Typed};
use super::program::*;
use super::scope::{Binding, ScopeLog, ScopeMark, Scopes};
use super::types::*;
use super::typing::{self, Clash, Member, Misfit};
use crate::BuiltinId;
pub(super) use array::ArrayError;
pub(super) use assign::ValueError;
pub(super) use call::ArgumentError;
pub(super) use calls::CallError;
pub(super) use declare::DeclarationError;
use doubt::{Doubts, settle};
pub(super) use entry::EntryError;
pub(super) use expression::{ExpressionError, Indexed};
use finish::LoopCheck;
pub(super) use foreign::ForeignError;
pub(super) use function::FunctionError;
pub(super) use interface::InterfaceError;
pub(super) use layout::LayoutError;
pub(super) use limits::LimitError;
pub(super) use names::{NameError, Owner};
pub(super) use output::OutputError;
pub(super) use place::{PlaceError, Writer};
pub(super) use problem::{Aside, Problem, ProblemKind, ProblemMoment, Problems, SecondDeclaration};
use qualifier::Precisions;
pub(super) use qualifier::{QualifierError, Wanted};
pub(super) use record::{Record, RecordError};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Feature, Name, Names, Search, TokenKind, Tokens, Version};
use shaderlint_text::{Role, Sources, Span};
pub(super) use statement::{Condition, StatementError};
use std::ops::Deref;
use std::sync::Arc;
pub(super) use switch::SwitchError;
pub(super) use webgl1::Restriction;

/// Most errors that are looked for in one shader.
pub(super) const MAX_ERRORS: usize = 200;
/// Most values that are computed from two constants in a shader.
const MAX_COMPARED: usize = 50_000_000;

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
    /// How many errors are enough: no more are looked for.
    pub enough: usize,
}

/// Checks a parsed shader. `channels` overrides the types of `iChannel0` to `iChannel3`.
///
/// Returns what is known of the shader and what is wrong with it.
pub fn check(
    parsed: Parsed,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
    search: &mut Search,
) -> (Program, Problems) {
    let run = |doubts, enough| look(&parsed, stage, dialect, channels, doubts, enough);
    let mut checker = run(Doubts::default(), parsed.enough);
    if !checker.doubts.met.is_empty() {
        if checker.gave_up() {
            // Errors behind a doubtful declaration may be gone when it is settled.
            checker = run(Doubts::default(), MAX_ERRORS);
        }
        let met = std::mem::take(&mut checker.doubts.met);
        let standing = checker.problems.len();
        let doubts = settle(standing, &met, parsed.tree.exprs.len(), search, |d| {
            run(d.clone(), MAX_ERRORS).problems.len()
        });
        if !doubts.retyped.is_empty() {
            checker = run(doubts, parsed.enough);
        }
    }
    let Checker {
        exprs,
        variables,
        functions,
        structs,
        calls,
        declared,
        declared_params,
        pool,
        mut problems,
        scopes,
        ..
    } = checker;
    problems.truncate(MAX_ERRORS);
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
    let problems = Problems {
        all: problems,
        scopes: scopes.into_log(),
    };
    (program, problems)
}

/// One look at a shader, by what is taken to be doubtful in it.
fn look(
    parsed: &Parsed,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
    doubts: Doubts,
    enough: usize,
) -> Checker<'_> {
    let (tree, version) = (&parsed.tree, parsed.version);
    let mut checker = Checker {
        parsed: ParsedView {
            sources: &parsed.sources,
            tokens: &parsed.tokens,
            names: &parsed.names,
            tree,
            version,
            stage,
            dialect,
            builtins: Builtins::of(version, stage),
        },
        channels,
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
        most_errors: enough.min(MAX_ERRORS),
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
        problems: Vec::new(),
        doubts,
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

struct Checker<'a> {
    parsed: ParsedView<'a>,
    channels: Channels,
    syntax_errors: bool,
    scopes: Scopes,
    precisions: Precisions,
    exprs: Vec<ExprInfo>,
    variables: Vec<Variable>,
    functions: Vec<Function>,
    structs: Vec<Struct>,
    calls: Vec<Call>,
    declared: Vec<Option<VariableId>>,
    declared_params: Vec<Option<VariableId>>,
    pool: Pool,
    /// By the hash of name and parameters, the first function that has it.
    by_signature: FxHashMap<u64, FunctionRef>,
    by_name: FxHashMap<Name, Vec<FunctionRef>>,
    /// By name: the built-in function, once it was looked up.
    builtin_names: Vec<Option<Option<BuiltinId>>>,
    builtin_variables: FxHashMap<Name, VariableId>,
    current: Option<FunctionRef>,
    /// The whole expression at hand, and the type that it should have.
    whole: ExprId,
    wanted: Option<Type>,
    /// Depth of the statement at hand in the browser's tree.
    level: u32,
    flow: Vec<Flow>,
    /// Undeclared names: the problem that speaks of them, and how often they were used since.
    undeclared: FxHashMap<Name, (usize, u32)>,
    reported_names: FxHashSet<Name>,
    /// How many values may still be computed from two constants.
    comparable: usize,
    /// How many errors are looked for.
    most_errors: usize,
    /// Types whose missing precision was reported.
    missing_precision: Vec<Base>,
    /// The function in which too deep a tree was reported.
    deep_reported: Option<Option<FunctionRef>>,
    outputs: Vec<output::Output>,
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
    problems: Vec<Problem>,
    doubts: Doubts,
}

impl<'a> Deref for Checker<'a> {
    type Target = ParsedView<'a>;

    fn deref(&self) -> &ParsedView<'a> {
        &self.parsed
    }
}

impl<'a> Typed<'a> for Checker<'a> {
    fn exprs(&self) -> &[ExprInfo] {
        &self.exprs
    }

    fn structs(&self) -> &[Struct] {
        &self.structs
    }
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
        self.problems.len() >= self.most_errors
    }

    pub(super) fn at_global_scope(&self) -> bool {
        self.scopes.depth() == 0
    }

    /// Reports what is wrong at a place.
    fn reject(&mut self, at: Extent, what: impl Into<ProblemKind>) {
        if self.gave_up() {
            return;
        }
        let moment = ProblemMoment {
            exprs: self.exprs.len(),
            variables: self.variables.len(),
            functions: self.functions.len(),
            structs: self.structs.len(),
            scopes: self.scopes.mark(),
            current: self.current,
            whole: self.whole,
            wanted: self.wanted,
        };
        self.problems.push(Problem {
            at,
            what: what.into(),
            moment,
            asides: Vec::new(),
        });
    }

    /// Reports what is wrong with an expression.
    fn reject_expr(&mut self, id: ExprId, what: impl Into<ProblemKind>) {
        self.reject(self.tree.expr(id).extent, what);
    }

    /// Adds to a problem what came to be known of it.
    fn add_aside(&mut self, problem: usize, aside: Aside) {
        if let Some(problem) = self.problems.get_mut(problem) {
            problem.asides.push(aside);
        }
    }
}
