//! A complete shader as code with a `mainImage`: what it declares for its own host is removed, and
//! its `main` is called by a `mainImage` after it.

use super::renamed::{unused, words};
use super::used::{UsedInput, UsedValue};
use crate::ProjectPass;
use shaderlint_host::Feed;
use shaderlint_semantic::{Program, Stage, Storage, Variable};
use shaderlint_syntax::{Lexer, RawKind};
use shaderlint_text::Span;
use std::collections::BTreeSet;
use std::ops::Range;

/// How a complete shader becomes code with a `mainImage`.
#[derive(Default)]
pub(super) struct PlainShader {
    /// New names: of `main`, and of what its host calls its position and its colour.
    pub(super) names: Vec<(String, String)>,
    /// Declarations of what its host sets and reads.
    pub(super) globals: String,
    /// The `mainImage`.
    pub(super) image: String,
    /// Its name, which is another one if the shader has a function of this name.
    pub(super) image_name: String,
    /// Inputs that the varyings depend on.
    pub(super) inputs: Vec<UsedInput>,
}

impl PlainShader {
    /// `None` for a shader that is not a fragment shader with a single output and a `main`.
    pub(super) fn of(program: &Program, pass: &ProjectPass, text: &str) -> Option<PlainShader> {
        let taken: BTreeSet<String> = words(text)
            .into_iter()
            .map(|(_, w)| w.to_string())
            .collect();
        if program.stage != Stage::Fragment || !taken.contains("main") {
            return None;
        }
        let mut shader = PlainShader::default();
        let main = shader.rename("main", &taken);
        let mut body = String::new();
        if taken.contains("gl_FragCoord") {
            let place = unused("fragPlace", &taken);
            shader.globals.push_str(&format!("vec4 {place};\n"));
            body.push_str(&format!("    {place} = vec4(fragCoord, 0.5, 1.0);\n"));
            shader.names.push(("gl_FragCoord".to_string(), place));
        }
        for value in &pass.bound.varyings {
            let place = &value.place;
            body.push_str(&format!("    {place} = {};\n", value.value));
        }
        let names = |storage| own_variables(program, storage);
        for variable in names(Storage::Input) {
            shader.declare(program, variable);
        }
        if body.contains("port_") {
            shader.inputs.push(size());
            body = format!(
                "    vec2 port_place = fragCoord / port_size;\n    \
                 vec2 port_pos = 2.0 * port_place - 1.0;\n{body}"
            );
        }
        let outputs: Vec<&Variable> = names(Storage::Output).collect();
        let color = match outputs.as_slice() {
            [] => {
                let color = unused("pixel", &taken);
                shader.globals.push_str(&format!("vec4 {color};\n"));
                shader
                    .names
                    .push(("gl_FragColor".to_string(), color.clone()));
                color
            }
            [one] if program.type_name(one.ty) == "vec4" => {
                shader.declare(program, one);
                program.names.text(one.name).to_string()
            }
            _ => return None,
        };
        let image = match taken.contains("mainImage") {
            true => unused("mainImage", &taken),
            false => "mainImage".to_string(),
        };
        shader.image = format!(
            "void {image}(out vec4 fragColor, in vec2 fragCoord) {{\n{body}    {main}();\n    \
             fragColor = {color};\n}}\n"
        );
        shader.image_name = image;
        Some(shader)
    }

    fn rename(&mut self, old: &str, taken: &BTreeSet<String>) -> String {
        let new = unused(old, taken);
        self.names.push((old.to_string(), new.clone()));
        new
    }

    /// Declares a variable of the interface as a global variable.
    fn declare(&mut self, program: &Program, variable: &Variable) {
        let ty = program.type_name(variable.ty.element());
        let name = program.names.text(variable.name);
        let size = match variable.ty.array {
            0 => String::new(),
            size => format!("[{size}]"),
        };
        self.globals.push_str(&format!("{ty} {name}{size};\n"));
    }
}

/// The size of the image in pixels.
fn size() -> UsedInput {
    UsedInput {
        name: "port_size".to_string(),
        ty: "vec2".to_string(),
        value: UsedValue::Known(Feed::Resolution),
        span: Span::default(),
        is_live: true,
    }
}

/// The variables of the user in a storage class.
fn own_variables(program: &Program, storage: Storage) -> impl Iterator<Item = &Variable> {
    program.variables.iter().filter(move |variable| {
        let span = program.declared_at(variable);
        variable.storage == storage && span.is_some_and(|span| program.is_user(span))
    })
}

/// The lines with `#version`, the declarations of the interface, and default precisions.
pub(super) fn interface(text: &str) -> Vec<Range<usize>> {
    let mut lexer = Lexer::new(text, 0);
    let mut found = Vec::new();
    let (mut depth, mut first, mut is_interface) = (0_i32, None, false);
    // Start of the directive in the current line, and whether its word follows.
    let (mut directive, mut is_version) = (None, false);
    loop {
        let token = lexer.next_token();
        let (start, end) = (token.span.start as usize, token.span.end as usize);
        let word = text.get(start..end).unwrap_or("");
        match token.kind {
            RawKind::Newline | RawKind::End => {
                if let (Some(start), true) = (directive, is_version) {
                    found.push(start..token.span.start as usize);
                }
                (directive, is_version) = (None, false);
                if token.kind == RawKind::End {
                    return found;
                }
            }
            RawKind::Whitespace | RawKind::LineComment | RawKind::BlockComment => {}
            RawKind::Hash if first.is_none() => directive = Some(start),
            _ if directive.is_some() => is_version |= word == "version",
            _ => {
                depth += i32::from(word == "{") - i32::from(word == "}");
                let is_start = first.is_none() && depth == 0;
                match word {
                    ";" | "}" if depth == 0 => {
                        if let (Some(start), true, ";") = (first, is_interface, word) {
                            found.push(start..end);
                        }
                        (first, is_interface) = (None, false);
                    }
                    _ if is_start => {
                        is_interface = INTERFACE.contains(&word);
                        first = Some(start);
                    }
                    _ => {}
                }
            }
        }
    }
}

/// The words with which a declaration of the interface, or a precision for all, starts.
const INTERFACE: [&str; 9] = [
    "precision",
    "uniform",
    "varying",
    "in",
    "out",
    "layout",
    "flat",
    "smooth",
    "invariant",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_of_the_interface_are_found() {
        let text = "#version 300 es\nuniform float a, b;\nfloat f(in float x) { return x; }\n\
                    layout(location = 0) out vec4 c;\nstruct S { float x; };\nflat in int n;\n";
        let found: Vec<&str> = interface(text)
            .into_iter()
            .map(|r| text.get(r).unwrap())
            .collect();
        assert_eq!(
            found,
            [
                "#version 300 es",
                "uniform float a, b;",
                "layout(location = 0) out vec4 c;",
                "flat in int n;"
            ]
        );
    }
}
