//! `shaderport gallery`, and several shaders as the input of `shaderport`.
#![cfg(unix)]

use super::embed::{COLORED, size};
use super::port::with_shader;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

const NO_ADDRESSES: &str = "note: link previews show no images, because `og:image` requires an \
    absolute address; pass the address of the output folder with `--url`";

#[test]
fn galleries_have_a_page_for_each_shader() {
    let folder = with_shader();
    folder.write("s/b.glsl", COLORED);
    folder.write("s/deep/c.frag", format!("#include \"lib.glsl\"\n{COLORED}"));
    folder.write("s/deep/lib.glsl", "float one() { return 1.0; }\n");
    folder.write("s/passes/image.glsl", COLORED);
    folder.write("s/passes/common.glsl", "const float A = 1.0;\n");
    folder.write("s/package.json", "{}");
    folder.write("s/notes.txt", "none");
    folder.write("s/.hidden/d.glsl", "wrong");
    let export = r#"{"info": {"name": "Rock &amp; <b>roll", "username": "me"}, "renderpass": [{"type":
        "image", "code": "CODE", "inputs": [], "outputs": []}]}"#;
    folder.write(
        "s/toy.json",
        export.replace("CODE", &COLORED.replace('\n', " ")),
    );
    folder.ports("gallery s -o s/out", NO_ADDRESSES);
    let index = folder.read("s/out/index.html");
    let links: Vec<&str> = index.split("href=\"").skip(2).collect();
    let links: Vec<&str> = links.iter().map(|l| l.split('"').next().unwrap()).collect();
    let expected = ["b", "deep_c", "passes", "toy"];
    assert_eq!(links, expected.map(|name| format!("{name}.html#play")));
    for name in expected {
        assert!(
            folder
                .read(&format!("s/out/{name}.html"))
                .contains("id=\"poster\"")
        );
        let png = fs::read(folder.path(&format!("s/out/{name}.png"))).unwrap();
        assert_eq!(size(&png), (640, 360));
    }
    assert!(
        index.contains("<b>Rock &amp; &lt;b&gt;roll</b><small>by me</small>"),
        "{index}"
    );
    assert!(!index.contains("=\"http") && index.contains("<title>s</title>"));
    let page = folder.read("s/out/b.html");
    assert!(page.contains("<script src=\"player.js\">") && page.len() < 300_000);
    assert!(folder.path("s/out/player.css").is_file());

    folder.port_fails(
        "gallery s -o s/out",
        "s/out/index.html already exists; use --force to overwrite it",
    );
    folder.ports(
        "gallery s -o s/out --force --title Seas --url https://e.org/seas",
        "",
    );
    let index = folder.read("s/out/index.html");
    assert!(index.contains("<h1>Seas</h1>"));
    assert!(
        index.contains("og:url\" content=\"https://e.org/seas/\""),
        "{index}"
    );
    assert!(
        index.contains("og:image\" content=\"https://e.org/seas/b.png\""),
        "{index}"
    );
    let page = folder.read("s/out/passes.html");
    assert!(page.contains("og:url\" content=\"https://e.org/seas/passes.html\""));
    assert!(page.contains("og:image\" content=\"https://e.org/seas/passes.png\""));
}

#[test]
fn shaders_with_errors_are_not_in_the_gallery() {
    let folder = with_shader();
    folder.write("s/good.glsl", COLORED);
    folder.write(
        "s/bad.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(q, r, p); }\n",
    );
    folder.write("s/text.glsl", "<!doctype html>");
    let (code, message) = folder.port("gallery s -o out --url https://e.org");
    assert_eq!(code, Some(1));
    let errors = "error: s/bad.glsl:1:50: `q` is not declared (and 1 more); left out\n\
        error: s/text.glsl: expected a shader, found HTML or XML; left out";
    assert_eq!(message, errors);
    assert!(folder.path("out/good.html").is_file() && !folder.path("out/bad.html").exists());
    fs::remove_file(folder.path("s/good.glsl")).unwrap();
    let (code, _) = folder.port("gallery s -o none");
    assert_eq!(code, Some(1));
    assert!(!folder.path("none").exists());
}

#[test]
fn shaders_of_a_gallery_must_have_different_names() {
    let folder = with_shader();
    let fails = |message: &str| folder.port_fails("gallery s -o out", message);
    folder.write("s/a.glsl", COLORED);
    folder.write("s/A.frag", COLORED);
    fails("s/a.glsl and s/A.frag would both be written to a.html; rename the shader");
    fs::remove_file(folder.path("s/A.frag")).unwrap();
    folder.write("s/index.glsl", COLORED);
    fails("s/index.glsl and the gallery would both be written to index.html; rename the shader");
    fs::remove_dir_all(folder.path("s")).unwrap();
    fails("s: no such file or folder");
    fs::create_dir(folder.path("s")).unwrap();
    fails("s: no shader found");
    assert!(!folder.path("out").exists());
}

/// The command does not take the name away from files.
#[test]
fn files_may_be_named_like_the_gallery_command() {
    let folder = with_shader();
    folder.write("gallery", COLORED);
    folder.ports("./gallery -o gallery.html", "");
    assert!(folder.read("gallery.html").starts_with("<!doctype html>"));
}

/// Exports of one shader each, as an array.
fn array(shaders: &[(&str, &str)]) -> String {
    let exports = shaders.iter().map(|(name, blue)| {
        let code = COLORED.replace("0.5 +", blue).replace('\n', " ");
        format!(
            r#"{{"info": {{"name": "{name}"}}, "renderpass": [{{"type": "image", "code": "{code}",
            "inputs": [], "outputs": []}}]}}"#
        )
    });
    format!("[{}]", exports.collect::<Vec<_>>().join(","))
}

#[test]
fn several_exports_form_a_gallery() {
    let folder = with_shader();
    folder.write("all.json", array(&[("Sea", "0.1 +"), ("Land", "0.2 +")]));
    folder.write("one.json", array(&[("Sky", "0.3 +")]));
    let pages = |out: &str| -> Vec<String> {
        let found = fs::read_dir(folder.path(out)).unwrap();
        let names = found.map(|f| f.unwrap().file_name().into_string().unwrap());
        let mut pages: Vec<String> = names.filter(|n| n.ends_with(".html")).collect();
        pages.sort();
        pages
    };
    folder.ports("all.json one.json -o both/", NO_ADDRESSES);
    assert_eq!(
        pages("both"),
        ["Land.html", "Sea.html", "index.html", "one.html"]
    );
    folder.ports("all.json -o array", NO_ADDRESSES);
    assert_eq!(pages("array"), ["Land.html", "Sea.html", "index.html"]);
    // One shader stays one page.
    fs::create_dir(folder.path("single")).unwrap();
    folder.ports("one.json -t html -o single", "");
    assert_eq!(pages("single"), ["Sky.html"]);

    let no_folder = "the input has several shaders; `-o FOLDER` writes a page for each";
    for args in ["all.json", "all.json one.json -o a.html", "all.json -o -"] {
        folder.port_fails(args, no_folder);
    }
    folder.port_fails(
        "all.json --verify -o more",
        "`--verify` requires one shader, but the input has several",
    );
    folder.port_fails(
        "one.json one.json -t module -o more",
        "`--target` requires one shader, but the input has several",
    );
    assert!(!folder.path("more").exists());
}

/// Only the page of a shader that changed is written again.
#[test]
fn a_watched_gallery_rewrites_changed_pages_only() {
    let folder = with_shader();
    folder.write("s/all.json", array(&[("Sea", "0.1 +"), ("Land", "0.2 +")]));
    folder.write("s/own.glsl", COLORED);
    let mut command = folder.port_command("gallery s -o out --watch");
    let mut running = command.stderr(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(running.stderr.take().unwrap()).lines();
    let mut waits = || {
        let waits = lines.find(|l| l.as_ref().unwrap().contains("waiting for changes"));
        assert!(waits.is_some());
    };
    let written = |name: &str| {
        let data = fs::metadata(folder.path(&format!("out/{name}.html")));
        data.unwrap().modified().unwrap()
    };
    waits();
    let before = ["Sea", "Land", "own"].map(written);
    folder.write("s/all.json", array(&[("Sea", "0.1 +"), ("Land", "0.9 -")]));
    waits();
    let after = ["Sea", "Land", "own"].map(written);
    let is_rewritten = [0, 1, 2].map(|i| before[i] != after[i]);
    assert_eq!(is_rewritten, [false, true, false]);
    folder.write("s/own.glsl", COLORED.replace("0.5 +", "0.7 -"));
    folder.write("s/new.glsl", COLORED);
    waits();
    assert_eq!(["Sea", "Land"].map(written), [after[0], after[1]]);
    assert!(written("own") != after[2] && folder.path("out/new.png").is_file());
    let index = fs::read_to_string(folder.path("out/index.html")).unwrap();
    assert!(index.contains("new.html") && index.contains("Land.html"));
    running.kill().unwrap();
    running.wait().unwrap();
}
