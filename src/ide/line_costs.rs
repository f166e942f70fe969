//! The operations of each line of a document, from a run or from the code.

use super::document::Document;
use shaderlint_engine::Analysis;
use shaderlint_exec::{Bytecode, Drawn};
use shaderlint_flow::CostPart;
use shaderlint_ir::Provenance;
use shaderlint_lint::Facts;
use shaderlint_semantic::FunctionRef;
use shaderlint_text::{LineIndex, SetAt, Span};
use std::collections::BTreeMap;

/// The lines of a document.
struct DocumentLines<'d> {
    document: &'d Document,
    analysis: &'d Analysis,
    index: LineIndex,
}

impl<'d> DocumentLines<'d> {
    fn of(document: &'d Document, analysis: &'d Analysis) -> DocumentLines<'d> {
        DocumentLines {
            document,
            analysis,
            index: LineIndex::new(&document.text),
        }
    }

    /// The line of the document at which something starts.
    fn line(&self, at: Provenance) -> Option<u32> {
        let program = &self.analysis.program;
        let token = program.token(at.extent(&program.tree)?.first)?;
        let span = self.document.report.in_input(Span::at(token.span.start))?;
        Some(self.index.line(span.start))
    }
}

/// Operations per pixel by line, from a run with costs.
pub(super) fn observed_lines(
    document: &Document,
    analysis: &Analysis,
    code: &Bytecode,
    drawn: &Drawn,
) -> BTreeMap<u32, f64> {
    let lines = DocumentLines::of(document, analysis);
    let module = analysis.module();
    let mut counts: BTreeMap<u32, u64> = BTreeMap::new();
    for cost in code.costs(&drawn.seen).filter(|cost| cost.operations > 0) {
        let mut calls = cost.calls.iter();
        let called = || calls.find_map(|call| lines.line(module.provenance(*call)));
        if let Some(line) = lines.line(cost.at).or_else(called) {
            *counts.entry(line).or_default() += cost.operations;
        }
    }
    let pixels = drawn.seen.pixels.max(1) as f64;
    let mean = |(line, count)| (line, count as f64 / pixels);
    counts.into_iter().map(mean).collect()
}

/// Operations by line, from the code alone.
pub(super) fn estimated_lines(
    document: &Document,
    analysis: &Analysis,
    facts: &Facts,
    entry: FunctionRef,
) -> BTreeMap<u32, f64> {
    let lines = DocumentLines::of(document, analysis);
    let (module, work) = (analysis.module(), facts.work());
    let mut found: BTreeMap<u32, f64> = BTreeMap::new();
    let is_own = |function: FunctionRef| {
        let declared = analysis.program.function(function)?.definition?;
        let header = analysis.program.tree.function(declared)?.header;
        let start = analysis.program.span(header).start;
        document.report.in_input(Span::at(start))
    };
    let mut calls = vec![0.0; module.functions.len()];
    calls.set_at(entry.0 as usize, 1.0);
    // A function comes after all that call it.
    let functions = facts.calls().graph.bottom_up();
    let bodies = functions.into_iter().rev().filter_map(|id| {
        let body = module.function(id)?.body?;
        Some((Some(id), body))
    });
    for (function, body) in [(None, module.globals)].into_iter().chain(bodies) {
        let times = function.map_or(1.0, |id| calls.get(id.0 as usize).copied().unwrap_or(0.0));
        if times == 0.0 {
            continue;
        }
        let mut on = |at, part, times| {
            let operations = match part {
                CostPart::Operations(cost) => f64::from(cost) * times,
                CostPart::Call(callee) => {
                    let is_host = lines.line(at).is_none();
                    if is_own(callee).is_some() || is_host {
                        if let Some(calls) = calls.get_mut(callee.0 as usize) {
                            *calls += times;
                        }
                        return;
                    }
                    work.operations(callee) * times
                }
            };
            if let Some(line) = lines.line(at).filter(|_| operations > 0.0) {
                *found.entry(line).or_default() += operations;
            }
        };
        work.visit(module, body, times, &mut on);
    }
    found
}
