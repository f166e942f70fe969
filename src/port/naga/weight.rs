//! What evaluating an expression costs and does, for all expressions at once.

use crate::semantic::{Program, Resolution};
use crate::syntax::ast::{ExprId, ExprKind};

/// Cost of what is not to be evaluated without need: a call, a look into a texture.
const HEAVY: u32 = 1000;
/// Costs from which on an expression is only evaluated where its value is asked for.
const LIMIT: u32 = 24;

/// What evaluating an expression costs, and whether it writes.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Weight {
    cost: u32,
    acts: bool,
}

impl Weight {
    /// Whether it may as well be evaluated where its value is not used.
    pub(super) fn is_light(self) -> bool {
        !self.acts && self.cost < LIMIT
    }
}

/// By [`ExprId`]; children stand before their parents.
pub(super) fn weights(program: &Program) -> Vec<Weight> {
    let mut all: Vec<Weight> = Vec::with_capacity(program.tree.exprs.len());
    for (i, expr) in program.tree.exprs.iter().enumerate() {
        let id = ExprId(i as u32);
        let own = match expr.kind {
            ExprKind::Assign(..) | ExprKind::Postfix(..) => Weight {
                cost: 1,
                acts: true,
            },
            ExprKind::Unary(op, _) if op.assigns() => Weight {
                cost: 1,
                acts: true,
            },
            ExprKind::Call(..) => match program.expr(id).resolution {
                Resolution::Function(_) => Weight {
                    cost: HEAVY,
                    acts: true,
                },
                Resolution::Builtin(_) => {
                    let overload = program.overload_called(id);
                    let is_texture = overload.is_some_and(|o| o.function.kind().is_texture());
                    Weight {
                        cost: if is_texture { HEAVY } else { 2 },
                        acts: overload.is_some_and(|o| o.out != 0),
                    }
                }
                _ => Weight::default(),
            },
            ExprKind::Paren(_) | ExprKind::Name(_) => Weight::default(),
            _ => Weight {
                cost: 1,
                acts: false,
            },
        };
        let mut sum = own;
        each_child(program, expr.kind, |child| {
            let of = all.get(child.0 as usize).copied().unwrap_or_default();
            sum.cost = sum.cost.saturating_add(of.cost);
            sum.acts |= of.acts;
        });
        all.push(sum);
    }
    all
}

fn each_child(program: &Program, kind: ExprKind, mut visit: impl FnMut(ExprId)) {
    match kind {
        ExprKind::Paren(e)
        | ExprKind::Unary(_, e)
        | ExprKind::Postfix(_, e)
        | ExprKind::Member(e, _) => visit(e),
        ExprKind::Binary(_, l, r)
        | ExprKind::Assign(_, l, r)
        | ExprKind::Comma(l, r)
        | ExprKind::Index(l, r) => {
            visit(l);
            visit(r);
        }
        ExprKind::Ternary(c, a, b) => {
            visit(c);
            visit(a);
            visit(b);
        }
        ExprKind::Call(_, args) | ExprKind::Construct(_, args) => {
            program.tree.args(args).iter().copied().for_each(visit);
        }
        ExprKind::Method(e, _, args) => {
            visit(e);
            program.tree.args(args).iter().copied().for_each(visit);
        }
        _ => {}
    }
}
