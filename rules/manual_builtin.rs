//! Formulas for which GLSL has a function.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, Shape, same_code};
use crate::semantic::{BuiltinId, Scalar};
use crate::syntax::ast::*;
use crate::text::Edit;

pub static RULE: Rule = Rule {
    name: "manual-builtin",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("manual_builtin.md"),
    checks: &[Check::Expr(&[Shape::Binary, Shape::Call], check)],
};

/// What a formula is, and the call that says the same.
struct Found {
    function: BuiltinId,
    arguments: Vec<ExprId>,
}

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let expr = tree.expr(id);
    let is_float = program.ty(id).scalar_kind() == Some(Scalar::Float);
    if !is_float || program.ty(id).is_matrix() || program.expr(id).is_const {
        return;
    }
    let found = match expr.kind {
        ExprKind::Call(..) => clamp(cx, id)
            .or_else(|| length(cx, id))
            .or_else(|| distance(cx, id)),
        ExprKind::Binary(BinaryOp::Add, a, b) if !is_summand(cx, id) => mix(cx, a, b),
        ExprKind::Binary(BinaryOp::Sub, a, b) => reflect(cx, a, b).or_else(|| fract(cx, a, b)),
        ExprKind::Binary(BinaryOp::Div, a, b) => normalize(cx, a, b),
        _ => None,
    };
    let Some(Found {
        function,
        arguments,
    }) = found
    else {
        return;
    };
    // What is computed twice in the formula must be the same each time.
    if cx.facts.effects().has(id) || !program.is_direct(expr.extent) {
        return;
    }
    let texts: Vec<&str> = arguments.iter().map(|&a| program.expr_text(a)).collect();
    let call = format!("{}({})", function.name(), texts.join(", "));
    let edit = Edit::replace(program.span(expr.extent), call.clone());
    cx.report_expr(id, format!("this is `{call}`"))
        .fix(Fix::suggestion(format!("write `{call}`"), vec![edit]));
}

/// The arguments of a call of one of GLSL's functions.
fn call<'a>(cx: &Context<'_, 'a>, id: ExprId, function: BuiltinId) -> Option<&'a [ExprId]> {
    let program = cx.program;
    let id = program.tree.unparen(id);
    match program.tree.expr(id).kind {
        ExprKind::Call(_, args) if program.builtin_called(id) == Some(function) => {
            Some(program.tree.args(args))
        }
        _ => None,
    }
}

fn same(cx: &Context, a: ExprId, b: ExprId) -> bool {
    let tree = &cx.program.tree;
    let [a, b] = [a, b].map(|e| tree.expr(tree.unparen(e)).extent);
    same_code(cx.program, a, b)
}

fn binary(cx: &Context, id: ExprId, op: BinaryOp) -> Option<(ExprId, ExprId)> {
    let tree = &cx.program.tree;
    match tree.expr(tree.unparen(id)).kind {
        ExprKind::Binary(found, a, b) if found == op => Some((a, b)),
        _ => None,
    }
}

/// Both orders of two operands.
fn orders<T: Copy>(a: T, b: T) -> [(T, T); 2] {
    [(a, b), (b, a)]
}

/// `min(max(x, low), high)` or `max(min(x, high), low)` with constants.
fn clamp(cx: &Context, id: ExprId) -> Option<Found> {
    let bound = |e: ExprId| {
        let values = cx.program.values(e);
        let first = values.first()?.as_float();
        let all = values.iter().all(|v| v.as_float() == first);
        all.then_some(first)
    };
    for (outer, inner) in orders(BuiltinId::Min, BuiltinId::Max) {
        let Some(&[a, b]) = call(cx, id, outer) else {
            continue;
        };
        for (nested, first) in orders(a, b) {
            let Some(&[c, d]) = call(cx, nested, inner) else {
                continue;
            };
            for (x, second) in orders(c, d) {
                let (low, high) = if outer == BuiltinId::Min {
                    (second, first)
                } else {
                    (first, second)
                };
                let fits = |e| {
                    [cx.program.ty(x), crate::semantic::Type::FLOAT].contains(&cx.program.ty(e))
                };
                let is_alike = cx.program.ty(low) == cx.program.ty(high);
                if let (Some(least), Some(most)) = (bound(low), bound(high))
                    && least <= most
                    && is_alike
                    && fits(low)
                    && bound(x).is_none()
                {
                    return Some(Found {
                        function: BuiltinId::Clamp,
                        arguments: vec![x, low, high],
                    });
                }
            }
        }
    }
    None
}

/// `sqrt(dot(v, v))`.
fn length(cx: &Context, id: ExprId) -> Option<Found> {
    let &[root] = call(cx, id, BuiltinId::Sqrt)? else {
        return None;
    };
    let &[a, b] = call(cx, root, BuiltinId::Dot)? else {
        return None;
    };
    same(cx, a, b).then(|| Found {
        function: BuiltinId::Length,
        arguments: vec![a],
    })
}

/// `length(a - b)` of two named places.
fn distance(cx: &Context, id: ExprId) -> Option<Found> {
    let &[difference] = call(cx, id, BuiltinId::Length)? else {
        return None;
    };
    let (a, b) = binary(cx, difference, BinaryOp::Sub)?;
    let program = cx.program;
    let is_place = |e: ExprId| {
        let mut at = program.tree.unparen(e);
        while let ExprKind::Member(inner, _) = program.tree.expr(at).kind {
            at = inner;
        }
        matches!(program.tree.expr(at).kind, ExprKind::Name(_)) && program.ty(e).is_vector()
    };
    (is_place(a) && is_place(b)).then(|| Found {
        function: BuiltinId::Distance,
        arguments: vec![a, b],
    })
}

/// Whether an expression is part of a longer sum, which has a shape of its own.
fn is_summand(cx: &Context, id: ExprId) -> bool {
    let parent = cx.facts.structure().parent(id);
    let kind = parent.map(|p| cx.program.tree.expr(p).kind);
    matches!(
        kind,
        Some(ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..))
    )
}

/// `a * (1.0 - t) + b * t` or `a + (b - a) * t`.
fn mix(cx: &Context, left: ExprId, right: ExprId) -> Option<Found> {
    let is_one = |e| cx.program.scalar(e).is_some_and(|v| v.as_float() == 1.0);
    let found = |a, b, t| {
        let ty = |e| cx.program.ty(e);
        let fits = ty(a) == ty(b) && (ty(t) == ty(a) || ty(t).is_scalar());
        // A number is a scale, and no mixture.
        let fits = fits && cx.program.values(t).is_empty();
        fits.then(|| Found {
            function: BuiltinId::Mix,
            arguments: vec![a, b, t],
        })
    };
    for (one, other) in orders(left, right) {
        let (Some((p, q)), rest) = (binary(cx, one, BinaryOp::Mul), other) else {
            continue;
        };
        for (factor, t) in orders(p, q) {
            let Some((minuend, subtrahend)) = binary(cx, factor, BinaryOp::Sub) else {
                continue;
            };
            // `rest + (minuend - rest) * t`
            if same(cx, subtrahend, rest) {
                return found(rest, minuend, t);
            }
            // `t * (1.0 - s) + b * s`
            if !is_one(minuend) {
                continue;
            }
            let Some((c, d)) = binary(cx, rest, BinaryOp::Mul) else {
                continue;
            };
            for (b, s) in orders(c, d) {
                if same(cx, s, subtrahend) {
                    return found(t, b, s);
                }
            }
        }
    }
    None
}

/// `d - 2.0 * dot(d, n) * n`, in any order of the factors.
fn reflect(cx: &Context, direction: ExprId, rest: ExprId) -> Option<Found> {
    let mut factors = Vec::new();
    let mut todo = vec![rest];
    while let Some(next) = todo.pop() {
        match binary(cx, next, BinaryOp::Mul) {
            Some((a, b)) if factors.len() < 3 => todo.extend([b, a]),
            _ => factors.push(next),
        }
    }
    let is_two = |e: &ExprId| cx.program.scalar(*e).is_some_and(|v| v.as_float() == 2.0);
    let product = |e: &ExprId| match call(cx, *e, BuiltinId::Dot) {
        Some(&[a, b]) => Some((a, b)),
        _ => None,
    };
    let [_, _, _] = factors.as_slice() else {
        return None;
    };
    let (a, b) = factors.iter().find_map(product)?;
    let normal = *factors
        .iter()
        .find(|f| !is_two(f) && product(f).is_none())?;
    let fits = |d, n| same(cx, d, direction) && same(cx, n, normal);
    let is_it = factors.iter().any(is_two) && (fits(a, b) || fits(b, a));
    is_it.then(|| Found {
        function: BuiltinId::Reflect,
        arguments: vec![direction, normal],
    })
}

/// `x - floor(x)`.
fn fract(cx: &Context, x: ExprId, floored: ExprId) -> Option<Found> {
    let &[inner] = call(cx, floored, BuiltinId::Floor)? else {
        return None;
    };
    same(cx, inner, x).then(|| Found {
        function: BuiltinId::Fract,
        arguments: vec![inner],
    })
}

/// `v / length(v)`.
fn normalize(cx: &Context, v: ExprId, divisor: ExprId) -> Option<Found> {
    let &[inner] = call(cx, divisor, BuiltinId::Length)? else {
        return None;
    };
    let is_it = cx.program.ty(v).is_vector() && same(cx, inner, v);
    is_it.then(|| Found {
        function: BuiltinId::Normalize,
        arguments: vec![inner],
    })
}
