//! Macros that are never used.

use shaderlint_lint::prelude::*;
use shaderlint_lint::remove_lines;

rule! { unused_macro, Tidy, Info, Strict, Macro(check) }

fn check(cx: &mut Context, definition: &Macro) {
    let program = cx.program;
    let span = definition.name_span;
    let is_own = cx.facts.own_file().is_some_and(|own| own.contains(span));
    if definition.uses > 0 || !is_own {
        return;
    }
    let name = program.names.text(definition.name);
    // Another mention may be an `#ifdef`, or in code that `#if` excludes.
    if name.starts_with('_') || cx.facts.count(name) != 1 {
        return;
    }
    let edit = removal(cx, span);
    let fix = edit.map(|edit| Fix::suggestion(format!("remove `{name}`"), vec![edit]));
    cx.report_span(span, format!("macro `{name}` is never used"))
        .fix(fix);
}

/// Removes the `#define` of the name at a span.
fn removal(cx: &Context, name: Span) -> Option<Edit> {
    let program = cx.program;
    let file = program.sources.file_at(name.start)?;
    let text = &*file.text;
    let at = (name.start - file.base) as usize;
    let start = text.get(..at)?.rfind('#')?;
    let mut end = at;
    loop {
        let rest = text.get(end..)?;
        let line = rest.find('\n').unwrap_or(rest.len());
        end += line;
        let goes_on = text.get(..end)?.trim_end_matches('\r').ends_with('\\');
        if !goes_on || end == text.len() {
            break;
        }
        end += 1;
    }
    let span = Span::new(file.base + start as u32, file.base + end as u32);
    // A comment that starts on this line and ends on a later one keeps the macro from being removed.
    let comments = &program.tokens.comments;
    let first = comments.partition_point(|c| c.start < span.start);
    let inside = comments.iter().skip(first);
    let mut inside = inside.take_while(|c| c.start < span.end);
    inside
        .all(|c| c.end <= span.end)
        .then(|| remove_lines(program, span))
}
