//! What uniforms, samplers and varyings of a dialect mean, as rows of tables.

use serde::Serialize;

/// What a uniform is given. The player knows how to get each (`player/program.js`).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum Feed {
    /// Seconds since the start.
    Time,
    /// Milliseconds since the start.
    Milliseconds,
    /// Seconds since the frame before.
    Delta,
    /// Number of the frame, from 0.
    Frame,
    /// Number of the frame, from 1.
    FrameFromOne,
    /// Frames a second.
    FrameRate,
    /// Samples of sound a second.
    SampleRate,
    /// Year, month from 0, day, seconds since midnight.
    Date,
    /// Year, month from 1, day, seconds since midnight.
    DateFromOne,
    /// Width and height in pixels, then the ratio of a pixel's sides.
    Resolution,
    /// Width and height in pixels, then what a pixel measures in the picture.
    ResolutionAndPixel,
    /// What a pixel measures in the picture.
    Pixel,
    /// Width and height of the texture that [`UniformData::of`](super::UniformData) names.
    TextureSize,
    /// Width by height.
    Aspect,
    /// Pixels of the device in one of the page.
    PixelRatio,
    /// The width of what is seen where it is one high.
    SurfaceSize,
    /// `iMouse`: where the button was pressed, where the mouse was dragged to.
    Mouse,
    /// Where the mouse is, in pixels from below; then whether its button is down.
    Pointer,
    /// Where the mouse is, from 0 to 1 from below, in the middle at first.
    PointerUnit,
    /// Where the mouse is, from 0 to 1 from above, in the middle at first.
    PointerUnitDown,
    /// Where the mouse is, from 0 to 1 from below, in the corner at first.
    PointerUnitZero,
    /// Where the mouse is, from -1 to 1 from below.
    PointerSigned,
    /// Whether the mouse's button is down.
    Button,
    /// How loud low, middle and high sounds are.
    Spectrum,
    /// How loud the sound is.
    Volume,
    /// Width and height of the texture that holds the spectra of the last frames.
    HistorySize,
    /// The place of a camera that looks at the picture: (0, 0, 1).
    Camera,
    /// A matrix that changes nothing.
    Identity,
    /// What the user sets.
    Control,
    /// Nothing: zeros.
    Nothing,
}

/// What a uniform of a name and one of some types means.
#[derive(Clone, Copy, Debug)]
pub struct FeedRow {
    /// The name; a `#` in it stands for a number.
    pub name: &'static str,
    /// The types that it may have.
    pub types: &'static [&'static str],
    /// What it is given.
    pub feed: Feed,
    /// How much it tells of the dialect.
    pub weight: u8,
}

/// A name that tells nothing.
pub const COMMON: u8 = 0;
/// A name that others use, too: two of them are evidence.
pub const USUAL: u8 = 1;
/// A name that hardly another dialect has.
pub const OWN: u8 = 3;

pub(super) const fn feed(
    name: &'static str,
    types: &'static [&'static str],
    feed: Feed,
    weight: u8,
) -> FeedRow {
    FeedRow {
        name,
        types,
        feed,
        weight,
    }
}

/// What a sampler reads.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextureFeed {
    /// A file that the user has to give.
    File,
    /// The picture as it was a frame ago.
    LastFrame,
    /// Spectrum and wave of music.
    Music,
    /// The sum of the spectra from the start.
    MusicSum,
    /// What the buffer of this number draws, or that of the number in the name.
    Buffer,
}

/// What a sampler of a name reads, and how.
#[derive(Clone, Copy, Debug)]
pub struct TextureRow {
    /// The name; a `#` in it stands for a number.
    pub name: &'static str,
    /// What it reads.
    pub texture: TextureFeed,
    /// `nearest`, `linear` or `mipmap`.
    pub filter: &'static str,
    /// `clamp` or `repeat`.
    pub wrap: &'static str,
    /// How much it tells of the dialect.
    pub weight: u8,
}

pub(super) const fn texture(
    name: &'static str,
    texture: TextureFeed,
    filter: &'static str,
    wrap: &'static str,
    weight: u8,
) -> TextureRow {
    TextureRow {
        name,
        texture,
        filter,
        wrap,
        weight,
    }
}

/// What a varying holds.
#[derive(Clone, Copy, Debug)]
pub struct VaryingRow {
    /// The name; of a varying that is a struct, that of a member.
    pub name: &'static str,
    /// Its type.
    pub ty: &'static str,
    /// Its value, as GLSL of the vertex shader: `port_place` is from 0 to 1, `port_pos` from -1 to 1,
    /// and `port_size` the size of the picture in pixels.
    pub value: &'static str,
    /// How much it tells of the dialect.
    pub weight: u8,
}

pub(super) const fn varying(
    name: &'static str,
    ty: &'static str,
    value: &'static str,
    weight: u8,
) -> VaryingRow {
    VaryingRow {
        name,
        ty,
        value,
        weight,
    }
}

/// Whether a name is that of a row, whose `#` stands for a number.
pub(super) fn is_named(row: &str, name: &str) -> bool {
    let Some((before, behind)) = row.split_once('#') else {
        return row == name;
    };
    let number = name
        .strip_prefix(before)
        .and_then(|n| n.strip_suffix(behind));
    number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// Names of varyings that are taken for the place in the picture, from 0 to 1.
pub const PLACES: [&str; 9] = [
    "vUv",
    "vUV",
    "v_uv",
    "uv",
    "vTexCoord",
    "v_texCoord",
    "v_texcoord",
    "texCoord",
    "texcoord",
];

const SIZE: &[&str] = &["vec2", "vec3", "ivec2"];
const PLACE: &[&str] = &["vec2", "vec3", "vec4"];
const NUMBER: &[&str] = &["float"];
const COUNT: &[&str] = &["int", "uint", "float"];

/// What uniforms mean whatever the dialect: ShaderToy's own names, and those that are usual.
pub(super) const USUAL_FEEDS: &[FeedRow] = &[
    feed("iResolution", SIZE, Feed::Resolution, COMMON),
    feed("iTime", NUMBER, Feed::Time, COMMON),
    feed("iGlobalTime", NUMBER, Feed::Time, COMMON),
    feed("iTimeDelta", NUMBER, Feed::Delta, COMMON),
    feed("iFrame", COUNT, Feed::Frame, COMMON),
    feed("iFrameRate", COUNT, Feed::FrameRate, COMMON),
    feed("iSampleRate", COUNT, Feed::SampleRate, COMMON),
    feed("iMouse", PLACE, Feed::Mouse, COMMON),
    feed("iDate", &["vec4"], Feed::Date, COMMON),
    feed("resolution", SIZE, Feed::Resolution, COMMON),
    feed("u_resolution", SIZE, Feed::Resolution, COMMON),
    feed("uResolution", SIZE, Feed::Resolution, COMMON),
    feed("screenSize", SIZE, Feed::Resolution, COMMON),
    feed("iResolution", &["vec4"], Feed::ResolutionAndPixel, COMMON),
    feed("resolution", &["vec4"], Feed::ResolutionAndPixel, COMMON),
    feed("u_resolution", &["vec4"], Feed::ResolutionAndPixel, COMMON),
    feed("uResolution", &["vec4"], Feed::ResolutionAndPixel, COMMON),
    feed("aspect", NUMBER, Feed::Aspect, COMMON),
    feed("u_aspect", NUMBER, Feed::Aspect, COMMON),
    feed("uAspect", NUMBER, Feed::Aspect, COMMON),
    feed("aspectRatio", NUMBER, Feed::Aspect, COMMON),
    feed("uPixelRatio", NUMBER, Feed::PixelRatio, COMMON),
    feed("u_pixelRatio", NUMBER, Feed::PixelRatio, COMMON),
    feed("time", NUMBER, Feed::Time, COMMON),
    feed("u_time", NUMBER, Feed::Time, COMMON),
    feed("uTime", NUMBER, Feed::Time, COMMON),
    feed("u_Time", NUMBER, Feed::Time, COMMON),
    feed("globalTime", NUMBER, Feed::Time, COMMON),
    feed("delta", NUMBER, Feed::Delta, COMMON),
    feed("deltaTime", NUMBER, Feed::Delta, COMMON),
    feed("u_delta", NUMBER, Feed::Delta, COMMON),
    feed("u_deltaTime", NUMBER, Feed::Delta, COMMON),
    feed("uDelta", NUMBER, Feed::Delta, COMMON),
    feed("frame", COUNT, Feed::Frame, COMMON),
    feed("u_frame", COUNT, Feed::Frame, COMMON),
    feed("uFrame", COUNT, Feed::Frame, COMMON),
    feed("date", &["vec4"], Feed::Date, COMMON),
    feed("u_date", &["vec4"], Feed::Date, COMMON),
    feed("mouse", PLACE, Feed::PointerUnit, COMMON),
    feed("u_mouse", PLACE, Feed::Pointer, COMMON),
    feed("uMouse", PLACE, Feed::PointerUnit, COMMON),
];

/// What samplers read whatever the dialect.
pub(super) const USUAL_TEXTURES: &[TextureRow] = &[
    texture(
        "backbuffer",
        TextureFeed::LastFrame,
        "linear",
        "clamp",
        COMMON,
    ),
    texture(
        "u_backbuffer",
        TextureFeed::LastFrame,
        "linear",
        "clamp",
        COMMON,
    ),
    texture(
        "prevFrame",
        TextureFeed::LastFrame,
        "linear",
        "clamp",
        COMMON,
    ),
    texture(
        "previousFrame",
        TextureFeed::LastFrame,
        "linear",
        "clamp",
        COMMON,
    ),
];

/// What varyings hold whatever the dialect. Others are told by their names and types.
pub(super) const USUAL_VARYINGS: &[VaryingRow] = &[varying(
    "vViewPosition",
    "vec3",
    "vec3(-port_pos, 1.0)",
    COMMON,
)];
