//! What a text shows of the dialect that it is written in.

use super::TextsBeside;
use super::complete::{Completion, completions_of};
use rustc_hash::FxHashSet;
use shaderlint_semantic::{Guess, Program, Storage, guess};
use shaderlint_syntax::{Lexer, RawKind};
use shaderlint_text::Role;

/// A variable that a text declares and something else sets.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Interfacing {
    /// Its name.
    pub name: String,
    /// Its type, as it is written.
    pub ty: String,
}

/// What the `#version` of a text asks for.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum VersionAsked {
    /// There is none.
    #[default]
    Nothing,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL ES 3.00 or a later one for devices.
    Es300,
    /// GLSL for desktops, by its number.
    Desktop(u32),
}

impl VersionAsked {
    fn of(line: &str) -> VersionAsked {
        let mut words = line.split_whitespace();
        let number = words.next().and_then(|n| n.parse().ok()).unwrap_or(0);
        match (number, words.next()) {
            (100, _) => VersionAsked::Es100,
            (_, Some("es")) | (300, _) => VersionAsked::Es300,
            (number, _) => VersionAsked::Desktop(number),
        }
    }
}

/// What a text shows.
pub struct Clues<'t> {
    /// The text.
    pub text: &'t str,
    /// What its file is called, without ending; empty where it has none.
    pub name: &'t str,
    /// The texts beside it that have been read.
    pub beside: &'t TextsBeside,
    /// What the `#version` of the text asks for.
    pub asked: VersionAsked,
    /// What its words tell of its version and kind.
    pub guess: Guess,
    /// The uniforms that it declares, samplers included.
    pub uniforms: Vec<Interfacing>,
    /// The varyings that it declares, and the members of those that are structs.
    pub inputs: Vec<Interfacing>,
    /// Whether it has statements outside of any function, and no function that is called.
    pub is_body: bool,
    has_output: bool,
    words: FxHashSet<&'t str>,
    conditions: FxHashSet<&'t str>,
    code: FxHashSet<&'t str>,
    declared: FxHashSet<String>,
}

impl<'t> Clues<'t> {
    /// Reads a text that stands alone.
    pub fn of(text: &'t str) -> Clues<'t> {
        static NOTHING: TextsBeside = TextsBeside::new();
        Clues::beside(text, "", &NOTHING)
    }

    /// What a text shows that was checked already.
    pub fn checked(text: &'t str, program: &Program) -> Clues<'t> {
        static NOTHING: TextsBeside = TextsBeside::new();
        let mut clues = Clues::unread(text, "", &NOTHING);
        clues.read(program);
        clues
    }

    /// Reads a text with others beside it.
    pub fn beside(text: &'t str, name: &'t str, beside: &'t TextsBeside) -> Clues<'t> {
        let mut clues = Clues::unread(text, name, beside);
        let completion = completions_of(&clues).into_iter().next_back();
        let completion = completion.map(|c| match clues.is_body {
            true => c.in_main(),
            false => c,
        });
        if let Some(checked) = completion.as_ref().and_then(Completion::check) {
            clues.read(&checked.program);
        }
        clues
    }

    /// What the words of a text show.
    pub(super) fn unread(text: &'t str, name: &'t str, beside: &'t TextsBeside) -> Clues<'t> {
        let guess = guess(text);
        let Words {
            words,
            conditions,
            code,
            asked,
        } = words(text);
        Clues {
            text,
            name,
            beside,
            asked,
            is_body: !guess.has_main && !guess.is_shadertoy() && !words.contains("mainImage"),
            guess,
            uniforms: Vec::new(),
            inputs: Vec::new(),
            has_output: false,
            words,
            conditions,
            code,
            declared: FxHashSet::default(),
        }
    }

    fn read(&mut self, program: &Program) {
        let is_user = |token| {
            let span = program.token(token).map(|t| t.span);
            let file = span.and_then(|s| program.sources.file_at(s.start));
            file.is_some_and(|f| f.role == Role::User)
        };
        for variable in &program.variables {
            if !variable.token.is_some_and(is_user) {
                continue;
            }
            let name = program.names.text(variable.name).to_string();
            let ty = program.type_name(variable.ty);
            self.declared.insert(name.clone());
            match variable.storage {
                Storage::Output => self.has_output = true,
                Storage::Uniform => self.uniforms.push(Interfacing { name, ty }),
                Storage::Input => {
                    let fields = program.struct_of(variable.ty).map(|s| &s.fields);
                    for field in fields.into_iter().flatten() {
                        self.inputs.push(Interfacing {
                            name: program.names.text(field.name).to_string(),
                            ty: program.type_name(field.ty),
                        });
                    }
                    self.inputs.push(Interfacing { name, ty });
                }
                _ => {}
            }
        }
        let functions = program.tree.functions.iter();
        let functions = functions
            .filter(|f| is_user(f.ident.token))
            .map(|f| f.ident.name);
        let macros = program.tokens.macros.iter();
        let macros = macros.filter(|m| !m.predefined && program.is_user(m.name_span));
        let names = functions.chain(macros.map(|m| m.name));
        self.declared
            .extend(names.map(|n| program.names.text(n).to_string()));
    }

    /// Whether something in the text could be drawn: it has an entry, or statements outside of any.
    pub fn is_shader(&self) -> bool {
        self.guess.kind.is_some() || (self.is_body && !self.declared.is_empty())
    }

    /// Whether it takes chunks of another library in: `#include <common>`.
    pub fn has_include(&self) -> bool {
        let mut lines = self.text.lines().map(str::trim_start);
        lines.any(|l| {
            l.strip_prefix("#include")
                .is_some_and(|r| r.trim_start().starts_with('<'))
        })
    }

    /// Whether it declares what it writes to.
    pub fn declares_output(&self) -> bool {
        self.has_output
    }

    /// Whether a word stands in the text, comments aside.
    pub fn has_word(&self, word: &str) -> bool {
        self.words.contains(word)
    }

    /// Whether `#if` asks for the value of a word.
    pub fn is_condition(&self, word: &str) -> bool {
        self.conditions.contains(word)
    }

    /// Whether a word stands anywhere but in conditions.
    pub fn is_read(&self, word: &str) -> bool {
        self.code.contains(word)
    }

    /// Whether the text declares a name.
    pub fn declares(&self, name: &str) -> bool {
        self.declared.contains(name)
    }

    /// Whether the text uses a name that it does not declare.
    pub fn is_free(&self, name: &str) -> bool {
        self.has_word(name) && !self.declares(name)
    }

    /// The words of the text that pass a test and are not declared.
    pub fn free_words(&self, wanted: impl Fn(&str) -> bool) -> Vec<&'t str> {
        let all = self.words.iter().copied();
        let mut found: Vec<&str> = all.filter(|w| wanted(w) && !self.declares(w)).collect();
        found.sort_unstable();
        found
    }

    /// Whether the text declares a uniform of a name and one of some types.
    pub fn has_uniform(&self, name: &str, types: &[&str]) -> bool {
        let is_it = |d: &Interfacing| d.name == name && types.contains(&d.ty.as_str());
        self.uniforms.iter().any(is_it)
    }
}

/// The words of a text.
#[derive(Default)]
struct Words<'t> {
    words: FxHashSet<&'t str>,
    /// Those whose values `#if` asks for.
    conditions: FxHashSet<&'t str>,
    /// Those that stand anywhere but in conditions.
    code: FxHashSet<&'t str>,
    /// What its `#version` asks for.
    asked: VersionAsked,
}

fn words(text: &str) -> Words<'_> {
    let mut lexer = Lexer::new(text, 0);
    let mut found = Words::default();
    let mut behind_hash = false;
    // The directive of the line that asks something, and the word before.
    let (mut condition, mut before) = ("", "");
    loop {
        let token = lexer.next_token();
        let (start, end) = (token.span.start as usize, token.span.end as usize);
        let word = text.get(start..end).unwrap_or("");
        match token.kind {
            RawKind::End => return found,
            RawKind::Whitespace => continue,
            RawKind::Newline => condition = "",
            RawKind::Word => {
                if behind_hash && word == "version" && found.asked == VersionAsked::Nothing {
                    let line = text.get(end..).and_then(|rest| rest.lines().next());
                    found.asked = VersionAsked::of(line.unwrap_or(""));
                }
                found.words.insert(word);
                match condition {
                    "" => drop(found.code.insert(word)),
                    "if" | "elif" if before != "defined" => drop(found.conditions.insert(word)),
                    _ => {}
                }
                if behind_hash && matches!(word, "if" | "elif" | "ifdef" | "ifndef" | "undef") {
                    condition = word;
                }
                before = word;
            }
            _ if word == "(" => {}
            _ => before = "",
        }
        behind_hash = token.kind == RawKind::Hash;
    }
}
