//! The inputs of shaders in the scripts that set them.

use crate::document::{Document, FileSpan};
use crate::symbol::declared_at;
use shaderlint_contract::{BoundInput, Contract, ProgramBindings};
use shaderlint_detect::embed::{DocumentLanguage, MentionKind, NameRole, mentions};
use shaderlint_detect::kind::file_extension;
use shaderlint_engine::contracts;
use shaderlint_project::Files;
use shaderlint_script::ScriptPlace;
use shaderlint_text::path::slashed;
use shaderlint_text::{LineIndex, Span};
use std::fmt::Write;
use std::sync::Arc;

/// Maximum number of places that a hover lists.
const MAX_SHOWN: usize = 6;

/// An input of the shaders of a program that a script makes.
pub struct BoundName {
    contract: Arc<Contract>,
    program: usize,
    /// Its name.
    pub name: String,
}

impl BoundName {
    fn program(&self) -> Option<&ProgramBindings> {
        self.contract.bindings.get(self.program)
    }

    fn input(&self) -> Option<&BoundInput> {
        self.program()?.input(&self.name)
    }

    fn span(&self, place: ScriptPlace) -> Option<FileSpan> {
        let (path, _) = self.contract.files.get(place.file)?;
        Some(FileSpan {
            path: slashed(path),
            span: Span::new(place.start, place.end),
        })
    }

    fn spans(&self, places: impl Iterator<Item = ScriptPlace>) -> Vec<FileSpan> {
        places.filter_map(|place| self.span(place)).collect()
    }

    /// Its declarations in all stages.
    pub fn declared(&self) -> Vec<FileSpan> {
        self.spans(self.input().iter().flat_map(|i| &i.declared).copied())
    }

    /// The places of scripts that name it.
    pub fn mentions(&self) -> Vec<FileSpan> {
        self.spans(
            self.program()
                .iter()
                .flat_map(|p| p.mentions_of(&self.name)),
        )
    }

    /// The places of scripts that compute names of inputs.
    pub fn computed(&self) -> Vec<FileSpan> {
        self.spans(self.program().iter().flat_map(|p| &p.computed).copied())
    }

    /// File and line of a place: `main.js:12`.
    fn line(&self, place: ScriptPlace) -> Option<String> {
        let (path, text) = self.contract.files.get(place.file)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Some(format!("{name}:{}", LineIndex::new(text).line(place.start)))
    }
}

/// The inputs of one name that a position in a script or shader refers to.
#[derive(Default)]
pub struct BoundNames {
    /// The name in the document.
    pub span: Span,
    /// In each program.
    pub all: Vec<BoundName>,
}

/// The programs of a contract that have an input of this name, if it is the right one.
fn inputs(
    contract: &Arc<Contract>,
    name: &str,
    is_it: impl Fn(&BoundName) -> bool,
) -> Vec<BoundName> {
    let all = (0..contract.bindings.len()).map(|program| BoundName {
        contract: contract.clone(),
        program,
        name: name.to_string(),
    });
    all.filter(|bound| bound.input().is_some() && is_it(bound))
        .collect()
}

/// The inputs that are declared at a place, as the programs around a document set them.
pub fn declared_inputs(
    document: &Document,
    name: &str,
    place: &FileSpan,
    files: &dyn Files,
) -> Vec<BoundName> {
    let around = contracts(&document.path, &document.text, &document.options, files);
    let is_here = |bound: &BoundName| bound.declared().contains(place);
    let mut found: Vec<BoundName> = around
        .iter()
        .flat_map(|c| inputs(c, name, is_here))
        .collect();
    // Another stage of the same program may declare it where this text is not compiled.
    let is_near = |bound: &BoundName| bound.declared().iter().any(|d| d.path == place.path);
    if found.is_empty() {
        found = around
            .iter()
            .flat_map(|c| inputs(c, name, is_near))
            .collect();
    }
    found
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
        let text = name.symbol.name(program);
        return BoundNames {
            span: document.report.in_input(name.span).unwrap_or_default(),
            all: declared_inputs(document, text, &place, files),
        };
    }
    let around = contracts(&document.path, &document.text, &document.options, files);
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let (before, after) = document
        .text
        .split_at_checked(offset as usize)
        .unwrap_or_default();
    let start = before.trim_end_matches(is_part).len();
    let length = after.len() - after.trim_start_matches(is_part).len();
    let span = Span::new(start as u32, offset + length as u32);
    let name = document.text.get(start..span.end as usize).unwrap_or("");
    let own = FileSpan {
        path: document.path.clone(),
        span,
    };
    let is_named = |bound: &BoundName| bound.mentions().contains(&own);
    let mut all: Vec<BoundName> = around
        .iter()
        .flat_map(|c| inputs(c, name, is_named))
        .collect();
    // Code that is not evaluated names it too.
    if all.is_empty() && around.iter().any(|c| !inputs(c, name, |_| true).is_empty()) {
        let language = DocumentLanguage::of_extension(&file_extension(&document.path));
        let named = language.map(|of| mentions(of, &document.text, name, NameRole::Input));
        let is_it = named.unwrap_or_default().iter().any(|mention| {
            mention.range.start == start
                && matches!(mention.kind, MentionKind::Name | MentionKind::Shorthand)
        });
        all = around
            .iter()
            .flat_map(|c| inputs(c, name, |_| is_it))
            .collect();
    }
    BoundNames { span, all }
}

impl BoundNames {
    /// The declarations in all programs, each once.
    pub fn declared(&self) -> Vec<FileSpan> {
        let mut found: Vec<FileSpan> = self.all.iter().flat_map(BoundName::declared).collect();
        found.sort();
        found.dedup();
        found
    }

    /// The declarations as GLSL, for a hover of a script.
    pub fn declarations(&self) -> String {
        let mut text = String::new();
        let mut add = |line: String| {
            if !text.contains(&line) {
                text.push_str(&line);
            }
        };
        for bound in &self.all {
            let Some(input) = bound.input() else { continue };
            let word = if input.is_attribute { "in" } else { "uniform" };
            add(format!(
                "```glsl\n{word} {} {}\n```\n",
                input.type_name, input.name
            ));
        }
        for bound in &self.all {
            let declared = bound.input().map_or(&[][..], |input| &input.declared);
            let lines = declared.iter().filter_map(|place| bound.line(*place));
            lines.for_each(|line| add(format!("\ndeclared in `{line}`\n")));
        }
        text
    }

    /// Where scripts set it, in Markdown.
    pub fn settings(&self) -> String {
        let mut lines: Vec<String> = Vec::new();
        for bound in &self.all {
            let settings = bound.input().map_or(&[][..], |input| &input.settings);
            for (index, setting) in settings.iter().enumerate() {
                let Some(line) = bound.line(setting.place) else {
                    continue;
                };
                let line = match (&setting.value, index) {
                    (Some(value), _) => format!("set to `{value}` in `{line}`"),
                    (None, 0) => format!("set in `{line}`"),
                    (None, _) => format!("changed in `{line}`"),
                };
                if !lines.contains(&line) {
                    lines.push(line);
                }
            }
        }
        let more = lines.len().saturating_sub(MAX_SHOWN);
        lines.truncate(MAX_SHOWN);
        let mut text = String::new();
        for line in &lines {
            let _ = write!(text, "\n{line}\n");
        }
        if more > 0 {
            let _ = write!(text, "\nand in {more} other places\n");
        }
        text
    }
}
