//! Functions of the language: of arrays, objects and texts.

use crate::call::Arguments;
use crate::evaluator::Evaluator;
use crate::value::{KnownText, ObjectId, Primitive, ScriptPlace, ScriptValue};
use crate::world::{ObjectKind, Source};
use std::rc::Rc;

/// Maximum number of elements of an array that is made at once.
const MAX_ELEMENTS: usize = 64;

fn text(text: KnownText) -> ScriptValue {
    ScriptValue::Text(Rc::new(text))
}

impl Evaluator<'_, '_> {
    /// The result of a method of the language; `None` if the object or the method is another.
    pub fn built_in(
        &mut self,
        object: &ScriptValue,
        name: &str,
        arguments: &Arguments,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let first = arguments.0.first().map(|(value, _)| value.clone());
        if let Some(function) = self.own_function(first.as_ref())
            && name == "then"
            && !object.object().is_some_and(|id| self.world.is_foreign(id))
        {
            return Some(self.run(
                function,
                ScriptValue::Undefined,
                vec![(object.clone(), place)],
                place,
            ));
        }
        match object {
            ScriptValue::Text(known) => self.text_method(known, name, arguments, place),
            ScriptValue::Object(id) => match &self.world.object(*id)?.kind {
                ObjectKind::Array(_) => self.array_method(*id, name, arguments, place),
                ObjectKind::Function(_) => {
                    let rest = arguments.0.iter().skip(1).cloned().collect();
                    let this = first.unwrap_or(ScriptValue::Undefined);
                    match name {
                        "call" => Some(self.run(*id, this, rest, place)),
                        "bind" => Some(object.clone()),
                        _ => None,
                    }
                }
                // A copy has the same parts and the same type.
                ObjectKind::Foreign(Source::Event(_))
                    if name == "clone" && arguments.0.is_empty() =>
                {
                    Some(object.clone())
                }
                ObjectKind::Foreign(Source::Global(global)) => {
                    let global = global.clone();
                    self.static_function(&global, name, arguments, place)
                }
                _ => None,
            },
            _ => None,
        }
    }

    fn own_function(&self, value: Option<&ScriptValue>) -> Option<ObjectId> {
        value?.object().filter(|id| self.closure(*id).is_some())
    }

    /// `Object.keys` and the like.
    fn static_function(
        &mut self,
        global: &str,
        name: &str,
        (arguments, _): &Arguments,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let first = arguments.first().map(|(value, _)| value.clone());
        match (global, name) {
            ("Math", _) | ("Date" | "performance", "now") | ("Number", _) => {
                Some(ScriptValue::Any(Primitive::Number))
            }
            ("Array", "isArray") => {
                let id = first?.object()?;
                match self.world.is_foreign(id) {
                    true => Some(ScriptValue::Any(Primitive::Bool)),
                    false => {
                        let kind = &self.world.object(id)?.kind;
                        Some(ScriptValue::Bool(matches!(kind, ObjectKind::Array(_))))
                    }
                }
            }
            ("Array", "from") => self.array_from(arguments, place),
            ("Promise", "all" | "resolve") | ("Object", "freeze" | "seal") => first,
            ("Object", "defineProperty" | "defineProperties") => {
                let target = first?;
                self.open(&target);
                Some(target)
            }
            ("Object", "assign") => {
                let target = first?;
                for (source, _) in arguments.iter().skip(1) {
                    self.copy_to(&target, source);
                }
                Some(target)
            }
            ("Object", "keys" | "values" | "entries") => {
                let object = first?;
                let (keys, is_open) = self.keys(&object);
                let mut all = Vec::new();
                for key in keys {
                    let value = self.world.get(&object, key.text()?).cloned();
                    let value = value.unwrap_or(ScriptValue::Undefined);
                    all.push(match name {
                        "keys" => key,
                        "values" => value,
                        _ => self.array(vec![key, value], place),
                    });
                }
                let array = self.array(all, place);
                if is_open {
                    self.open(&array);
                }
                Some(array)
            }
            ("Object", "fromEntries") => {
                let (entries, is_open) = self.iterated(&first?);
                let id = self.plain(place);
                let object = ScriptValue::Object(id);
                if is_open {
                    self.open(&object);
                }
                for entry in entries {
                    let pair = self.world.elements(&entry).map(<[ScriptValue]>::to_vec);
                    match pair.as_deref() {
                        Some([key, value]) if self.key(key).is_some() => {
                            let key = self.as_text(key);
                            let written = key.first_place().unwrap_or(place);
                            self.define(id, &key.content, value.clone(), written);
                        }
                        _ => self.open(&object),
                    }
                }
                Some(object)
            }
            _ => None,
        }
    }

    /// Sets the properties of a value on another.
    fn copy_to(&mut self, target: &ScriptValue, source: &ScriptValue) {
        let object = source.object().and_then(|id| self.world.object(id));
        let is_known = object.is_some_and(|o| matches!(o.kind, ObjectKind::Plain) && !o.is_open);
        let properties = object.map_or(Vec::new(), |o| o.properties.clone());
        for property in properties {
            self.write(target, Some(property.key), property.value, property.place);
        }
        if !is_known {
            self.open(target);
        }
    }

    fn array_from(
        &mut self,
        arguments: &[(ScriptValue, ScriptPlace)],
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let (source, _) = arguments.first()?;
        let length = self
            .world
            .get(source, "length")
            .and_then(ScriptValue::number);
        let (elements, is_open) = match length {
            Some(length) if (length as usize) <= MAX_ELEMENTS => {
                (vec![ScriptValue::Undefined; length as usize], false)
            }
            Some(_) => (Vec::new(), true),
            None => self.iterated(source),
        };
        let array = self.array(elements, place);
        if is_open {
            self.open(&array);
        }
        match arguments.get(1) {
            Some((function, _)) => {
                let function = (vec![(function.clone(), place)], false);
                self.array_method(array.object()?, "map", &function, place)
            }
            None => Some(array),
        }
    }

    /// `new Array(n)`
    pub fn new_array(
        &mut self,
        (arguments, is_open): &Arguments,
        place: ScriptPlace,
    ) -> ScriptValue {
        let length = match arguments.as_slice() {
            [(ScriptValue::Number(n), _)] if *n >= 0.0 && (*n as usize) <= MAX_ELEMENTS => {
                Some(*n as usize)
            }
            _ => None,
        };
        let array = self.array(vec![ScriptValue::Undefined; length.unwrap_or(0)], place);
        if length.is_none() || *is_open {
            self.open(&array);
        }
        array
    }

    fn array_method(
        &mut self,
        id: ObjectId,
        name: &str,
        arguments: &Arguments,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let array = ScriptValue::Object(id);
        let (elements, is_open) = self.iterated(&array);
        let first = arguments.0.first().map(|(value, _)| value.clone());
        match name {
            "push" | "unshift" | "splice" | "fill" | "pop" | "shift" | "reverse" | "sort" => {
                self.change_array(id, name, arguments)
            }
            "map" | "forEach" | "flatMap" | "filter" | "some" | "every" | "find" | "reduce" => {
                let function = self.own_function(first.as_ref())?;
                self.for_elements(name, function, (elements, is_open), place)
            }
            "concat" | "slice" | "flat" => {
                let mut all = elements;
                let mut has_more = is_open || name == "flat" && !arguments.0.is_empty();
                match (name, first) {
                    ("concat", _) => {
                        for (value, _) in &arguments.0 {
                            let (mut known, other) = self.iterated(value);
                            all.append(&mut known);
                            has_more |= other;
                        }
                    }
                    ("slice", None) => {}
                    ("slice", Some(ScriptValue::Number(n)))
                        if n >= 0.0 && arguments.0.len() == 1 =>
                    {
                        all.drain(..(n as usize).min(all.len()));
                    }
                    _ => has_more = true,
                }
                let array = self.array(all, place);
                if has_more {
                    self.open(&array);
                }
                Some(array)
            }
            "join" => {
                let separator =
                    first.map_or(KnownText::made(",".to_string()), |v| self.as_text(&v));
                let mut joined = KnownText::default();
                joined.is_open = is_open;
                for (index, element) in elements.iter().enumerate() {
                    if index > 0 {
                        joined.push(&separator);
                    }
                    joined.push(&self.as_text(element));
                }
                Some(text(joined))
            }
            "entries" => {
                let pairs = elements.into_iter().enumerate();
                let pairs = pairs
                    .map(|(index, value)| {
                        self.array(vec![ScriptValue::Number(index as f64), value], place)
                    })
                    .collect();
                let array = self.array(pairs, place);
                if is_open {
                    self.open(&array);
                }
                Some(array)
            }
            "values" => Some(array),
            "includes" => Some(ScriptValue::Any(Primitive::Bool)),
            "indexOf" | "findIndex" => Some(ScriptValue::Any(Primitive::Number)),
            _ => None,
        }
    }

    /// A method that changes an array.
    fn change_array(
        &mut self,
        id: ObjectId,
        name: &str,
        arguments: &Arguments,
    ) -> Option<ScriptValue> {
        let array = ScriptValue::Object(id);
        let is_shared = !self.logs.is_empty();
        let Some(ObjectKind::Array(own)) = self.world.objects.get_mut(id).map(|o| &mut o.kind)
        else {
            return None;
        };
        match (name, arguments.0.first()) {
            ("push", _) if !is_shared && own.len() < MAX_ELEMENTS * 16 => {
                own.extend(arguments.0.iter().map(|(value, _)| value.clone()));
            }
            ("fill", Some((value, _))) if !is_shared => own.fill(value.clone()),
            _ => self.open(&array),
        }
        if arguments.1 {
            self.open(&array);
        }
        Some(array)
    }

    /// Calls a function for each element.
    fn for_elements(
        &mut self,
        name: &str,
        function: ObjectId,
        (elements, is_open): (Vec<ScriptValue>, bool),
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let is_long = elements.len() > MAX_ELEMENTS;
        let mut results = Vec::new();
        for (index, element) in elements.into_iter().take(MAX_ELEMENTS).enumerate() {
            let index = ScriptValue::Number(index as f64);
            let arguments = match name {
                "reduce" => vec![
                    (self.unknown(place), place),
                    (element, place),
                    (index, place),
                ],
                _ => vec![(element, place), (index, place)],
            };
            results.push(self.run(function, ScriptValue::Undefined, arguments, place));
        }
        if is_open {
            self.once_for_others(function);
        }
        match name {
            "map" => {
                let array = self.array(results, place);
                if is_open || is_long {
                    self.open(&array);
                }
                Some(array)
            }
            "forEach" => Some(ScriptValue::Undefined),
            "some" | "every" => Some(ScriptValue::Any(Primitive::Bool)),
            "find" | "reduce" => Some(self.unknown(place)),
            _ => {
                let array = self.array(Vec::new(), place);
                self.open(&array);
                Some(array)
            }
        }
    }

    fn text_method(
        &mut self,
        known: &Rc<KnownText>,
        name: &str,
        (arguments, _): &Arguments,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let argument = |index: usize| arguments.get(index).map(|(value, _)| value);
        let content = &known.content;
        match name {
            "replace" | "replaceAll" => self.replaced(known, name, arguments),
            "trim" | "trimStart" | "trimEnd" => {
                let start = match name {
                    "trimEnd" => 0,
                    _ => content.len() - content.trim_start().len(),
                };
                let end = match name {
                    "trimStart" => content.len(),
                    _ => content.trim_end().len(),
                };
                Some(text(known.slice(start..end.max(start))))
            }
            "concat" => {
                let mut all = (**known).clone();
                for (value, _) in arguments {
                    all.push(&self.as_text(value));
                }
                Some(text(all))
            }
            "split" => {
                let separator = argument(0).and_then(ScriptValue::text)?;
                let mut parts = Vec::new();
                let mut from = 0;
                for (at, _) in content
                    .match_indices(separator)
                    .filter(|_| !separator.is_empty())
                {
                    parts.push(text(known.slice(from..at)));
                    from = at + separator.len();
                }
                parts.push(text(known.slice(from..content.len())));
                let array = self.array(parts, place);
                if known.is_open {
                    self.open(&array);
                }
                Some(array)
            }
            "toString" | "toLowerCase" | "toUpperCase" | "slice" | "substring" | "substr"
            | "padStart" | "repeat" => match name {
                "toString" => Some(ScriptValue::Text(known.clone())),
                _ => Some(text(KnownText::unknown())),
            },
            "startsWith" | "includes" | "endsWith" => {
                let word = argument(0).and_then(ScriptValue::text)?;
                let has = match name {
                    "startsWith" => content.starts_with(word),
                    "endsWith" => content.ends_with(word),
                    _ => content.contains(word),
                };
                Some(match known.is_open {
                    true => ScriptValue::Any(Primitive::Bool),
                    false => ScriptValue::Bool(has),
                })
            }
            _ => None,
        }
    }

    /// A text with parts replaced.
    fn replaced(
        &mut self,
        known: &KnownText,
        name: &str,
        arguments: &[(ScriptValue, ScriptPlace)],
    ) -> Option<ScriptValue> {
        let argument = |index: usize| arguments.get(index).map(|(value, _)| value);
        let to = argument(1);
        if let Some(function) = self.own_function(to) {
            self.run_unknown(function, None);
        }
        let (Some(from), Some(ScriptValue::Text(to))) =
            (argument(0).and_then(ScriptValue::text), to)
        else {
            let mut open = known.clone();
            open.is_open = true;
            return Some(text(open));
        };
        let mut result = KnownText::default();
        let mut rest = 0;
        let limit = if name == "replace" { 1 } else { usize::MAX };
        for (at, _) in known.content.match_indices(from).take(limit) {
            result.push(&known.slice(rest..at));
            result.push(to);
            rest = at + from.len();
        }
        result.push(&known.slice(rest..known.content.len()));
        Some(text(result))
    }

    /// A function of the language, of React or of Vue without an object.
    pub fn global_function(
        &mut self,
        callee: ObjectId,
        (arguments, is_open): &Arguments,
        place: ScriptPlace,
    ) -> Option<ScriptValue> {
        let first = arguments.first().map(|(value, _)| value.clone());
        let (source, name) = match &self.world.object(callee)?.kind {
            ObjectKind::Foreign(Source::Global(name)) => ("", name.clone()),
            ObjectKind::Foreign(Source::Package(package, name)) => {
                let source = match &**package {
                    "react" | "preact/hooks" => "react",
                    "vue" => "vue",
                    _ => "other",
                };
                (source, name.clone())
            }
            ObjectKind::Foreign(Source::Member(object, name)) => {
                let package = self.world.export_of(*object).map(|(package, _)| package);
                (
                    if package == Some("react") {
                        "react"
                    } else {
                        "other"
                    },
                    name.clone(),
                )
            }
            _ => return None,
        };
        match (source, &*name) {
            ("", "Number" | "parseFloat" | "parseInt") => Some(ScriptValue::Any(Primitive::Number)),
            ("", "String") => Some(text(
                first.map_or(KnownText::unknown(), |v| self.as_text(&v)),
            )),
            ("", "Boolean" | "isNaN") => Some(ScriptValue::Any(Primitive::Bool)),
            ("", "Array") => Some(self.new_array(&(arguments.clone(), *is_open), place)),
            // The same object, watched.
            ("vue", "reactive" | "shallowReactive" | "readonly" | "markRaw" | "toRaw")
            | ("", "$state") => first,
            ("react", "useMemo") => {
                let function = self.own_function(first.as_ref())?;
                Some(self.run(function, ScriptValue::Undefined, Vec::new(), place))
            }
            ("react", "useCallback" | "memo" | "forwardRef") => first,
            ("react", "useRef") => {
                let id = self.plain(place);
                self.define(
                    id,
                    "current",
                    first.unwrap_or(ScriptValue::Undefined),
                    place,
                );
                Some(ScriptValue::Object(id))
            }
            ("react", "useState") => {
                let value = match self.own_function(first.as_ref()) {
                    Some(function) => self.run(function, ScriptValue::Undefined, Vec::new(), place),
                    None => first.unwrap_or(ScriptValue::Undefined),
                };
                // Another value of the same type may be set later.
                let value = match value.primitive() {
                    Some(primitive) => ScriptValue::Any(primitive),
                    None => value,
                };
                let setter = self.unknown(place);
                Some(self.array(vec![value, setter], place))
            }
            _ => None,
        }
    }
}
