//! Words: what is said of what does not fit, and the edit that mends it.
//!
//! `typing` and `checker` decide, and leave what is wrong as data; [`explain()`] makes messages of it
//! once it is chosen what is to be said. Each of the checker's enums has its words in the file that is
//! called as the one it stands in. What they need besides is in the program, as far as the checker
//! knew it when it met the problem.

mod arguments;
mod array;
mod assign;
mod call;
mod calls;
mod constant;
mod construct;
mod context;
mod declare;
mod entry;
mod expression;
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
mod problem;
mod qualifier;
mod record;
mod resize;
mod statement;
mod switch;
#[cfg(test)]
mod tests;
mod version;
mod webgl1;

use super::builtins::{Builtins, MAX_PARAMS, Stage};
use super::checker::*;
use super::parsed::Typed;
use super::program::*;
use super::scope::Binding;
use super::types::*;
use super::typing::{self, Clash, Misfit, NonNumber};
use context::ExplainContext;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Fix, error};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Feature, Name, Token, TokenKind, Version};
use shaderlint_text::{Edit, Span};

/// What holds for every value.
const NO_CONVERSION: &str = "GLSL ES converts nothing by itself (section 4.1.10)";

/// Something that is wrong, as data, of which words can be made.
trait Explain {
    /// What to say of it.
    fn explain(self, context: &ExplainContext, at: Extent) -> Diagnostic;
}

/// Makes words of all that is wrong with a shader.
pub(super) fn explain(program: &Program, problems: &Problems) -> Vec<Diagnostic> {
    let mut context = ExplainContext::new(program, problems);
    let mut all = Vec::with_capacity(problems.len());
    for problem in &problems.all {
        context.go_to(problem.moment);
        let mut d = problem.what.clone().explain(&context, problem.at);
        // A fix whose edits do not stand in the user's own text just so is dropped.
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
    /// Adds to what is said of a problem what came to be known of it later.
    fn add(&self, d: &mut Diagnostic, aside: Aside, at: Extent) {
        match aside {
            Aside::Used(1) => d.notes.push("it is used once more".to_string()),
            Aside::Used(uses) => d.notes.push(format!("it is used {uses} times more")),
            Aside::SetTo(ty) if d.is(error::UNDECLARED_NAME) => {
                let name = Name(self.token(at.first).value);
                let fix = self.declaration_where_set(name, at.first, ty);
                d.fix = fix.or(d.fix.take());
            }
            Aside::SetTo(_) => {}
            Aside::Second(second) => d.fix = self.second_declaration(second),
            Aside::Argument(direction) => d.notes.push(format!(
                "the parameter is `{direction}`: the function writes to it"
            )),
        }
    }
}
