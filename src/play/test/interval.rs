//! Values of an interval: random ones, and simpler ones than a given one.

use shaderlint_math::hash;
use shaderlint_semantic::Scalar;

/// Numbers to round to when a value is made simpler.
const MAX_DECIMALS: i32 = 6;

/// The interval of one scalar; both ends are included.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct ValueInterval {
    pub scalar: Scalar,
    pub low: f64,
    pub high: f64,
}

impl ValueInterval {
    /// A number as a value of the type inside the interval.
    fn fitted(&self, number: f64) -> f64 {
        let number = match self.scalar {
            Scalar::Float => f64::from(number as f32),
            _ => number.round(),
        };
        number.clamp(self.low, self.high)
    }

    /// The value nearest to zero.
    pub fn simplest(&self) -> f64 {
        self.fitted(0.0)
    }

    /// A pseudo-random value. The ends, 0, 1 and -1 are more frequent than others, because mistakes
    /// often show there.
    pub fn random(&self, seed: u32) -> f64 {
        let pick = hash(seed);
        let special = [self.low, self.high, 0.0, 1.0, -1.0];
        let special = special.get((pick & 63) as usize).copied();
        if let Some(number) = special.filter(|n| (self.low..=self.high).contains(n)) {
            return number;
        }
        let share = f64::from(hash(pick)) / f64::from(u32::MAX);
        self.fitted(self.low + (self.high - self.low) * share)
    }

    /// The bits of a value in a register.
    pub fn bits(&self, number: f64) -> u32 {
        match self.scalar {
            Scalar::Float => (number as f32).to_bits(),
            Scalar::Int => number as i32 as u32,
            Scalar::Uint => number as u32,
            Scalar::Bool => u32::from(number != 0.0).wrapping_neg(),
        }
    }

    /// A value as GLSL.
    pub fn written(&self, number: f64) -> String {
        self.scalar.literal(self.bits(number))
    }

    /// Simpler values than this one, the simplest first: with fewer decimals, or nearer to zero.
    pub fn simpler(&self, number: f64) -> Vec<f64> {
        let target = self.simplest();
        let own = self.effort(number);
        let toward = (target - number).signum();
        let mut all = vec![target, 1.0, -1.0, -number, number.trunc()];
        for decimals in 0..=MAX_DECIMALS {
            let scale = 10_f64.powi(decimals);
            all.extend([
                (number * scale).floor() / scale,
                (number * scale).ceil() / scale,
            ]);
        }
        let step = 10_f64.powi(-(own.0.min(MAX_DECIMALS as usize) as i32));
        let mut part = number - target;
        while part.abs() > step {
            part = (part / 2.0 / step).trunc() * step;
            all.extend([target + part, number - part]);
        }
        all.push(number + toward * step);
        let mut all: Vec<f64> = all.into_iter().map(|n| self.fitted(n)).collect();
        all.retain(|n| self.effort(*n) < own);
        all.sort_by(|a, b| {
            let efforts = self.effort(*a).partial_cmp(&self.effort(*b));
            efforts.unwrap_or(std::cmp::Ordering::Equal)
        });
        all.dedup();
        all
    }

    /// How far from simple a value is: its decimals, its distance from the simplest value, and whether
    /// it is negative.
    fn effort(&self, number: f64) -> (usize, f64, bool) {
        let text = format!("{}", number as f32);
        let decimals = match self.scalar {
            Scalar::Float => text.split_once('.').map_or(0, |(_, part)| part.len()),
            _ => 0,
        };
        (decimals, (number - self.simplest()).abs(), number < 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_values_stay_in_their_interval_and_shrink() {
        let intervals = [
            (Scalar::Float, -10.0, 10.0),
            (Scalar::Float, 0.25, 0.75),
            (Scalar::Int, -7.0, -3.0),
            (Scalar::Uint, 2.0, 4_294_967_295.0),
        ];
        for (scalar, low, high) in intervals {
            let interval = ValueInterval { scalar, low, high };
            for seed in 0..500 {
                let value = interval.random(seed);
                assert!((low..=high).contains(&value), "{value}");
                for simpler in interval.simpler(value) {
                    assert!((low..=high).contains(&simpler), "{value} {simpler}");
                    assert!(interval.effort(simpler) < interval.effort(value));
                }
            }
            // 0.3 has fewer decimals than 0.25, which is nearer to zero.
            let simplest = interval.simpler(interval.simplest());
            assert_eq!(simplest.is_empty(), low != 0.25, "{simplest:?}");
        }
    }
}
