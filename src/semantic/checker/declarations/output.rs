//! The outputs of a fragment shader, and their locations (GLSL ES 3.00 section 4.3.8.2).

use super::qualifier::{Qualified, StorageRequest};
use crate::checker::*;

/// Most outputs of a fragment shader.
const MAX_DRAW_BUFFERS: u64 = 8;

/// An error in the outputs of a fragment shader.
#[derive(Clone, Copy, Debug)]
pub enum OutputError {
    /// An output beyond the last location, and the number of locations.
    Outside(Name, u64),
    /// An output, and another one at the same location.
    Shared(Name, Ident, u64),
    /// An output of the user in addition to that of the host.
    NextToHostOutputs(Name),
    /// One of several outputs, without a location.
    NoLocation(Name),
    /// `gl_FragColor` and `gl_FragData` in one shader; the first use of the earlier one.
    ColorAndData(TokenId),
}

/// An output of a fragment shader.
#[derive(Clone, Copy, Debug)]
pub(in crate::checker) struct OutputVariable {
    pub ident: Ident,
    location: Option<i32>,
    size: u32,
}

impl Checker<'_> {
    /// Records an output for the check of locations.
    pub(super) fn note_output(&mut self, declarator: &Declarator, qualified: &Qualified, ty: Type) {
        if self.stage == Stage::Fragment
            && qualified.storage == StorageRequest::Out
            && self.has(Feature::InOut)
            && !ty.is_error()
        {
            self.outputs.push(OutputVariable {
                ident: declarator.ident,
                location: qualified.layout.location,
                size: ty.array.max(1),
            });
        }
    }

    /// Outputs must not share a location, and several must all have one (section 4.3.8.2).
    pub(in crate::checker) fn check_outputs(&mut self) {
        let outputs = std::mem::take(&mut self.outputs);
        let mut taken: [Option<Ident>; MAX_DRAW_BUFFERS as usize] = Default::default();
        for output in &outputs {
            let (name, at) = (output.ident.name, Extent::token(output.ident.token));
            let first = output.location.unwrap_or(0) as u64;
            if first + output.size as u64 > MAX_DRAW_BUFFERS {
                self.reject(at, OutputError::Outside(name, MAX_DRAW_BUFFERS));
                continue;
            }
            if output.location.is_none() {
                continue;
            }
            for location in first..first + output.size as u64 {
                match taken.get_mut(location as usize) {
                    Some(slot @ None) => *slot = Some(output.ident),
                    Some(Some(other)) => {
                        let other = *other;
                        self.reject(at, OutputError::Shared(name, other, location));
                        break;
                    }
                    None => {}
                }
            }
        }
        let mut others = outputs.iter().skip(1).map(|o| o.ident.name);
        let has_others = outputs
            .first()
            .is_some_and(|o| others.any(|name| name != o.ident.name));
        // A misspelled qualifier may have been the location.
        let is_unknown =
            |p: &Problem| matches!(p.what, ProblemKind::Layout(LayoutError::UnknownNumber(_)));
        if has_others && !self.problems.iter().any(is_unknown) {
            self.check_locations_given(&outputs);
        }
    }

    fn check_locations_given(&mut self, outputs: &[OutputVariable]) {
        let Some(without) = outputs.iter().find(|o| o.location.is_none()) else {
            return;
        };
        // The output of ShaderToy's header has no location, so the user's output is the error.
        let users = outputs.iter().find(|o| !self.is_prelude(o.ident.token));
        if let (true, Some(output)) = (self.is_prelude(without.ident.token), users) {
            let at = Extent::token(output.ident.token);
            return self.reject(at, OutputError::NextToHostOutputs(output.ident.name));
        }
        let at = Extent::token(without.ident.token);
        self.reject(at, OutputError::NoLocation(without.ident.name));
    }

    /// Reports the use of both `gl_FragColor` and `gl_FragData`.
    pub(in crate::checker) fn check_fragment_variables(&mut self) {
        if let (Some(color), Some(data)) = (self.frag_color, self.frag_data) {
            let at = Extent::token(color.max(data));
            self.reject(at, OutputError::ColorAndData(color.min(data)));
        }
    }
}
