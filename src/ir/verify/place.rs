//! Verifies places: paths into variables and their types.

use crate::form::{Access, Lanes, Module, PlaceId};
use shaderlint_semantic::{Program, Scalar, Type};

/// Whether the path of a place fits its variable, and the place has the resulting type.
pub(super) fn check(program: &Program, module: &Module, id: PlaceId) -> Result<(), String> {
    let place = module.place(id);
    let Some(variable) = module.variable(place.variable) else {
        return Err(format!("unknown variable {}", place.variable.0));
    };
    let path = module.path(place);
    if path.len() != place.path.len as usize {
        return Err("the path exceeds the list of accesses".into());
    }
    let mut ty = variable.ty;
    for (i, access) in path.iter().enumerate() {
        if matches!(access, Access::Lanes(_)) && i + 1 != path.len() {
            return Err("components are selected before the end of the path".into());
        }
        ty = step(program, module, ty, access)?;
    }
    if ty != place.ty && !ty.is_error() {
        let (end, stated) = (program.type_name(ty), program.type_name(place.ty));
        return Err(format!("the path ends at type {end}, expected {stated}"));
    }
    Ok(())
}

/// The type after one step of a path.
fn step(program: &Program, module: &Module, ty: Type, access: &Access) -> Result<Type, String> {
    if ty.is_error() {
        return Ok(ty);
    }
    let none = |what: &str| Err(format!("{} has no {what}", program.type_name(ty)));
    match *access {
        Access::Member(n) => match member(program, ty, n) {
            Some(ty) => Ok(ty),
            None => none(&format!("member {n}")),
        },
        Access::Element(n) => match element(ty, n) {
            Some(ty) => Ok(ty),
            None => none(&format!("element {n}")),
        },
        Access::Computed(index) => {
            let index = module.ty(index);
            if !is_index(index) {
                return Err(format!("{} is not an index type", program.type_name(index)));
            }
            match computed(ty) {
                Some(ty) => Ok(ty),
                None => none("elements"),
            }
        }
        Access::Lanes(lanes) => match picked(ty, lanes) {
            Some(ty) => Ok(ty),
            None => none(&format!("components {:?}", lanes.numbers())),
        },
    }
}

/// Whether a type may be an index.
pub(super) fn is_index(ty: Type) -> bool {
    let is_integer = ty.scalar_kind().is_some_and(Scalar::is_integer);
    ty.is_error() || ty.is_scalar() && is_integer
}

/// The type of a member of a struct or block.
pub(super) fn member(program: &Program, ty: Type, number: u32) -> Option<Type> {
    let fields = &program.struct_of(ty).filter(|_| !ty.is_array())?.fields;
    Some(fields.get(number as usize)?.ty)
}

/// The type of an element of an array or a column of a matrix.
pub(super) fn element(ty: Type, number: u32) -> Option<Type> {
    if ty.is_array() {
        let size = ty.array;
        return (size == Type::UNSIZED || number < size).then(|| ty.element());
    }
    let (scalar, columns, rows) = ty.numeric()?;
    (columns > 1 && number < columns as u32).then(|| Type::vector(scalar, rows))
}

/// The type at a dynamic index: an element, column or component.
pub(super) fn computed(ty: Type) -> Option<Type> {
    if ty.is_vector() {
        return ty.scalar_kind().map(Type::scalar);
    }
    element(ty, 0)
}

/// The type of a swizzle.
pub(super) fn picked(ty: Type, lanes: Lanes) -> Option<Type> {
    let (scalar, 1, rows @ 2..) = ty.numeric()? else {
        return None;
    };
    let is_inside = lanes.count() > 0 && lanes.numbers().iter().all(|n| *n < rows);
    is_inside.then(|| Type::vector(scalar, lanes.count()))
}

/// Whether a swizzle repeats a component, so that it is not assignable.
pub(super) fn repeats(module: &Module, id: PlaceId) -> bool {
    let last = module.path(module.place(id)).last();
    let Some(Access::Lanes(lanes)) = last else {
        return false;
    };
    let mask = lanes.numbers().iter().fold(0u8, |mask, n| mask | 1 << n);
    mask.count_ones() != lanes.count() as u32
}
