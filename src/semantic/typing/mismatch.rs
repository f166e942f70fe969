//! Type errors as data.

use crate::types::*;

/// A type error with the types involved. Operands and arguments are numbered from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TypeMismatch {
    /// The operand or argument with this index is `void`.
    Void(usize),
    /// A unary operator does not accept this type.
    Operand(Type),
    /// Two operands are incompatible.
    Operands(Clash),
    /// A value cannot be converted to the required type.
    Value(Clash),
    /// A condition is not a `bool`.
    Condition(Type),
    /// The two values of `?:` have different types.
    Arms,
    /// `?:` does not accept values of this kind.
    Unchosen(NonNumber),
    /// The comma operator does not accept these values.
    Sequence,
    /// A type without members.
    NoMembers(Type),
    /// An array, which has no member but `length()`.
    ArrayMember,
    /// A swizzle with letters that are not components.
    Letters(Type),
    /// The letter with this index selects a component that the vector does not have.
    Component(Type, usize),
    /// The struct or block with this index has no such member.
    Field(u16),
    /// A type without elements.
    NoElements(Type),
    /// An index that is not an integer.
    Index(Type),
    /// A type without a constructor.
    NotConstructible(Type),
    /// A constructor without arguments.
    NoArguments(Type),
    /// The argument with this index is or contains a sampler.
    SamplerArgument(usize),
    /// Wrong number of arguments for a struct or array constructor.
    Count(Type),
    /// The argument with this index must have another type, that of its element or member.
    Part(usize, Type),
    /// The argument with this index is not numeric.
    NoNumber(usize, Type),
    /// A matrix constructor with a matrix and other arguments.
    MatrixWithOthers,
    /// The arguments have fewer components than the type; the number is given.
    TooFew(Type, u32),
    /// The arguments have more components than the type, with their number; the argument with this
    /// index is unused.
    TooMany(Type, u32, usize),
    /// `return` without a value in a function that returns one.
    NothingReturned(Type),
    /// `return` with a value in a `void` function.
    ValueReturned,
    /// `return` with a value of the wrong type.
    Returned(Type),
}

/// Why two types are incompatible.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Clash {
    Sampler,
    /// One is a struct or block that the operator does not accept, or they are different ones.
    Struct,
    /// A struct that contains an array or a sampler cannot be compared or assigned.
    StructInside,
    /// Only one is an array, or the operator does not accept arrays.
    Array,
    /// Two arrays of different sizes.
    ArraySize,
    /// Different component types: `int`, `uint`, `float` or `bool`.
    Scalars,
    /// Vectors or matrices of incompatible sizes.
    Shape,
    /// The operator requires integers.
    NeedsInteger,
    /// The operator requires numbers.
    NeedsNumber,
    /// The operator requires `bool` scalars.
    NeedsBool,
    /// The operator requires scalars.
    NeedsScalar,
}

/// Kinds of non-numeric values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NonNumber {
    /// `void`
    Void,
    Samplers,
    Structs,
    Blocks,
    Arrays,
}
