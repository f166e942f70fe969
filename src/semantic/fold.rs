//! Constant folding of built-in functions.

use super::constant::Value;
use super::types::{Scalar, Type};
use super::undefined::Undefined;
use shaderlint_math as math;
use shaderlint_math::{of_one, of_two};

/// Evaluates a built-in function. `args` has the scalars of each argument; `None` if the result is
/// unknown.
pub type Fold = fn(args: &[&[Value]]) -> Option<Vec<Value>>;

/// Evaluates a built-in function of a matrix with this many columns.
pub type MatrixFold = fn(columns: usize, args: &[&[Value]]) -> Option<Vec<Value>>;

/// How a built-in function is evaluated for constant arguments (GLSL ES 3.00 chapter 8).
#[derive(Clone, Copy, Debug)]
pub enum Folding {
    /// Never; the result is not a constant expression.
    Never,
    /// From the scalars of the arguments.
    Values(Fold),
    /// From the scalars of a matrix, with its number of columns.
    ByColumns(MatrixFold),
}

impl Folding {
    /// Evaluates the function; `first` is the type of the first argument.
    pub fn fold(self, first: Type, args: &[&[Value]]) -> Option<Vec<Value>> {
        match self {
            Folding::Never => None,
            Folding::Values(fold) => fold(args),
            Folding::ByColumns(fold) => fold(first.numeric()?.1 as usize, args),
        }
    }
}

pub(super) fn arc_tangent(args: &[&[Value]]) -> Option<Vec<Value>> {
    if args.len() == 2 {
        map2(args, |y, x| of_two(math::atan2, y, x))
    } else {
        map(args, |x| of_one(math::atan, x))
    }
}

pub(super) fn absolute(args: &[&[Value]]) -> Option<Vec<Value>> {
    each(args, |x| match x {
        Value::Int(v) => Value::Int(v.wrapping_abs()),
        v => Value::Float(v.as_float().abs()),
    })
}

pub(super) fn signum(args: &[&[Value]]) -> Option<Vec<Value>> {
    each(args, |x| match x {
        Value::Int(v) => Value::Int(v.signum()),
        v => Value::Float(sign(v.as_float())),
    })
}

pub(super) fn clamp(args: &[&[Value]]) -> Option<Vec<Value>> {
    triple(args, |x, lo, hi| {
        if !less(lo, x) {
            lo
        } else if less(hi, x) {
            hi
        } else {
            x
        }
    })
}

pub(super) fn mix(args: &[&[Value]]) -> Option<Vec<Value>> {
    triple(args, |x, y, t| match t {
        Value::Bool(true) => y,
        Value::Bool(false) => x,
        t => Value::Float(x.as_float() * (1.0 - t.as_float()) + y.as_float() * t.as_float()),
    })
}

pub(super) fn smoothstep(args: &[&[Value]]) -> Option<Vec<Value>> {
    triple(args, |e0, e1, x| {
        let (e0, e1, x) = (e0.as_float(), e1.as_float(), x.as_float());
        let t = ((x - e0) / (e1 - e0)).clamp(0.0, 1.0);
        // NaN counts as 0.
        let t = if t.is_nan() { 0.0 } else { t };
        Value::Float(t * t * (3.0 - 2.0 * t))
    })
}

pub(super) fn float_of_bits(args: &[&[Value]]) -> Option<Vec<Value>> {
    each(args, |x| Value::Float(f32::from_bits(x.as_uint())))
}

pub(super) fn length(args: &[&[Value]]) -> Option<Vec<Value>> {
    let x = floats(args.first()?);
    scalar(x.iter().map(|x| x * x).sum::<f32>().sqrt())
}

pub(super) fn distance(args: &[&[Value]]) -> Option<Vec<Value>> {
    let squares = zip(args)?.map(|(x, y)| (x - y) * (x - y));
    scalar(squares.sum::<f32>().sqrt())
}

pub(super) fn normalize(args: &[&[Value]]) -> Option<Vec<Value>> {
    let x = floats(args.first()?);
    let length = x.iter().map(|v| v * v).sum::<f32>().sqrt();
    values(
        x.iter()
            .map(|v| if length == 0.0 { 0.0 } else { v / length }),
    )
}

fn sign(x: f32) -> f32 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

fn zero_of(like: Value) -> Value {
    match like {
        Value::Int(_) => Value::Int(0),
        Value::Uint(_) => Value::Uint(0),
        _ => Value::Float(0.0),
    }
}

/// Sets the components whose result is undefined to 0.
pub(super) fn set_undefined_to_zero(made: &mut [Value], undefined: Undefined, args: &[&[Value]]) {
    for (i, value) in made.iter_mut().enumerate() {
        let operand = |number: usize| Some(at(args.get(number)?, i)?.as_double());
        if undefined.holds(operand) {
            *value = zero_of(*value);
        }
    }
}

pub(super) fn less(x: Value, y: Value) -> bool {
    match (x, y) {
        (Value::Int(x), Value::Int(y)) => x < y,
        (Value::Uint(x), Value::Uint(y)) => x < y,
        (x, y) => x.as_float() < y.as_float(),
    }
}

pub(super) fn each(args: &[&[Value]], f: impl Fn(Value) -> Value) -> Option<Vec<Value>> {
    Some(args.first()?.iter().map(|&x| f(x)).collect())
}

pub(super) fn map(args: &[&[Value]], f: impl Fn(f32) -> f32) -> Option<Vec<Value>> {
    each(args, |x| Value::Float(f(x.as_float())))
}

/// Component `i` of an argument; a scalar is the same for all.
fn at(arg: &[Value], i: usize) -> Option<Value> {
    if arg.len() == 1 {
        arg.first().copied()
    } else {
        arg.get(i).copied()
    }
}

pub(super) fn pair(args: &[&[Value]], f: impl Fn(Value, Value) -> Value) -> Option<Vec<Value>> {
    let &[x, y] = args else { return None };
    (0..x.len().max(y.len()))
        .map(|i| Some(f(at(x, i)?, at(y, i)?)))
        .collect()
}

pub(super) fn map2(args: &[&[Value]], f: impl Fn(f32, f32) -> f32) -> Option<Vec<Value>> {
    pair(args, |x, y| Value::Float(f(x.as_float(), y.as_float())))
}

fn triple(args: &[&[Value]], f: impl Fn(Value, Value, Value) -> Value) -> Option<Vec<Value>> {
    let &[x, y, z] = args else { return None };
    let len = x.len().max(y.len()).max(z.len());
    (0..len)
        .map(|i| Some(f(at(x, i)?, at(y, i)?, at(z, i)?)))
        .collect()
}

fn floats(arg: &[Value]) -> Vec<f32> {
    arg.iter().map(|v| v.as_float()).collect()
}

pub(super) fn zip<'a>(args: &'a [&[Value]]) -> Option<impl Iterator<Item = (f32, f32)> + use<'a>> {
    let &[x, y] = args else { return None };
    Some(x.iter().zip(y).map(|(x, y)| (x.as_float(), y.as_float())))
}

pub(super) fn scalar(x: f32) -> Option<Vec<Value>> {
    Some(vec![Value::Float(x)])
}

fn values(x: impl IntoIterator<Item = f32>) -> Option<Vec<Value>> {
    Some(x.into_iter().map(Value::Float).collect())
}

pub(super) fn cross(args: &[&[Value]]) -> Option<Vec<Value>> {
    let (&[x, y, z], &[u, v, w]) = (
        floats(args.first()?).as_slice(),
        floats(args.get(1)?).as_slice(),
    ) else {
        return None;
    };
    values([y * w - z * v, z * u - x * w, x * v - y * u])
}

pub(super) fn pack(args: &[&[Value]], f: impl Fn(f32) -> u16) -> Option<Vec<Value>> {
    let &[x, y] = *args.first()? else { return None };
    Some(vec![Value::Uint(
        f(x.as_float()) as u32 | (f(y.as_float()) as u32) << 16,
    )])
}

pub(super) fn unpack(args: &[&[Value]], f: impl Fn(u16) -> f32) -> Option<Vec<Value>> {
    let &[x] = *args.first()? else { return None };
    let bits = x.to(Scalar::Uint).as_uint();
    values([f(bits as u16), f((bits >> 16) as u16)])
}

pub(super) fn face_forward(args: &[&[Value]]) -> Option<Vec<Value>> {
    let dot: f32 = zip(args.get(1..3)?)?.map(|(x, y)| x * y).sum();
    let sign = if dot < 0.0 { 1.0 } else { -1.0 };
    values(floats(args.first()?).into_iter().map(|x| x * sign))
}

pub(super) fn reflect(args: &[&[Value]]) -> Option<Vec<Value>> {
    let dot: f32 = zip(args)?.map(|(x, y)| x * y).sum();
    values(zip(args)?.map(|(i, n)| i - 2.0 * dot * n))
}

pub(super) fn refract(args: &[&[Value]]) -> Option<Vec<Value>> {
    let eta = args.get(2)?.first()?.as_float();
    let pair = args.get(..2)?;
    let dot: f32 = zip(pair)?.map(|(i, n)| i * n).sum();
    let k = 1.0 - eta * eta * (1.0 - dot * dot);
    values(zip(pair)?.map(|(i, n)| {
        if k < 0.0 {
            0.0
        } else {
            eta * i - (eta * dot + k.sqrt()) * n
        }
    }))
}

/// Transposes a matrix with this many columns.
pub(super) fn transpose(columns: usize, args: &[&[Value]]) -> Option<Vec<Value>> {
    let &[m] = args else { return None };
    let rows = m.len() / columns;
    let at = |i: usize| m.get(i % columns * rows + i / columns).copied();
    (0..m.len()).map(at).collect()
}

/// Encodes a number from -1 to 1 in 16 bits.
pub(super) fn snorm_bits(x: f32) -> u16 {
    ((x.clamp(-1.0, 1.0) * 32767.0).round() as i16) as u16
}

/// A square matrix as columns.
pub(super) fn square(arg: &[Value]) -> Option<Vec<Vec<f32>>> {
    let n = match arg.len() {
        4 => 2,
        9 => 3,
        16 => 4,
        _ => return None,
    };
    Some(floats(arg).chunks(n).map(<[f32]>::to_vec).collect())
}

fn minor(m: &[Vec<f32>], column: usize, row: usize) -> Vec<Vec<f32>> {
    let without = |v: &Vec<f32>| {
        v.iter()
            .enumerate()
            .filter(|(i, _)| *i != row)
            .map(|(_, x)| *x)
            .collect()
    };
    m.iter()
        .enumerate()
        .filter(|(i, _)| *i != column)
        .map(|(_, c)| without(c))
        .collect()
}

pub(super) fn determinant(m: &[Vec<f32>]) -> f32 {
    if let [column] = m {
        return column.first().copied().unwrap_or(0.0);
    }
    m.iter()
        .enumerate()
        .map(|(i, column)| {
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            sign * column.first().copied().unwrap_or(0.0) * determinant(&minor(m, i, 0))
        })
        .sum()
}

pub(super) fn outer_product(args: &[&[Value]]) -> Option<Vec<Value>> {
    let (c, r) = (floats(args.first()?), floats(args.get(1)?));
    values(r.iter().flat_map(|y| c.iter().map(move |x| x * y)))
}

pub(super) fn inverse(args: &[&[Value]]) -> Option<Vec<Value>> {
    let m = square(args.first()?)?;
    let n = m.len();
    let det = determinant(&m);
    values((0..n * n).map(|i| {
        let (column, row) = (i / n, i % n);
        let sign = if (column + row) % 2 == 0 { 1.0 } else { -1.0 };
        let cofactor = if n == 1 {
            1.0
        } else {
            determinant(&minor(&m, row, column))
        };
        if det == 0.0 {
            0.0
        } else {
            sign * cofactor / det
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BuiltinId::{self, *};
    use std::f32::consts::PI;

    #[track_caller]
    fn check(id: BuiltinId, args: &[&[f32]], expected: &[f32]) {
        let args: Vec<Vec<Value>> = args
            .iter()
            .map(|a| a.iter().map(|&x| Value::Float(x)).collect())
            .collect();
        let args: Vec<&[Value]> = args.iter().map(Vec::as_slice).collect();
        let ty = Type::matrix(2, args[0].len() as u8 / 2);
        let found = id.fold(ty, &args).unwrap();
        let found: Vec<f32> = found.iter().map(|v| v.as_float()).collect();
        assert!(
            found
                .iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-5),
            "{id:?}: {found:?}"
        );
        assert_eq!(found.len(), expected.len());
    }

    #[test]
    fn built_in_functions_of_constants_are_folded() {
        check(Mod, &[&[-1.0], &[3.0]], &[2.0]);
        check(Clamp, &[&[5.0, -5.0], &[0.0], &[1.0]], &[1.0, 0.0]);
        check(Mix, &[&[0.0, 2.0], &[4.0, 4.0], &[0.5]], &[2.0, 3.0]);
        check(
            Cross,
            &[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]],
            &[0.0, 0.0, 1.0],
        );
        check(Length, &[&[3.0, 4.0]], &[5.0]);
        check(Sqrt, &[&[4.0, -4.0]], &[2.0, 0.0]);
        check(Pow, &[&[-2.0, 2.0, 0.0], &[2.0]], &[0.0, 4.0, 0.0]);
        check(Clamp, &[&[5.0, 5.0], &[2.0, 1.0], &[1.0, 2.0]], &[0.0, 2.0]);
        check(Smoothstep, &[&[1.0, 0.0], &[1.0], &[2.0]], &[0.0, 1.0]);
        check(Atan, &[&[-0.0, 1.0], &[-0.0, 1.0]], &[0.0, PI / 4.0]);
        check(Determinant, &[&[1.0, 2.0, 3.0, 4.0]], &[-2.0]);
        check(Inverse, &[&[2.0, 0.0, 0.0, 4.0]], &[0.5, 0.0, 0.0, 0.25]);
        check(Transpose, &[&[1.0, 2.0, 3.0, 4.0]], &[1.0, 3.0, 2.0, 4.0]);
        check(
            Transpose,
            &[&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]],
            &[1.0, 4.0, 2.0, 5.0, 3.0, 6.0],
        );
        check(Reflect, &[&[1.0, -1.0], &[0.0, 1.0]], &[1.0, 1.0]);
    }

    #[test]
    fn undefined_results_are_folded_as_in_the_browser() {
        check(Clamp, &[&[3.0], &[7.0], &[1.0]], &[0.0]);
        check(Clamp, &[&[f32::NAN], &[1.0], &[2.0]], &[1.0]);
        check(Smoothstep, &[&[1.0], &[0.5], &[0.7]], &[0.0]);
        check(Smoothstep, &[&[0.0], &[1.0], &[f32::NAN]], &[0.0]);
        assert_eq!(Value::Float(f32::NAN).as_int(), i32::MIN);
        assert_eq!(Value::Float(1e20).as_int(), i32::MIN);
    }
}
