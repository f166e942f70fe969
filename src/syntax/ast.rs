//! The syntax tree, stored in flat vectors.
//!
//! Every node records its first and last token; parentheses are nodes. Children are stored before
//! their parents, so iterating over the expressions of a statement by index follows evaluation
//! order, and walking or dropping a tree needs no recursion.

use super::names::{Name, TypeWord};
use super::token::TokenKind;

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

/// A range of entries in one of the tree's lists.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct List {
    /// Index of the first entry.
    pub start: u32,
    /// Number of entries.
    pub len: u32,
}

/// First and last token of a node, both inclusive.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Extent {
    /// Index of the first token.
    pub first: TokenId,
    /// Index of the last token, inclusive.
    pub last: TokenId,
}

impl Extent {
    /// The extent of a single token.
    pub const fn token(token: TokenId) -> Extent {
        Extent::new(token, token)
    }

    /// From one token to another, inclusive.
    pub const fn new(first: TokenId, last: TokenId) -> Extent {
        Extent { first, last }
    }

    /// Whether `other` is inside this extent.
    pub fn contains(self, other: Extent) -> bool {
        self.first <= other.first && other.last <= self.last
    }

    /// The smallest extent that contains both.
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
    /// Variant and operands of the expression.
    pub kind: ExprKind,
    /// Token range of the expression.
    pub extent: Extent,
}

// Size limits: a shader has thousands of these nodes.
const _: () = assert!(size_of::<Expr>() <= 28);
const _: () = assert!(size_of::<Stmt>() <= 36);

/// Kinds of expressions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ExprKind {
    /// Could not be parsed; an error has been reported.
    Error,
    /// Name of a variable.
    Name(Name),
    /// Integer literal, e.g. `1`.
    Int(i32),
    /// Unsigned literal, e.g. `1u`.
    Uint(u32),
    /// Floating-point literal.
    Float(f32),
    /// `true` or `false`.
    Bool(bool),
    /// `( e )`
    Paren(ExprId),
    /// `op e`
    Unary(UnaryOp, ExprId),
    /// `e op`
    Postfix(PostfixOp, ExprId),
    /// `l op r`; the operator is the token after `l`.
    Binary(BinaryOp, ExprId, ExprId),
    /// `l op r`; `None` stands for plain `=`. The operator is the token after `l`.
    Assign(Option<BinaryOp>, ExprId, ExprId),
    /// `c ? a : b`
    Ternary(ExprId, ExprId, ExprId),
    /// `l , r`
    Comma(ExprId, ExprId),
    /// `name(args)`: a call of a function or of a struct constructor, with the arguments in
    /// [`Tree::expr_lists`]. The name is the first token.
    Call(Name, List),
    /// `type(args)`: the constructor of a built-in type or of an array.
    Construct(TypeId, List),
    /// `object.name(args)`; GLSL has only `length()` of arrays.
    Method(ExprId, Name, List),
    /// `object.field`; the field is the last token.
    Member(ExprId, Name),
    /// `object[index]`
    Index(ExprId, ExprId),
}

/// Prefix operators.
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

/// Postfix operators.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PostfixOp {
    /// `++`
    Increment,
    /// `--`
    Decrement,
}

macro_rules! binary_operators {
    ($($variant:ident $token:ident $symbol:literal $precedence:literal,)*) => {
        /// Binary operators.
        #[expect(missing_docs, reason = "the variants are standard terms")]
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        pub enum BinaryOp { $($variant),* }

        impl BinaryOp {
            /// All binary operators.
            pub const ALL: &[BinaryOp] = &[$(BinaryOp::$variant),*];

            /// The operator in source form.
            pub const fn symbol(self) -> &'static str {
                match self { $(BinaryOp::$variant => $symbol,)* }
            }

            /// The binary operator that a token is.
            pub const fn of(kind: TokenKind) -> Option<BinaryOp> {
                match kind {
                    $(TokenKind::$token => Some(BinaryOp::$variant),)*
                    _ => None,
                }
            }

            /// How tightly the operator binds, from 4; a higher number binds more tightly (GLSL ES
            /// 3.00 section 5.1). Comma, assignment and `? :` bind less.
            pub const fn precedence(self) -> u8 {
                match self { $(BinaryOp::$variant => $precedence,)* }
            }
        }
    };
}

binary_operators! {
    Mul Star "*" 14,
    Div Slash "/" 14,
    Rem Percent "%" 14,
    Add Plus "+" 13,
    Sub Minus "-" 13,
    ShiftLeft ShiftLeft "<<" 12,
    ShiftRight ShiftRight ">>" 12,
    Less Less "<" 11,
    Greater Greater ">" 11,
    LessEqual LessEqual "<=" 11,
    GreaterEqual GreaterEqual ">=" 11,
    Equal EqualEqual "==" 10,
    NotEqual NotEqual "!=" 10,
    BitAnd And "&" 9,
    BitXor Xor "^" 8,
    BitOr Or "|" 7,
    And AndAnd "&&" 6,
    Xor XorXor "^^" 5,
    Or OrOr "||" 4,
}

impl UnaryOp {
    /// The operator in source form.
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

    /// Whether the operator modifies its operand.
    pub const fn assigns(self) -> bool {
        matches!(self, UnaryOp::Increment | UnaryOp::Decrement)
    }
}

impl PostfixOp {
    /// The operator in source form.
    pub const fn symbol(self) -> &'static str {
        match self {
            PostfixOp::Increment => "++",
            PostfixOp::Decrement => "--",
        }
    }
}

impl BinaryOp {
    /// Whether this is a relational or equality operator, with a `bool` result.
    pub const fn compares(self) -> bool {
        use BinaryOp::*;
        matches!(
            self,
            Less | Greater | LessEqual | GreaterEqual | Equal | NotEqual
        )
    }

    /// Whether the operator works on the bits of integers.
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
    /// Variant and children of the statement.
    pub kind: StmtKind,
    /// Token range of the statement.
    pub extent: Extent,
}

/// Kinds of statements. Bodies are statements too, including blocks.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StmtKind {
    /// Could not be parsed; an error has been reported.
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
        /// Controlling expression.
        condition: ExprId,
        /// Executed if the condition is true.
        then: StmtId,
        /// Executed if the condition is false.
        otherwise: Option<StmtId>,
    },
    /// `switch (selector) { ... }`
    Switch {
        /// Value compared with the `case` labels.
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
        /// An expression, a declaration or an empty statement.
        init: StmtId,
        /// An expression or a declaration; `None` means always true.
        condition: Option<StmtId>,
        /// Executed after each iteration.
        step: Option<ExprId>,
        /// Executed while the condition holds.
        body: StmtId,
    },
    /// `while (condition) body`
    While {
        /// An expression or a declaration.
        condition: StmtId,
        /// Executed while the condition holds.
        body: StmtId,
    },
    /// `do body while (condition);`
    Do {
        /// Executed once, then while the condition holds.
        body: StmtId,
        /// Tested after each iteration.
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

impl StmtKind {
    /// Whether it is a loop.
    pub const fn is_loop(&self) -> bool {
        matches!(
            self,
            StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
        )
    }
}

/// A type as written: `vec3`, `S`, `struct { ... }`, each optionally with `[size]`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TypeSpec {
    /// The type without array sizes.
    pub base: TypeBase,
    /// Array sizes after the type, in [`Tree::array_lists`].
    pub arrays: List,
    /// Token range of the type and its array sizes.
    pub extent: Extent,
}

/// A type without array sizes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TypeBase {
    /// Could not be parsed; an error has been reported.
    Error,
    /// `void`
    Void,
    /// A built-in type.
    Word(TypeWord),
    /// A name that must refer to a struct.
    Name(Name),
    /// A struct declared in place.
    Struct(StructId),
}

/// `[size]` or `[]`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArraySize {
    /// The size; `None` for `[]`.
    pub size: Option<ExprId>,
    /// Token range including both brackets.
    pub extent: Extent,
}

/// A struct declaration, or the members of an interface block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StructDecl {
    /// Name of the struct or block; `None` for an anonymous struct.
    pub name: Option<Ident>,
    /// Members in [`Tree::field_lists`].
    pub fields: List,
    /// Token range from `struct` or the block name to the closing brace.
    pub extent: Extent,
}

/// One line of members: `qualifiers type a, b[2];`
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FieldDecl {
    /// Qualifiers, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Type shared by all declarators.
    pub ty: TypeId,
    /// Member names, in [`Tree::declarator_lists`]; none has an initializer.
    pub declarators: List,
    /// Token range including the semicolon.
    pub extent: Extent,
}

/// A name and its token.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Ident {
    /// Interned name.
    pub name: Name,
    /// Index of the name's token.
    pub token: TokenId,
}

/// One declarator of a declaration: `a`, `a[2]`, `a = e`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Declarator {
    /// Declared name.
    pub ident: Ident,
    /// Array sizes after the name, in [`Tree::array_lists`].
    pub arrays: List,
    /// Expression after `=`.
    pub init: Option<ExprId>,
    /// Token range of the declarator.
    pub extent: Extent,
}

/// A qualifier before a type, in source order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Qualifier {
    /// Variant of the qualifier.
    pub kind: QualifierKind,
    /// Token range of the qualifier.
    pub extent: Extent,
}

/// Kinds of qualifiers (sections 4.3 to 4.7).
#[expect(missing_docs, reason = "the variants are standard terms")]
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
    /// Name of the layout qualifier.
    pub ident: Ident,
    /// The integer after `=`.
    pub value: Option<LayoutValue>,
}

/// The integer of a layout entry and its token.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LayoutValue {
    /// Value as written, e.g. the location.
    pub value: i32,
    /// Index of the integer's token.
    pub token: TokenId,
}

/// A declaration, at global scope or as a statement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Declaration {
    /// Variant of the declaration.
    pub kind: DeclKind,
    /// Token range including the semicolon.
    pub extent: Extent,
}

/// Kinds of declarations.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum DeclKind {
    /// Could not be parsed; an error has been reported.
    Error,
    /// `qualifiers type a, b = e;` with any number of declarators, including none.
    Variables {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// Type shared by all declarators.
        ty: TypeId,
        /// Declarators, in [`Tree::declarator_lists`].
        declarators: List,
    },
    /// `float f(vec2 p);`
    Prototype(FunctionId),
    /// `precision highp float;`
    Precision {
        /// `lowp`, `mediump` or `highp`.
        precision: QualifierKind,
        /// Type that the precision applies to.
        ty: TypeId,
    },
    /// `uniform Block { ... } instance[2];`
    Block {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// Name and members of the block.
        members: StructId,
        /// Instance name after the members.
        instance: Option<Declarator>,
    },
    /// `invariant a;` or `layout(std140) uniform;`
    Qualifiers {
        /// Qualifiers, in [`Tree::qualifier_lists`].
        qualifiers: List,
        /// Qualified name; `None` for a default layout.
        ident: Option<Ident>,
    },
}

/// Header of a function, with its body if this is a definition.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FunctionDecl {
    /// Qualifiers of the return type, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Return type.
    pub ty: TypeId,
    /// Name of the function.
    pub ident: Ident,
    /// Parameters, in [`Tree::param_lists`].
    pub params: List,
    /// Body of a definition; `None` for a prototype.
    pub body: Option<StmtId>,
    /// Token range up to the closing parenthesis.
    pub header: Extent,
    /// Token range of the whole function.
    pub extent: Extent,
}

/// A parameter of a function.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Param {
    /// Qualifiers, in [`Tree::qualifier_lists`].
    pub qualifiers: List,
    /// Type of the parameter, without array sizes after the name.
    pub ty: TypeId,
    /// Parameter name; `None` if it is unnamed.
    pub ident: Option<Ident>,
    /// Array sizes after the name, in [`Tree::array_lists`].
    pub arrays: List,
    /// Token range of the parameter.
    pub extent: Extent,
}

/// A declaration at global scope.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Item {
    /// A function definition.
    Function(FunctionId),
    /// Any other declaration.
    Decl(DeclId),
}

/// A parsed shader.
#[derive(Default, Debug)]
pub struct Tree {
    /// All expressions, children before parents.
    pub exprs: Vec<Expr>,
    /// All statements, children before parents.
    pub stmts: Vec<Stmt>,
    /// All declarations, global and local.
    pub decls: Vec<Declaration>,
    /// All function definitions and prototypes.
    pub functions: Vec<FunctionDecl>,
    /// All type specifiers.
    pub types: Vec<TypeSpec>,
    /// All structs, and the member lists of all interface blocks.
    pub structs: Vec<StructDecl>,
    /// Items at global scope, in source order.
    pub items: Vec<Item>,
    /// Names whose declarations could not be parsed; errors have been reported.
    pub lost: Vec<Name>,
    /// Argument lists of calls.
    pub expr_lists: Vec<ExprId>,
    /// Statement lists of blocks.
    pub stmt_lists: Vec<StmtId>,
    /// Array sizes of types and declarators.
    pub array_lists: Vec<ArraySize>,
    /// Member declarations of structs and blocks.
    pub field_lists: Vec<FieldDecl>,
    /// Declarators of declarations and members.
    pub declarator_lists: Vec<Declarator>,
    /// Qualifiers of declarations, members and parameters.
    pub qualifier_lists: Vec<Qualifier>,
    /// Entries of `layout(...)`.
    pub layout_lists: Vec<LayoutEntry>,
    /// Parameters of functions.
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

    /// The expression with this id; an error node if the id is not from this tree.
    pub fn expr(&self, id: ExprId) -> &Expr {
        self.exprs.get(id.0 as usize).unwrap_or(&Tree::NO_EXPR)
    }

    /// The statement with this id; an error node if the id is not from this tree.
    pub fn stmt(&self, id: StmtId) -> &Stmt {
        self.stmts.get(id.0 as usize).unwrap_or(&Tree::NO_STMT)
    }

    /// The type with this id; an error node if the id is not from this tree.
    pub fn ty(&self, id: TypeId) -> &TypeSpec {
        self.types.get(id.0 as usize).unwrap_or(&Tree::NO_TYPE)
    }

    /// The declaration with this id; `None` if the id is not from this tree.
    pub fn decl(&self, id: DeclId) -> Option<&Declaration> {
        self.decls.get(id.0 as usize)
    }

    /// The function with this id; `None` if the id is not from this tree.
    pub fn function(&self, id: FunctionId) -> Option<&FunctionDecl> {
        self.functions.get(id.0 as usize)
    }

    /// The struct with this id; `None` if the id is not from this tree.
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

    /// Array sizes of a type or declarator.
    pub fn arrays(&self, arrays: List) -> &[ArraySize] {
        list(&self.array_lists, arrays)
    }

    /// Qualifiers of a declaration, member or parameter.
    pub fn qualifiers(&self, qualifiers: List) -> &[Qualifier] {
        list(&self.qualifier_lists, qualifiers)
    }

    /// Declarators of a declaration.
    pub fn declarators(&self, declarators: List) -> &[Declarator] {
        list(&self.declarator_lists, declarators)
    }

    /// Member declarations of a struct or block.
    pub fn fields(&self, fields: List) -> &[FieldDecl] {
        list(&self.field_lists, fields)
    }

    /// Parameters of a function.
    pub fn params(&self, params: List) -> &[Param] {
        list(&self.param_lists, params)
    }

    /// Entries of a `layout(...)` qualifier.
    pub fn layout(&self, entries: List) -> &[LayoutEntry] {
        list(&self.layout_lists, entries)
    }

    /// The expression with any enclosing parentheses removed.
    pub fn unparen(&self, mut id: ExprId) -> ExprId {
        while let ExprKind::Paren(inner) = self.expr(id).kind {
            id = inner;
        }
        id
    }
}
