//! What a user puts onto a channel: `image.0=buffer_a`, `1=photo.jpg,nearest,clamp`, `0=keyboard`.

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
                let role = PassRole::of_name(pass)
                    .ok_or_else(|| format!("`{pass}` is no pass; there are {PASSES}"))?;
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

const PASSES: &str = "`image`, `buffer_a` to `buffer_d`, `cubemap` and `sound`";

fn source_of(text: &str) -> ChannelSource {
    match text {
        "keyboard" => ChannelSource::Device(InputKind::Keyboard),
        "webcam" => ChannelSource::Device(InputKind::Webcam),
        "mic" => ChannelSource::Device(InputKind::Microphone),
        _ => match PassRole::of_name(text) {
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
    /// Its content as `data:` addresses; six for the faces of a cube map.
    pub urls: Vec<String>,
}

/// The kind of input that a file is, by its ending, with its media type.
pub fn kind_of_file(path: &str) -> Option<(InputKind, &'static str)> {
    let ending = path.rsplit_once('.')?.1.to_ascii_lowercase();
    Some(match ending.as_str() {
        "png" => (InputKind::Texture, "image/png"),
        "jpg" | "jpeg" => (InputKind::Texture, "image/jpeg"),
        "webp" => (InputKind::Texture, "image/webp"),
        "gif" => (InputKind::Texture, "image/gif"),
        "avif" => (InputKind::Texture, "image/avif"),
        "bmp" => (InputKind::Texture, "image/bmp"),
        "mp4" => (InputKind::Video, "video/mp4"),
        "webm" => (InputKind::Video, "video/webm"),
        "ogv" => (InputKind::Video, "video/ogg"),
        "mp3" => (InputKind::Music, "audio/mpeg"),
        "ogg" | "oga" => (InputKind::Music, "audio/ogg"),
        "wav" => (InputKind::Music, "audio/wav"),
        "flac" => (InputKind::Music, "audio/flac"),
        "bin" => (InputKind::Volume, "application/octet-stream"),
        _ => return None,
    })
}

impl Project {
    /// Carries an order out. `media` is the file that it names.
    pub fn put(&mut self, order: &ChannelOrder, media: Option<Media>) -> Result<(), String> {
        let (kind, id) = self.source_kind(order, media.as_ref())?;
        let wanted = order.pass;
        let output = wanted.output();
        let pass = self
            .passes
            .iter_mut()
            .find(|p| p.kind == wanted.kind() && (p.kind != Pass::Buffer || p.output == output));
        let pass = pass
            .filter(|p| p.kind != Pass::Common)
            .ok_or_else(|| format!("there is no pass `{}`", wanted.name()))?;
        let old = pass.inputs.iter().rposition(|i| i.channel == order.channel);
        let mut input = match old.map(|at| pass.inputs.remove(at)) {
            // Music of an export stays music, and keeps its sampler.
            Some(old) if same_texture(old.kind, kind) => Input { kind, ..old },
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
                let (kind, _) = kind_of_file(path)
                    .ok_or_else(|| format!("{path}: this is no picture, film, music or volume"))?;
                let is_cube = media.is_some_and(|m| m.urls.len() == 6);
                Ok((
                    if is_cube { InputKind::Cubemap } else { kind },
                    String::new(),
                ))
            }
            ChannelSource::Pass(role) => {
                let id = role.output().map_or(String::new(), |o| o.0);
                let kind = match role {
                    PassRole::Buffer(_) => InputKind::Buffer,
                    PassRole::Cubemap => InputKind::Cubemap,
                    _ => return Err(format!("no channel can read the pass `{}`", role.name())),
                };
                if !self.draws(role.kind(), &id) {
                    return Err(format!("there is no pass `{}` to read", role.name()));
                }
                Ok((kind, id))
            }
        }
    }
}

/// Whether two kinds are sampled in the same way, so that one can take the other's place.
fn same_texture(a: InputKind, b: InputKind) -> bool {
    use InputKind::{Music, MusicStream};
    a == b || matches!((a, b), (Music | MusicStream, Music | MusicStream))
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
