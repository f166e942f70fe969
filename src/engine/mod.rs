//! The one way in: from the text of a file to what is to be said of it.
//!
//! A text is *whole* or a *part* by evidence; a host completes a part. What a shader includes, what
//! holds it (a page, a script, an export) and how it is configured is dealt with here, so that every
//! front only reads files and prints.

pub mod config;
mod document;
mod embedded;
mod export;
mod files;
mod foreign;
mod host;
mod include;
mod memo;
mod mend;
mod options;
mod part;
mod partner;
pub mod path;
mod reading;

pub use crate::semantic::Extent;
pub use document::{Report, Unread};
pub use files::{Entry, Files, LoadError, MAX_LOADED, NoFiles};
pub use include::{Absence, Includes, Missing};
pub use memo::Memo;
pub use mend::{Offer, mend, offer};
pub use options::{Desktop, DialectChoice, HostNames, HostUniform, Options};
pub use part::Shader;

use crate::semantic::Program;
use crate::text::{Content, Encoding};

/// Finds what is to be said of a text. `name` is its path, whose ending tells what it may be and
/// whose folder the files around it are looked for in.
///
/// ```
/// use shaderlint::engine::{NoFiles, Options, check};
///
/// let text = "void mainImage(out vec4 color, in vec2 place) {\n    color = vec3(1.0);\n}\n";
/// let report = check("image.glsl", text, &Options::default(), &NoFiles);
/// let [finding] = &report.diagnostics[..] else {
///     panic!("one finding")
/// };
/// assert_eq!(finding.rule, "vector-size");
/// let file = report.sources.file_at(finding.span.start).unwrap();
/// assert_eq!(file.position(finding.span.start).line, 2);
/// ```
pub fn check(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let world = World { options, files };
    document::judge(name, text, Encoding::Utf8, world)
}

/// Finds what is to be said of the bytes of a file, once they were decoded: how they were written is
/// a part of it.
pub fn check_content(
    name: &str,
    content: &Content,
    options: &Options,
    files: &dyn Files,
) -> Report {
    let world = World { options, files };
    document::judge(name, &content.text, content.encoding, world)
}

/// The shaders of a text, as they are understood, and nothing said of them: for tools that show what
/// becomes of a shader.
///
/// # Errors
/// The text is nothing that is read.
pub fn programs(
    name: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
) -> Result<Vec<Program>, Unread> {
    document::programs(name, text, World { options, files })
}

/// What a text is judged with.
#[derive(Clone, Copy)]
struct World<'a> {
    options: &'a Options,
    files: &'a dyn Files,
}
