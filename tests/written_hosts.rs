//! Shaders that `shaderport` writes for other hosts than pages.
#![cfg(unix)]

use super::port::with_shader;
use shaderlint::host::Preset;
use shaderlint::port::{HostedShader, Target};
use std::fs;

/// Uses names that hosts declare too, a macro for an input, and an input that no code reads.
const TOY: &str = "#define T iTime\n\
    float tex(vec2 p) { return sin(p.x * 10.0 + T); }\n\
    float unused() { return iMouse.x; }\n\
    void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
    vec2 uv = fragCoord / iResolution.xy;\n    float time = T * 0.5;\n    \
    fragColor = vec4(uv, tex(uv) * time, 0.3);\n}\n";

/// A shader that GLSL ES 1.00 has everything for, without a clock.
const STILL: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
    vec2 uv = fragCoord / iResolution.xy;\n    \
    fragColor = vec4(uv, sin(uv.x * 40.0) * cos(uv.y * 30.0), 1.0);\n}\n";

/// Draws what is behind, with the upper part darker.
const SCREEN: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
    vec2 uv = fragCoord / iResolution.xy;\n    \
    fragColor = texture(iChannel0, uv + vec2(0.1, 0.0)) * (1.0 - 0.5 * uv.y);\n}\n";

fn hosts() -> impl Iterator<Item = &'static Preset> {
    Target::hosts()
}

#[test]
fn every_host_with_a_template_draws_the_same_image() {
    let folder = with_shader();
    folder.write("toy.glsl", TOY);
    folder.write("still.glsl", STILL);
    folder.write("screen.glsl", SCREEN);
    let mut count = 0;
    for host in hosts() {
        let name = host.name;
        let knows_time = name != "niri";
        let has_screen = name != "xscreensaver";
        for (shader, is_written) in [("toy", knows_time), ("still", true), ("screen", has_screen)] {
            let out = format!("{shader}-{name}.frag");
            let (code, message) =
                folder.port(&format!("{shader}.glsl -t {name} --verify -o {out}"));
            if !is_written {
                assert_eq!(code, Some(1), "{name}, {shader}: {message}");
                assert!(!folder.path(&out).exists(), "{name}, {shader}");
                continue;
            }
            assert_eq!(code, Some(0), "{name}, {shader}: {message}");
            let is_same = message.contains("Image: identical on 9152 pixels")
                || message.contains("Image: identical code");
            assert!(is_same, "{name}, {shader}: {message}");
            // The host is recognised, or it is one that runs code of ShaderToy.
            let (code, message) = folder.port(&format!("{out} -o {out}.html"));
            assert_eq!(code, Some(0), "{name}, {shader}: {message}");
            let runs_toys = host.entries.iter().any(|entry| entry == "mainImage");
            let is_read = message.contains(&format!("read as {} (found ", host.read_as()));
            assert!(is_read || runs_toys, "{name}, {shader}: {message}");
            count += 1;
        }
    }
    assert_eq!(count, 13);
}

#[test]
fn uses_of_variables_the_host_lacks_are_errors() {
    let folder = with_shader();
    let check = |code: &str, target: &str, expected: &[&str]| {
        folder.write("x.glsl", code);
        let (exit, message) = folder.port(&format!("x.glsl -t {target} -o out.glsl"));
        assert_eq!(exit, Some(1), "{target}: {message}");
        assert!(!folder.path("out.glsl").exists(), "{target}: {message}");
        for part in expected {
            assert!(message.contains(part), "{target}: {part}\n{message}");
        }
    };
    let image = |body: &str| format!("void mainImage(out vec4 c, in vec2 p) {{\n    {body}\n}}\n");
    let mouse = image("c = iMouse * float(iFrame);");
    let lacks = |host: &str, name: &str| format!("host `{host}` does not provide `{name}`: ");
    let frame = lacks("hyprland", "iFrame");
    check(
        &mouse,
        "hyprland",
        &[&frame, "x.glsl:2:24", "Found 1 error"],
    );
    let second = lacks("ghostty", "iChannel1");
    check(
        &image("c = texture(iChannel1, p);"),
        "ghostty",
        &[&second, "x.glsl:2:17"],
    );
    let cube = lacks("flutter", "iChannel0");
    check(
        &image("c = texture(iChannel0, p.xyx);"),
        "flutter",
        &[&cube],
    );
    // The language of the host.
    let lookup = "host `flutter` does not accept this: `textureLod` is called";
    check(
        &image("c = textureLod(iChannel0, p, 0.0);"),
        "flutter",
        &[lookup, "x.glsl:2:9"],
    );
    let integers = image("int time = 3 & 1;\n    c = vec4(time);");
    check(
        &integers,
        "niri",
        &["host `niri` does not accept this: ", "x.glsl:2:"],
    );
    let upside = image("c = textureGrad(iChannel0, p, p, p);");
    check(&upside, "hyprland", &["`textureGrad`", "x.glsl:2:9"]);
}

/// ShaderToy's mouse is 0 until the first click, and so it stays.
#[test]
fn the_mouse_is_zero_on_hosts_without_one() {
    let folder = with_shader();
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    \
        vec2 at = iMouse.z > 0.0 ? iMouse.xy : p;\n    c = vec4(sin(at), 0.0, 1.0);\n}\n";
    folder.write("x.glsl", code);
    for host in ["ghostty", "hyprland"] {
        let (exit, message) = folder.port(&format!("x.glsl -t {host} --verify -o {host}.glsl"));
        assert_eq!(exit, Some(0), "{host}: {message}");
        let warning = format!("host `{host}` has no mouse: `iMouse` stays 0");
        for part in [&*warning, "x.glsl:2:15", "Image: identical"] {
            assert!(message.contains(part), "{host}: {part}\n{message}");
        }
    }
    let written = fs::read_to_string(folder.path("ghostty.glsl")).unwrap();
    assert!(!written.contains("iMouse2"), "{written}");
}

#[test]
fn inputs_of_an_export_that_the_host_lacks_are_errors() {
    let folder = with_shader();
    let export = |input: &str| {
        format!(
            r#"{{"renderpass":[{{"type":"image","outputs":[],"inputs":[{input}],
            "code":"void mainImage(out vec4 c, in vec2 p) {{ c = texture(iChannel0, p); }}"}}]}}"#
        )
    };
    for (number, kind) in ["texture", "keyboard", "music", "webcam"]
        .iter()
        .enumerate()
    {
        let input =
            format!(r#"{{"id":"4dfGRn","src":"/media/a/x.jpg","ctype":"{kind}","channel":0}}"#);
        folder.write("x.json", export(&input));
        let (code, message) = folder.port(&format!("x.json -t ghostty -o {number}.glsl"));
        assert_eq!(code, Some(1), "{kind}: {message}");
        let lacks = "host `ghostty` does not provide `iChannel0`: ";
        assert!(message.contains(lacks), "{kind}: {message}");
    }
}

#[test]
fn flutter_output_has_a_class_that_sets_its_uniforms() {
    let folder = with_shader();
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    \
        c = texture(iChannel0, p / iResolution.xy) * iMouse * float(iFrame) * iTime;\n}\n";
    folder.write("sea.glsl", code);
    let (exit, message) = folder.port("sea.glsl -t flutter --verify -o sea.frag");
    assert_eq!(exit, Some(0), "{message}");
    let read = |name: &str| fs::read_to_string(folder.path(name)).unwrap();
    insta::assert_snapshot!(
        "flutter",
        format!("{}\n{}", read("sea.frag"), read("sea.dart"))
    );
}

#[test]
fn screen_saver_programs_are_written_and_read_back() {
    let folder = with_shader();
    folder.write(
        "toy/common.glsl",
        "float wave(float x) { return sin(x); }\n",
    );
    let buffer =
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x), iTime, 0.0, 0.5); }\n";
    folder.write("toy/buffer_a.glsl", buffer);
    let second =
        "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel2, ivec2(p), 0); }\n";
    folder.write("toy/buffer_b.glsl", second);
    let image = "void mainImage(out vec4 c, in vec2 p) {\n    vec2 at = p / iResolution.xy;\n    \
        c = wave(at.x) * texture(iChannel0, at) + texture(iChannel1, at);\n}\n";
    folder.write("toy/image.glsl", image);
    let channels =
        "--channel buffer_b.2=buffer_a --channel image.0=buffer_b --channel image.1=buffer_a";
    let (code, message) = folder.port(&format!("toy {channels} -t xscreensaver --verify -o sea/"));
    assert_eq!(code, Some(0), "{message}");
    for pass in ["buffer_a", "buffer_b", "image"] {
        assert!(message.contains(&format!("{pass}: identical")), "{message}");
    }
    let read = |name: &str| fs::read_to_string(folder.path(name)).unwrap();
    assert!(read("sea/sea-c.glsl").starts_with("float wave("));
    assert_eq!(read("sea/sea-0.glsl"), buffer);
    assert_eq!(
        read("sea/sea-1.glsl"),
        second.replace("iChannel2", "iChannel0")
    );
    assert!(read("sea/sea-2.glsl").contains("texture(iChannel1, at) + texture(iChannel0, at)"));
    let (code, message) = folder.port("sea -t json -o back.json");
    assert_eq!(
        (code, message.contains("read as XScreenSaver")),
        (Some(0), true)
    );
    let own = format!("toy {channels} --channel buffer_a.0=buffer_a -t xscreensaver -o no/");
    folder.write(
        "toy/buffer_a.glsl",
        buffer.replace("wave(p.x)", "texelFetch(iChannel0, ivec2(p), 0).x"),
    );
    let (code, message) = folder.port(&own);
    let lacks = "a program cannot read what it drew itself";
    assert!(code == Some(1) && message.contains(lacks), "{message}");
}

/// Complete shaders of other hosts, with a `main` and uniforms of their own.
#[test]
fn shaders_of_other_hosts_are_written() {
    let folder = with_shader();
    let old = "precision mediump float;\nuniform float time;\nuniform vec2 resolution;\n\
        float tex(vec2 p) { return sin(p.x * 9.0 + time); }\nvoid main() {\n    \
        vec2 uv = gl_FragCoord.xy / resolution;\n    \
        gl_FragColor = vec4(uv, tex(uv), 1.0);\n}\n";
    let new = "#version 300 es\nprecision highp float;\nuniform vec2 u_resolution;\n\
        uniform float u_time;\nout vec4 color;\nvoid main() {\n    \
        color = vec4(fract(gl_FragCoord.xy / u_resolution + u_time), 0.0, 1.0);\n}\n";
    let both = "precision mediump float;\nuniform float time;\nuniform vec2 resolution;\n\
        #define iTime time\nvoid mainImage(out vec4 c, vec2 p) { c = vec4(p / resolution, iTime, 1.0); }\n\
        void main() { mainImage(gl_FragColor, gl_FragCoord.xy); }\n";
    folder.write("old.frag", old);
    folder.write("new.frag", new);
    folder.write("both.frag", both);
    for name in ["ghostty", "hyprland", "flutter"] {
        for shader in ["old", "new", "both"] {
            let out = format!("{shader}-{name}.glsl");
            let (code, message) =
                folder.port(&format!("{shader}.frag -t {name} --verify -o {out}"));
            assert_eq!(code, Some(0), "{name}, {shader}: {message}");
            assert!(message.contains("identical"), "{name}, {shader}: {message}");
        }
    }
    folder.write(
        "mouse.frag",
        old.replace("+ time", "+ time * mouse.x")
            .replace("uniform float", "uniform vec2 mouse;\nuniform float"),
    );
    let (code, message) = folder.port("mouse.frag -t ghostty -o mouse.glsl");
    assert_eq!(code, Some(1));
    let lacks = "host `ghostty` does not provide `mouse`";
    assert!(message.contains(lacks), "{message}");
}

/// The template of each host alone is a shader of that host.
#[test]
fn templates_of_hosts_compile() {
    for host in hosts() {
        let template = host.template.as_ref().unwrap();
        assert!(template.tail.is_empty() || template.tail.contains("port_image("));
        assert!(HostedShader::of(host, STILL).is_some(), "{}", host.name);
    }
}
