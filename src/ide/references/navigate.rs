//! Definitions and references.

use super::family::{NameHere, family, name_at};
use crate::document::{Document, FileSpan, Spot};
use crate::index::{NameUse, Occurrence};
use crate::symbol::{Symbol, declared_at};
use shaderlint_detect::embed::MentionKind;
use shaderlint_project::Files;
use shaderlint_semantic::Base;
use shaderlint_text::Span;

/// The definition of the symbol at an offset; of a function, its body.
pub fn definition(document: &Document, offset: u32, files: &dyn Files) -> Option<FileSpan> {
    let NameHere { spot, name, .. } = name_at(document, offset, files)?;
    let span = match name.symbol {
        Symbol::MacroParameter(..) => defined_in(&spot, name.symbol)?,
        _ => declared_at(spot.program(), name.symbol)?,
    };
    spot.document.place(span)
}

/// The first declaration of the symbol at an offset; of a function, its prototype.
pub fn declaration(document: &Document, offset: u32, files: &dyn Files) -> Option<FileSpan> {
    let NameHere { spot, name, .. } = name_at(document, offset, files)?;
    let mut all = spot.index().named(name.symbol);
    let declared = all.find(|o| matches!(o.access, NameUse::Declared | NameUse::Defined));
    spot.document.place(declared?.span)
}

fn defined_in(spot: &Spot, symbol: Symbol) -> Option<Span> {
    let mut all = spot.index().named(symbol);
    all.find(|o| o.access == NameUse::Defined).map(|o| o.span)
}

/// The declaration of the struct type of the symbol at an offset.
pub fn type_definition(document: &Document, offset: u32, files: &dyn Files) -> Option<FileSpan> {
    let NameHere { spot, name, .. } = name_at(document, offset, files)?;
    let ty = name.symbol.ty(spot.program())?;
    let (Base::Struct(id) | Base::Block(id)) = ty.base else {
        return None;
    };
    let span = declared_at(spot.program(), Symbol::Struct(u32::from(id)))?;
    spot.document.place(span)
}

/// The references to the symbol at an offset in all documents; `document` is one of them.
pub fn references(
    documents: &[&Document],
    document: &Document,
    offset: u32,
    files: &dyn Files,
) -> Vec<(FileSpan, NameUse)> {
    let Some(here) = name_at(document, offset, files) else {
        return Vec::new();
    };
    let family = family(documents, &here, files);
    let mut places = family.places;
    for (place, (kind, at)) in family.mentions {
        if kind != MentionKind::Unclear {
            places.insert(place, (NameUse::Unseen, at));
        }
    }
    let places = places.into_iter();
    places.map(|(place, (access, _))| (place, access)).collect()
}

/// The references to the symbol at an offset in the same document, with their uses.
pub fn highlights(document: &Document, offset: u32, files: &dyn Files) -> Vec<(Span, NameUse)> {
    let all = references(&[document], document, offset, files);
    let own = all
        .into_iter()
        .filter(|(place, _)| place.path == document.path);
    own.map(|(place, access)| (place.span, access)).collect()
}

/// The name at an offset, if other files may refer to its symbol.
pub fn shared_name(document: &Document, offset: u32, files: &dyn Files) -> Option<String> {
    let here = name_at(document, offset, files)?;
    let is_shared = is_shared(&here.spot, here.name) && !here.text().is_empty();
    is_shared.then(|| here.text().to_string())
}

/// Whether other files may refer to a symbol.
fn is_shared(spot: &Spot, name: Occurrence) -> bool {
    match name.symbol {
        Symbol::Variable(id) => spot
            .program()
            .variable(id)
            .is_some_and(|v| v.function.is_none()),
        Symbol::MacroParameter(..) | Symbol::Builtin(_) => false,
        Symbol::Function(_) | Symbol::Struct(_) | Symbol::Field(..) | Symbol::Macro(_) => true,
    }
}
