//! The types of a program and their spelling.

use super::Writer;
use shaderlint::semantic::{Base, Sampler, Scalar, Type};

impl Writer {
    /// A type before a name; arrays without their size.
    pub(super) fn base_name(&self, ty: Type) -> String {
        match ty.base {
            Base::Numeric {
                scalar,
                columns: 1,
                rows,
            } => scalar_or_vector(scalar, rows),
            Base::Numeric { columns, rows, .. } if columns == rows => format!("mat{columns}"),
            Base::Numeric { columns, rows, .. } => format!("mat{columns}x{rows}"),
            Base::Sampler(sampler) => sampler.name().to_string(),
            Base::Struct(id) => self
                .structs
                .get(id as usize)
                .map_or(String::new(), |s| s.name.clone()),
            _ => "void".to_string(),
        }
    }

    /// A type that no name follows.
    pub(super) fn type_name(&self, ty: Type) -> String {
        match ty.array {
            0 => self.base_name(ty),
            n => format!("{}[{n}]", self.base_name(ty)),
        }
    }

    /// A type and a name, with the array size before or after the name.
    pub(super) fn typed(&mut self, ty: Type, name: &str) -> String {
        if !ty.is_array() {
            return format!("{} {name}", self.base_name(ty));
        }
        let size = self.array_size(ty.array);
        if self.is_300 && self.one_in(3) {
            format!("{}[{size}] {name}", self.base_name(ty))
        } else {
            format!("{} {name}[{size}]", self.base_name(ty))
        }
    }

    /// An array size: a constant expression with that value.
    fn array_size(&mut self, size: u32) -> String {
        if self.mistake() {
            let odd = ["0", "-1", "", "1.0", "u1", "(1, 2)", "2][2", "true"];
            return self.pick(&odd).to_string();
        }
        match self.below(8) {
            0 => format!("{} + 1", size - 1),
            1 if self.is_300 => format!("{size}u"),
            2 => format!("int({size}.5)"),
            3 => format!("true ? {size} : 1"),
            _ => size.to_string(),
        }
    }

    pub(super) fn scalar(&mut self) -> Scalar {
        match self.below(if self.is_300 { 8 } else { 7 }) {
            0 => Scalar::Bool,
            1 | 2 => Scalar::Int,
            7 => Scalar::Uint,
            _ => Scalar::Float,
        }
    }

    /// A scalar, vector or matrix.
    pub(super) fn numeric_type(&mut self) -> Type {
        let scalar = self.scalar();
        let rows = self.below(5).max(1) as u8;
        match self.below(8) {
            0 | 1 => Type::scalar(scalar),
            2 if self.is_300 => Type::matrix(rows.max(2), self.below(5).max(2) as u8),
            2 => Type::matrix(rows.max(2), rows.max(2)),
            _ => Type::vector(scalar, rows),
        }
    }

    /// A type that a variable may have.
    pub(super) fn value_type(&mut self) -> Type {
        let known: Vec<usize> = self.scopes.iter().flat_map(|s| s.structs.clone()).collect();
        let ty = if !known.is_empty() && self.one_in(7) {
            let at = self.below(known.len());
            let seen = known.get(at).copied().filter(|&id| {
                let name = self.structs.get(id).map(|s| s.name.clone());
                let scope = name.and_then(|n| self.scope_of(&n));
                scope.is_some_and(|s| self.scopes[s].structs.contains(&id))
            });
            match seen {
                Some(id) => Type {
                    base: Base::Struct(id as u16),
                    array: 0,
                },
                None => self.numeric_type(),
            }
        } else {
            self.numeric_type()
        };
        if self.one_in(8) {
            ty.array_of(self.below(4) as u32 + 1)
        } else {
            ty
        }
    }

    /// A type whose values can be constructed and passed: GLSL ES 1.00 has no array values.
    pub(super) fn plain_type(&mut self) -> Type {
        loop {
            let ty = self.value_type();
            if self.is_300 || !self.holds_array(ty) {
                return ty;
            }
        }
    }

    pub(super) fn holds_array(&self, ty: Type) -> bool {
        ty.is_array()
            || match ty.base {
                Base::Struct(id) => self
                    .structs
                    .get(id as usize)
                    .is_some_and(|s| s.fields.iter().any(|f| self.holds_array(f.1))),
                _ => false,
            }
    }

    pub(super) fn holds_sampler(&self, ty: Type) -> bool {
        match ty.base {
            Base::Sampler(_) => true,
            Base::Struct(id) => self
                .structs
                .get(id as usize)
                .is_some_and(|s| s.fields.iter().any(|f| self.holds_sampler(f.1))),
            _ => false,
        }
    }

    pub(super) fn sampler(&mut self) -> Sampler {
        use Sampler as S;
        let old = [S::Sampler2D, S::SamplerCube];
        let new = [
            S::Sampler2D,
            S::Sampler3D,
            S::SamplerCube,
            S::Sampler2DArray,
            S::Isampler2D,
            S::Usampler2D,
            S::Sampler2DShadow,
        ];
        let at = self.below(if self.is_300 { new.len() } else { old.len() });
        if self.is_300 { new[at] } else { old[at] }
    }

    /// Sometimes `highp `, if the type accepts a precision.
    pub(super) fn precision(&mut self, ty: Type) -> &'static str {
        let takes = match ty.base {
            Base::Numeric { scalar, .. } => scalar != Scalar::Bool,
            Base::Sampler(_) => true,
            _ => false,
        };
        if takes && self.one_in(6) || !takes && self.mistake() {
            ["lowp ", "mediump ", "highp "][self.below(3)]
        } else {
            ""
        }
    }
}

fn scalar_or_vector(scalar: Scalar, rows: u8) -> String {
    let letter = match scalar {
        Scalar::Bool => "b",
        Scalar::Int => "i",
        Scalar::Uint => "u",
        Scalar::Float => "",
    };
    match rows {
        1 => scalar.name().to_string(),
        n => format!("{letter}vec{n}"),
    }
}
