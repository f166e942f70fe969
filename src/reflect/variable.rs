//! Variables that the program around a shader or its other stage sees.

use super::declared_type::ReflectedType;
use serde::Serialize;
use shaderlint_semantic::Program;
use shaderlint_semantic::interface::InterfaceVariable;
use shaderlint_text::Role;

/// A variable that the program around the shader or the other stage sees.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ReflectedVariable {
    /// Its name.
    pub name: String,
    /// Its type.
    #[serde(flatten)]
    pub ty: ReflectedType,
    /// Its precision, explicit or by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub precision: Option<&'static str>,
    /// Value of `layout(location = ...)`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub location: Option<i32>,
    /// Whether it is declared `flat`.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub flat: bool,
    /// Whether any code names it.
    pub used: bool,
    /// Whether the browser keeps it: code that runs names it.
    pub active: bool,
    /// Whether only another choice of macros declares it.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub conditional: bool,
    /// The file that declares it.
    pub file: String,
    /// Line of its name, from 1.
    pub line: u32,
    /// The comment after its declaration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub comment: Option<String>,
}

impl ReflectedVariable {
    /// Describes a declared variable.
    pub fn of(program: &Program, declared: &InterfaceVariable) -> ReflectedVariable {
        let token = program.token(declared.token);
        let (file, line, comment) = place(program, token.map_or(0, |token| token.span.start));
        ReflectedVariable {
            name: program.names.text(declared.name).to_string(),
            ty: ReflectedType::of(program, declared.ty),
            precision: declared.precision,
            location: declared.location,
            flat: declared.is_flat,
            used: declared.is_used,
            active: declared.is_active,
            conditional: false,
            file,
            line,
            comment,
        }
    }
}

/// The file and line of a position, and the comment at the end of the line.
pub fn place(program: &Program, at: u32) -> (String, u32, Option<String>) {
    let Some(file) = program.sources.file_at(at).filter(|f| f.role == Role::User) else {
        return (String::new(), 0, None);
    };
    let rest = file.text.get((at - file.base) as usize..).unwrap_or("");
    let rest = rest.lines().next().unwrap_or("");
    let comment = rest.split_once("//").map(|(_, text)| text.trim());
    let comment = comment.filter(|text| !text.is_empty()).map(str::to_string);
    let (path, line) = file.origin(file.position(at).line);
    (path.to_string(), line, comment)
}
