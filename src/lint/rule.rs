//! The shape of a rule.

use super::Context;
use crate::diagnostic::Severity;
use crate::semantic::FunctionRef;
use crate::syntax::ast::{BinaryOp, ExprId, StmtId};

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

/// What a rule wants to look at. One walk over the tree serves all rules.
#[derive(Clone, Copy)]
pub enum Check {
    /// The whole shader, once.
    Program(fn(&mut Context)),
    /// Every `l op r`.
    Binary(fn(&mut Context, &Binary)),
    /// Every expression.
    Expr(fn(&mut Context, ExprId)),
    /// Every statement.
    Stmt(fn(&mut Context, StmtId)),
    /// Every function with a body.
    Function(fn(&mut Context, FunctionRef)),
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
    /// Its page.
    pub page: &'static str,
    /// What it does.
    pub check: Check,
}
