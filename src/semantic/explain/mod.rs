//! Words: what is said of what does not fit, and the edit that mends it.
//!
//! `typing` and `checker` decide; what stands here turns a [`Misfit`] or one of the checker's enums
//! into a message, each enum in the file that is called as the one it stands in. It reads what the
//! checker found out so far, and changes nothing of it.

mod arguments;
mod array;
mod call;
mod calls;
mod constant;
mod construct;
mod declare;
mod entry;
mod foreign;
mod function;
mod interface;
mod layout;
mod limits;
mod member;
mod names;
mod operator;
mod output;
mod place;
mod qualifier;
mod record;
mod resize;
mod statement;
mod switch;
#[cfg(test)]
mod tests;
mod value;
mod version;
mod webgl1;

pub(crate) use names::note_uses;
pub(crate) use place::note_written;

use super::builtins::{Builtins, MAX_PARAMS, Stage};
use super::checker::*;
use super::host::EntryPoint;
use super::program::*;
use super::scope::Binding;
use super::types::*;
use super::typing::{self, Clash, Misfit, NonNumber};
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Fix, error};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Feature, Name, Token, TokenKind, Version};
use shaderlint_text::{Edit, Span};

/// What holds for every value.
const NO_CONVERSION: &str = "GLSL ES converts nothing by itself (section 4.1.10)";

/// Something that is wrong, as data, of which words can be made.
pub(crate) trait Explain: std::fmt::Debug {
    /// What to say of it.
    fn explain(self, checker: &Checker, at: Extent) -> Diagnostic;
}

impl Checker<'_> {
    /// What to say of an expression that does not fit. `parts` are its operands or arguments, as
    /// the misfit numbers them.
    pub(crate) fn explain(&self, id: ExprId, parts: &[ExprId], misfit: Misfit) -> Diagnostic {
        use Misfit as M;
        let part = |number: usize| parts.get(number).copied().unwrap_or(id);
        match misfit {
            M::Void(number) => self.explain_void(part(number)),
            M::Operand(ty) => self.explain_operand(id, part(0), ty),
            M::Operands(clash) => self.explain_operands(id, part(0), part(1), clash),
            M::Value(clash) => self.explain_assignment(id, part(0), part(1), clash),
            M::Condition(ty) => self.explain_condition(part(0), ty, Condition::Choice),
            M::Arms => self.explain_arms(id, part(0), part(1)),
            M::Unchosen(kind) => self.explain_unchosen(id, kind),
            M::Sequence => self.explain_sequence(id),
            M::NoMembers(_) | M::ArrayMember | M::Letters(_) | M::Component(..) | M::Field(_) => {
                self.explain_member(id, part(0), misfit)
            }
            M::NoElements(ty) => self.explain_no_elements(id, ty),
            M::Index(ty) => self.explain_index(part(1), ty),
            M::NotConstructible(_)
            | M::NoArguments(_)
            | M::SamplerArgument(_)
            | M::Count(_)
            | M::Part(..)
            | M::NoNumber(..)
            | M::MatrixBeside
            | M::TooFew(..)
            | M::TooMany(..) => self.explain_construction(id, parts, misfit),
            M::NothingReturned(_) | M::ValueReturned | M::Returned(_) => {
                self.explain_return(parts.first().copied(), self.tree.expr(id).extent, misfit)
            }
        }
    }

    /// A value of type `void` where one is needed.
    pub(crate) fn explain_void(&self, id: ExprId) -> Diagnostic {
        let message = "this has no value: its type is `void`";
        self.error_expr(error::VOID_VALUE, id, message)
    }
}
