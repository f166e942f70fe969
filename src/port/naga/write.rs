//! Validates the module with naga and writes it.

use super::hlsl::with_lists;
use super::interface::BindSlot;
use super::lower::Lowered;
use super::port::stage_name;
use super::target::{Output, Refused, TargetLanguage};
use ::naga::back::{hlsl, msl, spv, wgsl};
use ::naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use ::naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use shaderlint_semantic::Stage;
use shaderlint_text::Span;
use std::error::Error;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Validates a shader and writes it. `credits` are put into a comment at the start.
///
/// # Errors
/// If naga or the target language does not support something.
pub fn write(lowered: &Lowered, credits: &[String]) -> Result<Output, Refused> {
    let language = lowered.language;
    let written = catch_unwind(AssertUnwindSafe(|| {
        let info = check(lowered)?;
        emit(lowered, &info)
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
    for line in credits.iter().chain(&lowered.interface.lines(language)) {
        let _ = writeln!(head, "// {line}");
    }
    if language == TargetLanguage::Wgsl && lowered.interface.stage == stage_name(Stage::Fragment) {
        // GLSL leaves derivatives undefined in non-uniform control flow; WGSL would reject the
        // shader.
        head.push_str("diagnostic(off, derivative_uniformity);\n\n");
    }
    let mut text = head.into_bytes();
    text.extend(body);
    Ok(text)
}

fn check(lowered: &Lowered) -> Result<ModuleInfo, Refused> {
    // For `packHalf2x16`, which all four target languages have.
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
        Refused::new(span, format!("naga rejects this: {}", reasons(&inner)))
    })
}

/// An error with its causes.
fn reasons(error: &dyn Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(inner) = source {
        let _ = write!(text, ": {inner}");
        source = inner.source();
    }
    text
}

fn emit(lowered: &Lowered, info: &ModuleInfo) -> Result<Vec<u8>, String> {
    let module = &lowered.module;
    match lowered.language {
        TargetLanguage::Wgsl => wgsl::write_string(module, info, wgsl::WriterFlags::empty())
            .map(String::into_bytes)
            .map_err(|e| reasons(&e)),
        TargetLanguage::Spirv => {
            let options = spv::Options {
                lang_version: (1, 3),
                flags: spv::WriterFlags::DEBUG
                    | spv::WriterFlags::LABEL_VARYINGS
                    | spv::WriterFlags::ADJUST_COORDINATE_SPACE,
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
            Ok(with_lists(&text).into_bytes())
        }
        TargetLanguage::Msl => {
            let pipeline = msl::PipelineOptions::default();
            let (text, _) = msl::write_string(module, info, &metal(lowered), &pipeline)
                .map_err(|e| reasons(&e))?;
            Ok(text.into_bytes())
        }
    }
}

/// Accesses outside of arrays and textures are prevented, as in WebGL.
fn policies() -> BoundsCheckPolicies {
    BoundsCheckPolicies {
        index: BoundsCheckPolicy::Restrict,
        buffer: BoundsCheckPolicy::Restrict,
        image_load: BoundsCheckPolicy::ReadZeroSkipWrite,
        binding_array: BoundsCheckPolicy::Restrict,
    }
}

/// Metal numbers buffers, textures and samplers separately, in the order of the interface.
fn metal(lowered: &Lowered) -> msl::Options {
    let mut resources = msl::EntryPointResources::default();
    let place = |slot: &BindSlot| ::naga::ResourceBinding {
        group: slot.group,
        binding: slot.binding,
    };
    let interface = &lowered.interface;
    for (number, buffer) in (0..).zip(&interface.buffers) {
        let target = msl::BindTarget {
            buffer: Some(number),
            ..msl::BindTarget::default()
        };
        resources.resources.insert(place(&buffer.slot), target);
    }
    for (number, texture) in (0..).zip(&interface.textures) {
        let image = msl::BindTarget {
            texture: Some(number),
            ..msl::BindTarget::default()
        };
        resources.resources.insert(place(&texture.texture), image);
        let sampler = msl::BindTarget {
            sampler: Some(msl::BindSamplerTarget::Resource(number)),
            ..msl::BindTarget::default()
        };
        resources.resources.insert(place(&texture.sampler), sampler);
    }
    msl::Options {
        lang_version: (2, 1),
        per_entry_point_map: [(interface.entry.to_string(), resources)].into(),
        fake_missing_bindings: false,
        bounds_check_policies: policies(),
        force_loop_bounding: false,
        ..msl::Options::default()
    }
}
