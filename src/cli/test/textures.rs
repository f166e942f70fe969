//! The textures that comments of a test give by name: `// texture: iChannel0 = brick.png`, or
//! `buffer_a at frame 3` for a pass of the project in the same folder.

use super::super::image_file::decode;
use super::super::run::{Undrawable, read};
use crate::commands::run::{ObservedRays, ShotSetting, shot};
use crate::engine::inputs::Moment;
use crate::exec::{Filter, Image, ImageShape, Sampling, Texels, Texture, Watch, Wrap};
use crate::play::{RenderedImage, TextureMark};
use crate::project::{ChannelOrder, ChannelSource};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Size of buffers, that of the frame in which tests run.
const SIZE: [u32; 2] = [1280, 720];
/// Separates a buffer and its frame.
const AT_FRAME: &str = " at frame ";

/// The textures of a run, each loaded once.
#[derive(Default)]
pub struct Textures(Mutex<BTreeMap<(PathBuf, String), Result<Texture, String>>>);

impl Textures {
    /// The texture of a comment in a file.
    ///
    /// # Errors
    /// Why it cannot be loaded.
    pub fn load(&self, mark: &TextureMark, file: &Path) -> Result<Texture, String> {
        let folder = file.parent().unwrap_or(Path::new("")).to_path_buf();
        let key = (folder, mark.source.clone());
        let known = |all: &BTreeMap<_, Result<Texture, String>>| all.get(&key).cloned();
        if let Some(known) = self.0.lock().ok().and_then(|all| known(&all)) {
            return known;
        }
        let made = texture(&mark.source, &key.0);
        if let Ok(mut all) = self.0.lock() {
            all.insert(key, made.clone());
        }
        made
    }
}

/// The file that a comment names, if it names one.
pub fn file_of(mark: &TextureMark, file: &Path) -> Option<PathBuf> {
    let (source, _) = mark
        .source
        .split_once(AT_FRAME)
        .unwrap_or((&mark.source, ""));
    match ChannelOrder::read(&format!("texture={source}"))
        .ok()?
        .source
    {
        ChannelSource::File(path) => Some(file.with_file_name(path)),
        _ => None,
    }
}

fn texture(text: &str, folder: &Path) -> Result<Texture, String> {
    let (source, frame) = match text.split_once(AT_FRAME) {
        Some((source, frame)) => (source.trim(), Some(frame.trim())),
        None => (text, None),
    };
    let expected = || format!("expected a frame number after `at frame`, found `{text}`");
    let frame = frame.map(|frame| frame.parse::<u32>().map_err(|_| expected()));
    let frame = frame.transpose()?;
    let order = ChannelOrder::read(&format!("texture={source}"))?;
    let image = match (&order.source, frame) {
        (ChannelSource::File(path), None) => still(&folder.join(path), order.vflip != Some(false))?,
        (ChannelSource::Pass(role), frame) => buffer(folder, role.name(), frame.unwrap_or(0))?,
        _ => return Err(format!("`{text}` is not an image file or a buffer")),
    };
    let wrap = match order.wrap {
        Some("clamp") => Wrap::Clamp,
        _ => Wrap::Repeat,
    };
    let (filter, image) = match order.filter {
        Some("nearest") => (Filter::Nearest, image),
        Some("mipmap") => (Filter::Mipmap, image.with_levels()),
        _ => (Filter::Linear, image),
    };
    Ok(Texture {
        image: Arc::new(image),
        sampling: Sampling {
            filter,
            wrap: [wrap; 3],
        },
    })
}

/// An image file, with its last row first if it is flipped, as browsers upload it.
fn still(path: &Path, is_flipped: bool) -> Result<Image, String> {
    let shown = path.strip_prefix(".").unwrap_or(path).display();
    let bytes = fs::read(path).map_err(|e| format!("cannot read {shown}: {e}"))?;
    let decoded = decode(&bytes).map_err(|e| format!("cannot read {shown}: {e}"))?;
    let width = decoded.size[0].max(1) as usize;
    let colors = match is_flipped {
        true => decoded
            .colors
            .chunks(width)
            .rev()
            .flatten()
            .copied()
            .collect(),
        false => decoded.colors,
    };
    let [width, height] = decoded.size;
    let image = Image::new(ImageShape::Flat, [width, height, 1], Texels::Unorm8(colors));
    image.map_err(|_| format!("{shown}: texture size {width}x{height} is not supported"))
}

/// The output of a pass of the project in a folder.
fn buffer(folder: &Path, pass: &str, frame: u32) -> Result<Image, String> {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let loaded = read(folder, None, &[]).map_err(|why| match why {
        Undrawable::Errors(_) => format!("the project in {} has errors", folder.display()),
        Undrawable::Words(words) => words,
    })?;
    let setting = ShotSetting {
        size: SIZE,
        threads: 1,
        pass: Some(pass),
        show: None,
        uniforms: None,
        watch: Watch::Nothing,
        trace: false,
        rays: ObservedRays::Nothing,
        decode: Some(decode),
    };
    let mut ready = shot(&loaded.shader, &setting)?;
    let drawn = ready.drawn(&Moment::of_frame(frame), &mut |_| {})?;
    let rendered = RenderedImage::of(ready.code(), &drawn, 0);
    let [width, height] = rendered.size;
    let image = Image::new(
        ImageShape::Flat,
        [width, height, 1],
        Texels::Float(rendered.pixels),
    );
    image.map_err(|_| "the size of the buffer is not supported".to_string())
}
