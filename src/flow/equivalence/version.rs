//! The shaders that are compared.

use crate::effects::Effects;
use rustc_hash::FxHashMap;
use shaderlint_ir::{Module, Root};
use shaderlint_semantic::{FunctionRef, Program, VariableId};

/// A function that the other version has as its `main`: its first parameter is the output of that
/// name, and its second `gl_FragCoord.xy`.
#[derive(Clone, Copy)]
pub struct ImageEntry {
    /// The function.
    pub function: FunctionRef,
    /// Whether its caller sets the output to zero.
    pub is_cleared: bool,
    /// Whether its caller sets alpha to 1.0 at the end.
    pub is_opaque: bool,
}

/// One version of a shader.
#[derive(Clone, Copy)]
pub struct ShaderVersion<'a> {
    /// The checked program.
    pub program: &'a Program,
    /// Its IR.
    pub module: &'a Module,
    /// Its side effects.
    pub effects: &'a Effects,
    /// The entry function, unless that is `main`. Then outputs and `main` belong to its caller.
    pub entry: Option<ImageEntry>,
}

/// A global variable that keeps its value between functions.
pub(super) struct SharedGlobal<'a> {
    pub name: &'a str,
    /// The call that it belongs to: 0, or 1 for the parameter of an [`ImageEntry`].
    pub call: u32,
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
        let color = self.entry.and_then(|entry| self.parameter(entry, 0));
        let ids = (0..self.module.variables.len() as u32).map(VariableId);
        let is_shared = |id: &VariableId| match self.module.variable(*id).map(|v| v.root) {
            Some(Root::Global) => !self.is_const(*id),
            Some(Root::Output) => self.entry.is_none(),
            _ => color == Some(*id),
        };
        let mut all: Vec<SharedGlobal> = ids
            .filter(is_shared)
            .map(|id| SharedGlobal {
                name: self.name(id),
                call: u32::from(color == Some(id)),
                id,
            })
            .collect();
        all.sort_by_key(|g| g.name);
        all
    }

    /// A parameter of an entry function.
    pub(super) fn parameter(&self, entry: ImageEntry, at: usize) -> Option<VariableId> {
        let function = self.module.function(entry.function)?;
        self.module.parameters(function).get(at).copied()
    }

    /// The function that is compared with that of the other version.
    pub(super) fn entry_function(&self) -> Option<FunctionRef> {
        self.entry.map_or(self.module.entry, |e| Some(e.function))
    }

    /// Whether a function only computes a value of its arguments.
    pub(super) fn is_pure(&self, id: FunctionRef) -> bool {
        self.effects.is_pure(id) && !self.effects.acts(id)
    }

    /// The number of structs that the text of the host declares; they are the first.
    pub(super) fn host_structs(&self) -> u16 {
        let structs = self.program.structs.iter();
        let token = |s: &shaderlint_semantic::Struct| self.program.token(s.token);
        let is_host = |s| token(s).is_some_and(|t| !self.program.is_user(t.span));
        structs.take_while(|s| is_host(s)).count() as u16
    }

    /// The number of calls of a function.
    pub(super) fn call_count(&self, id: FunctionRef) -> usize {
        let calls = self.program.calls.iter();
        calls.filter(|call| call.callee == id).count()
    }

    /// The functions that are defined, by name and type.
    pub(super) fn functions(&self) -> FxHashMap<String, FunctionRef> {
        let all = (0..).map(FunctionRef).zip(&self.program.functions);
        let is_caller = |f: &shaderlint_semantic::Function| {
            self.entry.is_some() && self.program.names.text(f.name) == "main"
        };
        let defined = all.filter(|(_, f)| f.definition.is_some() && !is_caller(f));
        let signature = |f: &shaderlint_semantic::Function| {
            let ty = |ty| self.program.type_name(ty);
            let params = f.params.iter();
            let params = params.map(|p| format!("{} {}", p.direction.name(), ty(p.ty)));
            let params: Vec<String> = params.collect();
            let name = self.program.names.text(f.name);
            format!("{} {name}({})", ty(f.returns), params.join(", "))
        };
        let is_entry = |id| self.entry.is_some_and(|e| e.function == id);
        let defined = defined.map(|(id, f)| match is_entry(id) {
            true => ("void main()".to_string(), id),
            false => (signature(f), id),
        });
        defined.collect()
    }
}
