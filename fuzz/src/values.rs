//! Shaders that draw white if they compute correctly: how many do, in one process for all of them.

use serde_json::{Value, json};
use shaderlint::commands::run::{
    FrameView, Loaded, ObservedRays, ShotSetting, UniformText, frame, shot,
};
use shaderlint::engine::inputs::Moment;
use shaderlint::exec::Watch;
use shaderlint::project::Project;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

/// Prints the number of cases in a file of JSON lines (`{"id", "source", "uniforms"}`), and the ids
/// and messages of those that do not draw a white pixel.
pub fn print(file: &str) {
    let text = fs::read_to_string(file).expect("the file with the cases");
    let cases: Vec<&str> = text.lines().collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut wrong = Vec::new();
        while let Some(case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
            let case: Value = serde_json::from_str(case).expect("a case");
            if let Err(why) = is_white(&case) {
                wrong.push(json!({ "id": case["id"], "why": why }));
            }
        }
        wrong
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let wrong: Vec<Value> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let found = workers.into_iter().map(|w| w.join().expect("no panic"));
        found.flatten().collect()
    });
    println!("{}", json!({ "cases": cases.len(), "wrong": wrong }));
}

/// Draws one pixel of a case, as `shaderlint run` does.
fn is_white(case: &Value) -> Result<(), String> {
    let source = case["source"].as_str().ok_or("no source")?;
    let mut project = Project::from_shader("case", source).map_err(|e| e.to_string())?;
    let composed = project.resolve("case.frag").map_err(|e| e.to_string())?;
    if composed.has_errors() {
        return Err("the shader has errors".to_string());
    }
    let loaded = Loaded {
        name: "case.frag".to_string(),
        project,
        composed,
    };
    let uniforms = uniforms(&case["uniforms"]);
    let setting = ShotSetting {
        size: [1, 1],
        threads: 1,
        pass: None,
        show: None,
        uniforms: Some(UniformText {
            name: "uniforms",
            text: &uniforms,
        }),
        rays: ObservedRays::Nothing,
        watch: Watch::Flow,
        trace: false,
        decode: None,
    };
    let mut shot = shot(&loaded, &setting)?;
    let moment = Moment::given(None, None, None);
    let drawn = frame(
        &loaded,
        &mut shot,
        &moment,
        FrameView::default(),
        &mut |_| {},
    )?;
    let mean = drawn.facts.outputs.first().map(|o| &o.mean);
    match mean.is_some_and(|mean| mean.iter().all(|value| *value >= 1.0)) {
        true => Ok(()),
        false => Err(format!("it draws {mean:?}")),
    }
}

/// The values of uniforms, as `--uniforms` reads them: a value with one component is a number.
fn uniforms(given: &Value) -> String {
    let given = given.as_object().into_iter().flatten();
    let value = |value: &Value| match value["value"].as_array().map(Vec::as_slice) {
        Some([one]) => one.clone(),
        _ => value["value"].clone(),
    };
    let values = given.map(|(name, own)| (name.clone(), value(own)));
    Value::Object(values.collect()).to_string()
}
