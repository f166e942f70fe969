//! Well-known numbers with wrong digits.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, Shape};
use crate::syntax::ast::ExprId;
use crate::text::Edit;
use std::f64::consts::{E, FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};

pub static RULE: Rule = Rule {
    name: "mistyped-constant",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("mistyped_constant.md"),
    checks: &[Check::Expr(&[Shape::FloatLiteral], check)],
};

/// A number, what it is, and how many of its digits tell that it is meant.
const KNOWN: &[(f64, &str, usize)] = &[
    (PI, "π", 3),
    (TAU, "2π", 3),
    (FRAC_PI_2, "π/2", 6),
    (FRAC_1_PI, "1/π", 5),
    (E, "e", 4),
    (1.618_033_988_749_895, "the golden ratio", 4),
    (SQRT_2, "√2", 5),
    (57.295_779_513_082_32, "180/π", 4),
    (0.017_453_292_519_943_295, "π/180", 4),
];

/// Digits that a `float` can hold.
const EXACT: usize = 8;

fn check(cx: &mut Context, id: ExprId) {
    let text = cx.program.expr_text(id);
    let number = text.trim_end_matches(['f', 'F']);
    if number.contains(['e', 'E']) {
        return;
    }
    let Some((whole, fraction)) = number.split_once('.') else {
        return;
    };
    let Ok(written) = number.parse::<f64>() else {
        return;
    };
    // Nearly all numbers are far from all that are known.
    let is_near = |value: f64| (written - value).abs() < value * 0.01;
    if !KNOWN.iter().any(|(value, ..)| is_near(*value)) {
        return;
    }
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0').to_string();
    let found = KNOWN.iter().find_map(|&(value, name, telling)| {
        let right = format!("{value:.20}").replace('.', "");
        let right = right.trim_start_matches('0').to_string();
        let same = digits
            .bytes()
            .zip(right.bytes())
            .take_while(|(a, b)| a == b)
            .count();
        let is_meant = same >= telling && digits.len() >= same + 2 && same < EXACT - 1;
        // The last digit may be rounded up or cut off.
        let unit = 10f64.powi(-(fraction.len() as i32));
        let is_right = (written - value).abs() < unit.max(value * 2e-7);
        (is_meant && !is_right && is_near(value)).then_some((value, name))
    });
    let Some((value, name)) = found else { return };
    let right = format!("{value:.8}");
    let fix = cx.is_direct(id).then(|| {
        let edit = Edit::replace(cx.program.expr_span(id), right.clone());
        Fix::suggestion(format!("write `{right}`"), vec![edit])
    });
    cx.report_expr(id, format!("`{text}` is almost {name}, which is {right}"))
        .fix(fix);
}
