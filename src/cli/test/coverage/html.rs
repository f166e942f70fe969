//! Coverage as a page: a table of the files, and their code with counts.

use super::share::{Share, shares};
use crate::play::{Coverage, FileCoverage};
use std::collections::BTreeMap;
use std::fmt::Write;

const HEAD: &str = "<!doctype html>
<html lang=\"en\">
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>Coverage</title>
<style>
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 72rem; padding: 0 1rem; }
h2 { font-size: 1.1rem; margin: 2.5rem 0 .5rem; }
table { border-collapse: collapse; }
th, td { padding: .2rem .8rem; text-align: right; }
th:first-child, td:first-child { text-align: left; }
tr + tr { border-top: 1px solid light-dark(#ddd, #444); }
meter { width: 6rem; }
.code { font: 13px/1.5 ui-monospace, monospace; overflow-x: auto; border: 1px solid light-dark(#ddd, #444); }
.line { display: grid; grid-template-columns: 3.5rem 5.5rem 1fr; white-space: pre; min-width: max-content; }
.line > span { padding: 0 .6rem; }
.number, .count { text-align: right; color: light-dark(#666, #999); }
.ran > .count { background: light-dark(#d8f0d8, #1f3d24); color: inherit; }
.partly > .count { background: light-dark(#fbeec2, #4a3f14); color: inherit; }
.missed { background: light-dark(#fde3e1, #4a2220); }
.note { color: light-dark(#8a5a00, #e0b050); }
</style>
<h1>Coverage</h1>
";

pub fn html(coverage: &Coverage) -> String {
    let mut text = HEAD.to_string();
    text.push_str("<table>\n<tr><th>File<th>Lines<th><th>Branches<th>Functions\n");
    for (number, (path, file)) in coverage.files.iter().enumerate() {
        let [lines, branches, functions] = shares(file);
        let (path, percent) = (escaped(path), lines.percent());
        let [lines, branches, functions] = [lines, branches, functions].map(shown);
        let _ = writeln!(
            text,
            "<tr><td><a href=\"#file-{number}\">{path}</a><td>{lines}\
             <td><meter value=\"{percent:.1}\" max=\"100\"></meter><td>{branches}<td>{functions}"
        );
    }
    text.push_str("</table>\n");
    for (number, (path, file)) in coverage.files.iter().enumerate() {
        let path = escaped(path);
        let _ = writeln!(
            text,
            "<h2 id=\"file-{number}\">{path}</h2>\n<div class=\"code\">"
        );
        code(&mut text, file);
        text.push_str("</div>\n");
    }
    text.push_str("</html>\n");
    text
}

fn shown(share: Share) -> String {
    match share.all {
        0 => "–".to_string(),
        all => format!("{:.1} % ({}/{all})", share.percent(), share.ran),
    }
}

fn code(text: &mut String, file: &FileCoverage) {
    let lines = file.lines();
    let mut missing: BTreeMap<u32, Vec<&str>> = BTreeMap::new();
    for (&(line, _), [taken, skipped]) in &file.branches {
        match (taken, skipped) {
            (0, 0) => {}
            (0, _) => missing.entry(line).or_default().push("never true"),
            (_, 0) => missing.entry(line).or_default().push("never false"),
            _ => {}
        }
    }
    for (number, line) in (1..).zip(file.text.lines()) {
        let count = lines.get(&number).copied();
        let missing = missing.get(&number);
        let class = match count {
            None => "line",
            Some(0) => "line missed",
            Some(_) if missing.is_some() => "line partly",
            Some(_) => "line ran",
        };
        let count = count.map_or(String::new(), |count| format!("{count}×"));
        let note = missing.map_or(String::new(), |all| {
            format!("  <span class=\"note\">{}</span>", all.join(", "))
        });
        let line = escaped(line);
        let _ = writeln!(
            text,
            "<div class=\"{class}\"><span class=\"number\">{number}</span>\
             <span class=\"count\">{count}</span><span>{line}{note}</span></div>"
        );
    }
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}
