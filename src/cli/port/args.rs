//! Command-line arguments of `shaderport`.

use super::read;
use crate::cli::input::requests;
use crate::cli::output::Overwrite;
use crate::commands::PortRequest;
use crate::commands::run::InputRequest;
use crate::port::{Destination, Order, PageAddress, Poster, Target};
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Ports ShaderToy shaders to WebGL2.
///
/// Reads a shader file, a folder of passes or a ShaderToy export. Writes an HTML page, a JavaScript
/// module, plain shaders or shaders for another host.
#[derive(Parser, Clone, Default, Debug)]
#[command(name = "shaderport", version, max_term_width = 100)]
#[command(args_conflicts_with_subcommands = true, disable_help_subcommand = true)]
#[command(override_usage = "shaderport [OPTIONS] [INPUT]...\n       shaderport <COMMAND>")]
#[command(after_help = EXIT_CODES)]
pub struct PortArgs {
    /// Without a command, shaderport ports one shader
    #[command(subcommand)]
    pub(super) command: Option<PortCommand>,

    /// Shader file, ShaderToy export (.json) or folder of passes; `-` reads standard input
    ///
    /// The files of a folder, or several files, are assigned to passes by name: image.glsl,
    /// buffer_a.glsl, common.glsl, cubemap.glsl, sound.glsl. Several exports are written as a gallery.
    #[arg(value_name = "INPUT")]
    pub(super) input: Vec<PathBuf>,

    /// The text of the input, if its file has several shaders
    #[arg(skip)]
    pub(super) text: Option<String>,

    /// File of one pass: `image=a.glsl`, `buffer_a=b.glsl`
    #[arg(long, value_name = "PASS=FILE", help_heading = INPUT)]
    pub(super) pass: Vec<String>,
    /// Who completes the shader
    #[command(flatten)]
    pub(super) source: InputRequest,
    /// Folder with a copy of ShaderToy's media files, such as media/a/x.jpg, to embed in the output
    #[arg(long, value_name = "FOLDER", help_heading = INPUT)]
    pub(super) media: Option<PathBuf>,
    /// Largest media file to embed: `200M`
    #[arg(long, value_name = "SIZE", default_value = "64M", value_parser = read::size_of)]
    #[arg(help_heading = INPUT)]
    pub(super) max_media: u64,
    /// Leave channels with missing files black instead of drawing stand-ins
    #[arg(long, help_heading = INPUT)]
    pub(super) no_stand_ins: bool,
    /// Match ShaderToy's player exactly
    ///
    /// Channels that read the same buffer share the sampler settings that were set last. A channel
    /// with missing music is silent.
    #[arg(long, help_heading = INPUT)]
    pub(super) strict_player: bool,

    /// What the shader is ported to
    #[command(flatten)]
    pub(super) request: PortRequest,
    /// JSON file with both, as the MCP server writes it
    #[arg(long, value_name = "FILE", hide = true)]
    pub(super) asked: Option<PathBuf>,
    /// Overwrite existing files
    #[arg(long, help_heading = OUTPUT)]
    pub(super) force: bool,
    /// Rewrite the output whenever an input changes
    #[arg(long, conflicts_with = "diff", help_heading = OUTPUT)]
    pub(super) watch: bool,
    /// Serve the page at http://127.0.0.1:PORT, for this machine only
    ///
    /// With `--watch` the page reloads on each change and keeps its time, sliders and mouse. The
    /// default port is 4700.
    #[arg(long, value_name = "PORT", num_args = 0..=1, default_missing_value = "4700")]
    #[arg(require_equals = true, conflicts_with_all = ["diff", "output", "split"], help_heading = OUTPUT)]
    pub(super) serve: Option<u16>,
    /// Write a small page for frames of other pages: without a panel, and with a still image until the
    /// shader plays
    ///
    /// The image is drawn without a GPU.
    #[arg(long, conflicts_with_all = ["diff", "serve", "playground"], help_heading = OUTPUT)]
    pub(super) embed: bool,
    /// Let the shader of the page wait for a click; nothing is compiled before that
    #[arg(long, requires = "embed", help_heading = OUTPUT)]
    pub(super) click: bool,
    /// Address at which the page will be published: `https://example.org/water.html`
    ///
    /// Also writes the still image beside the page and names it in `og:image`, for link previews.
    #[arg(long, value_name = "ADDRESS", value_parser = PageAddress::read, requires_all = ["embed", "output"])]
    #[arg(help_heading = OUTPUT)]
    pub(super) url: Option<PageAddress>,
    /// Repair code that does not compile where only one fix is possible
    ///
    /// Repairs old GLSL, reserved and built-in names, global initialisers that are not constant, and
    /// missing qualifiers. Each repair is reported.
    #[arg(long, help_heading = CHECKS)]
    pub(super) repair: bool,
    /// Show the repairs as a diff and write nothing
    #[arg(long, help_heading = CHECKS, conflicts_with_all = ["split", "playground"])]
    pub(super) diff: bool,
    /// Verify for each pass that the output draws the same as the input
    ///
    /// Reads the output back. A pass is the same if its code is identical or if thousands of pixels
    /// match bit for bit.
    #[arg(long, conflicts_with = "diff", help_heading = CHECKS)]
    pub(super) verify: bool,
    /// Show which files were opened, and as which passes
    #[arg(short, long, global = true)]
    pub(super) verbose: bool,
}

/// The commands of `shaderport`.
#[derive(Subcommand, Clone, Debug)]
pub(super) enum PortCommand {
    /// Write a page of many shaders: a still image of each that links to its page
    ///
    /// To port a file or folder called `gallery`, write `./gallery`.
    Gallery(GalleryArgs),
}

/// The arguments of `shaderport gallery`.
#[derive(Args, Clone, Debug)]
#[command(after_help = GALLERY_EXIT_CODES)]
pub(super) struct GalleryArgs {
    /// Folders, files, ShaderToy exports (.json) and folders of passes
    ///
    /// An export may be an array of shaders.
    #[arg(value_name = "INPUT", required = true)]
    pub(super) input: Vec<PathBuf>,
    /// Output folder: index.html, and a page and an image for each shader
    #[arg(short, long, value_name = "OUT")]
    pub(super) output: PathBuf,
    /// Title of the page; default: the name of the input folder, or else of the output folder
    #[arg(long, value_name = "TITLE")]
    pub(super) title: Option<String>,
    /// Address at which the output folder will be published: `https://example.org/shaders/`
    ///
    /// Names the still images in `og:image`, for link previews.
    #[arg(long, value_name = "ADDRESS", value_parser = PageAddress::read)]
    pub(super) url: Option<PageAddress>,
    /// Site or library that the shaders are written for; default: detected for each
    #[arg(long, value_name = "NAME")]
    pub(super) host: Option<String>,
    /// Let each shader wait for a click, instead of playing when it is seen
    #[arg(long)]
    pub(super) click: bool,
    /// Rewrite the pages of shaders that change
    #[arg(long)]
    pub(super) watch: bool,
    /// Overwrite existing files
    #[arg(long)]
    pub(super) force: bool,
}

const GALLERY_EXIT_CODES: &str = "\
Exit codes:
  0  All shaders are in the gallery
  1  Shaders with errors were left out
  2  Wrong usage, or a file cannot be read or written";

/// The playground beside the documentation, once that has an address.
const PLAYGROUND: Option<&str> = match env!("CARGO_PKG_HOMEPAGE").is_empty() {
    true => None,
    false => Some(concat!(env!("CARGO_PKG_HOMEPAGE"), "playground/")),
};

const INPUT: &str = "Input";
const OUTPUT: &str = "Output";
const CHECKS: &str = "Repair and verification";
const EXIT_CODES: &str = "\
Exit codes:
  0  No errors
  1  The shader has errors, or --verify did not confirm the output
  2  Wrong usage, or a file cannot be read or written";

impl PortArgs {
    /// The arguments with the requests of a file, if one is named.
    pub(super) fn completed(mut self) -> Result<PortArgs, String> {
        if let Some(path) = &self.asked {
            (self.source, self.request) = requests(path)?;
        }
        Ok(self)
    }

    /// The build order that these arguments describe.
    pub(super) fn order<'a>(
        &'a self,
        target: Target,
        output: Destination<'a>,
        version: Option<&'a str>,
        poster: Option<&'a Poster>,
    ) -> Order<'a> {
        let order = self.request.order(target, output);
        Order {
            version,
            poster,
            playground: order.playground.or(PLAYGROUND),
            ..order
        }
    }

    /// The output format: `--target`, or else chosen by the extension of the output.
    pub(super) fn target(&self) -> Result<Target, String> {
        let request = &self.request;
        let usual = match self.embed || request.split || self.serve.is_some() {
            true => Target::Html,
            false => Target::Glsl,
        };
        let target = match request.target(usual) {
            // A folder may have an extension in its name.
            Ok(_) if self.is_folder() && usual == Target::Html => usual,
            Err(_) if self.is_folder() => usual,
            target => target?,
        };
        let page = [
            ("--embed", self.embed),
            ("--split", request.split),
            ("--playground", request.playground.is_some()),
        ];
        match page.iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) if target != Target::Html => Err(format!(
                "`{option}` requires an HTML page; use `-o NAME.html`"
            )),
            _ if request.split && !self.is_saved() => {
                Err("`--split` requires `-o FILE`: further files are written beside it".to_string())
            }
            _ => Ok(target),
        }
    }

    /// Whether an existing folder is written to, and no target is named.
    fn is_folder(&self) -> bool {
        let request = &self.request;
        request.target.is_none() && request.output.as_ref().is_some_and(|path| path.is_dir())
    }

    /// Whether the output goes to files and not to standard output.
    pub(super) fn is_saved(&self) -> bool {
        let output = self.request.output.as_ref();
        output.is_some_and(|path| path.as_os_str() != "-")
    }

    /// Whether existing files may be overwritten.
    pub(super) fn overwrite(&self) -> Overwrite {
        Overwrite::if_forced(self.force)
    }
}
