//! Order of evaluation. GLSL leaves the order of operands open (GLSL ES 3.00 section 5.9); browsers
//! evaluate them from left to right, but load an operand that is a variable, or a part of one, after all
//! operands: in `G + f()`, `G` has the value that `f` leaves. Measured in Chromium (ANGLE's SPIR-V).

use super::super::form::*;
use super::Lowerer;
use super::place::AssignTarget;
use shaderlint_semantic::{Type, Value};
use shaderlint_syntax::ast::{ExprId, ExprKind};

/// An operand while its siblings are evaluated.
pub(super) enum Operand {
    Value(OpId),
    /// Is loaded after them. The expressions are those whose value it is, the innermost last.
    Place(PlaceId, Vec<ExprId>),
    /// An `inout` argument.
    Target(AssignTarget, Type),
}

impl Lowerer<'_> {
    /// Evaluates operands from left to right, and then loads those that are variables.
    pub(super) fn in_order(&mut self, operands: &[ExprId]) -> Vec<OpId> {
        let count = self.writing.count_before(operands);
        let mut open = Vec::with_capacity(operands.len());
        for (at, &operand) in operands.iter().enumerate() {
            open.push(self.before(operand, at < count));
        }
        self.load_operands(open)
    }

    /// The values of operands that were all evaluated.
    pub(super) fn load_operands(&mut self, operands: Vec<Operand>) -> Vec<OpId> {
        let loaded = operands
            .into_iter()
            .map(|operand| self.load_operand(operand));
        loaded.collect()
    }

    /// Evaluates an operand; whether one follows that may write.
    pub(super) fn before(&mut self, operand: ExprId, is_followed: bool) -> Operand {
        match is_followed {
            true => self.unloaded(operand),
            false => Operand::Value(self.value(operand)),
        }
    }

    /// Evaluates an operand, except for the load of a variable.
    fn unloaded(&mut self, operand: ExprId) -> Operand {
        let program = self.program;
        let mut same = vec![operand];
        let mut id = operand;
        while let Some(inner) = match program.tree.expr(id).kind {
            _ if program.expr(id).constant.is_known() => None,
            ExprKind::Paren(inner) => Some(inner),
            ExprKind::Comma(left, right) => {
                self.value(left);
                Some(right)
            }
            ExprKind::Ternary(condition, then, otherwise) => match program.scalar(condition) {
                Some(Value::Bool(is_true)) => Some(if is_true { then } else { otherwise }),
                _ => None,
            },
            _ => None,
        } {
            id = inner;
            same.push(id);
        }
        let is_place = matches!(
            program.tree.expr(id).kind,
            ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Index(..)
        );
        if is_place && !program.expr(id).constant.is_known() {
            let outer = std::mem::replace(&mut self.origin, Provenance::Expr(id));
            let path = self.place_path(id);
            self.origin = outer;
            if let Some(path) = path {
                return Operand::Place(self.keep(&path), same);
            }
        }
        let value = self.value(id);
        same.iter().for_each(|id| self.note(*id, value));
        Operand::Value(value)
    }

    /// The value of an operand, after its siblings were evaluated.
    pub(super) fn load_operand(&mut self, operand: Operand) -> OpId {
        match operand {
            Operand::Value(value) => value,
            Operand::Target(target, ty) => self.read(target, ty),
            Operand::Place(place, same) => {
                let inner = same.last().map_or(self.origin, |id| Provenance::Expr(*id));
                let outer = std::mem::replace(&mut self.origin, inner);
                let value = self.load(place);
                self.origin = outer;
                same.iter().for_each(|id| self.note(*id, value));
                value
            }
        }
    }
}
