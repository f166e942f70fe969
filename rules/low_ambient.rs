//! Too little light in the shade, indoors and at sunset.

use crate::diagnostic::Severity;
use crate::lint::light::{INDOORS, given, has_word, named};
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting};
use crate::text::Span;

pub static RULE: Rule = Rule {
    name: "low-ambient",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[
        RuleOption::Number(&LEAST_INDOORS),
        RuleOption::Number(&LEAST_SUNSET),
    ],
    page: include_str!("low_ambient.md"),
    checks: &[Check::Program(check)],
};

static LEAST_INDOORS: Setting<f64> =
    Setting::new("indoors", 0.2, "Least ambient light in closed places");
static LEAST_SUNSET: Setting<f64> = Setting::new(
    "sunset",
    0.3,
    "Least ambient light where the sun stands low",
);

const SUNSET: &[&str] = &["sunset", "sunrise", "dusk", "dawn", "twilight"];

fn check(cx: &mut Context) {
    let program = cx.program;
    let dim: Vec<_> = given(cx)
        .into_iter()
        .filter(|g| has_word(g.name, &["ambient", "amb"]))
        .filter_map(|g| {
            let values: Vec<f64> = program
                .values(g.init)
                .iter()
                .map(|v| v.as_float() as f64)
                .collect();
            let is_light = matches!(values.len(), 1 | 3);
            is_light.then(|| (g, values.iter().sum::<f64>() / values.len() as f64))
        })
        .filter(|(_, light)| *light < cx.option(&LEAST_INDOORS).max(cx.option(&LEAST_SUNSET)))
        .collect();
    if dim.is_empty() {
        return;
    }
    let sunset = named(cx, SUNSET).or_else(|| remarked(cx, SUNSET));
    let (place, least, shown) = match (sunset, named(cx, INDOORS)) {
        (Some(shown), _) => ("at sunset", cx.option(&LEAST_SUNSET), shown),
        (None, Some(shown)) => ("indoors", cx.option(&LEAST_INDOORS), shown),
        (None, None) => return,
    };
    for (given, light) in dim.into_iter().filter(|(_, light)| *light < least) {
        cx.report_expr(
            given.init,
            format!("`{}` is {light:.2}; {place} it takes {least}", given.name),
        )
        .label(shown, format!("read from here: {place}"))
        .note("what the sun does not reach is lit by nothing else, and becomes black")
        .help(format!("take at least `vec3({least})`"));
    }
}

/// A comment that has one of these words.
fn remarked(cx: &Context, wanted: &[&str]) -> Option<Span> {
    let program = cx.program;
    let mut comments = program.tokens.comments.iter().copied();
    comments.find(|c| program.is_user(*c) && has_word(program.sources.text(*c), wanted))
}
