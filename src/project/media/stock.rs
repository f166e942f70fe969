//! ShaderToy's media files: ids, names and sizes, and their stand-ins.
//!
//! Ids and paths are from public exports, titles from ShaderToy's own list, sizes from
//! ShaderBridge, a converter to ReShade.

use super::{Generator, StandIn};
use crate::{Input, InputKind};

/// A media file of ShaderToy.
pub(super) struct Stock {
    kind: InputKind,
    id: &'static str,
    /// Prefix of its name in `/media/a/`.
    hash: &'static str,
    /// The name in `/presets/`, its former folder.
    preset: &'static str,
    pub(super) stand_in: StandIn,
}

impl Stock {
    /// Whether an input refers to this file, by id or path.
    fn is_of(&self, input: &Input) -> bool {
        let name = input.src.rsplit('/').next().unwrap_or("");
        let after = name.strip_prefix(self.preset);
        let is_preset = input.src.starts_with("/presets/")
            && after.is_some_and(|rest| rest.starts_with(['.', '_']));
        self.kind == input.kind && (input.id == self.id || name.starts_with(self.hash) || is_preset)
    }
}

/// The file that an input refers to.
pub(super) fn find(input: &Input) -> Option<&'static Stock> {
    STOCK.iter().find(|file| file.is_of(input))
}

const fn file(
    kind: InputKind,
    [id, hash, preset]: [&'static str; 3],
    title: &'static str,
    generator: Generator,
    size: [u32; 3],
) -> Stock {
    let stand_in = StandIn {
        title,
        size,
        is_gray: false,
        generator,
    };
    Stock {
        kind,
        id,
        hash,
        preset,
        stand_in,
    }
}

/// A file of which the player keeps only one component.
const fn gray(mut file: Stock) -> Stock {
    file.stand_in.is_gray = true;
    file
}

const fn square(side: u32) -> [u32; 3] {
    [side, side, 1]
}

#[rustfmt::skip]
static STOCK: [Stock; 30] = {
    use InputKind::{Cubemap, Texture, Volume};
    [
        file(Texture, ["XdX3Rn", "52d2a8f514c4", "tex07"], "Abstract 1", ABSTRACT_1, square(1024)),
        file(Texture, ["4dX3Rn", "bd6464771e47", "tex08"], "Abstract 2", ABSTRACT_2, square(512)),
        file(Texture, ["XdXGzr", "8979352a182b", "tex20"], "Abstract 3", ABSTRACT_3, square(1024)),
        gray(file(Texture, ["Xdf3zn", "85a6d68622b3", "tex15"], "Bayer", BAYER, square(8))),
        file(Texture, ["XsBSR3", "cb49c003b454", "tex22"], "Blue Noise", BLUE_NOISE, square(1024)),
        file(Texture, ["4dXGzr", "08b42b43ae9d", "tex21"], "Font 1", FONT, square(1024)),
        gray(file(Texture, ["4dXGzn", "0c7bf5fe9462", "tex12"], "Gray Noise Medium", NOISE, square(256))),
        gray(file(Texture, ["4sf3Rn", "0a40562379b6", "tex10"], "Gray Noise Small", NOISE, square(64))),
        file(Texture, ["4sfGRn", "fb918796edc3", "tex06"], "Lichen", LICHEN, square(1024)),
        file(Texture, ["4dfGRn", "8de3a3924cb9", "tex04"], "London", LONDON, square(512)),
        file(Texture, ["Xsf3Rn", "cbcbb5a6cfb5", "tex14"], "Nyancat", NYANCAT, [256, 32, 1]),
        file(Texture, ["XsXGRn", "cd4c518bc6ef", "tex01"], "Organic 1", ORGANIC_1, square(1024)),
        file(Texture, ["XsX3Rn", "92d7758c402f", "tex09"], "Organic 2", ORGANIC_2, square(1024)),
        file(Texture, ["Xsf3Rr", "79520a3d3a0f", "tex18"], "Organic 3", ORGANIC_3, square(1024)),
        file(Texture, ["4df3Rr", "3871e838723d", "tex17"], "Organic 4", ORGANIC_4, square(1024)),
        gray(file(Texture, ["4sf3Rr", "ad56fba948df", "tex19"], "Pebbles", PEBBLES, square(512))),
        file(Texture, ["Xsf3zn", "f735bee5b64e", "tex16"], "RGBA Noise Medium", NOISE, square(256)),
        file(Texture, ["XdXGzn", "3083c722c0c7", "tex11"], "RGBA Noise Small", NOISE, square(64)),
        file(Texture, ["4dXGRn", "10eb4fe0ac8a", "tex00"], "Rock Tiles", ROCK_TILES, square(512)),
        file(Texture, ["4sXGRn", "95b90082f799", "tex02"], "Rusty Metal", RUSTY_METAL, square(512)),
        file(Texture, ["XdfGRn", "e6e5631ce123", "tex03"], "Stars", STARS, square(512)),
        file(Texture, ["XsfGRn", "1f7dca9c22f3", "tex05"], "Wood", WOOD, square(1024)),
        file(Cubemap, ["XsfGzn", "585f9546c092", "cube00"], "Uffizi Gallery", GALLERY, square(512)),
        file(Cubemap, ["4sfGzn", "793a105653fb", "cube01"], "Uffizi Gallery Blurred", GALLERY_BLURRED, square(64)),
        file(Cubemap, ["XdX3zn", "488bd40303a2", "cube02"], "St. Peter's Basilica", BASILICA, square(256)),
        file(Cubemap, ["4dX3zn", "550a8cce1bf4", "cube03"], "St. Peter's Basilica Blurred", BASILICA_BLURRED, square(64)),
        file(Cubemap, ["XsX3zn", "94284d43be78", "cube04"], "Forest", FOREST, square(256)),
        file(Cubemap, ["4sX3zn", "0681c014f6c8", "cube05"], "Forest Blurred", FOREST_BLURRED, square(64)),
        gray(file(Volume, ["4sfGRr", "27012b4eadd0", "vol00"], "Grey Noise3D", NOISE_VOLUME, [32; 3])),
        file(Volume, ["XdX3Rr", "aea6b99da1d5", "vol01"], "RGBA Noise3D", NOISE_VOLUME, [32; 3]),
    ]
};

/// The stand-in for what a host shows on its screen.
pub(super) fn of_screen() -> StandIn {
    StandIn {
        title: "",
        size: [1024, 1024, 1],
        is_gray: false,
        generator: SCREEN,
    }
}

/// The stand-in for an unknown file, by kind.
pub(super) fn of_kind(kind: InputKind) -> Option<StandIn> {
    let (generator, size) = match kind {
        InputKind::Texture => (PHOTO, square(512)),
        InputKind::Cubemap => (SKY, square(256)),
        InputKind::Volume => (NOISE_VOLUME, [32; 3]),
        // ShaderToy's videos have about this size.
        InputKind::Video => (FILM, [512, 396, 1]),
        // 16 seconds at 44,100 samples per second.
        InputKind::Music | InputKind::MusicStream => (MUSIC, [1050, 672, 1]),
        _ => return None,
    };
    Some(StandIn {
        title: "",
        size,
        is_gray: kind == InputKind::Volume,
        generator,
    })
}

/// The code that all generators of a kind start with.
macro_rules! frame {
    ("cube") => {
        concat!(
            include_str!("frame/faces.glsl"),
            include_str!("frame/cube.glsl")
        )
    };
    ("blurred") => {
        concat!(
            include_str!("frame/faces.glsl"),
            include_str!("frame/blurred.glsl")
        )
    };
    ($name:literal) => {
        include_str!(concat!("frame/", $name, ".glsl"))
    };
}

macro_rules! generators {
    ($($constant:ident: $name:literal, $frame:tt, [$($part:literal),*];)*) => {
        $(const $constant: Generator = Generator {
            name: $name,
            parts: &[frame!($frame), $(include_str!(concat!($part, ".glsl"))),*],
        };)*
    };
}

generators! {
    ABSTRACT_1: "abstract_1", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "textures/abstract_1"];
    ABSTRACT_2: "abstract_2", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "textures/abstract_2"];
    ABSTRACT_3: "abstract_3", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "textures/abstract_3"];
    BAYER: "bayer", "flat", ["textures/bayer"];
    BLUE_NOISE: "blue_noise", "flat", ["lib/hash", "textures/blue_noise"];
    FONT: "font", "flat", ["textures/font"];
    NOISE: "noise", "flat", ["lib/hash", "textures/noise"];
    LICHEN: "lichen", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/lichen"];
    LONDON: "london", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "textures/london"];
    NYANCAT: "nyancat", "flat", ["textures/nyancat"];
    ORGANIC_1: "organic_1", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/organic_1"];
    ORGANIC_2: "organic_2", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/organic_2"];
    ORGANIC_3: "organic_3", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/organic_3"];
    ORGANIC_4: "organic_4", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/organic_4"];
    PEBBLES: "pebbles", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/pebbles"];
    PHOTO: "picture", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "textures/picture"];
    ROCK_TILES: "rock_tiles", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "textures/rock_tiles"];
    RUSTY_METAL: "rusty_metal", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "textures/rusty_metal"];
    STARS: "stars", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "lib/warp", "lib/cells", "textures/stars"];
    WOOD: "wood", "flat", ["lib/hash", "lib/tile", "lib/noise", "lib/fbm", "textures/wood"];
    GALLERY: "gallery", "cube", ["cubemaps/gallery"];
    GALLERY_BLURRED: "gallery_blurred", "blurred", ["cubemaps/gallery"];
    BASILICA: "basilica", "cube", ["cubemaps/basilica"];
    BASILICA_BLURRED: "basilica_blurred", "blurred", ["cubemaps/basilica"];
    FOREST: "forest", "cube", ["lib/hash", "cubemaps/forest"];
    FOREST_BLURRED: "forest_blurred", "blurred", ["lib/hash", "cubemaps/forest"];
    SCREEN: "screen", "flat", ["textures/screen_glyphs", "textures/font", "textures/screen"];
    SKY: "sky", "cube", ["cubemaps/sky"];
    NOISE_VOLUME: "noise_volume", "volume", ["lib/hash", "noise_volume"];
    FILM: "film", "film", ["film"];
    MUSIC: "music", "sound", ["lib/hash", "music"];
}
