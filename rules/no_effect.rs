//! Expressions with an unused value and no side effect.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::is_dropped;

rule! {
    no_effect, Tidy, Warning, Recommended,
    Stmt(check_statement), Expr(&[Shape::Comma], check_comma)
}

fn check_statement(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    if let StmtKind::Expr(root) = program.tree.stmt(id).kind
        && is_idle(cx, root)
        && is_dropped(program, cx.facts.structure(), root)
        && !is_placeholder(cx, id, root)
    {
        report_statement(cx, id, root);
    }
}

fn check_comma(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Comma(left, right) = program.tree.expr(id).kind else {
        return;
    };
    // If the whole expression has no effect, it was reported as a statement.
    let dropped = is_idle(cx, right) && is_dropped(program, cx.facts.structure(), id);
    // `a, b, c` is parsed as `(a, b), c`.
    let is_list = matches!(program.tree.expr(left).kind, ExprKind::Comma(..));
    if !dropped && !is_list && is_idle(cx, left) {
        cx.report_expr(left, "value left of the comma is unused")
            .note("`a, b` evaluates both operands and returns `b` (section 5.9)");
    }
}

/// Whether an expression has no side effect and does not come from a macro.
fn is_idle(cx: &Context, id: ExprId) -> bool {
    let program = cx.program;
    !plainly_acts(cx, id)
        && !cx.facts.effects().has(id)
        && !program.ty(id).is_error()
        && program.is_direct(program.tree.expr(id).extent)
}

/// Whether an expression is a placeholder: the name of the counter in the header of a `for`, or the
/// call of a function with an empty body.
fn is_placeholder(cx: &Context, stmt: StmtId, root: ExprId) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    match tree.expr(tree.unparen(root)).kind {
        ExprKind::Name(_) => {
            let outer = cx.facts.structure().outer(stmt);
            outer.is_some_and(|o| matches!(tree.stmt(o).kind, StmtKind::For { .. }))
        }
        ExprKind::Call(..) => {
            let Resolution::Function(callee) = program.expr(root).resolution else {
                return false;
            };
            let definition = program.function(callee).and_then(|f| f.definition);
            let body = definition.and_then(|d| tree.function(d)?.body);
            body.is_some_and(
                |b| matches!(tree.stmt(b).kind, StmtKind::Block(list) if list.len == 0),
            )
        }
        _ => false,
    }
}

/// Whether an expression is an assignment, or a call that writes to its arguments: a cheap test
/// that accepts nearly all statements.
fn plainly_acts(cx: &Context, id: ExprId) -> bool {
    let program = cx.program;
    match program.tree.expr(id).kind {
        ExprKind::Assign(..) | ExprKind::Postfix(..) => true,
        ExprKind::Unary(op, _) => op.assigns(),
        ExprKind::Call(..) => match program.expr(id).resolution {
            Resolution::Function(f) => program
                .function(f)
                .is_some_and(|f| f.params.iter().any(|p| p.direction.writes())),
            _ => false,
        },
        _ => false,
    }
}

fn report_statement(cx: &mut Context, stmt: StmtId, root: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let inner = tree.expr(tree.unparen(root));
    let removal = || without_statement(program, cx.facts.structure(), stmt);
    let (message, fix) = match inner.kind {
        ExprKind::Binary(BinaryOp::Equal, left, right) => {
            let operator = program.token(tree.expr(left).extent.last + 1);
            let fix = operator
                .filter(|_| tree.unparen(root) == root)
                .map(|t| Fix::suggestion("did you mean `=`?", vec![Edit::replace(t.span, "=")]));
            let (left, right) = (program.expr_text(left), program.expr_text(right));
            (
                format!("result of comparing `{left}` with `{right}` is unused"),
                fix,
            )
        }
        ExprKind::Binary(op, left, _) if can_assign(cx, op, left, root) => (
            "result of this operation is unused".to_string(),
            assignment(cx, left),
        ),
        ExprKind::Binary(op, left, _) if can_assign(cx, op, first_operand(tree, left), root) => {
            let place = program.expr_text(first_operand(tree, left));
            let edit = Edit::insert(program.expr_span(root).start, format!("{place} = "));
            let fix = Fix::suggestion(format!("assign the result to `{place}`"), vec![edit]);
            ("result of this operation is unused".to_string(), Some(fix))
        }
        ExprKind::Call(_, args) => {
            let name = program.token(inner.extent.first);
            let name = name.map_or("", |t| program.sources.text(t.span));
            let message = match program.ty(root).is_void() {
                true => format!("call of `{name}` has no effect"),
                false => format!("result of `{name}` is unused, and the call has no other effect"),
            };
            let first = tree.args(args).first().copied();
            let kept = first
                .filter(|&a| program.variable_of(a).is_some() && program.ty(a) == program.ty(root));
            let fix = kept.map(|a| {
                let text = program.expr_text(a);
                let start = program.expr_span(root).start;
                let edit = Edit::insert(start, format!("{text} = "));
                Fix::suggestion(format!("assign the result to `{text}`"), vec![edit])
            });
            (message, fix.or_else(removal))
        }
        _ => ("statement has no effect".to_string(), removal()),
    };
    cx.report_expr(root, message).fix(fix);
}

/// Whether `a * b;` could have been meant as `a *= b;`: the left operand is a variable of that type.
fn can_assign(cx: &Context, op: BinaryOp, left: ExprId, root: ExprId) -> bool {
    let program = cx.program;
    let mut place = left;
    while let ExprKind::Member(inner, _) | ExprKind::Index(inner, _) = program.tree.expr(place).kind
    {
        place = inner;
    }
    let variable = program.variable_of(place).and_then(|v| program.variable(v));
    let is_variable = variable.is_some_and(|v| {
        let is_read_only = matches!(
            v.storage,
            Storage::Uniform | Storage::Input | Storage::Param(Direction::ConstIn)
        );
        !v.is_const && !is_read_only && v.token.is_some()
    });
    let has_assignment = !op.compares() && !op.is_logical();
    has_assignment && is_variable && program.ty(left) == program.ty(root)
}

/// `a` of `a - b - c`
fn first_operand(tree: &Tree, mut left: ExprId) -> ExprId {
    while let ExprKind::Binary(op, inner, _) = tree.expr(left).kind
        && !op.compares()
        && !op.is_logical()
    {
        left = inner;
    }
    left
}

/// `a *= b;` for `a * b;`
fn assignment(cx: &Context, left: ExprId) -> Option<Fix> {
    let operator = cx
        .program
        .token(cx.program.tree.expr(left).extent.last + 1)?;
    let title = format!(
        "did you mean `{}=`?",
        cx.program.sources.text(operator.span)
    );
    let edit = Edit::insert(operator.span.end, "=");
    Some(Fix::suggestion(title, vec![edit]))
}
