//! Compressed projects.

use flate2::read::ZlibDecoder;
use std::io::Read;

/// Largest text of a project, in bytes: 40 MB, as for shaders.
const MAX_TEXT: u64 = 40 << 20;

/// Decompresses XML, as KodeLife stores it; `None` if it is not compressed.
pub(super) fn inflate(bytes: &[u8]) -> Option<Result<Vec<u8>, String>> {
    let [0x78, second, ..] = bytes else {
        return None;
    };
    if (0x7800 + u32::from(*second)) % 31 != 0 {
        return None;
    }
    // One byte more than the limit shows that there is more.
    let mut reader = ZlibDecoder::new(bytes).take(MAX_TEXT + 1);
    let mut start = [0; 1];
    let is_xml = matches!(reader.read(&mut start), Ok(1)) && start == *b"<";
    if !is_xml {
        return None;
    }
    let mut text = start.to_vec();
    Some(match reader.read_to_end(&mut text) {
        Ok(_) if text.len() > MAX_TEXT as usize => {
            Err("the project is larger than 40 MB when decompressed".to_string())
        }
        Ok(_) => Ok(text),
        Err(error) => Err(format!("the compressed project is damaged: {error}")),
    })
}
