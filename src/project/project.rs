//! ShaderToy projects: passes and the inputs of their channels.

use super::{Bindings, Completion, PassDraw, PassRole, Recognised, StandIn, UniformControl};
use shaderlint_host::Preset;
use shaderlint_semantic::{Channels, Pass, Sampler, Stage};
use shaderlint_text::TextPiece;
use std::sync::Arc;

/// A ShaderToy project, or a complete shader of another host.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Project {
    /// Title, author and similar data.
    pub info: Info,
    /// The passes, in the order of the export.
    pub passes: Vec<ProjectPass>,
    /// Whether it comes from an export, so that ShaderToy's licence terms apply and passes have
    /// names.
    pub is_export: bool,
    /// The detected host and the evidence for it; `None` for passes of ShaderToy's player, or if the
    /// user names the host.
    pub recognised: Option<Recognised>,
    /// The host of its complete shaders.
    pub host: Option<&'static Preset>,
    /// The number of controls that the text itself describes; they come first.
    pub described: usize,
    /// The uniforms that the user sets.
    pub controls: Vec<UniformControl>,
    /// The pass whose file was opened, if others were found beside it.
    pub opened: Option<PassRole>,
    /// Whether a file beside it says what its channels read, so that nothing is guessed.
    pub is_connected: bool,
    /// Notes about how the input was interpreted.
    pub notes: Vec<String>,
    /// Companion files that have not been read yet, by their paths relative to the project's
    /// folder.
    pub requested: Vec<String>,
}

/// Descriptive data of a project. All of it is untrusted.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Info {
    /// The id in the URL of its page.
    pub id: String,
    /// The title.
    pub name: String,
    /// The user name of the author.
    pub author: String,
    /// The author's description.
    pub description: String,
    /// The tags.
    pub tags: Vec<String>,
}

/// A pass of a project.
#[derive(Clone, PartialEq, Debug)]
pub struct ProjectPass {
    /// The kind of pass.
    pub kind: Pass,
    /// The name in the export, which has no fixed meaning.
    pub name: String,
    /// The code of the user.
    pub code: Arc<str>,
    /// The inputs of its channels.
    pub inputs: Vec<Input>,
    /// The id of its output.
    pub output: Option<OutputId>,
    /// Who declares its uniforms and `main`.
    pub wrapper: Wrapper,
    /// Text before the code of a complete shader.
    pub before: Arc<str>,
    /// Text after it.
    pub after: Arc<str>,
    /// The values of the uniforms and varyings of a complete shader.
    pub bound: Bindings,
    /// The shader stage of the code.
    pub stage: Stage,
    /// How a complete shader is drawn.
    pub draw: PassDraw,
    /// Path of its file; `None` in an export.
    pub file: Option<String>,
    /// The files that its code was put together from, in order; empty if it is one file.
    pub pieces: Vec<TextPiece>,
}

/// Who declares the uniforms, the output and `main` of a pass.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrapper {
    /// ShaderToy's player.
    Player,
    /// The code itself, a complete WebGL2 shader.
    Own,
}

/// The id of a pass's output in exports. Inputs refer to it.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct OutputId(pub String);

/// The ids of the buffers A to D.
const BUFFERS: [&str; 4] = ["4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"];
/// The ids of the buffers A to D in the REST API.
const BUFFER_NUMBERS: [&str; 4] = ["257", "258", "259", "260"];

impl OutputId {
    /// The output of the Image pass.
    pub const IMAGE: &'static str = "4dfGRr";
    /// The output of the cube map pass.
    pub const CUBE: &'static str = "4dX3Rr";
    /// What a host shows on its screen, which no pass draws.
    pub const SCREEN: &'static str = "port-screen";
    /// The output of the sound pass.
    pub const SOUND: &'static str = "XsfGRr";

    /// Normalises an id of an export or of the REST API.
    pub fn new(id: &str) -> OutputId {
        let number = BUFFER_NUMBERS.iter().position(|n| *n == id);
        let id = number.and_then(|i| BUFFERS.get(i)).map_or(id, |b| b);
        OutputId(id.to_string())
    }

    /// The id of a buffer, by number from 0 to 3.
    pub fn buffer(number: usize) -> Option<OutputId> {
        BUFFERS.get(number).map(|id| OutputId(id.to_string()))
    }

    /// The id of a buffer with a name, in a complete shader.
    pub fn of_dialect(name: &str) -> OutputId {
        OutputId(format!("own:{name}"))
    }

    /// The number of the buffer, from 0 to 3.
    pub fn number(&self) -> Option<usize> {
        BUFFERS.iter().position(|id| *id == self.0)
    }
}

/// The input of a channel.
#[derive(Clone, PartialEq, Debug)]
pub struct Input {
    /// The channel number; 0 to 3 in ShaderToy.
    pub channel: u8,
    /// The sampler of a complete shader that reads it; `None` for ShaderToy's `iChannel`s.
    pub uniform: Option<String>,
    /// The type of that sampler.
    pub sampler_type: Sampler,
    /// The kind of input.
    pub kind: InputKind,
    /// The id in the export; for a buffer the [`OutputId`] of the pass.
    pub id: String,
    /// The path on ShaderToy.
    pub src: String,
    /// The sampler settings.
    pub sampler: SamplerSettings,
    /// The layout of sound in its texture.
    pub signal: SignalForm,
    /// Name of the file that the user provided.
    pub name: String,
    /// That file as `data:` URLs, six for a cube map; empty if there is no file.
    pub urls: Vec<String>,
    /// The stand-in for a missing file.
    pub stand_in: Option<StandIn>,
    /// Whether the user said what the channel reads.
    pub is_given: bool,
}

/// The layout of sound in a texture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SignalForm {
    /// The spectrum, and above it the waveform, in the red component.
    Both,
    /// The spectrum only, in gray.
    Spectrum,
    /// The waveform only, in gray.
    Wave,
    /// The spectrum at the bottom and above it those of previous frames, in all components.
    History,
    /// The sum of the spectra since the start, in gray: increases by one per second at full level.
    Sum,
}

impl SignalForm {
    /// The name in the player.
    pub const fn word(self) -> &'static str {
        match self {
            SignalForm::Both => "",
            SignalForm::Spectrum => "spectrum",
            SignalForm::Wave => "wave",
            SignalForm::History => "history",
            SignalForm::Sum => "sum",
        }
    }
}

#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum InputKind {
    Texture, Buffer, Cubemap, Volume, Keyboard, Video, Webcam, Music, MusicStream, Microphone,
}

impl InputKind {
    /// The kind for the name in an export.
    pub fn of(word: &str) -> Option<InputKind> {
        Some(match word {
            "texture" => InputKind::Texture,
            "buffer" => InputKind::Buffer,
            "cubemap" => InputKind::Cubemap,
            "volume" => InputKind::Volume,
            "keyboard" => InputKind::Keyboard,
            "video" => InputKind::Video,
            "webcam" => InputKind::Webcam,
            "music" => InputKind::Music,
            "musicstream" => InputKind::MusicStream,
            "mic" => InputKind::Microphone,
            _ => return None,
        })
    }

    /// The name in an export.
    pub const fn word(self) -> &'static str {
        match self {
            InputKind::Texture => "texture",
            InputKind::Buffer => "buffer",
            InputKind::Cubemap => "cubemap",
            InputKind::Volume => "volume",
            InputKind::Keyboard => "keyboard",
            InputKind::Video => "video",
            InputKind::Webcam => "webcam",
            InputKind::Music => "music",
            InputKind::MusicStream => "musicstream",
            InputKind::Microphone => "mic",
        }
    }

    /// The sampler type of a channel with this input.
    pub const fn sampler(self) -> Sampler {
        match self {
            InputKind::Cubemap => Sampler::SamplerCube,
            InputKind::Volume => Sampler::Sampler3D,
            _ => Sampler::Sampler2D,
        }
    }
}

/// Sampler settings, with the words of the export. Unknown words have the meaning of the last
/// listed one.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct SamplerSettings {
    /// `linear`, `mipmap`, or anything else for nearest.
    pub filter: String,
    /// `clamp`, or anything else for repeat.
    pub wrap: String,
    /// Whether images are flipped vertically.
    pub vflip: bool,
}

impl SamplerSettings {
    /// Whether it uses mipmaps.
    pub fn has_mipmaps(&self) -> bool {
        self.filter == "mipmap"
    }

    /// The settings that most inputs of a kind have on ShaderToy.
    pub fn usual(kind: InputKind) -> SamplerSettings {
        let (filter, wrap, vflip) = match kind {
            InputKind::Texture => ("mipmap", "repeat", true),
            InputKind::Volume => ("mipmap", "repeat", false),
            InputKind::Cubemap => ("mipmap", "clamp", false),
            InputKind::Keyboard => ("nearest", "clamp", true),
            _ => ("linear", "clamp", true),
        };
        SamplerSettings {
            filter: filter.to_string(),
            wrap: wrap.to_string(),
            vflip,
        }
    }
}

impl Input {
    /// An input without content, with the default sampler settings of its kind.
    pub fn empty(channel: u8, kind: InputKind) -> Input {
        Input {
            channel,
            uniform: None,
            sampler_type: kind.sampler(),
            kind,
            id: String::new(),
            src: String::new(),
            sampler: SamplerSettings::usual(kind),
            signal: SignalForm::Both,
            name: String::new(),
            urls: Vec::new(),
            stand_in: None,
            is_given: false,
        }
    }
}

impl Project {
    /// Whether it has a pass that is shown or heard.
    pub fn is_shown(&self) -> bool {
        let is_it = |p: &ProjectPass| matches!(p.kind, Pass::Image | Pass::Cubemap | Pass::Sound);
        self.passes.iter().any(is_it)
    }

    /// Whether a pass of a kind has this output id.
    pub fn draws(&self, kind: Pass, id: &str) -> bool {
        let mut all = self.passes.iter().filter(|p| p.kind == kind);
        all.any(|p| p.output.as_ref().is_some_and(|o| o.0 == id))
    }

    /// Removes music with a missing file from its channels, as ShaderToy's player does. The player
    /// synthesises a spectrum and waveform only for music that is loaded and muted. Returns the
    /// channels, such as `image.0`.
    pub fn unload_music(&mut self) -> Vec<String> {
        let is_lost = |i: &Input| {
            matches!(i.kind, InputKind::Music | InputKind::MusicStream) && i.urls.is_empty()
        };
        let mut channels = Vec::new();
        for pass in &mut self.passes {
            let slug = pass.slug();
            let lost = pass.inputs.iter().filter(|i| is_lost(i));
            channels.extend(lost.map(|i| format!("{slug}.{}", i.channel)));
            pass.inputs.retain(|i| !is_lost(i));
        }
        channels
    }

    /// Shares sampler settings between channels that read the same buffer, as ShaderToy's player
    /// does: the last loaded wrap mode applies to all, and in each pass the filter of the last
    /// channel.
    pub fn share_samplers(&mut self) {
        let is_shared = |i: &Input| {
            i.kind == InputKind::Buffer || (i.kind == InputKind::Cubemap && i.id == OutputId::CUBE)
        };
        let mut wraps: Vec<(String, String)> = Vec::new();
        for input in self
            .passes
            .iter()
            .flat_map(|p| &p.inputs)
            .filter(|i| is_shared(i))
        {
            wraps.retain(|(id, _)| *id != input.id);
            wraps.push((input.id.clone(), input.sampler.wrap.clone()));
        }
        for pass in &mut self.passes {
            let mut order: Vec<(u8, String, String)> = pass
                .inputs
                .iter()
                .filter(|i| is_shared(i))
                .map(|i| (i.channel, i.id.clone(), i.sampler.filter.clone()))
                .collect();
            order.sort_by_key(|(channel, ..)| *channel);
            for input in pass.inputs.iter_mut().filter(|i| is_shared(i)) {
                if let Some((_, wrap)) = wraps.iter().find(|(id, _)| *id == input.id) {
                    input.sampler.wrap.clone_from(wrap);
                }
                if let Some((.., filter)) = order.iter().rev().find(|(_, id, _)| *id == input.id) {
                    input.sampler.filter.clone_from(filter);
                }
            }
        }
    }
}

impl ProjectPass {
    /// A pass that has only code.
    pub fn new(kind: Pass, code: impl Into<Arc<str>>) -> ProjectPass {
        ProjectPass {
            kind,
            name: String::new(),
            code: code.into(),
            inputs: Vec::new(),
            output: None,
            wrapper: Wrapper::Player,
            before: Arc::from(""),
            after: Arc::from(""),
            bound: Bindings::default(),
            stage: Stage::Fragment,
            draw: PassDraw::default(),
            file: None,
            pieces: Vec::new(),
        }
    }

    /// A pass that a host completes.
    pub fn completed(kind: Pass, completion: Completion) -> ProjectPass {
        ProjectPass {
            wrapper: Wrapper::Own,
            before: completion.before,
            after: completion.after,
            stage: completion.stage,
            draw: PassDraw {
                is_float: kind == Pass::Buffer,
                ..PassDraw::default()
            },
            ..ProjectPass::new(kind, completion.code)
        }
    }

    /// The name in file names and options: `image`, `buffer_a`, `common`.
    pub fn slug(&self) -> &'static str {
        match self.kind {
            Pass::Image => "image",
            Pass::Common => "common",
            Pass::Cubemap => "cubemap",
            Pass::Sound => "sound",
            Pass::Buffer => match self.output.as_ref().and_then(OutputId::number) {
                Some(0) => "buffer_a",
                Some(1) => "buffer_b",
                Some(2) => "buffer_c",
                Some(3) => "buffer_d",
                _ => "buffer",
            },
        }
    }

    /// The name shown to the user; for a pass without a name, its kind or index.
    pub fn title(&self, index: usize) -> String {
        if !self.name.is_empty() {
            return self.name.clone();
        }
        match self.kind {
            Pass::Image => "Image".to_string(),
            Pass::Common => "Common".to_string(),
            _ => format!("pass {index}"),
        }
    }

    /// By channel: whether its texture has mipmaps; `None` for a channel without input.
    pub fn mipmapped(&self) -> [Option<bool>; 4] {
        let mut mipmapped = [None; 4];
        for input in &self.inputs {
            if let Some(slot) = mipmapped.get_mut(input.channel as usize) {
                *slot = Some(input.sampler.filter == "mipmap");
            }
        }
        mipmapped
    }

    /// The sampler type of each channel; `sampler2D` for a channel without input.
    pub fn channels(&self) -> Channels {
        let mut channels = [Some(Sampler::Sampler2D); 4];
        for input in &self.inputs {
            if let Some(channel) = channels.get_mut(input.channel as usize) {
                *channel = Some(input.kind.sampler());
            }
        }
        channels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unavailable_music_is_not_loaded() {
        let mut pass = ProjectPass::new(Pass::Image, "");
        pass.inputs = vec![
            Input::empty(0, InputKind::Music),
            Input {
                urls: vec!["data:,".to_string()],
                ..Input::empty(1, InputKind::Music)
            },
            Input::empty(2, InputKind::Microphone),
        ];
        let mut project = Project {
            info: Info::default(),
            passes: vec![pass],
            is_export: true,
            ..Project::default()
        };
        assert_eq!(project.unload_music(), ["image.0"]);
        assert_eq!(project.passes[0].inputs.len(), 2);
    }

    #[test]
    fn samplers_with_equal_settings_are_shared() {
        let reader = |channel, filter: &str, wrap: &str| Input {
            id: "4dXGR8".to_string(),
            sampler: SamplerSettings {
                filter: filter.to_string(),
                wrap: wrap.to_string(),
                vflip: false,
            },
            ..Input::empty(channel, InputKind::Buffer)
        };
        let mut first = ProjectPass::new(Pass::Image, "");
        first.inputs = vec![reader(1, "linear", "clamp"), reader(0, "mipmap", "clamp")];
        let mut second = ProjectPass::new(Pass::Buffer, "");
        second.inputs = vec![reader(0, "nearest", "repeat")];
        let mut project = Project {
            info: Info::default(),
            passes: vec![first, second],
            is_export: true,
            ..Project::default()
        };
        project.share_samplers();
        let all: Vec<_> = project.passes.iter().flat_map(|p| &p.inputs).collect();
        assert!(all.iter().all(|i| i.sampler.wrap == "repeat"));
        let filters: Vec<_> = all.iter().map(|i| i.sampler.filter.as_str()).collect();
        assert_eq!(filters, ["linear", "linear", "nearest"]);
    }
}
