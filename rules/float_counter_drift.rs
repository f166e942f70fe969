//! Float counters where rounding changes the number of iterations.

use shaderlint_lint::prelude::*;

rule! { float_counter_drift, Numeric, Warning, Recommended, Stmt(check) }

/// Most iterations that are counted.
const MAX_ITERATIONS: u32 = 10_000;

/// `for (float x = start; x < limit; x += step)`
#[derive(Clone, Copy)]
struct Counted {
    counter: VariableId,
    /// Whether the loop assigns a variable that is declared before it.
    is_set: bool,
    start: f32,
    limit: f32,
    step: f32,
    op: BinaryOp,
}

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let Some(counted) = counted(program, id) else {
        return;
    };
    let Some((iterations, meant)) = iterations(&counted) else {
        return;
    };
    // A counter that is changed elsewhere counts differently.
    let writes = cx.facts.writes().to(counted.counter).len();
    let own = 1 + usize::from(counted.is_set);
    if iterations == meant || writes != own {
        return;
    }
    let StmtKind::For { init, body, .. } = program.tree.stmt(id).kind else {
        return;
    };
    let head = program.tree.stmt(init).extent.first;
    let head = Extent::new(head, program.tree.stmt(body).extent.first.saturating_sub(2));
    let step = plain(counted.step);
    cx.report(
        head,
        format!("this loop runs {iterations} iterations, not {meant}"),
    )
    .note(format!(
        "`{step}` has no exact `float` representation, and each addition rounds again"
    ))
    .help("use an `int` counter and compute the `float` value from it");
}

/// The number of iterations with `float` arithmetic, and with exact arithmetic.
fn iterations(counted: &Counted) -> Option<(u32, u32)> {
    let Counted {
        start,
        limit,
        step,
        op,
        ..
    } = *counted;
    let goes = |x: f32| match op {
        BinaryOp::Less => x < limit,
        BinaryOp::LessEqual => x <= limit,
        BinaryOp::Greater => x > limit,
        _ => x >= limit,
    };
    // The number as written, such as 0.1, which no `float` represents exactly.
    let written = |x: f32| plain(x).parse::<f64>().ok();
    let way = (written(limit)? - written(start)?) / written(step)?;
    let integer = way.round();
    let is_between = (way - integer).abs() > 1e-9 * integer.max(1.0);
    if is_between || !(1.0..MAX_ITERATIONS as f64).contains(&integer) {
        return None;
    }
    let is_closed = matches!(op, BinaryOp::LessEqual | BinaryOp::GreaterEqual);
    let meant = integer as u32 + u32::from(is_closed);
    let mut x = start;
    let iterations = (0..MAX_ITERATIONS).take_while(|_| {
        let is_on = goes(x);
        x += step;
        is_on
    });
    Some((iterations.count() as u32, meant))
}

/// A number in the fewest digits that identify it.
fn plain(x: f32) -> String {
    format!("{x:?}")
}

fn counted(program: &Program, id: StmtId) -> Option<Counted> {
    let tree = &program.tree;
    let StmtKind::For {
        init,
        condition: Some(condition),
        step: Some(step),
        ..
    } = tree.stmt(id).kind
    else {
        return None;
    };
    let (counter, start) = started(program, init)?;
    let StmtKind::Expr(condition) = tree.stmt(condition).kind else {
        return None;
    };
    let ExprKind::Binary(op, left, limit) = tree.expr(condition).kind else {
        return None;
    };
    let (sign, target, step) = match tree.expr(step).kind {
        ExprKind::Assign(Some(BinaryOp::Add), target, step) => (1.0, target, step),
        ExprKind::Assign(Some(BinaryOp::Sub), target, step) => (-1.0, target, step),
        _ => return None,
    };
    let is_order = op.compares() && !matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
    let is_counter = |e| program.variable_of(e) == Some(counter);
    (is_order && is_counter(left) && is_counter(target)).then_some(Counted {
        counter,
        is_set: matches!(tree.stmt(init).kind, StmtKind::Expr(_)),
        start,
        limit: float(program, limit)?,
        step: sign * float(program, step)?,
        op,
    })
}

/// The counter that a loop declares or assigns, and its start value.
fn started(program: &Program, init: StmtId) -> Option<(VariableId, f32)> {
    let tree = &program.tree;
    let decl = match tree.stmt(init).kind {
        StmtKind::Decl(decl) => decl,
        StmtKind::Expr(e) => {
            let ExprKind::Assign(None, target, value) = tree.expr(e).kind else {
                return None;
            };
            return Some((program.variable_of(target)?, float(program, value)?));
        }
        _ => return None,
    };
    let DeclKind::Variables { declarators, .. } = tree.decl(decl)?.kind else {
        return None;
    };
    let first = tree.declarators(declarators).first()?;
    let counter = *program.declared.get(declarators.start as usize)?;
    Some((counter?, float(program, first.init?)?))
}

fn float(program: &Program, expr: ExprId) -> Option<f32> {
    let is_float = program.ty(expr).scalar_kind() == Some(Scalar::Float);
    match program.scalar(expr)? {
        Value::Float(value) if is_float => Some(value),
        _ => None,
    }
}
