//! Tests with random values: the values of all cases, and the simplest that fail.

use super::interval::ValueInterval;
use super::invocation::{GivenInput, Invocation, failures};
use super::marks::TestProblem;
use super::quad::SIZE;
use super::suite::{AnyParameter, TestCase};
use shaderlint_engine::inputs::Scene;
use shaderlint_exec::{CompileOptions, OutputSlot, Stop, sample, sample_cases};
use shaderlint_math::hash;
use shaderlint_semantic::Scalar;

/// Maximum number of runs that search for simpler values.
const MAX_SHRINKS: usize = 400;

/// The random parameters of a test, each scalar with its interval.
pub(super) struct RandomInputs<'a> {
    parameters: &'a [AnyParameter],
    /// By parameter, then by scalar.
    intervals: Vec<Vec<ValueInterval>>,
}

/// The values of a case: by parameter, then by scalar.
pub(super) type Values = Vec<Vec<f64>>;

impl<'a> RandomInputs<'a> {
    /// Evaluates the ends of the intervals.
    pub fn of(invocation: &Invocation<'a>) -> Result<RandomInputs<'a>, TestProblem> {
        let parameters = &invocation.case.any;
        let mut intervals = Vec::new();
        for parameter in parameters {
            let problem = |message: String| TestProblem::new(parameter.at, message);
            let ends = parameter.ends.map(|entry| {
                let case = TestCase {
                    function: entry,
                    entry,
                    values: Vec::new(),
                    any: Vec::new(),
                };
                numbers(&Invocation {
                    case: &case,
                    ..*invocation
                })
            });
            let [Some(low), Some(high)] = ends else {
                return Err(problem("cannot evaluate the interval".to_string()));
            };
            let scalar = parameter.ty.scalar_kind().unwrap_or(Scalar::Float);
            let pairs = low.into_iter().zip(high);
            let own: Vec<ValueInterval> = pairs
                .map(|(low, high)| ValueInterval { scalar, low, high })
                .collect();
            let is_valid = |i: &ValueInterval| i.low <= i.high && (i.high - i.low).is_finite();
            if !own.iter().all(is_valid) {
                let message = "the interval is empty: its low end exceeds its high end";
                return Err(problem(message.to_string()));
            }
            intervals.push(own);
        }
        Ok(RandomInputs {
            parameters,
            intervals,
        })
    }

    /// The values of a case: first the simplest, then the ends, then random ones.
    pub fn values(&self, case: u32, seed: u32) -> Values {
        let mut lane = 0_u32;
        let mut value = |interval: &ValueInterval| {
            lane = lane.wrapping_add(1);
            match case {
                0 => interval.simplest(),
                1 => interval.low,
                2 => interval.high,
                _ => interval.random(seed ^ hash(case ^ hash(lane))),
            }
        };
        let parameters = self.intervals.iter();
        parameters
            .map(|all| all.iter().map(&mut value).collect())
            .collect()
    }

    /// The inputs of some cases.
    pub fn given(&self, cases: &[Values]) -> Vec<GivenInput> {
        let parameters = self.parameters.iter().zip(&self.intervals).enumerate();
        let inputs = parameters.map(|(number, (parameter, intervals))| {
            let scalars = intervals.iter().enumerate().map(|(at, interval)| {
                let value = |case: &Values| case.get(number)?.get(at).copied();
                let values = cases.iter().map(|case| value(case).unwrap_or(0.0));
                values.map(|number| interval.bits(number)).collect()
            });
            GivenInput {
                name: parameter.name.clone(),
                bits: scalars.collect(),
            }
        });
        inputs.collect()
    }

    /// The values as GLSL, by parameter.
    pub fn written(
        &self,
        values: &Values,
        type_name: impl Fn(&AnyParameter) -> String,
    ) -> Vec<(String, String)> {
        let parameters = self.parameters.iter().zip(&self.intervals).zip(values);
        let written = parameters.map(|((parameter, intervals), values)| {
            let lanes = intervals.iter().zip(values).map(|(i, v)| i.written(*v));
            let lanes: Vec<String> = lanes.collect();
            let text = match &lanes[..] {
                [one] => one.clone(),
                [first, others @ ..] if others.iter().all(|o| o == first) => {
                    format!("{}({first})", type_name(parameter))
                }
                all => format!("{}({})", type_name(parameter), all.join(", ")),
            };
            (parameter.name.clone(), text)
        });
        written.collect()
    }

    /// The simplest values that fail as well, at the same pixel and time.
    pub fn shrink(
        &self,
        invocation: &Invocation<'_>,
        scene: &Scene,
        pixel: [u32; 2],
        failing: Values,
    ) -> Values {
        let mut best = failing;
        let mut runs = 0;
        let mut is_changed = true;
        while is_changed && runs < MAX_SHRINKS {
            is_changed = false;
            for (number, intervals) in self.intervals.iter().enumerate() {
                for (at, interval) in intervals.iter().enumerate() {
                    let own = best.get(number).and_then(|v| v.get(at)).copied();
                    let simpler = interval.simpler(own.unwrap_or(0.0));
                    if simpler.is_empty() {
                        continue;
                    }
                    let candidates = simpler.into_iter().map(|value| {
                        let mut values = best.clone();
                        if let Some(slot) = values.get_mut(number).and_then(|v| v.get_mut(at)) {
                            *slot = value;
                        }
                        values
                    });
                    let mut candidates: Vec<Values> = candidates.collect();
                    runs += 1;
                    let failing = self.first_failure(invocation, scene, pixel, &candidates);
                    if let Some(failing) = failing {
                        best = candidates.swap_remove(failing);
                        is_changed = true;
                    }
                }
            }
        }
        best
    }

    fn first_failure(
        &self,
        invocation: &Invocation<'_>,
        scene: &Scene,
        pixel: [u32; 2],
        candidates: &[Values],
    ) -> Option<usize> {
        let given = self.given(candidates);
        let invocation = Invocation {
            given: &given,
            ..*invocation
        };
        let pixels = vec![pixel; candidates.len()];
        let sampled = sample_cases(&invocation.draw(scene), &pixels).ok()?;
        failures(&scene.code, &sampled).first().copied()
    }
}

/// The pixels of the cases.
pub(super) fn pixels(count: u32, seed: u32) -> Vec<[u32; 2]> {
    let [width, height] = SIZE;
    let pixel = |case: u32| {
        let thrown = hash(seed ^ hash(case));
        [(thrown & 0xffff) % width, (thrown >> 16) % height]
    };
    (0..count).map(pixel).collect()
}

/// The scalars that a function returns.
fn numbers(invocation: &Invocation<'_>) -> Option<Vec<f64>> {
    let scene = invocation.scene(&CompileOptions::default()).ok()?;
    let sampled: Result<_, Stop> = sample(&invocation.draw(&scene), &[[0; 2]]);
    let is_answer = |slot: &OutputSlot| slot.name.is_empty();
    let at = scene.code.outputs.iter().position(is_answer)?;
    let slot = scene.code.outputs.get(at)?;
    let bits = *sampled.ok()?.outputs.get(at)?.first()?;
    let number = |bits: u32| match slot.ty.scalar_kind() {
        Some(Scalar::Int) => f64::from(bits as i32),
        Some(Scalar::Uint) => f64::from(bits),
        _ => f64::from(f32::from_bits(bits)),
    };
    Some(bits.into_iter().take(slot.lanes()).map(number).collect())
}
