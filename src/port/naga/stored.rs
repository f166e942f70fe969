//! The layout of uniforms in buffers: `std140` (OpenGL ES 3.0, section 2.12.6.4). All four target
//! languages can express it, some only with explicit padding.

use super::body::Body;
use super::interface::{BufferMember, Repeated};
use super::lower::NagaLowerer;
use super::target::{Res, Value};
use ::naga::{ArraySize, Handle, MathFunction, StructMember, TypeInner};
use shaderlint_ir::Lanes;
use shaderlint_semantic::{Base, Scalar, Type};
use std::num::NonZeroU32;

/// A type in its buffer layout.
#[derive(Clone, Copy)]
pub(super) struct Stored {
    pub(super) ty: Handle<::naga::Type>,
    pub(super) size: u32,
    /// Alignment in bytes.
    align: u32,
    /// Whether it is a struct or an array of structs, which the target languages would pack more
    /// tightly.
    is_record: bool,
}

/// The layout of the matrices of a member, at any depth.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Major {
    Columns,
    /// Row-major, as with `layout(row_major)`.
    Rows,
}

impl Major {
    /// The stored type: transposed for a row-major matrix.
    fn laid(self, ty: Type) -> Type {
        match (self, ty.element().numeric()) {
            (Major::Rows, Some((_, columns @ 2.., rows))) => {
                let transposed = Type::matrix(rows, columns);
                if ty.is_array() {
                    transposed.array_of(ty.array)
                } else {
                    transposed
                }
            }
            _ => ty,
        }
    }
}

/// The place of a field in a struct.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct StoredField {
    /// The layout of its matrices.
    pub(super) major: Major,
    /// The index of the member.
    pub(super) member: u32,
    /// Offset in bytes from the start of the struct.
    pub(super) offset: u32,
}

/// The layout of a struct with the places of its fields; `None` for samplers.
pub(super) type StoredRecord = (Stored, Vec<Option<StoredField>>);

/// Alignment of arrays, structs and matrices, in bytes.
const ROW: u32 = 16;

/// The members of a struct under construction.
#[derive(Default)]
pub(super) struct Packing {
    members: Vec<StructMember>,
    offset: u32,
}

impl Packing {
    /// Appends a member.
    pub(super) fn add(
        &mut self,
        lowerer: &mut NagaLowerer,
        name: &str,
        stored: Stored,
    ) -> Res<StoredField> {
        if stored.is_record {
            self.pad(lowerer)?;
        }
        let offset = self.offset.next_multiple_of(stored.align);
        let member = self.members.len() as u32;
        self.members.push(StructMember {
            name: Some(name.to_string()),
            ty: stored.ty,
            binding: None,
            offset,
        });
        self.offset = offset.saturating_add(stored.size);
        Ok(StoredField {
            major: Major::Columns,
            member,
            offset,
        })
    }

    /// Adds padding up to the alignment of a struct.
    fn pad(&mut self, lowerer: &mut NagaLowerer) -> Res<()> {
        let ty = lowerer.ty(Type::UINT)?;
        self.offset = self.offset.next_multiple_of(4);
        while !self.offset.is_multiple_of(ROW) {
            self.members.push(StructMember {
                name: Some("padding".to_string()),
                ty,
                binding: None,
                offset: self.offset,
            });
            self.offset += 4;
        }
        Ok(())
    }

    pub(super) fn finish(mut self, lowerer: &mut NagaLowerer, name: Option<String>) -> Res<Stored> {
        self.pad(lowerer)?;
        let size = self.offset.max(ROW);
        let (members, span) = (self.members, size);
        let ty = lowerer.inner(name, TypeInner::Struct { members, span });
        Ok(Stored {
            ty,
            size,
            align: ROW,
            is_record: true,
        })
    }

    /// Whether it has no members.
    pub(super) fn is_empty(&self) -> bool {
        self.members.is_empty()
    }
}

impl NagaLowerer<'_> {
    /// The buffer layout of a type.
    pub(super) fn stored(&mut self, ty: Type, major: Major) -> Res<Stored> {
        let ty = major.laid(ty);
        if ty.is_array() {
            let element = ty.element();
            let stored = match element.numeric() {
                Some((scalar, 1, 1 | 2)) => self.row(scalar)?,
                Some(_) => self.stored(element, Major::Columns)?,
                None => self.stored(element, major)?,
            };
            return self.rows(stored, ty.array);
        }
        let Some((scalar, columns, rows)) = ty.numeric() else {
            return self.stored_record(ty, major);
        };
        let scalar = match scalar {
            Scalar::Bool => Scalar::Uint,
            other => other,
        };
        match (columns, rows) {
            (1, _) => Ok(Stored {
                ty: self.ty(Type::vector(scalar, rows))?,
                size: 4 * u32::from(rows),
                align: 4 * u32::from(rows).next_power_of_two(),
                is_record: false,
            }),
            (_, 2) => {
                let column = self.row(scalar)?;
                self.rows(column, columns.into())
            }
            _ => Ok(Stored {
                ty: self.ty(ty)?,
                size: ROW * u32::from(columns),
                align: ROW,
                is_record: false,
            }),
        }
    }

    /// A vector with four components, of which some may be unused.
    fn row(&mut self, scalar: Scalar) -> Res<Stored> {
        self.stored(Type::vector(scalar, 4), Major::Columns)
    }

    /// An array with the stride that `std140` requires.
    fn rows(&mut self, element: Stored, count: u32) -> Res<Stored> {
        let Some(size) = NonZeroU32::new(count).filter(|n| n.get() != Type::UNSIZED) else {
            return self.refuse("the size of this array is unknown");
        };
        let stride = element.size.next_multiple_of(ROW);
        let ty = self.inner(
            None,
            TypeInner::Array {
                base: element.ty,
                size: ArraySize::Constant(size),
                stride,
            },
        );
        Ok(Stored {
            ty,
            size: stride.saturating_mul(count),
            align: ROW,
            is_record: element.is_record,
        })
    }

    fn stored_record(&mut self, ty: Type, major: Major) -> Res<Stored> {
        if let Some((stored, _)) = self.uniforms.records.get(&(ty, major)) {
            return Ok(*stored);
        }
        let program = self.program;
        let Some(found) = program.struct_of(ty) else {
            return self.refuse("this type cannot be stored in a uniform buffer");
        };
        let mut packing = Packing::default();
        let mut fields = Vec::new();
        for (number, field) in found.fields.iter().enumerate() {
            let major = self.major_of(ty, number).unwrap_or(major);
            // Samplers are stored separately.
            fields.push(match field.ty.is_sampler() {
                true => None,
                false => {
                    let stored = self.stored(field.ty, major)?;
                    let name = program.names.text(field.name);
                    let place = packing.add(self, name, stored)?;
                    Some(StoredField { major, ..place })
                }
            });
        }
        if packing.is_empty() {
            let room = self.stored(Type::UINT, Major::Columns)?;
            packing.add(self, "padding", room)?;
        }
        let name = found.name.map(|n| program.names.text(n));
        let suffix = match major {
            Major::Columns => "Layout",
            Major::Rows => "LayoutByRows",
        };
        let name = format!("{}{suffix}", name.unwrap_or("Struct"));
        let stored = packing.finish(self, Some(name))?;
        self.uniforms.records.insert((ty, major), (stored, fields));
        Ok(stored)
    }

    /// The places of the fields of a struct or block.
    pub(super) fn stored_fields(&self, ty: Type, major: Major) -> &[Option<StoredField>] {
        let record = self.uniforms.records.get(&(ty, major));
        record.map_or(&[], |(_, fields)| fields)
    }

    /// The matrix layout of a block's member; `None` for a member of a struct.
    fn major_of(&self, block: Type, member: usize) -> Option<Major> {
        let Base::Block(record) = block.base else {
            return None;
        };
        let block = self.blocks.iter().find(|b| b.record == record)?;
        Some(match block.members_by_rows.get(member) {
            Some(true) => Major::Rows,
            _ => Major::Columns,
        })
    }

    /// Lists the members of a buffer by name.
    pub(super) fn list(
        &mut self,
        name: &str,
        (ty, major): (Type, Major),
        offset: u32,
        into: &mut Vec<BufferMember>,
    ) {
        let program = self.program;
        let element = ty.element();
        let Some((_, columns, rows)) = element.numeric() else {
            let Some(found) = program.struct_of(element) else {
                return;
            };
            let record = self.uniforms.records.get(&(element, major));
            let size = record.map_or(0, |r| r.0.size);
            for i in 0..ty.array.max(1) {
                let base = match ty.is_array() {
                    true => format!("{name}[{i}]"),
                    false => name.to_string(),
                };
                for (n, field) in found.fields.iter().enumerate() {
                    let place = self.stored_fields(element, major).get(n).copied().flatten();
                    if let Some(place) = place {
                        let own = program.names.text(field.name);
                        let inner = match base.is_empty() {
                            true => own.to_string(),
                            false => format!("{base}.{own}"),
                        };
                        let at = offset + i * size + place.offset;
                        self.list(&inner, (field.ty, place.major), at, into);
                    }
                }
            }
            return;
        };
        let spread = |count: u8, stride| Repeated {
            count: count.into(),
            stride,
        };
        let by_rows = columns > 1 && major == Major::Rows;
        let lines = if by_rows { rows } else { columns };
        into.push(BufferMember {
            name: name.to_string(),
            ty: program.type_name(element),
            offset,
            array: (ty.is_array()).then(|| Repeated {
                count: ty.array,
                stride: ROW * u32::from(lines),
            }),
            columns: (columns > 1 && !by_rows).then(|| spread(columns, ROW)),
            rows: by_rows.then(|| spread(rows, ROW)),
        });
    }
}

/// A place in a buffer.
#[derive(Clone, Copy)]
pub(super) struct StoredPlace {
    /// The pointer to it.
    pub(super) at: Value,
    /// The type of its value in the shader.
    pub(super) ty: Type,
    /// Whether only the first components of a stored vector are used.
    pub(super) is_wide: bool,
    /// The layout of its matrices.
    pub(super) major: Major,
}

impl StoredPlace {
    /// The place at a pointer.
    pub(super) fn new(at: Value, ty: Type, major: Major) -> StoredPlace {
        StoredPlace {
            at,
            ty,
            is_wide: false,
            major,
        }
    }

    /// Whether it is a row-major matrix.
    pub(super) fn is_by_rows(self) -> bool {
        let is_matrix = matches!(self.ty.numeric(), Some((_, 2.., _)));
        self.major == Major::Rows && is_matrix && !self.ty.is_array()
    }
}

impl Body<'_, '_> {
    /// A field of a struct or block.
    pub(super) fn held_field(&mut self, held: StoredPlace, index: u32) -> Res<StoredPlace> {
        let program = self.lowerer.program;
        let fields = self.lowerer.stored_fields(held.ty, held.major);
        let place = fields.get(index as usize).copied().flatten();
        let found = program.struct_of(held.ty);
        match (place, found.and_then(|s| s.fields.get(index as usize))) {
            (Some(place), Some(field)) => {
                let at = self.part(held.at, place.member);
                Ok(StoredPlace::new(at, field.ty, place.major))
            }
            _ => self.lowerer.refuse("a sampler cannot be used as a value"),
        }
    }

    /// An element, a column or a component.
    pub(super) fn held_part(&self, held: StoredPlace, at: Value) -> StoredPlace {
        let (ty, is_row) = match held.ty.numeric() {
            _ if held.ty.is_array() => (held.ty.element(), true),
            Some((scalar, 2.., rows)) => (Type::vector(scalar, rows), true),
            Some((scalar, ..)) => (Type::scalar(scalar), false),
            None => (Type::ERROR, false),
        };
        let is_wide = is_row && matches!(ty.numeric(), Some((_, 1, 1 | 2)));
        StoredPlace {
            at,
            ty,
            is_wide,
            major: held.major,
        }
    }

    /// Loads the value at a place.
    pub(super) fn unpack(&mut self, held: StoredPlace) -> Res<Value> {
        self.check_limits()?;
        let ty = held.ty;
        if held.is_by_rows() {
            let transposed = StoredPlace::new(held.at, held.major.laid(ty), Major::Columns);
            let rows = self.unpack(transposed)?;
            return Ok(self.math(MathFunction::Transpose, &[rows]));
        }
        let count = match (ty.is_array(), ty.numeric()) {
            (true, _) => ty.array,
            (false, None) => {
                let fields = self.lowerer.stored_fields(ty, held.major).len() as u32;
                let fields = (0..fields).map(|i| {
                    let field = self.held_field(held, i)?;
                    self.unpack(field)
                });
                let fields = fields.collect::<Res<Vec<_>>>()?;
                return self.compose(ty, fields);
            }
            (false, Some((_, columns @ 2.., 2))) => columns.into(),
            (false, Some((scalar, _, rows))) => {
                let mut value = self.load(held.at);
                if held.is_wide {
                    value = self.swizzle(value, Lanes::new(0..rows));
                }
                return Ok(match scalar {
                    Scalar::Bool => self.convert(value, Scalar::Bool),
                    _ => value,
                });
            }
        };
        let parts = (0..count).map(|i| {
            let at = self.part(held.at, i);
            let part = self.held_part(held, at);
            self.unpack(part)
        });
        let parts = parts.collect::<Res<Vec<_>>>()?;
        self.compose(ty, parts)
    }
}
