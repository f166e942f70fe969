//! Calls.

use crate::branch::StatementEnd;
use crate::evaluator::{Evaluator, ScriptFrame};
use crate::value::{ObjectId, ScriptPlace, ScriptValue};
use crate::world::{Code, EventKind, ForeignCall, ObjectKind, ScopeId, Source};
use oxc_ast::ast as js;
use oxc_span::GetSpan;
use std::rc::Rc;

/// Maximum number of calls of a function in a call of itself.
const MAX_RECURSION: usize = 2;
/// Functions of libraries that call a function at once.
const AT_ONCE: &[&str] = &[
    "map", "forEach", "filter", "some", "every", "reduce", "flatMap", "find", "sort", "then",
    "from", "replace", "finally",
];

/// The arguments of a call, and whether there may be others.
pub(crate) type Arguments = (Vec<(ScriptValue, ScriptPlace)>, bool);

impl<'a> Evaluator<'a, '_> {
    pub fn arguments(&mut self, scope: ScopeId, all: &'a [js::Argument<'a>]) -> Arguments {
        let mut values = Vec::new();
        let mut is_open = false;
        for argument in all {
            let place = self.place(argument.span());
            match argument {
                js::Argument::SpreadElement(spread) => {
                    let value = self.expression(scope, &spread.argument);
                    let (known, has_more) = self.iterated(&value);
                    values.extend(known.into_iter().map(|value| (value, place)));
                    is_open |= has_more;
                }
                other => {
                    if let Some(expression) = other.as_expression() {
                        values.push((self.expression(scope, expression), place));
                    }
                }
            }
        }
        (values, is_open)
    }

    pub fn call_expression(
        &mut self,
        scope: ScopeId,
        it: &'a js::CallExpression<'a>,
    ) -> ScriptValue {
        let place = self.place(it.span);
        let member = it.callee.as_member_expression();
        let member = member.or(match &it.callee {
            js::Expression::ChainExpression(chain) => chain.expression.as_member_expression(),
            _ => None,
        });
        if let js::Expression::Super(_) = &it.callee {
            let arguments = self.arguments(scope, &it.arguments);
            return self.super_call(arguments, place);
        }
        let Some(member) = member else {
            let callee = self.expression(scope, &it.callee);
            let arguments = self.arguments(scope, &it.arguments);
            if let (js::Expression::Identifier(name), Some((ScriptValue::Text(path), _))) =
                (&it.callee, arguments.0.first())
                && name.name == "require"
                && self.is_global(&callee)
            {
                let path = path.content.clone();
                return self.import(&path, place);
            }
            let name = match &it.callee {
                js::Expression::Identifier(name) => name.name.as_str(),
                _ => "",
            };
            return self.call(&callee, (None, name), arguments, place);
        };
        if let js::Expression::Super(_) = member.object() {
            let (key, _) = self.member_key(scope, member);
            let arguments = self.arguments(scope, &it.arguments);
            return self.super_method(key.as_deref().unwrap_or(""), arguments, place);
        }
        let object = self.expression(scope, member.object());
        self.use_missing(&object, member.object().span(), member.optional());
        let (key, key_place) = self.member_key(scope, member);
        let arguments = self.arguments(scope, &it.arguments);
        let key = key.unwrap_or_default();
        if let Some(value) = self.built_in(&object, &key, &arguments, place) {
            return value;
        }
        let callee = match object.primitive() {
            Some(_) => self.unknown(key_place),
            None => self.member(&object, &key, key_place),
        };
        self.missing = None;
        self.call(&callee, (Some(object), &key), arguments, place)
    }

    fn is_global(&self, value: &ScriptValue) -> bool {
        let object = value.object().and_then(|id| self.world.object(id));
        object.is_some_and(|o| matches!(o.kind, ObjectKind::Foreign(Source::Global(_))))
    }

    pub fn new_expression(&mut self, scope: ScopeId, it: &'a js::NewExpression<'a>) -> ScriptValue {
        let place = self.place(it.span);
        let callee = self.expression(scope, &it.callee);
        let arguments = self.arguments(scope, &it.arguments);
        let Some(id) = callee.object() else {
            return self.unknown(place);
        };
        match self.world.object(id).map(|o| &o.kind) {
            Some(ObjectKind::Class(_)) => self.construct(id, arguments, place),
            Some(ObjectKind::Function(_)) => {
                let this = self.plain(place);
                let this = ScriptValue::Object(this);
                let result = self.run(id, this.clone(), arguments.0, place);
                self.open(&this);
                match result {
                    ScriptValue::Object(_) => result,
                    _ => this,
                }
            }
            _ => {
                let name = match it.callee.as_member_expression() {
                    Some(member) => member.static_property_name().unwrap_or(""),
                    None => match &it.callee {
                        js::Expression::Identifier(name) => name.name.as_str(),
                        _ => "",
                    },
                };
                if name == "Array" && self.is_global(&callee) {
                    return self.new_array(&arguments, place);
                }
                let id = self.foreign_call(Some(id), (None, name), arguments, (true, place));
                ScriptValue::Object(id)
            }
        }
    }

    /// Calls a value.
    pub fn call(
        &mut self,
        callee: &ScriptValue,
        (this, name): (Option<ScriptValue>, &str),
        arguments: Arguments,
        place: ScriptPlace,
    ) -> ScriptValue {
        let Some(id) = callee.object() else {
            return self.unknown(place);
        };
        match self.world.object(id).map(|o| &o.kind) {
            Some(ObjectKind::Function(_)) => {
                let this = this.unwrap_or(ScriptValue::Undefined);
                self.run(id, this, arguments.0, place)
            }
            Some(ObjectKind::Foreign(_)) => {
                if this.is_none()
                    && let Some(value) = self.global_function(id, &arguments, place)
                {
                    return value;
                }
                let this = this.and_then(|value| value.object());
                ScriptValue::Object(self.foreign_call(
                    Some(id),
                    (this, name),
                    arguments,
                    (false, place),
                ))
            }
            _ => self.unknown(place),
        }
    }

    /// Calls a function that is not of the program. Functions in its arguments are called later.
    pub fn foreign_call(
        &mut self,
        callee: Option<ObjectId>,
        (this, name): (Option<ObjectId>, &str),
        (arguments, is_open): Arguments,
        (is_new, place): (bool, ScriptPlace),
    ) -> ObjectId {
        let arguments = match name {
            "loadShader" => self.loaded(arguments),
            _ if name.ends_with("FromScripts") => self.elements_of(arguments, place),
            _ => arguments,
        };
        let event = self.world.events.len();
        let result = self.add(ObjectKind::Foreign(Source::Event(event)), place);
        let export = callee.and_then(|id| self.world.export_of(id));
        let exported = export.filter(|(_, n)| *n != "*" && *n != "default");
        let call = ForeignCall {
            this,
            name: match exported {
                Some((_, exported)) => exported.into(),
                None => name.into(),
            },
            callee,
            is_new,
            arguments,
            is_open,
            result,
        };
        let functions: Vec<ObjectId> = call.arguments.iter().filter_map(|a| a.0.object()).collect();
        self.record(EventKind::Call(call), place);
        let is_at_once = AT_ONCE.contains(&name);
        for function in functions {
            if self.closure(function).is_some() {
                match is_at_once {
                    true => {
                        self.run_unknown(function, None);
                    }
                    false => self.deferred.push(function),
                }
            }
        }
        result
    }

    /// The texts of the elements that arguments name, also in an array.
    fn elements_of(
        &mut self,
        arguments: Vec<(ScriptValue, ScriptPlace)>,
        place: ScriptPlace,
    ) -> Vec<(ScriptValue, ScriptPlace)> {
        let text = |e: &Self, value: &ScriptValue| {
            let found = value.text().and_then(|id| e.page_element(id));
            found.unwrap_or_else(|| value.clone())
        };
        let mut found = Vec::new();
        for (value, at) in arguments {
            let all = self.world.elements(&value).map(<[ScriptValue]>::to_vec);
            let value = match all {
                Some(all) => {
                    let all = all.iter().map(|one| text(self, one)).collect();
                    self.array(all, place)
                }
                None => text(self, &value),
            };
            found.push((value, at));
        }
        found
    }

    /// The texts of the files that arguments name.
    fn loaded(
        &mut self,
        arguments: Vec<(ScriptValue, ScriptPlace)>,
    ) -> Vec<(ScriptValue, ScriptPlace)> {
        let load = |(value, place): (ScriptValue, ScriptPlace)| {
            let path = value.text().map(str::to_string);
            let module = path.map(|path| self.import(&path, place));
            let text = module.and_then(|module| self.world.get(&module, "default").cloned());
            (text.unwrap_or(value), place)
        };
        arguments.into_iter().map(load).collect()
    }

    /// Calls a function with unknown arguments.
    pub fn run_unknown(&mut self, id: ObjectId, this: Option<ScriptValue>) -> ScriptValue {
        let Some(closure) = self.closure(id) else {
            return ScriptValue::Undefined;
        };
        let (place, count) = (
            ScriptPlace {
                file: closure.file,
                ..ScriptPlace::default()
            },
            match closure.code {
                Code::Function(it) => it.params.items.len(),
                Code::Arrow(it) => it.params.items.len(),
            },
        );
        let arguments = (0..count).map(|_| (self.unknown(place), place)).collect();
        let this = this.unwrap_or_else(|| self.unknown(place));
        self.run(id, this, arguments, place)
    }

    /// Calls a function of the program.
    pub fn run(
        &mut self,
        id: ObjectId,
        this: ScriptValue,
        arguments: Vec<(ScriptValue, ScriptPlace)>,
        place: ScriptPlace,
    ) -> ScriptValue {
        let Some(closure) = self.closure(id).cloned() else {
            return self.unknown(place);
        };
        let is_active = self.active.iter().filter(|active| **active == id).count() >= MAX_RECURSION;
        if is_active {
            return self.unknown(place);
        }
        if let Some(ObjectKind::Function(closure)) =
            self.world.objects.get_mut(id).map(|o| &mut o.kind)
        {
            closure.runs += 1;
        }
        self.active.push(id);
        let file = std::mem::replace(&mut self.file, closure.file);
        self.frames.push(ScriptFrame {
            this: closure.this.clone().unwrap_or(this),
            home: closure.home,
            results: Vec::new(),
        });
        let scope = self.scope(Some(closure.scope));
        let ran = self.nested(|e| e.body(scope, closure.code, arguments));
        let frame = self.frames.pop();
        self.file = file;
        self.active.pop();
        if ran.is_none() {
            return self.unknown(place);
        }
        let results = frame.map_or(Vec::new(), |frame| frame.results);
        let mut joined: Option<ScriptValue> = None;
        for result in results {
            joined = Some(match joined {
                Some(other) => self.join(other, result),
                None => result,
            });
        }
        joined.unwrap_or(ScriptValue::Undefined)
    }

    fn body(&mut self, scope: ScopeId, code: Code<'a>, arguments: Vec<(ScriptValue, ScriptPlace)>) {
        let parameters = match code {
            Code::Function(it) => &it.params,
            Code::Arrow(it) => &it.params,
        };
        let mut arguments = arguments.into_iter();
        for parameter in &parameters.items {
            let value = arguments
                .next()
                .map_or(ScriptValue::Undefined, |(value, _)| value);
            let value = match (&value, &parameter.initializer) {
                (ScriptValue::Undefined, Some(default)) => self.expression(scope, default),
                _ => value,
            };
            // `constructor(private gl: ...)` sets the property.
            if parameter.accessibility.is_some()
                && let js::BindingPattern::BindingIdentifier(name) = &parameter.pattern
            {
                let place = self.place(name.span);
                let this = self.this(place);
                self.write(
                    &this,
                    Some(Rc::from(name.name.as_str())),
                    value.clone(),
                    place,
                );
            }
            self.bind(scope, &parameter.pattern, value);
        }
        if let Some(rest) = &parameters.rest {
            let rest_values = arguments.map(|(value, _)| value).collect();
            let array = self.array(rest_values, self.place(rest.span));
            self.bind(scope, &rest.rest.argument, array);
        }
        match code {
            Code::Function(it) => {
                if let Some(body) = &it.body {
                    self.statements(scope, &body.statements);
                }
            }
            Code::Arrow(it) => match &it.body {
                js::ArrowFunctionBody::FunctionBody(body) => {
                    self.statements(scope, &body.statements);
                }
                other => {
                    if let Some(expression) = other.as_expression() {
                        let value = self.expression(scope, expression);
                        if let Some(frame) = self.frames.last_mut() {
                            frame.results.push(value);
                        }
                    }
                }
            },
        }
    }

    /// Calls the functions that were handed on. `false` if there are none.
    pub fn call_deferred(&mut self) -> bool {
        let mut any = false;
        while !self.deferred.is_empty() {
            for function in std::mem::take(&mut self.deferred) {
                if self.closure(function).is_some_and(|c| c.runs == 0) {
                    self.task += 1;
                    self.run_unknown(function, None);
                    any = true;
                }
            }
        }
        any
    }

    /// Calls the functions, and makes instances of the classes, that nothing in the program uses. `false` if there
    /// are none.
    pub fn call_orphans(&mut self) -> bool {
        let mut any = false;
        for id in 0..self.world.objects.len() {
            let Some(object) = self.world.objects.get(id) else {
                continue;
            };
            // Those of other files are called when these are the root.
            if !self.own_files.contains(&object.place.file) {
                continue;
            }
            self.task += 1;
            let is_root = object.place.file == 0;
            match &object.kind {
                // A page need not use all classes of its script files.
                ObjectKind::Function(closure) if !is_root && closure.home.is_some() => {}
                ObjectKind::Class(_) if !is_root => {}
                ObjectKind::Function(closure) if closure.runs == 0 => {
                    let this = closure.home.map(|home| self.instance(home));
                    self.run_unknown(id, this);
                    any = true;
                }
                ObjectKind::Class(class) if class.instance.is_none() => {
                    self.instance(id);
                    any = true;
                }
                _ => {}
            }
        }
        any
    }

    /// Evaluates an expression of a callback as if it were called once for an unknown element.
    pub fn once_for_others(&mut self, function: ObjectId) {
        let mut way = |e: &mut Self| (StatementEnd::Next, e.run_unknown(function, None));
        self.ways(&mut [&mut way]);
    }
}
