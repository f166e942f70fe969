//! Tests written in GLSL: functions `bool test_*()`, which pass if they return true for every
//! tested pixel.

mod condition;
mod quad;

pub use condition::{SeenCondition, SeenValue};

use super::{Moment, Scene};
use crate::Analysis;
use quad::SIZE;
use shaderlint_exec::{
    Bytecode, CompileOptions, OutputSlot, Refusal, Sampled, Stop, quads_all_over, sample,
};
use shaderlint_semantic::{FunctionRef, Type};
use shaderlint_text::{FileId, Span};

/// Number of tested 2x2 quads.
const QUADS: usize = 48 * 48;
/// Times in seconds at which tests that read uniforms run.
const TIMES: [f64; 3] = [0.0, 1.0, 10.0];

/// The result of a test.
#[derive(Clone, PartialEq, Debug)]
pub enum TestVerdict {
    /// The test returned true for all pixels.
    Passed,
    /// The test returned false.
    Failed(TestFailure),
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
    /// Number of tested pixels.
    pub pixels: u64,
    /// Number of pixels with result false, or discarded.
    pub failed: u64,
    /// The first of these, if results depend on the pixel: `gl_FragCoord.xy` without the half.
    pub pixel: Option<[u32; 2]>,
    /// Size of the image that contains the pixel.
    pub size: [u32; 2],
    /// Time in seconds, if the test reads uniforms.
    pub time: Option<f64>,
    /// The conditions that the pixel evaluated, in source order.
    pub conditions: Vec<SeenCondition>,
}

/// The tests in a file, in source order, with the spans of their names.
pub fn tests(analysis: &Analysis, file: FileId) -> Vec<(FunctionRef, Span)> {
    let program = &analysis.program;
    let own = program.sources.file(file).map(|f| f.span());
    let functions = (0..).map(FunctionRef).zip(&program.functions);
    let tests = functions.filter(|(_, function)| function.is_test(&program.names));
    let named = tests.filter_map(|(id, function)| {
        let definition = program.tree.function(function.definition?)?;
        let span = program.token(definition.ident.token)?.span;
        own?.contains(span).then_some((id, span))
    });
    let mut named: Vec<_> = named.collect();
    named.sort_by_key(|(_, span)| span.start);
    named
}

/// Runs a test. Uniforms have their usual values; textures are black.
pub fn run_test(analysis: &Analysis, test: FunctionRef) -> TestVerdict {
    let options = CompileOptions {
        entry: Some(test),
        ..CompileOptions::default()
    };
    let scene = match Scene::of(
        &analysis.program,
        analysis.host,
        analysis.module(),
        &options,
    ) {
        Ok(scene) => scene,
        Err(refusal) => return refused(analysis, &refusal),
    };
    // Without inputs, all pixels have the same result.
    let quads = match scene.code.inputs.is_empty() {
        true => vec![[0; 2]],
        false => quads_all_over(SIZE, QUADS, 0),
    };
    let times = match scene.code.uniforms.is_empty() {
        true => TIMES.get(..1),
        false => TIMES.get(..),
    };
    for &time in times.into_iter().flatten() {
        let draw = scene.draw(SIZE, &Moment::at(time));
        let sampled = match sample(&draw, &quads) {
            Ok(sampled) => sampled,
            Err(Stop::OutOfFuel { .. }) => return TestVerdict::TooLong,
        };
        if let Some(failure) = failure(&scene.code, &sampled) {
            return TestVerdict::Failed(TestFailure {
                pixel: failure.pixel.filter(|_| !scene.code.inputs.is_empty()),
                time: (!scene.code.uniforms.is_empty()).then_some(time),
                conditions: match failure.pixel {
                    Some(pixel) => condition::seen(analysis, test, time, pixel),
                    None => Vec::new(),
                },
                ..failure
            });
        }
    }
    TestVerdict::Passed
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

/// The failure of a run, if a pixel is not true.
fn failure(code: &Bytecode, sampled: &Sampled) -> Option<TestFailure> {
    let is_answer = |slot: &OutputSlot| slot.name.is_empty() && slot.ty == Type::BOOL;
    let at = code.outputs.iter().position(is_answer)?;
    let answers = sampled.outputs.get(at)?;
    let all = answers.iter().zip(&sampled.covered).zip(&sampled.pixels);
    let mut wrong = all.filter(|((answer, is_covered), _)| answer[0] == 0 || !*is_covered);
    let (_, first) = wrong.next()?;
    Some(TestFailure {
        pixels: answers.len() as u64,
        failed: wrong.count() as u64 + 1,
        pixel: Some(*first),
        size: SIZE,
        time: None,
        conditions: Vec::new(),
    })
}
