//! Heat maps: a value of each pixel as a colour, with a legend below.

use super::bitmap::Bitmap;
use super::font;
use shaderlint_text::number::short;

/// Colours from the smallest to the largest value, dark to bright.
const RAMP: [[u8; 3]; 6] = [
    [6, 6, 20],
    [66, 16, 96],
    [158, 36, 92],
    [230, 84, 44],
    [250, 178, 40],
    [252, 250, 190],
];

/// Minimum width of an image with a legend.
const NARROWEST: u32 = 96;
const TEXT: [u8; 3] = [220; 3];
const GROUND: [u8; 3] = [16; 3];

/// The colour of a share of the maximum.
pub fn color(share: f64) -> [u8; 3] {
    let at = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let before = (at.floor() as usize).min(RAMP.len() - 2);
    let part = at - before as f64;
    match RAMP.get(before..before + 2) {
        Some([from, to]) => mixed([*from, *to], part),
        _ => [0; 3],
    }
}

fn mixed([from, to]: [[u8; 3]; 2], part: f64) -> [u8; 3] {
    let mut mixed = [0; 3];
    for ((lane, from), to) in mixed.iter_mut().zip(from).zip(to) {
        *lane = (f64::from(from) + (f64::from(to) - f64::from(from)) * part).round() as u8;
    }
    mixed
}

/// Colour of values that are not finite.
const NO_NUMBER: [u8; 3] = [255, 0, 255];

/// The heat map of values, bottom row first, with a legend if there is room. The scale starts at 0,
/// or at the smallest value if that is negative.
pub fn map(size: [u32; 2], values: &[f64], title: &str) -> Bitmap {
    let finite = || values.iter().copied().filter(|n| n.is_finite());
    let (least, most) = (finite().fold(0.0, f64::min), finite().fold(0.0, f64::max));
    let mut image = Bitmap::filled(size, [0; 3]);
    for ((x, y), value) in places(size).zip(values) {
        let share = match most > least {
            true => (value - least) / (most - least),
            false => 0.0,
        };
        let color = match value.is_finite() {
            true => color(share),
            false => NO_NUMBER,
        };
        image.set(x, y, color);
    }
    with_legend(image, title, [short(least), short(most)], color)
}

/// The pixels of an image, bottom row first.
fn places([width, height]: [u32; 2]) -> impl Iterator<Item = (u32, u32)> {
    (0..height)
        .rev()
        .flat_map(move |y| (0..width).map(move |x| (x, y)))
}

/// Colours of slopes from 0 to 1, which steps by the distance allow for, and above.
const GENTLE: [[u8; 3]; 2] = [[10, 14, 30], [150, 200, 230]];
const STEEP: [[u8; 3]; 2] = [[255, 120, 96], [150, 0, 0]];
/// The slope that the legend ends at.
const STEEPEST: f64 = 2.0;
/// Slopes above 1 that are due to rounding.
const ROUNDED: f64 = 0.01;

/// The heat map of slopes, bottom row first, with a legend if there is room: blue up to 1, red above.
pub fn slopes(size: [u32; 2], values: &[f64]) -> Bitmap {
    let most = values.iter().copied().fold(0.0, f64::max);
    let mut image = Bitmap::filled(size, [0; 3]);
    for ((x, y), value) in places(size).zip(values) {
        image.set(x, y, slope_color(*value / STEEPEST));
    }
    let title = format!("SLOPE, RED > 1, MAX {}", short(most));
    with_legend(image, &title, [0.0, STEEPEST].map(short), slope_color)
}

/// The colour of a share of the steepest slope of the legend.
fn slope_color(share: f64) -> [u8; 3] {
    let slope = share * STEEPEST;
    match slope <= 1.0 + ROUNDED {
        true => mixed(GENTLE, slope.clamp(0.0, 1.0)),
        false => mixed(STEEP, (slope - 1.0).clamp(0.0, 1.0)),
    }
}

/// Adds a legend with the title and the ends of the scale, and the colour of each share of it.
fn with_legend(
    image: Bitmap,
    title: &str,
    [first, number]: [String; 2],
    color: fn(f64) -> [u8; 3],
) -> Bitmap {
    let [width, height] = image.size;
    if width < NARROWEST {
        return image;
    }
    let scale = (width / 320).clamp(1, 4);
    let [margin, bar] = [4 * scale, 8 * scale];
    let below = 2 * margin + bar;
    let mut framed = Bitmap::filled([width, height + below], GROUND);
    framed.paste(&image, 0, 0);
    let baseline = height + margin + (bar - font::HEIGHT * scale) / 2;
    font::write(&mut framed, title, [margin, baseline], scale, TEXT);
    let least = font::width(title, scale) + 2 * margin;
    font::write(&mut framed, &first, [least, baseline], scale, TEXT);
    let room = font::width(&number, scale) + margin;
    let left = least + font::width(&first, scale) + margin;
    let right = width.saturating_sub(room + margin).max(left + 1);
    for x in left..right {
        let share = f64::from(x - left) / f64::from((right - left).max(2) - 1);
        for y in 0..bar {
            framed.set(x, height + margin + y, color(share));
        }
    }
    font::write(
        &mut framed,
        &number,
        [right + margin, baseline],
        scale,
        TEXT,
    );
    framed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_colour_ramp_gets_steadily_brighter() {
        assert_eq!((color(0.0), color(1.0)), (RAMP[0], RAMP[5]));
        let light = |share| color(share).iter().map(|n| u32::from(*n)).sum::<u32>();
        let all: Vec<u32> = (0..=20).map(|i| light(f64::from(i) / 20.0)).collect();
        assert!(all.is_sorted(), "{all:?}");
    }

    #[test]
    fn heatmaps_have_their_first_row_at_the_bottom_above_the_legend() {
        let image = map([1, 2], &[0.0, 4.0], "STEPS");
        assert_eq!(image.size, [1, 2]);
        assert_eq!((image.pixel(0, 0), image.pixel(0, 1)), (RAMP[5], RAMP[0]));
        let wide = map([320, 2], &[1.0; 640], "STEPS");
        assert_eq!(wide.size, [320, 18]);
        assert_eq!(wide.pixel(0, 17), GROUND);
        assert!((0..320).any(|x| wide.pixel(x, 10) == RAMP[5]));
    }

    #[test]
    fn numbers_in_the_legend_are_abbreviated() {
        let all = [0.0, 96.0, 9_999.0, 12_345.0, 2.5e7, 0.125, 31.25].map(short);
        assert_eq!(all, ["0", "96", "9999", "12K", "25M", "0.125", "31.2"]);
    }
}
