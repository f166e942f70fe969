//! What the helpers for floats and for doubles have in common.

/// Declares helpers for eight lanes of numbers. Adding and subtracting `rounder` rounds a number to the nearest
/// integer; the low bits of the sum are that integer.
macro_rules! lane_helpers {
    ($lanes:ident, $bits:ident, $number:ident, $rounder:expr) => {
        /// The same number in every lane, for the instructions of another vector.
        #[inline(always)]
        pub(super) fn number<S: Simd>(of: $lanes<S>, number: $number) -> $lanes<S> {
            $lanes::splat(of.token(), number)
        }

        /// Rounds to the nearest integer, for magnitudes below 2^21, or 2^51 for doubles. Also returns a number
        /// whose low bits are that integer in two's complement.
        #[inline(always)]
        pub(super) fn round<S: Simd>(x: $lanes<S>) -> ($lanes<S>, $bits<S>) {
            let sum = x + $rounder;
            (sum - $rounder, sum.bitcast())
        }

        /// `c[0] + c[1] * x + c[2] * x * x ...`
        #[inline(always)]
        pub(super) fn polynomial<S: Simd, const N: usize>(
            x: $lanes<S>,
            coefficients: [$number; N],
        ) -> $lanes<S> {
            let mut sum = number(x, 0.0);
            for (at, c) in coefficients.into_iter().rev().enumerate() {
                sum = if at == 0 { number(x, c) } else { sum * x + c };
            }
            sum
        }
    };
}
pub(super) use lane_helpers;
