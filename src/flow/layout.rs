//! How values lie in scalar lanes.
//!
//! A scalar is one lane. A vector is a lane for each component and one more for its length, which
//! conditions and functions often speak of. A matrix is its columns, a struct its members. All
//! elements of an array share the lanes of one.

use shaderlint_semantic::{Base, Program, Type};

/// Most lanes of a struct; of a larger one nothing is known.
const MAX_LANES: u32 = 512;

/// How the types of a shader lie in lanes.
#[derive(Debug)]
pub struct Layout {
    records: Vec<Record>,
}

#[derive(Debug)]
struct Record {
    lanes: u32,
    /// By member: its first lane, and its type.
    members: Vec<(u32, Type)>,
}

impl Layout {
    /// Lays out the structs of a shader; each is made of those before it.
    pub fn of(program: &Program) -> Layout {
        let mut layout = Layout {
            records: Vec::with_capacity(program.structs.len()),
        };
        for made in &program.structs {
            let mut lanes = 0u32;
            let mut members = Vec::with_capacity(made.fields.len());
            for field in &made.fields {
                members.push((lanes, field.ty));
                lanes = lanes.saturating_add(layout.lanes(field.ty));
            }
            if lanes > MAX_LANES {
                lanes = 0;
                members.clear();
            }
            layout.records.push(Record { lanes, members });
        }
        layout
    }

    /// How many lanes a value of a type has.
    pub fn lanes(&self, ty: Type) -> u32 {
        match ty.base {
            Base::Numeric { columns, rows, .. } => columns as u32 * column_lanes(rows),
            Base::Struct(id) | Base::Block(id) => {
                self.records.get(id as usize).map_or(0, |r| r.lanes)
            }
            Base::Error | Base::Void | Base::Sampler(_) => 0,
        }
    }

    /// The first lane of a struct's member, and the member's type.
    pub fn member(&self, ty: Type, number: u32) -> Option<(u32, Type)> {
        match ty.base {
            Base::Struct(id) | Base::Block(id) => {
                let record = self.records.get(id as usize)?;
                record.members.get(number as usize).copied()
            }
            _ => None,
        }
    }

    /// The first lane of a part of a value that has a number: a member, a column, a component, an
    /// element.
    pub fn part(&self, ty: Type, number: u32) -> Option<u32> {
        if ty.is_array() {
            return Some(0);
        }
        match ty.base {
            Base::Numeric {
                columns: columns @ 2..,
                rows,
                ..
            } => Some(number.min(columns as u32 - 1) * column_lanes(rows)),
            Base::Numeric { rows, .. } => Some(number.min(rows as u32 - 1)),
            _ => self.member(ty, number).map(|(first, _)| first),
        }
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
