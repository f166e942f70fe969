//! Several shaders as the input of `shaderport`, without `gallery`.

use crate::cli::port::args::{GalleryArgs, PortArgs};
use crate::cli::port::read::read_text;
use crate::project::exports_in;
use std::path::{Path, PathBuf};

/// The gallery that `shaderport *.json -o site/` asks for; `None` if the input is one shader.
///
/// # Errors
/// If the input is several shaders and another argument is about one, or if a file cannot be read.
pub(in crate::cli::port) fn gallery_of(args: &PortArgs) -> Result<Option<GalleryArgs>, String> {
    if args.text.is_some() || !is_batch(&args.input)? {
        return Ok(None);
    }
    let of_one = [
        ("--pass", !args.pass.is_empty()),
        ("--channel", !args.source.channels.is_empty()),
        ("--media", args.media.is_some()),
        (
            "--target",
            args.request.target.as_ref().is_some_and(|t| t != "html"),
        ),
        ("--serve", args.serve.is_some()),
        ("--repair", args.repair),
        ("--diff", args.diff),
        ("--verify", args.verify),
    ];
    if let Some((option, _)) = of_one.iter().find(|(_, is_given)| *is_given) {
        return Err(format!(
            "`{option}` requires one shader, but the input has several"
        ));
    }
    let output = args.request.output.clone().filter(|path| is_folder(path));
    let output =
        output.ok_or("the input has several shaders; `-o FOLDER` writes a page for each")?;
    Ok(Some(GalleryArgs {
        input: args.input.clone(),
        output,
        title: None,
        url: args.url.clone(),
        host: args.source.host.clone(),
        click: args.click,
        watch: args.watch,
        force: args.force,
    }))
}

/// Whether the inputs are several exports, or an export of several shaders.
fn is_batch(inputs: &[PathBuf]) -> Result<bool, String> {
    let is_export = |path: &PathBuf| path.extension().is_some_and(|e| e == "json");
    match inputs {
        [one] if is_export(one) && one.is_file() => Ok(exports_in(&read_text(one)?).len() > 1),
        [_] => Ok(false),
        several => Ok(several.iter().any(is_export)),
    }
}

/// Whether a path is a folder, or will be one.
fn is_folder(path: &Path) -> bool {
    let is_new = path.extension().is_none() && !path.exists() && path.as_os_str() != "-";
    is_new || path.is_dir() || path.to_string_lossy().ends_with(['/', '\\'])
}
