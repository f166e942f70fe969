//! Constructors (GLSL ES 3.00 section 5.4).

use super::mismatch::TypeMismatch;
use super::type_context::Types;
use crate::types::*;

/// A type with the array size that its constructor's arguments imply.
pub fn sized(mut ty: Type, arguments: usize) -> Type {
    if ty.array == Type::UNSIZED {
        ty.array = (arguments as u32).max(1);
    }
    ty
}

/// Checks a constructor call of `ty`, which has a size. Arguments of unknown type are accepted.
pub fn construct(
    types: Types,
    ty: Type,
    arguments: impl ExactSizeIterator<Item = Type> + Clone,
) -> Result<(), TypeMismatch> {
    if ty.is_void() || ty.is_sampler() {
        return Err(TypeMismatch::NotConstructible(ty));
    }
    if arguments.clone().any(Type::is_error) {
        return Ok(());
    }
    if arguments.len() == 0 {
        return Err(TypeMismatch::NoArguments(ty));
    }
    for (i, argument) in arguments.clone().enumerate() {
        if argument.is_void() {
            return Err(TypeMismatch::Void(i));
        }
        if types.inside(argument).sampler {
            return Err(TypeMismatch::SamplerArgument(i));
        }
    }
    match ty.base {
        _ if ty.is_array() => {
            let parts = std::iter::repeat_n(ty.element(), ty.array as usize);
            each(ty, parts, arguments)
        }
        Base::Struct(index) => {
            let record = types.structs.get(index as usize);
            let fields = record.map_or(&[][..], |s| &s.fields);
            each(ty, fields.iter().map(|f| f.ty), arguments)
        }
        _ => numbers(ty, arguments),
    }
}

/// Each argument initialises one element or member.
fn each(
    ty: Type,
    parts: impl ExactSizeIterator<Item = Type>,
    arguments: impl ExactSizeIterator<Item = Type>,
) -> Result<(), TypeMismatch> {
    if parts.len() != arguments.len() {
        return Err(TypeMismatch::Count(ty));
    }
    let mut pairs = parts.zip(arguments).enumerate();
    match pairs.find(|(_, (part, argument))| part != argument && !part.is_error()) {
        Some((i, (part, _))) => Err(TypeMismatch::Part(i, part)),
        None => Ok(()),
    }
}

/// The components of all arguments in sequence form the value and must suffice for it; a single
/// scalar fills it, and a matrix can be built from another of any size.
fn numbers(ty: Type, arguments: impl ExactSizeIterator<Item = Type>) -> Result<(), TypeMismatch> {
    let expected = ty.components();
    let count = arguments.len();
    let mut given = 0;
    let mut surplus = None;
    let mut has_matrix = false;
    for (i, argument) in arguments.enumerate() {
        if argument.numeric().is_none() {
            return Err(TypeMismatch::NoNumber(i, ty));
        }
        if given >= expected && surplus.is_none() {
            surplus = Some(i);
        }
        given += argument.components();
        has_matrix |= argument.is_matrix();
    }
    if ty.is_matrix() && has_matrix {
        return match count {
            1 => Ok(()),
            _ => Err(TypeMismatch::MatrixWithOthers),
        };
    }
    match surplus {
        Some(first) => Err(TypeMismatch::TooMany(ty, given, first)),
        None if given != 1 && given < expected => Err(TypeMismatch::TooFew(ty, given)),
        None => Ok(()),
    }
}
