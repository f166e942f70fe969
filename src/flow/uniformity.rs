//! What differs from pixel to pixel, and where control flow parts because of it.
//!
//! The GPU takes derivatives between neighbouring pixels, which must run the same code for it
//! (GLSL ES 3.00 sections 8.8 and 8.9). This finds the code that only some of them may run. What
//! differs spreads along a graph of values, variables and controls, made in one walk over the
//! module; the order of assignments does not count, so that it may call too much different, never
//! too little.

use rustc_hash::FxHashMap;
use shaderlint_ir::{
    Loop, LoopId, Module, OpId, OpKind, PlaceId, Provenance, Region, Root, Run, Switch, Visit,
    Visited,
};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::StmtId;

/// Index of a control: code that is run by the same pixels.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ControlId(pub u32);

/// Index of a parting.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct PartingId(pub u32);

/// Code that is run by the same pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Control {
    /// The control around it; `None` for a function's body.
    pub outer: Option<ControlId>,
    /// What parts its pixels from those of the control around it.
    pub parting: Option<PartingId>,
    /// The function.
    pub function: Option<FunctionRef>,
    /// The innermost loop around it.
    pub looped: Option<LoopId>,
}

/// What parts some pixels from others: a condition, or a way out that only some take.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Parting {
    /// The jump with which some leave.
    pub left_at: Option<StmtId>,
}

/// Something that may differ from pixel to pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Varying {
    /// The value of an operation.
    Value(OpId),
    /// What a variable holds.
    Variable(VariableId),
    /// What a function gives back.
    Returned(FunctionRef),
    /// Whether code runs.
    Control(ControlId),
    /// Whether pixels that come here together go on together.
    Parting(PartingId),
}

/// What differs from pixel to pixel.
#[derive(Default, Debug)]
pub struct Uniformity {
    first: Firsts,
    /// By node: what made it differ; itself for a source.
    from: Vec<Option<u32>>,
    controls: Vec<Control>,
    partings: Vec<Parting>,
    /// By operation.
    control_of: Vec<ControlId>,
    /// By loop.
    loops: Vec<Turns>,
}

/// The pixels of a loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Turns {
    /// Its turns.
    pub inside: ControlId,
    /// The code that it stands in.
    pub outside: ControlId,
}

/// Nodes are numbered: operations, variables, functions, then controls and partings in turn. These
/// are the first of each.
#[derive(Clone, Copy, Default, Debug)]
struct Firsts {
    variable: u32,
    function: u32,
    control: u32,
}

/// How far the code around a write is followed to the declaration; behind that, whatever parts the
/// pixels counts.
const MAX_OUTWARDS: usize = 32;

impl Uniformity {
    /// Follows what differs through a shader whose pixels start at its entry.
    pub fn of(module: &Module) -> Uniformity {
        Uniformity::spread(module, |_| sources(module).map(Varying::Variable).collect())
    }

    /// Follows through a shader what hangs on other things than the pixel: those that `sources`
    /// names, which is shown the shader's controls. What may hang on them "varies" in the answers.
    pub fn spread(
        module: &Module,
        sources: impl FnOnce(&Uniformity) -> Vec<Varying>,
    ) -> Uniformity {
        let first = Firsts {
            variable: module.ops.len() as u32,
            function: (module.ops.len() + module.variables.len()) as u32,
            control: (module.ops.len() + module.variables.len() + module.functions.len()) as u32,
        };
        let mut walk = Walk::new(module, first);
        walk.all();
        let Walk {
            edges,
            controls,
            partings,
            control_of,
            loops,
            ..
        } = walk;
        let nodes = first.control as usize + 2 * controls.len().max(partings.len());
        let spread = Lists::of(nodes, edges.iter().copied());
        let mut uniformity = Uniformity {
            first,
            from: vec![None; nodes],
            controls,
            partings,
            control_of,
            loops,
        };
        // First come, first served: the ways back are the shortest.
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

    /// Whether something may differ from pixel to pixel.
    pub fn varies(&self, what: Varying) -> bool {
        self.origin_of(self.node(what)).is_some()
    }

    /// Whether only some pixels may run an operation.
    pub fn is_divergent(&self, op: OpId) -> bool {
        let control = self.control_of(op);
        control.is_some_and(|c| self.varies(Varying::Control(c)))
    }

    /// The code that an operation belongs to.
    pub fn control_of(&self, op: OpId) -> Option<ControlId> {
        self.control_of.get(op.0 as usize).copied()
    }

    /// A control, if the number is this shader's.
    pub fn control(&self, id: ControlId) -> Option<&Control> {
        self.controls.get(id.0 as usize)
    }

    /// A parting, if the number is this shader's.
    pub fn parting(&self, id: PartingId) -> Option<&Parting> {
        self.partings.get(id.0 as usize)
    }

    /// The pixels of a loop.
    pub fn turns(&self, id: LoopId) -> Option<&Turns> {
        self.loops.get(id.0 as usize)
    }

    /// Why something differs: itself, then each time what made it so, down to the source.
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
                _ => Varying::Parting(PartingId(number)),
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
            Varying::Parting(p) => self.control + 2 * p.0 + 1,
        }
    }
}

/// What differs from the start: what is interpolated, and the place that the entry is given.
fn sources(module: &Module) -> impl Iterator<Item = VariableId> {
    let numbered = module.variables.iter().zip(0..);
    let found = numbered.filter(|(v, _)| match v.root {
        Root::Input => !v.is_flat,
        Root::Parameter => v.function.is_some() && v.function == module.entry,
        _ => false,
    });
    found.map(|(_, i)| VariableId(i))
}

/// How pixels leave a region before its end: what parts those that leave from the others that
/// came in.
#[derive(Clone, Copy, Default)]
struct Leaves {
    returns: Option<PartingId>,
    breaks: Option<PartingId>,
    continues: Option<PartingId>,
}

/// The walk that makes the graph.
struct Walk<'m> {
    module: &'m Module,
    first: Firsts,
    /// From a node to one that differs where it does.
    edges: Vec<(u32, u32)>,
    controls: Vec<Control>,
    /// That of what is being walked.
    control: ControlId,
    partings: Vec<Parting>,
    control_of: Vec<ControlId>,
    loops: Vec<Turns>,
    /// By function: the control of its body.
    bodies: Vec<ControlId>,
    /// Where a local is declared: what is written there is the same for all that have it.
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

impl<'m> Visit<'m> for Walk<'m> {
    type Out = Leaves;

    fn module(&self) -> &'m Module {
        self.module
    }

    fn region(&mut self, region: Region) -> Leaves {
        let outer = self.control;
        let mut leaves = Leaves::default();
        // What parts those that are still here from those that came in.
        let mut since: Option<PartingId> = None;
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
                // Behind it are those that did not leave.
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
            if let Some(slot) = self.control_of.get_mut(op.0 as usize) {
                *slot = self.control;
            }
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

    /// Those that leave a loop part from those that stay in it; behind it they meet again.
    fn looped(&mut self, id: LoopId, looped: &'m Loop) -> Leaves {
        let control = self.control;
        let parting = self.add_parting(None, looped.condition.map(Varying::Value));
        let inside = self.add_control(Some(control), Some(parting));
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
            self.edge(Varying::Parting(way), Varying::Parting(parting));
        }
        Leaves {
            returns: self.through(left.returns, Some(parting)),
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
        let breaks = Some(self.add_parting(Some(stmt), None));
        Leaves {
            breaks,
            ..Leaves::GO
        }
    }

    fn continues(&mut self, stmt: StmtId) -> Leaves {
        let continues = Some(self.add_parting(Some(stmt), None));
        Leaves {
            continues,
            ..Leaves::GO
        }
    }

    fn returns(&mut self, value: Option<OpId>, stmt: StmtId) -> Leaves {
        let returns = Some(self.add_parting(Some(stmt), None));
        self.returned(value, self.control);
        Leaves {
            returns,
            ..Leaves::GO
        }
    }
}

impl<'m> Walk<'m> {
    fn new(module: &'m Module, first: Firsts) -> Walk<'m> {
        let outside = ControlId(0);
        let turns = Turns {
            inside: outside,
            outside,
        };
        let mut walk = Walk {
            module,
            first,
            edges: Vec::with_capacity(module.ops.len() * 2),
            controls: Vec::new(),
            control: outside,
            partings: Vec::new(),
            control_of: vec![outside; module.ops.len()],
            loops: vec![turns; module.loops.len()],
            bodies: Vec::new(),
            declared_in: FxHashMap::default(),
        };
        // What runs before the entry is run by all.
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

    fn add_parting(&mut self, left_at: Option<StmtId>, from: Option<Varying>) -> PartingId {
        let id = PartingId(self.partings.len() as u32);
        self.partings.push(Parting { left_at });
        if let Some(from) = from {
            self.edge(from, Varying::Parting(id));
        }
        id
    }

    /// Code in which only those are that are in `outer`, and of them only some where `parting` says.
    fn add_control(&mut self, outer: Option<ControlId>, parting: Option<PartingId>) -> ControlId {
        let id = ControlId(self.controls.len() as u32);
        let around = outer.and_then(|o| self.controls.get(o.0 as usize)).copied();
        self.controls.push(Control {
            outer,
            parting,
            function: around.and_then(|c| c.function),
            looped: around.and_then(|c| c.looped),
        });
        let outer = outer.map(Varying::Control);
        for from in outer.into_iter().chain(parting.map(Varying::Parting)) {
            self.edge(from, Varying::Control(id));
        }
        id
    }

    /// Brings ways out together.
    fn join(&mut self, known: &mut Option<PartingId>, more: Option<PartingId>) {
        match (*known, more) {
            (Some(known), Some(more)) => {
                self.edge(Varying::Parting(more), Varying::Parting(known));
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

    /// A way out of code that `parting` leads into, as one out of the code around it.
    fn through(&mut self, way: Option<PartingId>, parting: Option<PartingId>) -> Option<PartingId> {
        let left_at = self.partings.get(way?.0 as usize)?.left_at;
        let outer = self.add_parting(left_at, way.map(Varying::Parting));
        if let Some(parting) = parting {
            self.edge(Varying::Parting(parting), Varying::Parting(outer));
        }
        Some(outer)
    }

    fn all_through(&mut self, leaves: Leaves, parting: Option<PartingId>) -> Leaves {
        Leaves {
            returns: self.through(leaves.returns, parting),
            breaks: self.through(leaves.breaks, parting),
            continues: self.through(leaves.continues, parting),
        }
    }

    /// Walks a region whose start is run by the pixels of `control`.
    fn within(&mut self, region: Region, control: ControlId) -> Leaves {
        let outer = std::mem::replace(&mut self.control, control);
        let leaves = self.region(region);
        self.control = outer;
        leaves
    }

    /// Code that a value leads into.
    fn side(&mut self, condition: OpId, side: Region) -> Leaves {
        let parting = Some(self.add_parting(None, Some(Varying::Value(condition))));
        let inside = self.add_control(Some(self.control), parting);
        let left = self.within(side, inside);
        self.all_through(left, parting)
    }

    fn returned(&mut self, value: Option<OpId>, control: ControlId) {
        let function = self.controls.get(control.0 as usize);
        let (Some(value), Some(function)) = (value, function.and_then(|c| c.function)) else {
            return;
        };
        let returned = Varying::Returned(function);
        self.edge(Varying::Value(value), returned);
        // Some give back this, others something else.
        let body = self.bodies.get(function.0 as usize).copied();
        self.part_since(body, control, returned);
    }

    /// What is done in `control` differs where its pixels part since they were in `from`; `None`
    /// stands for the start of the shader.
    fn part_since(&mut self, from: Option<ControlId>, control: ControlId, what: Varying) {
        let mut at = control;
        for _ in 0..MAX_OUTWARDS {
            if Some(at) == from {
                return;
            }
            let Some(&Control { outer, parting, .. }) = self.controls.get(at.0 as usize) else {
                return;
            };
            let Some(outer) = outer else {
                break;
            };
            if let Some(parting) = parting {
                self.edge(Varying::Parting(parting), what);
            }
            at = outer;
        }
        self.edge(Varying::Control(at), what);
    }

    /// What differs is written, or to different places, or by some pixels only.
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
        self.part_since(declared, control, Varying::Variable(variable));
    }
}
