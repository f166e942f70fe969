//! The JSON schema of the configuration, for editors.

use super::read::{DESKTOPS, DIALECTS, LEVELS, TARGETS};
use crate::host::PRESETS;
use crate::lint::{Group, Page, Renderer, Rule, RuleOption};
use serde_json::{Map, Value, json};

/// The schema, as it is committed in `editors/shaderlint.schema.json`.
pub fn schema(rules: &[&'static Rule]) -> String {
    let globs =
        |about: &str| json!({"description": about, "type": "array", "items": {"type": "string"}});
    let types =
        "^[biu]?(vec|mat|sampler|float|int|uint|bool)[A-Za-z0-9]*( *\\[[0-9]+\\])?$|^[iu]?sampler";
    let uniforms = json!({
        "description": "Uniforms that the host declares, with their types",
        "type": "object",
        "additionalProperties": {"type": "string", "pattern": types}
    });
    let layer = json!({
        "target": {"description": "What draws the shaders in the end", "enum": TARGETS},
        "dialect": {"description": "What the shaders are written for", "enum": DIALECTS},
        "desktop": {"description": "What is said of shaders for OpenGL, Vulkan and other hosts than WebGL", "enum": DESKTOPS},
        "host": {
            "description": "What the host declares for the shaders",
            "oneOf": [
                {"enum": PRESETS},
                {
                    "type": "object",
                    "properties": {
                        "preset": {"enum": PRESETS},
                        "prelude": {"description": "A file of GLSL that describes a host, from the folder of this file", "type": "string"},
                        "uniforms": uniforms
                    },
                    "additionalProperties": false
                }
            ]
        },
        "include_roots": {
            "description": "Folders that #include searches behind that of the file, from the folder of this file",
            "type": "array",
            "items": {"type": "string"}
        },
        "rules": {
            "description": "Levels and options of rules and groups",
            "type": "object",
            "properties": names(rules),
            "additionalProperties": false
        }
    });
    let with = |more: Value| -> Value {
        let mut all = layer.as_object().cloned().unwrap_or_default();
        all.extend(more.as_object().cloned().unwrap_or_default());
        Value::Object(all)
    };
    let paths = globs("The files that it holds for, from the folder of this file");
    let overrides = json!({
        "description": "What holds for some files, the later over the earlier",
        "type": "array",
        "items": {
            "type": "object",
            "required": ["paths"],
            "properties": with(json!({"paths": paths})),
            "additionalProperties": false
        }
    });
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "shaderlint.toml",
        "type": "object",
        "properties": with(json!({
            "include": globs("The files that folders are searched for"),
            "exclude": globs("The files that are left out of folders"),
            "overrides": overrides
        })),
        "additionalProperties": false
    });
    let text = serde_json::to_string_pretty(&schema).unwrap_or_default();
    text + "\n"
}

fn names(rules: &[&'static Rule]) -> Map<String, Value> {
    let level = json!({"enum": LEVELS});
    let fail = json!({"description": "Whether its findings fail the run", "type": "boolean"});
    let table = |mut properties: Map<String, Value>| {
        properties.insert("level".to_string(), level.clone());
        properties.insert("fail".to_string(), fail.clone());
        json!({"type": "object", "properties": properties, "additionalProperties": false})
    };
    let many = |name: &str, about: String| {
        let either = [level.clone(), table(Map::new())];
        (
            name.to_string(),
            json!({"description": about, "oneOf": either}),
        )
    };
    let group = |g: &Group| many(g.name(), format!("All rules of the group {}", g.name()));
    let rule = |r: &&'static Rule| {
        let mut properties = Map::new();
        for option in r.options {
            let about = format!(
                "{} (default {}, on a GPU {})",
                option.about(),
                option.usual(Renderer::SwiftShader),
                option.usual(Renderer::Gpu)
            );
            let value = json!({"description": about, "type": type_of(*option)});
            properties.insert(option.name().to_string(), value);
        }
        let summary = Page::new(r.page).summary;
        let value = json!({"description": summary, "oneOf": [level.clone(), table(properties)]});
        (r.name.to_string(), value)
    };
    std::iter::once(many("all", "All rules".to_string()))
        .chain(Group::ALL.iter().map(group))
        .chain(rules.iter().map(rule))
        .collect()
}

/// How a schema calls the type of an option.
const fn type_of(option: RuleOption) -> &'static str {
    match option {
        RuleOption::Count(_) => "integer",
        RuleOption::Number(_) => "number",
        RuleOption::Switch(_) => "boolean",
    }
}
