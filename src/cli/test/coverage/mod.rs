//! `--coverage`: which lines and branches of the files under test ran.

mod json;
mod lcov;
mod share;

use super::super::output::{Overwrite, write};
use crate::play::Coverage;
use crate::text::number::percent;
use clap::ValueEnum;
use share::{Share, shares};
use std::path::Path;

/// The values of `--coverage-format`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum CoverageFormat {
    /// As `genhtml`, CI systems and editors read it
    Lcov,
    /// One JSON object
    Json,
}

/// Writes the file of `--coverage`, in the format of its extension unless another is given.
///
/// # Errors
/// A message with the path.
pub fn save(
    coverage: &Coverage,
    path: &Path,
    format: Option<CoverageFormat>,
) -> Result<(), String> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let format = format.unwrap_or(match extension {
        "json" => CoverageFormat::Json,
        _ => CoverageFormat::Lcov,
    });
    let text = match format {
        CoverageFormat::Lcov => lcov::lcov(coverage),
        CoverageFormat::Json => json::json(coverage),
    };
    let written = write(path, text.as_bytes(), Overwrite::Allowed);
    written.map_err(|e| format!("cannot write {}: {e}", path.display()))
}

/// A line for people: how much ran.
pub fn summary(coverage: &Coverage) -> String {
    let mut total = [Share::default(); 3];
    for file in coverage.files.values() {
        for (total, own) in total.iter_mut().zip(shares(file)) {
            (total.ran, total.all) = (total.ran + own.ran, total.all + own.all);
        }
    }
    let [lines, branches, _] = total;
    format!(
        "coverage: {} of {} lines, {} of {} branches",
        percent(lines.percent() / 100.0),
        lines.all,
        percent(branches.percent() / 100.0),
        branches.all
    )
}
