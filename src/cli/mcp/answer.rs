//! What a tool answers: bounded, and never empty.

use super::command::CommandOutcome;
use rmcp::model::{CallToolResult, ContentBlock};

/// Longest text of an answer in bytes, about six thousand tokens. What is longer helps nobody who has
/// to read it.
pub const MAX_TEXT: usize = 24_000;
/// Lines that stay at the end of a text that is cut: the summary.
const LAST_LINES: usize = 3;
/// Longest of these lines that is kept, in bytes.
const MAX_LINE: usize = 1_000;

/// What a tool answers.
#[derive(Debug)]
pub struct ToolAnswer {
    blocks: Vec<ContentBlock>,
    failed: bool,
}

impl ToolAnswer {
    /// What was asked for. Says `otherwise` where the text is empty.
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

    /// Why there is no answer.
    pub fn failed(text: &str) -> ToolAnswer {
        ToolAnswer {
            failed: true,
            ..ToolAnswer::of(text, "the command failed without a word")
        }
    }

    /// What a command said: what was asked for, then what it has to say of that. Says `otherwise`
    /// where it said nothing.
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

    /// Adds a text where there is one.
    pub fn push_any(&mut self, text: &str) {
        if !text.trim().is_empty() {
            self.push(text);
        }
    }

    /// Adds a PNG.
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

/// A text of at most `max` bytes, the first and the last lines of one that is longer.
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
    // Whole lines, unless there is one only.
    let head = head.rsplit_once('\n').map_or(head, |(lines, _)| lines);
    let left_out = rest.get(head.len()..).unwrap_or_default();
    let told = match left_out.trim_matches('\n').lines().count() {
        0 | 1 => format!("[{} bytes are left out]", left_out.len()),
        lines => format!("[{lines} lines are left out: ask for less at a time]"),
    };
    format!("{head}\n{told}\n{last}")
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
        let told = "[974 lines are left out: ask for less at a time]";
        assert!(short.contains(told), "{short}");
        assert!(short.len() < 200 + told.len() + 2);
    }

    #[test]
    fn a_long_line_is_cut_between_characters() {
        let short = shortened(&"é".repeat(1000), 201);
        assert_eq!(short.matches('é').count(), 100);
        assert!(short.contains("[1800 bytes are left out]"), "{short}");
    }

    #[test]
    fn no_answer_is_empty() {
        for answer in [ToolAnswer::of(" \n", "nothing"), ToolAnswer::failed("")] {
            assert_eq!(answer.blocks.len(), 1);
            let text = answer.blocks[0].as_text().map(|t| t.text.as_str());
            assert!(text.is_some_and(|t| !t.is_empty()));
        }
    }
}
