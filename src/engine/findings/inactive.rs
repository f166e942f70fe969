//! Mistakes in code that `#if` excludes because a macro is not defined, which a host or a user of
//! the shader may define.
//!
//! The shader is checked again with such macros defined. A mistake is reported if it occurs both
//! with all macros that can be defined together and with only those that its branch needs, whatever
//! other groups select.

use super::stage::ShaderCheck;
use crate::shader::assumption::{AssumedMacros, BranchNeeds};
use crate::shader::reading::Readings;
use crate::shader::shader_input::ShaderInput;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Applicability, Certainty, Diagnostic, Severity};
use shaderlint_semantic::Program;
use shaderlint_syntax::ast::TokenId;
use shaderlint_syntax::{RawItem, RawKind, raw_items, tokenize};
use shaderlint_text::{Sources, Span};
use std::sync::Arc;

/// Maximum number of further checks to find mistakes.
const MOST_CHECKS: usize = 8;
/// Maximum number of further checks to confirm them.
const MOST_CONFIRMED: usize = 8;

/// Adds the mistakes in excluded code to the findings of a shader without errors, as warnings.
pub fn report(shader: &mut ShaderCheck) {
    let (sources, part, checked) = (shader.sources, shader.part, &mut shader.checked);
    if part.readings.is_shown() || checked.open.is_torn {
        return;
    }
    if checked.has_errors() || checked.program.tokens.inactive.is_empty() {
        return;
    }
    let files = part.reading().map_or(&[][..], |reading| &reading.files);
    let branches = BranchNeeds::of(sources, files, &checked.program);
    let mut left = branches.excluded();
    let mut found: Vec<Diagnostic> = Vec::new();
    for _ in 0..MOST_CHECKS {
        let mut together = AssumedMacros::default();
        left.retain(|needs| !together.join(needs));
        if together.is_empty() {
            break;
        }
        found.extend(mistakes(sources, part, &checked.program, &together));
    }
    let mut reported: FxHashSet<Span> = FxHashSet::default();
    found.retain(|d| reported.insert(d.span));
    let mut confirmed: Vec<(&AssumedMacros, Vec<Diagnostic>)> = Vec::new();
    for mut d in found {
        let Some(needs) = branches.at(d.span.start) else {
            continue;
        };
        let known = confirmed.iter().position(|(known, _)| *known == needs);
        if known.is_none() && confirmed.len() < MOST_CONFIRMED {
            confirmed.push((needs, mistakes(sources, part, &checked.program, needs)));
        }
        let at = known.unwrap_or(confirmed.len().saturating_sub(1));
        let again = confirmed.get(at).filter(|(known, _)| *known == needs);
        let is_again = |o: &Diagnostic| o.span == d.span && o.message == d.message;
        if again.is_some_and(|(_, all)| all.iter().any(is_again)) {
            d.severity = Severity::Warning;
            d.notes.push(format!("an error if {needs}"));
            // Fixes there are not verified.
            if let Some(fix) = &mut d.fix {
                fix.applicability = Applicability::Unsafe;
            }
            checked.diagnostics.push(d);
        }
    }
    let key = |d: &Diagnostic| (d.span.start, d.span.end);
    checked.diagnostics.sort_by_key(key);
}

/// The errors in code that a shader excludes, if these macros are defined.
fn mistakes(
    sources: &Arc<Sources>,
    part: &ShaderInput,
    program: &Program,
    assumed: &AssumedMacros,
) -> Vec<Diagnostic> {
    let mut sources = Sources::clone(sources);
    let Some(readings) = part
        .readings
        .with_macros(&mut sources, &assumed.definitions())
        .map(Readings::into_parts)
    else {
        return Vec::new();
    };
    let read = readings.check(&Arc::new(sources), part.infer_channels);
    let Some(read) = read.filter(|read| !read.open.is_torn) else {
        return Vec::new();
    };
    let mut found = read.diagnostics;
    found.retain(|d| d.severity == Severity::Error && is_inactive(program, d.span));
    if !found.is_empty() {
        let of_host = names_of_host(&read.program);
        found.retain(|d| {
            let is_syntax = d.certainty() == Certainty::Syntax;
            let mut words = statement(&read.program, d.span).into_iter();
            !words.any(|word| assumed.replaces(word, is_syntax) || of_host.contains(word))
        });
    }
    found
}

/// The functions, structs and members that a host declares: it may declare them differently with
/// other macros.
fn names_of_host(program: &Program) -> FxHashSet<&str> {
    let is_own = |token: TokenId| {
        let token = program.token(token);
        token.is_some_and(|t| program.sources.is_user(t.spelled))
    };
    let functions = program.functions.iter().filter(|f| {
        let declared = program.tree.function(f.declaration);
        !declared.is_some_and(|d| is_own(d.ident.token))
    });
    let functions = functions.map(|f| f.name);
    let structs = program.structs.iter().filter(|s| !is_own(s.token));
    let members = structs.flat_map(|s| s.fields.iter().map(|f| f.name).chain(s.name));
    let names = functions.chain(members);
    names.map(|name| program.names.text(name)).collect()
}

/// The words of the statement around a span, without directives.
fn statement(program: &Program, span: Span) -> Vec<&str> {
    let Some(code) = program.sources.code_at(span.start) else {
        return Vec::new();
    };
    let ends = [';', '{', '}'];
    let before = code.text.get(..(span.start - code.base) as usize);
    let start = before.and_then(|b| b.rfind(ends)).map_or(0, |at| at + 1);
    let after = (span.end - code.base) as usize;
    let end = code.text.get(after..).and_then(|rest| rest.find(ends));
    let end = end.map_or(code.text.len(), |at| after + at);
    let text = code.text.get(start..end).unwrap_or("");
    let tokens = tokenize(text, 0);
    let items = raw_items(&tokens).into_iter();
    let words = items.filter_map(|item| match item {
        RawItem::Token(t) if t.kind == RawKind::Word => {
            text.get(t.span.start as usize..t.span.end as usize)
        }
        _ => None,
    });
    words.collect()
}

/// Whether a shader does not compile the code at a span.
fn is_inactive(program: &Program, span: Span) -> bool {
    program.tokens.inactive.iter().any(|s| s.contains(span))
}
