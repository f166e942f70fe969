//! The input of a tool: a file or a text.

use std::ffi::OsString;

/// The input of a tool.
#[derive(Clone, Copy, Debug)]
pub enum ToolInput<'a> {
    /// Path of a file or folder.
    Path(&'a str),
    /// Text of a shader.
    Code(&'a str),
}

impl<'a> ToolInput<'a> {
    /// Accepts exactly one of path and code.
    ///
    /// # Errors
    /// A message if both or neither are given.
    pub fn of(path: Option<&'a String>, code: Option<&'a String>) -> Result<ToolInput<'a>, String> {
        match (path, code) {
            (Some(path), None) if path.is_empty() => Err("`path` is empty".to_string()),
            // It would mean standard input, which the protocol uses.
            (Some(path), None) if path == "-" => Err("pass the text as `code`".to_string()),
            (Some(path), None) => Ok(ToolInput::Path(path)),
            (None, Some(code)) => Ok(ToolInput::Code(code)),
            (None, None) => Err("pass a `path` or some `code`".to_string()),
            (Some(_), Some(_)) => Err("pass either `path` or `code`, not both".to_string()),
        }
    }

    /// The standard input of the command.
    pub fn text(self) -> &'a str {
        match self {
            ToolInput::Path(_) => "",
            ToolInput::Code(code) => code,
        }
    }

    /// The last arguments of the command, after `--` because a path may look like an option.
    pub fn args(self) -> [OsString; 2] {
        let path = match self {
            ToolInput::Path(path) => path,
            ToolInput::Code(_) => "-",
        };
        ["--".into(), path.into()]
    }
}
