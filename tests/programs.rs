//! Shaders that live in a program: scripts insert texts into them, hand them to a library, import them from
//! files.

use crate::scratch::Scratch;
use std::fs;
use std::path::Path;

/// Checks all findings in some files, each as `file:line:column: severity[rule]: message`.
#[track_caller]
fn check(files: &[(&str, &str)], expected: &[&str]) {
    let scratch = Scratch::new(files);
    let ran = scratch.run(&["-q", "--no-run", "--format", "short", "."]);
    let lines = ran.out.lines();
    let lines: Vec<&str> = lines
        .map(|l| l.split_once("; ").map_or(l, |(l, _)| l))
        .collect();
    assert_eq!(lines, expected, "{files:?}");
}

const NOISE: &str = "export const noise = /* glsl */ `\nfloat noise(vec2 p) { return p.x; }\n`;\n\
    export { fbm as fractal } from './fbm.js';\nexport default `#define TAU 6.28\\n`;\n";
const FBM: &str = "import { noise } from './noise';\n\
    export const fbm = `${noise}\nfloat fbm(vec2 p) { return noise(p) + 0.5; }\n`;\n";
const LIGHT: &str = "vec3 light(vec3 n) { return vec3(n.x); }\n";

/// A script that puts a shader together in each way, with a body for its `main`.
fn script(body: &str) -> String {
    format!(
        "import tau, {{ fractal }} from './noise';\nimport light from './light.glsl?raw';\n\
         const STEPS = 8;\nconst parts = {{ head: `precision highp float;` }};\n\
         const all = [parts.head, 'uniform float time;', fractal, tau, light, main()].join('\\n');\n\
         function main() {{\n  return `void main() {{\n{body}\n}}`;\n}}\ngl.shaderSource(shader, all);\n"
    )
}

#[test]
fn texts_from_constants_functions_and_modules_are_one_shader() {
    let uses = "float x = fbm(vec2(time)) * TAU;\nfor (int i = 0; i < ${STEPS}; i++) x += 1.0;\n\
        gl_FragColor = vec4(light(vec3(x)), 1.0);";
    let modules = [("noise.ts", NOISE), ("fbm.ts", FBM), ("light.glsl", LIGHT)];
    let run = |body: &str, expected: &[&str]| {
        let main = script(body);
        check(
            &[&[("a.ts", main.as_str())], &modules[..]].concat(),
            expected,
        );
    };
    run(uses, &[]);
    run(
        &uses.replace("vec4(light(vec3(x)), 1.0)", "light(vec3(x))"),
        &["a.ts:10:1: error[vector-size]: cannot assign `vec3` to `vec4`"],
    );
    run(
        &uses.replace("fbm(", "fbn("),
        &["a.ts:8:11: error[undeclared-name]: function `fbn` is not declared"],
    );
    run(
        &uses.replace("light(vec3(x))", "light(x)"),
        &[
            "a.ts:10:27: error[vector-size]: expected `vec3` as argument 1 of `light`, found `float`",
        ],
    );
}

#[test]
fn mistakes_in_inserted_texts_are_reported_once_where_they_are() {
    let chunk = "const chunk = `float f(vec2 p) { return p; }`;\n";
    let main = "`${chunk}\nvoid main() { gl_FragColor = vec4(f(vec2(1.0))); }`";
    let script = format!("{chunk}const a = {main};\nconst b = {main};\n");
    let error =
        "a.js:1:34: error[vector-size]: expected return value of type `float`, found `vec2`";
    check(&[("a.js", &script)], &[error]);
}

/// A fragment shader for three.js that hands its text to this class.
fn three(class: &str, declared: &str, body: &str) -> String {
    format!(
        "import * as THREE from 'three';\nnew THREE.{class}({{ fragmentShader: `\n{declared}\n\
         void main() {{\n{body}\n}}` }});\n"
    )
}

#[test]
fn chunks_of_a_host_complete_a_shader() {
    let run = |declared: &str, body: &str, expected: &[&str]| {
        check(
            &[("a.js", &three("ShaderMaterial", declared, body))],
            expected,
        );
    };
    let common = "#include <common>";
    let end = "#include <colorspace_fragment>";
    run(
        common,
        &format!("gl_FragColor = vec4(pow2(PI));\n{end}"),
        &[],
    );
    run(
        common,
        &format!("gl_FragColor = vec3(PI);\n{end}"),
        &["a.js:5:1: error[vector-size]: cannot assign `vec3` to `vec4`"],
    );
    run(
        common,
        &format!("gl_FragColor = vec4(uFade);\n{end}"),
        &["a.js:5:21: error[undeclared-name]: `uFade` is not declared"],
    );
    run(
        common,
        "gl_FragColor = vec4(1.0);\n#include <colorspce_fragment>",
        &["a.js:6:11: error[bad-directive]: three.js has no chunk `colorspce_fragment`"],
    );
    // A variable that a chunk declares, sets or reads.
    let map = "vec4 diffuseColor = vec4(1.0);\n#include <map_fragment>\n#include <opaque_fragment>";
    run(
        "#define USE_MAP",
        &format!("vec3 outgoingLight = vec3(1.0);\n{map}"),
        &[],
    );
    // Names of a group that the material may activate, and of other releases.
    run(
        "#include <uv_pars_fragment>",
        "gl_FragColor = vec4(vMapUv, 1.0, 1.0);",
        &[],
    );
    run(
        common,
        "gl_FragColor = vec4(linearToRelativeLuminance(vec3(1.0)));",
        &[],
    );
    run("", "gl_FragColor = LinearTosRGB(vec4(1.0));", &[]);
}

/// A page or script that loads three.js from this address, and includes these chunks.
fn includes(address: &str, chunks: &[&str]) -> String {
    let chunks: Vec<String> = chunks.iter().map(|c| format!("#include <{c}>")).collect();
    let body = format!("gl_FragColor = vec4(1.0);\n{}", chunks.join("\n"));
    three("ShaderMaterial", "", &body).replace("'three'", &format!("'{address}'"))
}

#[test]
fn chunks_are_those_of_the_installed_release() {
    let old = includes("three", &["encodings_fragment"]);
    let new = includes("three", &["fog_fragment", "colorspace_fragment"]);
    let gone = includes("three", &["lightmap_fragment"]);
    let files = [("a.js", old.as_str()), ("b.js", &new), ("c.js", &gone)];
    let missing = |release: u32| {
        format!(
            "a.js:6:11: error[bad-directive]: `encodings_fragment` does not exist in three.js r{release}"
        )
    };
    let lightmap =
        "c.js:6:11: error[bad-directive]: `lightmap_fragment` does not exist in three.js r170";
    let early = "b.js:7:11: error[bad-directive]: `colorspace_fragment` exists from r154 on";
    let accepted = "a.js:6:11: warning[bad-directive]: `encodings_fragment` is an old name, which \
        three.js accepts until r163";
    let run = |more: &[(&str, &str)], expected: &[&str]| check(&[&files, more].concat(), expected);
    let of = |list: &str, range: &str| format!("{{\"{list}\": {{\"three\": \"{range}\"}}}}");
    for (range, expected) in [
        ("^0.170.0", &[missing(170).as_str(), lightmap][..]),
        ("0.160.x", &[accepted]),
        ("~0.152.2", &[early]),
        ("0.80.1", &[early]),
        (">=0.125", &[]),
        ("^0.150.0 || ^0.170.0", &[]),
        ("0.150.0 - 0.170.0", &[]),
        ("*", &[]),
        ("latest", &[]),
    ] {
        for list in ["dependencies", "devDependencies", "peerDependencies"] {
            run(&[("package.json", &of(list, range))], expected);
        }
    }
    // What is installed decides, and three.js itself has its own release.
    let range = of("dependencies", "^0.152.0");
    let installed = r#"{"name": "three", "version": "0.170.0"}"#;
    let modules = ("node_modules/three/package.json", installed);
    let all = [missing(170), lightmap.to_string()];
    let all = all.each_ref().map(String::as_str);
    run(&[("package.json", &range), modules], &all);
    run(&[("package.json", installed)], &all);
}

#[test]
fn chunks_are_those_of_the_release_that_a_page_loads() {
    let run = |address: &str, more: &str, is_early: bool| {
        let script = includes(address, &["colorspace_fragment"]) + more;
        let early = "a.js:6:11: error[bad-directive]: `colorspace_fragment` exists from r154 on";
        let expected: &[&str] = if is_early { &[early] } else { &[] };
        check(&[("a.js", &script)], expected);
    };
    for address in [
        "https://unpkg.com/three@0.150.1/build/three.module.js",
        "https://cdn.example.com/npm/three@0.150.1/+esm",
        "https://cdn.example.com/ajax/libs/three.js/r128/three.min.js",
        "https://cdn.example.com/ajax/libs/three.js/0.128.0/three.module.js",
    ] {
        run(address, "", true);
    }
    run("https://unpkg.com/three@0.160.0/three.js", "", false);
    run(
        "https://unpkg.com/my-three@0.150.0/three.js",
        "import 'three';",
        false,
    );
    // The script does not use the package of the project.
    let of_project = ("package.json", r#"{"dependencies": {"three": "0.150.0"}}"#);
    let unknown = |script: &str| check(&[("a.js", script), of_project], &[]);
    for own in [
        "./libs/three.module.js",
        "https://unpkg.com/three@0.160.0/three.js",
    ] {
        unknown(&includes(own, &["colorspace_fragment"]));
    }
    let global = includes("three", &["colorspace_fragment"]);
    unknown(&global.replace("import * as THREE from 'three';", "// three"));
    // Two releases are none.
    let other = "// https://unpkg.com/three@0.170.0/src/a.js\n";
    run("https://unpkg.com/three@0.150.1/three.js", other, false);
    let map = "<script type=\"importmap\">{\"imports\": {\"three\": \
        \"https://unpkg.com/three@0.170.0/build/three.module.js\"}}</script>\n";
    let script = includes("three", &["uv2_vertex"]);
    let page = format!("{map}<script type=\"module\">\n{script}</script>\n");
    check(
        &[("a.html", &page)],
        &["a.html:8:11: error[bad-directive]: `uv2_vertex` does not exist in three.js r170"],
    );
}

#[test]
fn a_program_that_adds_or_chooses_chunks_has_them() {
    let package = ("package.json", r#"{"dependencies": {"three": "0.170.0"}}"#);
    let shader = includes("three", &["uv2_vertex", "encodings_fragment"]);
    let add = |code: &str| {
        let added = format!("import {{ ShaderChunk }} from 'three';\n{code}\n");
        let scratch = Scratch::new(&[("a.js", &shader), ("b.ts", &added), package]);
        let ran = scratch.run(&["-q", "--no-run", "--format", "short", "."]);
        let severity = |l: &str| {
            l.split(' ')
                .nth(1)
                .and_then(|s| s.split('[').next())
                .map(str::to_string)
        };
        ran.out.lines().filter_map(severity).collect::<Vec<_>>()
    };
    assert_eq!(add(""), ["error", "error"]);
    assert_eq!(
        add("if (ShaderChunk.uv2_vertex === x) y();"),
        ["error", "error"]
    );
    assert_eq!(add("ShaderChunk.uv2_vertex = '';"), ["error"]);
    assert_eq!(
        add("ShaderChunk['uv2_vertex'] = ``;\nTHREE.ShaderChunk.encodings_fragment = x;"),
        [] as [&str; 0]
    );
    for code in [
        "Object.assign(THREE.ShaderChunk, all);\nx = 1;",
        "ShaderChunk[name] = text;",
    ] {
        assert_eq!(add(code), ["warning", "warning"], "{code}");
    }
    // A script chooses by the release.
    for choice in [
        "const name = parseInt(REVISION) < 154 ? 'encodings_fragment' : 'colorspace_fragment';\n",
        "const name = 'colorspace_fragment';\n",
    ] {
        let script = choice.to_string() + &includes("three", &["encodings_fragment"]);
        check(&[("a.js", &script), package], &[]);
        let script = script.replace("<encodings_fragment>", "<${name}>");
        check(&[("a.js", &script), package], &[]);
    }
}

#[test]
fn a_chunk_of_another_release_gets_the_name_of_this_one() {
    let script = includes("three", &["output_fragment", "fog_fragment"]);
    let package = |version: &str| format!("{{\"dependencies\": {{\"three\": \"{version}\"}}}}");
    let scratch = Scratch::new(&[("a.js", &script), ("package.json", &package("0.175.0"))]);
    let fix = |release: &str| {
        scratch.write("package.json", package(release));
        scratch.run(&["--no-run", "--fix", "a.js"]);
        scratch.read("a.js")
    };
    let new = script.replace("output_fragment", "opaque_fragment");
    assert_eq!(fix("0.175.0"), new);
    assert_eq!(fix("0.140.0"), script);
    // Neither of the two existed.
    assert_eq!(fix("0.120.0"), script);
    scratch.write("package.json", package(">=0.125"));
    let ran = scratch.run(&["--no-run", "--info", "--format", "short", "a.js"]);
    let info = "info[bad-directive]: `output_fragment` does not exist in three.js after r163; it became \
        `opaque_fragment` in r154";
    assert!(ran.out.contains(info), "{}", ran.out);
    scratch.write("package.json", package("^0.150.2"));
    let ran = scratch.run(&["--no-run", "-v", "a.js"]);
    assert!(
        ran.err.contains("for three.js, chunks of r150;"),
        "{}",
        ran.err
    );
}

/// Each chunk is syntactically complete, so that nothing around it is left unchecked.
#[test]
fn each_chunk_leaves_the_text_around_it_checked() {
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/host/chunks/three.glsl");
    let table = fs::read_to_string(table).unwrap();
    let chunks: Vec<(&str, &str)> = table
        .split("//# ")
        .skip(1)
        .filter_map(|part| part.split_once('\n'))
        .collect();
    assert!(chunks.len() > 100);
    let is_effect = |line: &str| line.starts_with("sets ") || line.starts_with("reads ");
    let texts: Vec<(String, String)> = chunks
        .iter()
        .map(|(name, lines)| {
            let include = format!("#include <{name}>");
            let (outside, inside) = match lines.lines().any(is_effect) {
                true => ("", include.as_str()),
                false => (include.as_str(), ""),
            };
            let body = format!("gl_FragColor = vec3(0.0);\n{inside}");
            (
                format!("{name}.js"),
                three("ShaderMaterial", outside, &body),
            )
        })
        .collect();
    let files: Vec<(&str, &str)> = texts
        .iter()
        .map(|(n, t)| (n.as_str(), t.as_str()))
        .collect();
    let scratch = Scratch::new(&files);
    let out = scratch
        .run(&["-q", "--no-run", "--format", "short", "."])
        .out;
    for (name, _) in &files {
        let error = format!("{name}:5:1: error[vector-size]");
        assert!(out.contains(&error), "{name}: {out}");
    }
}

#[test]
fn a_shader_file_is_read_as_the_scripts_that_import_it_use_it() {
    let lacks = "varying vec2 vUv;\nvoid main() { gl_FragColor = vec4(vUv, iTime, 1.0); }\n";
    let error = "a.frag:2:40: error[undeclared-name]: `iTime` is not declared";
    let warning = "a.frag:2:40: warning[undeclared-name]: `iTime` is not declared";
    let top = ("package.json", "{}");
    let run = |script: &str, expected: &[&str]| {
        check(&[("a.frag", lacks), ("b.js", script), top], expected);
    };
    let import = "import { ShaderMaterial } from 'three';\nimport frag from './a.frag?raw';\n";
    // Without a program, the text is a shader of an editor that declares the name.
    check(&[("a.frag", lacks), top], &[]);
    let hands_over = format!("{import}new ShaderMaterial({{ fragmentShader: frag }});\n");
    run(&hands_over, &[error]);
    let extends = format!(
        "{import}class M extends ShaderMaterial {{ constructor() {{ super({{ fragmentShader: frag }}); }} }}\n"
    );
    run(&extends, &[error]);
    // A function of the program may add to the text.
    run(
        &format!("{import}new ShaderMaterial({{ fragmentShader: f(frag) }});\n"),
        &[warning],
    );
}

/// Checks `own.frag`, whose `main` calls a function, as a script uses it beside `lib.frag` and `rest.frag`.
#[track_caller]
fn check_joined(script: &str, call: &str, expected: &[&str]) {
    let head = "precision highp float;\n";
    let own = format!("{head}void main() {{ gl_FragColor = vec4({call}); }}\n");
    let lib = format!("{head}uniform float scale;\nfloat wave(float x) {{ return x * scale; }}\n");
    let vertex = "attribute vec4 at;\nvoid main() { gl_Position = at; }\n";
    check(
        &[
            ("own.frag", &own),
            ("lib.frag", &lib),
            ("rest.frag", "float ripple(float x) { return x; }\n"),
            ("quad.vert", vertex),
            ("a.js", script),
            ("package.json", "{}"),
        ],
        expected,
    );
}

#[test]
fn files_that_a_script_joins_are_one_shader() {
    let undeclared = |severity: &str, name: &str| {
        format!("own.frag:2:35: {severity}[undeclared-name]: function `{name}` is not declared")
    };
    let lists = [
        "program('quad.vert', ['lib.frag', 'own.frag']);",
        "['lib.frag', 'own.frag'].map(load);",
        "program({ fragment: [load('lib.frag'), load('own.frag')] });",
        "compile(gl.FRAGMENT_SHADER, (await load('lib.frag')) + (await load('own.frag')));",
        "import lib from './lib.frag'; import own from './own.frag';\nprogram([lib, own].join('\\n'));",
        "const lib = get('./lib.frag?raw'), own = get('./own.frag?raw');\nprogram(`${lib}${own}`);",
    ];
    for list in lists {
        // The functions of the others are known, with their types.
        check_joined(list, "wave(1.0)", &[]);
        check_joined(
            list,
            "wave(true)",
            &[
                "own.frag:2:40: error[argument-mismatch]: expected `float` as argument 1 of `wave`, found `bool`",
            ],
        );
        // The file that declares it is loaded elsewhere, but not joined.
        let elsewhere = format!("{list}\nload('rest.frag');\n");
        let error = undeclared("error", "ripple");
        check_joined(&elsewhere, "ripple(1.0)", &[&error]);
    }
    // What else is joined is not known.
    let open = "program([prefix, load('lib.frag'), load('own.frag')]);\nload('rest.frag');\n";
    check_joined(open, "wave(1.0)", &[]);
    check_joined(open, "ripple(1.0)", &[&undeclared("warning", "ripple")]);
    // Stages are not one shader, and the order counts.
    let stages = "link(['quad.vert', 'lib.frag', 'own.frag']);";
    check_joined(stages, "wave(1.0)", &[&undeclared("warning", "wave")]);
}

/// Checks a script that compiles what an expression joins from `lib` and `own`, whose `main` calls a function.
#[track_caller]
fn check_strings(joined: &str, call: &str, expected: &[&str]) {
    let head = "precision highp float;";
    let text = format!(
        "const lib = `{head}\nfloat wave(float x) {{ return x; }}\n`;\n\
        const own = `{head}\nvoid main() {{ gl_FragColor = vec4({call}); }}\n`;\n\
        const gl = c.getContext('webgl'), s = gl.createShader(gl.FRAGMENT_SHADER);\n\
        const compile = (text) => {{ gl.shaderSource(s, text); gl.compileShader(s); }};\n\
        compile({joined});\n"
    );
    check(&[("a.js", &text), ("package.json", "{}")], expected);
}

#[test]
fn strings_that_a_script_joins_are_one_shader() {
    for joined in [
        "lib + own",
        "[lib, own]",
        "[lib, own].join('\\n')",
        "`${lib}${own}`",
    ] {
        check_strings(joined, "wave(1.0)", &[]);
        let error = "a.js:5:40: error[argument-mismatch]: expected `float` as argument 1 of `wave`, found `bool`";
        check_strings(joined, "wave(true)", &[error]);
        let error = "a.js:5:35: error[undeclared-name]: function `ripple` is not declared";
        check_strings(joined, "ripple(1.0)", &[error]);
    }
    // The function that compiles it may put the other text before.
    check_strings("own", "wave(1.0)", &[]);
    // Two entry functions are two shaders, and a text may insert another itself.
    check_strings("[own, lib, own]", "sin(1.0)", &[]);
}

#[test]
fn a_text_before_each_shader_declares_names_for_it() {
    let run = |compiled: &str, name: &str, expected: &[&str]| {
        let text = format!(
            "const gl = c.getContext('webgl'), head = `uniform float time;\n#define PI 3.14\n`;\n\
            const own = `precision highp float;\nvoid main() {{ gl_FragColor = vec4({name} * PI); }}`;\n\
            const compile = (shader, text) => {{ {compiled}; gl.compileShader(shader); }};\n\
            compile(gl.createShader(gl.FRAGMENT_SHADER), own);\n"
        );
        check(&[("a.js", &text), ("package.json", "{}")], expected);
    };
    let joined = [
        "gl.shaderSource(shader, head + text)",
        "gl.shaderSource(shader, `${head}${text}`)",
        "const all = head + text; gl.shaderSource(shader, all)",
        "text = head + text; gl.shaderSource(shader, text)",
    ];
    let error = "a.js:5:35: error[undeclared-name]: `phase` is not declared";
    for compiled in joined {
        run(compiled, "time", &[]);
        run(compiled, "phase", &[error]);
    }
    let pi = "a.js:5:43: error[undeclared-name]: `PI` is not a GLSL constant";
    run("gl.shaderSource(shader, text)", "phase", &[error, pi]);
}

#[test]
fn functions_that_a_host_calls_are_checked_with_its_names() {
    let effect = "uniform float strength;\n\
        void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) {\n\
        outputColor = inputColor * strength * aspect;\n}\n";
    let package = (
        "package.json",
        "{ \"dependencies\": { \"postprocessing\": \"6\", \"three\": \"0.187\" } }",
    );
    let script = "import { Effect } from 'postprocessing';\nimport frag from './a.frag';\n\
        export class E extends Effect { constructor() { super('E', frag); } }\n";
    check(&[("a.frag", effect), ("b.js", script), package], &[]);
    let lacks = effect.replace("uniform float strength;", "");
    let error = "a.frag:3:28: error[undeclared-name]: `strength` is not declared";
    check(&[("a.frag", &lacks), ("b.js", script), package], &[error]);
}

#[test]
fn a_macro_that_the_script_defines_is_not_missing() {
    let shader = "#version 300 es\nprecision highp float;\nout vec4 color;\n\
        void main() {\ncolor = vec4(0.0);\nfor (int i = 0; i < STEPS; i++) color += vec4(0.1);\n}\n";
    let script = |defines: &str| {
        format!("import frag from './a.frag';\nnew Material({{ frag, {defines} }});\n")
    };
    let defines = script("defines: { STEPS: steps.toString() }");
    check(
        &[
            ("a.frag", shader),
            ("b.js", &defines),
            ("package.json", "{}"),
        ],
        &[],
    );
    let error = "a.frag:6:21: error[undeclared-name]: `STEPS` is not declared";
    let other = script("steps: 3");
    check(
        &[("a.frag", shader), ("b.js", &other), ("package.json", "{}")],
        &[error],
    );
}

/// Scripts that no recursive parser has room for, and long ones, are answered, and their shaders are found.
#[test]
fn deep_and_long_scripts_are_answered() {
    let shader = "const s = `void main() { gl_FragColor = vec3(1.0); }`;\n";
    let nested =
        |open: &str, close: &str| format!("x = {}1{}", open.repeat(20_000), close.repeat(20_000));
    let rests = [
        nested("(", ")"),
        nested("`${", "}`"),
        nested("<a b={", "}/>"),
        nested("a => ", ""),
        nested("'a' + ", ""),
        nested("a ? b : ", ""),
        "if (a); else ".repeat(20_000) + ";",
        "while (a) ".repeat(20_000) + ";",
        format!("namespace {}A {{}}", "A.".repeat(20_000)),
        format!("type T = {}A", "keyof ".repeat(20_000)),
        format!("x = `{}", "${`".repeat(20_000)),
        "const a = `${b}x`; const b = `${a}y`;".to_string(),
    ];
    let names: Vec<String> = (0..rests.len())
        .map(|index| format!("{index}.tsx"))
        .collect();
    let texts: Vec<String> = rests
        .iter()
        .map(|rest| format!("{shader}{rest}\n"))
        .collect();
    let files = names.iter().zip(&texts);
    let files: Vec<(&str, &str)> = files.map(|(n, t)| (n.as_str(), t.as_str())).collect();
    let scratch = Scratch::new(&files);
    let mut arguments = vec!["-q", "--no-run", "--format", "short"];
    arguments.extend(names.iter().map(String::as_str));
    let out = scratch.run(&arguments).out;
    for name in &names {
        let found = format!("{name}:1:26: error[vector-size]");
        assert!(out.contains(&found), "{name}: {out}");
    }
}

#[test]
fn placeholders_in_complete_shaders_are_left_open() {
    let shader = |size: &str, line: &str| {
        format!(
            "#version 300 es\nprecision highp float;\nuniform float a[{size}];\n{line}\nout vec4 color;\n\
            void main() {{ color = vec4(a[0]); }}\n"
        )
    };
    check(&[("a.frag", &shader("%%count%%", "##DEFINES##"))], &[]);
    check(&[("a.frag", &shader("$(count)", ""))], &[]);
}

/// A page that compiles a shader in a context, with the findings.
#[track_caller]
fn check_context(script: &str, shader: &str, expected: &[&str]) {
    let page = format!(
        "<script>\n{script}\nconst code = `{shader}`;\ngl.shaderSource(gl.createShader(gl.FRAGMENT_SHADER), code);\n</script>\n"
    );
    check(&[("a.html", &page), ("package.json", "{}")], expected);
}

#[test]
fn the_context_of_a_page_decides_on_extensions() {
    let one = "const gl = canvas.getContext('webgl');";
    let enabled = &format!("{one} gl.getExtension('OES_standard_derivatives');");
    let directive = "#extension GL_OES_standard_derivatives : enable\n";
    let rest = "precision highp float;\nvarying vec2 uv;\nvoid main() { gl_FragColor = vec4(fwidth(uv), 0, 1); }\n";
    let shader = &format!("{directive}{rest}");
    check_context(enabled, shader, &[]);
    check_context(
        one,
        shader,
        &[
            "a.html:6:35: error[missing-extension]: `fwidth` needs the extension `OES_standard_derivatives`",
        ],
    );
    check_context(
        enabled,
        rest,
        &[
            "a.html:5:35: error[missing-extension]: `fwidth` needs `#extension GL_OES_standard_derivatives : enable`",
        ],
    );
    check_context(
        &enabled.replace("webgl", "webgl2"),
        shader,
        &["a.html:6:35: error[needs-webgl2]: `fwidth` requires GLSL ES 3.00"],
    );
    // Another script may enable it.
    let open = &format!("import {{ prepare }} from './prepare.js'; {one} prepare(gl);");
    check_context(
        open,
        shader,
        &[
            "a.html:6:35: warning[extension-not-enabled]: `fwidth` requires `OES_standard_derivatives` to be enabled",
        ],
    );
    let new = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
    check_context(
        one,
        new,
        &[
            "a.html:3:15: error[unsupported-version]: a WebGL1 context does not compile GLSL ES 3.00",
        ],
    );
}

#[test]
fn extensions_of_webgl1_are_not_required_in_glsl_es_300() {
    let shader = "#version 300 es\n#extension GL_OES_standard_derivatives : enable\nprecision highp float;\n\
        in vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(fwidth(uv), 0.0, 1.0); }\n";
    let warning = "a.frag:2:1: warning[legacy-extension]: extension `GL_OES_standard_derivatives` does not exist in WebGL2";
    check(&[("a.frag", shader)], &[warning]);
}

#[test]
fn a_default_precision_of_the_script_is_not_missing() {
    let script = "const head = 'precision highp float;';\nconst gl = make(head);";
    let shader = "uniform float x;\nvoid main() { gl_FragColor = vec4(x); }\n";
    check_context(script, shader, &[]);
    let script = "const gl = canvas.getContext('webgl');";
    check_context(
        script,
        shader,
        &["a.html:3:23: error[missing-precision]: missing precision for `float`"],
    );
}
