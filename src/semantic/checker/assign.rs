//! Assignments, initializers, and what can be assigned to (GLSL ES 3.00 sections 5.8 and 4.3).

use super::qualifier::{Qualified, Wanted};
use super::*;

impl Checker<'_> {
    pub(super) fn assign(
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
        let symbol = op.map_or("=".to_string(), |op| format!("{}=", op.symbol()));
        if let Some(op) = op.filter(|op| op.is_bitwise() || *op == BinaryOp::Rem) {
            self.require(
                Feature::IntegerOperators,
                id,
                &format!("the operator `{}=`", op.symbol()),
            );
        }
        if !self.check_assignable(left, self.tree.expr(id).extent, &symbol) || r.ty.is_error() {
            return ExprInfo {
                ty: l.ty,
                ..ExprInfo::ERROR
            };
        }
        let fits = match op {
            None => typing::assign(self.types(), l.ty, r.ty),
            Some(op) => typing::compound(self.types(), op, l.ty, r.ty).map(|_| ()),
        };
        if let Err(misfit) = fits {
            self.refuse(id, &[left, right], misfit);
        }
        ExprInfo {
            is_const: false,
            ..self.result(l.ty, [l, r], Constant::NONE)
        }
    }

    /// Checks an initializer; false where its type does not fit, which is then reported.
    pub(super) fn check_initializer(
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
            let d = self
                .error(
                    error::NEEDS_WEBGL2,
                    declarator.extent,
                    "GLSL ES 1.00 has no array initializers",
                )
                .help("assign the elements one by one in a function");
            self.report(d);
            return true;
        }
        if !matches!(qualified.storage, Wanted::None | Wanted::Const) {
            let word = qualified.storage.name();
            let d = self
                .error(
                    error::INVALID_QUALIFIER,
                    declarator.extent,
                    format!("a variable that is `{word}` cannot have an initial value"),
                )
                .note("its value comes from outside");
            self.report(d);
            return true;
        }
        if let Err(misfit) = typing::assign(self.types(), ty, info.ty) {
            let d = self.explain_initializer(declarator, spec, ty, init, misfit);
            self.report(d);
            return false;
        }
        self.check_initializer_constness(declarator, qualified, init);
        true
    }

    /// `const` wants a constant expression, and so does every initializer at global scope.
    fn check_initializer_constness(
        &mut self,
        declarator: &Declarator,
        qualified: &Qualified,
        init: ExprId,
    ) {
        let info = self.info(init);
        let is_const = qualified.storage == Wanted::Const;
        let is_global = self.at_global_scope() && !self.is_global_initializer(init);
        if is_const && !info.is_const || !is_const && is_global {
            let d = self.explain_initial_value(declarator, init, qualified.storage);
            self.report(d);
        }
    }

    /// Whether an expression may initialize a global variable: nothing but constants in GLSL ES
    /// 3.00; in 1.00 uniforms and other globals too, which browsers allow for old shaders. What they
    /// drop before a `,` may be anything.
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
                // Nor may what is kept for its effect stand there.
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

    /// Whether an expression, without what stands in it, may be part of a global's initial value.
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

    /// Another global or a uniform of the shader's own; `gl_DepthRange` is none.
    fn is_legacy_initializer(&self, id: VariableId) -> bool {
        self.variables.get(id.0 as usize).is_some_and(|v| {
            matches!(v.storage, Storage::Global | Storage::Uniform) && v.token.is_some()
        })
    }

    /// Notes that something is written to an expression.
    pub(super) fn mark_written(&mut self, id: ExprId) {
        let mut at = id;
        loop {
            match self.tree.expr(at).kind {
                ExprKind::Paren(inner) | ExprKind::Member(inner, _) | ExprKind::Index(inner, _) => {
                    at = inner
                }
                _ => match self.kept_operand(at) {
                    Some(kept) => at = kept,
                    None => break,
                },
            }
        }
        if let Some(id) = self.variable_of(at)
            && let Some(variable) = self.variables.get_mut(id.0 as usize)
        {
            variable.written = true;
        }
    }

    /// Whether something can be assigned to `id`; reports at `extent` where not.
    pub(super) fn check_assignable(&mut self, id: ExprId, extent: Extent, symbol: &str) -> bool {
        let mut at = id;
        // The browser does not look at the components of which an index takes one.
        let mut is_indexed = false;
        loop {
            match self.tree.expr(at).kind {
                ExprKind::Paren(inner) => at = inner,
                ExprKind::Index(inner, _) => {
                    is_indexed = true;
                    at = inner;
                }
                ExprKind::Member(inner, name) => {
                    let text = self.text(name);
                    let repeats = |c| text.chars().filter(|&other| other == c).count() > 1;
                    if !is_indexed && self.ty(inner).is_vector() && text.chars().any(repeats) {
                        let token = self.tree.expr(at).extent.last;
                        let rows = self.ty(inner).components() as u8;
                        let d = self.explain_repeated_component(text, rows, token);
                        self.report(d);
                        return false;
                    }
                    at = inner;
                }
                _ => match self.kept_operand(at) {
                    Some(kept) => at = kept,
                    None => break,
                },
            }
        }
        let Some(variable) = self.variable_of(at) else {
            let d = self.explain_no_place(id, symbol);
            self.report(d);
            return false;
        };
        self.check_writable(variable, id, extent)
    }

    fn check_writable(&mut self, id: VariableId, expr: ExprId, extent: Extent) -> bool {
        let Some(variable) = self.variables.get_mut(id.0 as usize) else {
            return false;
        };
        variable.written = true;
        let Variable {
            storage,
            is_const,
            token,
            ty,
            name,
            ..
        } = *variable;
        let name = self.text(name);
        let holds_sampler = self.inside(ty).sampler;
        let why = match storage {
            _ if is_const => "is a constant",
            Storage::Uniform => "is a uniform, set from outside",
            Storage::Input => "is an input of the shader",
            Storage::Param(Direction::ConstIn) => "is a `const` parameter",
            _ if ty.is_sampler() => "is a sampler",
            _ if holds_sampler => {
                "holds a sampler, and browsers let no part of such a struct change"
            }
            _ => {
                self.check_webgl1_write(id, extent);
                return true;
            }
        };
        let d = self.error_expr(
            error::NOT_ASSIGNABLE,
            expr,
            format!("`{name}` cannot be assigned to: it {why}"),
        );
        let d = self.with_declaration(d, token, "declared here");
        let fix = match storage {
            _ if is_const => self.take_const_away(token),
            Storage::Input | Storage::Uniform => self.copy_first(id),
            Storage::Param(_) => self.take_const_away(token),
            _ => None,
        };
        self.report(d.fix(fix));
        false
    }

    /// Mends the error about an undeclared variable by its declaration, where it is first set.
    fn declare_where_set(&mut self, left: ExprId, ty: Type) {
        let ExprKind::Name(name) = self.tree.expr(left).kind else {
            return;
        };
        let token = self.tree.expr(left).extent.first;
        let Some(&(index, 0)) = self.undeclared.get(&name) else {
            return;
        };
        let Some(fix) = self.declaration_where_set(name, token, ty) else {
            return;
        };
        let span = self.token_span(token);
        if let Some(d) = self
            .diagnostics
            .get_mut(index)
            .filter(|d| d.span == span && d.rule == error::UNDECLARED_NAME)
        {
            d.fix = Some(fix);
        }
    }
}
