//! Messages for [`StatementError`].

use super::*;

/// The message for a condition of type `found`.
fn condition_message(of: Condition, found: &str) -> String {
    let of = match of {
        Condition::Choice => "`? :`",
        Condition::If => "`if`",
        Condition::For => "`for`",
        Condition::While => "`while`",
    };
    format!("{of} condition must be `bool`, found `{found}`")
}

impl Explain for StatementError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use StatementError as E;
        let misplaced = |message| c.error(error::MISPLACED_JUMP, at, message);
        // Its `;` stays, which may be all there is after an `if`.
        let word = || {
            let edits = vec![Edit::delete(c.token_span(at.first))];
            Fix::suggestion("remove it", edits)
        };
        match self {
            E::Break => misplaced("`break` outside of a loop or `switch`").fix(word()),
            E::Continue => misplaced("`continue` outside of a loop").fix(word()),
            E::Discard => misplaced("`discard` outside of a fragment shader"),
            E::Condition(of, ty) => {
                let message = condition_message(of, &c.name_of(ty));
                c.error(error::CONDITION_TYPE, at, message)
            }
            E::NoCondition(id, of, ty) => c.explain_condition(id, ty, of),
            E::Return(value, mismatch) => c.explain_return(value, at, mismatch),
            E::Endless(variable) => c.endless_loop(variable, at),
        }
    }
}

impl ExplainContext<'_> {
    fn endless_loop(&self, variable: Option<VariableId>, at: Extent) -> Diagnostic {
        let d = self
            .error(error::INFINITE_LOOP, at, "this loop never terminates")
            .note(
                "browsers reject a loop with an always-true condition and no `break` or `return`",
            );
        match variable.and_then(|v| self.variables.get(v.0 as usize)) {
            Some(v) => {
                let name = self.text(v.name);
                let d = self.with_declaration(d, v.token, "always true");
                d.help(format!(
                    "set `{name}` to `false` in the loop, or bound the loop"
                ))
            }
            None => d.help("add a bound: `for (int i = 0; i < 100; i++)`"),
        }
    }

    /// A `return` with a value of the wrong type, or without the value it needs.
    pub(crate) fn explain_return(
        &self,
        value: Option<ExprId>,
        extent: Extent,
        mismatch: TypeMismatch,
    ) -> Diagnostic {
        match (mismatch, value) {
            (TypeMismatch::ValueReturned, Some(value)) => self.return_of_void(value, extent),
            (TypeMismatch::Returned(expected), Some(value)) => {
                self.return_mismatch(value, expected, extent)
            }
            (TypeMismatch::NothingReturned(expected), _) => {
                self.return_of_nothing(expected, extent)
            }
            (_, value) => self.explain_void(value.unwrap_or(self.root_expr)),
        }
    }

    fn return_of_nothing(&self, expected: Type, extent: Extent) -> Diagnostic {
        let name = self.name_of(expected);
        let d = self.error(
            error::RETURN_TYPE,
            extent,
            format!("`return` without a value in a function returning `{name}`"),
        );
        let zero = expected.zero();
        let place = self.token_span(extent.first);
        d.fix(zero.filter(|_| self.is_direct(extent)).map(|zero| {
            let edit = Edit::insert(place.end, format!(" {zero}"));
            Fix::suggestion(format!("return `{zero}`"), vec![edit])
        }))
    }

    fn return_of_void(&self, value: ExprId, extent: Extent) -> Diagnostic {
        let name = self.name_of(self.ty(value));
        let message = match self.ty(value).is_void() {
            true => "a `void` function cannot return an expression".to_string(),
            false => format!("a `void` function cannot return a value, found `{name}`"),
        };
        let d = self.error(error::RETURN_TYPE, extent, message);
        let d = self.label_return_type(d, "return type");
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
            true => "move the call before `return`",
            false => "remove the value",
        };
        let fix = self
            .is_direct(extent)
            .then(|| Fix::suggestion(title, edits));
        d.fix(fix)
    }

    fn return_mismatch(&self, value: ExprId, expected: Type, extent: Extent) -> Diagnostic {
        let found = self.ty(value);
        let numbers = |t: Type| t.scalar_kind().filter(|s| *s != Scalar::Bool);
        let rule = match (numbers(expected), numbers(found)) {
            (Some(a), Some(b)) if a != b && expected.components() == found.components() => {
                error::INT_FLOAT_MIX
            }
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::RETURN_TYPE,
        };
        let mut d = self.mismatch_at(extent, expected, value, rule);
        d.message = format!(
            "expected return value of type `{}`, found `{}`",
            self.name_of(expected),
            self.name_of(found)
        );
        self.label_return_type(d, "expected because of this return type")
    }

    fn label_return_type(&self, d: Diagnostic, label: &str) -> Diagnostic {
        let function = self.current.and_then(|f| self.functions.get(f.0 as usize));
        let decl = function.and_then(|f| self.tree.function(f.definition?));
        match decl.filter(|f| !self.is_prelude(f.ident.token)) {
            Some(decl) => d.label(self.span(self.tree.ty(decl.ty).extent), label),
            None => d,
        }
    }

    /// A condition that is not a `bool`.
    pub(crate) fn explain_condition(&self, id: ExprId, ty: Type, of: Condition) -> Diagnostic {
        let name = self.name_of(ty);
        let d = self
            .error_expr(error::CONDITION_TYPE, id, condition_message(of, &name))
            .note(format!("`{name}` does not convert to `bool` implicitly"));
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
            d.fix(Fix::safe(format!("add `!= {zero}`"), edits))
        } else if ty.scalar_kind() == Some(Scalar::Bool) {
            let edits = self.wrap(id, "all(", ")");
            d.note("`any(...)` tests whether at least one component is true")
                .fix(Fix::suggestion(
                    "use `all(...)` to test every component",
                    edits,
                ))
        } else if let Some(zero) = ty.zero().filter(|_| ty.is_vector()) {
            let edits = self.wrap(id, "any(notEqual(", &format!(", {zero}))"));
            let title = format!("use `any(notEqual(..., {zero}))`");
            d.fix(Fix::suggestion(title, edits))
        } else {
            d
        }
    }
}
