//! Author and licence of a shader, from its export or its comments.

use super::{Info, Project};

/// Maximum length of a licence line, in characters.
const MAX_LINE: usize = 200;

/// The first line of a comment that mentions a licence, without comment markers.
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

/// URL of the shader's page; empty without a valid id.
pub(super) fn link(info: &Info) -> String {
    let is_id =
        (4..=8).contains(&info.id.len()) && info.id.bytes().all(|b| b.is_ascii_alphanumeric());
    if is_id {
        format!("https://www.shadertoy.com/view/{}", info.id)
    } else {
        String::new()
    }
}

/// The licence stated in the code; for an export without one, ShaderToy's default.
pub(super) fn license(project: &Project) -> String {
    let license = project.passes.iter().find_map(|p| license_words(&p.code));
    match license {
        Some(words) => words,
        None if project.is_export => "The code states no licence; ShaderToy's default is \
             Creative Commons BY-NC-SA 3.0."
            .to_string(),
        None => String::new(),
    }
}

/// Title, author, URL and licence of an export, one per line, escaped for use in comments. Other
/// files contain their own credits.
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

/// A text on one line: without control characters, bidirectional controls, line separators and
/// backslashes, which would continue a comment on the next line.
fn plain(text: &str) -> String {
    let is_kept = |c: &char| {
        !c.is_control()
            && !matches!(c, '\\' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
    };
    let line: String = text.chars().filter(is_kept).take(MAX_LINE).collect();
    line.trim().replace("*/", "* /").replace("??", "? ?")
}

/// Whether a line contains a comment or looks like the inside of one.
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
