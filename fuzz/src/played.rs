//! Exports of ShaderToy, and what the machine draws of them, for a browser to draw them beside.

use serde_json::json;
use shaderlint::engine::play::{Moment, Picture, PlayOptions, Played, Player};
use shaderlint::exec::{CompileOptions, Kind, Lean, Persona, Watch};
use shaderlint::port::{Composed, Project, add_stand_ins};
use std::{fs, thread};

/// The size of a picture.
const SIZE: [u32; 2] = [96, 54];

/// The frames that are looked at.
const FRAMES: [u32; 2] = [0, 10];

/// GPUs that are no more exact than they have to be.
const INEXACT: [Persona; 3] = [
    Persona::Inexact(Lean::Out),
    Persona::Inexact(Lean::In),
    Persona::Inexact(Lean::Either),
];

/// Prints the pictures of some frames of an export, row by row from the bottom, three bytes a pixel, and
/// what went wrong with numbers on the way.
pub fn print(file: &str) {
    let frames = read(file).and_then(|export| played(&export, Persona::Exact));
    let line = match frames {
        Ok(frames) => {
            let frames = frames.iter().zip(FRAMES).map(|(own, number)| {
                json!({
                    "number": number,
                    "pixels": bytes(own).as_flattened(),
                    "wrong": wrong(own),
                })
            });
            json!({ "size": SIZE, "frames": frames.collect::<Vec<_>>() })
        }
        Err(why) => json!({ "why": why }),
    };
    println!("{line}");
}

/// Prints by frame and pixel of an export whether another GPU may draw it otherwise, by more than one
/// 255th.
pub fn print_unsettled(file: &str) {
    let frames = read(file).and_then(|export| {
        let exact = played(&export, Persona::Exact)?;
        let mut unsettled = vec![vec![false; SIZE.iter().product::<u32>() as usize]; FRAMES.len()];
        for persona in INEXACT {
            let other = played(&export, persona)?;
            for ((unsettled, own), other) in unsettled.iter_mut().zip(&exact).zip(&other) {
                let pixels = bytes(own).into_iter().zip(bytes(other));
                for (unsettled, (own, other)) in unsettled.iter_mut().zip(pixels) {
                    *unsettled |= own.iter().zip(other).any(|(a, b)| a.abs_diff(b) > 1);
                }
            }
        }
        Ok(unsettled)
    });
    println!(
        "{}",
        json!({ "unsettled": frames.as_ref().ok(), "why": frames.as_ref().err() })
    );
}

/// A project, put together.
type Export = (Project, Composed);

fn read(file: &str) -> Result<Export, String> {
    let text = fs::read_to_string(file).map_err(|e| e.to_string())?;
    let mut project = Project::from_json(&text).map_err(|e| e.to_string())?;
    add_stand_ins(&mut project);
    let composed = project.resolve(file).map_err(|e| e.to_string())?;
    match composed.has_errors() {
        true => Err("it has errors".to_string()),
        false => Ok((project, composed)),
    }
}

/// The frames as a GPU draws them.
fn played((project, composed): &Export, persona: Persona) -> Result<Vec<Played>, String> {
    let options = PlayOptions {
        size: SIZE,
        threads: thread::available_parallelism().map_or(1, usize::from),
        compile: CompileOptions {
            watch: match persona {
                Persona::Exact => Watch::Numbers,
                _ => Watch::Nothing,
            },
            persona,
            ..CompileOptions::default()
        },
        decode: None,
    };
    let mut player = Player::new(project, composed, &options).map_err(|p| p.to_string())?;
    let frames = FRAMES.into_iter().map(|frame| {
        let moment = Moment {
            // Where the clock of the browser stands.
            date: [2000.0, 0.0, 1.0, 0.0],
            ..Moment::of_frame(frame)
        };
        let drawn = player.play_to(&moment, &mut |_| {});
        drawn.map_err(|stop| format!("{stop:?}"))
    });
    frames.collect()
}

fn bytes(played: &Played) -> Vec<[u8; 3]> {
    let pixels = played.picture.pixels.iter();
    pixels.map(|pixel| Picture::shown(*pixel)).collect()
}

/// What went wrong with numbers in the passes of a frame.
fn wrong(played: &Played) -> Vec<&'static str> {
    let numbers = played
        .passes
        .iter()
        .flat_map(|(_, drawn)| &drawn.seen.numbers);
    let mut kinds: Vec<_> = numbers.map(|number| number.kind).collect();
    kinds.sort();
    kinds.dedup();
    let names = kinds.into_iter().map(|kind| match kind {
        Kind::Nan => "NaN",
        Kind::Infinite => "infinite",
        Kind::DivisionByZero => "division by zero",
        Kind::OutOfRange => "out of range",
        Kind::Undefined => "undefined",
    });
    names.collect()
}
