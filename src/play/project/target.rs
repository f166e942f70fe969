//! Render targets: pairs of images, one of which is read while the other is drawn.

use super::shader::size_of;
use super::{PlaybackProblem, Player};
use shaderlint_exec::{Image, ImageShape, Texels};
use shaderlint_project::{InputKind, OutputId, Project, ProjectPass, Wrapper};
use shaderlint_semantic::Pass;
use std::sync::Arc;

/// Side of a cube map in pixels.
pub(super) const CUBE_SIDE: u32 = 1024;

/// Maximum number of texels of all render targets.
const MAX_TEXELS: u64 = 1 << 25;

/// Directions of the faces +x, -x, +y, -y, +z, -z at (0,0), (1,0), (1,1) and (0,1).
#[rustfmt::skip]
pub(super) const CUBE_CORNERS: [[f64; 12]; 6] = [
    [1.0, 1.0, 1.0, 1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0],
    [-1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, -1.0, -1.0, -1.0],
    [-1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, 1.0, 1.0],
    [-1.0, -1.0, 1.0, 1.0, -1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, -1.0],
    [-1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0],
    [1.0, 1.0, -1.0, -1.0, 1.0, -1.0, -1.0, -1.0, -1.0, 1.0, -1.0, -1.0],
];

/// The texel format of a render target.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Depth {
    /// 8-bit, as a canvas.
    Bytes,
    /// 16-bit floats.
    Half,
    /// 32-bit floats.
    Float,
}

pub(super) struct ImagePair {
    shape: ImageShape,
    pub side: [u32; 2],
    depth: Depth,
    /// Whether a channel reads it with mipmaps.
    has_levels: bool,
    empty: Arc<Image>,
    /// The image that channels read.
    front: Arc<Image>,
    /// The image that is drawn next.
    back: Arc<Image>,
}

impl ImagePair {
    pub fn image(&self) -> Arc<Image> {
        Arc::clone(&self.front)
    }

    pub fn clear(&mut self) {
        self.front = Arc::clone(&self.empty);
        self.back = Arc::clone(&self.empty);
    }

    /// Stores the pixels of a draw and swaps the images. Pixels that were not drawn keep the value
    /// of two frames ago.
    pub fn take(&mut self, mut pixels: Vec<[f32; 4]>, covered: &[bool]) {
        if covered.contains(&false)
            && let Some(old) = self.back.level(0)
        {
            let all = pixels.iter_mut().zip(covered).enumerate();
            for (at, (pixel, _)) in all.filter(|(_, (_, is_covered))| !**is_covered) {
                *pixel = old.color(at);
            }
        }
        let texels = match self.depth {
            Depth::Bytes => Texels::of_colors(&pixels),
            Depth::Float => Texels::Float(pixels),
            Depth::Half => {
                for lane in pixels.iter_mut().flatten() {
                    *lane = half(*lane);
                }
                Texels::Float(pixels)
            }
        };
        if let Some(image) = image(self.shape, self.side, texels, self.has_levels) {
            self.back = Arc::clone(&self.front);
            self.front = Arc::new(image);
        }
    }
}

fn image(shape: ImageShape, side: [u32; 2], texels: Texels, has_levels: bool) -> Option<Image> {
    let [width, height] = side;
    let image = Image::new(shape, [width, height, layers(shape)], texels).ok()?;
    Some(if has_levels {
        image.with_levels()
    } else {
        image
    })
}

fn layers(shape: ImageShape) -> u32 {
    if shape == ImageShape::Cube { 6 } else { 1 }
}

/// The nearest 16-bit float, halves to even; values that are too large become infinite.
fn half(number: f32) -> f32 {
    // The smallest value that rounds to infinity.
    const LIMIT: f32 = 65_520.0;
    if number.is_nan() || number.is_infinite() {
        return number;
    }
    if number.abs() >= LIMIT {
        return f32::INFINITY.copysign(number);
    }
    let exponent = (number.to_bits() >> 23 & 0xff) as i32 - 127;
    // Ten bits of fraction, fewer for subnormal numbers.
    let step = f32::from_bits(((exponent.max(-14) - 10 + 127) as u32) << 23);
    (number / step).round_ties_even() * step
}

/// Creates the render targets of all passes, and of outputs that are read but not drawn.
pub(super) fn make(player: &mut Player, project: &Project) -> Result<(), PlaybackProblem> {
    let mut targets: Vec<(OutputId, ImageShape, [u32; 2], Depth)> = Vec::new();
    let reads = |id: &OutputId| {
        let mut inputs = project.passes.iter().flat_map(|p| &p.inputs);
        inputs.any(|i| i.kind == InputKind::Buffer && i.id == id.0)
    };
    for pass in &mut player.passes {
        let Some(of) = project.passes.get(pass.index) else {
            continue;
        };
        let id = of.output.clone().unwrap_or(OutputId(String::new()));
        let spot = match of.kind {
            Pass::Cubemap => (
                OutputId(OutputId::CUBE.to_string()),
                ImageShape::Cube,
                [CUBE_SIDE; 2],
                Depth::Half,
            ),
            Pass::Buffer => spot(project, of, id, player.size),
            Pass::Image if !id.0.is_empty() && reads(&id) => spot(project, of, id, player.size),
            Pass::Image | Pass::Common | Pass::Sound => continue,
        };
        // Passes with the same name share a target; a pass without a name has its own.
        let known = targets
            .iter()
            .position(|w| w.0 == spot.0 && !spot.0.0.is_empty());
        pass.target = Some(known.unwrap_or(targets.len()));
        if known.is_none() {
            targets.push(spot);
        }
    }
    let texels = targets.iter().map(|(_, shape, [width, height], _)| {
        2 * u64::from(*width) * u64::from(*height) * u64::from(layers(*shape))
    });
    let texels: u64 = texels.sum();
    if texels > MAX_TEXELS {
        return Err(PlaybackProblem::TooLarge {
            texels,
            most: MAX_TEXELS,
        });
    }
    for (id, shape, side, depth) in targets {
        let count = side.iter().map(|s| *s as usize).product::<usize>() * layers(shape) as usize;
        let texels = match depth {
            Depth::Bytes => Texels::Unorm8(vec![[0; 4]; count]),
            Depth::Half | Depth::Float => Texels::Float(vec![[0.0; 4]; count]),
        };
        let has_levels = is_mipmapped(project, &id, shape);
        let Some(empty) = image(shape, side, texels, has_levels) else {
            continue;
        };
        let empty = Arc::new(empty);
        player.targets.push(ImagePair {
            shape,
            side,
            depth,
            has_levels,
            front: Arc::clone(&empty),
            back: Arc::clone(&empty),
            empty,
        });
    }
    Ok(())
}

fn spot(
    project: &Project,
    pass: &ProjectPass,
    id: OutputId,
    canvas: [u32; 2],
) -> (OutputId, ImageShape, [u32; 2], Depth) {
    let is_float = pass.draw.is_float || (pass.wrapper == Wrapper::Player);
    let depth = if is_float { Depth::Float } else { Depth::Bytes };
    (id, ImageShape::Flat, size_of(project, pass, canvas), depth)
}

/// Whether a channel reads a target with mipmaps.
fn is_mipmapped(project: &Project, id: &OutputId, shape: ImageShape) -> bool {
    let kind = match shape {
        ImageShape::Cube => InputKind::Cubemap,
        _ => InputKind::Buffer,
    };
    let mut inputs = project.passes.iter().flat_map(|p| &p.inputs);
    inputs.any(|i| i.kind == kind && i.id == id.0 && i.sampler.has_mipmaps())
}

#[cfg(test)]
mod tests {
    use super::half;

    #[test]
    fn colours_are_rounded_to_half_floats() {
        let all = [
            (1.0, 1.0),
            (2049.0, 2048.0),
            (2051.0, 2052.0),
            (65_519.0, 65_504.0),
            (65_520.0, f32::INFINITY),
            (-1e9, f32::NEG_INFINITY),
            (1e-9, 0.0),
            (6e-8, 5.960_464_5e-8),
            (0.1, 0.099_975_586),
        ];
        for (number, expected) in all {
            assert_eq!(half(number), expected, "{number}");
        }
        assert!(half(f32::NAN).is_nan());
    }
}
