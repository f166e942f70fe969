//! Overloads of built-in functions, and built-in variables.

use super::table::BuiltinId;
use crate::constant::Value;
use crate::types::Type;
use shaderlint_syntax::ast::QualifierKind;

/// Maximum number of parameters of a built-in function.
pub const MAX_PARAMS: usize = 5;

/// An overload of a built-in function.
#[derive(Clone, Copy, Debug)]
pub struct Overload {
    /// The function that it overloads.
    pub function: BuiltinId,
    /// Types of the parameters; unused entries are `void`.
    pub params: [Type; MAX_PARAMS],
    /// Number of parameters.
    pub count: u8,
    /// Bit `i` is set if parameter `i` is `out`.
    pub out: u8,
    /// Bit `i` is set if argument `i` must be a constant expression.
    pub constant: u8,
    /// Return type.
    pub returns: Type,
}

impl Overload {
    /// Placeholder for unused array entries.
    pub(super) const NONE: Overload = Overload {
        function: BuiltinId::Radians,
        params: [Type::VOID; MAX_PARAMS],
        count: 0,
        out: 0,
        constant: 0,
        returns: Type::VOID,
    };

    /// The types of the used parameters.
    pub fn params(&self) -> &[Type] {
        self.params
            .get(..self.count as usize)
            .unwrap_or(&self.params)
    }

    /// Whether the parameter at a position is `out`.
    pub fn writes(&self, position: usize) -> bool {
        self.out & 1 << position != 0
    }

    /// The result for constant arguments, given as scalars; `None` if it is unknown.
    pub fn fold(&self, args: &[&[Value]]) -> Option<Vec<Value>> {
        let first = self.params().first().copied().unwrap_or(Type::VOID);
        self.function.fold(first, args)
    }
}

/// Storage of a built-in variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BuiltinStorage {
    /// Read-only; differs per fragment or vertex.
    In,
    /// Written by the shader.
    Out,
    /// Read-only; the same for all invocations.
    Uniform,
    /// A constant with this value.
    Const(i32),
}

impl BuiltinStorage {
    /// The value of a constant.
    pub fn value(self) -> Option<Value> {
        match self {
            BuiltinStorage::Const(value) => Some(Value::Int(value)),
            _ => None,
        }
    }
}

/// A built-in variable of the language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BuiltinVariable {
    /// Type; `None` for the struct of `gl_DepthRange`, with the members `near`, `far`, `diff`.
    pub ty: Option<Type>,
    /// Whether it is an input, output, uniform or constant.
    pub storage: BuiltinStorage,
    /// Precision, if the specification states one.
    pub precision: Option<QualifierKind>,
}

impl BuiltinVariable {
    /// Placeholder for unused array entries.
    pub(super) const NONE: BuiltinVariable = BuiltinVariable {
        ty: None,
        storage: BuiltinStorage::In,
        precision: None,
    };
}
