//! Reads a configuration. Every error in it has a position.

mod file;
mod mistake;
mod rules;
mod schema;
mod word_or;

pub use schema::schema;

use super::layer::{Config, Layer};
use crate::options::TargetVersion;
use file::{ConfigFile, HostEntry, Patterns};
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

fn config(file: ConfigFile) -> Result<Config, Mistake> {
    let overrides = file.overrides.into_iter().map(|own| {
        let layer = Layer {
            preset: own.preset,
            info: own.info,
            target: own.target,
            target_version: own.target_version.map(TargetVersion::version),
            run_samples: own.run_samples,
            dialect: own.dialect,
            desktop: own.desktop,
            host: own.host.map(HostEntry::names).transpose()?,
            include_roots: own.include_roots,
            format: own.format.choice()?,
            rules: own.rules.adjustments()?,
        };
        Ok((own.paths.globs()?, layer))
    });
    Ok(Config {
        overrides: overrides.collect::<Result<_, Mistake>>()?,
        base: Layer {
            preset: file.preset,
            info: file.info,
            target: file.target,
            target_version: file.target_version.map(TargetVersion::version),
            run_samples: file.run_samples,
            dialect: file.dialect,
            desktop: file.desktop,
            host: file.host.map(HostEntry::names).transpose()?,
            include_roots: file.include_roots,
            format: file.format.choice()?,
            rules: file.rules.adjustments()?,
        },
        include: file.include.map(Patterns::globs).transpose()?,
        exclude: file.exclude.map(Patterns::globs).transpose()?,
        ..Config::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::{Adjustment, style};
    use shaderlint_format::{Brace, Indentation, StyleChoice};
    use shaderlint_lint::Renderer;

    #[track_caller]
    fn wrong(text: &str, line: u32, column: u32, message: &str) {
        let error = parse(text).err();
        let error = error.map(|e| (e.line, e.column, e.message));
        assert_eq!(error, Some((line, column, message.to_string())));
    }

    #[test]
    fn configuration_errors_have_positions() {
        wrong(
            "x = 1",
            1,
            1,
            "unknown key `x`; expected one of `preset`, `info`, `target`, `target-version`, `run_samples`, `dialect`, `desktop`, `host`, `format`, `rules`, \
             `include`, `include_roots`, `exclude`, `overrides`",
        );
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
            "unknown value `gpus`; expected one of `swiftshader`, `gpu`; did you mean `gpu`?",
        );
        wrong(
            "[rules]\nstep-budgt = \"off\"",
            2,
            1,
            "unknown rule or group `step-budgt`; did you mean `step-budget`?",
        );
        wrong(
            "[rules]\nvector-size = \"off\"",
            2,
            1,
            "`vector-size` is a compile error and has no level",
        );
        wrong(
            "[host.uniforms]\na = \"vec5\"",
            2,
            5,
            "`vec5` is not a GLSL type; use `float`, `vec3`, `sampler2D`, `vec4[8]`",
        );
        wrong(
            "[host.uniforms]\nlights = \"vec3[0]\"",
            2,
            10,
            "`vec3[0]` is not a GLSL type; use `float`, `vec3`, `sampler2D`, `vec4[8]`",
        );
        wrong(
            "[host.uniforms]\nsample = \"vec3\"",
            2,
            1,
            "`sample` is not a valid uniform name",
        );
        wrong(
            "rules.step-budget.loop = -1",
            1,
            19,
            "unknown key `loop`; expected one of `main`, `shadow`, `sum`, `level`, `fail`",
        );
        wrong(
            "exclude = [\"a\", \"[\"]",
            1,
            17,
            "invalid pattern `[`: unclosed character class; missing ']'",
        );
        wrong("include_roots = [1]", 1, 18, "expected a string");
        assert!(parse("a = ").is_err());
    }

    /// Messages use the names of TOML types, not those of serde.
    #[test]
    fn type_errors_name_toml_types() {
        wrong("target = 3", 1, 10, "expected a string");
        wrong("include_roots = [1]", 1, 18, "expected a string");
        wrong("include = \"a\"", 1, 11, "expected a list: `[...]`");
        wrong("overrides = [1]", 1, 14, "expected a table");
        wrong("host.uniforms = []", 1, 17, "expected a table");
        wrong(
            "rules = { tidy = 1 }",
            1,
            18,
            "expected a string or a table",
        );
        wrong("rules.tidy.fail = 1", 1, 19, "expected `true` or `false`");
        wrong(
            "rules.step-budget.main = -1",
            1,
            26,
            "expected a non-negative integer",
        );
        for value in ["-1.5", "inf", "\"a\""] {
            wrong(
                &format!("rules.mediump-noise.factor = {value}"),
                1,
                30,
                "expected a non-negative number",
            );
        }
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
        wrong(
            "format.indent = 0",
            1,
            17,
            "expected a number from 1 to 16, or `\"tab\"`",
        );
        wrong(
            "format.width = 5",
            1,
            16,
            "expected a number from 20 to 1000",
        );
        wrong(
            "format.brace = \"nxt\"",
            1,
            16,
            "unknown value `nxt`; expected one of `same`, `next`; did you mean `next`?",
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
