//! The shaders that draw stand-ins for ShaderToy's media files.

use super::tidy::files;
use shaderlint::engine::{Options, check};
use shaderlint::port::html;
use shaderlint::project::NoFiles;
use shaderlint::project::{Generator, OutputId, Project, add_stand_ins};
use std::fs;

/// One input for each of ShaderToy's files, one of each kind with an unknown file, and the screen of
/// a host.
fn inputs() -> Vec<String> {
    let rows = fs::read_to_string("src/project/media/stock.rs").unwrap();
    let files = rows.lines().filter_map(|line| {
        let (kind, rest) = line.split_once("file(")?.1.split_once(", [\"")?;
        Some((kind.to_lowercase(), rest.split('"').next()?.to_string()))
    });
    let kinds = ["texture", "cubemap", "volume", "video", "music"];
    let unknown = kinds.map(|kind| (kind.to_string(), String::new()));
    let screen = [("texture".to_string(), OutputId::SCREEN.to_string())];
    let all = files.chain(unknown).chain(screen);
    all.map(|(kind, id)| format!(r#"{{"type":"{kind}","id":"{id}","channel":0}}"#))
        .collect()
}

/// A project whose only pass has these inputs.
fn project(inputs: &[String]) -> Project {
    let code = "void mainImage(out vec4 c, vec2 p) { c = texture(iChannel0, p); }";
    let inputs = inputs.join(",");
    let pass = format!(r#"{{"type":"image","code":"{code}","inputs":[{inputs}]}}"#);
    let mut project = Project::from_json(&format!(r#"{{"renderpass":[{pass}]}}"#)).unwrap();
    add_stand_ins(&mut project);
    project
}

fn generators() -> Vec<Generator> {
    let project = project(&inputs());
    let inputs = project.passes.iter().flat_map(|p| &p.inputs);
    let mut all: Vec<Generator> = Vec::new();
    for generator in inputs.map(|i| i.stand_in.unwrap().generator) {
        if !all.contains(&generator) {
            all.push(generator);
        }
    }
    all
}

/// Rules about costs per frame do not apply to a shader that runs once.
const COSTLY: [&str; 2] = ["map-inlining", "nested-iterations"];

#[test]
fn generators_have_no_findings() {
    let all = generators();
    assert_eq!(all.len(), 31);
    for generator in all {
        let (name, text) = (format!("{}.frag", generator.name), generator.fragment());
        let report = check(&name, &text, &Options::default(), &NoFiles);
        assert!(
            report.shaders.len() == 1,
            "{name} is not recognised as a shader"
        );
        let mut all = report.diagnostics.iter();
        let finding = all.find(|f| !COSTLY.contains(&f.rule));
        let at = finding.map(|f| report.sources.text(f.span));
        assert!(finding.is_none(), "{name}: {finding:?} at {at:?}");
    }
}

#[test]
fn every_generator_file_is_used() {
    let all: String = generators().iter().map(Generator::fragment).collect();
    let found = files(&["src/project/media"], ".glsl");
    assert!(found.len() > 30, "{} files", found.len());
    for (path, text) in found {
        let lines = text.lines().map(str::trim);
        let code: Vec<_> = lines.filter(|l| !l.starts_with("//")).collect();
        assert!(all.contains(&code.join("\n")), "{path}");
    }
}

#[test]
fn font_stroke_offsets_match_the_table() {
    let text = fs::read_to_string("src/project/media/textures/font.glsl").unwrap();
    let (strokes, rest) = text.split_once("\n);\n").unwrap();
    let lines = strokes.lines().filter(|l| l.starts_with("    0x"));
    let mut begin = vec![0];
    begin.extend(lines.scan(0, |sum, line| {
        *sum += line.matches("0x").count();
        Some(*sum)
    }));
    let (table, _) = rest.split_once("\n);\n").unwrap();
    let numbers = table.lines().skip(2).flat_map(|l| l.split(','));
    let table: Vec<usize> = numbers.filter_map(|n| n.trim().parse().ok()).collect();
    assert_eq!(table, begin);
    assert_eq!(table.len(), 95);
}

#[test]
fn a_page_contains_each_used_generator_once() {
    let used = |ids: &[&str]| {
        let input = |id: &&str| format!(r#"{{"type":"texture","id":"{id}","channel":0}}"#);
        let inputs: Vec<String> = ids.iter().map(input).collect();
        let mut project = project(&inputs);
        let composed = project.resolve("test").unwrap();
        html(&project, &composed, None, None).whole()
    };
    // One shader draws both sizes of noise.
    let page = used(&["Xsf3zn", "XdXGzn"]);
    assert_eq!(page.matches("ivec2(37, 17)").count(), 1);
    assert_eq!(page.matches("STROKES").count(), 0);
    let with = used(&["Xdf3zn", "Xsf3zn"]).len();
    let (small, large) = (page.len(), used(&["Xsf3zn", "4dXGzr"]).len());
    assert!(
        large - small < 12_000,
        "the font adds {} bytes",
        large - small
    );
    let without = used(&["Xdf3zn"]).len();
    assert!(
        with - without < 1_500,
        "noise adds {} bytes",
        with - without
    );
}
