//! One check of a parsed shader, with the types of its channels found out where they are not known.

use super::channels::needed_channels;
use super::checker::{MAX_ERRORS, Parsed, Problems, check};
use super::program::Program;
use super::types::Sampler;
use super::unit::Unit;
use shaderlint_syntax::Search;
use std::sync::Arc;

/// Checks a shader, with the types of its channels found out where they are not known.
pub(super) fn judge(parsed: Parsed, unit: &Unit, search: &mut Search) -> (Program, Problems) {
    match unit.infer_channels {
        true => check_with_any_channels(parsed, unit, search),
        false => check(parsed, unit.stage, unit.dialect, [None; 4], search),
    }
}

/// Checks a shader whose channels may be of any type. Only where something is wrong with channels of
/// two dimensions, its lookups are asked for others.
///
/// A count that ends early chooses well enough. Where it ended by lookups that do not fit two
/// dimensions, either they are more than those that do, and the other channels are taken; or at least
/// as many do, which would all be errors with the others.
fn check_with_any_channels(
    parsed: Parsed,
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
    let parsed = Parsed {
        enough,
        ..program.take_parsed()
    };
    check(parsed, unit.stage, unit.dialect, channels, search)
}

impl Program {
    /// The shader as it was before it was checked. What is known of it goes with it.
    pub(super) fn take_parsed(&mut self) -> Parsed {
        Parsed {
            sources: Arc::clone(&self.sources),
            tokens: std::mem::take(&mut self.tokens),
            names: std::mem::take(&mut self.names),
            tree: std::mem::take(&mut self.tree),
            version: self.version,
            has_errors: self.had_errors,
            enough: MAX_ERRORS,
        }
    }
}
