//! Type information of one shader.

use crate::types::*;
use shaderlint_syntax::{Feature, Version};

/// Type information of one shader: its structs and the version of the language.
#[derive(Clone, Copy)]
pub struct Types<'a> {
    /// Structs and blocks, by index.
    pub structs: &'a [Struct],
    /// The version of the language.
    pub version: Version,
}

impl Types<'_> {
    /// The contents of a type, at any depth.
    pub fn inside(self, ty: Type) -> Inside {
        let record = |id: u16| self.structs.get(id as usize).map(|s| s.inside);
        Inside::of(ty, |id| record(id).unwrap_or_default())
    }

    /// Number of scalars in a value of a type.
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

    pub(super) fn has(self, feature: Feature) -> bool {
        self.version.has(feature)
    }
}
