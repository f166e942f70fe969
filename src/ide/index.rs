//! Index of the names in a shader, with the symbols that they refer to.

use super::symbol::Symbol;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_semantic::{FunctionRef, Program, Resolution, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Name, RawItem, RawKind, RawToken, TokenKind, raw_items, tokenize};
use shaderlint_text::{CompiledText, Span};

/// How a symbol is used by an occurrence of its name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum NameUse {
    /// Declared and possibly defined elsewhere: a prototype.
    Declared,
    /// Declared and defined.
    Defined,
    /// Read, called, or used as a type.
    Read,
    /// Assigned.
    Written,
    /// Read and assigned.
    Changed,
    /// Not compiled: in an inactive group, or in the body of an unused macro.
    Unseen,
}

/// An occurrence of a name in the user's text.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Occurrence {
    /// Span of the name.
    pub span: Span,
    /// Symbol that it refers to.
    pub symbol: Symbol,
    /// How the symbol is used.
    pub access: NameUse,
}

/// The names of a shader.
#[derive(Default, Debug)]
pub struct Index {
    /// In source order; a name in the body of a macro may refer to several symbols.
    pub all: Vec<Occurrence>,
}

impl Index {
    /// Finds the names of a shader.
    pub fn of(program: &Program) -> Index {
        let mut builder = Builder {
            program,
            found: Vec::new(),
            targets: FxHashMap::default(),
        };
        builder.targets();
        builder.expressions();
        builder.declarations();
        builder.functions();
        builder.types();
        builder.macro_calls();
        let mut seen: FxHashSet<u32> = builder.found.iter().map(|o| o.span.start).collect();
        builder.directives(&mut seen);
        let mut all = builder.found;
        all.sort_unstable();
        all.dedup_by_key(|o| (o.span, o.symbol));
        Index { all }
    }

    /// The name at an address, or ending there.
    pub fn at(&self, address: u32) -> Option<Occurrence> {
        let after = self.all.partition_point(|o| o.span.start <= address);
        let before = self.all.get(..after)?.iter().rev().take(8);
        let touching = before.filter(|o| o.span.end >= address);
        // Of two adjacent names, the one that starts there.
        touching
            .copied()
            .max_by_key(|o| (o.span.start, o.access != NameUse::Unseen))
    }

    /// The occurrences of a symbol.
    pub fn named(&self, symbol: Symbol) -> impl Iterator<Item = Occurrence> {
        self.all.iter().copied().filter(move |o| o.symbol == symbol)
    }
}

struct Builder<'p> {
    program: &'p Program,
    found: Vec<Occurrence>,
    /// By expression: its use, unless it is read.
    targets: FxHashMap<ExprId, NameUse>,
}

impl Builder<'_> {
    fn add(&mut self, token: TokenId, name: Name, symbol: Symbol, access: NameUse) {
        let Some(token) = self.program.token(token) else {
            return;
        };
        // A token in the body of a macro is found in the `#define`.
        let text = self.program.names.text(name);
        let span = Span::new(token.spelled, token.spelled + text.len() as u32);
        self.add_at(span, text, symbol, access);
    }

    fn add_at(&mut self, span: Span, text: &str, symbol: Symbol, access: NameUse) {
        if self.program.is_user(span) && self.program.sources.text(span) == text {
            self.found.push(Occurrence {
                span,
                symbol,
                access,
            });
        }
    }

    /// Records assignments.
    fn targets(&mut self) {
        let program = self.program;
        for (expr, id) in program.tree.exprs.iter().zip(0..) {
            match expr.kind {
                ExprKind::Assign(None, target, _) => self.target(target, NameUse::Written),
                ExprKind::Assign(Some(_), target, _) | ExprKind::Postfix(_, target) => {
                    self.target(target, NameUse::Changed);
                }
                ExprKind::Unary(op, target) if op.assigns() => {
                    self.target(target, NameUse::Changed)
                }
                ExprKind::Call(_, list) => {
                    for (position, arg) in program.tree.args(list).iter().enumerate() {
                        if let Some(access) = self.argument(ExprId(id), position) {
                            self.target(*arg, access);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// The use of an argument, unless it is read.
    fn argument(&self, call: ExprId, position: usize) -> Option<NameUse> {
        match self.program.expr(call).resolution {
            Resolution::Function(f) => {
                let direction = self.program.function(f)?.params.get(position)?.direction;
                match (direction.reads(), direction.writes()) {
                    (true, true) => Some(NameUse::Changed),
                    (false, true) => Some(NameUse::Written),
                    _ => None,
                }
            }
            Resolution::Builtin(_) => {
                let overload = self.program.overload_called(call)?;
                overload.writes(position).then_some(NameUse::Written)
            }
            _ => None,
        }
    }

    fn target(&mut self, mut target: ExprId, access: NameUse) {
        loop {
            target = match self.program.tree.expr(target).kind {
                ExprKind::Paren(inner) | ExprKind::Index(inner, _) => inner,
                ExprKind::Member(inner, _) => {
                    self.targets.insert(target, access);
                    inner
                }
                ExprKind::Name(_) => break,
                _ => return,
            };
        }
        self.targets.insert(target, access);
    }

    fn expressions(&mut self) {
        let program = self.program;
        for (expr, id) in program.tree.exprs.iter().zip(0..) {
            let id = ExprId(id);
            let access = self.targets.get(&id).copied().unwrap_or(NameUse::Read);
            match expr.kind {
                ExprKind::Name(name) => {
                    if let Resolution::Variable(variable) = program.expr(id).resolution {
                        self.add(expr.extent.first, name, Symbol::Variable(variable), access);
                    }
                }
                ExprKind::Call(name, _) => {
                    let symbol = match program.expr(id).resolution {
                        Resolution::Function(function) => Symbol::Function(function),
                        Resolution::Struct(number) => Symbol::Struct(number),
                        Resolution::Builtin(_) => match program.builtin_called(id) {
                            Some(builtin) => Symbol::Builtin(builtin),
                            None => continue,
                        },
                        Resolution::Variable(_) | Resolution::None => continue,
                    };
                    self.add(expr.extent.first, name, symbol, NameUse::Read);
                }
                ExprKind::Member(object, name) => {
                    if let Some(symbol) = self.member(object, name) {
                        self.add(expr.extent.last, name, symbol, access);
                    }
                }
                _ => {}
            }
        }
    }

    fn member(&self, object: ExprId, name: Name) -> Option<Symbol> {
        let ty = self.program.ty(object);
        let number = struct_number(ty)?;
        let fields = &self.program.structs.get(number as usize)?.fields;
        let field = fields.iter().position(|f| f.name == name)?;
        Some(Symbol::Field(number, field as u32))
    }

    fn declarations(&mut self) {
        let program = self.program;
        for (variable, id) in program.variables.iter().zip(0..) {
            if let Some(token) = variable.token {
                let symbol = Symbol::Variable(VariableId(id));
                self.add(token, variable.name, symbol, NameUse::Defined);
            }
        }
        for decl in &program.tree.decls {
            // `invariant position;`
            if let DeclKind::Qualifiers {
                ident: Some(ident), ..
            } = decl.kind
                && let Some(variable) = self.global(ident.name)
            {
                let symbol = Symbol::Variable(variable);
                self.add(ident.token, ident.name, symbol, NameUse::Read);
            }
        }
    }

    fn global(&self, name: Name) -> Option<VariableId> {
        let mut all = self.program.variables.iter().zip(0..);
        let found = all.find(|(v, _)| v.name == name && v.function.is_none())?;
        Some(VariableId(found.1))
    }

    fn functions(&mut self) {
        let program = self.program;
        let mut by_id: FxHashMap<FunctionId, FunctionRef> = FxHashMap::default();
        for (function, number) in program.functions.iter().zip(0..) {
            by_id.insert(function.declaration, FunctionRef(number));
            if let Some(definition) = function.definition {
                by_id.insert(definition, FunctionRef(number));
            }
        }
        for (decl, id) in program.tree.functions.iter().zip(0..) {
            let known = by_id.get(&FunctionId(id)).copied();
            let Some(function) = known.or_else(|| self.repeated(decl)) else {
                continue;
            };
            let access = match decl.body {
                Some(_) => NameUse::Defined,
                None => NameUse::Declared,
            };
            self.add(
                decl.ident.token,
                decl.ident.name,
                Symbol::Function(function),
                access,
            );
        }
    }

    /// The function that a repeated prototype declares.
    fn repeated(&self, decl: &FunctionDecl) -> Option<FunctionRef> {
        let is_it = |f: &shaderlint_semantic::Function| {
            f.name == decl.ident.name && f.params.len() == decl.params.len as usize
        };
        let mut all = self.program.functions.iter().zip(0..);
        let mut found = all.by_ref().filter(|(f, _)| is_it(f)).map(|(_, i)| i);
        let first = found.next()?;
        found.next().is_none().then_some(FunctionRef(first))
    }

    /// Structs, their members, and their uses as types.
    fn types(&mut self) {
        let program = self.program;
        let mut named: FxHashMap<Name, Vec<(TokenId, u32)>> = FxHashMap::default();
        // The members of a block without an instance name are variables.
        let variables = program.variables.iter().filter_map(|v| v.token);
        let variables: FxHashSet<TokenId> = variables.collect();
        for (record, number) in program.structs.iter().zip(0..) {
            if let Some(name) = record.name {
                named.entry(name).or_default().push((record.token, number));
                self.add(record.token, name, Symbol::Struct(number), NameUse::Defined);
            }
            for (field, at) in record.fields.iter().zip(0..) {
                if variables.contains(&field.token) {
                    continue;
                }
                let symbol = Symbol::Field(number, at);
                self.add(field.token, field.name, symbol, NameUse::Defined);
            }
        }
        for ty in &program.tree.types {
            let TypeBase::Name(name) = ty.base else {
                continue;
            };
            let before = named.get(&name).map_or(&[][..], Vec::as_slice).iter();
            let mut before = before.rev().filter(|(token, _)| *token < ty.extent.first);
            let last = before.next();
            if let Some((_, number)) = last {
                self.add(
                    ty.extent.first,
                    name,
                    Symbol::Struct(*number),
                    NameUse::Read,
                );
            }
        }
    }

    fn macro_calls(&mut self) {
        let tokens = &self.program.tokens;
        for expansion in &tokens.expansions {
            let Some(definition) = tokens.macros.get(expansion.definition.0 as usize) else {
                continue;
            };
            let text = self.program.names.text(definition.name);
            let span = Span::new(
                expansion.call.start,
                expansion.call.start + text.len() as u32,
            );
            self.add_at(span, text, Symbol::Macro(definition.name), NameUse::Read);
        }
    }

    /// Names in directives and in code that is not compiled. `seen` contains the addresses of known
    /// names.
    fn directives(&mut self, seen: &mut FxHashSet<u32>) {
        let global = Globals::of(self.program);
        for CompiledText { text, base, .. } in user_texts(self.program) {
            let tokens = tokenize(text, base);
            for item in raw_items(&tokens) {
                match item {
                    RawItem::Directive(_, line) => self.directive(line, &global, seen),
                    RawItem::Token(token) if token.kind == RawKind::Word => {
                        if is_inactive(self.program, token.span) {
                            self.unseen(token.span, &global, seen);
                        }
                    }
                    RawItem::Token(_) => {}
                }
            }
        }
    }

    fn directive(&mut self, line: &[RawToken], global: &Globals, seen: &mut FxHashSet<u32>) {
        let mut words = line.iter().filter(|t| t.kind == RawKind::Word);
        let Some(first) = words.next() else {
            return;
        };
        let program = self.program;
        let text = |token: &RawToken| program.sources.text(token.span);
        match text(first) {
            "define" => self.define(line, global, seen),
            "if" | "ifdef" | "ifndef" | "elif" | "undef" => {
                for word in words {
                    let name = program.names.get(text(word));
                    if let Some(name) = name.filter(|n| global.macros.contains(n)) {
                        let symbol = Symbol::Macro(name);
                        seen.insert(word.span.start);
                        self.add_at(word.span, text(word), symbol, NameUse::Read);
                    }
                }
            }
            _ => {}
        }
    }

    fn define(&mut self, line: &[RawToken], global: &Globals, seen: &mut FxHashSet<u32>) {
        let program = self.program;
        let text = |span: Span| program.sources.text(span);
        let mut rest = line.iter().skip_while(|t| t.kind != RawKind::Word).skip(1);
        let mut rest = rest.by_ref().skip_while(|t| t.kind == RawKind::Whitespace);
        let Some(head) = rest.next().filter(|t| t.kind == RawKind::Word) else {
            return;
        };
        if let Some(name) = program.names.get(text(head.span)) {
            seen.insert(head.span.start);
            self.add_at(
                head.span,
                text(head.span),
                Symbol::Macro(name),
                NameUse::Defined,
            );
        }
        let rest: Vec<&RawToken> = rest.collect();
        let is_mark = |t: &RawToken, kind| t.kind == RawKind::Operator(kind);
        let has_params = rest
            .first()
            .is_some_and(|t| is_mark(t, TokenKind::LeftParen));
        let close = rest.iter().position(|t| is_mark(t, TokenKind::RightParen));
        let (params, body) = match (has_params, close) {
            (true, Some(close)) => rest.split_at(close),
            _ => (&[][..], rest.as_slice()),
        };
        let words = |tokens: &[&RawToken]| {
            let words = tokens.iter().filter(|t| t.kind == RawKind::Word);
            words.map(|t| t.span).collect::<Vec<_>>()
        };
        let mut own: FxHashMap<&str, u32> = FxHashMap::default();
        for (span, number) in words(params).into_iter().zip(0..) {
            own.insert(text(span), number);
            let symbol = Symbol::MacroParameter(head.span.start, number);
            self.add_at(span, text(span), symbol, NameUse::Defined);
        }
        for span in words(body) {
            match own.get(text(span)) {
                Some(number) => {
                    let symbol = Symbol::MacroParameter(head.span.start, *number);
                    seen.insert(span.start);
                    self.add_at(span, text(span), symbol, NameUse::Read);
                }
                None => self.unseen(span, global, seen),
            }
        }
    }

    /// A word that is not compiled: it refers to the global symbol of its name.
    fn unseen(&mut self, span: Span, global: &Globals, seen: &mut FxHashSet<u32>) {
        let text = self.program.sources.text(span);
        let Some(name) = self.program.names.get(text) else {
            return;
        };
        let found = global
            .symbols
            .get(&name)
            .filter(|_| seen.insert(span.start));
        for symbol in found.into_iter().flatten() {
            self.add_at(span, text, *symbol, NameUse::Unseen);
        }
    }
}

/// Global symbols by name.
struct Globals {
    macros: FxHashSet<Name>,
    symbols: FxHashMap<Name, Vec<Symbol>>,
}

impl Globals {
    fn of(program: &Program) -> Globals {
        let mut symbols: FxHashMap<Name, Vec<Symbol>> = FxHashMap::default();
        let own = program.tokens.macros.iter().filter(|m| !m.predefined);
        let macros: FxHashSet<Name> = own.map(|m| m.name).collect();
        for (function, i) in program.functions.iter().zip(0..) {
            let all = symbols.entry(function.name).or_default();
            all.push(Symbol::Function(FunctionRef(i)));
        }
        for (variable, i) in program.variables.iter().zip(0..) {
            if variable.function.is_none() {
                let all = symbols.entry(variable.name).or_default();
                all.push(Symbol::Variable(VariableId(i)));
            }
        }
        for (record, i) in program.structs.iter().zip(0..) {
            if let Some(name) = record.name {
                symbols.entry(name).or_default().push(Symbol::Struct(i));
            }
        }
        for name in &macros {
            symbols.insert(*name, vec![Symbol::Macro(*name)]);
        }
        Globals { macros, symbols }
    }
}

/// The index of the struct or block of a type.
pub fn struct_number(ty: shaderlint_semantic::Type) -> Option<u32> {
    use shaderlint_semantic::Base;
    match ty.base {
        Base::Struct(id) | Base::Block(id) if !ty.is_array() => Some(u32::from(id)),
        _ => None,
    }
}

/// Whether code is not compiled.
pub fn is_inactive(program: &Program, span: Span) -> bool {
    let inactive = &program.tokens.inactive;
    let after = inactive.partition_point(|s| s.start <= span.start);
    let last = after.checked_sub(1).and_then(|i| inactive.get(i));
    last.is_some_and(|s| s.contains(span))
}

/// The user's texts that a shader consists of, in order.
fn user_texts(program: &Program) -> Vec<CompiledText<'_>> {
    let mut found = Vec::new();
    let mut bounds: Vec<Span> = Vec::new();
    let tokens = program.tokens.tokens.iter().map(|t| t.spelled);
    let names = program.tokens.macros.iter().filter(|m| !m.predefined);
    let names = names.map(|m| m.name_span.start);
    for address in tokens.chain(names) {
        let is_known = |s: &Span| s.start <= address && address <= s.end;
        if bounds.last().is_some_and(is_known) || bounds.iter().any(is_known) {
            continue;
        }
        if let Some(code) = program.sources.code_at(address) {
            bounds.push(Span::new(code.base, code.base + code.text.len() as u32));
            if program.sources.is_user(code.base) {
                found.push(code);
            }
        }
    }
    found
}
