//! The tracefile format of LCOV (geninfo(1)).

use super::share::{Share, shares};
use crate::play::{Coverage, FileCoverage};
use std::collections::BTreeSet;
use std::fmt::Write;

pub fn lcov(coverage: &Coverage) -> String {
    let mut text = String::new();
    for (path, file) in &coverage.files {
        let _ = writeln!(text, "TN:\nSF:{path}");
        functions(&mut text, file);
        branches(&mut text, file);
        for (line, count) in file.lines() {
            let _ = writeln!(text, "DA:{line},{count}");
        }
        let [lines, ..] = shares(file);
        let _ = writeln!(text, "LF:{}\nLH:{}\nend_of_record", lines.all, lines.ran);
    }
    text
}

fn functions(text: &mut String, file: &FileCoverage) {
    let mut names = BTreeSet::new();
    let mut counts = String::new();
    for (&(line, _), function) in &file.functions {
        // Names are keys: overloads have their line as well.
        let name = match names.insert(function.name.clone()) {
            true => function.name.clone(),
            false => format!("{}@{line}", function.name),
        };
        let _ = writeln!(text, "FN:{line},{name}");
        let _ = writeln!(counts, "FNDA:{},{name}", file.calls(function));
    }
    let [_, _, Share { ran, all }] = shares(file);
    let _ = writeln!(text, "{counts}FNF:{all}\nFNH:{ran}");
}

fn branches(text: &mut String, file: &FileCoverage) {
    let mut last = (0, 0);
    for (&(line, _), sides) in &file.branches {
        let block = if last.0 == line { last.1 + 1 } else { 0 };
        last = (line, block);
        let is_reached = sides.iter().any(|count| *count > 0);
        for (side, count) in sides.iter().enumerate() {
            let count = if is_reached {
                count.to_string()
            } else {
                "-".to_string()
            };
            let _ = writeln!(text, "BRDA:{line},{block},{side},{count}");
        }
    }
    let [_, Share { ran, all }, _] = shares(file);
    let _ = writeln!(text, "BRF:{all}\nBRH:{ran}");
}
