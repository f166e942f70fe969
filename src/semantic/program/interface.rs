//! The interface of a stage: inputs, outputs, uniforms and blocks with the properties of their
//! declarations.

use super::static_use::named;
use crate::{Base, Program, Scalar, Stage, Storage, Type, VariableId};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::{self, *};
use shaderlint_text::{Role, Span};

/// A precision qualifier as text.
pub type PrecisionWord = &'static str;

/// A variable visible to the other stage or the page.
#[derive(Clone, Copy, Debug)]
pub struct InterfaceVariable {
    /// Declared name.
    pub name: Name,
    /// The token that declares it.
    pub token: TokenId,
    /// Declared type.
    pub ty: Type,
    /// Precision, explicit or by default; `None` if the type has none.
    pub precision: Option<PrecisionWord>,
    /// Whether it is declared `flat`.
    pub is_flat: bool,
    /// Whether it is declared `invariant`.
    pub is_invariant: bool,
    /// Value of `layout(location = ...)`.
    pub location: Option<i32>,
    /// Whether any code refers to it.
    pub is_used: bool,
    /// Whether code that the browser does not remove refers to it.
    pub is_active: bool,
}

/// A uniform block.
#[derive(Clone, Debug)]
pub struct Block {
    /// Block name.
    pub name: Name,
    /// The token that names it.
    pub token: TokenId,
    /// Index among the structs of its program.
    pub record: u16,
    /// Instance name token and array size, 0 for no array.
    pub instance: Option<(TokenId, u32)>,
    /// Whether matrices are row-major, from its own layout or the default.
    pub by_rows: bool,
    /// By member: whether its matrices are row-major.
    pub members_by_rows: Vec<bool>,
}

/// The interface of a stage.
pub struct Interface<'a> {
    /// The checked shader.
    pub program: &'a Program,
    /// Attributes of a vertex shader, or varyings of a fragment shader.
    pub inputs: Vec<InterfaceVariable>,
    /// Varyings of a vertex shader, or outputs of a fragment shader.
    pub outputs: Vec<InterfaceVariable>,
    /// Uniforms outside blocks.
    pub uniforms: Vec<InterfaceVariable>,
    /// Uniform blocks.
    pub blocks: Vec<Block>,
    /// Precision of members, by the member's token.
    members: FxHashMap<TokenId, PrecisionWord>,
    /// Names declared `invariant`, including built-in variables.
    invariant: FxHashSet<Name>,
    /// By variable: whether any code refers to it, and whether live code does.
    named: Vec<(bool, bool)>,
}

impl<'a> Interface<'a> {
    /// Reads the declarations of a shader without errors.
    pub fn of(program: &'a Program) -> Interface<'a> {
        let mut reader = Reader::new(program);
        for item in &program.tree.items {
            match *item {
                ast::Item::Function(id) => reader.function(id),
                ast::Item::Decl(id) => reader.declaration(id),
            }
        }
        let mut found = reader.found;
        // Declarations of a host count only if they are used.
        let is_user = |token: TokenId| {
            let span = program.token(token).map_or(Span::default(), |t| t.span);
            let file = program.sources.file_at(span.start);
            file.is_none_or(|f| f.role == Role::User)
        };
        for list in [&mut found.inputs, &mut found.outputs, &mut found.uniforms] {
            list.retain(|i| i.is_used || is_user(i.token));
        }
        for item in found.inputs.iter_mut().chain(&mut found.outputs) {
            item.is_invariant |= found.invariant.contains(&item.name);
        }
        let makes_all_invariant = program.tokens.invariant_all;
        for item in &mut found.outputs {
            item.is_invariant |= makes_all_invariant;
        }
        found
    }

    /// The text of a name.
    pub fn text(&self, name: Name) -> &'a str {
        self.program.names.text(name)
    }

    /// The precision of a struct or block member.
    pub fn member_precision(&self, token: TokenId) -> Option<PrecisionWord> {
        self.members.get(&token).copied()
    }

    /// Whether a built-in variable was declared `invariant`.
    pub fn is_invariant(&self, builtin: &str) -> bool {
        let name = self.program.names.get(builtin);
        name.is_some_and(|n| self.invariant.contains(&n))
            || (self.program.stage == Stage::Vertex && self.program.tokens.invariant_all)
    }

    /// The first token that refers to a built-in variable, if live code does.
    pub fn builtin_use(&self, builtin: &str) -> Option<TokenId> {
        let name = self.program.names.get(builtin)?;
        let is_it = |v: &crate::Variable| v.name == name && v.token.is_none();
        let id = self.program.variables.iter().position(is_it)?;
        self.named.get(id).filter(|(_, is_active)| *is_active)?;
        let mut all = self.program.tree.exprs.iter();
        let first = all.find(|e| matches!(e.kind, ExprKind::Name(n) if n == name))?;
        Some(first.extent.first)
    }

    /// Whether a token is in the host's prelude.
    pub fn is_hosts(&self, token: TokenId) -> bool {
        let start = self.program.token(token).map_or(0, |t| t.span.start);
        let file = self.program.sources.file_at(start);
        file.is_some_and(|f| f.role == Role::Prelude)
    }
}

/// Traversal of the declarations.
struct Reader<'a> {
    found: Interface<'a>,
    /// Variables by the token that declares them.
    variables: FxHashMap<TokenId, VariableId>,
    /// Structs by the token that names them.
    records: FxHashMap<TokenId, u16>,
    float: Option<PrecisionWord>,
    int: Option<PrecisionWord>,
    /// Default set by `layout(row_major) uniform;`.
    by_rows: bool,
}

impl<'a> Reader<'a> {
    fn new(program: &'a Program) -> Reader<'a> {
        let is_vertex = program.stage == Stage::Vertex;
        let declared = program.variables.iter().zip(0..);
        let records = program.structs.iter().zip(0..=u16::MAX);
        Reader {
            found: Interface {
                program,
                inputs: Vec::new(),
                outputs: Vec::new(),
                uniforms: Vec::new(),
                blocks: Vec::new(),
                members: FxHashMap::default(),
                invariant: FxHashSet::default(),
                named: named(program),
            },
            variables: declared
                .filter_map(|(v, i)| Some((v.token?, VariableId(i))))
                .collect(),
            records: records.map(|(r, i)| (r.token, i)).collect(),
            float: is_vertex.then_some("highp"),
            int: Some(if is_vertex { "highp" } else { "mediump" }),
            by_rows: false,
        }
    }

    fn function(&mut self, id: FunctionId) {
        let tree = &self.found.program.tree;
        if let Some(function) = tree.function(id) {
            self.type_spec(function.ty);
        }
    }

    fn declaration(&mut self, id: DeclId) {
        let tree = &self.found.program.tree;
        let Some(declaration) = tree.decl(id) else {
            return;
        };
        match declaration.kind {
            DeclKind::Error => {}
            DeclKind::Prototype(id) => self.function(id),
            DeclKind::Precision { precision, ty } => self.set_default(precision, ty),
            DeclKind::Qualifiers { qualifiers, ident } => match ident {
                Some(ident) => {
                    self.found.invariant.insert(ident.name);
                }
                None => self.by_rows = self.matrices_by_rows(qualifiers, self.by_rows),
            },
            DeclKind::Block {
                qualifiers,
                members,
                instance,
            } => self.block(qualifiers, members, instance),
            DeclKind::Variables {
                qualifiers,
                ty,
                declarators,
            } => {
                self.type_spec(ty);
                for declarator in tree.declarators(declarators) {
                    self.variable(qualifiers, declarator.ident);
                }
            }
        }
    }

    /// Reads the members of a struct defined in a type.
    fn type_spec(&mut self, ty: TypeId) {
        if let TypeBase::Struct(id) = self.found.program.tree.ty(ty).base {
            self.record(id);
        }
    }

    /// Reads the precisions of members; returns the index of the struct.
    fn record(&mut self, id: StructId) -> Option<u16> {
        let program = self.found.program;
        let tree = &program.tree;
        let decl = tree.structure(id)?;
        let token = decl.name.map_or(decl.extent.first, |n| n.token);
        let index = *self.records.get(&token)?;
        let fields = &program.structs.get(index as usize)?.fields;
        let lines = tree.fields(decl.fields).iter();
        let declared = lines.flat_map(|l| tree.declarators(l.declarators).iter().map(move |_| l));
        for (line, field) in declared.zip(fields) {
            if let Some(precision) = self.precision(line.qualifiers, field.ty) {
                self.found.members.insert(field.token, precision);
            }
        }
        Some(index)
    }

    fn set_default(&mut self, precision: QualifierKind, ty: TypeId) {
        let TypeBase::Word(word) = self.found.program.tree.ty(ty).base else {
            return;
        };
        let precision = word_of(precision);
        match Type::of_word(word).base {
            Base::Numeric {
                scalar: Scalar::Float,
                ..
            } => self.float = precision,
            Base::Numeric { .. } => self.int = precision,
            _ => {}
        }
    }

    /// The precision of a variable or member, explicit or by default.
    fn precision(&self, qualifiers: List, ty: Type) -> Option<PrecisionWord> {
        let default = match ty.base {
            Base::Numeric { scalar, .. } => match scalar {
                Scalar::Bool => return None,
                Scalar::Float => self.float,
                Scalar::Int | Scalar::Uint => self.int,
            },
            // The browser does not compare precisions of samplers.
            _ => return None,
        };
        let all = self.found.program.tree.qualifiers(qualifiers).iter();
        all.rev().find_map(|q| word_of(q.kind)).or(default)
    }

    fn variable(&mut self, qualifiers: List, ident: Ident) {
        let program = self.found.program;
        let Some(id) = self.variables.get(&ident.token) else {
            return;
        };
        let Some(variable) = program.variable(*id) else {
            return;
        };
        let all = program.tree.qualifiers(qualifiers);
        let has = |kind| all.iter().any(|q| q.kind == kind);
        let (is_used, is_active) = self
            .found
            .named
            .get(id.0 as usize)
            .copied()
            .unwrap_or_default();
        let item = InterfaceVariable {
            name: ident.name,
            token: ident.token,
            ty: variable.ty,
            precision: self.precision(qualifiers, variable.ty),
            is_flat: has(QualifierKind::Flat),
            is_invariant: has(QualifierKind::Invariant),
            location: location(&program.tree, all),
            is_used,
            is_active,
        };
        match variable.storage {
            Storage::Input => self.found.inputs.push(item),
            Storage::Output => self.found.outputs.push(item),
            Storage::Uniform => self.found.uniforms.push(item),
            _ => {}
        }
    }

    fn block(&mut self, qualifiers: List, members: StructId, instance: Option<Declarator>) {
        let program = self.found.program;
        let tree = &program.tree;
        let (Some(record), Some(decl)) = (self.record(members), tree.structure(members)) else {
            return;
        };
        let Some(name) = decl.name else { return };
        let by_rows = self.matrices_by_rows(qualifiers, self.by_rows);
        let lines = tree.fields(decl.fields).iter();
        let by_line = lines.flat_map(|line| {
            let of_line = self.matrices_by_rows(line.qualifiers, by_rows);
            tree.declarators(line.declarators)
                .iter()
                .map(move |_| of_line)
        });
        let size = |d: &Declarator| {
            let id = self.variables.get(&d.ident.token)?;
            Some(program.variable(*id)?.ty.array)
        };
        let block = Block {
            name: name.name,
            token: name.token,
            record,
            instance: instance.map(|d| (d.ident.token, size(&d).unwrap_or(0))),
            by_rows,
            members_by_rows: by_line.collect(),
        };
        self.found.blocks.push(block);
    }

    /// Whether these qualifiers, or else the default, make matrices row-major.
    fn matrices_by_rows(&self, qualifiers: List, before: bool) -> bool {
        let program = self.found.program;
        let mut by_rows = before;
        for qualifier in program.tree.qualifiers(qualifiers) {
            let QualifierKind::Layout(entries) = qualifier.kind else {
                continue;
            };
            for entry in program.tree.layout(entries) {
                match program.names.text(entry.ident.name) {
                    "row_major" => by_rows = true,
                    "column_major" => by_rows = false,
                    _ => {}
                }
            }
        }
        by_rows
    }
}

/// The location given by qualifiers.
pub fn location(tree: &Tree, qualifiers: &[Qualifier]) -> Option<i32> {
    let entries = qualifiers.iter().filter_map(|q| match q.kind {
        QualifierKind::Layout(entries) => Some(tree.layout(entries)),
        _ => None,
    });
    let mut locations = entries.flatten().filter_map(|e| e.value);
    locations.next_back().map(|v| v.value)
}

fn word_of(kind: QualifierKind) -> Option<PrecisionWord> {
    match kind {
        QualifierKind::Lowp => Some("lowp"),
        QualifierKind::Mediump => Some("mediump"),
        QualifierKind::Highp => Some("highp"),
        _ => None,
    }
}
