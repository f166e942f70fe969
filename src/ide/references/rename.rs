//! Renames a symbol if every name keeps its meaning.
//!
//! There are no special cases. The changed texts are checked again, with each branch of `#if`, and
//! the declarations that names refer to are compared. If one differs, the renaming is rejected with
//! the position.

use super::family::{NameFamily, NameHere, family, name_at};
use crate::document::{Document, FileSpan, Overlay, SymbolOrigin};
use crate::index::NameUse;
use crate::symbol::Symbol;
use shaderlint_detect::embed::MentionKind;
use shaderlint_diagnostic::Severity;
use shaderlint_project::Files;
use shaderlint_semantic::{Program, starts_a_shader};
use shaderlint_syntax::{RawKind, WordClass, classify, tokenize};
use shaderlint_text::{Edit, LineIndex, Span, apply_edits};
use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

/// The edits of a renaming.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Renaming {
    /// By path of a file: its edits, with offsets in its text.
    pub edits: BTreeMap<String, Vec<Edit>>,
}

/// Why a name cannot be renamed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RenameRefusal(pub String);

impl fmt::Display for RenameRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for RenameRefusal {}

fn refused<T>(why: impl Into<String>) -> Result<T, RenameRefusal> {
    Err(RenameRefusal(why.into()))
}

/// The span and text of the name at an offset, if it can be renamed.
///
/// # Errors
/// If the user's text does not declare the name.
pub fn may_rename(
    document: &Document,
    offset: u32,
    files: &dyn Files,
) -> Result<(Span, String), RenameRefusal> {
    let here = renamable(document, offset, files)?;
    Ok((here.span, here.text().to_string()))
}

/// The name at an offset, if it can be renamed.
fn renamable<'d>(
    document: &'d Document,
    offset: u32,
    files: &dyn Files,
) -> Result<NameHere<'d>, RenameRefusal> {
    let Some(here) = name_at(document, offset, files) else {
        return refused("no symbol to rename here");
    };
    let NameHere { spot, name, .. } = &here;
    let program = spot.program();
    let text = here.text().to_string();
    match here.origin() {
        SymbolOrigin::Given(_)
            if matches!(name.symbol, Symbol::Builtin(_)) || text.starts_with("gl_") =>
        {
            refused(format!("`{text}` is built in and cannot be renamed"))
        }
        SymbolOrigin::Given(_) => {
            let host = program.dialect.host().called;
            refused(format!(
                "`{text}` is declared by {host} and cannot be renamed"
            ))
        }
        _ if !is_identifier(&text) => refused(format!("`{text}` is not a valid identifier")),
        _ if is_entry(program, name.symbol) => {
            let host = program.dialect.host().called;
            refused(format!("{host} calls `{text}` by name"))
        }
        _ => Ok(here),
    }
}

/// Whether a host calls a function by name.
fn is_entry(program: &Program, symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Function(_)) && starts_a_shader(symbol.name(program))
}

/// Renames the symbol at an offset in all documents that refer to it; `document` is one of them.
///
/// # Errors
/// If a name would refer to another declaration, or the new name is not valid.
pub fn rename(
    documents: &[&Document],
    document: &Document,
    offset: u32,
    new: &str,
    files: &dyn Files,
) -> Result<Renaming, RenameRefusal> {
    let here = renamable(document, offset, files)?;
    is_name(here.spot.program(), new)?;
    if new == here.text() {
        return Ok(Renaming::default());
    }
    let family = family(documents, &here, files);
    certain(documents, &here, &family)?;
    let renaming = edits(documents, &family, new)?;
    verify(documents, &renaming, new, files)?;
    Ok(renaming)
}

/// Whether a text is one word.
fn is_identifier(text: &str) -> bool {
    matches!(&tokenize(text, 0)[..], [one] if one.kind == RawKind::Word)
}

/// Whether a word is a valid name.
fn is_name(program: &Program, word: &str) -> Result<(), RenameRefusal> {
    if !is_identifier(word) {
        return refused(format!("`{word}` is not a valid identifier"));
    }
    let is_taken = classify(word, program.version) != WordClass::Plain;
    if is_taken {
        return refused(format!("`{word}` is a keyword or reserved word"));
    }
    if word.starts_with("gl_") || word.contains("__") {
        return refused("names that start with `gl_` or contain `__` are reserved");
    }
    Ok(())
}

/// Whether it is known what the names refer to.
fn certain(
    documents: &[&Document],
    here: &NameHere,
    family: &NameFamily,
) -> Result<(), RenameRefusal> {
    let name = here.text();
    let document = |at: usize| documents.get(at).copied().unwrap_or(here.spot.document);
    if let Some(place) = family.uncertain.first() {
        let at = family.places.get(place).map_or(0, |(_, at)| *at);
        let at = located(document(at), place);
        return refused(format!("`{name}` in {at} may refer to another declaration"));
    }
    let mut unclear = family.mentions.iter();
    if let Some((place, (_, at))) = unclear.find(|(_, (kind, _))| *kind == MentionKind::Unclear) {
        let at = located(document(*at), place);
        return refused(format!("{at} may refer to `{name}`"));
    }
    let is_given = |origin: &SymbolOrigin| matches!(origin, SymbolOrigin::Given(_));
    if family.origins.iter().any(is_given) {
        return refused(format!(
            "`{name}` is not declared here in every branch of `#if`"
        ));
    }
    Ok(())
}

/// The edits that rename a symbol.
fn edits(
    documents: &[&Document],
    family: &NameFamily,
    new: &str,
) -> Result<Renaming, RenameRefusal> {
    let mut renaming = Renaming::default();
    for (place, (kind, _)) in &family.mentions {
        let edit = match kind {
            MentionKind::Shorthand => Edit::insert(place.span.start, format!("{new}: ")),
            MentionKind::Name | MentionKind::Edited | MentionKind::Unclear => {
                Edit::replace(place.span, new)
            }
        };
        renaming
            .edits
            .entry(place.path.clone())
            .or_default()
            .push(edit);
    }
    for (place, (_, at)) in &family.places {
        let Some(document) = documents.get(*at) else {
            continue;
        };
        let edit = match place.path == document.path {
            // Embedded shaders may require escapes.
            true => written(document, place, new),
            false => Some(Edit::replace(place.span, new)),
        };
        let Some(edit) = edit else {
            return refused(format!("cannot edit {}", located(document, place)));
        };
        let edits = renaming.edits.entry(place.path.clone()).or_default();
        edits.push(edit);
    }
    for edits in renaming.edits.values_mut() {
        edits.sort_by_key(|edit| edit.span.start);
    }
    Ok(renaming)
}

/// The edit that renames an occurrence in a document.
fn written(document: &Document, place: &FileSpan, new: &str) -> Option<Edit> {
    let start = document.report.address(place.span.start)?;
    let end = document.report.address(place.span.end)?;
    let edit = Edit::replace(Span::new(start, end), new);
    document.report.edit_of_input(&edit)
}

fn located(document: &Document, place: &FileSpan) -> String {
    let name = place.path.rsplit('/').next().unwrap_or(&place.path);
    if place.path != document.path {
        return format!("`{name}`");
    }
    let line = LineIndex::new(&document.text).line(place.span.start);
    format!("line {line} of `{name}`")
}

/// Checks the changed texts, and compares the declarations that names refer to.
fn verify(
    documents: &[&Document],
    renaming: &Renaming,
    new: &str,
    files: &dyn Files,
) -> Result<(), RenameRefusal> {
    let mut texts: BTreeMap<PathBuf, Arc<str>> = BTreeMap::new();
    for (path, edits) in &renaming.edits {
        let known = documents.iter().find(|d| d.path == *path);
        let text = match known {
            Some(document) => document.text.clone(),
            None => match files.load(path.as_ref()) {
                Ok(text) => text,
                Err(error) => return refused(format!("`{path}`: {error}")),
            },
        };
        let Ok(changed) = apply_edits(&text, 0, edits) else {
            return refused(format!("cannot edit `{path}`: edits overlap"));
        };
        texts.insert(path.into(), changed.into());
    }
    let overlay = Overlay { files, texts };
    for document in documents {
        let text = overlay
            .texts
            .get(document.path.as_ref() as &std::path::Path);
        let text = text.cloned().unwrap_or_else(|| document.text.clone());
        let before = document.read_as(document.text.to_string(), files);
        let after = document.read_as(text.to_string(), &overlay);
        compare(&before, &after, renaming, new)?;
        // Those of the document were read without rules too, when its names were searched.
        let (old, now) = (document.alternatives(files), after.alternatives(&overlay));
        if old.len() != now.len() {
            return refused(format!(
                "renaming to `{new}` changes which code is compiled"
            ));
        }
        for (before, after) in old.iter().zip(now) {
            compare(before, after, renaming, new)?;
        }
    }
    Ok(())
}

/// A name and its declaration.
type NameMeaning = (FileSpan, Option<FileSpan>);

/// Rejects a renaming that changes the meaning of a name.
fn compare(
    before: &Document,
    after: &Document,
    renaming: &Renaming,
    new: &str,
) -> Result<(), RenameRefusal> {
    let errors = |document: &Document| {
        let all = document.report.diagnostics.iter();
        let errors = all.filter(|d| d.severity == Severity::Error);
        errors.map(|d| d.message.clone()).collect::<Vec<_>>()
    };
    let (old_errors, new_errors) = (errors(before), errors(after));
    if let Some(error) = new_errors.iter().find(|e| !old_errors.contains(e))
        && new_errors.len() > old_errors.len()
    {
        return refused(format!("renaming to `{new}` causes an error: {error}"));
    }
    let moved: Vec<Vec<NameMeaning>> = meanings(before, Some(renaming));
    let now: Vec<Vec<NameMeaning>> = meanings(after, None);
    if moved.len() != now.len() {
        return refused(format!(
            "renaming to `{new}` changes how the file is parsed"
        ));
    }
    for (was, is) in moved.iter().zip(&now) {
        let differs = was.iter().zip(is).find(|(was, is)| was != is);
        let longer = || was.get(is.len()).or(is.get(was.len()));
        let Some(place) = differs.map(|(was, is)| was.min(is)).or_else(longer) else {
            continue;
        };
        let at = located(after, &place.0);
        return refused(format!(
            "`{new}` would refer to another declaration in {at}"
        ));
    }
    Ok(())
}

/// How edits move the text after them.
struct Shift<'r> {
    /// By path: the start of each edit, and the growth of the text up to its end.
    by_path: BTreeMap<&'r str, Vec<(u32, i64)>>,
}

impl Shift<'_> {
    fn of(renaming: &Renaming) -> Shift<'_> {
        let by_path = renaming.edits.iter().map(|(path, edits)| {
            let mut grown = 0;
            let steps = edits.iter().map(|edit| {
                grown += edit.text.len() as i64 - i64::from(edit.span.len());
                (edit.span.start, grown)
            });
            (path.as_str(), steps.collect())
        });
        Shift {
            by_path: by_path.collect(),
        }
    }

    /// The position after the edits. A renamed name keeps its start.
    fn moved(&self, place: FileSpan) -> FileSpan {
        let steps = self.by_path.get(place.path.as_str());
        let steps = steps.map_or(&[][..], Vec::as_slice);
        let by = |offset: u32| {
            let before = steps.partition_point(|(start, _)| *start < offset);
            let last = before.checked_sub(1).and_then(|i| steps.get(i));
            let moved = i64::from(offset) + last.map_or(0, |(_, grown)| *grown);
            moved.max(0) as u32
        };
        FileSpan {
            span: Span::new(by(place.span.start), by(place.span.end)),
            ..place
        }
    }
}

/// By shader: the names and their declarations, with positions after the renaming.
fn meanings(document: &Document, renaming: Option<&Renaming>) -> Vec<Vec<NameMeaning>> {
    let shift = renaming.map(Shift::of);
    let moved = |place: FileSpan| match &shift {
        Some(shift) => shift.moved(place),
        None => place,
    };
    let of = |(program, index): (&Program, &crate::Index)| {
        let mut origins: BTreeMap<Symbol, Option<FileSpan>> = BTreeMap::new();
        let seen = index.all.iter().filter(|o| o.access != NameUse::Unseen);
        let meaning = seen.filter_map(|o| {
            let place = document.place(o.span).map(&moved)?;
            let origin = origins.entry(o.symbol).or_insert_with(|| {
                match document.origin(program, o.symbol) {
                    SymbolOrigin::Text(place) | SymbolOrigin::MacroParameter(place, _) => {
                        Some(moved(place))
                    }
                    // Stages are linked by name, independent of positions.
                    SymbolOrigin::Interface(..) | SymbolOrigin::Given(_) => None,
                }
            });
            Some((place, origin.clone()))
        });
        meaning.collect()
    };
    document.shaders().map(of).collect()
}
