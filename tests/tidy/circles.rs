//! No two files depend on each other, directly or indirectly: each can be read after the files that
//! it uses.

use super::code::Crate;
use super::{crates, files};
use std::collections::{BTreeMap, BTreeSet};

/// Remaining dependency cycles: the files of each, or folders that contain them. This list must
/// only become shorter.
const LEFT: &[&[&str]] = &[
    &["fuzz/src/main.rs", "fuzz/src/throw.rs"],
    &[
        "src/engine/lib.rs",
        "src/engine/fix.rs",
        "src/engine/verify.rs",
    ],
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
        "src/lint/option.rs",
        "src/lint/rule.rs",
        "src/lint/settings.rs",
        "src/lint/sample/bench.rs",
        "src/lint/sample/culprit.rs",
        "src/lint/march/hit.rs",
        "src/lint/sample/more_iterations.rs",
        "src/lint/sample/mod.rs",
        "src/lint/sample/pixels.rs",
        "src/lint/sample/verdict.rs",
    ],
    &[
        "src/port/dialect/",
        "src/port/media/mod.rs",
        "src/port/media/stock.rs",
        "src/port/project.rs",
        "src/port/signature.rs",
    ],
    &["src/port/naga/"],
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

#[test]
fn file_dependencies_have_no_new_cycles() {
    let all = files(&["src", "rules", "fuzz"], ".rs");
    let folders = crates();
    let mut arrows = Arrows::new();
    for folder in &folders {
        arrows.extend(Crate::new(folder, &folders, &all).arrows());
    }
    let count: usize = arrows.values().map(BTreeSet::len).sum();
    assert!(count > 1000, "{count} dependencies");
    let mut met = BTreeSet::new();
    let mut circles_left = Vec::new();
    for circle in circles(&arrows) {
        let place = |file: &&str, left: &[&'static str]| {
            let place = left.iter().find(|place| file.starts_with(**place));
            place.copied()
        };
        let is_left = |left: &&&[&'static str]| circle.iter().all(|f| place(f, left).is_some());
        match LEFT.iter().find(is_left) {
            Some(left) => met.extend(circle.iter().filter_map(|f| place(f, left))),
            None => circles_left.push(describe(&circle, &arrows)),
        }
    }
    assert!(circles_left.is_empty(), "{}", circles_left.join("\n"));
    let places = LEFT.iter().copied().flatten();
    let removed: Vec<&str> = places.filter(|p| !met.contains(*p)).copied().collect();
    assert!(
        removed.is_empty(),
        "no longer in a cycle; remove from LEFT: {}",
        removed.join(" ")
    );
}

fn describe(circle: &[&str], arrows: &Arrows) -> String {
    let mut circles_left = format!("a dependency cycle of {} files:", circle.len());
    for from in circle {
        for to in arrows[from].iter().filter(|to| circle.contains(to)) {
            circles_left += &format!("\n    {from} -> {to}");
        }
    }
    circles_left
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
