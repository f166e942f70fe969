//! Mistakes inside expressions and constructs of other languages: each is a single error, and its
//! fix produces the intended code.

use shaderlint::engine::{DialectChoice, Options, check, fix_text};
use shaderlint::lint::{Allow, Settings};
use shaderlint::project::NoFiles;
use shaderlint::rules::RULES;

const HEAD: &str = "#version 300 es\nprecision highp float;\nuniform sampler2D tex;\nuniform float time;\n\
    uniform mat4 mvp;\nin vec2 uv;\nout vec4 fragColor;\nfloat ring(vec2 p, float r) { return length(p) - r; }\n";
const BEFORE: &str = "void main() {\nvec3 a = vec3(uv, 0.5), b = a.zyx;\nfloat x = uv.x, y = uv.y;\n\
    int i = 3;\nbool p = x > y, q = y > 0.5;\n";
const AFTER: &str = "\nfragColor = vec4(a * x + b * y, float(i));\n}\n";

fn options() -> Options {
    let settings = Settings::new(RULES, &[], &["all".to_string()]).unwrap();
    Options::new(DialectChoice::Auto, settings)
}

fn judge(code: &str) -> Vec<String> {
    let report = check("a.frag", code, &options(), &NoFiles);
    assert!(report.unread.is_none(), "cannot be judged: {code}");
    report.diagnostics.into_iter().map(|d| d.message).collect()
}

/// Expects one error for `broken`; its fix must produce `meant`, which compiles.
fn check_in(before: &str, broken: &str, meant: &str, after: &str) {
    let code = format!("{before}{broken}{after}");
    let errors = judge(&code);
    assert_eq!(errors.len(), 1, "{broken}: {errors:?}");
    let fixed = fix_text("a.frag", &code, &options(), &NoFiles, Allow::Unsafe);
    let body = fixed
        .text
        .strip_prefix(before)
        .and_then(|t| t.strip_suffix(after));
    assert_eq!(body.unwrap_or(&fixed.text), meant, "{errors:?}");
    assert_eq!(judge(&fixed.text), Vec::<String>::new(), "{meant}");
}

fn statement(broken: &str, meant: &str) {
    check_in(&format!("{HEAD}{BEFORE}"), broken, meant, AFTER);
}

fn global(broken: &str, meant: &str) {
    check_in(HEAD, broken, meant, &format!("\n{BEFORE}{AFTER}"));
}

#[test]
fn types_and_functions_of_other_languages_are_replaced() {
    statement("float3 c = a; b = c;", "vec3 c = a; b = c;");
    statement(
        "vec2 c = half2(x, y); x = c.x;",
        "vec2 c = vec2(x, y); x = c.x;",
    );
    statement("Vec3 c = a; b = c;", "vec3 c = a; b = c;");
    statement("a = lerp(a, b, x);", "a = mix(a, b, x);");
    statement("x = saturate(y + 1.0);", "x = clamp(y + 1.0, 0.0, 1.0);");
    statement(
        "vec4 c = mul(mvp, mul(mvp, vec4(a, 1.0))); x = c.x;",
        "vec4 c = (mvp * (mvp * vec4(a, 1.0))); x = c.x;",
    );
    statement("x = mad(x, y + 1.0, x);", "x = (x * (y + 1.0) + x);");
    statement("x = fmod(x, y);", "x = mod(x, y);");
    statement(
        "a = tex2Dlod(tex, vec4(uv, 0.0, 1.0)).rgb;",
        "a = textureLod(tex, (vec4(uv, 0.0, 1.0)).xy, (vec4(uv, 0.0, 1.0)).w).rgb;",
    );
    statement("x = Math.max(x, Math.PI);", "x = max(x, 3.14159265);");
    statement("x = powf(x, y);", "x = pow(x, y);");
    statement("p = True;", "p = true;");
    statement("x = null;", "x = 0.0;");
    statement("console.log(x);", "");
    statement("x = a.dot(b);", "x = dot(a, b);");
}

#[test]
fn names_that_the_shader_declares_are_not_replaced() {
    let own = "float lerp(float a, float b) { return a * b; }\nstruct float3 { float x; };\n";
    let code = format!(
        "{HEAD}{own}{BEFORE}float var = lerp(x, y); float3 c = float3(var); x = c.x;{AFTER}"
    );
    assert_eq!(judge(&code), Vec::<String>::new());
}

#[test]
fn declarations_without_a_type_get_the_type_of_their_value() {
    statement("var c = a * 2.0; b = c;", "vec3 c = a * 2.0; b = c;");
    statement("let c: f32 = 1.0; x = c;", "float c = 1.0; x = c;");
    statement("let c: vec3<f32> = a; b = c;", "vec3 c = a; b = c;");
    statement("const c = 2.0; x = c;", "const float c = 2.0; x = c;");
    statement(
        "constexpr float c = 2.0; x = c;",
        "const float c = 2.0; x = c;",
    );
    statement("c = a * 2.0; b = c;", "vec3 c = a * 2.0; b = c;");
    global("const K: f32 = 2.0;", "const float K = 2.0;");
}

#[test]
fn operators_of_other_languages_are_replaced() {
    statement(
        "if (p and x > 1.0) { x = 1.0; }",
        "if (p && x > 1.0) { x = 1.0; }",
    );
    statement("if (not p) { x = 1.0; }", "if (!p) { x = 1.0; }");
    statement("if (i === 3) { x = 1.0; }", "if (i == 3) { x = 1.0; }");
    statement("if (i <> 3) { x = 1.0; }", "if (i != 3) { x = 1.0; }");
    statement("p &&= q;", "p = p && q;");
    statement("x = 2.0 * y ** 2 + 1.0;", "x = 2.0 * pow(y, 2.0) + 1.0;");
    statement("x = 2.0 * y ^ 2.0;", "x = 2.0 * pow(y, 2.0);");
    statement("x = x % 2.0;", "x = mod(x, 2.0);");
    statement("x = std::sin(y);", "x = sin(y);");
    statement("float c = 1,5; x = c;", "float c = 1.5; x = c;");
    statement("x = i as f32;", "x = float(i);");
    statement("x = (half)i;", "x = float(i);");
    statement("x = static_cast<float>(i);", "x = float(i);");
    statement("p = 0 <= i < 3;", "p = 0 <= i && i < 3;");
    statement("a = new vec3(1.0);", "a = vec3(1.0);");
    statement("x = 1.0h;", "x = 1.0;");
    statement("i = 0b101;", "i = 0x5;");
}

#[test]
fn statement_headers_of_other_languages_are_replaced() {
    statement(
        "if (p) { x = 1.0; } elif (q) { x = 2.0; } else { x = 3.0; }",
        "if (p) { x = 1.0; } else if (q) { x = 2.0; } else { x = 3.0; }",
    );
    statement(
        "[unroll] for (int k = 0; k < 4; k++) { x += 1.0; }",
        "for (int k = 0; k < 4; k++) { x += 1.0; }",
    );
    statement(
        "for (k in range(4)) { x += 1.0; }",
        "for (int k = 0; k < 4; k++) { x += 1.0; }",
    );
    statement("if p { x = 1.0; }", "if (p) { x = 1.0; }");
    global(
        "fn shade(q: vec3<f32>, r: f32) -> vec3<f32> { return q * r; }",
        "vec3 shade(vec3 q, float r) { return q * r; }",
    );
    global(
        "vec4 shade(vec2 q) : SV_Target { return vec4(q, 0.0, 1.0); }",
        "vec4 shade(vec2 q) { return vec4(q, 0.0, 1.0); }",
    );
    global(
        "cbuffer Params : register(b0) { vec4 tint; };",
        "uniform Params { vec4 tint; };",
    );
    global("import math", "");
}

#[test]
fn arguments_are_removed_added_and_swapped() {
    statement("x = ring(uv);", "x = ring(uv, 0.0);");
    statement("x = ring(true, uv, y);", "x = ring(uv, y);");
    statement("x = ring(y, uv);", "x = ring(uv, y);");
    statement("a = texture(uv, tex).rgb;", "a = texture(tex, uv).rgb;");
    statement("x = max(y);", "x = max(y, 0.0);");
    statement("a = mix(a, b.xy, x);", "a = mix(a, b.xyz, x);");
}

#[test]
fn a_missing_fourth_component_is_one() {
    statement("fragColor = a;", "fragColor = vec4(a, 1.0);");
    statement("fragColor = x;", "fragColor = vec4(vec3(x), 1.0);");
    statement("fragColor = vec4(a);", "fragColor = vec4(a, 1.0);");
    statement("fragColor = mvp * a;", "fragColor = mvp * vec4(a, 1.0);");
    statement("a = mvp * a;", "a = (mvp * vec4(a, 1.0)).xyz;");
}

#[test]
fn constants_that_are_written_become_variables_and_redeclarations_are_removed() {
    statement("const float k = 1.0; k += 2.0;", "float k = 1.0; k += 2.0;");
    statement("a.xx = uv;", "a.xy = uv;");
    statement(
        "vec3 c = a * x; vec3 c = a * x; b = c;",
        "vec3 c = a * x;  b = c;",
    );
    statement(
        "vec3 c = a * x; vec3 c = b; b = c;",
        "vec3 c = a * x; c = b; b = c;",
    );
    statement(
        "vec3 c = a; float c = x; x = c;",
        "vec3 c = a; float c2 = x; x = c2;",
    );
    let broken = format!("{HEAD}{BEFORE}time += 0.1;{AFTER}");
    let fixed = fix_text("a.frag", &broken, &options(), &NoFiles, Allow::Unsafe);
    assert!(
        fixed.text.contains("float timeCopy = time;"),
        "{}",
        fixed.text
    );
    assert_eq!(judge(&fixed.text), Vec::<String>::new());
}

#[test]
fn uses_of_a_variable_decide_whether_its_type_or_value_is_fixed() {
    statement(
        "int c = 1.5; x = c * 2.0; y = c;",
        "float c = 1.5; x = c * 2.0; y = c;",
    );
    statement("int c = 2.0; i = c + 1;", "int c = 2; i = c + 1;");
    let three = format!("{HEAD}{BEFORE}float c = 0; float d = max(c, 0); a = c;{AFTER}");
    assert_eq!(judge(&three).len(), 3);
}

#[test]
fn reserved_words_used_as_names_are_the_only_error() {
    for word in [
        "typedef",
        "enum",
        "class",
        "namespace",
        "template",
        "half",
        "goto",
        "using",
    ] {
        let code = format!("{HEAD}{BEFORE}float {word} = 1.0; x = {word};{AFTER}");
        let errors = judge(&code);
        assert_eq!(errors.len(), 1, "{word}: {errors:?}");
        assert!(errors[0].contains("reserved"), "{errors:?}");
    }
}
