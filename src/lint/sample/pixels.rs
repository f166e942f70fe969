//! Colours of sampled pixels.

use super::{Instant, Round, SampleFrame, SampleRun};
use crate::facts::Facts;

/// A sampled pixel that was not discarded.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SampledPixel {
    /// `gl_FragCoord.xy - 0.5`.
    pub at: [u32; 2],
    /// Red, green and blue as the shader writes them.
    pub color: [f32; 3],
}

impl SampledPixel {
    /// Whether all channels are equal.
    pub fn is_even(&self) -> bool {
        let [r, g, b] = self.color;
        r == g && g == b
    }

    /// The displayed colour, from 0 to 1; NaN counts as 0.
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

impl SampleFrame {
    /// The sampled quads, by their lower left pixels.
    pub fn quads(&self) -> Vec<[u32; 2]> {
        let quads = self.sampled.pixels.chunks(4);
        quads.filter_map(|quad| quad.first().copied()).collect()
    }

    /// The pixels that were not discarded.
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

impl Facts<'_> {
    /// Whether the first pixels change in time.
    pub fn changes_later(&self) -> Option<bool> {
        let first = self.round(Round::First)?.frames.first()?;
        let (bench, supplier) = self.bench()?;
        let later = Instant::at(first.instant.time + 1.7);
        let after = bench.sample(bench.watched(), supplier, &later, &first.quads())?;
        let before = &first.sampled;
        Some(before.outputs != after.outputs || before.covered != after.covered)
    }
}

impl SampleRun {
    /// Whether the test holds for every instant with drawn pixels, and there is one.
    pub fn all(&self, mut test: impl FnMut(&SampleFrame) -> bool) -> bool {
        let mut drawn = self
            .frames
            .iter()
            .filter(|s| s.drawn().next().is_some())
            .peekable();
        drawn.peek().is_some() && drawn.all(&mut test)
    }

    /// Whether all channels are equal everywhere, and not always zero: the output is a visualised number,
    /// not an image.
    pub fn shows_a_number(&self) -> bool {
        let is_lit = |pixel: &SampledPixel| pixel.color != [0.0; 3];
        self.drawn().all(|pixel| pixel.is_even()) && self.drawn().any(|pixel| is_lit(&pixel))
    }

    /// The drawn pixels of all instants.
    pub fn drawn(&self) -> impl Iterator<Item = SampledPixel> {
        self.frames.iter().flat_map(SampleFrame::drawn)
    }
}

/// The share of pixels for which the test holds, from 0 to 1.
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

/// Luminance of a displayed colour, from 0 to 1 (weights of Rec. 709).
pub fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// White, with a tolerance for rounding.
const WHITE: f32 = 1.02;

/// Whether every channel is brighter than white.
pub fn is_too_bright(pixel: &SampledPixel) -> bool {
    pixel.color.iter().all(|lane| *lane > WHITE)
}
