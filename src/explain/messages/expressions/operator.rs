//! Messages for operands of the wrong types, and for the GLSL functions to use instead.

use crate::messages::*;

/// Maximum number of expressions after an operand among which its parent is searched.
const MAX_LATER: usize = 100;

/// The message for operands that an operator cannot combine.
fn cannot_combine(symbol: &str, left: &str, right: &str) -> String {
    match symbol {
        "+" => format!("cannot add `{right}` to `{left}`"),
        "-" => format!("cannot subtract `{right}` from `{left}`"),
        "*" => format!("cannot multiply `{left}` by `{right}`"),
        "/" => format!("cannot divide `{left}` by `{right}`"),
        "<" | ">" | "<=" | ">=" | "==" | "!=" => {
            format!("cannot compare `{left}` with `{right}`")
        }
        "? :" => format!("`? :` has incompatible types: `{left}` and `{right}`"),
        _ => format!("cannot apply `{symbol}` to `{left}` and `{right}`"),
    }
}

impl ExplainContext<'_> {
    /// Operands of types that an operator does not accept. `id` is the whole expression, which may
    /// be an assignment like `l += r`.
    pub(super) fn explain_operands(
        &self,
        id: ExprId,
        left: ExprId,
        right: ExprId,
        clash: Clash,
    ) -> Diagnostic {
        let (ExprKind::Binary(op, ..) | ExprKind::Assign(Some(op), ..)) = self.tree.expr(id).kind
        else {
            return self.explain_assignment(id, left, right, clash);
        };
        let (l, r) = (self.ty(left), self.ty(right));
        let d = match clash {
            Clash::Scalars if l.is_array() => {
                self.other_mismatch(id, op.symbol(), left, right, clash)
            }
            Clash::Scalars
                if l.scalar_kind() == Some(Scalar::Bool)
                    || r.scalar_kind() == Some(Scalar::Bool) =>
            {
                self.bool_mismatch(id, op, left, right)
            }
            Clash::Scalars => {
                if op == BinaryOp::Rem
                    && let Some(d) = self.float_remainder(id, left, right)
                {
                    return d;
                }
                let prefer_int = op.compares() || op == BinaryOp::Rem;
                return self.mixed(id, op.symbol(), left, right, prefer_int);
            }
            Clash::Shape => self.shape_mismatch(id, op.symbol(), left, right),
            _ => self.other_mismatch(id, op.symbol(), left, right, clash),
        };
        self.advise_operator(d, id, op, left, right, clash)
    }

    /// `%` with a float operand that is not an integral literal: only `mod` can be meant.
    fn float_remainder(&self, id: ExprId, left: ExprId, right: ExprId) -> Option<Diagnostic> {
        let lasts = |id| {
            self.ty(id).scalar_kind() == Some(Scalar::Float) && self.integer_literal(id).is_none()
        };
        if !lasts(left) && !lasts(right) {
            return None;
        }
        let message = "`%` requires integers; use `mod(a, b)` for floats";
        let d = self.error_expr(error::INT_FLOAT_MIX, id, message);
        let fix = self.as_call(id, BuiltinId::Mod, left, right);
        Some(self.both(d, left, right).fix(fix))
    }

    fn both(&self, d: Diagnostic, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.name_of(self.ty(left)), self.name_of(self.ty(right)));
        d.label(self.expr_span(left), format!("`{l}`"))
            .label(self.expr_span(right), format!("`{r}`"))
    }

    fn bool_mismatch(&self, id: ExprId, op: BinaryOp, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.name_of(self.ty(left)), self.name_of(self.ty(right)));
        let is_bool = |id| self.ty(id).scalar_kind() == Some(Scalar::Bool);
        if let Some(d) = self.chained_comparison(id, op, left, right) {
            return d;
        }
        let message = cannot_combine(op.symbol(), &l, &r);
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
                "`{}` evaluates to a `bool`, which is then compared with `{}`",
                self.expr_text(left),
                self.expr_text(right)
            ));
        let is_plain = self.is_direct(self.tree.expr(id).extent);
        Some(d.fix(is_plain.then(|| Fix::safe("join two comparisons with `&&`", vec![edit]))))
    }

    /// Compares those of the expressions that are numbers with zero.
    fn compare_with_zero(&self, all: &[ExprId]) -> Option<Fix> {
        let mut edits = Vec::new();
        for &id in all.iter().filter(|&&id| self.ty(id) != Type::BOOL) {
            let ty = self.ty(id);
            let zero = ty.zero().filter(|_| ty.is_scalar())?;
            edits.extend(match self.binds_tightly(id) {
                true => vec![Edit::insert(self.expr_span(id).end, format!(" != {zero}"))],
                false => self.wrap(id, "(", &format!(") != {zero}")),
            });
        }
        let is_direct = all
            .iter()
            .all(|&id| self.is_direct(self.tree.expr(id).extent));
        // Languages that take a number for a condition compare it with zero.
        is_direct.then(|| Fix::safe("compare with zero", edits))
    }

    /// `int`, `uint` and `float` mixed: reported at the operand to change, usually a literal.
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
        let (culprit, expected) = self.culprit(left, ls, right, rs, prefer_int);
        // What is assigned to keeps its type.
        let assigns = matches!(self.tree.expr(id).kind, ExprKind::Assign(..)) && culprit == left;
        let (culprit, expected) = if assigns {
            (right, ls)
        } else {
            (culprit, expected)
        };
        let other = if culprit == left { right } else { left };
        let message = cannot_combine(symbol, &self.name_of(l), &self.name_of(r));
        let fix = self.convert(culprit, expected).map(|fix| match assigns {
            // That cuts off fractions.
            true => Fix::suggestion(fix.title, fix.edits),
            false => fix,
        });
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
            if prefer_int && !is_literal(int) && self.integer_literal(float).is_some() {
                return (float, int_kind);
            }
            return (int, Scalar::Float);
        }
        // `int` and `uint`: prefer to change a literal.
        if is_literal(left) && !is_literal(right) {
            (left, rs)
        } else {
            (right, ls)
        }
    }

    fn shape_mismatch(&self, id: ExprId, symbol: &str, left: ExprId, right: ExprId) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let message = cannot_combine(symbol, &ln, &rn);
        let d = self.error_expr(error::VECTOR_SIZE, id, message);
        let d = self.both(d, left, right);
        if l.is_matrix() || r.is_matrix() {
            let fix = match self.tree.expr(id).kind {
                ExprKind::Binary(BinaryOp::Mul, ..) => self.match_matrix(id, left, right),
                _ => None,
            };
            return d
                .note("the left operand must have as many columns as the right has rows (section 5.9)")
                .fix(fix);
        }
        let d = d.note("vectors of different sizes cannot be combined (section 5.9)");
        let fix = match self.tree.expr(id).kind {
            ExprKind::Assign(..) => self.become_type(right, l),
            _ => self.match_sizes(id, left, right),
        };
        d.fix(fix)
    }

    fn other_mismatch(
        &self,
        id: ExprId,
        symbol: &str,
        left: ExprId,
        right: ExprId,
        clash: Clash,
    ) -> Diagnostic {
        let (l, r) = (self.ty(left), self.ty(right));
        let (ln, rn) = (self.name_of(l), self.name_of(r));
        let has_float = [l, r].map(Type::scalar_kind).contains(&Some(Scalar::Float));
        let (rule, message) = match clash {
            Clash::Sampler => (
                error::SAMPLER_RESTRICTION,
                format!("samplers cannot be operands of `{symbol}`"),
            ),
            Clash::Struct if ln == rn => (
                error::TYPE_MISMATCH,
                format!("cannot apply `{symbol}` to `{ln}`"),
            ),
            Clash::Struct | Clash::Scalars => {
                (error::TYPE_MISMATCH, cannot_combine(symbol, &ln, &rn))
            }
            Clash::StructInside => (
                error::UNSUPPORTED_OPERATION,
                format!("cannot apply `{symbol}` to structs that contain arrays or samplers"),
            ),
            Clash::Array if l.is_array() != r.is_array() => {
                (error::TYPE_MISMATCH, cannot_combine(symbol, &ln, &rn))
            }
            Clash::Array if !self.has(Feature::ArrayValues) => (
                error::NEEDS_WEBGL2,
                format!("GLSL ES 1.00 does not support `{symbol}` on arrays"),
            ),
            Clash::Array => (
                error::TYPE_MISMATCH,
                format!("cannot apply `{symbol}` to arrays"),
            ),
            Clash::ArraySize => (
                error::TYPE_MISMATCH,
                format!("array sizes differ: `{ln}` and `{rn}`"),
            ),
            Clash::NeedsInteger if symbol == "%" && has_float => (
                error::TYPE_MISMATCH,
                "`%` requires integers; use `mod(a, b)` for floats".to_string(),
            ),
            Clash::NeedsInteger => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` requires integers, found `{ln}` and `{rn}`"),
            ),
            Clash::NeedsNumber => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` requires numbers, found `{ln}`"),
            ),
            Clash::NeedsBool => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` requires `bool` operands, found `{ln}` and `{rn}`"),
            ),
            _ => (
                error::TYPE_MISMATCH,
                format!("`{symbol}` requires scalars, found `{ln}` and `{rn}`"),
            ),
        };
        let d = self.error_expr(rule, id, message);
        if ln == rn {
            d
        } else {
            self.both(d, left, right)
        }
    }

    /// Adds a fix with the GLSL equivalent of an operator that does not accept its operands.
    fn advise_operator(
        &self,
        d: Diagnostic,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
        clash: Clash,
    ) -> Diagnostic {
        use BinaryOp as B;
        let as_call = |function| self.as_call(id, function, left, right);
        let fix = match (op, clash) {
            (B::Rem, Clash::NeedsInteger) => as_call(BuiltinId::Mod),
            (B::BitXor, Clash::NeedsInteger) => self.as_power(id, left, right),
            (B::BitAnd | B::BitOr, Clash::NeedsInteger | Clash::Scalars)
                if self.ty(left) == Type::BOOL && self.ty(right) == Type::BOOL =>
            {
                self.double_operator(op, left, right)
            }
            (_, Clash::NeedsScalar) => {
                let function = match op {
                    B::Less => BuiltinId::LessThan,
                    B::Greater => BuiltinId::GreaterThan,
                    B::LessEqual => BuiltinId::LessThanEqual,
                    _ => BuiltinId::GreaterThanEqual,
                };
                let keeps_each = self.takes_bools(id);
                as_call(function).map(|mut fix| {
                    for edit in fix.edits.iter_mut().filter(|_| !keeps_each) {
                        edit.text = format!("all({})", edit.text);
                        fix.title = format!("use `{}` to compare every component", edit.text);
                    }
                    fix
                })
            }
            (B::And | B::Or | B::Xor, Clash::NeedsBool) => self.compare_with_zero(&[left, right]),
            _ => return d,
        };
        d.fix(fix)
    }

    /// Whether an operand of a call that takes vectors of `bool`, or the value of such a vector.
    fn takes_bools(&self, id: ExprId) -> bool {
        use BuiltinId as B;
        // Parents come after their children.
        let later = self.tree.exprs.iter().skip(id.0 as usize + 1);
        let call = later.take(MAX_LATER).find_map(|e| match e.kind {
            ExprKind::Call(name, args) if self.tree.args(args).contains(&id) => Some(name),
            _ => None,
        });
        let function = call.and_then(|name| BuiltinId::named(self.text(name)));
        let bools = |ty: Type| ty.is_vector() && ty.scalar_kind() == Some(Scalar::Bool);
        matches!(function, Some(B::All | B::Any | B::Not | B::Mix))
            || self.root_expr == id && self.expected.is_some_and(bools)
    }

    /// `l & r` of `bool`s becomes `l && r`.
    fn double_operator(&self, op: BinaryOp, left: ExprId, right: ExprId) -> Option<Fix> {
        let token = self.token(self.tree.expr(left).extent.last + 1);
        let symbol = op.symbol().repeat(2);
        let is_direct = token.is_direct() && token.span.end <= self.expr_span(right).start;
        let edits = vec![Edit::replace(token.span, symbol.clone())];
        is_direct.then(|| Fix::suggestion(format!("use `{symbol}`"), edits))
    }

    /// `l op r` becomes `function(l, r)`, as floats, and with a scalar widened to the other vector.
    fn as_call(&self, id: ExprId, function: BuiltinId, left: ExprId, right: ExprId) -> Option<Fix> {
        let all = Extent::new(
            self.tree.expr(left).extent.first,
            self.tree.expr(right).extent.last,
        );
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
        let edits = vec![Edit::replace(self.span(all), text.clone())];
        let title = format!("use `{text}`");
        // `%` of numbers means nothing else; that all components are compared is a guess.
        Some(match function {
            BuiltinId::Mod => Fix::safe(title, edits),
            _ => Fix::suggestion(title, edits),
        })
    }

    /// `l ^ r` as a power, which in other languages binds tighter than here.
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

    /// The text of an expression, converted to a type.
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

    /// `c ? a : b` with different types of `a` and `b`.
    pub(super) fn explain_arms(&self, id: ExprId, yes: ExprId, no: ExprId) -> Diagnostic {
        let (y, n) = (self.ty(yes), self.ty(no));
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
            .error_expr(rule, id, cannot_combine("? :", &yn, &nn))
            .note(NO_CONVERSION);
        let fix = match (y.is_vector() && n.is_vector(), y.components() == 1) {
            (true, _) => self.match_sizes(id, yes, no),
            (false, true) => self.become_type(yes, n),
            (false, false) => self.become_type(no, y),
        };
        self.both(d, yes, no).fix(fix)
    }

    /// `=` where `==` must be meant.
    pub(crate) fn compare_instead(&self, id: ExprId) -> Option<Fix> {
        let ExprKind::Assign(None, left, _) = self.tree.expr(self.tree.unparen(id)).kind else {
            return None;
        };
        let token = self.token(self.tree.expr(left).extent.last + 1);
        let edits = vec![Edit::replace(token.span, "==")];
        (token.kind == TokenKind::Equal && token.is_direct())
            .then(|| Fix::suggestion("use `==`", edits))
    }

    /// An operand of a type that its operator does not accept.
    pub(super) fn explain_operand(&self, id: ExprId, operand: ExprId, ty: Type) -> Diagnostic {
        let symbol = match self.tree.expr(id).kind {
            ExprKind::Unary(op, _) => op.symbol(),
            ExprKind::Postfix(op, _) => op.symbol(),
            _ => "",
        };
        let name = self.name_of(ty);
        let d = self.error_expr(
            error::TYPE_MISMATCH,
            id,
            format!("cannot apply `{symbol}` to `{name}`"),
        );
        let sign = self.token(self.tree.expr(id).extent.first);
        let is_direct = self.is_direct(self.tree.expr(id).extent);
        let negated = |before: &str, after: &str| {
            let end = self.expr_span(operand).end;
            let edits = vec![Edit::replace(sign.span, before), Edit::insert(end, after)];
            Some(edits).filter(|_| is_direct)
        };
        match (symbol, ty.scalar_kind()) {
            ("!", Some(Scalar::Bool)) => {
                let edits = negated("not(", ")");
                d.fix(edits.map(|e| Fix::suggestion("negate each component with `not(...)`", e)))
            }
            ("!", Some(_)) if ty.is_scalar() => {
                let zero = ty.zero().unwrap_or_default();
                let edits = negated("(", &format!(" == {zero})"));
                d.fix(edits.map(|e| Fix::safe(format!("compare with `{zero}`"), e)))
            }
            ("~", _) => d.note("`~` requires `int` or `uint`"),
            _ => d,
        }
    }

    /// `? :` on types that it does not support.
    pub(super) fn explain_unchosen(&self, id: ExprId, kind: NonNumber) -> Diagnostic {
        let what = match kind {
            NonNumber::Void => "`void`",
            NonNumber::Samplers => "samplers",
            NonNumber::Structs => "structs",
            NonNumber::Blocks => "blocks",
            NonNumber::Arrays => "arrays",
        };
        let message = format!("`? :` does not support {what}");
        self.error_expr(error::UNSUPPORTED_OPERATION, id, message)
            .note("WebGL2 disallows this operation (WebGL 2.0 section 5.26)")
            .help("use `if` and `else`")
    }

    /// `,` between types that it does not support.
    pub(super) fn explain_sequence(&self, id: ExprId) -> Diagnostic {
        let message = "`,` does not support `void` or array operands";
        self.error_expr(error::UNSUPPORTED_OPERATION, id, message)
            .note("WebGL2 disallows this operation (WebGL 2.0 section 5.26)")
            .help("split it into two statements")
    }
}
