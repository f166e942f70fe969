//! Where the members of uniform blocks are in their buffers: the layout `std140` (OpenGL ES 3.0, section 2.12.6.4).

use super::interface::{Block, Interface};
use crate::{Base, Program, Type};

/// The alignment of vectors of four, arrays and structs, in bytes.
const ROW: u32 = 16;
/// Maximum number of members that are listed.
const MAX_MEMBERS: usize = 4096;

/// A member of a block that is no struct, with its place in the buffer in bytes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BlockMember {
    /// The path in the block, as WebGL names it: `lamps[0].power`.
    pub name: String,
    /// The type; arrays are listed once.
    pub ty: Type,
    /// First byte.
    pub offset: u32,
    /// Bytes from the first to the last component.
    pub size: u32,
    /// Bytes from an element of an array to the next, 0 for no array.
    pub stride: u32,
}

/// The layout of a block.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct BlockLayout {
    /// The members in order.
    pub members: Vec<BlockMember>,
    /// Bytes of the block.
    pub size: u32,
}

impl BlockLayout {
    /// The layout of a block; `None` if a type is unknown or it is too large.
    pub fn of(interface: &Interface, block: &Block) -> Option<BlockLayout> {
        let program = interface.program;
        let mut found = BlockLayout::default();
        let mut end = 0;
        let record = program.structs.get(usize::from(block.record))?;
        let name = program.names.text(block.name);
        let prefix = if block.instance.is_some() {
            format!("{name}.")
        } else {
            String::new()
        };
        for (index, field) in record.fields.iter().enumerate() {
            let by_rows = block
                .members_by_rows
                .get(index)
                .copied()
                .unwrap_or(block.by_rows);
            let path = format!("{prefix}{}", program.names.text(field.name));
            end = found.place(program, (&path, field.ty, by_rows), end)?;
        }
        found.size = end;
        Some(found)
    }

    /// Places a member after a byte and returns the byte after it.
    fn place(
        &mut self,
        program: &Program,
        (path, ty, by_rows): (&str, Type, bool),
        end: u32,
    ) -> Option<u32> {
        let start = end.next_multiple_of(alignment(program, ty)?);
        let element = Type { array: 0, ..ty };
        if !matches!(ty.base, Base::Struct(_)) {
            let size = size(element, by_rows)?;
            let stride = size.next_multiple_of(ROW);
            let (bytes, after) = match ty.array {
                0 => (size, size),
                count => (
                    stride.checked_mul(count - 1)?.checked_add(size)?,
                    stride.checked_mul(count)?,
                ),
            };
            let is_array = ty.array > 0;
            self.members.push(BlockMember {
                name: if is_array {
                    format!("{path}[0]")
                } else {
                    path.to_string()
                },
                ty,
                offset: start,
                size: bytes,
                stride: if is_array { stride } else { 0 },
            });
            return (self.members.len() < MAX_MEMBERS).then(|| start.checked_add(after))?;
        }
        let record = program.struct_of(ty)?;
        let mut at = start;
        for number in 0..ty.array.max(1) {
            let path = match ty.array {
                0 => path.to_string(),
                _ => format!("{path}[{number}]"),
            };
            for field in &record.fields {
                let path = format!("{path}.{}", program.names.text(field.name));
                at = self.place(program, (&path, field.ty, by_rows), at)?;
            }
            at = at.next_multiple_of(ROW);
        }
        Some(at)
    }
}

/// The alignment of a type in bytes.
fn alignment(program: &Program, ty: Type) -> Option<u32> {
    let element = Type { array: 0, ..ty };
    match (element.numeric(), ty.base) {
        (Some((_, 1, rows)), _) if ty.array == 0 => Some(4 * u32::from(rows).next_power_of_two()),
        (Some(_), _) => Some(ROW),
        (None, Base::Struct(_)) => program.struct_of(ty).map(|_| ROW),
        _ => None,
    }
}

/// The bytes of a type that is no array and no struct.
fn size(ty: Type, by_rows: bool) -> Option<u32> {
    let (_, columns, rows) = ty.numeric()?;
    let (columns, rows) = (u32::from(columns), u32::from(rows));
    Some(match (columns, by_rows) {
        (1, _) => 4 * rows,
        // Each vector of a matrix has the room of four components.
        (_, false) => ROW * columns,
        (_, true) => ROW * rows,
    })
}
