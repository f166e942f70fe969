//! Lowers places to naga's pointers and accesses.

use super::body::{Body, Bound};
use super::stored::StoredPlace;
use super::target::{Res, Value};
use super::types::{Sink, size};
use ::naga::{Expression, SwizzleComponent};
use shaderlint_ir::{Access, Lanes, OpId, OpKind, Place, PlaceId, Root};
use shaderlint_semantic::{Type, VariableId};

/// A resolved place.
struct Spot {
    at: At,
    /// The selected components, if not all.
    lanes: Option<Lanes>,
}

/// The location of a place.
#[derive(Clone, Copy)]
enum At {
    Value(Value),
    Pointer(Value),
    /// A place in a uniform buffer.
    Stored(StoredPlace),
}

impl Body<'_, '_> {
    fn spot(&mut self, place: &Place) -> Res<Spot> {
        let form = self.lowerer.form;
        let mut path = form.path(place);
        let is_computed = path.iter().any(|a| matches!(a, Access::Computed(_)));
        let mut at = match self.root(place.variable, &mut path)? {
            // Naga requires a pointer to access a column of a matrix with a computed index.
            Bound::Value(value) if is_computed && self.has_columns(place.variable) => {
                let ty = form.variable(place.variable).map_or(Type::ERROR, |v| v.ty);
                At::Pointer(self.spill(value, ty)?)
            }
            Bound::Value(value) => At::Value(value),
            Bound::Pointer(pointer) => At::Pointer(pointer),
            Bound::Stored(held) => At::Stored(held),
        };
        let mut lanes = None;
        for access in path {
            // A row-major matrix is loaded before a column of it is accessed.
            if let At::Stored(held) = at
                && held.is_by_rows()
            {
                let value = self.unpack(held)?;
                at = match access {
                    Access::Computed(_) => At::Pointer(self.spill(value, held.ty)?),
                    _ => At::Value(value),
                };
            }
            at = match *access {
                Access::Member(index) => match at {
                    At::Stored(held) => At::Stored(self.held_field(held, index)?),
                    at => self.step_to(at, |it, base| it.part(base, index)),
                },
                Access::Element(index) => self.step_to(at, |it, base| it.part(base, index)),
                Access::Computed(index) => {
                    let index = self.value(index)?;
                    self.step_to(at, |it, base| it.add(Expression::Access { base, index }))
                }
                Access::Lanes(chosen) => match chosen.numbers() {
                    &[one] => self.step_to(at, |it, base| it.part(base, one.into())),
                    _ => {
                        lanes = Some(chosen);
                        at
                    }
                },
            }
        }
        Ok(Spot { at, lanes })
    }

    /// The root of a place. For an array of blocks the first access selects the buffer.
    fn root(&mut self, id: VariableId, path: &mut &[Access]) -> Res<Bound> {
        if !self.lowerer.uniforms.instances.contains_key(&id) {
            return self.bound(id);
        }
        let is_array = self
            .lowerer
            .form
            .variable(id)
            .is_some_and(|v| v.ty.is_array());
        let number = match (is_array, *path) {
            (false, _) => 0,
            (true, [Access::Element(number), rest @ ..]) => {
                *path = rest;
                *number
            }
            _ => {
                return self
                    .lowerer
                    .refuse("an array of blocks needs a constant index");
            }
        };
        self.block(id, number).map(Bound::Stored)
    }

    /// Accesses a part of a location.
    fn step_to(&mut self, at: At, step: impl FnOnce(&mut Self, Value) -> Value) -> At {
        match at {
            At::Value(value) => At::Value(step(self, value)),
            At::Pointer(pointer) => At::Pointer(step(self, pointer)),
            At::Stored(held) => {
                let inner = step(self, held.at);
                At::Stored(self.held_part(held, inner))
            }
        }
    }

    fn has_columns(&self, id: VariableId) -> bool {
        let ty = self.lowerer.form.variable(id).map_or(Type::ERROR, |v| v.ty);
        let part = ty.element();
        !(part.is_scalar() || part.is_vector())
    }

    pub(super) fn read(&mut self, place: PlaceId) -> Res<Value> {
        let spot = self.spot(self.lowerer.form.place(place))?;
        let value = match spot.at {
            At::Value(value) => value,
            At::Pointer(pointer) => self.load(pointer),
            At::Stored(held) => self.unpack(held)?,
        };
        Ok(match spot.lanes {
            Some(lanes) => self.swizzle(value, lanes),
            None => value,
        })
    }

    pub(super) fn write(&mut self, place: PlaceId, value: OpId) -> Res<()> {
        let form = self.lowerer.form;
        let place = form.place(place);
        if !self.lowerer.has_place(place.variable)? || self.is_lent(value) {
            return Ok(());
        }
        if self.decides(place, value)
            && let value = self.value(value)?
            && !self.known.contains(&value)
        {
            if let Some(name) = self.lowerer.name(place.variable) {
                self.name(value, name);
            }
            self.variables.insert(place.variable, Bound::Value(value));
            return Ok(());
        }
        let spot = self.spot(place)?;
        // Variables of a function are zero-initialised, but not again in each iteration of a loop.
        if form.op(value).kind == OpKind::Undef && !self.in_loop {
            return Ok(());
        }
        let value = self.value(value)?;
        let At::Pointer(to) = spot.at else {
            return self.lowerer.refuse("cannot assign to this");
        };
        let Some(lanes) = spot.lanes else {
            self.store(to, value);
            return Ok(());
        };
        for (i, lane) in lanes.numbers().iter().enumerate() {
            let from = self.part(value, i as u32);
            let to = self.part(to, (*lane).into());
            self.store(to, from);
        }
        Ok(())
    }

    /// Whether a variable has a single value during its lifetime and needs no storage. Excludes
    /// cases of a `switch`, which share variables and may be duplicated. Values that target
    /// compilers can evaluate are excluded by the caller.
    fn decides(&self, place: &Place, value: OpId) -> bool {
        let form = self.lowerer.form;
        let root = form.variable(place.variable).map(|v| v.root);
        root == Some(Root::Local)
            && place.path.len == 0
            && (place.ty.is_scalar() || place.ty.is_vector())
            && form.op(value).kind != OpKind::Undef
            && self.lowerer.stores(place.variable) == 1
            && !self.in_switch
    }

    /// Selects components of a vector.
    pub(super) fn swizzle(&mut self, vector: Value, lanes: Lanes) -> Value {
        if let &[one] = lanes.numbers() {
            return self.part(vector, one.into());
        }
        let lane = |i: usize| match lanes.numbers().get(i) {
            Some(1) => SwizzleComponent::Y,
            Some(2) => SwizzleComponent::Z,
            Some(3) => SwizzleComponent::W,
            _ => SwizzleComponent::X,
        };
        self.add(Expression::Swizzle {
            size: size(lanes.count()),
            vector,
            pattern: [lane(0), lane(1), lane(2), lane(3)],
        })
    }
}
