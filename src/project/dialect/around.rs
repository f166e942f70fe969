//! The program around a text as evidence for its host: what the script imports, and the packages of
//! the project.

use crate::access::FileAccess;
use crate::files::Files;
use crate::files::imports::imports;
use serde_json::Value;
use shaderlint_host::{Preset, presets};
use shaderlint_text::path::plain;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Size limit of `package.json` in bytes.
const MAX_FILE: usize = 1024 * 1024;
/// Maximum number of parent folders that are searched.
const MAX_FOLDERS: usize = 16;
/// The lists of dependencies; the first is what the program itself uses.
const DEPENDENCIES: [&str; 3] = ["dependencies", "devDependencies", "peerDependencies"];

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

/// Whether the project of a file names its packages, and none has chunks that shaders include.
pub fn has_no_chunks(name: &str, access: FileAccess) -> bool {
    let has_chunks = |p: &&Preset| p.base.is_some() || p.chunk_library().is_some();
    !packages(name, access).is_empty() && !installed_hosts(name, access).iter().any(has_chunks)
}

/// The release of a package with versions `0.RELEASE.PATCH` for a file: the one that is installed, otherwise the
/// only one that its project accepts.
pub fn installed_release(name: &str, package: &str, access: FileAccess) -> Option<u32> {
    let files = access.files;
    let folder = folder_of(name, files);
    let in_modules = |above: &Path| above.join("node_modules").join(package);
    *access.cache.release(&in_modules(&folder), files, || {
        let above = folders(&folder, files);
        let mut installed = above.iter().filter_map(|f| manifest(files, &in_modules(f)));
        let manifests: Vec<_> = above.iter().filter_map(|f| manifest(files, f)).collect();
        let is_own = |m: &&Value| m.get("name").is_some_and(|name| name == package);
        let own = || manifests.iter().find(is_own).cloned();
        if let Some(found) = installed.next().or_else(own) {
            return release(found.get("version")?.as_str()?);
        }
        let mut ranges = manifests
            .iter()
            .map(|m| DEPENDENCIES.map(|l| m.get(l)?.get(package)));
        let ranges = ranges.find(|all| all.iter().any(Option::is_some))?;
        ranges
            .iter()
            .flatten()
            .find_map(|range| release(range.as_str()?))
    })
}

/// Whether a script uses an installed package of a host, and neither a file of this name nor the global of a page.
pub fn uses_installed(script: &str, host: &Preset, package: &str) -> bool {
    let is_end = |rest: &str| {
        let end = rest.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '.');
        end.starts_with(['"', '\'', '`'])
    };
    let file = format!("/{package}.");
    let mut files = script.match_indices(&file);
    let has_copy = files.any(|(at, _)| script.get(at + file.len()..).is_some_and(is_end));
    let mut imported = imports(script).into_iter().map(package_of);
    !has_copy && (!host.is_used_in(script) || imported.any(|name| host.is_package(name)))
}

/// The release of a version, or the only one in a range: before 1.0.0, `^` and `~` allow one.
fn release(range: &str) -> Option<u32> {
    let version = range.trim_start_matches(['^', '~', '=', 'v']);
    let mut parts = version.strip_prefix("0.")?.splitn(2, '.');
    let middle = parts.next()?.parse().ok();
    // More than one version is a range of its own.
    let is_one = !parts.next().unwrap_or("").contains([' ', '|', '<', '>']);
    middle.filter(|_| is_one)
}

/// The names of the package that contains a file and of its dependencies. `package.json` is
/// searched in the folder of the file and its parents, up to the root of the repository.
fn packages(name: &str, access: FileAccess) -> Arc<BTreeSet<String>> {
    let files = access.files;
    let folder = folder_of(name, files);
    access.cache.packages(&folder, files, || {
        let all = folders(&folder, files).into_iter();
        let all = all.filter_map(|above| manifest(files, above));
        all.flat_map(|package| names_in(&package)).collect()
    })
}

/// The absolute path of the folder of a file.
fn folder_of(name: &str, files: &dyn Files) -> PathBuf {
    let file = plain(&files.here().join(name));
    file.parent().unwrap_or(Path::new("")).to_path_buf()
}

/// A folder and its parents, up to the root of its package in `node_modules` or of the repository.
fn folders<'f>(folder: &'f Path, files: &dyn Files) -> Vec<&'f Path> {
    let is_root = |f: &Path| {
        let is_module = f.parent().is_some_and(|p| p.ends_with("node_modules"));
        is_module || files.entry(&f.join(".git")).is_some()
    };
    let above = folder.ancestors().take(MAX_FOLDERS);
    let root = above.clone().position(is_root);
    above.take(root.map_or(MAX_FOLDERS, |at| at + 1)).collect()
}

/// The `package.json` of a folder.
fn manifest(files: &dyn Files, folder: &Path) -> Option<Value> {
    let text = files.load(&folder.join("package.json")).ok()?;
    serde_json::from_str(text.get(..MAX_FILE.min(text.len()))?).ok()
}

/// The names of a package and of its dependencies.
fn names_in(package: &Value) -> Vec<String> {
    let name = package.get("name").and_then(|n| n.as_str());
    let lists = DEPENDENCIES.iter();
    let lists = lists.filter_map(|l| package.get(*l)?.as_object());
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
