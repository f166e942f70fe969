//! The inputs of programs, with the places of scripts that name and set them.

use crate::breach::base;
use crate::interface::Stages;
use crate::shape::frame_size;
use shaderlint_script::{ObjectKind, ScriptPlace, ScriptValue, Source, World};
use std::fmt;

/// The release of three.js since which colours are converted to linear ones.
const LINEAR_COLORS: u32 = 152;

/// The inputs of a program and the names of them in scripts.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct ProgramBindings {
    /// Where the program is made.
    pub place: ScriptPlace,
    /// What its shaders declare.
    pub inputs: Vec<BoundInput>,
    /// The names by which scripts refer to its inputs, also to those that no shader declares.
    pub mentions: Vec<(String, ScriptPlace)>,
    /// Where scripts compute a name, with the name if it is known.
    pub computed: Vec<(Option<String>, ScriptPlace)>,
}

/// A uniform or attribute of a program.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct BoundInput {
    /// Its name.
    pub name: String,
    /// Its type in GLSL, with the size of an array.
    pub type_name: String,
    /// Whether it is an attribute.
    pub is_attribute: bool,
    /// Its name in the declarations of the stages.
    pub declared: Vec<ScriptPlace>,
    /// Where it is set, the first value first.
    pub settings: Vec<InputSetting>,
    /// Whether something else may change it.
    pub escapes: bool,
}

/// A place that sets an input.
#[derive(Clone, PartialEq, Debug)]
pub struct InputSetting {
    /// Where.
    pub place: ScriptPlace,
    /// The value, if it is known.
    pub value: Option<InputValue>,
}

/// The value of an input.
#[derive(Clone, PartialEq, Debug)]
pub enum InputValue {
    /// Numbers, column by column.
    Numbers(Vec<f64>),
    /// Width and height of the frame.
    FrameSize,
    /// A time.
    Time,
}

impl fmt::Display for InputValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            InputValue::Numbers(all) => {
                let shown = all.iter().take(16).map(|n| (*n as f32).to_string());
                let shown: Vec<String> = shown.collect();
                let more = if all.len() > 16 { ", …" } else { "" };
                match shown.as_slice() {
                    [one] => f.write_str(one),
                    _ => write!(f, "({}{more})", shown.join(", ")),
                }
            }
            InputValue::FrameSize => f.write_str("the size of the frame"),
            InputValue::Time => f.write_str("the time"),
        }
    }
}

impl ProgramBindings {
    /// Of a program with some stages.
    pub fn new(place: ScriptPlace, stages: &Stages) -> ProgramBindings {
        let mut inputs: Vec<BoundInput> = Vec::new();
        let uniforms = stages.all().flat_map(|s| &s.uniforms).map(|u| (u, false));
        let attributes = stages.vertex.iter().flat_map(|s| &s.inputs);
        for (input, is_attribute) in uniforms.chain(attributes.map(|a| (a, true))) {
            match inputs.iter_mut().find(|known| known.name == input.name) {
                Some(known) => known.declared.extend(input.place),
                None => inputs.push(BoundInput {
                    name: input.name.clone(),
                    type_name: input.type_name.clone(),
                    is_attribute,
                    declared: input.place.into_iter().collect(),
                    ..BoundInput::default()
                }),
            }
        }
        ProgramBindings {
            place,
            inputs,
            ..ProgramBindings::default()
        }
    }

    /// Adds a place that names an input, or a part of it: `lights[0].color`.
    pub fn mention(&mut self, world: &World, name: &str, place: ScriptPlace) {
        let name = base(name).to_string();
        match world.named(place, &name) {
            Some(place) => self.mentions.push((name, place)),
            None => self.computed.push((Some(name), place)),
        }
    }

    /// Adds a place that sets an input. A place that is evaluated again with another value has no known one.
    pub fn set(&mut self, name: &str, setting: InputSetting) {
        let mut all = self.inputs.iter_mut();
        let Some(input) = all.find(|input| input.name == base(name)) else {
            return;
        };
        match input.settings.iter_mut().find(|s| s.place == setting.place) {
            Some(known) if known.value != setting.value => known.value = None,
            Some(_) => {}
            None => input.settings.push(setting),
        }
    }

    /// The input of a name.
    pub fn input(&self, name: &str) -> Option<&BoundInput> {
        self.inputs.iter().find(|input| input.name == name)
    }
}

impl BoundInput {
    /// The first value, or the time if that is set, and where it is set.
    pub fn value(&self) -> Option<(&InputValue, ScriptPlace)> {
        let mut all = self.settings.iter();
        let time = all.find(|s| s.value == Some(InputValue::Time));
        let first = time.or(self.settings.first())?;
        Some((first.value.as_ref()?, first.place))
    }

    /// Whether nothing changes its value.
    pub fn is_constant(&self) -> bool {
        let is_same = |s: &InputSetting| s.value.as_ref() == self.value().map(|(value, _)| value);
        !self.escapes && self.settings.iter().all(is_same)
    }
}

/// The value of some arguments: `new Vector2(innerWidth, innerHeight)`, `gl.uniform2f(location, 1, 2)`.
pub fn value_of_all<'v>(
    world: &World,
    all: impl Iterator<Item = &'v ScriptValue> + Clone,
) -> Option<InputValue> {
    let sizes = all
        .clone()
        .map(|value| frame_size(world, value).map(|(is_width, _)| is_width));
    if sizes.eq([Some(true), Some(false)]) {
        return Some(InputValue::FrameSize);
    }
    let mut numbers = Vec::new();
    for value in all {
        match value_of(world, value, None)? {
            InputValue::Numbers(more) => numbers.extend(more),
            _ => return None,
        }
    }
    Some(InputValue::Numbers(numbers))
}

/// A value, if it is known. `release` is the one of three.js.
pub fn value_of(world: &World, value: &ScriptValue, release: Option<u32>) -> Option<InputValue> {
    let numbers = |all: Vec<f64>| Some(InputValue::Numbers(all));
    match value {
        ScriptValue::Number(number) => return numbers(vec![*number]),
        ScriptValue::Bool(flag) => return numbers(vec![f64::from(u8::from(*flag))]),
        value if is_clock(world, value) => return Some(InputValue::Time),
        _ => {}
    }
    if let Some(elements) = world.elements(value) {
        return value_of_all(world, elements.iter()).filter(|_| !elements.is_empty());
    }
    let call = world.call_of(value.object()?).filter(|call| call.is_new)?;
    let name = call.name.trim_end_matches(|c: char| c.is_ascii_digit());
    let size = call.name.get(name.len()..)?.parse::<usize>().unwrap_or(3);
    let arguments = call.arguments.iter().map(|(value, _)| value);
    match (name, arguments.clone().next(), call.arguments.len()) {
        ("Color", Some(ScriptValue::Number(color)), 1) => numbers(color_of(*color as u32, release)),
        ("Color", Some(ScriptValue::Text(text)), _) => {
            let digits = text.content.strip_prefix('#').filter(|d| d.len() == 6)?;
            let color = u32::from_str_radix(digits, 16).ok()?;
            numbers(color_of(color, release))
        }
        (name, Some(ScriptValue::Number(count)), 1) if name.ends_with("Array") => {
            numbers(vec![0.0; (*count as usize).min(4096)])
        }
        (name, Some(_), _) if name.ends_with("Array") => value_of_all(world, arguments),
        ("Vector" | "Vec" | "Color" | "Matrix" | "Mat", Some(_), _) => {
            let found = value_of_all(world, arguments)?;
            let is_whole = |all: &Vec<f64>| all.len() == size || all.len() == size * size;
            match &found {
                InputValue::Numbers(all) => is_whole(all).then_some(found),
                _ => Some(found),
            }
        }
        // The fourth component of a vector of three.js is 1.
        ("Vector", None, _) => {
            let all = (0..size).map(|at| f64::from(u8::from(at == 3)));
            numbers(all.collect())
        }
        ("Matrix" | "Mat", None, _) => {
            let all = (0..size * size).map(|at| f64::from(u8::from(at % (size + 1) == 0)));
            numbers(all.collect())
        }
        ("Vec", None, _) => numbers(vec![0.0; size]),
        _ => None,
    }
}

/// The components of a colour that is written as one number.
fn color_of(color: u32, release: Option<u32>) -> Vec<f64> {
    let is_linear = release.is_none_or(|release| release >= LINEAR_COLORS);
    let part = |shift: u32| match f64::from((color >> shift) & 255) / 255.0 {
        c if !is_linear => c,
        c if c < 0.04045 => c / 12.92,
        c => ((c + 0.055) / 1.055).powf(2.4),
    };
    vec![part(16), part(8), part(0)]
}

/// Whether a value is read from a clock.
fn is_clock(world: &World, value: &ScriptValue) -> bool {
    let Some(id) = value.object() else {
        return false;
    };
    match world.object(id).map(|o| &o.kind) {
        Some(ObjectKind::Foreign(Source::Member(_, name))) => &**name == "elapsedTime",
        _ => world.call_of(id).is_some_and(|call| {
            !call.is_new && ["getElapsedTime", "now", "getElapsed"].contains(&&*call.name)
        }),
    }
}

/// Whether a statement adds to what is named at a place.
pub fn is_increment(world: &World, place: ScriptPlace) -> bool {
    let rest = ScriptPlace {
        start: place.end,
        end: place.end + 3,
        ..place
    };
    let after = world.code(rest).unwrap_or("").trim_start();
    after.starts_with("+=") || after.starts_with("++")
}
