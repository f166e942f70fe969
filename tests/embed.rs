//! Pages that show a still image until they are clicked.
#![cfg(unix)]

use super::port::with_shader;
use std::fs;

pub const COLORED: &str = "void mainImage(out vec4 c, in vec2 p) {\n    \
    c = vec4(p / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);\n}\n";

const NO_ADDRESS: &str = "note: link previews show no image, because `og:image` requires an \
    absolute address; pass the address of the page with `--url`";

/// The width and height of a PNG file.
pub fn size(png: &[u8]) -> (u32, u32) {
    let reader = png::Decoder::new(std::io::Cursor::new(png)).read_info();
    let info = reader.unwrap().info().clone();
    (info.width, info.height)
}

#[test]
fn embedding_requires_a_page() {
    let folder = with_shader();
    let message = "`--embed` requires an HTML page; use `-o NAME.html`";
    for args in [
        "--embed -o a.js",
        "--embed -o a.frag",
        "--embed -t glsl",
        "--embed -o a.html -t json",
    ] {
        folder.port_fails(&format!("a.glsl {args}"), message);
    }
    folder.write("b.glsl", COLORED);
    let out = folder.port_command("b.glsl --embed").output().unwrap();
    assert!(out.stdout.starts_with(b"<!doctype html>"));
    folder.port_fails(
        "b.glsl --embed -o - --url https://e.org/b.html",
        "`--url` requires `-o FILE`: the still image is written beside it",
    );
    for args in [
        "--embed --serve",
        "--embed --diff",
        "--url https://e.org -o b.html",
    ] {
        assert_eq!(folder.port(&format!("b.glsl {args}")).0, Some(2), "{args}");
    }
    let (code, message) = folder.port("b.glsl --embed -o b.html --url b.html");
    assert_eq!(code, Some(2));
    assert!(
        message.contains("expected an absolute address such as"),
        "{message}"
    );
    assert!(!folder.path("b.html").exists());
}

#[test]
fn link_previews_require_an_address() {
    let folder = with_shader();
    folder.write("sea & sky.glsl", COLORED);
    folder.write("b.glsl", COLORED);
    folder.ports("b.glsl --embed -o b.html", NO_ADDRESS);
    let page = folder.read("b.html");
    assert!(page.contains(
        "<img alt=\"Still image of b\" width=\"640\" height=\"360\" src=\"data:image/png;base64,"
    ));
    assert!(page.contains("<meta property=\"og:title\" content=\"b\">"));
    assert!(page.contains("<meta name=\"twitter:card\" content=\"summary\">"));
    assert!(!page.contains("\"og:image") && !folder.path("b.png").exists());

    let out = folder
        .port_command("--embed --url https://e.org/x/sea -o new/sea.html")
        .arg("sea & sky.glsl")
        .output()
        .unwrap();
    assert_eq!(String::from_utf8(out.stderr).unwrap(), "");
    let page = folder.read("new/sea.html");
    for (name, value) in [
        ("property=\"og:title\"", "sea &amp; sky"),
        ("property=\"og:type\"", "website"),
        ("property=\"og:url\"", "https://e.org/x/sea"),
        ("property=\"og:image\"", "https://e.org/x/sea.png"),
        ("property=\"og:image:width\"", "640"),
        ("property=\"og:image:height\"", "360"),
        ("property=\"og:image:alt\"", "Still image of sea &amp; sky"),
        ("name=\"twitter:card\"", "summary_large_image"),
    ] {
        let row = format!("<meta {name} content=\"{value}\">");
        assert!(page.contains(&row), "{row}");
    }
    assert!(page.contains("<title>sea &amp; sky</title>"));
    assert_eq!(
        size(&fs::read(folder.path("new/sea.png")).unwrap()),
        (640, 360)
    );
}

#[test]
fn still_images_do_not_overwrite_files() {
    let folder = with_shader();
    let url = "--embed --url https://e.org/a.html";
    folder.write("b.glsl", COLORED);
    folder.write("b.png", "mine");
    folder.port_fails(
        &format!("b.glsl {url} -o b.html"),
        "b.png already exists; use --force to overwrite it",
    );
    assert_eq!(folder.read("b.png"), "mine");
    assert!(!folder.path("b.html").exists());
    let (code, message) = folder.port(&format!("a.glsl --channel 0=a.png {url} -o a.html --force"));
    assert_eq!(code, Some(2));
    let end = "a.png is an input file; choose another output";
    assert!(message.ends_with(end), "{message}");
}

/// Without a still image, the page is written all the same.
#[test]
fn pages_without_a_still_image_give_the_reason() {
    let folder = with_shader();
    let embed = |code: &str| {
        folder.write("x.glsl", code);
        let (exit, message) = folder.port("x.glsl --embed -o x.html --force");
        let page = folder.read("x.html");
        assert!(
            page.contains("<div id=\"poster\"><p>x "),
            "a plain background"
        );
        let prefix = "note: the page has no still image: ";
        let mut lines = message.lines();
        let why = lines
            .find_map(|l| l.strip_prefix(prefix))
            .map(str::to_string);
        (exit, why.unwrap_or(message))
    };
    let errors = "the shader has errors".to_string();
    let wrong = "void mainImage(out vec4 c, in vec2 p) { c = vec4(q); }";
    assert_eq!(embed(wrong), (Some(1), errors));
    let vertices = "attribute float vertexId;\nvarying vec4 v_color;\nvoid main() {\n    \
        gl_Position = vec4(vertexId);\n    v_color = vec4(1.0);\n}\n";
    let (code, why) = embed(vertices);
    assert_eq!(code, Some(0), "{why}");
    assert!(why.contains("vertex shader"), "{why}");
}

/// Noise does not compress; its image is smaller.
#[test]
fn still_images_are_small_files() {
    let folder = with_shader();
    let noise = "fract(sin(p.xyx * vec3(12.9, 78.2, 37.7) + p.yxx * 4.1) * 43758.5)";
    let code = format!("void mainImage(out vec4 c, in vec2 p) {{ c = vec4({noise}, 1.0); }}\n");
    folder.write("noise.glsl", code);
    folder.ports("noise.glsl --embed --url https://e.org/ -o noise.html", "");
    let file = fs::read(folder.path("noise.png")).unwrap();
    assert_eq!((size(&file), file.len() < 256 * 1024), ((320, 180), true));
}

/// Shaders that start black are drawn later.
#[test]
fn still_images_are_not_black() {
    let folder = with_shader();
    let code = COLORED.replace("1.0);", "1.0) * step(4.0, iTime);");
    folder.write("late.glsl", code);
    folder.ports("late.glsl --embed --url https://e.org/ -o late.html", "");
    let file = fs::read(folder.path("late.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    assert!(bytes.iter().any(|b| *b > 200));
}
