//! Sliders, colours and switches for values in the code.

use super::ControlKind;
use serde::Serialize;
use shaderlint_text::FileId;

/// Which values in the code have sliders.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum SliderChoice {
    /// Those whose comment gives a range, and constants of type `bool`
    #[default]
    Marked,
    /// Also other `#define`s and constants of literals, from zero to twice the value
    Auto,
    /// None
    None,
}

/// A value in the code that the user sets. Offsets are in UTF-16 units.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub(super) struct Slider {
    pub(super) name: String,
    pub(super) label: String,
    pub(super) kind: ControlKind,
    /// The type of the literals.
    pub(super) scalar: &'static str,
    pub(super) value: Vec<f64>,
    pub(super) min: Vec<f64>,
    pub(super) max: Vec<f64>,
    #[serde(rename = "file", serialize_with = "number")]
    pub(super) file: FileId,
    pub(super) start: usize,
    pub(super) end: usize,
}

fn number<S: serde::Serializer>(file: &FileId, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_u32(file.0)
}

/// The sliders of a project.
#[derive(Clone, PartialEq, Default, Debug)]
pub(super) struct Sliders {
    pub(super) list: Vec<Slider>,
    /// Proposed sliders, and why values have none.
    pub(super) notes: Vec<String>,
}
