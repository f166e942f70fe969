//! The languages that GLSL is found in.

use std::fmt;

/// The languages that GLSL is found in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DocumentLanguage {
    /// HTML: script elements, and literals in scripts.
    Html,
    /// JavaScript and TypeScript: literals.
    Script,
    /// Vue, Svelte and Astro: script elements, and literals in the text around them.
    Component,
    /// Markdown: fences.
    Markdown,
    /// KDL, as in the configuration of niri: strings.
    Kdl,
    /// GLSL: several shaders, which a program splits.
    Sections,
}

impl fmt::Display for DocumentLanguage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            DocumentLanguage::Html => "HTML",
            DocumentLanguage::Script => "a script",
            DocumentLanguage::Component => "a component",
            DocumentLanguage::Markdown => "Markdown",
            DocumentLanguage::Kdl => "KDL",
            DocumentLanguage::Sections => "several shaders",
        })
    }
}

impl DocumentLanguage {
    /// The language of files with this extension.
    pub fn of_extension(extension: &str) -> Option<DocumentLanguage> {
        Some(match extension {
            "html" | "htm" | "xhtml" => DocumentLanguage::Html,
            "js" | "mjs" | "cjs" | "jsx" | "ts" | "mts" | "cts" | "tsx" => DocumentLanguage::Script,
            "vue" | "svelte" | "astro" => DocumentLanguage::Component,
            "md" | "markdown" | "mdx" => DocumentLanguage::Markdown,
            "kdl" => DocumentLanguage::Kdl,
            _ => return None,
        })
    }
}
