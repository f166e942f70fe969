//! PNG files.

use crate::cli::image_file;
use crate::commands::run::Bitmap;
use crate::commands::run::MAX_PIXELS;
use crate::play::Decoded;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_png_is_read_back_unchanged() {
        let mut bitmap = Bitmap::filled([3, 2], [1, 2, 3]);
        bitmap.set(2, 1, [250, 0, 9]);
        bitmap.set(3, 0, [9; 3]);
        let file = bitmap.png().unwrap();
        assert_eq!(of_png(&file), Ok(bitmap));
        assert!(of_png(&file[..20]).is_err());
    }
}
