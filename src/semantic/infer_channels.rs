//! Checks a parsed shader and infers the types of its channels where they are unknown.

use super::channels::needed_channels;
use super::checker::{ParsedShader, check};
use super::problem::MAX_ERRORS;
use super::problem::Problems;
use super::program::Program;
use super::types::Sampler;
use super::unit::Unit;
use shaderlint_syntax::Search;
use std::sync::Arc;

/// Checks a shader and infers the types of its channels where they are unknown.
pub(super) fn check_unit(
    parsed: ParsedShader,
    unit: &Unit,
    search: &mut Search,
) -> (Program, Problems) {
    match unit.infer_channels {
        true => check_with_any_channels(parsed, unit, search),
        false => check(parsed, unit.stage, unit.dialect, [None; 4], search),
    }
}

/// Checks a shader with channels of unknown types. Only if there are errors with 2D channels, other
/// types are inferred from its lookups.
///
/// A check that stops early is good enough for this choice: if it stopped because of lookups that
/// do not fit 2D, either they are the majority and the other types are used, or at least as many
/// fit 2D and would all be errors with the other types.
fn check_with_any_channels(
    parsed: ParsedShader,
    unit: &Unit,
    search: &mut Search,
) -> (Program, Problems) {
    let enough = parsed.enough;
    let (mut program, problems) = check(parsed, unit.stage, unit.dialect, [None; 4], search);
    if problems.is_empty() {
        return (program, problems);
    }
    let channels = needed_channels(&program);
    if channels.iter().flatten().all(|c| *c == Sampler::Sampler2D) {
        return (program, problems);
    }
    let parsed = ParsedShader {
        enough,
        ..program.take_parsed()
    };
    check(parsed, unit.stage, unit.dialect, channels, search)
}

impl Program {
    /// Takes the parsed shader out of the program for another check, dropping the results of this
    /// one.
    pub(super) fn take_parsed(&mut self) -> ParsedShader {
        ParsedShader {
            sources: Arc::clone(&self.sources),
            tokens: std::mem::take(&mut self.tokens),
            names: std::mem::take(&mut self.names),
            tree: std::mem::take(&mut self.tree),
            version: self.version,
            context: self.context,
            has_errors: self.had_errors,
            enough: MAX_ERRORS,
        }
    }
}
