//! Keeps the findings of unchanged files in `.shaderlint_cache`.
//!
//! An entry is valid for one text, name, set of options and program, and as long as everything that
//! the check read elsewhere is the same. It is a file of its own, replaced as a whole, so that
//! concurrent runs never see half of one. A cache that cannot be read or written costs time only.

mod entry;
mod recorder;

pub use entry::Entry;
pub use recorder::{Answers, Recorder};

use super::super::config::absolute;
use super::super::input::InputFile;
use crate::engine::Options;
use crate::engine::config::FILE;
use crate::text::Content;
use std::collections::HashMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use xxhash_rust::xxh3::xxh3_128;

/// Name of the folder.
pub const FOLDER: &str = ".shaderlint_cache";
/// Largest entry in bytes.
const MAX_ENTRY: usize = 1 << 20;
/// Files that mark the top of a project.
const TOPS: [&str; 2] = [FILE, ".git"];
/// Tells backup programs that the folder can be made again, see `bford.info/cachedir`.
const TAG: &str = "Signature: 8a477f597d28d172789f06886806bc55\n\
    # This folder holds results of shaderlint. It can be deleted at any time.\n";

/// The cache of a project.
pub struct FindingCache {
    folder: PathBuf,
    /// What the program and the current folder contribute to every key.
    run: u128,
    /// The digest of each set of options; the options are kept, so that their address stays theirs.
    options: Mutex<HashMap<usize, (Arc<Options>, u128)>>,
    /// What the file system answered in this run.
    pub answers: Answers,
    is_broken: AtomicBool,
}

/// Where an entry is, and for what it is valid.
#[derive(Clone, Copy)]
pub struct Key {
    file: u128,
    valid_for: u128,
}

impl FindingCache {
    /// The cache of the current folder's project: the nearest folder above with a configuration or
    /// version control, or the current folder. Nothing is written yet.
    pub fn here() -> Option<FindingCache> {
        let here = std::env::current_dir().ok()?;
        let is_top = |folder: &&Path| TOPS.iter().any(|name| folder.join(name).exists());
        let top = here.ancestors().find(is_top).unwrap_or(&here);
        Some(FindingCache {
            folder: top.join(FOLDER),
            run: xxh3_128(format!("{}\n{}", program()?, here.display()).as_bytes()),
            options: Mutex::default(),
            answers: Answers::new(),
            is_broken: AtomicBool::new(false),
        })
    }

    /// The key of an input; `None` for standard input.
    pub fn key(
        &self,
        input: &InputFile,
        content: &Content,
        options: &Arc<Options>,
        readings: bool,
    ) -> Option<Key> {
        let path = absolute(input.path.as_deref()?);
        let options = self.digest(options);
        let text = xxh3_128(content.text.as_bytes());
        let about = format!(
            "{options:x} {} {:?} {:?} {readings}",
            input.name, input.claim, content.encoding
        );
        // Another text or program replaces the entry.
        let file = format!("{} {about}", path.display());
        let valid_for = format!("{:x} {text:x} {about}", self.run);
        Some(Key {
            file: xxh3_128(file.as_bytes()),
            valid_for: xxh3_128(valid_for.as_bytes()),
        })
    }

    fn digest(&self, options: &Arc<Options>) -> u128 {
        let mut known = recorder::lock(&self.options);
        let address = Arc::as_ptr(options) as usize;
        let (_, digest) = known.entry(address).or_insert_with(|| {
            let digest = xxh3_128(options.fingerprint().as_bytes());
            (options.clone(), digest)
        });
        *digest
    }

    /// The entry of a key, if everything that it depends on is still the same.
    pub fn find(&self, key: Key, options: &Options) -> Option<Entry> {
        let bytes = fs::read(self.path(key)).ok()?;
        let entry = Entry::read(&bytes, key.valid_for)?;
        let is_same = |(what, digest): &(_, u128)| self.answers.digest(what, options) == *digest;
        entry.depends_on.iter().all(is_same).then_some(entry)
    }

    /// Keeps an entry. After the first failure nothing more is written.
    pub fn keep(&self, key: Key, entry: &Entry) {
        if self.is_broken.load(Ordering::Relaxed) {
            return;
        }
        let bytes = entry.bytes(key.valid_for).filter(|b| b.len() <= MAX_ENTRY);
        let is_written = bytes.is_none_or(|bytes| self.write(key, &bytes).is_ok());
        self.is_broken.fetch_or(!is_written, Ordering::Relaxed);
    }

    fn write(&self, key: Key, bytes: &[u8]) -> std::io::Result<()> {
        let tag = self.folder.join("CACHEDIR.TAG");
        if !tag.is_file() {
            fs::create_dir_all(&self.folder)?;
            // Neither version control nor backups are to contain it.
            fs::write(self.folder.join(".gitignore"), "*\n")?;
            fs::write(tag, TAG)?;
        }
        let mut file = tempfile::NamedTempFile::new_in(&self.folder)?;
        file.write_all(bytes)?;
        file.persist(self.path(key))?;
        Ok(())
    }

    fn path(&self, key: Key) -> PathBuf {
        self.folder.join(format!("{:032x}", key.file))
    }
}

/// Identifies the program: its version, and the size and time of its file, which builds of the same
/// version differ in.
fn program() -> Option<String> {
    let data = fs::metadata(std::env::current_exe().ok()?).ok()?;
    let (version, modified) = (env!("CARGO_PKG_VERSION"), data.modified().ok()?);
    Some(format!("{version} {} {modified:?}", data.len()))
}
