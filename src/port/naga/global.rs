//! Global variables: constants, shared variables, inputs and outputs.

use super::body::{Body, Bound};
use super::lower::{Initialisers, NagaLowerer};
use super::stored::Major;
use super::target::{Res, Value};
use super::types::{Sink, compose};
use ::naga::{
    AddressSpace, Constant, Expression, GlobalVariable, Handle, MemoryDecorations, ResourceBinding,
    Span,
};
use shaderlint_ir::Root;
use shaderlint_semantic::{Constant as Known, Stage, Storage, Type, VariableId};

/// A global variable in the naga module.
#[derive(Clone, Copy, Debug)]
pub(super) enum Global {
    Variable(Handle<GlobalVariable>),
    Constant(Handle<Constant>),
    /// A member of a uniform buffer, with the layout of its matrices.
    Stored(Handle<GlobalVariable>, u32, Major),
}

impl<'p> NagaLowerer<'p> {
    /// Declares shared variables, inputs and outputs.
    pub(super) fn declare_globals(&mut self) -> Res<()> {
        let program = self.program;
        for (i, variable) in program.variables.iter().enumerate() {
            let is_shared = matches!(
                variable.storage,
                Storage::Global | Storage::Input | Storage::Output
            );
            // The next stage reads an output even if it is never assigned.
            let is_handed_on =
                variable.storage == Storage::Output && program.stage == Stage::Vertex;
            let is_used = variable.read || variable.written || is_handed_on;
            if !is_shared || variable.token.is_none() || variable.ty.is_sampler() || !is_used {
                continue;
            }
            self.stand_at_name(variable);
            let id = VariableId(i as u32);
            let name = program.names.text(variable.name);
            let is_constant = variable.is_const && variable.constant.is_known();
            if is_constant && self.constant(id)?.is_some() {
                continue;
            }
            let ty = self.ty(variable.ty)?;
            let handle = self.private(name, ty);
            self.globals.insert(id, Global::Variable(handle));
        }
        Ok(())
    }

    /// Declares a private variable.
    pub(super) fn private(
        &mut self,
        name: &str,
        ty: Handle<::naga::Type>,
    ) -> Handle<GlobalVariable> {
        self.global_variable(name, ty, AddressSpace::Private, None)
    }

    /// Declares a variable of the module.
    pub(super) fn global_variable(
        &mut self,
        name: &str,
        ty: Handle<::naga::Type>,
        space: AddressSpace,
        binding: Option<ResourceBinding>,
    ) -> Handle<GlobalVariable> {
        let variable = GlobalVariable {
            name: Some(name.to_string()),
            space,
            binding,
            ty,
            init: None,
            memory_decorations: MemoryDecorations::empty(),
        };
        self.module
            .global_variables
            .append(variable, Span::UNDEFINED)
    }

    /// Whether stores to a variable are needed: not if it is never read, or is a constant.
    pub(super) fn has_place(&mut self, id: VariableId) -> Res<bool> {
        let is_shared = |root| matches!(root, Root::Global | Root::Output);
        let is_shared = self.form.variable(id).is_some_and(|v| is_shared(v.root));
        let is_own = self.program.variable(id).is_some_and(|v| v.token.is_some());
        match self.globals.get(&id) {
            None if is_shared && is_own => Ok(false),
            None => Ok(self.named(id)?.is_none()),
            Some(global) => Ok(matches!(global, Global::Variable(_))),
        }
    }

    /// The named constant for a variable. Scalar and vector constants of functions are inlined.
    pub(super) fn named(&mut self, id: VariableId) -> Res<Option<Handle<Constant>>> {
        match (self.globals.get(&id).copied(), self.program.variable(id)) {
            (Some(Global::Constant(found)), _) => Ok(Some(found)),
            (None, Some(v)) if v.is_const && v.constant.is_known() => {
                match v.ty.is_scalar() || v.ty.is_vector() {
                    true => Ok(None),
                    false => self.constant(id),
                }
            }
            _ => Ok(None),
        }
    }

    /// Declares a named constant; `None` if one of its values cannot be written as a literal.
    fn constant(&mut self, id: VariableId) -> Res<Option<Handle<Constant>>> {
        let Some(variable) = self.program.variable(id) else {
            return Ok(None);
        };
        let Some(init) = self.initialiser(variable.ty, variable.constant)? else {
            return Ok(None);
        };
        let constant = Constant {
            name: self.name(id).map(str::to_string),
            ty: self.ty(variable.ty)?,
            init,
        };
        let handle = self.module.constants.append(constant, Span::UNDEFINED);
        self.globals.insert(id, Global::Constant(handle));
        Ok(Some(handle))
    }

    /// The initial value of a constant.
    fn initialiser(&mut self, ty: Type, known: Known) -> Res<Option<Value>> {
        let values = self.program.pool.values(known);
        let mut all = Initialisers::new(self);
        let value = compose(&mut all, ty, &mut values.iter());
        all.finish();
        value
    }
}

impl Body<'_, '_> {
    /// Where a variable is stored in this function.
    pub(super) fn bound(&mut self, id: VariableId) -> Res<Bound> {
        if let Some(found) = self.variables.get(&id) {
            return Ok(*found);
        }
        match self.lowerer.globals.get(&id).copied() {
            Some(Global::Variable(handle)) => {
                Ok(Bound::Pointer(self.add(Expression::GlobalVariable(handle))))
            }
            Some(Global::Constant(handle)) => {
                Ok(Bound::Value(self.add(Expression::Constant(handle))))
            }
            Some(Global::Stored(buffer, member, major)) => {
                Ok(self.stored_uniform(id, buffer, member, major))
            }
            None => self.unbound(id),
        }
    }

    /// Declares a variable on its first use.
    fn unbound(&mut self, id: VariableId) -> Res<Bound> {
        let (program, form) = (self.lowerer.program, self.lowerer.form);
        let name = self.lowerer.name(id);
        if let Some(constant) = self.lowerer.named(id)? {
            return Ok(Bound::Value(self.add(Expression::Constant(constant))));
        }
        match (form.variable(id), program.variable(id)) {
            (Some(variable), _) if matches!(variable.root, Root::Local | Root::Temporary) => {
                let bound = Bound::Pointer(self.local(name, variable.ty)?);
                self.variables.insert(id, bound);
                Ok(bound)
            }
            (_, Some(variable)) if variable.token.is_none() => self.special(id),
            (Some(variable), _) => {
                let (ty, name) = (program.type_name(variable.ty), name.unwrap_or_default());
                self.lowerer.refuse(format!(
                    "`{ty} {name}` has no equivalent in the target language"
                ))
            }
            _ => self.lowerer.refuse("unknown variable"),
        }
    }
}
