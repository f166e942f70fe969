//! Files of other tools that contain shaders: both programs read the same shader for the same host,
//! and report the same errors.

use crate::scratch::Scratch;

/// The places of the errors that `shaderport` prints: the line and the column.
fn ported(scratch: &Scratch, file: &str) -> Vec<String> {
    let (_, message) = scratch.port(&format!("{file} -o out.html --force"));
    let marked = message.lines().filter_map(|line| line.split_once("┌─ "));
    let places = marked.filter_map(|(_, place)| place.strip_prefix(&format!("{file}:")));
    places.map(str::to_string).collect()
}

/// The same for `shaderlint`.
fn linted(scratch: &Scratch, file: &str) -> Vec<String> {
    let places = scratch.places(&[file]).into_iter();
    let place = |text: String| text.split_once(' ').map(|(place, _)| place.to_string());
    places.filter_map(place).collect()
}

/// The host that `shaderlint` names.
#[track_caller]
fn check_host(scratch: &Scratch, file: &str, host: &str) {
    let ran = scratch.run(&[file, "-v"]);
    assert!(ran.err.contains(host), "{}", ran.err);
    assert!(!ran.out.contains("error["), "{}", ran.out);
    let run = scratch.run(&["run", file, "--size", "16x9"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
}

/// A configuration of niri, with a body for its first shader.
fn configuration(open: &str, body: &str, close: &str) -> String {
    format!(
        "// custom-shader \"vec4 open_color(vec3 a, vec3 b) {{ return vec4(x); }}\"\n\
         screenshot-path \"~/a \\\" {{shader}}\"\nwindow-open {{\n    custom-shader {open}\n\
         vec4 open_color(vec3 at, vec3 size) {{\n    {body}\n}}\n{close}; duration-ms 200 }}\n\
         window-close {{ custom-shader {open}vec4 close_color(vec3 at, vec3 size) {{ return vec4(1.0); }}{close} }}\n"
    )
}

#[test]
fn shaders_in_strings_of_kdl_are_read() {
    let scratch = Scratch::new(&[]);
    let good = "return texture2D(niri_tex, at.st) * niri_clamped_progress;";
    for (open, close) in [
        ("r\"", "\""),
        ("r##\"", "\"##"),
        ("#\"\"\"", "\"\"\"#"),
        ("\"", "\""),
    ] {
        scratch.write("w.kdl", configuration(open, good, close));
        let (code, message) = scratch.port("w.kdl -o out.html --force");
        assert_eq!(code, Some(0), "{message}");
        assert!(message.contains("note: read as niri (found "), "{message}");
        let more = "note: the first of 2 shaders is drawn; the next one starts in line 9";
        assert!(message.contains(more), "{message}");
        check_host(&scratch, "w.kdl", "for niri");
        scratch.write(
            "w.kdl",
            configuration(open, "return texture2D(niri_tex, unknown);", close),
        );
        let places = ["6:32"];
        assert_eq!(ported(&scratch, "w.kdl"), places, "{open}");
        assert_eq!(linted(&scratch, "w.kdl"), places, "{open}");
    }
}

#[test]
fn projects_of_kodelife_are_drawn_by_their_fragment_stages() {
    let scratch = Scratch::new(&[]);
    let project = |body: &str| {
        format!(
            "<klxml v='18' a='GL3'><document><passes><pass type='RENDER'><stages>\
             <stage type='VERTEX'><params><param type='CONSTANT_CUBE'><variableName>c</variableName></param></params>\
             <shader><source profile='GL3'><![CDATA[#version 150\nin vec4 a_position;\n\
             void main() {{ gl_Position = a_position; }}\n]]></source></shader></stage>\
             <stage type='FRAGMENT'><shader><source profile='GL3'><![CDATA[#version 150\nout vec4 color;\n\
             void main() {{ color = {body}; }}\n]]></source></shader></stage></stages></pass></passes></document></klxml>"
        )
    };
    scratch.write("k.klproj", project("vec4(gl_FragCoord.xy * 0.01, 0, 1)"));
    let (code, message) = scratch.port("k.klproj -o k.html");
    assert_eq!(code, Some(0), "{message}");
    // No stage that is not run has parameters without a value.
    assert!(!message.contains("not supported"), "{message}");
    check_host(&scratch, "k.klproj", "checked as KodeLife: fragment shader");
    scratch.write("k.klproj", project("vec4(unknown)"));
    assert_eq!(ported(&scratch, "k.klproj"), ["3:28"]);
    assert_eq!(linted(&scratch, "k.klproj"), ["3:28"]);
}

#[test]
fn a_script_with_one_shader_is_ported() {
    let scratch = Scratch::new(&[]);
    let code = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";
    scratch.write("a.js", format!("export const wave = `\n{code}`;\n"));
    assert_eq!(scratch.port("a.js -o a.html").0, Some(0));
    scratch.write("b.js", format!("const a = `{code}`, b = `{code}`;\n"));
    let message = "b.js: expected a shader, found a script; move the shader to a file of its own";
    scratch.port_fails("b.js -o b.html", message);
}

#[test]
fn presets_of_milkdrop_are_refused() {
    let scratch = Scratch::new(&[]);
    scratch.write(
        "p.milk",
        "MILKDROP_PRESET_VERSION=201\n[preset00]\nzoom=1.01\n",
    );
    scratch.port_fails(
        "p.milk -o p.html",
        "p.milk:2: expected GLSL for ShaderToy, WebGL or another host, found a MilkDrop preset: `[preset00]`",
    );
}

#[test]
fn transitions_have_controls_with_their_defaults() {
    let scratch = Scratch::new(&[]);
    let code = "uniform float soft; // = 0.3\nuniform vec2 way; // = vec2(1.0, -4)\n\
        uniform ivec2 cells; /* = ivec2(4) */\nuniform float plain; // (0~4)\n\
        float hide(float from) { return step(from, progress) * soft * plain; }\n\
        vec4 transition(vec2 uv) {\n    return mix(getFromColor(uv), getToColor(uv * way * vec2(cells)), hide(uv.x));\n}\n";
    scratch.write("t.glsl", code);
    let (exit, message) = scratch.port("t.glsl -o t.html");
    assert_eq!(exit, Some(0), "{message}");
    let page = scratch.read("t.html");
    for value in ["[0.3]", "[1.0,-4.0]", "[4.0,4.0]", "[2.0]"] {
        assert!(page.contains(&format!("\"value\":{value}")), "{value}");
    }
    check_host(&scratch, "t.glsl", "checked as GL Transitions (found ");
    scratch.write("t.glsl", code.replace("* plain", "* unknown"));
    assert_eq!(ported(&scratch, "t.glsl"), ["5:63"]);
    assert_eq!(linted(&scratch, "t.glsl"), ["5:63"]);
}

/// Ghostty compiles desktop GLSL, which accepts what the repairs replace.
#[test]
fn desktop_glsl_of_a_host_is_accepted_by_all_commands() {
    let code = "vec4 TINT = vec4(iCurrentCursorColor.rgb * 0.5, 1);\n\
        layout(location = 0) uniform float gain;\n\
        float cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x * gain; };\n\
        void mainImage(out vec4 o, in vec2 p) {\n    vec2 ends[2] = { vec2(0, 1), vec2(1, 2) };\n    \
        o = texture(iChannel0, p / iResolution.xy) + TINT * cross(ends[0], ends[1]) * 2;\n}\n";
    let scratch = Scratch::new(&[("g.glsl", code)]);
    let (exit, message) = scratch.port("g.glsl -o g.html");
    assert_eq!(exit, Some(0), "{message}");
    assert!(
        message.contains("note: read as Ghostty (found `iCurrentCursorColor`)\n"),
        "{message}"
    );
    check_host(&scratch, "g.glsl", "checked as Ghostty (found ");
}
