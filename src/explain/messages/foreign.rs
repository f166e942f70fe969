//! Messages for [`ForeignError`]: names of other languages and their GLSL equivalents.

use super::*;
use shaderlint_syntax::{Foreign, Meaning, foreign};

impl Explain for ForeignError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use ForeignError as E;
        let token = at.first;
        let word = |name| foreign(c.text(name), c.version);
        match self {
            E::Absent(name) => match word(name).map(|f| f.meaning) {
                Some(Meaning::Absent(why)) => {
                    c.explain_absent(error::UNKNOWN_TYPE, name, token, why)
                }
                _ => c.explain_unknown_type(name, token),
            },
            E::Type(name) => c.explain_foreign_type(name, token, word(name), ""),
            E::Uniform(name) => c.explain_foreign_type(name, token, word(name), "uniform "),
            E::Inferred(from, found) => c.explain_inferred_type(token, from, found),
            E::Call(id, name, args) => {
                let types: Vec<Type> = c.tree.args(args).iter().map(|&a| c.ty(a)).collect();
                let known = word(name).and_then(|f| c.explain_foreign_call(id, name, f, &types));
                known.unwrap_or_else(|| c.explain_undeclared_function(name, token))
            }
        }
    }
}

impl ExplainContext<'_> {
    /// A type that has another name in GLSL; the fix writes `before` and that name.
    fn explain_foreign_type(
        &self,
        name: Name,
        token: TokenId,
        found: Option<Foreign>,
        before: &str,
    ) -> Diagnostic {
        let Some((found, word)) = found.and_then(|f| match f.meaning {
            Meaning::Type(word) => Some((f, word)),
            _ => None,
        }) else {
            return self.explain_unknown_type(name, token);
        };
        let d = self.foreign_error(error::UNKNOWN_TYPE, token, found, "type", word);
        self.rename_fix(d, name, &format!("{before}{word}"))
    }

    /// A name without a GLSL equivalent.
    pub(crate) fn explain_absent(
        &self,
        rule: ErrorKind,
        name: Name,
        token: TokenId,
        why: &'static str,
    ) -> Diagnostic {
        let message = format!("GLSL has no `{}`", self.text(name));
        self.error_at(rule, token, message).note(why)
    }

    /// `var`, `let` or `auto` at `token`; the fix replaces the tokens from `from` to it with the
    /// type of the value.
    pub(crate) fn explain_inferred_type(
        &self,
        token: TokenId,
        from: TokenId,
        found: Type,
    ) -> Diagnostic {
        let word = self.text(Name(self.token(token).value));
        let message = format!("`{word}` is not a type; GLSL has no type inference");
        let d = self.error_at(error::UNKNOWN_TYPE, token, message);
        if found.is_error() {
            return d.help("use an explicit type: `float`, `vec3`, ...");
        }
        let name = self.name_of(found);
        let span = self.token_span(from).to(self.token_span(token));
        d.fix(Fix::safe_replacement(span, name))
    }

    /// A call of a function that GLSL has in another form; `None` if the name is not a function.
    pub(crate) fn explain_foreign_call(
        &self,
        id: ExprId,
        name: Name,
        found: Foreign,
        types: &[Type],
    ) -> Option<Diagnostic> {
        let token = self.tree.expr(id).extent.first;
        let error =
            |has: &str| self.foreign_error(error::UNDECLARED_NAME, token, found, "function", has);
        match found.meaning {
            Meaning::Function(word) => Some(self.rename_fix(error(word), name, word)),
            Meaning::Code(code, count) => {
                let fix = self.rewrite_calls(name, code, count);
                Some(error(&shown(code)).fix(fix.map(|(t, e)| Fix::safe(t, e))))
            }
            Meaning::Nearly(code, count, why) => {
                let d = error(&shown(code)).note(why);
                let fix = self.rewrite_calls(name, code, count);
                Some(d.fix(fix.map(|(t, e)| Fix::suggestion(t, e))))
            }
            Meaning::Statement(code, count) => {
                let fix = self
                    .remove_statement(token)
                    .filter(|_| types.first() == Some(&Type::FLOAT));
                let edits = fix.and_then(|_| self.rewrite_call(id, code, count));
                let fix = edits.map(|(text, edits)| Fix::safe(format!("use `{text}`"), edits));
                Some(error(&shown(code)).fix(fix))
            }
            _ => self.foreign_value(name, token),
        }
    }

    fn foreign_error(
        &self,
        rule: ErrorKind,
        token: TokenId,
        found: Foreign,
        what: &str,
        has: &str,
    ) -> Diagnostic {
        let text = self.text(Name(self.token(token).value));
        let message = format!("`{text}` is not a GLSL {what}; use `{has}`");
        let origin = match found.language {
            "HLSL" => format!("an HLSL {what}"),
            described if described.contains(' ') => format!("a {what} of {described}"),
            name => format!("a {name} {what}"),
        };
        self.error_at(rule, token, message)
            .note(format!("`{text}` is {origin}"))
    }

    /// Replaces every use of a name with `to`.
    pub(super) fn rename_fix(&self, d: Diagnostic, name: Name, to: &str) -> Diagnostic {
        let edits = self.rename_all(name, to);
        match edits.len() {
            0 => d.help(format!("use `{to}`")),
            1 => d.fix(Fix::safe(format!("use `{to}`"), edits)),
            n => d.fix(Fix::safe(
                format!("replace all {n} uses with `{to}`"),
                edits,
            )),
        }
    }

    /// The message for an undeclared name that is a value in other languages.
    pub(super) fn foreign_value(&self, name: Name, token: TokenId) -> Option<Diagnostic> {
        let text = self.text(name);
        let found = foreign(text, self.version)?;
        match found.meaning {
            _ if self
                .nearest_name(text, false)
                .is_some_and(|n| n.eq_ignore_ascii_case(text)) =>
            {
                None
            }
            Meaning::Value(value) => {
                let d = self.foreign_error(error::UNDECLARED_NAME, token, found, "constant", value);
                Some(self.rename_fix(d, name, value))
            }
            Meaning::Zero => Some(self.foreign_zero(name, token)),
            Meaning::Namespace => {
                let message = format!("GLSL has no namespace `{text}`; functions have no prefix");
                let d = self.error_at(error::UNDECLARED_NAME, token, message);
                let edits = self.unqualify(name);
                let fix =
                    (!edits.is_empty()).then(|| Fix::safe(format!("remove `{text}.`"), edits));
                Some(d.fix(fix))
            }
            Meaning::Silent => {
                let message = format!("GLSL has no `{text}`; shaders cannot print");
                let d = self
                    .error_at(error::UNDECLARED_NAME, token, message)
                    .note("to inspect a value, write it to the output as a colour");
                Some(d.fix(self.remove_statement(token)))
            }
            Meaning::Absent(why) => {
                Some(self.explain_absent(error::UNDECLARED_NAME, name, token, why))
            }
            _ => None,
        }
    }

    /// `null`, `None` and the like.
    fn foreign_zero(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let d = self
            .error_at(
                error::UNDECLARED_NAME,
                token,
                format!("GLSL has no `{text}`"),
            )
            .note("every variable holds a value of its type");
        let expected = self.expected.or_else(|| {
            let before = self.tree.exprs.get(self.exprs.len().checked_sub(1)?)?;
            let ty = self.exprs.last()?.ty;
            let assigns = self.token(before.extent.last + 1).kind == TokenKind::Equal;
            (assigns && before.extent.last + 2 == token).then_some(ty)
        });
        match expected.and_then(|ty| ty.zero()) {
            Some(zero) => d.fix(Fix::suggested_replacement(self.token_span(token), zero)),
            None => d,
        }
    }

    /// Edits that remove a namespace before names that GLSL has or has an equivalent for.
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

    /// Removes the statement that starts at `token`, if one does.
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
            .then(|| Fix::suggestion("remove the statement", vec![edit]))
    }

    /// Replaces every call of a function with `code`; where calls nest, only the outermost.
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
            1 => (format!("use `{title}`"), edits),
            n => (
                format!("rewrite all {n} calls, the first as `{title}`"),
                edits,
            ),
        })
    }

    /// Replaces a call with `code`, in which `$1`, `$2` and so on are its arguments.
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
        while let Some((before, after)) = rest.split_once('$') {
            let (number, after) = after.split_at_checked(1)?;
            let &arg = args.get(number.parse::<usize>().ok()?.checked_sub(1)?)?;
            let opens = before.ends_with(", ") || (before.len() > 1 && before.ends_with('('));
            let delimited = opens && after.starts_with([',', ')']);
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
            rest = after;
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
}

/// Whether `code` uses each argument exactly once and in order.
fn in_order(code: &str, count: usize) -> bool {
    let numbers = code.split('$').skip(1).map(|p| p.get(..1).unwrap_or(""));
    numbers.eq((1..=count).map(|n| match n {
        1 => "1",
        2 => "2",
        3 => "3",
        _ => "4",
    }))
}

/// `code` as messages show it: with `a`, `b`, ... for the arguments.
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
