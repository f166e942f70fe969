//! Fixes that make vectors of different sizes match.

use crate::messages::*;

/// Longest code that a fix's title shows.
const MAX_SHOWN: usize = 60;

impl ExplainContext<'_> {
    /// Resizes one of the two vectors in `id` to the size of the other. The size that the context
    /// expects decides which; if that is unknown, a longer swizzle or uniform is truncated, and
    /// otherwise the smaller one is extended.
    pub(super) fn match_sizes(&self, id: ExprId, left: ExprId, right: ExprId) -> Option<Fix> {
        let (l, r) = (self.vector_size(left)?, self.vector_size(right)?);
        let (small, large) = if l < r { (left, right) } else { (right, left) };
        let expected = self
            .expected_size(id)
            .filter(|&size| size == l || size == r);
        let size = expected.unwrap_or_else(|| {
            if self.gives_way(large) {
                l.min(r)
            } else {
                l.max(r)
            }
        });
        if size == l.min(r) {
            self.cut(large, size)
        } else {
            self.fill(small, size)
        }
    }

    /// Resizes a value to the size of the expected vector.
    pub(crate) fn resize(&self, value: ExprId, expected: Type) -> Option<Fix> {
        let (_, 1, have) = self.ty(value).numeric()? else {
            return None;
        };
        let (_, 1, size) = expected.numeric()? else {
            return None;
        };
        if have > size {
            return self.cut(value, size);
        }
        if have > 1 {
            return self.fill(value, size);
        }
        if !self.is_direct(self.tree.expr(value).extent) {
            return None;
        }
        let name = self.name_of(expected);
        let scalar = expected.scalar_kind()?;
        if size == 4 && scalar == Scalar::Float && self.literal_token(value).is_none() {
            let edits = self.wrap(value, "vec4(vec3(", "), 1.0)");
            let text = self.expr_text(value);
            return Some(Fix::suggestion(
                format!("use `vec4(vec3({text}), 1.0)`"),
                edits,
            ));
        }
        let edits = self.wrap(value, &format!("{name}("), ")");
        Some(Fix::suggestion(
            format!("convert it with `{name}(...)`"),
            edits,
        ))
    }

    /// Resizes the vector in a product with a matrix to the size that the matrix requires, and the
    /// product to the size that its context expects.
    pub(super) fn match_matrix(&self, id: ExprId, left: ExprId, right: ExprId) -> Option<Fix> {
        let ((_, lc, lr), (_, rc, rr)) = (self.ty(left).numeric()?, self.ty(right).numeric()?);
        let (vector, size) = match (lc > 1, rc > 1) {
            (true, false) => (right, lc),
            (false, true) => (left, rr),
            (true, true) if lc == lr && rc == rr => {
                let (small, large) = if lc < rc {
                    (left, right)
                } else {
                    (right, left)
                };
                return self.become_type(small, self.ty(large));
            }
            _ => return None,
        };
        let mut fix = self.resize(vector, Type::vector(Scalar::Float, size))?;
        let (_, _, have) = self.ty(vector).numeric()?;
        let is_requested = self.expected_size(id) == Some(have) && have < size;
        if let Some(letters) = "xyzw".get(..have as usize).filter(|_| is_requested) {
            let [open, close] = self
                .wrap(id, "(", &format!(").{letters}"))
                .try_into()
                .ok()?;
            fix.edits.insert(0, open);
            match fix.edits.last_mut() {
                Some(last) if last.span == close.span => last.text += &close.text,
                _ => fix.edits.push(close),
            }
            fix.title = format!("{}, and `.{letters}` of the product", fix.title);
        }
        Some(fix)
    }

    /// The components that extend a vector from `have` to `size`: 1 for the fourth, which is alpha
    /// (opaque) or w (a point), and 0 for the others.
    pub(crate) fn added_components(scalar: Scalar, have: u8, size: u8) -> String {
        let (zero, one) = match scalar {
            Scalar::Float => ("0.0", "1.0"),
            Scalar::Bool => ("false", "true"),
            Scalar::Int => ("0", "1"),
            Scalar::Uint => ("0u", "1u"),
        };
        (have..size)
            .map(|i| format!(", {}", if i == 3 { one } else { zero }))
            .collect()
    }

    /// Declares a variable with the type of its initializer, if that is a computed value. Not for a
    /// texel or a variable, of which only some components may be meant.
    pub(super) fn retype(
        &self,
        spec: Extent,
        declarator: &Declarator,
        init: ExprId,
    ) -> Option<Fix> {
        use ExprKind as E;
        let is_part = match self.tree.expr(self.core(init)).kind {
            E::Name(_) | E::Member(..) | E::Index(..) | E::Method(..) => true,
            E::Call(name, _) => {
                let function = BuiltinId::named(self.text(name));
                function.is_some_and(|f| f.kind().is_texture())
            }
            _ => false,
        };
        let found = self.ty(init);
        if is_part || found.components() < 2 || !self.is_direct(spec) || declarator.arrays.len > 0 {
            return None;
        }
        let name = self.name_of(found);
        let variable = self.text(declarator.ident.name);
        Some(Fix::suggestion(
            format!("declare `{variable}` as `{name}`"),
            vec![Edit::replace(self.span(spec), name)],
        ))
    }

    fn vector_size(&self, id: ExprId) -> Option<u8> {
        match self.ty(id).numeric()? {
            (_, 1, rows @ 2..) => Some(rows),
            _ => None,
        }
    }

    /// The vector size that the statement around `id` expects of it, if known.
    pub(crate) fn expected_size(&self, id: ExprId) -> Option<u8> {
        let target = self.tree.expr(id).extent;
        let holds = |e: ExprId| self.tree.expr(e).extent.contains(target);
        let mut expected = self.expected;
        let mut at = self.root_expr;
        while at != id {
            at = match self.tree.expr(at).kind {
                ExprKind::Paren(inner) | ExprKind::Unary(_, inner) => inner,
                ExprKind::Assign(_, left, right) if holds(right) => {
                    expected = Some(self.ty(left));
                    right
                }
                ExprKind::Binary(op, left, _) if !op.compares() && holds(left) => left,
                ExprKind::Binary(op, _, right) if !op.compares() && holds(right) => right,
                ExprKind::Ternary(_, yes, _) if holds(yes) => yes,
                ExprKind::Ternary(_, _, no) if holds(no) => no,
                _ => return None,
            };
        }
        match expected?.numeric()? {
            (_, 1, rows @ 2..) => Some(rows),
            _ => None,
        }
    }

    /// The vector that determines the size of `id`, through parentheses, signs and scalar factors.
    fn core(&self, id: ExprId) -> ExprId {
        let mut at = id;
        loop {
            at = match self.tree.expr(at).kind {
                ExprKind::Paren(inner) | ExprKind::Unary(_, inner) => inner,
                ExprKind::Binary(_, left, right) if self.ty(right).is_scalar() => left,
                ExprKind::Binary(_, left, right) if self.ty(left).is_scalar() => right,
                _ => return at,
            };
        }
    }

    /// The token and letters of a swizzle, and the size of its vector.
    fn swizzle_of(&self, id: ExprId) -> Option<(TokenId, &str, u8)> {
        let expr = self.tree.expr(id);
        let ExprKind::Member(object, name) = expr.kind else {
            return None;
        };
        let size = self.vector_size(object)?;
        Some((expr.extent.last, self.text(name), size))
    }

    /// Whether a vector should be truncated rather than the other one extended.
    fn gives_way(&self, id: ExprId) -> bool {
        let core = self.core(id);
        let variable = match self.info(core).resolution {
            Resolution::Variable(variable) => self.variables.get(variable.0 as usize),
            _ => None,
        };
        self.swizzle_of(core).is_some() || variable.is_some_and(|v| v.storage == Storage::Uniform)
    }

    /// Truncates a vector to its first `size` components.
    fn cut(&self, id: ExprId, size: u8) -> Option<Fix> {
        let core = self.core(id);
        let letters = "xyzw".get(..size as usize)?;
        let at = if self.is_atom(core) { core } else { id };
        if !self.is_direct(self.tree.expr(at).extent) {
            return None;
        }
        let span = self.expr_span(at);
        let text = self.sources.text(span);
        let swizzle = self.swizzle_of(at);
        let (shown, edits) = match swizzle {
            Some((token, swizzle, _)) => {
                let kept = swizzle.get(..size as usize)?;
                let shown = format!("{}{kept}", text.strip_suffix(swizzle)?);
                (shown, vec![Edit::replace(self.token_span(token), kept)])
            }
            None if self.is_atom(at) => {
                let edit = Edit::insert(span.end, format!(".{letters}"));
                (format!("{text}.{letters}"), vec![edit])
            }
            None => {
                let edits = vec![
                    Edit::insert(span.start, "("),
                    Edit::insert(span.end, format!(").{letters}")),
                ];
                (format!("({text}).{letters}"), edits)
            }
        };
        let title = match shown.len() > MAX_SHOWN || shown.contains('\n') {
            true => format!("truncate it with `.{letters}`"),
            false => format!("use `{shown}`"),
        };
        Some(Fix::suggestion(title, edits))
    }

    /// Extends a vector: a swizzle gets more letters, everything else a constructor.
    fn fill(&self, id: ExprId, size: u8) -> Option<Fix> {
        let ty = Type::vector(self.ty(id).scalar_kind()?, size);
        let have = self.vector_size(id)?;
        if have >= size || !self.is_direct(self.tree.expr(id).extent) {
            return None;
        }
        if let Some(fix) = self.lengthen(self.core(id), size) {
            return Some(fix);
        }
        if let Some(fix) = self.spread(self.core(id), ty) {
            return Some(fix);
        }
        let zeros = ExplainContext::added_components(ty.scalar_kind()?, have, size);
        let span = self.expr_span(id);
        let name = self.name_of(ty);
        let text = self.sources.text(span);
        let title = format!("use `{name}({text}{zeros})`");
        let edits = self.wrap(id, &format!("{name}("), &format!("{zeros})"));
        Some(Fix::suggestion(title, edits))
    }

    /// `vec2(x)` of one number becomes `vec3(x)`.
    fn spread(&self, id: ExprId, ty: Type) -> Option<Fix> {
        let ExprKind::Construct(spec, args) = self.tree.expr(id).kind else {
            return None;
        };
        let [arg] = self.tree.args(args) else {
            return None;
        };
        let name = self.name_of(ty);
        let edits = vec![Edit::replace(
            self.span(self.tree.ty(spec).extent),
            name.clone(),
        )];
        let title = format!("use `{name}({})`", self.expr_text(*arg));
        self.ty(*arg)
            .is_scalar()
            .then(|| Fix::suggestion(title, edits))
    }

    /// `.xy` becomes `.xyz`, if the vector has that many components.
    fn lengthen(&self, id: ExprId, size: u8) -> Option<Fix> {
        let (token, swizzle, has) = self.swizzle_of(id)?;
        let letters = ["xyzw", "rgba", "stpq"];
        let set = letters.iter().find(|set| set.starts_with(swizzle))?;
        let longer = set.get(..size as usize).filter(|_| has >= size)?;
        let edit = Edit::replace(self.token_span(token), longer);
        let text = self.expr_text(id).strip_suffix(swizzle)?;
        let title = format!("use `{text}{longer}`");
        Some(Fix::suggestion(title, vec![edit]))
    }
}
