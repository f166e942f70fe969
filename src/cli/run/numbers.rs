//! The numbers that went wrong.

use super::columns::columns;
use super::load::Shot;
use super::place::{position, span};
use crate::exec::{Kind, NumberSeen, Seen};
use crate::semantic::Program;
use serde::Serialize;

/// An operation whose numbers went wrong.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct NumberRow {
    /// Where it stands: `file:line:column`.
    pub at: String,
    /// Its text.
    pub text: String,
    /// `nan`, `infinite`, `division by zero`, `out of range`, `undefined`.
    pub kind: &'static str,
    /// How often pixels met it.
    pub times: u64,
    /// The first pixel, from the left and from below.
    pub pixel: [u32; 2],
    /// What the operation worked on there; what JSON has no number for is `null`.
    pub operands: Vec<f64>,
}

/// The longest text of an operation in a table.
const LONGEST: usize = 40;

/// All numbers that went wrong, in the order of the text.
pub fn rows(program: &Program, shot: &Shot, seen: &Seen) -> Vec<NumberRow> {
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

const fn kind(number: &NumberSeen) -> &'static str {
    match number.kind {
        Kind::Nan => "nan",
        Kind::Infinite => "infinite",
        Kind::DivisionByZero => "division by zero",
        Kind::OutOfRange => "out of range",
        Kind::Undefined => "undefined",
    }
}

/// The table for people.
pub fn table(rows: &[NumberRow]) -> String {
    if rows.is_empty() {
        return "  no number went wrong\n".to_string();
    }
    let head = ["number", "of", "is", "first at", "with", "times"];
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

/// The beginning of what is too long.
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
    fn what_went_wrong_stands_with_its_numbers() {
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
            "  number      of           is         first at  with     times\n  \
             a.glsl:4:5  pow(q, 2.0)  undefined  3,0       -1.75 2     12\n"
        );
        assert_eq!(table(&[]), "  no number went wrong\n");
    }

    #[test]
    fn long_operations_are_cut() {
        let text = "a".repeat(41);
        assert_eq!(short(&text), format!("{}...", "a".repeat(37)));
        assert_eq!(short("b"), "b");
    }
}
