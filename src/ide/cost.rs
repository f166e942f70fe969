//! The cost of a shader, and of each line of it.

use super::document::Document;
use super::line_costs::estimated_lines;
use super::run::RunObservations;
use shaderlint_exec::start;
use shaderlint_semantic::Stage;
use std::collections::BTreeMap;

/// The cost of a shader, and of the lines of its document.
#[derive(Clone, PartialEq, Debug)]
pub struct ShaderCost {
    /// What is drawn by the shader: a vertex or a pixel.
    pub stage: Stage,
    /// Operations per pixel, or per vertex.
    pub operations: f64,
    /// Where the figures come from.
    pub source: CostSource,
    /// By line, from 1: its operations. What a macro or another file does counts for the line that
    /// uses it. What only the host's code does belongs to no line.
    pub lines: BTreeMap<u32, f64>,
}

/// Where the figures of a cost come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CostSource {
    /// The average of a sample run.
    SampleRun,
    /// The most that a pixel can take, from the code.
    Bound,
    /// The code, which has loops of unknown length.
    Estimate,
}

/// The cost of a shader of a document: that of its sample run, or an estimate. `None` for a shader
/// with errors, or without an entry point.
pub fn shader_cost(
    document: &Document,
    shader: usize,
    seen: Option<&RunObservations>,
) -> Option<ShaderCost> {
    let analysis = document.report.analyses.get(shader)?;
    let stage = analysis.program.stage;
    if let Some(seen) = seen {
        return Some(ShaderCost {
            stage,
            operations: seen.cost,
            source: CostSource::SampleRun,
            lines: seen.lines.clone(),
        });
    }
    let facts = analysis.facts();
    let entry = facts.entry().filter(|_| !analysis.has_errors)?;
    let entry = start(&analysis.program, analysis.module()).unwrap_or(entry);
    let (operations, is_bound) = facts.work().of_shader(entry);
    Some(ShaderCost {
        stage,
        operations,
        source: match is_bound {
            true => CostSource::Bound,
            false => CostSource::Estimate,
        },
        lines: estimated_lines(document, analysis, &facts, entry),
    })
}
