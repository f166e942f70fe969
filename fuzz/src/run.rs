//! Programs with exactly known results, and what the VM draws for them.

use crate::builtins::CASES;
use crate::compute::{Computing, compute};
use shaderlint::engine::inputs::{Moment, Scene};
use shaderlint::engine::{Analysis, DialectChoice, Options, analyze};
use shaderlint::exec::{CompileOptions, Draw, Watch, compile, draw, sample};
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;

/// Size of a program's image, in pixels.
const SIZE: [u32; 2] = [8, 8];

/// Size of the image of a built-in function, in pixels.
const LARGE: [u32; 2] = [64, 64];

/// Memory limit for running a shader, in bytes: all registers, and 1 MB for each of 32 uniforms.
const MEMORY: usize = 40 << 20;

/// Limit of repeated instructions for a group of pixels.
const FUEL: u64 = 2_000_000;

/// Prints the programs of `count` seeds with their images, row by row from the bottom; a discarded
/// pixel is zero.
pub fn print(seed: u64, count: u64) {
    for seed in seed..seed + count {
        let program = compute(seed);
        let line = match render(&program, SIZE) {
            Ok(pixels) => serde_json::json!({
                "id": seed,
                "source": program.text,
                "seeds": program.seeds,
                "parts": program.parts,
                "pixels": pixels,
            }),
            Err(why) => serde_json::json!({ "id": seed, "source": program.text, "why": why }),
        };
        println!("{line}");
    }
}

/// Prints a program for each built-in function, with its image and the difference that is allowed
/// for another implementation.
pub fn print_builtins() {
    for case in &CASES {
        let program = case.program();
        let (kind, number) = case.bound();
        let line = match render(&program, LARGE) {
            Ok(pixels) => serde_json::json!({
                "id": case.text,
                "source": program.text,
                "seeds": program.seeds,
                "parts": program.parts,
                "pixels": pixels,
                "bound": kind,
                "by": number,
            }),
            Err(why) => serde_json::json!({ "id": case.text, "source": program.text, "why": why }),
        };
        println!("{line}");
    }
}

/// The image that the VM draws.
pub fn render(program: &Computing, size: [u32; 2]) -> Result<Vec<[u32; 4]>, String> {
    let options = Options::new(DialectChoice::Webgl2, Settings::of_rules(&[]));
    let report = analyze("a.frag", &program.text, &options, &NoFiles);
    let analysis = report.analyses.first().ok_or("no shader found")?;
    if analysis.has_errors {
        return Err("the shader has errors".to_string());
    }
    let options = CompileOptions::default();
    let code = compile(&analysis.program, analysis.module(), &options).map_err(|r| r.what)?;
    let mut job = Draw::new(&code, size);
    job.fuel = FUEL;
    job.set("seeds", &program.seeds.map(f64::from));
    job.set("parts", &program.parts.map(f64::from));
    let drawn = draw(&job, 1).map_err(|stop| format!("{stop:?}"))?;
    let pixels = drawn.outputs.into_iter().next().unwrap_or_default();
    let seen = pixels.into_iter().zip(drawn.covered);
    Ok(seen
        .map(|(pixel, covered)| if covered { pixel } else { [0; 4] })
        .collect())
}

/// Checks that a compiled shader draws the same bits as a complete frame, quad by quad, and with
/// instrumentation.
pub fn agrees_with_itself(text: &str) {
    let report = analyze("a.glsl", text, &Options::default(), &NoFiles);
    for analysis in report.analyses.iter().filter(|a| !a.has_errors) {
        let run = |watch| agrees_by_quads(analysis, watch);
        if let (Some(plain), Some(watched)) = (run(Watch::Nothing), run(Watch::Numbers)) {
            assert!(plain == watched, "different pixels with instrumentation");
        }
    }
}

/// Bits by output and pixel, and which pixels are covered.
type Pixels = (Vec<Vec<[u32; 4]>>, Vec<bool>);

/// What a shader draws, as a frame and quad by quad; `None` if it is rejected or takes too long.
fn agrees_by_quads(analysis: &Analysis, watch: Watch) -> Option<Pixels> {
    let options = CompileOptions {
        watch,
        ..CompileOptions::default()
    };
    // Shaders that cannot be run are rejected.
    let scene = Scene::of(
        &analysis.program,
        analysis.host,
        analysis.module(),
        &options,
    )
    .ok()?;
    let bytes = scene.code.bytes();
    assert!(bytes <= MEMORY, "{bytes} bytes to run it");
    let mut job = scene.draw(SIZE, &Moment::at(1.7));
    job.fuel = FUEL / 100;
    let full = draw(&job, 1).ok()?;
    let rows = (0..SIZE[1]).step_by(2);
    for (y, x) in rows.flat_map(|y| (0..SIZE[0]).step_by(2).map(move |x| (y, x))) {
        let quad = sample(&job, &[[x, y]]).ok()?;
        for (lane, [x, y]) in quad.pixels.iter().enumerate() {
            let at = (y * SIZE[0] + x) as usize;
            let is_same = quad.covered[lane] == full.covered[at];
            assert!(is_same, "single pixel {x}, {y}");
            for (quad, full) in quad.outputs.iter().zip(&full.outputs) {
                let (alone, framed) = (quad[lane], full[at]);
                assert!(
                    alone == framed,
                    "single pixel {x}, {y}: {alone:08x?}, in the frame {framed:08x?}"
                );
            }
        }
    }
    Some((full.outputs, full.covered))
}
