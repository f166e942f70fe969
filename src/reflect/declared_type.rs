//! Types with the members of structs.

use serde::Serialize;
use shaderlint_semantic::{Base, Program, Scalar, Struct, Type};

/// A type of GLSL.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ReflectedType {
    /// Its name, without the size of an array.
    #[serde(rename = "type")]
    pub name: String,
    /// Number of elements of an array.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<u32>,
    /// Component type, columns and rows; `None` for samplers and structs.
    #[serde(skip)]
    pub numeric: Option<(Scalar, u8, u8)>,
    /// The members of a struct.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<DeclaredMember>,
}

/// A member of a struct or block.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct DeclaredMember {
    /// Its name.
    pub name: String,
    /// Its type.
    #[serde(flatten)]
    pub ty: ReflectedType,
}

impl ReflectedType {
    /// Describes a type of a program.
    pub fn of(program: &Program, ty: Type) -> ReflectedType {
        let element = Type { array: 0, ..ty };
        let record = match ty.base {
            Base::Struct(_) => program.struct_of(ty),
            _ => None,
        };
        ReflectedType {
            name: program.type_name(element),
            array: (ty.array > 0).then_some(ty.array),
            numeric: element.numeric(),
            members: record.map_or(Vec::new(), |record| members(program, record)),
        }
    }

    /// The type as it is declared before and after a name, with the members of a struct: equal texts are types
    /// that both stages may share.
    pub fn signature(&self) -> String {
        let mut text = self.name.clone();
        if !self.members.is_empty() {
            text = format!("{text} {{ {} }}", signatures(&self.members));
        }
        match self.array {
            Some(size) => format!("{text}[{size}]"),
            None => text,
        }
    }
}

/// The declarations of members.
pub fn signatures(members: &[DeclaredMember]) -> String {
    let each = members.iter();
    let each = each.map(|member| format!("{} {};", member.ty.signature(), member.name));
    each.collect::<Vec<_>>().join(" ")
}

/// The members of a struct.
pub fn members(program: &Program, record: &Struct) -> Vec<DeclaredMember> {
    let each = record.fields.iter().map(|field| DeclaredMember {
        name: program.names.text(field.name).to_string(),
        ty: ReflectedType::of(program, field.ty),
    });
    each.collect()
}
