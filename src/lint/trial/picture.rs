//! What the pixels of a trial are like.

use super::{Trial, TrialShot};

/// A pixel that was drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SampledPixel {
    /// `gl_FragCoord.xy`, less the half.
    pub at: [u32; 2],
    /// Red, green and blue as the shader gives them.
    pub color: [f32; 3],
}

impl SampledPixel {
    /// Whether all channels hold the same number.
    pub fn is_even(&self) -> bool {
        let [r, g, b] = self.color;
        r == g && g == b
    }

    /// What the screen shows, from 0 to 1; a NaN is black.
    pub fn shown(&self) -> [f32; 3] {
        self.color.map(|lane| {
            if lane.is_nan() {
                0.0
            } else {
                lane.clamp(0.0, 1.0)
            }
        })
    }
}

impl TrialShot {
    /// The pixels that were drawn.
    pub fn drawn(&self) -> impl Iterator<Item = SampledPixel> {
        let all = self.sampled.pixels.iter().zip(&self.colors);
        let drawn = all
            .zip(&self.sampled.covered)
            .filter(|(_, covered)| **covered);
        drawn.map(|((at, color), _)| SampledPixel {
            at: *at,
            color: *color,
        })
    }
}

impl Trial {
    /// Whether every instant that drew anything is like this, and one did.
    pub fn all(&self, mut test: impl FnMut(&TrialShot) -> bool) -> bool {
        let mut drawn = self
            .shots
            .iter()
            .filter(|s| s.drawn().next().is_some())
            .peekable();
        drawn.peek().is_some() && drawn.all(&mut test)
    }

    /// Whether all channels hold the same number everywhere, and not always zero: a number that is
    /// looked at, and no picture.
    pub fn shows_a_number(&self) -> bool {
        let is_lit = |pixel: &SampledPixel| pixel.color != [0.0; 3];
        self.drawn().all(|pixel| pixel.is_even()) && self.drawn().any(|pixel| is_lit(&pixel))
    }

    /// The pixels of all instants that were drawn.
    pub fn drawn(&self) -> impl Iterator<Item = SampledPixel> {
        self.shots.iter().flat_map(TrialShot::drawn)
    }
}

/// How large a share of the pixels is like this.
pub fn share(
    pixels: impl Iterator<Item = SampledPixel>,
    mut test: impl FnMut(&SampledPixel) -> bool,
) -> f64 {
    let (mut all, mut like) = (0_u32, 0_u32);
    for pixel in pixels {
        all += 1;
        like += u32::from(test(&pixel));
    }
    f64::from(like) / f64::from(all.max(1))
}

/// How bright a colour on the screen looks, from 0 to 1 (weights of Rec. 709).
pub fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// What rounding may add to white.
const WHITE: f32 = 1.02;

/// Whether every channel is past what the screen shows.
pub fn is_too_bright(pixel: &SampledPixel) -> bool {
    pixel.color.iter().all(|lane| *lane > WHITE)
}
