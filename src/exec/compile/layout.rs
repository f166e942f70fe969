//! How values lie in scalars: a vector by components, a matrix by columns, an array by elements, a
//! struct by members.

use shaderlint_semantic::{Base, Program, Type};

/// Most scalars of a value.
pub(super) const MAX_SCALARS: u32 = 1 << 15;

/// How many scalars a type has: `None` for too many, or where that is not known.
pub(super) fn scalars(program: &Program, ty: Type) -> Option<u32> {
    let one = match ty.base {
        Base::Numeric { columns, rows, .. } => columns as u32 * rows as u32,
        Base::Struct(_) | Base::Block(_) => {
            let fields = &program.struct_of(ty.element())?.fields;
            let each = fields.iter().map(|f| scalars(program, f.ty));
            each.sum::<Option<u32>>()?
        }
        Base::Void | Base::Sampler(_) => 0,
        Base::Error => return None,
    };
    let count = match ty.array {
        0 => one,
        Type::UNSIZED => return None,
        n => one.checked_mul(n)?,
    };
    (count <= MAX_SCALARS).then_some(count)
}

/// The first scalar of a part with a number, how many it has, and how many such parts there are.
pub(super) fn part(program: &Program, ty: Type, number: u32) -> Option<(u32, Type, u32)> {
    if ty.is_array() {
        let element = ty.element();
        return Some((
            number.checked_mul(scalars(program, element)?)?,
            element,
            ty.array,
        ));
    }
    match ty.base {
        Base::Numeric {
            scalar,
            columns: columns @ 2..,
            rows,
        } => {
            let column = Type::vector(scalar, rows);
            Some((number.checked_mul(rows as u32)?, column, columns as u32))
        }
        Base::Numeric { scalar, rows, .. } => Some((number, Type::scalar(scalar), rows as u32)),
        Base::Struct(_) | Base::Block(_) => {
            let fields = &program.struct_of(ty)?.fields;
            let field = fields.get(number as usize)?;
            let before = fields.get(..number as usize)?;
            let at = before
                .iter()
                .map(|f| scalars(program, f.ty))
                .sum::<Option<u32>>()?;
            Some((at, field.ty, fields.len() as u32))
        }
        _ => None,
    }
}
