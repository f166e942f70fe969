//! The verifier: what makes a module well-formed. Tests and fuzzers check lowering against it; all
//! users of the IR rely on it.

mod op;
mod place;
mod verifier;

pub use verifier::Violation;
use verifier::{StepContext, Verifier};

use crate::form::{
    Case, CaseLabel, Function, Loop, Module, OpId, PlaceId, Provenance, Region, Root, Run, Step,
    Switch,
};
use crate::layout::Layout;
use shaderlint_semantic::{Direction, FunctionRef, Program, Scalar, Stage, Storage, Type};

/// All violations in the module that a program was lowered to; none if lowering is correct.
pub fn verify(program: &Program, module: &Module) -> Vec<Violation> {
    let mut verifier = Verifier {
        program,
        layout: Layout::of(program),
        module,
        builtins: program.builtins(),
        at: StepContext::default(),
        next: 0,
        defined: vec![false; module.ops.len()],
        trail: Vec::new(),
        seen: vec![false; module.steps.len()],
        problems: Vec::new(),
    };
    verifier.tables();
    verifier.places();
    verifier.walk(None, module.globals);
    // They are in source order, which may differ from the order of their ids.
    let mut functions: Vec<_> = (0..).map(FunctionRef).zip(&module.functions).collect();
    // A function without operations starts where the next one does.
    functions.sort_by_key(|(_, function)| (function.ops.first, function.ops.len));
    for (id, function) in functions {
        verifier.function(id, function);
    }
    let ops = module.ops.len() as u32;
    if verifier.next != ops {
        verifier.report(format!(
            "runs contain {} of {ops} operations",
            verifier.next
        ));
    }
    verifier.expressions();
    verifier.problems
}

impl Verifier<'_> {
    /// Verifies the tables indexed by ids of the program.
    fn tables(&mut self) {
        let (program, module) = (self.program, self.module);
        if module.provenances.len() != module.ops.len() {
            self.report("expected one provenance per operation");
        }
        if module.functions.len() != program.functions.len() {
            self.report("the functions differ from those of the program");
        }
        if module.stage != Some(program.stage) {
            self.report("the stage differs from that of the program");
        }
        if module.variables.len() < program.variables.len() {
            self.report("the module has fewer variables than the program");
        }
        for (i, variable) in module.variables.iter().enumerate() {
            let Some(declared) = program.variables.get(i) else {
                if variable.root != Root::Temporary && !variable.root.is_parameter() {
                    let root = variable.root;
                    self.report(format!("variable {i}, made by lowering, is {root:?}"));
                }
                continue;
            };
            if variable.ty != declared.ty {
                let (a, b) = (self.name(variable.ty), self.name(declared.ty));
                self.report(format!("variable {i} has type {a}, declared as {b}"));
            }
            let (is, was) = (variable.root, declared.storage);
            if is != root_of(was) {
                self.report(format!("variable {i} is {is:?}, declared as {was:?}"));
            }
        }
        if let Some(entry) = module.entry
            && module.function(entry).is_none_or(|f| f.body.is_none())
        {
            self.report("the entry has no body");
        }
    }

    fn places(&mut self) {
        for id in (0..self.module.places.len() as u32).map(PlaceId) {
            if let Err(text) = place::check(self.program, self.module, id) {
                self.report(format!("place {}: {text}", id.0));
            }
        }
    }

    fn function(&mut self, id: FunctionRef, function: &Function) {
        self.at.function = Some(id);
        self.parameters(id, function);
        let first = self.next;
        match function.body {
            Some(body) => {
                if function.ops.first.0 != first {
                    self.report(format!("the operations must start with %{first}"));
                }
                self.walk(Some(id), body);
                if function.ops.first.0 + function.ops.len != self.next {
                    self.report(format!("the operations must end before %{}", self.next));
                }
            }
            None if function.ops.len > 0 => self.report("operations without a body"),
            None => {}
        }
        self.at = StepContext::default();
    }

    fn parameters(&mut self, id: FunctionRef, function: &Function) {
        let Some(declared) = self.program.function(id) else {
            return;
        };
        if function.returns != declared.returns {
            self.report("the return type differs from the declaration");
        }
        let parameters = self.module.parameters(function);
        if function.body.is_none() && parameters.is_empty() {
            return;
        }
        if parameters.len() != declared.params.len() {
            self.report("the parameters differ from those of the program");
        }
        for (parameter, declared) in parameters.iter().zip(&declared.params) {
            let root = root_of(Storage::Param(declared.direction));
            let variable = self.module.variable(*parameter);
            let is_right = variable
                .is_some_and(|v| v.ty == declared.ty && v.root == root && v.function == Some(id));
            if !is_right {
                self.report(format!(
                    "parameter {} differs from its declaration",
                    parameter.0
                ));
            }
        }
    }

    /// Verifies the code of a function, or of the global initialisers.
    fn walk(&mut self, function: Option<FunctionRef>, body: Region) {
        self.at = StepContext {
            function,
            ..StepContext::default()
        };
        self.region(body);
        self.undefine(0);
    }

    /// Values defined in a region are visible until its end.
    fn region(&mut self, region: Region) {
        let mark = self.trail.len();
        self.steps(region);
        self.undefine(mark);
    }

    fn undefine(&mut self, mark: usize) {
        for op in self.trail.drain(mark.min(self.trail.len())..) {
            if let Some(slot) = self.defined.get_mut(op.0 as usize) {
                *slot = false;
            }
        }
    }

    fn is_defined(&self, op: OpId) -> bool {
        self.defined.get(op.0 as usize).copied().unwrap_or(false)
    }

    fn steps(&mut self, region: Region) {
        let module = self.module;
        let steps = module.steps(region);
        if steps.len() != region.0.len as usize {
            return self.report("a region exceeds the list of steps");
        }
        for (i, step) in (region.0.start as usize..).zip(steps) {
            match self.seen.get_mut(i) {
                Some(slot) if !*slot => *slot = true,
                _ => return self.report(format!("step {i} is in two regions")),
            }
            self.step(step);
        }
    }

    fn step(&mut self, step: &Step) {
        match *step {
            Step::Run(run) => self.run(run),
            Step::If {
                condition,
                then,
                otherwise,
                ..
            } => {
                self.needs(condition, Type::BOOL, "the condition of an `if`");
                self.region(then);
                self.region(otherwise);
            }
            Step::Loop(id) => match self.module.looped(id) {
                Some(found) => self.looped(found),
                None => self.report(format!("unknown loop {}", id.0)),
            },
            Step::Switch(id) => match self.module.switch(id) {
                Some(found) => self.switch(found),
                None => self.report(format!("unknown switch {}", id.0)),
            },
            Step::Break(_) if self.at.breakable == 0 => {
                self.report("a `break` outside any loop or switch")
            }
            Step::Continue(_) if self.at.loops == 0 => self.report("a `continue` outside any loop"),
            Step::Break(_) | Step::Continue(_) => {}
            Step::Return(value, _) => self.returned(value),
            Step::Discard(_) if self.module.stage != Some(Stage::Fragment) => {
                self.report("a `discard` outside a fragment shader");
            }
            Step::Discard(_) => {}
        }
    }

    fn run(&mut self, run: Run) {
        if run.first.0 != self.next || run.len == 0 {
            let (first, len, next) = (run.first.0, run.len, self.next);
            self.report(format!(
                "a run of {len} starts with %{first}, expected %{next}"
            ));
        }
        self.next = run.first.0.saturating_add(run.len);
        if self.next as usize > self.module.ops.len() {
            return self.report("a run exceeds the list of operations");
        }
        for id in run.ops() {
            let module = self.module;
            module.each_operand(id, |operand| {
                if !self.is_defined(operand) {
                    self.report_op(id, format!("%{} is not defined here", operand.0));
                }
            });
            if let Err(text) = op::check(self, id) {
                self.report_op(id, text);
            }
            if let Some(slot) = self.defined.get_mut(id.0 as usize) {
                *slot = true;
                self.trail.push(id);
            }
        }
    }

    /// Checks the operand of a control-flow construct.
    fn needs(&mut self, op: OpId, ty: Type, what: &str) {
        if !self.is_defined(op) {
            self.report(format!("{what}, %{}, is not defined here", op.0));
        }
        let found = self.module.ty(op);
        if !op::fits(found, ty) {
            let (found, ty) = (self.name(found), self.name(ty));
            self.report(format!(
                "{what}, %{}, has type {found}, expected {ty}",
                op.0
            ));
        }
    }

    fn returned(&mut self, value: Option<OpId>) {
        let Some(function) = self.at.function.and_then(|f| self.module.function(f)) else {
            return self.report("a `return` outside any function");
        };
        match value {
            Some(value) => self.needs(value, function.returns, "the returned value"),
            None if op::fits(function.returns, Type::VOID) => {}
            None => self.report("a `return` without a value"),
        }
    }

    fn looped(&mut self, found: &Loop) {
        let outer = self.at;
        let inner = StepContext {
            loops: outer.loops + 1,
            breakable: outer.breakable + 1,
            ..outer
        };
        if found.tests_first {
            self.test(found);
        }
        self.at = inner;
        self.region(found.body);
        self.at = outer;
        self.region(found.step);
        if !found.tests_first {
            self.test(found);
        }
    }

    /// Verifies the test region of a loop; the value of the condition is only used there.
    fn test(&mut self, found: &Loop) {
        let mark = self.trail.len();
        // The test region contains no jumps.
        let outer = self.at;
        self.at = StepContext {
            function: outer.function,
            ..StepContext::default()
        };
        self.steps(found.test);
        if let Some(condition) = found.condition {
            self.needs(condition, Type::BOOL, "the condition of a loop");
        }
        self.at = outer;
        self.undefine(mark);
    }

    fn switch(&mut self, found: &Switch) {
        let is_integer = self
            .module
            .scalar(found.selector)
            .is_none_or(Scalar::is_integer);
        let selector = self.module.ty(found.selector);
        self.needs(found.selector, selector, "the selector of a `switch`");
        if !is_integer || !(selector.is_scalar() || selector.is_error()) {
            self.report("the selector of a `switch` is not an integer");
        }
        let module = self.module;
        let cases = module.cases(found);
        self.labels(cases);
        let outer = self.at;
        self.at.breakable += 1;
        for case in cases {
            self.region(case.body);
        }
        self.at = outer;
    }

    fn labels(&mut self, cases: &[Case]) {
        let mut seen: Vec<CaseLabel> = Vec::new();
        for case in cases {
            let labels = self.module.labels(case);
            if labels.is_empty() {
                self.report("a case without a label");
            }
            for &label in labels {
                if seen.contains(&label) {
                    self.report(format!("two cases for {label:?}"));
                }
                seen.push(label);
            }
        }
    }

    /// Operations that compute expressions have the types of these expressions.
    fn expressions(&mut self) {
        let (program, module) = (self.program, self.module);
        for (i, op) in module.by_expr.iter().enumerate() {
            let Some(op) = *op else { continue };
            let id = shaderlint_syntax::ast::ExprId(i as u32);
            if op.0 as usize >= module.ops.len() {
                self.report(format!("expression {i} has no valid operation"));
            } else if !op::fits(module.ty(op), program.ty(id)) {
                let (is, was) = (self.name(module.ty(op)), self.name(program.ty(id)));
                self.report_op(
                    op,
                    format!("the operation has type {is}, its expression {was}"),
                );
            }
        }
        for (i, origin) in module.provenances.iter().enumerate() {
            let exists = match *origin {
                Provenance::Expr(e) => program.tree.exprs.len() > e.0 as usize,
                Provenance::Stmt(s) => program.tree.stmts.len() > s.0 as usize,
                Provenance::Declaration(t) => program.token(t).is_some(),
                Provenance::Language => true,
            };
            if !exists {
                self.report_op(OpId(i as u32), "the provenance is not in the program");
            }
        }
    }
}

/// The storage class that corresponds to a declared `storage`.
fn root_of(storage: Storage) -> Root {
    match storage {
        Storage::Local => Root::Local,
        Storage::Global => Root::Global,
        Storage::Param(Direction::In | Direction::ConstIn) => Root::Parameter,
        Storage::Param(Direction::Out) => Root::ParameterOut,
        Storage::Param(Direction::Inout) => Root::ParameterInout,
        Storage::Uniform => Root::Uniform,
        Storage::Input => Root::Input,
        Storage::Output => Root::Output,
    }
}
