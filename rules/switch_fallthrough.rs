//! `case` groups that fall through into the next one.

use shaderlint_lint::prelude::*;

rule! { switch_fallthrough, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let tree = &cx.program.tree;
    let StmtKind::Switch { body, .. } = tree.stmt(id).kind else {
        return;
    };
    let body = tree.block(body);
    let is_label = |s: StmtId| matches!(tree.stmt(s).kind, StmtKind::Case(_) | StmtKind::Default);
    // If no case leaves, they are meant to be executed in a row.
    if !body.iter().any(|s| cx.facts.reach().ends(*s)) {
        return;
    }
    for (at, pair) in body.windows(2).enumerate() {
        let &[last, label] = pair else { continue };
        if is_label(last) || !is_label(label) {
            continue;
        }
        let group = body.get(..=at).unwrap_or(&[]);
        let group = group.rsplit(|s| is_label(*s)).next().unwrap_or(&[]);
        let after = body.get(at + 1..).unwrap_or(&[]);
        let next = after.iter().find(|s| !is_label(**s));
        // Falling through into a lone jump does no harm.
        let leaves = next.is_some_and(|n| {
            matches!(
                tree.stmt(*n).kind,
                StmtKind::Break | StmtKind::Return(_) | StmtKind::Discard
            )
        });
        if !leaves && !group.iter().any(|s| cx.facts.reach().ends(*s)) {
            report(cx, last, label);
        }
    }
}

fn report(cx: &mut Context, last: StmtId, label: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let (last, label) = (tree.stmt(last).extent, tree.stmt(label).extent);
    let gap = Span::new(program.span(last).end, program.span(label).start);
    // A comment between them documents the fall-through.
    let is_noted = program
        .tokens
        .comments
        .iter()
        .any(|c| gap.contains(*c) && is_own_line(cx, *c));
    if is_noted || !program.is_direct(Extent::token(last.last)) || !program.is_direct(label) {
        return;
    }
    let edit = Edit::insert(program.span(last).end, " break;");
    let fix = Fix::suggestion("add `break;`", vec![edit]);
    cx.report(label, "previous `case` falls through into this one")
        .label(
            program.span(Extent::token(last.last)),
            "no `break` after this",
        )
        .help("if this is intended, add a comment on its own line before this label")
        .fix(fix);
}

/// Whether only blanks precede a comment on its line.
fn is_own_line(cx: &Context, comment: Span) -> bool {
    let code = cx.program.sources.file_at(comment.start);
    let start = code.and_then(|file| {
        let offset = comment.start - file.base;
        let (line, _) = file.lines().bounds(offset, file.text.len() as u32);
        file.text.get(line as usize..offset as usize)
    });
    start.is_some_and(|s| s.trim().is_empty())
}
