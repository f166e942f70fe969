//! The layout of values: the parts of a type, and their offsets in scalars and in lanes.
//!
//! Scalars are for code generation: a vector consists of its components, a matrix of its columns,
//! an array of its elements, a struct of its members. Lanes are for the analyses: a vector has one
//! additional lane for its length, which conditions and built-in functions often constrain, and all
//! elements of an array share the same lanes.

use shaderlint_semantic::{Base, Program, Type};

/// Maximum number of lanes of a struct; larger structs have none and are not analysed.
const MAX_LANES: u32 = 512;

/// The layout of all types of a shader.
#[derive(Debug)]
pub struct Layout {
    records: Vec<RecordLayout>,
}

#[derive(Debug)]
struct RecordLayout {
    lanes: u32,
    scalars: Option<u32>,
    members: Vec<PartLayout>,
}

/// A member, element, column or component of a value.
#[derive(Clone, Copy, Debug)]
pub struct PartLayout {
    /// The type of the part.
    pub ty: Type,
    /// Offset of its first lane.
    pub lane: u32,
    /// Offset of its first scalar; `None` if it overflows or is not known.
    pub scalar: Option<u32>,
}

impl Layout {
    /// Lays out the structs of a shader, in declaration order.
    pub fn of(program: &Program) -> Layout {
        let mut layout = Layout {
            records: Vec::with_capacity(program.structs.len()),
        };
        for made in &program.structs {
            let (mut lane, mut scalar) = (0u32, Some(0u32));
            let mut members = Vec::with_capacity(made.fields.len());
            for field in &made.fields {
                let ty = field.ty;
                members.push(PartLayout { ty, lane, scalar });
                lane = lane.saturating_add(layout.lanes(ty));
                let before = scalar.zip(layout.scalars(ty));
                scalar = before.and_then(|(before, own)| before.checked_add(own));
            }
            layout.records.push(RecordLayout {
                lanes: if lane > MAX_LANES { 0 } else { lane },
                scalars: scalar,
                members,
            });
        }
        layout
    }

    fn record(&self, ty: Type) -> Option<&RecordLayout> {
        match ty.base {
            Base::Struct(id) | Base::Block(id) => self.records.get(id as usize),
            _ => None,
        }
    }

    /// The number of lanes of a type.
    pub fn lanes(&self, ty: Type) -> u32 {
        match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * column_lanes(rows),
            _ => self.record(ty).map_or(0, |r| r.lanes),
        }
    }

    /// The number of scalars of a type; `None` if it overflows or is not known.
    pub fn scalars(&self, ty: Type) -> Option<u32> {
        let one = match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * rows as u32,
            Base::Struct(_) | Base::Block(_) => self.record(ty)?.scalars?,
            Base::Void | Base::Sampler(_) => 0,
            Base::Error => return None,
        };
        match ty.array {
            0 => Some(one),
            Type::UNSIZED => None,
            n => one.checked_mul(n),
        }
    }

    /// The number of parts of a type.
    pub fn count(&self, ty: Type) -> u32 {
        match (ty.is_array(), ty.base) {
            (true, _) => ty.array,
            (
                _,
                Base::Numeric {
                    columns: 1, rows, ..
                },
            ) => rows as u32,
            (_, Base::Numeric { columns, .. }) => columns as u32,
            _ => self.record(ty).map_or(0, |r| r.members.len() as u32),
        }
    }

    /// The part at an index. An index out of range is extrapolated in scalars, and clamped to the
    /// last part in lanes.
    pub fn part(&self, ty: Type, index: u32) -> Option<PartLayout> {
        if ty.is_array() {
            let ty = ty.element();
            let scalar = self.scalars(ty).and_then(|each| each.checked_mul(index));
            return Some(PartLayout {
                ty,
                lane: 0,
                scalar,
            });
        }
        let Some((kind, columns, rows)) = ty.numeric() else {
            return self.record(ty)?.members.get(index as usize).copied();
        };
        let (ty, lanes, count) = match columns {
            1 => (Type::scalar(kind), 1, rows),
            _ => (Type::vector(kind, rows), column_lanes(rows), columns),
        };
        Some(PartLayout {
            ty,
            lane: index.min(count as u32 - 1) * lanes,
            scalar: index.checked_mul(ty.components()),
        })
    }

    /// The first lane of the part at an index; `None` if the type has no lanes.
    pub fn lane(&self, ty: Type, index: u32) -> Option<u32> {
        let part = self.part(ty, index)?;
        (ty.is_array() || self.lanes(ty) > 0).then_some(part.lane)
    }

    /// The types of all parts.
    pub fn parts(&self, ty: Type) -> impl Iterator<Item = Type> {
        (0..self.count(ty)).filter_map(move |index| Some(self.part(ty, index)?.ty))
    }
}

/// The number of lanes of a scalar or vector with this many components.
pub const fn column_lanes(rows: u8) -> u32 {
    if rows > 1 {
        rows as u32 + 1
    } else {
        rows as u32
    }
}

/// The lane of the length of a vector, or of an array of vectors.
pub const fn length_lane(ty: Type) -> Option<u32> {
    match ty.base {
        Base::Numeric {
            columns: 1,
            rows: rows @ 2..,
            ..
        } => Some(rows as u32),
        _ => None,
    }
}
