//! SHADERed: XML projects with shader passes in separate files.
//!
//! Source: the files that SHADERed's ShaderToy import writes (dfranx/PluginShadertoy), and
//! `Names.cpp` and `SystemVariableManager.cpp` of dfranx/SHADERed. A pass runs a vertex and a pixel
//! shader over its items; `ScreenQuadNDC` covers the image. It draws into the named render texture
//! or into the window. `<variable>` defines the value of a uniform: a system value, or numbers. An
//! object is bound to a slot of a pass, which is the index of the sampler in the pixel shader.

use super::complete::completions_of;
use super::vscode::{joined, quoted};
use super::{Clues, Completion, HostCode, Plan, PlannedPass, Sign, read_buffer, sampled};
use crate::{ControlKind, Input, InputKind, OutputId, PassDraw, UniformControl};
use roxmltree::{Document, Node};
use shaderlint_semantic::Pass;
use shaderlint_text::path::slashed;
use std::sync::Arc;

pub(super) static CODE: HostCode = HostCode {
    host: "shadered",
    signs,
    plan: Some(plan),
    declare: None,
};

/// Prefix of the names that uniforms with a system value get.
const SYSTEM: &str = "port_sys_";

fn signs(clues: &Clues) -> Vec<Sign> {
    let text = clues.text.trim_start_matches('\u{feff}').trim_start();
    match text.starts_with('<') && text.contains("<pipeline") {
        true => vec![Sign::new("`<pipeline>`", u8::MAX)],
        false => Vec::new(),
    }
}

fn plan(clues: &Clues) -> Plan {
    let mut plan = Plan {
        is_description: true,
        ..Plan::default()
    };
    let text = clues.text.trim_start_matches('\u{feff}').trim_start();
    let document = match Document::parse(text) {
        Ok(document) => document,
        Err(error) => {
            plan.notes.push(format!("cannot parse the XML: {error}"));
            return plan;
        }
    };
    let project = document.root_element();
    let mut maker = ShaderedReader {
        clues,
        project,
        plan,
    };
    let passes = child(project, "pipeline")
        .into_iter()
        .flat_map(|p| children(p, "pass"));
    for pass in passes {
        maker.pass(pass);
    }
    finish(&mut maker.plan);
    maker.plan
}

/// Makes the last pass that draws into the window the Image; without one, the last buffer is shown.
fn finish(plan: &mut Plan) {
    let is_window = |p: &PlannedPass| p.kind == Pass::Image;
    let windows = plan.passes.iter().filter(|p| is_window(p)).count();
    if windows > 1 {
        let note = "several passes draw into the window; only the last one is shown";
        plan.notes.push(note.to_string());
    }
    let last = plan.passes.iter().rposition(is_window);
    let mut index = 0;
    plan.passes.retain(|p| {
        index += 1;
        !is_window(p) || Some(index - 1) == last
    });
    if last.is_none()
        && let Some(name) = plan.passes.last().map(|p| p.name.clone())
    {
        plan.passes.push(PlannedPass::copy_of(&name));
    }
    let floats = plan.passes.iter().map(|p| PassDraw {
        is_float: p.kind == Pass::Buffer,
        ..PassDraw::default()
    });
    plan.draws = floats.collect();
}

pub(super) fn child<'d>(node: Node<'d, 'd>, name: &str) -> Option<Node<'d, 'd>> {
    node.children().find(|n| n.has_tag_name(name))
}

pub(super) fn children<'d>(
    node: Node<'d, 'd>,
    name: &'static str,
) -> impl Iterator<Item = Node<'d, 'd>> {
    node.children().filter(move |n| n.has_tag_name(name))
}

struct ShaderedReader<'c, 't, 'd> {
    clues: &'c Clues<'t>,
    project: Node<'d, 'd>,
    plan: Plan,
}

const MAX_DEPTH: usize = 16;

impl<'d> ShaderedReader<'_, '_, 'd> {
    fn note(&mut self, note: String) {
        if !self.plan.notes.contains(&note) {
            self.plan.notes.push(note);
        }
    }

    fn pass(&mut self, pass: Node<'d, 'd>) {
        let name = pass.attribute("name").unwrap_or("");
        let kind = pass.attribute("type").unwrap_or("shader");
        if pass.attribute("active") == Some("false") {
            return;
        }
        if kind != "shader" {
            return self.note(format!("pass `{name}` is not drawn: its type is `{kind}`"));
        }
        if !self.covers_image(pass, name) {
            return self.note(format!(
                "pass `{name}` is not drawn: it has no full-screen quad"
            ));
        }
        let shader = children(pass, "shader").find(|s| s.attribute("type") == Some("ps"));
        // Version 1 has elements where later versions have attributes.
        let path = shader.and_then(|s| s.attribute("path").or_else(|| child(s, "path")?.text()));
        let path = slashed(path.unwrap_or("").trim());
        let path = path.as_str();
        let is_foreign = [".hlsl", ".rs", ".slang", ".lua"]
            .iter()
            .any(|e| path.ends_with(e));
        if is_foreign {
            return self.note(format!("pass `{name}` is not drawn: `{path}` is not GLSL"));
        }
        let Some(code) = self.load(&joined("", path), 0) else {
            return;
        };
        let inner = Clues::of(&code);
        let variables = self.variables(pass);
        let candidates = completions_of(&inner)
            .into_iter()
            .map(|c| after(c, &variables));
        let target = child(pass, "rendertexture").and_then(|t| t.attribute("name"));
        let candidates = candidates.collect();
        let mut planned = match target.filter(|t| !matches!(*t, "" | "Window")) {
            Some(target) => PlannedPass::buffer(target, candidates),
            None => PlannedPass {
                kind: Pass::Image,
                name: name.to_string(),
                output: OutputId(OutputId::IMAGE.to_string()),
                candidates,
                inputs: Vec::new(),
                is_of_text: false,
                pieces: Vec::new(),
            },
        };
        let samplers: Vec<&str> = inner
            .uniforms
            .iter()
            .filter(|u| u.ty.starts_with("sampler"))
            .map(|u| u.name.as_str())
            .collect();
        planned.inputs = self.inputs(name, &samplers);
        self.plan.passes.push(planned);
    }

    /// Whether a pass has a full-screen quad; other items are reported.
    fn covers_image(&mut self, pass: Node<'d, 'd>, name: &str) -> bool {
        let items = child(pass, "items")
            .into_iter()
            .flat_map(|i| children(i, "item"));
        let mut covers = false;
        for item in items {
            let kind = child(item, "type").and_then(|t| t.text()).unwrap_or("");
            let is_geometry = item.attribute("type") == Some("geometry");
            match kind.trim() {
                "ScreenQuadNDC" | "ScreenQuad" | "Rectangle" if is_geometry => covers = true,
                other => {
                    let what = item.attribute("type").unwrap_or("item");
                    self.note(format!("`{other}` ({what}) of pass `{name}` is not drawn"));
                }
            }
        }
        covers
    }

    /// The text of a file with its includes. Files that have not been read yet are requested.
    fn load(&mut self, path: &str, depth: usize) -> Option<String> {
        let text = match self.clues.siblings.get(path) {
            Some(Some(text)) => text.clone(),
            Some(None) => {
                self.note(format!("`{path}` was not found"));
                return None;
            }
            None => {
                self.plan.requested.push(path.to_string());
                return None;
            }
        };
        let mut code = String::with_capacity(text.len());
        for line in text.split_inclusive('\n') {
            let file = line
                .trim_start()
                .strip_prefix('#')
                .and_then(|l| l.trim_start().strip_prefix("include"))
                .and_then(|rest| {
                    let angled = rest.split_once('<').and_then(|(_, r)| r.split_once('>'));
                    angled.map(|(file, _)| file).or_else(|| quoted(rest))
                });
            match file {
                Some(file) if depth < MAX_DEPTH => {
                    code.push_str(&format!("//{line}"));
                    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
                    let direct = joined(folder, file);
                    let is_missing = self
                        .clues
                        .siblings
                        .get(&direct)
                        .is_some_and(Option::is_none);
                    let file = if is_missing { joined("", file) } else { direct };
                    code.push_str(&self.load(&file, depth + 1).unwrap_or_default());
                    code.push('\n');
                }
                _ => code.push_str(line),
            }
        }
        Some(code)
    }

    /// Macros that rename uniforms with system values; variables with numbers become controls.
    fn variables(&mut self, pass: Node<'d, 'd>) -> String {
        let mut macros = String::new();
        let holders = children(pass, "shader").chain([pass]);
        let all = holders
            .flat_map(|h| children(h, "variables"))
            .flat_map(|v| children(v, "variable"));
        for variable in all {
            let name = variable.attribute("name").unwrap_or("");
            let system = variable.attribute("system").filter(|s| *s != "None");
            if let Some(system) = system {
                macros.push_str(&format!("#define {name} {SYSTEM}{system}\n"));
                continue;
            }
            let control = control(name, variable);
            let is_new =
                |c: &UniformControl| !self.plan.controls.iter().any(|own| own.name == c.name);
            if let Some(control) = control.filter(is_new) {
                self.plan.controls.push(control);
            }
        }
        macros
    }

    /// The inputs of the samplers of a pass, by the slots that objects are bound to.
    fn inputs(&mut self, pass: &str, samplers: &[&str]) -> Vec<Input> {
        let mut inputs = Vec::new();
        let objects = child(self.project, "objects");
        for object in objects.into_iter().flat_map(|o| children(o, "object")) {
            let kind = object.attribute("type").unwrap_or("");
            let bound = children(object, "bind").filter(|b| b.attribute("name") == Some(pass));
            for bind in bound {
                let slot: Option<usize> = bind.attribute("slot").and_then(|s| s.parse().ok());
                let Some(sampler) = slot.and_then(|s| samplers.get(s)) else {
                    continue;
                };
                let path = object.attribute("path").unwrap_or("");
                let file = |kind| Input {
                    src: joined("", path),
                    ..sampled(sampler, kind, ("linear", "repeat"))
                };
                match kind {
                    "rendertexture" => {
                        let name = object.attribute("name").unwrap_or("");
                        inputs.push(read_buffer(sampler, name));
                    }
                    "texture" => inputs.push(file(InputKind::Texture)),
                    "cubemap" => inputs.push(file(InputKind::Cubemap)),
                    "texture3d" => inputs.push(file(InputKind::Volume)),
                    "audio" => inputs.push(file(InputKind::Music)),
                    other => self.note(format!(
                        "`{sampler}` is empty: `{other}` inputs are not supported"
                    )),
                }
            }
        }
        inputs
    }
}

/// A candidate with macros before it, but after its `#version`.
pub(super) fn after(completion: Completion, macros: &str) -> Completion {
    if macros.is_empty() {
        return completion;
    }
    let mut before = completion.before.to_string();
    if before.is_empty() {
        let version = completion
            .code
            .lines()
            .find(|l| l.trim_start().starts_with("#version"));
        before = version.map_or(String::new(), |v| format!("{}\n", v.trim()));
        let bare = Completion::after(before + macros, &completion.code);
        return Completion {
            note: completion.note,
            ..bare
        };
    }
    Completion {
        before: Arc::from(before + macros),
        ..completion
    }
}

/// The control of a variable with numbers.
fn control(name: &str, variable: Node) -> Option<UniformControl> {
    let ty = variable.attribute("type").unwrap_or("float");
    let lanes = match ty.chars().last().and_then(|c| c.to_digit(10)) {
        Some(lanes @ 2..=4) if !ty.contains('x') => lanes as usize,
        Some(_) => return None,
        None => 1,
    };
    let values = variable.descendants().filter(|n| n.has_tag_name("value"));
    let values = values.filter_map(|v| v.text()?.trim().parse::<f64>().ok());
    let kind = match (ty.trim_end_matches(|c: char| c.is_ascii_digit()), lanes) {
        ("bool", 1) => ControlKind::Bool,
        ("int", 1) => ControlKind::Int,
        ("float", 1) => ControlKind::Float,
        _ => ControlKind::Vector,
    };
    let value: Vec<f64> = values.chain([0.0; 4]).take(lanes).collect();
    let control = UniformControl::even(name, kind, lanes, (0.0, 0.0, 1.0));
    let ends = |end: fn(f64) -> f64| match control.min.is_empty() {
        true => Vec::new(),
        false => value.iter().map(|v| end(*v)).collect(),
    };
    Some(UniformControl {
        min: ends(|v| (2.0 * v).min(0.0)),
        max: ends(|v| (2.0 * v).max(1.0)),
        value,
        ..control
    })
}
