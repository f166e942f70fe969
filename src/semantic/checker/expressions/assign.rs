//! Assignments and initializers (GLSL ES 3.00 sections 5.8 and 4.3).

use crate::checker::declarations::qualifier::{Qualified, StorageRequest};
use crate::checker::*;

/// An error in the initializer of a declaration.
#[derive(Clone, Copy, Debug)]
pub enum ValueError {
    /// A value of another type than the declared one, and the extent of that type if it can be
    /// edited.
    Initializer(Declarator, Option<Extent>, Type, ExprId, TypeMismatch),
    /// A declared type, at this extent, that matches neither the value nor the uses of the
    /// variable.
    Retyped(Declarator, Extent, Type, ExprId, TypeMismatch),
    /// A value that must be a constant expression.
    NotConstant(Declarator, ExprId, StorageRequest),
}

impl Checker<'_> {
    pub(in crate::checker) fn assign(
        &mut self,
        id: ExprId,
        op: Option<BinaryOp>,
        left: ExprId,
        right: ExprId,
    ) -> ExprInfo {
        let (l, r) = (self.info(left), self.info(right));
        if l.ty.is_error() {
            self.mark_written(left);
            if op.is_none() {
                self.declare_where_set(left, r.ty);
            }
            return ExprInfo::ERROR;
        }
        if op.is_some_and(|op| op.is_bitwise() || op == BinaryOp::Rem) {
            self.require(Feature::IntegerOperators, id);
        }
        let (at, by) = (self.tree.expr(id).extent, Writer::Assign(op));
        if !self.check_assignable(left, at, by) || r.ty.is_error() {
            return ExprInfo::wrong(l.ty);
        }
        let fits = match op {
            None => typing::assign(self.types(), l.ty, r.ty),
            Some(op) => typing::compound(self.types(), op, l.ty, r.ty).map(|_| ()),
        };
        if let Err(mismatch) = fits {
            self.refuse(id, &[left, right], mismatch);
        }
        ExprInfo {
            is_const: false,
            ..self.result(l.ty, [l, r], Constant::NONE)
        }
    }

    /// Checks an initializer; false if its type is wrong, which is then reported.
    pub(in crate::checker) fn check_initializer(
        &mut self,
        declarator: &Declarator,
        qualified: &Qualified,
        spec: Option<Extent>,
        ty: Type,
        init: ExprId,
    ) -> bool {
        let info = self.info(init);
        if info.ty.is_error() {
            return true;
        }
        if ty.is_error() {
            return false;
        }
        if !self.has(Feature::ArrayValues) && ty.is_array() {
            self.reject(declarator.extent, ArrayError::Value);
            return true;
        }
        if !matches!(
            qualified.storage,
            StorageRequest::None | StorageRequest::Const
        ) {
            let problem = DeclarationError::Value(qualified.storage);
            self.reject(declarator.extent, problem);
            return true;
        }
        if let Err(mismatch) = typing::assign(self.types(), ty, info.ty) {
            let problem = ValueError::Initializer(*declarator, spec, ty, init, mismatch);
            self.reject(declarator.extent, problem);
            return false;
        }
        self.check_initializer_constness(declarator, qualified, init);
        true
    }

    /// A `const` needs a constant expression, and so does every initializer at global scope.
    fn check_initializer_constness(
        &mut self,
        declarator: &Declarator,
        qualified: &Qualified,
        init: ExprId,
    ) {
        let info = self.info(init);
        let is_const = qualified.storage == StorageRequest::Const;
        let is_global = self.at_global_scope() && !self.is_global_initializer(init);
        if is_const && !info.is_const || !is_const && is_global {
            let problem = ValueError::NotConstant(*declarator, init, qualified.storage);
            self.reject_expr(init, problem);
        }
    }

    /// Whether an expression may initialize a global variable: only constants in GLSL ES 3.00; in
    /// 1.00 also uniforms and other globals, which browsers allow for old shaders. Operands that
    /// they remove before a `,` may be anything.
    fn is_global_initializer(&self, init: ExprId) -> bool {
        if self.info(init).is_const {
            return true;
        }
        let mut dropped: Vec<Extent> = Vec::new();
        for (_, info, expr) in self.subtree(init) {
            dropped.pop_if(|d| expr.extent.first < d.first);
            if dropped.last().is_some_and(|d| expr.extent.last <= d.last) {
                continue;
            }
            if let ExprKind::Comma(left, right) = expr.kind
                && self.has(Feature::ConstantComma)
                && self.is_temporary(right)
            {
                // An operand that is kept for its side effects is not allowed.
                if self.has_side_effects(left) {
                    return false;
                }
                dropped.push(self.tree.expr(left).extent);
            }
            if !self.may_initialize_global(info, &expr.kind) {
                return false;
            }
        }
        true
    }

    /// Whether an expression, apart from its operands, may be part of a global initializer.
    fn may_initialize_global(&self, info: &ExprInfo, kind: &ExprKind) -> bool {
        match (info.resolution, kind) {
            (Resolution::Variable(id), ExprKind::Name(_)) => {
                info.is_const
                    || (self.has(Feature::LooseInitializers) && self.is_legacy_initializer(id))
            }
            (Resolution::Function(_), _) => false,
            (Resolution::Builtin(overload), _) => !self.is_lookup(overload),
            (_, ExprKind::Assign(..) | ExprKind::Postfix(..)) => false,
            (_, ExprKind::Unary(op, _)) => !op.assigns(),
            _ => true,
        }
    }

    /// Whether a built-in function reads a texture.
    fn is_lookup(&self, overload: u32) -> bool {
        let overload = self.builtins.overload(overload);
        overload.is_some_and(|o| o.function.kind().is_texture())
    }

    /// Whether a variable is a global or uniform that the shader declares; not `gl_DepthRange`.
    fn is_legacy_initializer(&self, id: VariableId) -> bool {
        self.variables.get(id.0 as usize).is_some_and(|v| {
            matches!(v.storage, Storage::Global | Storage::Uniform) && v.token.is_some()
        })
    }

    /// Adds the type of the first assigned value to the error about an undeclared variable.
    fn declare_where_set(&mut self, left: ExprId, ty: Type) {
        let ExprKind::Name(name) = self.tree.expr(left).kind else {
            return;
        };
        let token = self.tree.expr(left).extent.first;
        let Some(&(index, 0)) = self.undeclared.get(&name) else {
            return;
        };
        let is_it = |p: &Problem| {
            p.at == Extent::token(token)
                && matches!(p.what, ProblemKind::Name(NameError::Undeclared(_)))
        };
        if self.problems.get(index).is_some_and(is_it) {
            self.add_aside(index, Aside::SetTo(ty));
        }
    }
}
