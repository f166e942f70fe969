//! Sample runs for editors: cost and iterations, and images of the values of a variable.

use super::document::Document;
use super::line_costs::observed_lines;
use shaderlint_engine::Analysis;
use shaderlint_engine::inputs::{Moment, Scene};
use shaderlint_exec::{CompileOptions, Drawn, LANES, LoopObservation, Probe, Stop, Watch, draw};
use shaderlint_play::RenderedImage;
use shaderlint_semantic::{Stage, VariableId};
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::Span;
use std::collections::BTreeMap;
use std::fmt;

/// Size of the image in pixels, so small that a run takes milliseconds.
const SIZE: [u32; 2] = [64, 36];
/// Time in seconds; animations have started by then.
const TIME: f64 = 1.0;
/// Maximum number of instructions of a run, about 50 ms on one core.
const BUDGET: u64 = 6_000_000;
/// Maximum number of instructions of a compiled shader.
const MOST_INSTRUCTIONS: usize = 60_000;

/// The result of a sample run.
#[derive(Clone, Default, Debug)]
pub struct RunObservations {
    /// Iterations by loop.
    pub loops: BTreeMap<StmtId, ObservedIterations>,
    /// Average number of operations per pixel.
    pub cost: f64,
    /// Maximum number of operations of a pixel.
    pub most_cost: u32,
    /// By line of the document, from 1: average number of operations per pixel.
    pub lines: BTreeMap<u32, f64>,
}

/// Number of iterations of a loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ObservedIterations {
    /// Maximum per pixel.
    pub most: u32,
    /// Average per execution of the loop.
    pub mean: f64,
    /// Share of the pixels that reached it and ran all iterations.
    pub exhausted: f64,
}

impl fmt::Display for ObservedIterations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "sample run: at most {} iterations, {:.1} on average",
            self.most, self.mean
        )
    }
}

impl ObservedIterations {
    fn of(seen: &LoopObservation) -> ObservedIterations {
        ObservedIterations {
            most: seen.most,
            mean: seen.iterations as f64 / seen.entries.max(1) as f64,
            exhausted: seen.exhausted_pixels as f64 / seen.pixels.max(1) as f64,
        }
    }
}

/// How much work a frame of a shader is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FrameCost {
    /// The average number of operations per pixel.
    PerPixel(f64),
    /// More than the budget of a sample run: more than about this many operations per pixel.
    Exceeded(f64),
    /// The shader cannot be run.
    Unknown,
}

/// Counts the operations of a frame in a small image.
pub fn frame_cost(analysis: &Analysis) -> FrameCost {
    let options = CompileOptions {
        cost: true,
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let Some(scene) = scene(analysis, &options) else {
        return FrameCost::Unknown;
    };
    match drawn(&scene) {
        Ok(drawn) => FrameCost::PerPixel(drawn.mean_cost()),
        Err(_) => {
            // An operation takes about four instructions.
            let groups = f64::from(SIZE[0] * SIZE[1]) / LANES as f64;
            FrameCost::Exceeded(BUDGET as f64 / groups / 4.0)
        }
    }
}

/// Draws a small image of a shader of a document and returns statistics; `None` if it cannot run,
/// or exceeds the budget.
pub fn run(document: &Document, analysis: &Analysis) -> Option<RunObservations> {
    let options = CompileOptions {
        watch: Watch::Flow,
        cost: true,
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let scene = scene(analysis, &options)?;
    let drawn = drawn(&scene).ok()?;
    let module = analysis.module();
    let loops = drawn.seen.loops.iter().filter(|l| l.entries > 0);
    let iterations =
        loops.filter_map(|l| Some((module.looped(l.id)?.stmt, ObservedIterations::of(l))));
    Some(RunObservations {
        loops: iterations.collect(),
        cost: drawn.mean_cost(),
        most_cost: drawn.most_cost(),
        lines: observed_lines(document, analysis, &scene.code, &drawn),
    })
}

/// An image of the values of a variable that is used in a span; `None` if the shader cannot run, or
/// exceeds the budget.
pub fn image_of(analysis: &Analysis, variable: VariableId, within: Span) -> Option<RenderedImage> {
    let options = CompileOptions {
        probe: Some(Probe::Variable { variable, within }),
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let scene = scene(analysis, &options)?;
    let drawn = drawn(&scene).ok()?;
    // The last output is the flag that says whether the line ran.
    let output = scene.code.outputs.len().checked_sub(2)?;
    let mut image = RenderedImage::of(&scene.code, &drawn, output);
    if scene.code.outputs.get(output)?.ty.components() == 1 {
        // Scalars are grey, vectors are colours.
        let grey = |pixel: &mut [f32; 4]| *pixel = [pixel[0], pixel[0], pixel[0], 1.0];
        image.pixels.iter_mut().for_each(grey);
    }
    (!image.pixels.is_empty()).then_some(image)
}

/// The limits of the colours of a shader: 0 and 1, unless more than 5 % of the numbers are below or
/// above; then the 5 % beyond are left out. `None` if it cannot run, or exceeds the budget.
pub fn limits(analysis: &Analysis) -> Option<[f32; 2]> {
    let options = CompileOptions {
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let scene = scene(analysis, &options)?;
    let drawn = drawn(&scene).ok()?;
    let image = RenderedImage::of(&scene.code, &drawn, 0);
    let numbers = image.pixels.iter().flat_map(|pixel| pixel.iter().take(3));
    let mut finite: Vec<f32> = numbers.copied().filter(|n| n.is_finite()).collect();
    finite.sort_unstable_by(f32::total_cmp);
    let beyond = finite.len() / 20;
    let (least, most) = (finite.get(beyond)?, finite.iter().nth_back(beyond)?);
    Some([least.min(0.0), most.max(1.0)])
}

/// The small image of a scene, within the budget.
fn drawn(scene: &Scene) -> Result<Drawn, Stop> {
    let mut drawing = scene.draw(SIZE, &Moment::at(TIME));
    drawing.budget = BUDGET;
    draw(&drawing, 1)
}

fn scene(analysis: &Analysis, options: &CompileOptions) -> Option<Scene> {
    if analysis.has_errors || analysis.program.stage != Stage::Fragment {
        return None;
    }
    Scene::of(&analysis.program, analysis.host, analysis.module(), options).ok()
}
