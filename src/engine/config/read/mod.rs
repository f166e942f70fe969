//! Reads a configuration. Every error in it has a position.

mod file;
mod mistake;
mod rules;
mod schema;
mod word_or;

pub use schema::schema;

use super::layer::Config;
use file::{ConfigFile, Patterns};
use mistake::Mistake;
use shaderlint_text::LineIndex;

/// An error in a configuration.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigError {
    /// Line number, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Message without position.
    pub message: String,
}

/// Parses the text of a configuration.
pub fn parse(text: &str) -> Result<Config, ConfigError> {
    let file = toml::from_str(text).map_err(Mistake::from);
    file.and_then(config).map_err(|mistake| {
        let position = LineIndex::new(text).position(text, mistake.span.start as u32);
        ConfigError {
            line: position.line,
            column: position.column,
            message: mistake.message,
        }
    })
}

fn config(mut file: ConfigFile) -> Result<Config, Mistake> {
    let overrides = std::mem::take(&mut file.overrides).into_iter();
    let overrides = overrides.map(|own| Ok((own.paths.globs()?, own.layer()?)));
    Ok(Config {
        overrides: overrides.collect::<Result<_, Mistake>>()?,
        include: file.include.as_ref().map(Patterns::globs).transpose()?,
        exclude: file.exclude.as_ref().map(Patterns::globs).transpose()?,
        base: file.layer()?,
        ..Config::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::{Adjustment, style};
    use shaderlint_format::{Brace, Indentation, StyleChoice};
    use shaderlint_lint::Renderer;

    /// Messages use the names of TOML types, not those of serde.
    #[test]
    fn configuration_errors_have_positions() {
        let cases = include_str!("errors.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            let error = parse(&text.replace('↵', "\n")).err();
            let error = error.map(|e| format!("{}:{} {}", e.line, e.column, e.message));
            assert_eq!(error.as_deref(), Some(expected), "{text}");
        }
        assert!(parse("a = ").is_err());
    }

    #[test]
    fn format_styles_are_read() {
        let text = "[format]\nindent = 2\nbrace = \"next\"\n[[overrides]]\npaths = [\"a\"]\nformat.indent = \"tab\"";
        let config = parse(text).unwrap();
        let brace = Some(Brace::Next);
        let nothing = StyleChoice::default();
        let base = StyleChoice {
            indent: Some(Indentation::Spaces(2)),
            brace,
            ..nothing
        };
        assert_eq!(style(&config, &[], nothing), base);
        let other = StyleChoice {
            width: Some(80),
            brace: Some(Brace::Same),
            ..nothing
        };
        let tab = Some(Indentation::Tab(4));
        assert_eq!(
            style(&config, &[0], other),
            StyleChoice {
                indent: tab,
                brace,
                width: Some(80)
            }
        );
    }

    #[test]
    fn rule_levels_and_hosts_are_read() {
        let text = "target = \"gpu\"\n[host]\npreset = \"three\"\nuniforms = { uTime = \"float\", on = \"bool\", lights = \"vec3[4]\" }\n\
            [rules]\nbudget = \"info\"\nstep-budget = \"off\"\n[[overrides]]\npaths = [\"a/**\"]\nrules = { numeric = \"off\" }";
        let config = parse(text).unwrap();
        assert_eq!(config.base.target, Some(Renderer::Gpu));
        let (rule, adjustment) = config.base.rules.last().unwrap();
        assert_eq!(
            (rule.name, adjustment),
            ("step-budget", &Adjustment::Level(None))
        );
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
    fn patterns_work_as_in_gitignore() {
        let config = parse("exclude = [\"old\", \"a/*.glsl\", \"/top.frag\"]").unwrap();
        let excluded = config.exclude.unwrap();
        for path in ["old/x.glsl", "b/old/c/x.glsl", "a/x.glsl", "top.frag"] {
            assert!(excluded.is_match(path), "{path}");
        }
        for path in ["older/x.glsl", "a/b/x.glsl", "b/top.frag", "c/a/x.glsl"] {
            assert!(!excluded.is_match(path), "{path}");
        }
    }
}
