//! Vertex and fragment shader together: what the browser's linker asks of two shaders that compile.
//!
//! The rules are those of GLSL ES 3.00 (4.3.4 to 4.3.10 and 9) and 1.00 (4.3.3 to 4.6.4) as ANGLE
//! applies them: what a fragment shader names counts as used, whether or not the code runs.

mod blocks;
mod compare;
mod interface;
mod limits;
mod live;
mod uniforms;
mod varyings;

use super::Program;
use compare::{Difference, Differing};
pub use interface::{Block, Interface, InterfaceVariable};
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, error};
use shaderlint_syntax::ast::TokenId;
use shaderlint_text::Span;

/// Finds what keeps two shaders without errors from being linked. Both stand in one address space.
pub fn link(vertex: &Program, fragment: &Program) -> Vec<Diagnostic> {
    let (vertex, fragment) = (Interface::of(vertex), Interface::of(fragment));
    let mut found = Found::default();
    if vertex.program.version != fragment.program.version {
        versions(&vertex, &fragment, &mut found);
        return found.diagnostics;
    }
    limits::attributes(&vertex, &mut found);
    varyings::check(&vertex, &fragment, &mut found);
    uniforms::check(&vertex, &fragment, &mut found);
    blocks::check(&vertex, &fragment, &mut found);
    limits::counts(&vertex, &mut found);
    limits::counts(&fragment, &mut found);
    found.diagnostics.truncate(MAX_ERRORS);
    found.diagnostics
}

/// Most errors that are looked for between two shaders.
const MAX_ERRORS: usize = 200;

/// Both stages are of one version.
fn versions(vertex: &Interface, fragment: &Interface, found: &mut Found) {
    let place = |i: &Interface| {
        let tokens = &i.program.tokens;
        let first = tokens.tokens.first().map(|t| t.span);
        tokens.version_span.or(first).unwrap_or_default()
    };
    let name = |i: &Interface| i.program.version.profile().name;
    let message = format!(
        "the fragment shader is {}, and its vertex shader {}",
        name(fragment),
        name(vertex)
    );
    found.diagnostics.push(
        Diagnostic::error(error::LINK_VERSION, place(fragment), message)
            .label(place(vertex), format!("{} here", name(vertex)))
            .note("both stages of a program are of one version (section 3.3)")
            .help("start both with the same `#version`"),
    );
}

/// What was found.
#[derive(Default)]
struct Found {
    diagnostics: Vec<Diagnostic>,
    /// Places that an error stands at: each mistake is told once.
    told: FxHashSet<Span>,
}

/// A place in one of the shaders, and what stands there.
struct Place<'a, 'p> {
    interface: &'a Interface<'p>,
    token: TokenId,
    label: String,
}

impl<'a, 'p> Place<'a, 'p> {
    fn new(interface: &'a Interface<'p>, token: TokenId, label: impl Into<String>) -> Self {
        let label = label.into();
        Place {
            interface,
            token,
            label,
        }
    }

    fn span(&self) -> Span {
        let token = self.interface.program.token(self.token);
        token.map_or(Span::default(), |t| t.span)
    }
}

impl Found {
    /// Whether so much is wrong that looking on is of no use.
    fn is_full(&self) -> bool {
        self.diagnostics.len() >= MAX_ERRORS
    }

    /// Reports what two places say differently: at the first that the user wrote. Gives the
    /// diagnostic, so that more can be said; `None` where it was told before.
    fn differ(
        &mut self,
        rule: ErrorKind,
        message: String,
        first: Place,
        second: Place,
    ) -> Option<&mut Diagnostic> {
        let is_hosts = |p: &Place| p.interface.is_hosts(p.token);
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
    fn at(&mut self, rule: ErrorKind, message: String, at: Place) -> Option<&mut Diagnostic> {
        if at.interface.is_hosts(at.token) || !self.told.insert(at.span()) {
            return None;
        }
        let mut d = Diagnostic::error(rule, at.span(), message).mark(at.label.clone());
        d.macros = at.interface.program.macros_at(at.token);
        self.diagnostics.push(d);
        self.diagnostics.last_mut()
    }

    /// Reports two declarations that should be the same. `what` is the thing in words.
    fn difference(
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
        let first = Place::new(fragment, *fragment_token, label(in_fragment, "fragment"));
        let second = Place::new(vertex, *vertex_token, label(in_vertex, "vertex"));
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
                (_, error::LINK_BLOCK) => blocks::SAME,
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

#[cfg(test)]
mod tests;
