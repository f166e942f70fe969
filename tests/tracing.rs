//! A traced pixel is that of the image: the same bits, the same cost.

use shaderlint::commands::run::{Loaded, ObservedRays, ShotSetting, shot};
use shaderlint::engine::inputs::Moment;
use shaderlint::exec::{TracedValue, Watch};
use shaderlint::project::{Project, add_stand_ins};
use std::fs;
use std::path::Path;

const SIZE: [u32; 2] = [48, 27];
/// Pixels at the corners, in all places of a quad, and in the middle.
const PIXELS: [[u32; 2]; 7] = [
    [0, 0],
    [47, 26],
    [24, 13],
    [25, 13],
    [24, 14],
    [25, 14],
    [31, 5],
];

fn setting(trace: bool) -> ShotSetting<'static> {
    ShotSetting {
        rays: ObservedRays::Nothing,
        size: SIZE,
        threads: 1,
        pass: None,
        show: None,
        uniforms: None,
        watch: Watch::Flow,
        trace,
        decode: None,
    }
}

fn loaded(path: &Path) -> Loaded {
    let name = path.to_string_lossy().to_string();
    let text = fs::read_to_string(path).unwrap();
    let mut project = Project::from_shader("traced", &text).unwrap();
    let composed = project.resolve(&name).unwrap();
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &name).unwrap();
    assert!(!composed.has_errors(), "{name}");
    Loaded {
        name,
        project,
        composed,
    }
}

#[test]
fn traced_pixels_equal_those_of_the_image() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/templates");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut shaders: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|e| e == "glsl"))
        .collect();
    shaders.sort();
    assert!(shaders.len() >= 3, "{shaders:?}");
    for path in shaders {
        let loaded = loaded(&path);
        let moment = Moment::at(1.5);
        let drawn = shot(&loaded, &setting(false))
            .unwrap()
            .drawn(&moment, &mut |_| {})
            .unwrap();
        let mut ready = shot(&loaded, &setting(true)).unwrap();
        for [x, y] in PIXELS {
            let traced = ready
                .traced(&moment, ([x, y], 100_000), &mut |_| {})
                .unwrap();
            let at = (y * SIZE[0] + x) as usize;
            let of_image: Vec<_> = drawn.outputs.iter().map(|output| output[at]).collect();
            let place = format!("{} at {x},{y}", loaded.name);
            assert_eq!(traced.outputs, of_image, "{place}");
            assert_eq!(
                (traced.cost, traced.is_covered),
                (drawn.cost[at], drawn.covered[at]),
                "{place}"
            );
            let writes = traced.steps.iter().rev().find(|step| {
                let site = &traced.sites[step.site as usize];
                matches!(site.value, TracedValue::Written(..)) && site.ty.components() == 4
            });
            // Every template ends with its colour.
            assert_eq!(writes.unwrap().bits, traced.outputs[0], "{place}");
        }
    }
}
