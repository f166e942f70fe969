//! Ranges of expressions.

use super::builtins::{of_function, of_host};
use super::interval::{Range, Reach, below};
use super::places::{PlaceId, Write, Written, swizzle};
use super::{Ranges, is_same};
use crate::semantic::builtins::Transfer;
use crate::semantic::flow::Structure;
use crate::semantic::{BuiltinId, FunctionRef, Program, Resolution, Scalar, Storage, VariableId};
use crate::syntax::ast::*;

/// How far the way to an answer may lead.
const MAX_DEPTH: u32 = 120;
/// Stands for the length of a vector among its components.
pub(super) const LENGTH: u8 = 4;

/// Answers questions about ranges.
#[derive(Clone, Copy)]
pub struct Evaluator<'x> {
    /// The shader.
    pub program: &'x Program,
    /// What stands in what.
    pub structure: &'x Structure,
    /// What is known already.
    pub ranges: &'x Ranges,
}

impl<'x> Evaluator<'x> {
    /// The range of a component of an expression; of a scalar, the component is 0.
    pub fn component(&self, expr: ExprId, component: u8) -> Range {
        self.part(expr, component, 0)
    }

    /// The ranges of all components of a number or vector.
    pub fn components(self, expr: ExprId) -> impl Iterator<Item = Range> + use<'x> {
        let ty = self.program.ty(expr);
        let count = if ty.is_matrix() { 0 } else { ty.components() };
        (0..count as u8).map(move |c| {
            let mut range = self.part(expr, c, 0);
            if count == 1 && !range.is_any() {
                self.narrow_written(expr, &mut range);
            }
            range
        })
    }

    /// The range of a component; a scalar stands for all components, as in `v * 2.0`.
    pub(super) fn part(&self, expr: ExprId, component: u8, depth: u32) -> Range {
        let element = self.program.ty(expr).element();
        let component = match element.components() {
            1 if component == LENGTH => return self.at(expr, 0, depth).abs(),
            1 => 0,
            _ if element.is_matrix() => return Range::ANY,
            0 => return Range::ANY,
            _ => component,
        };
        self.at(expr, component, depth)
    }

    fn at(&self, expr: ExprId, component: u8, depth: u32) -> Range {
        if depth > MAX_DEPTH {
            return Range::ANY;
        }
        if let Some(range) = self.constant(expr, component) {
            return range;
        }
        if let Some(known) = self.ranges.exprs.borrow().get(expr, component) {
            return known;
        }
        let range = match component {
            LENGTH => self.measured(expr, depth + 1),
            _ => self.fit(expr, self.compute(expr, component, depth + 1)),
        };
        self.ranges
            .exprs
            .borrow_mut()
            .insert(expr, component, range);
        range
    }

    /// The length of a vector: as a whole, or else from its components.
    fn measured(&self, expr: ExprId, depth: u32) -> Range {
        let whole = self.compute(expr, LENGTH, depth);
        let mut length = if whole.hi.value.is_finite() {
            whole
        } else {
            let count = self.program.ty(expr).element().components() as u8;
            self.length((0..count).map(|c| self.part(expr, c, depth)))
        };
        length.raise(0.0);
        length
    }

    fn constant(&self, expr: ExprId, component: u8) -> Option<Range> {
        let values = self.program.values(expr);
        if self.program.ty(expr).is_array() || values.is_empty() {
            return None;
        }
        let number = |v: &crate::semantic::Value| match *v {
            crate::semantic::Value::Int(v) => v as f64,
            crate::semantic::Value::Uint(v) => v as f64,
            v => v.as_float() as f64,
        };
        if component == LENGTH {
            let sum: f64 = values.iter().map(|v| number(v) * number(v)).sum();
            return Some(Range::constant(sum.sqrt()));
        }
        values
            .get(component as usize)
            .map(|v| Range::constant(number(v)))
    }

    /// Integers are whole, and wrap round where they are too large.
    fn fit(&self, expr: ExprId, range: Range) -> Range {
        let (lo, hi) = match self.program.ty(expr).element().scalar_kind() {
            Some(Scalar::Int) => (i32::MIN as f64, i32::MAX as f64),
            Some(Scalar::Uint) => (0.0, u32::MAX as f64),
            Some(Scalar::Bool) => (0.0, 1.0),
            _ => return range,
        };
        let wraps = |r: &Range| {
            (r.lo.value < lo && r.lo.value.is_finite())
                || (r.hi.value > hi && r.hi.value.is_finite())
        };
        let whole = Range::new(f64::NEG_INFINITY, f64::INFINITY, Reach::Loose).like(&range);
        let mut fitting = if wraps(&range) { whole } else { range };
        if lo == 0.0 && fitting.lo.value < 0.0 {
            fitting = Range::new(0.0, f64::INFINITY, Reach::Loose).like(&range);
        }
        fitting.exactly()
    }

    fn compute(&self, expr: ExprId, component: u8, depth: u32) -> Range {
        let program = self.program;
        match program.tree.expr(expr).kind {
            ExprKind::Paren(inner) => self.at(inner, component, depth),
            ExprKind::Name(_) | ExprKind::Index(..) | ExprKind::Member(..) => {
                self.read(expr, component, depth)
            }
            ExprKind::Unary(UnaryOp::Plus, inner) => self.part(inner, component, depth),
            ExprKind::Unary(UnaryOp::Minus, inner) if component == LENGTH => {
                self.part(inner, component, depth)
            }
            ExprKind::Unary(UnaryOp::Minus, inner) => -self.part(inner, component, depth),
            ExprKind::Binary(op, a, b) => self.binary(op, a, b, component, depth),
            ExprKind::Assign(None, _, value) => self.part(value, component, depth),
            ExprKind::Ternary(_, a, b) => {
                let (a, b) = (
                    self.part(a, component, depth),
                    self.part(b, component, depth),
                );
                let mut range = a.join(b);
                range.sources |= 1 << (expr.0 % 64);
                range
            }
            ExprKind::Comma(_, b) => self.part(b, component, depth),
            ExprKind::Call(_, args) => match program.expr(expr).resolution {
                Resolution::Function(callee) => {
                    self.result(callee, component, depth, program.tree.args(args))
                }
                Resolution::Builtin(_) => {
                    let function = program.builtin_called(expr);
                    let transfer = function.map_or(Transfer::Unknown, BuiltinId::transfer);
                    let args = program.tree.args(args);
                    let mut range = self.builtin(transfer, args, component, depth);
                    if range.sources == 0 && range.single().is_none() {
                        range.sources = 1 << (expr.0 % 64);
                    }
                    range
                }
                _ => Range::ANY,
            },
            ExprKind::Construct(_, args) => self.construct(expr, args, component, depth),
            ExprKind::Method(..) => Range::new(1.0, f64::INFINITY, Reach::Loose).exactly(),
            _ => Range::ANY,
        }
    }

    /// A variable or a part of one.
    fn read(&self, expr: ExprId, component: u8, depth: u32) -> Range {
        let program = self.program;
        let mut range = match program.tree.expr(expr).kind {
            ExprKind::Member(object, name) => match swizzle(program, object, name) {
                Some(components) if component == LENGTH => {
                    let parts = (0..4).map_while(|p| components.at(p));
                    self.length(parts.map(|c| self.part(object, c, depth)))
                }
                Some(components) => match components.at(component) {
                    Some(named) => self.part(object, named, depth),
                    None => Range::ANY,
                },
                None => match self.ranges.places.field(program, object, name) {
                    Some(place) => self.place(place, component, depth),
                    None => Range::ANY,
                },
            },
            ExprKind::Index(object, index) => {
                let ty = program.ty(object);
                if ty.is_array() {
                    self.part(object, component, depth)
                } else if ty.is_vector() {
                    match program.scalar(index) {
                        Some(at) => self.part(object, at.as_int().clamp(0, 3) as u8, depth),
                        None => self.any_of(object, depth),
                    }
                } else {
                    Range::ANY
                }
            }
            _ => match program.variable_of(expr) {
                Some(variable) => match self.last_written(expr, variable, component, depth) {
                    Some(range) => range,
                    None => self.variable(variable, component, depth),
                },
                None => Range::ANY,
            },
        };
        if component != LENGTH
            && let Some((place, named)) = self.ranges.places.named(program, expr)
            && let Some(variable) = self.narrowable(place)
        {
            let at = named.map_or(Some(component), |n| n.at(component));
            if let Some(at) = at {
                self.narrow(expr, variable, at, &mut range, depth);
            }
            // The conditions cannot all hold for what is known: some of it is wrong.
            if range.lo.value > range.hi.value {
                range = Range::ANY.like(&range);
            }
        }
        range
    }

    fn variable(&self, id: VariableId, component: u8, depth: u32) -> Range {
        let program = self.program;
        let Some(variable) = program.variable(id) else {
            return Range::ANY;
        };
        let is_host = matches!(variable.storage, Storage::Uniform | Storage::Input);
        if is_host || variable.token.is_none() {
            let host = of_host(program.names.text(variable.name), component);
            let source = 1 << ((id.0 * 4 + component as u32) % 64);
            return Range {
                sources: source,
                ..host.unwrap_or(Range::ANY)
            };
        }
        let constants = program.pool.values(variable.constant);
        if variable.is_const && component != LENGTH && variable.ty.is_array() {
            let step = variable.ty.element().components().max(1) as usize;
            let values = constants.iter().skip(component as usize).step_by(step);
            let all = values.map(|v| Range::constant(v.as_float() as f64));
            if let Some(range) = all.reduce(Range::join) {
                return Range {
                    sources: 1 << (id.0 % 64),
                    ..range
                };
            }
        }
        self.place(PlaceId(id.0), component, depth)
    }

    /// What a place may hold.
    pub(super) fn place(&self, place: PlaceId, component: u8, depth: u32) -> Range {
        let source = 1u64 << ((place.0 * 4 + component as u32) % 64);
        let unknown = Range {
            sources: source,
            ..Range::ANY
        };
        if depth > MAX_DEPTH {
            return unknown;
        }
        let key = (place.0, component);
        if let Some(known) = self.ranges.places_known.borrow().get(&key) {
            return known.unwrap_or(unknown);
        }
        self.ranges.places_known.borrow_mut().insert(key, None);
        let writes = self.ranges.places.writes(place);
        let mut range = self.joined(writes, component, depth).unwrap_or(unknown);
        if writes.len() > 1 || range.is_any() {
            range.sources |= source;
        }
        range.mixed |= writes.len() > 1 && self.is_parameter(place);
        if writes.len() > 1 && !self.is_steady(place) {
            range = range.loose();
        }
        if self.ranges.hidden_places.get(place.0 as usize) == Some(&true) {
            // Whether it is rounded, the writes that are known tell best.
            range = Range {
                exact: range.exact,
                ..unknown
            };
        }
        self.ranges
            .places_known
            .borrow_mut()
            .insert(key, Some(range));
        range
    }

    /// Whether each value of a place reaches its uses: what the callers of a function pass, and
    /// the turns of a loop's counter. Of other writes it is not known which come last.
    fn is_steady(&self, place: PlaceId) -> bool {
        let variable = VariableId(place.0);
        if self.is_parameter(place) {
            return !self.ranges.places.is_changed(variable);
        }
        self.ranges.counters.contains(&variable)
    }

    fn is_parameter(&self, place: PlaceId) -> bool {
        let variable = self.program.variable(VariableId(place.0));
        variable.is_some_and(|v| matches!(v.storage, Storage::Param(_)))
    }

    /// Joins the writes to a component; `None` where there is none, or one is unknown.
    fn joined(&self, writes: &[Write], component: u8, depth: u32) -> Option<Range> {
        let mut known: Option<Range> = None;
        let mut own = Vec::new();
        for write in writes {
            let at = match write.to {
                Some(_) if component == LENGTH => return None,
                Some(to) => match to.position(component) {
                    Some(at) => at,
                    None => continue,
                },
                None => component,
            };
            let range = match write.value {
                Written::Value(value) => self.part(value, at, depth + 1),
                Written::Copy(from) => self.place(from, at, depth + 1),
                Written::Unknown => return None,
                Written::Combined(..) | Written::Step(_) => {
                    own.push((write.value, at));
                    continue;
                }
            };
            known = Some(known.map_or(range, |k| k.join(range)));
        }
        let mut range = known?;
        for (value, at) in own {
            range = self.own_change(range, value, at, depth)?;
        }
        Some(range)
    }

    /// What a place holds once its own value may have been changed any number of times.
    fn own_change(&self, start: Range, value: Written, at: u8, depth: u32) -> Option<Range> {
        let (op, by) = match value {
            Written::Step(by) => (BinaryOp::Add, Range::constant(by)),
            Written::Combined(op, value) => (op, self.part(value, at, depth + 1)),
            _ => return None,
        };
        if at == LENGTH {
            return None;
        }
        let by = if op == BinaryOp::Sub { -by } else { by };
        let mut range = start.like(&by);
        range.exact &= by.exact;
        match op {
            BinaryOp::Add | BinaryOp::Sub => {
                if by.hi.value > 0.0 {
                    range = range
                        .join(Range::new(start.lo.value, f64::INFINITY, Reach::Loose).exactly());
                }
                if by.lo.value < 0.0 {
                    range = range.join(
                        Range::new(f64::NEG_INFINITY, start.hi.value, Reach::Loose).exactly(),
                    );
                }
                if by.lo.value >= 0.0 {
                    range.lo = start.lo;
                }
                if by.hi.value <= 0.0 {
                    range.hi = start.hi;
                }
            }
            BinaryOp::Mul if by.lo.value >= 0.0 && start.lo.value >= 0.0 => {
                let hi = if by.hi.value <= 1.0 {
                    start.hi.value
                } else {
                    f64::INFINITY
                };
                range = range.join(Range::new(0.0, hi, Reach::Loose).exactly());
            }
            BinaryOp::Div if by.lo.value >= 1.0 && start.lo.value >= 0.0 => {
                range = range.join(Range::new(0.0, start.hi.value, Reach::Loose));
            }
            _ => return None,
        }
        Some(range)
    }

    /// What a function returns. Where callers differ, the bounds are not those of one call.
    fn result(&self, callee: FunctionRef, component: u8, depth: u32, args: &[ExprId]) -> Range {
        let key = (callee.0, component);
        let known = self.ranges.results.borrow().get(&key).copied();
        let range = match known {
            Some(known) => known.unwrap_or(Range::ANY),
            None if depth > MAX_DEPTH => Range::ANY,
            None => {
                self.ranges.results.borrow_mut().insert(key, None);
                let returns = self.ranges.places.returns(callee).iter();
                let all = returns.map(|&e| self.part(e, component, depth + 1));
                let mut range = all.reduce(Range::join).unwrap_or(Range::ANY);
                if self.ranges.hidden_functions.get(callee.0 as usize) == Some(&true) {
                    range = Range {
                        exact: range.exact,
                        ..Range::ANY
                    };
                }
                self.ranges.results.borrow_mut().insert(key, Some(range));
                range
            }
        };
        let mut range = if range.mixed { range.loose() } else { range };
        range.mixed = false;
        for &arg in args {
            if self.program.ty(arg).components() > 0 {
                range.sources |= self.part(arg, 0, depth + 1).sources;
            }
        }
        if range.sources == 0 && range.single().is_none() {
            range.sources = 1 << (callee.0 % 64);
        }
        range
    }

    /// Any component of a vector.
    fn any_of(&self, vector: ExprId, depth: u32) -> Range {
        let count = self.program.ty(vector).components() as u8;
        let all = (0..count).map(|c| self.part(vector, c, depth));
        all.reduce(Range::join).unwrap_or(Range::ANY)
    }

    /// The length of a vector of these components.
    fn length(&self, parts: impl Iterator<Item = Range>) -> Range {
        let squares = parts.map(|p| p.square());
        let sum = squares.reduce(|a, b| a + b).unwrap_or(Range::ANY);
        let mut length = sum.rising(|v| v.max(0.0).sqrt());
        length.raise(0.0);
        length
    }

    fn construct(&self, expr: ExprId, args: List, component: u8, depth: u32) -> Range {
        let program = self.program;
        let ty = program.ty(expr);
        let args = program.tree.args(args);
        if ty.is_array() {
            let all = args.iter().map(|&a| self.part(a, component, depth));
            let range = all.reduce(Range::join).unwrap_or(Range::ANY);
            return Range {
                sources: range.sources | 1 << (expr.0 % 64),
                ..range
            };
        }
        if component == LENGTH {
            let count = ty.components() as u8;
            return self.length((0..count).map(|c| self.part(expr, c, depth)));
        }
        let mut before = 0;
        for &arg in args {
            let count = program.ty(arg).components();
            let is_spread = args.len() == 1 && count == 1;
            if is_spread || (component as u32) < before + count {
                let at = if is_spread {
                    0
                } else {
                    component - before as u8
                };
                return self.converted(expr, self.part(arg, at, depth), arg);
            }
            before += count;
        }
        Range::ANY
    }

    /// The value of a constructor's argument, converted.
    fn converted(&self, expr: ExprId, range: Range, arg: ExprId) -> Range {
        let is_float = self.program.ty(arg).scalar_kind() == Some(Scalar::Float);
        match self.program.ty(expr).scalar_kind() {
            Some(kind) if kind.is_integer() && is_float => range.rising(f64::trunc).exactly(),
            Some(Scalar::Bool) => Range::new(0.0, 1.0, Reach::Loose).like(&range),
            _ => range,
        }
    }

    fn builtin(&self, transfer: Transfer, args: &[ExprId], component: u8, depth: u32) -> Range {
        let part = |e: ExprId| self.part(e, component, depth);
        let length = |e: ExprId| self.part(e, LENGTH, depth);
        match (transfer, args) {
            (Transfer::Direction, &[_]) if component == LENGTH => {
                Range::new(1.0, 1.0, Reach::Touched)
            }
            (Transfer::Direction, &[v]) => {
                let of = part(v);
                let mut unit = Range::new(-1.0, 1.0, Reach::Touched).like(&of);
                if of.lo.value >= 0.0 {
                    unit.lo = Range::constant(0.0).lo;
                    unit = unit.loose();
                } else if of.hi.value <= 0.0 {
                    unit.hi = Range::constant(0.0).hi;
                    unit = unit.loose();
                } else if of.is_finite() && !(of.lo.is_reached() && of.hi.is_reached()) {
                    unit = unit.loose();
                }
                unit
            }
            (Transfer::Reflection, &[v, n]) if component == LENGTH && is_unit(length(n)) => {
                length(v)
            }
            (Transfer::Reflection, &[v, n]) => {
                let (v, n) = (length(v), length(n));
                let sources = self.sources(args, depth);
                let range = if is_unit(v) && is_unit(n) {
                    Range::new(-1.0, 1.0, Reach::Touched)
                } else {
                    Range::ANY
                };
                Range { sources, ..range }
            }
            (_, _) if component == LENGTH => Range::ANY,
            (Transfer::Norm, &[v]) => length(v).like(&self.hanging(args, depth)),
            (Transfer::Separation, &[a, b]) => {
                let count = self.program.ty(a).components() as u8;
                let parts = (0..count).map(|c| self.part(a, c, depth) - self.part(b, c, depth));
                self.length(parts).like(&self.hanging(args, depth))
            }
            (Transfer::Product, &[a, b]) => {
                if is_same(self.program, a, b) {
                    return length(a).square().like(&self.hanging(args, depth));
                }
                let (a_length, b_length) = (length(a), length(b));
                let range = a_length * b_length;
                let (a, b) = (self.sources(&[a], depth), self.sources(&[b], depth));
                let mut range = Range::new(-range.hi.value, range.hi.value, Reach::Touched);
                range.sources = a | b;
                let is_free = a & b == 0 && a_length.hi.is_reached() && b_length.hi.is_reached();
                if is_free { range } else { range.loose() }
            }
            (Transfer::Texel, _) => Range {
                sources: self.sources(args, depth),
                ..Range::ANY
            },
            (Transfer::Mixed, _) => Range::ANY.like(&self.hanging(args, depth)),
            (Transfer::MixedMagnitude, _) => {
                Range::new(0.0, f64::INFINITY, Reach::Loose).like(&self.hanging(args, depth))
            }
            _ => {
                let ranges: Vec<Range> = args.iter().map(|&a| part(a)).collect();
                of_function(transfer, &ranges)
            }
        }
    }

    /// What any component of these hangs on.
    fn sources(&self, args: &[ExprId], depth: u32) -> u64 {
        let of = |&e: &ExprId| {
            let count = self.program.ty(e).components().min(4) as u8;
            (0..count).fold(0, |bits, c| bits | self.part(e, c, depth).sources)
        };
        args.iter().fold(0, |bits, e| bits | of(e))
    }

    fn hanging(&self, args: &[ExprId], depth: u32) -> Range {
        Range {
            sources: self.sources(args, depth),
            ..Range::ANY
        }
    }

    pub(super) fn binary(
        &self,
        op: BinaryOp,
        a: ExprId,
        b: ExprId,
        component: u8,
        depth: u32,
    ) -> Range {
        let program = self.program;
        if program.ty(a).is_matrix() || program.ty(b).is_matrix() {
            return Range::ANY;
        }
        let (x, y) = (
            self.part(a, component, depth),
            self.part(b, component, depth),
        );
        let unknown = Range::ANY.like(&x).like(&y);
        if component == LENGTH {
            let is_scaled = program.ty(a).is_scalar() || program.ty(b).is_scalar();
            return match op {
                BinaryOp::Mul if is_scaled => x * y,
                BinaryOp::Div if program.ty(b).is_scalar() => x / y,
                _ => unknown,
            };
        }
        let is_whole = program.ty(a).scalar_kind() != Some(Scalar::Float);
        match op {
            BinaryOp::Add => x + y,
            BinaryOp::Sub if x.sources != 0 && is_same(program, a, b) => Range::constant(0.0),
            BinaryOp::Sub => x - y,
            BinaryOp::Mul if x.sources != 0 && is_same(program, a, b) => x.square(),
            BinaryOp::Mul => x * y,
            BinaryOp::Div if is_whole => (x / y).rising(f64::trunc),
            BinaryOp::Div => match self.is_share(a, b, component) {
                true => Range::new(0.0, below(1.0), Reach::Touched).like(&x),
                false => x / y,
            },
            BinaryOp::Rem if y.lo.value > 0.0 => {
                let most = (y.hi.value - 1.0).min(x.hi.value.max(0.0));
                let least = if x.lo.value >= 0.0 {
                    0.0
                } else {
                    -y.hi.value + 1.0
                };
                let mut range = Range::new(least, most, Reach::Touched).like(&x).like(&y);
                if x.is_finite() || y.single().is_none() {
                    range = range.loose();
                } else if !x.reaches_below(0.0) {
                    range.lo.reach = Reach::Loose;
                }
                range
            }
            BinaryOp::BitAnd if x.lo.value >= 0.0 || y.lo.value >= 0.0 => {
                let of = |r: Range| {
                    if r.lo.value >= 0.0 {
                        r.hi.value
                    } else {
                        f64::INFINITY
                    }
                };
                Range::new(0.0, of(x).min(of(y)), Reach::Loose).like(&unknown)
            }
            BinaryOp::ShiftRight if x.lo.value >= 0.0 => {
                Range::new(0.0, x.hi.value, Reach::Loose).like(&unknown)
            }
            BinaryOp::BitOr | BinaryOp::BitXor if x.lo.value >= 0.0 && y.lo.value >= 0.0 => {
                Range::new(0.0, f64::INFINITY, Reach::Loose).like(&unknown)
            }
            _ => unknown,
        }
    }

    /// Whether this is `fragCoord.x / iResolution.x`: how far along the picture a pixel lies.
    fn is_share(&self, a: ExprId, b: ExprId, component: u8) -> bool {
        let named = |e, name: &str| {
            let found = self.copied_from(e, component, 0);
            found.is_some_and(|(v, c)| {
                let variable = self.program.variable(v);
                variable.is_some_and(|v| self.program.names.text(v.name) == name)
                    && (c == component || self.program.ty(e).is_scalar())
            })
        };
        let same = |e, of| {
            self.copied_from(e, component, 0).map(|f| f.1)
                == self.copied_from(of, component, 0).map(|f| f.1)
        };
        named(b, "iResolution") && named(a, "gl_FragCoord") && same(a, b)
    }

    /// The variable, and its component, that an expression is a copy of.
    fn copied_from(&self, expr: ExprId, component: u8, depth: u32) -> Option<(VariableId, u8)> {
        if depth > 8 {
            return None;
        }
        let (place, named) = self.ranges.places.named(self.program, expr)?;
        let component = match named {
            Some(named) => named.at(if self.program.ty(expr).is_scalar() {
                0
            } else {
                component
            })?,
            None => component,
        };
        match self.ranges.places.writes(place) {
            [] => Some((VariableId(place.0), component)),
            [
                Write {
                    value: Written::Unknown,
                    ..
                },
            ] => Some((VariableId(place.0), component)),
            &[
                Write {
                    value: Written::Value(value),
                    to: None,
                },
            ] => self.copied_from(value, component, depth + 1),
            _ => None,
        }
    }
}

fn is_unit(length: Range) -> bool {
    length.single() == Some(1.0)
}
