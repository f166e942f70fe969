//! Definite assignment: which variables may be read, or left by a function, before they are
//! assigned on some path; and whether the end of a function is reachable.
//!
//! Writes in a loop count as assigned after it: shaders rarely make explicit that a loop runs at
//! least once, or that a search succeeds. A repeated condition has the same value as before until
//! one of its operands changes.

mod both_sides;
mod cases;
mod conditions;
mod operands;
mod state;
#[cfg(test)]
mod tests;
mod walk;

use super::calls::Calls;
use super::ranges::Query;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{Module, OpId, OpKind, Root};
use shaderlint_semantic::{FunctionRef, Mentions, Program, Stage, VariableId};
pub use state::{AssignmentFindings, PartMask, UnassignedVariable};
use walk::AssignmentWalk;

/// The findings of all functions, by function.
#[derive(Default, Debug)]
pub struct DefiniteAssignment {
    by_function: FxHashMap<FunctionRef, AssignmentFindings>,
}

impl DefiniteAssignment {
    /// Analyses the paths through all functions of a shader.
    pub fn of<'x>(
        (program, module): (&'x Program, &'x Module),
        calls: &Calls,
        mentions: &'x Mentions,
        query: &'x dyn Fn() -> Query<'x>,
    ) -> DefiniteAssignment {
        let main = main(program);
        let outputs = main.map_or(Vec::new(), |main| outputs_of(program, module, main));
        let ignored = ignored(module, calls);
        let mut walk = AssignmentWalk::new(program, module, mentions, &ignored, query);
        let mut paths = DefiniteAssignment::default();
        for id in calls.graph.bottom_up() {
            let globals = match Some(id) == main {
                true => outputs.as_slice(),
                false => &[],
            };
            if let Some(findings) = walk.function(id, globals) {
                paths.by_function.insert(id, findings);
            }
        }
        paths
    }

    /// The findings of a function; `None` if it was not analysed.
    pub fn get(&self, function: FunctionRef) -> Option<&AssignmentFindings> {
        self.by_function.get(&function)
    }
}

/// `in` parameters whose value is unused, except as an argument for another such parameter.
fn ignored(module: &Module, calls: &Calls) -> FxHashSet<VariableId> {
    let mut ignored = FxHashSet::default();
    for id in calls.graph.bottom_up() {
        let Some(function) = module.function(id) else {
            continue;
        };
        let mut loads: Vec<(OpId, VariableId)> = Vec::new();
        let mut passed: FxHashSet<OpId> = FxHashSet::default();
        for op in function.ops.ops() {
            match module.op(op).kind {
                OpKind::Load(place) => loads.push((op, module.place(place).variable)),
                OpKind::Call(callee, list) => {
                    let parameters = module.function(callee).map(|f| module.parameters(f));
                    let given = module.operands(list).iter().zip(parameters.unwrap_or(&[]));
                    passed.extend(
                        given
                            .filter(|(_, p)| ignored.contains(*p))
                            .map(|(op, _)| *op),
                    );
                }
                _ => {}
            }
        }
        let is_used = |parameter: &VariableId| {
            let mut own = loads.iter().filter(|(_, variable)| variable == parameter);
            own.any(|(op, _)| !passed.contains(op))
        };
        let is_in = |p: &&VariableId| {
            let root = module.variable(**p).map(|v| v.root);
            root == Some(Root::Parameter)
        };
        let parameters = module.parameters(function).iter();
        if function.body.is_some() {
            ignored.extend(parameters.filter(is_in).filter(|p| !is_used(p)));
        }
    }
    ignored
}

fn main(program: &Program) -> Option<FunctionRef> {
    let name = program.names.get("main")?;
    let is_main = |f: &shaderlint_semantic::Function| f.definition.is_some() && f.name == name;
    let at = program.functions.iter().position(is_main)?;
    Some(FunctionRef(at as u32))
}

/// The outputs of a fragment shader that only `main` accesses.
fn outputs_of(program: &Program, module: &Module, main: FunctionRef) -> Vec<VariableId> {
    if program.stage != Stage::Fragment {
        return Vec::new();
    }
    let is_output = |v: VariableId| module.variable(v).is_some_and(|v| v.root == Root::Output);
    let ids = (0..).map(VariableId).zip(&program.variables);
    let mut found: Vec<VariableId> = ids
        .filter(|(id, v)| is_output(*id) && (v.token.is_some() || v.written))
        .map(|(id, _)| id)
        .collect();
    for id in (0..module.functions.len() as u32).map(FunctionRef) {
        let Some(function) = module
            .function(id)
            .filter(|_| id != main && !found.is_empty())
        else {
            continue;
        };
        for op in function.ops.ops() {
            if let OpKind::Load(place) | OpKind::Store(place, _) = module.op(op).kind {
                let variable = module.place(place).variable;
                found.retain(|v| *v != variable);
            }
        }
    }
    found
}
