//! The types of values that scripts set.

use crate::library::LibraryExport;
use shaderlint_script::{ObjectKind, Primitive, ScriptValue, Source, World};

/// The type of a value, as far as a setter distinguishes it.
#[derive(Clone, PartialEq, Debug)]
pub enum ValueShape {
    /// Not known, or nothing yet.
    Unknown,
    /// A number.
    Number,
    /// A boolean.
    Bool,
    /// A text.
    Text,
    /// An object for a vector of this many components, with its name.
    Vector(u32, String),
    /// An object for a matrix of this many columns, with its name.
    Matrix(u32, String),
    /// A texture.
    Texture,
    /// Numbers, and how many, if that is known.
    Numbers(Option<usize>),
    /// Values of one type.
    List(usize, Box<ValueShape>),
    /// An object of the program with properties.
    Record,
}

impl ValueShape {
    /// The type of a value.
    pub fn of(world: &World, value: &ScriptValue) -> ValueShape {
        match value.primitive() {
            Some(Primitive::Number) => return ValueShape::Number,
            Some(Primitive::Bool) => return ValueShape::Bool,
            Some(Primitive::Text) => return ValueShape::Text,
            None => {}
        }
        let Some(id) = value.object() else {
            return ValueShape::Unknown;
        };
        let Some(object) = world.object(id) else {
            return ValueShape::Unknown;
        };
        match &object.kind {
            ObjectKind::Array(elements) if object.is_open => match elements.first() {
                Some(first) if ValueShape::of(world, first) == ValueShape::Number => {
                    ValueShape::Numbers(None)
                }
                _ => ValueShape::Unknown,
            },
            ObjectKind::Array(elements) => ValueShape::of_elements(world, elements),
            ObjectKind::Plain if !object.is_open => ValueShape::Record,
            ObjectKind::Foreign(Source::Event(_)) => ValueShape::of_call(world, id),
            // `target.texture`
            ObjectKind::Foreign(Source::Member(target, name)) if &**name == "texture" => {
                let call = world.call_of(*target).filter(|call| call.is_new);
                match call {
                    Some(_) => ValueShape::Texture,
                    None => ValueShape::Unknown,
                }
            }
            _ => ValueShape::Unknown,
        }
    }

    fn of_elements(world: &World, elements: &[ScriptValue]) -> ValueShape {
        let mut shapes = elements
            .iter()
            .map(|element| ValueShape::of(world, element));
        let Some(first) = shapes.next() else {
            return ValueShape::Unknown;
        };
        match shapes.all(|other| other == first) {
            false => ValueShape::Unknown,
            true if first == ValueShape::Number => ValueShape::Numbers(Some(elements.len())),
            true => ValueShape::List(elements.len(), Box::new(first)),
        }
    }

    /// The type of what a call makes: the names of classes for vectors are the same in all libraries.
    fn of_call(world: &World, id: usize) -> ValueShape {
        let Some(call) = world.call_of(id) else {
            return ValueShape::Unknown;
        };
        let name = &*call.name;
        if !call.is_new {
            let loads = call.this.and_then(|this| world.call_of(this));
            let is_loader = loads.is_some_and(|loader| loader.name.ends_with("TextureLoader"));
            return match name {
                "load" if is_loader => ValueShape::Texture,
                _ => ValueShape::Unknown,
            };
        }
        if let Some(bytes) = name.strip_suffix("Array").filter(|_| name != "Array") {
            let is_typed = [
                "Float32",
                "Float64",
                "Int8",
                "Int16",
                "Int32",
                "Uint8",
                "Uint8Clamped",
                "Uint16",
                "Uint32",
            ];
            if is_typed.contains(&bytes) {
                return ValueShape::Numbers(length(
                    world,
                    call.arguments.first().map(|(value, _)| value),
                ));
            }
        }
        let origin = LibraryExport::of(world, call.callee);
        if origin.is_none() {
            return ValueShape::Unknown;
        }
        let digit = || name.chars().last().and_then(|c| c.to_digit(10));
        let is = |stem: &str| name.strip_suffix(|c: char| c.is_ascii_digit()) == Some(stem);
        match name {
            "Quaternion" => ValueShape::Vector(4, name.to_string()),
            "Color" | "Color3" => ValueShape::Vector(3, name.to_string()),
            _ if is("Vector") || is("Vec") || is("Color") => digit()
                .map_or(ValueShape::Unknown, |n| {
                    ValueShape::Vector(n, name.to_string())
                }),
            _ if is("Matrix") || is("Mat") => digit().map_or(ValueShape::Unknown, |n| {
                ValueShape::Matrix(n, name.to_string())
            }),
            _ if name.ends_with("Texture") => ValueShape::Texture,
            _ => ValueShape::Unknown,
        }
    }

    /// The value in words.
    pub fn text(&self) -> String {
        match self {
            ValueShape::Unknown => "a value".to_string(),
            ValueShape::Number => "a number".to_string(),
            ValueShape::Bool => "a boolean".to_string(),
            ValueShape::Text => "a string".to_string(),
            ValueShape::Vector(_, name) | ValueShape::Matrix(_, name) => format!("a `{name}`"),
            ValueShape::Texture => "a texture".to_string(),
            ValueShape::Numbers(Some(1)) => "one number".to_string(),
            ValueShape::Numbers(Some(count)) => format!("{count} numbers"),
            ValueShape::Numbers(None) => "numbers".to_string(),
            ValueShape::List(1, of) => format!("an array of {}", of.text()),
            ValueShape::List(count, of) => {
                let of = of.text();
                let of = of.strip_prefix("a ").unwrap_or(&of).to_string();
                format!("{count} values of type {of}")
            }
            ValueShape::Record => "an object".to_string(),
        }
    }
}

/// The number of elements of a typed array made from a value.
pub fn length(world: &World, value: Option<&ScriptValue>) -> Option<usize> {
    match value? {
        ScriptValue::Number(count) => Some(*count as usize),
        value => world.elements(value).map(<[ScriptValue]>::len),
    }
}

/// Whether a value is the width of the frame, or its height, and whether it counts CSS pixels.
pub fn frame_size(world: &World, value: &ScriptValue) -> Option<(bool, bool)> {
    let (of, name) = match &world.object(value.object()?)?.kind {
        ObjectKind::Foreign(Source::Member(of, name)) => (Some(*of), name),
        ObjectKind::Foreign(Source::Global(name)) => (None, name),
        _ => return None,
    };
    let stem = name.strip_suffix("idth").or(name.strip_suffix("eight"))?;
    let is_css = ["inner", "client", "offset"]
        .iter()
        .any(|part| stem.starts_with(part));
    let is_canvas = |of| {
        let holder = world.member_of(of).map(|(_, name)| name);
        let call = world.call_of(of).map(|call| &*call.name);
        matches!(holder, Some("canvas" | "domElement"))
            || matches!(
                call,
                Some("getElementById" | "querySelector" | "createElement")
            )
    };
    let is_own = match stem {
        "w" | "h" => of.is_some_and(is_canvas),
        _ => is_css || stem.starts_with("drawingBuffer"),
    };
    is_own.then_some((name.ends_with("idth"), is_css))
}
