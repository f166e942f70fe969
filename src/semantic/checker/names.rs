//! Name resolution, and errors about names.

use super::super::builtins::{BuiltinStorage, BuiltinVariable, LEGACY_FUNCTIONS};
use super::*;

/// An error in the declaration or use of a name.
#[derive(Clone, Copy, Debug)]
pub enum NameError {
    /// A reserved name, and who reserves it.
    Reserved(Name, Owner),
    /// A name that is already declared in the scope.
    Twice(Name, Binding),
    /// A function, block or type used as a variable.
    NotAVariable(Name, Binding),
    /// A variable that is not declared.
    Undeclared(Name),
    /// A name used as a type that is not a type.
    UnknownType(Name),
    /// A function of GLSL ES 1.00, and its replacement.
    LegacyFunction(Name, &'static str),
    /// A function that is not declared.
    UndeclaredFunction(Name),
}

/// Who reserves a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Owner {
    Language,
    Webgl,
    /// WebGL as well: names with two underscores in a row.
    Browser,
}

/// Who reserves a name, if it is reserved.
fn owner(name: &str) -> Option<Owner> {
    if !name.as_bytes().contains(&b'_') {
        None
    } else if name.starts_with("gl_") {
        Some(Owner::Language)
    } else if name.starts_with("webgl_") || name.starts_with("_webgl_") {
        Some(Owner::Webgl)
    } else {
        name.contains("__").then_some(Owner::Browser)
    }
}

impl Checker<'_> {
    /// Checks that a name is not reserved: no `gl_`, no `webgl_`, no two underscores in a row.
    pub(super) fn check_not_reserved(&mut self, ident: Ident) -> bool {
        let Some(owner) = owner(self.text(ident.name)) else {
            return true;
        };
        if self.is_prelude(ident.token) {
            return true;
        }
        if self.reported_names.insert(ident.name) {
            let at = Extent::token(ident.token);
            self.reject(at, NameError::Reserved(ident.name, owner));
        }
        false
    }

    /// Reports a name that is already declared in the innermost scope.
    pub(super) fn is_redefinition(&mut self, ident: Ident) -> bool {
        let Some(before) = self.scopes.get_here(ident.name) else {
            return false;
        };
        if before == Binding::Error {
            return true;
        }
        let at = Extent::token(ident.token);
        self.reject(at, NameError::Twice(ident.name, before));
        true
    }

    /// The variable that a name resolves to here, built-in variables included.
    pub(super) fn find_variable(&mut self, name: Name) -> Option<VariableId> {
        match self.scopes.get(name) {
            Some(Binding::Variable(id)) => Some(id),
            Some(_) => None,
            None => {
                if let Some(&id) = self.builtin_variables.get(&name) {
                    return Some(id);
                }
                let found = self.builtins.variable(self.text(name))?;
                let id = self.declare_builtin(name, found);
                self.builtin_variables.insert(name, id);
                Some(id)
            }
        }
    }

    pub(super) fn storage_of_builtin(&self, found: BuiltinVariable) -> Storage {
        match found.storage {
            BuiltinStorage::In => Storage::Input,
            BuiltinStorage::Out => Storage::Output,
            BuiltinStorage::Uniform => Storage::Uniform,
            BuiltinStorage::Const(_) => Storage::Global,
        }
    }

    /// Adds a built-in variable to the program.
    fn declare_builtin(&mut self, name: Name, found: BuiltinVariable) -> VariableId {
        let storage = self.storage_of_builtin(found);
        let is_const = matches!(found.storage, BuiltinStorage::Const(_));
        let constant = self.pool.add(found.storage.value());
        let ty = found.ty.unwrap_or_else(|| self.depth_range());
        let id = VariableId(self.variables.len() as u32);
        self.variables.push(Variable {
            name,
            ty,
            storage,
            is_const,
            constant,
            token: None,
            function: None,
            hides: None,
            written: false,
            read: false,
        });
        id
    }

    /// Adds the struct type of `gl_DepthRange`.
    fn depth_range(&mut self) -> Type {
        let fields = ["near", "far", "diff"]
            .iter()
            .filter_map(|f| self.names.get(f))
            .map(|name| Field {
                name,
                ty: Type::FLOAT,
                token: 0,
            })
            .collect();
        let index = self.structs.len() as u32;
        self.structs.push(Struct {
            name: None,
            token: 0,
            fields,
            inside: Inside {
                nesting: 1,
                ..Inside::default()
            },
        });
        Type::structure(index)
    }

    /// A name used as a variable.
    pub(super) fn name(&mut self, name: Name, id: ExprId) -> ExprInfo {
        let token = self.tree.expr(id).extent.first;
        match self.scopes.get(name) {
            Some(Binding::Variable(variable)) => self.variable(variable, token),
            Some(Binding::Error) => ExprInfo::ERROR,
            Some(binding) => {
                self.reject(Extent::token(token), NameError::NotAVariable(name, binding));
                ExprInfo::ERROR
            }
            None => match self.find_variable(name) {
                Some(variable) => self.variable(variable, token),
                None => {
                    self.undeclared_variable(name, token);
                    ExprInfo::ERROR
                }
            },
        }
    }

    fn variable(&mut self, id: VariableId, token: TokenId) -> ExprInfo {
        let Some(variable) = self.variables.get_mut(id.0 as usize) else {
            return ExprInfo::ERROR;
        };
        variable.read = true;
        let Variable {
            ty,
            constant,
            is_const,
            name,
            storage,
            token: declared,
            ..
        } = *variable;
        if declared.is_none() && storage == Storage::Output && !self.has(Feature::InOut) {
            match self.names.text(name) {
                "gl_FragColor" => self.frag_color = self.frag_color.or(Some(token)),
                "gl_FragData" => self.frag_data = self.frag_data.or(Some(token)),
                _ => {}
            }
        }
        ExprInfo {
            ty,
            constant,
            resolution: Resolution::Variable(id),
            height: 0,
            is_const,
        }
    }

    /// Whether an undeclared name was already reported; counts the use.
    pub(super) fn was_reported(&mut self, name: Name) -> bool {
        match self.undeclared.get_mut(&name) {
            Some((_, uses)) => {
                *uses += 1;
                true
            }
            None => false,
        }
    }

    pub(super) fn report_undeclared(
        &mut self,
        name: Name,
        at: Extent,
        problem: impl Into<ProblemKind>,
    ) {
        self.undeclared.insert(name, (self.problems.len(), 0));
        self.reject(at, problem);
    }

    fn undeclared_variable(&mut self, name: Name, token: TokenId) {
        // Reserved words have been reported by the parser.
        if self.token(token).kind == TokenKind::Reserved || self.was_reported(name) {
            return;
        }
        self.report_undeclared(name, Extent::token(token), NameError::Undeclared(name));
    }

    /// A name used as a type that is not a type.
    pub(super) fn unknown_type(&mut self, name: Name, token: TokenId) {
        if self.was_reported(name) {
            return;
        }
        self.report_undeclared(name, Extent::token(token), NameError::UnknownType(name));
    }

    /// A call of a function that is not declared.
    pub(super) fn undeclared_function(&mut self, name: Name, token: TokenId) {
        let text = self.text(name);
        let legacy = LEGACY_FUNCTIONS.iter().find(|(old, _)| *old == text);
        if let (Some((_, new)), true) = (legacy, self.has(Feature::OverloadedLookups)) {
            return self.reject(Extent::token(token), NameError::LegacyFunction(name, new));
        }
        if self.was_reported(name) {
            return;
        }
        self.report_undeclared(
            name,
            Extent::token(token),
            NameError::UndeclaredFunction(name),
        );
    }
}
