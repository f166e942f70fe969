//! What a host must know of a shader to feed it: in the head of what is written, and as JSON.

use super::target::{FirstRow, TargetLanguage};
use crate::draw::SizeTerm;
use serde::Serialize;

/// Everything that a shader takes and gives, with its place.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct HostInterface {
    /// `vertex` or `fragment`.
    pub stage: &'static str,
    /// The function that the host calls.
    pub entry: &'static str,
    /// Which row of what is drawn lies first in memory, for a fragment shader.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_row: Option<FirstRow>,
    /// What is drawn, where that is a pass of a project.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pass: Option<DrawnPass>,
    /// The uniforms: those that stand alone in one buffer, each block in its own.
    pub buffers: Vec<Buffer>,
    /// The samplers: each is a texture and a way to sample it.
    pub textures: Vec<TexturePair>,
    /// What the stage before gives, or the attributes of the vertex.
    pub inputs: Vec<Port>,
    /// What the stage gives on.
    pub outputs: Vec<Port>,
    /// What else there is to know.
    pub notes: Vec<String>,
}

/// A pass of a project.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct DrawnPass {
    /// Its name, by which textures say what they show.
    pub name: String,
    /// `image`, `buffer`, `cubemap` or `sound`.
    pub kind: &'static str,
    /// Its number among the passes of a frame, which are drawn one after another; none for sound.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<usize>,
    /// What it draws into, as WebGPU calls it.
    pub format: &'static str,
    /// The width and height of that, where they are not those of the picture, as formulas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<[SizeTerm; 2]>,
    /// What passes that draw into the same share.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<String>,
}

/// What a texture of a pass shows.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct TextureSource {
    /// `texture`, `cubemap`, `volume`, `keyboard`, `video`, `webcam`, `music`, `mic`; `buffer` or
    /// `cubebuffer` for what a pass has drawn last.
    pub kind: &'static str,
    /// The name of that pass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pass: Option<String>,
    /// `nearest`, `linear` or `mipmap`.
    pub filter: String,
    /// `clamp` or `repeat`.
    pub wrap: String,
}

/// Where the host binds something.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct BindSlot {
    /// The group, set or space.
    pub group: u32,
    /// The number in it.
    pub binding: u32,
    /// What the language itself calls the place, where that is not the group and the binding.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
}

/// A buffer of uniforms.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Buffer {
    /// The block; `uniforms` for what stands in none.
    pub name: String,
    /// Where it is bound.
    pub slot: BindSlot,
    /// In bytes.
    pub size: u32,
    /// What lies in it.
    pub members: Vec<BufferMember>,
}

/// A number, vector or matrix in a buffer, or an array of them.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct BufferMember {
    /// As WebGL names it: `lights[1].color`.
    pub name: String,
    /// Its type in GLSL, without the array. A `bool` is a number, which is 0 where it is false.
    #[serde(rename = "type")]
    pub ty: String,
    /// In bytes from the start of the buffer.
    pub offset: u32,
    /// The number of elements and the bytes from one to the next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<Repeated>,
    /// The number of columns of a matrix and the bytes from one to the next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<Repeated>,
    /// The same of its rows, of a matrix that lies by them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<Repeated>,
}

/// Equal parts, one behind the other.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Repeated {
    /// How many there are.
    pub count: u32,
    /// In bytes.
    pub stride: u32,
}

/// A sampler of the shader.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct TexturePair {
    /// As WebGL names it.
    pub name: String,
    /// Its type in GLSL.
    #[serde(rename = "type")]
    pub ty: &'static str,
    /// Where the texture is bound.
    pub texture: BindSlot,
    /// Where the way to sample it is bound.
    pub sampler: BindSlot,
    /// What it shows, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<TextureSource>,
}

/// Something that passes between a stage and its neighbour.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Port {
    /// As the shader calls it.
    pub name: String,
    /// Its type in GLSL.
    #[serde(rename = "type")]
    pub ty: String,
    /// Its number.
    pub location: u32,
}

impl HostInterface {
    /// The lines of the head.
    pub(super) fn lines(&self, language: TargetLanguage) -> Vec<String> {
        let place = |slot: &BindSlot| match &slot.place {
            Some(place) => place.clone(),
            None => format!("group {}, binding {}", slot.group, slot.binding),
        };
        let mut lines = Vec::new();
        for buffer in &self.buffers {
            let members = buffer.members.iter();
            let members = members.map(|m| format!("{} at {}", m.name, m.offset));
            lines.push(format!(
                "{}: {}, {} bytes: {}",
                place(&buffer.slot),
                match buffer.name.as_str() {
                    HostInterface::UNIFORMS => "the uniforms".to_string(),
                    name => format!("the block {name}"),
                },
                buffer.size,
                members.collect::<Vec<_>>().join(", ")
            ));
        }
        for texture in &self.textures {
            let sampler = match language {
                TargetLanguage::Wgsl | TargetLanguage::Spirv => {
                    format!("binding {}", texture.sampler.binding)
                }
                _ => place(&texture.sampler),
            };
            let shown = match &texture.source {
                Some(TextureSource {
                    pass: Some(name), ..
                }) => format!(", {name}"),
                _ => String::new(),
            };
            lines.push(format!(
                "{}: the texture of {}{shown}; {sampler}: how it is sampled",
                place(&texture.texture),
                texture.name
            ));
        }
        if let (TargetLanguage::Hlsl, Some(first)) = (language, self.textures.first()) {
            // Naga's writer puts all samplers of a program into one heap, as Direct3D does.
            let group = first.sampler.group;
            lines.push(format!(
                "register(t{group}, space255): nagaGroup{group}SamplerIndexArray, by entry the number \
                 of a sampler in nagaSamplerHeap at register(s0, space0) or, where it compares, \
                 nagaComparisonSamplerHeap at register(s0, space1)"
            ));
        }
        for (ports, word) in [(&self.inputs, "in"), (&self.outputs, "out")] {
            let ports: Vec<String> = ports
                .iter()
                .map(|p| format!("{} {} at {}", p.ty, p.name, p.location))
                .collect();
            if !ports.is_empty() {
                lines.push(format!("{word}: {}", ports.join(", ")));
            }
        }
        lines.extend(self.notes.iter().cloned());
        lines
    }

    /// The name of the buffer of what stands in no block.
    pub(super) const UNIFORMS: &'static str = "uniforms";
}
