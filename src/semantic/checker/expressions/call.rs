//! Calls of functions (GLSL ES 3.00 section 6.1).

use crate::builtins::{BuiltinId, BuiltinKind, LEGACY_FUNCTIONS, Overload};
use crate::checker::*;
use crate::constant::Value;

/// Range of the offset of a texture lookup, in texels.
const TEXEL_OFFSETS: std::ops::RangeInclusive<i32> = -8..=7;

/// An error in a call or its arguments.
#[derive(Clone, Copy, Debug)]
pub enum ArgumentError {
    /// A call of a variable.
    Variable(ExprId, Name, VariableId, List),
    /// A call that matches none of the shader's functions of this name.
    User(ExprId, Name, List),
    /// A call that matches no overload of a built-in function.
    Builtin(ExprId, Name, BuiltinId, List),
    /// A texture offset that is not constant.
    DynamicOffset(ExprId),
    /// A texture offset that is out of range.
    Offset(ExprId, i32),
    /// An argument that is not an input of the fragment shader, for this function.
    Interpolant(ExprId, BuiltinId),
}

impl Checker<'_> {
    /// Reports a call that matches no overload, unless one could not be parsed and may be the one
    /// that is meant.
    fn reject_call(&mut self, id: ExprId, name: Name, problem: ArgumentError) {
        if !self.tree.lost.contains(&name) {
            self.reject_expr(id, problem);
        }
    }

    /// `name(args)`: a function, or the constructor of a struct.
    pub(in crate::checker) fn call(&mut self, id: ExprId, name: Name, args: List) -> ExprInfo {
        if self.unknown_functions.contains(&name) {
            return ExprInfo::ERROR;
        }
        match self.scopes.get(name) {
            Some(Binding::Struct(index)) => {
                return self.construct_type(id, Type::structure(index), args);
            }
            Some(Binding::Error) => return ExprInfo::ERROR,
            Some(Binding::Variable(variable)) => {
                self.reject_expr(id, ArgumentError::Variable(id, name, variable, args));
                return ExprInfo::ERROR;
            }
            Some(Binding::Function) => {
                if let Some(info) = self.call_user(id, name, args) {
                    return info;
                }
            }
            Some(Binding::Block(_)) | None => {}
        }
        match self.builtin_named(name) {
            Some(function) => self.call_builtin(id, name, function, args),
            None if self.by_name.contains_key(&name) => {
                self.reject_call(id, name, ArgumentError::User(id, name, args));
                self.result_of_any(name)
            }
            None if self.is_foreign(name, id) => self.foreign_call(id, name, args),
            None => {
                self.undeclared_function(name, self.tree.expr(id).extent.first);
                self.result_of_legacy(name)
            }
        }
    }

    /// The built-in function of this name.
    pub(super) fn builtin_named(&mut self, name: Name) -> Option<BuiltinId> {
        let index = name.0 as usize;
        if self.builtin_names.len() <= index {
            self.builtin_names.resize(index + 64, None);
        }
        let (text, builtins) = (self.text(name), self.builtins);
        let slot = self.builtin_names.get_mut(index)?;
        *slot.get_or_insert_with(|| builtins.function(text))
    }

    /// A call of a function of the shader, if one has these parameters.
    fn call_user(&mut self, id: ExprId, name: Name, args: List) -> Option<ExprInfo> {
        let tree = self.tree;
        let list = tree.args(args);
        if list.iter().any(|&a| self.ty(a).is_error()) {
            self.note_call_with_errors(id, name);
            return Some(self.result_of_any(name));
        }
        let callee = self.function_of(name, list.iter().map(|&a| self.ty(a)))?;
        let returns = self.functions.get(callee.0 as usize)?.returns;
        for (i, &arg) in list.iter().enumerate() {
            let function = self.functions.get(callee.0 as usize)?;
            let direction = function.params.get(i)?.direction;
            if direction.writes() {
                self.check_out_argument(arg, direction.name());
            }
        }
        self.calls.push(Call {
            caller: self.current,
            callee,
            expr: id,
        });
        let infos = list.iter().map(|&a| self.info(a));
        let info = self.result(returns, infos, Constant::NONE);
        Some(ExprInfo {
            resolution: Resolution::Function(callee),
            is_const: false,
            ..info
        })
    }

    /// A call whose arguments were reported is still recorded, if only one function can be meant.
    fn note_call_with_errors(&mut self, id: ExprId, name: Name) {
        if let Some(&[callee]) = self.by_name.get(&name).map(Vec::as_slice) {
            self.calls.push(Call {
                caller: self.current,
                callee,
                expr: id,
            });
        }
    }

    /// The result of a call that matches no function of the name: known if all return the same
    /// type.
    fn result_of_any(&self, name: Name) -> ExprInfo {
        let all = self.by_name.get(&name).map_or(&[][..], Vec::as_slice);
        let functions = all.iter().filter_map(|f| self.functions.get(f.0 as usize));
        let common = typing::common(functions.map(|f| f.returns));
        let is_builtin = self.builtins.function(self.text(name)).is_some();
        let ty = common.filter(|_| !is_builtin).unwrap_or(Type::ERROR);
        ExprInfo::wrong(ty)
    }

    /// The result of a GLSL ES 1.00 lookup, so that its error does not cause others.
    fn result_of_legacy(&self, name: Name) -> ExprInfo {
        let is_legacy = LEGACY_FUNCTIONS
            .iter()
            .any(|(old, _)| *old == self.text(name));
        let ty = if is_legacy {
            Type::vector(Scalar::Float, 4)
        } else {
            Type::ERROR
        };
        ExprInfo::wrong(ty)
    }

    fn check_out_argument(&mut self, arg: ExprId, direction: &'static str) {
        let before = self.problems.len();
        let extent = self.tree.expr(arg).extent;
        if !self.check_assignable(arg, extent, Writer::Word(direction)) {
            self.add_aside(before, Aside::Argument(direction));
        }
    }

    fn call_builtin(
        &mut self,
        id: ExprId,
        name: Name,
        function: BuiltinId,
        args: List,
    ) -> ExprInfo {
        let tree = self.tree;
        let list = tree.args(args);
        if list.iter().any(|&a| self.ty(a).is_error()) {
            return self.builtin_result_of_any(function, list.len());
        }
        let (first, overloads) = self.builtins.overloads_of(function);
        let types = list.iter().map(|&a| self.ty(a));
        let fits = |o: &Overload| types.clone().eq(o.params().iter().copied());
        let Some(at) = overloads.iter().position(fits) else {
            self.reject_call(id, name, ArgumentError::Builtin(id, name, function, args));
            return self.builtin_result_of_any(function, list.len());
        };
        let Some(overload) = overloads.get(at) else {
            return ExprInfo::ERROR;
        };
        for (i, &arg) in list.iter().enumerate() {
            if overload.writes(i) {
                self.check_out_argument(arg, "out");
            }
            if overload.constant & (1 << i) != 0 {
                self.check_offset(arg);
            }
        }
        if function.interpolates() {
            self.check_interpolant(list, function);
        }
        let is_math = function.kind() == BuiltinKind::Math && overload.out == 0;
        let constant = if is_math {
            self.fold_call(overload, list)
        } else {
            Constant::NONE
        };
        let infos = list.iter().map(|&a| self.info(a));
        let mut info = self.result(overload.returns, infos, constant);
        info.is_const &= is_math;
        info.resolution = Resolution::Builtin(first + at as u32);
        info
    }

    fn builtin_result_of_any(&self, function: BuiltinId, count: usize) -> ExprInfo {
        let (_, overloads) = self.builtins.overloads_of(function);
        let fitting = overloads.iter().filter(|o| o.params().len() == count);
        let ty = typing::common(fitting.map(|o| o.returns)).unwrap_or(Type::ERROR);
        ExprInfo::wrong(ty)
    }

    fn fold_call(&mut self, overload: &Overload, args: &[ExprId]) -> Constant {
        let infos = args.iter().map(|&a| self.info(a));
        if !infos.clone().all(|a| a.is_const && a.constant.is_known()) {
            return Constant::NONE;
        }
        let values: Vec<&[Value]> = infos.map(|a| self.pool.values(a.constant)).collect();
        match overload.fold(&values) {
            Some(values) if values.len() as u32 == overload.returns.components() => {
                self.pool.add(values)
            }
            _ => Constant::NONE,
        }
    }

    /// Checks that a texture offset is a constant within [`TEXEL_OFFSETS`] (section 8.8).
    /// The first argument must be an input or an element of one.
    fn check_interpolant(&mut self, list: &[ExprId], function: BuiltinId) {
        let Some(&first) = list.first() else { return };
        let mut object = self.tree.unparen(first);
        if let ExprKind::Index(array, _) = self.tree.expr(object).kind
            && self.ty(array).is_array()
        {
            object = self.tree.unparen(array);
        }
        let variable = self.variable_of(object);
        let storage = variable.and_then(|id| Some(self.variables.get(id.0 as usize)?.storage));
        if storage != Some(Storage::Input) {
            self.reject_expr(first, ArgumentError::Interpolant(first, function));
        }
    }

    fn check_offset(&mut self, arg: ExprId) {
        let info = self.info(arg);
        if !info.is_const {
            return self.reject_expr(arg, ArgumentError::DynamicOffset(arg));
        }
        let out = self
            .pool
            .values(info.constant)
            .iter()
            .find(|v| !TEXEL_OFFSETS.contains(&v.as_int()));
        if let Some(value) = out {
            let offset = value.as_int();
            self.reject_expr(arg, ArgumentError::Offset(arg, offset));
        }
    }
}
