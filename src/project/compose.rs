//! Composes each pass as the player compiles it: header, Common passes in order, its own code.

use super::sliders::{SliderChoice, Sliders};
use super::{OutputId, Project, ProjectPass, Wrapper};
use shaderlint_explain::{Checked, analyze};
use shaderlint_semantic::{Channels, Dialect, Pass, Stage, Unit};
use shaderlint_text::{FileId, Role, Sources};
use std::sync::{Arc, OnceLock};

/// A pass that is ready to be compiled.
pub struct PassUnit {
    /// Index of the pass in the project.
    pub pass: usize,
    /// The kind of pass.
    pub kind: Pass,
    /// Who declares the uniforms and `main`.
    pub wrapper: Wrapper,
    /// The shader stage.
    pub stage: Stage,
    /// By channel: whether its texture has mipmaps; `None` if unknown.
    pub mipmapped: [Option<bool>; 4],
    /// Header, Common passes and code, in the order in which they are compiled.
    pub files: Vec<FileId>,
    /// The result of the check, computed on first use.
    checked: OnceLock<Checked>,
}

/// A project with all texts in one address space. Each pass is checked at most once.
pub struct Composed {
    /// The texts: headers, then Common passes, then other passes.
    pub sources: Arc<Sources>,
    /// The passes that run, in project order. A project that has only Common passes has those.
    pub units: Vec<PassUnit>,
    /// By text: the pass that it is the code of; `None` for headers.
    owners: Vec<Option<usize>>,
    /// By pass of the project: everything that determines the compiled text.
    keys: Vec<UnitKey>,
    /// Which values have sliders.
    pub choice: SliderChoice,
    /// The sliders, computed on first use.
    pub sliders: OnceLock<Sliders>,
}

/// Everything that determines the compiled text of a pass: its channels, its code, and the text
/// around it.
#[derive(PartialEq, Eq)]
struct UnitKey(Pass, Wrapper, Channels, [Arc<str>; 3]);

impl UnitKey {
    fn of(pass: &ProjectPass) -> UnitKey {
        let texts = [&pass.before, &pass.code, &pass.after].map(Arc::clone);
        UnitKey(pass.kind, pass.wrapper, pass.channels(), texts)
    }
}

impl PassUnit {
    /// The position among the programs of a host that runs several: the number of the buffer; the
    /// image is the last one.
    pub fn program_number(&self, project: &Project) -> usize {
        let pass = project.passes.get(self.pass);
        let buffer = pass.filter(|pass| pass.kind == Pass::Buffer);
        let output = buffer.and_then(|pass| pass.output.as_ref());
        output.and_then(OutputId::number).unwrap_or(usize::MAX)
    }
}

impl Composed {
    /// The result of checking a pass.
    pub fn analysis<'a>(&self, unit: &'a PassUnit) -> &'a Checked {
        unit.checked.get_or_init(|| {
            analyze(&Unit {
                dialect: match unit.wrapper {
                    Wrapper::Player => Dialect::ShaderToy(unit.kind),
                    Wrapper::Own => Dialect::WebGl,
                },
                ..Unit::complete(&self.sources, &unit.files, unit.stage)
            })
        })
    }

    /// Whether the browser would reject a pass.
    pub fn has_errors(&self) -> bool {
        self.units.iter().any(|u| self.analysis(u).has_errors())
    }

    /// Whether it was composed from this state of the project, so that its checks are still valid.
    pub fn is_of(&self, project: &Project) -> bool {
        let keys = project.passes.iter().map(UnitKey::of);
        self.keys.iter().eq(keys.collect::<Vec<_>>().iter())
    }

    /// Chooses which values have sliders.
    pub fn choose_sliders(&mut self, choice: SliderChoice) {
        self.choice = choice;
        self.sliders = OnceLock::new();
    }

    /// The same passes with another text in one or several files. Returns `None` if the texts are
    /// too large to be addressed.
    pub fn with_texts(&self, texts: &[(FileId, String)]) -> Option<Composed> {
        let mut sources = Sources::new();
        for (id, file) in (0..).map(FileId).zip(self.sources.files()) {
            let changed = texts.iter().find(|(changed, _)| *changed == id);
            let text = changed.map_or(file.text.clone(), |(_, text)| text.as_str().into());
            sources.add(&file.path, file.part.clone(), file.role, text)?;
        }
        let units = self.units.iter().map(|unit| PassUnit {
            files: unit.files.clone(),
            checked: OnceLock::new(),
            ..*unit
        });
        Some(Composed {
            sources: Arc::new(sources),
            units: units.collect(),
            owners: self.owners.clone(),
            keys: Vec::new(),
            choice: self.choice,
            sliders: OnceLock::new(),
        })
    }

    /// Index of the pass that a text is the code of.
    pub fn owner(&self, file: FileId) -> Option<usize> {
        self.owners.get(file.0 as usize).copied().flatten()
    }
}

/// Composes the passes of a project. `path` is the input file given by the user. Returns `None` if
/// the texts are too large to be addressed.
pub fn compose(project: &Project, path: &str) -> Option<Composed> {
    let mut sources = Sources::new();
    let headers = headers(project, &mut sources)?;
    let commons = add(project, &mut sources, path, |p| p.kind == Pass::Common)?;
    let passes = add(project, &mut sources, path, |p| p.kind != Pass::Common)?;
    let alone = if passes.is_empty() { &commons } else { &passes };
    let mut units = Vec::new();
    for &(pass, file) in alone {
        let found = project.passes.get(pass)?;
        let mut files = Vec::new();
        if found.wrapper == Wrapper::Player {
            files.push(headers.iter().find(|(header, _)| *header == pass)?.1);
            files.extend(commons.iter().map(|(_, f)| *f).filter(|f| *f != file));
        }
        let around = |sources: &mut Sources, text: &Arc<str>| match text.is_empty() {
            true => Some(None),
            false => sources.add("", None, Role::Prelude, text.clone()).map(Some),
        };
        files.extend(around(&mut sources, &found.before)?);
        files.push(file);
        files.extend(around(&mut sources, &found.after)?);
        units.push(PassUnit {
            pass,
            kind: found.kind,
            wrapper: found.wrapper,
            stage: found.stage,
            mipmapped: found.mipmapped(),
            files,
            checked: OnceLock::new(),
        });
    }
    let mut owners = vec![None; sources.files().len()];
    for &(pass, file) in commons.iter().chain(&passes) {
        if let Some(owner) = owners.get_mut(file.0 as usize) {
            *owner = Some(pass);
        }
    }
    Some(Composed {
        sources: Arc::new(sources),
        units,
        owners,
        keys: project.passes.iter().map(UnitKey::of).collect(),
        choice: SliderChoice::Marked,
        sliders: OnceLock::new(),
    })
}

/// The headers of the passes that the player completes, each once. A pass in a file may declare
/// uniforms of the player itself.
fn headers(project: &Project, sources: &mut Sources) -> Option<Vec<(usize, FileId)>> {
    let commons: String = project.commons().map(|pass| &*pass.code).collect();
    let mut known: Vec<(String, FileId)> = Vec::new();
    let mut headers = Vec::new();
    let player = |pass: &&ProjectPass| pass.wrapper == Wrapper::Player;
    for (i, pass) in project
        .passes
        .iter()
        .enumerate()
        .filter(|(_, pass)| player(pass))
    {
        let host = pass.kind.host();
        let text = match project.is_export {
            true => host.prelude(pass.channels()),
            false => host.prelude_beside(pass.channels(), &format!("{commons}{}", pass.code)),
        };
        let id = match known.iter().find(|(known, _)| *known == text) {
            Some((_, id)) => *id,
            None => sources.add("", None, Role::Prelude, text.clone())?,
        };
        known.push((text, id));
        headers.push((i, id));
    }
    Some(headers)
}

/// Adds the texts of the selected passes. Returns their indexes and files.
fn add(
    project: &Project,
    sources: &mut Sources,
    path: &str,
    is_composed: impl Fn(&ProjectPass) -> bool,
) -> Option<Vec<(usize, FileId)>> {
    let passes = project.passes.iter().enumerate();
    passes
        .filter(|(_, pass)| is_composed(pass))
        .map(|(i, pass)| {
            let part = project.is_export.then(|| pass.title(i));
            let (code, path) = (pass.code.clone(), pass.file.as_deref().unwrap_or(path));
            let id = sources.add(path, part, Role::User, code)?;
            sources.set_pieces(id, &pass.pieces);
            Some((i, id))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `__LINE__` keeps counting after the header and after every Common pass, as in the compiled
    /// text.
    #[test]
    fn line_numbers_continue_through_common_code() {
        let json = r#"{"renderpass":[
            {"type":"image","code":"\nconst int HERE = __LINE__;\nvoid mainImage(out vec4 c, in vec2 p) {}"},
            {"type":"common","code":"// one\n#define THERE __LINE__"},
            {"type":"common","code":"const int A = __LINE__; const int B = THERE;\n"}]}"#;
        let mut project = Project::from_json(json).unwrap();
        let composed = project.resolve("").unwrap();
        let program = &composed.analysis(&composed.units[0]).program;
        let values = ["HERE", "A", "B"].map(|name| {
            let name = program.names.get(name);
            let variable = program.variables.iter().find(|v| Some(v.name) == name)?;
            program.pool.scalar(variable.constant).map(|v| v.as_int())
        });
        assert_eq!(values, [Some(59), Some(56), Some(56)]);
    }
}
