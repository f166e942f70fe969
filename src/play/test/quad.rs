//! The image that tests run in, and draws of one quad of it.

use shaderlint_exec::{Draw, Sampled, sample};

/// Size of the image that tests run in.
pub const SIZE: [u32; 2] = [1280, 720];

/// A draw of one quad at a time; also returns the index of the pixel in it.
pub fn draw_quad(draw: &Draw<'_>, pixel: [u32; 2]) -> Option<(Sampled, usize)> {
    let sampled = sample(draw, &[pixel.map(|lane| lane & !1)]).ok()?;
    let at = sampled.pixels.iter().position(|p| *p == pixel)?;
    Some((sampled, at))
}
