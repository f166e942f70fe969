//! Runs the command that the arguments of `shaderlint` name.

use super::command::{CLEAN, FAILED, FINDINGS, TextOrJson, complain};
#[cfg(feature = "dap")]
use super::dap;
use super::lint::{self, Command, LintArgs, ProgramName, init, ir, reduce};
#[cfg(feature = "lsp")]
use super::lsp;
use super::port::PortArgs;
use super::{fmt, run as draw, test, types};
#[cfg(feature = "mcp")]
use super::{mcp, port, usage};
use crate::commands::{self, rule_list, rule_table};
use crate::engine::config::schema;
use clap::CommandFactory;
use std::io::{self, Write};

/// Runs the command and returns the exit code.
pub fn run(args: &LintArgs) -> u8 {
    args.global.apply();
    let code = match (&args.command, &args.explain) {
        (Some(command), _) => run_command(command),
        (None, Some(name)) => explain(std::slice::from_ref(name)),
        (None, None) => lint::run(&args.check),
    };
    match code {
        Ok(code) => code,
        // The reader of the output closed it.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => FINDINGS,
        Err(error) => {
            complain(&error.to_string());
            FAILED
        }
    }
}

fn run_command(command: &Command) -> io::Result<u8> {
    // Collected first, because the libraries that print panic on closed pipes.
    let mut text = Vec::new();
    match command {
        Command::Check(args) => return lint::run(args),
        Command::Init => return init::run(),
        Command::Explain { words } => return explain(words),
        Command::Fmt(args) => return fmt::run(args),
        Command::Run(args) => return draw::run(args),
        Command::Test(args) => return test::run(args),
        Command::Reduce(args) => return reduce::run(args),
        Command::Ir { file } => return ir::run(file),
        Command::Types(args) => return types::run(args),
        Command::Reflect(args) => return types::print_reflection(args),
        #[cfg(feature = "lsp")]
        Command::References(args) => return lsp::references(args),
        #[cfg(feature = "lsp")]
        Command::Lsp { .. } => {
            let was_shut_down = lsp::serve()?;
            return Ok(if was_shut_down { CLEAN } else { FINDINGS });
        }
        #[cfg(feature = "dap")]
        Command::Dap => return dap::serve().map(|()| CLEAN),
        #[cfg(feature = "mcp")]
        Command::Mcp => return mcp::serve().map(|()| CLEAN),
        #[cfg(feature = "mcp")]
        Command::Port { args } => {
            let args = std::iter::once("shaderport".into()).chain(args.iter().cloned());
            return Ok(usage::read(args).map_or_else(|code| code, |args| port::run(&args)));
        }
        Command::Rules { format } => match format {
            TextOrJson::Human => text = rule_table().into_bytes(),
            TextOrJson::Json => {
                text = serde_json::to_vec_pretty(&rule_list())?;
                text.push(b'\n');
            }
        },
        Command::Completions { shell, program } => {
            let mut command = described(*program);
            let name = command.get_name().to_string();
            clap_complete::generate(*shell, &mut command, name, &mut text);
        }
        Command::Man { program } => clap_mangen::Man::new(described(*program)).render(&mut text)?,
        Command::Schema => text.extend_from_slice(schema().as_bytes()),
    }
    io::stdout().lock().write_all(&text)?;
    Ok(CLEAN)
}

/// The arguments of a program.
pub fn described(program: ProgramName) -> clap::Command {
    match program {
        ProgramName::Shaderlint => LintArgs::command(),
        ProgramName::Shaderport => PortArgs::command(),
    }
}

/// Prints the documentation of a rule, compile error or host, and returns the exit code.
fn explain(words: &[String]) -> io::Result<u8> {
    if words.is_empty() {
        complain("`explain` requires a name; `shaderlint rules` lists those of rules");
        return Ok(FAILED);
    }
    match commands::explain(words) {
        Ok(text) => {
            io::stdout().lock().write_all(text.as_bytes())?;
            Ok(CLEAN)
        }
        Err(message) => {
            complain(&message);
            Ok(FAILED)
        }
    }
}
