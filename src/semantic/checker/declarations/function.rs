//! Functions: headers, prototypes and bodies (GLSL ES 3.00 section 6.1).

use super::qualifier::StorageRequest;
use crate::builtins::Overload;
use crate::checker::*;
use rustc_hash::FxHasher;
use shaderlint_text::SetAt;
use std::hash::{Hash, Hasher};

/// An error in the header of a function, or between its declarations.
#[derive(Clone, Copy, Debug)]
pub enum FunctionError {
    /// A function that is declared inside another.
    Local,
    /// A second prototype, in a version that allows only one.
    PrototypeTwice(Name),
    /// A second definition, and the name in the first one.
    DefinedTwice(Name, Option<TokenId>),
    /// A function that never returns a value of its return type.
    NoReturn(Name, Type),
    /// A parameter of type `void`.
    VoidParameter,
    /// A struct that is declared in a parameter list.
    StructParameter,
    /// An array parameter without a size.
    UnsizedParameter,
    /// A sampler parameter that is `out` or `inout`.
    OutSampler,
    /// A return type that is or contains a sampler.
    ReturnsSampler,
    /// An array return type without a size.
    ReturnsUnsized,
    /// An array return type, in a version without array values.
    ReturnsArray,
    /// A return type that is a struct containing an array, in such a version.
    ReturnsArrayInside,
    /// A function with the name of a built-in one.
    Builtin(Name),
    /// The return type here, and the one of an earlier declaration.
    ReturnType(FunctionRef, Type, Type),
    /// Parameter qualifiers that differ from an earlier declaration.
    Directions(FunctionRef),
}

impl Checker<'_> {
    /// A declaration without a body.
    pub(in crate::checker) fn prototype(&mut self, id: FunctionId) {
        let tree = self.tree;
        let Some(decl) = tree.function(id) else {
            return;
        };
        if !self.at_global_scope() {
            self.reject(decl.header, FunctionError::Local);
        }
        let before = self.function_named(id);
        let returns = self.return_type(decl);
        self.scopes.push();
        self.precisions.push();
        let params = self.parameters(decl, false);
        self.precisions.pop();
        self.scopes.pop();
        let Some(params) = params else { return };
        if let Some(function) = self.declare_function(id, decl, params, returns)
            && before == Some(function)
            && !self.has(Feature::RepeatedPrototypes)
        {
            let name = decl.ident.name;
            self.reject(decl.header, FunctionError::PrototypeTwice(name));
        }
    }

    /// The only function of a name so far, for the rule on prototypes of GLSL ES 1.00.
    fn function_named(&self, id: FunctionId) -> Option<FunctionRef> {
        let name = self.tree.function(id)?.ident.name;
        let all = self.by_name.get(&name)?;
        let declared = |f: &&FunctionRef| {
            let function = self.functions.get(f.0 as usize);
            function.is_some_and(|f| {
                self.tree
                    .function(f.declaration)
                    .is_some_and(|d| d.body.is_none())
            })
        };
        all.iter()
            .filter(declared)
            .count()
            .eq(&1)
            .then(|| all.first().copied())
            .flatten()
    }

    pub(in crate::checker) fn function_definition(&mut self, id: FunctionId) {
        let tree = self.tree;
        let Some(decl) = tree.function(id) else {
            return;
        };
        // A struct that is declared here is visible in the rest of the shader.
        let returns = self.return_type(decl);
        self.scopes.push();
        self.precisions.push();
        // The parameters belong to the function, but its id is not known before their types.
        let next = FunctionRef(self.functions.len() as u32);
        let first_variable = self.variables.len();
        self.current = Some(next);
        let params = self.parameters(decl, true);
        let declared = match params {
            Some(params) => {
                let count = params.len();
                if count > 255 {
                    self.reject(decl.header, LimitError::Parameters);
                }
                self.declare_function(id, decl, params, returns)
            }
            None => None,
        };
        self.current = declared.or(Some(next));
        for variable in self.variables.iter_mut().skip(first_variable) {
            variable.function = self.current;
        }
        let returns = match declared.and_then(|f| self.functions.get(f.0 as usize)) {
            Some(function) => function.returns,
            None => Type::ERROR,
        };
        if let Some(function) = declared {
            self.note_definition(function, id, decl);
        }
        self.body(decl, returns);
        self.current = None;
        self.precisions.pop();
        self.scopes.pop();
    }

    fn note_definition(&mut self, function: FunctionRef, id: FunctionId, decl: &FunctionDecl) {
        let Some(known) = self.functions.get_mut(function.0 as usize) else {
            return;
        };
        if let Some(before) = known.definition {
            let token = self.tree.function(before).map(|f| f.ident.token);
            let at = Extent::token(decl.ident.token);
            let problem = FunctionError::DefinedTwice(decl.ident.name, token);
            return self.reject(at, problem);
        }
        known.definition = Some(id);
    }

    fn body(&mut self, decl: &FunctionDecl, returns: Type) {
        let tree = self.tree;
        let Some(body) = decl.body else { return };
        self.level = 3;
        self.flow.clear();
        self.returns_value = false;
        self.returned = returns;
        if let StmtKind::Block(list) = tree.stmt(body).kind {
            self.statements(list);
        }
        let lacks_return = !returns.is_void() && !returns.is_error() && !self.returns_value;
        // A statement with a syntax error may have been the `return`.
        if lacks_return && !self.syntax_errors {
            let problem = FunctionError::NoReturn(decl.ident.name, returns);
            self.reject(decl.header, problem);
        }
    }

    /// Checks the parameters, and declares them if `declare`. `None` if a type is unknown: calls of
    /// the function are then not checked.
    fn parameters(&mut self, decl: &FunctionDecl, declare: bool) -> Option<Vec<Parameter>> {
        let tree = self.tree;
        let list = tree.params(decl.params);
        let mut params = Vec::with_capacity(list.len());
        let mut known = true;
        for (i, param) in list.iter().enumerate() {
            let (direction, precision) = self.param_qualifiers(param.qualifiers);
            let base = self.type_spec(param.ty);
            if base.is_void() {
                known &= self.void_parameter(param, list.len());
                continue;
            }
            self.check_precision(base, precision, tree.ty(param.ty).extent);
            let ty = self.parameter_type(param, base, direction);
            known &= !ty.is_error();
            params.push(Parameter { ty, direction });
            if declare {
                self.check_size(ty, Storage::Param(direction), param.ident, param.extent);
            }
            let Some(ident) = param.ident else { continue };
            if !declare {
                self.check_not_reserved(ident);
                continue;
            }
            let id =
                self.declare_variable(ident, ty, Storage::Param(direction), false, Constant::NONE);
            self.declared_params
                .set_at(decl.params.start as usize + i, id);
        }
        if !known {
            self.scopes_declare_unknown_function(decl.ident);
            return None;
        }
        Some(params)
    }

    /// Calls of a function with faulty parameters are not checked.
    fn scopes_declare_unknown_function(&mut self, ident: Ident) {
        self.unknown_functions.insert(ident.name);
    }

    /// Checks `(void)`; false if `void` is not allowed here.
    fn void_parameter(&mut self, param: &Param, count: usize) -> bool {
        if param.ident.is_none() && count == 1 {
            return true;
        }
        self.reject(param.extent, FunctionError::VoidParameter);
        false
    }

    fn parameter_type(&mut self, param: &Param, base: Type, direction: Direction) -> Type {
        let tree = self.tree;
        if let TypeBase::Struct(_) = tree.ty(param.ty).base {
            self.reject(param.extent, FunctionError::StructParameter);
        }
        let ty = self.with_arrays(base, param.arrays, StorageRequest::None);
        let problem = if ty.array == Type::UNSIZED {
            FunctionError::UnsizedParameter
        } else if ty.is_sampler() && direction.writes() {
            FunctionError::OutSampler
        } else {
            return ty;
        };
        self.reject(param.extent, problem);
        Type::ERROR
    }

    /// Declares a function, or finds the one that was declared before.
    fn declare_function(
        &mut self,
        id: FunctionId,
        decl: &FunctionDecl,
        params: Vec<Parameter>,
        returns: Type,
    ) -> Option<FunctionRef> {
        let name = decl.ident.name;
        if !self.check_not_reserved(decl.ident) {
            return None;
        }
        if !self.check_builtin_name(decl.ident, &params) {
            self.unknown_functions.insert(name);
            return None;
        }
        self.check_hidden(decl.ident);
        let types = params.iter().map(|p| p.ty);
        if let Some(known) = self.function_of(name, types.clone()) {
            self.check_redeclaration(known, decl, &params, returns);
            return Some(known);
        }
        let function = FunctionRef(self.functions.len() as u32);
        let hash = signature(name, types);
        self.by_signature.entry(hash).or_insert(function);
        self.functions.push(Function {
            name,
            params,
            returns,
            declaration: id,
            definition: None,
        });
        self.by_name.entry(name).or_default().push(function);
        self.declare_globally(name);
        self.check_main(decl, returns);
        Some(function)
    }

    /// The function of the shader with this name and these parameters.
    pub(in crate::checker) fn function_of(
        &self,
        name: Name,
        types: impl Iterator<Item = Type> + Clone,
    ) -> Option<FunctionRef> {
        let fits = |function: &FunctionRef| {
            let known = self.functions.get(function.0 as usize);
            known.is_some_and(|f| f.name == name && f.params.iter().map(|p| p.ty).eq(types.clone()))
        };
        let first = self.by_signature.get(&signature(name, types.clone()))?;
        if fits(first) {
            return Some(*first);
        }
        self.by_name.get(&name)?.iter().copied().find(fits)
    }

    /// Binds the name at global scope, although the scope of the parameters is open.
    fn declare_globally(&mut self, name: Name) {
        if !matches!(self.scopes.get_global(name), Some(Binding::Function)) {
            self.scopes.declare_global(name, Binding::Function);
        }
    }

    fn return_type(&mut self, decl: &FunctionDecl) -> Type {
        let tree = self.tree;
        let qualified = self.function_qualifiers(decl);
        let ty = self.type_spec(decl.ty);
        let extent = tree.ty(decl.ty).extent;
        self.check_precision(ty, qualified, extent);
        let problem = if self.inside(ty).sampler {
            FunctionError::ReturnsSampler
        } else if ty.array == Type::UNSIZED && decl.body.is_some() {
            FunctionError::ReturnsUnsized
        } else if !self.has(Feature::ArrayValues) && ty.is_array() {
            FunctionError::ReturnsArray
        } else if !self.has(Feature::ArrayValues) && self.inside(ty).array {
            FunctionError::ReturnsArrayInside
        } else {
            return ty;
        };
        self.reject(extent, problem);
        Type::ERROR
    }

    /// Checks the qualifiers of the return type, which can only be a precision; whether there is
    /// one.
    fn function_qualifiers(&mut self, decl: &FunctionDecl) -> bool {
        use QualifierKind as Q;
        let tree = self.tree;
        let all = tree.qualifiers(decl.qualifiers);
        let is_precision = |q: &Qualifier| matches!(q.kind, Q::Lowp | Q::Mediump | Q::Highp);
        if all.iter().all(is_precision) {
            self.check_sequence(all);
        }
        for qualifier in all {
            if !is_precision(qualifier) {
                self.reject(qualifier.extent, QualifierError::Returned);
            }
        }
        !all.is_empty()
    }

    /// A function must not redefine a built-in one: in GLSL ES 3.00 with any parameters, in 1.00
    /// with the same parameters.
    fn check_builtin_name(&mut self, ident: Ident, params: &[Parameter]) -> bool {
        let text = self.text(ident.name);
        let Some(found) = self.builtins.protected_function(text) else {
            return true;
        };
        if !self.has(Feature::OverloadedBuiltins) && found.is_redefinable() {
            return true;
        }
        if self.has(Feature::OverloadedBuiltins) {
            let types = params.iter().map(|p| p.ty);
            let (_, overloads) = self.builtins.overloads_of(found);
            let is_same = |o: &Overload| types.clone().eq(o.params().iter().copied());
            if !overloads.iter().any(is_same) {
                return true;
            }
        }
        if self.is_prelude(ident.token) {
            return true;
        }
        if !self.reported_names.insert(ident.name) {
            return false;
        }
        let at = Extent::token(ident.token);
        self.reject(at, FunctionError::Builtin(ident.name));
        false
    }

    /// A function must not have the name of a variable or struct.
    fn check_hidden(&mut self, ident: Ident) {
        let Some(before) = self.scopes.get_global(ident.name) else {
            return;
        };
        if matches!(before, Binding::Function | Binding::Error) {
            return;
        }
        let at = Extent::token(ident.token);
        self.reject(at, NameError::Twice(ident.name, before));
    }

    /// All declarations of a function must agree (section 6.1).
    fn check_redeclaration(
        &mut self,
        known: FunctionRef,
        decl: &FunctionDecl,
        params: &[Parameter],
        returns: Type,
    ) {
        let Some(before) = self.functions.get(known.0 as usize) else {
            return;
        };
        let token = self
            .tree
            .function(before.declaration)
            .map(|f| f.ident.token);
        let same_returns = before.returns == returns || returns.is_error();
        let same_directions = before
            .params
            .iter()
            .zip(params)
            .all(|(a, b)| a.direction == b.direction);
        let problem = if !same_returns {
            FunctionError::ReturnType(known, returns, before.returns)
        } else if !same_directions {
            FunctionError::Directions(known)
        } else {
            return;
        };
        if token.is_some_and(|t| self.is_prelude(t)) && self.is_entry(decl.ident.name) {
            return self.wrong_entry(decl);
        }
        self.reject(decl.header, problem);
        if let Some(before) = self.functions.get_mut(known.0 as usize) {
            before.returns = Type::ERROR;
        }
    }
}

/// Hash of the name and parameter types of a function.
fn signature(name: Name, types: impl Iterator<Item = Type>) -> u64 {
    let mut hasher = FxHasher::default();
    name.hash(&mut hasher);
    types.for_each(|ty| ty.hash(&mut hasher));
    hasher.finish()
}
