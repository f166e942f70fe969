//! Loads a project from paths: shader files, folders, exports, and the inputs of channels.

use super::args::PortArgs;
use super::media::{Carried, folder_of};
use super::read::read_text;
use crate::cli::config::{configs, host_of};
use crate::cli::disk::Disk;
use crate::cli::evidence;
use crate::commands::run::InputRequest;
use crate::engine::config::{ConfigArgs, Configs};
use crate::engine::{Options, Repairs, modernize, repair};
use crate::host::Preset;
use crate::project::{
    ChannelName, Composed, GivenOrder, OpenedProject, PassRole, Project, ShaderError, SingleShader,
    add_stand_ins, channel_file, open_file, open_passes, unknown_pass,
};
use crate::text::path::slashed;
use std::path::{Path, PathBuf};
use std::sync::Arc;

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
    let configs = configs(ConfigArgs {
        paths: args.input.clone(),
        ..ConfigArgs::default()
    });
    let OpenedProject {
        project,
        single,
        mut read,
        mut orders,
        ..
    } = open(args, &configs)?;
    let name = name_of(args);
    let wrong = |e: ShaderError| format!("{name}: {e}");
    let mode = match args.repair || args.diff {
        true => Mode::Repair,
        false => Mode::AsItIs,
    };
    let Repaired {
        mut project,
        composed,
        repairs,
        given,
        renamed,
    } = repaired(project, single.as_ref(), &name, mode)?;
    if !project.is_shown() {
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
    project.put_all(&orders, &mut carried)?;
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
    read.extend(args.input.iter().filter(|path| path.is_file()).cloned());
    read.extend(carried.paths().cloned());
    let mut composed = project.renew(composed, &name).map_err(wrong)?;
    composed.choose_sliders(args.request.sliders);
    Ok(LoadedProject {
        project,
        composed,
        repairs,
        given,
        read,
        notes,
    })
}

/// A project after repairs.
struct Repaired {
    project: Project,
    composed: Composed,
    repairs: Repairs,
    /// The composed passes before the repairs, if there were any.
    given: Option<Composed>,
    /// The samplers that were renamed, with the new names.
    renamed: Vec<(String, String)>,
}

/// Converts and repairs a project, if that is asked for or necessary.
fn repaired(
    mut project: Project,
    single: Option<&SingleShader>,
    name: &str,
    mode: Mode,
) -> Result<Repaired, String> {
    let wrong = |e: ShaderError| format!("{name}: {e}");
    let old = single
        .filter(|single| mode == Mode::Repair && project.modernized(&single.text.text).is_some());
    if let Some(single) = old {
        let text = &*single.text.text;
        let repairs = modernize(&project, name, text, |text| single.draft(text).ok());
        let repairs = repairs.ok_or(wrong(ShaderError::TooLarge))?;
        let given = project.resolve(name).map_err(wrong)?;
        let mut repaired = single
            .draft(repairs.text().unwrap_or(text))
            .map_err(wrong)?;
        let composed = repaired.resolve(name).map_err(wrong)?;
        if !repairs.is_empty() || repairs.left.is_some() {
            return Ok(Repaired {
                renamed: project.renamed_samplers(&repaired),
                project: repaired,
                composed,
                repairs,
                given: Some(given),
            });
        }
        project = repaired;
    }
    let composed = project.resolve(name).map_err(wrong)?;
    if (mode == Mode::Repair || project.host.is_some() && composed.has_errors())
        && let Some((fixed, renewed, repairs)) = apply_repairs(&project, &composed, name, mode)?
    {
        return Ok(Repaired {
            renamed: project.renamed_samplers(&fixed),
            project: fixed,
            composed: renewed,
            repairs,
            given: Some(composed),
        });
    }
    Ok(Repaired {
        project,
        composed,
        repairs: Repairs::default(),
        given: None,
        renamed: Vec::new(),
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

const USAGE: &str = "no input: pass a shader file, a ShaderToy export (.json) or a folder of passes; \
                     try `shaderport ocean.glsl -o ocean.html`, or `--help` for all options";

/// Applies the channel orders of a project that is not written. Returns the files that were read and
/// notes about them.
pub(in crate::cli) fn put_channels(
    project: &mut Project,
    orders: &[GivenOrder],
) -> Result<(Vec<PathBuf>, Vec<String>), String> {
    let mut carried = Carried::new(MOST_MEDIA, "");
    project.put_all(orders, &mut carried)?;
    Ok((
        carried.paths().cloned().collect(),
        carried.remarks().to_vec(),
    ))
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

/// The files and folders that the arguments name, which may not exist yet.
pub(super) fn named_files(args: &PortArgs) -> Vec<PathBuf> {
    let passes = args.pass.iter().filter_map(|text| text.split_once('='));
    let passes = passes.map(|(_, path)| PathBuf::from(path));
    let disk = Disk::new();
    let orders = args.input.first().map(|path| channel_file(path, &disk));
    let input = args.input.iter().cloned();
    input.chain(passes).chain(orders).collect()
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

/// Opens what the arguments name.
fn open(args: &PortArgs, configs: &Configs) -> Result<OpenedProject, String> {
    let disk = Disk::new();
    let host = named_host(args.source.host.as_deref())?;
    let mut draft = match &args.input[..] {
        [] if args.pass.is_empty() => return Err(USAGE.to_string()),
        [one] if args.pass.is_empty() && !one.is_dir() => {
            open_one(one, args.text.as_deref(), host, configs)?
        }
        several => {
            let named: Result<Vec<_>, _> = args.pass.iter().map(|text| named_pass(text)).collect();
            let first = several.first().map_or(Path::new(""), PathBuf::as_path);
            let options = options_at(first, configs)?;
            open_passes(several, &named?, options.file_access(&disk))?
        }
    };
    draft.order(&args.source.channels)?;
    evidence::opened(&name_of(args), &draft);
    Ok(draft)
}

/// Opens a file or a folder with the configuration that applies to it, and resolves it. `from` is the
/// host given by the user, `channels` are the user's orders.
pub(in crate::cli) fn draft(
    path: &Path,
    from: Option<&str>,
    channels: &[String],
) -> Result<(OpenedProject, Composed), String> {
    let args = PortArgs {
        input: vec![path.to_path_buf()],
        source: InputRequest {
            host: from.map(str::to_string),
            channels: channels.to_vec(),
        },
        ..PortArgs::default()
    };
    let mut opened = open(&args, &configs(ConfigArgs::default()))?;
    let name = name_of(&args);
    let composed = (opened.project.resolve(&name)).map_err(|e| format!("{name}: {e}"))?;
    // Most other hosts run desktop GLSL.
    if opened.project.host.is_some()
        && composed.has_errors()
        && let Some((fixed, renewed, _)) =
            apply_repairs(&opened.project, &composed, &name, Mode::AsItIs)?
    {
        opened.project = fixed;
        return Ok((opened, renewed));
    }
    Ok((opened, composed))
}

fn open_one(
    path: &Path,
    text: Option<&str>,
    host: Option<&'static Preset>,
    configs: &Configs,
) -> Result<OpenedProject, String> {
    let name = slashed(path);
    let text = text.map_or_else(|| read_text(path), |text| Ok(text.to_string()))?;
    let options = options_at(path, configs)?;
    open_file(&name, &text, host, options.file_access(&Disk::new()))
}

/// The options for a file or for the passes in a folder.
fn options_at(path: &Path, configs: &Configs) -> Result<Arc<Options>, String> {
    let path = match path.is_dir() {
        true => &path.join("image.glsl"),
        false => path,
    };
    configs.options(path).map_err(|e| e.to_string())
}

/// The host given by the user.
fn named_host(from: Option<&str>) -> Result<Option<&'static Preset>, String> {
    let named = from.map(|name| host_of(name).map_err(|e| format!("--host: {e}")));
    named.transpose()
}

/// The pass and the file in a `--pass`.
fn named_pass(text: &str) -> Result<(PassRole, PathBuf), String> {
    let parts = text.split_once('=');
    let (role, path) =
        parts.ok_or_else(|| format!("--pass: expected `PASS=FILE`, found `{text}`"))?;
    let role = PassRole::of_name(role).ok_or_else(|| format!("--pass: {}", unknown_pass(role)))?;
    Ok((role, PathBuf::from(path)))
}
