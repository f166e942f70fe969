//! What a page or script does with its shaders.

use super::DocumentLanguage;
use super::together::scripts;
use crate::script::parse;
use crate::script::tree::NodeKind;

/// What a file does with its shaders.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Embedder {
    /// It compiles shaders itself, without a library.
    pub hands_over: bool,
    /// What it does with leading white space of shaders.
    pub leading_blanks: LeadingBlanks,
}

impl Embedder {
    /// Analyses a page or script.
    pub fn of(language: DocumentLanguage, text: &str) -> Embedder {
        let mut found = Embedder::default();
        let mut trims = false;
        let calls = ["shaderSource", "trim", "replace"];
        if !calls.iter().any(|name| text.contains(name)) {
            return found;
        }
        for script in scripts(language, text) {
            let text = text.get(script).unwrap_or("");
            let tree = parse(text);
            for node in tree.nodes.iter().filter(|node| node.kind == NodeKind::Call) {
                let mut parts = node.children.iter();
                let callee = parts.next().and_then(|id| tree.last_name(text, *id));
                let first = parts.next().and_then(|id| tree.node(*id));
                let first = first.and_then(|first| text.get(first.span.clone()));
                match (callee, first) {
                    (Some("shaderSource"), _) => found.hands_over = true,
                    (Some("trim" | "trimStart" | "trimLeft"), None) => trims = true,
                    (Some("replace"), Some(pattern)) => {
                        let starts = ["/^\\s", "/^[\\s", "/^\\n", "/^[\\n"];
                        trims |= starts.iter().any(|start| pattern.starts_with(start));
                    }
                    _ => {}
                }
            }
        }
        found.leading_blanks = match (trims, found.hands_over) {
            (true, _) => LeadingBlanks::Trimmed,
            (false, true) => LeadingBlanks::Kept,
            (false, false) => LeadingBlanks::Unknown,
        };
        found
    }
}

/// What happens to leading white space before the shader is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum LeadingBlanks {
    /// Unknown, because other code compiles the shader.
    #[default]
    Unknown,
    /// Removed.
    Trimmed,
    /// Kept.
    Kept,
}
