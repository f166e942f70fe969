//! Noise sums with more octaves than are visible.

use shaderlint_flow::reaching_definitions::{Def, DefId, ReachingDefinitions};
use shaderlint_ir::LoopId;
use shaderlint_lint::prelude::*;
use shaderlint_semantic::tunable::range_after;

rule! { octave_budget, Budget, Info, Performance, [Count(&OCTAVES)], Stmt(check) }

static OCTAVES: Setting<u64> =
    Setting::new("octaves", 12, "Maximum octaves of a noise sum").on_swiftshader(6);

/// Maximum number of operations of a product that are searched for a call.
const MAX_LOOK: usize = 16;

fn check(cx: &mut Context, stmt: StmtId) {
    let program = cx.program;
    let Some(looped) = cx.facts.loops().get(stmt).copied() else {
        return;
    };
    let (Some(iterations), Some(given)) = (looped.bound.iterations(), looped.given) else {
        return;
    };
    let most = cx.option(&OCTAVES);
    // A loop that exits early sums as many octaves as its caller asks for.
    if looped.ends_early || iterations <= most || !sums_octaves(cx, stmt) {
        return;
    }
    let uses = program.macros_at(program.tree.expr(given).extent.first);
    let body_end = uses.last().and_then(|used| {
        let mut macros = program.tokens.macros.iter();
        let found = macros.find(|m| m.name_span == used.definition)?;
        Some(found.body.last()?.token.span)
    });
    // A range that the author gave takes precedence.
    if let Some((range, _)) = body_end.and_then(|end| range_after(program, end))
        && iterations as f64 <= range.max
    {
        return;
    }
    cx.report_expr(
        given,
        format!("noise sums {iterations} octaves; the limit is {most}"),
    )
    .note(
        "each octave costs the same and contributes half as much; the last ones are smaller \
        than a pixel",
    )
    .help(format!("use {most} octaves, and fewer at a distance"));
}

/// Whether a loop sums calls of a function, scaled by a number that each iteration scales again.
fn sums_octaves(cx: &Context, stmt: StmtId) -> bool {
    let (module, defs) = (cx.facts.module(), cx.facts.reaching_definitions());
    let mut loops = (0..).map(LoopId).zip(&module.loops);
    let Some((id, looped)) = loops.find(|(_, l)| l.stmt == stmt) else {
        return false;
    };
    let scaled: Vec<DefId> = defs
        .heads(id)
        .filter(|h| is_scaled(module, defs, *h))
        .collect();
    // The position and the amplitude.
    scaled.len() >= 2
        && looped.ops.ops().any(|op| match module.op(op).kind {
            OpKind::Binary(Binary::Multiply | Binary::Divide, a, b) => {
                let is_amplitude = |o| sees(module, defs, o, &scaled);
                is_amplitude(b) && is_called(module, a) || is_amplitude(a) && is_called(module, b)
            }
            _ => false,
        })
}

/// Whether each iteration multiplies the value that a loop head holds.
fn is_scaled(module: &Module, defs: &ReachingDefinitions, head: DefId) -> bool {
    let Def::Head { back, .. } = defs.get(head) else {
        return false;
    };
    let Def::Stored { value, .. } = defs.get(defs.unrefined(back)) else {
        return false;
    };
    let is_own = |op| sees(module, defs, op, &[head]);
    match module.op(value).kind {
        OpKind::Binary(Binary::Multiply, a, b) | OpKind::MatrixProduct(a, b) => {
            is_own(a) != is_own(b)
        }
        OpKind::Binary(Binary::Divide, a, _) => is_own(a),
        OpKind::Binary(Binary::Add, a, b) => is_own(a) && is_own(b),
        _ => false,
    }
}

/// Whether a value is a copy of one of these, or a product with one.
fn sees(module: &Module, defs: &ReachingDefinitions, op: OpId, heads: &[DefId]) -> bool {
    match module.op(op).kind {
        OpKind::Load(_) => {
            let mut lanes = 0..defs.lanes_of(op);
            lanes.any(|lane| heads.contains(&defs.unrefined(defs.seen(op, lane))))
        }
        OpKind::Splat(a) | OpKind::Swizzle(a, _) => sees(module, defs, a, heads),
        OpKind::Binary(Binary::Multiply, a, b) | OpKind::MatrixProduct(a, b) => {
            sees(module, defs, a, heads) || sees(module, defs, b, heads)
        }
        _ => false,
    }
}

/// Whether a value is computed from the result of a user-defined function.
fn is_called(module: &Module, op: OpId) -> bool {
    let mut todo = vec![op];
    for _ in 0..MAX_LOOK {
        let Some(op) = todo.pop() else {
            return false;
        };
        if let OpKind::Call(..) = module.op(op).kind {
            return true;
        }
        module.each_operand(op, |operand| todo.push(operand));
    }
    false
}
