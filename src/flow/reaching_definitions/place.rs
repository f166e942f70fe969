//! Maps places to slots.

use super::def::{ReachingDefinitions, Slot};
use shaderlint_ir::{Access, Lanes, Layout, Module, OpId, OpKind, PlaceId, column_lanes};
use shaderlint_semantic::Type;

/// The slots that a place may refer to.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaceSlots {
    /// The first slot, with dynamic indices taken as 0.
    pub first: Slot,
    /// The type of the place before swizzling.
    pub ty: Type,
    /// Count and stride of the candidates of a dynamic index: into columns, then into components.
    pub picks: [(u32, u32); 2],
    /// Whether it is an element of an array, so that a write is a weak update.
    pub is_element: bool,
    /// The swizzled components.
    pub lanes: Option<Lanes>,
    /// The vector that components are selected from: its first slot and its number of components.
    pub vector: Option<(Slot, u8)>,
}

impl PlaceSlots {
    /// Resolves a place; `None` if its type has no components.
    pub(super) fn of(
        module: &Module,
        layout: &Layout,
        slots: &[u32],
        place: PlaceId,
    ) -> Option<PlaceSlots> {
        let place = module.place(place);
        let ty = module.variable(place.variable)?.ty;
        if layout.lanes(ty) == 0 {
            return None;
        }
        let mut spot = PlaceSlots {
            first: Slot(*slots.get(place.variable.0 as usize)?),
            ty,
            picks: [(1, 0); 2],
            is_element: false,
            lanes: None,
            vector: None,
        };
        for access in module.path(place) {
            match *access {
                Access::Member(number) => {
                    spot.first.0 += layout.lane(spot.ty, number)?;
                    spot.ty = layout.part(spot.ty, number)?.ty;
                }
                Access::Element(number) => spot.element(layout, Some(number))?,
                Access::Computed(_) => spot.element(layout, None)?,
                Access::Lanes(lanes) => {
                    let (_, _, rows) = spot.ty.numeric()?;
                    spot.vector = Some((spot.first, rows));
                    spot.lanes = Some(lanes);
                }
            }
        }
        (layout.lanes(spot.ty) > 0).then_some(spot)
    }

    fn element(&mut self, layout: &Layout, number: Option<u32>) -> Option<()> {
        if self.ty.is_array() {
            self.ty = self.ty.element();
            self.is_element = true;
            return Some(());
        }
        let (scalar, columns, rows) = self.ty.numeric()?;
        let (pick, all, stride, inner) = match columns {
            1 => (1, rows as u32, 1, Type::scalar(scalar)),
            _ => {
                let inner = Type::vector(scalar, rows);
                (0, columns as u32, column_lanes(rows), inner)
            }
        };
        if columns == 1 {
            self.vector = Some((self.first, rows));
        }
        match number {
            Some(number) => self.first.0 += layout.lane(self.ty, number)?,
            None => *self.picks.get_mut(pick)? = (all, stride),
        }
        self.ty = inner;
        Some(())
    }

    /// Whether a column or component is selected by a dynamic index.
    pub(super) fn is_picked(&self) -> bool {
        self.picks.iter().any(|(count, _)| *count > 1)
    }

    /// The slot of a component, with dynamic indices taken as 0.
    pub(super) fn slot(&self, lane: u32) -> Option<Slot> {
        let at = match self.lanes {
            Some(lanes) => *lanes.numbers().get(lane as usize)? as u32,
            None => lane,
        };
        Some(Slot(self.first.0 + at))
    }

    /// The slots that a component may refer to. The length of a swizzle has none.
    pub(super) fn slots(&self, lane: u32) -> impl Iterator<Item = Slot> {
        let [(outer, far), (inner, near)] = self.picks;
        let offsets = (0..outer).flat_map(move |o| (0..inner).map(move |i| o * far + i * near));
        let first = self.slot(lane).into_iter();
        first.flat_map(move |first| offsets.clone().map(move |offset| Slot(first.0 + offset)))
    }

    /// The vectors whose length changes when the place is written.
    pub(super) fn vectors(&self) -> impl Iterator<Item = (Slot, u8)> {
        let (outer, far) = self.picks[0];
        let all = self.vector.into_iter();
        all.flat_map(move |(first, rows)| (0..outer).map(move |o| (Slot(first.0 + o * far), rows)))
    }

    /// The number of components of the place, without the length of a swizzle.
    pub(super) fn width(&self, layout: &Layout) -> u32 {
        match self.lanes {
            Some(lanes) => lanes.count() as u32,
            None => layout.lanes(self.ty),
        }
    }

    /// The slot of the length, if the swizzle is a permutation of the whole vector.
    pub(super) fn length(&self) -> Option<Slot> {
        let (first, rows) = self.vector?;
        let lanes = self.lanes?;
        let picked = lanes.numbers().iter().fold(0u8, |mask, n| mask | 1 << n);
        let all = lanes.count() == rows && picked == (1u8 << rows) - 1;
        all.then_some(Slot(first.0 + rows as u32))
    }
}

impl ReachingDefinitions {
    /// Whether a value is an element of an array. All elements share their definitions, so that
    /// these do not identify it.
    pub fn is_element(&self, module: &Module, op: OpId) -> bool {
        match module.op(op).kind {
            OpKind::Load(place) => self.is_element_place(module, place),
            OpKind::Extract(base, _) | OpKind::ExtractComputed { base, .. } => {
                module.ty(base).is_array()
            }
            _ => false,
        }
    }

    fn is_element_place(&self, module: &Module, place: PlaceId) -> bool {
        match PlaceSlots::of(module, &self.layout, &self.slots, place) {
            Some(spot) => spot.is_element,
            // What has no components, such as a sampler, is indexed in arrays only.
            None => {
                let mut path = module.path(module.place(place)).iter();
                path.any(|access| matches!(access, Access::Element(_) | Access::Computed(_)))
            }
        }
    }
}
