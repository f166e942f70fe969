//! Definitions, references, outlines and call hierarchies.

use super::workspace::{Related, document_at};
use crate::buffers::TextBuffer;
use crate::capabilities::symbol_kind;
use crate::snapshot::{Answer, Failure, Snapshot};
use crate::uri::path_of;
use gen_lsp_types::*;
use shaderlint_ide::{self as ide, CallItem, Document, FileSpan, NameUse, OutlineItem};
use shaderlint_project::Files;
use shaderlint_text::Span;
use std::path::Path;
use std::sync::Arc;

type Find = fn(&Document, u32, &dyn Files) -> Option<FileSpan>;

fn find(
    snapshot: &Snapshot,
    at: &TextDocumentPositionParams,
    find: Find,
) -> Answer<Option<Location>> {
    let (buffer, offset) = snapshot.place(at)?;
    let found = find(&snapshot.document(buffer), offset, &snapshot.files);
    Ok(found.and_then(|place| snapshot.location(&place)))
}

/// The definition of the symbol at a position.
pub fn definition(
    snapshot: &Snapshot,
    params: DefinitionParams,
) -> Answer<Option<DefinitionResponse>> {
    if let Some(file) = included(snapshot, &params.text_document_position_params)? {
        return Ok(Some(DefinitionResponse::Definition(Definition::Location(
            file,
        ))));
    }
    let at = &params.text_document_position_params;
    let (buffer, offset) = snapshot.place(at)?;
    let document = snapshot.document(buffer);
    if document.spot(offset).is_none() {
        let bound = ide::bound_at(&document, offset, &snapshot.files);
        let all = bound.declared().into_iter();
        let all = all.filter_map(|place| snapshot.location(place));
        let all: Vec<Location> = all.collect();
        let found = (!all.is_empty()).then_some(Definition::LocationList(all));
        return Ok(found.map(DefinitionResponse::Definition));
    }
    let found = find(snapshot, at, ide::definition)?;
    Ok(found.map(|place| DefinitionResponse::Definition(Definition::Location(place))))
}

/// The document and offset of the declaration of the input that a position in a script names; the position itself
/// where it is in a shader.
pub fn declared(snapshot: &Snapshot, document: Arc<Document>, offset: u32) -> (Arc<Document>, u32) {
    if document.spot(offset).is_some() {
        return (document, offset);
    }
    let bound = ide::bound_at(&document, offset, &snapshot.files);
    let places = bound.declared().into_iter().cloned();
    let mut found = places.filter_map(|place| {
        let document = match place.path == document.path {
            true => document.clone(),
            false => document_at(snapshot, Path::new(&place.path))?,
        };
        let offset = place.span.start;
        document
            .spot(offset)
            .is_some()
            .then_some((document, offset))
    });
    found.next().unwrap_or_else(|| (document.clone(), offset))
}

/// The file that the include directive at a position refers to.
fn included(snapshot: &Snapshot, at: &TextDocumentPositionParams) -> Answer<Option<Location>> {
    let (buffer, offset) = snapshot.place(at)?;
    let text = &buffer.text;
    let start = text
        .get(..offset as usize)
        .and_then(|t| t.rfind('\n'))
        .map_or(0, |at| at + 1);
    let line = text
        .get(start..)
        .and_then(|t| t.lines().next())
        .unwrap_or("");
    let directive = line.trim_start().strip_prefix('#').map(str::trim_start);
    let Some(path) = directive.and_then(|d| d.strip_prefix("include")) else {
        return Ok(None);
    };
    let name = path.trim().trim_matches(['"', '<', '>']);
    let document = snapshot.document(buffer);
    let files = document.report.sources.files().iter();
    let mut own = files.filter(|f| f.path != document.path);
    let file = own.find(|f| {
        f.path
            .ends_with(name.trim_start_matches("./").trim_start_matches("../"))
    });
    Ok(file.and_then(|file| {
        snapshot.location(&FileSpan {
            path: file.path.clone(),
            span: shaderlint_text::Span::at(0),
        })
    }))
}

/// The first declaration of the symbol at a position.
pub fn declaration(
    snapshot: &Snapshot,
    params: DeclarationParams,
) -> Answer<Option<DeclarationResponse>> {
    let found = find(
        snapshot,
        &params.text_document_position_params,
        ide::declaration,
    )?;
    Ok(found.map(|place| DeclarationResponse::Declaration(Declaration::Location(place))))
}

/// The declaration of the struct type of the symbol at a position.
pub fn type_definition(
    snapshot: &Snapshot,
    params: TypeDefinitionParams,
) -> Answer<Option<TypeDefinitionResponse>> {
    let found = find(
        snapshot,
        &params.text_document_position_params,
        ide::type_definition,
    )?;
    Ok(found.map(|place| TypeDefinitionResponse::Definition(Definition::Location(place))))
}

/// All references to the symbol at a position, in all files of the workspace.
pub fn references(snapshot: &Snapshot, params: ReferenceParams) -> Answer<Option<Vec<Location>>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let found = name_uses(snapshot, buffer, offset);
    let with_declaration = params.context.include_declaration;
    let is_listed = |access: NameUse| {
        with_declaration || !matches!(access, NameUse::Declared | NameUse::Defined)
    };
    let items = found.iter().filter(|(_, access)| is_listed(*access));
    Ok(Some(
        items
            .filter_map(|(place, _)| snapshot.location(place))
            .collect(),
    ))
}

/// All uses of the symbol at an offset of an open document, in the files of its project.
pub fn name_uses(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    offset: u32,
) -> Vec<(FileSpan, NameUse)> {
    let (document, offset) = declared(snapshot, snapshot.document(buffer), offset);
    let related = Related::of(snapshot, &document, offset);
    ide::references(&related.all(), &document, offset, &snapshot.files)
}

/// All references to the symbol at a position in the same document.
pub fn highlights(
    snapshot: &Snapshot,
    params: DocumentHighlightParams,
) -> Answer<Option<Vec<DocumentHighlight>>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let found = ide::highlights(&snapshot.document(buffer), offset, &snapshot.files);
    let lines = buffer.lines(snapshot.columns());
    let items = found.into_iter().map(|(span, access)| DocumentHighlight {
        range: lines.range(span),
        kind: Some(match access {
            NameUse::Written | NameUse::Changed | NameUse::Defined => DocumentHighlightKind::Write,
            NameUse::Read => DocumentHighlightKind::Read,
            NameUse::Declared | NameUse::Unseen => DocumentHighlightKind::Text,
        }),
    });
    Ok(Some(items.collect()))
}

/// The outline of a document.
pub fn outline(
    snapshot: &Snapshot,
    params: DocumentSymbolParams,
) -> Answer<Option<DocumentSymbolResponse>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let found = ide::outline(&snapshot.document(buffer));
    if !snapshot.client.nested_outline {
        let uri = &buffer.uri;
        let flat = found
            .iter()
            .map(|item| flat_symbol(snapshot, buffer, uri, item));
        return Ok(Some(DocumentSymbolResponse::SymbolInformationList(
            flat.collect(),
        )));
    }
    let items = found
        .iter()
        .map(|item| document_symbol(snapshot, buffer, item));
    Ok(Some(DocumentSymbolResponse::DocumentSymbolList(
        items.collect(),
    )))
}

#[expect(deprecated, reason = "the field is required")]
fn flat_symbol(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    uri: &Uri,
    item: &OutlineItem,
) -> SymbolInformation {
    SymbolInformation {
        location: Location {
            uri: uri.clone(),
            range: buffer.lines(snapshot.columns()).range(item.span),
        },
        base_symbol_information: BaseSymbolInformation {
            name: item.name.clone(),
            kind: symbol_kind(item.kind),
            tags: None,
            container_name: None,
        },
        deprecated: None,
    }
}

#[expect(deprecated, reason = "the field is required")]
fn document_symbol(snapshot: &Snapshot, buffer: &TextBuffer, item: &OutlineItem) -> DocumentSymbol {
    let lines = buffer.lines(snapshot.columns());
    let inner = item
        .inner
        .iter()
        .map(|inner| document_symbol(snapshot, buffer, inner));
    let inner: Vec<DocumentSymbol> = inner.collect();
    DocumentSymbol {
        name: item.name.clone(),
        detail: Some(item.detail.clone()).filter(|d| !d.is_empty()),
        kind: symbol_kind(item.kind),
        range: lines.range(item.span),
        selection_range: lines.range(item.name_span),
        children: Some(inner).filter(|inner| !inner.is_empty()),
        tags: None,
        deprecated: None,
    }
}

/// The function at a position, for the call hierarchy.
pub fn prepare_calls(
    snapshot: &Snapshot,
    params: CallHierarchyPrepareParams,
) -> Answer<Option<Vec<CallHierarchyItem>>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let found = ide::call_item(&snapshot.document(buffer), offset);
    let item = found.and_then(|item| hierarchy_item(snapshot, item));
    Ok(item.map(|item| vec![item]))
}

fn hierarchy_item(snapshot: &Snapshot, item: CallItem) -> Option<CallHierarchyItem> {
    let name = FileSpan {
        path: item.place.path.clone(),
        span: item.name_span,
    };
    let around = snapshot.location(&item.place)?;
    Some(CallHierarchyItem {
        name: item.name,
        kind: SymbolKind::Function,
        tags: None,
        detail: Some(item.detail),
        uri: around.uri,
        range: around.range,
        selection_range: snapshot.location(&name)?.range,
        data: None,
    })
}

/// The document and offset of an item that the client sends back.
fn place_of(snapshot: &Snapshot, item: &CallHierarchyItem) -> Answer<(Arc<Document>, u32)> {
    let document = match snapshot.buffer(&item.uri) {
        Ok(buffer) => snapshot.document(buffer),
        // An included file that is not open.
        Err(failure) => {
            let path = path_of(&item.uri).ok_or(failure)?;
            let read = document_at(snapshot, &path);
            read.ok_or_else(|| Failure::refused("cannot read the file"))?
        }
    };
    let start = item.selection_range.start;
    let offset = snapshot.with_lines(&document.path, |lines| lines.offset(start));
    Ok((document, offset.unwrap_or(0)))
}

/// The ranges of calls in a file.
fn ranges(snapshot: &Snapshot, path: &str, calls: &[Span]) -> Option<Vec<Range>> {
    snapshot.with_lines(path, |lines| {
        calls.iter().map(|span| lines.range(*span)).collect()
    })
}

/// The callers of a function in all files of the workspace.
pub fn incoming(
    snapshot: &Snapshot,
    params: CallHierarchyIncomingCallsParams,
) -> Answer<Option<Vec<CallHierarchyIncomingCall>>> {
    let (document, offset) = place_of(snapshot, &params.item)?;
    let related = Related::of(snapshot, &document, offset);
    let links = ide::incoming(&related.all(), &document, offset).into_iter();
    let calls = links.filter_map(|link| {
        Some(CallHierarchyIncomingCall {
            from_ranges: ranges(snapshot, &link.item.place.path, &link.calls)?,
            from: hierarchy_item(snapshot, link.item)?,
        })
    });
    Ok(Some(calls.collect()))
}

/// The callees of a function.
pub fn outgoing(
    snapshot: &Snapshot,
    params: CallHierarchyOutgoingCallsParams,
) -> Answer<Option<Vec<CallHierarchyOutgoingCall>>> {
    let (document, offset) = place_of(snapshot, &params.item)?;
    let links = ide::outgoing(&document, offset).into_iter();
    let calls = links.filter_map(|link| {
        Some(CallHierarchyOutgoingCall {
            from_ranges: ranges(snapshot, &document.path, &link.calls)?,
            to: hierarchy_item(snapshot, link.item)?,
        })
    });
    Ok(Some(calls.collect()))
}
