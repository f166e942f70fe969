//! Statements that never run.

use shaderlint_lint::prelude::*;

rule! { dead_code, Tidy, Info, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let tree = &cx.program.tree;
    match tree.stmt(id).kind {
        StmtKind::Block(body) => check_run(cx, tree.block(body), true),
        StmtKind::Switch { body, .. } => {
            let is_label =
                |s: &StmtId| matches!(tree.stmt(*s).kind, StmtKind::Case(_) | StmtKind::Default);
            for run in tree.block(body).split(is_label) {
                check_run(cx, run, false);
            }
        }
        _ => {}
    }
}

/// Checks a sequence of statements.
fn check_run(cx: &mut Context, run: &[StmtId], is_block: bool) {
    let program = cx.program;
    let tree = &program.tree;
    let Some(end) = run.iter().position(|&s| cx.facts.reach().ends(s)) else {
        return;
    };
    let is_code = |s: &&StmtId| tree.stmt(**s).kind != StmtKind::Empty;
    let dead: Vec<StmtId> = run.iter().skip(end + 1).filter(is_code).copied().collect();
    let (Some(&first), Some(&last), Some(&end)) = (dead.first(), dead.last(), run.get(end)) else {
        return;
    };
    let (end, kind) = (tree.stmt(end), tree.stmt(first).kind);
    // A function needs a `return` after `discard`, and by convention every case ends with a `break`
    // and every function with a `return`.
    let is_jump = matches!(
        kind,
        StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue
    );
    if dead.len() == 1 && is_jump {
        return;
    }
    let extent = tree.stmt(first).extent.to(tree.stmt(last).extent);
    let Some(edit) = remove_statement(program, extent) else {
        return;
    };
    let exit = match end.kind {
        StmtKind::Return(_) => "`return` exits here",
        StmtKind::Discard => "`discard` exits here",
        StmtKind::Break => "`break` exits here",
        StmtKind::Continue => "`continue` exits here",
        _ => "always exits here",
    };
    let end = program.span(end.extent);
    let (message, title) = match dead.len() {
        1 => (
            "this statement is unreachable".to_string(),
            "remove the statement",
        ),
        n => (
            format!("these {n} statements are unreachable"),
            "remove the statements",
        ),
    };
    let fix = is_block.then(|| Fix::suggestion(title, vec![edit]));
    cx.report(tree.stmt(first).extent, message)
        .label(end, exit)
        .fix(fix);
}
