//! Files in memory.

use gen_lsp_types::Uri;
use shaderlint_diagnostic::ERRORS;
use shaderlint_engine::config::{Selection, options};
use shaderlint_engine::{FileType, Files, LoadError, Options};
use shaderlint_format::StyleChoice;
use shaderlint_lsp::{ConfigFinding, SampleRuns, Workspace};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files by path.
#[derive(Default)]
pub struct MemoryFiles {
    texts: BTreeMap<PathBuf, Arc<str>>,
}

impl MemoryFiles {
    /// Files with these contents.
    pub fn new(texts: &BTreeMap<PathBuf, String>) -> MemoryFiles {
        let texts = texts.iter();
        MemoryFiles {
            texts: texts
                .map(|(path, text)| (path.clone(), Arc::from(text.as_str())))
                .collect(),
        }
    }
}

impl Files for MemoryFiles {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        self.texts.get(path).cloned().ok_or(LoadError::NotFound)
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let mut inside = self.texts.range(path.to_path_buf()..);
        let (first, _) = inside.next()?;
        match first {
            first if first == path => Some(FileType::File),
            first => first.starts_with(path).then_some(FileType::Folder),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let inside = self.texts.keys();
        let names: BTreeSet<String> = inside
            .filter_map(|path| {
                let name = path.strip_prefix(folder).ok()?.components().next()?;
                Some(name.as_os_str().to_string_lossy().into_owned())
            })
            .collect();
        names.into_iter().collect()
    }

    fn here(&self) -> &Path {
        Path::new("/")
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        self.entry(path).map(|_| path.to_path_buf())
    }

    fn version(&self, _: &Path) -> Option<u64> {
        None
    }
}

/// A workspace whose files are all open, with the default options.
pub struct OpenWorkspace {
    nothing: MemoryFiles,
    /// The options of a check without and with sample runs.
    options: [Arc<Options>; 2],
    /// Address of the documentation; ends with a slash.
    site: Option<String>,
}

impl OpenWorkspace {
    /// `site` is the address of the documentation, which findings refer to.
    pub fn new(site: Option<String>) -> OpenWorkspace {
        OpenWorkspace {
            nothing: MemoryFiles::default(),
            options: [Some(0), None].map(|run_samples| {
                let selection = Selection {
                    run_samples,
                    ..Selection::default()
                };
                Arc::new(options(None, &[], &selection).unwrap_or_default())
            }),
            site,
        }
    }
}

impl Workspace for OpenWorkspace {
    fn saved(&self) -> &dyn Files {
        &self.nothing
    }

    fn options(&self, _: &Path, runs: SampleRuns) -> Option<Arc<Options>> {
        let [quick, full] = &self.options;
        Some(match runs {
            SampleRuns::Off => quick.clone(),
            SampleRuns::AsConfigured => full.clone(),
        })
    }

    fn style(&self, _: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        Ok(client)
    }

    fn leaves_out(&self, _: &Path) -> bool {
        false
    }

    fn files(&self, _: &[PathBuf]) -> Vec<PathBuf> {
        Vec::new()
    }

    fn invalid_configs(&self, _: &[PathBuf]) -> Vec<ConfigFinding> {
        Vec::new()
    }

    fn project_files(&self, _: &Path, _: &[PathBuf]) -> Vec<PathBuf> {
        Vec::new()
    }

    fn page(&self, rule: &str) -> Option<Uri> {
        let site = self.site.as_ref()?;
        let folder = match ERRORS.contains(&rule) {
            true => "errors",
            false => "rules",
        };
        Some(Uri(format!("{site}{folder}/{rule}")))
    }

    fn write_page(&self, _: &str, _: &str) -> Option<Uri> {
        None
    }

    fn renewed(&self, _: &[PathBuf]) -> Arc<dyn Workspace> {
        Arc::new(OpenWorkspace::new(self.site.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_what_files_lie_in() {
        let texts = ["/a/b.glsl", "/a-c.glsl", "/a/d/e.glsl"];
        let texts = texts.map(|path| (PathBuf::from(path), String::new()));
        let files = MemoryFiles::new(&texts.into());
        assert_eq!(files.names(Path::new("/a")), ["b.glsl", "d"]);
        assert_eq!(files.entry(Path::new("/a")), Some(FileType::Folder));
        assert_eq!(files.entry(Path::new("/a/b.glsl")), Some(FileType::File));
        assert_eq!(files.entry(Path::new("/a/b")), None);
        assert!(files.load(Path::new("/a/d/e.glsl")).is_ok());
    }
}
