//! Conversions between paths and `file:` URIs (RFC 8089).

use gen_lsp_types::Uri;
use shaderlint_text::markup::in_address;
use shaderlint_text::path::{plain, slashed};
use std::path::{Path, PathBuf};

/// The path of a `file:` URI; `None` for others.
pub fn path_of(uri: &Uri) -> Option<PathBuf> {
    let rest = uri.0.strip_prefix("file://")?;
    // The path may follow an authority: `file://localhost/a`.
    let path = rest.get(rest.find('/')?..)?;
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let [first, after @ ..] = rest {
        let escaped = match (first, after) {
            (b'%', [high, low, after @ ..]) => {
                let digits = hex(*high).zip(hex(*low));
                digits.map(|(high, low)| (high << 4 | low, after))
            }
            _ => None,
        };
        let (byte, after) = escaped.unwrap_or((*first, after));
        bytes.push(byte);
        rest = after;
    }
    let path = String::from_utf8(bytes).ok()?;
    // `/C:/a` on Windows.
    let drive = path.get(1..3).filter(|d| d.ends_with(':') && cfg!(windows));
    let path = match drive {
        Some(_) => path.strip_prefix('/')?,
        None => &path,
    };
    Some(plain(Path::new(path)))
}

/// The URI of a path.
pub fn uri_of(path: &str) -> Uri {
    let start = if path.starts_with('/') { "" } else { "/" };
    let path = slashed(path);
    let parts: Vec<String> = path.split('/').map(in_address).collect();
    Uri(format!("file://{start}{}", parts.join("/")))
}

fn hex(digit: u8) -> Option<u8> {
    (digit as char).to_digit(16).map(|d| d as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_survive_conversion_to_uris() {
        for path in ["/a/b.glsl", "/a b/ü#%20.frag", "/x+y/[1].glsl"] {
            assert_eq!(path_of(&uri_of(path)), Some(path.into()), "{path}");
        }
        let encoded = Uri("file:///a%3Ab/c%2520.frag".into());
        assert_eq!(path_of(&encoded), Some("/a:b/c%20.frag".into()));
        assert_eq!(path_of(&Uri("untitled:Untitled-1".into())), None);
    }
}
