//! Runs rules over a shader.

use super::broken::Broken;
use super::{Binary, Builtin, Check, Context, Facts, Rule, Settings, Shape};
use crate::diagnostic::{Diagnostic, Severity};
use crate::semantic::{FunctionRef, Program};
use crate::syntax::ast::*;
use crate::text::embed::Embedder;
use crate::text::{Role, Span};

/// Where rules did not run, since what stands there has errors.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub enum Unrun {
    /// They ran everywhere.
    #[default]
    Nowhere,
    /// In these functions.
    Functions {
        /// Their names.
        names: Vec<String>,
        /// Where no rule looked, in the order of the text.
        broken: Vec<Span>,
    },
    /// In the whole shader.
    Everywhere,
}

/// Runs the selected rules over a shader: one walk over the expressions and one over the statements
/// serve all of them.
pub fn lint(
    program: &Program,
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) {
    lint_within(
        program,
        Embedder::default(),
        &[],
        rules,
        settings,
        diagnostics,
    );
}

/// Runs the selected rules over a shader that stands in a page or script, as far as it is free of
/// the errors given. Says where they did not run.
pub fn lint_within(
    program: &Program,
    embedder: Embedder,
    errors: &[Diagnostic],
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) -> Unrun {
    let mut facts = Facts::new(program);
    facts.embedder = embedder;
    facts.broken = Broken::of(program, errors);
    if facts.broken.whole() {
        return Unrun::Everywhere;
    }
    let before = diagnostics.len();
    walk(program, &facts, rules, settings, diagnostics);
    if !facts.broken.any() {
        return Unrun::Nowhere;
    }
    let mut at = 0;
    diagnostics.retain(|d| {
        at += 1;
        at <= before || facts.broken.admits(program, d)
    });
    Unrun::Functions {
        names: broken_functions(program, &facts.broken),
        broken: facts.broken.spans().collect(),
    }
}

/// The names of the functions that have errors, in the order of the text.
fn broken_functions(program: &Program, broken: &Broken) -> Vec<String> {
    let functions = program.functions.iter().zip(0..);
    let functions = functions.filter(|(_, i)| broken.function(FunctionRef(*i)));
    let placed = functions.map(|(f, _)| {
        let id = f.definition.unwrap_or(f.declaration);
        let token = program.tree.function(id).map(|d| d.ident.token);
        (token, program.names.text(f.name).to_string())
    });
    let mut placed: Vec<_> = placed.collect();
    placed.sort();
    placed.dedup_by(|a, b| a.1 == b.1);
    placed.into_iter().map(|(_, name)| name).collect()
}

/// Runs the rules over all that is there.
fn walk<'p>(
    program: &'p Program,
    facts: &Facts<'p>,
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let mut run = Run {
        program,
        facts,
        settings,
        diagnostics,
    };
    let mut exprs = ExprRules::default();
    let mut stmts = Vec::new();
    let mut functions = Vec::new();
    for &rule in rules {
        let Some(level) = settings.level(rule) else {
            continue;
        };
        let active = Active { rule, level };
        match rule.check {
            Check::Program(check) => check(&mut run.context(active)),
            Check::Binary(check) => exprs.binary.push((active, check)),
            Check::Builtin(check) => exprs.builtin.push((active, check)),
            Check::Expr(shapes, check) => {
                for &shape in shapes {
                    if let Some(all) = exprs.by_shape.get_mut(shape as usize) {
                        all.push((active, check));
                    }
                }
            }
            Check::Stmt(check) => stmts.push((active, check)),
            Check::Function(check) => functions.push((active, check)),
            Check::Allows | Check::Page => {}
        }
    }
    let first = first_user_token(program);
    let tree = &program.tree;
    for (i, expr) in tree
        .exprs
        .iter()
        .enumerate()
        .filter(|(_, e)| e.extent.first >= first)
    {
        run.expr(&exprs, ExprId(i as u32), expr);
    }
    for (i, _) in tree
        .stmts
        .iter()
        .enumerate()
        .filter(|(_, s)| s.extent.first >= first)
    {
        for (rule, check) in &stmts {
            check(&mut run.context(*rule), StmtId(i as u32));
        }
    }
    for (i, function) in program.functions.iter().enumerate() {
        let decl = function.definition.and_then(|d| tree.function(d));
        let is_whole = !facts.broken.function(FunctionRef(i as u32));
        if is_whole && decl.is_some_and(|d| d.extent.first >= first) {
            for (rule, check) in &functions {
                check(&mut run.context(*rule), FunctionRef(i as u32));
            }
        }
    }
}

/// The first token that the user wrote; what a host puts before is not linted.
fn first_user_token(program: &Program) -> TokenId {
    let tokens = &program.tokens.tokens;
    let is_user = |address: u32| {
        program
            .sources
            .file_at(address)
            .is_some_and(|f| f.role == Role::User)
    };
    tokens.partition_point(|t| !is_user(t.span.start)) as TokenId
}

/// A rule that runs, and how bad its findings are.
#[derive(Clone, Copy)]
struct Active {
    rule: &'static Rule,
    level: Severity,
}

type BinaryCheck = fn(&mut Context, &Binary);
type BuiltinCheck = fn(&mut Context, &Builtin);
type ExprCheck = fn(&mut Context, ExprId);

/// The rules that look at expressions, by what they want.
#[derive(Default)]
struct ExprRules {
    binary: Vec<(Active, BinaryCheck)>,
    builtin: Vec<(Active, BuiltinCheck)>,
    /// By [`Shape`].
    by_shape: [Vec<(Active, ExprCheck)>; Shape::COUNT],
}

struct Run<'a, 'p> {
    program: &'p Program,
    facts: &'a Facts<'p>,
    settings: &'a Settings,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'p> Run<'_, 'p> {
    fn context(&mut self, active: Active) -> Context<'_, 'p> {
        Context {
            program: self.program,
            facts: self.facts,
            settings: self.settings,
            rule: active.rule,
            severity: active.level,
            diagnostics: self.diagnostics,
        }
    }

    fn expr(&mut self, rules: &ExprRules, id: ExprId, expr: &Expr) {
        let Some(shape) = Shape::of(&expr.kind) else {
            return;
        };
        for (rule, check) in rules.by_shape.get(shape as usize).into_iter().flatten() {
            check(&mut self.context(*rule), id);
        }
        match expr.kind {
            ExprKind::Binary(op, left, right) => {
                let binary = Binary {
                    id,
                    op,
                    left,
                    right,
                };
                for (rule, check) in &rules.binary {
                    check(&mut self.context(*rule), &binary);
                }
            }
            ExprKind::Call(_, args) => {
                let program = self.program;
                let Some(function) = program.builtin_called(id) else {
                    return;
                };
                let builtin = Builtin {
                    id,
                    function,
                    args: program.tree.args(args),
                };
                for (rule, check) in &rules.builtin {
                    check(&mut self.context(*rule), &builtin);
                }
            }
            _ => {}
        }
    }
}
