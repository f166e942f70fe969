//! The declarations that hosts add to a text.

use crate::options::{HostUniform, Options};
use shaderlint_host::{Preset, declared_in};
use shaderlint_syntax::{Lexer, RawKind, TokenKind as T};
use shaderlint_text::{FileId, Role, Sources};
use std::collections::BTreeSet;

/// The declarations that a host adds, without names that the text declares itself: other releases
/// of a host declare fewer names, and texts may repeat declarations. Whether the text has its own output is
/// decided by its declarations, if it is not known.
pub fn prelude(
    preset: &Preset,
    code: &str,
    is_vertex: bool,
    has_own_output: Option<bool>,
) -> String {
    let own = PreludeNames::of(code);
    let mut text = String::new();
    if has_own_output.unwrap_or(own.has_output) {
        text.push_str("#define OWN_OUTPUT 1\n");
    }
    let mut depth = 0_usize;
    for line in preset.declarations(is_vertex).split_inclusive('\n') {
        let is_outside = depth == 0;
        depth += line.matches('{').count();
        depth = depth.saturating_sub(line.matches('}').count());
        let is_single = is_outside && depth == 0;
        let is_repeated = is_single && declared_in(line).is_some_and(|n| own.names.contains(n));
        text.push_str(if is_repeated { "\n" } else { line });
    }
    text
}

/// Whether a text declares an output.
pub fn declares_output(code: &str) -> bool {
    PreludeNames::of(code).has_output
}

/// The names that a text declares outside of functions.
#[derive(Default)]
struct PreludeNames<'t> {
    names: BTreeSet<&'t str>,
    /// Whether it declares an output.
    has_output: bool,
}

impl<'t> PreludeNames<'t> {
    fn of(code: &'t str) -> PreludeNames<'t> {
        let mut found = PreludeNames::default();
        let mut lexer = Lexer::new(code, 0);
        let mut depth = 0_usize;
        let mut last: Option<&str> = None;
        let mut before: Option<&str> = None;
        loop {
            let token = lexer.next_token();
            let word = code.get(token.span.start as usize..token.span.end as usize);
            match token.kind {
                RawKind::End => return found,
                RawKind::Whitespace | RawKind::Newline => continue,
                RawKind::LineComment | RawKind::BlockComment => continue,
                RawKind::Word if depth == 0 => {
                    found.has_output |= word == Some("out");
                    if last == Some("define") {
                        found.names.extend(word);
                    }
                    before = last;
                    last = word;
                    continue;
                }
                RawKind::Operator(T::LeftParen | T::LeftBrace) => {
                    found.note(before, last);
                    depth += 1;
                }
                RawKind::Operator(T::RightParen | T::RightBrace) => depth = depth.saturating_sub(1),
                RawKind::Operator(T::Semicolon | T::LeftBracket | T::Equal | T::Comma) => {
                    found.note(before, last);
                }
                _ => {}
            }
            (before, last) = (None, None);
        }
    }

    /// Records a name if it is followed by the end of a declarator.
    fn note(&mut self, before: Option<&str>, name: Option<&'t str>) {
        if before.is_some() {
            self.names.extend(name);
        }
    }
}

/// Inserts the declarations of the host before the text, but after `#version`.
pub fn with_host(
    sources: &mut Sources,
    header: Option<String>,
    own: Vec<FileId>,
    options: &Options,
) -> Option<Vec<FileId>> {
    let declared = declarations(sources, &own, &options.host.uniforms);
    let Some(header) = header else {
        if declared.is_empty() {
            return Some(own);
        }
        let prelude = sources.add("", None, Role::Prelude, declared)?;
        return after_version(sources, own, prelude);
    };
    let mut files = vec![sources.add("", None, Role::Prelude, header + &declared)?];
    files.extend(own);
    Some(files)
}

/// The declarations of the host's uniforms, without those that the shader declares itself.
fn declarations(sources: &Sources, own: &[FileId], uniforms: &[HostUniform]) -> String {
    let texts = || own.iter().filter_map(|id| Some(sources.code(*id)?.text));
    let mut text = String::new();
    for uniform in uniforms {
        let HostUniform { name, ty, size } = uniform;
        if texts().any(|code| declares(code, name)) {
            continue;
        }
        let precision = if ty.starts_with('b') { "" } else { "highp " };
        let size = size.map_or(String::new(), |s| format!("[{s}]"));
        text.push_str(&format!("uniform {precision}{ty} {name}{size};\n"));
    }
    text
}

/// Whether a text declares a uniform of this name.
fn declares(code: &str, name: &str) -> bool {
    if !code.contains(name) {
        return false;
    }
    let mut lexer = Lexer::new(code, 0);
    let mut in_uniform = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match (token.kind, code.get(range).unwrap_or("")) {
            (RawKind::End, _) => return false,
            (RawKind::Word, "uniform") => in_uniform = true,
            (RawKind::Word, word) if in_uniform && word == name => return true,
            (_, ";") => in_uniform = false,
            _ => {}
        }
    }
}

/// Inserts declarations after the line with `#version`, or at the start if there is none.
pub fn after_version(
    sources: &mut Sources,
    own: Vec<FileId>,
    prelude: FileId,
) -> Option<Vec<FileId>> {
    let mut own = own.into_iter();
    let first = own.next()?;
    let code = sources.code(first)?;
    let (text, base) = (code.text.to_string(), code.base);
    let mut files = Vec::new();
    match version_end(&text) {
        None => files.extend([prelude, first]),
        Some(after) => {
            let file = sources.file_id_at(base)?;
            let offset = (base - sources.file(file)?.base) as usize;
            files.push(sources.embed(file, offset, text.get(..after)?)?);
            files.push(prelude);
            files.push(sources.embed(file, offset + after, text.get(after..)?)?);
        }
    }
    files.extend(own);
    Some(files)
}

/// The start of the line after `#version`.
fn version_end(text: &str) -> Option<usize> {
    let mut lexer = Lexer::new(text, 0);
    let mut after_hash = false;
    let mut seen = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match token.kind {
            RawKind::End => return None,
            RawKind::Newline if seen => return Some(range.end),
            RawKind::Hash => after_hash = true,
            RawKind::Word => {
                seen |= after_hash && text.get(range) == Some("version");
                after_hash = false;
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn host_declarations_that_the_shader_repeats_are_omitted() {
        let preset = Preset {
            prelude: "uniform mat4 a;\nfloat f(float x);\n#define B 1\nuniform vec3 c[4];\n\
                layout(location = 0) out vec4 d;\n"
                .to_string(),
            ..Preset::default()
        };
        let own =
            "uniform mat4 a;\n#define B 2\nvec4 g() { vec3 c; return d; }\nfloat f(float y) { }";
        let shown = prelude(&preset, own, true, None);
        let left: Vec<&str> = shown.lines().filter(|l| l.contains(';')).collect();
        assert_eq!(
            left,
            ["uniform vec3 c[4];", "layout(location = 0) out vec4 d;"]
        );
        assert!(!shown.contains("#define B"));
        assert!(prelude(&preset, "out vec4 x;", false, None).starts_with("#define OWN_OUTPUT"));
    }
}
