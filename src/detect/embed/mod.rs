//! GLSL embedded in web pages, scripts and documents.
//!
//! A shader is a range of the outer text together with code of the same length, in which the syntax
//! of the outer language is blank. So offsets in a shader are offsets in the file. Escape sequences
//! are decoded (`\n` is a line break), and `${...}` is replaced by an undeclared name.

mod changes;
mod component;
mod context;
mod embedded;
mod embedder;
mod hole;
mod holes;
mod html;
mod kdl;
mod listing;
mod markdown;
mod markup;
mod mention;
mod receiver;
mod script;
mod tag;
mod template;
mod text;
mod together;
mod webgl;

use crate::kind::{may_be_shader, sections};
use crate::script::is_limited_once;

pub use crate::document_language::DocumentLanguage;
pub use embedded::{
    Embedded, ImportedTexts, InsertedPart, ModuleFile, NamedStage, NoModules, Wrapping, joined,
};
pub use embedder::{Embedder, LeadingBlanks};
pub use holes::mask;
pub use html::{element_of, script_files};
pub use mention::{Mention, MentionKind, NameRole, mentions};
pub use receiver::ShaderReceiver;
pub use script::ParsedScript;
pub use together::{lists, strings, together};
pub use webgl::AskedWebGl;

/// The scripts of a file, with blanks for everything else, so that offsets are the same; `None` if it is no file
/// with scripts.
pub fn script_code(language: DocumentLanguage, text: &str) -> Option<String> {
    // The parser has no limit of its own.
    if !is_limited_once(text) {
        return None;
    }
    let mut ranges = match language {
        DocumentLanguage::Script => return Some(text.to_string()),
        DocumentLanguage::Component | DocumentLanguage::Html => html::scripts(text),
        _ => return None,
    };
    if language == DocumentLanguage::Component {
        ranges.extend(component::front_matter_code(text));
    }
    let mut code: String = text
        .chars()
        .flat_map(|c| std::iter::repeat_n(if c == '\n' { '\n' } else { ' ' }, c.len_utf8()))
        .collect();
    for range in &ranges {
        code.replace_range(range.clone(), text.get(range.clone())?);
    }
    if language == DocumentLanguage::Component {
        markup::add_elements(text, &ranges, &mut code);
    }
    Some(code)
}

/// Finds the shaders in a file, in source order.
pub fn extract(language: DocumentLanguage, text: &str) -> Vec<Embedded> {
    extract_named("", language, text)
}

/// Finds the shaders in a file of this name, which may indicate shaders.
pub fn extract_named(name: &str, language: DocumentLanguage, text: &str) -> Vec<Embedded> {
    extract_with(name, language, text, &NoModules)
}

/// Finds the shaders in a file of this name, with what they insert from other modules.
pub fn extract_with(
    name: &str,
    language: DocumentLanguage,
    text: &str,
    modules: &dyn ImportedTexts,
) -> Vec<Embedded> {
    let mut found = Vec::new();
    let signs = ["glsl", "GLSL", "shader", "Shader", "```", "~~~"];
    if !may_be_shader(text) && !signs.iter().any(|w| text.contains(w)) {
        return found;
    }
    match language {
        DocumentLanguage::Html => html::extract(text, 0, modules, &mut found),
        DocumentLanguage::Script => {
            script::extract(
                text,
                0,
                context::is_file_of_shaders(name),
                modules,
                &mut found,
            );
        }
        DocumentLanguage::Component => component::extract(text, 0, modules, &mut found),
        DocumentLanguage::Markdown => markdown::extract(name, text, &mut found),
        DocumentLanguage::Kdl => kdl::extract(text, 0, &mut found),
        DocumentLanguage::Sections => found.extend(sections(text).into_iter().map(Embedded::from)),
    }
    found.iter_mut().for_each(Embedded::leave_out);
    let is_element = |shader: &&mut Embedded| shader.wrapping == Wrapping::Element;
    if matches!(
        language,
        DocumentLanguage::Html | DocumentLanguage::Component
    ) && Embedder::of(language, text).leading_blanks == LeadingBlanks::Trimmed
    {
        let elements = found.iter_mut().filter(is_element);
        elements.for_each(Embedded::trim_start);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::{Edit, Span};

    #[test]
    fn edits_outside_of_the_shader_are_refused() {
        let text = "x = \"void main() {\\n}\";";
        let found = extract(DocumentLanguage::Script, text);
        let shader = &found[0];
        let at = |word: &str| text.find(word).unwrap() as u32;
        let edit = |from: u32, to: u32, with: &str| Edit::replace(Span::new(from, to), with);
        assert!(shader.admits(text, &edit(at("main"), at("()"), "foo")));
        assert!(!shader.admits(text, &edit(at("main"), at("()"), "\n")));
        assert!(!shader.admits(text, &edit(at("\\n"), at("\\n") + 2, "")));
        assert!(!shader.admits(text, &edit(0, 1, "y")));
    }

    #[test]
    fn lines_are_added_only_to_fences_at_the_start_of_the_line() {
        let admits = |text: &str| {
            let found = extract(DocumentLanguage::Markdown, text);
            let at = text.find("a;").unwrap() as u32;
            let edit = |with: &str| Edit::replace(Span::new(at, at + 1), with);
            ["b", "b\n"].map(|with| found[0].admits(text, &edit(with)))
        };
        assert_eq!(admits("b\n```glsl\na;\n```\n"), [true, true]);
        assert_eq!(admits("- b\n  ```glsl\n  a;\n  ```\n"), [true, false]);
        assert_eq!(admits("> ```glsl\n> a;\n> ```\n"), [true, false]);
    }
}
