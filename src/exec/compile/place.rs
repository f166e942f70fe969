//! Lowering of loads and stores, and of access to parts of values.

use super::emit::{Compiler, MAX_KEPT, Made, Regs, Value};
use crate::bytecode::{ArraySite, F2, FaultCheck, Instr, Reg};
use rustc_hash::FxHashSet;
use shaderlint_ir::{Access, Lanes, OpId, PlaceId, Root};
use shaderlint_semantic::{Base, Scalar, Type, VariableId};

/// Maximum number of scalars of a value.
const MAX_SCALARS: u32 = 1 << 15;

/// The location of a place within its variable, in scalars.
#[derive(Default)]
struct PlaceSpot {
    /// The offset of the first scalar, without dynamic indices.
    at: u32,
    /// The offset added by dynamic indices.
    index: Option<Reg>,
    /// The number of scalars before swizzling.
    len: u32,
    /// The swizzled components.
    lanes: Option<Lanes>,
    /// The offset of the sampler within the variable.
    sampler: u32,
}

impl Compiler<'_> {
    pub fn load(&mut self, id: OpId, place: PlaceId) -> Made<Value> {
        let place = *self.module.place(place);
        let variable = place.variable;
        let spot = self.spot(variable, self.module.path(&place))?;
        if place.ty.is_sampler() {
            let first = self.first_sampler(variable)?;
            return match spot.index {
                None => Some(Value::Samplers(first + spot.sampler)),
                Some(_) => self.refuse("a dynamically indexed sampler"),
            };
        }
        let value = self.held(variable)?;
        let is_alias = self.plan.is_name(self.module, variable)
            || self.is_given(variable)
            // A debugger reads variables after their last use.
            || !self.options.steps && self.plan.stays(id, variable);
        let loaded = match (value, spot.index) {
            (Value::Memory { at, .. }, None) => self.memory_part(at + spot.at, &spot),
            (Value::Memory { at, len }, Some(index)) => {
                let base = at + spot.at;
                let end = at + len;
                Value::Regs(self.table(base, end, index, &spot))
            }
            (Value::Regs(regs), None) => {
                let picked = self.picked(regs, &spot);
                match is_alias {
                    true => self.retain(Value::Regs(picked)),
                    false => Value::Regs(self.copied(picked)),
                }
            }
            (Value::Regs(regs), Some(index)) => {
                let regs = self.neighbours(regs);
                Value::Regs(self.gathered(regs, index, &spot))
            }
            (Value::Nothing | Value::Samplers(_), _) => {
                return self.refuse("a value without a type");
            }
        };
        if let Some(index) = spot.index {
            self.registers.release(index);
        }
        Some(loaded)
    }

    pub fn store(&mut self, id: OpId, place: PlaceId, value: OpId) -> Made<()> {
        let place = *self.module.place(place);
        let variable = place.variable;
        if self.plan.value_of(variable) == Some(value) && self.plan.is_name(self.module, variable) {
            let value = self.value(value);
            self.retain(value);
            self.set_variable(variable, value);
            return Some(());
        }
        if place.ty.is_sampler() {
            return self.refuse("a write to a sampler");
        }
        let spot = self.spot(variable, self.module.path(&place))?;
        let Value::Regs(to) = self.held(variable)? else {
            return self.refuse("a write to a read-only variable");
        };
        let from = self.operand(value);
        match spot.index {
            None => {
                let to = self.picked(to, &spot);
                self.write(id, value, to, from);
            }
            Some(index) => {
                for at in 0..from.len {
                    let lane = lane_of(&spot, at);
                    let base = self.reg(to, spot.at + lane);
                    let site = self.site(base as u32, (to.len - spot.at - lane).max(1));
                    let from = self.reg(from, at);
                    self.push(Instr::Scatter { from, index, site });
                }
                self.registers.release(index);
            }
        }
        Some(())
    }

    /// Moves a value to the registers of a variable; if nothing else uses the value, its last
    /// instructions write there directly.
    fn write(&mut self, id: OpId, value: OpId, to: Regs, from: Regs) {
        // Pixels that wait keep their variables if a debugger reads them.
        let writes_all = self.plan.writes_all(id) && !self.options.steps;
        if writes_all && self.forwarded(value, to, from) {
            return;
        }
        // Overlapping parts of one variable, as in `v.xy = v.yx`, must be read before they are
        // written.
        let overlaps = self.overlaps(to, from);
        let from = match overlaps {
            true => self.copied(from),
            false => from,
        };
        for at in 0..to.len.min(from.len) {
            let (to, from) = (self.reg(to, at), self.reg(from, at));
            if to != from {
                self.push(match writes_all {
                    true => Instr::Move(to, from),
                    false => Instr::MoveActive(to, from),
                });
            }
        }
        if overlaps {
            self.release(Value::Regs(from));
        }
    }

    /// Whether a move overwrites a register that a later move reads.
    fn overlaps(&self, to: Regs, from: Regs) -> bool {
        if from.len <= MAX_KEPT as u32 {
            return (0..from.len).any(|n| {
                let reg = self.reg(from, n);
                (0..n).any(|m| self.reg(to, m) == reg)
            });
        }
        let mut written = FxHashSet::default();
        (0..from.len).any(|n| {
            let is_written = written.contains(&self.reg(from, n));
            written.insert(self.reg(to, n));
            is_written
        })
    }

    fn forwarded(&mut self, value: OpId, to: Regs, from: Regs) -> bool {
        let count = from.len as usize;
        let Some(start) = self.code.body.len().checked_sub(count) else {
            return false;
        };
        if count == 0 || to.len != from.len || !self.plan.is_last_use(value, self.clock()) {
            return false;
        }
        let Some(tail) = self.code.body.get(start..) else {
            return false;
        };
        let (to, from) = (self.list(to), self.list(from));
        let mut pairs = tail.iter().zip(from).enumerate();
        let fits = pairs.all(|(n, (instr, reg))| {
            instr.target() == Some(*reg)
                && self.registers.is_held_once(*reg)
                && self.registers.owner(*reg).is_none()
                && !to.get(..n).unwrap_or(&[]).iter().any(|t| instr.reads(*t))
        });
        // An instruction must not read the result of an earlier one that would be redirected.
        let chained = tail.iter().any(|i| from.iter().any(|f| i.reads(*f)));
        if !fits || chained {
            return false;
        }
        let to: Vec<Reg> = to.to_vec();
        for (instr, to) in self.code.body.iter_mut().skip(start).zip(to) {
            *instr = instr.to(to);
        }
        true
    }

    fn clock(&self) -> u32 {
        self.frames.last().map_or(0, |f| f.clock)
    }

    /// The location of a variable; allocates its registers on first use.
    fn held(&mut self, variable: VariableId) -> Made<Value> {
        let value = self.variable_value(variable);
        if value != Value::Nothing {
            return Some(value);
        }
        let declared = self.program.variable(variable);
        if let Some(declared) = declared
            && declared.is_const
            && declared.constant.is_known()
        {
            let values = self.program.pool.values(declared.constant);
            let value = self.constants_of(values);
            self.set_variable(variable, value);
            return Some(value);
        }
        self.open(variable)
    }

    /// Whether a variable is an input or uniform.
    fn is_given(&self, variable: VariableId) -> bool {
        let root = self.module.variable(variable).map(|v| v.root);
        matches!(root, Some(Root::Uniform | Root::Input)) || self.plan.is_never_written(variable)
    }

    fn first_sampler(&mut self, variable: VariableId) -> Made<u32> {
        if let Value::Samplers(first) = self.variable_value(variable) {
            return Some(first);
        }
        match self.samplers_of.get(&variable) {
            Some(first) => Some(*first),
            None => self.refuse("a sampler in a struct parameter"),
        }
    }

    fn spot(&mut self, variable: VariableId, path: &[Access]) -> Made<PlaceSpot> {
        let mut ty = self.module.variable(variable)?.ty;
        let mut spot = PlaceSpot::default();
        for access in path {
            match *access {
                Access::Member(number) => {
                    let members = self.program.struct_of(ty).map_or(&[][..], |s| &s.fields);
                    let before = members.get(..number as usize).unwrap_or(&[]);
                    spot.sampler += before.iter().map(|f| self.samplers_in(f.ty)).sum::<u32>();
                    let (at, inner, _) = self.part_of(ty, number)?;
                    (spot.at, ty) = (spot.at + at, inner);
                }
                Access::Element(number) => {
                    let (at, inner, count) = self.part_of(ty, number)?;
                    if number >= count {
                        return self.refuse("an index that is out of bounds");
                    }
                    spot.sampler += number * self.samplers_in(inner);
                    (spot.at, ty) = (spot.at + at, inner);
                }
                Access::Computed(index) => {
                    let (stride, inner, count) = self.part_of(ty, 1)?;
                    let step = self.steps(index, count, stride);
                    spot.index = Some(match spot.index {
                        None => step,
                        Some(index) => {
                            let sum = self.then_two(F2::IntAdd, index, step);
                            self.registers.release(step);
                            sum
                        }
                    });
                    ty = inner;
                }
                Access::Lanes(lanes) => spot.lanes = Some(lanes),
            }
        }
        spot.len = match ty.is_sampler() {
            true => 0,
            false => self.scalars_of(ty)?,
        };
        Some(spot)
    }

    fn part_of(&mut self, ty: Type, number: u32) -> Made<(u32, Type, u32)> {
        match self.part_at(ty, number) {
            Some(found) => Some(found),
            None => self.refuse("a value with more than 32,768 scalars"),
        }
    }

    /// The offset of a part by index, its type, and the number of such parts.
    pub fn part_at(&self, ty: Type, number: u32) -> Option<(u32, Type, u32)> {
        let part = self.layout.part(ty, number)?;
        Some((part.scalar?, part.ty, self.layout.count(ty)))
    }

    /// The number of scalars of a type; `None` if there are too many.
    pub fn scalars(&self, ty: Type) -> Option<u32> {
        let found = self.layout.scalars(ty);
        found.filter(|count| *count <= MAX_SCALARS)
    }

    /// The number of scalars of a type; refuses the shader if there are too many.
    pub fn scalars_of(&mut self, ty: Type) -> Made<u32> {
        match self.scalars(ty) {
            Some(count) => Some(count),
            None => self.refuse("a value with more than 32,768 scalars"),
        }
    }

    /// The scalar offset of a dynamic index, clamped to the existing elements.
    fn steps(&mut self, index: OpId, count: u32, stride: u32) -> Reg {
        let is_int = self.module.scalar(index) == Some(Scalar::Int);
        let index = self.operand(index);
        let index = self.reg(index, 0);
        let (id, limit) = (self.op, self.constant(count));
        self.check(id, FaultCheck::Index, index, &[index, limit]);
        let last = self.constant(count.saturating_sub(1));
        let inside = match is_int {
            true => {
                let zero = self.constant(0);
                let low = self.two(F2::IntMax, index, zero);
                self.then_two(F2::IntMin, low, last)
            }
            false => self.two(F2::UintMin, index, last),
        };
        match stride {
            1 => inside,
            _ => {
                let stride = self.constant(stride);
                self.then_two(F2::IntMultiply, inside, stride)
            }
        }
    }

    /// The registers of a place without dynamic indices.
    fn picked(&mut self, regs: Regs, spot: &PlaceSpot) -> Regs {
        match spot.lanes {
            None => Self::part(regs, spot.at, spot.len),
            Some(lanes) => {
                let picked: Vec<Reg> = lanes
                    .numbers()
                    .iter()
                    .map(|n| self.reg(regs, spot.at + *n as u32))
                    .collect();
                self.listed(picked)
            }
        }
    }

    /// A copy in fresh registers.
    pub fn copied(&mut self, regs: Regs) -> Regs {
        let copies: Vec<Reg> = (0..regs.len)
            .map(|n| {
                let reg = self.reg(regs, n);
                self.fresh(Instr::Move(0, reg))
            })
            .collect();
        self.listed(copies)
    }

    fn memory_part(&mut self, at: u32, spot: &PlaceSpot) -> Value {
        match spot.lanes {
            None if spot.len > super::emit::MAX_KEPT as u32 => Value::Memory { at, len: spot.len },
            None => {
                let value = Value::Memory { at, len: spot.len };
                Value::Regs(self.in_registers(value))
            }
            Some(lanes) => {
                let words = lanes.numbers().iter().map(|n| at + *n as u32);
                let words: Vec<Reg> = words.map(|at| self.word(at)).collect();
                Value::Regs(self.listed(words))
            }
        }
    }

    fn site(&mut self, base: u32, len: u32) -> u32 {
        self.code.arrays.push(ArraySite { base, len });
        self.code.arrays.len() as u32 - 1
    }

    /// Loads dynamically indexed scalars from memory.
    fn table(&mut self, base: u32, end: u32, index: Reg, spot: &PlaceSpot) -> Regs {
        let count = spot.lanes.map_or(spot.len, |l| l.count() as u32);
        let mut made = Vec::with_capacity(count as usize);
        for n in 0..count {
            let base = base + lane_of(spot, n);
            let site = self.site(base, end.saturating_sub(base).max(1));
            let instr = Instr::Table { to: 0, index, site };
            made.push(self.pure(instr, &[index]));
        }
        self.listed(made)
    }

    /// Loads dynamically indexed scalars from consecutive registers.
    fn gathered(&mut self, regs: Regs, index: Reg, spot: &PlaceSpot) -> Regs {
        let count = spot.lanes.map_or(spot.len, |l| l.count() as u32);
        let mut made = Vec::with_capacity(count as usize);
        for n in 0..count {
            let lane = lane_of(spot, n);
            let base = self.reg(regs, spot.at + lane);
            let site = self.site(base as u32, (regs.len - spot.at - lane).max(1));
            made.push(self.fresh(Instr::Gather { to: 0, index, site }));
        }
        self.listed(made)
    }

    /// The same registers if they are consecutive, else a permanent copy in consecutive registers.
    fn neighbours(&mut self, regs: Regs) -> Regs {
        let list = self.list(regs);
        let lie_so = list
            .windows(2)
            .all(|w| matches!(w, [a, b] if *b == a.saturating_add(1)));
        if lie_so {
            return regs;
        }
        let first = self.registers.row(regs.len, VariableId(u32::MAX), true);
        let row = self.listed((0..regs.len).map(|n| first.saturating_add(n as u16)));
        for n in 0..regs.len {
            let (to, from) = (self.reg(row, n), self.reg(regs, n));
            self.push(Instr::Move(to, from));
        }
        row
    }

    /// The element, column or component of a value at a dynamic index.
    pub fn extract_computed(&mut self, base: OpId, index: OpId) -> Made<Value> {
        let ty = self.module.ty(base);
        if matches!(ty.base, Base::Sampler(_)) {
            return self.refuse("a dynamically indexed sampler");
        }
        let (stride, inner, count) = self.part_of(ty, 1)?;
        let len = self.scalars_of(inner)?;
        let index = self.steps(index, count, stride);
        let spot = PlaceSpot {
            at: 0,
            index: Some(index),
            len,
            lanes: None,
            sampler: 0,
        };
        let made = match self.value(base) {
            Value::Memory { at, len } => self.table(at, at + len, index, &spot),
            value => {
                let regs = self.in_registers(value);
                let regs = self.neighbours(regs);
                self.gathered(regs, index, &spot)
            }
        };
        self.registers.release(index);
        Some(Value::Regs(made))
    }
}

/// The offset, from the start of a place, of a component of its value.
fn lane_of(spot: &PlaceSpot, number: u32) -> u32 {
    let lane = spot
        .lanes
        .and_then(|l| l.numbers().get(number as usize).copied());
    lane.map_or(number, u32::from)
}
