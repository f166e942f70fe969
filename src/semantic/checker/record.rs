//! Structs and interface blocks (GLSL ES 3.00 sections 4.1.8 and 4.3.7).

use super::qualifier::Wanted;
use super::*;

/// Deepest nesting of structs that WebGL allows (WebGL 1.0 section 6.20).
const MAX_NESTING: u32 = 4;
/// The members of desktop GLSL's `gl_PerVertex`. Browsers take these names in every struct, and in
/// every block that has a name.
const PER_VERTEX: [&str; 4] = [
    "gl_Position",
    "gl_PointSize",
    "gl_ClipDistance",
    "gl_CullDistance",
];
/// Most members; a limit of ANGLE's.
const MAX_FIELDS: usize = 16_383;

/// Members at hand, with what their qualifiers were.
struct Members {
    fields: Vec<Field>,
    inside: Inside,
}

impl Checker<'_> {
    /// Declares a struct and gives its type.
    pub(super) fn structure(&mut self, id: StructId) -> Type {
        let tree = self.tree;
        let Some(decl) = tree.structure(id) else {
            return Type::ERROR;
        };
        let members = self.members(decl, false);
        if let Some(ident) = decl.name {
            self.check_not_reserved(ident);
        }
        let index = self.structs.len() as u32;
        let token = decl.name.map_or(decl.extent.first, |n| n.token);
        let Members { fields, inside } = members;
        let name = decl.name.map(|n| n.name);
        self.structs.push(Struct {
            name,
            token,
            fields,
            inside,
        });
        if let Some(ident) = decl.name
            && !self.is_redefinition(ident)
        {
            self.scopes.declare(ident.name, Binding::Struct(index));
        }
        Type::structure(index)
    }

    fn members(&mut self, decl: &StructDecl, is_block: bool) -> Members {
        let tree = self.tree;
        let mut members = Members {
            fields: Vec::new(),
            inside: Inside {
                nesting: 1,
                ..Inside::default()
            },
        };
        let mut seen: FxHashMap<Name, TokenId> = FxHashMap::default();
        if decl.fields.len == 0 {
            let rule = if is_block {
                error::INTERFACE_BLOCK
            } else {
                error::INVALID_STRUCT
            };
            let d = self.error(
                rule,
                decl.extent,
                "this has no members; it needs at least one",
            );
            self.report(d);
        }
        for line in tree.fields(decl.fields) {
            self.member_qualifiers(line, is_block);
            if let TypeBase::Struct(_) = tree.ty(line.ty).base {
                let d = self
                    .error(
                        error::INVALID_STRUCT,
                        tree.ty(line.ty).extent,
                        "a struct cannot be declared inside another",
                    )
                    .note("declare it before, and use its name here (section 4.1.8)");
                self.report(d);
            }
            let base = self.type_spec(line.ty);
            let precision = self.has_precision(line.qualifiers);
            self.check_precision(base, precision, tree.ty(line.ty).extent);
            for declarator in tree.declarators(line.declarators) {
                let ty = self.member_type(declarator, base, line, is_block);
                self.add_member(&mut members, &mut seen, declarator.ident, ty);
            }
        }
        if members.fields.len() > MAX_FIELDS {
            let d = self.error(
                error::BROWSER_LIMIT,
                decl.extent,
                "this has too many members",
            );
            self.report(d.note("the browser takes 16383"));
        }
        members
    }

    fn has_precision(&self, qualifiers: List) -> bool {
        use QualifierKind::*;
        self.tree
            .qualifiers(qualifiers)
            .iter()
            .any(|q| matches!(q.kind, Lowp | Mediump | Highp))
    }

    fn add_member(
        &mut self,
        members: &mut Members,
        seen: &mut FxHashMap<Name, TokenId>,
        ident: Ident,
        ty: Type,
    ) {
        if !PER_VERTEX.contains(&self.text(ident.name)) {
            self.check_not_reserved(ident);
        }
        if let Some(&before) = seen.get(&ident.name) {
            let message = format!("member `{}` is declared twice", self.text(ident.name));
            let d = self
                .error_at(error::INVALID_STRUCT, ident.token, message)
                .label(self.token_span(before), "first declared here");
            self.report(d);
        }
        seen.insert(ident.name, ident.token);
        let inside = self.inside(ty);
        // Told once, not of every struct around it.
        if inside.nesting == MAX_NESTING && members.inside.nesting <= MAX_NESTING {
            let d = self
                .error_at(
                    error::BROWSER_LIMIT,
                    ident.token,
                    "structs are nested too deeply",
                )
                .note("WebGL allows a depth of 4 (WebGL 1.0 section 6.20)");
            self.report(d);
        }
        members.inside.add(inside);
        members.fields.push(Field {
            name: ident.name,
            ty,
            token: ident.token,
        });
    }

    fn member_type(
        &mut self,
        declarator: &Declarator,
        base: Type,
        line: &FieldDecl,
        is_block: bool,
    ) -> Type {
        let name = Extent::token(declarator.ident.token);
        if base.is_void() {
            let d = self.error(error::VOID_VALUE, name, "a member cannot be `void`");
            self.report(d);
            return Type::ERROR;
        }
        let mut ty = self.with_arrays(base, declarator.arrays, Wanted::None);
        if ty.array == Type::UNSIZED {
            let d = self.error(
                error::INVALID_ARRAY,
                declarator.extent,
                "the array needs a size",
            );
            self.report(d);
            ty.array = 1;
        }
        if is_block && self.inside(ty).sampler {
            let d = self
                .error(
                    error::INTERFACE_BLOCK,
                    line.extent,
                    "a sampler cannot stand in a block",
                )
                .help("declare it outside, as a `uniform` of its own");
            self.report(d);
        }
        ty
    }

    /// Members of structs take only a precision; those of blocks `uniform` and a layout too.
    fn member_qualifiers(&mut self, line: &FieldDecl, is_block: bool) {
        let tree = self.tree;
        let mut precisions = 0;
        for qualifier in tree.qualifiers(line.qualifiers) {
            use QualifierKind as Q;
            let ok = match qualifier.kind {
                Q::Lowp | Q::Mediump | Q::Highp => {
                    precisions += 1;
                    precisions == 1
                }
                Q::Uniform => is_block,
                Q::Layout(entries) if is_block => {
                    let mut found = layout::Layout::default();
                    self.read_layout(entries, &mut found);
                    // The browser reads a location here, and forgets it.
                    !found.block
                }
                _ => false,
            };
            if !ok {
                let word = self.sources.text(self.span(qualifier.extent));
                let message = format!("a member cannot be `{word}`");
                let rule = if is_block {
                    error::INTERFACE_BLOCK
                } else {
                    error::INVALID_STRUCT
                };
                let d = self.error(rule, qualifier.extent, message);
                self.report(d);
            }
        }
    }

    /// `uniform Block { ... } name[2];`
    pub(super) fn block(
        &mut self,
        qualifiers: List,
        members: StructId,
        instance: Option<Declarator>,
        extent: Extent,
    ) {
        let tree = self.tree;
        let Some(decl) = tree.structure(members) else {
            return;
        };
        let header = Extent {
            first: extent.first,
            last: decl.name.map_or(extent.first, |n| n.token),
        };
        if !self.has(Feature::Blocks) {
            let d = self.error(error::NEEDS_WEBGL2, header, "blocks come with GLSL ES 3.00");
            return self.report(d);
        }
        let qualified = self.qualifiers(qualifiers);
        self.check_block(&qualified, decl, header);
        let Members { fields, inside } = self.members(decl, true);
        let index = self.structs.len() as u32;
        let token = decl.name.map_or(decl.extent.first, |n| n.token);
        let name = decl.name.map(|n| n.name);
        self.structs.push(Struct {
            name,
            token,
            fields: fields.clone(),
            inside,
        });
        if let Some(ident) = decl.name
            && !self.is_redefinition(ident)
        {
            self.scopes.declare(ident.name, Binding::Block(index));
        }
        match instance {
            Some(declarator) => self.block_instance(&declarator, index, decl.name, header),
            None => {
                self.check_size(Type::block(index), Storage::Uniform, decl.name, header);
                for field in fields {
                    let ident = Ident {
                        name: field.name,
                        token: field.token,
                    };
                    self.declare_variable(ident, field.ty, Storage::Uniform, false, Constant::NONE);
                }
            }
        }
    }

    fn block_instance(
        &mut self,
        declarator: &Declarator,
        index: u32,
        block: Option<Ident>,
        header: Extent,
    ) {
        let base = Type::block(index);
        let mut ty = self.with_arrays(base, declarator.arrays, Wanted::Uniform);
        if ty.array == Type::UNSIZED {
            let d = self.error(
                error::INTERFACE_BLOCK,
                declarator.extent,
                "an array of blocks needs a size",
            );
            self.report(d);
            ty.array = 1;
        }
        self.check_size(ty, Storage::Uniform, block, header);
        self.declare_variable(
            declarator.ident,
            ty,
            Storage::Uniform,
            false,
            Constant::NONE,
        );
    }

    fn check_block(&mut self, qualified: &qualifier::Qualified, decl: &StructDecl, header: Extent) {
        if let Some(ident) = decl.name {
            self.check_not_reserved(ident);
        }
        let message = if qualified.storage != Wanted::Uniform {
            "a block must be `uniform` in GLSL ES 3.00"
        } else if qualified.invariant {
            "a block cannot be `invariant`"
        } else if qualified.layout.location.is_some() {
            "a block has no location"
        } else {
            return;
        };
        let d = self.error(error::INTERFACE_BLOCK, header, message);
        self.report(d);
    }

    /// `layout(std140) uniform;`
    pub(super) fn default_layout(&mut self, qualifiers: List, extent: Extent) {
        let qualified = self.qualifiers(qualifiers);
        let message = if qualified.layout.is_empty() {
            "a declaration is missing behind these qualifiers"
        } else if qualified.storage != Wanted::Uniform {
            "a default layout can only be set for `uniform`"
        } else if qualified.layout.location.is_some() {
            "a location is for one variable only"
        } else if !self.has(Feature::Layouts) {
            "`layout` comes with GLSL ES 3.00"
        } else {
            return;
        };
        let d = self.error(error::INVALID_LAYOUT, extent, message);
        self.report(d);
    }

    /// `invariant gl_Position;`
    pub(super) fn requalify(&mut self, qualifiers: List, ident: Ident) {
        let qualified = self.qualifiers(qualifiers);
        let text = self.text(ident.name);
        // `uniform S;` for a struct declares nothing, as `S;` does.
        if let Some(Binding::Struct(id)) = self.scopes.get(ident.name)
            && !qualified.invariant
        {
            let ty = Type::structure(id);
            let extent = Extent::token(ident.token);
            self.check_type_of_variables(&qualified, ty, extent);
            return self.check_variable_layout(&qualified, extent);
        }
        if !qualified.invariant {
            // `uniform Foo;`: a declaration without a type or without a name.
            let message = format!("`{text}` stands where a type or a name is missing");
            let d = self.error_at(error::SYNTAX_ERROR, ident.token, message);
            return self.report(d);
        }
        let only = qualified.storage == Wanted::None && !qualified.precision;
        if !only {
            let d = self.error_at(
                error::INVALID_QUALIFIER,
                ident.token,
                "only `invariant` can be given afterwards",
            );
            self.report(d);
        }
        let Some(id) = self.find_variable(ident.name) else {
            let message = format!("nothing declares `{text}`");
            let d = self.error_at(error::UNDECLARED_NAME, ident.token, message);
            return self.report(d);
        };
        let Some(variable) = self.variables.get(id.0 as usize) else {
            return;
        };
        let may_input = variable.storage == Storage::Input
            && self.stage == Stage::Fragment
            && self.has(Feature::InvariantInputs)
            && text != "gl_FrontFacing";
        if variable.storage != Storage::Output && !may_input {
            let message = format!("`{text}` cannot be invariant");
            let d = self
                .error_at(error::INVALID_QUALIFIER, ident.token, message)
                .note("only outputs can be (section 4.6.1)");
            self.report(d);
        }
    }
}
