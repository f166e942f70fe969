//! 8-bit images.

use shaderlint_play::{RenderedImage, png};

/// An image of three bytes per pixel, top row first.
#[derive(Clone, PartialEq, Debug)]
pub struct Bitmap {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green and blue of each pixel.
    pub bytes: Vec<u8>,
}

impl Bitmap {
    /// A rendered image as 8-bit colours.
    pub fn of(image: &RenderedImage) -> Bitmap {
        Bitmap {
            size: image.size,
            bytes: image.bytes(),
        }
    }

    /// An image of one colour.
    pub fn filled(size: [u32; 2], color: [u8; 3]) -> Bitmap {
        let pixels = size.iter().map(|n| *n as usize).product();
        Bitmap {
            size,
            bytes: color.repeat(pixels),
        }
    }

    /// The image as a PNG file.
    ///
    /// # Errors
    /// A message if it has no pixels.
    pub fn png(&self) -> Result<Vec<u8>, String> {
        png(self.size, &self.bytes).map_err(|e| e.to_string())
    }

    /// The pixel at a position from the upper left corner; black outside.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        let at = self.offset(x, y).and_then(|at| self.bytes.get(at..at + 3));
        at.and_then(|bytes| bytes.try_into().ok()).unwrap_or([0; 3])
    }

    /// Sets a pixel; ignores positions outside.
    pub fn set(&mut self, x: u32, y: u32, color: [u8; 3]) {
        let at = self.offset(x, y);
        if let Some(pixel) = at.and_then(|at| self.bytes.get_mut(at..at + 3)) {
            pixel.copy_from_slice(&color);
        }
    }

    fn offset(&self, x: u32, y: u32) -> Option<usize> {
        let [width, height] = self.size;
        (x < width && y < height).then(|| 3 * (y as usize * width as usize + x as usize))
    }

    /// A smaller copy in which each pixel is the average of those it covers, approximately in
    /// linear light.
    pub fn shrunk(&self, size: [u32; 2]) -> Bitmap {
        let mut small = Bitmap::filled(size, [0; 3]);
        let ends = |i: u32, from: u32, to: u32| {
            let scaled = |i: u32| (u64::from(i) * u64::from(from) / u64::from(to)) as u32;
            (scaled(i), scaled(i + 1).max(scaled(i) + 1))
        };
        for y in 0..size[1] {
            let (top, bottom) = ends(y, self.size[1], size[1]);
            for x in 0..size[0] {
                let (left, right) = ends(x, self.size[0], size[0]);
                let mut sums = [0.0_f64; 3];
                for (y, x) in (top..bottom).flat_map(|y| (left..right).map(move |x| (y, x))) {
                    for (sum, byte) in sums.iter_mut().zip(self.pixel(x, y)) {
                        *sum += f64::from(byte) * f64::from(byte);
                    }
                }
                let count = f64::from((bottom - top) * (right - left));
                small.set(x, y, sums.map(|sum| (sum / count).sqrt().round() as u8));
            }
        }
        small
    }

    /// Copies an image into this one.
    pub fn paste(&mut self, other: &Bitmap, left: u32, top: u32) {
        for y in 0..other.size[1] {
            for x in 0..other.size[0] {
                self.set(left + x, top + y, other.pixel(x, y));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_preserves_brightness() {
        let mut bitmap = Bitmap::filled([4, 2], [0; 3]);
        bitmap.set(0, 0, [255; 3]);
        let small = bitmap.shrunk([2, 1]);
        assert_eq!(small.pixel(0, 0), [128; 3]);
        assert_eq!(small.pixel(1, 0), [0; 3]);
        assert_eq!(bitmap.shrunk([4, 2]), bitmap);
    }
}
