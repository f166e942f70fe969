//! Restrictions of WebGL1 on loops and indices, from Appendix A of GLSL ES 1.00.

use super::*;
use shaderlint_syntax::WebGl;

/// Something of GLSL ES 1.00 that WebGL1 does not accept.
#[derive(Clone, Copy, Debug)]
pub enum Restriction {
    /// A loop with this keyword.
    Loop(&'static str),
    /// A loop that declares no index.
    NoIndex,
    /// A loop that declares several indices.
    Indices,
    /// A loop index of another type than `int` and `float`.
    IndexType,
    /// A loop index that does not start at a constant.
    Start,
    /// A loop without a condition.
    NoCondition,
    /// A condition that does not compare the index.
    Condition,
    /// A loop bound that is not constant.
    End,
    /// A step that does not change the index by a constant.
    Step,
    /// A loop index that is changed in the body.
    IndexWritten,
    /// An index of an array, vector or matrix that is not built from constants and loop indices.
    Subscript,
    /// An index of `gl_FragData` that is not constant.
    FragData,
}

impl Checker<'_> {
    pub(super) fn refuse_webgl1_loop(&mut self, word: &'static str, extent: Extent) {
        if !self.has(Feature::FreeControlFlow) {
            self.reject(Extent::token(extent.first), Restriction::Loop(word));
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
            self.reject(keyword, Restriction::NoIndex);
            return None;
        };
        let (&[declarator], Some(&Some(id))) = (
            tree.declarators(declarators),
            self.declared.get(declarators.start as usize),
        ) else {
            self.reject(keyword, Restriction::Indices);
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
            self.reject(declarator.extent, Restriction::IndexType);
            return None;
        }
        let is_const = declarator.init.is_some_and(|e| self.info(e).is_const);
        if !is_const {
            self.reject(declarator.extent, Restriction::Start);
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
            return self.reject(keyword, Restriction::NoCondition);
        };
        let at = tree.expr(expr).extent;
        let ExprKind::Binary(op, left, right) = tree.expr(tree.unparen(expr)).kind else {
            return self.reject(at, Restriction::Condition);
        };
        if !op.compares() || self.base_variable(left) != Some(index) {
            return self.reject(at, Restriction::Condition);
        }
        if !self.info(right).is_const && !self.ty(right).is_error() {
            self.reject(tree.expr(right).extent, Restriction::End);
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
        let Some(step) = step else {
            return self.reject(keyword, Restriction::Step);
        };
        let at = tree.expr(step).extent;
        let (operand, by) = match tree.expr(tree.unparen(step)).kind {
            ExprKind::Unary(op, operand) if op.assigns() => (operand, None),
            ExprKind::Postfix(_, operand) => (operand, None),
            ExprKind::Assign(Some(BinaryOp::Add | BinaryOp::Sub), left, right) => {
                (left, Some(right))
            }
            _ => return self.reject(at, Restriction::Step),
        };
        let is_const = by.is_none_or(|e| self.info(e).is_const || self.ty(e).is_error());
        if self.base_variable(operand) != Some(index) || !is_const {
            self.reject(at, Restriction::Step);
        }
    }

    /// Reports a write to the index of a WebGL1 loop in its body.
    pub(super) fn check_webgl1_write(&mut self, id: VariableId, extent: Extent) {
        if !self.has(Feature::FreeControlFlow) && self.flow.iter().any(|f| f.loop_index == Some(id))
        {
            self.reject(extent, Restriction::IndexWritten);
        }
    }

    /// Checks that an index is built from constants and loop indices. Uniforms of vertex shaders
    /// accept any index, `gl_FragData` only 0.
    pub(super) fn check_webgl1_index(&mut self, id: ExprId, object: ExprId, is_frag_data: bool) {
        let ExprKind::Index(_, index) = self.tree.expr(id).kind else {
            return;
        };
        let info = self.info(index);
        if is_frag_data && self.context.webgl == WebGl::Two {
            // Constants that are out of range are reported as for any array.
            if !info.is_const {
                let extent = self.tree.expr(index).extent;
                self.reject(extent, Restriction::FragData);
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
            self.reject(extent, Restriction::Subscript);
        }
    }

    fn base_storage(&self, object: ExprId) -> Option<Storage> {
        let id = self.variable_of(object)?;
        self.variables.get(id.0 as usize).map(|v| v.storage)
    }

    /// Whether every name in an index is a constant or the index of an enclosing loop, and no
    /// function of the shader is called.
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
