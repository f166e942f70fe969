//! Draws a frame: its image, and its statistics.

use super::bitmap::Bitmap;
use super::facts::{self, CostFacts, OutputFacts, RunFacts};
use super::setting::{FrameView, HeatMap};
use super::shot::{Loaded, Shot};
use super::{fields, functions, heat, loops, numbers, show};
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::Drawn;
use shaderlint_lint::march::RayOutcome;
use shaderlint_play::RenderedImage;

/// A frame that was drawn.
pub struct Frame {
    /// The image.
    pub bitmap: Bitmap,
    /// The statistics.
    pub facts: RunFacts,
}

/// Draws a frame. `progress` is called before each frame that it depends on, with its number.
///
/// # Errors
/// A message about a run that was stopped.
pub fn frame(
    loaded: &Loaded,
    shot: &mut Shot,
    moment: &Moment,
    view: FrameView<'_>,
    progress: &mut dyn FnMut(u32),
) -> Result<Frame, String> {
    let drawn = shot.drawn(moment, progress)?;
    let image = RenderedImage::of(shot.code(), &drawn, 0);
    let bitmap = match (view.heat, view.show) {
        (Some(heat), _) => heat_map(heat, &image, &drawn),
        (None, Some(show)) => show::value_image(&show.name, shot.code(), &drawn),
        (None, None) => Bitmap::of(&image),
    };
    let mut facts = facts_of(loaded, shot, (&drawn, &image), moment);
    if let Some(program) = loaded.program(shot).filter(|_| view.report) {
        facts.loops = Some(loops::rows(program, shot, &drawn.seen));
        facts.functions = Some(functions::rows(program, &drawn.seen));
        facts.fields = fields::rows(program, loaded, shot);
        facts.numbers = Some(numbers::rows(program, shot, &drawn.seen));
    }
    facts.notes = shot.notes(&loaded.project);
    Ok(Frame { bitmap, facts })
}

fn heat_map(heat: HeatMap, image: &RenderedImage, drawn: &Drawn) -> Bitmap {
    let counts = |all: &[u32]| all.iter().map(|n| f64::from(*n)).collect::<Vec<_>>();
    let (values, title) = match heat {
        HeatMap::Steps => (counts(&drawn.iterations), "STEPS"),
        HeatMap::Cost => (counts(&drawn.cost), "OPERATIONS"),
        HeatMap::Divergence => {
            let waited = |(own, all): (&u32, &u32)| match *all {
                0 => 0.0,
                all => 100.0 * f64::from(all - own.min(&all)) / f64::from(all),
            };
            let pairs = drawn.cost.iter().zip(&drawn.ran);
            (pairs.map(waited).collect(), "DIVERGENCE IN 8X4, %")
        }
        HeatMap::Nan => {
            let is_bad = |pixel: &[f32; 4]| pixel.iter().any(|lane| !lane.is_finite());
            let values = image.pixels.iter().map(|p| f64::from(u8::from(is_bad(p))));
            (values.collect(), "NOT FINITE")
        }
        HeatMap::Slope => {
            let rays = RayOutcome::all(&drawn.outputs).into_iter();
            let slopes: Vec<f64> = rays.map(|ray| f64::from(ray.slope)).collect();
            return heat::slopes(drawn.size, &slopes);
        }
    };
    heat::map(drawn.size, &values, title)
}

/// The facts of a frame; `image` is its first output.
fn facts_of(
    loaded: &Loaded,
    shot: &Shot,
    (drawn, image): (&Drawn, &RenderedImage),
    moment: &Moment,
) -> RunFacts {
    let code = shot.code();
    let program = loaded.program(shot);
    let outputs = shot.outputs().iter().zip(0..).map(|(slot, at)| {
        let facts = match at {
            0 => image.facts(&drawn.covered),
            at => RenderedImage::of(code, drawn, at).facts(&drawn.covered),
        };
        let ty = program.map_or(String::new(), |p| p.type_name(slot.ty));
        let lanes = slot.ty.components();
        OutputFacts::of(&slot.name, (ty, lanes), &facts, drawn.covered.len())
    });
    RunFacts {
        schema: 1,
        file: loaded.name.clone(),
        size: drawn.size,
        time: moment.time,
        frame: moment.frame,
        mouse: facts::mouse(moment),
        output: None,
        outputs: outputs.collect(),
        cost: CostFacts::of(drawn),
        loops: None,
        rays: None,
        functions: None,
        numbers: None,
        fields: None,
        notes: Vec::new(),
    }
}
