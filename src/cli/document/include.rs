//! `#include` of neighbouring files, as bundlers resolve it.

use super::{Options, Read};
use crate::diagnostic::{Diagnostic, error};
use crate::syntax::{Lexer, RawKind};
use crate::text::{FileId, Role, Span};
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Most files that one shader may include, each time counted.
const MAX_INCLUDES: usize = 256;
/// Largest file that is included, in bytes.
const MAX_FILE: u64 = 4 * 1024 * 1024;

/// Where `#include` finds its files.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Includes {
    /// The folder that no include may leave; `None` where nothing is included.
    root: Option<PathBuf>,
}

impl Includes {
    /// Nothing is included.
    pub fn none() -> Includes {
        Includes::default()
    }

    /// Files inside this folder may be included.
    pub fn inside(root: &Path) -> Includes {
        Includes {
            root: root.canonicalize().ok(),
        }
    }

    /// Reads a file that is named in another one.
    fn load(&self, from: &str, named: &str) -> Result<(String, String), Refusal> {
        let root = self.root.as_deref().ok_or(Refusal::Missing)?;
        let folder = Path::new(from).parent().unwrap_or(Path::new(""));
        let path = tidy(&folder.join(named));
        let real = path.canonicalize().map_err(|_| Refusal::Missing)?;
        if !real.starts_with(root) {
            return Err(Refusal::Outside);
        }
        let size = fs::metadata(&real).map_err(|_| Refusal::Missing)?;
        if !size.is_file() || size.len() > MAX_FILE {
            return Err(Refusal::Missing);
        }
        let text = fs::read_to_string(&real).map_err(|_| Refusal::Missing)?;
        Ok((path.to_string_lossy().replace('\\', "/"), text))
    }
}

/// Why a file is not included.
enum Refusal {
    Missing,
    Outside,
}

/// A path without `.` and, as far as it goes, without `..`.
fn tidy(path: &Path) -> PathBuf {
    let mut tidied = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(tidied.components().next_back(), Some(Component::Normal(_))) =>
            {
                tidied.pop();
            }
            part => tidied.push(part),
        }
    }
    tidied
}

/// A shader with what it includes.
pub struct Spread {
    /// What is compiled, in order.
    pub files: Vec<FileId>,
    /// Whether a host puts in something that is not at hand.
    pub is_open: bool,
}

/// Puts files in the place of the `#include`s that name them.
pub(super) fn spread(
    read: &mut Read,
    name: &str,
    file: FileId,
    text: &str,
    options: &Options,
) -> Option<Spread> {
    let mut spread = Spread {
        files: Vec::new(),
        is_open: false,
    };
    if !text.contains("#include") && !text.contains("# include") {
        spread.files.push(file);
        return Some(spread);
    }
    let mut budget = MAX_INCLUDES;
    let mut open = vec![Open::new(name, file, text.into())];
    while let Some(last) = open.last_mut() {
        let Some(next) = last.directives.pop() else {
            let rest = last.rest()?;
            spread
                .files
                .push(read.sources.embed(last.file, last.done, rest)?);
            open.pop();
            continue;
        };
        let base = read.sources.file(last.file)?.base;
        let span = Span::new(base + next.start as u32, base + next.end as u32);
        let (from, owner) = (last.name.clone(), last.file);
        if next.is_chunk {
            spread.is_open |= options.host.preset.is_some();
            if options.host.preset.is_some() {
                let before = last.text.get(last.done..next.start)?;
                spread
                    .files
                    .push(read.sources.embed(owner, last.done, before)?);
                last.done = next.end;
            }
            continue;
        }
        let loaded = options.includes.load(&from, &next.path);
        let problem = match loaded {
            Ok((path, _)) if open.iter().any(|o| o.name == path) => {
                Some(format!("`{}` includes itself", next.path))
            }
            Ok(_) if budget == 0 => Some(format!("more than {MAX_INCLUDES} files are included")),
            Ok((path, text)) => {
                budget -= 1;
                let last = open.last_mut()?;
                let before = last.text.get(last.done..next.start)?.to_string();
                spread
                    .files
                    .push(read.sources.embed(owner, last.done, before)?);
                last.done = next.end;
                let text: Arc<str> = text.into();
                let id = read
                    .sources
                    .add(path.as_str(), None, Role::User, text.clone())?;
                open.push(Open::new(&path, id, text));
                None
            }
            Err(Refusal::Outside) => Some(format!("`{}` lies outside the project", next.path)),
            // The compiler says what it says of every directive that it does not know.
            Err(Refusal::Missing) => None,
        };
        if let Some(problem) = problem {
            let last = open.last_mut()?;
            let before = last.text.get(last.done..next.start)?.to_string();
            spread
                .files
                .push(read.sources.embed(owner, last.done, before)?);
            last.done = next.end;
            let rule = error::BAD_DIRECTIVE;
            read.problems.push(Diagnostic::error(rule, span, problem));
        }
    }
    Some(spread)
}

/// A file that is being put in.
struct Open {
    name: String,
    file: FileId,
    text: Arc<str>,
    /// What of it has been put in.
    done: usize,
    /// Its `#include`s that are to come, the last first.
    directives: Vec<Directive>,
}

impl Open {
    fn new(name: &str, file: FileId, text: Arc<str>) -> Open {
        let mut directives = directives(&text);
        directives.reverse();
        Open {
            name: tidy(Path::new(name)).to_string_lossy().replace('\\', "/"),
            file,
            text,
            done: 0,
            directives,
        }
    }

    fn rest(&self) -> Option<String> {
        self.text.get(self.done..).map(str::to_string)
    }
}

/// `#include "path"`, or `#include <chunk>`.
struct Directive {
    start: usize,
    end: usize,
    path: String,
    is_chunk: bool,
}

fn directives(text: &str) -> Vec<Directive> {
    let mut lexer = Lexer::new(text, 0);
    let mut found = Vec::new();
    let mut hash = None;
    let mut at_line_start = true;
    loop {
        let token = lexer.next_token();
        let (start, end) = (token.span.start as usize, token.span.end as usize);
        match token.kind {
            RawKind::End => return found,
            RawKind::Newline => at_line_start = true,
            RawKind::Whitespace | RawKind::BlockComment => {}
            RawKind::Hash if at_line_start => {
                hash = Some(start);
                at_line_start = false;
            }
            RawKind::Word if hash.is_some() && text.get(start..end) == Some("include") => {
                let line = text.get(end..).unwrap_or("");
                let line = line.split(['\n', '\r']).next().unwrap_or("");
                let named = line.trim_start();
                let is_chunk = named.starts_with('<');
                let close = if is_chunk { '>' } else { '"' };
                let path = named.get(1..).and_then(|n| n.split_once(close));
                if let (Some((path, _)), true) = (path, is_chunk || named.starts_with('"')) {
                    found.push(Directive {
                        start: hash.take().unwrap_or(start),
                        end: end + line.len(),
                        path: path.to_string(),
                        is_chunk,
                    });
                }
                hash = None;
            }
            _ => {
                hash = None;
                at_line_start = false;
            }
        }
    }
}
