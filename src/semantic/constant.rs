//! Values of constant expressions (GLSL ES 3.00 section 4.3.3).
//!
//! Every value is a sequence of scalars: the components of a vector, a matrix by columns, an array
//! by elements, a struct by members.

use super::types::Scalar;

/// A scalar value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// `int`
    Int(i32),
    /// `uint`
    Uint(u32),
    /// `float`
    Float(f32),
}

impl Value {
    /// Converts it as a constructor does (section 5.4.1).
    pub fn to(self, scalar: Scalar) -> Value {
        match scalar {
            Scalar::Bool => Value::Bool(self.as_bool()),
            Scalar::Int => Value::Int(self.as_int()),
            Scalar::Uint => Value::Uint(self.as_uint()),
            Scalar::Float => Value::Float(self.as_float()),
        }
    }

    /// The type and bit pattern, for hashing.
    pub fn bits(self) -> (Scalar, u32) {
        match self {
            Value::Bool(v) => (Scalar::Bool, u32::from(v)),
            Value::Int(v) => (Scalar::Int, v as u32),
            Value::Uint(v) => (Scalar::Uint, v),
            Value::Float(v) => (Scalar::Float, v.to_bits()),
        }
    }

    /// The result of `bool(x)`.
    pub fn as_bool(self) -> bool {
        match self {
            Value::Bool(v) => v,
            Value::Int(v) => v != 0,
            Value::Uint(v) => v != 0,
            Value::Float(v) => v != 0.0,
        }
    }

    /// The result of `int(x)`.
    pub fn as_int(self) -> i32 {
        match self {
            Value::Bool(v) => v as i32,
            Value::Int(v) => v,
            Value::Uint(v) => v as i32,
            Value::Float(v) => float_to_int(v),
        }
    }

    /// The result of `uint(x)`; a negative float, where it is undefined, is converted via `int`.
    pub fn as_uint(self) -> u32 {
        match self {
            Value::Bool(v) => v as u32,
            Value::Int(v) => v as u32,
            Value::Uint(v) => v,
            Value::Float(v) if v < 0.0 => v as i32 as u32,
            Value::Float(v) => v as u32,
        }
    }

    /// As an `f64`, which represents every scalar exactly.
    pub fn as_double(self) -> f64 {
        match self {
            Value::Bool(v) => v as u8 as f64,
            Value::Int(v) => v as f64,
            Value::Uint(v) => v as f64,
            Value::Float(v) => v as f64,
        }
    }

    /// The result of `float(x)`.
    pub fn as_float(self) -> f32 {
        match self {
            Value::Bool(v) => v as u8 as f32,
            Value::Int(v) => v as f32,
            Value::Uint(v) => v as f32,
            Value::Float(v) => v,
        }
    }

    /// The exact number.
    pub fn as_number(self) -> f64 {
        match self {
            Value::Int(v) => v as f64,
            Value::Uint(v) => v as f64,
            v => v.as_float() as f64,
        }
    }
}

/// `int(x)`. Out-of-range values are undefined; ANGLE uses the result of the processor.
fn float_to_int(x: f32) -> i32 {
    if (-2_147_483_648.0..2_147_483_648.0).contains(&x) {
        x as i32
    } else {
        i32::MIN
    }
}

/// A range of values in a [`Pool`]; empty if the value is unknown.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Constant {
    start: u32,
    len: u32,
}

impl Constant {
    /// An unknown value.
    pub const NONE: Constant = Constant { start: 0, len: 0 };

    /// Whether the value is known.
    pub const fn is_known(self) -> bool {
        self.len > 0
    }

    /// Number of scalars; 0 if the value is unknown.
    pub const fn scalars(self) -> u32 {
        self.len
    }

    /// `len` scalars starting at index `from`; unknown if there are fewer.
    pub fn part(self, from: u32, len: u32) -> Constant {
        if from.checked_add(len).is_some_and(|end| end <= self.len) {
            Constant {
                start: self.start + from,
                len,
            }
        } else {
            Constant::NONE
        }
    }
}

/// Storage for the values of all constants of a shader.
#[derive(Clone, Default, Debug)]
pub struct Pool {
    values: Vec<Value>,
}

impl Pool {
    /// Maximum number of stored scalars; further constants are treated as unknown.
    const LIMIT: usize = 4_000_000;

    /// Stores a sequence of scalars.
    pub fn add(&mut self, values: impl IntoIterator<Item = Value>) -> Constant {
        let start = self.values.len();
        if start > Pool::LIMIT {
            return Constant::NONE;
        }
        self.values.extend(values);
        Constant {
            start: start as u32,
            len: (self.values.len() - start) as u32,
        }
    }

    /// Stores the concatenated values of constants, each mapped by `f`; unknown if one of them is.
    pub fn join(
        &mut self,
        parts: impl IntoIterator<Item = Constant>,
        f: impl Fn(Value) -> Value,
    ) -> Constant {
        let start = self.values.len();
        for part in parts {
            let stored = self.map(part, &f);
            if !stored.is_known() {
                self.values.truncate(start);
                return Constant::NONE;
            }
        }
        Constant {
            start: start as u32,
            len: (self.values.len() - start) as u32,
        }
    }

    /// Stores the values of a constant mapped by `f`.
    pub fn map(&mut self, of: Constant, f: impl Fn(Value) -> Value) -> Constant {
        let start = self.values.len();
        if start > Pool::LIMIT {
            return Constant::NONE;
        }
        for at in of.start as usize..(of.start + of.len) as usize {
            if let Some(&value) = self.values.get(at) {
                self.values.push(f(value));
            }
        }
        Constant {
            start: start as u32,
            len: of.len,
        }
    }

    /// The scalars of a constant.
    pub fn values(&self, constant: Constant) -> &[Value] {
        let start = constant.start as usize;
        self.values
            .get(start..start + constant.len as usize)
            .unwrap_or(&[])
    }

    /// The value of a scalar constant.
    pub fn scalar(&self, constant: Constant) -> Option<Value> {
        match self.values(constant) {
            &[value] => Some(value),
            _ => None,
        }
    }
}
