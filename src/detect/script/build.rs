//! Builds the tree of a script from its syntax tree.

use super::tree::{
    BindingValue, Export, NodeKind, ScriptBinding, ScriptNode, ScriptNodeId, ScriptTree,
};
use oxc_ast::ast as js;
use oxc_ast_visit::{Visit, walk};
use oxc_span::{GetSpan, Span};
use std::ops::Range;

/// Maximum depth of nodes; what is deeper is left out.
const MAX_DEPTH: usize = 400;

/// Builds the tree of a parsed script.
pub fn build(text: &str, program: &js::Program) -> ScriptTree {
    let mut builder = TreeBuilder {
        text,
        tree: ScriptTree::default(),
        open: Vec::new(),
        scopes: vec![range(program.span)],
        depth: 0,
    };
    let comments = program.comments.iter().map(|c| range(c.span));
    builder.tree.comments.extend(comments);
    builder.visit_program(program);
    builder.tree.index_names(text);
    builder.tree
}

fn range(span: Span) -> Range<usize> {
    span.start as usize..span.end as usize
}

/// The contents of a quoted string or template.
fn inside(span: Span) -> Range<usize> {
    let range = range(span);
    range.start + 1..range.end.saturating_sub(1).max(range.start + 1)
}

/// The path of the module in `require("path")`.
fn required(value: &js::Expression) -> Option<String> {
    let js::Expression::CallExpression(call) = value else {
        return None;
    };
    match (&call.callee, call.arguments.first()?) {
        (js::Expression::Identifier(name), js::Argument::StringLiteral(path))
            if name.name == "require" =>
        {
            Some(path.value.to_string())
        }
        _ => None,
    }
}

struct TreeBuilder<'t> {
    text: &'t str,
    tree: ScriptTree,
    /// The nodes that are being built.
    open: Vec<ScriptNodeId>,
    /// The scopes around the current place.
    scopes: Vec<Range<usize>>,
    depth: usize,
}

impl TreeBuilder<'_> {
    /// Adds a node with what `walk` visits inside.
    fn node(
        &mut self,
        kind: NodeKind,
        span: Range<usize>,
        walk: impl FnOnce(&mut Self),
    ) -> ScriptNodeId {
        let id = self.tree.nodes.len();
        let parent = self.open.last().copied();
        self.tree.nodes.push(ScriptNode {
            kind,
            span,
            parent,
            children: Vec::new(),
        });
        if let Some(parent) = parent.and_then(|p| self.tree.nodes.get_mut(p)) {
            parent.children.push(id);
        }
        self.open.push(id);
        self.depth += 1;
        if self.depth < MAX_DEPTH {
            walk(self);
        }
        self.depth -= 1;
        self.open.pop();
        id
    }

    fn bind(&mut self, name: Span, value: BindingValue) {
        if let Some(scope) = self.scopes.last().cloned() {
            self.tree.bindings.push(ScriptBinding {
                name: range(name),
                scope,
                value,
            });
        }
    }

    fn scoped(&mut self, span: Span, walk: impl FnOnce(&mut Self)) {
        self.scopes.push(range(span));
        walk(self);
        self.scopes.pop();
    }

    fn expression(&mut self, it: &js::Expression) -> ScriptNodeId {
        let span = it.span();
        match it {
            js::Expression::StringLiteral(_) => self.node(NodeKind::Text, inside(span), |_| {}),
            js::Expression::TemplateLiteral(it) => self.template(it),
            js::Expression::NumericLiteral(_) => self.node(NodeKind::Number, range(span), |_| {}),
            js::Expression::Identifier(_) => self.node(NodeKind::Name, range(span), |_| {}),
            js::Expression::StaticMemberExpression(it) => self.member(it),
            js::Expression::ComputedMemberExpression(it) => {
                self.pair(NodeKind::Index, span, [&it.object, &it.expression])
            }
            js::Expression::CallExpression(it) => {
                self.call(NodeKind::Call, span, &it.callee, &it.arguments)
            }
            js::Expression::NewExpression(it) => {
                self.call(NodeKind::New, span, &it.callee, &it.arguments)
            }
            js::Expression::TaggedTemplateExpression(it) => {
                self.node(NodeKind::Tagged, range(span), |b| {
                    b.expression(&it.tag);
                    b.template(&it.quasi);
                })
            }
            js::Expression::ObjectExpression(it) => self.node(NodeKind::Object, range(span), |b| {
                b.visit_object_property_kinds(&it.properties);
            }),
            js::Expression::ArrayExpression(it) => self.node(NodeKind::Array, range(span), |b| {
                walk::walk_array_expression(b, it);
            }),
            js::Expression::BinaryExpression(it) => self.binary(it),
            js::Expression::LogicalExpression(it) => {
                self.pair(NodeKind::Choice, span, [&it.left, &it.right])
            }
            js::Expression::ConditionalExpression(it) => {
                self.pair(NodeKind::Choice, span, [&it.consequent, &it.alternate])
            }
            js::Expression::AssignmentExpression(it) => self.assignment(it),
            js::Expression::ChainExpression(it) => match &it.expression {
                js::ChainElement::CallExpression(call) => {
                    self.call(NodeKind::Call, span, &call.callee, &call.arguments)
                }
                js::ChainElement::StaticMemberExpression(it) => self.member(it),
                _ => self.node(NodeKind::Other, range(span), |b| {
                    walk::walk_chain_expression(b, it);
                }),
            },
            js::Expression::ParenthesizedExpression(it) => self.expression(&it.expression),
            js::Expression::TSAsExpression(it) => self.expression(&it.expression),
            js::Expression::TSSatisfiesExpression(it) => self.expression(&it.expression),
            js::Expression::TSNonNullExpression(it) => self.expression(&it.expression),
            js::Expression::TSTypeAssertion(it) => self.expression(&it.expression),
            js::Expression::ArrowFunctionExpression(it) => self.arrow(it),
            js::Expression::FunctionExpression(it) => self.function(it),
            _ => self.node(NodeKind::Other, range(span), |b| {
                walk::walk_expression(b, it)
            }),
        }
    }

    fn member(&mut self, it: &js::StaticMemberExpression) -> ScriptNodeId {
        let name = range(it.property.span);
        self.node(NodeKind::Member(name), range(it.span), |b| {
            b.expression(&it.object);
        })
    }

    /// A node with two expressions.
    fn pair(&mut self, kind: NodeKind, span: Span, both: [&js::Expression; 2]) -> ScriptNodeId {
        self.node(kind, range(span), |b| {
            for one in both {
                b.expression(one);
            }
        })
    }

    fn call<'a>(
        &mut self,
        kind: NodeKind,
        span: Span,
        callee: &js::Expression<'a>,
        arguments: &[js::Argument<'a>],
    ) -> ScriptNodeId {
        self.node(kind, range(span), |b| {
            b.expression(callee);
            arguments
                .iter()
                .for_each(|argument| b.visit_argument(argument));
        })
    }

    fn template(&mut self, it: &js::TemplateLiteral) -> ScriptNodeId {
        let starts = it.quasis.iter().map(|q| q.span.end as usize);
        let ends = it.quasis.iter().skip(1).map(|q| q.span.start as usize);
        let holes = starts.zip(ends).map(|(from, to)| from..to).collect();
        self.node(NodeKind::Template(holes), inside(it.span), |b| {
            for expression in &it.expressions {
                b.expression(expression);
            }
        })
    }

    /// A chain of operators on the left side is one node, so that its length is not limited.
    fn binary(&mut self, it: &js::BinaryExpression) -> ScriptNodeId {
        let kind = |it: &js::BinaryExpression| match it.operator {
            js::BinaryOperator::Addition => NodeKind::Sum,
            operator if operator.is_equality() => NodeKind::Comparison,
            _ => NodeKind::Other,
        };
        let mut operands = vec![&it.right];
        let mut left = &it.left;
        while let js::Expression::BinaryExpression(inner) = left
            && inner.operator == it.operator
        {
            operands.push(&inner.right);
            left = &inner.left;
        }
        operands.push(left);
        self.node(kind(it), range(it.span), |b| {
            for operand in operands.into_iter().rev() {
                b.expression(operand);
            }
        })
    }

    fn assignment(&mut self, it: &js::AssignmentExpression) -> ScriptNodeId {
        let adds = it.operator == js::AssignmentOperator::Addition;
        let is_text = adds || it.operator == js::AssignmentOperator::Assign;
        let kind = match is_text {
            true => NodeKind::Assignment(adds),
            false => NodeKind::Other,
        };
        self.node(kind, range(it.span), |b| {
            match &it.left {
                js::AssignmentTarget::AssignmentTargetIdentifier(name) => {
                    b.node(NodeKind::Name, range(name.span), |_| {});
                }
                js::AssignmentTarget::StaticMemberExpression(member) => {
                    b.member(member);
                }
                js::AssignmentTarget::ComputedMemberExpression(member) => {
                    b.pair(
                        NodeKind::Index,
                        member.span,
                        [&member.object, &member.expression],
                    );
                }
                other => {
                    b.node(NodeKind::Other, range(other.span()), |b| {
                        walk::walk_assignment_target(b, other);
                    });
                }
            }
            b.expression(&it.right);
        })
    }

    fn arrow(&mut self, it: &js::ArrowFunctionExpression) -> ScriptNodeId {
        self.node(NodeKind::Function, range(it.span), |b| {
            b.scoped(it.span, |b| {
                b.visit_formal_parameters(&it.params);
                match it.get_expression() {
                    Some(result) => {
                        b.node(NodeKind::Return, range(result.span()), |b| {
                            b.expression(result);
                        });
                    }
                    None => walk::walk_arrow_function_body(b, &it.body),
                }
            });
        })
    }

    fn function(&mut self, it: &js::Function) -> ScriptNodeId {
        self.node(NodeKind::Function, range(it.span), |b| {
            b.scoped(it.span, |b| {
                b.visit_formal_parameters(&it.params);
                if let Some(body) = &it.body {
                    b.visit_function_body(body);
                }
            });
        })
    }

    fn property(&mut self, key: &js::PropertyKey, value: Option<&js::Expression>) {
        let name = match key {
            js::PropertyKey::StringLiteral(it) => inside(it.span),
            js::PropertyKey::StaticIdentifier(it) => range(it.span),
            other => range(other.span()),
        };
        let end = value.map_or(name.end, |v| v.span().end as usize);
        let span = name.start..end;
        self.node(NodeKind::Property(name), span, |b| {
            if let Some(value) = value {
                b.expression(value);
            }
        });
    }

    /// Adds the names that a pattern declares; only a plain name has a known value.
    fn pattern(&mut self, it: &js::BindingPattern, value: BindingValue) {
        match it {
            js::BindingPattern::BindingIdentifier(name) => self.bind(name.span, value),
            other => walk::walk_binding_pattern(self, other),
        }
    }

    fn export(&mut self, name: &js::ModuleExportName, export: Export) {
        let exports = &mut self.tree.exports;
        exports.insert(name.name().to_string(), export);
    }
}

impl<'a> Visit<'a> for TreeBuilder<'_> {
    fn visit_expression(&mut self, it: &js::Expression<'a>) {
        self.expression(it);
    }

    fn visit_statement(&mut self, it: &js::Statement<'a>) {
        self.depth += 1;
        if self.depth < MAX_DEPTH {
            walk::walk_statement(self, it);
        }
        self.depth -= 1;
    }

    fn visit_block_statement(&mut self, it: &js::BlockStatement<'a>) {
        self.scoped(it.span, |b| walk::walk_block_statement(b, it));
    }

    fn visit_for_statement(&mut self, it: &js::ForStatement<'a>) {
        self.scoped(it.span, |b| walk::walk_for_statement(b, it));
    }

    fn visit_catch_clause(&mut self, it: &js::CatchClause<'a>) {
        self.scoped(it.span, |b| walk::walk_catch_clause(b, it));
    }

    fn visit_object_property(&mut self, it: &js::ObjectProperty<'a>) {
        self.property(&it.key, Some(&it.value));
    }

    fn visit_static_member_expression(&mut self, it: &js::StaticMemberExpression<'a>) {
        self.member(it);
    }

    fn visit_binding_property(&mut self, it: &js::BindingProperty<'a>) {
        self.property(&it.key, None);
        walk::walk_binding_property(self, it);
    }

    fn visit_spread_element(&mut self, it: &js::SpreadElement<'a>) {
        self.node(NodeKind::Spread, range(it.span), |b| {
            b.expression(&it.argument);
        });
    }

    fn visit_property_definition(&mut self, it: &js::PropertyDefinition<'a>) {
        self.property(&it.key, it.value.as_ref());
    }

    fn visit_variable_declarator(&mut self, it: &js::VariableDeclarator<'a>) {
        let name = range(it.id.span());
        let id = self.node(NodeKind::Variable(name), range(it.span), |b| {
            if let Some(value) = &it.init {
                b.expression(value);
            }
        });
        let value = match it.init.as_ref().and_then(required) {
            Some(path) => BindingValue::Import(path, "default".to_string()),
            None => {
                let value = self.tree.child(id, 0);
                value.map_or(BindingValue::Unknown, BindingValue::Node)
            }
        };
        self.pattern(&it.id, value);
    }

    fn visit_binding_identifier(&mut self, it: &js::BindingIdentifier<'a>) {
        self.bind(it.span, BindingValue::Unknown);
    }

    fn visit_function(&mut self, it: &js::Function<'a>, _: oxc_syntax::scope::ScopeFlags) {
        let id = self.function(it);
        if let Some(name) = &it.id {
            self.bind(name.span, BindingValue::Node(id));
        }
    }

    fn visit_class(&mut self, it: &js::Class<'a>) {
        let extended = it
            .heritage
            .as_ref()
            .map_or(0..0, |class| range(class.expression.span()));
        let id = self.node(NodeKind::Class(extended), range(it.span), |b| {
            walk::walk_class(b, it)
        });
        if let Some(name) = &it.id {
            self.bind(name.span, BindingValue::Node(id));
        }
    }

    fn visit_return_statement(&mut self, it: &js::ReturnStatement<'a>) {
        self.node(NodeKind::Return, range(it.span), |b| {
            walk::walk_return_statement(b, it)
        });
    }

    fn visit_throw_statement(&mut self, it: &js::ThrowStatement<'a>) {
        self.node(NodeKind::Throw, range(it.span), |b| {
            walk::walk_throw_statement(b, it)
        });
    }

    fn visit_jsx_element(&mut self, it: &js::JSXElement<'a>) {
        let opening = &it.opening_element;
        let name = range(opening.name.span());
        self.node(NodeKind::Element(name), range(it.span), |b| {
            for attribute in &opening.attributes {
                b.visit_jsx_attribute_item(attribute);
            }
            for child in &it.children {
                b.visit_jsx_child(child);
            }
        });
    }

    fn visit_jsx_attribute(&mut self, it: &js::JSXAttribute<'a>) {
        let name = range(it.name.span());
        self.node(NodeKind::Attribute(name), range(it.span), |b| {
            if let Some(js::JSXAttributeValue::StringLiteral(text)) = &it.value {
                b.node(NodeKind::Text, inside(text.span), |_| {});
            } else if let Some(value) = &it.value {
                b.visit_jsx_attribute_value(value);
            }
        });
    }

    fn visit_import_declaration(&mut self, it: &js::ImportDeclaration<'a>) {
        let path = it.source.value.to_string();
        for specifier in it.specifiers.iter().flatten() {
            let imported = match specifier {
                js::ImportDeclarationSpecifier::ImportSpecifier(it) => {
                    it.imported.name().to_string()
                }
                js::ImportDeclarationSpecifier::ImportDefaultSpecifier(_) => "default".to_string(),
                js::ImportDeclarationSpecifier::ImportNamespaceSpecifier(_) => "*".to_string(),
            };
            let local = specifier.local().span;
            self.bind(local, BindingValue::Import(path.clone(), imported));
        }
    }

    fn visit_export_declaration(&mut self, it: &js::ExportDeclaration<'a>) {
        let from = self.tree.bindings.len();
        walk::walk_export_declaration(self, it);
        let names = self.tree.bindings.get(from..).unwrap_or(&[]);
        let top = self.scopes.first();
        let names = names.iter().filter(|b| Some(&b.scope) == top);
        let exports = names.map(|b| (self.text.get(b.name.clone()), b.name.clone()));
        let exports =
            exports.filter_map(|(word, name)| Some((word?.to_string(), Export::Name(name))));
        self.tree.exports.extend(exports.collect::<Vec<_>>());
    }

    fn visit_export_named_declaration(&mut self, it: &js::ExportNamedDeclaration<'a>) {
        for specifier in &it.specifiers {
            let local = range(specifier.local.span());
            self.export(&specifier.exported, Export::Name(local));
        }
    }

    fn visit_export_from_declaration(&mut self, it: &js::ExportFromDeclaration<'a>) {
        let path = it.source.value.to_string();
        for specifier in &it.specifiers {
            let name = specifier.local.name().to_string();
            self.export(&specifier.exported, Export::Other(path.clone(), name));
        }
    }

    fn visit_export_all_declaration(&mut self, it: &js::ExportAllDeclaration<'a>) {
        if it.exported.is_none() {
            self.tree.passed_on.push(it.source.value.to_string());
        }
    }

    fn visit_export_default_declaration(&mut self, it: &js::ExportDefaultDeclaration<'a>) {
        let id = self.tree.nodes.len();
        walk::walk_export_default_declaration(self, it);
        if id < self.tree.nodes.len() {
            self.tree
                .exports
                .insert("default".to_string(), Export::Node(id));
        }
    }

    // Types hold no text.
    fn visit_ts_type(&mut self, _: &js::TSType<'a>) {}
    fn visit_ts_type_annotation(&mut self, _: &js::TSTypeAnnotation<'a>) {}
    fn visit_ts_interface_declaration(&mut self, _: &js::TSInterfaceDeclaration<'a>) {}
    fn visit_ts_type_alias_declaration(&mut self, _: &js::TSTypeAliasDeclaration<'a>) {}
}
