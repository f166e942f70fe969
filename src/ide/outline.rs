//! The outline of a document: functions, structs with members, globals, macros.

use super::document::Document;
use super::symbol::{Symbol, SymbolKind, declared_at};
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_syntax::ast::{DeclKind, Extent, Item, TokenId};
use shaderlint_text::Span;

/// An item of the outline.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OutlineItem {
    /// Declared name.
    pub name: String,
    /// Type or signature.
    pub detail: String,
    /// Kind of symbol.
    pub kind: SymbolKind,
    /// Span of the declaration.
    pub span: Span,
    /// Span of the name.
    pub name_span: Span,
    /// Members.
    pub inner: Vec<OutlineItem>,
}

/// The global declarations of a document, in source order.
pub fn outline(document: &Document) -> Vec<OutlineItem> {
    let mut found: Vec<OutlineItem> = Vec::new();
    for (program, _) in document.shaders() {
        let add = |symbol, extent| item(document, program, symbol, extent);
        let functions = program.functions.iter().zip(0..);
        found.extend(functions.filter_map(|(function, id)| {
            let declared = function.definition.unwrap_or(function.declaration);
            let extent = program.tree.function(declared)?.extent;
            add(Symbol::Function(FunctionRef(id)), Some(extent))
        }));
        let structs = (0..program.structs.len() as u32).map(Symbol::Struct);
        found.extend(structs.filter_map(|symbol| {
            let extent = struct_extent(program, symbol);
            let mut found = add(symbol, extent)?;
            found.inner = fields(document, program, symbol);
            Some(found)
        }));
        let variables = program.variables.iter().zip(0..);
        let globals = variables.filter(|(v, _)| v.function.is_none() && v.token.is_some());
        found.extend(globals.filter_map(|(variable, id)| {
            let symbol = Symbol::Variable(VariableId(id));
            add(symbol, variable.token.and_then(|t| item_around(program, t)))
        }));
        let macros = program.tokens.macros.iter().filter(|m| !m.predefined);
        found.extend(macros.filter_map(|m| add(Symbol::Macro(m.name), None)));
    }
    found.sort_by(|a, b| (a.name_span, &a.name).cmp(&(b.name_span, &b.name)));
    found.dedup_by_key(|item| item.name_span);
    found
}

fn item(
    document: &Document,
    program: &Program,
    symbol: Symbol,
    extent: Option<Extent>,
) -> Option<OutlineItem> {
    let own = declared_at(program, symbol)?;
    let name_span = document.report.in_input(own).filter(|s| !s.is_empty())?;
    let around = extent.and_then(|extent| document.report.in_input(program.span(extent)));
    let around = around.filter(|span| span.contains(name_span));
    let detail = match symbol {
        Symbol::Function(_) => symbol.declaration(program),
        Symbol::Variable(_) | Symbol::Field(..) => symbol
            .ty(program)
            .map_or(String::new(), |ty| program.type_name(ty)),
        _ => String::new(),
    };
    Some(OutlineItem {
        name: symbol.name(program).to_string(),
        detail,
        kind: symbol.kind(program),
        span: around.unwrap_or(name_span),
        name_span,
        inner: Vec::new(),
    })
}

fn struct_extent(program: &Program, symbol: Symbol) -> Option<Extent> {
    let Symbol::Struct(id) = symbol else {
        return None;
    };
    let token = program.structs.get(id as usize)?.token;
    let all = program.tree.structs.iter().map(|s| s.extent);
    let mut around = all.filter(|e| e.contains(Extent::token(token)));
    around.next()
}

fn fields(document: &Document, program: &Program, symbol: Symbol) -> Vec<OutlineItem> {
    let Symbol::Struct(id) = symbol else {
        return Vec::new();
    };
    let count = program
        .structs
        .get(id as usize)
        .map_or(0, |s| s.fields.len() as u32);
    let all = (0..count).map(|at| Symbol::Field(id, at));
    all.filter_map(|field| item(document, program, field, None))
        .collect()
}

/// The global declaration that contains a token.
fn item_around(program: &Program, token: TokenId) -> Option<Extent> {
    let inside = Extent::token(token);
    let extents = program.tree.items.iter().filter_map(|item| match item {
        Item::Decl(id) => program.tree.decl(*id),
        Item::Function(_) => None,
    });
    let mut around =
        extents.filter(|d| !matches!(d.kind, DeclKind::Prototype(_)) && d.extent.contains(inside));
    around.next().map(|d| d.extent)
}
