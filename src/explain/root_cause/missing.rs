//! Names that are declared nowhere: functions and constants that everybody knows, and uniforms.
//!
//! The declaration is proved by a check: the error disappears and none appears in what is inserted. The
//! rest of the shader is checked with it, so that the types of these names are known.

use super::candidate::same;
use super::edited::EditedUnit;
use crate::library::{self, LibraryDefinition};
use crate::single_pass::analyze_single_pass;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix, error};
use shaderlint_semantic::{Program, Type, Unit};
use shaderlint_syntax::ast::{DeclKind, Expr, ExprId, ExprKind, Item};
use shaderlint_syntax::{Search, TypeWord};
use shaderlint_text::{CompiledText, Edit, FileId, Span};
use std::collections::BTreeMap;

/// Types of a uniform, most frequent first.
const UNIFORM_TYPES: &str = "\
    float vec2 vec3 vec4 int sampler2D samplerCube mat4 mat3 mat2 bool";
/// Maximum number of names that are declared in one shader.
const MAX_NAMES: usize = 12;
/// Maximum number of unknown names in a shader for which their uses are asked: one with more lacks a file.
const MAX_UNKNOWN: usize = 6;
/// Cost of a candidate in tokens, beyond those of the shader.
const CANDIDATE_TOKENS: usize = 1_000;

/// Declarations that a shader lacks.
pub(super) struct InsertedNames {
    /// Their errors, with the declarations as fixes.
    pub reported: Vec<Diagnostic>,
    /// The edits that insert all.
    pub edits: Vec<Edit>,
}

/// A way to declare a name.
struct NameInsertion {
    title: String,
    is_function: bool,
    /// The texts to insert, in order.
    parts: Vec<String>,
}

/// The texts inserted so far, by place.
#[derive(Clone, Default)]
struct Inserted(BTreeMap<u32, Vec<String>>);

impl Inserted {
    fn add(&mut self, at: u32, parts: &[String]) {
        let texts = self.0.entry(at).or_default();
        for part in parts {
            if !texts.contains(part) {
                texts.push(part.clone());
            }
        }
    }

    /// The edits; a text that is needed at several places is inserted at the first.
    fn edits(&self) -> Vec<Edit> {
        let mut seen: Vec<&String> = Vec::new();
        let mut edits = Vec::new();
        for (at, parts) in &self.0 {
            let new: Vec<&String> = parts.iter().filter(|part| !seen.contains(part)).collect();
            let text: String = new.iter().map(|part| part.as_str()).collect();
            edits.push(Edit::insert(*at, text));
            seen.extend(new);
        }
        edits
    }
}

/// How much is known about a name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Knowledge {
    /// What it means.
    Meaning,
    /// Only the type that its uses need.
    Uses,
}

/// Declares the names in `errors` that are declared nowhere, as far as this is known of them.
pub(super) fn declare(
    unit: &Unit,
    program: &Program,
    errors: &[Diagnostic],
    known: Knowledge,
    search: &mut Search,
) -> InsertedNames {
    let mut inserted = Inserted::default();
    let mut reported: Vec<Diagnostic> = Vec::new();
    let is_missing = |d: &&Diagnostic| {
        let is_later = d.is(error::NEEDS_WEBGL2) && known == Knowledge::Meaning;
        (d.is(error::UNDECLARED_NAME) || is_later) && d.macros.is_empty()
    };
    let undeclared = errors.iter().filter(is_missing);
    let unknown = undeclared.clone().filter(|d| d.fix.is_none()).count();
    let undeclared = undeclared.filter(|_| known == Knowledge::Meaning || unknown <= MAX_UNKNOWN);
    let size = program.size() + CANDIDATE_TOKENS;
    let name = |d: &Diagnostic| program.sources.text(d.span);
    // Arguments come after the name of the function that they are for.
    for d in undeclared.rev().take(MAX_NAMES) {
        if known == Knowledge::Uses && reported.iter().any(|other| name(other) == name(d)) {
            continue;
        }
        let all = match known {
            Knowledge::Meaning => declarations(program, d),
            Knowledge::Uses => placeholders(program, d),
        };
        let Some(first) = all.first() else { continue };
        let Some(at) = place(program, d.span, first.is_function) else {
            continue;
        };
        let with = |declaration: &NameInsertion| {
            let mut with = inserted.clone();
            with.add(at, &declaration.parts);
            with
        };
        // No declaration can do more than mend the errors of its name.
        let others = errors.iter().filter(|e| name(e) != name(d));
        let is_open = |e: &&Diagnostic| !reported.iter().any(|other| name(other) == name(e));
        let enough = others.filter(is_open).count();
        let best = search.fewest(
            (errors.len() + 1, enough),
            size,
            all,
            |search, declaration, _| {
                let copy = EditedUnit::new(unit, &with(declaration).edits())?;
                let after = analyze_single_pass(&copy.unit(unit), search).diagnostics;
                let after: Vec<Diagnostic> = after.into_iter().map(|d| copy.back(d)).collect();
                let fails = after.iter().any(|a| same(a, d) || a.span == Span::at(at));
                let reveals = after.len() + reported.len() >= errors.len();
                let is_unproved = known == Knowledge::Uses && reveals;
                (!fails && !is_unproved).then_some(after.len())
            },
        );
        if let Some((declaration, _)) = best {
            inserted = with(&declaration);
            let edit = Edit::insert(at, declaration.parts.concat());
            let fix = Fix::suggestion(declaration.title, vec![edit]);
            reported.push(d.clone().fix(fix));
        }
    }
    InsertedNames {
        reported,
        edits: inserted.edits(),
    }
}

/// The ways to declare the name of an error, most likely first.
fn declarations(program: &Program, d: &Diagnostic) -> Vec<NameInsertion> {
    let name = program.sources.text(d.span);
    // A name that is declared elsewhere is labelled there.
    if program.names.get(name).is_none() || !d.labels.is_empty() {
        return Vec::new();
    }
    let is_near = d.fix.as_ref().is_some_and(|fix| {
        let mut edits = fix.edits.iter();
        fix.applicability == Applicability::Safe
            || edits.any(|edit| edit.text.eq_ignore_ascii_case(name))
    });
    let calls = calls(program, name);
    if let Some((_, args)) = calls.iter().find(|(start, _)| *start == d.span.start) {
        let known = if is_near {
            Vec::new()
        } else {
            library::functions(name)
        };
        let accepts = |known: &&LibraryDefinition, args: &[Type]| {
            let types = known.params.iter().map(|param| type_of(param));
            known.params.len() == args.len()
                && types
                    .zip(args)
                    .all(|(ty, arg)| arg.is_error() || ty == Some(*arg))
        };
        let is_known = |(_, args): &(u32, Vec<Type>)| !args.iter().any(|ty| ty.is_error());
        let others = calls.iter().filter(|call| is_known(call));
        let others = others.filter_map(|(_, args)| known.iter().find(|d| accepts(d, args)));
        let others: Vec<&LibraryDefinition> = others.collect();
        let with_others =
            |first| function(program, [first].into_iter().chain(others.clone()), name);
        return known
            .iter()
            .filter(|d| accepts(d, args))
            .map(with_others)
            .collect();
    }
    match library::constant(name) {
        Some(known) if !is_near => constants(&known, name),
        None if d.fix.is_none() && is_uniform(name) => uniforms(name),
        _ => Vec::new(),
    }
}

/// Overloads of a function, with the functions that they call and the shader does not have.
fn function<'d>(
    program: &Program,
    overloads: impl Iterator<Item = &'d LibraryDefinition>,
    name: &str,
) -> NameInsertion {
    let mut parts: Vec<String> = Vec::new();
    let mut add = |text: String| {
        let part = format!("{text}\n\n");
        if !parts.contains(&part) {
            parts.push(part);
        }
    };
    let is_own = |called: &LibraryDefinition| {
        let mut functions = program.functions.iter();
        functions.any(|f| program.names.text(f.name) == called.name)
    };
    for known in overloads {
        let called = known.called();
        let lacking = called.iter().filter(|called| !is_own(called));
        lacking.for_each(|called| add(called.text.to_string()));
        add(known.named(name));
    }
    NameInsertion {
        title: format!("add a definition of `{name}`"),
        is_function: true,
        parts,
    }
}

/// A constant with its own type; one that counts as a number as well.
fn constants(known: &LibraryDefinition, name: &str) -> Vec<NameInsertion> {
    let text = known.named(name);
    let number = text.replacen("int", "float", 1).replacen(';', ".0;", 1);
    let texts = if known.ty == "int" {
        vec![text, number]
    } else {
        vec![text]
    };
    texts.into_iter().map(line).collect()
}

fn uniforms(name: &str) -> Vec<NameInsertion> {
    let texts = UNIFORM_TYPES
        .split(' ')
        .map(|ty| format!("uniform {ty} {name};"));
    texts.map(line).collect()
}

/// A parameter of the picture: a uniform, or a constant where the host sets no other uniforms than its own.
/// Names of other functions and names of one or two letters are rather local variables.
fn placeholders(program: &Program, d: &Diagnostic) -> Vec<NameInsertion> {
    let name = program.sources.text(d.span);
    let is_constant = || name.chars().all(|c| !c.is_ascii_lowercase());
    let declared = program.names.get(name);
    let mut variables = program.variables.iter();
    match name.len() {
        0..3 => Vec::new(),
        _ if d.fix.is_some() || !d.labels.is_empty() => Vec::new(),
        _ if !calls(program, name).is_empty() => Vec::new(),
        _ if variables.any(|v| Some(v.name) == declared) => Vec::new(),
        _ if !program.dialect.host().declares_uniforms() && !is_constant() => uniforms(name),
        _ => constants_of_one(name),
    }
}

fn constants_of_one(name: &str) -> Vec<NameInsertion> {
    let constant = |ty: &str| {
        let one = match ty {
            "float" => "1.0".to_string(),
            "int" => "1".to_string(),
            "bool" => "true".to_string(),
            ty => format!("{ty}(1.0)"),
        };
        let is_value = type_of(ty)?.numeric().is_some();
        is_value.then(|| line(format!("const {ty} {name} = {one};")))
    };
    UNIFORM_TYPES.split(' ').filter_map(constant).collect()
}

fn line(text: String) -> NameInsertion {
    NameInsertion {
        title: format!("declare it: `{text}`"),
        is_function: false,
        parts: vec![text + "\n"],
    }
}

/// Whether a name is written as uniforms are: `uTime`, `u_time`, `iTime`.
fn is_uniform(name: &str) -> bool {
    let rest = name.strip_prefix(['u', 'i']);
    rest.is_some_and(|rest| {
        rest.strip_prefix('_').is_some_and(|rest| !rest.is_empty())
            || rest.starts_with(|c: char| c.is_ascii_uppercase())
    })
}

fn type_of(word: &str) -> Option<Type> {
    TypeWord::named(word).map(Type::of_word)
}

/// The calls of a function: where each starts, and the types of its arguments.
fn calls(program: &Program, name: &str) -> Vec<(u32, Vec<Type>)> {
    let name = program.names.get(name);
    let ty = |id: &ExprId| {
        program
            .exprs
            .get(id.0 as usize)
            .map_or(Type::ERROR, |info| info.ty)
    };
    let call = |expr: &Expr| match expr.kind {
        ExprKind::Call(called, args) if Some(called) == name => {
            let types = program.tree.args(args).iter().map(ty).collect();
            Some((program.span(expr.extent).start, types))
        }
        _ => None,
    };
    program.tree.exprs.iter().filter_map(call).collect()
}

/// Where declarations are inserted, above the comment of another one: functions before the one that calls
/// them, because they may call functions above it, the rest before the first one of the file.
fn place(program: &Program, name: Span, is_function: bool) -> Option<u32> {
    let (sources, tree) = (&program.sources, &program.tree);
    let file: FileId = sources.file_id_at(name.start)?;
    let extents = tree.items.iter().filter_map(|item| match *item {
        Item::Function(id) => Some(tree.function(id)?.extent),
        Item::Decl(id) => {
            let decl = tree.decl(id)?;
            let is_open = matches!(decl.kind, DeclKind::Precision { .. } | DeclKind::Error);
            (!is_open).then_some(decl.extent)
        }
    });
    let mut starts = extents.filter_map(|extent| {
        let token = program.tokens.tokens.get(extent.first as usize)?;
        let start = token.span.start;
        let is_meant = !is_function || program.span(extent).contains(name);
        let is_here = sources.file_id_at(start) == Some(file);
        (token.is_direct() && is_meant && is_here).then_some(start)
    });
    Some(above_comment(sources.code(file)?, starts.next()?))
}

/// The start of the line of a declaration at `at`, or of the comments directly above it.
fn above_comment(code: CompiledText<'_>, at: u32) -> u32 {
    let before = code.text.get(..(at - code.base) as usize).unwrap_or("");
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    let (above, indent) = before.split_at(line);
    if !indent.trim().is_empty() {
        return at;
    }
    let is_comment = |line: &&str| line.trim_start().starts_with("//");
    let comments = above.split_inclusive('\n').rev().take_while(is_comment);
    let start = line - comments.map(str::len).sum::<usize>();
    code.base + start as u32
}
