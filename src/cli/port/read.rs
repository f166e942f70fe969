//! Reads input files, with a size limit and a notice while waiting for a pipe.

use crate::cli::inflate::inflate;
use crate::cli::usage::missing;
use crate::text::path::slashed;
use crate::text::{Content, Encoding};
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// Largest shader or export, in bytes. An export may contain its media.
const MAX_CODE: u64 = 128 * MIB;

/// Largest shader file, in bytes.
const MAX_SHADER: usize = 40 * MIB as usize;

const MIB: u64 = 1024 * 1024;

/// How long a pipe or a terminal may be silent before a notice is printed.
const PATIENCE: Duration = Duration::from_secs(2);

/// The text of a shader or an export; `-` is standard input.
pub(in crate::cli) fn read_text(path: &Path) -> Result<String, String> {
    let name = slashed(path);
    let wrong = |e: String| format!("{name}: {e}");
    let bytes = match path.as_os_str() == "-" {
        true => wait_for("standard input", || Ok(io::stdin()))?,
        false => {
            if !path.exists() {
                return Err(wrong(missing(path)));
            }
            let data = fs::metadata(path).map_err(|e| wrong(plain_error(&e)))?;
            if data.is_dir() {
                return Err(wrong("expected a file, found a folder".to_string()));
            }
            let from = path.to_path_buf();
            match data.is_file() {
                true => read_to(&mut File::open(path).map_err(|e| wrong(plain_error(&e)))?)
                    .map_err(|e| wrong(plain_error(&e)))?,
                false => wait_for(&name, move || File::open(from))?,
            }
        }
    };
    let text = decode(bytes).map_err(wrong)?;
    let is_export = text.trim_start().starts_with(['{', '[']);
    match text.len() {
        size if size as u64 > MAX_CODE || size > MAX_SHADER && !is_export => Err(wrong(format!(
            "the file is larger than {}, the limit for shaders",
            size_words(MAX_SHADER as u64)
        ))),
        _ => Ok(text),
    }
}

/// The bytes of a regular file of at most `limit` bytes. `advice` is appended to the error for a
/// larger file.
pub(super) fn read_media(path: &Path, limit: u64, advice: &str) -> Result<Vec<u8>, String> {
    let wrong = |e: String| format!("{}: {e}", slashed(path));
    let data = fs::metadata(path).map_err(|e| wrong(plain_error(&e)))?;
    if !data.is_file() {
        return Err(wrong("not a regular file".to_string()));
    }
    if data.len() > limit {
        let (size, most) = (size_words(data.len()), size_words(limit));
        return Err(wrong(format!(
            "the file has {size}, but the limit for media is {most}{advice}"
        )));
    }
    fs::read(path).map_err(|e| wrong(plain_error(&e)))
}

/// The message of a system error, without its number.
pub(super) fn plain_error(error: &io::Error) -> String {
    let text = error.to_string();
    match text.split_once(" (os error") {
        Some((words, _)) => words.to_string(),
        None => text,
    }
}

/// Reads a source that may never end, in its own thread. Prints a notice if nothing arrives for a
/// while.
fn wait_for<R: Read>(
    name: &str,
    open: impl FnOnce() -> io::Result<R> + Send + 'static,
) -> Result<Vec<u8>, String> {
    let (to, from) = channel();
    thread::spawn(move || {
        let read = open().and_then(|mut input| pass_on(&mut input, &to));
        // Sending fails if the receiver has stopped reading.
        let _ = to.send(read.map(|()| Vec::new()));
    });
    let mut bytes = Vec::new();
    let mut is_reported = false;
    loop {
        match from.recv_timeout(PATIENCE) {
            Ok(Ok(part)) if part.is_empty() => return Ok(bytes),
            Ok(Ok(part)) => bytes.extend(part),
            Ok(Err(e)) => return Err(format!("{name}: {}", plain_error(&e))),
            Err(RecvTimeoutError::Disconnected) => return Ok(bytes),
            Err(RecvTimeoutError::Timeout) if !is_reported => {
                is_reported = true;
                let _ = writeln!(
                    io::stderr(),
                    "waiting for {name}; press Ctrl+D to end the input, Ctrl+C to cancel"
                );
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        if bytes.len() as u64 > MAX_CODE {
            return Ok(bytes);
        }
    }
}

/// Sends the input in chunks.
fn pass_on(input: &mut impl Read, to: &Sender<io::Result<Vec<u8>>>) -> io::Result<()> {
    let mut part = vec![0; MIB as usize];
    loop {
        let length = input.read(&mut part)?;
        let Some(read @ [_, ..]) = part.get(..length) else {
            return Ok(());
        };
        if to.send(Ok(read.to_vec())).is_err() {
            return Ok(());
        }
    }
}

/// Reads one byte more than the limit, so that the caller can detect larger files.
fn read_to(file: &mut File) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(MAX_CODE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Decodes a text and removes a byte order mark.
fn decode(bytes: Vec<u8>) -> Result<String, String> {
    let bytes = inflate(&bytes).unwrap_or(Ok(bytes))?;
    if let Some(text) = Content::utf16(&bytes) {
        return Ok(text);
    }
    let Content { mut text, encoding } = Content::of(bytes);
    match encoding {
        Encoding::Binary | Encoding::Utf16 => Err("the file is not text".to_string()),
        Encoding::Utf8 | Encoding::Damaged(_) => {
            if text.starts_with('\u{feff}') {
                text.drain(..'\u{feff}'.len_utf8());
            }
            Ok(text)
        }
    }
}

/// A size in bytes, formatted for messages.
pub(super) fn size_words(bytes: u64) -> String {
    match bytes {
        0..1024 => format!("{bytes} bytes"),
        1024..MIB => format!("{} KB", bytes.div_ceil(1024)),
        _ => format!("{:.1} MB", bytes as f64 / MIB as f64).replace(".0 ", " "),
    }
}

/// Parses a size such as `64M`, `1.5 GB` or `4000`.
pub(super) fn size_of(text: &str) -> Result<u64, String> {
    let text = text.trim().to_ascii_lowercase();
    let text = text.trim_end_matches('b').trim_end_matches('i');
    let (number, unit) = match text.chars().last() {
        Some('k') => (text.trim_end_matches('k'), 1024),
        Some('m') => (text.trim_end_matches('m'), MIB),
        Some('g') => (text.trim_end_matches('g'), 1024 * MIB),
        _ => (text, 1),
    };
    let number: f64 = number
        .trim()
        .parse()
        .ok()
        .filter(|n: &f64| n.is_finite() && *n >= 0.0)
        .ok_or("expected a number of bytes, or a size such as `64M` or `1G`")?;
    Ok((number * unit as f64) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_sizes_are_parsed_and_printed() {
        assert_eq!(size_of("64M"), Ok(64 * MIB));
        assert_eq!(size_of("1.5 GiB"), Ok(1536 * MIB));
        assert_eq!(size_of("12"), Ok(12));
        assert!(size_of("big").is_err() && size_of("-1").is_err() && size_of("").is_err());
        assert_eq!(size_words(64 * MIB), "64 MB");
        assert_eq!(size_words(1500), "2 KB");
        assert_eq!(size_words(5), "5 bytes");
    }

    #[test]
    fn byte_order_marks_are_removed() {
        let all: [&[u8]; 4] = [
            b"ab",
            b"\xef\xbb\xbfab",
            b"\xff\xfea\0b\0",
            b"\xfe\xff\0a\0b",
        ];
        for bytes in all {
            assert_eq!(decode(bytes.to_vec()), Ok("ab".to_string()));
        }
        assert!(decode(b"\0\xff\x01".to_vec()).is_err());
    }
}
