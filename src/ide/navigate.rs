//! Definitions and references.

use super::document::{Document, FileSpan, Spot};
use super::index::{NameUse, Occurrence};
use super::symbol::{Symbol, declared_at};
use shaderlint_semantic::Base;
use shaderlint_text::Span;

/// The definition of the symbol at an offset; of a function, its body.
pub fn definition(document: &Document, offset: u32) -> Option<FileSpan> {
    let spot = document.spot(offset)?;
    let symbol = spot.name()?.symbol;
    let span = match symbol {
        Symbol::MacroParameter(..) => defined_in(&spot, symbol)?,
        _ => declared_at(spot.program(), symbol)?,
    };
    document.place(span)
}

/// The first declaration of the symbol at an offset; of a function, its prototype.
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

/// The declaration of the struct type of the symbol at an offset.
pub fn type_definition(document: &Document, offset: u32) -> Option<FileSpan> {
    let spot = document.spot(offset)?;
    let ty = spot.name()?.symbol.ty(spot.program())?;
    let (Base::Struct(id) | Base::Block(id)) = ty.base else {
        return None;
    };
    let span = declared_at(spot.program(), Symbol::Struct(u32::from(id)))?;
    document.place(span)
}

/// The references to the symbol at an offset in all documents; `document` is one of them.
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

/// The references to the symbol at an offset in the same document, with their uses.
pub fn highlights(document: &Document, offset: u32) -> Vec<(Span, NameUse)> {
    let all = references(&[document], document, offset);
    let own = all
        .into_iter()
        .filter(|(place, _)| place.path == document.path);
    own.map(|(place, access)| (place.span, access)).collect()
}

/// Whether other files may refer to a symbol.
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

/// The name at an offset, with its span in the document.
pub(super) fn name_at(document: &Document, offset: u32) -> Option<(Spot<'_>, Occurrence, Span)> {
    let spot = document.spot(offset)?;
    let name = spot.name()?;
    Some((spot, name, document.report.in_input(name.span)?))
}
