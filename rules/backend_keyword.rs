//! Names that other shading languages reserve.

use rustc_hash::FxHashMap;
use shaderlint_lint::prelude::*;
use std::sync::LazyLock;

rule! { backend_keyword, Portability, Info, Strict, [Switch(&WGSL)], Name(check) }

static WGSL: Setting<bool> =
    Setting::new("wgsl", false, "Also report names that only WGSL reserves");

/// Languages that shaders are ported to, and the words that each reserves although WebGL does not.
const LANGUAGES: &str = include_str!("backend_keyword.txt");

/// By word: the languages that reserve it.
static REFUSED_BY: LazyLock<FxHashMap<&str, Vec<&str>>> = LazyLock::new(|| {
    let mut refused_by: FxHashMap<&str, Vec<&str>> = FxHashMap::default();
    for (language, words) in LANGUAGES.lines().filter_map(|line| line.split_once(": ")) {
        for word in words.split(' ') {
            refused_by.entry(word).or_default().push(language);
        }
    }
    refused_by
});

fn check(cx: &mut Context, name: &DeclaredName) {
    let Some(refusing) = REFUSED_BY.get(name.text) else {
        return;
    };
    if *refusing == ["WGSL"] && !cx.option(&WGSL) {
        return;
    }
    cx.report(
        Extent::token(name.token),
        format!("`{}` is reserved in {}", name.text, listed(refusing)),
    )
    .note("WebGL accepts this name, but ports of the shader and some drivers do not")
    .help(format!("rename `{}`", name.text));
}

/// `a`, `a and b`, `a, b and c`.
fn listed(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => one.to_string(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
