//! The shape of a rule.

use super::Context;
use crate::diagnostic::Severity;
use crate::semantic::{BuiltinId, FunctionRef};
use crate::syntax::ast::{BinaryOp, ExprId, ExprKind, StmtId};

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
}

impl Group {
    /// All groups.
    pub const ALL: [Group; 6] = [
        Group::Webgl2,
        Group::Numeric,
        Group::Portability,
        Group::Budget,
        Group::Look,
        Group::Tidy,
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
        }
    }
}

/// A binary expression, as rules get it.
#[derive(Clone, Copy, Debug)]
pub struct Binary {
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
}

impl Shape {
    /// How many there are.
    pub(super) const COUNT: usize = 5;

    /// The shape of an expression; `None` for one that no rule asks for.
    pub(super) const fn of(kind: &ExprKind) -> Option<Shape> {
        match kind {
            ExprKind::Binary(..) => Some(Shape::Binary),
            ExprKind::Assign(..) => Some(Shape::Assign),
            ExprKind::Call(..) => Some(Shape::Call),
            ExprKind::Construct(..) => Some(Shape::Construct),
            ExprKind::Index(..) => Some(Shape::Index),
            _ => None,
        }
    }
}

/// What a rule wants to look at. One walk over the tree serves all rules.
#[derive(Clone, Copy)]
pub enum Check {
    /// The whole shader, once.
    Program(fn(&mut Context)),
    /// Every `l op r`.
    Binary(fn(&mut Context, &Binary)),
    /// Every call of a built-in function.
    Builtin(fn(&mut Context, &Builtin)),
    /// Every expression of these shapes.
    Expr(&'static [Shape], fn(&mut Context, ExprId)),
    /// Every statement.
    Stmt(fn(&mut Context, StmtId)),
    /// Every function with a body.
    Function(fn(&mut Context, FunctionRef)),
    /// Comments that allow findings, which are looked at when all findings are there.
    Allows,
    /// What the script around shaders asks of them, which is looked at where they are linked.
    Page,
}

/// A number that a rule goes by, and that the configuration may set.
pub struct RuleOption {
    /// Its name in the configuration: words with hyphens.
    pub name: &'static str,
    /// Its value where a renderer on the processor draws.
    pub default: f64,
    /// Its value where a graphics card draws.
    pub on_gpu: f64,
    /// What it is, as a sentence without a full stop.
    pub about: &'static str,
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
    /// The numbers that it goes by.
    pub options: &'static [RuleOption],
    /// Its page.
    pub page: &'static str,
    /// What it does.
    pub check: Check,
}
