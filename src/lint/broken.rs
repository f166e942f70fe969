//! Items of a shader with errors. Rules report nothing in them, and treat every name that occurs in them as
//! used, written to and called.

use super::words::each_word;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, Facet, Severity};
use shaderlint_semantic::CallGraph;
use shaderlint_semantic::{Function, FunctionRef, Program, Type};
use shaderlint_syntax::ast::{ExprKind, Item, StmtKind};
use shaderlint_syntax::{Macro, Name, TokenKind};
use shaderlint_text::{Role, Span};

/// Longest span of a finding in a shader with errors, in bytes: its words are looked up one by one.
const MAX_FINDING: u32 = 256;

/// Where rules cannot run.
#[derive(Clone, Copy, Default, Debug)]
pub struct Obstacles<'d> {
    /// The errors of the shader.
    pub errors: &'d [Diagnostic],
    /// Where the code that is compiled depends on the host of a shader fragment.
    pub unclear: &'d [Span],
}

/// The functions and declarations with errors or other obstacles, and those that depend on them.
#[derive(Default, Debug)]
pub struct Broken<'a> {
    /// The items at global scope, in the order of the text, and whether they have errors.
    items: Vec<(Span, bool)>,
    /// The words in items with errors.
    words: FxHashSet<&'a str>,
    /// Names of functions that have errors, or call one that has.
    suspects: FxHashSet<Name>,
    /// By function: whether it has errors.
    functions: Vec<bool>,
    /// Whether an error is in no function and no declaration.
    is_everything: bool,
}

impl<'a> Broken<'a> {
    /// Marks the items with obstacles, if there are any.
    pub fn of(program: &'a Program, obstacles: Obstacles) -> Broken<'a> {
        let mut broken = Broken::default();
        let found = obstacles.errors.iter();
        let errors = || found.clone().filter(|d| d.severity == Severity::Error);
        if errors().next().is_none() && obstacles.unclear.is_empty() {
            return broken;
        }
        broken.items = items(program);
        let mut outside: Vec<u32> = obstacles.unclear.iter().map(|s| s.start).collect();
        outside.retain(|at| !broken.mark(*at));
        broken.mark_macros(program, outside);
        errors().for_each(|d| broken.mark_error(program, d));
        if !broken.any() {
            return Broken::default();
        }
        if broken.is_everything {
            return broken;
        }
        broken.mark_unknown(program);
        broken.mark_dependents(program);
        broken.read_words(program);
        broken.mark_functions(program);
        broken
    }

    /// Whether any item has errors.
    pub fn any(&self) -> bool {
        self.is_everything || self.items.iter().any(|(_, is_broken)| *is_broken)
    }

    /// Whether no rule can run on the shader.
    pub fn is_everything(&self) -> bool {
        self.is_everything
    }

    /// Whether a function has errors.
    pub fn function(&self, function: FunctionRef) -> bool {
        let known = self.functions.get(function.0 as usize);
        known.copied().unwrap_or(false)
    }

    /// Whether a word occurs in an item with errors.
    pub fn has(&self, word: &str) -> bool {
        self.words.contains(word)
    }

    /// The words in items with errors.
    pub fn words(&self) -> impl Iterator<Item = &'a str> {
        self.words.iter().copied()
    }

    /// The spans of items with errors, in the order of the text.
    pub fn spans(&self) -> impl Iterator<Item = Span> {
        let broken = self.items.iter().filter(|(_, is_broken)| *is_broken);
        broken.map(|(span, _)| *span)
    }

    /// Whether a finding does not depend on an item with errors.
    pub fn admits(&self, program: &Program, finding: &Diagnostic) -> bool {
        let labels = finding.labels.iter().map(|l| l.span);
        let fixes = finding.fix.iter().flat_map(|f| &f.edits);
        let mut places = labels.chain(fixes.map(|e| e.span)).chain([finding.span]);
        if places.any(|span| self.touches(span)) || finding.span.len() > MAX_FINDING {
            return false;
        }
        let mut is_clear = true;
        each_word(program.sources.text(finding.span), |word| {
            let name = program.names.get(word);
            is_clear &= !name.is_some_and(|n| self.suspects.contains(&n));
        });
        is_clear
    }

    /// Whether a span touches an item with errors.
    fn touches(&self, span: Span) -> bool {
        let from = self.items.partition_point(|(s, _)| s.end < span.start);
        let inside = self.items.iter().skip(from);
        let mut inside = inside.take_while(|(s, _)| s.start <= span.end);
        inside.any(|(_, is_broken)| *is_broken)
    }

    /// Marks the item at an address; returns whether there is one.
    fn mark(&mut self, address: u32) -> bool {
        let after = self.items.partition_point(|(s, _)| s.start <= address);
        let item = after.checked_sub(1).and_then(|i| self.items.get_mut(i));
        match item.filter(|(span, _)| address <= span.end) {
            Some((_, is_broken)) => {
                *is_broken = true;
                true
            }
            None => false,
        }
    }

    fn mark_error(&mut self, program: &Program, error: &Diagnostic) {
        // A missing or extra brace, or an unclosed conditional, moves the boundaries of items.
        self.is_everything |= error.subject.is_brace() || error.has(Facet::Moves);
        let calls = error.macros.iter().map(|m| m.call);
        let labels = error.labels.iter().map(|l| l.span);
        let others: Vec<Span> = calls.chain(labels).collect();
        for other in others {
            self.mark(other.start);
        }
        let at = error.span.start;
        let is_placed = self.mark(at) || self.mark_macros(program, vec![at]);
        self.is_everything |= !is_placed;
    }

    /// Marks all uses of the macros whose definitions contain one of the addresses; returns whether there is
    /// one.
    fn mark_macros(&mut self, program: &Program, mut addresses: Vec<u32>) -> bool {
        addresses.sort_unstable();
        let tokens = &program.tokens;
        let extent = |m: &Macro| {
            let last = m.body.last().map_or(m.name_span, |p| p.token.span);
            m.name_span.to(last)
        };
        let holds = |s: &Span| {
            let next = addresses.partition_point(|at| *at < s.start);
            addresses.get(next).is_some_and(|at| *at <= s.end)
        };
        let holding = tokens.macros.iter().filter(|m| !m.predefined).map(extent);
        let mut holding: Vec<Span> = holding.filter(holds).collect();
        if holding.is_empty() {
            return false;
        }
        holding.sort_by_key(|s| s.start);
        for token in tokens.tokens.iter().filter(|t| !t.is_direct()) {
            let next = holding.partition_point(|s| s.start <= token.spelled);
            let holder = next.checked_sub(1).and_then(|i| holding.get(i));
            if holder.is_some_and(|s| token.spelled <= s.end) {
                self.mark(token.span.start);
            }
        }
        true
    }

    /// Marks items with an invalid expression or statement, reported or not.
    fn mark_unknown(&mut self, program: &Program) {
        let tree = &program.tree;
        let exprs = tree.exprs.iter().zip(&program.exprs);
        let exprs = exprs.filter(|(e, info)| e.kind == ExprKind::Error || info.ty == Type::ERROR);
        let stmts = tree.stmts.iter().filter(|s| s.kind == StmtKind::Error);
        let variables = program.variables.iter().filter(|v| v.ty == Type::ERROR);
        let tokens = exprs
            .map(|(e, _)| e.extent.first)
            .chain(stmts.map(|s| s.extent.first))
            .chain(variables.filter_map(|v| v.token));
        for token in tokens {
            if let Some(token) = program.token(token) {
                self.mark(token.span.start);
            }
        }
    }

    /// Marks items that use a name whose declaration has errors, or was lost.
    fn mark_dependents(&mut self, program: &Program) {
        let tree = &program.tree;
        let mut lost: FxHashSet<Name> = tree.lost.iter().copied().collect();
        let globals = program.variables.iter().filter(|v| v.function.is_none());
        let globals = globals.filter_map(|v| Some((v.name, v.token?)));
        let structs = tree.structs.iter().filter_map(|s| s.name);
        let structs = structs.map(|ident| (ident.name, ident.token));
        for (name, token) in globals.chain(structs) {
            let at = program.token(token).map(|t| t.span);
            if at.is_some_and(|span| self.touches(span)) {
                lost.insert(name);
            }
        }
        if lost.is_empty() {
            return;
        }
        // The code that a host adds uses its own names.
        let is_user = |span: Span| {
            let file = program.sources.file_at(span.start);
            file.is_some_and(|f| f.role == Role::User)
        };
        for token in &program.tokens.tokens {
            let is_lost = token.kind == TokenKind::Identifier && lost.contains(&Name(token.value));
            if is_lost && is_user(token.span) {
                self.mark(token.span.start);
            }
        }
    }

    fn read_words(&mut self, program: &'a Program) {
        let lost = program.tree.lost.iter().map(|n| program.names.text(*n));
        let broken = self.items.iter().filter(|(_, is_broken)| *is_broken);
        let mut words = FxHashSet::default();
        for (span, _) in broken {
            each_word(program.sources.text(*span), |word| {
                words.insert(word);
            });
        }
        // Names in macro expansions count as well.
        for token in program.tokens.tokens.iter().filter(|t| !t.is_direct()) {
            if token.kind == TokenKind::Identifier && self.touches(token.span) {
                words.insert(program.sources.text(Span::new(
                    token.spelled,
                    token.spelled + program.names.text(Name(token.value)).len() as u32,
                )));
            }
        }
        for name in lost {
            self.suspects.extend(program.names.get(name));
        }
        self.words = words;
    }

    fn mark_functions(&mut self, program: &Program) {
        let is_broken = |f: &Function| {
            let decl = f.definition.or(Some(f.declaration));
            let decl = decl.and_then(|d| program.tree.function(d));
            decl.is_some_and(|d| self.touches(program.span(d.extent)))
        };
        self.functions = program.functions.iter().map(is_broken).collect();
        let calls = CallGraph::of(program);
        let mut suspect = self.functions.clone();
        let all = (0..suspect.len() as u32).map(FunctionRef);
        let mut todo: Vec<FunctionRef> = all.filter(|f| self.function(*f)).collect();
        while let Some(next) = todo.pop() {
            for caller in calls.callers(next) {
                if let Some(is_suspect @ false) = suspect.get_mut(caller.0 as usize) {
                    *is_suspect = true;
                    todo.push(caller);
                }
            }
        }
        let named = program.functions.iter().zip(&suspect);
        let named = named.filter(|(_, is_suspect)| **is_suspect);
        self.suspects.extend(named.map(|(f, _)| f.name));
    }
}

/// The items at global scope.
fn items(program: &Program) -> Vec<(Span, bool)> {
    let tree = &program.tree;
    let extent = |item: &Item| match *item {
        Item::Function(f) => tree.function(f).map(|f| f.extent),
        Item::Decl(d) => tree.decl(d).map(|d| d.extent),
    };
    let extents = tree.items.iter().filter_map(extent);
    let mut items: Vec<(Span, bool)> = extents.map(|e| (program.span(e), false)).collect();
    items.sort_by_key(|(span, _)| span.start);
    items
}
