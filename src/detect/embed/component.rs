//! Shaders in components of Vue, Svelte and Astro: in their scripts, and in literals of their
//! templates.

use super::embedded::{Embedded, ImportedTexts};
use super::html::{self, next_script};
use super::script;
use std::ops::Range;

/// Finds the shaders of a component.
pub fn extract(text: &str, base: usize, modules: &dyn ImportedTexts, found: &mut Vec<Embedded>) {
    let count = found.len();
    let front = front_matter(text);
    script::extract(text.get(..front).unwrap_or(""), base, false, modules, found);
    let rest = text.get(front..).unwrap_or("");
    html::elements(rest, base + front, modules, found);
    let lower = rest.to_ascii_lowercase();
    let mut at = 0;
    loop {
        let element = next_script(&lower, at);
        let end = element.as_ref().map_or(rest.len(), |e| e.start);
        let between = rest.get(at..end).unwrap_or("");
        script::extract(between, base + front + at, false, modules, found);
        let Some(element) = element else { break };
        at = element.end;
    }
    if let Some(own) = found.get_mut(count..) {
        own.sort_by_key(|e| e.start);
    }
}

/// The code of the front matter of an Astro component.
pub(super) fn front_matter_code(text: &str) -> Option<Range<usize>> {
    let end = front_matter(text);
    let start = text.find("---")? + 3;
    (start + 4 <= end).then(|| start..end - 4)
}

/// Length of the front matter of an Astro component, between two lines of `---`.
fn front_matter(text: &str) -> usize {
    let Some(after) = text.trim_start().strip_prefix("---") else {
        return 0;
    };
    let start = text.len() - after.len();
    after.find("\n---").map_or(0, |end| start + end + 4)
}

#[cfg(test)]
mod tests {
    use super::super::embedded::NoModules;
    use super::*;

    #[test]
    fn only_scripts_and_literals_of_components_are_read() {
        let text = "---\nconst a = `#version 300 es\n1`;\n---\n<p>don't void main() {}</p>\
            <script lang=\"ts\">const b = `#version 300 es\n2`;</script>\
            <div x={/* glsl */ `3;`} />";
        let mut found = Vec::new();
        extract(text, 0, &NoModules, &mut found);
        let codes: Vec<&str> = found.iter().map(|s| s.code.as_str()).collect();
        assert_eq!(codes, ["#version 300 es\n1", "#version 300 es\n2", "3;"]);
        for shader in &found {
            assert_eq!(
                text.get(shader.start..shader.end()),
                Some(shader.code.as_str())
            );
        }
    }
}
