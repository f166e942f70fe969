//! The JSON schema of the configuration, for editors.

use super::file::ConfigFile;
use super::rules::{LEVELS, Rules};
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Map, Value, json};
use shaderlint_lint::{Group, Page, Renderer, Rule, RuleOption};
use shaderlint_rules::RULES;
use std::borrow::Cow;

/// The schema, as committed in `editors/shaderlint.schema.json`.
pub fn schema() -> String {
    let settings = SchemaSettings::draft07().with(|s| s.inline_subschemas = true);
    let settings = settings.with_transform(RecursiveTransform(without_null));
    let schema = settings
        .into_generator()
        .into_root_schema_for::<ConfigFile>();
    let text = serde_json::to_string_pretty(&schema).unwrap_or_default();
    text + "\n"
}

/// TOML has no null: optional keys are omitted.
fn without_null(schema: &mut Schema) {
    if let Some(Value::Array(words)) = schema.get_mut("enum") {
        words.retain(|word| !word.is_null());
    }
    if let Some(ty) = but_null(schema, "type") {
        schema.insert("type".to_string(), ty);
    }
    if let Some(Value::Object(mut own)) = but_null(schema, "anyOf") {
        schema.remove("anyOf");
        own.append(schema.ensure_object());
        *schema = own.into();
    }
}

/// The first of two alternatives, if the other is null.
fn but_null(schema: &Schema, key: &str) -> Option<Value> {
    match schema.get(key)?.as_array()?.as_slice() {
        [some, null] if null == "null" || *null == json!({"type": "null"}) => Some(some.clone()),
        _ => None,
    }
}

impl JsonSchema for Rules {
    fn schema_name() -> Cow<'static, str> {
        "Rules".into()
    }

    /// The options of each rule.
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let groups = Group::ALL.iter().map(|g| {
            let about = format!("All rules of the group {}", g.name());
            (g.name(), either(&about, Map::new()))
        });
        let names = |r: &&'static Rule| std::iter::once(r.name).chain(r.alias());
        let rules = RULES.iter().flat_map(|r| names(r).map(|n| (n, of_rule(r))));
        let all = std::iter::once(("all", either("All rules", Map::new())));
        let properties = all.chain(groups).chain(rules);
        let properties: Map<String, Value> = properties.map(|(k, v)| (k.to_string(), v)).collect();
        json_schema!({
            "type": "object",
            "properties": properties,
            "additionalProperties": false
        })
    }
}

fn of_rule(rule: &Rule) -> Value {
    let options = rule.options.iter().map(|option| {
        let about = format!(
            "{} (default {}, on SwiftShader {})",
            option.about(),
            option.usual(Renderer::Gpu),
            option.usual(Renderer::SwiftShader)
        );
        let value = json!({"description": about, "type": type_of(*option)});
        (option.name().to_string(), value)
    });
    either(&Page::new(rule.page).summary, options.collect())
}

/// The schema of a level, or a table with options.
fn either(about: &str, mut options: Map<String, Value>) -> Value {
    let level = json!({"enum": LEVELS});
    let fail = json!({"description": "Whether findings fail the run", "type": "boolean"});
    options.insert("level".to_string(), level.clone());
    options.insert("fail".to_string(), fail);
    let table = json!({"type": "object", "properties": options, "additionalProperties": false});
    json!({"description": about, "oneOf": [level, table]})
}

/// The schema type of an option.
const fn type_of(option: RuleOption) -> &'static str {
    match option {
        RuleOption::Count(_) => "integer",
        RuleOption::Number(_) => "number",
        RuleOption::Switch(_) => "boolean",
    }
}
