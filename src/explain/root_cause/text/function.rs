//! Functions as other languages write them: `function f(x) {`, `auto f(float x) {`,
//! `auto f = [](float x) { ... };`, `const f = (x) => ...;`.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_syntax::{RawKind, TokenKind, WordClass, classify};
use std::ops::Range;

/// Types of a result or of a parameter without a type, the most frequent first.
const TYPES: [&str; 5] = ["float", "vec2", "vec3", "vec4", "void"];

/// A parameter list with an inferred type for each bare name, and the type of the result.
struct InferredHeader {
    result: &'static str,
    parameters: String,
}

impl FaultyShader<'_> {
    pub(super) fn functions(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        all.extend(self.function_word(line).into_iter().flatten());
        all.extend(self.lambda(line).into_iter().flatten());
    }

    /// `function wave(x) {`
    fn function_word(&self, line: &FaultyLine) -> Option<Vec<RepairCandidate>> {
        let word = line.token(0);
        let is_plain = |class| matches!(class, WordClass::Plain | WordClass::Reserved);
        let is_header = line.kind(0) == Some(RawKind::Word)
            && is_plain(classify(word, self.program.version))
            && line.kind(1) == Some(RawKind::Word)
            && line.is(2, TokenKind::LeftParen);
        let after = line.after(2).filter(|_| is_header)?;
        // `float3 f()` is about the type.
        let start = line.span(0).start;
        let mut own = self.errors.iter().filter(|d| d.span.start == start);
        if own.any(|d| d.is(error::UNKNOWN_TYPE) && d.fix.is_some()) {
            return None;
        }
        let is_open = line.is(after, TokenKind::LeftBrace) || after == line.tokens.len();
        if !is_open || self.function_around(line.start).is_some() {
            return None;
        }
        let name = line.token(1);
        let span = line.span(0);
        let entry = self.program.dialect.host().entry;
        let entry = entry.filter(|entry| entry.name == name);
        let headers = match entry {
            Some(entry) => vec![entry_header(line, 3..after - 1, entry.signature)],
            None => headers(line, 3..after - 1),
        };
        let candidates = headers.into_iter().map(|header| {
            let text = format!("{} {name}({})", header.result, header.parameters);
            let edits = vec![Edit::replace(span.to(line.span(after - 1)), text.clone())];
            let message = format!("expected a return type, found `{word}`");
            foreign(span, message, format!("use `{text}`"), edits)
        });
        Some(candidates.collect())
    }

    /// `auto wave = [](float x) { return sin(x); };`, `const wave = (x) => sin(x);`
    fn lambda(&self, line: &FaultyLine) -> Option<Vec<RepairCandidate>> {
        let equal = (0..line.tokens.len()).find(|&at| line.is(at, TokenKind::Equal))?;
        let name = equal.checked_sub(1);
        let name = name.filter(|&at| line.kind(at) == Some(RawKind::Word))?;
        let is_lambda = line.is(equal + 1, TokenKind::LeftBracket);
        let captures = match is_lambda {
            true => line.after(equal + 1),
            false => Some(equal + 1),
        };
        let open = captures.filter(|&at| line.is(at, TokenKind::LeftParen))?;
        let after = line.after(open)?;
        let is_arrow = |at: usize, kind| line.is(at, kind) && line.is(at + 1, TokenKind::Greater);
        let body = match (is_lambda, is_arrow(after, TokenKind::Equal)) {
            (true, false) => {
                (after..line.tokens.len()).find(|&at| line.is(at, TokenKind::LeftBrace))
            }
            (false, true) => Some(after + 2),
            _ => None,
        };
        let starts = |&at: &usize| line.starts_statement(at);
        let first = (0..=name).rev().find(starts)?;
        let (body, last) = lambda_body(line, body?)?;
        let name = line.token(name);
        let statement = line.span(first).to(line.span(last));
        let place = self.function_around(line.start);
        let headers = headers(line, open + 1..after - 1).into_iter();
        let candidates = headers.map(|header| {
            let text = format!("{} {name}({}) {body}", header.result, header.parameters);
            let edits = match place {
                Some(start) => vec![
                    Edit::insert(start, format!("{text}\n\n")),
                    Edit::delete(statement),
                ],
                None => vec![Edit::replace(statement, text)],
            };
            let title = format!("declare the function `{} {name}`", header.result);
            let message = "GLSL has no functions as values";
            foreign(line.span(equal + 1), message, title, edits)
        });
        Some(candidates.collect())
    }
}

/// The block of a lambda, or its expression as a block, and the last token of the statement.
fn lambda_body(line: &FaultyLine, at: usize) -> Option<(String, usize)> {
    if line.is(at, TokenKind::LeftBrace) {
        let after = line.after(at)?;
        let block = line.of(line.span(at).to(line.span(after - 1))).to_string();
        let last = if line.is(after, TokenKind::Semicolon) {
            after
        } else {
            after - 1
        };
        return Some((block, last));
    }
    let end = (at..line.tokens.len()).find(|&at| line.is(at, TokenKind::Semicolon))?;
    let value = line.of(Span::new(line.span(at).start, line.span(end).start));
    Some((format!("{{ return {}; }}", value.trim()), end))
}

/// The header of the entry function with the names of a parameter list between two tokens.
fn entry_header(line: &FaultyLine, list: Range<usize>, signature: &str) -> InferredHeader {
    let types = signature.split(['(', ')']).nth(1).unwrap_or("").split(", ");
    let types = types.filter_map(|param| Some(param.rsplit_once(' ')?.0));
    let names = list.filter(|&at| line.kind(at) == Some(RawKind::Word));
    let params = types
        .zip(names)
        .map(|(ty, at)| format!("{ty} {}", line.token(at)));
    InferredHeader {
        result: "void",
        parameters: params.collect::<Vec<_>>().join(", "),
    }
}

/// The headers that a parameter list between two tokens may stand for.
fn headers(line: &FaultyLine, list: Range<usize>) -> Vec<InferredHeader> {
    let mut parameters: Vec<Vec<&str>> = vec![Vec::new()];
    for at in list {
        match parameters.last_mut() {
            Some(words) if !line.is(at, TokenKind::Comma) => words.push(line.token(at)),
            _ => parameters.push(Vec::new()),
        }
    }
    parameters.retain(|words| !words.is_empty());
    let is_bare = |words: &Vec<&str>| words.len() == 1;
    let taken: &[&str] = match parameters.iter().any(is_bare) {
        true => &["float", "vec2", "vec3"],
        false => &["float"],
    };
    let mut all = Vec::new();
    for ty in taken {
        let written = parameters.iter().map(|words| match words.as_slice() {
            [name] => format!("{ty} {name}"),
            words => words.join(" "),
        });
        let written: Vec<String> = written.collect();
        all.extend(TYPES.map(|result| InferredHeader {
            result,
            parameters: written.join(", "),
        }));
    }
    all
}
