//! Documentation of built-in functions and variables, from `built_ins.txt`; and of ShaderToy's
//! uniforms, from the file of its host.

mod figure;

use figure::plot;
use rustc_hash::FxHashMap;
use shaderlint_host::shadertoy;
use std::sync::OnceLock;

/// Documentation of a name.
#[derive(Default, Debug)]
pub struct LibraryEntry {
    /// Parameter names of each overload; empty for a variable.
    pub heads: Vec<Vec<&'static str>>,
    /// Text in Markdown.
    pub text: String,
}

/// The documentation of a built-in name.
pub fn entry(name: &str) -> Option<&'static LibraryEntry> {
    static ENTRIES: OnceLock<FxHashMap<&'static str, LibraryEntry>> = OnceLock::new();
    ENTRIES
        .get_or_init(|| {
            let mut all = read(include_str!("built_ins.txt"));
            let uniforms = shadertoy().into_iter().flat_map(|p| &p.descriptions);
            for (name, description) in uniforms {
                all.entry(name).or_default().text = description.clone();
            }
            all
        })
        .get(name)
}

fn read(text: &'static str) -> FxHashMap<&'static str, LibraryEntry> {
    let mut entries: FxHashMap<&str, LibraryEntry> = FxHashMap::default();
    let mut name = "";
    for line in text.lines().filter(|l| !l.starts_with('#')) {
        match line.strip_prefix("    ") {
            Some(description) => {
                let entry = entries.entry(name).or_default();
                if let Some(line) = description.strip_prefix("plot: ") {
                    let plot = plot(line).unwrap_or_default();
                    entry.text.push_str(&format!("\n\n{plot}"));
                    continue;
                }
                if !entry.text.is_empty() {
                    entry.text.push(' ');
                }
                entry.text.push_str(description);
            }
            None if line.is_empty() => {}
            None => {
                let (head, params) = line.split_once('(').unwrap_or((line, ""));
                name = head;
                let entry = entries.entry(name).or_default();
                if let Some(params) = params.strip_suffix(')') {
                    entry.heads.push(params.split(", ").collect());
                }
            }
        }
    }
    entries
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_semantic::builtins::Builtins;
    use shaderlint_semantic::{Pass, Stage};
    use shaderlint_syntax::Version;

    #[test]
    fn every_built_in_has_a_description() {
        for version in [Version::Es100, Version::Es300] {
            for stage in [Stage::Vertex, Stage::Fragment] {
                let all = Builtins::of(version, stage);
                for overload in all.overloads() {
                    let name = overload.function.name();
                    let entry = entry(name).unwrap_or_else(|| panic!("{name}"));
                    let heads = entry.heads.iter();
                    let counts: Vec<usize> = heads.map(Vec::len).collect();
                    assert!(
                        counts.contains(&overload.params().len()),
                        "{name}: {counts:?}"
                    );
                    assert!(entry.text.len() > 20, "{name}");
                }
                for name in all.variable_names() {
                    assert!(entry(name).is_some_and(|e| e.heads.is_empty()), "{name}");
                }
            }
        }
    }

    #[test]
    fn plots_of_functions_are_drawn() {
        let lines = include_str!("built_ins.txt").lines();
        let plots: Vec<&str> = lines.filter_map(|l| l.strip_prefix("    plot: ")).collect();
        assert!(plots.len() > 15, "{}", plots.len());
        for line in plots {
            assert!(plot(line).is_some(), "{line}");
        }
        let step = plot("step(0.5, x), x from 0 to 1").unwrap();
        let rows: Vec<String> = step.lines().map(|l| l.replace('\u{2800}', " ")).collect();
        assert_eq!(rows[3], format!("1 {}{}", " ".repeat(15), "⠉".repeat(15)));
        assert_eq!(rows[7], format!("0 {}{}", "⣀".repeat(15), " ".repeat(15)));
        assert_eq!(rows[8], format!("  0{:>29}", 1));
    }

    #[test]
    fn every_shadertoy_uniform_has_a_description() {
        let mut declared = 0;
        for pass in [Pass::Image, Pass::Buffer, Pass::Cubemap, Pass::Sound] {
            let prelude = pass.host().prelude([None; 4]);
            for line in prelude.split([';', '\n']) {
                let mut words = line.trim().split([' ', '[']);
                if words.next() == Some("uniform")
                    && let Some(name) = words.nth(1).filter(|n| n.starts_with('i'))
                {
                    declared += 1;
                    assert!(entry(name).is_some(), "{name}");
                }
            }
            let main = pass.host().entry.map_or("", |e| e.name);
            assert!(entry(main).is_some(), "{main}");
        }
        assert!(declared > 30, "{declared}");
    }
}
