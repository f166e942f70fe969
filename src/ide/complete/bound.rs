//! Completion of the names of inputs in scripts.

use super::proposal::{CompletionKind, PLACEHOLDER, Proposal};
use crate::document::Document;
use crate::symbol::SymbolKind;
use shaderlint_contract::ProgramBindings;
use shaderlint_engine::{Options, contracts};
use shaderlint_project::Files;
use shaderlint_text::Span;
use std::sync::Arc;

/// Maximum number of bytes in which the start of an object is searched.
const MAX_OBJECT: usize = 4_000;

/// Whether inputs may be named after a text: after a dot, in a string, or as a key of an object.
fn may_be_named(before: &str) -> bool {
    let from = before.floor_char_boundary(before.len().saturating_sub(MAX_OBJECT));
    let before = before.get(from..).unwrap_or("");
    let is_about = |text: &str| text.contains("niform") || text.contains("ttrib");
    let line = before.rsplit('\n').next().unwrap_or("");
    let last = before.trim_end();
    match last.chars().next_back() {
        Some('.') => is_about(line),
        Some('"' | '\'' | '`') => is_about(line) || line.contains("set"),
        Some('{' | ',' | '}') => {
            let mut depth = 0;
            let open = last.rfind(|c: char| {
                depth += match c {
                    '}' => 1,
                    '{' => -1,
                    _ => 0,
                };
                depth < 0
            });
            let holder = open.and_then(|at| last.get(..at)).unwrap_or("").trim_end();
            let name = holder.trim_end_matches([':', '=', ' ']);
            holder.ends_with('(') || name.ends_with("niforms") || name.ends_with("ttributes")
        }
        _ => false,
    }
}

/// The inputs of the program that a word in a script belongs to; those that are not set yet first.
pub fn inputs(document: &Document, word: Span, files: &dyn Files) -> Vec<Proposal> {
    let text = &document.text;
    let before = text.get(..word.start as usize).unwrap_or("");
    if !may_be_named(before) {
        return Vec::new();
    }
    let rest = text.get(word.start as usize..).unwrap_or("");
    let rest = rest.trim_start_matches(super::is_of_name);
    // What the editor shows is incomplete: its contract is not the one of the document.
    let options = Options {
        contracts: Arc::default(),
        ..Options::clone(&document.options)
    };
    for end in ["", ",", ";", ": 0,"] {
        let text = format!("{before}{PLACEHOLDER}{end}{rest}");
        let around = contracts(&document.path, &text, &options, files);
        let programs = around.iter().flat_map(|contract| &contract.bindings);
        let is_it = |p: &&ProgramBindings| p.mentions_of(PLACEHOLDER).next().is_some();
        let programs: Vec<&ProgramBindings> = programs.filter(is_it).collect();
        if !programs.is_empty() {
            return proposals(&programs, before);
        }
    }
    Vec::new()
}

fn proposals(programs: &[&ProgramBindings], before: &str) -> Vec<Proposal> {
    let line = before.rsplit('\n').next().unwrap_or("");
    let is_attribute = line.contains("ttrib");
    let mut found: Vec<Proposal> = Vec::new();
    for program in programs {
        for input in program
            .inputs
            .iter()
            .filter(|i| i.is_attribute == is_attribute)
        {
            if found.iter().any(|p| p.label == input.name) {
                continue;
            }
            let is_set = program.mentions_of(&input.name).next().is_some();
            let kind = match is_attribute {
                true => SymbolKind::Input,
                false => SymbolKind::Uniform,
            };
            let proposal = Proposal::new(
                &*input.name,
                CompletionKind::Symbol(kind),
                u16::from(is_set),
            );
            found.push(proposal.detail(&*input.type_name));
        }
    }
    found
}
