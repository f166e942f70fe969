//! Operators, assignments and `return` (GLSL ES 3.00 sections 5.8, 5.9 and 6.1).

use super::mismatch::{Clash, NonNumber, TypeMismatch};
use super::type_context::Types;
use crate::types::*;
use shaderlint_syntax::Feature;
use shaderlint_syntax::ast::{BinaryOp, UnaryOp};

/// What the result is used for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    /// As a value of its own.
    Value,
    /// It replaces the left operand.
    Update,
}

/// `op operand`, without `++` and `--`.
pub fn unary(op: UnaryOp, operand: Type) -> Result<Type, TypeMismatch> {
    let scalar = operand.scalar_kind();
    let fits = match op {
        UnaryOp::Not => operand == Type::BOOL,
        UnaryOp::BitNot => scalar.is_some_and(Scalar::is_integer) && !operand.is_matrix(),
        _ => scalar.is_some_and(|s| s != Scalar::Bool),
    };
    match fits {
        true => Ok(operand),
        false if operand.is_void() => Err(TypeMismatch::Void(0)),
        false => Err(TypeMismatch::Operand(operand)),
    }
}

/// `++` and `--`.
pub fn step(operand: Type) -> Result<Type, TypeMismatch> {
    unary(UnaryOp::Plus, operand)
}

/// `l op r`
pub fn binary(types: Types, op: BinaryOp, l: Type, r: Type) -> Result<Type, TypeMismatch> {
    let is_equality = matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
    values(l, r)?;
    let fits = aggregates(types, is_equality, l, r);
    fits.and_then(|()| operate(op, l, r, Use::Value))
        .map_err(TypeMismatch::Operands)
}

/// `l op= r`, whose result must fit `l`.
pub fn compound(types: Types, op: BinaryOp, l: Type, r: Type) -> Result<Type, TypeMismatch> {
    values(l, r)?;
    let fits = aggregates(types, false, l, r);
    fits.and_then(|()| operate(op, l, r, Use::Update))
        .map_err(TypeMismatch::Operands)
}

/// `l = r`, or `r` as the initial value of `l`.
pub fn assign(types: Types, l: Type, r: Type) -> Result<(), TypeMismatch> {
    values(l, r)?;
    aggregates(types, true, l, r).map_err(TypeMismatch::Value)?;
    if l == r {
        return Ok(());
    }
    Err(TypeMismatch::Value(
        match (l.element().scalar_kind(), r.element().scalar_kind()) {
            (Some(a), Some(b)) if a != b => Clash::Scalars,
            _ => Clash::Shape,
        },
    ))
}

/// A condition must be a `bool`.
pub fn condition(ty: Type) -> Result<(), TypeMismatch> {
    match ty {
        Type::BOOL => Ok(()),
        ty if ty.is_void() => Err(TypeMismatch::Void(0)),
        ty => Err(TypeMismatch::Condition(ty)),
    }
}

/// `c ? yes : no`. WebGL2 allows it only for scalars, vectors and matrices (WebGL 2.0 section
/// 5.26).
pub fn choice(yes: Type, no: Type) -> Result<Type, TypeMismatch> {
    if yes != no {
        return Err(match (yes.is_void(), no.is_void()) {
            (true, _) => TypeMismatch::Void(0),
            (_, true) => TypeMismatch::Void(1),
            _ => TypeMismatch::Arms,
        });
    }
    let kind = match yes.base {
        Base::Void => NonNumber::Void,
        Base::Sampler(_) => NonNumber::Samplers,
        Base::Struct(_) if !yes.is_array() => NonNumber::Structs,
        Base::Block(_) => NonNumber::Blocks,
        _ if yes.is_array() => NonNumber::Arrays,
        _ => return Ok(yes),
    };
    Err(TypeMismatch::Unchosen(kind))
}

/// `l, r`. WebGL2 does not allow it for arrays and types that contain them (WebGL 2.0 section
/// 5.26).
pub fn sequence(types: Types, l: Type, r: Type) -> Result<Type, TypeMismatch> {
    let fits =
        |ty: Type| !ty.is_void() && !matches!(ty.base, Base::Block(_)) && !types.inside(ty).array;
    match fits(l) && fits(r) {
        true => Ok(r),
        false => Err(TypeMismatch::Sequence),
    }
}

/// `return` with or without a value, in a function with return type `expected`.
pub fn returned(expected: Type, value: Option<Type>) -> Result<(), TypeMismatch> {
    let is_unknown = expected.is_error() || value.is_some_and(Type::is_error);
    match value {
        None if expected.is_void() || expected.is_error() => Ok(()),
        None => Err(TypeMismatch::NothingReturned(expected)),
        Some(found) if found.is_void() && (expected.is_void() || expected.is_error()) => {
            Err(TypeMismatch::ValueReturned)
        }
        Some(found) if is_unknown || found == expected => Ok(()),
        Some(_) if expected.is_void() => Err(TypeMismatch::ValueReturned),
        Some(found) if found.is_void() => Err(TypeMismatch::Void(0)),
        Some(_) => Err(TypeMismatch::Returned(expected)),
    }
}

/// Checks that neither operand is `void`.
fn values(l: Type, r: Type) -> Result<(), TypeMismatch> {
    match (l.is_void(), r.is_void()) {
        (true, _) => Err(TypeMismatch::Void(0)),
        (_, true) => Err(TypeMismatch::Void(1)),
        _ => Ok(()),
    }
}

/// Rules for all operators: no samplers, and structs and arrays only in comparison and assignment
/// of whole values.
fn aggregates(types: Types, takes_aggregates: bool, l: Type, r: Type) -> Result<(), Clash> {
    if l.is_sampler() || r.is_sampler() {
        return Err(Clash::Sampler);
    }
    let is_struct = |t: Type| matches!(t.base, Base::Struct(_) | Base::Block(_));
    if is_struct(l) || is_struct(r) {
        let is_block = matches!(l.base, Base::Block(_)) || matches!(r.base, Base::Block(_));
        if is_block || !takes_aggregates || l != r {
            return Err(Clash::Struct);
        }
        let inside = types.inside(l.element());
        if (!types.has(Feature::ArrayValues) && inside.array) || inside.sampler {
            return Err(Clash::StructInside);
        }
    }
    if l.is_array() != r.is_array() {
        return Err(Clash::Array);
    }
    if l.is_array() {
        if !types.has(Feature::ArrayValues) || !takes_aggregates {
            return Err(Clash::Array);
        }
        if l.array != r.array {
            return Err(Clash::ArraySize);
        }
        if l.base != r.base {
            let mixed = l.element().scalar_kind() != r.element().scalar_kind();
            return Err(if mixed { Clash::Scalars } else { Clash::Shape });
        }
    }
    Ok(())
}

/// The result type of an operator, for operands that [`aggregates`] accepts.
fn operate(op: BinaryOp, l: Type, r: Type, goes: Use) -> Result<Type, Clash> {
    use BinaryOp as B;
    if l.is_array() || matches!(l.base, Base::Struct(_)) {
        return Ok(Type::BOOL);
    }
    let (Some((ls, lc, lr)), Some((rs, rc, rr))) = (l.numeric(), r.numeric()) else {
        return Err(Clash::Struct);
    };
    let is_shift = matches!(op, B::ShiftLeft | B::ShiftRight);
    if op.is_bitwise() && (!ls.is_integer() || (is_shift && !rs.is_integer())) {
        return Err(Clash::NeedsInteger);
    }
    if ls != rs && !is_shift {
        return Err(Clash::Scalars);
    }
    let same_shape = (lc, lr) == (rc, rr);
    match op {
        B::Equal | B::NotEqual if same_shape => Ok(Type::BOOL),
        B::Equal | B::NotEqual => Err(Clash::Shape),
        B::Less | B::Greater | B::LessEqual | B::GreaterEqual => {
            if !l.is_scalar() || !r.is_scalar() {
                Err(Clash::NeedsScalar)
            } else if ls == Scalar::Bool {
                Err(Clash::NeedsNumber)
            } else {
                Ok(Type::BOOL)
            }
        }
        B::And | B::Or | B::Xor if l == Type::BOOL && r == Type::BOOL => Ok(Type::BOOL),
        B::And | B::Or | B::Xor => Err(Clash::NeedsBool),
        _ if ls == Scalar::Bool => Err(Clash::NeedsNumber),
        B::Mul => product(l, r)
            .filter(|result| goes == Use::Value || *result == l)
            .ok_or(Clash::Shape),
        B::Rem if !ls.is_integer() => Err(Clash::NeedsInteger),
        _ if same_shape => Ok(l),
        _ => {
            let mixed = (l.is_matrix() && r.is_vector()) || (l.is_vector() && r.is_matrix());
            let keeps_left = goes == Use::Update || is_shift;
            if mixed || !(l.is_scalar() || r.is_scalar()) || (!r.is_scalar() && keeps_left) {
                Err(Clash::Shape)
            } else {
                Ok(if l.is_scalar() { r } else { l })
            }
        }
    }
}

/// Type of `l * r`, if they can be multiplied.
fn product(l: Type, r: Type) -> Option<Type> {
    let ((scalar, lc, lr), (_, rc, rr)) = (l.numeric()?, r.numeric()?);
    Some(match (l.is_matrix(), r.is_matrix()) {
        (true, true) if lc == rr => Type::matrix(rc, lr),
        (true, false) if r.is_vector() && lc == rr => Type::vector(scalar, lr),
        (false, true) if l.is_vector() && lr == rr => Type::vector(scalar, rc),
        (true, true) => return None,
        (true, false) if r.is_vector() => return None,
        (false, true) if l.is_vector() => return None,
        _ if l.is_scalar() => r,
        _ if r.is_scalar() || lr == rr => l,
        _ => return None,
    })
}
