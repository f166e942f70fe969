//! Statements.

use super::body::{Body, Bound};
use super::types::Sink;
use super::{Res, Value};
use crate::semantic::VariableId;
use crate::syntax::ast::{DeclId, DeclKind, Declarator, ExprId, StmtId, StmtKind};
use ::naga::{Block, Statement, SwitchCase, SwitchValue, UnaryOperator};

impl Body<'_, '_> {
    /// Lowers a statement.
    pub(super) fn statement(&mut self, id: StmtId) -> Res<()> {
        self.depth += 1;
        self.check_limits()?;
        let program = self.lowerer.program;
        let stmt = program.tree.stmt(id);
        self.lowerer.place = program.span(stmt.extent);
        match stmt.kind {
            StmtKind::Empty => {}
            StmtKind::Expr(e) => self.run(e)?,
            StmtKind::Decl(decl) => self.declaration(decl)?,
            StmtKind::Block(list) => self.statements(program.tree.block(list))?,
            StmtKind::If {
                condition,
                then,
                otherwise,
            } => self.branches(condition, then, otherwise)?,
            StmtKind::Switch { selector, body } => {
                self.switch(selector, program.tree.block(body))?;
            }
            StmtKind::For {
                init,
                condition,
                step,
                body,
            } => {
                self.statement(init)?;
                self.repeat(condition, step, body)?;
            }
            StmtKind::While { condition, body } => self.repeat(Some(condition), None, body)?,
            StmtKind::Do { body, condition } => self.repeat_until(body, condition)?,
            StmtKind::Break => self.push(Statement::Break),
            StmtKind::Continue => self.push(Statement::Continue),
            StmtKind::Return(value) => self.give(value)?,
            StmtKind::Discard => self.push(Statement::Kill),
            StmtKind::Case(_) | StmtKind::Default | StmtKind::Error => {
                return self
                    .lowerer
                    .refuse("this statement stands outside a `switch`");
            }
        }
        self.depth -= 1;
        Ok(())
    }

    /// Lowers statements up to the first that nothing passes.
    fn statements(&mut self, all: &[StmtId]) -> Res<()> {
        for stmt in all {
            self.statement(*stmt)?;
            if self.is_terminated() {
                break;
            }
        }
        Ok(())
    }

    fn give(&mut self, value: Option<ExprId>) -> Res<()> {
        let value = match value {
            Some(e) if self.returns.is_void() => {
                self.run(e)?;
                None
            }
            Some(e) => Some(self.value(e)?),
            None => None,
        };
        self.push(Statement::Return { value });
        Ok(())
    }

    fn branches(&mut self, condition: ExprId, then: StmtId, otherwise: Option<StmtId>) -> Res<()> {
        let condition = self.value(condition)?;
        let accept = self.nested(|body| body.statement(then))?;
        let reject = self.nested(|body| otherwise.map_or(Ok(()), |o| body.statement(o)))?;
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        Ok(())
    }

    fn declaration(&mut self, id: DeclId) -> Res<()> {
        let program = self.lowerer.program;
        let Some(decl) = program.tree.decl(id) else {
            return Ok(());
        };
        let DeclKind::Variables { declarators, .. } = decl.kind else {
            return Ok(());
        };
        for (i, declarator) in program.tree.declarators(declarators).iter().enumerate() {
            let declared = program.declared.get(declarators.start as usize + i);
            if let Some(variable) = declared.copied().flatten() {
                self.lowerer.place = program.span(declarator.extent);
                self.declare(variable, declarator)?;
            }
        }
        Ok(())
    }

    fn declare(&mut self, id: VariableId, declarator: &Declarator) -> Res<()> {
        let program = self.lowerer.program;
        let Some(variable) = program.variable(id) else {
            return Ok(());
        };
        let ty = variable.ty;
        let is_plain = ty.is_scalar() || ty.is_vector();
        if variable.is_const
            && variable.constant.is_known()
            && !is_plain
            && self.lowerer.constant(id)?.is_some()
        {
            return Ok(());
        }
        let name = program.names.text(variable.name);
        let value = declarator.init.map(|init| self.value(init)).transpose()?;
        if let (Some(value), false, true) = (value, variable.written, is_plain && !self.in_switch) {
            self.name(value, name);
            self.variables.insert(id, Bound::Value(value));
            return Ok(());
        }
        let pointer = self.local(Some(name), ty)?;
        self.variables.insert(id, Bound::Pointer(pointer));
        // Browsers start variables at zero, in each turn of a loop.
        let value = match value {
            None if self.loops > 0 => Some(self.zero(ty)?),
            given => given,
        };
        if let Some(value) = value {
            self.store(pointer, value);
        }
        Ok(())
    }

    /// Keeps the name of a variable that never changes.
    fn name(&mut self, value: Value, name: &str) {
        let is_free = self.function.expressions[value].needs_pre_emit();
        let names = &mut self.function.named_expressions;
        if !is_free && !names.contains_key(&value) {
            names.insert(value, name.to_string());
        }
    }

    fn repeat(&mut self, condition: Option<StmtId>, step: Option<ExprId>, body: StmtId) -> Res<()> {
        self.loops += 1;
        let in_switch = std::mem::replace(&mut self.in_switch, false);
        let turn = self.nested(|it| {
            if let Some(condition) = condition {
                let holds = it.condition(condition)?;
                it.leave_unless(holds)?;
            }
            it.statement(body)
        })?;
        let continuing = self.nested(|it| step.map_or(Ok(()), |step| it.run(step)))?;
        self.in_switch = in_switch;
        self.loops -= 1;
        self.push(Statement::Loop {
            body: turn,
            continuing,
            break_if: None,
        });
        Ok(())
    }

    /// The condition of a loop, which may declare a variable.
    fn condition(&mut self, id: StmtId) -> Res<Value> {
        let program = self.lowerer.program;
        match program.tree.stmt(id).kind {
            StmtKind::Expr(e) => self.value(e),
            StmtKind::Decl(decl) => {
                self.declaration(decl)?;
                let declared = match program.tree.decl(decl).map(|d| d.kind) {
                    Some(DeclKind::Variables { declarators, .. }) => {
                        program.declared.get(declarators.start as usize)
                    }
                    _ => None,
                };
                match declared.copied().flatten() {
                    Some(variable) => match self.bound(variable)? {
                        Bound::Pointer(pointer) => Ok(self.load(pointer)),
                        Bound::Value(value) => Ok(value),
                        Bound::Sampler { .. } => self.lowerer.refuse("this is no condition"),
                    },
                    None => self.lowerer.refuse("this is no condition"),
                }
            }
            _ => Ok(self.add(::naga::Expression::Literal(::naga::Literal::Bool(true)))),
        }
    }

    fn leave_unless(&mut self, holds: Value) -> Res<()> {
        let reject = self.nested(|it| {
            it.push(Statement::Break);
            Ok(())
        })?;
        self.push(Statement::If {
            condition: holds,
            accept: Block::new(),
            reject,
        });
        Ok(())
    }

    fn repeat_until(&mut self, body: StmtId, condition: ExprId) -> Res<()> {
        self.loops += 1;
        let in_switch = std::mem::replace(&mut self.in_switch, false);
        let turn = self.nested(|it| it.statement(body))?;
        let mut done = None;
        let continuing = self.nested(|it| {
            let expr = it.value(condition)?;
            let op = UnaryOperator::LogicalNot;
            done = Some(it.add(::naga::Expression::Unary { op, expr }));
            Ok(())
        })?;
        self.in_switch = in_switch;
        self.loops -= 1;
        self.push(Statement::Loop {
            body: turn,
            continuing,
            break_if: done,
        });
        Ok(())
    }

    /// Naga lets nothing but empty cases fall through, so what follows is written out again.
    fn switch(&mut self, selector: ExprId, body: &[StmtId]) -> Res<()> {
        let program = self.lowerer.program;
        let is_label = |s: &StmtId| {
            matches!(
                program.tree.stmt(*s).kind,
                StmtKind::Case(_) | StmtKind::Default
            )
        };
        let selector = self.value(selector)?;
        let in_switch = std::mem::replace(&mut self.in_switch, true);
        let mut cases = Vec::new();
        for (at, label) in body.iter().enumerate().filter(|(_, s)| is_label(s)) {
            let value = self.label(*label)?;
            let rest = body.get(at + 1..).unwrap_or(&[]);
            let is_empty = rest.first().is_some_and(is_label);
            let block = if is_empty {
                Block::new()
            } else {
                let code: Vec<StmtId> = rest.iter().copied().filter(|s| !is_label(s)).collect();
                self.nested(|it| it.statements(&code))?
            };
            cases.push(SwitchCase {
                value,
                body: block,
                fall_through: is_empty,
            });
        }
        self.in_switch = in_switch;
        if !cases.iter().any(|c| c.value == SwitchValue::Default) {
            cases.push(SwitchCase {
                value: SwitchValue::Default,
                body: Block::new(),
                fall_through: false,
            });
        }
        self.push(Statement::Switch { selector, cases });
        Ok(())
    }

    fn label(&mut self, id: StmtId) -> Res<SwitchValue> {
        let program = self.lowerer.program;
        let StmtKind::Case(value) = program.tree.stmt(id).kind else {
            return Ok(SwitchValue::Default);
        };
        match program.scalar(value) {
            Some(crate::semantic::Value::Int(v)) => Ok(SwitchValue::I32(v)),
            Some(crate::semantic::Value::Uint(v)) => Ok(SwitchValue::U32(v)),
            _ => self.refuse(value, "the value of this label is not known"),
        }
    }
}
