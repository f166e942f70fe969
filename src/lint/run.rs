//! Runs rules over a shader.

use super::{Binary, Check, Context, Facts, Group, Rule};
use crate::diagnostic::{Diagnostic, ERRORS};
use crate::semantic::{FunctionRef, Program};
use crate::syntax::ast::*;
use crate::text::Role;

/// Which rules run.
#[derive(Clone, Debug)]
pub struct Selection {
    rules: Vec<&'static str>,
}

/// A name that is neither a rule's nor a group's.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownRule {
    /// The name.
    pub name: String,
    /// A rule or group of a name like it.
    pub near: Option<&'static str>,
}

const GROUPS: [Group; 6] = [
    Group::Webgl2,
    Group::Numeric,
    Group::Portability,
    Group::Budget,
    Group::Look,
    Group::Tidy,
];

impl Selection {
    /// The rules that run by default, with those of `select` added and those of `ignore` taken
    /// away. Each word names a rule or a group; `all` names every rule.
    pub fn new(
        rules: &[&'static Rule],
        select: &[String],
        ignore: &[String],
    ) -> Result<Selection, UnknownRule> {
        let mut chosen: Vec<&'static str> =
            rules.iter().filter(|r| r.default).map(|r| r.name).collect();
        for word in select {
            chosen.extend(named(rules, word)?);
        }
        for word in ignore {
            let away = named(rules, word)?;
            chosen.retain(|r| !away.contains(r));
        }
        Ok(Selection { rules: chosen })
    }

    /// No rule but one of those chosen.
    pub fn only(mut self, name: &str) -> Selection {
        self.rules.retain(|r| *r == name);
        self
    }

    fn holds(&self, rule: &Rule) -> bool {
        self.rules.contains(&rule.name)
    }
}

fn named(rules: &[&'static Rule], word: &str) -> Result<Vec<&'static str>, UnknownRule> {
    let found: Vec<&'static str> = rules
        .iter()
        .filter(|r| word == "all" || r.name == word || r.group.name() == word)
        .map(|r| r.name)
        .collect();
    // Compile errors have names too, but cannot be chosen or left out.
    if !found.is_empty() || GROUPS.iter().any(|g| g.name() == word) || ERRORS.contains(&word) {
        return Ok(found);
    }
    let near = rules
        .iter()
        .map(|r| r.name)
        .chain(GROUPS.iter().map(|g| g.name()))
        .map(|n| (strsim::damerau_levenshtein(n, word), n))
        .filter(|(distance, _)| *distance <= 3)
        .min()
        .map(|(_, n)| n);
    Err(UnknownRule {
        name: word.to_string(),
        near,
    })
}

/// Runs the selected rules over a shader without compile errors: one walk over the expressions and
/// one over the statements serve all of them.
pub fn lint(
    program: &Program,
    rules: &[&'static Rule],
    selection: &Selection,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let facts = Facts::new(program);
    let mut run = Run {
        program,
        facts: &facts,
        diagnostics,
    };
    let mut exprs = Vec::new();
    let mut stmts = Vec::new();
    let mut functions = Vec::new();
    for rule in rules.iter().copied().filter(|r| selection.holds(r)) {
        match rule.check {
            Check::Program(check) => check(&mut run.context(rule)),
            Check::Binary(_) | Check::Expr(_) => exprs.push(rule),
            Check::Stmt(check) => stmts.push((rule, check)),
            Check::Function(check) => functions.push((rule, check)),
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
        for rule in &exprs {
            run.expr(rule, ExprId(i as u32), expr);
        }
    }
    for (i, _) in tree
        .stmts
        .iter()
        .enumerate()
        .filter(|(_, s)| s.extent.first >= first)
    {
        for (rule, check) in &stmts {
            check(&mut run.context(rule), StmtId(i as u32));
        }
    }
    for (i, function) in program.functions.iter().enumerate() {
        let decl = function.definition.and_then(|d| tree.function(d));
        if decl.is_some_and(|d| d.extent.first >= first) {
            for (rule, check) in &functions {
                check(&mut run.context(rule), FunctionRef(i as u32));
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

struct Run<'a, 'p> {
    program: &'a Program<'p>,
    facts: &'a Facts<'a, 'p>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'p> Run<'_, 'p> {
    fn context(&mut self, rule: &'static Rule) -> Context<'_, 'p> {
        Context {
            program: self.program,
            facts: self.facts,
            rule,
            severity: rule.severity,
            diagnostics: self.diagnostics,
        }
    }

    fn expr(&mut self, rule: &'static Rule, id: ExprId, expr: &Expr) {
        match (rule.check, expr.kind) {
            (Check::Binary(check), ExprKind::Binary(op, left, right)) => {
                check(
                    &mut self.context(rule),
                    &Binary {
                        id,
                        op,
                        left,
                        right,
                    },
                );
            }
            (Check::Expr(check), _) => check(&mut self.context(rule), id),
            _ => {}
        }
    }
}
