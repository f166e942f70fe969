//! Shaders in string literals of a script.

use super::chain::Chain;
use super::constants::Constants;
use super::context::{LiteralContext, grown};
use super::embedded::{Embedded, Wrapping};
use super::holes::mask;
use super::literal::read;
use super::token::{ScriptToken, ScriptTokenKind, is_literal, is_mark, tokens};
use crate::kind::{Chunk, Scanned};
use std::collections::HashSet;

/// Finds the shaders. If the name of the script indicates shaders, its literals need less evidence.
pub fn extract(text: &str, base: usize, is_named: bool, found: &mut Vec<Embedded>) {
    let tokens = tokens(text);
    let script = Script {
        constants: Constants::of(text, &tokens),
        grown: grown(text, &tokens),
        is_named,
    };
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if !is_literal(token) {
            at += 1;
            continue;
        }
        let chain = Chain::of(text, &tokens, at);
        let last = chain.last;
        let shader = shader(text, &tokens, at, &chain, &script);
        if let Some(shader) = shader {
            found.push(Embedded {
                start: shader.start + base,
                ..shader
            });
        }
        at = last + 1;
    }
}

/// What is known about a script.
struct Script<'a> {
    constants: Constants,
    /// Variables to which text is appended.
    grown: HashSet<&'a str>,
    /// Whether the file name indicates shaders.
    is_named: bool,
}

/// The shader in a chain of literals, if it contains one.
fn shader(
    text: &str,
    tokens: &[ScriptToken],
    first: usize,
    chain: &Chain,
    script: &Script,
) -> Option<Embedded> {
    /// Minimum length of a text without a tag or comment.
    const SHORTEST: usize = 8;
    let context = LiteralContext::of(text, tokens, first);
    let end = chain.parts.last().and_then(|l| tokens.get(*l))?.range.end;
    if !context.is_introduced && end - tokens.get(first)?.range.start < SHORTEST {
        return None;
    }
    let code = read(text, tokens, chain, &script.constants)?;
    if code.text.trim().is_empty() || !is_taken(&code.text, &context, script.is_named) {
        return None;
    }
    let literal = tokens.get(first)?;
    let is_template =
        chain.parts.len() == 1 && matches!(literal.kind, ScriptTokenKind::Template(_));
    let masked = mask(&code.text);
    let mut shader = Embedded {
        start: code.start,
        has_holes: code.has_holes
            || masked.is_some()
            || context.is_pattern
            || context.is_given_to(&script.grown),
        code: masked.unwrap_or(code.text),
        wrapping: if is_template {
            Wrapping::Template
        } else {
            Wrapping::Quotes
        },
        is_vertex: context.is_vertex,
        chapter: 0,
    };
    cut_start(text, tokens, chain.last + 1, &mut shader);
    Some(shader)
}

/// Whether a text is a shader, or a shader fragment that can be checked.
fn is_taken(code: &str, context: &LiteralContext, is_named: bool) -> bool {
    // A search pattern or a replacement.
    if context.is_introduced {
        return true;
    }
    if context.is_pattern && !is_balanced(code) {
        return false;
    }
    let scanned = Scanned::of(code);
    let is_part = || scanned.chunk() != Chunk::No;
    if context.is_message || scanned.is_bare() || context.is_pattern && !is_part() {
        return false;
    }
    if scanned.is_shader() {
        return true;
    }
    is_balanced(code)
        && match scanned.chunk() {
            Chunk::Clear => true,
            Chunk::Likely => context.names_shader || is_named,
            Chunk::No => false,
        }
}

/// Whether all brackets match.
fn is_balanced(code: &str) -> bool {
    let count = |open: char, close: char| {
        let mut depth = 0_i32;
        for c in code.chars() {
            depth += i32::from(c == open) - i32::from(c == close);
            if depth < 0 {
                return false;
            }
        }
        depth == 0
    };
    count('{', '}') && count('(', ')')
}

/// Removes what `.trim()` or `.slice(1)` after the literal removes.
fn cut_start(text: &str, tokens: &[ScriptToken], after: usize, shader: &mut Embedded) {
    if !is_mark(tokens, after, b'.') {
        return;
    }
    let word = |at: usize| {
        let range = tokens.get(at).map_or(0..0, |t| t.range.clone());
        text.get(range).unwrap_or("")
    };
    match (word(after + 1), word(after + 3)) {
        ("trim" | "trimStart" | "trimLeft", _) => shader.trim_start(),
        ("slice" | "substring" | "substr", "1") if shader.code.starts_with(['\n', ' ']) => {
            shader.code.remove(0);
            shader.start += 1;
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let mut found = Vec::new();
        extract(text, 0, false, &mut found);
        for shader in &found {
            assert!(text.get(shader.start..shader.end()).is_some());
        }
        let codes: Vec<&str> = found.iter().map(|s| s.code.as_str()).collect();
        assert_eq!(codes, expected);
    }

    #[test]
    fn literals_with_shaders_are_found() {
        check(
            "const a = `#version 300 es\nx`, b = 'void 0';",
            &["#version 300 es\nx"],
        );
        check(
            "f(glsl`float f();`, /* glsl */ `x`, /*no*/`y`)",
            &["float f();", "x"],
        );
        check(
            "s = 'void  main ( ) {}'; t = \"void mainly()\"",
            &["void  main ( ) {}"],
        );
    }

    #[test]
    fn concatenated_literals_are_joined() {
        check(
            "s = 'void main() {\\n' +\n 'x;' + // it's\n '}';",
            &["void main() {\n       x;              }"],
        );
        check(
            "s = ['void main() {', '}'].join('\\n');",
            &["void main() {\n   }"],
        );
        check(
            "s = 'void main() {' + f(1) + '}';",
            &["void main() {            }"],
        );
    }

    #[test]
    fn decoded_escapes_keep_their_width() {
        check(
            r"s = 'void main() { \
}\t\x41\\\n';",
            &["void main() {   }     A \\\n "],
        );
    }

    #[test]
    fn holes_become_names_numbers_or_nothing() {
        check(
            "s = `void main() {\n${a}\nx = ${b};y = ${c}.0; z = vec${d}(1);}`",
            &["void main() {\n    \nx = hhhh;y = 1111.0; z = vechhh1(1);}"],
        );
    }

    #[test]
    fn interpolated_constants_are_inserted_and_other_values_are_holes() {
        let holes = |text: &str| {
            let mut found = Vec::new();
            extract(text, 0, false, &mut found);
            found.iter().map(|s| s.has_holes).collect::<Vec<_>>()
        };
        let constant = "const PR = 'highp'; const s = `precision ${PR} float; void main() {}`;";
        check(constant, &["precision highp float; void main() {}"]);
        assert_eq!(holes(constant), [false]);
        assert_eq!(holes("s = 'void main() {}' + x;"), [true]);
        assert_eq!(holes("s = x + /* glsl */ 'void main() {}';"), [true]);
        assert_eq!(holes("let s = 'void main() {'; s += x;"), [true]);
        assert_eq!(holes("s.replace(a, /* glsl */ 'void main() { b;')"), [true]);
        assert_eq!(holes("s = 'float a = {{ b }}; void main() {}'"), [true]);
        check(
            "s = 'float a[' + n + ']; void main() {}'.concat(b, 'float c;')",
            &["float a[hhhhhhhhh]; void main() {}             float c;"],
        );
        check(
            "s = ['void main() {', a ? 'b' : '', '}'].filter(c).join('\\n')",
            &["void main() {\n                \n}"],
        );
    }

    #[test]
    fn literals_without_shaders_are_skipped() {
        check("s.replace('void main() {', 'void main() {\\n x;')", &[]);
        check("if (s === '#version 300 es') {}", &[]);
        check("s = '#version 300 es\\n' + x;", &[]);
        check("throw new Error('no void main() { in it')", &[]);
        check("const a = 'float f(float b) { return b; }';", &[]);
        let part = "float f(float b) { return b; }";
        check(&format!("const aFrag = '{part}';"), &[part]);
        let clear = "vec3 f(vec2 b) { return vec3(b, 1.); }";
        check(&format!("a('{clear}');"), &[clear]);
    }

    #[test]
    fn text_that_the_script_trims_is_trimmed() {
        check("s = `\n#version 300 es\nx`.trim()", &["#version 300 es\nx"]);
        check(
            "s = `\n#version 300 es\nx`.slice(1)",
            &["#version 300 es\nx"],
        );
        check("s = `\n#version 300 es\nx`", &["\n#version 300 es\nx"]);
    }
}
