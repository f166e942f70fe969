//! The documentation of rules and errors as files, which every editor can open.

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

    fn write(&self, name: &str, content: &str) -> Option<Uri> {
        let mut made = self.lock();
        if let Some(known) = made.pages.get(name) {
            return known.clone();
        }
        if made.folder.is_none() {
            made.folder = tempfile::Builder::new()
                .prefix("shaderlint-")
                .tempdir()
                .ok();
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
