//! The picture that a test is run in, and one quad of it.

use shaderlint_exec::{Draw, Sampled, sample};

/// The picture that tests are run in.
pub const SIZE: [u32; 2] = [1280, 720];

/// A draw of one quad, at a moment; the index of a pixel in it.
pub fn draw_quad(draw: &Draw<'_>, pixel: [u32; 2]) -> Option<(Sampled, usize)> {
    let sampled = sample(draw, &[pixel.map(|lane| lane & !1)]).ok()?;
    let at = sampled.pixels.iter().position(|p| *p == pixel)?;
    Some((sampled, at))
}
