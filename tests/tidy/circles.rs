//! No two files depend on each other, directly or indirectly: each can be read after the files that
//! it uses.

use super::code::Crate;
use super::{crates, files};
use std::collections::{BTreeMap, BTreeSet};

/// The files of each remaining dependency cycle. This list must only become shorter.
const LEFT: &[&[&str]] = &[
    &["fuzz/src/main.rs", "fuzz/src/throw.rs"],
    &[
        "src/play/project/channel.rs",
        "src/play/project/mod.rs",
        "src/play/project/sound.rs",
        "src/play/project/target.rs",
    ],
    &["src/exec/vm/mod.rs", "src/exec/vm/watch.rs"],
    &[
        "src/flow/ranges/back.rs",
        "src/flow/ranges/mod.rs",
        "src/flow/ranges/reason.rs",
        "src/flow/ranges/solve.rs",
    ],
    &[
        "src/lint/context.rs",
        "src/lint/facts.rs",
        "src/lint/march/hit.rs",
        "src/lint/option.rs",
        "src/lint/rule.rs",
        "src/lint/sample/bench.rs",
        "src/lint/sample/culprit.rs",
        "src/lint/sample/mod.rs",
        "src/lint/sample/more_iterations.rs",
        "src/lint/sample/pixels.rs",
        "src/lint/sample/verdict.rs",
        "src/lint/settings.rs",
    ],
    &[
        "src/project/dialect/bind.rs",
        "src/project/dialect/bookofshaders.rs",
        "src/project/dialect/clues.rs",
        "src/project/dialect/complete.rs",
        "src/project/dialect/isf.rs",
        "src/project/dialect/kodelife.rs",
        "src/project/dialect/kodi.rs",
        "src/project/dialect/mod.rs",
        "src/project/dialect/shadertoy.rs",
        "src/project/dialect/three.rs",
        "src/project/dialect/twigl.rs",
        "src/project/dialect/vertex.rs",
        "src/project/dialect/vertexshaderart.rs",
        "src/project/dialect/vscode.rs",
        "src/project/media/mod.rs",
        "src/project/media/stock.rs",
        "src/project/project.rs",
    ],
    &[
        "src/port/naga/body.rs",
        "src/port/naga/function.rs",
        "src/port/naga/global.rs",
        "src/port/naga/lower.rs",
        "src/port/naga/port.rs",
        "src/port/naga/sampler.rs",
        "src/port/naga/special.rs",
        "src/port/naga/stored.rs",
        "src/port/naga/types.rs",
        "src/port/naga/uniform.rs",
    ],
    &[
        "src/syntax/parser/correction.rs",
        "src/syntax/parser/mod.rs",
    ],
    &[
        "src/syntax/preprocessor/directive_repair.rs",
        "src/syntax/preprocessor/input.rs",
        "src/syntax/preprocessor/macros.rs",
        "src/syntax/preprocessor/mod.rs",
        "src/syntax/preprocessor/number.rs",
    ],
];

/// The remaining cycles between entries of a folder, of which one at least is a folder itself. This
/// list must only become shorter.
const LEFT_OF_FOLDERS: &[&[&str]] = &[
    &["src/flow/reaching_definitions/", "src/flow/same.rs"],
    &[
        "src/lint/context.rs",
        "src/lint/facts.rs",
        "src/lint/march/",
        "src/lint/option.rs",
        "src/lint/rule.rs",
        "src/lint/sample/",
        "src/lint/settings.rs",
    ],
    &[
        "src/project/dialect/",
        "src/project/media/",
        "src/project/project.rs",
    ],
    &["src/explain/root_cause/", "src/explain/single_pass.rs"],
    // The problems are listed in one enum.
    &["src/semantic/checker/", "src/semantic/problem.rs"],
    &["src/syntax/parser/", "src/syntax/translation/"],
];

type Arrows<'a> = BTreeMap<&'a str, BTreeSet<&'a str>>;

/// All files that a file depends on, directly or indirectly.
fn reached<'a>(arrows: &Arrows<'a>, from: &str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&str> = arrows.get(from).into_iter().flatten().copied().collect();
    while let Some(file) = open.pop() {
        if reached.insert(file) {
            open.extend(arrows.get(file).into_iter().flatten());
        }
    }
    reached
}

/// The strongly connected components with more than one file.
fn circles<'a>(arrows: &Arrows<'a>) -> BTreeSet<Vec<&'a str>> {
    let reached_by = arrows.keys().map(|file| (*file, reached(arrows, file)));
    let all: BTreeMap<&str, BTreeSet<&str>> = reached_by.collect();
    let with = |file: &str| {
        let there = all[file].iter().copied();
        let back = there.filter(|to| all.get(to).is_some_and(|back| back.contains(file)));
        back.collect::<Vec<&str>>()
    };
    let circles = all.keys().map(|file| with(file));
    circles.filter(|circle| circle.len() > 1).collect()
}

/// The dependencies between the entries of each folder: its folders, each with all that is in it,
/// and its files, without the one that declares them as modules.
fn folder_arrows<'a>(arrows: &Arrows<'a>) -> Arrows<'a> {
    let mut found = Arrows::new();
    let pairs = arrows
        .iter()
        .flat_map(|(from, to)| to.iter().map(|to| (*from, *to)));
    for (from, to) in pairs {
        let parts = from.split_inclusive('/').zip(to.split_inclusive('/'));
        let shared = parts
            .take_while(|(a, b)| a == b)
            .map(|(a, _)| a.len())
            .sum();
        let entry = |file: &'a str| match file[shared..].find('/') {
            Some(end) => &file[..=shared + end],
            None => file,
        };
        let is_list = |entry: &str| ["mod.rs", "lib.rs", "main.rs"].contains(&&entry[shared..]);
        let (from, to) = (entry(from), entry(to));
        if !is_list(from) && !is_list(to) {
            found.entry(from).or_default().insert(to);
        }
    }
    found
}

/// What differs between the cycles that are there and those that are listed.
fn differences(arrows: &Arrows, found: &BTreeSet<Vec<&str>>, left: &[&[&str]]) -> Vec<String> {
    let is_listed = |circle: &&Vec<&str>| left.contains(&circle.as_slice());
    let new = found.iter().filter(|circle| !is_listed(circle));
    let old = left.iter().filter(|circle| !found.contains(**circle));
    let old = old.map(|circle| format!("not a cycle any more: {}", circle.join(" ")));
    new.map(|circle| describe(circle, arrows))
        .chain(old)
        .collect()
}

#[test]
fn files_and_folders_have_no_new_dependency_cycles() {
    let all = files(&["src", "rules", "fuzz"], ".rs");
    let folders = crates();
    let mut arrows = Arrows::new();
    for folder in &folders {
        arrows.extend(Crate::new(folder, &folders, &all).arrows());
    }
    let count: usize = arrows.values().map(BTreeSet::len).sum();
    assert!(count > 2000, "{count} dependencies");
    let mut wrong = differences(&arrows, &circles(&arrows), LEFT);
    let arrows = folder_arrows(&arrows);
    let mut found = circles(&arrows);
    found.retain(|circle| circle.iter().any(|entry| entry.ends_with('/')));
    wrong.extend(differences(&arrows, &found, LEFT_OF_FOLDERS));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn describe(circle: &[&str], arrows: &Arrows) -> String {
    let mut text = format!("a dependency cycle of {}:", circle.len());
    for from in circle {
        for to in arrows[from].iter().filter(|to| circle.contains(to)) {
            text += &format!("\n    {from} -> {to}");
        }
    }
    text
}

/// The dependency cycles of a crate with these files.
fn circles_of(texts: &[(&str, &str)]) -> Vec<Vec<String>> {
    let file = |(name, text): &(&str, &str)| (format!("a/{name}.rs"), text.to_string());
    let files: Vec<(String, String)> = texts.iter().map(file).collect();
    let read = Crate::new("a", &[], &files);
    let found = circles(&read.arrows()).into_iter();
    found
        .map(|circle| circle.into_iter().map(str::to_string).collect())
        .collect()
}

#[test]
fn cycles_are_found_in_every_spelling() {
    let two = [vec!["a/b.rs".to_string(), "a/c.rs".to_string()]];
    let lib = ("lib", "mod b;\nmod c;\npub use b::B;\npub use c::C;\n");
    let b = ("b", "use super::c::C;\npub struct B;\n");
    for naming in [
        "use crate::b::B;",
        "use crate::{B, b::{self as way, more::More}};",
        "use super::{b::{deep::Deep, B}};",
        "use super::b; fn f(_: b::B) {}",
        "use crate::B;",
        "fn f(_: crate::b::B) {}",
        "fn f() { super::b::go(\"\\\"\") }",
    ] {
        assert_eq!(circles_of(&[lib, b, ("c", naming)]), two, "{naming}");
    }
    for naming in [
        "// use crate::b::B;",
        "const A: &str = \"use crate::b::B;\";",
        "#[cfg(test)]\nmod tests { use super::super::b::B; }",
        "use other::b::B;",
        "use super::b;",
    ] {
        assert_eq!(circles_of(&[lib, b, ("c", naming)]).len(), 0, "{naming}");
    }
}

#[test]
fn cycles_between_folders_are_found() {
    // Only the file of the modules and a file in a folder depend on each other.
    let pairs = [
        ("a/b/one.rs", "a/c/deep/two.rs"),
        ("a/c/three.rs", "a/b/four.rs"),
        ("a/b/four.rs", "a/d.rs"),
        ("a/mod.rs", "a/b/one.rs"),
        ("a/b/one.rs", "a/mod.rs"),
        ("a/b/one.rs", "a/b/four.rs"),
    ];
    let mut arrows = Arrows::new();
    for (from, to) in pairs {
        arrows.entry(from).or_default().insert(to);
    }
    assert!(
        circles(&arrows)
            .iter()
            .all(|circle| circle.contains(&"a/mod.rs"))
    );
    let found = circles(&folder_arrows(&arrows));
    assert_eq!(found, BTreeSet::from([vec!["a/b/", "a/c/"]]));
    let left: &[&[&str]] = &[&["a/b/", "a/c/"]];
    let listed = |left| differences(&folder_arrows(&arrows), &found, left).len();
    assert_eq!(
        (listed(left), listed(&[]), listed(&[&["a/b/", "a/d/"]])),
        (0, 1, 2)
    );
}
