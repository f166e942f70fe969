//! The channels of passes.

use super::shader::PassShader;
use super::signal::Signal;
use super::stand_in::{Film, SubstituteImage};
use super::still::{Decode, Stills};
use super::target::ImagePair;
use super::{PlaybackProblem, Player};
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::{Draw, Filter, Image, ImageShape, Sampling, Stop, Texels, Texture, Wrap};
use shaderlint_project::{Input, InputKind, OutputId, Project};
use shaderlint_semantic::Pass;
use std::sync::Arc;

/// Size of the keyboard texture: three rows of keys, none pressed.
const KEYBOARD: [u32; 3] = [256, 3, 1];

/// A channel of a pass.
pub(super) struct Channel {
    index: usize,
    /// Names of the samplers that read it.
    names: Vec<String>,
    kind: InputKind,
    sampling: Sampling,
    source: ChannelFeed,
}

/// The source of a channel.
enum ChannelFeed {
    /// No texture is bound.
    Nothing,
    Still(Arc<Image>),
    /// A substitute for a file, by its index in the player.
    StandIn(usize),
    /// A render target of passes.
    Target(usize),
    /// A substitute for a video, drawn for each frame.
    Film(Box<Film>),
    /// Synthetic audio, computed for each frame.
    Signal(Box<Signal>),
}

/// The current texture of a channel, and the uniforms that describe it.
pub(super) struct Read {
    texture: Option<Texture>,
    size: [f64; 3],
    time: f64,
}

impl Channel {
    /// The render target that it reads.
    pub fn target(&self) -> Option<usize> {
        match self.source {
            ChannelFeed::Target(target) => Some(target),
            _ => None,
        }
    }

    /// Whether its image is drawn for each frame.
    pub const fn is_film(&self) -> bool {
        matches!(self.source, ChannelFeed::Film(_))
    }

    /// Whether its content depends on previous frames.
    pub fn remembers(&self) -> bool {
        matches!(&self.source, ChannelFeed::Signal(signal) if signal.remembers())
    }

    /// The texture that a pass of a kind reads.
    pub fn read(&self, player: &Player, by: Pass) -> Read {
        // The sound pass has only textures and volumes bound.
        let is_bound =
            by != Pass::Sound || matches!(self.kind, InputKind::Texture | InputKind::Volume);
        let (image, time) = match &self.source {
            _ if !is_bound => (None, 0.0),
            ChannelFeed::Nothing => (None, 0.0),
            ChannelFeed::Still(image) => (Some(Arc::clone(image)), 0.0),
            ChannelFeed::Target(target) => (player.targets.get(*target).map(ImagePair::image), 0.0),
            ChannelFeed::StandIn(at) => {
                (player.stand_ins.get(*at).map(SubstituteImage::image), 0.0)
            }
            ChannelFeed::Film(film) => (Some(film.image()), film.time()),
            ChannelFeed::Signal(signal) => (signal.image(), signal.time()),
        };
        // The player sets no resolution for cube maps from files, nor for the keyboard in the cube
        // map pass.
        let is_sized = match self.kind {
            InputKind::Cubemap => self.target().is_some(),
            InputKind::Keyboard => by != Pass::Cubemap,
            _ => true,
        };
        let size = match &image {
            Some(image) if is_sized => {
                let [width, height, depth] = image.size();
                let depth = if image.shape() == ImageShape::Volume {
                    depth
                } else {
                    1
                };
                [width, height, depth].map(f64::from)
            }
            _ => [0.0; 3],
        };
        let texture = image.map(|image| Texture {
            image,
            sampling: self.sampling,
        });
        Read {
            texture,
            size,
            time,
        }
    }
}

/// Opens the channels of all passes.
pub(super) fn open(
    player: &mut Player,
    project: &Project,
    decode: Option<Decode>,
) -> Result<(), PlaybackProblem> {
    let mut stand_ins = Vec::new();
    let mut stills = Stills::new(decode);
    let mut opened = Vec::new();
    let mut notes = Vec::new();
    for pass in &player.passes {
        let found = project.passes.get(pass.index);
        let mut channels = Vec::new();
        for input in found.map_or(&[][..], |p| &p.inputs) {
            let source = match input.urls.is_empty() {
                true => source(player, project, input, &mut stand_ins)?,
                false => match stills.get(input) {
                    Ok(image) => ChannelFeed::Still(image),
                    Err(why) => {
                        let title = found.map_or(String::new(), |f| f.title(pass.index));
                        let (source, instead) = in_place_of_file(input);
                        let index = input.channel;
                        notes.push(format!(
                            "{title}: cannot read the file of channel {index}: {why}; {instead}"
                        ));
                        source
                    }
                },
            };
            channels.push(channel(input, source));
        }
        opened.push(channels);
    }
    player.notes.append(&mut notes);
    player.stand_ins = stand_ins;
    for (pass, channels) in player.passes.iter_mut().zip(opened) {
        pass.channels = channels;
    }
    Ok(())
}

/// The substitute for a file that cannot be read, with its description.
fn in_place_of_file(input: &Input) -> (ChannelFeed, &'static str) {
    match input.kind {
        InputKind::Music | InputKind::MusicStream => (
            ChannelFeed::Signal(Box::new(Signal::new(input))),
            "using a synthetic spectrum and wave",
        ),
        _ => (ChannelFeed::Nothing, "the channel is empty"),
    }
}

fn channel(input: &Input, source: ChannelFeed) -> Channel {
    let index = usize::from(input.channel);
    let is_keyboard = input.kind == InputKind::Keyboard;
    let filter = match input.sampler.filter.as_str() {
        _ if is_keyboard => Filter::Nearest,
        "linear" => Filter::Linear,
        "mipmap" => Filter::Mipmap,
        _ => Filter::Nearest,
    };
    let wrap = if is_keyboard || input.sampler.wrap == "clamp" {
        Wrap::Clamp
    } else {
        Wrap::Repeat
    };
    Channel {
        index,
        names: match &input.uniform {
            Some(name) => vec![name.clone()],
            None => vec![format!("iChannel{index}"), format!("iCh{index}.sampler")],
        },
        kind: input.kind,
        sampling: Sampling {
            filter,
            wrap: [wrap; 3],
        },
        source,
    }
}

fn source(
    player: &Player,
    project: &Project,
    input: &Input,
    stand_ins: &mut Vec<SubstituteImage>,
) -> Result<ChannelFeed, PlaybackProblem> {
    let draws_cube = player.passes.iter().any(|p| p.kind == Pass::Cubemap);
    match input.kind {
        InputKind::Buffer => return Ok(of_buffer(player, project, input)),
        InputKind::Cubemap if draws_cube && input.id == OutputId::CUBE => {
            let cube = player.passes.iter().find(|p| p.kind == Pass::Cubemap);
            let target = cube.and_then(|p| p.target);
            return Ok(target.map_or(ChannelFeed::Nothing, ChannelFeed::Target));
        }
        InputKind::Keyboard => return Ok(still(KEYBOARD)),
        InputKind::Music | InputKind::MusicStream | InputKind::Microphone => {
            return Ok(ChannelFeed::Signal(Box::new(Signal::new(input))));
        }
        _ => {}
    }
    let Some(stand_in) = input.stand_in else {
        return Ok(ChannelFeed::Nothing);
    };
    if input.kind == InputKind::Video {
        let film = Film::new(&stand_in, input)?;
        return Ok(ChannelFeed::Film(Box::new(film)));
    }
    let at = SubstituteImage::index(stand_ins, &stand_in, input)?;
    Ok(ChannelFeed::StandIn(at))
}

/// The source of a channel that names a buffer: the render target of the pass that draws it, or an
/// empty one.
fn of_buffer(player: &Player, project: &Project, input: &Input) -> ChannelFeed {
    let is_drawn = |index: usize| {
        let pass = project.passes.get(index);
        let output = pass.and_then(|p| p.output.as_ref());
        !input.id.is_empty() && output.is_some_and(|o| o.0 == input.id)
    };
    let mut drawn = player
        .passes
        .iter()
        .filter(|p| matches!(p.kind, Pass::Buffer | Pass::Image));
    let target = drawn.find(|p| is_drawn(p.index)).and_then(|p| p.target);
    let [width, height] = player.size;
    target.map_or_else(|| still([width, height, 1]), ChannelFeed::Target)
}

/// An image of zeros.
fn still([width, height, depth]: [u32; 3]) -> ChannelFeed {
    let texels = Texels::Unorm8(vec![[0; 4]; width as usize * height as usize]);
    let image = Image::new(ImageShape::Flat, [width, height, depth], texels);
    image.map_or(ChannelFeed::Nothing, |image| {
        ChannelFeed::Still(Arc::new(image))
    })
}

/// Updates the sources that change with each frame. `paints` is whether images are painted; else they
/// only have their sizes and times.
pub(super) fn update(player: &mut Player, moment: &Moment, paints: bool) -> Result<(), Stop> {
    let threads = player.threads;
    if paints {
        for stand_in in &mut player.stand_ins {
            stand_in.paint(threads)?;
        }
    }
    for channel in player.passes.iter_mut().flat_map(|p| &mut p.channels) {
        let has_levels = channel.sampling.filter == Filter::Mipmap;
        match &mut channel.source {
            ChannelFeed::Film(film) if paints => film.update(moment.time, threads)?,
            ChannelFeed::Film(film) => film.seek(moment.time),
            ChannelFeed::Signal(signal) => signal.update(moment.time, has_levels),
            ChannelFeed::Nothing
            | ChannelFeed::Still(_)
            | ChannelFeed::StandIn(_)
            | ChannelFeed::Target(_) => {}
        }
    }
    Ok(())
}

/// Binds the channels in a draw.
pub(super) fn bind(draw: &mut Draw<'_>, shader: &PassShader, given: &[(&Channel, Read)]) {
    let mut times = [0.0; 4];
    let mut sizes = [[0.0; 3]; 4];
    for (channel, read) in given {
        for name in &channel.names {
            if let Some(texture) = &read.texture {
                draw.bind(name, texture.clone());
            }
            let names: Vec<String> = shader.sizes_of(name).map(str::to_string).collect();
            for name in names {
                set(draw, &name, &read.size);
            }
        }
        let slots = times
            .get_mut(channel.index)
            .zip(sizes.get_mut(channel.index));
        if let Some((time, size)) = slots {
            (*time, *size) = (read.time, read.size);
        }
        let of = |member: &str| format!("iCh{}.{member}", channel.index);
        draw.set(&of("size"), &read.size);
        draw.set(&of("time"), &[read.time]);
        draw.set(
            &of("loaded"),
            &[f64::from(u8::from(read.texture.is_some()))],
        );
    }
    set(draw, "iChannelTime", &times);
    set(draw, "iChannelResolution", sizes.as_flattened());
}

/// Sets a uniform, with as many components as it has.
fn set(draw: &mut Draw<'_>, name: &str, lanes: &[f64]) {
    let slot = draw.code.uniforms.iter().find(|slot| slot.name == name);
    let Some(ty) = slot.map(|slot| slot.ty) else {
        return;
    };
    let count = (ty.element().components() * ty.array.max(1)) as usize;
    let mut lanes = lanes.to_vec();
    lanes.resize(count, 0.0);
    draw.set(name, &lanes);
}
