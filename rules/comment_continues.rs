//! A `\` at the end of a `//` comment, which makes the next line part of the comment.

use shaderlint_lint::prelude::*;

rule! { comment_continues, Tidy, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    for &comment in &program.tokens.comments {
        let text = program.sources.text(comment);
        if text.starts_with("//") && text.contains('\\') && program.is_user(comment) {
            check_comment(cx, comment, text);
        }
    }
}

/// Reports the first line of a comment that looks like code.
fn check_comment(cx: &mut Context, comment: Span, text: &str) {
    let mut start = 0;
    for (at, _) in text.match_indices('\n') {
        let line = text.get(start..at).unwrap_or("").trim_end_matches('\r');
        let next = text.get(at + 1..).unwrap_or("");
        let next = next.lines().next().unwrap_or("");
        let code = next.trim_start();
        let is_comment = code.is_empty() || code.starts_with("//") || code.starts_with('\\');
        if line.ends_with('\\') && !is_comment {
            let mark = comment.start + (start + line.len()) as u32;
            let mark = Span::new(mark - 1, mark);
            let from = comment.start + (at + 1 + next.len() - code.len()) as u32;
            let place = Span::new(from, from + code.trim_end().len() as u32);
            cx.report_span(place, "this line is part of the `//` comment above it")
                .label(mark, "`\\` continues the comment")
                .help("remove the `\\`, or add a character after it");
            return;
        }
        start = at + 1;
    }
}
