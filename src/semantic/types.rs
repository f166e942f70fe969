//! Types (GLSL ES 3.00 section 4.1).

use shaderlint_syntax::{Name, TypeWord};

/// Component type of numbers, vectors and matrices.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Scalar {
    /// `bool`
    Bool,
    /// `int`
    Int,
    /// `uint`
    Uint,
    /// `float`
    Float,
}

impl Scalar {
    /// The type's name in GLSL.
    pub const fn name(self) -> &'static str {
        match self {
            Scalar::Bool => "bool",
            Scalar::Int => "int",
            Scalar::Uint => "uint",
            Scalar::Float => "float",
        }
    }

    /// The literal in GLSL of a value given by its bits; NaN and infinity by their names.
    pub fn literal(self, bits: u32) -> String {
        match self {
            Scalar::Bool => (bits != 0).to_string(),
            Scalar::Int => (bits as i32).to_string(),
            Scalar::Uint => format!("{bits}u"),
            Scalar::Float => format!("{:?}", f32::from_bits(bits)),
        }
    }

    /// Whether it is `int` or `uint`.
    pub const fn is_integer(self) -> bool {
        matches!(self, Scalar::Int | Scalar::Uint)
    }
}

/// Sampler types.
#[expect(missing_docs, reason = "the variants are standard terms")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[rustfmt::skip]
pub enum Sampler {
    Sampler2D, Sampler3D, SamplerCube, Sampler2DArray,
    Isampler2D, Isampler3D, IsamplerCube, Isampler2DArray,
    Usampler2D, Usampler3D, UsamplerCube, Usampler2DArray,
    Sampler2DShadow, SamplerCubeShadow, Sampler2DArrayShadow,
}

impl Sampler {
    /// The type's name in GLSL.
    pub const fn name(self) -> &'static str {
        match self {
            Sampler::Sampler2D => "sampler2D",
            Sampler::Sampler3D => "sampler3D",
            Sampler::SamplerCube => "samplerCube",
            Sampler::Sampler2DArray => "sampler2DArray",
            Sampler::Isampler2D => "isampler2D",
            Sampler::Isampler3D => "isampler3D",
            Sampler::IsamplerCube => "isamplerCube",
            Sampler::Isampler2DArray => "isampler2DArray",
            Sampler::Usampler2D => "usampler2D",
            Sampler::Usampler3D => "usampler3D",
            Sampler::UsamplerCube => "usamplerCube",
            Sampler::Usampler2DArray => "usampler2DArray",
            Sampler::Sampler2DShadow => "sampler2DShadow",
            Sampler::SamplerCubeShadow => "samplerCubeShadow",
            Sampler::Sampler2DArrayShadow => "sampler2DArrayShadow",
        }
    }

    /// Whether it has a predefined default precision (section 4.5.4).
    pub const fn has_default_precision(self) -> bool {
        matches!(self, Sampler::Sampler2D | Sampler::SamplerCube)
    }
}

/// A type without the array size.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Base {
    /// The type of something with a reported error; compatible with everything, so that one mistake
    /// gives one error.
    Error,
    /// `void`
    Void,
    /// A scalar (1 column, 1 row), vector (1 column) or matrix.
    Numeric {
        /// Component type.
        scalar: Scalar,
        /// Number of columns; 1 for scalars and vectors.
        columns: u8,
        /// Number of rows; the number of components of a vector.
        rows: u8,
    },
    /// A sampler.
    Sampler(Sampler),
    /// A struct, by index in [`Program`](super::Program).
    Struct(u16),
    /// An interface block, by index in [`Program`](super::Program).
    Block(u16),
}

/// A type. Arrays have one dimension, as in GLSL ES 3.00.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Type {
    /// The type, or the element type of an array.
    pub base: Base,
    /// Array size; 0 for no array, [`Type::UNSIZED`] for an unknown size.
    pub array: u32,
}

// Passed by value everywhere, so it should fit in a register.
const _: () = assert!(size_of::<Type>() <= 8);

impl Type {
    /// The array size of `float a[]`.
    pub const UNSIZED: u32 = u32::MAX;
    /// See [`Base::Error`].
    pub const ERROR: Type = Type {
        base: Base::Error,
        array: 0,
    };
    /// `void`
    pub const VOID: Type = Type {
        base: Base::Void,
        array: 0,
    };
    /// `bool`
    pub const BOOL: Type = Type::scalar(Scalar::Bool);
    /// `int`
    pub const INT: Type = Type::scalar(Scalar::Int);
    /// `uint`
    pub const UINT: Type = Type::scalar(Scalar::Uint);
    /// `float`
    pub const FLOAT: Type = Type::scalar(Scalar::Float);

    /// A scalar type.
    pub const fn scalar(scalar: Scalar) -> Type {
        Type::vector(scalar, 1)
    }

    /// A vector of `rows` components; one component makes a scalar.
    pub const fn vector(scalar: Scalar, rows: u8) -> Type {
        Type {
            base: Base::Numeric {
                scalar,
                columns: 1,
                rows,
            },
            array: 0,
        }
    }

    /// A matrix.
    pub const fn matrix(columns: u8, rows: u8) -> Type {
        Type {
            base: Base::Numeric {
                scalar: Scalar::Float,
                columns,
                rows,
            },
            array: 0,
        }
    }

    /// A struct type, by index. Beyond the representable number of structs, the type is an error
    /// type, so nothing is reported.
    pub const fn structure(id: u32) -> Type {
        let base = match id <= u16::MAX as u32 {
            true => Base::Struct(id as u16),
            false => Base::Error,
        };
        Type { base, array: 0 }
    }

    /// An interface block, by index.
    pub const fn block(id: u32) -> Type {
        match Type::structure(id).base {
            Base::Struct(id) => Type {
                base: Base::Block(id),
                array: 0,
            },
            _ => Type::ERROR,
        }
    }

    /// A sampler.
    pub const fn sampler(sampler: Sampler) -> Type {
        Type {
            base: Base::Sampler(sampler),
            array: 0,
        }
    }

    /// Zero as a value of a numeric or boolean type, in GLSL syntax.
    pub fn zero(self) -> Option<String> {
        let zero = match self.scalar_kind().filter(|_| !self.is_array())? {
            Scalar::Float => "0.0",
            Scalar::Int => "0",
            Scalar::Uint => "0u",
            Scalar::Bool => "false",
        };
        Some(match self.is_scalar() {
            true => zero.to_string(),
            false => format!("{}({zero})", type_name(self, |_| String::new())),
        })
    }

    /// The type of a built-in type name.
    pub const fn of_word(word: TypeWord) -> Type {
        use Sampler as S;
        use Scalar::*;
        use TypeWord as W;
        match word {
            W::Bool => Type::BOOL,
            W::Int => Type::INT,
            W::Uint => Type::UINT,
            W::Float => Type::FLOAT,
            W::Vec2 => Type::vector(Float, 2),
            W::Vec3 => Type::vector(Float, 3),
            W::Vec4 => Type::vector(Float, 4),
            W::Bvec2 => Type::vector(Bool, 2),
            W::Bvec3 => Type::vector(Bool, 3),
            W::Bvec4 => Type::vector(Bool, 4),
            W::Ivec2 => Type::vector(Int, 2),
            W::Ivec3 => Type::vector(Int, 3),
            W::Ivec4 => Type::vector(Int, 4),
            W::Uvec2 => Type::vector(Uint, 2),
            W::Uvec3 => Type::vector(Uint, 3),
            W::Uvec4 => Type::vector(Uint, 4),
            W::Mat2 => Type::matrix(2, 2),
            W::Mat2x3 => Type::matrix(2, 3),
            W::Mat2x4 => Type::matrix(2, 4),
            W::Mat3x2 => Type::matrix(3, 2),
            W::Mat3 => Type::matrix(3, 3),
            W::Mat3x4 => Type::matrix(3, 4),
            W::Mat4x2 => Type::matrix(4, 2),
            W::Mat4x3 => Type::matrix(4, 3),
            W::Mat4 => Type::matrix(4, 4),
            W::Sampler2D => Type::sampler(S::Sampler2D),
            W::Sampler3D => Type::sampler(S::Sampler3D),
            W::SamplerCube => Type::sampler(S::SamplerCube),
            W::Sampler2DArray => Type::sampler(S::Sampler2DArray),
            W::Isampler2D => Type::sampler(S::Isampler2D),
            W::Isampler3D => Type::sampler(S::Isampler3D),
            W::IsamplerCube => Type::sampler(S::IsamplerCube),
            W::Isampler2DArray => Type::sampler(S::Isampler2DArray),
            W::Usampler2D => Type::sampler(S::Usampler2D),
            W::Usampler3D => Type::sampler(S::Usampler3D),
            W::UsamplerCube => Type::sampler(S::UsamplerCube),
            W::Usampler2DArray => Type::sampler(S::Usampler2DArray),
            W::Sampler2DShadow => Type::sampler(S::Sampler2DShadow),
            W::SamplerCubeShadow => Type::sampler(S::SamplerCubeShadow),
            W::Sampler2DArrayShadow => Type::sampler(S::Sampler2DArrayShadow),
        }
    }

    /// The array of `size` elements of this type.
    pub const fn array_of(self, size: u32) -> Type {
        Type {
            base: self.base,
            array: size,
        }
    }

    /// The element type of an array; the type itself if it is not an array.
    pub const fn element(self) -> Type {
        Type {
            base: self.base,
            array: 0,
        }
    }

    /// Whether it is [`Base::Error`].
    pub const fn is_error(self) -> bool {
        matches!(self.base, Base::Error)
    }

    /// Whether it is `void`.
    pub const fn is_void(self) -> bool {
        matches!(self.base, Base::Void)
    }

    /// Whether it is an array.
    pub const fn is_array(self) -> bool {
        self.array != 0
    }

    /// Whether it is a sampler, or an array of samplers.
    pub const fn is_sampler(self) -> bool {
        matches!(self.base, Base::Sampler(_))
    }

    /// The sampler type; `None` for arrays and other types.
    pub const fn as_sampler(self) -> Option<Sampler> {
        match self.base {
            Base::Sampler(sampler) if self.array == 0 => Some(sampler),
            _ => None,
        }
    }

    /// Component type, columns and rows of a scalar, vector or matrix; `None` for arrays and other
    /// types.
    pub const fn numeric(self) -> Option<(Scalar, u8, u8)> {
        match self.base {
            Base::Numeric {
                scalar,
                columns,
                rows,
            } if self.array == 0 => Some((scalar, columns, rows)),
            _ => None,
        }
    }

    /// Component type; `None` for arrays and other types.
    pub const fn scalar_kind(self) -> Option<Scalar> {
        match self.numeric() {
            Some((scalar, ..)) => Some(scalar),
            None => None,
        }
    }

    /// Whether it is a single number or `bool`.
    pub const fn is_scalar(self) -> bool {
        matches!(self.numeric(), Some((_, 1, 1)))
    }

    /// Whether it is a vector of 2 to 4 components.
    pub const fn is_vector(self) -> bool {
        matches!(self.numeric(), Some((_, 1, 2..)))
    }

    /// Whether it is a matrix.
    pub const fn is_matrix(self) -> bool {
        matches!(self.numeric(), Some((_, 2.., _)))
    }

    /// Number of components of a number, vector or matrix; 0 for everything else.
    pub const fn components(self) -> u32 {
        match self.numeric() {
            Some((_, columns, rows)) => columns as u32 * rows as u32,
            None => 0,
        }
    }

    /// The same shape with another component type.
    pub const fn with_scalar(self, scalar: Scalar) -> Type {
        match self.base {
            Base::Numeric { columns, rows, .. } => Type {
                base: Base::Numeric {
                    scalar,
                    columns,
                    rows,
                },
                array: self.array,
            },
            _ => self,
        }
    }
}

/// A member of a struct or block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Field {
    /// Name of the member.
    pub name: Name,
    /// Declared type.
    pub ty: Type,
    /// Index of the token that names it.
    pub token: u32,
}

/// A struct, or the members of an interface block.
#[derive(Clone, Debug)]
pub struct Struct {
    /// Name; `None` if it is anonymous.
    pub name: Option<Name>,
    /// Index of the token that names it, or of its `{`.
    pub token: u32,
    /// Members in order.
    pub fields: Vec<Field>,
    /// Properties of its contents, at any depth.
    pub inside: Inside,
}

/// Properties of the contents of a type at any depth. Cached per struct, so that queries do not
/// traverse structs again.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Inside {
    /// Nesting depth of structs; 0 for other types.
    pub nesting: u32,
    /// Whether it contains an array.
    pub array: bool,
    /// Whether it contains a sampler.
    pub sampler: bool,
    /// Whether it contains an `int` or `uint`.
    pub integer: bool,
    /// Size of a variable, in bytes.
    pub bytes: u64,
    /// Size of a uniform, in bytes; each vector uses the space of a `vec4`.
    pub uniform_bytes: u64,
}

impl Inside {
    /// The contents of a type, given those of its struct.
    pub fn of(ty: Type, record: impl FnOnce(u16) -> Inside) -> Inside {
        let mut inside = match ty.base {
            Base::Struct(id) | Base::Block(id) => record(id),
            Base::Numeric {
                scalar,
                columns,
                rows,
            } => Inside {
                integer: scalar.is_integer(),
                bytes: columns as u64 * rows as u64 * 4,
                uniform_bytes: match columns {
                    1 => 16,
                    _ => columns.max(rows) as u64 * 16,
                },
                ..Inside::default()
            },
            base => Inside {
                sampler: matches!(base, Base::Sampler(_)),
                bytes: 4,
                uniform_bytes: 4,
                ..Inside::default()
            },
        };
        let count = ty.array.max(1) as u64;
        inside.array |= ty.is_array();
        inside.bytes = inside.bytes.saturating_mul(count);
        inside.uniform_bytes = inside.uniform_bytes.saturating_mul(count);
        inside
    }

    /// Adds the contents of a member.
    pub fn add(&mut self, member: Inside) {
        self.nesting = self.nesting.max(member.nesting + 1);
        self.array |= member.array;
        self.sampler |= member.sampler;
        self.integer |= member.integer;
        self.bytes = self.bytes.saturating_add(member.bytes);
        self.uniform_bytes = self.uniform_bytes.saturating_add(member.uniform_bytes);
    }
}

/// Name of a numeric type.
fn numeric_name(scalar: Scalar, columns: u8, rows: u8) -> String {
    let prefix = match scalar {
        Scalar::Bool => "b",
        Scalar::Int => "i",
        Scalar::Uint => "u",
        Scalar::Float => "",
    };
    match (columns, rows) {
        (1, 1) => scalar.name().to_string(),
        (1, n) => format!("{prefix}vec{n}"),
        (c, r) if c == r => format!("mat{c}"),
        (c, r) => format!("mat{c}x{r}"),
    }
}

/// A type in GLSL syntax; `struct_name` returns the names of structs and blocks.
pub fn type_name(ty: Type, struct_name: impl Fn(u16) -> String) -> String {
    let base = match ty.base {
        Base::Error => "?".to_string(),
        Base::Void => "void".to_string(),
        Base::Numeric {
            scalar,
            columns,
            rows,
        } => numeric_name(scalar, columns, rows),
        Base::Sampler(sampler) => sampler.name().to_string(),
        Base::Struct(id) | Base::Block(id) => struct_name(id),
    };
    match ty.array {
        0 => base,
        Type::UNSIZED => format!("{base}[]"),
        n => format!("{base}[{n}]"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_printed_as_glsl() {
        let name = |ty| type_name(ty, |_| "S".to_string());
        assert_eq!(name(Type::matrix(2, 3)), "mat2x3");
        assert_eq!(name(Type::vector(Scalar::Uint, 4).array_of(3)), "uvec4[3]");
        assert_eq!(
            name(Type {
                base: Base::Struct(0),
                array: Type::UNSIZED
            }),
            "S[]"
        );
        for word in TypeWord::ALL {
            assert_eq!(
                name(Type::of_word(word)).to_lowercase(),
                format!("{word:?}").to_lowercase()
            );
        }
    }
}
