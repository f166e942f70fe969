//! Comments without their marks: a lost second `/`, `/*` or `*/`, and plain sentences.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_syntax::{RawKind, TokenKind, TypeWord, WordClass, classify};

/// Number of lines after an error in which the `*/` of its comment is searched.
const MAX_LINES: usize = 60;
/// Marks that start a comment in other languages, or a part of `//`.
const MARKS: &[&str] = &["\"\"\"", "/", "\\\\", "\\", "#", "--", "%", "'", ";;", "*"];
/// Least number of words that make a sentence.
const SENTENCE: usize = 3;

impl FaultyShader<'_> {
    pub(super) fn comments(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        all.extend(self.unterminated(line).into_iter().flatten());
        all.extend(self.lost_start(line));
        all.extend(self.stray_end(line));
        self.lost_slashes(line, all);
    }

    /// `/* ...` up to the end of the file: the comment may end with its line or paragraph.
    fn unterminated(&self, line: &FaultyLine) -> Option<Vec<RepairCandidate>> {
        let mut found = self.errors.iter().filter(|d| line.errors.contains(&d.span));
        let d = found.find(|d| d.is(error::UNTERMINATED_COMMENT))?;
        let code = self.program.sources.code_at(line.start)?;
        let rest = code.text.get((d.span.start - code.base) as usize..);
        let mut ends: Vec<u32> = Vec::new();
        let mut at = d.span.start;
        let lines = rest.unwrap_or("").split_inclusive('\n').take(MAX_LINES);
        let mut in_stars = true;
        for (i, text) in lines.enumerate() {
            let end = at + text.trim_end().len() as u32;
            in_stars &= i == 0 || text.trim_start().starts_with('*');
            // The end of the lines that start with a star is the most likely one.
            match (i, in_stars) {
                (0, _) => ends.push(end),
                (_, true) => {
                    ends.clear();
                    ends.push(end);
                }
                _ if text.trim().is_empty() => {
                    ends.push(at.saturating_sub(1));
                    break;
                }
                _ if ends.len() < 4 => ends.push(end),
                _ => {}
            }
            at += text.len() as u32;
        }
        let fix = |end| Fix::suggestion("add `*/`", vec![Edit::insert(end, " */")]);
        let ends = ends.into_iter();
        Some(
            ends.map(|end| RepairCandidate::of_error(d, fix(end)))
                .collect(),
        )
    }

    /// A comment that ends with `*/` and starts without `/*`.
    fn lost_start(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let (_, rest) = self.program.sources.around(line.start);
        let lines = rest.split_inclusive('\n').take(MAX_LINES);
        let within: usize = lines.map(str::len).sum();
        let rest = rest.get(..within).unwrap_or("");
        let end = rest.find("*/")?;
        let before = rest.get(..end).unwrap_or("");
        // Each line of many comments starts with a star.
        let later = before.split('\n').skip(1).map(str::trim_start);
        let mut later = later.filter(|l| !l.is_empty()).peekable();
        let has_stars = later.peek().is_some() && later.all(|l| l.starts_with('*'));
        let ends = [';', '{', '}'];
        let code = if has_stars { &ends[1..] } else { &ends };
        if before.contains("/*") || before.contains(code) {
            return None;
        }
        let blanks = (line.text.len() - line.text.trim_start().len()) as u32;
        let start = line.start + blanks;
        let has_star = line.text.trim_start().starts_with('*');
        let mark = if has_star { "/" } else { "/* " };
        let span = Span::new(start, line.end().min(line.start + end as u32 + 2));
        let edits = vec![Edit::insert(start, mark)];
        let message = "missing `/*` before this comment";
        Some(syntax(span, message, "add `/*`", edits))
    }

    /// `*/` after the end of the comment.
    fn stray_end(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let is_end = |&at: &usize| {
            line.is(at, TokenKind::Star)
                && line.is(at + 1, TokenKind::Slash)
                && line.touches_next(at)
        };
        let at = (0..line.tokens.len()).find(is_end)?;
        let span = line.span(at).to(line.span(at + 1));
        let offset = (span.start - line.start) as usize;
        let before = line.text.get(..offset).unwrap_or("");
        if let Some(end) = nested(before) {
            // The first `*/` ended the comment.
            let end = line.start + end as u32 + 2;
            let has_blank = line.of(Span::new(end, end + 1)) == " ";
            let edits = vec![Edit::insert(end, if has_blank { " /*" } else { " /* " })];
            let message = "block comments do not nest: the comment ended at the first `*/`";
            return Some(syntax(span, message, "start another comment", edits));
        }
        let blanks = match before.trim().is_empty() {
            true => 0,
            false => (before.len() - before.trim_end().len()) as u32,
        };
        let edits = vec![Edit::delete(Span::new(span.start - blanks, span.end))];
        let message = "`*/` without `/*`";
        Some(syntax(span, message, "remove `*/`", edits))
    }

    /// `/ text`, `\\ text`, `# text`, or a sentence without any mark.
    fn lost_slashes(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let first = line.errors.iter().map(|e| e.start).min().unwrap_or(0);
        let places = (0..line.tokens.len()).filter(|&at| line.starts_statement(at));
        for at in places {
            let from = line.span(at).start;
            let rest = line.text.get((from - line.start) as usize..).unwrap_or("");
            if from > first && line.span(at.saturating_sub(1)).end <= first {
                // The error must be in the text that becomes a comment.
                break;
            }
            let span = Span::new(from, line.start + line.text.trim_end().len() as u32);
            let mark = MARKS.iter().find(|mark| rest.starts_with(**mark));
            let after = mark.and_then(|mark| rest.strip_prefix(*mark));
            match (mark, after) {
                // `#word` is a directive.
                (Some(&"#"), Some(after)) if !after.starts_with([' ', '\t']) => {}
                (Some(mark), Some(after)) if is_comment(after, 1) => {
                    let place = Span::new(from, from + mark.len() as u32);
                    let message = format!("expected `//` before this comment, found `{mark}`");
                    let edits = vec![Edit::replace(place, "//")];
                    all.push(syntax(span, message, "use `//`", edits));
                }
                (None, _) if self.is_sentence(line, at) || is_link(rest) => {
                    let message = "missing `//` before this comment";
                    let edits = vec![Edit::insert(from, "// ")];
                    all.push(syntax(span, message, "add `//`", edits));
                }
                _ => {}
            }
        }
    }

    /// Whether the line consists of words from a token on, and few of them are of the language.
    fn is_sentence(&self, line: &FaultyLine, at: usize) -> bool {
        let rest = at..line.tokens.len();
        let from = (line.span(at).start - line.start) as usize;
        let text = line.text.get(from..).unwrap_or("");
        let is_word = |i: &usize| line.kind(*i) == Some(RawKind::Word);
        let is_plain = |i: &usize| {
            is_word(i) && classify(line.token(*i), self.program.version) == WordClass::Plain
        };
        let words = rest.clone().take_while(is_word).count();
        let plain = rest.clone().take_while(is_word).filter(is_plain).count();
        is_comment(text, SENTENCE)
            && words >= SENTENCE
            && 2 * plain > words
            && TypeWord::named(line.token(at)).is_none()
    }
}

/// Whether a text is the address of a page.
fn is_link(text: &str) -> bool {
    let scheme = text.split_once("://").map_or("", |(scheme, _)| scheme);
    !scheme.is_empty() && scheme.bytes().all(|b| b.is_ascii_lowercase())
}

/// Whether a text has this many words and no end of a statement.
fn is_comment(text: &str, words: usize) -> bool {
    let has_code = text.contains([';', '{', '}', '=']);
    let is_word = |w: &&str| w.starts_with(|c: char| c.is_alphanumeric());
    !has_code && text.split_whitespace().filter(is_word).count() >= words
}

/// Where the comment with a second `/*` inside ends.
fn nested(before: &str) -> Option<usize> {
    let end = before.rfind("*/")?;
    let start = before.get(..end)?.find("/*")?;
    before.get(start + 2..end)?.find("/*").map(|_| end)
}
