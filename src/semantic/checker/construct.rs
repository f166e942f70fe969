//! Constructors (GLSL ES 3.00 section 5.4).

use super::super::constant::Value;
use super::*;
use crate::diagnostic::Fix;
use crate::text::Edit;

impl Checker<'_> {
    /// `vec3(...)`, `float[2](...)`: a type of the language, or an array.
    pub(super) fn construct(&mut self, id: ExprId, ty: TypeId, args: List) -> ExprInfo {
        let tree = self.tree;
        let spec = tree.ty(ty);
        if let TypeBase::Struct(_) = spec.base {
            let d = self.error(
                error::INVALID_STRUCT,
                spec.extent,
                "a struct cannot be declared inside an expression",
            );
            self.report(d);
            return ExprInfo::ERROR;
        }
        let ty = self.type_spec(ty);
        if ty.is_array() && !self.has(Feature::ArrayValues) {
            let d = self.error_expr(
                error::NEEDS_WEBGL2,
                id,
                "array constructors come with GLSL ES 3.00",
            );
            self.report(d);
            return ExprInfo::ERROR;
        }
        self.construct_type(id, ty, args)
    }

    pub(super) fn construct_type(&mut self, id: ExprId, mut ty: Type, args: List) -> ExprInfo {
        let tree = self.tree;
        let args = tree.args(args);
        if ty.is_error() {
            return ExprInfo::ERROR;
        }
        if ty.is_void() || ty.is_sampler() {
            let name = self.name_of(ty);
            let d = self.error_expr(
                error::CONSTRUCTOR_ARGUMENTS,
                id,
                format!("`{name}` cannot be constructed"),
            );
            self.report(d);
            return ExprInfo::ERROR;
        }
        if ty.array == Type::UNSIZED {
            ty.array = (args.len() as u32).max(1);
        }
        if args.iter().any(|&a| self.ty(a).is_error()) {
            return ExprInfo {
                ty,
                ..ExprInfo::ERROR
            };
        }
        let ok = self.check_arguments(id, ty, args)
            && if ty.is_array() {
                self.check_elements(id, ty, args)
            } else if let Base::Struct(index) = ty.base {
                self.check_members(id, index, args)
            } else {
                self.check_components(id, ty, args)
            };
        if !ok {
            return ExprInfo {
                ty,
                ..ExprInfo::ERROR
            };
        }
        let infos = || args.iter().map(|&a| self.info(a));
        let is_known = infos().all(|i| i.is_const && i.constant.is_known());
        let constant = match is_known {
            true => self.fold_construct(ty, args),
            false => Constant::NONE,
        };
        let infos = args.iter().map(|&a| self.info(a));
        let mut info = self.result(ty, infos, constant);
        if let Base::Struct(index) = ty.base {
            info.resolution = Resolution::Struct(index);
        }
        info
    }

    /// What holds for every constructor: arguments, with values, and no samplers.
    fn check_arguments(&mut self, id: ExprId, ty: Type, args: &[ExprId]) -> bool {
        if args.is_empty() {
            let name = self.name_of(ty);
            let d = self.error_expr(
                error::CONSTRUCTOR_ARGUMENTS,
                id,
                format!("`{name}()` has no arguments"),
            );
            let zero = self.zero_of(ty).map(|zero| match ty.is_scalar() {
                true => format!("{name}({zero})"),
                false => zero,
            });
            let is_direct = self.is_direct(self.tree.expr(id).extent);
            let fix = zero.filter(|_| is_direct).map(|zero| {
                let edits = vec![Edit::replace(self.expr_span(id), zero.clone())];
                Fix::suggestion(format!("write `{zero}`"), edits)
            });
            self.report(d.fix(fix));
            return false;
        }
        for &arg in args {
            let of = self.ty(arg);
            if of.is_void() {
                self.void_value(arg);
                return false;
            }
            if self.inside(of).sampler {
                let message = if of.is_sampler() {
                    "a sampler cannot be an argument of a constructor"
                } else {
                    "a struct that holds a sampler cannot be an argument of a constructor"
                };
                let d = self.error_expr(error::SAMPLER_RESTRICTION, arg, message);
                self.report(d.note("samplers cannot be copied (section 4.1.7)"));
                return false;
            }
        }
        true
    }

    fn check_elements(&mut self, id: ExprId, ty: Type, args: &[ExprId]) -> bool {
        if ty.array as usize != args.len() {
            let message = format!(
                "`{}` takes {} elements, not {}",
                self.name_of(ty),
                ty.array,
                args.len()
            );
            let d = self.error_expr(error::CONSTRUCTOR_ARGUMENTS, id, message);
            self.report(d);
            return false;
        }
        let element = ty.element();
        for &arg in args {
            if self.ty(arg) != element {
                self.bad_part(arg, element, "an element of the array");
                return false;
            }
        }
        true
    }

    fn check_members(&mut self, id: ExprId, index: u32, args: &[ExprId]) -> bool {
        let Some(record) = self.structs.get(index as usize) else {
            return false;
        };
        let fields = &record.fields;
        if fields.len() != args.len() {
            let opened = record.token;
            let name = record.name.map_or("struct", |n| self.text(n));
            let message = format!(
                "`{name}` has {} members, but {} values are given",
                fields.len(),
                args.len()
            );
            let d = self.error_expr(error::CONSTRUCTOR_ARGUMENTS, id, message);
            let d = self.with_declaration(d, Some(opened), "declared here");
            self.report(d);
            return false;
        }
        let mut pairs = args.iter().zip(fields);
        let misfit = pairs.find(|(arg, f)| self.ty(**arg) != f.ty && !f.ty.is_error());
        let Some((&arg, &Field { name, ty, .. })) = misfit else {
            return true;
        };
        let what = format!("the member `{}`", self.text(name));
        self.bad_part(arg, ty, &what);
        false
    }

    /// An argument that is not of the type of the part it stands for.
    fn bad_part(&mut self, arg: ExprId, wanted: Type, what: &str) {
        let found = self.ty(arg);
        let scalars = (wanted.scalar_kind(), found.scalar_kind());
        let same_size = wanted.components() == found.components();
        let rule = match scalars {
            (Some(a), Some(b)) if a != b && a != Scalar::Bool && b != Scalar::Bool && same_size => {
                error::INT_FLOAT_MIX
            }
            (Some(a), Some(b)) if a == b => error::VECTOR_SIZE,
            _ => error::CONSTRUCTOR_ARGUMENTS,
        };
        let mut d = self.misfit_at(self.tree.expr(arg).extent, wanted, arg, rule);
        d.message = format!(
            "{what} is `{}`, not `{}`",
            self.name_of(wanted),
            self.name_of(found)
        );
        self.report(d);
    }

    fn check_components(&mut self, id: ExprId, ty: Type, args: &[ExprId]) -> bool {
        let wanted = ty.components();
        let mut given = 0;
        let mut has_matrix = false;
        let mut surplus = None;
        for &arg in args {
            let of = self.ty(arg);
            if of.numeric().is_none() {
                let (name, what) = (self.name_of(ty), self.name_of(of));
                let d = self.error_expr(
                    error::CONSTRUCTOR_ARGUMENTS,
                    arg,
                    format!("`{name}` cannot be made of `{what}`"),
                );
                self.report(d);
                return false;
            }
            has_matrix |= of.is_matrix();
            if given >= wanted && surplus.is_none() {
                surplus = Some(arg);
            }
            given += of.components();
        }
        if ty.is_matrix() && has_matrix {
            if args.len() == 1 {
                return true;
            }
            let d = self.error_expr(
                error::CONSTRUCTOR_ARGUMENTS,
                id,
                "a matrix made of a matrix takes no other argument",
            );
            self.report(d);
            return false;
        }
        let too_few = given != 1 && given < wanted;
        if surplus.is_none() && !too_few {
            return true;
        }
        let name = self.name_of(ty);
        let plural = |n: u32| if n == 1 { "component" } else { "components" };
        let d = if let Some(arg) = surplus {
            let d = self.error_expr(
                error::CONSTRUCTOR_ARGUMENTS,
                id,
                format!(
                    "`{name}` has {wanted} {}, but {given} are given",
                    plural(wanted)
                ),
            );
            let fix = self.drop_from(args, arg);
            d.label(self.expr_span(arg), "nothing is left for this")
                .fix(fix)
        } else {
            let d = self.error_expr(
                error::CONSTRUCTOR_ARGUMENTS,
                id,
                format!("`{name}` needs {wanted} components, but only {given} are given"),
            );
            let fix = self.add_components(ty, args, given);
            self.label_arguments(d, args).fix(fix)
        };
        self.report(d);
        false
    }

    /// Takes the arguments from `arg` on away.
    fn drop_from(&self, args: &[ExprId], arg: ExprId) -> Option<Fix> {
        let at = args.iter().position(|&a| a == arg)?;
        let (&before, &last) = (args.get(at.checked_sub(1)?)?, args.last()?);
        let span = Span::new(self.expr_span(before).end, self.expr_span(last).end);
        let text = self
            .sources
            .text(self.expr_span(arg).to(self.expr_span(last)));
        let title = match text.len() < 40 && !text.contains('\n') {
            true => format!("take `{text}` away"),
            false => "take what is too much away".to_string(),
        };
        Some(Fix::suggestion(title, vec![Edit::delete(span)]))
    }

    /// Adds the components that a vector lacks.
    fn add_components(&self, ty: Type, args: &[ExprId], given: u32) -> Option<Fix> {
        let (scalar, 1, size) = ty.numeric()? else {
            return None;
        };
        let added = Checker::added_components(scalar, given as u8, size);
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

    /// The value of a constructor whose arguments are known.
    fn fold_construct(&mut self, ty: Type, args: &[ExprId]) -> Constant {
        let exprs = &self.exprs;
        let info = |id: &ExprId| exprs.get(id.0 as usize).copied();
        let parts = args.iter().filter_map(|a| Some(info(a)?.constant));
        let Some((scalar, columns, rows)) = ty.numeric() else {
            return self.pool.join(parts, |value| value);
        };
        let given: u32 = parts.clone().map(Constant::scalars).sum();
        let from = args.first().and_then(|a| info(a)?.ty.numeric());
        match from {
            _ if given == 1 && columns == 1 => {
                let one = parts.cycle().take(rows.into());
                self.pool.join(one, |value| value.to(scalar))
            }
            _ if columns > 1 && (given == 1 || args.len() == 1) => {
                let all: Vec<Value> = parts
                    .flat_map(|p| self.pool.values(p))
                    .map(|v| v.to(scalar))
                    .collect();
                let out = match (all.as_slice(), from) {
                    (&[one], _) => diagonal(columns, rows, |_, _| None, one),
                    (all, Some((_, c @ 2.., r))) => {
                        let at = |column: u8, row: u8| {
                            let place = column as usize * r as usize + row as usize;
                            all.get(place).copied().filter(|_| column < c && row < r)
                        };
                        diagonal(columns, rows, at, Value::Float(1.0))
                    }
                    (all, _) => all.iter().take(ty.components() as usize).copied().collect(),
                };
                self.pool.add(out)
            }
            _ => {
                let mut left = ty.components();
                let parts = parts.map_while(|part| {
                    let taken = part.scalars().min(left);
                    left -= taken;
                    (taken > 0).then(|| part.part(0, taken))
                });
                self.pool.join(parts, |value| value.to(scalar))
            }
        }
    }
}

/// A matrix of what `at` gives, and elsewhere of `one` in the diagonal and 0 beside it.
fn diagonal(columns: u8, rows: u8, at: impl Fn(u8, u8) -> Option<Value>, one: Value) -> Vec<Value> {
    let mut out = Vec::new();
    for column in 0..columns {
        for row in 0..rows {
            let zero = if column == row {
                one
            } else {
                Value::Float(0.0)
            };
            out.push(at(column, row).unwrap_or(zero));
        }
    }
    out
}
