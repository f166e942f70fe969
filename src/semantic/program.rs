//! What is known of a shader once it has been checked. Nothing in it ever changes.

use super::builtins::{BuiltinId, Builtins, Overload, Stage};
use super::constant::{Constant, Pool, Value};
use super::dialect::Dialect;
use super::types::{Base, Struct, Type, type_name};
use shaderlint_diagnostic::MacroUse;
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Name, Names, Token, Tokens, Version, macro_uses};
use shaderlint_text::{Sources, Span};
use std::sync::Arc;

/// Index of a [`Variable`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct VariableId(pub u32);

/// Index of a [`Function`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FunctionRef(pub u32);

/// Where a variable lives and who may write to it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Storage {
    /// Declared in a function.
    Local,
    /// Declared at global scope.
    Global,
    /// A parameter.
    Param(Direction),
    /// `uniform`, a member of a nameless uniform block included.
    Uniform,
    /// `in` of the stage; `attribute`, `varying` in the fragment shader.
    Input,
    /// `out` of the stage; `varying` in the vertex shader.
    Output,
}

/// How a parameter passes values.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Direction {
    /// `in`, or nothing.
    In,
    /// `const in`
    ConstIn,
    /// `out`
    Out,
    /// `inout`
    Inout,
}

impl Direction {
    /// Whether the caller's value is read.
    pub const fn reads(self) -> bool {
        !matches!(self, Direction::Out)
    }

    /// Whether the caller's variable is written to.
    pub const fn writes(self) -> bool {
        matches!(self, Direction::Out | Direction::Inout)
    }

    /// As it is written.
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
    /// Its name.
    pub name: Name,
    /// Its type.
    pub ty: Type,
    /// Where it lives.
    pub storage: Storage,
    /// Whether it was declared `const`.
    pub is_const: bool,
    /// Its value, if it is a constant.
    pub constant: Constant,
    /// The token that declares it; `None` for what the language defines.
    pub token: Option<TokenId>,
    /// The function that it belongs to.
    pub function: Option<FunctionRef>,
    /// The variable of an outer scope that has the same name.
    pub hides: Option<VariableId>,
    /// Whether anything writes to it after its declaration.
    pub written: bool,
    /// Whether anything reads it.
    pub read: bool,
}

/// A parameter of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parameter {
    /// Its type.
    pub ty: Type,
    /// How it passes values.
    pub direction: Direction,
}

/// A function that the shader declares.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Name,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// What it returns.
    pub returns: Type,
    /// The first declaration.
    pub declaration: FunctionId,
    /// The declaration with the body.
    pub definition: Option<FunctionId>,
}

impl Function {
    /// Whether it is a test, as `shaderlint test` runs them: `bool test_*()`.
    pub fn is_test(&self, names: &Names) -> bool {
        let is_called_so = names.text(self.name).starts_with("test_");
        is_called_so && self.params.is_empty() && self.returns == Type::BOOL
    }
}

/// A call of one of the shader's functions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Call {
    /// The function that calls; `None` at global scope.
    pub caller: Option<FunctionRef>,
    /// The function that is called.
    pub callee: FunctionRef,
    /// The call.
    pub expr: ExprId,
}

/// What a name or call stands for.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Resolution {
    /// Nothing to resolve, or nothing found.
    #[default]
    None,
    /// A variable.
    Variable(VariableId),
    /// A function of the shader.
    Function(FunctionRef),
    /// A built-in function: the number of its overload in [`Builtins`].
    Builtin(u32),
    /// The constructor of a struct, by its number.
    Struct(u32),
}

/// What is known of an expression.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ExprInfo {
    /// Its type.
    pub ty: Type,
    /// Its value, if it is known.
    pub constant: Constant,
    /// What it stands for.
    pub resolution: Resolution,
    /// How deep the browser's tree below it is, folded constants not counted.
    pub height: u16,
    /// Whether it is a constant expression (GLSL ES 3.00 section 4.3.3).
    pub is_const: bool,
}

// Every expression has one.
const _: () = assert!(size_of::<ExprInfo>() <= 28);

impl ExprInfo {
    /// An expression that was reported.
    pub const ERROR: ExprInfo = ExprInfo {
        ty: Type::ERROR,
        constant: Constant::NONE,
        resolution: Resolution::None,
        height: 0,
        // Nothing more is said of it, so it passes for a constant too.
        is_const: true,
    };
}

/// A checked shader.
pub struct Program {
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
    /// The stage.
    pub stage: Stage,
    /// Who runs it.
    pub dialect: Dialect,
    /// By [`ExprId`].
    pub exprs: Vec<ExprInfo>,
    /// All variables.
    pub variables: Vec<Variable>,
    /// All functions.
    pub functions: Vec<Function>,
    /// All structs and blocks.
    pub structs: Vec<Struct>,
    /// All calls of the shader's functions, in the order of the text.
    pub calls: Vec<Call>,
    /// By the order of [`Tree::declarator_lists`]: the variable that each declares.
    pub declared: Vec<Option<VariableId>>,
    /// By the order of [`Tree::param_lists`]: the variable that each declares in a definition.
    pub declared_params: Vec<Option<VariableId>>,
    /// The values of constants.
    pub pool: Pool,
    /// Whether errors were found before the types were looked at.
    pub(super) had_errors: bool,
}

impl Program {
    /// How many tokens and macro calls it has.
    pub fn size(&self) -> usize {
        self.tokens.tokens.len() + self.tokens.expansions.len()
    }

    /// What is known of an expression.
    pub fn expr(&self, id: ExprId) -> &ExprInfo {
        self.exprs.get(id.0 as usize).unwrap_or(&ExprInfo::ERROR)
    }

    /// Type of an expression.
    pub fn ty(&self, id: ExprId) -> Type {
        self.expr(id).ty
    }

    /// The scalars of a constant expression; empty where the value is not known.
    pub fn values(&self, id: ExprId) -> &[Value] {
        self.pool.values(self.expr(id).constant)
    }

    /// The value of a constant scalar expression.
    pub fn scalar(&self, id: ExprId) -> Option<Value> {
        self.pool.scalar(self.expr(id).constant)
    }

    /// A variable, if the number is this program's.
    pub fn variable(&self, id: VariableId) -> Option<&Variable> {
        self.variables.get(id.0 as usize)
    }

    /// The variable that an expression names, parentheses aside.
    pub fn variable_of(&self, id: ExprId) -> Option<VariableId> {
        match self.expr(self.tree.unparen(id)).resolution {
            Resolution::Variable(id) => Some(id),
            _ => None,
        }
    }

    /// A function, if the number is this program's.
    pub fn function(&self, id: FunctionRef) -> Option<&Function> {
        self.functions.get(id.0 as usize)
    }

    /// The built-in function that an expression calls.
    pub fn builtin_called(&self, id: ExprId) -> Option<BuiltinId> {
        self.overload_called(id).map(|o| o.function)
    }

    /// The form of a built-in function that an expression calls.
    pub fn overload_called(&self, id: ExprId) -> Option<&'static Overload> {
        match self.expr(id).resolution {
            Resolution::Builtin(overload) => {
                Builtins::of(self.version, self.stage).overload(overload)
            }
            _ => None,
        }
    }

    /// The function that runs for each pixel or vertex: `mainImage` and its kin, or `main`.
    pub fn entry(&self) -> Option<FunctionRef> {
        let name = self.names.get(self.dialect.host().entry?.name)?;
        let is_entry = |f: &Function| f.definition.is_some() && f.name == name;
        let at = self.functions.iter().position(is_entry)?;
        Some(FunctionRef(at as u32))
    }

    /// The precision that the language gives one of its own variables.
    pub fn builtin_precision(&self, name: Name) -> Option<QualifierKind> {
        Builtins::of(self.version, self.stage)
            .variable(self.names.text(name))?
            .precision
    }

    /// Whether a place is in the user's text, and not in what a host puts around it.
    pub fn is_user(&self, span: Span) -> bool {
        !span.is_empty() && self.sources.is_user(span.start)
    }

    /// Where the name of a variable stands that the text declares.
    pub fn declared_at(&self, variable: &Variable) -> Option<Span> {
        variable.token.and_then(|t| self.token(t)).map(|t| t.span)
    }

    /// What declares a variable; `None` for a parameter and for what the language defines.
    pub fn declarator_of(&self, variable: VariableId) -> Option<&Declarator> {
        let at = self.declared.iter().position(|d| *d == Some(variable))?;
        self.tree.declarator_lists.get(at)
    }

    /// A token.
    pub fn token(&self, id: TokenId) -> Option<&Token> {
        self.tokens.tokens.get(id as usize)
    }

    /// Where a node stands, as the user sees it.
    pub fn span(&self, extent: Extent) -> Span {
        let of = |id| self.token(id).map_or(Span::default(), |t| t.span);
        of(extent.first).to(of(extent.last))
    }

    /// Where an expression stands.
    pub fn expr_span(&self, id: ExprId) -> Span {
        self.span(self.tree.expr(id).extent)
    }

    /// The text of an expression as the user sees it.
    pub fn expr_text(&self, id: ExprId) -> &str {
        self.sources.text(self.expr_span(id))
    }

    /// Whether all tokens of a node stand in the user's text just so, outside any macro call.
    pub fn is_direct(&self, extent: Extent) -> bool {
        self.tokens.are_direct(extent.first, extent.last)
    }

    /// The macro calls that a token came through, innermost first.
    pub fn macros_at(&self, token: TokenId) -> Vec<MacroUse> {
        self.token(token).map_or(Vec::new(), |t| {
            macro_uses(&self.tokens.expansions, &self.tokens.macros, &self.names, t)
        })
    }

    /// A type as it is written.
    pub fn type_name(&self, ty: Type) -> String {
        type_name(ty, |id| struct_name(&self.structs, &self.names, id))
    }

    /// The struct that a type is, arrays aside.
    pub fn struct_of(&self, ty: Type) -> Option<&Struct> {
        match ty.base {
            Base::Struct(id) | Base::Block(id) => self.structs.get(id as usize),
            _ => None,
        }
    }
}

/// Name of a struct in messages.
pub(super) fn struct_name(structs: &[Struct], names: &Names, id: u16) -> String {
    let name = structs.get(id as usize).and_then(|s| s.name);
    name.map_or("struct".to_string(), |n| names.text(n).to_string())
}

/// A program can be kept by one thread and read by many.
const _: () = {
    const fn is_shared<T: Send + Sync + 'static>() {}
    is_shared::<Program>();
};
