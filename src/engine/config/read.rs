//! Reads a configuration; every key that it does not know is an error with its place.

use super::super::options::{Desktop, DialectChoice, HostNames, HostUniform};
use super::{Config, Layer};
use crate::diagnostic::{ERRORS, Severity};
use crate::host::{PRESETS, preset};
use crate::lint::{Failing, Group, OptionValue, Renderer, Rule, RuleOption, nearest_rule};
use crate::syntax::{Version, WordClass, classify};
use crate::text::LineIndex;
use globset::{GlobBuilder, GlobSet, GlobSetBuilder};
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys of the file.
pub const KEYS: [&str; 9] = [
    "target",
    "dialect",
    "desktop",
    "host",
    "rules",
    "include",
    "include_roots",
    "exclude",
    "overrides",
];
/// Keys of an override.
pub const OVERRIDE_KEYS: [&str; 7] = [
    "paths",
    "target",
    "dialect",
    "desktop",
    "host",
    "include_roots",
    "rules",
];
/// Keys of `host`.
pub const HOST_KEYS: [&str; 3] = ["preset", "prelude", "uniforms"];
/// Words for `target`.
pub const TARGETS: [&str; 2] = ["swiftshader", "gpu"];
/// Words for `dialect`.
pub const DIALECTS: [&str; 4] = ["auto", "shadertoy", "webgl2", "webgl1"];
/// Words for `desktop`.
pub const DESKTOPS: [&str; 3] = ["report", "skip", "port"];
/// Words for `level`.
pub const LEVELS: [&str; 3] = ["off", "info", "warning"];
/// What is wrong with a configuration.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigError {
    /// 1-based.
    pub line: u32,
    /// 1-based, in characters.
    pub column: u32,
    /// What is wrong.
    pub message: String,
}

/// An error at a range of bytes.
struct Problem(Range<usize>, String);

type Result<T> = std::result::Result<T, Problem>;
type Value<'a> = Spanned<DeValue<'a>>;

/// Reads the text of a configuration.
pub fn parse(
    text: &str,
    rules: &'static [&'static Rule],
) -> std::result::Result<Config, ConfigError> {
    let table = DeTable::parse(text).map_err(|e| {
        let message = e.message().lines().collect::<Vec<_>>().join("; ");
        Problem(e.span().unwrap_or(0..0), message)
    });
    table
        .and_then(|t| file(t.get_ref(), rules))
        .map_err(|Problem(span, message)| {
            let position = LineIndex::new(text).position(text, span.start as u32);
            ConfigError {
                line: position.line,
                column: position.column,
                message,
            }
        })
}

fn file(table: &DeTable, rules: &'static [&'static Rule]) -> Result<Config> {
    let mut config = Config::default();
    check_keys(table, &KEYS)?;
    config.base = layer(table, rules)?;
    for (key, value) in table {
        match key.get_ref().as_ref() {
            "include" => config.include = Some(globs(value)?),
            "exclude" => config.exclude = Some(globs(value)?),
            "overrides" => {
                for entry in array(value)? {
                    let table = table_of(entry)?;
                    check_keys(table, &OVERRIDE_KEYS)?;
                    let paths = table.iter().find(|(k, _)| k.get_ref() == "paths");
                    let (_, paths) = paths.ok_or(Problem(
                        entry.span(),
                        "an override needs `paths`: `paths = [\"legacy/**\"]`".to_string(),
                    ))?;
                    config.overrides.push((globs(paths)?, layer(table, rules)?));
                }
            }
            _ => {}
        }
    }
    Ok(config)
}

fn layer(table: &DeTable, rules: &'static [&'static Rule]) -> Result<Layer> {
    let mut layer = Layer::default();
    for (key, value) in table {
        match key.get_ref().as_ref() {
            "target" => {
                layer.target = Some(match word(value, &TARGETS)? {
                    "gpu" => Renderer::Gpu,
                    _ => Renderer::SwiftShader,
                });
            }
            "dialect" => {
                layer.dialect = Some(match word(value, &DIALECTS)? {
                    "shadertoy" => DialectChoice::Shadertoy,
                    "webgl2" => DialectChoice::Webgl2,
                    "webgl1" => DialectChoice::Webgl1,
                    _ => DialectChoice::Auto,
                });
            }
            "desktop" => {
                layer.desktop = Some(match word(value, &DESKTOPS)? {
                    "skip" => Desktop::Skip,
                    "port" => Desktop::Port,
                    _ => Desktop::Report,
                });
            }
            "host" => layer.host = Some(host(value)?),
            "include_roots" => {
                let folders = array(value)?.iter().map(|v| string(v).map(str::to_string));
                layer.include_roots = Some(folders.collect::<Result<_>>()?);
            }
            "rules" => rules_of(table_of(value)?, rules, &mut layer)?,
            _ => {}
        }
    }
    Ok(layer)
}

fn rules_of(table: &DeTable, rules: &'static [&'static Rule], layer: &mut Layer) -> Result<()> {
    // What names more is read first, so that what names less holds.
    for width in [Width::All, Width::Group, Width::Rule] {
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            let own = match name {
                "all" => Width::All,
                _ if Group::ALL.iter().any(|g| g.name() == name) => Width::Group,
                _ => Width::Rule,
            };
            if own != width {
                continue;
            }
            let is_named =
                |r: &&&'static Rule| own == Width::All || r.name == name || r.group.name() == name;
            let named: Vec<&'static Rule> = rules.iter().filter(is_named).copied().collect();
            if named.is_empty() && own == Width::Rule {
                return Err(Problem(key.span(), no_rule(name, rules)));
            }
            let level = match value.get_ref() {
                DeValue::String(_) => Some(level(value)?),
                DeValue::Table(table) => options(table, &named, own, layer)?,
                _ => {
                    let message = "this must be a level, or a table with `level` and options";
                    return Err(Problem(value.span(), message.to_string()));
                }
            };
            let levels = level.map(|l| named.iter().map(move |r| (r.name, l)));
            layer.levels.extend(levels.into_iter().flatten());
        }
    }
    Ok(())
}

/// How many rules a key names.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Width {
    All,
    Group,
    Rule,
}

fn no_rule(name: &str, rules: &[&'static Rule]) -> String {
    if ERRORS.contains(&name) {
        return format!("`{name}` is a compile error, which has no level");
    }
    let near =
        nearest_rule(rules, name).map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    format!("there is no rule or group `{name}`{near}")
}

/// Reads `{ level = "info", fail = true, steps = 128 }`.
fn options(
    table: &DeTable,
    named: &[&'static Rule],
    width: Width,
    layer: &mut Layer,
) -> Result<Option<Option<Severity>>> {
    let mut own = None;
    for (key, value) in table {
        let name = key.get_ref().as_ref();
        if name == "level" {
            own = Some(level(value)?);
            continue;
        }
        if name == "fail" {
            let failing = match switch(value)? {
                true => Failing::Yes,
                false => Failing::No,
            };
            layer
                .failing
                .extend(named.iter().map(|r| (r.name, failing)));
            continue;
        }
        let rule = named.first().filter(|_| width == Width::Rule);
        let known = rule.map_or(&[][..], |r| r.options);
        let option = known.iter().find(|o| o.name() == name);
        let (Some(rule), Some(option)) = (rule, option) else {
            let names = known.iter().map(|o| o.name());
            let keys: Vec<&str> = names.chain(["level", "fail"]).collect();
            return Err(Problem(key.span(), unknown_key(name, &keys)));
        };
        let given = match option {
            RuleOption::Count(_) => OptionValue::Count(count(value)?),
            RuleOption::Number(_) => OptionValue::Number(number(value)?),
            RuleOption::Switch(_) => OptionValue::Switch(switch(value)?),
        };
        layer.options.push((rule.name, option.name(), given));
    }
    Ok(own)
}

fn level(value: &Value) -> Result<Option<Severity>> {
    if value.get_ref().as_str() == Some("error") {
        let message = "no rule has the level `error`: an error means that the browser refuses the shader; \
            `{ level = \"warning\", fail = true }` makes the run fail on it";
        return Err(Problem(value.span(), message.to_string()));
    }
    Ok(match word(value, &LEVELS)? {
        "info" => Some(Severity::Info),
        "warning" => Some(Severity::Warning),
        _ => None,
    })
}

fn switch(value: &Value) -> Result<bool> {
    match value.get_ref() {
        DeValue::Boolean(on) => Ok(*on),
        _ => {
            let message = "this must be `true` or `false`";
            Err(Problem(value.span(), message.to_string()))
        }
    }
}

fn count(value: &Value) -> Result<u64> {
    let wrong = || {
        Problem(
            value.span(),
            "this must be a whole number, 0 or more".to_string(),
        )
    };
    match value.get_ref() {
        DeValue::Integer(i) => {
            let digits = i.as_str().replace('_', "");
            u64::from_str_radix(&digits, i.radix()).map_err(|_| wrong())
        }
        _ => Err(wrong()),
    }
}

fn number(value: &Value) -> Result<f64> {
    let wrong = || Problem(value.span(), "this must be a number, 0 or more".to_string());
    let number = match value.get_ref() {
        DeValue::Integer(i) => {
            let digits = i.as_str().replace('_', "");
            i64::from_str_radix(&digits, i.radix())
                .map(|v| v as f64)
                .map_err(|_| wrong())
        }
        DeValue::Float(f) => f.as_str().replace('_', "").parse().map_err(|_| wrong()),
        _ => Err(wrong()),
    };
    number.and_then(|n: f64| {
        let is_amount = n.is_finite() && n >= 0.0;
        is_amount.then_some(n).ok_or_else(wrong)
    })
}

fn host(value: &Value) -> Result<HostNames> {
    let mut host = HostNames::default();
    if value.get_ref().is_str() {
        host.preset = preset(word(value, PRESETS)?).cloned().map(Arc::new);
        return Ok(host);
    }
    let table = table_of(value)?;
    check_keys(table, &HOST_KEYS)?;
    for (key, value) in table {
        if key.get_ref() == "preset" {
            host.preset = preset(word(value, PRESETS)?).cloned().map(Arc::new);
            continue;
        }
        if key.get_ref() == "prelude" {
            host.prelude = Some(string(value)?.to_string());
            continue;
        }
        for (name, ty) in table_of(value)? {
            host.uniforms.push(uniform(name, ty)?);
        }
    }
    Ok(host)
}

/// Reads `uTime = "float"` or `lights = "vec3[4]"`.
fn uniform(name: &Spanned<std::borrow::Cow<str>>, ty: &Value) -> Result<HostUniform> {
    let ident = name.get_ref().as_ref();
    let is_word = ident.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && ident
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let is_free = is_word && !ident.starts_with("gl_") && !ident.starts_with("webgl_");
    if !is_free || classify(ident, Version::Es300) != WordClass::Plain {
        let message = format!("`{ident}` cannot be the name of a uniform");
        return Err(Problem(name.span(), message));
    }
    let text = string(ty)?;
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
        return Err(Problem(ty.span(), message));
    };
    Ok(HostUniform {
        name: ident.to_string(),
        ty: base.to_string(),
        size,
    })
}

/// Reads patterns as `.gitignore` has them: `*` stays inside a folder, a pattern without a slash
/// holds at any depth, and what names a folder holds for all in it.
fn globs(value: &Value) -> Result<GlobSet> {
    let mut set = GlobSetBuilder::new();
    for entry in array(value)? {
        let written = string(entry)?;
        let plain = written.trim_end_matches('/');
        let rooted = match plain.strip_prefix('/').or(plain.strip_prefix("./")) {
            Some(rooted) => rooted.to_string(),
            None if plain.contains('/') => plain.to_string(),
            None => format!("**/{plain}"),
        };
        for pattern in [format!("{rooted}/**"), rooted] {
            let glob = GlobBuilder::new(&pattern).literal_separator(true).build();
            let wrong = |e: globset::Error| format!("`{written}` is no pattern: {}", e.kind());
            set.add(glob.map_err(|e| Problem(entry.span(), wrong(e)))?);
        }
    }
    set.build()
        .map_err(|e| Problem(value.span(), e.to_string()))
}

fn check_keys(table: &DeTable, known: &[&str]) -> Result<()> {
    let wrong = table
        .keys()
        .find(|k| !known.contains(&k.get_ref().as_ref()));
    match wrong {
        Some(key) => Err(Problem(key.span(), unknown_key(key.get_ref(), known))),
        None => Ok(()),
    }
}

fn unknown_key(name: &str, known: &[&str]) -> String {
    match near(name, known) {
        Some(near) => format!("unknown key `{name}`; did you mean `{near}`?"),
        None => format!("unknown key `{name}`; there are `{}`", known.join("`, `")),
    }
}

fn near<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let distances = known
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, name), *k));
    distances.filter(|(d, _)| *d <= 3).min().map(|(_, k)| k)
}

fn word<'a>(value: &Value, known: &[&'a str]) -> Result<&'a str> {
    let text = string(value)?;
    known.iter().find(|k| **k == text).copied().ok_or_else(|| {
        let near = near(text, known).map_or(String::new(), |n| format!("; did you mean `{n}`?"));
        let message = format!("`{text}` is none of `{}`{near}", known.join("`, `"));
        Problem(value.span(), message)
    })
}

fn string<'a>(value: &'a Value) -> Result<&'a str> {
    let text = value.get_ref().as_str();
    text.ok_or_else(|| Problem(value.span(), "this must be a text in quotes".to_string()))
}

fn array<'a, 'i>(value: &'a Value<'i>) -> Result<&'a [Value<'i>]> {
    match value.get_ref() {
        DeValue::Array(array) => Ok(array),
        _ => Err(Problem(
            value.span(),
            "this must be a list: `[...]`".to_string(),
        )),
    }
}

fn table_of<'a, 'i>(value: &'a Value<'i>) -> Result<&'a DeTable<'i>> {
    let table = value.get_ref().as_table();
    table.ok_or_else(|| Problem(value.span(), "this must be a table".to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rules::RULES;

    #[track_caller]
    fn wrong(text: &str, line: u32, column: u32, message: &str) {
        let error = parse(text, RULES).err();
        let error = error.map(|e| (e.line, e.column, e.message));
        assert_eq!(error, Some((line, column, message.to_string())));
    }

    #[test]
    fn mistakes_have_places() {
        wrong("x = 1", 1, 1, &unknown_key("x", &KEYS));
        wrong(
            "\ntaget = \"gpu\"",
            2,
            1,
            "unknown key `taget`; did you mean `target`?",
        );
        wrong(
            "target = \"gpus\"",
            1,
            10,
            "`gpus` is none of `swiftshader`, `gpu`; did you mean `gpu`?",
        );
        wrong(
            "[rules]\nstep-budgt = \"off\"",
            2,
            1,
            "there is no rule or group `step-budgt`; did you mean `step-budget`?",
        );
        wrong(
            "[rules]\nvector-size = \"off\"",
            2,
            1,
            "`vector-size` is a compile error, which has no level",
        );
        wrong(
            "[host.uniforms]\na = \"vec5\"",
            2,
            5,
            "`vec5` is no type of GLSL; write `float`, `vec3`, `sampler2D`, `vec4[8]`",
        );
        wrong(
            "[host.uniforms]\nlights = \"vec3[0]\"",
            2,
            10,
            "`vec3[0]` is no type of GLSL; write `float`, `vec3`, `sampler2D`, `vec4[8]`",
        );
        wrong(
            "[host.uniforms]\nsample = \"vec3\"",
            2,
            1,
            "`sample` cannot be the name of a uniform",
        );
        wrong(
            "rules.step-budget.loop = -1",
            1,
            19,
            &unknown_key("loop", &["main", "shadow", "sum", "level", "fail"]),
        );
        wrong("include = \"a\"", 1, 11, "this must be a list: `[...]`");
        assert!(parse("a = ", RULES).is_err());
    }

    #[test]
    fn levels_and_hosts_are_read() {
        let text = "target = \"gpu\"\n[host]\npreset = \"three\"\nuniforms = { uTime = \"float\", on = \"bool\", lights = \"vec3[4]\" }\n\
            [rules]\nbudget = \"info\"\nstep-budget = \"off\"\n[[overrides]]\npaths = [\"a/**\"]\nrules = { numeric = \"off\" }";
        let config = parse(text, RULES).unwrap();
        assert_eq!(config.base.target, Some(Renderer::Gpu));
        assert_eq!(config.base.levels.last(), Some(&("step-budget", None)));
        let uniforms = config.base.host.unwrap().uniforms;
        let uniforms: Vec<_> = uniforms
            .iter()
            .map(|u| (&*u.name, &*u.ty, u.size))
            .collect();
        assert_eq!(
            uniforms,
            [
                ("lights", "vec3", Some(4)),
                ("on", "bool", None),
                ("uTime", "float", None)
            ]
        );
        assert!(config.overrides[0].0.is_match("a/b/c.glsl"));
    }

    #[test]
    fn patterns_are_those_of_gitignore() {
        let config = parse("exclude = [\"old\", \"a/*.glsl\", \"/top.frag\"]", RULES).unwrap();
        let excluded = config.exclude.unwrap();
        for path in ["old/x.glsl", "b/old/c/x.glsl", "a/x.glsl", "top.frag"] {
            assert!(excluded.is_match(path), "{path}");
        }
        for path in ["older/x.glsl", "a/b/x.glsl", "b/top.frag", "c/a/x.glsl"] {
            assert!(!excluded.is_match(path), "{path}");
        }
    }
}
