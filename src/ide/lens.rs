//! Code lenses above functions and constants.

use super::document::Document;
use super::hover::operations;
use super::preview::preview_project;
use super::run::RunObservations;
use shaderlint_diagnostic::count;
use shaderlint_exec::start;
use shaderlint_semantic::tunable::tunables;
use shaderlint_semantic::{Scalar, Stage};
use shaderlint_text::Span;

/// A code lens.
#[derive(Clone, PartialEq, Debug)]
pub struct Lens {
    /// Span that it is shown above.
    pub span: Span,
    /// Displayed text.
    pub title: String,
    /// Command on click.
    pub command: LensCommand,
}

/// Commands of code lenses.
#[derive(Clone, PartialEq, Debug)]
pub enum LensCommand {
    /// None: the lens is informative.
    Nothing,
    /// Opens the preview of the shader with this number.
    Preview(usize),
    /// Changes a number with a slider.
    Tune {
        /// Span of the number.
        value_span: Span,
        /// Current value.
        value: f64,
        /// Minimum of the slider.
        min: f64,
        /// Maximum of the slider.
        max: f64,
    },
}

/// The lenses of a document; `seen` holds the results of sample runs, by shader.
pub fn lenses(document: &Document, seen: &[Option<RunObservations>]) -> Vec<Lens> {
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
            if preview_project(document, number).is_ok() {
                found.push(Lens {
                    span,
                    title: "▶ Preview".to_string(),
                    command: LensCommand::Preview(number),
                });
            }
            let title = match seen.get(number).and_then(Option::as_ref) {
                Some(seen) => observed_cost(seen),
                None => {
                    let start = start(program, analysis.module()).unwrap_or(entry);
                    let (count, is_bound) = facts.work().of_shader(start);
                    estimated_cost(program.stage, count, is_bound)
                }
            };
            found.push(Lens {
                span,
                title,
                command: LensCommand::Nothing,
            });
        }
        for tunable in tunables(program) {
            let (&[now], &[min], &[max]) = (&*tunable.value, &*tunable.min, &*tunable.max) else {
                continue;
            };
            if tunable.scalar == Scalar::Bool {
                continue;
            }
            let name = document.report.in_input(tunable.name);
            let value = document.report.in_input(tunable.value_span);
            if let (Some(span), Some(value_span)) = (name, value) {
                found.push(Lens {
                    span,
                    title: format!(
                        "Change {}: {min} … {max}",
                        program.sources.text(tunable.name),
                    ),
                    command: LensCommand::Tune {
                        value_span,
                        value: now,
                        min,
                        max,
                    },
                });
            }
        }
    }
    found.sort_by_key(|lens| lens.span);
    found.dedup();
    found
}

/// The cost of a shader that was not run.
fn estimated_cost(stage: Stage, count: f64, is_bound: bool) -> String {
    let count = operations(count);
    let per = match stage {
        Stage::Vertex => "vertex",
        Stage::Fragment => "pixel",
    };
    match is_bound {
        true => format!("estimated: at most {count} per {per}"),
        false => format!("estimated: {count} per {per}, if loops of unknown length run 8 times"),
    }
}

/// The cost of pixels in a sample run.
fn observed_cost(seen: &RunObservations) -> String {
    let mut title = format!("sample run: {} per pixel", operations(seen.cost.round()));
    if f64::from(seen.most_cost) > seen.cost.round() {
        let most = operations(f64::from(seen.most_cost));
        title.push_str(&format!(", at most {most}"));
    }
    if let Some(most) = seen.loops.values().map(|iterations| iterations.most).max() {
        title.push_str(&format!("; loops up to {}", count(most, "iteration")));
    }
    title
}
