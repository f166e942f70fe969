//! The summary: what was checked, what was found, and where rules did not run.

use super::place::list;
use serde::{Deserialize, Serialize};
use shaderlint_diagnostic::{Diagnostic, Severity, count};
use std::collections::BTreeSet;

/// Maximum number of function names in one line.
const MAX_NAMES: usize = 5;

/// How an input was interpreted.
#[derive(Clone, PartialEq, Eq, Default, Debug, Deserialize, Serialize)]
pub struct ReadAs {
    /// The hosts of its shaders, as names that `--host` accepts.
    pub hosts: Vec<String>,
    /// A description, as `-v` prints it.
    pub read_as: String,
}

/// What was checked in one input, and what was not.
#[derive(Clone, PartialEq, Eq, Default, Debug, Deserialize, Serialize)]
pub struct Scope {
    /// Number of shaders.
    pub shaders: usize,
    /// How the input was interpreted, for the formats that print it.
    pub read_as: Option<ReadAs>,
    /// Number of shaders that rules skipped because of errors outside functions.
    pub skipped_shaders: usize,
    /// The functions that rules skipped because of errors.
    pub skipped_functions: Vec<String>,
    /// The functions of shader fragments that rules skipped because of errors or the host.
    pub open_functions: Vec<String>,
    /// Number of excerpts of shaders, which rules skip.
    pub excerpts: usize,
    /// The names that hosts have to declare for the shader fragments of this input.
    pub open_names: BTreeSet<String>,
    /// Number of findings dropped because there are too many.
    pub left_out: usize,
    /// Number of errors that `--only` hides.
    pub hidden: usize,
    /// Number of infos that are counted instead of printed.
    pub counted_infos: usize,
    /// Number of findings in the baseline.
    pub known: usize,
    /// For each finding of a rule with `fail = true`, the name of the rule.
    #[serde(skip)]
    pub failing: Vec<&'static str>,
}

/// The totals of a run.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Summary {
    /// Number of files checked.
    pub files: usize,
    /// Number of files that contain shaders.
    pub holding: usize,
    /// Number of shaders checked.
    pub shaders: usize,
    /// Number of findings with severity error.
    pub errors: usize,
    /// Number of findings with severity warning.
    pub warnings: usize,
    /// Number of findings with severity info.
    pub infos: usize,
    /// Number of findings that `--fix` would fix.
    pub fixable: usize,
    /// Number of further findings that `--unsafe-fixes` would fix.
    pub suggested: usize,
    /// Number of findings that were fixed.
    pub fixed: usize,
    /// Number of findings that were counted but not printed.
    pub left_out: usize,
    /// Number of errors that `--only` hides.
    pub hidden: usize,
    /// Number of infos that are counted instead of printed.
    pub counted_infos: usize,
    /// Number of findings in the baseline.
    pub known: usize,
    /// Number of findings of rules with `fail = true`.
    pub failing: usize,
    /// The names of these rules.
    pub failing_rules: BTreeSet<&'static str>,
    /// Number of files with shader fragments that use undeclared names.
    pub parts: usize,
    /// These names.
    pub open_names: BTreeSet<String>,
    /// Number of shaders that rules skipped.
    pub skipped_shaders: usize,
    /// The functions that rules skipped because of errors, in source order, each with its file.
    pub skipped_functions: Vec<(String, String)>,
    /// Those of shader fragments, which errors or the host prevent from being checked.
    pub open_functions: Vec<(String, String)>,
    /// Number of excerpts of shaders, which rules skip.
    pub excerpts: usize,
    /// How each input was interpreted, for the formats that print it.
    pub readings: Vec<(String, ReadAs)>,
}

/// How a caller names the options that a summary refers to.
pub struct OptionNames {
    fix: &'static str,
    unsafe_fixes: &'static str,
    /// The same, where `fix` is not mentioned.
    unsafe_alone: &'static str,
    only: &'static str,
    info: &'static str,
}

impl OptionNames {
    /// The options of the command line.
    pub const COMMAND: OptionNames = OptionNames {
        fix: "--fix",
        unsafe_fixes: "--unsafe-fixes",
        unsafe_alone: "--unsafe-fixes",
        only: "--only",
        info: "--info",
    };
    /// The parameters of tools for coding agents.
    pub const TOOL: OptionNames = OptionNames {
        fix: "the tool `fix`",
        unsafe_fixes: "its parameter `unsafe_fixes`",
        unsafe_alone: "the parameter `unsafe_fixes` of the tool `fix`",
        only: "the parameter `only`",
        info: "the parameter `info`",
    };
}

impl Summary {
    /// Counts a finding.
    pub fn add(&mut self, diagnostic: &Diagnostic) {
        match diagnostic.severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
        }
    }

    /// Adds the counts of one input.
    pub fn enter(&mut self, input: &str, scope: &Scope) {
        self.shaders += scope.shaders;
        let read_as = scope.read_as.iter().cloned();
        self.readings
            .extend(read_as.map(|r| (input.to_string(), r)));
        self.holding += usize::from(scope.shaders > 0);
        self.left_out += scope.left_out;
        self.hidden += scope.hidden;
        self.counted_infos += scope.counted_infos;
        self.known += scope.known;
        self.skipped_shaders += scope.skipped_shaders;
        self.excerpts += scope.excerpts;
        self.parts += usize::from(!scope.open_names.is_empty());
        self.open_names.extend(scope.open_names.iter().cloned());
        self.failing += scope.failing.len();
        self.failing_rules.extend(&scope.failing);
        for (all, functions) in [
            (&mut self.skipped_functions, &scope.skipped_functions),
            (&mut self.open_functions, &scope.open_functions),
        ] {
            // Several passes may contain the same function.
            let mut seen = BTreeSet::new();
            let functions = functions.iter().filter(|f| seen.insert(*f));
            all.extend(functions.map(|f| (f.to_string(), input.to_string())));
        }
    }

    /// The number of findings of all severities.
    pub fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }

    /// `2 errors, 1 warning`; empty if there are no findings.
    pub fn counts(&self) -> String {
        let found = [
            (self.errors, "error"),
            (self.warnings, "warning"),
            (self.infos, "info"),
        ];
        let found = found.iter().filter(|(n, _)| *n > 0);
        let found: Vec<String> = found.map(|(n, one)| count(*n, one)).collect();
        found.join(", ")
    }

    /// `3 fixable with --fix`, if there are any.
    fn fixes(&self, options: &OptionNames) -> Option<String> {
        let OptionNames {
            fix, unsafe_fixes, ..
        } = options;
        match (self.fixable, self.suggested) {
            (0, 0) => None,
            (0, n) => Some(format!("{n} fixable with {}", options.unsafe_alone)),
            (n, 0) => Some(format!("{n} fixable with {fix}")),
            (n, m) => Some(format!(
                "{n} fixable with {fix}, {m} more with {unsafe_fixes}"
            )),
        }
    }

    /// What was checked: `12 shaders in 9 files`.
    fn looked_at(&self) -> String {
        let shaders = match self.shaders {
            0 => "no shader".to_string(),
            n => count(n, "shader"),
        };
        match self.files {
            n if self.shaders == 0 || n == self.holding => {
                format!("{shaders} in {}", count(n, "file"))
            }
            n => format!("{shaders} in {} of {}", self.holding, count(n, "file")),
        }
    }

    /// Whether rules did not run somewhere, or names were not resolved.
    fn is_incomplete(&self) -> bool {
        self.parts > 0
            || self.skipped_shaders > 0
            || self.excerpts > 0
            || !self.skipped_functions.is_empty()
            || !self.open_functions.is_empty()
    }

    /// The lines of the summary, which name options as the caller does.
    pub fn lines(&self, options: &OptionNames) -> Vec<String> {
        if self.files == 0 {
            return Vec::new();
        }
        let found = match self.counts() {
            found if !found.is_empty() => format!("Found {found} ({})", self.looked_at()),
            _ if self.shaders == 0 => {
                format!("No shaders found in {}", count(self.files, "file"))
            }
            _ if self.is_incomplete() => {
                format!(
                    "No findings in what could be checked ({})",
                    self.looked_at()
                )
            }
            _ => format!("All checks passed ({})", self.looked_at()),
        };
        let known = (self.known > 0).then(|| format!("{} in the baseline", self.known));
        let hidden = (self.hidden > 0).then(|| {
            let hidden = count(self.hidden, "error");
            format!("{hidden} hidden by {}", options.only)
        });
        let fixed = (self.fixed > 0).then(|| format!("fixed {}", count(self.fixed, "finding")));
        let more = if self.findings() > 0 {
            "more info"
        } else {
            "info"
        };
        let infos = self.counted_infos;
        let infos = (infos > 0).then(|| format!("{}: {}", count(infos, more), options.info));
        let first: Vec<String> = [
            Some(found),
            fixed,
            known,
            hidden,
            self.fixes(options),
            infos,
        ]
        .into_iter()
        .flatten()
        .collect();
        let mut lines = vec![first.join("; ")];
        if self.failing > 0 {
            let rules: Vec<String> = self
                .failing_rules
                .iter()
                .map(|r| format!("`{r}`"))
                .collect();
            let which = count(self.failing, "finding");
            lines.push(format!(
                "Failed because of {which} of {} (`fail = true`)",
                rules.join(", ")
            ));
        }
        lines
    }

    /// The line about what rules skipped, with what helps.
    pub fn unchecked(&self) -> Option<String> {
        let functions = self.skipped_functions.len() + self.open_functions.len();
        let all = [
            (functions, "function"),
            (self.skipped_shaders, "shader"),
            (self.excerpts, "excerpt"),
        ];
        let all = all.iter().filter(|(n, _)| *n > 0);
        let all: Vec<String> = all.map(|(n, one)| count(*n, one)).collect();
        let all = match (all.is_empty(), self.parts) {
            (true, 0) => return None,
            (true, files) => count(files, "file"),
            _ => all.join(", "),
        };
        let is_open = self.parts > 0 || !self.open_functions.is_empty();
        let host = match is_open {
            true => "; set `[host]` in shaderlint.toml to check more",
            false => "",
        };
        Some(format!("Not fully checked: {all} (-v lists them){host}"))
    }

    /// The lines about functions and shaders that rules skipped.
    pub fn skipped(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let name = |(function, file): &(String, String)| match self.files {
            1 => format!("`{function}`"),
            _ => format!("`{function}` in {file}"),
        };
        for (functions, cause) in [
            (&self.skipped_functions, "with errors"),
            (&self.open_functions, "with errors or unknown names"),
        ] {
            if !functions.is_empty() {
                lines.push(format!(
                    "Rules skipped {} {cause}: {}",
                    count(functions.len(), "function"),
                    list(functions.iter().map(name), MAX_NAMES)
                ));
            }
        }
        if self.skipped_shaders > 0 {
            lines.push(format!(
                "Rules skipped {} with errors outside functions",
                count(self.skipped_shaders, "shader")
            ));
        }
        if self.excerpts > 0 {
            let excerpts = count(self.excerpts, "incomplete excerpt");
            lines.push(format!("Rules skipped {excerpts}"));
        }
        if self.parts > 0 {
            let files = match self.parts {
                1 => "1 file is a shader fragment".to_string(),
                n => format!("{n} files are shader fragments"),
            };
            let names = self.open_names.iter().map(|n| format!("`{n}`"));
            lines.push(format!(
                "{files} using names from a host: {}; set `[host]` in shaderlint.toml to check them",
                list(names, MAX_NAMES)
            ));
        }
        lines
    }
}
