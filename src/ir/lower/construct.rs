//! Lowering of constructors (GLSL ES 3.00 section 5.4) to components.

use super::super::form::*;
use super::Lowerer;
use shaderlint_semantic::{Scalar, Type};
use shaderlint_syntax::ast::List;

/// A component of a value; those of a matrix are in column-major order.
#[derive(Clone, Copy)]
struct Component {
    of: OpId,
    number: u32,
}

impl Lowerer<'_> {
    /// Lowers the constructor of a struct, one argument per member.
    pub(super) fn record(&mut self, args: List, ty: Type) -> OpId {
        let members = self.values(args);
        self.compose(&members, ty)
    }

    /// Lowers the constructor of a built-in type or array.
    pub(super) fn construct(&mut self, args: List, ty: Type) -> OpId {
        let values = self.values(args);
        if ty.is_array() {
            return self.compose(&values, ty);
        }
        let Some((scalar, columns, rows)) = ty.numeric() else {
            return self.op(OpKind::Unknown, ty);
        };
        let sizes = values.iter().map(|v| self.module.ty(*v).components());
        if sizes.clone().any(|size| size == 0) || values.is_empty() {
            return self.op(OpKind::Unknown, ty);
        }
        let values: Vec<OpId> = values
            .into_iter()
            .map(|v| self.converted(v, scalar))
            .collect();
        match values[..] {
            [one] if self.module.ty(one) == ty => one,
            [one] if self.module.ty(one).is_scalar() && columns == 1 => {
                self.op(OpKind::Splat(one), ty)
            }
            [one] if self.module.ty(one).is_scalar() => self.diagonal(one, columns, rows),
            [one] if self.module.ty(one).is_matrix() && columns > 1 => {
                self.resized(one, columns, rows)
            }
            // The common case: one scalar argument per component.
            _ if columns == 1 && self.are_scalars(&values, rows) => self.compose(&values, ty),
            _ if columns == 1 => {
                let components = self.components(&values, rows as usize);
                self.gather(&components, ty)
            }
            _ => {
                let all = self.components(&values, columns as usize * rows as usize);
                let column = Type::vector(scalar, rows);
                let made = all.chunks(rows as usize);
                let made: Vec<OpId> = made.map(|c| self.gather(c, column)).collect();
                self.compose(&made, ty)
            }
        }
    }

    fn are_scalars(&self, values: &[OpId], count: u8) -> bool {
        let is_scalar = |v: &OpId| self.module.ty(*v).is_scalar();
        values.len() == count as usize && values.iter().all(is_scalar)
    }

    fn compose(&mut self, parts: &[OpId], ty: Type) -> OpId {
        let parts = self.operands(parts);
        self.op(OpKind::Compose(parts), ty)
    }

    /// Converts a value to another scalar type, with the same shape.
    fn converted(&mut self, value: OpId, scalar: Scalar) -> OpId {
        let ty = self.module.ty(value);
        match ty.scalar_kind() == Some(scalar) {
            true => value,
            false => self.op(OpKind::Convert(value), ty.with_scalar(scalar)),
        }
    }

    /// The first `expected` components of a sequence of values.
    fn components(&self, values: &[OpId], expected: usize) -> Vec<Component> {
        let each = |of: &OpId| {
            let of = *of;
            (0..self.module.ty(of).components()).map(move |number| Component { of, number })
        };
        values.iter().flat_map(each).take(expected).collect()
    }

    /// Composes a scalar or vector from components; adjacent components of one vector become one
    /// swizzle.
    fn gather(&mut self, components: &[Component], ty: Type) -> OpId {
        let mut parts = Vec::with_capacity(components.len());
        let mut rest = components;
        while let Some(&first) = rest.first() {
            let (of, from) = self.vector_of(first);
            let row = self.module.ty(of).components();
            let len = rest
                .iter()
                .zip(first.number..)
                .take_while(|(c, number)| c.of == first.of && c.number == *number)
                .take(row.saturating_sub(from) as usize)
                .count()
                .max(1);
            parts.push(self.picked_components(of, from, len as u32));
            rest = rest.get(len..).unwrap_or(&[]);
        }
        match parts[..] {
            [one] if self.module.ty(one) == ty => one,
            _ => self.compose(&parts, ty),
        }
    }

    /// The vector that contains a component (for a matrix, the column), and its index there.
    fn vector_of(&mut self, component: Component) -> (OpId, u32) {
        let ty = self.module.ty(component.of);
        match ty.numeric() {
            Some((scalar, 2.., rows)) => {
                let column = component.number / rows as u32;
                let column = self.op(
                    OpKind::Extract(component.of, column),
                    Type::vector(scalar, rows),
                );
                (column, component.number % rows as u32)
            }
            _ => (component.of, component.number),
        }
    }

    /// Consecutive components of a vector; the vector itself if these are all.
    fn picked_components(&mut self, of: OpId, from: u32, len: u32) -> OpId {
        let ty = self.module.ty(of);
        if from == 0 && len == ty.components() {
            return of;
        }
        let scalar = ty.scalar_kind().unwrap_or(Scalar::Float);
        let lanes = Lanes::new((from..from + len).map(|n| n as u8));
        self.op(OpKind::Swizzle(of, lanes), Type::vector(scalar, len as u8))
    }

    /// `mat3(1.0)`: the scalar on the diagonal, zero elsewhere.
    fn diagonal(&mut self, scalar: OpId, columns: u8, rows: u8) -> OpId {
        let zero = self.number(0, Type::FLOAT);
        let column = Type::vector(Scalar::Float, rows);
        let made: Vec<OpId> = (0..columns)
            .map(|c| {
                let row = |r| if r == c { scalar } else { zero };
                let parts: Vec<OpId> = (0..rows).map(row).collect();
                self.compose(&parts, column)
            })
            .collect();
        self.compose(&made, Type::matrix(columns, rows))
    }

    /// A matrix constructed from a matrix of another size; missing cells are those of the identity
    /// matrix.
    fn resized(&mut self, matrix: OpId, columns: u8, rows: u8) -> OpId {
        let Some((_, known, height)) = self.module.ty(matrix).numeric() else {
            return matrix;
        };
        let is_grown = columns > known || rows > height;
        let identity = is_grown.then(|| [0, 1].map(|n| self.number(n, Type::FLOAT)));
        let of_identity = |r, c| identity.map(|[zero, one]| if r == c { one } else { zero });
        let mut made = Vec::with_capacity(columns as usize);
        for c in 0..columns {
            let mut parts = Vec::with_capacity(4);
            if c < known {
                let ty = Type::vector(Scalar::Float, height);
                let column = self.op(OpKind::Extract(matrix, c as u32), ty);
                parts.push(self.picked_components(column, 0, height.min(rows) as u32));
                parts.extend((height..rows).filter_map(|r| of_identity(r, c)));
            } else {
                parts.extend((0..rows).filter_map(|r| of_identity(r, c)));
            }
            made.push(match parts[..] {
                [whole] => whole,
                _ => self.compose(&parts, Type::vector(Scalar::Float, rows)),
            });
        }
        self.compose(&made, Type::matrix(columns, rows))
    }
}
