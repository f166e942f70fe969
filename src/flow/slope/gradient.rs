//! Gradients as combinations of generators, and bounds of the norms of Jacobians.
//!
//! A generator is a vector with a length of at most one. Generators that are independent form the rows of
//! a matrix with a norm of at most one: the axes, the axes of a rotated frame, and directions within
//! subspaces that are orthogonal.

use super::form::ScalarId;
use super::interval::RealSpan;
use rustc_hash::FxHashMap;

/// Index of a generator.
pub(super) type GradientGenerator = u32;

/// A set of gradients.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct FieldGradient {
    /// The ranges of the coefficients, by generator.
    pub parts: Vec<(GradientGenerator, RealSpan)>,
    /// An upper bound of the length.
    pub norm: f64,
}

impl FieldGradient {
    pub const ZERO: FieldGradient = FieldGradient {
        parts: Vec::new(),
        norm: 0.0,
    };

    pub fn unknown() -> FieldGradient {
        FieldGradient {
            parts: Vec::new(),
            norm: f64::INFINITY,
        }
    }

    pub fn is_known(&self) -> bool {
        self.norm.is_finite()
    }

    /// Multiples of the gradients.
    pub fn scale(&self, by: RealSpan) -> FieldGradient {
        if by.most() == 0.0 || self.norm == 0.0 {
            return FieldGradient::ZERO;
        }
        let norm = self.norm * by.most();
        if !norm.is_finite() {
            return FieldGradient::unknown();
        }
        let parts = self.parts.iter().map(|(g, span)| (*g, span.multiply(by)));
        FieldGradient {
            parts: parts.collect(),
            norm,
        }
    }

    /// Either of both.
    pub fn hull(&self, other: &FieldGradient) -> FieldGradient {
        self.merge(other, RealSpan::hull, f64::max)
    }

    /// The sums of both.
    pub fn add(&self, other: &FieldGradient) -> FieldGradient {
        self.merge(other, RealSpan::add, |a, b| a + b)
    }

    fn merge(
        &self,
        other: &FieldGradient,
        meet: impl Fn(RealSpan, RealSpan) -> RealSpan,
        norm: impl Fn(f64, f64) -> f64,
    ) -> FieldGradient {
        if !self.is_known() || !other.is_known() {
            return FieldGradient::unknown();
        }
        let (mut ours, mut theirs) = (self.parts.iter().peekable(), other.parts.iter().peekable());
        let mut parts = Vec::with_capacity(self.parts.len().max(other.parts.len()));
        loop {
            let next = match (ours.peek(), theirs.peek()) {
                (Some((a, x)), Some((b, y))) => match a.cmp(b) {
                    std::cmp::Ordering::Less => (*a, *x, RealSpan::ZERO),
                    std::cmp::Ordering::Equal => (*a, *x, *y),
                    std::cmp::Ordering::Greater => (*b, RealSpan::ZERO, *y),
                },
                (Some((a, x)), None) => (*a, *x, RealSpan::ZERO),
                (None, Some((b, y))) => (*b, RealSpan::ZERO, *y),
                (None, None) => break,
            };
            ours.next_if(|(g, _)| *g == next.0);
            theirs.next_if(|(g, _)| *g == next.0);
            parts.push((next.0, meet(next.1, next.2)));
        }
        FieldGradient {
            parts,
            norm: norm(self.norm, other.norm),
        }
    }
}

/// What a generator is a direction of: generators of one source are orthogonal.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
struct GeneratorSource {
    node: ScalarId,
    /// The generators of which it is a combination.
    support: Vec<GradientGenerator>,
}

/// All generators of a function.
#[derive(Default)]
pub(super) struct Generators {
    /// By generator: the number of its source.
    sources: Vec<u32>,
    all: Vec<GeneratorSource>,
    known: FxHashMap<(GeneratorSource, u32), GradientGenerator>,
    numbers: FxHashMap<GeneratorSource, u32>,
}

impl Generators {
    /// The axis of a coordinate.
    pub fn axis(&mut self, node: ScalarId) -> GradientGenerator {
        self.of(node, 0, Vec::new())
    }

    /// A direction of a node within the span of other generators.
    pub fn of(
        &mut self,
        node: ScalarId,
        index: u32,
        support: Vec<GradientGenerator>,
    ) -> GradientGenerator {
        let source = GeneratorSource { node, support };
        if let Some(known) = self.known.get(&(source.clone(), index)) {
            return *known;
        }
        let next = self.all.len() as u32;
        let number = *self.numbers.entry(source.clone()).or_insert(next);
        if number == next {
            self.all.push(source.clone());
        }
        let id = self.sources.len() as GradientGenerator;
        self.sources.push(number);
        self.known.insert((source, index), id);
        id
    }

    fn source(&self, generator: GradientGenerator) -> Option<(u32, &GeneratorSource)> {
        let number = *self.sources.get(generator as usize)?;
        Some((number, self.all.get(number as usize)?))
    }

    /// Whether two generators are orthogonal.
    fn is_independent(&self, a: GradientGenerator, b: GradientGenerator, depth: u32) -> bool {
        let (Some((first, source)), Some((second, other))) = (self.source(a), self.source(b))
        else {
            return false;
        };
        if a == b || depth == 0 {
            return false;
        }
        if first == second {
            return true;
        }
        let (support, rest) = match first > second {
            true => (&source.support, b),
            false => (&other.support, a),
        };
        if support.is_empty() {
            // Both are axes.
            return source.support.is_empty() && other.support.is_empty();
        }
        support
            .iter()
            .all(|g| self.is_independent(*g, rest, depth - 1))
    }

    /// An upper bound of the norm of a Jacobian with these rows.
    pub fn norm(&self, rows: &[&FieldGradient]) -> f64 {
        if rows.iter().any(|row| !row.is_known()) {
            return f64::INFINITY;
        }
        let squares: f64 = rows.iter().map(|row| row.norm * row.norm).sum();
        let mut all: Vec<GradientGenerator> =
            rows.iter().flat_map(|r| &r.parts).map(|p| p.0).collect();
        all.sort_unstable();
        all.dedup();
        let mut bins: Vec<Vec<GradientGenerator>> = Vec::new();
        for generator in all {
            let is_free = |bin: &&mut Vec<GradientGenerator>| {
                bin.iter()
                    .all(|other| self.is_independent(*other, generator, 12))
            };
            match bins.iter_mut().find(is_free) {
                Some(bin) => bin.push(generator),
                None => bins.push(vec![generator]),
            }
        }
        let sum: f64 = bins.iter().map(|bin| norm_of(rows, bin)).sum();
        sum.min(squares.sqrt())
    }

    /// The norm of a Jacobian of which each row is a direction of its own.
    pub fn norm_of_directions(&self, rows: &[&FieldGradient]) -> f64 {
        let is_apart = |a: &FieldGradient, b: &FieldGradient| {
            let mut pairs = a
                .parts
                .iter()
                .flat_map(|x| b.parts.iter().map(move |y| (x.0, y.0)));
            pairs.all(|(x, y)| self.is_independent(x, y, 12))
        };
        let mut bins: Vec<Vec<&FieldGradient>> = Vec::new();
        for row in rows {
            match bins
                .iter_mut()
                .find(|bin| bin.iter().all(|other| is_apart(other, row)))
            {
                Some(bin) => bin.push(row),
                None => bins.push(vec![row]),
            }
        }
        let most =
            |bin: &Vec<&FieldGradient>| bin.iter().fold(0.0, |most: f64, row| most.max(row.norm));
        bins.iter().map(|bin| most(bin).powi(2)).sum::<f64>().sqrt()
    }
}

/// An upper bound of the norm of the matrix of coefficients of some generators.
fn norm_of(rows: &[&FieldGradient], columns: &[GradientGenerator]) -> f64 {
    let cell = |row: &FieldGradient, column: GradientGenerator| {
        let found = row.parts.iter().find(|(g, _)| *g == column);
        found.map_or(RealSpan::ZERO, |(_, span)| *span)
    };
    let matrix = |value: fn(RealSpan) -> f64| -> Vec<Vec<f64>> {
        let row = |row: &&FieldGradient| columns.iter().map(|c| value(cell(row, *c))).collect();
        rows.iter().map(row).collect()
    };
    let most = spectral(&matrix(RealSpan::most));
    let middle = spectral(&matrix(|span| (span.lo + span.hi) / 2.0));
    let radius = spectral(&matrix(|span| (span.hi - span.lo) / 2.0));
    most.min(middle + radius)
}

/// An upper bound of the spectral norm of a matrix.
fn spectral(matrix: &[Vec<f64>]) -> f64 {
    let columns = matrix.first().map_or(0, Vec::len);
    let cell = |row: usize, column: usize| {
        let row = matrix.get(row);
        row.and_then(|row| row.get(column)).copied().unwrap_or(0.0)
    };
    // Of both products with the transpose, the smaller one.
    let by_rows = matrix.len() <= columns;
    let (count, inner) = match by_rows {
        true => (matrix.len(), columns),
        false => (columns, matrix.len()),
    };
    let product = |a: usize, b: usize| -> f64 {
        let each = (0..inner).map(|k| match by_rows {
            true => cell(a, k) * cell(b, k),
            false => cell(k, a) * cell(k, b),
        });
        each.sum()
    };
    let mut gram: Vec<Vec<f64>> = (0..count)
        .map(|a| (0..count).map(|b| product(a, b)).collect())
        .collect();
    // The norm of a power of a symmetric matrix is that power of its norm. `gram * exp(log)` is the
    // power.
    let (mut best, mut log, mut power) = (f64::INFINITY, 0.0, 1.0);
    for _ in 0..14 {
        let scale = greatest_row_sum(&gram);
        if scale == 0.0 || !scale.is_finite() {
            return scale.sqrt();
        }
        log += scale.ln();
        best = best.min((log / power).exp());
        gram.iter_mut().flatten().for_each(|cell| *cell /= scale);
        let column = |b: usize| {
            gram.iter()
                .map(move |row| row.get(b).copied().unwrap_or(0.0))
        };
        let square = |row: &Vec<f64>| {
            let cells = (0..count).map(|b| row.iter().zip(column(b)).map(|(x, y)| x * y).sum());
            cells.collect()
        };
        gram = gram.iter().map(square).collect();
        (log, power) = (log * 2.0, power * 2.0);
    }
    best.sqrt()
}

/// An upper bound of the norm of a symmetric matrix.
fn greatest_row_sum(matrix: &[Vec<f64>]) -> f64 {
    let sum = |row: &Vec<f64>| row.iter().map(|cell| cell.abs()).sum::<f64>();
    matrix.iter().map(sum).fold(0.0, f64::max)
}
