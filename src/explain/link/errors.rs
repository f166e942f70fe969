//! Link errors and their positions.

use super::compare::{Difference, Differing};
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, error};
use shaderlint_semantic::interface::Interface;
use shaderlint_syntax::ast::TokenId;
use shaderlint_text::Span;

/// Maximum number of link errors.
pub const MAX_ERRORS: usize = 200;

/// Errors found so far.
#[derive(Default)]
pub struct LinkErrors {
    pub diagnostics: Vec<Diagnostic>,
    /// Spans with an error; each mistake is reported once.
    pub reported: FxHashSet<Span>,
}

impl LinkErrors {
    /// Whether the error limit is reached.
    pub fn is_full(&self) -> bool {
        self.diagnostics.len() >= MAX_ERRORS
    }

    /// Reports a mismatch between two declarations at the first one written by the user. Returns
    /// the diagnostic for further notes; `None` if it was reported before.
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
        if is_hosts(&at) || !self.reported.insert(at.span()) {
            return None;
        }
        let mut d = Diagnostic::error(rule, at.span(), message).mark(at.label);
        d.macros = at.interface.program.macros_at(at.token);
        let d = if is_hosts(&other) {
            d.note(format!(
                "the other declaration is part of the host: {}",
                other.label
            ))
        } else {
            d.label(other.span(), other.label)
        };
        self.diagnostics.push(d);
        self.diagnostics.last_mut()
    }

    /// Reports an error at one position.
    pub fn at(
        &mut self,
        rule: ErrorKind,
        message: String,
        at: LinkSite,
    ) -> Option<&mut Diagnostic> {
        if at.interface.is_hosts(at.token) || !self.reported.insert(at.span()) {
            return None;
        }
        let mut d = Diagnostic::error(rule, at.span(), message).mark(at.label.clone());
        d.macros = at.interface.program.macros_at(at.token);
        self.diagnostics.push(d);
        self.diagnostics.last_mut()
    }

    /// Reports two declarations that should match. `what` is the name of the declared thing.
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
            Differing::Type => format!(
                "`{subject}` is `{in_fragment}` in the fragment but `{in_vertex}` in the vertex shader"
            ),
            Differing::Precision => format!(
                "`{subject}` is `{}` in the fragment but `{}` in the vertex shader",
                precision_of(in_fragment),
                precision_of(in_vertex)
            ),
            Differing::StructName => format!(
                "`{subject}` is a {in_fragment} in the fragment but a {in_vertex} in the vertex shader"
            ),
            Differing::Members => format!(
                "`{subject}` has {in_fragment} in the fragment but {in_vertex} in the vertex shader"
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
                    "a uniform must have the same precision in both stages; vertex shaders default to `highp` (section 4.5.3)"
                }
                (Differing::StructName, _) => {
                    "a struct shared by both stages must have the same name in both (section 4.3.10)"
                }
                (_, error::LINK_VARYING) => {
                    "an output and the input of the same name must have the same type (section 4.3.10)"
                }
                (_, error::LINK_BLOCK) => SAME,
                _ => "a uniform declared in both stages is a single variable (section 4.3.5)",
            }
            .to_string(),
        );
        if *kind == Differing::Precision {
            d.help.push(format!(
                "use `{}` in both stages",
                higher(in_vertex, in_fragment)
            ));
        }
    }
}

/// A position in one of the shaders, with its label.
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

/// The precision of a type such as `highp float`.
fn precision_of(text: &str) -> &str {
    text.split(' ').next().unwrap_or(text)
}

/// The type with the higher precision.
fn higher<'a>(a: &'a str, b: &'a str) -> &'a str {
    let order = ["highp ", "mediump ", "lowp "];
    let rank = |t: &str| order.iter().position(|p| t.starts_with(p));
    if rank(a) <= rank(b) { a } else { b }
}

/// Rule for blocks in both stages.
pub const SAME: &str = "a block used in both stages must have the same members, layout and array size \
                    (section 4.3.7)";
