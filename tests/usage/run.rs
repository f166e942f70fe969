//! `run`: images, messages and rejected inputs.

use crate::scratch::Scratch;

/// Red increases to the right, green upwards; blue depends on a uniform.
const RAMP: &str = "#version 300 es
precision highp float;
uniform vec2 u_resolution;
uniform float gain;
uniform mat2 turn;
out vec4 color;
void main() {
    vec2 place = gl_FragCoord.xy / u_resolution;
    vec2 turned = turn * vec2(1.0, 0.0);
    color = vec4(place, gain * turned.y, 1.0);
}
";

/// A march that ends at a hit, and a loop that always runs four iterations.
const MARCH: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float t = 0.0;
    for (int i = 0; i < 8; i++) {
        if (t > fragCoord.x) break;
        t += 1.0;
    }
    for (int i = 0; i < 4; i++) {
        t += 0.5;
    }
    fragColor = vec4(t / 16.0, iTime, 0.0, 1.0);
}
";

/// A buffer that counts frames, and an image that shows it.
const COUNTER: &str = r#"{"info": {"name": "counter"}, "renderpass": [
    {"type": "image", "name": "Image", "code": "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }",
     "inputs": [{"id": "4dXGR8", "channel": 0, "type": "buffer", "sampler": {"filter": "nearest", "wrap": "clamp"}}],
     "outputs": [{"id": "4dfGRr", "channel": 0}]},
    {"type": "buffer", "name": "Buffer A", "code": "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + vec4(0.25, 0.0, 0.0, 1.0); }",
     "inputs": [{"id": "4dXGR8", "channel": 0, "type": "buffer", "sampler": {"filter": "nearest", "wrap": "clamp"}}],
     "outputs": [{"id": "4dXGR8", "channel": 0}]}]}"#;

/// Width, height and pixels of a PNG.
pub(super) fn pixels(scratch: &Scratch, name: &str) -> (u32, u32, Vec<[u8; 3]>) {
    let file = std::fs::File::open(scratch.path(name)).unwrap();
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let pixels = bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2]]);
    (info.width, info.height, pixels.collect())
}

#[test]
fn images_are_written_top_row_first() {
    let scratch = Scratch::new(&[
        ("a.frag", RAMP),
        ("u.json", "{\"gain\": 0.5, \"turn\": [0, 2, 0, 0]}"),
    ]);
    let args = ["run", "a.frag", "--size", "4x2", "--uniforms", "u.json"];
    let ran = scratch.run(&[&args[..], &["-o", "a.png"]].concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{}", ran.out);
    assert!(ran.out.contains("written   a.png"), "{}", ran.out);
    let (width, height, pixels) = pixels(&scratch, "a.png");
    assert_eq!((width, height), (4, 2));
    assert_eq!(pixels[0], [32, 191, 255]);
    assert_eq!(pixels[7], [223, 64, 255]);
    let again = scratch.run(&[&args[..], &["-o", "a.png"]].concat());
    assert_eq!(again.code, 2);
    assert!(
        again.err.contains("a.png already exists; use --force"),
        "{}",
        again.err
    );
    let over = scratch.run(&[&args[..], &["--force", "-o", "a.frag"]].concat());
    assert_eq!(over.code, 2);
    assert!(over.err.contains("a.frag is an input file"), "{}", over.err);
    for name in ["a.jpg", "a.JPEG", "b.png.webp"] {
        let other = scratch.run(&[&args[..], &["-o", name]].concat());
        assert_eq!((other.code, other.out.as_str()), (2, ""), "{name}");
        assert!(
            other.err.contains("images are written as PNG"),
            "{}",
            other.err
        );
    }
}

#[test]
fn invalid_uniforms_are_reported_with_their_position() {
    let scratch = Scratch::new(&[("a.frag", RAMP)]);
    for (json, expected) in [
        (
            "{\"gian\": 1}",
            "u.json:1:10: unknown uniform `gian`; did you mean `gain`?",
        ),
        (
            "{\n  \"turn\": [1, 2]\n}",
            "u.json:2:11: `turn` expects 4 numbers, found 2",
        ),
        ("{\"gain\": null}", "u.json:1:10: `gain`: expected a number"),
    ] {
        scratch.write("u.json", json);
        let ran = scratch.run(&["run", "a.frag", "--size", "2x2", "--uniforms", "u.json"]);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains(expected), "{}", ran.err);
    }
}

#[test]
fn uniforms_have_the_values_of_scripts() {
    let script = "import fragmentShader from './a.frag';
import { ShaderMaterial, Matrix2, Vector2 } from 'three';
const uniforms = { gain: { value: 0.5 }, u_resolution: { value: new Vector2() }, turn: { value: 1 } };
new ShaderMaterial({ fragmentShader, uniforms });
";
    let text = RAMP.replace("gain * turned.y", "gain");
    let scratch = Scratch::new(&[("a.frag", &text), ("main.js", script)]);
    let args = ["run", "a.frag", "--size", "2x2", "--force", "-o", "a.png"];
    let ran = scratch.run(&args);
    let note = "scripts give these uniforms their first values: `gain` = 0.5 (main.js:3)";
    assert!(ran.err.contains(note), "{}", ran.err);
    assert_eq!(pixels(&scratch, "a.png").2[0], [64, 191, 128]);
    let ran = scratch.run(&[&args[..], &["--format", "json"]].concat());
    assert!(ran.out.contains(note), "{}", ran.out);
    scratch.write("u.json", "{\"gain\": 1}");
    scratch.run(&[&args[..], &["--uniforms", "u.json"]].concat());
    assert_eq!(pixels(&scratch, "a.png").2[0], [64, 191, 255]);
}

#[test]
fn unset_uniforms_are_reported() {
    let scratch = Scratch::new(&[("a.frag", RAMP)]);
    let ran = scratch.run(&["run", "a.frag", "--size", "2x2"]);
    assert_eq!(ran.code, 0);
    assert!(ran.err.contains("default to 0: `gain`"), "{}", ran.err);
}

#[test]
fn loop_statistics_are_reported() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    let args = [
        "run", "m.glsl", "--size", "16x1", "--time", "0.5", "--report",
    ];
    let ran = scratch.run(&[&args[..], &["--format", "json"]].concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let reported: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(reported["schema"], 1);
    assert_eq!(reported["size"], serde_json::json!([16, 1]));
    assert_eq!(
        (&reported["time"], &reported["frame"]),
        (&0.5.into(), &30.into())
    );
    let march = &reported["loops"][0];
    assert_eq!(march["at"], "m.glsl:3:5");
    assert_eq!(
        (&march["bound"], &march["turns"]),
        (&"at most".into(), &8.into())
    );
    assert_eq!(
        (&march["most"], &march["exhausted"]),
        (&8.into(), &0.5625.into())
    );
    let steady = &reported["loops"][1];
    assert_eq!(
        (&steady["mean"], &steady["exhausted"]),
        (&4.0.into(), &serde_json::Value::Null)
    );
    let text = scratch.run(&args).out;
    assert!(text.contains("m.glsl:3:5  mainImage  at most 8"), "{text}");
}

#[test]
fn a_variable_can_be_shown_at_a_line() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    let args = [
        "run", "m.glsl", "--size", "16x1", "-o", "t.png", "--force", "--show",
    ];
    let ran = scratch.run(&[&args[..], &["t@5"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (_, _, pixels) = pixels(&scratch, "t.png");
    assert_ne!(pixels[0], pixels[15]);
    let ran = scratch.run(&[&args[..], &["t@1"]].concat());
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("`t` is not used on line 1; it is used on lines 2, 4, 5"),
        "{}",
        ran.err
    );
    let ran = scratch.run(&[&args[..], &["x@1"]].concat());
    assert!(
        ran.err.contains("reads or writes no variable `x`"),
        "{}",
        ran.err
    );
}

#[test]
fn positions_refer_to_included_files() {
    let scratch = Scratch::new(&[
        (
            "parts/tint.glsl",
            "float tint(float x) {\n    float c = x * 2.0;\n    return c;\n}\n",
        ),
        (
            "a.glsl",
            "#include \"parts/tint.glsl\"\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
             float a = tint(fragCoord.x);\n    fragColor = vec4(a);\n}\n",
        ),
    ]);
    let ran = scratch.run(&["run", "a.glsl", "--size", "8x8", "--pixel", "3,4"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    for place in ["parts/tint.glsl:2:11  tint", "a.glsl:3:11", "a.glsl:4:5"] {
        assert!(ran.out.contains(place), "{}", ran.out);
    }
    let ran = scratch.run(&["run", "a.glsl", "--size", "8x8", "--show", "a@8"]);
    let message = "`a` is not used on line 8; it is used on lines 3, 4";
    assert!(ran.err.contains(message), "{}", ran.err);
}

#[test]
fn heatmaps_have_a_legend() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    for heat in ["steps", "cost", "divergence", "overdraw", "nan"] {
        let name = format!("{heat}.png");
        let ran = scratch.run(&[
            "run",
            "m.glsl",
            "--size",
            "128x8",
            "--heatmap",
            heat,
            "-o",
            &name,
        ]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let (width, height, _) = pixels(&scratch, &name);
        assert_eq!((width, height), (128, 24));
    }
    let (_, _, steps) = pixels(&scratch, "steps.png");
    assert_ne!(steps[0], steps[20]);
    let (_, _, waiting) = pixels(&scratch, "divergence.png");
    // The old name.
    assert_eq!(waiting, pixels(&scratch, "overdraw.png").2);
    // The first pixels of a group leave the march before the others; further right all run eight
    // iterations.
    assert_ne!(waiting[0], waiting[7]);
    assert_eq!(waiting[7], waiting[64]);
}

#[test]
fn pixels_are_traced_step_by_step() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    let args = ["run", "m.glsl", "--size", "16x9", "--pixel", "2,1"];
    let ran = scratch.run(&args);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{}", ran.out);
    let expected = "\
m.glsl: pixel 2,1 of 16x9, 0 s, frame 0
  image     0.3125 0 0 1
  cost      32 operations
  loop        function   bound      max  mean  p99  exhausted
  m.glsl:3:5  mainImage  at most 8    4   4.0    4        0 %
  m.glsl:7:5  mainImage  exactly 4    4   4.0    4          -
  place        function   variable   first         last          times
  m.glsl:1:44  mainImage  fragCoord  2.5 1.5       2.5 1.5           1
  m.glsl:2:11  mainImage  t          0             0                 1
  m.glsl:3:14  mainImage  i          0             0                 1
  m.glsl:3:28  mainImage  i          1             3                 3
  m.glsl:5:9   mainImage  t          1             3                 3
  m.glsl:7:14  mainImage  i          0             0                 1
  m.glsl:7:28  mainImage  i          1             4                 4
  m.glsl:8:9   mainImage  t          3.5           5                 4
  m.glsl:10:5  mainImage  fragColor  0.3125 0 0 1  0.3125 0 0 1      1
";
    assert_eq!(ran.out, expected);
    let ran = scratch.run(&[&args[..], &["--format", "json"]].concat());
    let facts: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let sites = facts["sites"].as_array().unwrap();
    let steps = facts["steps"].as_array().unwrap();
    let of_t = steps.iter().filter(|step| {
        let site = &sites[usize::try_from(step[0].as_u64().unwrap()).unwrap()];
        site["name"] == "t"
    });
    let values: Vec<_> = of_t.map(|step| step[1][0].as_f64().unwrap()).collect();
    assert_eq!(values, [0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 4.5, 5.0]);
    let ran = scratch.run(&["run", "m.glsl", "--size", "16x9", "--pixel", "16,1"]);
    assert_eq!(ran.code, 2);
    let message = "the pixel 16,1 is outside the image of 16x9";
    assert!(ran.err.contains(message), "{}", ran.err);
    let ran = scratch.run(&["run", "m.glsl", "--pixel", "16"]);
    assert!(
        ran.err.contains("expected a pixel such as 320,180"),
        "{}",
        ran.err
    );
}

/// The second frame of a buffer that counts, read by the image.
#[test]
fn traced_pixels_of_a_pass_see_earlier_frames() {
    let scratch = Scratch::new(&[("counter.json", COUNTER)]);
    for (pass, expected) in [("image", "0.5 0 0 1"), ("buffer_a", "0.5 0 0 2")] {
        let args = [
            "run",
            "counter.json",
            "--size",
            "2x2",
            "--frame",
            "1",
            "--pixel",
            "1,1",
        ];
        let ran = scratch.run(&[&args[..], &["--pass", pass]].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        assert!(
            ran.out.contains(&format!("  image     {expected}\n")),
            "{}",
            ran.out
        );
    }
}

#[test]
fn costs_are_reported_by_function() {
    let shader = "float square(float x) { return x * x; }
float twice(float x) { return square(x) + square(x + 1.0); }
void mainImage(out vec4 color, in vec2 place) {
    color = vec4(twice(place.x) + square(place.y));
}
";
    let scratch = Scratch::new(&[("f.glsl", shader)]);
    let args = ["run", "f.glsl", "--size", "8x4", "--report"];
    let ran = scratch.run(&[&args[..], &["--format", "json"]].concat());
    let reported: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let all = reported["functions"].as_array().unwrap();
    let row = |name: &str| all.iter().find(|f| f["name"] == name).unwrap();
    assert_eq!(row("twice")["at"], "f.glsl:2:7");
    let count = |name: &str| row(name)["own_operations"].as_u64().unwrap();
    let sum: u64 = all
        .iter()
        .map(|f| f["own_operations"].as_u64().unwrap())
        .sum();
    assert_eq!(reported["cost"]["operations"], sum);
    let with = count("twice") + count("square") / 3 * 2;
    let share = row("twice")["with_callees"].as_f64().unwrap();
    assert!((share - with as f64 / sum as f64).abs() < 1e-12, "{share}");
    let text = scratch.run(&args).out;
    let line = text.lines().find(|l| l.contains("square")).unwrap();
    assert!(line.contains("f.glsl:1:7"), "{text}");
}

#[test]
fn shaders_are_compared_bit_by_bit() {
    let same = MARCH.replace("t / 16.0", "t * 0.0625");
    let other = MARCH.replace("t / 16.0", "t / 15.0");
    let files = [
        ("a.glsl", MARCH),
        ("same.glsl", &same),
        ("other.glsl", &other),
    ];
    let scratch = Scratch::new(&files);
    let args = ["run", "--size", "16x2", "a.glsl", "--compare"];
    let ran = scratch.run(&[&args[..], &["same.glsl"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.out);
    assert!(
        ran.out
            .contains("identical: compared 256 pixels in 8 frames"),
        "{}",
        ran.out
    );
    let ran = scratch.run(&[&args[..], &["other.glsl", "-o", "d.png"]].concat());
    assert_eq!(ran.code, 1, "{}", ran.out);
    assert!(
        ran.out.contains("a.glsl and other.glsl differ"),
        "{}",
        ran.out
    );
    assert!(scratch.path("d.png").exists());
}

#[test]
fn a_sheet_contains_images_at_several_times() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    let ran = scratch.run(&[
        "run", "m.glsl", "--size", "64x32", "--sheet", "4", "-o", "s.png",
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (width, height, pixels) = pixels(&scratch, "s.png");
    assert_eq!((width, height), (76, 62));
    let at = |x: usize, y: usize| pixels[y * 76 + x];
    // The second image is drawn at one second, and green increases with time.
    assert_eq!((at(10, 10)[1], at(50, 10)[1]), (0, 255));
    // The statistics of each frame.
    let lines: Vec<&str> = ran
        .out
        .lines()
        .filter(|l| l.starts_with("m.glsl:"))
        .collect();
    assert_eq!(lines.len(), 4, "{}", ran.out);
    assert_eq!(lines[1], "m.glsl: 64x32, 1 s, frame 60");
    assert_eq!(ran.out.matches("operations per pixel").count(), 4);
    let ran = scratch.run(&[
        "run", "m.glsl", "--size", "64x32", "--sheet", "2", "--every", "0.5", "--format", "json",
    ]);
    let sheet: serde_json::Value = serde_json::from_str(&ran.out).expect("JSON");
    assert_eq!(sheet["frames"][1]["time"], 0.5);
    assert!(sheet["frames"][0]["cost"]["operations"].as_u64() > Some(0));
}

#[test]
fn shaders_with_errors_are_reported_and_not_drawn() {
    let scratch = Scratch::new(&[("a.frag", &RAMP.replace("gain *", "gian *"))]);
    let ran = scratch.run(&["run", "a.frag", "-o", "a.png"]);
    assert_eq!(ran.code, 1);
    let message = "error[undeclared-name]: `gian` is not declared";
    let checked = scratch.run(&["a.frag"]);
    assert!(ran.out.starts_with(message), "{}", ran.out);
    assert!(checked.out.contains(message), "{}", checked.out);
    assert!(!scratch.path("a.png").exists());
    let ran = scratch.run(&["run", "none.frag"]);
    assert_eq!(ran.code, 2, "{}", ran.err);
}

#[test]
fn varyings_contain_the_pixel_position() {
    let shader = "precision highp float;\nvarying vec2 vUv;\n\
        void main() { gl_FragColor = vec4(vUv, 0.0, 1.0); }\n";
    let scratch = Scratch::new(&[("v.frag", shader)]);
    let ran = scratch.run(&["run", "v.frag", "--size", "4x2", "-o", "v.png"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (_, _, pixels) = pixels(&scratch, "v.png");
    assert_eq!((pixels[0], pixels[7]), ([32, 191, 0], [223, 64, 0]));
}

#[test]
fn images_are_drawn_in_the_terminal() {
    let scratch = Scratch::new(&[("m.glsl", MARCH)]);
    let mut command = scratch.command(&["run", "m.glsl", "--size", "4x2", "--color", "always"]);
    command.env("TERM", "xterm").env("COLORTERM", "truecolor");
    let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
    let line = out.lines().next().unwrap();
    assert_eq!(line.matches('▀').count(), 4, "{out}");
    assert!(line.starts_with("\u{1b}[38;2;"), "{out}");
}

#[test]
fn the_readme_images_are_up_to_date() {
    let scratch = Scratch::new(&[]);
    let templates = crate::scratch::root().join("corpus/templates");
    let shader = templates.join("voxel.glsl");
    let args = [
        "run",
        shader.to_str().unwrap(),
        "--size",
        "320x180",
        "--time",
        "6",
    ];
    for (name, more) in [
        ("voxel.png", &[][..]),
        ("voxel.steps.png", &["--heatmap", "steps"]),
    ] {
        let ran = scratch.run(&[&args[..], more, &["-o", name]].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        std::fs::copy(templates.join(name), scratch.path("kept.png")).unwrap();
        let drawn = pixels(&scratch, name);
        assert!(
            drawn == pixels(&scratch, "kept.png"),
            "{name} is out of date"
        );
    }
}

#[test]
fn projects_are_run_with_all_their_passes() {
    let scratch = Scratch::new(&[("counter.json", COUNTER)]);
    let args = [
        "run",
        "counter.json",
        "--size",
        "2x2",
        "--frame",
        "1",
        "--force",
        "-o",
        "c.png",
    ];
    let ran = scratch.run(&args);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let (_, _, drawn) = pixels(&scratch, "c.png");
    assert_eq!(drawn, [[128, 0, 0]; 4]);
    let ran = scratch.run(&[&args[..], &["--pass", "buffer_a"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let ran = scratch.run(&[&args[..], &["--pass", "buffer_b"]].concat());
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("the project has no pass `buffer_b`; it has image, buffer_a"),
        "{}",
        ran.err
    );
}

/// Four colours, with red in the upper left corner.
const COLORS: [[u8; 3]; 4] = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 0]];

/// A PNG file of 2x2 pixels.
fn colors() -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 2, 2);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(COLORS.as_flattened()).unwrap();
    writer.finish().unwrap();
    file
}

/// Images from `--channel`, `channels.toml` and an export have the same orientation as on the page;
/// a file that is not an image is reported.
#[test]
fn channel_images_have_the_correct_orientation() {
    let show = "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }";
    let scratch = Scratch::new(&[("show.glsl", show)]);
    scratch.write("colors.png", colors());
    scratch.write("half.png", &colors()[..40]);
    scratch.write("sound.wav", b"RIFF\x04\0\0\0WAVEfmt ");
    let draw = |more: &[&str]| {
        let args = ["--size", "2x2", "--force", "-o", "drawn.png"];
        let ran = scratch.run(&[&["run"], more, &args].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        (pixels(&scratch, "drawn.png").2, ran.out + &ran.err)
    };
    let flipped = [COLORS[2], COLORS[3], COLORS[0], COLORS[1]];
    assert_eq!(draw(&["show.glsl", "--channel", "0=colors.png"]).0, COLORS);
    let noflip = "0=colors.png,nearest,clamp,noflip";
    assert_eq!(draw(&["show.glsl", "--channel", noflip]).0, flipped);
    let (drawn, message) = draw(&["show.glsl", "--channel", "0=half.png"]);
    assert_eq!(drawn, [[0; 3]; 4]);
    assert!(message.contains("; the channel is empty"), "{message}");
    let (_, message) = draw(&["show.glsl", "--channel", "0=sound.wav"]);
    assert!(
        message.contains("; using a synthetic spectrum and wave"),
        "{message}"
    );
    let ran = scratch.run(&[
        "run",
        "show.glsl",
        "--channel",
        "0=color.png",
        "-o",
        "x.png",
    ]);
    assert_eq!((ran.code, scratch.path("x.png").exists()), (2, false));
    assert!(
        ran.err.contains("file `color.png` not found"),
        "{}",
        ran.err
    );
    scratch.write("channels.toml", "0 = \"colors.png,nearest\"\n");
    assert_eq!(draw(&["show.glsl"]).0, COLORS);
    // Media that `shaderport` embeds in an export are drawn.
    let mut port = std::process::Command::new(insta_cmd::get_cargo_bin("shaderport"));
    port.current_dir(scratch.path("."));
    let made = port
        .args(["show.glsl", "-o", "project.json"])
        .output()
        .unwrap();
    assert!(made.status.success());
    std::fs::remove_file(scratch.path("channels.toml")).unwrap();
    assert_eq!(draw(&["project.json"]).0, COLORS);
}
