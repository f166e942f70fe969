//! Properties that hold for every text, checked with thousands of random ones.
//!
//! The texts are the same in every run; `SHADERLINT_SEED` sets another seed and `SHADERLINT_ROUNDS`
//! multiplies their number.

use proptest::prelude::*;
use proptest::test_runner::{FileFailurePersistence, RngSeed};
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, Options, Report, Unread, check, fix_text};
use shaderlint::lint::{Allow, Settings};
use shaderlint::port::json;
use shaderlint::project::NoFiles;
use shaderlint::project::Project;
use shaderlint::rules::RULES;
use shaderlint::syntax::tokenize;
use shaderlint::text::{Role, Sources};

/// Snippets of shaders; random combinations produce half-valid code, where most can go wrong.
const PIECES: &[&str] = &[
    "float ",
    "int ",
    "vec3 ",
    "mat2 ",
    "const ",
    "uniform ",
    "in ",
    "out ",
    "struct S { float a; }; ",
    "void mainImage(out vec4 o, in vec2 p) {\n",
    "float f(float x) {\n",
    "return ",
    "if (",
    "else ",
    "for (int i = 0; i < 4; i++) ",
    "while (",
    "switch (",
    "case 1: ",
    "default: ",
    "break; ",
    "x ",
    "y ",
    "o ",
    "o.xy ",
    ".zw ",
    "f(",
    "g(",
    "vec4(",
    "iTime ",
    "iChannel0 ",
    "1 ",
    "2.0 ",
    "3u ",
    "08 ",
    "1f ",
    "+ ",
    "- ",
    "* ",
    "== ",
    "= ",
    "+= ",
    "< ",
    "&& ",
    "? ",
    ": ",
    ", ",
    "; ",
    ";\n",
    "( ",
    ") ",
    "{ ",
    "} ",
    "[",
    "] ",
    "}\n",
    "\n",
    "\\\n",
    "// note\n",
    "/* note */ ",
    "/* ",
    "#define F(a) a + a\n",
    "#define G\n",
    "F(",
    "G ",
    "#if 1\n",
    "#ifdef G\n",
    "#else\n",
    "#endif\n",
    "#line 7\n",
    "é",
    "→",
    "\u{feff}",
    "x = 1;\n",
    "float z = x;\n",
    "x += f(x);\n",
    "o = vec4(x, y, 0.0, 1.0);\n",
];

fn texts() -> impl Strategy<Value = String> {
    let pieces = prop::collection::vec(prop::sample::select(PIECES), 0..80);
    pieces.prop_map(|all| all.concat())
}

/// `None` if the text is clearly not a shader.
fn judge(text: &str) -> Option<Report> {
    let settings = Settings::new(RULES, &["all".to_string()], &[]).unwrap();
    let options = Options::new(DialectChoice::Auto, settings);
    let report = check("a.glsl", text, &options, &NoFiles);
    match report.unread {
        None => Some(report),
        Some(Unread::Skipped(_) | Unread::NotGlsl) => None,
        Some(_) => panic!("not recognised as a shader"),
    }
}

/// Rule and message of each finding, in order.
fn summary(found: &Option<Report>) -> Vec<(&'static str, String)> {
    let all = found.iter().flat_map(|f| &f.diagnostics);
    all.map(|d| (d.rule, d.message.clone())).collect()
}

fn count_errors(found: &Option<Report>) -> usize {
    let all = found.iter().flat_map(|f| &f.diagnostics);
    all.filter(|d| d.severity == Severity::Error).count()
}

/// An export with one item of every kind, in which snippets replace others.
const EXPORT: &str = r#"[{"ver":"0.1","info":{"id":"abcdef","name":"n","username":"u","tags":["t"]},
"renderpass":[{"inputs":[{"id":"4dXGR8","filepath":"/media/a.png","type":"buffer","channel":0,
"sampler":{"filter":"linear","wrap":"clamp","vflip":"true"}},{"id":257,"ctype":"texture","src":"/b.png","channel":"1"}],
"outputs":[{"id":"4dfGRr","channel":0}],"code":"void mainImage(out vec4 c, in vec2 p) {\\n c = vec4(0);\\n}","name":"Image","type":"image"},
{"inputs":[],"outputs":[{"id":257}],"code":"","name":"Buf A","type":"buffer"}]}]"#;

const JSON_PIECES: &[&str] = &[
    "null",
    "0",
    "-1",
    "1e999",
    "\"\"",
    "[]",
    "{}",
    "[null]",
    "true",
    "\"4dXGR8\"",
    "\\ud800",
    "\\udc00\\ud800",
    "\\",
    "\"",
    ",",
    ":",
    "{",
    "}",
    "[",
    "]",
    "é",
    "\u{feff}",
    "\"sound\"",
    "\"cubemap\"",
    "\"../x\"",
    "\"data:,\"",
    "[[[[[[[[[[",
    "99999999999999999999",
];

/// The last character boundary at or before an offset.
fn boundary(text: &str, at: usize) -> usize {
    let mut places = (0..=at.min(text.len())).rev();
    places.find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

/// The export with values or arbitrary ranges replaced.
fn exports() -> impl Strategy<Value = String> {
    let change = (
        0..EXPORT.len(),
        0..12_usize,
        prop::sample::select(JSON_PIECES),
    );
    prop::collection::vec((change, any::<bool>()), 0..4).prop_map(|changes| {
        let mut text = EXPORT.to_string();
        for ((at, length, piece), is_value) in changes {
            let mut starts = text.match_indices(':').map(|(i, _)| i + 1);
            let at = match is_value {
                true => starts.find(|i| *i >= at).unwrap_or(0),
                false => at.min(text.len()),
            };
            let rest = &text[boundary(&text, at)..];
            let value = rest.find([',', '}', ']']).unwrap_or(0);
            let end = at + if is_value { value } else { length };
            let (from, to) = (boundary(&text, at), boundary(&text, end));
            text.replace_range(from..to.max(from), piece);
        }
        text
    })
}

/// The configuration of a property with `cases` texts a round. Prints the seed, which is shown if it fails.
fn config(cases: u32) -> ProptestConfig {
    let seed = std::env::var("SHADERLINT_SEED").map_or(1, |seed| seed.parse().unwrap());
    println!("SHADERLINT_SEED={seed}");
    let rounds = std::env::var("SHADERLINT_ROUNDS").map_or(1, |rounds| rounds.parse().unwrap());
    let failures = FileFailurePersistence::Direct("tests/properties.txt");
    ProptestConfig {
        cases: cases * rounds,
        failure_persistence: Some(Box::new(failures)),
        rng_seed: RngSeed::Fixed(seed),
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(config(250))]

    #[test]
    fn tokens_concatenate_to_the_text(text in prop_oneof![texts(), any::<String>()]) {
        let mut at = 0;
        for token in tokenize(&text, 0) {
            prop_assert_eq!(token.span.start, at);
            prop_assert!(token.span.end > at);
            prop_assert!(text.is_char_boundary(token.span.end as usize));
            at = token.span.end;
        }
        prop_assert_eq!(at as usize, text.len());
    }

    #[test]
    fn positions_increase_with_offsets(text in any::<String>()) {
        let mut sources = Sources::new();
        let id = sources.add("a", None, Role::User, text.as_str()).unwrap();
        let file = sources.file(id).unwrap();
        let mut last = file.position(0);
        for address in 1..=text.len() as u32 {
            let next = file.position(address);
            prop_assert!((last.line, last.column, last.utf16) <= (next.line, next.column, next.utf16));
            last = next;
        }
    }

    #[test]
    fn kinds_of_line_breaks_do_not_affect_findings(text in texts()) {
        let (unix, windows) = (judge(&text), judge(&text.replace('\n', "\r\n")));
        prop_assert_eq!(summary(&unix), summary(&windows));
    }

    #[test]
    fn findings_are_inside_the_user_text(text in prop_oneof![texts(), any::<String>()]) {
        let Some(found) = judge(&text) else {
            return Ok(());
        };
        for d in &found.diagnostics {
            prop_assert!(!d.message.contains('\n'), "{}", d.message);
            let labels = d.labels.iter().map(|l| l.span);
            let edits = d.fix.iter().flat_map(|f| f.edits.iter().map(|e| e.span));
            for span in std::iter::once(d.span).chain(labels).chain(edits) {
                let file = found.sources.file_at(span.start).unwrap();
                prop_assert_eq!(file.role, Role::User, "{}", d.message);
                prop_assert!(file.span().contains(span), "{}", d.message);
                let (start, end) = (span.start - file.base, span.end - file.base);
                prop_assert!(file.text.get(start as usize..end as usize).is_some(), "{}", d.message);
            }
        }
    }

    /// Any export is read or rejected; what was read can be written and read again.
    #[test]
    fn exports_are_read_or_rejected(text in exports()) {
        if let Ok(project) = Project::from_json(&text) {
            let written = json(&project);
            let again = Project::from_json(&written);
            prop_assert_eq!(again.map(|p| json(&p)), Ok(written));
        }
    }
}

proptest! {
    // Each text is checked five times.
    #![proptest_config(config(50))]

    /// Valid code stays valid, and repeating `--fix` changes nothing more.
    #[test]
    fn fixes_add_no_errors_and_terminate(text in texts()) {
        prop_assert_eq!(trouble_of_fixes(&text), None);
    }
}

/// What is wrong with the fixes of a text, if anything.
fn trouble_of_fixes(text: &str) -> Option<String> {
    let options = Options::default();
    let before = count_errors(&judge(text));
    let fixed = |text: &str, allow| fix_text("a.glsl", text, &options, &NoFiles, allow).text;
    for allow in [Allow::Safe, Allow::Unsafe] {
        let after = count_errors(&judge(&fixed(text, allow)));
        if before == 0 && after > 0 {
            return Some(format!("the fixes added {after} errors"));
        }
    }
    let once = fixed(text, Allow::Unsafe);
    let twice = fixed(&once, Allow::Unsafe);
    (once != twice).then(|| format!("{once}\n-- a second run changes it to --\n{twice}"))
}

/// Unreadable code consumed the `;` of its line, and each one that a fix inserted after it.
#[test]
fn fixes_terminate_after_unreadable_code() {
    assert_eq!(trouble_of_fixes("{;}x};#[(i 0;<4;i+)+}f();w;"), None);
}
