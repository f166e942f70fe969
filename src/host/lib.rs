//! Hosts: libraries that complete shaders before a browser sees them. Each is a file of GLSL with
//! facts in its head, those of `presets/` and those that users write alike.
//!
//! The head is made of line comments: the name in its first line, a paragraph of what the host does,
//! and lines `key: value`. What follows is put before the shaders, with `VERTEX_SHADER` or
//! `FRAGMENT_SHADER` defined.

use std::fmt;
use std::sync::OnceLock;

/// What version of the language a host compiles as.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum HostVersion {
    /// Either, as its user asks.
    #[default]
    Any,
    /// What the text's own `#version` says; the host puts its declarations behind that.
    Own,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL ES 3.00.
    Es300,
}

impl fmt::Display for HostVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            HostVersion::Any => "either version, as its user asks",
            HostVersion::Own => "what the `#version` of the text says",
            HostVersion::Es100 => "GLSL ES 1.00",
            HostVersion::Es300 => "GLSL ES 3.00, whatever the text says",
        })
    }
}

/// A host.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Preset {
    /// How configurations name it; empty for one that a user wrote.
    pub name: &'static str,
    /// How people name it.
    pub title: String,
    /// What it does, in sentences.
    pub about: String,
    /// Where its facts come from.
    pub source: String,
    /// The packages that say that it is there; one that ends with `/` is a scope.
    pub packages: Vec<String>,
    /// Names that only this host declares; `*` at the end stands for anything.
    pub words: Vec<String>,
    /// Names of JavaScript under which a page without modules has it.
    pub globals: Vec<String>,
    /// How it writes what it includes.
    pub includes: String,
    /// How it writes what it puts in, each as `START...END`.
    pub holes: Vec<String>,
    /// What it compiles as.
    pub version: HostVersion,
    /// Whether it declares nothing else, so that another unknown name is a mistake.
    pub is_complete: bool,
    /// Whether it takes texts with a `#version` and puts its own in the place of that.
    pub takes_version: bool,
    /// Whether it gives other names to what a text declares.
    pub renames: bool,
    /// The functions that it calls.
    pub entries: Vec<String>,
    /// What it puts before the shaders.
    pub prelude: String,
}

/// A line of a head that cannot be read: its number, and what is wrong with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HeadError {
    /// Number of the line, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

macro_rules! presets {
    ($($name:literal),* $(,)?) => {
        /// The names of all presets, in the order of the alphabet.
        pub const PRESETS: &[&str] = &[$($name),*];
        static SOURCES: [Source; PRESETS.len()] = [$(Source {
            name: $name,
            text: include_str!(concat!("presets/", $name, ".glsl")),
            preset: OnceLock::new(),
        }),*];
    };
}

/// The file of a preset, which is read when it is first asked for.
struct Source {
    name: &'static str,
    text: &'static str,
    preset: OnceLock<Preset>,
}

impl Source {
    fn preset(&self) -> &Preset {
        self.preset.get_or_init(|| Preset {
            name: self.name,
            ..read(self.text).unwrap_or_default()
        })
    }
}

presets!(
    "babylon",
    "butterchurn",
    "cesium",
    "gl-react",
    "glslcanvas",
    "glslify",
    "hydra",
    "isf",
    "kodi",
    "lamina",
    "luma",
    "lygia",
    "mapbox",
    "maplibre",
    "ogl",
    "openframeworks",
    "p5",
    "phaser",
    "pixi",
    "pixi7",
    "playcanvas",
    "postprocessing",
    "processing",
    "regl",
    "shader-park",
    "shadertoy",
    "three",
    "three-custom-shader-material",
    "twgl",
    "vtk",
);

/// All presets.
pub fn presets() -> impl Iterator<Item = &'static Preset> {
    SOURCES.iter().map(Source::preset)
}

/// The preset of a name.
pub fn preset(name: &str) -> Option<&'static Preset> {
    SOURCES.iter().find(|s| s.name == name).map(Source::preset)
}

impl Preset {
    /// The page that describes it, in Markdown.
    pub fn page(&self) -> String {
        let mut text = format!("# {}\n\n{}\n\n", self.title, self.about);
        let code = |words: &[String]| format!("`{}`", words.join("`, `"));
        let mut facts = vec![
            ("Compiled as", self.version.to_string()),
            (
                "Other names",
                match self.is_complete {
                    true => "are mistakes".to_string(),
                    false => "may be there, too".to_string(),
                },
            ),
        ];
        for (what, words) in [
            ("Calls", &self.entries),
            ("Known by the packages", &self.packages),
            ("Known by the names", &self.words),
            ("Known in a page by", &self.globals),
            ("Fills", &self.holes),
        ] {
            if !words.is_empty() {
                facts.push((what, code(words)));
            }
        }
        if !self.includes.is_empty() {
            facts.push(("Includes", format!("`{}`", self.includes)));
        }
        if !self.source.is_empty() {
            facts.push(("Source", self.source.clone()));
        }
        text.push_str("| | |\n|---|---|\n");
        for (what, value) in facts {
            text.push_str(&format!("| {what} | {value} |\n"));
        }
        text.push_str(&format!("\n```toml\nhost = \"{}\"\n```\n", self.name));
        let prelude = self.prelude.trim();
        if !prelude.is_empty() {
            text.push_str("\nWhat it puts before a shader:\n\n```glsl\n");
            text.push_str(prelude);
            text.push_str("\n```\n");
        }
        text
    }

    /// What is put before a shader of a stage.
    pub fn declarations(&self, is_vertex: bool) -> String {
        let stage = if is_vertex {
            "VERTEX_SHADER"
        } else {
            "FRAGMENT_SHADER"
        };
        format!("#define {stage} 1\n{}\n#undef {stage}\n", self.prelude)
    }

    /// Whether a text has places that the host puts something in: a hole around a word.
    pub fn fills(&self, text: &str) -> bool {
        let is_word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | ':' | '.' | ' ');
        let mut holes = self.holes.iter().filter_map(|h| h.split_once("..."));
        holes.any(|(start, end)| {
            text.match_indices(start).any(|(at, _)| {
                let inside = text.get(at + start.len()..).unwrap_or("");
                let length = inside.find(|c| !is_word(c)).unwrap_or(inside.len());
                let (word, behind) = inside.split_at(length);
                !word.trim().is_empty() && (behind.starts_with(end) || word.ends_with(end))
            })
        })
    }

    /// Whether a package of this name says that the host is there.
    pub fn is_package(&self, package: &str) -> bool {
        self.packages.iter().any(|own| match own.strip_suffix('/') {
            Some(scope) => package
                .strip_prefix(scope)
                .is_some_and(|rest| rest.starts_with('/')),
            None => package == own,
        })
    }

    /// Whether the script around a shader uses it under its name of a page.
    pub fn is_used_in(&self, script: &str) -> bool {
        self.globals.iter().any(|g| {
            let uses = script.match_indices(g.as_str());
            let is_whole = |(at, _): (usize, &str)| {
                let before = script.get(..at).and_then(|b| b.chars().next_back());
                let behind = script.get(at + g.len()..).unwrap_or("");
                behind.starts_with('.') && !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
            };
            uses.into_iter().any(is_whole)
        })
    }

    /// Whether only this host declares a name.
    pub fn has_word(&self, name: &str) -> bool {
        self.words.iter().any(|own| match own.strip_suffix('*') {
            Some(beginning) => name.starts_with(beginning),
            None => name == own,
        })
    }
}

/// Reads a host's file.
///
/// # Errors
///
/// The first line of the head with a key that does not exist, or a value that cannot be one.
pub fn read(text: &str) -> Result<Preset, HeadError> {
    let mut preset = Preset::default();
    let mut length = 0;
    let mut has_facts = false;
    for (number, line) in text.split_inclusive('\n').enumerate() {
        let Some(comment) = line.strip_prefix("//") else {
            break;
        };
        length += line.len();
        let comment = comment.trim();
        // Sentences hold colons, too: the facts start with the first key.
        let fact = comment.split_once(": ").filter(|(key, _)| match has_facts {
            true => is_key(key),
            false => KEYS.contains(key),
        });
        has_facts |= fact.is_some();
        match fact {
            Some((key, value)) => preset.set(key, value.trim()).map_err(|message| HeadError {
                line: number + 1,
                message,
            })?,
            None if preset.title.is_empty() => preset.title = comment.to_string(),
            None if comment.is_empty() => {}
            None => {
                if !preset.about.is_empty() {
                    preset.about.push(' ');
                }
                preset.about.push_str(comment);
            }
        }
    }
    // The head stays as blank lines, so that places in the file are those of the text.
    let lines = text.get(..length).unwrap_or("").matches('\n').count();
    preset.prelude = "\n".repeat(lines) + text.get(length..).unwrap_or("");
    Ok(preset)
}

/// The keys of a head.
const KEYS: [&str; 11] = [
    "source", "package", "global", "word", "entry", "include", "hole", "version", "names",
    "renames", "takes",
];

/// Whether a word in front of a colon may be meant as a key.
fn is_key(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase())
}

impl Preset {
    fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        let words = || value.split_whitespace().map(str::to_string);
        match key {
            "source" => self.source = value.to_string(),
            "package" => self.packages.extend(words()),
            "word" => self.words.extend(words()),
            "entry" => self.entries.extend(words()),
            "global" => self.globals.extend(words()),
            "include" => self.includes = value.to_string(),
            "hole" => self.holes.extend(words()),
            "version" => {
                self.version = match value {
                    "any" => HostVersion::Any,
                    "own" => HostVersion::Own,
                    "100" => HostVersion::Es100,
                    "300 es" => HostVersion::Es300,
                    _ => {
                        return Err(format!(
                            "`{value}` is none of `any`, `own`, `100`, `300 es`"
                        ));
                    }
                }
            }
            "takes" => {
                self.takes_version = match value {
                    "version" => true,
                    _ => return Err(format!("`{value}` is not `version`")),
                }
            }
            "renames" => {
                self.renames = match value {
                    "yes" => true,
                    "no" => false,
                    _ => return Err(format!("`{value}` is neither `yes` nor `no`")),
                }
            }
            "names" => {
                self.is_complete = match value {
                    "all" => true,
                    "some" => false,
                    _ => return Err(format!("`{value}` is neither `all` nor `some`")),
                }
            }
            _ => {
                return Err(format!("`{key}` is none of the keys {}", KEYS.join(", ")));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_is_read() {
        let text = "// My engine\n//\n// Puts things: many.\n// word: my_* uMine\n// package: mine @mine/\n\
            // version: 100\n// names: all\nuniform float uMine;\n";
        let preset = read(text).unwrap();
        assert_eq!(preset.title, "My engine");
        assert_eq!(preset.about, "Puts things: many.");
        assert!(preset.has_word("my_x") && preset.has_word("uMine") && !preset.has_word("uMin"));
        assert!(preset.is_package("mine") && preset.is_package("@mine/core"));
        assert!(!preset.is_package("@mine2/core") && !preset.is_package("mine-too"));
        assert_eq!(preset.version, HostVersion::Es100);
        assert!(preset.is_complete);
        assert_eq!(preset.prelude, "\n\n\n\n\n\n\nuniform float uMine;\n");
        let error = read("// A\n// version: 2\n").unwrap_err();
        assert_eq!(
            (error.line, error.message.as_str()),
            (2, "`2` is none of `any`, `own`, `100`, `300 es`")
        );
        assert_eq!(
            read("// A\n// names: all\n// wrong: 2\n").unwrap_err().line,
            3
        );
    }

    #[test]
    fn every_preset_is_read() {
        for Source { name, text, .. } in &SOURCES {
            let preset = read(text).unwrap_or_else(|e| panic!("{name}: {e:?}"));
            assert!(
                !preset.title.is_empty() && !preset.about.is_empty(),
                "{name}"
            );
            assert!(!preset.source.is_empty(), "{name}");
        }
    }
}
