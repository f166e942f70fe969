//! Edits that remove code with its lines.

use super::{Edit, Sources, Span};

/// Removes the code of a span, with its lines if nothing else is on them. Comments stay.
pub fn remove_lines(sources: &Sources, span: Span) -> Edit {
    let Some(file) = sources.file_at(span.start) else {
        return Edit::delete(span);
    };
    let (text, base) = (&*file.text, file.base);
    let (start, end) = ((span.start - base) as usize, (span.end - base) as usize);
    let (Some(before), Some(after)) = (text.get(..start), text.get(end..)) else {
        return Edit::delete(span);
    };
    // Uses the line index, since one line may be the whole file and hold very many such spans.
    let bounds = |at: usize| file.lines().bounds(at as u32, text.len() as u32);
    let (line, next) = (bounds(start).0 as usize, bounds(end).1 as usize);
    let blanks = after.len() - after.trim_start_matches([' ', '\t']).len();
    let (spaced, newline) = match after.get(..next - end) {
        Some(line) if line.ends_with('\n') => line.split_at(line.len() - 1),
        Some(line) => (line, ""),
        None => (after, ""),
    };
    let is_first = before.get(line..).is_some_and(|s| s.trim().is_empty());
    let rest = spaced.trim();
    let is_last = rest.is_empty();
    let edit =
        |from: usize, to: usize| Edit::delete(Span::new(base + from as u32, base + to as u32));
    match (is_first, is_last) {
        (true, true) => {
            let mut to = end + spaced.len() + usize::from(!newline.is_empty());
            // Two adjacent blank lines become one.
            let is_blank_above = line == 0 || before.get(..line).is_some_and(ends_in_blank_line);
            let below = text.get(to..).unwrap_or("");
            let next = below.find('\n').map_or(below.len(), |i| i + 1);
            let is_blank_below = below.get(..next).is_some_and(|l| l.trim().is_empty());
            if is_blank_above && is_blank_below {
                to += next;
            }
            edit(line, to)
        }
        // Other code follows on the line: it moves up.
        (true, false) => edit(start, end + blanks),
        (false, _) if rest.is_empty() => {
            let kept = before.trim_end_matches([' ', '\t']).len();
            edit(kept, end)
        }
        (false, _) => edit(start, end + blanks),
    }
}

fn ends_in_blank_line(text: &str) -> bool {
    let mut lines = text.lines().rev();
    lines.next().is_none_or(|l| l.trim().is_empty())
}
