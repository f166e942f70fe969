//! Invalid numbers: NaN, infinities and undefined results.

use super::columns::columns;
use super::place::{position, span};
use super::shot::Shot;
use serde::Serialize;
use shaderlint_exec::{FaultKind, NumberObservation, Observations};
use shaderlint_semantic::Program;

/// An operation with invalid results.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct NumberRow {
    /// Position of the operation: `file:line:column`.
    pub at: String,
    /// Source text of the operation.
    pub text: String,
    /// `nan`, `infinite`, `division by zero`, `out of range`, `undefined`.
    pub kind: &'static str,
    /// Number of times that pixels produced it.
    pub times: u64,
    /// First pixel that produced it, from the lower left corner.
    pub pixel: [u32; 2],
    /// Operands of the operation at this pixel; NaN and infinities are `null` in JSON.
    pub operands: Vec<f64>,
}

/// Maximum length of source text in a table, in characters.
const LONGEST: usize = 40;

/// All invalid numbers in source order.
pub fn rows(program: &Program, shot: &Shot, seen: &Observations) -> Vec<NumberRow> {
    let found = seen.numbers.iter().filter_map(|number| {
        let place = span(program, shot.module.provenance(number.op))?;
        Some((place, number))
    });
    let mut found: Vec<_> = found.collect();
    found.sort_by_key(|(place, number)| (place.start, number.kind));
    let rows = found.into_iter().filter_map(|(place, number)| {
        let text = program.sources.text(place);
        Some(NumberRow {
            at: position(&program.sources, place)?,
            text: text.split_whitespace().collect::<Vec<_>>().join(" "),
            kind: kind(number),
            times: number.times,
            pixel: number.witness.pixel,
            operands: number.witness.operands.clone(),
        })
    });
    rows.collect()
}

const fn kind(number: &NumberObservation) -> &'static str {
    match number.kind {
        FaultKind::Nan => "nan",
        FaultKind::Infinite => "infinite",
        FaultKind::DivisionByZero => "division by zero",
        FaultKind::OutOfRange => "out of range",
        FaultKind::Undefined => "undefined",
    }
}

/// The table for people.
pub fn table(rows: &[NumberRow]) -> String {
    if rows.is_empty() {
        return "  no invalid numbers\n".to_string();
    }
    let head = [
        "number",
        "expression",
        "result",
        "first at",
        "operands",
        "times",
    ];
    let mut cells = vec![head.map(str::to_string)];
    cells.extend(rows.iter().map(|row| {
        let [x, y] = row.pixel;
        let operands = row.operands.iter().map(|n| (*n as f32).to_string());
        [
            row.at.clone(),
            short(&row.text),
            row.kind.to_string(),
            format!("{x},{y}"),
            operands.collect::<Vec<_>>().join(" "),
            row.times.to_string(),
        ]
    }));
    columns(&cells, 5)
}

/// Truncates long source text.
fn short(text: &str) -> String {
    match text.chars().count() > LONGEST {
        true => text
            .chars()
            .take(LONGEST - 3)
            .chain("...".chars())
            .collect(),
        false => text.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_printed_with_their_operands() {
        let row = NumberRow {
            at: "a.glsl:4:5".to_string(),
            text: "pow(q, 2.0)".to_string(),
            kind: "undefined",
            times: 12,
            pixel: [3, 0],
            operands: vec![-1.75, 2.0],
        };
        assert_eq!(
            table(&[row]),
            "  number      expression   result     first at  operands  times\n  \
             a.glsl:4:5  pow(q, 2.0)  undefined  3,0       -1.75 2      12\n"
        );
        assert_eq!(table(&[]), "  no invalid numbers\n");
    }

    #[test]
    fn long_operations_are_truncated() {
        let text = "a".repeat(41);
        assert_eq!(short(&text), format!("{}...", "a".repeat(37)));
        assert_eq!(short("b"), "b");
    }
}
