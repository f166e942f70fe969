//! Division by zero.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule, Shape};
use crate::semantic::{BuiltinId, Scalar};
use crate::syntax::ast::{BinaryOp, ExprId, ExprKind};

pub static RULE: Rule = Rule {
    name: "zero-division",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("zero_division.md"),
    checks: &[Check::Expr(
        &[Shape::Binary, Shape::Assign, Shape::Call],
        check,
    )],
};

fn check(cx: &mut Context, id: ExprId) {
    let (op, divisor) = match cx.program.tree.expr(id).kind {
        ExprKind::Binary(op, _, divisor) | ExprKind::Assign(Some(op), _, divisor) => (op, divisor),
        ExprKind::Call(_, args) if cx.program.builtin_called(id) == Some(BuiltinId::Mod) => {
            match cx.program.tree.args(args) {
                &[_, divisor] => (BinaryOp::Rem, divisor),
                _ => return,
            }
        }
        _ => return,
    };
    if !matches!(op, BinaryOp::Div | BinaryOp::Rem) {
        return;
    }
    let Some(range) = cx.facts.range(divisor).find(|r| r.holds(0.0)) else {
        return;
    };
    let is_float = cx.program.ty(divisor).scalar_kind() == Some(Scalar::Float);
    let is_zero = range.single() == Some(0.0);
    let known = match is_float {
        true => range.to_string(),
        false => range.of_integer(),
    };
    let message = match is_zero {
        true => "division by zero".to_string(),
        false => format!("the divisor may be zero: {known}"),
    };
    let finding = cx.report_expr(divisor, message).note(match is_float {
        true => {
            "the result is an infinity, or a NaN if both are zero; some GPUs give something else"
        }
        false => "the result of an integer division by zero is undefined",
    });
    if !is_zero && range.lo.value >= 0.0 {
        finding.help("decide what comes out there: start the counter behind zero, leave that case out, or bound the divisor from below by the smallest value that means something");
    }
}
