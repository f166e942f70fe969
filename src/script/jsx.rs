//! Elements of JSX: each is a new object of its name, with its attributes and its children.

use crate::evaluator::Evaluator;
use crate::value::{ScriptPlace, ScriptValue};
use crate::world::ScopeId;
use oxc_ast::ast as js;
use oxc_span::GetSpan;
use std::rc::Rc;

impl<'a> Evaluator<'a, '_> {
    pub fn element(&mut self, scope: ScopeId, it: &'a js::JSXElement<'a>) -> ScriptValue {
        let place = self.place(it.span);
        let opening = &it.opening_element;
        let attributes = self.plain(self.place(opening.span));
        for attribute in &opening.attributes {
            match attribute {
                js::JSXAttributeItem::Attribute(attribute) => {
                    let js::JSXAttributeName::Identifier(name) = &attribute.name else {
                        continue;
                    };
                    let place = self.place(name.span);
                    // `{uniforms}` of Svelte
                    let (name, value) = match name.name.strip_prefix('$') {
                        Some(own) if attribute.value.is_none() => {
                            (own, self.name(scope, own, place))
                        }
                        _ => (name.name.as_str(), self.attribute(scope, attribute)),
                    };
                    self.define(attributes, name, value, place);
                }
                js::JSXAttributeItem::SpreadAttribute(spread) => {
                    let value = self.expression(scope, &spread.argument);
                    self.copy_properties(attributes, &value);
                }
            }
        }
        let children = self.element_children(scope, &it.children);
        let children = self.array(children, place);
        let arguments = vec![
            (ScriptValue::Object(attributes), self.place(opening.span)),
            (children, place),
        ];
        let (callee, name) = self.element_type(scope, &opening.name);
        let is_own = callee
            .as_ref()
            .is_some_and(|c| c.object().is_some_and(|id| !self.world.is_foreign(id)));
        if let (true, Some(callee)) = (is_own, &callee) {
            return self.call(callee, (None, &name), (arguments, false), place);
        }
        let callee = callee.and_then(|value| value.object());
        let id = self.foreign_call(callee, (None, &name), (arguments, false), (true, place));
        // `ref={r}` sets `r.current`.
        let reference = self
            .world
            .property(attributes, "ref")
            .map(|p| p.value.clone());
        if let Some(reference) = reference {
            let is_function = reference.object().filter(|id| self.closure(*id).is_some());
            match is_function {
                Some(function) => {
                    self.run(
                        function,
                        ScriptValue::Undefined,
                        vec![(ScriptValue::Object(id), place)],
                        place,
                    );
                }
                None => {
                    let current: Rc<str> = "current".into();
                    self.write(
                        &reference,
                        Some(current),
                        ScriptValue::Object(id),
                        ScriptPlace::default(),
                    );
                }
            }
        }
        ScriptValue::Object(id)
    }

    fn attribute(&mut self, scope: ScopeId, it: &'a js::JSXAttribute<'a>) -> ScriptValue {
        match &it.value {
            None => ScriptValue::Bool(true),
            Some(js::JSXAttributeValue::StringLiteral(text)) => self.quoted(text),
            Some(js::JSXAttributeValue::Element(element)) => self.element(scope, element),
            Some(js::JSXAttributeValue::ExpressionContainer(it)) => {
                match it.expression.as_expression() {
                    Some(expression) => self.expression(scope, expression),
                    None => ScriptValue::Undefined,
                }
            }
            Some(js::JSXAttributeValue::Fragment(it)) => self.unknown(self.place(it.span)),
        }
    }

    /// The values of the children of an element.
    pub fn element_children(
        &mut self,
        scope: ScopeId,
        all: &'a [js::JSXChild<'a>],
    ) -> Vec<ScriptValue> {
        let mut values = Vec::new();
        for child in all {
            match child {
                js::JSXChild::Element(element) => values.push(self.element(scope, element)),
                js::JSXChild::Fragment(it) => {
                    values.append(&mut self.element_children(scope, &it.children));
                }
                js::JSXChild::ExpressionContainer(it) => {
                    if let Some(expression) = it.expression.as_expression() {
                        values.push(self.expression(scope, expression));
                    }
                }
                _ => {}
            }
        }
        values
    }

    /// What an element is an instance of: a value, or a name of the renderer.
    fn element_type(
        &mut self,
        scope: ScopeId,
        name: &'a js::JSXElementName<'a>,
    ) -> (Option<ScriptValue>, String) {
        let place = self.place(name.span());
        match name {
            js::JSXElementName::Identifier(it) => (None, it.name.to_string()),
            js::JSXElementName::IdentifierReference(it) => {
                let name = it.name.as_str();
                (Some(self.name(scope, name, place)), name.to_string())
            }
            js::JSXElementName::MemberExpression(it) => {
                let name = it.property.name.to_string();
                let object = match &it.object {
                    js::JSXMemberExpressionObject::IdentifierReference(it) => {
                        self.name(scope, it.name.as_str(), place)
                    }
                    _ => self.unknown(place),
                };
                (Some(self.member(&object, &name, place)), name)
            }
            _ => (None, String::new()),
        }
    }
}
