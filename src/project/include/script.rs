//! The modules that a script imports: other scripts, and shaders in files of their own.

use super::find::FoundFile;
use crate::access::FileAccess;
use crate::files::FileType;
use shaderlint_detect::embed::{
    DocumentLanguage, ImportedTexts, InsertedPart, ModuleFile, ParsedScript,
};
use shaderlint_detect::kind::file_extension;
use shaderlint_text::path::tidy;
use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Maximum number of modules that lead from one to the next.
const MAX_DEPTH: usize = 8;
/// Maximum number of modules that are read for a script.
const MAX_MODULES: usize = 256;
/// Extensions that are left out in imports.
const EXTENSIONS: [&str; 6] = ["ts", "js", "tsx", "jsx", "mjs", "glsl"];

/// The modules that a script imports.
pub struct ScriptModules<'a> {
    /// Path of the script.
    from: &'a str,
    access: FileAccess<'a>,
    /// By path: the modules that were read, shared with modules that import others.
    read: &'a ModuleCache,
    depth: usize,
}

/// The modules that were read for a script.
pub type ModuleCache = RefCell<HashMap<PathBuf, Rc<ReadModule>>>;

/// A module.
pub struct ReadModule {
    file: ModuleFile,
    /// The parsed text, unless the file is a shader.
    script: Option<ParsedScript>,
}

impl<'a> ScriptModules<'a> {
    /// The modules that the script with this path imports.
    pub fn new(from: &'a str, access: FileAccess<'a>, read: &'a ModuleCache) -> ScriptModules<'a> {
        ScriptModules {
            from,
            access,
            read,
            depth: 0,
        }
    }

    /// A module by its path, which is relative to the script.
    fn read(&self, path: &str) -> Option<Rc<ReadModule>> {
        let path = path.split('?').next().filter(|p| p.starts_with('.'))?;
        let folder = Path::new(self.from).parent().unwrap_or(Path::new(""));
        let base = tidy(&folder.join(path));
        let is_file = |path: &PathBuf| self.access.files.entry(path) == Some(FileType::File);
        let file = module_files(&base).into_iter().find(is_file)?;
        if let Some(known) = self.read.borrow().get(&file) {
            return Some(known.clone());
        }
        if self.read.borrow().len() >= MAX_MODULES {
            return None;
        }
        let FoundFile {
            name, file: found, ..
        } = self.access.load(&file).ok()?;
        let text = found.text.clone();
        let is_script = DocumentLanguage::of_extension(&file_extension(&name));
        let is_script = is_script == Some(DocumentLanguage::Script);
        let module = Rc::new(ReadModule {
            script: is_script.then(|| ParsedScript::new(text.clone())),
            file: ModuleFile {
                path: name.into(),
                text,
            },
        });
        self.read.borrow_mut().insert(file, module.clone());
        Some(module)
    }
}

/// The files that an import may refer to.
pub fn module_files(base: &Path) -> Vec<PathBuf> {
    let name = base.file_name().unwrap_or_default().to_string_lossy();
    let mut all = vec![base.to_path_buf()];
    // TypeScript is imported by the name of what it is compiled to.
    if let Some(stem) = name.strip_suffix(".js") {
        all.push(base.with_file_name(format!("{stem}.ts")));
    }
    all.extend(EXTENSIONS.map(|e| base.with_file_name(format!("{name}.{e}"))));
    all.extend(EXTENSIONS.map(|e| base.join(format!("index.{e}"))));
    all
}

impl ImportedTexts for ScriptModules<'_> {
    fn text(&self, path: &str, name: &str) -> Option<InsertedPart> {
        if self.depth >= MAX_DEPTH {
            return None;
        }
        let module = self.read(path)?;
        let mut text = match &module.script {
            Some(script) => {
                let from = &*module.file.path;
                let depth = self.depth + 1;
                script.export(
                    name,
                    &ScriptModules {
                        from,
                        depth,
                        ..*self
                    },
                )?
            }
            None if name == "default" || name == "*" => InsertedPart::whole(&module.file.text),
            None => return None,
        };
        text.is_of(&module.file);
        Some(text)
    }
}
