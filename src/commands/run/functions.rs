//! The cost of each function.

use super::columns::columns;
use super::place::position;
use serde::Serialize;
use shaderlint_exec::{FunctionObservation, Observations};
use shaderlint_semantic::Program;
use shaderlint_text::number::percent;

/// A function and its share of the cost.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct FunctionRow {
    /// Name of the function; empty for the initialisers of globals.
    pub name: String,
    /// Position of the definition: `file:line:column`.
    pub at: Option<String>,
    /// Operations of all pixels in the function itself.
    pub own_operations: u64,
    /// Share of all operations in the function itself.
    pub own: f64,
    /// Share of all operations in the function and its callees.
    pub with_callees: f64,
}

/// All functions that ran, most expensive first.
pub fn rows(program: &Program, seen: &Observations) -> Vec<FunctionRow> {
    let mut seen_functions: Vec<&FunctionObservation> = seen.functions.iter().collect();
    seen_functions.retain(|f| f.inclusive > 0);
    seen_functions.sort_by_key(|f| {
        (
            std::cmp::Reverse((f.own, f.inclusive)),
            f.function.map(|id| id.0),
        )
    });
    let share = |operations: u64| operations as f64 / seen.operations.max(1) as f64;
    let rows = seen_functions.into_iter().map(|own| {
        let function = own.function.and_then(|id| program.function(id));
        let tree = &program.tree;
        let definition = function.and_then(|f| tree.function(f.definition?));
        let token = definition.and_then(|d| program.token(d.ident.token));
        FunctionRow {
            name: function.map_or(String::new(), |f| program.names.text(f.name).to_string()),
            at: token.and_then(|t| position(&program.sources, t.span)),
            own_operations: own.own,
            own: share(own.own),
            with_callees: share(own.inclusive),
        }
    });
    rows.collect()
}

/// The table for people.
pub fn table(rows: &[FunctionRow]) -> String {
    let head = ["function", "at", "self", "total"];
    let mut cells = vec![head.map(str::to_string)];
    cells.extend(rows.iter().map(|row| {
        let name = match row.name.as_str() {
            "" => "(global initialisers)",
            name => name,
        };
        [
            name.to_string(),
            row.at.clone().unwrap_or_default(),
            percent(row.own),
            percent(row.with_callees),
        ]
    }));
    columns(&cells, 2)
}
