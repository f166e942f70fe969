//! One run of a test: its entry function with values of its parameters, at a time.

use super::quad::SIZE;
use super::suite::TestCase;
use shaderlint_engine::Analysis;
use shaderlint_engine::inputs::{Moment, Scene};
use shaderlint_exec::{Bytecode, CompileOptions, Draw, OutputSlot, Refusal, Sampled, Texture};
use shaderlint_semantic::Type;

/// The value of a parameter: the bits of each scalar, by case.
#[derive(Clone, Debug)]
pub struct GivenInput {
    pub name: String,
    pub bits: Vec<Vec<u32>>,
}

/// A test whose inputs are known.
#[derive(Clone, Copy)]
pub struct Invocation<'a> {
    pub analysis: &'a Analysis,
    pub case: &'a TestCase,
    pub textures: &'a [(String, Texture)],
    /// The values of random parameters.
    pub given: &'a [GivenInput],
    /// Time in seconds.
    pub time: f64,
}

impl<'a> Invocation<'a> {
    /// Compiles the test.
    pub fn scene(&self, options: &CompileOptions) -> Result<Scene, Refusal> {
        let options = CompileOptions {
            entry: Some(self.case.entry),
            ..*options
        };
        let analysis = self.analysis;
        Scene::of(
            &analysis.program,
            analysis.host,
            analysis.module(),
            &options,
        )
    }

    /// A draw with all inputs.
    pub fn draw<'s>(&self, scene: &'s Scene) -> Draw<'s> {
        let mut draw = scene.draw(SIZE, &Moment::at(self.time));
        for (name, texture) in self.textures {
            let [width, height, _] = texture.image.size().map(f64::from);
            if let Some(number) = name.strip_prefix("iChannel") {
                draw.set(
                    &format!("iChannelResolution[{number}]"),
                    &[width, height, 1.0],
                );
            }
            draw.bind(name, texture.clone());
        }
        for input in self.given {
            draw.input_by_case(&input.name, input.bits.clone());
        }
        draw
    }
}

/// The pixels or cases that are not true or were discarded.
pub fn failures(code: &Bytecode, sampled: &Sampled) -> Vec<usize> {
    let is_answer = |slot: &OutputSlot| slot.name.is_empty() && slot.ty == Type::BOOL;
    let at = code.outputs.iter().position(is_answer);
    let Some(answers) = at.and_then(|at| sampled.outputs.get(at)) else {
        return Vec::new();
    };
    let all = answers.iter().zip(&sampled.covered).enumerate();
    let wrong = all.filter(|(_, (answer, is_covered))| answer[0] == 0 || !**is_covered);
    wrong.map(|(at, _)| at).collect()
}
