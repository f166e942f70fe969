//! Problems that the checker finds, as data. `explain` turns them into messages.

pub use super::checker::{
    ArgumentError, ArrayError, CallError, Condition, DeclarationError, EntryError, ExpressionError,
    ForeignError, FunctionError, Indexed, InterfaceError, LayoutError, LimitError, NameError,
    OutputError, Owner, PlaceError, QualifierError, RecordError, RecordKind, Restriction,
    StatementError, StorageRequest, SwitchError, ValueError, Writer,
};
use super::program::{FunctionRef, Program, VariableId};
use super::scope::{ScopeLog, ScopeMark};
use super::types::Type;
use super::typing::TypeMismatch;
use shaderlint_syntax::ast::{ExprId, ExprKind, Extent, Ident};

/// Most errors that are reported in one shader.
pub const MAX_ERRORS: usize = 200;

/// A problem, and the state of the checker when it was found.
#[derive(Debug)]
pub struct Problem {
    pub at: Extent,
    pub what: ProblemKind,
    pub moment: ProblemMoment,
    /// Information that was added later.
    pub asides: Vec<Aside>,
}

/// State of the checker: the number of items known so far.
#[derive(Clone, Copy, Debug)]
pub struct ProblemMoment {
    pub exprs: usize,
    pub variables: usize,
    pub functions: usize,
    pub structs: usize,
    pub scopes: ScopeMark,
    pub current: Option<FunctionRef>,
    /// The root of the expression being checked, and the type that its context expects.
    pub root_expr: ExprId,
    pub expected: Option<Type>,
}

/// Information about a problem that was found later.
#[derive(Clone, Copy, Debug)]
pub enum Aside {
    /// Number of further uses of an undeclared name.
    Used(u32),
    /// Type of the first value that is assigned to an undeclared variable.
    SetTo(Type),
    /// The second declaration of a name.
    Second(SecondDeclaration),
    /// Qualifier of the parameter for which an argument must be assignable.
    Argument(&'static str),
}

/// A declaration of a name that is already declared.
#[derive(Clone, Copy, Debug)]
pub struct SecondDeclaration {
    pub ident: Ident,
    pub first: VariableId,
    pub ty: Type,
    pub spec: Option<Extent>,
    /// Whether later uses refer to the second declaration.
    pub is_meant: bool,
}

/// All problems of a shader, in the order in which they were found.
pub struct Problems {
    pub all: Vec<Problem>,
    /// Log of the scopes, to restore those of any moment.
    pub scopes: ScopeLog,
}

impl Problems {
    /// Number of problems.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether there are no problems.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }
}

macro_rules! kinds {
    ($($kind:ident($of:ident)),* $(,)?) => {
        #[derive(Clone, Debug)]
        pub enum ProblemKind {
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

impl Program {
    /// The word or literal that is wrong wherever it stands, however the code around it is parsed.
    pub(super) fn faulty_word(&self, problem: &Problem) -> Option<Extent> {
        use ProblemKind as P;
        use TypeMismatch as T;
        match &problem.what {
            P::Name(NameError::Twice(..) | NameError::UnknownType(_))
            | P::Foreign(ForeignError::Inferred(..)) => None,
            P::Name(_) | P::Foreign(_) => Some(problem.at),
            P::Expression(ExpressionError::Suffix(..) | ExpressionError::Unsigned(_)) => {
                Some(problem.at)
            }
            P::Expression(ExpressionError::Misfit(.., T::Letters(_) | T::Component(..))) => {
                Some(problem.at)
            }
            P::Expression(ExpressionError::Misfit(_, operands, T::Operands(_))) => {
                let mut extents = operands.iter().map(|&id| self.tree.expr(id));
                let literal = extents.find(|expr| matches!(expr.kind, ExprKind::Int(_)));
                literal.map(|expr| expr.extent)
            }
            _ => None,
        }
    }
}
