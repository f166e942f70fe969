//! The shape of a rule.

use super::context::Context;
use super::option::RuleOption;
use shaderlint_diagnostic::Severity;
use shaderlint_semantic::{BuiltinId, FunctionRef, VariableId};
use shaderlint_syntax::Macro;
use shaderlint_syntax::ast::{
    BinaryOp, Declarator, ExprId, ExprKind, Extent, List, StmtId, TokenId, TypeId,
};

/// What a rule is about.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Group {
    /// What the host makes of the shader.
    Webgl2,
    /// Values.
    Numeric,
    /// Other drivers and back ends.
    Portability,
    /// Cost.
    Budget,
    /// The picture.
    Look,
    /// Order in the code.
    Tidy,
    /// What a run of the shader shows.
    Runtime,
}

impl Group {
    /// All groups.
    pub const ALL: [Group; 7] = [
        Group::Webgl2,
        Group::Numeric,
        Group::Portability,
        Group::Budget,
        Group::Look,
        Group::Tidy,
        Group::Runtime,
    ];

    /// The word for `--select` and the configuration.
    pub const fn name(self) -> &'static str {
        match self {
            Group::Webgl2 => "webgl2",
            Group::Numeric => "numeric",
            Group::Portability => "portability",
            Group::Budget => "budget",
            Group::Look => "look",
            Group::Tidy => "tidy",
            Group::Runtime => "runtime",
        }
    }
}

/// A binary expression, as rules get it.
#[derive(Clone, Copy, Debug)]
pub struct BinaryExpr {
    /// The expression.
    pub id: ExprId,
    /// Its operator.
    pub op: BinaryOp,
    /// Its left operand.
    pub left: ExprId,
    /// Its right operand.
    pub right: ExprId,
}

/// A call of a built-in function, as rules get it.
#[derive(Clone, Copy, Debug)]
pub struct Builtin<'a> {
    /// The call.
    pub id: ExprId,
    /// The function.
    pub function: BuiltinId,
    /// Its arguments.
    pub args: &'a [ExprId],
}

/// One variable of a declaration in the user's text, as rules get it.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredVariable<'a> {
    /// The variable.
    pub variable: VariableId,
    /// All names of the declaration.
    pub declarators: &'a [Declarator],
    /// Which of them it is.
    pub index: usize,
    /// Qualifiers of all, in [`Tree::qualifiers`](shaderlint_syntax::ast::Tree::qualifiers).
    pub qualifiers: List,
    /// Type of all, without what stands behind a name.
    pub ty: TypeId,
    /// The whole declaration.
    pub extent: Extent,
    /// The statement that it is, inside a function.
    pub stmt: Option<StmtId>,
}

impl<'a> DeclaredVariable<'a> {
    /// The name, and what stands with it.
    pub fn declarator(&self) -> Option<&'a Declarator> {
        self.declarators.get(self.index)
    }
}

/// A name that the user's text declares, outside any macro call.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredName<'a> {
    /// Where it stands first.
    pub token: TokenId,
    /// The name.
    pub text: &'a str,
    /// What is named so.
    pub what: Named,
}

/// What a name is declared to be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Named {
    /// A variable or parameter.
    Variable(VariableId),
    /// A function.
    Function(FunctionRef),
    /// A struct.
    Struct,
}

/// The shapes of expressions that rules ask for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// `l op r`
    Binary,
    /// `l = r` and `l op= r`
    Assign,
    /// A call of any function, and the making of a struct.
    Call,
    /// The making of what is no struct: `vec3(1.0)`.
    Construct,
    /// `object[index]`
    Index,
    /// `condition ? a : b`
    Ternary,
    /// `a, b`
    Comma,
    /// A literal with a point or an exponent: `1.0`, `2e-3`.
    FloatLiteral,
}

impl Shape {
    /// How many there are.
    pub(super) const COUNT: usize = 8;

    /// The shape of an expression; `None` for one that no rule asks for.
    pub(super) const fn of(kind: &ExprKind) -> Option<Shape> {
        match kind {
            ExprKind::Binary(..) => Some(Shape::Binary),
            ExprKind::Assign(..) => Some(Shape::Assign),
            ExprKind::Call(..) => Some(Shape::Call),
            ExprKind::Construct(..) => Some(Shape::Construct),
            ExprKind::Index(..) => Some(Shape::Index),
            ExprKind::Ternary(..) => Some(Shape::Ternary),
            ExprKind::Comma(..) => Some(Shape::Comma),
            ExprKind::Float(_) => Some(Shape::FloatLiteral),
            _ => None,
        }
    }
}

/// What a rule wants to look at. One walk over the tree serves all rules, and shows them nothing but
/// the user's text: what a host puts around it is none of theirs.
#[derive(Clone, Copy)]
pub enum Check {
    /// The whole shader, once; what is asked of the facts is the place to start from.
    Program(fn(&mut Context)),
    /// Every `l op r`.
    Binary(fn(&mut Context, &BinaryExpr)),
    /// Every call of a built-in function.
    Builtin(fn(&mut Context, &Builtin)),
    /// Every expression of these shapes.
    Expr(&'static [Shape], fn(&mut Context, ExprId)),
    /// Every statement.
    Stmt(fn(&mut Context, StmtId)),
    /// Every function with a body.
    Function(fn(&mut Context, FunctionRef)),
    /// Every variable of a declaration, parameters left out.
    Declaration(fn(&mut Context, &DeclaredVariable)),
    /// Every name that is declared.
    Name(fn(&mut Context, &DeclaredName)),
    /// Every macro.
    Macro(fn(&mut Context, &Macro)),
    /// What a run of the shader shows, once, behind all checks of its text.
    Run(fn(&mut Context)),
    /// Comments that allow findings, which are looked at when all findings are there.
    Allows,
    /// What the script around shaders asks of them, which is looked at where they are linked.
    Page,
}

impl Rule {
    /// Whether it looks at the comments that allow findings.
    pub fn is_of_allows(&self) -> bool {
        self.checks.iter().any(|c| matches!(c, Check::Allows))
    }
}

/// A lint rule. `NAME.rs` in `rules/` holds one; `NAME.md` beside it is what it means.
pub struct Rule {
    /// Its name, which reads well after "allow".
    pub name: &'static str,
    /// What it is about.
    pub group: Group,
    /// How bad its findings are, unless the configuration says otherwise.
    pub severity: Severity,
    /// Whether it runs without being asked for.
    pub default: bool,
    /// What it goes by, and the configuration may change.
    pub options: &'static [RuleOption],
    /// Its page.
    pub page: &'static str,
    /// What it looks at, and what it does there.
    pub checks: &'static [Check],
}
