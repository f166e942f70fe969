//! Bands of colour by height that are too narrow, or of another height.

use crate::diagnostic::Severity;
use crate::lint::light::{factors, has_word, name_of, words};
use crate::lint::{BinaryExpr, Check, Context, Group, Rule, RuleOption, Setting};
use crate::semantic::{BuiltinId, FunctionRef};
use crate::syntax::ast::*;
use std::collections::BTreeMap;

pub static RULE: Rule = Rule {
    name: "height-band-spacing",
    group: Group::Look,
    severity: Severity::Warning,
    default: false,
    options: &[RuleOption::Number(&SPACING)],
    page: include_str!("height_band_spacing.md"),
    checks: &[Check::Program(bands), Check::Binary(heights)],
};

static SPACING: Setting<f64> = Setting::new(
    "spacing",
    0.2,
    "Least distance of two thresholds of a height from 0 to 1",
);

/// Comparisons of one ratio with numbers that lie close together.
fn bands(cx: &mut Context) {
    let program = cx.program;
    let structure = cx.facts.structure();
    let mut found: BTreeMap<(FunctionRef, &str), Vec<(f64, ExprId)>> = BTreeMap::new();
    for (i, expr) in program.tree.exprs.iter().enumerate() {
        let ExprKind::Binary(
            BinaryOp::Less | BinaryOp::LessEqual | BinaryOp::Greater | BinaryOp::GreaterEqual,
            a,
            b,
        ) = expr.kind
        else {
            continue;
        };
        let (Some(name), Some(value)) = (name_of(program, a), program.scalar(b)) else {
            continue;
        };
        let value = value.as_float() as f64;
        let is_ratio = has_word(name, &["ratio", "normalized", "norm", "frac"])
            && (0.0..=1.0).contains(&value);
        if let Some(function) = structure
            .function_of_expr(ExprId(i as u32))
            .filter(|_| is_ratio)
        {
            found.entry((function, name)).or_default().push((value, b));
        }
    }
    let least = cx.option(&SPACING);
    for ((_, name), mut thresholds) in found {
        thresholds.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in thresholds.windows(2) {
            let &[(low, before), (high, at)] = pair else {
                continue;
            };
            let distance = high - low;
            // Twice the same is one threshold.
            if distance < 1e-6 || distance + 1e-6 >= least {
                continue;
            }
            let before = program.expr_span(before);
            cx.report_expr(
                at,
                format!("the band of `{name}` from {low:.2} to {high:.2} is too narrow"),
            )
            .label(before, "it starts here")
            .note("few pixels lie in it, so that its colour is not seen")
            .help(format!(
                "keep thresholds {least} apart: `0.4` for grass and `0.7` for rock"
            ));
        }
    }
}

/// `y / maxH` beside a height function that reaches another height.
fn heights(cx: &mut Context, ratio: &BinaryExpr) {
    let program = cx.program;
    let calls = cx.facts.calls();
    let by = ratio.right;
    let name = name_of(program, by).filter(|n| ratio.op == BinaryOp::Div && is_max_height(n));
    let function = cx.facts.structure().function_of_expr(ratio.id);
    let (Some(name), Some(function)) = (name, function) else {
        return;
    };
    let Some(taken) = number(cx, by) else {
        return;
    };
    let reached = calls.calls_by(function).find_map(|c| {
        let called = program.function(c.callee)?;
        let text = program.names.text(called.name);
        let is_height = has_word(text, &["height", "terrain", "mountain", "elevation"]);
        let reached = is_height.then(|| highest(cx, c.callee))??;
        Some((text, reached, program.expr_span(c.expr)))
    });
    let Some((called, reached, span)) = reached else {
        return;
    };
    if (taken - reached).abs() > 0.01 * reached.abs() {
        cx.report_expr(
            by,
            format!("`{name}` is {taken}, but `{called}` reaches {reached}"),
        )
        .label(span, "the height comes from here")
        .note("the bands of colour lie where the ground is not")
        .help(format!("make `{name}` {reached:?}"));
    }
}

fn is_max_height(name: &str) -> bool {
    let words = words(name);
    let has = |w: &str| words.iter().any(|x| x == w);
    has("max") && (has("h") || has("height"))
}

/// The most that a height function gives back: the number that its noise is scaled by, or that it
/// is cut off at.
fn highest(cx: &Context, function: FunctionRef) -> Option<f64> {
    let program = cx.program;
    let decl = program
        .tree
        .function(program.function(function)?.definition?)?;
    let body = program.tree.stmt(decl.body?);
    let StmtKind::Block(list) = body.kind else {
        return None;
    };
    let StmtKind::Return(Some(value)) = program.tree.stmt(*program.tree.block(list).last()?).kind
    else {
        return None;
    };
    let value = program.tree.unparen(value);
    if let (Some(BuiltinId::Clamp | BuiltinId::Min), ExprKind::Call(_, args)) =
        (program.builtin_called(value), program.tree.expr(value).kind)
    {
        return number(cx, *program.tree.args(args).last()?);
    }
    let numbers: Vec<f64> = factors(program, value)
        .iter()
        .filter_map(|f| number(cx, *f))
        .collect();
    match numbers.as_slice() {
        &[one] if one > 1.0 => Some(one),
        _ => None,
    }
}

/// The one number that an expression may be.
fn number(cx: &Context, expr: ExprId) -> Option<f64> {
    cx.facts.range(expr).next()?.single()
}
