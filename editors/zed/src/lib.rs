//! Starts `shaderlint lsp` in Zed: the program on `PATH`, or else the npm package.

use zed_extension_api::settings::LspSettings;
use zed_extension_api::{self as zed, LanguageServerId, Worktree, serde_json};

const PACKAGE: &str = "shaderlint";

struct Shaderlint;

impl zed::Extension for Shaderlint {
    fn new() -> Shaderlint {
        Shaderlint
    }

    fn language_server_command(
        &mut self,
        id: &LanguageServerId,
        worktree: &Worktree,
    ) -> zed::Result<zed::Command> {
        let (command, mut args) = match worktree.which(PACKAGE) {
            Some(program) => (program, Vec::new()),
            None => (zed::node_binary_path()?, vec![installed(id)?]),
        };
        args.push("lsp".to_string());
        Ok(zed::Command {
            command,
            args,
            env: Vec::new(),
        })
    }

    fn language_server_initialization_options(
        &mut self,
        id: &LanguageServerId,
        worktree: &Worktree,
    ) -> zed::Result<Option<serde_json::Value>> {
        let settings = LspSettings::for_worktree(id.as_ref(), worktree)?;
        Ok(settings.initialization_options)
    }
}

/// The script that starts the program of the npm package, which is installed or updated first.
fn installed(id: &LanguageServerId) -> zed::Result<String> {
    let installed = zed::npm_package_installed_version(PACKAGE)?;
    let newest = match (zed::npm_package_latest_version(PACKAGE), installed.clone()) {
        (Ok(newest), _) => newest,
        // Without a network the installed one is good enough.
        (Err(_), Some(installed)) => installed,
        (Err(error), None) => return Err(error),
    };
    if installed.as_ref() != Some(&newest) {
        let status = zed::LanguageServerInstallationStatus::Downloading;
        zed::set_language_server_installation_status(id, &status);
        zed::npm_install_package(PACKAGE, &newest)?;
    }
    let folder = std::env::current_dir().map_err(|e| e.to_string())?;
    let script = folder.join("node_modules/shaderlint/bin/shaderlint.js");
    Ok(script.to_string_lossy().into_owned())
}

zed::register_extension!(Shaderlint);
