//! Decodes the bytes of a file.

/// The encoding of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Encoding {
    /// Valid UTF-8.
    Utf8,
    /// UTF-8 with an invalid byte at this offset; invalid bytes are decoded as U+FFFD, as browsers
    /// do it.
    Damaged(u32),
    /// UTF-16, which is not decoded.
    Utf16,
    /// Another encoding, which is not decoded.
    Binary,
}

/// The contents of a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Content {
    /// Decoded text.
    pub text: String,
    /// Detected encoding.
    pub encoding: Encoding,
}

impl Content {
    /// Valid UTF-8 text.
    pub fn utf8(text: &str) -> Content {
        Content {
            text: text.to_string(),
            encoding: Encoding::Utf8,
        }
    }

    /// Decodes UTF-16 with a byte order mark, as some shells write it.
    pub fn utf16(bytes: &[u8]) -> Option<String> {
        let (rest, is_little) = match bytes {
            [0xff, 0xfe, rest @ ..] => (rest, true),
            [0xfe, 0xff, rest @ ..] => (rest, false),
            _ => return None,
        };
        let pairs = rest.chunks_exact(2).filter_map(|p| p.try_into().ok());
        let unit = |pair| match is_little {
            true => u16::from_le_bytes(pair),
            false => u16::from_be_bytes(pair),
        };
        let units: Vec<u16> = pairs.map(unit).collect();
        Some(String::from_utf16_lossy(&units))
    }

    /// Decodes the bytes of a file.
    pub fn of(bytes: Vec<u8>) -> Content {
        let error = match String::from_utf8(bytes) {
            Ok(text) => {
                let encoding = Encoding::Utf8;
                return Content { text, encoding };
            }
            Err(error) => error,
        };
        let valid = error.utf8_error().valid_up_to() as u32;
        let bytes = error.as_bytes();
        let nothing = |encoding| Content {
            text: String::new(),
            encoding,
        };
        match bytes {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => nothing(Encoding::Utf16),
            _ if bytes.contains(&0) => nothing(Encoding::Binary),
            _ => Content {
                text: String::from_utf8_lossy(bytes).into_owned(),
                encoding: Encoding::Damaged(valid),
            },
        }
    }
}
