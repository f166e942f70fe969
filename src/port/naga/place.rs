//! Places that can be written to: variables, members, elements and components.

use super::body::{Body, Bound};
use super::types::Sink;
use super::{Res, Value};
use crate::semantic::{Resolution, Type};
use crate::syntax::Name;
use crate::syntax::ast::{ExprId, ExprKind};
use ::naga::{Expression, SwizzleComponent};

/// A place.
#[derive(Clone, Debug)]
pub(super) enum Place {
    /// What this points at.
    Pointer(Value),
    /// Some components of the vector that `vector` points at.
    Lanes {
        /// Points at the vector.
        vector: Value,
        /// The numbers of the components.
        lanes: Vec<u32>,
    },
}

/// A part that a `.name` picks.
pub(super) enum Part {
    /// A member, or one component.
    One(u32),
    /// Several components.
    Many(Vec<u32>),
}

impl Body<'_, '_> {
    /// The place that an expression names.
    pub(super) fn place(&mut self, id: ExprId) -> Res<Place> {
        let program = self.lowerer.program;
        let id = program.tree.unparen(id);
        match program.tree.expr(id).kind {
            ExprKind::Name(_) => {
                let Resolution::Variable(variable) = program.expr(id).resolution else {
                    return self.refuse(id, "this cannot be written to");
                };
                let outer = std::mem::replace(&mut self.lowerer.place, program.expr_span(id));
                let Bound::Pointer(pointer) = self.bound(variable)? else {
                    return self.refuse(id, "this cannot be written to");
                };
                self.lowerer.place = outer;
                Ok(Place::Pointer(pointer))
            }
            ExprKind::Member(base, name) => {
                let part = self.member(base, name)?;
                let place = self.place(base)?;
                self.pick(place, part)
            }
            ExprKind::Index(base, index) => {
                let place = self.place(base)?;
                self.element(place, index)
            }
            _ => self.refuse(id, "this cannot be written to"),
        }
    }

    /// What `.name` picks of a value.
    pub(super) fn member(&mut self, base: ExprId, name: Name) -> Res<Part> {
        let program = self.lowerer.program;
        let text = program.names.text(name);
        let ty = program.ty(base);
        if let Some(found) = program.struct_of(ty) {
            return match found.fields.iter().position(|f| f.name == name) {
                Some(index) => Ok(Part::One(index as u32)),
                None => self.refuse(base, "this member is not known"),
            };
        }
        let lane = |c: char| {
            ["xrs", "ygt", "zbp", "waq"]
                .iter()
                .position(|s| s.contains(c))
        };
        let lanes: Vec<u32> = text.chars().filter_map(lane).map(|l| l as u32).collect();
        match lanes[..] {
            [] => self.refuse(base, "these components are not known"),
            [one] => Ok(Part::One(one)),
            _ => Ok(Part::Many(lanes)),
        }
    }

    fn pick(&mut self, place: Place, part: Part) -> Res<Place> {
        Ok(match (place, part) {
            (Place::Pointer(base), Part::One(index)) => Place::Pointer(self.part(base, index)),
            (Place::Pointer(vector), Part::Many(lanes)) => Place::Lanes { vector, lanes },
            (Place::Lanes { vector, lanes }, Part::One(index)) => {
                let lane = lanes.get(index as usize).copied().unwrap_or(0);
                Place::Pointer(self.part(vector, lane))
            }
            (Place::Lanes { vector, lanes }, Part::Many(inner)) => {
                let of = |i: &u32| lanes.get(*i as usize).copied().unwrap_or(0);
                let lanes = inner.iter().map(of).collect();
                Place::Lanes { vector, lanes }
            }
        })
    }

    fn element(&mut self, place: Place, index: ExprId) -> Res<Place> {
        let known = self.known_index(index);
        match (place, known) {
            (Place::Pointer(base), Some(index)) => Ok(Place::Pointer(self.part(base, index))),
            (Place::Pointer(base), None) => {
                let index = self.value(index)?;
                Ok(Place::Pointer(self.add(Expression::Access { base, index })))
            }
            (lanes, Some(index)) => self.pick(lanes, Part::One(index)),
            (_, None) => self.refuse(index, "an index that is computed, of chosen components"),
        }
    }

    /// The value of an index, if it is a constant.
    pub(super) fn known_index(&self, id: ExprId) -> Option<u32> {
        let program = self.lowerer.program;
        let id = program.tree.unparen(id);
        u32::try_from(program.scalar(id)?.as_int()).ok()
    }

    /// Whether a place is part of a variable, and so is read where it lies.
    pub(super) fn is_stored(&self, mut id: ExprId) -> bool {
        let program = self.lowerer.program;
        loop {
            match program.tree.expr(id).kind {
                ExprKind::Paren(inner) | ExprKind::Member(inner, _) | ExprKind::Index(inner, _) => {
                    id = inner
                }
                ExprKind::Name(_) => {
                    let Resolution::Variable(variable) = program.expr(id).resolution else {
                        return false;
                    };
                    return self.is_pointer(variable);
                }
                _ => return false,
            }
        }
    }

    /// What stands at a place.
    pub(super) fn read(&mut self, place: &Place) -> Value {
        match place {
            Place::Pointer(pointer) => self.load(*pointer),
            Place::Lanes { vector, lanes } => {
                let vector = self.load(*vector);
                self.swizzle(vector, lanes)
            }
        }
    }

    /// Writes to a place.
    pub(super) fn write(&mut self, place: &Place, value: Value) {
        match place {
            Place::Pointer(pointer) => self.store(*pointer, value),
            Place::Lanes { vector, lanes } => {
                for (i, lane) in lanes.iter().enumerate() {
                    let from = self.part(value, i as u32);
                    let to = self.part(*vector, *lane);
                    self.store(to, from);
                }
            }
        }
    }

    /// Some components of a vector, as a vector.
    pub(super) fn swizzle(&mut self, vector: Value, lanes: &[u32]) -> Value {
        let lane = |i: usize| match lanes.get(i) {
            Some(1) => SwizzleComponent::Y,
            Some(2) => SwizzleComponent::Z,
            Some(3) => SwizzleComponent::W,
            _ => SwizzleComponent::X,
        };
        self.add(Expression::Swizzle {
            size: super::types::size(lanes.len() as u8),
            vector,
            pattern: [lane(0), lane(1), lane(2), lane(3)],
        })
    }

    /// Refuses an expression.
    pub(super) fn refuse<T>(&mut self, id: ExprId, message: impl Into<String>) -> Res<T> {
        self.lowerer.place = self.lowerer.program.expr_span(id);
        self.lowerer.refuse(message)
    }

    /// A vector of equal components, for the type that is wanted.
    pub(super) fn splat(&mut self, value: Value, ty: Type) -> Value {
        match ty.numeric() {
            Some((_, 1, rows @ 2..)) => self.add(Expression::Splat {
                size: super::types::size(rows),
                value,
            }),
            _ => value,
        }
    }
}
