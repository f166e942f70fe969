//! How values lie, for all that take them apart: which parts they have, and where those begin in
//! scalars and in lanes.
//!
//! In scalars, a vector is its components, a matrix its columns, an array its elements, a struct
//! its members. In lanes, which analyses speak of, a vector has one more for its length, which
//! conditions and functions often speak of, and all elements of an array share the lanes of one.

use shaderlint_semantic::{Base, Program, Type};

/// Most lanes of a struct; of a larger one nothing is known.
const MAX_LANES: u32 = 512;

/// How the types of a shader lie.
#[derive(Debug)]
pub struct Layout {
    records: Vec<Record>,
}

#[derive(Debug)]
struct Record {
    lanes: u32,
    scalars: Option<u32>,
    members: Vec<PartLayout>,
}

/// A member, an element, a column or a component of a value.
#[derive(Clone, Copy, Debug)]
pub struct PartLayout {
    /// Its type.
    pub ty: Type,
    /// Its first lane.
    pub lane: u32,
    /// Its first scalar; `None` for too many, or where that is not known.
    pub scalar: Option<u32>,
}

impl Layout {
    /// Lays out the structs of a shader; each is made of those before it.
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
            layout.records.push(Record {
                lanes: if lane > MAX_LANES { 0 } else { lane },
                scalars: scalar,
                members,
            });
        }
        layout
    }

    fn record(&self, ty: Type) -> Option<&Record> {
        match ty.base {
            Base::Struct(id) | Base::Block(id) => self.records.get(id as usize),
            _ => None,
        }
    }

    /// How many lanes a value of a type has.
    pub fn lanes(&self, ty: Type) -> u32 {
        match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * column_lanes(rows),
            _ => self.record(ty).map_or(0, |r| r.lanes),
        }
    }

    /// How many scalars a value of a type has: `None` for too many, or where that is not known.
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

    /// How many parts a value has.
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

    /// The part with a number. Of one that is not there the place is where it would be in scalars,
    /// and that of the last one in lanes.
    pub fn part(&self, ty: Type, number: u32) -> Option<PartLayout> {
        if ty.is_array() {
            let ty = ty.element();
            let scalar = self.scalars(ty).and_then(|each| each.checked_mul(number));
            return Some(PartLayout {
                ty,
                lane: 0,
                scalar,
            });
        }
        let Some((kind, columns, rows)) = ty.numeric() else {
            return self.record(ty)?.members.get(number as usize).copied();
        };
        let (ty, lanes, count) = match columns {
            1 => (Type::scalar(kind), 1, rows),
            _ => (Type::vector(kind, rows), column_lanes(rows), columns),
        };
        Some(PartLayout {
            ty,
            lane: number.min(count as u32 - 1) * lanes,
            scalar: number.checked_mul(ty.components()),
        })
    }

    /// The first lane of the part with a number; `None` where its value has no lanes.
    pub fn lane(&self, ty: Type, number: u32) -> Option<u32> {
        let part = self.part(ty, number)?;
        (ty.is_array() || self.lanes(ty) > 0).then_some(part.lane)
    }

    /// The types of all parts of a value.
    pub fn parts(&self, ty: Type) -> impl Iterator<Item = Type> {
        (0..self.count(ty)).filter_map(move |number| Some(self.part(ty, number)?.ty))
    }
}

/// The lanes of a scalar or vector with this many components.
pub const fn column_lanes(rows: u8) -> u32 {
    if rows > 1 {
        rows as u32 + 1
    } else {
        rows as u32
    }
}

/// The lane that holds the length of a vector or of an array's vectors.
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
