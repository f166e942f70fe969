//! What names and numbers of a shader say about its lights and colours.

use crate::semantic::Program;
use crate::syntax::ast::*;

/// The words of a name, in lower case: `sunColor2`, `SUN_COLOR` and `sun_color` all start with
/// `sun`.
pub fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut was_lower = false;
    for c in name.chars() {
        if !c.is_ascii_alphabetic() {
            was_lower = false;
            words.push(String::new());
            continue;
        }
        if words.is_empty() || (was_lower && c.is_ascii_uppercase()) {
            words.push(String::new());
        }
        if let Some(last) = words.last_mut() {
            last.push(c.to_ascii_lowercase());
        }
        was_lower = c.is_ascii_lowercase();
    }
    words.retain(|w| !w.is_empty());
    words
}

/// Whether one of the words of a name is one of these.
pub fn has_word(name: &str, wanted: &[&str]) -> bool {
    words(name).iter().any(|w| wanted.contains(&w.as_str()))
}

/// The colour that an expression is, if its three numbers are known: `vec3(0.5)`, or a constant.
pub fn color(program: &Program, expr: ExprId) -> Option<[f64; 3]> {
    match *program.values(expr) {
        [r, g, b] => Some([r, g, b].map(|v| v.as_float() as f64)),
        _ => None,
    }
}

/// The name that an expression is, a swizzle behind it left out: `sunColor` of `sunColor.rgb`.
pub fn name_of<'a>(program: &'a Program, expr: ExprId) -> Option<&'a str> {
    let mut at = program.tree.unparen(expr);
    while let ExprKind::Member(inner, field) = program.tree.expr(at).kind {
        if program.ty(program.tree.unparen(inner)).components() <= 1 {
            return Some(program.names.text(field));
        }
        at = program.tree.unparen(inner);
    }
    match program.tree.expr(at).kind {
        ExprKind::Name(name) => Some(program.names.text(name)),
        _ => None,
    }
}

/// The operands of a product, taken apart; a quotient's divisor and a sum are operands themselves.
pub fn factors(program: &Program, expr: ExprId) -> Vec<ExprId> {
    let tree = &program.tree;
    let mut factors = Vec::new();
    let mut todo = vec![expr];
    while let Some(e) = todo.pop() {
        match tree.expr(tree.unparen(e)).kind {
            ExprKind::Binary(BinaryOp::Mul, a, b) => todo.extend([b, a]),
            _ => factors.push(tree.unparen(e)),
        }
    }
    factors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fall_into_words() {
        assert_eq!(words("sunColor2"), ["sun", "color"]);
        assert_eq!(words("SUN_COL"), ["sun", "col"]);
        assert_eq!(words("ambientLight"), ["ambient", "light"]);
    }
}
