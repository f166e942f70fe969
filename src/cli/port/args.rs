//! The arguments of `shaderport`.

use super::read;
use crate::cli::output::Overwrite;
#[cfg(feature = "naga")]
use crate::port::naga::FirstRow;
use crate::port::{Destination, MainChoice, Order, Target};
use clap::Parser;
use std::path::{Path, PathBuf};

/// Turns ShaderToy code into WebGL2: a shader file, a folder of passes or an export in, a page that
/// plays it, a module or plain shaders out.
#[derive(Parser, Debug)]
#[command(name = "shaderport", version, about, max_term_width = 100)]
pub struct PortArgs {
    /// A shader file, a ShaderToy export (.json), a folder or several files whose names tell their
    /// passes (image.glsl, buffer_a.glsl, common.glsl, cubemap.glsl, sound.glsl); `-` is standard
    /// input
    #[arg(value_name = "INPUT")]
    pub(super) input: Vec<PathBuf>,
    /// File to write, or folder for several shaders; without it the first file goes to standard
    /// output
    #[arg(short, long, value_name = "PATH")]
    pub(super) output: Option<PathBuf>,
    /// What to make; without it the ending of the output tells
    #[arg(short, long, value_enum, value_name = "TARGET")]
    pub(super) target: Option<Target>,
    /// Who runs the code, like `shadertoy`, `glsl-sandbox` or `bonzomatic`, or a file that describes one;
    /// without it the configuration or the code tells.
    /// An unknown name shows all
    #[arg(long, value_name = "NAME", visible_alias = "from")]
    pub(super) host: Option<String>,
    /// File of a pass, like `image=a.glsl` or `buffer_a=b.glsl`
    #[arg(long, value_name = "PASS=FILE")]
    pub(super) pass: Vec<String>,
    /// What a channel reads, like `0=keyboard`, `image.1=photo.jpg`, `buffer_a.0=buffer_a` or, by the
    /// name of a sampler, `u_tex0=photo.jpg`; behind it may stand how, like `,nearest,clamp,noflip`
    #[arg(long, value_name = "[PASS.]N=SOURCE")]
    pub(super) channel: Vec<String>,
    /// Folder with the site's files, such as media/a/x.jpg, to be put into the output
    #[arg(long, value_name = "FOLDER")]
    pub(super) media: Option<PathBuf>,
    /// Largest file that goes onto a channel and into the output, like `200M`
    #[arg(long, value_name = "SIZE", default_value = "64M", value_parser = read::size_of)]
    pub(super) max_media: u64,
    /// Leave channels black whose files are not at hand, instead of drawing something like them
    #[arg(long)]
    pub(super) no_stand_ins: bool,
    /// Write what a host must know of a WGSL, SPIR-V, HLSL or MSL shader beside it, as FILE.json: the
    /// places of uniforms, textures, attributes and varyings
    #[cfg(feature = "naga")]
    #[arg(long)]
    pub(super) interface: bool,
    /// Which row of the picture a WGSL, SPIR-V, HLSL or MSL shader draws first
    #[cfg(feature = "naga")]
    #[arg(long, value_enum, default_value_t, value_name = "ROW")]
    pub(super) first_row: FirstRow,
    /// How plain shaders get their `main`
    #[arg(long, value_enum, default_value_t, value_name = "HOW")]
    pub(super) main: MainChoice,
    /// Read back what is written, and tell by pass whether it draws what the original draws: proved
    /// by the same code, or the same bits on thousands of pixels
    #[arg(long, conflicts_with = "diff")]
    pub(super) verify: bool,
    /// Do as ShaderToy's player does where two channels read one buffer: the last setting wins; and
    /// where music is not at hand: nothing is on its channel
    #[arg(long)]
    pub(super) strict_player: bool,
    /// Mend code that does not compile where there is one answer: old GLSL, names that are reserved or
    /// built in, global values that are not constant, missing qualifiers; each repair is told
    #[arg(long)]
    pub(super) repair: bool,
    /// Show the repairs as a diff, and write nothing
    #[arg(long)]
    pub(super) diff: bool,
    /// Write over a file that is there already
    #[arg(long)]
    pub(super) force: bool,
    /// Make the output again whenever a file changes, until it is stopped
    #[arg(long, conflicts_with = "diff")]
    pub(super) watch: bool,
    /// Show the page at http://127.0.0.1, for programs on this machine alone; with `--watch` it is
    /// drawn anew at each change, and time, sliders and mouse stay
    #[arg(long, value_name = "PORT", num_args = 0..=1, default_missing_value = "4700")]
    #[arg(require_equals = true, conflicts_with_all = ["diff", "output"])]
    pub(super) serve: Option<u16>,
}

impl PortArgs {
    /// What is to be made, and how.
    pub(super) fn order<'a>(
        &self,
        target: Target,
        output: Destination<'a>,
        version: Option<&'a str>,
    ) -> Order<'a> {
        Order {
            target,
            main: self.main,
            output,
            version,
            #[cfg(feature = "naga")]
            interface: self.interface,
            #[cfg(feature = "naga")]
            first_row: self.first_row,
        }
    }

    /// What to make: what is asked for, else what the ending of the output tells.
    pub(super) fn target(&self) -> Result<Target, String> {
        let path = self.output.as_deref().unwrap_or(Path::new(""));
        match (self.target, self.serve) {
            (Some(target), _) => Ok(target),
            (None, Some(_)) if self.output.is_none() => Ok(Target::Html),
            // A folder may have any name.
            (None, _) if path.is_dir() => Ok(Target::of_path(path).unwrap_or(Target::Glsl)),
            (None, _) if path.as_os_str() == "-" => Ok(Target::Glsl),
            (None, _) => Target::of_path(path).map_err(|e| format!("-o {}: {e}", path.display())),
        }
    }

    /// Whether files are written, and not standard output.
    pub(super) fn is_saved(&self) -> bool {
        self.output
            .as_ref()
            .is_some_and(|path| path.as_os_str() != "-")
    }

    /// Whether a file may be in the way.
    pub(super) fn overwrite(&self) -> Overwrite {
        match self.force {
            true => Overwrite::Allowed,
            false => Overwrite::Never,
        }
    }
}
