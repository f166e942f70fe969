//! Typing: from the types of operands to the type of a result, or to what does not fit.
//!
//! Nothing here knows of places or words. Every decision is a function of types; what is said of a
//! [`Misfit`] is made in `explain`.

mod construct;
mod member;
mod operator;
#[cfg(test)]
mod tests;

pub use construct::{construct, sized};
pub use member::{LENGTH, Member, SWIZZLES, components, element, index, member};
pub use operator::{assign, binary, choice, compound, condition, returned, sequence, step, unary};

use super::types::*;
use shaderlint_syntax::{Feature, Version};

/// What types mean in one shader: its structs, and the version of the language.
#[derive(Clone, Copy)]
pub struct Types<'a> {
    /// The structs and blocks, by number.
    pub structs: &'a [Struct],
    /// The version of the language.
    pub version: Version,
}

impl Types<'_> {
    /// What lies inside a type, at any depth.
    pub fn inside(self, ty: Type) -> Inside {
        let record = |id: u16| self.structs.get(id as usize).map(|s| s.inside);
        Inside::of(ty, |id| record(id).unwrap_or_default())
    }

    /// Number of scalars that a value of a type is made of.
    pub fn scalars_in(self, ty: Type) -> u32 {
        let one = match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * rows as u32,
            Base::Struct(id) => self.structs.get(id as usize).map_or(0, |s| {
                s.fields
                    .iter()
                    .fold(0, |n: u32, f| n.saturating_add(self.scalars_in(f.ty)))
            }),
            _ => 0,
        };
        one.saturating_mul(ty.array.max(1))
    }

    fn has(self, feature: Feature) -> bool {
        self.version.has(feature)
    }
}

/// What does not fit, with the types at fault. Operands and arguments are numbered from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Misfit {
    /// The operand or argument of this number has no value.
    Void(usize),
    /// An operator with one operand has no meaning for its type.
    Operand(Type),
    /// Two operands do not go together.
    Operands(Clash),
    /// A value cannot become one of another type.
    Value(Clash),
    /// A condition is no single truth value.
    Condition(Type),
    /// The two values of `? :` are of different types.
    Arms,
    /// `? :` cannot choose between values of such a kind.
    Unchosen(NonNumber),
    /// `,` cannot stand between such values.
    Sequence,
    /// A type without members.
    NoMembers(Type),
    /// An array, which has no member but `length()`.
    ArrayMember,
    /// Letters that pick no components.
    Letters(Type),
    /// The letter of this number picks a component that the vector has not.
    Component(Type, usize),
    /// The struct or block of this number has no such member.
    Field(u16),
    /// A type without elements.
    NoElements(Type),
    /// An index that is no integer.
    Index(Type),
    /// A type of which no value can be constructed.
    NotConstructible(Type),
    /// A constructor without arguments.
    NoArguments(Type),
    /// The argument of this number is a sampler or holds one.
    SamplerArgument(usize),
    /// A struct or array takes another number of arguments.
    Count(Type),
    /// The argument of this number has to be of another type, since it becomes a part of its own.
    Part(usize, Type),
    /// The argument of this number is made of no numbers.
    NoNumber(usize, Type),
    /// A matrix is made of a matrix and something else.
    MatrixBeside,
    /// The arguments have fewer components than the type: so many.
    TooFew(Type, u32),
    /// The arguments have more components than the type; nothing is left for the one of this number.
    TooMany(Type, u32, usize),
    /// `return` without the value that the function gives.
    NothingReturned(Type),
    /// `return` with a value in a function that gives none.
    ValueReturned,
    /// `return` with a value of another type than the function's.
    Returned(Type),
}

/// Why two types do not go together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Clash {
    /// One is a sampler.
    Sampler,
    /// One is a struct or block and the operator is not for those, or they are of two types.
    Struct,
    /// A struct that holds an array or a sampler cannot be compared or assigned.
    StructInside,
    /// One is an array, the other is not; or arrays have no such operator.
    Array,
    /// Two arrays of different sizes.
    ArraySize,
    /// `int`, `uint`, `float` or `bool` mixed.
    Scalars,
    /// Vectors or matrices of sizes that do not fit.
    Shape,
    /// The operator is for integers.
    NeedsInteger,
    /// The operator is for numbers.
    NeedsNumber,
    /// The operator is for single truth values.
    NeedsBool,
    /// The operator compares single numbers.
    NeedsScalar,
}

/// Kinds of values that are no numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NonNumber {
    /// `void`
    Void,
    /// Samplers.
    Samplers,
    /// Structs.
    Structs,
    /// Blocks.
    Blocks,
    /// Arrays.
    Arrays,
}

/// The type that is common to some, if it is.
pub fn common(mut types: impl Iterator<Item = Type>) -> Option<Type> {
    let first = types.next()?;
    types.all(|ty| ty == first).then_some(first)
}
