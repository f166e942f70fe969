//! What is said of a picture, for people and for programs.

use super::columns::{percent, seconds};
use super::functions::{self, FunctionRow};
use super::loops::{self, LoopRow};
use super::numbers::{self, NumberRow};
use crate::engine::play::{Button, Moment, PictureFacts};
use crate::exec::Drawn;
use serde::Serialize;

/// All that is said of a run. Fields are only ever added.
#[derive(Serialize)]
pub struct RunFacts {
    /// Of this form.
    pub schema: u32,
    /// The shader.
    pub file: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Seconds since the start.
    pub time: f64,
    /// Number of the frame.
    pub frame: u32,
    /// The mouse, where it has come.
    pub mouse: Option<MouseFacts>,
    /// What was written.
    pub output: Option<String>,
    /// What the shader gives, the first as it is shown.
    pub outputs: Vec<OutputFacts>,
    /// What it took.
    pub cost: CostFacts,
    /// The loops, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loops: Option<Vec<LoopRow>>,
    /// What each function cost, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub functions: Option<Vec<FunctionRow>>,
    /// The numbers that went wrong, where the loops were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub numbers: Option<Vec<NumberRow>>,
    /// What was made up or left out.
    pub notes: Vec<String>,
}

/// Where the mouse is.
#[derive(Serialize)]
pub struct MouseFacts {
    x: f64,
    y: f64,
    down: bool,
}

/// What one output holds.
#[derive(Serialize)]
pub struct OutputFacts {
    /// Its name.
    pub name: String,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// By channel, alpha left out, of the numbers that are finite.
    pub mean: Vec<f64>,
    /// The smallest.
    pub min: Vec<f64>,
    /// The largest.
    pub max: Vec<f64>,
    /// Share of the pixels that are black on the screen.
    pub black: f64,
    /// Share of those with a NaN.
    pub nan: f64,
    /// Share of those with an infinite number.
    pub infinite: f64,
    /// Share of those that were discarded.
    pub discarded: f64,
    /// How many colours are on the screen, counted up to 65,536.
    pub colors: u32,
}

/// What a picture took.
#[derive(Serialize)]
pub struct CostFacts {
    /// Operations of all pixels.
    pub operations: u64,
    /// Of one pixel, in the mean.
    pub mean: f64,
    /// Of the most expensive pixel.
    pub most: u32,
}

impl OutputFacts {
    /// What is said of an output of so many lanes.
    pub fn of(
        name: &str,
        (ty, lanes): (String, u32),
        facts: &PictureFacts,
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
    /// What is said of the cost.
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
    /// For people.
    pub fn text(&self) -> String {
        let [width, height] = self.size;
        let (file, time, frame) = (&self.file, seconds(self.time), self.frame);
        let mut text = format!("{file}: {width}x{height}, {time}, frame {frame}\n");
        for (output, i) in self.outputs.iter().zip(0..) {
            let name = match i {
                0 => "picture".to_string(),
                _ => output.name.clone(),
            };
            let lanes = |all: &[f64]| {
                let all = all.iter().map(|n| number(*n));
                all.collect::<Vec<_>>().join(" ")
            };
            text.push_str(&format!(
                "  {name:9} mean {}, from {} to {}\n",
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
                1 => "one colour".to_string(),
                n if n >= 65_536 => "65536 colours or more".to_string(),
                n => format!("{n} colours"),
            };
            text.push_str(&format!("  {:9} {}, {colors}\n", "", shares.join(", ")));
        }
        let CostFacts { mean, most, .. } = self.cost;
        text.push_str(&format!(
            "  {:9} {mean:.0} operations a pixel, {most} at most\n",
            "cost"
        ));
        if let Some(loops) = &self.loops {
            text.push_str(&loops::table(loops));
        }
        if let Some(numbers) = &self.numbers {
            text.push_str(&numbers::table(numbers));
        }
        if let Some(functions) = &self.functions {
            text.push_str(&functions::table(functions));
        }
        if let Some(output) = &self.output {
            text.push_str(&format!("  {:9} {output}\n", "written"));
        }
        text
    }

    /// For programs.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        format!("{text}\n")
    }
}

/// A number to three digits behind the point.
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
    fn times_and_numbers_are_short() {
        let all = [0.0, 2.0, 0.5, 10.0, 1.0 / 6.0].map(seconds);
        assert_eq!(all, ["0 s", "2 s", "0.5 s", "10 s", "0.167 s"]);
        assert_eq!([-0.0001, 1.5].map(number), ["0.000", "1.500"]);
    }

    #[test]
    fn what_is_there_is_never_told_as_none() {
        let all = [0.0, 1e-7, 0.005, 0.5, 0.9999, 1.0].map(percent);
        assert_eq!(
            all,
            ["0 %", "under 0.01 %", "0.50 %", "50.0 %", "99.9 %", "100 %"]
        );
    }
}
