//! Edits that remove code cleanly: no blank line where a statement was, no comma left over.

use super::rule::DeclaredVariable;
use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{Declarator, Extent};
use shaderlint_text::{Edit, Span};

/// Removes a statement, declaration or function. `None` where it starts or ends in a macro, or where it
/// contains directives, which may belong to others outside.
pub fn remove_statement(program: &Program, extent: Extent) -> Option<Edit> {
    let is_direct = |t| program.token(t).is_some_and(|t| t.is_direct());
    let span = program.span(extent);
    let has_directive = program.sources.text(span).contains('#');
    (is_direct(extent.first) && is_direct(extent.last) && !has_directive)
        .then(|| remove_lines(program, span))
}

/// Removes the code of a span, with its lines if nothing else is on them. Comments stay.
pub fn remove_lines(program: &Program, span: Span) -> Edit {
    let Some(file) = program.sources.file_at(span.start) else {
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

/// Removes the declaration of a variable: all of it, or one name among several.
pub fn remove_declaration(program: &Program, declared: &DeclaredVariable) -> Option<Edit> {
    match declared.declarators.len() {
        1 => remove_statement(program, declared.extent),
        _ => remove_declarator(program, declared.declarators, declared.index),
    }
}

/// Removes one of several names of a declaration, with its initializer and a comma. `None` where a token
/// of it comes from a macro, or there is only one name.
fn remove_declarator(program: &Program, all: &[Declarator], index: usize) -> Option<Edit> {
    let this = all.get(index)?;
    let span = |extent: Extent| program.is_direct(extent).then(|| program.span(extent));
    let own = span(this.extent)?;
    let before = index.checked_sub(1).and_then(|i| all.get(i));
    let removed = match (before, all.get(index + 1)) {
        (Some(before), _) => Span::new(span(before.extent)?.end, own.end),
        (None, Some(next)) => Span::new(own.start, span(next.extent)?.start),
        (None, None) => return None,
    };
    // A comment between two names may be about either.
    let text = program.sources.text(removed);
    let has_comment = text.contains("//") || text.contains("/*");
    (!has_comment).then(|| Edit::delete(removed))
}
