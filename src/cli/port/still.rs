//! Draws the still image of a page, without a GPU and within a budget.
//!
//! The budget counts operations, so that the same shader gives the same image on every machine. Each
//! image is drawn only if a smaller one showed that it is within the budget.

use crate::cli::image_file::decode;
use crate::commands::run::Bitmap;
use crate::engine::inputs::Moment;
use crate::exec::{CompileOptions, Drawn};
use crate::play::{PlaybackOptions, Played, Player, RenderedImage};
use crate::port::Still;
use crate::project::{Composed, Project};
use std::collections::HashSet;

/// The sizes of the image: the largest within the budget and the file size.
const SIZES: [[u32; 2]; 3] = [[640, 360], [480, 270], [320, 180]];
/// The sizes of the images that are drawn first, to count operations.
const SAMPLES: [[u32; 2]; 2] = [[16, 9], [64, 36]];
/// Operations of all pixels and frames of an image: some seconds on two cores.
const BUDGET: f64 = 2.4e10;
/// Largest file in bytes. Images full of noise are made smaller, because the page contains them.
const MAX_FILE: usize = 256 * 1024;
/// The moments of a shader that does not depend on previous frames, in seconds: the first at which
/// the image is more than one colour. Many shaders start black.
const TIMES: [f64; 3] = [2.0, 5.0, 10.0];
/// The number of frames of other shaders; the second if the first exceeds the budget.
const FRAMES: [u32; 2] = [60, 5];
/// Fewer colours than this in a small image are almost one colour.
const FEW_COLORS: usize = 16;

/// The still image, or why there is none.
pub(super) fn still(project: &Project, composed: &Composed) -> Result<Still, String> {
    if composed.has_errors() {
        return Err("the shader has errors".to_string());
    }
    let [frames, few] = FRAMES;
    let remembers = player(project, composed, [1, 1])?.remembers();
    match draw_still(project, composed, frames) {
        Err(_) if remembers => draw_still(project, composed, few),
        drawn => drawn,
    }
}

/// The still image of a shader, after some frames if it depends on them.
fn draw_still(project: &Project, composed: &Composed, frames: u32) -> Result<Still, String> {
    let mut cost = StillCost::default();
    let mut best: Option<(usize, f64)> = None;
    for (i, size) in SAMPLES.into_iter().enumerate() {
        let is_last = i + 1 == SAMPLES.len();
        let times = if is_last { &TIMES[..] } else { &TIMES[..1] };
        for time in times {
            cost.check(size)?;
            let frame = play(player(project, composed, size)?, size, (*time, frames))?;
            cost = frame.cost;
            let count = colors(&frame.image);
            if best.is_none_or(|(most, _)| count > most) {
                best = Some((count, *time));
            }
            if count >= FEW_COLORS || frame.remembers {
                break;
            }
        }
    }
    let time = best.map_or(0.0, |(_, time)| time);
    let fitting = SIZES.into_iter().find(|size| cost.check(*size).is_ok());
    let [.., least] = SIZES;
    let size = fitting.unwrap_or(least);
    cost.check(size)?;
    let image = play(player(project, composed, size)?, size, (time, frames))?.image;
    encoded(&Bitmap::of(&image))
}

/// The file of an image, which is made smaller until the file is small enough.
fn encoded(image: &Bitmap) -> Result<Still, String> {
    let png = image.png()?;
    let smaller = SIZES.into_iter().find(|size| *size < image.size);
    match smaller {
        Some(size) if png.len() > MAX_FILE => encoded(&image.shrunk(size)),
        _ => Ok(Still {
            size: image.size,
            png,
        }),
    }
}

/// The number of colours of an image.
fn colors(image: &RenderedImage) -> usize {
    let bytes = image.bytes();
    let (pixels, _) = bytes.as_chunks::<3>();
    pixels.iter().collect::<HashSet<_>>().len()
}

/// An image, and what it took.
struct StillFrame {
    image: RenderedImage,
    cost: StillCost,
    /// Whether it depends on previous frames, which were drawn as well.
    remembers: bool,
}

/// The operations of an image.
#[derive(Clone, Copy, Default)]
struct StillCost {
    /// Per pixel of the image.
    per_pixel: f64,
    /// Of passes whose size does not depend on the image.
    fixed: f64,
}

impl StillCost {
    /// Adds a frame of this size.
    fn add(&mut self, played: &Played, size: [u32; 2]) {
        for (_, drawn) in &played.passes {
            let cost: f64 = drawn.ran.iter().copied().map(f64::from).sum();
            match drawn.size == size {
                true => self.per_pixel += cost / area(size),
                // The faces of a cube map, of which only the last is known.
                false if is_face(drawn) => self.fixed += 6.0 * cost,
                false => self.fixed += cost,
            }
        }
    }

    /// Refuses a size at which the image exceeds the budget.
    fn check(&self, size: [u32; 2]) -> Result<(), String> {
        let cost = self.per_pixel * area(size) + self.fixed;
        match cost <= BUDGET {
            true => Ok(()),
            false => Err(format!(
                "it needs more than {:.0} billion operations",
                BUDGET / 1e9
            )),
        }
    }
}

fn area([width, height]: [u32; 2]) -> f64 {
    f64::from(width) * f64::from(height)
}

fn is_face(drawn: &Drawn) -> bool {
    let [width, height] = drawn.size;
    width == height
}

/// What draws the image at a size.
fn player(project: &Project, composed: &Composed, size: [u32; 2]) -> Result<Player, String> {
    let options = PlaybackOptions {
        size,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        observed: None,
        compile: CompileOptions {
            cost: true,
            ..CompileOptions::default()
        },
        decode: Some(decode),
    };
    Player::new(project, composed, &options).map_err(|e| e.to_string())
}

/// Draws the image at a time, or after some frames if it depends on them.
fn play(
    mut player: Player,
    size: [u32; 2],
    (time, frames): (f64, u32),
) -> Result<StillFrame, String> {
    let remembers = player.remembers();
    let moments: Vec<Moment> = match remembers {
        true => (0..=frames).map(Moment::of_frame).collect(),
        false => vec![Moment::at(time)],
    };
    let mut cost = StillCost::default();
    let mut image = None;
    for moment in &moments {
        let stopped = |_| "some pixels need too many operations".to_string();
        let played = player.frame(moment).map_err(stopped)?;
        cost.add(&played, size);
        cost.check(size)?;
        image = Some(played.image);
    }
    let image = image.ok_or("the shader has no image")?;
    Ok(StillFrame {
        image,
        cost,
        remembers,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cost_of_a_still_image_grows_with_its_pixels() {
        let cost = StillCost {
            per_pixel: 3.9e5,
            fixed: 1e9,
        };
        let why = "it needs more than 24 billion operations".to_string();
        assert_eq!(cost.check([320, 180]), Ok(()));
        assert_eq!(cost.check([480, 270]), Err(why));
    }
}
