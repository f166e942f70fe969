//! Macros that nothing uses.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_lint::{Check, Context, Group, Rule, remove_lines};
use shaderlint_syntax::Macro;
use shaderlint_text::{Edit, Span};

pub static RULE: Rule = Rule {
    name: "unused-macro",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("unused_macro.md"),
    checks: &[Check::Macro(check)],
};

fn check(cx: &mut Context, definition: &Macro) {
    let program = cx.program;
    let span = definition.name_span;
    let is_own = cx.facts.own_file().is_some_and(|own| own.contains(span));
    if definition.uses > 0 || !is_own {
        return;
    }
    let name = program.names.text(definition.name);
    // Any other mention may be a test, or code that is left out at the moment.
    if name.starts_with('_') || cx.facts.count(name) != 1 {
        return;
    }
    let edit = removal(cx, span);
    let fix = edit.map(|edit| Fix::suggestion(format!("take `{name}` out"), vec![edit]));
    cx.report_span(span, format!("nothing uses the macro `{name}`"))
        .fix(fix);
}

/// Takes the `#define` away whose name stands at a span.
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
    // A comment that starts here and ends further down is left where it is, and the macro with it.
    let comments = &program.tokens.comments;
    let first = comments.partition_point(|c| c.start < span.start);
    let inside = comments.iter().skip(first);
    let mut inside = inside.take_while(|c| c.start < span.end);
    inside
        .all(|c| c.end <= span.end)
        .then(|| remove_lines(program, span))
}
