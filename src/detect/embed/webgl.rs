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

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(script: &str, (one, two, is_all): (bool, bool, bool), words: &[&str]) {
        let found = AskedWebGl::of(DocumentLanguage::Script, script);
        assert_eq!(
            (found.one, found.two, found.is_all),
            (one, two, is_all),
            "{script}"
        );
        assert_eq!(found.words, words, "{script}");
    }

    #[test]
    fn contexts_and_extensions_are_read_from_scripts() {
        let lod = ["EXT_shader_texture_lod"];
        check(
            "const gl = c.getContext('webgl'); gl.getExtension('EXT_shader_texture_lod'); gl.shaderSource(s, f);",
            (true, false, true),
            &lod,
        );
        check(
            "const gl = c.getContext('webgl2') || c.getContext('webgl');",
            (true, true, false),
            &[],
        );
        check(
            "const gl = ['webgl2', 'webgl'].map((kind) => c.getContext(kind)).find(Boolean);",
            (true, true, false),
            &[],
        );
        check(
            "import { f } from './f.js'; const gl = c.getContext('webgl'); f(gl); gl.shaderSource(s, f);",
            (true, false, false),
            &[],
        );
        check(
            "const gl = c.getContext('webgl'); gl.shaderSource(s, f); all.forEach((e) => gl.getExtension(e));",
            (true, false, false),
            &[],
        );
        check(
            "const draw = regl({ extensions: ['EXT_shader_texture_lod'] });",
            (false, false, false),
            &lod,
        );
    }

    #[test]
    fn only_the_scripts_of_a_page_are_read() {
        let page =
            "<p>getContext('webgl2')</p><script>c.getContext('webgl').shaderSource()</script>";
        let found = AskedWebGl::of(DocumentLanguage::Html, page);
        assert_eq!((found.one, found.two, found.is_all), (true, false, true));
        let page =
            "<script src=gl.js></script><script>c.getContext('webgl').shaderSource()</script>";
        assert!(!AskedWebGl::of(DocumentLanguage::Html, page).is_all);
    }
}
