//! The macro calls of a shader and the errors they cause.

use super::candidate::RepairCandidate;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix, Label, error};
use shaderlint_semantic::Program;
use shaderlint_syntax::{MacroId, Token};
use shaderlint_text::{Edit, Span};

/// Maximum number of calls labelled in a finding.
const MAX_LABELS: usize = 3;
/// Maximum number of lines between a call and an error that its macro may have caused.
const LINES_AFTER: u32 = 3;

/// Maximum number of calls before an error that are considered.
const MAX_NEAR: usize = 100;

/// All macro calls, with their spans in the user's text.
pub(super) struct MacroCalls {
    /// In source order.
    all: Vec<(Span, MacroId)>,
}

impl MacroCalls {
    pub fn of(program: &Program) -> MacroCalls {
        let expansions = &program.tokens.expansions;
        let mut outer: Vec<Span> = Vec::with_capacity(expansions.len());
        let mut all = Vec::with_capacity(expansions.len());
        for expansion in expansions {
            let parent = match expansion.parent {
                Token::DIRECT => None,
                at => outer.get(at as usize).copied(),
            };
            let call = parent.unwrap_or(expansion.call);
            outer.push(call);
            all.push((call, expansion.definition));
        }
        all.sort_unstable_by_key(|(call, id)| (call.start, call.end, *id));
        all.dedup();
        MacroCalls { all }
    }

    /// The macros called in an error, on its line or shortly before it, nearest last.
    pub fn near(&self, program: &Program, error: Span) -> &[(Span, MacroId)] {
        let Some(file) = program.sources.file_at(error.start) else {
            return &[];
        };
        let line = file.lines().line(error.start - file.base);
        let from = file.lines().start(line.saturating_sub(LINES_AFTER));
        let from = file.base + from.unwrap_or(0);
        let first = self.all.partition_point(|(call, _)| call.start < from);
        let last = self
            .all
            .partition_point(|(call, _)| call.start <= error.start || error.contains(*call));
        self.all.get(first..last).unwrap_or(&[])
    }

    /// Whether a call of the macro named at `of` may have caused an error.
    pub fn touches(&self, program: &Program, of: Span, d: &Diagnostic) -> bool {
        d.macros.iter().any(|m| m.definition == of)
            || self
                .near(program, d.span)
                .iter()
                .rev()
                .take(MAX_NEAR)
                .any(|(_, id)| {
                    let definition = program.tokens.macros.get(id.0 as usize);
                    definition.is_some_and(|m| m.name_span == of)
                })
    }

    /// The diagnostic for a repair that removes these errors, with labels at the affected calls.
    pub fn report(&self, candidate: RepairCandidate, removed: &[&Diagnostic]) -> Diagnostic {
        let mut d = candidate.diagnostic;
        let Some(of) = candidate.of else {
            return d;
        };
        if !d.macros.is_empty() {
            return d;
        }
        let mut places: Vec<Span> = Vec::new();
        for e in removed {
            let through = e.macros.iter().any(|m| m.definition == of);
            let call = match e.macros.last().filter(|_| through) {
                Some(outermost) => Some(outermost.call),
                None => {
                    let last = self.all.partition_point(|(c, _)| c.start <= e.span.start);
                    last.checked_sub(1)
                        .and_then(|i| self.all.get(i))
                        .map(|(c, _)| *c)
                }
            };
            places.extend(call.filter(|c| c.start != d.span.start));
        }
        places.sort_unstable();
        places.dedup();
        let more = places.len().saturating_sub(MAX_LABELS);
        for call in places.into_iter().take(MAX_LABELS) {
            d = d.label(call, "used here");
        }
        if more > 0 {
            d = d.note(more_uses(more));
        }
        d
    }
}

/// Whether a position is inside a macro definition.
pub(super) fn is_in_definition(program: &Program, span: Span) -> bool {
    definition_at(program, span).is_some()
}

/// Name span of the macro in whose definition a position is.
fn definition_at(program: &Program, span: Span) -> Option<Span> {
    let mut all = program.tokens.macros.iter();
    let found = all.find(|m| {
        let end = m.body.last().map_or(m.name_span.end, |p| p.token.span.end);
        !m.predefined && m.name_span.start <= span.start && span.start <= end
    });
    found.map(|m| m.name_span)
}

/// Merges errors at the same position of a macro body. If all calls of the macro fail, the error is
/// reported at the definition, otherwise at the failing calls.
pub(crate) fn gather(program: &Program, errors: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let in_body = |d: &Diagnostic| {
        let outermost = d.macros.last()?.call;
        (!outermost.contains(d.span) && is_in_definition(program, d.span)).then_some(outermost)
    };
    if !errors.iter().any(|d| in_body(d).is_some()) {
        return errors;
    }
    let calls = MacroCalls::of(program);
    let mut out: Vec<Diagnostic> = Vec::new();
    let mut heads: Vec<(usize, Vec<Span>)> = Vec::new();
    for d in errors {
        let Some(call) = in_body(&d) else {
            out.push(d);
            continue;
        };
        let known = heads.iter_mut().find(|(at, _)| {
            out.get(*at)
                .is_some_and(|o| o.kind == d.kind && o.span == d.span)
        });
        match known {
            Some((at, places)) => {
                places.push(call);
                if let Some(first) = out.get_mut(*at) {
                    join_fixes(first, d.fix);
                }
            }
            None => {
                heads.push((out.len(), vec![call]));
                out.push(d);
            }
        }
    }
    for (at, mut places) in heads {
        places.sort_unstable();
        places.dedup();
        let Some(d) = out.get_mut(at) else { continue };
        let used = calls.count(program, d.macros.first().map_or(d.span, |m| m.definition));
        point(program, d, &places, used);
    }
    out
}

/// Adds the fix of the same error in another call. Without it, the error has no fix.
fn join_fixes(first: &mut Diagnostic, other: Option<Fix>) {
    let Some(other) = other else {
        first.fix = None;
        return;
    };
    if let Some(fix) = &mut first.fix {
        let is_new = |edit: &Edit| !fix.edits.contains(edit);
        let more: Vec<Edit> = other.edits.into_iter().filter(is_new).collect();
        fix.edits.extend(more);
        if other.applicability == Applicability::Unsafe {
            fix.applicability = Applicability::Unsafe;
        }
    }
}

impl MacroCalls {
    /// Number of calls of the macro named at `of`.
    fn count(&self, program: &Program, of: Span) -> usize {
        let is_it = |id: &MacroId| {
            let definition = program.tokens.macros.get(id.0 as usize);
            definition.is_some_and(|m| m.name_span == of)
        };
        self.all.iter().filter(|(_, id)| is_it(id)).count()
    }
}

/// Moves the error to the definition or to the calls; `used` is the total number of calls.
fn point(program: &Program, d: &mut Diagnostic, places: &[Span], used: usize) {
    let Some(&first) = places.first() else { return };
    // Names that do not exist are reported once for all uses.
    let once = d.is(error::UNDECLARED_NAME) || d.is(error::LEGACY_GLSL);
    if places.len() < used && !once {
        let body = std::mem::replace(&mut d.span, first);
        d.labels.insert(
            0,
            Label {
                span: body,
                message: std::mem::take(&mut d.label),
            },
        );
        if let Some(l) = d.labels.first_mut().filter(|l| l.message.is_empty()) {
            l.message = "in the macro definition".to_string();
        }
        // An edit of the definition would change the other calls.
        let own = d.macros.first().map(|m| m.definition);
        let is_foreign = |e: &Edit| own.is_some() && definition_at(program, e.span) == own;
        d.fix.take_if(|fix| fix.edits.iter().any(is_foreign));
        for &place in places.iter().skip(1).take(MAX_LABELS - 1) {
            d.labels.push(Label {
                span: place,
                message: "also here".to_string(),
            });
        }
        return;
    }
    for &place in places.iter().take(MAX_LABELS) {
        d.labels.push(Label {
            span: place,
            message: "used here".to_string(),
        });
    }
    if places.len() > MAX_LABELS {
        d.notes.push(more_uses(places.len() - MAX_LABELS));
    }
}

fn more_uses(count: usize) -> String {
    match count {
        1 => "1 more use fails".to_string(),
        _ => format!("{count} more uses fail"),
    }
}
