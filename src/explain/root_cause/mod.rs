//! Root causes of errors.
//!
//! If a macro definition or a directive is wrong, the compiler reports errors later: at each call,
//! or at the end of the file. So the repairs suggested by such lines are tried one after the other:
//! the shader is checked again with the repair, and if errors disappear and no new ones appear, the
//! line is the cause. It is reported once, and the rest of the shader is checked in its repaired
//! form.

mod brackets;
mod call;
pub(super) mod calls;
mod candidate;
mod choice;
mod conditional;
mod consequences;
mod declaration;
mod definition;
mod edited;
mod literal;
mod missing;
#[cfg(test)]
mod tests;
mod text;

use super::single_pass::analyze_single_pass;
use calls::MacroCalls;
use candidate::{RepairCandidate, same};
use edited::EditedUnit;
use missing::Knowledge;
use shaderlint_diagnostic::{Diagnostic, Facet, error};
use shaderlint_semantic::{Program, Unit};
use shaderlint_syntax::Search;
use shaderlint_text::{Edit, Span};

/// Total tokens that the repairs of one shader may parse and check.
const MAX_TOKENS: usize = 200_000;
/// Fixed cost of a trial in tokens, for its setup.
const CHECK_TOKENS: usize = 1_000;
/// Number of bytes that cost as much as one token; large enough that whitespace and comments in
/// ordinary code do not matter.
const TOKEN_BYTES: usize = 64;
/// Maximum number of repairs per shader.
const MAX_REPAIRS: u32 = 12;
/// Maximum number of edits of a fix that are compared with other errors.
const MAX_EDITS: usize = 100;
/// Maximum number of errors for which nearby lines are examined.
const MAX_LOOKED_AT: usize = 20;

/// A shader and its errors.
struct FaultyShader<'a> {
    unit: &'a Unit<'a>,
    program: &'a Program,
    errors: &'a [Diagnostic],
    calls: MacroCalls,
}

/// Attributes the errors of a shader to their root causes.
pub(super) fn attribute(
    unit: &Unit,
    program: &Program,
    errors: Vec<Diagnostic>,
    search: &mut Search,
) -> Vec<Diagnostic> {
    let mut errors = search.within(MAX_TOKENS, |search| declared(unit, program, errors, search));
    errors.sort_by_key(|d| (d.span.start, d.span.end));
    consequences::keep_causes(program, &mut errors);
    consequences::keep_end(program, &mut errors);
    // A name with an invalid character, or a reserved word, is one mistake.
    let is_named = |d: &Diagnostic| d.is(error::INVALID_CHARACTER) || d.is(error::RESERVED_WORD);
    let named: Vec<Span> = errors
        .iter()
        .filter(|d| is_named(d))
        .map(|d| d.span)
        .collect();
    errors.retain(|d| !d.is(error::UNDECLARED_NAME) || named.binary_search(&d.span).is_err());
    errors
}

/// Declares the names that are missing and repairs the shader in which they are known; returns all
/// findings.
fn declared(
    unit: &Unit,
    program: &Program,
    errors: Vec<Diagnostic>,
    search: &mut Search,
) -> Vec<Diagnostic> {
    let found = missing::declare(unit, program, &errors, Knowledge::Meaning, search);
    let copy = EditedUnit::new(unit, &found.edits).filter(|_| !found.reported.is_empty());
    let Some(copy) = copy else {
        return repair(unit, program, errors, search, MAX_REPAIRS);
    };
    let declared = copy.unit(unit);
    let analysis = analyze_single_pass(&declared, search);
    let (program, errors) = (&analysis.program, analysis.diagnostics);
    let rest = repair(&declared, program, errors, search, MAX_REPAIRS);
    let mut all: Vec<Diagnostic> = rest.into_iter().map(|d| copy.back(d)).collect();
    all.extend(found.reported);
    all
}

/// Adds declarations as fixes of names of which only the uses are known: these are guesses, which prove
/// nothing about other errors. A name that lacks one declaration is one error.
fn with_guesses(
    unit: &Unit,
    program: &Program,
    mut errors: Vec<Diagnostic>,
    search: &mut Search,
) -> Vec<Diagnostic> {
    let found = missing::declare(unit, program, &errors, Knowledge::Uses, search).reported;
    let name = |d: &Diagnostic| program.sources.text(d.span);
    let is_declared = |d: &Diagnostic| {
        d.is(error::UNDECLARED_NAME) && found.iter().any(|other| name(other) == name(d))
    };
    errors.retain(|d| !is_declared(d));
    errors.extend(found);
    errors
}

/// Applies the best repair and continues with the repaired shader; returns all findings.
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
    let case = FaultyShader {
        unit,
        program,
        errors: &errors,
        calls: MacroCalls::of(program),
    };
    let Some(chosen) = case.choose(search) else {
        drop_unproved(program, &mut errors);
        return with_guesses(unit, program, errors, search);
    };
    let Some(copy) = EditedUnit::new(unit, &chosen.edits) else {
        return errors;
    };
    let repaired = copy.unit(unit);
    let analysis = analyze_single_pass(&repaired, search);
    let after = analysis.diagnostics.clone();
    let removed: Vec<&Diagnostic> = {
        let after: Vec<Diagnostic> = after.iter().map(|d| copy.back(d.clone())).collect();
        let is_fixed = |d: &&Diagnostic| !after.iter().any(|a| same(a, d));
        errors.iter().filter(is_fixed).collect()
    };
    let reported = case.calls.report(chosen, &removed);
    let rest = repair(&repaired, &analysis.program, after, search, left - 1);
    let mut all: Vec<Diagnostic> = rest.into_iter().map(|d| copy.back(d)).collect();
    all.retain(|d| d.span != reported.span);
    all.push(reported);
    all
}

/// Whether an error is about a word, however the code around it is parsed.
fn is_about_a_word(d: &Diagnostic) -> bool {
    let kinds = [
        error::UNDECLARED_NAME,
        error::UNKNOWN_TYPE,
        error::SWIZZLE_OUT_OF_RANGE,
    ];
    kinds.into_iter().any(|kind| d.is(kind))
}

/// Removes fixes inside macro definitions that no trial has confirmed.
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

impl FaultyShader<'_> {
    /// The repair that leaves the fewest errors.
    fn choose(&self, search: &mut Search) -> Option<RepairCandidate> {
        // Text that is copied for a trial but contains no tokens has a cost too: a file may be one
        // comment.
        let codes = self.unit.files.iter();
        let codes = codes.filter_map(|&id| self.unit.sources.code(id));
        let bytes: usize = codes.map(|code| code.text.len()).sum();
        let size = self.program.size().max(bytes / TOKEN_BYTES);
        // With many errors, a trial takes longer and proves less.
        let tokens = (size + CHECK_TOKENS) * (1 + self.errors.len() / 50);
        let faults = |search: &mut Search, candidate: &RepairCandidate, _| {
            let after = self.errors_after(&candidate.edits, search)?;
            self.is_repair(candidate, &after).then_some(after.len())
        };
        let best = search.fewest((usize::MAX, 0), tokens, self.candidates(), faults);
        best.map(|(candidate, _)| candidate)
    }

    /// The findings with the edits applied, mapped to positions in the original text.
    fn errors_after(&self, edits: &[Edit], search: &mut Search) -> Option<Vec<Diagnostic>> {
        let copy = EditedUnit::new(self.unit, edits)?;
        let unit = copy.unit(self.unit);
        let found = analyze_single_pass(&unit, search).diagnostics;
        Some(found.into_iter().map(|d| copy.back(d)).collect())
    }

    /// Whether an error disappears and none appears that the repair may have caused.
    fn is_repair(&self, candidate: &RepairCandidate, after: &[Diagnostic]) -> bool {
        let is_fixed = |d: &&Diagnostic| !after.iter().any(|a| same(a, d));
        if self.errors.iter().filter(is_fixed).count() == 0 {
            return false;
        }
        if candidate.must_reduce && after.len() >= self.errors.len() {
            return false;
        }
        let is_new = |d: &&Diagnostic| !self.errors.iter().any(|e| same(e, d));
        // Code that does not parse is not checked, which hides the other errors in it.
        let is_edited = |d: &&Diagnostic| candidate.edits.iter().any(|e| e.span.touches(d.span));
        let unparsed = |of: &[Diagnostic]| of.iter().filter(|d| d.has(Facet::Grammar)).count();
        let mut hidden = self.errors.iter().filter(|d| !is_edited(d) && is_fixed(d));
        let is_unparsed = |d: &&Diagnostic| is_new(d) && d.has(Facet::Grammar);
        let is_own = |d: &Diagnostic| is_new(&d) && is_edited(&d);
        if candidate.must_reduce && after.iter().any(is_own)
            || unparsed(after) > unparsed(self.errors)
            || after.iter().any(|d| is_unparsed(&d)) && hidden.any(is_about_a_word)
        {
            return false;
        }
        let mut new = after.iter().filter(is_new).peekable();
        if new.peek().is_none() {
            return true;
        }
        let cause = candidate.of;
        let call = |d: &Diagnostic| d.macros.last().map(|outermost| outermost.call);
        let is_revealed = |d: &Diagnostic| {
            call(&candidate.diagnostic)
                .is_some_and(|fixed| call(d) == Some(fixed) || self.is_unchecked(fixed, d.span))
        };
        let is_other =
            |d: &Diagnostic| cause.is_none_or(|of| !self.calls.touches(self.program, of, d));
        after.len() <= self.errors.len() && new.all(|d| is_revealed(d) || is_other(d))
    }

    /// Whether code is in an expression without a type that a macro call is in: the rest of an expression is
    /// checked once its operands have a type.
    fn is_unchecked(&self, call: Span, code: Span) -> bool {
        let exprs = self.program.tree.exprs.iter().zip(&self.program.exprs);
        let mut untyped = exprs.filter(|(_, info)| info.ty.is_error());
        untyped.any(|(expr, _)| {
            let span = self.program.span(expr.extent);
            span.contains(call) && span.contains(code)
        })
    }

    /// The repairs suggested by the lines near the errors, most likely first.
    fn candidates(&self) -> Vec<RepairCandidate> {
        let mut all = self.own_fixes();
        all.extend(self.shared_fixes());
        all.extend(self.directives());
        all.extend(self.conditionals());
        all.extend(self.broken_calls());
        all.extend(self.definitions());
        all.extend(self.macro_fixes());
        all.extend(self.declarations());
        all.extend(self.choices());
        all.extend(self.text_repairs());
        all.extend(self.lost_types());
        all.retain(|c| c.edits.iter().all(|e| self.is_user(e.span)));
        all
    }

    /// The fixes of errors in directives.
    fn own_fixes(&self) -> Vec<RepairCandidate> {
        let in_directive = |d: &&Diagnostic| {
            let is_number = d.is(error::INT_FLOAT_MIX);
            let is_inside = || calls::is_in_definition(self.program, d.span);
            d.has(Facet::Directive) || !is_number && is_inside()
        };
        self.fixes_of(in_directive)
    }

    /// The fixes that edit macros.
    fn macro_fixes(&self) -> Vec<RepairCandidate> {
        let is_edited = |e: &Edit| calls::is_in_definition(self.program, e.span);
        let edits_macro = |d: &&Diagnostic| {
            let mut fix = d.fix.iter();
            fix.any(|fix| fix.edits.iter().take(MAX_EDITS).any(is_edited))
        };
        self.fixes_of(edits_macro)
    }

    /// The fixes of some errors.
    fn fixes_of(&self, is_meant: impl Fn(&&Diagnostic) -> bool) -> Vec<RepairCandidate> {
        let found = self.errors.iter().filter(is_meant);
        let candidate = |d: &Diagnostic| {
            let fix = d.fix.clone()?;
            let of = d.macros.first().map(|m| m.definition);
            Some(RepairCandidate {
                of,
                ..RepairCandidate::new(d.clone(), fix)
            })
        };
        found.filter_map(candidate).take(MAX_LOOKED_AT).collect()
    }

    /// The fixes that edit what other errors are about as well.
    fn shared_fixes(&self) -> Vec<RepairCandidate> {
        let looked_at = || self.errors.iter().take(MAX_LOOKED_AT);
        let mut all: Vec<RepairCandidate> = Vec::new();
        for d in looked_at() {
            let Some(fix) = &d.fix else { continue };
            let edits = || fix.edits.iter().take(MAX_EDITS);
            let is_other =
                |o: &&Diagnostic| o.span != d.span && edits().any(|e| e.span.touches(o.span));
            if edits().count() > 1 && looked_at().any(|o| is_other(&o)) {
                all.push(RepairCandidate::of_error(d, fix.clone()));
            }
        }
        all
    }

    fn is_user(&self, span: Span) -> bool {
        self.unit.sources.is_user(span.start)
    }
}
