//! The state of an evaluation: objects, scopes and names.

use crate::value::{KnownText, ObjectId, ScriptPlace, ScriptValue};
use crate::world::{
    Closure, EventCertainty, EventId, EventKind, ObjectKind, Property, ScopeId, ScriptEvent,
    ScriptObject, Source, World,
};
use oxc_allocator::Allocator;
use oxc_span::Span;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// Maximum number of expressions and statements that are evaluated.
const MAX_STEPS: usize = 120_000;
/// Maximum depth of expressions, statements and calls.
const MAX_DEPTH: usize = 120;
/// Maximum number of objects.
const MAX_OBJECTS: usize = 60_000;
/// Maximum number of rounds in which functions are called that the program does not call itself.
const MAX_ROUNDS: usize = 4;

/// Finds the modules of a program.
pub trait Loader {
    /// The file that the path in an import means, with its text.
    fn load(&self, path: &str, from: &Path) -> Option<(PathBuf, Arc<str>)>;
    /// The code of a file in which everything except its scripts is blank; `None` if it is not a script.
    fn script(&self, path: &Path, text: &str) -> Option<String>;
    /// The contents of the script element of a page with this `id`, and its `type`.
    fn element(&self, text: &str, id: &str) -> Option<(Range<usize>, String)>;
    /// The scripts of a page that are files.
    fn scripts(&self, path: &Path, text: &str) -> Vec<ExternalScript>;
}

/// A script of a page that is a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ExternalScript {
    /// Offset of its element in the page.
    pub at: usize,
    /// The path in the page.
    pub path: String,
    /// Whether it is a module.
    pub is_module: bool,
}

/// Evaluates a program and hands on what it does. Functions that nothing calls are called last, with unknown
/// arguments.
pub fn evaluate<R>(
    (path, text): (&Path, &str),
    loader: &dyn Loader,
    read: impl FnOnce(&World) -> R,
) -> Option<R> {
    let allocator = Allocator::default();
    let mut evaluator = Evaluator {
        allocator: &allocator,
        loader,
        world: World::default(),
        scopes: Vec::new(),
        modules: Vec::new(),
        globals: FxHashMap::default(),
        members: FxHashMap::default(),
        frames: Vec::new(),
        active: Vec::new(),
        logs: Vec::new(),
        deferred: Vec::new(),
        certainty: EventCertainty::Sure,
        task: 0,
        missing: None,
        loops: 0,
        file: 0,
        own_files: vec![0],
        steps: MAX_STEPS,
        depth: 0,
    };
    evaluator.module(path.to_path_buf(), text.into())?;
    for _ in 0..MAX_ROUNDS {
        if !evaluator.call_deferred() && !evaluator.call_orphans() {
            break;
        }
    }
    evaluator.world.is_cut |= evaluator.steps == 0;
    let reads = &mut evaluator.world.reads;
    reads.sort_unstable();
    reads.dedup();
    Some(read(&evaluator.world))
}

/// A variable or property that is changed.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) enum ChangedSlot<'a> {
    Variable(ScopeId, &'a str),
    Property(ObjectId, Rc<str>),
}

/// What a branch has changed, with the values before, in order.
#[derive(Default)]
pub(crate) struct ChangeLog<'a> {
    pub changes: Vec<(ChangedSlot<'a>, Option<ScriptValue>)>,
    known: FxHashSet<ChangedSlot<'a>>,
}

impl<'a> ChangeLog<'a> {
    /// Adds a change, unless there is an earlier one.
    pub fn add(&mut self, slot: ChangedSlot<'a>, old: Option<ScriptValue>) {
        if self.known.insert(slot.clone()) {
            self.changes.push((slot, old));
        }
    }
}

/// The names of a block.
pub(crate) struct NameScope<'a> {
    parent: Option<ScopeId>,
    names: FxHashMap<&'a str, ScriptValue>,
}

/// A function that is running.
pub(crate) struct ScriptFrame {
    pub this: ScriptValue,
    /// The class of the running method.
    pub home: Option<ObjectId>,
    pub results: Vec<ScriptValue>,
}

pub(crate) struct Evaluator<'a, 'r> {
    pub allocator: &'a Allocator,
    pub loader: &'r dyn Loader,
    pub world: World<'a>,
    scopes: Vec<NameScope<'a>>,
    /// The modules with the objects of their exports.
    pub modules: Vec<(PathBuf, ObjectId)>,
    globals: FxHashMap<Rc<str>, ObjectId>,
    /// The root, and the scripts of a page that are files.
    pub own_files: Vec<usize>,
    pub members: FxHashMap<(ObjectId, Rc<str>), ObjectId>,
    pub frames: Vec<ScriptFrame>,
    /// The functions that are running.
    pub active: Vec<ObjectId>,
    /// What the branches that are being evaluated have changed, with the values before.
    pub logs: Vec<ChangeLog<'a>>,
    /// Functions that were handed on.
    pub deferred: Vec<ObjectId>,
    pub certainty: EventCertainty,
    /// The number of the current task.
    pub task: usize,
    /// The last property that was missing.
    pub missing: Option<EventId>,
    /// Number of loops that are being evaluated.
    pub loops: usize,
    /// The index of the current file.
    pub file: usize,
    pub steps: usize,
    pub depth: usize,
}

impl<'a> Evaluator<'a, '_> {
    /// Runs something that nests, unless a budget is used up.
    pub fn nested<R>(&mut self, run: impl FnOnce(&mut Self) -> R) -> Option<R> {
        self.steps = self.steps.saturating_sub(1);
        let is_full = self.world.objects.len() > MAX_OBJECTS;
        if self.steps == 0 || self.depth >= MAX_DEPTH || is_full {
            self.world.is_cut = true;
            return None;
        }
        self.depth += 1;
        let result = run(self);
        self.depth -= 1;
        Some(result)
    }

    pub fn place(&self, span: Span) -> ScriptPlace {
        ScriptPlace {
            file: self.file,
            start: span.start,
            end: span.end,
        }
    }

    /// Adds an object.
    pub fn add(&mut self, kind: ObjectKind<'a>, place: ScriptPlace) -> ObjectId {
        self.world.objects.push(ScriptObject {
            kind,
            place,
            properties: Vec::new(),
            is_open: false,
            class: None,
        });
        self.world.objects.len() - 1
    }

    /// A value of which nothing is known.
    pub fn unknown(&mut self, place: ScriptPlace) -> ScriptValue {
        ScriptValue::Object(self.add(ObjectKind::Foreign(Source::Unknown), place))
    }

    pub fn plain(&mut self, place: ScriptPlace) -> ObjectId {
        self.add(ObjectKind::Plain, place)
    }

    pub fn array(&mut self, elements: Vec<ScriptValue>, place: ScriptPlace) -> ScriptValue {
        ScriptValue::Object(self.add(ObjectKind::Array(elements), place))
    }

    /// Makes an object one that may have other properties or elements.
    pub fn open(&mut self, value: &ScriptValue) {
        if let Some(object) = value.object().and_then(|id| self.world.objects.get_mut(id)) {
            object.is_open = true;
        }
    }

    /// Records an event.
    pub fn record(&mut self, kind: EventKind, place: ScriptPlace) -> EventId {
        self.world.events.push(ScriptEvent {
            kind,
            place,
            certainty: self.certainty,
            task: self.task,
        });
        self.world.events.len() - 1
    }

    pub fn closure(&self, id: ObjectId) -> Option<&Closure<'a>> {
        match &self.world.objects.get(id)?.kind {
            ObjectKind::Function(closure) => Some(closure),
            _ => None,
        }
    }

    /// A scope in another.
    pub fn scope(&mut self, parent: Option<ScopeId>) -> ScopeId {
        self.scopes.push(NameScope {
            parent,
            names: FxHashMap::default(),
        });
        self.scopes.len() - 1
    }

    /// Declares a name.
    pub fn declare(&mut self, scope: ScopeId, name: &'a str, value: ScriptValue) {
        if let Some(scope) = self.scopes.get_mut(scope) {
            scope.names.insert(name, value);
        }
    }

    /// The scope that declares a name.
    fn declaring(&self, scope: ScopeId, name: &str) -> Option<ScopeId> {
        let mut current = Some(scope);
        while let Some(id) = current {
            let scope = self.scopes.get(id)?;
            if scope.names.contains_key(name) {
                return Some(id);
            }
            current = scope.parent;
        }
        None
    }

    /// The value of a name.
    pub fn name(&mut self, scope: ScopeId, name: &str, place: ScriptPlace) -> ScriptValue {
        if name == "undefined" {
            return ScriptValue::Undefined;
        }
        let declaring = self.declaring(scope, name);
        let declared = declaring.and_then(|id| self.scopes.get(id)?.names.get(name));
        match declared {
            Some(value) => value.clone(),
            None => ScriptValue::Object(self.global(name, place)),
        }
    }

    /// The object of a global name.
    pub fn global(&mut self, name: &str, place: ScriptPlace) -> ObjectId {
        if let Some(id) = self.globals.get(name) {
            return *id;
        }
        let name: Rc<str> = name.into();
        let id = self.add(ObjectKind::Foreign(Source::Global(name.clone())), place);
        self.globals.insert(name, id);
        id
    }

    /// Assigns to a name.
    pub fn set_name(&mut self, scope: ScopeId, name: &'a str, value: ScriptValue) {
        if let Some(scope) = self.declaring(scope, name) {
            self.set(
                ChangedSlot::Variable(scope, name),
                Some(value),
                ScriptPlace::default(),
            );
        }
    }

    /// The value of a slot.
    pub fn slot(&self, slot: &ChangedSlot<'a>) -> Option<ScriptValue> {
        match slot {
            ChangedSlot::Variable(scope, name) => self.scopes.get(*scope)?.names.get(name).cloned(),
            ChangedSlot::Property(object, key) => {
                Some(self.world.property(*object, key)?.value.clone())
            }
        }
    }

    /// Changes a slot, or removes it, and remembers that for the branch that is being evaluated.
    pub fn set(&mut self, slot: ChangedSlot<'a>, value: Option<ScriptValue>, place: ScriptPlace) {
        let old = self.slot(&slot);
        if let Some(log) = self.logs.last_mut() {
            log.add(slot.clone(), old);
        }
        self.put(&slot, value, place);
    }

    /// Changes a slot, or removes it.
    pub fn put(&mut self, slot: &ChangedSlot<'a>, value: Option<ScriptValue>, place: ScriptPlace) {
        match slot {
            ChangedSlot::Variable(scope, name) => {
                if let (Some(scope), Some(value)) = (self.scopes.get_mut(*scope), value) {
                    scope.names.insert(name, value);
                }
            }
            ChangedSlot::Property(object, key) => {
                let is_sure = self.logs.is_empty();
                let Some(object) = self.world.objects.get_mut(*object) else {
                    return;
                };
                let known = object.properties.iter().position(|p| p.key == *key);
                match (known, value) {
                    (Some(index), Some(value)) => {
                        if let Some(property) = object.properties.get_mut(index) {
                            property.value = value;
                        }
                    }
                    (Some(index), None) => {
                        object.properties.remove(index);
                    }
                    (None, Some(value)) => object.properties.push(Property {
                        key: key.clone(),
                        value,
                        place,
                        is_sure,
                        accessors: [None, None],
                    }),
                    (None, None) => {}
                }
            }
        }
    }

    /// Sets a property of a new object, which no branch shares.
    pub fn define(&mut self, object: ObjectId, key: &str, value: ScriptValue, place: ScriptPlace) {
        self.put(
            &ChangedSlot::Property(object, key.into()),
            Some(value),
            place,
        );
        let object = self.world.objects.get_mut(object);
        let property = object.and_then(|o| o.properties.iter_mut().find(|p| &*p.key == key));
        if let Some(property) = property {
            property.is_sure = true;
            property.place = place;
        }
    }

    /// The value of a property.
    pub fn member(&mut self, value: &ScriptValue, key: &str, place: ScriptPlace) -> ScriptValue {
        let id = match value {
            ScriptValue::Object(id) => match self.element_part(*id, key, place) {
                Some(part) => return part,
                None => *id,
            },
            ScriptValue::Text(text) if key == "length" && !text.is_open => {
                return ScriptValue::Number(
                    text.content.chars().map(char::len_utf16).sum::<usize>() as f64,
                );
            }
            _ => return self.unknown(place),
        };
        self.world.reads.push((id, place));
        if let Some(property) = self.world.property(id, key).cloned() {
            return match property.accessors {
                [Some(getter), _] => self.run(getter, ScriptValue::Object(id), Vec::new(), place),
                [None, Some(_)] => ScriptValue::Undefined,
                _ => property.value,
            };
        }
        if let Some(found) = self.inherited(id, key, place) {
            return found;
        }
        let Some(object) = self.world.object(id) else {
            return ScriptValue::Undefined;
        };
        match &object.kind {
            ObjectKind::Array(elements) => {
                let is_open = object.is_open;
                let found = match key {
                    "length" => Some(ScriptValue::Number(elements.len() as f64)),
                    _ => key
                        .parse()
                        .ok()
                        .and_then(|at: usize| elements.get(at).cloned()),
                };
                match found {
                    Some(found) if !is_open || key != "length" => found,
                    _ if is_open => self.child(id, key, place),
                    _ => ScriptValue::Undefined,
                }
            }
            ObjectKind::Plain if !object.is_open && object.class.is_none() => {
                let kind = EventKind::Missing {
                    object: id,
                    key: key.into(),
                    is_used: false,
                };
                self.missing = Some(self.record(kind, place));
                ScriptValue::Undefined
            }
            ObjectKind::Plain if !object.is_open => ScriptValue::Undefined,
            _ => self.child(id, key, place),
        }
    }

    /// The part that an object was made from: `mesh.material` of `new Mesh(geometry, material)`.
    fn given_part(&self, id: ObjectId, key: &str) -> Option<ScriptValue> {
        let call = self.world.call_of(id).filter(|call| call.is_new)?;
        let count = call.arguments.len();
        let index = match key {
            "material" if count > 0 => count.min(2) - 1,
            "geometry" if count > 1 => 0,
            _ => return None,
        };
        let (value, _) = call.arguments.get(index)?;
        let object = self.world.object(value.object()?)?;
        let is_made = matches!(object.kind, ObjectKind::Foreign(Source::Event(_)));
        is_made.then(|| value.clone())
    }

    /// A property of an object of which nothing is known; the same each time.
    fn child(&mut self, id: ObjectId, key: &str, place: ScriptPlace) -> ScriptValue {
        if let Some(given) = self.given_part(id, key) {
            return given;
        }
        let key: Rc<str> = key.into();
        if let Some(child) = self.members.get(&(id, key.clone())) {
            return ScriptValue::Object(*child);
        }
        let child = self.add(ObjectKind::Foreign(Source::Member(id, key.clone())), place);
        self.members.insert((id, key), child);
        ScriptValue::Object(child)
    }

    /// Sets a property.
    pub fn write(
        &mut self,
        target: &ScriptValue,
        key: Option<Rc<str>>,
        value: ScriptValue,
        place: ScriptPlace,
    ) {
        let ScriptValue::Object(id) = target else {
            return;
        };
        let id = *id;
        let kind = EventKind::Write {
            object: id,
            key: key.clone(),
            value: value.clone(),
        };
        let Some(key) = key else {
            self.record(kind, place);
            return self.open(target);
        };
        let setter = self.world.property(id, &key).and_then(|p| p.accessors[1]);
        if let Some(setter) = setter.or_else(|| self.setter(id, &key)) {
            self.run(setter, ScriptValue::Object(id), vec![(value, place)], place);
            return;
        }
        self.record(kind, place);
        let is_branch = !self.logs.is_empty();
        if let Some(ObjectKind::Array(elements)) =
            self.world.objects.get_mut(id).map(|o| &mut o.kind)
        {
            match key.parse().ok().and_then(|at: usize| elements.get_mut(at)) {
                Some(element) if !is_branch => *element = value,
                _ => self.open(target),
            }
            return;
        }
        self.set(ChangedSlot::Property(id, key), Some(value), place);
    }

    /// A text, or its unknown value.
    pub fn as_text(&self, value: &ScriptValue) -> KnownText {
        match value {
            ScriptValue::Text(text) => (**text).clone(),
            ScriptValue::Number(number) => KnownText::made(format!("{number}")),
            ScriptValue::Bool(flag) => KnownText::made(flag.to_string()),
            ScriptValue::Null => KnownText::made("null".to_string()),
            ScriptValue::Undefined => KnownText::made("undefined".to_string()),
            ScriptValue::Any(_) | ScriptValue::Object(_) => KnownText::unknown(),
        }
    }

    /// The name of the property that a value selects, if it is known.
    pub fn key(&self, value: &ScriptValue) -> Option<Rc<str>> {
        let text = self.as_text(value);
        (!text.is_open).then(|| text.content.into())
    }
}
