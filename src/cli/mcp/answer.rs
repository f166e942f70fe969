//! Answers of tools: limited in size, and never empty.

use super::command::CommandOutcome;
use rmcp::model::{CallToolResult, ContentBlock};

/// Size limit of an answer in bytes, about six thousand tokens.
pub const MAX_TEXT: usize = 24_000;
/// Number of lines kept at the end of a truncated text: the summary.
const LAST_LINES: usize = 3;
/// Maximum length of these lines in bytes.
const MAX_LINE: usize = 1_000;

/// The answer of a tool.
#[derive(Debug)]
pub struct ToolAnswer {
    blocks: Vec<ContentBlock>,
    failed: bool,
}

impl ToolAnswer {
    /// A successful answer. `otherwise` replaces an empty text.
    pub fn of(text: &str, otherwise: &str) -> ToolAnswer {
        let mut answer = ToolAnswer {
            blocks: Vec::new(),
            failed: false,
        };
        answer.push(if text.trim().is_empty() {
            otherwise
        } else {
            text
        });
        answer
    }

    /// An answer that reports an error.
    pub fn failed(text: &str) -> ToolAnswer {
        ToolAnswer {
            failed: true,
            ..ToolAnswer::of(text, "the command failed without output")
        }
    }

    /// The output of a command: standard output, then standard error. `otherwise` replaces an empty
    /// output.
    pub fn of_outcome(outcome: &CommandOutcome, otherwise: &str) -> ToolAnswer {
        let (out, err) = (outcome.out.trim(), outcome.err.trim());
        let first = if out.is_empty() { err } else { &outcome.out };
        let mut answer = ToolAnswer::of(first, otherwise);
        if !out.is_empty() {
            answer.push_any(&outcome.err);
        }
        answer
    }

    /// Adds a text.
    pub fn push(&mut self, text: &str) {
        self.blocks
            .push(ContentBlock::text(shortened(text, MAX_TEXT)));
    }

    /// Adds a text unless it is empty.
    pub fn push_any(&mut self, text: &str) {
        if !text.trim().is_empty() {
            self.push(text);
        }
    }

    /// Adds a PNG image.
    pub fn push_png(&mut self, bytes: &[u8]) {
        use base64::Engine;
        let data = base64::engine::general_purpose::STANDARD.encode(bytes);
        self.blocks.push(ContentBlock::image(data, "image/png"));
    }
}

impl From<ToolAnswer> for CallToolResult {
    fn from(answer: ToolAnswer) -> CallToolResult {
        match answer.failed {
            true => CallToolResult::error(answer.blocks),
            false => CallToolResult::success(answer.blocks),
        }
    }
}

/// Truncates a text to `max` bytes in the middle; the first and last lines are kept.
fn shortened(text: &str, max: usize) -> String {
    if text.len() <= max {
        return text.to_string();
    }
    let text = text.trim_end();
    let from_end = text.rsplit('\n').take(LAST_LINES);
    let mut last: Vec<&str> = from_end.take_while(|line| line.len() <= MAX_LINE).collect();
    last.reverse();
    let last = last.join("\n");
    let rest = text.get(..text.len() - last.len()).unwrap_or_default();
    let room = max.saturating_sub(last.len());
    let mut ends = (0..=room).rev();
    let end = ends.find(|end| rest.is_char_boundary(*end)).unwrap_or(0);
    let head = rest.get(..end).unwrap_or_default();
    // Cut at a line break, unless there is only one line.
    let head = head.rsplit_once('\n').map_or(head, |(lines, _)| lines);
    let left_out = rest.get(head.len()..).unwrap_or_default();
    let omitted = match left_out.trim_matches('\n').lines().count() {
        0 | 1 => format!("[{} bytes omitted]", left_out.len()),
        lines => format!("[{lines} lines omitted; request less at a time]"),
    };
    format!("{head}\n{omitted}\n{last}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_keep_their_first_and_last_lines() {
        let text: Vec<String> = (0..1000).map(|n| format!("line {n}")).collect();
        let text = text.join("\n");
        let short = shortened(&text, 200);
        assert!(short.starts_with("line 0\nline 1\n"), "{short}");
        assert!(short.ends_with("line 997\nline 998\nline 999"), "{short}");
        let omitted = "[974 lines omitted; request less at a time]";
        assert!(short.contains(omitted), "{short}");
        assert!(short.len() < 200 + omitted.len() + 2);
    }

    #[test]
    fn long_lines_are_cut_at_character_boundaries() {
        let short = shortened(&"é".repeat(1000), 201);
        assert_eq!(short.matches('é').count(), 100);
        assert!(short.contains("[1800 bytes omitted]"), "{short}");
    }

    #[test]
    fn answers_are_never_empty() {
        for answer in [ToolAnswer::of(" \n", "nothing"), ToolAnswer::failed("")] {
            assert_eq!(answer.blocks.len(), 1);
            let text = answer.blocks[0].as_text().map(|t| t.text.as_str());
            assert!(text.is_some_and(|t| !t.is_empty()));
        }
    }
}
