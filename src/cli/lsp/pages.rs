//! The documentation of rules and errors as files, which every editor can open.

use super::parent::is_alive;
use crate::lsp::uri_of;
use crate::rules::page;
use gen_lsp_types::Uri;
use std::collections::HashMap;
use std::fs;
use std::sync::Mutex;
use tempfile::TempDir;

/// A folder of documentation files.
#[derive(Default)]
pub struct PageFiles {
    made: Mutex<MadePage>,
}

/// Prefix of the folder's name; the id of the process follows.
const PREFIX: &str = "shaderlint-pages-";

/// Removes the folders of servers that were killed.
fn remove_left_over() {
    for entry in fs::read_dir(std::env::temp_dir())
        .into_iter()
        .flatten()
        .flatten()
    {
        let name = entry.file_name();
        let of = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
        let id = of.and_then(|of| of.split('-').next()?.parse().ok());
        if id.is_some_and(|id| !is_alive(id)) {
            // Another server may remove it at the same time.
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

#[derive(Default)]
struct MadePage {
    /// Created on first use, removed at exit.
    folder: Option<TempDir>,
    pages: HashMap<String, Option<Uri>>,
}

impl PageFiles {
    /// The URI of the documentation of a rule; `None` if there is none or the file cannot be
    /// written.
    pub fn uri(&self, rule: &str) -> Option<Uri> {
        let text = page(rule)?;
        self.write(&format!("{rule}.md"), text)
    }

    /// Writes a file next to the documentation, replacing one of the same name.
    pub fn write_anew(&self, name: &str, content: &str) -> Option<Uri> {
        self.lock().pages.remove(name);
        self.write(name, content)
    }

    /// Removes all files.
    pub fn remove(&self) {
        *self.lock() = MadePage::default();
    }

    fn write(&self, name: &str, content: &str) -> Option<Uri> {
        let mut made = self.lock();
        if let Some(known) = made.pages.get(name) {
            return known.clone();
        }
        if made.folder.is_none() {
            remove_left_over();
            let prefix = format!("{PREFIX}{}-", std::process::id());
            made.folder = tempfile::Builder::new().prefix(&prefix).tempdir().ok();
        }
        let file = made.folder.as_ref().map(|folder| folder.path().join(name));
        let written = file.filter(|file| fs::write(file, content).is_ok());
        let uri = written.map(|file| uri_of(&file.to_string_lossy()));
        made.pages.insert(name.to_string(), uri.clone());
        uri
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, MadePage> {
        self.made
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}
