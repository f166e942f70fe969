//! Who may do what with a shader, as far as its text says.

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
