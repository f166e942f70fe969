//! Shadow loops that go on behind the first thing that they meet.

use crate::diagnostic::Severity;
use crate::lint::march::Role;
use crate::lint::{Check, Context, Group, Rule, RuleOption};
use crate::syntax::ast::Extent;

pub static RULE: Rule = Rule {
    name: "shadow-steps",
    group: Group::Budget,
    severity: Severity::Warning,
    default: true,
    options: &[RuleOption {
        name: "steps",
        default: 16.0,
        on_gpu: 64.0,
        about: "Most steps of a shadow loop that never stops early",
    }],
    page: include_str!("shadow_steps.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let most = cx.option("steps");
    let facts = cx.facts;
    for march in facts.marches() {
        let looped = march.looped;
        let (Some(turns), Role::Shadow, false) =
            (looped.bound.turns(), march.role, looped.ends_early)
        else {
            continue;
        };
        if turns as f64 <= most {
            continue;
        }
        let head = Extent::token(cx.program.tree.stmt(looped.stmt).extent.first);
        cx.report(
            head,
            format!("the shadow loop always takes all {turns} steps"),
        )
        .note("once the light is hidden, more steps change nothing")
        .help("stop there: `if (h < 0.001) return 0.0;`, or `if (res < 0.004) break;`");
    }
}
