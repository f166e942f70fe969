//! Loop iterations that were counted, next to the bounds that were proved.

use super::columns::columns;
use super::place::{position, span};
use super::shot::Shot;
use serde::Serialize;
use shaderlint_exec::{LoopObservation, Observations};
use shaderlint_flow::Bound;
use shaderlint_ir::Provenance;
use shaderlint_lint::Facts;
use shaderlint_semantic::Program;
use shaderlint_text::number::percent;

/// A loop and its number of iterations.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct LoopRow {
    /// Position of the loop: `file:line:column`.
    pub at: String,
    /// Name of the enclosing function.
    pub function: String,
    /// Kind of the static bound: `exactly`, `at most`, `ends` (finite, but unknown), `open`
    /// (unknown).
    pub bound: &'static str,
    /// Static bound of the number of iterations, if known.
    #[serde(rename = "turns")]
    pub iterations: Option<u64>,
    /// Number of pixels that reached the loop.
    pub pixels: u64,
    /// Largest number of iterations.
    pub most: u32,
    /// Average number of iterations per execution of the loop.
    pub mean: f64,
    /// Number of iterations that 99 % of the executions do not exceed.
    pub p99: u32,
    /// Share of the pixels that ran all iterations without leaving early; `None` for loops without
    /// an early exit.
    pub exhausted: Option<f64>,
}

/// All loops that were reached, most iterations first.
pub fn rows(program: &Program, shot: &Shot, seen: &Observations) -> Vec<LoopRow> {
    let facts = Facts::of(program, &shot.known);
    let known = facts.loops();
    let mut seen: Vec<&LoopObservation> = seen.loops.iter().filter(|l| l.entries > 0).collect();
    seen.sort_by_key(|l| (std::cmp::Reverse(l.iterations), l.id));
    let rows = seen.into_iter().filter_map(|own| {
        let stmt = shot.module.looped(own.id)?.stmt;
        let own_facts = known.get(stmt);
        let (bound, iterations) = match own_facts.map_or(Bound::Open, |f| f.bound) {
            Bound::Exact(n) => ("exactly", Some(n)),
            Bound::AtMost(n) => ("at most", Some(n)),
            Bound::Ends => ("ends", None),
            Bound::Open => ("open", None),
        };
        let function = own_facts.and_then(|f| program.function(f.function));
        let place = span(program, Provenance::Stmt(stmt));
        Some(LoopRow {
            at: position(&program.sources, place?)?,
            function: function.map_or(String::new(), |f| program.names.text(f.name).to_string()),
            bound,
            iterations,
            pixels: own.pixels,
            most: own.most,
            mean: own.iterations as f64 / own.entries.max(1) as f64,
            p99: quantile(&own.histogram, 0.99),
            exhausted: own_facts
                .is_some_and(|f| f.ends_early)
                .then(|| own.exhausted_pixels as f64 / own.pixels.max(1) as f64),
        })
    });
    rows.collect()
}

/// The smallest number that at least the given share of the counted values do not exceed.
fn quantile(histogram: &[u32], share: f64) -> u32 {
    let all: u64 = histogram.iter().map(|n| u64::from(*n)).sum();
    let needed = (all as f64 * share).ceil() as u64;
    let mut counted = 0;
    for (count, iterations) in histogram.iter().zip(0..) {
        counted += u64::from(*count);
        if counted >= needed {
            return iterations;
        }
    }
    0
}

/// The table for people.
pub fn table(rows: &[LoopRow]) -> String {
    if rows.is_empty() {
        return "  no loop was reached\n".to_string();
    }
    let head = [
        "loop",
        "function",
        "bound",
        "max",
        "mean",
        "p99",
        "exhausted",
    ];
    let mut cells = vec![head.map(str::to_string)];
    cells.extend(rows.iter().map(|row| {
        [
            row.at.clone(),
            row.function.clone(),
            match row.iterations {
                Some(n) => format!("{} {n}", row.bound),
                None => row.bound.to_string(),
            },
            row.most.to_string(),
            format!("{:.1}", row.mean),
            row.p99.to_string(),
            row.exhausted.map_or("-".to_string(), percent),
        ]
    }));
    columns(&cells, 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_histogram_are_computed() {
        let mut histogram = vec![0; 10];
        histogram[2] = 98;
        histogram[5] = 1;
        histogram[9] = 1;
        assert_eq!(quantile(&histogram, 0.5), 2);
        assert_eq!(quantile(&histogram, 0.99), 5);
        assert_eq!(quantile(&histogram, 1.0), 9);
        assert_eq!(quantile(&[], 0.99), 0);
    }

    #[test]
    fn table_columns_are_aligned() {
        let row = LoopRow {
            at: "a.glsl:4:5".to_string(),
            function: "map".to_string(),
            bound: "at most",
            iterations: Some(96),
            pixels: 100,
            most: 71,
            mean: 16.12,
            p99: 64,
            exhausted: Some(0.031),
        };
        let text = table(&[row]);
        assert_eq!(
            text,
            "  loop        function  bound       max  mean  p99  exhausted\n  \
             a.glsl:4:5  map       at most 96   71  16.1   64      3.1 %\n"
        );
    }
}
