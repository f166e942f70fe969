//! Decides what kind of file a file is, from its name and its content.
//!
//! Only GLSL ES is checked, and nothing else is ever written. An extension of GLSL is believed
//! unless the content is clearly something else; without a telling extension, the content must
//! clearly be GLSL; an extension of another language is believed.

mod chunk;
mod evidence;
mod made;
mod scan;
mod sections;
mod shader_language;
mod signs;

pub use chunk::{Chunk, Scanned};
use evidence::starts_as_web;
pub use evidence::{Evidence, VersionLine, has_main, is_type};
pub use made::made;
pub(crate) use sections::{Section, chunks, sections};
pub use sections::{is_chunk_of_library, without_annotations};
pub use shader_language::ShaderLanguage;
pub(crate) use signs::may_be_shader;

use crate::document_language::DocumentLanguage;
use std::fmt;

/// What kind of file a file is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FileKind {
    /// GLSL ES.
    Shader,
    /// JSON, which may be a ShaderToy export, or a project of KodeLife.
    Export,
    /// A document that may contain shaders.
    Holds(DocumentLanguage),
    /// A shader in a language that WebGL cannot compile.
    Foreign(ShaderLanguage),
    /// Anything else, which is neither checked nor written.
    Other,
}

/// What kind of file a file is, and why.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Decision {
    /// What the file is checked as.
    pub kind: FileKind,
    reason: String,
}

impl fmt::Display for Decision {
    /// The reason, as a phrase after the file name.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reason)
    }
}

impl Decision {
    /// The same for a text that is not an export after all.
    pub fn no_export(self) -> Decision {
        match self.reason.ends_with("JSON") {
            true => Decision::new(FileKind::Other, "JSON, but not a ShaderToy export"),
            false => self,
        }
    }

    fn new(kind: FileKind, reason: impl Into<String>) -> Decision {
        Decision {
            kind,
            reason: reason.into(),
        }
    }
}

/// What is known of a file besides its name and content.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Claim {
    /// Nothing.
    #[default]
    None,
    /// The user declares it as a shader, by a pattern of the configuration.
    Shader,
    /// The user names the dialect of the shaders: a file for GLSL is GLSL, whatever it contains.
    Dialect,
}

/// What an extension indicates.
enum Extension {
    /// GLSL.
    Shader,
    /// GLSL, or another language with the same extension.
    Shared,
    /// A shader stage that WebGL does not have.
    Stage,
    Export(&'static str),
    Holds(DocumentLanguage),
    Foreign(ShaderLanguage),
    /// Another language.
    Other(&'static str),
    Unknown,
}

/// The extension of a file name in lower case; empty if there is none.
pub fn file_extension(name: &str) -> String {
    let file = name.rsplit(['/', '\\']).next().unwrap_or("");
    let extension = file.rsplit_once('.').map_or("", |(_, extension)| extension);
    extension.to_ascii_lowercase()
}

fn extension_of(name: &str) -> Extension {
    let extension = file_extension(name);
    if let Some(language) = DocumentLanguage::of_extension(&extension) {
        return Extension::Holds(language);
    }
    match extension.as_str() {
        "glsl" | "frag" | "vert" | "fsh" | "vsh" | "glslf" | "glslv" => Extension::Shader,
        "fs" | "vs" => Extension::Shared,
        "json" | "shadertoy" => Extension::Export("JSON"),
        "klproj" => Extension::Export("a project of KodeLife"),
        "comp" | "geom" | "tesc" | "tese" | "rgen" | "rint" | "rahit" | "rchit" | "rmiss"
        | "rcall" | "mesh" | "task" => Extension::Stage,
        "hlsl" | "hlsli" | "fxh" | "cginc" | "cg" | "usf" | "ush" => {
            Extension::Foreign(ShaderLanguage::Hlsl)
        }
        "metal" => Extension::Foreign(ShaderLanguage::Metal),
        "wgsl" => Extension::Foreign(ShaderLanguage::Wgsl),
        "gdshader" | "gdshaderinc" => Extension::Foreign(ShaderLanguage::Godot),
        other => others(other).map_or(Extension::Unknown, Extension::Other),
    }
}

/// Languages whose files may contain GLSL in strings, or share it by macros, but are not GLSL.
fn others(extension: &str) -> Option<&'static str> {
    Some(match extension {
        "c" | "h" | "cc" | "cpp" | "cxx" | "hh" | "hpp" | "hxx" | "inl" | "ipp" | "m" | "mm" => {
            "C or C++"
        }
        "cu" | "cuh" => "CUDA",
        "cl" => "OpenCL",
        "ino" | "pde" => "a sketch",
        "rs" => "Rust",
        "py" | "pyi" | "pyx" | "pyw" => "Python",
        "ipynb" => "a notebook",
        "java" | "kt" | "kts" | "scala" | "groovy" | "gradle" => "a language of the JVM",
        "cs" | "fsx" | "fsi" | "vb" => "a language of .NET",
        "go" | "swift" | "dart" | "zig" | "nim" | "d" | "jl" | "r" | "lua" | "rb" | "php"
        | "pl" | "hs" | "ml" | "mli" | "clj" | "cljs" | "elm" | "ex" | "exs" | "erl" | "hx"
        | "as" | "gd" | "lisp" | "el" | "coffee" | "sql" | "proto" => "another language",
        "sh" | "bash" | "zsh" | "fish" | "ps1" | "bat" | "cmd" => "a script",
        "css" | "scss" | "sass" | "less" => "a style sheet",
        "xml" | "svg" | "plist" => "XML",
        "yaml" | "yml" | "toml" | "ini" | "cfg" | "conf" | "lock" | "map" | "csv" | "tsv"
        | "log" | "jsonl" | "ndjson" | "jsonc" | "json5" => "data",
        "rst" | "adoc" | "tex" | "org" => "text",
        _ => return None,
    })
}

/// Decides what kind of file a file is.
pub fn decide(name: &str, text: &str, claim: Claim) -> Decision {
    let kind = match extension_of(name) {
        Extension::Other(what) => {
            return Decision::new(FileKind::Other, format!("the extension indicates {what}"));
        }
        Extension::Holds(DocumentLanguage::Script) if is_packed(name) => {
            return Decision::new(FileKind::Other, "the extension indicates a minified script");
        }
        Extension::Holds(language) => {
            let reason = format!("may contain shaders: the extension indicates {language}");
            return Decision::new(FileKind::Holds(language), reason);
        }
        Extension::Export(what) => {
            return Decision::new(FileKind::Export, format!("the extension indicates {what}"));
        }
        Extension::Foreign(language) => {
            let reason = format!("the extension indicates {language}");
            return Decision::new(FileKind::Foreign(language), reason);
        }
        kind => kind,
    };
    let may_be_split = !matches!(kind, Extension::Stage) && claim != Claim::Dialect;
    if may_be_split && !sections(text).is_empty() {
        let kind = FileKind::Holds(DocumentLanguage::Sections);
        return Decision::new(kind, "the content is several shaders");
    }
    let is_for_glsl = matches!(kind, Extension::Shader | Extension::Stage);
    if is_for_glsl && starts_as_web(text) && own_directive(text).is_none() {
        return Decision::new(FileKind::Shader, "the extension indicates GLSL");
    }
    let evidence = Evidence::of(text);
    let is_desktop = evidence.version.is_some_and(VersionLine::is_desktop);
    if claim == Claim::Dialect && matches!(kind, Extension::Shader) && !is_desktop {
        return Decision::new(FileKind::Shader, "the dialect is given");
    }
    if let Some(language) = evidence.foreign() {
        return Decision::new(FileKind::Foreign(language), reason(&evidence, language));
    }
    if let Some(language) = evidence.other() {
        return Decision::new(FileKind::Other, format!("the content is {language}"));
    }
    if let Some(word) = own_directive(text) {
        let reason = format!("`{word}` is a directive of another preprocessor");
        return Decision::new(FileKind::Other, reason);
    }
    match (kind, claim) {
        (Extension::Stage, _) if evidence.version.is_none() => Decision::new(
            FileKind::Foreign(ShaderLanguage::Desktop),
            "the extension indicates a shader stage that WebGL does not have",
        ),
        (Extension::Shader | Extension::Stage, _) => {
            Decision::new(FileKind::Shader, "the extension indicates GLSL")
        }
        (Extension::Shared, _) if text.trim().is_empty() || evidence.has_glsl() => {
            Decision::new(FileKind::Shader, "the extension indicates GLSL")
        }
        (Extension::Shared, Claim::None | Claim::Dialect) => {
            Decision::new(FileKind::Other, "the content is not GLSL")
        }
        (_, Claim::Shader) => Decision::new(FileKind::Shader, "declared as GLSL"),
        _ if evidence.is_glsl() => Decision::new(FileKind::Shader, "the content is GLSL"),
        _ => Decision::new(
            FileKind::Other,
            "neither the extension nor the content indicates GLSL",
        ),
    }
}

/// The evidence for a language: the `#version`, or typical code.
pub fn reason(evidence: &Evidence, language: ShaderLanguage) -> String {
    match evidence.version {
        Some(version) => {
            let es = if version.is_es { " es" } else { "" };
            format!("detected {language} by `#version {}{es}`", version.number)
        }
        None => {
            let reported: Vec<String> = evidence
                .reported(language)
                .iter()
                .map(|t| format!("`{t}`"))
                .collect();
            format!("detected {language} by {}", reported.join(", "))
        }
    }
}

/// Whether files of this name are found when folders are searched.
pub fn is_searched(name: &str) -> bool {
    let is_known = matches!(
        extension_of(name),
        Extension::Shader | Extension::Shared | Extension::Export(_) | Extension::Holds(_)
    );
    is_known && !is_packed(name) && !is_declarations(name)
}

/// Whether a file of this name is a shader, and not a file that may contain some.
pub fn is_shader(name: &str) -> bool {
    matches!(extension_of(name), Extension::Shader | Extension::Shared)
}

/// Whether a file of this name is a script.
pub fn is_script(name: &str) -> bool {
    matches!(
        extension_of(name),
        Extension::Holds(DocumentLanguage::Script)
    )
}

/// Whether a file is a TypeScript declaration file.
fn is_declarations(name: &str) -> bool {
    [".d.ts", ".d.mts", ".d.cts"]
        .iter()
        .any(|e| name.ends_with(e))
}

/// Whether a script is minified, according to its name.
fn is_packed(name: &str) -> bool {
    [".min.js", ".min.mjs", ".min.cjs"]
        .iter()
        .any(|e| name.ends_with(e))
}

/// A directive that starts with `@` at the start of a line, for a program that extracts shaders
/// from the text. `@import` is an include like any other.
pub fn own_directive(text: &str) -> Option<&str> {
    if !text.contains('@') {
        return None;
    }
    let mut in_comment = false;
    text.lines().find_map(|line| {
        let was_in_comment = in_comment;
        // The last comment delimiter of a line decides whether a comment continues on the next one.
        in_comment = match (line.rfind("/*"), line.rfind("*/")) {
            (Some(open), Some(close)) => open > close,
            (Some(open), None) => line.find("//").is_none_or(|at| at > open),
            (None, Some(_)) => false,
            (None, None) => in_comment,
        };
        let line = line.trim();
        let after = line.strip_prefix('@').filter(|_| !was_in_comment)?;
        let end = after.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let word = after.get(..end.unwrap_or(after.len()))?;
        let is_closed = after.get(word.len()..).is_some_and(|b| b.starts_with('@'));
        let is_word = word.starts_with(|c: char| c.is_ascii_lowercase());
        (is_word && word != "import" && !is_closed).then(|| line.get(..=word.len()))?
    })
}
