//! The program as the checker knew it when it met a problem, from which messages are built.

use super::*;
use shaderlint_semantic::parsed::ParsedView;
use shaderlint_semantic::scope::{NameBindings, PastScopes};
use shaderlint_syntax::macro_uses;
use shaderlint_text::Role;
use std::cell::{Cell, RefCell};
use std::ops::Deref;

/// Most names, tokens and pairs of letters that are compared for suggestions, over all errors of a
/// shader.
const MAX_ADVICE: usize = 6_000_000;

/// The program at the moment of a problem.
pub(super) struct ExplainContext<'a> {
    parsed: ParsedView<'a>,
    program: &'a Program,
    scopes: PastScopes<'a>,
    pub exprs: &'a [ExprInfo],
    pub structs: &'a [Struct],
    pub variables: &'a [Variable],
    pub functions: &'a [Function],
    /// Return types by the first declaration, of functions that a later one declares differently.
    disputed: Vec<(FunctionId, Type)>,
    pub current: Option<FunctionRef>,
    pub root_expr: ExprId,
    pub expected: Option<Type>,
    /// Names and tokens that may still be searched for suggestions; starts at [`MAX_ADVICE`].
    advice: Cell<usize>,
    /// Places in macro calls and macro bodies that supply exactly what a fix changes.
    pub exact: RefCell<Vec<Span>>,
}

impl<'a> Deref for ExplainContext<'a> {
    type Target = ParsedView<'a>;

    fn deref(&self) -> &ParsedView<'a> {
        &self.parsed
    }
}

impl<'a> Typed<'a> for ExplainContext<'a> {
    fn exprs(&self) -> &[ExprInfo] {
        self.exprs
    }

    fn structs(&self) -> &[Struct] {
        self.structs
    }
}

impl<'a> ExplainContext<'a> {
    pub fn new(program: &'a Program, problems: &'a Problems) -> ExplainContext<'a> {
        let disputed = problems.all.iter().filter_map(|p| match p.what {
            ProblemKind::Function(FunctionError::ReturnType(known, _, other)) => {
                Some((program.function(known)?.declaration, other))
            }
            _ => None,
        });
        ExplainContext {
            disputed: disputed.collect(),
            parsed: ParsedView {
                sources: &program.sources,
                tokens: &program.tokens,
                names: &program.names,
                tree: &program.tree,
                version: program.version,
                stage: program.stage,
                dialect: program.dialect,
                context: program.context,
                builtins: program.builtins(),
            },
            program,
            scopes: PastScopes::new(&problems.scopes),
            exprs: &[],
            structs: &[],
            variables: &[],
            functions: &[],
            current: None,
            root_expr: ExprId(0),
            expected: None,
            advice: Cell::new(MAX_ADVICE),
            exact: RefCell::new(Vec::new()),
        }
    }

    /// Restores the state of the program at a moment.
    pub fn go_to(&mut self, moment: ProblemMoment) {
        fn first<T>(all: &[T], count: usize) -> &[T] {
            all.get(..count).unwrap_or(all)
        }
        let program = self.program;
        self.exprs = first(&program.exprs, moment.exprs);
        self.structs = first(&program.structs, moment.structs);
        self.variables = first(&program.variables, moment.variables);
        self.functions = first(&program.functions, moment.functions);
        self.current = moment.current;
        self.root_expr = moment.root_expr;
        self.expected = moment.expected;
        self.exact.borrow_mut().clear();
        self.scopes.go_to(moment.scopes);
    }

    /// Bindings of the names in scope.
    pub fn scopes(&self) -> &NameBindings {
        self.scopes.bindings()
    }

    pub fn at_global_scope(&self) -> bool {
        self.scopes().depth() == 0
    }

    /// The functions of the shader with this name.
    pub fn functions_named(&self, name: Name) -> impl Iterator<Item = &'a Function> {
        self.functions.iter().filter(move |f| f.name == name)
    }

    /// The return type of a function by its declarations so far.
    pub fn returns_of(&self, function: &Function) -> Type {
        let mut disputed = self.disputed.iter();
        let before = disputed.find(|(declaration, _)| *declaration == function.declaration);
        before.map_or(function.returns, |(_, ty)| *ty)
    }

    /// Whether this many names or tokens may still be searched for suggestions; counts them.
    pub fn affords(&self, looks: usize) -> bool {
        let left = self.advice.get().checked_sub(looks);
        self.advice.set(left.unwrap_or(0));
        left.is_some()
    }

    /// The token that declares a name.
    pub fn declaration_token(&self, name: Name, binding: Binding) -> Option<TokenId> {
        match binding {
            Binding::Variable(id) => self.variables.get(id.0 as usize)?.token,
            Binding::Struct(id) | Binding::Block(id) => {
                self.structs.get(id as usize).map(|s| s.token)
            }
            Binding::Function => {
                let function = self.functions_named(name).next()?;
                self.tree
                    .function(function.declaration)
                    .map(|f| f.ident.token)
            }
            Binding::Error => None,
        }
    }

    pub fn error(&self, kind: ErrorKind, extent: Extent, message: impl Into<String>) -> Diagnostic {
        let mut d = Diagnostic::error(kind, self.span(extent), message);
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

    pub fn error_at(
        &self,
        kind: ErrorKind,
        token: TokenId,
        message: impl Into<String>,
    ) -> Diagnostic {
        self.error(kind, Extent::token(token), message)
    }

    pub fn error_expr(
        &self,
        kind: ErrorKind,
        expr: ExprId,
        message: impl Into<String>,
    ) -> Diagnostic {
        self.error(kind, self.tree.expr(expr).extent, message)
    }

    /// Whether a span is in the user's text and cuts no macro call in two.
    pub fn is_editable(&self, span: Span) -> bool {
        let exact = self.exact.borrow();
        let is_exact = exact
            .iter()
            .any(|e| e.start <= span.start && span.end <= e.end);
        let tokens = &self.tokens.tokens;
        // Tokens are sorted by their position in the text that the user sees.
        let from = tokens.partition_point(|t| t.span.end <= span.start);
        let inside = tokens.get(from..).unwrap_or(&[]);
        let clean = inside
            .iter()
            .take_while(|t| t.span.start < span.end)
            .all(|t| t.is_direct() || span.contains(t.span));
        (clean || is_exact)
            && self
                .sources
                .file_at(span.start)
                .is_some_and(|f| f.role == Role::User)
    }

    /// Labels the declaration of a name in the user's text; notes one of the host or of GLSL.
    pub fn with_declaration(
        &self,
        d: Diagnostic,
        token: Option<TokenId>,
        what: &str,
    ) -> Diagnostic {
        match token {
            Some(token) if !self.is_prelude(token) => d.label(self.token_span(token), what),
            Some(_) => d.note(format!("declared by {}", self.dialect.host().called)),
            None => d.note("it is a GLSL built-in"),
        }
    }
}
