//! What keeps two shaders from being linked, and where it stands.

use super::compare::{Difference, Differing};
use super::interface::Interface;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, error};
use shaderlint_syntax::ast::TokenId;
use shaderlint_text::Span;

/// Most errors that are looked for between two shaders.
pub const MAX_ERRORS: usize = 200;

/// What was found.
#[derive(Default)]
pub struct LinkErrors {
    pub diagnostics: Vec<Diagnostic>,
    /// Places that an error stands at: each mistake is told once.
    pub told: FxHashSet<Span>,
}

impl LinkErrors {
    /// Whether so much is wrong that looking on is of no use.
    pub fn is_full(&self) -> bool {
        self.diagnostics.len() >= MAX_ERRORS
    }

    /// Reports what two places say differently: at the first that the user wrote. Gives the
    /// diagnostic, so that more can be said; `None` where it was told before.
    pub fn differ(
        &mut self,
        rule: ErrorKind,
        message: String,
        first: LinkSite,
        second: LinkSite,
    ) -> Option<&mut Diagnostic> {
        let is_hosts = |p: &LinkSite| p.interface.is_hosts(p.token);
        let (at, other) = if is_hosts(&first) {
            (second, first)
        } else {
            (first, second)
        };
        if is_hosts(&at) || !self.told.insert(at.span()) {
            return None;
        }
        let mut d = Diagnostic::error(rule, at.span(), message).mark(at.label);
        d.macros = at.interface.program.macros_at(at.token);
        let d = if is_hosts(&other) {
            d.note(format!(
                "the host puts the other before it: {}",
                other.label
            ))
        } else {
            d.label(other.span(), other.label)
        };
        self.diagnostics.push(d);
        self.diagnostics.last_mut()
    }

    /// Reports something at one place.
    pub fn at(
        &mut self,
        rule: ErrorKind,
        message: String,
        at: LinkSite,
    ) -> Option<&mut Diagnostic> {
        if at.interface.is_hosts(at.token) || !self.told.insert(at.span()) {
            return None;
        }
        let mut d = Diagnostic::error(rule, at.span(), message).mark(at.label.clone());
        d.macros = at.interface.program.macros_at(at.token);
        self.diagnostics.push(d);
        self.diagnostics.last_mut()
    }

    /// Reports two declarations that should be the same. `what` is the thing in words.
    pub fn difference(
        &mut self,
        rule: ErrorKind,
        what: &str,
        vertex: &Interface,
        fragment: &Interface,
        difference: &Difference,
    ) {
        let Difference {
            path,
            kind,
            vertex: (vertex_token, in_vertex),
            fragment: (fragment_token, in_fragment),
        } = difference;
        let subject = format!("{what}{path}");
        let message = match kind {
            Differing::Type | Differing::Precision => format!(
                "`{subject}` is `{in_fragment}` in the fragment shader and `{in_vertex}` in the \
                 vertex shader"
            ),
            Differing::StructName => format!(
                "`{subject}` is a {in_fragment} in the fragment shader and a {in_vertex} in the \
                 vertex shader"
            ),
            Differing::Members => format!(
                "`{subject}` has {in_fragment} in the fragment shader where the vertex shader has \
                 {in_vertex}"
            ),
        };
        let label = |text: &str, of: &str| format!("{} in the {of} shader", quoted(text, *kind));
        let first = LinkSite::new(fragment, *fragment_token, label(in_fragment, "fragment"));
        let second = LinkSite::new(vertex, *vertex_token, label(in_vertex, "vertex"));
        let Some(d) = self.differ(rule, message, first, second) else {
            return;
        };
        d.notes.push(
            match (kind, rule) {
                (Differing::Precision, _) => {
                    "`highp` is the default of vertex shaders; a uniform of both stages needs one precision (section 4.5.3)"
                }
                (Differing::StructName, _) => {
                    "structs of both stages are the same only if their names are, too (section 4.3.10)"
                }
                (_, error::LINK_VARYING) => {
                    "what the vertex shader passes on arrives as what it was (section 4.3.10)"
                }
                (_, error::LINK_BLOCK) => SAME,
                _ => "a uniform of both stages is one variable (section 4.3.5)",
            }
            .to_string(),
        );
        if *kind == Differing::Precision {
            d.help.push(format!(
                "write `{}` in both",
                higher(in_vertex, in_fragment)
            ));
        }
    }
}

/// A place in one of the shaders, and what stands there.
pub struct LinkSite<'a, 'p> {
    pub interface: &'a Interface<'p>,
    pub token: TokenId,
    pub label: String,
}

impl<'a, 'p> LinkSite<'a, 'p> {
    pub fn new(interface: &'a Interface<'p>, token: TokenId, label: impl Into<String>) -> Self {
        let label = label.into();
        LinkSite {
            interface,
            token,
            label,
        }
    }

    pub fn span(&self) -> Span {
        let token = self.interface.program.token(self.token);
        token.map_or(Span::default(), |t| t.span)
    }
}

fn quoted(text: &str, kind: Differing) -> String {
    match kind {
        Differing::Type | Differing::Precision => format!("`{text}`"),
        Differing::StructName | Differing::Members => text.to_string(),
    }
}

/// The one of two types with the higher precision.
fn higher<'a>(a: &'a str, b: &'a str) -> &'a str {
    let order = ["highp ", "mediump ", "lowp "];
    let rank = |t: &str| order.iter().position(|p| t.starts_with(p));
    if rank(a) <= rank(b) { a } else { b }
}

/// Why blocks must be the same.
pub const SAME: &str = "a block of both stages is one block: the same members, layout and arrays \
                    (section 4.3.7)";
