//! The values that a host sets, from comments after declarations: `uniform float time; // = time`.
//!
//! The value follows the `=`. Options follow after commas: how a texture is sampled (`mipmap`,
//! `repeat`), further types (`or vec3 ivec2`), `numbered` if the number in the name may be any
//! other, `ending` if names that end in it mean the same, and how strongly the name indicates this host (`usual`, `own`).

use super::near::none_of;
use serde::Serialize;
use std::collections::BTreeMap;

macro_rules! feeds {
    ($(#[$doc:meta])* $feeds:ident: $($variant:ident $name:literal $description:literal,)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
        #[serde(rename_all = "camelCase")]
        pub enum $feeds {
            $(#[doc = $description] $variant,)*
        }

        impl $feeds {
            /// All variants.
            pub const ALL: &[$feeds] = &[$($feeds::$variant),*];

            /// The name in host files.
            pub fn name(self) -> &'static str {
                match self { $($feeds::$variant => $name,)* }
            }

            /// A description of the value.
            pub fn description(self) -> &'static str {
                match self { $($feeds::$variant => $description,)* }
            }

            /// The variant with a name in host files.
            pub(super) fn named(name: &str) -> Result<$feeds, String> {
                let found = $feeds::ALL.iter().copied().find(|feed| feed.name() == name);
                found.ok_or_else(|| {
                    let names: Vec<&str> = $feeds::ALL.iter().map(|feed| feed.name()).collect();
                    none_of(name, &names)
                })
            }
        }
    };
}

feeds! {
    /// The value of a uniform. The player implements each (`player/program.js`).
    Feed:
    Time "time" "seconds since the start",
    Milliseconds "milliseconds" "milliseconds since the start",
    Delta "delta" "seconds since the previous frame",
    Frame "frame" "frame number, from 0",
    FrameFromOne "frame-from-one" "frame number, from 1",
    FrameRate "frame-rate" "frames per second",
    SampleRate "sample-rate" "audio samples per second",
    ChannelTime "channel-time" "playback position of the sound or video of each channel, in seconds",
    ChannelResolution "channel-resolution" "width, height and depth of the texture of each channel",
    Date "date" "year, month from 0, day, seconds since midnight",
    DateFromOne "date-from-one" "year, month from 1, day, seconds since midnight",
    Resolution "resolution" "width and height in pixels, then the pixel aspect ratio",
    ResolutionAndPixel "resolution-and-pixel" "width and height in pixels, then 1/width and 1/height",
    Pixel "pixel" "1/width and 1/height",
    TextureSize "texture-size" "width and height of the texture that the name refers to",
    Aspect "aspect" "width divided by height",
    PixelRatio "pixel-ratio" "device pixels per CSS pixel",
    SurfaceSize "surface-size" "width and height of the visible area, scaled to height 1",
    Mouse "mouse" "as `iMouse`: position of the last drag, then of the last click",
    Pointer "pointer" "mouse position in pixels, y up, then whether its button is down",
    PointerUnit "pointer-unit" "mouse position from 0 to 1, y up, initially in the centre",
    PointerUnitDown "pointer-unit-down" "mouse position from 0 to 1, y down, initially in the centre",
    PointerUnitZero "pointer-unit-zero" "mouse position from 0 to 1, y up, initially in the corner",
    PointerSigned "pointer-signed" "mouse position from -1 to 1, y up",
    Button "button" "whether the mouse button is down",
    Spectrum "spectrum" "levels of low, middle and high frequencies",
    Volume "volume" "loudness of the sound",
    VolumeBytes "volume-bytes" "loudness of the sound, from 0 to 255",
    HistorySize "history-size" "width and height of the texture with the most recent spectra",
    Camera "camera" "position of a camera that faces the image: (0, 0, 1)",
    Identity "identity" "identity matrix",
    Width "width" "width in pixels",
    Height "height" "height in pixels",
    Progress "progress" "progress of an animation, from 0 to 1 in a second, then 1 for half a second",
    Cursor "cursor" "a text cursor that moves every 1.5 seconds: left edge, upper edge, width and height, in pixels",
    CursorBefore "cursor-before" "the same before its last move",
    CursorTime "cursor-time" "seconds from the start to the last move of the cursor",
    CursorColor "cursor-color" "colour of the cursor: orange",
    Ones "ones" "ones",
    Control "control" "value set by the user",
    Nothing "nothing" "zeros",
}

feeds! {
    /// The input of a sampler.
    TextureFeed:
    File "file" "a file provided by the user",
    LastFrame "last-frame" "the previous frame",
    Music "music" "spectrum and waveform of music",
    MusicSum "music-sum" "sum of the spectra since the start",
    Buffer "buffer" "output of the buffer with this name",
    Channel "channel" "input of the channel with this number",
    Screen "screen" "what the host shows: a file provided by the user, or a page of text",
}

/// Weight of a name that indicates no host.
pub const COMMON: u8 = 0;
/// Weight of a name that several hosts use: two of them are sufficient evidence.
pub const USUAL: u8 = 1;
/// Weight of a name that hardly any other host uses.
pub const OWN: u8 = 3;

/// The value of a uniform with a name and one of several types.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FeedRow {
    /// The name; `#` in it stands for a number, `*` for any beginning.
    pub name: String,
    /// The accepted types.
    pub types: Vec<String>,
    /// The value.
    pub feed: Feed,
    /// How strongly it indicates the host.
    pub weight: u8,
    /// Whether the host declares it, and not the shader.
    pub is_declared: bool,
}

/// The input of a sampler with a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextureRow {
    /// The name; `#` in it stands for a number.
    pub name: String,
    /// The input.
    pub texture: TextureFeed,
    /// `nearest`, `linear` or `mipmap`.
    pub filter: &'static str,
    /// `clamp` or `repeat`.
    pub wrap: &'static str,
    /// Whether `v` is 0 at the upper edge of the image.
    pub top_first: bool,
    /// How strongly it indicates the host.
    pub weight: u8,
    /// Whether the host declares it, and not the shader.
    pub is_declared: bool,
}

/// The value of a varying.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct VaryingRow {
    /// The name; for a struct, the name of a member.
    pub name: String,
    /// The GLSL type.
    pub ty: String,
    /// The value as a GLSL expression of the vertex shader: `port_place` ranges from 0 to 1,
    /// `port_pos` from -1 to 1, and `port_size` is the size of the image in pixels.
    pub value: String,
    /// How strongly it indicates the host.
    pub weight: u8,
    /// Whether the host declares it, and not the shader.
    pub is_declared: bool,
}

/// The values of all names that a host sets.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Meanings {
    /// Values of uniforms.
    pub feeds: Vec<FeedRow>,
    /// Inputs of samplers.
    pub textures: Vec<TextureRow>,
    /// Values of varyings.
    pub varyings: Vec<VaryingRow>,
}

/// Whether only one name matches the name of a row.
pub fn is_one_name(row: &str) -> bool {
    !row.contains(['#', '*'])
}

/// Whether a name matches the name of a row, in which `#` stands for a number, and `*` for any
/// beginning: then capitals and underscores do not matter.
pub fn is_named(row: &str, name: &str) -> bool {
    if let Some(end) = row.strip_prefix('*') {
        return name.replace('_', "").to_ascii_lowercase().ends_with(end);
    }
    let Some((before, after)) = row.split_once('#') else {
        return row == name;
    };
    let number = name
        .strip_prefix(before)
        .and_then(|n| n.strip_suffix(after));
    number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// A declaration followed by a comment.
struct HostDeclaration<'t> {
    /// `uniform`, `varying` or `in`.
    qualifier: &'t str,
    /// Includes the size of an array.
    ty: String,
    name: &'t str,
}

/// The code before a `// =` comment, and what the comment says. All hosts are read for any shader with
/// a uniform of its own, and a search for one character is the fastest.
fn meaning_in(line: &str) -> Option<(&str, &str)> {
    line.match_indices('=').find_map(|(at, _)| {
        let code = line.get(..at)?.strip_suffix("// ")?;
        Some((code, line.get(at + 1..)?))
    })
}

impl Meanings {
    /// Adds the rows of the base. They are not evidence for this host.
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

    /// The table of names and values in Markdown.
    pub(super) fn page(&self, descriptions: &BTreeMap<String, String>) -> String {
        let description =
            |name: &str, short: String| descriptions.get(name).cloned().unwrap_or(short);
        let who = |is_declared| match is_declared {
            true => "the host",
            false => "the shader",
        };
        let feeds = self.feeds.iter().map(|r| {
            let types = r.types.join("`, `");
            (
                &r.name,
                types,
                description(&r.name, r.feed.description().to_string()),
                r.is_declared,
            )
        });
        let textures = self.textures.iter().map(|r| {
            let short = format!("{} ({}, {})", r.texture.description(), r.filter, r.wrap);
            let description = description(&r.name, short);
            (&r.name, "sampler2D".to_string(), description, r.is_declared)
        });
        let varyings = self.varyings.iter().map(|r| {
            let description = format!("`{}`", r.value);
            (&r.name, r.ty.clone(), description, r.is_declared)
        });
        let rows = feeds.chain(textures).chain(varyings);
        let rows = rows.map(|(name, ty, description, is_declared)| {
            let name = name.replace('#', "N");
            format!(
                "| `{name}` | `{ty}` | {description} | {} |\n",
                who(is_declared)
            )
        });
        let rows: String = rows.collect();
        match rows.is_empty() {
            true => rows,
            false => format!(
                "\n## Inputs\n\nNames that the host sets. `shaderport` and sample runs set them as well.\n\n\
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

    /// The description of a name's value.
    pub fn description(&self, name: &str) -> Option<&'static str> {
        let feeds = self.feeds.iter().filter(|r| is_named(&r.name, name));
        let textures = self.textures.iter().filter(|r| is_named(&r.name, name));
        let mut all = feeds
            .map(|r| r.feed.description())
            .chain(textures.map(|r| r.texture.description()));
        all.next()
    }

    /// Reads a line with a declaration and a `// =` comment, and returns the declaration; ignores other
    /// lines.
    pub(super) fn read<'t>(
        &mut self,
        line: &'t str,
        is_declared: bool,
    ) -> Result<Option<&'t str>, String> {
        let Some((code, meaning)) = meaning_in(line) else {
            return Ok(None);
        };
        let Some(declared) = HostDeclaration::of(code) else {
            let what = "`// =` must follow the declaration of a single uniform or varying";
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
            return Ok(Some(code));
        }
        let mut words = value.split(',').map(str::trim);
        let given = words.next().unwrap_or("");
        match declared.ty.contains("sampler") {
            true => self.texture(&declared, given, words, (weight, is_declared)),
            false => self.feed(declared, given, words, (weight, is_declared)),
        }?;
        Ok(Some(code))
    }

    fn feed<'w>(
        &mut self,
        declared: HostDeclaration,
        given: &str,
        words: impl Iterator<Item = &'w str>,
        (weight, is_declared): (u8, bool),
    ) -> Result<(), String> {
        let feed = Feed::named(given)?;
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
                None if word == "ending" => row.name = format!("*{}", declared.name),
                None => {
                    let all = ["or TYPE", "numbered", "ending", "usual", "own"];
                    return Err(none_of(word, &all));
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
        let texture = TextureFeed::named(given)?;
        let mut row = TextureRow {
            name: declared.name.to_string(),
            texture,
            filter: "linear",
            wrap: "clamp",
            top_first: false,
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
                _ if word == "top-first" => row.top_first = true,
                _ => {
                    let others = ["top-first", "numbered", "usual", "own"];
                    let all = [&FILTERS[..], &WRAPS[..], &others[..]].concat();
                    return Err(none_of(word, &all));
                }
            }
        }
        self.textures.push(row);
        Ok(())
    }
}

/// Splits off the weight at the end of a comment.
fn weighted(meaning: &str) -> (&str, u8) {
    let (value, last) = meaning.rsplit_once(',').unwrap_or((meaning, ""));
    match last.trim() {
        "usual" => (value.trim_end(), USUAL),
        "own" => (value.trim_end(), OWN),
        _ => (meaning, COMMON),
    }
}

/// Replaces the number in a name by `#`.
fn numbered(name: &str) -> Result<String, String> {
    let start = name.find(|c: char| c.is_ascii_digit());
    let Some((before, rest)) = start.and_then(|at| name.split_at_checked(at)) else {
        return Err(format!(
            "`numbered` requires a digit in the name, but `{name}` has none"
        ));
    };
    let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    Ok(format!("{before}#{after}"))
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

/// The size of an array, with its brackets.
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
    fn comments_give_the_meanings_of_names() {
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
        assert_eq!(
            all.description("size"),
            Some(Feed::Resolution.description())
        );
        assert_eq!(all.description("plain"), None);
    }

    #[test]
    fn invalid_meanings_are_reported() {
        wrong("uniform float t; // = tmie", "did you mean `time`?");
        wrong("uniform float t; // = time, ofen", "found `ofen`");
        wrong("uniform sampler2D t; // = files", "did you mean `file`?");
        wrong("uniform float t; // = time, numbered", "requires a digit");
        wrong("uniform float a, b; // = time", "a single uniform");
        wrong("#define A 1 // = time", "a single uniform or varying");
    }
}
