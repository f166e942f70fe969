//! Which rules run, how bad their findings are, and the numbers that they go by.

use super::{Group, Rule};
use crate::diagnostic::{ERRORS, Severity};
use rustc_hash::FxHashMap;

/// What draws the shader in the end, which decides how much work a pixel may take.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Target {
    /// A renderer on the processor, as headless browsers have.
    #[default]
    SwiftShader,
    /// A graphics card.
    Gpu,
}

/// How the linter is set.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The rules that run, and how bad their findings are.
    levels: FxHashMap<&'static str, Severity>,
    /// By rule and option, where it differs from what the rule goes by otherwise.
    options: FxHashMap<(&'static str, &'static str), f64>,
    /// What draws the shader.
    pub target: Target,
}

/// A name that is neither a rule's nor a group's.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownRule {
    /// The name.
    pub name: String,
    /// A rule or group of a name like it.
    pub near: Option<&'static str>,
}

impl Settings {
    /// The rules that run by default, with those of `select` added and those of `ignore` taken
    /// away. Each word names a rule or a group; `all` names every rule.
    pub fn new(
        rules: &[&'static Rule],
        select: &[String],
        ignore: &[String],
    ) -> Result<Settings, UnknownRule> {
        let mut settings = Settings {
            levels: FxHashMap::default(),
            options: FxHashMap::default(),
            target: Target::default(),
        };
        for rule in rules.iter().filter(|r| r.default) {
            settings.set_level(rule, Some(rule.severity));
        }
        settings.adjust(rules, select, ignore)?;
        Ok(settings)
    }

    /// Adds the rules that `select` names to those that run, and takes those of `ignore` away.
    pub fn adjust(
        &mut self,
        rules: &[&'static Rule],
        select: &[String],
        ignore: &[String],
    ) -> Result<(), UnknownRule> {
        for word in select {
            for rule in named(rules, word)? {
                self.levels.entry(rule.name).or_insert(rule.severity);
            }
        }
        for word in ignore {
            for rule in named(rules, word)? {
                self.set_level(rule, None);
            }
        }
        Ok(())
    }

    /// No rule but one of those chosen.
    pub fn only(mut self, name: &str) -> Settings {
        self.levels.retain(|r, _| *r == name);
        self
    }

    /// Sets how bad the findings of a rule are; `None` turns it off.
    pub fn set_level(&mut self, rule: &Rule, level: Option<Severity>) {
        match level {
            Some(level) => self.levels.insert(rule.name, level),
            None => self.levels.remove(rule.name),
        };
    }

    /// Sets a number that a rule goes by. Says whether the rule has such a number.
    pub fn set_option(&mut self, rule: &Rule, option: &str, value: f64) -> bool {
        let known = rule.options.iter().find(|o| o.name == option);
        if let Some(known) = known {
            self.options.insert((rule.name, known.name), value);
        }
        known.is_some()
    }

    /// How bad the findings of a rule are; `None` where it does not run.
    pub fn level(&self, rule: &Rule) -> Option<Severity> {
        self.levels.get(rule.name).copied()
    }

    /// A number that a rule goes by.
    pub fn option(&self, rule: &Rule, option: &str) -> f64 {
        let Some(known) = rule.options.iter().find(|o| o.name == option) else {
            return 0.0;
        };
        let set = self.options.get(&(rule.name, known.name)).copied();
        set.unwrap_or(match self.target {
            Target::SwiftShader => known.default,
            Target::Gpu => known.on_gpu,
        })
    }
}

/// The rules that a word names.
fn named(rules: &[&'static Rule], word: &str) -> Result<Vec<&'static Rule>, UnknownRule> {
    let found: Vec<&'static Rule> = rules
        .iter()
        .filter(|r| word == "all" || r.name == word || r.group.name() == word)
        .copied()
        .collect();
    // Compile errors have names too, but cannot be chosen or left out.
    if !found.is_empty() || Group::ALL.iter().any(|g| g.name() == word) || ERRORS.contains(&word) {
        return Ok(found);
    }
    Err(UnknownRule {
        name: word.to_string(),
        near: nearest_rule(rules, word),
    })
}

/// The rule or group whose name is most like a word, if one is like it.
pub fn nearest_rule(rules: &[&'static Rule], word: &str) -> Option<&'static str> {
    rules
        .iter()
        .map(|r| r.name)
        .chain(Group::ALL.iter().map(|g| g.name()))
        .map(|n| (strsim::damerau_levenshtein(n, word), n))
        .filter(|(distance, _)| *distance <= 3)
        .min()
        .map(|(_, n)| n)
}
