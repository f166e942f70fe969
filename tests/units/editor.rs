//! Tests with a marker `|` in the text for the position.

use shaderlint::engine::Options;
use shaderlint::ide::*;
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;
use shaderlint::semantic::VariableId;
use shaderlint::text::{Span, apply_edits};
use std::sync::Arc;

/// The beginning of each test shader.
const HEAD: &str =
    "#version 300 es\nprecision highp float;\nout vec4 color;\nuniform float time;\n";

/// The document of a text without its marker, and the offset of the marker.
fn marked(text: &str) -> (Document, u32) {
    let text = format!("{HEAD}{text}");
    let at = text.find('|').expect("a mark");
    let plain = text.replacen('|', "", 1);
    let options = Arc::new(Options::default());
    let document = Document::new("/a.frag", plain.into(), options, &NoFiles);
    (document, at as u32)
}

/// Checks the text after renaming the symbol at the marker, without its head, or the refusal.
#[track_caller]
fn check_rename(text: &str, new: &str, expected: &str) {
    let (document, at) = marked(text);
    let got = match rename(&[&document], &document, at, new, &NoFiles) {
        Ok(renaming) => {
            let edits = &renaming.edits["/a.frag"];
            let text = apply_edits(&document.text, 0, edits).unwrap();
            text.strip_prefix(HEAD).unwrap_or(&text).to_string()
        }
        Err(refusal) => refusal.to_string(),
    };
    assert_eq!(got, expected, "{text}");
}

#[test]
fn renaming_changes_all_references() {
    check_rename(
        "float f(float x) { float |y = x; { float y = 2.0; y++; } return y; }\nvoid main() { color = vec4(f(1.0)); }\n",
        "z",
        "float f(float x) { float z = x; { float y = 2.0; y++; } return z; }\nvoid main() { color = vec4(f(1.0)); }\n",
    );
    check_rename(
        "float scale = 2.0;\n#define TWICE(x) (x * |scale)\nvoid main() { float scaled = TWICE(1.0); color = vec4(scaled + scale); }\n",
        "factor",
        "float factor = 2.0;\n#define TWICE(x) (x * factor)\nvoid main() { float scaled = TWICE(1.0); color = vec4(scaled + factor); }\n",
    );
    check_rename(
        "#define |HIGH 1\n#if HIGH\nvoid main() { color = vec4(1); }\n#elif defined(HIGH)\n#endif\n",
        "BEST",
        "#define BEST 1\n#if BEST\nvoid main() { color = vec4(1); }\n#elif defined(BEST)\n#endif\n",
    );
    check_rename(
        "#define M(|a, b) (a + b)\nvoid main() { float a = 1.0; color = vec4(M(a, 2.0)); }\n",
        "first",
        "#define M(first, b) (first + b)\nvoid main() { float a = 1.0; color = vec4(M(a, 2.0)); }\n",
    );
    check_rename(
        "struct S { float |a; vec2 b; };\nvoid main() { S s = S(1.0, vec2(2)); s.a += s.b.x; color = vec4(s.a); }\n",
        "size",
        "struct S { float size; vec2 b; };\nvoid main() { S s = S(1.0, vec2(2)); s.size += s.b.x; color = vec4(s.size); }\n",
    );
    // Inactive code may be active with other defines.
    check_rename(
        "float |wave() { return 1.0; }\nvoid main() {\n#ifdef SLOW\n    color = vec4(wave());\n#else\n    color = vec4(wave() + 1.0);\n#endif\n}\n",
        "ripple",
        "float ripple() { return 1.0; }\nvoid main() {\n#ifdef SLOW\n    color = vec4(ripple());\n#else\n    color = vec4(ripple() + 1.0);\n#endif\n}\n",
    );
}

#[test]
fn renamings_that_change_the_meaning_are_refused() {
    check_rename(
        "float |k = 2.0;\nvoid main() { float n = 1.0; color = vec4(n * k); }\n",
        "n",
        "`n` would refer to another declaration in line 6 of `a.frag`",
    );
    check_rename(
        "float n = 1.0;\nvoid main() { float |k = 2.0; color = vec4(n * k); }\n",
        "n",
        "`n` would refer to another declaration in line 6 of `a.frag`",
    );
    check_rename(
        "void main() { float |a = 1.0; float b = 2.0; color = vec4(a * b); }\n",
        "b",
        "renaming to `b` causes an error: `b` is already declared in this scope",
    );
    check_rename(
        "void |main() { color = vec4(1); }\n",
        "run",
        "the host calls `main` by name",
    );
    check_rename(
        "void main() { color = vec4(|sin(1.0)); }\n",
        "s",
        "`sin` is built in and cannot be renamed",
    );
    check_rename(
        "void main() { float |a = time; color = vec4(a); }\n",
        "in",
        "`in` is a keyword or reserved word",
    );
    check_rename(
        "void main() { float |a = time; color = vec4(a); }\n",
        "2d",
        "`2d` is not a valid identifier",
    );
}

/// The labels of completions at the marker that start with `start`.
fn proposed(text: &str, start: &str) -> Vec<String> {
    let (document, at) = marked(text);
    let (_, found) = complete(&document, at, &NoFiles);
    let labels = found.into_iter().map(|p| p.label);
    labels.filter(|l| l.starts_with(start)).collect()
}

#[test]
fn completions_depend_on_the_position() {
    let scopes =
        "void main() { float before = 1.0; { float inner = 2.0; } |\n float behind = 3.0; }\n";
    assert_eq!(proposed(scopes, "before"), ["before"]);
    assert_eq!(proposed(scopes, "inner"), Vec::<String>::new());
    assert_eq!(proposed(scopes, "behind"), Vec::<String>::new());
    assert_eq!(proposed(scopes, "smooth"), ["smoothstep"]);
    let fields =
        "struct Ray { vec3 from; vec3 to; };\nvoid main() { Ray ray; ray.|\n color = vec4(1); }\n";
    assert_eq!(proposed(fields, ""), ["from", "to"]);
    let lanes = "void main() { vec2 p = vec2(time); color = vec4(p.|); }\n";
    assert!(proposed(lanes, "x").contains(&"xy".to_string()));
    assert_eq!(proposed(lanes, "z"), Vec::<String>::new());
    assert_eq!(
        proposed("#de|\nvoid main() { color = vec4(1); }\n", "de"),
        ["define"]
    );
    assert_eq!(
        proposed("#|\nvoid main() { color = vec4(1); }\n", "de"),
        ["define"]
    );
    let allow = "void main() { color = vec4(1); } // shaderlint: allow(unused-|)\n";
    assert!(proposed(allow, "unused-").contains(&"unused-variable".to_string()));
    assert_eq!(
        proposed("// not | here\nvoid main() {}\n", ""),
        Vec::<String>::new()
    );
}

/// The first completion at the marker that starts with the word before it.
fn first(text: &str) -> String {
    let before = text.split('|').next().unwrap_or("");
    let rest = before.trim_end_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
    let all = proposed(text, &before[rest.len()..]);
    all.into_iter().next().unwrap_or_default()
}

#[test]
fn the_most_likely_completion_is_first() {
    // In general.
    assert_eq!(first("void main() { float a = ma|; }\n"), "max");
    assert_eq!(first("void main() { re| }\n"), "return");
    assert_eq!(first("fl|\nvoid main() {}\n"), "float");
    // By type.
    let two = "void main() { vec3 half3 = vec3(1); vec2 half2 = vec2(1); ";
    assert_eq!(first(&format!("{two} vec3 a = ha|; }}")), "half3");
    assert_eq!(first(&format!("{two} vec2 a = 2.0 * ha|; }}")), "half2");
    assert_eq!(
        first(&format!("{two} color = vec4(cross(half3, ha|), 1); }}")),
        "half3"
    );
    assert_eq!(
        first(&format!("{two} color = vec4(half2, ha|); }}")),
        "half2"
    );
    assert_eq!(first(&format!("{two} float z = ha|.z; }}")), "half3");
    let calls = "float wave(float x) { return x; }\nfloat wave2(vec2 x) { return x.x; }\n\
        void main() { vec2 p = vec2(time); color = vec4(wave(1.0) + wave(2.0)); float a = ";
    assert_eq!(first(&format!("{calls} wa|(p); }}")), "wave2");
    assert_eq!(first(&format!("{calls} wa|(time); }}")), "wave");
    // By use in this text.
    let used = "void main() { float wave1 = 1.0, wave2 = 2.0; float a = wave2 * wave2;\n";
    assert_eq!(first(&format!("{used} a += sin(wave1) + wa|; }}")), "wave2");
    // What is assigned.
    let written = "void f(out vec2 part, const vec2 params) { pa|.x = params.x * params.y; }\nvoid main() {}\n";
    assert_eq!(first(written), "part");
    // Braces need not be balanced.
    assert_eq!(first("} void main() { float wave = 1.0; wa| }\n"), "wave");
    // A name has no value in its own initializer.
    assert_eq!(
        proposed("void main() { float wave = wa|; }\n", "wave"),
        Vec::<String>::new()
    );
}

#[test]
fn completing_a_call_keeps_existing_arguments() {
    let snippet = |text: &str| {
        let (document, at) = marked(text);
        let (_, found) = complete(&document, at, &NoFiles);
        found
            .into_iter()
            .find(|p| p.label == "mix")
            .unwrap()
            .snippet
    };
    assert_eq!(
        snippet("void main() { float a = mi|(1.0, 2.0, 3.0); }\n"),
        None
    );
    let all = Some("mix(${1:x}, ${2:y}, ${3:a})".to_string());
    assert_eq!(snippet("void main() { float a = mi|;\n(a); }\n"), all);
}

#[test]
fn directives_have_their_own_completions() {
    let rest = "\nvoid main() { color = vec4(1); }\n";
    let of = |text: &str| proposed(&format!("{text}{rest}"), "");
    assert_eq!(of("#version |"), ["300 es", "100"]);
    assert_eq!(of("#version 300 e|"), ["300 es", "100"]);
    assert!(of("#extension |").contains(&"GL_OES_sample_variables".to_string()));
    assert_eq!(
        of("#extension GL_OES_EGL_image_external_essl3 : |"),
        ["enable", "require", "warn", "disable"]
    );
    assert_eq!(of("precision |"), ["highp", "mediump", "lowp"]);
    assert_eq!(of("precision lowp |")[..2], ["int", "float"]);
    assert_eq!(of("#line |"), Vec::<String>::new());
    let tests = of("#define FAST 1\n#if FA|");
    assert!(tests.contains(&"FAST".to_string()) && tests.contains(&"defined".to_string()));
    assert!(!tests.contains(&"time".to_string()), "{tests:?}");
    assert!(!of("#define FAST 1\n#ifdef FA|").contains(&"defined".to_string()));
}

#[test]
fn inactive_code_has_completions() {
    let text = "#ifdef FAST\nfloat noise(vec2 p) { return p.x; }\n#else\nfloat noise(vec3 p) { return p.x; }\n#endif\n\
        void main() {\n#ifdef FAST\n    float wave = 1.0;\n    #if 0\n    color = vec4(wa|);\n    #endif\n\
        #else\n    float water = 1.0;\n#endif\n}\n";
    assert_eq!(first(text), "wave");
    assert!(!proposed(text, "wa").contains(&"water".to_string()));
    let field = "struct S { float size; };\nvoid main() {\n#ifdef FAST\n    S s; color = vec4(s.|);\n#endif\n}\n";
    assert_eq!(proposed(field, ""), ["size"]);
}

#[test]
fn names_of_the_host_are_completed() {
    let text = "// Author: A\nuniform float size; // = 0.1\n\
        vec4 both(vec2 uv) { return mix(getFromColor(uv), getToColor(uv), progress * ra|); }\n";
    // The host is the one with this entry function.
    let asked = |text: &str, host: Option<&str>| {
        let at = text.find('|').unwrap();
        let mut options = Options::default();
        let is_of = |p: &&shaderlint_host::Preset| p.entries.iter().any(|e| Some(&**e) == host);
        options.host.preset = shaderlint_host::presets().find(is_of);
        let plain = text.replacen('|', "", 1);
        let document = Document::new("/a.glsl", plain.into(), Arc::new(options), &NoFiles);
        complete(&document, at as u32, &NoFiles).1
    };
    let found = asked(
        &format!("{text}vec4 transition(vec2 uv) {{ return both(uv); }}\n"),
        None,
    );
    let ratio = found.iter().find(|p| p.label == "ratio");
    assert_eq!(ratio.expect("a name of the host").detail, "float");
    assert!(!found.iter().any(|p| p.label == "_fromR"));
    let found = asked(
        &format!("{}|", text.replace("ra|", "1.0")),
        Some("transition"),
    );
    let entry = found.iter().find(|p| p.label == "transition");
    let body = "vec4 transition(vec2 uv) {\n\t$0\n}";
    assert_eq!(
        entry.expect("its entry function").snippet.as_deref(),
        Some(body)
    );
    let found = asked(
        &format!("{text}vec4 transition(vec2 uv) {{ return both(uv); }}\n|")
            .replacen("ra|", "1.0", 1),
        Some("transition"),
    );
    assert!(
        !found
            .iter()
            .any(|p| p.label == "transition" || p.label == "ratio")
    );
}

/// The hover at the marker.
fn hovered(text: &str) -> String {
    let (document, at) = marked(text);
    hover(&document, at, None, &NoFiles).map_or(String::new(), |h| h.text)
}

#[test]
fn inactive_code_has_hovers_and_signatures() {
    let text = "#ifdef HIGH\nfloat f(vec2 at, float k) { return |at.x * k; }\n\
        #elif defined(LOW)\nfloat f(float at) { return at; }\n#endif\n\
        void main() { color = vec4(1); }\n";
    assert!(hovered(text).contains("vec2 at"));
    let text = text.replace('|', "").replace("return at;", "return |at;");
    assert!(hovered(&text).contains("float at"));
    let (document, at) = marked(
        "#ifdef HIGH\nfloat f(vec2 at, float k) { return at.x * k; }\n\
        float g() { return f(vec2(1), |2.0); }\n#endif\nvoid main() { color = vec4(1); }\n",
    );
    let help = signature_help(&document, at, &NoFiles).unwrap();
    assert_eq!(help.signatures[0].label, "float f(vec2 at, float k)");
    assert_eq!(help.argument, 1);
}

#[test]
fn hovers_show_documentation_and_ranges() {
    let text = hovered("void main() { float a = |fract(time); color = vec4(a); }\n");
    assert!(
        text.contains("float fract(float x)") && text.contains("at least 0 and less than 1"),
        "{text}"
    );
    let text = hovered("void main() { float a = fract(time); color = vec4(|a); }\n");
    assert!(
        text.contains("float a") && text.contains("here: "),
        "{text}"
    );
    let text = hovered(
        "// How far.\nconst float |FAR = 2.0 * 10.0;\nvoid main() { color = vec4(FAR); }\n",
    );
    assert!(
        text.contains("constant: `20.0`") && text.contains("How far."),
        "{text}"
    );
    let text = hovered(
        "void main() { float s = 0.0; |for (int i = 0; i < 7; i++) s += 1.0; color = vec4(s); }\n",
    );
    assert!(text.contains("7 iterations"), "{text}");
}

#[test]
fn hovers_describe_names_of_user_defined_hosts() {
    let own = shaderlint_host::read("uniform float beat; // = time\n").unwrap();
    let mut options = Options::default();
    options.host.describe(Some(own));
    let text = "void main() { gl_FragColor = vec4(beat); }\n";
    let document = Document::new("/a.glsl", text.into(), Arc::new(options), &NoFiles);
    let at = text.find("beat").unwrap() as u32;
    let description = hover(&document, at, None, &NoFiles).unwrap().text;
    assert!(
        description.contains(shaderlint_host::Feed::Time.description()),
        "{description}"
    );
}

#[test]
fn analyses_of_unchanged_documents_are_reused() {
    let text = format!(
        "{HEAD}float f(float x) {{ return fract(x); }}\n\
         void main() {{ float s = 0.0; for (int i = 0; i < 7; i++) s += f(time); color = vec4(s); }}\n"
    );
    let options = Options {
        settings: Arc::new(Settings::of_rules(&[])),
        ..Options::default()
    };
    let document = Document::new("/a.frag", text.into(), Arc::new(options), &NoFiles);
    let at = |word: &str| document.text.find(word).expect(word) as u32;
    let all = Span::new(0, document.text.len() as u32);
    let iterations = HintOptions {
        parameters: false,
        iterations: true,
        types: false,
    };
    let ask = |question: usize| {
        match question {
            0 => assert!(hover(&document, at("x); }"), None, &NoFiles).is_some()),
            1 => assert!(!lenses(&document, &[]).is_empty()),
            2 => assert!(!hints(&document, all, iterations, &[]).is_empty()),
            3 => assert!(call_item(&document, at("f(float")).is_some()),
            4 => assert!(!outgoing(&document, at("main")).is_empty()),
            _ => assert!(!incoming(&[&document], &document, at("f(float")).is_empty()),
        }
        document.report.analyses[0].facts().answers()
    };
    // Without rules nothing is computed. Each analysis is computed once on demand.
    assert_eq!(document.report.analyses[0].facts().answers(), 0);
    let once = ask(0);
    assert!(once > 0);
    let all: Vec<usize> = (1..6).map(ask).collect();
    assert!(all.is_sorted() && all.iter().all(|n| *n >= once), "{all:?}");
    let last = all.last().copied();
    assert!((0..6).map(ask).all(|n| Some(n) == last));
}

#[test]
fn selection_ranges_are_nested() {
    let (document, at) =
        marked("void main() { float a = (1.0 + |time) * 2.0; color = vec4(a); }\n");
    let around = selection(&document, at);
    let text = |i: usize| {
        let span = around[i];
        &document.text[span.start as usize..span.end as usize]
    };
    assert_eq!(
        [text(0), text(1), text(2)],
        ["time", "1.0 + time", "(1.0 + time)"]
    );
    assert_eq!(text(around.len() - 1), &*document.text);
}

#[test]
fn signature_help_marks_the_current_argument() {
    let (document, at) = marked(
        "float f(vec2 p, float k) { return p.x * k; }\nvoid main() { color = vec4(f(vec2(1, 2), |)); }\n",
    );
    let help = signature_help(&document, at, &NoFiles).unwrap();
    assert_eq!(
        (help.signatures[0].label.as_str(), help.argument),
        ("float f(vec2 p, float k)", 1)
    );
}

#[test]
fn numbers_are_previewed_in_grey_and_vectors_in_colour() {
    let (document, _) = marked(
        "void main() {\n|float x = gl_FragCoord.x / 64.0;\nvec3 rgb = vec3(x, 0.0, 0.5);\ncolor = vec4(rgb, x);\n}\n",
    );
    let analysis = &document.report.analyses[0];
    let program = &analysis.program;
    let all = Span::new(0, u32::MAX);
    let middle = |name: &str| {
        let name = program.names.get(name).unwrap();
        let found = program.variables.iter().position(|v| v.name == name);
        let image = image_of(analysis, VariableId(found.unwrap() as u32), all).unwrap();
        image.pixels[32]
    };
    let x = 32.5 / 64.0;
    assert_eq!(middle("x"), [x, x, x, 1.0]);
    assert_eq!(middle("rgb")[..3], [x, 0.0, 0.5]);
}

/// The estimated cost of a shader and the most that a pixel takes in a sample run.
fn costs(code: &str) -> (f64, f64) {
    let (document, _) = marked(&format!("void main() {{\n|{code}\n}}\n"));
    let analysis = &document.report.analyses[0];
    let (estimate, is_bound) = {
        let facts = analysis.facts();
        facts.work().of_shader(facts.entry().unwrap())
    };
    assert!(is_bound, "{code}");
    (
        estimate,
        f64::from(run(&document, analysis).unwrap().most_cost),
    )
}

#[test]
fn estimated_and_measured_costs_agree() {
    for code in [
        "color = vec4(sin(gl_FragCoord.x) * 2.0 + gl_FragCoord.y);",
        "float x = 0.0; for (int i = 0; i < 7; i++) { x += cos(gl_FragCoord.x); } color = vec4(x);",
        "float x = gl_FragCoord.x; color = vec4(x > -1.0 && x < 1e6 ? x * x : x);",
    ] {
        let (estimate, most) = costs(code);
        assert!(most <= estimate, "{code}: {most} of {estimate}");
        // All code runs except one side of `?:`.
        assert!(estimate - most <= 1.0, "{code}: {most} of {estimate}");
    }
}

/// The tokens of a script, with their kinds.
fn script_tokens(text: &str) -> Vec<(String, SemanticKind)> {
    let options = Arc::new(Options::default());
    let document = Document::new("/a.js", text.into(), options, &NoFiles);
    let all = semantic_tokens(&document).into_iter();
    let shown = |span: Span| document.text[span.start as usize..span.end as usize].to_string();
    all.map(|token| (shown(token.span), token.kind)).collect()
}

#[test]
fn strings_without_a_grammar_get_all_semantic_tokens() {
    let code = "precision highp float;\n// Sums\nuniform float time;\n#define A 2.0\n\
        void main() { gl_FragColor = vec4(time * A + ${more}); }\n";
    let found = script_tokens(&format!("const shader = `{code}`;\n"));
    let kind = |word: &str| {
        let mut all = found.iter().filter(|(text, _)| text == word);
        all.next().map(|(_, kind)| *kind)
    };
    for (word, expected) in [
        ("precision", SemanticKind::Plain(PlainClass::Keyword)),
        ("float", SemanticKind::Plain(PlainClass::Type)),
        ("// Sums", SemanticKind::Plain(PlainClass::Comment)),
        ("#", SemanticKind::Plain(PlainClass::Keyword)),
        ("define", SemanticKind::Plain(PlainClass::Keyword)),
        ("2.0", SemanticKind::Plain(PlainClass::Number)),
        ("*", SemanticKind::Plain(PlainClass::Operator)),
        ("vec4", SemanticKind::Plain(PlainClass::Type)),
        ("time", SemanticKind::Symbol(TokenClass::Variable)),
        ("A", SemanticKind::Symbol(TokenClass::Macro)),
    ] {
        assert_eq!(kind(word), Some(expected), "{word}: {found:?}");
    }
    assert!(
        found
            .iter()
            .all(|(text, _)| !text.contains("more") && text != "const")
    );
    for tag in ["glsl", "/* glsl */ "] {
        let found = script_tokens(&format!("const shader = {tag}`{code}`;\n"));
        let is_plain = |(_, kind): &(String, SemanticKind)| matches!(kind, SemanticKind::Plain(_));
        assert!(
            !found.is_empty() && !found.iter().any(is_plain),
            "{found:?}"
        );
    }
}

/// The cost of each line of a text after its head, without and with a sample run.
#[track_caller]
fn line_costs(text: &str) -> [Vec<(u32, f64)>; 2] {
    let (document, _) = marked(&format!("{text}|"));
    let analysis = &document.report.analyses[0];
    let seen = run(&document, analysis).expect("a run");
    let costs = [None, Some(&seen)].map(|seen| shader_cost(&document, 0, seen).unwrap());
    for cost in &costs {
        let sum: f64 = cost.lines.values().sum();
        assert!((sum - cost.operations).abs() < 1e-6, "{cost:?}");
    }
    costs.map(|cost| {
        let head = HEAD.matches('\n').count() as u32;
        let lines = cost.lines.into_iter();
        lines
            .map(|(line, operations)| (line - head, operations))
            .collect()
    })
}

#[test]
fn costs_are_attributed_to_lines() {
    let [estimated, observed] = line_costs(
        "#define TWICE(x) ((x) * 2.0 + 1.0)
float f(float x) {
    return x * x;
}
void main() {
    float s = TWICE(time);
    for (int i = 0; i < 10; i++) {
        s += f(s)
            * 3.0;
    }
    if (gl_FragCoord.x < 32.0) s = -s;
    color = vec4(s);
}
",
    );
    // The condition of the loop is evaluated 11 times.
    let of_loop = [(3, 10.0), (6, 2.0), (7, 21.0), (8, 20.0)];
    assert_eq!(estimated, [&of_loop[..], &[(11, 2.0)]].concat());
    // Half of the pixels change the sign.
    assert_eq!(observed, [&of_loop[..], &[(11, 1.5)]].concat());
}
