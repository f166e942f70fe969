//! Detects the type of a media file by its first bytes: extensions can be wrong, and browsers check
//! the content too.

use super::InputKind;

/// How many bytes of a file are inspected.
const HEAD: usize = 4096;

/// The kind of input and media type of a file; `None` for types that browsers do not support.
pub fn kind_of_bytes(bytes: &[u8]) -> Option<(InputKind, &'static str)> {
    let head = bytes.get(..HEAD).unwrap_or(bytes);
    image(head).or_else(|| film_or_music(head)).or_else(|| {
        let head = VolumeHead::read(bytes);
        head.map(|_| (InputKind::Volume, "application/octet-stream"))
    })
}

/// The media type for the extension of a file name.
pub fn kind_of_name(path: &str) -> Option<&'static str> {
    let extension = path.rsplit_once('.')?.1.to_ascii_lowercase();
    Some(match extension.as_str() {
        "png" => "image/png",
        "jpg" | "jpeg" => "image/jpeg",
        "webp" => "image/webp",
        "gif" => "image/gif",
        "avif" => "image/avif",
        "bmp" => "image/bmp",
        "mp4" => "video/mp4",
        "webm" => "video/webm",
        "ogv" => "video/ogg",
        "mp3" => "audio/mpeg",
        "ogg" | "oga" => "audio/ogg",
        "wav" => "audio/wav",
        "flac" => "audio/flac",
        "bin" => "application/octet-stream",
        _ => return None,
    })
}

fn image(head: &[u8]) -> Option<(InputKind, &'static str)> {
    let is_brand = |brand: &[u8]| brands(head).any(|b| b == brand);
    let kind = match head {
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => "image/png",
        [0xff, 0xd8, 0xff, ..] => "image/jpeg",
        [b'G', b'I', b'F', b'8', b'7' | b'9', b'a', ..] => "image/gif",
        _ if riff(head) == Some(b"WEBP") => "image/webp",
        _ if is_brand(b"avif") || is_brand(b"avis") => "image/avif",
        // The size of the second header, which identifies the version of the format.
        [b'B', b'M', ..]
            if matches!(
                head.get(14..18),
                Some([12 | 40 | 52 | 56 | 64 | 108 | 124, 0, 0, 0])
            ) =>
        {
            "image/bmp"
        }
        _ => return None,
    };
    Some((InputKind::Texture, kind))
}

fn film_or_music(head: &[u8]) -> Option<(InputKind, &'static str)> {
    let has = |word: &[u8]| head.windows(word.len()).any(|w| w == word);
    let first = brands(head).next();
    Some(match head {
        [0x1a, 0x45, 0xdf, 0xa3, ..] if has(b"webm") => (InputKind::Video, "video/webm"),
        [b'O', b'g', b'g', b'S', ..] if has(b"theora") => (InputKind::Video, "video/ogg"),
        [b'O', b'g', b'g', b'S', ..] => (InputKind::Music, "audio/ogg"),
        [b'f', b'L', b'a', b'C', ..] => (InputKind::Music, "audio/flac"),
        [b'I', b'D', b'3', ..] => (InputKind::Music, "audio/mpeg"),
        _ if riff(head) == Some(b"WAVE") => (InputKind::Music, "audio/wav"),
        // Only audio has a brand of its own; images of this family were matched before.
        _ if first.is_some_and(|b| b.starts_with(b"M4A")) => (InputKind::Music, "audio/mp4"),
        _ if first.is_some_and(|b| !IMAGE_BRANDS.contains(&b)) => (InputKind::Video, "video/mp4"),
        // A frame of MPEG audio: eleven set bits, then version, layer, bit rate and frequency.
        [0xff, second, third, ..]
            if second & 0xe6 == 0xe2
                && second & 0x18 != 0x08
                && third & 0xf0 != 0xf0
                && third & 0x0c != 0x0c =>
        {
            (InputKind::Music, "audio/mpeg")
        }
        [0xff, 0xf1 | 0xf9, ..] => (InputKind::Music, "audio/aac"),
        _ => return None,
    })
}

/// Brands of MP4-like files that are images which browsers do not support.
const IMAGE_BRANDS: [&[u8]; 6] = [b"heic", b"heix", b"hevc", b"hevx", b"mif1", b"msf1"];

/// The form type of a RIFF file.
fn riff(head: &[u8]) -> Option<&[u8; 4]> {
    let is_riff = head.starts_with(b"RIFF");
    head.get(8..12).filter(|_| is_riff)?.try_into().ok()
}

/// The brands of an MP4-like file, its major brand first.
fn brands(head: &[u8]) -> impl Iterator<Item = &[u8]> {
    let size = match head.get(..8) {
        Some([a, b, c, d, b'f', b't', b'y', b'p']) => u32::from_be_bytes([*a, *b, *c, *d]),
        _ => 0,
    };
    let brands = head.get(8..head.len().min(size as usize)).unwrap_or(&[]);
    // A version number follows the major brand.
    let others = brands.chunks_exact(4).enumerate();
    others.filter(|(i, _)| *i != 1).map(|(_, brand)| brand)
}

/// The header of ShaderToy's volume files: a signature, three sizes, the number of components, a
/// layout, and a format (0 for bytes, 10 for floats).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VolumeHead {
    /// Width, height and depth in texels.
    pub size: [u32; 3],
    /// Number of components of a texel, 1 to 4.
    pub components: usize,
    /// Size of a component in bytes: 1 for bytes, 4 for floats.
    pub width: usize,
}

impl VolumeHead {
    /// Offset of the data, in bytes.
    pub const LENGTH: usize = 20;

    /// Parses the header of a file with the exact amount of data that it specifies.
    pub fn read(file: &[u8]) -> Option<VolumeHead> {
        let field = |at: usize| {
            let four = file.get(at..at + 4)?.try_into().ok()?;
            Some(u32::from_le_bytes(four))
        };
        let (components, width) = match file.get(16..VolumeHead::LENGTH)? {
            [components @ 1..=4, _, 0, 0] => (usize::from(*components), 1),
            [components @ 1..=4, _, 10, 0] => (usize::from(*components), 4),
            _ => return None,
        };
        let size = [field(4)?, field(8)?, field(12)?];
        let mut sides = size.iter().map(|side| *side as usize);
        let data = sides.try_fold(components * width, usize::checked_mul)?;
        let is_complete = data > 0 && data.checked_add(VolumeHead::LENGTH) == Some(file.len());
        is_complete.then_some(VolumeHead {
            size,
            components,
            width,
        })
    }
}

/// The error for a file that is not a supported media file.
pub fn why_not(bytes: &[u8]) -> &'static str {
    let head = bytes.get(..HEAD).unwrap_or(bytes);
    let text = String::from_utf8_lossy(head).to_lowercase();
    match head {
        [] => "the file is empty",
        _ if text.contains("<svg") => {
            "SVG is not supported because it can contain scripts; save the image as PNG"
        }
        _ if text.trim_start().starts_with("<!doctype") || text.contains("<html") => {
            "this is an HTML page, perhaps saved instead of the file"
        }
        [0x1a, 0x45, 0xdf, 0xa3, ..] => "Matroska is not supported; save the video as WebM or MP4",
        _ if brands(head).next().is_some() => {
            "browsers do not support HEIC and similar formats; save the image as PNG"
        }
        [b'I', b'I', b'*', 0, ..] | [b'M', b'M', 0, b'*', ..] => {
            "browsers do not support TIFF; save the image as PNG"
        }
        _ => "not an image, video, audio or volume file that browsers support",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(bytes: &[u8], expected: Option<&str>) {
        let found = kind_of_bytes(bytes).map(|(_, kind)| kind);
        assert_eq!(found, expected);
    }

    #[test]
    fn media_types_are_detected_by_the_first_bytes() {
        check(b"\x89PNG\r\n\x1a\n\0\0", Some("image/png"));
        check(b"\xff\xd8\xff\xe0", Some("image/jpeg"));
        check(b"GIF89a", Some("image/gif"));
        check(b"RIFF\x01\0\0\0WEBPVP8 ", Some("image/webp"));
        check(b"RIFF\x01\0\0\0WAVEfmt ", Some("audio/wav"));
        check(b"\0\0\0\x1cftypmif1\0\0\0\0avifmiaf", Some("image/avif"));
        check(b"\0\0\0\x18ftypmif1\0\0\0\0heic", None);
        check(b"\0\0\0\x18ftypisom\0\0\x02\0mp41", Some("video/mp4"));
        check(b"\0\0\0\x18ftypM4A \0\0\x02\0mp42", Some("audio/mp4"));
        check(b"BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", Some("image/bmp"));
        check(b"BMP is a format of pictures", None);
        check(b"\x1a\x45\xdf\xa3\x01\x42\x82\x84webm", Some("video/webm"));
        check(b"\x1a\x45\xdf\xa3\x01\x42\x82\x88matroska", None);
        check(b"OggS\0\x02 \x80theora", Some("video/ogg"));
        check(b"OggS\0\x02 OpusHead", Some("audio/ogg"));
        check(b"fLaC", Some("audio/flac"));
        check(b"ID3\x03", Some("audio/mpeg"));
        check(b"\xff\xfb\x90\x64", Some("audio/mpeg"));
        check(b"\xff\xf1\x50\x80", Some("audio/aac"));
        check(b"\xff\xff\xff\xff", None);
        check(b"<svg xmlns", None);
        check(b"", None);
    }

    #[test]
    fn volumes_must_have_the_size_in_their_header() {
        let mut volume = b"BIN\0\x02\0\0\0\x02\0\0\0\x02\0\0\0\x01\0\0\0".to_vec();
        volume.extend([0; 8]);
        check(&volume, Some("application/octet-stream"));
        volume.push(0);
        check(&volume, None);
        let mut huge = [0xff; 28];
        huge[16..20].copy_from_slice(&[4, 0, 10, 0]);
        check(&huge, None);
    }

    #[test]
    fn files_that_are_not_media_are_named_in_messages() {
        assert!(why_not(b"<?xml version='1.0'?>\n<svg>").contains("SVG"));
        assert!(why_not(b"<!DOCTYPE html>").contains("HTML"));
        assert!(why_not(b"").contains("empty"));
    }
}
