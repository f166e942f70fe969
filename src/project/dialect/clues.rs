//! Properties of a text that indicate its host.

use super::SiblingTexts;
use super::complete::{Completion, completions_of};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_diagnostic::Lack;
use shaderlint_host::{Preset, is_provided};
use shaderlint_semantic::{Guess, Program, Storage, guess};
use shaderlint_syntax::{RawKind, written_tokens};
use shaderlint_text::Role;

/// A variable that a text declares and the host sets.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Interfacing {
    /// The name, or the name of a struct member.
    pub name: String,
    /// The type as written in GLSL.
    pub ty: String,
}

/// The version in the `#version` of a text.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum VersionAsked {
    /// There is no `#version`.
    #[default]
    Nothing,
    /// GLSL ES 1.00.
    Es100,
    /// GLSL ES 3.00.
    Es300,
    /// Desktop GLSL or a later GLSL ES, with its version number.
    Desktop(u32),
}

impl VersionAsked {
    fn of(line: &str) -> VersionAsked {
        let mut words = line.split_whitespace();
        let number = words.next().and_then(|n| n.parse().ok()).unwrap_or(0);
        match (number, words.next()) {
            (100, _) => VersionAsked::Es100,
            (300, _) => VersionAsked::Es300,
            (number, _) => VersionAsked::Desktop(number),
        }
    }
}

/// Finds the hosts of the program around a text, likeliest first. It is asked only if the text itself
/// shows none.
pub type HostsAround<'t> = &'t dyn Fn() -> Vec<&'static Preset>;

/// Properties of a text that indicate its host.
pub struct Clues<'t> {
    /// The text.
    pub text: &'t str,
    /// The file name without extension; empty if there is none.
    pub name: &'t str,
    /// The companion files that have been read.
    pub siblings: &'t SiblingTexts,
    /// The hosts of the program around the text.
    pub around: HostsAround<'t>,
    /// The version in the `#version` of the text.
    pub asked: VersionAsked,
    /// Version and kind, guessed from the words of the text.
    pub guess: Guess,
    /// The uniforms that it declares, including samplers.
    pub uniforms: Vec<Interfacing>,
    /// The varyings that it declares, including the members of structs.
    pub inputs: Vec<Interfacing>,
    /// Whether it has statements outside of functions, and no entry function.
    pub is_body: bool,
    has_output: bool,
    words: FxHashMap<&'t str, WordUses>,
    declared: FxHashSet<String>,
    /// The names among these that are declared outside of functions.
    outer: FxHashSet<String>,
    /// The names that are not declared where they are used.
    lacking: FxHashSet<String>,
}

impl<'t> Clues<'t> {
    /// The properties of a text without companion files.
    pub fn of(text: &'t str) -> Clues<'t> {
        static NOTHING: SiblingTexts = SiblingTexts::new();
        Clues::with_siblings(text, "", &NOTHING)
    }

    /// The properties of a text that has already been checked.
    pub fn checked(text: &'t str, program: &Program) -> Clues<'t> {
        static NOTHING: SiblingTexts = SiblingTexts::new();
        let mut clues = Clues::unread(text, "", &NOTHING);
        clues.read(program);
        clues
    }

    /// The properties of a text with companion files.
    pub fn with_siblings(text: &'t str, name: &'t str, siblings: &'t SiblingTexts) -> Clues<'t> {
        let mut clues = Clues::unread(text, name, siblings);
        let completion = completions_of(&clues).into_iter().next_back();
        let completion = completion.map(|c| match clues.is_body {
            true => c.in_main(),
            false => c,
        });
        if let Some(checked) = completion.as_ref().and_then(Completion::check) {
            clues.read(&checked.program);
            let lacking = checked.diagnostics.iter();
            let lacking = lacking.filter(|d| d.lacks() == Some(Lack::Name));
            let sources = &checked.program.sources;
            clues.lacking = lacking.map(|d| sources.text(d.span).to_string()).collect();
        }
        clues
    }

    /// These properties, with the hosts of the program around the text.
    pub fn among(self, around: HostsAround<'t>) -> Clues<'t> {
        Clues { around, ..self }
    }

    /// The properties that follow from the words of a text alone.
    pub(super) fn unread(text: &'t str, name: &'t str, siblings: &'t SiblingTexts) -> Clues<'t> {
        let guess = guess(text);
        let TextWords { words, asked } = words(text);
        Clues {
            text,
            name,
            siblings,
            around: &Vec::new,
            asked,
            is_body: !guess.has_main && !guess.is_shadertoy() && !words.contains_key("mainImage"),
            guess,
            uniforms: Vec::new(),
            inputs: Vec::new(),
            has_output: false,
            words,
            declared: FxHashSet::default(),
            outer: FxHashSet::default(),
            lacking: FxHashSet::default(),
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
            let function = variable.function.and_then(|f| program.function(f));
            // A text without `main` was checked in the body of one.
            let is_outer = |name| self.is_body && program.names.text(name) == "main";
            if function.is_none_or(|f| is_outer(f.name)) {
                self.outer.insert(name.clone());
            }
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
        for name in functions.chain(macros.map(|m| m.name)) {
            let name = program.names.text(name);
            self.declared.insert(name.to_string());
            self.outer.insert(name.to_string());
        }
    }

    /// Whether the text can be drawn: it has an entry function, or statements outside of functions.
    pub fn is_shader(&self) -> bool {
        self.guess.kind.is_some() || (self.is_body && !self.declared.is_empty())
    }

    /// Whether it includes chunks of a library: `#include <common>`.
    pub fn has_include(&self) -> bool {
        let mut lines = self.text.lines().map(str::trim_start);
        lines.any(|line| {
            let rest = line.strip_prefix("#include").map(str::trim_start);
            let path = rest.and_then(|r| r.strip_prefix('<')?.split_once('>'));
            // A chunk has no extension; a path is a file of the project.
            path.is_some_and(|(path, _)| !is_provided(path.trim()) && !path.contains(['.', '/']))
        })
    }

    /// Whether it declares its output.
    pub fn declares_output(&self) -> bool {
        self.has_output
    }

    /// Whether a word occurs in the text, not counting comments.
    pub fn has_word(&self, word: &str) -> bool {
        self.words.contains_key(word)
    }

    /// Whether an `#if` uses the value of a word.
    pub fn is_condition(&self, word: &str) -> bool {
        self.words.get(word).is_some_and(|uses| uses.in_condition)
    }

    /// Whether a word occurs outside of conditions.
    pub fn is_read(&self, word: &str) -> bool {
        self.words.get(word).is_some_and(|uses| uses.in_code)
    }

    /// Whether the text declares a name.
    pub fn declares(&self, name: &str) -> bool {
        self.declared.contains(name)
    }

    /// Whether the text declares a name outside of functions, so that the host must not declare it.
    pub fn declares_outside(&self, name: &str) -> bool {
        self.outer.contains(name)
    }

    /// Whether the text uses a name without declaring it.
    pub fn is_free(&self, name: &str) -> bool {
        self.has_word(name) && !self.declares(name)
    }

    /// Whether a use of the name in the text lacks a declaration.
    pub fn is_lacking(&self, name: &str) -> bool {
        self.lacking.contains(name)
    }

    /// The undeclared words of the text that satisfy a predicate.
    pub fn free_words(&self, is_searched: impl Fn(&str) -> bool) -> Vec<&'t str> {
        let all = self.words.keys().copied();
        let mut found: Vec<&str> = all
            .filter(|w| is_searched(w) && !self.declares(w))
            .collect();
        found.sort_unstable();
        found
    }

    /// Whether the text declares a uniform with a name and one of several types.
    pub fn has_uniform(&self, name: &str, types: &[&str]) -> bool {
        let is_it = |d: &Interfacing| d.name == name && types.contains(&d.ty.as_str());
        self.uniforms.iter().any(is_it)
    }
}

/// Where a word of a text occurs.
#[derive(Clone, Copy, Default)]
struct WordUses {
    /// In an `#if` that uses its value.
    in_condition: bool,
    /// Outside of conditions.
    in_code: bool,
}

/// The words of a text.
#[derive(Default)]
struct TextWords<'t> {
    words: FxHashMap<&'t str, WordUses>,
    /// The version in its `#version`.
    asked: VersionAsked,
}

/// The version in the `#version` of a text.
pub(super) fn version_of(text: &str) -> VersionAsked {
    match text.contains("version") {
        true => words(text).asked,
        false => VersionAsked::Nothing,
    }
}

fn words(text: &str) -> TextWords<'_> {
    let mut found = TextWords::default();
    let mut after_hash = false;
    // The conditional directive of the current line, and the previous word.
    let (mut condition, mut before) = ("", "");
    for (kind, range, word) in written_tokens(text) {
        match kind {
            RawKind::Whitespace => continue,
            RawKind::Newline => condition = "",
            RawKind::Word => {
                if after_hash && word == "version" && found.asked == VersionAsked::Nothing {
                    let line = text.get(range.end..).and_then(|rest| rest.lines().next());
                    found.asked = VersionAsked::of(line.unwrap_or(""));
                }
                let uses = found.words.entry(word).or_default();
                match condition {
                    "" => uses.in_code = true,
                    "if" | "elif" if before != "defined" => uses.in_condition = true,
                    _ => {}
                }
                if after_hash && matches!(word, "if" | "elif" | "ifdef" | "ifndef" | "undef") {
                    condition = word;
                }
                before = word;
            }
            _ if word == "(" => {}
            _ => before = "",
        }
        after_hash = kind == RawKind::Hash;
    }
    found
}
