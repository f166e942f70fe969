//! The module for three.js' WebGPURenderer: the WGSL of each pass as a function for `wgslFn`.
//!
//! three.js reads the first function of a text and copies what follows it, so the rest of the WGSL
//! module comes after that function. Uniforms are its parameters and are stored in a private
//! variable; textures have the names that the module gives to their nodes.

use super::Composed;
use super::naga::{FirstRow, HostInterface, Refused, TargetLanguage, TranslatedShader, translate};
use super::payload::{PassData, passes};
use serde::Serialize;
use shaderlint_project::Project;
use shaderlint_project::{InputKind, VaryingValue};
use shaderlint_semantic::{Pass, Stage};
use std::fmt::Write;

/// A pass for the module.
#[derive(Serialize)]
pub(super) struct WebGpuPass<'a> {
    #[serde(flatten)]
    data: PassData<'a>,
    code: String,
    /// The uniforms that the function expects, with their GLSL types; arrays have a length.
    parameters: Vec<WgslParameter>,
    /// The samplers that it reads, by name.
    samplers: Vec<String>,
    /// The uniform for the height of the image, if the shader does not know it otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    height: Option<String>,
}

#[derive(Serialize)]
struct WgslParameter {
    name: String,
    #[serde(rename = "type")]
    ty: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    count: Option<u32>,
}

/// Why there is no module.
pub(super) enum NoWebGpu {
    /// A pass, by name, cannot be translated.
    Refused(String, Refused),
    /// The project has what the module does not support.
    Unsupported(String),
    /// A pass does not compile.
    Errors,
}

/// The passes of the module: buffers and the image.
pub(super) fn webgpu_passes<'a>(
    project: &'a Project,
    composed: &Composed,
) -> Result<Vec<WebGpuPass<'a>>, NoWebGpu> {
    let mut made = Vec::new();
    let units = composed.units.iter().filter(|u| u.kind != Pass::Common);
    for (unit, data) in units.zip(passes(project, composed)) {
        let name = data.name.clone();
        match unit.kind {
            Pass::Sound => continue,
            Pass::Cubemap => return Err(unsupported(&name, "cube map passes")),
            _ if unit.stage == Stage::Vertex => return Err(unsupported(&name, "vertex shaders")),
            _ => {}
        }
        let has_partner = project.passes.get(unit.pass);
        if has_partner.is_some_and(|p| p.draw.partner.is_some()) {
            return Err(unsupported(&name, "vertex shaders"));
        }
        let shader = translate(project, composed, unit, TargetLanguage::Wgsl, FirstRow::Top);
        let shader = shader.map_err(|reason| NoWebGpu::Refused(name.clone(), reason))?;
        let shader = shader.ok_or(NoWebGpu::Errors)?;
        let bound = has_partner.map_or(&[][..], |p| &p.bound.varyings);
        made.push(pass(data, &shader, bound)?);
    }
    Ok(made)
}

/// The channels that are black until the page sets their texture, as a note.
pub fn channels_to_set(project: &Project) -> Option<String> {
    let passes = project.passes.iter();
    let channels: Vec<String> = passes
        .flat_map(|pass| {
            let inputs = pass.inputs.iter().filter(|i| i.kind != InputKind::Buffer);
            inputs.map(|input| format!("`{}.{}`", pass.slug(), input.channel))
        })
        .collect();
    let all = channels.join(", ");
    (!all.is_empty()).then(|| format!("channels are black until `setChannel` sets them: {all}"))
}

fn unsupported(pass: &str, what: &str) -> NoWebGpu {
    NoWebGpu::Unsupported(format!(
        "modules for WebGPURenderer do not support {what} (`{pass}`); use `--target three` instead"
    ))
}

fn pass<'a>(
    data: PassData<'a>,
    shader: &TranslatedShader,
    bound: &[VaryingValue],
) -> Result<WebGpuPass<'a>, NoWebGpu> {
    let text = String::from_utf8_lossy(&shader.text);
    let name = data.name.clone();
    let interface = &shader.interface;
    let module = WgslModule::read(&text).ok_or_else(|| unsupported(&name, "this shader"))?;
    let (mut parameters, mut stores) = parameters(&module, interface)
        .map_err(|what| unsupported(&name, &format!("uniforms like `{what}`")))?;
    let places = places(&module, interface, bound)
        .map_err(|what| unsupported(&name, &format!("varyings like `{what}`")))?;
    if !places.is_empty() {
        stores.push_str(&places);
        parameters.push(WgslParameter {
            name: "port_size".to_string(),
            ty: "vec2".to_string(),
            count: None,
        });
    }
    let own = data.own.as_ref().map_or(&[][..], |own| own.uniforms);
    let is_height = |p: &&WgslParameter| {
        p.name.starts_with("pictureHeight") && own.iter().all(|u| u.name != p.name)
    };
    let height = parameters.iter().find(is_height).map(|p| p.name.clone());
    let mut renamed = vec![("main".to_string(), "port_main".to_string())];
    let mut samplers = Vec::new();
    for (texture, names) in interface.textures.iter().zip(module.textures.chunks(2)) {
        let [(texture_name, ty), (sampler_name, _)] = names else {
            return Err(unsupported(&name, "this shader"));
        };
        if !module.uses(texture_name) {
            continue;
        }
        if ty != "texture_2d<f32>" {
            return Err(unsupported(&name, &format!("`{}`", texture.ty)));
        }
        let number = samplers.len();
        renamed.push((texture_name.clone(), format!("port_texture{number}")));
        renamed.push((
            sampler_name.clone(),
            format!("port_sampler{number}_sampler"),
        ));
        samplers.push(texture.name.clone());
    }
    Ok(WebGpuPass {
        data,
        code: module.function(&parameters, &stores, samplers.len(), &renamed),
        parameters,
        samplers,
        height,
    })
}

/// The statements that compute varyings from the position in the image.
fn places(
    module: &WgslModule,
    interface: &HostInterface,
    bound: &[VaryingValue],
) -> Result<String, String> {
    let mut text = String::new();
    for (location, name, ty) in &module.varyings {
        let port = interface.inputs.iter().find(|p| p.location == *location);
        let glsl = port.map_or(name.as_str(), |port| &port.name);
        let value = bound.iter().find(|v| v.place == glsl).map(|v| &v.value);
        let value = value.filter(|v| is_wgsl(v) && (ty == "f32" || ty.ends_with("<f32>")));
        let value = value.ok_or(glsl.to_string())?;
        let _ = writeln!(text, "    let {name}: {ty} = {value};");
    }
    if text.is_empty() {
        return Ok(text);
    }
    let y = match interface.first_row {
        Some(FirstRow::Bottom) => "position.y",
        _ => "given_port_size.y - position.y",
    };
    let place = format!(
        "    let port_size = given_port_size;\n    \
         let port_place = vec2f(position.x, {y}) / port_size;\n    \
         let port_pos = 2.0 * port_place - 1.0;\n"
    );
    Ok(place + &text)
}

/// Whether a GLSL expression means the same in WGSL: arithmetic with floats, vectors and the
/// position in the image.
fn is_wgsl(value: &str) -> bool {
    let known = [
        "port_place",
        "port_pos",
        "port_size",
        "vec2",
        "vec3",
        "vec4",
    ];
    let is_known = |word: &str| {
        let is_number = word.starts_with(|c: char| c.is_ascii_digit());
        is_number || known.contains(&word)
    };
    let is_plain = |c: char| c.is_ascii_alphanumeric() || " _+-*/(),.".contains(c);
    value.chars().all(is_plain) && words(value).all(|(word, _)| is_known(word))
}

/// The uniforms that a shader uses, and the statements that store them.
fn parameters(
    module: &WgslModule,
    interface: &HostInterface,
) -> Result<(Vec<WgslParameter>, String), String> {
    let mut found = Vec::new();
    let mut stores = String::new();
    // Members of structs are listed one by one, and cannot be assigned so.
    let nested = interface.buffers.iter().flat_map(|b| &b.members);
    if let Some(nested) = nested.clone().find(|m| m.name.contains(['.', '['])) {
        return Err(nested.name.clone());
    }
    let members = interface.buffers.iter().flat_map(|b| &b.members);
    for (member, (field, ty)) in members.zip(&module.members) {
        let used = format!("uniforms.{field}");
        if !module.code.contains(&used) && !module.entry.contains(&used) {
            continue;
        }
        let (element, count) = match ty.strip_prefix("array<").and_then(|t| t.strip_suffix('>')) {
            Some(array) => {
                let (element, count) = array.rsplit_once(", ").ok_or(member.name.clone())?;
                (
                    element,
                    Some(count.parse().map_err(|_| member.name.clone())?),
                )
            }
            None => (ty.as_str(), None),
        };
        if element.starts_with("mat") || element.starts_with("array") {
            return Err(member.name.clone());
        }
        let is_padded = member.ty == "float" && element.starts_with("vec4");
        let at = if is_padded { ".x" } else { "" };
        match count {
            None => {
                let _ = writeln!(stores, "    uniforms.{field} = given_{};", member.name);
            }
            Some(count) => {
                for i in 0..count {
                    let name = &member.name;
                    let _ = writeln!(stores, "    uniforms.{field}[{i}]{at} = given_{name}_{i};");
                }
            }
        }
        found.push(WgslParameter {
            name: member.name.clone(),
            ty: member.ty.clone(),
            count,
        });
    }
    Ok((found, stores))
}

/// A WGSL module as naga writes it, in parts.
#[derive(Default)]
struct WgslModule {
    /// Everything but the bindings, the struct of uniforms and the entry point.
    code: String,
    /// The names and types of the members of the uniforms.
    members: Vec<(String, String)>,
    /// The names and types of textures and samplers, in order.
    textures: Vec<(String, String)>,
    /// The statements of the entry point.
    entry: String,
    /// The varyings that it expects: location, name and type.
    varyings: Vec<(u32, String, String)>,
    /// Whether its result is a vector, and it expects only the position and varyings.
    is_plain: bool,
}

impl WgslModule {
    fn read(text: &str) -> Option<WgslModule> {
        let mut module = WgslModule::default();
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            if line.starts_with("//") || line.starts_with("diagnostic(") {
                continue;
            }
            if line.starts_with("@group") {
                let declared = lines.next()?.trim_end_matches(';');
                if let Some(named) = declared.strip_prefix("var<uniform> ") {
                    let _ = writeln!(module.code, "var<private> {named};");
                } else {
                    let (name, ty) = declared.strip_prefix("var ")?.split_once(": ")?;
                    module.textures.push((name.to_string(), ty.to_string()));
                }
                continue;
            }
            if line.starts_with("@fragment") {
                let head = lines.next()?;
                module.is_plain = head.contains("-> @location(0) vec4<f32>");
                let (_, expected) = head.split_once('(')?;
                let (expected, _) = expected.rsplit_once(") ->")?;
                for parameter in expected.split(", ").filter(|p| !p.is_empty()) {
                    if parameter == "@builtin(position) position: vec4<f32>" {
                        continue;
                    }
                    let (location, named) =
                        parameter.strip_prefix("@location(")?.split_once(") ")?;
                    let (name, ty) = named.split_once(": ")?;
                    let found = (location.parse().ok()?, name.to_string(), ty.to_string());
                    module.varyings.push(found);
                }
                let body = lines.by_ref().take_while(|line| *line != "}");
                module.entry = body.map(|line| format!("{line}\n")).collect();
                continue;
            }
            if line.starts_with("struct Uniforms {") {
                let _ = writeln!(module.code, "{line}");
                for member in lines.by_ref().take_while(|line| *line != "}") {
                    let _ = writeln!(module.code, "{member}");
                    let (name, ty) = member.trim().trim_end_matches(',').split_once(": ")?;
                    module.members.push((name.to_string(), ty.to_string()));
                }
                module.code.push_str("}\n");
                continue;
            }
            let _ = writeln!(module.code, "{line}");
        }
        module.is_plain.then_some(module)
    }

    /// Whether a name occurs outside its declaration.
    fn uses(&self, name: &str) -> bool {
        let mut all = [&self.code, &self.entry].into_iter();
        all.any(|text| words(text).any(|(word, _)| word == name))
    }

    /// The function for `wgslFn`, and all that it uses.
    fn function(
        &self,
        parameters: &[WgslParameter],
        stores: &str,
        textures: usize,
        renamed: &[(String, String)],
    ) -> String {
        let mut head = "position: vec4f".to_string();
        for parameter in parameters {
            let ty = wgsl_type(&parameter.ty);
            match parameter.count {
                None => {
                    let _ = write!(head, ", given_{}: {ty}", parameter.name);
                }
                Some(count) => {
                    for i in 0..count {
                        let _ = write!(head, ", given_{}_{i}: {ty}", parameter.name);
                    }
                }
            }
        }
        for i in 0..textures {
            let _ = write!(head, ", port_t{i}: texture_2d<f32>, port_s{i}: sampler");
        }
        let names = self.own_names(renamed);
        let texts = [stores, &self.entry, &self.code];
        let [stores, entry, code] = texts.map(|text| rename(text, &names));
        format!("fn port_draw({head}) -> vec4f {{\n{stores}{entry}}}\n{code}")
    }

    /// New names for what the module declares, so that none is a name of three.js.
    fn own_names(&self, renamed: &[(String, String)]) -> Vec<(String, String)> {
        let mut names = renamed.to_vec();
        for line in self.code.lines() {
            let rest = ["fn ", "struct ", "const ", "var<private> ", "override "]
                .iter()
                .find_map(|word| line.strip_prefix(word));
            let end = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
            let name = rest.and_then(|rest| rest.split(end).next()).unwrap_or("");
            if !name.is_empty() && names.iter().all(|(old, _)| old != name) {
                names.push((name.to_string(), format!("port_{name}")));
            }
        }
        names
    }
}

/// The WGSL type of a uniform.
fn wgsl_type(glsl: &str) -> String {
    let scalar = |word: &str| match word {
        "float" => Some("f32"),
        "int" => Some("i32"),
        "uint" | "bool" => Some("u32"),
        _ => None,
    };
    if let Some(scalar) = scalar(glsl) {
        return scalar.to_string();
    }
    let (prefix, lanes) = glsl.split_once("vec").unwrap_or(("", "4"));
    let suffix = match prefix {
        "i" => "i",
        "u" | "b" => "u",
        _ => "f",
    };
    format!("vec{lanes}{suffix}")
}

/// Words of a text with their offsets, except members after a dot.
fn words(text: &str) -> impl Iterator<Item = (&str, usize)> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut from = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = text.get(from..)?;
            let start = from + rest.find(is_word)?;
            let word = text.get(start..)?;
            let end = start + word.find(|c| !is_word(c)).unwrap_or(word.len());
            from = end;
            let is_member = text.get(..start)?.ends_with('.');
            if !is_member {
                return Some((text.get(start..end)?, start));
            }
        }
    })
}

fn rename(text: &str, names: &[(String, String)]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut from = 0;
    let mut structs = Vec::new();
    let mut open = None;
    for (at, _) in text.match_indices(['{', '}']) {
        match text.get(at..at + 1) {
            Some("{") if open.is_none() => open = Some(at),
            Some("{") => {}
            _ => {
                let line = open.and_then(|at: usize| text.get(..at)?.lines().last());
                if let (Some(start), true) = (open, line.is_some_and(|l| l.starts_with("struct ")))
                {
                    structs.push(start..at);
                }
                open = None;
            }
        }
    }
    for (word, at) in words(text) {
        let Some((_, new)) = names.iter().find(|(old, _)| old == word) else {
            continue;
        };
        let is_declared_member = text
            .get(at + word.len()..)
            .is_some_and(|t| t.starts_with(": "))
            && structs.iter().any(|range| range.contains(&at));
        if is_declared_member {
            continue;
        }
        out.push_str(text.get(from..at).unwrap_or(""));
        out.push_str(new);
        from = at + word.len();
    }
    out.push_str(text.get(from..).unwrap_or(""));
    out
}
