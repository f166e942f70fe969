//! The program around a text as evidence for its host: what the script imports, and the packages of
//! the project.

use crate::access::FileAccess;
use crate::files::Files;
use crate::files::imports::imports;
use shaderlint_host::{Preset, presets};
use shaderlint_text::path::plain;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

/// Size limit of `package.json` in bytes.
const MAX_FILE: usize = 1024 * 1024;
/// Maximum number of parent folders that are searched.
const MAX_FOLDERS: usize = 16;

/// The hosts that a script imports or uses through their globals.
pub fn imported_hosts(script: &str) -> Vec<&'static Preset> {
    let imported = imports(script);
    let uses = |p: &&Preset| {
        p.is_used_in(script) || imported.iter().any(|name| p.is_package(package_of(name)))
    };
    presets().filter(uses).collect()
}

/// The hosts among the packages of the project that contains a file.
pub fn installed_hosts(name: &str, access: FileAccess) -> Vec<&'static Preset> {
    let used = packages(name, access);
    let uses = |p: &&Preset| used.iter().any(|name| p.is_package(name));
    presets().filter(uses).collect()
}

/// The names of the package that contains a file and of its dependencies. `package.json` is
/// searched in the folder of the file and its parents, up to the root of the repository.
fn packages(name: &str, access: FileAccess) -> Arc<BTreeSet<String>> {
    let files = access.files;
    let file = plain(&files.here().join(name));
    let folder = file.parent().unwrap_or(Path::new(""));
    access.cache.packages(folder, files, || {
        let mut all = BTreeSet::new();
        for above in folder.ancestors().take(MAX_FOLDERS) {
            all.extend(names_in(files, &above.join("package.json")));
            let is_module = above.parent().is_some_and(|p| p.ends_with("node_modules"));
            if is_module || files.entry(&above.join(".git")).is_some() {
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

/// The package of an import path: `three` for `three/addons/x.js`.
fn package_of(path: &str) -> &str {
    let parts = if path.starts_with('@') { 2 } else { 1 };
    let end = path.match_indices('/').nth(parts - 1);
    end.and_then(|(at, _)| path.get(..at)).unwrap_or(path)
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
