//! Accuracy tests against double precision.

use super::common::clamp;
use super::*;
use fearless_simd::{f32x8 as FloatLanes, i32x8 as IntLanes, prelude::*, u32x8 as UintLanes};

/// Eight numbers, for the instructions of every machine.
type Floats = FloatLanes<Baseline>;
type Ints = IntLanes<Baseline>;
type Uints = UintLanes<Baseline>;

/// The same number in every lane.
fn floats(x: f32) -> Floats {
    Floats::splat(baseline(), x)
}

fn ints(x: i32) -> Ints {
    Ints::splat(baseline(), x)
}

fn uints(x: u32) -> Uints {
    Uints::splat(baseline(), x)
}

/// Pseudo-random floats of both signs and all exponents, the same in every run.
fn numbers(count: usize) -> impl Iterator<Item = f32> {
    let mut state = 0x9e37_79b9_u32;
    std::iter::repeat_with(move || {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        f32::from_bits(state)
    })
    .filter(|x| x.is_finite())
    .take(count)
}

/// The error in ULP (units in the last place).
fn ulps(found: f32, expected: f64) -> f64 {
    let nearest = expected as f32;
    if found == nearest || found.is_nan() && nearest.is_nan() {
        return 0.0;
    }
    let next = f64::from(nearest.abs().next_up().min(f32::MAX));
    let unit = (next - f64::from(nearest.abs())).max(f64::from(f32::MIN_POSITIVE) / 8_388_608.0);
    (f64::from(found) - expected).abs() / unit
}

/// Checks that the error of a unary function stays within `bound` ULP of a double-precision
/// reference.
#[track_caller]
fn check(
    f: impl Fn(Floats) -> Floats,
    exact: impl Fn(f64) -> f64,
    within: impl Fn(f32) -> bool,
    bound: f64,
) {
    let mut worst = (0.0, 0.0);
    for x in numbers(400_000).filter(|x| within(*x)) {
        let found = f(floats(x))[0];
        let error = ulps(found, exact(f64::from(x)));
        if error.is_nan() || error > worst.0 {
            worst = (error, x);
        }
    }
    assert!(worst.0 <= bound, "{} units at {:e}", worst.0, worst.1);
}

/// Checks a unary function at selected points, bit by bit except for the payload of NaN.
#[track_caller]
fn exactly(f: impl Fn(Floats) -> Floats, pairs: &[(f32, f32)]) {
    for (x, expected) in pairs {
        let found = f(floats(*x))[7];
        let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
        assert!(same, "{x:?}: {found:?}, not {expected:?}");
    }
}

const INF: f32 = f32::INFINITY;
const NAN: f32 = f32::NAN;

#[test]
fn sines_are_accurate_for_angles_of_any_size() {
    let below = |most: f32| move |x: f32| x.abs() < most;
    let above = |least: f32| move |x: f32| x.abs() >= least;
    check(sin, f64::sin, below(8192.0), 2.0);
    check(cos, f64::cos, below(8192.0), 2.0);
    check(tan, f64::tan, below(8192.0), 3.5);
    check(sin, f64::sin, above(8192.0), 0.6);
    check(cos, f64::cos, above(8192.0), 0.6);
    check(tan, f64::tan, above(8192.0), 0.6);
    exactly(sin, &[(0.0, 0.0), (INF, NAN), (NAN, NAN)]);
    exactly(cos, &[(0.0, 1.0), (-0.0, 1.0), (-INF, NAN), (NAN, NAN)]);
    exactly(tan, &[(0.0, 0.0), (INF, NAN), (NAN, NAN)]);
}

#[test]
fn lanes_do_not_depend_on_each_other() {
    let mixed = [0.5, 1e30, -7.25, 3e5, 0.0, 1e-40, INF, NAN];
    let other = [0.0, 1e30, 2.0, -1.0, 0.0, 3.0, INF, 2.0];
    let functions: [fn(Floats) -> Floats; 12] = [
        sin, cos, tan, asin, acos, atan, exp, exp2, log, log2, sqrt, floor,
    ];
    let pairs: [fn(Floats, Floats) -> Floats; 3] = [pow, atan2, modulo];
    let bits = |x: Floats| <[f32; 8]>::from(x).map(|x| if x.is_nan() { 0 } else { x.to_bits() });
    for at in 0..8 {
        let (x, y) = (floats(mixed[at]), floats(other[at]));
        for f in functions {
            assert_eq!(bits(f(x))[0], bits(f(mixed.simd_into(baseline())))[at]);
        }
        for f in pairs {
            let beside = f(mixed.simd_into(baseline()), other.simd_into(baseline()));
            assert_eq!(bits(f(x, y))[0], bits(beside)[at]);
        }
    }
}

#[test]
fn inverse_trigonometric_functions_are_accurate() {
    check(asin, f64::asin, |_| true, 2.5);
    check(acos, f64::acos, |_| true, 2.0);
    check(atan, f64::atan, |_| true, 2.5);
    exactly(
        asin,
        &[(1.0, std::f32::consts::FRAC_PI_2), (-0.0, -0.0), (1.5, NAN)],
    );
    exactly(
        acos,
        &[(1.0, 0.0), (-1.0, std::f32::consts::PI), (-1.5, NAN)],
    );
    exactly(
        atan,
        &[(INF, std::f32::consts::FRAC_PI_2), (-0.0, -0.0), (NAN, NAN)],
    );
    let values = [0.0, -0.0, 1.0, -1.0, -1e-35, 1e35, INF, -INF];
    for y in values {
        for x in values {
            let expected = match x == 0.0 && y == 0.0 {
                true => f64::from(y),
                false => f64::from(y).atan2(f64::from(x)),
            };
            exactly(|y| atan2(y, floats(x)), &[(y, expected as f32)]);
        }
    }
    let y = numbers(200_000);
    for (y, x) in y.zip(numbers(200_100).skip(100)) {
        let found = atan2(floats(y), floats(x))[0];
        let error = ulps(found, f64::from(y).atan2(f64::from(x)));
        assert!(error <= 2.5, "{error} at {y:e}, {x:e}");
    }
}

#[test]
fn exponentials_and_logarithms_are_accurate() {
    check(exp, f64::exp, |_| true, 1.5);
    check(exp2, f64::exp2, |_| true, 1.5);
    check(log, f64::ln, |x| x >= f32::MIN_POSITIVE, 1.0);
    check(log2, f64::log2, |x| x >= f32::MIN_POSITIVE, 1.5);
    exactly(exp, &[(0.0, 1.0), (INF, INF), (-INF, 0.0), (NAN, NAN)]);
    exactly(
        exp2,
        &[(10.0, 1024.0), (-1.0, 0.5), (-INF, 0.0), (200.0, INF)],
    );
    exactly(log, &[(1.0, 0.0), (INF, INF), (NAN, NAN)]);
    exactly(log2, &[(8.0, 3.0), (0.25, -2.0), (INF, INF), (NAN, NAN)]);
}

/// Undefined results are those of Chromium's software renderer.
#[test]
fn undefined_results_are_those_of_the_browser() {
    exactly(log2, &[(-8.0, 3.0), (0.0, -127.0), (-0.0, -127.0)]);
    exactly(log, &[(0.0, -88.029_69), (-1.0, 0.0), (-INF, 88.722_84)]);
    let two = floats(2.0);
    exactly(
        |x| pow(x, two),
        &[(-1.75, 3.0625), (-1.0, 1.0), (-0.5, 0.25)],
    );
    exactly(|x| pow(x, floats(0.0)), &[(0.0, 1.0), (-0.0, 1.0)]);
    exactly(|x| pow(x, -two), &[(-2.0, 0.25), (0.0, INF)]);
    exactly(
        |x| pow(x, floats(-1.0)),
        &[(0.0, 2f32.powi(127)), (-0.0, 2f32.powi(127))],
    );
    exactly(sqrt, &[(-1.0, NAN), (-0.0, -0.0)]);
    exactly(inverse_sqrt, &[(0.0, INF), (-0.0, -INF), (-4.0, NAN)]);
    exactly(atanh, &[(1.0, INF), (-1.0, -44.014_847)]);
    exactly(
        |x| round_even(atanh(x) * floats(1e4)),
        &[(2.0, 5493.0), (-7.0, -1438.0)],
    );
}

#[test]
fn min_and_max_return_the_second_operand_for_nan() {
    let two = floats(2.0);
    exactly(|x| max(x, two), &[(NAN, 2.0), (3.0, 3.0), (1.0, 2.0)]);
    exactly(|x| max(two, x), &[(NAN, NAN), (3.0, 3.0), (1.0, 2.0)]);
    exactly(|x| min(x, two), &[(NAN, 2.0), (3.0, 2.0), (1.0, 1.0)]);
    exactly(|x| min(two, x), &[(NAN, NAN), (-INF, -INF)]);
    exactly(|x| max(x, x), &[(NAN, NAN)]);
    exactly(|x| max_number(two, x), &[(NAN, 2.0), (3.0, 3.0)]);
    exactly(|x| max_number(x, two), &[(NAN, 2.0), (1.0, 2.0)]);
    exactly(|x| min_number(two, x), &[(NAN, 2.0), (-INF, -INF)]);
    exactly(|x| min_number(x, two), &[(NAN, 2.0), (3.0, 2.0)]);
    exactly(
        |x| clamp(x, floats(0.0), two),
        &[(NAN, 0.0), (INF, 2.0), (1.5, 1.5)],
    );
    exactly(|x| smoothstep(floats(0.0), two, x), &[(NAN, 0.0)]);
    exactly(|x| step(two, x), &[(NAN, 0.0)]);
}

#[test]
fn powers_of_integers_are_exact() {
    for x in 0..=4000 {
        let x = x as f32;
        exactly(|x| pow(x, floats(2.0)), &[(x, x * x)]);
    }
    for y in -126..=127 {
        exactly(|y| pow(floats(2.0), y), &[(y as f32, 2f32.powi(y))]);
    }
    let bases = numbers(400_000).filter(|x| x.is_normal());
    for (x, y) in bases.zip(numbers(400_100).skip(100)) {
        let found = pow(floats(x.abs()), floats(y))[0];
        let error = ulps(found, f64::from(x.abs()).powf(f64::from(y)));
        assert!(error <= 1.0, "{error} at {x:e}, {y:e}");
    }
    exactly(
        |x| pow(x, floats(2.0)),
        &[(INF, INF), (0.0, 0.0), (NAN, NAN)],
    );
    exactly(|x| pow(x, floats(0.0)), &[(3.0, 1.0)]);
    exactly(|x| pow(x, floats(-1.0)), &[(INF, 0.0)]);
}

#[test]
fn hyperbolic_functions_are_accurate_for_small_numbers() {
    check(sinh, f64::sinh, |_| true, 0.6);
    check(cosh, f64::cosh, |_| true, 0.6);
    check(tanh, f64::tanh, |_| true, 0.6);
    check(asinh, f64::asinh, |x| x.abs() < 1e9, 0.6);
    check(acosh, f64::acosh, |_| true, 0.6);
    check(atanh, f64::atanh, |x| x.abs() < 1.0, 0.6);
    exactly(tanh, &[(INF, 1.0), (-INF, -1.0), (-0.0, -0.0), (NAN, NAN)]);
    exactly(asinh, &[(INF, INF), (-INF, -INF), (-0.0, -0.0), (NAN, NAN)]);
    exactly(acosh, &[(1.0, 0.0), (0.5, NAN), (INF, INF), (NAN, NAN)]);
    exactly(atanh, &[(-0.0, -0.0), (NAN, NAN)]);
}

#[test]
fn rounding_functions_are_exact_at_every_magnitude() {
    let signed = [
        0.0, 0.5, 1.5, 2.5, 0.99999994, 8388607.5, 8388609.0, 3e9, INF, 1e-40,
    ];
    let signed = signed.into_iter().flat_map(|x| [x, -x]);
    for x in numbers(100_000).chain(signed).chain([NAN]) {
        exactly(floor, &[(x, x.floor())]);
        exactly(ceil, &[(x, x.ceil())]);
        exactly(trunc, &[(x, x.trunc())]);
        exactly(round_even, &[(x, x.round_ties_even())]);
        let rest = x - x.floor();
        exactly(fract, &[(x, if rest < 1.0 { rest } else { 0.999_999_94 })]);
    }
}

#[test]
fn common_functions_have_the_specified_values() {
    let three =
        |f: fn(Floats, Floats, Floats) -> Floats, x, y, z| f(floats(x), floats(y), floats(z))[0];
    assert_eq!(three(clamp, 5.0, 0.0, 1.0), 1.0);
    assert_eq!(three(mix, 2.0, 4.0, 0.25), 2.5);
    assert_eq!(three(smoothstep, 0.0, 2.0, 1.0), 0.5);
    assert_eq!(three(smoothstep, 0.0, 2.0, 9.0), 1.0);
    exactly(sign, &[(-0.0, 0.0), (-3.0, -1.0), (1e-30, 1.0)]);
    exactly(|x| modulo(x, floats(3.0)), &[(-1.0, 2.0), (7.0, 1.0)]);
    exactly(|x| step(floats(1.0), x), &[(1.0, 1.0), (0.5, 0.0)]);
}

#[test]
fn integers_wrap_and_never_trap() {
    let two = |f: fn(Ints, Ints) -> Ints, x: i32, y: i32| f(ints(x), ints(y))[0];
    assert_eq!(two(divide_int, -7, 2), -3);
    assert_eq!(two(divide_int, i32::MIN, -1), 1);
    assert_eq!(two(divide_int, 7, 0), -7);
    assert_eq!(two(remainder_int, -7, 2), 1);
    assert_eq!(two(remainder_int, 7, -2), -1);
    assert_eq!(two(remainder_int, 7, 0), 0);
    assert_eq!(two(remainder_int, i32::MIN, -1), 0);
    let two = |f: fn(Uints, Uints) -> Uints, x: u32, y: u32| f(uints(x), uints(y))[0];
    assert_eq!(two(divide_uint, u32::MAX, 2), 0x7fff_ffff);
    assert_eq!(two(divide_uint, 3, 0), 0);
    assert_eq!(two(remainder_uint, 3, 0), 3);
    assert_eq!(two(remainder_uint, u32::MAX, 10), 5);
    assert_eq!(two(shift_left, 3, 33), 6);
    assert_eq!(two(shift_right_uint, 0x8000_0000, 31), 1);
    let shifted = shift_right_int(ints(-8), uints(34));
    assert_eq!(shifted[0], -2);
}

#[test]
fn numbers_are_converted_as_in_the_browser() {
    let numbers = numbers(100_000).chain([0.0, -0.0, NAN, INF, -INF, 2147483648.0, -2147483648.0]);
    for x in numbers {
        let lanes = floats(x);
        let truncated = match x {
            -2147483648.0..2147483648.0 => x as i32,
            _ => i32::MIN,
        };
        assert_eq!(int_of_float(lanes)[3], truncated, "{x:e}");
        let unsigned = uint_of_float(lanes)[3];
        let within = (0.0..4_294_967_296.0).contains(&x);
        assert_eq!(
            unsigned,
            if within {
                x as u32
            } else {
                u32::from(x.is_nan()) << 31
            },
            "{x:e}"
        );
        let bits = x.to_bits();
        let found = float_of_uint(uints(bits))[3];
        assert_eq!(found, bits as f32);
        let found = float_of_int(ints(bits as i32))[3];
        assert_eq!(found, bits as i32 as f32);
    }
}

#[test]
fn packed_values_are_unpacked() {
    let (x, y) = (floats(0.25), floats(-1.5));
    assert_eq!(pack_half(x, y)[0], 0xbe00_3400);
    assert_eq!(unpack_half(pack_half(x, y)).map(|x| x[0]), [0.25, -1.5]);
    assert_eq!(pack_snorm(x, y)[0], 0x8001_2000);
    assert_eq!(pack_unorm(x, y)[0], 0x0000_4000);
    let found = unpack_snorm(uints(0x8000_7fff)).map(|x| x[0]);
    assert_eq!(found, [1.0, -1.0]);
    let found = unpack_unorm(uints(0xffff_0000)).map(|x| x[0]);
    assert_eq!(found, [0.0, 1.0]);
}

#[test]
fn half_floats_are_encoded_as_in_ieee_754() {
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

#[test]
fn sines_of_doubles_equal_those_of_the_standard_library() {
    for n in -2000..2000 {
        let angle = f64::from(n) * 0.37;
        assert!((sine(angle) - angle.sin()).abs() < 1e-12, "{angle}");
    }
}

/// The bits of all functions that take and return floats; NaN is one value.
fn bits_of_all<S: Simd>(simd: S, x: [f32; 8], y: [f32; 8]) -> Vec<[u32; 8]> {
    let (a, b): (FloatLanes<S>, FloatLanes<S>) = (x.simd_into(simd), y.simd_into(simd));
    let one = [
        ceil(a),
        floor(a),
        fract(a),
        round_even(a),
        sign(a),
        trunc(a),
        sqrt(a),
        inverse_sqrt(a),
        exp(a),
        exp2(a),
        log(a),
        log2(a),
        sin(a),
        cos(a),
        tan(a),
        asin(a),
        acos(a),
        atan(a),
        sinh(a),
        cosh(a),
        tanh(a),
        asinh(a),
        acosh(a),
        atanh(a),
    ];
    let two = [
        min(a, b),
        max(a, b),
        min_number(a, b),
        max_number(a, b),
        modulo(a, b),
        step(a, b),
        pow(a, b),
        atan2(a, b),
        mix(a, b, a),
        smoothstep(a, b, a),
        float_of_int(int_of_float(a)),
        float_of_uint(uint_of_float(a)),
    ];
    let [low, high] = unpack_half(pack_half(a, b));
    let bits = |x: f32| if x.is_nan() { 0 } else { x.to_bits() };
    let floats = one.into_iter().chain(two).chain([low, high]);
    let floats = floats.map(|lanes| <[f32; 8]>::from(lanes).map(bits));
    let (a, b): (UintLanes<S>, UintLanes<S>) = (a.bitcast(), b.bitcast());
    let (c, d): (IntLanes<S>, IntLanes<S>) = (a.bitcast(), b.bitcast());
    let uints = [
        divide_uint(a, b),
        remainder_uint(a, b),
        shift_left(a, b),
        shift_right_uint(a, b),
        divide_int(c, d).bitcast(),
        remainder_int(c, d).bitcast(),
        shift_right_int(c, b).bitcast(),
    ];
    floats.chain(uints.map(<[u32; 8]>::from)).collect()
}

#[test]
fn results_do_not_depend_on_the_instruction_set() {
    let special = [
        0.0,
        -0.0,
        1.0,
        -1.5,
        INF,
        -INF,
        NAN,
        1e-40,
        8388607.5,
        -2147483648.0,
        4294967296.0,
        1e30,
    ];
    let all: Vec<f32> = numbers(40_000).chain(special).collect();
    let (xs, _) = all.as_chunks::<8>();
    let Some(simd) = faster() else { return };
    for (x, y) in xs.iter().zip(xs.iter().skip(7).cycle()) {
        let found = simd.vectorize(
            #[inline(always)]
            || bits_of_all(simd, *x, *y),
        );
        assert_eq!(found, bits_of_all(baseline(), *x, *y), "{x:?} {y:?}");
    }
}
