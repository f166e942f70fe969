//! The files that a run tests.

use super::super::input::InputFile;
use crate::detect::kind::Claim;
use std::collections::BTreeSet;
use std::path::Path;

/// Suffix of the name of a file that tests another: `NAME.test.glsl`.
pub const TESTS: &str = ".test";

/// The inputs, and the test files that belong to files named on the command line.
pub fn with_neighbours(inputs: Vec<InputFile>) -> Vec<InputFile> {
    let mut known: BTreeSet<String> = inputs.iter().map(|i| i.name.clone()).collect();
    let mut all = Vec::new();
    for input in inputs {
        let neighbours = input.path.as_deref().filter(|_| input.is_explicit);
        let neighbours = neighbours.map_or(Vec::new(), |path| sibling_tests(path, &input.name));
        all.push(input);
        for neighbour in neighbours {
            if known.insert(neighbour.name.clone()) {
                all.push(neighbour);
            }
        }
    }
    all
}

/// The test files of a file.
fn sibling_tests(path: &Path, name: &str) -> Vec<InputFile> {
    let (Some(stem), Some(extension)) = (path.file_stem(), path.extension()) else {
        return Vec::new();
    };
    let (stem, extension) = (stem.to_string_lossy(), extension.to_string_lossy());
    let mut names = vec![
        format!("{stem}{TESTS}.{extension}"),
        format!("{stem}{TESTS}.glsl"),
    ];
    names.dedup();
    let folder = name.rsplit_once('/').map(|(folder, _)| folder);
    let found = names.into_iter().filter_map(|own| {
        let path = path.with_file_name(&own);
        path.is_file().then(|| InputFile {
            name: folder.map_or(own.clone(), |folder| format!("{folder}/{own}")),
            path: Some(path),
            is_explicit: true,
            claim: Claim::None,
        })
    });
    found.collect()
}
