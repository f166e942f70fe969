//! What is to be written, and what is to be said of it.

#[cfg(feature = "naga")]
use super::naga::Refused;
use super::order::{Destination, Order};
use super::rewrite::NotSafe;
use shaderlint_diagnostic::{Diagnostic, Origin, Severity};
use shaderlint_text::Span;
use std::fmt;
use std::path::{Path, PathBuf};

/// A file that is to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// Its path, like that of the order.
    pub path: PathBuf,
    /// What it holds.
    pub content: Vec<u8>,
}

/// What is to be written, and what is to be said of it.
#[derive(Default)]
pub struct Build {
    /// The files, the one that was asked for first.
    pub files: Vec<File>,
    /// The passes that could not be made as asked for.
    pub remarks: Vec<Remark>,
}

impl Build {
    pub(super) fn of(files: Vec<File>) -> Build {
        Build {
            files,
            remarks: Vec::new(),
        }
    }
}

/// Why nothing can be made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BuildError {
    /// Modules for three.js have no place for a cube map pass.
    Cubemap,
    /// These passes do not go into one file.
    NeedsFolder(Vec<String>),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::Cubemap => f.write_str(
                "three.js gets the Image and its buffers; this has a cube map pass. \
                 Write a module instead, with `--target module`",
            ),
            BuildError::NeedsFolder(names) => write!(
                f,
                "this has {} passes ({}); write a page, with `-o FILE.html`, or name a folder, with \
                 `-o FOLDER`",
                names.len(),
                names.join(", ")
            ),
        }
    }
}

pub(super) fn file(path: &Path, content: impl Into<Vec<u8>>) -> File {
    File {
        path: path.to_path_buf(),
        content: content.into(),
    }
}

/// What is to become a file.
pub(super) struct NamedPass {
    /// What the user calls it.
    pub name: String,
    /// What its file is called in a folder.
    pub slug: String,
    /// How that ends.
    pub ending: &'static str,
    /// What it holds.
    pub content: Vec<u8>,
}

/// One pass may become the file named; several go into a folder, under names of their own.
pub(super) fn named(order: Order, passes: Vec<NamedPass>) -> Result<Vec<File>, BuildError> {
    let folder = match order.output {
        Destination::Folder(folder) => folder,
        other if passes.len() < 2 => {
            let only = passes.into_iter().map(|p| file(other.path(), p.content));
            return Ok(only.collect());
        }
        _ => {
            let names = passes.into_iter().map(|p| p.name);
            return Err(BuildError::NeedsFolder(names.collect()));
        }
    };
    let mut files: Vec<File> = Vec::new();
    for pass in passes {
        let NamedPass { slug, ending, .. } = &pass;
        let mut path = folder.join(format!("{slug}.{ending}"));
        let mut number = 2;
        while files.iter().any(|f| f.path == path) {
            path = folder.join(format!("{slug}_{number}.{ending}"));
            number += 1;
        }
        files.push(file(&path, pass.content));
    }
    Ok(files)
}

/// What is to be said of a pass that could not be made as asked for.
pub struct Remark {
    /// What the user calls the pass.
    pub pass: String,
    /// How bad it is; nothing is written if it is an error.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// Where; empty where it is the whole pass.
    pub span: Span,
    rule: &'static str,
}

impl Remark {
    /// A pass that was to be rewritten, and is not.
    pub(super) fn kept(pass: String, reason: &NotSafe) -> Remark {
        Remark {
            pass,
            severity: Severity::Warning,
            message: format!("this stays behind the player's header: {}", reason.message),
            span: reason.span,
            rule: "kept-main",
        }
    }

    /// A pass that has no form in the language that was asked for.
    #[cfg(feature = "naga")]
    pub(super) fn refused(pass: String, reason: &Refused) -> Remark {
        Remark {
            pass,
            severity: Severity::Error,
            message: reason.message.clone(),
            span: reason.span,
            rule: "not-portable",
        }
    }

    /// The remark as a finding.
    pub fn diagnostic(&self) -> Diagnostic {
        let message = self.message.clone();
        Diagnostic::new(
            self.rule,
            Origin::Compiler,
            self.severity,
            self.span,
            message,
        )
    }
}
