//! The ray probe: outputs how the first march of a loop went in each pixel, with steps of another length.

use super::emit::{Compiler, Made, RayRegisters, Regs, Value};
use crate::bytecode::{F1, F2, F3, Instr, OutputSlot, Reg};
use crate::options::RayProbe;
use shaderlint_ir::{Binary, LoopId, OpId, OpKind};
use shaderlint_semantic::{Scalar, Type, Value as Number};

/// Shortest move, relative to the distance from the start, over which a slope is measured: below it,
/// rounding errors dominate.
const LEAST_MOVE: f32 = 1e-3;

impl Compiler<'_> {
    /// Allocates the registers of the ray probe.
    pub fn open_rays(&mut self) -> Made<()> {
        let probe = self.options.rays?;
        let lanes = probe.lanes().count();
        let fresh: Vec<Reg> = (0..18 + lanes).map(|_| self.registers.fresh()).collect();
        let all = self.listed(fresh);
        self.zero(all);
        let at = |n| self.reg(all, n);
        self.rays = Some(RayRegisters {
            entered: at(0),
            marches: at(1),
            places: [at(2), at(3)],
            change: at(4),
            passed: at(5),
            hit: at(6),
            tested: at(7),
            slope: at(8),
            point: [at(9), at(10), at(11)],
            has_point: at(12),
            last_point: [at(13), at(14), at(15)],
            last_field: at(16),
            was_evaluated: at(17),
            start: Compiler::part(all, 18, lanes as u32),
        });
        Some(())
    }

    /// Notes where a ray starts.
    pub fn enter_rays(&mut self, id: LoopId) -> Made<()> {
        let (probe, rays) = self.probed_rays(id)?;
        let is_first = self.one(F1::Not, rays.entered);
        self.push(Instr::MoveActive(rays.marches, is_first));
        self.registers.release(is_first);
        let holds = self.constant(u32::MAX);
        self.push(Instr::MoveActive(rays.entered, holds));
        let moved = self.moved(&probe)?;
        self.while_marching(rays, |c| {
            for (at, reg) in (0..).zip(moved) {
                let to = c.reg(rays.start, at);
                c.push(Instr::MoveActive(to, reg));
            }
        });
        Some(())
    }

    /// Notes where a ray is at the start of an iteration.
    pub fn iterate_rays(&mut self, id: LoopId) -> Made<()> {
        let (probe, rays) = self.probed_rays(id)?;
        self.while_marching(rays, |c| {
            let [last, second] = rays.places;
            c.push(Instr::MoveActive(second, last));
            if let Some(way) = c.way(&probe, rays) {
                c.push(Instr::MoveActive(last, way));
                c.registers.release(way);
            }
        });
        Some(())
    }

    /// Notes the result of an operation that is part of the march.
    pub fn note_ray(&mut self, op: OpId) -> Made<()> {
        let (probe, rays) = (self.options.rays?, self.rays?);
        if probe.point == Some(op) {
            let from = self.operand(op);
            self.while_marching(rays, |c| c.keep_point(rays, from));
        }
        if probe.field.is_some_and(|(field, _)| field == op) {
            let (lane, value) = (probe.field?.1, self.operand(op));
            self.while_marching(rays, |c| c.measure_slope(&probe, rays, c.reg(value, lane)));
        }
        if probe.condition == Some(op) {
            let value = self.operand(op);
            self.while_marching(rays, |c| c.keep_hit(&probe, rays, c.reg(value, 0)));
        }
        Some(())
    }

    /// The value of an operation with a step of another length, or a limit of more iterations.
    pub fn rescaled(&mut self, op: OpId, value: Value) -> Value {
        let Some(probe) = self.options.rays else {
            return value;
        };
        if let Some((_, times)) = probe.limit.filter(|(limit, _)| *limit == op) {
            return self.raised(op, times).unwrap_or(value);
        }
        let mut steps = probe.steps.iter().flatten();
        match steps.find(|(sum, _)| *sum == op) {
            Some(&(_, term)) if probe.thousandths != 1000 => {
                self.rescaled_sum((op, term), probe.thousandths, value)
            }
            _ => value,
        }
    }

    /// Appends the ray probe to the outputs.
    pub fn close_rays(&mut self) {
        let Some(rays) = self.rays else {
            return;
        };
        let one = self.float(1.0);
        let was = self.two(F2::And, rays.entered, one);
        let [x, y, z] = rays.point;
        let all = [
            ("ray.march", [was, rays.slope, rays.change, one]),
            ("ray.test", [rays.hit, rays.tested, rays.passed, one]),
            ("ray.point", [x, y, z, rays.has_point]),
        ];
        let slots = all.map(|(name, regs)| OutputSlot {
            name: name.to_string(),
            ty: Type::vector(Scalar::Float, 4),
            regs: regs.to_vec(),
        });
        self.code.outputs.extend(slots);
    }

    fn probed_rays(&self, id: LoopId) -> Made<(RayProbe, RayRegisters)> {
        let probe = self.options.rays.filter(|probe| probe.looped == id)?;
        Some((probe, self.rays?))
    }

    /// The registers of what moves.
    fn moved(&self, probe: &RayProbe) -> Made<Vec<Reg>> {
        let Value::Regs(regs) = self.variable_value(probe.moved) else {
            return None;
        };
        Some(probe.lanes().map(|lane| self.reg(regs, lane)).collect())
    }

    /// Emits code for the pixels that march for the first time.
    fn while_marching(&mut self, rays: RayRegisters, emit: impl FnOnce(&mut Self)) {
        let mark = self.slots();
        let others = self.slot();
        let jump = self.push(Instr::If {
            condition: rays.marches,
            others,
            to: 0,
        });
        emit(self);
        self.land(jump);
        self.push(Instr::EndIf { others });
        self.give_back_slots(mark);
    }

    /// The distance from the start: the sum over the moved scalars, which grows evenly along a ray.
    fn way(&mut self, probe: &RayProbe, rays: RayRegisters) -> Made<Reg> {
        let moved = self.moved(probe)?;
        let start: Vec<Reg> = self.list(rays.start).to_vec();
        self.sum_of(moved.into_iter().zip(start), |c, difference| {
            c.then_one(F1::Abs, difference)
        })
    }

    /// The sum of what is computed from differences.
    fn sum_of(
        &mut self,
        pairs: impl Iterator<Item = (Reg, Reg)>,
        mut each: impl FnMut(&mut Self, Reg) -> Reg,
    ) -> Made<Reg> {
        let mut sum: Option<Reg> = None;
        for (a, b) in pairs {
            let difference = self.two(F2::Subtract, a, b);
            let part = each(self, difference);
            sum = Some(match sum {
                None => part,
                Some(sum) => {
                    let more = self.then_two(F2::Add, sum, part);
                    self.registers.release(part);
                    more
                }
            });
        }
        sum
    }

    fn keep_point(&mut self, rays: RayRegisters, from: Regs) {
        for (at, to) in (0..).zip(rays.point) {
            let from = self.reg(from, at);
            self.push(Instr::MoveActive(to, from));
        }
        let one = self.float(1.0);
        self.push(Instr::MoveActive(rays.has_point, one));
    }

    fn keep_hit(&mut self, probe: &RayProbe, rays: RayRegisters, condition: Reg) {
        let one = self.float(1.0);
        let mut hit = self.two(F2::And, condition, one);
        if !probe.truth {
            hit = self.then_two(F2::Xor, hit, one);
        }
        self.push(Instr::MoveActive(rays.hit, hit));
        // A test of what the previous iteration left is of its place.
        let [last, before] = rays.places;
        let place = if probe.is_late { before } else { last };
        let is_hit = self.then_two(F2::Equal, hit, one);
        let passed = self.three(F3::Select, is_hit, rays.passed, place);
        self.push(Instr::MoveActive(rays.passed, passed));
        self.registers.release(is_hit);
        self.registers.release(passed);
        if let Some(way) = self.way(probe, rays) {
            self.push(Instr::MoveActive(rays.tested, way));
            self.registers.release(way);
        }
        self.keep_moved_point(probe, rays);
    }

    /// Notes the point, if it is what moves.
    fn keep_moved_point(&mut self, probe: &RayProbe, rays: RayRegisters) {
        if let Some(moved) = self.moved(probe).filter(|moved| moved.len() >= 3) {
            let from = self.listed(moved);
            self.keep_point(rays, from);
        }
    }

    /// Compares the distance with that of the last evaluation.
    fn measure_slope(&mut self, probe: &RayProbe, rays: RayRegisters, field: Reg) {
        self.keep_moved_point(probe, rays);
        let pairs = rays.point.into_iter().zip(rays.last_point);
        let squares = self.sum_of(pairs, |c, d| {
            let square = c.two(F2::Multiply, d, d);
            c.registers.release(d);
            square
        });
        let Some(squares) = squares else { return };
        let length = self.then_one(F1::Sqrt, squares);
        let difference = self.two(F2::Subtract, field, rays.last_field);
        let change = self.then_one(F1::Abs, difference);
        let slope = self.two(F2::Divide, change, length);
        let before = self.one(F1::Abs, rays.last_field);
        let relative = self.two(F2::Divide, change, before);
        // Where nothing moved, or for the first time, nothing is measured.
        let least = self.float(LEAST_MOVE);
        let one = self.float(1.0);
        let far = self.two(F2::Add, rays.places[0], one);
        let least = self.then_two(F2::Multiply, far, least);
        let moves = self.two(F2::Less, least, length);
        let both = self.two(F2::And, moves, rays.was_evaluated);
        for (most, new) in [(rays.slope, slope), (rays.change, relative)] {
            let larger = self.two(F2::MaxNumber, new, most);
            let kept = self.three(F3::Select, both, larger, most);
            self.push(Instr::MoveActive(most, kept));
            self.registers.release(larger);
            self.registers.release(kept);
        }
        for (to, from) in rays.last_point.into_iter().zip(rays.point) {
            self.push(Instr::MoveActive(to, from));
        }
        self.push(Instr::MoveActive(rays.last_field, field));
        let holds = self.constant(u32::MAX);
        self.push(Instr::MoveActive(rays.was_evaluated, holds));
        for reg in [length, change, slope, before, relative, least, moves, both] {
            self.registers.release(reg);
        }
    }

    /// A limit, several times as large.
    fn raised(&mut self, op: OpId, times: u32) -> Made<Value> {
        let bits = match *self.module.constant(op) {
            [Number::Int(n)] => n.saturating_mul(times as i32) as u32,
            [Number::Uint(n)] => n.saturating_mul(times),
            [Number::Float(n)] => (n * times as f32).to_bits(),
            _ => return None,
        };
        let reg = self.constant(bits);
        Some(Value::Regs(self.listed([reg])))
    }

    /// A sum with its term multiplied.
    fn rescaled_sum(&mut self, (op, term): (OpId, OpId), thousandths: u32, value: Value) -> Value {
        let OpKind::Binary(kind, ..) = self.module.op(op).kind else {
            return value;
        };
        let Value::Regs(regs) = value else {
            return value;
        };
        let terms = self.operand(term);
        // What is left of the term is added to the sum.
        let by = self.float(thousandths as f32 / 1000.0 - 1.0);
        let f = match kind {
            Binary::Subtract => F2::Subtract,
            _ => F2::Add,
        };
        let made: Vec<Reg> = (0..regs.len)
            .map(|at| {
                let (sum, term) = (self.reg(regs, at), self.reg(terms, at));
                let more = self.two(F2::Multiply, term, by);
                let made = self.then_two(f, sum, more);
                self.registers.release(more);
                made
            })
            .collect();
        Value::Regs(self.listed(made))
    }
}
