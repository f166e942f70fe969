//! What the bytes of a file say, as text.

/// How the bytes of a file were written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Encoding {
    /// As they should be.
    Utf8,
    /// UTF-8 up to this offset; what follows is read as a browser reads it, with U+FFFD in the
    /// place of bytes that mean nothing.
    Damaged(u32),
    /// UTF-16; nothing of it is read.
    Utf16,
    /// Neither; nothing of it is read.
    Binary,
}

/// What a file holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Content {
    /// Its text.
    pub text: String,
    /// How it was written.
    pub encoding: Encoding,
}

impl Content {
    /// Text that is well encoded.
    pub fn utf8(text: &str) -> Content {
        Content {
            text: text.to_string(),
            encoding: Encoding::Utf8,
        }
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
