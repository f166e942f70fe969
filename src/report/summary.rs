//! What the last lines of a run say: what was looked at, what was found, and what was not looked at.

use shaderlint_diagnostic::{Diagnostic, Severity};
use std::collections::BTreeSet;

/// Most names in one line.
const MAX_NAMES: usize = 5;

/// What an input was read as.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct ReadAs {
    /// Who runs its shaders, by the names that `--host` takes.
    pub hosts: Vec<&'static str>,
    /// What it is, in words, as `-v` says it.
    pub read_as: String,
}

/// What was looked at in one input, and what was not.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Scope {
    /// Shaders that were read in it.
    pub shaders: usize,
    /// What it was read as, where the format says that.
    pub read_as: Option<ReadAs>,
    /// Shaders in which no rule ran, since they have errors outside their functions.
    pub unrun_shaders: usize,
    /// The functions in which no rule ran, since they have errors.
    pub unrun_functions: Vec<String>,
    /// The names that hosts have to declare for its parts of shaders.
    pub open_names: BTreeSet<String>,
    /// Findings that are not handed on, since there are too many.
    pub left_out: usize,
    /// Errors that were not asked for.
    pub hidden: usize,
    /// Findings that were there before.
    pub known: usize,
    /// Rules whose findings fail the run, by name.
    pub failing: Vec<&'static str>,
}

/// How many findings there were.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Summary {
    /// Files looked at.
    pub files: usize,
    /// Files that hold shaders.
    pub holding: usize,
    /// Shaders looked at.
    pub shaders: usize,
    /// Errors.
    pub errors: usize,
    /// Warnings.
    pub warnings: usize,
    /// Infos.
    pub infos: usize,
    /// Findings that `--fix` would mend.
    pub fixable: usize,
    /// Findings that `--unsafe-fixes` would mend besides.
    pub suggested: usize,
    /// Findings that have been mended.
    pub fixed: usize,
    /// Findings that were counted and not printed.
    pub left_out: usize,
    /// Errors that were not asked for.
    pub hidden: usize,
    /// Findings that were there before.
    pub known: usize,
    /// Findings of rules that fail the run.
    pub failing: usize,
    /// The names of those rules.
    pub failing_rules: BTreeSet<&'static str>,
    /// Files that hold parts of shaders which lack names.
    pub parts: usize,
    /// Those names.
    pub open_names: BTreeSet<String>,
    /// Shaders in which no rule ran.
    pub unrun_shaders: usize,
    /// Functions in which no rule ran, in the order of the text, and the file of each.
    pub unrun_functions: Vec<(String, String)>,
    /// The inputs, and what each was read as, where the format says that.
    pub readings: Vec<(String, ReadAs)>,
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

    /// Counts what was looked at.
    pub fn enter(&mut self, input: &str, scope: &Scope) {
        self.shaders += scope.shaders;
        let read_as = scope.read_as.iter().cloned();
        self.readings
            .extend(read_as.map(|r| (input.to_string(), r)));
        self.holding += usize::from(scope.shaders > 0);
        self.left_out += scope.left_out;
        self.hidden += scope.hidden;
        self.known += scope.known;
        self.unrun_shaders += scope.unrun_shaders;
        self.parts += usize::from(!scope.open_names.is_empty());
        self.open_names.extend(scope.open_names.iter().cloned());
        self.failing += scope.failing.len();
        self.failing_rules.extend(&scope.failing);
        // A function may stand in several passes.
        let mut seen = BTreeSet::new();
        let functions = scope.unrun_functions.iter();
        let functions: Vec<&String> = functions.filter(|f| seen.insert(*f)).collect();
        let named = functions.iter().map(|f| (f.to_string(), input.to_string()));
        self.unrun_functions.extend(named);
    }

    /// All findings.
    pub fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }

    /// `2 errors, 1 warning`; empty where nothing is found.
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

    /// `3 can be fixed with --fix`, if any can.
    pub fn fixes(&self) -> Option<String> {
        match (self.fixable, self.suggested) {
            (0, 0) => None,
            (0, n) => Some(format!("{n} can be fixed with --unsafe-fixes")),
            (n, 0) => Some(format!("{n} can be fixed with --fix")),
            (n, m) => Some(format!(
                "{n} can be fixed with --fix, {m} more with --unsafe-fixes"
            )),
        }
    }

    /// What was looked at: `12 shaders in 9 files`.
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

    /// The lines that sum up.
    pub fn lines(&self) -> Vec<String> {
        if self.files == 0 {
            return Vec::new();
        }
        let found = match self.counts() {
            found if found.is_empty() => format!("{}, no findings", self.looked_at()),
            found => format!("{}: {found}", self.looked_at()),
        };
        let known = (self.known > 0).then(|| format!("{} in the baseline", self.known));
        let hidden = (self.hidden > 0).then(|| {
            let hidden = count(self.hidden, "error");
            format!("{hidden} left out by --only")
        });
        let fixed = (self.fixed > 0).then(|| format!("{} fixed", count(self.fixed, "finding")));
        let first: Vec<String> = [fixed, Some(found), known, hidden, self.fixes()]
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
            let verb = if self.failing == 1 { "fails" } else { "fail" };
            lines.push(format!(
                "{which} of {} {verb} the run, as the configuration says",
                rules.join(", ")
            ));
        }
        lines.extend(self.unrun());
        lines
    }

    /// Where rules did not run.
    fn unrun(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let functions = &self.unrun_functions;
        if !functions.is_empty() {
            let is_one_file = self.files == 1;
            let name = |(function, file): &(String, String)| match is_one_file {
                true => format!("`{function}`"),
                false => format!("`{function}` of {file}"),
            };
            let mut names: Vec<String> = functions.iter().take(MAX_NAMES).map(name).collect();
            if functions.len() > MAX_NAMES {
                names.push(format!("{} more", functions.len() - MAX_NAMES));
            }
            lines.push(format!(
                "rules did not run in {} with errors: {}",
                count(functions.len(), "function"),
                names.join(", ")
            ));
        }
        if self.unrun_shaders > 0 {
            lines.push(format!(
                "rules did not run in {}, whose errors reach beyond one function",
                count(self.unrun_shaders, "shader")
            ));
        }
        if self.parts > 0 {
            let files = match self.parts {
                1 => "1 file is a part of a shader".to_string(),
                n => format!("{n} files are parts of shaders"),
            };
            let names = match self.open_names.len() {
                1 => "1 name comes".to_string(),
                n => format!("{n} names come"),
            };
            lines.push(format!(
                "{files}; {names} from what completes them: `[host]` in shaderlint.toml makes them checked"
            ));
        }
        lines
    }
}

/// `1 file`, `2 files`.
pub fn count(n: usize, one: &str) -> String {
    match n {
        1 => format!("1 {one}"),
        n => format!("{n} {one}s"),
    }
}
