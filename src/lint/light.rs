//! What names and numbers of a shader say about its lights and colours.

use super::run::declared_names;
use super::{Context, DeclaredName, Named};
use crate::semantic::Program;
use crate::syntax::ast::*;
use crate::text::Span;

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
pub fn name_of(program: &Program, expr: ExprId) -> Option<&str> {
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

/// A name of the user's text that has one of these words, and where it is declared.
pub fn named(cx: &Context, wanted: &[&str]) -> Option<Span> {
    let program = cx.program;
    let is_it = |n: &&DeclaredName| n.what != Named::Struct && has_word(n.text, wanted);
    let names = declared_names(program);
    let found = names
        .iter()
        .find(is_it)
        .and_then(|n| program.token(n.token));
    let mut macros = program.tokens.macros.iter().map(|m| m.name_span);
    found.map(|token| token.span).or_else(|| {
        macros.find(|s| program.is_user(*s) && has_word(program.sources.text(*s), wanted))
    })
}

/// Words for places without a sky.
pub const INDOORS: &[&str] = &[
    "cave",
    "cavern",
    "indoor",
    "indoors",
    "interior",
    "room",
    "dungeon",
    "tunnel",
    "corridor",
    "underground",
    "maze",
    "hallway",
    "basement",
    "ceiling",
];

/// A declarator whose first value is known when the shader is read: its variable's name, and the
/// value.
pub struct Given<'a> {
    /// The name.
    pub name: &'a str,
    /// Its token.
    pub token: TokenId,
    /// The first value.
    pub init: ExprId,
}

/// The declarators of the user's text that have a first value.
pub fn given<'a>(cx: &Context<'_, 'a>) -> Vec<Given<'a>> {
    let all = cx.program.tree.declarator_lists.iter();
    all.filter_map(|d| {
        let token = d.ident.token;
        let found = cx.program.token(token).filter(|t| t.is_direct())?;
        cx.program.is_user(found.span).then_some(Given {
            name: cx.program.sources.text(found.span),
            token,
            init: d.init?,
        })
    })
    .collect()
}

/// The operands of a sum, taken apart.
pub fn terms(program: &Program, expr: ExprId) -> Vec<ExprId> {
    let tree = &program.tree;
    let mut terms = Vec::new();
    let mut todo = vec![expr];
    while let Some(e) = todo.pop() {
        match tree.expr(tree.unparen(e)).kind {
            ExprKind::Binary(BinaryOp::Add, a, b) => todo.extend([b, a]),
            _ => terms.push(tree.unparen(e)),
        }
    }
    terms
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
