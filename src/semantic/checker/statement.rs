//! Statements (GLSL ES 3.00 section 6).

use super::super::constant::Value;
use super::finish::LoopCheck;
use super::*;

/// How deep the checker follows statements; the parser stops before.
const MAX_DEPTH: u32 = 400;

impl Checker<'_> {
    /// The statements of a block, in the scope that is open.
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

    /// A statement whose block, if it is one, opens no further scope.
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

    fn open_scope(&mut self) {
        self.scopes.push();
        self.precisions.push();
    }

    fn close_scope(&mut self) {
        self.precisions.pop();
        self.scopes.pop();
    }

    fn open_flow(&mut self, kind: FlowKind) {
        self.flow.push(Flow {
            kind,
            has_break: false,
            has_return: false,
            labels: FxHashMap::default(),
            loop_index: None,
        });
    }

    /// Ends a statement and tells the one around it what it holds. A `break` in a block or `if`
    /// leaves what is around too; one in a loop or `switch` does not.
    fn close_flow(&mut self) -> Option<Flow> {
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
        // What the browser may drop is looked at when it is known whether it does.
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
                    self.misplaced(stmt.extent, "`continue` can only stand in a loop");
                }
            }
            StmtKind::Discard => {
                if self.stage != Stage::Fragment {
                    self.misplaced(stmt.extent, "`discard` can only stand in a fragment shader");
                }
            }
            StmtKind::Return(value) => self.return_statement(value, stmt.extent),
        }
    }

    fn misplaced(&mut self, extent: Extent, message: &str) {
        let d = self.error(error::MISPLACED_JUMP, extent, message);
        self.report(d);
    }

    /// `S;` for a struct, which parses as an expression but is a declaration without a name. What
    /// `S[2];` says of its size is looked at all the same.
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
        // Expressions are checked in the order of the tree; these two have nothing to be checked.
        self.exprs.push(ExprInfo::ERROR);
        if let Some(size) = size {
            self.root(size, self.level);
            self.exprs.push(ExprInfo::ERROR);
        }
        true
    }

    /// The instance of a block, or an element of an array of them, is no statement.
    fn check_no_block(&mut self, expr: ExprId) {
        if matches!(self.ty(expr).base, Base::Block(_)) {
            let d = self
                .error_expr(
                    error::INTERFACE_BLOCK,
                    expr,
                    "a block cannot stand alone as a statement",
                )
                .help("name one of its members: `block.member`");
            self.report(d);
        }
    }

    /// An expression that is a node of its own at `level` of the browser's tree.
    pub(super) fn root(&mut self, expr: ExprId, level: u32) {
        self.eval(expr);
        let height = self.info(expr).height as u32;
        self.check_depth(level + height, self.tree.expr(expr).extent);
    }

    fn condition(&mut self, expr: ExprId, what: &str) {
        self.root(expr, self.level + 1);
        let ty = self.ty(expr);
        if ty.is_error() {
            return;
        }
        let d = match typing::condition(ty) {
            Ok(()) => return,
            Err(Misfit::Condition(ty)) => self.explain_condition(expr, ty, what),
            Err(misfit) => self.explain(expr, &[expr], misfit),
        };
        self.report(d);
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
            self.condition(condition, "the condition of `if`");
            self.scoped(then, FlowKind::If);
            match otherwise {
                None => break,
                Some(next) if matches!(tree.stmt(next).kind, StmtKind::If { .. }) => {
                    // In the browser's tree it stands in a block of the `if` before.
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
            self.loop_condition(condition, "the condition of the loop");
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
        self.loop_condition(condition, "the condition of `while`");
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
        self.condition(condition, "the condition of `while`");
        self.close_flow();
    }

    /// The condition of `for` or `while`, which may declare a `bool`.
    fn loop_condition(&mut self, id: StmtId, what: &str) {
        let tree = self.tree;
        let stmt = tree.stmt(id);
        match stmt.kind {
            StmtKind::Expr(expr) => {
                self.level -= 1;
                self.condition(expr, what);
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
                    let name = self.name_of(ty);
                    let message = format!("{what} must be `bool`, not `{name}`");
                    let d = self.error(error::CONDITION_TYPE, stmt.extent, message);
                    self.report(d);
                }
            }
            _ => {}
        }
    }

    /// A loop whose condition is always true, without a `break` or `return`, never ends, and
    /// browsers refuse it.
    fn end_loop(&mut self, condition: Option<StmtId>, extent: Extent) {
        let Some(flow) = self.close_flow() else {
            return;
        };
        if flow.has_break || flow.has_return {
            return;
        }
        let keyword = Extent::token(extent.first);
        let Some(condition) = condition else {
            return self.infinite_loop(keyword, None);
        };
        let StmtKind::Expr(expr) = self.tree.stmt(condition).kind else {
            return;
        };
        let info = self.info(expr);
        match self.pool.scalar(info.constant) {
            Some(Value::Bool(true)) if info.is_const => self.infinite_loop(keyword, None),
            Some(_) if info.is_const => {}
            _ => {
                if let Some(variable) = self.variable_behind(expr)
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

    pub(super) fn infinite_loop(&mut self, keyword: Extent, variable: Option<VariableId>) {
        let d = self
            .error(error::INFINITE_LOOP, keyword, "this loop never ends")
            .note("browsers refuse a loop whose condition is always true and that has no `break` or `return`");
        let d = match variable.and_then(|v| self.variables.get(v.0 as usize)) {
            Some(v) => {
                let name = self.text(v.name);
                let d = self.with_declaration(d, v.token, "true from the start, and never changed");
                d.help(format!(
                    "set `{name}` to false somewhere, or give the loop a bound"
                ))
            }
            None => d.help("give it a bound: `for (int i = 0; i < 100; i++)`"),
        };
        self.report(d);
    }

    /// Remembers a `bool` that starts as true.
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
            return self.misplaced(extent, "`break` can only stand in a loop or `switch`");
        }
        if let Some(flow) = self.flow.last_mut() {
            flow.has_break = true;
        }
    }

    fn return_statement(&mut self, value: Option<ExprId>, extent: Extent) {
        if let Some(flow) = self.flow.last_mut() {
            flow.has_return = true;
        }
        let wanted = self.returned;
        let Some(value) = value else {
            if let Err(misfit) = typing::returned(wanted, None) {
                let d = self.explain_return(None, extent, misfit);
                self.report(d);
                self.returns_value = true;
            }
            return;
        };
        self.returns_value = true;
        self.wanted = Some(wanted);
        self.root(value, self.level + 1);
        self.wanted = None;
        if let Err(misfit) = typing::returned(wanted, Some(self.ty(value))) {
            let d = self.explain_return(Some(value), extent, misfit);
            self.report(d);
        }
    }

    fn switch(&mut self, selector: ExprId, body: List) {
        self.root(selector, self.level + 1);
        let ty = self.ty(selector);
        let is_integer = matches!(ty, Type::INT | Type::UINT);
        if !is_integer && !ty.is_error() {
            let name = self.name_of(ty);
            let d = self
                .error_expr(
                    error::INVALID_SWITCH,
                    selector,
                    format!("`switch` wants an integer, not `{name}`"),
                )
                .fix(if ty == Type::FLOAT {
                    self.convert(selector, Scalar::Int)
                } else {
                    None
                });
            self.report(d);
        }
        let selector_type = if is_integer { ty } else { Type::ERROR };
        self.open_scope();
        self.open_flow(FlowKind::Switch(selector_type));
        self.level += 2;
        self.statements(body);
        self.level -= 2;
        self.check_last_label(body);
        self.close_flow();
        self.close_scope();
    }

    /// Behind the last label of a `switch` must stand a statement that the browser keeps.
    fn check_last_label(&mut self, body: List) {
        let tree = self.tree;
        let mut dropped = None;
        for &last in tree.block(body).iter().rev() {
            match tree.stmt(last).kind {
                StmtKind::Case(_) | StmtKind::Default => {
                    let extent = tree.stmt(last).extent;
                    let message = "the last label of a `switch` has no statement";
                    let d = self.error(error::INVALID_SWITCH, extent, message);
                    let d = match dropped {
                        Some(dropped) => {
                            d.label(self.span(dropped), "the browser drops this before it looks")
                        }
                        None => d,
                    };
                    return self.report(d.help("put `break;` behind it"));
                }
                _ if self.is_dropped(last) => dropped = Some(tree.stmt(last).extent),
                _ => return,
            }
        }
    }

    /// Whether a statement is of a kind that [`Checker::is_dropped`] may speak of.
    fn may_be_dropped(&self, id: StmtId) -> bool {
        match self.tree.stmt(id).kind {
            StmtKind::If { .. } => true,
            StmtKind::Decl(decl) => {
                let kind = self.tree.decl(decl).map(|d| d.kind);
                matches!(kind, Some(DeclKind::Precision { .. }))
            }
            _ => false,
        }
    }

    /// Whether nothing of a statement is left in the browser's tree: `precision`, and an `if` whose
    /// constant condition chooses a branch that is not there, or is dropped itself.
    fn is_dropped(&self, id: StmtId) -> bool {
        let mut at = id;
        loop {
            let StmtKind::If {
                condition,
                then,
                otherwise,
            } = self.tree.stmt(at).kind
            else {
                return self.may_be_dropped(at);
            };
            let info = self.info(condition);
            let known = self.pool.scalar(info.constant).filter(|_| info.is_const);
            match known.map(|v| v.as_bool()) {
                Some(true) => at = then,
                Some(false) => match otherwise {
                    Some(otherwise) => at = otherwise,
                    None => return true,
                },
                None => return false,
            }
        }
    }

    fn case(&mut self, value: ExprId, extent: Extent) {
        self.root(value, self.level + 1);
        let info = self.info(value);
        if info.ty.is_error() {
            return self.label_unknown();
        }
        if !matches!(info.ty, Type::INT | Type::UINT) {
            let name = self.name_of(info.ty);
            let d = self
                .error_expr(
                    error::INVALID_SWITCH,
                    value,
                    format!("a label must be an integer, not `{name}`"),
                )
                .fix(if info.ty == Type::FLOAT {
                    self.convert(value, Scalar::Int)
                } else {
                    None
                });
            self.report(d);
            return self.label_unknown();
        }
        if info.is_const && !info.constant.is_known() {
            return self.label_unknown();
        }
        let Some(label) = self.pool.scalar(info.constant).filter(|_| info.is_const) else {
            let d = self.error_expr(
                error::NOT_CONSTANT,
                value,
                "a label must be a constant expression",
            );
            let d = self.explain_not_constant(d, value);
            self.report(d);
            return self.label_unknown();
        };
        let number = match label {
            Value::Uint(v) => v as i64,
            v => v.as_int() as i64,
        };
        self.label(Some((number, value, info.ty)), extent.first);
    }

    /// A label that was reported still makes the statements behind it reachable.
    fn label_unknown(&mut self) {
        if let Some(Flow {
            kind: FlowKind::Switch(_),
            labels,
            ..
        }) = self.flow.last_mut()
        {
            labels.insert(Some(i64::MIN + labels.len() as i64), 0);
        }
    }

    /// A `case` with its value, or `default`.
    fn label(&mut self, case: Option<(i64, ExprId, Type)>, token: TokenId) {
        let Some(Flow {
            kind: FlowKind::Switch(selector),
            labels,
            ..
        }) = self.flow.last_mut()
        else {
            let word = if case.is_some() { "case" } else { "default" };
            let d = self.error_at(
                error::INVALID_SWITCH,
                token,
                format!("`{word}` can only stand directly in a `switch`"),
            );
            return self.report(d);
        };
        let selector = *selector;
        let value = case.map(|(v, ..)| v);
        let first = *labels.entry(value).or_insert(token);
        if first != token {
            let d = self
                .error_at(
                    error::INVALID_SWITCH,
                    token,
                    "this label stands twice in the `switch`",
                )
                .label(self.token_span(first), "the first one");
            return self.report(d);
        }
        if let Some((_, expr, ty)) = case
            && !selector.is_error()
            && ty != selector
        {
            let (want, have) = (self.name_of(selector), self.name_of(ty));
            let scalar = selector.scalar_kind().unwrap_or(Scalar::Int);
            let d = self
                .error_expr(
                    error::INVALID_SWITCH,
                    expr,
                    format!("the label is `{have}`, but `switch` compares `{want}`"),
                )
                .fix(self.convert(expr, scalar));
            self.report(d);
        }
    }

    /// No statement of a `switch` may stand before its first label.
    fn check_label_before(&mut self, extent: Extent) {
        if let Some(Flow {
            kind: FlowKind::Switch(_),
            labels,
            ..
        }) = self.flow.last_mut()
            && labels.is_empty()
        {
            // Reported once.
            labels.insert(Some(i64::MIN), 0);
            let d = self.error(
                error::INVALID_SWITCH,
                extent,
                "this stands before the first label of the `switch`",
            );
            self.report(d);
        }
    }
}
