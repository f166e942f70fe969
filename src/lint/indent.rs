//! How far in code stands on its line.

use shaderlint_semantic::Program;
use shaderlint_syntax::ast::TokenId;

/// A line, and the blanks that it begins with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Indent<'p> {
    /// The line; 1 is the first.
    pub line: u32,
    /// What stands before the first code of it.
    pub blanks: &'p str,
}

impl Indent<'_> {
    /// Whether it begins with more of the same blanks than another; tabs against blanks tell nothing.
    pub fn is_deeper_than(&self, other: &Indent) -> bool {
        self.blanks.len() > other.blanks.len() && self.blanks.starts_with(other.blanks)
    }
}

/// The line that a token begins; `None` where other code stands before it.
pub fn indent(program: &Program, token: TokenId) -> Option<Indent<'_>> {
    let (line, before) = before(program, token)?;
    let is_first = before.bytes().all(|b| matches!(b, b' ' | b'\t'));
    is_first.then_some(Indent {
        line,
        blanks: before,
    })
}

/// How far the line of a token stands in, whatever stands before the token.
pub fn line_indent(program: &Program, token: TokenId) -> Option<Indent<'_>> {
    let (line, before) = before(program, token)?;
    let blanks = before.len() - before.trim_start_matches([' ', '\t']).len();
    let blanks = before.get(..blanks)?;
    Some(Indent { line, blanks })
}

/// The number of a token's line, and what stands on it before the token.
fn before(program: &Program, token: TokenId) -> Option<(u32, &str)> {
    let start = program.token(token)?.span.start;
    let file = program.sources.file_at(start)?;
    let offset = start.checked_sub(file.base)?;
    let (line, _) = file.lines().bounds(offset, file.text.len() as u32);
    let text = file.text.get(line as usize..offset as usize)?;
    Some((file.position(start).line, text))
}
