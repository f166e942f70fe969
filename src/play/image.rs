//! The image of a draw, and its statistics.

use shaderlint_exec::{Bytecode, Drawn};
use shaderlint_semantic::Scalar;

/// An image, bottom row first.
#[derive(Clone, PartialEq, Debug)]
pub struct RenderedImage {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// By pixel: red, green, blue and alpha as written by the shader.
    pub pixels: Vec<[f32; 4]>,
}

/// Statistics of an image.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct ImageFacts {
    /// Average of each channel over finite values.
    pub mean: [f64; 3],
    /// Minimum of each channel.
    pub least: [f64; 3],
    /// Maximum of each channel.
    pub most: [f64; 3],
    /// Number of pixels that are black after rounding to 8 bits.
    pub black: u64,
    /// Number of pixels with a NaN in red, green or blue.
    pub nan: u64,
    /// Number of pixels with an infinity and no NaN there.
    pub infinite: u64,
    /// Number of discarded pixels.
    pub discarded: u64,
    /// Number of distinct colours after rounding to 8 bits, counted up to 65,536.
    pub colors: u32,
}

/// Maximum number of colours counted.
const MAX_COLORS: u32 = 1 << 16;

/// Counts distinct colours.
#[derive(Default)]
struct Colors {
    /// By colour: a bit that is set if it was counted. Empty before the first colour.
    counted: Vec<u64>,
    count: u32,
    last: [u8; 3],
}

impl Colors {
    fn add(&mut self, color @ [r, g, b]: [u8; 3]) {
        if self.counted.is_empty() {
            self.counted = vec![0; 1 << 18];
        } else if color == self.last || self.count == MAX_COLORS {
            return;
        }
        self.last = color;
        let number = u32::from_be_bytes([0, r, g, b]);
        if let Some(word) = self.counted.get_mut(number as usize / 64) {
            let bit = 1 << (number % 64);
            self.count += u32::from(*word & bit == 0);
            *word |= bit;
        }
    }
}

/// Converts a value to a byte, rounded as in a framebuffer; NaN becomes 0.
fn byte(number: f32) -> u8 {
    (number.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

impl RenderedImage {
    /// The image of an output of a draw. Discarded pixels are black.
    pub fn of(code: &Bytecode, drawn: &Drawn, output: usize) -> RenderedImage {
        let mut pixels = Vec::new();
        if let (Some(slot), Some(bits)) = (code.outputs.get(output), drawn.outputs.get(output)) {
            let lanes = slot.lanes();
            let scalar = slot.ty.scalar_kind();
            let is_plain = lanes == 4 && scalar.is_none_or(|scalar| scalar == Scalar::Float);
            let all = bits.iter().zip(&drawn.covered);
            pixels.extend(all.map(|(bits, is_covered)| {
                if is_plain && *is_covered {
                    return bits.map(f32::from_bits);
                }
                let mut pixel = [0.0, 0.0, 0.0, 1.0];
                for (lane, bits) in pixel.iter_mut().zip(bits).take(lanes) {
                    *lane = if *is_covered { slot.number(*bits) } else { 0.0 };
                }
                pixel
            }));
        }
        RenderedImage {
            size: drawn.size,
            pixels,
        }
    }

    /// The 8-bit colour of a pixel, without alpha.
    pub fn shown([r, g, b, _]: [f32; 4]) -> [u8; 3] {
        [r, g, b].map(byte)
    }

    /// The 8-bit image, top row first, three bytes per pixel.
    pub fn bytes(&self) -> Vec<u8> {
        let width = self.size[0].max(1) as usize;
        let mut bytes = Vec::with_capacity(3 * self.pixels.len());
        for row in self.pixels.chunks_exact(width).rev() {
            for pixel in row {
                bytes.extend_from_slice(&RenderedImage::shown(*pixel));
            }
        }
        bytes
    }

    /// The statistics of the image; `covered` says which pixels were not discarded.
    pub fn facts(&self, covered: &[bool]) -> ImageFacts {
        let mut facts = ImageFacts::default();
        let mut counts = [0_u64; 3];
        let mut colors = Colors::default();
        facts.least = [f64::INFINITY; 3];
        facts.most = [f64::NEG_INFINITY; 3];
        for (pixel, is_covered) in self.pixels.iter().zip(covered) {
            let [r, g, b, _] = *pixel;
            let shown = RenderedImage::shown(*pixel);
            colors.add(shown);
            facts.black += u64::from(shown == [0; 3]);
            facts.discarded += u64::from(!is_covered);
            let has_nan = [r, g, b].iter().any(|n| n.is_nan());
            facts.nan += u64::from(has_nan);
            facts.infinite += u64::from(!has_nan && [r, g, b].iter().any(|n| n.is_infinite()));
            let sums = facts.mean.iter_mut().zip(&mut counts);
            let ends = facts.least.iter_mut().zip(&mut facts.most);
            for ((lane, (sum, count)), (least, most)) in [r, g, b].iter().zip(sums).zip(ends) {
                if lane.is_finite() {
                    let lane = f64::from(*lane);
                    *sum += lane;
                    *count += 1;
                    *least = least.min(lane);
                    *most = most.max(lane);
                }
            }
        }
        for (channel, count) in counts.iter().enumerate() {
            if let (Some(sum), true) = (facts.mean.get_mut(channel), *count > 0) {
                *sum /= *count as f64;
            }
        }
        for (least, most) in facts.least.iter_mut().zip(&mut facts.most) {
            if least > most {
                (*least, *most) = (0.0, 0.0);
            }
        }
        facts.colors = colors.count;
        facts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_flipped_and_values_are_rounded() {
        let image = RenderedImage {
            size: [1, 2],
            pixels: vec![[0.5, 2.0, -1.0, 1.0], [f32::NAN, f32::INFINITY, 0.0, 0.0]],
        };
        assert_eq!(image.bytes(), [0, 255, 0, 128, 255, 0]);
        let facts = image.facts(&[true, true]);
        assert_eq!((facts.nan, facts.infinite, facts.black), (1, 0, 0));
        assert_eq!(facts.mean, [0.5, 2.0, -0.5]);
        assert_eq!(facts.least, [0.5, 2.0, -1.0]);
        assert_eq!(facts.colors, 2);
    }
}
