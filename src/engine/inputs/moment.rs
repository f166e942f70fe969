//! Time, frame number and mouse of a frame.

use shaderlint_host::Feed;
use shaderlint_math::sine;

/// Audio samples per second, as in ShaderToy's player.
const SAMPLE_RATE: f64 = 44_100.0;
/// Number of frequencies in an audio texture.
const SIGNAL_WIDTH: f64 = 512.0;
/// Number of frames in the history of the spectrum.
const HISTORY_ROWS: f64 = 240.0;

/// 2 pi, with the digits that the player uses.
const PAGE_TAU: f64 = 62_831.0 / 10_000.0;

/// Time, frame number and mouse of a frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Moment {
    /// Time in seconds since the start.
    pub time: f64,
    /// Frame number, from 0.
    pub frame: u32,
    /// Frames per second.
    pub rate: f64,
    /// The mouse, if it was pressed.
    pub mouse: Option<Mouse>,
    /// Year, month from 0, day, seconds since midnight.
    pub date: [f64; 4],
}

/// State of the mouse.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Mouse {
    /// Last position with the button down, in pixels from the lower left corner.
    pub at: [f64; 2],
    /// State of the button.
    pub button: Button,
}

/// State of the mouse button.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Button {
    /// Released.
    Up,
    /// Held down.
    Down,
}

impl Moment {
    /// Default frame rate.
    pub const RATE: f64 = 60.0;

    /// The frame at a time, without mouse.
    pub fn at(time: f64) -> Moment {
        Moment {
            time,
            frame: (time * Moment::RATE).round() as u32,
            rate: Moment::RATE,
            mouse: None,
            // A fixed date, so that runs are reproducible.
            date: [2000.0, 0.0, 1.0, time],
        }
    }

    /// The frame with a number, without mouse.
    pub fn of_frame(frame: u32) -> Moment {
        Moment {
            frame,
            ..Moment::at(f64::from(frame) / Moment::RATE)
        }
    }

    /// The frame at a time, with a number, or both; the first one if neither is given.
    pub fn given(time: Option<f64>, frame: Option<u32>, mouse: Option<Mouse>) -> Moment {
        let moment = match (time, frame) {
            (Some(time), None) => Moment::at(time),
            (None, frame) => Moment::of_frame(frame.unwrap_or(0)),
            (Some(time), Some(frame)) => Moment {
                frame,
                ..Moment::at(time)
            },
        };
        Moment { mouse, ..moment }
    }

    /// ShaderToy's `iMouse`: the last position with the button down, and the position of the click;
    /// its signs encode the state of the button.
    pub fn shadertoy_mouse(&self) -> [f64; 4] {
        match self.mouse {
            None => [0.0, 0.0, -0.0, -0.0],
            Some(Mouse { at: [x, y], button }) => {
                let (x, y) = (x.floor(), y.floor());
                match button {
                    Button::Up => [x, y, -x, -y],
                    Button::Down => [x, y, x, -y],
                }
            }
        }
    }

    /// The components of a uniform, for an image size. Empty if other data determines its value.
    pub fn lanes(&self, feed: Feed, size: [u32; 2]) -> Vec<f64> {
        let [w, h] = size.map(f64::from);
        let share = self.mouse.map(|m| [m.at[0] / w, m.at[1] / h]);
        let is_down = self.mouse.is_some_and(|m| m.button == Button::Down);
        let down = f64::from(u8::from(is_down));
        match feed {
            Feed::Time => vec![self.time],
            Feed::Milliseconds => vec![self.time * 1000.0],
            Feed::Delta => vec![1.0 / self.rate],
            Feed::Frame => vec![f64::from(self.frame)],
            Feed::FrameFromOne => vec![f64::from(self.frame) + 1.0],
            Feed::FrameRate => vec![self.rate],
            Feed::SampleRate => vec![SAMPLE_RATE],
            Feed::Date => self.date.to_vec(),
            Feed::DateFromOne => {
                let [year, month, day, seconds] = self.date;
                vec![year, month + 1.0, day, seconds]
            }
            Feed::Resolution => vec![w, h, 1.0, 1.0],
            Feed::ResolutionAndPixel => vec![w, h, 1.0 / w, 1.0 / h],
            Feed::Pixel => vec![1.0 / w, 1.0 / h],
            Feed::Aspect => vec![w / h],
            Feed::PixelRatio => vec![1.0],
            Feed::SurfaceSize => vec![w / h, 1.0],
            Feed::Mouse => self.shadertoy_mouse().to_vec(),
            Feed::Pointer => {
                let [x, y] = self.mouse.map_or([0.0; 2], |m| m.at);
                vec![x, y, down, 0.0]
            }
            Feed::PointerUnit => share.unwrap_or([0.5; 2]).to_vec(),
            Feed::PointerUnitDown => share.map_or(vec![0.5; 2], |[x, y]| vec![x, 1.0 - y]),
            Feed::PointerUnitZero => share.unwrap_or([0.0; 2]).to_vec(),
            Feed::PointerSigned => share.map_or(vec![0.0; 2], |p| {
                p.iter().map(|lane| 2.0 * lane - 1.0).collect()
            }),
            Feed::Button => vec![down],
            Feed::Spectrum => made_up_spectrum(self.time).to_vec(),
            Feed::Volume => made_up_spectrum(self.time).into_iter().take(1).collect(),
            Feed::VolumeBytes => made_up_spectrum(self.time)
                .into_iter()
                .take(1)
                .map(|level| 255.0 * level)
                .collect(),
            Feed::HistorySize => vec![SIGNAL_WIDTH, HISTORY_ROWS],
            Feed::Camera => vec![0.0, 0.0, 1.0],
            Feed::Width => vec![w],
            Feed::Height => vec![h],
            Feed::Progress => vec![(self.time % CURSOR_STEP).min(1.0)],
            Feed::Cursor => text_cursor(self.time, [w, h]).to_vec(),
            Feed::CursorBefore => text_cursor(self.time - CURSOR_STEP, [w, h]).to_vec(),
            Feed::CursorTime => vec![(self.time / CURSOR_STEP).floor() * CURSOR_STEP],
            Feed::CursorColor => vec![1.0, 0.6, 0.2, 1.0],
            Feed::Ones => vec![1.0; 4],
            Feed::ChannelTime | Feed::ChannelResolution | Feed::TextureSize => Vec::new(),
            Feed::Identity | Feed::Control | Feed::Nothing => Vec::new(),
        }
    }
}

/// Seconds between two moves of the text cursor, and from one animation to the next.
const CURSOR_STEP: f64 = 1.5;

/// The text cursor at a time: its left and upper edge, width and height. It visits the cells of a
/// grid of 48 columns and 16 rows.
fn text_cursor(time: f64, [w, h]: [f64; 2]) -> [f64; 4] {
    let step = (time / CURSOR_STEP).floor() + 1.0;
    let (column, row) = ((step * 19.0) % 48.0, (step * 5.0) % 16.0);
    let (width, height) = (w / 48.0, h / 16.0);
    [column * width, h - row * height, width, height]
}

/// The synthetic levels of low, middle and high frequencies, as the page computes them without
/// audio.
fn made_up_spectrum(time: f64) -> [f64; 3] {
    let sine = |factor: f64| sine(factor * time);
    let half = (0.5 + 0.5 * sine(PAGE_TAU)) * (0.5 + 0.5 * sine(PAGE_TAU));
    let middle = 0.4 + 0.3 * sine(13.0) * sine(1.7);
    [half * half, middle, 0.2 + 0.15 * sine(23.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_of_the_mouse_position_shows_its_button() {
        let moment = |button| Moment {
            mouse: Some(Mouse {
                at: [10.5, 20.0],
                button,
            }),
            ..Moment::at(1.0)
        };
        let down = moment(Button::Down);
        assert_eq!(down.shadertoy_mouse(), [10.0, 20.0, 10.0, -20.0]);
        assert_eq!(down.lanes(Feed::PointerUnitDown, [21, 40]), [0.5, 0.5]);
        let up = moment(Button::Up).shadertoy_mouse();
        assert_eq!(up, [10.0, 20.0, -10.0, -20.0]);
        let away = Moment::at(0.0).shadertoy_mouse();
        assert!(away[2].is_sign_negative() && away[2] == 0.0);
    }

    #[test]
    fn times_and_frames_convert_into_each_other() {
        assert_eq!(Moment::at(2.0).frame, 120);
        assert_eq!(Moment::of_frame(90).time, 1.5);
        let size = Moment::at(0.0).lanes(Feed::ResolutionAndPixel, [200, 100]);
        assert_eq!(size, [200.0, 100.0, 0.005, 0.01]);
    }
}
