//! Varyings from the vertex to the fragment shader (GLSL ES 3.00 section 4.3.10).

use super::compare::{DeclaredType, InterfaceComparison, PrecisionMatch};
use super::errors::{LinkErrors, LinkSite};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::{Label, error};
use shaderlint_semantic::Storage;
use shaderlint_semantic::interface::{Interface, InterfaceVariable};
use shaderlint_syntax::Feature;
use shaderlint_syntax::ast::TokenId;

/// Checks that the inputs used by the fragment shader match outputs of the vertex shader.
pub fn check(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    let mut comparison = InterfaceComparison::new(vertex, fragment);
    let given = vertex.outputs.iter().map(|o| (vertex.text(o.name), o));
    let given: FxHashMap<&str, &InterfaceVariable> = given.collect();
    let left_out = left_out(vertex);
    // Inputs that are declared but never used may be missing.
    for input in fragment.inputs.iter().filter(|i| i.is_used) {
        if found.is_full() {
            return;
        }
        let name = fragment.text(input.name);
        let Some(output) = given.get(name) else {
            if !left_out.contains(name) {
                missing(vertex, fragment, input, found);
            }
            continue;
        };
        let sides = (declared(output), declared(input));
        match comparison.difference(sides.0, sides.1, PrecisionMatch::Free) {
            Some(difference) => {
                let rule = error::LINK_VARYING;
                found.difference(rule, name, vertex, fragment, &difference);
            }
            None => qualifiers(vertex, fragment, (output, input), found),
        }
    }
    if vertex.program.version.has(Feature::InvariantInputs) {
        invariant_builtins(vertex, fragment, found);
    }
}

/// The properties of a variable that are compared.
pub fn declared(item: &InterfaceVariable) -> DeclaredType {
    DeclaredType {
        token: item.token,
        ty: item.ty,
        precision: item.precision,
    }
}

/// `flat`, and in GLSL ES 1.00 `invariant`, must match.
fn qualifiers(
    vertex: &Interface,
    fragment: &Interface,
    (output, input): (&InterfaceVariable, &InterfaceVariable),
    found: &mut LinkErrors,
) {
    let compares_invariance = vertex.program.version.has(Feature::InvariantInputs);
    let (word, section) = if output.is_flat != input.is_flat {
        ("flat", "4.3.9")
    } else if compares_invariance && output.is_invariant != input.is_invariant {
        ("invariant", "4.6.4")
    } else {
        return;
    };
    let is_qualified = |i: &InterfaceVariable| match word {
        "flat" => i.is_flat,
        _ => i.is_invariant,
    };
    let label = |item: &InterfaceVariable, stage: &str| {
        let negation = if is_qualified(item) { "" } else { "not " };
        format!("{negation}`{word}` in the {stage} shader")
    };
    let (with, without) = if is_qualified(input) {
        ("fragment", "vertex")
    } else {
        ("vertex", "fragment")
    };
    let name = fragment.text(input.name);
    let message = format!("`{name}` is `{word}` in the {with} but not in the {without} shader");
    let first = LinkSite::new(fragment, input.token, label(input, "fragment"));
    let second = LinkSite::new(vertex, output.token, label(output, "vertex"));
    if let Some(d) = found.differ(error::LINK_VARYING, message, first, second) {
        d.notes.push(format!(
            "`{word}` must be used in both stages or in neither (section {section})"
        ));
        d.help.push(format!("add `{word}` in the {without} shader"));
    }
}

/// Reports an input without a vertex shader output.
fn missing(
    vertex: &Interface,
    fragment: &Interface,
    input: &InterfaceVariable,
    found: &mut LinkErrors,
) {
    let name = fragment.text(input.name);
    let message = format!("the vertex shader has no output `{name}`");
    let place = LinkSite::new(fragment, input.token, "read in the fragment shader");
    let Some(d) = found.at(error::LINK_VARYING, message, place) else {
        return;
    };
    d.notes.push(
        "an input that the fragment shader uses must be an output of its vertex shader (section 4.3.10)"
            .to_string(),
    );
    let ty = fragment.program.type_name(input.ty);
    // A host may have defined it as a macro.
    let has_varying = fragment.program.names.get("varying").is_some();
    let word = match (has_varying, input.is_flat) {
        (true, _) => "varying",
        (false, true) => "flat out",
        (false, false) => "out",
    };
    let (seen, help) = match (own_variable(vertex, name), nearest(vertex, fragment, name)) {
        (Some((token, what)), _) => (
            Some((token, format!("declared as {what} here"))),
            format!("declare `{word} {ty} {name};` in the vertex shader"),
        ),
        (None, Some(near)) => (
            Some((near.token, "similar vertex shader output".to_string())),
            format!("did you mean `{}`?", vertex.text(near.name)),
        ),
        (None, None) => (
            None,
            format!("add `{word} {ty} {name};` to the vertex shader and assign to it"),
        ),
    };
    if let Some((token, message)) = seen {
        let span = LinkSite::new(vertex, token, "").span();
        d.labels.push(Label { span, message });
    }
    d.help.push(help);
}

/// A global of this name in the vertex shader that is not an output.
fn own_variable(vertex: &Interface, name: &str) -> Option<(TokenId, &'static str)> {
    let id = vertex.program.names.get(name)?;
    let mut all = vertex.program.variables.iter();
    let variable = all.find(|v| v.name == id && v.function.is_none() && v.token.is_some())?;
    let token = variable.token.filter(|t| !vertex.is_hosts(*t))?;
    match variable.storage {
        Storage::Global => Some((token, "a variable")),
        Storage::Input => Some((token, "an attribute")),
        Storage::Uniform => Some((token, "a uniform")),
        _ => None,
    }
}

/// The output that a name is probably a typo of, among those that the fragment shader does not
/// read.
fn nearest<'a>(
    vertex: &'a Interface,
    fragment: &Interface,
    name: &str,
) -> Option<&'a InterfaceVariable> {
    let inputs = fragment.inputs.iter().map(|i| fragment.text(i.name));
    let inputs: FxHashSet<&str> = inputs.collect();
    let is_free =
        |o: &&InterfaceVariable| !vertex.is_hosts(o.token) && !inputs.contains(vertex.text(o.name));
    let limit = match name.len() {
        0..=2 => 0,
        3..=5 => 1,
        _ => 2,
    };
    let distance = |o: &InterfaceVariable| {
        let output = vertex.text(o.name);
        if output.len().abs_diff(name.len()) > limit {
            return usize::MAX;
        }
        let (output, name) = (output.to_ascii_lowercase(), name.to_ascii_lowercase());
        strsim::damerau_levenshtein(&output, &name)
    };
    let free = vertex.outputs.iter().filter(is_free);
    let distances = free.map(|o| (distance(o), o)).filter(|(d, _)| *d <= limit);
    distances.min_by_key(|(d, _)| *d).map(|(_, o)| o)
}

/// Words in text skipped by `#if`, because the page may enable declarations there.
fn left_out<'a>(interface: &Interface<'a>) -> FxHashSet<&'a str> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let inactive = interface.program.tokens.inactive.iter();
    let texts = inactive.map(|span| interface.program.sources.text(*span));
    let words = texts.flat_map(|text| text.split(move |c| !is_letter(c)));
    words.filter(|w| !w.is_empty()).collect()
}

/// `invariant gl_FragCoord` requires `invariant gl_Position`, and `gl_PointCoord` requires
/// `gl_PointSize` (GLSL ES 1.00 section 4.6.4).
fn invariant_builtins(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    for (input, output) in [
        ("gl_FragCoord", "gl_Position"),
        ("gl_PointCoord", "gl_PointSize"),
    ] {
        // The linker does not see variables that no statement uses.
        let is_given = vertex.is_invariant(output) && vertex.builtin_use(output).is_some();
        if !fragment.is_invariant(input) || is_given {
            continue;
        }
        let Some(token) = fragment.builtin_use(input) else {
            continue;
        };
        let message =
            format!("`{input}` is `invariant` but `{output}` in the vertex shader is not");
        let place = LinkSite::new(fragment, token, "");
        if let Some(d) = found.at(error::LINK_VARYING, message, place) {
            d.help
                .push(format!("add `invariant {output};` to the vertex shader"));
        }
    }
}
