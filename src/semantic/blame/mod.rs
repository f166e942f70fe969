//! Whose fault an error is.
//!
//! Where a macro's definition or a directive is wrong, the compiler stumbles later: at each call, or
//! at the end of the file. So the repairs that such a line suggests by its own shape are tried, one
//! after the other: the shader is checked again with the repair made, and if errors go away and none
//! comes, the line is at fault. It is then reported once, and the rest of the shader is judged as
//! the repaired one.

mod brackets;
mod call;
pub(super) mod calls;
mod candidate;
mod conditional;
mod definition;
mod literal;
#[cfg(test)]
mod tests;
mod trial;

use super::once::analyze_once;
use super::program::Program;
use super::unit::Unit;
use calls::Calls;
use candidate::Candidate;
use shaderlint_diagnostic::{Diagnostic, Facet};
use shaderlint_syntax::Search;
use shaderlint_text::{Edit, Span};
use trial::Copy;

/// Tokens that the repairs of one shader may read and check.
const MAX_TOKENS: usize = 200_000;
/// What one more trial costs beside its tokens: much is set up for it.
const TRIAL_TOKENS: usize = 1_000;
/// Bytes of text that cost as much as a token: far more than code has, so that neither blanks nor
/// comments count in what is code.
const TOKEN_BYTES: usize = 64;
/// Most repairs of one shader.
const MAX_REPAIRS: u32 = 12;
/// Most errors whose surroundings are looked at.
const MAX_LOOKED_AT: usize = 20;

/// A shader with what was found in it.
struct Case<'a> {
    unit: &'a Unit<'a>,
    program: &'a Program,
    errors: &'a [Diagnostic],
    calls: Calls,
}

/// Finds whose fault the errors of a shader are.
pub(super) fn attribute(
    unit: &Unit,
    program: &Program,
    errors: Vec<Diagnostic>,
    search: &mut Search,
) -> Vec<Diagnostic> {
    let mut errors = search.within(MAX_TOKENS, |search| {
        repair(unit, program, errors, search, MAX_REPAIRS)
    });
    errors.sort_by_key(|d| (d.span.start, d.span.end));
    errors
}

/// Makes the best repair and goes on with the repaired shader; gives what is wrong in all.
fn repair(
    unit: &Unit,
    program: &Program,
    mut errors: Vec<Diagnostic>,
    search: &mut Search,
    left: u32,
) -> Vec<Diagnostic> {
    if errors.is_empty() || left == 0 {
        return errors;
    }
    let case = Case {
        unit,
        program,
        errors: &errors,
        calls: Calls::of(program),
    };
    let Some(chosen) = case.choose(search) else {
        drop_unproved(program, &mut errors);
        return errors;
    };
    let Some(copy) = Copy::new(unit, &chosen.edits) else {
        return errors;
    };
    let repaired = copy.unit(unit);
    let analysis = analyze_once(&repaired, search);
    let after = analysis.diagnostics.clone();
    let gone: Vec<&Diagnostic> = {
        let after: Vec<Diagnostic> = after.iter().map(|d| copy.back(d.clone())).collect();
        let is_gone = |d: &&Diagnostic| !after.iter().any(|a| same(a, d));
        errors.iter().filter(is_gone).collect()
    };
    let told = case.calls.tell(chosen, &gone);
    let rest = repair(&repaired, &analysis.program, after, search, left - 1);
    let mut all: Vec<Diagnostic> = rest.into_iter().map(|d| copy.back(d)).collect();
    all.retain(|d| d.span != told.span);
    all.push(told);
    all
}

/// Whether both speak of the same mistake.
fn same(a: &Diagnostic, b: &Diagnostic) -> bool {
    a.kind == b.kind && a.span.start == b.span.start
}

/// Takes away the fixes of definitions that no trial has proved.
fn drop_unproved(program: &Program, errors: &mut [Diagnostic]) {
    for d in errors {
        let is_foreign = |e: &Edit| calls::is_in_definition(program, e.span);
        if !d.macros.is_empty()
            && d.fix
                .as_ref()
                .is_some_and(|f| f.edits.iter().any(is_foreign))
        {
            d.fix = None;
        }
    }
}

impl Case<'_> {
    /// The repair after which the least is wrong.
    fn choose(&self, search: &mut Search) -> Option<Candidate> {
        // What is copied for a trial and is no token costs, too: a text may be one comment.
        let codes = self.unit.files.iter();
        let codes = codes.filter_map(|&id| self.unit.sources.code(id));
        let bytes: usize = codes.map(|code| code.text.len()).sum();
        let size = self.program.size().max(bytes / TOKEN_BYTES);
        // Where much is wrong a trial takes longer, and proves less.
        let tokens = (size + TRIAL_TOKENS) * (1 + self.errors.len() / 50);
        let faults = |search: &mut Search, candidate: &Candidate, _| {
            let after = self.attempt(&candidate.edits, search)?;
            self.mends(candidate, &after).then_some(after.len())
        };
        let best = search.fewest((usize::MAX, 0), tokens, self.candidates(), faults);
        best.map(|(candidate, _)| candidate)
    }

    /// What is wrong when the edits are made, at the places of the text as it is.
    fn attempt(&self, edits: &[Edit], search: &mut Search) -> Option<Vec<Diagnostic>> {
        let copy = Copy::new(self.unit, edits)?;
        let unit = copy.unit(self.unit);
        let found = analyze_once(&unit, search).diagnostics;
        Some(found.into_iter().map(|d| copy.back(d)).collect())
    }

    /// Whether something goes away, and nothing comes that the repair could have done.
    fn mends(&self, candidate: &Candidate, after: &[Diagnostic]) -> bool {
        let is_gone = |d: &&Diagnostic| !after.iter().any(|a| same(a, d));
        if self.errors.iter().filter(is_gone).count() == 0 {
            return false;
        }
        let is_new = |d: &&Diagnostic| !self.errors.iter().any(|e| same(e, d));
        let mut new = after.iter().filter(is_new).peekable();
        if new.peek().is_none() {
            return true;
        }
        let blamed = candidate.of;
        after.len() <= self.errors.len()
            && new.all(|d| blamed.is_none_or(|of| !self.calls.touches(self.program, of, d)))
    }

    /// The repairs that the lines near the errors suggest, the likeliest first.
    fn candidates(&self) -> Vec<Candidate> {
        let mut all = self.own_fixes();
        all.extend(self.directives());
        all.extend(self.conditionals());
        all.extend(self.broken_calls());
        all.extend(self.definitions());
        all.retain(|c| c.edits.iter().all(|e| self.is_user(e.span)));
        all
    }

    /// The fixes of errors in directives: behind them the shader is what it was meant to be.
    fn own_fixes(&self) -> Vec<Candidate> {
        let in_directive = |d: &&Diagnostic| {
            d.has(Facet::Directive) || calls::is_in_definition(self.program, d.span)
        };
        let found = self.errors.iter().filter(in_directive);
        let candidate = |d: &Diagnostic| {
            let fix = d.fix.as_ref()?;
            let of = d.macros.first().map(|m| m.definition);
            Some(Candidate {
                edits: fix.edits.clone(),
                diagnostic: d.clone(),
                of,
            })
        };
        found.filter_map(candidate).take(MAX_LOOKED_AT).collect()
    }

    fn is_user(&self, span: Span) -> bool {
        self.unit.sources.is_user(span.start)
    }
}
