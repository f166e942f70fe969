//! The call hierarchy, with the estimated cost of functions.

use super::family::{NameHere, compiled_name};
use crate::document::{Document, FileSpan};
use crate::hover::operations;
use crate::symbol::{Symbol, declared_at};
use shaderlint_lint::Facts;
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::Span;
use std::collections::BTreeMap;

/// A function in the call hierarchy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CallItem {
    /// Name of the function.
    pub name: String,
    /// Signature and estimated cost.
    pub detail: String,
    /// Span of the function.
    pub place: FileSpan,
    /// Span of the name.
    pub name_span: Span,
}

/// A caller or callee.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CallLink {
    /// The caller or callee.
    pub item: CallItem,
    /// Spans of the calls in the file of the caller.
    pub calls: Vec<Span>,
}

/// The user-defined function at an offset.
pub fn call_item(document: &Document, offset: u32) -> Option<CallItem> {
    let NameHere { spot, name, .. } = compiled_name(document, offset)?;
    let Symbol::Function(function) = name.symbol else {
        return None;
    };
    item(document, &spot.analysis.facts(), function)
}

fn item(document: &Document, facts: &Facts, function: FunctionRef) -> Option<CallItem> {
    let program = facts.program();
    let symbol = Symbol::Function(function);
    let name = document.place(declared_at(program, symbol)?)?;
    let known = program.function(function)?;
    let decl = program
        .tree
        .function(known.definition.unwrap_or(known.declaration))?;
    let around = document.place(program.span(decl.extent));
    let around = around.filter(|a| a.path == name.path && a.span.contains(name.span));
    let cost = operations(facts.work().operations(function));
    Some(CallItem {
        name: symbol.name(program).to_string(),
        detail: format!("{} · about {cost}", symbol.declaration(program)),
        name_span: name.span,
        place: around.unwrap_or(name),
    })
}

/// The functions in the documents that call the function at an offset of `document`, which is one
/// of them.
pub fn incoming(documents: &[&Document], document: &Document, offset: u32) -> Vec<CallLink> {
    let Some(NameHere { spot, name, .. }) = compiled_name(document, offset) else {
        return Vec::new();
    };
    let origin = document.origin(spot.program(), name.symbol);
    let mut found = Vec::new();
    for document in documents {
        let analyses = document.report.analyses.iter();
        for (analysis, (program, index)) in analyses.zip(document.shaders()) {
            let own = index.all.iter().find_map(|o| match o.symbol {
                Symbol::Function(id) if document.origin(program, o.symbol) == origin => Some(id),
                _ => None,
            });
            let calls = program.calls.iter().filter(|c| Some(c.callee) == own);
            let callers = calls.filter_map(|c| Some((c.caller?, c.expr)));
            found.extend(links(document, &analysis.facts(), callers));
        }
    }
    // Passes and includes are analysed more than once.
    found.sort_by(|a, b| a.item.place.cmp(&b.item.place));
    found.dedup_by(|a, b| a.item.place == b.item.place);
    found
}

/// The functions that the function at an offset calls.
pub fn outgoing(document: &Document, offset: u32) -> Vec<CallLink> {
    let Some(NameHere { spot, name, .. }) = compiled_name(document, offset) else {
        return Vec::new();
    };
    let Symbol::Function(own) = name.symbol else {
        return Vec::new();
    };
    let facts = spot.analysis.facts();
    let calls = facts.program().calls.iter();
    let calls = calls.filter(|c| c.caller == Some(own));
    links(document, &facts, calls.map(|c| (c.callee, c.expr)))
}

/// Groups calls by function.
fn links(
    document: &Document,
    facts: &Facts,
    calls: impl Iterator<Item = (FunctionRef, ExprId)>,
) -> Vec<CallLink> {
    let program = facts.program();
    let mut by_function: BTreeMap<FunctionRef, Vec<Span>> = BTreeMap::new();
    for (other, call) in calls {
        let first = program.tree.expr(call).extent.first;
        let span = program.token(first).map(|t| t.span);
        let place = span.and_then(|span| document.place(span));
        by_function
            .entry(other)
            .or_default()
            .extend(place.map(|p| p.span));
    }
    let links = by_function.into_iter().filter_map(|(other, calls)| {
        let item = item(document, facts, other)?;
        Some(CallLink { item, calls })
    });
    links.collect()
}
