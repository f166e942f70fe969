//! Every page means what it says: its bad examples are reported as it prints, its fixes give what
//! it shows, its good examples are silent.
//!
//! `INSTA_UPDATE=always cargo test` writes what is printed and fixed into the pages, and the table of
//! all rules between its markers.

use shaderlint::cli::document::{DialectChoice, check, fix_text};
use shaderlint::cli::input::Content;
use shaderlint::diagnostic::{Diagnostic, ERRORS};
use shaderlint::lint::{Allow, Fence, FenceKind, Page, Settings};
use shaderlint::report::render;
use shaderlint::rules::RULES;
use shaderlint::text::Sources;
use std::fs;
use std::path::Path;

fn judge(name: &str, code: &str, settings: &Settings) -> (Sources, Vec<Diagnostic>) {
    match check(name, Content::utf8(code), DialectChoice::Auto, settings) {
        Ok(findings) => (findings.sources, findings.diagnostics),
        Err(_) => panic!("{name} cannot be judged"),
    }
}

/// Only the rule of the page runs, so that a page does not speak of others.
fn settings(name: &str) -> Settings {
    let all = ["all".to_string()];
    let none = Settings::new(RULES, &[], &all).unwrap();
    if ERRORS.contains(&name) {
        return none;
    }
    Settings::new(RULES, &[name.to_string()], &[])
        .unwrap()
        .only(name)
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
            let choice = DialectChoice::Auto;
            let fixed = fix_text(bad.file, self.content(bad), choice, &settings, allow);
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
    // Pages are UTF-8 themselves.
    let has_examples = name != "invalid-encoding";
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
        fresh.push_str(&text[done..fence.range.start]);
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
    let accept = std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut problems = Vec::new();
    for (path, name) in pages {
        let Ok(text) = fs::read_to_string(root.join(&path)) else {
            problems.push(format!("{path} is missing"));
            continue;
        };
        let (found, fresh) = check_page(name, &text);
        if accept && fresh != text {
            fs::write(root.join(&path), fresh).unwrap();
        }
        problems.extend(found);
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}

#[test]
fn pages_of_rules() {
    run(RULES
        .iter()
        .map(|r| (format!("rules/{}.md", r.name.replace('-', "_")), r.name)));
}

#[test]
fn pages_of_errors() {
    run(ERRORS
        .iter()
        .map(|name| (format!("rules/errors/{name}.md"), *name)));
}

/// What stands around the table of rules, where a file has one.
const MARKERS: (&str, &str) = ("<!-- rules -->\n", "<!-- /rules -->");

/// A row for each rule. `folder` leads from the file to the pages.
fn table(folder: &str) -> String {
    let mut text = String::from(
        "\n| rule | group | level | by default | fix | what it finds |\n|---|---|---|---|---|---|\n",
    );
    for rule in RULES {
        let page = Page::new(rule.page);
        let has = |kind| page.fences.iter().any(|f| f.kind == kind);
        let fix = match (has(FenceKind::Fixed), has(FenceKind::Suggested)) {
            (true, _) => "safe",
            (false, true) => "unsafe",
            (false, false) => "",
        };
        let row = [
            format!(
                "[{}]({folder}{}.md)",
                rule.name,
                rule.name.replace('-', "_")
            ),
            rule.group.name().to_string(),
            rule.severity.name().to_string(),
            if rule.default { "on" } else { "off" }.to_string(),
            fix.to_string(),
            page.summary.replace('|', "\\|"),
        ];
        text.push_str(&format!("| {} |\n", row.join(" | ")));
    }
    text.push('\n');
    text
}

/// A file with its table as it should be; `None` where it has no table.
fn with_table(text: &str, folder: &str) -> Option<String> {
    let (before, rest) = text.split_once(MARKERS.0)?;
    let (_, behind) = rest.split_once(MARKERS.1)?;
    let table = table(folder);
    Some(format!("{before}{}{table}{}{behind}", MARKERS.0, MARKERS.1))
}

#[test]
fn tables_of_rules() {
    let accept = std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut stale = Vec::new();
    for (path, folder, must) in [
        ("rules/README.md", "", true),
        ("README.md", "rules/", false),
    ] {
        let text = fs::read_to_string(root.join(path)).unwrap_or_default();
        match with_table(&text, folder) {
            Some(fresh) if fresh != text => {
                stale.push(path);
                if accept {
                    fs::write(root.join(path), fresh).unwrap();
                }
            }
            None if must => panic!("{path} has no place for the table of rules"),
            _ => {}
        }
    }
    assert!(stale.is_empty(), "the table of rules is stale in {stale:?}");
}

#[test]
fn a_table_stands_between_its_markers() {
    let text = "# A\n\n<!-- rules -->\nold\n<!-- /rules -->\n\nmore\n";
    let fresh = with_table(text, "rules/").unwrap();
    assert!(fresh.starts_with("# A\n\n<!-- rules -->\n\n| rule "));
    assert!(fresh.ends_with(" |\n\n<!-- /rules -->\n\nmore\n"));
    assert!(!fresh.contains("old"));
    assert!(fresh.contains("| [float-equality](rules/float_equality.md) | numeric | "));
    assert_eq!(with_table("# A\n", ""), None);
}
