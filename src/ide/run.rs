//! What runs of a shader have shown of it, and what a variable looks like all over the picture.

use shaderlint_engine::Analysis;
use shaderlint_engine::play::{Moment, Picture, Scene};
use shaderlint_exec::{CompileOptions, LoopSeen, Probe, Watch, draw};
use shaderlint_semantic::{Stage, VariableId};
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::Span;
use std::collections::BTreeMap;
use std::fmt;

/// The picture that is run: so small that it costs milliseconds.
const SIZE: [u32; 2] = [64, 36];
/// When: what is animated has begun by then.
const TIME: f64 = 1.0;
/// Instructions that a run may take, some 50 ms of one core.
const BUDGET: u64 = 6_000_000;
/// Instructions that a shader may become.
const MOST_INSTRUCTIONS: usize = 60_000;

/// What a run has shown.
#[derive(Clone, Default, Debug)]
pub struct RunSeen {
    /// By loop.
    pub loops: BTreeMap<StmtId, SeenTurns>,
    /// Operations of a pixel in the mean.
    pub cost: f64,
    /// The most operations of one pixel.
    pub most_cost: u32,
}

/// How often a loop turned.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SeenTurns {
    /// The most turns of one pixel.
    pub most: u32,
    /// Turns in the mean.
    pub mean: f64,
    /// The share of the pixels that came to it and ran all of its turns.
    pub exhausted: f64,
}

impl fmt::Display for SeenTurns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "seen in a run: at most {} turns, {:.1} in the mean",
            self.most, self.mean
        )
    }
}

impl SeenTurns {
    fn of(seen: &LoopSeen) -> SeenTurns {
        SeenTurns {
            most: seen.most,
            mean: seen.turns as f64 / seen.entries.max(1) as f64,
            exhausted: seen.exhausted_pixels as f64 / seen.pixels.max(1) as f64,
        }
    }
}

/// Draws a small picture of a shader and says what was seen; `None` where it cannot be run, or takes
/// too long.
pub fn run(analysis: &Analysis) -> Option<RunSeen> {
    let options = CompileOptions {
        watch: Watch::Flow,
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let scene = scene(analysis, &options)?;
    let mut drawing = scene.draw(SIZE, &Moment::at(TIME));
    drawing.budget = BUDGET;
    let drawn = draw(&drawing, 1).ok()?;
    let module = analysis.module();
    let loops = drawn.seen.loops.iter().filter(|l| l.entries > 0);
    let turns = loops.filter_map(|l| Some((module.looped(l.id)?.stmt, SeenTurns::of(l))));
    Some(RunSeen {
        loops: turns.collect(),
        cost: drawn.mean_cost(),
        most_cost: drawn.most_cost(),
    })
}

/// What a variable is all over the picture, where it is read or written within a stretch of the text;
/// `None` where it cannot be run, or takes too long.
pub fn picture_of(analysis: &Analysis, variable: VariableId, within: Span) -> Option<Picture> {
    let options = CompileOptions {
        probe: Some(Probe::Variable { variable, within }),
        most: Some(MOST_INSTRUCTIONS),
        ..CompileOptions::default()
    };
    let scene = scene(analysis, &options)?;
    let mut drawing = scene.draw(SIZE, &Moment::at(TIME));
    drawing.budget = BUDGET;
    let drawn = draw(&drawing, 1).ok()?;
    // The value is the last output but one.
    let output = scene.code.outputs.len().checked_sub(2)?;
    let mut picture = Picture::of(&scene.code, &drawn, output);
    if scene.code.outputs.get(output)?.ty.components() == 1 {
        // A number is grey, where several are colours.
        let grey = |pixel: &mut [f32; 4]| *pixel = [pixel[0], pixel[0], pixel[0], 1.0];
        picture.pixels.iter_mut().for_each(grey);
    }
    (!picture.pixels.is_empty()).then_some(picture)
}

fn scene(analysis: &Analysis, options: &CompileOptions) -> Option<Scene> {
    if analysis.has_errors || analysis.program.stage != Stage::Fragment {
        return None;
    }
    Scene::of(&analysis.program, analysis.host, analysis.module(), options).ok()
}
