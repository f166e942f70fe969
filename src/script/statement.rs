//! Statements.

use crate::branch::StatementEnd;
use crate::evaluator::Evaluator;
use crate::value::ScriptValue;
use crate::world::ScopeId;
use oxc_ast::ast as js;
use oxc_span::GetSpan;

impl<'a> Evaluator<'a, '_> {
    /// The statements of a block; its functions are declared first.
    pub fn statements(&mut self, scope: ScopeId, all: &'a [js::Statement<'a>]) -> StatementEnd {
        for statement in all {
            self.hoist(scope, statement);
        }
        for statement in all {
            let flow = self.statement(scope, statement);
            if flow != StatementEnd::Next {
                return flow;
            }
        }
        StatementEnd::Next
    }

    /// Declares a function before the statements around it.
    fn hoist(&mut self, scope: ScopeId, statement: &'a js::Statement<'a>) {
        let function = match statement {
            js::Statement::FunctionDeclaration(function) => function,
            js::Statement::ExportDeclaration(export) => match &export.declaration {
                js::Declaration::FunctionDeclaration(function) => function,
                _ => return,
            },
            js::Statement::ExportDefaultDeclaration(export) => match &export.declaration {
                js::ExportDefaultDeclarationKind::FunctionDeclaration(function) => function,
                _ => return,
            },
            _ => return,
        };
        if let (Some(name), Some(_)) = (&function.id, &function.body) {
            let value = self.function(scope, function);
            self.declare(scope, name.name.as_str(), value);
        }
    }

    pub fn statement(&mut self, scope: ScopeId, statement: &'a js::Statement<'a>) -> StatementEnd {
        let run = self.nested(|e| e.statement_inside(scope, statement));
        run.unwrap_or(StatementEnd::Next)
    }

    fn statement_inside(
        &mut self,
        scope: ScopeId,
        statement: &'a js::Statement<'a>,
    ) -> StatementEnd {
        match statement {
            js::Statement::BlockStatement(block) => {
                let inner = self.scope(Some(scope));
                return self.statements(inner, &block.body);
            }
            js::Statement::ExpressionStatement(it) => {
                self.expression(scope, &it.expression);
            }
            js::Statement::VariableDeclaration(it) => self.variables(scope, it),
            js::Statement::ClassDeclaration(it) => {
                let value = self.class(scope, it);
                if let Some(name) = &it.id {
                    self.declare(scope, name.name.as_str(), value);
                }
            }
            js::Statement::IfStatement(it) => return self.condition(scope, it),
            js::Statement::ReturnStatement(it) => {
                let value = match &it.argument {
                    Some(argument) => self.expression(scope, argument),
                    None => ScriptValue::Undefined,
                };
                if let Some(frame) = self.frames.last_mut() {
                    frame.results.push(value);
                }
                return StatementEnd::Return;
            }
            js::Statement::ThrowStatement(it) => {
                self.expression(scope, &it.argument);
                return StatementEnd::Throw;
            }
            js::Statement::BreakStatement(_) => return StatementEnd::Break,
            js::Statement::ContinueStatement(_) => return StatementEnd::Continue,
            js::Statement::LabeledStatement(it) => return self.statement(scope, &it.body),
            js::Statement::TryStatement(it) => return self.attempt(scope, it),
            js::Statement::SwitchStatement(it) => return self.switch(scope, it),
            js::Statement::WhileStatement(it) => {
                return self.iterate(
                    &mut |e| {
                        let test = e.expression(scope, &it.test);
                        e.truth(&test)
                    },
                    &mut |e| e.statement(scope, &it.body),
                );
            }
            js::Statement::DoWhileStatement(it) => {
                let flow = self.statement(scope, &it.body);
                self.expression(scope, &it.test);
                return if flow.ends_function() {
                    flow
                } else {
                    StatementEnd::Next
                };
            }
            js::Statement::ForStatement(it) => return self.for_loop(scope, it),
            js::Statement::ForOfStatement(it) => {
                let all = self.expression(scope, &it.right);
                let elements = self.iterated(&all);
                return self.each(scope, (&it.left, &it.body), elements);
            }
            js::Statement::ForInStatement(it) => {
                let all = self.expression(scope, &it.right);
                let keys = self.keys(&all);
                return self.each(scope, (&it.left, &it.body), keys);
            }
            _ => self.module_item(scope, statement),
        }
        StatementEnd::Next
    }

    pub fn variables(&mut self, scope: ScopeId, it: &'a js::VariableDeclaration<'a>) {
        for declarator in &it.declarations {
            let value = match &declarator.init {
                Some(init) => self.expression(scope, init),
                // A declared global of TypeScript.
                None if it.declare => continue,
                None => ScriptValue::Undefined,
            };
            self.bind(scope, &declarator.id, value);
        }
    }

    fn condition(&mut self, scope: ScopeId, it: &'a js::IfStatement<'a>) -> StatementEnd {
        let test = self.expression(scope, &it.test);
        self.world.optional.extend(test.object());
        match (self.truth(&test), &it.alternate) {
            (Some(true), _) => self.statement(scope, &it.consequent),
            (Some(false), Some(other)) => self.statement(scope, other),
            (Some(false), None) => StatementEnd::Next,
            (None, None) => {
                let mut then =
                    |e: &mut Self| (e.statement(scope, &it.consequent), ScriptValue::Undefined);
                self.ways(&mut [&mut then]).0
            }
            (None, Some(other)) => {
                let mut then =
                    |e: &mut Self| (e.statement(scope, &it.consequent), ScriptValue::Undefined);
                let mut otherwise =
                    |e: &mut Self| (e.statement(scope, other), ScriptValue::Undefined);
                self.ways(&mut [&mut then, &mut otherwise]).0
            }
        }
    }

    fn attempt(&mut self, scope: ScopeId, it: &'a js::TryStatement<'a>) -> StatementEnd {
        let inner = self.scope(Some(scope));
        let flow = self.statements(inner, &it.block.body);
        if let Some(handler) = &it.handler {
            let mut catch = |e: &mut Self| {
                let inner = e.scope(Some(scope));
                if let Some(parameter) = &handler.param {
                    let value = e.unknown(e.place(parameter.span));
                    e.bind(inner, &parameter.pattern, value);
                }
                (
                    e.statements(inner, &handler.body.body),
                    ScriptValue::Undefined,
                )
            };
            self.ways(&mut [&mut catch]);
        }
        if let Some(last) = &it.finalizer {
            let inner = self.scope(Some(scope));
            self.statements(inner, &last.body);
        }
        match flow {
            StatementEnd::Throw => StatementEnd::Next,
            flow => flow,
        }
    }

    /// A `switch`: the cases from the one that is known to be equal, otherwise each case as a branch.
    fn switch(&mut self, scope: ScopeId, it: &'a js::SwitchStatement<'a>) -> StatementEnd {
        let value = self.expression(scope, &it.discriminant);
        let inner = self.scope(Some(scope));
        let mut tests = Vec::new();
        for case in &it.cases {
            tests.push(case.test.as_ref().map(|test| self.expression(inner, test)));
        }
        let is_known = |v: &ScriptValue| v.text().is_some() || v.number().is_some();
        let is_constant =
            |v: &ScriptValue| is_known(v) || self.world.call_of(v.object().unwrap_or(0)).is_none();
        let equal = tests
            .iter()
            .position(|t| t.as_ref().is_some_and(|t| t.is_same(&value)));
        let is_decided = is_known(&value) && tests.iter().flatten().all(is_constant);
        let default = tests.iter().position(Option::is_none);
        let run = |e: &mut Self, first: usize| {
            for case in it.cases.iter().skip(first) {
                let flow = e.statements(inner, &case.consequent);
                if flow != StatementEnd::Next {
                    return if flow == StatementEnd::Break {
                        StatementEnd::Next
                    } else {
                        flow
                    };
                }
            }
            StatementEnd::Next
        };
        match equal.or(default.filter(|_| is_decided)) {
            Some(first) => run(self, first),
            None if is_decided => StatementEnd::Next,
            None => {
                let mut all: Vec<_> = (0..it.cases.len())
                    .map(|first| move |e: &mut Self| (run(e, first), ScriptValue::Undefined))
                    .collect();
                let mut nothing = |_: &mut Self| (StatementEnd::Next, ScriptValue::Undefined);
                let mut ways: Vec<crate::branch::BranchCode<'_, 'a, '_>> = Vec::new();
                for way in &mut all {
                    ways.push(way);
                }
                if default.is_none() || ways.len() < 2 {
                    ways.push(&mut nothing);
                }
                self.ways(&mut ways).0
            }
        }
    }

    fn for_loop(&mut self, scope: ScopeId, it: &'a js::ForStatement<'a>) -> StatementEnd {
        let inner = self.scope(Some(scope));
        match &it.init {
            Some(js::ForStatementInit::VariableDeclaration(variables)) => {
                self.variables(inner, variables);
            }
            Some(other) => {
                if let Some(expression) = other.as_expression() {
                    self.expression(inner, expression);
                }
            }
            None => {}
        }
        let mut is_first = true;
        self.iterate(
            &mut |e| {
                if !std::mem::replace(&mut is_first, false)
                    && let Some(update) = &it.update
                {
                    e.expression(inner, update);
                }
                let test = e.expression(inner, it.test.as_ref()?);
                e.truth(&test)
            },
            &mut |e| e.statement(inner, &it.body),
        )
    }

    /// A loop over elements: those that are known, and whether there may be others.
    fn each(
        &mut self,
        scope: ScopeId,
        (left, body): (&'a js::ForStatementLeft<'a>, &'a js::Statement<'a>),
        (elements, is_open): (Vec<ScriptValue>, bool),
    ) -> StatementEnd {
        let inner = self.scope(Some(scope));
        let mut elements = elements.into_iter();
        self.iterate(
            &mut |e| {
                let (element, has) = match elements.next() {
                    Some(element) => (element, Some(true)),
                    None if !is_open => return Some(false),
                    None => (e.unknown(e.place(left.span())), None),
                };
                match left {
                    js::ForStatementLeft::VariableDeclaration(it) => {
                        if let Some(variable) = it.declarations.first() {
                            e.bind(inner, &variable.id, element);
                        }
                    }
                    other => {
                        if let Some(target) = other.as_assignment_target() {
                            e.assign(inner, target, element);
                        }
                    }
                }
                has
            },
            &mut |e| e.statement(inner, body),
        )
    }
}
