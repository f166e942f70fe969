//! What pasting and merging leaves between the lines: marks of a conflict, tags of a page, marks
//! of a diff, numbers of lines.

use super::*;

/// Maximum number of lines of a conflict.
const MAX_LINES: usize = 4_000;
/// Marks that a merge leaves, in their order.
const MARKS: [&str; 4] = ["<<<<<<<", "|||||||", "=======", ">>>>>>>"];

/// A line with its line break.
#[derive(Clone, Copy)]
pub(super) struct TextRow<'a> {
    pub start: u32,
    pub text: &'a str,
}

impl TextRow<'_> {
    pub fn span(&self) -> Span {
        Span::new(self.start, self.start + self.text.len() as u32)
    }

    /// The span without the blanks and the line break at the end.
    pub fn shown(&self) -> Span {
        Span::new(self.start, self.start + self.text.trim_end().len() as u32)
    }

    pub fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }

    /// The mark of a merge at its start.
    fn mark(&self) -> Option<usize> {
        let text = self.text.trim();
        let is_mark = |mark: &str| {
            let rest = text.strip_prefix(mark);
            rest.is_some_and(|r| r.is_empty() || r.starts_with(' '))
        };
        MARKS.iter().position(|m| is_mark(m))
    }
}

impl FaultyShader<'_> {
    /// A conflict of a merge: the first version is kept.
    pub(super) fn conflict(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let first = TextRow {
            start: line.start,
            text: line.text,
        };
        let mark = first.mark()?;
        let rows = self.rows_from(line.start);
        let span = Span::new(
            line.start + (line.text.len() - line.text.trim_start().len()) as u32,
            line.end(),
        );
        let mut found = self.conflict_edits(&rows);
        let mut title = "keep the first version";
        if mark > 0 || found.is_none() {
            let row = rows.first().map_or(span, TextRow::span);
            found = Some(vec![Edit::delete(row)]);
            title = "remove the line";
        }
        let message = match mark {
            0 => "unresolved merge conflict",
            _ => "leftover line of a merge conflict",
        };
        found.map(|edits| syntax(span, message, title, edits))
    }

    /// Deletes the marks and the versions after the first one.
    fn conflict_edits(&self, rows: &[TextRow]) -> Option<Vec<Edit>> {
        let end = rows.iter().position(|r| r.mark() == Some(3))?;
        let other = rows.iter().position(|r| matches!(r.mark(), Some(1 | 2)))?;
        let (first, other, end) = (rows.first()?, rows.get(other)?, rows.get(end)?);
        let second = other.span().to(end.span());
        (other.start < end.start).then(|| vec![Edit::delete(first.span()), Edit::delete(second)])
    }

    /// The lines from an address on.
    pub(super) fn rows_from(&self, start: u32) -> Vec<TextRow<'_>> {
        let (_, rest) = self.program.sources.around(start);
        let mut at = start;
        let rows = rest.split_inclusive('\n').take(MAX_LINES).map(|text| {
            let row = TextRow { start: at, text };
            at += text.len() as u32;
            row
        });
        rows.collect()
    }

    /// Lines that are not a part of the shader, and marks before each line.
    pub(super) fn pasted_marks(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        all.extend(self.tags(line));
        if let Some(prefix) = prefix(line.text) {
            let rows = self.rows_from(line.start);
            let marked = rows.iter().map_while(|r| Some((r, self::prefix(r.text)?)));
            let edits = marked.map(|(r, p)| {
                let blanks = (r.text.len() - r.text.trim_start().len()) as u32;
                Edit::delete(Span::new(r.start + blanks, r.start + p as u32))
            });
            let mark = line.text.get(..prefix).unwrap_or("").trim();
            let message = format!("unexpected `{mark}` before the code of the line");
            let blanks = (line.text.len() - line.text.trim_start().len()) as u32;
            let span = Span::new(line.start + blanks, line.end());
            all.push(syntax(span, message, "remove it", edits.collect()));
        }
    }

    /// Tags of HTML: alone on a line, the line is removed.
    fn tags(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let open = line.text.find('<')?;
        let rest = line.text.get(open..).unwrap_or("");
        let close = rest.find('>')?;
        let tag = rest.get(..close + 1).unwrap_or("");
        let comment = rest.starts_with("<!--").then(|| rest.find("-->")).flatten();
        let tag = comment.and_then(|end| rest.get(..end + 3)).unwrap_or(tag);
        let name = tag.trim_start_matches(['<', '/', '!', '-']);
        if !name.starts_with(|c: char| c.is_ascii_alphabetic() || comment.is_some()) {
            return None;
        }
        let word: String = name
            .chars()
            .take_while(char::is_ascii_alphanumeric)
            .collect();
        let start = line.start + open as u32;
        let span = Span::new(start, start + tag.len() as u32);
        if comment.is_some() {
            let inner = tag
                .trim_start_matches(['<', '!', '-'])
                .trim_end_matches(['-', '>']);
            let edits = vec![Edit::replace(span, format!("/*{inner}*/"))];
            let message = "expected `/* */` for a comment, found `<!-- -->`";
            return Some(foreign(span, message, "use `/* */`", edits));
        }
        let mut edits = vec![Edit::delete(span)];
        let closing = format!("</{word}");
        if let Some((code, at)) = self.program.sources.code_at(line.end()).and_then(|code| {
            let from = (line.end() - code.base) as usize;
            let at = code.text.get(from..)?.find(&closing)? + from;
            Some((code, at))
        }) {
            let end = code
                .text
                .get(at..)
                .and_then(|t| t.find('>'))
                .map_or(closing.len(), |i| i + 1);
            let at = code.base + at as u32;
            edits.push(Edit::delete(Span::new(at, at + end as u32)));
        }
        let message = format!(
            "unexpected HTML tag `<{}{word}>`",
            if tag.starts_with("</") { "/" } else { "" }
        );
        Some(foreign(span, message, "remove the tag", edits))
    }
}

/// Length of a line number, the mark of a diff or the mark of a quotation at the start of a line.
fn prefix(text: &str) -> Option<usize> {
    let blanks = text.len() - text.trim_start().len();
    let rest = text.get(blanks..)?;
    let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let len = match rest.get(digits..)? {
        after if digits > 0 => match after.chars().next()? {
            ':' | '|' | '.' | ')' => digits + 1,
            ' ' | '\t' => digits,
            _ => return None,
        },
        after if after.starts_with(['+', '>', '|']) && !after.starts_with(">>") => 1,
        _ => return None,
    };
    let after = rest.get(len..)?;
    let gap = after.len() - after.trim_start_matches([' ', '\t']).len();
    let gap = if digits > 0 || rest.starts_with(['>', '|']) {
        gap.min(1)
    } else {
        0
    };
    (!after.trim().is_empty()).then_some(blanks + len + gap)
}
