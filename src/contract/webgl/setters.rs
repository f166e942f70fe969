//! The functions of WebGL that set uniforms.

use crate::interface::DeclaredInput;
use shaderlint_semantic::{Base, Scalar};

/// A function that sets a uniform: `uniform3fv`, `uniformMatrix4fv`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Setter {
    /// Columns and rows of a matrix, or 1 and the number of components.
    pub columns: u8,
    /// Rows, or number of components.
    pub rows: u8,
    /// Type of a component.
    pub scalar: Scalar,
    /// Whether it takes an array.
    pub is_array: bool,
}

impl Setter {
    /// The setter of this name.
    pub fn named(name: &str) -> Option<Setter> {
        let rest = name.strip_prefix("uniform")?;
        if let Some(size) = rest
            .strip_prefix("Matrix")
            .and_then(|rest| rest.strip_suffix("fv"))
        {
            let (columns, rows) = size.split_once('x').unwrap_or((size, size));
            return Some(Setter {
                columns: columns.parse().ok()?,
                rows: rows.parse().ok()?,
                scalar: Scalar::Float,
                is_array: true,
            });
        }
        let (size, kind) = rest.split_at_checked(1)?;
        let (kind, is_array) = match kind.strip_suffix('v') {
            Some(kind) => (kind, true),
            None => (kind, false),
        };
        Some(Setter {
            columns: 1,
            rows: size.parse().ok().filter(|size| (1..=4).contains(size))?,
            scalar: match kind {
                "f" => Scalar::Float,
                "i" => Scalar::Int,
                "ui" => Scalar::Uint,
                _ => return None,
            },
            is_array,
        })
    }

    /// The setter for a uniform.
    fn of(uniform: &DeclaredInput, is_array: bool) -> Option<Setter> {
        if uniform.is_sampler() {
            return Some(Setter {
                columns: 1,
                rows: 1,
                scalar: Scalar::Int,
                is_array,
            });
        }
        let Base::Numeric {
            scalar,
            columns,
            rows,
        } = uniform.ty.base
        else {
            return None;
        };
        Some(Setter {
            columns,
            rows,
            scalar,
            is_array,
        })
    }

    /// Whether it sets a uniform of this type; `None` for structs, whose members are set.
    pub fn fits(self, uniform: &DeclaredInput) -> Option<bool> {
        let needed = Setter::of(uniform, self.is_array)?;
        let is_bool = needed.scalar == Scalar::Bool;
        Some(
            (self.columns, self.rows) == (needed.columns, needed.rows)
                && (is_bool || self.scalar == needed.scalar),
        )
    }

    /// The name of the setter that a uniform needs.
    pub fn name_for(self, uniform: &DeclaredInput) -> Option<String> {
        let Setter {
            columns,
            rows,
            scalar,
            ..
        } = Setter::of(uniform, self.is_array)?;
        if columns > 1 {
            return Some(match columns == rows {
                true => format!("uniformMatrix{columns}fv"),
                false => format!("uniformMatrix{columns}x{rows}fv"),
            });
        }
        let kind = match scalar {
            Scalar::Float => "f",
            Scalar::Uint => "ui",
            Scalar::Int | Scalar::Bool => "i",
        };
        let is_array = self.is_array && self.columns == 1;
        Some(format!(
            "uniform{rows}{kind}{}",
            if is_array { "v" } else { "" }
        ))
    }

    /// Numbers per element.
    pub fn components(self) -> usize {
        usize::from(self.columns) * usize::from(self.rows)
    }
}
