//! Scene functions that evaluate every primitive at every step of a ray.

use shaderlint_lint::prelude::*;

rule! {
    no_early_exit, Budget, Info, Performance,
    [Count(&PRIMITIVES), Number(&OPERATIONS)], Program(check)
}

static PRIMITIVES: Setting<u64> = Setting::new(
    "primitives",
    16,
    "Minimum number of primitives in a reported scene function",
)
.on_swiftshader(8);
static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    600.0,
    "Minimum cost of a reported scene function, in operations",
)
.on_swiftshader(80.0);

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let program = cx.program;
    let mut scenes: Vec<(FunctionRef, StmtId)> = Vec::new();
    for march in facts.marches().iter().filter(|m| m.looped.ends_early) {
        if let Some(scene) = march.ray.scene.map(|call| call.function)
            && scenes.iter().all(|(f, _)| *f != scene)
        {
            scenes.push((scene, march.looped.stmt));
        }
    }
    for (scene, looped) in scenes {
        let Some(function) = program.function(scene) else {
            continue;
        };
        let Some(decl) = function.definition.and_then(|d| program.tree.function(d)) else {
            continue;
        };
        let primitives = facts.calls().calls_by(scene).map(|c| c.callee);
        let primitives: Vec<_> = primitives.filter(|c| is_primitive(cx, *c)).collect();
        let count = primitives.len();
        // Calls of a single function are usually samples of a grid.
        if primitives.iter().all(|c| Some(c) == primitives.first()) {
            continue;
        }
        let operations = facts.work().operations(scene);
        let is_large =
            count as u64 >= cx.option(&PRIMITIVES) && operations >= cx.option(&OPERATIONS);
        if !is_large || decl.body.is_none_or(|b| branches(cx, b)) {
            continue;
        }
        let name = program.names.text(function.name);
        let step = program.span(Extent::token(program.tree.stmt(looped).extent.first));
        cx.report(
            Extent::token(decl.ident.token),
            format!("`{name}` evaluates all its {count} primitives at every step"),
        )
        .label(step, "called by this loop")
        .note(
            "most steps are far from most primitives; a software renderer runs out of time and \
            shows nothing",
        )
        .help(
            "test a bounding box per group first, and return or skip the group when the point \
            is outside",
        );
    }
}

/// Whether a function maps a position to a scalar, such as a distance or a material.
fn is_primitive(cx: &Context, callee: FunctionRef) -> bool {
    let Some(function) = cx.program.function(callee) else {
        return false;
    };
    let has_place = function.params.iter().any(|p| p.ty.components() >= 2);
    has_place && function.returns.components() == 1
}

/// Whether a body skips part of its work on a condition.
fn branches(cx: &Context, body: StmtId) -> bool {
    let tree = &cx.program.tree;
    let mut todo = vec![body];
    while let Some(next) = todo.pop() {
        let stmt = tree.stmt(next);
        if let StmtKind::If {
            condition,
            then,
            otherwise,
        } = stmt.kind
        {
            let holds = |s: StmtId| holds_call(cx, s);
            if (leaves(tree, then) && asks_place(cx, condition))
                || holds(then)
                || otherwise.is_some_and(holds)
            {
                return true;
            }
        }
        if matches!(stmt.kind, StmtKind::Switch { .. }) {
            return true;
        }
        each_inner(tree, stmt, |s| todo.push(s));
    }
    false
}

/// Whether a condition tests a position, not a distance computed from it.
fn asks_place(cx: &Context, condition: ExprId) -> bool {
    let program = cx.program;
    let mut todo = vec![condition];
    while let Some(e) = todo.pop() {
        if matches!(program.tree.expr(e).kind, ExprKind::Name(_)) && program.ty(e).is_vector() {
            return true;
        }
        each_operand(&program.tree, program.tree.expr(e), |child| {
            todo.push(child)
        });
    }
    false
}

fn leaves(tree: &Tree, stmt: StmtId) -> bool {
    match tree.stmt(stmt).kind {
        StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue => true,
        StmtKind::Block(list) => tree.block(list).last().is_some_and(|s| {
            matches!(
                tree.stmt(*s).kind,
                StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue
            )
        }),
        _ => false,
    }
}

/// Whether a branch contains a call of a user-defined function.
fn holds_call(cx: &Context, stmt: StmtId) -> bool {
    let extent = cx.program.tree.stmt(stmt).extent;
    let Some(function) = cx.facts.structure().function_of(stmt) else {
        return false;
    };
    cx.facts.calls().calls_by(function).any(|c| {
        let e = cx.program.tree.expr(c.expr).extent;
        let is_function = matches!(cx.program.expr(c.expr).resolution, Resolution::Function(_));
        is_function && extent.first <= e.first && e.last <= extent.last
    })
}
