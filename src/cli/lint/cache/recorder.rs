//! Notes what a check asks about other files, and answers it again later.

use super::super::super::disk::Disk;
use crate::engine::Options;
use crate::project::{Dependency, FileType, Files, LoadError};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use xxhash_rust::xxh3::xxh3_128;

/// A question about another file.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Deserialize, Serialize)]
pub enum Question {
    /// Its text.
    Text(PathBuf),
    /// Whether it is a file or a folder.
    Entry(PathBuf),
    /// The names in a folder.
    Names(PathBuf),
    /// Its path without symbolic links.
    Real(PathBuf),
    /// Whether it is checked in the same run.
    Checked(String),
}

/// Digests of the answers of this run, so that each file is read once.
pub struct Answers {
    disk: Disk,
    known: Mutex<HashMap<Question, u128>>,
}

impl Answers {
    /// Nothing was asked yet.
    pub fn new() -> Answers {
        Answers {
            disk: Disk::new(),
            known: Mutex::default(),
        }
    }

    /// The digest of the current answer.
    pub fn digest(&self, question: &Question, options: &Options) -> u128 {
        if let Question::Checked(name) = question {
            return options.checked.contains(name).into();
        }
        if let Some(known) = lock(&self.known).get(question) {
            return *known;
        }
        let digest = digest(question, &self.disk);
        lock(&self.known).insert(question.clone(), digest);
        digest
    }
}

fn digest(question: &Question, disk: &Disk) -> u128 {
    let answer = match question {
        Question::Text(path) => match disk.load(path) {
            Ok(text) => return xxh3_128(text.as_bytes()),
            Err(error) => format!("{error:?}"),
        },
        Question::Entry(path) => format!("{:?}", disk.entry(path)),
        Question::Names(folder) => {
            let mut names = disk.names(folder);
            // Hidden files, this cache among them, are never shaders.
            names.retain(|name| !name.starts_with('.'));
            names.sort_unstable();
            names.join("\n")
        }
        Question::Real(path) => format!("{:?}", disk.real(path)),
        Question::Checked(_) => String::new(),
    };
    xxh3_128(answer.as_bytes())
}

/// The file system, for one check.
pub struct Recorder<'a> {
    disk: &'a Disk,
    questions: Mutex<Option<BTreeSet<Question>>>,
}

impl<'a> Recorder<'a> {
    /// Nothing was asked yet.
    pub fn new(disk: &'a Disk) -> Recorder<'a> {
        Recorder {
            disk,
            questions: Mutex::new(Some(BTreeSet::new())),
        }
    }

    /// What the check asked; `None` if the result depends on too much to be kept.
    pub fn asked(self) -> Option<Vec<Question>> {
        let asked = self.questions.into_inner();
        let asked = asked.unwrap_or_else(PoisonError::into_inner)?;
        Some(asked.into_iter().collect())
    }

    fn note(&self, question: Question) {
        if let Some(asked) = lock(&self.questions).as_mut() {
            asked.insert(question);
        }
    }
}

impl Files for Recorder<'_> {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        self.note(Question::Text(path.to_path_buf()));
        self.disk.load(path)
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        self.note(Question::Entry(path.to_path_buf()));
        self.disk.entry(path)
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        self.note(Question::Names(folder.to_path_buf()));
        self.disk.names(folder)
    }

    fn here(&self) -> &Path {
        self.disk.here()
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        self.note(Question::Real(path.to_path_buf()));
        self.disk.real(path)
    }

    fn version(&self, path: &Path) -> Option<u64> {
        self.disk.version(path)
    }

    fn depends_on(&self, what: Dependency<'_>) {
        match what {
            Dependency::Text(path) => self.note(Question::Text(path.to_path_buf())),
            Dependency::Names(folder) => self.note(Question::Names(folder.to_path_buf())),
            Dependency::Checked(name) => self.note(Question::Checked(name.to_string())),
            Dependency::Repository => *lock(&self.questions) = None,
        }
    }
}

/// The content of a mutex, also after a panic of another check.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
