//! Inputs of shaders in the scripts that set them: a position is marked with `|`.

use shaderlint::engine::{Options, scripted};
use shaderlint::ide::*;
use shaderlint::text::apply_edits;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

type Texts = BTreeMap<PathBuf, Arc<str>>;

const VERTEX: &str = "uniform float uTime;
attribute float aSize;
void main() { gl_Position = vec4(position + sin(uTime) * aSize, 1.0); }
";
const FRAGMENT: &str = "uniform float uTime;
uniform vec3 uColor;
uniform vec2 uSize;
void main() { gl_FragColor = vec4(uColor * fract(uTime), uSize.x); }
";
const SCRIPT: &str = "import * as THREE from 'three';
import vertexShader from './sea.vert';
import fragmentShader from './sea.frag';
const size = new THREE.Vector2(window.innerWidth, window.innerHeight);
const material = new THREE.ShaderMaterial({
  vertexShader, fragmentShader,
  uniforms: {
    uTime: { value: 0 },
    uColor: { value: new THREE.Color(1, 0.5, 0) },
    uSize: { value: size },
  },
});
const geometry = new THREE.BufferGeometry();
geometry.setAttribute('aSize', new THREE.BufferAttribute(new Float32Array(3), 1));
const points = new THREE.Points(geometry, material);
const clock = new THREE.Clock();
function render() {
  requestAnimationFrame(render);
  material.uniforms.uTime.value = clock.getElapsedTime();
}
render();
";
const RAW: &str = "const gl = document.querySelector('canvas').getContext('webgl');
const fragment = `precision mediump float;
uniform vec2 size;
uniform float power;
void main() { gl_FragColor = vec4(size, power, 1.0); }`;
const vertex = `attribute vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }`;
const program = gl.createProgram();
for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  gl.attachShader(program, shader);
}
gl.linkProgram(program);
gl.useProgram(program);
const power = gl.getUniformLocation(program, 'power');
gl.uniform1f(power, 2.5);
gl.uniform2f(gl.getUniformLocation(program, 'size'), gl.canvas.width, gl.canvas.height);
gl.drawArrays(gl.TRIANGLES, 0, 3);
";

fn three() -> Texts {
    let all = [
        ("/main.js", SCRIPT),
        ("/sea.vert", VERTEX),
        ("/sea.frag", FRAGMENT),
    ];
    all.map(|(path, text)| (path.into(), text.into())).into()
}

/// The documents of some files, and the offset of a mark that is put before a part of the first one.
fn opened(texts: &Texts, path: &str) -> Document {
    let text = texts[&PathBuf::from(path)].clone();
    Document::new(path, text, Arc::new(Options::default()), texts)
}

fn offset(text: &str, around: &str) -> u32 {
    let at = text.find(&around.replace('|', ""));
    (at.unwrap_or_else(|| panic!("no {around}")) + around.find('|').unwrap()) as u32
}

#[track_caller]
fn check_hover(texts: &Texts, path: &str, around: &str, expected: &[&str]) {
    let document = opened(texts, path);
    let at = offset(&document.text, around);
    let text = hover(&document, at, None, texts).map_or(String::new(), |hover| hover.text);
    for part in expected {
        assert!(text.contains(part), "{around}: {text}");
    }
}

#[track_caller]
fn check_definition(texts: &Texts, path: &str, around: &str, expected: &[(&str, &str)]) {
    let document = opened(texts, path);
    let at = offset(&document.text, around);
    let bound = bound_at(&document, at, texts);
    let found = bound.declared().into_iter();
    let places = expected.iter().map(|(path, around)| {
        let start = offset(&texts[&PathBuf::from(path)], around);
        (path.to_string(), start)
    });
    let found: Vec<_> = found.map(|p| (p.path.clone(), p.span.start)).collect();
    assert_eq!(found, places.collect::<Vec<_>>(), "{around}");
}

#[test]
fn names_in_scripts_lead_to_declarations() {
    let texts = three();
    let both = [("/sea.frag", "float |uTime"), ("/sea.vert", "float |uTime")];
    check_definition(&texts, "/main.js", "uT|ime: {", &both);
    check_definition(&texts, "/main.js", "uniforms.|uTime.value", &both);
    check_definition(
        &texts,
        "/main.js",
        "'aS|ize'",
        &[("/sea.vert", "float |aSize")],
    );
    check_definition(&texts, "/main.js", "const si|ze", &[]);
    let raw = [("/raw.js", RAW)]
        .map(|(path, text)| (path.into(), text.into()))
        .into();
    check_definition(&raw, "/raw.js", "'pow|er'", &[("/raw.js", "float |power")]);
}

#[test]
fn strings_of_modules_belong_to_programs_that_were_checked() {
    let module = format!("export const fragmentShader = `{FRAGMENT}`;\n");
    let script = SCRIPT
        .replace("import vertexShader from './sea.vert';\n", "")
        .replace(
            "fragmentShader from './sea.frag'",
            "{ fragmentShader } from './sea.js'",
        )
        .replace("vertexShader, ", "");
    let texts = [("/main.js", script), ("/sea.js", module)];
    let texts: Texts = texts.map(|(path, text)| (path.into(), text.into())).into();
    let main = opened(&texts, "/main.js");
    let module = texts[&PathBuf::from("/sea.js")].clone();
    let module = Document::new("/sea.js", module, main.options.clone(), &texts);
    let at = offset(&module.text, "vec3 u|Color");
    let found = hover(&module, at, None, &texts).unwrap().text;
    assert!(
        found.contains("set to `(1, 0.5, 0)` in `main.js:8`"),
        "{found}"
    );
}

#[test]
fn instances_of_a_class_set_its_uniforms() {
    let script = "import { shaderMaterial } from '@react-three/drei';
import { extend } from '@react-three/fiber';
const WaveMaterial = shaderMaterial({ uTime: 0.5 },
  'void main() { gl_Position = vec4(position, 1.0); }',
  'uniform float uTime; void main() { gl_FragColor = vec4(uTime); }');
extend({ WaveMaterial });
export const Wave = () => <mesh><waveMaterial uTime={2} /></mesh>;
";
    let texts: Texts = [("/wave.jsx".into(), script.into())].into();
    let declared = [("/wave.jsx", "float |uTime")];
    check_definition(&texts, "/wave.jsx", "<waveMaterial uTi|me", &declared);
    let set = ["set to `0.5` in `wave.jsx:3`", "changed in `wave.jsx:7`"];
    check_hover(&texts, "/wave.jsx", "float u|Time", &set);
}

#[test]
fn hovers_show_both_sides() {
    let texts = three();
    let set = [
        "set to `0` in `main.js:8`",
        "set to `the time` in `main.js:19`",
    ];
    check_hover(&texts, "/sea.frag", "fract(u|Time", &set);
    check_hover(&texts, "/sea.vert", "float u|Time", &set);
    check_hover(
        &texts,
        "/main.js",
        "uniforms.u|Time",
        &[
            "uniform float uTime",
            "declared in `sea.frag:1`",
            "declared in `sea.vert:1`",
            set[0],
        ],
    );
    check_hover(
        &texts,
        "/sea.frag",
        "vec3 u|Color",
        &["set to `(1, 0.5, 0)` in `main.js:9`"],
    );
    check_hover(
        &texts,
        "/sea.frag",
        "vec2 u|Size",
        &["set to `the size of the frame` in `main.js:10`"],
    );
    let raw = [("/raw.js", RAW)]
        .map(|(path, text)| (path.into(), text.into()))
        .into();
    check_hover(
        &raw,
        "/raw.js",
        "float p|ower",
        &["set to `2.5` in `raw.js:18`"],
    );
    check_hover(&raw, "/raw.js", "vec2 s|ize", &["the size of the frame"]);
}

#[track_caller]
fn check_renamed(texts: &Texts, path: &str, around: &str, new: &str, expected: &[&str]) {
    let documents: Vec<Document> = texts
        .keys()
        .map(|p| opened(texts, p.to_str().unwrap()))
        .collect();
    let all: Vec<&Document> = documents.iter().collect();
    let document = all.iter().find(|d| d.path == path).unwrap();
    let at = offset(&document.text, around);
    let got = match rename(&all, document, at, new, texts) {
        Ok(renaming) => {
            let changed = renaming
                .edits
                .iter()
                .map(|(path, edits)| apply_edits(&texts[&PathBuf::from(path)], 0, edits).unwrap());
            changed.collect::<String>()
        }
        Err(refusal) => refusal.to_string(),
    };
    for part in expected {
        assert!(got.contains(part), "{around}: {got}");
    }
}

#[test]
fn a_renamed_uniform_is_renamed_in_all_stages_and_scripts() {
    let mut texts = three();
    let all = [
        "clock: {",
        "material.uniforms.clock.value",
        "uniform float clock;\nattribute",
        "uniform float clock;\nuniform vec3",
        "sin(clock)",
        "fract(clock)",
    ];
    check_renamed(&texts, "/sea.frag", "fract(u|Time", "clock", &all);
    check_renamed(&texts, "/sea.vert", "float u|Time", "clock", &all);
    let script = SCRIPT.replace(
        "render();\n",
        "render();\nmaterial.uniforms[window.key] = { value: 1 };\n",
    );
    texts.insert("/main.js".into(), script.into());
    check_renamed(
        &texts,
        "/sea.frag",
        "fract(u|Time",
        "clock",
        &["of `main.js` may refer to `uTime`"],
    );
}

#[track_caller]
fn check_completed(old: &str, new: &str, expected: &[&str]) {
    let (files, path) = match SCRIPT.contains(old) {
        true => (three(), "/main.js"),
        false => ([("/raw.js".into(), RAW.into())].into(), "/raw.js"),
    };
    let mut texts: Texts = files;
    let text = &texts[&PathBuf::from(path)];
    let at = new.find('|').unwrap() as u32 + text.find(old).unwrap() as u32;
    let text = text.replacen(old, &new.replace('|', ""), 1);
    texts.insert(path.into(), text.into());
    let (word, mut found) = complete(&opened(&texts, path), at, &texts);
    found.sort_by_key(|p| (p.rank, p.label.clone()));
    let shown = found.iter().map(|p| format!("{} {}", p.detail, p.label));
    assert_eq!(shown.collect::<Vec<_>>(), expected, "{new}");
    assert!(word.len() < 3 && word.end == at, "{word:?}");
}

#[test]
fn names_of_inputs_are_completed_in_scripts() {
    check_completed(
        "uColor: { value: new THREE.Color(1, 0.5, 0) },",
        "u|",
        &["vec3 uColor", "vec2 uSize", "float uTime"],
    );
    check_completed(
        "    uColor: { value: new THREE.Color(1, 0.5, 0) },\n",
        "    |",
        &["vec3 uColor", "vec2 uSize", "float uTime"],
    );
    check_completed(
        "uTime.value = clock.getElapsedTime()",
        "|",
        &["vec3 uColor", "vec2 uSize", "float uTime"],
    );
    check_completed(
        "program, 'power'",
        "program, '|'",
        &["float power", "vec2 size"],
    );
    check_completed("const clock", "const |clock", &[]);
}

#[test]
fn members_of_blocks_show_their_place() {
    let text = "#version 300 es
precision highp float;
layout(std140) uniform Lamp { vec3 at; float power; vec2 steps[3]; } lamp;
uniform Fog { float near; mat3 turn; };
out vec4 color;
void main() { color = vec4(lamp.at * lamp.power + near * turn[0], lamp.steps[1].x); }
";
    let texts: Texts = [("/a.frag".into(), text.into())].into();
    check_hover(
        &texts,
        "/a.frag",
        "lamp.po|wer",
        &["offset 12, size 4 (`std140`, in bytes of `Lamp`)"],
    );
    check_hover(&texts, "/a.frag", "ste|ps[3]", &["offset 16, size 40"]);
    check_hover(&texts, "/a.frag", "+ ne|ar", &["offset 0, size 4"]);
    check_hover(&texts, "/a.frag", "tu|rn[0]", &["offset 16, size 48"]);
}

/// The values that scripts give the uniforms of a file; constants with a star.
#[track_caller]
fn check_values(texts: &Texts, path: &str, expected: &[&str]) {
    let text = &texts[&PathBuf::from(path)];
    let found = scripted(path, text, &Options::default(), texts);
    let shown = found.iter().map(|value| {
        let star = if value.is_constant { "*" } else { "" };
        format!("{star}{} {} {}", value.name, value.value, value.place)
    });
    assert_eq!(shown.collect::<Vec<_>>(), expected, "{path}");
}

#[test]
fn scripts_give_uniforms_their_values() {
    let mut texts = three();
    let values = [
        "uTime the time main.js:19",
        "*uColor (1, 0.5, 0) main.js:9",
        "*uSize the size of the frame main.js:10",
    ];
    check_values(&texts, "/sea.frag", &values);
    check_values(&texts, "/sea.vert", &values[..1]);
    // What a panel gets may change; a colour that is one number is linear.
    let script = SCRIPT.replace("1, 0.5, 0", "0xff0080").replace(
        "const clock",
        "gui.add(material.uniforms.uColor, 'value').name('uColor');\nconst clock",
    );
    texts.insert("/main.js".into(), script.into());
    let values = [
        "uTime the time main.js:20",
        "uColor (1, 0, 0.2158605) main.js:9",
        "*uSize the size of the frame main.js:10",
    ];
    check_values(&texts, "/sea.frag", &values);
    let raw = [("/raw.js", RAW)]
        .map(|(path, text)| (path.into(), text.into()))
        .into();
    let values = [
        "*size the size of the frame raw.js:19",
        "*power 2.5 raw.js:18",
    ];
    check_values(&raw, "/raw.js", &values);
}
