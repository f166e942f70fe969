//! The type checker: one walk over the tree, in the order of the text.
//!
//! Expressions are checked in the order in which the tree stores them, children before parents,
//! without recursion. The result of an error has the error type, which is accepted everywhere, so
//! that each error is reported once.
//!
//! Each file has the checks of one area, and an enum of its errors. Their messages are in the file
//! of the same name in `explain/messages`.

mod calls;
mod candidate_type;
mod declarations;
mod expressions;
mod finish;
mod foreign;
mod limits;
mod names;
mod statement;
mod switch;
#[cfg(test)]
mod tests;
mod webgl1;

use super::builtins::{Builtins, Stage};
use super::constant::{Constant, Pool};
use super::dialect::{Channels, Dialect};
use super::parsed::{ParsedView, Typed};
use super::problem::{
    Aside, MAX_ERRORS, Problem, ProblemKind, ProblemMoment, Problems, SecondDeclaration,
};
use super::program::*;
use super::scope::{Binding, Scopes};
use super::types::*;
use super::typing::{self, Clash, Member, TypeMismatch};
use crate::BuiltinId;
pub use calls::CallError;
use candidate_type::{CandidateTypes, choose_types};
pub use declarations::array::ArrayError;
pub use declarations::declare::DeclarationError;
pub use declarations::entry::EntryError;
pub use declarations::function::FunctionError;
pub use declarations::interface::InterfaceError;
pub use declarations::layout::LayoutError;
pub use declarations::output::OutputError;
use declarations::qualifier::Precisions;
pub use declarations::qualifier::{QualifierError, StorageRequest};
pub use declarations::record::{RecordError, RecordKind};
pub use expressions::assign::ValueError;
pub use expressions::call::ArgumentError;
pub use expressions::expression::{ExpressionError, Indexed};
pub use expressions::place::{PlaceError, Writer};
use finish::LoopCheck;
pub use foreign::ForeignError;
pub use limits::LimitError;
pub use names::{NameError, Owner};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Feature, GlContext, Name, Names, Search, TokenKind, Tokens, Version};
use shaderlint_text::{Role, Sources, Span};
pub use statement::{Condition, StatementError};
use std::ops::Deref;
use std::sync::Arc;
pub use switch::SwitchError;
pub use webgl1::Restriction;

/// Most components that constant folding of binary operators processes in one shader.
const MAX_COMPARED: usize = 50_000_000;

/// A parsed shader: the input of the checker.
pub struct ParsedShader {
    /// The files of the shader, those of the host included.
    pub sources: Arc<Sources>,
    /// The tokens after preprocessing.
    pub tokens: Tokens,
    /// The interned identifiers.
    pub names: Names,
    /// The syntax tree.
    pub tree: Tree,
    /// The GLSL ES version of the shader.
    pub version: Version,
    /// The context that compiles it.
    pub context: GlContext,
    /// Whether the preprocessor or the parser reported errors.
    pub has_errors: bool,
    /// Number of errors after which checking stops.
    pub enough: usize,
}

/// Checks a parsed shader. `channels` overrides the types of `iChannel0` to `iChannel3`.
///
/// Returns the checked program and its problems.
pub fn check(
    parsed: ParsedShader,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
    search: &mut Search,
) -> (Program, Problems) {
    let run = |candidates, enough| look(&parsed, stage, dialect, channels, candidates, enough);
    let mut checker = run(CandidateTypes::default(), parsed.enough);
    if !checker.candidates.met.is_empty() {
        if checker.gave_up() {
            // Errors after a doubtful declaration may disappear once its type is chosen.
            checker = run(CandidateTypes::default(), MAX_ERRORS);
        }
        let met = std::mem::take(&mut checker.candidates.met);
        let standing = checker.problems.len();
        let candidates = choose_types(standing, &met, parsed.tree.exprs.len(), search, |d| {
            run(d.clone(), MAX_ERRORS).problems.len()
        });
        if !candidates.retyped.is_empty() {
            checker = run(candidates, parsed.enough);
        }
    }
    let mut all = checker.problems;
    all.truncate(MAX_ERRORS);
    let problems = Problems {
        all,
        scopes: checker.scopes.into_log(),
    };
    let program = Program {
        exprs: checker.exprs,
        variables: checker.variables,
        functions: checker.functions,
        structs: checker.structs,
        calls: checker.calls,
        declared: checker.declared,
        declared_params: checker.declared_params,
        pool: checker.pool,
        stage,
        dialect,
        sources: parsed.sources,
        version: parsed.version,
        context: parsed.context,
        had_errors: parsed.has_errors,
        tokens: parsed.tokens,
        names: parsed.names,
        tree: parsed.tree,
    };
    (program, problems)
}

/// One pass over a shader, with the given choices for doubtful declarations.
fn look(
    parsed: &ParsedShader,
    stage: Stage,
    dialect: Dialect,
    channels: Channels,
    candidates: CandidateTypes,
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
            context: parsed.context,
            builtins: Builtins::of(version, stage).in_context(parsed.context, parsed.tokens.active),
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
        root_expr: ExprId(0),
        expected: None,
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
        views: None,
        unknown_functions: FxHashSet::default(),
        always_true: FxHashSet::default(),
        returned: Type::VOID,
        returns_value: false,
        problems: Vec::new(),
        candidates,
    };
    for &name in &tree.lost {
        checker.scopes.declare(name, Binding::Error);
    }
    checker.items();
    checker.finish();
    checker
}

/// The kind of statement around another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum FlowKind {
    Block,
    If,
    Loop,
    Switch(Type),
}

/// An enclosing statement, with the state that the checks of loops and switches need.
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
    /// The first function with each hash of name and parameter types.
    by_signature: FxHashMap<u64, FunctionRef>,
    by_name: FxHashMap<Name, Vec<FunctionRef>>,
    /// The built-in function of each name; the outer `None` is a name that was not looked up yet.
    builtin_names: Vec<Option<Option<BuiltinId>>>,
    builtin_variables: FxHashMap<Name, VariableId>,
    current: Option<FunctionRef>,
    /// The root of the expression being checked, and the type that its context expects.
    root_expr: ExprId,
    expected: Option<Type>,
    /// Depth of the current statement in the browser's tree.
    level: u32,
    flow: Vec<Flow>,
    /// Undeclared names: the index of the problem that reports them, and the number of later uses.
    undeclared: FxHashMap<Name, (usize, u32)>,
    reported_names: FxHashSet<Name>,
    /// Components that constant folding of binary operators may still process.
    comparable: usize,
    /// Number of errors after which checking stops, at most [`MAX_ERRORS`].
    most_errors: usize,
    /// Types with a missing precision that was already reported.
    missing_precision: Vec<Base>,
    /// The last function in which a tree that is too deep was reported.
    deep_reported: Option<Option<FunctionRef>>,
    outputs: Vec<declarations::output::OutputVariable>,
    loops: Vec<LoopCheck>,
    private_size: u64,
    frag_color: Option<TokenId>,
    frag_data: Option<TokenId>,
    /// The number of views that a layout gives.
    views: Option<i32>,
    /// Functions that could not be declared; calls of them are not checked.
    unknown_functions: FxHashSet<Name>,
    /// Variables of type `bool` that are initialized with `true`.
    always_true: FxHashSet<VariableId>,
    /// The return type of the current function, and whether it has a `return` with a value.
    returned: Type,
    returns_value: bool,
    problems: Vec<Problem>,
    candidates: CandidateTypes,
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

    /// Whether enough errors were found to stop.
    pub(super) fn gave_up(&self) -> bool {
        self.problems.len() >= self.most_errors
    }

    pub(super) fn at_global_scope(&self) -> bool {
        self.scopes.depth() == 0
    }

    /// Reports a problem at `at`.
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
            root_expr: self.root_expr,
            expected: self.expected,
        };
        self.problems.push(Problem {
            at,
            what: what.into(),
            moment,
            asides: Vec::new(),
        });
    }

    /// Reports a problem of an expression.
    fn reject_expr(&mut self, id: ExprId, what: impl Into<ProblemKind>) {
        self.reject(self.tree.expr(id).extent, what);
    }

    /// Adds later information to a problem.
    fn add_aside(&mut self, problem: usize, aside: Aside) {
        if let Some(problem) = self.problems.get_mut(problem) {
            problem.asides.push(aside);
        }
    }
}
