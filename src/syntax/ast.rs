//! The tree: syntax only, in flat vectors.
//!
//! Every node knows its first and last token; parentheses are nodes. Children are stored before
//! their parents, so the expressions of one statement, taken in the order of their numbers, are in
//! the order of evaluation, and nothing that walks or drops a tree needs to recurse.

use super::names::{Name, TypeWord};

/// Index of a token in [`Tokens`](super::Tokens).
pub type TokenId = u32;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);
    )*};
}

ids! {
    /// Index of an [`Expr`].
    ExprId;
    /// Index of a [`Stmt`].
    StmtId;
    /// Index of a [`Declaration`].
    DeclId;
    /// Index of a [`FunctionDecl`].
    FunctionId;
    /// Index of a [`TypeSpec`].
    TypeId;
    /// Index of a [`StructDecl`].
    StructId;
}

/// A run of entries in one of the tree's lists.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct List {
    /// First entry.
    pub start: u32,
    /// Number of entries.
    pub len: u32,
}

/// First and last token of a node.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Extent {
    /// First token.
    pub first: TokenId,
    /// Last token, which belongs to the node.
    pub last: TokenId,
}

impl Extent {
    /// The extent of one token.
    pub const fn token(token: TokenId) -> Extent {
        Extent {
            first: token,
            last: token,
        }
    }

    /// Whether `other` lies inside.
    pub fn contains(self, other: Extent) -> bool {
        self.first <= other.first && other.last <= self.last
    }

    /// The smallest extent that holds both.
    pub fn to(self, other: Extent) -> Extent {
        Extent {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }
}

/// An expression (GLSL ES 3.00 section 5).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Its tokens.
    pub extent: Extent,
}

// A shader has thousands of them.
const _: () = assert!(size_of::<Expr>() <= 28);
const _: () = assert!(size_of::<Stmt>() <= 36);

/// The kinds of expression.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ExprKind {
    /// Could not be read; already reported.
    Error,
    /// A variable.
    Name(Name),
    /// A literal.
    Int(i32),
    /// A literal.
    Uint(u32),
    /// A literal, kept as its bits.
    Float(f32),
    /// A literal.
    Bool(bool),
    /// `( e )`
    Paren(ExprId),
    /// `op e`
    Unary(UnaryOp, ExprId),
    /// `e op`
    Postfix(PostfixOp, ExprId),
    /// `l op r`; the operator is the token behind `l`.
    Binary(BinaryOp, ExprId, ExprId),
    /// `l op r`; `None` is the plain `=`. The operator is the token behind `l`.
    Assign(Option<BinaryOp>, ExprId, ExprId),
    /// `c ? a : b`
    Ternary(ExprId, ExprId, ExprId),
    /// `l , r`
    Comma(ExprId, ExprId),
    /// `name(args)`: a function or the constructor of a struct; arguments in
    /// [`Tree::expr_lists`]. The name is the first token.
    Call(Name, List),
    /// `type(args)`: the constructor of a type of the language or of an array.
    Construct(TypeId, List),
    /// `object.name(args)`. Only `length()` of an array exists.
    Method(ExprId, Name, List),
    /// `object.field`; the field is the last token.
    Member(ExprId, Name),
    /// `object[index]`
    Index(ExprId, ExprId),
}

/// Operators before an operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum UnaryOp {
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `!`
    Not,
    /// `~`
    BitNot,
    /// `++`
    Increment,
    /// `--`
    Decrement,
}

/// Operators behind an operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PostfixOp {
    /// `++`
    Increment,
    /// `--`
    Decrement,
}

/// Operators between two operands.
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum BinaryOp {
    Mul, Div, Rem, Add, Sub, ShiftLeft, ShiftRight, Less, Greater, LessEqual, GreaterEqual, Equal,
    NotEqual, BitAnd, BitXor, BitOr, And, Xor, Or,
}

impl UnaryOp {
    /// As it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            UnaryOp::Plus => "+",
            UnaryOp::Minus => "-",
            UnaryOp::Not => "!",
            UnaryOp::BitNot => "~",
            UnaryOp::Increment => "++",
            UnaryOp::Decrement => "--",
        }
    }

    /// Whether it writes to its operand.
    pub const fn assigns(self) -> bool {
        matches!(self, UnaryOp::Increment | UnaryOp::Decrement)
    }
}

impl PostfixOp {
    /// As it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            PostfixOp::Increment => "++",
            PostfixOp::Decrement => "--",
        }
    }
}

impl BinaryOp {
    /// As it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            BinaryOp::Mul => "*",
            BinaryOp::Div => "/",
            BinaryOp::Rem => "%",
            BinaryOp::Add => "+",
            BinaryOp::Sub => "-",
            BinaryOp::ShiftLeft => "<<",
            BinaryOp::ShiftRight => ">>",
            BinaryOp::Less => "<",
            BinaryOp::Greater => ">",
            BinaryOp::LessEqual => "<=",
            BinaryOp::GreaterEqual => ">=",
            BinaryOp::Equal => "==",
            BinaryOp::NotEqual => "!=",
            BinaryOp::BitAnd => "&",
            BinaryOp::BitXor => "^",
            BinaryOp::BitOr => "|",
            BinaryOp::And => "&&",
            BinaryOp::Xor => "^^",
            BinaryOp::Or => "||",
        }
    }

    /// Whether the result is a `bool` made from two numbers, or from any two equal types.
    pub const fn compares(self) -> bool {
        use BinaryOp::*;
        matches!(
            self,
            Less | Greater | LessEqual | GreaterEqual | Equal | NotEqual
        )
    }

    /// Whether it works on the bits of integers.
    pub const fn is_bitwise(self) -> bool {
        use BinaryOp::*;
        matches!(self, BitAnd | BitXor | BitOr | ShiftLeft | ShiftRight)
    }

    /// Whether it is `&&`, `||` or `^^`.
    pub const fn is_logical(self) -> bool {
        matches!(self, BinaryOp::And | BinaryOp::Or | BinaryOp::Xor)
    }
}

/// A statement (section 6).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stmt {
    /// What it is.
    pub kind: StmtKind,
    /// Its tokens.
    pub extent: Extent,
}

/// The kinds of statement. Bodies are statements too, blocks included.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StmtKind {
    /// Could not be read; already reported.
    Error,
    /// `;`
    Empty,
    /// `e;`
    Expr(ExprId),
    /// A declaration.
    Decl(DeclId),
    /// `{ ... }`; statements in [`Tree::stmt_lists`].
    Block(List),
    /// `if (condition) then else otherwise`
    If {
        /// The condition.
        condition: ExprId,
        /// Runs when it is true.
        then: StmtId,
        /// Runs when it is false.
        otherwise: Option<StmtId>,
    },
    /// `switch (selector) { ... }`
    Switch {
        /// What is compared.
        selector: ExprId,
        /// Statements and labels, in [`Tree::stmt_lists`].
        body: List,
    },
    /// `case e:`
    Case(ExprId),
    /// `default:`
    Default,
    /// `for (init; condition; step) body`
    For {
        /// An expression, a declaration or empty.
        init: StmtId,
        /// An expression or a declaration.
        condition: Option<StmtId>,
        /// Runs after each turn.
        step: Option<ExprId>,
        /// The body.
        body: StmtId,
    },
    /// `while (condition) body`
    While {
        /// An expression or a declaration.
        condition: StmtId,
        /// The body.
        body: StmtId,
    },
    /// `do body while (condition);`
    Do {
        /// The body.
        body: StmtId,
        /// The condition.
        condition: ExprId,
    },
    /// `break;`
    Break,
    /// `continue;`
    Continue,
    /// `return e;`
    Return(Option<ExprId>),
    /// `discard;`
    Discard,
}

/// A type as written: `vec3`, `S`, `struct { ... }`, each perhaps with `[size]`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TypeSpec {
    /// The type without array sizes.
    pub base: TypeBase,
    /// Sizes behind the type, in [`Tree::array_lists`].
    pub arrays: List,
    /// Its tokens.
    pub extent: Extent,
}

/// The type without array sizes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TypeBase {
    /// Could not be read; already reported.
    Error,
    /// `void`
    Void,
    /// A type of the language.
    Word(TypeWord),
    /// A name, which must be a struct's.
    Name(Name),
    /// A struct declared on the spot.
    Struct(StructId),
}

/// `[size]` or `[]`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArraySize {
    /// The size, unless left out.
    pub size: Option<ExprId>,
    /// From bracket to bracket.
    pub extent: Extent,
}

/// A struct declaration, or the members of an interface block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StructDecl {
    /// Its name, if it has one.
    pub name: Option<Ident>,
    /// Members in [`Tree::field_lists`].
    pub fields: List,
    /// Its tokens.
    pub extent: Extent,
}

/// One line of members: `qualifiers type a, b[2];`
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FieldDecl {
    /// Qualifiers, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Type of all.
    pub ty: TypeId,
    /// Names, in [`Tree::declarator_lists`]; none has an initializer.
    pub declarators: List,
    /// Its tokens.
    pub extent: Extent,
}

/// A name and its token.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Ident {
    /// The name.
    pub name: Name,
    /// Where it stands.
    pub token: TokenId,
}

/// One name of a declaration: `a`, `a[2]`, `a = e`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Declarator {
    /// The name.
    pub ident: Ident,
    /// Sizes behind the name, in [`Tree::array_lists`].
    pub arrays: List,
    /// The initializer.
    pub init: Option<ExprId>,
    /// Its tokens.
    pub extent: Extent,
}

/// A qualifier in front of a type, in the order written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Qualifier {
    /// What it is.
    pub kind: QualifierKind,
    /// Its tokens.
    pub extent: Extent,
}

/// The kinds of qualifier (section 4.3 to 4.7).
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum QualifierKind {
    Const, In, Out, Inout, Centroid, Uniform, Attribute, Varying,
    Flat, Smooth, Invariant, Lowp, Mediump, Highp,
    /// `layout(...)`; entries in [`Tree::layout_lists`].
    Layout(List),
}

/// One entry of `layout(...)`: `std140` or `location = 2`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LayoutEntry {
    /// Its name.
    pub ident: Ident,
    /// The number behind `=`.
    pub value: Option<LayoutValue>,
}

/// The number of a layout entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LayoutValue {
    /// The number.
    pub value: i32,
    /// Where it stands.
    pub token: TokenId,
}

/// A declaration, at global scope or as a statement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Declaration {
    /// What it is.
    pub kind: DeclKind,
    /// Its tokens, the semicolon included.
    pub extent: Extent,
}

/// The kinds of declaration.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum DeclKind {
    /// Could not be read; already reported.
    Error,
    /// `qualifiers type a, b = e;` with any number of names, none included.
    Variables {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// The type.
        ty: TypeId,
        /// Names, in [`Tree::declarator_lists`].
        declarators: List,
    },
    /// `float f(vec2 p);`
    Prototype(FunctionId),
    /// `precision highp float;`
    Precision {
        /// `lowp`, `mediump` or `highp`.
        precision: QualifierKind,
        /// The type.
        ty: TypeId,
    },
    /// `uniform Block { ... } instance[2];`
    Block {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// Name and members.
        members: StructId,
        /// Name behind the members.
        instance: Option<Declarator>,
    },
    /// `invariant a;` or `layout(std140) uniform;`
    Qualifiers {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// What is qualified; nothing for a default layout.
        ident: Option<Ident>,
    },
}

/// A function's header, and its body if it is a definition.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FunctionDecl {
    /// Qualifiers of the return type, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Return type.
    pub ty: TypeId,
    /// Its name.
    pub ident: Ident,
    /// Parameters, in [`Tree::param_lists`].
    pub params: List,
    /// The body, unless it is a prototype.
    pub body: Option<StmtId>,
    /// Its tokens up to the closing parenthesis.
    pub header: Extent,
    /// All its tokens.
    pub extent: Extent,
}

/// A parameter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Param {
    /// Qualifiers, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Its type.
    pub ty: TypeId,
    /// Its name.
    pub ident: Option<Ident>,
    /// Sizes behind the name, in [`Tree::array_lists`].
    pub arrays: List,
    /// Its tokens.
    pub extent: Extent,
}

/// What stands at global scope.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Item {
    /// A function with a body.
    Function(FunctionId),
    /// Anything else.
    Decl(DeclId),
}

/// A parsed shader.
#[derive(Default, Debug)]
pub struct Tree {
    /// All expressions, children before parents.
    pub exprs: Vec<Expr>,
    /// All statements, children before parents.
    pub stmts: Vec<Stmt>,
    /// All declarations.
    pub decls: Vec<Declaration>,
    /// All functions and prototypes.
    pub functions: Vec<FunctionDecl>,
    /// All types.
    pub types: Vec<TypeSpec>,
    /// All structs, and the members of all interface blocks.
    pub structs: Vec<StructDecl>,
    /// What stands at global scope, in order.
    pub items: Vec<Item>,
    /// Names whose declarations could not be read and were reported.
    pub lost: Vec<Name>,
    /// Arguments.
    pub expr_lists: Vec<ExprId>,
    /// Statements of blocks.
    pub stmt_lists: Vec<StmtId>,
    /// Array sizes.
    pub array_lists: Vec<ArraySize>,
    /// Members.
    pub field_lists: Vec<FieldDecl>,
    /// Declared names.
    pub declarator_lists: Vec<Declarator>,
    /// Qualifiers.
    pub qualifier_lists: Vec<Qualifier>,
    /// Layout entries.
    pub layout_lists: Vec<LayoutEntry>,
    /// Parameters.
    pub param_lists: Vec<Param>,
}

/// The entries of a list.
pub fn list<T>(all: &[T], list: List) -> &[T] {
    let start = list.start as usize;
    all.get(start..start + list.len as usize).unwrap_or(&[])
}

impl Tree {
    const NO_EXPR: Expr = Expr {
        kind: ExprKind::Error,
        extent: Extent { first: 0, last: 0 },
    };
    const NO_STMT: Stmt = Stmt {
        kind: StmtKind::Error,
        extent: Extent { first: 0, last: 0 },
    };
    const NO_TYPE: TypeSpec = TypeSpec {
        base: TypeBase::Error,
        arrays: List { start: 0, len: 0 },
        extent: Extent { first: 0, last: 0 },
    };

    /// An expression; one that could not be read where the number is not this tree's.
    pub fn expr(&self, id: ExprId) -> &Expr {
        self.exprs.get(id.0 as usize).unwrap_or(&Tree::NO_EXPR)
    }

    /// A statement; one that could not be read where the number is not this tree's.
    pub fn stmt(&self, id: StmtId) -> &Stmt {
        self.stmts.get(id.0 as usize).unwrap_or(&Tree::NO_STMT)
    }

    /// A type; one that could not be read where the number is not this tree's.
    pub fn ty(&self, id: TypeId) -> &TypeSpec {
        self.types.get(id.0 as usize).unwrap_or(&Tree::NO_TYPE)
    }

    /// A declaration, if the number is this tree's.
    pub fn decl(&self, id: DeclId) -> Option<&Declaration> {
        self.decls.get(id.0 as usize)
    }

    /// A function, if the number is this tree's.
    pub fn function(&self, id: FunctionId) -> Option<&FunctionDecl> {
        self.functions.get(id.0 as usize)
    }

    /// A struct, if the number is this tree's.
    pub fn structure(&self, id: StructId) -> Option<&StructDecl> {
        self.structs.get(id.0 as usize)
    }

    /// Arguments of a call.
    pub fn args(&self, args: List) -> &[ExprId] {
        list(&self.expr_lists, args)
    }

    /// Statements of a block.
    pub fn block(&self, body: List) -> &[StmtId] {
        list(&self.stmt_lists, body)
    }

    /// Array sizes.
    pub fn arrays(&self, arrays: List) -> &[ArraySize] {
        list(&self.array_lists, arrays)
    }

    /// Qualifiers.
    pub fn qualifiers(&self, qualifiers: List) -> &[Qualifier] {
        list(&self.qualifier_lists, qualifiers)
    }

    /// Declared names.
    pub fn declarators(&self, declarators: List) -> &[Declarator] {
        list(&self.declarator_lists, declarators)
    }

    /// Members.
    pub fn fields(&self, fields: List) -> &[FieldDecl] {
        list(&self.field_lists, fields)
    }

    /// Parameters.
    pub fn params(&self, params: List) -> &[Param] {
        list(&self.param_lists, params)
    }

    /// Layout entries.
    pub fn layout(&self, entries: List) -> &[LayoutEntry] {
        list(&self.layout_lists, entries)
    }

    /// The expression inside any parentheses.
    pub fn unparen(&self, mut id: ExprId) -> ExprId {
        while let ExprKind::Paren(inner) = self.expr(id).kind {
            id = inner;
        }
        id
    }
}
