//! Prevents constant evaluation in target compilers. They reject constant expressions that GLSL
//! accepts and gives some value at run time: a division by zero, the square root of a negative
//! number, `clamp` with reversed limits.
//!
//! Constant expressions of GLSL are folded before, as in the browser. Other known operands are read
//! from a variable, which target compilers do not evaluate.

use super::body::Body;
use super::lower::NagaLowerer;
use super::target::Value;
use super::types::Sink;
use ::naga::proc::{ResolveContext, TypeResolution};
use ::naga::{
    Arena, BinaryOperator as Op, Expression, Handle, Literal, LocalVariable, MathFunction as F,
    Span, Statement, TypeInner,
};

impl Body<'_, '_> {
    /// Changes an expression so that a compiler cannot evaluate or reject it before run time.
    pub(super) fn at_run_time(&mut self, mut expression: Expression) -> Expression {
        let is_known = |it: &Self, value: &Value| it.known.contains(value);
        match &mut expression {
            Expression::Binary { op, left, right } if computes(*op) => {
                if is_known(self, left) && is_known(self, right) {
                    *left = self.hidden(*left);
                }
                if self.is_refused(*op, *right) {
                    *right = self.hidden(*right);
                }
            }
            Expression::Unary { expr, .. } | Expression::As { expr, .. }
                if is_known(self, expr) =>
            {
                *expr = self.hidden(*expr);
            }
            Expression::Math {
                fun,
                arg,
                arg1,
                arg2,
                ..
            } => {
                let bounds = match fun {
                    F::Clamp => arg1.as_mut().zip(arg2.as_mut()),
                    F::SmoothStep => Some(&mut *arg).zip(arg1.as_mut()),
                    _ => None,
                };
                if let Some((low, high)) = bounds
                    && self.are_reversed(*low, *high)
                {
                    *low = self.hidden(*low);
                }
                let others = [Some(*arg), *arg1, *arg2];
                if others.iter().flatten().all(|v| is_known(self, v)) {
                    *arg = self.hidden(*arg);
                }
            }
            _ => {}
        }
        expression
    }

    /// Whether a compiler can evaluate an expression.
    pub(super) fn is_known(&self, expression: &Expression) -> bool {
        let known = |value: &Value| self.known.contains(value);
        match expression {
            Expression::Literal(_) | Expression::Constant(_) | Expression::ZeroValue(_) => true,
            Expression::Compose { components, .. } => components.iter().all(known),
            Expression::Splat { value: inner, .. }
            | Expression::Swizzle { vector: inner, .. }
            | Expression::AccessIndex { base: inner, .. }
            | Expression::Relational {
                argument: inner, ..
            } => known(inner),
            Expression::Access { base, index } => known(base) && known(index),
            Expression::Binary { left, right, .. } => known(left) && known(right),
            Expression::Select {
                condition,
                accept,
                reject,
            } => [condition, accept, reject].into_iter().all(known),
            _ => false,
        }
    }

    /// Hides a known value in a variable.
    fn hidden(&mut self, value: Value) -> Value {
        let Some(ty) = self.type_of(value) else {
            return value;
        };
        let variable = LocalVariable {
            name: None,
            ty,
            init: None,
        };
        let span = Span::UNDEFINED;
        let handle = self.function.local_variables.append(variable, span);
        let pointer = self.add(Expression::LocalVariable(handle));
        self.push(Statement::Store { pointer, value });
        self.add(Expression::Load { pointer })
    }

    fn type_of(&mut self, value: Value) -> Option<Handle<::naga::Type>> {
        let function = &self.function;
        let (locals, arguments) = (&function.local_variables, &function.arguments);
        let context = ResolveContext::with_locals(&self.lowerer.module, locals, arguments);
        let grown = self.types.grow(value, &function.expressions, &context);
        grown.ok()?;
        Some(match self.types[value].clone() {
            TypeResolution::Handle(handle) => handle,
            TypeResolution::Value(inner) => self.lowerer.inner(None, inner),
        })
    }

    /// Whether compilers reject an operator because of its right operand alone.
    fn is_refused(&self, op: Op, right: Value) -> bool {
        let lanes = lanes(self.lowerer, &self.function.expressions, right);
        lanes.iter().any(|lane| match (op, lane) {
            (Op::Divide | Op::Modulo, Literal::I32(0) | Literal::U32(0)) => true,
            (Op::ShiftLeft | Op::ShiftRight, Literal::U32(by)) => *by >= u32::BITS,
            _ => false,
        })
    }

    /// Whether known limits are reversed or equal.
    fn are_reversed(&self, low: Value, high: Value) -> bool {
        let arena = &self.function.expressions;
        let low = lanes(self.lowerer, arena, low);
        let high = lanes(self.lowerer, arena, high);
        low.iter().zip(&high).any(|lanes| match lanes {
            (Literal::F32(low), Literal::F32(high)) => low >= high,
            (Literal::I32(low), Literal::I32(high)) => low > high,
            (Literal::U32(low), Literal::U32(high)) => low > high,
            _ => false,
        })
    }
}

/// Whether compilers may reject an operator.
fn computes(op: Op) -> bool {
    matches!(
        op,
        Op::Add
            | Op::Subtract
            | Op::Multiply
            | Op::Divide
            | Op::Modulo
            | Op::ShiftLeft
            | Op::ShiftRight
    )
}

/// The components of a value, as far as they are known.
fn lanes(lowerer: &NagaLowerer, arena: &Arena<Expression>, value: Value) -> Vec<Literal> {
    match &arena[value] {
        Expression::Literal(literal) => vec![*literal],
        Expression::Constant(constant) => {
            let constant = &lowerer.module.constants[*constant];
            lanes(lowerer, &lowerer.module.global_expressions, constant.init)
        }
        Expression::ZeroValue(ty) => zeros(&lowerer.module.types[*ty].inner),
        Expression::Splat { size, value } => {
            let all = lanes(lowerer, arena, *value);
            all.repeat(*size as usize)
        }
        Expression::Compose { components, .. } => {
            let parts = components.iter();
            parts.flat_map(|c| lanes(lowerer, arena, *c)).collect()
        }
        _ => Vec::new(),
    }
}

/// The components of a zero value.
fn zeros(ty: &TypeInner) -> Vec<Literal> {
    let (scalar, count) = match ty {
        TypeInner::Scalar(scalar) => (*scalar, 1),
        TypeInner::Vector { size, scalar } => (*scalar, *size as usize),
        _ => return Vec::new(),
    };
    Literal::zero(scalar).map_or(Vec::new(), |zero| vec![zero; count])
}
