//! SARIF 2.1.0. Columns count Unicode scalar values, as `columnKind` declares.

use super::others::placed_message;
use super::place::{path, region};
use serde_json::{Value, json};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::{Edit, Sources, Span};
use std::io::{self, Write};

/// Returns the documentation of a rule or a compile error by name.
pub type Pages = fn(&str) -> Option<RulePage>;

/// The documentation of a rule.
pub struct RulePage {
    /// One sentence.
    pub summary: String,
    /// The page after its title, in Markdown.
    pub body: &'static str,
}

/// Writes everything before the first finding.
pub fn begin(out: &mut impl Write) -> io::Result<()> {
    out.write_all(
        b"{\"$schema\":\"https://json.schemastore.org/sarif-2.1.0.json\",\"version\":\"2.1.0\",\"runs\":[{\
          \"columnKind\":\"unicodeCodePoints\",\"results\":[",
    )
}

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    fingerprint: &str,
    root: &str,
) -> io::Result<()> {
    let mut text = placed_message(sources, d);
    for line in d.notes.iter().chain(&d.help) {
        text.push('\n');
        text.push_str(line);
    }
    let related: Vec<Value> = d
        .labels
        .iter()
        .chain(&d.others)
        .map(|l| {
            let mut place = location(sources, l.span, root);
            put(&mut place, "message", json!({"text": l.message}));
            place
        })
        .collect();
    let mut result = json!({
        "ruleId": d.rule,
        "level": level(d.severity),
        "message": {"text": text},
        "locations": [location(sources, d.span, root)],
        "partialFingerprints": {"shaderlint/v1": fingerprint}
    });
    if !related.is_empty() {
        put(&mut result, "relatedLocations", Value::Array(related));
    }
    if let Some(fix) = &d.fix
        && let Some(changes) = changes(sources, &fix.edits, root)
    {
        put(
            &mut result,
            "fixes",
            json!([{"description": {"text": fix.title}, "artifactChanges": changes}]),
        );
    }
    serde_json::to_writer(out, &result)?;
    Ok(())
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "note",
    }
}

/// Adds a member to an object.
fn put(object: &mut Value, name: &str, value: Value) {
    if let Value::Object(members) = object {
        members.insert(name.to_string(), value);
    }
}

fn location(sources: &Sources, span: Span, root: &str) -> Value {
    let mut physical = json!({"artifactLocation": {"uri": uri(path(sources, span, root))}});
    if let Some(region) = region_of(sources, span) {
        put(&mut physical, "region", region);
    }
    let mut place = json!({"physicalLocation": physical});
    if let Some(part) = sources.file_at(span.start).and_then(|f| f.part.as_ref()) {
        put(
            &mut place,
            "logicalLocations",
            json!([{"name": part, "kind": "module"}]),
        );
    }
    place
}

fn region_of(sources: &Sources, span: Span) -> Option<Value> {
    let (start, end) = region(sources, span)?;
    Some(json!({
        "startLine": start.line,
        "startColumn": start.column,
        "endLine": end.line,
        "endColumn": end.column,
        "byteOffset": start.byte,
        "byteLength": end.byte - start.byte
    }))
}

/// The edits of a fix, which all are in one file.
fn changes(sources: &Sources, edits: &[Edit], root: &str) -> Option<Value> {
    let first = edits.first()?;
    let replacements: Option<Vec<Value>> = edits
        .iter()
        .map(|e| {
            let deleted = region_of(sources, e.span)?;
            Some(json!({"deletedRegion": deleted, "insertedContent": {"text": e.text}}))
        })
        .collect();
    let uri = uri(path(sources, first.span, root));
    Some(json!([{"artifactLocation": {"uri": uri}, "replacements": replacements?}]))
}

/// A path as a relative reference or a `file:` URI.
fn uri(path: &str) -> String {
    let mut out = String::new();
    if path.starts_with('/') {
        out.push_str("file://");
    } else if path.as_bytes().get(1) == Some(&b':') {
        out.push_str("file:///");
    }
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'.' | b'-' | b'_' | b'~' => {
                out.push(byte as char)
            }
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

/// Writes everything after the last finding: the tool and the rules that have findings.
pub fn end(out: &mut impl Write, names: &[&'static str], pages: Pages) -> io::Result<()> {
    let rules: Vec<Value> = names.iter().map(|name| rule(name, pages)).collect();
    let tool = json!({
        "driver": {
            "name": "shaderlint",
            "version": env!("CARGO_PKG_VERSION"),
            "rules": rules
        }
    });
    write!(out, "\n],\"tool\":")?;
    serde_json::to_writer(&mut *out, &tool)?;
    out.write_all(b"}]}\n")
}

fn rule(name: &str, pages: Pages) -> Value {
    let Some(page) = pages(name) else {
        return json!({"id": name});
    };
    json!({
        "id": name,
        "shortDescription": {"text": page.summary},
        "help": {"text": page.summary, "markdown": page.body}
    })
}
