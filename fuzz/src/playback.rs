//! ShaderToy exports and what the VM draws for them, for comparison with a browser.

use serde_json::json;
use shaderlint::engine::inputs::Moment;
use shaderlint::exec::{CompileOptions, ErrorDirection, FaultKind, GpuProfile, Watch};
use shaderlint::play::{PlaybackOptions, Played, Player, RenderedImage};
use shaderlint::project::{Composed, Project, add_stand_ins};
use std::{fs, thread};

/// Size of a frame, in pixels.
const SIZE: [u32; 2] = [96, 54];

/// Numbers of the compared frames.
const FRAMES: [u32; 2] = [0, 10];

/// GPU profiles with the lowest precision that the standard allows.
const IMPRECISE_GPUS: [GpuProfile; 3] = [
    GpuProfile::Inexact(ErrorDirection::Out),
    GpuProfile::Inexact(ErrorDirection::In),
    GpuProfile::Inexact(ErrorDirection::Either),
];

/// Prints some frames of an export, row by row from the bottom, three bytes per pixel, and the
/// numeric errors that occurred.
pub fn print(file: &str) {
    let frames = read(file).and_then(|export| played(&export, GpuProfile::Exact));
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

/// Prints for each frame and pixel of an export whether another GPU may draw it differently, by
/// more than 1/255.
pub fn print_unsettled(file: &str) {
    let frames = read(file).and_then(|export| {
        let exact = played(&export, GpuProfile::Exact)?;
        let mut unsettled = vec![vec![false; SIZE.iter().product::<u32>() as usize]; FRAMES.len()];
        for gpu_profile in IMPRECISE_GPUS {
            let other = played(&export, gpu_profile)?;
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

/// A project and its composed passes.
type Export = (Project, Composed);

fn read(file: &str) -> Result<Export, String> {
    let text = fs::read_to_string(file).map_err(|e| e.to_string())?;
    let mut project = Project::from_json(&text).map_err(|e| e.to_string())?;
    add_stand_ins(&mut project);
    let composed = project.resolve(file).map_err(|e| e.to_string())?;
    match composed.has_errors() {
        true => Err("the shader has errors".to_string()),
        false => Ok((project, composed)),
    }
}

/// The frames as drawn by a GPU with this profile.
fn played((project, composed): &Export, gpu_profile: GpuProfile) -> Result<Vec<Played>, String> {
    let options = PlaybackOptions {
        size: SIZE,
        threads: thread::available_parallelism().map_or(1, usize::from),
        observed: None,
        compile: CompileOptions {
            watch: match gpu_profile {
                GpuProfile::Exact => Watch::Numbers,
                _ => Watch::Nothing,
            },
            gpu_profile,
            ..CompileOptions::default()
        },
        decode: None,
    };
    let mut player = Player::new(project, composed, &options).map_err(|p| p.to_string())?;
    let frames = FRAMES.into_iter().map(|frame| {
        let moment = Moment {
            // The time that the browser's clock shows.
            date: [2000.0, 0.0, 1.0, 0.0],
            ..Moment::of_frame(frame)
        };
        let drawn = player.play_to(&moment, &mut |_| {});
        drawn.map_err(|stop| format!("{stop:?}"))
    });
    frames.collect()
}

fn bytes(played: &Played) -> Vec<[u8; 3]> {
    let pixels = played.image.pixels.iter();
    pixels.map(|pixel| RenderedImage::shown(*pixel)).collect()
}

/// The numeric errors in the passes of a frame.
fn wrong(played: &Played) -> Vec<&'static str> {
    let numbers = played
        .passes
        .iter()
        .flat_map(|(_, drawn)| &drawn.seen.numbers);
    let mut kinds: Vec<_> = numbers.map(|number| number.kind).collect();
    kinds.sort();
    kinds.dedup();
    let names = kinds.into_iter().map(|kind| match kind {
        FaultKind::Nan => "NaN",
        FaultKind::Infinite => "infinite",
        FaultKind::DivisionByZero => "division by zero",
        FaultKind::OutOfRange => "out of range",
        FaultKind::Undefined => "undefined",
    });
    names.collect()
}
