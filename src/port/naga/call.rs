//! Calls of user-defined functions. `out` and `inout` arguments are pointers: to the caller's
//! variable if the value is copied from it and back to it, otherwise to a copy.

use super::body::{Body, Bound};
use super::target::{Res, Value};
use ::naga::MathFunction;
use shaderlint_ir::{OpId, OpKind, PlaceId, Root};
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::List;

impl Body<'_, '_> {
    /// Lowers a call and returns its value; `None` for a function without a result.
    pub(super) fn user_call(
        &mut self,
        call: OpId,
        function: FunctionRef,
        operands: List,
    ) -> Res<Option<Value>> {
        let form = self.lowerer.form;
        let (Some(found), Some(handle)) = (
            form.function(function),
            self.lowerer.functions.get(&function).copied(),
        ) else {
            return self.lowerer.refuse("this function has no body");
        };
        let taken = self.taken_back(call);
        let mut arguments = Vec::new();
        // The argument position of the one texture with a computed index.
        let mut chosen = None;
        let parameters = form.parameters(found).iter().zip(form.operands(operands));
        for (number, (parameter, operand)) in (0..).zip(parameters) {
            let root = form.variable(*parameter).map(|v| v.root);
            if form.ty(*operand).is_sampler() {
                if self.is_chosen(*operand) && chosen.is_none() {
                    chosen = Some((arguments.len(), *operand));
                    continue;
                }
                let all = self.samplers(*operand)?.into_iter();
                arguments.extend(all.flat_map(|l| [l.image, l.sampler]));
            } else if root == Some(Root::Parameter) {
                arguments.push(self.value(*operand)?);
            } else if let Some(pointer) = self.lent(call, number, *operand, &taken)? {
                arguments.push(pointer);
            } else {
                let value = self.value(*operand)?;
                let copy = self.spill(value, form.ty(*operand))?;
                self.copies.insert((call, number), copy);
                arguments.push(copy);
            }
        }
        let returns = found.returns;
        let Some((at, operand)) = chosen else {
            return Ok(self.call(handle, arguments, returns));
        };
        self.with_sampler(operand, returns, |it, looked| {
            let (before, after) = arguments.split_at(at);
            let all = [before, &[looked.image, looked.sampler], after].concat();
            Ok(it.call(handle, all, returns))
        })
    }

    /// The value of an `out` parameter after a call; `None` if it is already stored in its target.
    pub(super) fn returned(&mut self, call: OpId, parameter: u32) -> Res<Option<Value>> {
        let form = self.lowerer.form;
        // `modf` is the only built-in function that writes to an argument.
        if let OpKind::Builtin(_, operands) = form.op(call).kind
            && let &[x, ..] = form.operands(operands)
        {
            let x = self.value(x)?;
            return Ok(Some(self.math(MathFunction::Trunc, &[x])));
        }
        let copy = self.copies.get(&(call, parameter)).copied();
        Ok(copy.map(|copy| self.load(copy)))
    }

    /// Whether a value is already stored in the place that it is stored to.
    pub(super) fn is_lent(&self, value: OpId) -> bool {
        let form = self.lowerer.form;
        match form.op(value).kind {
            OpKind::Returned(call, parameter) => {
                let is_own = matches!(form.op(call).kind, OpKind::Call(..));
                is_own && !self.copies.contains_key(&(call, parameter))
            }
            _ => false,
        }
    }

    /// By parameter: the places that the results of `out` parameters are stored to.
    fn taken_back(&self, call: OpId) -> Vec<(u32, PlaceId)> {
        let kind = |id: u32| self.lowerer.form.op(OpId(id)).kind;
        let mut found = Vec::new();
        let mut at = call.0 + 1;
        while let OpKind::Returned(of, parameter) = kind(at)
            && of == call
            && let OpKind::Store(place, value) = kind(at + 1)
            && value == OpId(at)
        {
            found.push((parameter, place));
            at += 2;
        }
        found
    }

    /// A pointer to the local variable that a parameter is copied from and back to, if nothing else
    /// writes to it in between.
    fn lent(
        &mut self,
        call: OpId,
        parameter: u32,
        operand: OpId,
        taken: &[(u32, PlaceId)],
    ) -> Res<Option<Value>> {
        let form = self.lowerer.form;
        let Some((_, target)) = taken.iter().find(|(number, _)| *number == parameter) else {
            return Ok(None);
        };
        let target = form.place(*target);
        let is_of = |place: PlaceId| form.place(place).variable == target.variable;
        let writes = |id: u32| matches!(form.op(OpId(id)).kind, OpKind::Store(p, _) if is_of(p));
        let is_same = match form.op(operand).kind {
            OpKind::Undef => true,
            OpKind::Load(from) => {
                let is_complete = is_of(from) && form.place(from).path.len == 0;
                is_complete && !(operand.0..call.0).any(writes)
            }
            _ => false,
        };
        let owner = form.variable(target.variable).map(|v| v.function);
        let is_own = matches!(owner, Some(Some(_)));
        let is_alone = taken.iter().filter(|(_, place)| is_of(*place)).count() == 1;
        if !(is_same && is_own && is_alone && target.path.len == 0) {
            return Ok(None);
        }
        match self.bound(target.variable)? {
            Bound::Pointer(pointer) => Ok(Some(pointer)),
            _ => Ok(None),
        }
    }
}
