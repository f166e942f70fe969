//! Messages for [`ValueError`]: values of the wrong type, and fixes that convert them.

use crate::messages::*;

impl Explain for ValueError {
    fn explain(self, c: &ExplainContext, _: Extent) -> Diagnostic {
        use ValueError as E;
        match self {
            E::Initializer(declarator, spec, ty, init, mismatch) => {
                c.explain_initializer(&declarator, spec, ty, init, mismatch)
            }
            E::Retyped(declarator, spec, ty, init, mismatch) => {
                c.explain_declared_type(mismatch, spec, &declarator, ty, init)
            }
            E::NotConstant(declarator, init, storage) => {
                c.explain_initial_value(&declarator, init, storage)
            }
        }
    }
}

impl ExplainContext<'_> {
    /// `l = r` with different types.
    pub(super) fn explain_assignment(
        &self,
        id: ExprId,
        left: ExprId,
        right: ExprId,
        clash: Clash,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let rule = self.rule_for(l, r, clash);
        let d = self.mismatch_at(self.tree.expr(id).extent, l, right, rule);
        let d = d.label(self.expr_span(left), format!("has type `{ln}`"));
        if d.span == self.expr_span(right) {
            d
        } else {
            d.label(self.expr_span(right), format!("`{rn}`"))
        }
    }

    /// A declaration with an initializer of another type.
    fn explain_initializer(
        &self,
        declarator: &Declarator,
        spec: Option<Extent>,
        ty: Type,
        init: ExprId,
        mismatch: TypeMismatch,
    ) -> Diagnostic {
        let found = self.ty(init);
        let clash = match mismatch {
            TypeMismatch::Value(clash) => clash,
            _ => return self.explain_void(init),
        };
        let rule = self.rule_for(ty, found, clash);
        let d = self.mismatch_at(declarator.extent, ty, init, rule);
        let retyped = spec.and_then(|spec| self.retype(spec, declarator, init));
        let d = match retyped.filter(|_| rule == error::VECTOR_SIZE) {
            Some(fix) => d.fix(fix),
            None => d,
        };
        match d.span == self.expr_span(init) {
            true => d,
            false => d.label(self.expr_span(init), format!("`{}`", self.name_of(found))),
        }
    }

    /// A declared type that matches neither the value nor the uses of the variable.
    fn explain_declared_type(
        &self,
        mismatch: TypeMismatch,
        spec: Extent,
        declarator: &Declarator,
        ty: Type,
        init: ExprId,
    ) -> Diagnostic {
        let rule = match mismatch {
            TypeMismatch::Value(clash) => self.rule_for(ty, self.ty(init), clash),
            _ => error::VOID_VALUE,
        };
        let (expected, found) = (self.name_of(ty), self.name_of(self.ty(init)));
        let ident = declarator.ident;
        let text = self.text(ident.name);
        let message =
            format!("`{text}` is declared as `{expected}`, but its value and uses are `{found}`");
        let edit = Edit::replace(self.span(spec), found.clone());
        self.error(rule, spec.to(Extent::token(ident.token)), message)
            .label(self.expr_span(init), format!("`{found}`"))
            .fix(Fix::safe(format!("declare it as `{found}`"), vec![edit]))
    }

    fn rule_for(&self, expected: Type, found: Type, clash: Clash) -> ErrorKind {
        let has_bool = |t: Type| t.element().scalar_kind() == Some(Scalar::Bool);
        match clash {
            Clash::Scalars if has_bool(expected) || has_bool(found) => error::TYPE_MISMATCH,
            Clash::Scalars if expected.components() == found.components() => error::INT_FLOAT_MIX,
            Clash::Scalars => error::TYPE_MISMATCH,
            Clash::Shape => error::VECTOR_SIZE,
            Clash::Sampler => error::SAMPLER_RESTRICTION,
            Clash::StructInside => error::UNSUPPORTED_OPERATION,
            Clash::Array if !self.has(Feature::ArrayValues) => error::NEEDS_WEBGL2,
            _ => error::TYPE_MISMATCH,
        }
    }

    /// A value that cannot be assigned to `expected`: reported at the value if it is a literal that
    /// is easily converted, else at all of `extent`.
    pub(crate) fn mismatch_at(
        &self,
        extent: Extent,
        expected: Type,
        value: ExprId,
        rule: ErrorKind,
    ) -> Diagnostic {
        let found = self.ty(value);
        let (wn, fname) = (self.name_of(expected), self.name_of(found));
        let message = format!("cannot assign `{fname}` to `{wn}`");
        let fix = self.become_type(value, expected);
        let fix = fix.map(|fix| match self.fills_vector(value, expected) {
            true => Fix::safe(fix.title, fix.edits),
            false => fix,
        });
        let at_value = rule == error::INT_FLOAT_MIX && self.literal_token(value).is_some();
        let d = if at_value {
            self.error_expr(rule, value, message)
                .mark(format!("`{fname}`"))
        } else {
            self.error(rule, extent, message)
        };
        d.note(NO_CONVERSION).fix(fix)
    }

    /// Whether a number is the value of all components of a vector; of a vector with four the last one may
    /// be meant to be 1.
    fn fills_vector(&self, value: ExprId, expected: Type) -> bool {
        let found = self.ty(value);
        found.is_scalar()
            && found.scalar_kind() == expected.scalar_kind()
            && expected.is_vector()
            && expected.components() < 4
    }

    /// Converts a number, vector or matrix to another type.
    pub(super) fn become_type(&self, value: ExprId, expected: Type) -> Option<Fix> {
        let (ws, wc, wr) = expected.numeric()?;
        let (fs, fc, fr) = self.ty(value).numeric()?;
        if (wc, wr) == (fc, fr) {
            return self.convert(value, ws);
        }
        if let Some(fix) = self.component_list(value, expected) {
            return Some(fix);
        }
        if ws == fs && wc == 1 && fc == 1 {
            return self.resize(value, expected);
        }
        let fills = (fc, fr) == (1, 1);
        let is_direct = self.is_direct(self.tree.expr(value).extent);
        if !is_direct || !(fills || (fc > 1 && wc > 1)) {
            return None;
        }
        let name = self.name_of(expected);
        let title = format!("convert it with `{name}(...)`");
        Some(Fix::suggestion(
            title,
            self.wrap(value, &format!("{name}("), ")"),
        ))
    }

    /// `(1.0, 2.0, 3.0)` instead of a vector.
    fn component_list(&self, value: ExprId, expected: Type) -> Option<Fix> {
        let ExprKind::Paren(inner) = self.tree.expr(value).kind else {
            return None;
        };
        let (mut at, mut components) = (inner, 0);
        loop {
            let (next, last) = match self.tree.expr(at).kind {
                ExprKind::Comma(left, right) => (Some(left), right),
                _ => (None, at),
            };
            components += self.ty(last).components();
            match next {
                Some(next) => at = next,
                None => break,
            }
        }
        let is_list = at != inner && components == expected.components() && expected.is_vector();
        let name = self.name_of(expected);
        let edit = Edit::insert(self.expr_span(value).start, name.clone());
        (is_list && self.is_direct(self.tree.expr(value).extent))
            .then(|| Fix::safe(format!("use `{name}(...)`"), vec![edit]))
    }

    /// The digits of a floating point literal without fraction: `2.0` gives `2`.
    pub(super) fn integer_literal(&self, id: ExprId) -> Option<String> {
        let token = self.literal_token(id)?;
        let value = f32::from_bits(token.value);
        let small = token.kind == TokenKind::Float && value.fract() == 0.0 && value.abs() < 1e7;
        small.then(|| format!("{}", value as i64))
    }

    /// Converts an expression to another scalar type: a literal is rewritten, everything else
    /// wrapped.
    pub(crate) fn convert(&self, id: ExprId, to: Scalar) -> Option<Fix> {
        let extent = self.tree.expr(id).extent;
        let place = self.exact_place(extent);
        let place = place.filter(|place| !place.in_body || !self.is_dividable(id, *place));
        let Some(span) = place.map(|place| place.span) else {
            return self.convert_parts(id, to);
        };
        if let Some(fix) = self.convert_literal(id, span, to) {
            return Some(fix);
        }
        if !self.is_direct(extent) {
            self.exact.borrow_mut().push(span);
        }
        let ty = self.ty(id);
        let name = self.name_of(ty.with_scalar(to));
        let text = self.sources.text(span);
        let is_paren = matches!(self.tree.expr(id).kind, ExprKind::Paren(_));
        let has_parens = is_paren && self.is_direct(extent);
        let mut edits = vec![Edit::insert(
            span.start,
            if has_parens {
                name.clone()
            } else {
                format!("{name}(")
            },
        )];
        if !has_parens {
            edits.push(Edit::insert(span.end, ")"));
        }
        let shown = if has_parens {
            format!("{name}{text}")
        } else {
            format!("{name}({text})")
        };
        let title = if shown.len() < 60 && !shown.contains('\n') {
            format!("use `{shown}`")
        } else {
            format!("use `{name}(...)`")
        };
        let loses = ty.scalar_kind() == Some(Scalar::Float);
        Some(if loses {
            Fix::suggestion(title, edits)
        } else {
            Fix::safe(title, edits)
        })
    }

    /// Whether the parts of an expression are better converted than its place in the body of a macro: in other
    /// calls, it may be a vector.
    fn is_dividable(&self, id: ExprId, place: ExactPlace) -> bool {
        place.has_params || matches!(self.tree.expr(id).kind, ExprKind::Paren(_))
    }

    /// Converts the integers in an expression that macros supply, which gives the same value.
    fn convert_parts(&self, id: ExprId, to: Scalar) -> Option<Fix> {
        let parts = match self.tree.expr(id).kind {
            _ if to != Scalar::Float => return None,
            ExprKind::Paren(inner) | ExprKind::Unary(UnaryOp::Minus | UnaryOp::Plus, inner) => {
                return self.convert(inner, to);
            }
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, left, right) => {
                [left, right]
            }
            ExprKind::Ternary(_, yes, no) => [yes, no],
            _ => return None,
        };
        let [first, second] = parts.map(|part| self.convert(part, to));
        let (mut fix, second) = (first?, second?);
        fix.title = joined_title(&[fix.title, second.title]);
        let is_new = |edit: &Edit| !fix.edits.contains(edit);
        let more: Vec<Edit> = second.edits.into_iter().filter(is_new).collect();
        fix.edits.extend(more);
        Some(fix)
    }

    /// Converts an expression that is a literal, if it is written at `place`: a macro that is a literal may be
    /// used with its own type elsewhere.
    fn convert_literal(&self, id: ExprId, place: Span, to: Scalar) -> Option<Fix> {
        let number = self.literal(id)?;
        let token = self.token(number);
        let span = match token.is_direct() {
            true => token.span,
            false => self.token_span(number),
        };
        let text = self.converted_literal(id, &token, to)?;
        let is_written = self
            .sources
            .text(span)
            .starts_with(|c: char| c.is_ascii_digit() || c == '.');
        if !place.contains(span) || !is_written {
            return None;
        }
        if !token.is_direct() {
            self.exact.borrow_mut().push(span);
        }
        Some(Fix::safe_replacement(span, text))
    }

    pub(super) fn converted_literal(
        &self,
        id: ExprId,
        token: &Token,
        to: Scalar,
    ) -> Option<String> {
        let text = self.sources.text(self.token_span(self.literal(id)?));
        let digits = text.trim_end_matches(['u', 'U']);
        match (token.kind, to) {
            // Octal and hexadecimal digits have another value as a float.
            (TokenKind::Int | TokenKind::Uint, Scalar::Float) if is_decimal(digits) => {
                Some(format!("{digits}.0"))
            }
            (TokenKind::Int, Scalar::Uint) => Some(format!("{digits}u")),
            (TokenKind::Uint, Scalar::Int) => Some(digits.to_string()),
            (TokenKind::Float, Scalar::Int) => self.integer_literal(id),
            (TokenKind::Float, Scalar::Uint) => self.integer_literal(id).map(|d| format!("{d}u")),
            _ => None,
        }
    }

    /// Edits that wrap an expression.
    pub(in crate::messages) fn wrap(&self, id: ExprId, before: &str, after: &str) -> Vec<Edit> {
        let span = self.expr_span(id);
        Edit::around(span, before, after)
    }

    /// Whether an expression needs no parentheses before a `.`.
    pub(in crate::messages) fn is_atom(&self, id: ExprId) -> bool {
        use ExprKind as E;
        matches!(
            self.tree.expr(id).kind,
            E::Name(_)
                | E::Paren(_)
                | E::Call(..)
                | E::Construct(..)
                | E::Member(..)
                | E::Index(..)
                | E::Method(..)
        )
    }

    /// Whether an expression can be an operand of any operator without parentheses.
    pub(in crate::messages) fn binds_tightly(&self, id: ExprId) -> bool {
        use ExprKind as E;
        let is_literal = matches!(
            self.tree.expr(id).kind,
            E::Int(_) | E::Uint(_) | E::Float(_) | E::Bool(_)
        );
        is_literal || self.is_atom(id)
    }
}
