//! Fixes for calls with too few, too many or swapped arguments.

use super::call::OverloadCandidate;
use crate::messages::*;

/// The usual value of a built-in function's parameter, by its index, to insert where it is missing.
#[rustfmt::skip]
const USUAL: &[(BuiltinId, usize, &str)] = &[
    (BuiltinId::Max, 1, "0.0"), (BuiltinId::Min, 1, "1.0"), (BuiltinId::Pow, 1, "2.0"),
    (BuiltinId::Mod, 1, "1.0"), (BuiltinId::Mix, 2, "0.5"), (BuiltinId::Clamp, 1, "0.0"),
    (BuiltinId::Clamp, 2, "1.0"), (BuiltinId::Smoothstep, 0, "0.0"),
    (BuiltinId::Smoothstep, 1, "1.0"), (BuiltinId::Step, 0, "0.5"),
    (BuiltinId::Refract, 2, "0.66"), (BuiltinId::TextureLod, 2, "0.0"),
    (BuiltinId::TexelFetch, 2, "0"), (BuiltinId::TextureSize, 1, "0"),
];

/// Most arguments for which other orders are tried.
const MAX_SWAPPED: usize = 4;

impl ExplainContext<'_> {
    /// Removes surplus arguments so that the rest match a candidate.
    pub(super) fn drop_arguments(
        &self,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
    ) -> Option<Fix> {
        let mut found = None;
        for candidate in candidates {
            let Some(extra) = args.len().checked_sub(candidate.params.len()) else {
                continue;
            };
            for first in (0..=candidate.params.len()).rev().filter(|_| extra > 0) {
                let kept = args
                    .iter()
                    .take(first)
                    .chain(args.iter().skip(first + extra));
                if kept
                    .map(|&a| self.ty(a))
                    .eq(candidate.params.iter().copied())
                {
                    found = Some((first, extra));
                }
            }
        }
        let (first, extra) = found?;
        let removed = args.get(first..first + extra)?;
        let (start, end) = (
            self.expr_span(*removed.first()?),
            self.expr_span(*removed.last()?),
        );
        let span = match (args.get(first + extra), first.checked_sub(1)) {
            (Some(&next), _) => Span::new(start.start, self.expr_span(next).start),
            (None, Some(before)) => Span::new(self.expr_span(*args.get(before)?).end, end.end),
            (None, None) => start.to(end),
        };
        Some(self.without(start.to(end), span))
    }

    /// Removes extra arguments with what separates them from the others.
    pub(super) fn without(&self, arguments: Span, whole: Span) -> Fix {
        let text = self.sources.text(arguments);
        let title = match text.len() < 40 && !text.contains('\n') {
            true => format!("remove `{text}`"),
            false => "remove the extra arguments".to_string(),
        };
        Fix::suggestion(title, vec![Edit::delete(whole)])
    }

    /// Removes arguments to match an overload with fewer, if one is a `bool` or nothing else helps.
    pub(super) fn fewer_arguments(
        &self,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
        is_last_resort: bool,
    ) -> Option<Fix> {
        let has_bool = args.iter().any(|&a| self.ty(a) == Type::BOOL);
        (is_last_resort || has_bool)
            .then(|| self.drop_arguments(args, candidates))
            .flatten()
    }

    /// Names the missing arguments, with a fix that inserts values for them. Where several
    /// positions are possible, arguments named like parameters decide, then the last position wins.
    pub(super) fn missing_arguments(
        &self,
        d: Diagnostic,
        name: Name,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
    ) -> Diagnostic {
        let mut best: Option<(usize, usize, &OverloadCandidate, usize)> = None;
        for candidate in candidates {
            let Some(missing) = candidate.params.len().checked_sub(args.len()) else {
                continue;
            };
            for first in (0..=args.len()).filter(|_| missing > 0) {
                let left = candidate.params.iter().enumerate();
                let mut pairs = left
                    .filter(|(i, _)| *i < first || *i >= first + missing)
                    .zip(args);
                let Some(named) = pairs.try_fold(0, |n, ((i, &ty), &arg)| {
                    let same = candidate
                        .names
                        .get(i)
                        .is_some_and(|p| *p == self.expr_text(arg));
                    (self.ty(arg) == ty).then_some(n + same as usize)
                }) else {
                    continue;
                };
                let is_better = best.is_none_or(|(n, _, c, _)| {
                    let (have, other) = (candidate.params.len(), c.params.len());
                    let is_same = std::ptr::eq(candidate, c);
                    have < other || (have == other && (named > n || (is_same && named == n)))
                });
                if is_better {
                    best = Some((named, first, candidate, missing));
                }
            }
        }
        let Some((_, first, candidate, missing)) = best else {
            return d;
        };
        let what = |i: usize| match candidate.names.get(i).filter(|n| !n.is_empty()) {
            Some(param) => {
                let ty = candidate.params.get(i).copied().unwrap_or(Type::ERROR);
                format!("`{} {param}`", self.name_of(ty))
            }
            None => format!("argument {}", i + 1),
        };
        let names: Vec<String> = (first..first + missing).map(what).collect();
        let d = d.note(format!("missing {}", names.join(" and ")));
        let values: Option<Vec<String>> = (first..first + missing)
            .map(|i| self.value_for(name, candidate, i, args))
            .collect();
        let Some(values) = values.map(|v| v.join(", ")) else {
            return d;
        };
        let edit = match (args.get(first), args.last()) {
            (Some(&next), _) => Edit::insert(self.expr_span(next).start, format!("{values}, ")),
            (None, Some(&last)) => Edit::insert(self.expr_span(last).end, format!(", {values}")),
            (None, None) => return d,
        };
        d.fix(Fix::suggestion(format!("add `{values}`"), vec![edit]))
    }

    /// A value to pass for a parameter: a variable of its name, the usual value, or 0.
    fn value_for(
        &self,
        name: Name,
        candidate: &OverloadCandidate,
        index: usize,
        args: &[ExprId],
    ) -> Option<String> {
        let &ty = candidate.params.get(index)?;
        let writes = candidate.writes.get(index).copied().unwrap_or(false);
        let fits = |v: &Variable| v.ty == ty && (!writes || self.is_writable(v));
        let param = candidate.names.get(index).map_or("", |n| n.as_str());
        let variables = || {
            self.scopes()
                .visible()
                .filter_map(|(_, binding)| match binding {
                    Binding::Variable(id) => {
                        let found = self.variables.get(id.0 as usize).filter(|v| fits(v));
                        found.filter(|v| v.storage == Storage::Uniform || !self.is_host_name(v))
                    }
                    _ => None,
                })
        };
        if let Some(same) = variables().find(|v| self.text(v.name) == param) {
            return Some(self.text(same.name).to_string());
        }
        let is_given = |v: &&Variable| args.iter().any(|&a| self.expr_text(a) == self.text(v.name));
        let text = self.text(name);
        let function = self.builtins.function(text);
        let usual = USUAL
            .iter()
            .find(|(f, i, _)| Some(*f) == function && *i == index);
        if let (Some((_, _, value)), false) = (usual, writes) {
            return Some(match ty.is_scalar() {
                true => value.to_string(),
                false => format!("{}({value})", self.name_of(ty)),
            });
        }
        match ty.zero() {
            Some(zero) if !writes && candidate.token.is_some() => Some(zero),
            zero => {
                let others = variables().filter(|v| !is_given(v) && v.token.is_some());
                let found = others.last().or_else(|| variables().last());
                found
                    .map(|v| self.text(v.name).to_string())
                    .or(zero.filter(|_| !writes))
            }
        }
    }

    /// Whether a variable is declared in the host's own code.
    fn is_host_name(&self, variable: &Variable) -> bool {
        variable.token.is_some_and(|token| self.is_prelude(token))
    }

    /// Whether a variable can be passed for an `out` parameter.
    pub(super) fn is_writable(&self, variable: &Variable) -> bool {
        !variable.is_const
            && !matches!(
                variable.storage,
                Storage::Uniform | Storage::Input | Storage::Param(Direction::ConstIn)
            )
    }

    /// `f(h, s, v)` for a function of a vector: the arguments are its components.
    pub(super) fn join_arguments(
        &self,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
    ) -> Option<Fix> {
        let [candidate] = candidates else { return None };
        let mut rest = args;
        let mut edits = Vec::new();
        let mut title = String::new();
        for &param in &candidate.params {
            let (&first, _) = rest.split_first()?;
            let count = if self.ty(first) == param {
                1
            } else {
                param.components() as usize
            };
            let (own, others) = rest.split_at_checked(count)?;
            rest = others;
            if count == 1 {
                continue;
            }
            let scalar = Type::scalar(param.scalar_kind().filter(|_| param.is_vector())?);
            if own.iter().any(|&arg| self.ty(arg) != scalar) {
                return None;
            }
            let all = self.expr_span(first).to(self.expr_span(*own.last()?));
            let open = format!("{}(", self.name_of(param));
            title = format!("use `{open}{})`", self.sources.text(all));
            edits.push(Edit::insert(all.start, open));
            edits.push(Edit::insert(all.end, ")"));
        }
        let is_direct = args
            .iter()
            .all(|&arg| self.is_direct(self.tree.expr(arg).extent));
        (rest.is_empty() && is_direct && !edits.is_empty()).then(|| Fix::suggestion(title, edits))
    }

    /// Swaps two arguments where the swapped order matches a candidate.
    pub(super) fn swap_arguments(
        &self,
        args: &[ExprId],
        candidates: &[&OverloadCandidate],
    ) -> Option<Fix> {
        if args.len() > MAX_SWAPPED {
            return None;
        }
        for (i, &a) in args.iter().enumerate() {
            for (j, &b) in args.iter().enumerate().skip(i + 1) {
                let mut types: Vec<Type> = args.iter().map(|&a| self.ty(a)).collect();
                types.swap(i, j);
                if self.ty(a) == self.ty(b) || !candidates.iter().any(|c| c.params == types) {
                    continue;
                }
                let (a, b) = (self.expr_span(a), self.expr_span(b));
                let edits = vec![
                    Edit::replace(a, self.sources.text(b)),
                    Edit::replace(b, self.sources.text(a)),
                ];
                return Some(Fix::suggestion("swap the two arguments", edits));
            }
        }
        None
    }

    /// Converts every argument that does not match the candidate.
    pub(super) fn fix_arguments(
        &self,
        args: &[ExprId],
        candidate: &OverloadCandidate,
    ) -> Option<Fix> {
        let mut edits = Vec::new();
        let mut titles = Vec::new();
        for (&arg, &expected) in args.iter().zip(&candidate.params) {
            if self.ty(arg) == expected {
                continue;
            }
            let fix = self.become_type(arg, expected)?;
            titles.push(fix.title);
            edits.extend(fix.edits);
        }
        Some(Fix::suggestion(joined_title(&titles), edits))
    }
}

/// One title for several fixes: the verb that all begin with is written once.
pub(in crate::messages) fn joined_title(titles: &[String]) -> String {
    let verb = |title: &str| title.split_inclusive(' ').next().map_or(0, str::len);
    let mut joined = String::new();
    let mut before = "";
    for (i, title) in titles.iter().enumerate() {
        let (word, rest) = title.split_at(verb(title));
        let after = match i {
            0 => "",
            _ if i + 1 == titles.len() => " and ",
            _ => ", ",
        };
        joined.push_str(after);
        joined.push_str(if word == before { rest } else { title });
        before = word;
    }
    joined
}
