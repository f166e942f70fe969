//! Declarations with a value of another type: the uses of the variable decide which of the two is
//! wrong.

use super::*;

/// Most declarations of a shader that are decided by the uses of their variables.
const MAX_CANDIDATES: usize = 8;

/// Most expressions that are checked again in total, in a shader with fewer expressions.
const MAX_SIZE: usize = 60_000;

/// Declarations with a value of another type.
#[derive(Clone, Default)]
pub(super) struct CandidateTypes {
    /// Those found so far, as indices of declarators.
    pub met: Vec<usize>,
    /// Those that get the type of their value instead of the declared one.
    pub retyped: Vec<usize>,
}

/// Chooses for each declaration in turn between the declared type and that of its value: the one
/// that results in fewer errors. `count` returns their number.
pub(super) fn choose_types(
    first: usize,
    met: &[usize],
    size: usize,
    search: &mut Search,
    mut count: impl FnMut(&CandidateTypes) -> usize,
) -> CandidateTypes {
    let mut standing = first;
    let mut candidates = CandidateTypes::default();
    search.within(MAX_SIZE.max(size), |search| {
        for &declarator in met.iter().take(MAX_CANDIDATES) {
            candidates.retyped.push(declarator);
            let retyped = |_: &mut Search, _: &(), _| Some(count(&candidates));
            match search.fewest((standing, 0), size, [()], retyped) {
                Some((_, fewer)) => standing = fewer,
                None => {
                    candidates.retyped.pop();
                }
            }
        }
    });
    candidates
}

impl Checker<'_> {
    /// Whether the uses after a second declaration refer to that one.
    pub(super) fn means_second(&mut self, index: usize, first: VariableId, ty: Type) -> bool {
        let is_other = self
            .variables
            .get(first.0 as usize)
            .is_some_and(|v| v.ty != ty);
        if is_other && !self.at_global_scope() {
            self.candidates.met.push(index);
        }
        self.candidates.retyped.contains(&index)
    }

    /// The type of a variable with a value of another type, after the error about it was reported:
    /// the declared one, unless the uses of the variable require that of the value.
    pub(super) fn chosen_type(
        &mut self,
        index: usize,
        spec: Option<Extent>,
        declarator: &Declarator,
        ty: Type,
    ) -> Type {
        let (Some(spec), Some(init)) = (spec, declarator.init) else {
            return ty;
        };
        let found = self.ty(init);
        let is_plain = !ty.is_array() && !found.is_array() && declarator.arrays.len == 0;
        let (Some((expected, ..)), Some(_), true) = (ty.numeric(), found.numeric(), is_plain)
        else {
            return ty;
        };
        // `float a = 0;` always means a float.
        if expected == Scalar::Float && self.literal_token(init).is_some() {
            return ty;
        }
        self.candidates.met.push(index);
        if !self.candidates.retyped.contains(&index) {
            return ty;
        }
        self.report_declared_type(spec, declarator, ty, init);
        found
    }

    /// Replaces the error about the value of a declaration by one about its type.
    fn report_declared_type(
        &mut self,
        spec: Extent,
        declarator: &Declarator,
        ty: Type,
        init: ExprId,
    ) {
        let mismatch = match self.problems.pop().map(|p| p.what) {
            Some(ProblemKind::Value(ValueError::Initializer(.., mismatch))) => mismatch,
            _ => TypeMismatch::Value(Clash::Struct),
        };
        let problem = ValueError::Retyped(*declarator, spec, ty, init, mismatch);
        self.reject(spec.to(Extent::token(declarator.ident.token)), problem);
    }
}
