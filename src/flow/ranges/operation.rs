//! Transfer functions of IR operations.

use super::Query;
use super::builtin::of_function;
use super::entry::{join, measure};
use super::interval::{Interval, Tightness};
use super::node::{GetRange, Node, NodeSubject};
use crate::reaching_definitions::Def;
use crate::same::is_same;
use shaderlint_ir::{Binary, OpId, OpKind, Unary, column_lanes, length_lane};
use shaderlint_semantic::builtins::{MAX_PARAMS, Transfer};
use shaderlint_semantic::{BuiltinId, FunctionRef, Scalar, Type, VariableId};
use shaderlint_syntax::ast::List;

/// Maximum number of copies of a variable that are followed.
const MAX_COPIES: u32 = 8;

impl Query<'_> {
    /// The range of a component of an operation's value.
    pub(super) fn operation(
        &self,
        op: OpId,
        lane: u32,
        get: &mut impl GetRange,
    ) -> Option<Interval> {
        let (module, defs) = (self.module, self.defs);
        let found = module.op(op);
        if let Some((vector, rows)) = measured(found.ty, lane) {
            return self.length(op, vector, rows, get);
        }
        let source = 1u64 << (op.0 % 64);
        let mut of = |op: OpId, lane: u32| self.of_lane(op, lane, get);
        match found.kind {
            OpKind::Const(_) => Some(self.number(op, lane)),
            // The elements of an array that are written one after another share their range.
            OpKind::Undef if found.ty.is_array() => None,
            OpKind::Undef => Some(unknown(source)),
            OpKind::Unknown | OpKind::Store(..) => Some(unknown(source)),
            OpKind::Load(_) => get(Node::def(defs, defs.seen(op, lane))),
            OpKind::Unary(Unary::Negate, a) => Some(-of(a, lane)?),
            OpKind::Unary(Unary::Not, a) => {
                Some(Interval::new(0.0, 1.0, Tightness::Loose).like(&of(a, lane)?))
            }
            OpKind::Unary(Unary::BitNot, a) => Some(Interval::ANY.like(&of(a, lane)?)),
            OpKind::Binary(kind, a, b) => {
                let (x, y) = (of(a, lane), of(b, lane));
                Some(self.binary(kind, (a, x?), (b, y?), lane))
            }
            OpKind::MatrixProduct(a, b) => self.product(op, (a, b), lane, get),
            OpKind::Same { left, right, .. } => {
                let (x, y) = (of(left, 0), of(right, 0));
                Some(
                    Interval::new(0.0, 1.0, Tightness::Loose)
                        .like(&x?)
                        .like(&y?),
                )
            }
            OpKind::Select {
                then, otherwise, ..
            } => {
                let mut joined = join([of(then, lane), of(otherwise, lane)].into_iter())?;
                joined.sources |= source;
                Some(joined)
            }
            OpKind::Convert(a) => Some(self.converted(op, a, of(a, lane)?)),
            OpKind::Splat(a) => of(a, 0),
            OpKind::Compose(list) if found.ty.is_array() => {
                let elements = module.operands(list).iter().map(|e| of(*e, lane));
                let mut joined = join(elements)?;
                joined.sources |= source;
                Some(joined)
            }
            OpKind::Swizzle(..) | OpKind::Compose(_) | OpKind::Extract(..) => {
                match defs.part_of(module, op, lane) {
                    Some((part, lane)) => of(part, lane),
                    None => Some(Interval::ANY),
                }
            }
            OpKind::ExtractComputed { base, .. } => {
                let (count, stride) = picked(module.ty(base));
                let mut joined = join((0..count).map(|n| of(base, n * stride + lane)))?;
                joined.sources |= source;
                Some(joined)
            }
            OpKind::Builtin(function, list) => {
                let args = module.operands(list);
                let mut range = self.builtin(function, args, lane, get)?;
                if range.sources == 0 && range.single().is_none() {
                    range.sources = source;
                }
                Some(range)
            }
            OpKind::Call(function, list) => self.call(function, list, lane, get),
            OpKind::Returned(call, number) => self.returned(call, number, lane, source, get),
        }
    }

    /// The range of a component of a constant; `None` for other nodes.
    pub(super) fn constant(&self, node: Node) -> Option<Interval> {
        let NodeSubject::Lane(op, lane) = node.subject(self.defs) else {
            return None;
        };
        let found = self.module.op(op);
        if !matches!(found.kind, OpKind::Const(_)) || measured(found.ty, lane).is_some() {
            return None;
        }
        let mut range = self.number(op, lane);
        self.fit(op, lane, &mut range);
        Some(range)
    }

    fn number(&self, op: OpId, lane: u32) -> Interval {
        let ty = self.module.ty(op);
        let rows = ty.numeric().map_or(1, |(_, _, rows)| rows);
        let (column, row) = (lane / column_lanes(rows), lane % column_lanes(rows));
        let at = column * rows as u32 + row;
        let value = self.module.constant(op).get(at as usize);
        value.map_or(Interval::ANY, |v| Interval::constant(v.as_number()))
    }

    /// The range of a component of an operand.
    pub(super) fn of_lane(&self, op: OpId, lane: u32, get: &mut impl GetRange) -> Option<Interval> {
        match Node::lane(self.defs, op, lane) {
            Some(node) => get(node),
            None => Some(Interval::ANY),
        }
    }

    /// The length of a vector or of a matrix column that starts at component `first`: from the
    /// lengths of the operands if possible, else from the components.
    fn length(&self, op: OpId, first: u32, rows: u32, get: &mut impl GetRange) -> Option<Interval> {
        let (module, defs) = (self.module, self.defs);
        let at = first + rows;
        let mut of = |op: OpId, lane: u32| self.of_lane(op, lane, get);
        let scale = |op: OpId| match module.op(op).kind {
            OpKind::Splat(scalar) => Some(scalar),
            _ => None,
        };
        let direct = match module.op(op).kind {
            OpKind::Load(_) => return get(Node::def(defs, defs.seen(op, at))),
            OpKind::Unary(Unary::Negate, a) => return of(a, at),
            OpKind::Extract(a, number) => {
                let part = defs.layout.lane(module.ty(a), number)?;
                return of(a, part + at);
            }
            OpKind::Call(function, list) => return self.call(function, list, at, get),
            OpKind::Binary(Binary::Multiply, a, b) => {
                let scaled = match (scale(a), scale(b)) {
                    (Some(scalar), _) => Some((b, scalar)),
                    (_, scalar) => scalar.map(|scalar| (a, scalar)),
                };
                let both = scaled.and_then(|(v, scalar)| of(v, at).zip(of(scalar, 0)));
                both.map(|(length, scalar)| length * scalar.abs())
            }
            OpKind::Binary(Binary::Divide, a, b) => {
                let both = scale(b).and_then(|scalar| of(a, at).zip(of(scalar, 0)));
                both.map(|(length, scalar)| length / scalar.abs())
            }
            OpKind::Swizzle(a, lanes) => {
                let picked = lanes.numbers().iter().fold(0u8, |mask, n| mask | 1 << n);
                let all = module.ty(a).components();
                let is_all = lanes.count() as u32 == all && picked as u32 + 1 == 1 << all;
                length_lane(module.ty(a))
                    .filter(|_| is_all)
                    .and_then(|lane| of(a, lane))
            }
            OpKind::Select {
                then, otherwise, ..
            } => join([of(then, at), of(otherwise, at)].into_iter()),
            OpKind::Compose(_) if !module.ty(op).is_vector() => {
                match defs.part_of(module, op, at) {
                    Some((part, lane)) => of(part, lane),
                    None => None,
                }
            }
            OpKind::Builtin(function, list) => {
                let transfer = function.transfer();
                let args = module.operands(list);
                match (transfer, args) {
                    (Transfer::Direction, [_]) => Some(Interval::new(1.0, 1.0, Tightness::Touched)),
                    (Transfer::Reflection, [v, normal]) => {
                        let (length, normal) = (of(*v, at), of(*normal, at));
                        length.filter(|_| normal.is_some_and(is_unit))
                    }
                    _ => None,
                }
            }
            _ => None,
        };
        let parts = (first..at).map(|lane| of(op, lane));
        let mut length = match (direct, measure(parts)) {
            (Some(direct), Some(_)) if direct.hi.value.is_finite() => direct,
            (_, measured) => measured?,
        };
        length.raise(0.0);
        Some(length)
    }

    pub(super) fn is_integer(&self, op: OpId) -> bool {
        self.module
            .ty(op)
            .scalar_kind()
            .is_some_and(Scalar::is_integer)
    }

    fn binary(
        &self,
        op: Binary,
        (a, x): (OpId, Interval),
        (b, y): (OpId, Interval),
        lane: u32,
    ) -> Interval {
        let unknown = Interval::ANY.like(&x).like(&y);
        let same = || x.sources & y.sources != 0 && is_same(self.module, self.defs, a, b);
        match op {
            Binary::Add => match may_cross(&x, &y) && self.is_centred(a, b, lane, 1.0) {
                true => (x + y).taking_both_signs(),
                false => x + y,
            },
            Binary::Subtract if same() || self.is_passed_twice(&x, &y, (a, b), lane) => {
                Interval::constant(0.0)
            }
            Binary::Subtract => match may_cross(&x, &-y) && self.is_centred(a, b, lane, -1.0) {
                true => (x - y).taking_both_signs(),
                false => x - y,
            },
            Binary::Multiply if same() => x.square(),
            Binary::Multiply => x * y,
            Binary::Divide if self.is_integer(a) => (x / y).stepped(f64::trunc),
            Binary::Divide => match self.share(a, b, lane) {
                Some(share) => share.rounded().like(&x),
                None => x / y,
            },
            Binary::Remainder if y.lo.value > 0.0 => remainder(x, y),
            Binary::BitAnd if x.lo.value >= 0.0 || y.lo.value >= 0.0 => {
                let of = |r: Interval| match r.lo.value >= 0.0 {
                    true => r.hi.value,
                    false => f64::INFINITY,
                };
                Interval::new(0.0, of(x).min(of(y)), Tightness::Loose).like(&unknown)
            }
            Binary::ShiftRight if x.lo.value >= 0.0 => {
                Interval::new(0.0, x.hi.value, Tightness::Loose).like(&unknown)
            }
            Binary::BitOr | Binary::BitXor if x.lo.value >= 0.0 && y.lo.value >= 0.0 => {
                Interval::new(0.0, f64::INFINITY, Tightness::Loose).like(&unknown)
            }
            Binary::Less
            | Binary::LessEqual
            | Binary::Greater
            | Binary::GreaterEqual
            | Binary::And
            | Binary::Or
            | Binary::Xor => Interval::new(0.0, 1.0, Tightness::Loose).like(&unknown),
            _ => unknown,
        }
    }

    /// Whether every call passes the same value to two parameters.
    fn is_passed_twice(&self, x: &Interval, y: &Interval, (a, b): (OpId, OpId), lane: u32) -> bool {
        let (module, defs) = (self.module, self.defs);
        if x.sources & y.sources == 0 {
            return false;
        }
        let passed = |op| {
            let (load, at) = defs.through(module, op, lane)?;
            let Def::Entry(slot) = defs.get(defs.unrefined(defs.seen(load, at))) else {
                return None;
            };
            let variable = module.variable(defs.variable_at(slot).0)?;
            let is_one = !variable.ty.is_array();
            defs.passed(module, slot).filter(|_| is_one)
        };
        let Some((first, second)) = passed(a).zip(passed(b)) else {
            return false;
        };
        let (left, right) = (first.args(), second.args());
        first.lane == second.lane
            && left.len() == right.len()
            && left.len() <= MAX_COPIES as usize
            && left.zip(right).all(|(a, b)| is_same(module, defs, a, b))
    }

    /// The range after a conversion to another scalar type.
    fn converted(&self, op: OpId, a: OpId, range: Interval) -> Interval {
        let is_float = self.module.ty(a).scalar_kind() == Some(Scalar::Float);
        match self.module.ty(op).scalar_kind() {
            Some(kind) if kind.is_integer() && is_float => range.stepped(f64::trunc).exactly(),
            Some(Scalar::Bool) => Interval::new(0.0, 1.0, Tightness::Loose).like(&range),
            // A `bool` of unknown value.
            _ if !range.is_finite() && self.module.ty(a).scalar_kind() == Some(Scalar::Bool) => {
                Interval::new(0.0, 1.0, Tightness::Loose).like(&range)
            }
            _ => range,
        }
    }

    fn builtin(
        &self,
        function: BuiltinId,
        args: &[OpId],
        lane: u32,
        get: &mut impl GetRange,
    ) -> Option<Interval> {
        let (module, defs) = (self.module, self.defs);
        let transfer = function.transfer();
        let mut of = |op: OpId, lane: u32| self.of_lane(op, lane, get);
        let own = |op: OpId| module.operand_lane(op, lane);
        let all = |op: OpId| 0..module.ty(op).components().min(4);
        let every = args.iter().filter(|_| mixes(transfer));
        let every = every.flat_map(|&arg| all(arg).map(move |lane| (arg, lane)));
        let hanging = mixed(every.map(|(arg, lane)| of(arg, lane)));
        let mut length = |op: OpId| match length_lane(module.ty(op)) {
            Some(lane) => {
                let mut length = of(op, lane)?;
                length.raise(0.0);
                Some(length)
            }
            None => Some(of(op, 0)?.abs()),
        };
        Some(match (transfer, args) {
            (Transfer::Direction, &[v]) => direction(of(v, own(v))?),
            (Transfer::Reflection, &[v, normal]) => {
                let (v, normal) = (length(v), length(normal));
                let range = match is_unit(v?) && is_unit(normal?) {
                    true => Interval::new(-1.0, 1.0, Tightness::Touched),
                    false => Interval::ANY,
                };
                Interval {
                    sources: hanging?.sources,
                    ..range
                }
            }
            (Transfer::Norm, &[v]) => {
                let length = length(v)?.like(&hanging?);
                match length.single().is_none() && module.ty(v).is_vector() {
                    true => length.rounded(),
                    false => length,
                }
            }
            (Transfer::Separation, &[a, b]) => {
                let parts = all(a).map(|lane| {
                    let (x, y) = (of(a, lane), of(b, lane));
                    Some(x? - y?)
                });
                measure(parts)?.like(&hanging?)
            }
            (Transfer::Product, &[a, b]) => {
                let (x, y) = (length(a), length(b));
                if is_same(module, defs, a, b) {
                    return Some(x?.square().like(&hanging?));
                }
                let mut sources = |op: OpId| {
                    all(op).fold(0, |bits, lane| bits | of(op, lane).map_or(0, |r| r.sources))
                };
                let (own, other) = (sources(a), sources(b));
                let terms = all(a).map(|lane| Some(of(a, lane)? * of(b, lane)?));
                let sum = terms.reduce(|sum, term| Some(sum? + term?))??;
                Interval {
                    rounding: hanging?.rounding,
                    ..dot((x?, own), (y?, other)).within(&sum)
                }
            }
            (Transfer::Texel, _) => Interval::ANY.taking(0.0, 1.0).like(&hanging?),
            (_, &[a, b]) if function == BuiltinId::Cross && is_same(module, defs, a, b) => {
                Interval::constant(0.0)
            }
            (Transfer::Mixed, _) => Interval::ANY.like(&hanging?),
            (Transfer::MixedMagnitude, _) => {
                Interval::new(0.0, f64::INFINITY, Tightness::Loose).like(&hanging?)
            }
            _ => of_each(transfer, args.iter().map(|&arg| of(arg, own(arg))))?,
        })
    }

    /// The range of a function's return value. If the callers differ, the bounds may not be
    /// attained in this call.
    fn call(
        &self,
        function: FunctionRef,
        args: List,
        lane: u32,
        get: &mut impl GetRange,
    ) -> Option<Interval> {
        let defs = self.defs;
        let returned = defs.returns_of(function).iter();
        let mut nodes = returned.filter_map(|value| Node::lane(defs, *value, lane));
        let known = match nodes.next() {
            Some(first) => join(std::iter::once(first).chain(nodes).map(&mut *get)),
            None => Some(Interval::ANY),
        };
        let args = self.module.operands(args).iter();
        let passed = args.filter_map(|arg| get(Node::lane(defs, *arg, 0)?));
        let sources = passed.fold(0, |bits, range| bits | range.sources);
        let mut range = self.out_of(function, known?);
        range.sources |= sources;
        if range.sources == 0 && range.single().is_none() {
            range.sources = 1 << (function.0 % 64);
        }
        Some(range)
    }

    /// Makes the range of a result independent of individual callers.
    fn out_of(&self, function: FunctionRef, range: Interval) -> Interval {
        let mut range = match self.ranges.hides_function(function) {
            true => Interval {
                rounding: range.rounding,
                ..Interval::ANY
            },
            false => range,
        };
        if range.mixed {
            range = range.loose();
        }
        range.mixed = false;
        range
    }

    /// The range of what a call writes back to a parameter.
    fn returned(
        &self,
        call: OpId,
        number: u32,
        lane: u32,
        source: u64,
        get: &mut impl GetRange,
    ) -> Option<Interval> {
        let (module, defs) = (self.module, self.defs);
        let OpKind::Call(function, _) = module.op(call).kind else {
            return Some(unknown(source));
        };
        let parameter = module.function(function).and_then(|found| {
            let all = module.parameters(found);
            all.get(number as usize).copied()
        });
        let exit = parameter.and_then(|id| defs.exit(defs.slot(id, lane)));
        let Some(exit) = exit else {
            return Some(unknown(source));
        };
        let mut range = self.out_of(function, get(Node::def(defs, exit))?);
        if range.sources == 0 && range.single().is_none() {
            range.sources = source;
        }
        Some(range)
    }

    /// The variable set by the host, and the component, that a value is a copy of.
    pub(super) fn copied_from(&self, mut op: OpId, mut lane: u32) -> Option<(VariableId, u32)> {
        let (module, defs) = (self.module, self.defs);
        for _ in 0..MAX_COPIES {
            let (load, at) = defs.through(module, op, lane)?;
            let from = defs.copied_from(module, defs.seen(load, at));
            match defs.get(from) {
                Def::Entry(slot) => match defs.passed(module, slot) {
                    Some(passed) if passed.args().len() > 1 => return None,
                    Some(passed) => (op, lane) = (passed.args().next()?, passed.lane),
                    None => return Some(defs.variable_at(slot)),
                },
                Def::Stored { value, lane: at } if value != op => (op, lane) = (value, at),
                _ => return None,
            }
        }
        None
    }
}

/// Whether one number is non-negative and the other is not, each unbounded on one side.
fn may_cross(x: &Interval, y: &Interval) -> bool {
    let is_unbounded = |r: &Interval| r.lo.value.is_infinite() != r.hi.value.is_infinite();
    let is_positive = |r: &Interval| r.lo.value >= 0.0;
    is_unbounded(x) && is_unbounded(y) && is_positive(x) != is_positive(y)
}

fn unknown(sources: u64) -> Interval {
    Interval {
        sources,
        ..Interval::ANY
    }
}

/// The range of a built-in function that maps components individually. All arguments are requested,
/// even if one never has a value.
fn of_each(
    transfer: Transfer,
    args: impl ExactSizeIterator<Item = Option<Interval>>,
) -> Option<Interval> {
    let mut ranges = [Interval::ANY; MAX_PARAMS];
    let (count, mut is_made) = (args.len(), true);
    for (slot, arg) in ranges.iter_mut().zip(args) {
        match arg {
            Some(range) => *slot = range,
            None => is_made = false,
        }
    }
    let known = ranges.get(..count).filter(|_| is_made)?;
    Some(of_function(transfer, known))
}

/// An unbounded range with the combined sources and rounding of all operands.
fn mixed(all: impl Iterator<Item = Option<Interval>>) -> Option<Interval> {
    let mut mixed = Some(Interval::ANY.exactly());
    for one in all {
        mixed = mixed.zip(one).map(|(mixed, one)| Interval {
            sources: mixed.sources | one.sources,
            rounding: mixed.rounding_with(&one),
            ..mixed
        });
    }
    mixed
}

/// The first component and the number of components of the vector whose length is at `lane`.
fn measured(ty: Type, lane: u32) -> Option<(u32, u32)> {
    let (_, _, rows) = ty.element().numeric().filter(|(_, _, rows)| *rows > 1)?;
    let width = column_lanes(rows);
    (lane % width == rows as u32).then(|| (lane - rows as u32, rows as u32))
}

/// Count and stride of the candidates of a dynamic index.
fn picked(ty: Type) -> (u32, u32) {
    match ty.numeric() {
        Some((_, 1, rows)) => (rows as u32, 1),
        Some((_, columns, rows)) => (columns as u32, column_lanes(rows)),
        // The elements of an array share their components.
        None => (1, 0),
    }
}

fn is_unit(length: Interval) -> bool {
    length.single() == Some(1.0)
}

/// Whether each component of the result depends on all components of the arguments.
const fn mixes(transfer: Transfer) -> bool {
    matches!(
        transfer,
        Transfer::Norm
            | Transfer::Separation
            | Transfer::Product
            | Transfer::Reflection
            | Transfer::Texel
            | Transfer::Mixed
            | Transfer::MixedMagnitude
    )
}

/// The dot product of two vectors, each given by its length and its sources.
fn dot((a, own): (Interval, u64), (b, other): (Interval, u64)) -> Interval {
    let most = (a * b).hi.value;
    let mut range = Interval::new(-most, most, Tightness::Touched);
    range.sources = own | other;
    let is_free = own & other == 0 && a.hi.is_reached() && b.hi.is_reached();
    if is_free { range } else { range.loose() }
}

/// A component of `normalize`.
fn direction(of: Interval) -> Interval {
    let mut unit = Interval::new(-1.0, 1.0, Tightness::Touched)
        .rounded()
        .like(&of);
    if of.lo.value >= 0.0 {
        unit.lo = Interval::constant(0.0).lo;
        unit = unit.loose();
    } else if of.hi.value <= 0.0 {
        unit.hi = Interval::constant(0.0).hi;
        unit = unit.loose();
    } else if of.is_finite() && !(of.lo.is_reached() && of.hi.is_reached()) {
        unit = unit.loose();
    }
    unit
}

/// `x % y` for a positive `y`.
fn remainder(x: Interval, y: Interval) -> Interval {
    let most = (y.hi.value - 1.0).min(x.hi.value.max(0.0));
    let least = match x.lo.value >= 0.0 {
        true => 0.0,
        false => -y.hi.value + 1.0,
    };
    let mut range = Interval::new(least, most, Tightness::Touched)
        .like(&x)
        .like(&y);
    if x.lo.value == 0.0 && x.holds(0.0) {
        // Counters from zero hit multiples of `y` repeatedly.
        range = range.loose();
        range.lo.tightness = Tightness::Held;
    } else if x.is_finite() || y.single().is_none() {
        range = range.loose();
    } else if !(x.reaches_below(0.0) || x.lo.value == 0.0 && x.lo.is_reached()) {
        range.lo.tightness = Tightness::Loose;
    }
    range
}
