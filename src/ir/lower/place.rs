//! Lowering of places: loads and stores of variables and their parts.

use super::super::form::*;
use super::Lowerer;
use shaderlint_semantic::{Base, Scalar, Type, VariableId};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::*;

/// A place under construction, before it is added to the module.
pub(super) struct PlacePath {
    variable: VariableId,
    path: Vec<Access>,
    /// The components of a swizzle at its end.
    lanes: Option<Lanes>,
    pub ty: Type,
}

/// The destination of an assignment.
#[derive(Clone, Copy)]
pub(super) enum AssignTarget {
    Place(PlaceId),
    /// A dynamically indexed component of a swizzle: `v.zx[i]`.
    Component {
        /// The swizzle.
        of: PlaceId,
        /// The index into the swizzle.
        index: OpId,
    },
    /// Not assignable; this was already reported.
    Nothing,
}

/// What a `.name` selects.
pub(super) enum Picked {
    /// The index and type of a member.
    Member(u32, Type),
    /// A swizzle.
    Lanes(Lanes),
    /// There is no such member or component.
    Nothing,
}

impl Lowerer<'_> {
    /// What `.name` selects from a value of this type.
    pub(super) fn picked(&self, ty: Type, name: Name) -> Picked {
        if Self::is_record(ty) {
            let fields = self.program.struct_of(ty).map_or(&[][..], |s| &s.fields);
            let mut numbered = (0..).zip(fields);
            return match numbered.find(|(_, f)| f.name == name) {
                Some((number, field)) => Picked::Member(number, field.ty),
                None => Picked::Nothing,
            };
        }
        let sets = ["xyzw", "rgba", "stpq"];
        let number = |c: char| sets.iter().find_map(|set| set.find(c));
        let text = self.program.names.text(name);
        match ty.is_vector() {
            true => Picked::Lanes(Lanes::new(text.chars().filter_map(number).map(|n| n as u8))),
            false => Picked::Nothing,
        }
    }

    /// The place that an expression denotes; `None` if it is not a variable or part of one. Indices
    /// are evaluated here, in order.
    pub(super) fn place_path(&mut self, id: ExprId) -> Option<PlacePath> {
        let program = self.program;
        match program.tree.expr(id).kind {
            ExprKind::Paren(inner) => self.place_path(inner),
            ExprKind::Name(_) => {
                let variable = program.variable_of(id)?;
                Some(PlacePath {
                    variable,
                    path: Vec::new(),
                    lanes: None,
                    ty: program.variable(variable)?.ty,
                })
            }
            ExprKind::Member(object, name) => {
                let mut place_path = self.deeper(|l| l.place_path(object))??;
                match self.picked(place_path.ty, name) {
                    Picked::Member(number, ty) => {
                        place_path.path.push(Access::Member(number));
                        place_path.ty = ty;
                    }
                    Picked::Lanes(lanes) => place_path.take_lanes(lanes),
                    Picked::Nothing => return None,
                }
                Some(place_path)
            }
            ExprKind::Index(object, index) => {
                // Checked before anything is evaluated, since this case needs a different place.
                if self.is_swizzle(object) && program.scalar(index).is_none() {
                    return None;
                }
                let mut place_path = self.deeper(|l| l.place_path(object))??;
                self.take_element(&mut place_path, index)?;
                Some(place_path)
            }
            _ => None,
        }
    }

    /// Whether an expression is a swizzle.
    fn is_swizzle(&self, id: ExprId) -> bool {
        let program = self.program;
        match program.tree.expr(program.tree.unparen(id)).kind {
            ExprKind::Member(object, _) => program.ty(object).is_vector(),
            _ => false,
        }
    }

    /// Appends an index to a place.
    fn take_element(&mut self, place_path: &mut PlacePath, index: ExprId) -> Option<()> {
        let element = element_of(place_path.ty)?;
        let known = self.program.scalar(index).map(|v| v.as_int().max(0) as u32);
        match known {
            Some(number) if place_path.ty.is_vector() => {
                place_path.take_lanes(Lanes::new([number.min(3) as u8]))
            }
            Some(number) => {
                place_path.path.push(Access::Element(number));
                place_path.ty = element;
            }
            None => {
                let index = self.value(index);
                place_path.path.push(Access::Computed(index));
                place_path.ty = element;
            }
        }
        Some(())
    }

    /// Adds a place to the module.
    pub(super) fn keep(&mut self, place_path: &PlacePath) -> PlaceId {
        let start = self.module.access_lists.len() as u32;
        self.module.access_lists.extend_from_slice(&place_path.path);
        let lanes = place_path.lanes.map(Access::Lanes);
        self.module.access_lists.extend(lanes);
        self.add_place_along(place_path.variable, start, place_path.ty)
    }

    /// The destination of an assignment to an expression.
    pub(super) fn target(&mut self, id: ExprId) -> AssignTarget {
        if let Some(place_path) = self.place_path(id) {
            return AssignTarget::Place(self.keep(&place_path));
        }
        let tree = &self.program.tree;
        if let ExprKind::Index(object, index) = tree.expr(tree.unparen(id)).kind
            && let Some(place_path) = self.place_path(object)
        {
            let index = self.value(index);
            let of = self.keep(&place_path);
            return AssignTarget::Component { of, index };
        }
        AssignTarget::Nothing
    }

    /// Loads the current value of an assignment's destination.
    pub(super) fn read(&mut self, target: AssignTarget, ty: Type) -> OpId {
        match target {
            AssignTarget::Place(place) => self.load(place),
            AssignTarget::Component { of, index } => {
                let base = self.load(of);
                self.op(OpKind::ExtractComputed { base, index }, ty)
            }
            AssignTarget::Nothing => self.op(OpKind::Unknown, ty),
        }
    }

    /// Stores a value to an assignment's destination.
    pub(super) fn write(&mut self, target: AssignTarget, value: OpId) {
        match target {
            AssignTarget::Place(place) => self.store(place, value),
            AssignTarget::Component { of, index } => {
                let all = self.load(of);
                let ty = self.module.ty(all);
                let variable = self.new_variable(ty, Root::Temporary);
                let whole = self.place_of(variable, ty);
                self.store(whole, all);
                let one = self.module.ty(value);
                let component = self.add_place(variable, &[Access::Computed(index)], one);
                self.store(component, value);
                let all = self.load(whole);
                self.store(of, all);
            }
            AssignTarget::Nothing => {}
        }
    }
}

impl PlacePath {
    /// Appends a swizzle to a place.
    fn take_lanes(&mut self, inner: Lanes) {
        let lanes = self.lanes.map_or(inner, |lanes| lanes.pick(inner));
        self.lanes = Some(lanes);
        let scalar = self.ty.scalar_kind().unwrap_or(Scalar::Float);
        self.ty = Type::vector(scalar, lanes.count());
    }
}

/// The type of an element of an array, a column of a matrix or a component of a vector.
pub(super) fn element_of(ty: Type) -> Option<Type> {
    if ty.is_array() {
        return Some(ty.element());
    }
    match ty.base {
        Base::Numeric {
            scalar,
            columns: 2..,
            rows,
        } => Some(Type::vector(scalar, rows)),
        Base::Numeric {
            scalar,
            columns: 1,
            rows: 2..,
        } => Some(Type::scalar(scalar)),
        _ => None,
    }
}
