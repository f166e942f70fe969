//! Which faults a sample run could still find: those that ranges do not rule out.

use crate::facts::Facts;
use shaderlint_exec::FaultKind;
use shaderlint_flow::ranges::Interval;
use shaderlint_ir::{Access, Binary, OpId, OpKind};
use shaderlint_semantic::Undefined;
use shaderlint_semantic::builtins::BuiltinKind;

impl Facts<'_> {
    /// Whether a fault of this kind is possible anywhere, and would be reported.
    pub(super) fn has_open(&self, kind: FaultKind) -> bool {
        if !self.may_check(kind) {
            return false;
        }
        let Some((bench, _)) = self.bench() else {
            return false;
        };
        let mut checked = bench.watched().checked();
        checked.any(|(op, other)| other == kind && self.is_open(op, kind))
    }

    /// Whether the shader has an operation with an open fault of this kind, as far as that is known before
    /// it is compiled.
    fn may_check(&self, kind: FaultKind) -> bool {
        let module = self.module();
        let mut ops = (0..).map(OpId).zip(&module.ops);
        match kind {
            FaultKind::DivisionByZero => ops.any(|(id, op)| {
                let divides = matches!(
                    op.kind,
                    OpKind::Binary(Binary::Divide | Binary::Remainder, ..)
                );
                divides && self.is_open(id, kind)
            }),
            FaultKind::Undefined => ops.any(|(id, op)| {
                let is_candidate = match op.kind {
                    OpKind::Binary(binary, ..) => matches!(
                        binary,
                        Binary::Remainder | Binary::ShiftLeft | Binary::ShiftRight
                    ),
                    OpKind::Builtin(function, _) => match function.kind() {
                        BuiltinKind::Math => function.undefined() != Undefined::NEVER,
                        BuiltinKind::Derivative(_) => true,
                        _ => false,
                    },
                    _ => false,
                };
                is_candidate && self.is_open(id, kind)
            }),
            FaultKind::OutOfRange => {
                let is_computed = |access: &Access| matches!(access, Access::Computed(_));
                module.access_lists.iter().any(is_computed)
                    || ops.any(|(_, op)| matches!(op.kind, OpKind::ExtractComputed { .. }))
            }
            FaultKind::Nan | FaultKind::Infinite => true,
        }
    }

    /// Whether a fault of this operation is possible, and would be reported.
    pub(super) fn is_open(&self, op: OpId, kind: FaultKind) -> bool {
        !self.is_reported(op) && self.is_known(op) && self.may_fault(op, kind)
    }

    /// Whether the ranges of the operands permit a fault.
    fn may_fault(&self, op: OpId, kind: FaultKind) -> bool {
        let (module, ranges) = (self.module(), self.ranges());
        let lanes = || 0..module.ty(op).components();
        let range = |operand: OpId, lane: u32| -> Interval {
            ranges.lane(operand, module.operand_lane(operand, lane))
        };
        match (kind, module.op(op).kind) {
            (
                FaultKind::DivisionByZero,
                OpKind::Binary(Binary::Divide | Binary::Remainder, _, divisor),
            ) => lanes().any(|lane| range(divisor, lane).contains(0.0)),
            (FaultKind::Undefined, OpKind::Builtin(function, list))
                if function.kind() == BuiltinKind::Math =>
            {
                let operands = module.operands(list);
                let may_hold = |lane: u32| {
                    function.undefined().may_hold(|operand| {
                        let range = range(*operands.get(operand)?, lane);
                        Some((range.lo.value, range.hi.value))
                    })
                };
                lanes().any(may_hold)
            }
            _ => true,
        }
    }
}
