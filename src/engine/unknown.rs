//! How severe it is that a name is not declared in a text which a host may complete.
//!
//! A text is complete where nobody can add to it: then an unknown name is an error. In an open text
//! it is a warning where it looks like a typo and the repository has it nowhere else; all others are
//! listed in one info for the file.

use super::host::Hosts;
use super::part::Part;
use super::reading::code_of;
use super::repository::words;
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_semantic::{Checked, Wholeness};
use shaderlint_text::{Sources, Span};
use std::collections::BTreeSet;

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
    sources: &Sources,
    part: &Part,
    checked: &mut Checked,
    hosts: &Hosts,
    unresolved: &mut Unresolved,
) {
    if checked.wholeness == Wholeness::Whole || part.readings.is_shown() {
        return;
    }
    let mut unknown = std::mem::take(&mut checked.open.unknown);
    // What a program puts in has no name here.
    unknown.retain(|d| is_word(sources.text(d.span)));
    let code = code_of(sources, part.reading().map_or(&[], |r| &r.files));
    let standing = Standing::of(part, &unknown, |d| is_typo(d, sources.text(d.span), &code));
    for mut d in unknown {
        let word = sources.text(d.span);
        let may_be = standing != Standing::Open || is_near(&d, word);
        if !may_be || is_used_outside(word, &code, hosts) {
            unresolved.first = unresolved.first.or(Some(d.span));
            unresolved.names.insert(word.to_string());
            continue;
        }
        if standing != Standing::Complete {
            d.severity = Severity::Warning;
        }
        checked.diagnostics.push(d);
    }
    let place = |d: &Diagnostic| (d.span.start, d.span.end);
    checked.diagnostics.sort_by_key(place);
}

/// What may be added to a text.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Standing {
    /// Nothing.
    Complete,
    /// Nothing that is known of: it has an entry, and all but one of its names are declared.
    Closed,
    /// Anything.
    Open,
}

impl Standing {
    fn of(part: &Part, unknown: &[Diagnostic], is_typo: impl Fn(&Diagnostic) -> bool) -> Standing {
        let readings = &part.readings;
        if !readings.holds_entry() || readings.has_gaps() || !part.missing.is_empty() {
            return Standing::Open;
        }
        let is_known = match readings.hosts.is_empty() {
            true => part.embedder.hands_over,
            false => readings.are_hosts_complete,
        };
        // A text that lacks nothing but what it misspells asks for no host.
        if is_known || unknown.iter().all(is_typo) {
            Standing::Complete
        } else if unknown.len() == 1 {
            Standing::Closed
        } else {
            Standing::Open
        }
    }
}

/// Whether a name is one that is declared, misspelt once.
fn is_typo(d: &Diagnostic, word: &str, code: &str) -> bool {
    is_near(d, word) && words(code).filter(|w| *w == word).count() == 1
}

fn is_word(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Whether a name is within two edits of one that is declared, or is declared after all, but not
/// where it is used. Numbers tell names apart on purpose, and in short names so does each letter.
fn is_near(d: &Diagnostic, word: &str) -> bool {
    const SHORTEST: usize = 4;
    let near = d.fix.as_ref().and_then(|f| f.edits.first());
    let is_typo_of = |near: &str| {
        let stem = |w: &str| w.trim_matches(|c: char| c.is_ascii_digit()).to_string();
        let lower = |w: &str| w.to_ascii_lowercase();
        near.len().max(word.len()) >= SHORTEST
            && strsim::damerau_levenshtein(&lower(near), &lower(word)) <= 2
            && stem(near) != stem(word)
    };
    !d.labels.is_empty() || near.is_some_and(|edit| is_typo_of(&edit.text))
}

/// Whether a name is used outside of the text that lacks it: in the script around it, or in another
/// file of its repository.
fn is_used_outside(word: &str, code: &str, hosts: &Hosts) -> bool {
    let count = |text: &str| words(text).filter(|w| *w == word).count();
    let around = hosts.script().map_or(0, count);
    around > count(code) || hosts.is_beside(word)
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
