//! Formulas: patterns of expressions that match whatever the order of operands and the parentheses.

use super::context::Context;
use super::same::same_code;
use shaderlint_semantic::{BuiltinId, Program};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};

/// A pattern of an expression.
#[derive(Clone, Copy, Debug)]
pub enum Formula {
    /// Any expression; operands with the same number must be the same code.
    Operand(usize),
    /// A constant of this value.
    Number(f32),
    /// An operator and its operands, in either order if it is commutative.
    Binary(BinaryOp, &'static Formula, &'static Formula),
    /// A call of a built-in function with one argument.
    Unary(BuiltinId, &'static Formula),
    /// A call of a built-in function with two arguments, in either order if it is commutative.
    Call(BuiltinId, &'static Formula, &'static Formula),
}

/// The most operands of a formula.
pub const MAX_OPERANDS: usize = 3;

/// By number: the expression bound to an operand of a formula.
type Operands = [Option<ExprId>; MAX_OPERANDS];

/// Matches an expression with a formula. Returns the first binding of operands that `fits`, by number and
/// without parentheses.
pub fn operands(
    cx: &Context,
    formula: &Formula,
    expr: ExprId,
    fits: impl Fn(&[ExprId]) -> bool,
) -> Option<Vec<ExprId>> {
    if !may_be(cx, formula, expr) {
        return None;
    }
    let mut found = None;
    unify(cx, formula, expr, [None; MAX_OPERANDS], &mut |operands| {
        let operands: Vec<ExprId> = operands.iter().flatten().copied().collect();
        let is_it = fits(&operands);
        if is_it {
            found = Some(operands);
        }
        is_it
    });
    found
}

/// Quick check whether the outermost operator matches.
fn may_be(cx: &Context, formula: &Formula, expr: ExprId) -> bool {
    let tree = &cx.program.tree;
    match (*formula, tree.expr(tree.unparen(expr)).kind) {
        (Formula::Operand(_) | Formula::Number(_), _) => true,
        (Formula::Binary(op, ..), ExprKind::Binary(found, ..)) => op == found,
        (Formula::Unary(..) | Formula::Call(..), ExprKind::Call(..)) => true,
        _ => false,
    }
}

/// Tries every match of `expr` with a formula, given the operands bound so far, until `then` accepts one.
fn unify(
    cx: &Context,
    formula: &Formula,
    expr: ExprId,
    mut given: Operands,
    then: &mut dyn FnMut(Operands) -> bool,
) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    let expr = tree.unparen(expr);
    let kind = tree.expr(expr).kind;
    match (*formula, kind) {
        // A comma expression would become two arguments of a call.
        (Formula::Operand(_), ExprKind::Comma(..)) => false,
        (Formula::Operand(number), _) => match given.get_mut(number) {
            Some(Some(same)) => {
                let [a, b] = [*same, expr].map(|e| tree.expr(e).extent);
                same_code(program, a, b) && then(given)
            }
            Some(slot) => {
                *slot = Some(expr);
                then(given)
            }
            None => false,
        },
        (Formula::Number(number), _) => {
            program.scalar(expr).is_some_and(|v| v.as_float() == number) && then(given)
        }
        (Formula::Binary(op, p, q), ExprKind::Binary(found, a, b)) if op == found => {
            let commutes = matches!(op, BinaryOp::Add | BinaryOp::Mul);
            unify_pair(cx, [p, q], [a, b], commutes, given, then)
        }
        (Formula::Unary(function, p), ExprKind::Call(_, args)) => match *tree.args(args) {
            [a] if program.builtin_called(expr) == Some(function) => unify(cx, p, a, given, then),
            _ => false,
        },
        (Formula::Call(function, p, q), ExprKind::Call(_, args)) => match *tree.args(args) {
            [a, b] if program.builtin_called(expr) == Some(function) => {
                use BuiltinId::{Distance, Dot, Max, Min};
                let commutes = matches!(function, Min | Max | Dot | Distance);
                unify_pair(cx, [p, q], [a, b], commutes, given, then)
            }
            _ => false,
        },
        _ => false,
    }
}

fn unify_pair(
    cx: &Context,
    [p, q]: [&Formula; 2],
    [a, b]: [ExprId; 2],
    commutes: bool,
    given: Operands,
    then: &mut dyn FnMut(Operands) -> bool,
) -> bool {
    let mut both = |a, b| {
        may_be(cx, p, a)
            && may_be(cx, q, b)
            && unify(cx, p, a, given, &mut |given| unify(cx, q, b, given, then))
    };
    both(a, b) || (commutes && both(b, a))
}

/// The factors of a product, without parentheses; a quotient or sum is one factor.
pub fn factors(program: &Program, expr: ExprId) -> Vec<ExprId> {
    let tree = &program.tree;
    let mut factors = Vec::new();
    let mut todo = vec![expr];
    while let Some(e) = todo.pop() {
        match tree.expr(tree.unparen(e)).kind {
            ExprKind::Binary(BinaryOp::Mul, a, b) => todo.extend([b, a]),
            _ => factors.push(tree.unparen(e)),
        }
    }
    factors
}
