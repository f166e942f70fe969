//! What is asked of a port: the same for the command line, MCP and WebAssembly.

use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser};
use serde::{Deserialize, Serialize};
#[cfg(feature = "naga")]
use shaderlint_port::naga::FirstRow;
use shaderlint_port::{Destination, MainChoice, Order, PageAddress, Target};
use shaderlint_project::SliderChoice;
use std::path::{Path, PathBuf};

/// What a shader is ported to.
#[derive(clap::Args, Clone, Default, Debug, Serialize, Deserialize, schemars::JsonSchema)]
#[command(next_help_heading = "Output")]
#[serde(default, rename_all = "camelCase")]
pub struct PortRequest {
    /// Output file, or folder for several shaders; default: the first file, on standard output
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
    /// Output format, or host that the shader is written for; default: chosen by the extension of the
    /// output
    #[arg(short, long, value_parser = PossibleValuesParser::new(targets()), value_name = "TARGET")]
    #[schemars(schema_with = "target_schema")]
    pub target: Option<String>,
    /// How plain shaders get a `main` function
    #[arg(long, value_enum, default_value_t, value_name = "HOW")]
    pub main: MainChoice,
    /// Values in the code that get sliders in pages and modules
    #[arg(long, value_enum, default_value_t, value_name = "WHICH")]
    pub sliders: SliderChoice,
    /// Write the script and the style of the page as files beside it
    ///
    /// For sites whose policy allows only files: `script-src 'self'`.
    #[arg(long)]
    pub split: bool,
    /// Address of the playground whose debugger the page offers: `https://example.org/playground/`
    ///
    /// A button opens it with the shader, at the time of the page and the pixel that was clicked last.
    #[arg(long, value_name = "ADDRESS", value_parser = folder_of)]
    pub playground: Option<String>,
    /// Write the resource interface of each shader to FILE.json
    ///
    /// Lists the locations and bindings of uniforms, textures, attributes and varyings.
    #[cfg(feature = "naga")]
    #[arg(long, help_heading = TRANSLATION)]
    pub interface: bool,
    /// Which row of the image is drawn first
    #[cfg(feature = "naga")]
    #[arg(long, value_enum, default_value_t, value_name = "ROW", help_heading = TRANSLATION)]
    pub first_row: FirstRow,
}

#[cfg(feature = "naga")]
const TRANSLATION: &str = "WGSL, SPIR-V, HLSL and MSL";

impl PortRequest {
    /// The output format that is asked for; else that of the output's extension, or `usual` without one.
    ///
    /// # Errors
    /// A message about an unknown target or extension, or an invalid address.
    pub fn target(&self, usual: Target) -> Result<Target, String> {
        self.playground.as_deref().map(folder_of).transpose()?;
        let path = self.output.as_deref().unwrap_or(Path::new(""));
        match &self.target {
            Some(name) => {
                let host = || {
                    Target::hosts()
                        .find(|host| host.name == name)
                        .map(Target::Host)
                };
                let format = Target::from_str(name, false).ok().or_else(host);
                let known = targets().map(|target| format!("`{}`", target.get_name()));
                let known = || known.collect::<Vec<_>>().join(", ");
                format
                    .ok_or_else(|| format!("unknown target `{name}`; expected one of {}", known()))
            }
            None if path.as_os_str().is_empty() || path.as_os_str() == "-" => Ok(usual),
            None => Target::of_path(path).map_err(|e| format!("-o {}: {e}", path.display())),
        }
    }

    /// The build order, without what only some fronts have.
    pub fn order<'a>(&'a self, target: Target, output: Destination<'a>) -> Order<'a> {
        Order {
            target,
            main: self.main,
            output,
            version: None,
            poster: None,
            split: self.split,
            playground: self.playground.as_deref(),
            #[cfg(feature = "naga")]
            interface: self.interface,
            #[cfg(feature = "naga")]
            first_row: self.first_row,
        }
    }
}

/// The names of the output formats, and of the hosts that shaders are written for.
fn targets() -> impl Iterator<Item = PossibleValue> {
    let formats = Target::value_variants().iter();
    let formats = formats.filter_map(|target| target.to_possible_value());
    let hosts = Target::hosts()
        .map(|host| PossibleValue::new(host.name).help(format!("Shader for {}", host.read_as())));
    formats.chain(hosts)
}

fn target_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let names: Vec<String> = targets()
        .map(|target| target.get_name().to_string())
        .collect();
    schemars::json_schema!({ "type": "string", "enum": names })
}

/// The address of a folder.
fn folder_of(text: &str) -> Result<String, String> {
    PageAddress::read_folder(text).map(|address| address.text().to_string())
}
