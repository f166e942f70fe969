//! Uniform blocks with the places of their members.

use super::declared_type::{DeclaredMember, ReflectedType, members};
use serde::Serialize;
use shaderlint_semantic::BlockLayout;
use shaderlint_semantic::interface::{Block, Interface};

/// A uniform block.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ReflectedBlock {
    /// Its name.
    pub name: String,
    /// The name of its instance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instance: Option<String>,
    /// Number of instances, if they are an array.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<u32>,
    /// Bytes of its buffer.
    pub size: u32,
    /// Its members as they are declared.
    #[serde(skip)]
    pub declared: Vec<DeclaredMember>,
    /// Its members by the names that WebGL has for them, with their places in the buffer.
    pub members: Vec<PlacedMember>,
}

/// A member of a block with its place in the buffer (`std140`), in bytes.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct PlacedMember {
    /// The name in WebGL, such as `Lights.color` or `lamps[0].power`.
    pub name: String,
    /// Its type.
    #[serde(flatten)]
    pub ty: ReflectedType,
    /// Its first byte.
    pub offset: u32,
    /// From the first byte to the last one.
    pub size: u32,
    /// From an element of an array to the next one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stride: Option<u32>,
}

impl ReflectedBlock {
    /// Describes a block; `None` if it has no layout.
    pub fn of(interface: &Interface, block: &Block) -> Option<ReflectedBlock> {
        let program = interface.program;
        let layout = BlockLayout::of(interface, block)?;
        let record = program.structs.get(usize::from(block.record))?;
        let placed = layout.members.iter().map(|member| PlacedMember {
            name: member.name.clone(),
            ty: ReflectedType::of(program, member.ty),
            offset: member.offset,
            size: member.size,
            stride: (member.stride > 0).then_some(member.stride),
        });
        let instance = block.instance.and_then(|(token, _)| program.token(token));
        Some(ReflectedBlock {
            name: program.names.text(block.name).to_string(),
            instance: instance.map(|token| program.sources.text(token.span).to_string()),
            array: block
                .instance
                .map(|(_, size)| size)
                .filter(|size| *size > 0),
            size: layout.size,
            declared: members(program, record),
            members: placed.collect(),
        })
    }
}
