//! Every machine-readable format, read by a parser. The required content of each format is written
//! down here from its specification.

use crate::scratch::{BROKEN, CLEAN, Scratch, WARNED};
use serde_json::Value;
use std::collections::BTreeSet;

/// An export whose pass has an error in its second line.
fn export() -> String {
    let code = "// é\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1); c += 1; float x = 1; }";
    let pass = serde_json::json!({"type": "image", "name": "Image", "code": code, "inputs": [], "outputs": []});
    serde_json::json!({"info": {"name": "x"}, "renderpass": [pass]}).to_string()
}

/// A file of each kind.
fn scratch() -> Scratch {
    Scratch::new(&[
        ("a b/größe,1.glsl", BROKEN),
        ("clean.glsl", CLEAN),
        ("export.json", &export()),
        ("warned.glsl", WARNED),
    ])
}

fn json(scratch: &Scratch, format: &str, args: &[&str]) -> Value {
    let ran = scratch.run(&[&["--info", "--format", format], args].concat());
    assert_eq!(ran.err, "");
    serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}: {}", ran.out))
}

fn list<'a>(value: &'a Value, path: &str) -> &'a Vec<Value> {
    let found = value.pointer(path).and_then(Value::as_array);
    found.unwrap_or_else(|| panic!("no array at {path} in {value}"))
}

fn text<'a>(value: &'a Value, path: &str) -> &'a str {
    let found = value.pointer(path).and_then(Value::as_str);
    found.unwrap_or_else(|| panic!("no string at {path} in {value}"))
}

fn number(value: &Value, path: &str) -> u64 {
    let found = value.pointer(path).and_then(Value::as_u64);
    found.unwrap_or_else(|| panic!("no number at {path} in {value}"))
}

/// The text that a SARIF region covers, found by its lines and columns and again by its byte
/// offsets.
fn covered<'a>(file: &'a str, region: &Value) -> &'a str {
    let offset = |line: &str, column: &str| {
        let (line, column) = (
            number(region, line) as usize,
            number(region, column) as usize,
        );
        let start: usize = file
            .split_inclusive('\n')
            .take(line - 1)
            .map(str::len)
            .sum();
        let chars = file[start..].char_indices();
        start + chars.map(|(i, _)| i).nth(column - 1).unwrap()
    };
    let (start, end) = (
        offset("/startLine", "/startColumn"),
        offset("/endLine", "/endColumn"),
    );
    assert_eq!(number(region, "/byteOffset") as usize, start);
    assert_eq!(number(region, "/byteLength") as usize, end - start);
    &file[start..end]
}

#[test]
fn sarif_has_the_required_properties() {
    let log = json(&scratch(), "sarif", &["."]);
    assert_eq!(text(&log, "/version"), "2.1.0");
    assert!(text(&log, "/$schema").ends_with("sarif-2.1.0.json"));
    assert_eq!(list(&log, "/runs").len(), 1);
    assert_eq!(text(&log, "/runs/0/columnKind"), "unicodeCodePoints");
    assert_eq!(text(&log, "/runs/0/tool/driver/name"), "shaderlint");
    let rules = list(&log, "/runs/0/tool/driver/rules");
    let ids: BTreeSet<&str> = rules.iter().map(|r| text(r, "/id")).collect();
    assert_eq!(ids.len(), rules.len(), "ids are unique");
    for rule in rules {
        assert!(text(rule, "/shortDescription/text").ends_with('.'));
        assert!(text(rule, "/help/markdown").contains("```glsl"));
        assert!(!text(rule, "/help/text").is_empty());
    }
    let results = list(&log, "/runs/0/results");
    let mut levels = BTreeSet::new();
    for result in results {
        assert!(ids.contains(text(result, "/ruleId")));
        levels.insert(text(result, "/level"));
        assert!(!text(result, "/message/text").is_empty());
        assert!(!text(result, "/partialFingerprints/shaderlint~1v1").is_empty());
        let places = list(result, "/locations").iter();
        let related = result.get("relatedLocations").and_then(Value::as_array);
        for place in places.chain(related.into_iter().flatten()) {
            let uri = text(place, "/physicalLocation/artifactLocation/uri");
            assert!(uri.is_ascii() && !uri.contains([' ', '\\', ':']), "{uri}");
        }
    }
    assert_eq!(levels, BTreeSet::from(["error", "note", "warning"]));
}

#[test]
fn sarif_points_at_the_code() {
    let scratch = scratch();
    let log = json(&scratch, "sarif", &["a b"]);
    let results = list(&log, "/runs/0/results");
    let place = "/locations/0/physicalLocation";
    let uri = text(&results[0], &format!("{place}/artifactLocation/uri"));
    assert_eq!(uri, "a%20b/gr%C3%B6%C3%9Fe%2C1.glsl");
    let region = |r: &Value| r.pointer(&format!("{place}/region")).cloned().unwrap();
    let covered_by: Vec<&str> = results
        .iter()
        .map(|r| covered(BROKEN, &region(r)))
        .collect();
    assert_eq!(covered_by, ["2", "1"]);
    let change = "/fixes/0/artifactChanges/0";
    assert_eq!(
        text(&results[1], &format!("{change}/artifactLocation/uri")),
        uri
    );
    let edit = results[1]
        .pointer(&format!("{change}/replacements/0"))
        .unwrap();
    assert_eq!(covered(BROKEN, &edit["deletedRegion"]), "1");
    assert_eq!(text(edit, "/insertedContent/text"), "1.0");
}

#[test]
fn positions_in_exports_are_described_in_words() {
    let log = json(&scratch(), "sarif", &["export.json"]);
    let result = &list(&log, "/runs/0/results")[0];
    assert_eq!(
        text(result, "/locations/0/logicalLocations/0/name"),
        "Image"
    );
    assert!(
        result
            .pointer("/locations/0/physicalLocation/region")
            .is_none()
    );
    assert!(
        text(result, "/message/text").contains("(Image, line 2, column "),
        "{result}"
    );
    assert!(
        result.get("fixes").is_none(),
        "its positions are not those of the file"
    );
}

#[test]
fn absolute_paths_become_relative() {
    let scratch = scratch();
    let path = scratch.path("warned.glsl");
    let path = path.to_str().unwrap();
    let log = json(&scratch, "sarif", &[path]);
    let uri = "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri";
    assert_eq!(text(&log, uri), "warned.glsl");
    let issues = json(&scratch, "gitlab", &[path]);
    assert_eq!(text(&issues, "/0/location/path"), "warned.glsl");
    let github = scratch.run(&["--format", "github", path]);
    assert!(
        github.out.starts_with("::warning file=warned.glsl,"),
        "{}",
        github.out
    );
    let outside = scratch.run_in("a b", &["--format", "sarif", path]);
    let log: Value = serde_json::from_str(&outside.out).unwrap();
    assert!(text(&log, uri).starts_with("file:///"));
}

#[test]
fn fingerprints_survive_unrelated_changes() {
    let prints = |text_of_file: &str, path: &str, format: &str| -> Vec<String> {
        let scratch = Scratch::new(&[("a.glsl", text_of_file)]);
        let log = json(&scratch, format, &["a.glsl"]);
        let found = log.pointer(path).and_then(Value::as_array).unwrap();
        let print = |r: &Value| {
            let sarif = r.pointer("/partialFingerprints/shaderlint~1v1");
            sarif
                .or(r.get("fingerprint"))
                .unwrap()
                .as_str()
                .unwrap()
                .to_string()
        };
        found.iter().map(print).collect()
    };
    let moved = format!("// one\n// two\n{}", WARNED.replace("    float", "\tfloat"));
    let twice = WARNED.replace(
        "    float unused",
        "    wave += pow(iTime - 9.0, 2.0);\n    float unused",
    );
    for (path, format) in [("/runs/0/results", "sarif"), ("", "gitlab")] {
        let before = prints(WARNED, path, format);
        assert_eq!(before.len(), 2);
        assert_eq!(before, prints(&moved, path, format));
        let after = prints(&twice, path, format);
        let unique: BTreeSet<&String> = after.iter().collect();
        assert_eq!((after.len(), unique.len()), (3, 3));
        assert!(before.iter().all(|p| after.contains(p)));
    }
}

#[test]
fn identical_lines_have_different_fingerprints() {
    let line = "    fragColor += pow(iTime - 9.0, 2.0);\n";
    let code = format!(
        "void mainImage(out vec4 fragColor, in vec2 p) {{\n    fragColor = vec4(p, 0.0, 1.0);\n{line}{line}}}\n"
    );
    let scratch = Scratch::new(&[("a.glsl", &code), ("b.glsl", &code)]);
    let issues = json(&scratch, "gitlab", &["."]);
    let issues = issues.as_array().unwrap();
    let prints: BTreeSet<&str> = issues.iter().map(|i| text(i, "/fingerprint")).collect();
    assert_eq!(prints.len(), issues.len());
    assert!(issues.len() >= 4, "{issues:?}");
}

#[test]
fn gitlab_has_the_documented_keys() {
    let issues = json(&scratch(), "gitlab", &["."]);
    let mut severities = BTreeSet::new();
    for issue in issues.as_array().unwrap() {
        assert!(!text(issue, "/description").is_empty());
        assert!(!text(issue, "/check_name").is_empty());
        assert!(!text(issue, "/fingerprint").is_empty());
        severities.insert(text(issue, "/severity"));
        let path = text(issue, "/location/path");
        assert!(!path.starts_with(['/', '.']), "{path}");
        assert!(number(issue, "/location/lines/begin") >= 1);
    }
    assert_eq!(severities, BTreeSet::from(["critical", "info", "minor"]));
    let clean = json(&scratch(), "gitlab", &["clean.glsl"]);
    assert_eq!(clean, Value::Array(Vec::new()));
}

/// Parses a workflow command like GitHub's runner.
fn command(line: &str) -> (String, Vec<(String, String)>, String) {
    let (head, message) = line.strip_prefix("::").unwrap().split_once("::").unwrap();
    let (name, properties) = head.split_once(' ').unwrap();
    let unescape = |s: &str| {
        let s = s.replace("%3A", ":").replace("%2C", ",");
        s.replace("%0D", "\r")
            .replace("%0A", "\n")
            .replace("%25", "%")
    };
    let property = |p: &str| {
        let (key, value) = p.split_once('=').unwrap();
        (key.to_string(), unescape(value))
    };
    let properties = properties.split(',').map(property).collect();
    (name.to_string(), properties, unescape(message))
}

#[test]
fn github_commands_are_escaped() {
    let scratch = scratch();
    scratch.write("100%,a:b.glsl", BROKEN);
    let ran = scratch.run(&[
        "--info",
        "--format",
        "github",
        "100%,a:b.glsl",
        "export.json",
        "warned.glsl",
    ]);
    let commands: Vec<_> = ran.out.lines().map(command).collect();
    let (name, properties, message) = &commands[1];
    let get = |key: &str| {
        let found = properties.iter().find(|(k, _)| k == key);
        found.map(|(_, v)| v.as_str())
    };
    assert_eq!(name, "error");
    assert_eq!(get("file"), Some("100%,a:b.glsl"));
    assert_eq!(get("title"), Some("int-float-mix"));
    assert_eq!((get("line"), get("endLine")), (Some("5"), Some("5")));
    assert_eq!(
        (get("col"), get("endColumn")),
        (Some("25"), Some("26")),
        "UTF-16 units"
    );
    assert!(message.contains('\n'));
    let names: BTreeSet<&str> = commands.iter().map(|(n, ..)| n.as_str()).collect();
    assert_eq!(names, BTreeSet::from(["error", "notice", "warning"]));
}

#[test]
fn junit_is_xml_and_counts() {
    let ran = scratch().run(&["--format", "junit", "."]);
    let xml = roxmltree::Document::parse(&ran.out).unwrap();
    let suites = xml.root_element();
    assert_eq!(suites.tag_name().name(), "testsuites");
    let mut names = Vec::new();
    for suite in suites.children().filter(|n| n.is_element()) {
        assert_eq!(suite.tag_name().name(), "testsuite");
        names.push(suite.attribute("name").unwrap());
        let cases: Vec<_> = suite
            .children()
            .filter(|n| n.has_tag_name("testcase"))
            .collect();
        let failed = cases.iter().flat_map(|c| c.children());
        let failed = failed.filter(|n| n.has_tag_name("failure")).count();
        assert_eq!(suite.attribute("tests").unwrap(), cases.len().to_string());
        assert_eq!(suite.attribute("failures").unwrap(), failed.to_string());
        for case in cases {
            assert!(case.attribute("name").is_some() && case.attribute("classname").is_some());
        }
    }
    assert_eq!(
        names,
        [
            "a b/größe,1.glsl",
            "clean.glsl",
            "export.json",
            "warned.glsl"
        ]
    );
    let failure = xml
        .descendants()
        .find(|n| n.has_tag_name("failure"))
        .unwrap();
    assert_eq!(
        failure.attribute("message"),
        Some("cannot divide `float` by `int`")
    );
    assert!(
        failure
            .text()
            .unwrap()
            .contains("2 │ float halfOf(float x) { return x / 2; }")
    );
    let mut warned = xml
        .descendants()
        .filter(|n| n.attribute("name") == Some("warned.glsl"));
    assert_eq!(
        warned.next_back().unwrap().attribute("failures"),
        Some("1"),
        "an info is not a failure"
    );
}

#[test]
fn checkstyle_is_xml_with_positions() {
    let scratch = scratch();
    let hostile = "void mainImage(out vec4 c, in vec2 p) { c = \"<&>'\u{1}\u{ffff}\"; }";
    scratch.write("hostile.glsl", hostile);
    let ran = scratch.run(&["--info", "--format", "checkstyle", "."]);
    let xml = roxmltree::Document::parse(&ran.out).unwrap();
    assert_eq!(xml.root_element().tag_name().name(), "checkstyle");
    let files: Vec<_> = xml
        .root_element()
        .children()
        .filter(|n| n.is_element())
        .collect();
    assert_eq!(files.len(), 5);
    let places: Vec<_> = files[0].children().filter(|n| n.is_element()).collect();
    let attribute = |name| places[1].attribute(name).unwrap();
    assert_eq!(
        (attribute("line"), attribute("column")),
        ("5", "24"),
        "characters"
    );
    assert_eq!(attribute("severity"), "error");
    assert_eq!(attribute("source"), "shaderlint.int-float-mix");
    let severities: BTreeSet<&str> = xml
        .descendants()
        .filter_map(|n| n.attribute("severity"))
        .collect();
    assert_eq!(severities, BTreeSet::from(["error", "info", "warning"]));
}

#[test]
fn formats_are_valid_without_findings() {
    let scratch = scratch();
    for format in ["json", "sarif", "gitlab"] {
        json(&scratch, format, &["clean.glsl"]);
    }
    for format in ["junit", "checkstyle"] {
        let ran = scratch.run(&["--format", format, "clean.glsl"]);
        roxmltree::Document::parse(&ran.out).unwrap();
    }
    for format in ["short", "jsonl", "github"] {
        assert_eq!(scratch.run(&["--format", format, "clean.glsl"]).out, "");
    }
    for format in ["human", "agent"] {
        let ran = scratch.run(&["--format", format, "clean.glsl"]);
        assert_eq!(ran.out, "All checks passed (1 shader in 1 file)\n");
    }
}

#[test]
fn json_counts_columns_in_both_units() {
    let found = json(&scratch(), "json", &["a b"]);
    let start = found.pointer("/diagnostics/1/start").unwrap();
    let byte = BROKEN.rfind("1;").unwrap() as u64;
    let places = ["/line", "/column", "/utf16", "/byte"].map(|p| number(start, p));
    assert_eq!(places, [5, 24, 25, byte]);
}

#[test]
fn positions_in_a_page_are_relative_to_the_page() {
    let page = "<p>é</p>\n<script type=\"x-shader/x-fragment\">#version 300 es\n/* 𝄞 */ float x = 1;\n</script>\n";
    let scratch = Scratch::new(&[("a.html", page)]);
    let found = json(&scratch, "json", &["a.html"]);
    let byte = page.find("1;").unwrap() as u64;
    let all = list(&found, "/diagnostics").iter();
    let mixed = all.filter(|d| text(d, "/rule") == "int-float-mix");
    let place = |d: &Value| ["/line", "/column", "/utf16", "/byte"].map(|p| number(&d["start"], p));
    assert_eq!(mixed.map(place).collect::<Vec<_>>(), [[3, 19, 20, byte]]);
}

#[test]
fn statistics_count_findings_by_rule() {
    let ran = scratch().run(&["--statistics", "a b", "warned.glsl"]);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(
        lines,
        [
            "      2  int-float-mix",
            "      1  pow-negative-base",
            "      1  unused-variable",
            "Found 2 errors, 1 warning, 1 info (2 shaders in 2 files); 2 fixable with --fix, 1 more with --unsafe-fixes",
            "Not fully checked: 2 functions (-v lists them)"
        ]
    );
    assert_eq!(ran.code, 1);
}
