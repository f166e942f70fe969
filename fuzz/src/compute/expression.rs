//! Expressions with known values.

use super::{Kind, LONGEST, Type, Way, Writer};

/// Floats up to this magnitude are exact integers, and so are their sums.
const EXACT: u64 = 1 << 22;
/// Largest magnitude of a stored float.
const STORED: u64 = 64;

/// An expression, with the largest magnitude of its floats.
pub(super) struct Value {
    pub text: String,
    most: u64,
}

impl Value {
    fn new(text: impl Into<String>, most: u64) -> Value {
        Value {
            text: text.into(),
            most,
        }
    }
}

impl Writer {
    /// An expression whose floats are small enough to be stored.
    pub(super) fn value(&mut self, ty: Type, depth: usize) -> String {
        let value = self.expression(ty, depth);
        self.within(value, STORED, ty).text
    }

    /// The value itself if its floats are at most `most`, otherwise reduced to that range.
    fn within(&mut self, value: Value, most: u64, ty: Type) -> Value {
        if value.most <= most || ty.kind != Kind::Float || !ty.is_plain() {
            return value;
        }
        Value::new(format!("W({})", value.text), STORED)
    }

    fn expression(&mut self, ty: Type, depth: usize) -> Value {
        let may_call = depth > 0 && self.one_in(6);
        if let Some(call) = may_call.then(|| self.call(ty, depth)).flatten() {
            return Value::new(call, STORED);
        }
        if !ty.is_plain() || depth == 0 || self.one_in(8) {
            return self.leaf(ty, depth);
        }
        if self.one_in(8) {
            let condition = self.value(Type::scalar(Kind::Bool), depth - 1);
            let yes = self.expression(ty, depth - 1);
            let no = self.expression(ty, depth - 1);
            let text = format!("({condition} ? {} : {})", yes.text, no.text);
            return Value::new(text, yes.most.max(no.most));
        }
        match ty.kind {
            Kind::Bool => Value::new(self.truth(ty, depth - 1), 1),
            Kind::Int | Kind::Uint => Value::new(self.integer(ty, depth - 1), 0),
            Kind::Float => self.float(ty, depth - 1),
        }
    }

    /// A variable, a component of one, or a literal.
    fn leaf(&mut self, ty: Type, depth: usize) -> Value {
        let path = (!self.one_in(5))
            .then(|| self.path(ty, false, depth.min(1)))
            .flatten();
        match path {
            Some(text) => Value::new(text, STORED),
            None => Value::new(self.literal(ty, depth), STORED),
        }
    }

    /// A variable of the type, or a component of one that has the type.
    pub(super) fn path(&mut self, expected: Type, written: bool, depth: usize) -> Option<String> {
        for _ in 0..8 {
            let at = self.below(self.variables.len());
            let variable = self.variables.get(at)?.clone();
            if written && !variable.is_written {
                continue;
            }
            let (mut text, mut ty) = (variable.name, variable.ty);
            while ty != expected {
                let Some((part, of)) = self.part(&text, ty, expected, depth) else {
                    break;
                };
                (text, ty) = (part, of);
            }
            if ty == expected {
                return Some(text);
            }
        }
        None
    }

    /// A component of something: an element, member, column or swizzle.
    fn part(
        &mut self,
        text: &str,
        ty: Type,
        expected: Type,
        depth: usize,
    ) -> Option<(String, Type)> {
        if ty.array > 0 {
            let at = self.index(ty.array, depth);
            return Some((format!("{text}[{at}]"), ty.element()));
        }
        if let Some(record) = ty.record {
            let at = self.below(self.records[record].len());
            return Some((format!("{text}.m{at}"), self.records[record][at]));
        }
        if ty.columns > 1 {
            let at = self.index(ty.columns, depth);
            return Some((format!("{text}[{at}]"), Type::vector(ty.kind, ty.rows)));
        }
        if ty.rows == 1 || expected.kind != ty.kind || !expected.is_plain() || expected.columns > 1
        {
            return None;
        }
        if expected.rows == 1 && self.one_in(2) {
            let at = self.index(ty.rows, depth);
            return Some((format!("{text}[{at}]"), Type::scalar(ty.kind)));
        }
        (expected.rows <= ty.rows).then(|| {
            let lanes = self.lanes(ty.rows, expected.rows);
            (format!("{text}.{lanes}"), expected)
        })
    }

    /// A swizzle without repeated components.
    fn lanes(&mut self, of: usize, count: usize) -> String {
        let set = self.pick(&["xyzw", "rgba", "stpq"]);
        let mut left: Vec<char> = set.chars().take(of).collect();
        (0..count)
            .map(|_| left.remove(self.random.below(left.len())))
            .collect()
    }

    /// An index less than `size`.
    fn index(&mut self, size: usize, depth: usize) -> String {
        if depth == 0 || self.one_in(3) {
            return self.below(size).to_string();
        }
        let int = self.value(Type::scalar(Kind::Int), depth - 1);
        match size {
            2 | 4 | 8 => format!("{int} & {}", size - 1),
            _ => format!("int(uint({int}) % {size}u)"),
        }
    }

    fn literal(&mut self, ty: Type, depth: usize) -> String {
        let depth = depth.saturating_sub(1);
        let name = ty.name();
        if ty.array > 0 {
            let all: Vec<String> = (0..ty.array)
                .map(|_| self.value(ty.element(), depth))
                .collect();
            return format!("{name}({})", all.join(", "));
        }
        if let Some(record) = ty.record {
            let fields = self.records[record].clone();
            let all: Vec<String> = fields.iter().map(|ty| self.value(*ty, depth)).collect();
            return format!("{name}({})", all.join(", "));
        }
        if ty.columns == 1 && ty.rows == 1 {
            return self.number(ty.kind);
        }
        if self.one_in(3) {
            let one = self.value(Type::scalar(ty.kind), depth);
            return format!("{name}({one})");
        }
        let mut left = ty.columns * ty.rows;
        let mut all = Vec::new();
        while left > 0 {
            let rows = (self.below(3) + 1).min(left);
            let value = self.value(Type::vector(ty.kind, rows), depth.min(1));
            all.push(value);
            left -= rows;
        }
        format!("{name}({})", all.join(", "))
    }

    fn number(&mut self, kind: Kind) -> String {
        let small = self.below(19) as i32 - 9;
        match kind {
            Kind::Bool => self.pick(&["true", "false"]).to_string(),
            Kind::Int => match self.below(6) {
                0 => self
                    .pick(&["0x7fffffff", "(-0x7fffffff)", "0x55aa", "(1 << 20)"])
                    .to_string(),
                _ => format!("({small})"),
            },
            Kind::Uint => match self.below(6) {
                0 => self
                    .pick(&["0xffffffffu", "0x80000000u", "1664525u"])
                    .to_string(),
                _ => format!("{}u", small.unsigned_abs()),
            },
            Kind::Float => format!("({small}.0)"),
        }
    }

    /// An expression of another scalar type, converted.
    fn converted(&mut self, ty: Type, from: Kind, depth: usize) -> String {
        let value = self.value(Type { kind: from, ..ty }, depth);
        match (from, ty.kind) {
            (Kind::Int, Kind::Float) => format!("{}({value} & 63)", ty.name()),
            (Kind::Uint, Kind::Float) => format!("{}({value} & 63u)", ty.name()),
            // Unsigned integers are never negative.
            (Kind::Float, Kind::Uint) => format!("{}(abs({value}))", ty.name()),
            _ => format!("{}({value})", ty.name()),
        }
    }

    fn truth(&mut self, ty: Type, depth: usize) -> String {
        let kind = self.pick(&[Kind::Int, Kind::Uint, Kind::Float]);
        if ty.rows > 1 {
            let of = Type::vector(kind, ty.rows);
            let (x, y) = (self.value(of, depth), self.value(of, depth));
            let names = [
                "lessThan",
                "lessThanEqual",
                "greaterThan",
                "equal",
                "notEqual",
            ];
            return match self.below(5) {
                0 => format!("not({})", self.value(ty, depth)),
                _ => format!("{}({x}, {y})", self.pick(&names)),
            };
        }
        match self.below(8) {
            0 => format!("(!{})", self.value(ty, depth)),
            1 => {
                let (x, y) = (self.value(ty, depth), self.value(ty, depth));
                format!("({x} {} {y})", self.pick(&["&&", "||", "^^", "==", "!="]))
            }
            2 => {
                // The right operand may have side effects or be skipped.
                let x = self.value(ty, depth);
                let step = self.step().unwrap_or("1".to_string());
                let op = self.pick(&["&&", "||"]);
                format!("({x} {op} ({step}) > {})", self.below(9))
            }
            3 => {
                let rows = self.below(3) + 2;
                let all = self.value(Type::vector(Kind::Bool, rows), depth);
                format!("{}({all})", self.pick(&["any", "all"]))
            }
            4 => {
                let mut of = self.value_type();
                if of.record.is_some() {
                    of = of.element();
                }
                let (x, y) = (self.value(of, depth), self.value(of, depth));
                format!("({x} {} {y})", self.pick(&["==", "!="]))
            }
            5 => self.converted(ty, kind, depth),
            _ => {
                let of = Type::scalar(kind);
                let (x, y) = (self.value(of, depth), self.value(of, depth));
                format!(
                    "({x} {} {y})",
                    self.pick(&["<", "<=", ">", ">=", "==", "!="])
                )
            }
        }
    }

    /// `x++` and the like, for an integer.
    pub(super) fn step(&mut self) -> Option<String> {
        let place = self.path(Type::scalar(Kind::Int), true, 0)?;
        Some(match self.below(4) {
            0 => format!("{place}++"),
            1 => format!("--{place}"),
            2 => format!("{place} += 3"),
            _ => format!("++{place}"),
        })
    }

    fn integer(&mut self, ty: Type, depth: usize) -> String {
        let one = Type::scalar(ty.kind);
        let other = if self.one_in(3) { one } else { ty };
        let is_signed = ty.kind == Kind::Int;
        match self.below(9) {
            0 => {
                let kinds = [
                    Kind::Bool,
                    Kind::Float,
                    if is_signed { Kind::Uint } else { Kind::Int },
                ];
                let from = self.pick(&kinds);
                self.converted(ty, from, depth)
            }
            1 => format!("{}({})", self.pick(&["-", "~", "+"]), self.value(ty, depth)),
            2 => {
                let (x, by) = (self.value(ty, depth), self.below(40));
                match self.below(3) {
                    0 => format!("({x} {} {})", self.pick(&["<<", ">>"]), by % 32),
                    _ => {
                        let by = self.value(other, depth);
                        format!(
                            "({x} {} ({by} & {}))",
                            self.pick(&["<<", ">>"]),
                            if is_signed { "31" } else { "31u" }
                        )
                    }
                }
            }
            3 => {
                let (x, y) = (self.value(ty, depth), self.value(other, depth));
                let name = self.pick(&["min", "max"]);
                format!("{name}({x}, {y})")
            }
            4 if is_signed => format!("{}({})", self.pick(&["abs", "sign"]), self.value(ty, depth)),
            5 => {
                // The remainder of negative operands is undefined.
                let (x, y) = (self.value(ty, depth), self.value(other, depth));
                match (is_signed, self.below(2)) {
                    (true, 0) => format!("(({x} & 0xffff) % (({y} & 255) | 1))"),
                    (true, _) => format!("({x} / (({y} & 255) | 1))"),
                    (false, 0) => format!("({x} % ({y} | 1u))"),
                    (false, _) => format!("({x} / ({y} | 1u))"),
                }
            }
            6 if ty.rows == 1 => {
                let text = self.converted(Type::scalar(Kind::Float), Kind::Int, depth);
                let name = if is_signed {
                    "floatBitsToInt"
                } else {
                    "floatBitsToUint"
                };
                format!("{name}(abs({text}) + 1.0)")
            }
            _ => {
                let (x, y) = (self.value(ty, depth), self.value(other, depth));
                let (x, y) = if self.one_in(4) { (y, x) } else { (x, y) };
                format!("({x} {} {y})", self.pick(&["+", "-", "*", "&", "|", "^"]))
            }
        }
    }

    fn float(&mut self, ty: Type, depth: usize) -> Value {
        let one = Type::scalar(Kind::Float);
        if ty.columns > 1 {
            return self.matrix(ty, depth);
        }
        let other = if self.one_in(3) { one } else { ty };
        match self.below(9) {
            0 => {
                let from = self.pick(&[Kind::Bool, Kind::Int, Kind::Uint]);
                Value::new(self.converted(ty, from, depth), STORED)
            }
            1 => {
                let x = self.expression(ty, depth);
                let name = self.pick(&["abs", "sign", "-", "floor", "trunc", "ceil", "round"]);
                Value::new(format!("{name}({})", x.text), x.most.max(1))
            }
            2 => {
                let (x, y) = (self.expression(ty, depth), self.expression(other, depth));
                let name = self.pick(&["min", "max"]);
                Value::new(
                    format!("{name}({}, {})", x.text, y.text),
                    x.most.max(y.most),
                )
            }
            3 => {
                let x = self.value(ty, depth);
                let by = self.pick(&["2.0", "4.0", "8.0"]);
                let text = match self.below(3) {
                    0 => format!("floor({x} / {by})"),
                    1 => format!("mod({x}, {by})"),
                    _ => format!("(fract({x} / {by}) * {by})"),
                };
                Value::new(text, STORED)
            }
            4 => {
                let (x, y, z) = (
                    self.value(ty, depth),
                    self.value(ty, depth),
                    self.value(ty.with_bools(), depth),
                );
                Value::new(format!("mix({x}, {y}, {z})"), STORED)
            }
            5 => {
                let (x, y) = (self.value(ty, depth), self.value(ty, depth));
                match ty.rows {
                    3 => Value::new(format!("cross({x}, {y})"), 2 * STORED * STORED),
                    1 => {
                        let of = Type::vector(Kind::Float, self.below(3) + 2);
                        let (x, y) = (self.value(of, depth), self.value(of, depth));
                        Value::new(format!("dot({x}, {y})"), 4 * STORED * STORED)
                    }
                    _ => Value::new(format!("step({x}, {y})"), 1),
                }
            }
            6 if ty.rows > 1 => {
                let inner = self.below(3) + 2;
                let vector = self.value(Type::vector(Kind::Float, inner), depth);
                let text = match self.below(2) {
                    0 => format!(
                        "({} * {vector})",
                        self.value(Type::matrix(inner, ty.rows), depth)
                    ),
                    _ => format!(
                        "({vector} * {})",
                        self.value(Type::matrix(ty.rows, inner), depth)
                    ),
                };
                Value::new(text, 4 * STORED * STORED)
            }
            _ => self.sum(ty, other, depth),
        }
    }

    fn sum(&mut self, ty: Type, other: Type, depth: usize) -> Value {
        let (x, y) = (self.expression(ty, depth), self.expression(other, depth));
        let op = self.pick(&["+", "-", "*"]);
        let limit = if op == "*" { 1 << 11 } else { EXACT / 2 };
        let x = self.within(x, limit, ty);
        let y = self.within(y, limit, other);
        let most = if op == "*" {
            x.most * y.most
        } else {
            x.most + y.most
        };
        let (x, y) = if self.one_in(4) { (y, x) } else { (x, y) };
        Value::new(format!("({} {op} {})", x.text, y.text), most)
    }

    fn matrix(&mut self, ty: Type, depth: usize) -> Value {
        match self.below(6) {
            0 => {
                let transposed = Type::matrix(ty.rows, ty.columns);
                let x = self.expression(transposed, depth);
                Value::new(format!("transpose({})", x.text), x.most)
            }
            1 => {
                let (x, y) = (self.value(ty, depth), self.value(ty, depth));
                Value::new(format!("matrixCompMult({x}, {y})"), STORED * STORED)
            }
            2 => {
                let column = self.value(Type::vector(Kind::Float, ty.rows), depth);
                let row = self.value(Type::vector(Kind::Float, ty.columns), depth);
                Value::new(format!("outerProduct({column}, {row})"), STORED * STORED)
            }
            3 => {
                let inner = self.below(3) + 2;
                let x = self.value(Type::matrix(inner, ty.rows), depth);
                let y = self.value(Type::matrix(ty.columns, inner), depth);
                Value::new(format!("({x} * {y})"), 4 * STORED * STORED)
            }
            4 => {
                let from = Type::matrix(self.below(3) + 2, self.below(3) + 2);
                let x = self.value(from, depth);
                Value::new(format!("{}({x})", ty.name()), STORED)
            }
            _ => {
                let (x, y) = (self.expression(ty, depth), self.expression(ty, depth));
                let x = self.within(x, EXACT / 2, ty);
                let y = self.within(y, EXACT / 2, ty);
                let op = self.pick(&["+", "-"]);
                Value::new(format!("({} {op} {})", x.text, y.text), x.most + y.most)
            }
        }
    }

    /// A call of a function that returns the type.
    pub(super) fn call(&mut self, returns: Type, depth: usize) -> Option<String> {
        let fitting: Vec<usize> = (0..self.functions.len())
            .filter(|f| self.functions[*f].returns == Some(returns))
            .collect();
        // A function called in a loop may contain a loop itself.
        if fitting.is_empty() || self.loops > 1 {
            return None;
        }
        let function = self.pick(&fitting);
        self.call_of(function, depth)
    }

    pub(super) fn call_of(&mut self, function: usize, depth: usize) -> Option<String> {
        let function = self.functions[function].clone();
        if self.called + function.size > LONGEST {
            return None;
        }
        let (mut args, mut written) = (Vec::new(), Vec::new());
        for (way, ty) in &function.params {
            args.push(match way {
                Way::In => self.value(*ty, depth.saturating_sub(1)),
                Way::Out | Way::Inout => {
                    let place = self.path(*ty, true, 0)?;
                    let root = |text: &str| text.split(['.', '[']).next().map(str::to_string);
                    // The order of two writes to one variable is unspecified.
                    if written.contains(&root(&place)) {
                        return None;
                    }
                    written.push(root(&place));
                    place
                }
            });
        }
        self.called += function.size;
        Some(format!("{}({})", function.name, args.join(", ")))
    }
}

impl Type {
    fn with_bools(self) -> Type {
        Type {
            kind: Kind::Bool,
            ..self
        }
    }
}
