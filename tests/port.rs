//! `shaderport` as an impatient or a careless person runs it: what it reads, what it must not write
//! over, and what it says.
#![cfg(unix)]

use insta_cmd::get_cargo_bin;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::symlink;
use std::path::PathBuf;
use std::process::{Command, Stdio};

const CODE: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }\n";
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// A folder with a shader `a.glsl` and a picture `a.png`.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Folder {
        let folder = Folder(tempfile::tempdir().unwrap());
        folder.put("a.glsl", CODE);
        folder.put("a.png", PNG);
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    fn command(&self, args: &str) -> Command {
        let mut command = Command::new(get_cargo_bin("shaderport"));
        command.current_dir(self.0.path());
        command.args(args.split_whitespace());
        command
    }

    /// Exit code, and what is said without the notes of what is not at hand.
    fn run(&self, args: &str) -> (Option<i32>, String) {
        let out = self.command(args).output().unwrap();
        let said = String::from_utf8(out.stderr).unwrap();
        let lines = said.lines().filter(|l| !l.contains("and there is none"));
        let lines: Vec<&str> = lines.collect();
        (out.status.code(), lines.join("\n"))
    }

    #[track_caller]
    fn works(&self, args: &str, said: &str) {
        assert_eq!(self.run(args), (Some(0), said.to_string()), "{args}");
    }

    #[track_caller]
    fn fails(&self, args: &str, said: &str) {
        let said = format!("shaderport: {said}");
        assert_eq!(self.run(args), (Some(2), said), "{args}");
    }
}

#[test]
fn an_input_is_never_written_over() {
    let folder = Folder::new();
    fs::hard_link(folder.path("a.glsl"), folder.path("hard.glsl")).unwrap();
    let same = |name: &str| format!("{name} is what is read; write to another file");
    folder.fails("a.glsl -o ./a.glsl --force", &same("./a.glsl"));
    folder.fails("a.glsl -o hard.glsl --force", &same("hard.glsl"));
    folder.fails("--pass image=a.glsl -o a.glsl --force", &same("a.glsl"));
    let (code, said) = folder.run("a.glsl --channel 0=a.png -t json -o a.png --force");
    assert_eq!(code, Some(2));
    assert!(said.ends_with(&same("a.png")), "{said}");
    folder.put("p/image.frag", CODE);
    folder.fails("p -o p --force", &same("p/image.frag"));
    assert_eq!(fs::read_to_string(folder.path("a.glsl")).unwrap(), CODE);
    assert_eq!(fs::read(folder.path("a.png")).unwrap(), PNG);
}

#[test]
fn only_regular_files_are_written_over() {
    let folder = Folder::new();
    folder.put("there.html", "there");
    symlink(folder.path("there.html"), folder.path("link.html")).unwrap();
    fs::create_dir(folder.path("image.frag")).unwrap();
    let end = ", and only regular files are written over; without `-o` it goes to standard output";
    folder.fails(
        "a.glsl -o link.html --force",
        &format!("link.html is a symbolic link{end}"),
    );
    folder.fails(
        "a.glsl -t html -o /dev/null --force",
        &format!("/dev/null is a device{end}"),
    );
    folder.fails(
        "a.glsl -o . --force -t glsl",
        &format!("./image.frag is a folder{end}"),
    );
    folder.fails(
        "a.glsl -o /dev/null --force",
        &format!("/dev/null is a device{end}"),
    );
    folder.fails("a.glsl -o a.glsl/b.html", "a.glsl is no folder");
    assert_eq!(fs::read(folder.path("there.html")).unwrap(), b"there");
    folder.works("a.glsl -o there.html --force", "");
}

#[test]
fn a_folder_is_where_files_get_names() {
    let folder = Folder::new();
    folder.works("a.glsl -o shaders", "");
    folder.works("a.glsl -t html -o pages/", "");
    folder.works("a.glsl -t json -o pages", "");
    for file in [
        "shaders/image.frag",
        "shaders/pass.vert",
        "pages/a.html",
        "pages/a.json",
    ] {
        assert!(folder.path(file).is_file(), "{file}");
    }
    folder.works("a.glsl -o new/folder/a.html", "");
    let out = folder.command("a.glsl -o -").output().unwrap();
    assert!(out.stdout.starts_with(b"#version 300 es\n"));
}

#[test]
fn passes_outside_of_their_folder_are_not_read() {
    let folder = Folder::new();
    folder.put("p/image.glsl", CODE);
    folder.put("secret.glsl", "#define SECRET\n");
    symlink(folder.path("secret.glsl"), folder.path("p/common.glsl")).unwrap();
    folder.fails(
        "p -o a.html",
        "p/common.glsl leads out of p; give it with `--pass common=FILE`",
    );
    fs::remove_file(folder.path("p/common.glsl")).unwrap();
    symlink("image.glsl", folder.path("p/buffer_a.glsl")).unwrap();
    folder.works("p -o a.html", "");
}

#[test]
fn media_are_what_their_bytes_say() {
    let folder = Folder::new();
    folder.put("b.png", b"\xff\xd8\xff\xe0");
    folder.put("c.png", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    folder.works(
        "a.glsl --channel 0=b.png -o b.html",
        "note: b.png holds image/jpeg whatever its name says, and is taken as that\n\
         note: b.png adds 31 bytes",
    );
    let page = fs::read_to_string(folder.path("b.html")).unwrap();
    assert!(page.contains("data:image/jpeg;base64,/9j/4A=="));
    folder.fails(
        "a.glsl --channel 0=c.png -o c.html",
        "--channel: c.png: this is SVG, a document that may hold scripts; save the picture as PNG",
    );
    folder.fails(
        "a.glsl --channel 0=a.png --max-media 4 -o c.html",
        "--channel: a.png: the file has 8 bytes; at most 4 bytes are put onto a channel, more \
         with `--max-media SIZE`",
    );
}

#[test]
fn media_outside_of_their_folder_are_not_read() {
    let folder = Folder::new();
    let toy = r#"{"renderpass":[{"type":"image","code":"void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }",
        "outputs":[],"inputs":[{"channel":0,"type":"texture","filepath":"/media/b.png"}]}]}"#;
    folder.put("toy.json", toy);
    folder.put("site/media/keep.txt", "");
    symlink(folder.path("a.png"), folder.path("site/media/b.png")).unwrap();
    let out = "`/media/b.png` leads out of site";
    folder.fails("toy.json --media site -o toy.html", out);
    assert!(!folder.path("toy.html").exists());
}

/// Every target that can be read back is the original's code; a plain `main` is compared by running.
#[test]
fn what_is_written_is_verified() {
    let folder = Folder::new();
    let export = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/export.json");
    // The export has an error, which is mended here.
    let text = fs::read_to_string(export).unwrap().replace("SCALE", "2.0");
    folder.put("export.json", text);
    let lines = |said: &str| -> Vec<String> {
        let told = said.lines().filter(|l| l.contains(": the same"));
        told.map(str::to_string).collect()
    };
    for target in ["page.html", "module.js", "project.json", "shaders"] {
        let (code, said) = folder.run(&format!("export.json --verify -o {target}"));
        assert_eq!(code, Some(0), "{target}: {said}");
        let told = lines(&said);
        assert!(!told.is_empty(), "{target}: {said}");
        assert!(
            told.iter().all(|l| l.ends_with(": the same code")),
            "{target}: {said}"
        );
    }
    folder.put(
        "plain.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, sin(iTime), 1); }",
    );
    folder.works(
        "plain.glsl --main rewrite --verify -o plain.frag",
        "Image: the same bits on 8832 pixels",
    );
}

/// A repair is compared with what was given, where that draws anything.
#[test]
fn repairs_are_verified() {
    let folder = Folder::new();
    let told = |file: &str, code: &str| {
        folder.put(file, code);
        let (exit, said) = folder.run(&format!("{file} --repair --verify --force -o page.html"));
        let last = said.lines().last().unwrap_or_default().to_string();
        (exit, last)
    };
    let old = "precision highp float;\nvarying vec2 place;\nuniform float time;\n\
               uniform sampler2D back;\nvoid main() {\n    \
               gl_FragColor = texture2D(back, place) * sin(time);\n}\n";
    let same = "Image: the same bits on 8832 pixels".to_string();
    assert_eq!(told("old.frag", old), (Some(0), same));
    let toy = "void mainImage(out vec4 c, in vec2 p) { c = texture2D(iChannel0, p); }\n";
    let since = " as the repaired text; what was given does not compile";
    let same = format!("Image: the same code{since}");
    assert_eq!(told("toy.glsl", toy), (Some(0), same));
}

/// A pass of vertices is written as a vertex shader with the site's fragment shader beside it, and a
/// pair of shaders as this pair.
#[test]
fn both_shaders_of_a_pass_are_written() {
    let folder = Folder::new();
    let dialects = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/dialects");
    let check = |from: &str, out: &str, vertex: (&str, &str), fragment: (&str, &str)| {
        let args = format!("{dialects}/{from} -t glsl --verify -o {out}");
        let (code, said) = folder.run(&args);
        assert_eq!(code, Some(0), "{said}");
        assert!(said.ends_with("Image: the same code"), "{said}");
        for (file, text) in [vertex, fragment] {
            let shader = fs::read_to_string(folder.path(file)).unwrap();
            assert!(shader.contains(text), "{file}: {shader}");
        }
    };
    let [points, color] = ["attribute float vertexId;", "gl_FragColor = v_color;"];
    let cube = "vertexshaderart/cube.vert";
    check(
        cube,
        "cube.frag",
        ("cube.vert", points),
        ("cube.frag", color),
    );
    check(
        cube,
        "cube",
        ("cube/image.vert", points),
        ("cube/image.frag", color),
    );
    let [own, lines] = ["left_coord = clamp(", "void main() {"];
    let pair = ("pair/pass.vert", own);
    check("isf/edges.fs", "pair", pair, ("pair/image.frag", lines));
}

#[test]
fn what_is_too_large_for_a_shader_is_not_read_as_one() {
    let folder = Folder::new();
    folder.put("large.glsl", vec![b'\n'; 41 << 20]);
    let said = "large.glsl: this has more than 40 MB; that is no shader";
    folder.fails("large.glsl -o large.html", said);
}

#[test]
fn sound_of_a_time_alone_is_repaired() {
    let folder = Folder::new();
    let toy = r#"{"renderpass":[
        {"type":"image","code":"void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }","inputs":[],"outputs":[]},
        {"type":"sound","code":"vec2 mainSound(float time) { return vec2(sin(time)); }","inputs":[],"outputs":[]}]}"#;
    folder.put("toy.json", toy);
    assert_eq!(folder.run("toy.json -o new.json").0, Some(1));
    let (code, said) = folder.run("toy.json --repair -o new.json --force");
    assert_eq!(code, Some(0), "{said}");
    let new = fs::read_to_string(folder.path("new.json")).unwrap();
    assert!(new.contains("mainSound(in int, float time)"), "{new}");
}

#[test]
fn wrong_names_are_told_with_the_right_ones() {
    let folder = Folder::new();
    let check = |args: &str, said: &str| folder.fails(&format!("{args} -o x.html"), said);
    check(
        "a.glsl --channel 0=keybord",
        "--channel: there is no file `keybord`; did you mean `keyboard`?",
    );
    check(
        "a.glsl --channel bufer_a.0=mic",
        "--channel: `bufer_a` is no pass; did you mean `buffer_a`?",
    );
    check(
        "a.glsl --channel buffer_a.0=mic",
        "--channel: there is no pass `buffer_a`; there is `image`",
    );
    check(
        "--pass imag=a.glsl",
        "--pass: `imag` is no pass; did you mean `image`?",
    );
    folder.fails(
        "a.glsl -o a.vert",
        "-o a.vert: nothing is made for the ending `.vert`; write `-o NAME.frag`, and the vertex \
         shader lies beside it",
    );
    folder.put("p/other.json", "{}");
    check(
        "p",
        "p: no file in it is called like a pass: `image.glsl`, `buffer_a.glsl`, `common.glsl`; or \
         give a file itself, like p/other.json",
    );
}

#[test]
fn texts_are_read_in_every_encoding() {
    let folder = Folder::new();
    folder.put("bom.glsl", format!("\u{feff}{CODE}"));
    folder.put("p/image.glsl", format!("\u{feff}{CODE}"));
    let units = CODE.encode_utf16().flat_map(u16::to_le_bytes);
    folder.put(
        "wide.glsl",
        [0xff, 0xfe].into_iter().chain(units).collect::<Vec<u8>>(),
    );
    folder.put(
        "bom.json",
        format!("\u{feff} [{{\"renderpass\":[{{\"type\":\"image\",\"code\":{CODE:?}}}]}}]"),
    );
    for (i, input) in [
        "bom.glsl",
        "p",
        "--pass image=bom.glsl",
        "wide.glsl",
        "bom.json",
    ]
    .iter()
    .enumerate()
    {
        folder.works(&format!("{input} -o {i}.html"), "");
        let page = fs::read_to_string(folder.path(&format!("{i}.html"))).unwrap();
        assert!(
            !page.contains('\u{feff}') && !page.contains("\\ufeff"),
            "{input}"
        );
    }
    folder.put("page.glsl", "<!doctype html>");
    folder.fails(
        "page.glsl -o x.html",
        "page.glsl: this is a page of HTML or XML, and no shader",
    );
    folder.fails(
        "/dev/zero -o x.html",
        "/dev/zero: this has more than 40 MB; that is no shader",
    );
    folder.fails(
        "p/image.glsl/x -o x.html",
        "p/image.glsl/x: Not a directory",
    );
}

/// A page is a thing to send.
#[test]
fn a_page_of_a_template_is_small() {
    let folder = Folder::new();
    for name in ["raymarching", "terrain", "voxel"] {
        let root = env!("CARGO_MANIFEST_DIR");
        let template = format!("{root}/corpus/templates/{name}.glsl");
        folder.put("t.glsl", fs::read(template).unwrap());
        let output = folder.command("-o t.html --force t.glsl").output().unwrap();
        assert!(output.status.success());
        let size = fs::metadata(folder.path("t.html")).unwrap().len();
        assert!(size < 160_000, "{name}: {size} bytes");
    }
}

#[test]
fn it_says_what_it_waits_for() {
    let folder = Folder::new();
    let mut command = folder.command("- -t html");
    let mut running = command
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut said = String::new();
    let mut errors = BufReader::new(running.stderr.take().unwrap());
    errors.read_line(&mut said).unwrap();
    assert!(
        said.starts_with("waiting for the end of standard input"),
        "{said}"
    );
    let mut input = running.stdin.take().unwrap();
    input.write_all(CODE.as_bytes()).unwrap();
    drop(input);
    errors.read_to_string(&mut said).unwrap();
    assert_eq!(running.wait().unwrap().code(), Some(0), "{said}");
}

#[test]
fn what_no_repair_makes_a_shader_is_said_as_it_is() {
    let folder = Folder::new();
    folder.put("text.glsl", "hello world\n");
    let (code, said) = folder.run("text.glsl -o text.html");
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("there is no type `hello`"), "{said}");
    assert!(!said.contains("repaired"), "{said}");
    // One that a repair makes whole is mended unasked, as WebGL2 needs it.
    let desktop = "#version 330\nout vec4 c;\nvoid main() { c = vec4(1 / 2.0f); }\n";
    folder.put("desktop.glsl", desktop);
    let (code, said) = folder.run("desktop.glsl -o desktop.html");
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("repaired"), "{said}");
}

#[test]
fn a_channel_is_named_by_its_sampler() {
    let folder = Folder::new();
    let code = "precision highp float;\nuniform sampler2D u_photo;\n\
        void main() { gl_FragColor = texture2D(u_photo, vec2(0.5)); }\n";
    folder.put("photo.frag", code);
    let note = "note: a.png adds 34 bytes";
    folder.works("photo.frag --channel u_photo=a.png -o photo.html", note);
    let page = fs::read_to_string(folder.path("photo.html")).unwrap();
    assert!(page.contains("\"uniform\":\"u_photo\"") && page.contains("data:image/png"));
    let (code, said) = folder.run("photo.frag --channel photo=a.png -o other.html");
    assert_eq!(code, Some(2), "{said}");
    assert!(
        said.contains("there is no sampler `photo`; there is `u_photo`"),
        "{said}"
    );
}
