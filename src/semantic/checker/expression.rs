//! Expressions: literals, members, indices and the operators with one operand or three.

use super::super::constant::Value;
use super::*;
use crate::diagnostic::Fix;
use crate::syntax::{Meaning, foreign};
use crate::text::Edit;

/// The one method there is, of arrays.
const LENGTH: &str = "length";

impl Checker<'_> {
    /// Checks the expression `root` and everything in it.
    pub(super) fn eval(&mut self, root: ExprId) {
        self.whole = root;
        while self.exprs.len() <= root.0 as usize && self.exprs.len() < self.tree.exprs.len() {
            let id = ExprId(self.exprs.len() as u32);
            let info = if self.gave_up() {
                ExprInfo::ERROR
            } else {
                self.expression(id)
            };
            self.exprs.push(info);
        }
    }

    /// Checks one expression whose operands have been checked.
    fn expression(&mut self, id: ExprId) -> ExprInfo {
        match self.tree.expr(id).kind {
            ExprKind::Error => ExprInfo::ERROR,
            ExprKind::Name(name) => self.name(name, id),
            ExprKind::Int(value) => self.literal(Type::INT, Value::Int(value)),
            ExprKind::Uint(value) => self.uint_literal(id, value),
            ExprKind::Float(value) => self.float_literal(id, value),
            ExprKind::Bool(value) => self.literal(Type::BOOL, Value::Bool(value)),
            ExprKind::Paren(inner) => self.info(inner),
            ExprKind::Unary(op, operand) => self.unary(id, op, operand),
            ExprKind::Postfix(op, operand) => self.step(id, op.symbol(), operand),
            ExprKind::Binary(op, left, right) => self.binary(id, op, left, right),
            ExprKind::Assign(op, left, right) => self.assign(id, op, left, right),
            ExprKind::Ternary(condition, yes, no) => self.ternary(id, condition, yes, no),
            ExprKind::Comma(left, right) => self.comma(id, left, right),
            ExprKind::Call(name, args) => self.call(id, name, args),
            ExprKind::Construct(ty, args) => self.construct(id, ty, args),
            ExprKind::Method(object, name, args) => self.method(id, object, name, args),
            ExprKind::Member(object, name) => self.member(id, object, name),
            ExprKind::Index(object, index) => self.index(id, object, index),
        }
    }

    fn literal(&mut self, ty: Type, value: Value) -> ExprInfo {
        let constant = self.pool.add([value]);
        ExprInfo {
            ty,
            constant,
            resolution: Resolution::None,
            height: 0,
            is_const: true,
        }
    }

    fn uint_literal(&mut self, id: ExprId, value: u32) -> ExprInfo {
        if !self.has(Feature::UnsignedIntegers) {
            let d = self
                .error_expr(
                    error::NEEDS_WEBGL2,
                    id,
                    "GLSL ES 1.00 has no unsigned integers",
                )
                .help("start the shader with `#version 300 es`");
            self.report(d);
            return ExprInfo::ERROR;
        }
        self.literal(Type::UINT, Value::Uint(value))
    }

    fn float_literal(&mut self, id: ExprId, value: f32) -> ExprInfo {
        if !self.has(Feature::FloatSuffix) {
            let extent = self.tree.expr(id).extent;
            let spelled = self.token(extent.first);
            let text = if spelled.is_direct() {
                self.expr_text(id)
            } else {
                ""
            };
            if text.ends_with(['f', 'F']) {
                let end = spelled.span.end;
                let edit = Edit::delete(Span::new(end - 1, end));
                let d = self
                    .error_expr(error::NEEDS_WEBGL2, id, "GLSL ES 1.00 has no suffix `f`")
                    .fix(Fix::safe("take the suffix away", vec![edit]));
                self.report(d);
            }
        }
        self.literal(Type::FLOAT, Value::Float(value))
    }

    /// The info of a result that is constant if its operands are.
    pub(super) fn result(
        &self,
        ty: Type,
        operands: impl IntoIterator<Item = ExprInfo>,
        constant: Constant,
    ) -> ExprInfo {
        let (mut is_const, mut deepest) = (true, None);
        for operand in operands {
            is_const &= operand.is_const;
            deepest = deepest.max(Some(operand.height));
        }
        // What the browser folds leaves no tree behind.
        let folded = is_const && constant.is_known() && ty.components() > 0;
        let height = if folded {
            0
        } else {
            deepest.map_or(0, |h: u16| h.saturating_add(1))
        };
        let constant = if is_const { constant } else { Constant::NONE };
        ExprInfo {
            ty,
            constant,
            resolution: Resolution::None,
            height,
            is_const,
        }
    }

    fn unary(&mut self, id: ExprId, op: UnaryOp, operand: ExprId) -> ExprInfo {
        if op.assigns() {
            return self.step(id, op.symbol(), operand);
        }
        let info = self.info(operand);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        let scalar = info.ty.scalar_kind();
        let ok = match op {
            UnaryOp::Not => info.ty == Type::BOOL,
            UnaryOp::BitNot => scalar.is_some_and(Scalar::is_integer) && !info.ty.is_matrix(),
            _ => scalar.is_some_and(|s| s != Scalar::Bool),
        };
        if !ok {
            self.bad_operand(id, op.symbol(), operand);
            return ExprInfo::ERROR;
        }
        if op == UnaryOp::BitNot {
            self.require(Feature::IntegerOperators, id, "the operator `~`");
        }
        let constant = self.pool.map(info.constant, |v| match (op, v) {
            (UnaryOp::Minus, Value::Int(v)) => Value::Int(v.wrapping_neg()),
            (UnaryOp::Minus, Value::Uint(v)) => Value::Uint(v.wrapping_neg()),
            (UnaryOp::Minus, Value::Float(v)) => Value::Float(-v),
            (UnaryOp::Not, v) => Value::Bool(!v.as_bool()),
            (UnaryOp::BitNot, Value::Int(v)) => Value::Int(!v),
            (UnaryOp::BitNot, Value::Uint(v)) => Value::Uint(!v),
            (_, v) => v,
        });
        self.result(info.ty, [info], constant)
    }

    /// `++` and `--`.
    fn step(&mut self, id: ExprId, symbol: &str, operand: ExprId) -> ExprInfo {
        let info = self.info(operand);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        if info.ty.scalar_kind().is_none_or(|s| s == Scalar::Bool) {
            self.bad_operand(id, symbol, operand);
            return ExprInfo::ERROR;
        }
        if !self.check_assignable(operand, self.tree.expr(id).extent, symbol) {
            return ExprInfo::ERROR;
        }
        ExprInfo {
            is_const: false,
            ..self.result(info.ty, [info], Constant::NONE)
        }
    }

    fn bad_operand(&mut self, id: ExprId, symbol: &str, operand: ExprId) {
        let ty = self.ty(operand);
        let name = self.name_of(ty);
        if ty.is_void() {
            return self.void_value(operand);
        }
        let d = self.error_expr(
            error::TYPE_MISMATCH,
            id,
            format!("`{symbol}` has no meaning for `{name}`"),
        );
        let sign = self.token(self.tree.expr(id).extent.first);
        let is_direct = self.is_direct(self.tree.expr(id).extent);
        let negated = |before: &str, behind: &str| {
            let end = self.expr_span(operand).end;
            let edits = vec![Edit::replace(sign.span, before), Edit::insert(end, behind)];
            Some(edits).filter(|_| is_direct)
        };
        let d = match (symbol, ty.scalar_kind()) {
            ("!", Some(Scalar::Bool)) => {
                let edits = negated("not(", ")");
                d.fix(edits.map(|e| Fix::suggestion("negate each component with `not(...)`", e)))
            }
            ("!", Some(_)) if ty.is_scalar() => {
                let zero = self.zero_of(ty).unwrap_or_default();
                let edits = negated("(", &format!(" == {zero})"));
                d.fix(edits.map(|e| Fix::suggestion(format!("compare with `{zero}`"), e)))
            }
            ("~", _) => d.note("`~` works on `int` and `uint`"),
            _ => d,
        };
        self.report(d);
    }

    /// Reports a value of type `void` where one is needed.
    pub(super) fn void_value(&mut self, id: ExprId) {
        let d = self.explain_void(id);
        self.report(d);
    }

    /// Reports what a later version of the language has.
    pub(super) fn require(&mut self, feature: Feature, id: ExprId, what: &str) {
        if !self.has(feature) {
            let d = self
                .error_expr(
                    error::NEEDS_WEBGL2,
                    id,
                    format!("{what} comes with GLSL ES 3.00"),
                )
                .help("start the shader with `#version 300 es`");
            self.report(d);
        }
    }

    fn ternary(&mut self, id: ExprId, condition: ExprId, yes: ExprId, no: ExprId) -> ExprInfo {
        let (c, y, n) = (self.info(condition), self.info(yes), self.info(no));
        if !c.ty.is_error() && c.ty != Type::BOOL {
            let d = self.explain_condition(condition, "the condition of `? :`");
            self.report(d);
        }
        if y.ty.is_error() || n.ty.is_error() {
            return ExprInfo::ERROR;
        }
        if y.ty != n.ty {
            let d = self.explain_arms(id, yes, no);
            self.report(d);
            return ExprInfo::ERROR;
        }
        let what = match y.ty.base {
            Base::Void => "`void`",
            Base::Sampler(_) => "samplers",
            Base::Struct(_) if !y.ty.is_array() => "structs",
            Base::Block(_) => "blocks",
            _ if y.ty.is_array() => "arrays",
            _ => {
                let constant = match self.pool.scalar(c.constant) {
                    Some(v) if v.as_bool() => y.constant,
                    Some(_) => n.constant,
                    None => Constant::NONE,
                };
                return self.result(y.ty, [c, y, n], constant);
            }
        };
        let d = self
            .error_expr(
                error::UNSUPPORTED_OPERATION,
                id,
                format!("`? :` cannot choose between {what}"),
            )
            .note("WebGL2 does not have it (WebGL 2.0 section 5.26)")
            .help("use `if` and `else`");
        self.report(d);
        ExprInfo::ERROR
    }

    fn comma(&mut self, id: ExprId, left: ExprId, right: ExprId) -> ExprInfo {
        let (l, r) = (self.info(left), self.info(right));
        let bad =
            |ty: Type| ty.is_void() || matches!(ty.base, Base::Block(_)) || self.inside(ty).array;
        if bad(l.ty) || bad(r.ty) {
            let d = self
                .error_expr(
                    error::UNSUPPORTED_OPERATION,
                    id,
                    "the operator `,` cannot stand between `void`s or arrays",
                )
                .note("WebGL2 does not have it (WebGL 2.0 section 5.26)")
                .help("write two statements");
            self.report(d);
            return ExprInfo::ERROR;
        }
        let is_kept = self.has(Feature::ConstantComma);
        let constant = if is_kept { r.constant } else { Constant::NONE };
        let info = self.result(r.ty, [l, r], constant);
        ExprInfo {
            is_const: info.is_const && is_kept,
            ..info
        }
    }

    /// `object.name(...)`: only `length()` of an array exists.
    fn method(&mut self, id: ExprId, object: ExprId, name: Name, args: List) -> ExprInfo {
        let info = self.info(object);
        self.require(Feature::ArrayValues, id, "`.length()`");
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        let text = self.text(name);
        let message = if text != LENGTH {
            format!("there is no method `{text}`; only arrays have one, `length()`")
        } else if args.len > 0 {
            "`length()` takes no argument".to_string()
        } else if !info.ty.is_array() {
            let of = self.name_of(info.ty);
            format!("`.length()` is for arrays; this is `{of}`")
        } else {
            let len = self.pool.add([Value::Int(info.ty.array as i32)]);
            // The length is constant even where the array is not, unless computing the array does
            // something.
            let pure = !self.has_side_effects(object);
            let constant = if pure { len } else { Constant::NONE };
            let height = if pure {
                0
            } else {
                info.height.saturating_add(1)
            };
            return ExprInfo {
                ty: Type::INT,
                constant,
                resolution: Resolution::None,
                height,
                is_const: pure,
            };
        };
        let d = self.error_expr(error::NOT_A_FUNCTION, id, message);
        let d = match info.ty.is_vector() && text == LENGTH {
            true => d.note("the number of a vector's components is fixed"),
            false => d,
        };
        let fix = self.method_as_call(id, object, name, args);
        let fix = fix.or_else(|| {
            let is_swizzle =
                info.ty.is_vector() && components(text, &mut [0; MOST_COMPONENTS]).is_some();
            let behind = self.expr_span(object).end + 1 + text.len() as u32;
            let is_direct = self.is_direct(self.tree.expr(id).extent) && args.len == 1;
            let edits = vec![Edit::insert(behind, " * ")];
            (is_swizzle && is_direct).then(|| Fix::suggestion("multiply with `*`", edits))
        });
        self.report(d.fix(fix));
        ExprInfo::ERROR
    }

    /// `v.f(a)` becomes `f(v, a)`, where there is such a function.
    fn method_as_call(&self, id: ExprId, object: ExprId, name: Name, args: List) -> Option<Fix> {
        let text = self.text(name);
        let function = match foreign(text, self.version).map(|f| f.meaning) {
            Some(Meaning::Function(function)) => function,
            _ if self.builtins.function(text).is_some() => text,
            _ if self.by_name.contains_key(&name) => text,
            _ => return None,
        };
        let span = self.expr_span(object);
        let end = match self.tree.args(args).first() {
            Some(&first) => Span::new(span.end, self.expr_span(first).start),
            None => Span::new(span.end, self.expr_span(id).end),
        };
        let edits = vec![
            Edit::insert(span.start, format!("{function}(")),
            Edit::replace(end, if args.len > 0 { ", " } else { ")" }),
        ];
        self.is_direct(self.tree.expr(id).extent).then(|| {
            Fix::suggestion(
                format!("write `{function}({}...`", self.expr_text(object)),
                edits,
            )
        })
    }

    /// `v.xyz` of a vector with two components and `v.xyzw` of one with three: the components that
    /// it lacks are added.
    fn lack_of_components(&self, id: ExprId, object: ExprId, text: &str, rows: u8) -> Option<Fix> {
        let size = text.len() as u8;
        let is_whole = ["xyzw", "rgba", "stpq"]
            .iter()
            .any(|set| set.starts_with(text));
        let is_written = self.token(self.tree.expr(id).extent.last + 1).kind == TokenKind::Equal;
        let scalar = self.ty(object).scalar_kind()?;
        let is_wanted = self.wanted_size(id).is_none_or(|wanted| wanted == size);
        let is_direct = self.is_direct(self.tree.expr(id).extent);
        if !is_whole || size < rows + 1 || size < 2 || is_written || !is_wanted || !is_direct {
            return None;
        }
        let name = self.name_of(Type::vector(scalar, size));
        let added = Checker::added_components(scalar, rows, size);
        let written = format!("{name}({}{added})", self.expr_text(object));
        let edits = vec![Edit::replace(self.expr_span(id), written.clone())];
        Some(Fix::suggestion(format!("write `{written}`"), edits))
    }

    fn member(&mut self, id: ExprId, object: ExprId, name: Name) -> ExprInfo {
        let info = self.info(object);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        if let Some((scalar, 1, rows @ 2..)) = info.ty.numeric() {
            return self.swizzle(id, object, info, name, scalar, rows);
        }
        let field = self.tree.expr(id).extent.last;
        let text = self.text(name);
        if info.ty.is_array() {
            let d = self.error_at(
                error::NO_SUCH_FIELD,
                field,
                format!("an array has no member `{text}`"),
            );
            let d = match text {
                LENGTH => d.help("write `.length()`"),
                _ => d.help("take an element first: `a[0]`"),
            };
            self.report(d);
            return ExprInfo::ERROR;
        }
        match info.ty.base {
            Base::Struct(index) | Base::Block(index) => self.field(id, object, info, index, name),
            Base::Void => {
                self.void_value(object);
                ExprInfo::ERROR
            }
            _ => {
                let of = self.name_of(info.ty);
                let d = self.error_at(
                    error::INVALID_SWIZZLE,
                    field,
                    format!("`{of}` has no component `{text}`"),
                );
                let d = match info.ty.numeric() {
                    Some((_, 1, 1)) => {
                        d.note("only vectors have components; GLSL has no `.x` of a number")
                    }
                    Some(_) => d.help(
                        "a column of a matrix is `m[0]`, a number in it `m[0].x` or `m[0][0]`",
                    ),
                    None => d,
                };
                self.report(d);
                ExprInfo::ERROR
            }
        }
    }

    fn field(
        &mut self,
        id: ExprId,
        object: ExprId,
        info: ExprInfo,
        index: u32,
        name: Name,
    ) -> ExprInfo {
        let Some(record) = self.structs.get(index as usize) else {
            return ExprInfo::ERROR;
        };
        let is_comma = matches!(
            self.tree.expr(self.tree.unparen(object)).kind,
            ExprKind::Comma(..)
        );
        if is_comma && self.inside(info.ty).sampler {
            let message = "no member can be taken of a struct that holds samplers behind `,`";
            let d = self
                .error_expr(error::UNSUPPORTED_OPERATION, id, message)
                .note("the browser does not compile it")
                .help("take the member of the variable itself");
            self.report(d);
            return ExprInfo::ERROR;
        }
        let mut offset = 0;
        for field in &record.fields {
            let size = self.scalars_in(field.ty);
            if field.name == name {
                let constant = info.constant.part(offset, size);
                let mut result = self.result(field.ty, [info], constant);
                if !info.constant.is_known() {
                    result.constant = Constant::NONE;
                }
                return result;
            }
            offset += size;
        }
        let d = self.no_such_field(id, object, record, name);
        self.report(d);
        ExprInfo::ERROR
    }

    /// Number of scalars that a value of a type is made of.
    pub(super) fn scalars_in(&self, ty: Type) -> u32 {
        let one = match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * rows as u32,
            Base::Struct(id) => self.structs.get(id as usize).map_or(0, |s| {
                s.fields
                    .iter()
                    .fold(0, |n: u32, f| n.saturating_add(self.scalars_in(f.ty)))
            }),
            _ => 0,
        };
        one.saturating_mul(ty.array.max(1))
    }

    fn swizzle(
        &mut self,
        id: ExprId,
        object: ExprId,
        info: ExprInfo,
        name: Name,
        scalar: Scalar,
        rows: u8,
    ) -> ExprInfo {
        let text = self.text(name);
        let token = self.tree.expr(id).extent.last;
        let mut room = [0; MOST_COMPONENTS];
        let Some(components) = components(text, &mut room) else {
            let d = self.bad_swizzle(text, token, &self.name_of(info.ty));
            self.report(d);
            return ExprInfo::ERROR;
        };
        if let Some(&over) = components.iter().find(|&&c| c >= rows) {
            let of = self.name_of(info.ty);
            let letter = text
                .chars()
                .nth(components.iter().position(|&c| c == over).unwrap_or(0));
            let has = "xyzw".get(..rows as usize).unwrap_or("");
            let letters: Vec<String> = has.chars().map(|c| format!("`{c}`")).collect();
            let d = self
                .error_at(
                    error::SWIZZLE_OUT_OF_RANGE,
                    token,
                    format!("`{of}` has no component `{}`", letter.unwrap_or(' ')),
                )
                .mark(format!("the vector has {}", letters.join(", ")));
            let d = match self.tree.expr(self.tree.unparen(object)).kind {
                ExprKind::Member(..) => {
                    let text = self.expr_text(object);
                    d.note(format!(
                        "`{text}` is a new `{of}`, whose components are {} again",
                        letters.join(", ")
                    ))
                }
                _ => d,
            };
            let fix = self.lack_of_components(id, object, text, rows);
            let fix = fix.or_else(|| self.mend_swizzle(text, rows, token));
            self.report(d.fix(fix));
            let ty = Type::vector(scalar, components.len() as u8);
            return ExprInfo {
                ty,
                ..ExprInfo::ERROR
            };
        }
        let picked = components.iter().map(|&c| info.constant.part(c.into(), 1));
        let constant = self.pool.join(picked, |value| value);
        let ty = Type::vector(scalar, components.len() as u8);
        let mut result = self.result(ty, [info], constant);
        // The browser makes one swizzle of two.
        if let ExprKind::Member(inner, _) = self.tree.expr(self.tree.unparen(object)).kind
            && self.ty(inner).is_vector()
        {
            result.height = info.height;
        }
        result
    }

    fn bad_swizzle(&self, text: &str, token: TokenId, of: &str) -> Diagnostic {
        let d = self.error_at(
            error::INVALID_SWIZZLE,
            token,
            format!("`{text}` are no components of `{of}`"),
        );
        let letters = |set: &str| text.chars().any(|c| set.contains(c));
        let sets = ["xyzw", "rgba", "stpq"]
            .iter()
            .filter(|s| letters(s))
            .count();
        if text.chars().all(|c| "xyzwrgbastpq".contains(c)) && sets > 1 {
            d.note("`xyzw`, `rgba` and `stpq` cannot be mixed (section 5.5)")
        } else if text.len() > 4 {
            d.note("at most four components can be taken at once (section 5.5)")
        } else if text == LENGTH {
            d.help("a vector's length is `length(v)`")
        } else {
            d.note("a component is one of `xyzw`, `rgba` or `stpq` (section 5.5)")
        }
    }

    fn index(&mut self, id: ExprId, object: ExprId, index: ExprId) -> ExprInfo {
        let (base, at) = (self.info(object), self.info(index));
        if base.ty.is_error() || at.ty.is_error() {
            return ExprInfo::ERROR;
        }
        let (element, size) = match base.ty.numeric() {
            _ if base.ty.is_array() => (base.ty.element(), base.ty.array),
            Some((scalar, columns @ 2.., rows)) => (Type::vector(scalar, rows), columns as u32),
            Some((scalar, 1, rows @ 2..)) => (Type::scalar(scalar), rows as u32),
            _ => {
                let name = self.name_of(base.ty);
                let d = self
                    .error_expr(
                        error::INVALID_INDEX,
                        id,
                        format!("`{name}` cannot be indexed"),
                    )
                    .note("arrays, vectors and matrices can (section 5.7)");
                self.report(d);
                return ExprInfo::ERROR;
            }
        };
        if !matches!(at.ty, Type::INT | Type::UINT) {
            self.bad_index(index);
            return ExprInfo {
                is_const: false,
                ..self.result(element, [base], Constant::NONE)
            };
        }
        self.check_index_range(id, object, index, size);
        self.check_index_kind(id, object, base, at);
        let each = self.scalars_in(element);
        let constant = match self.pool.scalar(at.constant) {
            Some(value) => base
                .constant
                .part(value.as_uint().saturating_mul(each), each),
            None => Constant::NONE,
        };
        self.result(element, [base, at], constant)
    }

    fn bad_index(&mut self, index: ExprId) {
        let name = self.name_of(self.ty(index));
        let d = self.error_expr(
            error::INVALID_INDEX,
            index,
            format!("an index must be an integer, not `{name}`"),
        );
        let fix = match self.ty(index) {
            Type::FLOAT => self.convert(index, Scalar::Int),
            _ => None,
        };
        self.report(d.fix(fix));
    }

    /// A constant index must lie in the array, vector or matrix (section 5.7). Behind a comma, whose
    /// result is no constant, the browser looks for negative ones alone.
    fn check_index_range(&mut self, id: ExprId, object: ExprId, index: ExprId, size: u32) {
        let mut last = index;
        while let ExprKind::Comma(_, right) = self.tree.expr(self.tree.unparen(last)).kind {
            last = right;
        }
        let info = self.info(last);
        let Some(value) = self.pool.scalar(info.constant).filter(|_| info.is_const) else {
            return;
        };
        let value = match value {
            Value::Uint(v) if v > i32::MAX as u32 => v as i64,
            v => v.as_int() as i64,
        };
        let is_judged = value < 0 || self.info(index).is_const;
        if (0..size as i64).contains(&value) || size == Type::UNSIZED || !is_judged {
            return;
        }
        let of = self.name_of(self.ty(object));
        let d = self
            .error_expr(
                error::INDEX_OUT_OF_RANGE,
                index,
                format!("index {value} lies outside `{of}`"),
            )
            .mark(format!("the last one is {}", size - 1));
        let d = match self
            .variable_of(object)
            .and_then(|v| self.variables.get(v.0 as usize))
        {
            Some(v) if v.token.is_some() => self.with_declaration(d, v.token, "declared here"),
            _ => d,
        };
        let _ = id;
        self.report(d);
    }

    pub(in crate::semantic) fn variable_of(&self, id: ExprId) -> Option<VariableId> {
        match self.info(self.tree.unparen(id)).resolution {
            Resolution::Variable(id) => Some(id),
            _ => None,
        }
    }

    /// Some arrays take constant indices only.
    fn check_index_kind(&mut self, id: ExprId, object: ExprId, base: ExprInfo, at: ExprInfo) {
        // Of a comma the browser keeps what stands behind it, where nothing before it does anything.
        let mut behind = self.tree.unparen(object);
        while let ExprKind::Comma(left, right) = self.tree.expr(behind).kind
            && !self.has_side_effects(left)
        {
            behind = self.tree.unparen(right);
        }
        let storage = self
            .variable_of(behind)
            .and_then(|v| self.variables.get(v.0 as usize));
        let is_output = storage.is_some_and(|v| v.storage == Storage::Output);
        let is_builtin = storage.is_some_and(|v| v.token.is_none());
        if !self.has(Feature::FreeControlFlow) {
            let is_frag_data = is_builtin && is_output && base.ty.is_array();
            return self.check_webgl1_index(id, object, is_frag_data);
        }
        if at.is_const && at.constant.is_known() {
            return;
        }
        let what = match base.ty.base {
            Base::Sampler(_) if base.ty.is_array() => "an array of samplers",
            Base::Block(_) => "an array of blocks",
            _ if is_output && self.stage == Stage::Fragment && base.ty.is_array() => {
                "an array of fragment outputs"
            }
            _ if is_output && self.stage == Stage::Fragment => "a fragment output",
            _ => return,
        };
        let d = self
            .error_expr(error::INVALID_INDEX, id, format!("{what} takes a constant index only"))
            .note("in GLSL ES 3.00 the index must be a constant expression (sections 4.1.7, 4.3.6, 4.3.7)")
            .help("use `switch` or `if` to choose among the elements");
        self.report(d);
    }
}

/// Most components that can be picked at once.
const MOST_COMPONENTS: usize = 4;

/// The components that a member's name picks, if it does.
fn components<'a>(text: &str, room: &'a mut [u8; MOST_COMPONENTS]) -> Option<&'a [u8]> {
    let set = ["xyzw", "rgba", "stpq"]
        .into_iter()
        .find(|set| text.starts_with(|c| set.contains(c)))?;
    let picked = room.get_mut(..text.len())?;
    for (slot, letter) in picked.iter_mut().zip(text.bytes()) {
        *slot = set.bytes().position(|c| c == letter)? as u8;
    }
    Some(picked)
}
