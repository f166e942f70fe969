//! Messages with a header, as the protocols of language servers and debuggers have them.

use std::io::{self, BufRead, ErrorKind, Read, Write};

/// Size limit of a message in bytes.
const MAX_MESSAGE: u64 = 256 * 1024 * 1024;
/// Size limit of a line of the header in bytes.
const MAX_LINE: u64 = 8 * 1024;

/// The body of the next message; `None` at the end of the input.
pub fn read_body(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        input.take(MAX_LINE).read_until(b'\n', &mut line)?;
        if line.is_empty() && length.is_none() {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let Some(line) = line.strip_suffix('\n') else {
            return Err(invalid("the header has no end"));
        };
        let line = line.trim_end();
        if line.is_empty() {
            break;
        }
        let Some((name, value)) = line.split_once(':') else {
            return Err(invalid("a line of the header has no `:`"));
        };
        if name.eq_ignore_ascii_case("content-length") {
            let number = value.trim().parse::<u64>();
            let number = number.map_err(|_| invalid("`Content-Length` is not a number"))?;
            length = Some(number);
        }
    }
    let length = length.ok_or_else(|| invalid("the header has no `Content-Length`"))?;
    if length > MAX_MESSAGE {
        return Err(invalid(&format!(
            "the message has {length} bytes; the limit is {MAX_MESSAGE}"
        )));
    }
    // The buffer grows with what arrives, not with what is announced.
    let mut body = Vec::new();
    input.take(length).read_to_end(&mut body)?;
    if (body.len() as u64) < length {
        return Err(io::Error::new(
            ErrorKind::UnexpectedEof,
            "the message has no end",
        ));
    }
    Ok(Some(body))
}

fn invalid(message: &str) -> io::Error {
    io::Error::new(ErrorKind::InvalidData, message)
}

/// Writes a message.
///
/// # Errors
/// If the output fails.
pub fn write_body(output: &mut impl Write, body: &str) -> io::Result<()> {
    let frame = format!("Content-Length: {}\r\n\r\n{body}", body.len());
    output.write_all(frame.as_bytes())
}
