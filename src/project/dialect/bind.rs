//! Binds the uniforms, samplers and varyings of a complete shader to values.

use super::vertex::{VaryingValue, Vertex, vertex};
use super::vscode::numbers;
use super::with_usual;
use crate::{ControlKind, Input, InputKind, OutputId, SamplerSettings, SignalForm, UniformControl};
use serde::Serialize;
use shaderlint_host::{Feed, FeedRow, Preset, TextureFeed, TextureRow, is_named};
use shaderlint_semantic::tunable::{is_color, range_after};
use shaderlint_semantic::{
    Program, Sampler, Scalar, Stage, Storage, Value, Variable, VariableId, channel,
};

/// A uniform that the player sets.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct UniformData {
    /// The name in the shader.
    pub name: String,
    /// The GLSL type.
    #[serde(rename = "type")]
    pub ty: String,
    /// The value that the player sets.
    pub source: Feed,
    /// For [`Feed::TextureSize`]: the sampler of the texture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of: Option<String>,
}

/// The values of all uniforms, samplers and varyings of a complete shader.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Bindings {
    /// The uniforms, without samplers.
    pub uniforms: Vec<UniformData>,
    /// The samplers, as channels with names.
    pub inputs: Vec<Input>,
    /// The uniforms that the user sets.
    pub controls: Vec<UniformControl>,
    /// The source of the vertex shader.
    pub vertex: String,
    /// The values that it assigns to the varyings.
    pub varyings: Vec<VaryingValue>,
    /// Unknown uniforms that stay zero.
    pub zeros: Vec<String>,
    /// Unknown varyings, whose value is chosen by type.
    pub guessed: Vec<String>,
}

/// Number of textures that every WebGL2 implementation can bind at once.
pub const MAX_CHANNELS: u8 = 16;

/// Determines the values for a complete shader. `own` are the inputs and controls that the text
/// itself describes, `output` is the output of the pass, `partner` the other shader of the pair if
/// the file provides it.
pub fn bind(
    program: &Program,
    host: &Preset,
    own: (&[Input], &[UniformControl]),
    output: Option<&OutputId>,
    partner: Option<&str>,
) -> Bindings {
    let vertex = match program.stage {
        Stage::Fragment => vertex(program, host),
        Stage::Vertex => Vertex::default(),
    };
    let mut bound = Bindings {
        vertex: vertex.code,
        varyings: vertex.varyings,
        guessed: vertex.guessed,
        ..Bindings::default()
    };
    for (variable, id) in program.variables.iter().zip(0..) {
        let is_declared = variable.token.is_some() && variable.storage == Storage::Uniform;
        let is_user = program
            .declared_at(variable)
            .is_some_and(|s| program.is_user(s));
        // The other shader of the pair may read names that its host declares.
        let is_read = is_user
            || variable.read
            || partner.is_some_and(|text| reads(text, program.names.text(variable.name)));
        if !is_declared || !is_read {
            continue;
        }
        match variable.ty.element().as_sampler() {
            Some(sampler) => {
                let name = program.names.text(variable.name);
                let inputs = inputs_of(name, variable, sampler, host, output);
                for mut input in inputs {
                    let given = own.0.iter().find(|i| i.uniform == input.uniform);
                    if let Some(given) = given {
                        input = given.clone();
                    }
                    bound.add(input);
                }
            }
            None => bound.set(program, VariableId(id), variable, host, own.1),
        }
    }
    bound
}

/// Whether a text contains a word.
fn reads(text: &str, word: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    text.split(|c| !is_part(c)).any(|w| w == word)
}

impl Bindings {
    /// Adds a channel, with its own number if that is free.
    fn add(&mut self, input: Input) {
        let is_taken = |n: u8| self.inputs.iter().any(|i| i.channel == n);
        let requested = channel(input.uniform.as_deref().unwrap_or(""));
        let free = || (0..MAX_CHANNELS).find(|n| !is_taken(*n));
        let channel = requested.filter(|n| !is_taken(*n)).or_else(free);
        if let Some(channel) = channel {
            self.inputs.push(Input { channel, ..input });
        }
    }

    fn set(
        &mut self,
        program: &Program,
        id: VariableId,
        variable: &Variable,
        host: &Preset,
        own: &[UniformControl],
    ) {
        let name = program.names.text(variable.name).to_string();
        let ty = program.type_name(variable.ty);
        let is_it = |r: &&FeedRow| is_named(&r.name, &name) && r.types.contains(&ty);
        let mut rows = with_usual(host).flat_map(|h| &h.meanings.feeds);
        let of = sized_sampler(program, &name, &ty);
        let source = match rows.find(is_it) {
            _ if own.iter().any(|c| c.name == name) => Feed::Control,
            _ if of.is_some() => Feed::TextureSize,
            // The player sets these by name.
            Some(row) if matches!(row.feed, Feed::ChannelTime | Feed::ChannelResolution) => return,
            Some(row) => row.feed,
            None if variable.ty.is_matrix() && variable.ty.array == 0 => Feed::Identity,
            None => match variable.read {
                true => Feed::Control,
                false => return,
            },
        };
        if source == Feed::Control {
            let given = own.iter().find(|c| c.name == name).cloned();
            let colors = self.controls.iter();
            let colors = colors.filter(|c| c.kind == ControlKind::Color).count();
            match given.or_else(|| control(program, id, variable, colors)) {
                Some(control) => self.controls.push(control),
                None => return self.zeros.push(name),
            }
        }
        self.uniforms.push(UniformData {
            name,
            ty,
            source,
            of,
        });
    }
}

/// The sampler to whose texture size a uniform refers, by its name: `u_tex0Resolution`,
/// `photoSize`, `photo_size`.
fn sized_sampler(program: &Program, name: &str, ty: &str) -> Option<String> {
    const EXTENSIONS: [&str; 4] = ["Resolution", "_resolution", "Size", "_size"];
    if !matches!(ty, "vec2" | "vec3") {
        return None;
    }
    let is_sampler = |base: &&str| {
        let mut all = program.variables.iter();
        all.any(|v| {
            let is_it = program.names.text(v.name) == *base && v.storage == Storage::Uniform;
            is_it && v.ty.as_sampler().is_some()
        })
    };
    let mut bases = EXTENSIONS.iter().filter_map(|end| name.strip_suffix(end));
    bases.find(is_sampler).map(str::to_string)
}

/// The channels of a sampler, one for each element of an array.
fn inputs_of(
    name: &str,
    variable: &Variable,
    sampler: Sampler,
    host: &Preset,
    output: Option<&OutputId>,
) -> Vec<Input> {
    let is_it = |r: &&TextureRow| is_named(&r.name, name) && r.texture != TextureFeed::Channel;
    let mut rows = with_usual(host).flat_map(|h| &h.meanings.textures);
    let row = rows.find(|r| sampler == Sampler::Sampler2D && is_it(r));
    let kind = match sampler {
        Sampler::SamplerCube | Sampler::IsamplerCube | Sampler::UsamplerCube => InputKind::Cubemap,
        Sampler::Sampler3D | Sampler::Isampler3D | Sampler::Usampler3D => InputKind::Volume,
        _ => InputKind::Texture,
    };
    let mut input = Input::empty(0, kind);
    input.sampler_type = sampler;
    if let Some(row) = row {
        input = read_by(row, name, output);
    }
    let named = |uniform: String| Input {
        uniform: Some(uniform),
        ..input.clone()
    };
    match variable.ty.array {
        0 => vec![named(name.to_string())],
        size => (0..size.min(u32::from(MAX_CHANNELS)))
            .map(|i| named(format!("{name}[{i}]")))
            .collect(),
    }
}

/// The input of a sampler, as a row of the host defines it.
fn read_by(row: &TextureRow, name: &str, output: Option<&OutputId>) -> Input {
    let (kind, id) = match row.texture {
        TextureFeed::File | TextureFeed::Channel => (InputKind::Texture, String::new()),
        TextureFeed::Screen => (InputKind::Texture, OutputId::SCREEN.to_string()),
        TextureFeed::Music | TextureFeed::MusicSum => (InputKind::Music, String::new()),
        TextureFeed::LastFrame => (
            InputKind::Buffer,
            output.map_or(String::new(), |o| o.0.clone()),
        ),
        TextureFeed::Buffer => (InputKind::Buffer, OutputId::of_dialect(name).0),
    };
    let mut input = Input::empty(0, kind);
    input.id = id;
    input.is_given = row.texture != TextureFeed::File;
    if row.texture == TextureFeed::MusicSum {
        input.signal = SignalForm::Sum;
    }
    input.sampler = SamplerSettings {
        filter: row.filter.to_string(),
        wrap: row.wrap.to_string(),
        vflip: !row.top_first,
    };
    input
}

/// The control for an unknown uniform, based on its declaration; `None` for arrays and structs.
fn control(
    program: &Program,
    id: VariableId,
    variable: &Variable,
    colors: usize,
) -> Option<UniformControl> {
    let name = program.names.text(variable.name);
    let (scalar, columns, lanes) = variable.ty.numeric()?;
    if variable.ty.array > 0 || columns > 1 {
        return None;
    }
    let lanes = usize::from(lanes);
    let kind = match (scalar, lanes) {
        (Scalar::Bool, _) => ControlKind::Bool,
        (Scalar::Float, 1) => ControlKind::Float,
        (Scalar::Int | Scalar::Uint, 1) => ControlKind::Int,
        (Scalar::Float, 3 | 4) if is_color(name) => ControlKind::Color,
        _ => ControlKind::Vector,
    };
    let mut control = match kind {
        ControlKind::Color => UniformControl::color(name, lanes, colors),
        ControlKind::Bool => UniformControl::even(name, kind, lanes, (0.0, 0.0, 1.0)),
        ControlKind::Int => UniformControl::even(name, kind, lanes, (0.0, 1.0, 10.0)),
        ControlKind::Float => UniformControl::even(name, kind, lanes, (0.0, 1.0, 2.0)),
        _ => UniformControl::even(name, kind, lanes, (-1.0, 0.5, 1.0)),
    };
    let declared = program.declared_at(variable)?;
    if let Some((range, _)) = line_end(program, declared).and_then(|s| range_after(program, s)) {
        control.min = vec![range.min; lanes];
        control.max = vec![range.max; lanes];
        control.value = vec![(range.min + range.max) / 2.0; lanes];
    }
    let init = program.declarator_of(id).and_then(|d| d.init);
    let first: Vec<f64> = match init {
        Some(init) => program.values(init).iter().map(number).collect(),
        None => noted(program, declared, lanes),
    };
    if first.len() == lanes {
        widen(&mut control, &first);
        control.value = first;
    }
    Some(control)
}

/// Extends the range of a control so that it contains a value.
fn widen(control: &mut UniformControl, value: &[f64]) {
    for ((min, max), value) in control.min.iter_mut().zip(&mut control.max).zip(value) {
        if *value > *max {
            *max = 2.0 * value;
        }
        if *value < *min {
            *min = 2.0 * value;
        }
    }
}

/// The default value in the comment after a declaration, as GL Transitions writes it: `// = 0.1`.
fn noted(program: &Program, name: shaderlint_text::Span, lanes: usize) -> Vec<f64> {
    let file = program.sources.file_at(name.start);
    let rest = file.and_then(|f| f.text.get((name.end - f.base) as usize..));
    let line = rest.and_then(|rest| rest.lines().next()).unwrap_or("");
    let comment = line.split_once("//").or_else(|| line.split_once("/*"));
    let value = comment.and_then(|(_, text)| text.trim_start().strip_prefix('='));
    let value = value.unwrap_or("").trim_start();
    let is_constructed = value.starts_with(|c: char| c.is_alphabetic());
    let end = value.find(|c: char| match is_constructed {
        true => c == ')',
        false => c.is_whitespace() || c == ',' || c == ';',
    });
    let found = numbers(value.get(..end.unwrap_or(value.len())).unwrap_or(""));
    match found[..] {
        [one] => vec![one; lanes],
        _ => found,
    }
}

/// The text from a name to the next semicolon.
fn line_end(program: &Program, name: shaderlint_text::Span) -> Option<shaderlint_text::Span> {
    let file = program.sources.file_at(name.start)?;
    let rest = file.text.get((name.end - file.base) as usize..)?;
    let end = rest.find(';')? as u32 + 1;
    Some(shaderlint_text::Span::new(name.start, name.end + end))
}

fn number(value: &Value) -> f64 {
    match *value {
        Value::Bool(b) => f64::from(u8::from(b)),
        Value::Int(n) => f64::from(n),
        Value::Uint(n) => f64::from(n),
        Value::Float(n) => f64::from(n),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Project;

    const CODE: &str = "#version 300 es\nprecision highp float;\nuniform vec2 u_resolution;\n\
        uniform float gain; // how strong (0.5~4.5)\nuniform vec3 baseColor;\nuniform mat4 turn;\n\
        uniform float unused;\nuniform float weights[3];\nuniform sampler2D maps[2];\n\
        uniform samplerCube iChannel1;\nin vec2 vUv;\nout vec4 c;\nvoid main() {\n\
        c = turn * vec4(baseColor * gain * weights[1], 1.0) + texture(maps[0], vUv / u_resolution)\n\
        + texture(iChannel1, vec3(1.0));\n}\n";

    #[test]
    fn every_input_of_a_shader_is_bound() {
        let project = Project::from_shader("", CODE).unwrap();
        let bound = &project.passes[0].bound;
        let uniforms = bound.uniforms.iter();
        let sources = uniforms.map(|u| format!("{} {:?}", u.name, u.source));
        let sources = sources.collect::<Vec<_>>().join(", ");
        let expected = "u_resolution Resolution, gain Control, baseColor Control, turn Identity";
        assert_eq!(sources, expected);
        let gain = &project.controls[0];
        assert_eq!((&gain.min[..], &gain.max[..]), (&[0.5][..], &[4.5][..]));
        assert_eq!(project.controls[1].kind, ControlKind::Color);
        assert_eq!(bound.zeros, ["weights"]);
        let inputs = bound.inputs.iter();
        let inputs = inputs.map(|i| (i.channel, i.uniform.as_deref().unwrap()));
        let named = [(0, "maps[0]"), (1, "maps[1]"), (2, "iChannel1")];
        assert_eq!(inputs.collect::<Vec<_>>(), named);
    }

    #[test]
    fn texture_sizes_are_bound_to_samplers_by_name() {
        let code = "precision highp float;\nuniform sampler2D u_tex0, photo;\nuniform vec2 u_tex0Resolution;\n\
            uniform vec2 photo_size, otherSize;\nvoid main() { gl_FragColor = texture2D(u_tex0, u_tex0Resolution) \
            + texture2D(photo, photo_size * otherSize); }\n";
        let project = Project::from_shader("", code).unwrap();
        let uniforms = project.passes[0].bound.uniforms.iter();
        let found: Vec<_> = uniforms.map(|u| (u.source, u.of.as_deref())).collect();
        let requested = [
            (Feed::TextureSize, Some("u_tex0")),
            (Feed::TextureSize, Some("photo")),
            (Feed::Control, None),
        ];
        assert_eq!(found, requested);
    }

    #[test]
    fn controls_start_at_the_initial_value() {
        let code = "#version 330\nuniform float a = 3.5;\nuniform bool b = true;\nout vec4 c;\n\
            void main() { c = vec4(b ? a : 0.0); }\n";
        let project = Project::from_shader("", code).unwrap();
        let values: Vec<&[f64]> = project.controls.iter().map(|c| &c.value[..]).collect();
        assert_eq!(values, [&[3.5][..], &[1.0][..]]);
    }
}
