//! Assignments and patterns.

use crate::branch::StatementEnd;
use crate::evaluator::Evaluator;
use crate::value::{Primitive, ScriptValue};
use crate::world::{ObjectKind, ScopeId};
use oxc_ast::ast as js;
use oxc_span::GetSpan;
use std::rc::Rc;

impl<'a> Evaluator<'a, '_> {
    pub fn assignment(
        &mut self,
        scope: ScopeId,
        it: &'a js::AssignmentExpression<'a>,
    ) -> ScriptValue {
        let value = match it.operator.to_binary_operator() {
            None if it.operator == js::AssignmentOperator::Assign => {
                self.expression(scope, &it.right)
            }
            // `a ??= b`
            None => {
                let old = self.target(scope, &it.left);
                let new = self.expression(scope, &it.right);
                match self.truth(&old) {
                    Some(true) => old,
                    _ => self.join(old, new),
                }
            }
            Some(operator) => {
                let old = self.target(scope, &it.left);
                let right = self.expression(scope, &it.right);
                self.operate(operator, &old, &right, self.place(it.span))
            }
        };
        self.assign(scope, &it.left, value.clone());
        value
    }

    /// The value of what is assigned to.
    fn target(&mut self, scope: ScopeId, it: &'a js::AssignmentTarget<'a>) -> ScriptValue {
        match it {
            js::AssignmentTarget::AssignmentTargetIdentifier(name) => {
                self.name(scope, name.name.as_str(), self.place(name.span))
            }
            other => match other.as_member_expression() {
                Some(member) => self.member_expression(scope, member).1,
                None => self.unknown(self.place(other.span())),
            },
        }
    }

    /// Assigns a value.
    pub fn assign(&mut self, scope: ScopeId, it: &'a js::AssignmentTarget<'a>, value: ScriptValue) {
        match it {
            js::AssignmentTarget::AssignmentTargetIdentifier(name) => {
                self.set_name(scope, name.name.as_str(), value);
            }
            js::AssignmentTarget::ArrayAssignmentTarget(it) => {
                let elements = it.elements.iter().enumerate();
                for (index, element) in elements.filter_map(|(i, e)| Some((i, e.as_ref()?))) {
                    let place = self.place(it.span);
                    let element_value = self.member(&value, &index.to_string(), place);
                    self.assign_with_default(scope, element, element_value);
                }
            }
            js::AssignmentTarget::ObjectAssignmentTarget(it) => {
                for property in &it.properties {
                    match property {
                        js::AssignmentTargetProperty::AssignmentTargetPropertyIdentifier(it) => {
                            let name = it.binding.name.as_str();
                            let found = self.member(&value, name, self.place(it.span));
                            let found = self.or_default(scope, found, it.init.as_ref());
                            self.set_name(scope, name, found);
                        }
                        js::AssignmentTargetProperty::AssignmentTargetPropertyProperty(it) => {
                            let key = self.property_key(scope, &it.name);
                            let place = self.key_place(&it.name);
                            let found = match key {
                                Some(key) => self.member(&value, &key, place),
                                None => self.unknown(place),
                            };
                            self.assign_with_default(scope, &it.binding, found);
                        }
                    }
                }
            }
            other => {
                if let Some(member) = other.as_member_expression() {
                    let object = self.expression(scope, member.object());
                    self.use_missing(&object, member.object().span(), false);
                    let (key, place) = self.member_key(scope, member);
                    self.write(&object, key, value, place);
                }
            }
        }
    }

    fn assign_with_default(
        &mut self,
        scope: ScopeId,
        it: &'a js::AssignmentTargetMaybeDefault<'a>,
        value: ScriptValue,
    ) {
        match it {
            js::AssignmentTargetMaybeDefault::AssignmentTargetWithDefault(it) => {
                let value = self.or_default(scope, value, Some(&it.init));
                self.assign(scope, &it.binding, value);
            }
            other => {
                if let Some(target) = other.as_assignment_target() {
                    self.assign(scope, target, value);
                }
            }
        }
    }

    /// A value, or the default where it is missing.
    fn or_default(
        &mut self,
        scope: ScopeId,
        value: ScriptValue,
        default: Option<&'a js::Expression<'a>>,
    ) -> ScriptValue {
        match (&value, default) {
            (ScriptValue::Undefined, Some(default)) => self.expression(scope, default),
            (ScriptValue::Object(id), Some(default)) if self.world.is_foreign(*id) => {
                // An option that a caller may leave out.
                let mut way = |e: &mut Self| (StatementEnd::Next, e.expression(scope, default));
                let (_, other) = self.ways(&mut [&mut way]);
                match other.primitive() {
                    Some(primitive) => ScriptValue::Any(primitive),
                    None => value,
                }
            }
            _ => value,
        }
    }

    /// Declares the names of a pattern.
    pub fn bind(
        &mut self,
        scope: ScopeId,
        pattern: &'a js::BindingPattern<'a>,
        value: ScriptValue,
    ) {
        match pattern {
            js::BindingPattern::BindingIdentifier(name) => {
                self.declare(scope, name.name.as_str(), value);
            }
            js::BindingPattern::AssignmentPattern(it) => {
                let value = self.or_default(scope, value, Some(&it.right));
                self.bind(scope, &it.left, value);
            }
            js::BindingPattern::ArrayPattern(it) => {
                for (index, element) in it.elements.iter().enumerate() {
                    let Some(element) = element else { continue };
                    let place = self.place(element.span());
                    let value = self.member(&value, &index.to_string(), place);
                    self.bind(scope, element, value);
                }
                if let Some(rest) = &it.rest {
                    let (known, is_open) = self.iterated(&value);
                    let known = known.into_iter().skip(it.elements.len()).collect();
                    let array = self.array(known, self.place(rest.span));
                    if is_open {
                        self.open(&array);
                    }
                    self.bind(scope, &rest.argument, array);
                }
            }
            js::BindingPattern::ObjectPattern(it) => self.bind_object(scope, it, value),
        }
        self.missing = None;
    }

    fn bind_object(&mut self, scope: ScopeId, it: &'a js::ObjectPattern<'a>, value: ScriptValue) {
        let mut taken: Vec<Rc<str>> = Vec::new();
        for property in &it.properties {
            let key = self.property_key(scope, &property.key);
            let place = self.key_place(&property.key);
            let found = match &key {
                Some(key) => self.member(&value, key, place),
                None => self.unknown(place),
            };
            taken.extend(key);
            self.bind(scope, &property.value, found);
        }
        if let Some(rest) = &it.rest {
            let id = self.plain(self.place(rest.span));
            self.copy_properties(id, &value);
            if let Some(object) = self.world.objects.get_mut(id) {
                object.properties.retain(|p| !taken.contains(&p.key));
            }
            self.bind(scope, &rest.argument, ScriptValue::Object(id));
        }
    }

    /// `a++`
    pub fn update(&mut self, scope: ScopeId, it: &'a js::UpdateExpression<'a>) -> ScriptValue {
        let by = match it.operator {
            js::UpdateOperator::Increment => 1.0,
            js::UpdateOperator::Decrement => -1.0,
        };
        let changed = |old: &ScriptValue| match old {
            ScriptValue::Number(number) => ScriptValue::Number(number + by),
            _ => ScriptValue::Any(Primitive::Number),
        };
        match &it.argument {
            js::SimpleAssignmentTarget::AssignmentTargetIdentifier(name) => {
                let old = self.name(scope, name.name.as_str(), self.place(name.span));
                let new = changed(&old);
                self.set_name(scope, name.name.as_str(), new.clone());
                if it.prefix { new } else { old }
            }
            other => {
                let Some(member) = other.as_member_expression() else {
                    return ScriptValue::Any(Primitive::Number);
                };
                let (object, old) = self.member_expression(scope, member);
                let (key, place) = self.member_key(scope, member);
                let new = changed(&old);
                self.write(&object, key, new.clone(), place);
                if it.prefix { new } else { old }
            }
        }
    }

    /// The elements of a value that is iterated, and whether there may be others.
    pub fn iterated(&self, value: &ScriptValue) -> (Vec<ScriptValue>, bool) {
        let object = value.object().and_then(|id| self.world.object(id));
        match object.map(|o| (&o.kind, o.is_open)) {
            Some((ObjectKind::Array(elements), is_open)) => (elements.clone(), is_open),
            _ => (Vec::new(), true),
        }
    }

    /// The names of the properties of a value, and whether there may be others.
    pub fn keys(&mut self, value: &ScriptValue) -> (Vec<ScriptValue>, bool) {
        let object = value.object().and_then(|id| self.world.object(id));
        let Some(object) = object else {
            return (Vec::new(), true);
        };
        match &object.kind {
            ObjectKind::Plain => {
                let texts = object.properties.iter().map(|p| {
                    let text = crate::KnownText::written(&p.key, p.place);
                    ScriptValue::Text(Rc::new(text))
                });
                (texts.collect(), object.is_open)
            }
            _ => (Vec::new(), true),
        }
    }
}
