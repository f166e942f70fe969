//! Ray marching loops, and what they are for.

use rustc_hash::FxHashSet;
use shaderlint_flow::ranges::Query;
use shaderlint_flow::reaching_definitions::{Def, DefId, ReachingDefinitions};
use shaderlint_flow::{Calls, LoopFacts, Loops, RayLoop, ray_loops};
use shaderlint_ir::{Binary, Module, OpId, OpKind, Root};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{FunctionRef, Program};

/// A loop that follows a ray.
#[derive(Clone, Debug)]
pub struct March {
    /// The loop.
    pub looped: LoopFacts,
    /// How it follows the ray.
    pub ray: RayLoop,
    /// Purpose of the loop.
    pub goal: MarchGoal,
}

/// Purpose of a marching loop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MarchGoal {
    /// Finds the surface that a pixel shows.
    Image,
    /// Tests whether a light is occluded.
    Shadow,
}

impl MarchGoal {
    /// The name in messages, without an article.
    pub const fn name(self) -> &'static str {
        match self {
            MarchGoal::Image => "marching loop",
            MarchGoal::Shadow => "shadow loop",
        }
    }
}

/// The loops that are reachable from the entry function and provably follow a ray.
pub fn marches(
    query: Query,
    (loops, calls): (&Loops, &Calls),
    entry: Option<FunctionRef>,
) -> Vec<March> {
    let Some(entry) = entry else {
        return Vec::new();
    };
    let reached = calls.graph.reached_from(entry);
    let is_reached = |f: FunctionRef| reached.get(f.0 as usize).copied().unwrap_or(false);
    let rays = ray_loops(query, calls).into_iter();
    rays.filter(|ray| is_reached(ray.function))
        .filter_map(|ray| {
            Some(March {
                looped: *loops.get(ray.stmt)?,
                goal: match gives_light(query.module, query.defs, ray.function) {
                    true => MarchGoal::Shadow,
                    false => MarchGoal::Image,
                },
                ray,
            })
        })
        .collect()
}

/// Whether a function returns only the visibility of a light: constants, and the minimum of quotients
/// that a loop computes. Other marching functions return a distance.
fn gives_light(module: &Module, defs: &ReachingDefinitions, function: FunctionRef) -> bool {
    let Some(found) = module.function(function) else {
        return false;
    };
    let mut parameters = module.parameters(found).iter();
    let gives_back = parameters.any(|p| {
        let root = module.variable(*p).map(|v| v.root);
        matches!(root, Some(Root::ParameterOut | Root::ParameterInout))
    });
    let returns = defs.returns_of(function);
    let mut light = Light {
        module,
        defs,
        known: FxHashSet::default(),
        left: MAX_PARTS,
    };
    let is_number = |op: &OpId| module.ty(*op).is_scalar();
    // A single constant is no evidence.
    let is_constant = |op: &OpId| matches!(module.op(*op).kind, OpKind::Const(_));
    let is_scene = returns.len() > 1 || !returns.iter().all(is_constant);
    is_scene && !gives_back && returns.iter().all(|r| is_number(r) && light.value(*r))
}

/// Most operations that are followed from the returned values.
const MAX_PARTS: u32 = 64;

/// A walk from the returned values of a function back to their operands.
struct Light<'a> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    known: FxHashSet<DefId>,
    left: u32,
}

impl Light<'_> {
    fn value(&mut self, op: OpId) -> bool {
        let Some(left) = self.left.checked_sub(1) else {
            return false;
        };
        self.left = left;
        let module = self.module;
        let operands = |list| module.operands(list).iter().copied();
        match module.op(op).kind {
            OpKind::Const(_) => true,
            OpKind::Load(_) => self.def(self.defs.seen(op, 0)),
            OpKind::Builtin(function, list) if matches!(function.transfer(), Transfer::Minimum) => {
                // The minimum of a quotient and the previous result.
                let is_quotient = operands(list).any(|o| self.is_quotient(o));
                operands(list).all(|o| is_quotient && self.is_quotient(o) || self.value(o))
            }
            OpKind::Builtin(_, list) => operands(list).all(|o| self.value(o)),
            OpKind::Unary(_, a) | OpKind::Convert(a) => self.value(a),
            OpKind::Binary(_, a, b) => self.value(a) && self.value(b),
            OpKind::Select {
                then, otherwise, ..
            } => self.value(then) && self.value(otherwise),
            _ => false,
        }
    }

    fn def(&mut self, def: DefId) -> bool {
        let defs = self.defs;
        let def = defs.unrefined(def);
        if !self.known.insert(def) {
            return true;
        }
        match defs.get(def) {
            Def::Stored { value, .. } => self.value(value),
            Def::Merge { sides, .. } => defs.list(sides).iter().all(|side| self.def(*side)),
            Def::Head { init, back, .. } => {
                !self.counts(def, back) && self.def(init) && self.def(back)
            }
            _ => false,
        }
    }

    /// Whether a value that a loop carries around grows by a constant: it counts the steps.
    fn counts(&self, head: DefId, back: DefId) -> bool {
        let (module, defs) = (self.module, self.defs);
        let Def::Stored { value, .. } = defs.get(defs.unrefined(back)) else {
            return false;
        };
        let is_head = |op: OpId| {
            matches!(module.op(op).kind, OpKind::Load(_))
                && defs.unrefined(defs.seen(op, 0)) == head
        };
        let is_constant = |op: OpId| matches!(module.op(op).kind, OpKind::Const(_));
        match module.op(value).kind {
            OpKind::Binary(Binary::Add, a, b) => {
                is_head(a) && is_constant(b) || is_head(b) && is_constant(a)
            }
            _ => false,
        }
    }

    fn is_quotient(&self, op: OpId) -> bool {
        let (module, defs) = (self.module, self.defs);
        let mut at = op;
        for _ in 0..4 {
            at = match module.op(at).kind {
                OpKind::Binary(Binary::Divide, _, by) => {
                    return !matches!(module.op(by).kind, OpKind::Const(_));
                }
                OpKind::Binary(Binary::Multiply, a, b) => match module.op(a).kind {
                    OpKind::Binary(..) => a,
                    _ => b,
                },
                OpKind::Load(_) => match defs.get(defs.unrefined(defs.seen(at, 0))) {
                    Def::Stored { value, .. } => value,
                    _ => return false,
                },
                _ => return false,
            };
        }
        false
    }
}

/// The call path from the entry to a function, if it has more than two functions:
/// `mainImage` -> `render` -> `castRay`.
pub fn way(
    program: &Program,
    calls: &Calls,
    entry: FunctionRef,
    to: FunctionRef,
) -> Option<String> {
    let chain = calls.graph.chain(entry, to)?;
    let names: Vec<String> = chain
        .iter()
        .filter_map(|f| program.function(*f))
        .map(|f| format!("`{}`", program.names.text(f.name)))
        .collect();
    (names.len() > 2).then(|| names.join(" -> "))
}
