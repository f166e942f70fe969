//! The inputs of shaders in the scripts that set them.

use crate::document::{Document, FileSpan};
use crate::symbol::declared_at;
use shaderlint_contract::{Contract, InputValue, ProgramBindings};
use shaderlint_detect::embed::{DocumentLanguage, MentionKind, NameRole, mentions};
use shaderlint_detect::kind::file_extension;
use shaderlint_engine::known_contracts;
use shaderlint_project::Files;
use shaderlint_script::ScriptPlace;
use shaderlint_text::Span;
use shaderlint_text::path::slashed;
use std::collections::BTreeSet;

/// Maximum number of places that a hover lists.
const MAX_SHOWN: usize = 6;

/// An input of the shaders of a program that a script makes.
pub struct BoundName {
    /// Its declarations in all stages.
    pub declared: Vec<FileSpan>,
    /// The places of scripts that name it.
    pub mentions: Vec<FileSpan>,
    /// The places of scripts that may compute its name.
    pub computed: Vec<FileSpan>,
    /// What a hover of a script shows, a paragraph each: the declaration and its places.
    declarations: Vec<String>,
    /// Where scripts set it.
    settings: Vec<String>,
}

impl BoundName {
    fn of(contract: &Contract, program: &ProgramBindings, name: &str) -> Option<BoundName> {
        let input = program.input(name)?;
        let span = |place: &ScriptPlace| {
            let (path, _) = contract.files.get(place.file)?;
            Some(FileSpan {
                path: slashed(path),
                span: Span::new(place.start, place.end),
            })
        };
        let mentions = program.mentions.iter().filter(|(own, _)| own == name);
        let computed = program.computed.iter();
        let computed = computed.filter(|(own, _)| own.as_ref().is_none_or(|own| own == name));
        let word = if input.is_attribute { "in" } else { "uniform" };
        let declaration = format!("```glsl\n{word} {} {name}\n```\n", input.type_name);
        let lines = input
            .declared
            .iter()
            .filter_map(|place| contract.line(*place));
        let lines = lines.map(|line| format!("\ndeclared in `{line}`\n"));
        let settings = input
            .settings
            .iter()
            .enumerate()
            .filter_map(|(index, setting)| {
                let line = contract.line(setting.place)?;
                Some(match (&setting.value, index) {
                    (Some(InputValue::Numbers(all)), _) if input.type_name == "bool" => {
                        format!("\nset to `{}` in `{line}`\n", all != &[0.0])
                    }
                    (Some(value), _) => format!("\nset to `{value}` in `{line}`\n"),
                    (None, 0) => format!("\nset in `{line}`\n"),
                    (None, _) => format!("\nchanged in `{line}`\n"),
                })
            });
        Some(BoundName {
            declared: input.declared.iter().filter_map(span).collect(),
            mentions: mentions.filter_map(|(_, place)| span(place)).collect(),
            computed: computed.filter_map(|(_, place)| span(place)).collect(),
            declarations: std::iter::once(declaration).chain(lines).collect(),
            settings: settings.collect(),
        })
    }
}

/// The inputs of one name that a position in a script or shader refers to.
#[derive(Default)]
pub struct BoundNames {
    /// The name: in the document for scripts, in the sources for shaders.
    pub span: Span,
    /// In each program.
    pub all: Vec<BoundName>,
}

/// The inputs of a name in the programs around a document.
fn inputs(document: &Document, name: &str, files: &dyn Files) -> Vec<BoundName> {
    let around = known_contracts(&document.path, &document.text, &document.options, files);
    let programs = around
        .iter()
        .flat_map(|c| c.bindings.iter().map(move |p| (c, p)));
    programs
        .filter_map(|(c, p)| BoundName::of(c, p, name))
        .collect()
}

/// The input of a shader that an offset in a script or shader refers to.
pub fn bound_at(document: &Document, offset: u32, files: &dyn Files) -> BoundNames {
    if let Some(spot) = document.spot(offset) {
        let program = spot.program();
        let name = spot.name();
        let place = name.and_then(|name| document.place(declared_at(program, name.symbol)?));
        let (Some(name), Some(place)) = (name, place) else {
            return BoundNames::default();
        };
        let mut all = inputs(document, name.symbol.name(program), files);
        all.retain(|bound| bound.declared.contains(&place));
        let span = name.span;
        return BoundNames { span, all };
    }
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let parts = document.text.split_at_checked(offset as usize);
    let (before, after) = parts.unwrap_or_default();
    let start = before.trim_end_matches(is_part).len();
    let length = after.len() - after.trim_start_matches(is_part).len();
    let span = Span::new(start as u32, offset + length as u32);
    let name = document.text.get(start..span.end as usize).unwrap_or("");
    let own = FileSpan {
        path: document.path.clone(),
        span,
    };
    let mut all = inputs(document, name, files);
    if all.iter().any(|bound| bound.mentions.contains(&own)) {
        all.retain(|bound| bound.mentions.contains(&own));
    } else if !all.is_empty() {
        // Code that is not evaluated names it too.
        let language = DocumentLanguage::of_extension(&file_extension(&document.path));
        let named = language.map(|of| mentions(of, &document.text, name, NameRole::Input));
        let is_it = named.unwrap_or_default().iter().any(|mention| {
            mention.range.start == start
                && matches!(mention.kind, MentionKind::Name | MentionKind::Shorthand)
        });
        all.retain(|_| is_it);
    }
    BoundNames { span, all }
}

/// All of some paragraphs, each once.
fn distinct<'t>(all: impl Iterator<Item = &'t String>) -> Vec<&'t str> {
    let mut found: Vec<&str> = Vec::new();
    for text in all {
        if !found.contains(&text.as_str()) {
            found.push(text);
        }
    }
    found
}

impl BoundNames {
    /// The declarations in all programs, each once.
    pub fn declared(&self) -> BTreeSet<&FileSpan> {
        self.all.iter().flat_map(|bound| &bound.declared).collect()
    }

    /// The declarations in Markdown, for a hover of a script.
    pub fn declarations(&self) -> String {
        distinct(self.all.iter().flat_map(|bound| &bound.declarations)).concat()
    }

    /// Where scripts set it, in Markdown.
    pub fn settings(&self) -> String {
        let all = distinct(self.all.iter().flat_map(|bound| &bound.settings));
        let mut text = all.get(..MAX_SHOWN).unwrap_or(&all).concat();
        if let Some(more) = all.len().checked_sub(MAX_SHOWN).filter(|more| *more > 0) {
            text.push_str(&format!("\nand in {more} other places\n"));
        }
        text
    }
}
