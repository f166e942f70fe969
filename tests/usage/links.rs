//! Vertex and fragment shaders that belong together: which are linked, where errors are reported,
//! and what is never guessed.

use crate::scratch::Scratch;

const VERTEX: &str = "\
#version 300 es
in vec2 position;
out vec3 vUv;
void main() {
    vUv = vec3(position, 0.0);
    gl_Position = vec4(position, 0.0, 1.0);
}
";

const FRAGMENT: &str = "\
#version 300 es
precision highp float;
in vec2 vUv;
out vec4 color;
void main() {
    color = vec4(vUv, 0.0, 1.0);
}
";

#[track_caller]
fn check(files: &[(&str, &str)], args: &[&str], expected: &[&str]) {
    let scratch = Scratch::new(files);
    let ran = scratch.run(&[args, &["--info", "--format", "short"]].concat());
    let place = |line: &str| {
        let (place, rest) = line.split_once(": ").unwrap();
        format!("{place} {}", rest.split(['[', ']']).nth(1).unwrap())
    };
    let lines: Vec<&str> = ran.out.lines().collect();
    let found = lines.iter().filter(|l| l.contains("]: "));
    let places: Vec<String> = found.map(|l| place(l)).collect();
    assert_eq!(places, expected, "{}", ran.out);
}

#[test]
fn adjacent_files_are_linked_and_reported_once() {
    for (vert, frag) in [
        ("a.vert", "a.frag"),
        ("a.vs", "a.fs"),
        ("a.vert.glsl", "a.frag.glsl"),
        ("water_vert.glsl", "water_frag.glsl"),
        ("src/vertex.glsl", "src/fragment.glsl"),
    ] {
        let files = [(vert, VERTEX), (frag, FRAGMENT)];
        let expected = format!("{frag}:3:9 link-varying");
        check(&files, &["."], &[&expected]);
        // Naming either of the two checks the other one, too.
        check(&files, &[vert], &[&expected]);
        check(&files, &[frag], &[&expected]);
        check(&files, &[frag, vert], &[&expected]);
    }
}

#[test]
fn unrelated_files_are_not_linked() {
    check(&[("a.vert", VERTEX), ("b.frag", FRAGMENT)], &["."], &[]);
    check(&[("a.vert", VERTEX), ("sub/a.frag", FRAGMENT)], &["."], &[]);
    // The other file's own errors are not reported for this one.
    let broken = FRAGMENT.replace("color =", "color + =");
    check(&[("a.vert", VERTEX), ("a.frag", &broken)], &["a.vert"], &[]);
    // A name that the page may define is not missing.
    let vertex = VERTEX.replace("out vec3 vUv;", "#ifdef UV\nout vec2 vUv;\n#endif");
    let vertex = vertex
        .replace("vUv = ", "gl_PointSize = ")
        .replace("vec3(position, 0.0);", "1.0;");
    check(&[("a.vert", &vertex), ("a.frag", FRAGMENT)], &["."], &[]);
}

const PAGE: &str = "\
<script id=\"vs\" type=\"x-shader/x-vertex\">
attribute vec2 position;
varying vec2 vUv;
void main() { vUv = position; gl_Position = vec4(position, 0.0, 1.0); }
</script>
<script id=\"fs\" type=\"x-shader/x-fragment\">
precision highp float;
varying vec3 vUv;
uniform float uTime;
void main() { gl_FragColor = vec4(vUv * uTime, 1.0); }
</script>
";

#[test]
fn the_two_shaders_of_a_page_are_linked() {
    check(
        &[("p.html", PAGE)],
        &["p.html"],
        &["p.html:8:14 link-varying"],
    );
    // With three shaders it is unknown which belong together, unless a script links them.
    let third = PAGE
        .replace("id=\"fs\"", "id=\"other\"")
        .replace("uTime", "uOther");
    let three = format!("{PAGE}{}", third.split_once("</script>\n").unwrap().1);
    check(&[("p.html", &three)], &["p.html"], &[]);
    let reported = format!("{three}<script>link(gl, get('vs'), get('fs'));</script>");
    check(
        &[("p.html", &reported)],
        &["p.html"],
        &["p.html:8:14 link-varying"],
    );
}

/// Makes the program of a page.
const BUILD: &str = "const p = gl.createProgram();
for (const [type, id] of [[gl.VERTEX_SHADER, 'vs'], [gl.FRAGMENT_SHADER, 'fs']]) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, document.getElementById(id).textContent);
  gl.attachShader(p, shader);
}";

#[test]
fn uniforms_queried_by_a_page_must_exist() {
    let page = PAGE.replace("varying vec3 vUv;", "varying vec2 vUv;");
    let page = page.replace("vec4(vUv * uTime, 1.0)", "vec4(vUv * uTime, 0.0, 1.0)");
    let asks = |name: &str| {
        format!("{page}<script>{BUILD}\nconst u = gl.getUniformLocation(p, {name});</script>\n")
    };
    check(&[("p.html", &asks("'uTime'"))], &["p.html"], &[]);
    let found = ["p.html:18:37 unknown-uniform"];
    check(&[("p.html", &asks("'utime'"))], &["p.html"], &found);
    check(&[("p.html", &asks("name"))], &["p.html"], &[]);
    check(&[("p.html", &asks("'u' + name"))], &["p.html"], &[]);
    check(
        &[("p.html", &asks("'utime'"))],
        &["--ignore", "unknown-uniform", "p.html"],
        &[],
    );
    // Of a program that is not known nothing is reported.
    let other = asks("'utime'").replace("const p = gl.createProgram()", "const p = make(gl)");
    check(&[("p.html", &other)], &["p.html"], &[]);
}

#[test]
fn materials_of_three_js_are_linked_separately() {
    let script = "\
import * as THREE from 'three';
const good = new THREE.ShaderMaterial({
  vertexShader: `
    varying vec2 vUv;
    void main() { vUv = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
  fragmentShader: `
    varying vec2 vUv;
    void main() { gl_FragColor = vec4(vUv, 0.0, 1.0); }`,
});
const bad = new THREE.ShaderMaterial({
  vertexShader: `
    void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
  fragmentShader: `
    varying vec2 vUv;
    void main() { gl_FragColor = vec4(vUv, 0.0, 1.0); }`,
});
";
    check(&[("m.js", script)], &["m.js"], &["m.js:14:18 link-varying"]);
    // An undeclared name does not prevent linking.
    let unknown = script.replacen("vec4(vUv, 0.0, 1.0)", "vec4(vUv, other, 1.0)", 2);
    let all = [
        "m.js:8:44 undeclared-name",
        "m.js:14:18 link-varying",
        "m.js:15:44 undeclared-name",
    ];
    check(&[("m.js", &unknown)], &["m.js"], &all);
    let (one, _) = script.split_once("const bad").unwrap();
    let keys = "uniforms: { uTime: { value: 0 }, uColour: { value: c } },\n  vertexShader";
    let asks = one.replacen("vertexShader", keys, 1);
    let asks = asks.replacen(
        "varying vec2 vUv;\n    void main() { gl_F",
        "varying vec2 vUv; uniform float uTime; uniform float uColor;\n    void main() { gl_F",
        1,
    );
    let asks = asks.replace("vec4(vUv, 0.0, 1.0)", "vec4(vUv, uTime, uColor)");
    check(
        &[("m.js", &asks)],
        &["m.js", "--ignore", "render-target"],
        &["m.js:3:36 unknown-uniform"],
    );
}
