//! The distance fields that rays march along: where they are steeper than a distance.

use super::place::position;
use super::shot::{Loaded, Shot};
use serde::Serialize;
use shaderlint_flow::DistanceField;
use shaderlint_lint::Facts;
use shaderlint_play::{Steepest, steepest};
use shaderlint_semantic::Program;
use shaderlint_text::number::seconds;

/// Number of planes over which the steepest place is searched, per time.
const PLANES: u32 = 40;
/// How much steeper than 1 two sampled points have to be.
const STEEP: f64 = 1.01;

/// A distance field, and what is known of its slope.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct FieldRow {
    /// Name of the function.
    pub function: String,
    /// Position of the definition: `file:line:column`.
    pub at: Option<String>,
    /// `steeper` (than a distance, between two points), `gentle` (in all samples) or `undecided`.
    pub verdict: &'static str,
    /// The steepest two points that were sampled; `None` if the function cannot be run on its own.
    pub steepest: Option<Steepest>,
}

/// The distance fields of a pass; `None` if there are none.
pub fn rows(program: &Program, loaded: &Loaded, shot: &Shot) -> Option<Vec<FieldRow>> {
    let fields = Facts::of(program, &shot.known).fields();
    let rows = fields.into_iter().map(|field| {
        let shader = (program, &*shot.module);
        let found = steepest(shader, loaded.project.host, field, PLANES);
        row(program, field, found.ok().flatten())
    });
    let rows: Vec<FieldRow> = rows.collect();
    (!rows.is_empty()).then_some(rows)
}

fn row(program: &Program, field: DistanceField, found: Option<Steepest>) -> FieldRow {
    let function = program.function(field.function);
    let tree = &program.tree;
    let definition = function.and_then(|f| tree.function(f.definition?));
    let token = definition.and_then(|d| program.token(d.ident.token));
    FieldRow {
        function: function.map_or(String::new(), |f| program.names.text(f.name).to_string()),
        at: token.and_then(|t| position(&program.sources, t.span)),
        verdict: match found {
            Some(found) if found.slope > STEEP => "steeper",
            Some(_) => "gentle",
            None => "undecided",
        },
        steepest: found,
    }
}

/// The lines for people.
pub fn lines(rows: &[FieldRow]) -> String {
    rows.iter().map(line).collect()
}

fn line(row: &FieldRow) -> String {
    let at = row
        .at
        .as_ref()
        .map_or(String::new(), |at| format!(" at {at}"));
    let point = |[x, y, z]: [f64; 3]| format!("({x:.3}, {y:.3}, {z:.3})");
    let verdict = match &row.steepest {
        None => "not decided: the function cannot be run on its own".to_string(),
        Some(steep) if row.verdict == "steeper" => {
            let [p, q] = steep.points.map(point);
            let time = steep.time.map(|t| format!(" at {}", seconds(t)));
            let time = time.unwrap_or_default();
            format!("slope {:.2} between {p} and {q}{time}", steep.slope)
        }
        Some(steep) => format!(
            "slope at most {:.2} in {} samples",
            steep.slope, steep.samples
        ),
    };
    format!("  distance field `{}`{at}: {verdict}\n", row.function)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_fields_are_summarised_in_text() {
        let steep = Steepest {
            slope: 1.834,
            points: [[0.0, 1.0, 2.0], [0.0, 1.0, 2.01]],
            values: [0.5, 0.6],
            time: Some(1.0),
            samples: 1024,
        };
        let steeper = FieldRow {
            function: "map".to_string(),
            at: Some("a.glsl:1:7".to_string()),
            verdict: "steeper",
            steepest: Some(steep),
        };
        let gentle = FieldRow {
            verdict: "gentle",
            steepest: Some(Steepest {
                slope: 1.0,
                ..steep
            }),
            ..steeper.clone()
        };
        let undecided = FieldRow {
            verdict: "undecided",
            steepest: None,
            at: None,
            ..steeper.clone()
        };
        assert_eq!(
            lines(&[steeper, gentle, undecided]),
            "  distance field `map` at a.glsl:1:7: slope 1.83 between (0.000, 1.000, 2.000) and \
             (0.000, 1.000, 2.010) at 1 s\n  \
             distance field `map` at a.glsl:1:7: slope at most 1.00 in 1024 samples\n  \
             distance field `map`: not decided: the function cannot be run on its own\n"
        );
    }
}
