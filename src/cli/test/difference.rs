//! Visible differences between two images.
//!
//! Colours are converted to Oklab (Björn Ottosson, 2020), in which equal distances look about
//! equally large. Two pixels differ visibly if their distance is more than [`VISIBLE`], which is
//! just noticeable side by side.

use crate::commands::run::Bitmap;
use serde::Serialize;

/// Smallest visible distance in Oklab.
const VISIBLE: f64 = 0.02;

/// The difference between two images of the same size.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ImageDifference {
    /// Share of the pixels that differ visibly, 0 to 1.
    pub visible: f64,
    /// Average distance of the pixels in Oklab.
    pub mean: f64,
    /// Largest distance; the distance between black and white is 1.
    pub most: f64,
    /// Position of the pixel with the largest distance, from the lower left corner.
    pub worst: [u32; 2],
}

/// Compares two images of the same size. Also returns the distance of each pixel, bottom row first.
pub fn difference(a: &Bitmap, b: &Bitmap) -> (ImageDifference, Vec<f64>) {
    let [width, height] = a.size;
    let mut distances = Vec::with_capacity(width as usize * height as usize);
    let (mut most, mut worst) = (0.0, [0, 0]);
    for y in 0..height {
        for x in 0..width {
            let [one, two] = [a, b].map(|bitmap| bitmap.pixel(x, height - 1 - y));
            let distance = distance(one, two);
            if distance > most {
                (most, worst) = (distance, [x, y]);
            }
            distances.push(distance);
        }
    }
    let count = distances.len().max(1) as f64;
    let visible = distances.iter().filter(|d| **d > VISIBLE).count();
    let found = ImageDifference {
        visible: visible as f64 / count,
        mean: distances.iter().sum::<f64>() / count,
        most,
        worst,
    };
    (found, distances)
}

/// Distance of two sRGB colours in Oklab.
fn distance(a: [u8; 3], b: [u8; 3]) -> f64 {
    if a == b {
        return 0.0;
    }
    let lanes = oklab(a).into_iter().zip(oklab(b));
    lanes.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Converts an sRGB colour to Oklab: lightness, green to red, blue to yellow.
fn oklab(color: [u8; 3]) -> [f64; 3] {
    let linear = |byte: u8| match f64::from(byte) / 255.0 {
        c if c <= 0.040_45 => c / 12.92,
        c => ((c + 0.055) / 1.055).powf(2.4),
    };
    let [r, g, b] = color.map(linear);
    let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
    let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
    let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn oklab_colours_have_the_published_values() {
        let near = |color: [u8; 3], expected: [f64; 3]| {
            let found = oklab(color);
            let gaps = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
            assert!(gaps.fold(0.0, f64::max) < 1e-4, "{color:?}: {found:?}");
        };
        near([255; 3], [1.0, 0.0, 0.0]);
        near([255, 0, 0], [0.627_955, 0.224_863, 0.125_846]);
        near([0, 0, 255], [0.452_014, -0.032_457, -0.311_528]);
    }

    #[test]
    fn differences_of_one_step_are_invisible() {
        let mut image = Bitmap::filled([4, 2], [100, 150, 200]);
        let other = Bitmap::filled([4, 2], [101, 149, 201]);
        let (found, _) = difference(&image, &other);
        assert!(found.visible == 0.0 && found.mean > 0.0, "{found:?}");
        image.set(3, 1, [100, 170, 200]);
        let (found, distances) = difference(&image, &other);
        assert_eq!((found.visible, found.worst), (0.125, [3, 0]));
        assert_eq!(distances[3], found.most);
    }
}
