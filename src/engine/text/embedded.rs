//! Shaders embedded in pages, scripts and documents.

use super::foreign;
use super::leading_blanks::leading_blanks;
use super::pieces::pieces;
use super::shader_file::shaders;
use crate::check_context::CheckContext;
use crate::hosts::hosted;
use crate::options::Options;
use crate::shader::input::SplitInput;
use crate::shader::reading::{InputText, Surroundings};
use crate::shader::shader_input::ShaderInput;
use shaderlint_detect::embed::{
    DocumentLanguage, Embedded, Embedder, LeadingBlanks, NamedStage, Wrapping, joined,
};
use shaderlint_detect::kind::{
    Evidence, ShaderLanguage, has_main, own_directive, without_annotations,
};
use shaderlint_diagnostic::{Applicability, Diagnostic, error};
use shaderlint_host::shadertoy;
use shaderlint_project::{MissingInclude, imported_hosts, spread_chunks};
use shaderlint_semantic::snippet::{SnippetItem, items};
use shaderlint_semantic::{GuessedKind, Stage, guess, needs_300};
use shaderlint_syntax::{Version, WordClass, classify};
use shaderlint_text::{FileId, Role};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// Maximum number of scopes in an excerpt, and of declarations in a chapter.
const MAX_SCOPES: usize = 100;

/// Adds the embedded shaders of a file. `None` if they are too large.
pub fn parts(
    input: &mut SplitInput,
    name: &str,
    language: DocumentLanguage,
    file: FileId,
    text: &str,
    context: CheckContext,
) -> Option<()> {
    let options = context.options;
    let mut all = std::mem::take(&mut input.embedded);
    let embedder = embedder((name, text), language, &all, context);
    if embedder.leading_blanks == LeadingBlanks::Trimmed {
        all.iter_mut().for_each(Embedded::trim_start);
    }
    remove_annotations(text, &mut all);
    let is_300 = language == DocumentLanguage::Markdown && speaks_of_300(&all);
    // A script that contains `#version` may write it before any of its shaders.
    let is_unchanged = embedder.hands_over && !embedder.joins;
    let is_compiled = is_unchanged && !text.contains("#version") && !writes_precision(text, &all);
    let is_document = matches!(
        language,
        DocumentLanguage::Markdown | DocumentLanguage::Html
    );
    let is_desktop = is_document && speaks_of_desktop(text);
    let around = FileContext {
        is_300,
        is_compiled,
    };
    let mut known = ChapterVariables::default();
    let mut modules = HashMap::new();
    for (index, embedded) in all.iter().enumerate() {
        known.enter(embedded.chapter);
        // It is checked in the shaders that insert it.
        if embedded.is_part {
            continue;
        }
        let is_part = |code: &str| {
            let guessed = guess(code);
            !code.contains("#version") && !guessed.has_main && !guessed.is_shadertoy()
        };
        if own_directive(&embedded.code).is_some() || is_desktop && is_part(&embedded.code) {
            continue;
        }
        if foreign::is_reported(&embedded.code, options) {
            let place = (file, embedded.start);
            if hosted::part(input, name, place, &embedded.code, context)? {
                continue;
            }
        }
        if foreign::inside(input, file, embedded, options)? {
            continue;
        }
        let read = match is_excerpt(embedded) {
            true => excerpt(input, file, embedded, &mut known)?,
            false => {
                let sources = Arc::make_mut(&mut input.sources);
                pieces(sources, file, embedded, &mut modules)?
            }
        };
        let read = with_imports(input, (name, file), embedded, read, context)?;
        let shaders = shaders_of(input, embedded, read, around, options)?.into_iter();
        input.parts.extend(shaders.map(|shader| ShaderInput {
            embedded: Some(index),
            embedder,
            is_of_library: embedded.chunk.is_some(),
            ..shader
        }));
    }
    input.embedded = all;
    Some(())
}

/// Removes what the host of a page or script removes from declarations.
fn remove_annotations(text: &str, all: &mut [Embedded]) {
    let is_annotated = |e: &Embedded| e.code.contains(':') && e.chunk.is_none();
    if all.iter().any(is_annotated) && imported_hosts(text).iter().any(|h| h.takes_annotations) {
        all.iter_mut()
            .for_each(|e| e.code = without_annotations(&e.code));
    }
}

/// The files of a text with the chunks of a library that it imports, and the chunks that are missing.
fn with_imports(
    input: &mut SplitInput,
    (name, file): (&str, FileId),
    embedded: &Embedded,
    read: Vec<FileId>,
    context: CheckContext,
) -> Option<(Vec<FileId>, Vec<MissingInclude>)> {
    let imports = |_: &&String| embedded.code.contains("#import ") && !is_shown(embedded);
    let Some(chunk) = embedded.chunk.as_ref().filter(imports) else {
        return Some((read, Vec::new()));
    };
    let text = (chunk.as_str(), embedded.start, embedded.code.as_str());
    let access = context.file_access();
    let found = spread_chunks(&mut input.sources, (name, file), text, access)?;
    input.problems.extend(found.problems);
    input.hushed.extend(found.hushed);
    Some((found.files, found.missing))
}

/// What the program around the shaders does. A document shows code of several programs.
fn embedder(
    (name, text): (&str, &str),
    language: DocumentLanguage,
    all: &[Embedded],
    context: CheckContext,
) -> Embedder {
    if matches!(language, DocumentLanguage::Markdown | DocumentLanguage::Kdl) {
        return Embedder::default();
    }
    let own = Embedder::of(language, text);
    // What scripts do with leading white space only matters for shaders that start with it.
    let starts_blank = |e: &Embedded| e.code.starts_with(char::is_whitespace);
    match all.iter().any(starts_blank) {
        true => Embedder {
            leading_blanks: leading_blanks(name, text, own, context),
            ..own
        },
        false => own,
    }
}

/// What is known about the file around a shader.
#[derive(Clone, Copy)]
struct FileContext {
    /// Whether it uses only GLSL ES 3.00.
    is_300: bool,
    /// Whether it compiles its shaders itself, unchanged.
    is_compiled: bool,
}

/// Whether shaders of a document use GLSL ES 3.00 or ShaderToy, and none uses 1.00. Then its
/// excerpts have that version too.
fn speaks_of_300(all: &[Embedded]) -> bool {
    let shadertoy = shadertoy();
    let words = shadertoy.map_or(&[][..], |p| p.words.as_slice());
    let is_new = |e: &Embedded| {
        let uses_player = words.iter().any(|w| e.code.contains(w.as_str()));
        uses_player || guess(&e.code).is_shadertoy() || needs_300(&e.code)
    };
    let is_old = |e: &Embedded| guess(&e.code).kind == Some(GuessedKind::WebGl1);
    all.iter().any(is_new) && !all.iter().any(is_old)
}

/// Whether a document has shaders of desktop GLSL and none of GLSL ES. Then its excerpts are desktop GLSL
/// too.
fn speaks_of_desktop(text: &str) -> bool {
    let lines = text.lines().map(str::trim_start);
    let versions = lines.filter(|line| line.starts_with("#version "));
    let mut versions = versions.map(|line| Evidence::of(line).foreign()).peekable();
    versions.peek().is_some() && versions.all(|found| found == Some(ShaderLanguage::Desktop))
}

/// Whether it is shown, not run.
fn is_shown(embedded: &Embedded) -> bool {
    matches!(embedded.wrapping, Wrapping::Fence | Wrapping::Listing)
}

/// Whether it shows only parts of a shader.
fn is_excerpt(embedded: &Embedded) -> bool {
    let code = embedded.code.as_str();
    let guessed = guess(code);
    let has_entry =
        guessed.has_main || guessed.is_shadertoy() || code.trim_start().starts_with("#version");
    is_shown(embedded) && (!has_entry || embedded.has_holes)
}

fn shaders_of(
    input: &mut SplitInput,
    embedded: &Embedded,
    (files, missing): (Vec<FileId>, Vec<MissingInclude>),
    around: FileContext,
    options: &Options,
) -> Option<Vec<ShaderInput>> {
    let code = embedded.code.as_str();
    let guessed = guess(code);
    let text = InputText {
        files,
        stage: match embedded.stage {
            Some(NamedStage::Vertex) => Some(Stage::Vertex),
            // Some pages name both stages alike.
            Some(NamedStage::Fragment) if guessed.stage != Some(Stage::Vertex) => {
                Some(Stage::Fragment)
            }
            _ => None,
        },
        surroundings: match embedded.wrapping {
            Wrapping::Element => Surroundings::Element,
            Wrapping::Template | Wrapping::Quotes | Wrapping::Raw => Surroundings::Literal,
            Wrapping::Fence | Wrapping::Listing => Surroundings::Shown,
        },
        is_open: !missing.is_empty(),
        is_composed: false,
        is_compiled: around.is_compiled && !is_shown(embedded),
        is_300: around.is_300,
        has_holes: is_excerpt(embedded) || embedded.has_holes,
        macros: String::new(),
    };
    shaders(input, (code, guessed), (text, missing), options)
}

/// Completes an excerpt: its functions and directives, then its statements in a function. Each
/// declaration opens a new scope, because documents repeat names.
fn excerpt(
    input: &mut SplitInput,
    file: FileId,
    embedded: &Embedded,
    known: &mut ChapterVariables,
) -> Option<Vec<FileId>> {
    let sources = Arc::make_mut(&mut input.sources);
    let items = items(&embedded.code);
    if items.iter().all(|i| matches!(i, SnippetItem::Global(_))) {
        return Some(vec![sources.embed(
            file,
            embedded.start,
            embedded.code.as_str(),
        )?]);
    }
    let mut globals = Vec::new();
    let mut statements = Vec::new();
    let open = sources.add("", None, Role::Prelude, "{")?;
    let mut scopes = 0;
    let mut declared = Vec::new();
    for item in items {
        let (range, into) = match &item {
            SnippetItem::Global(range) => (range, &mut globals),
            SnippetItem::Declaration(range) | SnippetItem::Statement(range) => {
                (range, &mut statements)
            }
        };
        if matches!(item, SnippetItem::Declaration(_)) && scopes < MAX_SCOPES {
            into.push(open);
            scopes += 1;
        }
        let code = embedded.code.get(range.clone())?;
        if matches!(item, SnippetItem::Declaration(_)) {
            declared.push(code);
        }
        into.push(sources.embed(file, embedded.start + range.start, code)?);
    }
    let function = format!("\nvoid excerpt_of_a_shader() {{\n{}", known.declarations());
    let function = sources.add("", None, Role::Prelude, function)?;
    let close = sources.add("", None, Role::Prelude, "\n}".repeat(scopes + 1))?;
    globals.push(function);
    globals.append(&mut statements);
    globals.push(close);
    declared.into_iter().for_each(|code| known.declare(code));
    Some(globals)
}

/// The variables that excerpts of a chapter have declared so far.
#[derive(Default)]
struct ChapterVariables {
    chapter: u32,
    /// By name: the type, or `None` if the document declares several.
    types: BTreeMap<String, Option<String>>,
}

impl ChapterVariables {
    fn enter(&mut self, chapter: u32) {
        if chapter != self.chapter {
            self.chapter = chapter;
            self.types.clear();
        }
    }

    fn declare(&mut self, code: &str) {
        let Some((ty, rest)) = code.split_once(char::is_whitespace) else {
            return;
        };
        let rest = rest.trim_start();
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let (name, after) = rest.split_at(end.unwrap_or(rest.len()));
        let of_type = classify(ty, Version::Es300);
        if matches!(of_type, WordClass::Type(_))
            && self.types.len() < MAX_SCOPES
            && after.trim_start().starts_with(['=', ';'])
        {
            let known = self.types.entry(name.to_string());
            let known = known.or_insert_with(|| Some(ty.to_string()));
            if known.as_deref() != Some(ty) {
                *known = None;
            }
        }
    }

    fn declarations(&self) -> String {
        let of =
            |(name, ty): (&String, &Option<String>)| Some(format!("{} {name};\n", ty.as_ref()?));
        self.types.iter().filter_map(of).collect()
    }
}

/// Replaces a fix that cannot be written in the surrounding language with a help.
pub fn note_fix(diagnostic: &mut Diagnostic) {
    let Some(fix) = diagnostic.fix.take() else {
        return;
    };
    if fix.applicability == Applicability::Safe || diagnostic.help.is_empty() {
        let is_version = diagnostic.is(error::VERSION_PLACEMENT);
        diagnostic.help.push(if is_version {
            "start the string with `#version`".to_string()
        } else {
            fix.title
        });
    }
}

/// Whether a script has a default precision outside of its complete shaders, which it may write before them.
fn writes_precision(text: &str, all: &[Embedded]) -> bool {
    let is_complete = |shader: &&Embedded| has_main(&joined(&shader.code, &shader.inserted));
    let complete: Vec<&Embedded> = all.iter().filter(is_complete).collect();
    let is_own = |at: usize| complete.iter().any(|shader| shader.holds(at));
    let mut statements = text.match_indices("precision ").filter(|(at, word)| {
        let after = text.get(at + word.len()..).unwrap_or("");
        ["highp ", "mediump ", "lowp "]
            .iter()
            .any(|p| after.starts_with(p))
    });
    statements.any(|(at, _)| !is_own(at))
}
