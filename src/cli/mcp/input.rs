//! What a tool reads: a file or a text.

use std::ffi::OsString;

/// What a tool reads.
#[derive(Clone, Copy, Debug)]
pub enum ToolInput<'a> {
    /// A file or folder.
    Path(&'a str),
    /// A text.
    Code(&'a str),
}

impl<'a> ToolInput<'a> {
    /// What is given: one of both.
    ///
    /// # Errors
    /// In words, where there is none, or both.
    pub fn of(path: Option<&'a String>, code: Option<&'a String>) -> Result<ToolInput<'a>, String> {
        match (path, code) {
            (Some(path), None) if path.is_empty() => Err("`path` is empty".to_string()),
            // It would be standard input, which is the client's.
            (Some(path), None) if path == "-" => Err("give the text as `code`".to_string()),
            (Some(path), None) => Ok(ToolInput::Path(path)),
            (None, Some(code)) => Ok(ToolInput::Code(code)),
            (None, None) => Err("give a `path` or some `code`".to_string()),
            (Some(_), Some(_)) => Err("give either `path` or `code`, not both".to_string()),
        }
    }

    /// Standard input of the command.
    pub fn text(self) -> &'a str {
        match self {
            ToolInput::Path(_) => "",
            ToolInput::Code(code) => code,
        }
    }

    /// The last arguments of the command. A path may begin as an option does.
    pub fn args(self) -> [OsString; 2] {
        let path = match self {
            ToolInput::Path(path) => path,
            ToolInput::Code(_) => "-",
        };
        ["--".into(), path.into()]
    }
}
