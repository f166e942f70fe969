//! Lights so bright that all colours become white.

use crate::diagnostic::Severity;
use crate::lint::light::{factors, has_word, name_of, terms};
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting, Shape};
use crate::semantic::root;
use crate::semantic::{BuiltinId, Program};
use crate::syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "bright-light",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[RuleOption::Number(&MOST_SUN), RuleOption::Number(&MOST_SKY)],
    page: include_str!("bright_light.md"),
    checks: &[Check::Expr(&[Shape::Assign], check)],
};

static MOST_SUN: Setting<f64> = Setting::new("sun", 2.0, "Brightest light of the sun");
static MOST_SKY: Setting<f64> = Setting::new("sky", 1.0, "Brightest light of the sky");

const SUM: &[&str] = &["lighting", "lin", "light", "lights", "illumination"];
const SUN: &[&str] = &["sun", "dif", "diff", "diffuse", "ndotl", "key"];
const SKY: &[&str] = &["sky", "hemi", "hemisphere", "dome"];
/// What makes a lamp of it, which may be brighter close by.
const LAMP: &[&str] = &[
    "att",
    "atten",
    "attenuation",
    "falloff",
    "point",
    "torch",
    "lamp",
    "spec",
    "specular",
    "spe",
];

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Assign(None | Some(BinaryOp::Add), target, value) = program.tree.expr(id).kind
    else {
        return;
    };
    let is_sum = name_of(program, target).is_some_and(|n| has_word(n, SUM));
    if !is_sum || program.expr(id).is_const || maps_tones(program) {
        return;
    }
    for term in terms(program, value) {
        light(cx, term);
    }
}

/// A term of the light: numbers and colours times what they shine on.
fn light(cx: &mut Context, term: ExprId) {
    let program = cx.program;
    let factors = factors(program, term);
    let names: Vec<&str> = factors
        .iter()
        .filter_map(|f| name_of(program, *f))
        .collect();
    let is = |words: &[&str]| names.iter().any(|n| has_word(n, words));
    if is(LAMP) {
        return;
    }
    let (what, most) = if is(SKY) {
        ("sky", cx.option(&MOST_SKY))
    } else if is(SUN) {
        ("sun", cx.option(&MOST_SUN))
    } else {
        return;
    };
    let strength: f64 = factors
        .iter()
        .filter_map(|f| {
            let values = program.values(*f).iter().map(|v| v.as_float() as f64);
            values.reduce(f64::max)
        })
        .product();
    if strength > most * 1.0001 {
        cx.report_expr(
            term,
            format!("the light of the {what} is {strength:.1} strong; {most:.1} is the most"),
        )
        .note("brighter light washes the colours of all materials out to white")
        .help(format!(
            "take at most {most:.1}, or map the tones at the end: `col = col / (1.0 + col)`"
        ));
    }
}

/// Whether the shader brings bright colours back into range at the end.
fn maps_tones(program: &Program) -> bool {
    let by_name = program.functions.iter().any(|f| {
        let name = program.names.text(f.name).to_lowercase();
        [
            "aces",
            "tonemap",
            "tone_map",
            "filmic",
            "reinhard",
            "uncharted",
            "agx",
        ]
        .iter()
        .any(|n| name.contains(n))
    });
    by_name
        || program
            .tree
            .exprs
            .iter()
            .enumerate()
            .any(|(i, e)| maps(program, ExprId(i as u32), e))
}

/// `c / (1.0 + c)` or `1.0 - exp(-c)` of a colour.
fn maps(program: &Program, id: ExprId, expr: &Expr) -> bool {
    if !program.ty(id).is_vector() || program.ty(id).components() < 3 {
        return false;
    }
    match expr.kind {
        ExprKind::Binary(BinaryOp::Div, color, by) => {
            let same = root(program, color);
            same.is_some() && terms(program, by).iter().any(|t| root(program, *t) == same)
        }
        ExprKind::Binary(BinaryOp::Sub, _, e) => {
            program.builtin_called(program.tree.unparen(e)) == Some(BuiltinId::Exp)
        }
        _ => false,
    }
}
