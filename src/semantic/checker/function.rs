//! Functions: headers, prototypes and bodies (GLSL ES 3.00 section 6.1).

use super::super::builtins::Overload;
use super::qualifier::Wanted;
use super::*;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

impl Checker<'_> {
    /// A declaration without a body.
    pub(super) fn prototype(&mut self, id: FunctionId) {
        let tree = self.tree;
        let Some(decl) = tree.function(id) else {
            return;
        };
        if !self.at_global_scope() {
            let d = self
                .error(
                    error::LOCAL_FUNCTION,
                    decl.header,
                    "a function cannot be declared inside a function",
                )
                .note("move the declaration out (section 4.2.4)");
            self.report(d);
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
            let message = format!("`{}` is declared twice", self.text(decl.ident.name));
            let d = self
                .error(error::FUNCTION_MISMATCH, decl.header, message)
                .note("GLSL ES 1.00 section 4.2.7 allows one prototype only");
            self.report(d);
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

    pub(super) fn function_definition(&mut self, id: FunctionId) {
        let tree = self.tree;
        let Some(decl) = tree.function(id) else {
            return;
        };
        // A struct that is declared here is known to the rest of the shader.
        let returns = self.return_type(decl);
        self.scopes.push();
        self.precisions.push();
        // The parameters belong to the function, whose number is not known before its types are.
        let next = FunctionRef(self.functions.len() as u32);
        let first_variable = self.variables.len();
        self.current = Some(next);
        let params = self.parameters(decl, true);
        let declared = match params {
            Some(params) => {
                let count = params.len();
                if count > 255 {
                    let d = self.error(
                        error::BROWSER_LIMIT,
                        decl.header,
                        "a function takes at most 255 parameters",
                    );
                    self.report(d);
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
            let name = self.text(decl.ident.name);
            let d = self.error_at(
                error::REDEFINITION,
                decl.ident.token,
                format!("the function `{name}` is defined twice with the same parameters"),
            );
            let d = self.with_declaration(d, token, "first defined here");
            return self.report(d);
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
        if !returns.is_void() && !returns.is_error() && !self.returns_value {
            let name = self.text(decl.ident.name);
            let wanted = self.name_of(returns);
            let d = self
                .error(
                    error::MISSING_RETURN,
                    decl.header,
                    format!("`{name}` returns nothing, although it is `{wanted}`"),
                )
                .note(format!(
                    "somewhere in it must be a `return` with a `{wanted}`"
                ));
            // A statement that could not be read may have been the `return`.
            if !self.syntax_errors {
                self.report(d);
            }
        }
    }

    /// Checks the parameters, and declares them if the function has a body. Nothing where a type is
    /// not known: the function then stands for any.
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
            if let Some(slot) = self.declared_params.get_mut(decl.params.start as usize + i) {
                *slot = id;
            }
        }
        if !known {
            self.scopes_declare_unknown_function(decl.ident);
            return None;
        }
        Some(params)
    }

    /// Calls of a function whose parameters could not be read are not judged.
    fn scopes_declare_unknown_function(&mut self, ident: Ident) {
        self.unknown_functions.insert(ident.name);
    }

    /// `(void)`; true where that is right.
    fn void_parameter(&mut self, param: &Param, count: usize) -> bool {
        if param.ident.is_none() && count == 1 {
            return true;
        }
        let d = self
            .error(
                error::VOID_VALUE,
                param.extent,
                "a parameter cannot be `void`",
            )
            .note("only `f(void)`, for no parameter at all, is allowed");
        self.report(d);
        false
    }

    fn parameter_type(&mut self, param: &Param, base: Type, direction: Direction) -> Type {
        let tree = self.tree;
        if let TypeBase::Struct(_) = tree.ty(param.ty).base {
            let d = self.error(
                error::INVALID_PARAMETER,
                param.extent,
                "a struct cannot be declared in a parameter",
            );
            self.report(d);
        }
        let ty = self.with_arrays(base, param.arrays, Wanted::None);
        let message = if ty.array == Type::UNSIZED {
            "an array parameter needs a size"
        } else if ty.is_sampler() && direction.writes() {
            "a sampler cannot be an `out` parameter"
        } else {
            return ty;
        };
        let d = self.error(error::INVALID_PARAMETER, param.extent, message);
        self.report(d);
        Type::ERROR
    }

    /// Makes a function known, or finds the one that was declared before.
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
    pub(super) fn function_of(
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

    /// A function belongs to global scope, although its parameters' scope is open.
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
        let holds_sampler = self.inside(ty).sampler;
        let message = if holds_sampler {
            "a function cannot return a sampler"
        } else if ty.array == Type::UNSIZED {
            "an array that is returned needs a size"
        } else if !self.has(Feature::ArrayValues) && ty.is_array() {
            "GLSL ES 1.00 functions cannot return arrays"
        } else if !self.has(Feature::ArrayValues) && self.inside(ty).array {
            "GLSL ES 1.00 functions cannot return structs that hold arrays"
        } else {
            return ty;
        };
        let rule = if holds_sampler {
            error::SAMPLER_RESTRICTION
        } else {
            error::INVALID_ARRAY
        };
        let d = self.error(rule, extent, message);
        self.report(d);
        Type::ERROR
    }

    /// Only a precision may stand before the return type. Says whether one does.
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
                let word = self.sources.text(self.span(qualifier.extent));
                let message = format!("a function's return type cannot be `{word}`");
                let d = self.error(error::INVALID_QUALIFIER, qualifier.extent, message);
                self.report(d);
            }
        }
        !all.is_empty()
    }

    /// A function must not take the name of a built-in one: in GLSL ES 3.00 any form of it, in 1.00
    /// the same form.
    fn check_builtin_name(&mut self, ident: Ident, params: &[Parameter]) -> bool {
        let text = self.text(ident.name);
        let Some(found) = self.builtins.function(text) else {
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
        let to = self.free_function_name(text);
        let edits = self.rename_all(ident.name, &to);
        let d = self
            .error_at(error::BUILTIN_REDEFINITION, ident.token, format!("`{text}` is a built-in function"))
            .note("GLSL ES 3.00 lets no function take such a name, whatever its parameters (section 6.1)");
        let d = if edits.is_empty() {
            d.help(format!("rename it, to `{to}` for example"))
        } else {
            d.fix(crate::diagnostic::Fix::suggestion(
                format!("rename it to `{to}`"),
                edits,
            ))
        };
        self.report(d);
        false
    }

    fn free_function_name(&self, text: &str) -> String {
        let mut chars = text.chars();
        let first = chars.next().map(|c| c.to_ascii_uppercase()).unwrap_or('F');
        let base = format!("my{first}{}", chars.as_str());
        let mut name = base.clone();
        let mut number = 2;
        while self.names.get(&name).is_some() {
            name = format!("{base}{number}");
            number += 1;
        }
        name
    }

    /// A function must not take the name of a variable or struct.
    fn check_hidden(&mut self, ident: Ident) {
        let Some(before) = self.scopes.get_global(ident.name) else {
            return;
        };
        if matches!(before, Binding::Function | Binding::Error) {
            return;
        }
        let text = self.text(ident.name);
        let token = self.declaration_token(ident.name, before);
        let d = self.error_at(
            error::REDEFINITION,
            ident.token,
            format!("`{text}` is declared twice in one scope"),
        );
        let d = self.with_declaration(d, token, "first declared here");
        self.report(d);
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
        let text = self.text(decl.ident.name);
        let message = if !same_returns {
            let other = self.name_of(before.returns);
            format!(
                "`{text}` returns `{}` here, but `{other}` in another declaration",
                self.name_of(returns)
            )
        } else if !same_directions {
            format!("the parameters of `{text}` are qualified otherwise in another declaration")
        } else {
            return;
        };
        if token.is_some_and(|t| self.is_prelude(t)) && self.is_entry(text) {
            return self.wrong_entry(decl);
        }
        let d = self.error(error::FUNCTION_MISMATCH, decl.header, message);
        let d = self.with_declaration(d, token, "the other one");
        self.report(d);
        if let Some(before) = self.functions.get_mut(known.0 as usize) {
            before.returns = Type::ERROR;
        }
    }

    fn is_entry(&self, text: &str) -> bool {
        self.dialect.host().entry.is_some_and(|e| e.name == text)
    }

    pub(super) fn wrong_entry(&mut self, decl: &FunctionDecl) {
        let Some(entry) = self.dialect.host().entry else {
            return;
        };
        let text = self.text(decl.ident.name);
        let d = self
            .error(
                error::MAINIMAGE_SIGNATURE,
                decl.header,
                format!("`{text}` is not declared as the player calls it"),
            )
            .help(format!("write `{}`", entry.signature));
        self.report(d);
    }

    fn check_main(&mut self, decl: &FunctionDecl, returns: Type) {
        if self.text(decl.ident.name) != "main" {
            return;
        }
        let has_params = self
            .tree
            .params(decl.params)
            .iter()
            .any(|p| self.tree.ty(p.ty).base != TypeBase::Void);
        let message = if has_params {
            "`main` takes no parameters"
        } else if !returns.is_void() && !returns.is_error() {
            "`main` returns nothing"
        } else {
            return;
        };
        let d = self
            .error(error::FUNCTION_MISMATCH, decl.header, message)
            .help("write `void main()`");
        self.report(d);
    }
}

/// The hash of what tells functions apart.
fn signature(name: Name, types: impl Iterator<Item = Type>) -> u64 {
    let mut hasher = FxHasher::default();
    name.hash(&mut hasher);
    types.for_each(|ty| ty.hash(&mut hasher));
    hasher.finish()
}
