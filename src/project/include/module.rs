//! glslify modules. Each has its own namespace: names that it declares get a numbered suffix, as in
//! glslify, and its export gets the name under which it is required.

use super::find::{Absent, FoundFile};
use crate::access::FileAccess;
use crate::files::scan::{Form, IncludeDirective};
use shaderlint_syntax::{RawKind, TokenKind, written_tokens};
use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

/// Size limit in bytes of the modules of a shader.
const MAX_TEXT: usize = 16 * 1024 * 1024;
/// Maximum number of modules of a shader, and of lookups.
const MAX_MODULES: usize = 1_024;
/// Maximum depth of nested modules.
const MAX_DEPTH: usize = 64;

/// The modules of a shader.
#[derive(Default)]
pub struct Modules {
    /// The names that the shader gives to exports of modules.
    asked: HashMap<PathBuf, String>,
    made: Vec<MadeModule>,
    /// The stack of modules being included.
    open: Vec<PathBuf>,
    count: usize,
    size: usize,
    lookups: usize,
    /// Modules that were not found.
    pub missing: Vec<(String, Absent)>,
    /// Whether a part of a module is missing.
    pub is_open: bool,
}

/// A module that is included.
struct MadeModule {
    real: PathBuf,
    arguments: Vec<(String, String)>,
    export: String,
}

impl Modules {
    /// Records what the shader requires, so that modules that require the same can share it.
    pub fn expect(&mut self, name: &str, context: FileAccess, directives: &[IncludeDirective]) {
        for directive in directives.iter().take(MAX_MODULES) {
            if let Form::Require(requested, arguments) = &directive.form
                && arguments.is_empty()
                && let Ok(found) = context.find(name, &directive.requested)
            {
                self.asked
                    .entry(found.real)
                    .or_insert_with(|| requested.clone());
            }
        }
    }

    /// The text of a module as included in the shader, empty if it is included already, and the
    /// name of its export: `requested`, if given. `None` if it cannot be included.
    pub fn put(
        &mut self,
        found: &FoundFile,
        arguments: &[(String, String)],
        requested: Option<&str>,
        context: FileAccess,
    ) -> Option<(String, String)> {
        let is_same = |m: &&MadeModule| {
            m.real == found.real
                && m.arguments == arguments
                && requested.is_none_or(|w| w == m.export)
        };
        if let Some(made) = self.made.iter().find(is_same) {
            return Some((String::new(), made.export.clone()));
        }
        let export = found.file.scan.export.clone()?;
        let is_circle = self.open.contains(&found.real) || self.open.len() >= MAX_DEPTH;
        self.size += found.file.text.len();
        if is_circle || self.size > MAX_TEXT || self.count >= MAX_MODULES {
            return None;
        }
        self.count += 1;
        let number = self.count;
        let text = &*found.file.text;
        let own = top_names(text).into_iter();
        let mut names: HashMap<String, String> =
            own.map(|n| (n.clone(), format!("{n}_{number}"))).collect();
        names.extend(arguments.iter().cloned());
        let asked = self.asked.get(&found.real).filter(|_| arguments.is_empty());
        let requested = requested.map(str::to_string).or_else(|| asked.cloned());
        let exported = match requested {
            Some(requested) => {
                names.insert(export, requested.clone());
                requested
            }
            None => names.get(&export).unwrap_or(&export).clone(),
        };
        self.open.push(found.real.clone());
        let text = self.rewrite(found, names, context);
        self.open.pop();
        self.made.push(MadeModule {
            real: found.real.clone(),
            arguments: arguments.to_vec(),
            export: exported.clone(),
        });
        Some((text, exported))
    }

    /// Renames the names of a module, and includes the modules that it requires.
    fn rewrite(
        &mut self,
        found: &FoundFile,
        mut names: HashMap<String, String>,
        context: FileAccess,
    ) -> String {
        let text = &*found.file.text;
        let mut out = String::with_capacity(text.len());
        let mut done = 0;
        for directive in &found.file.scan.directives {
            rename(text, done..directive.start, &names, &mut out);
            done = directive.end;
            let Form::Require(name, arguments) = &directive.form else {
                self.is_open = true;
                continue;
            };
            self.lookups += 1;
            if self.lookups > MAX_MODULES {
                self.is_open = true;
                continue;
            }
            let renamed = |value: &String| names.get(value).unwrap_or(value).clone();
            let arguments: Vec<_> = arguments
                .iter()
                .map(|(name, value)| (name.clone(), renamed(value)))
                .collect();
            match context.find(&found.name, &directive.requested) {
                Ok(inner) => match self.put(&inner, &arguments, None, context) {
                    Some((text, export)) => {
                        out.push_str(&text);
                        names.insert(name.clone(), export);
                    }
                    None => self.is_open = true,
                },
                Err(absent) => self
                    .missing
                    .push((directive.requested.path.clone(), absent)),
            }
        }
        rename(text, done..text.len(), &names, &mut out);
        out.push('\n');
        out
    }
}

/// Copies a range of a text with names replaced.
fn rename(
    text: &str,
    part: std::ops::Range<usize>,
    names: &HashMap<String, String>,
    out: &mut String,
) {
    let part = text.get(part).unwrap_or("");
    let mut after_dot = false;
    for (kind, _, word) in written_tokens(part) {
        match kind {
            RawKind::Word if !(after_dot && is_swizzle(word)) => {
                out.push_str(names.get(word).map_or(word, String::as_str));
            }
            _ => out.push_str(word),
        }
        after_dot = kind == RawKind::Operator(TokenKind::Dot);
    }
}

/// Whether a word after a dot may be a swizzle.
fn is_swizzle(word: &str) -> bool {
    word.len() <= 4 && word.chars().all(|c| "xyzwrgbastpq".contains(c))
}

/// Keywords of declarations that are shared by the whole shader or declare no name.
const SHARED: [&str; 7] = [
    "uniform",
    "attribute",
    "varying",
    "in",
    "out",
    "precision",
    "layout",
];

/// The functions, structs, variables and constants that a text declares at global scope.
fn top_names(text: &str) -> HashSet<String> {
    let mut reader = ModuleReader::default();
    let mut at_line_start = true;
    let mut in_directive = false;
    for (kind, _, word) in written_tokens(text) {
        match kind {
            RawKind::Newline => {
                at_line_start = true;
                in_directive = false;
            }
            blank if blank.is_blank() => {}
            RawKind::Hash if at_line_start => in_directive = true,
            kind => {
                at_line_start = false;
                if !in_directive {
                    reader.token(kind, word);
                }
            }
        }
    }
    reader.found
}

#[derive(Default)]
struct ModuleReader {
    found: HashSet<String>,
    /// Number of open braces and brackets.
    depth: usize,
    /// Whether the words since the last `;` start a shared declaration.
    is_shared: bool,
    is_initializer: bool,
    /// The word that may be a declared name, and whether its predecessor allows that.
    word: Option<String>,
    may_follow: bool,
    is_struct: bool,
}

impl ModuleReader {
    fn token(&mut self, kind: RawKind, text: &str) {
        let at_top = self.depth == 0;
        let ends_name = matches!(text, "(" | "=" | ";" | "," | "[");
        if let Some(word) = self.word.take().filter(|_| ends_name && at_top)
            && !self.is_shared
            && !self.is_initializer
        {
            self.found.insert(word);
        }
        match text {
            "(" | "[" | "{" => self.depth += 1,
            ")" | "]" | "}" => {
                self.depth = self.depth.saturating_sub(1);
                self.may_follow = matches!(text, "]" | "}");
                self.is_shared &= text != "}" || self.depth > 0;
                return;
            }
            ";" if at_top => {
                (self.is_shared, self.is_initializer) = (false, false);
                self.may_follow = false;
                return;
            }
            "," if at_top => {
                self.is_initializer = false;
                self.may_follow = true;
                return;
            }
            "=" if at_top => self.is_initializer = true,
            _ => {}
        }
        let is_word = kind == RawKind::Word;
        if at_top && is_word {
            self.is_shared |= SHARED.contains(&text);
            if std::mem::take(&mut self.is_struct) {
                self.found.insert(text.to_string());
            }
            self.is_struct = text == "struct";
            let is_own = !text.starts_with("gl_");
            self.word = (self.may_follow && is_own).then(|| text.to_string());
        }
        self.may_follow = is_word;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn top_level_declarations_of_a_module_are_private() {
        let text = "precision highp float;\nuniform float time;\nvarying vec2 uv;\n#define K 1.\n\
            struct Ray { vec3 from; } ray;\nconst float a = max(b, c), d[2] = float[2](1., 2.);\n\
            float f(in vec2 p, float q) { float inner = p.x; return inner; }\nvec2 g(vec2 p);\n";
        let mut found: Vec<_> = top_names(text).into_iter().collect();
        found.sort();
        assert_eq!(found, ["Ray", "a", "d", "f", "g", "ray"]);
    }

    #[test]
    fn components_keep_their_names() {
        let names = HashMap::from([
            ("x".to_string(), "x_1".to_string()),
            ("field".to_string(), "field_1".to_string()),
        ]);
        let mut out = String::new();
        rename("ab field = v.x + s.field * x;", 3..29, &names, &mut out);
        assert_eq!(out, "field_1 = v.x + s.field_1 * x_1;");
    }
}
