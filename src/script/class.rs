//! Classes.

use crate::call::Arguments;
use crate::evaluator::{Evaluator, ScriptFrame};
use crate::value::{ObjectId, ScriptPlace, ScriptValue};
use crate::world::{Code, Method, ObjectKind, ScopeId, ScriptClass, Source};
use oxc_ast::ast as js;
use std::rc::Rc;

/// Maximum number of classes that extend each other.
const MAX_BASES: usize = 16;

impl<'a> Evaluator<'a, '_> {
    pub fn class(&mut self, scope: ScopeId, it: &'a js::Class<'a>) -> ScriptValue {
        let place = self.place(it.span);
        let base = match &it.heritage {
            Some(heritage) => self.expression(scope, &heritage.expression).object(),
            None => None,
        };
        let scope = self.scope(Some(scope));
        let class = ScriptClass {
            code: it,
            base,
            scope,
            methods: Vec::new(),
            constructor: None,
            instance: None,
        };
        let id = self.add(ObjectKind::Class(class), place);
        let value = ScriptValue::Object(id);
        if let Some(name) = &it.id {
            self.declare(scope, name.name.as_str(), value.clone());
        }
        self.frames.push(ScriptFrame {
            this: value.clone(),
            home: Some(id),
            results: Vec::new(),
        });
        for element in &it.body.body {
            self.class_element(scope, id, element);
        }
        self.frames.pop();
        value
    }

    fn class_element(&mut self, scope: ScopeId, id: ObjectId, it: &'a js::ClassElement<'a>) {
        match it {
            js::ClassElement::MethodDefinition(it) => {
                if it.value.body.is_none() {
                    return;
                }
                let place = self.place(it.value.span);
                let closure = self.close(Code::Function(&it.value), scope, None, place);
                let (Some(function), Some(name)) =
                    (closure.object(), self.property_key(scope, &it.key))
                else {
                    return;
                };
                if it.r#static && it.kind == js::MethodDefinitionKind::Method {
                    let place = self.key_place(&it.key);
                    return self.define(id, &name, closure, place);
                }
                let kind = it.kind;
                if let Some(class) = self.script_class(id) {
                    match kind {
                        js::MethodDefinitionKind::Constructor => class.constructor = Some(function),
                        _ => class.methods.push(Method {
                            name,
                            kind,
                            function,
                        }),
                    }
                }
            }
            js::ClassElement::PropertyDefinition(it) if it.r#static => {
                if let Some(key) = self.property_key(scope, &it.key) {
                    let value = it.value.as_ref().map(|value| self.expression(scope, value));
                    let place = self.key_place(&it.key);
                    self.define(id, &key, value.unwrap_or(ScriptValue::Undefined), place);
                }
            }
            js::ClassElement::StaticBlock(it) => {
                self.statements(scope, &it.body);
            }
            _ => {}
        }
    }

    fn script_class(&mut self, id: ObjectId) -> Option<&mut ScriptClass<'a>> {
        match &mut self.world.objects.get_mut(id)?.kind {
            ObjectKind::Class(class) => Some(class),
            _ => None,
        }
    }

    /// Makes an instance of a class of the program.
    pub fn construct(
        &mut self,
        class: ObjectId,
        arguments: Arguments,
        place: ScriptPlace,
    ) -> ScriptValue {
        let id = self.plain(place);
        if let Some(object) = self.world.objects.get_mut(id) {
            object.class = Some(class);
        }
        if let Some(known) = self.script_class(class) {
            known.instance = Some(id);
        }
        self.initialize(class, id, arguments, place);
        ScriptValue::Object(id)
    }

    /// The last instance of a class, or one that is made with unknown arguments.
    pub fn instance(&mut self, class: ObjectId) -> ScriptValue {
        let Some(known) = self.script_class(class) else {
            return ScriptValue::Undefined;
        };
        if let Some(instance) = known.instance {
            return ScriptValue::Object(instance);
        }
        let constructor = known.constructor;
        let place = self
            .world
            .object(class)
            .map_or(ScriptPlace::default(), |o| o.place);
        let closure = constructor.and_then(|id| self.closure(id));
        let count = closure.map_or(0, |closure| match closure.code {
            Code::Function(it) => it.params.items.len(),
            Code::Arrow(_) => 0,
        });
        let arguments = (0..count).map(|_| (self.unknown(place), place)).collect();
        self.construct(class, (arguments, false), place)
    }

    /// Runs the constructor of a class on an instance.
    fn initialize(
        &mut self,
        class: ObjectId,
        id: ObjectId,
        arguments: Arguments,
        place: ScriptPlace,
    ) {
        let Some(known) = self.script_class(class) else {
            return;
        };
        let (constructor, base) = (known.constructor, known.base);
        match (constructor, base) {
            (Some(constructor), None) => {
                self.fields(class, id);
                self.run(constructor, ScriptValue::Object(id), arguments.0, place);
            }
            // It calls `super`.
            (Some(constructor), Some(_)) => {
                self.run(constructor, ScriptValue::Object(id), arguments.0, place);
            }
            (None, Some(base)) => {
                self.initialize_base(base, id, arguments, place);
                self.fields(class, id);
            }
            (None, None) => self.fields(class, id),
        }
    }

    fn initialize_base(
        &mut self,
        base: ObjectId,
        id: ObjectId,
        arguments: Arguments,
        place: ScriptPlace,
    ) {
        if self.script_class(base).is_some() {
            return self.initialize(base, id, arguments, place);
        }
        let made = self.foreign_call(Some(base), (None, ""), arguments, (true, place));
        // The result of the call is the instance.
        let event = self.world.events.len();
        let source = self.world.object(made).map(|o| match &o.kind {
            ObjectKind::Foreign(source) => source.clone(),
            _ => Source::Unknown,
        });
        let found = self.world.events.iter_mut().rev().take(event.min(64));
        for event in found {
            if let crate::EventKind::Call(call) = &mut event.kind
                && call.result == made
            {
                call.result = id;
                break;
            }
        }
        if let Some(object) = self.world.objects.get_mut(id) {
            object.kind = ObjectKind::Foreign(source.unwrap_or(Source::Unknown));
        }
    }

    /// Sets the fields of a class on an instance.
    fn fields(&mut self, class: ObjectId, id: ObjectId) {
        let Some(known) = self.script_class(class) else {
            return;
        };
        let (code, scope) = (known.code, known.scope);
        let file = self.world.object(class).map_or(self.file, |o| o.place.file);
        let file = std::mem::replace(&mut self.file, file);
        self.frames.push(ScriptFrame {
            this: ScriptValue::Object(id),
            home: Some(class),
            results: Vec::new(),
        });
        for element in &code.body.body {
            if let js::ClassElement::PropertyDefinition(it) = element
                && !it.r#static
                && let Some(value) = &it.value
                && let Some(key) = self.property_key(scope, &it.key)
            {
                let value = self.expression(scope, value);
                let place = self.key_place(&it.key);
                self.define(id, &key, value, place);
            }
        }
        self.frames.pop();
        self.file = file;
    }

    /// `super(...)`
    pub fn super_call(&mut self, arguments: Arguments, place: ScriptPlace) -> ScriptValue {
        let frame = self.frames.last();
        let this = frame.map(|frame| (frame.this.clone(), frame.home));
        if let Some((ScriptValue::Object(id), Some(home))) = this
            && let Some(base) = self.script_class(home).and_then(|class| class.base)
        {
            self.initialize_base(base, id, arguments, place);
            self.fields(home, id);
        }
        ScriptValue::Undefined
    }

    /// `super.name(...)`
    pub fn super_method(
        &mut self,
        name: &str,
        arguments: Arguments,
        place: ScriptPlace,
    ) -> ScriptValue {
        let this = self.this(place);
        let home = self.frames.last().and_then(|frame| frame.home);
        let base = home.and_then(|home| self.script_class(home)?.base);
        let method =
            base.and_then(|base| self.method(base, name, js::MethodDefinitionKind::Method));
        match method {
            Some(method) => self.run(method, this, arguments.0, place),
            None => ScriptValue::Object(self.foreign_call(
                None,
                (this.object(), name),
                arguments,
                (false, place),
            )),
        }
    }

    /// A method of a class or of those that it extends.
    fn method(
        &self,
        class: ObjectId,
        name: &str,
        kind: js::MethodDefinitionKind,
    ) -> Option<ObjectId> {
        let mut class = Some(class);
        for _ in 0..MAX_BASES {
            let ObjectKind::Class(known) = &self.world.object(class?)?.kind else {
                return None;
            };
            let mut methods = known.methods.iter().rev();
            let found = methods.find(|m| &*m.name == name && m.kind == kind);
            if let Some(found) = found {
                return Some(found.function);
            }
            class = known.base;
        }
        None
    }

    /// The value that an object has from its class.
    pub fn inherited(
        &mut self,
        id: ObjectId,
        name: &str,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let object = self.world.object(id)?;
        if let (ObjectKind::Class(class), None) = (&object.kind, object.class) {
            let base = class.base?;
            return match self.world.is_foreign(base) {
                true => None,
                false => Some(self.member(&ScriptValue::Object(base), name, place)),
            };
        }
        let class = object.class?;
        if let Some(getter) = self.method(class, name, js::MethodDefinitionKind::Get) {
            return Some(self.run(getter, ScriptValue::Object(id), Vec::new(), place));
        }
        let method = self.method(class, name, js::MethodDefinitionKind::Method)?;
        Some(ScriptValue::Object(method))
    }

    /// The setter that an object has from its class.
    pub fn setter(&self, id: ObjectId, name: &Rc<str>) -> Option<ObjectId> {
        let class = self.world.object(id)?.class?;
        self.method(class, name, js::MethodDefinitionKind::Set)
    }
}
