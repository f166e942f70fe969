//! The types of values that scripts set.

use crate::library::Origin;
use shaderlint_script::{ObjectKind, Primitive, Source, Value, World};

/// The type of a value, as far as a setter distinguishes it.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
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
    List(usize, Box<Shape>),
    /// An object of the program with properties.
    Record,
}

impl Shape {
    /// The type of a value.
    pub fn of(world: &World, value: &Value) -> Shape {
        match value.primitive() {
            Some(Primitive::Number) => return Shape::Number,
            Some(Primitive::Bool) => return Shape::Bool,
            Some(Primitive::Text) => return Shape::Text,
            None => {}
        }
        let Some(id) = value.object() else {
            return Shape::Unknown;
        };
        let Some(object) = world.object(id) else {
            return Shape::Unknown;
        };
        match &object.kind {
            ObjectKind::Array(elements) if object.is_open => match elements.first() {
                Some(first) if Shape::of(world, first) == Shape::Number => Shape::Numbers(None),
                _ => Shape::Unknown,
            },
            ObjectKind::Array(elements) => Shape::of_elements(world, elements),
            ObjectKind::Plain if !object.is_open => Shape::Record,
            ObjectKind::Foreign(Source::Event(_)) => Shape::of_call(world, id),
            // `target.texture`
            ObjectKind::Foreign(Source::Member(target, name)) if &**name == "texture" => {
                let call = world.call_of(*target).filter(|call| call.is_new);
                match call {
                    Some(_) => Shape::Texture,
                    None => Shape::Unknown,
                }
            }
            _ => Shape::Unknown,
        }
    }

    fn of_elements(world: &World, elements: &[Value]) -> Shape {
        let mut shapes = elements.iter().map(|element| Shape::of(world, element));
        let Some(first) = shapes.next() else {
            return Shape::Unknown;
        };
        match shapes.all(|other| other == first) {
            false => Shape::Unknown,
            true if first == Shape::Number => Shape::Numbers(Some(elements.len())),
            true => Shape::List(elements.len(), Box::new(first)),
        }
    }

    /// The type of what a call makes: the names of classes for vectors are the same in all libraries.
    fn of_call(world: &World, id: usize) -> Shape {
        let Some(call) = world.call_of(id) else {
            return Shape::Unknown;
        };
        let name = &*call.name;
        if !call.is_new {
            let loads = call.this.and_then(|this| world.call_of(this));
            let is_loader = loads.is_some_and(|loader| loader.name.ends_with("TextureLoader"));
            return match name {
                "load" if is_loader => Shape::Texture,
                _ => Shape::Unknown,
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
                return Shape::Numbers(length(
                    world,
                    call.arguments.first().map(|(value, _)| value),
                ));
            }
        }
        let origin = Origin::of(world, call.callee);
        if origin.is_none() {
            return Shape::Unknown;
        }
        let digit = || name.chars().last().and_then(|c| c.to_digit(10));
        let is = |stem: &str| name.strip_suffix(|c: char| c.is_ascii_digit()) == Some(stem);
        match name {
            "Quaternion" => Shape::Vector(4, name.to_string()),
            "Color" | "Color3" => Shape::Vector(3, name.to_string()),
            _ if is("Vector") || is("Vec") || is("Color") => {
                digit().map_or(Shape::Unknown, |n| Shape::Vector(n, name.to_string()))
            }
            _ if is("Matrix") || is("Mat") => {
                digit().map_or(Shape::Unknown, |n| Shape::Matrix(n, name.to_string()))
            }
            _ if name.ends_with("Texture") => Shape::Texture,
            _ => Shape::Unknown,
        }
    }

    /// The value in words.
    pub fn text(&self) -> String {
        match self {
            Shape::Unknown => "a value".to_string(),
            Shape::Number => "a number".to_string(),
            Shape::Bool => "a boolean".to_string(),
            Shape::Text => "a string".to_string(),
            Shape::Vector(_, name) | Shape::Matrix(_, name) => format!("a `{name}`"),
            Shape::Texture => "a texture".to_string(),
            Shape::Numbers(Some(1)) => "one number".to_string(),
            Shape::Numbers(Some(count)) => format!("{count} numbers"),
            Shape::Numbers(None) => "numbers".to_string(),
            Shape::List(1, of) => format!("an array of {}", of.text()),
            Shape::List(count, of) => {
                let of = of.text();
                let of = of.strip_prefix("a ").unwrap_or(&of).to_string();
                format!("{count} values of type {of}")
            }
            Shape::Record => "an object".to_string(),
        }
    }
}

/// The number of elements of a typed array made from a value.
pub fn length(world: &World, value: Option<&Value>) -> Option<usize> {
    match value? {
        Value::Number(count) => Some(*count as usize),
        value => world.elements(value).map(<[Value]>::len),
    }
}
