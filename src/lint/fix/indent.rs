//! Indentation of lines.

use shaderlint_semantic::Program;
use shaderlint_syntax::ast::TokenId;

/// A line and its leading blanks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Indent<'p> {
    /// Line number, from 1.
    pub line: u32,
    /// The blanks before the first code.
    pub blanks: &'p str,
}

impl Indent<'_> {
    /// Whether it extends the indentation of another; tabs and spaces are not comparable.
    pub fn is_deeper_than(&self, other: &Indent) -> bool {
        self.blanks.len() > other.blanks.len() && self.blanks.starts_with(other.blanks)
    }
}

/// The indentation of a token that is the first on its line; `None` for other tokens.
pub fn indent(program: &Program, token: TokenId) -> Option<Indent<'_>> {
    let (line, before) = before(program, token)?;
    let is_first = before.bytes().all(|b| matches!(b, b' ' | b'\t'));
    is_first.then_some(Indent {
        line,
        blanks: before,
    })
}

/// The indentation of the line of a token.
pub fn line_indent(program: &Program, token: TokenId) -> Option<Indent<'_>> {
    let (line, before) = before(program, token)?;
    let blanks = before.len() - before.trim_start_matches([' ', '\t']).len();
    let blanks = before.get(..blanks)?;
    Some(Indent { line, blanks })
}

/// The line number of a token, and the text before it on that line.
fn before(program: &Program, token: TokenId) -> Option<(u32, &str)> {
    let start = program.token(token)?.span.start;
    let file = program.sources.file_at(start)?;
    let offset = start.checked_sub(file.base)?;
    let (line, _) = file.lines().bounds(offset, file.text.len() as u32);
    let text = file.text.get(line as usize..offset as usize)?;
    Some((file.position(start).line, text))
}
