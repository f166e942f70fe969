//! The sound pass: samples, computed in blocks with 512 samples per row as in the player.

use super::channel::bind;
use super::{Moment, Player};
use shaderlint_exec::{Stop, draw};
use shaderlint_semantic::Pass;

/// Samples per second.
pub const SOUND_RATE: u32 = 44_100;
/// Samples in a row of a block.
const ROW: u32 = 512;
const BLOCK: u32 = ROW * ROW;

impl Player {
    /// `count` stereo samples of the sound pass, starting at `first`; `None` without a sound pass.
    ///
    /// # Errors
    /// Why a draw was stopped.
    pub fn sound(&self, first: u32, count: u32) -> Result<Option<Vec<[f32; 2]>>, Stop> {
        let Some(pass) = self.passes.iter().find(|p| p.kind == Pass::Sound) else {
            return Ok(None);
        };
        let mut samples = Vec::new();
        let end = first.saturating_add(count);
        let mut block = first / BLOCK * BLOCK;
        while block < end {
            let rows = (end - block).div_ceil(ROW).min(ROW);
            let size = [ROW, rows];
            let mut one = pass.shader.draw(size, &Moment::at(0.0));
            let read = pass.channels.iter().map(|c| (c, c.read(self, pass.kind)));
            bind(&mut one, &pass.shader, &read.collect::<Vec<_>>());
            one.set("iTimeOffset", &[f64::from(block) / f64::from(SOUND_RATE)]);
            one.set("iSampleOffset", &[f64::from(block)]);
            let drawn = draw(&one, self.threads)?;
            let texels = drawn.outputs.first().into_iter().flatten();
            let texels = texels.map(|bits| bits.map(byte));
            let from = first.saturating_sub(block) as usize;
            let pixels = texels.take((end - block).min(BLOCK) as usize).skip(from);
            samples.extend(pixels.map(|[left, left_high, right, right_high]| {
                [sample(left, left_high), sample(right, right_high)]
            }));
            block += BLOCK;
        }
        Ok(Some(samples))
    }
}

/// A component of a texel after conversion to 8 bits.
fn byte(bits: u32) -> f32 {
    (f32::from_bits(bits).clamp(0.0, 1.0) * 255.0 + 0.5).floor()
}

fn sample(low: f32, high: f32) -> f32 {
    -1.0 + 2.0 * (low + 256.0 * high) / 65535.0
}
