//! Contact sheets: frames of several times next to each other.

use super::args::RunArgs;
use crate::cli::progress::Progress;
use crate::commands::run::{Bitmap, Loaded, SheetFacts, Shot, font, frame};
use crate::engine::inputs::Moment;
use crate::text::number::short;

/// Distance between two frames in pixels.
const GAP: u32 = 4;
const GROUND: [u8; 3] = [16; 3];
const TEXT: [u8; 3] = [220; 3];

/// Draws a contact sheet of `count` frames. Each is drawn in full size and scaled down, because the
/// shader may depend on the size of a pixel.
pub fn draw(
    loaded: &Loaded,
    shot: &mut Shot,
    args: &RunArgs,
    count: u32,
) -> Result<(Bitmap, SheetFacts), String> {
    let columns = columns(count);
    let small = args.size.map(|side| (side / columns).max(1));
    let scale = (small[0] / 80).clamp(1, 4);
    let label = font::HEIGHT * scale + 2 * GAP;
    let rows = count.div_ceil(columns);
    let cell = [small[0] + GAP, small[1] + label];
    let size = [columns * cell[0] + GAP, rows * cell[1] + GAP];
    let mut sheet = Bitmap::filled(size, GROUND);
    let first = args.moment();
    let progress = Progress::new(count);
    let mut frames = Vec::new();
    for i in 0..count {
        let moment = Moment {
            mouse: first.mouse,
            ..Moment::at(first.time + f64::from(i) * args.every)
        };
        let mut report = |number| progress.frame(number, moment.frame);
        let made = frame(loaded, shot, &moment, args.view(), &mut report)?;
        let [left, top] = [GAP + i % columns * cell[0], GAP + i / columns * cell[1]];
        sheet.paste(&made.bitmap.shrunk(small), left, top);
        frames.push(made.facts);
        let caption = format!("{} S", short(moment.time));
        font::write(
            &mut sheet,
            &caption,
            [left, top + small[1] + GAP],
            scale,
            TEXT,
        );
        progress.drew(i + 1);
    }
    let facts = SheetFacts {
        schema: 1,
        frames,
        output: None,
    };
    Ok((sheet, facts))
}

/// Number of frames in a row.
fn columns(count: u32) -> u32 {
    (1..=count).find(|n| n * n >= count).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_sheets_are_nearly_square() {
        assert_eq!([1, 2, 4, 5, 9, 10].map(columns), [1, 2, 2, 3, 3, 4]);
    }
}
