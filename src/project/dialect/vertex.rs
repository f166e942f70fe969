//! The vertex shader of a pass: one triangle that covers the image, and the values of the varyings.

use super::with_usual;
use shaderlint_host::{Preset, VaryingRow};
use shaderlint_semantic::{Program, Scalar, Storage, Type, Variable};
use shaderlint_syntax::Version;

/// A vertex shader and the values of its varyings.
#[derive(Default)]
pub(super) struct Vertex {
    pub(super) code: String,
    pub(super) varyings: Vec<VaryingValue>,
    /// Names of unknown varyings.
    pub(super) guessed: Vec<String>,
}

/// Names of varyings that mean the position in the image, from 0 to 1.
pub const PLACES: [&str; 9] = [
    "vUv",
    "vUV",
    "v_uv",
    "uv",
    "vTexCoord",
    "v_texCoord",
    "v_texcoord",
    "texCoord",
    "texcoord",
];

/// The value of a varying or of one of its members.
#[derive(Clone, PartialEq, Debug)]
pub struct VaryingValue {
    /// The assigned GLSL expression: `vUv`, `surface.normal`, `weights[2]`.
    pub place: String,
    /// The GLSL type, a scalar, vector or matrix.
    pub ty: Type,
    /// The value, in the form of [`VaryingRow::value`].
    pub value: String,
}

/// The vertex shader for a fragment shader.
pub(super) fn vertex(program: &Program, host: &Preset) -> Vertex {
    let is_input = |v: &&Variable| v.storage == Storage::Input && v.token.is_some();
    let inputs: Vec<&Variable> = program.variables.iter().filter(is_input).collect();
    let mut guessed = Vec::new();
    let is_new = program.version == Version::Es300;
    let (head, input, output) = match is_new {
        true => ("#version 300 es\n", "layout(location = 0) in", "out"),
        false => ("", "attribute", "varying"),
    };
    let mut declared = structs(program, &inputs);
    let mut varyings = Vec::new();
    for variable in &inputs {
        let name = program.names.text(variable.name);
        let flat = match variable.ty.scalar_kind() {
            Some(kind) if kind.is_integer() => "flat ",
            _ => "",
        };
        let ty = program.type_name(variable.ty.element());
        let size = match variable.ty.array {
            0 => String::new(),
            size => format!("[{size}]"),
        };
        declared.push_str(&format!("{flat}{output} {ty} {name}{size};\n"));
        let mut writer = VertexWriter {
            program,
            host,
            guessed: &mut guessed,
            varyings: &mut varyings,
        };
        writer.write(name, name, variable.ty);
    }
    let set: String = varyings
        .iter()
        .map(|v| format!("    {} = {};\n", v.place, v.value))
        .collect();
    let code = format!(
        "{head}precision highp float;\nprecision highp int;\n{input} vec2 port_pos;\n{size}{declared}\
         void main() {{\n    vec2 port_place = 0.5 + 0.5 * port_pos;\n{set}    \
         gl_Position = vec4(port_pos, 0.0, 1.0);\n}}\n",
        size = match set.contains("port_size") {
            true => "uniform vec2 port_size;\n",
            false => "",
        }
    );
    Vertex {
        code,
        varyings,
        guessed,
    }
}

/// The structs that the inputs use.
fn structs(program: &Program, inputs: &[&Variable]) -> String {
    let mut text = String::new();
    for found in inputs.iter().filter_map(|v| program.struct_of(v.ty)) {
        let Some(name) = found.name.map(|n| program.names.text(n)) else {
            continue;
        };
        let head = format!("struct {name} {{");
        if text.contains(&head) {
            continue;
        }
        let fields = found.fields.iter().map(|f| {
            let (ty, name) = (program.type_name(f.ty), program.names.text(f.name));
            format!(" {ty} {name};")
        });
        text.push_str(&format!("{head}{} }};\n", fields.collect::<String>()));
    }
    text
}

struct VertexWriter<'a> {
    program: &'a Program,
    host: &'a Preset,
    guessed: &'a mut Vec<String>,
    varyings: &'a mut Vec<VaryingValue>,
}

impl VertexWriter<'_> {
    /// Assigns a varying or a member of one. `name` is its name in the rows.
    fn write(&mut self, place: &str, name: &str, ty: Type) {
        if ty.array > 0 {
            for i in 0..ty.array.min(64) {
                self.write(&format!("{place}[{i}]"), name, ty.element());
            }
            return;
        }
        if let Some(record) = self.program.struct_of(ty) {
            for field in &record.fields {
                let own = self.program.names.text(field.name);
                self.write(&format!("{place}.{own}"), own, field.ty);
            }
            return;
        }
        let written = self.program.type_name(ty);
        let is_it = |r: &&VaryingRow| r.name == name && r.ty == written;
        let mut rows = with_usual(self.host).flat_map(|h| &h.meanings.varyings);
        let known = rows.find(is_it);
        let value = match known {
            Some(row) => row.value.clone(),
            None => {
                if ty != Type::vector(Scalar::Float, 2) {
                    self.guessed.push(name.to_string());
                }
                by_type(name, &written).to_string()
            }
        };
        self.varyings.push(VaryingValue {
            place: place.to_string(),
            ty,
            value,
        });
    }
}

/// The value of an unknown varying, based on its name and type; the position in the image by
/// default.
fn by_type(name: &str, ty: &str) -> &'static str {
    let name = name.to_ascii_lowercase();
    let is_color = name.contains("color") || name.contains("colour");
    match ty {
        "vec3" if name.contains("normal") => "vec3(0.0, 0.0, 1.0)",
        "vec3" if is_color => "vec3(port_place, 1.0)",
        "vec4" if is_color => "vec4(port_place, 1.0, 1.0)",
        "float" => "port_place.x",
        "vec2" => "port_place",
        "vec3" => "vec3(port_pos, 0.0)",
        "vec4" => "vec4(port_pos, 0.0, 1.0)",
        "int" => "0",
        "uint" => "0u",
        "ivec2" => "ivec2(0)",
        "ivec3" => "ivec3(0)",
        "ivec4" => "ivec4(0)",
        "uvec2" => "uvec2(0u)",
        "uvec3" => "uvec3(0u)",
        "uvec4" => "uvec4(0u)",
        "mat2" => "mat2(1.0)",
        "mat3" => "mat3(1.0)",
        _ => "mat4(1.0)",
    }
}
