//! Macros that the program around a shader may define.

use serde::Serialize;
use shaderlint_semantic::Program;
use shaderlint_syntax::{
    ConditionalDirective, MacroTestKind, RawItem, is_blank, raw_items, tokenize,
};
use shaderlint_text::{FileId, Role, Span};
use std::collections::HashSet;

/// A macro that conditions test.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct SettableMacro {
    /// Its name.
    pub name: String,
    /// Whether its value counts, and not only that it is defined.
    pub has_value: bool,
    /// The value that the shader gives it if nobody else does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub default: Option<String>,
}

/// The macros that a shader of these files tests before it defines them, in order.
pub fn settable(program: &Program, files: &[FileId]) -> Vec<SettableMacro> {
    let mut reader = MacroReader::default();
    let predefined = program.tokens.macros.iter().filter(|m| m.predefined);
    let predefined = predefined.map(|m| program.names.text(m.name).to_string());
    reader.defined.extend(predefined);
    for code in files.iter().filter_map(|id| program.sources.code(*id)) {
        let span = Span::new(code.base, code.base + code.text.len() as u32);
        match code.role {
            Role::User => reader.read(code.text, code.base),
            // The macros of a host are there before the text.
            Role::Prelude => {
                let macros = program.tokens.macros.iter();
                let own = macros.filter(|m| span.contains(m.name_span));
                let names = own.map(|m| program.names.text(m.name).to_string());
                reader.defined.extend(names);
            }
        }
    }
    let mut found = reader.found;
    // A guard against including a file twice is no setting.
    found.retain(|m| m.has_value || m.default.is_none());
    found
}

#[derive(Default)]
struct MacroReader {
    found: Vec<SettableMacro>,
    /// The macros that the text or the language defines before anything tests them.
    defined: HashSet<String>,
}

impl MacroReader {
    fn read(&mut self, code: &str, base: u32) {
        let text = |span: Span| {
            let range = (span.start - base) as usize..(span.end - base) as usize;
            code.get(range).unwrap_or("")
        };
        for item in raw_items(&tokenize(code, base)) {
            if let Some(directive) = ConditionalDirective::read(&item, code, base) {
                for test in directive.tests() {
                    self.test(test.name, test.kind != MacroTestKind::Defined);
                }
                continue;
            }
            let RawItem::Directive(_, line) = item else {
                continue;
            };
            let mut words = line.iter().filter(|token| !is_blank(token.kind));
            if words.next().is_some_and(|word| text(word.span) == "define")
                && let Some(name) = words.next()
            {
                let end = words
                    .next_back()
                    .map_or(name.span.end, |last| last.span.end);
                let value = text(Span::new(name.span.end, end));
                self.define(text(name.span), value.trim());
            }
        }
    }

    fn test(&mut self, name: &str, has_value: bool) {
        match self.found.iter_mut().find(|known| known.name == name) {
            Some(known) => known.has_value |= has_value,
            None if self.defined.contains(name) || name.starts_with("GL_") => {}
            None => self.found.push(SettableMacro {
                name: name.to_string(),
                has_value,
                default: None,
            }),
        }
    }

    /// What is defined after a test is the default of a macro that somebody may have set.
    fn define(&mut self, name: &str, value: &str) {
        match self.found.iter_mut().find(|known| known.name == name) {
            Some(known) => {
                known.has_value |= !value.is_empty();
                known.default.get_or_insert_with(|| value.to_string());
            }
            None => {
                self.defined.insert(name.to_string());
            }
        }
    }
}
