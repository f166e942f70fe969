//! `shaderport` used impatiently or carelessly: what it reads, what it must not overwrite, and its
//! messages.
#![cfg(unix)]

use super::scratch::Scratch;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use insta_cmd::get_cargo_bin;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::symlink;
use std::process::{Command, Stdio};

const CODE: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }\n";
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// A folder with a shader `a.glsl` and an image `a.png`.
pub fn with_shader() -> Scratch {
    let folder = Scratch::new(&[("a.glsl", CODE)]);
    folder.write("a.png", PNG);
    folder
}

#[test]
fn inputs_are_never_overwritten() {
    let folder = with_shader();
    fs::hard_link(folder.path("a.glsl"), folder.path("hard.glsl")).unwrap();
    let same = |name: &str| format!("{name} is an input file; choose another output");
    folder.port_fails("a.glsl -o ./a.glsl --force", &same("./a.glsl"));
    folder.port_fails("a.glsl -o hard.glsl --force", &same("hard.glsl"));
    folder.port_fails("--pass image=a.glsl -o a.glsl --force", &same("a.glsl"));
    let (code, message) = folder.port("a.glsl --channel 0=a.png -t json -o a.png --force");
    assert_eq!(code, Some(2));
    assert!(message.ends_with(&same("a.png")), "{message}");
    folder.write("p/image.frag", CODE);
    folder.port_fails("p -o p --force", &same("p/image.frag"));
    assert_eq!(fs::read_to_string(folder.path("a.glsl")).unwrap(), CODE);
    assert_eq!(fs::read(folder.path("a.png")).unwrap(), PNG);
}

#[test]
fn only_regular_files_are_overwritten() {
    let folder = with_shader();
    folder.write("there.html", "there");
    symlink(folder.path("there.html"), folder.path("link.html")).unwrap();
    fs::create_dir(folder.path("image.frag")).unwrap();
    let end = ", not a regular file; omit `-o` to write to standard output";
    folder.port_fails(
        "a.glsl -o link.html --force",
        &format!("cannot overwrite link.html: it is a symbolic link{end}"),
    );
    folder.port_fails(
        "a.glsl -t html -o /dev/null --force",
        &format!("cannot overwrite /dev/null: it is a device{end}"),
    );
    folder.port_fails(
        "a.glsl -o . --force -t glsl",
        &format!("cannot overwrite ./image.frag: it is a folder{end}"),
    );
    folder.port_fails(
        "a.glsl -o /dev/null --force",
        &format!("cannot overwrite /dev/null: it is a device{end}"),
    );
    folder.port_fails("a.glsl -o a.glsl/b.html", "a.glsl is not a folder");
    assert_eq!(fs::read(folder.path("there.html")).unwrap(), b"there");
    folder.ports("a.glsl -o there.html --force", "");
}

#[test]
fn files_in_an_output_folder_get_default_names() {
    let folder = with_shader();
    folder.ports("a.glsl -o shaders", "");
    folder.ports("a.glsl -t html -o pages/", "");
    folder.ports("a.glsl -t json -o pages", "");
    for file in [
        "shaders/image.frag",
        "shaders/pass.vert",
        "pages/a.html",
        "pages/a.json",
    ] {
        assert!(folder.path(file).is_file(), "{file}");
    }
    folder.ports("a.glsl -o new/folder/a.html", "");
    let out = folder.port_command("a.glsl -o -").output().unwrap();
    assert!(out.stdout.starts_with(b"#version 300 es\n"));
}

#[test]
fn passes_outside_of_their_folder_are_not_read() {
    let folder = with_shader();
    folder.write("p/image.glsl", CODE);
    folder.write("secret.glsl", "#define SECRET\n");
    symlink(folder.path("secret.glsl"), folder.path("p/common.glsl")).unwrap();
    folder.port_fails(
        "p -o a.html",
        "p/common.glsl is outside of p; pass it with `--pass common=FILE`",
    );
    fs::remove_file(folder.path("p/common.glsl")).unwrap();
    symlink("image.glsl", folder.path("p/buffer_a.glsl")).unwrap();
    let guess = "note: image.0 = buffer_a, buffer_a.0 = buffer_a (the only buffer)";
    folder.ports("p -o a.html", guess);
}

#[test]
fn media_types_are_detected_from_content() {
    let folder = with_shader();
    folder.write("b.png", b"\xff\xd8\xff\xe0");
    folder.write("c.png", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    folder.ports(
        "a.glsl --channel 0=b.png -o b.html",
        "note: b.png contains image/jpeg, despite its extension\n\
         note: embedded b.png (31 bytes)",
    );
    let page = fs::read_to_string(folder.path("b.html")).unwrap();
    assert!(page.contains("data:image/jpeg;base64,/9j/4A=="));
    folder.port_fails(
        "a.glsl --channel 0=c.png -o c.html",
        "--channel: c.png: SVG is not supported because it can contain scripts; save the image as \
         PNG",
    );
    folder.port_fails(
        "a.glsl --channel 0=a.png --max-media 4 -o c.html",
        "--channel: a.png: the file has 8 bytes, but the limit for media is 4 bytes; raise it with \
         `--max-media SIZE`",
    );
}

#[test]
fn media_outside_of_their_folder_are_not_read() {
    let folder = with_shader();
    let toy = r#"{"renderpass":[{"type":"image","code":"void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }",
        "outputs":[],"inputs":[{"channel":0,"type":"texture","filepath":"/media/b.png"}]}]}"#;
    folder.write("toy.json", toy);
    folder.write("site/media/keep.txt", "");
    symlink(folder.path("a.png"), folder.path("site/media/b.png")).unwrap();
    let out = "`/media/b.png` is outside of site";
    folder.port_fails("toy.json --media site -o toy.html", out);
    assert!(!folder.path("toy.html").exists());
}

/// Every target that can be read back contains the original code; a plain `main` is compared by
/// running it.
#[test]
fn output_is_verified() {
    let folder = with_shader();
    let export = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/export.json");
    // The export has an error that is repaired here.
    let text = fs::read_to_string(export).unwrap().replace("SCALE", "2.0");
    folder.write("export.json", text);
    let lines = |message: &str| -> Vec<String> {
        let reported = message.lines().filter(|l| l.contains(": identical"));
        reported.map(str::to_string).collect()
    };
    for target in ["page.html", "module.js", "project.json", "shaders"] {
        let (code, message) = folder.port(&format!("export.json --verify -o {target}"));
        assert_eq!(code, Some(0), "{target}: {message}");
        let reported = lines(&message);
        assert!(!reported.is_empty(), "{target}: {message}");
        assert!(
            reported.iter().all(|l| l.ends_with(": identical code")),
            "{target}: {message}"
        );
    }
    folder.write(
        "plain.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, sin(iTime), 1); }",
    );
    folder.ports(
        "plain.glsl --main rewrite --verify -o plain.frag",
        "Image: identical on 9152 pixels",
    );
}

/// A repair is compared with the original if that draws anything.
#[test]
fn repairs_are_verified() {
    let folder = with_shader();
    let reported = |file: &str, code: &str| {
        folder.write(file, code);
        let (exit, message) =
            folder.port(&format!("{file} --repair --verify --force -o page.html"));
        let last = message.lines().last().unwrap_or_default().to_string();
        (exit, last)
    };
    let old = "precision highp float;\nvarying vec2 place;\nuniform float time;\n\
               uniform sampler2D back;\nvoid main() {\n    \
               gl_FragColor = texture2D(back, place) * sin(time);\n}\n";
    let same = "Image: identical on 9152 pixels".to_string();
    assert_eq!(reported("old.frag", old), (Some(0), same));
    let toy = "void mainImage(out vec4 c, in vec2 p) { c = texture2D(iChannel0, p); }\n";
    let since = ", compared with the repaired code: the original does not compile";
    let same = format!("Image: identical code{since}");
    assert_eq!(reported("toy.glsl", toy), (Some(0), same));
}

/// A vertex pass is written as a vertex shader together with the host's fragment shader, and a pair
/// of shaders as that pair.
#[test]
fn both_shaders_of_a_pass_are_written() {
    let folder = with_shader();
    let dialects = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/dialects");
    let check = |from: &str, out: &str, vertex: (&str, &str), fragment: (&str, &str)| {
        let args = format!("{dialects}/{from} -t glsl --verify -o {out}");
        let (code, message) = folder.port(&args);
        assert_eq!(code, Some(0), "{message}");
        assert!(message.ends_with("Image: identical code"), "{message}");
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
fn oversized_files_are_rejected() {
    let folder = with_shader();
    folder.write("large.glsl", vec![b'\n'; 41 << 20]);
    let message = "large.glsl: the file is larger than 40 MB, the limit for shaders";
    folder.port_fails("large.glsl -o large.html", message);
}

#[test]
fn main_sound_with_only_a_time_is_repaired() {
    let folder = with_shader();
    let toy = r#"{"renderpass":[
        {"type":"image","code":"void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }","inputs":[],"outputs":[]},
        {"type":"sound","code":"vec2 mainSound(float time) { return vec2(sin(time)); }","inputs":[],"outputs":[]}]}"#;
    folder.write("toy.json", toy);
    assert_eq!(folder.port("toy.json -o new.json").0, Some(1));
    let (code, message) = folder.port("toy.json --repair -o new.json --force");
    assert_eq!(code, Some(0), "{message}");
    let new = fs::read_to_string(folder.path("new.json")).unwrap();
    assert!(new.contains("mainSound(in int, float time)"), "{new}");
}

#[test]
fn misspelled_names_get_suggestions() {
    let folder = with_shader();
    let check =
        |args: &str, message: &str| folder.port_fails(&format!("{args} -o x.html"), message);
    check(
        "a.glsl --channel 0=keybord",
        "--channel: file `keybord` not found; did you mean `keyboard`?",
    );
    check(
        "a.glsl --channel bufer_a.0=mic",
        "--channel: unknown pass `bufer_a`; did you mean `buffer_a`?",
    );
    check(
        "a.glsl --channel buffer_a.0=mic",
        "--channel: the project has no pass `buffer_a`; it has `image`",
    );
    check(
        "--pass imag=a.glsl",
        "--pass: unknown pass `imag`; did you mean `image`?",
    );
    folder.port_fails(
        "a.glsl -o a.vert",
        "-o a.vert: unknown output extension `.vert`; use `-o NAME.frag`, which writes NAME.vert as \
         well",
    );
    folder.write("p/other.json", "{}");
    check(
        "p",
        "p: no pass found; name the files `image.glsl`, `buffer_a.glsl`, `common.glsl`, or pass a \
         single file, such as p/other.json",
    );
}

#[test]
fn all_unicode_encodings_are_read() {
    let folder = with_shader();
    folder.write("bom.glsl", format!("\u{feff}{CODE}"));
    folder.write("p/image.glsl", format!("\u{feff}{CODE}"));
    let units = CODE.encode_utf16().flat_map(u16::to_le_bytes);
    folder.write(
        "wide.glsl",
        [0xff, 0xfe].into_iter().chain(units).collect::<Vec<u8>>(),
    );
    folder.write(
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
        folder.ports(&format!("{input} -o {i}.html"), "");
        let page = fs::read_to_string(folder.path(&format!("{i}.html"))).unwrap();
        assert!(
            !page.contains('\u{feff}') && !page.contains("\\ufeff"),
            "{input}"
        );
    }
    folder.write("page.glsl", "<!doctype html>");
    folder.port_fails(
        "page.glsl -o x.html",
        "page.glsl: expected a shader, found HTML or XML",
    );
    folder.port_fails(
        "/dev/zero -o x.html",
        "/dev/zero: the file is larger than 40 MB, the limit for shaders",
    );
    folder.port_fails(
        "p/image.glsl/x -o x.html",
        "p/image.glsl/x: no such file or folder",
    );
}

/// A page is small enough to send.
#[test]
fn pages_of_templates_are_small() {
    let folder = with_shader();
    for name in ["raymarching", "terrain", "voxel"] {
        let root = env!("CARGO_MANIFEST_DIR");
        let template = format!("{root}/corpus/templates/{name}.glsl");
        folder.write("t.glsl", fs::read(template).unwrap());
        let output = folder
            .port_command("-o t.html --force t.glsl")
            .output()
            .unwrap();
        assert!(output.status.success());
        let size = fs::metadata(folder.path("t.html")).unwrap().len();
        assert!(size < 100_000, "{name}: {size} bytes");
    }
}

#[test]
fn waiting_for_standard_input_is_reported() {
    let folder = with_shader();
    let mut command = folder.port_command("- -t html");
    let mut running = command
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut message = String::new();
    let mut errors = BufReader::new(running.stderr.take().unwrap());
    errors.read_line(&mut message).unwrap();
    assert!(
        message.starts_with("waiting for standard input"),
        "{message}"
    );
    let mut input = running.stdin.take().unwrap();
    input.write_all(CODE.as_bytes()).unwrap();
    drop(input);
    errors.read_to_string(&mut message).unwrap();
    assert_eq!(running.wait().unwrap().code(), Some(0), "{message}");
}

#[test]
fn unrepairable_text_is_not_reported_as_repaired() {
    let folder = with_shader();
    folder.write("text.glsl", "hello world\n");
    let (code, message) = folder.port("text.glsl -o text.html");
    assert_eq!(code, Some(1), "{message}");
    assert!(message.contains("unknown type `hello`"), "{message}");
    assert!(!message.contains("repaired"), "{message}");
    // A shader that a repair completes is repaired automatically, as WebGL2 requires it.
    let desktop = "#version 330\nout vec4 c;\nvoid main() { c = vec4(1 / 2.0f); }\n";
    folder.write("desktop.glsl", desktop);
    let (code, message) = folder.port("desktop.glsl -o desktop.html");
    assert_eq!(code, Some(0), "{message}");
    assert!(message.contains("repaired"), "{message}");
}

#[test]
fn channels_are_named_by_their_sampler() {
    let folder = with_shader();
    let code = "precision highp float;\nuniform sampler2D u_photo;\n\
        void main() { gl_FragColor = texture2D(u_photo, vec2(0.5)); }\n";
    folder.write("photo.frag", code);
    let note = "note: embedded a.png (34 bytes)";
    folder.ports("photo.frag --channel u_photo=a.png -o photo.html", note);
    let page = fs::read_to_string(folder.path("photo.html")).unwrap();
    assert!(page.contains("\"uniform\":\"u_photo\"") && page.contains("data:image/png"));
    let (code, message) = folder.port("photo.frag --channel photo=a.png -o other.html");
    assert_eq!(code, Some(2), "{message}");
    assert!(
        message.contains("unknown sampler `photo`; the shader has `u_photo`"),
        "{message}"
    );
}

#[test]
fn shaders_of_other_engines_are_one_error_and_write_no_files() {
    let folder = with_shader();
    let godot =
        "// Waves\nshader_type canvas_item;\nvoid fragment() { COLOR = vec4(UV, 0.0, 1.0); }\n";
    let hook = "//!HOOK LUMA\n//!BIND HOOKED\nvec4 hook() { return HOOKED_tex(HOOKED_pos); }\n";
    folder.write("waves.glsl", godot);
    folder.write("hook.glsl", hook);
    folder.write("p/image.glsl", CODE);
    folder.write("p/common.glsl", godot);
    let expected = |place: &str, found: &str| {
        format!("{place}: expected GLSL for ShaderToy, WebGL or another host, found {found}")
    };
    let found = "a Godot shader: `shader_type canvas_item`";
    folder.port_fails("waves.glsl -o a.html", &expected("waves.glsl:2", found));
    folder.port_fails(
        "waves.glsl -t json --repair",
        &expected("waves.glsl:2", found),
    );
    folder.port_fails("p -o p.html", &expected("p/common.glsl:2", found));
    let found = "a user shader of mpv: `//!HOOK LUMA`";
    folder.port_fails("hook.glsl -o a.html", &expected("hook.glsl:1", found));
    assert!(!folder.path("a.html").exists() && !folder.path("p.html").exists());
    // The user decides what a text is.
    let (code, message) = folder.port("waves.glsl --host shadertoy -o a.html");
    assert!(
        code == Some(1) || message.contains("no entry point"),
        "{message}"
    );
}

#[test]
fn skipped_files_that_were_named_are_reported() {
    let folder = with_shader();
    folder.write(
        "waves.glsl",
        "shader_type sky;\nvoid sky() { COLOR = vec3(0.0); }\n",
    );
    let lint = |args: &str| {
        let mut command = Command::new(get_cargo_bin("shaderlint"));
        command.current_dir(folder.path("")).args(args.split(' '));
        let out = command.output().unwrap();
        let text = String::from_utf8(out.stdout).unwrap() + &String::from_utf8(out.stderr).unwrap();
        (out.status.code(), text)
    };
    for _ in 0..2 {
        // A result in the cache says the same.
        let (code, text) = lint("waves.glsl");
        assert_eq!(code, Some(0));
        assert!(
            text.contains("waves.glsl: not checked: a Godot shader"),
            "{text}"
        );
    }
    let (_, text) = lint("--format json waves.glsl");
    assert!(
        text.contains(r#""read_as":"not checked: a Godot shader""#),
        "{text}"
    );
    assert!(text.contains(r#""shaders":0"#), "{text}");
}

#[test]
fn programs_of_a_screen_saver_are_passes() {
    let folder = with_shader();
    let code = "void mainImage(out vec4 c, in vec2 p) { c = COMMON * texelFetch(iChannel0, ivec2(p), 0); }\n";
    for name in ["s/sea-0.glsl", "s/sea-1.glsl", "s/sea-2.glsl"] {
        folder.write(name, code);
    }
    folder.write("s/sea-c.glsl", "#define COMMON vec4(1.0)\n");
    let note =
        "note: read as XScreenSaver: `iChannel0` to `iChannel3` are the outputs of programs 0 to 3";
    folder.ports("s -t json -o folder.json", note);
    folder.ports(
        "s/sea-1.glsl s/sea-0.glsl s/sea-c.glsl s/sea-2.glsl -t json -o files.json",
        note,
    );
    for name in ["folder.json", "files.json"] {
        let json: serde_json::Value =
            serde_json::from_slice(&fs::read(folder.path(name)).unwrap()).unwrap();
        let all = json.get("Shader").unwrap_or(&json)["renderpass"]
            .as_array()
            .unwrap()
            .clone();
        assert_eq!(all.len(), 4);
        for pass in all.iter().filter(|p| p["type"] != "common") {
            let input = &pass["inputs"][0];
            assert_eq!(
                (&input["channel"], &input["id"]),
                (&0.into(), &"4dXGR8".into())
            );
            assert_eq!(input["sampler"]["filter"], "nearest");
        }
    }
    folder.write("s/lake-0.glsl", code);
    let (exit, message) = folder.port("s -t json");
    assert!(
        exit == Some(2) && message.contains("no pass found"),
        "{message}"
    );
}

/// Compresses XML as KodeLife does.
fn compressed(xml: &str) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(xml.as_bytes()).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn projects_of_kodelife_are_decompressed_within_limits() {
    let folder = with_shader();
    let code = "uniform float clock; void main() { gl_FragColor = vec4(clock); }";
    let project = |api: &str, source: &str| {
        format!(
            "<klxml v='19' a='{api}'><document><params><param type='CLOCK'><variableName>clock</variableName>\
             </param></params><passes><pass type='RENDER'><stages><stage type='FRAGMENT'><shader>\
             <source profile='{source}'><![CDATA[{code}]]></source></shader></stage></stages></pass>\
             <pass type='COMPUTE'><properties><label>Sort</label></properties></pass></passes></document></klxml>"
        )
    };
    let read = "note: read as KodeLife (found `<klxml>`)\n";
    let other = "note: pass `Sort` is not drawn: its type is `COMPUTE`";
    folder.write("gl.klproj", compressed(&project("GL2", "GL2")));
    folder.write("gl.xml", project("GL2", "GL2"));
    folder.ports("gl.klproj -o gl.html", &format!("{read}{other}"));
    folder.ports("gl.xml -o xml.html", &format!("{read}{other}"));
    let page = fs::read_to_string(folder.path("gl.html")).unwrap();
    assert!(page.contains("#define clock port_kl_CLOCK"));
    folder.write("metal.klproj", compressed(&project("MTL", "GL2")));
    let older = "note: pass `pass 0`: the project is for `MTL`; its source for `GL2` is used, which may be older\n";
    folder.ports("metal.klproj -o m.html", &format!("{read}{older}{other}"));
    folder.write("none.klproj", compressed(&project("MTL", "MTL")));
    let (exit, message) = folder.port("none.klproj -o n.html");
    assert!(
        exit == Some(2) && message.contains("no pass of type `image`"),
        "{message}"
    );

    let whole = compressed(&project("GL2", "GL2"));
    folder.write("cut.klproj", &whole[..whole.len() / 2]);
    let (exit, message) = folder.port("cut.klproj -o c.html");
    assert!(
        exit == Some(2) && message.contains("the compressed project is damaged"),
        "{message}"
    );
    folder.write(
        "bomb.klproj",
        compressed(&format!("<klxml>{}", " ".repeat(41 << 20))),
    );
    folder.port_fails(
        "bomb.klproj -o b.html",
        "bomb.klproj: the project is larger than 40 MB when decompressed",
    );
}

/// Ranges that cannot become sliders are reported, and so are proposals; neither for plain shaders.
#[test]
fn sliders_are_listed() {
    let folder = with_shader();
    let code = "const int N = 2; // (0~4)\nconst float HALF = float(N) * 0.5; // (0~1)\n\
        const float GAIN = 0.5;\nfloat a[N];\n\
        void mainImage(out vec4 c, in vec2 p) { a[0] = HALF; c = vec4(a[0] * GAIN); }\n";
    folder.write("s.glsl", code);
    let refused = "note: no slider for `HALF`: its value is not a literal\n\
        note: no slider for `N`: with 0 the shader does not compile: array size cannot be 0";
    folder.ports("s.glsl -o s.html", refused);
    let proposed = format!("note: proposed sliders: `GAIN` (0~1)\n{refused}");
    folder.ports("s.glsl --sliders auto -o auto.js", &proposed);
    folder.ports("s.glsl --sliders none -o none.html", "");
    folder.ports("s.glsl --sliders auto -o s.frag", "");
}
