//! Built-in functions.

use super::body::Body;
use super::target::{FirstRow, Res, TargetLanguage, Value};
use super::types::Sink;
use ::naga::{
    BinaryOperator as Op, DerivativeAxis, DerivativeControl, Expression, Handle, Literal,
    MathFunction as F, RelationalFunction, ScalarKind, Statement, UnaryOperator,
};
use shaderlint_ir::OpId;
use shaderlint_ir::expand::{self, Arithmetic, Operator};
use shaderlint_semantic::builtins::Axis;
use shaderlint_semantic::{BuiltinId, Scalar, Type};

impl Body<'_, '_> {
    /// Lowers a call of a built-in function.
    pub(super) fn builtin(
        &mut self,
        id: OpId,
        function: BuiltinId,
        operands: &[OpId],
    ) -> Res<Value> {
        let form = self.lowerer.form;
        if function.kind().is_texture() {
            return self.texture(function.kind(), operands, form.ty(id));
        }
        let how = lowering(function);
        if let (Lowering::ByColumns(op), &[l, r]) = (&how, operands) {
            return self.by_columns(*op, l, r);
        }
        // A scalar among vectors applies to every component, except in `refract`.
        let mut types = operands.iter().map(|o| form.ty(*o));
        let first = types.next().unwrap_or(Type::FLOAT);
        let wide = types.chain([first]).find(|t| t.is_vector());
        let wide = wide.filter(|_| !matches!(how, Lowering::OfVectors(_)));
        let mut values = Vec::new();
        for operand in operands {
            let value = self.value(*operand)?;
            values.push(match wide {
                Some(wide) if form.ty(*operand).is_scalar() => self.splat(value, wide),
                _ => value,
            });
        }
        match (how, &values[..]) {
            (Lowering::ArcTangent, [_, _]) => Ok(self.math(F::Atan2, &values)),
            (Lowering::ArcTangent, _) => Ok(self.math(F::Atan, &values)),
            (Lowering::Math(fun), _) => Ok(self.math(fun, &values)),
            (Lowering::OfVectors(fun), _) if first.is_vector() => Ok(self.math(fun, &values)),
            (Lowering::OfVectors(fun), _) => match self.geometry(fun, &values) {
                Some(value) => Ok(value),
                None => self.without_counterpart(function),
            },
            (Lowering::Relation(op), &[l, r]) => Ok(self.op(op, l, r)),
            (Lowering::Reduction(fun), &[argument]) => {
                Ok(self.add(Expression::Relational { fun, argument }))
            }
            (Lowering::Bits(kind), &[x]) => Ok(self.cast(x, kind, None)),
            (Lowering::Unusual(op), &[x]) => Ok(self.unusual(op, x, first)),
            (Lowering::Derivative(axis), &[expr]) => self.derivative(axis, expr, first),
            (Lowering::Not, &[expr]) => {
                let op = UnaryOperator::LogicalNot;
                Ok(self.add(Expression::Unary { op, expr }))
            }
            (Lowering::Modulo, &[x, y]) => Ok(self.modulo(x, y)),
            (Lowering::SmoothStep, &[low, high, x]) => match self.lowerer.language {
                TargetLanguage::Wgsl => self.smoothstep([low, high, x], wide.unwrap_or(first)),
                _ => Ok(self.math(F::SmoothStep, &values)),
            },
            (Lowering::Fraction, &[x]) => {
                let integral = self.math(F::Trunc, &[x]);
                Ok(self.op(Op::Subtract, x, integral))
            }
            (Lowering::Mix, &[x, y, share]) => {
                let share_is = operands.last().and_then(|o| form.scalar(*o));
                Ok(match share_is {
                    Some(Scalar::Bool) => self.select(share, y, x),
                    _ => self.math(F::Mix, &values),
                })
            }
            (Lowering::OuterProduct, &[column, row]) => {
                self.outer_product(column, row, form.ty(id))
            }
            (Lowering::Inverse, &[matrix]) => self.inverse(matrix, first),
            _ => self.without_counterpart(function),
        }
    }

    fn without_counterpart<T>(&self, function: BuiltinId) -> Res<T> {
        let message = format!(
            "`{}` has no equivalent in the target language",
            function.name()
        );
        self.lowerer.refuse(message)
    }

    /// Functions that naga has only for vectors, and GLSL also for scalars.
    fn geometry(&mut self, fun: F, args: &[Value]) -> Option<Value> {
        Some(match (fun, args) {
            (F::Dot, &[x, y]) => self.op(Op::Multiply, x, y),
            (F::Normalize, &[x]) => self.math(F::Sign, &[x]),
            (F::Reflect, &[i, n]) => *expand::reflect(self, &[i], &[n]).first()?,
            (F::FaceForward, &[n, i, reference]) => {
                let made = expand::face_forward(self, [&[n], &[i], &[reference]]);
                *made.first()?
            }
            (F::Refract, &[i, n, eta]) => *expand::refract(self, &[i], &[n], eta).first()?,
            _ => return None,
        })
    }

    /// `x - y * floor(x / y)`; naga's `%` truncates towards zero.
    fn modulo(&mut self, x: Value, y: Value) -> Value {
        let ratio = self.op(Op::Divide, x, y);
        let floor = self.math(F::Floor, &[ratio]);
        let integral = self.op(Op::Multiply, y, floor);
        self.op(Op::Subtract, x, integral)
    }

    /// `smoothstep` as a generated function: WebGPU's compiler multiplies in another order than WebGL's.
    fn smoothstep(&mut self, values: [Value; 3], ty: Type) -> Res<Value> {
        let function = match self.lowerer.smoothsteps.get(&ty) {
            Some(found) => *found,
            None => {
                let made = smoothstep(self, ty)?;
                self.lowerer.smoothsteps.insert(ty, made);
                made
            }
        };
        match self.call(function, values.to_vec(), ty) {
            Some(value) => Ok(value),
            None => self.without_counterpart(BuiltinId::Smoothstep),
        }
    }

    /// `isnan` and `isinf` by bits: WGSL has neither, and other compilers assume that they are
    /// never true. `op` compares the bits with those of infinity.
    fn unusual(&mut self, op: Op, x: Value, ty: Type) -> Value {
        let bits = self.cast(x, ScalarKind::Uint, None);
        let ty = ty.with_scalar(Scalar::Uint);
        let mut word = |bits| {
            let value = self.add(Expression::Literal(Literal::U32(bits)));
            self.splat(value, ty)
        };
        let (all, infinity) = (word(0x7fff_ffff), word(0x7f80_0000));
        let positive = self.op(Op::And, bits, all);
        self.op(op, positive, infinity)
    }

    /// If rows are flipped, so is the direction of `dFdy`.
    fn derivative(&mut self, axis: Axis, expr: Value, ty: Type) -> Res<Value> {
        let derivative = match axis {
            Axis::X => DerivativeAxis::X,
            Axis::Y => DerivativeAxis::Y,
            Axis::Both => DerivativeAxis::Width,
        };
        let value = self.add(Expression::Derivative {
            axis: derivative,
            ctrl: DerivativeControl::None,
            expr,
        });
        match (axis, self.lowerer.origin) {
            (Axis::Y, FirstRow::Top) => self.negate(value, ty),
            _ => Ok(value),
        }
    }
}

/// Generates the function `smoothstep` of a type.
fn smoothstep(body: &mut Body, ty: Type) -> Res<Handle<::naga::Function>> {
    let inner = body.lowerer.ty(ty)?;
    let name = format!("smoothstep{}", ty.components());
    let mut made = Body::new(body.lowerer, &name);
    made.function.result = Some(::naga::FunctionResult {
        ty: inner,
        binding: None,
    });
    let [low, high, x] = ["low", "high", "x"].map(|name| made.argument(name, inner));
    let [zero, one, two, three] = [0.0, 1.0, 2.0, 3.0].map(|value| {
        let value = made.float(value);
        made.splat(value, ty)
    });
    let distance = made.op(Op::Subtract, x, low);
    let width = made.op(Op::Subtract, high, low);
    let share = made.op(Op::Divide, distance, width);
    let t = made.math(F::Clamp, &[share, zero, one]);
    made.name(t, "t");
    let square = made.op(Op::Multiply, t, t);
    let double = made.op(Op::Multiply, two, t);
    let rest = made.op(Op::Subtract, three, double);
    let value = made.op(Op::Multiply, square, rest);
    made.push(Statement::Return { value: Some(value) });
    let function = made.finish();
    body.lowerer.define(function)
}

impl Arithmetic for Body<'_, '_> {
    type Value = Value;

    fn number(&mut self, value: f32) -> Value {
        self.float(value)
    }

    fn binary(&mut self, op: Operator, left: Value, right: Value) -> Value {
        let op = match op {
            Operator::Add => Op::Add,
            Operator::Subtract => Op::Subtract,
            Operator::Multiply => Op::Multiply,
            Operator::Less => Op::Less,
        };
        self.op(op, left, right)
    }

    fn negated(&mut self, expr: Value) -> Value {
        let op = UnaryOperator::Negate;
        self.add(Expression::Unary { op, expr })
    }

    fn sqrt(&mut self, value: Value) -> Value {
        let zero = self.float(0.0);
        let inside = self.math(F::Max, &[value, zero]);
        self.math(F::Sqrt, &[inside])
    }

    fn choose(&mut self, condition: Value, then: Value, otherwise: Value) -> Value {
        self.select(condition, then, otherwise)
    }

    fn dot(&mut self, left: &[Value], right: &[Value]) -> Value {
        let products = left.iter().zip(right);
        let products: Vec<Value> = products
            .map(|(l, r)| self.op(Op::Multiply, *l, *r))
            .collect();
        let sum = products
            .into_iter()
            .reduce(|sum, next| self.op(Op::Add, sum, next));
        sum.unwrap_or_else(|| self.float(0.0))
    }
}

/// How a function is lowered to naga.
enum Lowering {
    /// To the same function.
    Math(F),
    /// To the same function, which naga has only for vectors.
    OfVectors(F),
    /// To an operator that compares component by component.
    Relation(Op),
    /// To a reduction of several `bool` values.
    Reduction(RelationalFunction),
    /// To a bit cast to another scalar type.
    Bits(ScalarKind),
    /// To a comparison of the bits with those of infinity.
    Unusual(Op),
    Derivative(Axis),
    /// To an operator on each column.
    ByColumns(Op),
    /// To one of two functions, depending on the number of arguments.
    ArcTangent,
    /// To the expansion of `mod`.
    Modulo,
    /// To the same function, or to a generated one.
    SmoothStep,
    /// To the fractional part; for `modf`, whose integer part is a separate operation.
    Fraction,
    /// To a selection or an interpolation, depending on the type of the last argument.
    Mix,
    /// To `!` on each component.
    Not,
    /// To the expansion of `outerProduct`.
    OuterProduct,
    /// To a generated function.
    Inverse,
    /// Lowered elsewhere, or not supported.
    Apart,
}

#[rustfmt::skip]
fn lowering(function: BuiltinId) -> Lowering {
    use BuiltinId as B;
    use Lowering::*;
    match function {
        B::Radians => Math(F::Radians), B::Degrees => Math(F::Degrees), B::Sin => Math(F::Sin),
        B::Cos => Math(F::Cos), B::Tan => Math(F::Tan), B::Asin => Math(F::Asin),
        B::Acos => Math(F::Acos), B::Sinh => Math(F::Sinh), B::Cosh => Math(F::Cosh),
        B::Tanh => Math(F::Tanh), B::Asinh => Math(F::Asinh), B::Acosh => Math(F::Acosh),
        B::Atanh => Math(F::Atanh), B::Pow => Math(F::Pow), B::Exp => Math(F::Exp),
        B::Log => Math(F::Log), B::Exp2 => Math(F::Exp2), B::Log2 => Math(F::Log2),
        B::Sqrt => Math(F::Sqrt), B::InverseSqrt => Math(F::InverseSqrt), B::Abs => Math(F::Abs),
        B::Sign => Math(F::Sign), B::Floor => Math(F::Floor), B::Trunc => Math(F::Trunc),
        B::Round | B::RoundEven => Math(F::Round), B::Ceil => Math(F::Ceil),
        B::Fract => Math(F::Fract), B::Min => Math(F::Min), B::Max => Math(F::Max),
        B::Clamp => Math(F::Clamp), B::Step => Math(F::Step),
        B::Smoothstep => SmoothStep, B::PackSnorm2x16 => Math(F::Pack2x16snorm),
        B::UnpackSnorm2x16 => Math(F::Unpack2x16snorm),
        B::PackUnorm2x16 => Math(F::Pack2x16unorm),
        B::UnpackUnorm2x16 => Math(F::Unpack2x16unorm), B::PackHalf2x16 => Math(F::Pack2x16float),
        B::UnpackHalf2x16 => Math(F::Unpack2x16float), B::Length => Math(F::Length),
        B::Distance => Math(F::Distance), B::Cross => Math(F::Cross),
        B::Transpose => Math(F::Transpose), B::Determinant => Math(F::Determinant),
        B::Dot => OfVectors(F::Dot), B::Normalize => OfVectors(F::Normalize),
        B::Reflect => OfVectors(F::Reflect), B::FaceForward => OfVectors(F::FaceForward),
        B::Refract => OfVectors(F::Refract), B::LessThan => Relation(Op::Less),
        B::LessThanEqual => Relation(Op::LessEqual), B::GreaterThan => Relation(Op::Greater),
        B::GreaterThanEqual => Relation(Op::GreaterEqual), B::Equal => Relation(Op::Equal),
        B::NotEqual => Relation(Op::NotEqual), B::Any => Reduction(RelationalFunction::Any),
        B::All => Reduction(RelationalFunction::All), B::Not => Not,
        B::IsNan => Unusual(Op::Greater), B::IsInf => Unusual(Op::Equal),
        B::FloatBitsToInt => Bits(ScalarKind::Sint), B::FloatBitsToUint => Bits(ScalarKind::Uint),
        B::IntBitsToFloat | B::UintBitsToFloat => Bits(ScalarKind::Float),
        B::DFdx => Derivative(Axis::X), B::DFdy => Derivative(Axis::Y),
        B::Fwidth => Derivative(Axis::Both), B::Atan => ArcTangent, B::Mod => Modulo,
        B::Modf => Fraction, B::Mix => Mix, B::MatrixCompMult => ByColumns(Op::Multiply),
        B::OuterProduct => OuterProduct, B::Inverse => Inverse,
        B::TextureSize | B::Texture | B::TextureOffset | B::TextureLod
        | B::TextureLodOffset | B::TextureGrad | B::TextureGradOffset | B::TextureProj
        | B::TextureProjOffset | B::TextureProjLod | B::TextureProjLodOffset | B::TextureProjGrad
        | B::TextureProjGradOffset | B::TexelFetch | B::TexelFetchOffset | B::Texture2D
        | B::Texture2DProj | B::Texture2DLod | B::Texture2DProjLod | B::TextureCube
        | B::TextureCubeLod | B::Texture2DLodExt | B::Texture2DProjLodExt | B::TextureCubeLodExt
        | B::Texture2DGradExt | B::Texture2DProjGradExt | B::TextureCubeGradExt
        | B::InterpolateAtCentroid | B::InterpolateAtSample | B::InterpolateAtOffset => Apart,
    }
}
