//! The same operand twice: `x - x`, `max(a, a)`, `a || b || a`.

use rustc_hash::FxHashMap;
use shaderlint_lint::code_hash;
use shaderlint_lint::prelude::*;

rule! { same_operands, Tidy, Warning, Recommended, Binary(check_binary), Builtin(check_builtin) }

/// Maximum length of a chain of `&&` or `||` that is checked.
const MAX_CHAIN: usize = 64;

fn check_binary(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::*;
    let program = cx.program;
    let outcome = match e.op {
        And | Or => return check_chain(cx, e),
        Sub => "always zero",
        Div => "one, or undefined for zero",
        Rem => "always zero",
        BitXor => "always zero",
        BitAnd | BitOr => "that operand",
        Xor | Less | Greater => "always false",
        LessEqual | GreaterEqual => "always true",
        // For floats this is a test for NaN: see `nan-compare`.
        Equal | NotEqual if program.ty(e.left).scalar_kind() == Some(Scalar::Float) => return,
        Equal => "always true",
        NotEqual => "always false",
        Mul | Add | ShiftLeft | ShiftRight => return,
    };
    let is_matrix = program.ty(e.left).is_matrix();
    let is_mistake = !program.expr(e.id).is_const && !is_matrix && !is_short_number(cx, e);
    if is_mistake && is_twice(cx, e.left, e.right) {
        let text = program.expr_text(e.left);
        let symbol = e.op.symbol();
        let message = format!("both operands of `{symbol}` are `{text}`; the result is {outcome}");
        cx.report_expr(e.id, message);
    }
}

/// Whether this is a short form of a vector of zeros or ones: `p - p` or `p / p` of a variable, where
/// nothing else is added to it.
fn is_short_number(cx: &Context, e: &BinaryExpr) -> bool {
    let tree = &cx.program.tree;
    let mut operand = tree.unparen(e.left);
    while let ExprKind::Member(inner, _) = tree.expr(operand).kind {
        operand = tree.unparen(inner);
    }
    let is_variable = matches!(tree.expr(operand).kind, ExprKind::Name(_));
    if !is_variable || !matches!(e.op, BinaryOp::Sub | BinaryOp::Div) {
        return false;
    }
    let structure = cx.facts.structure();
    let is_paren = |p: &ExprId| matches!(tree.expr(*p).kind, ExprKind::Paren(_));
    let mut around = std::iter::successors(structure.parent(e.id), |p| structure.parent(*p));
    let is_alone = around.find(|p| !is_paren(p)).is_none_or(|p| {
        matches!(
            tree.expr(p).kind,
            ExprKind::Assign(..) | ExprKind::Construct(..) | ExprKind::Comma(..)
        )
    });
    is_alone && cx.program.ty(e.id).is_vector()
}

/// Compares each condition of a chain with those before it.
fn check_chain(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let tree = &program.tree;
    let is_inner =
        |id: ExprId| matches!(tree.expr(id).kind, ExprKind::Binary(op, ..) if op == e.op);
    let is_top = cx
        .facts
        .structure()
        .parent(e.id)
        .is_none_or(|p| !is_inner(p));
    if !is_top {
        return;
    }
    let mut all = vec![e.right];
    let mut at = e.left;
    while let ExprKind::Binary(op, left, right) = tree.expr(at).kind {
        if op != e.op || all.len() >= MAX_CHAIN {
            break;
        }
        all.push(right);
        at = left;
    }
    all.push(at);
    let mut asked: FxHashMap<u64, ExprId> = FxHashMap::default();
    for &next in all.iter().rev() {
        let hash = code_hash(program, tree.expr(tree.unparen(next)).extent);
        let before = *asked.entry(hash).or_insert(next);
        if before != next && is_twice(cx, before, next) {
            let text = program.expr_text(next);
            let message = format!("`{text}` is tested twice in this `{}` chain", e.op.symbol());
            let before = program.expr_span(before);
            cx.report_expr(next, message)
                .label(before, "first tested here");
        }
    }
}

fn check_builtin(cx: &mut Context, call: &Builtin) {
    use BuiltinId::*;
    let program = cx.program;
    let (a, b) = match *call.args {
        [a, b] => (a, b),
        [a, b, _] if call.function == Mix => (a, b),
        [_, a, b] if call.function == Clamp => (a, b),
        _ => return,
    };
    let outcome = match call.function {
        Min | Max | Mix => "that argument",
        Clamp => "that bound",
        Step | LessThanEqual | GreaterThanEqual => "constant",
        LessThan | GreaterThan => "always false",
        Distance | Cross | Mod => "always zero",
        Equal | NotEqual if program.ty(a).scalar_kind() != Some(Scalar::Float) => "constant",
        _ => return,
    };
    if is_twice(cx, a, b) && !program.expr(call.id).is_const {
        let (text, name) = (program.expr_text(a), call.function.name());
        let message = format!("`{name}` is called with `{text}` twice; the result is {outcome}");
        cx.report_expr(call.id, message);
    }
}

/// Whether two expressions are the same code, not from a macro and without side effects.
fn is_twice(cx: &Context, a: ExprId, b: ExprId) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    let [a, b] = [a, b].map(|e| tree.unparen(e));
    let [first, second] = [a, b].map(|e| tree.expr(e).extent);
    first.last - first.first == second.last - second.first
        && same_code(program, first, second)
        && program.is_direct(first)
        && program.is_direct(second)
        && !cx.facts.effects().has(a)
}
