//! Jumps and loops that go nowhere, what `return` gives, and what conditions are.

use super::*;

impl Condition {
    fn words(self) -> &'static str {
        match self {
            Condition::Choice => "the condition of `? :`",
            Condition::If => "the condition of `if`",
            Condition::For => "the condition of the loop",
            Condition::While => "the condition of `while`",
        }
    }
}

impl Explain for StatementError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use StatementError as E;
        let misplaced = |message| c.error(error::MISPLACED_JUMP, at, message);
        match self {
            E::Break => misplaced("`break` can only stand in a loop or `switch`"),
            E::Continue => misplaced("`continue` can only stand in a loop"),
            E::Discard => misplaced("`discard` can only stand in a fragment shader"),
            E::Condition(of, ty) => {
                let what = of.words();
                let message = format!("{what} must be `bool`, not `{}`", c.name_of(ty));
                c.error(error::CONDITION_TYPE, at, message)
            }
            E::NoCondition(id, of, ty) => c.explain_condition(id, ty, of),
            E::Return(value, misfit) => c.explain_return(value, at, misfit),
            E::Endless(variable) => c.endless_loop(variable, at),
        }
    }
}

impl ExplainContext<'_> {
    fn endless_loop(&self, variable: Option<VariableId>, at: Extent) -> Diagnostic {
        let d = self
            .error(error::INFINITE_LOOP, at, "this loop never ends")
            .note("browsers refuse a loop whose condition is always true and that has no `break` or `return`");
        match variable.and_then(|v| self.variables.get(v.0 as usize)) {
            Some(v) => {
                let name = self.text(v.name);
                let d = self.with_declaration(d, v.token, "true from the start, and never changed");
                d.help(format!(
                    "set `{name}` to false somewhere, or give the loop a bound"
                ))
            }
            None => d.help("give it a bound: `for (int i = 0; i < 100; i++)`"),
        }
    }

    /// A `return` that does not give what the function does.
    pub(crate) fn explain_return(
        &self,
        value: Option<ExprId>,
        extent: Extent,
        misfit: Misfit,
    ) -> Diagnostic {
        match (misfit, value) {
            (Misfit::ValueReturned, Some(value)) => self.return_of_void(value, extent),
            (Misfit::Returned(wanted), Some(value)) => self.return_misfit(value, wanted, extent),
            (Misfit::NothingReturned(wanted), _) => self.return_of_nothing(wanted, extent),
            (_, value) => self.explain_void(value.unwrap_or(self.whole)),
        }
    }

    fn return_of_nothing(&self, wanted: Type, extent: Extent) -> Diagnostic {
        let name = self.name_of(wanted);
        let d = self.error(
            error::RETURN_TYPE,
            extent,
            format!("this `return` gives nothing, but the function is `{name}`"),
        );
        let zero = self.zero_of(wanted);
        let place = self.token_span(extent.first);
        d.fix(zero.filter(|_| self.is_direct(extent)).map(|zero| {
            let edit = Edit::insert(place.end, format!(" {zero}"));
            Fix::suggestion(format!("return `{zero}`"), vec![edit])
        }))
    }

    fn return_of_void(&self, value: ExprId, extent: Extent) -> Diagnostic {
        let name = self.name_of(self.ty(value));
        let d = self.error(
            error::RETURN_TYPE,
            extent,
            format!("a `void` function cannot return a value (this is `{name}`)"),
        );
        let d = self.label_return_type(d);
        let span = Span::new(self.token_span(extent.first).end, self.expr_span(value).end);
        let edits = match self.ty(value).is_void() {
            true => {
                let start = self.token_span(extent.first).start;
                let (call, end) = (self.expr_text(value), self.expr_span(value).end);
                vec![Edit::replace(
                    Span::new(start, end),
                    format!("{call}; return"),
                )]
            }
            false => vec![Edit::delete(span)],
        };
        let title = match self.ty(value).is_void() {
            true => "call it, then return",
            false => "return nothing",
        };
        let fix = self
            .is_direct(extent)
            .then(|| Fix::suggestion(title, edits));
        d.fix(fix)
    }

    fn return_misfit(&self, value: ExprId, wanted: Type, extent: Extent) -> Diagnostic {
        let found = self.ty(value);
        let numbers = |t: Type| t.scalar_kind().filter(|s| *s != Scalar::Bool);
        let rule = match (numbers(wanted), numbers(found)) {
            (Some(a), Some(b)) if a != b && wanted.components() == found.components() => {
                error::INT_FLOAT_MIX
            }
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::RETURN_TYPE,
        };
        let mut d = self.misfit_at(extent, wanted, value, rule);
        d.message = format!(
            "the function returns `{}`, but this is `{}`",
            self.name_of(wanted),
            self.name_of(found)
        );
        self.label_return_type(d)
    }

    fn label_return_type(&self, d: Diagnostic) -> Diagnostic {
        let function = self.current.and_then(|f| self.functions.get(f.0 as usize));
        let decl = function.and_then(|f| self.tree.function(f.definition?));
        match decl.filter(|f| !self.is_prelude(f.ident.token)) {
            Some(decl) => d.label(self.span(self.tree.ty(decl.ty).extent), "the return type"),
            None => d,
        }
    }

    /// A condition that is no `bool`.
    pub(crate) fn explain_condition(&self, id: ExprId, ty: Type, of: Condition) -> Diagnostic {
        let (what, name) = (of.words(), self.name_of(ty));
        let d = self
            .error_expr(
                error::CONDITION_TYPE,
                id,
                format!("{what} must be `bool`, not `{name}`"),
            )
            .note("a number does not count as true or false here");
        let zero = match ty {
            Type::INT => "0",
            Type::UINT => "0u",
            Type::FLOAT => "0.0",
            _ => "",
        };
        let is_assignment = matches!(
            self.tree.expr(self.tree.unparen(id)).kind,
            ExprKind::Assign(None, ..)
        );
        if is_assignment {
            d.note("`=` assigns; `==` compares")
                .fix(self.compare_instead(id))
        } else if !zero.is_empty() && self.is_direct(self.tree.expr(id).extent) {
            let span = self.expr_span(id);
            let atom = self.is_atom(id);
            let mut edits = vec![Edit::insert(
                span.end,
                format!("{} != {zero}", if atom { "" } else { ")" }),
            )];
            if !atom {
                edits.insert(0, Edit::insert(span.start, "("));
            }
            d.fix(Fix::safe(format!("compare with `{zero}`"), edits))
        } else if ty.scalar_kind() == Some(Scalar::Bool) {
            let fix = Fix::suggestion("true where all are: `all(...)`", self.wrap(id, "all(", ")"));
            d.note("`any(...)` is true where one is").fix(fix)
        } else if let Some(zero) = self.zero_of(ty).filter(|_| ty.is_vector()) {
            let edits = self.wrap(id, "any(notEqual(", &format!(", {zero}))"));
            d.fix(Fix::suggestion("true where one is not 0", edits))
        } else {
            d
        }
    }
}
