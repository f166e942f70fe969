//! Names of other languages that nothing declares: what GLSL has for them, and the edit.

use super::qualifier::Wanted;
use super::*;
use crate::diagnostic::Fix;
use crate::syntax::{Foreign, Meaning, WordClass, classify, foreign};
use crate::text::Edit;

impl Checker<'_> {
    fn foreign(&self, name: Name) -> Option<Foreign> {
        foreign(self.text(name), self.version)
    }

    /// Whether an undeclared function has a name that other languages use.
    pub(super) fn is_foreign(&self, name: Name, id: ExprId) -> bool {
        let token = self.tree.expr(id).extent.first;
        self.foreign(name).is_some() && self.declared_later(name, token).is_none()
    }

    /// The type of GLSL that an undeclared one stands for; it is reported.
    pub(super) fn foreign_type(&mut self, name: Name, token: TokenId) -> Option<Type> {
        let found = self.foreign(name)?;
        let text = self.text(name);
        let Meaning::Type(word) = found.meaning else {
            let Meaning::Absent(why) = found.meaning else {
                return None;
            };
            if !self.was_reported(name) {
                let message = format!("GLSL has no `{text}`");
                let d = self.error_at(error::UNKNOWN_TYPE, token, message);
                self.report_undeclared(name, d.note(why));
            }
            return Some(Type::ERROR);
        };
        let WordClass::Type(ty) = classify(word, self.version) else {
            return None;
        };
        let ty = Type::of_word(ty);
        let before = token.checked_sub(1).map(|t| self.token(t).kind);
        let lacks_uniform = ty.is_sampler()
            && self.at_global_scope()
            && matches!(
                before,
                None | Some(TokenKind::Semicolon | TokenKind::RightBrace)
            );
        if !self.was_reported(name) {
            let d = self.foreign_error(error::UNKNOWN_TYPE, token, found, "type", word);
            let d = match lacks_uniform {
                true => self.rename_fix(d, name, &format!("uniform {word}")),
                false => self.rename_fix(d, name, word),
            };
            self.report_undeclared(name, d);
        }
        Some(if lacks_uniform { Type::ERROR } else { ty })
    }

    /// The type of the values of variables that are declared with `var`, `let` or `auto`, if this
    /// is such a word; it is reported.
    pub(super) fn inferred_type(
        &mut self,
        qualifiers: List,
        ty: TypeId,
        declarators: List,
    ) -> Option<(Type, Wanted)> {
        let tree = self.tree;
        let spec = tree.ty(ty);
        let token = spec.extent.first;
        let word = match spec.base {
            TypeBase::Name(name) if self.scopes.get(name).is_none() => {
                matches!(self.foreign(name)?.meaning, Meaning::Inferred).then(|| self.text(name))?
            }
            _ => return None,
        };
        let mut found = None;
        for declarator in tree.declarators(declarators) {
            let init = declarator.init?;
            self.eval(init);
            let ty = self.ty(init);
            if *found.get_or_insert(ty) != ty {
                found = Some(Type::ERROR);
            }
        }
        let found = found.filter(|t| !t.is_void()).unwrap_or(Type::ERROR);
        let message = format!("`{word}` is no type: GLSL takes none from a value");
        let d = self.error_at(error::UNKNOWN_TYPE, token, message);
        let name = self.name_of(found);
        // What other languages call constant is set once, here it is known before the shader runs.
        let all = tree.qualifiers(qualifiers);
        let values = tree.declarators(declarators);
        let is_known = values
            .iter()
            .all(|d| d.init.is_some_and(|i| self.info(i).is_const));
        let (from, wanted) = match all {
            [only] if only.kind == QualifierKind::Const && is_known => (token, Wanted::Const),
            [only] if only.kind == QualifierKind::Const => (only.extent.first, Wanted::None),
            _ => (token, Wanted::None),
        };
        let span = self.token_span(from).to(self.token_span(token));
        let d = match found.is_error() {
            true => d.help("write the type: `float`, `vec3`, ..."),
            false => d.fix(Fix::safe(
                format!("write `{name}`"),
                vec![Edit::replace(span, name)],
            )),
        };
        self.report(d);
        Some((found, wanted))
    }

    fn foreign_error(
        &self,
        rule: &'static str,
        token: TokenId,
        found: Foreign,
        what: &str,
        has: &str,
    ) -> Diagnostic {
        let text = self.text(Name(self.token(token).value));
        let message = format!("there is no {what} `{text}`: GLSL has `{has}`");
        self.error_at(rule, token, message)
            .note(format!("`{text}` is a word of {}", found.language))
    }

    /// Writes `to` in the place of every use of a name.
    pub(super) fn rename_fix(&self, d: Diagnostic, name: Name, to: &str) -> Diagnostic {
        let edits = self.rename_all(name, to);
        match edits.len() {
            0 => d.help(format!("write `{to}`")),
            1 => d.fix(Fix::safe(format!("write `{to}`"), edits)),
            n => d.fix(Fix::safe(format!("write `{to}` in all {n} places"), edits)),
        }
    }

    /// What to say of an undeclared name that is a value in other languages.
    pub(super) fn foreign_value(&mut self, name: Name, token: TokenId) -> Option<Diagnostic> {
        let text = self.text(name);
        let found = self.foreign(name)?;
        match found.meaning {
            _ if self
                .nearest_name(text, false)
                .is_some_and(|n| n.eq_ignore_ascii_case(text)) =>
            {
                None
            }
            Meaning::Value(value) => {
                let d = self.foreign_error(error::UNDECLARED_NAME, token, found, "value", value);
                Some(self.rename_fix(d, name, value))
            }
            Meaning::Zero => Some(self.foreign_zero(name, token)),
            Meaning::Namespace => {
                let message = format!("GLSL has no `{text}`: its functions stand alone");
                let d = self.error_at(error::UNDECLARED_NAME, token, message);
                let edits = self.unqualify(name);
                let fix =
                    (!edits.is_empty()).then(|| Fix::safe(format!("take `{text}.` away"), edits));
                Some(d.fix(fix))
            }
            Meaning::Silent => {
                let message = format!("a shader cannot print, and has no `{text}`");
                let d = self
                    .error_at(error::UNDECLARED_NAME, token, message)
                    .note("a value is seen by its colour: write it to the output");
                Some(d.fix(self.remove_statement(token)))
            }
            Meaning::Absent(why) => {
                let message = format!("GLSL has no `{text}`");
                Some(
                    self.error_at(error::UNDECLARED_NAME, token, message)
                        .note(why),
                )
            }
            _ => None,
        }
    }

    /// `null`, `None` and their kin.
    fn foreign_zero(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let d = self
            .error_at(
                error::UNDECLARED_NAME,
                token,
                format!("GLSL has no `{text}`"),
            )
            .note("a variable always has a value of its type");
        let wanted = self.wanted.or_else(|| {
            let before = self.tree.exprs.get(self.exprs.len().checked_sub(1)?)?;
            let ty = self.exprs.last()?.ty;
            let assigns = self.token(before.extent.last + 1).kind == TokenKind::Equal;
            (assigns && before.extent.last + 2 == token).then_some(ty)
        });
        match wanted.and_then(|ty| self.zero_of(ty)) {
            Some(zero) => d.fix(Fix::suggestion(
                format!("write `{zero}`"),
                vec![Edit::replace(self.token_span(token), zero)],
            )),
            None => d,
        }
    }

    /// 0 as a value of a type of numbers.
    pub(super) fn zero_of(&self, ty: Type) -> Option<String> {
        let zero = match ty.scalar_kind()? {
            Scalar::Float => "0.0",
            Scalar::Int => "0",
            Scalar::Uint => "0u",
            Scalar::Bool => "false",
        };
        match ty.is_scalar() {
            true => Some(zero.to_string()),
            false if ty.is_array() => None,
            false => Some(format!("{}({zero})", self.name_of(ty))),
        }
    }

    /// Edits that take the name of a namespace away before names that GLSL has or has a word for.
    fn unqualify(&self, name: Name) -> Vec<Edit> {
        let all = &self.tokens.tokens;
        let mut edits = Vec::new();
        for (i, token) in all.iter().enumerate() {
            if token.kind != TokenKind::Identifier || token.value != name.0 {
                continue;
            }
            let (Some(dot), Some(member)) = (all.get(i + 1), all.get(i + 2)) else {
                return Vec::new();
            };
            if dot.kind != TokenKind::Dot || ![token, dot, member].iter().all(|t| t.is_direct()) {
                return Vec::new();
            }
            let text = self.sources.text(member.span);
            let lower = text.to_ascii_lowercase();
            let to = match foreign(text, self.version).map(|f| f.meaning) {
                Some(Meaning::Value(word) | Meaning::Function(word) | Meaning::Type(word)) => word,
                _ if self.builtins.function(text).is_some() => text,
                _ if self.builtins.function(&lower).is_some() => &lower,
                _ => return Vec::new(),
            };
            edits.push(Edit::replace(token.span.to(member.span), to));
        }
        edits
    }

    /// Takes the statement away that starts at `token`, if one does.
    fn remove_statement(&self, token: TokenId) -> Option<Fix> {
        let all = &self.tokens.tokens;
        let before = all.get((token as usize).checked_sub(1)?)?;
        use TokenKind as T;
        if !matches!(before.kind, T::Semicolon | T::LeftBrace | T::RightBrace) {
            return None;
        }
        let rest = all.get(token as usize..)?;
        let end = rest.iter().position(|t| t.kind == T::Semicolon)?;
        let last = token + end as u32;
        let extent = Extent { first: token, last };
        let is_plain = rest
            .get(..end)?
            .iter()
            .all(|t| !matches!(t.kind, T::LeftBrace | T::RightBrace));
        let edit = Edit::delete(self.span(extent));
        (is_plain && self.is_direct(extent))
            .then(|| Fix::suggestion("take the statement out", vec![edit]))
    }

    /// A call of a function that other languages have.
    pub(super) fn foreign_call(&mut self, id: ExprId, name: Name, args: List) -> ExprInfo {
        let tree = self.tree;
        let types: Vec<Type> = tree.args(args).iter().map(|&a| self.ty(a)).collect();
        let token = tree.expr(id).extent.first;
        let Some(found) = self.foreign(name) else {
            return ExprInfo::ERROR;
        };
        let rule = error::UNDECLARED_NAME;
        let d = match found.meaning {
            Meaning::Type(_) => {
                let ty = self.foreign_type(name, token).unwrap_or(Type::ERROR);
                return self.construct_type(id, ty, args);
            }
            _ if self.was_reported(name) => None,
            // What it would print was reported.
            Meaning::Silent if types.iter().any(|t| t.is_error()) => None,
            Meaning::Function(word) => {
                let d = self.foreign_error(rule, token, found, "function", word);
                Some(self.rename_fix(d, name, word))
            }
            Meaning::Code(code, count) => {
                let d = self.foreign_error(rule, token, found, "function", &shown(code));
                Some(
                    d.fix(
                        self.rewrite_calls(name, code, count)
                            .map(|(t, e)| Fix::safe(t, e)),
                    ),
                )
            }
            Meaning::Nearly(code, count, why) => {
                let d = self.foreign_error(rule, token, found, "function", &shown(code));
                let fix = self.rewrite_calls(name, code, count);
                Some(d.note(why).fix(fix.map(|(t, e)| Fix::suggestion(t, e))))
            }
            Meaning::Statement(code, count) => {
                let d = self.foreign_error(rule, token, found, "function", &shown(code));
                let fix = self
                    .remove_statement(token)
                    .filter(|_| types.first() == Some(&Type::FLOAT));
                let edits = fix.and_then(|_| self.rewrite_call(id, code, count));
                Some(d.fix(edits.map(|(text, edits)| Fix::safe(format!("write `{text}`"), edits))))
            }
            _ => match self.foreign_value(name, token) {
                Some(d) => Some(d),
                None => {
                    self.undeclared_function(name, token);
                    None
                }
            },
        };
        if let Some(d) = d {
            self.report_undeclared(name, d);
        }
        ExprInfo {
            ty: self.type_of_foreign(found.meaning, &types),
            ..ExprInfo::ERROR
        }
    }

    /// The type of a call of a foreign function, as far as it is known.
    fn type_of_foreign(&self, meaning: Meaning, types: &[Type]) -> Type {
        let found = match (meaning, types) {
            (Meaning::Function(word), _) => self.builtins.function(word).and_then(|(_, f)| {
                let overloads = self.builtins.overloads_of(f);
                overloads
                    .iter()
                    .find(|o| o.params() == types)
                    .map(|o| o.returns)
            }),
            (Meaning::Code("($1 * $2)", _), &[l, r]) => {
                self.binary_type(BinaryOp::Mul, l, r, false).ok()
            }
            (Meaning::Code(code, _) | Meaning::Nearly(code, ..), &[first, ..]) => {
                let keeps = !["tex", "int", "!", "($1 <"]
                    .iter()
                    .any(|p| code.starts_with(p));
                keeps.then_some(first)
            }
            _ => None,
        };
        found.unwrap_or(Type::ERROR)
    }

    /// Writes `code` in the place of every call of a function, or of those that stand in no other.
    fn rewrite_calls(&self, name: Name, code: &str, count: usize) -> Option<(String, Vec<Edit>)> {
        let calls = self
            .tree
            .exprs
            .iter()
            .enumerate()
            .filter_map(|(i, e)| match e.kind {
                ExprKind::Call(n, _) if n == name => Some(ExprId(i as u32)),
                _ => None,
            });
        let mut calls: Vec<ExprId> = calls.collect();
        calls.sort_by_key(|&id| self.tree.expr(id).extent.first);
        let nests = in_order(code, count);
        let (mut edits, mut title, mut passed) = (Vec::new(), None, 0);
        let mut number = 0;
        for id in calls {
            let extent = self.tree.expr(id).extent;
            if !nests && extent.first < passed {
                continue;
            }
            passed = passed.max(extent.last);
            let (text, more) = self.rewrite_call(id, code, count)?;
            title = title.or(Some(text));
            number += 1;
            edits.extend(more);
        }
        let title = title?;
        Some(match number {
            1 => (format!("write `{title}`"), edits),
            n => (format!("write `{title}`, and so in all {n} calls"), edits),
        })
    }

    /// Writes `code` in the place of a call, whose arguments stand for `$1`, `$2` and so on.
    fn rewrite_call(&self, id: ExprId, code: &str, count: usize) -> Option<(String, Vec<Edit>)> {
        let tree = self.tree;
        let ExprKind::Call(_, args) = tree.expr(id).kind else {
            return None;
        };
        let args = tree.args(args);
        let is_plain = self.is_direct(tree.expr(id).extent) || in_order(code, count);
        if args.len() != count || !is_plain {
            return None;
        }
        let mut text = String::new();
        let mut edits = Vec::new();
        let mut at = self.expr_span(id).start;
        let mut gap = String::new();
        let mut rest = code;
        while let Some((before, behind)) = rest.split_once('$') {
            let (number, behind) = behind.split_at_checked(1)?;
            let &arg = args.get(number.parse::<usize>().ok()?.checked_sub(1)?)?;
            let opens = before.ends_with(", ") || (before.len() > 1 && before.ends_with('('));
            let delimited = opens && behind.starts_with([',', ')']);
            let (open, close) = match delimited || self.binds_tightly(arg) {
                true => ("", ""),
                false => ("(", ")"),
            };
            let span = self.expr_span(arg);
            gap += before;
            gap += open;
            text += before;
            text += open;
            text += self.sources.text(span);
            text += close;
            if in_order(code, count) {
                edits.push(Edit::replace(
                    Span::new(at, span.start),
                    std::mem::take(&mut gap),
                ));
                gap += close;
                at = span.end;
            }
            rest = behind;
        }
        text += rest;
        gap += rest;
        let end = self.expr_span(id).end;
        let has_comment = |e: &Edit| self.sources.text(e.span).contains('/');
        if !in_order(code, count) {
            edits = vec![Edit::replace(self.expr_span(id), text.clone())];
        } else if edits.iter().any(has_comment) {
            return None;
        } else {
            edits.push(Edit::replace(Span::new(at, end), gap));
        }
        let title = text.lines().next().unwrap_or("").chars().take(60).collect();
        Some((title, edits))
    }

    /// Whether an expression can stand beside any operator without parentheses.
    pub(super) fn binds_tightly(&self, id: ExprId) -> bool {
        use ExprKind as E;
        let is_literal = matches!(
            self.tree.expr(id).kind,
            E::Int(_) | E::Uint(_) | E::Float(_) | E::Bool(_)
        );
        is_literal || self.is_atom(id)
    }
}

/// Whether a code names each of its arguments once, in their order.
fn in_order(code: &str, count: usize) -> bool {
    let numbers = code.split('$').skip(1).map(|p| p.get(..1).unwrap_or(""));
    numbers.eq((1..=count).map(|n| match n {
        1 => "1",
        2 => "2",
        3 => "3",
        _ => "4",
    }))
}

/// A code as a message shows it.
fn shown(code: &str) -> String {
    let names = ["a", "b", "c", "d"];
    let mut text = code.to_string();
    for (i, name) in names.iter().enumerate() {
        text = text.replace(&format!("${}", i + 1), name);
    }
    match text.strip_prefix('(').and_then(|t| t.strip_suffix(')')) {
        Some(inner) if !inner.starts_with('(') => inner.to_string(),
        _ => text,
    }
}
