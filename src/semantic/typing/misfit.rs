//! What does not fit, as data.

use crate::types::*;

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
