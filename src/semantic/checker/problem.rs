//! What the checker finds wrong, as data: whether words are made of it, others decide.

use super::*;

/// Something that is wrong, and what was known of the shader when it was met.
#[derive(Debug)]
pub(crate) struct Problem {
    pub at: Extent,
    pub what: ProblemKind,
    pub moment: ProblemMoment,
    /// What came to be known of it later.
    pub asides: Vec<Aside>,
}

/// How far the checker was: what was declared later is not known yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProblemMoment {
    pub exprs: usize,
    pub variables: usize,
    pub functions: usize,
    pub structs: usize,
    pub scopes: ScopeMark,
    pub current: Option<FunctionRef>,
    /// The whole expression at hand, and the type that it should have.
    pub whole: ExprId,
    pub wanted: Option<Type>,
}

/// What came to be known of a problem after it was met.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Aside {
    /// How often an undeclared name is used besides.
    Used(u32),
    /// An undeclared variable is first set to a value of this type.
    SetTo(Type),
    /// What is declared a second time.
    Second(SecondDeclaration),
    /// An argument that cannot be written to is one for a parameter so qualified.
    Argument(&'static str),
}

/// A declaration of a name that has one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SecondDeclaration {
    pub ident: Ident,
    pub first: VariableId,
    pub ty: Type,
    pub spec: Option<Extent>,
    /// Whether the uses behind it mean the second one.
    pub is_meant: bool,
}

/// All that is wrong with a shader.
pub struct Problems {
    pub(crate) all: Vec<Problem>,
    /// The scopes of all moments.
    pub(crate) scopes: ScopeLog,
}

impl Problems {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }
}

macro_rules! kinds {
    ($($kind:ident($of:ident)),* $(,)?) => {
        /// All that can be wrong.
        #[derive(Clone, Debug)]
        pub(crate) enum ProblemKind {
            $($kind($of)),*
        }

        $(impl From<$of> for ProblemKind {
            fn from(of: $of) -> ProblemKind {
                ProblemKind::$kind(of)
            }
        })*
    };
}

kinds! {
    Array(ArrayError),
    Argument(ArgumentError),
    Calls(CallError),
    Declaration(DeclarationError),
    Entry(EntryError),
    Expression(ExpressionError),
    Foreign(ForeignError),
    Function(FunctionError),
    Interface(InterfaceError),
    Layout(LayoutError),
    Limit(LimitError),
    Name(NameError),
    Output(OutputError),
    Place(PlaceError),
    Qualifier(QualifierError),
    Record(RecordError),
    Restriction(Restriction),
    Statement(StatementError),
    Switch(SwitchError),
    Value(ValueError),
}
