//! Constructors (GLSL ES 3.00 section 5.4).

use crate::checker::*;
use crate::constant::Value;

impl Checker<'_> {
    /// `vec3(...)`, `float[2](...)`: a built-in type or an array.
    pub(in crate::checker) fn construct(&mut self, id: ExprId, ty: TypeId, args: List) -> ExprInfo {
        let tree = self.tree;
        let ty = self.type_spec(ty);
        if ty.is_array() && !self.has(Feature::ArrayValues) {
            self.reject(tree.expr(id).extent, ArrayError::Constructor);
            return ExprInfo::ERROR;
        }
        self.construct_type(id, ty, args)
    }

    pub(in crate::checker) fn construct_type(
        &mut self,
        id: ExprId,
        mut ty: Type,
        args: List,
    ) -> ExprInfo {
        let tree = self.tree;
        let args = tree.args(args);
        if ty.is_error() {
            return ExprInfo::ERROR;
        }
        ty = typing::sized(ty, args.len());
        let types = args.iter().map(|&a| self.ty(a));
        if let Err(mismatch) = typing::construct(self.types(), ty, types.clone()) {
            self.refuse(id, args, mismatch);
            let ty = match mismatch {
                TypeMismatch::NotConstructible(_) => Type::ERROR,
                _ => ty,
            };
            return ExprInfo::wrong(ty);
        }
        if types.clone().any(Type::is_error) {
            return ExprInfo::wrong(ty);
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
            info.resolution = Resolution::Struct(index.into());
        }
        info
    }

    /// The value of a constructor with constant arguments.
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

/// A matrix of the values of `at`; where that is `None`, of `one` on the diagonal and 0 elsewhere.
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
