//! PNG files.

use super::args::MAX_PIXELS;
use super::image_file;
use crate::commands::run::Bitmap;
use crate::engine::playback::Decoded;

/// Decodes a PNG file and ignores its transparency.
///
/// # Errors
/// A message if the data is invalid.
pub fn of_png(bytes: &[u8]) -> Result<Bitmap, String> {
    let Decoded { size, colors } = image_file::of_png(bytes, MAX_PIXELS)?;
    let opaque = colors.into_iter().flat_map(|[r, g, b, _]| [r, g, b]);
    Ok(Bitmap {
        size,
        bytes: opaque.collect(),
    })
}

/// Encodes a PNG file.
///
/// # Errors
/// A message if the image cannot be encoded.
pub fn png(bitmap: &Bitmap) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let [width, height] = bitmap.size;
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // Fast compression: a smaller file took a tenth of the total time.
    encoder.set_compression(png::Compression::Fast);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&bitmap.bytes)?;
        writer.finish()
    });
    written.map(|()| bytes).map_err(|e| e.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let mut bitmap = Bitmap::filled([3, 2], [1, 2, 3]);
        bitmap.set(2, 1, [250, 0, 9]);
        bitmap.set(3, 0, [9; 3]);
        let file = png(&bitmap).unwrap();
        assert_eq!(of_png(&file), Ok(bitmap));
        assert!(of_png(&file[..20]).is_err());
    }
}
