//! Puts the evaluation of an expression into a copy of a program.
//!
//! The value is stored in a global variable. The store is a statement before the statement at hand, or,
//! for the condition or step of a loop, the left side of a comma.

use super::places::StackFrame;
use shaderlint_commands::run::Variant;
use shaderlint_semantic::{Program, Structure};
use shaderlint_syntax::ast::{Extent, StmtId, StmtKind};
use std::sync::Arc;

/// The global variable of the value.
pub const NAME: &str = "shaderlint_value";

/// A place in a program at which expressions can be evaluated.
pub struct InsertionPlace {
    /// Index of the pass in the project.
    pub pass: usize,
    /// The code of the pass.
    code: Arc<str>,
    /// Where the global variable is declared.
    global: usize,
    /// Where the expression is stored.
    at: usize,
    form: InsertionForm,
}

/// How the store is written.
#[derive(Clone, Copy)]
enum InsertionForm {
    /// As a statement; ends at this offset in braces if it has to be one statement with the next.
    Statement { end: Option<usize> },
    /// Before a comma; the expression after it ends at this offset.
    Comma { end: usize },
}

/// A changed text.
pub struct InsertedText {
    pub code: String,
    /// Offset of the parentheses around the expression.
    pub expression: usize,
    /// Offset of the statement that evaluates it.
    pub start: usize,
}

impl InsertionPlace {
    /// The place before the statement that a frame executes.
    ///
    /// # Errors
    /// A message if there is none.
    pub fn of(build: &Variant, frame: &StackFrame) -> Result<InsertionPlace, String> {
        let program = build.program().ok_or("the program is gone")?;
        let place = match is_end(program, frame.extent) {
            true => Some((frame.extent, false, false)),
            false => place(program, statement_at(program, frame.extent.first)),
        };
        let (extent, is_comma, needs_braces) =
            place.ok_or("expressions cannot be evaluated at this place, only variables")?;
        if !program.is_direct(Extent::token(extent.first)) {
            return Err("expressions cannot be evaluated in a macro, only variables".to_string());
        }
        let span = program.span(extent);
        let file = program.sources.file_id_at(span.start);
        let file = file.and_then(|id| Some((id, program.sources.file(id)?)));
        let (id, file) = file.ok_or("the statement has no place in the text")?;
        let pass = build
            .composed
            .owner(id)
            .ok_or("the host's code cannot be changed")?;
        let around = program
            .tree
            .functions
            .iter()
            .find(|f| f.extent.contains(extent));
        let function = around.map_or(extent, |f| f.extent);
        let offset = |address: u32| address.saturating_sub(file.base) as usize;
        let end = offset(span.end);
        Ok(InsertionPlace {
            pass,
            code: file.text.clone(),
            global: offset(program.span(function).start),
            at: offset(span.start),
            form: match (is_comma, needs_braces) {
                (true, _) => InsertionForm::Comma { end },
                (false, needs_braces) => InsertionForm::Statement {
                    end: needs_braces.then_some(end),
                },
            },
        })
    }

    /// The text that evaluates an expression and keeps its value, of this type, if one is given.
    ///
    /// # Errors
    /// A message if it is not an expression.
    pub fn insert(&self, expression: &str, ty: Option<&str>) -> Result<InsertedText, String> {
        is_one_expression(expression)?;
        let declared = ty.map_or(String::new(), |ty| format!("{ty} {NAME}; "));
        let store = ty.map_or(String::new(), |_| format!("{NAME} = "));
        let part = |range: std::ops::Range<usize>| self.code.get(range).unwrap_or("");
        let mut code = format!(
            "{}{declared}{}",
            part(0..self.global),
            part(self.global..self.at)
        );
        let (open, close, end) = match self.form {
            InsertionForm::Statement { end: None } => ("", "; ", None),
            InsertionForm::Statement { end } => ("{ ", "; ", end.map(|end| (end, " }"))),
            InsertionForm::Comma { end } => ("(", ", ", Some((end, ")"))),
        };
        code.push_str(open);
        let start = code.len();
        code.push_str(&store);
        let place = code.len();
        code.push_str(&format!("({expression}){close}"));
        let rest = match end {
            Some((end, close)) => format!(
                "{}{close}{}",
                part(self.at..end),
                part(end..self.code.len())
            ),
            None => part(self.at..self.code.len()).to_string(),
        };
        code.push_str(&rest);
        Ok(InsertedText {
            code,
            expression: place,
            start: match self.form {
                InsertionForm::Statement { .. } => start,
                // The statement begins with the parenthesis.
                InsertionForm::Comma { .. } => start - open.len(),
            },
        })
    }
}

/// Whether a place is the end of a function.
fn is_end(program: &Program, at: Extent) -> bool {
    let mut functions = program.tree.functions.iter();
    functions.any(|f| f.body.is_some() && Extent::token(f.extent.last) == at)
}

/// The statement that has this token, without those inside it.
fn statement_at(program: &Program, token: u32) -> Option<StmtId> {
    let tree = &program.tree;
    let all = (0..).map(StmtId).zip(&tree.stmts);
    let around = all.filter(|(_, s)| s.extent.first <= token && token <= s.extent.last);
    around
        .min_by_key(|(_, s)| s.extent.last - s.extent.first)
        .map(|(id, _)| id)
}

/// What the store goes before: its extent, whether that is an expression, and whether both need braces.
fn place(program: &Program, statement: Option<StmtId>) -> Option<(Extent, bool, bool)> {
    let statement = statement?;
    let tree = &program.tree;
    let structure = Structure::of(program);
    let of = |id: StmtId| &tree.stmt(id).kind;
    let outer = structure.outer(statement);
    let condition = match (of(statement), outer.map(of)) {
        (StmtKind::For { step, .. }, _) => return Some((tree.expr((*step)?).extent, true, false)),
        (StmtKind::Do { condition, .. }, _) => {
            return Some((tree.expr(*condition).extent, true, false));
        }
        (StmtKind::Expr(expr), Some(StmtKind::For { condition, .. })) => {
            (*condition == Some(statement)).then_some(*expr)
        }
        (StmtKind::Expr(expr), Some(StmtKind::While { condition, .. })) => {
            (*condition == statement).then_some(*expr)
        }
        _ => None,
    };
    if let Some(condition) = condition {
        return Some((tree.expr(condition).extent, true, false));
    }
    let is_header = match outer.map(of) {
        Some(StmtKind::For {
            init, condition, ..
        }) => *init == statement || *condition == Some(statement),
        Some(StmtKind::While { condition, .. }) => *condition == statement,
        _ => false,
    };
    let before = match outer {
        Some(outer) if is_header => outer,
        _ => statement,
    };
    let around = structure.outer(before).map(of);
    let is_listed = matches!(
        around,
        None | Some(StmtKind::Block(_) | StmtKind::Switch { .. })
    );
    Some((tree.stmt(before).extent, false, !is_listed))
}

/// Checks that a text cannot be more than one expression.
fn is_one_expression(text: &str) -> Result<(), String> {
    let mut open = Vec::new();
    let pairs = [('(', ')'), ('[', ']')];
    for c in text.chars() {
        if pairs.iter().any(|(left, _)| *left == c) {
            open.push(c);
        } else if let Some((left, _)) = pairs.iter().find(|(_, right)| *right == c)
            && open.pop() != Some(*left)
        {
            return Err(format!("unexpected `{c}`"));
        }
    }
    let is_plain = !text.contains([';', '{', '}', '#', '\n', '\r', '\\'])
        && !text.contains("//")
        && !text.contains("/*");
    match () {
        () if text.trim().is_empty() => Err("expected an expression".to_string()),
        () if !open.is_empty() => Err("a parenthesis is not closed".to_string()),
        () if !is_plain => Err("expected one expression on one line".to_string()),
        () => Ok(()),
    }
}
