//! Completes a text so that a page can compile it. There are several candidates; the first one that
//! compiles is used.

use super::clues::{Clues, VersionAsked};
use shaderlint_diagnostic::Severity;
use shaderlint_explain::{Checked, analyze};
use shaderlint_host::{Preset, declared_in, matches_any};
use shaderlint_semantic::builtins::LEGACY_FUNCTIONS;
use shaderlint_semantic::{Stage, Unit};
use shaderlint_syntax::{RawKind, Version, written_tokens};
use shaderlint_text::{Role, Sources};
use std::ops::Range;
use std::sync::Arc;

/// A text and its surroundings.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Completion {
    /// Text before it.
    pub before: Arc<str>,
    /// The text itself; its `#version` and `#extension` lines are comments if there is text before
    /// it.
    pub code: Arc<str>,
    /// Text after it.
    pub after: Arc<str>,
    /// The changes to the text of the user.
    pub changes: Vec<TextChange>,
    /// A note for the user.
    pub note: Option<String>,
    /// The shader stage.
    pub stage: Stage,
}

/// A change that allows a text to be compiled after another.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextChange {
    /// The replaced bytes of the text.
    pub range: Range<usize>,
    /// The replacement.
    pub put: String,
    /// Whether the replacement is a comment.
    pub is_hidden: bool,
}

impl Completion {
    /// The unchanged text.
    pub fn bare(text: &str) -> Completion {
        Completion {
            before: Arc::from(""),
            code: Arc::from(text),
            after: Arc::from(""),
            changes: Vec::new(),
            note: None,
            stage: Stage::Fragment,
        }
    }

    /// The text after a prelude, which contains the `#version`.
    pub fn after(before: String, text: &str) -> Completion {
        let changes = usual_changes(text);
        Completion {
            before: Arc::from(before),
            code: Arc::from(changed(text, &changes)),
            after: Arc::from(""),
            changes,
            note: None,
            stage: Stage::Fragment,
        }
    }

    /// The same for the vertex stage.
    pub fn for_vertices(self) -> Completion {
        Completion {
            stage: Stage::Vertex,
            ..self
        }
    }

    /// The same with a note.
    pub fn with_note(self, note: impl Into<String>) -> Completion {
        Completion {
            note: Some(note.into()),
            ..self
        }
    }

    /// The text as the body of `main`.
    pub fn in_main(self) -> Completion {
        Completion {
            before: Arc::from(format!("{}void main() {{\n", self.before)),
            after: Arc::from("}\n"),
            ..self
        }
    }

    /// The same with a `main` after the text that calls `mainImage`.
    pub fn calling_image(self) -> Completion {
        self.with_main("void main() {\n    mainImage(gl_FragColor, gl_FragCoord.xy);\n}\n")
    }

    /// The same with a `main` in GLSL ES 1.00 after the text.
    pub fn with_main(self, main: &str) -> Completion {
        let end = match self.before.starts_with("#version 300") {
            true => {
                "\nout vec4 port_Color;\n".to_string() + &main.replace("gl_FragColor", "port_Color")
            }
            false => format!("\n{main}"),
        };
        self.with_end(&end)
    }

    /// The same with another text after it.
    pub fn with_end(self, after: &str) -> Completion {
        Completion {
            after: Arc::from(after),
            ..self
        }
    }

    /// Checks the completed text as the browser would.
    pub fn check(&self) -> Option<Checked> {
        let mut sources = Sources::new();
        let mut files = Vec::new();
        for (text, role) in [
            (&self.before, Role::Prelude),
            (&self.code, Role::User),
            (&self.after, Role::Prelude),
        ] {
            if role == Role::User || !text.is_empty() {
                files.push(sources.add("", None, role, text.clone())?);
            }
        }
        let sources = Arc::new(sources);
        Some(analyze(&Unit::complete(&sources, &files, self.stage)))
    }
}

/// The first candidate that compiles, otherwise the one with the fewest errors.
pub fn best(candidates: Vec<Completion>) -> Option<Completion> {
    let mut best: Option<(usize, Completion)> = None;
    for candidate in candidates {
        let found = candidate.check()?.diagnostics;
        let errors = found.iter().filter(|d| d.severity == Severity::Error);
        let errors = errors.count();
        if errors == 0 {
            return Some(candidate);
        }
        if best.as_ref().is_none_or(|(least, _)| errors < *least) {
            best = Some((errors, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Candidates for a text without a host: unchanged, with the missing defaults, and as GLSL ES 3.00.
pub(super) fn completions_of(clues: &Clues) -> Vec<Completion> {
    completions_after(clues, "", true)
}

/// Candidates for a text after the declarations of a host. `as_it_is` is false if the host
/// always adds text.
pub(super) fn completions_after(clues: &Clues, host: &str, as_it_is: bool) -> Vec<Completion> {
    let text = clues.text;
    let old = || Completion::after(defaults(Version::Es100) + host, text);
    let new = || Completion::after(modern(clues) + host, text);
    let needs = match clues.asked {
        VersionAsked::Nothing | VersionAsked::Es100 => {
            "compiled as GLSL ES 3.00: the shader uses features that GLSL ES 1.00 lacks"
        }
        _ => "",
    };
    let upgraded = || match needs {
        "" => new(),
        note => new().with_note(note),
    };
    let desktop = |number| {
        new().with_note(format!(
            "`#version {number}` is desktop GLSL; compiled as GLSL ES 3.00"
        ))
    };
    let rest = match clues.asked {
        VersionAsked::Nothing | VersionAsked::Es100 => vec![old(), upgraded()],
        VersionAsked::Es300 => vec![new()],
        VersionAsked::Desktop(number) if number < 130 => vec![
            old().with_note(format!(
                "`#version {number}` is desktop GLSL; compiled as GLSL ES 1.00"
            )),
            desktop(number),
        ],
        VersionAsked::Desktop(number) => vec![desktop(number)],
    };
    let bare = as_it_is && !matches!(clues.asked, VersionAsked::Desktop(_));
    let bare = bare.then(|| Completion::bare(text));
    bare.into_iter().chain(rest).collect()
}

/// The declarations of a host, without names that the text declares itself.
pub(super) fn declarations(host: &Preset, clues: &Clues, is_vertex: bool) -> String {
    without_own(&host.declarations(is_vertex), clues)
}

/// Removes the declarations of names that the text declares itself.
pub(super) fn without_own(text: &str, clues: &Clues) -> String {
    let is_theirs =
        |line: &&str| declared_in(line).is_none_or(|name| !clues.declares_outside(name));
    let lines = text.lines().filter(|l| !l.is_empty()).filter(is_theirs);
    lines.map(|line| format!("{line}\n")).collect()
}

/// The version and all default precisions.
pub(super) fn defaults(version: Version) -> String {
    let (head, types) = match version {
        Version::Es100 => ("", "float int"),
        Version::Es300 => ("#version 300 es\n", TYPES),
    };
    let lines = types
        .split(' ')
        .map(|ty| format!("precision highp {ty};\n"));
    head.to_string() + &lines.collect::<String>()
}

/// The types that need a default precision in GLSL ES 3.00.
const TYPES: &str = "\
    float int sampler2D samplerCube sampler3D sampler2DArray sampler2DShadow samplerCubeShadow \
    sampler2DArrayShadow isampler2D isampler3D isamplerCube usampler2D usampler3D usamplerCube";

/// The text before a text that is compiled as GLSL ES 3.00: the defaults, and macros for older
/// syntax.
pub(super) fn modern(clues: &Clues) -> String {
    let mut text = defaults(Version::Es300);
    if clues.has_word("varying") {
        text.push_str("#define varying in\n");
    }
    if clues.has_word("gl_FragDepthEXT") {
        text.push_str("#define gl_FragDepthEXT gl_FragDepth\n");
    }
    if clues.has_word("gl_FragColor") && !clues.declares_output() {
        text.push_str("out vec4 port_FragColor;\n#define gl_FragColor port_FragColor\n");
    } else if clues.has_word("gl_FragData") {
        text.push_str("out vec4 port_FragData[4];\n#define gl_FragData port_FragData\n");
    }
    text.push_str(&old_lookups(clues));
    if clues.has_word("sampler1D") {
        text.push_str(LINES);
    }
    let image = IMAGES.iter().find(|(word, _)| clues.has_word(word));
    if let Some((_, zero)) = image {
        text.push_str(&format!(
            "#define imageLoad(image, place) {zero}(0)\n#define imageStore(image, place, value)\n"
        ));
        for add in ["Add", "Max", "Min", "Or", "And", "Xor", "Exchange"] {
            text.push_str(&format!(
                "#define imageAtomic{add}(image, place, value) {zero}(0).x\n"
            ));
        }
    }
    text
}

/// Types of writable images, which WebGL does not have, and the value that reading them returns:
/// zero.
const IMAGES: [(&str, &str); 3] = [
    ("uimage2D", "uvec4"),
    ("iimage2D", "ivec4"),
    ("image2D", "vec4"),
];

/// Whether a text declares writable images.
pub(super) fn has_images(clues: &Clues) -> bool {
    IMAGES.iter().any(|(word, _)| clues.has_word(word))
}

/// Comments out the declarations of uniforms that contain a word.
fn hide_declarations(text: &str, changes: &mut Vec<TextChange>, is_hidden: impl Fn(&str) -> bool) {
    // Start of the current declaration, and whether it contains such a word.
    let (mut first, mut is_found): (Option<usize>, bool) = (None, false);
    for (kind, range, word) in written_tokens(text) {
        match kind {
            RawKind::Whitespace | RawKind::Newline => {}
            RawKind::LineComment | RawKind::BlockComment => {}
            _ if word == ";" => {
                let whole = first.take().filter(|_| is_found);
                let whole = whole.and_then(|at| Some((at, text.get(at..range.end)?)));
                if let Some((at, own)) = whole.filter(|(_, own)| !own.contains("*/")) {
                    changes.push(TextChange {
                        range: at..range.end,
                        put: format!("/*{own}*/"),
                        is_hidden: true,
                    });
                }
                is_found = false;
            }
            _ if matches!(word, "{" | "}") => (first, is_found) = (None, false),
            _ if first.is_none() && matches!(word, "layout" | "uniform") => {
                first = Some(range.start)
            }
            _ => is_found |= first.is_some() && is_hidden(word),
        }
    }
}

/// One-dimensional textures of desktop GLSL are replaced by the first rows of two-dimensional ones.
const LINES: &str = "#define sampler1D sampler2D\n\
    vec4 port_texture(sampler2D s, vec2 p) { return texture(s, p); }\n\
    vec4 port_texture(sampler2D s, vec2 p, float b) { return texture(s, p, b); }\n\
    vec4 port_texture(sampler2D s, float p) { return texture(s, vec2(p, 0.25)); }\n\
    vec4 port_texture(sampler2D s, float p, float b) { return texture(s, vec2(p, 0.25), b); }\n\
    vec4 port_texture(sampler3D s, vec3 p) { return texture(s, p); }\n\
    vec4 port_texture(samplerCube s, vec3 p) { return texture(s, p); }\n\
    vec4 port_fetch(sampler2D s, ivec2 p, int l) { return texelFetch(s, p, l); }\n\
    vec4 port_fetch(sampler2D s, int p, int l) {\n    \
    int w = textureSize(s, l).x;\n    \
    return texelFetch(s, ivec2(w < 1024 ? p * w / 1024 : p, 0), l);\n}\n\
    #define texture port_texture\n#define texelFetch port_fetch\n";

/// The GLSL ES 1.00 lookup functions that a text uses. If it has a variable with the name of the
/// modern function, functions are defined instead of macros.
fn old_lookups(clues: &Clues) -> String {
    let mut text = String::new();
    for (old, new) in LEGACY_FUNCTIONS
        .iter()
        .filter(|(old, _)| clues.is_free(old))
    {
        if !clues.declares(new) {
            text.push_str(&format!("#define {old} {new}\n"));
            continue;
        }
        let (sampler, place) = match *old {
            "textureCube" => ("samplerCube", "vec3"),
            "texture3D" => ("sampler3D", "vec3"),
            _ => ("sampler2D", "vec2"),
        };
        text.push_str(&format!(
            "vec4 {old}({sampler} s, {place} p) {{ return {new}(s, p); }}\n\
             vec4 {old}({sampler} s, {place} p, float b) {{ return {new}(s, p, b); }}\n"
        ));
    }
    text
}

/// The changes to a text that a host compiles after its declarations, including the directives that
/// the host processes.
pub(super) fn changes(text: &str, host: &Preset) -> Vec<TextChange> {
    let obeyed = directives(text, |word| matches_any(&host.directives, word));
    let hidden = obeyed.into_iter().map(|d| TextChange {
        put: format!("//{}", text.get(d.start..d.end).unwrap_or("")),
        range: d.start..d.end,
        is_hidden: true,
    });
    let mut all = usual_changes(text);
    hide_declarations(text, &mut all, |word| {
        host.defined.iter().any(|own| own == word)
    });
    all.extend(hidden);
    in_order(all)
}

/// The changes to a text that is compiled after another.
fn usual_changes(text: &str) -> Vec<TextChange> {
    let mut all = Vec::new();
    hide_first_lines(text, &mut all);
    hide_declarations(text, &mut all, |word| {
        IMAGES.iter().any(|(image, _)| *image == word)
    });
    make_struct_inputs(text, &mut all);
    in_order(all)
}

/// Sorts the changes; the first of overlapping changes is kept.
fn in_order(mut all: Vec<TextChange>) -> Vec<TextChange> {
    all.sort_by_key(|c| (c.range.start, c.range.end));
    all.dedup_by(|next, last| next.range.start < last.range.end);
    all
}

/// A line with a directive.
pub(super) struct Directive<'t> {
    /// Offset of its `#`.
    pub(super) start: usize,
    /// Offset of the end of the line.
    pub(super) end: usize,
    pub(super) word: &'t str,
    /// The text after the word.
    pub(super) rest: &'t str,
}

/// Whether a text may contain one of the given directives; a match may also be in a comment.
pub(super) fn may_have_directives(text: &str, is_searched: impl Fn(&str) -> bool) -> bool {
    let mut after = text.split('#').skip(1).map(str::trim_start);
    after.any(|rest| {
        // A comment or the end of a line may lie between.
        let word = rest
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .next();
        rest.starts_with(['/', '\\']) || word.is_some_and(&is_searched)
    })
}

/// The lines of a text with the given directives.
pub(super) fn directives(text: &str, is_searched: impl Fn(&str) -> bool) -> Vec<Directive<'_>> {
    if !may_have_directives(text, &is_searched) {
        return Vec::new();
    }
    let mut found: Vec<Directive> = Vec::new();
    let mut hash = None;
    for (kind, range, word) in written_tokens(text) {
        match kind {
            RawKind::Whitespace => {}
            RawKind::Hash => hash = Some(range.start),
            RawKind::Word => {
                if let Some(at) = hash.take().filter(|_| is_searched(word)) {
                    let rest = text.get(range.end..).and_then(|t| t.lines().next());
                    let rest = rest.unwrap_or("");
                    found.push(Directive {
                        start: at,
                        end: range.end + rest.len(),
                        word,
                        rest,
                    });
                }
            }
            _ => hash = None,
        }
    }
    found
}

/// A text with its changes applied.
pub(super) fn changed(text: &str, changes: &[TextChange]) -> String {
    let mut out = String::with_capacity(text.len() + 32);
    let mut from = 0;
    for change in changes {
        out.push_str(text.get(from..change.range.start).unwrap_or(""));
        out.push_str(&change.put);
        from = change.range.end;
    }
    out.push_str(text.get(from..).unwrap_or(""));
    out
}

/// Comments out `#version`, `#extension` and `#include` lines: the text before has its own version,
/// which must come first, and included files are not available.
fn hide_first_lines(text: &str, changes: &mut Vec<TextChange>) {
    let is_first = |word: &str| matches!(word, "version" | "extension" | "include");
    let lines = directives(text, is_first).into_iter();
    changes.extend(lines.map(|d| TextChange {
        put: format!("//{}", text.get(d.start..d.end).unwrap_or("")),
        range: d.start..d.end,
        is_hidden: true,
    }));
}

/// Converts input blocks, which GLSL ES 3.00 does not have, to inputs of structs: `in VertexData {
/// vec2 uv; } data;`.
fn make_struct_inputs(text: &str, changes: &mut Vec<TextChange>) {
    // State within a block: the position of `in`, the name, and whether its brace is open.
    let mut word: Option<Range<usize>> = None;
    let mut block: Option<(Range<usize>, &str)> = None;
    let mut is_open = false;
    for (kind, range, own) in written_tokens(text) {
        match kind {
            RawKind::Whitespace | RawKind::Newline => continue,
            RawKind::LineComment | RawKind::BlockComment => continue,
            RawKind::Word if own == "in" && !is_open => (word, block) = (Some(range), None),
            RawKind::Word if block.is_none() => {
                block = word.take().map(|range| (range, own));
            }
            _ => match (own, &block) {
                ("{", Some((range, _))) => {
                    changes.push(TextChange {
                        range: range.clone(),
                        put: "struct".to_string(),
                        is_hidden: false,
                    });
                    is_open = true;
                }
                ("}", Some((_, name))) if is_open => {
                    changes.push(TextChange {
                        range: range.end..range.end,
                        put: format!("; in {name}"),
                        is_hidden: false,
                    });
                    (is_open, block, word) = (false, None, None);
                }
                _ if !is_open => (word, block) = (None, None),
                _ => {}
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn version_and_extension_lines_become_comments() {
        let text =
            "#version 410 core\n # extension GL_X : enable\n#define version 1\n// #version\n";
        assert_eq!(
            changed(text, &usual_changes(text)),
            "//#version 410 core\n //# extension GL_X : enable\n#define version 1\n// #version\n"
        );
    }

    #[test]
    fn storage_images_are_replaced_by_zeros() {
        let text = "#version 420 core\nuniform vec2 size;\n\
            layout(r32ui) uniform coherent restrict uimage2D[3] computeTex;\nout vec4 c;\n\
            void main() {\nimageAtomicAdd(computeTex[0], ivec2(1), 3u);\n\
            c = vec4(imageLoad(computeTex[0], ivec2(size)).x);\n}\n";
        let code = taken(text).code;
        assert!(
            code.contains("/*layout(r32ui) uniform coherent restrict uimage2D[3] computeTex;*/")
        );
        assert!(code.contains("\nuniform vec2 size;\n"));
    }

    #[track_caller]
    fn taken(text: &str) -> Completion {
        let clues = Clues::of(text);
        let taken = best(completions_of(&clues)).unwrap();
        let errors = taken.check().unwrap().diagnostics;
        assert!(
            errors.iter().all(|d| d.severity != Severity::Error),
            "{errors:?}"
        );
        taken
    }

    #[test]
    fn complete_shaders_are_not_changed() {
        let text = "precision mediump float;\nvoid main() { gl_FragColor = vec4(1.0); }\n";
        assert_eq!(taken(text), Completion::bare(text));
        let text = "#version 300 es\nprecision highp float;\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
        assert_eq!(taken(text), Completion::bare(text));
    }

    #[test]
    fn missing_declarations_are_inserted_before_the_text() {
        let old = taken("uniform float t;\nvoid main() { gl_FragColor = vec4(t); }\n");
        assert!(old.before.starts_with("precision highp float;"), "{old:?}");
        let line = taken("\n#version 300 es\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
        assert!(line.before.starts_with("#version 300 es"), "{line:?}");
        let derived = taken(
            "#extension GL_OES_standard_derivatives : enable\nprecision mediump float;\n\
             void main() { gl_FragColor = vec4(dFdx(gl_FragCoord.x)); }\n",
        );
        assert!(derived.note.is_some() && derived.before.contains("port_FragColor"));
        let named = taken(
            "#extension GL_OES_standard_derivatives : enable\nprecision mediump float;\n\
             uniform sampler2D texture;\nvarying vec2 v;\n\
             void main() { gl_FragColor = texture2D(texture, v) + fwidth(v.x); }\n",
        );
        assert!(named.before.contains("vec4 texture2D("), "{named:?}");
    }
}
