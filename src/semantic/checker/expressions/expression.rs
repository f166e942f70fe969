//! Expressions: literals, members, indices, and unary and ternary operators.

use crate::checker::*;
use crate::constant::Value;
use crate::typing::LENGTH;

/// An error in an expression.
#[derive(Clone, Debug)]
pub enum ExpressionError {
    /// Operands or arguments of wrong types, in the order in which the misfit numbers them.
    Misfit(ExprId, Vec<ExprId>, TypeMismatch),
    /// An unsigned literal in a version without them.
    Unsigned(ExprId),
    /// The `f` suffix of a literal that ends at this position, in a version without suffixes.
    Suffix(ExprId, u32),
    /// An operator or method of a later version.
    Later(ExprId),
    /// An unknown method, or `length()` with arguments.
    Method(ExprId, ExprId, Name, List),
    /// A member of a comma expression that is a struct containing samplers.
    MemberBehindComma(ExprId),
    /// A constant index, its value, and the number of elements that it exceeds.
    IndexRange(ExprId, ExprId, i64, u32),
    /// An index that must be constant.
    DynamicIndex(ExprId, Indexed),
}

/// What accepts only constant indices.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Indexed {
    Samplers,
    Blocks,
    Outputs,
    Output,
    /// A built-in array whose size only a declaration gives.
    Unsized,
}

impl Checker<'_> {
    /// Checks the expression `root` and everything in it.
    pub(in crate::checker) fn eval(&mut self, root: ExprId) {
        self.root_expr = root;
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
            self.reject_expr(id, ExpressionError::Unsigned(id));
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
                self.reject_expr(id, ExpressionError::Suffix(id, spelled.span.end));
            }
        }
        self.literal(Type::FLOAT, Value::Float(value))
    }

    /// The result of an operation, which is constant if its operands are.
    pub(in crate::checker) fn result(
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
        // An expression that the browser folds adds no depth to its tree.
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
        if let Err(mismatch) = typing::unary(op, info.ty) {
            return self.refuse(id, &[operand], mismatch);
        }
        if op == UnaryOp::BitNot {
            self.require(Feature::IntegerOperators, id);
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
    fn step(&mut self, id: ExprId, symbol: &'static str, operand: ExprId) -> ExprInfo {
        let info = self.info(operand);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        if let Err(mismatch) = typing::step(info.ty) {
            return self.refuse(id, &[operand], mismatch);
        }
        if !self.check_assignable(operand, self.tree.expr(id).extent, Writer::Word(symbol)) {
            return ExprInfo::ERROR;
        }
        ExprInfo {
            is_const: false,
            ..self.result(info.ty, [info], Constant::NONE)
        }
    }

    /// Reports a type error in an expression.
    pub(in crate::checker) fn refuse(
        &mut self,
        id: ExprId,
        parts: &[ExprId],
        mismatch: TypeMismatch,
    ) -> ExprInfo {
        self.reject_expr(id, ExpressionError::Misfit(id, parts.to_vec(), mismatch));
        ExprInfo::ERROR
    }

    /// Reports an operator or method that requires a later version of the language.
    pub(in crate::checker) fn require(&mut self, feature: Feature, id: ExprId) {
        if !self.has(feature) {
            self.reject_expr(id, ExpressionError::Later(id));
        }
    }

    fn ternary(&mut self, id: ExprId, condition: ExprId, yes: ExprId, no: ExprId) -> ExprInfo {
        let (c, y, n) = (self.info(condition), self.info(yes), self.info(no));
        if !c.ty.is_error()
            && let Err(mismatch) = typing::condition(c.ty)
        {
            self.refuse(id, &[condition], mismatch);
        }
        if y.ty.is_error() || n.ty.is_error() {
            return ExprInfo::ERROR;
        }
        match typing::choice(y.ty, n.ty) {
            Ok(ty) => {
                let constant = match self.pool.scalar(c.constant) {
                    Some(v) if v.as_bool() => y.constant,
                    Some(_) => n.constant,
                    None => Constant::NONE,
                };
                self.result(ty, [c, y, n], constant)
            }
            Err(mismatch) => self.refuse(id, &[yes, no], mismatch),
        }
    }

    fn comma(&mut self, id: ExprId, left: ExprId, right: ExprId) -> ExprInfo {
        let (l, r) = (self.info(left), self.info(right));
        let ty = match typing::sequence(self.types(), l.ty, r.ty) {
            Ok(ty) => ty,
            Err(mismatch) => return self.refuse(id, &[left, right], mismatch),
        };
        let is_kept = self.has(Feature::ConstantComma);
        let constant = if is_kept { r.constant } else { Constant::NONE };
        let info = self.result(ty, [l, r], constant);
        ExprInfo {
            is_const: info.is_const && is_kept,
            ..info
        }
    }

    /// `object.name(...)`: only `length()` of an array exists.
    fn method(&mut self, id: ExprId, object: ExprId, name: Name, args: List) -> ExprInfo {
        let info = self.info(object);
        self.require(Feature::ArrayValues, id);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        if self.text(name) != LENGTH || args.len > 0 || !info.ty.is_array() {
            self.reject_expr(id, ExpressionError::Method(id, object, name, args));
            return ExprInfo::ERROR;
        }
        let len = self.pool.add([Value::Int(info.ty.array as i32)]);
        // The length is constant even if the array is not, unless computing the array has side
        // effects.
        let pure = !self.has_side_effects(object);
        ExprInfo {
            ty: Type::INT,
            constant: if pure { len } else { Constant::NONE },
            resolution: Resolution::None,
            height: if pure {
                0
            } else {
                info.height.saturating_add(1)
            },
            is_const: pure,
        }
    }

    fn member(&mut self, id: ExprId, object: ExprId, name: Name) -> ExprInfo {
        let info = self.info(object);
        if info.ty.is_error() {
            return ExprInfo::ERROR;
        }
        let text = self.text(name);
        if self.is_after_comma(object, info.ty) {
            self.reject_expr(id, ExpressionError::MemberBehindComma(id));
            return ExprInfo::ERROR;
        }
        match typing::member(self.types(), info.ty, name, text) {
            Ok(Member::Components(ty, lanes)) => self.swizzle(object, info, ty, lanes),
            Ok(Member::Field(ty, offset)) => {
                let size = self.types().scalars_in(ty);
                let constant = match info.constant.is_known() {
                    true => info.constant.part(offset, size),
                    false => Constant::NONE,
                };
                self.result(ty, [info], constant)
            }
            Err(mismatch) => {
                self.refuse(id, &[object], mismatch);
                match (mismatch, info.ty.scalar_kind()) {
                    (TypeMismatch::Component(..), Some(scalar)) => ExprInfo {
                        ty: Type::vector(scalar, text.len() as u8),
                        ..ExprInfo::ERROR
                    },
                    _ => ExprInfo::ERROR,
                }
            }
        }
    }

    /// Whether `object` is a comma expression that is a struct containing samplers.
    fn is_after_comma(&self, object: ExprId, ty: Type) -> bool {
        let inner = self.tree.expr(self.tree.unparen(object)).kind;
        let is_record = !ty.is_array() && matches!(ty.base, Base::Struct(_) | Base::Block(_));
        is_record && matches!(inner, ExprKind::Comma(..)) && self.inside(ty).sampler
    }

    fn swizzle(&mut self, object: ExprId, info: ExprInfo, ty: Type, lanes: [u8; 4]) -> ExprInfo {
        let picked = lanes.get(..ty.components() as usize).unwrap_or(&[]);
        let picked = picked.iter().map(|&c| info.constant.part(c.into(), 1));
        let constant = self.pool.join(picked, |value| value);
        let mut result = self.result(ty, [info], constant);
        // The browser combines two swizzles into one.
        if let ExprKind::Member(inner, _) = self.tree.expr(self.tree.unparen(object)).kind
            && self.ty(inner).is_vector()
        {
            result.height = info.height;
        }
        result
    }

    fn index(&mut self, id: ExprId, object: ExprId, index: ExprId) -> ExprInfo {
        let (base, at) = (self.info(object), self.info(index));
        if base.ty.is_error() || at.ty.is_error() {
            return ExprInfo::ERROR;
        }
        let (element, size) = match typing::element(base.ty) {
            Ok(found) => found,
            Err(mismatch) => return self.refuse(id, &[object, index], mismatch),
        };
        if let Err(mismatch) = typing::index(at.ty) {
            self.refuse(id, &[object, index], mismatch);
            return ExprInfo {
                is_const: false,
                ..self.result(element, [base], Constant::NONE)
            };
        }
        self.check_index_range(object, index, size);
        self.check_index_kind(id, object, base, at);
        let each = self.types().scalars_in(element);
        let constant = match self.pool.scalar(at.constant) {
            Some(value) => base
                .constant
                .part(value.as_uint().saturating_mul(each), each),
            None => Constant::NONE,
        };
        self.result(element, [base, at], constant)
    }

    /// A constant index must be within the array, vector or matrix (section 5.7). Of a comma
    /// expression, which is not constant, the browser only checks that it is not negative.
    fn check_index_range(&mut self, object: ExprId, index: ExprId, size: u32) {
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
        let is_checked = value < 0 || self.info(index).is_const;
        if (0..size as i64).contains(&value) || size == Type::UNSIZED || !is_checked {
            return;
        }
        let problem = ExpressionError::IndexRange(object, index, value, size);
        self.reject_expr(index, problem);
    }

    /// Checks the index of arrays that accept only constant indices.
    fn check_index_kind(&mut self, id: ExprId, object: ExprId, base: ExprInfo, at: ExprInfo) {
        // Of a comma expression without side effects the browser keeps only the right operand.
        let mut after = self.tree.unparen(object);
        while let ExprKind::Comma(left, right) = self.tree.expr(after).kind
            && !self.has_side_effects(left)
        {
            after = self.tree.unparen(right);
        }
        let storage = self
            .variable_of(after)
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
        let name = storage.map_or("", |v| self.text(v.name));
        let what = match base.ty.base {
            _ if is_builtin && name == "gl_SampleMask" => return,
            _ if is_builtin && matches!(name, "gl_ClipDistance" | "gl_CullDistance") => {
                Indexed::Unsized
            }
            Base::Sampler(_) if base.ty.is_array() => Indexed::Samplers,
            Base::Block(_) => Indexed::Blocks,
            _ if is_output && self.stage == Stage::Fragment && base.ty.is_array() => {
                Indexed::Outputs
            }
            _ if is_output && self.stage == Stage::Fragment => Indexed::Output,
            _ => return,
        };
        self.reject_expr(id, ExpressionError::DynamicIndex(id, what));
    }
}
