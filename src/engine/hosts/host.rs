//! Detects the hosts that may complete a text: by the names that it lacks, by imports of the
//! surrounding script, and by the packages of its project.

use crate::check_context::CheckContext;
use crate::scripted::{ScriptedValue, scripted};
use crate::shader::reading::Readings;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_detect::embed::{
    AskedWebGl, DocumentLanguage, Embedded, Mention, MentionKind, NameRole, ParsedScript,
    ShaderReceiver, lists, mentions,
};
use shaderlint_detect::kind::{file_extension, has_main};
use shaderlint_host::{ChunkLibrary, Preset, presets};
use shaderlint_project::{
    FileType, JoinedFiles, NamesForOthers, counts, hash, imported_hosts, installed_hosts,
    installed_release, macros, meant, uses_installed,
};
use shaderlint_text::path::plain;
use std::cell::{LazyCell, OnceCell};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Maximum number of hosts that a text is checked for.
const MAX_HOSTS: usize = 4;
/// Maximum number of scripts that import a file and are read.
const MAX_IMPORTERS: usize = 8;
/// Maximum number of texts in a list that a script joins.
const MAX_JOINED: usize = 16;

/// Detects the hosts for the texts of one file.
pub struct Hosts<'a> {
    name: &'a str,
    /// The page or script that contains the texts.
    script: Option<Arc<str>>,
    /// The scripts that import the file, with their texts; computed on first use.
    importers: OnceCell<Vec<(PathBuf, Arc<str>)>>,
    /// How often each word appears in the script, by hash; computed on first use.
    counts: OnceCell<FxHashMap<u64, usize>>,
    /// The names that the script may declare for its shaders, by hash, and whether it puts declarations
    /// together; computed on first use.
    given: OnceCell<(FxHashSet<u64>, bool)>,
    /// Whether the script may ask for WebGL1 alone; computed on first use.
    may_be_webgl1: OnceCell<bool>,
    /// What the scripts ask WebGL for; computed on first use.
    asked_webgl: OnceCell<AskedWebGl>,
    context: CheckContext<'a>,
    /// The hosts that the script imports; computed on first use.
    imported: OnceCell<Vec<&'static Preset>>,
    /// The hosts among the packages of the project; computed on first use.
    installed: OnceCell<Vec<&'static Preset>>,
    /// The release of the library whose chunks the texts include; computed on first use.
    release: OnceCell<Option<u32>>,
}

/// How scripts hand a shader to a host.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Handed {
    /// The host.
    pub host: &'static Preset,
    /// Whether the host adds nothing to the shader.
    pub is_bare: bool,
    /// Whether the scripts ask for GLSL ES 3.00.
    pub is_300: bool,
}

/// The host among some to which a receiver belongs.
fn handed_to(receiver: &ShaderReceiver, around: &[&'static Preset]) -> Option<Handed> {
    let has = |names: &[String]| names.contains(&receiver.name);
    let host = *around.iter().find(|p| has(&p.complete) || has(&p.bare))?;
    let mut set = receiver.beside.iter();
    Some(Handed {
        host,
        is_bare: has(&host.bare),
        is_300: match host.glsl.as_slice() {
            [key, new] => {
                set.any(|(name, value)| name == key && [new, "300 es"].contains(&value.as_str()))
            }
            _ => false,
        },
    })
}

impl<'a> Hosts<'a> {
    /// For a file with this name, which may be a script or page.
    pub fn new(name: &'a str, script: Option<Arc<str>>, context: CheckContext<'a>) -> Hosts<'a> {
        Hosts {
            name,
            script,
            importers: OnceCell::new(),
            counts: OnceCell::new(),
            given: OnceCell::new(),
            may_be_webgl1: OnceCell::new(),
            asked_webgl: OnceCell::new(),
            context,
            imported: OnceCell::new(),
            installed: OnceCell::new(),
            release: OnceCell::new(),
        }
    }

    /// The hosts that may complete a text that lacks some names: hosts that alone declare one of
    /// them, otherwise those of the script and of the project. The flag says whether the names
    /// determined the hosts.
    pub fn of(
        &self,
        lacking: &BTreeSet<String>,
        readings: &Readings,
    ) -> (Vec<&'static Preset>, bool) {
        let some = |all: &mut dyn Iterator<Item = &'static Preset>| -> Vec<_> {
            all.filter(|p| readings.may_host(p))
                .take(MAX_HOSTS)
                .collect()
        };
        // Scripts that import a part of a shader put it together.
        let is_called = readings.holds_entry() || self.script.is_some();
        let imported = if is_called { self.imported() } else { &[] };
        let installed = self.installed().iter();
        let others = installed.filter(|p| !imported.iter().any(|i| i.name == p.name));
        let around: Vec<_> = imported.iter().chain(others).copied().collect();
        let around = || around.iter().copied();
        // A function that only this host calls.
        let calls = |p: &&Preset| p.entries.iter().any(|e| e != "main" && readings.defines(e));
        let by_entry = some(&mut around().filter(calls));
        if !by_entry.is_empty() {
            return (by_entry, true);
        }
        // A program of its own does not run in a site or a tool.
        let is_program = LazyCell::new(|| self.is_in_program());
        let may_run = |p: &Preset| !p.packages.is_empty() || !p.globals.is_empty() || !*is_program;
        // Names alone do not show another library than those that the program uses.
        let has_library = around().any(|p| !p.packages.is_empty());
        let is_around = |p: &Preset| {
            let is_base = |of: &Preset| of.base.as_ref() == Some(&p.name);
            around().any(|of| of.name == p.name || is_base(of))
        };
        let may_be_used = |p: &Preset| !has_library || p.packages.is_empty() || is_around(p);
        let named = |p: &&Preset| {
            lacking.iter().any(|name| p.has_word(name)) && may_run(p) && may_be_used(p)
        };
        let by_word = some(&mut presets().filter(named));
        if !by_word.is_empty() {
            return (by_word, true);
        }
        let inserts = |p: &&Preset| readings.chunks().iter().any(|name| p.chunk(name).is_some());
        let by_chunk = some(&mut around().filter(inserts));
        match readings.chunks() {
            [] => (some(&mut around()), false),
            _ if by_chunk.is_empty() => (
                some(&mut presets().filter(|p| p.base.is_none() && inserts(p))),
                true,
            ),
            _ => (by_chunk, true),
        }
    }

    /// How the scripts around a text hand it to a host that they use, if all do so in the same way.
    pub fn handed(&self, embedded: Option<&Embedded>) -> Option<Handed> {
        let receives = |p: &&Preset| !p.complete.is_empty() || !p.bare.is_empty();
        let around = match &self.script {
            Some(_) => self.imported(),
            None => self.installed(),
        };
        if !around.iter().any(receives) {
            return None;
        }
        let all = match embedded {
            Some(shader) => shader.receivers.clone(),
            None => self.receivers()?,
        };
        let mut all = all.iter().map(|receiver| handed_to(receiver, around));
        let first = all.next()??;
        all.all(|other| other.as_ref() == Some(&first))
            .then_some(first)
    }

    /// To what the scripts that import the file hand it, if all hand it on unchanged.
    fn receivers(&self) -> Option<Vec<ShaderReceiver>> {
        let all = self.importers().iter();
        let all = all.map(|(path, text)| self.receivers_in(path, text));
        Some(all.collect::<Option<Vec<_>>>()?.concat())
    }

    /// The release of the library whose chunks a text includes: the one that the project has, or that the addresses
    /// in the script around the text name. `None` also if these differ.
    pub fn release(&self, host: &Preset, readings: &Readings) -> Option<u32> {
        *self.release.get_or_init(|| {
            let library = host.chunk_library()?;
            let script = self.script.as_ref();
            let may_use = script.is_none_or(|text| uses_installed(text, host, library.package));
            let installed =
                installed_release(self.name, library.package, self.context.file_access());
            let installed = installed.filter(|_| may_use);
            // The scripts that import a file are searched only if they decide.
            let is_asked = script.is_some() || installed.is_none() && readings.holds_entry();
            let scripts = if is_asked { self.scripts() } else { Vec::new() };
            let cited = scripts.iter().flat_map(|(_, text)| library.cited_in(text));
            let all: BTreeSet<u32> = cited.chain(installed).collect();
            all.first().copied().filter(|_| all.len() == 1)
        })
    }

    /// Whether the script adds a chunk to a library, or another file of the program if that is asked for; `*`
    /// is one that it does not name.
    pub fn adds_chunk(&self, library: &ChunkLibrary, chunk: &str, is_anywhere: bool) -> bool {
        let member = library.member(chunk);
        let script = self.script.as_ref();
        script.is_some_and(|text| library.added_in(text).contains(&member))
            || is_anywhere && self.is_used_outside(&member, 0)
    }

    /// The path of the file.
    pub fn name(&self) -> &'a str {
        self.name
    }

    /// The environment of the check.
    pub fn context(&self) -> CheckContext<'a> {
        self.context
    }

    /// The scripts around the texts: the one that contains them, or those that import the file.
    fn scripts(&self) -> Vec<(&Path, &str)> {
        match &self.script {
            Some(text) => vec![(Path::new(self.name), text)],
            None => self
                .importers()
                .iter()
                .map(|(path, text)| (path.as_path(), &**text))
                .collect(),
        }
    }

    /// The values that the scripts around the texts give their uniforms.
    pub fn scripted(&self) -> Vec<ScriptedValue> {
        let text = self.script.as_deref().unwrap_or("");
        scripted(self.name, text, self.context.options, self.context.files)
    }

    /// What the scripts around the texts ask WebGL for. They are read only for shaders that an extension
    /// concerns, or if they may ask for WebGL1 alone.
    pub fn asked_webgl(&self, is_concerned: impl Fn() -> bool) -> Option<&AskedWebGl> {
        let is_needed = match &self.script {
            Some(text) => {
                let may_be_webgl1 = || AskedWebGl::may_be_only_one(text);
                *self.may_be_webgl1.get_or_init(may_be_webgl1) || is_concerned()
            }
            None => is_concerned() && self.is_imported(),
        };
        if !is_needed {
            return None;
        }
        Some(self.asked_webgl.get_or_init(|| {
            let language = |path: &Path| {
                DocumentLanguage::of_extension(&file_extension(&path.to_string_lossy()))
            };
            let scripts = self.scripts().into_iter();
            let all =
                scripts.filter_map(|(path, text)| Some(AskedWebGl::of(language(path)?, text)));
            let joined = all.reduce(|mut one, other| {
                one.join(other);
                one
            });
            joined.unwrap_or_default()
        }))
    }

    /// The scripts that import the file, with their texts.
    fn importers(&self) -> &[(PathBuf, Arc<str>)] {
        self.importers.get_or_init(|| {
            let files = self.context.files;
            let cache = &self.context.options.file_cache;
            let all = cache
                .importers(&self.file(), files)
                .into_iter()
                .take(MAX_IMPORTERS);
            all.filter_map(|path| Some((path.clone(), files.load(&path).ok()?)))
                .collect()
        })
    }

    /// Whether the text belongs to a program: it is in a script or page, or scripts import it.
    fn is_in_program(&self) -> bool {
        let language = DocumentLanguage::of_extension(&file_extension(self.name));
        match language {
            Some(DocumentLanguage::Markdown | DocumentLanguage::Kdl) => false,
            Some(_) => true,
            None => self.is_imported(),
        }
    }

    /// Whether scripts import the file.
    pub fn is_imported(&self) -> bool {
        self.script.is_none() && !self.importers().is_empty()
    }

    /// Whether this host gives the texts no other names: the script that contains them says so, or all that
    /// import the file hand it on unchanged.
    pub fn is_complete(&self, host: &Preset, readings: &Readings) -> bool {
        match &self.script {
            Some(script) => host.is_complete_in(script),
            None if host.is_complete => true,
            None if !readings.holds_entry() && !readings.is_called => false,
            None => {
                let all = self.importers();
                let is_handed = |(_, text): &(PathBuf, Arc<str>)| host.is_complete_in(text);
                let is_known = |r: &ShaderReceiver| host.is_complete_for(&r.name);
                let received = self.receivers().filter(|_| all.iter().all(is_handed));
                received.is_some_and(|all| !all.is_empty() && all.iter().all(is_known))
            }
        }
    }

    /// To what a script hands the file, if it hands it on unchanged.
    fn receivers_in(&self, path: &Path, text: &Arc<str>) -> Option<Vec<ShaderReceiver>> {
        let file = self.file();
        let top = self
            .context
            .options
            .file_cache
            .top(path, self.context.files);
        let is_file = |import: &str| meant(import, path, &top).contains(&file);
        let all = ParsedScript::new(text.clone()).receivers(is_file);
        // A script that does not use its import exports it.
        all.filter(|all| !all.is_empty())
    }

    /// Whether a word is used outside of a text that uses it `count` times: in the surrounding
    /// script, or in another file of the repository.
    pub fn is_used_outside(&self, word: &str, count: usize) -> bool {
        if self.is_in_script(word, count) {
            return true;
        }
        let files = self.context.files;
        let file = self.file();
        let (is_elsewhere, is_all) = self
            .context
            .options
            .file_cache
            .is_elsewhere(word, &file, files);
        // Files that were not read may declare it.
        is_elsewhere || !is_all
    }

    /// Whether a script around the text gives a value for a name that it inserts as a macro.
    pub fn is_given(&self, name: &str) -> bool {
        let gives = |text: &str| text.contains("define") && macros(text).contains(&name);
        self.scripts().iter().any(|(_, text)| gives(text))
    }

    /// Whether the scripts around a complete text that uses a word `count` times may declare it.
    pub fn may_be_declared_in_script(&self, word: &str, count: usize) -> bool {
        let (declared, writes) = self.given.get_or_init(|| {
            let mut declared = FxHashSet::default();
            let mut writes = false;
            for (path, script) in self.scripts() {
                let found = NamesForOthers::of(&path.to_string_lossy(), script);
                declared.extend(found.declared.iter().map(|name| hash(name)));
                writes |= found.writes_declarations;
            }
            (declared, writes)
        });
        declared.contains(&hash(word)) || *writes && self.is_in_script(word, count)
    }

    /// Whether something outside of a complete text that uses a word `count` times may declare it: the
    /// scripts around it, or another file of the repository. Other complete shaders declare names for
    /// themselves.
    pub fn may_be_declared_outside(&self, word: &str, count: usize) -> bool {
        if self.may_be_declared_in_script(word, count) {
            return true;
        }
        let files = self.context.files;
        let file = self.file();
        let cache = &self.context.options.file_cache;
        cache.may_be_declared(word, &file, files)
    }

    /// Whether a script around the text sets an input of this name: in `uniforms: { name: ... }` or
    /// `getUniformLocation(program, "name")`.
    fn is_set(&self, name: &str) -> bool {
        self.scripts().iter().any(|(path, text)| {
            let extension = file_extension(&path.to_string_lossy());
            let language =
                DocumentLanguage::of_extension(&extension).filter(|_| text.contains(name));
            let all = language.map(|of| mentions(of, text, name, NameRole::Input));
            let is_name =
                |m: &Mention| matches!(m.kind, MentionKind::Name | MentionKind::Shorthand);
            all.is_some_and(|all| all.iter().any(is_name))
        })
    }

    /// Whether a script around the text sets an input of this name, or other complete shaders declare it for
    /// themselves, and no text that a program may put before others declares it.
    pub fn is_forgotten(&self, name: &str) -> bool {
        let cache = &self.context.options.file_cache;
        let (file, files) = (self.file(), self.context.files);
        let is_own = |text: &str| NamesForOthers::of(self.name, text).owned.contains(&name);
        let is_set = self.is_set(name);
        // What a script says about its own shaders holds whatever other files declare.
        if let Some(script) = &self.script
            && (is_set || is_own(script))
        {
            return !self.may_be_declared_in_script(name, usize::MAX);
        }
        (is_set || cache.is_owned(name, &file, files)) && !cache.is_declared(name, &file, files)
    }

    /// Whether a program of the repository contains a name after `#` or `#extension `, or as a macro after `'`.
    pub fn is_written_by_program(&self, mark: &str, name: &str) -> bool {
        let (files, file) = (self.context.files, self.file());
        let cache = &self.context.options.file_cache;
        !name.is_empty() && cache.is_elsewhere(&format!("{mark}{name}"), &file, files).0
    }

    /// Whether another file of the repository has a function or macro of this name.
    pub fn may_be_overloaded(&self, name: &str) -> bool {
        let cache = &self.context.options.file_cache;
        self.script.is_none() && cache.may_be_declared(name, &self.file(), self.context.files)
    }

    /// Whether a part of a shader in another file or in the script declares a name, so that a script may put it
    /// before the text.
    pub fn may_be_joined(&self, word: &str) -> bool {
        let cache = &self.context.options.file_cache;
        self.is_imported() && cache.may_be_declared(word, &self.file(), self.context.files)
            || self.script.is_some() && self.may_be_declared_in_script(word, usize::MAX)
    }

    /// The files that scripts join to this one, which has the entry function.
    pub fn joined(&self) -> Vec<JoinedFiles> {
        if !self.is_imported() {
            return Vec::new();
        }
        let files = self.context.files;
        let file = self.file();
        let own = file.file_name().unwrap_or_default().to_string_lossy();
        let mut found = Vec::new();
        let mut is_all = true;
        for (path, text) in self.importers() {
            let top = self.context.options.file_cache.top(path, files);
            let language = DocumentLanguage::of_extension(&file_extension(&path.to_string_lossy()));
            let is_file = |path: &PathBuf| files.entry(path) == Some(FileType::File);
            let path_of = |text: &Option<String>| {
                let text = text.as_ref().filter(|text| text.contains('.'))?;
                meant(text, path, &top).into_iter().find(is_file)
            };
            let count = found.len();
            for list in language.map_or(Vec::new(), |language| lists(language, text)) {
                if list.len() > MAX_JOINED || !list.iter().flatten().any(|t| t.contains(&*own)) {
                    continue;
                }
                let all: Vec<Option<PathBuf>> = list.iter().map(path_of).collect();
                let mut own = all
                    .iter()
                    .enumerate()
                    .filter(|(_, p)| p.as_ref() == Some(&file));
                let (Some((at, _)), None) = (own.next(), own.next()) else {
                    continue;
                };
                let is_entry = |path: &PathBuf| files.load(path).is_ok_and(|t| has_main(&t));
                let part = |range: &[Option<PathBuf>]| range.iter().flatten().cloned().collect();
                let (before, after) = (
                    all.get(..at).unwrap_or(&[]),
                    all.get(at + 1..).unwrap_or(&[]),
                );
                let mut others = before.iter().chain(after).flatten();
                if others.clone().next().is_none() || others.any(is_entry) {
                    continue;
                }
                is_all &= all.iter().all(Option::is_some);
                found.push(JoinedFiles {
                    before: part(before),
                    after: part(after),
                    is_all: true,
                });
            }
            is_all &= found.len() > count;
        }
        found.iter_mut().for_each(|list| list.is_all = is_all);
        found
    }

    /// Whether a script around a text that uses a word `count` times contains it too.
    pub fn is_in_script(&self, word: &str, count: usize) -> bool {
        let counts = self.counts.get_or_init(|| {
            let mut all = FxHashMap::default();
            for (_, text) in self.scripts() {
                for (word, number) in counts(text) {
                    *all.entry(word).or_insert(0) += number;
                }
            }
            all
        });
        let own = if self.script.is_some() { count } else { 0 };
        counts.get(&hash(word)).is_some_and(|all| *all > own)
    }

    /// Whether no host is known that may write `#version` before a text, and no program in the
    /// repository does.
    pub fn adds_no_version(&self) -> bool {
        let files = self.context.files;
        let file = self.file();
        self.imported().is_empty()
            && self.installed().is_empty()
            && !self.context.options.file_cache.adds_version(&file, files)
    }

    /// The absolute path of the file.
    fn file(&self) -> PathBuf {
        plain(&self.context.files.here().join(self.name))
    }

    fn imported(&self) -> &[&'static Preset] {
        self.imported.get_or_init(|| {
            let scripts = self.scripts().into_iter();
            let all = scripts.flat_map(|(_, text)| imported_hosts(text));
            let mut seen = BTreeSet::new();
            all.filter(|host| seen.insert(host.name)).collect()
        })
    }

    fn installed(&self) -> &[&'static Preset] {
        let access = self.context.file_access();
        self.installed
            .get_or_init(|| installed_hosts(self.name, access))
    }
}
