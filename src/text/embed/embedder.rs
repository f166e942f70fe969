//! What a page or script says of the shaders in it.

/// What a file says of the shaders in it.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Embedder {
    /// It asks for WebGL1, and nowhere for WebGL2.
    pub is_webgl1: bool,
    /// It hands shaders over to the browser itself, without a library.
    pub hands_over: bool,
    /// What it does with the blanks before a shader.
    pub front: Front,
}

impl Embedder {
    /// Reads what a page or script says.
    pub fn of(text: &str) -> Embedder {
        let asks_for_webgl1 = || {
            text.match_indices("getContext(").any(|(at, call)| {
                let rest = text.get(at + call.len()..).unwrap_or("").trim_start();
                let word = rest.get(1..).unwrap_or("");
                word.starts_with("webgl") || word.starts_with("experimental-webgl")
            })
        };
        Embedder {
            is_webgl1: !text.contains("webgl2") && asks_for_webgl1(),
            hands_over: text.contains(HANDS_OVER),
            front: Front::of(text),
        }
    }
}

/// What becomes of the blanks before a shader until the browser reads it.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Front {
    /// Something else hands the shader over.
    #[default]
    Unknown,
    /// They are taken away.
    Trimmed,
    /// They stay.
    Kept,
}

impl Front {
    /// Reads what a page or script does.
    pub(super) fn of(text: &str) -> Front {
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
            Front::Trimmed
        } else if text.contains(HANDS_OVER) {
            Front::Kept
        } else {
            Front::Unknown
        }
    }
}

/// The call that hands a shader over to the browser.
const HANDS_OVER: &str = ".shaderSource(";
