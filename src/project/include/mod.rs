//! Resolves `#include` and similar directives as bundlers do: included files replace the
//! directives.

mod find;
pub mod gathered;
mod module;
mod moved;
pub mod script;
mod subject;

pub use find::{Absence, EXTENSIONS};
pub use moved::{FileMoves, moved_includes};

use crate::access::FileAccess;
use crate::dialect::has_no_chunks;
use crate::files::family::common_of;
use crate::files::scan::{Form, IncludeDirective, IncludedFile, Manner, RequestedFile};
use find::{Absent, FoundFile, is_of_package};
use module::Modules;
use shaderlint_detect::kind::is_chunk_of_library;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_host::{is_chunk as is_chunk_of_host, is_provided};
use shaderlint_text::path::{plain, slashed, tidy};
use shaderlint_text::{Edit, FileId, Role, Sources, Span};
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Maximum number of files that a shader may include, counted each time.
const MAX_INCLUDES: usize = 256;
/// Maximum number of file lookups for one shader.
const MAX_LOOKUPS: usize = 4_096;
/// Maximum number of macros that are treated as parameters of files.
const MAX_ARGUMENTS: usize = 64;

/// A shader with its includes.
pub struct Spread {
    /// The files to compile, in order.
    pub files: Vec<FileId>,
    /// Whether included code is missing.
    pub is_open: bool,
    /// Whether a program has its own way to find included files, so that it puts the shader together.
    pub is_composed: bool,
    /// Includes that were not found.
    pub missing: Vec<MissingInclude>,
    /// Findings about the directives.
    pub problems: Vec<Diagnostic>,
    /// Files whose findings are not reported here.
    pub hushed: Hushed,
}

/// The files that a script joins to a shader.
#[derive(Default)]
pub struct JoinedFiles {
    /// The files before it.
    pub before: Vec<PathBuf>,
    /// The files after it.
    pub after: Vec<PathBuf>,
    /// Whether the script joins nothing else to it.
    pub is_all: bool,
}

/// An include that was not found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MissingInclude {
    /// The directive.
    pub span: Span,
    /// The path in the directive.
    pub path: String,
    /// Folders that were searched.
    pub looked_in: Vec<String>,
    /// Why it was not included.
    pub why: Absence,
    /// A path that is nearly the same and exists.
    pub similar: Option<String>,
}

impl fmt::Display for MissingInclude {
    /// What was tried, as a note.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is {}", self.path, self.why)?;
        if !self.looked_in.is_empty() {
            write!(f, " (searched in {})", self.looked_in.join(", "))?;
        }
        match &self.similar {
            Some(path) => write!(f, "; did you mean `{path}`?"),
            None => Ok(()),
        }
    }
}

/// Files whose findings are reported elsewhere or not at all.
#[derive(Default)]
pub struct Hushed(HashMap<FileId, Hush>);

/// Which findings of a file are not reported.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hush {
    /// Findings of rules, because the file belongs to a package.
    Rules,
    /// All findings.
    All,
}

impl Hushed {
    /// Adds the files of another shader.
    pub fn extend(&mut self, others: Hushed) {
        self.0.extend(others.0);
    }

    /// Whether a finding is reported.
    pub fn admits(&self, sources: &Sources, diagnostic: &Diagnostic) -> bool {
        if self.0.is_empty() {
            return true;
        }
        let file = sources.file_id_at(diagnostic.span.start);
        match file.and_then(|id| self.0.get(&id)) {
            None => true,
            Some(Hush::Rules) => diagnostic.severity == Severity::Error,
            Some(Hush::All) => false,
        }
    }
}

/// Includes the files that directives name, the Common file of a ShaderToy project before its
/// passes, the tested file before its tests, and the files that a script puts before and after the shader.
pub fn spread(
    sources: &mut Arc<Sources>,
    (name, file, text): (&str, FileId, &str),
    joined: &JoinedFiles,
    context: FileAccess,
) -> Option<Spread> {
    let found = |path: Option<PathBuf>| path.and_then(|path| context.load(&path).ok());
    let subject = found(subject::subject_of(name, text, context));
    let common = match &subject {
        Some(subject) => common_of(&subject.name, &subject.file.text, context),
        None => common_of(name, text, context),
    };
    let tested = subject.as_ref().map(|s| &*s.file.text);
    let test_prelude = subject::test_prelude(name, text, tested);
    let mut spreader = Spreader::new(sources, name, context);
    for found in found(common).into_iter().chain(subject) {
        let is_hushed = context.is_checked(&found.name);
        spreader.put_beside(found, is_hushed)?;
    }
    let load = |path: &PathBuf| context.load(&context.relative(path)).ok();
    // What a script puts before all of them is not known, so their own findings are those without the shader.
    for found in joined.before.iter().filter_map(load) {
        spreader.put_beside(found, true)?;
    }
    if let Some(test_prelude) = test_prelude {
        let prelude = spreader.prelude(test_prelude)?;
        spreader.found.files.push(prelude);
    }
    spreader.shader(name, file, text)?;
    for found in joined.after.iter().filter_map(load) {
        spreader.put_beside(found, true)?;
    }
    Some(spreader.found)
}

/// Includes the chunks of a library that one of its chunks imports, which starts at an offset in a file.
pub fn spread_chunks(
    sources: &mut Arc<Sources>,
    (name, file): (&str, FileId),
    (chunk, start, code): (&str, usize, &str),
    context: FileAccess,
) -> Option<Spread> {
    let mut spreader = Spreader::new(sources, name, context);
    let own = Arc::new(IncludedFile::new(code.into()));
    let real = plain(&context.files.here().join(name)).join(chunk);
    spreader.open(name.to_string(), real, file, own);
    spreader.open.last_mut()?.start = start;
    spreader.run()?;
    Some(spreader.found)
}

/// Expands the includes of a shader.
struct Spreader<'r, 'w> {
    sources: &'r mut Arc<Sources>,
    context: FileAccess<'w>,
    found: Spread,
    /// The stack of files being included.
    open: Vec<OpenFile>,
    /// The files that were included.
    seen: HashMap<PathBuf, SeenFile>,
    /// The macros that some file undefines.
    undefined: BTreeSet<String>,
    /// Resolved files, by including file and path.
    known: HashMap<(String, String), FoundFile>,
    lookups: usize,
    modules: Modules,
    /// Whether the shader itself belongs to a package.
    is_in_package: bool,
    budget: usize,
    /// Whether directives for chunks of the host stay in the text.
    keeps_chunks: bool,
    /// Whether the directive stays in the text, which the host expands.
    is_left: bool,
}

/// A file on the stack.
struct OpenFile {
    name: String,
    real: PathBuf,
    file: FileId,
    /// Where the text starts in the file.
    start: usize,
    text: Arc<IncludedFile>,
    /// Length of the text that was added already.
    done: usize,
    /// Index of the next directive.
    next: usize,
    /// Whether it is included under a condition.
    is_conditional: bool,
    /// Number of open braces at the include.
    depth: u32,
    /// Text that is added after it.
    close: Option<FileId>,
}

/// The first include of a file.
#[derive(Clone, Copy)]
struct SeenFile {
    is_conditional: bool,
    is_inside: bool,
    number: usize,
}

/// How an include is expanded.
enum IncludeMode {
    Put,
    /// Inside an include guard with this number.
    Guard(usize),
    /// Omitted, because the file is included already.
    Leave,
    Circle,
}

impl<'r, 'w> Spreader<'r, 'w> {
    fn new(sources: &'r mut Arc<Sources>, name: &str, context: FileAccess<'w>) -> Self {
        Spreader {
            sources,
            context,
            found: Spread {
                files: Vec::new(),
                is_open: false,
                is_composed: false,
                missing: Vec::new(),
                problems: Vec::new(),
                hushed: Hushed::default(),
            },
            open: Vec::new(),
            seen: HashMap::new(),
            undefined: BTreeSet::new(),
            known: HashMap::new(),
            lookups: MAX_LOOKUPS,
            modules: Modules::default(),
            is_in_package: is_of_package(Path::new(name)),
            budget: MAX_INCLUDES,
            keeps_chunks: false,
            is_left: false,
        }
    }

    /// Adds the shader itself with what it includes.
    fn shader(&mut self, name: &str, file: FileId, text: &str) -> Option<()> {
        let words = ["include", "import", "glslify"];
        let own = words.iter().any(|w| text.contains(w));
        let own = own.then(|| Arc::new(IncludedFile::new(text.into())));
        let Some(own) = own.filter(|own| !own.scan.directives.is_empty()) else {
            self.found.files.push(file);
            return Some(());
        };
        let directives = &own.scan.directives;
        self.modules.expect(name, self.context, directives);
        let name = slashed(tidy(Path::new(name)));
        let real = self.context.files.real(Path::new(&name));
        let real = real.unwrap_or_else(|| PathBuf::from(&name));
        self.open(name, real, file, own);
        self.run()
    }

    /// Includes a file before or after the shader, whose findings may be reported elsewhere.
    fn put_beside(&mut self, found: FoundFile, is_hushed: bool) -> Option<()> {
        let text = found.file.text.clone();
        let seen = SeenFile {
            is_conditional: false,
            is_inside: false,
            number: self.seen.len(),
        };
        self.seen.insert(found.real.clone(), seen);
        let id = self.add(&found.name, text)?;
        if is_hushed {
            self.found.hushed.0.insert(id, Hush::All);
        }
        self.open(found.name, found.real, id, found.file);
        self.run()
    }

    fn add(&mut self, path: &str, text: impl Into<Arc<str>>) -> Option<FileId> {
        Arc::make_mut(self.sources).add(path, None, Role::User, text)
    }

    fn open(&mut self, name: String, real: PathBuf, file: FileId, text: Arc<IncludedFile>) {
        let room = MAX_ARGUMENTS.saturating_sub(self.undefined.len());
        let more = text.scan.undefined.iter().take(room);
        self.undefined.extend(more.cloned());
        self.open.push(OpenFile {
            name,
            real,
            file,
            start: 0,
            text,
            done: 0,
            next: 0,
            is_conditional: false,
            depth: 0,
            close: None,
        });
    }

    /// Expands all files on the stack. `None` if the result is too large.
    fn run(&mut self) -> Option<()> {
        while let Some(last) = self.open.last_mut() {
            let directive = last.text.scan.directives.get(last.next).cloned();
            last.next += 1;
            let Some(directive) = directive else {
                let rest = last.text.text.get(last.done..)?;
                let at = last.start + last.done;
                let piece = Arc::make_mut(self.sources).embed(last.file, at, rest)?;
                self.found.files.push(piece);
                self.found.files.extend(last.close);
                self.open.pop();
                continue;
            };
            let before = last.text.text.get(last.done..directive.start)?;
            let at = last.start + last.done;
            let piece = Arc::make_mut(self.sources).embed(last.file, at, before)?;
            self.found.files.push(piece);
            // The host inserts its chunks, which show who it is.
            let stays = self.keeps_chunks && directive.requested.manner == Manner::Chunk;
            last.done = directive.end;
            let base = self.sources.file(last.file)?.base + last.start as u32;
            let span = Span::new(base + directive.start as u32, base + directive.end as u32);
            let from = last.name.clone();
            let missing = self.found.is_open;
            self.found.is_open = false;
            self.directive(&from, &directive, span)?;
            let stays = stays && self.found.is_open || std::mem::take(&mut self.is_left);
            if let (true, Some(last)) = (stays, self.open.last_mut()) {
                last.done = directive.start;
            }
            self.found.is_open |= missing;
        }
        Some(())
    }

    fn directive(&mut self, from: &str, directive: &IncludeDirective, span: Span) -> Option<()> {
        let requested = &directive.requested;
        let is_chunk = requested.manner == Manner::Chunk && self.context.host.is_some();
        // The host inserts what the file contains.
        if requested.manner == Manner::Chunk && is_provided(&requested.path) {
            self.found.is_open |= self.keeps_chunks;
            return Some(());
        }
        if is_chunk && !requested.path.contains(['/', '.']) {
            self.found.is_open = true;
            return Some(());
        }
        let found = match self.find(from, requested) {
            Ok(found) => found,
            Err(_) if requested.manner == Manner::Chunk && is_chunk_of_host(&requested.path) => {
                (self.is_left, self.found.is_open) = (true, self.keeps_chunks);
                return Some(());
            }
            Err(_) if is_chunk => {
                self.found.is_open = true;
                return Some(());
            }
            Err(absent) => {
                // The host may have no chunk with that name.
                self.is_left = requested.manner == Manner::Chunk;
                // A module adds nothing but the name that it is given.
                self.found.is_open |= directive.form == Form::Put;
                self.miss(span, &requested.path, absent);
                return Some(());
            }
        };
        match &directive.form {
            Form::Put => self.put(found, directive, span),
            Form::Require(name, arguments) => self.require(found, name, arguments, span),
        }
    }

    fn find(&mut self, from: &str, requested: &RequestedFile) -> Result<FoundFile, Absent> {
        let key = (from.to_string(), requested.path.clone());
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        if self.budget == 0 || self.lookups == 0 {
            return Err(Absent::too_many());
        }
        self.lookups -= 1;
        let found = self.context.find(from, requested);
        let found = found.or_else(|absent| self.elsewhere(from, requested).ok_or(absent))?;
        self.known.insert(key, found.clone());
        Ok(found)
    }

    /// Searches the repository for a file that is not where its path says, unless the host may insert it. A file
    /// does not include itself.
    fn elsewhere(&self, from: &str, requested: &RequestedFile) -> Option<FoundFile> {
        let is_chunk = requested.manner == Manner::Chunk;
        let is_host_used = || !has_no_chunks(from, self.context);
        let may_be_of_host =
            self.context.host.is_some() || is_chunk_of_host(&requested.path) && is_host_used();
        if is_chunk && may_be_of_host {
            return None;
        }
        let found = match is_chunk_of_library(&requested.path) {
            true => self.context.chunk(from, &requested.path)?,
            false => self.context.elsewhere(from, requested)?,
        };
        let is_own = |open: &OpenFile| open.real == found.real && found.outer.is_none();
        (!self.open.iter().any(is_own)).then_some(found)
    }

    fn miss(&mut self, span: Span, path: &str, absent: Absent) {
        // A path may also belong to the host or to a bundler.
        if let Some(similar) = &absent.similar {
            let message = format!("`{path}` is not found");
            let problem = Diagnostic::of(error::BAD_DIRECTIVE, Severity::Warning, span, message);
            let written = self.sources.text(span);
            let fix = written.find(path).map(|at| {
                let start = span.start + at as u32;
                let span = Span::new(start, start + path.len() as u32);
                let title = format!("replace with `{similar}`");
                Fix::suggestion(title, vec![Edit::replace(span, similar.as_str())])
            });
            let problem = problem.help(format!("did you mean `{similar}`?")).fix(fix);
            self.found.problems.push(problem);
        }
        self.found.missing.push(MissingInclude {
            span,
            path: path.to_string(),
            looked_in: absent.looked_in,
            why: absent.why,
            similar: absent.similar,
        });
    }

    fn put(&mut self, found: FoundFile, directive: &IncludeDirective, span: Span) -> Option<()> {
        let (is_conditional, depth) = self.open.last().map_or((false, 0), |last| {
            let is_conditional = last.is_conditional || directive.is_conditional;
            (is_conditional, last.depth + directive.depth)
        });
        let mut close = None;
        let way = self.way(&found, is_conditional, depth);
        match way {
            IncludeMode::Leave => return Some(()),
            IncludeMode::Put | IncludeMode::Guard(_) if self.budget == 0 => {
                self.found.is_open = true;
                self.miss(span, &directive.requested.path, Absent::too_many());
                return Some(());
            }
            // A library that imports itself in a circle leaves the second copy out.
            IncludeMode::Circle if found.outer.is_some() => return Some(()),
            IncludeMode::Circle => {
                let message = format!("`{}` includes itself", directive.requested.path);
                let problem = Diagnostic::error(error::BAD_DIRECTIVE, span, message);
                self.found.problems.push(problem);
                return Some(());
            }
            IncludeMode::Put => {}
            IncludeMode::Guard(number) => {
                let name = format!("shaderlint_once_{number}");
                let open = format!("#ifndef {name}\n#define {name}\n");
                let open = self.prelude(&open)?;
                self.found.files.push(open);
                close = Some(self.prelude("\n#endif\n")?);
            }
        }
        self.budget -= 1;
        let (start, text) = found.outer.unwrap_or((0, found.file.text.clone()));
        let id = self.add(&found.name, text)?;
        let is_hushed = |open: &OpenFile| self.found.hushed.0.get(&open.file) == Some(&Hush::All);
        self.found.is_composed |= found.is_elsewhere;
        if found.is_elsewhere || self.open.last().is_some_and(is_hushed) {
            // What its program puts before it is not known, so its findings are those without the shader.
            self.found.hushed.0.insert(id, Hush::All);
        } else if is_of_package(Path::new(&found.name)) && !self.is_in_package {
            self.found.hushed.0.insert(id, Hush::Rules);
        }
        self.open(found.name, found.real, id, found.file);
        let last = self.open.last_mut()?;
        (last.is_conditional, last.depth, last.close) = (is_conditional, depth, close);
        last.start = start;
        Some(())
    }

    fn prelude(&mut self, text: &str) -> Option<FileId> {
        Arc::make_mut(self.sources).add("", None, Role::Prelude, text)
    }

    /// Bundlers differ in how they treat a file that is included twice. A second copy that would
    /// only repeat declarations is never intended.
    fn way(&mut self, found: &FoundFile, is_conditional: bool, depth: u32) -> IncludeMode {
        let scan = &found.file.scan;
        let is_safe = scan.is_guarded || scan.is_once;
        if self.open.iter().any(|o| o.real == found.real) {
            return if is_safe {
                IncludeMode::Leave
            } else {
                IncludeMode::Circle
            };
        }
        let is_given = |name: &String| {
            let is_own = scan.defined.contains(name);
            !is_own && found.file.text.contains(name.as_str())
        };
        // Macros that change between the copies are parameters of the file.
        let own = scan.undefined.iter().take(MAX_ARGUMENTS);
        let takes = own.chain(&self.undefined);
        let is_template = !is_safe && takes.into_iter().any(is_given);
        let now = SeenFile {
            is_conditional,
            is_inside: depth > 0,
            number: self.seen.len(),
        };
        let known = self.seen.entry(found.real.clone()).or_insert(now);
        let seen = *known;
        known.is_conditional &= is_conditional;
        let is_first = seen.number == now.number;
        let declares = scan.declares || !(seen.is_inside || now.is_inside);
        if is_template || !(is_safe || declares) {
            return IncludeMode::Put;
        }
        if !is_first && !seen.is_conditional {
            return IncludeMode::Leave;
        }
        // Conditions are not evaluated yet, so the first copy may be inactive.
        match scan.is_guarded || (is_first && !is_conditional) {
            true => IncludeMode::Put,
            false => IncludeMode::Guard(seen.number),
        }
    }

    /// Includes a glslify module under a name.
    fn require(
        &mut self,
        found: FoundFile,
        name: &str,
        arguments: &[(String, String)],
        span: Span,
    ) -> Option<()> {
        if self.budget == 0 {
            self.found.is_open = true;
            return Some(());
        }
        let made = self
            .modules
            .put(&found, arguments, Some(name), self.context);
        self.found.is_open |= self.modules.is_open || made.is_none();
        for (path, absent) in std::mem::take(&mut self.modules.missing) {
            self.found.is_open = true;
            self.miss(span, &path, absent);
        }
        match made {
            Some((text, _)) if !text.is_empty() => {
                self.budget -= 1;
                let id = self.add(&found.name, text)?;
                // The text differs from the file.
                self.found.hushed.0.insert(id, Hush::All);
                self.found.files.push(id);
            }
            _ => {}
        }
        Some(())
    }
}
