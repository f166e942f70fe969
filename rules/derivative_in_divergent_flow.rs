//! Derivatives in code that only some neighbouring pixels run.

use shaderlint_flow::{ControlId, DivergenceCause};
use shaderlint_lint::prelude::*;

rule! { derivative_in_divergent_flow, Portability, Info, Recommended, Program(check) }

/// Most labels of a finding.
const MAX_LABELS: usize = 4;
/// Most findings in one shader: the cause of the divergence is usually the same for all.
const MAX_FINDINGS: usize = 8;

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let branched = facts.gradients().iter().filter_map(|g| match g.cause {
        DivergenceCause::Branch(control) => Some((g, control)),
        DivergenceCause::Loop(_) => None,
    });
    // Without mipmaps a lookup uses no derivatives. ShaderToy's textures have them by default; those of
    // other pages rarely do.
    let is_mipmapped = cx.program.dialect.is_shadertoy();
    let matters = |function: BuiltinId| is_mipmapped || !function.kind().is_texture();
    let branched = branched.filter(|(gradient, _)| matters(gradient.function));
    for (gradient, control) in branched.take(MAX_FINDINGS) {
        let labels = labels(cx, control);
        let help = help(cx, gradient.call, gradient.function);
        let name = gradient.function.name();
        let mut finding = cx.report_op(
            gradient.call,
            format!("`{name}` is called where neighbouring pixels diverge"),
        );
        for (span, message) in labels {
            finding = finding.label(span, message);
        }
        let finding = finding.note(
            "derivatives are undefined here, which shows as seams and wrong pixels along the edge",
        );
        match help {
            Some(help) => finding.help(help),
            None => finding.help("move the call before the branch"),
        };
    }
}

/// The help for a call of `texture`; `None` for other calls and long ones.
fn help(cx: &Context, call: OpId, function: BuiltinId) -> Option<String> {
    let Provenance::Expr(call) = cx.facts.module().provenance(call) else {
        return None;
    };
    let text = cx.program.expr_text(call);
    let is_short = text.len() < 60 && !text.contains('\n');
    let rest = text
        .strip_prefix("texture(")
        .filter(|_| function == BuiltinId::Texture && is_short)?;
    let args = rest.strip_suffix(')')?;
    Some(format!(
        "move the call before the branch, or use `textureLod({args}, 0.0)`"
    ))
}

/// The path from the branch back to the cause of the divergence: first the condition, last the
/// source.
fn labels(cx: &Context, control: ControlId) -> Vec<(Span, String)> {
    let (program, facts) = (cx.program, cx.facts);
    let mut labels: Vec<(Span, String)> = Vec::new();
    let mut last_variable = None;
    let mut has_condition = false;
    for why in facts.uniformity().why(Varying::Control(control)) {
        match why {
            // The first value on the path is the condition.
            Varying::Value(op) if !has_condition => {
                has_condition = true;
                if let Provenance::Expr(e) = facts.module().provenance(op) {
                    labels.push((program.expr_span(e), "differs between pixels".into()));
                }
            }
            Varying::Divergence(p) => {
                let left = facts.uniformity().divergence(p).and_then(|p| p.left_at);
                if let Some(stmt) = left.map(|s| program.tree.stmt(s))
                    && matches!(stmt.kind, StmtKind::Return(_))
                {
                    let span = program.span(stmt.extent);
                    if labels.iter().all(|(known, _)| *known != span) {
                        labels.push((span, "some pixels return here".into()));
                    }
                }
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
            Storage::Input => format!("`{name}` differs between pixels"),
            _ => format!("`{name}` is the pixel position"),
        };
        let token = source.token.and_then(|t| program.token(t));
        let span = token.map(|t| t.span).filter(|s| program.is_user(*s));
        match (span, labels.last_mut()) {
            (Some(span), _) => labels.push((span, what)),
            (None, Some((_, message))) => *message = format!("{message} because {what}"),
            _ => {}
        }
    }
    labels
}
