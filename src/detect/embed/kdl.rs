//! Shaders in strings of KDL, the language of niri's configuration: the values of nodes whose names
//! mention shaders.

use super::embedded::{Embedded, Wrapping};
use crate::kind::{Chunk, Scanned};

/// Finds the shaders.
pub fn extract(text: &str, base: usize, found: &mut Vec<Embedded>) {
    let mut at = 0;
    while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
        let up_to = |end: &str| rest.find(end).map_or(rest.len(), |i| i + end.len());
        let node = text
            .get(..at)
            .and_then(|t| t.rsplit(['\n', '{', ';']).next());
        at += if rest.starts_with("//") {
            up_to("\n")
        } else if rest.starts_with("/*") {
            up_to("*/")
        } else if let Some((open, code, close)) = string(rest) {
            let scanned = Scanned::of(code);
            if node.is_some_and(|node| node.contains("shader")) && scanned.chunk() != Chunk::No {
                let start = base + at + open;
                found.push(Embedded::new(start, code.to_string(), Wrapping::Raw));
            }
            open + code.len() + close
        } else {
            rest.chars().next().map_or(1, char::len_utf8)
        };
    }
}

/// The string at the start of a text, between the lengths of its delimiters: `"`, `"""`, and both
/// with any number of `#`, after `r` in KDL 1.
fn string(text: &str) -> Option<(usize, &str, usize)> {
    let marked = text.strip_prefix('r').unwrap_or(text);
    let bare = marked.trim_start_matches('#');
    let quotes = ["\"\"\"", "\""].into_iter().find(|q| bare.starts_with(q))?;
    let inside = bare.strip_prefix(quotes)?;
    let open = text.len() - inside.len();
    let close = format!("{quotes}{}", "#".repeat(marked.len() - bare.len()));
    // Only a string without marks has escape sequences.
    let is_end = |at: usize| {
        let before = inside.get(..at).unwrap_or("");
        open > quotes.len() || (before.len() - before.trim_end_matches('\\').len()) % 2 == 0
    };
    let end = inside.match_indices(&close).find(|(at, _)| is_end(*at));
    let code = inside.get(..end.map_or(inside.len(), |(at, _)| at))?;
    Some((open, code, close.len()))
}
