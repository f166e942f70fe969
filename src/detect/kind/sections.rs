//! Texts with several shaders, which a program splits at lines such as `[vertex]`, `<fragment>`, `#type vertex`,
//! `-- Fragment` and `// vertex`, or where each shader starts with `#version`.

use super::chunk::{Chunk, Scanned};
use super::evidence::Evidence;
use std::ops::Range;

/// A shader in a text of several.
pub struct Section {
    /// Offset of its code.
    pub start: usize,
    /// Its code, of the same length as in the text.
    pub code: String,
    /// Whether it is called a vertex shader.
    pub is_vertex: bool,
    /// Whether code before the first shader may belong to it.
    pub is_open: bool,
    /// The name of a chunk of a library; empty for a text that only imports some.
    pub chunk: Option<String>,
}

impl Section {
    fn new(start: usize, code: String, is_vertex: bool, is_open: bool) -> Section {
        Section {
            start,
            code,
            is_vertex,
            is_open,
            chunk: None,
        }
    }

    /// A chunk of a library, without its code.
    fn of_chunk(start: usize, name: &str) -> Section {
        Section {
            chunk: Some(name.to_string()),
            ..Section::new(start, String::new(), name.ends_with(".vertex"), false)
        }
    }
}

/// A line that starts or ends a shader.
struct Marker {
    /// Its text.
    line: Range<usize>,
    /// Where the shader starts.
    start: usize,
    is_vertex: bool,
    is_end: bool,
}

/// The shaders of a text: chunks between `@export` and `@end`, or at least two shaders with a `main` each;
/// otherwise none.
pub fn sections(text: &str) -> Vec<Section> {
    let chunks = chunks(text);
    if !chunks.is_empty() {
        return chunks;
    }
    if text.matches("main").count() < 2 {
        return Vec::new();
    }
    [marker, version]
        .into_iter()
        .find_map(|of| split(text, of))
        .unwrap_or_default()
}

fn split(text: &str, of: fn(&str) -> Option<Marker>) -> Option<Vec<Section>> {
    let mut markers = Vec::new();
    let (mut at, mut depth) = (0, 0_u32);
    for line in text.split_inclusive('\n') {
        let directive = line
            .trim_start()
            .strip_prefix('#')
            .map_or("", str::trim_start);
        match directive {
            _ if directive.starts_with("if") => depth += 1,
            _ if directive.starts_with("endif") => depth = depth.saturating_sub(1),
            _ if depth == 0 => markers.extend(of(line).map(|found| Marker {
                line: at..at + line.len(),
                start: at + found.start,
                ..found
            })),
            _ => {}
        }
        at += line.len();
    }
    let first = markers.first()?;
    let is_open = Scanned::of(text.get(..first.line.start)?).chunk() != Chunk::No;
    let ends = markers.iter().skip(1).map(|next| next.line.start);
    let ends = ends.chain([text.len()]).collect::<Vec<_>>();
    let starts = markers
        .iter()
        .zip(ends)
        .filter(|(marker, _)| !marker.is_end);
    let shaders = starts.map(|(marker, end)| {
        let code = text.get(marker.start..end)?;
        // A line that names no stage may separate shaders too.
        let after = code.rfind('}').and_then(|at| code.get(at + 1..));
        let is_code = |rest: &str| rest.contains(['#', '/']) || rest.trim().is_empty();
        let is_between = |rest: &&str| end < text.len() && !is_code(rest);
        let code = after
            .filter(is_between)
            .and_then(|rest| code.strip_suffix(rest))
            .unwrap_or(code);
        let evidence = Evidence::of(code);
        let is_own = mains(code) == 1 && evidence.is_glsl() && evidence.foreign().is_none();
        is_own.then(|| Section::new(marker.start, code.to_string(), marker.is_vertex, is_open))
    });
    let shaders = shaders.collect::<Option<Vec<_>>>()?;
    (shaders.len() > 1 && mains(text) == shaders.len()).then_some(shaders)
}

/// The chunks of a library, as ClayGL has them: `@export name.vertex` and `@end` on lines of their own; without
/// them a text that imports chunks is one. What their program reads and removes is blank: `uniform float size : 1.0;`.
pub fn chunks(text: &str) -> Vec<Section> {
    let is_import = |line: &str| {
        let name = line.trim().strip_prefix("@import ");
        name.is_some_and(is_chunk_of_library)
    };
    let is_one = !text.contains("@export ");
    match is_one {
        true if text.contains("@import ") && text.lines().any(is_import) => {}
        false if text.contains("@end") => {}
        _ => return Vec::new(),
    }
    let mut open = is_one.then(|| Section::of_chunk(0, ""));
    let mut found: Vec<Section> = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let own = line.trim();
        at += line.len();
        if let Some(name) = own.strip_prefix("@export ") {
            open = Some(Section::of_chunk(at, name));
        } else if own == "@end" {
            found.extend(open.take());
        } else if let Some(chunk) = &mut open {
            chunk.code += &plain(line);
        }
    }
    found.extend(open.filter(|_| is_one));
    found
}

/// A text as GLSL of the same length, without the annotations that the library of its chunks removes.
pub fn without_annotations(text: &str) -> String {
    text.split_inclusive('\n').map(plain).collect()
}

/// Whether a name in an import is that of a chunk of a library: `clay.util.rgbm`.
pub fn is_chunk_of_library(name: &str) -> bool {
    name.matches('.').count() > 1 && !name.contains(['/', '"', '\''])
}

/// A line of a chunk as GLSL of the same length: with `#import` for `@import`, without the annotations and values
/// of a declaration, and without a `;` after the number of a macro.
fn plain(line: &str) -> String {
    let own = line.trim_start();
    if own.starts_with("@import ") {
        return line.replacen('@', "#", 1);
    }
    let is_macro = own.starts_with("#define ") && own.trim_end().ends_with(';');
    let mut is_declaration = own.starts_with("uniform ") || own.starts_with("attribute ");
    let (mut depth, mut is_left_out) = (0, false);
    let mut plain = |c: char| {
        match c {
            ';' => is_left_out = is_macro,
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => is_left_out = false,
            // A comment follows.
            '/' if depth == 0 => is_declaration = false,
            ':' | '=' if is_declaration && depth == 0 => is_left_out = true,
            _ => {}
        }
        let is_blank = is_left_out && c != '\n';
        if is_blank {
            " ".repeat(c.len_utf8())
        } else {
            c.to_string()
        }
    };
    line.chars().map(&mut plain).collect()
}

/// The number of definitions of `main`.
fn mains(text: &str) -> usize {
    let is_defined = |(at, word): (usize, &str)| {
        let before = text.get(..at)?.trim_end().ends_with("void");
        let after = text.get(at + word.len()..)?.trim_start();
        (before && after.starts_with('(')).then_some(())
    };
    text.match_indices("main").filter_map(is_defined).count()
}

/// A line that names a stage, and no code: two more words at most.
fn marker(line: &str) -> Option<Marker> {
    if line.contains([';', '(', ')', '{', '}', '=', ',', '"']) {
        return None;
    }
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words = line.split(|c| !is_word(c)).filter(|word| !word.is_empty());
    let stages = words
        .clone()
        .filter_map(|word| match word.to_ascii_lowercase().as_str() {
            "vertex" | "vert" => Some((word, true)),
            "fragment" | "frag" => Some((word, false)),
            _ => None,
        });
    let (&[(stage, is_vertex)], 1..=3) = (&stages.collect::<Vec<_>>()[..], words.count()) else {
        return None;
    };
    let before = line.get(..line.find(stage)?)?;
    Some(Marker {
        line: 0..0,
        start: line.len(),
        is_vertex,
        is_end: before.ends_with(['/', '\\']) && !before.ends_with("//"),
    })
}

/// A `#version`, which a shader starts with.
fn version(line: &str) -> Option<Marker> {
    line.trim_start().starts_with("#version").then_some(Marker {
        line: 0..0,
        start: 0,
        is_vertex: false,
        is_end: false,
    })
}
