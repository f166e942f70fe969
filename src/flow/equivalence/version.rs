//! The shaders that are compared.

use crate::effects::Effects;
use rustc_hash::FxHashMap;
use shaderlint_ir::{Module, Root};
use shaderlint_semantic::{FunctionRef, Program, VariableId};

/// One version of a shader.
#[derive(Clone, Copy)]
pub struct ShaderVersion<'a> {
    /// The checked program.
    pub program: &'a Program,
    /// Its IR.
    pub module: &'a Module,
    /// Its side effects.
    pub effects: &'a Effects,
}

/// A global variable that keeps its value between functions.
pub(super) struct SharedGlobal<'a> {
    pub name: &'a str,
    pub id: VariableId,
}

impl<'a> ShaderVersion<'a> {
    pub(super) fn name(&self, id: VariableId) -> &'a str {
        let variable = self.program.variable(id);
        variable.map_or("", |v| self.program.names.text(v.name))
    }

    pub(super) fn is_const(&self, id: VariableId) -> bool {
        self.program.variable(id).is_some_and(|v| v.is_const)
    }

    /// The global variables and outputs that may change, by name.
    pub(super) fn shared(&self) -> Vec<SharedGlobal<'a>> {
        let ids = (0..self.module.variables.len() as u32).map(VariableId);
        let is_shared = |id: &VariableId| {
            let root = self.module.variable(*id).map(|v| v.root);
            matches!(root, Some(Root::Global | Root::Output)) && !self.is_const(*id)
        };
        let mut all: Vec<SharedGlobal> = ids
            .filter(is_shared)
            .map(|id| SharedGlobal {
                name: self.name(id),
                id,
            })
            .collect();
        all.sort_by_key(|g| g.name);
        all
    }

    /// Whether a function only computes a value of its arguments.
    pub(super) fn is_pure(&self, id: FunctionRef) -> bool {
        self.effects.is_pure(id) && !self.effects.acts(id)
    }

    /// The number of calls of a function.
    pub(super) fn call_count(&self, id: FunctionRef) -> usize {
        let calls = self.program.calls.iter();
        calls.filter(|call| call.callee == id).count()
    }

    /// The functions that are defined, by name and type.
    pub(super) fn functions(&self) -> FxHashMap<String, FunctionRef> {
        let all = (0..).map(FunctionRef).zip(&self.program.functions);
        let defined = all.filter(|(_, f)| f.definition.is_some());
        let signature = |f: &shaderlint_semantic::Function| {
            let ty = |ty| self.program.type_name(ty);
            let params = f.params.iter();
            let params = params.map(|p| format!("{} {}", p.direction.name(), ty(p.ty)));
            let params: Vec<String> = params.collect();
            let name = self.program.names.text(f.name);
            format!("{} {name}({})", ty(f.returns), params.join(", "))
        };
        defined.map(|(id, f)| (signature(f), id)).collect()
    }
}
