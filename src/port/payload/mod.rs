//! What the player gets: the project as JSON, with the values that have sliders, the keys that it
//! reads and the findings in its code; and the files of the player that it needs.

mod findings;
mod keys;
pub(super) mod pieces;
pub(super) mod tuned;

use super::{
    Composed, Generator, Input, InputKind, OutputId, Project, ProjectPass, SizeTerm,
    UniformControl, UniformData, VERTEX, Wrapper, credits,
};
use findings::{FindingData, findings};
use keys::key_names;
use serde::Serialize;
use shaderlint_project::Slider;
use shaderlint_project::is_gray;
use shaderlint_semantic::{Pass, Sampler, Stage};
use shaderlint_text::{FileId, Role, SetAt, SourceFile};
use tuned::sliders;

#[derive(Serialize)]
struct Payload<'a> {
    title: &'a str,
    author: &'a str,
    link: String,
    license: String,
    description: &'a str,
    vertex: &'static str,
    files: Vec<PayloadText<'a>>,
    passes: Vec<PassData<'a>>,
    tunables: Vec<Slider>,
    controls: &'a [UniformControl],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    media: Vec<MediaData>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    findings: Vec<FindingData>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    keys: Vec<String>,
}

/// A generator of stand-ins.
#[derive(Serialize)]
struct MediaData {
    name: &'static str,
    text: String,
}

#[derive(Serialize)]
struct PayloadText<'a> {
    name: String,
    text: &'a str,
    hidden: bool,
}

#[derive(Serialize)]
pub(super) struct PassData<'a> {
    pub(super) kind: &'static str,
    pub(super) name: String,
    files: Vec<u32>,
    pub(super) inputs: Vec<Option<InputData<'a>>>,
    #[serde(flatten)]
    pub(super) own: Option<OwnData<'a>>,
}

/// The additional data of a shader that declares its own uniforms.
#[derive(Serialize)]
pub(super) struct OwnData<'a> {
    vertex: &'a str,
    pub(super) uniforms: &'a [UniformData],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) size: Option<&'a [SizeTerm; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) into: Option<&'a str>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) float: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    quad: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    fragment: Option<&'a str>,
}

#[derive(Serialize)]
pub(super) struct InputData<'a> {
    pub(super) kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) uniform: Option<&'a str>,
    #[serde(skip_serializing_if = "str::is_empty")]
    sampler: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) buffer: Option<usize>,
    pub(super) filter: &'a str,
    pub(super) wrap: &'a str,
    vflip: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    gray: bool,
    #[serde(skip_serializing_if = "str::is_empty")]
    form: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    name: &'a str,
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    urls: &'a [String],
    #[serde(flatten)]
    stand_in: Option<StandInData>,
}

/// The stand-in for a missing file.
#[derive(Serialize)]
struct StandInData {
    #[serde(rename = "standIn")]
    generator: &'static str,
    title: &'static str,
    size: [u32; 3],
}

/// The project in the form that the player reads.
pub(super) fn payload(project: &Project, composed: &Composed) -> String {
    let sources = &composed.sources;
    let payload = Payload {
        title: &project.info.name,
        author: &project.info.author,
        link: credits::link(&project.info),
        license: credits::license(project),
        description: &project.info.description,
        vertex: VERTEX,
        files: (0..)
            .zip(sources.files())
            .map(|(i, f)| text(project, composed.owner(FileId(i)), f))
            .collect(),
        passes: passes(project, composed),
        tunables: named_sliders(project, composed),
        controls: &project.controls,
        media: media(project),
        findings: findings(composed),
        keys: key_names(project, composed),
    };
    // Serialisation fails only for maps with keys that are not strings, and for failing writers.
    serde_json::to_string(&payload).unwrap_or_default()
}

fn text<'a>(project: &Project, owner: Option<usize>, file: &'a SourceFile) -> PayloadText<'a> {
    let pass = owner.and_then(|i| Some((i, project.passes.get(i)?)));
    PayloadText {
        name: pass.map_or(String::new(), |(i, pass)| pass.title(i)),
        text: &file.text,
        hidden: file.role == Role::Prelude,
    }
}

/// The passes that run, in project order.
pub(super) fn passes<'a>(project: &'a Project, composed: &Composed) -> Vec<PassData<'a>> {
    let running: Vec<_> = composed
        .units
        .iter()
        .filter(|u| u.kind != Pass::Common)
        .filter_map(|u| Some((u, project.passes.get(u.pass)?)))
        .collect();
    let drawn_by = |id: &str| {
        let writes = |o: &OutputId| !id.is_empty() && o.0 == id;
        let mut all = running.iter();
        all.position(|(_, p)| {
            matches!(p.kind, Pass::Buffer | Pass::Image) && p.output.as_ref().is_some_and(writes)
        })
    };
    let draws_cube = running.iter().any(|(_, p)| p.kind == Pass::Cubemap);
    let data = running.iter().map(|(unit, pass)| {
        let last = pass.inputs.iter().map(|i| usize::from(i.channel) + 1).max();
        let mut inputs: Vec<_> = (0..last.unwrap_or(0).max(4)).map(|_| None).collect();
        for input in &pass.inputs {
            inputs.set_at(
                input.channel as usize,
                Some(input_data(input, drawn_by(&input.id), draws_cube)),
            );
        }
        PassData {
            kind: kind_word(pass.kind),
            name: pass.title(unit.pass),
            files: unit.files.iter().map(|f| f.0).collect(),
            inputs,
            own: own(pass),
        }
    });
    data.collect()
}

fn own(pass: &ProjectPass) -> Option<OwnData<'_>> {
    let partner = pass.draw.partner.as_deref();
    let (vertex, fragment) = match pass.stage {
        Stage::Fragment => (partner.unwrap_or(&pass.bound.vertex), None),
        Stage::Vertex => ("", partner),
    };
    (pass.wrapper == Wrapper::Own).then_some(OwnData {
        vertex,
        uniforms: &pass.bound.uniforms,
        size: pass.draw.size.as_ref(),
        into: match pass.kind {
            Pass::Buffer => pass.output.as_ref().map(|o| o.0.as_str()),
            _ => None,
        },
        float: pass.draw.is_float,
        quad: pass.stage == Stage::Fragment && partner.is_some(),
        fragment,
    })
}

fn kind_word(kind: Pass) -> &'static str {
    match kind {
        Pass::Image | Pass::Common => "image",
        Pass::Buffer => "buffer",
        Pass::Cubemap => "cubemap",
        Pass::Sound => "sound",
    }
}

/// The generators that channels need, without duplicates.
fn media(project: &Project) -> Vec<MediaData> {
    let inputs = project.passes.iter().flat_map(|p| &p.inputs);
    let mut used: Vec<Generator> = Vec::new();
    for generator in inputs.filter_map(|i| i.stand_in).map(|s| s.generator) {
        if !used.contains(&generator) {
            used.push(generator);
        }
    }
    let data = used.iter().map(|generator| MediaData {
        name: generator.name,
        text: generator.fragment(),
    });
    data.collect()
}

fn input_data<'a>(input: &'a Input, buffer: Option<usize>, draws_cube: bool) -> InputData<'a> {
    let reads_pass = input.kind == InputKind::Cubemap && draws_cube && input.id == OutputId::CUBE;
    let is_buffer = input.kind == InputKind::Buffer;
    let kind = match input.kind {
        InputKind::Texture => "texture",
        InputKind::Buffer => "buffer",
        InputKind::Cubemap if reads_pass => "cubebuffer",
        InputKind::Cubemap => "cubemap",
        InputKind::Volume => "volume",
        InputKind::Keyboard => "keyboard",
        InputKind::Video => "video",
        InputKind::Webcam => "webcam",
        InputKind::Music | InputKind::MusicStream => "music",
        InputKind::Microphone => "mic",
    };
    InputData {
        kind,
        uniform: input.uniform.as_deref(),
        sampler: match input.sampler_type {
            Sampler::Sampler2D | Sampler::SamplerCube | Sampler::Sampler3D => "",
            other => other.name(),
        },
        buffer: if is_buffer { buffer } else { None },
        filter: match input.sampler.filter.as_str() {
            word @ ("linear" | "mipmap") => word,
            _ => "nearest",
        },
        wrap: if input.sampler.wrap == "clamp" {
            "clamp"
        } else {
            "repeat"
        },
        vflip: input.sampler.vflip,
        gray: is_gray(input),
        form: input.signal.word(),
        name: &input.name,
        urls: &input.urls,
        stand_in: input.stand_in.map(|stand_in| StandInData {
            generator: stand_in.generator.name,
            title: stand_in.title,
            size: stand_in.size,
        }),
    }
}

/// The sliders. A name with different values in several passes gets a slider for each, with the
/// name of the pass.
fn named_sliders(project: &Project, composed: &Composed) -> Vec<Slider> {
    let mut named: Vec<Slider> = Vec::new();
    for slider in &sliders(composed).list {
        let is_other = |other: &Slider| {
            let (a, b) = (other, slider);
            a.name == b.name
                && (a.kind, &a.value, &a.min, &a.max) != (b.kind, &b.value, &b.min, &b.max)
        };
        let mut slider = slider.clone();
        if named.iter().any(is_other) {
            let owner = composed.owner(slider.file);
            let pass = owner.and_then(|i| Some(project.passes.get(i)?.title(i)));
            slider.name = format!("{} ({})", slider.name, pass.unwrap_or_default());
        }
        named.push(slider);
    }
    named
}
