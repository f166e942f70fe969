//! Uses of each variable.

use crate::lists::Lists;
use crate::{Program, Resolution, VariableId};
use shaderlint_syntax::ast::{ExprId, Extent};

/// Expressions that refer to variables, in tree order.
#[derive(Default, Debug)]
pub struct Mentions(Lists<ExprId>);

impl Mentions {
    /// Collects the uses of all variables in a shader.
    pub fn of(program: &Program) -> Mentions {
        let named = program.exprs.iter().zip(0..).filter_map(|(info, i)| {
            let Resolution::Variable(v) = info.resolution else {
                return None;
            };
            Some((v.0, ExprId(i)))
        });
        Mentions(Lists::of(program.variables.len(), named))
    }

    /// The expressions that refer to a variable.
    pub fn all(&self, variable: VariableId) -> &[ExprId] {
        self.0.get(variable.0)
    }

    /// The first use of a variable in a token range.
    pub fn first_in(
        &self,
        program: &Program,
        variable: VariableId,
        extent: Extent,
    ) -> Option<ExprId> {
        let all = self.all(variable);
        let extent_of = |e: &ExprId| program.tree.expr(*e).extent;
        let next = all.partition_point(|e| extent_of(e).last < extent.first);
        let next = all.get(next).filter(|e| extent_of(e).first <= extent.last);
        next.copied()
    }

    /// Whether a variable is used in a token range.
    pub fn is_in(&self, program: &Program, variable: VariableId, extent: Extent) -> bool {
        self.first_in(program, variable, extent).is_some()
    }
}
