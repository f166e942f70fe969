//! Undeclared names of other languages, and the types of their GLSL equivalents.

use super::declarations::qualifier::StorageRequest;
use super::*;
use shaderlint_syntax::{Foreign, Meaning, WordClass, classify, foreign};

/// A use of a name of another language.
#[derive(Clone, Copy, Debug)]
pub enum ForeignError {
    /// A type without a GLSL equivalent.
    Absent(Name),
    /// A type that has another name in GLSL.
    Type(Name),
    /// Such a type, where `uniform` is missing before it.
    Uniform(Name),
    /// `var`, `let` or `auto`: the first token to replace, and the type of the value.
    Inferred(TokenId, Type),
    /// A call of a function of another language.
    Call(ExprId, Name, List),
}

impl Checker<'_> {
    fn foreign(&self, name: Name) -> Option<Foreign> {
        foreign(self.text(name), self.version)
    }

    /// Whether an undeclared function has a name of another language.
    pub(super) fn is_foreign(&self, name: Name, id: ExprId) -> bool {
        let token = self.tree.expr(id).extent.first;
        self.foreign(name).is_some() && self.declared_later(name, token).is_none()
    }

    /// Reports an undeclared type of another language, and returns its GLSL equivalent.
    pub(super) fn foreign_type(&mut self, name: Name, token: TokenId) -> Option<Type> {
        let found = self.foreign(name)?;
        let Meaning::Type(word) = found.meaning else {
            let Meaning::Absent(_) = found.meaning else {
                return None;
            };
            if !self.was_reported(name) {
                self.report_undeclared(name, Extent::token(token), ForeignError::Absent(name));
            }
            return Some(Type::ERROR);
        };
        let WordClass::Type(ty) = classify(word, self.version) else {
            return None;
        };
        let ty = Type::of_word(ty);
        let before = token.checked_sub(1).map(|t| self.token(t).kind);
        let lacks_uniform = ty.is_sampler()
            && self.at_global_scope()
            && matches!(
                before,
                None | Some(TokenKind::Semicolon | TokenKind::RightBrace)
            );
        if !self.was_reported(name) {
            let problem = match lacks_uniform {
                true => ForeignError::Uniform(name),
                false => ForeignError::Type(name),
            };
            self.report_undeclared(name, Extent::token(token), problem);
        }
        Some(if lacks_uniform { Type::ERROR } else { ty })
    }

    /// Reports a declaration with `var`, `let` or `auto`, and returns the type of its values.
    pub(super) fn inferred_type(
        &mut self,
        qualifiers: List,
        ty: TypeId,
        declarators: List,
    ) -> Option<(Type, StorageRequest)> {
        let tree = self.tree;
        let spec = tree.ty(ty);
        let token = spec.extent.first;
        match spec.base {
            TypeBase::Name(name) if self.scopes.get(name).is_none() => {
                matches!(self.foreign(name)?.meaning, Meaning::Inferred).then_some(())?
            }
            _ => return None,
        }
        let mut found = None;
        for declarator in tree.declarators(declarators) {
            let init = declarator.init?;
            self.eval(init);
            let ty = self.ty(init);
            if *found.get_or_insert(ty) != ty {
                found = Some(Type::ERROR);
            }
        }
        let found = found.filter(|t| !t.is_void()).unwrap_or(Type::ERROR);
        // In other languages `const` means assigned once; here, a constant expression.
        let all = tree.qualifiers(qualifiers);
        let values = tree.declarators(declarators);
        let is_known = values
            .iter()
            .all(|d| d.init.is_some_and(|i| self.info(i).is_const));
        let (from, storage) = match all {
            [only] if only.kind == QualifierKind::Const && is_known => {
                (token, StorageRequest::Const)
            }
            [only] if only.kind == QualifierKind::Const => {
                (only.extent.first, StorageRequest::None)
            }
            _ => (token, StorageRequest::None),
        };
        self.reject(Extent::token(token), ForeignError::Inferred(from, found));
        Some((found, storage))
    }

    /// Reports a call of a function of another language, and returns its result.
    pub(super) fn foreign_call(&mut self, id: ExprId, name: Name, args: List) -> ExprInfo {
        let tree = self.tree;
        let types: Vec<Type> = tree.args(args).iter().map(|&a| self.ty(a)).collect();
        let token = tree.expr(id).extent.first;
        let Some(found) = self.foreign(name) else {
            return ExprInfo::ERROR;
        };
        if let Meaning::Type(_) = found.meaning {
            let ty = self.foreign_type(name, token).unwrap_or(Type::ERROR);
            return self.construct_type(id, ty, args);
        }
        // The arguments of `print` and similar functions have already been reported.
        let is_reported =
            matches!(found.meaning, Meaning::Silent) && types.iter().any(|t| t.is_error());
        if !self.was_reported(name) && !is_reported {
            self.report_undeclared(
                name,
                Extent::token(token),
                ForeignError::Call(id, name, args),
            );
        }
        ExprInfo {
            ty: self.type_of_foreign(found.meaning, &types),
            ..ExprInfo::ERROR
        }
    }

    /// The result type of a call of a function of another language, if known.
    fn type_of_foreign(&self, meaning: Meaning, types: &[Type]) -> Type {
        let found = match (meaning, types) {
            (Meaning::Function(word), _) => self.builtins.function(word).and_then(|f| {
                let (_, overloads) = self.builtins.overloads_of(f);
                overloads
                    .iter()
                    .find(|o| o.params() == types)
                    .map(|o| o.returns)
            }),
            (Meaning::Code("($1 * $2)", _), &[l, r]) => {
                typing::binary(self.types(), BinaryOp::Mul, l, r).ok()
            }
            (Meaning::Code(code, _) | Meaning::Nearly(code, ..), &[first, ..]) => {
                let keeps = !["tex", "int", "!", "($1 <"]
                    .iter()
                    .any(|p| code.starts_with(p));
                keeps.then_some(first)
            }
            _ => None,
        };
        found.unwrap_or(Type::ERROR)
    }
}
