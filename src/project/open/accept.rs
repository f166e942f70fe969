//! Which texts are opened: shaders, in a language that is ported.

use shaderlint_detect::embed::{DocumentLanguage, extract_named};
use shaderlint_detect::kind::{Claim, Evidence, FileKind, ShaderLanguage, decide};
use shaderlint_semantic::{Stage, guess};
use std::path::Path;

/// The name of a file without its extension.
pub(super) fn title(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// A shader in a document.
pub(super) struct HeldShader {
    pub code: String,
    /// Its first line in the document, from 1.
    pub line: u32,
    /// What is said about further shaders.
    pub note: Option<String>,
}

/// The shader in a document; `None` if the text is a shader itself. Only KDL has several that are
/// alternatives.
pub(super) fn held(name: &str, text: &str) -> Result<Option<HeldShader>, String> {
    let FileKind::Holds(language) = decide(name, text, Claim::None).kind else {
        return Ok(None);
    };
    let mut all = extract_named(name, language, text);
    all.retain(|shader| !shader.has_holes && guess(&shader.code).stage != Some(Stage::Vertex));
    let line = |at: usize| 1 + text.get(..at).unwrap_or("").matches('\n').count() as u32;
    match &all[..] {
        [first, rest @ ..] if rest.is_empty() || language == DocumentLanguage::Kdl => {
            let note = rest.first().map(|next| {
                let (count, next) = (all.len(), line(next.start));
                format!("the first of {count} shaders is drawn; the next one starts in line {next}")
            });
            Ok(Some(HeldShader {
                code: first.code.clone(),
                line: line(first.start),
                note,
            }))
        }
        _ => Err(format!(
            "expected a shader, found {language}; move the shader to a file of its own"
        )),
    }
}

/// Rejects a shader in a language that is not ported, at the code that shows it.
pub(super) fn reject_other_languages(name: &str, text: &str) -> Result<(), String> {
    let FileKind::Foreign(language) = decide(name, text, Claim::None).kind else {
        return Ok(());
    };
    if language == ShaderLanguage::Desktop {
        return Ok(());
    }
    let sign = Evidence::of(text).first_sign(language).unwrap_or(0..0);
    let before = text.get(..sign.start).unwrap_or("");
    let line = before.matches('\n').count() + 1;
    let found = match text.get(sign).unwrap_or("") {
        "" => String::new(),
        code => format!(": `{code}`"),
    };
    Err(format!(
        "{name}:{line}: expected GLSL for ShaderToy, WebGL or another host, found {}{found}",
        language.shader()
    ))
}
