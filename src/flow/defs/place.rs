//! Which slots a place stands for.

use super::def::Slot;
use shaderlint_ir::{Access, Lanes, Layout, Module, PlaceId, column_lanes};
use shaderlint_semantic::Type;

/// The slots of a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaceSlots {
    /// The first slot.
    pub first: Slot,
    /// The type of what stands there, before components are picked.
    pub ty: Type,
    /// How many parts a computed number picks from, and how far apart they are: of columns, then of
    /// components.
    pub picks: [(u32, u32); 2],
    /// Whether it is one of the elements of an array, so that a write leaves the others.
    pub is_element: bool,
    /// The components that are picked.
    pub lanes: Option<Lanes>,
    /// The vector that components are picked from: its first slot and its length.
    pub vector: Option<(Slot, u8)>,
}

impl PlaceSlots {
    /// Resolves a place; `None` for what has no lanes.
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

    /// Whether a computed number picks among columns or components.
    pub(super) fn is_picked(&self) -> bool {
        self.picks.iter().any(|(count, _)| *count > 1)
    }

    /// The slot of a lane, where no computed number picks among columns or components.
    pub(super) fn slot(&self, lane: u32) -> Option<Slot> {
        let at = match self.lanes {
            Some(lanes) => *lanes.numbers().get(lane as usize)? as u32,
            None => lane,
        };
        Some(Slot(self.first.0 + at))
    }

    /// The slots that a lane may stand for; the length of picked components has none.
    pub(super) fn slots(&self, lane: u32) -> impl Iterator<Item = Slot> {
        let [(outer, far), (inner, near)] = self.picks;
        let offsets = (0..outer).flat_map(move |o| (0..inner).map(move |i| o * far + i * near));
        let first = self.slot(lane).into_iter();
        first.flat_map(move |first| offsets.clone().map(move |offset| Slot(first.0 + offset)))
    }

    /// The vectors whose length changes when components of them are written.
    pub(super) fn vectors(&self) -> impl Iterator<Item = (Slot, u8)> {
        let (outer, far) = self.picks[0];
        let all = self.vector.into_iter();
        all.flat_map(move |(first, rows)| (0..outer).map(move |o| (Slot(first.0 + o * far), rows)))
    }

    /// How many lanes are picked: the components, without the length.
    pub(super) fn width(&self, layout: &Layout) -> u32 {
        match self.lanes {
            Some(lanes) => lanes.count() as u32,
            None => layout.lanes(self.ty),
        }
    }

    /// The slot of the length, where all components of a vector are picked in any order.
    pub(super) fn length(&self) -> Option<Slot> {
        let (first, rows) = self.vector?;
        let lanes = self.lanes?;
        let picked = lanes.numbers().iter().fold(0u8, |mask, n| mask | 1 << n);
        let all = lanes.count() == rows && picked == (1u8 << rows) - 1;
        all.then_some(Slot(first.0 + rows as u32))
    }
}
