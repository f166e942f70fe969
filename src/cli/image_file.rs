//! Decodes image files: textures of channels and golden images.

use crate::play::Decoded;
use crate::project::kind_of_bytes;
use std::io::Cursor;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;

/// Maximum number of pixels of a texture, because exports may come from strangers.
const MOST_PIXELS: u64 = 1 << 24;

/// Decodes an image.
///
/// # Errors
/// A message if the format is not supported or the data is invalid.
pub fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    match kind_of_bytes(bytes) {
        Some((_, "image/png")) => of_png(bytes, MOST_PIXELS),
        Some((_, "image/jpeg")) => of_jpeg(bytes),
        Some((_, other)) => Err(format!("{other} is not supported; use PNG or JPEG")),
        None => Err("not an image".to_string()),
    }
}

/// Decodes a PNG file of at most `most` pixels.
///
/// # Errors
/// A message if the data is invalid or the image too large.
pub fn of_png(bytes: &[u8], most: u64) -> Result<Decoded, String> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|e| e.to_string())?;
    let size = [reader.info().width, reader.info().height];
    check_size(size, most)?;
    let mut samples = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let info = reader.next_frame(&mut samples).map_err(|e| e.to_string())?;
    samples.truncate(info.buffer_size());
    let pixels = samples.chunks_exact(info.color_type.samples());
    let colors = pixels.map(|pixel| match *pixel {
        [gray] => [gray, gray, gray, 255],
        [gray, opacity] => [gray, gray, gray, opacity],
        [r, g, b] => [r, g, b, 255],
        [r, g, b, opacity, ..] => [r, g, b, opacity],
        [] => [0; 4],
    });
    Ok(Decoded {
        size,
        colors: colors.collect(),
    })
}

fn of_jpeg(bytes: &[u8]) -> Result<Decoded, String> {
    let options = DecoderOptions::new_safe().jpeg_set_out_colorspace(ColorSpace::RGBA);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    let wrong = |e: DecodeErrors| e.to_string().trim().to_string();
    decoder.decode_headers().map_err(wrong)?;
    let size = decoder.dimensions().unwrap_or_default();
    let size = [size.0, size.1].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    check_size(size, MOST_PIXELS)?;
    // For four inks the decoder returns three bytes per pixel, whatever the output colour space.
    if let Some(inks @ (ColorSpace::CMYK | ColorSpace::YCCK)) = decoder.input_colorspace() {
        return Err(format!("JPEG in {inks:?} is not supported"));
    }
    let samples = decoder.decode().map_err(wrong)?;
    let (pixels, _) = samples.as_chunks::<4>();
    Ok(Decoded {
        size,
        colors: pixels.to_vec(),
    })
}

/// Rejects files that declare a huge image.
fn check_size([width, height]: [u32; 2], most: u64) -> Result<(), String> {
    let pixels = u64::from(width) * u64::from(height);
    match pixels <= most {
        true => Ok(()),
        false => Err(format!(
            "the image has {width}x{height} pixels; the limit is {most} pixels"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::run::Bitmap;

    #[test]
    fn images_above_the_pixel_limit_are_refused() {
        let file = Bitmap::filled([3, 2], [1, 2, 3]).png().unwrap();
        assert_eq!(of_png(&file, 6).unwrap().colors, [[1, 2, 3, 255]; 6]);
        let message = "the image has 3x2 pixels; the limit is 5 pixels";
        assert_eq!(of_png(&file, 5).unwrap_err(), message);
    }
}
