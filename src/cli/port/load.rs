//! Loads a project from paths: shader files, folders, exports, and the inputs of channels.

use super::args::PortArgs;
use super::channels::{GivenOrder, file_of, orders};
use super::media::{Carried, is_cube};
use super::read::{plain_error, read_text};
use super::siblings::{draft_with_siblings, folder_of};
use crate::cli::config::{configured_host, host_of};
use crate::detect::kind::{Claim, Evidence, FileKind, ShaderLanguage, decide};
use crate::engine::{Repairs, modernize, repair};
use crate::host::{Preset, shadertoy};
use crate::project::{
    ChannelName, ChannelSource, Composed, PassFile, PassRole, Project, ShaderError, SiblingTexts,
    add_stand_ins, saver_roles, unknown_pass, unknown_source,
};
use crate::semantic::Pass;
use crate::text::path::slashed;
use std::fs;
use std::path::{Path, PathBuf};

pub(super) struct LoadedProject {
    pub(super) project: Project,
    pub(super) composed: Composed,
    /// The repairs that were applied.
    pub(super) repairs: Repairs,
    /// The composed passes before the repairs, if there were any.
    pub(super) given: Option<Composed>,
    /// The files that were read. The output must not overwrite them.
    pub(super) read: Vec<PathBuf>,
    /// Notes about the files on channels.
    pub(super) notes: Vec<String>,
}

/// Loads the project that the arguments describe.
pub(super) fn load(args: &PortArgs) -> Result<LoadedProject, String> {
    let mut orders = args.orders()?;
    let mode = if args.repair || args.diff {
        Mode::Repair
    } else {
        Mode::AsItIs
    };
    let Drafted {
        mut project,
        mut repairs,
        mut given,
        mut renamed,
        siblings,
    } = match &args.input[..] {
        [] if args.pass.is_empty() => {
            return Err(USAGE.to_string());
        }
        [one] if let Some(text) = &args.text => Drafted::of(export(&slashed(one), text)?),
        [one] if args.pass.is_empty() && !one.is_dir() => {
            one_file(one, mode, host(args.host.as_deref())?)?
        }
        several => Drafted::of(parts(several, &args.pass)?),
    };
    let name = name_of(args);
    let wrong = |e: ShaderError| format!("{name}: {e}");
    let mut composed = project.resolve(&name).map_err(wrong)?;
    if (mode == Mode::Repair || project.host.is_some() && composed.has_errors())
        && repairs.is_empty()
        && repairs.left.is_none()
        && let Some((fixed, renewed, repaired)) = apply_repairs(&project, &composed, &name, mode)?
    {
        given = Some(std::mem::replace(&mut composed, renewed));
        renamed = project.renamed_samplers(&fixed);
        (project, repairs) = (fixed, repaired);
    }
    if project
        .passes
        .iter()
        .all(|p| !matches!(p.kind, Pass::Image | Pass::Cubemap | Pass::Sound))
    {
        return Err(format!("{name}: no pass of type `image`"));
    }
    let mut carried = Carried::new(args.max_media, "; raise it with `--max-media SIZE`");
    if let Some(folder) = &args.media {
        carried.find(&mut project, folder)?;
    }
    if let (Some(_), Some(path)) = (project.host, args.input.first())
        && path.as_os_str() != "-"
    {
        carried.find(&mut project, folder_of(path))?;
    }
    follow_repairs(&mut orders, &renamed);
    put(&mut project, &orders, &mut carried)?;
    let mut notes = carried.notes();
    if args.strict_player {
        project.share_samplers();
        let silent = project.unload_music().into_iter();
        notes.extend(silent.map(|channel| {
            format!("{channel}: music file not available; the channel is silent, as on ShaderToy")
        }));
    }
    if !args.no_stand_ins {
        add_stand_ins(&mut project);
    }
    let mut read = files_of(args)?;
    if let Some(path) = args.input.first() {
        read.extend(siblings.keys().map(|asked| folder_of(path).join(asked)));
    }
    read.extend(carried.paths().cloned());
    let mut composed = project.renew(composed, &name).map_err(wrong)?;
    composed.choose_sliders(args.sliders);
    Ok(LoadedProject {
        project,
        composed,
        repairs,
        given,
        read,
        notes,
    })
}

/// The repaired project; `None` if there is nothing to repair. Without `--repair`, repairs are
/// applied only if the result compiles, which makes WebGL1 and desktop shaders work.
fn apply_repairs(
    project: &Project,
    composed: &Composed,
    name: &str,
    mode: Mode,
) -> Result<Option<(Project, Composed, Repairs)>, String> {
    let wrong = |e: ShaderError| format!("{name}: {e}");
    let mut fixed = project.clone();
    let repaired = repair(&mut fixed, composed, name);
    let repaired = repaired.ok_or(wrong(ShaderError::TooLarge))?;
    if repaired.is_empty() && (repaired.left.is_none() || mode == Mode::AsItIs) {
        return Ok(None);
    }
    let renewed = fixed.resolve(name).map_err(wrong)?;
    let is_kept = mode == Mode::Repair || !renewed.has_errors();
    Ok(is_kept.then_some((fixed, renewed, repaired)))
}

/// Loads a file as a project without repairs. Returns the project and the files that it was loaded
/// from. `from` is the host given by the user.
pub(in crate::cli) fn draft(
    path: &Path,
    from: Option<&str>,
) -> Result<(Project, Vec<PathBuf>), String> {
    if path.is_dir() {
        let files = in_folder(path)?.into_iter().map(|(_, path)| path);
        let files = files.collect();
        return Ok((parts(&[path.to_path_buf()], &[])?, files));
    }
    let drafted = one_file(path, Mode::AsItIs, host(from)?)?;
    let siblings = drafted
        .siblings
        .keys()
        .map(|asked| folder_of(path).join(asked));
    let read = siblings.chain([path.to_path_buf()]).collect();
    Ok((drafted.project, read))
}

/// The host given by the user.
fn host(from: Option<&str>) -> Result<Option<&'static Preset>, String> {
    let named = from.map(|name| host_of(name).map_err(|e| format!("--host: {e}")));
    named.transpose()
}

const USAGE: &str = "no input: pass a shader file, a ShaderToy export (.json) or a folder of passes; \
                     try `shaderport ocean.glsl -o ocean.html`, or `--help` for all options";

impl PortArgs {
    /// The channel orders of the user.
    pub(super) fn orders(&self) -> Result<Vec<GivenOrder>, String> {
        orders(self.input.first().map(PathBuf::as_path), &self.channel)
    }
}

/// Applies the channel orders of the user and of a file next to the input. Returns the files that
/// were read and notes about them.
pub(in crate::cli) fn put_channels(
    project: &mut Project,
    input: &Path,
    channels: &[String],
) -> Result<(Vec<PathBuf>, Vec<String>), String> {
    let orders = orders(Some(input), channels)?;
    let mut carried = Carried::new(MOST_MEDIA, "");
    put(project, &orders, &mut carried)?;
    let mut read: Vec<PathBuf> = file_of(Some(input)).into_iter().collect();
    read.extend(carried.paths().cloned());
    Ok((read, carried.remarks().to_vec()))
}

/// Samplers that repairs renamed are found by their old names, too.
fn follow_repairs(orders: &mut [GivenOrder], renamed: &[(String, String)]) {
    for GivenOrder { order, .. } in orders {
        if let ChannelName::Sampler(name) = &mut order.channel
            && let Some((_, new)) = renamed.iter().find(|(old, _)| old == name)
        {
            name.clone_from(new);
        }
    }
}

fn put(project: &mut Project, orders: &[GivenOrder], carried: &mut Carried) -> Result<(), String> {
    for GivenOrder { by, order } in orders {
        let wrong = |e| format!("{by}: {e}");
        let media = match &order.source {
            ChannelSource::File(path) if !Path::new(path).exists() => {
                return Err(wrong(unknown_source(path)));
            }
            ChannelSource::File(path) => {
                let is_cube = is_cube(project, order);
                Some(carried.read(Path::new(path), is_cube).map_err(wrong)?)
            }
            _ => None,
        };
        project.put(order, media).map_err(wrong)?;
    }
    Ok(())
}

/// The shader files and order files that the arguments name.
pub(super) fn files_of(args: &PortArgs) -> Result<Vec<PathBuf>, String> {
    let input = args.input.first().map(PathBuf::as_path);
    let mut files: Vec<PathBuf> = file_of(input).into_iter().collect();
    for path in &args.input {
        match path.is_dir() {
            true => files.extend(in_folder(path)?.into_iter().map(|(_, path)| path)),
            false => files.push(path.clone()),
        }
    }
    let named = args.pass.iter().filter_map(|text| text.split_once('='));
    files.extend(named.map(|(_, path)| PathBuf::from(path)));
    Ok(files)
}

/// Largest media file for a project that is not written, in bytes.
const MOST_MEDIA: u64 = 64 << 20;

/// What to do with code that does not compile.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    AsItIs,
    Repair,
}

/// The name of the input in messages.
pub(super) fn name_of(args: &PortArgs) -> String {
    args.input.first().map_or("passes".to_string(), slashed)
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .map_or(String::new(), |s| s.to_string_lossy().into_owned())
}

struct Drafted {
    project: Project,
    /// Repairs that were already applied.
    repairs: Repairs,
    /// The composed passes before these repairs.
    given: Option<Composed>,
    /// The samplers that these repairs renamed, with the new names.
    renamed: Vec<(String, String)>,
    /// The companion files that it was loaded from.
    siblings: SiblingTexts,
}

impl Drafted {
    /// A project without companion files.
    fn of(project: Project) -> Drafted {
        Drafted {
            project,
            repairs: Repairs::default(),
            given: None,
            renamed: Vec::new(),
            siblings: SiblingTexts::new(),
        }
    }
}

/// The project of an export.
fn export(name: &str, text: &str) -> Result<Project, String> {
    Project::from_json(text).map_err(|e| format!("{name}: {e}"))
}

fn one_file(path: &Path, mode: Mode, from: Option<&'static Preset>) -> Result<Drafted, String> {
    let name = slashed(path);
    let text = read_text(path)?;
    let wrong = |e: String| format!("{name}: {e}");
    if from.is_none() {
        reject_other_languages(&name, &text)?;
    }
    if text.trim_start().starts_with(['{', '[']) {
        return Ok(Drafted::of(export(&name, &text)?));
    }
    if text.trim_start().starts_with('<') && !text.contains("<klxml") {
        return Err(wrong("expected a shader, found HTML or XML".to_string()));
    }
    if let FileKind::Holds(language) = decide(&name, &text, Claim::None).kind {
        return Err(wrong(format!(
            "expected a shader, found {language}; move the shader to a file of its own"
        )));
    }
    let title = if name == "-" {
        String::new()
    } else {
        stem(path)
    };
    let from = match from {
        None if name != "-" => configured_host(path)?,
        from => from,
    };
    let mut siblings = SiblingTexts::new();
    let mut draft = |text: &str| {
        draft_with_siblings(path, &mut siblings, |siblings| {
            Project::draft_with_siblings(&title, text, from, siblings)
                .map_err(|e| wrong(e.to_string()))
        })
    };
    let mut project = draft(&text)?;
    let is_old = project.modernized(&text).is_some();
    if mode == Mode::AsItIs || !is_old {
        return Ok(Drafted {
            siblings,
            ..Drafted::of(project)
        });
    }
    let repairs = modernize(&project, &name, &text, |text| draft(text).ok())
        .ok_or_else(|| wrong("the shader is too large".to_string()))?;
    let given = project.resolve(&name).map_err(|e| wrong(e.to_string()))?;
    let mut repaired = draft(repairs.text().unwrap_or(&text))?;
    repaired.resolve(&name).map_err(|e| wrong(e.to_string()))?;
    Ok(Drafted {
        renamed: project.renamed_samplers(&repaired),
        project: repaired,
        repairs,
        given: Some(given),
        siblings,
    })
}

/// Rejects a shader in a language that shaderport does not read, at the code that shows it.
fn reject_other_languages(name: &str, text: &str) -> Result<(), String> {
    let FileKind::Foreign(language) = decide(name, text, Claim::None).kind else {
        return Ok(());
    };
    if language == ShaderLanguage::Desktop {
        return Ok(());
    }
    let sign = Evidence::of(text).first_sign(language).unwrap_or(0..0);
    let before = text.get(..sign.start).unwrap_or("");
    let line = before.matches('\n').count() + 1;
    let found = match text.get(sign).unwrap_or("") {
        "" => String::new(),
        code => format!(": `{code}`"),
    };
    Err(format!(
        "{name}:{line}: expected GLSL for ShaderToy, WebGL or another host, found {}{found}",
        language.shader()
    ))
}

/// Assigns several files and folders, and the files of `--pass`, to passes.
fn parts(paths: &[PathBuf], named: &[String]) -> Result<Project, String> {
    let mut files: Vec<(PassRole, PathBuf)> = Vec::new();
    let saver = programs(paths).filter(|_| named.is_empty());
    let is_saver = saver.is_some();
    for text in named {
        let (role, path) = text
            .split_once('=')
            .ok_or_else(|| format!("--pass: expected `PASS=FILE`, found `{text}`"))?;
        let role =
            PassRole::of_name(role).ok_or_else(|| format!("--pass: {}", unknown_pass(role)))?;
        files.push((role, PathBuf::from(path)));
    }
    files.extend(saver.unwrap_or_default());
    for path in paths.iter().filter(|_| !is_saver) {
        if path.is_dir() {
            files.extend(in_folder(path)?);
        } else {
            let role = PassRole::of_name(&stem(path)).ok_or_else(|| {
                format!(
                    "{}: the file name does not match a pass; rename it, for example to \
                     `image.glsl` or `buffer_a.glsl`, or use `--pass image=FILE`",
                    slashed(path)
                )
            })?;
            files.push((role, path.clone()));
        }
    }
    let parts = files
        .into_iter()
        .map(|(role, path)| {
            let (file, text) = (slashed(&path), read_text(&path)?);
            reject_other_languages(&file, &text)?;
            Ok(PassFile {
                role,
                file,
                code: text.into(),
            })
        })
        .collect::<Result<Vec<_>, String>>()?;
    let title = match paths {
        [folder] if folder.is_dir() => {
            let absolute = folder.canonicalize().unwrap_or_else(|_| folder.clone());
            absolute
                .file_name()
                .map_or(String::new(), |n| n.to_string_lossy().into_owned())
        }
        _ => String::new(),
    };
    let mut project = Project::from_parts(&title, parts).map_err(|e| e.to_string())?;
    if is_saver {
        project.link_programs();
    }
    Ok(project)
}

/// The programs of a screen saver of XScreenSaver: the files themselves, or those of a folder.
fn programs(paths: &[PathBuf]) -> Option<Vec<(PassRole, PathBuf)>> {
    let mut files = match paths {
        [folder] if folder.is_dir() => {
            let entries = fs::read_dir(folder).ok()?;
            let files = entries.filter_map(|entry| Some(entry.ok()?.path()));
            files
                .filter(|path| is_shader(path) && !path.is_symlink())
                .collect()
        }
        files => files.to_vec(),
    };
    files.sort();
    let names: Vec<String> = files.iter().map(|path| stem(path)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    Some(saver_roles(&names)?.into_iter().zip(files).collect())
}

/// The passes in a folder. Symbolic links that leave the folder are rejected, since the user may
/// not have created a downloaded folder.
pub(in crate::cli) fn in_folder(folder: &Path) -> Result<Vec<(PassRole, PathBuf)>, String> {
    let wrong = |e: std::io::Error| format!("{}: {}", slashed(folder), plain_error(&e));
    let root = folder.canonicalize().map_err(wrong)?;
    let mut found = Vec::new();
    let mut others = Vec::new();
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let path = entry.map_err(wrong)?.path();
        match PassRole::of_name(&stem(&path)) {
            Some(role) if is_shader(&path) => {
                if !path.canonicalize().map_err(wrong)?.starts_with(&root) {
                    return Err(format!(
                        "{} is outside of {}; pass it with `--pass {}=FILE`",
                        slashed(&path),
                        slashed(folder),
                        role.name()
                    ));
                }
                found.push((role, path));
            }
            _ if is_shader(&path) || path.extension().is_some_and(|e| e == "json") => {
                others.push(path);
            }
            _ => {}
        }
    }
    found.sort();
    others.sort();
    let programs = programs(&[folder.to_path_buf()]).filter(|_| found.is_empty());
    if let Some(programs) = programs {
        return Ok(programs);
    }
    match (found.is_empty(), others.first()) {
        (false, _) => Ok(found),
        (true, other) => {
            let help = other.map_or(String::new(), |path| {
                format!(", or pass a single file, such as {}", slashed(path))
            });
            Err(format!(
                "{}: no pass found; name the files `image.glsl`, `buffer_a.glsl`, \
                 `common.glsl`{help}",
                slashed(folder)
            ))
        }
    }
}

/// Whether a file in a folder can be a pass.
fn is_shader(path: &Path) -> bool {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    shadertoy().is_some_and(|host| host.has_extension(extension)) && path.is_file()
}
