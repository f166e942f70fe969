//! Values known before the shader runs (GLSL ES 3.00 section 4.3.3).
//!
//! Every value is a run of scalars: a vector's components, a matrix column by column, an array
//! element by element, a struct member by member.

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
    /// Converted as a constructor converts (section 5.4.1).
    pub fn to(self, scalar: Scalar) -> Value {
        match scalar {
            Scalar::Bool => Value::Bool(self.as_bool()),
            Scalar::Int => Value::Int(self.as_int()),
            Scalar::Uint => Value::Uint(self.as_uint()),
            Scalar::Float => Value::Float(self.as_float()),
        }
    }

    /// As `bool(x)`.
    pub fn as_bool(self) -> bool {
        match self {
            Value::Bool(v) => v,
            Value::Int(v) => v != 0,
            Value::Uint(v) => v != 0,
            Value::Float(v) => v != 0.0,
        }
    }

    /// As `int(x)`.
    pub fn as_int(self) -> i32 {
        match self {
            Value::Bool(v) => v as i32,
            Value::Int(v) => v,
            Value::Uint(v) => v as i32,
            Value::Float(v) => float_to_int(v),
        }
    }

    /// As `uint(x)`; a negative float, whose conversion is undefined, goes through `int`.
    pub fn as_uint(self) -> u32 {
        match self {
            Value::Bool(v) => v as u32,
            Value::Int(v) => v as u32,
            Value::Uint(v) => v,
            Value::Float(v) if v < 0.0 => v as i32 as u32,
            Value::Float(v) => v as u32,
        }
    }

    /// As a number that holds all that the scalars hold.
    pub fn as_double(self) -> f64 {
        match self {
            Value::Bool(v) => v as u8 as f64,
            Value::Int(v) => v as f64,
            Value::Uint(v) => v as f64,
            Value::Float(v) => v as f64,
        }
    }

    /// As `float(x)`.
    pub fn as_float(self) -> f32 {
        match self {
            Value::Bool(v) => v as u8 as f32,
            Value::Int(v) => v as f32,
            Value::Uint(v) => v as f32,
            Value::Float(v) => v,
        }
    }
}

/// `int(x)`. What is out of range is undefined; ANGLE gives what the processor does.
fn float_to_int(x: f32) -> i32 {
    if (-2_147_483_648.0..2_147_483_648.0).contains(&x) {
        x as i32
    } else {
        i32::MIN
    }
}

/// A run of values in a [`Pool`]; empty where nothing is known.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Constant {
    start: u32,
    len: u32,
}

impl Constant {
    /// Nothing is known.
    pub const NONE: Constant = Constant { start: 0, len: 0 };

    /// Whether the value is known.
    pub const fn is_known(self) -> bool {
        self.len > 0
    }

    /// How many scalars it is made of; 0 where they are not known.
    pub const fn scalars(self) -> u32 {
        self.len
    }

    /// `len` scalars from the one with number `from`; nothing where it has fewer.
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

/// Holds the values of all constants of a shader.
#[derive(Clone, Default, Debug)]
pub struct Pool {
    values: Vec<Value>,
}

impl Pool {
    /// Most scalars that are kept; constants beyond are treated as unknown.
    const LIMIT: usize = 4_000_000;

    /// Stores values.
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

    /// Stores the values of constants, end to end, each as `f` makes it; nothing where one of them
    /// is not known.
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

    /// Stores the values of a constant as `f` makes them.
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
