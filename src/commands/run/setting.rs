//! What is drawn, and how.

use serde::{Deserialize, Serialize};
use shaderlint_exec::{RayProbe, Watch};
use shaderlint_play::Decode;

/// A variable on a source line.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub struct Show {
    /// Name of the variable.
    pub name: String,
    /// Line number, from 1.
    pub line: u32,
}

/// What a heat map shows of each pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum HeatMap {
    /// Loop iterations.
    Steps,
    /// Operations.
    Cost,
    /// Percentage of the work of its 8x4 pixel group that the pixel only waits for.
    #[cfg_attr(feature = "cli", value(alias = "overdraw"))]
    #[serde(alias = "overdraw")]
    Divergence,
    /// Values that are not finite.
    Nan,
    /// The largest slope of the scene's distance along the ray.
    Slope,
}

/// Which marching loop is observed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum ObservedRays {
    /// None.
    #[default]
    Nothing,
    /// The first loop that follows rays from the camera.
    Camera,
    /// The loop of a probe.
    Probe(RayProbe),
}

/// A JSON object with the values of uniforms.
#[derive(Clone, Copy, Debug)]
pub struct UniformText<'a> {
    /// Its name in messages.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// The settings of a draw.
#[derive(Clone, Copy)]
pub struct ShotSetting<'a> {
    /// Size of the image in pixels.
    pub size: [u32; 2],
    /// Number of threads.
    pub threads: usize,
    /// The pass to show; the image pass by default.
    pub pass: Option<&'a str>,
    /// The variable to show instead of the output.
    pub show: Option<&'a Show>,
    /// The values of uniforms.
    pub uniforms: Option<UniformText<'a>>,
    /// The marching loop that is observed.
    pub rays: ObservedRays,
    /// What the VM records.
    pub watch: Watch,
    /// Whether pixels can be traced.
    pub trace: bool,
    /// Decoder for embedded images.
    pub decode: Option<Decode>,
}

/// What is shown of a frame.
#[derive(Clone, Copy, Default)]
pub struct FrameView<'a> {
    /// A heat map instead of the image.
    pub heat: Option<HeatMap>,
    /// The variable of [`ShotSetting::show`] instead of the image.
    pub show: Option<&'a Show>,
    /// Whether loops, functions and invalid numbers are reported.
    pub report: bool,
}

/// How far a run is.
#[derive(Clone, Copy)]
pub struct RunProgress {
    /// The number of images that are drawn, and of all.
    pub images: [usize; 2],
    /// The next frame of those on which the image depends, and the last one.
    pub frames: [u32; 2],
}
