//! `p.x*p.x + p.x*p.x`: a component that was copied without being changed.

use shaderlint_lint::prelude::*;
use shaderlint_syntax::Token;

rule! {
    copied_component, Tidy, Warning, Recommended,
    Binary(check_sum), Expr(&[Shape::Construct], check_vector), Stmt(check_lines)
}

/// Component names, by naming set.
const SETS: [&str; 3] = ["xyzw", "rgba", "stpq"];

/// `f(p.x) + f(p.x)`
fn check_sum(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let tree = &program.tree;
    if e.op != BinaryOp::Add {
        return;
    }
    // The tree of a sum leans to the left.
    let (right, mut left) = (tree.unparen(e.right), tree.unparen(e.left));
    if let ExprKind::Binary(BinaryOp::Add, _, last) = tree.expr(left).kind {
        left = tree.unparen(last);
    }
    let [a, b] = [left, right].map(|id| tree.expr(id).extent);
    let is_work = matches!(
        tree.expr(right).kind,
        ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div, ..) | ExprKind::Call(..)
    );
    if !is_work || !same_code(program, a, b) || !cx.is_direct(e.id) {
        return;
    }
    let Some(name) = component_in(program, b).filter(|_| !cx.facts.effects().has(right)) else {
        return;
    };
    let text = program.expr_text(right);
    let place = program.span(a);
    let message = format!("`{text}` is added twice; did you mean another component than `{name}`?");
    cx.report(b, message).label(place, "same expression");
}

/// The component that all component accesses in the tokens name, if it is the same for all.
fn component_in(program: &Program, extent: Extent) -> Option<&str> {
    let mut all = (extent.first..=extent.last).filter_map(|t| component(program, t));
    let first = all.next()?;
    all.all(|next| next == first).then_some(first)
}

/// The component that a token names, if it is a single component after a dot.
fn component(program: &Program, token: TokenId) -> Option<&str> {
    let before = program.token(token.checked_sub(1)?)?;
    let name = program.token(token)?;
    let is_field = before.kind == TokenKind::Dot && name.kind == TokenKind::Identifier;
    let text = program.sources.text(name.span);
    let is_one = text.len() == 1 && SETS.iter().any(|s| s.contains(text));
    (is_field && is_one && name.is_direct()).then_some(text)
}

/// `vec3(f(p.x), f(p.y), f(p.y))`
fn check_vector(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let ExprKind::Construct(_, args) = tree.expr(id).kind else {
        return;
    };
    let args = tree.args(args);
    let ty = program.ty(id);
    let is_complete = ty.is_vector() && ty.components() as usize == args.len() && args.len() > 1;
    if !is_complete || !cx.is_direct(id) {
        return;
    }
    let extents: Vec<Extent> = args.iter().map(|a| tree.expr(*a).extent).collect();
    let letters: Vec<usize> = extents.iter().filter_map(|e| number(program, *e)).collect();
    let is_work = args.iter().all(|a| {
        matches!(
            tree.expr(tree.unparen(*a)).kind,
            ExprKind::Call(..) | ExprKind::Binary(..)
        )
    });
    let in_order = |n: usize| letters.iter().take(n).enumerate().all(|(i, l)| i == *l);
    let last = args.len() - 1;
    let is_copy = letters.len() == args.len()
        && in_order(last)
        && letters.get(last).copied() == last.checked_sub(1)
        && has_components(program, args.first().copied(), args.len());
    let Some((before, copy)) = extents.get(last - 1).zip(extents.get(last)) else {
        return;
    };
    if is_work && is_copy && same_code(program, *before, *copy) && are_alike(program, &extents) {
        let place = program.span(*before);
        cx.report(
            *copy,
            "the last component of this vector repeats the one before it",
        )
        .label(place, "may be copied from here");
    }
}

/// Whether every vector accessed in an argument has at least `count` components.
fn has_components(program: &Program, arg: Option<ExprId>, count: usize) -> bool {
    let tree = &program.tree;
    let Some(arg) = arg else { return false };
    let extent = tree.expr(arg).extent;
    let mut members = (0..=arg.0).rev().map(ExprId).take(64).filter_map(|e| {
        let found = tree.expr(e);
        match found.kind {
            ExprKind::Member(object, _) if extent.contains(found.extent) => Some(object),
            _ => None,
        }
    });
    members.all(|object| program.ty(object).components() as usize >= count)
}

/// The index of the only component that the tokens name.
fn number(program: &Program, extent: Extent) -> Option<usize> {
    let name = component_in(program, extent)?;
    SETS.iter().find_map(|set| set.find(name))
}

/// Whether pieces of code differ only in components.
fn are_alike(program: &Program, extents: &[Extent]) -> bool {
    extents.windows(2).all(|pair| match *pair {
        [a, b] => difference(program, a, b).is_some(),
        _ => false,
    })
}

/// The token offsets at which two pieces of code name different components; `None` if they differ
/// in anything else.
fn difference(program: &Program, a: Extent, b: Extent) -> Option<Vec<u32>> {
    if a.last - a.first != b.last - b.first {
        return None;
    }
    let mut found = Vec::new();
    for at in 0..=a.last - a.first {
        let (left, right) = (program.token(a.first + at)?, program.token(b.first + at)?);
        if is_one(left, right) {
            continue;
        }
        let both = component(program, a.first + at).zip(component(program, b.first + at));
        both?;
        found.push(at);
    }
    Some(found)
}

fn is_one(a: &Token, b: &Token) -> bool {
    (a.kind, a.value) == (b.kind, b.value) && a.is_direct() && b.is_direct()
}

/// Three lines that do the same to three components, where one component of the last line was not
/// changed: `c.x = f(a.x); c.y = f(a.y); c.z = f(a.y);`
fn check_lines(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::Block(body) = tree.stmt(id).kind else {
        return;
    };
    for lines in tree.block(body).windows(3) {
        let [Some(a), Some(b), Some(c)] = [0, 1, 2].map(|i| {
            let id = lines.get(i)?;
            match tree.stmt(*id).kind {
                StmtKind::Expr(e) => match tree.expr(e).kind {
                    ExprKind::Assign(_, target, _) => Some((tree.expr(e).extent, target)),
                    _ => None,
                },
                _ => None,
            }
        }) else {
            continue;
        };
        if let Some(at) = left_over(program, a.0, b.0, c.0) {
            let token = Extent::token(c.0.first + at);
            let text = program.sources.text(program.span(token));
            let message = format!("component `{text}` is unchanged from the line above");
            let place = program.span(Extent::token(b.0.first + at));
            let own = program.span(tree.expr(c.1).extent);
            cx.report(token, message)
                .label(own, "assigns another component")
                .label(place, "line above");
        }
    }
}

/// The first offset where the third of three lines names the same component as the second, although
/// the second differs from the first there.
fn left_over(program: &Program, a: Extent, b: Extent, c: Extent) -> Option<u32> {
    let changed = difference(program, a, b)?;
    let again = difference(program, b, c)?;
    let names = |extent: Extent, at: &u32| component(program, extent.first + at);
    let one = |extent: Extent| {
        let mut all = changed.iter().map(|at| names(extent, at));
        let first = all.next()?;
        all.all(|n| n == first).then_some(first?)
    };
    // The first two lines use one component each throughout, and the third continues the series.
    one(a)?;
    one(b)?;
    let target = changed.first()?;
    let goes_on = again.contains(target) && names(c, target) != names(a, target);
    let missed = changed.iter().find(|at| !again.contains(at));
    missed.filter(|_| goes_on && changed.len() > 1).copied()
}
