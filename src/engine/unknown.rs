//! How severe it is that a name is not declared in a text which a host may complete.
//!
//! A text is complete where nobody can add to it: then an unknown name is an error. In an open text
//! it is a warning where it looks like a typo and the repository has it nowhere else; all others are
//! listed in one info for the file.

use super::host::Hosts;
use super::part::Part;
use super::reading::code_of;
use super::typo::{Vocabulary, is_typo, variables};
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_host::matches_any;
use shaderlint_semantic::{BuiltinId, Checked, Wholeness};
use shaderlint_text::{Edit, Sources, Span};
use std::cell::LazyCell;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Most names that an info lists.
const MAX_LISTED: usize = 12;

/// The names of a file that its hosts have to declare, each once, with their first uses.
#[derive(Default)]
pub struct Unresolved {
    first: Option<Span>,
    names: BTreeSet<String>,
}

/// Adds the unknown names of a shader to what was found in it, where they are mistakes, and to
/// `unresolved` where they are not sure to be any.
pub fn judge(
    sources: &Arc<Sources>,
    part: &Part,
    checked: &mut Checked,
    hosts: &Hosts,
    unresolved: &mut Unresolved,
) {
    if part.readings.is_shown() {
        return;
    }
    let code = code_of(sources, part.reading().map_or(&[], |r| &r.files));
    let vocabulary = LazyCell::new(|| Vocabulary::of(&code));
    if !checked.program.tokens.undecided.is_empty() {
        report_inactive(checked, &vocabulary, hosts);
    }
    if checked.wholeness == Wholeness::Whole {
        return;
    }
    let mut unknown = checked.open.unknown.clone();
    // What a program puts in has no name here.
    unknown.retain(|d| {
        let word = sources.text(d.span);
        is_word(word) && !matches_any(&part.readings.declared_at_times, word)
    });
    for d in &mut unknown {
        suggest(d, sources.text(d.span), &vocabulary);
    }
    let openness = Openness::of(part, &unknown, |d| {
        let word = sources.text(d.span);
        is_near(d, word) && vocabulary.count(word) == 1
    });
    let (mut mistakes, others): (Vec<Diagnostic>, Vec<Diagnostic>) =
        unknown.into_iter().partition(|d| {
            let word = sources.text(d.span);
            let may_be = openness != Openness::Open || is_near(d, word);
            may_be && !hosts.is_used_outside(word, vocabulary.count(word))
        });
    let named = |d: &Diagnostic| sources.text(d.span).to_string();
    unresolved.first = unresolved.first.or(others.first().map(|d| d.span));
    unresolved.names.extend(others.iter().map(named));
    part.readings
        .confirm(sources, checked.wholeness, &mut mistakes);
    if openness != Openness::Complete {
        let severities = mistakes.iter_mut().map(|d| &mut d.severity);
        severities.for_each(|s| *s = Severity::Warning);
    }
    checked.diagnostics.append(&mut mistakes);
    sort(&mut checked.diagnostics);
}

fn sort(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
}

/// What may be added to a text.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Openness {
    /// Nothing.
    Complete,
    /// Nothing that is known of: it has an entry, and all but one of its names are declared.
    Closed,
    /// Anything.
    Open,
}

impl Openness {
    fn of(part: &Part, unknown: &[Diagnostic], is_typo: impl Fn(&Diagnostic) -> bool) -> Openness {
        let readings = &part.readings;
        if !readings.holds_entry() || readings.has_gaps() || !part.missing.is_empty() {
            return Openness::Open;
        }
        let is_known = match readings.hosts.is_empty() {
            true => part.embedder.hands_over,
            false => readings.are_hosts_complete,
        };
        // A text that lacks nothing but what it misspells asks for no host.
        if is_known || unknown.iter().all(is_typo) {
            Openness::Complete
        } else if unknown.len() == 1 {
            Openness::Closed
        } else {
            Openness::Open
        }
    }
}

/// Looks for what a name was meant to be where the checker has found nothing: what it is declared by
/// may be in code that could not be read.
fn suggest(d: &mut Diagnostic, word: &str, vocabulary: &Vocabulary) {
    if d.fix.is_none() && d.labels.is_empty() {
        d.fix = vocabulary.nearest(word).map(|near| meant(d.span, near));
    }
}

fn meant(span: Span, near: &str) -> Fix {
    let edits = vec![Edit::replace(span, near)];
    Fix::suggestion(format!("did you mean `{near}`?"), edits)
}

/// Reports the typos in groups of `#if` that are left out here and that the host may take.
fn report_inactive(checked: &mut Checked, vocabulary: &Vocabulary, hosts: &Hosts) {
    let program = &checked.program;
    let (sources, tokens) = (&program.sources, &program.tokens);
    let groups = tokens.inactive.iter().filter(|span| {
        let is_open = || tokens.undecided.iter().any(|group| group.contains(**span));
        sources.is_user(span.start) && is_open()
    });
    for group in groups {
        for (at, word) in variables(sources.text(*group)) {
            let is_known = program.names.get(word).is_some()
                || BuiltinId::named(word).is_some()
                || vocabulary.count(word) != 1;
            let near = || vocabulary.nearest(word);
            let Some(near) = (!is_known).then(near).flatten() else {
                continue;
            };
            if hosts.is_used_outside(word, 1) {
                continue;
            }
            let start = group.start + at as u32;
            let span = Span::new(start, start + word.len() as u32);
            let message = format!("`{word}` is not declared");
            let d = Diagnostic::of(error::UNDECLARED_NAME, Severity::Warning, span, message);
            checked.diagnostics.push(d.fix(Some(meant(span, near))));
        }
    }
    sort(&mut checked.diagnostics);
}

fn is_word(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Whether a name looks like a typo of one that is declared, or is declared after all, but not where it
/// is used.
fn is_near(d: &Diagnostic, word: &str) -> bool {
    let near = d.fix.as_ref().and_then(|f| f.edits.first());
    !d.labels.is_empty() || near.is_some_and(|edit| is_typo(word, &edit.text))
}

impl Unresolved {
    /// What there is to report about them.
    pub fn report(self) -> Option<Diagnostic> {
        let count = self.names.len();
        let listed: Vec<String> = self
            .names
            .iter()
            .take(MAX_LISTED)
            .map(|n| format!("`{n}`"))
            .collect();
        let more = count - listed.len();
        let message = match (self.names.first()?, more) {
            (name, _) if count == 1 => format!("`{name}` is not declared here"),
            (_, 0) => format!("{count} names are not declared here: {}", listed.join(", ")),
            (_, more) => format!(
                "{count} names are not declared here: {} and {more} more",
                listed.join(", ")
            ),
        };
        let d = Diagnostic::of(error::UNDECLARED_NAME, Severity::Info, self.first?, message);
        Some(d.note("the host that completes this text has to declare them"))
    }
}
