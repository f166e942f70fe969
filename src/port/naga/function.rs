//! Functions, those that are called before those that call.

use super::body::{Body, Bound};
use super::lower::Lowerer;
use super::types::{Sink, image, texel};
use super::{Res, Value};
use crate::semantic::{FunctionRef, Parameter, Program, VariableId};
use ::naga::{
    AddressSpace, Expression, FunctionArgument, FunctionResult, Handle, Statement, TypeInner,
};
use std::collections::HashSet;

/// The functions that `main` needs, each behind all that it calls.
pub(super) fn order(program: &Program, main: FunctionRef) -> Vec<FunctionRef> {
    let mut calls: Vec<Vec<FunctionRef>> = vec![Vec::new(); program.functions.len()];
    for call in &program.calls {
        if let Some(caller) = call.caller
            && let Some(all) = calls.get_mut(caller.0 as usize)
        {
            all.push(call.callee);
        }
    }
    let mut done = Vec::new();
    let mut seen = HashSet::new();
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

impl<'p> Lowerer<'p> {
    /// Makes a function of the shader.
    pub(super) fn function(&mut self, id: FunctionRef) -> Res<()> {
        let program = self.program;
        let Some(found) = program.function(id) else {
            return self.refuse("this function is not known");
        };
        let decl = found.definition.unwrap_or(found.declaration);
        let Some(decl) = program.tree.function(decl) else {
            return self.refuse("this function is not known");
        };
        self.place = program.span(decl.header);
        let Some(block) = decl.body else {
            return self.refuse("this function has no body");
        };
        let result = match found.returns.is_void() {
            true => None,
            false => Some(FunctionResult {
                ty: self.ty(found.returns)?,
                binding: None,
            }),
        };
        let name = program.names.text(found.name);
        let mut body = Body::new(self, name, found.returns);
        body.function.result = result;
        let params = program.tree.params(decl.params);
        for (i, (param, written)) in found.params.iter().zip(params).enumerate() {
            let variable = program
                .declared_params
                .get(decl.params.start as usize + i)
                .copied()
                .flatten();
            let name = written.ident.map_or("", |i| program.names.text(i.name));
            body.param(param, variable, name)?;
        }
        body.statement(block)?;
        body.end()?;
        let function = body.finish();
        let handle = self.define(function)?;
        self.functions.insert(id, handle);
        Ok(())
    }
}

impl Body<'_, '_> {
    /// Declares an argument; gives its value.
    pub(super) fn argument(&mut self, name: &str, ty: Handle<::naga::Type>) -> Value {
        let index = self.function.arguments.len() as u32;
        self.function.arguments.push(FunctionArgument {
            name: (!name.is_empty()).then(|| name.to_string()),
            ty,
            binding: None,
        });
        self.add(Expression::FunctionArgument(index))
    }

    fn param(&mut self, param: &Parameter, variable: Option<VariableId>, name: &str) -> Res<()> {
        let bound = if let Some(kind) = param.ty.as_sampler() {
            let ty = self.lowerer.inner(None, image(kind));
            let image = self.argument(name, ty);
            let comparison = texel(kind).is_none();
            let ty = self.lowerer.inner(None, TypeInner::Sampler { comparison });
            let sampler = self.argument(&format!("{name}Sampler"), ty);
            Bound::Sampler {
                image,
                sampler,
                kind,
            }
        } else if param.direction.writes() {
            let base = self.lowerer.ty(param.ty)?;
            let space = AddressSpace::Function;
            let ty = self.lowerer.inner(None, TypeInner::Pointer { base, space });
            Bound::Pointer(self.argument(name, ty))
        } else {
            let ty = self.lowerer.ty(param.ty)?;
            let value = self.argument(name, ty);
            let found = variable.and_then(|v| self.lowerer.program.variable(v));
            let is_plain = param.ty.is_scalar() || param.ty.is_vector();
            let is_fixed = found.is_none_or(|v| !v.written);
            match is_fixed && is_plain {
                true => Bound::Value(value),
                false => {
                    let pointer = self.local(Some(name), param.ty)?;
                    self.store(pointer, value);
                    Bound::Pointer(pointer)
                }
            }
        };
        if let Some(variable) = variable {
            self.variables.insert(variable, bound);
        }
        Ok(())
    }

    /// The end of a function, where nothing was returned before.
    fn end(&mut self) -> Res<()> {
        if self.is_terminated() {
            return Ok(());
        }
        let value = match self.returns.is_void() {
            true => None,
            false => {
                let returns = self.returns;
                Some(self.zero(returns)?)
            }
        };
        self.push(Statement::Return { value });
        Ok(())
    }
}
