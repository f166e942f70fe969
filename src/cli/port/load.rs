//! From paths to a project: shader files, folders, exports, and what goes onto channels.

use super::PortArgs;
use super::channels::{GivenOrder, orders};
use crate::cli::input::{InputFile, read};
use crate::engine::{Repairs, repair, repair_webgl1};
use crate::port::{
    ChannelOrder, ChannelSource, Composed, DIALECTS, DialectFacts, InputKind, Media, OutputId,
    PassFile, PassRole, Project, ShaderError, dialect_named, kind_of_file,
};
use crate::semantic::Pass;
use crate::text::kind::Claim;
use crate::text::{Content, Encoding};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::fs;
use std::path::{Path, PathBuf};

/// Largest file that is put into an output, in bytes.
const MAX_MEDIA: u64 = 64 * 1024 * 1024;

/// Endings of the shader files that a folder is searched for.
const SHADERS: [&str; 4] = ["glsl", "frag", "fs", "shadertoy"];

/// What the arguments name.
pub(super) struct Loaded {
    pub(super) project: Project,
    /// Its passes, put together.
    pub(super) composed: Composed,
    /// What was repaired in it.
    pub(super) repairs: Repairs,
}

/// Reads what the arguments name.
pub(super) fn load(args: &PortArgs) -> Result<Loaded, String> {
    let orders = orders(args)?;
    let mode = if args.repair || args.diff {
        Mode::Repair
    } else {
        Mode::AsItIs
    };
    let (mut project, mut repairs) = match &args.input[..] {
        [] if args.pass.is_empty() => {
            return Err("give a shader file, a folder or a ShaderToy export".to_string());
        }
        [one] if args.pass.is_empty() && !one.is_dir() => one_file(one, mode, dialect(args)?)?,
        several => (parts(several, &args.pass)?, Repairs::default()),
    };
    let name = name_of(args);
    let wrong = |e: ShaderError| format!("{name}: {e}");
    let mut composed = project.resolve(&name).map_err(wrong)?;
    // What a page or a desktop took and WebGL2 does not is mended unasked.
    if (mode == Mode::Repair || project.dialect.is_some()) && repairs.is_empty() {
        let repaired = repair(&mut project, &composed, &name);
        repairs = repaired.ok_or(wrong(ShaderError::TooLarge))?;
        if !repairs.is_empty() {
            composed = project.resolve(&name).map_err(wrong)?;
        }
    }
    if project
        .passes
        .iter()
        .all(|p| !matches!(p.kind, Pass::Image | Pass::Cubemap | Pass::Sound))
    {
        return Err(format!("{name}: there is no pass of type `image`"));
    }
    if let Some(folder) = &args.media {
        find_media(&mut project, folder)?;
    }
    for GivenOrder { by, order } in &orders {
        let media = match &order.source {
            ChannelSource::File(path) => Some(media(Path::new(path), is_cube(&project, order))?),
            _ => None,
        };
        project
            .put(order, media)
            .map_err(|e| format!("{by}: {e}"))?;
    }
    if args.strict_player {
        project.share_samplers();
    }
    let composed = project.renew(composed, &name).map_err(wrong)?;
    Ok(Loaded {
        project,
        composed,
        repairs,
    })
}

/// The dialect that the user says the code is written in.
fn dialect(args: &PortArgs) -> Result<Option<&'static DialectFacts>, String> {
    let Some(name) = &args.from else {
        return Ok(None);
    };
    let names: Vec<&str> = DIALECTS.iter().map(|d| d.name).collect();
    dialect_named(name).map(Some).ok_or_else(|| {
        format!(
            "--from: `{name}` is no dialect; these are: {}",
            names.join(", ")
        )
    })
}

/// What is done with code that does not compile.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    AsItIs,
    Repair,
}

/// How the input is called in messages.
pub(super) fn name_of(args: &PortArgs) -> String {
    args.input
        .first()
        .map_or("passes".to_string(), |path| shown(path))
}

/// A path with forward slashes.
fn shown(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .map_or(String::new(), |s| s.to_string_lossy().into_owned())
}

fn one_file(
    path: &Path,
    mode: Mode,
    from: Option<&'static DialectFacts>,
) -> Result<(Project, Repairs), String> {
    let name = shown(path);
    let text = read_text(path)?;
    let wrong = |e: String| format!("{name}: {e}");
    if text.trim_start().starts_with(['{', '[']) {
        let project = Project::from_json(&text).map_err(|e| wrong(e.to_string()))?;
        return Ok((project, Repairs::default()));
    }
    let title = if name == "-" {
        String::new()
    } else {
        stem(path)
    };
    let draft = |text: &str| {
        let project = Project::draft(&title, text, from);
        project.map_err(|e| wrong(e.to_string()))
    };
    let project = draft(&text)?;
    let modern = project.modernized(&text);
    let Some(mut modern) = modern.filter(|_| mode == Mode::Repair) else {
        return Ok((project, Repairs::default()));
    };
    let repairs = repair_webgl1(&mut modern, &name, &text)
        .ok_or_else(|| wrong("this is too large".to_string()))?;
    let code = modern.passes.first().map_or("", |p| &*p.code);
    Ok((draft(code)?, repairs))
}

fn read_text(path: &Path) -> Result<String, String> {
    let name = shown(path);
    let is_stdin = path.as_os_str() == "-";
    let input = InputFile {
        name: name.clone(),
        path: (!is_stdin).then(|| path.to_path_buf()),
        is_explicit: true,
        claim: Claim::None,
    };
    let Content { text, encoding } = read(&input).map_err(|e| format!("{name}: {e}"))?;
    match encoding {
        Encoding::Utf16 => Err(format!("{name}: the file is UTF-16; save it as UTF-8")),
        Encoding::Binary => Err(format!("{name}: the file is no text")),
        Encoding::Utf8 | Encoding::Damaged(_) => Ok(text),
    }
}

/// Several files and folders, and those that `--pass` names, as passes.
fn parts(paths: &[PathBuf], named: &[String]) -> Result<Project, String> {
    let mut files: Vec<(PassRole, PathBuf)> = Vec::new();
    for text in named {
        let (role, path) = text
            .split_once('=')
            .ok_or_else(|| format!("--pass: `{text}` is no pass; write it like `image=FILE`"))?;
        let role = PassRole::of_name(role).ok_or_else(|| format!("--pass: `{role}` is no pass"))?;
        files.push((role, PathBuf::from(path)));
    }
    for path in paths {
        if path.is_dir() {
            files.extend(in_folder(path)?);
        } else {
            let role = PassRole::of_name(&stem(path)).ok_or_else(|| {
                format!(
                    "{}: its name tells no pass; call it like `image.glsl` or `buffer_a.glsl`, or \
                     say `--pass image=FILE`",
                    shown(path)
                )
            })?;
            files.push((role, path.clone()));
        }
    }
    let parts = files
        .into_iter()
        .map(|(role, path)| {
            Ok(PassFile {
                role,
                file: shown(&path),
                code: read_text(&path)?.into(),
            })
        })
        .collect::<Result<Vec<_>, String>>()?;
    let title = match paths {
        [folder] if folder.is_dir() => {
            let whole = folder.canonicalize().unwrap_or_else(|_| folder.clone());
            whole
                .file_name()
                .map_or(String::new(), |n| n.to_string_lossy().into_owned())
        }
        _ => String::new(),
    };
    Project::from_parts(&title, parts).map_err(|e| e.to_string())
}

/// The passes that lie in a folder.
fn in_folder(folder: &Path) -> Result<Vec<(PassRole, PathBuf)>, String> {
    let wrong = |e: std::io::Error| format!("{}: {e}", shown(folder));
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let path = entry.map_err(wrong)?.path();
        if is_shader(&path)
            && let Some(role) = PassRole::of_name(&stem(&path))
        {
            found.push((role, path));
        }
    }
    found.sort();
    if found.is_empty() {
        return Err(format!(
            "{}: no file in it is called like a pass: `image.glsl`, `buffer_a.glsl`, `common.glsl`",
            shown(folder)
        ));
    }
    Ok(found)
}

/// Whether a file of a folder may be a pass.
pub(super) fn is_shader(path: &Path) -> bool {
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    SHADERS.contains(&ending) && path.is_file()
}

/// Whether an order is for a channel that reads a cube map.
fn is_cube(project: &Project, order: &ChannelOrder) -> bool {
    project
        .passes
        .iter()
        .filter(|p| {
            p.kind == order.pass.kind() && p.output == order.pass.output()
                || order.pass == PassRole::Image && p.kind == Pass::Image
        })
        .flat_map(|p| &p.inputs)
        .any(|i| i.channel == order.channel && i.kind == InputKind::Cubemap)
}

/// Reads a file that goes onto a channel. The faces of a cube map lie in `NAME`, `NAME_1` to
/// `NAME_5`; where only the first is there, it is all of them.
fn media(path: &Path, is_cube: bool) -> Result<Media, String> {
    let name = shown(path);
    let (_, kind) = kind_of_file(&name)
        .ok_or_else(|| format!("{name}: this is no picture, film, music or volume"))?;
    let first = data_address(path, kind)?;
    let mut urls = vec![first.clone()];
    if is_cube {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        for face in 1..6 {
            let path = path.with_file_name(format!("{}_{face}.{ending}", stem(path)));
            let url = if path.is_file() {
                data_address(&path, kind)?
            } else {
                first.clone()
            };
            urls.push(url);
        }
    }
    let name = path
        .file_name()
        .map_or(name, |n| n.to_string_lossy().into_owned());
    Ok(Media { name, urls })
}

fn data_address(path: &Path, kind: &str) -> Result<String, String> {
    let wrong = |e: std::io::Error| format!("{}: {e}", shown(path));
    let size = fs::metadata(path).map_err(wrong)?.len();
    if size > MAX_MEDIA {
        return Err(format!(
            "{}: the file has {size} bytes; {MAX_MEDIA} are allowed",
            shown(path)
        ));
    }
    let bytes = fs::read(path).map_err(wrong)?;
    Ok(format!(
        "data:{kind};base64,{}",
        BASE64_STANDARD.encode(bytes)
    ))
}

/// Takes what the export's channels read from a copy of the site's files. Nothing outside the folder
/// is read, whatever the export says.
fn find_media(project: &mut Project, folder: &Path) -> Result<(), String> {
    let wrong = |e: std::io::Error| format!("{}: {e}", shown(folder));
    let root = folder.canonicalize().map_err(wrong)?;
    for input in project.passes.iter_mut().flat_map(|p| &mut p.inputs) {
        let is_drawn = input.kind == InputKind::Buffer || input.id == OutputId::CUBE;
        if !input.urls.is_empty() || input.src.is_empty() || is_drawn {
            continue;
        }
        let inside = input.src.trim_start_matches('/');
        let last = inside.rsplit('/').next().unwrap_or(inside);
        let candidates = [root.join(inside), root.join(last)];
        let Some(path) = candidates.iter().find_map(|p| p.canonicalize().ok()) else {
            continue;
        };
        if !path.starts_with(&root) {
            return Err(format!("`{}` leads out of {}", input.src, shown(folder)));
        }
        if path.is_file() && kind_of_file(&shown(&path)).is_some() {
            let found = media(&path, input.kind == InputKind::Cubemap)?;
            (input.name, input.urls) = (found.name, found.urls);
        }
    }
    Ok(())
}
