//! Materials that are nearly white or gray.

use crate::diagnostic::Severity;
use crate::lint::light::{color, has_word, name_of};
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting, Shape};
use crate::syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "gray-material",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[
        RuleOption::Number(&SATURATION),
        RuleOption::Number(&BRIGHTNESS),
        RuleOption::Number(&LEAST_GREEN),
    ],
    page: include_str!("gray_material.md"),
    checks: &[Check::Expr(&[Shape::Construct], check)],
};

static SATURATION: Setting<f64> = Setting::new(
    "saturation",
    0.03,
    "Smallest saturation of a bright material",
);
static BRIGHTNESS: Setting<f64> = Setting::new(
    "brightness",
    0.7,
    "Smallest brightness of a material that counts as bright",
);
static LEAST_GREEN: Setting<f64> =
    Setting::new("green", 0.4, "Smallest saturation of grass and leaves");

const MATERIALS: &[&str] = &[
    "material", "mat", "albedo", "wall", "brick", "bricks", "stone", "wood", "dirt", "roof",
    "rock", "sand", "earth",
];
const GREEN: &[&str] = &["grass", "leaf", "leaves", "foliage"];
const WHITE: &[&str] = &[
    "snow", "cloud", "foam", "white", "splash", "ice", "gray", "grey",
];

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    if !matches!(program.tree.expr(id).kind, ExprKind::Construct(..)) {
        return;
    }
    let Some([r, g, b]) = color(program, id) else {
        return;
    };
    let (high, low) = (r.max(g).max(b), r.min(g).min(b));
    if high <= 0.0 || high > 1.0 {
        return;
    }
    let saturation = (high - low) / high;
    let Some(name) = painted(cx, id) else {
        return;
    };
    let is_gray = has_word(name, MATERIALS)
        && saturation <= cx.option(&SATURATION)
        && low >= cx.option(&BRIGHTNESS);
    let is_dull = has_word(name, GREEN) && saturation < cx.option(&LEAST_GREEN);
    if has_word(name, WHITE) || !(is_gray || is_dull) {
        return;
    }
    let percent = (saturation * 100.0).round();
    let finding = cx
        .report_expr(
            id,
            format!("the material `{name}` is almost without colour"),
        )
        .mark(format!("{percent} % saturated"))
        .note("light and gamma correction take more of it, and what is left is white or gray");
    finding.help(if is_dull {
        "take a clear green: `vec3(0.25, 0.55, 0.15)`"
    } else {
        "a dull colour still has a hue: brick red is `vec3(0.55, 0.35, 0.3)`"
    });
}

/// What is painted with a colour: the variable that it is given to, or the function that gives it
/// back, or whose variable it is given to.
fn painted<'a>(cx: &Context<'_, 'a>, id: ExprId) -> Option<&'a str> {
    let program = cx.program;
    let structure = cx.facts.structure();
    let stmt = structure.stmt_of(id)?;
    let function = program.function(structure.function_of(stmt)?)?;
    let function = program.names.text(function.name);
    let known = |name: &str| has_word(name, MATERIALS) || has_word(name, GREEN);
    let target = match structure.parent(id) {
        Some(parent) => match program.tree.expr(parent).kind {
            ExprKind::Assign(None, target, value) if value == id => name_of(program, target)?,
            _ => return None,
        },
        None => match program.tree.stmt(stmt).kind {
            StmtKind::Return(_) => function,
            StmtKind::Decl(decl) => {
                let DeclKind::Variables { declarators, .. } = program.tree.decl(decl)?.kind else {
                    return None;
                };
                let mut all = program.tree.declarators(declarators).iter();
                let found = all.find(|d| d.init == Some(id))?;
                program.names.text(found.ident.name)
            }
            _ => return None,
        },
    };
    Some(if known(target) || has_word(target, WHITE) {
        target
    } else {
        function
    })
}
