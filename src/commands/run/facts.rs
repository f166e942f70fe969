//! Statistics of a frame, for people and for programs.

use super::fields::{self, FieldRow};
use super::functions::{self, FunctionRow};
use super::loops::{self, LoopRow};
use super::numbers::{self, NumberRow};
use super::rays::{self, RayRow};
use serde::Serialize;
use shaderlint_diagnostic::count;
use shaderlint_engine::inputs::{Button, Moment};
use shaderlint_exec::Drawn;
use shaderlint_play::ImageFacts;
use shaderlint_text::number::{percent, seconds};

/// The result of a run. The JSON format may gain fields, but never loses any.
#[derive(Serialize)]
pub struct RunFacts {
    /// Version of the JSON format.
    pub schema: u32,
    /// Name of the shader file.
    pub file: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Time in seconds since the start.
    pub time: f64,
    /// Frame number, from 0.
    pub frame: u32,
    /// The mouse, if it was pressed.
    pub mouse: Option<MouseFacts>,
    /// Path of the image that was written.
    pub output: Option<String>,
    /// Statistics of the outputs; the first is the image.
    pub outputs: Vec<OutputFacts>,
    /// Number of operations.
    pub cost: CostFacts,
    /// Iterations of the loops, with --report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loops: Option<Vec<LoopRow>>,
    /// Rays of the marching loops, with --report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rays: Option<Vec<RayRow>>,
    /// Cost of the functions, with --report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub functions: Option<Vec<FunctionRow>>,
    /// Invalid numbers, with --report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub numbers: Option<Vec<NumberRow>>,
    /// The distance fields that rays march along, with --report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fields: Option<Vec<FieldRow>>,
    /// Notes about inputs that were missing or replaced.
    pub notes: Vec<String>,
}

/// The result of drawing a contact sheet. The JSON format may gain fields, but never loses any.
#[derive(Serialize)]
pub struct SheetFacts {
    /// Version of the JSON format.
    pub schema: u32,
    /// The statistics of each frame, in the order of time.
    pub frames: Vec<RunFacts>,
    /// Path of the image that was written.
    pub output: Option<String>,
}

/// Position and button of the mouse.
#[derive(Serialize)]
pub struct MouseFacts {
    x: f64,
    y: f64,
    down: bool,
}

/// Statistics of one output.
#[derive(Serialize)]
pub struct OutputFacts {
    /// Name of the output variable.
    pub name: String,
    /// Type of the output variable.
    #[serde(rename = "type")]
    pub ty: String,
    /// Average of each channel without alpha, over finite values.
    pub mean: Vec<f64>,
    /// Minimum of each channel.
    pub min: Vec<f64>,
    /// Maximum of each channel.
    pub max: Vec<f64>,
    /// Share of pixels that are black after rounding to 8 bits.
    pub black: f64,
    /// Share of pixels with a NaN.
    pub nan: f64,
    /// Share of pixels with an infinity.
    pub infinite: f64,
    /// Share of discarded pixels.
    pub discarded: f64,
    /// Number of distinct colours after rounding to 8 bits, counted up to 65,536.
    pub colors: u32,
}

/// The cost of a frame.
#[derive(Serialize)]
pub struct CostFacts {
    /// Number of operations of all pixels.
    pub operations: u64,
    /// Average number of operations per pixel.
    pub mean: f64,
    /// Number of operations of the most expensive pixel.
    pub most: u32,
}

impl OutputFacts {
    /// Statistics of an output with `lanes` components.
    pub fn of(
        name: &str,
        (ty, lanes): (String, u32),
        facts: &ImageFacts,
        pixels: usize,
    ) -> OutputFacts {
        let first = |all: [f64; 3]| all.into_iter().take(lanes.max(1) as usize).collect();
        let share = |count: u64| count as f64 / pixels.max(1) as f64;
        OutputFacts {
            name: name.to_string(),
            ty,
            mean: first(facts.mean),
            min: first(facts.least),
            max: first(facts.most),
            black: share(facts.black),
            nan: share(facts.nan),
            infinite: share(facts.infinite),
            discarded: share(facts.discarded),
            colors: facts.colors,
        }
    }
}

impl CostFacts {
    /// The cost of a draw.
    pub fn of(drawn: &Drawn) -> CostFacts {
        CostFacts {
            operations: drawn.seen.operations,
            mean: drawn.mean_cost(),
            most: drawn.most_cost(),
        }
    }
}

/// The mouse of a moment.
pub fn mouse(moment: &Moment) -> Option<MouseFacts> {
    moment.mouse.map(|mouse| MouseFacts {
        x: mouse.at[0],
        y: mouse.at[1],
        down: mouse.button == Button::Down,
    })
}

impl RunFacts {
    /// The text for people.
    pub fn text(&self) -> String {
        let [width, height] = self.size;
        let (file, time, frame) = (&self.file, seconds(self.time), self.frame);
        let mut text = format!("{file}: {width}x{height}, {time}, frame {frame}\n");
        for (output, i) in self.outputs.iter().zip(0..) {
            let name = match i {
                0 => "image".to_string(),
                _ => output.name.clone(),
            };
            let lanes = |all: &[f64]| {
                let all = all.iter().map(|n| number(*n));
                all.collect::<Vec<_>>().join(" ")
            };
            text.push_str(&format!(
                "  {name:9} mean {}, min {}, max {}\n",
                lanes(&output.mean),
                lanes(&output.min),
                lanes(&output.max)
            ));
            if i > 0 {
                continue;
            }
            let mut shares = vec![format!("{} black", percent(output.black))];
            let more = [
                (output.nan, "NaN"),
                (output.infinite, "infinite"),
                (output.discarded, "discarded"),
            ];
            for (share, what) in more.into_iter().filter(|(share, _)| *share > 0.0) {
                shares.push(format!("{} {what}", percent(share)));
            }
            let colors = match output.colors {
                n if n >= 65_536 => "65536 or more colours".to_string(),
                n => count(n, "colour"),
            };
            text.push_str(&format!("  {:9} {}, {colors}\n", "", shares.join(", ")));
        }
        let CostFacts { mean, most, .. } = self.cost;
        text.push_str(&format!(
            "  {:9} {mean:.0} operations per pixel, at most {most}\n",
            "cost"
        ));
        let report = [
            self.loops.as_deref().map(loops::table),
            self.rays.as_deref().map(rays::lines),
            self.numbers.as_deref().map(numbers::table),
            self.functions.as_deref().map(functions::table),
            self.fields.as_deref().map(fields::lines),
        ];
        text.extend(report.into_iter().flatten());
        text + &written(self.output.as_deref())
    }
}

impl SheetFacts {
    /// The text for people.
    pub fn text(&self) -> String {
        let frames: String = self.frames.iter().map(RunFacts::text).collect();
        frames + &written(self.output.as_deref())
    }
}

/// The line that says which file was written, if one was.
fn written(output: Option<&str>) -> String {
    output.map_or(String::new(), |output| {
        format!("  {:9} {output}\n", "written")
    })
}

/// Formats a number with three decimals.
fn number(number: f64) -> String {
    let text = format!("{number:.3}");
    match text.as_str() {
        "-0.000" => "0.000".to_string(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_decimals() {
        assert_eq!([-0.0001, 1.5].map(number), ["0.000", "1.500"]);
    }
}
