//! `switch` and its labels (GLSL ES 3.00 section 6.2).

use super::super::constant::Value;
use super::*;

/// An error in a `switch`.
#[derive(Clone, Copy, Debug)]
pub enum SwitchError {
    /// A selector that is not an integer.
    Selector(ExprId),
    /// A label that is not an integer.
    Label(ExprId),
    /// A label that is not constant.
    NotConstant(ExprId),
    /// A label of another type than the selector, and the type of the selector.
    LabelType(ExprId, Type),
    /// `case` or `default` that is not directly inside a `switch`.
    Outside(&'static str),
    /// A duplicate label, and the token of the first one.
    Twice(TokenId),
    /// A last label without a statement; the statement after it that the browser removes, if any.
    NothingBehind(Option<Extent>),
    /// A statement before the first label.
    BeforeLabels,
}

impl Checker<'_> {
    pub(super) fn switch(&mut self, selector: ExprId, body: List) {
        self.root(selector, self.level + 1);
        let ty = self.ty(selector);
        let is_integer = matches!(ty, Type::INT | Type::UINT);
        if !is_integer && !ty.is_error() {
            let at = self.tree.expr(selector).extent;
            self.reject(at, SwitchError::Selector(selector));
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

    /// Checks that the last label of a `switch` is followed by a statement that the browser keeps.
    fn check_last_label(&mut self, body: List) {
        let tree = self.tree;
        let mut dropped = None;
        for &last in tree.block(body).iter().rev() {
            match tree.stmt(last).kind {
                StmtKind::Case(_) | StmtKind::Default => {
                    let extent = tree.stmt(last).extent;
                    return self.reject(extent, SwitchError::NothingBehind(dropped));
                }
                _ if self.is_dropped(last) => dropped = Some(tree.stmt(last).extent),
                _ => return,
            }
        }
    }

    /// Whether a statement is of a kind that the browser may remove: see [`Checker::is_dropped`].
    pub(super) fn may_be_dropped(&self, id: StmtId) -> bool {
        match self.tree.stmt(id).kind {
            StmtKind::If { .. } => true,
            StmtKind::Decl(decl) => {
                let kind = self.tree.decl(decl).map(|d| d.kind);
                matches!(kind, Some(DeclKind::Precision { .. }))
            }
            _ => false,
        }
    }

    /// Whether the browser removes a statement from its tree: `precision`, and an `if` with a
    /// constant condition that selects a missing branch, or one that is removed itself.
    pub(super) fn is_dropped(&self, id: StmtId) -> bool {
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

    pub(super) fn case(&mut self, value: ExprId, extent: Extent) {
        self.root(value, self.level + 1);
        let (info, at) = (self.info(value), self.tree.expr(value).extent);
        if info.ty.is_error() {
            return self.label_unknown();
        }
        if !matches!(info.ty, Type::INT | Type::UINT) {
            self.reject(at, SwitchError::Label(value));
            return self.label_unknown();
        }
        if info.is_const && !info.constant.is_known() {
            return self.label_unknown();
        }
        let Some(label) = self.pool.scalar(info.constant).filter(|_| info.is_const) else {
            self.reject(at, SwitchError::NotConstant(value));
            return self.label_unknown();
        };
        let number = match label {
            Value::Uint(v) => v as i64,
            v => v.as_int() as i64,
        };
        self.label(Some((number, value, info.ty)), extent.first);
    }

    /// Records a faulty label, so that the statements after it are not reported.
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

    /// Checks a `case` with its value, or `default`.
    pub(super) fn label(&mut self, case: Option<(i64, ExprId, Type)>, token: TokenId) {
        let Some(Flow {
            kind: FlowKind::Switch(selector),
            labels,
            ..
        }) = self.flow.last_mut()
        else {
            let word = if case.is_some() { "case" } else { "default" };
            return self.reject(Extent::token(token), SwitchError::Outside(word));
        };
        let selector = *selector;
        let value = case.map(|(v, ..)| v);
        let first = *labels.entry(value).or_insert(token);
        if first != token {
            return self.reject(Extent::token(token), SwitchError::Twice(first));
        }
        if let Some((_, expr, ty)) = case
            && !selector.is_error()
            && ty != selector
        {
            let at = self.tree.expr(expr).extent;
            self.reject(at, SwitchError::LabelType(expr, selector));
        }
    }

    /// Reports a statement of a `switch` before its first label.
    pub(super) fn check_label_before(&mut self, extent: Extent) {
        if let Some(Flow {
            kind: FlowKind::Switch(_),
            labels,
            ..
        }) = self.flow.last_mut()
            && labels.is_empty()
        {
            // Reported once.
            labels.insert(Some(i64::MIN), 0);
            self.reject(extent, SwitchError::BeforeLabels);
        }
    }
}
