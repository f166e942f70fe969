//! Code completion.

use super::document::{Document, Spot};
use super::library::entry;
use super::signature::builtin_head;
use super::symbol::{Symbol, SymbolKind, declared_at};
use shaderlint_engine::Files;
use shaderlint_lint::Page;
use shaderlint_rules::RULES;
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{Dialect, Pass, Program, Stage, Type, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{DIRECTIVES, RawKind, TokenKind, TypeWord, WordClass, classify, tokenize};
use shaderlint_text::Span;
use std::collections::BTreeSet;

/// The kind of a completion.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CompletionKind {
    /// A symbol of the shader.
    Symbol(SymbolKind),
    /// A built-in type.
    Type,
    /// Another keyword.
    Keyword,
    /// Components of a vector.
    Components,
    /// A snippet with placeholders.
    Snippet,
    /// A file or folder.
    File,
    /// Name of a rule.
    Rule,
}

/// A completion.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Proposal {
    /// Text in the list.
    pub label: String,
    /// Kind of the completion.
    pub kind: CompletionKind,
    /// Type or signature.
    pub detail: String,
    /// Inserted text if it differs from the label; `${1:name}` are placeholders.
    pub snippet: Option<String>,
    /// Documentation in Markdown.
    pub text: String,
    /// Order in the list, lower first.
    pub rank: u8,
}

impl Proposal {
    fn new(label: impl Into<String>, kind: CompletionKind, rank: u8) -> Proposal {
        Proposal {
            label: label.into(),
            kind,
            detail: String::new(),
            snippet: None,
            text: String::new(),
            rank,
        }
    }

    fn detail(self, detail: impl Into<String>) -> Proposal {
        Proposal {
            detail: detail.into(),
            ..self
        }
    }
}

/// Identifier that replaces the incomplete word.
const PLACEHOLDER: &str = "shaderlintHole";

/// The completions at an offset, and the span of the incomplete word. The text is parsed with an
/// identifier in place of this word, because incomplete code does not parse.
pub fn complete(document: &Document, offset: u32, files: &dyn Files) -> (Span, Vec<Proposal>) {
    let mut word = word_before(&document.text, offset, is_of_name);
    let nothing = (word, Vec::new());
    let place = match document.spot(word.start) {
        Some(spot) => CompletionPlace::of(&spot),
        // An empty file is not detected as a shader.
        None if document.text.trim().is_empty() => CompletionPlace::Code,
        None => return nothing,
    };
    let found = match place {
        CompletionPlace::Comment(description) => {
            word = word_before(&document.text, offset, |c| is_of_name(c) || c == '-');
            rules(&description)
        }
        CompletionPlace::Directive => directives(),
        CompletionPlace::Include(path) => {
            word = word_before(&document.text, offset, |c| !matches!(c, '/' | '"' | '<'));
            included(document, &path, files)
        }
        CompletionPlace::Number => return nothing,
        CompletionPlace::Layout => layout(),
        place @ (CompletionPlace::Member | CompletionPlace::Code) => {
            let Some(text) = with_hole(document, word) else {
                return nothing;
            };
            let read = document.read_as(text, files);
            let Some(spot) = read.spot(word.start) else {
                return nothing;
            };
            match place {
                CompletionPlace::Member => members(&spot),
                _ => names(&spot),
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
    /// After the decimal point of a number.
    Number,
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
        if let Some(rest) = line.strip_prefix('#') {
            let rest = rest.trim_start();
            if let Some(path) = rest.strip_prefix("include") {
                let path = path.trim_start();
                let opened = path.strip_prefix(['"', '<']);
                return opened.map_or(CompletionPlace::Code, |p| {
                    CompletionPlace::Include(p.to_string())
                });
            }
            if rest.is_empty() {
                return CompletionPlace::Directive;
            }
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
            RawKind::Integer | RawKind::Float | RawKind::BadNumber => CompletionPlace::Number,
            _ => {
                let call = super::signature::open_call(spot);
                match call.is_some_and(|c| c.name == "layout") {
                    true => CompletionPlace::Layout,
                    false => CompletionPlace::Code,
                }
            }
        }
    }
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

fn directives() -> Vec<Proposal> {
    let all = DIRECTIVES.iter().chain(&["include"]);
    all.map(|name| Proposal::new(*name, CompletionKind::Keyword, 0))
        .collect()
}

fn layout() -> Vec<Proposal> {
    let all = [
        "location = ",
        "std140",
        "shared",
        "packed",
        "row_major",
        "column_major",
    ];
    all.iter()
        .map(|name| Proposal::new(*name, CompletionKind::Keyword, 0))
        .collect()
}

/// The files that an `#include` may refer to, relative to the document.
fn included(document: &Document, path: &str, files: &dyn Files) -> Vec<Proposal> {
    let own = std::path::Path::new(&document.path);
    let folder = own.parent().unwrap_or(own);
    let inner = path.rfind('/').and_then(|at| path.get(..at)).unwrap_or("");
    let folder = shaderlint_engine::path::plain(&folder.join(inner));
    let mut names = files.names(&folder);
    names.sort_unstable();
    let is_named = |name: &String| {
        let is_own = folder.join(name) == own;
        let is_folder =
            files.entry(&folder.join(name)) == Some(shaderlint_engine::FileType::Folder);
        let is_shader = shaderlint_text::kind::is_searched(name)
            && !name.ends_with(".json")
            && !name.ends_with(".js");
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

/// The letters of vector components (section 5.5).
const LETTERS: [&str; 3] = ["xyzw", "rgba", "stpq"];

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
                    Proposal::new(run, CompletionKind::Components, rank * 4 + run.len() as u8);
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

/// Names, keywords and snippets.
fn names(spot: &Spot) -> Vec<Proposal> {
    let program = spot.program();
    let at = hole(program);
    let mut found = Vec::new();
    let function = at.and_then(|token| function_around(program, token));
    variables(program, at, &mut found);
    functions(program, at, &mut found);
    types(program, &mut found);
    macros(program, &mut found);
    builtins(program, function.is_some(), &mut found);
    words(program, function.is_some(), &mut found);
    snippets(program, function.is_some(), &mut found);
    let mut seen = BTreeSet::new();
    found.retain(|c| {
        let is_snippet = c.kind == CompletionKind::Snippet;
        c.label != PLACEHOLDER && seen.insert((c.label.clone(), is_snippet))
    });
    found
}

/// The token of the placeholder.
fn hole(program: &Program) -> Option<TokenId> {
    let name = program.names.get(PLACEHOLDER)?;
    let mut all = program.tokens.tokens.iter().zip(0..);
    let is_hole =
        |t: &shaderlint_syntax::Token| t.kind == TokenKind::Identifier && t.value == name.0;
    all.find(|(token, _)| is_hole(token)).map(|(_, id)| id)
}

fn function_around(program: &Program, token: TokenId) -> Option<&FunctionDecl> {
    let inside = Extent::token(token);
    let mut all = program.tree.functions.iter();
    all.find(|f| f.body.is_some() && f.extent.contains(inside) && !f.header.contains(inside))
}

/// The innermost scope around a token (section 4.2.2).
fn scope(program: &Program, token: TokenId) -> Option<Extent> {
    let inside = Extent::token(token);
    let opens = |s: &&Stmt| {
        matches!(
            s.kind,
            StmtKind::Block(_)
                | StmtKind::For { .. }
                | StmtKind::While { .. }
                | StmtKind::Switch { .. }
        )
    };
    let around = program.tree.stmts.iter().filter(opens).map(|s| s.extent);
    let around = around.filter(|e| e.contains(inside));
    around.min_by_key(|e| e.last - e.first)
}

/// Whether a name is meant for users, and not internal to a host.
fn is_for_people(program: &Program, symbol: Symbol) -> bool {
    let declared = declared_at(program, symbol);
    let is_own = declared.is_none_or(|at| program.is_user(at));
    is_own || entry(symbol.name(program)).is_some()
}

/// Whether a variable is visible at a token.
fn is_visible(program: &Program, id: VariableId, at: TokenId) -> bool {
    let Some(variable) = program.variable(id) else {
        return false;
    };
    let Some(token) = variable.token else {
        return true;
    };
    if token >= at {
        return false;
    }
    let Some(function) = variable.function else {
        return true;
    };
    let function = program.function(function).and_then(|f| f.definition);
    let function = function.and_then(|f| program.tree.function(f));
    let here = Extent::token(at);
    let is_inside = function.is_some_and(|f| f.extent.contains(here));
    is_inside && scope(program, token).is_none_or(|scope| scope.contains(here))
}

fn variables(program: &Program, at: Option<TokenId>, found: &mut Vec<Proposal>) {
    let at = at.unwrap_or(TokenId::MAX);
    for (variable, id) in program.variables.iter().zip(0..) {
        let id = VariableId(id);
        if !is_visible(program, id, at) {
            continue;
        }
        let symbol = Symbol::Variable(id);
        if !is_for_people(program, symbol) {
            continue;
        }
        let kind = symbol.kind(program);
        let name = symbol.name(program);
        let rank = match kind {
            SymbolKind::Local | SymbolKind::Parameter => 0,
            _ if name.starts_with("gl_") => 4,
            _ => 1,
        };
        let item = Proposal::new(name, CompletionKind::Symbol(kind), rank);
        found.push(Proposal {
            text: entry(name).map_or(String::new(), |e| e.text.clone()),
            ..item.detail(program.type_name(variable.ty))
        });
    }
}

fn functions(program: &Program, at: Option<TokenId>, found: &mut Vec<Proposal>) {
    let at = at.unwrap_or(TokenId::MAX);
    for (function, id) in program.functions.iter().zip(0..) {
        let symbol = Symbol::Function(shaderlint_semantic::FunctionRef(id));
        let declared = program.tree.function(function.declaration);
        let name = symbol.name(program);
        let is_entry = shaderlint_semantic::starts_a_shader(name);
        let is_later = declared.is_none_or(|d| d.extent.first > at);
        if is_entry || is_later || !is_for_people(program, symbol) {
            continue;
        }
        let names = super::symbol::parameter_names(program, function);
        let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Function), 1);
        found.push(Proposal {
            snippet: Some(call(name, &names)),
            ..item.detail(symbol.declaration(program))
        });
    }
}

/// A call snippet with placeholders for its arguments.
fn call(name: &str, params: &[&str]) -> String {
    let places = params.iter().zip(1..);
    let places = places.map(|(param, i)| format!("${{{i}:{param}}}"));
    format!("{name}({})", places.collect::<Vec<_>>().join(", "))
}

fn types(program: &Program, found: &mut Vec<Proposal>) {
    for id in 0..program.structs.len() as u32 {
        let symbol = Symbol::Struct(id);
        let name = symbol.name(program);
        if !name.is_empty() && is_for_people(program, symbol) {
            found.push(Proposal::new(
                name,
                CompletionKind::Symbol(SymbolKind::Struct),
                1,
            ));
        }
    }
}

fn macros(program: &Program, found: &mut Vec<Proposal>) {
    for defined in program.tokens.macros.iter().filter(|m| !m.predefined) {
        if !is_for_people(program, Symbol::Macro(defined.name)) {
            continue;
        }
        let name = program.names.text(defined.name);
        let detail = Symbol::Macro(defined.name).declaration(program);
        let params = defined.params.as_ref();
        let params = params.map(|p| p.iter().map(|n| program.names.text(*n)).collect::<Vec<_>>());
        let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Macro), 2);
        found.push(Proposal {
            snippet: params.map(|p| call(name, &p)),
            ..item.detail(detail)
        });
    }
}

fn builtins(program: &Program, is_inside: bool, found: &mut Vec<Proposal>) {
    let all = Builtins::of(program.version, program.stage);
    if is_inside {
        for id in all.functions() {
            let description = entry(id.name());
            let (_, overloads) = all.overloads_of(id);
            let head = description.and_then(|e| e.heads.first());
            let item = Proposal::new(id.name(), CompletionKind::Symbol(SymbolKind::Function), 3);
            let form = overloads.first().map_or(String::new(), builtin_head);
            found.push(Proposal {
                snippet: head.map(|head| call(id.name(), head)),
                text: description.map_or(String::new(), |e| e.text.clone()),
                ..item.detail(form)
            });
        }
    }
    for name in all.variable_names().filter(|_| is_inside) {
        let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Global), 4);
        found.push(Proposal {
            text: entry(name).map_or(String::new(), |e| e.text.clone()),
            ..item.detail(super::symbol::builtin_variable(program, name).unwrap_or_default())
        });
    }
}

/// The keywords that are valid in the context.
fn words(program: &Program, is_inside: bool, found: &mut Vec<Proposal>) {
    let is_type =
        |word: &&TypeWord| matches!(classify(word.name(), program.version), WordClass::Type(_));
    for word in TypeWord::ALL.iter().filter(is_type) {
        found.push(Proposal::new(word.name(), CompletionKind::Type, 3));
    }
    let inside = [
        "break", "case", "continue", "default", "discard", "do", "else", "false", "for", "if",
        "return", "switch", "true", "while",
    ];
    let outside = [
        "attribute",
        "centroid",
        "flat",
        "in",
        "invariant",
        "layout",
        "out",
        "precision",
        "smooth",
        "uniform",
        "varying",
    ];
    let both = ["const", "highp", "lowp", "mediump", "struct", "void"];
    let place: &[&str] = if is_inside { &inside } else { &outside };
    let known = |word: &&&str| !matches!(classify(word, program.version), WordClass::Plain);
    let all = both.iter().chain(place).filter(known);
    found.extend(all.map(|word| Proposal::new(*word, CompletionKind::Keyword, 3)));
}

/// Snippets of frequent constructs.
fn snippets(program: &Program, is_inside: bool, found: &mut Vec<Proposal>) {
    let mut add = |label: &str, detail: &str, snippet: String| {
        let item = Proposal::new(label, CompletionKind::Snippet, 5);
        found.push(Proposal {
            snippet: Some(snippet),
            ..item.detail(detail)
        });
    };
    if is_inside {
        add(
            "for",
            "counting loop",
            "for (int ${1:i} = 0; ${1:i} < ${2:8}; ${1:i}++) {\n\t$0\n}".into(),
        );
        add(
            "if",
            "if statement",
            "if (${1:condition}) {\n\t$0\n}".into(),
        );
        return;
    }
    // A text without an entry function may become a shader of its host, or a ShaderToy pass.
    let version = program.tokens.version_span;
    let is_open = version.is_none_or(|span| !program.is_user(span));
    let is_open = is_open && program.stage == Stage::Fragment;
    let hosts = [
        Some(program.dialect),
        is_open.then_some(Dialect::ShaderToy(Pass::Image)),
    ];
    let entries = hosts.into_iter().flatten().filter_map(|d| d.host().entry);
    for entry in entries.filter(|_| program.entry().is_none()) {
        let body = format!("{} {{\n\t$0\n}}", entry.signature);
        add(entry.name, entry.signature, body);
    }
    add(
        "function",
        "function definition",
        "${1:float} ${2:name}(${3:float x}) {\n\treturn $0;\n}".into(),
    );
    add(
        "struct",
        "struct declaration",
        "struct ${1:Name} {\n\t${2:float value};\n};".into(),
    );
}
