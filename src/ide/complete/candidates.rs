//! The names, keywords and snippets that a completion offers, most likely first.

use super::expected::{Expected, Fit};
use super::proposal::{CompletionKind, PLACEHOLDER, Proposal};
use super::usage::{Usage, WordPlace};
use crate::document::Spot;
use crate::library::entry;
use crate::signature::builtin_head;
use crate::symbol::{Symbol, SymbolKind, declared_at};
use shaderlint_explain::library;
use shaderlint_host::Preset;
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{Dialect, Direction, Pass, Program, Stage, Storage, Type, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{TokenKind, TypeWord, WordClass, classify};
use std::collections::BTreeSet;

/// The candidates of one place.
struct Candidates<'p> {
    program: &'p Program,
    /// The host that completes the shader, other than ShaderToy.
    host: Option<&'static Preset>,
    /// The token of the placeholder.
    at: TokenId,
    expected: Expected,
    usage: Usage<'p>,
    found: Vec<(f32, Proposal)>,
}

/// The names, keywords and snippets at a placeholder, most likely first.
pub(crate) fn names(spot: &Spot) -> Vec<Proposal> {
    let program = spot.program();
    let code = spot.document.report.sources.code_at(spot.address);
    let (text, base) = code.map_or(("", spot.address), |code| (code.text, code.base));
    let at = hole(program);
    let mut all = Candidates {
        program,
        host: spot
            .analysis
            .host
            .filter(|_| !program.dialect.is_shadertoy()),
        at: at.unwrap_or(TokenId::MAX),
        expected: Expected::of(program, program.names.get(PLACEHOLDER)),
        usage: Usage::of(text, spot.address - base),
        found: Vec::new(),
    };
    // Braces in branches of `#if` need not be balanced.
    let is_outside = matches!(all.usage.place, WordPlace::Global | WordPlace::Parameter);
    let is_outside = is_outside && !at.is_some_and(|token| is_in_function(program, token));
    if !is_outside && all.usage.place != WordPlace::Expression {
        all.usage.place = WordPlace::Statement;
    }
    if !is_outside {
        all.variables();
        all.functions();
        all.builtins();
    }
    all.structs();
    all.macros();
    all.words();
    all.snippets();
    let mut found = all.found;
    found.sort_by(|(a, p), (b, q)| b.total_cmp(a).then_with(|| p.label.cmp(&q.label)));
    let mut seen = BTreeSet::new();
    found.retain(|(_, c)| {
        let is_snippet = c.kind == CompletionKind::Snippet;
        c.label != PLACEHOLDER && seen.insert((c.label.clone(), is_snippet))
    });
    let ranked = found.into_iter().zip(0..);
    ranked
        .map(|((_, item), rank)| Proposal { rank, ..item })
        .collect()
}

/// The token of the placeholder.
pub(super) fn hole(program: &Program) -> Option<TokenId> {
    let name = program.names.get(PLACEHOLDER)?;
    let mut all = program.tokens.tokens.iter().zip(0..);
    let is_hole =
        |t: &shaderlint_syntax::Token| t.kind == TokenKind::Identifier && t.value == name.0;
    all.find(|(token, _)| is_hole(token)).map(|(_, id)| id)
}

/// Whether a token is in the body of a function.
fn is_in_function(program: &Program, token: TokenId) -> bool {
    let inside = Extent::token(token);
    let mut all = program.tree.functions.iter();
    all.any(|f| f.body.is_some() && f.extent.contains(inside) && !f.header.contains(inside))
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

/// Whether a variable is visible at a token.
fn is_visible(program: &Program, id: VariableId, at: TokenId) -> bool {
    let Some(variable) = program.variable(id) else {
        return false;
    };
    let Some(token) = variable.token else {
        return true;
    };
    // The scope of a name starts after its initializer.
    let declarator = program.declarator_of(id);
    let is_own = declarator.is_some_and(|d| d.extent.contains(Extent::token(at)));
    if token >= at || is_own {
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

/// A call snippet with placeholders for its arguments.
fn call(name: &str, params: &[&str]) -> String {
    let places = params.iter().zip(1..);
    let places = places.map(|(param, i)| format!("${{{i}:{param}}}"));
    format!("{name}({})", places.collect::<Vec<_>>().join(", "))
}

/// Additional weight of a variable that is declared for this code, by it or by its host.
const VARIABLE: f32 = 2.0;

impl Candidates<'_> {
    fn add(&mut self, item: Proposal, fit: Fit) {
        let factor = match fit {
            Fit::Yes => 1.0,
            Fit::Unknown => 0.5,
            Fit::Part => 0.1,
            Fit::No => 0.003,
        };
        let is_variable = matches!(
            item.kind,
            CompletionKind::Symbol(
                SymbolKind::Local | SymbolKind::Parameter | SymbolKind::Uniform | SymbolKind::Input
            )
        );
        let known = if is_variable { VARIABLE } else { 0.0 };
        let likelihood = (self.usage.likelihood(&item.label) + known) * factor;
        self.found.push((likelihood, item));
    }

    /// Whether a name is meant for users, and not internal to a host.
    fn is_for_people(&self, symbol: Symbol) -> bool {
        let name = symbol.name(self.program);
        let declared = declared_at(self.program, symbol);
        let is_own = declared.is_none_or(|at| self.program.is_user(at));
        // ShaderToy's own code declares names that its documentation does not mention.
        let is_shown = !self.program.dialect.is_shadertoy() && !name.starts_with('_');
        is_own || is_shown || entry(name).is_some()
    }

    /// The documentation of a name that the language or the host declares.
    fn description(&self, name: &str) -> String {
        let of_host = self.host.and_then(|host| host.descriptions.get(name));
        let general = || entry(name).map(|entry| entry.text.clone());
        of_host.cloned().or_else(general).unwrap_or_default()
    }

    /// Adds a function; arguments that follow are kept.
    fn add_call(&mut self, item: Proposal, fit: Fit, params: Option<&[&str]>) {
        let params = params.filter(|_| self.usage.next != Some('('));
        let snippet = params.map(|params| call(&item.label, params));
        self.add(Proposal { snippet, ..item }, fit);
    }

    fn variables(&mut self) {
        let program = self.program;
        for (variable, id) in program.variables.iter().zip(0..) {
            let id = VariableId(id);
            let symbol = Symbol::Variable(id);
            if !is_visible(program, id, self.at) || !self.is_for_people(symbol) {
                continue;
            }
            let kind = symbol.kind(program);
            let name = symbol.name(program);
            let is_writable = matches!(
                kind,
                SymbolKind::Local | SymbolKind::Global | SymbolKind::Parameter | SymbolKind::Output
            );
            let fit = self.expected.variable(program, variable.ty, is_writable);
            let fit = match (self.usage.place, variable.storage) {
                (WordPlace::Statement, _) if !is_writable => Fit::No,
                (WordPlace::Statement, Storage::Param(Direction::In))
                | (WordPlace::Expression, Storage::Param(Direction::Out)) => fit.min(Fit::Part),
                _ => fit,
            };
            let item = Proposal::new(name, CompletionKind::Symbol(kind), 0);
            let item = Proposal {
                text: self.description(name),
                ..item.detail(program.type_name(variable.ty))
            };
            self.add(item, self.name_fit(fit));
        }
    }

    /// How well a name that is not a type fits.
    fn name_fit(&self, fit: Fit) -> Fit {
        match self.is_before_name() {
            true => Fit::No,
            false => fit,
        }
    }

    /// How well the name of a type fits, which has a constructor with these parameters.
    fn type_fit(&self, params: Option<&[Type]>, ty: Type) -> Fit {
        if self.is_before_name() {
            return Fit::Yes;
        }
        match self.usage.place {
            WordPlace::Expression => match params {
                Some(params) => self.expected.call(self.program, params, ty),
                None => self.expected.constructor(self.program, ty),
            },
            WordPlace::Statement if self.is_operand() || self.usage.next == Some('(') => Fit::No,
            _ => Fit::Yes,
        }
    }

    /// Whether an operator follows that only a value may precede.
    fn is_operand(&self) -> bool {
        let next = self.usage.next;
        next.is_some_and(|c| matches!(c, '=' | '.' | '[' | '+' | '-' | '*' | '/' | '<' | '>'))
    }

    fn is_before_name(&self) -> bool {
        let next = self.usage.next;
        let is_name = next.is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
        is_name && self.usage.place != WordPlace::Expression
    }

    fn functions(&mut self) {
        let program = self.program;
        for (function, id) in program.functions.iter().zip(0..) {
            let symbol = Symbol::Function(shaderlint_semantic::FunctionRef(id));
            let declared = program.tree.function(function.declaration);
            let name = symbol.name(program);
            let is_entry = shaderlint_semantic::starts_a_shader(name);
            let is_later = declared.is_none_or(|d| d.extent.first > self.at);
            if is_entry || is_later || !self.is_for_people(symbol) {
                continue;
            }
            let params: Vec<Type> = function.params.iter().map(|p| p.ty).collect();
            let fit = self.expected.call(program, &params, function.returns);
            let names = crate::symbol::parameter_names(program, function);
            let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Function), 0);
            let item = item.detail(symbol.declaration(program));
            self.add_call(item, self.name_fit(fit), Some(&names));
        }
    }

    fn structs(&mut self) {
        let program = self.program;
        for (record, id) in program.structs.iter().zip(0..) {
            let symbol = Symbol::Struct(id);
            let name = symbol.name(program);
            if !name.is_empty() && self.is_for_people(symbol) {
                let params: Vec<Type> = record.fields.iter().map(|f| f.ty).collect();
                let fit = self.type_fit(Some(&params), Type::structure(id));
                let kind = CompletionKind::Symbol(SymbolKind::Struct);
                self.add(Proposal::new(name, kind, 0), fit);
            }
        }
    }

    fn macros(&mut self) {
        let program = self.program;
        for defined in program.tokens.macros.iter().filter(|m| !m.predefined) {
            if !self.is_for_people(Symbol::Macro(defined.name)) {
                continue;
            }
            let name = program.names.text(defined.name);
            let detail = Symbol::Macro(defined.name).declaration(program);
            let params = defined.params.as_ref();
            let params =
                params.map(|p| p.iter().map(|n| program.names.text(*n)).collect::<Vec<_>>());
            let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Macro), 0);
            let fit = match params.is_some() == self.expected.is_call() {
                true => Fit::Unknown,
                false if params.is_some() => Fit::Unknown,
                false => Fit::Part,
            };
            self.add_call(item.detail(detail), fit, params.as_deref());
        }
    }

    fn builtins(&mut self) {
        let program = self.program;
        let all = Builtins::of(program.version, program.stage);
        for id in all.functions() {
            let description = entry(id.name());
            let (_, overloads) = all.overloads_of(id);
            let head = description.and_then(|e| e.heads.first());
            let form = overloads.first().map_or(String::new(), builtin_head);
            let fits = overloads.iter();
            let fits = fits.map(|o| self.expected.call(program, o.params(), o.returns));
            let fit = fits.max().unwrap_or(Fit::Unknown);
            let item = Proposal::new(id.name(), CompletionKind::Symbol(SymbolKind::Function), 0);
            let item = Proposal {
                text: description.map_or(String::new(), |e| e.text.clone()),
                ..item.detail(form)
            };
            self.add_call(item, self.name_fit(fit), head.map(|head| &head[..]));
        }
        for name in all.variable_names() {
            let item = Proposal::new(name, CompletionKind::Symbol(SymbolKind::Global), 0);
            let ty = all.variable(name).and_then(|v| v.ty).unwrap_or(Type::ERROR);
            let fit = self.expected.variable(program, ty, true);
            let item = Proposal {
                text: entry(name).map_or(String::new(), |e| e.text.clone()),
                ..item.detail(crate::symbol::builtin_variable(program, name).unwrap_or_default())
            };
            self.add(item, self.name_fit(fit));
        }
    }

    /// The keywords that are valid in the context.
    fn words(&mut self) {
        let program = self.program;
        for word in &TypeWord::ALL {
            if let WordClass::Type(_) = classify(word.name(), program.version) {
                let fit = self.type_fit(None, Type::of_word(*word));
                self.add(Proposal::new(word.name(), CompletionKind::Type, 0), fit);
            }
        }
        let allowed = match self.usage.place {
            WordPlace::Expression => "false true",
            WordPlace::Statement => {
                "break case const continue default discard do else for highp if lowp mediump \
                precision return struct switch while"
            }
            WordPlace::Parameter => "const highp in inout lowp mediump out",
            WordPlace::Global => {
                "attribute centroid const flat highp in invariant layout lowp mediump out \
                precision smooth struct uniform varying void"
            }
        };
        for word in allowed.split(' ') {
            if !matches!(classify(word, program.version), WordClass::Plain) {
                let fit = match self.usage.place {
                    WordPlace::Expression => self.expected.variable(program, Type::BOOL, false),
                    _ if self.usage.next == Some('=') => Fit::No,
                    _ if self.is_operand() && !matches!(word, "return" | "case") => Fit::No,
                    _ => Fit::Yes,
                };
                self.add(Proposal::new(word, CompletionKind::Keyword, 0), fit);
            }
        }
    }

    /// Snippets of frequent constructs.
    fn snippets(&mut self) {
        match self.usage.place {
            WordPlace::Statement => {
                self.snippet(
                    "for",
                    "counting loop",
                    "for (int ${1:i} = 0; ${1:i} < ${2:8}; ${1:i}++) {\n\t$0\n}",
                );
                self.snippet("if", "if statement", "if (${1:condition}) {\n\t$0\n}");
            }
            WordPlace::Global => {
                self.entries();
                self.snippet(
                    "function",
                    "function definition",
                    "${1:float} ${2:name}(${3:float x}) {\n\treturn $0;\n}",
                );
                self.snippet(
                    "struct",
                    "struct declaration",
                    "struct ${1:Name} {\n\t${2:float value};\n};",
                );
                self.definitions();
            }
            WordPlace::Parameter | WordPlace::Expression => {}
        }
    }

    /// Definitions of functions that many shaders use and this one lacks.
    fn definitions(&mut self) {
        let program = self.program;
        let own = program.functions.iter().map(|f| program.names.text(f.name));
        let own: BTreeSet<&str> = own.collect();
        let built_in = Builtins::of(program.version, program.stage);
        let lacks = |name: &&str| !own.contains(name) && built_in.function(name).is_none();
        for name in library::function_names().filter(lacks) {
            let mut parts: Vec<&str> = Vec::new();
            let overloads = library::functions(name);
            for definition in overloads
                .iter()
                .flat_map(|d| d.called())
                .chain(overloads.clone())
            {
                if !parts.contains(&definition.text) {
                    parts.push(definition.text);
                }
            }
            self.snippet(name, library::about(name), &parts.join("\n\n"));
        }
    }

    fn snippet(&mut self, label: &str, detail: &str, snippet: &str) {
        // The construct is already written.
        if self.usage.next == Some('(') {
            return;
        }
        let item = Proposal::new(label, CompletionKind::Snippet, 0);
        let snippet = Some(snippet.to_string());
        self.add(
            Proposal {
                snippet,
                ..item.detail(detail)
            },
            Fit::Unknown,
        );
    }

    /// The entry functions that the text lacks: of its host, or of a ShaderToy pass.
    fn entries(&mut self) {
        let program = self.program;
        let is_defined = |name: &str| {
            let mut all = program.functions.iter();
            all.any(|f| f.definition.is_some() && program.names.text(f.name) == name)
        };
        if let Some(host) = self.host {
            let names = host.entries.iter().filter(|name| !is_defined(name));
            let signed: Vec<_> = names
                .filter_map(|name| Some((name, signature_of(host, name)?)))
                .collect();
            for (name, signature) in signed {
                self.entry(name, signature);
            }
            return;
        }
        if program.entry().is_some() {
            return;
        }
        let version = program.tokens.version_span;
        let is_open = version.is_none_or(|span| !program.is_user(span));
        let is_open = is_open && program.stage == Stage::Fragment;
        let hosts = [
            Some(program.dialect),
            is_open.then_some(Dialect::ShaderToy(Pass::Image)),
        ];
        let entries = hosts.into_iter().flatten().filter_map(|d| d.host().entry);
        for entry in entries {
            self.entry(entry.name, entry.signature);
        }
    }

    fn entry(&mut self, name: &str, signature: &str) {
        self.snippet(name, signature, &format!("{signature} {{\n\t$0\n}}"));
    }
}

/// The declaration of an entry function of a host: its description shows it, unless it is the one
/// of WebGL or of ShaderToy.
fn signature_of(host: &'static Preset, name: &str) -> Option<&'static str> {
    let mut shown = host.about.split('`').skip(1).step_by(2);
    let is_of = |code: &&str| {
        let head = code.split_once('(').map_or("", |(head, _)| head);
        code.ends_with(')')
            && head.split_whitespace().count() == 2
            && head.ends_with(&format!(" {name}"))
    };
    let usual = [Dialect::WebGl, Dialect::ShaderToy(Pass::Image)];
    let mut usual = usual.into_iter().filter_map(|d| d.host().entry);
    let usual = usual.find(|entry| entry.name == name);
    shown.find(is_of).or(usual.map(|entry| entry.signature))
}
