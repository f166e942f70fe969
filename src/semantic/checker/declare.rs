//! Declarations of variables, structs and interface blocks (GLSL ES 3.00 section 4).

use super::super::constant::Value;
use super::qualifier::{Qualified, Wanted};
use super::*;

impl<'a> Checker<'a> {
    pub(super) fn declaration(&mut self, id: DeclId) {
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
                let d = self.error(error::INVALID_ARRAY, extent, "the array needs a size");
                self.report(d);
            }
            return;
        }
        for (i, declarator) in tree.declarators(declarators).iter().enumerate() {
            if i > 0 && qualified.layout.location.is_some() {
                let d = self.error_at(
                    error::INVALID_LAYOUT,
                    declarator.ident.token,
                    "a location is for one variable only",
                );
                self.report(d);
            }
            let index = declarators.start as usize + i;
            let spec = (declarators.len == 1).then_some(extent);
            self.declarator(index, declarator, &qualified, base, spec);
        }
    }

    /// What can be said of the type before the names come.
    pub(super) fn check_type_of_variables(
        &mut self,
        qualified: &Qualified,
        base: Type,
        extent: Extent,
    ) {
        self.check_precision(base, qualified.precision, extent);
        self.check_invariant(qualified, extent);
        self.check_interpolation(qualified, extent);
        let varying = matches!(
            qualified.storage,
            Wanted::FlatIn
                | Wanted::FlatOut
                | Wanted::SmoothIn
                | Wanted::SmoothOut
                | Wanted::CentroidIn
                | Wanted::CentroidOut
                | Wanted::In
                | Wanted::Out
        );
        if self.has(Feature::InOut) && varying {
            self.check_interface_type(qualified.storage, base, extent);
        }
        if !self.has(Feature::InOut) {
            if base.is_array() {
                let d = self
                    .error(
                        error::NEEDS_WEBGL2,
                        extent,
                        "an array size cannot stand behind the type here",
                    )
                    .help("in GLSL ES 1.00 write it behind the name: `float a[2]`");
                self.report(d);
            }
            let is_interface = matches!(qualified.storage, Wanted::Attribute | Wanted::Varying);
            let scalar = match base.base {
                Base::Numeric { scalar, .. } => Some(scalar),
                _ => None,
            };
            if is_interface && matches!(scalar, Some(Scalar::Bool | Scalar::Int)) {
                let message = format!(
                    "`{}` cannot be `{}`",
                    qualified.storage.name(),
                    self.name_of(base)
                );
                let d = self.error(error::INTERFACE_TYPE, extent, message);
                self.report(d);
            }
        }
    }

    /// `flat`, `smooth` and `centroid` need the `in` or `out` that they speak of. In a function they
    /// were reported where they stand.
    fn check_interpolation(&mut self, qualified: &Qualified, extent: Extent) {
        let alone = matches!(
            qualified.storage,
            Wanted::Flat | Wanted::Smooth | Wanted::Centroid
        );
        if alone && self.at_global_scope() {
            let word = qualified.storage.name();
            let extent = qualified.extent.unwrap_or(extent);
            let message = format!("`{word}` needs `in` or `out` behind it");
            let d = self
                .error(error::INVALID_QUALIFIER, extent, message)
                .note("only what passes between stages is interpolated (section 4.3.9)");
            self.report(d);
        }
    }

    fn check_invariant(&mut self, qualified: &Qualified, extent: Extent) {
        if !qualified.invariant {
            return;
        }
        if qualified.storage != Wanted::Varying && !qualified.storage.is_output() {
            let d = self
                .error(
                    error::INVALID_QUALIFIER,
                    qualified.extent.unwrap_or(extent),
                    "this cannot be `invariant`",
                )
                .note("only outputs can be invariant (section 4.6.1)");
            self.report(d);
        }
    }

    /// Inputs and outputs of a stage, by sections 4.3.4 and 4.3.6.
    fn check_interface_type(&mut self, storage: Wanted, ty: Type, extent: Extent) {
        let word = storage.name();
        let scalar = match ty.base {
            Base::Numeric { scalar, .. } => Some(scalar),
            _ => None,
        };
        let vertex_in = self.stage == Stage::Vertex && storage == Wanted::In;
        let fragment_out = self.stage == Stage::Fragment && storage == Wanted::Out;
        let message = if scalar == Some(Scalar::Bool) {
            format!("`{word}` cannot be `bool`")
        } else if vertex_in {
            if !ty.is_array() {
                return;
            }
            "an input of a vertex shader cannot be an array".to_string()
        } else if fragment_out {
            if !ty.element().is_matrix() {
                return;
            }
            "an output of a fragment shader cannot be a matrix".to_string()
        } else if self.inside(ty).integer && !matches!(storage, Wanted::FlatIn | Wanted::FlatOut) {
            format!("an integer that is passed between stages must be `flat {word}`")
        } else if let Some(message) = self.bad_interface_struct(ty) {
            message.to_string()
        } else {
            return;
        };
        let d = self.error(error::INTERFACE_TYPE, extent, message);
        self.report(d);
    }

    /// What lies inside a type.
    pub(super) fn inside(&self, ty: Type) -> Inside {
        self.types().inside(ty)
    }

    fn bad_interface_struct(&self, ty: Type) -> Option<&'static str> {
        let Base::Struct(id) = ty.base else {
            return None;
        };
        let fields = &self.structs.get(id as usize)?.fields;
        let is_bool = |b: Base| {
            matches!(
                b,
                Base::Numeric {
                    scalar: Scalar::Bool,
                    ..
                }
            )
        };
        Some(if ty.is_array() {
            "an array of structs cannot be passed between stages"
        } else if fields.iter().any(|f| f.ty.is_array()) {
            "a struct that holds an array cannot be passed between stages"
        } else if fields.iter().any(|f| matches!(f.ty.base, Base::Struct(_))) {
            "a struct that holds a struct cannot be passed between stages"
        } else if fields.iter().any(|f| is_bool(f.ty.base)) {
            "a struct that holds a `bool` cannot be passed between stages"
        } else {
            return None;
        })
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
        let ok = self.check_qualified_type(qualified, base, name);
        let mut ty = self.with_arrays(base, declarator.arrays, qualified.storage);
        let mut initial = None;
        if let Some(init) = declarator.init {
            self.wanted = Some(ty);
            self.eval(init);
            self.wanted = None;
            initial = Some(self.info(init));
            if ty.array == Type::UNSIZED {
                let found = self.ty(init);
                ty.array = if found.is_array() { found.array } else { 1 };
            }
        } else if ty.array == Type::UNSIZED {
            let d = self
                .error(
                    error::INVALID_ARRAY,
                    declarator.extent,
                    "the array needs a size",
                )
                .note("only an initializer can give it one: `float a[] = float[](1.0, 2.0);`");
            self.report(d);
            ty.array = 1;
        }
        if !ok {
            ty = Type::ERROR;
        }
        let mut is_const = qualified.storage == Wanted::Const;
        let mut constant = Constant::NONE;
        if is_const && declarator.init.is_none() {
            let message = format!(
                "the constant `{}` has no value",
                self.text(declarator.ident.name)
            );
            let d = self.error(error::NOT_CONSTANT, declarator.extent, message);
            self.report(d);
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
                false => ty = self.settled_type(index, spec, declarator, ty),
            }
            is_const &= info.is_const;
        }
        let storage = self.storage_of(qualified.storage);
        self.check_size(ty, storage, Some(declarator.ident), declarator.extent);
        let before = self.scopes.get_here(declarator.ident.name);
        let id = self.declare_variable(declarator.ident, ty, storage, is_const, constant);
        if let (None, Some(Binding::Variable(first))) = (id, before) {
            let is_meant = self.means_second(index, first, ty);
            self.mend_redefinition(declarator.ident, first, ty, spec, is_meant);
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
        self.note_output(declarator, qualified, ty);
        self.check_declared_depth(declarator);
    }

    /// What the type must not be for these qualifiers; false where it is.
    fn check_qualified_type(&mut self, qualified: &Qualified, base: Type, name: Extent) -> bool {
        if base.is_error() {
            return false;
        }
        if base.is_void() {
            let d = self.error(error::VOID_VALUE, name, "a variable cannot be `void`");
            self.report(d);
            return false;
        }
        let is_struct = matches!(base.base, Base::Struct(_));
        let vertex_in = self.stage == Stage::Vertex && qualified.storage == Wanted::In;
        let fragment_out = self.stage == Stage::Fragment && qualified.storage == Wanted::Out;
        let interface = vertex_in
            || fragment_out
            || matches!(qualified.storage, Wanted::Attribute | Wanted::Varying);
        if is_struct && interface {
            let message = format!("`{}` cannot be a struct", qualified.storage.name());
            let d = self.error(error::INTERFACE_TYPE, name, message);
            self.report(d);
            return false;
        }
        let holds_sampler = self.inside(base).sampler;
        if holds_sampler && qualified.storage != Wanted::Uniform {
            let d = self
                .error(
                    error::SAMPLER_RESTRICTION,
                    name,
                    "a sampler must be a `uniform` or a parameter",
                )
                .note("samplers cannot be copied into variables (section 4.1.7)");
            self.report(d);
            return false;
        }
        true
    }

    fn storage_of(&self, wanted: Wanted) -> Storage {
        match wanted {
            Wanted::Uniform => Storage::Uniform,
            Wanted::Attribute => Storage::Input,
            Wanted::Varying if self.stage == Stage::Vertex => Storage::Output,
            Wanted::Varying => Storage::Input,
            wanted if wanted.is_input() => Storage::Input,
            wanted if wanted.is_output() => Storage::Output,
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
        self.check_not_reserved(ident);
        if self.is_redefinition(ident) {
            return None;
        }
        Some(self.bind_variable(ident, ty, storage, is_const, constant))
    }

    /// Gives a name the meaning of a new variable.
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

    /// The type of `iChannel0` to `iChannel3` where it was chosen from outside.
    fn channel_type(&self, name: Name, ty: Type) -> Type {
        let channel = match self.text(name) {
            "iChannel0" => 0,
            "iChannel1" => 1,
            "iChannel2" => 2,
            "iChannel3" => 3,
            _ => return ty,
        };
        self.channels
            .get(channel)
            .copied()
            .flatten()
            .map_or(ty, Type::sampler)
    }

    /// Reports a name that the innermost scope has already.
    pub(super) fn is_redefinition(&mut self, ident: Ident) -> bool {
        let Some(before) = self.scopes.get_here(ident.name) else {
            return false;
        };
        if before == Binding::Error {
            return true;
        }
        let text = self.text(ident.name);
        let token = self.declaration_token(ident.name, before);
        let message = format!("`{text}` is declared twice in one scope");
        let d = self.error_at(error::REDEFINITION, ident.token, message);
        let d = self.with_declaration(d, token, "first declared here");
        self.report(d);
        true
    }

    /// The token that declares what a name stands for.
    pub(in crate::semantic) fn declaration_token(
        &self,
        name: Name,
        binding: Binding,
    ) -> Option<TokenId> {
        match binding {
            Binding::Variable(id) => self.variables.get(id.0 as usize)?.token,
            Binding::Struct(id) | Binding::Block(id) => {
                self.structs.get(id as usize).map(|s| s.token)
            }
            Binding::Function => {
                let first = self.by_name.get(&name)?.first()?;
                let function = self.functions.get(first.0 as usize)?;
                self.tree
                    .function(function.declaration)
                    .map(|f| f.ident.token)
            }
            Binding::Error => None,
        }
    }

    /// The type that a type in the text means. Declares the struct that it may hold.
    pub(super) fn type_spec(&mut self, id: TypeId) -> Type {
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
        self.with_arrays(base, spec.arrays, Wanted::None)
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

    /// The type with array sizes behind it. `storage` is that of the declaration, where one is.
    pub(super) fn with_arrays(&mut self, base: Type, arrays: List, storage: Wanted) -> Type {
        let tree = self.tree;
        let sizes = tree.arrays(arrays);
        let Some(first) = sizes.first() else {
            return base;
        };
        let mut ty = base;
        for size in sizes {
            let Some(len) = self.array_size(size) else {
                return Type::ERROR;
            };
            if ty.is_array() {
                let d = self
                    .error(
                        error::INVALID_ARRAY,
                        size.extent,
                        "GLSL ES 3.00 has no arrays of arrays",
                    )
                    .note("they come with GLSL ES 3.10, which WebGL2 does not have")
                    .help("use one array, and compute the index: `a[i * 4 + j]`");
                self.report(d);
                return Type::ERROR;
            }
            if !ty.is_error() {
                ty.array = len;
            }
        }
        self.check_array_qualifier(base, storage, first.extent);
        ty
    }

    fn check_array_qualifier(&mut self, base: Type, storage: Wanted, extent: Extent) {
        let vertex_in = self.stage == Stage::Vertex && storage == Wanted::In;
        let varying = !vertex_in && (storage.is_input() || storage.is_output());
        let message = match storage {
            Wanted::Attribute => "an attribute cannot be an array",
            Wanted::Const if !self.has(Feature::ArrayValues) => {
                "GLSL ES 1.00 has no constant arrays"
            }
            _ if vertex_in => "an input of a vertex shader cannot be an array",
            _ if varying && matches!(base.base, Base::Struct(_)) => {
                "an array of structs cannot be passed between stages"
            }
            _ => return,
        };
        let d = self.error(error::INVALID_ARRAY, extent, message);
        self.report(d);
    }

    /// The size that one pair of brackets gives; `None` where it hangs on something unknown.
    fn array_size(&mut self, size: &ArraySize) -> Option<u32> {
        let Some(expr) = size.size else {
            if !self.has(Feature::ArrayValues) {
                let d = self.error(error::NEEDS_WEBGL2, size.extent, "the array needs a size");
                self.report(d.note("GLSL ES 1.00 takes none from an initializer"));
            }
            return Some(Type::UNSIZED);
        };
        self.eval(expr);
        let info = self.info(expr);
        if info.ty.is_error() {
            return None;
        }
        let value = self.pool.scalar(info.constant);
        let (rule, message) = match value {
            _ if !matches!(info.ty, Type::INT | Type::UINT) => {
                let name = self.name_of(info.ty);
                (
                    error::INVALID_ARRAY,
                    format!("an array's size must be an integer, not `{name}`"),
                )
            }
            _ if !info.is_const => (
                error::NOT_CONSTANT,
                "an array's size must be a constant expression".to_string(),
            ),
            Some(Value::Int(v)) if v < 0 => (
                error::INVALID_ARRAY,
                "an array's size cannot be negative".to_string(),
            ),
            Some(v) if v.as_uint() == 0 => (
                error::INVALID_ARRAY,
                "an array's size cannot be 0".to_string(),
            ),
            Some(v) => return Some(v.as_uint().min(Type::UNSIZED - 1)),
            None => return Some(1),
        };
        let mut d = self.error_expr(rule, expr, message);
        if rule == error::NOT_CONSTANT {
            d = self.explain_not_constant(d, expr);
        }
        self.report(d);
        Some(1)
    }

    /// Adds a fix to the error about a name that is declared a second time.
    fn mend_redefinition(
        &mut self,
        ident: Ident,
        first: VariableId,
        ty: Type,
        spec: Option<Extent>,
        is_meant: bool,
    ) {
        let span = self.token_span(ident.token);
        let is_it = |d: &Diagnostic| d.rule == error::REDEFINITION && d.span == span;
        if self.diagnostics.last().is_some_and(is_it) {
            let fix = self.second_declaration(ident, first, ty, spec, is_meant);
            if let Some(d) = self.diagnostics.last_mut() {
                d.fix = fix;
            }
        }
    }
}
