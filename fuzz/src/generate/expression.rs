//! Expressions of a requested type.

use super::{Function, Use, Way, Writer};
use shaderlint::semantic::builtins::{BuiltinKind, Overload};
use shaderlint::semantic::{Base, Scalar, Type};

/// A place expression and its type.
struct Path {
    text: String,
    ty: Type,
}

impl Writer {
    /// An expression of a type, with operators nested at most `depth` deep.
    pub(super) fn expression(&mut self, ty: Type, depth: u32) -> String {
        let ty = if self.mistake() {
            self.numeric_type()
        } else {
            ty
        };
        if depth == 0 {
            return self.leaf(ty);
        }
        let found = match self.below(17) {
            0 => Some(format!("({})", self.expression(ty, depth - 1))),
            1 => self.unary(ty, depth - 1),
            2..=5 => self.binary(ty, depth - 1),
            6 => self.ternary(ty, depth - 1),
            7..=9 => self.builtin_call(ty, depth - 1),
            10 => self.user_call(ty, depth - 1),
            11 | 12 => Some(self.constructor(ty, depth - 1)),
            13 => self.part(ty, depth - 1),
            14 => self.comma(ty, depth - 1),
            15 => self.assignment(ty, depth - 1),
            _ => None,
        };
        found.unwrap_or_else(|| self.leaf(ty))
    }

    /// Names of variables, their members, elements and components.
    fn paths(&mut self, writable: bool) -> Vec<Path> {
        let mut paths = Vec::new();
        let anything = writable && self.mistake();
        for variable in self.visible() {
            let fits = match variable.usage {
                _ if anything => true,
                Use::Constant => !writable,
                Use::Free => !self.constant,
                Use::Read | Use::Index => !writable && !self.constant,
            };
            if fits {
                let ty = variable.ty;
                self.add_paths(variable.name, ty, 2, &mut paths);
            }
        }
        paths
    }

    fn add_paths(&mut self, text: String, ty: Type, depth: u32, paths: &mut Vec<Path>) {
        if depth > 0 {
            if ty.is_array() {
                let at = self.index(ty.array);
                self.add_paths(format!("{text}[{at}]"), ty.element(), depth - 1, paths);
            } else if let Base::Struct(id) = ty.base {
                let fields = self.structs.get(id as usize).map(|s| s.fields.clone());
                for (name, ty) in fields.unwrap_or_default() {
                    self.add_paths(format!("{text}.{name}"), ty, depth - 1, paths);
                }
            } else if ty.is_vector() && self.one_in(2) {
                let letter = ["x", "g", "s", "y"][self.below(2)];
                let scalar = ty.scalar_kind().map_or(Type::FLOAT, Type::scalar);
                paths.push(Path {
                    text: format!("{text}.{letter}"),
                    ty: scalar,
                });
            }
        }
        paths.push(Path { text, ty });
    }

    /// An index into something with `size` components.
    fn index(&mut self, size: u32) -> String {
        if self.mistake() {
            let odd = ["-1", "7", "1.0", "true", "(0, 9)", "9u"];
            return self.pick(&odd).to_string();
        }
        let at = self.below(size as usize);
        match self.below(6) {
            0 if self.is_300 => format!("{at}u"),
            1 => format!("{at} + 0"),
            2 if !self.constant => self.variable_index().unwrap_or_else(|| at.to_string()),
            _ => at.to_string(),
        }
    }

    /// A variable as an index: in GLSL ES 1.00 only a loop index.
    fn variable_index(&mut self) -> Option<String> {
        let fits = |usage: Use| match usage {
            Use::Index => true,
            Use::Constant => false,
            _ => self.is_300 && self.names.is_multiple_of(3),
        };
        let all = self.visible();
        let found: Vec<_> = all
            .iter()
            .filter(|v| v.ty == Type::INT && fits(v.usage))
            .collect();
        let at = self.below(found.len());
        let name = found.get(at)?.name.clone();
        if self.is_300 {
            // Some indices must be constant.
            self.unsure();
        }
        Some(name)
    }

    pub(super) fn leaf(&mut self, ty: Type) -> String {
        let mut fitting: Vec<Path> = self.paths(false);
        fitting.retain(|p| p.ty == ty);
        if fitting.is_empty() || (self.one_in(4) && !self.holds_sampler(ty)) {
            return self.literal(ty);
        }
        let at = self.below(fitting.len());
        fitting.swap_remove(at).text
    }

    pub(super) fn place(&mut self, ty: Type) -> Option<String> {
        let mut fitting: Vec<Path> = self.paths(true);
        fitting.retain(|p| p.ty == ty);
        let at = self.below(fitting.len());
        (at < fitting.len()).then(|| fitting.swap_remove(at).text)
    }

    /// The type of an assignable place.
    pub(super) fn place_type(&mut self) -> Option<Type> {
        let fitting: Vec<Path> = self.paths(true);
        let at = self.below(fitting.len());
        fitting.get(at).map(|p| p.ty)
    }

    pub(super) fn literal(&mut self, ty: Type) -> String {
        match (ty.array, ty.base) {
            (
                0,
                Base::Numeric {
                    scalar,
                    columns: 1,
                    rows: 1,
                },
            ) => self.number(scalar),
            (0, Base::Numeric { scalar, .. }) if self.one_in(2) => {
                format!("{}({})", self.base_name(ty), self.number(scalar))
            }
            _ => self.constructor(ty, 0),
        }
    }

    fn number(&mut self, scalar: Scalar) -> String {
        let small = self.below(9);
        match scalar {
            Scalar::Bool => self.pick(&["true", "false"]).to_string(),
            Scalar::Int if self.one_in(5) => {
                let odd = ["(-1)", "0x1F", "017", "2147483647", "0"];
                self.pick(&odd).to_string()
            }
            Scalar::Int => small.to_string(),
            Scalar::Uint => format!("{small}u"),
            Scalar::Float if self.one_in(3) => {
                let odd = ["0.0", "(-1.5)", "1e3", "2.5e-3", "100."];
                self.pick(&odd).to_string()
            }
            Scalar::Float => format!("{small}.{}", small * 3),
        }
    }

    fn constructor(&mut self, ty: Type, depth: u32) -> String {
        let name = self.type_name(ty);
        let args: Vec<String> = match ty.base {
            _ if ty.is_array() => (0..ty.array)
                .map(|_| self.expression(ty.element(), depth))
                .collect(),
            Base::Struct(id) => {
                let fields = self.structs.get(id as usize).map(|s| s.fields.clone());
                let fields = fields.unwrap_or_default();
                fields
                    .iter()
                    .map(|(_, ty)| self.expression(*ty, depth))
                    .collect()
            }
            _ => self.components(ty, depth),
        };
        format!("{name}({})", args.join(", "))
    }

    /// Constructor arguments for a scalar, vector or matrix.
    fn components(&mut self, ty: Type, depth: u32) -> Vec<String> {
        let expected = ty.components();
        if self.mistake() {
            let ty = self.numeric_type();
            return vec![self.expression(ty, depth); self.below(3)];
        }
        if ty.is_matrix() && self.is_300 && self.one_in(4) {
            let other = Type::matrix(self.below(3) as u8 + 2, self.below(3) as u8 + 2);
            return vec![self.expression(other, depth)];
        }
        if self.one_in(4) {
            let scalar = self.scalar();
            return vec![self.expression(Type::scalar(scalar), depth)];
        }
        let mut args = Vec::new();
        let mut given = 0;
        while given < expected {
            let scalar = self.scalar();
            let most = if ty.is_matrix() { expected - given } else { 4 };
            let rows = (self.below(4) as u32 + 1).min(most);
            args.push(self.expression(Type::vector(scalar, rows as u8), depth));
            given += rows;
        }
        args
    }

    fn unary(&mut self, ty: Type, depth: u32) -> Option<String> {
        let scalar = ty.scalar_kind()?;
        let op = match scalar {
            Scalar::Bool if ty.is_scalar() => "!",
            Scalar::Bool => return None,
            Scalar::Int | Scalar::Uint if self.is_300 && self.one_in(2) => "~",
            _ if !self.constant && self.one_in(2) => {
                let place = self.place(ty)?;
                let step = self.pick(&["++", "--"]);
                return Some(match self.below(2) {
                    0 => format!("({step}{place})"),
                    _ => format!("{place}{step}"),
                });
            }
            _ => self.pick(&["-", "+"]),
        };
        Some(format!("{op}({})", self.expression(ty, depth)))
    }

    fn binary(&mut self, ty: Type, depth: u32) -> Option<String> {
        let scalar = ty.scalar_kind()?;
        if self.mistake() {
            let ops = ["%", "&", "<<", "&&", "<", "==", "+", "^^"];
            let op = self.pick(&ops);
            return Some(self.infix(ty, op, ty, depth));
        }
        if scalar == Scalar::Bool {
            return ty.is_scalar().then(|| self.truth(depth));
        }
        let one = Type::scalar(scalar);
        let integer = scalar.is_integer() && self.is_300;
        Some(match self.below(6) {
            0 if integer => {
                let scalar = if self.one_in(2) {
                    Scalar::Int
                } else {
                    Scalar::Uint
                };
                let by = if self.one_in(2) {
                    ty.with_scalar(scalar)
                } else {
                    Type::scalar(scalar)
                };
                let op = self.pick(&["<<", ">>"]);
                self.infix(ty, op, by, depth)
            }
            1 if integer => {
                let op = self.pick(&["%", "&", "|", "^"]);
                self.infix(ty, op, ty, depth)
            }
            2 => {
                let op = self.pick(&["+", "-", "*", "/"]);
                self.infix(ty, op, one, depth)
            }
            3 => {
                let op = self.pick(&["+", "-", "*", "/"]);
                self.infix(one, op, ty, depth)
            }
            4 if scalar == Scalar::Float => self.product(ty, depth),
            _ => {
                let op = if ty.is_matrix() {
                    "+"
                } else {
                    self.pick(&["+", "-", "*", "/"])
                };
                self.infix(ty, op, ty, depth)
            }
        })
    }

    fn infix(&mut self, left: Type, op: &str, right: Type, depth: u32) -> String {
        let left = self.expression(left, depth);
        format!("({left} {op} {})", self.expression(right, depth))
    }

    /// A product with a matrix operand.
    fn product(&mut self, ty: Type, depth: u32) -> String {
        let (_, columns, rows) = ty.numeric().unwrap_or((Scalar::Float, 1, 1));
        let inner = self.below(3) as u8 + 2;
        let (left, right) = match (ty.is_matrix(), self.below(2)) {
            (true, _) if self.is_300 => (Type::matrix(inner, rows), Type::matrix(columns, inner)),
            (true, _) => (ty, ty),
            (false, _) if rows == 1 => (ty, ty),
            (false, 0) if self.is_300 => (
                Type::matrix(inner, rows),
                Type::vector(Scalar::Float, inner),
            ),
            (false, 1) if self.is_300 => (
                Type::vector(Scalar::Float, inner),
                Type::matrix(rows, inner),
            ),
            (false, 0) => (Type::matrix(rows, rows), ty),
            (false, _) => (ty, Type::matrix(rows, rows)),
        };
        self.infix(left, "*", right, depth)
    }

    /// A `bool` expression with an operator.
    fn truth(&mut self, depth: u32) -> String {
        match self.below(3) {
            0 => {
                let scalar = [Scalar::Int, Scalar::Float][self.below(2)];
                let op = self.pick(&["<", ">", "<=", ">="]);
                self.infix(Type::scalar(scalar), op, Type::scalar(scalar), depth)
            }
            1 => {
                let ty = self.plain_type();
                let op = self.pick(&["==", "!="]);
                self.infix(ty, op, ty, depth)
            }
            _ => {
                let op = self.pick(&["&&", "||", "^^"]);
                self.infix(Type::BOOL, op, Type::BOOL, depth)
            }
        }
    }

    fn ternary(&mut self, ty: Type, depth: u32) -> Option<String> {
        ty.numeric().filter(|_| !ty.is_array()).or_else(|| {
            // The conditional operator does not accept structs or arrays.
            self.mistake().then_some((Scalar::Int, 1, 1))
        })?;
        let condition = self.expression(Type::BOOL, depth);
        let yes = self.expression(ty, depth);
        Some(format!(
            "({condition} ? {yes} : {})",
            self.expression(ty, depth)
        ))
    }

    fn builtin_call(&mut self, ty: Type, depth: u32) -> Option<String> {
        let builtins = self.builtins;
        let fits = |o: &&Overload| {
            let is_math = o.function.kind() == BuiltinKind::Math && o.out == 0;
            o.returns == ty && (is_math || !self.constant)
        };
        let all: Vec<&Overload> = builtins.overloads().filter(fits).collect();
        let at = self.below(all.len());
        let overload = *all.get(at)?;
        let name = overload.function.name();
        if self.scope_of(name).is_some() {
            return None;
        }
        let mut args = Vec::new();
        for (i, &param) in overload.params().iter().enumerate() {
            let bit = 1 << i;
            args.push(if overload.out & bit != 0 {
                self.place(param)?
            } else if overload.constant & bit != 0 {
                self.constantly(|w| w.offset(param))
            } else if param.is_sampler() {
                self.sampler_path(param)?
            } else {
                self.expression(param, depth)
            });
        }
        Some(self.call_text(name.to_string(), args))
    }

    /// A call, with one argument too many or too few if it is to be invalid.
    fn call_text(&mut self, name: String, mut args: Vec<String>) -> String {
        if self.mistake() {
            match self.below(2) {
                0 => drop(args.pop()),
                _ => args.push("1.0".to_string()),
            }
        }
        format!("{name}({})", args.join(", "))
    }

    fn sampler_path(&mut self, ty: Type) -> Option<String> {
        let mut fitting = self.paths(false);
        fitting.retain(|p| p.ty == ty);
        let at = self.below(fitting.len());
        (at < fitting.len()).then(|| fitting.swap_remove(at).text)
    }

    /// The offset of a texture lookup.
    fn offset(&mut self, ty: Type) -> String {
        if self.mistake() {
            return self.expression(ty, 1);
        }
        let parts: Vec<String> = (0..ty.components())
            .map(|_| (self.below(16) as i32 - 8).to_string())
            .collect();
        format!("{}({})", self.base_name(ty), parts.join(", "))
    }

    fn user_call(&mut self, ty: Type, depth: u32) -> Option<String> {
        let mut known: Vec<Function> = self.functions.clone();
        known.retain(|f| f.returns == ty && self.scope_of(&f.name) == Some(0));
        let at = self.below(known.len());
        if self.constant || at >= known.len() {
            return None;
        }
        let function = known.swap_remove(at);
        self.call_of(&function, depth)
    }

    pub(super) fn call_of(&mut self, function: &Function, depth: u32) -> Option<String> {
        let mut args = Vec::new();
        for &(way, ty) in &function.params {
            args.push(match way {
                _ if self.holds_sampler(ty) => self.sampler_path(ty)?,
                Way::In => self.expression(ty, depth),
                _ => self.place(ty)?,
            });
        }
        Some(self.call_text(function.name.clone(), args))
    }

    /// Components, an element or a member of a larger value.
    fn part(&mut self, ty: Type, depth: u32) -> Option<String> {
        if let Some((scalar, 1, rows)) = ty.numeric() {
            let rest = self.below(3);
            if rest == 0 && rows > 1 && scalar == Scalar::Float {
                let columns = if self.is_300 {
                    self.below(3) as u8 + 2
                } else {
                    rows
                };
                let matrix = self.expression(Type::matrix(columns, rows), depth);
                return Some(format!("({matrix})[{}]", self.index(columns as u32)));
            }
            let size = self.below(3) as u8 + 2;
            let vector = self.expression(Type::vector(scalar, size), depth);
            if rest == 1 && rows == 1 {
                return Some(format!("({vector})[{}]", self.index(size as u32)));
            }
            return Some(format!("({vector}).{}", self.swizzle(size, rows)));
        }
        if self.is_300 && !ty.is_array() && self.one_in(2) {
            let size = self.below(3) as u32 + 1;
            let array = self.constructor(ty.array_of(size), depth);
            return Some(format!("{array}[{}]", self.index(size)));
        }
        None
    }

    fn swizzle(&mut self, size: u8, count: u8) -> String {
        let set = ["xyzw", "rgba", "stpq"][self.below(3)].as_bytes();
        let size = if self.mistake() { 4 } else { size as usize };
        (0..count).map(|_| set[self.below(size)] as char).collect()
    }

    fn comma(&mut self, ty: Type, depth: u32) -> Option<String> {
        let is_plain = !self.holds_array(ty) && (!self.is_300 || !self.constant);
        if !is_plain && !self.mistake() {
            return None;
        }
        let before = loop {
            let ty = self.plain_type();
            if !self.holds_array(ty) {
                break ty;
            }
        };
        let before = self.expression(before, depth);
        Some(format!("({before}, {})", self.expression(ty, depth)))
    }

    fn assignment(&mut self, ty: Type, depth: u32) -> Option<String> {
        if self.constant || (!self.is_300 && self.holds_array(ty)) {
            return None;
        }
        let place = self.place(ty)?;
        Some(format!("({})", self.assign_to(&place, ty, depth)))
    }

    /// `place op= value`
    pub(super) fn assign_to(&mut self, place: &str, ty: Type, depth: u32) -> String {
        let scalar = ty.scalar_kind();
        let (op, value) = match scalar {
            Some(Scalar::Bool) | None => ("=", ty),
            Some(_) if self.one_in(2) => ("=", ty),
            Some(s) if s.is_integer() && self.is_300 && self.one_in(2) => {
                (self.pick(&["%=", "&=", "|=", "^=", "<<=", ">>="]), ty)
            }
            Some(s) if self.one_in(2) => (self.pick(&["+=", "-=", "*=", "/="]), Type::scalar(s)),
            Some(_) if ty.is_matrix() && !matches!(ty.numeric(), Some((_, c, r)) if c == r) => {
                (self.pick(&["+=", "-="]), ty)
            }
            Some(_) => (self.pick(&["+=", "-=", "*="]), ty),
        };
        format!("{place} {op} {}", self.expression(value, depth))
    }
}
