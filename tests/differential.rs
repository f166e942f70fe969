//! Compares our parser with glsl-lang on the same texts; each disagreement must have a known
//! reason.
//!
//! `SHADERLINT_CASES=DIR cargo test --test all differential` also reads the ShaderToy exports in
//! `DIR/shadertoy`.

use glsl_lang::ast::TranslationUnit;
use glsl_lang::parse::DefaultParse;
use shaderlint::diagnostic::Severity;
use shaderlint::semantic::Pass;
use shaderlint::syntax::{
    ParseOptions, RawKind, Search, TokenKind, parse, preprocess, tokenize, unsplice,
};
use shaderlint::text::{Role, Sources, Span};
use std::collections::HashMap;
use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

/// A reason, and a predicate that tells whether it applies to a text.
type Explanation = (&'static str, fn(&str) -> bool);

/// Why the other parser rejects what ours, like the browser, accepts.
const EXPLANATIONS: [Explanation; 4] = [
    ("an integer of 2^31 or more", has_large_integer),
    ("a keyword of desktop GLSL as a name", has_foreign_keyword),
    (
        "an exponent before a minus: `5e2-.5`",
        has_exponent_before_sign,
    ),
    ("a struct name used for something else", reuses_struct_name),
];

/// Keywords of desktop GLSL that GLSL ES 3.00 does not reserve.
const FOREIGN_KEYWORDS: [&str; 12] = [
    "buffer",
    "shared",
    "subroutine",
    "precise",
    "double",
    "sample",
    "dvec2",
    "dvec3",
    "dvec4",
    "texture2D",
    "sampler",
    "texture3D",
];

fn words(text: &str) -> Vec<(RawKind, &str)> {
    let all = tokenize(text, 0).into_iter();
    let text_of =
        |t: shaderlint::syntax::RawToken| &text[t.span.start as usize..t.span.end as usize];
    all.filter(|t| !matches!(t.kind, RawKind::Whitespace | RawKind::Newline))
        .map(|t| (t.kind, text_of(t)))
        .collect()
}

fn has_large_integer(text: &str) -> bool {
    let value = |digits: &str| match digits.strip_prefix("0x").or(digits.strip_prefix("0X")) {
        Some(hex) => u64::from_str_radix(hex, 16),
        None => digits.parse(),
    };
    let is_large =
        |word: &str| value(word.trim_end_matches(['u', 'U'])).is_ok_and(|v| v >= 1 << 31);
    words(text)
        .iter()
        .any(|(kind, w)| *kind == RawKind::Integer && is_large(w))
}

fn has_foreign_keyword(text: &str) -> bool {
    words(text)
        .iter()
        .any(|(_, w)| FOREIGN_KEYWORDS.contains(w))
}

fn has_exponent_before_sign(text: &str) -> bool {
    let all = words(text);
    let is_pair = |pair: &[(RawKind, &str)]| {
        pair[0].0 == RawKind::Float
            && pair[0].1.contains(['e', 'E'])
            && matches!(pair[1].1, "-" | "+")
    };
    all.windows(2).any(is_pair)
}

fn reuses_struct_name(text: &str) -> bool {
    let all = words(text);
    let structs: Vec<&str> = all
        .windows(2)
        .filter(|w| w[0].1 == "struct")
        .map(|w| w[1].1)
        .collect();
    // A type name precedes a name or a call; after `.` or before `=` it is something else.
    let is_other = |w: &[(RawKind, &str)]| {
        structs.contains(&w[1].1) && (w[0].1 == "." || matches!(w[2].1, "=" | "." | ";" | ","))
    };
    all.windows(3).any(is_other)
}

/// The output of our preprocessor, with its line breaks preserved, and whether our parser accepts
/// it.
///
/// The other parser gets this text, because its own preprocessor does not support macros between
/// statements.
fn preprocessed(text: &str) -> (String, bool) {
    let mut sources = Sources::new();
    let header = Pass::Image.host().prelude([None; 4]);
    let header = sources.add("", None, Role::Prelude, header);
    let file = sources.add("a.glsl", None, Role::User, text);
    let files = [header.unwrap(), file.unwrap()];
    let mut read = preprocess(
        &sources,
        &files,
        true,
        shaderlint::syntax::GlContext::WEBGL2,
    );
    let language = ParseOptions {
        version: read.version,
        is_fragment: true,
    };
    let search = &mut Search::for_text();
    let parse = parse(&sources, &mut read.tokens, &read.names, language, search);
    let problems = parse.diagnostics;
    let mut all = read.diagnostics.iter().chain(&problems);
    let is_good = !all.any(|d| d.severity == Severity::Error);
    let ends: HashMap<u32, u32> = sources
        .files()
        .iter()
        .flat_map(|f| tokenize(&f.text, f.base))
        .map(|t| (t.span.start, t.span.end))
        .collect();
    let mut plain = String::new();
    let start = sources.files()[1].base;
    for token in read.tokens.tokens.iter().filter(|t| t.span.start >= start) {
        if let (Some(&end), true) = (ends.get(&token.spelled), token.kind != TokenKind::End) {
            plain.push_str(&unsplice(sources.text(Span::new(token.spelled, end))));
            plain.push('\n');
        }
    }
    (plain, is_good)
}

/// Whether glsl-lang accepts a text.
fn they_take(text: &str) -> Result<(), String> {
    let whole = format!("#version 300 es\n{text}");
    let read = catch_unwind(|| TranslationUnit::parse(whole.as_str()).map_err(|e| e.to_string()));
    read.unwrap_or_else(|_| Err("panic".to_string()))
        .map(|_| ())
}

fn push_files(folder: &Path, found: &mut Vec<(String, String)>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for path in entries.map(|e| e.unwrap().path()) {
        let name = path.display().to_string();
        if path.is_dir() {
            push_files(&path, found);
        } else if name.ends_with(".glsl") {
            found.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The passes of the exports in a folder, each preceded by its common code.
fn push_exports(folder: &Path, found: &mut Vec<(String, String)>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for path in entries.map(|e| e.unwrap().path()) {
        let text = fs::read_to_string(&path).unwrap();
        let Ok(project) = shaderlint::project::Project::from_json(&text) else {
            continue;
        };
        let common: String = project.commons().map(|p| format!("{}\n", p.code)).collect();
        let is_common = |p: &shaderlint::project::ProjectPass| p.kind == Pass::Common;
        for pass in project.passes.iter().filter(|p| !is_common(p)) {
            found.push((
                format!("{} {}", path.display(), pass.name),
                format!("{common}{}", pass.code),
            ));
        }
    }
}

#[test]
fn every_disagreement_has_a_known_reason() {
    let mut texts = Vec::new();
    push_files(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/templates"),
        &mut texts,
    );
    if let Some(cases) = std::env::var_os("SHADERLINT_CASES") {
        push_exports(&Path::new(&cases).join("shadertoy"), &mut texts);
    }
    assert!(!texts.is_empty());
    let mut agreed = 0;
    let mut explained = [0; EXPLANATIONS.len()];
    let mut unexplained = Vec::new();
    for (name, text) in &texts {
        let (text, ours) = preprocessed(text);
        let theirs = they_take(&text);
        if ours == theirs.is_ok() {
            agreed += 1;
        } else if let Some(i) = EXPLANATIONS
            .iter()
            .position(|(_, holds)| ours && holds(&text))
        {
            explained[i] += 1;
        } else {
            unexplained.push(format!("{name}: ours {ours}, glsl-lang {theirs:?}"));
        }
    }
    println!("{agreed} of {} texts with the same verdict", texts.len());
    for ((why, _), count) in EXPLANATIONS.iter().zip(explained) {
        println!("{count} for {why}");
    }
    assert!(unexplained.is_empty(), "{}", unexplained.join("\n"));
}
