//! When a picture is drawn, and where the mouse is then.

use shaderlint_host::Feed;
use shaderlint_math::sine;

/// Samples of sound a second, as ShaderToy's player has them.
const SAMPLE_RATE: f64 = 44_100.0;
/// How many frequencies a texture of sound has.
const SIGNAL_WIDTH: f64 = 512.0;
/// How many frames the history of the spectrum has.
const HISTORY_ROWS: f64 = 240.0;

/// A turn, to as many digits as the page has it.
const TURN: f64 = 62_831.0 / 10_000.0;

/// When a picture is drawn, and where the mouse is then.
#[derive(Clone, PartialEq, Debug)]
pub struct Moment {
    /// Seconds since the start.
    pub time: f64,
    /// Number of the frame, from 0.
    pub frame: u32,
    /// Frames a second.
    pub rate: f64,
    /// The mouse, where it has come.
    pub mouse: Option<Mouse>,
    /// Year, month from 0, day, seconds since midnight.
    pub date: [f64; 4],
}

/// The mouse over the picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Mouse {
    /// Where it is, in pixels from the left and from below.
    pub at: [f64; 2],
    /// Its button.
    pub button: Button,
}

/// The mouse's button.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Button {
    /// It was down, where the mouse is now, and is no more.
    Up,
    /// It is held down.
    Down,
}

impl Moment {
    /// Frames a second of a page that is not told otherwise.
    pub const RATE: f64 = 60.0;

    /// The moment of a time, no mouse near.
    pub fn at(time: f64) -> Moment {
        Moment {
            time,
            frame: (time * Moment::RATE).round() as u32,
            rate: Moment::RATE,
            mouse: None,
            // A run gives the same whenever it is made.
            date: [2000.0, 0.0, 1.0, time],
        }
    }

    /// The moment at which a frame is drawn, no mouse near.
    pub fn of_frame(frame: u32) -> Moment {
        Moment {
            frame,
            ..Moment::at(f64::from(frame) / Moment::RATE)
        }
    }

    /// ShaderToy's `iMouse`: where the mouse was last with its button down, and where that was
    /// pressed, by whose signs it is told whether it is down still.
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

    /// What a uniform is given, as many numbers as there are; of a size of the picture. What it is
    /// given by other things than the moment is empty.
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
            Feed::HistorySize => vec![SIGNAL_WIDTH, HISTORY_ROWS],
            Feed::Camera => vec![0.0, 0.0, 1.0],
            Feed::ChannelTime | Feed::ChannelResolution | Feed::TextureSize => Vec::new(),
            Feed::Identity | Feed::Control | Feed::Nothing => Vec::new(),
        }
    }
}

/// How loud low, middle and high sounds are that nobody plays, as the page makes them up.
fn made_up_spectrum(time: f64) -> [f64; 3] {
    let sine = |factor: f64| sine(factor * time);
    let half = (0.5 + 0.5 * sine(TURN)) * (0.5 + 0.5 * sine(TURN));
    let middle = 0.4 + 0.3 * sine(13.0) * sine(1.7);
    [half * half, middle, 0.2 + 0.15 * sine(23.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_signs_of_the_mouse_tell_of_its_button() {
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
    fn frames_and_times_go_together() {
        assert_eq!(Moment::at(2.0).frame, 120);
        assert_eq!(Moment::of_frame(90).time, 1.5);
        let size = Moment::at(0.0).lanes(Feed::ResolutionAndPixel, [200, 100]);
        assert_eq!(size, [200.0, 100.0, 0.005, 0.01]);
    }
}
