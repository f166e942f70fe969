//! The table `rules`: serde reads it as a map, because the options and their types depend on the
//! rule.

use super::mistake::{Mistake, none_of, unknown_key};
use super::word_or::WordOr;
use crate::config::layer::Adjustment;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use shaderlint_diagnostic::{ERRORS, Severity};
use shaderlint_lint::{Failing, OptionValue, Reach, Rule, RuleOption, nearest_rule};
use shaderlint_rules::RULES;
use std::collections::BTreeMap;
use toml::{Spanned, Value};

/// Settings of rules and groups, by name.
#[derive(Deserialize, Default)]
pub struct Rules(BTreeMap<Spanned<String>, WordOr<RuleLevel, RuleTable>>);

type RuleTable = BTreeMap<Spanned<String>, Spanned<Value>>;

/// The levels of rules.
pub const LEVELS: [&str; 3] = ["off", "info", "warning"];

/// Severity of findings; `None` is off.
#[derive(Deserialize, Clone, Copy)]
#[serde(try_from = "String")]
struct RuleLevel(Option<Severity>);

impl TryFrom<String> for RuleLevel {
    type Error = String;

    fn try_from(word: String) -> Result<RuleLevel, String> {
        match word.as_str() {
            "off" => Ok(RuleLevel(None)),
            "info" => Ok(RuleLevel(Some(Severity::Info))),
            "warning" => Ok(RuleLevel(Some(Severity::Warning))),
            "error" => Err(
                "rules cannot have the level `error`, which is for code that browsers \
                reject; use `{ level = \"warning\", fail = true }` to fail the run"
                    .to_string(),
            ),
            _ => Err(none_of(&word, &LEVELS)),
        }
    }
}

impl Rules {
    /// The adjustments in order: groups first, so that more specific names take precedence.
    pub fn adjustments(self) -> Result<Vec<(&'static Rule, Adjustment)>, Mistake> {
        let mut all = Vec::new();
        for (name, entry) in self.0 {
            let key = name.get_ref().as_str();
            let named = RULES.iter().filter_map(|r| Some((Reach::of(key, r)?, *r)));
            let named: Vec<(Reach, &'static Rule)> = named.collect();
            let options = match named[..] {
                [] => return Err(no_rule(&name)),
                [(Reach::Rule, rule)] => rule.options,
                _ => &[],
            };
            let adjustments: Vec<Adjustment> = match entry {
                WordOr::Word(level) => vec![Adjustment::Level(level.0)],
                WordOr::Table(table) => {
                    let entry = table.iter().map(|(k, v)| adjustment(k, v, options));
                    entry.collect::<Result<_, _>>()?
                }
            };
            for (reach, rule) in named {
                all.extend(adjustments.iter().map(|a| (reach, rule, *a)));
            }
        }
        all.sort_by_key(|(reach, ..)| *reach);
        Ok(all.into_iter().map(|(_, rule, a)| (rule, a)).collect())
    }
}

fn no_rule(name: &Spanned<String>) -> Mistake {
    let word = name.get_ref().as_str();
    let near =
        nearest_rule(RULES, word).map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    let message = match ERRORS.contains(&word) {
        true => format!("`{word}` is a compile error and has no level"),
        false => format!("unknown rule or group `{word}`{near}"),
    };
    Mistake::at(name, message)
}

/// Parses an entry of `{ level = "info", fail = true, steps = 128 }`.
fn adjustment(
    key: &Spanned<String>,
    value: &Spanned<Value>,
    options: &[RuleOption],
) -> Result<Adjustment, Mistake> {
    let name = key.get_ref().as_str();
    Ok(match name {
        "level" => Adjustment::Level(typed::<RuleLevel>(value)?.0),
        "fail" => Adjustment::Failing(match typed(value)? {
            true => Failing::Yes,
            false => Failing::No,
        }),
        _ => {
            let Some(option) = options.iter().find(|o| o.name() == name) else {
                let names = options.iter().map(|o| o.name());
                let known: Vec<&str> = names.chain(["level", "fail"]).collect();
                return Err(Mistake::at(key, unknown_key(name, &known)));
            };
            let value = match option {
                RuleOption::Count(_) => OptionValue::Count(typed(value)?),
                RuleOption::Number(_) => OptionValue::Number(amount(value)?),
                RuleOption::Switch(_) => OptionValue::Switch(typed(value)?),
            };
            Adjustment::Option(option.name(), value)
        }
    })
}

/// Deserialises a value with a known type.
fn typed<T: DeserializeOwned>(value: &Spanned<Value>) -> Result<T, Mistake> {
    let read = T::deserialize(value.get_ref().clone());
    read.map_err(|e| Mistake::at(value, Mistake::from(e).message))
}

fn amount(value: &Spanned<Value>) -> Result<f64, Mistake> {
    let number: f64 = typed(value)?;
    let is_amount = number.is_finite() && number >= 0.0;
    let wrong = || Mistake::at(value, "expected a non-negative number".to_string());
    is_amount.then_some(number).ok_or_else(wrong)
}
