//! L-values: what can be written to (GLSL ES 3.00 section 5.8).

use crate::checker::*;

/// A write to something that is not assignable.
#[derive(Clone, Copy, Debug)]
pub enum PlaceError {
    /// An expression that is not an l-value, and what writes to it.
    NoPlace(ExprId, Writer),
    /// A swizzle that repeats a component, and the size of its vector.
    Repeats(Name, u8),
    Constant(VariableId),
    Uniform(VariableId),
    Input(VariableId),
    /// A `const` parameter.
    ConstParameter(VariableId),
    Sampler(VariableId),
    /// A struct or array containing a sampler.
    SamplerInside(VariableId),
}

/// What writes to a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Writer {
    /// `=`, or an operator combined with it.
    Assign(Option<BinaryOp>),
    /// `++` or `--`, or the qualifier of a parameter.
    Word(&'static str),
}

impl Checker<'_> {
    /// Marks the variable of an expression as written.
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

    /// Whether `id` is assignable; reports at `extent` if not.
    pub(super) fn check_assignable(&mut self, id: ExprId, extent: Extent, by: Writer) -> bool {
        let mut at = id;
        // The browser does not check a swizzle that is indexed.
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
                        let token = Extent::token(self.tree.expr(at).extent.last);
                        let rows = self.ty(inner).components() as u8;
                        self.reject(token, PlaceError::Repeats(name, rows));
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
            self.reject(self.tree.expr(id).extent, PlaceError::NoPlace(id, by));
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
            ty,
            ..
        } = *variable;
        let problem = match storage {
            _ if is_const => PlaceError::Constant,
            Storage::Uniform => PlaceError::Uniform,
            Storage::Input => PlaceError::Input,
            Storage::Param(Direction::ConstIn) => PlaceError::ConstParameter,
            _ if ty.is_sampler() => PlaceError::Sampler,
            _ if self.inside(ty).sampler => PlaceError::SamplerInside,
            _ => {
                self.check_webgl1_write(id, extent);
                return true;
            }
        };
        self.reject(self.tree.expr(expr).extent, problem(id));
        false
    }
}
