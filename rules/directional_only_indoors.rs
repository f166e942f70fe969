//! Closed places that only the sun would light.

use crate::diagnostic::Severity;
use crate::lint::light::{INDOORS, given, has_word, named, words};
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::BuiltinId;
use crate::syntax::ast::Extent;

pub static RULE: Rule = Rule {
    name: "directional-only-indoors",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[],
    page: include_str!("directional_only_indoors.md"),
    checks: &[Check::Program(check)],
};

/// What a light inside is known by.
const INSIDE: &[&str] = &[
    "point",
    "torch",
    "torches",
    "lamp",
    "lantern",
    "candle",
    "attenuation",
    "atten",
    "att",
    "falloff",
    "emissive",
    "emission",
    "glow",
    "flicker",
];

fn check(cx: &mut Context) {
    let program = cx.program;
    let mut suns = given(cx).into_iter().filter(|g| {
        let is_direction = program.ty(g.init).components() == 3 && is_sun(g.name);
        is_direction
            && program.builtin_called(program.tree.unparen(g.init)) == Some(BuiltinId::Normalize)
            && program.expr(g.init).is_const
    });
    let Some(sun) = suns.next() else {
        return;
    };
    let Some(place) = named(cx, INDOORS) else {
        return;
    };
    let mut places = given(cx).into_iter();
    let has_lamp = places.any(|g| {
        let words = words(g.name);
        let has = |w: &str| words.iter().any(|x| x == w);
        (has("light") || has("lamp")) && (has("pos") || has("position"))
    });
    if has_lamp || named(cx, INSIDE).is_some() {
        return;
    }
    cx.report(
        Extent::token(sun.token),
        format!("`{}` is the only light of a closed place", sun.name),
    )
    .label(place, "closed, by its name")
    .note("walls and ceiling keep it out, and everything is black")
    .help("add lights inside, `1.0 / (1.0 + 0.1 * d + 0.01 * d * d)` strong at distance `d`, and ambient light of 0.2 or more");
}

fn is_sun(name: &str) -> bool {
    has_word(name, &["sun", "sundir", "light", "lightdir"])
        && (has_word(name, &["dir", "direction", "sundir", "lightdir"]))
}
