//! Detects the hosts that may complete a text: by the names that it lacks, by imports of the
//! surrounding script, and by the packages of its project.

use crate::check_context::CheckContext;
use crate::shader::reading::Readings;
use rustc_hash::FxHashMap;
use shaderlint_host::{Preset, presets};
use shaderlint_project::Files;
use shaderlint_project::{counts, hash};
use shaderlint_text::path::plain;
use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

/// Size limit of `package.json` in bytes.
const MAX_FILE: usize = 1024 * 1024;
/// Maximum number of parent folders that are searched.
const MAX_FOLDERS: usize = 16;
/// Maximum length of an import path in bytes.
const MAX_PATH: usize = 300;
/// Maximum number of hosts that a text is checked for.
const MAX_HOSTS: usize = 4;

/// The names of the package that contains a file and of its dependencies. `package.json` is
/// searched in the folder of the file and its parents, up to the root of the repository.
fn packages(name: &str, context: CheckContext) -> Arc<BTreeSet<String>> {
    let file = plain(&context.files.here().join(name));
    let folder = file.parent().unwrap_or(Path::new(""));
    let (files, cache) = (context.files, &context.options.file_cache);
    cache.packages(folder, files, || {
        let mut all = BTreeSet::new();
        for above in folder.ancestors().take(MAX_FOLDERS) {
            all.extend(names_in(context.files, &above.join("package.json")));
            let is_module = above.parent().is_some_and(|p| p.ends_with("node_modules"));
            if is_module || context.files.entry(&above.join(".git")).is_some() {
                break;
            }
        }
        all
    })
}

/// The names of a package and of its dependencies.
fn names_in(files: &dyn Files, file: &Path) -> Vec<String> {
    let text = files.load(file).ok();
    let Some(text) = text.filter(|t| t.len() <= MAX_FILE) else {
        return Vec::new();
    };
    let Ok(serde_json::Value::Object(package)) = serde_json::from_str(&text) else {
        return Vec::new();
    };
    let name = package.get("name").and_then(|n| n.as_str());
    let lists = ["dependencies", "peerDependencies", "devDependencies"];
    let lists = lists.iter().filter_map(|l| package.get(*l)?.as_object());
    let used = lists.flat_map(|l| l.keys().cloned());
    name.map(str::to_string).into_iter().chain(used).collect()
}

/// Detects the hosts for the texts of one file.
pub struct Hosts<'a> {
    name: &'a str,
    /// The page or script that contains the texts.
    script: Option<Arc<str>>,
    /// How often each word appears in the script, by hash; computed on first use.
    counts: OnceCell<FxHashMap<u64, usize>>,
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
        let counts = self.counts.get_or_init(|| counts(self.script()));
        if counts.get(&hash(word)).is_some_and(|all| *all > count) {
            return true;
        }
        let files = self.context.files;
        let file = plain(&files.here().join(self.name));
        let (is_elsewhere, is_all) = self
            .context
            .options
            .file_cache
            .is_elsewhere(word, &file, files);
        // Files that were not read may declare it.
        is_elsewhere || !is_all
    }

    /// Whether no host is known that may write `#version` before a text, and no program in the
    /// repository does.
    pub fn adds_no_version(&self) -> bool {
        let files = self.context.files;
        let file = plain(&files.here().join(self.name));
        self.imported().is_empty()
            && self.installed().is_empty()
            && !self.context.options.file_cache.adds_version(&file, files)
    }

    fn imported(&self) -> &[&'static Preset] {
        self.imported.get_or_init(|| {
            let script = self.script.as_deref().unwrap_or("");
            let imported = imports(script);
            let uses = |p: &&Preset| {
                p.is_used_in(script) || imported.iter().any(|name| p.is_package(package_of(name)))
            };
            presets().filter(uses).collect()
        })
    }

    fn installed(&self) -> &[&'static Preset] {
        self.installed.get_or_init(|| {
            let used = packages(self.name, self.context);
            let uses = |p: &&Preset| used.iter().any(|name| p.is_package(name));
            presets().filter(uses).collect()
        })
    }
}

/// The package of an import path: `three` for `three/addons/x.js`.
fn package_of(path: &str) -> &str {
    let parts = if path.starts_with('@') { 2 } else { 1 };
    let end = path.match_indices('/').nth(parts - 1);
    end.and_then(|(at, _)| path.get(..at)).unwrap_or(path)
}

/// The paths that a script imports or requires.
pub fn imports(script: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for word in ["from", "import", "require"] {
        for (at, _) in script.match_indices(word) {
            let after = script.get(at + word.len()..).unwrap_or("");
            let after = after.trim_start_matches([' ', '(', '\t']);
            let Some(quote) = after.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
                continue;
            };
            let path = after.get(1..).unwrap_or("");
            let mut near = path.bytes().take(MAX_PATH);
            let end = near.position(|b| b == quote as u8 || b == b'\n');
            found.extend(end.and_then(|end| path.get(..end)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imported_packages_are_found() {
        let script = "import * as T from 'three/addons/a.js'\nconst l = require( \"@luma.gl/core/x\");\
            import 'p5'; // from here";
        let names: Vec<&str> = imports(script).into_iter().map(package_of).collect();
        assert_eq!(names, ["three", "p5", "@luma.gl/core"]);
    }
}
