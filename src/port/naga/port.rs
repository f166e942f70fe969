//! Values passed between stages: attributes, varyings and outputs, with their locations.

use super::interface::Port;
use super::lower::NagaLowerer;
use ::naga::{Binding, Interpolation, Sampling};
use shaderlint_ir::Layout;
use shaderlint_semantic::{Program, Scalar, Stage, Storage, Type, VariableId};
use shaderlint_syntax::ast::{DeclKind, Item, List, QualifierKind};
use std::collections::BTreeSet;

/// A scalar or vector in a variable that is passed between stages. The target languages pass only
/// these.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    /// The variable that it is part of.
    pub(super) variable: VariableId,
    /// The indexes of members, elements and columns that lead to it.
    pub(super) path: Vec<u32>,
    pub(super) name: String,
    /// A scalar or vector type.
    pub(super) ty: Type,
    pub(super) location: u32,
    /// Whether it is `centroid`.
    is_centroid: bool,
}

impl Leaf {
    /// Its entry in the resource interface.
    pub(super) fn port(&self, program: &Program) -> Port {
        Port {
            name: self.name.clone(),
            ty: program.type_name(self.ty),
            location: self.location,
        }
    }

    /// The name in the target language.
    pub(super) fn word(&self) -> String {
        self.name.replace(['[', ']', '.'], "_")
    }

    /// The binding between two stages.
    pub(super) fn varying(&self, lowerer: &NagaLowerer) -> Binding {
        let is_flat = lowerer
            .form
            .variable(self.variable)
            .is_some_and(|v| v.is_flat);
        let (interpolation, sampling) = match self.ty.scalar_kind() {
            Some(Scalar::Float) if !is_flat => {
                let sampling = self.is_centroid.then_some(Sampling::Centroid);
                (Interpolation::Perspective, sampling)
            }
            _ => (Interpolation::Flat, None),
        };
        Binding::Location {
            location: self.location,
            interpolation: Some(interpolation),
            sampling,
            blend_src: None,
            per_primitive: false,
        }
    }

    /// Whether it is not interpolated.
    pub(super) fn is_flat(&self, lowerer: &NagaLowerer) -> bool {
        let binding = self.varying(lowerer);
        matches!(
            binding,
            Binding::Location {
                interpolation: Some(Interpolation::Flat),
                ..
            }
        )
    }
}

/// A location without interpolation.
pub(super) fn location(location: u32) -> Binding {
    Binding::Location {
        location,
        interpolation: None,
        sampling: None,
        blend_src: None,
        per_primitive: false,
    }
}

/// The varyings of a vertex shader with their locations, which the fragment shader uses too.
pub(super) fn varyings(program: &Program) -> Vec<(String, u32)> {
    let leaves = leaves(program, Storage::Output, &[]);
    leaves.into_iter().map(|l| (l.name, l.location)).collect()
}

/// The scalars and vectors of the variables of a storage class, in source order. Known locations
/// come first, then those in the source.
pub(super) fn leaves(program: &Program, storage: Storage, known: &[(String, u32)]) -> Vec<Leaf> {
    let mut all: Vec<Vec<Leaf>> = Vec::new();
    let mut taken: BTreeSet<u32> = known.iter().map(|(_, location)| *location).collect();
    let mut free = Vec::new();
    let layout = Layout::of(program);
    for (id, qualifiers) in declarations(program) {
        let Some(variable) = program.variable(id).filter(|v| v.storage == storage) else {
            continue;
        };
        let name = program.names.text(variable.name);
        let mut inner = Vec::new();
        split(
            (program, &layout),
            id,
            name,
            variable.ty,
            &mut Vec::new(),
            &mut inner,
        );
        let mut given = program.tree.qualifiers(qualifiers).iter();
        let is_centroid = given.any(|q| q.kind == QualifierKind::Centroid);
        inner.iter_mut().for_each(|l| l.is_centroid = is_centroid);
        let number = |leaf: &Leaf| known.iter().find(|(name, _)| *name == leaf.name);
        let first = match inner.first().and_then(number) {
            Some((_, location)) => Some(*location),
            None => explicit(program, qualifiers),
        };
        match first {
            Some(first) => {
                number_from(&mut inner, first);
                taken.extend(inner.iter().map(|l| l.location));
            }
            None => free.push(all.len()),
        }
        all.push(inner);
    }
    let mut next = 0;
    for i in free {
        if let Some(inner) = all.get_mut(i) {
            let count = inner.len() as u32;
            while (next..next + count).any(|n| taken.contains(&n)) {
                next += 1;
            }
            number_from(inner, next);
            next += count;
        }
    }
    all.into_iter().flatten().collect()
}

fn number_from(leaves: &mut [Leaf], first: u32) {
    for (leaf, location) in leaves.iter_mut().zip(first..) {
        leaf.location = location;
    }
}

/// Splits a value into its scalars and vectors.
pub(super) fn split(
    (program, layout): (&Program, &Layout),
    variable: VariableId,
    name: &str,
    ty: Type,
    path: &mut Vec<u32>,
    into: &mut Vec<Leaf>,
) {
    if ty.is_scalar() || ty.is_vector() {
        into.push(Leaf {
            variable,
            path: path.clone(),
            name: name.to_string(),
            ty,
            location: 0,
            is_centroid: false,
        });
        return;
    }
    let found = program.struct_of(ty).filter(|_| !ty.is_array());
    for (i, part) in (0..).zip(layout.parts(ty)) {
        let field = found.and_then(|s| s.fields.get(i as usize));
        let inner = match field {
            Some(field) => format!("{name}.{}", program.names.text(field.name)),
            None => format!("{name}[{i}]"),
        };
        path.push(i);
        split((program, layout), variable, &inner, part, path, into);
        path.pop();
    }
}

/// The variables at global scope with their qualifiers, in source order.
fn declarations(program: &Program) -> Vec<(VariableId, List)> {
    let mut found = Vec::new();
    for item in &program.tree.items {
        let Item::Decl(id) = item else { continue };
        let Some(decl) = program.tree.decl(*id) else {
            continue;
        };
        let DeclKind::Variables {
            qualifiers,
            declarators,
            ..
        } = decl.kind
        else {
            continue;
        };
        let declared = declarators.start as usize..(declarators.start + declarators.len) as usize;
        let declared = program.declared.get(declared).unwrap_or(&[]);
        found.extend(declared.iter().flatten().map(|id| (*id, qualifiers)));
    }
    found
}

/// The number in `layout(location = n)`.
fn explicit(program: &Program, qualifiers: List) -> Option<u32> {
    let tree = &program.tree;
    let layouts = tree
        .qualifiers(qualifiers)
        .iter()
        .filter_map(|q| match q.kind {
            QualifierKind::Layout(entries) => Some(tree.layout(entries)),
            _ => None,
        });
    let mut entries = layouts.flatten();
    let entry = entries.find(|e| program.names.text(e.ident.name) == "location")?;
    u32::try_from(entry.value?.value).ok()
}

/// The name of a stage in the resource interface.
pub(super) const fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex",
        Stage::Fragment => "fragment",
    }
}

/// The name of the entry point.
pub(super) const fn entry_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex_main",
        Stage::Fragment => "fragment_main",
    }
}
