//! Where names are declared and used.

use super::document::{Document, FileSpan, Spot};
use super::index::{NameUse, Occurrence};
use super::symbol::{Symbol, declared_at};
use shaderlint_semantic::Base;
use shaderlint_text::Span;

/// Where what stands at an offset is defined: a function at its body.
pub fn definition(document: &Document, offset: u32) -> Option<FileSpan> {
    let spot = document.spot(offset)?;
    let symbol = spot.name()?.symbol;
    let span = match symbol {
        Symbol::MacroParameter(..) => defined_in(&spot, symbol)?,
        _ => declared_at(spot.program(), symbol)?,
    };
    document.place(span)
}

/// Where what stands at an offset is first declared: a function at its prototype.
pub fn declaration(document: &Document, offset: u32) -> Option<FileSpan> {
    let spot = document.spot(offset)?;
    let symbol = spot.name()?.symbol;
    let mut all = spot.index().named(symbol);
    let declared = all.find(|o| matches!(o.access, NameUse::Declared | NameUse::Defined));
    document.place(declared?.span)
}

fn defined_in(spot: &Spot, symbol: Symbol) -> Option<Span> {
    let mut all = spot.index().named(symbol);
    all.find(|o| o.access == NameUse::Defined).map(|o| o.span)
}

/// Where the type of what stands at an offset is declared, where it is a struct.
pub fn type_definition(document: &Document, offset: u32) -> Option<FileSpan> {
    let spot = document.spot(offset)?;
    let ty = spot.name()?.symbol.ty(spot.program())?;
    let (Base::Struct(id) | Base::Block(id)) = ty.base else {
        return None;
    };
    let span = declared_at(spot.program(), Symbol::Struct(u32::from(id)))?;
    document.place(span)
}

/// Where what stands at an offset is named, in all of the documents; `document` is among them.
pub fn references(
    documents: &[&Document],
    document: &Document,
    offset: u32,
) -> Vec<(FileSpan, NameUse)> {
    let found = document
        .spot(offset)
        .and_then(|spot| Some((spot, spot.name()?)));
    let Some((spot, name)) = found else {
        return Vec::new();
    };
    let origin = document.origin(spot.program(), name.symbol);
    let named = documents.iter().flat_map(|d| d.named(&origin));
    let mut all: Vec<(FileSpan, NameUse)> = named.map(|n| (n.place, n.access)).collect();
    all.sort();
    all.dedup_by(|a, b| a.0 == b.0);
    all
}

/// Where what stands at an offset is named in the same text, with what is done with it there.
pub fn highlights(document: &Document, offset: u32) -> Vec<(Span, NameUse)> {
    let all = references(&[document], document, offset);
    let own = all
        .into_iter()
        .filter(|(place, _)| place.path == document.path);
    own.map(|(place, access)| (place.span, access)).collect()
}

/// Whether other files may name what a name means.
pub fn is_shared(spot: &Spot, name: Occurrence) -> bool {
    match name.symbol {
        Symbol::Variable(id) => spot
            .program()
            .variable(id)
            .is_some_and(|v| v.function.is_none()),
        Symbol::MacroParameter(..) | Symbol::Builtin(_) => false,
        Symbol::Function(_) | Symbol::Struct(_) | Symbol::Field(..) | Symbol::Macro(_) => true,
    }
}

/// A name in the text of a document that stands at an offset.
pub(super) fn name_at(document: &Document, offset: u32) -> Option<(Spot<'_>, Occurrence, Span)> {
    let spot = document.spot(offset)?;
    let name = spot.name()?;
    Some((spot, name, document.report.in_input(name.span)?))
}
