//! The VM: a SIMD interpreter that executes bytecode for 32 pixels at a time.
//!
//! The execution mask has one bit per lane. Registers of inactive lanes may hold anything;
//! variables that outlive a construct are written only in active lanes.

mod active;
mod arithmetic;
mod array;
mod following;
pub(super) mod state;
#[cfg(test)]
mod tests;
mod texture;
mod tracing;
mod watch;

use super::bytecode::{Bytecode, EMPTY, Instr, InstrIndex, Reg, StopKind};
use super::draw::{Draw, Stop};
use super::row::{LANES, Row};
use active::ActiveLanes;
use fearless_simd::Simd;
use following::Following;
use shaderlint_math::{Faster, baseline, faster};
use shaderlint_semantic::Scalar;
use watch::Watched;

pub(super) use tracing::TraceLog;
pub use tracing::TraceStep;
pub use watch::Fault;

/// All registers of a shader. The compiler guarantees that register indices are in bounds.
type Bank = [Row];

/// The pixels executed together.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Tile {
    pub pixels: [[u32; 2]; LANES],
    /// The requested lanes; the others are helper lanes for derivatives.
    pub requested: u32,
    /// The case of each lane.
    pub cases: [u32; LANES],
}

/// The state of the VM.
pub(super) struct Vm<'d> {
    draw: &'d Draw<'d>,
    code: &'d Bytecode,
    bank: Box<Bank>,
    masks: Vec<u32>,
    /// The execution mask: the active lanes.
    active: u32,
    /// The lanes that are not discarded.
    live: u32,
    /// The lanes that are counted in statistics.
    requested: u32,
    /// What follows from the execution mask, or from an earlier one.
    expanded: ActiveLanes,
    fuel: u64,
    /// The number of instructions executed so far.
    pub spent: u64,
    tile: Tile,
    pub watched: Watched,
    /// The traced lane, and what it did.
    pub traced: Option<TraceLog>,
    /// The lanes at whose stops a run pauses.
    pub pauses: u32,
    /// The trace sites that the requested lanes reached, if the run pauses.
    pub written: Vec<u32>,
    /// The index of the next instruction.
    at: usize,
    /// The number of instructions that this tile may not spend on repeats.
    once: u64,
    /// The instructions to run with; `None` for those of every machine.
    faster: Option<Faster>,
}

impl<'d> Vm<'d> {
    /// Creates a VM and executes the uniform prologue.
    pub fn new(draw: &'d Draw<'d>) -> Vm<'d> {
        Vm::with(draw, faster())
    }

    /// As [`Vm::new`], with these instructions.
    pub fn with(draw: &'d Draw<'d>, faster: Option<Faster>) -> Vm<'d> {
        let code = draw.code;
        let mut vm = Vm {
            draw,
            code,
            bank: vec![Row::ZERO; code.registers].into_boxed_slice(),
            masks: vec![0; code.slots.max(1) as usize],
            active: u32::MAX,
            live: u32::MAX,
            requested: 0,
            expanded: ActiveLanes::of(u32::MAX, 0),
            fuel: 0,
            spent: code.uniform_prologue.len() as u64,
            tile: Tile::default(),
            watched: Watched::new(code),
            traced: None,
            pauses: 0,
            written: Vec::new(),
            at: 0,
            once: 0,
            faster,
        };
        for (reg, bits) in &code.constants {
            vm.set(*reg, Row::splat(*bits));
        }
        match faster {
            Some(simd) => simd.vectorize(
                #[inline(always)]
                || vm.prologue(simd),
            ),
            None => vm.prologue(baseline()),
        }
        vm
    }

    #[inline(always)]
    fn prologue<S: Simd>(&mut self, simd: S) {
        for instr in &self.code.uniform_prologue {
            self.straight(simd, instr, &mut Following { body: &[], at: 0 });
        }
    }

    /// Executes a tile. Returns the lanes that were not discarded.
    ///
    /// # Errors
    /// The tile ran out of fuel.
    pub fn run(&mut self, tile: &Tile) -> Result<u32, Stop> {
        self.begin(tile)?;
        self.proceed()?;
        Ok(self.live & self.requested)
    }

    /// Prepares a tile, before its first instruction.
    ///
    /// # Errors
    /// There is not enough fuel for it.
    pub fn begin(&mut self, tile: &Tile) -> Result<(), Stop> {
        self.open(tile);
        (self.active, self.live) = (u32::MAX, u32::MAX);
        self.inputs();
        self.at = 0;
        // Each instruction runs once; only repeats in loops are charged as fuel.
        self.once = self.spent.saturating_add(self.code.body.len() as u64);
        let left = self.draw.budget.checked_sub(self.once);
        let left = left.ok_or_else(|| self.out_of_fuel())?;
        self.fuel = left.min(self.draw.fuel);
        Ok(())
    }

    /// Executes the tile to its end, or to the next stop of a lane that pauses. Returns the site of the
    /// stop; `None` at the end.
    ///
    /// # Errors
    /// The tile ran out of fuel.
    pub fn proceed(&mut self) -> Result<Option<u32>, Stop> {
        match self.faster {
            Some(simd) => simd.vectorize(
                #[inline(always)]
                || self.execute(simd),
            ),
            None => self.execute(baseline()),
        }
    }

    #[inline(always)]
    fn execute<S: Simd>(&mut self, simd: S) -> Result<Option<u32>, Stop> {
        let allowed = self.fuel;
        let body = self.code.body.as_slice();
        let mut following = Following { body, at: self.at };
        let mut paused = None;
        while let Some(instr) = body.get(following.at) {
            following.at += 1;
            match self.jump(simd, instr, &mut following) {
                Some(JumpTarget::To(target)) => following.at = target as usize,
                Some(JumpTarget::Back(target)) => {
                    let cost = (following.at - target as usize) as u64;
                    let Some(rest) = self.fuel.checked_sub(cost) else {
                        return Err(self.out_of_fuel());
                    };
                    self.fuel = rest;
                    following.at = target as usize;
                }
                Some(JumpTarget::Pause(site)) => {
                    paused = Some(site);
                    break;
                }
                None => {}
            }
        }
        self.at = following.at;
        self.once = self.once.saturating_add(allowed - self.fuel);
        if paused.is_none() {
            self.spent = self.once;
            self.watched.close(self.requested);
        }
        Ok(paused)
    }

    fn out_of_fuel(&self) -> Stop {
        Stop::OutOfFuel {
            pixel: self.tile.pixels.first().copied().unwrap_or_default(),
        }
    }

    /// The statistics of all tiles.
    pub fn finish(self) -> super::observations::Observations {
        self.watched.finish(self.code)
    }

    /// The value of a register.
    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    #[inline(always)]
    pub fn row(&self, reg: Reg) -> &Row {
        &self.bank[reg as usize]
    }

    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    #[inline(always)]
    fn set(&mut self, reg: Reg, row: Row) {
        self.bank[reg as usize] = row;
    }

    /// The lanes in which a register is true.
    #[inline(always)]
    fn mask<S: Simd>(&self, simd: S, reg: Reg) -> u32 {
        self.row(reg).mask(simd)
    }

    /// Records the value of a site, if the traced lane is active.
    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    #[inline(never)]
    fn record(&mut self, site: u32) {
        if self.pauses != 0 && self.active & self.requested != 0 {
            self.written.push(site);
        }
        if let Some(log) = &mut self.traced
            && self.active >> log.lane & 1 == 1
            && let Some(place) = self.code.traces.get(site as usize)
        {
            let rows = place.regs.iter().map(|reg| &self.bank[*reg as usize]);
            log.add(site, rows);
        }
    }

    /// Loads the inputs of the tile's pixels.
    fn inputs(&mut self) {
        let draw = self.draw;
        let [x, y] = [0, 1].map(|axis| {
            let pixels = &self.tile.pixels;
            pixels.map(|pixel| pixel.get(axis).copied().unwrap_or(0) as f32 + 0.5)
        });
        let given = draw.inputs.iter().zip(&draw.by_case);
        for (slot, (planes, by_case)) in self.code.inputs.iter().zip(given) {
            if let Some(by_case) = by_case {
                for (reg, bits) in slot.regs.iter().zip(by_case) {
                    let bits = |case: u32| bits.get(case as usize).copied().unwrap_or(0);
                    self.set(*reg, Row(self.tile.cases.map(bits)));
                }
                continue;
            }
            for (reg, [base, across, up]) in slot.regs.iter().zip(planes) {
                let mut values = [0.0; LANES];
                for ((value, x), y) in values.iter_mut().zip(x).zip(y) {
                    *value = base + across * x + up * y;
                }
                let row = match slot.ty.scalar_kind() {
                    Some(Scalar::Bool) => Row(values.map(|v| if v == 0.0 { 0 } else { u32::MAX })),
                    Some(Scalar::Int) => Row(values.map(|v| v as i32 as u32)),
                    Some(Scalar::Uint) => Row(values.map(|v| v as u32)),
                    Some(Scalar::Float) | None => Row::of_floats(values),
                };
                self.set(*reg, row);
            }
        }
    }

    /// Finds out what follows from the execution mask.
    #[inline(always)]
    fn expand(&mut self) {
        if self.expanded.mask != self.active {
            self.expanded = ActiveLanes::of(self.active, self.requested);
        }
    }

    fn kept(&self, slot: u16) -> u32 {
        self.masks.get(slot as usize).copied().unwrap_or(0)
    }

    fn keep(&mut self, slot: u16, mask: u32) {
        if slot != EMPTY
            && let Some(kept) = self.masks.get_mut(slot as usize)
        {
            *kept = mask;
        }
    }

    /// Jumps if no lane is active.
    fn unless_any(&self, to: InstrIndex) -> Option<JumpTarget> {
        (self.active == 0).then_some(JumpTarget::To(to))
    }

    /// Executes an instruction. Returns the jump to take.
    #[inline(always)]
    fn jump<S: Simd>(
        &mut self,
        simd: S,
        instr: &Instr,
        following: &mut Following<'_>,
    ) -> Option<JumpTarget> {
        match *instr {
            Instr::If {
                condition,
                others,
                to,
            } => {
                let holds = self.mask(simd, condition);
                self.keep(others, self.active & !holds);
                self.active &= holds;
                return self.unless_any(to);
            }
            Instr::Else { others, to } => {
                let kept = self.kept(others);
                self.keep(others, self.active);
                self.active = kept;
                return self.unless_any(to);
            }
            Instr::EndIf { others } => self.active |= self.kept(others),
            Instr::Keep(slot) => self.keep(slot, self.active),
            Instr::Clear(slot) => self.keep(slot, 0),
            Instr::Mark(slot, reg) => self.keep(slot, self.mask(simd, reg)),
            Instr::Restore { came, left, others } => {
                let removed = self.kept(left) | self.kept(others);
                self.active = self.kept(came) & !removed & self.live;
            }
            Instr::While { condition, to } => {
                self.active &= self.mask(simd, condition);
                return self.unless_any(to);
            }
            Instr::Resume(slot) => {
                self.active |= self.kept(slot);
                self.keep(slot, 0);
            }
            Instr::Wait(slot) => {
                self.keep(slot, self.kept(slot) | self.active);
                self.active = 0;
            }
            Instr::Case {
                waiting,
                marked,
                to,
            } => {
                let hit = self.kept(waiting) & self.kept(marked);
                self.keep(waiting, self.kept(waiting) & !hit);
                self.active |= hit;
                return self.unless_any(to);
            }
            Instr::Halt => self.active = 0,
            Instr::Discard => {
                self.live &= !self.active;
                self.active = 0;
            }
            Instr::SkipIfNone(to) => return self.unless_any(to),
            Instr::Back(to) => return Some(JumpTarget::Back(to)),
            Instr::Stop(site) => {
                if let Some(stop) = self.code.stops().get(site as usize)
                    && stop.kind == StopKind::Statement
                {
                    let lanes = self.active & self.requested;
                    self.watched.statement(stop.statement, lanes);
                }
                let pauses = self.active & self.pauses != 0;
                return pauses.then_some(JumpTarget::Pause(site));
            }
            _ => self.straight(simd, instr, following),
        }
        None
    }
}

/// The target of a jump.
enum JumpTarget {
    /// Forwards.
    To(InstrIndex),
    /// Backwards, to instructions already executed.
    Back(InstrIndex),
    /// Nowhere: the run pauses at this site.
    Pause(u32),
}
