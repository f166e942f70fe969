//! Messages for [`ExpressionError`].

use crate::messages::*;

impl Explain for ExpressionError {
    fn explain(self, c: &ExplainContext, _: Extent) -> Diagnostic {
        use ExpressionError as E;
        match self {
            E::Misfit(id, parts, mismatch) => c.explain_mismatch(id, &parts, mismatch),
            E::Unsigned(id) => c.explain_unsigned(id),
            E::Suffix(id, end) => c.explain_suffix(id, end),
            E::Later(id) => c.explain_later(id),
            E::Method(id, object, name, args) => c.explain_method(id, object, name, args),
            E::MemberBehindComma(id) => c.explain_member_after_comma(id),
            E::IndexRange(object, index, value, size) => {
                c.explain_index_range(object, index, value, size)
            }
            E::DynamicIndex(id, what) => c.explain_dynamic_index(id, what),
        }
    }
}

impl ExplainContext<'_> {
    /// The message for a type error in an expression. `parts` are its operands or arguments, in the
    /// order in which the misfit numbers them.
    fn explain_mismatch(&self, id: ExprId, parts: &[ExprId], mismatch: TypeMismatch) -> Diagnostic {
        use TypeMismatch as M;
        let part = |number: usize| parts.get(number).copied().unwrap_or(id);
        match mismatch {
            M::Void(number) => self.explain_void(part(number)),
            M::Operand(ty) => self.explain_operand(id, part(0), ty),
            M::Operands(clash) => self.explain_operands(id, part(0), part(1), clash),
            M::Value(clash) => self.explain_assignment(id, part(0), part(1), clash),
            M::Condition(ty) => self.explain_condition(part(0), ty, Condition::Choice),
            M::Arms => self.explain_arms(id, part(0), part(1)),
            M::Unchosen(kind) => self.explain_unchosen(id, kind),
            M::Sequence => self.explain_sequence(id),
            M::NoMembers(_) | M::ArrayMember | M::Letters(_) | M::Component(..) | M::Field(_) => {
                self.explain_member(id, part(0), mismatch)
            }
            M::NoElements(ty) => self.explain_no_elements(id, ty),
            M::Index(ty) => self.explain_index(part(1), ty),
            M::NotConstructible(_)
            | M::NoArguments(_)
            | M::SamplerArgument(_)
            | M::Count(_)
            | M::Part(..)
            | M::NoNumber(..)
            | M::MatrixWithOthers
            | M::TooFew(..)
            | M::TooMany(..) => self.explain_construction(id, parts, mismatch),
            M::NothingReturned(_) | M::ValueReturned | M::Returned(_) => {
                self.explain_return(parts.first().copied(), self.tree.expr(id).extent, mismatch)
            }
        }
    }

    /// A value of type `void` where one is needed.
    pub(in crate::messages) fn explain_void(&self, id: ExprId) -> Diagnostic {
        let message = "expected a value, found `void`";
        self.error_expr(error::VOID_VALUE, id, message)
    }
}
