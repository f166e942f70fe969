//! Synthetic audio textures, as the player computes them without audio: a spectrum and a wave.

use shaderlint_exec::{Image, ImageShape, Texels};
use shaderlint_math::sine;
use shaderlint_project::{Input, SignalForm};
use std::sync::Arc;

/// Number of frequencies, and of wave samples, in an audio texture.
const WIDTH: usize = 512;
/// Number of values that are computed.
const COUNT: usize = 1024;
/// Number of frames in the history of the spectrum.
const HISTORY_ROWS: usize = 240;

/// 2 pi, with the digits that the player uses.
const PAGE_TAU: f64 = 62_831.0 / 10_000.0;

/// Audio of a channel.
pub(super) struct Signal {
    form: SignalForm,
    /// The rows of the history, or the sums.
    kept: Vec<[f32; WIDTH]>,
    last: f64,
    image: Option<Arc<Image>>,
}

impl Signal {
    pub fn new(input: &Input) -> Signal {
        Signal {
            form: input.signal,
            kept: Vec::new(),
            last: 0.0,
            image: None,
        }
    }

    pub fn image(&self) -> Option<Arc<Image>> {
        self.image.clone()
    }

    /// The playback time that the player sets without audio.
    pub fn time(&self) -> f64 {
        10.0 + self.last
    }

    /// Whether it depends on previous frames.
    pub fn remembers(&self) -> bool {
        matches!(self.form, SignalForm::History | SignalForm::Sum)
    }

    pub fn update(&mut self, time: f64, has_levels: bool) {
        let seconds = (time - self.last).max(0.0);
        self.last = time;
        let gray = |line: &[u8; WIDTH]| line.iter().map(|v| [*v, *v, *v, 255]).collect();
        let texels = match self.form {
            SignalForm::Both => {
                let lines = [spectrum(time), wave(time)];
                let red = lines.as_flattened().iter().map(|v| [*v, 0, 0, 255]);
                Texels::Unorm8(red.collect())
            }
            SignalForm::Spectrum => Texels::Unorm8(gray(&spectrum(time))),
            SignalForm::Wave => Texels::Unorm8(gray(&wave(time))),
            SignalForm::History => {
                self.kept.insert(0, spectrum(time).map(f32::from));
                self.kept.resize(HISTORY_ROWS, [0.0; WIDTH]);
                let all = self.kept.as_flattened().iter();
                Texels::Unorm8(all.map(|v| [*v as u8; 4]).collect())
            }
            SignalForm::Sum => {
                self.kept.resize(1, [0.0; WIDTH]);
                let sums = self.kept.iter_mut().flatten().zip(spectrum(time));
                let sums = sums.map(|(sum, v)| {
                    *sum += (seconds * (f64::from(v) / 255.0)) as f32;
                    [*sum, *sum, *sum, 0.0]
                });
                Texels::Float(sums.collect())
            }
        };
        let rows = (texels.count() / WIDTH) as u32;
        let image = Image::new(ImageShape::Flat, [WIDTH as u32, rows, 1], texels).ok();
        let image = image.map(|i| if has_levels { i.with_levels() } else { i });
        self.image = image.map(Arc::new);
    }
}

fn byte(part: f64) -> u8 {
    (255.0 * part).floor() as u8
}

fn spectrum(time: f64) -> [u8; WIDTH] {
    // The factor of number j is exp(-3 j / 1024), so that consecutive factors have a constant
    // ratio.
    const SHARE: f64 = 0.997_074_599_846_54;
    const _: () = assert!(COUNT == 1024);
    let mut values = [0; WIDTH];
    let mut fade = 1.0;
    for (value, j) in values.iter_mut().zip(0_u32..) {
        let j = f64::from(j);
        let mut part = (0.75 + 0.25 * sine(10.0 * j + 13.0 * time)) * fade;
        if j < 3.0 {
            let beat = 0.5 + 0.5 * sine(PAGE_TAU * time);
            part = beat * beat * beat * beat * (1.0 - j / 3.0);
        }
        *value = byte(part);
        fade *= SHARE;
    }
    values
}

fn wave(time: f64) -> [u8; WIDTH] {
    let mut values = [0; WIDTH];
    for (value, j) in values.iter_mut().zip(0_u32..) {
        let x = f64::from(j) / COUNT as f64;
        let part = sine(17.0 * time + 62.831 * x) * sine(23.0 * time + 1.9 * x);
        *value = byte(0.5 + 0.15 * part);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectrum_decays_exponentially() {
        let share = (-3.0_f64 / COUNT as f64).exp();
        assert!((spectrum(0.7)[400] as f64 / 255.0 - share.powi(400)).abs() < 0.26);
        assert!((share - 0.997_074_599_846_54).abs() < 1e-15);
    }
}
