//! Contact sheets: frames of several times next to each other.

use super::bitmap::Bitmap;
use super::facts::SheetFacts;
use super::font;
use super::frame::frame;
use super::request::RunRequest;
use super::setting::RunProgress;
use super::shot::{Loaded, Shot};
use shaderlint_engine::inputs::Moment;
use shaderlint_text::number::short;

/// Distance between two frames in pixels.
const GAP: u32 = 4;
const GROUND: [u8; 3] = [16; 3];
const TEXT: [u8; 3] = [220; 3];

/// Draws a contact sheet of `count` frames. Each is drawn in full size and scaled down, because the
/// shader may depend on the size of a pixel.
pub fn draw(
    request: &RunRequest,
    (loaded, shot): (&Loaded, &mut Shot),
    count: u32,
    progress: &mut dyn FnMut(RunProgress),
) -> Result<(Bitmap, SheetFacts), String> {
    let columns = columns(count);
    let small = shot.size.map(|side| (side / columns).max(1));
    let scale = (small[0] / 80).clamp(1, 4);
    let label = font::HEIGHT * scale + 2 * GAP;
    let rows = count.div_ceil(columns);
    let cell = [small[0] + GAP, small[1] + label];
    let size = [columns * cell[0] + GAP, rows * cell[1] + GAP];
    let mut sheet = Bitmap::filled(size, GROUND);
    let first = request.moment();
    let every = request.every.unwrap_or(1.0);
    let mut frames = Vec::new();
    for i in 0..count {
        let moment = Moment {
            mouse: first.mouse,
            ..Moment::at(first.time + f64::from(i) * every)
        };
        let mut report = |number| {
            progress(RunProgress {
                images: [i, count].map(|n| n as usize),
                frames: [number, moment.frame],
            });
        };
        let made = frame(loaded, shot, &moment, request.view(), &mut report)?;
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
