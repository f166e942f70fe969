//! Comparison of declarations in the two stages.

use rustc_hash::FxHashMap;
use shaderlint_diagnostic::count;
use shaderlint_semantic::interface::{Interface, PrecisionWord};
use shaderlint_semantic::{Base, Field, Program, Type};
use shaderlint_syntax::ast::TokenId;

/// A declaration to compare.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredType {
    /// The token that names it.
    pub token: TokenId,
    /// Its type, including the array size.
    pub ty: Type,
    /// Its precision, if the type has one.
    pub precision: Option<PrecisionWord>,
}

/// The first difference between two declarations.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Path to the differing member: `.light.color`.
    pub path: String,
    pub kind: Differing,
    /// The token in the vertex shader, and its declaration as text.
    pub vertex: (TokenId, String),
    /// The token in the fragment shader, and its declaration as text.
    pub fragment: (TokenId, String),
}

/// Kinds of differences.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Differing {
    /// The type or the array size.
    Type,
    Precision,
    /// The names of the structs.
    StructName,
    /// Names or number of members.
    Members,
}

/// Whether precisions are compared.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PrecisionMatch {
    /// They must match.
    Same,
    /// They may differ.
    Free,
}

/// Compares declarations of two shaders.
pub struct InterfaceComparison<'a, 'p> {
    vertex: &'a Interface<'p>,
    fragment: &'a Interface<'p>,
    /// Results for pairs of structs compared so far.
    known: FxHashMap<(u16, u16, PrecisionMatch), Option<Difference>>,
}

impl<'a, 'p> InterfaceComparison<'a, 'p> {
    /// A comparison of two shaders.
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

    /// The first difference between two declarations, if any.
    pub fn difference(
        &mut self,
        vertex: DeclaredType,
        fragment: DeclaredType,
        precisions: PrecisionMatch,
    ) -> Option<Difference> {
        if let (Base::Struct(v), Base::Struct(f)) = (vertex.ty.base, fragment.ty.base) {
            let names = (
                record_name(self.vertex.program, v),
                record_name(self.fragment.program, f),
            );
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
            vertex: (vertex.token, type_name(self.vertex.program, vertex.ty)),
            fragment: (
                fragment.token,
                type_name(self.fragment.program, fragment.ty),
            ),
        })
    }

    /// The first difference between two structs or blocks. Structs nest at most four levels deep.
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
        if v.fields.len() != f.fields.len() {
            return Some(Difference {
                path: String::new(),
                kind: Differing::Members,
                vertex: (v.token, count(v.fields.len(), "member")),
                fragment: (f.token, count(f.fields.len(), "member")),
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

/// Members in the order of the linker: samplers last.
fn in_order(fields: &[Field]) -> impl Iterator<Item = &Field> {
    let others = fields.iter().filter(|f| !f.ty.is_sampler());
    others.chain(fields.iter().filter(|f| f.ty.is_sampler()))
}

fn is_record(ty: Type) -> bool {
    matches!(ty.base, Base::Struct(_) | Base::Block(_))
}

/// Name of a struct or block; empty if it has none.
fn record_name(program: &Program, id: u16) -> &str {
    let record = program.structs.get(id as usize);
    let name = record.and_then(|s| s.name);
    name.map_or("", |n| program.names.text(n))
}

/// A type as shown in messages.
fn type_name(program: &Program, ty: Type) -> String {
    match ty.base {
        Base::Struct(id) if !record_name(program, id).is_empty() => {
            format!("struct {}", program.type_name(ty))
        }
        Base::Struct(_) => "struct without a name".to_string(),
        _ => program.type_name(ty),
    }
}
