//! Uniforms outside blocks: uniforms of the same name in both stages are one variable (GLSL ES 3.00
//! section 4.3.5).

use super::compare::{InterfaceComparison, PrecisionMatch};
use super::errors::LinkErrors;
use super::varyings::declared;
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::error;
use shaderlint_semantic::interface::{Interface, InterfaceVariable};

/// Checks that uniforms of the same name have the same type and, if both stages use them, the same
/// precision.
pub fn check(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    let mut comparison = InterfaceComparison::new(vertex, fragment);
    let of_vertex = vertex.uniforms.iter().map(|u| (vertex.text(u.name), u));
    let of_vertex: FxHashMap<&str, &InterfaceVariable> = of_vertex.collect();
    for uniform in &fragment.uniforms {
        if found.is_full() {
            return;
        }
        let name = fragment.text(uniform.name);
        let Some(other) = of_vertex.get(name) else {
            continue;
        };
        let precisions = if uniform.is_used && other.is_used {
            PrecisionMatch::Same
        } else {
            PrecisionMatch::Free
        };
        let sides = (declared(other), declared(uniform));
        if let Some(difference) = comparison.difference(sides.0, sides.1, precisions) {
            let rule = error::LINK_UNIFORM;
            found.difference(rule, name, vertex, fragment, &difference);
        }
    }
}
