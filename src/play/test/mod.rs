//! Tests written in GLSL: functions `bool test_*()`, which pass if they return true for every
//! tested pixel and all values of their parameters.

mod condition;
mod coverage;
mod interval;
mod invocation;
mod marks;
mod quad;
mod random;
mod suite;

pub use condition::{SeenCondition, SeenValue};
pub use coverage::{Coverage, CoveredFunction, FileCoverage, RunCounts};
pub use marks::{TestProblem, TextureMark};
pub use suite::{Test, TestCase, TestSuite, unusable_tests};

use invocation::{Invocation, failures};
use quad::SIZE;
use random::{RandomInputs, Values};
use shaderlint_engine::Analysis;
use shaderlint_exec::{
    Bytecode, CompileOptions, Refusal, Sampled, Stop, Texture, Watch, quads_all_over, sample,
    sample_cases,
};
use shaderlint_math::hash;
use shaderlint_semantic::Stage;
use shaderlint_text::Span;

/// Number of tested 2x2 quads.
const QUADS: usize = 48 * 48;
/// Times in seconds at which tests that read uniforms run.
const TIMES: [f64; 3] = [0.0, 1.0, 10.0];

/// How tests run.
#[derive(Clone, Copy, Debug)]
pub struct TestSettings {
    /// The number of cases with random values.
    pub cases: u32,
    /// The seed of random values.
    pub seed: u32,
    /// Whether operations are counted.
    pub cost: bool,
    /// Whether statements and branches are counted.
    pub coverage: bool,
}

/// The result of a case.
#[derive(Clone, PartialEq, Debug)]
pub struct TestResult {
    /// Whether it passed.
    pub verdict: TestVerdict,
    /// Operations of one call on average, if they are counted.
    pub operations: Option<f64>,
    /// The statements and branches that ran, if they are counted.
    pub counts: RunCounts,
}

/// The verdict on a case.
#[derive(Clone, PartialEq, Debug)]
pub enum TestVerdict {
    /// The test returned true for all pixels and values.
    Passed,
    /// The test returned false.
    Failed(Box<TestFailure>),
    /// The values of its parameters are wrong.
    Invalid(TestProblem),
    /// The test cannot be run.
    Refused {
        /// The unsupported construct.
        what: String,
        /// Span of the construct.
        at: Option<Span>,
    },
    /// The test exceeded the operation limit.
    TooLong,
}

/// The details of a failed test.
#[derive(Clone, PartialEq, Debug)]
pub struct TestFailure {
    /// Number of tested pixels, or of cases with random values.
    pub pixels: u64,
    /// Number of these with result false, or discarded.
    pub failed: u64,
    /// The first of these, if results depend on the pixel: `gl_FragCoord.xy` without the half.
    pub pixel: Option<[u32; 2]>,
    /// Size of the image that contains the pixel.
    pub size: [u32; 2],
    /// Time in seconds, if the test reads uniforms.
    pub time: Option<f64>,
    /// The random values, made as simple as possible.
    pub found: Option<FoundValues>,
    /// The conditions that the pixel evaluated, in source order.
    pub conditions: Vec<SeenCondition>,
}

/// Random values for which a test fails.
#[derive(Clone, PartialEq, Debug)]
pub struct FoundValues {
    /// The number of the case, from 0.
    pub case: u32,
    /// The simplest values, as GLSL, by parameter.
    pub simplest: Vec<(String, String)>,
    /// The values of the case.
    pub first: Vec<(String, String)>,
}

/// Runs a case of a test. Uniforms have their usual values; textures that are not given are black.
pub fn run_test(
    analysis: &Analysis,
    case: &TestCase,
    textures: &[(String, Texture)],
    settings: &TestSettings,
) -> TestResult {
    let invocation = Invocation {
        analysis,
        case,
        textures,
        given: &[],
        time: 0.0,
    };
    let mut counted = CallCounts::default();
    let verdict = match case.any.is_empty() {
        true => run_pixels(invocation, settings, &mut counted),
        false => run_random(invocation, settings, &mut counted),
    };
    TestResult {
        verdict: verdict.unwrap_or_else(|verdict| verdict),
        operations: settings.cost.then(|| counted.mean()),
        counts: counted.counts,
    }
}

/// The operations of all calls.
#[derive(Default)]
struct CallCounts {
    operations: u64,
    calls: u64,
    counts: RunCounts,
}

impl CallCounts {
    fn add(&mut self, code: &Bytecode, sampled: &Sampled) {
        self.counts.add(code, &sampled.seen);
        self.operations += sampled.cost.iter().copied().map(u64::from).sum::<u64>();
        self.calls += sampled.cost.len() as u64;
    }

    fn mean(&self) -> f64 {
        self.operations as f64 / self.calls.max(1) as f64
    }
}

fn options(settings: &TestSettings) -> CompileOptions {
    CompileOptions {
        cost: settings.cost,
        steps: settings.coverage,
        watch: match settings.coverage {
            true => Watch::Faults,
            false => Watch::Nothing,
        },
        ..CompileOptions::default()
    }
}

/// The times at which a test runs.
fn times(reads_uniforms: bool) -> &'static [f64] {
    let (first, _) = TIMES.split_at(1);
    if reads_uniforms { &TIMES } else { first }
}

fn too_long(_: Stop) -> TestVerdict {
    TestVerdict::TooLong
}

/// Runs a test with fixed values for pixels all over the image.
fn run_pixels(
    invocation: Invocation<'_>,
    settings: &TestSettings,
    counted: &mut CallCounts,
) -> Result<TestVerdict, TestVerdict> {
    let analysis = invocation.analysis;
    let scene = invocation.scene(&options(settings));
    let scene = scene.map_err(|refusal| refused(analysis, &refusal))?;
    // Without inputs, all pixels have the same result; the attributes of vertices are zero.
    let has_pixels = !scene.code.inputs.is_empty() && analysis.program.stage == Stage::Fragment;
    let reads_uniforms = !scene.code.uniforms.is_empty();
    for &time in times(reads_uniforms) {
        let invocation = Invocation { time, ..invocation };
        let draw = invocation.draw(&scene);
        let sampled = match has_pixels {
            true => sample(&draw, &quads_all_over(SIZE, QUADS, 0)),
            false => sample_cases(&draw, &[[0; 2]]),
        };
        let sampled = sampled.map_err(too_long)?;
        counted.add(&scene.code, &sampled);
        let failed = failures(&scene.code, &sampled);
        let pixel = failed
            .first()
            .and_then(|at| sampled.pixels.get(*at))
            .copied();
        if let Some(pixel) = pixel {
            return Ok(TestVerdict::Failed(Box::new(TestFailure {
                pixels: sampled.pixels.len() as u64,
                failed: failed.len() as u64,
                pixel: has_pixels.then_some(pixel),
                size: SIZE,
                time: reads_uniforms.then_some(time),
                found: None,
                conditions: condition::seen(&invocation, pixel),
            })));
        }
    }
    Ok(TestVerdict::Passed)
}

/// Runs a test with random values.
fn run_random(
    invocation: Invocation<'_>,
    settings: &TestSettings,
    counted: &mut CallCounts,
) -> Result<TestVerdict, TestVerdict> {
    let analysis = invocation.analysis;
    let scene = invocation.scene(&options(settings));
    let scene = scene.map_err(|refusal| refused(analysis, &refusal))?;
    let inputs = RandomInputs::of(&invocation).map_err(TestVerdict::Invalid)?;
    let is_parameter = |name: &str| invocation.case.any.iter().any(|any| any.name == name);
    let reads_pixel = analysis.program.stage == Stage::Fragment
        && scene.code.inputs.iter().any(|i| !is_parameter(&i.name));
    let reads_uniforms = !scene.code.uniforms.is_empty();
    let seed = hash(settings.seed);
    let cases: Vec<Values> = (0..settings.cases)
        .map(|n| inputs.values(n, seed))
        .collect();
    let pixels = match reads_pixel {
        true => random::pixels(settings.cases, seed),
        false => vec![[0; 2]; cases.len()],
    };
    let given = inputs.given(&cases);
    for &time in times(reads_uniforms) {
        let invocation = Invocation {
            time,
            given: &given,
            ..invocation
        };
        let sampled = sample_cases(&invocation.draw(&scene), &pixels).map_err(too_long)?;
        counted.add(&scene.code, &sampled);
        let failed = failures(&scene.code, &sampled);
        let Some(first) = failed.first().copied() else {
            continue;
        };
        let pixel = pixels.get(first).copied().unwrap_or_default();
        let values = cases.get(first).cloned().unwrap_or_default();
        let simplest = inputs.shrink(&invocation, &scene, pixel, values.clone());
        let given = inputs.given(std::slice::from_ref(&simplest));
        let shown = Invocation {
            given: &given,
            ..invocation
        };
        let type_name = |any: &suite::AnyParameter| analysis.program.type_name(any.ty);
        return Ok(TestVerdict::Failed(Box::new(TestFailure {
            pixels: cases.len() as u64,
            failed: failed.len() as u64,
            pixel: reads_pixel.then_some(pixel),
            size: SIZE,
            time: reads_uniforms.then_some(time),
            found: Some(FoundValues {
                case: first as u32,
                simplest: inputs.written(&simplest, type_name),
                first: inputs.written(&values, type_name),
            }),
            conditions: condition::seen(&shown, pixel),
        })));
    }
    Ok(TestVerdict::Passed)
}

fn refused(analysis: &Analysis, refusal: &Refusal) -> TestVerdict {
    let program = &analysis.program;
    let extent = refusal.at.extent(&program.tree);
    let what = match analysis.has_errors {
        // The name of a host is represented as an expression with an error.
        false if refusal.what == "an expression with an error" => "a name from the host",
        _ => refusal.what.as_str(),
    };
    TestVerdict::Refused {
        what: what.to_string(),
        at: extent.map(|extent| program.span(extent)),
    }
}
