//! The inputs of programs, with the places of scripts that name and set them.

use crate::breach::base;
use crate::interface::Stages;
use crate::webgl::is_size;
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
    /// Where scripts compute a name.
    pub computed: Vec<ScriptPlace>,
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
        /// Maximum number of numbers that are listed.
        const MOST: usize = 16;
        match self {
            InputValue::Numbers(numbers) => {
                let shown = numbers.iter().take(MOST).map(|n| format!("{}", *n as f32));
                let shown = shown.collect::<Vec<_>>().join(", ");
                let more = if numbers.len() > MOST { ", …" } else { "" };
                match numbers.len() {
                    1 => f.write_str(&shown),
                    _ => write!(f, "({shown}{more})"),
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
            let known = inputs.iter_mut().find(|known| known.name == input.name);
            match known {
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
        match world.named(place, base(name)) {
            Some(place) => self.mentions.push((base(name).to_string(), place)),
            None => self.computed.push(place),
        }
    }

    /// Adds a place that sets an input. A place that is evaluated again with another value has no known one.
    pub fn set(&mut self, name: &str, setting: InputSetting) {
        let input = self
            .inputs
            .iter_mut()
            .find(|input| input.name == base(name));
        let Some(input) = input else { return };
        let known = input.settings.iter_mut().find(|s| s.place == setting.place);
        match known {
            Some(known) if known.value != setting.value => known.value = None,
            Some(_) => {}
            None => input.settings.push(setting),
        }
    }

    /// Sorts the places, each once.
    pub fn finish(mut self) -> ProgramBindings {
        self.mentions.sort();
        self.mentions.dedup();
        self
    }

    /// The input of a name.
    pub fn input(&self, name: &str) -> Option<&BoundInput> {
        self.inputs.iter().find(|input| input.name == name)
    }

    /// The places that name an input.
    pub fn mentions_of(&self, name: &str) -> impl Iterator<Item = ScriptPlace> {
        let all = self.mentions.iter().filter(move |(own, _)| own == name);
        all.map(|(_, place)| *place)
    }
}

impl BoundInput {
    /// The value that it always has, if nothing changes it.
    pub fn constant(&self) -> Option<(&InputValue, ScriptPlace)> {
        let first = self.settings.first().filter(|_| !self.escapes)?;
        let value = first.value.as_ref()?;
        let is_same = |other: &InputSetting| other.value.as_ref() == Some(value);
        self.settings
            .iter()
            .all(is_same)
            .then_some((value, first.place))
    }

    /// The value that it has first.
    pub fn initial(&self) -> Option<(&InputValue, ScriptPlace)> {
        let first = self.settings.first()?;
        Some((first.value.as_ref()?, first.place))
    }
}

/// The value of some arguments: `new Vector2(innerWidth, innerHeight)`, `gl.uniform2f(location, 1, 2)`.
pub fn value_of_all<'v>(
    world: &World,
    all: impl Iterator<Item = &'v ScriptValue> + Clone,
) -> Option<InputValue> {
    let sizes = all.clone().map(|value| is_size(world, value));
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
    match value {
        ScriptValue::Number(number) => return Some(InputValue::Numbers(vec![*number])),
        ScriptValue::Bool(flag) => {
            return Some(InputValue::Numbers(vec![f64::from(u8::from(*flag))]));
        }
        value if is_clock(world, value) => return Some(InputValue::Time),
        _ => {}
    }
    if let Some(elements) = world.elements(value) {
        return value_of_all(world, elements.iter()).filter(|_| !elements.is_empty());
    }
    let call = world.call_of(value.object()?).filter(|call| call.is_new)?;
    let arguments = || call.arguments.iter().map(|(value, _)| value);
    let name = &*call.name;
    let size = name.chars().last().and_then(|c| c.to_digit(10));
    match arguments().next() {
        Some(ScriptValue::Text(text)) if name == "Color" => {
            let digits = text.content.strip_prefix('#')?;
            let color = u32::from_str_radix(digits, 16)
                .ok()
                .filter(|_| digits.len() == 6);
            Some(color_of(color?, release))
        }
        Some(ScriptValue::Number(color)) if name == "Color" && call.arguments.len() == 1 => {
            Some(color_of(*color as u32, release))
        }
        // A number of zeros.
        Some(ScriptValue::Number(count)) if name.ends_with("Array") => {
            let count = (*count as usize).min(4096);
            Some(InputValue::Numbers(vec![0.0; count]))
        }
        Some(_) if size.is_some() || name.ends_with("Array") || name.starts_with("Color") => {
            let found = value_of_all(world, arguments())?;
            let is_whole = match (&found, size) {
                (InputValue::Numbers(all), Some(size)) if !name.ends_with("Array") => {
                    all.len() == size as usize || name.starts_with("Mat") && all.len() > 3
                }
                _ => true,
            };
            is_whole.then_some(found)
        }
        None if name.starts_with("Vec") => {
            let mut zeros = vec![0.0; size? as usize];
            // The fourth component of a vector of three.js is 1.
            if let (Some(last), "Vector4") = (zeros.get_mut(3), name) {
                *last = 1.0;
            }
            Some(InputValue::Numbers(zeros))
        }
        None if name.starts_with("Mat") => {
            let size = size? as usize;
            let is_one = |at: usize| at.is_multiple_of(size + 1);
            let all = (0..size * size).map(|at| f64::from(u8::from(is_one(at))));
            Some(InputValue::Numbers(all.collect()))
        }
        _ => None,
    }
}

/// The components of a colour that is written as one number.
fn color_of(color: u32, release: Option<u32>) -> InputValue {
    let linear = |c: f64| match c {
        c if c < 0.04045 => c / 12.92,
        c => ((c + 0.055) / 1.055).powf(2.4),
    };
    let is_linear = release.is_none_or(|release| release >= LINEAR_COLORS);
    let part = |shift: u32| {
        let c = f64::from((color >> shift) & 255) / 255.0;
        if is_linear { linear(c) } else { c }
    };
    InputValue::Numbers(vec![part(16), part(8), part(0)])
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
    let file = world.files.get(place.file);
    let after = file.and_then(|(_, text)| text.get(place.end as usize..));
    let after = after.unwrap_or("").trim_start();
    after.starts_with("+=") || after.starts_with("++")
}
