//! Compares two shaders bit for bit in the same frames.

use super::bitmap::Bitmap;
use super::facts::{self, MouseFacts};
use super::heat;
use super::shot::Shot;
use serde::Serialize;
use shaderlint_engine::inputs::{Button, Moment, Mouse};
use shaderlint_exec::{Bytecode, Drawn};
use shaderlint_play::RenderedImage;
use shaderlint_text::number::{percent, seconds, short};

/// Times in seconds that are compared by default.
const TIMES: [f64; 4] = [0.0, 1.0, 5.0, 20.0];

/// The result of a comparison.
#[derive(Serialize)]
pub struct Compared {
    schema: u32,
    file: String,
    other: String,
    size: [u32; 2],
    /// Whether all outputs are identical.
    pub same: bool,
    moments: Vec<MomentCompared>,
    /// Path of the image that was written.
    pub output: Option<String>,
}

#[derive(Default, Serialize)]
struct MomentCompared {
    time: f64,
    frame: u32,
    mouse: Option<MouseFacts>,
    /// Number of pixels that differ in any bit of any output.
    pixels: u64,
    /// Number of pixels that differ after rounding to 8 bits.
    shown: u64,
    /// Largest difference of a colour channel.
    most: f64,
    /// First pixel that differs, from the lower left corner.
    first: Option<[u32; 2]>,
}

/// The comparison of one frame, pixel by pixel.
struct ComparedImages {
    compared: MomentCompared,
    /// By pixel: the largest difference of a channel; a tiny value if only bits differ that are not
    /// shown.
    by_pixel: Vec<f64>,
}

/// Compares two shaders in some frames. Returns the result and an image of the frame that differs the
/// most. `progress` is called before each frame that is drawn, with the number of the pair and of the frame.
///
/// # Errors
/// A message about a run that was stopped.
pub fn compare(
    mut shots: [&mut Shot; 2],
    names: [&str; 2],
    size: [u32; 2],
    moments: &[Moment],
    progress: &mut dyn FnMut(usize, u32),
) -> Result<(Compared, Option<Bitmap>), String> {
    let mut compared = Vec::new();
    let mut worst: Option<(u64, Vec<f64>)> = None;
    for (number, moment) in moments.iter().enumerate() {
        let drawn = shots.each_mut().map(|shot| {
            let mut report_frame = |frame| progress(number, frame);
            shot.drawn(moment, &mut report_frame)
        });
        let [a, b] = drawn;
        let found = difference([&a?, &b?], shots.each_ref().map(|shot| shot.code()), moment);
        let pixels = found.compared.pixels;
        if pixels > 0 && worst.as_ref().is_none_or(|(most, _)| pixels > *most) {
            worst = Some((pixels, found.by_pixel));
        }
        compared.push(found.compared);
    }
    let image = worst.map(|(_, values)| heat::map(size, &values, "DIFFERENCE"));
    let compared = Compared {
        schema: 1,
        file: names[0].to_string(),
        other: names[1].to_string(),
        size,
        same: compared.iter().all(|moment| moment.pixels == 0),
        moments: compared,
        output: None,
    };
    Ok((compared, image))
}

/// The frames that are compared by default: several, with this mouse, or with and without one.
pub fn compared_moments(size: [u32; 2], mouse: Option<Mouse>) -> Vec<Moment> {
    let [width, height] = size.map(f64::from);
    let dragged = Mouse {
        at: [width * 0.3, height * 0.7],
        button: Button::Down,
    };
    let mice = match mouse {
        None => vec![None, Some(dragged)],
        mouse => vec![mouse],
    };
    let all = TIMES
        .iter()
        .flat_map(|time| mice.iter().map(move |mouse| (time, mouse)));
    all.map(|(time, mouse)| Moment {
        mouse: *mouse,
        ..Moment::at(*time)
    })
    .collect()
}

fn difference(drawn: [&Drawn; 2], codes: [&Bytecode; 2], moment: &Moment) -> ComparedImages {
    let [a, b] = drawn;
    let [code, other] = codes;
    let images = [(code, a), (other, b)].map(|(code, drawn)| RenderedImage::of(code, drawn, 0));
    let mut by_pixel = Vec::with_capacity(a.covered.len());
    let mut compared = MomentCompared {
        time: moment.time,
        frame: moment.frame,
        mouse: facts::mouse(moment),
        ..MomentCompared::default()
    };
    let width = a.size[0].max(1);
    let [left, right] = images.each_ref().map(|p| p.pixels.as_slice());
    for ((one, two), at) in left.iter().zip(right).zip(0_usize..) {
        let covered = a.covered.get(at) == b.covered.get(at);
        let outputs = a.outputs.len() == b.outputs.len()
            && a.outputs
                .iter()
                .zip(&b.outputs)
                .all(|(a, b)| a.get(at) == b.get(at));
        if covered && outputs {
            by_pixel.push(0.0);
            continue;
        }
        let lanes = one.iter().zip(two).take(3);
        let gaps = lanes.map(|(a, b)| f64::from((a - b).abs()));
        let gap = gaps.fold(0.0, |most, gap| match gap.is_finite() {
            true => gap.max(most),
            false => f64::from(u8::from(one.map(f32::to_bits) != two.map(f32::to_bits))).max(most),
        });
        compared.pixels += 1;
        compared.shown += u64::from(RenderedImage::shown(*one) != RenderedImage::shown(*two));
        compared.most = gap.max(compared.most);
        let place = || [at as u32 % width, at as u32 / width];
        compared.first.get_or_insert_with(place);
        by_pixel.push(gap.max(f64::from(f32::MIN_POSITIVE)));
    }
    ComparedImages { compared, by_pixel }
}

impl Compared {
    /// The text for people.
    pub fn text(&self) -> String {
        let [width, height] = self.size;
        let pixels = u64::from(width) * u64::from(height);
        let moments = self.moments.len();
        let (file, other) = (&self.file, &self.other);
        let seen = format!("{} pixels in {moments} frames", pixels * moments as u64);
        if self.same {
            return format!("{file} and {other} are identical: compared {seen}\n");
        }
        let mut text = format!("{file} and {other} differ: compared {seen}\n");
        for moment in self.moments.iter().filter(|m| m.pixels > 0) {
            let share = percent(moment.pixels as f64 / pixels.max(1) as f64);
            let [x, y] = moment.first.unwrap_or_default();
            let mouse = match &moment.mouse {
                Some(_) => ", mouse down",
                None => "",
            };
            text.push_str(&format!(
                "  at {}{mouse}: {} pixels ({share}), {} of them after rounding to 8 bits; largest \
                 difference {}, first at ({x}, {y})\n",
                seconds(moment.time),
                moment.pixels,
                moment.shown,
                short(moment.most),
            ));
        }
        if let Some(output) = &self.output {
            text.push_str(&format!("  written   {output}\n"));
        }
        text
    }
}
