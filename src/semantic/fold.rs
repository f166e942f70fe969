//! Built-in functions of constants.

use super::constant::Value;
use super::types::{Scalar, Type};

/// Computes a built-in function. `args` are the scalars of each argument; `None` where the result is
/// not known.
pub type Fold = fn(args: &[&[Value]]) -> Option<Vec<Value>>;

/// How to compute the function of this name (GLSL ES 3.00 chapter 8).
///
/// `first` is the type of its first argument.
pub fn fold_of(name: &str, first: Type) -> Option<Fold> {
    if name == "transpose" {
        return match first.numeric() {
            Some((_, 2, _)) => Some(transpose::<2>),
            Some((_, 3, _)) => Some(transpose::<3>),
            _ => Some(transpose::<4>),
        };
    }
    angle_or_power(name)
        .or_else(|| common(name))
        .or_else(|| geometric(name))
        .or_else(|| relational_or_packing(name))
}

/// Angles and powers (sections 8.1 and 8.2).
fn angle_or_power(name: &str) -> Option<Fold> {
    Some(match name {
        "radians" => |a| map(a, |x| x * (std::f32::consts::PI / 180.0)),
        "degrees" => |a| map(a, |x| x * (180.0 / std::f32::consts::PI)),
        "sin" => |a| map(a, f32::sin),
        "cos" => |a| map(a, f32::cos),
        "tan" => |a| map(a, f32::tan),
        "asin" => |a| map(a, |x| if x.abs() > 1.0 { 0.0 } else { x.asin() }),
        "acos" => |a| map(a, |x| if x.abs() > 1.0 { 0.0 } else { x.acos() }),
        "atan" => |a| {
            if a.len() == 2 {
                map2(a, f32::atan2)
            } else {
                map(a, f32::atan)
            }
        },
        "sinh" => |a| map(a, f32::sinh),
        "cosh" => |a| map(a, f32::cosh),
        "tanh" => |a| map(a, f32::tanh),
        "asinh" => |a| map(a, f32::asinh),
        "acosh" => |a| map(a, |x| if x < 1.0 { 0.0 } else { x.acosh() }),
        "atanh" => |a| map(a, |x| if x.abs() >= 1.0 { 0.0 } else { x.atanh() }),
        "pow" => |a| {
            map2(a, |x, y| {
                if x < 0.0 || (x == 0.0 && y <= 0.0) {
                    0.0
                } else {
                    x.powf(y)
                }
            })
        },
        "exp" => |a| map(a, f32::exp),
        "log" => |a| map(a, |x| if x <= 0.0 { 0.0 } else { x.ln() }),
        "exp2" => |a| map(a, f32::exp2),
        "log2" => |a| map(a, |x| if x <= 0.0 { 0.0 } else { x.log2() }),
        "sqrt" => |a| map(a, |x| if x < 0.0 { 0.0 } else { x.sqrt() }),
        "inversesqrt" => |a| map(a, |x| if x <= 0.0 { 0.0 } else { 1.0 / x.sqrt() }),
        _ => return None,
    })
}

/// Common functions (section 8.3).
fn common(name: &str) -> Option<Fold> {
    Some(match name {
        "abs" => |a| {
            each(a, |x| match x {
                Value::Int(v) => Value::Int(v.wrapping_abs()),
                v => Value::Float(v.as_float().abs()),
            })
        },
        "sign" => |a| {
            each(a, |x| match x {
                Value::Int(v) => Value::Int(v.signum()),
                v => Value::Float(sign(v.as_float())),
            })
        },
        "floor" => |a| map(a, f32::floor),
        "trunc" => |a| map(a, f32::trunc),
        "round" => |a| map(a, f32::round),
        "roundEven" => |a| map(a, f32::round_ties_even),
        "ceil" => |a| map(a, f32::ceil),
        "fract" => |a| map(a, |x| x - x.floor()),
        "mod" => |a| map2(a, |x, y| x - y * (x / y).floor()),
        "min" => |a| pair(a, |x, y| if less(y, x) { y } else { x }),
        "max" => |a| pair(a, |x, y| if less(x, y) { y } else { x }),
        "clamp" => |a| {
            triple(a, |x, lo, hi| {
                if less(hi, lo) {
                    // Undefined; the browser gives 0.
                    zero_of(lo)
                } else if !less(lo, x) {
                    lo
                } else if less(hi, x) {
                    hi
                } else {
                    x
                }
            })
        },
        "mix" => |a| {
            triple(a, |x, y, t| match t {
                Value::Bool(choose) => {
                    if choose {
                        y
                    } else {
                        x
                    }
                }
                t => {
                    Value::Float(x.as_float() * (1.0 - t.as_float()) + y.as_float() * t.as_float())
                }
            })
        },
        "step" => |a| map2(a, |edge, x| if x < edge { 0.0 } else { 1.0 }),
        "smoothstep" => |a| {
            triple(a, |e0, e1, x| {
                let (e0, e1, x) = (e0.as_float(), e1.as_float(), x.as_float());
                if e0 >= e1 {
                    // Undefined; the browser gives 0.
                    return Value::Float(0.0);
                }
                let t = ((x - e0) / (e1 - e0)).clamp(0.0, 1.0);
                // What is no number counts as 0.
                let t = if t.is_nan() { 0.0 } else { t };
                Value::Float(t * t * (3.0 - 2.0 * t))
            })
        },
        _ => return None,
    })
}

/// Vectors and matrices (sections 8.5 and 8.6).
fn geometric(name: &str) -> Option<Fold> {
    Some(match name {
        "length" => |a| scalar(floats(a.first()?).iter().map(|x| x * x).sum::<f32>().sqrt()),
        "distance" => |a| scalar(zip(a)?.map(|(x, y)| (x - y) * (x - y)).sum::<f32>().sqrt()),
        "dot" => |a| scalar(zip(a)?.map(|(x, y)| x * y).sum()),
        "cross" => cross,
        "normalize" => |a| {
            let x = floats(a.first()?);
            let length = x.iter().map(|v| v * v).sum::<f32>().sqrt();
            Some(
                x.iter()
                    .map(|v| Value::Float(if length == 0.0 { 0.0 } else { v / length }))
                    .collect(),
            )
        },
        "faceforward" | "reflect" | "refract" => vector_function(name)?,
        "matrixCompMult" => |a| map2(a, |x, y| x * y),
        "determinant" => |a| scalar(determinant(&square(a.first()?)?)),
        "outerProduct" | "inverse" => matrix_function(name)?,
        _ => return None,
    })
}

/// Comparisons, bit patterns and packing (sections 8.3, 8.4 and 8.7).
fn relational_or_packing(name: &str) -> Option<Fold> {
    Some(match name {
        "isnan" => |a| each(a, |x| Value::Bool(x.as_float().is_nan())),
        "isinf" => |a| each(a, |x| Value::Bool(x.as_float().is_infinite())),
        "floatBitsToInt" => |a| each(a, |x| Value::Int(x.as_float().to_bits() as i32)),
        "floatBitsToUint" => |a| each(a, |x| Value::Uint(x.as_float().to_bits())),
        "intBitsToFloat" | "uintBitsToFloat" => {
            |a| each(a, |x| Value::Float(f32::from_bits(x.as_uint())))
        }
        "packSnorm2x16" => |a| {
            pack(a, |x| {
                ((x.clamp(-1.0, 1.0) * 32767.0).round() as i16) as u16
            })
        },
        "packUnorm2x16" => |a| pack(a, |x| (x.clamp(0.0, 1.0) * 65535.0).round() as u16),
        "packHalf2x16" => |a| pack(a, half_bits),
        "unpackHalf2x16" => |a| unpack(a, half_value),
        "unpackSnorm2x16" => |a| unpack(a, |x| (x as i16 as f32 / 32767.0).clamp(-1.0, 1.0)),
        "unpackUnorm2x16" => |a| unpack(a, |x| x as f32 / 65535.0),
        "lessThan" => |a| pair(a, |x, y| Value::Bool(less(x, y))),
        "lessThanEqual" => |a| pair(a, |x, y| Value::Bool(less(x, y) || x == y)),
        "greaterThan" => |a| pair(a, |x, y| Value::Bool(less(y, x))),
        "greaterThanEqual" => |a| pair(a, |x, y| Value::Bool(less(y, x) || x == y)),
        "equal" => |a| pair(a, |x, y| Value::Bool(x == y)),
        "notEqual" => |a| pair(a, |x, y| Value::Bool(x != y)),
        "any" => |a| Some(vec![Value::Bool(a.first()?.iter().any(|v| v.as_bool()))]),
        "all" => |a| Some(vec![Value::Bool(a.first()?.iter().all(|v| v.as_bool()))]),
        "not" => |a| each(a, |x| Value::Bool(!x.as_bool())),
        _ => return None,
    })
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

fn less(x: Value, y: Value) -> bool {
    match (x, y) {
        (Value::Int(x), Value::Int(y)) => x < y,
        (Value::Uint(x), Value::Uint(y)) => x < y,
        (x, y) => x.as_float() < y.as_float(),
    }
}

fn each(args: &[&[Value]], f: impl Fn(Value) -> Value) -> Option<Vec<Value>> {
    Some(args.first()?.iter().map(|&x| f(x)).collect())
}

fn map(args: &[&[Value]], f: impl Fn(f32) -> f32) -> Option<Vec<Value>> {
    each(args, |x| Value::Float(f(x.as_float())))
}

/// The component `i` of an argument; a scalar has the same everywhere.
fn at(arg: &[Value], i: usize) -> Option<Value> {
    if arg.len() == 1 {
        arg.first().copied()
    } else {
        arg.get(i).copied()
    }
}

fn pair(args: &[&[Value]], f: impl Fn(Value, Value) -> Value) -> Option<Vec<Value>> {
    let &[x, y] = args else { return None };
    (0..x.len().max(y.len()))
        .map(|i| Some(f(at(x, i)?, at(y, i)?)))
        .collect()
}

fn map2(args: &[&[Value]], f: impl Fn(f32, f32) -> f32) -> Option<Vec<Value>> {
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

fn zip<'a>(args: &'a [&[Value]]) -> Option<impl Iterator<Item = (f32, f32)> + use<'a>> {
    let &[x, y] = args else { return None };
    Some(x.iter().zip(y).map(|(x, y)| (x.as_float(), y.as_float())))
}

fn scalar(x: f32) -> Option<Vec<Value>> {
    Some(vec![Value::Float(x)])
}

fn values(x: impl IntoIterator<Item = f32>) -> Option<Vec<Value>> {
    Some(x.into_iter().map(Value::Float).collect())
}

fn cross(args: &[&[Value]]) -> Option<Vec<Value>> {
    let (&[x, y, z], &[u, v, w]) = (
        floats(args.first()?).as_slice(),
        floats(args.get(1)?).as_slice(),
    ) else {
        return None;
    };
    values([y * w - z * v, z * u - x * w, x * v - y * u])
}

fn pack(args: &[&[Value]], f: impl Fn(f32) -> u16) -> Option<Vec<Value>> {
    let &[x, y] = *args.first()? else { return None };
    Some(vec![Value::Uint(
        f(x.as_float()) as u32 | (f(y.as_float()) as u32) << 16,
    )])
}

fn unpack(args: &[&[Value]], f: impl Fn(u16) -> f32) -> Option<Vec<Value>> {
    let &[x] = *args.first()? else { return None };
    let bits = x.to(Scalar::Uint).as_uint();
    values([f(bits as u16), f((bits >> 16) as u16)])
}

fn vector_function(name: &str) -> Option<Fold> {
    Some(match name {
        "faceforward" => |a| {
            let dot: f32 = zip(a.get(1..3)?)?.map(|(x, y)| x * y).sum();
            let sign = if dot < 0.0 { 1.0 } else { -1.0 };
            values(floats(a.first()?).into_iter().map(|x| x * sign))
        },
        "reflect" => |a| {
            let dot: f32 = zip(a)?.map(|(x, y)| x * y).sum();
            values(zip(a)?.map(|(i, n)| i - 2.0 * dot * n))
        },
        "refract" => |a| {
            let eta = a.get(2)?.first()?.as_float();
            let pair = a.get(..2)?;
            let dot: f32 = zip(pair)?.map(|(i, n)| i * n).sum();
            let k = 1.0 - eta * eta * (1.0 - dot * dot);
            values(zip(pair)?.map(|(i, n)| {
                if k < 0.0 {
                    0.0
                } else {
                    eta * i - (eta * dot + k.sqrt()) * n
                }
            }))
        },
        _ => return None,
    })
}

/// A matrix of so many columns, its rows made columns.
fn transpose<const COLUMNS: usize>(args: &[&[Value]]) -> Option<Vec<Value>> {
    let &[m] = args else { return None };
    let rows = m.len() / COLUMNS;
    let at = |i: usize| m.get(i % COLUMNS * rows + i / COLUMNS).copied();
    (0..m.len()).map(at).collect()
}

/// The 16 bits that are nearest to a number.
fn half_bits(x: f32) -> u16 {
    let sign = if x.is_sign_negative() { 0x8000 } else { 0 };
    let bits = x.abs().to_bits();
    sign | if x.is_nan() {
        0x7fff
    } else if bits >= 0x4780_0000 {
        0x7c00
    } else if bits >= 0x3880_0000 {
        // Rounded to even, with the exponent counted from another zero.
        let odd = bits >> 13 & 1;
        ((bits - 0x3800_0000 + 0xfff + odd) >> 13) as u16
    } else {
        // Too small for a leading one: counted in steps of 2^-24.
        (x.abs() * 16_777_216.0).round_ties_even() as u16
    }
}

/// The number that 16 bits stand for.
fn half_value(bits: u16) -> f32 {
    let (exponent, rest) = (bits >> 10 & 0x1f, (bits & 0x3ff) as f32);
    let size = match exponent {
        0 => rest / 16_777_216.0,
        31 if rest == 0.0 => f32::INFINITY,
        31 => f32::NAN,
        e => (1.0 + rest / 1024.0) * 2f32.powi(e as i32 - 15),
    };
    if bits & 0x8000 != 0 { -size } else { size }
}

/// A square matrix as columns.
fn square(arg: &[Value]) -> Option<Vec<Vec<f32>>> {
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

fn determinant(m: &[Vec<f32>]) -> f32 {
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

fn matrix_function(name: &str) -> Option<Fold> {
    Some(match name {
        "outerProduct" => |a| {
            let (c, r) = (floats(a.first()?), floats(a.get(1)?));
            values(r.iter().flat_map(|y| c.iter().map(move |x| x * y)))
        },
        "inverse" => |a| {
            let m = square(a.first()?)?;
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
        },
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(name: &str, args: &[&[f32]], expected: &[f32]) {
        let args: Vec<Vec<Value>> = args
            .iter()
            .map(|a| a.iter().map(|&x| Value::Float(x)).collect())
            .collect();
        let args: Vec<&[Value]> = args.iter().map(Vec::as_slice).collect();
        let ty = Type::matrix(2, args[0].len() as u8 / 2);
        let found = fold_of(name, ty).unwrap()(&args).unwrap();
        let found: Vec<f32> = found.iter().map(|v| v.as_float()).collect();
        assert!(
            found
                .iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-5),
            "{name}: {found:?}"
        );
        assert_eq!(found.len(), expected.len());
    }

    #[test]
    fn functions_of_constants_are_computed() {
        check("mod", &[&[-1.0], &[3.0]], &[2.0]);
        check("clamp", &[&[5.0, -5.0], &[0.0], &[1.0]], &[1.0, 0.0]);
        check("mix", &[&[0.0, 2.0], &[4.0, 4.0], &[0.5]], &[2.0, 3.0]);
        check(
            "cross",
            &[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]],
            &[0.0, 0.0, 1.0],
        );
        check("length", &[&[3.0, 4.0]], &[5.0]);
        check("determinant", &[&[1.0, 2.0, 3.0, 4.0]], &[-2.0]);
        check("inverse", &[&[2.0, 0.0, 0.0, 4.0]], &[0.5, 0.0, 0.0, 0.25]);
        check("transpose", &[&[1.0, 2.0, 3.0, 4.0]], &[1.0, 3.0, 2.0, 4.0]);
        check(
            "transpose",
            &[&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]],
            &[1.0, 4.0, 2.0, 5.0, 3.0, 6.0],
        );
        check("reflect", &[&[1.0, -1.0], &[0.0, 1.0]], &[1.0, 1.0]);
    }

    #[test]
    fn what_is_undefined_is_what_the_browser_makes_of_it() {
        check("clamp", &[&[3.0], &[7.0], &[1.0]], &[0.0]);
        check("clamp", &[&[f32::NAN], &[1.0], &[2.0]], &[1.0]);
        check("smoothstep", &[&[1.0], &[0.5], &[0.7]], &[0.0]);
        check("smoothstep", &[&[0.0], &[1.0], &[f32::NAN]], &[0.0]);
        assert_eq!(Value::Float(f32::NAN).as_int(), i32::MIN);
        assert_eq!(Value::Float(1e20).as_int(), i32::MIN);
    }

    #[test]
    fn halves_are_packed_as_ieee_754_says() {
        for (number, bits) in [
            (1.0, 0x3c00),
            (-2.5, 0xc100),
            (65504.0, 0x7bff),
            (5.960_464_5e-8, 1),
            (f32::INFINITY, 0x7c00),
        ] {
            assert_eq!((half_bits(number), half_value(bits)), (bits, number));
        }
    }
}
