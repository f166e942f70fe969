//! Messages for [`ArgumentError`]: calls that match no overload, with the nearest candidates.

use crate::messages::*;

/// Most candidates that a message lists.
const MAX_LISTED: usize = 5;

/// An overload that a call might mean.
pub(super) struct OverloadCandidate {
    pub params: Vec<Type>,
    /// Names of the parameters; empty for built-in functions, `""` for an unnamed one.
    pub names: Vec<String>,
    /// Whether each parameter is `out` or `inout`.
    pub writes: Vec<bool>,
    /// The signature as messages show it, without parameter names.
    shown: String,
    /// The name in its declaration; `None` for built-in functions.
    pub token: Option<TokenId>,
}

/// Cost of converting an argument to the type of a parameter; 0 where they are equal.
fn distance(expected: Type, found: Type, is_literal: bool) -> u32 {
    if expected == found {
        return 0;
    }
    match (expected.numeric(), found.numeric()) {
        (Some((ws, wc, wr)), Some((fs, fc, fr))) => {
            let shape = if (wc, wr) == (fc, fr) { 0 } else { 6 };
            let scalar = match (ws, fs) {
                (a, b) if a == b => 0,
                (Scalar::Bool, _) | (_, Scalar::Bool) => 8,
                (Scalar::Float, _) if is_literal => 1,
                _ => 3,
            };
            shape + scalar
        }
        _ => 20,
    }
}

impl Explain for ArgumentError {
    fn explain(self, c: &ExplainContext, _: Extent) -> Diagnostic {
        use ArgumentError as E;
        match self {
            E::Variable(id, name, variable, args) => {
                c.explain_call_of_variable(id, name, variable, args)
            }
            E::User(id, name, args) => c.explain_user_call(id, name, c.tree.args(args)),
            E::Builtin(id, name, function, args) => {
                c.explain_builtin_call(id, name, function, c.tree.args(args))
            }
            E::DynamicOffset(arg) => c.explain_dynamic_offset(arg),
            E::Offset(arg, offset) => c.explain_offset(arg, offset),
            E::Interpolant(arg, function) => {
                let message = format!("`{}` needs an input of the shader here", function.name());
                c.error_expr(error::ARGUMENT_MISMATCH, arg, message)
                    .note("its first argument must be an `in` variable or an element of one")
            }
        }
    }
}

impl ExplainContext<'_> {
    /// A call of a variable.
    pub(crate) fn explain_call_of_variable(
        &self,
        id: ExprId,
        name: Name,
        variable: VariableId,
        args: List,
    ) -> Diagnostic {
        let token = self.tree.expr(id).extent.first;
        let text = self.text(name);
        let d = self.error_at(
            error::NOT_A_FUNCTION,
            token,
            format!("`{text}` is a variable, not a function"),
        );
        let declared = self
            .variables
            .get(variable.0 as usize)
            .and_then(|v| v.token);
        let d = self.with_declaration(d, declared, "declared here");
        match self.functions_named(name).next().is_some() || self.builtins.function(text).is_some()
        {
            true => {
                let d = d.note("the variable shadows the function of the same name");
                match self.rename_variable(name) {
                    Some(fix) => d.fix(fix),
                    None => d.help("rename the variable"),
                }
            }
            false => {
                let product = self.product_of_call(token, variable, args);
                d.fix(product.or_else(|| self.index_of_call(token, variable, args)))
            }
        }
    }

    /// A call that matches none of the shader's functions of this name.
    pub(crate) fn explain_user_call(&self, id: ExprId, name: Name, args: &[ExprId]) -> Diagnostic {
        let candidates: Vec<OverloadCandidate> = self
            .functions_named(name)
            .map(|f| self.user_candidate(f))
            .collect();
        self.no_overload(id, name, args, &candidates)
    }

    fn user_candidate(&self, function: &Function) -> OverloadCandidate {
        let params: Vec<Type> = function.params.iter().map(|p| p.ty).collect();
        let list: Vec<String> = function
            .params
            .iter()
            .map(|p| match p.direction {
                Direction::In | Direction::ConstIn => self.name_of(p.ty),
                direction => format!("{} {}", direction.name(), self.name_of(p.ty)),
            })
            .collect();
        let returns = self.name_of(self.returns_of(function));
        let shown = format!(
            "{returns} {}({})",
            self.text(function.name),
            list.join(", ")
        );
        let declaration = self.tree.function(function.declaration);
        let names = declaration.map_or(&[][..], |f| self.tree.params(f.params));
        let names = names
            .iter()
            .map(|p| p.ident.map_or("", |i| self.text(i.name)).to_string());
        let token = declaration.map(|f| f.ident.token);
        OverloadCandidate {
            params,
            names: names.collect(),
            writes: function
                .params
                .iter()
                .map(|p| p.direction.writes())
                .collect(),
            shown,
            token,
        }
    }

    /// A call that matches no overload of a built-in function.
    pub(crate) fn explain_builtin_call(
        &self,
        id: ExprId,
        name: Name,
        function: BuiltinId,
        args: &[ExprId],
    ) -> Diagnostic {
        let (_, overloads) = self.builtins.overloads_of(function);
        let candidates: Vec<OverloadCandidate> = overloads
            .iter()
            .map(|o| {
                let list: Vec<String> = o.params().iter().map(|&p| self.name_of(p)).collect();
                let shown = format!(
                    "{} {}({})",
                    self.name_of(o.returns),
                    function.name(),
                    list.join(", ")
                );
                OverloadCandidate {
                    params: o.params().to_vec(),
                    names: Vec::new(),
                    writes: (0..o.params().len()).map(|i| o.writes(i)).collect(),
                    shown,
                    token: None,
                }
            })
            .collect();
        self.no_overload(id, name, args, &candidates)
    }

    fn no_overload(
        &self,
        id: ExprId,
        name: Name,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
    ) -> Diagnostic {
        if let Some(&arg) = args.iter().find(|&&a| self.ty(a).is_void()) {
            return self.explain_void(arg);
        }
        let same_count: Vec<&OverloadCandidate> = candidates
            .iter()
            .filter(|c| c.params.len() == args.len())
            .collect();
        if same_count.is_empty() {
            self.wrong_count(id, name, args, candidates)
        } else {
            self.wrong_types(id, name, args, &same_count, candidates)
        }
    }

    fn wrong_count(
        &self,
        id: ExprId,
        name: Name,
        args: &[ExprId],
        candidates: &[OverloadCandidate],
    ) -> Diagnostic {
        let text = self.text(name);
        let mut counts: Vec<usize> = candidates.iter().map(|c| c.params.len()).collect();
        counts.sort_unstable();
        counts.dedup();
        let expected = match counts.as_slice() {
            [1] => "1 argument".to_string(),
            [n] => format!("{n} arguments"),
            [rest @ .., last] => {
                let rest: Vec<String> = rest.iter().map(usize::to_string).collect();
                format!("{} or {last} arguments", rest.join(", "))
            }
            [] => "other arguments".to_string(),
        };
        let message = format!("`{text}` expects {expected}, found {}", args.len());
        let d = self.error_expr(error::ARGUMENT_MISMATCH, id, message);
        let joined = self.join_arguments(args, candidates);
        let d = match joined.or_else(|| self.drop_arguments(args, candidates)) {
            Some(fix) => d.fix(fix),
            None => self.missing_arguments(d, name, args, candidates),
        };
        self.list_candidates(d, candidates.iter())
    }

    fn list_candidates<'c>(
        &self,
        mut d: Diagnostic,
        candidates: impl ExactSizeIterator<Item = &'c OverloadCandidate>,
    ) -> Diagnostic {
        let count = candidates.len();
        for candidate in candidates.take(MAX_LISTED) {
            d = match candidate.token.filter(|&t| !self.is_prelude(t)) {
                Some(token) => d.label(self.token_span(token), format!("`{}`", candidate.shown)),
                None => d.note(format!("candidate: `{}`", candidate.shown)),
            };
        }
        if count > MAX_LISTED {
            d = d.note(format!("and {} more overloads", count - MAX_LISTED));
        }
        d
    }

    fn wrong_types(
        &self,
        id: ExprId,
        name: Name,
        args: &[ExprId],
        candidates: &[&OverloadCandidate],
        all: &[OverloadCandidate],
    ) -> Diagnostic {
        // Candidates that desktop GLSL would choose by its implicit conversions come first.
        let cost = |c: &OverloadCandidate| -> (bool, u32) {
            let pairs = || c.params.iter().zip(args);
            let is_implicit = pairs().all(|(&p, &a)| converts(p, self.ty(a)));
            let sum = pairs()
                .map(|(&p, &a)| distance(p, self.ty(a), self.literal_token(a).is_some()))
                .sum();
            (!is_implicit, sum)
        };
        let mut ranked: Vec<((bool, u32), &OverloadCandidate)> =
            candidates.iter().map(|c| (cost(c), *c)).collect();
        let size = |c: &OverloadCandidate| c.params.iter().map(|p| p.components()).sum::<u32>();
        ranked.sort_by_key(|(cost, c)| (*cost, std::cmp::Reverse(size(c))));
        let Some(&(best_cost, best)) = ranked.first() else {
            return self.error_expr(error::ARGUMENT_MISMATCH, id, "no matching overload");
        };
        let is_alone = ranked.get(1).is_none_or(|(cost, _)| *cost > best_cost);
        let wrong: Vec<(usize, ExprId, Type)> = args
            .iter()
            .zip(&best.params)
            .enumerate()
            .filter(|(_, (a, p))| self.ty(**a) != **p)
            .map(|(i, (a, p))| (i, *a, *p))
            .collect();
        let mixed = wrong.iter().all(|(_, a, p)| is_mix(*p, self.ty(*a)));
        let d = if mixed && is_alone {
            self.mixed_arguments(name, &wrong)
        } else if let (&[(index, arg, expected)], true) = (wrong.as_slice(), is_alone) {
            self.wrong_argument(name, index, arg, expected)
        } else {
            self.no_form(id, name, args)
        };
        let fix = self.swap_arguments(args, candidates);
        let fix = fix.or_else(|| self.fewer_arguments(args, all, d.fix.is_none()));
        let d = match (fix, &d.fix) {
            (Some(fix), _) => d.fix(fix),
            (None, None) => {
                let fixed_call = ranked.iter().find_map(|(_, c)| self.fix_arguments(args, c));
                d.fix(fixed_call)
            }
            _ => d,
        };
        self.list_candidates(
            d,
            ranked
                .iter()
                .take(if is_alone { 1 } else { MAX_PARAMS })
                .map(|(_, c)| *c)
                .collect::<Vec<_>>()
                .into_iter(),
        )
    }

    /// Arguments that only mix up `int` and `float`.
    fn mixed_arguments(&self, name: Name, wrong: &[(usize, ExprId, Type)]) -> Diagnostic {
        let text = self.text(name);
        let Some(&(_, first, expected)) = wrong.first() else {
            return self.error_expr(error::INT_FLOAT_MIX, ExprId(0), "");
        };
        let found = self.ty(first);
        let is_builtin = self.builtins.function(text).is_some();
        let rule = match found.numeric() {
            Some((Scalar::Int | Scalar::Uint, 1, 2..)) if is_builtin => error::INTEGER_LENGTH,
            _ => error::INT_FLOAT_MIX,
        };
        let (wn, fname) = (self.name_of(expected), self.name_of(found));
        let message = match rule {
            error::INTEGER_LENGTH => format!("no overload of `{text}` accepts `{fname}`"),
            _ => format!("`{text}` expects `{wn}`, found `{fname}`"),
        };
        let mut d = self
            .error_expr(rule, first, message)
            .mark(format!("`{fname}`"));
        let mut edits = Vec::new();
        let mut titles = Vec::new();
        let mut safe = true;
        for &(_, arg, expected) in wrong {
            let fix = expected.scalar_kind().and_then(|s| self.convert(arg, s));
            let Some(fix) = fix else { return d };
            safe &= fix.applicability == shaderlint_diagnostic::Applicability::Safe;
            titles.push(fix.title);
            edits.extend(fix.edits);
            if arg != first {
                d = d.label(
                    self.expr_span(arg),
                    format!("`{}`", self.name_of(self.ty(arg))),
                );
            }
        }
        let title = joined_title(&titles);
        d.fix(if safe {
            Fix::safe(title, edits)
        } else {
            Fix::suggestion(title, edits)
        })
    }

    /// One argument of another type than the parameter.
    fn wrong_argument(&self, name: Name, index: usize, arg: ExprId, expected: Type) -> Diagnostic {
        let text = self.text(name);
        let found = self.ty(arg);
        let rule = match (expected.scalar_kind(), found.scalar_kind()) {
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::ARGUMENT_MISMATCH,
        };
        let message = format!(
            "expected `{}` as argument {} of `{text}`, found `{}`",
            self.name_of(expected),
            index + 1,
            self.name_of(found)
        );
        self.error_expr(rule, arg, message)
            .fix(self.become_type(arg, expected))
    }

    /// `not (a > b)` on a single `bool`, as in other languages.
    fn negation(&self, id: ExprId, text: &str, args: &[ExprId]) -> Option<Fix> {
        let is_not = self.builtins.function(text) == Some(BuiltinId::Not);
        let is_one = is_not && matches!(args, [one] if self.ty(*one) == Type::BOOL);
        let word = self.tree.expr(id).extent.first;
        (is_one && self.token(word).is_direct()).then(|| {
            let before_argument = self.token_span(word + 1).start;
            let span = Span::new(self.token_span(word).start, before_argument);
            Fix::suggested_replacement(span, "!")
        })
    }

    fn no_form(&self, id: ExprId, name: Name, args: &[ExprId]) -> Diagnostic {
        let text = self.text(name);
        let types: Vec<String> = args.iter().map(|&a| self.name_of(self.ty(a))).collect();
        let scalars: Vec<Option<Scalar>> = args.iter().map(|&a| self.ty(a).scalar_kind()).collect();
        let vectors = args
            .iter()
            .all(|&a| self.ty(a).numeric().is_some_and(|(_, c, _)| c == 1));
        let same_scalar = scalars.windows(2).all(|w| w.first() == w.last());
        let rule = if vectors
            && same_scalar
            && scalars.first() == Some(&Some(Scalar::Float))
            && args.len() > 1
        {
            error::VECTOR_SIZE
        } else {
            error::ARGUMENT_MISMATCH
        };
        let list = match types.as_slice() {
            [one] => one.clone(),
            all => format!("({})", all.join(", ")),
        };
        let message = format!("no overload of `{text}` accepts `{list}`");
        let mut d = self.error_expr(rule, id, message);
        for (&arg, ty) in args.iter().zip(&types) {
            d = d.label(self.expr_span(arg), format!("`{ty}`"));
        }
        d.fix(self.negation(id, text, args))
    }

    /// `a(0)` instead of `a[0]`.
    fn index_of_call(&self, token: TokenId, variable: VariableId, args: List) -> Option<Fix> {
        let &[arg] = self.tree.args(args) else {
            return None;
        };
        let ty = self.variables.get(variable.0 as usize)?.ty;
        let has_elements = ty.is_array() || ty.is_matrix() || ty.is_vector();
        let is_index = matches!(self.ty(arg), Type::INT | Type::UINT);
        (has_elements && is_index)
            .then(|| self.other_brackets(token + 1, TokenKind::LeftParen, ("[", "]")))
            .flatten()
    }

    /// `a (b + c)` without the `*`.
    fn product_of_call(&self, token: TokenId, variable: VariableId, args: List) -> Option<Fix> {
        let &[arg] = self.tree.args(args) else {
            return None;
        };
        let ty = self.variables.get(variable.0 as usize)?.ty;
        typing::binary(self.types(), BinaryOp::Mul, ty, self.ty(arg)).ok()?;
        let edit = Edit::insert(self.token_span(token).end, " * ");
        Some(Fix::suggestion("add `*` to multiply", vec![edit]))
    }
}

/// Whether desktop GLSL converts one type to another implicitly: integers to floats and to `uint`.
fn converts(expected: Type, found: Type) -> bool {
    let is_wider = match (expected.scalar_kind(), found.scalar_kind()) {
        (Some(Scalar::Float), Some(Scalar::Int | Scalar::Uint)) => true,
        (expected, found) => (expected, found) == (Some(Scalar::Uint), Some(Scalar::Int)),
    };
    expected == found || is_wider && is_mix(expected, found)
}

/// Whether two types differ only in `int`, `uint` and `float`.
fn is_mix(expected: Type, found: Type) -> bool {
    match (expected.numeric(), found.numeric()) {
        (Some((ws, wc, wr)), Some((fs, fc, fr))) => {
            (wc, wr) == (fc, fr) && ws != fs && ws != Scalar::Bool && fs != Scalar::Bool
        }
        _ => false,
    }
}
