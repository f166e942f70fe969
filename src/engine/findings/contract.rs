//! What the program around the shaders of a script sets, compared with what they declare.

use super::stage::FileCheck;
use shaderlint_contract::{Breach, NEWEST, is_library, may_make_programs};
use shaderlint_detect::embed::{DocumentLanguage, element_of, script_code};
use shaderlint_detect::kind::{FileKind, file_extension};
use shaderlint_diagnostic::{Diagnostic, Origin, Severity};
use shaderlint_host::chunk_libraries;
use shaderlint_lint::Settings;
use shaderlint_project::{FileCache, Files, installed_release, meant};
use shaderlint_rules::rule;
use shaderlint_script::{Loader, ScriptPlace};
use shaderlint_text::{FileId, Role, Span};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Extensions that imports leave out.
const EXTENSIONS: &[&str] = &[
    "",
    ".ts",
    ".js",
    ".tsx",
    ".jsx",
    ".mjs",
    "/index.ts",
    "/index.js",
    "/index.tsx",
];

/// Maximum number of bytes of a module that makes no programs; what longer ones export is not known.
const MAX_HELPER: usize = 3_000;
/// Maximum number of bytes of a module; longer ones are libraries.
const MAX_MODULE: usize = 300_000;

/// Finds modules among the files of a repository.
struct ProgramModules<'a> {
    files: &'a dyn Files,
    cache: &'a FileCache,
}

impl Loader for ProgramModules<'_> {
    fn load(&self, path: &str, from: &Path) -> Option<(PathBuf, Arc<str>)> {
        // Libraries are known by their names.
        if is_library(path) || path.contains("node_modules") {
            return None;
        }
        let top = self.cache.top(from, self.files);
        // What starts with a name is a package, unless a bundler maps it to a folder.
        let is_near = path.starts_with(['.', '/', '@', '~', '#']) || path.contains(['/', '.']);
        let all = meant(path, from, &top).into_iter().filter(|_| is_near);
        let named = all.flat_map(|path| {
            // `./a.js` may be compiled from `./a.ts`.
            let text = path.to_string_lossy().into_owned();
            let source = text
                .strip_suffix(".js")
                .map(|stem| PathBuf::from(format!("{stem}.ts")));
            let with = EXTENSIONS
                .iter()
                .map(move |e| PathBuf::from(format!("{text}{e}")));
            with.chain(source)
        });
        let mut found = named.filter_map(|path| Some((path.clone(), self.files.load(&path).ok()?)));
        let (path, text) = found.next()?;
        let is_short = text.len() <= MAX_HELPER;
        let is_read = is_short || text.len() <= MAX_MODULE && may_make_programs(&text);
        (is_read || self.script(&path, "").is_none()).then_some((path, text))
    }

    fn script(&self, path: &Path, text: &str) -> Option<String> {
        let extension = file_extension(&path.to_string_lossy());
        script_code(DocumentLanguage::of_extension(&extension)?, text)
    }

    fn element(&self, text: &str, id: &str) -> Option<Range<usize>> {
        element_of(text, id)
    }
}

/// Adds what is wrong between the program and its shaders.
pub fn report(file: &mut FileCheck) {
    let FileKind::Holds(language) = file.kind else {
        return;
    };
    let is_script = matches!(
        language,
        DocumentLanguage::Script | DocumentLanguage::Component | DocumentLanguage::Html
    );
    let text = file.report.file.and_then(|id| file.report.sources.file(id));
    let Some(text) = text.filter(|_| is_script).map(|f| f.text.clone()) else {
        return;
    };
    if !may_make_programs(&text) {
        return;
    }
    let modules = ProgramModules {
        files: file.context.files,
        cache: &file.context.options.file_cache,
    };
    let place = Path::new(file.name);
    let release = release(file, &text);
    let Some(contract) = shaderlint_contract::check((place, &text), release, &modules) else {
        return;
    };
    let mut ids: Vec<Option<FileId>> = vec![None; contract.files.len()];
    if let Some(first) = ids.first_mut() {
        *first = file.report.file;
    }
    for breach in contract.breaches {
        let mut span = |place: ScriptPlace| {
            let id = ids.get_mut(place.file)?;
            if id.is_none() {
                let (path, text) = contract.files.get(place.file)?;
                let path = path.to_string_lossy();
                let sources = Arc::make_mut(&mut file.report.sources);
                *id = sources.add(path, None, Role::User, text.clone());
            }
            let base = file.report.sources.file((*id)?)?.base;
            Some(Span::new(base + place.start, base + place.end))
        };
        let place = span(breach.place);
        let label = breach
            .label
            .as_ref()
            .and_then(|(place, text)| Some((span(*place)?, text.clone())));
        let settings = &file.context.options.settings;
        let others = &file.report.diagnostics;
        let is_known = |d: &Diagnostic| {
            let spans = || std::iter::once(d.span).chain(d.labels.iter().map(|l| l.span));
            let own = place.iter().chain(label.iter().map(|(span, _)| span));
            d.severity == Severity::Error && own.clone().any(|own| spans().any(|span| span == *own))
        };
        if others.iter().any(is_known) {
            continue;
        }
        let found = place.and_then(|place| diagnostic(breach, place, label, settings));
        file.report.diagnostics.extend(found);
    }
}

/// The release of the library of a patch that the project has, or that addresses in the script name.
fn release(file: &FileCheck, text: &str) -> Option<u32> {
    if !text.contains("onBeforeCompile") {
        return None;
    }
    let library = chunk_libraries().first()?;
    let installed = installed_release(file.name, library.package, file.context.file_access());
    let named = installed.or_else(|| library.cited_in(text).last().copied());
    // A program that imports the package and lists no version gets the newest one.
    let imports = ['"', '\'']
        .iter()
        .any(|quote| text.contains(&format!("from {quote}{}{quote}", library.package)));
    named.or(imports.then_some(NEWEST))
}

fn diagnostic(
    breach: Breach,
    place: Span,
    label: Option<(Span, String)>,
    settings: &Settings,
) -> Option<Diagnostic> {
    let mut d = match rule(breach.rule) {
        Some(rule) => {
            let severity = settings.level(rule)?;
            Diagnostic::new(rule.name, Origin::Rule, severity, place, breach.message)
        }
        None => {
            let (origin, severity) = (Origin::Compiler, Severity::Error);
            Diagnostic::new(breach.rule, origin, severity, place, breach.message)
        }
    };
    if let Some((span, text)) = label {
        d = d.label(span, text);
    }
    if let Some(note) = breach.note {
        d = d.note(note);
    }
    if let Some(help) = breach.help {
        d = d.help(help);
    }
    Some(d)
}
