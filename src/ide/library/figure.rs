//! Small plots of built-in functions, from the values that the functions have in constants.

use shaderlint_semantic::builtins::{Builtins, Overload};
use shaderlint_semantic::{Stage, Type, Value};
use shaderlint_syntax::Version;
use shaderlint_text::number::decimals;

/// Columns and rows of characters; each has 2 by 4 dots.
const SIZE: [usize; 2] = [30, 5];

/// The plot that a line such as `fract(x), x from -2 to 2` describes, as a code block.
pub(super) fn plot(line: &str) -> Option<String> {
    let (call, range) = line.split_once(", x from ")?;
    let (from, to) = range.split_once(" to ")?;
    let left: f32 = from.parse().ok()?;
    let right: f32 = to.parse().ok()?;
    let (name, args) = call.strip_suffix(')')?.split_once('(')?;
    let args: Vec<&str> = args.split(", ").collect();
    let overload = overload(name, args.len())?;
    let steps = SIZE[0] * 2;
    let values = (0..steps).map(|i| {
        let x: f32 = left + (right - left) * i as f32 / (steps - 1) as f32;
        let arg = |arg: &&str| {
            Some([Value::Float(if *arg == "x" {
                x
            } else {
                arg.parse().ok()?
            })])
        };
        let args: Vec<[Value; 1]> = args.iter().map(arg).collect::<Option<_>>()?;
        let args: Vec<&[Value]> = args.iter().map(|arg| &arg[..]).collect();
        overload.fold(&args)?.first().map(|y| y.as_float())
    });
    let values: Vec<f32> = values.collect::<Option<_>>()?;
    let low = values.iter().copied().fold(f32::INFINITY, f32::min);
    let high = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let labels = [shown(high), shown(low)];
    let width = labels.iter().map(String::len).max().unwrap_or(0);
    let rows = dots(&values, low, high);
    let last = rows.len().saturating_sub(1);
    let mut text = String::from("```text\n");
    for (row, i) in rows.iter().zip(0..) {
        let label = match i {
            0 => labels[0].as_str(),
            i if i == last => labels[1].as_str(),
            _ => "",
        };
        text.push_str(&format!("{label:>width$} {row}\n"));
    }
    let room = SIZE[0].saturating_sub(from.len());
    text.push_str(&format!("{:width$} {from}{to:>room$}\n```", ""));
    Some(format!("`{call}`:\n\n{text}"))
}

/// The overload for scalars.
fn overload(name: &str, count: usize) -> Option<&'static Overload> {
    let builtins = Builtins::of(Version::Es300, Stage::Fragment);
    let (_, all) = builtins.overloads_of(builtins.function(name)?);
    all.iter().find(|overload| {
        let params = overload.params();
        params.len() == count && params.iter().all(|ty| *ty == Type::FLOAT)
    })
}

fn shown(value: f32) -> String {
    decimals(value.into(), 2)
}

/// The rows of a plot in Braille characters.
fn dots(values: &[f32], low: f32, high: f32) -> Vec<String> {
    /// The bits of the dots of a character, from top to bottom, left and right.
    const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    let height = SIZE[1] * 4;
    let mut cells = vec![[0u8; SIZE[0]]; SIZE[1]];
    let level = |y: f32| ((high - y) / (high - low) * (height - 1) as f32).round() as usize;
    let mut before: Option<usize> = None;
    for (y, x) in values.iter().zip(0..) {
        let at = level(*y);
        // The dots of a line are joined, those of a jump are not.
        let from = before
            .filter(|from| from.abs_diff(at) <= height / 6)
            .unwrap_or(at);
        for dot in from.min(at)..=from.max(at) {
            // The dot of the value before is already set.
            if dot != at && Some(dot) == before {
                continue;
            }
            let bit = BITS.get(dot % 4).and_then(|row| row.get(x % 2));
            let cell = cells.get_mut(dot / 4).and_then(|row| row.get_mut(x / 2));
            if let (Some(cell), Some(bit)) = (cell, bit) {
                *cell |= bit;
            }
        }
        before = Some(at);
    }
    let character = |bits: &u8| char::from_u32(0x2800 + u32::from(*bits)).unwrap_or(' ');
    let rows = cells.iter();
    rows.map(|row| row.iter().map(character).collect())
        .collect()
}
