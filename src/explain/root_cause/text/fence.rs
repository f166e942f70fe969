//! Code that was copied with the text around it: only what stands between the fences is code, or what
//! does not read as prose.

use super::conflict::TextRow;
use super::*;
use shaderlint_syntax::{TypeWord, WordClass, classify};

/// Maximum number of lines of prose.
const MAX_PROSE: usize = 100;
/// Least number of words in a line of prose that starts with a word of the language.
const MANY_WORDS: usize = 5;

impl FaultyShader<'_> {
    /// Fences, and prose outside of them, which becomes comments.
    pub(super) fn fences(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let code = self.program.sources.code_at(line.start);
        let code = code.filter(|code| code.text.contains("```") || code.text.contains("~~~"))?;
        let rows = self.rows_from(code.base);
        let is_fence = |row: &&TextRow| {
            let text = row.text.trim_start();
            text.starts_with("```") || text.starts_with("~~~")
        };
        let mut fences = rows.iter().filter(is_fence).map(|row| row.start);
        let (Some(first), second) = (fences.next(), fences.next()) else {
            return None;
        };
        let before = code.text.get(..(first - code.base) as usize).unwrap_or("");
        // A single fence after code closes it.
        let (open, close) = match second {
            None if before.contains('{') => (code.base, first),
            second => (first, second.unwrap_or(u32::MAX)),
        };
        let is_beyond = |row: &TextRow| row.start < open || row.start > close;
        // Code around a fence is kept.
        let has_code = rows
            .iter()
            .any(|row| is_beyond(row) && row.text.contains(['{', '}']));
        let is_outside = |row: &&TextRow| !has_code && is_beyond(row);
        let outside = rows.iter().filter(|row| is_fence(row) || is_outside(row));
        let edits = outside.filter_map(|row| match is_fence(&row) {
            true => Some(Edit::delete(row.span())),
            false if row.is_blank() => None,
            false => Some(Edit::insert(row.start, "// ")),
        });
        let is_text = |row: &TextRow| is_outside(&row) && !row.is_blank();
        let (message, title) = match rows.iter().any(is_text) {
            true => (
                "unexpected Markdown around the code",
                "make comments of the text outside the fences",
            ),
            false => ("unexpected Markdown fence", "remove the fence"),
        };
        let edits: Vec<Edit> = edits.collect();
        let at = edits.first().map_or(line.start, |edit| edit.span.start);
        let shown = rows.iter().find(|row| row.start == at);
        let span = shown.map_or(Span::at(at), TextRow::shown);
        Some(syntax(span, message, title, edits).safe())
    }
}

impl FaultyShader<'_> {
    /// Prose before the code, after it, or both, without a fence.
    pub(super) fn prose(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let code = self.program.sources.code_at(line.start);
        let Some(code) = code.filter(|code| !code.text.contains("```")) else {
            return;
        };
        let rows = self.rows_from(code.base);
        let is_prose = |row: &&TextRow| self.is_prose(row.text);
        let before: Vec<_> = rows.iter().take_while(is_prose).collect();
        let mut after: Vec<_> = rows.iter().rev().take_while(is_prose).collect();
        after.reverse();
        for (part, message) in [
            (before, "unexpected text before the code"),
            (after, "unexpected text after the code"),
        ] {
            if part.len() == rows.len() {
                continue;
            }
            let is_full = |row: &&TextRow| !row.is_blank();
            let full: Vec<TextRow> = part.into_iter().filter(is_full).copied().collect();
            let words = full.iter().map(|row| row.text.split_whitespace().count());
            let is_text = words.sum::<usize>() >= MANY_WORDS && full.len() <= MAX_PROSE;
            let Some(first) = full.first().filter(|_| is_text) else {
                continue;
            };
            // Only the first line stands for the text.
            let edits = full.iter().map(|row| Edit::insert(row.start, "// "));
            let (span, edits) = (first.shown(), edits.collect());
            all.push(syntax(span, message, "make a comment of it", edits).safe());
        }
    }

    /// Whether a line is empty or reads as prose.
    fn is_prose(&self, text: &str) -> bool {
        let text = text.trim();
        let is_between = |c: char| !c.is_alphanumeric() && c != '_';
        let mut words = text.split(is_between).filter(|word| !word.is_empty());
        let first = words.clone().next().unwrap_or("");
        let is_plain = classify(first, self.program.version) == WordClass::Plain;
        let is_directive = text.starts_with('#') && !text.starts_with("# ");
        let is_comment = text.starts_with("//") || text.starts_with("/*");
        let has_marks = text.contains([';', '{', '}', '=']) || is_directive || is_comment;
        let calls = |(at, _)| {
            text.get(..at)
                .is_some_and(|t| t.ends_with(char::is_alphanumeric))
        };
        let has_code = has_marks || text.match_indices('(').any(calls);
        let is_sentence = is_plain || words.nth(MANY_WORDS - 1).is_some();
        text.is_empty() || !has_code && is_sentence && TypeWord::named(first).is_none()
    }
}
