//! Uniformity analysis: which values differ between pixels, and where control flow diverges.
//!
//! Derivatives are computed between neighbouring pixels, which must all execute the call (GLSL ES
//! 3.00 sections 8.8 and 8.9). This analysis finds non-uniform control flow: code that only some of
//! the pixels may execute. Divergence propagates along a dependence graph of values, variables and
//! controls, which one walk over the module builds. The graph is flow-insensitive: the order of
//! assignments is ignored, so that the result is conservative (it may contain false positives, but
//! no false negatives).

use rustc_hash::FxHashMap;
use shaderlint_ir::{
    Loop, LoopId, Module, OpId, OpKind, PlaceId, Provenance, Region, Root, Run, Switch, Visit,
    Visited,
};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::SetAt;

/// Index of a [`Control`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ControlId(pub u32);

/// Index of a [`Divergence`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct DivergenceId(pub u32);

/// A maximal piece of code that is executed by one set of pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Control {
    /// The enclosing control; `None` for the body of a function.
    pub outer: Option<ControlId>,
    /// What makes its pixels diverge from those of the enclosing control.
    pub divergence: Option<DivergenceId>,
    /// The function that contains it; `None` at global scope.
    pub function: Option<FunctionRef>,
    /// The innermost loop around it.
    pub looped: Option<LoopId>,
}

/// A point of divergence: a condition, or an early exit that only some pixels take.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Divergence {
    /// The `break`, `continue` or `return` of an early exit.
    pub left_at: Option<StmtId>,
}

/// Something that may differ between pixels.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Varying {
    /// The result of an operation.
    Value(OpId),
    /// The contents of a variable.
    Variable(VariableId),
    /// The return value of a function.
    Returned(FunctionRef),
    /// Whether a piece of code is executed.
    Control(ControlId),
    /// Whether pixels that reach this point together diverge there.
    Divergence(DivergenceId),
}

/// The non-uniform values and control flow of a shader.
#[derive(Default, Debug)]
pub struct Uniformity {
    first: Firsts,
    /// By node: the node that made it non-uniform; the node itself for a source.
    from: Vec<Option<u32>>,
    controls: Vec<Control>,
    divergences: Vec<Divergence>,
    /// By operation.
    control_of: Vec<ControlId>,
    loops: Vec<LoopControls>,
}

/// The controls inside and around a loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LoopControls {
    /// The control of one iteration.
    pub inside: ControlId,
    /// The control of the code around the loop.
    pub outside: ControlId,
}

/// Node numbering: operations, variables, functions, then controls and partings interleaved. This
/// holds the first number of each group.
#[derive(Clone, Copy, Default, Debug)]
struct Firsts {
    variable: u32,
    function: u32,
    control: u32,
}

/// How many levels of controls are followed outwards from a write to the declaration; beyond that
/// any divergence counts.
const MAX_OUTWARDS: usize = 32;

impl Uniformity {
    /// Propagates non-uniformity from the inputs that differ between pixels.
    pub fn of(module: &Module) -> Uniformity {
        Uniformity::spread(module, |_| sources(module).map(Varying::Variable).collect())
    }

    /// Propagates dependence on any sources instead of the pixel: `sources` returns them and
    /// receives the controls of the shader. In the result, "varies" means "may depend on a source".
    pub fn spread(
        module: &Module,
        sources: impl FnOnce(&Uniformity) -> Vec<Varying>,
    ) -> Uniformity {
        let first = Firsts {
            variable: module.ops.len() as u32,
            function: (module.ops.len() + module.variables.len()) as u32,
            control: (module.ops.len() + module.variables.len() + module.functions.len()) as u32,
        };
        let mut walk = UniformityWalk::new(module, first);
        walk.all();
        let UniformityWalk {
            edges,
            controls,
            divergences,
            control_of,
            loops,
            ..
        } = walk;
        let nodes = first.control as usize + 2 * controls.len().max(divergences.len());
        let spread = Lists::of(nodes, edges.iter().copied());
        let mut uniformity = Uniformity {
            first,
            from: vec![None; nodes],
            controls,
            divergences,
            control_of,
            loops,
        };
        // Breadth-first, so that the paths back to a source are shortest.
        let mut todo: Vec<u32> = Vec::new();
        for source in sources(&uniformity) {
            let node = uniformity.node(source);
            uniformity.mark(node, node, &mut todo);
        }
        let mut done = 0;
        while let Some(&node) = todo.get(done) {
            done += 1;
            for &next in spread.get(node) {
                uniformity.mark(next, node, &mut todo);
            }
        }
        uniformity
    }

    /// Whether something may differ between pixels.
    pub fn varies(&self, what: Varying) -> bool {
        self.origin_of(self.node(what)).is_some()
    }

    /// Whether an operation may be executed by only some of the pixels.
    pub fn is_divergent(&self, op: OpId) -> bool {
        let control = self.control_of(op);
        control.is_some_and(|c| self.varies(Varying::Control(c)))
    }

    /// The control that contains an operation.
    pub fn control_of(&self, op: OpId) -> Option<ControlId> {
        self.control_of.get(op.0 as usize).copied()
    }

    /// A control; `None` if the id belongs to another shader.
    pub fn control(&self, id: ControlId) -> Option<&Control> {
        self.controls.get(id.0 as usize)
    }

    /// A point of divergence; `None` if the id belongs to another shader.
    pub fn divergence(&self, id: DivergenceId) -> Option<&Divergence> {
        self.divergences.get(id.0 as usize)
    }

    /// The controls inside and around a loop.
    pub fn loop_controls(&self, id: LoopId) -> Option<&LoopControls> {
        self.loops.get(id.0 as usize)
    }

    /// Why something is non-uniform: the node itself, followed by its causes, down to a source.
    pub fn why(&self, what: Varying) -> impl Iterator<Item = Varying> {
        let first = Some(self.node(what)).filter(|n| self.origin_of(*n).is_some());
        let way = std::iter::successors(first, |n| self.origin_of(*n).filter(|f| f != n));
        way.map(|n| self.varying(n))
    }

    fn origin_of(&self, node: u32) -> Option<u32> {
        self.from.get(node as usize).copied().flatten()
    }

    fn mark(&mut self, node: u32, from: u32, todo: &mut Vec<u32>) {
        if let Some(slot @ None) = self.from.get_mut(node as usize) {
            *slot = Some(from);
            todo.push(node);
        }
    }

    fn node(&self, what: Varying) -> u32 {
        self.first.node(what)
    }

    fn varying(&self, node: u32) -> Varying {
        let first = self.first;
        if node >= first.control {
            let number = (node - first.control) / 2;
            match (node - first.control) % 2 {
                0 => Varying::Control(ControlId(number)),
                _ => Varying::Divergence(DivergenceId(number)),
            }
        } else if node >= first.function {
            Varying::Returned(FunctionRef(node - first.function))
        } else if node >= first.variable {
            Varying::Variable(VariableId(node - first.variable))
        } else {
            Varying::Value(OpId(node))
        }
    }
}

impl Firsts {
    fn node(self, what: Varying) -> u32 {
        match what {
            Varying::Value(op) => op.0,
            Varying::Variable(v) => self.variable + v.0,
            Varying::Returned(f) => self.function + f.0,
            Varying::Control(c) => self.control + 2 * c.0,
            Varying::Divergence(p) => self.control + 2 * p.0 + 1,
        }
    }
}

/// The sources of non-uniformity: interpolated inputs, and the parameters of the entry point.
fn sources(module: &Module) -> impl Iterator<Item = VariableId> {
    let numbered = module.variables.iter().zip(0..);
    let found = numbered.filter(|(v, _)| match v.root {
        Root::Input => !v.is_flat,
        Root::Parameter => v.function.is_some() && v.function == module.entry,
        _ => false,
    });
    found.map(|(_, i)| VariableId(i))
}

/// The early exits of a region, by kind: each is the divergence between the pixels that leave and
/// the others.
#[derive(Clone, Copy, Default)]
struct Leaves {
    returns: Option<DivergenceId>,
    breaks: Option<DivergenceId>,
    continues: Option<DivergenceId>,
}

/// The walk that builds the dependence graph.
struct UniformityWalk<'m> {
    module: &'m Module,
    first: Firsts,
    /// Dependences: if the first node is non-uniform, so is the second.
    edges: Vec<(u32, u32)>,
    controls: Vec<Control>,
    /// The control of the code being walked.
    control: ControlId,
    divergences: Vec<Divergence>,
    control_of: Vec<ControlId>,
    loops: Vec<LoopControls>,
    /// By function: the control of its body.
    bodies: Vec<ControlId>,
    /// The control that declares a local: a write there is executed by all pixels that have the
    /// variable.
    declared_in: FxHashMap<VariableId, ControlId>,
}

impl Visited for Leaves {
    const GO: Leaves = Leaves {
        returns: None,
        breaks: None,
        continues: None,
    };

    fn stops(&self) -> bool {
        false
    }
}

impl<'m> Visit<'m> for UniformityWalk<'m> {
    type Out = Leaves;

    fn module(&self) -> &'m Module {
        self.module
    }

    fn region(&mut self, region: Region) -> Leaves {
        let outer = self.control;
        let mut leaves = Leaves::default();
        // The divergence between the pixels still here and those that entered the region.
        let mut since: Option<DivergenceId> = None;
        for step in self.module.steps(region) {
            let left = self.step(step);
            let left = match since {
                Some(_) => self.all_through(left, since),
                None => left,
            };
            let mut way = left.returns;
            self.join(&mut way, left.breaks);
            self.join(&mut way, left.continues);
            if way.is_some() {
                // Code after an early exit is executed by the pixels that did not leave.
                self.control = self.add_control(Some(self.control), way);
                since = way;
            }
            self.join_all(&mut leaves, left);
        }
        self.control = outer;
        leaves
    }

    fn run(&mut self, run: Run) -> Leaves {
        for op in run.ops() {
            self.control_of.set_at(op.0 as usize, self.control);
            self.op(op);
        }
        Leaves::default()
    }

    fn op(&mut self, id: OpId) -> Leaves {
        let module = self.module;
        let value = Varying::Value(id);
        match module.op(id).kind {
            OpKind::Store(place, written) => self.store(id, place, written),
            OpKind::Call(callee, operands) => {
                let params = module
                    .function(callee)
                    .map_or(&[][..], |f| module.parameters(f));
                for (&operand, &param) in module.operands(operands).iter().zip(params) {
                    self.edge(Varying::Value(operand), Varying::Variable(param));
                }
                self.edge(Varying::Returned(callee), value);
                if let Some(&body) = self.bodies.get(callee.0 as usize) {
                    self.edge(Varying::Control(self.control), Varying::Control(body));
                }
            }
            OpKind::Returned(call, number) => match module.op(call).kind {
                OpKind::Call(callee, _) => {
                    let params = module.function(callee).map(|f| module.parameters(f));
                    let param = params.and_then(|p| p.get(number as usize));
                    if let Some(&param) = param {
                        self.edge(Varying::Variable(param), value);
                    }
                }
                _ => self.edge(Varying::Value(call), value),
            },
            kind => {
                if let OpKind::Load(place) = kind {
                    let variable = Varying::Variable(module.place(place).variable);
                    self.edge(variable, value);
                }
                module.each_operand(id, |operand| {
                    if !matches!(module.op(operand).kind, OpKind::Const(_)) {
                        self.edge(Varying::Value(operand), value);
                    }
                });
            }
        }
        Leaves::default()
    }

    fn branch(&mut self, condition: OpId, sides: [Region; 2], _: Provenance) -> Leaves {
        let mut leaves = Leaves::default();
        for side in sides {
            let left = self.side(condition, side);
            self.join_all(&mut leaves, left);
        }
        leaves
    }

    /// Pixels that exit a loop diverge from those that stay in it, and reconverge after it.
    fn looped(&mut self, id: LoopId, looped: &'m Loop) -> Leaves {
        let control = self.control;
        let divergence = self.add_divergence(None, looped.condition.map(Varying::Value));
        let inside = self.add_control(Some(control), Some(divergence));
        if let Some(slot) = self.controls.get_mut(inside.0 as usize) {
            slot.looped = Some(id);
        }
        if let Some(slot) = self.loops.get_mut(id.0 as usize) {
            slot.inside = inside;
            slot.outside = control;
        }
        self.within(looped.test, inside);
        let left = self.within(looped.body, inside);
        self.within(looped.step, inside);
        for way in [left.breaks, left.returns].into_iter().flatten() {
            self.edge(Varying::Divergence(way), Varying::Divergence(divergence));
        }
        Leaves {
            returns: self.through(left.returns, Some(divergence)),
            ..Leaves::default()
        }
    }

    fn switch(&mut self, switch: &'m Switch) -> Leaves {
        let mut leaves = Leaves::default();
        for case in self.module.cases(switch) {
            let left = self.side(switch.selector, case.body);
            self.join_all(&mut leaves, left);
        }
        leaves.breaks = None;
        leaves
    }

    fn breaks(&mut self, stmt: StmtId) -> Leaves {
        let breaks = Some(self.add_divergence(Some(stmt), None));
        Leaves {
            breaks,
            ..Leaves::GO
        }
    }

    fn continues(&mut self, stmt: StmtId) -> Leaves {
        let continues = Some(self.add_divergence(Some(stmt), None));
        Leaves {
            continues,
            ..Leaves::GO
        }
    }

    fn returns(&mut self, value: Option<OpId>, stmt: StmtId) -> Leaves {
        let returns = Some(self.add_divergence(Some(stmt), None));
        self.returned(value, self.control);
        Leaves {
            returns,
            ..Leaves::GO
        }
    }
}

impl<'m> UniformityWalk<'m> {
    fn new(module: &'m Module, first: Firsts) -> UniformityWalk<'m> {
        let outside = ControlId(0);
        let loop_controls = LoopControls {
            inside: outside,
            outside,
        };
        let mut walk = UniformityWalk {
            module,
            first,
            edges: Vec::with_capacity(module.ops.len() * 2),
            controls: Vec::new(),
            control: outside,
            divergences: Vec::new(),
            control_of: vec![outside; module.ops.len()],
            loops: vec![loop_controls; module.loops.len()],
            bodies: Vec::new(),
            declared_in: FxHashMap::default(),
        };
        // Global initialisers are executed by all pixels.
        walk.add_control(None, None);
        for (i, function) in module.functions.iter().enumerate() {
            let body = walk.add_control(None, None);
            if let Some(control) = walk.controls.get_mut(body.0 as usize) {
                control.function = Some(FunctionRef(i as u32));
            }
            walk.bodies.push(body);
            let parameters = module.parameters(function).iter();
            walk.declared_in.extend(parameters.map(|p| (*p, body)));
        }
        walk
    }

    fn all(&mut self) {
        self.within(self.module.globals, ControlId(0));
        for (i, function) in self.module.functions.iter().enumerate() {
            if let (Some(body), Some(&control)) = (function.body, self.bodies.get(i)) {
                self.within(body, control);
            }
        }
    }

    fn edge(&mut self, from: Varying, to: Varying) {
        self.edges
            .push((self.first.node(from), self.first.node(to)));
    }

    fn add_divergence(&mut self, left_at: Option<StmtId>, from: Option<Varying>) -> DivergenceId {
        let id = DivergenceId(self.divergences.len() as u32);
        self.divergences.push(Divergence { left_at });
        if let Some(from) = from {
            self.edge(from, Varying::Divergence(id));
        }
        id
    }

    /// Adds code executed by the pixels of `outer`, or only by those that take one side of
    /// `divergence`.
    fn add_control(
        &mut self,
        outer: Option<ControlId>,
        divergence: Option<DivergenceId>,
    ) -> ControlId {
        let id = ControlId(self.controls.len() as u32);
        let around = outer.and_then(|o| self.controls.get(o.0 as usize)).copied();
        self.controls.push(Control {
            outer,
            divergence,
            function: around.and_then(|c| c.function),
            looped: around.and_then(|c| c.looped),
        });
        let outer = outer.map(Varying::Control);
        for from in outer.into_iter().chain(divergence.map(Varying::Divergence)) {
            self.edge(from, Varying::Control(id));
        }
        id
    }

    /// Combines the early exits of two paths.
    fn join(&mut self, known: &mut Option<DivergenceId>, more: Option<DivergenceId>) {
        match (*known, more) {
            (Some(known), Some(more)) => {
                self.edge(Varying::Divergence(more), Varying::Divergence(known));
            }
            (None, more) => *known = more,
            (_, None) => {}
        }
    }

    fn join_all(&mut self, known: &mut Leaves, more: Leaves) {
        self.join(&mut known.returns, more.returns);
        self.join(&mut known.breaks, more.breaks);
        self.join(&mut known.continues, more.continues);
    }

    /// An early exit of code guarded by `divergence`, as an exit of the enclosing code.
    fn through(
        &mut self,
        way: Option<DivergenceId>,
        divergence: Option<DivergenceId>,
    ) -> Option<DivergenceId> {
        let left_at = self.divergences.get(way?.0 as usize)?.left_at;
        let outer = self.add_divergence(left_at, way.map(Varying::Divergence));
        if let Some(divergence) = divergence {
            self.edge(Varying::Divergence(divergence), Varying::Divergence(outer));
        }
        Some(outer)
    }

    fn all_through(&mut self, leaves: Leaves, divergence: Option<DivergenceId>) -> Leaves {
        Leaves {
            returns: self.through(leaves.returns, divergence),
            breaks: self.through(leaves.breaks, divergence),
            continues: self.through(leaves.continues, divergence),
        }
    }

    /// Walks a region that starts in `control`.
    fn within(&mut self, region: Region, control: ControlId) -> Leaves {
        let outer = std::mem::replace(&mut self.control, control);
        let leaves = self.region(region);
        self.control = outer;
        leaves
    }

    /// Walks a region guarded by a condition.
    fn side(&mut self, condition: OpId, side: Region) -> Leaves {
        let divergence = Some(self.add_divergence(None, Some(Varying::Value(condition))));
        let inside = self.add_control(Some(self.control), divergence);
        let left = self.within(side, inside);
        self.all_through(left, divergence)
    }

    fn returned(&mut self, value: Option<OpId>, control: ControlId) {
        let function = self.controls.get(control.0 as usize);
        let (Some(value), Some(function)) = (value, function.and_then(|c| c.function)) else {
            return;
        };
        let returned = Varying::Returned(function);
        self.edge(Varying::Value(value), returned);
        // Divergent returns make the result non-uniform, even if each value is uniform.
        let body = self.bodies.get(function.0 as usize).copied();
        self.diverge_since(body, control, returned);
    }

    /// Adds edges to `what` from every divergence between `from` and `control`. `None` is the start
    /// of the shader.
    fn diverge_since(&mut self, from: Option<ControlId>, control: ControlId, what: Varying) {
        let mut at = control;
        for _ in 0..MAX_OUTWARDS {
            if Some(at) == from {
                return;
            }
            let Some(&Control {
                outer, divergence, ..
            }) = self.controls.get(at.0 as usize)
            else {
                return;
            };
            let Some(outer) = outer else {
                break;
            };
            if let Some(divergence) = divergence {
                self.edge(Varying::Divergence(divergence), what);
            }
            at = outer;
        }
        self.edge(Varying::Control(at), what);
    }

    /// A variable becomes non-uniform by a non-uniform value, a non-uniform index, or a divergent
    /// store.
    fn store(&mut self, id: OpId, place: PlaceId, written: OpId) {
        let control = self.control;
        let module = self.module;
        let variable = module.place(place).variable;
        let is_temporary = module.variable(variable).map(|v| v.root) == Some(Root::Temporary);
        if let Provenance::Declaration(_) = module.provenance(id) {
            self.declared_in.insert(variable, control);
        } else if is_temporary {
            self.declared_in.entry(variable).or_insert(control);
        }
        self.edge(Varying::Value(written), Varying::Variable(variable));
        module.each_index(place, |index| {
            self.edge(Varying::Value(index), Varying::Variable(variable));
        });
        let declared = self.declared_in.get(&variable).copied();
        self.diverge_since(declared, control, Varying::Variable(variable));
    }
}
