//! Functions, callees before callers.

use super::body::{Body, Bound};
use super::lower::NagaLowerer;
use super::target::{Res, Value};
use super::types::Sink;
use ::naga::{
    AddressSpace, Expression, FunctionArgument, FunctionResult, Handle, Statement, TypeInner,
};
use rustc_hash::FxHashSet;
use shaderlint_ir::{self as ir, OpKind, Root, Visit};
use shaderlint_semantic::{FunctionRef, Type, VariableId};

/// The functions that `main` uses, each after those that it calls.
pub(super) fn order(form: &ir::Module, main: FunctionRef) -> Vec<FunctionRef> {
    let callees = |function: &ir::Function| {
        let called = |op| match form.op(op).kind {
            OpKind::Call(callee, _) => Some(callee),
            _ => None,
        };
        function.ops.ops().filter_map(called).collect()
    };
    let calls: Vec<Vec<FunctionRef>> = form.functions.iter().map(callees).collect();
    let mut done = Vec::new();
    let mut seen = FxHashSet::default();
    let mut stack = vec![(main, 0)];
    while let Some((function, next)) = stack.pop() {
        if next == 0 && !seen.insert(function) {
            continue;
        }
        let callees = calls.get(function.0 as usize);
        match callees.and_then(|all| all.get(next)) {
            Some(callee) => {
                stack.push((function, next + 1));
                if !seen.contains(callee) {
                    stack.push((*callee, 0));
                }
            }
            None => done.push(function),
        }
    }
    done
}

impl<'p> NagaLowerer<'p> {
    /// Builds a function of the shader.
    pub(super) fn function(&mut self, id: FunctionRef) -> Res<()> {
        let (program, form) = (self.program, self.form);
        let (Some(declared), Some(function)) = (program.function(id), form.function(id)) else {
            return self.refuse("unknown function");
        };
        let written = declared.definition.unwrap_or(declared.declaration);
        if let Some(written) = program.tree.function(written) {
            self.place = program.span(written.header);
        }
        let Some(region) = function.body else {
            return self.refuse("this function has no body");
        };
        let returns = function.returns;
        let result = match returns.is_void() {
            true => None,
            false => Some(FunctionResult {
                ty: self.ty(returns)?,
                binding: None,
            }),
        };
        if self.takes_derivatives(function.ops) {
            self.deriving.insert(id);
        }
        let mut body = Body::new(self, program.names.text(declared.name));
        body.function.result = result;
        for parameter in form.parameters(function) {
            body.parameter(*parameter)?;
            body.clear(*parameter, region)?;
        }
        body.region(region)?;
        body.end(returns)?;
        let function = body.finish();
        let handle = self.define(function)?;
        self.functions.insert(id, handle);
        Ok(())
    }
}

impl NagaLowerer<'_> {
    /// Whether some operations take derivatives, also in functions that they call.
    pub(super) fn takes_derivatives(&self, ops: ir::Run) -> bool {
        ops.ops().any(|op| match self.form.op(op).kind {
            OpKind::Builtin(function, _) => function.kind().takes_derivatives(),
            OpKind::Call(callee, _) => self.deriving.contains(&callee),
            _ => false,
        })
    }
}

impl Body<'_, '_> {
    /// Declares an argument and returns its value.
    pub(super) fn argument(&mut self, name: &str, ty: Handle<::naga::Type>) -> Value {
        let index = self.function.arguments.len() as u32;
        self.function.arguments.push(FunctionArgument {
            name: (!name.is_empty()).then(|| name.to_string()),
            ty,
            binding: None,
        });
        self.add(Expression::FunctionArgument(index))
    }

    fn parameter(&mut self, id: VariableId) -> Res<()> {
        let Some(variable) = self.lowerer.form.variable(id) else {
            return self.lowerer.refuse("unknown parameter");
        };
        let ty = variable.ty;
        let name = self.lowerer.name(id).unwrap_or_default();
        if self.lowerer.inside(ty).sampler {
            return self.sampler_parameter(id, name, ty);
        }
        let bound = if variable.root != Root::Parameter {
            let base = self.lowerer.ty(ty)?;
            let space = AddressSpace::Function;
            let ty = self.lowerer.inner(None, TypeInner::Pointer { base, space });
            Bound::Pointer(self.argument(name, ty))
        } else {
            let inner = self.lowerer.ty(ty)?;
            let value = self.argument(name, inner);
            let is_plain = ty.is_scalar() || ty.is_vector();
            match is_plain && self.lowerer.stores(id) == 0 {
                true => Bound::Value(value),
                false => {
                    let pointer = self.local(Some(name), ty)?;
                    self.store(pointer, value);
                    Bound::Pointer(pointer)
                }
            }
        };
        self.variables.insert(id, bound);
        Ok(())
    }

    /// Initialises an `out` parameter to zero, as in the browser, unless the function starts by
    /// assigning it.
    fn clear(&mut self, parameter: VariableId, region: ir::Region) -> Res<()> {
        let form = self.lowerer.form;
        let Some(variable) = form.variable(parameter) else {
            return Ok(());
        };
        if variable.root != Root::ParameterOut || is_set_first(form, parameter, region) {
            return Ok(());
        }
        if let Some(Bound::Pointer(pointer)) = self.variables.get(&parameter).copied() {
            let zero = self.zero(variable.ty)?;
            self.store(pointer, zero);
        }
        Ok(())
    }

    /// Ends the function with a return value if control can reach the end.
    fn end(&mut self, returns: Type) -> Res<()> {
        if self.is_terminated() {
            return Ok(());
        }
        let value = match returns.is_void() {
            true => None,
            false => Some(self.zero(returns)?),
        };
        self.push(Statement::Return { value });
        Ok(())
    }
}

/// Whether the first use of a variable in a region is an unconditional assignment of all its
/// components.
fn is_set_first(form: &ir::Module, variable: VariableId, region: ir::Region) -> bool {
    let Some(ir::Step::Run(run)) = form.steps(region).first() else {
        return false;
    };
    let mut uses = run.ops().filter_map(|op| match form.op(op).kind {
        OpKind::Store(place, _) => Some((form.place(place), true)),
        OpKind::Load(place) => Some((form.place(place), false)),
        _ => None,
    });
    let first = uses.find(|(place, _)| place.variable == variable);
    first.is_some_and(|(place, is_set)| is_set && place.path.len == 0)
}
