//! Items of a shader with errors. Rules report nothing in them, and treat every name that occurs in them as
//! used, written to and called. Of a function that only uses names which are declared nowhere, the statements
//! that contain them are meant; elsewhere in it nothing is reported about a name that occurs in these.

use super::words::each_word;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, Facet, Lack, Severity};
use shaderlint_semantic::CallGraph;
use shaderlint_semantic::{Function, FunctionRef, Program, Storage, Type, Variable};
use shaderlint_syntax::ast::{ExprId, ExprKind, Extent, Item, Stmt, StmtId, StmtKind};
use shaderlint_syntax::{Macro, Name, TokenKind, WordClass, classify};
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
    /// Statements and conditions that use unknown names, in the order of the text. None contains another.
    unknown: Vec<Span>,
    /// The words in items with errors.
    words: FxHashSet<&'a str>,
    /// Names of the shader in statements with unknown names, each with the index of the item; without one
    /// if it is a global name.
    unsure: FxHashSet<(Option<usize>, &'a str)>,
    /// Names of functions that have errors, or call one that has.
    suspects: FxHashSet<Name>,
    /// By function: whether it has errors.
    functions: Vec<bool>,
    /// Whether an error is in no function and no declaration.
    pub is_everything: bool,
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
        let mut parts = StatementParts::of(program);
        let mut outside = Vec::new();
        for span in obstacles.unclear {
            let is_group = program.sources.text(*span).starts_with('#');
            let is_inside = is_group && broken.index_of(span.start).is_some();
            let is_placed = is_inside && parts.mark_group(*span) || parts.mark(span.start);
            if !is_placed && !broken.mark(span.start) {
                outside.push(span.start);
            }
        }
        broken.mark_macros(program, outside, &mut parts);
        for d in errors() {
            let is_name = d.lacks() == Some(Lack::Name) && !d.has(Facet::Moves);
            if !is_name || !parts.mark(d.span.start) {
                broken.mark_error(program, d, &mut parts);
            }
        }
        if !broken.any() && !parts.any() {
            return Broken::default();
        }
        if broken.is_everything {
            return broken;
        }
        broken.mark_unknown(program, &mut parts);
        broken.mark_dependents(program, &mut parts);
        parts.mark_loops(program);
        broken.unknown = parts.marked();
        broken.read_words(program);
        broken.mark_functions(program);
        broken
    }

    /// Whether any item has errors.
    pub fn any(&self) -> bool {
        self.is_everything
            || !self.unknown.is_empty()
            || self.items.iter().any(|(_, is_broken)| *is_broken)
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

    /// The spans with errors, in the order of the text.
    pub fn spans(&self) -> Vec<Span> {
        let broken = self.items.iter().filter(|(_, is_broken)| *is_broken);
        let broken = broken
            .map(|(span, _)| *span)
            .chain(self.unknown.iter().copied());
        let mut all: Vec<Span> = broken.collect();
        all.sort_unstable();
        all
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
        let item = self.index_of(finding.span.start);
        each_word(program.sources.text(finding.span), |word| {
            let name = program.names.get(word);
            is_clear &= !name.is_some_and(|n| self.suspects.contains(&n));
            let is_unsure = |item| self.unsure.contains(&(item, word));
            is_clear &= !is_unsure(item) && !is_unsure(None);
        });
        is_clear
    }

    /// Whether a span touches an item with errors, or a statement with unknown names.
    fn touches(&self, span: Span) -> bool {
        let after = self.unknown.partition_point(|s| s.end < span.start);
        let next = self.unknown.get(after);
        self.touches_item(span) || next.is_some_and(|s| s.start <= span.end)
    }

    /// Whether a span touches an item with errors.
    fn touches_item(&self, span: Span) -> bool {
        let from = self.items.partition_point(|(s, _)| s.end < span.start);
        let inside = self.items.iter().skip(from);
        let mut inside = inside.take_while(|(s, _)| s.start <= span.end);
        inside.any(|(_, is_broken)| *is_broken)
    }

    /// The index of the item at an address.
    fn index_of(&self, address: u32) -> Option<usize> {
        let after = self.items.partition_point(|(s, _)| s.start <= address);
        let index = after.checked_sub(1)?;
        let (span, _) = self.items.get(index)?;
        (address <= span.end).then_some(index)
    }

    /// Marks the item at an address; returns whether there is one.
    fn mark(&mut self, address: u32) -> bool {
        let item = self.index_of(address).and_then(|i| self.items.get_mut(i));
        item.map(|(_, is_broken)| *is_broken = true).is_some()
    }

    fn mark_error(&mut self, program: &Program, error: &Diagnostic, parts: &mut StatementParts) {
        // A missing or extra brace, or an unclosed conditional, moves the boundaries of items.
        self.is_everything |= error.subject.is_brace() || error.has(Facet::Moves);
        let calls = error.macros.iter().map(|m| m.call);
        let labels = error.labels.iter().map(|l| l.span);
        let others: Vec<Span> = calls.chain(labels).collect();
        for other in others {
            self.mark(other.start);
        }
        let at = error.span.start;
        let is_placed = self.mark(at) || self.mark_macros(program, vec![at], parts);
        self.is_everything |= !is_placed;
    }

    /// Marks all uses of the macros whose definitions contain one of the addresses; returns whether there is
    /// one.
    fn mark_macros(
        &mut self,
        program: &Program,
        mut addresses: Vec<u32>,
        parts: &mut StatementParts,
    ) -> bool {
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
            let is_held = holder.is_some_and(|s| token.spelled <= s.end);
            if is_held && !parts.mark(token.span.start) {
                self.mark(token.span.start);
            }
        }
        true
    }

    /// Marks what contains an invalid expression or statement, reported or not.
    fn mark_unknown(&mut self, program: &Program, parts: &mut StatementParts) {
        let tree = &program.tree;
        let exprs = tree.exprs.iter().zip(&program.exprs);
        let exprs = exprs.filter(|(e, info)| e.kind == ExprKind::Error || info.ty == Type::ERROR);
        let stmts = tree.stmts.iter().filter(|s| s.kind == StmtKind::Error);
        let variables = program.variables.iter().filter(|v| v.ty == Type::ERROR);
        let tokens = exprs
            .filter(|(e, _)| e.kind != ExprKind::Error)
            .map(|(e, _)| e.extent.first)
            .chain(variables.filter_map(|v| v.token));
        for token in tokens.filter_map(|token| program.token(token)) {
            if !parts.mark(token.span.start) {
                self.mark(token.span.start);
            }
        }
        let lost = tree.exprs.iter().filter(|e| e.kind == ExprKind::Error);
        let lost = lost.map(|e| e.extent.first);
        let lost = lost.chain(stmts.map(|s| s.extent.first));
        for token in lost.filter_map(|token| program.token(token)) {
            self.mark(token.span.start);
        }
    }

    /// Marks what uses a name whose declaration has errors, or was lost.
    fn mark_dependents(&mut self, program: &Program, parts: &mut StatementParts) {
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
            if is_lost && is_user(token.span) && !parts.mark(token.span.start) {
                self.mark(token.span.start);
            }
        }
    }

    fn read_words(&mut self, program: &'a Program) {
        let lost = program.tree.lost.iter().map(|n| program.names.text(*n));
        let mut words = FxHashSet::default();
        for span in self.spans() {
            each_word(program.sources.text(span), |word| {
                words.insert(word);
            });
        }
        // Functions of the language, types and what the shader cannot change are the same everywhere.
        let is_fixed =
            |v: &Variable| v.is_const || matches!(v.storage, Storage::Uniform | Storage::Input);
        let (fixed, others): (Vec<&Variable>, Vec<&Variable>) =
            program.variables.iter().partition(|v| is_fixed(v));
        let mut fixed: FxHashSet<Name> = fixed.iter().map(|v| v.name).collect();
        for variable in &others {
            fixed.remove(&variable.name);
        }
        let is_own = |word: &str| {
            let class = classify(word, program.version);
            let is_fixed = program
                .names
                .get(word)
                .is_some_and(|name| fixed.contains(&name));
            let is_language = program.builtins().function(word).is_some();
            matches!(class, WordClass::Plain) && !is_fixed && !is_language
        };
        let globals = others
            .iter()
            .filter(|v| v.function.is_none())
            .map(|v| v.name);
        let functions = program.functions.iter().map(|f| f.name);
        let globals: FxHashSet<Name> = globals.chain(functions).collect();
        for span in &self.unknown {
            let item = self.index_of(span.start);
            each_word(program.sources.text(*span), |word| {
                let name = program.names.get(word);
                let is_global = name.is_none_or(|name| globals.contains(&name));
                if is_own(word) {
                    self.unsure.insert((item.filter(|_| !is_global), word));
                }
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
        let extent = |f: &Function| {
            let decl = program.tree.function(f.definition.unwrap_or(f.declaration));
            decl.map(|d| program.span(d.extent))
        };
        let is_suspect = |f: &Function| extent(f).is_some_and(|span| self.touches(span));
        let mut suspect: Vec<bool> = program.functions.iter().map(is_suspect).collect();
        let is_broken = |f: &Function| extent(f).is_some_and(|span| self.touches_item(span));
        self.functions = program.functions.iter().map(is_broken).collect();
        let calls = CallGraph::of(program);
        let all = (0..).map(FunctionRef).zip(&suspect);
        let mut todo: Vec<FunctionRef> = all.filter(|(_, is)| **is).map(|(f, _)| f).collect();
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

/// The statements of a shader without others in them, and the heads of the others.
struct StatementParts {
    /// In the order of the text, and whether they are marked. None contains another.
    parts: Vec<(Span, bool)>,
    /// Marked groups of `#if`.
    groups: Vec<Span>,
}

impl StatementParts {
    fn of(program: &Program) -> StatementParts {
        let tree = &program.tree;
        let of_expr = |id: ExprId| tree.expr(id).extent;
        let head = |stmt: &Stmt, body: StmtId| Extent {
            first: stmt.extent.first,
            last: tree.stmt(body).extent.first.saturating_sub(1),
        };
        let part = |stmt: &Stmt| match stmt.kind {
            StmtKind::Expr(_) | StmtKind::Decl(_) | StmtKind::Return(_) => Some(stmt.extent),
            StmtKind::If { then, .. } => Some(head(stmt, then)),
            StmtKind::For { body, .. } | StmtKind::While { body, .. } => Some(head(stmt, body)),
            StmtKind::Switch { selector, .. } => Some(of_expr(selector)),
            StmtKind::Do { .. } => Some(Extent::token(stmt.extent.first)),
            _ => None,
        };
        // The statements in a head belong to it.
        let inner = tree.stmts.iter().flat_map(|stmt| match stmt.kind {
            StmtKind::For {
                init, condition, ..
            } => [Some(init), condition],
            StmtKind::While { condition, .. } => [Some(condition), None],
            _ => [None; 2],
        });
        let inner: FxHashSet<StmtId> = inner.flatten().collect();
        let stmts = tree.stmts.iter().zip((0..).map(StmtId));
        let extents = stmts
            .filter(|(_, id)| !inner.contains(id))
            .filter_map(|(stmt, _)| part(stmt));
        let ends = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
            StmtKind::Do { condition, .. } => Some(of_expr(condition)),
            _ => None,
        });
        let extents = extents.chain(ends);
        let mut parts: Vec<(Span, bool)> = extents.map(|e| (program.span(e), false)).collect();
        parts.sort_unstable();
        StatementParts {
            parts,
            groups: Vec::new(),
        }
    }

    /// Marks the part at an address; returns whether there is one.
    fn mark(&mut self, address: u32) -> bool {
        let after = self.parts.partition_point(|(s, _)| s.start <= address);
        let part = after.checked_sub(1).and_then(|i| self.parts.get_mut(i));
        let part = part.filter(|(span, _)| address < span.end);
        part.map(|(_, is_marked)| *is_marked = true).is_some()
    }

    /// Marks a group and the parts that it touches.
    fn mark_group(&mut self, group: Span) -> bool {
        let from = self.parts.partition_point(|(s, _)| s.end < group.start);
        let after = self.parts.iter_mut().skip(from);
        let inside = after.take_while(|(s, _)| s.start <= group.end);
        inside.for_each(|(_, is_marked)| *is_marked = true);
        self.groups.push(group);
        true
    }

    /// Marks the heads of loops with something marked in them: it may decide when they end.
    fn mark_loops(&mut self, program: &Program) {
        let marked = self.parts.iter().filter(|(_, is_marked)| *is_marked);
        let mut marked: Vec<Span> = marked.map(|(span, _)| *span).collect();
        marked.extend(&self.groups);
        marked.sort_unstable();
        let loops = program.tree.stmts.iter().filter(|s| s.kind.is_loop());
        for span in loops.map(|stmt| program.span(stmt.extent)) {
            let next = marked.partition_point(|s| s.start < span.start);
            if marked.get(next).is_some_and(|s| s.start <= span.end) {
                self.mark(span.start);
            }
        }
    }

    fn any(&self) -> bool {
        !self.groups.is_empty() || self.parts.iter().any(|(_, is_marked)| *is_marked)
    }

    /// What is marked, in the order of the text and without overlaps.
    fn marked(self) -> Vec<Span> {
        let marked = self.parts.into_iter().filter(|(_, is_marked)| *is_marked);
        let mut all: Vec<Span> = marked.map(|(span, _)| span).chain(self.groups).collect();
        all.sort_unstable();
        let mut apart: Vec<Span> = Vec::with_capacity(all.len());
        for span in all {
            match apart.last_mut() {
                Some(last) if span.start <= last.end => *last = last.to(span),
                _ => apart.push(span),
            }
        }
        apart
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
