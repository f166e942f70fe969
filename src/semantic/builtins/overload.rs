//! A form of a built-in function, and a built-in variable.

use super::table::BuiltinId;
use crate::constant::Value;
use crate::types::Type;
use shaderlint_syntax::ast::QualifierKind;

/// Most parameters of a built-in function.
pub const MAX_PARAMS: usize = 5;

/// One form of a built-in function.
#[derive(Clone, Copy, Debug)]
pub struct Overload {
    /// Its function.
    pub function: BuiltinId,
    /// Types of the parameters; unused places are `void`.
    pub params: [Type; MAX_PARAMS],
    /// Number of parameters.
    pub count: u8,
    /// Bit `i` is set if parameter `i` is `out`.
    pub out: u8,
    /// Bit `i` is set if argument `i` must be a constant expression.
    pub constant: u8,
    /// What it yields.
    pub returns: Type,
}

impl Overload {
    /// Of nothing; stands where none is yet.
    pub(super) const NONE: Overload = Overload {
        function: BuiltinId::Radians,
        params: [Type::VOID; MAX_PARAMS],
        count: 0,
        out: 0,
        constant: 0,
        returns: Type::VOID,
    };

    /// The types of its parameters.
    pub fn params(&self) -> &[Type] {
        self.params
            .get(..self.count as usize)
            .unwrap_or(&self.params)
    }

    /// Whether it writes to the argument at a position.
    pub fn writes(&self, position: usize) -> bool {
        self.out & 1 << position != 0
    }

    /// Its result of constant arguments, given as scalars; `None` where it is not known.
    pub fn fold(&self, args: &[&[Value]]) -> Option<Vec<Value>> {
        let first = self.params().first().copied().unwrap_or(Type::VOID);
        self.function.fold(first, args)
    }
}

/// How a built-in variable may be used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BuiltinStorage {
    /// Read only, different at each fragment or vertex.
    In,
    /// Written by the shader.
    Out,
    /// Read only, the same everywhere.
    Uniform,
    /// A constant of this value.
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

/// A built-in variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BuiltinVariable {
    /// Its type; `None` for the struct of `gl_DepthRange`, with the members `near`, `far`, `diff`.
    pub ty: Option<Type>,
    /// How it may be used.
    pub storage: BuiltinStorage,
    /// How exact it is, where the language says.
    pub precision: Option<QualifierKind>,
}

impl BuiltinVariable {
    /// Of nothing; stands where none is yet.
    pub(super) const NONE: BuiltinVariable = BuiltinVariable {
        ty: None,
        storage: BuiltinStorage::In,
        precision: None,
    };
}
