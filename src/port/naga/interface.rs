//! The resource interface of a shader, for the comments in the output and as JSON.

use super::target::{FirstRow, TargetLanguage};
use serde::Serialize;
use shaderlint_project::SizeTerm;

/// All inputs and outputs of a shader with their bindings.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct HostInterface {
    /// `vertex` or `fragment`.
    pub stage: &'static str,
    /// The name of the entry point.
    pub entry: &'static str,
    /// For a fragment shader: the row of the image that comes first in memory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_row: Option<FirstRow>,
    /// The pass of a project that it draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pass: Option<DrawnPass>,
    /// The uniform buffers: one for all uniforms outside of blocks, one for each block.
    pub buffers: Vec<Buffer>,
    /// The samplers, each as a texture and a sampler binding.
    pub textures: Vec<TexturePair>,
    /// The outputs of the previous stage, or the vertex attributes.
    pub inputs: Vec<Port>,
    /// The outputs of the stage.
    pub outputs: Vec<Port>,
    /// Further remarks for the host.
    pub notes: Vec<String>,
}

/// A pass of a project.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct DrawnPass {
    /// The name, to which texture sources refer.
    pub name: String,
    /// `image`, `buffer`, `cubemap` or `sound`.
    pub kind: &'static str,
    /// The position in the drawing order of a frame; `None` for sound.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<usize>,
    /// The WebGPU texture format of the target.
    pub format: &'static str,
    /// Width and height of the target as expressions; `None` for the size of the image.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<[SizeTerm; 2]>,
    /// An id shared by passes that draw into the same target.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<String>,
}

/// The input of a texture.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct TextureSource {
    /// `texture`, `cubemap`, `volume`, `keyboard`, `video`, `webcam`, `music`, `mic`; `buffer` or
    /// `cubebuffer` for the last output of a pass.
    pub kind: &'static str,
    /// The name of that pass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pass: Option<String>,
    /// `nearest`, `linear` or `mipmap`.
    pub filter: String,
    /// `clamp` or `repeat`.
    pub wrap: String,
}

/// Where a resource is bound.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct BindSlot {
    /// The bind group, descriptor set or register space.
    pub group: u32,
    /// The binding within the group.
    pub binding: u32,
    /// The register or attribute in HLSL and MSL; `None` if group and binding are sufficient.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
}

/// A uniform buffer.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Buffer {
    /// The name of the block; `uniforms` for uniforms outside of blocks.
    pub name: String,
    /// Where it is bound.
    pub slot: BindSlot,
    /// Size in bytes.
    pub size: u32,
    /// The members, with nested structs flattened.
    pub members: Vec<BufferMember>,
}

/// A scalar, vector or matrix in a buffer, or an array of them.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct BufferMember {
    /// The WebGL name: `lights[1].color`.
    pub name: String,
    /// The GLSL type without the array size. A `bool` is stored as an integer that is 0 for false.
    #[serde(rename = "type")]
    pub ty: String,
    /// Offset in bytes from the start of the buffer.
    pub offset: u32,
    /// Number of array elements and their stride.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<Repeated>,
    /// Number of columns of a matrix and their stride.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<Repeated>,
    /// Number of rows and their stride, for a row-major matrix.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<Repeated>,
}

/// A sequence of equally spaced parts.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Repeated {
    /// Number of parts.
    pub count: u32,
    /// Distance between parts in bytes.
    pub stride: u32,
}

/// A sampler of the shader.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct TexturePair {
    /// The WebGL name.
    pub name: String,
    /// The GLSL type of the sampler.
    #[serde(rename = "type")]
    pub ty: &'static str,
    /// Where the texture is bound.
    pub texture: BindSlot,
    /// Where the sampler is bound.
    pub sampler: BindSlot,
    /// The input of the texture, if known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<TextureSource>,
}

/// A value that is passed between stages.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Port {
    /// The name in the shader.
    pub name: String,
    /// The GLSL type of the value.
    #[serde(rename = "type")]
    pub ty: String,
    /// The location number.
    pub location: u32,
}

impl HostInterface {
    /// The lines of the comment at the start of the output.
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
                    HostInterface::UNIFORMS => "uniforms".to_string(),
                    name => format!("block {name}"),
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
                "{}: texture of {}{shown}; {sampler}: its sampler",
                place(&texture.texture),
                texture.name
            ));
        }
        if let (TargetLanguage::Hlsl, Some(first)) = (language, self.textures.first()) {
            // Naga's HLSL writer puts all samplers into one heap.
            let group = first.sampler.group;
            lines.push(format!(
                "register(t{group}, space255): nagaGroup{group}SamplerIndexArray; each entry is the \
                 index of a sampler in nagaSamplerHeap at register(s0, space0) or, for comparison \
                 samplers, in nagaComparisonSamplerHeap at register(s0, space1)"
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

    /// The name of the buffer for uniforms outside of blocks.
    pub(super) const UNIFORMS: &'static str = "uniforms";
}
