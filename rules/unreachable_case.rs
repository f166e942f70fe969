//! `case` labels that the selector never takes.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::given::hangs_on_callers;
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_semantic::{Storage, Value};
use shaderlint_syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "unreachable-case",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("unreachable_case.md"),
    checks: &[Check::Stmt(check)],
};

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::Switch { selector, body } = tree.stmt(id).kind else {
        return;
    };
    if program.expr(selector).is_const || !is_computed_here(cx, selector) {
        return;
    }
    let Some(range) = cx.facts.range(selector).next() else {
        return;
    };
    if range.is_any() || range.single().is_some() {
        return;
    }
    let place = program.expr_span(selector);
    let text = program.expr_text(selector);
    let known = format!("`{text}` is {} here", range.of_integer());
    for &stmt in tree.block(body) {
        let StmtKind::Case(label) = tree.stmt(stmt).kind else {
            continue;
        };
        let value = match program.scalar(label) {
            Some(Value::Int(v)) => v as f64,
            Some(Value::Uint(v)) => v as f64,
            _ => continue,
        };
        if !range.contains(value) {
            cx.report(tree.stmt(stmt).extent, "this case is never taken")
                .label(place, known.clone());
        }
    }
}

/// Whether a selector is what its function computes: callers and the host may give anything one day.
fn is_computed_here(cx: &Context, selector: ExprId) -> bool {
    let variable = cx.program.variable_of(selector);
    let storage = variable
        .and_then(|v| cx.program.variable(v))
        .map(|v| v.storage);
    matches!(storage, None | Some(Storage::Local)) && !hangs_on_callers(cx.facts, selector)
}
