//! Constructors (GLSL ES 3.00 section 5.4).

use super::body::Body;
use super::types::Sink;
use super::{Res, Value};
use crate::semantic::{Scalar, Type};
use crate::syntax::ast::{ExprId, List};
use ::naga::Expression;

impl Body<'_, '_> {
    /// `type(args)`
    pub(super) fn construct(&mut self, ty: Type, args: List) -> Res<Value> {
        let program = self.lowerer.program;
        let args = program.tree.args(args);
        let Some((scalar, columns, rows)) = ty.numeric() else {
            let parts: Res<Vec<Value>> = args.iter().map(|arg| self.value(*arg)).collect();
            let parts = parts?;
            return self.compose(ty, parts);
        };
        if let [only] = args {
            return self.single(*only, ty);
        }
        if columns == 1 {
            let parts = self.components(args, scalar, rows as usize, true)?;
            return self.compose(ty, parts);
        }
        let cells = self.components(args, scalar, columns as usize * rows as usize, false)?;
        let column = Type::vector(scalar, rows);
        let mut done = Vec::new();
        for cells in cells.chunks(rows as usize) {
            done.push(self.compose(column, cells.to_vec())?);
        }
        self.compose(ty, done)
    }

    /// The components of the arguments, converted; whole vectors where `keep` allows.
    fn components(
        &mut self,
        args: &[ExprId],
        scalar: Scalar,
        wanted: usize,
        keep: bool,
    ) -> Res<Vec<Value>> {
        let program = self.lowerer.program;
        let mut found = Vec::new();
        let mut count = 0;
        for arg in args {
            let ty = program.ty(*arg);
            let value = self.value(*arg)?;
            let (_, columns, rows) = ty.numeric().unwrap_or((scalar, 1, 1));
            for c in 0..columns as u32 {
                let column = if columns > 1 {
                    self.part(value, c)
                } else {
                    value
                };
                let column = self.converted(column, ty, scalar);
                if rows == 1 || keep && count + rows as usize <= wanted {
                    found.push(column);
                    count += rows as usize;
                    continue;
                }
                for r in 0..rows as u32 {
                    found.push(self.part(column, r));
                }
                count += rows as usize;
                if keep {
                    found.truncate(found.len() - count.saturating_sub(wanted));
                    count = count.min(wanted);
                }
            }
        }
        if !keep {
            found.truncate(wanted);
        }
        Ok(found)
    }

    /// A constructor with one argument.
    fn single(&mut self, arg: ExprId, ty: Type) -> Res<Value> {
        let from = self.lowerer.program.ty(arg);
        let (scalar, columns, rows) = ty.numeric().unwrap_or((Scalar::Float, 1, 1));
        let value = self.value(arg)?;
        let Some((_, from_columns, from_rows)) = from.numeric() else {
            return self.refuse(arg, "this cannot be converted");
        };
        if from == ty {
            return Ok(value);
        }
        if columns > 1 {
            return self.resized(value, from, ty);
        }
        if from.is_scalar() {
            let value = self.converted(value, from, scalar);
            return Ok(self.splat(value, ty));
        }
        if rows == 1 {
            let mut first = self.part(value, 0);
            if from_columns > 1 {
                first = self.part(first, 0);
            }
            return Ok(self.converted(first, from, scalar));
        }
        if from_columns > 1 {
            let mut cells = Vec::new();
            for c in 0..from_columns as u32 {
                let column = self.part(value, c);
                for r in 0..from_rows as u32 {
                    let cell = self.part(column, r);
                    cells.push(self.converted(cell, from, scalar));
                }
            }
            cells.truncate(rows as usize);
            return self.compose(ty, cells);
        }
        let value = self.converted(value, from, scalar);
        if rows == from_rows {
            return Ok(value);
        }
        let lanes: Vec<u32> = (0..rows as u32).collect();
        Ok(self.swizzle(value, &lanes))
    }

    /// A matrix out of a number, which goes on the diagonal, or of another matrix; what is missing
    /// comes from the identity.
    fn resized(&mut self, value: Value, from: Type, ty: Type) -> Res<Value> {
        let (_, columns, rows) = ty.numeric().unwrap_or((Scalar::Float, 2, 2));
        let (_, has_columns, has_rows) = from.numeric().unwrap_or((Scalar::Float, 1, 1));
        let value = if from.is_scalar() {
            self.converted(value, from, Scalar::Float)
        } else if from.is_vector() {
            return self.filled(value, from, ty);
        } else {
            value
        };
        let mut done = Vec::new();
        for c in 0..columns {
            let own = match from.is_matrix() && c < has_columns {
                true => Some(self.part(value, c as u32)),
                false => None,
            };
            let mut cells = Vec::new();
            for r in 0..rows {
                cells.push(match own {
                    Some(column) if r < has_rows => self.part(column, r as u32),
                    _ if c == r && from.is_scalar() => value,
                    _ => self.float(if c == r { 1.0 } else { 0.0 }),
                });
            }
            done.push(self.compose(Type::vector(Scalar::Float, rows), cells)?);
        }
        self.compose(ty, done)
    }

    /// `mat2(vec4)`, the one matrix that a vector fills.
    fn filled(&mut self, value: Value, from: Type, ty: Type) -> Res<Value> {
        let (_, columns, rows) = ty.numeric().unwrap_or((Scalar::Float, 2, 2));
        if from.components() < ty.components() {
            return self.lowerer.refuse("this does not fill the matrix");
        }
        let value = self.converted(value, from, Scalar::Float);
        let mut done = Vec::new();
        for c in 0..columns as u32 {
            let rows = rows as u32;
            let cells: Vec<u32> = (c * rows..(c + 1) * rows).collect();
            done.push(self.swizzle(value, &cells));
        }
        self.compose(ty, done)
    }

    /// A number or vector made of another scalar, unless it is so already.
    fn converted(&mut self, value: Value, from: Type, scalar: Scalar) -> Value {
        if from.scalar_kind() == Some(scalar) {
            value
        } else {
            self.convert(value, scalar)
        }
    }

    /// A function of naga.
    pub(super) fn math(&mut self, fun: ::naga::MathFunction, args: &[Value]) -> Value {
        let arg = |i: usize| args.get(i).copied();
        match arg(0) {
            Some(first) => self.add(Expression::Math {
                fun,
                arg: first,
                arg1: arg(1),
                arg2: arg(2),
                arg3: arg(3),
            }),
            None => self.float(0.0),
        }
    }
}
