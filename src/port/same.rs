//! Proves that a rewritten pass is equivalent to the original: compares the IR of both, operation
//! by operation, with the names that the rewrite gives to the output and the coordinate.
//!
//! `--verify` runs both and compares pixels, which shows equality only for the samples and needs
//! inputs and time. A rewritten pass is written without a check by the user, so equivalence is
//! proved for all inputs, even for a shader that takes too long to run.

use rustc_hash::FxHashMap;
use shaderlint_ir::{
    Access, Case, Lanes, LoopId, Module, Op, OpId, OpKind, PlaceId, Region, Root, Step, SwitchId,
};
use shaderlint_semantic::{FunctionRef, Program, Value, VariableId};

/// A checked shader and its IR.
pub(super) struct LoweredShader<'a> {
    pub(super) program: &'a Program,
    pub(super) module: &'a Module,
}

/// The code that the rewrite added around the body of `mainImage`.
pub(super) struct Added<'a> {
    /// The output variable, formerly the first parameter.
    pub(super) color: &'a str,
    /// Whether the output is set to zero at the start, like the parameter.
    pub(super) clears: bool,
    /// The local variable that replaces the second parameter; `None` if that is `gl_FragCoord.xy`.
    pub(super) coordinate: Option<&'a str>,
    /// Whether alpha is set to 1.0 at the end.
    pub(super) is_opaque: bool,
}

/// Whether `main` of the rewritten shader is equivalent to `mainImage` of the pass, including
/// everything that it calls or that runs before it.
pub(super) fn is_same(
    pass: &LoweredShader,
    image: FunctionRef,
    made: &LoweredShader,
    added: &Added,
) -> bool {
    let mut pair = ShaderPair {
        a: pass,
        b: made,
        variables: FxHashMap::default(),
        back: FxHashMap::default(),
        ops: FxHashMap::default(),
        functions: FxHashMap::default(),
        queue: Vec::new(),
        coordinate: None,
    };
    pair.entries(image, added).is_some() && pair.globals().is_some() && pair.others().is_some()
}

/// Two shaders that are compared in parallel. `None` results mean a difference.
struct ShaderPair<'a> {
    a: &'a LoweredShader<'a>,
    b: &'a LoweredShader<'a>,
    variables: FxHashMap<VariableId, VariableId>,
    back: FxHashMap<VariableId, VariableId>,
    ops: FxHashMap<OpId, OpId>,
    functions: FxHashMap<FunctionRef, FunctionRef>,
    queue: Vec<(FunctionRef, FunctionRef)>,
    /// The second parameter and `gl_FragCoord`, whose first two components it equals.
    coordinate: Option<(VariableId, VariableId)>,
}

/// An operation, or a control flow step.
#[derive(Clone, Copy)]
enum ComparedItem {
    Op(OpId),
    Step(Step),
}

/// The items of a region, with each operation separately.
fn items(module: &Module, region: Region) -> Vec<ComparedItem> {
    let mut items = Vec::new();
    for step in module.steps(region) {
        match step {
            Step::Run(run) => items.extend(run.ops().map(ComparedItem::Op)),
            other => items.push(ComparedItem::Step(*other)),
        }
    }
    items
}

fn holds(is_so: bool) -> Option<()> {
    is_so.then_some(())
}

impl LoweredShader<'_> {
    /// The name of a variable; `None` for one created by lowering.
    fn name(&self, id: VariableId) -> Option<&str> {
        let variable = self.program.variable(id)?;
        Some(self.program.names.text(variable.name))
    }

    /// The variable with a name and a kind.
    fn named(&self, name: &str, root: Root) -> Option<VariableId> {
        let ids = (0..self.module.variables.len() as u32).map(VariableId);
        let is_it = |id: &VariableId| {
            let own = self.module.variable(*id);
            own.is_some_and(|v| v.root == root) && self.name(*id) == Some(name)
        };
        ids.into_iter().find(is_it)
    }

    /// The variable and path that an item stores to, and the value.
    fn store(&self, item: ComparedItem) -> Option<(VariableId, &[Access], &Op)> {
        let ComparedItem::Op(op) = item else {
            return None;
        };
        let OpKind::Store(place, value) = self.module.op(op).kind else {
            return None;
        };
        let place = self.module.place(place);
        let path = self.module.path(place);
        Some((place.variable, path, self.module.op(value)))
    }

    /// Whether two items store a constant to a component of a variable.
    fn sets(&self, items: &[ComparedItem], to: VariableId, path: &[Access], value: f32) -> bool {
        let [ComparedItem::Op(_), store] = items else {
            return false;
        };
        let Some((variable, own_path, op)) = self.store(*store) else {
            return false;
        };
        let OpKind::Const(constant) = op.kind else {
            return false;
        };
        let values = self.module.pool.values(constant);
        let is_value = |v: &Value| matches!(v, Value::Float(f) if f.to_bits() == value.to_bits());
        variable == to && own_path == path && values.iter().all(is_value)
    }
}

impl ShaderPair<'_> {
    /// Compares the entry functions, without the code that the rewrite added.
    fn entries(&mut self, image: FunctionRef, added: &Added) -> Option<()> {
        let of = self.a.module.function(image)?;
        let &[color, place] = self.a.module.parameters(of) else {
            return None;
        };
        let main = self.b.module.function(self.b.module.entry?)?;
        let output = self.b.named(added.color, Root::Output)?;
        self.take(color, output)?;
        let mut theirs = &items(self.b.module, main.body?)[..];
        if added.clears {
            let (start, rest) = theirs.split_at_checked(2)?;
            holds(self.b.sets(start, output, &[], 0.0))?;
            theirs = rest;
        }
        // The variable exists only in a shader that mentions it.
        let fragment = self.b.named("gl_FragCoord", Root::Input);
        match added.coordinate {
            None => self.coordinate = fragment.map(|f| (place, f)),
            Some(name) => {
                let (start, rest) = theirs.split_at_checked(2)?;
                let local = self.copied_coordinate(start, fragment?)?;
                holds(self.b.name(local) == Some(name))?;
                self.take(place, local)?;
                theirs = rest;
            }
        }
        if added.is_opaque {
            let (rest, end) = theirs.split_at_checked(theirs.len().checked_sub(2)?)?;
            let alpha = Access::Lanes(Lanes::new([3]));
            holds(self.b.sets(end, output, &[alpha], 1.0))?;
            theirs = rest;
        }
        let ours = items(self.a.module, of.body?);
        self.items(&ours, theirs)?;
        // The browser rejects outputs with computed indices.
        let mut places = self.b.module.places.iter().filter(|p| p.variable == output);
        holds(places.all(|p| {
            let mut path = self.b.module.path(p).iter();
            !path.any(|step| matches!(step, Access::Computed(_)))
        }))
    }

    /// The variable that two items set to `gl_FragCoord.xy`.
    fn copied_coordinate(
        &self,
        items: &[ComparedItem],
        fragment: VariableId,
    ) -> Option<VariableId> {
        let (variable, path, op) = self.b.store(*items.last()?)?;
        let OpKind::Load(place) = op.kind else {
            return None;
        };
        let place = self.b.module.place(place);
        let lanes = [Access::Lanes(Lanes::new([0, 1]))];
        let is_copy = place.variable == fragment && self.b.module.path(place) == lanes;
        (is_copy && path.is_empty()).then_some(variable)
    }

    /// Compares the initial values of globals, except those of outputs.
    fn globals(&mut self) -> Option<()> {
        let own = |side: &LoweredShader| {
            let all = items(side.module, side.module.globals);
            let is_output = |item: &ComparedItem| {
                let root = side.store(*item).and_then(|s| side.module.variable(s.0));
                root.is_some_and(|v| v.root == Root::Output)
            };
            let mut kept: Vec<ComparedItem> = Vec::new();
            for item in all {
                match is_output(&item) {
                    // Its initial value is removed with it.
                    true => drop(kept.pop()),
                    false => kept.push(item),
                }
            }
            kept
        };
        let (ours, theirs) = (own(self.a), own(self.b));
        self.items(&ours, &theirs)
    }

    /// Compares the functions that are called.
    fn others(&mut self) -> Option<()> {
        while let Some((a, b)) = self.queue.pop() {
            let (ours, theirs) = (self.a.module.function(a)?, self.b.module.function(b)?);
            let name = |side: &LoweredShader, id| {
                let function = side.program.function(id);
                function.map(|f| side.program.names.text(f.name).to_string())
            };
            holds(name(self.a, a) == name(self.b, b))?;
            let parameters = self.a.module.parameters(ours);
            let others = self.b.module.parameters(theirs);
            holds(parameters.len() == others.len())?;
            for (&a, &b) in parameters.iter().zip(others) {
                self.variable(a, b)?;
            }
            match (ours.body, theirs.body) {
                (Some(a), Some(b)) => self.region(a, b)?,
                (None, None) => {}
                _ => return None,
            }
        }
        Some(())
    }

    fn region(&mut self, a: Region, b: Region) -> Option<()> {
        let (ours, theirs) = (items(self.a.module, a), items(self.b.module, b));
        self.items(&ours, &theirs)
    }

    fn items(&mut self, ours: &[ComparedItem], theirs: &[ComparedItem]) -> Option<()> {
        holds(ours.len() == theirs.len())?;
        for pair in ours.iter().zip(theirs) {
            match pair {
                (ComparedItem::Op(a), ComparedItem::Op(b)) => {
                    self.op(*a, *b)?;
                    self.ops.insert(*a, *b);
                }
                (ComparedItem::Step(a), ComparedItem::Step(b)) => self.step(a, b)?,
                _ => return None,
            }
        }
        Some(())
    }

    fn step(&mut self, a: &Step, b: &Step) -> Option<()> {
        match (*a, *b) {
            (
                Step::If {
                    condition,
                    then,
                    otherwise,
                    ..
                },
                Step::If {
                    condition: condition_b,
                    then: then_b,
                    otherwise: otherwise_b,
                    ..
                },
            ) => {
                self.value(condition, condition_b)?;
                self.region(then, then_b)?;
                self.region(otherwise, otherwise_b)
            }
            (Step::Loop(a), Step::Loop(b)) => self.looped(a, b),
            (Step::Switch(a), Step::Switch(b)) => self.switch(a, b),
            (Step::Return(Some(a), _), Step::Return(Some(b), _)) => self.value(a, b),
            (Step::Return(None, _), Step::Return(None, _))
            | (Step::Break(_), Step::Break(_))
            | (Step::Continue(_), Step::Continue(_))
            | (Step::Discard(_), Step::Discard(_)) => Some(()),
            _ => None,
        }
    }

    fn looped(&mut self, a: LoopId, b: LoopId) -> Option<()> {
        let (a, b) = (*self.a.module.looped(a)?, *self.b.module.looped(b)?);
        holds(a.tests_first == b.tests_first && a.condition.is_some() == b.condition.is_some())?;
        // Only a loop that tests first has its test before the body.
        if a.tests_first {
            self.region(a.test, b.test)?;
        }
        self.region(a.body, b.body)?;
        if !a.tests_first {
            self.region(a.test, b.test)?;
        }
        if let (Some(a), Some(b)) = (a.condition, b.condition) {
            self.value(a, b)?;
        }
        self.region(a.step, b.step)
    }

    fn switch(&mut self, a: SwitchId, b: SwitchId) -> Option<()> {
        let (a, b) = (*self.a.module.switch(a)?, *self.b.module.switch(b)?);
        self.value(a.selector, b.selector)?;
        let (ours, theirs) = (self.a.module, self.b.module);
        let (cases, others): (&[Case], &[Case]) = (ours.cases(&a), theirs.cases(&b));
        holds(cases.len() == others.len())?;
        for (a, b) in cases.iter().zip(others) {
            holds(ours.labels(a) == theirs.labels(b))?;
            self.region(a.body, b.body)?;
        }
        Some(())
    }

    /// Whether two values come from operations that were found to be equal.
    fn value(&self, a: OpId, b: OpId) -> Option<()> {
        holds(self.ops.get(&a) == Some(&b))
    }

    fn values(&self, a: &[OpId], b: &[OpId]) -> Option<()> {
        holds(a.len() == b.len())?;
        a.iter().zip(b).try_for_each(|(a, b)| self.value(*a, *b))
    }

    fn op(&mut self, a: OpId, b: OpId) -> Option<()> {
        let (ours, theirs) = (*self.a.module.op(a), *self.b.module.op(b));
        let (own, other) = (self.a, self.b);
        holds(ours.precision == theirs.precision)?;
        holds(own.program.type_name(ours.ty) == other.program.type_name(theirs.ty))?;
        let lists = |a, b| (own.module.operands(a), other.module.operands(b));
        match (ours.kind, theirs.kind) {
            (OpKind::Const(a), OpKind::Const(b)) => {
                let bits = |values: &[Value]| values.iter().map(bits_of).collect::<Vec<_>>();
                holds(bits(own.module.pool.values(a)) == bits(other.module.pool.values(b)))
            }
            (OpKind::Undef, OpKind::Undef) => Some(()),
            (OpKind::Load(a), OpKind::Load(b)) => self.place(a, b),
            (OpKind::Store(a, value), OpKind::Store(b, value_b)) => {
                self.value(value, value_b)?;
                self.place(a, b)
            }
            (OpKind::Builtin(kind, a), OpKind::Builtin(kind_b, b)) => {
                let (a, b) = lists(a, b);
                holds(kind == kind_b)?;
                self.values(a, b)
            }
            (OpKind::Call(callee, a), OpKind::Call(callee_b, b)) => {
                let (a, b) = lists(a, b);
                self.function(callee, callee_b)?;
                self.values(a, b)
            }
            (OpKind::Compose(a), OpKind::Compose(b)) => {
                let (a, b) = lists(a, b);
                self.values(a, b)
            }
            (kind, kind_b) => {
                holds(shape(kind) == shape(kind_b) && shape(kind).is_some())?;
                let mut operands = Vec::new();
                own.module.each_operand(a, |op| operands.push(op));
                let mut others = Vec::new();
                other.module.each_operand(b, |op| others.push(op));
                self.values(&operands, &others)
            }
        }
    }

    fn function(&mut self, a: FunctionRef, b: FunctionRef) -> Option<()> {
        match self.functions.get(&a) {
            Some(known) => holds(*known == b),
            None => {
                self.functions.insert(a, b);
                self.queue.push((a, b));
                Some(())
            }
        }
    }

    fn place(&mut self, a: PlaceId, b: PlaceId) -> Option<()> {
        let (own, other) = (self.a.module, self.b.module);
        let (ours, theirs) = (own.place(a), other.place(b));
        let (path, path_b) = (own.path(ours), other.path(theirs));
        if let Some((coordinate, fragment)) = self.coordinate
            && ours.variable == coordinate
        {
            let both = [Access::Lanes(Lanes::new([0, 1]))];
            let lanes = if path.is_empty() { &both } else { path };
            let is_known = matches!(lanes, [Access::Lanes(_)]);
            return holds(is_known && theirs.variable == fragment && path_b == lanes);
        }
        self.variable(ours.variable, theirs.variable)?;
        holds(path.len() == path_b.len())?;
        for step in path.iter().zip(path_b) {
            match step {
                (Access::Computed(a), Access::Computed(b)) => self.value(*a, *b)?,
                (a, b) => holds(a == b)?,
            }
        }
        Some(())
    }

    /// Whether two variables correspond; decided at their first occurrence by name and kind.
    fn variable(&mut self, a: VariableId, b: VariableId) -> Option<()> {
        if self.variables.contains_key(&a) || self.back.contains_key(&b) {
            return holds(self.variables.get(&a) == Some(&b) && self.back.get(&b) == Some(&a));
        }
        let (ours, theirs) = (self.a.module.variable(a)?, self.b.module.variable(b)?);
        holds(self.a.name(a) == self.b.name(b) && ours.root == theirs.root)?;
        self.take(a, b)
    }

    /// Records that two variables of the same type correspond.
    fn take(&mut self, a: VariableId, b: VariableId) -> Option<()> {
        let (ours, theirs) = (self.a.module.variable(a)?, self.b.module.variable(b)?);
        let name = |side: &LoweredShader, ty| side.program.type_name(ty);
        holds(name(self.a, ours.ty) == name(self.b, theirs.ty))?;
        holds(ours.precision == theirs.precision && ours.is_flat == theirs.is_flat)?;
        self.variables.insert(a, b);
        self.back.insert(b, a);
        Some(())
    }
}

/// The kind of an operation without its operands; `None` for kinds that are compared separately.
fn shape(kind: OpKind) -> Option<OpKind> {
    const NONE: OpId = OpId(0);
    Some(match kind {
        OpKind::Unary(operator, _) => OpKind::Unary(operator, NONE),
        OpKind::Binary(operator, ..) => OpKind::Binary(operator, NONE, NONE),
        OpKind::MatrixProduct(..) => OpKind::MatrixProduct(NONE, NONE),
        OpKind::Same { negated, .. } => OpKind::Same {
            negated,
            left: NONE,
            right: NONE,
        },
        OpKind::Select { .. } => OpKind::Select {
            condition: NONE,
            then: NONE,
            otherwise: NONE,
        },
        OpKind::Convert(_) => OpKind::Convert(NONE),
        OpKind::Splat(_) => OpKind::Splat(NONE),
        OpKind::Swizzle(_, lanes) => OpKind::Swizzle(NONE, lanes),
        OpKind::Extract(_, number) => OpKind::Extract(NONE, number),
        OpKind::ExtractComputed { .. } => OpKind::ExtractComputed {
            base: NONE,
            index: NONE,
        },
        OpKind::Returned(_, number) => OpKind::Returned(NONE, number),
        OpKind::Const(_)
        | OpKind::Undef
        | OpKind::Unknown
        | OpKind::Load(_)
        | OpKind::Store(..)
        | OpKind::Compose(_)
        | OpKind::Builtin(..)
        | OpKind::Call(..) => return None,
    })
}

/// The bits of a value, which also distinguish 0.0 from -0.0 and different NaNs.
fn bits_of(value: &Value) -> (u8, u32) {
    match *value {
        Value::Bool(v) => (0, u32::from(v)),
        Value::Int(v) => (1, v as u32),
        Value::Uint(v) => (2, v),
        Value::Float(v) => (3, v.to_bits()),
    }
}

#[cfg(test)]
mod tests {
    use crate::{Project, rewrite};

    /// The rewritten Image pass, or the reason why it was not rewritten.
    fn rewritten(code: &str) -> Result<String, String> {
        let mut project = Project::draft("", code, None).unwrap();
        let composed = project.resolve("").unwrap();
        rewrite(&project, &composed, &composed.units[0]).map_err(|e| e.message)
    }

    #[track_caller]
    fn kept(body: &str, reason: &str) {
        let code = format!("{body}\n");
        assert_eq!(rewritten(&code).unwrap_err(), reason, "{code}");
    }

    const HEAD: &str = "void mainImage(out vec4 c, in vec2 p) {";

    #[test]
    fn what_does_the_same_is_written() {
        for code in [
            "c = vec4(p, 0, 1);",
            "if (p.x > 9.0) c = vec4(p.y);",
            "p /= 2.0; c = vec4(p[int(p.x)]);",
            "for (int i = 0; i < 9; ++i) { if (i == 7) continue; c += p.xyxy; }",
            "switch (int(p.x)) { case 1: c = vec4(1); break; default: c.x = 0.5; }",
            "do { c.x += 1.0; } while (c.x < p.y); { vec4 c = vec4(2); c.x = 1.0; }",
            "vec2 gl = gl_FragCoord.xy; c = vec4(gl, p.yx);",
        ] {
            let text = rewritten(&format!("{HEAD} {code} }}")).unwrap();
            assert!(text.contains("void main()"), "{text}");
        }
        let struct_of_a_type = "struct S { float x; } f() { return S(0.5); }\n";
        assert!(rewritten(&format!("{struct_of_a_type}{HEAD} c = vec4(f().x); }}")).is_ok());
    }

    #[test]
    fn what_might_not_do_the_same_is_kept() {
        kept(
            &format!("{HEAD} for (int i = 0; i < 4; i++) c[i] = p.x; }}"),
            "the rewritten shader does not compile: a fragment output must be indexed with a constant",
        );
        kept(
            &format!("#define a 0.5\n{HEAD} c = vec4(a); }}"),
            "`a` is a macro",
        );
        kept(
            &format!("#define xy yx\n{HEAD} c = p.xyxy; }}"),
            "`xy` is a macro",
        );
        kept(
            &format!("{HEAD} c = vec4(1);\n#define c d\nvec4 d; d.x = 1.0; }}"),
            "`c` is a macro",
        );
        kept(
            &format!("{HEAD} c = vec4(__LINE__); }}"),
            "`__LINE__` would change",
        );
        kept(
            &format!("float c;\n{HEAD} c = vec4(1); }}"),
            "`c` is already a global variable",
        );
        kept(
            &format!("{HEAD} c = vec4(p[int(iTime)]); }}"),
            "equivalence could not be proved",
        );
    }
}
