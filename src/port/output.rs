//! Output files, and remarks about passes.

#[cfg(feature = "naga")]
use super::naga::Refused;
use super::order::{Destination, Order};
use super::rewrite::NotSafe;
use shaderlint_diagnostic::{Diagnostic, Origin, Severity};
use shaderlint_text::Span;
use std::fmt;
use std::path::{Path, PathBuf};

/// An output file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// The path to write, relative like the path of the order.
    pub path: PathBuf,
    /// The content.
    pub content: Vec<u8>,
}

/// The result of a build.
#[derive(Default)]
pub struct Build {
    /// The files; the requested one comes first.
    pub files: Vec<File>,
    /// Remarks about passes that could not be built as requested.
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

/// Why a build fails.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BuildError {
    /// The project has a cube map pass, which modules for three.js do not support.
    Cubemap,
    /// The module for WebGPURenderer does not support something of the project.
    #[cfg(feature = "naga")]
    NoWebGpu(String),
    /// Several passes, with these names, cannot be written to one file.
    NeedsFolder(Vec<String>),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::Cubemap => f.write_str(
                "three.js modules do not support cube map passes; use `--target module` instead",
            ),
            #[cfg(feature = "naga")]
            BuildError::NoWebGpu(reason) => f.write_str(reason),
            BuildError::NeedsFolder(names) => write!(
                f,
                "the project has {} passes ({}); use `-o FILE.html` for a page, or `-o FOLDER` for \
                 several files",
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

/// A shader to be written.
pub(super) struct NamedPass {
    /// The name shown to the user.
    pub name: String,
    /// The file name in a folder, without extension.
    pub slug: String,
    /// The file extension.
    pub extension: &'static str,
    /// The content of the file.
    pub content: Vec<u8>,
}

/// A single pass is written to the output file; several passes go into a folder, with generated
/// names.
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
        let NamedPass {
            slug, extension, ..
        } = &pass;
        let mut path = folder.join(format!("{slug}.{extension}"));
        let mut number = 2;
        while files.iter().any(|f| f.path == path) {
            path = folder.join(format!("{slug}_{number}.{extension}"));
            number += 1;
        }
        files.push(file(&path, pass.content));
    }
    Ok(files)
}

/// A remark about a pass that could not be built as requested.
pub struct Remark {
    /// The name of the pass.
    pub pass: String,
    /// The severity; nothing is written after an error.
    pub severity: Severity,
    /// The text of the remark.
    pub message: String,
    /// The span of the cause; empty for the whole pass.
    pub span: Span,
    rule: &'static str,
}

impl Remark {
    /// `mainImage` was not rewritten.
    pub(super) fn kept(pass: String, reason: &NotSafe) -> Remark {
        Remark {
            pass,
            severity: Severity::Warning,
            message: format!("`mainImage` was not rewritten: {}", reason.message),
            span: reason.span,
            rule: "kept-main",
        }
    }

    /// A host lacks something that a pass uses.
    pub(super) fn missing(pass: String, span: Span, message: String) -> Remark {
        Remark {
            pass,
            severity: Severity::Error,
            message,
            span,
            rule: "not-portable",
        }
    }

    /// A host draws a pass in a slightly different way.
    pub(super) fn differs(pass: String, span: Span, message: String) -> Remark {
        Remark {
            severity: Severity::Warning,
            ..Remark::missing(pass, span, message)
        }
    }

    /// A pass cannot be translated to the target language.
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

    /// The remark as a diagnostic.
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
