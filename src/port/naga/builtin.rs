//! The functions of the language.

use super::body::Body;
use super::types::Sink;
use super::{Res, Value, lower::Origin};
use crate::semantic::{Scalar, Type};
use crate::syntax::ast::ExprId;
use ::naga::{
    BinaryOperator as Op, DerivativeAxis, DerivativeControl, Expression, Literal,
    MathFunction as F, RelationalFunction, ScalarKind, UnaryOperator,
};

impl Body<'_, '_> {
    /// A call of a function of the language.
    pub(super) fn builtin(&mut self, id: ExprId, name: &str, args: &[ExprId]) -> Res<Value> {
        let program = self.lowerer.program;
        if name.starts_with("tex") || name.starts_with("shadow") {
            return self.texture(id, name, args);
        }
        if let (true, &[x, whole]) = (name == "modf", args) {
            return self.modf(x, whole);
        }
        let ty = program.ty(id);
        let mut values = Vec::new();
        for arg in args {
            values.push((self.value(*arg)?, program.ty(*arg)));
        }
        if let Some(fun) = direct(name, args.len()) {
            // A number among vectors goes with every component.
            let wide = values.iter().map(|v| v.1).find(|t| t.is_vector());
            let spread: Vec<Value> = values
                .iter()
                .map(|(value, ty)| self.widen(*value, *ty, wide.unwrap_or(*ty)))
                .collect();
            return Ok(self.math(fun, &spread));
        }
        let plain: Vec<Value> = values.iter().map(|v| v.0).collect();
        if let Some(op) = relation(name)
            && let [l, r] = plain[..]
        {
            return Ok(self.op(op, l, r));
        }
        let first = values.first().map_or(Type::FLOAT, |v| v.1);
        match (name, &plain[..]) {
            ("mod", &[x, y]) => {
                let y = values
                    .get(1)
                    .map_or(y, |(y, ty)| self.widen(*y, *ty, first));
                Ok(self.modulo(x, y))
            }
            ("mix", &[x, y, a]) => Ok(self.mix(x, y, (a, program.ty(args[2])), first)),
            ("refract", &[i, n, eta]) if first.is_vector() => {
                Ok(self.math(F::Refract, &[i, n, eta]))
            }
            ("matrixCompMult", &[l, r]) => self.by_columns(Op::Multiply, (l, ty), (r, ty)),
            ("outerProduct", &[column, row]) => self.outer_product(column, row, ty),
            ("inverse", &[matrix]) => self.inverse(matrix, ty),
            ("not", &[expr]) => {
                let op = UnaryOperator::LogicalNot;
                Ok(self.add(Expression::Unary { op, expr }))
            }
            ("any" | "all", &[argument]) => {
                let fun = match name {
                    "any" => RelationalFunction::Any,
                    _ => RelationalFunction::All,
                };
                Ok(self.add(Expression::Relational { fun, argument }))
            }
            ("isnan" | "isinf", &[x]) => self.special(name, x, first),
            ("floatBitsToInt", &[x]) => Ok(self.cast(x, ScalarKind::Sint, None)),
            ("floatBitsToUint", &[x]) => Ok(self.cast(x, ScalarKind::Uint, None)),
            ("intBitsToFloat" | "uintBitsToFloat", &[x]) => {
                Ok(self.cast(x, ScalarKind::Float, None))
            }
            ("dFdx" | "dFdy" | "fwidth", &[expr]) => self.derivative(name, expr, first),
            _ => match self.geometry(name, &plain, first) {
                Some(value) => value,
                None => self.refuse(id, format!("`{name}` has no counterpart")),
            },
        }
    }

    /// What naga only knows of vectors, and GLSL of single numbers too.
    fn geometry(&mut self, name: &str, args: &[Value], ty: Type) -> Option<Res<Value>> {
        let fun = match name {
            "dot" => F::Dot,
            "normalize" => F::Normalize,
            "reflect" => F::Reflect,
            "faceforward" => F::FaceForward,
            "refract" => F::Refract,
            _ => return None,
        };
        if ty.is_vector() {
            return Some(Ok(self.math(fun, args)));
        }
        Some(Ok(match (fun, args) {
            (F::Dot, &[x, y]) => self.op(Op::Multiply, x, y),
            (F::Normalize, &[x]) => self.math(F::Sign, &[x]),
            (F::Reflect, &[i, n]) => {
                let square = self.op(Op::Multiply, n, n);
                let both = self.op(Op::Multiply, square, i);
                let two = self.float(2.0);
                let turned = self.op(Op::Multiply, two, both);
                self.op(Op::Subtract, i, turned)
            }
            (F::FaceForward, &[n, i, reference]) => {
                let dot = self.op(Op::Multiply, reference, i);
                let zero = self.float(0.0);
                let is_facing = self.op(Op::Less, dot, zero);
                let op = UnaryOperator::Negate;
                let turned = self.add(Expression::Unary { op, expr: n });
                self.select(is_facing, n, turned)
            }
            (F::Refract, &[i, n, eta]) => self.refract(i, n, eta),
            _ => return None,
        }))
    }

    /// `refract` of single numbers, by the formula of section 8.5.
    fn refract(&mut self, i: Value, n: Value, eta: Value) -> Value {
        let (one, zero) = (self.float(1.0), self.float(0.0));
        let dot = self.op(Op::Multiply, n, i);
        let square = self.op(Op::Multiply, dot, dot);
        let rest = self.op(Op::Subtract, one, square);
        let etas = self.op(Op::Multiply, eta, eta);
        let share = self.op(Op::Multiply, etas, rest);
        let k = self.op(Op::Subtract, one, share);
        let inside = self.math(F::Max, &[k, zero]);
        let root = self.math(F::Sqrt, &[inside]);
        let along = self.op(Op::Multiply, eta, dot);
        let sum = self.op(Op::Add, along, root);
        let back = self.op(Op::Multiply, sum, n);
        let on = self.op(Op::Multiply, eta, i);
        let turned = self.op(Op::Subtract, on, back);
        let is_total = self.op(Op::Less, k, zero);
        self.select(is_total, zero, turned)
    }

    /// `x - y * floor(x / y)`; the `%` of naga cuts towards zero.
    fn modulo(&mut self, x: Value, y: Value) -> Value {
        let ratio = self.op(Op::Divide, x, y);
        let floor = self.math(F::Floor, &[ratio]);
        let whole = self.op(Op::Multiply, y, floor);
        self.op(Op::Subtract, x, whole)
    }

    fn mix(&mut self, x: Value, y: Value, (a, a_ty): (Value, Type), ty: Type) -> Value {
        if a_ty.scalar_kind() == Some(Scalar::Bool) {
            return self.select(a, y, x);
        }
        let a = self.widen(a, a_ty, ty);
        self.math(F::Mix, &[x, y, a])
    }

    /// The whole part goes to the second argument.
    fn modf(&mut self, x: ExprId, whole: ExprId) -> Res<Value> {
        let x = self.value(x)?;
        let place = self.place(whole)?;
        let cut = self.math(F::Trunc, &[x]);
        let rest = self.op(Op::Subtract, x, cut);
        self.write(&place, cut);
        Ok(rest)
    }

    /// `isnan`, `isinf` by the bits: WGSL has neither, and others take them for never true.
    fn special(&mut self, name: &str, x: Value, ty: Type) -> Res<Value> {
        let bits = self.cast(x, ScalarKind::Uint, None);
        let ty = ty.with_scalar(Scalar::Uint);
        let mut word = |bits| {
            let value = self.add(Expression::Literal(Literal::U32(bits)));
            self.splat(value, ty)
        };
        let (all, infinity) = (word(0x7fff_ffff), word(0x7f80_0000));
        let positive = self.op(Op::And, bits, all);
        let op = match name {
            "isnan" => Op::Greater,
            _ => Op::Equal,
        };
        Ok(self.op(op, positive, infinity))
    }

    /// Where rows are turned, so is the direction of `dFdy`.
    fn derivative(&mut self, name: &str, expr: Value, ty: Type) -> Res<Value> {
        let axis = match name {
            "dFdx" => DerivativeAxis::X,
            "dFdy" => DerivativeAxis::Y,
            _ => DerivativeAxis::Width,
        };
        let ctrl = DerivativeControl::None;
        let value = self.add(Expression::Derivative { axis, ctrl, expr });
        match (name, self.lowerer.origin) {
            ("dFdy", Origin::Picture) => self.negate(value, ty),
            _ => Ok(value),
        }
    }
}

/// Functions that are the same in naga.
fn direct(name: &str, count: usize) -> Option<F> {
    Some(match name {
        "atan" if count == 2 => F::Atan2,
        "atan" => F::Atan,
        "radians" => F::Radians,
        "degrees" => F::Degrees,
        "sin" => F::Sin,
        "cos" => F::Cos,
        "tan" => F::Tan,
        "asin" => F::Asin,
        "acos" => F::Acos,
        "sinh" => F::Sinh,
        "cosh" => F::Cosh,
        "tanh" => F::Tanh,
        "asinh" => F::Asinh,
        "acosh" => F::Acosh,
        "atanh" => F::Atanh,
        "pow" => F::Pow,
        "exp" => F::Exp,
        "log" => F::Log,
        "exp2" => F::Exp2,
        "log2" => F::Log2,
        "sqrt" => F::Sqrt,
        "inversesqrt" => F::InverseSqrt,
        "abs" => F::Abs,
        "sign" => F::Sign,
        "floor" => F::Floor,
        "trunc" => F::Trunc,
        "round" | "roundEven" => F::Round,
        "ceil" => F::Ceil,
        "fract" => F::Fract,
        "min" => F::Min,
        "max" => F::Max,
        "clamp" => F::Clamp,
        "step" => F::Step,
        "smoothstep" => F::SmoothStep,
        "packSnorm2x16" => F::Pack2x16snorm,
        "unpackSnorm2x16" => F::Unpack2x16snorm,
        "packUnorm2x16" => F::Pack2x16unorm,
        "unpackUnorm2x16" => F::Unpack2x16unorm,
        "packHalf2x16" => F::Pack2x16float,
        "unpackHalf2x16" => F::Unpack2x16float,
        "length" => F::Length,
        "distance" => F::Distance,
        "cross" => F::Cross,
        "transpose" => F::Transpose,
        "determinant" => F::Determinant,
        _ => return None,
    })
}

fn relation(name: &str) -> Option<Op> {
    Some(match name {
        "lessThan" => Op::Less,
        "lessThanEqual" => Op::LessEqual,
        "greaterThan" => Op::Greater,
        "greaterThanEqual" => Op::GreaterEqual,
        "equal" => Op::Equal,
        "notEqual" => Op::NotEqual,
        _ => return None,
    })
}
