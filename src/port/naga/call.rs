//! Calls of the shader's own functions. Arguments that are written to travel as pointers to
//! variables of the caller: the variable itself where it is one, else a copy that is written back.

use super::body::{Body, Bound};
use super::place::Place;
use super::{Res, Value};
use crate::semantic::{Direction, FunctionRef, Resolution, Storage, VariableId};
use crate::syntax::ast::{ExprId, List};

impl Body<'_, '_> {
    /// The value of a call; `None` for one of a function without.
    pub(super) fn called(&mut self, id: ExprId, args: List) -> Res<Option<Value>> {
        let program = self.lowerer.program;
        match program.expr(id).resolution {
            Resolution::Function(function) => self.user_call(id, function, args),
            Resolution::Builtin(_) => {
                let Some(overload) = program.overload_called(id) else {
                    return self.refuse(id, "this call is not known");
                };
                self.builtin(id, overload, program.tree.args(args))
                    .map(Some)
            }
            Resolution::Struct(_) => self.construct(program.ty(id), args).map(Some),
            _ => self.refuse(id, "this call is not known"),
        }
    }

    fn user_call(&mut self, id: ExprId, function: FunctionRef, args: List) -> Res<Option<Value>> {
        let program = self.lowerer.program;
        let (Some(found), Some(handle)) = (
            program.function(function),
            self.lowerer.functions.get(&function).copied(),
        ) else {
            return self.refuse(id, "this function has no body");
        };
        let mut arguments = Vec::new();
        let mut copies: Vec<(Place, Value)> = Vec::new();
        let mut taken: Vec<VariableId> = Vec::new();
        for (param, arg) in found.params.iter().zip(program.tree.args(args)) {
            if param.ty.is_sampler() {
                let (image, sampler, _) = self.sampler(*arg)?;
                arguments.extend([image, sampler]);
                continue;
            }
            if !param.direction.writes() {
                arguments.push(self.value(*arg)?);
                continue;
            }
            if let Some(pointer) = self.own_variable(*arg, &mut taken)? {
                arguments.push(pointer);
                continue;
            }
            let place = self.place(*arg)?;
            let copy = self.local(None, param.ty)?;
            let start = if param.direction == Direction::Inout {
                self.read(&place)
            } else {
                self.zero(param.ty)?
            };
            self.store(copy, start);
            arguments.push(copy);
            copies.push((place, copy));
        }
        let result = self.call(handle, arguments, found.returns);
        for (place, copy) in copies {
            let value = self.load(copy);
            self.write(&place, value);
        }
        Ok(result)
    }

    /// What points at the variable that an argument is, if it is one of this function and no other
    /// argument of the call.
    fn own_variable(&mut self, arg: ExprId, taken: &mut Vec<VariableId>) -> Res<Option<Value>> {
        let program = self.lowerer.program;
        let Some(id) = program.variable_of(arg) else {
            return Ok(None);
        };
        let is_own = program
            .variable(id)
            .is_some_and(|v| matches!(v.storage, Storage::Local | Storage::Param(_)));
        if !is_own || taken.contains(&id) {
            return Ok(None);
        }
        taken.push(id);
        match self.bound(id)? {
            Bound::Pointer(pointer) => Ok(Some(pointer)),
            _ => Ok(None),
        }
    }
}
