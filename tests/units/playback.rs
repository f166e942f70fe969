//! Tests of small projects, in which a few pixels show whether channels are right.

use serde_json::{Value, json};
use shaderlint::engine::inputs::{Button, Moment, Mouse};
use shaderlint::exec::CompileOptions;
use shaderlint::play::{PlaybackOptions, PlaybackProblem, Player};
use shaderlint::project::{Project, add_stand_ins};

const BUFFERS: [&str; 4] = ["4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"];

fn pass(kind: &str, output: &str, code: &str, inputs: &[Value]) -> Value {
    json!({"type": kind, "code": code, "inputs": inputs, "outputs": [{"id": output, "channel": 0}]})
}

fn image(code: &str, inputs: &[Value]) -> Value {
    pass("image", "4dfGRr", code, inputs)
}

fn buffer(number: usize, code: &str, inputs: &[Value]) -> Value {
    pass("buffer", BUFFERS[number], code, inputs)
}

/// A channel that reads a buffer.
fn reads(channel: u8, number: usize, filter: &str) -> Value {
    let sampler = json!({"filter": filter, "wrap": "clamp"});
    json!({"channel": channel, "type": "buffer", "id": BUFFERS[number], "sampler": sampler})
}

fn player(passes: &[Value], size: [u32; 2]) -> Result<Player, PlaybackProblem> {
    let export = json!({ "renderpass": passes }).to_string();
    let mut project = Project::from_json(&export).unwrap();
    add_stand_ins(&mut project);
    let composed = project.resolve("").unwrap();
    let options = PlaybackOptions {
        size,
        threads: 1,
        observed: None,
        compile: CompileOptions::default(),
        decode: None,
    };
    Player::new(&project, &composed, &options)
}

/// The first pixel of a frame.
fn first(passes: &[Value], frame: u32) -> [f32; 4] {
    let mut player = player(passes, [8, 4]).unwrap();
    let played = player
        .play_to(&Moment::of_frame(frame), &mut |_| {})
        .unwrap();
    played.image.pixels[0]
}

const SHOW: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }";
const COUNT: &str =
    "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + 0.125; }";

#[test]
fn buffers_read_their_previous_frame() {
    let passes = [
        image(SHOW, &[reads(0, 0, "nearest")]),
        buffer(0, COUNT, &[reads(0, 0, "nearest")]),
    ];
    assert_eq!(first(&passes, 0)[0], 0.125);
    assert_eq!(first(&passes, 4)[0], 0.625);
    let mut player = player(&passes, [2, 2]).unwrap();
    assert!(player.remembers());
    player.frame(&Moment::of_frame(0)).unwrap();
    let next = player.frame(&Moment::of_frame(1)).unwrap();
    assert_eq!(next.image.pixels[3][2], 0.25);
    let again = player.frame(&Moment::of_frame(0)).unwrap();
    assert_eq!(again.image.pixels[3][2], 0.125);
    assert_eq!(again.passes.len(), 2);
}

/// Buffers are drawn in the order of the export; a buffer that is drawn later is read with its
/// previous content.
#[test]
fn passes_draw_in_the_order_of_the_export() {
    let frame = "void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame)); }";
    let passes = [
        image(SHOW, &[reads(0, 1, "nearest")]),
        buffer(0, frame, &[]),
        buffer(1, SHOW, &[reads(0, 0, "nearest")]),
    ];
    assert_eq!(first(&passes, 5)[0], 5.0);
    assert!(!player(&passes, [2, 2]).unwrap().remembers());
    let passes = [
        image(SHOW, &[reads(0, 1, "nearest")]),
        buffer(1, SHOW, &[reads(0, 0, "nearest")]),
        buffer(0, frame, &[]),
    ];
    assert_eq!(first(&passes, 5)[0], 4.0);
}

#[test]
fn uniforms_have_the_values_of_the_player() {
    let code = "void mainImage(out vec4 c, in vec2 p) {
        bool ok = iResolution == vec3(8, 4, 1) && iTime == 0.5 && iFrame == 30 && iFrameRate == 60.0
            && abs(iTimeDelta - 1.0 / 60.0) < 1e-6 && iSampleRate == 44100.0
            && iDate == vec4(2000, 0, 1, 0.5) && iMouse == vec4(3, 2, 3, -2)
            && iChannelResolution[0] == vec3(8, 4, 1) && iChannelResolution[1] == vec3(256, 3, 1)
            && iChannelResolution[2] == vec3(0) && iChannelResolution[3] == vec3(64, 64, 1)
            && iCh3.size == vec3(64, 64, 1) && iCh0.loaded == 1 && iCh2.loaded == 0;
        c = vec4(ok, texelFetch(iChannel2, ivec2(0), 0).a, 0, 0.5);
    }";
    let inputs = [
        reads(0, 0, "linear"),
        json!({"channel": 1, "type": "keyboard", "id": "4dXGRr"}),
        json!({"channel": 3, "type": "texture", "id": "XdXGzn", "sampler": {"filter": "mipmap"}}),
    ];
    let passes = [image(code, &inputs), buffer(0, COUNT, &[])];
    let mut player = player(&passes, [8, 4]).unwrap();
    let moment = Moment {
        mouse: Some(Mouse {
            at: [3.5, 2.0],
            button: Button::Down,
        }),
        ..Moment::at(0.5)
    };
    let played = player.play_to(&moment, &mut |_| {}).unwrap();
    assert_eq!(played.image.pixels[0], [1.0, 1.0, 0.0, 1.0]);
}

#[test]
fn common_code_is_part_of_every_pass() {
    let common = json!({"type": "common", "code": "float half_of(float x) { return x * 0.5; }"});
    let code = "void mainImage(out vec4 c, in vec2 p) { c = vec4(half_of(p.x)); }";
    assert_eq!(first(&[common, image(code, &[])], 0)[0], 0.25);
}

#[test]
fn placeholder_textures_are_drawn_and_filtered() {
    let code = "void mainImage(out vec4 c, in vec2 p) {
        c = vec4(textureLod(iChannel0, vec2(0.3), 0.0).r, textureLod(iChannel0, vec2(0.3), 6.0).r, 0, 1);
    }";
    let input = |filter: &str| {
        let sampler = json!({"filter": filter, "wrap": "repeat", "vflip": "true"});
        json!({"channel": 0, "type": "texture", "id": "XdXGzn", "sampler": sampler})
    };
    let [sharp, mean, ..] = first(&[image(code, &[input("mipmap")])], 0);
    assert!((mean - 0.5).abs() < 0.05 && sharp != mean, "{sharp} {mean}");
    let [_, mean, ..] = first(&[image(code, &[input("nearest")])], 0);
    assert!(mean != 0.5);
}

#[test]
fn mipmaps_of_buffers_are_created_if_they_are_read() {
    let code =
        "void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec2(0.5), 3.0); }";
    let drawn = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.x < 2.0 ? 1.0 : 0.0); }";
    let with = |filter| {
        let passes = [image(code, &[reads(0, 0, filter)]), buffer(0, drawn, &[])];
        first(&passes, 0)[0]
    };
    assert_eq!(with("mipmap"), 0.25);
    assert_eq!(with("nearest"), 0.0);
}

#[test]
fn discarded_pixels_keep_their_values() {
    let drawn = "void mainImage(out vec4 c, in vec2 p) {
        if (iFrame > 1) discard;
        c = vec4(float(iFrame + 1) / 4.0);
    }";
    let passes = [
        image(SHOW, &[reads(0, 0, "nearest")]),
        buffer(0, drawn, &[]),
    ];
    let mut player = player(&passes, [2, 2]).unwrap();
    let mut seen = Vec::new();
    for frame in 0..5 {
        let played = player.frame(&Moment::of_frame(frame)).unwrap();
        seen.push(played.image.pixels[0][0]);
    }
    // Two images alternate.
    assert_eq!(seen, [0.25, 0.5, 0.25, 0.5, 0.25]);
}

#[test]
fn cube_maps_are_drawn_in_all_directions() {
    let cube =
        "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 0.1); }";
    let code = "void mainImage(out vec4 c, in vec2 p) {
        vec3 d = normalize(vec3(p - 3.0, 0.5 - p.y));
        vec4 t = texture(iChannel0, d);
        c = vec4(distance(t.xyz, d) < 0.01, t.a, iChannelResolution[0].x == 1024.0, 1);
    }";
    let input = json!({"channel": 0, "type": "cubemap", "id": "4dX3Rr",
        "sampler": {"filter": "linear", "wrap": "clamp"}});
    let passes = [image(code, &[input]), pass("cubemap", "4dX3Rr", cube, &[])];
    let mut player = player(&passes, [8, 4]).unwrap();
    let played = player.frame(&Moment::of_frame(0)).unwrap();
    // 0.1 as a 16-bit float.
    let expected = [1.0, 0.099_975_586, 1.0, 1.0];
    assert!(played.image.pixels.iter().all(|p| *p == expected));
}

#[test]
fn sound_is_computed_in_blocks() {
    let sound = "vec2 mainSound(in int samp, float time) {
        return vec2(float(samp) / 1000000.0, time / 10.0);
    }";
    let passes = [image(COUNT, &[]), pass("sound", "XsfGRr", sound, &[])];
    let player = player(&passes, [2, 2]).unwrap();
    let samples = player.sound(262_100, 100).unwrap().unwrap();
    assert_eq!(samples.len(), 100);
    for (sample, number) in samples.iter().zip(262_100_u32..) {
        let expected = [number as f32 / 1e6, number as f32 / 441_000.0];
        for (found, expected) in sample.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-4,
                "{number} {found} {expected}"
            );
        }
    }
}

#[test]
fn projects_that_cannot_run_are_refused_with_the_reason() {
    let refused = |passes: &[Value], size, reason: &str| {
        let problem = player(passes, size).err().map(|p| p.to_string());
        assert_eq!(problem.as_deref(), Some(reason));
    };
    let wrong = "void mainImage(out vec4 c, in vec2 p) { c = 1; }";
    refused(&[image(wrong, &[])], [2, 2], "Image: the shader has errors");
    let passes = [image(COUNT, &[]), buffer(0, COUNT, &[])];
    let reason = "the render targets have 128000000 texels; the limit is 33554432";
    refused(&passes, [8000, 8000], reason);
}
