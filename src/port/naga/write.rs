//! Naga's check and its writers.

use super::Refused;
use super::entry::ENTRY;
use super::lower::Lowered;
use crate::text::Span;
use ::naga::back::{hlsl, msl, spv, wgsl};
use ::naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use ::naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::error::Error;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The languages that naga writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TargetLanguage {
    /// WebGPU's language.
    Wgsl,
    /// Vulkan's binary form.
    Spirv,
    /// Direct3D's language, shader model 5.1.
    Hlsl,
    /// Metal's language, version 2.0.
    Msl,
}

impl TargetLanguage {
    /// All of them.
    pub const ALL: [TargetLanguage; 4] = [
        TargetLanguage::Wgsl,
        TargetLanguage::Spirv,
        TargetLanguage::Hlsl,
        TargetLanguage::Msl,
    ];

    /// How the names of its files end.
    pub const fn ending(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "wgsl",
            TargetLanguage::Spirv => "spv",
            TargetLanguage::Hlsl => "hlsl",
            TargetLanguage::Msl => "metal",
        }
    }

    /// As it is called.
    pub const fn name(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "WGSL",
            TargetLanguage::Spirv => "SPIR-V",
            TargetLanguage::Hlsl => "HLSL",
            TargetLanguage::Msl => "MSL",
        }
    }
}

/// What a file holds.
pub type Output = Vec<u8>;

/// Checks a pass and writes it. `credits` are the lines that say who made it.
pub fn write(
    lowered: &Lowered,
    language: TargetLanguage,
    credits: &[String],
) -> Result<Output, Refused> {
    let written = catch_unwind(AssertUnwindSafe(|| {
        let info = check(lowered)?;
        emit(lowered, &info, language)
            .map_err(|why| Refused::new(Span::default(), format!("{}: {why}", language.name())))
    }));
    let body = written.unwrap_or_else(|_| {
        let message = format!("naga cannot write this as {}", language.name());
        Err(Refused::new(Span::default(), message))
    })?;
    if language == TargetLanguage::Spirv {
        return Ok(body);
    }
    let mut head = String::new();
    for line in credits.iter().chain(&lowered.legend) {
        let _ = writeln!(head, "// {line}");
    }
    if language == TargetLanguage::Wgsl {
        // GLSL leaves the level of detail undefined where not all fragments look it up; WGSL would
        // refuse the shader.
        head.push_str("diagnostic(off, derivative_uniformity);\n\n");
    }
    let mut text = head.into_bytes();
    text.extend(body);
    Ok(text)
}

fn check(lowered: &Lowered) -> Result<ModuleInfo, Refused> {
    // The halves of `packHalf2x16`, which all four languages have.
    let capabilities = Capabilities::default() | Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    let mut validator = Validator::new(ValidationFlags::all(), capabilities);
    validator.validate(&lowered.module).map_err(|error| {
        let place = error.spans().next().map(|(span, _)| *span);
        let place = place.and_then(|span| span.to_range());
        let span = place.map_or(Span::default(), |range| Span {
            start: range.start as u32,
            end: range.end as u32,
        });
        let inner = error.into_inner();
        Refused::new(span, format!("naga refuses this: {}", reasons(&inner)))
    })
}

/// An error and what it comes from.
fn reasons(error: &dyn Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(inner) = source {
        let _ = write!(text, ": {inner}");
        source = inner.source();
    }
    text
}

fn emit(lowered: &Lowered, info: &ModuleInfo, language: TargetLanguage) -> Result<Vec<u8>, String> {
    let module = &lowered.module;
    match language {
        TargetLanguage::Wgsl => wgsl::write_string(module, info, wgsl::WriterFlags::empty())
            .map(String::into_bytes)
            .map_err(|e| reasons(&e)),
        TargetLanguage::Spirv => {
            let options = spv::Options {
                lang_version: (1, 3),
                flags: spv::WriterFlags::DEBUG | spv::WriterFlags::LABEL_VARYINGS,
                bounds_check_policies: policies(),
                force_loop_bounding: false,
                ..spv::Options::default()
            };
            let words = spv::write_vec(module, info, &options, None).map_err(|e| reasons(&e))?;
            Ok(words.iter().flat_map(|w| w.to_le_bytes()).collect())
        }
        TargetLanguage::Hlsl => {
            let options = hlsl::Options {
                force_loop_bounding: false,
                ..hlsl::Options::default()
            };
            let pipeline = hlsl::PipelineOptions::default();
            let mut text = String::new();
            hlsl::Writer::new(&mut text, &options, &pipeline)
                .write(module, info, None)
                .map_err(|e| reasons(&e))?;
            Ok(text.into_bytes())
        }
        TargetLanguage::Msl => {
            let pipeline = msl::PipelineOptions::default();
            let (text, _) = msl::write_string(module, info, &metal(lowered), &pipeline)
                .map_err(|e| reasons(&e))?;
            Ok(text.into_bytes())
        }
    }
}

/// What lies outside an array or a texture is never touched, as in WebGL.
fn policies() -> BoundsCheckPolicies {
    BoundsCheckPolicies {
        index: BoundsCheckPolicy::Restrict,
        buffer: BoundsCheckPolicy::Restrict,
        image_load: BoundsCheckPolicy::ReadZeroSkipWrite,
        binding_array: BoundsCheckPolicy::Restrict,
    }
}

/// Metal counts buffers, textures and samplers each for themselves: the uniforms are buffer 0, the
/// sampler with number `n` is texture `n` and sampler `n`.
fn metal(lowered: &Lowered) -> msl::Options {
    let mut resources = msl::EntryPointResources::default();
    for (_, variable) in lowered.module.global_variables.iter() {
        let Some(binding) = variable.binding else {
            continue;
        };
        let slot = (binding.binding.saturating_sub(1) / 2) as u8;
        let target = match binding.binding {
            0 => msl::BindTarget {
                buffer: Some(0),
                ..msl::BindTarget::default()
            },
            n if n % 2 == 1 => msl::BindTarget {
                texture: Some(slot),
                ..msl::BindTarget::default()
            },
            _ => msl::BindTarget {
                sampler: Some(msl::BindSamplerTarget::Resource(slot)),
                ..msl::BindTarget::default()
            },
        };
        resources.resources.insert(binding, target);
    }
    msl::Options {
        lang_version: (2, 0),
        per_entry_point_map: [(ENTRY.to_string(), resources)].into(),
        fake_missing_bindings: false,
        bounds_check_policies: policies(),
        force_loop_bounding: false,
        ..msl::Options::default()
    }
}
