//! Channel orders of the user: `image.0=buffer_a`, `1=photo.jpg,nearest,clamp`, `0=keyboard`, or
//! with the name of a sampler, `u_tex0=photo.jpg`.

use super::parts::{near, unknown_pass};
use crate::{
    Input, InputKind, MAX_CHANNELS, PassRole, Project, ProjectPass, SamplerSettings, Wrapper,
};
use shaderlint_semantic::{Pass, channel};

/// An order of the user that sets the input of one channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ChannelOrder {
    /// The pass; `None` is the Image, or every pass that declares the sampler.
    pub pass: Option<PassRole>,
    /// The channel, by number or sampler.
    pub channel: ChannelName,
    /// The input to put on the channel.
    pub source: ChannelSource,
    /// `nearest`, `linear` or `mipmap`; `None` keeps the current or default filter.
    pub filter: Option<&'static str>,
    /// `clamp` or `repeat`; `None` keeps the current or default wrap mode.
    pub wrap: Option<&'static str>,
    /// Whether images are flipped vertically; `None` keeps the current or default setting.
    pub vflip: Option<bool>,
}

/// How a user refers to a channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ChannelName {
    /// Its number.
    Number(u8),
    /// The name of the sampler that reads it.
    Sampler(String),
}

/// The input that an order puts on a channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ChannelSource {
    /// The output of a pass of the project.
    Pass(PassRole),
    /// The output of the pass itself, one frame before.
    Itself,
    /// A device: keyboard, camera or microphone.
    Device(InputKind),
    /// The path of a file.
    File(String),
    /// Nothing: a generated image of the type that the code reads.
    StandIn,
}

impl ChannelName {
    /// The number of the channel, if it is one of ShaderToy's.
    pub(crate) fn number(&self) -> Option<u8> {
        match self {
            ChannelName::Number(number) => Some(*number),
            ChannelName::Sampler(name) => channel(name),
        }
    }
}

impl ChannelOrder {
    /// Parses an order.
    pub fn read(text: &str) -> Result<ChannelOrder, String> {
        let wrong = || {
            format!(
                "expected `[PASS.]N=SOURCE`, found `{text}`; examples: `0=keyboard`, \
                 `image.1=photo.jpg`, `buffer_a.0=buffer_a`"
            )
        };
        let (place, source) = text.split_once('=').ok_or_else(wrong)?;
        let (pass, channel) = match place.rsplit_once('.') {
            Some((pass, channel)) => {
                let role = PassRole::of_name(pass).ok_or_else(|| unknown_pass(pass))?;
                (Some(role), channel)
            }
            None => (None, place),
        };
        let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '[' | ']');
        let is_name = channel.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
            && channel.chars().all(is_part);
        let channel = match channel.parse::<u8>().ok().filter(|n| *n < MAX_CHANNELS) {
            Some(number) => ChannelName::Number(number),
            None if is_name => ChannelName::Sampler(channel.to_string()),
            None => {
                return Err("expected a channel from 0 to 3, or the name of a sampler".to_string());
            }
        };
        let mut order = ChannelOrder {
            pass,
            channel,
            source: ChannelSource::File(String::new()),
            filter: None,
            wrap: None,
            vflip: None,
        };
        let mut source = source;
        while let Some((before, word)) = source.rsplit_once(',')
            && order.take_word(word.trim())
        {
            source = before;
        }
        if source.is_empty() {
            return Err(wrong());
        }
        order.source = source_of(source);
        Ok(order)
    }

    /// Applies a sampling word after the source; returns whether it is one.
    fn take_word(&mut self, word: &str) -> bool {
        let known = SAMPLING.into_iter().find(|known| *known == word);
        match known {
            Some("nearest" | "linear" | "mipmap") => self.filter = known,
            Some("clamp" | "repeat") => self.wrap = known,
            Some(word) => self.vflip = Some(word == "flip"),
            None => return false,
        }
        true
    }

    /// Applies the sampling words to the settings of a sampler.
    fn set_sampling(&self, sampler: &mut SamplerSettings) {
        if let Some(word) = self.filter {
            sampler.filter = word.to_string();
        }
        if let Some(word) = self.wrap {
            sampler.wrap = word.to_string();
        }
        sampler.vflip = self.vflip.unwrap_or(sampler.vflip);
    }
}

impl ProjectPass {
    /// The number of the channel that a sampler reads.
    fn channel_of(&self, sampler: &str) -> Option<u8> {
        let is_it = |i: &&Input| match &i.uniform {
            Some(name) => name == sampler,
            None => channel(sampler) == Some(i.channel),
        };
        let own = self.inputs.iter().find(is_it).map(|i| i.channel);
        own.or_else(|| channel(sampler).filter(|n| *n < 4 && self.wrapper == Wrapper::Player))
    }
}

/// The words for sampler settings.
const SAMPLING: [&str; 7] = [
    "nearest", "linear", "mipmap", "clamp", "repeat", "flip", "noflip",
];

/// The word for an input that is not available.
pub(super) const STAND_IN: &str = "stand-in";

const DEVICES: [(&str, InputKind); 3] = [
    ("keyboard", InputKind::Keyboard),
    ("webcam", InputKind::Webcam),
    ("mic", InputKind::Microphone),
];

/// The error for a source that is neither a file nor a known word.
pub fn unknown_source(text: &str) -> String {
    let how = text.rsplit_once(',').map(|(_, word)| word.trim());
    if let Some(how) = how
        && let Some(word) = near(how, SAMPLING)
    {
        return format!("file `{text}` not found; did you mean `{word}` instead of `{how}`?");
    }
    let devices = DEVICES.iter().map(|(word, _)| *word).chain([STAND_IN]);
    match near(text, devices.chain(PassRole::ALL.map(PassRole::name))) {
        Some(word) => format!("file `{text}` not found; did you mean `{word}`?"),
        None => format!(
            "file `{text}` not found; a channel reads a file, a pass such as `buffer_a`, \
             `keyboard`, `webcam`, `mic` or `stand-in`"
        ),
    }
}

fn source_of(text: &str) -> ChannelSource {
    let device = DEVICES.iter().find(|(word, _)| *word == text);
    match device {
        Some((_, kind)) => ChannelSource::Device(*kind),
        None if text == STAND_IN => ChannelSource::StandIn,
        None if text == "self" => ChannelSource::Itself,
        None => match PassRole::of_name(text) {
            Some(role) if !text.contains(['.', '/', '\\']) => ChannelSource::Pass(role),
            _ => ChannelSource::File(text.to_string()),
        },
    }
}

/// A media file for a channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Media {
    /// The file name.
    pub name: String,
    /// The kind of input, detected from the content.
    pub kind: InputKind,
    /// The content as `data:` URLs; six for the faces of a cube map.
    pub urls: Vec<String>,
}

impl Project {
    /// Applies an order. `media` is the file that it refers to.
    pub fn put(&mut self, order: &ChannelOrder, media: Option<Media>) -> Result<(), String> {
        let source = self.source_kind(order, media.as_ref())?;
        for (pass, channel) in self.places_of(order)? {
            let Some(pass) = self.passes.get_mut(pass) else {
                continue;
            };
            let old = pass.inputs.iter().rposition(|i| i.channel == channel);
            let old = old.map(|at| pass.inputs.remove(at));
            pass.inputs.retain(|i| i.channel != channel);
            let mut input = match (&source, old) {
                (None, old) => Input {
                    urls: Vec::new(),
                    ..old.unwrap_or_else(|| Input::empty(channel, InputKind::Texture))
                },
                // Music in an export stays music and keeps its sampler settings.
                (Some((kind, id)), Some(old)) if old.kind.takes(*kind) => Input {
                    kind: *kind,
                    id: id.clone(),
                    ..old
                },
                (Some((kind, id)), old) => Input {
                    uniform: old.and_then(|o| o.uniform),
                    id: id.clone(),
                    ..Input::empty(channel, *kind)
                },
            };
            input.is_given = true;
            if let Some(media) = &media {
                (input.name, input.urls) = (media.name.clone(), media.urls.clone());
            }
            order.set_sampling(&mut input.sampler);
            pass.inputs.push(input);
        }
        Ok(())
    }

    /// The passes that an order applies to, by index, each with its channel.
    ///
    /// # Errors
    /// If there is no such pass or channel.
    pub fn places_of(&self, order: &ChannelOrder) -> Result<Vec<(usize, u8)>, String> {
        let is_requested = |pass: &ProjectPass, role: PassRole| {
            let is_it = pass.kind != Pass::Buffer || pass.output == role.output();
            pass.kind == role.kind() && pass.kind != Pass::Common && is_it
        };
        let all = || (0..).zip(&self.passes);
        let number = match &order.channel {
            ChannelName::Number(number) => *number,
            ChannelName::Sampler(name) => {
                let requested =
                    |p: &ProjectPass| order.pass.is_none_or(|role| is_requested(p, role));
                let passes = all().filter(|(_, p)| requested(p));
                let found = passes.filter_map(|(i, p)| Some((i, p.channel_of(name)?)));
                let found: Vec<_> = found.collect();
                return match found.is_empty() {
                    true => Err(self.no_sampler(name)),
                    false => Ok(found),
                };
            }
        };
        let role = order.pass.unwrap_or(PassRole::Image);
        let pass = all().find(|(_, p)| is_requested(p, role));
        let (index, pass) = pass.ok_or_else(|| self.no_pass(role))?;
        match pass.wrapper == Wrapper::Player && number > 3 {
            true => Err("expected a channel from 0 to 3".to_string()),
            false => Ok(vec![(index, number)]),
        }
    }

    /// The samplers with another name in `after`, the same project with other texts, and these names.
    pub fn renamed_samplers(&self, after: &Project) -> Vec<(String, String)> {
        let passes = self.passes.iter().zip(&after.passes);
        let passes = passes.filter(|(old, new)| old.inputs.len() == new.inputs.len());
        let inputs = passes.flat_map(|(old, new)| old.inputs.iter().zip(&new.inputs));
        let names =
            inputs.filter_map(|(old, new)| Some((old.uniform.clone()?, new.uniform.clone()?)));
        names.filter(|(old, new)| old != new).collect()
    }

    /// The kind of input for an order, and the id of the pass that it refers to; `None` for a
    /// stand-in.
    fn source_kind(
        &self,
        order: &ChannelOrder,
        media: Option<&Media>,
    ) -> Result<Option<(InputKind, String)>, String> {
        match &order.source {
            ChannelSource::StandIn | ChannelSource::Itself => Ok(None),
            ChannelSource::Device(kind) => Ok(Some((*kind, String::new()))),
            ChannelSource::File(path) => {
                let media = media.ok_or_else(|| unknown_source(path))?;
                let kind = match media.kind {
                    InputKind::Texture if media.urls.len() == 6 => InputKind::Cubemap,
                    kind => kind,
                };
                Ok(Some((kind, String::new())))
            }
            ChannelSource::Pass(role) => {
                let id = role.output().map_or(String::new(), |o| o.0);
                let kind = match role {
                    PassRole::Buffer(_) => InputKind::Buffer,
                    PassRole::Cubemap => InputKind::Cubemap,
                    _ => return Err(format!("channels cannot read the pass `{}`", role.name())),
                };
                if !self.draws(role.kind(), &id) {
                    return Err(self.no_pass(*role));
                }
                Ok(Some((kind, id)))
            }
        }
    }
}

impl Project {
    /// The error for a sampler that no pass declares.
    fn no_sampler(&self, requested: &str) -> String {
        let mut names: Vec<&str> = Vec::new();
        let inputs = self.passes.iter().flat_map(|p| &p.inputs);
        for name in inputs.filter_map(|i| i.uniform.as_deref()) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        match names.is_empty() {
            true => format!("unknown sampler `{requested}`"),
            false => format!(
                "unknown sampler `{requested}`; the shader has `{}`",
                names.join("`, `")
            ),
        }
    }

    /// The error for a pass that is not in the project.
    fn no_pass(&self, requested: PassRole) -> String {
        let drawn = self.passes.iter().filter(|p| p.kind != Pass::Common);
        let names: Vec<String> = drawn.map(|p| format!("`{}`", p.slug())).collect();
        format!(
            "the project has no pass `{}`; it has {}",
            requested.name(),
            names.join(", ")
        )
    }
}

impl InputKind {
    /// Whether a file of another kind can replace an input of this kind.
    pub fn takes(self, file: InputKind) -> bool {
        use InputKind::{Cubemap, Music, MusicStream, Texture};
        self == file
            || matches!(
                (self, file),
                (Cubemap, Texture) | (Music | MusicStream, Music)
            )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Info, ProjectPass};

    #[test]
    fn misspelled_options_are_distinguished_from_files() {
        let message = |text: &str| unknown_source(text);
        assert!(
            message("keyboard,neerest").ends_with("did you mean `nearest` instead of `neerest`?")
        );
        assert!(message("keybord").ends_with("did you mean `keyboard`?"));
        assert!(message("photo,summer.jpg").contains("a channel reads a file"));
    }

    #[test]
    fn channel_arguments_are_parsed() {
        let order = ChannelOrder::read("buffer_a.2=pictures/a,b.jpg,nearest,clamp,noflip").unwrap();
        assert_eq!(order.pass, Some(PassRole::Buffer(0)));
        assert_eq!(order.channel, ChannelName::Number(2));
        assert_eq!(
            order.source,
            ChannelSource::File("pictures/a,b.jpg".to_string())
        );
        assert_eq!((order.filter, order.wrap), (Some("nearest"), Some("clamp")));
        assert_eq!(order.vflip, Some(false));
        let order = ChannelOrder::read("0=bufferB").unwrap();
        assert_eq!(order.source, ChannelSource::Pass(PassRole::Buffer(1)));
        assert_eq!(order.pass, None);
        for wrong in ["", "0", "16=keyboard", "-1=keyboard", "x.0=keyboard", "0="] {
            assert!(ChannelOrder::read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn channel_arguments_are_applied() {
        let mut project = Project {
            info: Info::default(),
            passes: vec![ProjectPass::new(Pass::Image, "")],
            ..Project::default()
        };
        let missing = ChannelOrder::read("0=buffer_a").unwrap();
        assert!(project.put(&missing, None).is_err());
        let keys = ChannelOrder::read("0=keyboard").unwrap();
        project.put(&keys, None).unwrap();
        let order = ChannelOrder::read("0=a.png,linear").unwrap();
        let media = Media {
            name: "a.png".to_string(),
            kind: InputKind::Texture,
            urls: vec!["data:,".to_string()],
        };
        project.put(&order, Some(media)).unwrap();
        let inputs = &project.passes[0].inputs;
        assert_eq!(inputs.len(), 1);
        assert_eq!(inputs[0].kind, InputKind::Texture);
        assert_eq!(inputs[0].sampler.filter, "linear");
        assert_eq!(inputs[0].sampler.wrap, "repeat");
    }

    #[test]
    fn channels_are_named_by_their_sampler() {
        let code = "precision highp float;\nuniform sampler2D photo;\nuniform sampler2D maps[4];\n\
            void main() { gl_FragColor = texture2D(photo, vec2(0.5)) + texture2D(maps[3], vec2(0.5)); }\n";
        let mut project = Project::from_shader("", code).unwrap();
        let mut put = |text: &str| project.put(&ChannelOrder::read(text).unwrap(), None);
        put("photo=keyboard").unwrap();
        put("image.maps[3]=webcam,nearest").unwrap();
        put("2=mic").unwrap();
        let wrong = put("image.other=mic").unwrap_err();
        assert!(
            wrong.contains("`photo`") && wrong.contains("`maps[0]`"),
            "{wrong}"
        );
        let mut inputs: Vec<(u8, InputKind, Option<&str>)> = project.passes[0]
            .inputs
            .iter()
            .map(|i| (i.channel, i.kind, i.uniform.as_deref()))
            .collect();
        inputs.sort_by_key(|i| i.0);
        assert_eq!(inputs[0], (0, InputKind::Keyboard, Some("photo")));
        assert_eq!(inputs[2], (2, InputKind::Microphone, Some("maps[1]")));
        assert_eq!(inputs[4], (4, InputKind::Webcam, Some("maps[3]")));
        let mut toy = Project::from_shader("", "void mainImage(out vec4 o, vec2 u) {}").unwrap();
        let mut put = |text: &str| toy.put(&ChannelOrder::read(text).unwrap(), None);
        put("iChannel1=keyboard").unwrap();
        assert!(put("4=keyboard").is_err() && put("iChannel4=keyboard").is_err());
        assert_eq!(toy.passes[0].inputs[0].channel, 1);
    }
}
