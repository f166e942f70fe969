//! Which rules run, how bad their findings are, and what they go by.

use super::option::{OptionType, OptionValue, Setting};
use super::rule::{Group, Rule};
use super::trial::TrialLimit;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};
use shaderlint_diagnostic::{ERRORS, Severity};

/// What draws the shader in the end, which decides how much work a pixel may take.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Renderer {
    /// A renderer on the processor, as headless browsers have.
    SwiftShader,
    /// A graphics card.
    #[default]
    Gpu,
}

impl Renderer {
    /// How bad the findings of a rule are where nothing else is said. A processor that has more to do
    /// than it can shows nothing, so what passes a limit of its own is a warning there.
    fn level(self, rule: &Rule) -> Severity {
        let is_limited = || rule.options.iter().any(|o| o.depends_on_target());
        match self {
            Renderer::SwiftShader if is_limited() => rule.severity.max(Severity::Warning),
            _ => rule.severity,
        }
    }
}

/// How the linter is set.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The rules that run, and how bad their findings are.
    levels: FxHashMap<&'static str, Severity>,
    /// By rule and option, where it differs from what the rule goes by otherwise.
    options: FxHashMap<(&'static str, &'static str), OptionValue>,
    /// The rules whose findings fail the run.
    failing: FxHashSet<&'static str>,
    /// The only names that are reported, where these were chosen.
    chosen: Option<FxHashSet<&'static str>>,
    /// What draws the shader.
    target: Renderer,
    /// How much of it is run.
    trial: TrialLimit,
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
        let mut settings = Settings::of_rules(rules);
        settings.adjust(rules, select, ignore)?;
        Ok(settings)
    }

    /// The rules that run by default.
    pub fn of_rules(rules: &[&'static Rule]) -> Settings {
        let mut settings = Settings {
            levels: FxHashMap::with_capacity_and_hasher(rules.len(), FxBuildHasher),
            options: FxHashMap::default(),
            failing: FxHashSet::default(),
            chosen: None,
            target: Renderer::default(),
            trial: TrialLimit::default(),
        };
        for rule in rules.iter().filter(|r| r.default) {
            settings.set_level(rule, Some(rule.severity));
        }
        settings
    }

    /// Sets what draws the shader.
    pub fn set_target(&mut self, rules: &[&'static Rule], target: Renderer) {
        let before = std::mem::replace(&mut self.target, target);
        for rule in rules {
            if self.level(rule) == Some(before.level(rule)) {
                self.set_level(rule, Some(target.level(rule)));
            }
        }
    }

    /// Sets how much of the shader is run.
    pub fn set_trial_limit(&mut self, limit: TrialLimit) {
        self.trial = limit;
    }

    /// How much of the shader is run.
    pub fn trial_limit(&self) -> TrialLimit {
        self.trial
    }

    /// Adds the rules that `select` names to those that run, and takes those of `ignore` away. Of two
    /// words for a rule the more specific holds: its own name before its group's before `all`. Of
    /// two that are as specific, `ignore` holds.
    pub fn adjust(
        &mut self,
        rules: &[&'static Rule],
        select: &[String],
        ignore: &[String],
    ) -> Result<(), UnknownRule> {
        for word in select.iter().chain(ignore) {
            named(rules, word)?;
        }
        for rule in rules {
            let best = |words: &[String]| words.iter().filter_map(|w| Reach::of(w, rule)).max();
            match (best(select), best(ignore)) {
                (Some(selected), ignored) if Some(selected) > ignored => {
                    self.levels
                        .entry(rule.name)
                        .or_insert(self.target.level(rule));
                }
                (_, Some(_)) => self.set_level(rule, None),
                _ => {}
            }
        }
        Ok(())
    }

    /// Nothing but what these words name, rules that are off included. A word may be a compile
    /// error, too.
    pub fn choose(&mut self, rules: &[&'static Rule], words: &[String]) -> Result<(), UnknownRule> {
        let mut chosen = FxHashSet::default();
        for word in words {
            chosen.extend(named(rules, word)?.iter().map(|r| r.name));
            chosen.extend(ERRORS.iter().filter(|e| *e == word));
        }
        for rule in rules {
            if chosen.contains(rule.name) {
                self.levels
                    .entry(rule.name)
                    .or_insert(self.target.level(rule));
            } else {
                self.set_level(rule, None);
            }
        }
        self.chosen = Some(chosen);
        Ok(())
    }

    /// Whether findings of this name are reported at all.
    pub fn reports(&self, name: &str) -> bool {
        self.chosen.as_ref().is_none_or(|c| c.contains(name))
    }

    /// Lets findings of a rule fail the run, or not.
    pub fn set_failing(&mut self, rule: &Rule, failing: Failing) {
        match failing {
            Failing::Yes => self.failing.insert(rule.name),
            Failing::No => self.failing.remove(rule.name),
        };
    }

    /// Whether a finding of this name fails the run, whatever its level.
    pub fn fails(&self, name: &str) -> bool {
        self.failing.contains(name)
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

    /// Sets what a rule goes by.
    pub fn set_option(&mut self, rule: &Rule, option: &'static str, value: OptionValue) {
        self.options.insert((rule.name, option), value);
    }

    /// How bad the findings of a rule are; `None` where it does not run.
    pub fn level(&self, rule: &Rule) -> Option<Severity> {
        self.levels.get(rule.name).copied()
    }

    /// What a rule goes by.
    pub fn option<T: OptionType>(&self, rule: &Rule, setting: &Setting<T>) -> T {
        let set = self.options.get(&(rule.name, setting.name));
        set.and_then(|value| T::of(*value))
            .unwrap_or(setting.usual(self.target))
    }
}

/// Whether findings of a rule fail the run although they are no errors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Failing {
    /// They do.
    Yes,
    /// They do as their level does.
    No,
}

/// How much a word names; the less, the more it says.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reach {
    /// Every rule.
    All,
    /// The rules of a group.
    Group,
    /// A rule.
    Rule,
}

impl Reach {
    /// As what a word names a rule, if it does.
    pub fn of(word: &str, rule: &Rule) -> Option<Reach> {
        match word {
            _ if word == rule.name => Some(Reach::Rule),
            _ if word == rule.group.name() => Some(Reach::Group),
            "all" => Some(Reach::All),
            _ => None,
        }
    }
}

/// The rules that a word names.
fn named(rules: &[&'static Rule], word: &str) -> Result<Vec<&'static Rule>, UnknownRule> {
    let found: Vec<&'static Rule> = rules
        .iter()
        .filter(|r| Reach::of(word, r).is_some())
        .copied()
        .collect();
    // Compile errors have names too, but cannot be chosen or left out.
    if !found.is_empty() || Group::ALL.iter().any(|g| g.name() == word) || ERRORS.contains(&word) {
        return Ok(found);
    }
    Err(UnknownRule {
        name: word.to_string(),
        near: nearest_name(rules, word),
    })
}

/// The rule or group whose name is most like a word, if one is like it.
pub fn nearest_rule(rules: &[&'static Rule], word: &str) -> Option<&'static str> {
    let names = rules.iter().map(|r| r.name);
    nearest(names.chain(Group::ALL.iter().map(|g| g.name())), word)
}

/// The rule, group or compile error whose name is most like a word, if one is like it.
pub fn nearest_name(rules: &[&'static Rule], word: &str) -> Option<&'static str> {
    let names = rules.iter().map(|r| r.name).chain(ERRORS.iter().copied());
    nearest(names.chain(Group::ALL.iter().map(|g| g.name())), word)
}

fn nearest(names: impl Iterator<Item = &'static str>, word: &str) -> Option<&'static str> {
    names
        .filter(|n| n.len().abs_diff(word.len()) <= 3)
        .map(|n| (strsim::damerau_levenshtein(n, word), n))
        .filter(|(distance, _)| *distance <= 3)
        .min()
        .map(|(_, n)| n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example_rules::RULES;

    /// Whether `float-equality`, and `unused-parameter`, which is off by default, run.
    #[track_caller]
    fn check(select: &str, ignore: &str, expected: (bool, bool)) {
        let words = |text: &str| -> Vec<String> {
            let words = text.split(' ').filter(|w| !w.is_empty());
            words.map(str::to_string).collect()
        };
        let settings = Settings::new(RULES, &words(select), &words(ignore)).unwrap();
        let runs = |name: &str| {
            let rule = RULES.iter().find(|r| r.name == name).unwrap();
            settings.level(rule).is_some()
        };
        assert_eq!((runs("float-equality"), runs("unused-parameter")), expected);
    }

    #[test]
    fn the_more_specific_word_holds() {
        check("", "", (true, false));
        check("", "all", (false, false));
        check("float-equality", "all", (true, false));
        check("float-equality", "numeric", (true, false));
        check("numeric", "all", (true, false));
        check("all", "numeric", (false, true));
        check("all", "float-equality", (false, true));
        check("numeric", "float-equality", (false, false));
        check("float-equality tidy", "float-equality all", (false, true));
    }
}
