//! What the debugger shows is what the shader computes, forwards and backwards.
//!
//! `SHADERLINT_CASES=DIR cargo test --test all debugging` also reads the ShaderToy exports in
//! `DIR/shadertoy`.

use serde_json::{Value, json};
use shaderlint::commands::run::{
    FrameDraw, Loaded, ObservedRays, Shot, ShotSetting, Variant, shot,
};
use shaderlint::dap::{Adapter, Launch, ProgramSource};
use shaderlint::engine::inputs::Moment;
use shaderlint::exec::{CompileOptions, Replay, TracedValue, Watch, lane_of};
use shaderlint::play::Decode;
use shaderlint::project::{Project, add_stand_ins};
use shaderlint::semantic::VariableId;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

const SIZE: [u32; 2] = [48, 27];
/// Maximum number of scalars of a value that are compared, as many as a trace has.
const SCALARS: usize = 64;

fn setting(trace: bool) -> ShotSetting<'static> {
    ShotSetting {
        size: SIZE,
        threads: 1,
        pass: None,
        show: None,
        uniforms: None,
        watch: Watch::Nothing,
        trace,
        rays: ObservedRays::Nothing,
        decode: None,
    }
}

/// The shaders to debug; exports are every tenth of the folder.
fn shaders() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/templates");
    let mut all = files(&folder, "glsl");
    assert!(all.len() >= 3, "{all:?}");
    if let Some(cases) = std::env::var_os("SHADERLINT_CASES") {
        let exports = files(&Path::new(&cases).join("shadertoy"), "json");
        all.extend(exports.into_iter().step_by(10));
    }
    all
}

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut found: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    found.sort();
    found
}

fn loaded(path: &Path) -> Option<Loaded> {
    let name = path.to_string_lossy().to_string();
    let text = fs::read_to_string(path).unwrap();
    let mut project = match path.extension().is_some_and(|e| e == "json") {
        true => Project::from_json(&text).ok()?,
        false => Project::from_shader("debugged", &text).unwrap(),
    };
    let composed = project.resolve(&name).ok()?;
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &name).ok()?;
    (!composed.has_errors()).then_some(Loaded {
        name,
        project,
        composed,
    })
}

/// A small generator of numbers, the same on every machine.
struct Numbers(u32);

impl Numbers {
    fn below(&mut self, end: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((u64::from(self.0) * u64::from(end)) >> 32) as u32
    }
}

/// Every value that a variable has after a statement that writes it is that of a trace of other code:
/// the code of the image, in which variables share registers.
#[test]
fn debugged_values_equal_those_of_a_trace() {
    // Early, because buffers are drawn from the first frame on.
    let moment = Moment::of_frame(3);
    let mut compared = 0;
    for path in shaders() {
        let Some(loaded) = loaded(&path) else {
            continue;
        };
        let Ok(mut traced) = shot(&loaded, &setting(true)) else {
            continue;
        };
        for pixel in [[24, 13], [3, 20], [41, 2]] {
            compared += compare(&loaded, &mut traced, (&moment, pixel));
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Compares all values of a pixel. Returns how many.
fn compare(loaded: &Loaded, traced: &mut Shot, (moment, pixel): (&Moment, [u32; 2])) -> usize {
    const MOST: usize = 20_000;
    let place = format!("{} at {pixel:?}", loaded.name);
    let Ok(trace) = traced.traced(moment, (pixel, MOST), &mut |_| {}) else {
        return 0;
    };
    let mut written: HashMap<VariableId, Vec<&[u32]>> = HashMap::new();
    for step in &trace.steps {
        if let TracedValue::Written(id, _) = trace.sites[step.site as usize].value {
            written.entry(id).or_default().push(&step.bits);
        }
    }
    let prepared = traced.prepared(moment, &mut |_| {}).unwrap();
    let options = CompileOptions {
        steps: true,
        trace: true,
        ..CompileOptions::default()
    };
    let build = Variant::of(
        loaded,
        FrameDraw::of(traced, &prepared, moment),
        None,
        &options,
    )
    .unwrap();
    let draw = build.draw();
    let mut replay = Replay::new(&draw, pixel).unwrap();
    let lane = lane_of(pixel);
    let mut seen: HashMap<VariableId, usize> = HashMap::new();
    let (mut steps, mut compared) = (0, 0);
    while let Some(pause) = replay.advance().unwrap() {
        if pause.lanes >> lane & 1 == 0 {
            continue;
        }
        let writes: Vec<VariableId> = replay.writes().map(|(id, _)| id).collect();
        replay.forget();
        steps += writes.len();
        if steps > MOST / 2 {
            break;
        }
        for id in &writes {
            *seen.entry(*id).or_default() += 1;
        }
        for id in writes {
            let number = seen[&id];
            // A local variable of a function that has returned is gone.
            if let Some(bits) = replay.scalars(id, lane, SCALARS) {
                assert_eq!(
                    Some(&&bits[..]),
                    written[&id].get(number - 1),
                    "{place}: {id:?}"
                );
                compared += 1;
            }
        }
    }
    if trace.is_covered && steps <= MOST / 2 {
        let outputs = replay.outputs(lane);
        let first: Vec<u32> = outputs[0].iter().copied().take(4).collect();
        assert_eq!(first, trace.outputs[0][..first.len()], "{place}");
    }
    compared
}

/// Programs that are already loaded.
struct Given;

impl ProgramSource for Given {
    fn load(&self, launch: &Launch) -> Result<Loaded, String> {
        loaded(Path::new(&launch.program)).ok_or_else(|| "the shader has errors".to_string())
    }

    fn decode(&self) -> Option<Decode> {
        None
    }

    fn text(&self, path: &str) -> Option<String> {
        fs::read_to_string(path).ok()
    }

    fn threads(&self) -> usize {
        1
    }
}

/// A client of the debugger.
struct DebugClient<'p> {
    adapter: Adapter<'p>,
    sequence: u64,
    /// The moment and thread of the last stop.
    now: (u64, u64),
}

impl DebugClient<'_> {
    /// Sends a request. Returns the body of the answer.
    fn ask(&mut self, command: &str, arguments: Value) -> Result<Value, String> {
        self.sequence += 1;
        let message = json!({
            "seq": self.sequence, "type": "request", "command": command, "arguments": arguments,
        });
        let mut answer = Err("no answer".to_string());
        for message in self.adapter.handle(&message) {
            if message["type"] == "response" {
                answer = match message["success"].as_bool() {
                    Some(true) => Ok(message["body"].clone()),
                    _ => Err(message["message"].to_string()),
                };
            } else if message["event"] == "stopped" {
                let body = &message["body"];
                self.now = (
                    body["moment"].as_u64().unwrap(),
                    body["threadId"].as_u64().unwrap(),
                );
            }
        }
        answer
    }

    /// Everything that is shown: the stack of each thread, and the variables of all frames.
    fn state(&mut self) -> String {
        let mut state = String::new();
        let thread = self.now.1;
        let stack = self
            .ask("stackTrace", json!({ "threadId": thread }))
            .unwrap();
        for frame in stack["stackFrames"].as_array().unwrap() {
            state += &format!("{} {} {}\n", frame["name"], frame["line"], frame["column"]);
            let scopes = self
                .ask("scopes", json!({ "frameId": frame["id"] }))
                .unwrap();
            for scope in scopes["scopes"].as_array().unwrap() {
                let reference = &scope["variablesReference"];
                let asked = json!({ "variablesReference": reference });
                let variables = self.ask("variables", asked).unwrap();
                for variable in variables["variables"].as_array().unwrap() {
                    state += &format!("  {} = {}\n", variable["name"], variable["value"]);
                }
            }
        }
        state
    }
}

/// Whatever the way to a moment, everything that is shown there is the same.
#[test]
fn stepping_back_restores_every_bit() {
    let forwards = [
        "next",
        "stepIn",
        "stepOut",
        "shaderlint/nextIteration",
        "continue",
    ];
    let backwards = [
        "stepBack",
        "shaderlint/stepBackIn",
        "shaderlint/stepBackOut",
        "reverseContinue",
    ];
    let mut numbers = Numbers(7);
    let walks = match std::env::var_os("SHADERLINT_CASES") {
        Some(_) => 30,
        None => 4,
    };
    let mut revisited = 0;
    for path in shaders() {
        for _ in 0..walks {
            let mut client = DebugClient {
                adapter: Adapter::new(&Given),
                sequence: 0,
                now: (0, 0),
            };
            let pixel = [numbers.below(SIZE[0]), numbers.below(SIZE[1])];
            client.ask("initialize", json!({})).unwrap();
            let launch = json!({ "program": path, "size": SIZE, "pixel": pixel, "frame": 3 });
            if client.ask("launch", launch).is_err() {
                continue;
            }
            client.ask("configurationDone", json!({})).unwrap();
            let mut states: HashMap<u64, String> = HashMap::new();
            for _ in 0..20 {
                // The end is reached too early if all motions were long.
                let ways = match numbers.below(2) {
                    0 => &forwards[..],
                    _ => &backwards[..],
                };
                let choice = numbers.below(ways.len() as u32 * 2) as usize % ways.len();
                let (before, state) = (client.now.0, client.state());
                client
                    .ask(ways[choice], json!({ "threadId": client.now.1 }))
                    .unwrap();
                let after = client.state();
                for (moment, state) in [(before, state), (client.now.0, after)] {
                    let known = states.entry(moment).or_insert_with(|| state.clone());
                    assert_eq!(*known, state, "{} at {pixel:?}, {moment}", path.display());
                    revisited += 1;
                }
            }
        }
    }
    assert!(revisited > 400, "{revisited}");
}
