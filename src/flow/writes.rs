//! The writes to each variable, and whether its value is ever used.

use shaderlint_ir::{Module, OpId, OpKind, PlaceId, Provenance, Root, Step};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{Mentions, Program, VariableId};
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::SetAt;

/// All writes of a shader.
#[derive(Default, Debug)]
pub struct Writes {
    /// In evaluation order.
    pub all: Vec<(ExprId, VariableId)>,
    /// By expression: the variables that the expression itself writes to.
    by_expr: Lists<VariableId>,
    /// By variable: the expressions that write to it, in source order.
    by_variable: Lists<ExprId>,
    /// By variable: the expressions that write to it and whose own value is unused, in source
    /// order.
    idle: Lists<ExprId>,
    /// By variable: whether its value is used.
    read: Vec<bool>,
    /// By variable: whether it is written to after its declaration.
    changes: Vec<bool>,
}

/// A write made by an expression.
#[derive(Clone, Copy)]
struct Write {
    variable: VariableId,
    expr: ExprId,
    store: OpId,
    /// Whether the value is an `out` or `inout` argument written back by a call.
    is_returned: bool,
}

impl Writes {
    /// Collects the writes of a module.
    pub fn of(program: &Program, module: &Module, mentions: &Mentions) -> Writes {
        let count = module.variables.len();
        let all = all(module);
        let pairs = || all.iter().map(|w| (w.expr.0, w.variable));
        let mut writes = Writes {
            all: all.iter().map(|w| (w.expr, w.variable)).collect(),
            by_expr: Lists::of(program.tree.exprs.len(), pairs()),
            by_variable: by_variable(program, &all, count),
            idle: Lists::default(),
            read: vec![false; count],
            changes: vec![false; count],
        };
        let last = last_uses(module);
        let mut idle = Vec::new();
        for write in &all {
            mark(&mut writes.changes, write.variable);
            let value = module.op_of(write.expr);
            let used = value.and_then(|v| last.get(v.0 as usize).copied());
            if write.is_returned || used.is_some_and(|used| used > write.store) {
                mark(&mut writes.read, write.variable);
            } else {
                idle.push((write.variable.0, write.expr));
            }
        }
        // Sorted in source order; an assignment to two members of a variable is listed once.
        idle.sort_unstable();
        idle.dedup();
        writes.idle = Lists::of(count, idle.iter().copied());
        for (op, made) in (0..).map(OpId).zip(&module.ops) {
            if let OpKind::Load(place) = made.kind {
                let variable = module.place(place).variable;
                if writes.is_read(variable) {
                    continue;
                }
                // The load in a compound assignment such as `x += y` is not a use of `x`.
                let is_own = matches!(module.provenance(op), Provenance::Expr(e)
                    if writes.by(e).contains(&variable));
                if !is_own {
                    mark(&mut writes.read, variable);
                }
            }
        }
        // Mentions without code were evaluated at compile time (constants, array lengths). They are
        // uses.
        let running = running(module);
        let named = (0..program.variables.len() as u32).map(VariableId);
        for ((id, slot), running) in named.zip(&mut writes.read).zip(running) {
            *slot |= mentions.all(id).len() > running;
        }
        writes
    }

    /// The variables that an expression itself writes to, without the writes of its operands.
    pub fn by(&self, expr: ExprId) -> &[VariableId] {
        self.by_expr.get(expr.0)
    }

    /// The expressions that write to a variable, in source order.
    pub fn to(&self, variable: VariableId) -> &[ExprId] {
        self.by_variable.get(variable.0)
    }

    /// Whether a variable is written to after its declaration.
    pub fn changes(&self, variable: VariableId) -> bool {
        let found = self.changes.get(variable.0 as usize);
        found.is_none_or(|c| *c)
    }

    /// Whether the value of a variable is used.
    pub fn is_read(&self, variable: VariableId) -> bool {
        self.read.get(variable.0 as usize).is_none_or(|r| *r)
    }

    /// The assignments to a variable whose own value is unused, in source order.
    pub fn idle(&self, variable: VariableId) -> &[ExprId] {
        self.idle.get(variable.0)
    }
}

fn by_variable(program: &Program, all: &[Write], count: usize) -> Lists<ExprId> {
    let start = |write: &Write| program.tree.expr(write.expr).extent.first;
    let mut sorted: Vec<&Write> = all.iter().collect();
    sorted.sort_by_key(|write| start(write));
    Lists::of(count, sorted.iter().map(|w| (w.variable.0, w.expr)))
}

fn mark(all: &mut [bool], variable: VariableId) {
    all.set_at(variable.0 as usize, true);
}

/// By variable: how often it is mentioned in lowered code. Each mention is a place.
fn running(module: &Module) -> Vec<usize> {
    let mut count: Vec<usize> = vec![0; module.variables.len()];
    for place in &module.places {
        if let Some(slot) = count.get_mut(place.variable.0 as usize) {
            *slot += 1;
        }
    }
    for (op, made) in (0..).map(OpId).zip(&module.ops) {
        if let (OpKind::Store(place, _), Provenance::Declaration(_)) =
            (made.kind, module.provenance(op))
            && let Some(slot) = count.get_mut(module.place(place).variable.0 as usize)
        {
            *slot = slot.saturating_sub(1);
        }
    }
    count
}

/// The writes made by expressions, in evaluation order.
fn all(module: &Module) -> Vec<Write> {
    let ops = (0..).map(OpId).zip(&module.ops);
    let writes = ops.filter_map(|(store, made)| {
        let (OpKind::Store(place, value), Provenance::Expr(expr)) =
            (made.kind, module.provenance(store))
        else {
            return None;
        };
        Some(Write {
            variable: declared(module, place)?,
            expr,
            store,
            is_returned: matches!(module.op(value).kind, OpKind::Returned(..)),
        })
    });
    writes.collect()
}

/// By operation: the last operation that uses its value; `AFTER` if control flow uses it,
/// `OpId(0)` if nothing does.
fn last_uses(module: &Module) -> Vec<OpId> {
    const AFTER: OpId = OpId(u32::MAX);
    let mut last = vec![OpId(0); module.ops.len()];
    let mut set = |value: OpId, user: OpId| {
        last.set_at(value.0 as usize, user);
    };
    for user in (0..module.ops.len() as u32).map(OpId) {
        module.each_operand(user, |value| set(value, user));
    }
    for step in &module.steps {
        match *step {
            Step::If { condition, .. } => set(condition, AFTER),
            Step::Return(Some(value), _) => set(value, AFTER),
            _ => {}
        }
    }
    let conditions = module.loops.iter().filter_map(|l| l.condition);
    conditions.for_each(|c| set(c, AFTER));
    let selectors = module.switches.iter().map(|s| s.selector);
    selectors.for_each(|s| set(s, AFTER));
    last
}

/// Whether a place belongs to a temporary introduced by lowering.
pub(super) fn is_temporary(module: &Module, place: PlaceId) -> bool {
    let root = module
        .variable(module.place(place).variable)
        .map(|v| v.root);
    root == Some(Root::Temporary)
}

/// The variable of a place, unless it is a temporary.
fn declared(module: &Module, place: PlaceId) -> Option<VariableId> {
    (!is_temporary(module, place)).then(|| module.place(place).variable)
}
