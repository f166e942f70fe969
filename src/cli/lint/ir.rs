//! `ir`: prints the IR of a shader, for work on the analyses.

use super::super::command::{CLEAN, FAILED, complain};
use super::super::config::configs;
use super::super::disk::Disk;
use crate::engine::analyze;
use crate::engine::config::ConfigArgs;
use crate::ir::{print, verify};
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Prints the IR of each shader in a file, and returns the exit code.
pub fn run(file: &Path) -> io::Result<u8> {
    let name = file.display().to_string();
    let text = fs::read_to_string(file).map_err(|e| io::Error::other(format!("{name}: {e}")))?;
    let options = configs(ConfigArgs::default()).options(file);
    let options = options.map_err(|e| io::Error::other(e.to_string()))?;
    let report = analyze(&name, &text, &options, &Disk::new());
    if let Some(unread) = report.unread {
        complain(&format!("{name}: {unread}"));
        return Ok(FAILED);
    }
    let mut code = CLEAN;
    let printed = report.analyses.iter().map(|analysis| {
        let (program, module) = (&analysis.program, analysis.module());
        for problem in verify(program, module) {
            complain(&format!("{name}: invalid IR: {problem}"));
            code = FAILED;
        }
        print(program, module)
    });
    let text = printed.collect::<Vec<_>>().join("\n");
    io::stdout().lock().write_all(text.as_bytes())?;
    Ok(code)
}
