//! The request `shaderlint/costs`: what each line of a document costs.

use crate::buffers::TextBuffer;
use crate::snapshot::{Answer, Snapshot};
use gen_lsp_types::TextDocumentIdentifier;
use serde::{Deserialize, Serialize};
use shaderlint_ide::{self as ide, CostSource, RunObservations};
use shaderlint_semantic::Stage;

/// The parameters of the request.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct CostParams {
    /// The document.
    text_document: TextDocumentIdentifier,
}

/// The cost of a shader of a document.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub struct ShaderCosts {
    /// Number of the shader in its document.
    shader: usize,
    /// `pixel` or `vertex`.
    per: &'static str,
    /// Operations per pixel or vertex.
    operations: f64,
    /// `sampleRun`: the average of a sample run; `bound`: the most that the code can take;
    /// `estimate`: the same with a guess for loops of unknown length.
    source: &'static str,
    /// The lines that cost something, in order.
    lines: Vec<LineCost>,
}

/// The cost of a line.
#[derive(Serialize)]
pub struct LineCost {
    /// The line, from 0.
    line: u32,
    /// Its operations.
    operations: f64,
    /// Its share of all operations of the shader, from 0 to 1.
    share: f64,
}

/// The costs of all shaders of a document, as its code lenses have them.
pub fn costs(snapshot: &Snapshot, params: &CostParams) -> Answer<Vec<ShaderCosts>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let (document, seen) = (snapshot.best(buffer), seen(snapshot, buffer));
    let shaders = 0..document.report.analyses.len();
    let costs = shaders.filter_map(|shader| {
        let seen = seen.get(shader).and_then(Option::as_ref);
        let cost = ide::shader_cost(&document, shader, seen)?;
        let share = |operations: f64| operations / cost.operations.max(1.0);
        let lines = cost.lines.iter().map(|(line, operations)| LineCost {
            line: line - 1,
            operations: *operations,
            share: share(*operations),
        });
        Some(ShaderCosts {
            shader,
            per: match cost.stage {
                Stage::Vertex => "vertex",
                Stage::Fragment => "pixel",
            },
            operations: cost.operations,
            source: match cost.source {
                CostSource::SampleRun => "sampleRun",
                CostSource::Bound => "bound",
                CostSource::Estimate => "estimate",
            },
            lines: lines.collect(),
        })
    });
    Ok(costs.collect())
}

/// The sample runs of a document. If they are still to come, its shaders are run now, so that a
/// client does not ask again.
fn seen(snapshot: &Snapshot, buffer: &TextBuffer) -> Vec<Option<RunObservations>> {
    let is_run = snapshot.settings.run && !snapshot.leaves_out(buffer);
    if buffer.ran.get().is_some() || !is_run {
        return snapshot.seen(buffer);
    }
    let document = snapshot.document(buffer);
    let shaders = document.report.analyses.iter();
    shaders.map(|shader| ide::run(&document, shader)).collect()
}
