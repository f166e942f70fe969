//! Verifies the operand and result types of operations.

use super::place;
use super::verifier::Verifier;
use crate::form::{Binary, Module, OpId, OpKind, PlaceId, Root, Unary};
use shaderlint_semantic::builtins::{BuiltinId, Overload};
use shaderlint_semantic::{Direction, FunctionRef, Scalar, Type};
use shaderlint_syntax::ast::List;

type OpResult = Result<(), String>;

/// Whether a value of one type may be used where the other is expected. Error types are compatible
/// with everything.
pub(super) fn fits(a: Type, b: Type) -> bool {
    a == b || a.is_error() || b.is_error()
}

/// Whether an operation is well-formed, given that its operands are defined.
pub(super) fn check(v: &Verifier<'_>, id: OpId) -> OpResult {
    let module = v.module;
    let op = *module.op(id);
    let ty = |operand| module.ty(operand);
    match op.kind {
        OpKind::Const(constant) => constant_fits(v, op.ty, module.pool.values(constant).len()),
        OpKind::Undef | OpKind::Unknown => Ok(()),
        OpKind::Load(place) => {
            inside(v, place)?;
            gives(v, op.ty, module.place(place).ty)
        }
        OpKind::Store(place, value) => {
            inside(v, place)?;
            gives(v, op.ty, Type::VOID)?;
            writable(module, place)?;
            takes(v, ty(value), module.place(place).ty)
        }
        OpKind::Unary(unary, a) => {
            takes_one(v, unary, a)?;
            gives(v, op.ty, ty(a))
        }
        OpKind::Binary(binary, a, b) => {
            takes_both(v, binary, ty(a), ty(b))?;
            let result = if binary.compares() { Type::BOOL } else { ty(a) };
            gives(v, op.ty, result)
        }
        OpKind::MatrixProduct(a, b) => product(v, op.ty, ty(a), ty(b)),
        OpKind::Same { left, right, .. } => {
            takes(v, ty(right), ty(left))?;
            gives(v, op.ty, Type::BOOL)
        }
        OpKind::Select {
            condition,
            then,
            otherwise,
        } => {
            takes(v, ty(condition), Type::BOOL)?;
            takes(v, ty(otherwise), ty(then))?;
            gives(v, op.ty, ty(then))
        }
        OpKind::Convert(a) => converts(v, op.ty, ty(a)),
        OpKind::Splat(a) => {
            holds(op.ty.components() > 1, || "a splat of one component".into())?;
            takes(v, ty(a), scalar_of(op.ty))
        }
        OpKind::Swizzle(a, lanes) => match place::picked(ty(a), lanes) {
            Some(found) => gives(v, op.ty, found),
            None if ty(a).is_error() => Ok(()),
            None => Err(format!(
                "components {:?} of {}",
                lanes.numbers(),
                v.name(ty(a))
            )),
        },
        OpKind::Compose(parts) => composes(v, op.ty, parts),
        OpKind::Extract(a, number) => {
            let part =
                place::element(ty(a), number).or_else(|| place::member(v.program, ty(a), number));
            match part {
                Some(found) => gives(v, op.ty, found),
                None if ty(a).is_error() => Ok(()),
                None => Err(format!("part {number} of {}", v.name(ty(a)))),
            }
        }
        OpKind::ExtractComputed { base, index } => computed(v, op.ty, ty(base), ty(index)),
        OpKind::Builtin(function, arguments) => builtin(v, op.ty, function, arguments),
        OpKind::Call(callee, arguments) => call(v, op.ty, callee, arguments),
        OpKind::Returned(call, number) => returned(v, op.ty, call, number),
    }
}

/// Whether a unary operator accepts its operand.
fn takes_one(v: &Verifier<'_>, unary: Unary, operand: OpId) -> OpResult {
    let ty = v.module.ty(operand);
    let scalar = v.module.scalar(operand);
    let is_taken = match unary {
        Unary::Negate => scalar != Some(Scalar::Bool),
        Unary::Not => fits(ty, Type::BOOL),
        Unary::BitNot => scalar.is_none_or(Scalar::is_integer),
    };
    holds(is_taken, || format!("{unary:?} of {}", v.name(ty)))
}

fn holds(what: bool, otherwise: impl FnOnce() -> String) -> OpResult {
    if what { Ok(()) } else { Err(otherwise()) }
}

fn gives(v: &Verifier<'_>, stated: Type, found: Type) -> OpResult {
    holds(fits(stated, found), || {
        format!(
            "the result has type {}, expected {}",
            v.name(found),
            v.name(stated)
        )
    })
}

fn takes(v: &Verifier<'_>, found: Type, needed: Type) -> OpResult {
    holds(fits(found, needed), || {
        format!(
            "expected an operand of type {}, found {}",
            v.name(needed),
            v.name(found)
        )
    })
}

fn computed(v: &Verifier<'_>, ty: Type, base: Type, index: Type) -> OpResult {
    holds(place::is_index(index), || {
        format!("{} is not an index type", v.name(index))
    })?;
    match place::computed(base) {
        Some(found) => gives(v, ty, found),
        None if base.is_error() => Ok(()),
        None => Err(format!("{} has no elements", v.name(base))),
    }
}

fn scalar_of(ty: Type) -> Type {
    ty.scalar_kind().map_or(Type::ERROR, Type::scalar)
}

fn constant_fits(v: &Verifier<'_>, ty: Type, len: usize) -> OpResult {
    let scalars = v.layout.scalars(ty);
    holds(scalars == Some(len as u32) || ty.is_error(), || {
        format!("a constant of {len} scalars is not a {}", v.name(ty))
    })
}

/// A place must belong to a variable of the current function or to a global.
fn inside(v: &Verifier<'_>, place: PlaceId) -> OpResult {
    let variable = v.module.variable(v.module.place(place).variable);
    let owner = variable.and_then(|v| v.function);
    holds(owner.is_none() || owner == v.at.function, || {
        "a variable of another function".into()
    })
}

fn writable(module: &Module, place: PlaceId) -> OpResult {
    let variable = module.variable(module.place(place).variable);
    let root = variable.map(|v| v.root);
    holds(
        !matches!(root, None | Some(Root::Uniform | Root::Input)),
        || "a write to a read-only variable".into(),
    )?;
    holds(!place::repeats(module, place), || {
        "two writes to the same component".into()
    })
}

fn takes_both(v: &Verifier<'_>, binary: Binary, a: Type, b: Type) -> OpResult {
    use Binary::*;
    if a.is_error() || b.is_error() {
        return Ok(());
    }
    let is_integer = |ty: Type| ty.scalar_kind().is_some_and(Scalar::is_integer);
    let is_right = match binary {
        Add | Subtract | Multiply | Divide => {
            a == b && !matches!(a.scalar_kind(), None | Some(Scalar::Bool))
        }
        Remainder | BitAnd | BitOr | BitXor => a == b && is_integer(a),
        ShiftLeft | ShiftRight => {
            is_integer(a) && is_integer(b) && a.components() == b.components()
        }
        Less | LessEqual | Greater | GreaterEqual => {
            a == b && a.is_scalar() && a.scalar_kind() != Some(Scalar::Bool)
        }
        And | Or | Xor => a == b && a == Type::BOOL,
    };
    holds(is_right, || {
        format!("{} {} {}", v.name(a), binary.symbol(), v.name(b))
    })
}

/// Checks a matrix product; a vector counts as a row on the left and as a column on the right.
fn product(v: &Verifier<'_>, ty: Type, a: Type, b: Type) -> OpResult {
    let (Some((_, ac, ar)), Some((_, bc, br))) = (a.numeric(), b.numeric()) else {
        return holds(a.is_error() || b.is_error(), || {
            "a matrix product of operands that are not numeric".into()
        });
    };
    let found = match (a.is_matrix(), b.is_matrix()) {
        (true, true) if ac == br => Some(Type::matrix(bc, ar)),
        (true, false) if b.is_vector() && ac == br => Some(Type::vector(Scalar::Float, ar)),
        (false, true) if a.is_vector() && ar == br => Some(Type::vector(Scalar::Float, bc)),
        _ => None,
    };
    match found {
        Some(found) => gives(v, ty, found),
        None => Err(format!("the product of {} and {}", v.name(a), v.name(b))),
    }
}

fn converts(v: &Verifier<'_>, ty: Type, from: Type) -> OpResult {
    let (Some(to), Some(of)) = (ty.scalar_kind(), from.scalar_kind()) else {
        return holds(ty.is_error() || from.is_error(), || {
            format!("{} converted to {}", v.name(from), v.name(ty))
        });
    };
    holds(to != of && from.with_scalar(to) == ty, || {
        format!("{} converted to {}", v.name(from), v.name(ty))
    })
}

fn composes(v: &Verifier<'_>, ty: Type, list: List) -> OpResult {
    let parts: Vec<Type> = v
        .module
        .operands(list)
        .iter()
        .map(|&p| v.module.ty(p))
        .collect();
    if ty.is_error() || parts.iter().any(|p| p.is_error()) {
        return Ok(());
    }
    let is_right = if ty.is_array() {
        let is_complete = ty.array as usize == parts.len();
        is_complete && parts.iter().all(|p| *p == ty.element())
    } else if ty.is_vector() {
        let count: u32 = parts.iter().map(|p| p.components()).sum();
        let are_numbers = parts
            .iter()
            .all(|p| !p.is_matrix() && scalar_of(*p) == scalar_of(ty));
        are_numbers && count == ty.components() && parts.len() > 1
    } else if let Some((scalar, columns @ 2.., rows)) = ty.numeric() {
        let column = Type::vector(scalar, rows);
        parts.len() == columns as usize && parts.iter().all(|p| *p == column)
    } else {
        let fields = v
            .program
            .struct_of(ty)
            .map(|s| s.fields.iter().map(|f| f.ty));
        fields.is_some_and(|f| f.eq(parts.iter().copied()))
    };
    holds(is_right, || {
        let parts: Vec<String> = parts.iter().map(|p| v.name(*p)).collect();
        format!("{} constructed from {}", v.name(ty), parts.join(", "))
    })
}

fn each_takes(v: &Verifier<'_>, list: List, needed: impl Iterator<Item = Type>) -> OpResult {
    let arguments = v.module.operands(list);
    let needed: Vec<Type> = needed.collect();
    holds(arguments.len() == needed.len(), || {
        format!("{} arguments, expected {}", arguments.len(), needed.len())
    })?;
    let mut pairs = arguments.iter().zip(needed);
    pairs.try_for_each(|(&argument, needed)| takes(v, v.module.ty(argument), needed))
}

/// The overload of a built-in function that accepts these operands.
fn form<'v>(v: &'v Verifier<'_>, function: BuiltinId, arguments: List) -> Option<&'v Overload> {
    let arguments = v.module.operands(arguments);
    let takes_them = |overload: &&Overload| {
        let params = overload.params().iter().enumerate();
        let read = params.filter(|(i, _)| !overload.writes(*i));
        let mut pairs = arguments.iter().zip(read.clone());
        read.count() == arguments.len() && pairs.all(|(a, (_, ty))| fits(v.module.ty(*a), *ty))
    };
    v.builtins.overloads_of(function).1.iter().find(takes_them)
}

fn builtin(v: &Verifier<'_>, ty: Type, function: BuiltinId, arguments: List) -> OpResult {
    match form(v, function, arguments) {
        Some(overload) => gives(v, ty, overload.returns),
        None => Err(format!(
            "`{}` has no overload for its operands",
            function.name()
        )),
    }
}

fn call(v: &Verifier<'_>, ty: Type, callee: FunctionRef, arguments: List) -> OpResult {
    let Some(function) = v.program.function(callee) else {
        return Err(format!("unknown function {}", callee.0));
    };
    each_takes(v, arguments, function.params.iter().map(|p| p.ty))?;
    for (&argument, param) in v.module.operands(arguments).iter().zip(&function.params) {
        let is_undefined = v.module.op(argument).kind == OpKind::Undef;
        holds(param.direction != Direction::Out || is_undefined, || {
            format!("%{} is passed to an `out` parameter", argument.0)
        })?;
    }
    gives(v, ty, function.returns)
}

/// The value must come from an `out` or `inout` parameter of the call.
fn returned(v: &Verifier<'_>, ty: Type, call: OpId, number: u32) -> OpResult {
    let found = match v.module.op(call).kind {
        OpKind::Call(callee, _) => {
            let params = v.program.function(callee).map(|f| &f.params);
            let param = params.and_then(|p| p.get(number as usize));
            param.filter(|p| p.direction.writes()).map(|p| p.ty)
        }
        OpKind::Builtin(function, arguments) => {
            let written = form(v, function, arguments)
                .filter(|o| number < o.count as u32 && o.writes(number as usize));
            written.and_then(|o| o.params().get(number as usize).copied())
        }
        _ => None,
    };
    match found {
        Some(found) => gives(v, ty, found),
        None => Err(format!("%{} does not write parameter {number}", call.0)),
    }
}
