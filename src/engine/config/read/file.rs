//! The shape of `shaderlint.toml`: what serde reads, and what the JSON schema is derived from.

use super::mistake::Mistake;
use super::rules::Rules;
use super::word_or::WordOr;
use crate::options::{Desktop, DialectChoice, HostNames, HostUniform};
use globset::{GlobBuilder, GlobSet, GlobSetBuilder};
use schemars::JsonSchema;
use serde::Deserialize;
use shaderlint_format::{Brace, Indentation, StyleChoice};
use shaderlint_host::{Preset, host_named, names};
use shaderlint_lint::Renderer;
use shaderlint_syntax::{Version, WordClass, classify};
use std::collections::BTreeMap;
use toml::Spanned;

// Two structs have the keys of a layer: serde forgets the places of what it flattens.

/// What holds for all files, and which files these are
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = "a table")]
#[schemars(title = "shaderlint.toml")]
pub struct ConfigFile {
    /// What draws the shaders in the end
    pub target: Option<Renderer>,
    /// How many pixels of each shader are run, whatever that takes; none where it is 0
    pub run_samples: Option<u32>,
    /// What the shaders are written for
    pub dialect: Option<DialectChoice>,
    /// What is said of shaders for OpenGL, Vulkan and other hosts than WebGL
    pub desktop: Option<Desktop>,
    /// What the host declares for the shaders
    pub host: Option<HostEntry>,
    /// How `shaderlint fmt` sets code
    #[serde(default)]
    pub format: FormatEntry,
    /// Levels and options of rules and groups
    #[serde(default)]
    pub rules: Rules,
    /// The files that folders are searched for
    pub include: Option<Patterns>,
    /// Folders that #include searches behind that of the file, from the folder of this file
    pub include_roots: Option<Vec<String>>,
    /// The files that are left out of folders
    pub exclude: Option<Patterns>,
    /// What holds for some files, the later over the earlier
    #[serde(default)]
    pub overrides: Vec<Override>,
}

/// What holds for some files
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct Override {
    /// The files that it holds for, from the folder of this file
    pub paths: Patterns,
    /// What draws the shaders in the end
    pub target: Option<Renderer>,
    /// How many pixels of each shader are run, whatever that takes; none where it is 0
    pub run_samples: Option<u32>,
    /// What the shaders are written for
    pub dialect: Option<DialectChoice>,
    /// What is said of shaders for OpenGL, Vulkan and other hosts than WebGL
    pub desktop: Option<Desktop>,
    /// What the host declares for the shaders
    pub host: Option<HostEntry>,
    /// Folders that #include searches behind that of the file, from the folder of this file
    pub include_roots: Option<Vec<String>>,
    /// How `shaderlint fmt` sets code
    #[serde(default)]
    pub format: FormatEntry,
    /// Levels and options of rules and groups
    #[serde(default)]
    pub rules: Rules,
}

/// How code is set
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct FormatEntry {
    /// What a level is indented by: a number of blanks, or "tab"
    #[schemars(with = "Option<IndentValue>")]
    indent: Option<Spanned<toml::Value>>,
    /// How many characters a line should have at most
    #[schemars(with = "Option<u32>", range(min = 20, max = 1000))]
    width: Option<Spanned<u32>>,
    /// Where the brace of a block stands: in the line of what it belongs to, or in the next
    brace: Option<Brace>,
}

/// The forms of `indent`, for the schema
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "only its schema is used")]
enum IndentValue {
    Blanks(#[schemars(range(min = 1, max = 16))] u32),
    Tab(#[schemars(extend("const" = "tab"))] String),
}

impl FormatEntry {
    /// As the formatter takes it.
    pub fn choice(self) -> Result<StyleChoice, Mistake> {
        let width = self.width.map(|width| match *width.get_ref() {
            20..=1000 => Ok(*width.get_ref()),
            _ => Err(Mistake::at(&width, "this must be 20 to 1000".to_string())),
        });
        Ok(StyleChoice {
            indent: self.indent.as_ref().map(indent).transpose()?,
            width: width.transpose()?,
            brace: self.brace,
        })
    }
}

/// Columns of a tab, where nothing is said of it.
const TAB: u32 = 4;

fn indent(value: &Spanned<toml::Value>) -> Result<Indentation, Mistake> {
    match value.get_ref() {
        toml::Value::Integer(blanks @ 1..=16) => Ok(Indentation::Spaces(*blanks as u32)),
        toml::Value::String(word) if word == "tab" => Ok(Indentation::Tab(TAB)),
        _ => Err(Mistake::at(
            value,
            "this must be 1 to 16, or `\"tab\"`".to_string(),
        )),
    }
}

/// What the host declares.
pub type HostEntry = WordOr<KnownHost, DescribedHost>;

impl HostEntry {
    /// As the engine takes it.
    pub fn names(self) -> Result<HostNames, Mistake> {
        let host = match self {
            WordOr::Word(known) => DescribedHost {
                preset: Some(known),
                ..DescribedHost::default()
            },
            WordOr::Table(host) => host,
        };
        let uniforms = host.uniforms.iter().map(|(name, ty)| uniform(name, &ty.0));
        Ok(HostNames {
            uniforms: uniforms.collect::<Result<_, _>>()?,
            preset: host.preset.map(|known| known.0),
            prelude: host.prelude,
        })
    }
}

/// A host with what the user says of it
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct DescribedHost {
    /// The host that it builds on
    preset: Option<KnownHost>,
    /// A file of GLSL that describes a host, from the folder of this file
    prelude: Option<String>,
    /// Uniforms that the host declares, with their types
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, UniformType>")]
    uniforms: BTreeMap<Spanned<String>, UniformType>,
}

/// The name of a host that comes with the program
#[derive(Deserialize, JsonSchema)]
#[serde(try_from = "String")]
#[schemars(with = "String", extend("enum" = names()))]
pub struct KnownHost(&'static Preset);

impl TryFrom<String> for KnownHost {
    type Error = String;

    fn try_from(name: String) -> Result<KnownHost, String> {
        Ok(KnownHost(host_named(&name)?))
    }
}

/// A type like `float` or `vec3[4]`
#[derive(Deserialize, JsonSchema)]
#[schemars(with = "String", extend("pattern" = TYPES))]
struct UniformType(Spanned<String>);

const TYPES: &str =
    "^[biu]?(vec|mat|sampler|float|int|uint|bool)[A-Za-z0-9]*( *\\[[0-9]+\\])?$|^[iu]?sampler";

/// Reads `uTime = "float"` or `lights = "vec3[4]"`.
fn uniform(name: &Spanned<String>, ty: &Spanned<String>) -> Result<HostUniform, Mistake> {
    let ident = name.get_ref().as_str();
    let is_word = ident.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && ident
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let is_free = is_word && !ident.starts_with("gl_") && !ident.starts_with("webgl_");
    if !is_free || classify(ident, Version::Es300) != WordClass::Plain {
        let message = format!("`{ident}` cannot be the name of a uniform");
        return Err(Mistake::at(name, message));
    }
    let text = ty.get_ref().as_str();
    let (base, size) = match text.split_once('[') {
        Some((base, rest)) => {
            let digits = rest.trim_end().strip_suffix(']').unwrap_or("");
            let size = digits.trim().parse::<u32>().ok();
            (base.trim(), size.filter(|s| *s > 0).map(Some))
        }
        None => (text.trim(), Some(None)),
    };
    let is_type = matches!(classify(base, Version::Es300), WordClass::Type(_)) && base != "void";
    let (true, Some(size)) = (is_type, size) else {
        let message =
            format!("`{text}` is no type of GLSL; write `float`, `vec3`, `sampler2D`, `vec4[8]`");
        return Err(Mistake::at(ty, message));
    };
    Ok(HostUniform {
        name: ident.to_string(),
        ty: base.to_string(),
        size,
    })
}

/// Patterns as `.gitignore` has them: `*` stays inside a folder, a pattern without a slash holds at
/// any depth, and what names a folder holds for all in it
#[derive(Deserialize, JsonSchema)]
#[schemars(with = "Vec<String>")]
pub struct Patterns(Spanned<Vec<Spanned<String>>>);

impl Patterns {
    /// All in one.
    pub fn globs(self) -> Result<GlobSet, Mistake> {
        let mut set = GlobSetBuilder::new();
        for entry in self.0.get_ref() {
            let written = entry.get_ref().as_str();
            let plain = written.trim_end_matches('/');
            let rooted = match plain.strip_prefix('/').or(plain.strip_prefix("./")) {
                Some(rooted) => rooted.to_string(),
                None if plain.contains('/') => plain.to_string(),
                None => format!("**/{plain}"),
            };
            for pattern in [format!("{rooted}/**"), rooted] {
                let glob = GlobBuilder::new(&pattern).literal_separator(true).build();
                let wrong = |e: globset::Error| format!("`{written}` is no pattern: {}", e.kind());
                set.add(glob.map_err(|e| Mistake::at(entry, wrong(e)))?);
            }
        }
        set.build().map_err(|e| Mistake::at(&self.0, e.to_string()))
    }
}
