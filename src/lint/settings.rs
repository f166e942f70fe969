//! Settings: which rules run, the severity of their findings, and their options.

use super::option::{OptionType, OptionValue, Setting};
use super::rule::{Group, Rule, RulePreset, rule_name};
use super::sample::SampleLimit;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};
use shaderlint_diagnostic::{ERRORS, Severity};
use shaderlint_syntax::Version;

/// The renderer that a shader is written for, which determines how much a pixel may cost.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Renderer {
    /// A software renderer, as in headless browsers.
    SwiftShader,
    /// A GPU.
    #[default]
    Gpu,
}

impl Renderer {
    /// The default severity of a rule. A software renderer that exceeds its time shows nothing, so rules
    /// with limits of their own for it are warnings there.
    fn level(self, rule: &Rule) -> Severity {
        let is_limited = || rule.options.iter().any(|o| o.depends_on_target());
        match self {
            Renderer::SwiftShader if is_limited() => rule.severity.max(Severity::Warning),
            _ => rule.severity,
        }
    }
}

/// Settings of the linter.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The rules that run, and the severity of their findings.
    levels: FxHashMap<&'static str, Severity>,
    /// By rule and option: values that the configuration sets.
    options: FxHashMap<(&'static str, &'static str), OptionValue>,
    /// The rules whose findings fail the run.
    failing: FxHashSet<&'static str>,
    /// The rules that the user turned on or gave a severity, by name, group or preset.
    asked: FxHashSet<&'static str>,
    /// Whether infos are reported that the user did not ask for.
    infos: Infos,
    /// The only names that are reported, if `--only` chose some.
    chosen: Option<FxHashSet<&'static str>>,
    target: Renderer,
    /// How much of the shader is sampled.
    sample_run: SampleLimit,
    /// The version that shaders are converted to.
    target_version: Option<Version>,
}

/// A name that is not a rule or group.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownRule {
    /// The unknown name.
    pub name: String,
    /// A rule or group with a similar name.
    pub near: Option<&'static str>,
}

impl Settings {
    /// The rules that run by default, plus those of `select`, minus those of `ignore`. Each word names a
    /// rule, a group or a preset, such as `all`.
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
            asked: FxHashSet::default(),
            infos: Infos::Shown,
            chosen: None,
            target: Renderer::default(),
            sample_run: SampleLimit::default(),
            target_version: None,
        };
        settings.set_preset(rules, RulePreset::Recommended);
        settings
    }

    /// Runs the rules of a preset and no others. Whoever chooses one beyond the default asks for its
    /// infos.
    pub fn set_preset(&mut self, rules: &[&'static Rule], preset: RulePreset) {
        for rule in rules {
            let level = self.target.level(rule);
            self.set_level(rule, preset.includes(rule).then_some(level));
        }
        if preset > RulePreset::Recommended {
            self.infos = Infos::Shown;
        }
    }

    /// Sets whether infos are reported that the user did not ask for.
    pub fn set_infos(&mut self, infos: Infos) {
        self.infos = infos;
    }

    /// Whether a finding of this name and severity is reported, and not only counted.
    pub fn shows(&self, name: &str, severity: Severity) -> bool {
        severity > Severity::Info
            || self.infos == Infos::Shown
            || self.asked.contains(name)
            || self.failing.contains(name)
    }

    /// Notes that the user asked for a rule.
    pub fn ask_for(&mut self, rule: &Rule) {
        self.asked.insert(rule.name);
    }

    /// Sets the renderer, and adapts severities that are not configured.
    pub fn set_target(&mut self, rules: &[&'static Rule], target: Renderer) {
        let before = std::mem::replace(&mut self.target, target);
        for rule in rules {
            if self.level(rule) == Some(before.level(rule)) {
                self.set_level(rule, Some(target.level(rule)));
            }
        }
    }

    /// Sets how much of the shader is sampled.
    pub fn set_sample_limit(&mut self, limit: SampleLimit) {
        self.sample_run = limit;
    }

    /// How much of the shader is sampled.
    pub fn sample_limit(&self) -> SampleLimit {
        self.sample_run
    }

    /// Sets the version that shaders are converted to.
    pub fn set_target_version(&mut self, version: Option<Version>) {
        self.target_version = version;
    }

    /// The version that shaders are converted to.
    pub fn target_version(&self) -> Option<Version> {
        self.target_version
    }

    /// Adds the rules that `select` names, and removes those of `ignore`. The more specific word wins: a
    /// rule before its group, a group before `all`. Of two equally specific words, `ignore` wins.
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
                    self.ask_for(rule);
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

    /// Reports only what these words name, including rules that are off. A word may also be a compile
    /// error.
    pub fn choose(&mut self, rules: &[&'static Rule], words: &[String]) -> Result<(), UnknownRule> {
        let mut chosen = FxHashSet::default();
        for word in words {
            chosen.extend(named(rules, word)?.iter().map(|r| r.name));
            chosen.extend(ERRORS.iter().filter(|e| *e == word));
        }
        for rule in rules {
            if chosen.contains(rule.name) {
                self.ask_for(rule);
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

    /// Sets whether findings of a rule fail the run.
    pub fn set_failing(&mut self, rule: &Rule, failing: Failing) {
        match failing {
            Failing::Yes => self.failing.insert(rule.name),
            Failing::No => self.failing.remove(rule.name),
        };
    }

    /// Whether a finding of this name fails the run, whatever its severity.
    pub fn fails(&self, name: &str) -> bool {
        self.failing.contains(name)
    }

    /// Keeps only the rule of this name.
    pub fn only(mut self, name: &str) -> Settings {
        self.levels.retain(|r, _| *r == name);
        self
    }

    /// Sets the severity of a rule; `None` turns it off.
    pub fn set_level(&mut self, rule: &Rule, level: Option<Severity>) {
        match level {
            Some(level) => self.levels.insert(rule.name, level),
            None => self.levels.remove(rule.name),
        };
    }

    /// Sets the value of an option.
    pub fn set_option(&mut self, rule: &Rule, option: &'static str, value: OptionValue) {
        self.options.insert((rule.name, option), value);
    }

    /// The severity of a rule; `None` if it does not run.
    pub fn level(&self, rule: &Rule) -> Option<Severity> {
        self.levels.get(rule.name).copied()
    }

    /// The value of an option.
    pub fn option<T: OptionType>(&self, rule: &Rule, setting: &Setting<T>) -> T {
        let set = self.options.get(&(rule.name, setting.name));
        set.and_then(|value| T::of(*value))
            .unwrap_or(setting.usual(self.target))
    }
}

/// Whether infos are reported that the user did not ask for.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Infos {
    /// They are reported.
    #[default]
    Shown,
    /// They are only counted.
    Counted,
}

/// Whether findings of a rule fail the run although they are not errors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Failing {
    /// They always fail the run.
    Yes,
    /// It depends on their severity.
    No,
}

/// How specific a word is, the least specific first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reach {
    /// The rules of a preset, such as `all`.
    All,
    /// The rules of a group.
    Group,
    /// A rule.
    Rule,
}

impl Reach {
    /// How a word names a rule; `None` if it does not.
    pub fn of(word: &str, rule: &Rule) -> Option<Reach> {
        match word {
            _ if rule_name(word) == rule.name => Some(Reach::Rule),
            _ if word == rule.group.name() => Some(Reach::Group),
            _ => {
                let preset = RulePreset::ALL.iter().find(|p| p.name() == word);
                preset.filter(|p| p.includes(rule)).map(|_| Reach::All)
            }
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
    // Compile errors have names too, but cannot be selected or ignored.
    if !found.is_empty() || Group::ALL.iter().any(|g| g.name() == word) || ERRORS.contains(&word) {
        return Ok(found);
    }
    Err(UnknownRule {
        name: word.to_string(),
        near: nearest_name(rules, word),
    })
}

/// The rule or group with the most similar name, if it is similar enough.
pub fn nearest_rule(rules: &[&'static Rule], word: &str) -> Option<&'static str> {
    let names = rules.iter().map(|r| r.name);
    nearest(names.chain(Group::ALL.iter().map(|g| g.name())), word)
}

/// The rule, group or compile error with the most similar name, if it is similar enough.
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
    fn the_more_specific_level_applies() {
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
