//! What a user puts onto a channel: `image.0=buffer_a`, `1=photo.jpg,nearest,clamp`, `0=keyboard`.

use super::parts::{near, unknown_pass};
use super::{Input, InputKind, PassRole, Project, SamplerSettings};
use crate::semantic::Pass;

/// An order of the user for one channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ChannelOrder {
    /// The pass; without one it is the Image.
    pub pass: PassRole,
    /// The channel, 0 to 3.
    pub channel: u8,
    /// What it shall read.
    pub source: ChannelSource,
    /// How; `None` keeps what is there, or what is usual.
    pub filter: Option<&'static str>,
    /// How; `None` keeps what is there, or what is usual.
    pub wrap: Option<&'static str>,
    /// Whether pictures are turned upside down; `None` keeps what is there, or what is usual.
    pub vflip: Option<bool>,
}

/// What a channel shall read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ChannelSource {
    /// What a pass of the project draws.
    Pass(PassRole),
    /// A device.
    Device(InputKind),
    /// A file, by its path.
    File(String),
}

impl ChannelOrder {
    /// Reads an order.
    pub fn read(text: &str) -> Result<ChannelOrder, String> {
        let wrong = || {
            format!(
                "`{text}` is no channel; write it like `0=keyboard`, `image.1=photo.jpg` or `buffer_a.0=buffer_a`"
            )
        };
        let (place, source) = text.split_once('=').ok_or_else(wrong)?;
        let (pass, channel) = match place.rsplit_once('.') {
            Some((pass, channel)) => {
                let role = PassRole::of_name(pass).ok_or_else(|| unknown_pass(pass))?;
                (role, channel)
            }
            None => (PassRole::Image, place),
        };
        let channel = channel.parse::<u8>().ok().filter(|c| *c < 4);
        let channel = channel.ok_or("a channel is a number from 0 to 3".to_string())?;
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

    /// Takes a word behind the source; tells whether it is one.
    fn take_word(&mut self, word: &str) -> bool {
        match word {
            "nearest" => self.filter = Some("nearest"),
            "linear" => self.filter = Some("linear"),
            "mipmap" => self.filter = Some("mipmap"),
            "clamp" => self.wrap = Some("clamp"),
            "repeat" => self.wrap = Some("repeat"),
            "flip" => self.vflip = Some(true),
            "noflip" => self.vflip = Some(false),
            _ => return false,
        }
        true
    }
}

/// The words that name a device.
const DEVICES: [(&str, InputKind); 3] = [
    ("keyboard", InputKind::Keyboard),
    ("webcam", InputKind::Webcam),
    ("mic", InputKind::Microphone),
];

/// What to say of a source that is neither a file nor a word.
pub fn unknown_source(text: &str) -> String {
    let devices = DEVICES.iter().map(|(word, _)| *word);
    match near(text, devices.chain(PassRole::ALL.map(PassRole::name))) {
        Some(word) => format!("there is no file `{text}`; did you mean `{word}`?"),
        None => format!(
            "there is no file `{text}`; a channel reads a file, a pass such as `buffer_a`, \
             `keyboard`, `webcam` or `mic`"
        ),
    }
}

fn source_of(text: &str) -> ChannelSource {
    let device = DEVICES.iter().find(|(word, _)| *word == text);
    match device {
        Some((_, kind)) => ChannelSource::Device(*kind),
        None => match PassRole::of_name(text) {
            Some(role) if !text.contains(['.', '/', '\\']) => ChannelSource::Pass(role),
            _ => ChannelSource::File(text.to_string()),
        },
    }
}

/// A file that goes onto a channel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Media {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: InputKind,
    /// Its content as `data:` addresses; six for the faces of a cube map.
    pub urls: Vec<String>,
}

impl Project {
    /// Carries an order out. `media` is the file that it names.
    pub fn put(&mut self, order: &ChannelOrder, media: Option<Media>) -> Result<(), String> {
        let (kind, id) = self.source_kind(order, media.as_ref())?;
        let wanted = order.pass;
        let output = wanted.output();
        let no_pass = self.no_pass(wanted);
        let pass = self
            .passes
            .iter_mut()
            .find(|p| p.kind == wanted.kind() && (p.kind != Pass::Buffer || p.output == output));
        let pass = pass.filter(|p| p.kind != Pass::Common).ok_or(no_pass)?;
        let old = pass.inputs.iter().rposition(|i| i.channel == order.channel);
        let mut input = match old.map(|at| pass.inputs.remove(at)) {
            // Music of an export stays music, and keeps its sampler.
            Some(old) if old.kind.takes(kind) => Input { kind, ..old },
            _ => Input::empty(order.channel, kind),
        };
        pass.inputs.retain(|i| i.channel != order.channel);
        input.id = id;
        if let Some(media) = media {
            (input.name, input.urls) = (media.name, media.urls);
        }
        let SamplerSettings {
            filter,
            wrap,
            vflip,
        } = &mut input.sampler;
        if let Some(word) = order.filter {
            *filter = word.to_string();
        }
        if let Some(word) = order.wrap {
            *wrap = word.to_string();
        }
        *vflip = order.vflip.unwrap_or(*vflip);
        pass.inputs.push(input);
        Ok(())
    }

    /// The kind of input that an order asks for, and the id of the pass that it names.
    fn source_kind(
        &self,
        order: &ChannelOrder,
        media: Option<&Media>,
    ) -> Result<(InputKind, String), String> {
        match &order.source {
            ChannelSource::Device(kind) => Ok((*kind, String::new())),
            ChannelSource::File(path) => {
                let media = media.ok_or_else(|| unknown_source(path))?;
                let kind = match media.kind {
                    InputKind::Texture if media.urls.len() == 6 => InputKind::Cubemap,
                    kind => kind,
                };
                Ok((kind, String::new()))
            }
            ChannelSource::Pass(role) => {
                let id = role.output().map_or(String::new(), |o| o.0);
                let kind = match role {
                    PassRole::Buffer(_) => InputKind::Buffer,
                    PassRole::Cubemap => InputKind::Cubemap,
                    _ => return Err(format!("no channel can read the pass `{}`", role.name())),
                };
                if !self.draws(role.kind(), &id) {
                    return Err(self.no_pass(*role));
                }
                Ok((kind, id))
            }
        }
    }
}

impl Project {
    /// What to say where a pass is named that the project does not have.
    fn no_pass(&self, wanted: PassRole) -> String {
        let drawn = self.passes.iter().filter(|p| p.kind != Pass::Common);
        let names: Vec<String> = drawn.map(|p| format!("`{}`", p.slug())).collect();
        format!(
            "there is no pass `{}`; there is {}",
            wanted.name(),
            names.join(", ")
        )
    }
}

impl InputKind {
    /// Whether a file of another kind can take the place of what a channel of this kind reads.
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
    use crate::port::{Info, ProjectPass};

    #[test]
    fn orders_are_read() {
        let order = ChannelOrder::read("buffer_a.2=pictures/a,b.jpg,nearest,clamp,noflip").unwrap();
        assert_eq!(order.pass, PassRole::Buffer(0));
        assert_eq!(order.channel, 2);
        assert_eq!(
            order.source,
            ChannelSource::File("pictures/a,b.jpg".to_string())
        );
        assert_eq!((order.filter, order.wrap), (Some("nearest"), Some("clamp")));
        assert_eq!(order.vflip, Some(false));
        let order = ChannelOrder::read("0=bufferB").unwrap();
        assert_eq!(order.source, ChannelSource::Pass(PassRole::Buffer(1)));
        assert_eq!(order.pass, PassRole::Image);
        for wrong in ["", "0", "4=keyboard", "x.0=keyboard", "0="] {
            assert!(ChannelOrder::read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn orders_are_carried_out() {
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
}
