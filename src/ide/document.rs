//! An open document and its analyses.

use super::index::{Index, Occurrence};
use super::symbol::{Symbol, declared_at};
use shaderlint_engine::{Analysis, Options, Report, analyze, program_name};
use shaderlint_lint::Settings;
use shaderlint_project::{FileType, Files, LoadError};
use shaderlint_semantic::{Dialect, Program, Stage, Storage};
use shaderlint_text::Span;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// A span in a file.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FileSpan {
    /// Path of the file.
    pub path: String,
    /// Offsets from the start of the file.
    pub span: Span,
}

/// The declaration of a name, independent of the shader that uses it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum SymbolOrigin {
    /// Declared in the user's text.
    Text(FileSpan),
    /// A parameter of the macro with its name at this position.
    MacroParameter(FileSpan, u32),
    /// A name that the stages of a program share: the name of the program's files, and the name.
    Interface(String, String),
    /// Built in, or declared by a host.
    Given(String),
}

/// A document and the analyses of its shaders. It is immutable; each edit creates a new one.
pub struct Document {
    /// Absolute path.
    pub path: String,
    /// Contents of the document.
    pub text: Arc<str>,
    /// Options of the check.
    pub options: Arc<Options>,
    /// Findings and analyses.
    pub report: Report,
    indexes: Vec<OnceLock<Index>>,
    /// The document with other branches of its conditional groups.
    pub(super) alternatives: OnceLock<Vec<Document>>,
}

/// A position in a shader of a document.
#[derive(Clone, Copy)]
pub struct Spot<'d> {
    /// The document.
    pub document: &'d Document,
    /// Index of the shader in the document.
    pub shader: usize,
    /// Analysis of the shader.
    pub analysis: &'d Analysis,
    /// Address of the position.
    pub address: u32,
}

impl Document {
    /// Checks a text.
    pub fn new(path: &str, text: Arc<str>, options: Arc<Options>, files: &dyn Files) -> Document {
        let report = analyze(path, &text, &options, files);
        let indexes = report.analyses.iter().map(|_| OnceLock::new()).collect();
        Document {
            path: path.to_string(),
            text,
            options,
            report,
            indexes,
            alternatives: OnceLock::new(),
        }
    }

    /// The document with another text, checked without rules.
    pub(super) fn read_as(&self, text: String, files: &dyn Files) -> Document {
        let options = Options {
            settings: Arc::new(Settings::of_rules(&[])),
            ..Options::clone(&self.options)
        };
        Document::new(&self.path, text.into(), Arc::new(options), files)
    }

    /// The shader at an offset.
    pub fn spot(&self, offset: u32) -> Option<Spot<'_>> {
        let address = self.report.address(offset)?;
        let analysis = self.report.analysis_at(address)?;
        let mut all = self.report.analyses.iter();
        let shader = all.position(|a| std::ptr::eq(a, analysis))?;
        Some(Spot {
            document: self,
            shader,
            analysis,
            address,
        })
    }

    /// The shaders with their name indices.
    pub fn shaders(&self) -> impl Iterator<Item = (&Program, &Index)> {
        let all = self.report.analyses.iter().zip(&self.indexes);
        all.map(|(analysis, index)| {
            let program: &Program = &analysis.program;
            (program, index.get_or_init(|| Index::of(program)))
        })
    }

    /// A span in one of the files of the shaders.
    pub fn place(&self, span: Span) -> Option<FileSpan> {
        if let Some(span) = self.report.in_input(span) {
            return Some(FileSpan {
                path: self.path.clone(),
                span,
            });
        }
        let sources = &self.report.sources;
        let file = sources.file_at(span.start).filter(|f| f.part.is_none())?;
        if !sources.is_user(span.start) || span.end > file.span().end {
            return None;
        }
        Some(FileSpan {
            path: file.path.clone(),
            span: Span::new(span.start - file.base, span.end - file.base),
        })
    }

    /// The declaration of a symbol.
    pub(super) fn origin(&self, program: &Program, symbol: Symbol) -> SymbolOrigin {
        let given = || SymbolOrigin::Given(symbol.name(program).to_string());
        if let Symbol::MacroParameter(of, at) = symbol {
            let place = self.place(Span::at(of));
            return place.map_or_else(given, |place| SymbolOrigin::MacroParameter(place, at));
        }
        let place = declared_at(program, symbol).and_then(|span| self.place(span));
        match place {
            Some(place) if is_linked(program, symbol) => {
                let name = symbol.name(program).to_string();
                SymbolOrigin::Interface(program_name(&place.path), name)
            }
            Some(place) => SymbolOrigin::Text(place),
            None => given(),
        }
    }
}

/// Whether stages are linked by the name of a variable: outputs of the vertex shader, and uniforms.
fn is_linked(program: &Program, symbol: Symbol) -> bool {
    let Symbol::Variable(id) = symbol else {
        return false;
    };
    let storage = program.variable(id).map(|v| v.storage);
    let is_handed_on = match program.stage {
        Stage::Vertex => storage == Some(Storage::Output),
        Stage::Fragment => storage == Some(Storage::Input),
    };
    let is_shared = is_handed_on || storage == Some(Storage::Uniform);
    is_shared && program.dialect == Dialect::WebGl
}

impl<'d> Spot<'d> {
    /// The checked program of the shader.
    pub fn program(&self) -> &'d Program {
        &self.analysis.program
    }

    /// The names of the shader.
    pub fn index(&self) -> &'d Index {
        static EMPTY: OnceLock<Index> = OnceLock::new();
        match self.document.indexes.get(self.shader) {
            Some(index) => index.get_or_init(|| Index::of(self.program())),
            None => EMPTY.get_or_init(Index::default),
        }
    }

    /// The name at the position.
    pub fn name(&self) -> Option<Occurrence> {
        self.index().at(self.address)
    }
}

/// A file system with some files replaced.
pub struct Overlay<'f> {
    /// The other files.
    pub files: &'f dyn Files,
    /// Contents of the replaced files, by absolute path.
    pub texts: BTreeMap<PathBuf, Arc<str>>,
}

impl Files for Overlay<'_> {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        match self.texts.get(path) {
            Some(text) => Ok(text.clone()),
            None => self.files.load(path),
        }
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        match self.texts.contains_key(path) {
            true => Some(FileType::File),
            false => self.files.entry(path),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        self.files.names(folder)
    }

    fn here(&self) -> &Path {
        self.files.here()
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        // A replaced file need not exist.
        let created = || {
            let folder = path.parent().filter(|_| self.texts.contains_key(path))?;
            let real = self.files.real(folder);
            Some(real.unwrap_or(folder.to_path_buf()).join(path.file_name()?))
        };
        self.files.real(path).or_else(created)
    }

    fn version(&self, path: &Path) -> Option<u64> {
        match self.texts.contains_key(path) {
            true => None,
            false => self.files.version(path),
        }
    }
}
