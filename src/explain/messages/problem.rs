//! Dispatch of each kind of problem to its messages.

use super::*;

impl Explain for ProblemKind {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use ProblemKind as K;
        match self {
            K::Array(of) => of.explain(c, at),
            K::Argument(of) => of.explain(c, at),
            K::Calls(of) => of.explain(c, at),
            K::Declaration(of) => of.explain(c, at),
            K::Entry(of) => of.explain(c, at),
            K::Expression(of) => of.explain(c, at),
            K::Foreign(of) => of.explain(c, at),
            K::Function(of) => of.explain(c, at),
            K::Interface(of) => of.explain(c, at),
            K::Layout(of) => of.explain(c, at),
            K::Limit(of) => of.explain(c, at),
            K::Name(of) => of.explain(c, at),
            K::Output(of) => of.explain(c, at),
            K::Place(of) => of.explain(c, at),
            K::Qualifier(of) => of.explain(c, at),
            K::Record(of) => of.explain(c, at),
            K::Restriction(of) => of.explain(c, at),
            K::Statement(of) => of.explain(c, at),
            K::Switch(of) => of.explain(c, at),
            K::Value(of) => of.explain(c, at),
        }
    }
}
