//! Statements (GLSL ES 3.00 section 6).

use super::super::constant::Value;
use super::finish::LoopCheck;
use super::*;

/// Deepest nesting of statements that is checked; the limit of the parser is lower.
const MAX_DEPTH: u32 = 400;

/// An error in a statement.
#[derive(Clone, Copy, Debug)]
pub enum StatementError {
    /// `break` outside of loops and `switch`.
    Break,
    /// `continue` outside of loops.
    Continue,
    /// `discard` outside of fragment shaders.
    Discard,
    /// A condition that declares a variable of another type than `bool`.
    Condition(Condition, Type),
    /// A condition that is not a `bool`.
    NoCondition(ExprId, Condition, Type),
    /// A `return` with a value of the wrong type, or without the value it needs.
    Return(Option<ExprId>, TypeMismatch),
    /// A loop that never terminates, and the variable that it tests.
    Endless(Option<VariableId>),
}

/// The statement or operator that a condition belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Condition {
    /// `? :`
    Choice,
    If,
    For,
    While,
}

impl Checker<'_> {
    /// The statements of a block, in the current scope.
    pub(super) fn statements(&mut self, list: List) {
        let tree = self.tree;
        for &id in tree.block(list) {
            if self.gave_up() {
                return;
            }
            self.statement(id);
        }
    }

    /// A statement with a scope of its own.
    fn scoped(&mut self, id: StmtId, kind: FlowKind) {
        self.open_scope();
        self.open_flow(kind);
        self.unscoped(id);
        self.close_flow();
        self.close_scope();
    }

    /// A statement that opens no further scope, even if it is a block.
    fn unscoped(&mut self, id: StmtId) {
        self.level += 1;
        match self.tree.stmt(id).kind {
            StmtKind::Block(list) => {
                self.level += 1;
                self.statements(list);
                self.level -= 1;
            }
            _ => {
                self.level += 1;
                self.statement(id);
                self.level -= 1;
            }
        }
        self.level -= 1;
    }

    pub(super) fn open_scope(&mut self) {
        self.scopes.push();
        self.precisions.push();
    }

    pub(super) fn close_scope(&mut self) {
        self.precisions.pop();
        self.scopes.pop();
    }

    pub(super) fn open_flow(&mut self, kind: FlowKind) {
        self.flow.push(Flow {
            kind,
            has_break: false,
            has_return: false,
            labels: FxHashMap::default(),
            loop_index: None,
        });
    }

    /// Ends a statement and passes what it contains to the one around it. A `break` in a block or
    /// `if` also leaves the enclosing statement; one in a loop or `switch` does not.
    pub(super) fn close_flow(&mut self) -> Option<Flow> {
        let ended = self.flow.pop()?;
        if let Some(outer) = self.flow.last_mut() {
            outer.has_return |= ended.has_return;
            if matches!(ended.kind, FlowKind::Block | FlowKind::If) {
                outer.has_break |= ended.has_break;
            }
        }
        Some(ended)
    }

    fn statement(&mut self, id: StmtId) {
        let tree = self.tree;
        let stmt = tree.stmt(id);
        if self.level > MAX_DEPTH * 2 {
            return;
        }
        // A statement that the browser may remove is checked once it is known whether it does.
        let is_label = matches!(stmt.kind, StmtKind::Case(_) | StmtKind::Default);
        if !is_label && !self.may_be_dropped(id) {
            self.check_label_before(stmt.extent);
        }
        match stmt.kind {
            StmtKind::Error => self.syntax_errors = true,
            StmtKind::Empty => {}
            StmtKind::Expr(expr) if self.declares_nothing(expr) => {}
            StmtKind::Expr(expr) => {
                self.root(expr, self.level);
                self.check_no_block(expr);
            }
            StmtKind::Decl(decl) => self.declaration(decl),
            StmtKind::Block(list) => {
                self.open_scope();
                self.open_flow(FlowKind::Block);
                self.check_depth(self.level, stmt.extent);
                self.level += 1;
                self.statements(list);
                self.level -= 1;
                self.close_flow();
                self.close_scope();
            }
            StmtKind::If { .. } => {
                self.if_statement(id);
                if !self.is_dropped(id) {
                    self.check_label_before(stmt.extent);
                }
            }
            StmtKind::Switch { selector, body } => self.switch(selector, body),
            StmtKind::Case(value) => self.case(value, stmt.extent),
            StmtKind::Default => self.label(None, stmt.extent.first),
            StmtKind::For {
                init,
                condition,
                step,
                body,
            } => {
                self.for_loop(init, condition, step, body, stmt.extent);
            }
            StmtKind::While { condition, body } => self.while_loop(condition, body, stmt.extent),
            StmtKind::Do { body, condition } => self.do_loop(body, condition, stmt.extent),
            StmtKind::Break => self.break_statement(stmt.extent),
            StmtKind::Continue => {
                if !self.flow.iter().any(|f| f.kind == FlowKind::Loop) {
                    self.reject(stmt.extent, StatementError::Continue);
                }
            }
            StmtKind::Discard => {
                if self.stage != Stage::Fragment {
                    self.reject(stmt.extent, StatementError::Discard);
                }
            }
            StmtKind::Return(value) => self.return_statement(value, stmt.extent),
        }
    }

    /// `S;` for a struct, which parses as an expression but is a declaration without a name. The
    /// size in `S[2];` is still checked.
    fn declares_nothing(&mut self, expr: ExprId) -> bool {
        let (named, size) = match self.tree.expr(expr).kind {
            ExprKind::Index(array, size) => (array, Some(size)),
            _ => (expr, None),
        };
        let ExprKind::Name(name) = self.tree.expr(named).kind else {
            return false;
        };
        if !matches!(self.scopes.get(name), Some(Binding::Struct(_))) {
            return false;
        }
        // Every expression of the tree needs an entry; these two have nothing to check.
        self.exprs.push(ExprInfo::ERROR);
        if let Some(size) = size {
            self.root(size, self.level);
            self.exprs.push(ExprInfo::ERROR);
        }
        true
    }

    /// Reports the instance of a block, or an element of an array of them, as a statement.
    fn check_no_block(&mut self, expr: ExprId) {
        if matches!(self.ty(expr).base, Base::Block(_)) {
            self.reject(self.tree.expr(expr).extent, RecordError::BlockAlone);
        }
    }

    /// Checks an expression that is a node at `level` of the browser's tree.
    pub(super) fn root(&mut self, expr: ExprId, level: u32) {
        self.eval(expr);
        let height = self.info(expr).height as u32;
        self.check_depth(level + height, self.tree.expr(expr).extent);
    }

    fn condition(&mut self, expr: ExprId, of: Condition) {
        self.root(expr, self.level + 1);
        let ty = self.ty(expr);
        if ty.is_error() {
            return;
        }
        match typing::condition(ty) {
            Ok(()) => {}
            Err(TypeMismatch::Condition(ty)) => {
                self.reject_expr(expr, StatementError::NoCondition(expr, of, ty));
            }
            Err(mismatch) => {
                self.refuse(expr, &[expr], mismatch);
            }
        }
    }

    /// A chain of `if` and `else if`, without recursion.
    fn if_statement(&mut self, id: StmtId) {
        let tree = self.tree;
        let mut at = id;
        let base = self.level;
        let mut open = 0;
        loop {
            let stmt = tree.stmt(at);
            let StmtKind::If {
                condition,
                then,
                otherwise,
            } = stmt.kind
            else {
                break;
            };
            self.condition(condition, Condition::If);
            self.scoped(then, FlowKind::If);
            match otherwise {
                None => break,
                Some(next) if matches!(tree.stmt(next).kind, StmtKind::If { .. }) => {
                    // In the browser's tree it is in a block of the previous `if`.
                    self.open_flow(FlowKind::If);
                    open += 1;
                    self.level += 2;
                    self.check_depth(self.level, tree.stmt(next).extent);
                    at = next;
                }
                Some(next) => {
                    self.scoped(next, FlowKind::If);
                    break;
                }
            }
        }
        for _ in 0..open {
            self.close_flow();
        }
        self.level = base;
    }

    fn for_loop(
        &mut self,
        init: StmtId,
        condition: Option<StmtId>,
        step: Option<ExprId>,
        body: StmtId,
        extent: Extent,
    ) {
        self.open_scope();
        self.open_flow(FlowKind::Loop);
        self.level += 1;
        self.statement(init);
        let index = self.check_webgl1_init(init, extent);
        if let Some(condition) = condition {
            self.loop_condition(condition, Condition::For);
        }
        self.check_webgl1_condition(condition, index, extent);
        if let Some(step) = step {
            self.root(step, self.level);
        }
        self.check_webgl1_step(step, index, extent);
        self.level -= 1;
        if let Some(flow) = self.flow.last_mut() {
            flow.loop_index = index;
        }
        self.unscoped(body);
        self.end_loop(condition, extent);
        self.close_scope();
    }

    fn while_loop(&mut self, condition: StmtId, body: StmtId, extent: Extent) {
        self.open_scope();
        self.open_flow(FlowKind::Loop);
        self.refuse_webgl1_loop("while", extent);
        self.level += 1;
        self.loop_condition(condition, Condition::While);
        self.level -= 1;
        self.unscoped(body);
        self.end_loop(Some(condition), extent);
        self.close_scope();
    }

    fn do_loop(&mut self, body: StmtId, condition: ExprId, extent: Extent) {
        self.open_flow(FlowKind::Loop);
        self.refuse_webgl1_loop("do", extent);
        self.open_scope();
        self.unscoped(body);
        self.close_scope();
        self.condition(condition, Condition::While);
        self.close_flow();
    }

    /// The condition of `for` or `while`, which may declare a `bool`.
    fn loop_condition(&mut self, id: StmtId, of: Condition) {
        let tree = self.tree;
        let stmt = tree.stmt(id);
        match stmt.kind {
            StmtKind::Expr(expr) => {
                self.level -= 1;
                self.condition(expr, of);
                self.level += 1;
            }
            StmtKind::Decl(decl) => {
                self.declaration(decl);
                let Some(DeclKind::Variables { declarators, .. }) = tree.decl(decl).map(|d| d.kind)
                else {
                    return;
                };
                let id = self
                    .declared
                    .get(declarators.start as usize)
                    .copied()
                    .flatten();
                let ty = id
                    .and_then(|v| self.variables.get(v.0 as usize))
                    .map_or(Type::ERROR, |v| v.ty);
                if !ty.is_error() && ty != Type::BOOL {
                    self.reject(stmt.extent, StatementError::Condition(of, ty));
                }
            }
            _ => {}
        }
    }

    /// Reports a loop with an always-true condition and no `break` or `return`, which browsers
    /// reject.
    fn end_loop(&mut self, condition: Option<StmtId>, extent: Extent) {
        let Some(flow) = self.close_flow() else {
            return;
        };
        if flow.has_break || flow.has_return {
            return;
        }
        let keyword = Extent::token(extent.first);
        let Some(condition) = condition else {
            return self.reject(keyword, StatementError::Endless(None));
        };
        let StmtKind::Expr(expr) = self.tree.stmt(condition).kind else {
            return;
        };
        let info = self.info(expr);
        match self.pool.scalar(info.constant) {
            Some(Value::Bool(true)) if info.is_const => {
                self.reject(keyword, StatementError::Endless(None))
            }
            Some(_) if info.is_const => {}
            _ => {
                if let Some(variable) = self.base_variable(expr)
                    && self.always_true.contains(&variable)
                    && self
                        .variables
                        .get(variable.0 as usize)
                        .is_some_and(|v| !v.written)
                {
                    self.loops.push(LoopCheck { variable, keyword });
                }
            }
        }
    }

    /// Records a `bool` that is initialized with `true`.
    pub(super) fn track_always_true(&mut self, id: VariableId, init: ExprInfo, ty: Type) {
        if ty == Type::BOOL && self.pool.scalar(init.constant) == Some(Value::Bool(true)) {
            self.always_true.insert(id);
        }
    }

    fn break_statement(&mut self, extent: Extent) {
        let inside = self
            .flow
            .iter()
            .any(|f| matches!(f.kind, FlowKind::Loop | FlowKind::Switch(_)));
        if !inside {
            return self.reject(extent, StatementError::Break);
        }
        if let Some(flow) = self.flow.last_mut() {
            flow.has_break = true;
        }
    }

    fn return_statement(&mut self, value: Option<ExprId>, extent: Extent) {
        if let Some(flow) = self.flow.last_mut() {
            flow.has_return = true;
        }
        let expected = self.returned;
        let Some(value) = value else {
            if let Err(mismatch) = typing::returned(expected, None) {
                self.reject(extent, StatementError::Return(None, mismatch));
                self.returns_value = true;
            }
            return;
        };
        self.returns_value = true;
        self.expected = Some(expected);
        self.root(value, self.level + 1);
        self.expected = None;
        if let Err(mismatch) = typing::returned(expected, Some(self.ty(value))) {
            self.reject(extent, StatementError::Return(Some(value), mismatch));
        }
    }
}
