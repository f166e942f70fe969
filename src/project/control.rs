//! Controls: uniforms that the user sets on the page.

use serde::Serialize;

/// The widget of a control.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ControlKind {
    /// A slider for a float.
    Float,
    /// A slider for an integer.
    Int,
    /// A checkbox.
    Bool,
    /// A colour picker.
    Color,
    /// A position in the image.
    Point,
    /// One slider per component.
    Vector,
    /// A list of named values.
    Choice,
    /// A button that sets the value for one frame.
    Event,
}

/// A named value of a list.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ControlChoice {
    /// The label in the list.
    pub label: String,
    /// The value of the uniform.
    pub value: f64,
}

/// A control.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct UniformControl {
    /// The name of the uniform.
    pub name: String,
    /// The label on the page.
    pub label: String,
    /// The widget.
    pub kind: ControlKind,
    /// The initial value, with one number per component.
    pub value: Vec<f64>,
    /// The minimum of each component.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub min: Vec<f64>,
    /// The maximum of each component.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub max: Vec<f64>,
    /// The values to choose from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<ControlChoice>,
}

/// Initial colours, so that several controls differ.
const PALETTE: [[f64; 3]; 4] = [
    [0.95, 0.55, 0.2],
    [0.15, 0.45, 0.85],
    [0.95, 0.9, 0.75],
    [0.15, 0.65, 0.5],
];

impl UniformControl {
    /// The least value, the value and the largest value of a slider for one number, and whether the
    /// number is an integer.
    pub fn slider(&self) -> Option<([f64; 3], bool)> {
        let is_int = match self.kind {
            ControlKind::Float => false,
            ControlKind::Int => true,
            _ => return None,
        };
        let (&[min], &[value], &[max]) = (&*self.min, &*self.value, &*self.max) else {
            return None;
        };
        Some(([min, value, max], is_int))
    }

    /// A control with the same value and range in all components.
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

    /// A colour control; `number` is the number of colours before it.
    pub fn color(name: &str, lanes: usize, number: usize) -> UniformControl {
        let color = PALETTE.get(number % PALETTE.len()).unwrap_or(&[1.0; 3]);
        let mut control = UniformControl::even(name, ControlKind::Color, lanes, (0.0, 1.0, 1.0));
        for (value, own) in control.value.iter_mut().zip(color) {
            *value = *own;
        }
        control
    }
}
