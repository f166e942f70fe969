//! What stands above functions and numbers, to be pressed.

use super::document::Document;
use super::hover::operations;
use super::run::RunSeen;
use shaderlint_semantic::tunable::tunables;
use shaderlint_text::Span;

/// A line above something.
#[derive(Clone, PartialEq, Debug)]
pub struct Lens {
    /// What it stands above.
    pub span: Span,
    /// What it says.
    pub title: String,
    /// What happens when it is pressed.
    pub command: LensCommand,
}

/// What happens when a line is pressed.
#[derive(Clone, PartialEq, Debug)]
pub enum LensCommand {
    /// Nothing: it says something.
    Nothing,
    /// The shader is shown.
    Preview,
    /// A number is changed.
    Tune {
        /// Where it is written.
        value_span: Span,
        /// What it is.
        value: f64,
        /// From where.
        min: f64,
        /// To where.
        max: f64,
    },
}

/// The lines above what a text declares; `seen` is what runs of its shaders have shown.
pub fn lenses(document: &Document, seen: &[Option<RunSeen>]) -> Vec<Lens> {
    let mut found: Vec<Lens> = Vec::new();
    let analyses = document.report.analyses.iter();
    for (number, analysis) in analyses.enumerate() {
        let program = &analysis.program;
        let facts = analysis.facts();
        let entry = facts.entry().filter(|_| !analysis.has_errors);
        let decl = entry.and_then(|e| program.function(e)?.definition);
        let decl = decl.and_then(|d| program.tree.function(d));
        let place = decl.map(|d| program.span(d.header));
        let place = place.filter(|p| program.is_user(*p));
        if let (Some(entry), Some(span)) = (entry, place.and_then(|p| document.report.in_input(p)))
        {
            found.push(Lens {
                span,
                title: "▶ Preview".to_string(),
                command: LensCommand::Preview,
            });
            let title = match seen.get(number).and_then(Option::as_ref) {
                Some(seen) => seen_cost(seen),
                None => {
                    let most = facts.work().operations(entry);
                    format!("estimated: up to {} per pixel", operations(most))
                }
            };
            found.push(Lens {
                span,
                title,
                command: LensCommand::Nothing,
            });
        }
        for tunable in tunables(program) {
            let name = document.report.in_input(tunable.name);
            let value = document.report.in_input(tunable.value_span);
            if let (Some(span), Some(value_span)) = (name, value) {
                found.push(Lens {
                    span,
                    title: format!(
                        "Change {}: {} … {}",
                        program.sources.text(tunable.name),
                        tunable.min,
                        tunable.max
                    ),
                    command: LensCommand::Tune {
                        value_span,
                        value: tunable.value,
                        min: tunable.min,
                        max: tunable.max,
                    },
                });
            }
        }
    }
    found.sort_by_key(|lens| lens.span);
    found.dedup();
    found
}

/// What the pixels of a run cost.
fn seen_cost(seen: &RunSeen) -> String {
    let mut title = format!("in a run: {} per pixel", operations(seen.cost.round()));
    if f64::from(seen.most_cost) > seen.cost.round() {
        title.push_str(&format!(", {} at most", seen.most_cost));
    }
    if let Some(most) = seen.loops.values().map(|turns| turns.most).max() {
        let plural = if most == 1 { "" } else { "s" };
        title.push_str(&format!("; loops up to {most} iteration{plural}"));
    }
    title
}
