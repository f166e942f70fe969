//! Rays that step over a surface, by marching loop.

use super::place::{position, span};
use super::setting::{ObservedRays, ShotSetting};
use super::shot::{Loaded, Shot, shot};
use serde::Serialize;
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::{RayProbe, Sampled, Watch, quads_all_over};
use shaderlint_ir::Provenance;
use shaderlint_lint::Facts;
use shaderlint_lint::march::{
    March, MarchSample, RayOutcome, StepLength, are_clearly_fewer, factor_length, largest_factor,
    longer_factors, ray_probe, step_factor,
};
use shaderlint_text::number::{decimals, percent, shortest_decimal};

/// Most quads that are sampled.
const MOST_QUADS: usize = 2048;

/// A loop that marches by a distance, and its rays: the first of each sampled pixel.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct RayRow {
    /// Position of the loop: `file:line:column`.
    pub at: String,
    /// Name of the enclosing function.
    pub function: String,
    /// Number of rays.
    pub rays: u64,
    /// Share of the rays that step over a surface, which marches with a quarter and a tenth of the step
    /// length find.
    pub stepped_over: f64,
    /// The first of them.
    pub first: Option<MissedPoint>,
    /// Largest slope of the distance between two steps of a ray.
    pub slope: f64,
    /// Longer steps that draw the same frame, if the steps have a factor and they save iterations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub longer: Option<LongerRow>,
}

/// Longer steps of a loop.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct LongerRow {
    /// The factor of the steps.
    pub factor: f64,
    /// The larger factor.
    pub larger: f64,
    /// Iterations per ray with both.
    pub iterations: [f64; 2],
}

/// A point of a surface that a ray steps over.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct MissedPoint {
    /// The pixel, from the lower left corner.
    pub pixel: [u32; 2],
    /// The point, if it is known.
    pub point: Option<[f64; 3]>,
}

/// The marching loops of a frame. Loops are left out whose hits are unknown or that cannot be run with
/// shorter steps; `None` if there is no other.
pub fn rays(
    loaded: &Loaded,
    own: &Shot,
    setting: &ShotSetting,
    moment: &Moment,
) -> Option<Vec<RayRow>> {
    let program = loaded.program(own)?;
    let facts = Facts::of(program, &own.known);
    let marches = facts.marches().iter();
    let rows = marches.filter_map(|march| row((loaded, &facts), own, (setting, moment), march));
    let rows: Vec<RayRow> = rows.collect();
    (!rows.is_empty()).then_some(rows)
}

fn row(
    (loaded, facts): (&Loaded, &Facts),
    own: &Shot,
    (setting, moment): (&ShotSetting, &Moment),
    march: &March,
) -> Option<RayRow> {
    let quads = quads_all_over(own.size, MOST_QUADS, 0);
    let [short, shortest] = StepLength::SHORTER;
    let runs = [StepLength::FULL, short, shortest].map(|length| {
        let probe = ray_probe(march, &own.module, length)?;
        let (_, sampled) = sampled(loaded, (setting, moment), (probe, Watch::Nothing), &quads)?;
        Some(sampled)
    });
    let [full, short, shortest] = runs;
    let full = full?;
    let [short, shortest] = [short?, shortest?].map(|run| RayOutcome::all(&run.outputs));
    let all = RayOutcome::all(&full.outputs);
    let reached = all.iter().filter(|ray| ray.is_reached);
    let (rays, slope) = (reached.clone().count(), reached.map(|ray| ray.slope));
    let slope = slope.fold(0.0, f32::max);
    let pairs = all
        .iter()
        .zip(short.iter().zip(&shortest))
        .zip(&full.pixels);
    let mut missed = pairs.filter_map(|((real, (short, shortest)), pixel)| {
        real.steps_over([short, shortest]).then_some(MissedPoint {
            pixel: *pixel,
            point: shortest.point.map(|point| point.map(shortest_decimal)),
        })
    });
    let first = missed.next();
    let count = missed.count() + usize::from(first.is_some());
    let program = facts.program();
    let place = span(program, Provenance::Stmt(march.looped.stmt))?;
    let function = program.function(march.looped.function);
    Some(RayRow {
        at: position(&program.sources, place)?,
        function: function.map_or(String::new(), |f| program.names.text(f.name).to_string()),
        rays: rays as u64,
        stepped_over: count as f64 / rays.max(1) as f64,
        first,
        slope: shortest_decimal(slope),
        longer: longer((loaded, facts), (setting, moment), march, &quads),
    })
}

/// The longest steps that draw the same pixels, of a loop whose steps have a literal factor.
fn longer(
    (loaded, facts): (&Loaded, &Facts),
    (setting, moment): (&ShotSetting, &Moment),
    march: &March,
    quads: &[[u32; 2]],
) -> Option<LongerRow> {
    let factor = step_factor(facts, march)?;
    let with = |other: f64| {
        let probe = ray_probe(march, facts.module(), factor_length(factor, other))?;
        let (shot, sampled) = sampled(loaded, (setting, moment), (probe, Watch::Flow), quads)?;
        Some(MarchSample::of(shot.code(), &sampled, march.ray.looped))
    };
    let per_ray = |sample: &MarchSample| MarchSample::per_ray(std::slice::from_ref(sample));
    let before = with(factor)?;
    if !are_clearly_fewer([per_ray(&before), 0.0]) {
        return None;
    }
    let keeps = |other| Some(before.is_kept_by(&with(other)?));
    let larger = largest_factor(&longer_factors(factor), keeps)?;
    let iterations = [per_ray(&before), per_ray(&with(larger)?)];
    are_clearly_fewer(iterations).then(|| LongerRow {
        factor: shortest_decimal(factor as f32),
        larger: shortest_decimal(larger as f32),
        iterations: iterations.map(|n| shortest_decimal(n as f32)),
    })
}

/// Draws some quads with an observed loop.
fn sampled(
    loaded: &Loaded,
    (setting, moment): (&ShotSetting, &Moment),
    (probe, watch): (RayProbe, Watch),
    quads: &[[u32; 2]],
) -> Option<(Shot, Sampled)> {
    let setting = ShotSetting {
        show: None,
        rays: ObservedRays::Probe(probe),
        watch,
        trace: false,
        ..*setting
    };
    let mut observed = shot(loaded, &setting).ok()?;
    let sampled = observed.sampled(moment, quads, &mut |_| {}).ok()?;
    Some((observed, sampled))
}

/// The lines for people: the loops with rays that step over a surface, and those with needlessly short
/// steps.
pub fn lines(rows: &[RayRow]) -> String {
    let missed = rows.iter().filter_map(|row| {
        let MissedPoint {
            pixel: [x, y],
            point,
        } = row.first?;
        let place = point.map_or(String::new(), |point| {
            let numbers = point.map(|n| decimals(n, 3));
            format!(", at ({})", numbers.join(", "))
        });
        let share = percent(row.stepped_over);
        Some(format!(
            "  {}: {share} of the rays step over the surface, first at pixel {x},{y}{place}\n",
            row.at
        ))
    });
    let short = rows.iter().filter_map(|row| {
        let longer = row.longer?;
        let times = decimals(longer.larger / longer.factor, 1);
        let [before, after] = longer.iterations.map(f64::round);
        Some(format!(
            "  {}: steps could be {times} times as long: {after} instead of {before} iterations per ray\n",
            row.at
        ))
    });
    missed.chain(short).collect()
}
