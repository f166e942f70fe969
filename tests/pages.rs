//! Tests the pages of rules, compile errors and hosts: each has its sections, its bad examples are
//! reported exactly as printed, its fixes write what is shown, and its good examples have no findings.
//!
//! `INSTA_UPDATE=always cargo test` writes the generated parts: heads, findings, fixed code, options,
//! and the tables in `rules/README.md`.

use super::recorded::stale;
use super::tidy::files;
use shaderlint::diagnostic::{Diagnostic, ERRORS};
use shaderlint::engine::{DialectChoice, Options, check, fix_text};
use shaderlint::host::{Feed, Limit, presets};
use shaderlint::lint::sample::{INSTANTS, SIZE, SampleLimit};
use shaderlint::lint::{
    Allow, Check, Fence, FenceKind, Page, Renderer, Rule, RulePreset, Settings,
};
use shaderlint::project::NoFiles;
use shaderlint::report::render;
use shaderlint::rules::{RULES, error_page};
use shaderlint::semantic::{GuessedKind, guess};
use shaderlint::syntax::Version;
use shaderlint::text::Sources;
use shaderlint::text::number::grouped;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// What an example is written for: a shader of its own, or common code of ShaderToy.
pub(super) fn choice(name: &str, code: &str) -> DialectChoice {
    let is_glsl = name.ends_with(".glsl");
    match guess(code).kind {
        None if is_glsl => DialectChoice::Shadertoy,
        Some(GuessedKind::WebGl1 | GuessedKind::WebGl2) if is_glsl && !guess(code).has_main => {
            DialectChoice::Webgl2
        }
        _ => DialectChoice::Auto,
    }
}

fn options(name: &str, code: &str, settings: &Settings) -> Options {
    Options::new(choice(name, code), settings.clone())
}

fn judge(name: &str, code: &str, settings: &Settings) -> (Arc<Sources>, Vec<Diagnostic>) {
    let report = check(name, code, &options(name, code, settings), &NoFiles);
    assert!(report.unread.is_none(), "{name} cannot be judged");
    (report.sources, report.diagnostics)
}

/// Only the rule of the page runs, so that a page does not speak of others.
fn settings(name: &str) -> Settings {
    let all = ["all".to_string()];
    let none = Settings::new(RULES, &[], &all).unwrap();
    if ERRORS.contains(&name) {
        return none;
    }
    let mut settings = Settings::new(RULES, &[name.to_string()], &[])
        .unwrap()
        .only(name);
    // `old-version` reports nothing without it.
    settings.set_target_version(Some(Version::Es300));
    settings
}

struct Example<'a> {
    page: &'a str,
    name: &'a str,
    bad: Option<&'a Fence<'a>>,
}

impl Example<'_> {
    fn content(&self, fence: &Fence) -> &str {
        &self.page[fence.range.clone()]
    }

    /// What a fence must hold, and what is wrong with it besides.
    fn expected(&self, fence: &Fence) -> Result<Option<String>, String> {
        let settings = settings(self.name);
        let code = self.content(fence);
        let bad = || {
            self.bad
                .ok_or(format!("{:?} without a bad example", fence.kind))
        };
        let fixed = |allow| {
            let bad = bad()?;
            let code = self.content(bad);
            let fixed = fix_text(
                bad.file,
                code,
                &options(bad.file, code, &settings),
                &NoFiles,
                allow,
            );
            let (sources, left) = judge(bad.file, &fixed.text, &settings);
            match left.first() {
                Some(d) => Err(format!("left over:\n{}", render(&sources, d))),
                None => Ok(Some(fixed.text)),
            }
        };
        match fence.kind {
            FenceKind::Bad => {
                let (sources, found) = judge(fence.file, code, &settings);
                let other = found.iter().find(|d| d.rule != self.name);
                match other {
                    Some(d) => Err(format!("also found:\n{}", render(&sources, d))),
                    None if found.is_empty() => Err(format!("nothing is found in\n{code}")),
                    None => Ok(None),
                }
            }
            FenceKind::Good => {
                let (sources, found) = judge(fence.file, code, &settings);
                match found.first() {
                    Some(d) => Err(format!("not good:\n{}", render(&sources, d))),
                    None => Ok(None),
                }
            }
            FenceKind::Text => {
                let bad = bad()?;
                let (sources, found) = judge(bad.file, self.content(bad), &settings);
                let text: Vec<String> = found.iter().map(|d| render(&sources, d)).collect();
                Ok(Some(format!("{}\n", text.join("\n").trim_end())))
            }
            FenceKind::Fixed => fixed(Allow::Safe),
            FenceKind::Suggested => fixed(Allow::Unsafe),
            FenceKind::Other => Ok(None),
        }
    }
}

/// The label before a fence, so that a rendered page says what the fence shows.
fn label(name: &str, kind: FenceKind) -> Option<&'static str> {
    let is_error = ERRORS.contains(&name);
    Some(match kind {
        FenceKind::Text => "shaderlint prints:",
        FenceKind::Fixed => "`--fix` writes:",
        FenceKind::Suggested => "`--unsafe-fixes` writes:",
        FenceKind::Good if is_error => "Accepted:",
        FenceKind::Good => "Not reported:",
        FenceKind::Bad | FenceKind::Other => return None,
    })
}

/// The sections of a page, in order.
fn sections(name: &str) -> Vec<&'static str> {
    let mut sections = vec!["## Why it matters", "## Example", "## Fix"];
    if name == "invalid-encoding" {
        // Pages are UTF-8 themselves.
        sections.remove(1);
    }
    if let Some(rule) = RULES.iter().find(|r| r.name == name) {
        sections.push("## When to ignore it");
        if !rule.options.is_empty() {
            sections.push(OPTIONS.trim());
        }
    }
    sections
}

/// Which parts a page lacks: its sections in order, each with a text.
fn missing_parts(name: &str, text: &str) -> Vec<String> {
    let mut outside = true;
    let mut found: Vec<(&str, usize)> = Vec::new();
    for line in text.lines() {
        outside ^= line.starts_with("```");
        match found.last_mut() {
            _ if outside && line.starts_with("## ") => found.push((line, 0)),
            Some((_, words)) => *words += line.split_whitespace().count(),
            None => {}
        }
    }
    let mut problems = Vec::new();
    let headings: Vec<&str> = found.iter().map(|(heading, _)| *heading).collect();
    let expected = sections(name);
    if headings != expected {
        problems.push(format!("{name}: expected {expected:?}, found {headings:?}"));
    }
    for (heading, words) in found {
        if words < 5 {
            problems.push(format!("{name}: `{heading}` is empty"));
        }
    }
    problems
}

/// The highest grade of fix that changes a bad example of a page.
fn fix_of(name: &str, text: &str, page: &Page) -> &'static str {
    let settings = settings(name);
    let changes = |allow| {
        let bad = page.fences.iter().filter(|f| f.kind == FenceKind::Bad);
        let mut codes = bad.map(|f| (f.file, &text[f.range.clone()]));
        codes.any(|(file, code)| {
            let options = options(file, code, &settings);
            fix_text(file, code, &options, &NoFiles, allow).text != code
        })
    };
    match (changes(Allow::Safe), changes(Allow::Unsafe)) {
        (true, _) => "safe",
        (false, true) => "unsafe",
        (false, false) => "none",
    }
}

/// The value of a fact in the head of a page.
fn fact<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = head.split_once(&format!("**{name}:** "))?;
    rest.split(' ').next()
}

/// The line between title and summary. A page keeps the version that it names; a new one gets the
/// version under development.
fn head(name: &str, text: &str) -> String {
    let page = Page::new(text);
    let fix = fix_of(name, text, &page);
    let since = fact(page.head, "Since").unwrap_or(env!("CARGO_PKG_VERSION"));
    match RULES.iter().find(|r| r.name == name) {
        None => {
            format!("**Compile error** \u{b7} **Fix:** {fix} \u{b7} **Since:** {since}")
        }
        Some(rule) => {
            let default = match rule.preset {
                RulePreset::Recommended => "on".to_string(),
                preset => format!("off (preset `{}`)", preset.name()),
            };
            let (group, severity) = (rule.group.name(), rule.severity.name());
            let alias = rule.alias();
            let alias = alias.map_or(String::new(), |a| format!(" \u{b7} **Alias:** `{a}`"));
            format!(
                "**Group:** {group} \u{b7} **Severity:** {severity} \u{b7} **Default:** {default} \
                \u{b7} **Fix:** {fix}{alias} \u{b7} **Since:** {since}"
            )
        }
    }
}

/// What a rule that runs the shader samples, for the paragraph after its summary.
fn sampled(name: &str) -> Option<String> {
    let rule = RULES.iter().find(|r| r.name == name)?;
    rule.checks.iter().find(|c| matches!(c, Check::Run(_)))?;
    let [width, height] = SIZE;
    let times = INSTANTS.map(|i| i.time.to_string());
    let (last, first) = times.split_last()?;
    let first = first.join(", ");
    let pixels = grouped(SampleLimit::default().pixels.into());
    Some(format!(
        "Found in a [sample run](../docs/sampling.md): up to {pixels} pixels of a {width}x{height} frame, \
        at {first} and {last} s."
    ))
}

/// A page with its generated paragraphs: the head, and what is sampled.
fn with_head(name: &str, text: &str) -> String {
    let (before, rest) = text.split_once("\n## ").unwrap_or((text, ""));
    let page = Page::new(before);
    let mut paragraphs = vec![format!("# {}", page.name), head(name, text), page.summary];
    paragraphs.extend(sampled(name));
    format!("{}\n\n## {rest}", paragraphs.join("\n\n"))
}

/// The text up to the content of a fence, with the label before the fence.
fn labelled(before: &str, label: Option<&str>) -> String {
    let (Some(label), Some((text, info))) = (label, before.rsplit_once("```")) else {
        return before.to_string();
    };
    match text.trim_end() {
        text if text.ends_with(label) => format!("{text}\n\n```{info}"),
        text => format!("{text}\n\n{label}\n\n```{info}"),
    }
}

/// Checks one page; gives what is wrong, and the page as it should be.
fn check_page(name: &str, text: &str) -> (Vec<String>, String) {
    let page = Page::new(text);
    let mut problems = Vec::new();
    if page.name != name {
        problems.push(format!("{name}: the title is `{}`", page.name));
    }
    if page.summary.is_empty() || !page.summary.ends_with('.') {
        problems.push(format!("{name}: no summary"));
    }
    let has_examples = sections(name).contains(&"## Example");
    problems.extend(missing_parts(name, text));
    let headed = with_head(name, text);
    if headed != text {
        problems.push(format!("{name}: the head is stale"));
    }
    let text = headed.as_str();
    let page = Page::new(text);
    if has_examples && !page.fences.iter().any(|f| f.kind == FenceKind::Bad) {
        problems.push(format!("{name}: no bad example"));
    }
    if has_examples
        && !page.fences.iter().any(|f| {
            matches!(
                f.kind,
                FenceKind::Good | FenceKind::Fixed | FenceKind::Suggested
            )
        })
    {
        problems.push(format!("{name}: no good example"));
    }
    let mut fresh = String::new();
    let mut done = 0;
    let mut example = Example {
        page: text,
        name,
        bad: None,
    };
    for fence in &page.fences {
        if fence.kind == FenceKind::Bad {
            example.bad = Some(fence);
        }
        let before = labelled(&text[done..fence.range.start], label(name, fence.kind));
        if before != text[done..fence.range.start] {
            problems.push(format!("{name}: a fence without its label"));
        }
        fresh.push_str(&before);
        let now = &text[fence.range.clone()];
        match example.expected(fence) {
            Ok(Some(expected)) => {
                if expected != now {
                    problems.push(format!(
                        "{name}: the page is stale, it should say\n{expected}"
                    ));
                }
                fresh.push_str(&expected);
            }
            Ok(None) => fresh.push_str(now),
            Err(problem) => {
                problems.push(format!("{name}: {problem}"));
                fresh.push_str(now);
            }
        }
        done = fence.range.end;
    }
    fresh.push_str(&text[done..]);
    (problems, fresh)
}

fn run(pages: impl Iterator<Item = (String, &'static str)>) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut problems = Vec::new();
    for (path, name) in pages {
        let Ok(text) = fs::read_to_string(root.join(&path)) else {
            problems.push(format!("{path} is missing"));
            continue;
        };
        let (found, fresh) = check_page(name, &text);
        problems.extend(found);
        problems.extend(stale(&root.join(&path), &fresh));
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}

/// The page of a rule in the repository.
fn path_of(rule: &Rule) -> String {
    format!("rules/{}.md", rule.name.replace('-', "_"))
}

#[test]
fn examples_of_rule_pages_have_recorded_findings() {
    run(RULES.iter().map(|r| (path_of(r), r.name)));
}

#[test]
fn examples_of_error_pages_have_recorded_findings() {
    run(ERRORS
        .iter()
        .map(|name| (format!("rules/errors/{name}.md"), *name)));
}

/// The list of the files of hosts, which names each. Their folders are kinds of hosts, for readers.
#[test]
fn the_list_of_hosts_is_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/host");
    let mut rows = BTreeMap::new();
    for (path, _) in files(&["src/host/presets"], ".glsl") {
        let path = path.trim_start_matches("src/host/");
        let name = path.rsplit('/').next().unwrap().trim_end_matches(".glsl");
        let row = format!("    (\"{name}\", include_str!(\"{path}\")),\n");
        assert_eq!(rows.insert(name.to_string(), row), None, "two hosts {name}");
    }
    let list = format!(
        "//! Every file of `presets/`, in the order of the alphabet. Made by `cargo test --test all pages`.\n\n\
         /// The name and the text of each.\n#[rustfmt::skip]\n\
         pub(super) const FILES: &[(&str, &str)] = &[\n{}];\n",
        rows.into_values().collect::<String>()
    );
    assert_eq!(stale(&folder.join("list.rs"), &list), None);
}

#[test]
fn pages_of_hosts_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules/hosts");
    let words: String = Feed::ALL
        .iter()
        .map(|feed| format!("| `{}` | {} |\n", feed.name(), feed.description()))
        .collect();
    let words = format!("| value | meaning |\n|---|---|\n{words}");
    let limits = Limit::ALL.iter().map(|limit| format!("`{}`", limit.name()));
    let limits = limits.collect::<Vec<_>>().join(", ");
    let mut list = format!(
        "# Hosts\n\nA host is the site or library that runs a shader, or completes it before the browser compiles it. \
        `shaderlint` and `shaderport` detect the host of a shader. To select one, use `--host NAME` or set \
        `host = \"NAME\"` in `shaderlint.toml`.\n\n\
        ## Defining a host\n\n\
        Each host is a GLSL file in `src/host/presets`. To add your own, write a file of the same form and set \
        `prelude = \"host.glsl\"` in the section `[host]`.\n\n\
        ```glsl\n// My engine\n//\n// A description.\n//\n// base: three\n// names: all\n\
        uniform float uClock; // = time\nuniform vec2 uSize; // = resolution, or vec3\n\
        uniform sampler2D uNoise; // = file, mipmap, repeat\n#ifdef SHADER_DECLARES\n\
        varying vec2 vPlace; // = port_place, own\n#endif\n```\n\n\
        The header has a title, a description and facts: `base` (the host that it extends), `version` (`any`, `own`, `desktop`, \
        `100`, `300 es`), `names` (`all`: other undeclared names are errors; `some`), \
        `uniforms` (`all`: a shader that declares other uniforms is for another host; `some`), `entry`, `include`, `hole`, `chunks` (`three.js`: those of that library), `package`, \
        `word`, `global`, `shows`, `alias`, `reads`, `source`, `renames`, `takes`, `requires`, `file`, `defines`, \
        `complete` and `bare` (JavaScript names that receive shaders to which it adds nothing else, or nothing at all), `patched` (what changes them nevertheless), `removed` (a name, the first release without it and what to do instead), \
        `glsl` (the property next to a shader that sets its version, and its value for GLSL ES 3.00), \
        `refuses` (what it does not accept: {limits}), `setters` (`dart`: an application sets the uniforms by their order), \
        `programs` (how many shaders it runs, which read each other).\n\n\
        A comment `// =` after a declaration states the value that the host sets, so that the shader can be run. Options \
        follow after commas: `or TYPE` lists more types, `numbered` accepts any number in the name, `ending` accepts names \
        that end like this one, in capitals or not, and `usual` or `own` \
        states how strongly the name indicates this host. Names between `#ifdef SHADER_DECLARES` and `#endif` are declared \
        by the shaders themselves. The value of a varying is a GLSL expression of `port_place` (from 0 to 1), `port_pos` \
        (from -1 to 1) and `port_size` (pixels).\n\n\
        Between `#ifdef SHADER_MAIN` and `#endif` is the `main` that the host appends; `port_entry` in it is the function \
        that the shader defines.\n\n\
        Between `#ifdef SHADER_TEMPLATE` and `#endif` is the text around the code of a shader that `shaderport --target NAME` \
        writes: `#pragma code` is the place of the code, `port_image` its `mainImage`. What follows `#pragma screen` is written \
        if the shader reads the screen.\n\n{words}\n## All hosts\n\n| name | host | compiled as |\n|---|---|---|\n",
    );
    let mut expected = Vec::new();
    for host in presets() {
        let row = format!(
            "| [{0}]({0}.md) | {1} | {2} |\n",
            host.name, host.title, host.version
        );
        list.push_str(&row);
        expected.push((format!("{}.md", host.name), host.page()));
    }
    expected.push(("README.md".to_string(), list));
    let outdated = expected
        .iter()
        .filter_map(|(name, text)| stale(&folder.join(name), text));
    let outdated: Vec<String> = outdated.collect();
    assert!(outdated.is_empty(), "{}", outdated.join("\n\n"));
    let count = fs::read_dir(folder).unwrap().count();
    assert_eq!(count, expected.len(), "pages of hosts that are not there");
}

/// A generated table, and what stands around it in a file.
struct Table {
    markers: (&'static str, &'static str),
    /// The table, given the folder that leads from the file to the pages.
    rows: fn(&str) -> String,
}

const TABLES: [Table; 2] = [
    Table {
        markers: ("<!-- rules -->\n", "<!-- /rules -->"),
        rows: rules,
    },
    Table {
        markers: ("<!-- errors -->\n", "<!-- /errors -->"),
        rows: errors,
    },
];

/// A row for each rule. `folder` leads from the file to the pages.
fn rules(folder: &str) -> String {
    let mut text = String::from(
        "\n| rule | group | severity | preset | fix | summary |\n|---|---|---|---|---|---|\n",
    );
    for rule in RULES {
        let page = Page::new(rule.page);
        let fix = fact(page.head, "Fix").unwrap_or("").replace("none", "");
        let row = [
            format!(
                "[{}]({folder}{}.md)",
                rule.name,
                rule.name.replace('-', "_")
            ),
            rule.group.name().to_string(),
            rule.severity.name().to_string(),
            rule.preset.name().to_string(),
            fix,
            page.summary.replace('|', "\\|"),
        ];
        text.push_str(&format!("| {} |\n", row.join(" | ")));
    }
    text.push('\n');
    text
}

/// A row for each compile error.
fn errors(folder: &str) -> String {
    let mut text = String::from("\n| error | summary |\n|---|---|\n");
    for name in ERRORS {
        let page = Page::new(error_page(name).unwrap());
        let summary = page.summary.replace('|', "\\|");
        text.push_str(&format!(
            "| [{name}]({folder}errors/{name}.md) | {summary} |\n"
        ));
    }
    text.push('\n');
    text
}

/// A file with its table as it should be; `None` where it has no table.
fn with_table(text: &str, table: &Table, folder: &str) -> Option<String> {
    let (open, close) = table.markers;
    let (before, rest) = text.split_once(open)?;
    let (_, after) = rest.split_once(close)?;
    Some(format!(
        "{before}{open}{}{close}{after}",
        (table.rows)(folder)
    ))
}

#[test]
fn tables_of_rules_and_errors_are_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules/README.md");
    let text = fs::read_to_string(&path).unwrap();
    let fresh = TABLES.iter().fold(text.clone(), |text, table| {
        with_table(&text, table, "").expect("rules/README.md has a place for each table")
    });
    assert_eq!(stale(&path, &fresh), None);
}

/// What a rule goes by, as the last section of its page; nothing where it has no options.
fn options_of(rule: &Rule) -> String {
    let rows = rule.options.iter().map(|option| {
        let [usual, on_swiftshader] =
            [Renderer::Gpu, Renderer::SwiftShader].map(|t| option.usual(t));
        let (name, about) = (option.name(), option.about());
        format!("| `{name}` | {usual} | {on_swiftshader} | {about} |\n")
    });
    let rows: String = rows.collect();
    match rows.is_empty() {
        true => rows,
        false => {
            format!("{OPTIONS}| option | default | on SwiftShader | |\n|---|---|---|---|\n{rows}")
        }
    }
}

/// How the section of options starts.
const OPTIONS: &str = "\n## Options\n\n";

#[test]
fn pages_end_with_an_up_to_date_list_of_options() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let outdated = RULES.iter().filter_map(|rule| {
        let text = rule.page.split(OPTIONS).next().unwrap().to_string();
        stale(&root.join(path_of(rule)), &(text + &options_of(rule)))
    });
    let outdated: Vec<String> = outdated.collect();
    assert!(outdated.is_empty(), "{}", outdated.join("\n\n"));
}

#[test]
fn tables_are_replaced_between_their_markers() {
    let text = "# A\n\n<!-- rules -->\nold\n<!-- /rules -->\n\nmore\n";
    let fresh = with_table(text, &TABLES[0], "rules/").unwrap();
    assert!(fresh.starts_with("# A\n\n<!-- rules -->\n\n| rule "));
    assert!(fresh.ends_with(" |\n\n<!-- /rules -->\n\nmore\n"));
    assert!(!fresh.contains("\nold\n"));
    assert!(fresh.contains("| [float-equality](rules/float_equality.md) | numeric | "));
    assert_eq!(with_table("# A\n", &TABLES[0], ""), None);
}

#[test]
fn pages_with_missing_parts_are_refused() {
    let parts = |text: &str| missing_parts("flat-frame", text).len();
    let body = "one two three four five\n";
    let whole = format!(
        "# a\n\nOne.\n\n## Why it matters\n{body}## Example\n{body}## Fix\n{body}## When to ignore it\n"
    );
    assert_eq!(parts(&format!("{whole}{body}")), 0);
    assert_eq!(parts(&whole), 1);
    assert_eq!(parts(&whole.replace("## Fix", "## Fixing")), 2);
}

#[test]
fn the_head_of_a_page_keeps_its_version() {
    let page = "# flat-frame\n\n**Since:** 0.0.9\n\nSummary.\n\n## Why it matters\n\nText.\n";
    let fresh = with_head("flat-frame", page);
    assert!(fresh.contains(" **Severity:** warning ") && fresh.contains("**Since:** 0.0.9\n"));
    assert!(fresh.contains("\n\nSummary.\n\nFound in a [sample run]"));
    assert_eq!(with_head("flat-frame", &fresh), fresh);
    let new = with_head("flat-frame", &page.replace("**Since:** 0.0.9\n\n", ""));
    assert!(new.contains(concat!("**Since:** ", env!("CARGO_PKG_VERSION"))));
}

#[test]
fn fences_are_labelled_once() {
    let once = labelled("Text.\n\n```glsl good\n", Some("Accepted:"));
    assert_eq!(once, "Text.\n\nAccepted:\n\n```glsl good\n");
    assert_eq!(labelled(&once, Some("Accepted:")), once);
    assert_eq!(labelled("Text.\n\n```sh\n", None), "Text.\n\n```sh\n");
}
