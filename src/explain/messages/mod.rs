//! Messages: the diagnostic for each problem that the checker found, and its fix.
//!
//! `typing` and `checker` report problems as data; [`explain()`] turns those that are to be shown
//! into diagnostics. The messages for an error enum of the checker are in the file of the same name
//! here. Everything else they need comes from the program, in the state in which the checker met
//! the problem.

mod calls;
mod context;
mod declarations;
mod expressions;
mod extension;
mod foreign;
mod limits;
mod names;
mod problem;
mod statement;
mod switch;
#[cfg(test)]
mod tests;
mod version;
mod webgl1;

use context::ExplainContext;
use expressions::arguments::joined_title;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Fix, error};
use shaderlint_semantic::builtins::{Builtins, MAX_PARAMS};
use shaderlint_semantic::parsed::{Typed, is_decimal, own_name};
use shaderlint_semantic::problem::*;
use shaderlint_semantic::scope::Binding;
use shaderlint_semantic::typing::{self, Clash, NonNumber, TypeMismatch};
use shaderlint_semantic::*;
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{ExactPlace, Feature, Name, Token, TokenKind, Version};
use shaderlint_text::{Edit, Span};

/// Note on every mix of types.
const NO_CONVERSION: &str = "GLSL ES has no implicit conversions (section 4.1.10)";

/// A problem that can be turned into a diagnostic.
trait Explain {
    /// The diagnostic at `at`.
    fn explain(self, context: &ExplainContext, at: Extent) -> Diagnostic;
}

/// Turns all problems of a shader into diagnostics.
pub(super) fn explain(program: &Program, problems: &Problems) -> Vec<Diagnostic> {
    let mut context = ExplainContext::new(program, problems);
    let mut all = Vec::with_capacity(problems.len());
    for problem in &problems.all {
        context.go_to(problem.moment);
        let mut d = problem.what.clone().explain(&context, problem.at);
        // A fix is dropped unless all its edits are in the user's own text, outside macros.
        if let Some(fix) = &d.fix
            && fix.edits.iter().any(|e| !context.is_editable(e.span))
        {
            d.fix = None;
        }
        for &aside in &problem.asides {
            context.add(&mut d, aside, problem.at);
        }
        all.push(d);
    }
    all
}

impl ExplainContext<'_> {
    /// Adds what the checker learned about a problem after reporting it.
    fn add(&self, d: &mut Diagnostic, aside: Aside, at: Extent) {
        match aside {
            Aside::Used(1) => d.notes.push("also used in 1 other place".to_string()),
            Aside::Used(uses) => d.notes.push(format!("also used in {uses} other places")),
            Aside::SetTo(ty) if d.is(error::UNDECLARED_NAME) => {
                let name = Name(self.token(at.first).value);
                let fix = self.declaration_where_set(name, at.first, ty);
                d.fix = fix.or(d.fix.take());
            }
            Aside::SetTo(_) => {}
            Aside::Second(second) => d.fix = self.second_declaration(second),
            Aside::Argument(direction) => d.notes.push(format!(
                "the parameter is `{direction}`, so the function writes to its argument"
            )),
        }
    }
}
