//! Structs and interface blocks (GLSL ES 3.00 sections 4.1.8 and 4.3.7).

use super::qualifier::{LayoutQualifier, Qualified, StorageRequest};
use crate::checker::*;

/// An error in a struct or an interface block.
#[derive(Clone, Copy, Debug)]
pub enum RecordError {
    /// A struct or block without members.
    Empty(RecordKind),
    /// A struct that is declared inside another.
    Inside,
    /// A member of type `void`.
    VoidMember,
    /// A name of two members, and the token of the first.
    MemberTwice(Name, TokenId),
    /// A qualifier that is not allowed on a member.
    MemberQualifier(RecordKind),
    /// A sampler in a block.
    SamplerInBlock,
    /// A block in a version without them.
    BlockLater,
    /// A block of anything but uniforms.
    BlockStorage,
    /// A block that is `invariant`.
    BlockInvariant,
    /// A block with a location.
    BlockLocation,
    /// An array of blocks without a size.
    BlocksUnsized,
    /// A block used as a statement.
    BlockAlone,
}

/// Declarations with members.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RecordKind {
    Struct,
    Block,
}

/// Deepest nesting of structs that WebGL allows (WebGL 1.0 section 6.20).
const MAX_NESTING: u32 = 4;
/// Members of desktop GLSL's `gl_PerVertex`. Browsers accept these names in every struct, and in
/// every block that has a name.
const PER_VERTEX: [&str; 4] = [
    "gl_Position",
    "gl_PointSize",
    "gl_ClipDistance",
    "gl_CullDistance",
];
/// Most members of a struct or block, a limit of ANGLE.
const MAX_FIELDS: usize = 16_383;

/// The members of a struct or block, and what their types contain.
struct Members {
    fields: Vec<Field>,
    inside: Inside,
}

impl Checker<'_> {
    /// Declares a struct and returns its type.
    pub(in crate::checker) fn structure(&mut self, id: StructId) -> Type {
        let tree = self.tree;
        let Some(decl) = tree.structure(id) else {
            return Type::ERROR;
        };
        let members = self.members(decl, RecordKind::Struct);
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

    fn members(&mut self, decl: &StructDecl, record: RecordKind) -> Members {
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
            self.reject(decl.extent, RecordError::Empty(record));
        }
        for line in tree.fields(decl.fields) {
            self.member_qualifiers(line, record);
            if let TypeBase::Struct(_) = tree.ty(line.ty).base {
                self.reject(tree.ty(line.ty).extent, RecordError::Inside);
            }
            let base = self.type_spec(line.ty);
            let precision = self.has_precision(line.qualifiers);
            self.check_precision(base, precision, tree.ty(line.ty).extent);
            for declarator in tree.declarators(line.declarators) {
                let ty = self.member_type(declarator, base, line, record);
                self.add_member(&mut members, &mut seen, declarator.ident, ty);
            }
        }
        if members.fields.len() > MAX_FIELDS {
            self.reject(decl.extent, LimitError::Members);
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
            let problem = RecordError::MemberTwice(ident.name, before);
            self.reject(Extent::token(ident.token), problem);
        }
        seen.insert(ident.name, ident.token);
        let inside = self.inside(ty);
        // Reported once, not for every enclosing struct.
        if inside.nesting == MAX_NESTING && members.inside.nesting <= MAX_NESTING {
            self.reject(Extent::token(ident.token), LimitError::Nesting);
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
        record: RecordKind,
    ) -> Type {
        if base.is_void() {
            let at = Extent::token(declarator.ident.token);
            self.reject(at, RecordError::VoidMember);
            return Type::ERROR;
        }
        let mut ty = self.with_arrays(base, declarator.arrays, StorageRequest::None);
        if ty.array == Type::UNSIZED {
            self.reject(declarator.extent, ArrayError::NoSize);
            ty.array = 1;
        }
        if record == RecordKind::Block && self.inside(ty).sampler {
            self.reject(line.extent, RecordError::SamplerInBlock);
        }
        ty
    }

    /// Members of structs can only have a precision; those of blocks also `uniform` and a layout.
    fn member_qualifiers(&mut self, line: &FieldDecl, record: RecordKind) {
        let tree = self.tree;
        let mut precisions = 0;
        for qualifier in tree.qualifiers(line.qualifiers) {
            use QualifierKind as Q;
            let ok = match qualifier.kind {
                Q::Lowp | Q::Mediump | Q::Highp => {
                    precisions += 1;
                    precisions == 1
                }
                Q::Uniform => record == RecordKind::Block,
                Q::Layout(entries) if record == RecordKind::Block => {
                    let mut found = LayoutQualifier::default();
                    self.read_layout(entries, &mut found);
                    // The browser accepts a location here, and ignores it.
                    !found.block
                }
                _ => false,
            };
            if !ok {
                self.reject(qualifier.extent, RecordError::MemberQualifier(record));
            }
        }
    }

    /// `uniform Block { ... } name[2];`
    pub(in crate::checker) fn block(
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
        let header = Extent::new(extent.first, decl.name.map_or(extent.first, |n| n.token));
        if !self.has(Feature::Blocks) {
            // The members are declared all the same: their uses are not mistakes of their own.
            self.reject(header, RecordError::BlockLater);
        } else {
            let qualified = self.qualifiers(qualifiers);
            self.check_block(&qualified, decl, header);
        }
        let Members { fields, inside } = self.members(decl, RecordKind::Block);
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
        let mut ty = self.with_arrays(base, declarator.arrays, StorageRequest::Uniform);
        if ty.array == Type::UNSIZED {
            self.reject(declarator.extent, RecordError::BlocksUnsized);
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

    fn check_block(&mut self, qualified: &Qualified, decl: &StructDecl, header: Extent) {
        if let Some(ident) = decl.name {
            self.check_not_reserved(ident);
        }
        let problem = if qualified.storage != StorageRequest::Uniform {
            RecordError::BlockStorage
        } else if qualified.invariant {
            RecordError::BlockInvariant
        } else if qualified.layout.location.is_some() {
            RecordError::BlockLocation
        } else {
            return;
        };
        self.reject(header, problem);
    }
}
