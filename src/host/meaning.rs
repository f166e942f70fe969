//! What a host sets a name to: a comment behind the declaration, `uniform float time; // = time`.
//!
//! Behind the `=` comes what it is given, and then, between commas, how a texture is read (`mipmap`,
//! `repeat`), further types (`or vec3 ivec2`), `numbered` where the number in the name may be any
//! other, and how much the name shows that a shader is this host's (`usual`, `own`).

use super::near::none_of;
use serde::Serialize;
use std::collections::BTreeMap;

macro_rules! feeds {
    ($($variant:ident $name:literal $says:literal,)*) => {
        /// What a uniform is given. The player knows how to get each (`player/program.js`).
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
        #[serde(rename_all = "camelCase")]
        pub enum Feed {
            $(#[doc = $says] $variant,)*
        }

        impl Feed {
            /// All of them.
            pub const ALL: &[Feed] = &[$(Feed::$variant),*];

            /// How a host's file calls it.
            pub fn name(self) -> &'static str {
                match self { $(Feed::$variant => $name,)* }
            }

            /// What it is, in words.
            pub fn says(self) -> &'static str {
                match self { $(Feed::$variant => $says,)* }
            }
        }
    };
}

feeds! {
    Time "time" "seconds since the start",
    Milliseconds "milliseconds" "milliseconds since the start",
    Delta "delta" "seconds since the frame before",
    Frame "frame" "number of the frame, from 0",
    FrameFromOne "frame-from-one" "number of the frame, from 1",
    FrameRate "frame-rate" "frames per second",
    SampleRate "sample-rate" "samples of sound per second",
    ChannelTime "channel-time" "seconds that the sound or video of each channel has played",
    ChannelResolution "channel-resolution" "width, height and depth of the texture of each channel",
    Date "date" "year, month from 0, day, seconds since midnight",
    DateFromOne "date-from-one" "year, month from 1, day, seconds since midnight",
    Resolution "resolution" "width and height in pixels, then the ratio of a pixel's sides",
    ResolutionAndPixel "resolution-and-pixel" "width and height in pixels, then the size of a pixel in the image",
    Pixel "pixel" "size of a pixel in the image",
    TextureSize "texture-size" "width and height of the texture that the name speaks of",
    Aspect "aspect" "width divided by height",
    PixelRatio "pixel-ratio" "pixels of the device in one of the page",
    SurfaceSize "surface-size" "width of what is seen where its height is 1",
    Mouse "mouse" "as `iMouse`: where the mouse was dragged to, then where the button was pressed",
    Pointer "pointer" "position of the mouse in pixels from below, then whether its button is down",
    PointerUnit "pointer-unit" "position of the mouse, from 0 to 1 from below, in the middle at first",
    PointerUnitDown "pointer-unit-down" "position of the mouse, from 0 to 1 from above, in the middle at first",
    PointerUnitZero "pointer-unit-zero" "position of the mouse, from 0 to 1 from below, in the corner at first",
    PointerSigned "pointer-signed" "position of the mouse, from -1 to 1 from below",
    Button "button" "whether the mouse's button is down",
    Spectrum "spectrum" "how loud low, middle and high sounds are",
    Volume "volume" "how loud the sound is",
    HistorySize "history-size" "width and height of the texture with the spectra of the last frames",
    Camera "camera" "position of a camera that looks at the image: (0, 0, 1)",
    Identity "identity" "a matrix that changes nothing",
    Control "control" "what the user sets",
    Nothing "nothing" "zeros",
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
    /// What the buffer of this name draws.
    Buffer,
    /// What the pass has on its channel of this number.
    Channel,
}

/// What a sampler reads, by the word for it in a host's file, and what that is.
const TEXTURES: [(&str, TextureFeed, &str); 6] = [
    ("file", TextureFeed::File, "a file that the user gives"),
    ("last-frame", TextureFeed::LastFrame, "the frame before"),
    ("music", TextureFeed::Music, "spectrum and wave of music"),
    (
        "music-sum",
        TextureFeed::MusicSum,
        "the sum of the spectra since the start",
    ),
    (
        "buffer",
        TextureFeed::Buffer,
        "what the buffer of this name draws",
    ),
    (
        "channel",
        TextureFeed::Channel,
        "what the channel of this number holds",
    ),
];

impl TextureFeed {
    /// What it is, in words.
    pub fn says(self) -> &'static str {
        let row = TEXTURES.iter().find(|(_, feed, _)| *feed == self);
        row.map_or("", |(.., says)| says)
    }
}

/// A name that shows nothing.
pub const COMMON: u8 = 0;
/// A name that others use, too: two of them are evidence.
pub const USUAL: u8 = 1;
/// A name that hardly another host has.
pub const OWN: u8 = 3;

/// What a uniform of a name and one of some types means.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FeedRow {
    /// The name; a `#` in it stands for a number.
    pub name: String,
    /// The types that it may have.
    pub types: Vec<String>,
    /// What it is given.
    pub feed: Feed,
    /// How much it shows of the host.
    pub weight: u8,
    /// Whether the host declares it.
    pub is_declared: bool,
}

/// What a sampler of a name reads, and how.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextureRow {
    /// The name; a `#` in it stands for a number.
    pub name: String,
    /// What it reads.
    pub texture: TextureFeed,
    /// `nearest`, `linear` or `mipmap`.
    pub filter: &'static str,
    /// `clamp` or `repeat`.
    pub wrap: &'static str,
    /// How much it shows of the host.
    pub weight: u8,
    /// Whether the host declares it.
    pub is_declared: bool,
}

/// What a varying holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct VaryingRow {
    /// The name; of a varying that is a struct, that of a member.
    pub name: String,
    /// Its type.
    pub ty: String,
    /// Its value, as GLSL of the vertex shader: `port_place` is from 0 to 1, `port_pos` from -1 to 1,
    /// and `port_size` the size of the picture in pixels.
    pub value: String,
    /// How much it shows of the host.
    pub weight: u8,
    /// Whether the host declares it.
    pub is_declared: bool,
}

/// What the names that a host sets mean.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Meanings {
    /// What its uniforms are given.
    pub feeds: Vec<FeedRow>,
    /// What its samplers read.
    pub textures: Vec<TextureRow>,
    /// What its varyings hold.
    pub varyings: Vec<VaryingRow>,
}

/// Whether a name is that of a row, whose `#` stands for a number.
pub fn is_named(row: &str, name: &str) -> bool {
    let Some((before, behind)) = row.split_once('#') else {
        return row == name;
    };
    let number = name
        .strip_prefix(before)
        .and_then(|n| n.strip_suffix(behind));
    number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// A declaration with a comment behind it.
struct HostDeclaration<'t> {
    /// `uniform`, `varying` or `in`.
    qualifier: &'t str,
    /// With an array's size.
    ty: String,
    name: &'t str,
}

impl Meanings {
    /// Adds those of the host that this one builds on: they show that one alone.
    pub(super) fn inherit(&mut self, base: &Meanings) {
        let feeds = base.feeds.iter().cloned();
        self.feeds.extend(feeds.map(|row| FeedRow {
            weight: COMMON,
            ..row
        }));
        let textures = base.textures.iter().cloned();
        self.textures.extend(textures.map(|row| TextureRow {
            weight: COMMON,
            ..row
        }));
        let varyings = base.varyings.iter().cloned();
        self.varyings.extend(varyings.map(|row| VaryingRow {
            weight: COMMON,
            ..row
        }));
    }

    /// The names, what they are given, and who declares them, in Markdown.
    pub(super) fn page(&self, said: &BTreeMap<String, String>) -> String {
        let says = |name: &str, short: String| said.get(name).cloned().unwrap_or(short);
        let who = |is_declared| match is_declared {
            true => "the host",
            false => "the shader",
        };
        let feeds = self.feeds.iter().map(|r| {
            let types = r.types.join("`, `");
            (
                &r.name,
                types,
                says(&r.name, r.feed.says().to_string()),
                r.is_declared,
            )
        });
        let textures = self.textures.iter().map(|r| {
            let short = format!("{} ({}, {})", r.texture.says(), r.filter, r.wrap);
            let says = says(&r.name, short);
            (&r.name, "sampler2D".to_string(), says, r.is_declared)
        });
        let varyings = self.varyings.iter().map(|r| {
            let says = format!("`{}`", r.value);
            (&r.name, r.ty.clone(), says, r.is_declared)
        });
        let rows = feeds.chain(textures).chain(varyings);
        let rows = rows.map(|(name, ty, says, is_declared)| {
            let name = name.replace('#', "N");
            format!("| `{name}` | `{ty}` | {says} | {} |\n", who(is_declared))
        });
        let rows: String = rows.collect();
        match rows.is_empty() {
            true => rows,
            false => format!(
                "\nWhat it sets, and `shaderport` and sample runs set in its place:\n\n\
                 | name | type | value | declared by |\n|---|---|---|---|\n{rows}"
            ),
        }
    }

    /// Whether the host itself declares a name that it sets.
    pub fn has_declared(&self) -> bool {
        self.feeds.iter().any(|r| r.is_declared)
            || self.textures.iter().any(|r| r.is_declared)
            || self.varyings.iter().any(|r| r.is_declared)
    }

    /// What is said of a name, in words.
    pub fn says(&self, name: &str) -> Option<&'static str> {
        let feeds = self.feeds.iter().filter(|r| is_named(&r.name, name));
        let textures = self.textures.iter().filter(|r| is_named(&r.name, name));
        let mut all = feeds
            .map(|r| r.feed.says())
            .chain(textures.map(|r| r.texture.says()));
        all.next()
    }

    /// Reads a line that declares something, with what it means, if it tells that.
    pub(super) fn read(&mut self, line: &str, is_declared: bool) -> Result<(), String> {
        let Some((code, meaning)) = line.split_once("// =") else {
            return Ok(());
        };
        let Some(declared) = HostDeclaration::of(code) else {
            let what =
                "only a uniform or a varying, one in a line, can be given something by `// =`";
            return Err(what.to_string());
        };
        let (value, weight) = weighted(meaning.trim());
        if declared.qualifier != "uniform" {
            self.varyings.push(VaryingRow {
                name: declared.name.to_string(),
                ty: declared.ty,
                value: value.to_string(),
                weight,
                is_declared,
            });
            return Ok(());
        }
        let mut words = value.split(',').map(str::trim);
        let given = words.next().unwrap_or("");
        match declared.ty.contains("sampler") {
            true => self.texture(&declared, given, words, (weight, is_declared)),
            false => self.feed(declared, given, words, (weight, is_declared)),
        }
    }

    fn feed<'w>(
        &mut self,
        declared: HostDeclaration,
        given: &str,
        words: impl Iterator<Item = &'w str>,
        (weight, is_declared): (u8, bool),
    ) -> Result<(), String> {
        let feed = Feed::ALL.iter().copied().find(|f| f.name() == given);
        let Some(feed) = feed else {
            let names: Vec<&str> = Feed::ALL.iter().map(|f| f.name()).collect();
            return Err(none_of(given, &names));
        };
        let mut row = FeedRow {
            name: declared.name.to_string(),
            types: vec![declared.ty],
            feed,
            weight,
            is_declared,
        };
        for word in words {
            match word.strip_prefix("or ") {
                Some(types) => row
                    .types
                    .extend(types.split_whitespace().map(str::to_string)),
                None if word == "numbered" => row.name = numbered(declared.name)?,
                None => {
                    return Err(none_of(word, &["or TYPE", "numbered", "usual", "own"]));
                }
            }
        }
        self.feeds.push(row);
        Ok(())
    }

    fn texture<'w>(
        &mut self,
        declared: &HostDeclaration,
        given: &str,
        words: impl Iterator<Item = &'w str>,
        (weight, is_declared): (u8, bool),
    ) -> Result<(), String> {
        let Some((_, texture, _)) = TEXTURES.iter().find(|(name, ..)| *name == given) else {
            return Err(none_of(given, &TEXTURES.map(|(name, ..)| name)));
        };
        let mut row = TextureRow {
            name: declared.name.to_string(),
            texture: *texture,
            filter: "linear",
            wrap: "clamp",
            weight,
            is_declared,
        };
        const FILTERS: [&str; 3] = ["nearest", "linear", "mipmap"];
        const WRAPS: [&str; 2] = ["clamp", "repeat"];
        for word in words {
            let filter = FILTERS.into_iter().find(|w| *w == word);
            let wrap = WRAPS.into_iter().find(|w| *w == word);
            match (filter, wrap) {
                (Some(filter), _) => row.filter = filter,
                (_, Some(wrap)) => row.wrap = wrap,
                _ if word == "numbered" => row.name = numbered(declared.name)?,
                _ => {
                    let others = ["numbered", "usual", "own"];
                    let all = [&FILTERS[..], &WRAPS[..], &others[..]].concat();
                    return Err(none_of(word, &all));
                }
            }
        }
        self.textures.push(row);
        Ok(())
    }
}

/// What a comment says, and the weight at its end.
fn weighted(meaning: &str) -> (&str, u8) {
    let (value, last) = meaning.rsplit_once(',').unwrap_or((meaning, ""));
    match last.trim() {
        "usual" => (value.trim_end(), USUAL),
        "own" => (value.trim_end(), OWN),
        _ => (meaning, COMMON),
    }
}

/// A name whose number stands for any.
fn numbered(name: &str) -> Result<String, String> {
    let start = name.find(|c: char| c.is_ascii_digit());
    let Some((before, rest)) = start.and_then(|at| name.split_at_checked(at)) else {
        return Err(format!("`{name}` is numbered, but has no number"));
    };
    let behind = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    Ok(format!("{before}#{behind}"))
}

impl<'t> HostDeclaration<'t> {
    fn of(code: &'t str) -> Option<HostDeclaration<'t>> {
        let (declaration, rest) = code.split_once(';')?;
        if !rest.trim().is_empty() || declaration.contains(',') {
            return None;
        }
        let precise = ["lowp", "mediump", "highp", "flat"];
        let mut words = declaration
            .split_whitespace()
            .filter(|w| !precise.contains(w));
        let qualifier = words
            .next()
            .filter(|w| ["uniform", "varying", "in"].contains(w))?;
        let (ty, name) = (words.next()?, words.next()?);
        let (name, size) = match name.split_once('[') {
            Some((name, _)) => (name, name_size(declaration)?),
            None => (name, ""),
        };
        words.next().is_none().then(|| HostDeclaration {
            qualifier,
            ty: format!("{ty}{size}"),
            name,
        })
    }
}

/// The size of an array, in its brackets.
fn name_size(declaration: &str) -> Option<&str> {
    let at = declaration.find('[')?;
    declaration.get(at..).map(str::trim_end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn wrong(line: &str, expected: &str) {
        let error = Meanings::default().read(line, true).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }

    #[test]
    fn comments_say_what_names_are_given() {
        let mut all = Meanings::default();
        for line in [
            "uniform highp vec2 size; // = resolution, or vec3 ivec2, usual",
            "uniform vec2 u_tex0Resolution; // = texture-size, numbered",
            "uniform sampler2D noise; // = file, mipmap, repeat, own",
            "varying vec2 surface; // = port_pos * vec2(port_size.x / port_size.y, 1.0), own",
            "uniform vec2 trails[10]; // = nothing",
            "uniform float plain;",
        ] {
            all.read(line, true).unwrap();
        }
        let row = &all.feeds[0];
        assert_eq!((row.name.as_str(), row.weight), ("size", USUAL));
        assert_eq!(row.types, ["vec2", "vec3", "ivec2"]);
        assert!(is_named(&all.feeds[1].name, "u_tex12Resolution"));
        assert_eq!(all.feeds[2].types, ["vec2[10]"]);
        let texture = &all.textures[0];
        assert_eq!((texture.filter, texture.wrap), ("mipmap", "repeat"));
        let varying = &all.varyings[0];
        assert_eq!(
            varying.value,
            "port_pos * vec2(port_size.x / port_size.y, 1.0)"
        );
        assert_eq!(all.says("size"), Some(Feed::Resolution.says()));
        assert_eq!(all.says("plain"), None);
    }

    #[test]
    fn what_cannot_be_read_is_said() {
        wrong("uniform float t; // = tmie", "did you mean `time`?");
        wrong("uniform float t; // = time, ofen", "`ofen` is none of");
        wrong("uniform sampler2D t; // = files", "did you mean `file`?");
        wrong("uniform float t; // = time, numbered", "has no number");
        wrong("uniform float a, b; // = time", "one in a line");
        wrong("#define A 1 // = time", "only a uniform or a varying");
    }
}
