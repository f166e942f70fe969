//! The contracts of the scripts around shaders, each evaluated once.

use crate::options::Options;
use shaderlint_contract::{Contract, NEWEST, is_library, may_make_programs};
use shaderlint_detect::embed::{DocumentLanguage, element_of, script_code, script_files};
use shaderlint_detect::kind::{file_extension, made};
use shaderlint_host::chunk_libraries;
use shaderlint_project::{FileAccess, FileCache, Files, installed_release, meant};
use shaderlint_script::{ExternalScript, Loader};
use shaderlint_text::path::plain;
use std::collections::HashMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, MutexGuard, PoisonError};

/// Maximum number of contracts that are kept.
const MAX_KEPT: usize = 64;
/// Maximum number of scripts around a shader file that are evaluated.
const MAX_AROUND: usize = 4;
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
        // What a bundler or minifier wrote is a library.
        let is_own = is_read && made(&text).is_none();
        (is_own || self.script(&path, "").is_none()).then_some((path, text))
    }

    fn script(&self, path: &Path, text: &str) -> Option<String> {
        let extension = file_extension(&path.to_string_lossy());
        script_code(DocumentLanguage::of_extension(&extension)?, text)
    }

    fn element(&self, text: &str, id: &str) -> Option<(Range<usize>, String)> {
        element_of(text, id)
    }

    fn scripts(&self, path: &Path, text: &str) -> Vec<ExternalScript> {
        if !is_page(&path.to_string_lossy()) {
            return Vec::new();
        }
        let files = script_files(text).into_iter();
        let own = files.filter(|(_, path, _)| !path.contains("//"));
        own.map(|(at, path, is_module)| ExternalScript {
            at,
            // A path without a dot is no package here.
            path: match path.starts_with(['.', '/']) {
                true => path.to_string(),
                false => format!("./{path}"),
            },
            is_module,
        })
        .collect()
    }
}

/// Whether a file is a page.
fn is_page(path: &str) -> bool {
    DocumentLanguage::of_extension(&file_extension(path)) == Some(DocumentLanguage::Html)
}

/// Whether a file may contain scripts.
fn is_script(path: &str) -> bool {
    let language = DocumentLanguage::of_extension(&file_extension(path));
    matches!(
        language,
        Some(DocumentLanguage::Script | DocumentLanguage::Component | DocumentLanguage::Html)
    )
}

/// The contracts that are kept, by the paths of their scripts.
fn kept(options: &Options) -> MutexGuard<'_, HashMap<PathBuf, Arc<Contract>>> {
    let all = options.contracts.lock();
    all.unwrap_or_else(PoisonError::into_inner)
}

/// The contract of the program that starts with a script, which is evaluated unless it is known.
pub fn contract(
    path: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
) -> Option<Arc<Contract>> {
    if !is_script(path) {
        return None;
    }
    let place = Path::new(path);
    let modules = ProgramModules {
        files,
        cache: &options.file_cache,
    };
    let makes_programs = |script: &ExternalScript| {
        let found = modules.load(&script.path, place);
        found.is_some_and(|(_, text)| may_make_programs(&text))
    };
    let is_program =
        may_make_programs(text) || modules.scripts(place, text).iter().any(makes_programs);
    if !is_program {
        return None;
    }
    let known = kept(options).get(place).cloned();
    let is_same = |(path, text): &(PathBuf, Arc<str>)| files.load(path).is_ok_and(|t| t == *text);
    let is_current = |contract: &Arc<Contract>| match contract.files.split_first() {
        Some((root, modules)) => *root.1 == *text && modules.iter().all(is_same),
        None => false,
    };
    if let Some(known) = known.filter(is_current) {
        return Some(known);
    }
    let release = release(path, text, options.file_access(files));
    let found = shaderlint_contract::check((place, text), release, &modules);
    let found = Arc::new(found?);
    let mut all = kept(options);
    if all.len() >= MAX_KEPT {
        all.clear();
    }
    all.insert(place.to_path_buf(), found.clone());
    Some(found)
}

/// The contracts of the programs that a file is in: its own if it is a script, and those of the scripts that
/// import a shader file.
pub fn contracts(
    path: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
) -> Vec<Arc<Contract>> {
    if is_script(path) {
        return contract(path, text, options, files).into_iter().collect();
    }
    let file = plain(&files.here().join(path));
    let importers = options.file_cache.importers(&file, files);
    contracts_of(&importers, options, files)
}

/// The contracts of the first of some scripts.
fn contracts_of(scripts: &[PathBuf], options: &Options, files: &dyn Files) -> Vec<Arc<Contract>> {
    let found = scripts.iter().filter_map(|script| {
        let text = files.load(script).ok()?;
        contract(&script.to_string_lossy(), &text, options, files)
    });
    found.take(MAX_AROUND).collect()
}

/// The contracts of the programs that a file is in, with those of scripts that were evaluated before: which these
/// are depends on what was checked.
pub fn known_contracts(
    path: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
) -> Vec<Arc<Contract>> {
    let mut found = contracts(path, text, options, files);
    let is_in = |(root, contract): &(&PathBuf, &Arc<Contract>)| {
        let mut modules = contract.files.iter().skip(1);
        let is_new = found
            .iter()
            .all(|known| known.files.first().is_none_or(|f| f.0 != **root));
        is_new && modules.any(|(module, _)| *module == *Path::new(path))
    };
    let all = kept(options);
    let roots = all.iter().filter(is_in).map(|(root, _)| root.clone());
    let mut roots: Vec<PathBuf> = roots.collect();
    // Evaluating them asks for it again.
    drop(all);
    roots.sort();
    found.extend(contracts_of(&roots, options, files));
    found
}

/// The release of the library of a patch or colour that the project has, or that addresses in the script name.
fn release(path: &str, text: &str, access: FileAccess) -> Option<u32> {
    if !text.contains("onBeforeCompile") && !text.contains("Color(") {
        return None;
    }
    let library = chunk_libraries().first()?;
    let installed = installed_release(path, library.package, access);
    let named = installed.or_else(|| library.cited_in(text).last().copied());
    // A program that imports the package and lists no version gets the newest one.
    let imports = ['"', '\'']
        .iter()
        .any(|quote| text.contains(&format!("from {quote}{}{quote}", library.package)));
    named.or(imports.then_some(NEWEST))
}
