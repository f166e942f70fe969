//! Which contexts of WebGL a page or script asks for, and which extensions it may enable.

use super::together::scripts;
use crate::document_language::DocumentLanguage;
use crate::script::parse;
use crate::script::tree::{BindingValue, NodeKind, ScriptNodeId, ScriptTree};

/// What a page or script asks WebGL for.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct AskedWebGl {
    /// Whether it asks for a context of WebGL1.
    pub one: bool,
    /// Whether it asks for a context of WebGL2.
    pub two: bool,
    /// Its constant strings, as far as they may name an extension.
    pub words: Vec<String>,
    /// Whether it asks for a context and compiles shaders itself.
    pub compiles: bool,
    /// Whether all code that its context goes through is in it, too.
    pub is_all: bool,
}

impl AskedWebGl {
    /// Whether a page or script may ask for WebGL1 and not for WebGL2, without reading it.
    pub fn may_be_only_one(text: &str) -> bool {
        let names = ["\"webgl\"", "'webgl'", "`webgl`", "experimental-webgl"];
        names.iter().any(|name| text.contains(name)) && !text.contains("webgl2")
    }

    /// Reads a page or script.
    pub fn of(language: DocumentLanguage, text: &str) -> AskedWebGl {
        let mut found = AskedWebGl::default();
        if !text.contains("getContext") && !text.contains("xtension") {
            return found;
        }
        let mut calls = ContextCalls::default();
        for part in scripts(language, text) {
            let script = text.get(part).unwrap_or("");
            let tree = parse(script);
            calls.read(script, &tree, &mut found);
        }
        let is_external = language != DocumentLanguage::Script && text.contains(" src=");
        found.compiles = calls.compiles && calls.asks;
        found.is_all = found.compiles && !calls.is_open && !is_external;
        let knows = calls.asks;
        (found.one, found.two) = (found.one && knows, found.two && knows);
        found
    }

    /// Adds what another script of the same program asks for.
    pub fn join(&mut self, other: AskedWebGl) {
        self.one |= other.one;
        self.two |= other.two;
        self.words.extend(other.words);
        self.compiles &= other.compiles;
        self.is_all &= other.is_all;
    }
}

/// The calls of a page that have to do with its context.
#[derive(Default)]
struct ContextCalls {
    /// `getContext`
    asks: bool,
    /// `shaderSource`
    compiles: bool,
    /// Whether other code may enable extensions: modules, and names that are not strings.
    is_open: bool,
}

impl ContextCalls {
    fn read(&mut self, text: &str, tree: &ScriptTree, found: &mut AskedWebGl) {
        let is_import = |value: &BindingValue| matches!(value, BindingValue::Import(..));
        self.is_open |= tree.bindings.iter().any(|b| is_import(&b.value));
        for node in &tree.nodes {
            match &node.kind {
                NodeKind::Text => match text.get(node.span.clone()).unwrap_or("") {
                    "webgl" | "experimental-webgl" => found.one = true,
                    "webgl2" | "experimental-webgl2" => found.two = true,
                    word if word.contains('_') => found.words.push(word.to_string()),
                    _ => {}
                },
                // `extensions: { OES_standard_derivatives: true }`
                NodeKind::Property(name) | NodeKind::Member(name) => {
                    let name = text.get(name.clone()).unwrap_or("");
                    if name.contains('_') {
                        found.words.push(name.to_string());
                    }
                }
                NodeKind::Call => self.call(text, tree, &node.children),
                _ => {}
            }
        }
    }

    fn call(&mut self, text: &str, tree: &ScriptTree, children: &[ScriptNodeId]) {
        let callee = children.first().and_then(|id| tree.last_name(text, *id));
        let argument = children.get(1).and_then(|id| tree.node(*id));
        match callee {
            Some("getContext") => self.asks = true,
            Some("shaderSource") => self.compiles = true,
            Some("getExtension") => {
                self.is_open |= argument.is_none_or(|a| a.kind != NodeKind::Text);
            }
            Some("require") => self.is_open = true,
            _ => {}
        }
    }
}
