//! Fragment shaders for the ShaderMaterial of three.js.
//!
//! Source: the preset `three` (`src/host/presets/libraries/three.glsl`), which contains the
//! declarations that three.js adds. The varyings are common ones of user-defined vertex shaders,
//! such as `vUv`: they have the values of a plane in front of the camera.

use super::complete::{Completion, completions_of, defaults};
use super::{Clues, HostCode, Plan, Sign};
use shaderlint_host::{OWN, preset};
use shaderlint_syntax::Version;

pub(super) static CODE: HostCode = HostCode {
    host: "three",
    signs: |clues| match clues.has_include() {
        true => vec![Sign::new("`#include <...>`", OWN)],
        false => Vec::new(),
    },
    plan: Some(plan),
    declare: None,
};

/// Own definitions of the functions and macros of three.js that are used most, one per line.
const BROUGHT: &str = include_str!("three.glsl");

/// The name that a line of [`BROUGHT`] defines.
fn defined(line: &str) -> &str {
    let line = line.strip_prefix("#define ").unwrap_or(line);
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words = line.split(|c| !is_part(c)).filter(|w| !w.is_empty());
    let is_macro = !line.contains('{');
    words.take(2).nth(usize::from(!is_macro)).unwrap_or("")
}

/// The definitions that the text does not contain itself, if it uses any.
fn brought(clues: &Clues) -> String {
    match BROUGHT.lines().any(|line| clues.is_free(defined(line))) {
        true => {
            let own = BROUGHT.lines().filter(|l| !clues.declares(defined(l)));
            own.map(|line| format!("{line}\n")).collect()
        }
        false => String::new(),
    }
}

/// Macros that the material's `defines` provide: those used in `#if` are 0, the others `value`.
fn defines(clues: &Clues, known: &str, value: &str) -> (String, Vec<String>) {
    let is_constant = |w: &str| {
        let mut chars = w.chars();
        w.len() > 2
            && !w.starts_with("GL_")
            && !w.starts_with("__")
            && chars.all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_')
            && w.starts_with(|c: char| c.is_ascii_uppercase())
            && !known
                .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                .any(|k| k == w)
    };
    let names = clues.free_words(is_constant);
    let mut text = String::new();
    let mut values = Vec::new();
    for name in names {
        // Macros that are only tested for existence stay undefined.
        let value = match (clues.is_condition(name), clues.is_read(name)) {
            (true, _) => "0",
            (false, true) => value,
            (false, false) => continue,
        };
        text.push_str(&format!("#define {name} {value}\n"));
        values.push(format!("`{name}` = {value}"));
    }
    (text, values)
}

fn plan(clues: &Clues) -> Plan {
    let host = preset("three").map_or(String::new(), |p| p.declarations(false));
    let output = match clues.declares_output() {
        true => "#define OWN_OUTPUT 1\n",
        false => "",
    };
    let head = format!(
        "{}{output}{host}{}",
        defaults(Version::Es300),
        brought(clues)
    );
    let around = |value: &str| {
        let (macros, values) = defines(clues, &head, value);
        let own = Completion::after(format!("{head}{macros}"), clues.text);
        let mut notes = Vec::new();
        if clues.has_include() {
            notes.push("`#include` chunks of three.js are not expanded".to_string());
        }
        if !values.is_empty() {
            notes.push(format!(
                "undefined macros get default values: {}",
                values.join(", ")
            ));
        }
        match notes.is_empty() {
            true => own,
            false => own.with_note(notes.join("; ")),
        }
    };
    // The shader of a RawShaderMaterial declares everything itself.
    let raw = completions_of(clues).into_iter();
    Plan::image(
        [around("4"), around("4.0")]
            .into_iter()
            .chain(raw)
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Project;

    #[test]
    fn names_of_three_js_chunks_are_listed() {
        let names: Vec<&str> = BROUGHT.lines().map(defined).collect();
        assert!(names.contains(&"saturate") && names.contains(&"packDepthToRGBA"));
        assert!(
            names
                .iter()
                .all(|n| !n.is_empty() && !matches!(*n, "float" | "vec3"))
        );
    }

    #[track_caller]
    fn draws(text: &str) -> Project {
        let project = Project::draft("", text, preset("three")).unwrap();
        let pass = &project.passes[0];
        let code = Completion {
            before: pass.before.clone(),
            ..Completion::bare(&pass.code)
        };
        let found = code.check().unwrap().diagnostics;
        let is_error = |d: &&shaderlint_diagnostic::Diagnostic| {
            d.severity == shaderlint_diagnostic::Severity::Error
        };
        assert_eq!(found.iter().filter(is_error).count(), 0, "{found:?}");
        project
    }

    #[test]
    fn functions_and_macros_of_three_js_are_defined() {
        draws(
            "#include <common>\n#include <packing>\nvarying vec2 vUv;\nvoid main() {\n\
             gl_FragColor = packDepthToRGBA(rand(vUv) * luminance(vec3(saturate(vUv.x))));\n}\n",
        );
        draws(
            "float rand(vec2 p) { return p.x; }\nvoid main() { gl_FragColor = vec4(rand(vec2(PI))); }\n",
        );
        let values = draws(
            "varying vec2 vUv;\nvoid main() {\nfloat s = 0.0;\nfor (int i = 0; i < SAMPLES; i++) s += 0.1;\n\
             #if PERSPECTIVE == 1\ns = 0.0;\n#endif\n#ifdef USE_MAP\ns = MAP_SCALE;\n#endif\n\
             gl_FragColor = vec4(s);\n}\n",
        );
        let note = "undefined macros get default values: `MAP_SCALE` = 4, `PERSPECTIVE` = 0, \
            `SAMPLES` = 4";
        assert_eq!(values.notes, [note]);
    }
}
