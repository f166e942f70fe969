//! Programs of which every number is known, and what the machine draws of them.

use crate::builtins::CASES;
use crate::compute::{Computing, compute};
use shaderlint::engine::play::{Moment, Scene};
use shaderlint::engine::{Analysis, DialectChoice, NoFiles, Options, analyze};
use shaderlint::exec::{CompileOptions, Draw, Watch, compile, draw, sample};
use shaderlint::lint::Settings;

/// The size of a picture.
const SIZE: [u32; 2] = [8, 8];

/// The size of a picture of a built-in function.
const LARGE: [u32; 2] = [64, 64];

/// Bytes that running a shader may take: as many as all registers, and 1 MB for each of 32 uniforms.
const MEMORY: usize = 40 << 20;

/// Instructions that a group of pixels may repeat.
const FUEL: u64 = 2_000_000;

/// Prints the programs of `count` seeds with their pictures, row by row from the bottom; a discarded
/// pixel has zeros.
pub fn print(seed: u64, count: u64) {
    for seed in seed..seed + count {
        let program = compute(seed);
        let line = match picture(&program, SIZE) {
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

/// Prints a program for each built-in function, with its picture and how far from that another
/// machine may be.
pub fn print_builtins() {
    for case in &CASES {
        let program = case.program();
        let (kind, number) = case.bound();
        let line = match picture(&program, LARGE) {
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

/// What the machine draws.
pub fn picture(program: &Computing, size: [u32; 2]) -> Result<Vec<[u32; 4]>, String> {
    let options = Options::new(DialectChoice::Webgl2, Settings::of_rules(&[]));
    let report = analyze("a.frag", &program.text, &options, &NoFiles);
    let analysis = report.analyses.first().ok_or("there is no shader")?;
    if analysis.has_errors {
        return Err("it has errors".to_string());
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

/// What compiles draws the same bits in a whole picture, quad by quad, and while it is watched.
pub fn agrees_with_itself(text: &str) {
    let report = analyze("a.glsl", text, &Options::default(), &NoFiles);
    for analysis in report.analyses.iter().filter(|a| !a.has_errors) {
        let run = |watch| agrees_by_quads(analysis, watch);
        if let (Some(plain), Some(watched)) = (run(Watch::Nothing), run(Watch::Numbers)) {
            assert!(plain == watched, "other pixels while watched");
        }
    }
}

/// By output and pixel the bits, and which pixels are covered.
type Pixels = (Vec<Vec<[u32; 4]>>, Vec<bool>);

/// What a shader draws, whole and quad by quad; nothing where it is refused or takes too long.
fn agrees_by_quads(analysis: &Analysis, watch: Watch) -> Option<Pixels> {
    let options = CompileOptions {
        watch,
        ..CompileOptions::default()
    };
    // What cannot be run is refused.
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
    let whole = draw(&job, 1).ok()?;
    let rows = (0..SIZE[1]).step_by(2);
    for (y, x) in rows.flat_map(|y| (0..SIZE[0]).step_by(2).map(move |x| (y, x))) {
        let quad = sample(&job, &[[x, y]]).ok()?;
        for (lane, [x, y]) in quad.pixels.iter().enumerate() {
            let at = (y * SIZE[0] + x) as usize;
            let is_same = quad.covered[lane] == whole.covered[at];
            assert!(is_same, "pixel {x}, {y} alone");
            for (quad, whole) in quad.outputs.iter().zip(&whole.outputs) {
                assert!(quad[lane] == whole[at], "pixel {x}, {y} alone");
            }
        }
    }
    Some((whole.outputs, whole.covered))
}
