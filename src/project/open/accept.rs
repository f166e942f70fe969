//! Which texts are opened: shaders, in a language that is ported.

use shaderlint_detect::embed::extract_named;
use shaderlint_detect::kind::{Claim, Evidence, FileKind, ShaderLanguage, decide};
use std::path::Path;

/// The name of a file without its extension.
pub(super) fn title(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The shader in a script or page, at its lines; `None` if the text is a shader itself.
pub(super) fn only_shader(name: &str, text: &str) -> Result<Option<String>, String> {
    let FileKind::Holds(language) = decide(name, text, Claim::None).kind else {
        return Ok(None);
    };
    match &extract_named(name, language, text)[..] {
        [one] => {
            let before = text.get(..one.start).unwrap_or("");
            let lines = "\n".repeat(before.matches('\n').count());
            Ok(Some(format!("{lines}{}", one.code)))
        }
        [] => Err(format!(
            "expected a shader, found {language}; move the shader to a file of its own"
        )),
        all => Err(format!(
            "expected a shader, found {language} with {} shaders; move one of them to a file of its own",
            all.len()
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
