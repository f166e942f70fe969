//! Who made a shader, and who may do what with it, as far as its text says.

use super::{Info, Project};

/// Most characters of a licence line that are kept.
const MAX_LINE: usize = 200;

/// The first line of a comment that speaks of a licence, without the marks of the comment.
pub fn license_words(code: &str) -> Option<String> {
    let is_about = |line: &str| {
        let line = line.to_ascii_lowercase();
        [
            "license",
            "licence",
            "spdx",
            "copyright",
            "creative commons",
            "cc0",
            "public domain",
        ]
        .iter()
        .any(|word| line.contains(word))
    };
    let line = code
        .lines()
        .find(|line| is_comment(line) && is_about(line))?;
    let text = line.trim().trim_start_matches(['/', '*', ' ', '\t']);
    let text = text.trim_end_matches(['/', '*', ' ', '\t']);
    Some(text.chars().take(MAX_LINE).collect())
}

/// Address of the shader's page, where its id is one.
pub(super) fn link(info: &Info) -> String {
    let is_id =
        (4..=8).contains(&info.id.len()) && info.id.bytes().all(|b| b.is_ascii_alphanumeric());
    if is_id {
        format!("https://www.shadertoy.com/view/{}", info.id)
    } else {
        String::new()
    }
}

/// What the code says of its licence; for an export that says nothing, what ShaderToy says.
pub(super) fn license(project: &Project) -> String {
    let said = project.passes.iter().find_map(|p| license_words(&p.code));
    match said {
        Some(words) => words,
        None if project.is_export => "No licence is given in the code; on ShaderToy that means \
             Creative Commons BY-NC-SA 3.0."
            .to_string(),
        None => String::new(),
    }
}

/// Title, author, link and licence of an export, a line each, in signs that end no comment. A
/// file of the user's own says of itself what is to be said.
pub(super) fn lines(project: &Project) -> Vec<String> {
    if !project.is_export {
        return Vec::new();
    }
    let info = &project.info;
    let by = match info.author.as_str() {
        "" => String::new(),
        author => format!("by {author}"),
    };
    let all = [info.name.clone(), by, link(info), license(project)];
    let lines = all.iter().map(|line| plain(line));
    lines.filter(|line| !line.is_empty()).collect()
}

/// A text on one line: without control characters, signs that change the direction of writing, line
/// separators, and the backslash, which would join the next line to a comment.
fn plain(text: &str) -> String {
    let is_kept = |c: &char| {
        !c.is_control()
            && !matches!(c, '\\' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
    };
    let line: String = text.chars().filter(is_kept).take(MAX_LINE).collect();
    line.trim().replace("*/", "* /").replace("??", "? ?")
}

/// Whether a line holds a comment, or lies inside one as far as its start tells.
fn is_comment(line: &str) -> bool {
    let start = line.trim_start();
    line.contains("//") || line.contains("/*") || start.starts_with('*') || !start.contains(';')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_licence_is_found_in_comments() {
        let code = "// The MIT License\n// Copyright 2020 A";
        assert_eq!(license_words(code).as_deref(), Some("The MIT License"));
        let code = "float a;\n/* License: CC0 */";
        assert_eq!(license_words(code).as_deref(), Some("License: CC0"));
        assert_eq!(license_words("float license = 1.0;"), None);
    }
}
