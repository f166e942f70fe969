//! What WebGL allows in GLSL ES 1.00: the loops and indices of its Appendix A.

use super::*;

impl Checker<'_> {
    fn restricted(&mut self, extent: Extent, message: &str) {
        let d = self
            .error(error::WEBGL1_RESTRICTION, extent, message)
            .note("GLSL ES 1.00 Appendix A; `#version 300 es` has no such rule");
        self.report(d);
    }

    pub(super) fn refuse_webgl1_loop(&mut self, word: &str, extent: Extent) {
        if !self.has(Feature::FreeControlFlow) {
            let keyword = Extent::token(extent.first);
            self.restricted(keyword, &format!("WebGL1 has no `{word}` loops"));
        }
    }

    /// `for (int i = 0; ...`: the index of the loop, if it is declared so.
    pub(super) fn check_webgl1_init(&mut self, init: StmtId, extent: Extent) -> Option<VariableId> {
        if self.has(Feature::FreeControlFlow) {
            return None;
        }
        let tree = self.tree;
        let keyword = Extent::token(extent.first);
        let decl = match tree.stmt(init).kind {
            StmtKind::Decl(decl) => tree.decl(decl),
            _ => None,
        };
        let Some(DeclKind::Variables { declarators, .. }) = decl.map(|d| d.kind) else {
            self.restricted(
                keyword,
                "a WebGL1 loop must declare its index: `for (int i = 0; ...`",
            );
            return None;
        };
        let (&[declarator], Some(&Some(id))) = (
            tree.declarators(declarators),
            self.declared.get(declarators.start as usize),
        ) else {
            self.restricted(
                keyword,
                "a WebGL1 loop must declare one index: `for (int i = 0; ...`",
            );
            return None;
        };
        let ty = self
            .variables
            .get(id.0 as usize)
            .map_or(Type::ERROR, |v| v.ty);
        if ty.is_error() {
            return None;
        }
        if !matches!(ty, Type::INT | Type::FLOAT) {
            self.restricted(
                declarator.extent,
                "the index of a WebGL1 loop must be `int` or `float`",
            );
            return None;
        }
        let is_const = declarator.init.is_some_and(|e| self.info(e).is_const);
        if !is_const {
            self.restricted(
                declarator.extent,
                "the index of a WebGL1 loop must start at a constant",
            );
            return None;
        }
        Some(id)
    }

    pub(super) fn check_webgl1_condition(
        &mut self,
        condition: Option<StmtId>,
        index: Option<VariableId>,
        extent: Extent,
    ) {
        let (false, Some(index)) = (self.has(Feature::FreeControlFlow), index) else {
            return;
        };
        let tree = self.tree;
        let keyword = Extent::token(extent.first);
        let Some(StmtKind::Expr(expr)) = condition.map(|c| tree.stmt(c).kind) else {
            return self.restricted(keyword, "a WebGL1 loop must have a condition: `i < 10`");
        };
        let at = tree.expr(expr).extent;
        let ExprKind::Binary(op, left, right) = tree.expr(tree.unparen(expr)).kind else {
            return self.restricted(
                at,
                "the condition of a WebGL1 loop must compare its index with a constant",
            );
        };
        if !op.compares() || self.variable_behind(left) != Some(index) {
            return self.restricted(
                at,
                "the condition of a WebGL1 loop must compare its index with a constant",
            );
        }
        if !self.info(right).is_const && !self.ty(right).is_error() {
            self.restricted(
                tree.expr(right).extent,
                "a WebGL1 loop must end at a constant",
            );
        }
    }

    pub(super) fn check_webgl1_step(
        &mut self,
        step: Option<ExprId>,
        index: Option<VariableId>,
        extent: Extent,
    ) {
        let (false, Some(index)) = (self.has(Feature::FreeControlFlow), index) else {
            return;
        };
        let tree = self.tree;
        let keyword = Extent::token(extent.first);
        let message = "a WebGL1 loop must change its index by a constant: `i++` or `i += 2`";
        let Some(step) = step else {
            return self.restricted(keyword, message);
        };
        let at = tree.expr(step).extent;
        let (operand, by) = match tree.expr(tree.unparen(step)).kind {
            ExprKind::Unary(op, operand) if op.assigns() => (operand, None),
            ExprKind::Postfix(_, operand) => (operand, None),
            ExprKind::Assign(Some(BinaryOp::Add | BinaryOp::Sub), left, right) => {
                (left, Some(right))
            }
            _ => return self.restricted(at, message),
        };
        let is_const = by.is_none_or(|e| self.info(e).is_const || self.ty(e).is_error());
        if self.variable_behind(operand) != Some(index) || !is_const {
            self.restricted(at, message);
        }
    }

    /// The index of a WebGL1 loop must not be changed in the loop's body.
    pub(super) fn check_webgl1_write(&mut self, id: VariableId, extent: Extent) {
        if !self.has(Feature::FreeControlFlow) && self.flow.iter().any(|f| f.loop_index == Some(id))
        {
            self.restricted(
                extent,
                "the body of a WebGL1 loop must not change its index",
            );
        }
    }

    /// An index is constant, or made of constants and loop indices; uniforms of vertex shaders take
    /// any. `gl_FragData` takes 0 alone.
    pub(super) fn check_webgl1_index(&mut self, id: ExprId, object: ExprId, is_frag_data: bool) {
        let ExprKind::Index(_, index) = self.tree.expr(id).kind else {
            return;
        };
        let info = self.info(index);
        if is_frag_data {
            // Constants that lie outside of it are found as those of any array are.
            if !info.is_const {
                let extent = self.tree.expr(index).extent;
                let d = self
                    .error(
                        error::INDEX_OUT_OF_RANGE,
                        extent,
                        "`gl_FragData` has one element here, with index 0",
                    )
                    .note(
                        "more need the extension `GL_EXT_draw_buffers`, which WebGL2 does not have",
                    );
                self.report(d);
            }
            return;
        }
        if info.is_const {
            return;
        }
        let storage = self.base_storage(object);
        if self.stage == Stage::Vertex && storage == Some(Storage::Uniform) {
            return;
        }
        if !self.is_constant_index(index) {
            let extent = self.tree.expr(index).extent;
            self.restricted(
                extent,
                "WebGL1 takes only constants and loop indices as an index here",
            );
        }
    }

    fn base_storage(&self, object: ExprId) -> Option<Storage> {
        let id = self.variable_of(object)?;
        self.variables.get(id.0 as usize).map(|v| v.storage)
    }

    /// Whether every name in an index is a constant or the index of a loop around, and nothing of
    /// the shader's own is called.
    fn is_constant_index(&self, index: ExprId) -> bool {
        self.subtree(index)
            .all(|(_, info, _)| match info.resolution {
                Resolution::Variable(id) => {
                    info.is_const || self.flow.iter().any(|f| f.loop_index == Some(id))
                }
                Resolution::Function(_) => false,
                _ => true,
            })
    }
}
