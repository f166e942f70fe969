//! Well-known numbers with wrong digits.

use shaderlint_lint::prelude::*;
use std::f64::consts::{E, FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};

rule! { mistyped_constant, Numeric, Warning, Recommended, Expr(&[Shape::FloatLiteral], check) }

/// A constant, its name, and the number of leading digits that identify it.
const KNOWN: &[(f64, &str, usize)] = &[
    (PI, "π", 3),
    (TAU, "2π", 3),
    (FRAC_PI_2, "π/2", 6),
    (FRAC_1_PI, "1/π", 5),
    (E, "e", 4),
    (1.618_033_988_749_895, "golden ratio", 4),
    (SQRT_2, "√2", 5),
    (57.295_779_513_082_32, "180/π", 4),
    (0.017_453_292_519_943_295, "π/180", 4),
];

/// Decimal digits that a `float` can hold.
const EXACT: usize = 8;

fn check(cx: &mut Context, id: ExprId) {
    let ExprKind::Float(number) = cx.program.tree.expr(id).kind else {
        return;
    };
    // Cheap test first: nearly all literals are far from every constant.
    let number = f64::from(number);
    let is_near = |(value, ..): &&(f64, &str, usize)| (number - value).abs() < value * 0.01;
    let Some(&(value, name, significant)) = KNOWN.iter().find(is_near) else {
        return;
    };
    let text = cx.program.expr_text(id);
    if !is_typo(text, value, significant) {
        return;
    }
    let right = format!("{value:.8}");
    let fix = cx.suggest(id, right.as_str());
    cx.report_expr(
        id,
        format!("`{text}` looks like a mistyped {name} ({right})"),
    )
    .fix(fix);
}

/// Whether a literal begins with the digits of a constant, continues with other digits, and is
/// neither that constant truncated nor rounded.
fn is_typo(text: &str, value: f64, significant: usize) -> bool {
    let text = text.trim_end_matches(['f', 'F']);
    let Some((integer, fraction)) = text.split_once('.').filter(|_| !text.contains(['e', 'E']))
    else {
        return false;
    };
    let Ok(written) = text.parse::<f64>() else {
        return false;
    };
    let digits = format!("{integer}{fraction}");
    let digits = digits.trim_start_matches('0');
    let right = format!("{value:.20}").replace('.', "");
    let right = right.trim_start_matches('0');
    let pairs = digits.bytes().zip(right.bytes());
    let same = pairs.take_while(|(a, b)| a == b).count();
    // The last digit may be rounded up or truncated.
    let unit = 10f64.powi(-(fraction.len() as i32));
    let is_right = (written - value).abs() < unit.max(value * 2e-7);
    same >= significant && digits.len() >= same + 2 && same < EXACT - 1 && !is_right
}
