//! KodeLife: projects (`.klproj`) with passes, whose shaders exist for several graphics APIs.
//!
//! Source: `docs/KODELIFE_FILE_FORMAT.md` of dreness/kodelife-generator, and KodeLife's manual
//! (parameters). A project is XML: parameters of the document, of passes and of stages say which
//! value a uniform has; each stage has a source for each API. The last pass is shown.

use super::{
    Clues, Completion, HostCode, Plan, PlannedPass, Sign, read_buffer, sampled, usual_plan,
};
use crate::{ControlKind, Input, InputKind, PassDraw, UniformControl};
use roxmltree::{Document, Node};
use shaderlint_host::{Preset, preset};
use std::sync::Arc;

const HOST: &str = "kodelife";

pub(super) static CODE: HostCode = HostCode {
    host: HOST,
    signs,
    plan: Some(plan),
    declare: None,
};

/// Prefix of the names that uniforms get whose value a parameter defines.
const PARAMETER: &str = "port_kl_";

/// Types of parameters whose values the preset lists.
const VALUES: &[&str] = &[
    "CLOCK",
    "FRAME_RESOLUTION",
    "FRAME_NUMBER",
    "INPUT_MOUSE_SIMPLE",
    "DATE",
    "AUDIO_SAMPLE_RATE",
    "AUDIO_SPECTRUM_SPLIT",
    "AUDIO_SPECTRUM_FULL",
    "FRAME_PREV_FRAME",
];

/// Sources in GLSL, in the order in which they are tried after that of the project's API.
const PROFILES: &[&str] = &["ES3-300", "ES3", "GL3", "GL2"];

fn project(text: &str) -> Option<&str> {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    (text.starts_with('<') && text.contains("<klxml")).then_some(text)
}

fn signs(clues: &Clues) -> Vec<Sign> {
    match project(clues.text) {
        Some(_) => vec![Sign::new("`<klxml>`", u8::MAX)],
        None => Vec::new(),
    }
}

fn plan(clues: &Clues) -> Plan {
    let Some(host) = preset(HOST) else {
        return Plan::default();
    };
    let Some(text) = project(clues.text) else {
        return usual_plan(host, clues);
    };
    let mut plan = Plan {
        is_description: true,
        ..Plan::default()
    };
    match Document::parse(text) {
        Ok(document) => read(host, document.root_element(), &mut plan),
        Err(error) => plan.notes.push(format!("cannot parse the XML: {error}")),
    }
    plan
}

/// Reads the passes of a project.
fn read(host: &'static Preset, root: Node, plan: &mut Plan) {
    let document = child(root, "document");
    let passes = document.and_then(|d| child(d, "passes"));
    let passes = passes.into_iter().flat_map(|p| children(p, "pass"));
    let mut drawn: Vec<KodeLifePass> = Vec::new();
    for (index, pass) in passes.enumerate() {
        let properties = child(pass, "properties");
        let name = properties.and_then(|p| value(p, "label"));
        let name = name.map_or(format!("pass {index}"), str::to_string);
        let is_on = properties.and_then(|p| value(p, "enabled")) != Some("0");
        let kind = pass.attribute("type").unwrap_or("RENDER");
        if is_on && kind != "RENDER" {
            let note = format!("pass `{name}` is not drawn: its type is `{kind}`");
            plan.notes.push(note);
        } else if is_on && let Some((stage, code)) = source(root, pass, &name, plan) {
            drawn.push(KodeLifePass {
                pass,
                stage,
                name,
                code,
            });
        }
    }
    let count = drawn.len();
    for (index, own) in drawn.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|i| drawn.get(i));
        let buffer = |index: usize| format!("pass{index}");
        let mut reader = ParameterReader {
            previous: before.map(|_| buffer(index - 1)),
            macros: String::new(),
            inputs: Vec::new(),
            plan: &mut *plan,
        };
        for holder in document.into_iter().chain([own.pass, own.stage]) {
            reader.parameters(holder);
        }
        let (macros, inputs) = (reader.macros, reader.inputs);
        let usual = usual_plan(host, &Clues::of(own.code)).passes;
        let candidates = usual.into_iter().flat_map(|p| p.candidates);
        let candidates = candidates.map(|c| after(c, &macros)).collect();
        let planned = match index + 1 == count {
            true => PlannedPass::image(candidates),
            false => PlannedPass::buffer(&buffer(index), candidates),
        };
        plan.passes.push(PlannedPass {
            name: own.name.clone(),
            inputs,
            is_of_text: false,
            ..planned
        });
        plan.draws.push(PassDraw {
            is_float: index + 1 < count,
            ..PassDraw::default()
        });
    }
}

/// A pass that is drawn.
struct KodeLifePass<'d> {
    pass: Node<'d, 'd>,
    /// Its fragment stage; the other stages are not run.
    stage: Node<'d, 'd>,
    name: String,
    /// The text of its fragment shader.
    code: &'d str,
}

/// The fragment stage of a pass, and its GLSL.
fn source<'d>(
    root: Node<'d, 'd>,
    pass: Node<'d, 'd>,
    name: &str,
    plan: &mut Plan,
) -> Option<(Node<'d, 'd>, &'d str)> {
    let stages = child(pass, "stages")?;
    let stage = children(stages, "stage").find(|s| s.attribute("type") == Some("FRAGMENT"));
    let shader = stage.and_then(|s| child(s, "shader"));
    let sources = || shader.into_iter().flat_map(|s| children(s, "source"));
    let of = |profile: &str| {
        let source = sources().find(|s| s.attribute("profile") == Some(profile));
        source?.text().filter(|text| !text.trim().is_empty())
    };
    let api = root.attribute("a").unwrap_or("");
    // Only the source of the API in use is edited; the others keep their template.
    if let Some(code) = of(api).filter(|_| PROFILES.contains(&api)) {
        return Some((stage?, code));
    }
    let found = PROFILES.iter().find_map(|p| Some((*p, of(p)?)));
    match found {
        Some((profile, _)) => plan.notes.push(format!(
            "pass `{name}`: the project is for `{api}`; its source for `{profile}` is used, which may be older"
        )),
        None => plan.notes.push(format!("pass `{name}` is not drawn: it has no GLSL")),
    }
    Some((stage?, found?.1))
}

/// The text of an element.
fn value<'d>(node: Node<'d, 'd>, name: &str) -> Option<&'d str> {
    child(node, name)?.text().map(str::trim)
}

/// The numbers of an element: one, or those of its `x`, `y`, `z` and `w`.
fn numbers(node: Node) -> Vec<f64> {
    let parse = |n: Node| n.text().and_then(|t| t.trim().parse::<f64>().ok());
    let lanes = node.children().filter(|n| n.is_element());
    let lanes: Vec<f64> = lanes.filter_map(parse).collect();
    match lanes.is_empty() {
        true => parse(node).into_iter().collect(),
        false => lanes,
    }
}

/// Reads the parameters that are valid for a pass.
struct ParameterReader<'p> {
    /// The buffer of the pass before.
    previous: Option<String>,
    /// Macros that rename uniforms.
    macros: String,
    inputs: Vec<Input>,
    plan: &'p mut Plan,
}

impl ParameterReader<'_> {
    fn parameters(&mut self, holder: Node) {
        let all = child(holder, "params").into_iter();
        for parameter in all.flat_map(|p| children(p, "param")) {
            let kind = parameter.attribute("type").unwrap_or("");
            let name = value(parameter, "variableName").unwrap_or("");
            if is_name(name) {
                self.parameter(kind, name, parameter);
            }
        }
    }

    fn parameter(&mut self, kind: &str, name: &str, parameter: Node) {
        match kind {
            _ if VALUES.contains(&kind) => {
                let line = format!("#define {name} {PARAMETER}{kind}\n");
                if !self.macros.contains(&line) {
                    self.macros.push_str(&line);
                }
            }
            "FRAME_PREV_PASS" | "FRAME_PREV_RENDERPASS" => match &self.previous {
                Some(buffer) => self.inputs.push(read_buffer(name, buffer)),
                None => self.note(format!("`{name}` is empty: no pass is before the first")),
            },
            "CONSTANT_TEXTURE_2D" => {
                let how = ("linear", "repeat");
                self.inputs.push(sampled(name, InputKind::Texture, how));
            }
            "CONSTANT_FLOAT1" => self.control(name, 1, parameter),
            "CONSTANT_FLOAT2" => self.control(name, 2, parameter),
            "CONSTANT_FLOAT3" => self.control(name, 3, parameter),
            "CONSTANT_FLOAT4" => self.control(name, 4, parameter),
            // Matrices are those of a vertex shader that changes nothing.
            _ if kind.starts_with("TRANSFORM_") => {}
            _ => self.note(format!(
                "`{name}` has no value: parameters of type `{kind}` are not supported"
            )),
        }
    }

    fn control(&mut self, name: &str, lanes: usize, parameter: Node) {
        let kind = match lanes {
            1 => ControlKind::Float,
            _ => ControlKind::Vector,
        };
        let given = child(parameter, "value").map(numbers).unwrap_or_default();
        let given: Vec<f64> = given.into_iter().chain([0.0; 4]).take(lanes).collect();
        let range = child(parameter, "range");
        let lanes_of = |range: Node| -> Vec<(f64, f64)> {
            let each = range.children().filter(|n| n.is_element());
            let each = each.map(|n| match numbers(n)[..] {
                [least, most] => (least, most),
                _ => (0.0, 1.0),
            });
            each.chain([(0.0, 1.0); 4]).take(lanes).collect()
        };
        let ends = range.map_or(vec![(0.0, 1.0); lanes], lanes_of);
        let is_new = !self.plan.controls.iter().any(|own| own.name == name);
        if is_new {
            self.plan.controls.push(UniformControl {
                min: ends.iter().map(|(least, _)| *least).collect(),
                max: ends.iter().map(|(_, most)| *most).collect(),
                value: given,
                ..UniformControl::even(name, kind, lanes, (0.0, 0.0, 1.0))
            });
        }
    }

    fn note(&mut self, note: String) {
        if !self.plan.notes.contains(&note) {
            self.plan.notes.push(note);
        }
    }
}

/// Whether a text can be the name of a uniform.
fn is_name(text: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    text.starts_with(is_letter) && text.chars().all(|c| is_letter(c) || c.is_ascii_digit())
}

fn child<'d>(node: Node<'d, 'd>, name: &str) -> Option<Node<'d, 'd>> {
    node.children().find(|n| n.has_tag_name(name))
}

fn children<'d>(node: Node<'d, 'd>, name: &'static str) -> impl Iterator<Item = Node<'d, 'd>> {
    node.children().filter(move |n| n.has_tag_name(name))
}

/// A candidate with macros before it, but after its `#version`.
fn after(completion: Completion, macros: &str) -> Completion {
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
