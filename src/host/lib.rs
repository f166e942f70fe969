//! Hosts: who runs a shader or completes it before a browser sees it, a site, a tool or a library.
//! Each is a file of GLSL with facts in its head, those of `presets/` and those that users write
//! alike. This is the only table of them: checking, running and porting read it.
//!
//! The head is made of line comments: the name in its first line, a paragraph of what the host does,
//! and lines `key: value`. What follows is put before the shaders, with `VERTEX_SHADER` or
//! `FRAGMENT_SHADER` defined. A comment `// = time` behind a declaration says what the host sets the
//! name to ([`Meanings`]), comments `/// ...` before it what editors show of it; names that shaders declare themselves are written between
//! `#ifdef SHADER_DECLARES` and `#endif`, which is put before none.

mod list;
mod meaning;
mod near;

pub use meaning::{
    COMMON, Feed, FeedRow, Meanings, OWN, TextureFeed, TextureRow, USUAL, VaryingRow, is_named,
};

use list::FILES;
use near::none_of;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Mutex, OnceLock, PoisonError};

/// What version of the language a host compiles as.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum HostVersion {
    /// Either, as its user asks.
    #[default]
    Any,
    /// What the text's own `#version` says; the host puts its declarations behind that.
    Own,
    /// GLSL of desktops, which is compiled as GLSL ES 3.00 in its place.
    Desktop,
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
            HostVersion::Desktop => "GLSL for desktops, here as GLSL ES 3.00",
            HostVersion::Es100 => "GLSL ES 1.00",
            HostVersion::Es300 => "GLSL ES 3.00, whatever the text says",
        })
    }
}

/// A host.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Preset {
    /// How configurations and `--host` name it; empty for one that a user wrote.
    pub name: &'static str,
    /// Other names by which it is found.
    pub aliases: Vec<String>,
    /// How people name it.
    pub title: String,
    /// What a shader of it is called, where that is not the title.
    pub reads: String,
    /// The host that it builds on: its declarations are put before its own.
    pub base: Option<&'static str>,
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
    /// Names of JavaScript by which a script hands it texts to which it adds nothing else, so that
    /// another unknown name is a mistake in those.
    pub complete: Vec<String>,
    /// Names of JavaScript by which a script changes such texts all the same.
    pub patched: Vec<String>,
    /// Names that it declares depending on what is drawn, with types that are not known; `*` at the
    /// end stands for anything.
    pub also: Vec<String>,
    /// Whether it takes texts with a `#version` and puts its own in the place of that.
    pub takes_version: bool,
    /// Whether it takes GLSL of desktops besides.
    pub takes_desktop: bool,
    /// Whether it gives other names to what a text declares.
    pub renames: bool,
    /// Whether what it puts around a text depends on that, so that a text is checked as what it
    /// becomes.
    pub composes: bool,
    /// What names of files with its passes end with.
    pub endings: Vec<String>,
    /// Directives that it obeys before the text is compiled; `*` at the end stands for anything.
    pub directives: Vec<String>,
    /// The functions that it calls.
    pub entries: Vec<String>,
    /// What further shows it in a text.
    pub signs: Vec<TextSign>,
    /// What is said of its names, by their comments: `/// The seconds since the start.`
    pub said: BTreeMap<String, String>,
    /// What the names mean that it sets, those of its base last.
    pub meanings: Meanings,
    /// What it puts before the shaders.
    pub prelude: String,
    /// Where in that its own part starts, behind that of its base.
    pub own_start: usize,
}

/// Words of a text that together show a host.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextSign {
    /// The words; the first is told.
    pub words: Vec<String>,
    /// How much they show.
    pub weight: u8,
}

/// A line of a head that cannot be read: its number, and what is wrong with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HeadError {
    /// Number of the line, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

/// The hosts of [`FILES`], each read when it is first asked for.
static PRESETS: [OnceLock<Preset>; FILES.len()] = [const { OnceLock::new() }; FILES.len()];

fn at(index: usize) -> Option<&'static Preset> {
    let ((name, text), cell) = (FILES.get(index)?, PRESETS.get(index)?);
    Some(cell.get_or_init(|| Preset {
        name,
        ..read(text).unwrap_or_default()
    }))
}

/// All presets, in the order of the alphabet.
pub fn presets() -> impl Iterator<Item = &'static Preset> {
    (0..FILES.len()).filter_map(at)
}

/// The preset of a name, or of an alias.
pub fn preset(name: &str) -> Option<&'static Preset> {
    match FILES.iter().position(|(own, _)| *own == name) {
        Some(index) => at(index),
        None => presets().find(|p| p.aliases.iter().any(|alias| alias == name)),
    }
}

/// Keeps a host that a user wrote, as those of the table are, until the program ends; the same one is
/// kept once.
pub fn kept(host: Preset) -> &'static Preset {
    static KEPT: Mutex<Vec<&'static Preset>> = Mutex::new(Vec::new());
    let mut all = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = all.iter().find(|own| ***own == host) {
        return known;
    }
    let own: &'static Preset = Box::leak(Box::new(host));
    all.push(own);
    own
}

/// ShaderToy's player.
pub fn shadertoy() -> Option<&'static Preset> {
    preset("shadertoy")
}

/// A page that runs a text as it stands.
pub fn page() -> Option<&'static Preset> {
    preset("webgl")
}

/// The names and aliases of all presets, in the order of the alphabet.
pub fn names() -> Vec<&'static str> {
    let aliases = presets().flat_map(|p| &p.aliases).map(String::as_str);
    let mut all: Vec<&str> = FILES.iter().map(|(name, _)| *name).chain(aliases).collect();
    all.sort_unstable();
    all
}

/// The preset of a name that a user wrote.
///
/// # Errors
///
/// What is wrong with the name, and the names that are close to it.
pub fn host_named(name: &str) -> Result<&'static Preset, String> {
    preset(name).ok_or_else(|| {
        let all = names();
        let most = (name.len() / 3).clamp(1, 3);
        let is_near = |n: &&&str| {
            n.starts_with(name) && !name.is_empty() || strsim::damerau_levenshtein(n, name) <= most
        };
        let near: Vec<&str> = all.iter().filter(is_near).copied().collect();
        match near.is_empty() {
            true => format!(
                "there is no host `{name}`; there are `{}`",
                all.join("`, `")
            ),
            false => format!(
                "there is no host `{name}`; did you mean `{}`?",
                near.join("` or `")
            ),
        }
    })
}

impl Preset {
    /// The page that describes it, in Markdown.
    pub fn page(&self) -> String {
        let mut text = format!("# {}\n\n{}\n\n", self.title, self.about);
        let code = |words: &[String]| format!("`{}`", words.join("`, `"));
        let mut facts = Vec::new();
        if let Some(base) = self.base {
            facts.push(("Builds on", format!("[{base}]({base}.md)")));
        }
        if !self.aliases.is_empty() {
            facts.push(("Also called", code(&self.aliases)));
        }
        facts.extend([
            ("Compiled as", self.version.to_string()),
            (
                "Other names",
                match self.is_complete {
                    true => "are mistakes".to_string(),
                    false => "may be there, too".to_string(),
                },
            ),
        ]);
        for (what, words) in [
            ("Calls", &self.entries),
            ("Known by the packages", &self.packages),
            ("Known by the names", &self.words),
            ("Known in a page by", &self.globals),
            ("Fills", &self.holes),
            ("Adds nothing to texts of", &self.complete),
            ("Unless changed by", &self.patched),
            ("May declare", &self.also),
            ("Passes in files that end with", &self.endings),
            ("Obeys the directives", &self.directives),
        ] {
            if !words.is_empty() {
                facts.push((what, code(words)));
            }
        }
        if self.composes {
            facts.push(("Around a shader", "what its text asks for".to_string()));
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
        text.push_str(&self.meanings.page(&self.said));
        let prelude = self.prelude.get(self.own_start..).unwrap_or("").trim();
        if !prelude.is_empty() {
            text.push_str("\nWhat it puts before a shader:\n\n```glsl\n");
            text.push_str(prelude);
            text.push_str("\n```\n");
        }
        text
    }

    /// What a shader of it is called where it is told what it was read as.
    pub fn read_as(&self) -> &str {
        match self.reads.is_empty() {
            true => &self.title,
            false => &self.reads,
        }
    }

    /// What is put before a shader of a stage.
    pub fn declarations(&self, is_vertex: bool) -> String {
        for_stage(&self.prelude, is_vertex)
    }

    /// The part of that which is its own, and not its base's.
    pub fn own_declarations(&self, is_vertex: bool) -> String {
        for_stage(self.prelude.get(self.own_start..).unwrap_or(""), is_vertex)
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

    /// Whether it runs texts whose `#version` is that of desktops.
    pub fn runs_desktop(&self) -> bool {
        self.takes_desktop || matches!(self.version, HostVersion::Own | HostVersion::Desktop)
    }

    /// Whether it declares names that it sets, so that texts use them undeclared.
    pub fn declares(&self) -> bool {
        self.meanings.has_declared()
    }

    /// Whether a text of a script gets no other names from it.
    pub fn is_complete_in(&self, script: &str) -> bool {
        let uses = |name: &String| script.contains(name.as_str());
        self.is_complete || self.complete.iter().any(uses) && !self.patched.iter().any(uses)
    }

    /// Whether a file with this ending may hold a pass of it.
    pub fn has_ending(&self, ending: &str) -> bool {
        self.endings.iter().any(|own| own == ending)
    }

    /// Whether only this host declares a name.
    pub fn has_word(&self, name: &str) -> bool {
        matches_any(&self.words, name)
    }
}

/// What is put before a shader, for one of the stages.
fn for_stage(prelude: &str, is_vertex: bool) -> String {
    let stage = match is_vertex {
        true => "VERTEX_SHADER",
        false => "FRAGMENT_SHADER",
    };
    format!("#define {stage} 1\n{prelude}\n#undef {stage}\n")
}

/// Whether a name is one of some, of which those that end with `*` stand for all that begin so.
pub fn matches_any(all: &[String], name: &str) -> bool {
    all.iter().any(|own| match own.strip_suffix('*') {
        Some(beginning) => name.starts_with(beginning),
        None => name == own,
    })
}

/// Reads a host's file.
///
/// # Errors
///
/// The first line with a key of the head that does not exist, with a value that cannot be one, or
/// with a meaning that cannot be read.
pub fn read(text: &str) -> Result<Preset, HeadError> {
    let mut preset = Preset::default();
    let mut given = GivenFacts::default();
    let mut has_facts = false;
    let mut is_head = true;
    // What the lines before a declaration say of it.
    let mut comment = String::new();
    // Whether the lines at hand are for names that shaders declare.
    let mut is_theirs = false;
    for (line, number) in text.split_inclusive('\n').zip(1..) {
        let wrong = |message| HeadError {
            line: number,
            message,
        };
        is_head &= line.starts_with("//") && !line.starts_with("///");
        if !is_head {
            let word = line.trim();
            if let Some(more) = word.strip_prefix("///") {
                comment = format!("{comment} {}", more.trim());
                preset.prelude.push('\n');
                continue;
            }
            let own = std::mem::take(&mut comment);
            if let (false, Some(name)) = (own.is_empty(), declared_in(line)) {
                let own = own.trim().to_string();
                preset.said.insert(name.to_string(), own);
            }
            let is_end = is_theirs && word == "#endif";
            is_theirs |= word == SHADER_DECLARES;
            preset.meanings.read(line, !is_theirs).map_err(wrong)?;
            // What is put before shaders is without these comments.
            let code = line.split_once("// =").map(|(code, _)| code.trim_end());
            match (is_theirs, code) {
                (true, _) => preset.prelude.push('\n'),
                (false, Some(code)) => preset.prelude.push_str(&format!("{code}\n")),
                (false, None) => preset.prelude.push_str(line),
            }
            is_theirs &= !is_end;
            continue;
        }
        // The head stays as blank lines, so that places in the file are those of the text.
        preset.prelude.push('\n');
        let told = line.trim_start_matches("//").trim();
        // Sentences hold colons, too: the facts start with the first key.
        let fact = told.split_once(": ").filter(|(key, _)| match has_facts {
            true => is_key(key),
            false => KEYS.contains(key),
        });
        has_facts |= fact.is_some();
        match fact {
            Some((key, value)) => {
                given.note(key);
                preset.set(key, value.trim()).map_err(wrong)?;
            }
            None if preset.title.is_empty() => preset.title = told.to_string(),
            None if told.is_empty() => {}
            None => {
                if !preset.about.is_empty() {
                    preset.about.push(' ');
                }
                preset.about.push_str(told);
            }
        }
    }
    preset.prelude.truncate(preset.prelude.trim_end().len());
    preset.prelude.push('\n');
    if let Some(base) = preset.base.and_then(self::preset) {
        preset.build_on(base, &given);
    }
    Ok(preset)
}

/// The line before declarations that are in the shaders themselves.
const SHADER_DECLARES: &str = "#ifdef SHADER_DECLARES";

/// Which facts a head gives that a base gives otherwise.
#[derive(Default)]
struct GivenFacts {
    version: bool,
    names: bool,
}

impl GivenFacts {
    fn note(&mut self, key: &str) {
        self.version |= key == "version";
        self.names |= key == "names";
    }
}

impl Preset {
    /// What a user says of a host that is known already.
    pub fn over(mut self, base: &Preset) -> Preset {
        self.put_behind(base);
        self.is_complete &= base.is_complete;
        self.version = base.version;
        self.base = Some(base.name);
        if self.entries.is_empty() {
            self.entries = base.entries.clone();
        }
        self
    }

    fn put_behind(&mut self, base: &Preset) {
        self.own_start = base.prelude.len() + 1;
        self.prelude = format!("{}\n{}", base.prelude, self.prelude);
        self.meanings.inherit(&base.meanings);
        for (name, said) in &base.said {
            let own = self.said.entry(name.clone());
            own.or_insert_with(|| said.clone());
        }
    }

    /// Puts what it says behind what its base says. What shows the base does not show it.
    fn build_on(&mut self, base: &Preset, given: &GivenFacts) {
        self.put_behind(base);
        if !given.version {
            self.version = base.version;
        }
        if !given.names {
            self.is_complete = base.is_complete;
        }
        if self.includes.is_empty() {
            self.includes = base.includes.clone();
        }
        if self.entries.is_empty() {
            self.entries = base.entries.clone();
        }
        self.holes.extend(base.holes.iter().cloned());
    }
}

/// The name that a line declares.
pub fn declared_in(line: &str) -> Option<&str> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let line = line.trim_start();
    if let Some(rest) = line.strip_prefix("#define ") {
        return rest.split(|c| !is_name(c)).next();
    }
    let line = line.strip_prefix("layout").map_or(line, |rest| {
        rest.split_once(')').map_or(rest, |(_, behind)| behind)
    });
    let end = line.find([';', '(', '[', '=', '{'])?;
    let head = line.get(..end)?.trim_end();
    head.rsplit(|c| !is_name(c))
        .next()
        .filter(|n| !n.is_empty())
}

/// The keys of a head.
const KEYS: [&str; 21] = [
    "alias",
    "reads",
    "base",
    "source",
    "package",
    "global",
    "word",
    "shows",
    "entry",
    "include",
    "hole",
    "version",
    "names",
    "renames",
    "takes",
    "complete",
    "patched",
    "also",
    "composes",
    "directive",
    "ending",
];

/// Whether a word in front of a colon may be meant as a key.
fn is_key(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase())
}

impl Preset {
    fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        let words = || value.split_whitespace().map(str::to_string);
        match key {
            "alias" => self.aliases.extend(words()),
            "reads" => self.reads = value.to_string(),
            "base" => self.base = Some(host_named(value)?.name),
            "shows" => self.signs.push(sign(value)?),
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
                    "desktop" => HostVersion::Desktop,
                    "100" => HostVersion::Es100,
                    "300 es" => HostVersion::Es300,
                    _ => {
                        return Err(format!(
                            "`{value}` is none of `any`, `own`, `desktop`, `100`, `300 es`"
                        ));
                    }
                }
            }
            "takes" => match value {
                "version" => self.takes_version = true,
                "desktop" => self.takes_desktop = true,
                _ => return Err(none_of(value, &["version", "desktop"])),
            },
            "complete" => self.complete.extend(words()),
            "patched" => self.patched.extend(words()),
            "also" => self.also.extend(words()),
            "directive" => self.directives.extend(words()),
            "ending" => self.endings.extend(words()),
            "renames" => self.renames = yes_or_no(value)?,
            "composes" => self.composes = yes_or_no(value)?,
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

fn yes_or_no(value: &str) -> Result<bool, String> {
    match value {
        "yes" => Ok(true),
        "no" => Ok(false),
        _ => Err(format!("`{value}` is neither `yes` nor `no`")),
    }
}

/// A sign like `own inData VertexData`.
fn sign(value: &str) -> Result<TextSign, String> {
    let mut words = value.split_whitespace();
    let weight = match words.next() {
        Some("own") => OWN,
        Some("usual") => USUAL,
        other => return Err(none_of(other.unwrap_or(""), &["own", "usual"])),
    };
    let words: Vec<String> = words.map(str::to_string).collect();
    match words.is_empty() {
        true => Err("this names no words".to_string()),
        false => Ok(TextSign { words, weight }),
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
            (2, "`2` is none of `any`, `own`, `desktop`, `100`, `300 es`")
        );
        assert_eq!(
            read("// A\n// names: all\n// wrong: 2\n").unwrap_err().line,
            3
        );
    }

    #[test]
    fn a_host_builds_on_another() {
        let text =
            "// Mine\n//\n// Like three.js.\n// base: three\nuniform float mine; // = time, own\n";
        let preset = read(text).unwrap();
        let three = super::preset("three").unwrap();
        assert_eq!(
            (preset.version, &preset.entries),
            (three.version, &three.entries)
        );
        assert!(preset.prelude.starts_with(&three.prelude));
        assert!(preset.prelude.contains("uniform float mine;"));
        assert_eq!(preset.meanings.feeds[0].name, "mine");
        assert!(preset.meanings.feeds.len() == three.meanings.feeds.len() + 1);
        assert!(preset.packages.is_empty() && preset.words.is_empty());
        let error = read("// A\n// base: threee\n").unwrap_err();
        assert!(
            error.message.ends_with("did you mean `three`?"),
            "{error:?}"
        );
    }

    #[test]
    fn what_shaders_declare_is_put_before_none() {
        let text = "// A\nuniform float a; // = time\n#ifdef SHADER_DECLARES\n\
            uniform float b; // = frame\n#endif\nuniform float c; // = tim\n";
        let error = read(text).unwrap_err();
        assert_eq!(error.line, 6);
        let preset = read(&text.replace("= tim\n", "= time\n")).unwrap();
        let own: Vec<&str> = preset.prelude.lines().filter(|l| !l.is_empty()).collect();
        assert_eq!(own, ["uniform float a;", "uniform float c;"]);
        let declared = preset.meanings.feeds.iter().map(|r| r.is_declared);
        assert_eq!(declared.collect::<Vec<_>>(), [true, false, true]);
    }

    #[test]
    fn comments_say_what_names_are() {
        let text =
            "// A\n/// How long\n/// it runs.\nuniform float a; // = time\nuniform float b;\n";
        let preset = read(text).unwrap();
        assert_eq!(
            preset.said.get("a").map(String::as_str),
            Some("How long it runs.")
        );
        assert_eq!(preset.said.len(), 1);
        assert_eq!(preset.prelude, "\n\n\nuniform float a;\nuniform float b;\n");
    }

    #[test]
    fn every_preset_is_read() {
        for (name, text) in FILES {
            let preset = read(text).unwrap_or_else(|e| panic!("{name}: {e:?}"));
            assert!(
                !preset.title.is_empty() && !preset.about.is_empty(),
                "{name}"
            );
            assert!(!preset.source.is_empty(), "{name}");
        }
    }
}
