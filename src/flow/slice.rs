//! Backward slices: the operations whose values reach given definitions, through arithmetic, calls
//! and variables.

use super::reaching_definitions::{Def, DefId, ReachingDefinitions};
use rustc_hash::FxHashSet;
use shaderlint_ir::{Module, OpId, OpKind};
use shaderlint_semantic::builtins::Transfer;

/// A component still to be visited.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum SlicePoint {
    Lane(OpId, u32),
    Def(DefId),
}

struct Slice<'a> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    todo: Vec<SlicePoint>,
    ops: FxHashSet<OpId>,
}

/// The operations whose values flow into `roots`. Conditions select values and are not part of them;
/// the operands of an operation are followed if `carries` returns `true` for it.
pub fn backward_slice(
    module: &Module,
    defs: &ReachingDefinitions,
    roots: impl IntoIterator<Item = DefId>,
    carries: impl Fn(OpId) -> bool,
) -> FxHashSet<OpId> {
    let mut slice = Slice {
        module,
        defs,
        todo: roots.into_iter().map(SlicePoint::Def).collect(),
        ops: FxHashSet::default(),
    };
    let mut seen = FxHashSet::default();
    while let Some(at) = slice.todo.pop() {
        if !seen.insert(at) {
            continue;
        }
        match at {
            SlicePoint::Def(def) => slice.def(def),
            SlicePoint::Lane(op, lane) => {
                slice.ops.insert(op);
                if carries(op) {
                    slice.operands(op, lane);
                }
            }
        }
    }
    slice.ops
}

impl Slice<'_> {
    fn operands(&mut self, op: OpId, lane: u32) {
        let (module, defs) = (self.module, self.defs);
        if let Some((part, lane)) = defs.part_of(module, op, lane) {
            return self.todo.push(SlicePoint::Lane(part, lane));
        }
        match module.op(op).kind {
            OpKind::Load(_) => self.todo.push(SlicePoint::Def(defs.seen(op, lane))),
            OpKind::Select {
                then, otherwise, ..
            } => self
                .todo
                .extend([then, otherwise].map(|side| SlicePoint::Lane(side, lane))),
            OpKind::Call(function, _) => {
                let returned = defs.returns_of(function).iter();
                self.todo
                    .extend(returned.map(|value| SlicePoint::Lane(*value, lane)));
            }
            OpKind::Returned(call, number) => {
                if let OpKind::Call(function, _) = module.op(call).kind
                    && let Some(function) = module.function(function)
                    && let Some(id) = module.parameters(function).get(number as usize)
                {
                    let exit = defs.exit(defs.slot(*id, lane));
                    self.todo.extend(exit.map(SlicePoint::Def));
                }
            }
            kind => {
                let keeps_lanes = is_componentwise(kind);
                module.each_operand(op, |operand| {
                    let all = 0..defs.lanes_of(operand);
                    let own = module.operand_lane(operand, lane);
                    let lanes = if keeps_lanes { own..own + 1 } else { all };
                    self.todo
                        .extend(lanes.map(|lane| SlicePoint::Lane(operand, lane)));
                });
            }
        }
    }

    fn def(&mut self, def: DefId) {
        let (module, defs) = (self.module, self.defs);
        match defs.get(defs.unrefined(def)) {
            Def::Stored { value, lane } => self.todo.push(SlicePoint::Lane(value, lane)),
            Def::Merge { sides, .. } | Def::Measured(sides) => {
                let sides = defs.list(sides).iter();
                self.todo.extend(sides.map(|side| SlicePoint::Def(*side)));
            }
            Def::Head { init, back, .. } => {
                self.todo.extend([init, back].map(SlicePoint::Def));
            }
            Def::Entry(slot) => {
                if let Some(passed) = defs.passed(module, slot) {
                    let args = passed.args();
                    self.todo
                        .extend(args.map(|arg| SlicePoint::Lane(arg, passed.lane)));
                }
                let writes = defs.global_writes(slot).iter();
                self.todo.extend(writes.map(|def| SlicePoint::Def(*def)));
            }
            Def::Refined { of, .. } => self.todo.push(SlicePoint::Def(of)),
            Def::Unknown => {}
        }
    }
}

/// Whether a component of the result depends on the same component of the operands only.
fn is_componentwise(kind: OpKind) -> bool {
    match kind {
        OpKind::Unary(..) | OpKind::Binary(..) | OpKind::Convert(_) => true,
        OpKind::Builtin(function, _) => !matches!(
            function.transfer(),
            Transfer::Unknown
                | Transfer::Norm
                | Transfer::Separation
                | Transfer::Product
                | Transfer::Direction
                | Transfer::Reflection
                | Transfer::Texel
                | Transfer::Mixed
                | Transfer::MixedMagnitude
        ),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_shader::TestShader;

    /// Checks which built-in functions flow into the output, `max` excluded.
    #[track_caller]
    fn check(code: &str, expected: &str) {
        let TestShader { module, defs, .. } = TestShader::of(code);
        let entry = module.function(module.entry.unwrap()).unwrap();
        let output = module.parameters(entry)[0];
        let exits = (0..4).filter_map(|lane| defs.exit(defs.slot(output, lane)));
        let name = |op: OpId| match module.op(op).kind {
            OpKind::Builtin(function, _) => Some(function.name()),
            _ => None,
        };
        let ops = backward_slice(&module, &defs, exits, |op| name(op) != Some("max"));
        let mut names: Vec<&str> = ops.into_iter().filter_map(name).collect();
        names.sort_unstable();
        assert_eq!(names.join(" "), expected, "{code}");
    }

    #[test]
    fn overwritten_and_unused_values_do_not_flow_into_the_output() {
        check(
            "void mainImage(out vec4 o, vec2 p) { float a = tan(p.x); o = vec4(log(p.x)); o = vec4(sqrt(p.y)); }",
            "sqrt",
        );
        check(
            "void mainImage(out vec4 o, vec2 p) { o = vec4(sin(p.x)); o.rgb = vec3(cos(p.x), exp(p.y), max(log(p.y), 0.0)); }",
            "cos exp max sin",
        );
        check(
            "void mainImage(out vec4 o, vec2 p) { vec4 c = vec4(sin(p.x), cos(p.x), 0, 1); o = c.xxwz; }",
            "sin",
        );
    }

    #[test]
    fn values_flow_through_calls_loops_and_globals() {
        check(
            "float g; float f(float x, out float y) { y = log(x); return x > tan(x) ? exp(x) : x; }
             void mainImage(out vec4 o, vec2 p) {
                 g = 1.0; float a, s = 0.0;
                 for (int i = 0; i < 3; i++) { s += sqrt(p.x); }
                 s += f(sin(p.x), a); o = vec4(s, a, g, dot(cos(p), p)); }",
            "cos dot exp log sin sqrt",
        );
    }
}
