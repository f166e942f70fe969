//! Where scripts refer to a name of a shader: in `getUniformLocation(program, "name")`, in
//! `uniforms: { name: ... }`, in `source.replace("name", ...)`.

use super::DocumentLanguage;
use super::together::scripts;
use crate::script::token::{ScriptToken, ScriptTokenKind, tokens};
use std::ops::Range;

/// What scripts use a name for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NameRole {
    /// An input of a program: scripts set it by name.
    Input,
    /// Any other name: scripts know it only where they edit the text of a shader.
    Inner,
}

/// A place where a script refers to a name, or may do so.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mention {
    /// Range of the name in the file.
    pub range: Range<usize>,
    /// How it refers to the name.
    pub kind: MentionKind,
}

/// How a script refers to a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MentionKind {
    /// By the name alone.
    Name,
    /// By a property that also names a variable of the script: `uniforms: { name }`.
    Shorthand,
    /// It may also be something else with the same name.
    Unclear,
}

/// The places where the scripts of a file refer to a name.
pub fn mentions(
    language: DocumentLanguage,
    text: &str,
    name: &str,
    role: NameRole,
) -> Vec<Mention> {
    let mut found = Vec::new();
    if name.is_empty() {
        return found;
    }
    for script in scripts(language, text) {
        let content = text.get(script.clone()).unwrap_or("");
        let mut tokens = tokens(content);
        tokens.retain(|t| t.kind != ScriptTokenKind::Comment);
        let mut reader = MentionReader {
            text: content,
            tokens: &tokens,
            open: Vec::new(),
            name,
            role,
            found: Vec::new(),
        };
        reader.read();
        found.extend(reader.found.into_iter().map(|mention| Mention {
            range: mention.range.start + script.start..mention.range.end + script.start,
            ..mention
        }));
    }
    found
}

/// What is inside a pair of brackets.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ScriptBracket {
    /// The object of uniforms or attributes, or an index of it.
    Inputs,
    /// Arguments of a function that is about uniforms, attributes or varyings.
    AboutInputs,
    /// Arguments of a function that searches or changes text.
    AboutText,
    /// Any other `{`.
    Braces,
    /// Anything else.
    Others,
}

struct MentionReader<'t> {
    text: &'t str,
    tokens: &'t [ScriptToken],
    open: Vec<ScriptBracket>,
    name: &'t str,
    role: NameRole,
    found: Vec<Mention>,
}

impl<'t> MentionReader<'t> {
    fn word(&self, at: usize) -> &'t str {
        let range = self.tokens.get(at).map_or(0..0, |t| t.range.clone());
        self.text.get(range).unwrap_or("")
    }

    /// Whether the token at an index is this mark.
    fn mark(&self, at: Option<usize>, mark: u8) -> bool {
        let token = at.and_then(|at| self.tokens.get(at));
        token.is_some_and(|t| t.kind == ScriptTokenKind::Mark(mark))
    }

    fn read(&mut self) {
        for (at, token) in self.tokens.iter().enumerate() {
            match &token.kind {
                ScriptTokenKind::Mark(mark @ (b'(' | b'[' | b'{')) => {
                    let bracket = self.bracket(at, *mark);
                    self.open.push(bracket);
                }
                ScriptTokenKind::Mark(b')' | b']' | b'}') => {
                    self.open.pop();
                }
                ScriptTokenKind::Word if self.word(at) == self.name => self.identifier(at),
                // A regular expression.
                ScriptTokenKind::Word if self.word(at).starts_with('/') => self.edited(at),
                ScriptTokenKind::Quoted | ScriptTokenKind::Template(_) => self.string(at),
                _ => {}
            }
        }
    }

    /// The meaning of a bracket, from what precedes it.
    fn bracket(&self, at: usize, mark: u8) -> ScriptBracket {
        let before = at.checked_sub(1);
        let is_inputs = |at: Option<usize>| at.is_some_and(|at| is_about_inputs(self.word(at)));
        match mark {
            b'{' => {
                let sets = self.mark(before, b':') || self.mark(before, b'=');
                match sets && is_inputs(at.checked_sub(2)) {
                    true => ScriptBracket::Inputs,
                    false => ScriptBracket::Braces,
                }
            }
            b'[' if is_inputs(before) => ScriptBracket::Inputs,
            // A list of names is like a name.
            b'[' => match self.open.last() {
                Some(outer @ (ScriptBracket::AboutInputs | ScriptBracket::AboutText)) => *outer,
                _ => ScriptBracket::Others,
            },
            _ if is_inputs(before) => ScriptBracket::AboutInputs,
            _ => match before.map_or("", |at| self.word(at)) {
                "replace" | "replaceAll" | "split" | "includes" | "indexOf" | "match"
                | "RegExp" => ScriptBracket::AboutText,
                _ => ScriptBracket::Others,
            },
        }
    }

    fn add(&mut self, range: Range<usize>, kind: MentionKind) {
        self.found.push(Mention { range, kind });
    }

    /// An identifier of the script with the name.
    fn identifier(&mut self, at: usize) {
        let Some(token) = self.tokens.get(at) else {
            return;
        };
        if self.role == NameRole::Inner {
            return;
        }
        let (before, after) = (at.checked_sub(1), Some(at + 1));
        let is_property = self.mark(before, b'.');
        let starts = self.mark(before, b'{') || self.mark(before, b',');
        let of_inputs = self.open.last() == Some(&ScriptBracket::Inputs);
        let in_braces = of_inputs || self.open.last() == Some(&ScriptBracket::Braces);
        let ends = self.mark(after, b',') || self.mark(after, b'}');
        let kind = if is_property {
            let of = at.checked_sub(2);
            let of = match self.mark(of, b'?') {
                true => at.checked_sub(3),
                false => of,
            };
            match of.is_some_and(|of| is_about_inputs(self.word(of))) {
                true => MentionKind::Name,
                false => MentionKind::Unclear,
            }
        } else if in_braces && starts && self.mark(after, b':') {
            match of_inputs {
                true => MentionKind::Name,
                false => MentionKind::Unclear,
            }
        } else if in_braces && starts && ends {
            match of_inputs {
                true => MentionKind::Shorthand,
                false => MentionKind::Unclear,
            }
        } else {
            // A variable of the script.
            return;
        };
        self.add(token.range.clone(), kind);
    }

    /// A string or template literal.
    fn string(&mut self, at: usize) {
        let Some(token) = self.tokens.get(at) else {
            return;
        };
        let text = self.word(at);
        let rest = text.strip_prefix(self.name);
        // `lights[0].color` refers to `lights`.
        let is_whole = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']));
        let around = self.open.last().copied().unwrap_or(ScriptBracket::Others);
        if around == ScriptBracket::AboutText || !is_whole {
            return self.edited(at);
        }
        if self.role == NameRole::Inner && around != ScriptBracket::AboutInputs {
            return;
        }
        let kind = match around {
            ScriptBracket::Inputs | ScriptBracket::AboutInputs => MentionKind::Name,
            _ => MentionKind::Unclear,
        };
        self.add(token.range.start..token.range.start + self.name.len(), kind);
    }

    /// A text that contains the name: a part of a shader, or a pattern for it.
    fn edited(&mut self, at: usize) {
        let Some(token) = self.tokens.get(at) else {
            return;
        };
        let text = self.word(at);
        let is_edited = self.open.contains(&ScriptBracket::AboutText);
        let is_code = text.contains([';', '{', '(', '=']);
        if !is_edited && !is_code {
            return;
        }
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
        for (start, _) in text.match_indices(self.name) {
            let end = start + self.name.len();
            let before = text.get(..start).and_then(|t| t.chars().next_back());
            let after = text.get(end..).and_then(|t| t.chars().next());
            // In `\bname\b`, the letter before belongs to the escape.
            let is_escape = text.get(..start).is_some_and(|t| t.ends_with("\\b"));
            if is_escape || !before.is_some_and(is_word) && !after.is_some_and(is_word) {
                let kind = match is_edited {
                    true => MentionKind::Name,
                    false => MentionKind::Unclear,
                };
                let base = token.range.start;
                self.add(base + start..base + end, kind);
            }
        }
    }
}

/// Whether a name of a script says that something is about inputs or outputs of a program.
fn is_about_inputs(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    ["uniform", "attrib", "varying"]
        .iter()
        .any(|part| word.contains(part))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Marks the mentions of `name` in a script: `<name>`, `+name+` for shorthands, `?name?` for
    /// unclear ones.
    #[track_caller]
    fn check(role: NameRole, marked: &str) {
        let text = marked.replace(['<', '>', '+', '?'], "");
        let mut shown = text.clone();
        let mut all = mentions(DocumentLanguage::Script, &text, "name", role);
        all.reverse();
        for mention in all {
            let (open, close) = match mention.kind {
                MentionKind::Name => ("<", ">"),
                MentionKind::Shorthand => ("+", "+"),
                MentionKind::Unclear => ("?", "?"),
            };
            shown.insert_str(mention.range.end, close);
            shown.insert_str(mention.range.start, open);
        }
        assert_eq!(shown, marked);
    }

    #[test]
    fn names_of_inputs_are_found_in_scripts() {
        let input = |text| check(NameRole::Input, text);
        input("const name = gl.getUniformLocation(p, '<name>'); use(name); // name");
        input("gl.getUniformLocation(p, `<name>[0].color`); a['names']; 'name this';");
        input("m({ uniforms: { <name>: { value: name }, other: name } }); f({ ?name?: 1 });");
        input("m({ uniforms: { +name+ } }); m({ uniforms: { a, +name+, '<name>': name } });");
        input("material.uniforms.<name>.value = 1; uniforms['<name>'] = name; mesh.?name?.x = 2;");
        input(
            "gl.transformFeedbackVaryings(p, ['a', '<name>'], 1); shader.setUniform('<name>', 1);",
        );
        input("log('?name?'); const { ?name? } = uniforms; call(a, name);");
    }

    #[test]
    fn names_in_edited_shader_texts_are_found() {
        let inner = |text| check(NameRole::Inner, text);
        inner("s.replace('<name>', 'x').replaceAll(/\\b<name>\\b/g, `<name> * 2.0`);");
        inner("const part = 'float name2 = ?name?(1.0);'; log('name'); a.name = 1;");
    }
}
