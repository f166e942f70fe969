//! Matrix operations that naga lacks: it only multiplies and adds.

use super::body::Body;
use super::target::{Res, Value};
use super::types::Sink;
use ::naga::{BinaryOperator as Op, Expression, Handle, MathFunction, Statement};
use shaderlint_ir::{OpId, expand};
use shaderlint_semantic::{Scalar, Type};

impl Body<'_, '_> {
    /// An arithmetic operator on two matrices, component by component.
    pub(super) fn matrix(&mut self, op: Op, left: OpId, right: OpId) -> Res<Value> {
        let (l, r) = match (op, self.spread(left), self.spread(right)) {
            (Op::Multiply, _, Some(number)) => (left, number),
            (Op::Multiply, Some(number), None) => (number, right),
            (Op::Add | Op::Subtract, None, None) => (left, right),
            (Op::Divide, None, Some(number)) => {
                // As the browser divides, with its rounding.
                let (matrix, number) = (self.value(left)?, self.value(number)?);
                return Ok(self.over(matrix, number));
            }
            _ => return self.by_columns(op, left, right),
        };
        let (l, r) = (self.value(l)?, self.value(r)?);
        Ok(self.op(op, l, r))
    }

    /// A matrix multiplied by the reciprocal of a number.
    fn over(&mut self, matrix: Value, number: Value) -> Value {
        let one = self.float(1.0);
        let reciprocal = self.op(Op::Divide, one, number);
        self.op(Op::Multiply, matrix, reciprocal)
    }

    /// An arithmetic operator on two matrices, column by column.
    pub(super) fn by_columns(&mut self, op: Op, left: OpId, right: OpId) -> Res<Value> {
        let ty = self.lowerer.form.ty(left);
        let (columns, column) = columns(ty);
        let mut done = Vec::new();
        for i in 0..columns {
            let l = self.column(left, i, column)?;
            let r = self.column(right, i, column)?;
            done.push(self.op(op, l, r));
        }
        self.compose(ty, done)
    }

    fn column(&mut self, matrix: OpId, index: u32, column: Type) -> Res<Value> {
        if let Some(number) = self.spread(matrix) {
            let number = self.value(number)?;
            return Ok(self.splat(number, column));
        }
        let value = self.value(matrix)?;
        Ok(self.part(value, index))
    }

    /// `outerProduct`
    pub(super) fn outer_product(&mut self, column: Value, row: Value, ty: Type) -> Res<Value> {
        let mut done = Vec::new();
        for i in 0..columns(ty).0 {
            let factor = self.part(row, i);
            done.push(self.op(Op::Multiply, column, factor));
        }
        self.compose(ty, done)
    }

    /// `inverse`, as a generated function: not all target languages have it.
    pub(super) fn inverse(&mut self, value: Value, ty: Type) -> Res<Value> {
        let size = columns(ty).0 as u8;
        let function = match self.lowerer.inverses.get(&size) {
            Some(found) => *found,
            None => {
                let made = inverse(self, size, ty)?;
                self.lowerer.inverses.insert(size, made);
                made
            }
        };
        match self.call(function, vec![value], ty) {
            Some(value) => Ok(value),
            None => self.lowerer.refuse("cannot invert this matrix"),
        }
    }

    /// The cofactors over the determinant.
    fn cofactors(&mut self, matrix: Value, size: u8, ty: Type) -> Res<Value> {
        let size = size as usize;
        let mut cells = Vec::new();
        for c in 0..size {
            let column = self.part(matrix, c as u32);
            cells.extend((0..size).map(|r| self.part(column, r as u32)));
        }
        let determinant = self.math(MathFunction::Determinant, &[matrix]);
        let Some(cofactors) = expand::adjugate(self, &cells, size) else {
            return self.lowerer.refuse("this matrix is empty");
        };
        let mut done = Vec::new();
        for column in cofactors.chunks(size) {
            let column_ty = Type::vector(Scalar::Float, size as u8);
            done.push(self.compose(column_ty, column.to_vec())?);
        }
        let adjugate = self.compose(ty, done)?;
        Ok(self.over(adjugate, determinant))
    }
}

/// The number of columns of a matrix, and their type.
fn columns(ty: Type) -> (u32, Type) {
    let (scalar, columns, rows) = ty.numeric().unwrap_or((Scalar::Float, 1, 1));
    (columns as u32, Type::vector(scalar, rows))
}

/// Generates the function that inverts a matrix of a size.
fn inverse(body: &mut Body, size: u8, ty: Type) -> Res<Handle<::naga::Function>> {
    let inner = body.lowerer.ty(ty)?;
    let mut inverse = Body::new(body.lowerer, &format!("inverse{size}"));
    inverse.argument("m", inner);
    inverse.function.result = Some(::naga::FunctionResult {
        ty: inner,
        binding: None,
    });
    let matrix = inverse.add(Expression::FunctionArgument(0));
    let value = inverse.cofactors(matrix, size, ty)?;
    inverse.push(Statement::Return { value: Some(value) });
    let function = inverse.finish();
    body.lowerer.define(function)
}
