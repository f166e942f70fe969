//! Whether two declarations of one thing are the same, and where they differ first.

use super::interface::{Interface, PrecisionWord};
use crate::{Base, Field, Type};
use rustc_hash::FxHashMap;
use shaderlint_syntax::ast::TokenId;

/// One of the two declarations: the token that names it, its type and its precision.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredType {
    /// The token.
    pub token: TokenId,
    /// The type.
    pub ty: Type,
    /// The precision, where the type has one.
    pub precision: Option<PrecisionWord>,
}

/// Where two declarations differ, and what each of them says there.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The members that lead there: `.light.color`.
    pub path: String,
    /// What differs.
    pub kind: Differing,
    /// The token in the vertex shader, and what it declares.
    pub vertex: (TokenId, String),
    /// The token in the fragment shader, and what it declares.
    pub fragment: (TokenId, String),
}

/// What differs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Differing {
    /// The type or the array size.
    Type,
    /// The precision.
    Precision,
    /// The names of two structs.
    StructName,
    /// Names or number of members.
    Members,
}

/// Whether precisions are compared.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PrecisionMatch {
    /// They must be the same.
    Same,
    /// Each stage may have its own.
    Free,
}

/// Compares declarations of two shaders.
pub struct InterfaceComparison<'a, 'p> {
    vertex: &'a Interface<'p>,
    fragment: &'a Interface<'p>,
    /// Structs that were compared, and how they differ: each pair is looked at once.
    known: FxHashMap<(u16, u16, PrecisionMatch), Option<Difference>>,
}

impl<'a, 'p> InterfaceComparison<'a, 'p> {
    /// Nothing is compared yet.
    pub fn new(
        vertex: &'a Interface<'p>,
        fragment: &'a Interface<'p>,
    ) -> InterfaceComparison<'a, 'p> {
        InterfaceComparison {
            vertex,
            fragment,
            known: FxHashMap::default(),
        }
    }

    /// Where two declarations differ first, if they do.
    pub fn difference(
        &mut self,
        vertex: DeclaredType,
        fragment: DeclaredType,
        precisions: PrecisionMatch,
    ) -> Option<Difference> {
        if let (Base::Struct(v), Base::Struct(f)) = (vertex.ty.base, fragment.ty.base) {
            let names = (self.vertex.record_name(v), self.fragment.record_name(f));
            if vertex.ty.array == fragment.ty.array && names.0 == names.1 {
                return self.records(v, f, precisions);
            }
            let kind = if names.0 == names.1 {
                Differing::Type
            } else {
                Differing::StructName
            };
            return self.types(vertex, fragment, kind);
        }
        if vertex.ty != fragment.ty || is_record(vertex.ty) {
            return self.types(vertex, fragment, Differing::Type);
        }
        if precisions == PrecisionMatch::Same && vertex.precision != fragment.precision {
            let of = |d: DeclaredType, i: &Interface| {
                let ty = i.program.type_name(d.ty);
                let text = d.precision.map_or(ty.clone(), |p| format!("{p} {ty}"));
                (d.token, text)
            };
            return Some(Difference {
                path: String::new(),
                kind: Differing::Precision,
                vertex: of(vertex, self.vertex),
                fragment: of(fragment, self.fragment),
            });
        }
        None
    }

    fn types(
        &self,
        vertex: DeclaredType,
        fragment: DeclaredType,
        kind: Differing,
    ) -> Option<Difference> {
        Some(Difference {
            path: String::new(),
            kind,
            vertex: (vertex.token, self.vertex.type_name(vertex.ty)),
            fragment: (fragment.token, self.fragment.type_name(fragment.ty)),
        })
    }

    /// Where two structs or blocks of one name differ first. Structs nest at most four deep.
    pub fn records(
        &mut self,
        vertex: u16,
        fragment: u16,
        precisions: PrecisionMatch,
    ) -> Option<Difference> {
        let key = (vertex, fragment, precisions);
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let found = self.members(vertex, fragment, precisions);
        self.known.insert(key, found.clone());
        found
    }

    fn members(&mut self, v: u16, f: u16, precisions: PrecisionMatch) -> Option<Difference> {
        let of = |i: &'a Interface, id: u16| i.program.structs.get(id as usize);
        let (v, f) = (of(self.vertex, v)?, of(self.fragment, f)?);
        let count = |n: usize| match n {
            1 => "1 member".to_string(),
            n => format!("{n} members"),
        };
        if v.fields.len() != f.fields.len() {
            return Some(Difference {
                path: String::new(),
                kind: Differing::Members,
                vertex: (v.token, count(v.fields.len())),
                fragment: (f.token, count(f.fields.len())),
            });
        }
        for (v, f) in in_order(&v.fields).zip(in_order(&f.fields)) {
            let names = (self.vertex.text(v.name), self.fragment.text(f.name));
            if names.0 != names.1 {
                return Some(Difference {
                    path: String::new(),
                    kind: Differing::Members,
                    vertex: (v.token, format!("`{}`", names.0)),
                    fragment: (f.token, format!("`{}`", names.1)),
                });
            }
            let declared = |field: &Field, i: &Interface| DeclaredType {
                token: field.token,
                ty: field.ty,
                precision: i.member_precision(field.token),
            };
            let sides = (declared(v, self.vertex), declared(f, self.fragment));
            if let Some(mut found) = self.difference(sides.0, sides.1, precisions) {
                found.path = format!(".{}{}", names.0, found.path);
                return Some(found);
            }
        }
        None
    }
}

/// The members in the order of the linker: samplers behind all others.
fn in_order(fields: &[Field]) -> impl Iterator<Item = &Field> {
    let others = fields.iter().filter(|f| !f.ty.is_sampler());
    others.chain(fields.iter().filter(|f| f.ty.is_sampler()))
}

fn is_record(ty: Type) -> bool {
    matches!(ty.base, Base::Struct(_) | Base::Block(_))
}

impl Interface<'_> {
    /// Name of a struct or block; empty where it has none.
    pub fn record_name(&self, id: u16) -> &str {
        let record = self.program.structs.get(id as usize);
        let name = record.and_then(|s| s.name);
        name.map_or("", |n| self.program.names.text(n))
    }

    /// A type in messages.
    fn type_name(&self, ty: Type) -> String {
        match ty.base {
            Base::Struct(id) if !self.record_name(id).is_empty() => {
                format!("struct {}", self.program.type_name(ty))
            }
            Base::Struct(_) => "struct without a name".to_string(),
            _ => self.program.type_name(ty),
        }
    }
}
