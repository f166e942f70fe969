//! Pages that show a still image until they are clicked, and galleries of them.
#![cfg(unix)]

use super::port::Folder;
use std::fs;

const COLORED: &str = "void mainImage(out vec4 c, in vec2 p) {\n    \
    c = vec4(p / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);\n}\n";

const NO_ADDRESS: &str = "note: link previews show no image, because `og:image` requires an \
    absolute address; pass the address of the page with `--url`";

const NO_ADDRESSES: &str = "note: link previews show no images, because `og:image` requires an \
    absolute address; pass the address of the output folder with `--url`";

impl Folder {
    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }
}

/// The width and height of a PNG file.
fn size(png: &[u8]) -> (u32, u32) {
    let reader = png::Decoder::new(std::io::Cursor::new(png)).read_info();
    let info = reader.unwrap().info().clone();
    (info.width, info.height)
}

#[test]
fn only_pages_are_embedded() {
    let folder = Folder::new();
    let message = "`--embed` requires an HTML page; use `-o NAME.html`";
    for args in [
        "--embed -o a.js",
        "--embed -o a.frag",
        "--embed -t glsl",
        "--embed -o a.html -t json",
    ] {
        folder.fails(&format!("a.glsl {args}"), message);
    }
    folder.put("b.glsl", COLORED);
    let out = folder.command("b.glsl --embed").output().unwrap();
    assert!(out.stdout.starts_with(b"<!doctype html>"));
    folder.fails(
        "b.glsl --embed -o - --url https://e.org/b.html",
        "`--url` requires `-o FILE`: the still image is written beside it",
    );
    for args in [
        "--embed --serve",
        "--embed --diff",
        "--url https://e.org -o b.html",
    ] {
        assert_eq!(folder.run(&format!("b.glsl {args}")).0, Some(2), "{args}");
    }
    let (code, message) = folder.run("b.glsl --embed -o b.html --url b.html");
    assert_eq!(code, Some(2));
    assert!(
        message.contains("expected an absolute address such as"),
        "{message}"
    );
    assert!(!folder.path("b.html").exists());
}

#[test]
fn link_previews_need_an_address() {
    let folder = Folder::new();
    folder.put("sea & sky.glsl", COLORED);
    folder.put("b.glsl", COLORED);
    folder.works("b.glsl --embed -o b.html", NO_ADDRESS);
    let page = folder.text("b.html");
    assert!(page.contains(
        "<img alt=\"Still image of b\" width=\"640\" height=\"360\" src=\"data:image/png;base64,"
    ));
    assert!(page.contains("<meta property=\"og:title\" content=\"b\">"));
    assert!(page.contains("<meta name=\"twitter:card\" content=\"summary\">"));
    assert!(!page.contains("\"og:image") && !folder.path("b.png").exists());

    let out = folder
        .command("--embed --url https://e.org/x/sea -o new/sea.html")
        .arg("sea & sky.glsl")
        .output()
        .unwrap();
    assert_eq!(String::from_utf8(out.stderr).unwrap(), "");
    let page = folder.text("new/sea.html");
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
fn a_still_image_overwrites_nothing() {
    let folder = Folder::new();
    let url = "--embed --url https://e.org/a.html";
    folder.put("b.glsl", COLORED);
    folder.put("b.png", "mine");
    folder.fails(
        &format!("b.glsl {url} -o b.html"),
        "b.png already exists; use --force to overwrite it",
    );
    assert_eq!(folder.text("b.png"), "mine");
    assert!(!folder.path("b.html").exists());
    let (code, message) = folder.run(&format!("a.glsl --channel 0=a.png {url} -o a.html --force"));
    assert_eq!(code, Some(2));
    let end = "a.png is an input file; choose another output";
    assert!(message.ends_with(end), "{message}");
}

/// Without a still image, the page is written all the same.
#[test]
fn a_page_without_a_still_image_says_why() {
    let folder = Folder::new();
    let embed = |code: &str| {
        folder.put("x.glsl", code);
        let (exit, message) = folder.run("x.glsl --embed -o x.html --force");
        let page = folder.text("x.html");
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
fn a_still_image_is_a_small_file() {
    let folder = Folder::new();
    let noise = "fract(sin(p.xyx * vec3(12.9, 78.2, 37.7) + p.yxx * 4.1) * 43758.5)";
    let code = format!("void mainImage(out vec4 c, in vec2 p) {{ c = vec4({noise}, 1.0); }}\n");
    folder.put("noise.glsl", code);
    folder.works("noise.glsl --embed --url https://e.org/ -o noise.html", "");
    let file = fs::read(folder.path("noise.png")).unwrap();
    assert_eq!((size(&file), file.len() < 256 * 1024), ((320, 180), true));
}

/// Shaders that start black are drawn later.
#[test]
fn a_still_image_shows_something() {
    let folder = Folder::new();
    let code = COLORED.replace("1.0);", "1.0) * step(4.0, iTime);");
    folder.put("late.glsl", code);
    folder.works("late.glsl --embed --url https://e.org/ -o late.html", "");
    let file = fs::read(folder.path("late.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    assert!(bytes.iter().any(|b| *b > 200));
}

#[test]
fn a_gallery_has_a_page_for_each_shader() {
    let folder = Folder::new();
    folder.put("s/b.glsl", COLORED);
    folder.put("s/deep/c.frag", format!("#include \"lib.glsl\"\n{COLORED}"));
    folder.put("s/deep/lib.glsl", "float one() { return 1.0; }\n");
    folder.put("s/passes/image.glsl", COLORED);
    folder.put("s/passes/common.glsl", "const float A = 1.0;\n");
    folder.put("s/package.json", "{}");
    folder.put("s/notes.txt", "none");
    folder.put("s/.hidden/d.glsl", "wrong");
    let export = r#"{"info": {"name": "Rock &amp; <b>roll", "username": "me"}, "renderpass": [{"type":
        "image", "code": "CODE", "inputs": [], "outputs": []}]}"#;
    folder.put(
        "s/toy.json",
        export.replace("CODE", &COLORED.replace('\n', " ")),
    );
    folder.works("gallery s -o s/out", NO_ADDRESSES);
    let index = folder.text("s/out/index.html");
    let links: Vec<&str> = index.split("href=\"").skip(2).collect();
    let links: Vec<&str> = links.iter().map(|l| l.split('"').next().unwrap()).collect();
    let expected = ["b", "deep_c", "passes", "toy"];
    assert_eq!(links, expected.map(|name| format!("{name}.html#play")));
    for name in expected {
        assert!(
            folder
                .text(&format!("s/out/{name}.html"))
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
    let page = folder.text("s/out/b.html");
    assert!(page.contains("<script src=\"player.js\">") && page.len() < 300_000);
    assert!(folder.path("s/out/player.css").is_file());

    folder.fails(
        "gallery s -o s/out",
        "s/out/index.html already exists; use --force to overwrite it",
    );
    folder.works(
        "gallery s -o s/out --force --title Seas --url https://e.org/seas",
        "",
    );
    let index = folder.text("s/out/index.html");
    assert!(index.contains("<h1>Seas</h1>"));
    assert!(
        index.contains("og:url\" content=\"https://e.org/seas/\""),
        "{index}"
    );
    assert!(
        index.contains("og:image\" content=\"https://e.org/seas/b.png\""),
        "{index}"
    );
    let page = folder.text("s/out/passes.html");
    assert!(page.contains("og:url\" content=\"https://e.org/seas/passes.html\""));
    assert!(page.contains("og:image\" content=\"https://e.org/seas/passes.png\""));
}

/// The shaders of a project that names them are not shaders of the gallery.
#[test]
fn a_gallery_has_projects_of_several_files() {
    let folder = Folder::new();
    let fixtures = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/fixtures/dialects/shadered"
    );
    for file in [
        "single.sprj",
        "shaders/quadVS.glsl",
        "shaders/simplePS.glsl",
    ] {
        folder.put(
            &format!("s/{file}"),
            fs::read(format!("{fixtures}/{file}")).unwrap(),
        );
    }
    folder.works("gallery s -o out", NO_ADDRESSES);
    assert!(folder.path("out/single.png").is_file());
    assert!(!folder.path("out/shaders_quadVS.html").exists());
}

#[test]
fn shaders_with_errors_are_left_out_of_a_gallery() {
    let folder = Folder::new();
    folder.put("s/good.glsl", COLORED);
    folder.put(
        "s/bad.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(q, r, p); }\n",
    );
    folder.put("s/text.glsl", "<!doctype html>");
    let (code, message) = folder.run("gallery s -o out --url https://e.org");
    assert_eq!(code, Some(1));
    let errors = "error: s/bad.glsl:1:50: `q` is not declared (and 1 more); left out\n\
        error: s/text.glsl: expected a shader, found HTML or XML; left out";
    assert_eq!(message, errors);
    assert!(folder.path("out/good.html").is_file() && !folder.path("out/bad.html").exists());
    fs::remove_file(folder.path("s/good.glsl")).unwrap();
    let (code, _) = folder.run("gallery s -o none");
    assert_eq!(code, Some(1));
    assert!(!folder.path("none").exists());
}

#[test]
fn shaders_of_a_gallery_have_different_names() {
    let folder = Folder::new();
    let fails = |message: &str| folder.fails("gallery s -o out", message);
    folder.put("s/a.glsl", COLORED);
    folder.put("s/A.frag", COLORED);
    fails("s/a.glsl and s/A.frag would both be written to a.html; rename the shader");
    fs::remove_file(folder.path("s/A.frag")).unwrap();
    folder.put("s/index.glsl", COLORED);
    fails("s/index.glsl and the gallery would both be written to index.html; rename the shader");
    fs::remove_dir_all(folder.path("s")).unwrap();
    fails("s: no such file or folder");
    fs::create_dir(folder.path("s")).unwrap();
    fails("s: no shader found");
    assert!(!folder.path("out").exists());
}

/// The command does not take the name away from files.
#[test]
fn a_file_may_be_called_gallery() {
    let folder = Folder::new();
    folder.put("gallery", COLORED);
    folder.works("./gallery -o gallery.html", "");
    assert!(folder.text("gallery.html").starts_with("<!doctype html>"));
}
