//! JSON for programs: one object, or one object per line. The README documents the fields.

use super::summary::{ReadAs, Summary};
use serde::Serialize;
use serde_json::json;
use shaderlint_diagnostic::{Diagnostic, Label, MacroUse};
use shaderlint_text::{Edit, Position, Sources, Span};
use std::io::{self, Write};

/// Version of the schema; it changes when the meaning of a field changes.
const SCHEMA: u32 = 1;

#[derive(Serialize)]
struct Range {
    start: Position,
    end: Position,
}

impl Range {
    fn new(sources: &Sources, span: Span) -> Range {
        let file = sources.file_at(span.start);
        let place = |address| {
            let nowhere = Position {
                line: 1,
                column: 1,
                utf16: 1,
                byte: 0,
            };
            file.map_or(nowhere, |f| f.shown_position(address))
        };
        Range {
            start: place(span.start),
            end: place(span.end),
        }
    }
}

#[derive(Serialize)]
struct JsonLabel<'a> {
    #[serde(flatten)]
    range: Range,
    #[serde(skip_serializing_if = "Option::is_none")]
    pass: Option<&'a str>,
    message: &'a str,
}

#[derive(Serialize)]
struct JsonMacro<'a> {
    name: &'a str,
    call: Range,
    #[serde(skip_serializing_if = "Option::is_none")]
    definition: Option<Range>,
}

#[derive(Serialize)]
struct JsonEdit<'a> {
    #[serde(flatten)]
    range: Range,
    text: &'a str,
}

#[derive(Serialize)]
struct JsonFix<'a> {
    title: &'a str,
    applicability: &'static str,
    edits: Vec<JsonEdit<'a>>,
}

#[derive(Serialize)]
struct JsonDiagnostic<'a> {
    file: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pass: Option<&'a str>,
    rule: &'static str,
    severity: &'static str,
    message: &'a str,
    #[serde(flatten)]
    range: Range,
    labels: Vec<JsonLabel<'a>>,
    /// Other places of the same mistake, with their messages.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    others: Vec<JsonLabel<'a>>,
    notes: Vec<&'a str>,
    macros: Vec<JsonMacro<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<JsonFix<'a>>,
    page: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    host: Option<String>,
    /// How the checked file was interpreted; the finding may be in a file that it includes.
    #[serde(skip_serializing_if = "Option::is_none")]
    read_as: Option<&'a str>,
}

fn convert<'a>(
    sources: &'a Sources,
    d: &'a Diagnostic,
    read_as: Option<&'a ReadAs>,
) -> JsonDiagnostic<'a> {
    let file = sources.file_at(d.span.start);
    let pass_at = |span: Span| sources.file_at(span.start).and_then(|f| f.part.as_deref());
    let label = |l: &'a Label| JsonLabel {
        range: Range::new(sources, l.span),
        pass: pass_at(l.span),
        message: &l.message,
    };
    let used = |m: &'a MacroUse| JsonMacro {
        name: &m.name,
        call: Range::new(sources, m.call),
        definition: (!m.definition.is_empty()).then(|| Range::new(sources, m.definition)),
    };
    let edit = |e: &'a Edit| JsonEdit {
        range: Range::new(sources, e.span),
        text: &e.text,
    };
    let own = (!d.label.is_empty()).then(|| JsonLabel {
        range: Range::new(sources, d.span),
        pass: pass_at(d.span),
        message: &d.label,
    });
    JsonDiagnostic {
        file: file.map_or("", |f| f.shown_path(d.span.start)),
        pass: pass_at(d.span),
        rule: d.rule,
        severity: d.severity.name(),
        message: &d.message,
        range: Range::new(sources, d.span),
        labels: own.into_iter().chain(d.labels.iter().map(label)).collect(),
        others: d.others.iter().map(label).collect(),
        notes: d.notes.iter().chain(&d.help).map(String::as_str).collect(),
        macros: d.macros.iter().map(used).collect(),
        fix: d.fix.as_ref().map(|f| JsonFix {
            title: &f.title,
            applicability: f.applicability.name(),
            edits: f.edits.iter().map(edit).collect(),
        }),
        page: d.page(),
        part: d.part.as_ref().map(|_| true),
        host: d
            .part
            .as_ref()
            .filter(|p| !p.is_empty())
            .map(|p| p.join(", ")),
        read_as: read_as.map(|r| r.read_as.as_str()),
    }
}

/// Writes everything before the first finding.
pub fn begin(out: &mut impl Write) -> io::Result<()> {
    let version = env!("CARGO_PKG_VERSION");
    write!(
        out,
        "{{\"schema\":{SCHEMA},\"tool\":{{\"name\":\"shaderlint\",\"version\":\"{version}\"}},\"diagnostics\":["
    )
}

/// Writes one finding as an element of the array.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    is_first: bool,
) -> io::Result<()> {
    out.write_all(if is_first { b"\n" } else { b",\n" })?;
    serde_json::to_writer(&mut *out, &convert(sources, d, None))?;
    Ok(())
}

/// Writes one finding on its own line.
pub fn write_line(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    read_as: Option<&ReadAs>,
) -> io::Result<()> {
    serde_json::to_writer(&mut *out, &convert(sources, d, read_as))?;
    out.write_all(b"\n")
}

/// Writes everything after the last finding.
pub fn end(out: &mut impl Write, summary: &Summary) -> io::Result<()> {
    let skipped = summary.skipped_functions.iter();
    let skipped = skipped.chain(&summary.open_functions);
    let skipped: Vec<_> = skipped
        .map(|(function, file)| json!({"file": file, "function": function}))
        .collect();
    let value = json!({
        "files": summary.files,
        "shaders": summary.shaders,
        "errors": summary.errors,
        "warnings": summary.warnings,
        "infos": summary.infos,
        "fixed": summary.fixed,
        "failing": summary.failing,
        "left_out": summary.left_out,
        "parts": summary.parts,
        "open_names": summary.open_names.len(),
        "unrun_shaders": summary.skipped_shaders,
        "unrun_functions": skipped
    });
    let readings = summary.readings.iter();
    let readings: Vec<_> = readings
        .map(|(file, r)| json!({"file": file, "hosts": r.hosts, "read_as": r.read_as}))
        .collect();
    let readings = json!(readings);
    writeln!(out, "\n],\"readings\":{readings},\"summary\":{value}}}")
}
