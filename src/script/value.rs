//! Values of a script.

use std::ops::Range;
use std::rc::Rc;

/// Index of an object in a [`World`](crate::World).
pub type ObjectId = usize;

/// A range in one of the files of a program; offsets in bytes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ScriptPlace {
    /// Index in [`World::files`](crate::World::files).
    pub file: usize,
    /// First byte.
    pub start: u32,
    /// End, exclusive.
    pub end: u32,
}

/// A value, as far as it is known.
#[derive(Clone, Debug)]
pub enum ScriptValue {
    /// `undefined`, or nothing.
    Undefined,
    /// `null`
    Null,
    /// A known boolean.
    Bool(bool),
    /// A known number.
    Number(f64),
    /// A text.
    Text(Rc<KnownText>),
    /// A value of a known type.
    Any(Primitive),
    /// An object, or a value of which nothing is known.
    Object(ObjectId),
}

/// A type of values without an identity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Primitive {
    /// A boolean.
    Bool,
    /// A number.
    Number,
    /// A text.
    Text,
}

impl ScriptValue {
    /// The object.
    pub fn object(&self) -> Option<ObjectId> {
        match self {
            ScriptValue::Object(id) => Some(*id),
            _ => None,
        }
    }

    /// The text, unless parts of it are unknown.
    pub fn text(&self) -> Option<&str> {
        match self {
            ScriptValue::Text(text) if !text.is_open => Some(&text.content),
            _ => None,
        }
    }

    /// The number.
    pub fn number(&self) -> Option<f64> {
        match self {
            ScriptValue::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// The type, if it has no identity.
    pub fn primitive(&self) -> Option<Primitive> {
        match self {
            ScriptValue::Bool(_) => Some(Primitive::Bool),
            ScriptValue::Number(_) => Some(Primitive::Number),
            ScriptValue::Text(_) => Some(Primitive::Text),
            ScriptValue::Any(primitive) => Some(*primitive),
            _ => None,
        }
    }

    /// Whether both are the same known value or the same object.
    pub fn is_same(&self, other: &ScriptValue) -> bool {
        match (self, other) {
            (ScriptValue::Undefined, ScriptValue::Undefined)
            | (ScriptValue::Null, ScriptValue::Null) => true,
            (ScriptValue::Bool(a), ScriptValue::Bool(b)) => a == b,
            (ScriptValue::Number(a), ScriptValue::Number(b)) => a == b,
            (ScriptValue::Text(a), ScriptValue::Text(b)) => {
                !a.is_open && !b.is_open && a.content == b.content
            }
            (ScriptValue::Object(a), ScriptValue::Object(b)) => a == b,
            _ => false,
        }
    }
}

/// A text with the places that its parts come from.
#[derive(Clone, Debug, Default)]
pub struct KnownText {
    /// The characters; of unknown parts there are none.
    pub content: String,
    /// The parts that are written in a file, in order.
    pieces: Vec<WrittenPiece>,
    /// Whether parts are unknown.
    pub is_open: bool,
}

/// A part of a text that is written in a file.
#[derive(Clone, Debug)]
struct WrittenPiece {
    /// Offset in the text.
    at: usize,
    place: ScriptPlace,
}

impl KnownText {
    /// A text that is written at a place. Where the lengths differ, it contains escapes.
    pub fn written(content: &str, place: ScriptPlace) -> KnownText {
        KnownText {
            content: content.to_string(),
            pieces: vec![WrittenPiece { at: 0, place }],
            is_open: false,
        }
    }

    /// A text that is not written anywhere.
    pub fn made(content: String) -> KnownText {
        KnownText {
            content,
            ..KnownText::default()
        }
    }

    /// A text of which nothing is known.
    pub fn unknown() -> KnownText {
        KnownText {
            is_open: true,
            ..KnownText::default()
        }
    }

    /// Appends a text.
    pub fn push(&mut self, other: &KnownText) {
        let at = self.content.len();
        self.content.push_str(&other.content);
        let moved = other.pieces.iter().map(|piece| WrittenPiece {
            at: piece.at + at,
            place: piece.place,
        });
        self.pieces.extend(moved);
        self.is_open |= other.is_open;
    }

    /// A part of the text.
    pub fn slice(&self, range: Range<usize>) -> KnownText {
        let content = self.content.get(range.clone()).unwrap_or("").to_string();
        let pieces = self.pieces.iter().enumerate().filter_map(|(index, piece)| {
            let next = self.pieces.get(index + 1);
            let end = next.map_or(self.content.len(), |p| p.at);
            let from = piece.at.max(range.start);
            let to = end.min(range.end);
            let moved = (from - piece.at) as u32;
            (from < to).then(|| WrittenPiece {
                at: from - range.start,
                place: ScriptPlace {
                    start: (piece.place.start + moved).min(piece.place.end),
                    ..piece.place
                },
            })
        });
        KnownText {
            content,
            pieces: pieces.collect(),
            is_open: self.is_open,
        }
    }

    /// Where a range of the text is written; `None` if nowhere.
    pub fn place(&self, range: Range<usize>) -> Option<ScriptPlace> {
        let piece = self.pieces.iter().rev().find(|p| p.at <= range.start)?;
        let start = piece.place.start + (range.start - piece.at) as u32;
        let end = start + range.len() as u32;
        (end <= piece.place.end).then_some(ScriptPlace {
            start,
            end,
            ..piece.place
        })
    }

    /// Where the text begins in a file.
    pub fn first_place(&self) -> Option<ScriptPlace> {
        self.pieces.first().map(|piece| piece.place)
    }
}
