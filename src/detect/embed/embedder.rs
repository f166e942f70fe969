//! What a page or script does with its shaders.

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
    pub fn of(text: &str) -> Embedder {
        Embedder {
            hands_over: text.contains(HANDS_OVER),
            leading_blanks: LeadingBlanks::of(text),
        }
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

impl LeadingBlanks {
    /// Analyses a page or script.
    pub(super) fn of(text: &str) -> LeadingBlanks {
        const TRIMS: [&str; 7] = [
            ".trim()",
            ".trimStart()",
            ".trimLeft()",
            ".replace(/^\\s",
            ".replace(/^[\\s",
            ".replace(/^\\n",
            ".replace(/^[\\n",
        ];
        if TRIMS.iter().any(|t| text.contains(t)) {
            LeadingBlanks::Trimmed
        } else if text.contains(HANDS_OVER) {
            LeadingBlanks::Kept
        } else {
            LeadingBlanks::Unknown
        }
    }
}

/// The call that passes a shader to the browser.
const HANDS_OVER: &str = ".shaderSource(";
