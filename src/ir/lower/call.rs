//! Lowering of calls: arguments are evaluated in [order](super::order) and passed by value; `out` arguments
//! are copied back after the call (copy-in, copy-out).

use super::super::form::*;
use super::Lowerer;
use super::order::Operand;
use super::place::AssignTarget;
use shaderlint_semantic::{Direction, FunctionRef, Type};
use shaderlint_syntax::ast::List;

impl Lowerer<'_> {
    /// Lowers a call of a user-defined function.
    pub(super) fn call(&mut self, function: FunctionRef, args: List, ty: Type) -> OpId {
        let program = self.program;
        let params = program.function(function).map_or(&[][..], |f| &f.params);
        let args = program.tree.args(args);
        let count = self.writing.count_before(args) as u32;
        let mut operands = Vec::with_capacity(params.len());
        let mut back: Vec<(u32, AssignTarget, Type)> = Vec::new();
        for ((number, param), &arg) in (0..).zip(params).zip(args) {
            let operand = match param.direction {
                Direction::In | Direction::ConstIn => self.before(arg, number < count),
                Direction::Out | Direction::Inout => {
                    let target = self.target(arg);
                    back.push((number, target, param.ty));
                    match param.direction {
                        Direction::Inout => Operand::Target(target, param.ty),
                        _ => Operand::Value(self.op(OpKind::Undef, param.ty)),
                    }
                }
            };
            operands.push(operand);
        }
        let operands = self.load_operands(operands);
        let operands = self.operands(&operands);
        let call = self.op(OpKind::Call(function, operands), ty);
        self.take_back(call, &back);
        call
    }

    /// Lowers a call of a built-in function.
    pub(super) fn builtin(&mut self, overload: u32, args: List, ty: Type) -> OpId {
        let program = self.program;
        let found = program.builtins().overload(overload);
        let out = found.map_or(0, |o| o.out);
        let kind = |operands| match found {
            Some(overload) => OpKind::Builtin(overload.function, operands),
            None => OpKind::Unknown,
        };
        let args = program.tree.args(args);
        let count = self.writing.count_before(args) as u32;
        let mut operands = Vec::with_capacity(args.len());
        let mut back = Vec::new();
        for (number, &arg) in (0..).zip(args) {
            match out >> number & 1 {
                0 => operands.push(self.before(arg, number < count)),
                _ => back.push((number, self.target(arg), program.ty(arg))),
            }
        }
        let operands = self.load_operands(operands);
        let operands = self.operands(&operands);
        let call = self.op(kind(operands), ty);
        self.take_back(call, &back);
        call
    }

    /// Copies the `out` and `inout` parameters of a call back to the arguments.
    fn take_back(&mut self, call: OpId, back: &[(u32, AssignTarget, Type)]) {
        for &(number, target, ty) in back {
            let value = self.op(OpKind::Returned(call, number), ty);
            self.write(target, value);
        }
    }
}
