//! The result of checking a shader, which is immutable, and what can be read off it.

pub(super) mod calls;
pub mod interface;
pub(super) mod late_values;
pub(super) mod mentions;
pub(super) mod reach;
mod static_use;
pub mod std140;
pub(super) mod structure;
pub(super) mod target;

use super::builtins::{BuiltinId, Builtins, Overload, Stage};
use super::constant::{Constant, Pool, Value};
use super::dialect::Dialect;
use super::types::{Base, Struct, Type, type_name};
use shaderlint_diagnostic::MacroUse;
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{
    GlContext, Macro, Name, Names, Token, TokenKind, Tokens, Version, macro_uses,
};
use shaderlint_text::{Sources, Span};
use std::sync::Arc;

/// Index of a [`Variable`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct VariableId(pub u32);

/// Index of a [`Function`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FunctionRef(pub u32);

/// Storage class of a variable.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Storage {
    /// Local variable of a function.
    Local,
    /// Global variable without a storage qualifier.
    Global,
    /// Parameter of a function.
    Param(Direction),
    /// `uniform`, including members of a uniform block without an instance name.
    Uniform,
    /// `in` variable; `attribute`, or `varying` in the fragment shader.
    Input,
    /// `out` variable; `varying` in the vertex shader.
    Output,
}

/// Direction of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Direction {
    /// `in` or no qualifier.
    In,
    /// `const in`
    ConstIn,
    /// `out`
    Out,
    /// `inout`
    Inout,
}

impl Direction {
    /// Whether the argument's value is read.
    pub const fn reads(self) -> bool {
        !matches!(self, Direction::Out)
    }

    /// Whether the argument is assigned.
    pub const fn writes(self) -> bool {
        matches!(self, Direction::Out | Direction::Inout)
    }

    /// The qualifier in source form.
    pub const fn name(self) -> &'static str {
        match self {
            Direction::In => "in",
            Direction::ConstIn => "const in",
            Direction::Out => "out",
            Direction::Inout => "inout",
        }
    }
}

/// A variable, parameter or named constant.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Declared name.
    pub name: Name,
    /// Declared type.
    pub ty: Type,
    /// Storage class.
    pub storage: Storage,
    /// Whether it was declared `const`.
    pub is_const: bool,
    /// Value, if it is a known constant.
    pub constant: Constant,
    /// Token that declares it; `None` for a built-in variable.
    pub token: Option<TokenId>,
    /// Function that declares it; `None` at global scope.
    pub function: Option<FunctionRef>,
    /// Variable of the same name in an outer scope.
    pub hides: Option<VariableId>,
    /// Whether it is assigned after its declaration.
    pub written: bool,
    /// Whether its value is read anywhere.
    pub read: bool,
}

/// A parameter of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parameter {
    /// Declared type.
    pub ty: Type,
    /// `in`, `out` or `inout`.
    pub direction: Direction,
}

/// A function that the shader declares.
#[derive(Clone, Debug)]
pub struct Function {
    /// Declared name.
    pub name: Name,
    /// Parameters in order.
    pub params: Vec<Parameter>,
    /// Return type.
    pub returns: Type,
    /// The first declaration.
    pub declaration: FunctionId,
    /// The declaration with the body.
    pub definition: Option<FunctionId>,
}

impl Function {
    /// Whether it is a test, as `shaderlint test` runs them: `bool test_*()`. Comments give values to
    /// its parameters.
    pub fn is_test(&self, names: &Names) -> bool {
        let is_called_so = names.text(self.name).starts_with("test_");
        is_called_so && self.has_only_inputs() && self.returns == Type::BOOL
    }

    /// Whether it is a benchmark of `shaderlint test`: `float bench_*()`, of any type.
    pub fn is_bench(&self, names: &Names) -> bool {
        names.text(self.name).starts_with("bench_") && self.has_only_inputs()
    }

    fn has_only_inputs(&self) -> bool {
        let is_input = |p: &Parameter| matches!(p.direction, Direction::In | Direction::ConstIn);
        self.params.iter().all(is_input)
    }
}

/// A call of a user-defined function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Call {
    /// Calling function; `None` at global scope.
    pub caller: Option<FunctionRef>,
    /// Called function.
    pub callee: FunctionRef,
    /// The call expression.
    pub expr: ExprId,
}

/// What a name or call refers to.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Resolution {
    /// Nothing to resolve, or not resolved.
    #[default]
    None,
    /// A variable.
    Variable(VariableId),
    /// A user-defined function.
    Function(FunctionRef),
    /// A built-in function: index of its overload in [`Builtins`].
    Builtin(u32),
    /// A struct constructor, by struct index.
    Struct(u32),
}

/// Type, value and resolution of an expression.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ExprInfo {
    /// Type of the value.
    pub ty: Type,
    /// Value, if it is known at compile time.
    pub constant: Constant,
    /// What the name or call refers to.
    pub resolution: Resolution,
    /// Height of the browser's tree below it, not counting folded constants.
    pub height: u16,
    /// Whether it is a constant expression (GLSL ES 3.00 section 4.3.3).
    pub is_const: bool,
}

// Size limit: there is one per expression.
const _: () = assert!(size_of::<ExprInfo>() <= 28);

impl ExprInfo {
    /// An expression with a reported error.
    pub const ERROR: ExprInfo = ExprInfo {
        ty: Type::ERROR,
        constant: Constant::NONE,
        resolution: Resolution::None,
        height: 0,
        // Avoids follow-up errors about constants.
        is_const: true,
    };

    /// An expression of a known type with a reported error.
    pub const fn wrong(ty: Type) -> ExprInfo {
        ExprInfo {
            ty,
            ..ExprInfo::ERROR
        }
    }
}

/// A checked shader.
pub struct Program {
    /// Files that make up the shader.
    pub sources: Arc<Sources>,
    /// Preprocessed tokens, macros and comments.
    pub tokens: Tokens,
    /// Interned words.
    pub names: Names,
    /// Syntax tree.
    pub tree: Tree,
    /// The version of the language.
    pub version: Version,
    /// The context that compiles it.
    pub context: GlContext,
    /// Vertex or fragment.
    pub stage: Stage,
    /// Host that runs it.
    pub dialect: Dialect,
    /// Results by [`ExprId`].
    pub exprs: Vec<ExprInfo>,
    /// Variables by [`VariableId`].
    pub variables: Vec<Variable>,
    /// Functions by [`FunctionRef`].
    pub functions: Vec<Function>,
    /// Structs and blocks by index.
    pub structs: Vec<Struct>,
    /// Calls of user-defined functions, in source order.
    pub calls: Vec<Call>,
    /// By index in [`Tree::declarator_lists`]: the variable that each declares.
    pub declared: Vec<Option<VariableId>>,
    /// By index in [`Tree::param_lists`]: the variable that each declares in a definition.
    pub declared_params: Vec<Option<VariableId>>,
    /// Values of constants.
    pub pool: Pool,
    /// Whether errors were found before type checking.
    pub(super) had_errors: bool,
}

impl Program {
    /// Number of tokens and macro calls.
    pub fn size(&self) -> usize {
        self.tokens.tokens.len() + self.tokens.expansions.len()
    }

    /// The built-in functions and variables that it can use.
    pub fn builtins(&self) -> Builtins {
        Builtins::of(self.version, self.stage).in_context(self.context, self.tokens.active)
    }

    /// Type, value and resolution of an expression.
    pub fn expr(&self, id: ExprId) -> &ExprInfo {
        self.exprs.get(id.0 as usize).unwrap_or(&ExprInfo::ERROR)
    }

    /// Type of an expression.
    pub fn ty(&self, id: ExprId) -> Type {
        self.expr(id).ty
    }

    /// The scalars of a constant expression; empty if the value is unknown.
    pub fn values(&self, id: ExprId) -> &[Value] {
        self.pool.values(self.expr(id).constant)
    }

    /// The value of a constant scalar expression.
    pub fn scalar(&self, id: ExprId) -> Option<Value> {
        self.pool.scalar(self.expr(id).constant)
    }

    /// The variable with this id; `None` if the id is not from this program.
    pub fn variable(&self, id: VariableId) -> Option<&Variable> {
        self.variables.get(id.0 as usize)
    }

    /// The variable that an expression refers to, ignoring parentheses.
    pub fn variable_of(&self, id: ExprId) -> Option<VariableId> {
        match self.expr(self.tree.unparen(id)).resolution {
            Resolution::Variable(id) => Some(id),
            _ => None,
        }
    }

    /// The function with this id; `None` if the id is not from this program.
    pub fn function(&self, id: FunctionRef) -> Option<&Function> {
        self.functions.get(id.0 as usize)
    }

    /// The built-in function that an expression calls.
    pub fn builtin_called(&self, id: ExprId) -> Option<BuiltinId> {
        self.overload_called(id).map(|o| o.function)
    }

    /// The overload of a built-in function that an expression calls.
    pub fn overload_called(&self, id: ExprId) -> Option<&'static Overload> {
        match self.expr(id).resolution {
            Resolution::Builtin(overload) => self.builtins().overload(overload),
            _ => None,
        }
    }

    /// The function that runs for each pixel or vertex: `main`, or ShaderToy's entry function.
    pub fn entry(&self) -> Option<FunctionRef> {
        let name = self.names.get(self.dialect.host().entry?.name)?;
        let is_entry = |f: &Function| f.definition.is_some() && f.name == name;
        let at = self.functions.iter().position(is_entry)?;
        Some(FunctionRef(at as u32))
    }

    /// The precision of a built-in variable.
    pub fn builtin_precision(&self, name: Name) -> Option<QualifierKind> {
        self.builtins().variable(self.names.text(name))?.precision
    }

    /// Whether a position is in the user's text rather than in text added by a host.
    pub fn is_user(&self, span: Span) -> bool {
        !span.is_empty() && self.sources.is_user(span.start)
    }

    /// The name by which the user's text refers to a variable: hosts define macros for their own.
    pub fn name_in_text(&self, variable: &Variable) -> &str {
        let declared = self.declared_at(variable);
        let is_theirs = declared.is_some_and(|span| !self.is_user(span));
        let is_name = |m: &&Macro| {
            let is_it = |t: &Token| t.kind == TokenKind::Identifier && t.value == variable.name.0;
            m.uses > 0 && matches!(m.body.as_slice(), [one] if is_it(&one.token))
        };
        let named = self
            .tokens
            .macros
            .iter()
            .find(is_name)
            .filter(|_| is_theirs);
        self.names.text(named.map_or(variable.name, |m| m.name))
    }

    /// Where the text declares a variable.
    pub fn declared_at(&self, variable: &Variable) -> Option<Span> {
        variable.token.and_then(|t| self.token(t)).map(|t| t.span)
    }

    /// The declarator of a variable; `None` for parameters and built-in variables.
    pub fn declarator_of(&self, variable: VariableId) -> Option<&Declarator> {
        let at = self.declared.iter().position(|d| *d == Some(variable))?;
        self.tree.declarator_lists.get(at)
    }

    /// The token with this id.
    pub fn token(&self, id: TokenId) -> Option<&Token> {
        self.tokens.tokens.get(id as usize)
    }

    /// Source span of a node in the user's text.
    pub fn span(&self, extent: Extent) -> Span {
        let of = |id| self.token(id).map_or(Span::default(), |t| t.span);
        of(extent.first).to(of(extent.last))
    }

    /// Source span of an expression in the user's text.
    pub fn expr_span(&self, id: ExprId) -> Span {
        self.span(self.tree.expr(id).extent)
    }

    /// Text of an expression in the user's source.
    pub fn expr_text(&self, id: ExprId) -> &str {
        self.sources.text(self.expr_span(id))
    }

    /// Whether all tokens of a node are in the user's text, outside any macro call.
    pub fn is_direct(&self, extent: Extent) -> bool {
        self.tokens.are_direct(extent.first, extent.last)
    }

    /// The macro calls that produced a token, innermost first.
    pub fn macros_at(&self, token: TokenId) -> Vec<MacroUse> {
        self.token(token).map_or(Vec::new(), |t| {
            macro_uses(&self.tokens.expansions, &self.tokens.macros, &self.names, t)
        })
    }

    /// A type in GLSL syntax.
    pub fn type_name(&self, ty: Type) -> String {
        type_name(ty, |id| struct_name(&self.structs, &self.names, id))
    }

    /// The struct of a type, ignoring arrays.
    pub fn struct_of(&self, ty: Type) -> Option<&Struct> {
        match ty.base {
            Base::Struct(id) | Base::Block(id) => self.structs.get(id as usize),
            _ => None,
        }
    }
}

/// Name of a struct for messages.
pub(super) fn struct_name(structs: &[Struct], names: &Names, id: u16) -> String {
    let name = structs.get(id as usize).and_then(|s| s.name);
    name.map_or("struct".to_string(), |n| names.text(n).to_string())
}

/// A program can be shared between threads.
const _: () = {
    const fn is_shared<T: Send + Sync + 'static>() {}
    is_shared::<Program>();
};
