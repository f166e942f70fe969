//! Signature help.

use super::document::{Document, Spot};
use super::library::entry;
use super::symbol::{parameters, typed};
use shaderlint_project::Files;
use shaderlint_semantic::builtins::{Builtins, Overload};
use shaderlint_semantic::{Program, Type};
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};
use shaderlint_text::Span;

/// The signature of a function.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Signature {
    /// Text such as `float mix(float x, float y, float a)`.
    pub label: String,
    /// Byte ranges of the parameters in the label.
    pub parameters: Vec<Span>,
    /// Documentation in Markdown.
    pub text: String,
}

/// The signatures of a call.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SignatureHelp {
    /// The overloads, matching ones first.
    pub signatures: Vec<Signature>,
    /// Index of the current argument.
    pub argument: u32,
}

/// An incomplete call at an offset.
pub(super) struct OpenCall {
    /// Name of the function.
    pub name: String,
    /// Index of the argument at the offset.
    pub argument: u32,
}

/// Maximum length in bytes of the searched code before the position.
const MOST: usize = 4_000;

/// The signature help at an offset, also in code that is not compiled.
pub fn signature_help(
    document: &Document,
    offset: u32,
    files: &dyn Files,
) -> Option<SignatureHelp> {
    let spot = document.compiled_at(offset, files).spot(offset)?;
    let call = open_call(&spot)?;
    let program = spot.program();
    let mut signatures = of_function(program, &call.name);
    signatures.extend(of_builtin(program, &call.name));
    signatures.extend(of_struct(program, &call.name));
    let fits = |s: &Signature| s.parameters.len() > call.argument as usize;
    signatures.sort_by_key(|s| !fits(s));
    (!signatures.is_empty()).then_some(SignatureHelp {
        signatures,
        argument: call.argument,
    })
}

/// The incomplete call at a position.
pub(super) fn open_call(spot: &Spot) -> Option<OpenCall> {
    let code = spot.document.report.sources.code_at(spot.address)?;
    let end = (spot.address - code.base) as usize;
    let mut start = end.saturating_sub(MOST);
    while !code.text.is_char_boundary(start) {
        start += 1;
    }
    let before = code.text.get(start..end)?;
    // The code may start inside a comment or word, because brackets are counted from the end.
    let tokens = tokenize(before, 0);
    let is_blank = |t: &&RawToken| {
        !matches!(
            t.kind,
            RawKind::Whitespace | RawKind::Newline | RawKind::LineComment | RawKind::BlockComment
        )
    };
    let mut rest = tokens.iter().rev().filter(is_blank);
    let (mut depth, mut argument) = (0, 0);
    while let Some(token) = rest.next() {
        match token.kind {
            RawKind::OpenComment => return None,
            RawKind::Operator(TokenKind::RightParen | TokenKind::RightBracket) => depth += 1,
            RawKind::Operator(TokenKind::LeftBracket) if depth > 0 => depth -= 1,
            RawKind::Operator(TokenKind::LeftBracket) => argument = 0,
            RawKind::Operator(TokenKind::LeftParen) if depth > 0 => depth -= 1,
            RawKind::Operator(TokenKind::LeftParen) => {
                let name = rest.next().filter(|t| t.kind == RawKind::Word);
                match name {
                    Some(name) => {
                        let name = before.get(name.span.start as usize..name.span.end as usize)?;
                        return Some(OpenCall {
                            name: name.to_string(),
                            argument,
                        });
                    }
                    // A parenthesised expression in an argument.
                    None => argument = 0,
                }
            }
            RawKind::Operator(TokenKind::Comma) if depth == 0 => argument += 1,
            RawKind::Operator(
                TokenKind::Semicolon | TokenKind::LeftBrace | TokenKind::RightBrace,
            ) => return None,
            _ => {}
        }
    }
    None
}

/// Builds a signature from its parameters.
fn signature(head: &str, params: &[String], text: String) -> Signature {
    let mut label = format!("{head}(");
    let mut parameters = Vec::new();
    for (i, param) in params.iter().enumerate() {
        if i > 0 {
            label.push_str(", ");
        }
        let start = label.len() as u32;
        label.push_str(param);
        parameters.push(Span::new(start, label.len() as u32));
    }
    label.push(')');
    Signature {
        label,
        parameters,
        text,
    }
}

fn of_function(program: &Program, name: &str) -> Vec<Signature> {
    let all = program.functions.iter();
    let named = all.filter(|f| program.names.text(f.name) == name);
    let description = |name: &str| entry(name).map_or(String::new(), |e| e.text.clone());
    let each = named.map(|function| {
        let head = format!("{} {name}", program.type_name(function.returns));
        signature(&head, &parameters(program, function), description(name))
    });
    each.collect()
}

fn of_struct(program: &Program, name: &str) -> Option<Signature> {
    let mut all = program.structs.iter();
    let record = all.find(|s| s.name.is_some_and(|n| program.names.text(n) == name))?;
    let fields = record.fields.iter();
    let params = fields.map(|f| typed(program, f.ty, program.names.text(f.name)));
    let params: Vec<String> = params.collect();
    Some(signature(name, &params, String::new()))
}

/// The parameters of an overload of a built-in function.
fn builtin_parameters(overload: &Overload) -> Vec<String> {
    let count = overload.params().len();
    let heads = entry(overload.function.name()).map_or(&[][..], |e| e.heads.as_slice());
    let names = heads.iter().find(|head| head.len() == count);
    let params = overload.params().iter().enumerate();
    let param = params.map(|(i, ty)| {
        let name = names.and_then(|n| n.get(i)).copied().unwrap_or("");
        let out = if overload.writes(i) { "out " } else { "" };
        format!("{out}{} {name}", type_name(*ty))
            .trim_end()
            .to_string()
    });
    param.collect()
}

/// A built-in type as written in GLSL.
fn type_name(ty: Type) -> String {
    shaderlint_semantic::type_name(ty, |_| String::new())
}

/// An overload of a built-in function as a declaration.
pub(super) fn builtin_head(overload: &Overload) -> String {
    let head = format!(
        "{} {}",
        type_name(overload.returns),
        overload.function.name()
    );
    signature(&head, &builtin_parameters(overload), String::new()).label
}

/// The overloads of a built-in function: one for each number of parameters and each first type that
/// is not just a larger vector.
fn of_builtin(program: &Program, name: &str) -> Vec<Signature> {
    let builtins = Builtins::of(program.version, program.stage);
    let Some(id) = builtins.function(name) else {
        return Vec::new();
    };
    let text = entry(name).map_or(String::new(), |e| e.text.clone());
    let (_, overloads) = builtins.overloads_of(id);
    let each = overloads.iter().map(|overload| {
        let head = format!("{} {name}", type_name(overload.returns));
        signature(&head, &builtin_parameters(overload), text.clone())
    });
    each.collect()
}
