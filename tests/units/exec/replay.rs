//! Tests of replays: where they stop, what they show, and that they come back to every bit.

use super::results::compiled;
use shaderlint_exec::{CompileOptions, Draw, Pause, QUAD, Replay, StopKind, draw, lane_of};
use shaderlint_ir::lower;
use shaderlint_semantic::{Program, check_fragment};

/// Options for code that stops.
fn stepping() -> CompileOptions {
    CompileOptions {
        steps: true,
        ..CompileOptions::default()
    }
}

const SHADER: &str = include_str!("replay.glsl");

/// The source of a stop, with the names of the functions that run.
fn shown(program: &Program, draw: &Draw<'_>, pause: &Pause) -> String {
    let stop = draw.code.stops()[pause.site as usize];
    let span = program.span(stop.extent);
    let names = draw.code.frames(&stop).map(|(function, _)| {
        let function = function.and_then(|f| program.function(f));
        function.map_or("globals", |f| program.names.text(f.name))
    });
    let back = matches!(stop.kind, StopKind::Return(..));
    let back = if back { " returned" } else { "" };
    let path: Vec<&str> = names.collect();
    format!("{} in {}{back}", program.sources.text(span), path.join("<"))
}

/// The values of variables; NaN if they have none.
fn variables(program: &Program, replay: &Replay<'_>, names: [&str; 5]) -> [f32; 5] {
    let find = |name: &str| {
        let mut all = (0..).zip(&program.variables);
        let (id, _) = all
            .find(|(_, v)| program.names.text(v.name) == name)
            .unwrap();
        let bits = replay.scalars(shaderlint_semantic::VariableId(id), 0, 1);
        bits.map_or(f32::NAN, |bits| f32::from_bits(bits[0]))
    };
    names.map(find)
}

/// The stops of the lower left pixel, and the variables `g`, `a`, `sum`, `d` and `old` there.
const STOPS: &str = include_str!("replay_stops.txt");

#[test]
fn a_replay_stops_before_each_statement() {
    let analysis = check_fragment(SHADER);
    let code = compiled(SHADER, &stepping());
    let mut ready = Draw::new(&code, [4, 2]);
    ready.set("x", &[0.25]);
    let mut replay = Replay::new(&ready, [0, 0]).unwrap();
    let mut lines = Vec::new();
    while let Some(pause) = replay.advance().unwrap() {
        if pause.lanes & 1 == 1 {
            let values = variables(&analysis.program, &replay, ["g", "a", "sum", "d", "old"]);
            let values = values.map(|v| v.to_string()).join(" ");
            lines.push(format!(
                "{}: {values}",
                shown(&analysis.program, &ready, &pause)
            ));
        }
    }
    assert_eq!(lines.join("\n"), STOPS.trim_end());
}

/// The outputs at the end of a replay are those of the draw, in each lane.
#[test]
fn a_replay_ends_with_the_outputs_of_the_draw() {
    let plain = compiled(SHADER, &CompileOptions::default());
    let code = compiled(SHADER, &stepping());
    let mut drawn = Draw::new(&plain, [4, 2]);
    drawn.set("x", &[0.25]);
    let image = draw(&drawn, 1).unwrap();
    let mut ready = Draw::new(&code, [4, 2]);
    ready.set("x", &[0.25]);
    for at in 0..8 {
        let mut replay = Replay::new(&ready, [at % 4, at / 4]).unwrap();
        while replay.advance().unwrap().is_some() {}
        let lane = lane_of([at % 4, at / 4]);
        assert_eq!(replay.outputs(lane)[0], image.outputs[0][at as usize]);
    }
}

#[test]
fn a_checkpoint_restores_every_bit() {
    let code = compiled(SHADER, &stepping());
    let ready = Draw::new(&code, [4, 2]);
    let program = &check_fragment(SHADER).program;
    let count = lower(program).variables.len() as u32;
    let state = |replay: &Replay<'_>| -> Vec<_> {
        let ids = (0..count).map(shaderlint_semantic::VariableId);
        let lanes = |id| (0..QUAD).map(move |lane| (id, lane));
        ids.flat_map(lanes)
            .map(|(id, lane)| replay.scalars(id, lane, 64))
            .collect()
    };
    let mut replay = Replay::new(&ready, [1, 1]).unwrap();
    let mut kept = Vec::new();
    while let Some(pause) = replay.advance().unwrap() {
        kept.push((replay.checkpoint(), pause, state(&replay)));
    }
    for pair in kept.windows(2).rev() {
        let (before, after) = (&pair[0], &pair[1]);
        replay.restore(&before.0);
        assert_eq!(state(&replay), before.2);
        assert_eq!(replay.advance().unwrap(), Some(after.1));
        assert_eq!(state(&replay), after.2);
    }
}

/// The statistics of a draw count how often each statement runs, and for how many pixels.
#[test]
fn a_draw_counts_statements() {
    let analysis = check_fragment(SHADER);
    let code = compiled(SHADER, &stepping());
    let ready = Draw::new(&code, [4, 2]);
    let seen = draw(&ready, 1).unwrap().seen.statements;
    let find = |text: &str| {
        let mut statements = code.statements().iter().zip(&seen);
        let is_it = |extent| analysis.program.sources.text(analysis.program.span(extent)) == text;
        let (_, seen) = statements.find(|(extent, _)| is_it(**extent)).unwrap();
        (seen.times, seen.pixels)
    };
    assert_eq!(find("continue;"), (2, 2));
    assert_eq!(find("i < 3"), (32, 8));
    // Of all three calls.
    assert_eq!(find("a > 3.0"), (38, 8));
}
