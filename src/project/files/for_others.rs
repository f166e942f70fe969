//! The names that the texts of a file may declare for shaders elsewhere.
//!
//! A complete shader declares names for itself. Everything else may be put before it: files without an
//! entry function, strings of programs, macros that a script defines.

use super::words::{is_glsl, words};
use shaderlint_detect::embed::{DocumentLanguage, extract_named};
use shaderlint_detect::kind::{file_extension, has_main};
use shaderlint_semantic::guess;
use shaderlint_syntax::{Lexer, RawKind, TokenKind, Version, WordClass, classify};
use std::ops::Range;

/// Maximum length in bytes of what a script defines or replaces at one place.
const MAX_PLACE: usize = 2_000;

/// What a file may declare for shaders in other texts.
#[derive(Default)]
pub struct NamesForOthers<'t> {
    /// Names that are declared outside of complete shaders.
    pub declared: Vec<&'t str>,
    /// Words of complete shaders that they do not declare.
    pub lacked: Vec<&'t str>,
    /// Inputs and outputs that complete shaders declare for themselves.
    pub owned: Vec<&'t str>,
    /// Whether a program puts declarations together from parts.
    pub writes_declarations: bool,
}

impl<'t> NamesForOthers<'t> {
    /// Analyses the text of a file with this name.
    pub fn of(name: &str, text: &'t str) -> NamesForOthers<'t> {
        let is_shader = is_glsl(&file_extension(name));
        let complete = complete_shaders(name, text);
        let mut found = NamesForOthers::default();
        let mut from = 0;
        for shader in &complete {
            found.add_rest(text.get(from..shader.start).unwrap_or(""), is_shader);
            let own = text.get(shader.clone()).unwrap_or("");
            let mut declared = Vec::new();
            declarations(own, DeclarationPlace::Anywhere, &mut declared);
            declared.sort_unstable();
            interface(own, &mut found.owned);
            let lacks = |word: &&str| declared.binary_search(word).is_err();
            found
                .lacked
                .extend(variables(own).into_iter().filter(lacks));
            from = shader.end;
        }
        found.add_rest(text.get(from..).unwrap_or(""), is_shader);
        found
    }

    fn add_rest(&mut self, rest: &'t str, is_shader: bool) {
        declarations(rest, DeclarationPlace::Global, &mut self.declared);
        if !is_shader {
            given(rest, &mut self.declared);
            self.writes_declarations |= writes_declarations(rest);
        }
    }
}

/// The ranges of complete shaders in a file, in order.
fn complete_shaders(name: &str, text: &str) -> Vec<Range<usize>> {
    let has_main = |code: &str| has_main(code) && !guess(code).is_shadertoy();
    if !has_main(text) {
        return Vec::new();
    }
    let extension = file_extension(name);
    match DocumentLanguage::of_extension(&extension) {
        _ if is_glsl(&extension) => std::iter::once(0..text.len()).collect(),
        Some(language) => {
            let all = extract_named(name, language, text).into_iter();
            let mut all: Vec<Range<usize>> = all
                .filter(|shader| has_main(&shader.code))
                .map(|shader| shader.start..shader.end())
                .collect();
            all.sort_by_key(|range| range.start);
            all
        }
        None => Vec::new(),
    }
}

/// The words of a text except for numbers.
fn names(text: &str) -> impl Iterator<Item = &str> {
    words(text).filter(|word| !word.starts_with(|c: char| c.is_ascii_digit()))
}

/// The words of a shader that may be names of variables: not in comments, neither called nor members.
fn variables(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut lexer = Lexer::new(text, 0);
    let (mut after_dot, mut last) = (false, None);
    loop {
        let token = lexer.next_token();
        let word = text.get(token.span.start as usize..token.span.end as usize);
        match token.kind {
            RawKind::Whitespace | RawKind::Newline => continue,
            RawKind::LineComment | RawKind::BlockComment => continue,
            RawKind::Operator(TokenKind::LeftParen) => last = None,
            _ => {}
        }
        found.extend(last.take());
        match token.kind {
            RawKind::End => return found,
            RawKind::Word if !after_dot => last = word,
            _ => {}
        }
        after_dot = token.kind == RawKind::Operator(TokenKind::Dot);
    }
}

/// The inputs and outputs that a shader declares, without the members of blocks.
fn interface<'t>(text: &'t str, found: &mut Vec<&'t str>) {
    let mut lexer = Lexer::new(text, 0);
    // How many words follow up to a name, while a declaration is open.
    let mut left = None;
    let mut open = 0_u32;
    loop {
        let token = lexer.next_token();
        let word = text.get(token.span.start as usize..token.span.end as usize);
        match (token.kind, word.unwrap_or("")) {
            (RawKind::End, _) => return,
            (RawKind::Word, "uniform" | "varying" | "attribute" | "in" | "out") if open == 0 => {
                left = Some(1_u32);
            }
            (RawKind::Word, "lowp" | "mediump" | "highp") => {}
            (RawKind::Word, name) if open == 0 => match left {
                Some(0) => found.push(name),
                Some(more) => left = Some(more - 1),
                None => {}
            },
            (RawKind::Operator(_), "(" | "[" | "{") => open += 1,
            (RawKind::Operator(_), ")" | "]" | "}") => open = open.saturating_sub(1),
            (RawKind::Operator(_), ";" | "=") => left = None,
            _ => {}
        }
    }
}

/// Which declarations count.
#[derive(Clone, Copy, PartialEq, Eq)]
enum DeclarationPlace {
    /// Outside of all brackets, which a string starts anew.
    Global,
    Anywhere,
}

/// The names that a text declares.
fn declarations<'t>(text: &'t str, from: DeclarationPlace, found: &mut Vec<&'t str>) {
    let is_type = |word: &str| {
        let class = |version| classify(word, version);
        // No type starts with another letter.
        word.starts_with(['b', 'f', 'i', 'm', 's', 'u', 'v'])
            && (word == "void"
                || matches!(class(Version::Es300), WordClass::Type(_))
                || matches!(class(Version::Es100), WordClass::Type(_)))
    };
    let place = |word: &str| word.as_ptr() as usize - text.as_ptr() as usize;
    // Whether a list of declarators is open.
    let mut in_list = false;
    let mut in_block = false;
    let (mut before, mut qualified, mut after_type) = ("", false, false);
    let (mut end, mut open) = (0, 0_u32);
    for word in names(text) {
        let start = place(word);
        let between = text.get(end..start).unwrap_or("").trim();
        for byte in between.bytes() {
            match byte {
                b'(' | b'{' => open += 1,
                b')' | b'}' => open = open.saturating_sub(1),
                b'"' | b'\'' | b'`' => open = 0,
                _ => {}
            }
        }
        in_block |= qualified && between.starts_with('{');
        // `uniform Lights { vec3 sun; } lights;`
        let is_instance = in_block && open == 0 && between.ends_with('}');
        in_block &= open > 0;
        let is_plain = !is_type(word);
        let before_is_type = std::mem::replace(&mut after_type, !is_plain);
        let is_adjacent = between.is_empty();
        let is_macro = before == "define" && is_adjacent;
        let follows_type = is_adjacent && (before_is_type || before == "struct");
        let continues = in_list && between.ends_with(',') && is_declarator_end(between);
        let is_own = is_macro || follows_type || is_instance || qualified && is_adjacent;
        let is_declared = is_plain && is_own;
        in_list = is_declared || continues && is_plain;
        let is_global = open == 0 || in_block && open == 1;
        if in_list && (from == DeclarationPlace::Anywhere || is_global) {
            found.push(word);
        }
        // The type of a qualified declaration may be a name of the text.
        qualified = is_adjacent && matches!(before, "uniform" | "varying" | "attribute");
        (before, end) = (word, start + word.len());
    }
}

/// Whether the text between two declarators is the size of an array at most.
fn is_declarator_end(between: &str) -> bool {
    let rest = between.trim_end_matches(',').trim();
    rest.is_empty() || rest.starts_with('[') && rest.ends_with(']')
}

/// The macros that a script defines.
pub fn macros(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    after(text, &["defines", "define("], &mut found);
    found
}

/// The names for which a script gives a text: macros that it defines, words that it replaces.
fn given<'t>(text: &'t str, found: &mut Vec<&'t str>) {
    after(
        text,
        &["defines", "define(", "replace(", "replaceAll("],
        found,
    );
}

/// The names in the brackets after some words.
fn after<'t>(text: &'t str, starts: &[&str], found: &mut Vec<&'t str>) {
    for word in starts {
        for (at, _) in text.match_indices(word) {
            let after = text.get(at + word.len()..).unwrap_or("");
            found.extend(names(cut(after)));
        }
    }
}

/// The start of a text, up to the bracket that closes the first one, or to the end of the statement.
fn cut(text: &str) -> &str {
    let mut depth = 0_i32;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'(' | b'{' | b'[' => depth += 1,
            b')' | b'}' | b']' => depth -= 1,
            _ => {}
        }
        let is_end = depth < 0 || depth == 0 && matches!(byte, b';' | b'\n' | b'}');
        if is_end || at >= MAX_PLACE {
            return text.get(..at).unwrap_or("");
        }
    }
    text
}

/// The rest of a line, as far as a declaration may go.
fn line(text: &str) -> &str {
    /// Maximum length in characters.
    const MAX_LINE: usize = 300;
    let mut characters = text.char_indices().take(MAX_LINE);
    let end = characters.find(|(_, c)| *c == '\n');
    let end = end.or_else(|| text.char_indices().nth(MAX_LINE));
    text.get(..end.map_or(text.len(), |(at, _)| at))
        .unwrap_or("")
}

/// Whether a program puts declarations together: a qualifier is followed by the end of a string or by a
/// placeholder, and a semicolon is inside of a string on this line. A message has none.
fn writes_declarations(text: &str) -> bool {
    ["uniform ", "varying ", "attribute "].iter().any(|word| {
        text.match_indices(word).any(|(at, _)| {
            let after = text.get(at + word.len()..).unwrap_or("");
            let ends = [";'", ";\"", ";`", ";\\n", "};", "%s;"];
            after.starts_with(['$', '"', '\'', '`', '%', '{'])
                && ends.iter().any(|end| line(after).contains(end))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(name: &str, text: &str, declared: &[&str], lacked: &[&str]) {
        let found = NamesForOthers::of(name, text);
        assert_eq!(found.declared, declared, "{text}");
        let unknown = found.lacked.iter().filter(|w| w.starts_with('u'));
        assert_eq!(unknown.copied().collect::<Vec<_>>(), lacked, "{text}");
    }

    #[test]
    fn complete_shaders_declare_names_for_themselves_only() {
        let main = "void main() { gl_FragColor = vec4(u1, u2, u3, 1.0); }";
        check(
            "a.glsl",
            &format!("uniform float u1, u2; {main}"),
            &[],
            &["uniform", "u3"],
        );
        let part = "uniform float u1, u2[3], u3;\n#define N 3\nstruct S { vec3 at; };";
        check("a.glsl", part, &["u1", "u2", "u3", "N", "S"], &[]);
        let blocks = "uniform A { vec3 u1; } u2;\nuniform B { float u3; };\nvoid f() { vec3 a; }";
        check("a.glsl", blocks, &["u1", "u2", "u3", "f"], &[]);
        check("a.glsl", "float f(vec2 u1) { vec3 u2; }", &["f"], &[]);
        check("a.glsl", "void g() {}", &["g"], &[]);
        let uses = "void main() { gl_FragColor = a.u1 + u2(u3); /* u4 */ }";
        check("a.glsl", uses, &[], &["u3"]);
        check("a.glsl", "uniform Light light;", &["light"], &[]);
        let script = format!("const a = `{main}`; m({{ defines: {{ N: 3 }} }}); uniforms.u1 = 2;");
        check("a.js", &script, &["N"], &["u1", "u2", "u3"]);
        check("a.js", "s = 'uniform vec3 u1;' + s", &["u1"], &[]);
    }

    #[test]
    fn declarations_that_a_program_puts_together_are_noticed() {
        let writes = |text: &str| NamesForOthers::of("a.js", text).writes_declarations;
        assert!(writes("s = `uniform ${type} ${name};`"));
        assert!(writes("s = 'uniform ' + type + ' ' + name + ';\\n';"));
        assert!(!writes("console.error(`uniform ${name} is not set`);"));
        assert!(!writes("s = 'uniform float a;'"));
    }
}
