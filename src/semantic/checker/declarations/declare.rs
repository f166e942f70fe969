//! Declarations of variables, structs and interface blocks (GLSL ES 3.00 section 4).

use super::qualifier::{Qualified, StorageRequest};
use crate::checker::*;
use crate::host::channel;
use shaderlint_syntax::GlExtension;

/// An error in the declaration of a variable.
#[derive(Clone, Copy, Debug)]
pub enum DeclarationError {
    /// A variable of type `void`.
    Void,
    /// A sampler that is neither a uniform nor a parameter.
    Sampler,
    /// A constant without an initializer.
    NoValue(Name),
    /// An initializer of a variable with a storage that has none, such as `uniform`.
    Value(StorageRequest),
}

impl<'a> Checker<'a> {
    pub(in crate::checker) fn declaration(&mut self, id: DeclId) {
        let tree = self.tree;
        let Some(decl) = tree.decl(id) else { return };
        match decl.kind {
            DeclKind::Error => {}
            DeclKind::Precision { ty, .. } => self.precision_statement(ty),
            DeclKind::Prototype(id) => self.prototype(id),
            DeclKind::Qualifiers { qualifiers, ident } => match ident {
                Some(ident) => self.requalify(qualifiers, ident),
                None => self.default_layout(qualifiers, decl.extent),
            },
            DeclKind::Block {
                qualifiers,
                members,
                instance,
            } => {
                self.block(qualifiers, members, instance, decl.extent);
            }
            DeclKind::Variables {
                qualifiers,
                ty,
                declarators,
            } => {
                self.variables(qualifiers, ty, declarators);
            }
        }
    }

    fn variables(&mut self, qualifiers: List, ty: TypeId, declarators: List) {
        let tree = self.tree;
        let mut qualified = self.qualifiers(qualifiers);
        let base = match self.inferred_type(qualifiers, ty, declarators) {
            Some((base, storage)) => {
                qualified.storage = storage;
                base
            }
            None => self.type_spec(ty),
        };
        let extent = tree.ty(ty).extent;
        self.check_type_of_variables(&qualified, base, extent);
        if declarators.len == 0 {
            self.check_variable_layout(&qualified, extent);
            if base.array == Type::UNSIZED {
                self.reject(extent, ArrayError::NoSize);
            }
            return;
        }
        for (i, declarator) in tree.declarators(declarators).iter().enumerate() {
            if i > 0 && qualified.layout.location.is_some() {
                self.reject(Extent::token(declarator.ident.token), LayoutError::Shared);
            }
            let index = declarators.start as usize + i;
            let spec = (declarators.len == 1).then_some(extent);
            self.declarator(index, declarator, &qualified, base, spec);
        }
    }

    /// Checks the type and qualifiers of a declaration, before its declarators.
    pub(super) fn check_type_of_variables(
        &mut self,
        qualified: &Qualified,
        base: Type,
        extent: Extent,
    ) {
        self.check_precision(base, qualified.precision, extent);
        self.check_invariant(qualified, extent);
        self.check_interpolation(qualified, extent);
        if !self.has(Feature::InOut) && base.is_array() {
            self.reject(extent, ArrayError::BehindType);
        }
        if let Err(problem) = self.passed(qualified.storage, base) {
            self.reject(extent, problem);
        }
    }

    /// `flat`, `smooth` and `centroid` need an `in` or `out`. Inside a function they have already
    /// been reported.
    fn check_interpolation(&mut self, qualified: &Qualified, extent: Extent) {
        let alone = matches!(
            qualified.storage,
            StorageRequest::Flat | StorageRequest::Smooth | StorageRequest::Centroid
        );
        if alone && self.at_global_scope() {
            let at = qualified.extent.unwrap_or(extent);
            self.reject(at, QualifierError::Alone(qualified.storage));
        }
    }

    fn check_invariant(&mut self, qualified: &Qualified, extent: Extent) {
        let is_output =
            qualified.storage == StorageRequest::Varying || qualified.storage.is_output();
        if qualified.invariant && !is_output {
            let at = qualified.extent.unwrap_or(extent);
            self.reject(at, QualifierError::Invariant);
        }
    }

    /// What a type contains: arrays, samplers and so on.
    pub(in crate::checker) fn inside(&self, ty: Type) -> Inside {
        self.types().inside(ty)
    }

    fn declarator(
        &mut self,
        index: usize,
        declarator: &Declarator,
        qualified: &Qualified,
        base: Type,
        spec: Option<Extent>,
    ) {
        let name = Extent::token(declarator.ident.token);
        self.check_variable_layout(qualified, name);
        if let Some(word) = qualified.layout.depth
            && self.text(declarator.ident.name) != "gl_FragDepth"
        {
            self.reject(Extent::token(word.token), LayoutError::Unknown(word.name));
        }
        let ok = self.check_qualified_type(qualified, base, name);
        let mut ty = self.with_arrays(base, declarator.arrays, qualified.storage);
        let mut initial = None;
        if let Some(init) = declarator.init {
            self.expected = Some(ty);
            self.eval(init);
            self.expected = None;
            initial = Some(self.info(init));
            if ty.array == Type::UNSIZED {
                let found = self.ty(init);
                ty.array = if found.is_array() { found.array } else { 1 };
            }
        } else if ty.array == Type::UNSIZED {
            self.reject(declarator.extent, ArrayError::NoSizeNorValue);
            ty.array = 1;
        }
        if !ok {
            ty = Type::ERROR;
        }
        let mut is_const = qualified.storage == StorageRequest::Const;
        let mut constant = Constant::NONE;
        if is_const && declarator.init.is_none() {
            let name = declarator.ident.name;
            self.reject(declarator.extent, DeclarationError::NoValue(name));
            is_const = false;
        }
        if let (Some(init), Some(info)) = (declarator.init, initial) {
            match self.check_initializer(declarator, qualified, spec, ty, init) {
                true => {
                    constant = if is_const {
                        info.constant
                    } else {
                        Constant::NONE
                    }
                }
                false => ty = self.chosen_type(index, spec, declarator, ty),
            }
            is_const &= info.is_const;
        }
        let storage = self.storage_of(qualified.storage);
        self.check_size(ty, storage, Some(declarator.ident), declarator.extent);
        let before = self.scopes.get_here(declarator.ident.name);
        let id = self.declare_variable(declarator.ident, ty, storage, is_const, constant);
        if let (None, Some(Binding::Variable(first))) = (id, before) {
            let is_meant = self.means_second(index, first, ty);
            self.recover_redefinition(declarator.ident, first, ty, spec, is_meant);
            if is_meant {
                self.bind_variable(declarator.ident, ty, storage, is_const, constant);
            }
        }
        if let (Some(id), Some(slot)) = (id, self.declared.get_mut(index)) {
            *slot = Some(id);
        }
        if let (Some(id), Some(info)) = (id, initial) {
            self.track_always_true(id, info, ty);
        }
        if !self.is_builtin_name(declarator.ident.name) {
            self.note_output(declarator, qualified, ty);
        }
        self.check_declared_depth(declarator);
    }

    /// Whether the type is allowed with these qualifiers; reports if not.
    fn check_qualified_type(&mut self, qualified: &Qualified, base: Type, name: Extent) -> bool {
        if base.is_error() {
            return false;
        }
        if base.is_void() {
            self.reject(name, DeclarationError::Void);
        } else if let Err(problem) = self.passed_as(qualified.storage, base) {
            self.reject(name, problem);
        } else if self.inside(base).sampler && qualified.storage != StorageRequest::Uniform {
            self.reject(name, DeclarationError::Sampler);
        } else {
            return true;
        }
        false
    }

    fn storage_of(&self, expected: StorageRequest) -> Storage {
        match expected {
            StorageRequest::Uniform => Storage::Uniform,
            StorageRequest::Attribute => Storage::Input,
            StorageRequest::Varying if self.stage == Stage::Vertex => Storage::Output,
            StorageRequest::Varying => Storage::Input,
            expected if expected.is_input() => Storage::Input,
            expected if expected.is_output() => Storage::Output,
            _ if self.at_global_scope() => Storage::Global,
            _ => Storage::Local,
        }
    }

    /// Declares a variable, unless its name is taken or reserved.
    pub(super) fn declare_variable(
        &mut self,
        ident: Ident,
        ty: Type,
        storage: Storage,
        is_const: bool,
        constant: Constant,
    ) -> Option<VariableId> {
        let mut ty = ty;
        if self.is_prelude(ident.token) {
            ty = self.channel_type(ident.name, ty);
        }
        if !self.redeclares_builtin(ident, ty, storage) {
            self.check_not_reserved(ident);
        }
        if self.is_redefinition(ident) {
            return None;
        }
        Some(self.bind_variable(ident, ty, storage, is_const, constant))
    }

    /// Whether a name is that of a built-in variable.
    fn is_builtin_name(&self, name: Name) -> bool {
        let text = self.text(name);
        text.starts_with("gl_") && self.builtins.variable(text).is_some()
    }

    /// Whether a declaration repeats a built-in variable as an extension allows: distances with a size
    /// before they are used, and the depth.
    fn redeclares_builtin(&self, ident: Ident, ty: Type, storage: Storage) -> bool {
        let text = self.text(ident.name);
        if !text.starts_with("gl_") || !self.at_global_scope() {
            return false;
        }
        let Some((builtin, known)) = self.builtins.variable(text).and_then(|b| Some((b, b.ty?)))
        else {
            return false;
        };
        let is_like = known.element() == ty.element()
            && known.is_array() == ty.is_array()
            && ty.array <= known.array
            && self.storage_of_builtin(builtin) == storage;
        let is_allowed = match text {
            "gl_FragDepth" => self.has_active(GlExtension::ConservativeDepth),
            "gl_ClipDistance" | "gl_CullDistance" => {
                !self.builtin_variables.contains_key(&ident.name)
            }
            _ => false,
        };
        is_like && is_allowed
    }

    /// Binds a name to a new variable.
    pub(super) fn bind_variable(
        &mut self,
        ident: Ident,
        ty: Type,
        storage: Storage,
        is_const: bool,
        constant: Constant,
    ) -> VariableId {
        let hides = match self.scopes.get(ident.name) {
            Some(Binding::Variable(outer)) => Some(outer),
            _ => None,
        };
        let id = VariableId(self.variables.len() as u32);
        self.variables.push(Variable {
            name: ident.name,
            ty,
            storage,
            is_const,
            constant,
            token: Some(ident.token),
            function: self.current,
            hides,
            written: false,
            read: false,
        });
        self.scopes.declare(ident.name, Binding::Variable(id));
        id
    }

    /// The type of `iChannel0` to `iChannel3`, overridden by the options.
    fn channel_type(&self, name: Name, ty: Type) -> Type {
        let channel = channel(self.text(name)).and_then(|c| self.channels.get(c as usize));
        channel.copied().flatten().map_or(ty, Type::sampler)
    }

    /// Resolves a type specifier. Declares the struct that it may define.
    pub(in crate::checker) fn type_spec(&mut self, id: TypeId) -> Type {
        let tree = self.tree;
        let spec = tree.ty(id);
        let base = match spec.base {
            TypeBase::Error => Type::ERROR,
            TypeBase::Void => Type::VOID,
            TypeBase::Word(word) => Type::of_word(word),
            TypeBase::Struct(id) => self.structure(id),
            TypeBase::Name(name) => self.named_type(name, spec.extent.first),
        };
        if spec.arrays.len == 0 {
            return base;
        }
        self.with_arrays(base, spec.arrays, StorageRequest::None)
    }

    fn named_type(&mut self, name: Name, token: TokenId) -> Type {
        match self.scopes.get(name) {
            Some(Binding::Struct(id)) => Type::structure(id),
            Some(Binding::Error) => Type::ERROR,
            found => {
                let foreign = match found {
                    None => self.foreign_type(name, token),
                    _ => None,
                };
                foreign.unwrap_or_else(|| {
                    self.unknown_type(name, token);
                    Type::ERROR
                })
            }
        }
    }

    /// Adds the details that a fix needs to the error about a redeclared name.
    fn recover_redefinition(
        &mut self,
        ident: Ident,
        first: VariableId,
        ty: Type,
        spec: Option<Extent>,
        is_meant: bool,
    ) {
        let is_it = |p: &Problem| {
            p.at == Extent::token(ident.token)
                && matches!(p.what, ProblemKind::Name(NameError::Twice(..)))
        };
        if self.problems.last().is_some_and(is_it) {
            let second = SecondDeclaration {
                ident,
                first,
                ty,
                spec,
                is_meant,
            };
            self.add_aside(self.problems.len() - 1, Aside::Second(second));
        }
    }
}
