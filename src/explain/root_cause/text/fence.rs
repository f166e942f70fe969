//! Code that was copied with the text around it: only what stands between the fences is code, or what
//! does not read as prose.

use super::conflict::TextRow;
use super::*;
use shaderlint_syntax::{TypeWord, WordClass, classify};

/// Least number of words in a line of prose that starts with a word of the language.
const MANY_WORDS: usize = 5;

impl FaultyShader<'_> {
    /// Fences, and prose outside of them, which becomes comments.
    pub(super) fn fences(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let code = self.program.sources.code_at(line.start);
        let Some(code) = code.filter(|code| code.text.contains("```") || code.text.contains("~~~"))
        else {
            return;
        };
        let rows = self.rows_from(code.base);
        let is_fence = |row: &&TextRow| {
            let text = row.text.trim_start();
            text.starts_with("```") || text.starts_with("~~~")
        };
        let mut fences = rows.iter().filter(is_fence).map(|row| row.start);
        let (Some(first), second) = (fences.next(), fences.next()) else {
            return;
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
            true => Some(Edit::delete(Span::new(
                row.start,
                row.start + row.text.len() as u32,
            ))),
            false if row.text.trim().is_empty() => None,
            false => Some(Edit::insert(row.start, "// ")),
        });
        let (message, title) = match rows
            .iter()
            .any(|row| is_outside(&row) && !row.text.trim().is_empty())
        {
            true => (
                "unexpected Markdown around the code",
                "make comments of the text outside the fences",
            ),
            false => ("unexpected Markdown fence", "remove the fence"),
        };
        let edits: Vec<Edit> = edits.collect();
        let at = edits.first().map_or(line.start, |edit| edit.span.start);
        let shown = rows
            .iter()
            .find(|row| row.start == at)
            .map_or("", |row| row.text.trim_end());
        let span = Span::new(at, at + shown.len() as u32);
        all.push(syntax(span, message, title, edits).safe());
    }
}

impl FaultyShader<'_> {
    /// Prose before the code, behind it, or both, without a fence.
    pub(super) fn prose(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let code = self.program.sources.code_at(line.start);
        let Some(code) = code.filter(|code| !code.text.contains("```")) else {
            return;
        };
        let rows = self.rows_from(code.base);
        let is_prose = |row: &&TextRow| self.is_prose(row.text);
        let before: Vec<_> = rows.iter().take_while(is_prose).collect();
        let mut behind: Vec<_> = rows.iter().rev().take_while(is_prose).collect();
        behind.reverse();
        for (part, message) in [
            (before, "unexpected text before the code"),
            (behind, "unexpected text behind the code"),
        ] {
            let full = part.iter().filter(|row| !row.text.trim().is_empty());
            let edits: Vec<Edit> = full
                .clone()
                .map(|row| Edit::insert(row.start, "// "))
                .collect();
            let words: usize = full
                .clone()
                .map(|row| row.text.split_whitespace().count())
                .sum();
            let Some(first) = full.clone().next().filter(|_| words >= MANY_WORDS) else {
                continue;
            };
            // Only the first line stands for the text.
            let start = first.start;
            let span = Span::new(start, start + first.text.trim_end().len() as u32);
            all.push(syntax(span, message, "make a comment of it", edits).safe());
        }
    }

    /// Whether a line is empty or reads as prose.
    fn is_prose(&self, text: &str) -> bool {
        let text = text.trim();
        let is_letter = |c: char| !c.is_alphanumeric() && c != '_';
        let mut words = text.split(is_letter).filter(|word| !word.is_empty());
        let first = words.clone().next().unwrap_or("");
        let is_plain = classify(first, self.program.version) == WordClass::Plain;
        let is_directive = text.starts_with('#') && !text.starts_with("# ");
        let is_comment = text.starts_with("//") || text.starts_with("/*");
        let has_code = text.contains([';', '{', '}']) || is_directive || is_comment;
        let is_sentence = is_plain || words.nth(MANY_WORDS - 1).is_some();
        text.is_empty() || !has_code && is_sentence && TypeWord::named(first).is_none()
    }
}
