//! Lowering of expressions.

use super::super::form::*;
use super::Lowerer;
use super::place::{Picked, element_of};
use shaderlint_semantic::{Resolution, Scalar, Type, Value};
use shaderlint_syntax::ast::*;

/// Maximum number of nodes of a right operand that may be evaluated unconditionally.
const FEW: u32 = 12;

impl Lowerer<'_> {
    /// Lowers an expression. Returns its value.
    pub(super) fn value(&mut self, id: ExprId) -> OpId {
        let outer = std::mem::replace(&mut self.origin, Provenance::Expr(id));
        let made = self.deeper(|l| l.value_at(id));
        let made = made.unwrap_or_else(|| self.unknown(id));
        self.note(id, made);
        self.origin = outer;
        made
    }

    fn unknown(&mut self, id: ExprId) -> OpId {
        let ty = self.program.ty(id);
        self.op(OpKind::Unknown, ty)
    }

    fn value_at(&mut self, id: ExprId) -> OpId {
        let program = self.program;
        let ty = program.ty(id);
        // A constant array is not copied to each use, since there may be many: it stays in its
        // variable.
        if ty.components() > 0 && program.expr(id).constant.is_known() {
            return self.constant(program.values(id).iter().copied(), ty);
        }
        match program.tree.expr(id).kind {
            ExprKind::Error => self.unknown(id),
            ExprKind::Int(v) => self.constant([Value::Int(v)], Type::INT),
            ExprKind::Uint(v) => self.constant([Value::Uint(v)], Type::UINT),
            ExprKind::Float(v) => self.constant([Value::Float(v)], Type::FLOAT),
            ExprKind::Bool(v) => self.constant([Value::Bool(v)], Type::BOOL),
            ExprKind::Paren(inner) => self.value(inner),
            ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Index(..) => self.part(id),
            ExprKind::Unary(op, operand) => self.unary(op, operand, ty),
            ExprKind::Postfix(op, operand) => {
                self.counted(matches!(op, PostfixOp::Increment), operand).0
            }
            ExprKind::Binary(op, left, right) => self.binary(op, left, right, ty),
            ExprKind::Assign(op, target, value) => self.assign(op, target, value),
            ExprKind::Ternary(condition, then, otherwise) => {
                self.ternary(condition, then, otherwise, ty)
            }
            ExprKind::Comma(left, right) => {
                self.value(left);
                self.value(right)
            }
            ExprKind::Call(_, args) => match program.expr(id).resolution {
                Resolution::Function(function) => self.call(function, args, ty),
                Resolution::Builtin(overload) => self.builtin(overload, args, ty),
                Resolution::Struct(_) => self.record(args, ty),
                _ => {
                    self.values(args);
                    self.unknown(id)
                }
            },
            ExprKind::Construct(_, args) => self.construct(args, ty),
            // The length of an array is a constant, unless the array type has an error.
            ExprKind::Method(object, ..) => {
                self.value(object);
                self.unknown(id)
            }
        }
    }

    /// Lowers arguments.
    pub(super) fn values(&mut self, args: List) -> Vec<OpId> {
        let program = self.program;
        self.in_order(program.tree.args(args))
    }

    /// Lowers a variable or a part of a value.
    fn part(&mut self, id: ExprId) -> OpId {
        if let Some(place_path) = self.place_path(id) {
            let place = self.keep(&place_path);
            return self.load(place);
        }
        let program = self.program;
        let ty = program.ty(id);
        match program.tree.expr(id).kind {
            ExprKind::Member(object, name) => {
                let base = self.value(object);
                match self.picked(self.module.ty(base), name) {
                    Picked::Member(number, ty) => self.op(OpKind::Extract(base, number), ty),
                    Picked::Lanes(lanes) => self.op(OpKind::Swizzle(base, lanes), ty),
                    Picked::Nothing => self.unknown(id),
                }
            }
            ExprKind::Index(object, index) => {
                let base = self.value(object);
                let known = program.scalar(index).map(|v| v.as_int().max(0) as u32);
                if element_of(self.module.ty(base)).is_none() {
                    return self.unknown(id);
                }
                match known {
                    Some(number) => self.element(base, number, ty),
                    None => {
                        let index = self.value(index);
                        self.op(OpKind::ExtractComputed { base, index }, ty)
                    }
                }
            }
            _ => self.unknown(id),
        }
    }

    /// The element, column or component at a constant index.
    pub(super) fn element(&mut self, base: OpId, number: u32, ty: Type) -> OpId {
        match self.module.ty(base).is_vector() {
            true => self.op(OpKind::Swizzle(base, Lanes::new([number.min(3) as u8])), ty),
            false => self.op(OpKind::Extract(base, number), ty),
        }
    }

    fn unary(&mut self, op: UnaryOp, operand: ExprId, ty: Type) -> OpId {
        let kind = match op {
            UnaryOp::Increment => return self.counted(true, operand).1,
            UnaryOp::Decrement => return self.counted(false, operand).1,
            UnaryOp::Plus => return self.value(operand),
            UnaryOp::Minus => Unary::Negate,
            UnaryOp::Not => Unary::Not,
            UnaryOp::BitNot => Unary::BitNot,
        };
        let operand = self.value(operand);
        self.op(OpKind::Unary(kind, operand), ty)
    }

    /// Lowers `++` or `--`. Returns the values before and after.
    fn counted(&mut self, is_more: bool, operand: ExprId) -> (OpId, OpId) {
        let ty = self.program.ty(operand);
        let target = self.target(operand);
        let before = self.read(target, ty);
        let one = self.number(1, ty);
        let kind = match is_more {
            true => Binary::Add,
            false => Binary::Subtract,
        };
        let after = self.op(OpKind::Binary(kind, before, one), ty);
        self.write(target, after);
        (before, after)
    }

    /// Lowers `target = value` and `target op= value`: first the destination, then the value, then
    /// the load of the destination.
    fn assign(&mut self, op: Option<BinaryOp>, target: ExprId, value: ExprId) -> OpId {
        let ty = self.program.ty(target);
        let place = self.target(target);
        let mut value = self.value(value);
        if let Some(op) = op {
            let before = self.read(place, ty);
            value = self.operate(op, before, value, ty);
        }
        self.write(place, value);
        value
    }

    fn binary(&mut self, op: BinaryOp, left: ExprId, right: ExprId, ty: Type) -> OpId {
        let is_cut_short = matches!(op, BinaryOp::And | BinaryOp::Or);
        if is_cut_short && !self.is_simple(right) {
            let left = self.value(left);
            return self.cut_short(matches!(op, BinaryOp::And), left, right);
        }
        let left = self.before(left, self.writing.has(right));
        let right = self.value(right);
        let left = self.load_operand(left);
        self.operate(op, left, right, ty)
    }

    /// Lowers `&&` or `||` with short-circuit evaluation.
    fn cut_short(&mut self, is_and: bool, left: OpId, right: ExprId) -> OpId {
        let place = self.temporary(Type::BOOL);
        self.store(place, left);
        let origin = self.origin;
        let runs = self.region(|l| {
            let value = l.value(right);
            l.store(place, value);
        });
        let (then, otherwise) = match is_and {
            true => (runs, Region::default()),
            false => (Region::default(), runs),
        };
        self.step(Step::If {
            condition: left,
            then,
            otherwise,
            origin,
        });
        self.load(place)
    }

    fn ternary(&mut self, condition: ExprId, then: ExprId, otherwise: ExprId, ty: Type) -> OpId {
        let condition = self.value(condition);
        if self.is_simple(then) && self.is_simple(otherwise) {
            let then = self.value(then);
            let otherwise = self.value(otherwise);
            let kind = OpKind::Select {
                condition,
                then,
                otherwise,
            };
            return self.op(kind, ty);
        }
        let place = (!ty.is_void()).then(|| self.temporary(ty));
        let origin = self.origin;
        let mut side = |expr: ExprId| {
            self.region(|l| {
                let value = l.value(expr);
                if let Some(place) = place {
                    l.store(place, value);
                }
            })
        };
        let (then, otherwise) = (side(then), side(otherwise));
        self.step(Step::If {
            condition,
            then,
            otherwise,
            origin,
        });
        match place {
            Some(place) => self.load(place),
            None => self.op(OpKind::Unknown, ty),
        }
    }

    /// Whether an expression is cheap and safe to evaluate unconditionally: few operations, no
    /// calls, divisions, shifts, dynamic indices or side effects.
    fn is_simple(&self, id: ExprId) -> bool {
        let mut left = FEW;
        self.is_simple_within(id, &mut left)
    }

    fn is_simple_within(&self, id: ExprId, left: &mut u32) -> bool {
        let Some(rest) = left.checked_sub(1) else {
            return false;
        };
        *left = rest;
        let program = self.program;
        if program.expr(id).constant.is_known() {
            return true;
        }
        match program.tree.expr(id).kind {
            ExprKind::Int(_) | ExprKind::Uint(_) | ExprKind::Float(_) | ExprKind::Bool(_) => true,
            ExprKind::Name(_) => program.variable_of(id).is_some(),
            ExprKind::Paren(inner) | ExprKind::Member(inner, _) => {
                self.is_simple_within(inner, left)
            }
            ExprKind::Unary(op, inner) => !op.assigns() && self.is_simple_within(inner, left),
            ExprKind::Binary(op, l, r) => {
                let is_total = !matches!(
                    op,
                    BinaryOp::Div | BinaryOp::Rem | BinaryOp::ShiftLeft | BinaryOp::ShiftRight
                );
                is_total && self.is_simple_within(l, left) && self.is_simple_within(r, left)
            }
            _ => false,
        }
    }

    /// Lowers a binary operator. A scalar operand is first splatted to the shape of the other.
    pub(super) fn operate(&mut self, op: BinaryOp, left: OpId, right: OpId, ty: Type) -> OpId {
        let kind = match op {
            BinaryOp::Equal | BinaryOp::NotEqual => {
                let negated = op == BinaryOp::NotEqual;
                let kind = OpKind::Same {
                    negated,
                    left,
                    right,
                };
                return self.op(kind, Type::BOOL);
            }
            BinaryOp::Mul if self.is_product(left, right) => {
                return self.op(OpKind::MatrixProduct(left, right), ty);
            }
            BinaryOp::Mul => Binary::Multiply,
            BinaryOp::Div => Binary::Divide,
            BinaryOp::Rem => Binary::Remainder,
            BinaryOp::Add => Binary::Add,
            BinaryOp::Sub => Binary::Subtract,
            BinaryOp::ShiftLeft => Binary::ShiftLeft,
            BinaryOp::ShiftRight => Binary::ShiftRight,
            BinaryOp::Less => Binary::Less,
            BinaryOp::Greater => Binary::Greater,
            BinaryOp::LessEqual => Binary::LessEqual,
            BinaryOp::GreaterEqual => Binary::GreaterEqual,
            BinaryOp::BitAnd => Binary::BitAnd,
            BinaryOp::BitXor => Binary::BitXor,
            BinaryOp::BitOr => Binary::BitOr,
            BinaryOp::And => Binary::And,
            BinaryOp::Xor => Binary::Xor,
            BinaryOp::Or => Binary::Or,
        };
        let left = self.spread(left, right);
        let right = self.spread(right, left);
        self.op(OpKind::Binary(kind, left, right), ty)
    }

    /// Whether a product is a matrix product.
    fn is_product(&self, left: OpId, right: OpId) -> bool {
        let (left, right) = (self.module.ty(left), self.module.ty(right));
        left.is_matrix() && !right.is_scalar() || right.is_matrix() && !left.is_scalar()
    }

    /// Splats a scalar to the shape of the other operand; other values are returned unchanged.
    fn spread(&mut self, value: OpId, other: OpId) -> OpId {
        let (own, shape) = (self.module.ty(value), self.module.ty(other));
        let scalar = own.scalar_kind().unwrap_or(Scalar::Float);
        match own.is_scalar() && shape.components() > 1 {
            true => self.op(OpKind::Splat(value), shape.with_scalar(scalar)),
            false => value,
        }
    }
}
