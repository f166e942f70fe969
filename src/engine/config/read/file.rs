//! The structure of `shaderlint.toml`: serde reads it, and the JSON schema is derived from it.

use super::mistake::Mistake;
use super::rules::Rules;
use super::word_or::WordOr;
use crate::config::layer::Layer;
use crate::options::{
    ContextChoice, Desktop, DialectChoice, HostNames, HostUniform, TargetVersion,
};
use globset::{GlobBuilder, GlobSet, GlobSetBuilder};
use schemars::JsonSchema;
use serde::Deserialize;
use shaderlint_format::{Brace, Indentation, StyleChoice};
use shaderlint_host::{Preset, host_named, names, none_of};
use shaderlint_lint::{Renderer, RulePreset};
use shaderlint_syntax::{EXTENSIONS, Extensions, GlExtension, Version, WordClass, classify};
use std::collections::BTreeMap;
use toml::Spanned;

// Serde loses positions with `flatten`, so that both structs have the keys of a layer.
macro_rules! with_layer {
    ($(#[$about:meta])* $name:ident { $($own:tt)* }) => {
        #[derive(Deserialize, JsonSchema)]
        $(#[$about])*
        #[serde(deny_unknown_fields, expecting = "a table")]
        pub struct $name {
            $($own)*
            /// Rules to run, before the levels in `rules`
            preset: Option<RulePreset>,
            /// Whether to report infos; otherwise only those of rules in `rules` are
            info: Option<bool>,
            /// Renderer that the shaders run on in production
            target: Option<Renderer>,
            /// Version of GLSL that shaders are converted to
            #[serde(rename = "target-version")]
            target_version: Option<TargetVersion>,
            /// Number of pixels to sample per shader, however long it takes; 0 disables sample runs
            run_samples: Option<u32>,
            /// Dialect of the shaders
            dialect: Option<DialectChoice>,
            /// Context of WebGL that compiles the shaders
            context: Option<ContextChoice>,
            /// Extensions that are enabled in the context, as in `getExtension`
            #[schemars(with = "Option<Vec<String>>")]
            extensions: Option<Vec<Spanned<String>>>,
            /// How to treat desktop GLSL and other shaders that WebGL cannot compile
            desktop: Option<Desktop>,
            /// Site or library that completes the shaders
            host: Option<HostEntry>,
            /// Folders that `#include` searches after the folder of the file, relative to this file
            include_roots: Option<Vec<String>>,
            /// Style of `shaderlint fmt`
            #[serde(default)]
            format: FormatEntry,
            /// Levels and options of rules and groups
            #[serde(default)]
            rules: Rules,
        }

        impl $name {
            /// Checks the keys of the layer.
            pub fn layer(self) -> Result<Layer, Mistake> {
                Ok(Layer {
                    preset: self.preset,
                    info: self.info,
                    target: self.target,
                    target_version: self.target_version.map(TargetVersion::version),
                    run_samples: self.run_samples,
                    dialect: self.dialect,
                    webgl: self.context.map(ContextChoice::webgl),
                    extensions: enabled(self.extensions)?,
                    desktop: self.desktop,
                    host: self.host.map(HostEntry::names).transpose()?,
                    include_roots: self.include_roots,
                    format: self.format.choice()?,
                    rules: self.rules.adjustments()?,
                })
            }
        }
    };
}

with_layer! {
    /// Configuration of shaderlint
    #[schemars(title = "shaderlint.toml")]
    ConfigFile {
        /// Files to check when folders are searched
        pub include: Option<Patterns>,
        /// Files to skip when folders are searched
        pub exclude: Option<Patterns>,
        /// Settings for some files; later overrides take precedence
        #[serde(default)]
        pub overrides: Vec<Override>,
    }
}

with_layer! {
    /// Settings for some files
    Override {
        /// Files that the settings apply to, relative to this configuration
        pub paths: Patterns,
    }
}

/// The extensions that a list names.
fn enabled(list: Option<Vec<Spanned<String>>>) -> Result<Option<Extensions>, Mistake> {
    let named = |entry: &Spanned<String>| {
        GlExtension::named(entry.get_ref()).ok_or_else(|| {
            let known: Vec<&str> = EXTENSIONS.iter().map(|facts| facts.name).collect();
            Mistake::at(entry, none_of(entry.get_ref(), &known))
        })
    };
    list.map(|list| list.iter().map(named).collect())
        .transpose()
}

/// Style of `shaderlint fmt`
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct FormatEntry {
    /// Indentation of a level: a number of spaces, or "tab"
    #[schemars(with = "Option<IndentValue>")]
    indent: Option<Spanned<toml::Value>>,
    /// Maximum line length in characters
    #[schemars(with = "Option<u32>", range(min = 20, max = 1000))]
    width: Option<Spanned<u32>>,
    /// Position of the opening brace of a block: on the same line or on the next line
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
    /// Checks the values.
    fn choice(self) -> Result<StyleChoice, Mistake> {
        let width = self.width.map(|width| match *width.get_ref() {
            20..=1000 => Ok(*width.get_ref()),
            _ => Err(Mistake::at(
                &width,
                "expected a number from 20 to 1000".to_string(),
            )),
        });
        Ok(StyleChoice {
            indent: self.indent.as_ref().map(indent).transpose()?,
            width: width.transpose()?,
            brace: self.brace,
        })
    }
}

/// Width of a tab in columns.
const TAB: u32 = 4;

fn indent(value: &Spanned<toml::Value>) -> Result<Indentation, Mistake> {
    match value.get_ref() {
        toml::Value::Integer(blanks @ 1..=16) => Ok(Indentation::Spaces(*blanks as u32)),
        toml::Value::String(word) if word == "tab" => Ok(Indentation::Tab(TAB)),
        _ => Err(Mistake::at(
            value,
            "expected a number from 1 to 16, or `\"tab\"`".to_string(),
        )),
    }
}

/// The host in short or long form.
pub type HostEntry = WordOr<KnownHost, DescribedHost>;

impl HostEntry {
    /// Checks the uniforms.
    fn names(self) -> Result<HostNames, Mistake> {
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
            is_complete: host.names == Some(NamesOfHost::All),
        })
    }
}

/// A host with additional declarations
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct DescribedHost {
    /// Host to extend
    preset: Option<KnownHost>,
    /// GLSL file that describes the host, relative to this configuration
    prelude: Option<String>,
    /// Whether the host declares all names that the shaders do not, so that any other is an error
    names: Option<NamesOfHost>,
    /// Uniforms that the host declares, with their types
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, UniformType>")]
    uniforms: BTreeMap<Spanned<String>, UniformType>,
}

/// How many of the names that a host declares are known
#[derive(Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum NamesOfHost {
    /// All of them
    All,
    /// Those of the host, if it is not said that they are all
    Some,
}

/// Name of a built-in host
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

/// A type such as `float` or `vec3[4]`
#[derive(Deserialize, JsonSchema)]
#[schemars(with = "String", extend("pattern" = TYPES))]
struct UniformType(Spanned<String>);

const TYPES: &str =
    "^[biu]?(vec|mat|sampler|float|int|uint|bool)[A-Za-z0-9]*( *\\[[0-9]+\\])?$|^[iu]?sampler";

/// Parses `uTime = "float"` or `lights = "vec3[4]"`.
fn uniform(name: &Spanned<String>, ty: &Spanned<String>) -> Result<HostUniform, Mistake> {
    let ident = name.get_ref().as_str();
    let is_word = ident.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && ident
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let is_free = is_word && !ident.starts_with("gl_") && !ident.starts_with("webgl_");
    if !is_free || classify(ident, Version::Es300) != WordClass::Plain {
        let message = format!("`{ident}` is not a valid uniform name");
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
            format!("`{text}` is not a GLSL type; use `float`, `vec3`, `sampler2D`, `vec4[8]`");
        return Err(Mistake::at(ty, message));
    };
    Ok(HostUniform {
        name: ident.to_string(),
        ty: base.to_string(),
        size,
    })
}

/// Patterns as in `.gitignore`: `*` does not match `/`, a pattern without a slash matches at any
/// depth, and a folder matches everything in it
#[derive(Deserialize, JsonSchema)]
#[schemars(with = "Vec<String>")]
pub struct Patterns(Spanned<Vec<Spanned<String>>>);

impl Patterns {
    /// Compiles the patterns.
    pub fn globs(&self) -> Result<GlobSet, Mistake> {
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
                let wrong =
                    |e: globset::Error| format!("invalid pattern `{written}`: {}", e.kind());
                set.add(glob.map_err(|e| Mistake::at(entry, wrong(e)))?);
            }
        }
        set.build().map_err(|e| Mistake::at(&self.0, e.to_string()))
    }
}
