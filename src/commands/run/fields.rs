//! The distance fields that rays march along: whether they are as steep as a distance at most.

use super::place::{position, span};
use super::shot::{Loaded, Shot};
use serde::Serialize;
use shaderlint_engine::playback::{Steepest, steepest};
use shaderlint_flow::{DistanceField, Obstacle, Slope, SlopeObstacle};
use shaderlint_lint::Facts;
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
    /// `proved` (nowhere steeper than 1), `steeper` (than 1, between two points), `bounded` (by a
    /// number above 1) or `undecided`.
    pub verdict: &'static str,
    /// The slope that it nowhere exceeds, if one was found.
    pub bound: Option<f64>,
    /// Why there is no bound.
    pub reason: Option<String>,
    /// The steepest two points that were sampled; `None` if the function cannot be run on its own.
    pub steepest: Option<SteepRow>,
}

/// Two points, and the values of a field there.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct SteepRow {
    /// Difference of the values divided by the distance of the points.
    pub slope: f64,
    /// The points.
    pub points: [[f64; 3]; 2],
    /// The values.
    pub values: [f64; 2],
    /// Time in seconds, if the field depends on uniforms.
    pub time: Option<f64>,
    /// Number of points that were sampled.
    pub samples: u64,
}

/// The distance fields of a pass; `None` if there are none.
pub fn rows(program: &Program, loaded: &Loaded, shot: &Shot) -> Option<Vec<FieldRow>> {
    let facts = Facts::of(program, &shot.known);
    let rows = facts.slopes().iter().map(|(field, slope)| {
        let found = steepest((program, &shot.module), loaded.project.host, *field, PLANES);
        row(program, shot, (*field, *slope), found.ok().flatten())
    });
    let rows: Vec<FieldRow> = rows.collect();
    (!rows.is_empty()).then_some(rows)
}

fn row(
    program: &Program,
    shot: &Shot,
    (field, slope): (DistanceField, Slope),
    found: Option<Steepest>,
) -> FieldRow {
    let function = program.function(field.function);
    let tree = &program.tree;
    let definition = function.and_then(|f| tree.function(f.definition?));
    let token = definition.and_then(|d| program.token(d.ident.token));
    let (bound, reason) = match slope {
        Slope::AtMost(most) => (Some(most), None),
        Slope::Unknown(obstacle) => (None, Some(reason(program, shot, obstacle))),
    };
    let is_steep = found.is_some_and(|found| found.slope > STEEP);
    FieldRow {
        function: function.map_or(String::new(), |f| program.names.text(f.name).to_string()),
        at: token.and_then(|t| position(&program.sources, t.span)),
        verdict: match bound {
            Some(_) if slope.is_distance() => "proved",
            _ if is_steep => "steeper",
            Some(_) => "bounded",
            None => "undecided",
        },
        bound,
        reason,
        steepest: found.map(|found| SteepRow {
            slope: found.slope,
            points: found.points,
            values: found.values,
            time: found.time,
            samples: found.samples,
        }),
    }
}

fn reason(program: &Program, shot: &Shot, obstacle: Obstacle) -> String {
    let what = match obstacle.why {
        SlopeObstacle::Discontinuity => "may be discontinuous",
        SlopeObstacle::Unbounded => "may be arbitrarily steep",
        SlopeObstacle::Operation => "has an unknown slope",
        SlopeObstacle::Loop => "has an unknown number of iterations",
        SlopeObstacle::Size => "is too large to analyse",
        SlopeObstacle::Body | SlopeObstacle::Value | SlopeObstacle::Jump => "cannot be analysed",
    };
    let place = obstacle.at.map(|op| shot.module.provenance(op));
    let place = place.and_then(|from| span(program, from));
    let at = place.and_then(|place| {
        let words = program.sources.text(place).split_whitespace();
        let text = words.collect::<Vec<_>>().join(" ");
        let short: String = text.chars().take(48).collect();
        let dots = if short.len() < text.len() { "..." } else { "" };
        Some(format!(
            "`{short}{dots}` at {}",
            position(&program.sources, place)?
        ))
    });
    match at {
        Some(at) => format!("{at} {what}"),
        None => format!("the function {what}"),
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
    let found = row.steepest.as_ref().map(|steep| {
        let [p, q] = steep.points;
        let time = steep
            .time
            .map_or(String::new(), |t| format!(" at {}", seconds(t)));
        (
            steep.slope,
            format!("between {} and {}{time}", point(p), point(q)),
        )
    });
    let verdict = match (row.verdict, row.bound, found) {
        ("proved", ..) => "proved to be nowhere steeper than a distance".to_string(),
        ("steeper", Some(most), Some((slope, place))) => {
            format!("slope {slope:.2} {place}, nowhere more than {most:.2}")
        }
        ("steeper", None, Some((slope, place))) => format!("slope {slope:.2} {place}"),
        (_, Some(most), Some((slope, _))) => {
            format!("slope at most {most:.2}; sampled {slope:.2}")
        }
        (_, Some(most), None) => format!("slope at most {most:.2}"),
        (_, None, found) => {
            let sampled = found.map_or(String::new(), |(slope, _)| format!("; sampled {slope:.2}"));
            let reason = row.reason.as_deref().unwrap_or("no bound was found");
            format!("not decided: {reason}{sampled}")
        }
    };
    format!("  distance field `{}`{at}: {verdict}\n", row.function)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_for_people() {
        let row = FieldRow {
            function: "map".to_string(),
            at: Some("a.glsl:1:7".to_string()),
            verdict: "proved",
            bound: Some(1.0),
            reason: None,
            steepest: None,
        };
        let steep = SteepRow {
            slope: 1.834,
            points: [[0.0, 1.0, 2.0], [0.0, 1.0, 2.01]],
            values: [0.5, 0.6],
            time: Some(1.0),
            samples: 1024,
        };
        let steeper = FieldRow {
            verdict: "steeper",
            bound: None,
            steepest: Some(steep),
            ..row.clone()
        };
        let undecided = FieldRow {
            verdict: "undecided",
            bound: None,
            reason: Some("`floor(p)` at a.glsl:2:3 may be discontinuous".to_string()),
            at: None,
            ..row.clone()
        };
        let bounded = FieldRow {
            verdict: "bounded",
            bound: Some(1.5),
            ..row.clone()
        };
        assert_eq!(
            lines(&[row, steeper, undecided, bounded]),
            "  distance field `map` at a.glsl:1:7: proved to be nowhere steeper than a distance\n  \
             distance field `map` at a.glsl:1:7: slope 1.83 between (0.000, 1.000, 2.000) and \
             (0.000, 1.000, 2.010) at 1 s\n  \
             distance field `map`: not decided: `floor(p)` at a.glsl:2:3 may be discontinuous\n  \
             distance field `map` at a.glsl:1:7: slope at most 1.50\n"
        );
    }
}
