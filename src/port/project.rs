//! ShaderToy projects: passes, and what their channels read.

use super::{Bindings, PassDraw, StandIn, UniformControl};
use shaderlint_host::Preset;
use shaderlint_semantic::{Channels, Pass, Sampler, Stage};
use std::sync::Arc;

/// A ShaderToy project.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Project {
    /// Who made it, and what it is called.
    pub info: Info,
    /// Its passes, in the order of the export.
    pub passes: Vec<ProjectPass>,
    /// Whether it comes from an export, so that ShaderToy's terms hold and passes have names.
    pub is_export: bool,
    /// What its whole shaders are written in.
    pub host: Option<&'static Preset>,
    /// How many of the controls the text itself describes: the first ones.
    pub described: usize,
    /// The uniforms that the user sets.
    pub controls: Vec<UniformControl>,
    /// What is to be told of how it was read.
    pub notes: Vec<String>,
    /// The texts that it asks for beside its own, by their paths from its folder.
    pub wanted: Vec<String>,
}

/// Who made a project, and what it is called; all of it is text from outside.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Info {
    /// The id in the address of its page.
    pub id: String,
    /// Its title.
    pub name: String,
    /// Its author.
    pub author: String,
    /// What the author wrote about it.
    pub description: String,
    /// Its tags.
    pub tags: Vec<String>,
}

/// A pass.
#[derive(Clone, PartialEq, Debug)]
pub struct ProjectPass {
    /// What it draws.
    pub kind: Pass,
    /// Its name, which tells nothing certain.
    pub name: String,
    /// Its code.
    pub code: Arc<str>,
    /// What its channels read.
    pub inputs: Vec<Input>,
    /// What it writes to.
    pub output: Option<OutputId>,
    /// Who declares its uniforms and `main`.
    pub wrapper: Wrapper,
    /// What goes before the code of a whole shader.
    pub before: Arc<str>,
    /// What goes behind it.
    pub behind: Arc<str>,
    /// What a whole shader is given.
    pub bound: Bindings,
    /// The stage that the code is for.
    pub stage: Stage,
    /// How a whole shader is drawn.
    pub draw: PassDraw,
    /// Path of its own file, where it has one.
    pub file: Option<String>,
}

/// Who declares what stands around the code of a pass: its uniforms, its output and `main`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrapper {
    /// ShaderToy's player.
    Player,
    /// The code itself, a whole WebGL2 shader.
    Own,
}

/// What a pass writes to, as inputs name it: the id that exports use.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct OutputId(pub String);

/// The ids of the buffers A to D.
const BUFFERS: [&str; 4] = ["4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"];
/// The numbers that the REST API has for them.
const BUFFER_NUMBERS: [&str; 4] = ["257", "258", "259", "260"];

impl OutputId {
    /// What the picture is written to.
    pub const IMAGE: &'static str = "4dfGRr";
    /// What the cube map is written to.
    pub const CUBE: &'static str = "4dX3Rr";
    /// What the sound is written to.
    pub const SOUND: &'static str = "XsfGRr";

    /// The id as exports write it, for that of an export or of the REST API.
    pub fn new(id: &str) -> OutputId {
        let number = BUFFER_NUMBERS.iter().position(|n| *n == id);
        let id = number.and_then(|i| BUFFERS.get(i)).map_or(id, |b| b);
        OutputId(id.to_string())
    }

    /// A buffer, by its number from 0 to 3.
    pub fn buffer(number: usize) -> Option<OutputId> {
        BUFFERS.get(number).map(|id| OutputId(id.to_string()))
    }

    /// What a buffer of a whole shader is called that its sampler names.
    pub fn of_dialect(name: &str) -> OutputId {
        OutputId(format!("own:{name}"))
    }

    /// The number of the buffer that it is.
    pub fn number(&self) -> Option<usize> {
        BUFFERS.iter().position(|id| *id == self.0)
    }
}

/// What a channel reads.
#[derive(Clone, PartialEq, Debug)]
pub struct Input {
    /// Number of the channel; ShaderToy has 0 to 3.
    pub channel: u8,
    /// The sampler of a whole shader that reads it; `None` for ShaderToy's `iChannel`s.
    pub uniform: Option<String>,
    /// The type of that sampler.
    pub sampler_type: Sampler,
    /// What kind of thing it is.
    pub kind: InputKind,
    /// Its id; for a buffer the [`OutputId`] of the pass.
    pub id: String,
    /// Where the site keeps it.
    pub src: String,
    /// How it is sampled.
    pub sampler: SamplerSettings,
    /// How sound lies in its texture.
    pub signal: SignalForm,
    /// Name of the file that the user gave for it.
    pub name: String,
    /// That file as `data:` addresses, six for a cube map; none where no file is at hand.
    pub urls: Vec<String>,
    /// What is drawn where no file is at hand.
    pub stand_in: Option<StandIn>,
}

/// How sound lies in a texture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SignalForm {
    /// Its spectrum, and above that its wave, in the red component.
    Both,
    /// Its spectrum alone, in gray.
    Spectrum,
    /// Its wave alone, in gray.
    Wave,
    /// Its spectrum at the bottom and above that those of the frames before, in all components.
    History,
    /// The sum of its spectra from the start, in gray: one a second where it is loudest.
    Sum,
}

impl SignalForm {
    /// As the player calls it.
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

/// The kinds of input.
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum InputKind {
    Texture, Buffer, Cubemap, Volume, Keyboard, Video, Webcam, Music, MusicStream, Microphone,
}

impl InputKind {
    /// The kind that a word of an export names.
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

    /// As exports write it.
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

    /// The type of the channel that reads it.
    pub const fn sampler(self) -> Sampler {
        match self {
            InputKind::Cubemap => Sampler::SamplerCube,
            InputKind::Volume => Sampler::Sampler3D,
            _ => Sampler::Sampler2D,
        }
    }
}

/// How an input is sampled. The words are the export's own; unknown ones mean the same to the player
/// as those named last.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct SamplerSettings {
    /// `linear`, `mipmap`, else nearest.
    pub filter: String,
    /// `clamp`, else repeat.
    pub wrap: String,
    /// Whether the picture is turned upside down.
    pub vflip: bool,
}

impl SamplerSettings {
    /// Whether it reads smaller levels of a texture.
    pub fn has_mipmaps(&self) -> bool {
        self.filter == "mipmap"
    }

    /// What most inputs of a kind are set to on the site.
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
    /// An input that holds nothing yet, sampled as most of its kind are.
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
        }
    }
}

impl Project {
    /// Whether some pass of a kind draws what an id names.
    pub fn draws(&self, kind: Pass, id: &str) -> bool {
        let mut all = self.passes.iter().filter(|p| p.kind == kind);
        all.any(|p| p.output.as_ref().is_some_and(|o| o.0 == id))
    }

    /// What ShaderToy's player does with music whose file it cannot load: nothing is on the channel.
    /// It makes a spectrum and a wave up only for music that is loaded and muted. Gives the channels,
    /// like `image.0`.
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

    /// What ShaderToy's player does with two channels that read one buffer in two ways: the wrap
    /// that was loaded last holds for all, and in each pass the filter of the last channel.
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
    /// A pass with nothing but its code.
    pub fn new(kind: Pass, code: impl Into<Arc<str>>) -> ProjectPass {
        ProjectPass {
            kind,
            name: String::new(),
            code: code.into(),
            inputs: Vec::new(),
            output: None,
            wrapper: Wrapper::Player,
            before: Arc::from(""),
            behind: Arc::from(""),
            bound: Bindings::default(),
            stage: Stage::Fragment,
            draw: PassDraw::default(),
            file: None,
        }
    }

    /// What the pass is called in file names and options: `image`, `buffer_a`, `common`.
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

    /// What the user calls it; for a pass without a name, what it draws and its place.
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

    /// By channel: whether its texture has mipmaps; not known of a channel without input.
    pub fn mipmapped(&self) -> [Option<bool>; 4] {
        let mut mipmapped = [None; 4];
        for input in &self.inputs {
            if let Some(slot) = mipmapped.get_mut(input.channel as usize) {
                *slot = Some(input.sampler.filter == "mipmap");
            }
        }
        mipmapped
    }

    /// The type of each channel; a channel without input is a `sampler2D`.
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
    fn music_that_is_not_at_hand_is_not_loaded() {
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
    fn the_players_samplers_are_shared() {
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
