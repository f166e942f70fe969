//! `normalize` of a vector that is already normalized.

use shaderlint_flow::reaching_definitions::Def;
use shaderlint_lint::prelude::*;

rule! { redundant_normalize, Budget, Info, Performance, Builtin(check) }

/// Maximum number of copies through which a value is followed.
const MAX_COPIES: usize = 8;

fn check(cx: &mut Context, call: &Builtin) {
    let &[arg] = call.args else { return };
    let program = cx.program;
    let ty = program.ty(arg);
    let is_vector = call.function == BuiltinId::Normalize && ty.is_vector();
    if !is_vector || program.expr(call.id).is_const {
        return;
    }
    let Some(made) = cx.facts.module().op_of(arg).and_then(|op| unit(cx, op)) else {
        return;
    };
    let text = program.expr_text(arg).to_string();
    let fix = cx.suggest(call.id, text.as_str());
    let made = made.map(|expr| program.expr_span(expr));
    let message = format!("redundant `normalize`: `{text}` already has length 1");
    cx.report_expr(call.id, message)
        .label(made, "normalized here")
        .fix(fix);
}

/// The call of `normalize` of which a vector is an unchanged copy. The inner `None` means that
/// there are several such calls.
fn unit(cx: &Context, op: OpId) -> Option<Option<ExprId>> {
    let (module, defs) = (cx.facts.module(), cx.facts.reaching_definitions());
    let is_normalize =
        |op: OpId| matches!(module.op(op).kind, OpKind::Builtin(BuiltinId::Normalize, _));
    let mut at = op;
    for _ in 0..MAX_COPIES {
        match module.op(at).kind {
            OpKind::Builtin(BuiltinId::Normalize, _) => {
                return Some(match module.provenance(at) {
                    Provenance::Expr(expr) => Some(expr),
                    _ => None,
                });
            }
            OpKind::Call(function, _) => {
                let returns = defs.returns_of(function);
                let all = !returns.is_empty() && returns.iter().all(|r| is_normalize(*r));
                return all.then_some(None);
            }
            OpKind::Load(_) => {
                let width = module.ty(at).components();
                let held = |lane| match defs.get(defs.unrefined(defs.seen(at, lane))) {
                    Def::Stored { value, lane: from } if from == lane => Some(value),
                    _ => None,
                };
                let value = held(0)?;
                let is_complete = module.ty(value) == module.ty(at);
                let is_one = (1..width).all(|lane| held(lane) == Some(value));
                at = Some(value).filter(|_| is_complete && is_one)?;
            }
            _ => return None,
        }
    }
    None
}
