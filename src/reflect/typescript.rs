//! Declarations of TypeScript for shaders.

use super::block::ReflectedBlock;
use super::declared_type::{DeclaredMember, ReflectedType, signatures};
use super::reflection::Reflection;
use super::variable::ReflectedVariable;
use shaderlint_semantic::Scalar;
use std::collections::{BTreeSet, HashSet};
use std::fmt::Write;

/// Types and functions that all programs share.
const PROGRAM: &str = include_str!("program.ts");
/// What three.js needs besides.
const THREE: &str = include_str!("three.ts");
/// By type of GLSL: the classes of three.js for its values.
const THREE_VALUES: &str = include_str!("three.txt");
/// The longest array whose length is part of its type.
const MAX_TUPLE: u32 = 16;

/// Which types uniforms have.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum UniformTypes {
    /// `vec3` is a tuple of three numbers, as WebGL has it.
    #[default]
    Tuples,
    /// `vec3` is `{ value: Vector3 | Color }`, as a material of three.js has it.
    Three,
    /// Each shader has both.
    Both,
}

/// How declarations are written.
#[derive(Clone, Copy)]
pub struct TypeStyle<'a> {
    /// The types of uniforms.
    pub uniforms: UniformTypes,
    /// Whether three.js sets a uniform itself.
    pub is_given: &'a dyn Fn(&str) -> bool,
}

impl TypeStyle<'_> {
    fn has_three(&self) -> bool {
        self.uniforms != UniformTypes::Tuples
    }
}

/// The first lines of a generated file.
fn head(source: &str) -> String {
    format!("// Written by `shaderlint types`{source}: changes are lost.\n/* eslint-disable */\n")
}

/// The declaration file of a shader with this file name, so that importing the file has the type of its text.
pub fn declaration(file: &str, shader: &Reflection, style: &TypeStyle) -> String {
    let body = interface("Shader", shader, style);
    let mut text = head(&format!(" from {file}"));
    text.push_str(&three_import(&body));
    text.push('\n');
    text.push_str(&body);
    text.push_str(
        "\ndeclare const text: string & { readonly \"~shader\"?: Shader };\nexport default text;\n",
    );
    text
}

/// One module with the types of several shaders by their paths, and the functions that use them.
pub fn module<'a>(
    shaders: impl Iterator<Item = (&'a str, &'a Reflection)>,
    style: &TypeStyle,
) -> String {
    let mut index = String::from("/** The texts of all shaders by their paths. */\n");
    index.push_str("export interface Shaders {\n");
    let (mut all, mut names) = (String::new(), HashSet::new());
    for (path, shader) in shaders {
        let name = path.trim_start_matches(['.', '/']);
        let name = name.replace(|c: char| !c.is_alphanumeric(), "_");
        let mut name = format!("Shader_{name}");
        while !names.insert(name.clone()) {
            name.push('_');
        }
        let _ = writeln!(index, "  {path:?}: ShaderText<{name}>;");
        let _ = write!(all, "\n/** {path} */\n{}", interface(&name, shader, style));
    }
    index.push_str("}\n");
    let mut text = head("");
    text.push_str(&helper_imports(&all, style));
    let _ = write!(text, "\n{index}{all}\n{}", helper_code(style));
    text
}

/// The functions and types that use the declarations.
pub fn helpers(style: &TypeStyle) -> String {
    let mut text = head("");
    text.push_str(&helper_imports("", style));
    let _ = write!(text, "\n{}", helper_code(style));
    text
}

fn helper_code(style: &TypeStyle) -> String {
    match style.has_three() {
        true => format!("{PROGRAM}{THREE}"),
        false => PROGRAM.to_string(),
    }
}

fn helper_imports(body: &str, style: &TypeStyle) -> String {
    match style.has_three() {
        true => format!(
            "import {{ ShaderMaterial, type ShaderMaterialParameters }} from \"three\";\n{}",
            three_import(body)
        ),
        false => String::new(),
    }
}

/// The import of the types of three.js that a text names.
fn three_import(body: &str) -> String {
    let words = |text: &'static str| text.split([' ', '|']).filter(|w| *w != "null");
    let classes = three_values().flat_map(|(_, classes)| words(classes));
    let is_named = |name: &&str| {
        body.split(|c: char| !c.is_alphanumeric())
            .any(|w| w == *name)
    };
    let named: BTreeSet<&str> = classes
        .filter(|name| !name.is_empty())
        .filter(is_named)
        .collect();
    let named: Vec<&str> = named.into_iter().collect();
    match named.is_empty() {
        true => String::new(),
        false => format!("import type {{ {} }} from \"three\";\n", named.join(", ")),
    }
}

/// The interface with everything that a shader declares.
fn interface(name: &str, shader: &Reflection, style: &TypeStyle) -> String {
    let mut out = format!("export interface {name} {{\n");
    let stage = shader.stage.filter(|_| !shader.open).unwrap_or("none");
    let _ = writeln!(out, "  stage: \"{stage}\";");
    let version = shader.version;
    let version = version.map_or("100 | 300".to_string(), |v| v.to_string());
    let _ = writeln!(out, "  version: {version};");
    let fields = |list: &[ReflectedVariable], write: &dyn Fn(&ReflectedVariable) -> String| {
        list.iter().map(|v| entry(v, &write(v))).collect::<String>()
    };
    let values = fields(&shader.uniforms, &|v| tuple(&v.ty));
    group(&mut out, "uniforms", &values);
    if style.has_three() {
        let own = shader.uniforms.iter();
        let own: Vec<ReflectedVariable> = own
            .filter(|v| !(style.is_given)(&v.name))
            .cloned()
            .collect();
        let values = fields(&own, &|v| format!("{{ value: {} }}", three(&v.ty)));
        group(&mut out, "material", &values);
    }
    blocks(&mut out, &shader.blocks);
    let sized = |v: &ReflectedVariable| {
        let size = v.ty.numeric.map_or(0, |(_, columns, rows)| columns * rows);
        let location = v
            .location
            .map_or(String::new(), |at| format!("; location: {at}"));
        format!(
            "{{ type: \"{}\"; size: {size}{location} }}",
            v.ty.signature()
        )
    };
    group(&mut out, "attributes", &fields(&shader.attributes, &sized));
    let varyings = fields(&shader.varyings, &|v| format!("\"{}\"", v.ty.signature()));
    group(&mut out, "varyings", &varyings);
    group(&mut out, "outputs", &fields(&shader.outputs, &sized));
    let defines = shader.defines.iter().map(|define| {
        let default = define.default.as_ref().filter(|text| !text.is_empty());
        let comment = default.map_or(String::new(), |text| {
            format!("    /** {} if it is not set */\n", comment_text(text))
        });
        let ty = match define.has_value {
            true => "number | string | boolean",
            false => "\"\" | number | boolean",
        };
        format!("{comment}    {}?: {ty};\n", define.name)
    });
    group(&mut out, "defines", &defines.collect::<String>());
    shared(&mut out, shader);
    out.push_str("}\n");
    out
}

/// A property that is an object.
fn group(out: &mut String, name: &str, fields: &str) {
    let _ = match fields.is_empty() {
        true => writeln!(out, "  {name}: {{}};"),
        false => writeln!(out, "  {name}: {{\n{fields}  }};"),
    };
}

/// A property of a variable, after its type in GLSL.
fn entry(variable: &ReflectedVariable, ty: &str) -> String {
    let comment = variable.comment.as_deref().map(comment_text);
    let comment = comment.map_or(String::new(), |text| format!(": {text}"));
    let optional = if variable.conditional { "?" } else { "" };
    format!(
        "    /** `{}`{comment} */\n    {}{optional}: {ty};\n",
        variable.ty.signature(),
        variable.name
    )
}

/// A text that does not end a comment.
fn comment_text(text: &str) -> String {
    text.replace("*/", "* /")
}

fn blocks(out: &mut String, blocks: &[ReflectedBlock]) {
    let mut values = String::new();
    let mut layouts = String::new();
    for block in blocks {
        let members = block.declared.iter().map(|member| {
            let at = offset(block, &member.name).unwrap_or(0);
            let ty = member.ty.signature();
            format!(
                "/** `{ty}` at byte {at} */ {}: {}",
                member.name,
                tuple(&member.ty)
            )
        });
        let members = members.collect::<Vec<_>>().join("; ");
        let placed = block
            .members
            .iter()
            .map(|m| format!("{:?}: {}", m.name, m.offset));
        let placed = placed.collect::<Vec<_>>().join("; ");
        let size = block.size;
        let names = match block.array {
            None => vec![block.name.clone()],
            Some(count) => (0..count.min(MAX_TUPLE))
                .map(|at| format!("\"{}[{at}]\"", block.name))
                .collect(),
        };
        for name in names {
            let _ = writeln!(
                values,
                "    /** {size} bytes */\n    {name}: {{ {members} }};"
            );
            let _ = writeln!(
                layouts,
                "    {name}: {{ size: {size}; offsets: {{ {placed} }} }};"
            );
        }
    }
    group(out, "blocks", &values);
    group(out, "layouts", &layouts);
}

/// The first byte of a member, also of a struct or array.
fn offset(block: &ReflectedBlock, member: &str) -> Option<u32> {
    let prefix = format!("{}.", block.name);
    let is_part = |name: &str| {
        let own = name.strip_prefix(&prefix).unwrap_or(name);
        let after = own.strip_prefix(member);
        after.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    let first = block.members.iter().find(|placed| is_part(&placed.name));
    first.map(|placed| placed.offset)
}

/// What both stages of a program must declare alike (GLSL ES 3.00, sections 4.3.5 to 4.3.10).
fn shared(out: &mut String, shader: &Reflection) {
    let is_vertex = shader.stage == Some("vertex");
    out.push_str("  shared: {\n");
    let line = |out: &mut String, name: &str, fields: Vec<String>| {
        let _ = match fields.is_empty() {
            true => writeln!(out, "    {name}: {{}};"),
            false => writeln!(out, "    {name}: {{ {} }};", fields.join("; ")),
        };
    };
    let uniforms = shader.uniforms.iter().filter(|v| !v.conditional).map(|v| {
        // The browser compares precisions of what both stages use.
        let precision = match v.precision.filter(|_| v.used) {
            Some(precision) => format!("{precision:?}"),
            None => "any".to_string(),
        };
        format!("{}: [\"{}\", {precision}]", v.name, v.ty.signature())
    });
    line(out, "uniforms", uniforms.collect());
    let blocks = shader.blocks.iter().map(|block| {
        let instances = block
            .array
            .map_or(String::new(), |size| format!("[{size}]"));
        let members = signatures(&block.declared);
        format!(
            "{}: \"{members} {} bytes{instances}\"",
            block.name, block.size
        )
    });
    line(out, "blocks", blocks.collect());
    let varyings = shader.varyings.iter().filter(|v| is_vertex || v.used);
    let varyings = varyings.map(|v| match v.conditional {
        // Whoever defines the macros gets it.
        true => format!("{}: never", v.name),
        false => {
            let flat = if v.flat { "flat " } else { "" };
            format!("{}: \"{flat}{}\"", v.name, v.ty.signature())
        }
    });
    line(out, "varyings", varyings.collect());
    out.push_str("  };\n");
}

/// Repeats a type as often as an array has elements.
fn repeated(element: &str, array: Option<u32>) -> String {
    match array {
        None => element.to_string(),
        Some(size) if size <= MAX_TUPLE => {
            let all = vec![element; size as usize];
            format!("readonly [{}]", all.join(", "))
        }
        Some(_) if !element.chars().all(char::is_alphanumeric) => format!("readonly ({element})[]"),
        Some(_) => format!("readonly {element}[]"),
    }
}

/// The members of a struct, each with its type.
fn record(members: &[DeclaredMember], write: fn(&ReflectedType) -> String) -> String {
    let fields = members.iter();
    let fields = fields.map(|m| format!("{}: {}", m.name, write(&m.ty)));
    format!("{{ {} }}", fields.collect::<Vec<_>>().join("; "))
}

/// The type of a value as numbers, tuples and typed arrays.
fn tuple(ty: &ReflectedType) -> String {
    let Some((scalar, columns, rows)) = ty.numeric else {
        return match ty.members.is_empty() {
            // The number of a texture unit.
            true => repeated("number", ty.array),
            false => repeated(&record(&ty.members, tuple), ty.array),
        };
    };
    let word = match scalar {
        Scalar::Bool => "boolean",
        _ => "number",
    };
    let size = u32::from(columns) * u32::from(rows);
    let buffer = match scalar {
        Scalar::Float => " | Float32Array",
        Scalar::Int => " | Int32Array",
        Scalar::Uint => " | Uint32Array",
        Scalar::Bool => "",
    };
    let element = match size {
        1 => word.to_string(),
        _ => repeated(word, Some(size)),
    };
    match (ty.array, size) {
        (None, 1) => element,
        (array, _) => format!("{}{buffer}", repeated(&element, array)),
    }
}

/// The type of a value in a uniform of three.js.
fn three(ty: &ReflectedType) -> String {
    if !ty.members.is_empty() {
        return repeated(&record(&ty.members, three), ty.array);
    }
    match three_values().find(|(name, _)| *name == ty.name) {
        Some((_, classes)) => repeated(classes, ty.array),
        None => tuple(ty),
    }
}

/// Types of GLSL and the classes of three.js for their values.
fn three_values() -> impl Iterator<Item = (&'static str, &'static str)> {
    THREE_VALUES.lines().filter_map(|line| line.split_once(' '))
}
