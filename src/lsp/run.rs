//! Sample runs of documents.

use super::buffers::{Ran, TextBuffer};
use super::snapshot::Snapshot;
use super::workspace::SampleRuns;
use shaderlint_ide::{Document, run};
use std::sync::Arc;

/// Runs the shaders of a document.
pub fn run_buffer(snapshot: &Snapshot, buffer: &Arc<TextBuffer>) {
    let options = snapshot.options(SampleRuns::AsConfigured, buffer);
    let text = buffer.text.clone();
    let document = Document::new(&buffer.path, text, options, &snapshot.files);
    let shaders = document.report.analyses.iter();
    let seen = shaders.map(|shader| run(&document, shader)).collect();
    let ran = Ran {
        document: Arc::new(document),
        seen,
    };
    // No other task sets this state.
    let _ = buffer.ran.set(ran);
}
