//! Evaluates a function symbolically.

use super::nodes::{NodeId, NodeTag, Nodes, PathStep};
use super::version::{ImageEntry, ShaderVersion, SharedGlobal};
use rustc_hash::FxHashMap;
use shaderlint_ir::{Access, Lanes, Module, OpId, OpKind, Place, PlaceId, Precision, Root};
use shaderlint_semantic::{FunctionRef, Scalar, Type, Value, VariableId};

const VEC2: Type = Type::vector(Scalar::Float, 2);
const VEC4: Type = Type::vector(Scalar::Float, 4);

/// Maximum number of operations that are evaluated.
const MAX_OPS: u32 = 2_000_000;

/// Maximum number of nested calls that are inlined.
pub(super) const MAX_INLINED: u32 = 32;

/// A variable of one call; globals belong to call 0.
pub(super) type CallVariable = (u32, VariableId);

/// The values of variables at a position.
pub(super) type VariableValues = FxHashMap<CallVariable, NodeId>;

/// A loop or `switch` around a position.
#[derive(Default)]
pub(super) struct Exits {
    pub is_loop: bool,
    pub breaks: Vec<VariableValues>,
    pub continues: Vec<VariableValues>,
}

/// A call that is evaluated.
#[derive(Default)]
pub(super) struct EvaluatedCall {
    pub number: u32,
    pub function: Option<FunctionRef>,
    pub ops: FxHashMap<OpId, NodeId>,
    /// By call: the values that it returns in its parameters.
    pub returned: FxHashMap<OpId, Vec<NodeId>>,
    pub exits: Vec<Exits>,
    /// Whether it is evaluated at its call.
    pub is_inlined: bool,
    /// The result of a call that is inlined, and its operation.
    pub result: Option<(OpId, NodeId)>,
}

/// A function whose calls are not inlined.
#[derive(Clone)]
pub(super) struct CalledFunction {
    pub signature: String,
    /// Whether calls with equal arguments are equal, and have no side effects.
    pub is_pure: bool,
}

/// The evaluation of one shader. Functions return `None` if there is no answer.
pub(super) struct Evaluation<'n, 'a> {
    pub nodes: &'n mut Nodes,
    pub side: ShaderVersion<'a>,
    pub module: &'a Module,
    /// The functions whose calls are not inlined.
    called: FxHashMap<FunctionRef, CalledFunction>,
    shared: Vec<SharedGlobal<'a>>,
    /// Values of constants.
    constants: VariableValues,
    pub values: VariableValues,
    /// Side effects so far, in the current region.
    pub effects: Vec<NodeId>,
    /// The position in the control flow, on which derivatives depend.
    pub position: NodeId,
    pub loops: u32,
    calls: u32,
    depth: u32,
    left: u32,
}

impl<'n, 'a> Evaluation<'n, 'a> {
    pub fn new(
        nodes: &'n mut Nodes,
        side: ShaderVersion<'a>,
        called: FxHashMap<FunctionRef, CalledFunction>,
    ) -> Evaluation<'n, 'a> {
        nodes.host_structs = side.host_structs();
        let start = nodes.add(NodeTag::Start, Type::VOID, Vec::new());
        Evaluation {
            nodes,
            side,
            module: side.module,
            called,
            shared: side.shared(),
            constants: VariableValues::default(),
            values: VariableValues::default(),
            effects: Vec::new(),
            position: start,
            loops: 0,
            calls: 0,
            depth: 0,
            left: MAX_OPS,
        }
    }

    pub fn node(&mut self, tag: NodeTag, operands: Vec<NodeId>) -> NodeId {
        self.nodes.add(tag, Type::VOID, operands)
    }

    /// Evaluates initial values, and returns those of global variables that may change.
    pub fn globals(&mut self) -> Option<Vec<NodeId>> {
        let mut frame = EvaluatedCall::default();
        let is_alive = self.region(self.module.globals, &mut frame)?;
        if !is_alive || !self.effects.is_empty() {
            return None;
        }
        // Outputs have no initial value.
        let is_global = |id| {
            self.module
                .variable(id)
                .is_some_and(|v| v.root == Root::Global)
        };
        let ids: Vec<VariableId> = self.shared.iter().map(|g| g.id).collect();
        let globals = ids.into_iter().filter(|id| is_global(*id));
        let shared = globals.map(|id| self.whole(0, id)).collect();
        let is_const = |(_, id): &CallVariable| self.side.is_const(*id);
        let all = std::mem::take(&mut self.values);
        self.constants = all.into_iter().filter(|(key, _)| is_const(key)).collect();
        Some(shared)
    }

    /// The current values of the variables that outlive calls.
    fn shared_values(&mut self) -> Vec<NodeId> {
        let keys = self.shared_keys();
        keys.into_iter()
            .map(|(call, id)| self.whole(call, id))
            .collect()
    }

    /// The variables that outlive calls.
    pub fn shared_keys(&self) -> Vec<CallVariable> {
        self.shared.iter().map(|g| (g.call, g.id)).collect()
    }

    /// What a function computes.
    pub fn function(&mut self, id: FunctionRef) -> Option<NodeId> {
        let function = self.module.function(id)?;
        self.values = self.constants.clone();
        self.effects.clear();
        self.position = self.node(NodeTag::Start, Vec::new());
        (self.loops, self.calls, self.depth) = (0, 1, 0);
        let mut frame = EvaluatedCall {
            number: 1,
            function: Some(id),
            ..EvaluatedCall::default()
        };
        // All ways to a position have a value for each of them.
        for (call, id) in self.shared_keys() {
            let value = self.whole(call, id);
            self.values.insert((call, id), value);
        }
        let entry = self.side.entry.filter(|e| e.function == id);
        if let Some(entry) = entry {
            self.enter(entry)?;
        }
        for (number, parameter) in (0..).zip(self.module.parameters(function)) {
            if entry.is_some() {
                break;
            }
            let variable = self.module.variable(*parameter)?;
            let tag = match variable.root {
                Root::ParameterOut => NodeTag::Undef,
                _ => NodeTag::Parameter(number),
            };
            let value = self.nodes.add(tag, variable.ty, Vec::new());
            self.values.insert((1, *parameter), value);
        }
        if self.region(function.body?, &mut frame)? {
            if let Some(entry) = entry.filter(|e| e.is_opaque) {
                let color = self.side.parameter(entry, 0)?;
                let one = self.nodes.constant(&[Value::Float(1.0)], Type::FLOAT);
                let alpha = NodeTag::Insert(vec![PathStep::Lanes(Lanes::new([3]))]);
                let operands = vec![self.whole(1, color), one];
                let value = self.nodes.add(alpha, VEC4, operands);
                self.values.insert((1, color), value);
            }
            self.leave(None, &frame)?;
        }
        let effects = std::mem::take(&mut self.effects);
        Some(self.node(NodeTag::Effects, effects))
    }

    /// Sets the parameters of a function that the other version has as `main`.
    fn enter(&mut self, entry: ImageEntry) -> Option<()> {
        let color = self.side.parameter(entry, 0)?;
        let coordinate = self.side.parameter(entry, 1)?;
        let is_high = |id| {
            let precision = self.module.variable(id).map(|v| v.precision);
            precision == Some(Precision::High)
        };
        if !is_high(color) || !is_high(coordinate) {
            return None;
        }
        if entry.is_cleared {
            let zero = self.nodes.constant(&[Value::Float(0.0); 4], VEC4);
            self.values.insert((1, color), zero);
        }
        let fragment = NodeTag::Entry("gl_FragCoord".to_string());
        let fragment = self.nodes.add(fragment, VEC4, Vec::new());
        let lanes = NodeTag::Swizzle(Lanes::new([0, 1]));
        let place = self.nodes.add(lanes, VEC2, vec![fragment]);
        self.values.insert((1, coordinate), place);
        Some(())
    }

    /// Records what a function returns.
    pub fn leave(&mut self, value: Option<NodeId>, frame: &EvaluatedCall) -> Option<()> {
        let mut results: Vec<NodeId> = value.into_iter().collect();
        results.extend(self.out_values(frame)?);
        results.extend(self.shared_values());
        let effect = self.node(NodeTag::Return, results);
        self.effects.push(effect);
        Some(())
    }

    /// The values of the parameters of a call that are returned.
    fn out_values(&mut self, frame: &EvaluatedCall) -> Option<Vec<NodeId>> {
        let parameters = self
            .module
            .parameters(self.module.function(frame.function?)?);
        let mut values = Vec::new();
        for parameter in parameters {
            let root = self.module.variable(*parameter)?.root;
            if matches!(root, Root::ParameterOut | Root::ParameterInout)
                && !self.is_shared(*parameter)
            {
                values.push(self.whole(frame.number, *parameter));
            }
        }
        Some(values)
    }

    fn is_shared(&self, id: VariableId) -> bool {
        self.shared.iter().any(|g| g.id == id)
    }

    /// The variable of a call, or a global variable.
    pub fn key(&self, id: VariableId, call: u32) -> CallVariable {
        let variable = self.module.variable(id);
        match variable.is_some_and(|v| v.function.is_some()) {
            true => (call, id),
            false => (0, id),
        }
    }

    /// The value of a variable.
    pub fn whole(&mut self, call: u32, id: VariableId) -> NodeId {
        if let Some(value) = self.values.get(&(call, id)) {
            return *value;
        }
        let variable = self.module.variable(id);
        let ty = variable.map_or(Type::ERROR, |v| v.ty);
        let name = self.side.name(id);
        let tag = match variable.is_some_and(|v| v.function.is_some() && !self.is_shared(id)) {
            true => NodeTag::Undef,
            false => NodeTag::Entry(name.to_string()),
        };
        self.nodes.add(tag, ty, Vec::new())
    }

    /// Evaluates an operation.
    pub fn op(&mut self, id: OpId, frame: &mut EvaluatedCall) -> Option<()> {
        self.left = self.left.checked_sub(1)?;
        let op = *self.module.op(id);
        let mut operands = Vec::new();
        let (module, ops) = (self.module, &frame.ops);
        let mut is_known = true;
        module.each_operand(id, |o| match ops.get(&o) {
            Some(value) => operands.push(*value),
            None => is_known = false,
        });
        if !is_known {
            return None;
        }
        let tag = match op.kind {
            OpKind::Unknown => return None,
            OpKind::Load(place) => {
                let value = self.load(place, operands, frame);
                frame.ops.insert(id, value);
                return Some(());
            }
            OpKind::Store(place, value) => {
                let value_of = operands.pop()?;
                return self.store(place, value, value_of, operands, frame);
            }
            OpKind::Const(_) => {
                let value = self.nodes.constant(module.constant(id), op.ty);
                frame.ops.insert(id, value);
                return Some(());
            }
            OpKind::Call(callee, _) => return self.call(id, callee, operands, frame),
            OpKind::Returned(call, position) => {
                let position = position as usize;
                let value = frame.returned.get(&call).and_then(|all| all.get(position));
                let value = *value?;
                frame.ops.insert(id, value);
                return Some(());
            }
            OpKind::Undef => NodeTag::Undef,
            OpKind::Unary(unary, _) => NodeTag::Unary(unary),
            OpKind::Binary(binary, ..) => NodeTag::Binary(binary),
            OpKind::MatrixProduct(..) => NodeTag::MatrixProduct,
            OpKind::Same { negated, .. } => NodeTag::Same(negated),
            OpKind::Select { .. } => NodeTag::Select,
            OpKind::Convert(_) => NodeTag::Convert,
            OpKind::Splat(_) => NodeTag::Splat,
            OpKind::Swizzle(_, lanes) => NodeTag::Swizzle(lanes),
            OpKind::Compose(_) => NodeTag::Compose,
            OpKind::Extract(_, at) => NodeTag::Extract(at),
            // An index may be out of bounds anywhere else.
            OpKind::ExtractComputed { .. } => {
                operands.push(self.position);
                NodeTag::ExtractComputed
            }
            OpKind::Builtin(function, _) => {
                if function.kind().takes_derivatives() {
                    operands.push(self.position);
                }
                NodeTag::Builtin(function)
            }
        };
        let value = self.nodes.add(tag, op.ty, operands);
        frame.ops.insert(id, value);
        Some(())
    }

    fn load(&mut self, place: PlaceId, indices: Vec<NodeId>, frame: &EvaluatedCall) -> NodeId {
        let place = *self.module.place(place);
        let (call, id) = self.key(place.variable, frame.number);
        let mut value = self.whole(call, id);
        let mut indices = indices.into_iter();
        let path = self.module.path(&place);
        for (at, access) in path.iter().enumerate() {
            let ty = self.part_type(&place, at);
            value = match access {
                Access::Member(i) | Access::Element(i) => {
                    self.nodes.add(NodeTag::Extract(*i), ty, vec![value])
                }
                Access::Lanes(lanes) => self.nodes.add(NodeTag::Swizzle(*lanes), ty, vec![value]),
                Access::Computed(_) => {
                    let operands = [value].into_iter().chain(indices.next());
                    let operands = operands.chain([self.position]).collect();
                    self.nodes.add(NodeTag::ExtractComputed, ty, operands)
                }
            };
        }
        value
    }

    /// The type after a step of a path; only that of the last is known.
    fn part_type(&self, place: &Place, at: usize) -> Type {
        match at + 1 == self.module.path(place).len() {
            true => place.ty,
            false => Type::VOID,
        }
    }

    fn store(
        &mut self,
        place: PlaceId,
        op: OpId,
        value: NodeId,
        indices: Vec<NodeId>,
        frame: &EvaluatedCall,
    ) -> Option<()> {
        let place = *self.module.place(place);
        let key = self.key(place.variable, frame.number);
        let value = self.rounded(place.variable, op, value);
        let path = self.module.path(&place);
        let variable = self.module.variable(place.variable)?;
        let value = match path {
            [] => value,
            path => {
                let steps = path.iter().map(|access| match access {
                    Access::Member(i) | Access::Element(i) => PathStep::Part(*i),
                    Access::Lanes(lanes) => PathStep::Lanes(*lanes),
                    Access::Computed(_) => PathStep::Computed,
                });
                let tag = NodeTag::Insert(steps.collect());
                let whole = self.whole(key.0, key.1);
                let operands = [whole, value].into_iter().chain(indices).collect();
                self.nodes.add(tag, variable.ty, operands)
            }
        };
        self.values.insert(key, value);
        Some(())
    }

    /// A value as a variable keeps it.
    fn rounded(&mut self, variable: VariableId, op: OpId, value: NodeId) -> NodeId {
        let kept = self.module.variable(variable).map(|v| v.precision);
        self.lowered(kept.unwrap_or_default(), op, value)
    }

    /// A value with a precision that may be lower than that of its operation.
    fn lowered(&mut self, kept: Precision, op: OpId, value: NodeId) -> NodeId {
        let op = self.module.op(op);
        match kept < op.precision && kept != Precision::None {
            true => self.nodes.add(NodeTag::Rounded(kept), op.ty, vec![value]),
            false => value,
        }
    }

    fn call(
        &mut self,
        id: OpId,
        callee: FunctionRef,
        arguments: Vec<NodeId>,
        frame: &mut EvaluatedCall,
    ) -> Option<()> {
        let Some(CalledFunction { signature, is_pure }) = self.called.get(&callee).cloned() else {
            return self.inlined(id, callee, arguments, frame);
        };
        let ty = self.module.ty(id);
        let mut operands = arguments;
        operands.push(self.position);
        if !is_pure {
            operands.extend(self.shared_values());
        }
        let tag = NodeTag::Call(signature);
        let call = self.nodes.add(tag, ty, operands);
        frame.ops.insert(id, call);
        if is_pure {
            return Some(());
        }
        self.effects.push(call);
        for key in self.shared_keys() {
            let name = self.side.name(key.1).to_string();
            let after = self.node(NodeTag::After(name), vec![call]);
            self.values.insert(key, after);
        }
        let parameters = self.module.parameters(self.module.function(callee)?);
        let returned = (0..).zip(parameters).map(|(number, parameter)| {
            let ty = self
                .module
                .variable(*parameter)
                .map_or(Type::ERROR, |v| v.ty);
            self.nodes.add(NodeTag::Returned(number), ty, vec![call])
        });
        let returned: Vec<NodeId> = returned.collect();
        frame.returned.insert(id, returned);
        Some(())
    }

    /// Whether calls of a function are pure; `None` if they are inlined.
    pub fn is_pure(&self, callee: FunctionRef) -> Option<bool> {
        self.called.get(&callee).map(|f| f.is_pure)
    }

    /// Evaluates the body of a function at its call.
    fn inlined(
        &mut self,
        id: OpId,
        callee: FunctionRef,
        arguments: Vec<NodeId>,
        frame: &mut EvaluatedCall,
    ) -> Option<()> {
        let function = self.module.function(callee)?;
        self.calls += 1;
        self.depth += 1;
        let mut inner = EvaluatedCall {
            number: self.calls,
            function: Some(callee),
            is_inlined: true,
            ..EvaluatedCall::default()
        };
        let parameters = self.module.parameters(function);
        let OpKind::Call(_, list) = self.module.op(id).kind else {
            return None;
        };
        let ops = self.module.operands(list);
        for ((parameter, value), op) in parameters.iter().zip(arguments).zip(ops) {
            let value = self.rounded(*parameter, *op, value);
            self.values.insert((inner.number, *parameter), value);
        }
        if self.depth > MAX_INLINED || !self.region(function.body?, &mut inner)? {
            return None;
        }
        self.depth -= 1;
        let returned = parameters.iter().map(|p| self.whole(inner.number, *p));
        let returned: Vec<NodeId> = returned.collect();
        frame.returned.insert(id, returned);
        let nothing = self.node(NodeTag::Undef, Vec::new());
        let kept = self.module.op(id).precision;
        let result = inner
            .result
            .map(|(op, value)| self.lowered(kept, op, value));
        frame.ops.insert(id, result.unwrap_or(nothing));
        Some(())
    }
}
