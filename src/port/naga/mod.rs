//! Translates checked passes to WGSL, SPIR-V, HLSL and MSL.
//!
//! [`lower`] is a fold over the regions of the IR (`shaderlint_ir`): places become naga's pointers,
//! operations naga's expressions, control flow naga's statements. Samplers are split into a texture
//! and a sampler, and rows are flipped, only here. [`write`] validates the result with naga and
//! writes it. Unsupported constructs are rejected, with the span and the reason.
//!
//! The module has one entry point, `fragment_main`. All uniforms are members of one struct at
//! binding 0 of group 0; the sampler number `n`, in source order, is a texture at binding `2n + 1`
//! and a sampler at `2n + 2`.

mod body;
mod builtin;
mod call;
mod entry;
mod function;
mod global;
mod hlsl;
mod interface;
mod known;
mod lower;
mod matrix;
mod op;
mod place;
mod port;
mod region;
mod sampler;
mod special;
mod stored;
mod target;
mod texel;
mod texture;
mod types;
mod uniform;
mod write;

pub use interface::{
    BindSlot, Buffer, BufferMember, DrawnPass, HostInterface, Port, Repeated, TexturePair,
    TextureSource,
};
pub use lower::{Lowered, lower};
pub use target::{FirstRow, LowerOptions, Output, Refused, TargetLanguage};
pub use write::write;

use super::credits;
use super::payload::{InputData, PassData, passes};
use shaderlint_diagnostic::Severity;
use shaderlint_project::Project;
use shaderlint_project::{Composed, PassUnit};
use shaderlint_semantic::Pass;

/// A translated shader.
#[derive(Clone, Debug)]
pub struct TranslatedShader {
    /// The source text, or the binary for SPIR-V.
    pub text: Output,
    /// The resource interface.
    pub interface: HostInterface,
}

/// Translates a pass; `image` is the first row of the image. Returns `None` if it does not
/// compile.
pub fn translate(
    project: &Project,
    composed: &Composed,
    unit: &PassUnit,
    language: TargetLanguage,
    image: FirstRow,
) -> Result<Option<TranslatedShader>, Refused> {
    let analysis = composed.analysis(unit);
    let is_error = |d: &shaderlint_diagnostic::Diagnostic| d.severity == Severity::Error;
    if analysis.diagnostics.iter().any(is_error) {
        return Ok(None);
    }
    let passes = passes(project, composed);
    let is_read = |name: &str| {
        let mut inputs = passes.iter().flat_map(|p| p.inputs.iter().flatten());
        inputs.any(|i| {
            i.buffer
                .and_then(|b| passes.get(b))
                .is_some_and(|p| p.name == name)
        })
    };
    let running = composed.units.iter().filter(|u| u.kind != Pass::Common);
    let drawn = running.zip(&passes).find(|(u, _)| u.pass == unit.pass);
    let drawn = drawn.map(|(_, data)| data);
    // Passes read buffers by row number; only an image that is displayed is flipped.
    let is_image = unit.kind == Pass::Image && !drawn.is_some_and(|p| is_read(&p.name));
    let options = LowerOptions {
        language,
        first_row: if is_image { image } else { FirstRow::Bottom },
        vertex: None,
    };
    let mut lowered = lower(&analysis.program, options)?;
    if let Some(drawn) = drawn {
        describe(&mut lowered.interface, drawn, &passes);
    }
    let text = write(&lowered, &credits::lines(project))?;
    let interface = lowered.interface;
    Ok(Some(TranslatedShader { text, interface }))
}

/// How many passes are drawn before one: first buffers, then cube maps, then the image, each in
/// project order.
fn earlier(drawn: &PassData, passes: &[PassData]) -> usize {
    let rank = |kind: &str| {
        ["buffer", "cubemap", "image"]
            .iter()
            .position(|k| *k == kind)
    };
    let own = rank(drawn.kind);
    let of_kind = passes.iter().filter(|p| p.kind == drawn.kind);
    let before = of_kind.take_while(|p| !std::ptr::eq(*p, drawn)).count();
    let ranks = passes.iter().filter_map(|p| rank(p.kind));
    before + ranks.filter(|r| Some(*r) < own).count()
}

/// Adds the target of a pass and the inputs of its textures to the interface.
fn describe(interface: &mut HostInterface, drawn: &PassData, passes: &[PassData]) {
    let own = drawn.own.as_ref();
    interface.pass = Some(DrawnPass {
        name: drawn.name.clone(),
        kind: drawn.kind,
        order: (drawn.kind != "sound").then(|| earlier(drawn, passes)),
        format: match (drawn.kind, own) {
            ("buffer", None) => "rgba32float",
            ("cubemap", _) => "rgba16float",
            (_, Some(own)) if own.float => "rgba32float",
            _ => "rgba8unorm",
        },
        size: own.and_then(|own| own.size).cloned(),
        target: own.and_then(|own| own.into).map(str::to_string),
    });
    let named = |number: usize, input: &InputData| match input.uniform {
        Some(name) => name.to_string(),
        None => format!("iChannel{number}"),
    };
    for texture in &mut interface.textures {
        let inputs = drawn.inputs.iter().enumerate();
        let mut inputs = inputs.filter_map(|(i, input)| Some((i, input.as_ref()?)));
        let found = inputs.find(|(i, input)| named(*i, input) == texture.name);
        let Some((_, input)) = found else { continue };
        let pass = match input.kind {
            "cubebuffer" => passes.iter().find(|p| p.kind == "cubemap"),
            _ => input.buffer.and_then(|b| passes.get(b)),
        };
        texture.source = Some(TextureSource {
            kind: input.kind,
            pass: pass.map(|p| p.name.clone()),
            filter: input.filter.to_string(),
            wrap: input.wrap.to_string(),
        });
    }
}
