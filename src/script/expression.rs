//! Expressions.

use crate::branch::StatementEnd;
use crate::evaluator::Evaluator;
use crate::value::{KnownText, Primitive, ScriptPlace, ScriptValue};
use crate::world::{Closure, Code, EventKind, ObjectKind, ScopeId};
use oxc_ast::ast as js;
use oxc_span::{GetSpan, Span};
use std::rc::Rc;

/// The place of the contents of a quoted string or template.
fn inside(place: ScriptPlace) -> ScriptPlace {
    ScriptPlace {
        start: place.start + 1,
        end: place.end.saturating_sub(1).max(place.start + 1),
        ..place
    }
}

impl<'a> Evaluator<'a, '_> {
    pub fn expression(&mut self, scope: ScopeId, it: &'a js::Expression<'a>) -> ScriptValue {
        let value = self.nested(|e| e.expression_inside(scope, it));
        match value {
            Some(value) => value,
            None => self.unknown(self.place(it.span())),
        }
    }

    fn expression_inside(&mut self, scope: ScopeId, it: &'a js::Expression<'a>) -> ScriptValue {
        let place = self.place(it.span());
        match it {
            js::Expression::BooleanLiteral(it) => ScriptValue::Bool(it.value),
            js::Expression::NullLiteral(_) => ScriptValue::Null,
            js::Expression::NumericLiteral(it) => ScriptValue::Number(it.value),
            js::Expression::StringLiteral(it) => self.quoted(it),
            js::Expression::TemplateLiteral(it) => self.template(scope, it),
            js::Expression::TaggedTemplateExpression(it) => {
                let tag = self.expression(scope, &it.tag);
                let text = self.template(scope, &it.quasi);
                // A tag of GLSL marks the text for editors and bundlers.
                match tag.object().filter(|id| self.world.is_foreign(*id)) {
                    Some(_) => text,
                    None => self.unknown(place),
                }
            }
            js::Expression::Identifier(it) => self.name(scope, it.name.as_str(), place),
            js::Expression::ThisExpression(_) => self.this(place),
            js::Expression::ArrayExpression(it) => self.array_literal(scope, it),
            js::Expression::ObjectExpression(it) => self.object_literal(scope, it),
            js::Expression::ArrowFunctionExpression(it) => {
                let this = self.frames.last().map(|frame| frame.this.clone());
                self.close(Code::Arrow(it), scope, this, place)
            }
            js::Expression::FunctionExpression(it) => self.function(scope, it),
            js::Expression::ClassExpression(it) => self.class(scope, it),
            js::Expression::AssignmentExpression(it) => self.assignment(scope, it),
            js::Expression::UpdateExpression(it) => self.update(scope, it),
            js::Expression::UnaryExpression(it) => self.unary(scope, it),
            js::Expression::BinaryExpression(it) => self.binary(scope, it),
            js::Expression::LogicalExpression(it) => self.logical(scope, it),
            js::Expression::ConditionalExpression(it) => self.conditional(scope, it),
            js::Expression::SequenceExpression(it) => {
                let values = it.expressions.iter().map(|one| self.expression(scope, one));
                values.last().unwrap_or(ScriptValue::Undefined)
            }
            js::Expression::AwaitExpression(it) => self.expression(scope, &it.argument),
            js::Expression::CallExpression(it) => self.call_expression(scope, it),
            js::Expression::NewExpression(it) => self.new_expression(scope, it),
            js::Expression::ImportExpression(it) => self.import_expression(scope, it),
            js::Expression::ChainExpression(it) => match &it.expression {
                js::ChainElement::CallExpression(call) => self.call_expression(scope, call),
                js::ChainElement::TSNonNullExpression(it) => self.expression(scope, &it.expression),
                other => match other.as_member_expression() {
                    Some(member) => self.member_expression(scope, member).1,
                    None => self.unknown(place),
                },
            },
            js::Expression::ParenthesizedExpression(it) => self.expression(scope, &it.expression),
            js::Expression::TSAsExpression(it) => self.expression(scope, &it.expression),
            js::Expression::TSSatisfiesExpression(it) => self.expression(scope, &it.expression),
            js::Expression::TSNonNullExpression(it) => self.expression(scope, &it.expression),
            js::Expression::TSTypeAssertion(it) => self.expression(scope, &it.expression),
            js::Expression::TSInstantiationExpression(it) => self.expression(scope, &it.expression),
            js::Expression::JSXElement(it) => self.element(scope, it),
            js::Expression::JSXFragment(it) => {
                let children = self.element_children(scope, &it.children);
                self.array(children, place)
            }
            js::Expression::YieldExpression(it) => {
                if let Some(argument) = &it.argument {
                    self.expression(scope, argument);
                }
                self.unknown(place)
            }
            other => match other.as_member_expression() {
                Some(member) => self.member_expression(scope, member).1,
                None => self.unknown(place),
            },
        }
    }

    pub fn this(&mut self, place: ScriptPlace) -> ScriptValue {
        let this = self.frames.last().map(|frame| frame.this.clone());
        this.unwrap_or_else(|| self.unknown(place))
    }

    /// A string literal.
    pub fn quoted(&self, it: &js::StringLiteral) -> ScriptValue {
        let place = inside(self.place(it.span));
        ScriptValue::Text(Rc::new(KnownText::written(&it.value, place)))
    }

    fn template(&mut self, scope: ScopeId, it: &'a js::TemplateLiteral<'a>) -> ScriptValue {
        let mut text = KnownText::default();
        for (index, quasi) in it.quasis.iter().enumerate() {
            let cooked = quasi.value.cooked.as_ref().unwrap_or(&quasi.value.raw);
            text.push(&KnownText::written(cooked, self.place(quasi.span)));
            if let Some(expression) = it.expressions.get(index) {
                let value = self.expression(scope, expression);
                text.push(&self.as_text(&value));
            }
        }
        ScriptValue::Text(Rc::new(text))
    }

    /// A closure.
    pub fn close(
        &mut self,
        code: Code<'a>,
        scope: ScopeId,
        this: Option<ScriptValue>,
        place: ScriptPlace,
    ) -> ScriptValue {
        let home = self.frames.last().and_then(|frame| frame.home);
        let closure = Closure {
            code,
            scope,
            this,
            home,
            file: self.file,
            runs: 0,
        };
        ScriptValue::Object(self.add(ObjectKind::Function(closure), place))
    }

    pub fn function(&mut self, scope: ScopeId, it: &'a js::Function<'a>) -> ScriptValue {
        self.close(Code::Function(it), scope, None, self.place(it.span))
    }

    fn array_literal(&mut self, scope: ScopeId, it: &'a js::ArrayExpression<'a>) -> ScriptValue {
        let mut elements = Vec::new();
        let mut is_open = false;
        for element in &it.elements {
            match element {
                js::ArrayExpressionElement::SpreadElement(spread) => {
                    let value = self.expression(scope, &spread.argument);
                    let (mut known, has_more) = self.iterated(&value);
                    elements.append(&mut known);
                    is_open |= has_more;
                }
                js::ArrayExpressionElement::Elision(_) => elements.push(ScriptValue::Undefined),
                other => {
                    if let Some(expression) = other.as_expression() {
                        elements.push(self.expression(scope, expression));
                    }
                }
            }
        }
        let array = self.array(elements, self.place(it.span));
        if is_open {
            self.open(&array);
        }
        array
    }

    fn object_literal(&mut self, scope: ScopeId, it: &'a js::ObjectExpression<'a>) -> ScriptValue {
        let id = self.plain(self.place(it.span));
        let object = ScriptValue::Object(id);
        for property in &it.properties {
            match property {
                js::ObjectPropertyKind::SpreadProperty(spread) => {
                    let value = self.expression(scope, &spread.argument);
                    self.copy_properties(id, &value);
                }
                js::ObjectPropertyKind::ObjectProperty(it) => {
                    let place = self.key_place(&it.key);
                    let key = self.property_key(scope, &it.key);
                    let value = match &it.value {
                        js::Expression::FunctionExpression(function) => {
                            self.function(scope, function)
                        }
                        value => self.expression(scope, value),
                    };
                    let Some(key) = key else {
                        self.open(&object);
                        continue;
                    };
                    match it.kind {
                        js::PropertyKind::Init => self.define(id, &key, value, place),
                        kind => {
                            let is_setter = kind == js::PropertyKind::Set;
                            self.add_accessor(id, &key, (value, is_setter), place);
                        }
                    }
                }
            }
        }
        object
    }

    /// Adds a getter or setter.
    pub fn add_accessor(
        &mut self,
        id: usize,
        key: &str,
        (function, is_setter): (ScriptValue, bool),
        place: ScriptPlace,
    ) {
        if self.world.property(id, key).is_none() {
            self.define(id, key, ScriptValue::Undefined, place);
        }
        let object = self.world.objects.get_mut(id);
        let property = object.and_then(|o| o.properties.iter_mut().find(|p| &*p.key == key));
        if let Some(accessor) = property.and_then(|p| p.accessors.get_mut(usize::from(is_setter))) {
            *accessor = function.object();
        }
    }

    /// Copies the properties of a value to an object, as spreading does.
    pub fn copy_properties(&mut self, id: usize, value: &ScriptValue) {
        let source = value.object().and_then(|id| self.world.object(id));
        let is_known = source.is_some_and(|o| matches!(o.kind, ObjectKind::Plain) && !o.is_open);
        let known = source.map_or(Vec::new(), |o| o.properties.clone());
        for property in known {
            self.define(id, &property.key, property.value, property.place);
        }
        if !is_known && matches!(value, ScriptValue::Object(_)) {
            self.open(&ScriptValue::Object(id));
        }
    }

    /// The place of a property's name.
    pub fn key_place(&self, key: &js::PropertyKey) -> ScriptPlace {
        match key {
            js::PropertyKey::StringLiteral(it) => inside(self.place(it.span)),
            other => self.place(other.span()),
        }
    }

    /// The name of a property, if it is known.
    pub fn property_key(
        &mut self,
        scope: ScopeId,
        key: &'a js::PropertyKey<'a>,
    ) -> Option<Rc<str>> {
        match key {
            js::PropertyKey::StaticIdentifier(it) => Some(it.name.as_str().into()),
            js::PropertyKey::PrivateIdentifier(it) => Some(format!("#{}", it.name).into()),
            other => {
                let value = self.expression(scope, other.as_expression()?);
                self.key(&value)
            }
        }
    }

    /// The object of a member expression and the value of the member.
    pub fn member_expression(
        &mut self,
        scope: ScopeId,
        it: &'a js::MemberExpression<'a>,
    ) -> (ScriptValue, ScriptValue) {
        let object = self.expression(scope, it.object());
        self.use_missing(&object, it.object().span(), it.optional());
        let (key, place) = self.member_key(scope, it);
        let member = match key {
            Some(key) => self.member(&object, &key, place),
            None => self.any_element(&object, place),
        };
        (object, member)
    }

    /// A value that is an element of an array, or unknown.
    fn any_element(&mut self, object: &ScriptValue, place: ScriptPlace) -> ScriptValue {
        match object
            .object()
            .and_then(|id| self.world.object(id))
            .map(|o| &o.kind)
        {
            Some(ObjectKind::Array(elements)) => match elements.as_slice() {
                [one] => one.clone(),
                _ => self.unknown(place),
            },
            _ => self.unknown(place),
        }
    }

    /// The name of a member, if it is known, and its place.
    pub fn member_key(
        &mut self,
        scope: ScopeId,
        it: &'a js::MemberExpression<'a>,
    ) -> (Option<Rc<str>>, ScriptPlace) {
        match it {
            js::MemberExpression::StaticMemberExpression(it) => (
                Some(it.property.name.as_str().into()),
                self.place(it.property.span),
            ),
            js::MemberExpression::PrivateFieldExpression(it) => (
                Some(format!("#{}", it.field.name).into()),
                self.place(it.field.span),
            ),
            js::MemberExpression::ComputedMemberExpression(it) => {
                let value = self.expression(scope, &it.expression);
                let place = self.place(it.expression.span());
                let is_text = matches!(it.expression, js::Expression::StringLiteral(_));
                let place = if is_text { inside(place) } else { place };
                (self.key(&value), place)
            }
        }
    }

    /// Notes that something is read from a missing value.
    pub fn use_missing(&mut self, object: &ScriptValue, span: Span, is_optional: bool) {
        if is_optional {
            self.world.optional.extend(object.object());
        }
        let missing = self.missing.take().filter(|_| !is_optional);
        let event = missing.and_then(|id| self.world.events.get_mut(id));
        if let (ScriptValue::Undefined, Some(event)) = (object, event)
            && event.place.file == self.file
            && event.place.end >= span.start
            && event.place.end <= span.end
            && let EventKind::Missing { is_used, .. } = &mut event.kind
        {
            *is_used = true;
        }
    }

    fn unary(&mut self, scope: ScopeId, it: &'a js::UnaryExpression<'a>) -> ScriptValue {
        let value = self.expression(scope, &it.argument);
        match (it.operator, &value) {
            (js::UnaryOperator::UnaryNegation, ScriptValue::Number(n)) => ScriptValue::Number(-n),
            (js::UnaryOperator::UnaryPlus, ScriptValue::Number(n)) => ScriptValue::Number(*n),
            (js::UnaryOperator::LogicalNot, _) => match self.truth(&value) {
                Some(flag) => ScriptValue::Bool(!flag),
                None => ScriptValue::Any(Primitive::Bool),
            },
            (js::UnaryOperator::Typeof, _) => {
                let name = match value.primitive() {
                    Some(Primitive::Number) => "number",
                    Some(Primitive::Text) => "string",
                    Some(Primitive::Bool) => "boolean",
                    None => match &value {
                        ScriptValue::Undefined => "undefined",
                        ScriptValue::Object(id) if self.closure(*id).is_some() => "function",
                        ScriptValue::Object(id) if self.world.is_foreign(*id) => {
                            return ScriptValue::Any(Primitive::Text);
                        }
                        _ => "object",
                    },
                };
                ScriptValue::Text(Rc::new(KnownText::made(name.to_string())))
            }
            (js::UnaryOperator::Void, _) => ScriptValue::Undefined,
            (js::UnaryOperator::Delete, _) => ScriptValue::Bool(true),
            _ => ScriptValue::Any(Primitive::Number),
        }
    }

    fn binary(&mut self, scope: ScopeId, it: &'a js::BinaryExpression<'a>) -> ScriptValue {
        let left = self.expression(scope, &it.left);
        let right = self.expression(scope, &it.right);
        self.operate(it.operator, &left, &right, self.place(it.span))
    }

    /// The result of an operator.
    pub fn operate(
        &mut self,
        operator: js::BinaryOperator,
        left: &ScriptValue,
        right: &ScriptValue,
        place: ScriptPlace,
    ) -> ScriptValue {
        use js::BinaryOperator as Op;
        if operator.is_equality() {
            let equals = matches!(operator, Op::Equality | Op::StrictEquality);
            return match self.equality(left, right) {
                Some(is_equal) => ScriptValue::Bool(is_equal == equals),
                None => ScriptValue::Any(Primitive::Bool),
            };
        }
        if matches!(operator, Op::Instanceof | Op::In) {
            return self.relation(operator, left, right);
        }
        if operator == Op::Addition {
            let is_text = |v: &ScriptValue| v.primitive() == Some(Primitive::Text);
            if is_text(left) || is_text(right) {
                let mut text = self.as_text(left);
                text.push(&self.as_text(right));
                return ScriptValue::Text(Rc::new(text));
            }
            let is_number = |v: &ScriptValue| v.primitive() == Some(Primitive::Number);
            return match (left, right) {
                (ScriptValue::Number(a), ScriptValue::Number(b)) => ScriptValue::Number(a + b),
                _ if is_number(left) && is_number(right) => ScriptValue::Any(Primitive::Number),
                (ScriptValue::Object(id), ScriptValue::Number(n))
                | (ScriptValue::Number(n), ScriptValue::Object(id)) => {
                    let sum = ObjectKind::Foreign(crate::Source::Sum(*id, *n as i32));
                    ScriptValue::Object(self.add(sum, place))
                }
                _ => self.unknown(place),
            };
        }
        let (ScriptValue::Number(a), ScriptValue::Number(b)) = (left, right) else {
            return ScriptValue::Any(match operator.is_compare() {
                true => Primitive::Bool,
                false => Primitive::Number,
            });
        };
        match operator {
            Op::Subtraction => ScriptValue::Number(a - b),
            Op::Multiplication => ScriptValue::Number(a * b),
            Op::Division => ScriptValue::Number(a / b),
            Op::Remainder => ScriptValue::Number(a % b),
            Op::Exponential => ScriptValue::Number(a.powf(*b)),
            Op::LessThan => ScriptValue::Bool(a < b),
            Op::LessEqualThan => ScriptValue::Bool(a <= b),
            Op::GreaterThan => ScriptValue::Bool(a > b),
            Op::GreaterEqualThan => ScriptValue::Bool(a >= b),
            Op::ShiftLeft => ScriptValue::Number(((*a as i64 as i32) << (*b as u32 & 31)).into()),
            Op::BitwiseAnd => ScriptValue::Number((*a as i64 as i32 & *b as i64 as i32).into()),
            Op::BitwiseOR => ScriptValue::Number((*a as i64 as i32 | *b as i64 as i32).into()),
            _ => ScriptValue::Any(Primitive::Number),
        }
    }

    /// `instanceof` and `in`
    fn relation(
        &self,
        operator: js::BinaryOperator,
        left: &ScriptValue,
        right: &ScriptValue,
    ) -> ScriptValue {
        let object = right.object().and_then(|id| self.world.object(id));
        let known = match operator {
            js::BinaryOperator::In => {
                let key = self.key(left);
                object
                    .filter(|o| matches!(o.kind, ObjectKind::Plain))
                    .zip(key)
                    .and_then(|(o, key)| {
                        let has = o.properties.iter().any(|p| p.key == key);
                        (has || !o.is_open).then_some(has)
                    })
            }
            _ => match (left.primitive(), left.object()) {
                (Some(_), _) => Some(false),
                (None, Some(id)) => self.is_instance(id, right.object()),
                _ => Some(false),
            },
        };
        known.map_or(ScriptValue::Any(Primitive::Bool), ScriptValue::Bool)
    }

    /// Whether an object is an instance of a function, if that is known.
    fn is_instance(&self, id: usize, class: Option<usize>) -> Option<bool> {
        let class = class?;
        let object = self.world.object(id)?;
        if object.class == Some(class) {
            return Some(true);
        }
        let name = |id: usize| self.world.export_of(id).map(|(_, name)| name.to_string());
        match self.world.call_of(id) {
            Some(call) if call.is_new => {
                let made = call.callee.and_then(name)?;
                // A base class has another name.
                (Some(made) == name(class)).then_some(true)
            }
            Some(_) => None,
            None if self.world.is_foreign(id) => None,
            None => self.world.export_of(class).map(|_| false),
        }
    }

    /// Whether two values are equal, if that is known.
    fn equality(&self, left: &ScriptValue, right: &ScriptValue) -> Option<bool> {
        let is_known = |v: &ScriptValue| match v {
            ScriptValue::Any(_) => false,
            ScriptValue::Text(text) => !text.is_open,
            ScriptValue::Object(id) => !self.world.is_foreign(*id),
            _ => true,
        };
        let is_nothing = |v: &ScriptValue| matches!(v, ScriptValue::Undefined | ScriptValue::Null);
        if is_nothing(left) && is_nothing(right) {
            return Some(true);
        }
        // A named constant of WebGL is equal to itself and to no other.
        if let (ScriptValue::Object(a), ScriptValue::Object(b)) = (left, right) {
            let constant = |id: usize| match &self.world.object(id)?.kind {
                ObjectKind::Foreign(crate::Source::Member(_, name)) => {
                    let is_constant = name
                        .chars()
                        .all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
                    is_constant.then(|| name.clone())
                }
                _ => None,
            };
            if let (Some(a), Some(b)) = (constant(*a), constant(*b)) {
                return Some(a == b);
            }
        }
        if left.is_same(right) {
            return Some(true);
        }
        (is_known(left) && is_known(right)).then_some(false)
    }

    fn logical(&mut self, scope: ScopeId, it: &'a js::LogicalExpression<'a>) -> ScriptValue {
        let left = self.expression(scope, &it.left);
        self.world.optional.extend(left.object());
        let is_taken = match it.operator {
            js::LogicalOperator::And => self.truth(&left),
            js::LogicalOperator::Or => self.truth(&left).map(|flag| !flag),
            js::LogicalOperator::Coalesce => match &left {
                ScriptValue::Undefined | ScriptValue::Null => Some(true),
                ScriptValue::Object(id) if self.world.is_foreign(*id) => None,
                _ => Some(false),
            },
        };
        match is_taken {
            Some(true) => self.expression(scope, &it.right),
            Some(false) => left,
            None => {
                let mut way = |e: &mut Self| (StatementEnd::Next, e.expression(scope, &it.right));
                let (_, right) = self.ways(&mut [&mut way]);
                match it.operator {
                    js::LogicalOperator::And => right,
                    // The value of a parameter or option if there is one.
                    _ => self.join(left, right),
                }
            }
        }
    }

    fn conditional(
        &mut self,
        scope: ScopeId,
        it: &'a js::ConditionalExpression<'a>,
    ) -> ScriptValue {
        let test = self.expression(scope, &it.test);
        self.world.optional.extend(test.object());
        match self.truth(&test) {
            Some(true) => self.expression(scope, &it.consequent),
            Some(false) => self.expression(scope, &it.alternate),
            None => {
                let mut one =
                    |e: &mut Self| (StatementEnd::Next, e.expression(scope, &it.consequent));
                let mut other =
                    |e: &mut Self| (StatementEnd::Next, e.expression(scope, &it.alternate));
                self.ways(&mut [&mut one, &mut other]).1
            }
        }
    }
}
