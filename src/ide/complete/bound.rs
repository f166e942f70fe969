//! Completion of the names of inputs in scripts.

use super::proposal::{CompletionKind, PLACEHOLDER, Proposal};
use crate::document::Document;
use crate::symbol::SymbolKind;
use shaderlint_contract::ProgramBindings;
use shaderlint_engine::{Options, contracts};
use shaderlint_project::Files;
use shaderlint_text::Span;
use std::sync::Arc;

/// Maximum number of bytes before a position that show whether it is about inputs.
const MAX_BEFORE: usize = 4_000;

/// Whether inputs may be named after a text: after a dot, in a string, or as a key of an object.
fn may_be_named(before: &str) -> bool {
    let from = before.floor_char_boundary(before.len().saturating_sub(MAX_BEFORE));
    let near = before.get(from..).unwrap_or("");
    let line = near.rsplit('\n').next().unwrap_or("");
    let last = near.trim_end().chars().next_back();
    let shown = match last {
        Some('.' | '"' | '\'' | '`') => line,
        Some('{' | ',' | '}') => near,
        _ => return false,
    };
    ["niform", "ttrib", "haderMaterial("]
        .iter()
        .any(|sign| shown.contains(sign))
}

/// The inputs of the program that a word in a script belongs to; those that are not set yet first.
pub fn inputs(document: &Document, word: Span, files: &dyn Files) -> Vec<Proposal> {
    let text = &document.text;
    let before = text.get(..word.start as usize).unwrap_or("");
    if !may_be_named(before) {
        return Vec::new();
    }
    let rest = text.get(word.start as usize..).unwrap_or("");
    let rest = rest.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
    // What the editor shows is incomplete: its contract is not the one of the document.
    let options = Options {
        contracts: Arc::default(),
        ..Options::clone(&document.options)
    };
    for end in ["", ",", ";", ": 0,"] {
        let text = format!("{before}{PLACEHOLDER}{end}{rest}");
        let around = contracts(&document.path, &text, &options, files);
        let programs = around.iter().flat_map(|contract| &contract.bindings);
        let is_it = |p: &&ProgramBindings| is_named(p, PLACEHOLDER);
        let programs: Vec<&ProgramBindings> = programs.filter(is_it).collect();
        if !programs.is_empty() {
            return proposals(&programs, before);
        }
    }
    Vec::new()
}

/// Whether scripts name an input of a program.
fn is_named(program: &ProgramBindings, name: &str) -> bool {
    program.mentions.iter().any(|(own, _)| own == name)
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
            let is_set = is_named(program, &input.name);
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
