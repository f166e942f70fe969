//! Shadow loops that continue after the light is blocked.

use shaderlint_lint::march::MarchGoal;
use shaderlint_lint::prelude::*;

rule! { shadow_steps, Budget, Info, Recommended, [Count(&STEPS)], Program(check) }

static STEPS: Setting<u64> = Setting::new(
    "steps",
    32,
    "Maximum steps of a shadow loop without an early exit",
)
.on_swiftshader(16);

fn check(cx: &mut Context) {
    let most = cx.option(&STEPS);
    let facts = cx.facts;
    for march in facts.marches() {
        let looped = march.looped;
        let (Some(iterations), MarchGoal::Shadow, false) =
            (looped.bound.iterations(), march.goal, looped.ends_early)
        else {
            continue;
        };
        if iterations <= most {
            continue;
        }
        let head = Extent::token(cx.program.tree.stmt(looped.stmt).extent.first);
        cx.report(
            head,
            format!("shadow loop always runs all {iterations} steps"),
        )
        .note("once the light is blocked, further steps change nothing")
        .help("add an early exit: `if (h < 0.001) return 0.0;` or `if (res < 0.004) break;`");
    }
}
