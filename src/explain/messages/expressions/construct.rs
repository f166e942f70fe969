//! Messages for constructors with wrong arguments.

use crate::messages::*;
use shaderlint_diagnostic::count;

impl ExplainContext<'_> {
    /// A constructor that its arguments do not match.
    pub(super) fn explain_construction(
        &self,
        id: ExprId,
        args: &[ExprId],
        mismatch: TypeMismatch,
    ) -> Diagnostic {
        let error = |at: ExprId, message: String| {
            self.error_expr(error::CONSTRUCTOR_ARGUMENTS, at, message)
        };
        let arg = |number: usize| args.get(number).copied().unwrap_or(id);
        match mismatch {
            TypeMismatch::NotConstructible(ty) => {
                error(id, format!("`{}` cannot be constructed", self.name_of(ty)))
            }
            TypeMismatch::NoArguments(ty) => self.no_arguments(id, ty),
            TypeMismatch::SamplerArgument(number) => self.sampler_argument(arg(number)),
            TypeMismatch::Count(ty) => self.wrong_component_count(id, ty, args.len()),
            TypeMismatch::Part(number, expected) => {
                let what = self.component_in_words(id, number);
                self.bad_component(arg(number), expected, &what)
            }
            TypeMismatch::NoNumber(number, ty) => {
                let (name, what) = (self.name_of(ty), self.name_of(self.ty(arg(number))));
                error(
                    arg(number),
                    format!("cannot construct `{name}` from `{what}`"),
                )
            }
            TypeMismatch::TooFew(ty, given) => {
                let (name, expected) = (self.name_of(ty), count(ty.components(), "component"));
                let message = format!("`{name}` expects {expected}, found {given}");
                let fix = self.add_components(ty, args, given);
                self.label_arguments(error(id, message), args).fix(fix)
            }
            TypeMismatch::TooMany(ty, given, surplus) => {
                let (name, expected) = (self.name_of(ty), count(ty.components(), "component"));
                let message = format!("`{name}` expects {expected}, found {given}");
                error(id, message)
                    .label(self.expr_span(arg(surplus)), "extra argument")
                    .fix(self.drop_from(args, arg(surplus)))
            }
            _ => error(
                id,
                "a matrix constructed from a matrix accepts no other arguments".to_string(),
            ),
        }
    }

    fn no_arguments(&self, id: ExprId, ty: Type) -> Diagnostic {
        let name = self.name_of(ty);
        let message = format!("`{name}()` needs at least one argument");
        let d = self.error_expr(error::CONSTRUCTOR_ARGUMENTS, id, message);
        let zero = ty.zero().map(|zero| match ty.is_scalar() {
            true => format!("{name}({zero})"),
            false => zero,
        });
        let is_direct = self.is_direct(self.tree.expr(id).extent);
        d.fix(zero.filter(|_| is_direct).map(|zero| {
            let edits = vec![Edit::replace(self.expr_span(id), zero.clone())];
            Fix::suggestion(format!("use `{zero}`"), edits)
        }))
    }

    fn sampler_argument(&self, arg: ExprId) -> Diagnostic {
        let message = if self.ty(arg).is_sampler() {
            "a sampler cannot be a constructor argument"
        } else {
            "a struct containing a sampler cannot be a constructor argument"
        };
        self.error_expr(error::SAMPLER_RESTRICTION, arg, message)
            .note("samplers cannot be copied (section 4.1.7)")
    }

    /// A wrong number of arguments for the elements of an array or the members of a struct.
    fn wrong_component_count(&self, id: ExprId, ty: Type, given: usize) -> Diagnostic {
        let record = match ty.base {
            Base::Struct(index) if !ty.is_array() => self.structs.get(index as usize),
            _ => None,
        };
        let Some(record) = record else {
            let (name, expected) = (self.name_of(ty), count(ty.array, "element"));
            let message = format!("`{name}` expects {expected}, found {given}");
            return self.error_expr(error::CONSTRUCTOR_ARGUMENTS, id, message);
        };
        let name = record.name.map_or("struct", |n| self.text(n));
        let expected = count(record.fields.len(), "argument");
        let message = format!("`{name}` expects {expected}, found {given}");
        let d = self.error_expr(error::CONSTRUCTOR_ARGUMENTS, id, message);
        self.with_declaration(d, Some(record.token), "declared here")
    }

    /// The struct member or array element that an argument initializes.
    fn component_in_words(&self, id: ExprId, number: usize) -> String {
        let field = match (self.tree.expr(id).kind, self.constructed(id)) {
            (ExprKind::Call(..), Some(index)) => {
                let record = self.structs.get(index as usize);
                record.and_then(|r| r.fields.get(number))
            }
            _ => None,
        };
        match field {
            Some(field) => format!("member `{}`", self.text(field.name)),
            None => "array element".to_string(),
        }
    }

    /// The struct whose constructor is called.
    fn constructed(&self, id: ExprId) -> Option<u32> {
        match self.tree.expr(id).kind {
            ExprKind::Call(name, _) => match self.scopes().get(name)? {
                Binding::Struct(index) => Some(index),
                _ => None,
            },
            _ => None,
        }
    }

    /// An argument of another type than its member or element.
    fn bad_component(&self, arg: ExprId, expected: Type, what: &str) -> Diagnostic {
        let found = self.ty(arg);
        let scalars = (expected.scalar_kind(), found.scalar_kind());
        let same_size = expected.components() == found.components();
        let rule = match scalars {
            (Some(a), Some(b)) if a != b && a != Scalar::Bool && b != Scalar::Bool && same_size => {
                error::INT_FLOAT_MIX
            }
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::CONSTRUCTOR_ARGUMENTS,
        };
        let mut d = self.mismatch_at(self.tree.expr(arg).extent, expected, arg, rule);
        d.message = format!(
            "{what} must be `{}`, found `{}`",
            self.name_of(expected),
            self.name_of(found)
        );
        d
    }

    /// Removes the arguments from `arg` on.
    fn drop_from(&self, args: &[ExprId], arg: ExprId) -> Option<Fix> {
        let at = args.iter().position(|&a| a == arg)?;
        let (&before, &last) = (args.get(at.checked_sub(1)?)?, args.last()?);
        let last = self.expr_span(last);
        let span = Span::new(self.expr_span(before).end, last.end);
        Some(self.without(self.expr_span(arg).to(last), span))
    }

    /// Adds the missing components of a vector.
    fn add_components(&self, ty: Type, args: &[ExprId], given: u32) -> Option<Fix> {
        let (scalar, 1, size) = ty.numeric()? else {
            return None;
        };
        // A number and its alpha are a grey.
        if let (Scalar::Float, 4, [grey, alpha]) = (scalar, size, args)
            && self.ty(*grey).is_scalar()
            && self.ty(*alpha).is_scalar()
            && self.is_direct(self.tree.expr(*grey).extent)
        {
            let title = format!("use `vec3({})`", self.expr_text(*grey));
            return Some(Fix::suggestion(title, self.wrap(*grey, "vec3(", ")")));
        }
        let added = ExplainContext::added_components(scalar, given as u8, size);
        let end = self.expr_span(*args.last()?).end;
        let title = format!("add `{}`", added.trim_start_matches(", "));
        Some(Fix::suggestion(title, vec![Edit::insert(end, added)]))
    }

    fn label_arguments(&self, mut d: Diagnostic, args: &[ExprId]) -> Diagnostic {
        if args.len() > 1 {
            for &arg in args {
                d = d.label(
                    self.expr_span(arg),
                    format!("`{}`", self.name_of(self.ty(arg))),
                );
            }
        }
        d
    }
}
