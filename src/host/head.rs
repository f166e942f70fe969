//! Reads host files: the facts in the header, and the declarations.

use super::limit::Limit;
use super::meaning::{OWN, USUAL};
use super::near::none_of;
use super::preset::{
    GivenFacts, HeadError, HostVersion, Preset, RemovedName, RequiredVersion, TextSign, declared_in,
};
use super::template::Template;

/// Finds a known host by its name.
type Known = fn(&str) -> Result<&'static Preset, String>;

/// Parses a host file. `known` are the hosts that it may extend.
pub(super) fn read(text: &str, known: Known) -> Result<Preset, HeadError> {
    let mut preset = Preset::default();
    let mut given = GivenFacts::default();
    let mut has_facts = false;
    let mut is_head = true;
    let mut ends_paragraph = false;
    // The documentation comment before the current declaration.
    let mut comment = String::new();
    // Whether the current line is in the `SHADER_DECLARES` section.
    let mut is_theirs = false;
    let mut section: Option<(&str, String)> = None;
    for (line, number) in text.split_inclusive('\n').zip(1..) {
        let wrong = |message| HeadError {
            line: number,
            message,
        };
        is_head &= line.starts_with("//") && !line.starts_with("///");
        if !is_head {
            let word = line.trim();
            if section.is_some() || [SHADER_TEMPLATE, SHADER_MAIN].contains(&word) {
                preset.prelude.push('\n');
                section = preset.read_section(section.take(), line).map_err(wrong)?;
                continue;
            }
            if let Some(more) = word.strip_prefix("///") {
                comment = format!("{comment} {}", more.trim());
                preset.prelude.push('\n');
                continue;
            }
            let own = std::mem::take(&mut comment);
            if !own.is_empty()
                && let Some(name) = declared_in(line)
            {
                let own = own.trim().to_string();
                preset.descriptions.insert(name.to_string(), own);
            }
            let is_end = is_theirs && word == "#endif";
            is_theirs |= word == SHADER_DECLARES;
            // Meanings are not part of the prelude.
            let code = preset.meanings.read(line, !is_theirs).map_err(wrong)?;
            match (is_theirs, code) {
                (true, _) => preset.prelude.push('\n'),
                (false, Some(code)) => {
                    preset.prelude.push_str(code.trim_end());
                    preset.prelude.push('\n');
                }
                (false, None) => preset.prelude.push_str(line),
            }
            is_theirs &= !is_end;
            continue;
        }
        // The header becomes blank lines, so that line numbers are those of the file.
        preset.prelude.push('\n');
        let header = line.trim_start_matches("//").trim();
        let fact = fact_in(header, has_facts);
        has_facts |= fact.is_some();
        match fact {
            Some((key, value)) => {
                given.note(key);
                preset.set(key, value.trim(), known).map_err(wrong)?;
            }
            None if preset.title.is_empty() => preset.title = header.to_string(),
            None if header.is_empty() => ends_paragraph = true,
            None => preset.describe(header, std::mem::take(&mut ends_paragraph)),
        }
    }
    preset.prelude.truncate(preset.prelude.trim_end().len());
    preset.prelude.push('\n');
    if let Some(base) = preset.base.and_then(|base| known(base).ok()) {
        preset.build_on(base, &given);
    }
    Ok(preset)
}

/// Starts the section of names that the shaders declare.
const SHADER_DECLARES: &str = "#ifdef SHADER_DECLARES";

/// Starts the template.
const SHADER_TEMPLATE: &str = "#ifdef SHADER_TEMPLATE";

/// Starts the section of the text that the host appends.
const SHADER_MAIN: &str = "#ifdef SHADER_MAIN";

/// The keys of a header.
const KEYS: &str = "\
    alias reads base source package global word shows entry include hole file chunks version \
    context requires names uniforms renames takes complete patched bare glsl removed also composes \
    directive defines ending refuses setters programs";

/// The key and the value in a line of the header. Sentences may contain colons: the facts start at the
/// first known key.
fn fact_in(header: &str, has_facts: bool) -> Option<(&str, &str)> {
    let (key, value) = header.split_once(':')?;
    let value = value.strip_prefix(' ')?;
    let is_fact = match has_facts {
        true => is_key(key),
        false => KEYS.split(' ').any(|known| known == key),
    };
    is_fact.then_some((key, value))
}

/// Whether a word before a colon may be meant as a key.
fn is_key(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase())
}

impl Preset {
    /// Adds a line to the description.
    fn describe(&mut self, line: &str, starts_paragraph: bool) {
        if !self.about.is_empty() {
            let separator = if starts_paragraph { "\n\n" } else { " " };
            self.about.push_str(separator);
        }
        self.about.push_str(line);
    }

    /// Adds a line to those of a section; the last one completes it.
    fn read_section<'t>(
        &mut self,
        section: Option<(&'t str, String)>,
        line: &'t str,
    ) -> Result<Option<(&'t str, String)>, String> {
        match section {
            None => return Ok(Some((line.trim(), String::new()))),
            Some((start, lines)) if line.trim() != "#endif" => {
                return Ok(Some((start, lines + line)));
            }
            Some((SHADER_MAIN, lines)) => self.main = lines,
            Some((_, lines)) => self.template = Some(Template::of(&lines)?),
        }
        Ok(None)
    }

    fn set(&mut self, key: &str, value: &str, known: Known) -> Result<(), String> {
        let words = || value.split_whitespace().map(str::to_string);
        match key {
            "alias" => self.aliases.extend(words()),
            "reads" => self.reads = value.to_string(),
            "base" => self.base = Some(known(value)?.name),
            "shows" => self.signs.push(sign(value)?),
            "source" => self.source = value.to_string(),
            "package" => self.packages.extend(words()),
            "word" => self.words.extend(words()),
            "entry" => self.entries.extend(words()),
            "global" => self.globals.extend(words()),
            "chunks" => self.chunks = value.to_string(),
            "file" => self.files.extend(words()),
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
                            "expected one of `any`, `own`, `desktop`, `100`, `300 es`, found `{value}`"
                        ));
                    }
                }
            }
            "context" => match value.split(' ').next() {
                Some("webgl1" | "webgl2") => self.context.extend(words()),
                _ => return Err(none_of(value, &["webgl1", "webgl2"])),
            },
            "requires" => self.required = Some(required(value)?),
            "takes" => match value {
                "version" => self.takes_version = true,
                "desktop" => self.takes_desktop = true,
                "late-version" => self.takes_late_version = true,
                "annotations" => self.takes_annotations = true,
                _ => {
                    let all = ["version", "desktop", "late-version", "annotations"];
                    return Err(none_of(value, &all));
                }
            },
            "complete" => self.complete.extend(words()),
            "patched" => self.patched.extend(words()),
            "bare" => self.bare.extend(words()),
            "glsl" => self.glsl.extend(words()),
            "removed" => self.removed.push(removed(value)?),
            "also" => self.also.extend(words()),
            "defines" => self.defined.extend(words()),
            "directive" => self.directives.extend(words()),
            "ending" => self.extensions.extend(words()),
            "renames" => self.renames = yes_or_no(value)?,
            "composes" => self.composes = yes_or_no(value)?,
            "setters" => self.setters = value.to_string(),
            "programs" => {
                self.programs = value
                    .parse()
                    .map_err(|_| format!("expected a number, found `{value}`"))?;
            }
            "refuses" => {
                for word in words() {
                    self.limits.push(Limit::named(&word)?);
                }
            }
            "names" => self.is_complete = all_or_some(value)?,
            "uniforms" => self.sets_all = all_or_some(value)?,
            _ => {
                return Err(format!(
                    "unknown key `{key}`; expected one of {}",
                    KEYS.replace(' ', ", ")
                ));
            }
        }
        Ok(())
    }
}

/// Parses a name that is gone, such as `map 137 remove the call`.
fn removed(value: &str) -> Result<RemovedName, String> {
    let mut parts = value.splitn(3, ' ');
    let mut found = || {
        Some(RemovedName {
            name: parts.next()?.to_string(),
            release: parts.next()?.parse().ok()?,
            advice: parts.next()?.to_string(),
        })
    };
    found().ok_or_else(|| format!("expected `NAME RELEASE ADVICE`, found `{value}`"))
}

/// Parses a required version such as `300 es, 8.0`.
fn required(value: &str) -> Result<RequiredVersion, String> {
    let (version, since) = value
        .split_once(", ")
        .ok_or_else(|| format!("expected `VERSION, RELEASE`, found `{value}`"))?;
    Ok(RequiredVersion {
        version: version.to_string(),
        since: since.to_string(),
    })
}

fn all_or_some(value: &str) -> Result<bool, String> {
    match value {
        "all" => Ok(true),
        "some" => Ok(false),
        _ => Err(format!("expected `all` or `some`, found `{value}`")),
    }
}

fn yes_or_no(value: &str) -> Result<bool, String> {
    match value {
        "yes" => Ok(true),
        "no" => Ok(false),
        _ => Err(format!("expected `yes` or `no`, found `{value}`")),
    }
}

/// Parses evidence such as `own inData VertexData`.
fn sign(value: &str) -> Result<TextSign, String> {
    let mut words = value.split_whitespace();
    let weight = match words.next() {
        Some("own") => OWN,
        Some("usual") => USUAL,
        other => return Err(none_of(other.unwrap_or(""), &["own", "usual"])),
    };
    let words: Vec<String> = words.map(str::to_string).collect();
    match words.is_empty() {
        true => Err("expected at least one word".to_string()),
        false => Ok(TextSign { words, weight }),
    }
}
