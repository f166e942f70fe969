//! Code completion.

mod bound;
mod candidates;
mod expected;
pub(super) mod proposal;
mod usage;

use super::document::{Document, Spot};
use super::symbol::SymbolKind;
use expected::LETTERS;
use proposal::{CompletionKind, PLACEHOLDER, Proposal};
use shaderlint_lint::Page;
use shaderlint_project::Files;
use shaderlint_rules::RULES;
use shaderlint_semantic::{Program, Type};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{
    DIRECTIVES, EXTENSION_BEHAVIORS, RawKind, RawToken, TokenKind, TypeWord, WordClass, classify,
    extensions, tokenize,
};
use shaderlint_text::Span;

/// The completions at an offset, and the span of the incomplete word. The text is parsed with an
/// identifier in place of this word, because incomplete code does not parse.
pub fn complete(document: &Document, offset: u32, files: &dyn Files) -> (Span, Vec<Proposal>) {
    let mut word = word_before(&document.text, offset, is_of_name);
    let nothing = (word, Vec::new());
    let place = match document.spot(word.start) {
        Some(spot) => CompletionPlace::of(&spot),
        // An empty file is not detected as a shader.
        None if document.text.trim().is_empty() => CompletionPlace::Code,
        None => return (word, bound::inputs(document, word, files)),
    };
    let found = match place {
        CompletionPlace::Comment(description) => {
            word = word_before(&document.text, offset, |c| is_of_name(c) || c == '-');
            rules(&description)
        }
        CompletionPlace::Directive => keywords(DIRECTIVES.into_iter().chain(["include"])),
        CompletionPlace::Version(typed) => {
            word.start = offset - typed.len() as u32;
            versions(document, offset)
        }
        CompletionPlace::Extension => extension_names(document, offset),
        CompletionPlace::Behavior => keywords(EXTENSION_BEHAVIORS),
        CompletionPlace::Condition(is_expression) => conditions(document, offset, is_expression),
        CompletionPlace::Precision => keywords(PRECISIONS),
        CompletionPlace::PrecisionType => precision_types(document, offset),
        CompletionPlace::Nothing => return nothing,
        CompletionPlace::Include(path) => {
            word = word_before(&document.text, offset, |c| !matches!(c, '/' | '"' | '<'));
            included(document, &path, files)
        }
        CompletionPlace::Layout => layout(),
        place @ (CompletionPlace::Member | CompletionPlace::Code) => {
            let Some(text) = with_hole(document, word) else {
                return nothing;
            };
            let read = document.read_as(text, files);
            let compiled = match has_hole(&read) {
                true => Some(&read),
                false => read
                    .alternatives(files)
                    .iter()
                    .find(|other| has_hole(other)),
            };
            let read = compiled.unwrap_or(&read);
            let Some(spot) = read.spot(word.start) else {
                return nothing;
            };
            match place {
                CompletionPlace::Member => members(&spot),
                _ => candidates::names(&spot),
            }
        }
    };
    (word, found)
}

/// Whether a character may be part of an identifier.
fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The word of such characters before an offset.
fn word_before(text: &str, offset: u32, is_word: fn(char) -> bool) -> Span {
    let before = text.get(..offset as usize).unwrap_or("");
    let word = before.trim_end_matches(is_word);
    Span::new(word.len() as u32, offset)
}

/// The text with the placeholder in place of a word.
fn with_hole(document: &Document, word: Span) -> Option<String> {
    let before = document.text.get(..word.start as usize)?;
    let after = document.text.get(word.end as usize..)?;
    let after = after.trim_start_matches(is_of_name);
    // A single word is not detected as GLSL.
    if before.trim().is_empty() && after.trim().is_empty() {
        return Some(format!("{before}int {PLACEHOLDER};{after}"));
    }
    Some(format!("{before}{PLACEHOLDER}{after}"))
}

/// Whether the placeholder is in active code of a shader.
fn has_hole(document: &Document) -> bool {
    let mut all = document.report.analyses.iter();
    all.any(|analysis| candidates::hole(&analysis.program).is_some())
}

/// The syntactic context of a completion.
enum CompletionPlace {
    /// After a dot.
    Member,
    /// In a comment with this beginning.
    Comment(String),
    /// After a `#`.
    Directive,
    /// In the path of an `#include` with this beginning.
    Include(String),
    /// The version in `#version`, with this beginning.
    Version(String),
    /// The name in `#extension`.
    Extension,
    /// After the name in `#extension`.
    Behavior,
    /// The condition of a directive, and whether it is an expression.
    Condition(bool),
    /// After `precision`.
    Precision,
    /// The type in a `precision` statement.
    PrecisionType,
    /// Where nothing is completed: after the decimal point of a number, and in other directives.
    Nothing,
    /// In `layout(...)`.
    Layout,
    /// Anywhere else in code.
    Code,
}

impl CompletionPlace {
    fn of(spot: &Spot) -> CompletionPlace {
        let code = spot.document.report.sources.code_at(spot.address);
        let Some(code) = code else {
            return CompletionPlace::Code;
        };
        let before = code.text.get(..(spot.address - code.base) as usize);
        let before = before.unwrap_or("");
        let tokens = tokenize(before, 0);
        let line = before.rsplit('\n').next().unwrap_or("").trim_start();
        let is_comment = |t: &RawToken| {
            matches!(
                t.kind,
                RawKind::LineComment | RawKind::BlockComment | RawKind::OpenComment
            )
        };
        let is_in_comment = tokens.last().is_some_and(is_comment);
        if let Some(rest) = line.strip_prefix('#').filter(|_| !is_in_comment)
            && let Some(place) = CompletionPlace::of_directive(rest.trim_start())
        {
            return place;
        }
        let Some(last) = tokens.last() else {
            return CompletionPlace::Code;
        };
        let text = |span: Span| before.get(span.start as usize..span.end as usize);
        match last.kind {
            RawKind::LineComment | RawKind::OpenComment => {
                CompletionPlace::Comment(text(last.span).unwrap_or("").to_string())
            }
            RawKind::Operator(TokenKind::Dot) => CompletionPlace::Member,
            RawKind::Integer | RawKind::Float | RawKind::BadNumber => CompletionPlace::Nothing,
            _ => {
                let call = super::signature::open_call(spot);
                if call.is_some_and(|c| c.name == "layout") {
                    return CompletionPlace::Layout;
                }
                let mut words = tokens.iter().rev().filter(|t| t.kind == RawKind::Word);
                let mut word = || words.next().and_then(|t| Some((text(t.span)?, t.span.end)));
                let last = word();
                // Only white space is between the last word and the place.
                let is_last = |end: u32| before.get(end as usize..).is_some_and(is_blank);
                match (last.filter(|(_, end)| is_last(*end)), word()) {
                    (Some(("precision", _)), _) => CompletionPlace::Precision,
                    (Some(_), Some(("precision", _))) => CompletionPlace::PrecisionType,
                    _ => CompletionPlace::Code,
                }
            }
        }
    }

    /// The context in a directive, of which this is the text after `#`.
    fn of_directive(text: &str) -> Option<CompletionPlace> {
        let name_end = text.find(|c: char| !is_of_name(c)).unwrap_or(text.len());
        let (name, rest) = text.split_at_checked(name_end)?;
        let rest = match rest.trim_start() {
            _ if rest.is_empty() => return Some(CompletionPlace::Directive),
            rest => rest,
        };
        Some(match name {
            "include" => CompletionPlace::Include(rest.strip_prefix(['"', '<'])?.to_string()),
            "version" => CompletionPlace::Version(rest.to_string()),
            "extension" if rest.contains(':') => CompletionPlace::Behavior,
            "extension" => CompletionPlace::Extension,
            "if" | "elif" => CompletionPlace::Condition(true),
            "ifdef" | "ifndef" | "undef" => CompletionPlace::Condition(false),
            "define" => return None,
            _ => CompletionPlace::Nothing,
        })
    }
}

fn is_blank(text: &str) -> bool {
    text.chars().all(char::is_whitespace)
}

/// The names of rules for a suppression comment.
fn rules(comment: &str) -> Vec<Proposal> {
    let words: Vec<&str> = comment
        .trim_start_matches(['/', '*', ' '])
        .split('(')
        .collect();
    let is_allow = matches!(words[..], [head, _] if head.trim_start().starts_with("shaderlint:"));
    if !is_allow {
        return Vec::new();
    }
    let all = RULES.iter();
    all.map(|rule| {
        let summary = Page::new(rule.page).summary;
        Proposal::new(rule.name, CompletionKind::Rule, 0).detail(summary)
    })
    .collect()
}

fn keywords<'a>(all: impl IntoIterator<Item = &'a str>) -> Vec<Proposal> {
    let ranked = all.into_iter().zip(0..);
    let each = ranked.map(|(name, rank)| Proposal::new(name, CompletionKind::Keyword, rank));
    each.collect()
}

const PRECISIONS: [&str; 3] = ["highp", "mediump", "lowp"];

/// The versions that a complete shader may have; others have the version of their host.
fn versions(document: &Document, offset: u32) -> Vec<Proposal> {
    let spot = document.spot(offset);
    match spot.is_some_and(|spot| spot.program().dialect.is_shadertoy()) {
        true => Vec::new(),
        false => keywords(["300 es", "100"]),
    }
}

fn extension_names(document: &Document, offset: u32) -> Vec<Proposal> {
    let version = document.spot(offset).map(|spot| spot.program().version);
    keywords(version.into_iter().flat_map(extensions))
}

/// The macros that a condition may test.
fn conditions(document: &Document, offset: u32, is_expression: bool) -> Vec<Proposal> {
    let Some(spot) = document.spot(offset) else {
        return Vec::new();
    };
    let program = spot.program();
    let kind = CompletionKind::Symbol(SymbolKind::Macro);
    let mut names: Vec<&str> = (program.tokens.macros.iter())
        .map(|defined| program.names.text(defined.name))
        .collect();
    names.sort_unstable();
    names.dedup();
    let each = names.into_iter().map(|name| Proposal::new(name, kind, 0));
    let defined = Proposal::new("defined", CompletionKind::Keyword, 1);
    each.chain(is_expression.then_some(defined)).collect()
}

/// The types that have a default precision (section 4.5.4).
fn precision_types(document: &Document, offset: u32) -> Vec<Proposal> {
    let version = document.spot(offset).map(|spot| spot.program().version);
    let is_of = |word: &TypeWord| {
        let ty = Type::of_word(*word);
        let is_known = version.is_some_and(|v| classify(word.name(), v) == WordClass::Type(*word));
        is_known && (ty == Type::FLOAT || ty == Type::INT || ty.is_sampler())
    };
    keywords(TypeWord::ALL.iter().filter(|w| is_of(w)).map(|w| w.name()))
}

fn layout() -> Vec<Proposal> {
    keywords([
        "location = ",
        "std140",
        "shared",
        "packed",
        "row_major",
        "column_major",
    ])
}

/// The files that an `#include` may refer to, relative to the document.
fn included(document: &Document, path: &str, files: &dyn Files) -> Vec<Proposal> {
    let own = std::path::Path::new(&document.path);
    let folder = own.parent().unwrap_or(own);
    let inner = path.rfind('/').and_then(|at| path.get(..at)).unwrap_or("");
    let folder = shaderlint_text::path::plain(&folder.join(inner));
    let mut names = files.names(&folder);
    names.sort_unstable();
    let is_named = |name: &String| {
        let is_own = folder.join(name) == own;
        let is_folder =
            files.entry(&folder.join(name)) == Some(shaderlint_project::FileType::Folder);
        let is_shader = shaderlint_detect::kind::is_shader(name);
        !name.starts_with('.') && !is_own && (is_folder || is_shader)
    };
    names.retain(is_named);
    let each = names.into_iter();
    each.map(|name| Proposal::new(name, CompletionKind::File, 0))
        .collect()
}

/// The type of the expression before the placeholder.
fn object(program: &Program) -> Option<Type> {
    let name = program.names.get(PLACEHOLDER)?;
    let mut all = program.tree.exprs.iter();
    all.find_map(|expr| match expr.kind {
        ExprKind::Member(object, member) if member == name => Some(program.ty(object)),
        ExprKind::Method(object, member, _) if member == name => Some(program.ty(object)),
        _ => None,
    })
}

fn members(spot: &Spot) -> Vec<Proposal> {
    let program = spot.program();
    let Some(ty) = object(program) else {
        return Vec::new();
    };
    if ty.is_array() {
        let length = Proposal::new("length()", CompletionKind::Symbol(SymbolKind::Function), 0);
        return vec![length.detail("int")];
    }
    if let Some(number) = super::index::struct_number(ty) {
        let fields = program
            .structs
            .get(number as usize)
            .map(|s| s.fields.as_slice());
        let fields = fields.unwrap_or(&[]).iter();
        let field = fields.map(|field| {
            let name = program.names.text(field.name);
            Proposal::new(name, CompletionKind::Symbol(SymbolKind::Field), 0)
                .detail(program.type_name(field.ty))
        });
        return field.collect();
    }
    match ty.is_vector() {
        true => components(program, ty),
        false => Vec::new(),
    }
}

/// The usual swizzles of a vector: single components, and consecutive ones.
fn components(program: &Program, ty: Type) -> Vec<Proposal> {
    let count = ty.components() as usize;
    let mut found = Vec::new();
    for (letters, rank) in LETTERS.into_iter().zip(0..) {
        let letters = letters.get(..count).unwrap_or(letters);
        for from in 0..count {
            for to in from + 1..=count {
                let Some(run) = letters
                    .get(from..to)
                    .filter(|run| *run != letters || count < 5)
                else {
                    continue;
                };
                let of = ty.scalar_kind().map(|scalar| match run.len() {
                    1 => Type::scalar(scalar),
                    len => Type::vector(scalar, len as u8),
                });
                let detail = of.map_or(String::new(), |ty| program.type_name(ty));
                let item =
                    Proposal::new(run, CompletionKind::Components, rank * 4 + run.len() as u16);
                found.push(item.detail(detail));
            }
        }
    }
    for (run, least) in [
        ("xz", 3),
        ("yx", 2),
        ("yz", 3),
        ("zx", 3),
        ("zyx", 3),
        ("bgr", 3),
        ("xyxy", 2),
    ] {
        if count >= least && !found.iter().any(|c| c.label == run) {
            found.push(Proposal::new(run, CompletionKind::Components, 14));
        }
    }
    found
}
