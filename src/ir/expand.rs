//! Expansions of built-in functions into simpler operations, shared by everything that runs shaders
//! or translates them to another language.

/// A binary operator on scalars.
#[expect(missing_docs, reason = "the variants are standard terms")]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Less,
}

/// A builder of scalar operations.
pub trait Arithmetic {
    /// A scalar or a condition.
    type Value: Copy;

    /// A constant.
    fn number(&mut self, value: f32) -> Self::Value;

    /// Emits a binary operation.
    fn binary(&mut self, op: Operator, left: Self::Value, right: Self::Value) -> Self::Value;

    /// Emits a negation.
    fn negated(&mut self, value: Self::Value) -> Self::Value;

    /// Emits the square root of a non-negative number.
    fn sqrt(&mut self, value: Self::Value) -> Self::Value;

    /// Emits a selection by a condition.
    fn choose(
        &mut self,
        condition: Self::Value,
        then: Self::Value,
        otherwise: Self::Value,
    ) -> Self::Value;

    /// Emits the dot product of two vectors.
    fn dot(&mut self, left: &[Self::Value], right: &[Self::Value]) -> Self::Value;
}

/// `faceforward`
pub fn face_forward<A: Arithmetic>(
    to: &mut A,
    [n, i, reference]: [&[A::Value]; 3],
) -> Vec<A::Value> {
    let zero = to.number(0.0);
    let product = to.dot(reference, i);
    let faces = to.binary(Operator::Less, product, zero);
    let flipped = |&along: &A::Value| {
        let against = to.negated(along);
        to.choose(faces, along, against)
    };
    n.iter().map(flipped).collect()
}

/// `reflect`
pub fn reflect<A: Arithmetic>(to: &mut A, i: &[A::Value], n: &[A::Value]) -> Vec<A::Value> {
    let product = to.dot(i, n);
    let twice = to.binary(Operator::Add, product, product);
    let reflected = |(&i, &n): (&A::Value, &A::Value)| {
        let back = to.binary(Operator::Multiply, twice, n);
        to.binary(Operator::Subtract, i, back)
    };
    i.iter().zip(n).map(reflected).collect()
}

/// `refract`, by the formula of GLSL ES 3.00 section 8.5.
pub fn refract<A: Arithmetic>(
    to: &mut A,
    i: &[A::Value],
    n: &[A::Value],
    eta: A::Value,
) -> Vec<A::Value> {
    use Operator::{Add, Less, Multiply, Subtract};
    let (zero, one) = (to.number(0.0), to.number(1.0));
    let product = to.dot(n, i);
    let square = to.binary(Multiply, product, product);
    let rest = to.binary(Subtract, one, square);
    let eta_square = to.binary(Multiply, eta, eta);
    let scaled = to.binary(Multiply, eta_square, rest);
    let k = to.binary(Subtract, one, scaled);
    let is_total = to.binary(Less, k, zero);
    let root = to.sqrt(k);
    let along = to.binary(Multiply, eta, product);
    let along = to.binary(Add, along, root);
    let refracted = |(&i, &n): (&A::Value, &A::Value)| {
        let kept = to.binary(Multiply, eta, i);
        let bent = to.binary(Multiply, along, n);
        let made = to.binary(Subtract, kept, bent);
        to.choose(is_total, zero, made)
    };
    i.iter().zip(n).map(refracted).collect()
}

/// The determinant of a square matrix in column-major order, expanded along its first row; `None`
/// if the matrix is empty.
pub fn determinant<A: Arithmetic>(to: &mut A, cells: &[A::Value], size: usize) -> Option<A::Value> {
    use Operator::{Add, Multiply, Subtract};
    match *cells {
        [one] => Some(one),
        [a, b, c, d] => {
            let (left, right) = (to.binary(Multiply, a, d), to.binary(Multiply, c, b));
            Some(to.binary(Subtract, left, right))
        }
        _ => {
            let mut sum = None;
            for (column, &factor) in cells.iter().step_by(size.max(1)).enumerate() {
                let inner = determinant(to, &minor(cells, size, column, 0), size - 1)?;
                let term = to.binary(Multiply, factor, inner);
                sum = Some(match sum {
                    None => term,
                    Some(sum) if column % 2 == 1 => to.binary(Subtract, sum, term),
                    Some(sum) => to.binary(Add, sum, term),
                });
            }
            sum
        }
    }
}

/// The adjugate (the transposed cofactor matrix), which `inverse` divides by the determinant.
pub fn adjugate<A: Arithmetic>(
    to: &mut A,
    cells: &[A::Value],
    size: usize,
) -> Option<Vec<A::Value>> {
    let places = (0..size).flat_map(|column| (0..size).map(move |row| (column, row)));
    let cofactors = places.map(|(column, row)| {
        let value = determinant(to, &minor(cells, size, row, column), size - 1)?;
        Some(match (column + row) % 2 {
            1 => to.negated(value),
            _ => value,
        })
    });
    cofactors.collect()
}

/// The cells of a matrix without one column and one row.
fn minor<V: Copy>(cells: &[V], size: usize, column: usize, row: usize) -> Vec<V> {
    let kept = (0..size * size).filter(|n| n / size != column && n % size != row);
    kept.filter_map(|n| cells.get(n).copied()).collect()
}
