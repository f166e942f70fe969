//! Whether a value is used as an angle only: as a sum or a multiple in arguments of `sin`, `cos` and
//! `tan`.

use super::ranges::Query;
use super::reaching_definitions::{Def, DefId};
use rustc_hash::FxHashMap;
use shaderlint_ir::{Binary, OpId, OpKind, Root, Unary};
use shaderlint_semantic::{BuiltinId, Scalar};

/// Most steps from one value to the next that it is computed from.
const MAX_DEPTH: u32 = 100;

/// A use of a value as an angle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AngleUse {
    /// The call of `sin`, `cos` or `tan`.
    pub call: OpId,
    /// The function.
    pub function: BuiltinId,
    /// What the value is multiplied by.
    pub factor: f64,
}

/// All uses of a scalar; `None` if one of them is not as an angle.
pub fn angle_uses(query: Query, value: OpId) -> Option<Vec<AngleUse>> {
    let mut angles = Angles {
        query,
        value,
        lanes: FxHashMap::default(),
        defs: FxHashMap::default(),
        heads: Vec::new(),
    };
    let mut uses = Vec::new();
    for op in (0..query.module.ops.len() as u32).map(OpId) {
        angles.consumer(op, &mut uses)?;
    }
    angles.are_heads_free().then_some(uses)
}

/// How a component depends on the value.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Dependence {
    /// Not at all, or through an angle.
    Free,
    /// It is a multiple of the value plus something else.
    Times(f64),
    /// In another way.
    Other,
}

use Dependence::{Free, Other, Times};

struct Angles<'x> {
    query: Query<'x>,
    value: OpId,
    lanes: FxHashMap<(OpId, u32), Dependence>,
    defs: FxHashMap<DefId, Dependence>,
    /// The values that loops carry from one iteration to the next, which are taken not to depend on it.
    heads: Vec<DefId>,
}

impl Angles<'_> {
    /// Records an operation that uses the value as an angle; `None` if it uses it otherwise.
    fn consumer(&mut self, op: OpId, uses: &mut Vec<AngleUse>) -> Option<()> {
        let module = self.query.module;
        match module.op(op).kind {
            OpKind::Builtin(function, list) if period(function).is_some() => {
                let &[angle] = module.operands(list) else {
                    return None;
                };
                for lane in 0..self.query.defs.lanes_of(angle) {
                    match self.lane((angle, lane), 0) {
                        Free => {}
                        Times(factor) => uses.push(AngleUse {
                            call: op,
                            function,
                            factor,
                        }),
                        Other => return None,
                    }
                }
                Some(())
            }
            OpKind::Store(place, value) if self.is_plain(place) => self.linear(value),
            // Parameters see their arguments.
            OpKind::Call(..) => self.linear(op),
            OpKind::Unary(Unary::Negate, _)
            | OpKind::Binary(
                Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide,
                ..,
            )
            | OpKind::Splat(_)
            | OpKind::Swizzle(..)
            | OpKind::Extract(..)
            | OpKind::Select { .. } => self.linear(op),
            OpKind::Compose(_) if module.ty(op).is_vector() => self.linear(op),
            OpKind::Convert(_) if module.ty(op).scalar_kind() == Some(Scalar::Float) => {
                self.linear(op)
            }
            // The value itself is computed from its operands.
            _ if op == self.value => Some(()),
            _ => self.unused(op),
        }
    }

    /// Whether a place is a variable, or components of one, that only the shader reads.
    fn is_plain(&self, place: shaderlint_ir::PlaceId) -> bool {
        let module = self.query.module;
        let place = module.place(place);
        module.variable(place.variable).is_some_and(|v| {
            let is_own = matches!(
                v.root,
                Root::Local | Root::Temporary | Root::Parameter | Root::Global
            );
            is_own && (v.ty.is_scalar() || v.ty.is_vector())
        })
    }

    /// `None` if a component depends on the value, but not as a multiple.
    fn linear(&mut self, op: OpId) -> Option<()> {
        let count = self.query.defs.lanes_of(op);
        let is_linear = (0..count).all(|lane| self.lane((op, lane), 0) != Other);
        is_linear.then_some(())
    }

    /// `None` if an operand depends on the value.
    fn unused(&mut self, op: OpId) -> Option<()> {
        let (module, defs) = (self.query.module, self.query.defs);
        let mut is_free = true;
        module.each_operand(op, |operand| {
            let mut lanes = 0..defs.lanes_of(operand);
            is_free &= lanes.all(|lane| self.lane((operand, lane), 0) == Free);
        });
        is_free.then_some(())
    }

    fn lane(&mut self, at: (OpId, u32), depth: u32) -> Dependence {
        if at.0 == self.value {
            return Times(1.0);
        }
        if let Some(known) = self.lanes.get(&at) {
            return *known;
        }
        if depth > MAX_DEPTH {
            return Other;
        }
        let found = self.computed(at, depth + 1);
        self.lanes.insert(at, found);
        found
    }

    fn computed(&mut self, (op, lane): (OpId, u32), depth: u32) -> Dependence {
        let (module, defs) = (self.query.module, self.query.defs);
        if let OpKind::Load(_) = module.op(op).kind {
            return self.def(defs.unrefined(defs.seen(op, lane)), depth);
        }
        if let Some(part) = defs.part_of(module, op, lane) {
            return self.lane(part, depth);
        }
        match module.op(op).kind {
            OpKind::Unary(Unary::Negate, a) => self.lane((a, lane), depth).times(-1.0),
            OpKind::Convert(a) => self.lane((a, lane), depth),
            OpKind::Splat(a) => self.lane((a, 0), depth),
            OpKind::Binary(kind, a, b) => {
                let [left, right] = [a, b].map(|side| self.lane((side, lane), depth));
                let number = |op| self.query.lane(op, lane).single();
                match kind {
                    Binary::Add => left.plus(right),
                    Binary::Subtract => left.plus(right.times(-1.0)),
                    Binary::Multiply if right == Free => left.scaled(number(b)),
                    Binary::Multiply if left == Free => right.scaled(number(a)),
                    Binary::Divide if right == Free => left.scaled(number(b).map(f64::recip)),
                    Binary::Multiply | Binary::Divide => Other,
                    _ => Free,
                }
            }
            OpKind::Select {
                then, otherwise, ..
            } => {
                let sides = [then, otherwise].map(|side| self.lane((side, lane), depth));
                joined(sides.into_iter())
            }
            OpKind::Call(function, _) => {
                let values = defs.returns_of(function).iter();
                let values: Vec<_> = values.map(|v| self.lane((*v, lane), depth)).collect();
                joined(values.into_iter())
            }
            // Other uses are found at the operation itself.
            _ => Free,
        }
    }

    fn def(&mut self, def: DefId, depth: u32) -> Dependence {
        if let Some(known) = self.defs.get(&def) {
            return *known;
        }
        if depth > MAX_DEPTH {
            return Other;
        }
        let found = self.defined(def, depth + 1);
        self.defs.insert(def, found);
        found
    }

    fn defined(&mut self, def: DefId, depth: u32) -> Dependence {
        let (module, defs) = (self.query.module, self.query.defs);
        match defs.get(def) {
            Def::Stored { value, lane } => self.lane((value, lane), depth),
            Def::Refined { of, .. } => self.def(of, depth),
            Def::Merge { sides, .. } | Def::Measured(sides) => self.all(defs.list(sides), depth),
            Def::Head { .. } => {
                self.heads.push(def);
                Free
            }
            Def::Entry(slot) => match defs.passed(module, slot) {
                Some(passed) => {
                    let lane = passed.lane;
                    let args: Vec<OpId> = passed.args().collect();
                    let args: Vec<_> = args
                        .into_iter()
                        .map(|arg| self.lane((arg, lane), depth))
                        .collect();
                    joined(args.into_iter())
                }
                None => self.all(defs.global_writes(slot), depth),
            },
            Def::Unknown => Free,
        }
    }

    /// Whether no loop carries the value, as was assumed.
    fn are_heads_free(&mut self) -> bool {
        let mut next = 0;
        while let Some(&head) = self.heads.get(next) {
            if let Def::Head { init, back, .. } = self.query.defs.get(head)
                && self.all(&[init, back], 0) != Free
            {
                return false;
            }
            next += 1;
        }
        true
    }

    fn all(&mut self, list: &[DefId], depth: u32) -> Dependence {
        let defs = self.query.defs;
        let all: Vec<_> = list
            .iter()
            .map(|def| self.def(defs.unrefined(*def), depth))
            .collect();
        joined(all.into_iter())
    }
}

impl Dependence {
    fn times(self, factor: f64) -> Dependence {
        match self {
            Times(known) => Times(known * factor),
            _ => self,
        }
    }

    fn scaled(self, factor: Option<f64>) -> Dependence {
        match (self, factor) {
            (Times(known), Some(factor)) => Times(known * factor),
            (Times(_), None) => Other,
            _ => self,
        }
    }

    fn plus(self, other: Dependence) -> Dependence {
        match (self, other) {
            (Other, _) | (_, Other) => Other,
            (Free, known) | (known, Free) => known,
            (Times(a), Times(b)) => Times(a + b),
        }
    }
}

/// The dependence of a value that is one of several.
fn joined(mut all: impl Iterator<Item = Dependence>) -> Dependence {
    let first = all.next().unwrap_or(Free);
    match all.all(|other| other == first) {
        true => first,
        false => Other,
    }
}

/// The period of a function of an angle.
pub fn period(function: BuiltinId) -> Option<f64> {
    use std::f64::consts::{PI, TAU};
    match function {
        BuiltinId::Sin | BuiltinId::Cos => Some(TAU),
        BuiltinId::Tan => Some(PI),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_shader::{TestShader, cases};

    /// Checks the uses of the first `mod` in a shader, in a function `f` of `x`.
    #[track_caller]
    fn check(body: &str, expected: &str) {
        let code = format!(
            "float g; float wave(float a) {{ return sin(a); }} float half_of(float a) {{ return 0.5 * a; }}
            float f(float x) {{ {body} }}
            void mainImage(out vec4 o, vec2 q) {{ o = vec4(f(q.x)); }}"
        );
        let shader = TestShader::of(&code);
        let module = &shader.module;
        let is_mod = |op: &OpId| matches!(module.op(*op).kind, OpKind::Builtin(BuiltinId::Mod, _));
        let value = (0..module.ops.len() as u32).map(OpId).find(is_mod).unwrap();
        let found = match angle_uses(shader.query(), value) {
            Some(uses) => {
                let uses = uses
                    .iter()
                    .map(|u| format!("{} {}", u.function.name(), u.factor));
                uses.collect::<Vec<_>>().join(", ")
            }
            None => "other".to_string(),
        };
        assert_eq!(found, expected, "{body}");
    }

    #[test]
    fn uses_of_angles_are_found() {
        for (body, expected) in cases(include_str!("angles.txt")) {
            check(body, expected);
        }
    }
}
