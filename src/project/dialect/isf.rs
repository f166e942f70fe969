//! ISF, the Interactive Shader Format: a comment with a JSON object, then a fragment shader.
//!
//! Source: the specification (README.md of mrRay/ISF_Spec), and `src/ISFParser.js` and
//! `src/ISFRenderer.js` of interactive-shader-format 2.9.0. The declarations of the host are in the
//! preset `isf`; the object adds a uniform for each of INPUTS, each PASSES target and each image of
//! IMPORTED. The text is compiled once for each of PASSES, with PASSINDEX as its number; later
//! passes can read the output of a pass. A file of the same name with the extension `.vs` is the
//! vertex shader, which the host runs for the four corners of the image. ISF 1 lists
//! PERSISTENT_BUFFERS separately. Images are linear and clamped, months are counted from 1, and a
//! `float` without a range ranges from 0 to 1.

use super::clues::VersionAsked;
use super::complete::{defaults, modern};
use super::{Clues, Completion, Credit, HostCode, Plan, PlannedPass, Sign, read_buffer, sampled};
use crate::{
    ControlChoice, ControlKind, Input, InputKind, PassDraw, SignalForm, SizeTerm, UniformControl,
};
use serde_json::{Map, Value};
use shaderlint_host::{OWN, preset};
use shaderlint_semantic::Stage;
use shaderlint_syntax::Version;
use std::sync::Arc;

pub(super) static CODE: HostCode = HostCode {
    host: "isf",
    signs,
    plan: Some(plan),
    declare: Some(declare),
};

fn signs(clues: &Clues) -> Vec<Sign> {
    let mut found = Vec::new();
    if head(clues.text).is_some_and(|text| KEYS.iter().any(|key| text.contains(key))) {
        let what = "a JSON header with `INPUTS`";
        // The declarations of an invalid header are unknown.
        found.push(match head(clues.text).is_some_and(|h| object(h).is_ok()) {
            true => Sign::form(what, 3 * OWN),
            false => Sign::new(what, 3 * OWN),
        });
    }
    for word in [
        "vv_FragNormCoord",
        "IMG_NORM_PIXEL",
        "IMG_THIS_PIXEL",
        VERTEX_INIT,
    ] {
        if clues.is_free(word) {
            found.push(Sign::new(format!("`{word}`"), OWN));
        }
    }
    found
}

/// Header keys that no other format has.
const KEYS: [&str; 3] = ["\"INPUTS\"", "\"ISFVSN\"", "\"PASSES\""];

/// The JSON text of a header: the first comment with an object, after at most other comments.
pub(super) fn head(text: &str) -> Option<&str> {
    let mut text = text.trim_start_matches('\u{feff}').trim_start();
    loop {
        if text.starts_with("//") {
            text = text.split_once('\n')?.1.trim_start();
            continue;
        }
        let (inside, rest) = text.strip_prefix("/*")?.split_once("*/")?;
        let inside = inside.trim_matches(|c: char| c.is_whitespace() || c == '*');
        if inside.starts_with('{') {
            return Some(inside);
        }
        text = rest.trim_start();
    }
}

/// Parses a header. Trailing commas, comments, names without quotes and line breaks in strings are
/// accepted, as in JSON5.
pub(super) fn object(head: &str) -> Result<Map<String, Value>, String> {
    let strict = serde_json::from_str(head);
    let read = strict.or_else(|error| serde_json::from_str(&relaxed(head)).map_err(|_| error));
    read.map_err(|e| format!("cannot parse the JSON header: {e}"))
}

/// Removes comments and trailing commas, quotes names, and replaces control characters in strings by
/// spaces.
fn relaxed(text: &str) -> String {
    let text = without_comments(text);
    let mut out = String::with_capacity(text.len());
    let mut in_string = false;
    let mut is_escaped = false;
    let mut in_name = false;
    for (at, c) in text.char_indices() {
        let rest = text.get(at + c.len_utf8()..).unwrap_or("");
        let next = rest.trim_start();
        let is_word = c.is_ascii_alphanumeric() || matches!(c, '_' | '$');
        if !in_string && in_name && !is_word {
            out.push('"');
            in_name = false;
        }
        let end = rest.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let starts_word = out.trim_end().ends_with(['{', ',']) && !c.is_ascii_digit();
        if !in_string && !in_name && is_word && starts_word && end.trim_start().starts_with(':') {
            out.push('"');
            in_name = true;
        }
        match c {
            ',' if !in_string && next.starts_with([']', '}']) => continue,
            c if in_string && c.is_control() => out.push(' '),
            c => out.push(c),
        }
        in_string ^= c == '"' && !is_escaped;
        is_escaped = in_string && c == '\\' && !is_escaped;
    }
    out
}

/// Replaces line comments outside of strings by nothing.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut in_string = false;
        let mut is_escaped = false;
        let end = line.char_indices().find(|(at, c)| {
            let is_comment = !in_string && line.get(*at..).is_some_and(|l| l.starts_with("//"));
            in_string ^= *c == '"' && !is_escaped;
            is_escaped = in_string && *c == '\\' && !is_escaped;
            is_comment
        });
        match end {
            Some((at, _)) => {
                out.push_str(line.get(..at).unwrap_or(""));
                out.push('\n');
            }
            None => out.push_str(line),
        }
    }
    out
}

/// The content of a header.
#[derive(Default)]
struct Head {
    /// The declarations that it adds.
    declared: String,
    /// The inputs of its samplers.
    inputs: Vec<Input>,
    controls: Vec<UniformControl>,
    passes: Vec<IsfTarget>,
    notes: Vec<String>,
    credit: Credit,
}

/// A pass of a header.
#[derive(Default)]
struct IsfTarget {
    name: Option<String>,
    draw: PassDraw,
}

/// The size of the target of a pass, from the values of `WIDTH` and `HEIGHT`; `None` for the size of
/// the output.
fn target_size(
    [width, height]: [Option<&Value>; 2],
    notes: &mut Vec<String>,
) -> Option<[SizeTerm; 2]> {
    let sizes = [(width, "$WIDTH"), (height, "$HEIGHT")].map(|(value, usual)| {
        let text = match value {
            Some(Value::String(text)) => text.clone(),
            Some(Value::Number(number)) => number.to_string(),
            _ => usual.to_string(),
        };
        let usual = SizeTerm::Name(usual.to_string());
        match SizeTerm::read(&text) {
            Ok(term) => (term == usual, term),
            Err(rest) => {
                notes.push(format!(
                    "cannot parse the pass size `{text}` at `{rest}`; using the size of the output"
                ));
                (true, usual)
            }
        }
    });
    let is_usual = sizes.iter().all(|(is_usual, _)| *is_usual);
    (!is_usual).then(|| sizes.map(|(_, term)| term))
}

/// The function that only vertex shaders call.
const VERTEX_INIT: &str = "isf_vertShaderInit";

fn plan(clues: &Clues) -> Plan {
    let head = match head(clues.text).map(object) {
        Some(Ok(object)) => Head::of(&object),
        Some(Err(note)) => Head {
            notes: vec![note],
            ..Head::default()
        },
        None => Head::default(),
    };
    let mut plan = Plan {
        notes: head.notes.clone(),
        credit: Some(head.credit.clone()),
        ..Plan::default()
    };
    if clues.has_word(VERTEX_INIT) {
        let note = "this is the vertex shader of a pair; pass the `.fs` file next to it instead";
        plan.notes.push(note.to_string());
    }
    let vertex = sibling_vertex(clues, &mut plan);
    let usual = [IsfTarget::default()];
    let targets = match head.passes.as_slice() {
        [] => &usual,
        passes => passes,
    };
    for (index, target) in targets.iter().enumerate() {
        let is_last = index + 1 == targets.len();
        let candidates = vec![completion(clues, &head, index)];
        let mut pass = match &target.name {
            Some(name) => PlannedPass::buffer(name, candidates),
            // Later passes draw over it.
            None if !is_last => continue,
            None => PlannedPass::image(candidates),
        };
        pass.inputs.clone_from(&head.inputs);
        plan.passes.push(pass);
        plan.draws.push(PassDraw {
            partner: vertex.map(|text| vertex_shader(text, &head, index)),
            ..target.draw.clone()
        });
        if let Some(name) = target.name.as_deref().filter(|_| is_last) {
            plan.passes.push(PlannedPass::copy_of(name));
            plan.draws.push(PassDraw::default());
        }
    }
    plan.controls = head.controls;
    plan
}

/// The companion vertex shader, if the text has varyings that only that can set.
fn sibling_vertex<'c>(clues: &Clues<'c>, plan: &mut Plan) -> Option<&'c str> {
    let given = preset("isf").map_or(&[][..], |p| &p.meanings.varyings);
    let is_own = |name: &str| !given.iter().any(|row| row.name == name);
    if clues.name.is_empty() || !clues.inputs.iter().any(|d| is_own(&d.name)) {
        return None;
    }
    let path = format!("{}.vs", clues.name);
    match clues.siblings.get(&path) {
        Some(vertex) => vertex.as_ref().map(|vertex| &*vertex.text),
        None => {
            plan.requested.push(path);
            None
        }
    }
}

/// The text after the declarations of the host.
fn completion(clues: &Clues, head: &Head, index: usize) -> Completion {
    let mut before = modern(clues);
    if !clues.has_word("varying") {
        before.push_str("#define varying in\n");
    }
    before.push_str(&declarations(head, index));
    before.push_str(LOOKUPS);
    for input in &head.inputs {
        let name = input.uniform.as_deref().unwrap_or("");
        for (word, value) in [
            ("imgSize", format!("IMG_SIZE({name})")),
            ("imgRect", "vec4(0.0, 0.0, 1.0, 1.0)".to_string()),
            ("flip", "false".to_string()),
            ("normTexCoord", "isf_FragNormCoord".to_string()),
            ("texCoord", "isf_FragCoord".to_string()),
        ] {
            let word = format!("_{name}_{word}");
            if clues.has_word(&word) {
                before.push_str(&format!("#define {word} {value}\n"));
            }
        }
    }
    let completion = Completion::after(before, clues.text);
    match clues.asked {
        VersionAsked::Desktop(number) => completion.with_note(format!(
            "`#version {number}` is desktop GLSL; compiled as GLSL ES 3.00"
        )),
        _ => completion,
    }
}

/// The declarations of the host and of the header.
fn declarations(head: &Head, index: usize) -> String {
    format!(
        "{}#define PASSINDEX {index}\n{}",
        host(Stage::Fragment),
        head.declared
    )
}

/// The declarations of the preset.
fn host(stage: Stage) -> String {
    let text = preset("isf").map_or(String::new(), |p| p.declarations(stage == Stage::Vertex));
    let lines = text.lines().filter(|line| !line.is_empty());
    lines.fold(String::new(), |text, line| text + line + "\n")
}

/// Definitions of functions that the preset only declares.
const LOOKUPS: &str = "\
vec2 IMG_SIZE(sampler2D image) { return vec2(textureSize(image, 0)); }\n\
vec4 IMG_NORM_PIXEL(sampler2D image, vec2 place) { return texture(image, place); }\n\
vec4 IMG_PIXEL(sampler2D image, vec2 pixel) { return texture(image, pixel / IMG_SIZE(image)); }\n\
vec4 IMG_THIS_PIXEL(sampler2D image) { return texture(image, isf_FragNormCoord); }\n\
vec4 IMG_THIS_NORM_PIXEL(sampler2D image) { return texture(image, isf_FragNormCoord); }\n\
vec4 VVSAMPLER_2DBYNORM(sampler2D image, vec4 rect, vec2 size, bool flip, vec2 place) { return texture(image, place); }\n\
vec4 VVSAMPLER_2DBYPIXEL(sampler2D image, vec4 rect, vec2 size, bool flip, vec2 pixel) { return texture(image, pixel / size); }\n";

/// The completed companion vertex shader.
fn vertex_shader(text: &str, head: &Head, index: usize) -> Arc<str> {
    let text = Completion::after(String::new(), text).code;
    Arc::from(format!(
        "{}#define attribute in\n#define varying out\n#define position port_pos\n{}\
         #define PASSINDEX {index}\n{}varying vec2 isf_FragCoord;\n{text}\n\
         void isf_vertShaderInit() {{\n    gl_Position = vec4(port_pos, 0.0, 1.0);\n    \
         isf_FragNormCoord = 0.5 + 0.5 * port_pos;\n    \
         isf_FragCoord = isf_FragNormCoord * RENDERSIZE;\n    \
         isf_fragCoord = floor(isf_FragCoord);\n}}\n",
        defaults(Version::Es300),
        host(Stage::Vertex),
        head.declared,
    ))
}

impl Head {
    fn of(object: &Map<String, Value>) -> Head {
        let mut head = Head {
            credit: Credit {
                author: text_of(object, "CREDIT").unwrap_or_default(),
                description: text_of(object, "DESCRIPTION").unwrap_or_default(),
            },
            ..Head::default()
        };
        for input in list(object, "INPUTS") {
            head.input(input);
        }
        for (name, path) in imported(object.get("IMPORTED")) {
            let mut input = sampled(&name, InputKind::Texture, ("linear", "clamp"));
            input.src = path;
            head.sampler(input);
        }
        let old = persistent(object.get("PERSISTENT_BUFFERS"));
        for pass in list(object, "PASSES") {
            head.pass(pass, &old);
        }
        for name in head.targets() {
            head.sampler(read_buffer(&name, &name));
        }
        head
    }

    /// The names of the buffers, without duplicates.
    fn targets(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for name in self.passes.iter().filter_map(|p| p.name.as_ref()) {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        names
    }

    fn sampler(&mut self, input: Input) {
        let name = input.uniform.as_deref().unwrap_or("");
        self.declared
            .push_str(&format!("uniform sampler2D {name};\n"));
        self.inputs.push(input);
    }

    fn input(&mut self, input: &Map<String, Value>) {
        let Some(name) = text_of(input, "NAME").filter(|n| is_identifier(n)) else {
            self.notes
                .push("one of the `INPUTS` has no valid GLSL name".to_string());
            return;
        };
        let kind = text_of(input, "TYPE").unwrap_or_default();
        let signal = match kind.as_str() {
            "image" => {
                let input = sampled(&name, InputKind::Texture, ("linear", "clamp"));
                return self.sampler(input);
            }
            "audio" => Some(SignalForm::Wave),
            "audioFFT" => Some(SignalForm::Spectrum),
            _ => None,
        };
        if let Some(signal) = signal {
            let input = sampled(&name, InputKind::Music, ("linear", "clamp"));
            return self.sampler(Input { signal, ..input });
        }
        let Some((ty, mut control)) = control(&name, &kind, input) else {
            let note = format!("input `{name}` has type `{kind}`, which ISF 2 does not define");
            return self.notes.push(note);
        };
        if let Some(label) = text_of(input, "LABEL").filter(|l| !l.is_empty()) {
            control.label = label;
        }
        self.declared.push_str(&format!("uniform {ty} {name};\n"));
        self.controls.push(control);
    }

    fn pass(&mut self, pass: &Map<String, Value>, old: &[(String, Map<String, Value>)]) {
        let name = text_of(pass, "TARGET").filter(|n| is_identifier(n));
        let other = name
            .as_ref()
            .and_then(|name| old.iter().find(|(own, _)| own == name));
        let get = |key| {
            pass.get(key)
                .or_else(|| other.and_then(|(_, o)| o.get(key)))
        };
        let size =
            target_size(["WIDTH", "HEIGHT"].map(get), &mut self.notes).filter(|_| name.is_some());
        self.passes.push(IsfTarget {
            draw: PassDraw {
                size,
                is_float: get("FLOAT").is_some_and(is_true),
                ..PassDraw::default()
            },
            name,
        });
    }
}

/// Adds an input to the JSON header.
fn declare(text: &str, _: usize, control: &UniformControl) -> Option<(usize, String)> {
    let ([min, value, max], is_int) = control.slider()?;
    let ty = if is_int { "long" } else { "float" };
    let name = &control.name;
    let input = format!(
        "{{ \"NAME\": \"{name}\", \"TYPE\": \"{ty}\", \"DEFAULT\": {value}, \"MIN\": {min}, \"MAX\": {max} }}"
    );
    let head = head(text)?;
    let start = text.find(head)?;
    let Some(inputs) = head.find("\"INPUTS\"") else {
        let open = start + 1;
        return Some((
            open,
            format!("\n    \"INPUTS\": [\n        {input}\n    ],"),
        ));
    };
    let open = inputs + head.get(inputs..)?.find('[')? + 1;
    let is_empty = head.get(open..)?.trim_start().starts_with(']');
    let end = if is_empty { "\n    " } else { "," };
    Some((start + open, format!("\n        {input}{end}")))
}

/// The control of an input, and the type of its uniform.
fn control(
    name: &str,
    kind: &str,
    input: &Map<String, Value>,
) -> Option<(&'static str, UniformControl)> {
    let value = |key: &str| input.get(key).map(numbers).filter(|n| !n.is_empty());
    let (ty, kind, lanes, usual): (_, _, _, (f64, f64)) = match kind {
        "float" => ("float", ControlKind::Float, 1, (0.0, 1.0)),
        "bool" => ("bool", ControlKind::Bool, 1, (0.0, 1.0)),
        "event" => ("bool", ControlKind::Event, 1, (0.0, 1.0)),
        "long" => ("int", ControlKind::Int, 1, (0.0, 10.0)),
        "color" => ("vec4", ControlKind::Color, 4, (0.0, 1.0)),
        "point2D" => ("vec2", ControlKind::Point, 2, (0.0, 1.0)),
        _ => return None,
    };
    let mut control = UniformControl::even(name, kind, lanes, (usual.0, usual.0, usual.1));
    if kind == ControlKind::Color {
        control.value = vec![1.0; lanes];
    }
    if kind == ControlKind::Int {
        control.choices = choices(input);
        if !control.choices.is_empty() {
            control.kind = ControlKind::Choice;
        }
    }
    let has_range = !control.min.is_empty();
    for (key, lanes) in [("MIN", &mut control.min), ("MAX", &mut control.max)] {
        let given = value(key).filter(|_| has_range).unwrap_or_default();
        for (lane, given) in lanes.iter_mut().zip(given.iter().cycle()) {
            *lane = *given;
        }
    }
    let first = value("DEFAULT").or_else(|| value("IDENTITY"));
    match first {
        Some(first) => {
            for (lane, first) in control.value.iter_mut().zip(first) {
                *lane = first;
            }
        }
        None if kind == ControlKind::Float || kind == ControlKind::Point => {
            control.value = middle(&control);
        }
        None => {}
    }
    for (lane, value) in control.value.iter().enumerate() {
        if let Some(min) = control.min.get_mut(lane) {
            *min = min.min(*value);
        }
        if let Some(max) = control.max.get_mut(lane) {
            *max = max.max(*value);
        }
    }
    Some((ty, control))
}

fn middle(control: &UniformControl) -> Vec<f64> {
    let ends = control.min.iter().zip(&control.max);
    ends.map(|(min, max)| (min + max) / 2.0).collect()
}

/// The values of a menu with their labels.
fn choices(input: &Map<String, Value>) -> Vec<ControlChoice> {
    let labels = input.get("LABELS").and_then(Value::as_array);
    let count = labels.map_or(0, |labels| labels.len() as u32);
    let values = input.get("VALUES").map(numbers);
    let values = values.unwrap_or_else(|| (0..count).map(f64::from).collect());
    let label = |i: usize, value: f64| match labels.and_then(|l| l.get(i)) {
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
        None => value.to_string(),
    };
    let values = values.into_iter().enumerate();
    values
        .map(|(i, value)| ControlChoice {
            label: label(i, value),
            value,
        })
        .collect()
}

/// The numbers of a value: a single one, or those of a list.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Bool(b) => vec![f64::from(u8::from(*b))],
        Value::Number(n) => n.as_f64().into_iter().collect(),
        Value::String(text) => text.trim().parse().into_iter().collect(),
        Value::Array(all) => all.iter().flat_map(numbers).collect(),
        _ => Vec::new(),
    }
}

/// Whether a value is true; old headers use 1.
fn is_true(value: &Value) -> bool {
    match value {
        Value::String(text) => matches!(text.as_str(), "true" | "YES" | "1"),
        value => numbers(value).first().is_some_and(|n| *n > 0.0),
    }
}

fn text_of(object: &Map<String, Value>, key: &str) -> Option<String> {
    object.get(key).and_then(Value::as_str).map(str::to_string)
}

/// The objects of a list.
fn list<'o>(
    object: &'o Map<String, Value>,
    key: &str,
) -> impl Iterator<Item = &'o Map<String, Value>> + use<'o> {
    let all = object.get(key).and_then(Value::as_array);
    all.into_iter().flatten().filter_map(Value::as_object)
}

/// The images that a header imports, by name: an object of objects, or a list of them.
fn imported(value: Option<&Value>) -> Vec<(String, String)> {
    let path = |item: &Value| item.get("PATH").and_then(Value::as_str).map(str::to_string);
    match value {
        Some(Value::Object(all)) => all
            .iter()
            .filter(|(name, _)| is_identifier(name))
            .filter_map(|(name, item)| Some((name.clone(), path(item)?)))
            .collect(),
        Some(Value::Array(all)) => all
            .iter()
            .filter_map(|item| {
                let name = item.get("NAME")?.as_str()?.to_string();
                is_identifier(&name).then_some((name, path(item)?))
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The buffers that ISF 1 lists, by name: a list of names, or an object of objects.
fn persistent(value: Option<&Value>) -> Vec<(String, Map<String, Value>)> {
    match value {
        Some(Value::Object(all)) => all
            .iter()
            .map(|(name, item)| (name.clone(), item.as_object().cloned().unwrap_or_default()))
            .collect(),
        _ => Vec::new(),
    }
}

/// Whether a name is a valid GLSL identifier.
pub(super) fn is_identifier(name: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    name.starts_with(|c: char| is_part(c) && !c.is_ascii_digit())
        && name.chars().all(is_part)
        && !name.starts_with("gl_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_may_be_json5() {
        let read = |text: &str| Value::Object(object(text).unwrap()).to_string();
        let expected = r#"{"a":[{"b_1":"x // y"},{}],"c":2}"#;
        for text in [
            r#"{"a": [{"b_1": "x // y"}, {}], "c": 2}"#,
            "{\n  a: [ // a comment, with \"quotes\"\n    { b_1: \"x // y\", },\n    {},\n  ],\n  \"c\": 2, // 3\n}",
        ] {
            assert_eq!(read(text), expected, "{text}");
        }
        assert!(object("{a b: 1}").is_err() && object("{\"a\": b}").is_err());
    }
    use crate::Project;
    use crate::dialect::recognise;

    #[test]
    fn vertex_shaders_without_a_fragment_shader_name_the_missing_file() {
        let text = "varying vec2 q; void main() { isf_vertShaderInit(); q = vec2(1.0); }";
        assert_eq!(recognise(&Clues::of(text)).unwrap().host.name, "isf");
        let notes = plan(&Clues::of(text)).notes;
        assert!(
            notes.iter().any(|n| n.contains("`.fs` file next to it")),
            "{notes:?}"
        );
    }

    #[test]
    fn headers_with_json_errors_are_read() {
        let read = object("{\"A\": [1, 2,],\n \"B\": \"two\nlines, ]\",}").unwrap();
        assert_eq!(read.len(), 2);
        assert_eq!(read["B"], "two lines, ]");
        assert!(object("{\"A\": }").is_err());
    }

    fn project(text: &str) -> Project {
        let mut project = Project::draft("x", text, None).unwrap();
        project.resolve("x").unwrap();
        project
    }

    #[test]
    fn inputs_become_controls_and_channels() {
        let project = project(
            r#"/*{"INPUTS": [
            {"NAME": "a", "TYPE": "float", "MIN": -1, "MAX": 3},
            {"NAME": "b", "TYPE": "long", "VALUES": [4, 9], "LABELS": ["four", "nine"], "DEFAULT": 9},
            {"NAME": "c", "TYPE": "color", "DEFAULT": [1, 0.5, 0, 1]},
            {"NAME": "d", "TYPE": "event"}, {"NAME": "e f", "TYPE": "bool"},
            {"NAME": "p", "TYPE": "point2D", "DEFAULT": [2, 0.5]},
            {"NAME": "sound", "TYPE": "audioFFT"}, {"NAME": "i", "TYPE": "image"}]}*/
            void main() { gl_FragColor = IMG_NORM_PIXEL(i, p) + IMG_PIXEL(sound, vec2(a)); }"#,
        );
        let controls = project.controls.iter().map(|c| {
            let range = format!("{:?} {:?} {:?}", c.min, c.value, c.max);
            format!("{} {:?} {range}", c.name, c.kind)
        });
        assert_eq!(
            controls.collect::<Vec<_>>(),
            [
                "a Float [-1.0] [1.0] [3.0]",
                "b Choice [0.0] [9.0] [10.0]",
                "c Color [0.0, 0.0, 0.0, 0.0] [1.0, 0.5, 0.0, 1.0] [1.0, 1.0, 1.0, 1.0]",
                "d Event [] [0.0] []",
                "p Point [0.0, 0.0] [2.0, 0.5] [2.0, 1.0]",
            ]
        );
        let inputs = project.passes[0].inputs.iter();
        let inputs = inputs.map(|i| format!("{:?} {:?}", i.kind, i.signal));
        let expected = ["Music Spectrum", "Texture Both"];
        assert_eq!(inputs.collect::<Vec<_>>(), expected);
        assert_eq!(project.notes.len(), 2, "{:?}", project.notes);
    }

    #[test]
    fn passes_draw_to_their_targets() {
        let project = project(
            r#"/*{"INPUTS": [], "PASSES": [{"TARGET": "a", "WIDTH": "$WIDTH/2", "FLOAT": true}, {},
            {"TARGET": "b", "PERSISTENT": true}]}*/
            void main() { gl_FragColor = IMG_THIS_PIXEL(a) + IMG_THIS_PIXEL(b) + float(PASSINDEX); }"#,
        );
        let passes = project.passes.iter().map(|p| {
            let (has_size, is_float) = (p.draw.size.is_some(), p.draw.is_float);
            format!("{} {:?} {has_size} {is_float}", p.name, p.kind)
        });
        let expected = [
            "a Buffer true true",
            "b Buffer false false",
            "Image Image false false",
        ];
        assert_eq!(passes.collect::<Vec<_>>(), expected);
        assert!(project.passes[1].before.contains("#define PASSINDEX 2"));
    }
}
