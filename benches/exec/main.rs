//! Speed of running shaders without a GPU: `cargo bench --bench exec` prints the numbers as one
//! JSON object, which `benches/run` copies into its table. Each number is the best of several runs.

mod voxel;

use shaderlint::engine::inputs::{Moment, Scene};
use shaderlint::engine::{Analysis, Options, analyze};
use shaderlint::exec::{CompileOptions, Draw, Watch, draw, quads_all_over, sample};
use shaderlint::ir::lower;
use shaderlint::play::RenderedImage;
use shaderlint::project::NoFiles;
use std::hint::black_box;
use std::time::Instant;

/// Resolution that sampling assumes, in pixels.
const SIZE: [u32; 2] = [1280, 720];
/// Resolution of complete frames, in pixels.
const IMAGE_SIZE: [u32; 2] = [640, 360];
const TIME: f64 = 2.0;
/// Minimum duration of one measurement, in seconds.
const SECONDS: f64 = 0.5;

/// Time of the fastest run, in milliseconds.
fn best(mut work: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    while begin.elapsed().as_secs_f64() < SECONDS || best == f64::INFINITY {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    best
}

/// Compiles a template of the corpus.
fn checked(name: &str) -> Analysis {
    let path = format!(
        "{}/corpus/templates/{name}.glsl",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(&path).expect("readable template");
    let report = analyze(&path, &text, &Options::default(), &NoFiles);
    report
        .analyses
        .into_iter()
        .next()
        .expect("exactly one shader")
}

fn scene(analysis: &Analysis, watch: Watch) -> Scene {
    let options = CompileOptions {
        watch,
        cost: watch == Watch::Flow,
        ..CompileOptions::default()
    };
    Scene::of(&analysis.program, None, analysis.module(), &options).expect("executable shader")
}

/// All measurements of a template.
fn measured(name: &str) -> serde_json::Value {
    let analysis = checked(name);
    let (plain, watched) = (
        scene(&analysis, Watch::Nothing),
        scene(&analysis, Watch::Flow),
    );
    let moment = Moment::at(TIME);
    let quads = quads_all_over(SIZE, 48 * 48, 0);
    let asked = |draw: Draw<'_>| best(|| drop(black_box(sample(&draw, &quads))));
    let whole = |scene: &Scene, threads| {
        let draw_ready = scene.draw(IMAGE_SIZE, &moment);
        best(|| drop(black_box(draw(&draw_ready, threads))))
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let seen = draw(&watched.draw(IMAGE_SIZE, &moment), cores)
        .expect("run within the fuel limit")
        .seen;
    let one = whole(&plain, 1);
    let pixels = f64::from(IMAGE_SIZE[0] * IMAGE_SIZE[1]);
    let options = CompileOptions::default();
    serde_json::json!({
        "sampling_ms": asked(plain.draw(SIZE, &moment)),
        "watched_sampling_ms": asked(watched.draw(SIZE, &moment)),
        "lower_ms": best(|| drop(black_box(lower(&analysis.program)))),
        "compile_ms": best(|| drop(black_box(Scene::of(&analysis.program, None, analysis.module(), &options,
        )))),
        "pixel_one_core_ns": one * 1e6 / pixels,
        "pixel_all_cores_ns": whole(&plain, cores) * 1e6 / pixels,
        "lane_op_ns": one * 1e6 / seen.operations as f64,
        "operations_per_pixel": seen.operations as f64 / pixels,
    })
}

/// Time per pixel of the native version on one core, after checking that it draws the same image.
fn native() -> f64 {
    let time = TIME as f32;
    let own = || (0..IMAGE_SIZE[1]).flat_map(|y| (0..IMAGE_SIZE[0]).map(move |x| [x, y]));
    let analysis = checked("voxel");
    let scene = scene(&analysis, Watch::Nothing);
    let drawn =
        draw(&scene.draw(IMAGE_SIZE, &Moment::at(TIME)), 1).expect("run within the fuel limit");
    let image = RenderedImage::of(&scene.code, &drawn, 0);
    let differs = own().zip(&image.pixels).filter(|(at, known)| {
        let found = voxel::pixel(*at, IMAGE_SIZE, time);
        let mut gaps = found.iter().zip(*known).map(|(a, b)| (a - b).abs());
        gaps.any(|gap| gap > 1.0 / 255.0)
    });
    let share = differs.count() as f64 / image.pixels.len() as f64;
    assert!(
        share < 0.001,
        "{share} of the pixels differ from the shader's"
    );
    let draw_all = || {
        let sum: f32 = own().map(|at| voxel::pixel(at, IMAGE_SIZE, time)[0]).sum();
        black_box(sum);
    };
    best(draw_all) * 1e6 / f64::from(IMAGE_SIZE[0] * IMAGE_SIZE[1])
}

fn main() {
    let templates = ["voxel", "raymarching", "terrain"];
    let measured = templates.map(|name| (name.to_string(), measured(name)));
    let all = serde_json::json!({
        "templates": serde_json::Map::from_iter(measured),
        "native_pixel_ns": native(),
    });
    println!("{all}");
}
