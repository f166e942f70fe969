//! Declarations in code that conditions leave out: another choice of macros would compile them.

use super::declared_type::ReflectedType;
use super::variable::{ReflectedVariable, place};
use shaderlint_semantic::{Program, Stage, Storage, Type};
use shaderlint_syntax::{TypeWord, tokenize};

/// The variables that left out code declares for the other stage or the program.
pub fn inactive(program: &Program) -> Vec<(Storage, ReflectedVariable)> {
    let spans = program.tokens.inactive.iter();
    let own = spans.filter(|span| program.is_user(**span));
    own.flat_map(|span| declarations(program, program.sources.text(*span), span.start))
        .collect()
}

/// The declarations of a text that starts at an address.
fn declarations(program: &Program, text: &str, base: u32) -> Vec<(Storage, ReflectedVariable)> {
    let tokens = tokenize(text, base);
    let words: Vec<(&str, u32)> = tokens
        .iter()
        .map(|token| {
            let at = (token.span.start - base) as usize..(token.span.end - base) as usize;
            (text.get(at).unwrap_or(""), token.span.start)
        })
        .filter(|(word, _)| !word.trim().is_empty())
        .collect();
    let mut found = Vec::new();
    for (at, (word, _)) in words.iter().enumerate() {
        let storage = match (*word, program.stage) {
            ("uniform", _) => Storage::Uniform,
            ("attribute" | "in", Stage::Vertex) | ("in", Stage::Fragment) => Storage::Input,
            ("varying", Stage::Fragment) => Storage::Input,
            ("varying" | "out", _) => Storage::Output,
            _ => continue,
        };
        let mut rest = words.iter().skip(at + 1);
        let mut next = rest.next();
        while next.is_some_and(|(word, _)| matches!(*word, "highp" | "mediump" | "lowp")) {
            next = rest.next();
        }
        let ty = next.and_then(|(word, _)| TypeWord::named(word));
        let (Some(ty), Some((name, start)), Some((after, _))) = (ty, rest.next(), rest.next())
        else {
            continue;
        };
        let size = match *after {
            ";" => 0,
            "[" => match rest.next().and_then(|(size, _)| size.parse().ok()) {
                Some(size) => size,
                None => continue,
            },
            _ => continue,
        };
        let (file, line, comment) = place(program, *start);
        found.push((
            storage,
            ReflectedVariable {
                name: (*name).to_string(),
                ty: ReflectedType::of(program, Type::of_word(ty).array_of(size)),
                precision: None,
                location: None,
                flat: false,
                used: false,
                active: false,
                conditional: true,
                file,
                line,
                comment,
            },
        ));
    }
    found
}
