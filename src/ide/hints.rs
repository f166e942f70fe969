//! Inlay hints.

use super::document::Document;
use super::run::RunObservations;
use super::symbol::parameter_names;
use shaderlint_flow::Bound;
use shaderlint_lint::Facts;
use shaderlint_semantic::{Program, Resolution, swizzled};
use shaderlint_syntax::ast::{ExprId, ExprKind, StmtKind, TokenId};
use shaderlint_text::Span;

/// An inlay hint.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hint {
    /// Offset in the document.
    pub offset: u32,
    /// Displayed text.
    pub text: String,
    /// Kind of the hint.
    pub kind: HintKind,
}

/// Kinds of inlay hints.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum HintKind {
    /// Name of a parameter, before its argument.
    Parameter,
    /// Number of iterations, after the head of a loop.
    Iterations,
    /// Type of `?:` or of a swizzle, after the expression.
    Type,
}

/// Which hints are shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct HintOptions {
    /// Whether names of parameters are shown.
    pub parameters: bool,
    /// Whether numbers of iterations are shown.
    pub iterations: bool,
    /// Whether types are shown.
    pub types: bool,
}

/// The hints in a span; `seen` holds the results of sample runs, by shader.
pub fn hints(
    document: &Document,
    within: Span,
    options: HintOptions,
    seen: &[Option<RunObservations>],
) -> Vec<Hint> {
    let mut found = Vec::new();
    for (number, analysis) in document.report.analyses.iter().enumerate() {
        let mut finder = HintFinder {
            document,
            program: &analysis.program,
            within,
            found: &mut found,
        };
        if options.parameters {
            finder.parameters();
        }
        if options.iterations {
            finder.iterations(&analysis.facts(), seen.get(number).and_then(Option::as_ref));
        }
        if options.types {
            finder.types();
        }
    }
    found.sort_by_key(|hint| hint.offset);
    found.dedup();
    found
}

struct HintFinder<'d> {
    document: &'d Document,
    program: &'d Program,
    within: Span,
    found: &'d mut Vec<Hint>,
}

impl HintFinder<'_> {
    /// Adds a hint before or after a token, unless the token comes from a macro.
    fn add(&mut self, token: TokenId, is_after: bool, text: String, kind: HintKind) {
        let token = self.program.token(token).filter(|t| t.is_direct());
        let place = token.map(|t| {
            if is_after {
                t.span.after()
            } else {
                t.span.before()
            }
        });
        let place = place.filter(|p| self.program.sources.is_user(p.start));
        let offset = place.and_then(|p| self.document.report.in_input(p));
        if let Some(offset) = offset.map(|s| s.start)
            && (self.within.start..=self.within.end).contains(&offset)
        {
            self.found.push(Hint { offset, text, kind });
        }
    }

    fn parameters(&mut self) {
        let program = self.program;
        for (expr, id) in program.tree.exprs.iter().zip(0..) {
            let ExprKind::Call(_, list) = expr.kind else {
                continue;
            };
            let Resolution::Function(function) = program.expr(ExprId(id)).resolution else {
                continue;
            };
            let Some(function) = program.function(function).filter(|f| f.params.len() > 1) else {
                continue;
            };
            let names = parameter_names(program, function);
            for (arg, name) in program.tree.args(list).iter().zip(names) {
                // Arguments that are names, and parameters with one letter, need no hint.
                let is_clear = self.is_plain(*arg);
                if is_clear || name.len() < 2 {
                    continue;
                }
                let first = program.tree.expr(*arg).extent.first;
                self.add(first, false, format!("{name}:"), HintKind::Parameter);
            }
        }
    }

    /// Whether an expression is a name, or components of one.
    fn is_plain(&self, expr: ExprId) -> bool {
        match self.program.tree.expr(expr).kind {
            ExprKind::Name(_) => true,
            ExprKind::Member(object, _) => self.is_plain(object),
            _ => false,
        }
    }

    fn iterations(&mut self, facts: &Facts, seen: Option<&RunObservations>) {
        let program = self.program;
        for known in &facts.loops().all {
            let stmt = program.tree.stmt(known.stmt);
            let body = match stmt.kind {
                StmtKind::For { body, .. } | StmtKind::While { body, .. } => body,
                _ => continue,
            };
            let text = match known.bound {
                Bound::Exact(n) if !known.ends_early => format!("× {n}"),
                Bound::Exact(n) | Bound::AtMost(n) => format!("× ≤ {n}"),
                Bound::Ends | Bound::Open => String::new(),
            };
            let seen = seen.and_then(|s| s.loops.get(&known.stmt));
            let seen = seen.map(|observed| format!("sampled: {}", observed.most));
            let all: Vec<String> = [text]
                .into_iter()
                .filter(|t| !t.is_empty())
                .chain(seen)
                .collect();
            // The head of the loop ends before its body.
            let head = program.tree.stmt(body).extent.first.checked_sub(1);
            if let Some(head) = head.filter(|_| !all.is_empty()) {
                self.add(
                    head,
                    true,
                    format!(" {}", all.join(", ")),
                    HintKind::Iterations,
                );
            }
        }
    }

    fn types(&mut self) {
        let program = self.program;
        for (expr, id) in program.tree.exprs.iter().zip(0..) {
            let is_shown = match expr.kind {
                ExprKind::Ternary(..) => true,
                ExprKind::Member(object, name) => swizzled(program, object, name).is_some(),
                _ => false,
            };
            let ty = program.ty(ExprId(id));
            if is_shown && !ty.is_error() && !ty.is_scalar() {
                let text = format!(": {}", program.type_name(ty));
                self.add(expr.extent.last, true, text, HintKind::Type);
            }
        }
    }
}
