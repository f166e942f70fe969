//! Runs rules over a shader.

use super::absorb::absorb;
use super::broken::{Broken, Obstacles};
use super::context::Context;
use super::facts::Facts;
use super::rule::{BinaryExpr, Builtin, Check, DeclaredName, DeclaredVariable, Named, Rule, Shape};
use super::settings::Settings;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_syntax::Macro;
use shaderlint_syntax::ast::*;
use shaderlint_text::{Role, Span};
use std::sync::Arc;

/// Where rules did not run because of errors.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub enum SkippedRules {
    /// They ran everywhere.
    #[default]
    Nowhere,
    /// In these functions.
    Functions {
        /// Their names.
        names: Vec<String>,
        /// Spans that were skipped, in the order of the text.
        broken: Vec<Span>,
    },
    /// In the whole shader.
    Everywhere,
}

/// Runs the selected rules over a shader, in one walk over the expressions and one over the statements.
pub fn lint(
    program: &Program,
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let facts = Facts::of(program, &Arc::default());
    lint_within(facts, Obstacles::default(), rules, settings, diagnostics);
}

/// Runs the selected rules over the shader of `facts`, except for items with an obstacle. Returns where
/// they did not run.
pub fn lint_within(
    mut facts: Facts,
    obstacles: Obstacles,
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) -> SkippedRules {
    let program = facts.program();
    facts.samples.supplier = facts.around.supplier;
    facts.samples.limit = settings.sample_limit();
    facts.break_at(obstacles);
    if facts.broken.is_everything {
        return SkippedRules::Everywhere;
    }
    let before = diagnostics.len();
    let mut found = Vec::new();
    walk(program, &facts, rules, settings, &mut found);
    absorb(program, &mut found);
    diagnostics.append(&mut found);
    if !facts.broken.any() {
        return SkippedRules::Nowhere;
    }
    let mut at = 0;
    diagnostics.retain(|d| {
        at += 1;
        at <= before || facts.broken.admits(program, d)
    });
    SkippedRules::Functions {
        names: broken_functions(program, &facts.broken),
        broken: facts.broken.spans(),
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

/// Runs the rules over the user's text.
fn walk<'p>(
    program: &'p Program,
    facts: &Facts<'p>,
    rules: &[&'static Rule],
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let checks = Checks::of(rules, settings);
    let mut run = RuleRun {
        program,
        facts,
        settings,
        diagnostics,
    };
    run.each(&checks.program, |check, cx| check(cx));
    run.names(&checks);
    run.macros(&checks);
    let first = first_user_token(program);
    run.declarations(&checks, first);
    let tree = &program.tree;
    for (expr, i) in tree.exprs.iter().zip(0..) {
        if expr.extent.first >= first {
            run.expr(&checks, ExprId(i), expr);
        }
    }
    for (stmt, i) in tree.stmts.iter().zip(0..) {
        if stmt.extent.first >= first {
            run.each(&checks.stmt, |check, cx| check(cx, StmtId(i)));
        }
    }
    for (function, i) in program.functions.iter().zip(0..) {
        let decl = function.definition.and_then(|d| tree.function(d));
        let is_complete = !facts.broken.function(FunctionRef(i));
        if is_complete && decl.is_some_and(|d| d.extent.first >= first) {
            run.each(&checks.function, |check, cx| check(cx, FunctionRef(i)));
        }
    }
    run.each(&checks.run, |check, cx| check(cx));
}

/// The first token of the user's text; code that a host adds before it is not linted.
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

/// A rule that runs, and the severity of its findings.
#[derive(Clone, Copy)]
struct Active {
    rule: &'static Rule,
    level: Severity,
}

type OnProgram = fn(&mut Context);
type OnBinary = fn(&mut Context, &BinaryExpr);
type OnBuiltin = fn(&mut Context, &Builtin);
type OnExpr = fn(&mut Context, ExprId);
type OnStmt = fn(&mut Context, StmtId);
type OnFunction = fn(&mut Context, FunctionRef);
type OnDeclaration = fn(&mut Context, &DeclaredVariable);
type OnName = fn(&mut Context, &DeclaredName);
type OnMacro = fn(&mut Context, &Macro);

/// The checks of the rules that run, by kind.
#[derive(Default)]
struct Checks {
    program: Vec<(Active, OnProgram)>,
    binary: Vec<(Active, OnBinary)>,
    builtin: Vec<(Active, OnBuiltin)>,
    /// By [`Shape`].
    by_shape: [Vec<(Active, OnExpr)>; Shape::COUNT],
    stmt: Vec<(Active, OnStmt)>,
    function: Vec<(Active, OnFunction)>,
    declaration: Vec<(Active, OnDeclaration)>,
    name: Vec<(Active, OnName)>,
    macros: Vec<(Active, OnMacro)>,
    run: Vec<(Active, OnProgram)>,
}

impl Checks {
    fn of(rules: &[&'static Rule], settings: &Settings) -> Checks {
        let mut checks = Checks::default();
        for &rule in rules {
            let Some(level) = settings.level(rule) else {
                continue;
            };
            let active = Active { rule, level };
            for check in rule.checks {
                checks.add(active, *check);
            }
        }
        checks
    }

    fn add(&mut self, rule: Active, check: Check) {
        match check {
            Check::Program(check) => self.program.push((rule, check)),
            Check::Binary(check) => self.binary.push((rule, check)),
            Check::Builtin(check) => self.builtin.push((rule, check)),
            Check::Expr(shapes, check) => {
                for &shape in shapes {
                    if let Some(all) = self.by_shape.get_mut(shape as usize) {
                        all.push((rule, check));
                    }
                }
            }
            Check::Stmt(check) => self.stmt.push((rule, check)),
            Check::Function(check) => self.function.push((rule, check)),
            Check::Declaration(check) => self.declaration.push((rule, check)),
            Check::Name(check) => self.name.push((rule, check)),
            Check::Macro(check) => self.macros.push((rule, check)),
            Check::Run(check) => self.run.push((rule, check)),
            Check::Allows | Check::Page => {}
        }
    }
}

struct RuleRun<'a, 'p> {
    program: &'p Program,
    facts: &'a Facts<'p>,
    settings: &'a Settings,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'p> RuleRun<'_, 'p> {
    /// Runs some checks, each as its rule.
    fn each<C: Copy>(&mut self, checks: &[(Active, C)], run: impl Fn(C, &mut Context<'_, 'p>)) {
        let Some((first, _)) = checks.first() else {
            return;
        };
        let mut cx = Context {
            program: self.program,
            facts: self.facts,
            settings: self.settings,
            rule: first.rule,
            severity: first.level,
            diagnostics: self.diagnostics,
        };
        for (active, check) in checks {
            cx.rule = active.rule;
            cx.severity = active.level;
            run(*check, &mut cx);
        }
    }

    fn expr(&mut self, checks: &Checks, id: ExprId, expr: &Expr) {
        let Some(shape) = Shape::of(&expr.kind) else {
            return;
        };
        let of_shape = checks.by_shape.get(shape as usize);
        self.each(of_shape.map_or(&[], Vec::as_slice), |check, cx| {
            check(cx, id);
        });
        match expr.kind {
            ExprKind::Binary(op, left, right) => {
                let binary = BinaryExpr {
                    id,
                    op,
                    left,
                    right,
                };
                self.each(&checks.binary, |check, cx| check(cx, &binary));
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
                self.each(&checks.builtin, |check, cx| check(cx, &builtin));
            }
            _ => {}
        }
    }

    fn declarations(&mut self, checks: &Checks, first: TokenId) {
        let tree = &self.program.tree;
        let locals = tree.stmts.iter().zip(0..);
        let locals = locals.filter_map(|(stmt, i)| match stmt.kind {
            StmtKind::Decl(decl) => Some((decl, Some(StmtId(i)))),
            _ => None,
        });
        let globals = tree.items.iter().filter_map(|item| match *item {
            Item::Decl(decl) => Some((decl, None)),
            _ => None,
        });
        for (decl, stmt) in locals.chain(globals) {
            if tree.decl(decl).is_some_and(|d| d.extent.first >= first) {
                self.declaration(checks, decl, stmt);
            }
        }
    }

    fn declaration(&mut self, checks: &Checks, decl: DeclId, stmt: Option<StmtId>) {
        let program = self.program;
        let Some(decl) = program.tree.decl(decl) else {
            return;
        };
        let DeclKind::Variables {
            qualifiers,
            ty,
            declarators,
        } = decl.kind
        else {
            return;
        };
        let declared = program.declared.get(declarators.start as usize..);
        let all = program.tree.declarators(declarators);
        for (index, variable) in declared.unwrap_or(&[]).iter().take(all.len()).enumerate() {
            let Some(variable) = *variable else { continue };
            let declaration = DeclaredVariable {
                variable,
                declarators: all,
                index,
                qualifiers,
                ty,
                extent: decl.extent,
                stmt,
            };
            self.each(&checks.declaration, |check, cx| check(cx, &declaration));
        }
    }

    fn names(&mut self, checks: &Checks) {
        if checks.name.is_empty() {
            return;
        }
        for name in declared_names(self.program) {
            self.each(&checks.name, |check, cx| check(cx, &name));
        }
    }

    fn macros(&mut self, checks: &Checks) {
        let program = self.program;
        for definition in &program.tokens.macros {
            if program.is_user(definition.name_span) {
                self.each(&checks.macros, |check, cx| check(cx, definition));
            }
        }
    }
}

/// The names that the user's text declares, in order.
pub(super) fn declared_names(program: &Program) -> Vec<DeclaredName<'_>> {
    let tree = &program.tree;
    let variables = program.variables.iter().zip(0..);
    let variables = variables.filter_map(|(v, i)| Some((v.token?, Named::Variable(VariableId(i)))));
    let functions = program.functions.iter().zip(0..).filter_map(|(f, i)| {
        let decl = tree.function(f.declaration)?;
        Some((decl.ident.token, Named::Function(FunctionRef(i))))
    });
    let structs = tree.structs.iter();
    let structs = structs.filter_map(|s| Some((s.name?.token, Named::Struct)));
    let all = variables.chain(functions).chain(structs);
    let mut names: Vec<DeclaredName> = all
        .filter_map(|(id, what)| {
            let token = program.token(id)?;
            let is_own = token.is_direct() && program.is_user(token.span);
            is_own.then(|| DeclaredName {
                token: id,
                text: program.sources.text(token.span),
                what,
            })
        })
        .collect();
    names.sort_by_key(|n| n.token);
    names.dedup_by_key(|n| n.token);
    names
}
