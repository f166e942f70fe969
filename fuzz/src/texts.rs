//! The shaders that are mutated: the corpus, and the code fences of the rules' pages.

use std::fs;
use std::path::{Path, PathBuf};

/// The shaders of the corpus and of the code fences of the rules' pages.
pub fn seeds() -> Vec<String> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    walk(&top.join("corpus"), &mut paths);
    walk(&top.join("rules"), &mut paths);
    paths.sort();
    let mut seeds = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap_or_default();
        match path.extension().and_then(|e| e.to_str()) {
            Some("glsl" | "frag" | "vert" | "json") => seeds.extend(cases(&text)),
            Some("md") => seeds.extend(fences(&text)),
            _ => {}
        }
    }
    seeds
}

/// The cases of a file in `corpus/verdicts`. Any other file is a single case.
fn cases(text: &str) -> Vec<String> {
    let Some((head, rest)) = text.split_once("\n//: ") else {
        return vec![text.to_string()];
    };
    let all = std::iter::once(head).chain(rest.split("\n//: "));
    let code = all.filter_map(|case| case.split_once('\n'));
    code.map(|(_, code)| code.to_string()).collect()
}

fn fences(page: &str) -> Vec<String> {
    let parts = page.split("\n```").skip(1).step_by(2);
    let code = parts
        .filter_map(|p| p.strip_prefix("glsl"))
        .filter_map(|p| p.split_once('\n'));
    code.map(|(_, code)| code.to_string()).collect()
}

fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            walk(&path, found);
        } else {
            found.push(path);
        }
    }
}
