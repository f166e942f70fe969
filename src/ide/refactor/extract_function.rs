//! Moves an expression, or statements, to a new function.

use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind};
use crate::symbol::typed;
use shaderlint_semantic::{Direction, FunctionRef, Storage, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_text::{Edit, Span, apply_edits};

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    match place.expr() {
        Some(expr) => of_expr(place, expr),
        None => of_statements(place),
    }
}

/// A variable that the new function gets.
struct PassedVariable {
    id: VariableId,
    direction: Direction,
}

fn proposal(
    place: &RefactorPlace,
    function: FunctionRef,
    passed: &[PassedVariable],
    parts: NewFunction,
) -> Option<ProposedRefactoring> {
    let program = place.program;
    let own = place.definition(function)?;
    let mut parameters = Vec::new();
    let mut arguments = Vec::new();
    for variable in passed {
        let declared = program.variable(variable.id)?;
        let name = program.names.text(declared.name);
        let typed = typed(program, declared.ty, name);
        parameters.push(match variable.direction {
            Direction::In => typed,
            direction => format!("{} {typed}", direction.name()),
        });
        arguments.push(name);
    }
    let (name, line) = (parts.name, place.line_break());
    let head = format!("{} {name}({})", parts.returns, parameters.join(", "));
    let text = format!("{head} {{{line}{}}}{line}{line}", parts.body);
    let call = format!(
        "{}{name}({}){}",
        parts.before,
        arguments.join(", "),
        parts.after
    );
    let at = place.before_item(program.span(own.extent).start)?;
    let edits = vec![Edit::insert(at, text), Edit::replace(parts.replaced, call)];
    let kind = RefactorKind::ExtractFunction;
    Some(ProposedRefactoring::new(kind, "Extract to function", edits).named(name))
}

/// The text of a new function, and of its call.
struct NewFunction {
    name: String,
    returns: String,
    body: String,
    /// The text before and after the call.
    before: String,
    after: &'static str,
    replaced: Span,
}

fn of_expr(place: &RefactorPlace, expr: ExprId) -> Option<ProposedRefactoring> {
    let (program, tree) = (place.program, &place.program.tree);
    let ty = program.ty(expr);
    let inner = tree.unparen(expr);
    let extent = tree.expr(expr).extent;
    let is_trivial = matches!(
        tree.expr(inner).kind,
        ExprKind::Name(_)
            | ExprKind::Int(_)
            | ExprKind::Uint(_)
            | ExprKind::Float(_)
            | ExprKind::Bool(_)
    );
    if is_trivial || ty.is_error() || ty.is_void() || ty.is_sampler() {
        return None;
    }
    let (function, _) = place.function_of(expr)?;
    let locals = place.locals_in(extent);
    if locals.iter().any(|id| place.writes_in(*id, extent)) {
        return None;
    }
    let passed = locals.into_iter().map(|id| PassedVariable {
        id,
        direction: Direction::In,
    });
    let passed: Vec<PassedVariable> = passed.collect();
    let (indent, line) = (place.indentation(), place.line_break());
    let body = format!("{indent}return {};{line}", place.value_text(expr)?);
    proposal(
        place,
        function,
        &passed,
        NewFunction {
            name: place.free_name("extracted"),
            returns: typed(program, ty, "").trim_end().to_string(),
            body,
            before: String::new(),
            after: "",
            replaced: place.selection,
        },
    )
}

/// Consecutive statements of a block.
struct SelectedStatements {
    function: FunctionRef,
    extent: Extent,
    first: StmtId,
}

/// The selected statements, if no jump leaves them.
fn selected(place: &RefactorPlace) -> Option<SelectedStatements> {
    let (program, tree) = (place.program, &place.program.tree);
    let structure = place.facts.structure();
    for stmt in &tree.stmts {
        let (StmtKind::Block(list) | StmtKind::Switch { body: list, .. }) = stmt.kind else {
            continue;
        };
        let block = tree.block(list);
        let span = |s: &StmtId| program.span(tree.stmt(*s).extent);
        let first = block
            .iter()
            .position(|s| span(s).start == place.selection.start);
        let last = block
            .iter()
            .rposition(|s| span(s).end == place.selection.end);
        let (Some(first), Some(last)) = (first, last) else {
            continue;
        };
        let inner = block.get(first..=last)?;
        let (first, last) = (*inner.first()?, *inner.last()?);
        let extent = tree.stmt(first).extent.to(tree.stmt(last).extent);
        let function = structure.function_of(first)?;
        return (place.is_exact(extent) && !is_left(place, extent)).then_some(SelectedStatements {
            function,
            extent,
            first,
        });
    }
    None
}

/// Whether a jump or a label connects code with the code around it.
fn is_left(place: &RefactorPlace, extent: Extent) -> bool {
    let tree = &place.program.tree;
    let structure = place.facts.structure();
    let all = tree.stmts.iter().zip(0..);
    let mut within = all.filter(|(s, _)| extent.contains(s.extent));
    within.any(|(stmt, id)| {
        // The statement that a jump or a label belongs to.
        let is_outside = |is_target: fn(&StmtKind) -> bool| {
            let mut around = structure.outwards(StmtId(id)).map(|s| tree.stmt(s));
            let target = around.find(|s| is_target(&s.kind));
            target.is_none_or(|s| !extent.contains(s.extent))
        };
        let is_switch = |kind: &StmtKind| matches!(kind, StmtKind::Switch { .. });
        match stmt.kind {
            StmtKind::Return(_) | StmtKind::Error => true,
            StmtKind::Case(_) | StmtKind::Default => is_outside(is_switch),
            StmtKind::Continue => is_outside(StmtKind::is_loop),
            StmtKind::Break => {
                is_outside(|kind| kind.is_loop() || matches!(kind, StmtKind::Switch { .. }))
            }
            _ => false,
        }
    })
}

fn of_statements(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let program = place.program;
    let statements = selected(place)?;
    let extent = statements.extent;
    let text = place.text_of(extent)?;
    if text.lines().any(|line| line.trim_start().starts_with('#')) {
        return None;
    }
    let mut passed = Vec::new();
    for id in place.locals_in(extent) {
        let variable = program.variable(id)?;
        if !variable
            .token
            .is_some_and(|t| extent.contains(Extent::token(t)))
        {
            let is_written = place.writes_in(id, extent);
            let is_returned = is_written && is_used_after(place, id, &statements);
            let direction = match is_returned {
                true => Direction::Inout,
                false => Direction::In,
            };
            passed.push(PassedVariable { id, direction });
        }
    }
    // Declared in the statements, and used after them.
    let declared = (0..).map(VariableId).zip(&program.variables);
    let declared =
        declared.filter(|(_, v)| v.token.is_some_and(|t| extent.contains(Extent::token(t))));
    let used = declared.filter(|(id, _)| is_mentioned_outside(place, *id, extent));
    let used: Vec<VariableId> = used.map(|(id, _)| id).collect();
    let (indent, line) = (place.indentation(), place.line_break());
    let mut parts = NewFunction {
        name: place.free_name("extracted"),
        returns: "void".to_string(),
        body: String::new(),
        before: String::new(),
        after: ";",
        replaced: place.selection,
    };
    let mut text = text.to_string();
    if used.len() > 1 {
        text = without_types(place, &used, extent)?;
        parts.before = declarations(place, &used, statements.first)?;
        let outputs = used.iter().map(|id| PassedVariable {
            id: *id,
            direction: Direction::Out,
        });
        passed.extend(outputs);
    }
    parts.body = indented(place, statements.first, &text)?;
    if let [result] = used[..] {
        let variable = program.variable(result)?;
        let own = program.names.text(variable.name);
        parts.body.push_str(&format!("{indent}return {own};{line}"));
        parts.before = format!("{} = ", typed(program, variable.ty, own));
        parts.returns = typed(program, variable.ty, "").trim_end().to_string();
    }
    proposal(place, statements.function, &passed, parts)
}

/// The text of statements in which variables are parameters, and not declared.
fn without_types(place: &RefactorPlace, used: &[VariableId], extent: Extent) -> Option<String> {
    let program = place.program;
    let mut edits = Vec::new();
    for id in used {
        let (decl, _) = place.only_declarator(*id)?;
        let start = program.span(decl.extent).start;
        let name = program.declarator_of(*id)?.ident.token;
        let end = program.token(name)?.span.start;
        edits.push(Edit::delete(Span::new(start, end)));
    }
    let span = program.span(extent);
    apply_edits(place.text(span)?, span.start, &edits).ok()
}

/// The declarations of variables before a call that sets them.
fn declarations(place: &RefactorPlace, used: &[VariableId], first: StmtId) -> Option<String> {
    let program = place.program;
    let start = program.span(program.tree.stmt(first).extent).start;
    let after = match place.indent(start)? {
        Some(indent) => format!("{}{indent}", place.line_break()),
        None => " ".to_string(),
    };
    let declared = used.iter().map(|id| {
        let variable = program.variable(*id)?;
        let typed = typed(program, variable.ty, program.names.text(variable.name));
        Some(format!("{typed};{after}"))
    });
    declared.collect()
}

fn is_mentioned_outside(place: &RefactorPlace, id: VariableId, extent: Extent) -> bool {
    let mut all = place.facts.mentions().all(id).iter();
    all.any(|e| !extent.contains(place.program.tree.expr(*e).extent))
}

/// Whether a value written in statements may be read after them.
fn is_used_after(place: &RefactorPlace, id: VariableId, statements: &SelectedStatements) -> bool {
    let (program, tree) = (place.program, &place.program.tree);
    let storage = program.variable(id).map(|v| v.storage);
    if matches!(
        storage,
        Some(Storage::Param(Direction::Out | Direction::Inout))
    ) {
        return true;
    }
    let structure = place.facts.structure();
    let declared = program.variable(id).and_then(|v| v.token).unwrap_or(0);
    // A loop around the statements that does not declare the variable runs them again.
    let mut around = structure.outwards(statements.first).map(|s| tree.stmt(s));
    let is_repeated = around.any(|s| s.kind.is_loop() && declared < s.extent.first);
    let mut all = place.facts.mentions().all(id).iter();
    let is_later = |e: &ExprId| tree.expr(*e).extent.first > statements.extent.last;
    is_repeated || all.any(is_later)
}

/// The lines of statements, indented as the body of a function.
fn indented(place: &RefactorPlace, first: StmtId, text: &str) -> Option<String> {
    let start = place
        .program
        .span(place.program.tree.stmt(first).extent)
        .start;
    let outer = place.indent(start)?.unwrap_or("");
    let (indent, line) = (place.indentation(), place.line_break());
    let mut body = String::new();
    for (number, text) in text.lines().enumerate() {
        let own = match number {
            0 => text,
            _ => text.strip_prefix(outer).unwrap_or(text.trim_start()),
        };
        if !own.trim().is_empty() {
            body.push_str(indent);
        }
        body.push_str(own);
        body.push_str(line);
    }
    Some(body)
}
