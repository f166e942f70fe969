//! Expensive calls that give the same in every turn of a loop.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting};
use crate::semantic::{Program, Resolution, Storage, VariableId, each_operand};
use crate::syntax::ast::*;
use std::collections::BTreeSet;

pub static RULE: Rule = Rule {
    name: "loop-invariant-call",
    group: Group::Budget,
    severity: Severity::Info,
    default: true,
    options: &[RuleOption::Number(&OPERATIONS)],
    page: include_str!("loop_invariant_call.md"),
    checks: &[Check::Program(check)],
};

static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    40.0,
    "Fewest operations of a call that is reported",
)
.on_swiftshader(12.0);

fn check(cx: &mut Context) {
    let program = cx.program;
    let facts = cx.facts;
    let mut places: Option<Places> = None;
    for call in &program.calls {
        if facts.work().operations(call.callee) < cx.option(&OPERATIONS)
            || !facts.effects().is_pure(call.callee)
            || program.expr(call.expr).is_const
        {
            continue;
        }
        let Some(stmt) = facts.structure().stmt_of(call.expr) else {
            continue;
        };
        let around = facts.structure().outwards(stmt);
        let Some(looped) = around
            .filter_map(|s| facts.loops().get(s))
            .find(|l| runs_each_turn(program, l.stmt, call.expr) && l.bound.turns() != Some(1))
        else {
            continue;
        };
        let places = places.get_or_insert_with(|| Places::of(cx));
        let extent = program.tree.stmt(looped.stmt).extent;
        if !is_still(cx, places, call.expr, extent) {
            continue;
        }
        let Some(function) = program.function(call.callee) else {
            continue;
        };
        let name = program.names.text(function.name);
        let head = program.span(Extent::token(extent.first));
        let turns = looped
            .bound
            .turns()
            .map_or(String::new(), |t| format!(", {t} times"));
        cx.report_expr(
            call.expr,
            format!("`{name}` gives the same in every turn of the loop"),
        )
        .label(head, format!("computed again in each turn{turns}"))
        .help("compute it once before the loop");
    }
}

/// Whether an expression stands in a loop where each turn may reach it, its first value left out.
fn runs_each_turn(program: &Program, looped: StmtId, expr: ExprId) -> bool {
    let tree = &program.tree;
    let at = tree.expr(expr).extent.first;
    match tree.stmt(looped).kind {
        StmtKind::For { init, .. } => tree.stmt(init).extent.last < at,
        _ => true,
    }
}

/// Where variables are written to, declarations included: first tokens, in order of the variables
/// and of the text.
struct Places(Vec<(VariableId, TokenId)>);

impl Places {
    fn of(cx: &Context) -> Places {
        let program = cx.program;
        let written = cx.facts.writes().all().iter();
        let written = written.map(|(expr, v)| (*v, program.tree.expr(*expr).extent.first));
        let mut all: Vec<(VariableId, TokenId)> = written.collect();
        let variables = program.variables.iter().zip(0..);
        all.extend(variables.filter_map(|(v, i)| Some((VariableId(i), v.token?))));
        all.sort_unstable();
        Places(all)
    }

    fn is_written_in(&self, variable: VariableId, extent: Extent) -> bool {
        let next = self.0.partition_point(|w| *w < (variable, extent.first));
        let next = self.0.get(next);
        next.is_some_and(|(v, token)| *v == variable && *token <= extent.last)
    }
}

/// Whether an expression has no effects and names nothing that changes in a loop.
fn is_still(cx: &Context, places: &Places, expr: ExprId, extent: Extent) -> bool {
    let program = cx.program;
    let mut todo = vec![expr];
    let mut seen = BTreeSet::new();
    while let Some(e) = todo.pop() {
        if !cx.facts.writes().by(e).is_empty() {
            return false;
        }
        if let Resolution::Variable(v) = program.expr(e).resolution
            && seen.insert(v)
        {
            let storage = program.variable(v).map(|v| (v.storage, v.written));
            // A function that the loop calls may write to a global variable.
            let is_shared = matches!(storage, Some((Storage::Global | Storage::Output, true)));
            if is_shared || places.is_written_in(v, extent) {
                return false;
            }
        }
        each_operand(&program.tree, program.tree.expr(e), |child| {
            todo.push(child)
        });
    }
    true
}
