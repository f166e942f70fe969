//! `shaderlint references`: where the project of a file uses a name, as the language server answers it.

use super::super::command::{CLEAN, FAILED, FINDINGS, complain};
use super::super::config::{absolute, configs};
use super::super::evidence;
use super::super::port::read_text;
use super::pages::PageFiles;
use super::workspace::DiskWorkspace;
use crate::engine::config::ConfigArgs;
use crate::ide::{FileSpan, NameUse};
use crate::lsp::{Session, name_uses, uri_of};
use crate::project::Files;
use crate::text::LineIndex;
use crate::text::path::slashed;
use gen_lsp_types::Uri;
use lsp_server::Notification;
use serde_json::json;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Arguments of `shaderlint references`.
#[derive(clap::Args, Debug)]
pub struct ReferencesArgs {
    /// File that uses the name
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Name of a variable, function, struct, member or macro
    #[arg(value_name = "NAME")]
    name: String,
    /// Only what the name means in this line of the file
    #[arg(long, value_name = "NUMBER")]
    line: Option<u32>,
}

/// Uses of one symbol, in the order of files.
type Uses = Vec<(FileSpan, NameUse)>;

/// Prints the uses of a name: a group for each symbol with this name. Returns the exit code.
pub fn references(args: &ReferencesArgs) -> io::Result<u8> {
    let text = match read_text(&args.file) {
        Ok(text) => text,
        Err(message) => {
            complain(&message);
            return Ok(FAILED);
        }
    };
    let configs = configs(ConfigArgs::default());
    evidence::file(&slashed(&args.file), &text, &configs);
    let session = opened(&uri(args), &text);
    let found = uses(&session, args, &text);
    let groups: Vec<String> = found.iter().map(|uses| group(&session, uses)).collect();
    if groups.is_empty() {
        let line = args.line.map(|line| format!(" in line {line}"));
        let (name, file) = (&args.name, slashed(&args.file));
        let line = line.unwrap_or_default();
        complain(&format!("{file}: no symbol is named `{name}`{line}"));
        return Ok(FINDINGS);
    }
    io::stdout()
        .lock()
        .write_all(groups.join("\n").as_bytes())?;
    Ok(CLEAN)
}

/// The URI of the file.
fn uri(args: &ReferencesArgs) -> Uri {
    uri_of(&slashed(absolute(&args.file)))
}

/// A session in which a file is open.
fn opened(uri: &Uri, text: &str) -> Session {
    let workspace = |folders: &[PathBuf]| {
        let pages = Arc::new(PageFiles::default());
        Arc::new(DiskWorkspace::new(folders, pages)) as _
    };
    let mut session = Session::new(&json!({}), workspace);
    let document = json!({ "uri": uri, "languageId": "", "version": 0, "text": text });
    session.notification(Notification::new(
        "textDocument/didOpen".to_string(),
        json!({ "textDocument": document }),
    ));
    session
}

/// The uses of each symbol with the name.
fn uses(session: &Session, args: &ReferencesArgs, text: &str) -> Vec<Uses> {
    let snapshot = session.snapshot();
    let lines = LineIndex::new(text);
    let Ok(buffer) = snapshot.buffer(&uri(args)) else {
        return Vec::new();
    };
    let mut seen: BTreeSet<u32> = BTreeSet::new();
    let mut groups = Vec::new();
    for at in name_places(text, &args.name) {
        let is_asked = args.line.is_none_or(|l| lines.position(text, at).line == l);
        if !is_asked || seen.contains(&at) {
            continue;
        }
        let found = name_uses(snapshot, buffer, at);
        let own = found.iter().filter(|(place, _)| place.path == buffer.path);
        seen.extend(own.map(|(place, _)| place.span.start));
        if !found.is_empty() {
            groups.push(found);
        }
    }
    groups
}

/// The offsets of a name in a text.
fn name_places<'a>(text: &'a str, name: &'a str) -> impl Iterator<Item = u32> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let is_whole = move |at: &usize| {
        let before = text.get(..*at).and_then(|t| t.chars().next_back());
        let after = text.get(at + name.len()..).and_then(|t| t.chars().next());
        !before.is_some_and(is_part) && !after.is_some_and(is_part)
    };
    let found = text.match_indices(name).map(|(at, _)| at);
    found.filter(is_whole).map(|at| at as u32)
}

/// The lines of a symbol: `path:line:column: read: the code of the line`.
fn group(session: &Session, uses: &Uses) -> String {
    let mut text = String::new();
    let mut last: Option<(&str, Arc<str>, LineIndex)> = None;
    for (place, access) in uses {
        if last.as_ref().is_none_or(|(path, ..)| *path != place.path) {
            let Ok(content) = session.snapshot().files.load(Path::new(&place.path)) else {
                continue;
            };
            let index = LineIndex::new(&content);
            last = Some((&place.path, content, index));
        }
        let Some((path, content, index)) = &last else {
            continue;
        };
        let at = index.position(content, place.span.start);
        let code = content.lines().nth(at.line as usize - 1).unwrap_or("");
        text.push_str(&format!(
            "{}:{}:{}: {}: {}\n",
            relative(path),
            at.line,
            at.column,
            word(*access),
            code.trim()
        ));
    }
    text
}

/// A path as it is typed in the current folder.
fn relative(path: &str) -> String {
    let here = absolute(Path::new("."));
    let path = Path::new(path);
    slashed(path.strip_prefix(here).unwrap_or(path))
}

/// How a name is used.
fn word(access: NameUse) -> &'static str {
    match access {
        NameUse::Declared => "declared",
        NameUse::Defined => "defined",
        NameUse::Read => "read",
        NameUse::Written => "written",
        NameUse::Changed => "changed",
        NameUse::Unseen => "not compiled",
    }
}
