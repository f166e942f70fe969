//! Positions for a missing `#endif` or `#if`, and misspelled directives.

use super::FaultyShader;
use super::candidate::RepairCandidate;
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_syntax::{DIRECTIVES, GroupDirective};
use shaderlint_text::{Edit, Role, Span};

/// Maximum number of positions tried for one `#endif`.
const MAX_PLACES: usize = 40;
/// Maximum number of lines of a group that are examined.
const MAX_LINES: usize = 4_000;

/// A line of a conditional group.
struct Line<'t> {
    /// Address of its first byte.
    start: u32,
    text: &'t str,
    /// Nesting depth of groups inside the current group at the start of the line.
    depth: u32,
    /// Number of braces opened since the current branch started.
    braces: i32,
}

fn indent_of(line: &str) -> usize {
    let blanks = line.chars().take_while(|c| matches!(c, ' ' | '\t'));
    blanks.map(|c| if c == '\t' { 4 } else { 1 }).sum()
}

/// Candidates for an unknown directive: every directive that it resembles.
fn misspelled(at: u32, line: &str, word: &str, all: &mut Vec<RepairCandidate>) {
    let (Some(hash), Some(from)) = (line.find('#'), line.find(word)) else {
        return;
    };
    let start = at + from as u32;
    let mut span = Span::new(start, start + word.len() as u32);
    let lower = word.to_ascii_lowercase();
    let resembles = |known: &'static str| {
        let distance = strsim::damerau_levenshtein(known, &lower);
        (distance <= 2 || known.starts_with(&lower) || lower.starts_with(known))
            .then_some((distance, known))
    };
    let mut near: Vec<(usize, &str)> = DIRECTIVES.iter().filter_map(|k| resembles(k)).collect();
    near.sort_unstable();
    // `#end if` is one directive split in two.
    let rest = line.get(from + word.len()..).unwrap_or("");
    let more = rest.trim_start();
    let next = more
        .split(|c: char| !c.is_ascii_alphanumeric())
        .next()
        .unwrap_or("");
    let joined = format!("{lower}{}", next.to_ascii_lowercase());
    if let Some(known) = DIRECTIVES
        .iter()
        .find(|k| **k == joined && !next.is_empty())
    {
        span.end += (rest.len() - more.len() + next.len()) as u32;
        near = vec![(0, known)];
    }
    for (_, known) in near {
        let fix = Fix::safe(
            format!("did you mean `#{known}`?"),
            vec![Edit::replace(span, known)],
        );
        let message = format!("unknown directive `#{word}`");
        let integral = Span::new(at + hash as u32, span.end);
        let found = Diagnostic::error(error::BAD_DIRECTIVE, integral, message);
        all.push(RepairCandidate::new(found, fix));
    }
}

impl Line<'_> {
    fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }

    fn indent(&self) -> usize {
        indent_of(self.text)
    }

    /// Name of the directive on the line; empty if there is none.
    fn directive(&self) -> &str {
        directive(self.text).unwrap_or("")
    }
}

/// The word after a line's `#`.
fn directive(line: &str) -> Option<&str> {
    let word = line.trim_start().strip_prefix('#')?.trim_start();
    let end = word.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    word.get(..end.unwrap_or(word.len()))
}

/// What a line's directive does to groups.
fn group_directive(line: &str) -> Option<GroupDirective> {
    GroupDirective::of(directive(line)?)
}

impl FaultyShader<'_> {
    /// Positions where a missing `#endif` may belong, most likely first.
    pub(super) fn conditionals(&self) -> Vec<RepairCandidate> {
        let is_open = |d: &&Diagnostic| d.is(error::UNBALANCED_CONDITIONAL) && d.fix.is_none();
        let Some(found) = self
            .errors
            .iter()
            .filter(is_open)
            .find(|d| group_directive(self.text(d.span)) == Some(GroupDirective::Opens))
        else {
            return self.lost_openings();
        };
        let lines = self.lines_after(found.span);
        let mut all = Vec::new();
        all.extend(
            places(&lines, self.indent_of(found.span))
                .into_iter()
                .filter_map(|i| {
                    let line = lines.get(i)?;
                    let blanks = self.blanks_before(found.span);
                    let edit = Edit::insert(line.start, format!("{blanks}#endif\n"));
                    let fix =
                        Fix::suggestion("add `#endif` where the group seems to end", vec![edit]);
                    let mut d = found.clone();
                    d.notes.clear();
                    d.label = "unclosed conditional group".to_string();
                    let d = d.label(Span::at(line.start), "expected `#endif` here");
                    Some(RepairCandidate::new(d, fix))
                }),
        );
        all
    }

    /// Candidates for every unknown directive. In skipped groups nothing else checks them.
    pub(super) fn directives(&self) -> Vec<RepairCandidate> {
        let mut all = Vec::new();
        let files = self
            .unit
            .files
            .iter()
            .filter_map(|&id| self.unit.sources.code(id));
        for code in files.filter(|c| c.role == Role::User) {
            let mut at = code.base;
            for text in code.text.split_inclusive(['\n', '\r']) {
                let word = directive(text).filter(|w| !w.is_empty() && !DIRECTIVES.contains(w));
                if let Some(word) = word {
                    misspelled(at, text, word, &mut all);
                }
                at += text.len() as u32;
            }
        }
        all.truncate(MAX_PLACES);
        all
    }

    /// Candidates for `#else` or `#endif` without `#if`: an `#if` before one of the preceding
    /// paragraphs.
    fn lost_openings(&self) -> Vec<RepairCandidate> {
        let is_lone = |d: &&Diagnostic| {
            let effect = group_directive(self.text(d.span));
            d.is(error::UNBALANCED_CONDITIONAL)
                && d.labels.is_empty()
                && effect.is_some_and(|effect| effect != GroupDirective::Opens)
        };
        let Some(found) = self.errors.iter().find(is_lone) else {
            return Vec::new();
        };
        let Some(code) = self.program.sources.code_at(found.span.start) else {
            return Vec::new();
        };
        let before = code
            .text
            .get(..(found.span.start - code.base) as usize)
            .unwrap_or("");
        let mut end = before.rfind('\n').map_or(0, |i| i + 1);
        let mut scored: Vec<(i32, u32)> = Vec::new();
        let (mut depth, mut count) = (0_u32, 0);
        let indent = self.indent_of(found.span);
        while let Some(text) = before.get(..end).filter(|t| !t.is_empty() && count < 400) {
            let start = text.trim_end_matches('\n').rfind('\n').map_or(0, |i| i + 1);
            let line = text.get(start..).unwrap_or("");
            let above = text
                .get(..start)
                .unwrap_or("")
                .lines()
                .next_back()
                .unwrap_or("");
            match group_directive(line) {
                Some(GroupDirective::Closes) => depth += 1,
                Some(GroupDirective::Opens) => match depth.checked_sub(1) {
                    Some(less) => depth = less,
                    None => break,
                },
                _ => {}
            }
            end = start;
            count += 1;
            if depth == 0 && !line.trim().is_empty() {
                let mut score = count;
                score -= if above.trim().is_empty() { 5 } else { 0 };
                score -= if indent_of(above) < indent_of(line) || indent_of(line) < indent {
                    2
                } else {
                    0
                };
                scored.push((score, code.base + start as u32));
            }
        }
        scored.sort_unstable();
        let places = scored.into_iter().take(MAX_PLACES).map(|(_, at)| at);
        let candidate = |at: u32| {
            let fix = Fix::suggestion(
                "add `#if 1` where the group seems to start",
                vec![Edit::insert(at, "#if 1\n")],
            );
            let found = found.clone();
            RepairCandidate::new(found.label(Span::at(at), "`#if` may be missing here"), fix)
        };
        places.map(candidate).collect()
    }

    /// The lines after an `#if`, up to the end of its file or of the enclosing group.
    fn lines_after(&self, opening: Span) -> Vec<Line<'_>> {
        let mut lines = Vec::new();
        let Some(code) = self.program.sources.code_at(opening.start) else {
            return lines;
        };
        let from = self.end_of_line(opening.end);
        let rest = code.text.get((from - code.base) as usize..).unwrap_or("");
        let (mut at, mut depth, mut braces) = (from, 0_u32, 0);
        for text in rest.split_inclusive('\n').take(MAX_LINES) {
            lines.push(Line {
                start: at,
                text,
                depth,
                braces,
            });
            at += text.len() as u32;
            match group_directive(text) {
                Some(GroupDirective::Opens) => depth += 1,
                Some(GroupDirective::Closes) => depth = depth.saturating_sub(1),
                Some(GroupDirective::Alternates) if depth == 0 => braces = 0,
                None if directive(text).is_none() => {
                    let code = text.split("//").next().unwrap_or("");
                    let count = |c| code.matches(c).count() as i32;
                    braces += count('{') - count('}');
                }
                _ => {}
            }
        }
        // The rest of the directive's own line.
        if !lines.is_empty() {
            lines.remove(0);
        }
        lines.push(Line {
            start: at,
            text: "",
            depth,
            braces,
        });
        lines
    }

    /// The blanks before a place at the start of a line.
    pub(super) fn blanks_before(&self, span: Span) -> String {
        let (before, _) = self.program.sources.around(span.start);
        let line = before.rsplit(['\n', '\r']).next().unwrap_or("");
        let is_blank = line.trim().is_empty();
        if is_blank { line } else { "" }.to_string()
    }

    fn indent_of(&self, span: Span) -> usize {
        indent_of(&self.blanks_before(span))
    }
}

/// Indices of the lines before which the `#endif` may belong, most likely first.
fn places(lines: &[Line], indent: usize) -> Vec<usize> {
    // After the last branch of the group.
    let alternates = Some(GroupDirective::Alternates);
    let is_branch = |l: &Line| l.depth == 0 && group_directive(l.text) == alternates;
    let last_branch = lines.iter().rposition(is_branch);
    // Braces left open by earlier branches are left open by the last one too.
    let open = last_branch.and_then(|i| lines.get(i)).map(|l| l.braces);
    let from = last_branch.map_or(0, |i| i + 1);
    let mut scored: Vec<(i32, usize)> = Vec::new();
    for (i, line) in lines.iter().enumerate().skip(from + 1) {
        if line.depth > 0 {
            continue;
        }
        scored.push((score(lines, i, indent, open) + (i - from) as i32 / 4, i));
    }
    scored.sort_unstable();
    scored
        .into_iter()
        .take(MAX_PLACES)
        .map(|(_, i)| i)
        .collect()
}

/// Cost of placing the `#endif` before a line; lower is more likely.
fn score(lines: &[Line], i: usize, indent: usize, open: Option<i32>) -> i32 {
    let Some(line) = lines.get(i) else { return 100 };
    let before = lines
        .get(..i)
        .and_then(|l| l.iter().rev().find(|l| !l.is_blank()));
    let after = lines
        .get(i..)
        .and_then(|l| l.iter().find(|l| !l.is_blank()));
    let mut score = 0;
    score += match open {
        Some(open) if line.braces != open => 12,
        None if line.braces != 0 => 6,
        _ => 0,
    };
    // A paragraph ends here, more clearly with two blank lines.
    let is_blank = |i: usize| lines.get(i).is_none_or(Line::is_blank);
    if is_blank(i) {
        score -= 4;
        score -= if is_blank(i + 1) { 3 } else { 0 };
    }
    if i.checked_sub(1).is_some_and(is_blank) {
        score += 3;
    }
    let (Some(before), Some(after)) = (before, after) else {
        return score;
    };
    // The contents of the group were indented, or all of one kind.
    if before.indent() > after.indent() && after.indent() <= indent {
        score -= 3;
    }
    let (was, is) = (before.directive(), after.directive());
    if was == "define" {
        score += if is == "define" { 3 } else { -4 };
    } else if before.indent() == after.indent() && !is_blank(i) {
        score += 2;
    }
    score
}
