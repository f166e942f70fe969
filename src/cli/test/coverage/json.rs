//! Coverage as JSON. The format may gain fields, but never loses any.

use super::share::shares;
use crate::play::{Coverage, FileCoverage};
use serde_json::{Value, json};

pub fn json(coverage: &Coverage) -> String {
    let files: Vec<Value> = coverage
        .files
        .iter()
        .map(|(path, file)| of_file(path, file))
        .collect();
    let text = serde_json::to_string_pretty(&json!({ "schema": 1, "files": files }));
    format!("{}\n", text.unwrap_or_default())
}

fn of_file(path: &str, file: &FileCoverage) -> Value {
    let lines = file.lines().into_iter();
    let lines: Vec<Value> = lines
        .map(|(line, count)| json!({ "line": line, "count": count }))
        .collect();
    let branches = file.branches.iter().map(|(&(line, column), [taken, skipped])| {
        json!({ "line": line, "column": column, "true": taken, "false": skipped })
    });
    let functions = file.functions.iter().map(|(&(line, _), function)| {
        json!({ "name": function.name, "line": line, "calls": file.calls(function) })
    });
    let [all_lines, all_branches, all_functions] = shares(file).map(
        |share| json!({ "total": share.all, "covered": share.ran, "percent": share.percent() }),
    );
    json!({
        "file": path,
        "summary": { "lines": all_lines, "branches": all_branches, "functions": all_functions },
        "lines": lines,
        "branches": branches.collect::<Vec<_>>(),
        "functions": functions.collect::<Vec<_>>(),
    })
}
