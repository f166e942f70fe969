//! Texel storage.

/// The texels of one level: by layer, then by row, starting with the row at coordinate 0.
#[derive(Clone, PartialEq, Debug)]
pub enum Texels {
    /// 8-bit normalised formats, read as a `vec4` in 0..1.
    Unorm8(Vec<[u8; 4]>),
    /// Float formats, read as `vec4`.
    Float(Vec<[f32; 4]>),
    /// Signed integer formats, read as `ivec4`.
    Int(Vec<[i32; 4]>),
    /// Unsigned integer formats, read as `uvec4`.
    Uint(Vec<[u32; 4]>),
}

impl Texels {
    /// The number of texels.
    pub fn count(&self) -> usize {
        match self {
            Texels::Unorm8(texels) => texels.len(),
            Texels::Float(texels) => texels.len(),
            Texels::Int(texels) => texels.len(),
            Texels::Uint(texels) => texels.len(),
        }
    }

    /// Converts colours to 8 bits, as a canvas stores them; NaN becomes 0.
    pub fn of_colors(colors: &[[f32; 4]]) -> Texels {
        let byte = |part: f32| (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        Texels::Unorm8(colors.iter().map(|color| color.map(byte)).collect())
    }

    /// A texel as floats; zero if there is no such texel.
    pub fn color(&self, index: usize) -> [f32; 4] {
        let color = match self {
            Texels::Unorm8(texels) => texels
                .get(index)
                .map(|texel| texel.map(|part| f32::from(part) / 255.0)),
            Texels::Float(texels) => texels.get(index).copied(),
            Texels::Int(texels) => texels.get(index).map(|t| t.map(|part| part as f32)),
            Texels::Uint(texels) => texels.get(index).map(|t| t.map(|part| part as f32)),
        };
        color.unwrap_or_default()
    }

    /// Whether lookups return integers.
    pub(super) fn are_integers(&self) -> bool {
        matches!(self, Texels::Int(_) | Texels::Uint(_))
    }
}
