//! Detects the hosts that may complete a text: by the names that it lacks, by imports of the
//! surrounding script, and by the packages of its project.

use crate::check_context::CheckContext;
use crate::shader::reading::Readings;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_host::{Preset, presets};
use shaderlint_project::{NamesForOthers, counts, hash, imported_hosts, installed_hosts};
use shaderlint_text::path::plain;
use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

/// Maximum number of hosts that a text is checked for.
const MAX_HOSTS: usize = 4;

/// Detects the hosts for the texts of one file.
pub struct Hosts<'a> {
    name: &'a str,
    /// The page or script that contains the texts.
    script: Option<Arc<str>>,
    /// How often each word appears in the script, by hash; computed on first use.
    counts: OnceCell<FxHashMap<u64, usize>>,
    /// The names that the script may declare for its shaders, by hash, and whether it puts declarations
    /// together; computed on first use.
    given: OnceCell<(FxHashSet<u64>, bool)>,
    context: CheckContext<'a>,
    /// The hosts that the script imports; computed on first use.
    imported: OnceCell<Vec<&'static Preset>>,
    /// The hosts among the packages of the project; computed on first use.
    installed: OnceCell<Vec<&'static Preset>>,
}

impl<'a> Hosts<'a> {
    /// For a file with this name, which may be a script or page.
    pub fn new(name: &'a str, script: Option<Arc<str>>, context: CheckContext<'a>) -> Hosts<'a> {
        Hosts {
            name,
            script,
            counts: OnceCell::new(),
            given: OnceCell::new(),
            context,
            imported: OnceCell::new(),
            installed: OnceCell::new(),
        }
    }

    /// The hosts that may complete a text that lacks some names: hosts that alone declare one of
    /// them, otherwise those of the script and of the project. The flag says whether the names
    /// determined the hosts.
    pub fn of(
        &self,
        lacking: &BTreeSet<String>,
        readings: &Readings,
    ) -> (Vec<&'static Preset>, bool) {
        let some = |all: &mut dyn Iterator<Item = &'static Preset>| -> Vec<_> {
            all.filter(|p| readings.may_host(p))
                .take(MAX_HOSTS)
                .collect()
        };
        let named = |p: &&Preset| lacking.iter().any(|name| p.has_word(name));
        let by_word = some(&mut presets().filter(named));
        if !by_word.is_empty() {
            return (by_word, true);
        }
        let imported = self.imported().iter();
        let installed = self.installed().iter();
        let others = installed.filter(|p| !self.imported().iter().any(|i| i.name == p.name));
        (some(&mut imported.chain(others).copied()), false)
    }

    /// The path of the file.
    pub fn name(&self) -> &'a str {
        self.name
    }

    /// The environment of the check.
    pub fn context(&self) -> CheckContext<'a> {
        self.context
    }

    /// The page or script that contains the texts; empty for shader files.
    pub fn script(&self) -> &str {
        self.script.as_deref().unwrap_or("")
    }

    /// Whether a word is used outside of a text that uses it `count` times: in the surrounding
    /// script, or in another file of the repository.
    pub fn is_used_outside(&self, word: &str, count: usize) -> bool {
        if self.is_in_script(word, count) {
            return true;
        }
        let files = self.context.files;
        let file = self.file();
        let (is_elsewhere, is_all) = self
            .context
            .options
            .file_cache
            .is_elsewhere(word, &file, files);
        // Files that were not read may declare it.
        is_elsewhere || !is_all
    }

    /// Whether something outside of a complete text that uses a word `count` times may declare it: the
    /// surrounding script, or another file of the repository. Other complete shaders declare names for
    /// themselves.
    pub fn may_be_declared_outside(&self, word: &str, count: usize) -> bool {
        let (declared, writes) = self.given.get_or_init(|| {
            let script = self.script();
            let found = NamesForOthers::of(self.name, script);
            let declared = found.declared.iter().map(|name| hash(name));
            (declared.collect(), found.writes_declarations)
        });
        if declared.contains(&hash(word)) || *writes && self.is_in_script(word, count) {
            return true;
        }
        let files = self.context.files;
        let file = self.file();
        let cache = &self.context.options.file_cache;
        cache.may_be_declared(word, &file, files)
    }

    /// Whether the script around a text that uses a word `count` times contains it too.
    pub fn is_in_script(&self, word: &str, count: usize) -> bool {
        let counts = self.counts.get_or_init(|| counts(self.script()));
        counts.get(&hash(word)).is_some_and(|all| *all > count)
    }

    /// Whether no host is known that may write `#version` before a text, and no program in the
    /// repository does.
    pub fn adds_no_version(&self) -> bool {
        let files = self.context.files;
        let file = self.file();
        self.imported().is_empty()
            && self.installed().is_empty()
            && !self.context.options.file_cache.adds_version(&file, files)
    }

    /// The absolute path of the file.
    fn file(&self) -> PathBuf {
        plain(&self.context.files.here().join(self.name))
    }

    fn imported(&self) -> &[&'static Preset] {
        self.imported.get_or_init(|| imported_hosts(self.script()))
    }

    fn installed(&self) -> &[&'static Preset] {
        let access = self.context.file_access();
        self.installed
            .get_or_init(|| installed_hosts(self.name, access))
    }
}
