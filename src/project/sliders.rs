//! Sliders, colours and switches for values in the code.

use super::ControlKind;
use serde::Serialize;
use shaderlint_text::FileId;

/// Which values in the code have sliders.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[cfg_attr(
    feature = "cli",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema)
)]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"), schemars(inline))]
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
pub struct Slider {
    /// The name of the constant or variable.
    pub name: String,
    /// The text beside the slider.
    pub label: String,
    /// How it is shown.
    pub kind: ControlKind,
    /// The type of the literals.
    pub scalar: &'static str,
    /// The value in the code, one number per component.
    pub value: Vec<f64>,
    /// The lower limits.
    pub min: Vec<f64>,
    /// The upper limits.
    pub max: Vec<f64>,
    /// The file that the literals are in.
    #[serde(rename = "file", serialize_with = "number")]
    pub file: FileId,
    /// Start offset of the literals.
    pub start: usize,
    /// End offset.
    pub end: usize,
}

fn number<S: serde::Serializer>(file: &FileId, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_u32(file.0)
}

/// The sliders of a project.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Sliders {
    /// The sliders in order.
    pub list: Vec<Slider>,
    /// Proposed sliders, and why values have none.
    pub notes: Vec<String>,
}
