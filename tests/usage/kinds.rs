//! Files of every kind found in repositories: anything but GLSL ES stays unchanged, byte for byte,
//! and GLSL ES inside other files is fixed.

use crate::scratch::Scratch;
use std::collections::BTreeMap;
use std::fs;

/// A complete shader with two errors and a comment.
const SHADER: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() {\n    float a = 1; // kept\n    float b = max(a, 0);\n    color = vec4(a, b, a, b);\n}\n";
/// A typical desktop program, after its `#version`.
const DESKTOP: &str = "layout(location = 0) out vec4 color;\nvoid main() {\n    float a = 1;\n    color = vec4(a)\n}\n";

fn after_fix(text: &str) -> String {
    text.replace("a = 1;", "a = 1.0;")
        .replace("max(a, 0)", "max(a, 0.0)")
}

/// Files that contain shaders, with `§` for each shader.
const HOLDERS: &[(&str, &str)] = &[
    ("whole.frag", "§"),
    ("whole.glsl", "§"),
    ("whole.fs", "§"),
    ("noending", "§"),
    ("notes.txt", "§"),
    ("engine.shader", "§"),
    ("babylon.fx", "§"),
    (
        "App.vue",
        "<template>\n  <p>float a = 1;</p>\n</template>\n\n<script setup lang=\"ts\">\nconst a: number = 1;\nconst frag = `§`;\n</script>\n\n<style>\np { a: 1; }\n</style>\n",
    ),
    (
        "Scene.svelte",
        "<script>\n  let a = 1;\n  const frag = /* glsl */ `§`;\n</script>\n<p>don't {a}; float a = 1;</p>\n<Shader code={glsl`§`} />\n",
    ),
    (
        "page.astro",
        "---\nconst a = 1;\nconst frag = `§`;\n---\n<p>It's {a = 1;}</p>\n<script>const b = glsl`§`;</script>\n",
    ),
    (
        "page.html",
        "<!DOCTYPE html>\n<p>float a = 1;</p>\n<script type=\"x-shader/x-fragment\">§</script>\n<script>let a = 1; const s = `§`;</script>\n",
    ),
    ("plain.js", "let a = 1;\nconst s = `§`;\n"),
    (
        "tagged.mjs",
        "export const a = 1; export default glsl`§`;\n",
    ),
    (
        "tagged.cjs",
        "module.exports = /* glsl */ `§`; let a = 1;\n",
    ),
    ("typed.ts", "const a: number = 1; const s: string = `§`;\n"),
    ("typed.mts", "export const s: string = `§`; let a = 1;\n"),
    ("typed.cts", "const s: string = `§`; let a = 1;\n"),
    (
        "view.jsx",
        "const v = <p title=\"a = 1;\">don't</p>;\nconst s = `§`;\n",
    ),
    (
        "view.tsx",
        "const v = <T,>(a: T) => <p>{a}</p>;\nconst s = `§`;\n",
    ),
    (
        "guide.md",
        "# Text\n\nfloat a = 1;\n\n```\nUse vec3 and gl_FragColor, as vec4(a) = 1; is wrong here.\n```\n\n```diff\n-float a = 1;\n+vec3 a = vec3(1);\n```\n\n```python\na = 1;\n```\n\n```glsl\n§```\n\n```\n- float a = 1;\n+ float a = vec3(2).x;\n```\n",
    ),
    (
        "guide.mdx",
        "import A from 'a'\n\n```glsl\n§```\n\n<A a={1} />\n",
    ),
];

/// Files that must not change. `§` stands for a complete shader in them.
const OTHERS: &[(&str, &str)] = &[
    (
        "tool.py",
        "import os\nSHADER = \"\"\"§\"\"\"\nfloat a = 1;\n",
    ),
    (
        "main.cpp",
        "#include <string>\nstd::string s = R\"(§)\";\nfloat a = 1;\n",
    ),
    (
        "shared.h",
        "#pragma once\nvoid main() { float a = 1; vec3 b = vec3(a); }\n",
    ),
    (
        "lib.rs",
        "const S: &str = r#\"§\"#;\nfn main() { let a = 1; }\n",
    ),
    (
        "Program.fs",
        "module Program\n\nopen System\n\nlet a = 1;\nlet f x = x + a\nlet s = \"\"\"§\"\"\"\n",
    ),
    ("script.vs", ": square dup * ;\n1 a = 1;\n"),
    (
        "Unlit.shader",
        "Shader \"Unlit\" {\n  SubShader {\n    Pass {\n      GLSLPROGRAM\n      void main() { float a = 1; gl_FragColor = vec4(a); }\n      ENDGLSL\n    }\n  }\n}\n",
    ),
    (
        "water.gdshader",
        "shader_type spatial;\nvoid fragment() { float a = 1; ALBEDO = vec3(a); }\n",
    ),
    (
        "water.shader",
        "shader_type canvas_item;\nvoid fragment() { float a = 1; COLOR = vec4(a); }\n",
    ),
    (
        "old.fx",
        "float4x4 world;\nfloat4 main(float4 p : POSITION) : COLOR0 { float a = 1; return p * a; }\n",
    ),
    (
        "new.hlsl",
        "cbuffer C : register(b0) { float a; };\nfloat4 main() : SV_Target { float a = 1; return a; }\n",
    ),
    (
        "hidden.glsl",
        "cbuffer C : register(b0) { float4 k; };\nfloat4 main() : SV_Target { float a = 1; return a; }\n",
    ),
    (
        "blur.metal",
        "#include <metal_stdlib>\nkernel void f() { float a = 1; }\n",
    ),
    (
        "web.wgsl",
        "@fragment fn f() -> @location(0) vec4<f32> { var a = 1; return vec4<f32>(a); }\n",
    ),
    (
        "web.glsl",
        "@fragment fn f() -> @location(0) vec4<f32> { var a = 1; return vec4<f32>(a); }\n",
    ),
    (
        "vulkan.frag",
        "layout(set = 0, binding = 1) uniform sampler2D t;\nvoid main() { float a = 1; }\n",
    ),
    (
        "sum.comp",
        "layout(local_size_x = 1) in;\nvoid main() { float a = 1; }\n",
    ),
    (
        "sum.glsl",
        "layout(local_size_x = 1) in;\nvoid main() { float a = 1; }\n",
    ),
    (
        "grass.geom",
        "layout(points) in;\nvoid main() { float a = 1; EmitVertex(); }\n",
    ),
    (
        "grass.glsl",
        "layout(triangles) in;\nlayout(triangle_strip) out;\nvoid main() { float a = 1; EmitVertex(); }\n",
    ),
    (
        "hill.tesc",
        "layout(vertices = 3) out;\nvoid main() { float a = 1; }\n",
    ),
    (
        "hill.tese",
        "layout(quads) in;\nvoid main() { float a = 1; gl_Position = vec4(gl_TessCoord, 1); }\n",
    ),
    ("ray.rgen", "void main() { float a = 1; }\n"),
    (
        "package.json",
        "{\"scripts\": {\"a\": \"float a = 1; void main() {}\"}}\n",
    ),
    ("broken.json", "{\"a\": 1; void main() { float a = 1; }\n"),
    ("package-lock.json", "{\"a\": \"float a = 1;\"}\n"),
    ("yarn.lock", "a§1:\n  float a = 1;\n"),
    (
        "bundle.js.map",
        "{\"sourcesContent\": [\"void main() { float a = 1; }\"]}\n",
    ),
    ("bundle.min.js", "var a=`§`;"),
    (
        "book.ipynb",
        "{\"cells\": [{\"source\": [\"float a = 1;\", \"void main() {}\"]}]}\n",
    ),
    (
        "data.glsl",
        "{\"code\": \"void main() { float a = 1; }\"}\n",
    ),
    (
        "page.glsl",
        "<!DOCTYPE html>\n<script type=\"x-shader/x-fragment\">§</script>\n",
    ),
    (
        "module.glsl",
        "import a from 'a';\nexport default `§`;\nlet a = 1;\n",
    ),
    ("tool.glsl", "import os\ndef f(x):\n    a = 1;\n"),
    (
        "escaped.html",
        "<script type=\"x-shader/x-fragment\">void main() { float a = 1; for (int i = 0; i &lt; 3; i++) {} }</script>\n",
    ),
    (
        "page.js",
        "const page = `<!DOCTYPE html><html><body><script>void main() { float a = 1; gl_FragColor = vec4(a); }</script></body></html>`;\n",
    ),
    (
        "native.js",
        "const c = `#include <stdio.h>\nvoid main() { float a = 1; printf(\"x\"); }`;\n",
    ),
    (
        "Empty.vue",
        "<template>\n  <p>void main() { float a = 1; }</p>\n</template>\n",
    ),
    (
        "README",
        "Write float a = 1; in a shader and see what the linter says of it.\n",
    ),
    (
        "prose.txt",
        "In GLSL one writes vec3 a = vec3(1) and void main() { float a = 1; } there.\n",
    ),
    (
        "change.txt",
        "+vec3 a = vec3(1);\n-vec3 b = vec3(1);\n+float a = 1;\n",
    ),
    (
        "change.glsl",
        "diff --git a/a.glsl b/a.glsl\n--- a/a.glsl\n+++ b/a.glsl\n@@ -1,1 +1,1 @@\n-float a = 1;\n+float a = 2;\n",
    ),
    ("Makefile", "a: b\n\tfloat a = 1;\n"),
    ("run.sh", "#!/bin/sh\nfloat a = 1;\nvoid main() { }\n"),
    (
        "style.css",
        "a { b: 1; }\n/* void main() { float a = 1; } */\n",
    ),
    (
        "art.svg",
        "<svg><script>void main() { float a = 1; }</script></svg>\n",
    ),
    ("ci.yml", "a: 1;\nb: void main() { float a = 1; }\n"),
    (
        "Main.java",
        "class Main { public static void main(String[] a) { float a = 1; } }\n",
    ),
];

/// The name of a style, and how it transforms a text.
type Style = (&'static str, fn(&str) -> String);

/// Encodings and line ends of files.
const STYLES: [Style; 4] = [
    ("plain", |text| text.to_string()),
    ("crlf", |text| text.replace('\n', "\r\n")),
    ("tabs", |text| text.replace("    ", "\t")),
    ("open", |text| text.trim_end_matches('\n').to_string()),
];

/// The files, each with its content before and after `--fix`, with or without `--unsafe-fixes`.
fn files(unsafe_fixes: bool) -> BTreeMap<String, (Vec<u8>, Vec<u8>)> {
    let mut all = BTreeMap::new();
    for (style, write) in STYLES {
        let mut add = |name: &str, before: &str, after: &str| {
            let (before, after) = (write(before).into_bytes(), write(after).into_bytes());
            all.insert(format!("{style}/{name}"), (before, after));
        };
        for (name, text) in HOLDERS {
            let before = text.replace('§', SHADER);
            add(name, &before, &text.replace('§', &after_fix(SHADER)));
        }
        for (name, text) in OTHERS {
            let text = text.replace('§', SHADER);
            add(name, &text, &text);
        }
        for version in [
            "110", "120", "130", "140", "150", "330 core", "400", "410", "420", "430", "440",
            "450", "460", "310 es", "320 es",
        ] {
            let text = format!("#version {version}\n{DESKTOP}");
            let webgl2 = "#version 300 es\nprecision highp float;\n";
            let after = match unsafe_fixes {
                true => webgl2.to_string() + &after_fix(DESKTOP).replace("(a)", "(a);"),
                false => text.clone(),
            };
            add(&format!("v{version}.frag").replace(' ', "_"), &text, &after);
        }
        // A pass of an export, whose code has the line ends of the style.
        let export = |code: &str| {
            let code = serde_json::to_string(&write(code))
                .unwrap()
                .replace('/', "\\/");
            format!(
                "{{\"ver\": 1.0,\n  \"info\": {{\"name\": \"a = 1;\"}}, \"renderpass\": [{{ \"inputs\":[],\"outputs\":[],\"code\":{code} , \"type\":\"image\"}}]}}\n"
            )
        };
        let code = "// \"größe\" \\ a/b\nvoid mainImage(out vec4 c, in vec2 p) {\n    float a = 1;\n    c = vec4(a);\n}\n";
        add("pass.json", &export(code), &export(&after_fix(code)));
    }
    let utf16: Vec<u8> = SHADER.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let utf16 = [vec![0xff, 0xfe], utf16].concat();
    for name in ["wide.glsl", "wide.js", "wide.txt"] {
        all.insert(name.to_string(), (utf16.clone(), utf16.clone()));
    }
    let latin = [SHADER.as_bytes(), b"// gr\xf6\xdfe\n"].concat();
    all.insert("latin.frag".to_string(), (latin.clone(), latin));
    let binary = [SHADER.as_bytes(), b"\0\xff"].concat();
    for name in ["picture.png", "module.spv", "binary.frag"] {
        all.insert(name.to_string(), (binary.clone(), binary.clone()));
    }
    let marked = |text: String| [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let text = |shader: &str| format!("let a = 1;\nconst s = `{shader}`;\n");
    let files = (marked(text(SHADER)), marked(text(&after_fix(SHADER))));
    all.insert("marked.js".to_string(), files);
    all
}

#[track_caller]
fn check(args: &[&str], explicit: bool) {
    let files = files(args.contains(&"--unsafe-fixes"));
    let scratch = Scratch::new(&[]);
    for (name, (before, _)) in &files {
        scratch.write(name, before);
    }
    let names: Vec<&str> = files.keys().map(String::as_str).collect();
    let paths = if explicit { names } else { vec!["."] };
    let reported = scratch.run(&paths);
    let ran = scratch.run(&[args, &paths].concat());
    for (name, (before, after)) in &files {
        let now = fs::read(scratch.path(name)).unwrap();
        let is_searched = !["noending", "notes.txt", "engine.shader", "babylon.fx"]
            .iter()
            .any(|n| name.ends_with(n));
        let expected = if explicit || is_searched {
            after
        } else {
            before
        };
        assert_eq!(
            String::from_utf8_lossy(&now),
            String::from_utf8_lossy(expected),
            "{name}"
        );
        assert_eq!(&now, expected, "{name}");
    }
    // All fixes offered must be applied; more may become possible.
    let fixed = ran.out.split("; fixed ").nth(1);
    let fixed = fixed.and_then(|l| l.split(' ').next()).unwrap_or("");
    let promise = reported.out.split(" fixable with --fix").next();
    let promised = promise.and_then(|p| p.rsplit(' ').next()).unwrap_or("");
    let [fixed, promised] = [fixed, promised].map(|n| n.parse::<usize>().unwrap());
    assert!(100 < promised && promised <= fixed, "{promised} {fixed}");
    let skipped = ran
        .err
        .lines()
        .filter(|l| l.contains(": skipped: ") || l.contains(": not checked: "))
        .count();
    assert_eq!(skipped, ran.err.lines().count(), "{}", ran.err);
    assert_eq!(explicit, skipped > 0, "{}", ran.err);
}

#[test]
fn only_glsl_is_changed_in_folders() {
    check(&["--fix"], false);
}

#[test]
fn only_glsl_is_changed_in_named_files() {
    check(&["--fix"], true);
    check(&["--fix", "--unsafe-fixes"], true);
}

#[test]
fn named_files_without_a_shader_are_errors() {
    let scratch = Scratch::new(&[
        ("a.py", "x = 'void main() {}'\n"),
        ("b.js", "const a = 1;\n"),
        ("desktop.frag", "#version 450\nvoid main() {}\n"),
        ("shaderlint.toml", "desktop = \"skip\"\n"),
    ]);
    let err = |args: &[&str], code: i32| {
        let ran = scratch.run(args);
        assert_eq!(ran.code, code, "{args:?}");
        ran.err
    };
    let python = "shaderlint: a.py: not checked: the extension indicates Python\n";
    let script = "shaderlint: b.js: not checked: it contains no text that is certainly GLSL\n";
    assert_eq!(err(&["a.py"], 2), python);
    // The second time from the cache.
    assert_eq!(err(&["b.js"], 2), script);
    assert_eq!(err(&["b.js"], 2), script);
    assert_eq!(err(&["a.py", "b.js"], 2), [python, script].concat());
    assert_eq!(err(&["."], 0), "");
    let skipped = python.replace("not checked", "skipped");
    assert_eq!(err(&["--force-exclude", "a.py", "b.js"], 0), skipped);
    assert!(err(&["desktop.frag"], 0).contains("desktop.frag: skipped: "));
}

#[test]
fn skipped_input_is_passed_on() {
    let scratch = Scratch::new(&[]);
    let piped = scratch.pipe(
        "float a = 1;\n",
        &["--fix", "-", "--stdin-filename", "a.py"],
    );
    assert_eq!(piped.out, "float a = 1;\n");
}

#[test]
fn desktop_shaders_are_skipped_or_ported_on_request() {
    let code = "#version 330\nprecision highp float;\nout vec4 c;\nvoid main() { float a = 1; c = vec4(a); }\n";
    let scratch = Scratch::new(&[("a.frag", code)]);
    assert_eq!(scratch.places(&["a.frag"]), ["1:1 unsupported-version"]);
    scratch.write("shaderlint.toml", "desktop = \"skip\"");
    let ran = scratch.run(&["."]);
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (0, "", ""));
    scratch.write("shaderlint.toml", "desktop = \"port\"");
    let both = ["1:1 unsupported-version", "4:25 int-float-mix"];
    assert_eq!(scratch.places(&["a.frag"]), both);
    scratch.run(&["--fix", "a.frag"]);
    assert_eq!(scratch.read("a.frag"), code);
    scratch.run(&["--unsafe-fixes", "a.frag"]);
    let ported = code.replace("330", "300 es").replace("a = 1;", "a = 1.0;");
    assert_eq!(scratch.read("a.frag"), ported);
}

#[test]
fn generated_files_are_skipped_in_folders() {
    let script = format!("const fragmentShader = `{SHADER}`;\n");
    let scratch = Scratch::new(&[]);
    let mapped = format!("{script}//# sourceMappingURL=a.js.map\n");
    for (name, text) in [
        ("src/a.js", script.clone()),
        ("src/b.js", mapped),
        ("src/c.d.ts", script.clone()),
        ("dist/d.js", script.clone()),
        ("src/node_modules/e/e.js", script),
    ] {
        scratch.write(name, text);
    }
    let fixed = |args: &[&str]| scratch.run(args).out.contains("; fixed ");
    let reported = scratch.run(&["-v", "."]);
    let message = [
        "src/node_modules: skipped: dependencies or build output",
        "dist: skipped: dependencies or build output",
        "src/b.js: skipped: generated: refers to a source map",
    ];
    for line in message {
        assert!(reported.err.contains(line), "{}", reported.err);
    }
    assert!(
        reported
            .err
            .contains("1 file skipped because of the extension"),
        "{}",
        reported.err
    );
    assert!(fixed(&["--fix", "."]) && !fixed(&["--fix", "."]));
    // A file that is named explicitly is read.
    for name in ["dist", "src/b.js", "src/c.d.ts", "src/node_modules"] {
        assert!(fixed(&["--fix", name]), "{name}");
    }
}

#[test]
fn byte_order_marks_are_warnings() {
    let shader = "#version 300 es\nprecision highp float;\nout vec4 c;\nvoid main() {\n    c = vec4(1.0);\n}\n";
    let scratch = Scratch::new(&[]);
    scratch.write("a.frag", format!("\u{feff}{shader}"));
    let reported = scratch.run(&["a.frag", "--format", "short"]);
    assert!(
        reported.out.contains("warning[invalid-character]"),
        "{}",
        reported.out
    );
    assert!(!reported.out.contains("error["), "{}", reported.out);
    scratch.run(&["--fix", "a.frag"]);
    assert_eq!(scratch.read("a.frag"), shader);
    // Inside a string the byte order mark reaches the compiler.
    scratch.write(
        "a.js",
        format!("const fragmentShader = `\u{feff}{shader}`;\n"),
    );
    let reported = scratch.run(&["a.js", "--format", "short"]);
    assert!(
        reported.out.contains("error[version-placement]"),
        "{}",
        reported.out
    );
    let export = r#"{"ver": "0.1", "info": {"name": "n"}, "renderpass": [{"inputs": [], "outputs": [], "code": "void mainImage(out vec4 c, in vec2 p) {\n    float a = 1;\n    c = vec4(a);\n}\n", "type": "image"}]}"#;
    scratch.write("a.json", format!("\u{feff}{export}\n"));
    scratch.run(&["--fix", "a.json"]);
    assert!(scratch.read("a.json").contains("float a = 1.0;"));
}
