//! Ray marching loops that take more steps than a software renderer can.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "step-budget",
    group: Group::Budget,
    severity: Severity::Warning,
    default: true,
    page: include_str!("step_budget.md"),
    check: Check::Program(check),
};

fn check(_cx: &mut Context) {}
