//! Uniforms that the user of a page sets.

use serde::Serialize;

/// How a control is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ControlKind {
    /// A slider of fractions.
    Float,
    /// A slider of whole numbers.
    Int,
    /// A check box.
    Bool,
    /// A colour.
    Color,
    /// A place in the picture.
    Point,
    /// Several sliders.
    Vector,
    /// One of some values.
    Choice,
    /// A button.
    Event,
}

/// A value with its name.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ControlChoice {
    /// The name.
    pub label: String,
    /// The value.
    pub value: f64,
}

/// A uniform that the user sets.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct UniformControl {
    /// The uniform.
    pub name: String,
    /// What people call it.
    pub label: String,
    /// How it is shown.
    pub kind: ControlKind,
    /// Its value at first, as many numbers as it takes.
    pub value: Vec<f64>,
    /// The smallest values.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub min: Vec<f64>,
    /// The largest values.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub max: Vec<f64>,
    /// The values to choose from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<ControlChoice>,
}

/// Colours of controls, so that two are seen to be two.
const PALETTE: [[f64; 3]; 4] = [
    [0.95, 0.55, 0.2],
    [0.15, 0.45, 0.85],
    [0.95, 0.9, 0.75],
    [0.15, 0.65, 0.5],
];

impl UniformControl {
    /// A control with the same value and range in all lanes.
    pub fn even(
        name: &str,
        kind: ControlKind,
        lanes: usize,
        range: (f64, f64, f64),
    ) -> UniformControl {
        let (min, value, max) = range;
        let has_range = !matches!(kind, ControlKind::Bool | ControlKind::Event);
        let ends = |end| match has_range {
            true => vec![end; lanes],
            false => Vec::new(),
        };
        UniformControl {
            name: name.to_string(),
            label: name.to_string(),
            kind,
            value: vec![value; lanes],
            min: ends(min),
            max: ends(max),
            choices: Vec::new(),
        }
    }

    /// A colour; `number` counts the colours before it.
    pub fn color(name: &str, lanes: usize, number: usize) -> UniformControl {
        let color = PALETTE.get(number % PALETTE.len()).unwrap_or(&[1.0; 3]);
        let mut control = UniformControl::even(name, ControlKind::Color, lanes, (0.0, 1.0, 1.0));
        for (value, own) in control.value.iter_mut().zip(color) {
            *value = *own;
        }
        control
    }
}
