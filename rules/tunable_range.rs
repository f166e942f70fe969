//! Numbers outside the range documented in their comment.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::tunable::tunables;

rule! { tunable_range, Budget, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    for found in tunables(program) {
        let Some(range) = found.range else { continue };
        let ends = found.min.iter().zip(&found.max);
        let mut outside = found.value.iter().zip(ends);
        let outside = outside.find(|(value, (min, max))| !(**min..=**max).contains(*value));
        let Some((value, (min, max))) = outside else {
            continue;
        };
        let side = if value < min { "below" } else { "above" };
        let text = program.sources.text(found.value_span);
        cx.report_span(
            found.value_span,
            format!("`{text}` is {side} the range given in its comment"),
        )
        .label(range, "documented range")
        .help(format!(
            "use a value from {min} to {max}, or update the comment"
        ));
    }
}
