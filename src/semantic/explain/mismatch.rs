//! What to say when types do not fit, and how to mend it.

use super::*;
use crate::semantic::BuiltinId;

const NO_CONVERSION: &str = "GLSL ES converts nothing by itself (section 4.1.10)";

impl Checker<'_> {
    /// A value of type `void` where one is needed.
    pub(in crate::semantic) fn explain_void(&self, id: ExprId) -> Diagnostic {
        let message = "this has no value: its type is `void`";
        self.error_expr(error::VOID_VALUE, id, message)
    }

    /// Operands that do not fit an operator. `id` is the whole expression, which may be an
    /// assignment like `l += r`.
    pub(in crate::semantic) fn explain_operands(
        &self,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
        misfit: Misfit,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let d = match misfit {
            Misfit::Void => return self.explain_void(if l.is_void() { left } else { right }),
            Misfit::Scalars if l.is_array() => {
                self.other_misfit(id, op.symbol(), left, right, misfit)
            }
            Misfit::Scalars
                if l.scalar_kind() == Some(Scalar::Bool)
                    || r.scalar_kind() == Some(Scalar::Bool) =>
            {
                self.bool_misfit(id, op, left, right)
            }
            Misfit::Scalars => {
                if op == BinaryOp::Rem
                    && let Some(d) = self.float_remainder(id, left, right)
                {
                    return d;
                }
                let prefer_int = op.compares() || op == BinaryOp::Rem;
                return self.mixed(id, op.symbol(), left, right, prefer_int);
            }
            Misfit::Shape => self.shape_misfit(id, op.symbol(), left, right),
            _ => self.other_misfit(id, op.symbol(), left, right, misfit),
        };
        self.advise_operator(d, id, op, left, right, misfit)
    }

    /// `%` with an operand that is a float for good: only `mod` can be meant.
    fn float_remainder(&self, id: ExprId, left: ExprId, right: ExprId) -> Option<Diagnostic> {
        let lasts = |id| {
            self.ty(id).scalar_kind() == Some(Scalar::Float) && self.whole_literal(id).is_none()
        };
        if !lasts(left) && !lasts(right) {
            return None;
        }
        let (l, r) = (self.name_of(self.ty(left)), self.name_of(self.ty(right)));
        let message = format!("`%` works on integers, not on `{l}` and `{r}`");
        let d = self.error_expr(error::INT_FLOAT_MIX, id, message);
        let fix = self.as_call(id, BuiltinId::Mod, left, right);
        Some(self.both(d, left, right).fix(fix))
    }

    fn both(&self, d: Diagnostic, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.name_of(self.ty(left)), self.name_of(self.ty(right)));
        d.label(self.expr_span(left), format!("`{l}`"))
            .label(self.expr_span(right), format!("`{r}`"))
    }

    fn bool_misfit(&self, id: ExprId, op: BinaryOp, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.name_of(self.ty(left)), self.name_of(self.ty(right)));
        let is_bool = |id| self.ty(id).scalar_kind() == Some(Scalar::Bool);
        if let Some(d) = self.chained_comparison(id, op, left, right) {
            return d;
        }
        let message = format!("`{l}` and `{r}` do not go together in `{}`", op.symbol());
        let d = self
            .error_expr(error::TYPE_MISMATCH, id, message)
            .note(NO_CONVERSION);
        let other = |id| self.ty(id).scalar_kind().filter(|s| *s != Scalar::Bool);
        let fix = match (is_bool(left), is_bool(right)) {
            _ if op.is_logical() => self.compare_with_zero(&[left, right]),
            (true, false) => other(right).and_then(|s| self.convert(left, s)),
            (false, true) => other(left).and_then(|s| self.convert(right, s)),
            _ => None,
        };
        self.both(d, left, right).fix(fix)
    }

    /// `a < b < c`, which other languages read as `a < b && b < c`.
    fn chained_comparison(
        &self,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
    ) -> Option<Diagnostic> {
        let ExprKind::Binary(first, _, middle) = self.tree.expr(left).kind else {
            return None;
        };
        if !first.compares() || !op.compares() || self.ty(right) == Type::BOOL {
            return None;
        }
        let text = self.expr_text(middle);
        let edit = Edit::insert(self.expr_span(left).end, format!(" && {text}"));
        let d = self
            .error_expr(error::TYPE_MISMATCH, id, "comparisons cannot be chained")
            .note(format!(
                "`{}` gives a `bool`, which is then compared with `{}`",
                self.expr_text(left),
                self.expr_text(right)
            ));
        let is_plain = self.is_direct(self.tree.expr(id).extent);
        Some(d.fix(is_plain.then(|| Fix::safe("compare twice, joined by `&&`", vec![edit]))))
    }

    /// Compares the numbers among some expressions with 0.
    fn compare_with_zero(&self, all: &[ExprId]) -> Option<Fix> {
        let mut edits = Vec::new();
        for &id in all.iter().filter(|&&id| self.ty(id) != Type::BOOL) {
            let ty = self.ty(id);
            let zero = self.zero_of(ty).filter(|_| ty.is_scalar())?;
            edits.extend(match self.binds_tightly(id) {
                true => vec![Edit::insert(self.expr_span(id).end, format!(" != {zero}"))],
                false => self.wrap(id, "(", &format!(") != {zero}")),
            });
        }
        let is_direct = all
            .iter()
            .all(|&id| self.is_direct(self.tree.expr(id).extent));
        is_direct.then(|| Fix::suggestion("compare with 0", edits))
    }

    /// `int`, `uint` and `float` mixed: points at what should change, most often a literal.
    fn mixed(
        &self,
        id: ExprId,
        symbol: &str,
        left: ExprId,
        right: ExprId,
        prefer_int: bool,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let ls = l.scalar_kind().unwrap_or(Scalar::Float);
        let rs = r.scalar_kind().unwrap_or(Scalar::Float);
        let (culprit, wanted) = self.culprit(left, ls, right, rs, prefer_int);
        let other = if culprit == left { right } else { left };
        let message = format!(
            "`{}` and `{}` do not mix in `{symbol}`",
            self.name_of(l),
            self.name_of(r)
        );
        let fix = self.convert(culprit, wanted);
        let is_literal = self.literal_token(culprit).is_some();
        let d = if is_literal || !matches!(symbol, "=" | "+=" | "-=" | "*=" | "/=") {
            self.error_expr(error::INT_FLOAT_MIX, culprit, message)
        } else {
            self.error_expr(error::INT_FLOAT_MIX, id, message).label(
                self.expr_span(culprit),
                format!("`{}`", self.name_of(self.ty(culprit))),
            )
        };
        d.mark(if is_literal {
            format!("`{}`", self.name_of(self.ty(culprit)))
        } else {
            String::new()
        })
        .label(
            self.expr_span(other),
            format!("`{}`", self.name_of(self.ty(other))),
        )
        .note(NO_CONVERSION)
        .fix(fix)
    }

    /// Which operand to convert, and to what.
    fn culprit(
        &self,
        left: ExprId,
        ls: Scalar,
        right: ExprId,
        rs: Scalar,
        prefer_int: bool,
    ) -> (ExprId, Scalar) {
        let is_literal = |id| self.literal_token(id).is_some();
        if ls == Scalar::Float || rs == Scalar::Float {
            let (float, int) = if ls == Scalar::Float {
                (left, right)
            } else {
                (right, left)
            };
            let int_kind = if ls == Scalar::Float { rs } else { ls };
            if prefer_int && !is_literal(int) && self.whole_literal(float).is_some() {
                return (float, int_kind);
            }
            return (int, Scalar::Float);
        }
        // `int` and `uint`: a literal changes most easily.
        if is_literal(left) && !is_literal(right) {
            (left, rs)
        } else {
            (right, ls)
        }
    }

    fn shape_misfit(&self, id: ExprId, symbol: &str, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let d = self.error_expr(
            error::VECTOR_SIZE,
            id,
            format!("`{ln}` and `{rn}` do not fit in `{symbol}`"),
        );
        let d = self.both(d, left, right);
        if l.is_matrix() || r.is_matrix() {
            let fix = match self.tree.expr(id).kind {
                ExprKind::Binary(BinaryOp::Mul, ..) => self.match_matrix(id, left, right),
                _ => None,
            };
            return d
                .note("the left has as many columns as the right has rows (section 5.9)")
                .fix(fix);
        }
        let d = d.note("vectors of different sizes cannot be combined (section 5.9)");
        let fix = match self.tree.expr(id).kind {
            ExprKind::Assign(..) => self.become_type(right, l),
            _ => self.match_sizes(id, left, right),
        };
        d.fix(fix)
    }

    fn other_misfit(
        &self,
        id: ExprId,
        symbol: &str,
        left: ExprId,
        right: ExprId,
        misfit: Misfit,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let (rule, message) = match misfit {
            Misfit::Sampler => (
                error::SAMPLER_RESTRICTION,
                format!("a sampler cannot stand in `{symbol}`"),
            ),
            Misfit::Struct if ln == rn => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` has no meaning for `{ln}`"),
            ),
            Misfit::Struct | Misfit::Scalars => (
                error::TYPE_MISMATCH,
                format!("`{ln}` and `{rn}` do not fit in `{symbol}`"),
            ),
            Misfit::StructInside => (
                error::UNSUPPORTED_OPERATION,
                format!("`{symbol}` cannot stand between structs that hold arrays or samplers"),
            ),
            Misfit::Array if l.is_array() != r.is_array() => (
                error::TYPE_MISMATCH,
                format!("`{ln}` and `{rn}` do not fit in `{symbol}`"),
            ),
            Misfit::Array if !self.has(Feature::ArrayValues) => (
                error::NEEDS_WEBGL2,
                format!("GLSL ES 1.00 has no `{symbol}` for arrays"),
            ),
            Misfit::Array => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` has no meaning for arrays"),
            ),
            Misfit::ArraySize => (
                error::TYPE_MISMATCH,
                format!("the arrays `{ln}` and `{rn}` differ in size"),
            ),
            Misfit::NeedsInteger => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` works on integers, not on `{ln}` and `{rn}`"),
            ),
            Misfit::NeedsNumber => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` works on numbers, not on `{ln}`"),
            ),
            Misfit::NeedsBool => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` works on single `bool`s, not on `{ln}` and `{rn}`"),
            ),
            _ => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` compares single numbers, not `{ln}` and `{rn}`"),
            ),
        };
        let d = self.error_expr(rule, id, message);
        if ln == rn {
            d
        } else {
            self.both(d, left, right)
        }
    }

    /// What GLSL has in the place of an operator that does not fit.
    fn advise_operator(
        &self,
        d: Diagnostic,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
        misfit: Misfit,
    ) -> Diagnostic {
        use BinaryOp as B;
        let as_call = |function| self.as_call(id, function, left, right);
        let fix = match (op, misfit) {
            (B::Rem, Misfit::NeedsInteger) => as_call(BuiltinId::Mod),
            (B::BitXor, Misfit::NeedsInteger) => self.as_power(id, left, right),
            (B::BitAnd | B::BitOr, Misfit::NeedsInteger | Misfit::Scalars)
                if self.ty(left) == Type::BOOL && self.ty(right) == Type::BOOL =>
            {
                self.double_operator(op, left, right)
            }
            (_, Misfit::NeedsScalar) => {
                let function = match op {
                    B::Less => BuiltinId::LessThan,
                    B::Greater => BuiltinId::GreaterThan,
                    B::LessEqual => BuiltinId::LessThanEqual,
                    _ => BuiltinId::GreaterThanEqual,
                };
                as_call(function).map(|mut fix| {
                    for edit in &mut fix.edits {
                        edit.text = format!("all({})", edit.text);
                    }
                    fix.title = format!("{}, true where all are", fix.title);
                    fix
                })
            }
            (B::And | B::Or | B::Xor, Misfit::NeedsBool) => self.compare_with_zero(&[left, right]),
            _ => return d,
        };
        d.fix(fix)
    }

    /// `l & r` of truth values becomes `l && r`.
    fn double_operator(&self, op: BinaryOp, left: ExprId, right: ExprId) -> Option<Fix> {
        let token = self.token(self.tree.expr(left).extent.last + 1);
        let symbol = op.symbol().repeat(2);
        let is_direct = token.is_direct() && token.span.end <= self.expr_span(right).start;
        let edits = vec![Edit::replace(token.span, symbol.clone())];
        is_direct.then(|| Fix::suggestion(format!("write `{symbol}`"), edits))
    }

    /// `l op r` becomes `function(l, r)`, in floats and with a number made a vector beside one.
    fn as_call(&self, id: ExprId, function: BuiltinId, left: ExprId, right: ExprId) -> Option<Fix> {
        let all = Extent {
            first: self.tree.expr(left).extent.first,
            last: self.tree.expr(right).extent.last,
        };
        let (l, r) = (self.ty(left), self.ty(right));
        let (_, 1, lr) = l.numeric()? else {
            return None;
        };
        let (_, 1, rr) = r.numeric()? else {
            return None;
        };
        let is_float =
            l.scalar_kind() == Some(Scalar::Float) || r.scalar_kind() == Some(Scalar::Float);
        let scalar = match is_float {
            true => Scalar::Float,
            false => l.scalar_kind()?,
        };
        let rows = lr.max(rr);
        if !self.is_direct(all) || (lr != rr && lr != 1 && rr != 1) {
            return None;
        }
        let ty = Type::vector(scalar, rows);
        let ty = if rows == 1 { Type::scalar(scalar) } else { ty };
        let keeps = function == BuiltinId::Mod && rr == 1;
        let right_type = if keeps { Type::scalar(scalar) } else { ty };
        let text = format!(
            "{}({}, {})",
            function.name(),
            self.text_as(left, ty),
            self.text_as(right, right_type)
        );
        let text = match self.tree.expr(id).kind {
            ExprKind::Assign(..) => format!("{} = {text}", self.expr_text(left)),
            _ => text,
        };
        let edit = Edit::replace(self.span(all), text.clone());
        Some(Fix::suggestion(format!("write `{text}`"), vec![edit]))
    }

    /// `l ^ r`, which is a power in other languages. It binds loosely here, and tightly there.
    fn as_power(&self, id: ExprId, left: ExprId, right: ExprId) -> Option<Fix> {
        let (mut base, mut exponent) = (left, right);
        while let ExprKind::Binary(_, _, last) = self.tree.expr(base).kind {
            base = last;
        }
        while let ExprKind::Unary(UnaryOp::Minus, inner) = self.tree.expr(base).kind {
            base = inner;
        }
        while let ExprKind::Binary(_, first, _) = self.tree.expr(exponent).kind {
            exponent = first;
        }
        self.as_call(id, BuiltinId::Pow, base, exponent)
    }

    /// The text of an expression, as a value of a type.
    fn text_as(&self, id: ExprId, ty: Type) -> String {
        let text = self.expr_text(id);
        let literal = self.literal_token(id).zip(ty.scalar_kind());
        let literal = literal.and_then(|(token, to)| {
            let converted = self.converted_literal(id, &token, to)?;
            Some(text.replace(self.sources.text(token.span), &converted))
        });
        match literal {
            Some(literal) if ty.is_scalar() => literal,
            Some(literal) => format!("{}({literal})", self.name_of(ty)),
            None if self.ty(id) == ty => text.to_string(),
            None => format!("{}({text})", self.name_of(ty)),
        }
    }

    /// `l = r` whose types do not fit.
    pub(in crate::semantic) fn explain_assignment(
        &self,
        id: ExprId,
        left: ExprId,
        right: ExprId,
        misfit: Misfit,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        if misfit == Misfit::Void {
            return self.explain_void(right);
        }
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let rule = self.rule_for(l, r, misfit);
        let d = self.misfit_at(self.tree.expr(id).extent, l, right, rule);
        let d = d.label(self.expr_span(left), format!("a variable of type `{ln}`"));
        if d.span == self.expr_span(right) {
            d
        } else {
            d.label(self.expr_span(right), format!("`{rn}`"))
        }
    }

    /// A declaration whose initializer does not fit.
    pub(in crate::semantic) fn explain_initializer(
        &self,
        declarator: &Declarator,
        spec: Option<Extent>,
        ty: Type,
        init: ExprId,
        misfit: Misfit,
    ) -> Diagnostic {
        let found = self.ty(init);
        if misfit == Misfit::Void {
            return self.explain_void(init);
        }
        let rule = self.rule_for(ty, found, misfit);
        let d = self.misfit_at(declarator.extent, ty, init, rule);
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

    fn rule_for(&self, wanted: Type, found: Type, misfit: Misfit) -> &'static str {
        let has_bool = |t: Type| t.element().scalar_kind() == Some(Scalar::Bool);
        match misfit {
            Misfit::Scalars if has_bool(wanted) || has_bool(found) => error::TYPE_MISMATCH,
            Misfit::Scalars if wanted.components() == found.components() => error::INT_FLOAT_MIX,
            Misfit::Scalars => error::TYPE_MISMATCH,
            Misfit::Shape => error::VECTOR_SIZE,
            Misfit::Sampler => error::SAMPLER_RESTRICTION,
            Misfit::StructInside => error::UNSUPPORTED_OPERATION,
            Misfit::Array if !self.has(Feature::ArrayValues) => error::NEEDS_WEBGL2,
            _ => error::TYPE_MISMATCH,
        }
    }

    /// "a `float` is wanted, but this is `int`": at the value where it is a literal that is easily
    /// mended, else at all of `extent`.
    pub(in crate::semantic) fn misfit_at(
        &self,
        extent: Extent,
        wanted: Type,
        value: ExprId,
        rule: &'static str,
    ) -> Diagnostic {
        let found = self.ty(value);
        let (wn, fname) = (self.name_of(wanted), self.name_of(found));
        let message = format!("`{fname}` cannot become `{wn}` by itself");
        let fix = self.become_type(value, wanted);
        let at_value = rule == error::INT_FLOAT_MIX && self.literal_token(value).is_some();
        let d = if at_value {
            self.error_expr(rule, value, message)
                .mark(format!("`{fname}`"))
        } else {
            self.error(rule, extent, message)
        };
        d.note(NO_CONVERSION).fix(fix)
    }

    /// Makes a number, vector or matrix one of another type.
    pub(super) fn become_type(&self, value: ExprId, wanted: Type) -> Option<Fix> {
        let (ws, wc, wr) = wanted.numeric()?;
        let (fs, fc, fr) = self.ty(value).numeric()?;
        if (wc, wr) == (fc, fr) {
            return self.convert(value, ws);
        }
        if let Some(fix) = self.component_list(value, wanted) {
            return Some(fix);
        }
        if ws == fs && wc == 1 && fc == 1 {
            return self.resize(value, wanted);
        }
        let fills = (fc, fr) == (1, 1);
        let is_direct = self.is_direct(self.tree.expr(value).extent);
        if !is_direct || !(fills || (fc > 1 && wc > 1)) {
            return None;
        }
        let name = self.name_of(wanted);
        let title = format!("make a `{name}` of it");
        Some(Fix::suggestion(
            title,
            self.wrap(value, &format!("{name}("), ")"),
        ))
    }

    /// `(1.0, 2.0, 3.0)` in the place of a vector.
    fn component_list(&self, value: ExprId, wanted: Type) -> Option<Fix> {
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
        let is_list = at != inner && components == wanted.components() && wanted.is_vector();
        let name = self.name_of(wanted);
        let edit = Edit::insert(self.expr_span(value).start, name.clone());
        (is_list && self.is_direct(self.tree.expr(value).extent))
            .then(|| Fix::safe(format!("write `{name}(...)`"), vec![edit]))
    }

    /// Edits that put text around an expression.
    pub(super) fn wrap(&self, id: ExprId, before: &str, behind: &str) -> Vec<Edit> {
        let span = self.expr_span(id);
        vec![
            Edit::insert(span.start, before),
            Edit::insert(span.end, behind),
        ]
    }

    /// Whether an expression needs no parentheses before a `.`.
    pub(super) fn is_atom(&self, id: ExprId) -> bool {
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

    /// `c ? a : b` whose arms differ.
    pub(in crate::semantic) fn explain_arms(
        &self,
        id: ExprId,
        yes: ExprId,
        no: ExprId,
    ) -> Diagnostic {
        let (y, n) = (self.ty(yes), self.ty(no));
        if y.is_void() || n.is_void() {
            return self.explain_void(if y.is_void() { yes } else { no });
        }
        let scalars = (y.scalar_kind(), n.scalar_kind());
        let mixed = matches!(scalars, (Some(a), Some(b)) if a != b && a != Scalar::Bool && b != Scalar::Bool);
        if mixed && y.components() == n.components() {
            return self.mixed(id, "? :", yes, no, false);
        }
        let (yn, nn) = (self.name_of(y), self.name_of(n));
        let rule = match scalars {
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::TYPE_MISMATCH,
        };
        let d = self
            .error_expr(
                rule,
                id,
                format!("the two values of `? :` differ: `{yn}` and `{nn}`"),
            )
            .note(NO_CONVERSION);
        let fix = match (y.is_vector() && n.is_vector(), y.components() == 1) {
            (true, _) => self.match_sizes(id, yes, no),
            (false, true) => self.become_type(yes, n),
            (false, false) => self.become_type(no, y),
        };
        self.both(d, yes, no).fix(fix)
    }

    /// A condition that is no `bool`.
    pub(in crate::semantic) fn explain_condition(&self, id: ExprId, what: &str) -> Diagnostic {
        let ty = self.ty(id);
        if ty.is_void() {
            return self.explain_void(id);
        }
        let name = self.name_of(ty);
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

    /// `=` where `==` must be meant.
    pub(in crate::semantic) fn compare_instead(&self, id: ExprId) -> Option<Fix> {
        let ExprKind::Assign(None, left, _) = self.tree.expr(self.tree.unparen(id)).kind else {
            return None;
        };
        let token = self.token(self.tree.expr(left).extent.last + 1);
        let edits = vec![Edit::replace(token.span, "==")];
        (token.kind == TokenKind::Equal && token.is_direct())
            .then(|| Fix::suggestion("write `==`", edits))
    }

    /// The token of a literal number, through parentheses and signs.
    pub(in crate::semantic) fn literal_token(&self, id: ExprId) -> Option<Token> {
        let mut at = id;
        loop {
            match self.tree.expr(at).kind {
                ExprKind::Paren(inner) | ExprKind::Unary(UnaryOp::Minus | UnaryOp::Plus, inner) => {
                    at = inner
                }
                ExprKind::Int(_) | ExprKind::Uint(_) | ExprKind::Float(_) => {
                    return Some(self.token(self.tree.expr(at).extent.first));
                }
                _ => return None,
            }
        }
    }

    /// The digits of a floating point literal without fraction: `2.0` gives `2`.
    fn whole_literal(&self, id: ExprId) -> Option<String> {
        let token = self.literal_token(id)?;
        let value = f32::from_bits(token.value);
        let small = token.kind == TokenKind::Float && value.fract() == 0.0 && value.abs() < 1e7;
        small.then(|| format!("{}", value as i64))
    }

    /// Makes an expression of another scalar kind: a literal is rewritten, everything else wrapped.
    pub(in crate::semantic) fn convert(&self, id: ExprId, to: Scalar) -> Option<Fix> {
        if let Some(token) = self.literal_token(id)
            && let Some(text) = self.converted_literal(id, &token, to)
        {
            let is_own = token.is_direct()
                || self
                    .sources
                    .text(token.span)
                    .starts_with(|c: char| c.is_ascii_digit());
            return is_own.then(|| {
                Fix::safe(
                    format!("write `{text}`"),
                    vec![Edit::replace(token.span, text)],
                )
            });
        }
        let extent = self.tree.expr(id).extent;
        if !self.is_direct(extent) {
            return None;
        }
        let ty = self.ty(id);
        let name = self.name_of(ty.with_scalar(to));
        let span = self.expr_span(id);
        let text = self.sources.text(span);
        let has_parens = matches!(self.tree.expr(id).kind, ExprKind::Paren(_));
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
            format!("write `{shown}`")
        } else {
            format!("convert it with `{name}(...)`")
        };
        let loses = ty.scalar_kind() == Some(Scalar::Float);
        Some(if loses {
            Fix::suggestion(title, edits)
        } else {
            Fix::safe(title, edits)
        })
    }

    fn converted_literal(&self, id: ExprId, token: &Token, to: Scalar) -> Option<String> {
        let text = self.sources.text(token.span);
        let digits = text.trim_end_matches(['u', 'U']);
        let is_decimal = digits.bytes().all(|b| b.is_ascii_digit())
            && (digits == "0" || !digits.starts_with('0'))
            && !digits.is_empty();
        match (token.kind, to) {
            (TokenKind::Int | TokenKind::Uint, Scalar::Float) if is_decimal => {
                Some(format!("{digits}.0"))
            }
            (TokenKind::Int, Scalar::Uint) => Some(format!("{digits}u")),
            (TokenKind::Uint, Scalar::Int) => Some(digits.to_string()),
            (TokenKind::Float, Scalar::Int) => self.whole_literal(id),
            (TokenKind::Float, Scalar::Uint) => self.whole_literal(id).map(|d| format!("{d}u")),
            _ => None,
        }
    }
}
