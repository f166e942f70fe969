//! The objects of a program and what it does with them.

use crate::value::{ObjectId, ScriptPlace, ScriptValue};
use oxc_ast::ast as js;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;

/// Index of a scope.
pub(crate) type ScopeId = usize;
/// Index of an event in [`World::events`].
pub type EventId = usize;

/// What a program does, in the order in which it does it.
#[derive(Default)]
pub struct World<'a> {
    /// The files that were evaluated or loaded, the root first.
    pub files: Vec<(PathBuf, Arc<str>)>,
    /// All objects.
    pub objects: Vec<ScriptObject<'a>>,
    /// Calls of functions outside of the program, and changes of objects.
    pub events: Vec<ScriptEvent>,
    /// Objects whose properties are read, and where the names of these are written.
    pub reads: Vec<(ObjectId, ScriptPlace)>,
    /// The values of which `?.` reads something.
    pub optional: Vec<ObjectId>,
    /// Whether a budget ended the evaluation.
    pub is_cut: bool,
}

/// An object, or a value of which nothing is known.
pub struct ScriptObject<'a> {
    /// What it is.
    pub kind: ObjectKind<'a>,
    /// The expression that made it.
    pub place: ScriptPlace,
    /// The known properties in the order of their creation.
    pub properties: Vec<Property>,
    /// Whether it may have other properties or elements.
    pub is_open: bool,
    /// The class of the program that it is an instance of.
    pub class: Option<ObjectId>,
}

/// What an object is.
pub enum ObjectKind<'a> {
    /// An object of the program.
    Plain,
    /// An array with its elements.
    Array(Vec<ScriptValue>),
    /// A function of the program.
    Function(Closure<'a>),
    /// A class of the program.
    Class(ScriptClass<'a>),
    /// Something from outside of the program.
    Foreign(Source),
}

/// Where a foreign object comes from.
#[derive(Clone, PartialEq, Debug)]
pub enum Source {
    /// An export of a package or of a module that was not found: its path and the name, `*` for all.
    Package(Rc<str>, Rc<str>),
    /// A global name.
    Global(Rc<str>),
    /// The property of another object.
    Member(ObjectId, Rc<str>),
    /// The result of a call.
    Event(EventId),
    /// A number more than another value, as the location of a column of a matrix.
    Sum(ObjectId, i32),
    /// Anything else.
    Unknown,
}

/// A property.
#[derive(Clone, Debug)]
pub struct Property {
    /// Its name.
    pub key: Rc<str>,
    /// Its value; for a getter `Undefined`.
    pub value: ScriptValue,
    /// Where the name is written.
    pub place: ScriptPlace,
    /// Whether the object has it on all paths.
    pub is_sure: bool,
    /// The functions that read and write it.
    pub accessors: [Option<ObjectId>; 2],
}

/// A function with its environment.
#[derive(Clone)]
pub struct Closure<'a> {
    pub(crate) code: Code<'a>,
    pub(crate) scope: ScopeId,
    pub(crate) this: Option<ScriptValue>,
    pub(crate) home: Option<ObjectId>,
    /// Index of its file.
    pub(crate) file: usize,
    pub(crate) runs: usize,
}

/// The code of a function.
#[derive(Clone, Copy)]
pub(crate) enum Code<'a> {
    Function(&'a js::Function<'a>),
    Arrow(&'a js::ArrowFunctionExpression<'a>),
}

/// A class of the program.
pub struct ScriptClass<'a> {
    pub(crate) code: &'a js::Class<'a>,
    pub(crate) base: Option<ObjectId>,
    pub(crate) scope: ScopeId,
    pub(crate) methods: Vec<Method>,
    pub(crate) constructor: Option<ObjectId>,
    /// An instance.
    pub(crate) instance: Option<ObjectId>,
}

/// A method of a class.
#[derive(Clone)]
pub(crate) struct Method {
    pub name: Rc<str>,
    pub kind: js::MethodDefinitionKind,
    pub function: ObjectId,
}

/// How sure it is that something happens.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum EventCertainty {
    /// Always when the code around it runs.
    #[default]
    Sure,
    /// If a condition is met that has no other branch.
    Guarded,
    /// In one of several branches.
    Alternative,
}

/// Something that a program does.
#[derive(Clone, Debug)]
pub struct ScriptEvent {
    /// What.
    pub kind: EventKind,
    /// The expression.
    pub place: ScriptPlace,
    /// How sure it is.
    pub certainty: EventCertainty,
    /// The number of the task in which it happens: the module is the first, each function that something else
    /// calls is another.
    pub task: usize,
}

/// What a program does.
#[derive(Clone, Debug)]
pub enum EventKind {
    /// A call of a function that is not of the program.
    Call(ForeignCall),
    /// A property is set.
    Write {
        /// Whose.
        object: ObjectId,
        /// Its name; `None` if that is not known.
        key: Option<Rc<str>>,
        /// The new value.
        value: ScriptValue,
    },
    /// A property is read that an object of the program does not have.
    Missing {
        /// The object.
        object: ObjectId,
        /// The name.
        key: Rc<str>,
        /// Whether something is read from the missing value, without `?.`.
        is_used: bool,
    },
}

/// A call of a function that is not of the program.
#[derive(Clone, Debug)]
pub struct ForeignCall {
    /// The object whose method is called.
    pub this: Option<ObjectId>,
    /// The last name of the function.
    pub name: Rc<str>,
    /// The function.
    pub callee: Option<ObjectId>,
    /// Whether it is called with `new`, or is an element of JSX.
    pub is_new: bool,
    /// The known arguments, with their places.
    pub arguments: Vec<(ScriptValue, ScriptPlace)>,
    /// Whether there may be other arguments.
    pub is_open: bool,
    /// The result.
    pub result: ObjectId,
}

impl<'a> World<'a> {
    /// An object.
    pub fn object(&self, id: ObjectId) -> Option<&ScriptObject<'a>> {
        self.objects.get(id)
    }

    /// A property of an object.
    pub fn property(&self, id: ObjectId, key: &str) -> Option<&Property> {
        self.object(id)?.properties.iter().find(|p| &*p.key == key)
    }

    /// The value of a property of an object.
    pub fn get(&self, value: &ScriptValue, key: &str) -> Option<&ScriptValue> {
        Some(&self.property(value.object()?, key)?.value)
    }

    /// The elements of an array whose length is known.
    pub fn elements(&self, value: &ScriptValue) -> Option<&[ScriptValue]> {
        let object = self.object(value.object()?)?;
        match &object.kind {
            ObjectKind::Array(elements) if !object.is_open => Some(elements),
            _ => None,
        }
    }

    /// The call whose result an object is.
    pub fn call_of(&self, id: ObjectId) -> Option<&ForeignCall> {
        match &self.object(id)?.kind {
            ObjectKind::Foreign(Source::Event(event)) => match &self.events.get(*event)?.kind {
                EventKind::Call(call) => Some(call),
                _ => None,
            },
            _ => None,
        }
    }

    /// The object and the name of the property that a foreign object is.
    pub fn member_of(&self, id: ObjectId) -> Option<(ObjectId, &str)> {
        match &self.object(id)?.kind {
            ObjectKind::Foreign(Source::Member(object, name)) => Some((*object, name)),
            _ => None,
        }
    }

    /// The package that an object comes from, and its name there: `three` and `ShaderMaterial`.
    pub fn export_of(&self, id: ObjectId) -> Option<(&str, &str)> {
        match &self.object(id)?.kind {
            ObjectKind::Foreign(Source::Package(package, name)) => Some((package, name)),
            ObjectKind::Foreign(Source::Member(object, name)) => {
                let (package, _) = self.export_of(*object)?;
                Some((package, name))
            }
            _ => None,
        }
    }

    /// Whether a class of the program declares a member.
    pub fn declares(&self, class: ObjectId, name: &str) -> bool {
        let Some(ObjectKind::Class(class)) = self.object(class).map(|o| &o.kind) else {
            return false;
        };
        class.code.body.body.iter().any(|element| {
            let key = element.property_key();
            key.and_then(|key| key.static_name())
                .is_some_and(|key| key == name)
        })
    }

    /// Whether a script names a property in a way that is not followed: as a text, or after a dot.
    pub fn is_mentioned(&self, name: &str) -> bool {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
        self.files.iter().any(|(_, text)| {
            text.match_indices(name).any(|(at, _)| {
                let before = text.get(..at).and_then(|t| t.chars().next_back());
                let after = text.get(at + name.len()..).and_then(|t| t.chars().next());
                match before {
                    Some('.') => !after.is_some_and(is_part),
                    Some(quote @ ('"' | '\'' | '`')) => after == Some(quote),
                    _ => false,
                }
            })
        })
    }

    /// The code at a place.
    pub fn code(&self, place: ScriptPlace) -> Option<&str> {
        let (_, text) = self.files.get(place.file)?;
        text.get(place.start as usize..place.end as usize)
    }

    /// The place of a name in the code at a place, such as that of a string; `None` if it is not written there.
    pub fn named(&self, place: ScriptPlace, name: &str) -> Option<ScriptPlace> {
        let code = self.code(place)?;
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
        let mut words = code.split(|c| !is_part(c)).filter(|word| *word == name);
        let start = words.next()?.as_ptr() as usize - code.as_ptr() as usize;
        let start = place.start + start as u32;
        words.next().is_none().then_some(ScriptPlace {
            start,
            end: start + name.len() as u32,
            ..place
        })
    }

    /// Whether nothing is known of an object.
    pub fn is_foreign(&self, id: ObjectId) -> bool {
        let object = self.object(id);
        object.is_none_or(|o| matches!(o.kind, ObjectKind::Foreign(_)))
    }
}
