//! `explain` and `rules`: the documentation of rules and compile errors.

use serde_json::{Value, json};
use shaderlint_diagnostic::{ERRORS, Severity};
use shaderlint_host::{Preset, names as host_names, preset};
use shaderlint_lint::{OptionValue, Page, Renderer};
use shaderlint_report::RulePage;
use shaderlint_rules::{RULES, error_page, page};

/// The documentation of a rule, compile error or host. Words that are not a name list the pages that
/// contain all of them.
///
/// # Errors
/// If no page contains them, with a message.
pub fn explain(words: &[String]) -> Result<String, String> {
    let name = words.join(" ");
    if let Some(page) = page_named(&name) {
        return Ok(page);
    }
    match search(words).as_slice() {
        [] => Err(unknown(&name)),
        [one] => Ok(page_named(one).unwrap_or_default()),
        several => Ok(summaries(several)),
    }
}

/// The page of a rule, compile error or host.
fn page_named(name: &str) -> Option<String> {
    let host = || preset(name).map(Preset::page);
    page(name).map(str::to_string).or_else(host)
}

/// The names of all pages.
fn names() -> impl Iterator<Item = &'static str> {
    let names = RULES.iter().map(|r| r.name).chain(ERRORS.iter().copied());
    names.chain(host_names())
}

/// The names that contain all words; if there are none, those of the pages whose text does.
fn search(words: &[String]) -> Vec<&'static str> {
    let words: Vec<String> = words.iter().map(|w| w.to_lowercase()).collect();
    let has_all = |text: &str| {
        let text = text.to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let named: Vec<&str> = names().filter(|name| has_all(name)).collect();
    if !named.is_empty() {
        return named;
    }
    let is_about = |name: &&str| page(name).is_some_and(has_all);
    names().filter(is_about).collect()
}

/// A line for each page: name and summary.
fn summaries(names: &[&str]) -> String {
    let width = names.iter().map(|n| n.len()).max().unwrap_or(0);
    let mut text = String::new();
    for name in names {
        let summary = page(name).map_or_else(String::new, |p| Page::new(p).summary);
        text.push_str(format!("{name:width$}  {summary}").trim_end());
        text.push('\n');
    }
    text
}

/// The page as SARIF shows it.
pub fn rule_page(name: &str) -> Option<RulePage> {
    let text = page(name)?;
    Some(RulePage {
        summary: Page::new(text).summary,
        body: text.split_once('\n').map_or("", |(_, body)| body).trim(),
    })
}

fn unknown(name: &str) -> String {
    let distances = names().map(|n| (strsim::damerau_levenshtein(n, name), n));
    let near = distances.filter(|(d, _)| *d <= 3).min();
    let near = near.map_or(String::new(), |(_, n)| format!("; did you mean `{n}`?"));
    format!("unknown rule, compile error or host `{name}`{near}")
}

/// A table of all rules: name, group, default severity, summary.
pub fn rule_table() -> String {
    let width = RULES.iter().map(|r| r.name.len()).max().unwrap_or(0);
    let mut sorted = RULES.to_vec();
    sorted.sort_by_key(|r| (r.group, r.name));
    let mut text = String::new();
    for rule in sorted {
        let level = if rule.is_default() {
            rule.severity.name()
        } else {
            "off"
        };
        let summary = Page::new(rule.page).summary;
        let (name, group) = (rule.name, rule.group.name());
        text.push_str(&format!(
            "{name:width$}  {group:11}  {level:7}  {summary}\n"
        ));
    }
    text
}

fn json_of(value: OptionValue) -> Value {
    match value {
        OptionValue::Count(value) => json!(value),
        OptionValue::Number(value) => json!(value),
        OptionValue::Switch(value) => json!(value),
    }
}

/// All rules and compile errors, with their options, as JSON.
pub fn rule_list() -> Value {
    let rules = RULES.iter().map(|rule| {
        let options = rule.options.iter().map(|o| {
            let [default, on_swiftshader] =
                [Renderer::Gpu, Renderer::SwiftShader].map(|t| json_of(o.usual(t)));
            json!({"name": o.name(), "about": o.about(), "default": default, "on_swiftshader": on_swiftshader})
        });
        json!({
            "name": rule.name,
            "kind": "rule",
            "group": rule.group.name(),
            "severity": rule.severity.name(),
            "default": rule.is_default(),
            "preset": rule.preset.name(),
            "summary": Page::new(rule.page).summary,
            "options": options.collect::<Vec<_>>(),
            "page": format!("rules/{}.md", rule.name.replace('-', "_"))
        })
    });
    let errors = ERRORS.iter().map(|name| {
        json!({
            "name": name,
            "kind": "error",
            "group": null,
            "severity": Severity::Error.name(),
            "default": true,
            "summary": error_page(name).map(|p| Page::new(p).summary),
            "options": [],
            "page": format!("rules/errors/{name}.md")
        })
    });
    let all: Vec<Value> = rules.chain(errors).collect();
    json!({"schema": 1, "rules": all})
}
