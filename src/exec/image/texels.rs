//! The texels of a level.

/// The texels of one level, layer by layer, each layer row by row, the row of coordinate 0 first.
#[derive(Clone, PartialEq, Debug)]
pub enum Texels {
    /// Of formats of 8 bits that give a `vec4` of 0 to 1.
    Unorm8(Vec<[u8; 4]>),
    /// Of formats that give `vec4`.
    Float(Vec<[f32; 4]>),
    /// Of formats that give `ivec4`.
    Int(Vec<[i32; 4]>),
    /// Of formats that give `uvec4`.
    Uint(Vec<[u32; 4]>),
}

impl Texels {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Texels::Unorm8(texels) => texels.len(),
            Texels::Float(texels) => texels.len(),
            Texels::Int(texels) => texels.len(),
            Texels::Uint(texels) => texels.len(),
        }
    }

    /// Colours as a canvas keeps them: what is not a number is 0.
    pub fn of_colors(colors: &[[f32; 4]]) -> Texels {
        let byte = |part: f32| (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        Texels::Unorm8(colors.iter().map(|color| color.map(byte)).collect())
    }

    /// What one gives, as floats; nothing of those that there are not.
    pub fn color(&self, number: usize) -> [f32; 4] {
        let color = match self {
            Texels::Unorm8(texels) => texels
                .get(number)
                .map(|texel| texel.map(|part| f32::from(part) / 255.0)),
            Texels::Float(texels) => texels.get(number).copied(),
            Texels::Int(texels) => texels.get(number).map(|t| t.map(|part| part as f32)),
            Texels::Uint(texels) => texels.get(number).map(|t| t.map(|part| part as f32)),
        };
        color.unwrap_or_default()
    }

    /// Whether lookups give integers.
    pub(super) fn whole(&self) -> bool {
        matches!(self, Texels::Int(_) | Texels::Uint(_))
    }
}
