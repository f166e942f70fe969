//! Derivatives in code that only some pixels run.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::flow::{Parted, Varying};
use crate::semantic::{BuiltinId, Program, Storage};
use crate::syntax::ast::{ExprId, StmtId, StmtKind};
use crate::text::Span;

pub static RULE: Rule = Rule {
    name: "derivative-in-divergent-flow",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("derivative_in_divergent_flow.md"),
    check: Check::Program(check),
};

/// Most places that a finding points at.
const MAX_LABELS: usize = 4;
/// Most findings in one shader: what parts the pixels is mostly the same for all.
const MAX_FINDINGS: usize = 8;

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let program = cx.program;
    let branched = facts.gradients().iter().filter_map(|g| match g.parted {
        Parted::Branch(stmt) => Some((g, stmt)),
        Parted::Loop(_) => None,
    });
    for (gradient, stmt) in branched.take(MAX_FINDINGS) {
        let labels = labels(cx, stmt);
        let name = gradient.function.name();
        let mut finding = cx.report_expr(
            gradient.call,
            format!("`{name}` compares neighbouring pixels, but only some of them run this"),
        );
        for (span, message) in labels {
            finding = finding.label(span, message);
        }
        let finding = finding.note(
            "its derivatives are undefined here: seams and single wrong pixels along the edge",
        );
        match help(program, gradient.call, gradient.function) {
            Some(help) => finding.help(help),
            None => finding.help("compute it before the branch"),
        };
    }
}

/// What to write instead of a texture call.
fn help(program: &Program, call: ExprId, function: BuiltinId) -> Option<String> {
    let text = program.expr_text(call);
    let is_short = text.len() < 60 && !text.contains('\n');
    let rest = text
        .strip_prefix("texture(")
        .filter(|_| function == BuiltinId::Texture && is_short)?;
    let args = rest.strip_suffix(')')?;
    Some(format!(
        "compute it before the branch, or write `textureLod({args}, 0.0)`"
    ))
}

/// The way from the branch back to what differs: first the condition, last the source.
fn labels(cx: &Context, stmt: StmtId) -> Vec<(Span, String)> {
    let program = cx.program;
    let mut labels: Vec<(Span, String)> = Vec::new();
    let mut last_variable = None;
    let mut has_condition = false;
    for why in cx.facts.uniformity().why(Varying::Stmt(stmt)) {
        match why {
            Varying::Expr(e) => {
                let structure = cx.facts.structure();
                let is_whole = structure.parent(e).is_none();
                let of = structure.stmt_of(e);
                if is_whole && !has_condition && of.is_some_and(|s| decides(cx, s)) {
                    has_condition = true;
                    labels.push((program.expr_span(e), "not the same for all pixels".into()));
                }
            }
            Varying::Behind(s) if matches!(program.tree.stmt(s).kind, StmtKind::Return(_)) => {
                let span = program.span(program.tree.stmt(s).extent);
                labels.push((span, "some pixels leave here".into()));
            }
            Varying::Variable(v) if has_condition => last_variable = Some(v),
            _ => {}
        }
        if labels.len() >= MAX_LABELS {
            break;
        }
    }
    let source = last_variable.and_then(|v| program.variable(v));
    if let Some(source) = source {
        let name = program.names.text(source.name);
        let what = match source.storage {
            Storage::Input => format!("because of `{name}`, which differs from pixel to pixel"),
            _ => format!("because of `{name}`, the place of the pixel"),
        };
        let token = source.token.and_then(|t| program.token(t));
        let span = token.map(|t| t.span).filter(|s| cx.is_users(*s));
        match (span, labels.last_mut()) {
            (Some(span), _) => labels.push((span, what)),
            (None, Some((_, message))) => *message = format!("{message}, {what}"),
            _ => {}
        }
    }
    labels
}

/// Whether a statement is a condition: that of an `if`, a `switch` or a loop.
fn decides(cx: &Context, stmt: StmtId) -> bool {
    let tree = &cx.program.tree;
    match tree.stmt(stmt).kind {
        StmtKind::If { .. } | StmtKind::Switch { .. } | StmtKind::Do { .. } => true,
        StmtKind::Expr(_) => {
            let outer = cx.facts.structure().outer(stmt);
            outer.is_some_and(|o| match tree.stmt(o).kind {
                StmtKind::For { condition, .. } => condition == Some(stmt),
                StmtKind::While { condition, .. } => condition == stmt,
                _ => false,
            })
        }
        _ => false,
    }
}
