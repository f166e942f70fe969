//! Code that shows a change: its lines start with `+`, `-` or `*`.

/// What happens to a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LineChange {
    Kept,
    Added,
    Removed,
}

/// The text after a change, with the same length: removed lines and marks are blank. `None` if no
/// change is shown.
///
/// `shown` has the lines of `code`, without what precedes them in the file. A lesson marks lines
/// without a word about it; `is_named` is set if the author calls it a diff.
pub fn renewed(shown: &str, code: &str, is_named: bool) -> Option<String> {
    if !shown.lines().any(|line| line.starts_with(['+', '-', '*'])) {
        return None;
    }
    let changes = match is_named {
        true => shown.lines().map(named_change).collect(),
        false => marked(shown)?,
    };
    let mut text = String::with_capacity(code.len());
    for (line, change) in code.split_inclusive('\n').zip(changes) {
        let mark = line.find(|c: char| !c.is_whitespace());
        match (change, mark) {
            (LineChange::Removed, _) => text.extend(line.bytes().map(|b| match b {
                b'\n' | b'\r' => char::from(b),
                _ => ' ',
            })),
            (LineChange::Added, Some(at)) => {
                text.push_str(line.get(..at).unwrap_or(""));
                text.push(' ');
                text.push_str(line.get(at + 1..).unwrap_or(""));
            }
            _ => text.push_str(line),
        }
    }
    Some(text)
}

/// The change of a line in the output of a program.
fn named_change(line: &str) -> LineChange {
    let of_git = ["diff --git ", "index "];
    match line.chars().next() {
        _ if is_header(line) || of_git.iter().any(|w| line.starts_with(w)) => LineChange::Removed,
        mark @ Some('-' | '+') => change(mark),
        _ => LineChange::Kept,
    }
}

/// Whether a line names the changed file or the changed lines.
fn is_header(line: &str) -> bool {
    ["+++ ", "--- ", "@@ "].iter().any(|w| line.starts_with(w))
}

/// The changes of a text whose author marks lines; `None` if a mark may be an operator, and no other
/// line shows that the marks are none.
fn marked(shown: &str) -> Option<Vec<LineChange>> {
    let mut reader = MarkReader::default();
    let changes = shown.lines().map(|line| reader.line(line)).collect();
    (reader.is_certain || reader.is_marked && !reader.may_be_operator).then_some(changes)
}

#[derive(Default)]
struct MarkReader {
    /// Whether an operator may follow the last line that is not marked.
    is_open: bool,
    /// Whether the line before has a mark.
    follows_mark: bool,
    /// The mark of the line that opens the comment around the line, if there is one.
    comment: Option<Option<char>>,
    is_marked: bool,
    is_certain: bool,
    may_be_operator: bool,
}

impl MarkReader {
    fn line(&mut self, line: &str) -> LineChange {
        if is_header(line) {
            self.is_open = false;
            return LineChange::Removed;
        }
        let mark = mark(line);
        if let Some(opener) = self.comment {
            // Text and lists in comments are no changes.
            if line.contains("*/") {
                self.comment = None;
            }
            return match mark == opener {
                true => change(mark),
                false => LineChange::Kept,
            };
        }
        let (code, opens) = without_comments(line);
        if opens {
            self.comment = Some(mark);
        }
        let code = code.trim_end();
        if mark.is_some() {
            let kind = MarkedCode::of(code.get(1..).unwrap_or(""));
            self.is_marked = true;
            self.is_certain |= kind == MarkedCode::Statement;
            self.may_be_operator |= self.is_open && !self.follows_mark && kind == MarkedCode::Any;
        } else if !code.is_empty() {
            let is_directive = code.trim_start().starts_with('#') || code.contains("#version");
            let is_operand =
                |c: char| c.is_alphanumeric() || matches!(c, '_' | ')' | ']' | '"' | '\'');
            self.is_open = !is_directive && code.ends_with(is_operand);
        }
        self.follows_mark = mark.is_some();
        change(mark)
    }
}

fn change(mark: Option<char>) -> LineChange {
    match mark {
        Some('-') => LineChange::Removed,
        Some(_) => LineChange::Added,
        None => LineChange::Kept,
    }
}

/// The character that marks a line. `++i;`, `*/` and `-= 1` start with none.
fn mark(line: &str) -> Option<char> {
    let mut chars = line.chars();
    let mark = chars.next().filter(|c| matches!(c, '+' | '-' | '*'))?;
    let next = chars.next();
    let is_end = (mark, next) == ('*', Some('/'));
    (next != Some(mark) && next != Some('=') && !is_end).then_some(mark)
}

/// The code before a comment, and whether the comment continues in the next line.
fn without_comments(line: &str) -> (&str, bool) {
    let mut rest = line;
    while let Some(at) = rest.find("/*") {
        if rest.get(..at).is_some_and(|before| before.contains("//")) {
            break;
        }
        match rest.get(at..).and_then(|comment| comment.split_once("*/")) {
            Some((_, after)) => rest = after,
            None => return (line.get(..line.len() - rest.len() + at).unwrap_or(""), true),
        }
    }
    (line.split("//").next().unwrap_or(""), false)
}

/// What follows a mark.
#[derive(Clone, Copy, PartialEq, Eq)]
enum MarkedCode {
    /// No expression continues like this.
    Statement,
    /// Nothing.
    Blank,
    Any,
}

impl MarkedCode {
    fn of(code: &str) -> MarkedCode {
        let code = code.trim();
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '$');
        let first = |text: &str| text.find(|c| !is_part(c)).unwrap_or(text.len());
        let (word, after) = code.split_at_checked(first(code)).unwrap_or((code, ""));
        let after = after.trim_start();
        let second = after.get(..first(after)).unwrap_or("");
        let is_operator = matches!(word, "await" | "delete" | "new" | "typeof" | "void")
            || matches!(second, "as" | "in" | "instanceof" | "satisfies");
        let is_keyword = matches!(word, "else" | "for" | "if" | "return" | "switch" | "while");
        let is_declaration = !word.is_empty() && !second.is_empty() && !is_operator;
        // `a.b[i] += 1`
        let place = |c: char| is_part(c) || matches!(c, '.' | '[' | ']');
        let assigned = code.trim_start_matches(place).trim_start();
        let assigned = assigned.trim_start_matches(['+', '-', '*', '/']);
        let is_equality = assigned.starts_with("==") || assigned.starts_with("=>");
        let is_assignment = !word.is_empty() && assigned.starts_with('=') && !is_equality;
        let starts = code.starts_with(['#', '}', '<']);
        match code.is_empty() {
            true => MarkedCode::Blank,
            false if starts || is_keyword || is_assignment || is_declaration => {
                MarkedCode::Statement
            }
            false => MarkedCode::Any,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_read_as_the_code_after_them() {
        let cases = include_str!("changes.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            let (text, expected) = (text.replace('↵', "\n"), expected.replace('↵', "\n"));
            let (is_named, text) = match text.strip_prefix("diff ") {
                Some(text) => (true, text),
                None => (false, text.as_str()),
            };
            let result = renewed(text, text, is_named);
            assert_eq!(result.as_deref().unwrap_or("none"), expected, "{text}");
        }
    }

    #[test]
    fn marks_follow_what_precedes_the_lines() {
        let result = renewed("a;\n+b;\n-c;\n", "  a;\r\n  +b;\r\n  -c;\r\n", false);
        assert_eq!(result.as_deref(), Some("  a;\r\n   b;\r\n     \r\n"));
    }
}
