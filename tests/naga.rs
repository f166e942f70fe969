//! The target languages of naga: every GLSL feature can be translated to all four, or is rejected
//! at its position.
//!
//! `INSTA_UPDATE=always cargo test --all-features --test all naga` accepts the current output.
#![cfg(feature = "naga")]

use super::scratch::Scratch;
use shaderlint::explain::{Checked, analyze};
use shaderlint::port::naga::{
    FirstRow, LowerOptions, Lowered, Refused, Repeated, TargetLanguage, lower, translate, write,
};
use shaderlint::port::{
    Destination, MainChoice, Order, Target, complete_shaders, translate_shaders,
};
use shaderlint::project::{Project, compose};
use shaderlint::semantic::{Completeness, Dialect, Stage, Unit};
use shaderlint::text::{Role, Sources};
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// Translates the only pass of a shader.
fn written(code: &str, language: TargetLanguage) -> Result<Vec<u8>, Refused> {
    let project = Project::from_shader("shader", code).unwrap();
    let composed = compose(&project, "shader").unwrap();
    let [unit] = &composed.units[..] else {
        panic!("one pass");
    };
    let problems = &composed.analysis(unit).diagnostics;
    assert!(problems.is_empty(), "{problems:?}\n{code}");
    translate(&project, &composed, unit, language, FirstRow::Top).map(|made| made.unwrap().text)
}

fn wgsl(code: &str) -> String {
    let written = written(code, TargetLanguage::Wgsl).unwrap_or_else(|e| panic!("{e:?}\n{code}"));
    String::from_utf8(written).unwrap()
}

/// Asserts that all four languages support the code.
#[track_caller]
fn reaches_all(code: &str) {
    for language in TargetLanguage::ALL {
        let bytes =
            written(code, language).unwrap_or_else(|e| panic!("{language:?} {e:?}\n{code}"));
        match language {
            TargetLanguage::Spirv => assert_eq!(bytes[..4], 0x0723_0203_u32.to_le_bytes()),
            _ => assert!(String::from_utf8(bytes).unwrap().contains("fragment_main")),
        }
    }
}

/// Compiles the HLSL output if `HLSL_COMPILER` names glslang's executable.
#[test]
fn hlsl_output_compiles() {
    let Ok(compiler) = std::env::var("HLSL_COMPILER") else {
        return;
    };
    let folder = Scratch::new(&[]);
    let file = folder.path("shader.hlsl");
    let accepts = |stage: Stage, text: &[u8]| {
        fs::write(&file, text).unwrap();
        let (stage, entry) = match stage {
            Stage::Vertex => ("vert", "vertex_main"),
            Stage::Fragment => ("frag", "fragment_main"),
        };
        let out = Command::new(&compiler)
            .args(["-D", "-S", stage, "-e", entry, "-V", "-o"])
            .arg(folder.path("shader.spv"))
            .arg(&file)
            .output()
            .unwrap();
        let stderr = String::from_utf8_lossy(&out.stdout).into_owned();
        assert!(
            out.status.success(),
            "{stderr}\n{}",
            String::from_utf8_lossy(text)
        );
    };
    for statement in STATEMENTS {
        let text = written(&with_functions(statement), TargetLanguage::Hlsl).unwrap();
        accepts(Stage::Fragment, &text);
    }
    for (stage, code) in SHADERS {
        let (_, text) = translate_complete(&checked(*stage, code), TargetLanguage::Hlsl).unwrap();
        accepts(*stage, &text);
    }
}

#[test]
fn templates_translate_to_all_languages() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/templates");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "glsl") {
            reaches_all(&fs::read_to_string(&path).unwrap());
            count += 1;
        }
    }
    assert!(count >= 3);
}

/// Statements that use a feature; `c` is the colour, `f` the pixel position, `i` and `u` integers
/// that are unknown at compile time.
const STATEMENTS: &[&str] = &[
    // Components, places, and assignments used as values.
    "c.zx = f; c.rgb *= 2.0; c.xyz.yz = f.yx; c[i] = 1.0;",
    "c.x = c.y = f.x; c += 1.0; i++; --i; vec4 d = c++; c = d--;",
    "vec2 v = f; v.yx = v; v[i] += v.x; c.xy = v;",
    "float a[3]; a[0] = f.x; a[i] = a[2]; c = vec4(a[i], a[0], float(a.length()), 1.0);",
    "float a[2] = float[2](f.x, f.y); float b[] = float[](1.0, 2.0); c.x = float(a == b);",
    "const float T[3] = float[3](1.0, 2.0, 4.0); c.x = T[i] + T[1];",
    "struct S { vec2 p; float q[2]; }; S s = S(f, float[2](1.0, f.x)); S t = s; t.q[i] = 3.0; \
     c.x = float(s != t) + t.q[1];",
    "c.zyx[i] = 2.0; c.zyx[i] += f.x; c.x += c.zyx[i]; f.yx[1] = 3.0;",
    "const mat2 M[2] = mat2[2](mat2(1.0), mat2(2.0)); c.xy = M[i][i] + M[1][0]; c.z = mat2(3.0)[i].x;",
    // Scalars and vectors.
    "c = mod(c, 3.0) + mod(c, c.wzyx); c.x = mod(f.x, 2.0);",
    "i = i / 3 + i % 5 - (i << 2) + (i >> 1) ^ (i & 7) | ~i; c.x = float(i);",
    "u = u * 747796405u + 2891336453u; u ^= u >> 16; u <<= 3; c.x = float(-u);",
    "ivec2 p = ivec2(f) << 1; uvec3 q = uvec3(p, u) >> uvec3(1u, 2u, 3u); c.xyz = vec3(q);",
    "c.x = float(floatBitsToUint(f.x)) + intBitsToFloat(i) + uintBitsToFloat(u);",
    "c.x = 1.0 / 0.0; c.y = sqrt(-1.0); c.z = -1.0 / 0.0; c.w = float(isnan(c.y) || isinf(c.x));",
    "c.xy = vec2(1.0, 1.0 / 0.0);",
    "c.x = float(any(isnan(c)));",
    "float w; c.x = modf(f.x, w) + w; vec2 ww; c.xy = modf(f, ww); c.zw = ww;",
    "c.x = length(f.x) + distance(f.x, 1.0) + dot(f.x, 2.0) + normalize(f.x) + reflect(f.x, 1.0) \
     + refract(f.x, 1.0, 0.5) + faceforward(f.x, 1.0, f.y);",
    "c.xyz = refract(c.xyz, c.zyx, 0.7) + reflect(c.xyz, c.zyx) + faceforward(c.xyz, c.zyx, c.yyy);",
    "c = mix(c, c.wzyx, f.x) + mix(c, c.wzyx, bvec4(true, false, i > 1, u > 2u)) + step(0.5, c);",
    "c = clamp(c, 0.0, 1.0) + min(c, 0.5) + max(c, f.x) + smoothstep(0.0, 1.0, c);",
    "i = clamp(i, 0, 3) + abs(i) + sign(i) + min(i, 4); c.x = float(i);",
    "c.x = atan(f.y, f.x) + atan(f.x) + sinh(f.x) + acosh(f.x) + roundEven(f.x) + trunc(f.x);",
    "c = vec4(unpackHalf2x16(packHalf2x16(f)), unpackSnorm2x16(packUnorm2x16(f)));",
    "c.xyz = vec3(lessThan(f, c.xy), all(equal(f, c.xy))); c.x = float(any(not(bvec2(i > 1))));",
    // Matrices.
    "mat2 m = mat2(f, f.yx); m *= 2.0; m = m + 1.0 - m / 2.0; m = 3.0 / m; c.xy = m * f * m;",
    "mat3 m = mat3(2.0); m[1].xy = f; m[i][i] = 4.0; c.xyz = m[i] + m[0]; m++; c.x += -m[0][0];",
    "mat4 m = mat4(mat2(f, f)); mat2 k = mat2(m); mat2 l = mat2(c); c.x = float(k == l) + k[1].x;",
    "mat2x3 m = mat2x3(c.xyz, c.xyz); mat3x2 t = transpose(m); mat2 p = t * m; c.xy = p * f;",
    "mat3 m = outerProduct(c.xyz, c.zyx); c.x = determinant(inverse(m)) + inverse(mat2(c))[0].x;",
    "c = inverse(mat4(f.x)) * c + matrixCompMult(mat4(1.0), mat4(2.0))[i];",
    "c.x = (mat2(1.0, 2.0, 3.0, 4.0) * f)[i] + mat2(f, f)[i].x;",
    // Short-circuit and conditional evaluation.
    "c.x = i > 1 && bump(f.x) > 2.0 ? bump(f.y) : f.x; c.y = i > 2 || bump(f.x) > 1.0 ? 1.0 : 0.0;",
    "bool b = i > 1 ^^ u > 1u; c.x = b ? 1.0 : 2.0; mat2 m = b ? mat2(1.0) : mat2(2.0); c.xy *= m;",
    "c.x = (bump(f.x), f.y); if (i > 1) nothing();",
    // Control flow.
    "for (int k = 0; k < 9; k++) { if (k == i) continue; if (k > 7) break; c.x += float(k); }",
    "int k = 0; while (k++ < 5) { float z; z += 1.0; c.x += z; } do { k--; if (k == 2) continue; } \
     while (k > 0);",
    "while (bool go = i < 3) { i++; c.x += float(go); }",
    "for (;;) { if (bump(c.x) > 5.0) break; } for (int a = 0, b = 5; a < b; a++, b--) c.y += 1.0;",
    "switch (i) { case 0: c.x = 1.0; case 1: case 2: c.y = 2.0; break; default: c.z = 3.0; }",
    "switch (u) { case 1u: float z = 1.0; case 2u: z = 2.0; c.x = z; if (i > 2) break; c.y = z; }",
    "for (int k = 0; k < 3; k++) { switch (k) { case 1: continue; default: break; } c.x += 1.0; }",
    "if (f.x < 0.0) discard; if (f.x < 1.0) return; else c.x = 1.0;",
    // Calls.
    "c.x = same(f.x) + same(f).y + float(same(i)); swap(c.x, c.y); swap(c.z, c.z);",
    "float a[2]; fill(a); fill(A); c.x = a[1] + A[0]; swap(G, c.w); c.x = twice(c.x) + G;",
    "float x = 1.0, y = 2.0; swap(x, y); vec2 v; split(c, v, c.zw); c.xy = v;",
    "float x = 1.0; swap(x, x); vec2 v = f; split(vec4(v, v), v, v); swap(v.x, v.y); c.xy = v * x;",
    // Textures.
    "c = texture(iChannel0, f) + textureLod(iChannel1, f, 1.0) + texelFetch(iChannel2, ivec2(f), 0);",
    "c = look(iChannel3, f) + look(iChannel0, f) + textureGrad(iChannel0, f, dFdx(f), dFdy(f));",
    "c = textureOffset(iChannel0, f, ivec2(1, -1)) + textureProj(iChannel0, c) + \
     texture(iChannel0, f, 1.5); c.xy += vec2(textureSize(iChannel0, 0)) * fwidth(f);",
    // Uniforms.
    "c = iMouse + iDate + vec4(iResolution, iTime) + iTimeDelta + float(iFrame) + iFrameRate;",
    "c.xyz = iChannelResolution[i] + iChannelResolution[1] + iChannelTime[i] + iChannelTime[2];",
    "c = gl_FragCoord * (gl_FrontFacing ? 1.0 : 2.0); float gl = 1.0; c.x += gl;",
];

const FUNCTIONS: &str = "\
float G = 1.0;
float A[2] = float[2](1.0, 2.0);
const vec3 K[2] = vec3[2](vec3(1.0), vec3(2.0, 3.0, 4.0));
float bump(float x) { G += x; return G + K[1].x; }
void nothing() { G = 2.0; }
float same(float x) { return x; }
vec2 same(vec2 x) { return x; }
int same(int x) { x++; return x; }
float twice(const in float x) { return x * 2.0; }
void swap(inout float a, inout float b) { float t = a; a = b; b = t; }
void fill(out float a[2]) { a[0] = 1.0; a[1] = a[0]; }
void split(in vec4 all, out vec2 a, out vec2 b) { a = all.xy; b = all.zw; }
vec4 look(sampler2D s, vec2 p) { return texture(s, p); }
float unsaid(float x) { if (x > 1.0) return 2.0; }
";

#[test]
fn features_translate_to_all_languages() {
    for statement in STATEMENTS {
        reaches_all(&with_functions(statement));
    }
}

/// A ShaderToy shader that executes a statement.
fn with_functions(statement: &str) -> String {
    format!(
        "{FUNCTIONS}void mainImage(out vec4 c, in vec2 f) {{\n    c = vec4(f, unsaid(f.x), 1.0);\n    \
         int i = iFrame; uint u = uint(iFrame);\n    {statement}\n}}\n"
    )
}

/// Complete shaders of both stages and versions, with arbitrary uniforms.
const SHADERS: &[(Stage, &str)] = &[
    (
        Stage::Fragment,
        "#version 300 es\nprecision highp float;\nuniform vec2 u_resolution;\nin vec2 vUv;\n\
         layout(location = 0) out vec4 color;\nlayout(location = 1) out vec4 depth;\n\
         void main() { color = vec4(vUv / u_resolution, gl_FragCoord.xy); depth = vec4(1.0); \
         gl_FragDepth = 0.5; }\n",
    ),
    (
        Stage::Fragment,
        "precision mediump float;\nvarying vec2 v;\nuniform sampler2D maps[2];\n\
         void main() { gl_FragData[0] = texture2D(maps[1], v) + texture2D(maps[0], gl_PointCoord); }\n",
    ),
    (
        Stage::Vertex,
        "attribute vec4 at;\nattribute mat3 turn;\nuniform mat4 view;\nvarying vec2 v;\n\
         void main() { v = (turn * at.xyz).xy; gl_Position = view * at; gl_PointSize = 2.0; }\n",
    ),
    (
        Stage::Vertex,
        "#version 300 es\nstruct S { float a; mat2 m; };\nuniform S s[2];\nuniform bvec3 flags[3];\n\
         layout(location = 3) in vec4 at;\nout S passed;\nflat out ivec2 which;\n\
         void main() { passed = s[gl_InstanceID]; which = ivec2(gl_VertexID, flags[1]); \
         gl_Position = at * gl_DepthRange.diff; }\n",
    ),
    (
        Stage::Fragment,
        "#version 300 es\nprecision highp float;\nstruct Light { vec3 at; float power[2]; mat3x2 m; };\n\
         layout(std140) uniform Lights { Light lights[2]; bool on; mat2 turns[2]; };\n\
         uniform Other { vec2 p; float a[3]; } others[2];\nuniform struct { sampler2D map; float s; } m;\n\
         uniform bool flag;\nuniform float weights[3];\nuniform mat2 one;\nuniform vec3 last;\n\
         out vec4 color;\nvoid main() { int i = int(last.x); Light l = lights[i]; mat2 t = turns[i]; \
         color = texture(m.map, l.at.xy * m.s) * weights[i] + vec4(one[0], others[1].a[i], t[1].x); \
         if (flag && on) color.x += lights[1].power[i] + l.m[2].y + others[0].p.y + one[i].x; }\n",
    ),
    (
        Stage::Fragment,
        "precision mediump float;\nvarying vec2 v;\nuniform sampler2D maps[3];\n\
         uniform struct { sampler2D map; float s; } m[2];\n\
         vec4 look(sampler2D s, inout vec2 p) { p += 1.0; return texture2D(s, p); }\n\
         vec4 all(sampler2D s[3], vec2 p) { vec4 c = texture2D(s[2], p); \
         for (int i = 0; i < 3; i++) c += texture2D(s[i], p); return c; }\n\
         void main() { vec2 p = v; vec4 c = all(maps, v); for (int i = 0; i < 3; i++) { \
         c += texture2D(maps[i], v) + look(maps[i], p); } for (int i = 0; i < 2; i++) \
         c += texture2D(m[i].map, v * m[i].s); gl_FragColor = c; }\n",
    ),
    (
        Stage::Fragment,
        "#version 300 es\nprecision highp float;\nprecision highp int;\n\
         uniform highp isampler2D a;\nuniform highp usampler2DArray b;\n\
         uniform highp isampler3D d;\nuniform highp usamplerCube q;\nuniform int level;\n\
         centroid in vec2 v;\nflat in ivec2 w;\nout ivec4 color;\n\
         void main() { color = texture(a, v) + textureLod(a, v, 1.5) + textureOffset(a, v, \
         ivec2(1, -1)) + textureProj(a, v.xyx) + textureGrad(a, v, v, v) + ivec4(texture(b, \
         v.xyx)) + texture(d, v.xyx, 1.0) + ivec4(textureSize(q, level), textureSize(b, \
         level).z, w.x) + textureProjLodOffset(a, v.xyx, 1.0, ivec2(2)); }\n",
    ),
];

#[test]
fn complete_shaders_translate_to_all_languages() {
    for (stage, code) in SHADERS {
        let checked = checked(*stage, code);
        for language in TargetLanguage::ALL {
            translate_complete(&checked, language)
                .unwrap_or_else(|e| panic!("{language:?} {e:?}\n{code}"));
        }
    }
}

#[test]
fn the_interface_lists_the_inputs_from_the_host() {
    let shown = |(stage, code): &(Stage, &str), language| {
        let (lowered, text) = translate_complete(&checked(*stage, code), language).unwrap();
        let head = String::from_utf8_lossy(&text);
        let head: Vec<&str> = head.lines().take_while(|l| l.starts_with("//")).collect();
        let json = serde_json::to_string_pretty(&lowered.interface).unwrap();
        format!("{}\n{json}\n", head.join("\n"))
    };
    let [_, _, _, vertex, fragment, ..] = SHADERS else {
        panic!()
    };
    insta::assert_snapshot!(shown(fragment, TargetLanguage::Wgsl));
    insta::assert_snapshot!(shown(fragment, TargetLanguage::Hlsl));
    insta::assert_snapshot!(shown(vertex, TargetLanguage::Msl));
}

#[test]
fn the_interface_lists_the_inputs_of_all_passes() {
    let pass = |kind: &str, id: &str, inputs: &str| {
        format!(
            "{{\"type\":\"{kind}\",\"name\":\"\",\"outputs\":[{{\"id\":\"{id}\",\"channel\":0}}],\
             \"inputs\":[{inputs}],\"code\":\"void mainImage(out vec4 c, in vec2 f) \
             {{ c = texelFetch(iChannel0, ivec2(f), 0); }}\"}}"
        )
    };
    let reads = |id: &str| {
        format!(
            "{{\"id\":\"{id}\",\"type\":\"buffer\",\"channel\":0,\"sampler\":\
             {{\"filter\":\"linear\",\"wrap\":\"clamp\"}}}}"
        )
    };
    let image = pass("image", "4dfGRr", &reads("4dXGR8"));
    let buffer = pass("buffer", "4dXGR8", &reads("4dXGR8"));
    let json = format!(
        "{{\"ver\":\"0.1\",\"info\":{{\"id\":\"x\",\"name\":\"n\"}},\"renderpass\":[{image},{buffer}]}}"
    );
    let project = Project::from_json(&json).unwrap();
    let composed = compose(&project, "project").unwrap();
    let reported = |i: usize, row| {
        let unit = &composed.units[i];
        let made = translate(&project, &composed, unit, TargetLanguage::Wgsl, row);
        let interface = made.unwrap().unwrap().interface;
        let source = interface.textures[0].source.clone().unwrap();
        let pass = interface.pass.unwrap();
        (pass, source, interface.first_row.unwrap())
    };
    let (picture, read, row) = reported(0, FirstRow::Top);
    let (drawn, own, rows) = reported(1, FirstRow::Top);
    assert_eq!(
        (picture.kind, picture.order, picture.format),
        ("image", Some(1), "rgba8unorm")
    );
    assert_eq!(
        (drawn.kind, drawn.order, drawn.format),
        ("buffer", Some(0), "rgba32float")
    );
    assert_eq!((row, rows), (FirstRow::Top, FirstRow::Bottom));
    assert_eq!(reported(0, FirstRow::Bottom).2, FirstRow::Bottom);
    assert_eq!(read, own);
    assert_eq!(read.pass, Some(drawn.name));
    assert_eq!(
        (read.filter.as_str(), read.wrap.as_str()),
        ("linear", "clamp")
    );
}

#[test]
fn linked_stages_share_varying_locations() {
    let vertex = "#version 300 es\nin vec4 at;\nout vec3 unused;\nout vec2 b;\nout float a;\n\
                  void main() { a = at.x; b = at.xy; gl_Position = at; }\n";
    let fragment = "#version 300 es\nprecision highp float;\nin float a;\nin vec2 b;\nout vec4 c;\n\
                    void main() { c = vec4(a, b, 1.0); }\n";
    let file = |path: &str, code: &str| (path.to_string(), code.to_string(), None);
    let order = Order {
        target: Target::Wgsl,
        main: MainChoice::Wrap,
        output: Destination::Folder(Path::new("out")),
        version: None,
        poster: None,
        split: false,
        playground: None,
        interface: true,
        first_row: FirstRow::Top,
    };
    let all = complete_shaders(vec![file("x.vert", vertex), file("x.frag", fragment)]).unwrap();
    let build = translate_shaders(order, &all).unwrap();
    let paths: Vec<_> = build
        .files
        .iter()
        .map(|f| f.path.to_str().unwrap())
        .collect();
    let expected = [
        "x.vert.wgsl",
        "x.frag.wgsl",
        "x.vert.wgsl.json",
        "x.frag.wgsl.json",
    ];
    assert_eq!(paths, expected.map(|name| format!("out/{name}")));
    let text = |i: usize| String::from_utf8(build.files[i].content.clone()).unwrap();
    for stage in [text(0), text(1)] {
        assert!(stage.contains("@location(1) b: vec2<f32>"), "{stage}");
        assert!(stage.contains("@location(2) a: f32"), "{stage}");
    }
    let alone = complete_shaders(vec![file("x.frag", fragment)]).unwrap();
    let build = translate_shaders(order, &alone).unwrap();
    let text = String::from_utf8(build.files[0].content.clone()).unwrap();
    assert!(text.contains("@location(0) a: f32"), "{text}");
}

/// Features without an equivalent in the target languages, and the message for each.
const REFUSED: &[(&str, &str, &str)] = &[
    (
        "uniform isamplerCube s;",
        "color = vec4(texture(s, vUv.xyx));",
        "texture(s, vUv.xyx)",
    ),
    (
        "uniform struct S { isampler2D map; } s; vec4 f(S x) { return vec4(texture(x.map, vUv)); }",
        "color = f(s);",
        "vec4 f(S x)",
    ),
];

#[test]
fn untranslatable_features_are_rejected_at_their_position() {
    for (declaration, statement, place) in REFUSED {
        let code = format!(
            "#version 300 es\nprecision highp float;\nprecision highp isampler2D;\n\
             precision highp isamplerCube;\nin vec2 vUv;\n{declaration}\nout vec4 color;\nvoid main() {{ {statement} }}\n"
        );
        let refused = refusal(&code);
        assert_eq!(refused.1, *place, "{}", refused.0.message);
    }
}

/// The WGSL translation of a complete fragment shader.
fn wgsl_of(code: &str) -> String {
    let (_, text) =
        translate_complete(&checked(Stage::Fragment, code), TargetLanguage::Wgsl).unwrap();
    String::from_utf8(text).unwrap()
}

/// The refusal of a shader, and the text at its position.
fn refusal(code: &str) -> (Refused, String) {
    let analysis = checked(Stage::Fragment, code);
    let refused = translate_complete(&analysis, TargetLanguage::Wgsl)
        .err()
        .unwrap();
    let text = analysis.program.sources.text(refused.span).to_string();
    (refused, text)
}

/// Checks a complete shader, which must compile.
fn checked(stage: Stage, code: &str) -> Checked {
    let mut sources = Sources::new();
    let files = [sources.add("", None, Role::User, code).unwrap()];
    let checked = analyze(&Unit {
        sources: &Arc::new(sources),
        files: &files,
        stage,
        dialect: Dialect::WebGl,
        context: shaderlint::syntax::GlContext::WEBGL2,
        infer_channels: false,
        completeness: Completeness::Complete,
    });
    assert!(
        checked.diagnostics.is_empty(),
        "{:?}\n{code}",
        checked.diagnostics
    );
    checked
}

fn translate_complete(
    checked: &Checked,
    language: TargetLanguage,
) -> Result<(Lowered, Vec<u8>), Refused> {
    let options = LowerOptions {
        language,
        first_row: FirstRow::Top,
        vertex: None,
    };
    let lowered = lower(&checked.program, options)?;
    let text = write(&lowered, &[])?;
    Ok((lowered, text))
}

#[test]
fn rows_are_flipped_for_images_only() {
    let image = "void mainImage(out vec4 c, in vec2 f) { c = vec4(f, dFdy(f)); }";
    let flipped = wgsl(image);
    assert!(flipped.contains("uniforms.iResolution.y"), "{flipped}");
    let derivative = flipped.split_once(" = dpdy(").unwrap().0;
    let name = derivative.rsplit(' ').next().unwrap();
    assert!(flipped.contains(&format!("-({name})")), "{flipped}");
}

#[test]
fn user_names_do_not_flip_rows() {
    let head =
        "#version 300 es\nprecision highp float;\nuniform vec2 resolution;\nout vec4 color;\n";
    let main = "void main() { color = vec4(resolution, gl_FragCoord.xy); }\n";
    let text = wgsl(&format!("{head}{main}"));
    assert!(!text.contains("resolution.y"), "{text}");
    assert!(text.contains("// pictureHeight is the height"), "{text}");
    assert!(text.contains("= uniforms.pictureHeight;"), "{text}");
    let taken = wgsl(&format!(
        "{head}const vec2 pictureHeight = vec2(1.0);\n{main}"
    ));
    assert!(taken.contains("= uniforms.pictureHeight2_;"), "{taken}");
    let mine =
        wgsl("void mainImage(out vec4 c, in vec2 f) { vec2 iResolution = f; c.xy = iResolution; }");
    assert!(mine.contains("= uniforms.iResolution.y;"), "{mine}");
}

/// Where compilers of WGSL choose another rounding than WebGL, the operations are written out.
#[test]
fn operations_have_the_rounding_of_webgl() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    mat2 m = mat2(p, p.yx) / p.x;\n    \
                c = smoothstep(vec4(p, p), vec4(1.0), c) + smoothstep(0.0, 1.0, m[0].x) + \
                smoothstep(0.2, 1.0, p.xyxy);\n}";
    let text = wgsl(code);
    assert_eq!(text.matches("fn smoothstep").count(), 2, "{text}");
    assert!(text.contains(" * (3f - (2f * t"), "{text}");
    assert!(!text.contains("smoothstep("), "{text}");
    assert!(text.contains("(1f / "), "{text}");
    let hlsl = String::from_utf8(written(code, TargetLanguage::Hlsl).unwrap()).unwrap();
    assert!(hlsl.contains("smoothstep("), "{hlsl}");
}

/// A variable that is an operand is read after a call beside it, a value computed from it before, in all
/// languages as in the browser.
#[test]
fn operands_are_evaluated_in_the_order_of_the_browser() {
    let code = "int g = 1;\nint f() { g = 7; return 2; }\nint both(int x, int y) { return x * 10 + y; }\n\
                void mainImage(out vec4 c, in vec2 p) {\n    \
                c.x = float(-g + f());\n    c.y = float(g + f());\n    c.z = float(both(g * 2, f()));\n    \
                c.w = float(both(f(), g));\n}";
    for language in [
        TargetLanguage::Wgsl,
        TargetLanguage::Hlsl,
        TargetLanguage::Msl,
    ] {
        let text = String::from_utf8(written(code, language).unwrap()).unwrap();
        let body = text.split_once("mainImage(").unwrap().1;
        let steps = body.lines().filter_map(|line| match line {
            _ if line.trim_end().ends_with("= g;") => Some('g'),
            _ if line.contains("= f(") => Some('f'),
            _ => None,
        });
        assert_eq!(steps.collect::<String>(), "gffggffg", "{text}");
    }
}

/// The steps after a branch that returns are in its other side if they take derivatives: compilers that
/// join both sides would give the pixels that returned other values.
#[test]
fn derivatives_after_a_return_move_to_the_else_branch() {
    let of = |rest: &str| {
        wgsl(&format!(
            "float f(vec2 p) {{ if (p.x > 1.0) {{ p.x -= 0.4; return 0.0; }} {rest} }}\n\
             void mainImage(out vec4 c, in vec2 p) {{ c = vec4(f(p)); }}"
        ))
    };
    let is_divided = |text: &str| {
        let body = text.split_once("fn f(").unwrap().1;
        let branch = body.split_once("return 0f;").unwrap().1;
        branch
            .trim_start()
            .trim_start_matches('}')
            .trim_start()
            .starts_with("else")
    };
    for (rest, expected) in [
        ("return dFdx(p.x);", true),
        ("vec4 t = texture(iChannel0, p); return t.x;", true),
        (
            "for (int i = 0; i < 3; i++) p.y += dFdy(p.x); return p.y;",
            true,
        ),
        ("return textureLod(iChannel0, p, 0.0).x;", false),
        ("return length(p);", false),
    ] {
        let text = of(rest);
        assert_eq!(is_divided(&text), expected, "{rest}\n{text}");
    }
    // Derivatives in called functions count; HLSL, MSL and SPIR-V keep the order of the shader.
    let code = "float g(vec2 p) { return fwidth(p.x); }\n\
                float f(vec2 p) { if (p.x > 1.0) { p.x -= 0.4; return 0.0; } return g(p); }\n\
                void mainImage(out vec4 c, in vec2 p) { c = vec4(f(p)); }";
    assert!(is_divided(&wgsl(code)), "{}", wgsl(code));
    let hlsl = written(code, TargetLanguage::Hlsl).unwrap();
    let hlsl = String::from_utf8(hlsl).unwrap();
    assert!(!hlsl.contains("else"), "{hlsl}");
}

#[test]
fn out_parameters_start_at_zero() {
    let of = |body: &str| {
        wgsl(&format!(
            "void mainImage(out vec4 c, in vec2 f) {{ {body} }}"
        ))
    };
    let cleared = "(*c) = vec4<f32>();";
    for body in ["c.xy += f;", "if (f.x > 1.0) c = f.xyxy;", "c = c + 1.0;"] {
        assert!(of(body).contains(cleared), "{body}");
    }
    assert!(!of("vec2 g = f; c = g.xyxy; c += 1.0;").contains(cleared));
}

#[test]
fn integer_textures_wrap_at_the_nearest_level() {
    let text = wgsl_of(
        "#version 300 es\nprecision highp float;\nprecision highp isampler2D;\n\
         uniform isampler2D t;\nuniform float l;\nout vec4 c;\n\
         void main() { c = vec4(textureLod(t, gl_FragCoord.xy, l)); }\n",
    );
    assert!(text.contains("= min(max(i32(round("), "{text}");
    // The remainder has the sign of the dividend, so two operations are needed.
    assert_eq!(text.matches(" % ").count(), 2, "{text}");
}

#[test]
fn frag_coord_w_is_inverted_for_direct3d() {
    let code = "#version 300 es\nprecision highp float;\nout vec4 c;\n\
                void main() { c = vec4(gl_FragCoord.w); }\n";
    let inverse = |language| {
        let (_, text) = translate_complete(&checked(Stage::Fragment, code), language).unwrap();
        String::from_utf8(text)
            .unwrap()
            .contains("1.0 / position.w")
    };
    assert!(inverse(TargetLanguage::Hlsl) && !inverse(TargetLanguage::Wgsl));
}

#[test]
fn texture_size_halves_with_each_level() {
    let of = |level: &str| {
        wgsl(&format!(
            "void mainImage(out vec4 c, in vec2 f) {{ c.xy = vec2(textureSize(iChannel0, {level})); }}"
        ))
    };
    assert!(!of("0").contains(" >> "));
    assert!(
        of("iFrame").contains(">> vec2(min(u32("),
        "{}",
        of("iFrame")
    );
    assert!(!of("iFrame").contains("textureDimensions(iChannel0_, "));
}

#[test]
fn sampler_array_elements_are_selected_by_switch() {
    let text = wgsl_of(SHADERS[5].1);
    assert_eq!(text.matches("switch ").count(), 4, "{text}");
    assert!(
        text.contains("fn all_(s_0_: texture_2d<f32>") || text.contains("s_0"),
        "{text}"
    );
}

#[test]
fn qualifiers_are_kept() {
    let vertex = "#version 300 es\ninvariant gl_Position;\nin vec4 at;\ncentroid out vec2 v;\n\
                  flat out int w;\nvoid main() { v = at.xy; w = 1; gl_Position = at; }\n";
    let (_, text) =
        translate_complete(&checked(Stage::Vertex, vertex), TargetLanguage::Wgsl).unwrap();
    let text = String::from_utf8(text).unwrap();
    for part in [
        "@builtin(position) @invariant",
        "@location(0) @interpolate(perspective, centroid) v: vec2<f32>",
        "@location(1) @interpolate(flat) w: i32",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let reported = wgsl_of(SHADERS[6].1);
    for part in [
        "centroid",
        "// flat inputs have the value of the first vertex",
        "// integer textures use nearest filtering",
    ] {
        assert!(reported.contains(part), "{part}\n{reported}");
    }
}

#[test]
fn row_major_layouts_are_supported() {
    let code = "#version 300 es\nprecision highp float;\nstruct S { mat2x3 m; };\n\
                layout(std140) uniform B { layout(row_major) mat3x2 a; mat3x2 b; \
                layout(row_major) S s[2]; layout(row_major) mat4 n[2]; int i; };\n\
                out vec4 c;\nvoid main() { c = vec4(a[i] + a[1], b[2].x, s[i].m[1].y) + n[i][i] + n[1] * \
                vec4(a[0][i]); }\n";
    let checked = checked(Stage::Fragment, code);
    for language in TargetLanguage::ALL {
        let (lowered, text) = translate_complete(&checked, language).unwrap();
        if language == TargetLanguage::Wgsl {
            let text = String::from_utf8(text).unwrap();
            assert!(text.contains("a: mat2x3<f32>"), "{text}");
            assert!(text.contains("transpose("), "{text}");
            let members = &lowered.interface.buffers[0].members;
            let reported: Vec<_> = members
                .iter()
                .map(|m| (m.name.as_str(), m.offset, m.columns.is_some(), m.rows))
                .collect();
            let rows = |count| Some(Repeated { count, stride: 16 });
            assert_eq!(
                reported,
                [
                    ("a", 0, false, rows(2)),
                    ("b", 32, true, None),
                    ("s[0].m", 80, false, rows(3)),
                    ("s[1].m", 128, false, rows(3)),
                    ("n", 176, false, rows(4)),
                    ("i", 304, false, None),
                ]
            );
        }
    }
}

#[test]
fn out_of_bounds_texel_fetches_return_zero() {
    let text =
        wgsl("void mainImage(out vec4 c, in vec2 f) { c = texelFetch(iChannel0, ivec2(f), 0); }");
    for part in [
        "fn texelFetch_sampler2D(image: texture_2d<f32>, at: vec2<i32>, level: i32)",
        "if all((vec2<u32>(at) < ",
        "return vec4<f32>();",
        "= texelFetch_sampler2D(iChannel0_, ",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// Browsers warn about code after the last return.
#[test]
fn functions_end_with_their_last_return() {
    let text = wgsl(
        "float f(float x) { if (x > 1.0) { return 1.0; } else if (x > 0.5) { return x; } return x * x; }\n\
         void mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x)); }",
    );
    assert!(!text.contains("return f32();"), "{text}");
}

/// Constant expressions that WGSL compilers would reject must not remain in the output.
#[test]
fn invalid_constant_expressions_are_evaluated_at_run_time() {
    for (statement, refused) in [
        ("c.x = clamp(f.x, 1.0, 0.0);", "1f, 0f)"),
        ("c = clamp(c, 1.0, 0.0);", "vec4(1f), vec4(0f))"),
        ("c.x = smoothstep(1.0, 1.0, f.x);", "smoothstep(1f"),
        ("float a = -1.0; c.x = pow(a, 0.5);", "pow(-1f"),
        ("float a = 0.0; c.x = 1.0 / a;", "/ 0f"),
        ("vec2 a = vec2(0); c.xy = normalize(a);", "normalize(vec"),
        ("i = i / 0; c.x = float(i % 0);", "/ 0i"),
        (
            "ivec2 p = ivec2(i) << ivec2(1, 40); c.xy = vec2(p);",
            "<< vec2<u32>(1",
        ),
        (
            "int k = 2147483647; i = k + 1; c.x = float(i);",
            "2147483647i +",
        ),
        ("float k = 1e20; c.x = float(uint(k));", "u32(1"),
        ("mat2 m = mat2(1e30); c.x = (m * m)[0].x;", ") * mat2x2"),
        (
            "uint k = 0x7f800000u; c.x = uintBitsToFloat(k);",
            "bitcast<f32>(2",
        ),
    ] {
        let text = wgsl(&format!(
            "void mainImage(out vec4 c, in vec2 f) {{ c = f.xyxy; int i = iFrame; {statement} }}"
        ));
        assert!(!text.contains(refused), "{statement}\n{text}");
    }
}

#[test]
fn wgsl_output_is_as_recorded() {
    insta::assert_snapshot!(wgsl(include_str!("fixtures/naga.glsl")));
}

#[test]
fn deeply_nested_code_does_not_crash() {
    let deep = |n: usize, open: &str, close: &str| {
        format!(
            "void mainImage(out vec4 c, in vec2 f) {{ float x = f.x; c = vec4({}x{}); }}",
            open.repeat(n),
            close.repeat(n)
        )
    };
    for code in [
        deep(100, "sin(", ")"),
        deep(110, "-(", ")"),
        deep(200, "1.0 + ", ""),
        deep(60, "mod(", ", 2.0)"),
    ] {
        for language in TargetLanguage::ALL {
            // Deeply nested code may be rejected, but must not crash.
            let _ = written(&code, language);
        }
    }
    let chain: String = (1..250)
        .map(|i| format!("float f{i}(float x) {{ return f{}(x) + 1.0; }}\n", i - 1))
        .collect();
    reaches_all(&format!(
        "float f0(float x) {{ return x; }}\n{chain}void mainImage(out vec4 c, in vec2 f) {{ \
         c = vec4(f249(f.x)); }}"
    ));
}
