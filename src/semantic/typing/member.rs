//! Members, components and elements (GLSL ES 3.00 sections 5.5 and 5.7).

use super::mismatch::TypeMismatch;
use super::type_context::Types;
use crate::types::*;
use shaderlint_syntax::Name;

/// What a member expression selects.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Member {
    /// Components of a vector: the resulting type and the component indices.
    Components(Type, [u8; 4]),
    /// A member of a struct or block: its type and the number of scalars before it.
    Field(Type, u32),
}

/// The only method, available for arrays.
pub const LENGTH: &str = "length";
/// The letters of component names, by set.
pub const SWIZZLES: [&str; 3] = ["xyzw", "rgba", "stpq"];

/// Resolves `object.name`; `text` is the name.
pub fn member(types: Types, object: Type, name: Name, text: &str) -> Result<Member, TypeMismatch> {
    if let Some((scalar, 1, rows @ 2..)) = object.numeric() {
        let lanes = components(text).ok_or(TypeMismatch::Letters(object))?;
        let picked = lanes.get(..text.len()).unwrap_or(&[]);
        if let Some(letter) = picked.iter().position(|&c| c >= rows) {
            return Err(TypeMismatch::Component(object, letter));
        }
        return Ok(Member::Components(
            Type::vector(scalar, text.len() as u8),
            lanes,
        ));
    }
    match object.base {
        _ if object.is_array() => Err(TypeMismatch::ArrayMember),
        Base::Struct(index) | Base::Block(index) => field(types, index, name),
        Base::Void => Err(TypeMismatch::Void(0)),
        _ => Err(TypeMismatch::NoMembers(object)),
    }
}

fn field(types: Types, index: u16, name: Name) -> Result<Member, TypeMismatch> {
    let fields = types
        .structs
        .get(index as usize)
        .map_or(&[][..], |s| &s.fields);
    let mut offset = 0;
    for field in fields {
        if field.name == name {
            return Ok(Member::Field(field.ty, offset));
        }
        offset += types.scalars_in(field.ty);
    }
    Err(TypeMismatch::Field(index))
}

/// The component indices of a swizzle; `None` if it is not one.
pub fn components(text: &str) -> Option<[u8; 4]> {
    let set = SWIZZLES
        .iter()
        .find(|set| text.starts_with(|c| set.contains(c)))?;
    let mut lanes = [0; 4];
    let picked = lanes.get_mut(..text.len())?;
    for (lane, letter) in picked.iter_mut().zip(text.bytes()) {
        *lane = set.bytes().position(|c| c == letter)? as u8;
    }
    Some(lanes)
}

/// Element type and count of an array, a matrix (its columns) or a vector.
pub fn element(object: Type) -> Result<(Type, u32), TypeMismatch> {
    match object.numeric() {
        _ if object.is_array() => Ok((object.element(), object.array)),
        Some((scalar, columns @ 2.., rows)) => Ok((Type::vector(scalar, rows), columns as u32)),
        Some((scalar, 1, rows @ 2..)) => Ok((Type::scalar(scalar), rows as u32)),
        _ => Err(TypeMismatch::NoElements(object)),
    }
}

/// Checks that an index is an integer.
pub fn index(ty: Type) -> Result<(), TypeMismatch> {
    match ty {
        Type::INT | Type::UINT => Ok(()),
        ty => Err(TypeMismatch::Index(ty)),
    }
}
