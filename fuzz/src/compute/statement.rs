//! Statements, functions and complete programs.

use super::{Function, Kind, Type, Way, Writer};

/// Helpers that reduce floats to the stored range, and the output.
const HEAD: &str = "#version 300 es
precision highp float;
precision highp int;
uniform ivec4 seeds;
uniform vec4 parts;
out highp uvec4 drawn;
float W(float x) { return float((int(x) & 127) - 64); }
vec2 W(vec2 v) { return vec2(W(v.x), W(v.y)); }
vec3 W(vec3 v) { return vec3(W(v.x), W(v.y), W(v.z)); }
vec4 W(vec4 v) { return vec4(W(v.x), W(v.y), W(v.z), W(v.w)); }
mat2x2 W(mat2x2 m) { return mat2x2(W(m[0]), W(m[1])); }
mat2x3 W(mat2x3 m) { return mat2x3(W(m[0]), W(m[1])); }
mat2x4 W(mat2x4 m) { return mat2x4(W(m[0]), W(m[1])); }
mat3x2 W(mat3x2 m) { return mat3x2(W(m[0]), W(m[1]), W(m[2])); }
mat3x3 W(mat3x3 m) { return mat3x3(W(m[0]), W(m[1]), W(m[2])); }
mat3x4 W(mat3x4 m) { return mat3x4(W(m[0]), W(m[1]), W(m[2])); }
mat4x2 W(mat4x2 m) { return mat4x2(W(m[0]), W(m[1]), W(m[2]), W(m[3])); }
mat4x3 W(mat4x3 m) { return mat4x3(W(m[0]), W(m[1]), W(m[2]), W(m[3])); }
mat4x4 W(mat4x4 m) { return mat4x4(W(m[0]), W(m[1]), W(m[2]), W(m[3])); }
uint sum = 7u;
void mixIn(uint x) { sum = (sum ^ x) * 16777619u + (sum >> 13); }
";

impl Writer {
    pub(super) fn program(&mut self) -> String {
        let mut text = HEAD.to_string();
        self.declare("seeds", Type::vector(Kind::Int, 4), false);
        self.declare("parts", Type::vector(Kind::Float, 4), false);
        for _ in 0..self.below(3) {
            text.push_str(&self.record());
        }
        for _ in 0..self.below(4) {
            // Initialisers of globals are constant.
            let outer = std::mem::take(&mut self.variables);
            let text_of = self.declaration('g');
            text.push_str(&text_of);
            self.variables.splice(0..0, outer);
        }
        for _ in 0..self.below(4) {
            text.push_str(&self.function());
        }
        text.push_str("void main() {\nivec2 at = ivec2(gl_FragCoord.xy);\n");
        let globals = self.variables.len();
        self.declare("at", Type::vector(Kind::Int, 2), true);
        self.is_main = true;
        for _ in 0..self.below(3) + 2 {
            text.push_str(&self.statements(3));
        }
        text.push_str(&self.gather(globals));
        text + "drawn = uvec4(sum, at, sum >> 16);\n}\n"
    }

    /// Combines the final values of all variables into the output.
    fn gather(&mut self, globals: usize) -> String {
        let mut text = String::new();
        let seen = self.variables.clone();
        let ends = seen.iter().skip(2).take(globals.saturating_sub(2));
        for variable in ends.chain(seen.iter().skip(globals)) {
            self.gather_one(&variable.name, variable.ty, &mut text);
        }
        text
    }

    fn gather_one(&mut self, path: &str, ty: Type, text: &mut String) {
        if ty.array > 0 {
            for at in 0..ty.array {
                self.gather_one(&format!("{path}[{at}]"), ty.element(), text);
            }
        } else if let Some(record) = ty.record {
            for (at, ty) in self.records[record].clone().into_iter().enumerate() {
                self.gather_one(&format!("{path}.m{at}"), ty, text);
            }
        } else if ty.columns > 1 {
            for at in 0..ty.columns {
                let column = Type::vector(ty.kind, ty.rows);
                self.gather_one(&format!("{path}[{at}]"), column, text);
            }
        } else {
            for at in 0..ty.rows {
                let lane = if ty.rows == 1 {
                    String::new()
                } else {
                    format!("[{at}]")
                };
                let scalar = match ty.kind {
                    Kind::Float => format!("uint(int({path}{lane}))"),
                    _ => format!("uint({path}{lane})"),
                };
                text.push_str(&format!("mixIn({scalar});\n"));
            }
        }
    }

    fn record(&mut self) -> String {
        let mut fields = Vec::new();
        let mut text = format!("struct S{} {{\n", self.records.len());
        for at in 0..self.below(3) + 1 {
            let ty = self.value_type();
            // Structs contain scalars, vectors, matrices and arrays of these.
            let ty = if ty.record.is_some() {
                self.plain_type()
            } else {
                ty
            };
            text.push_str(&format!("    {} m{at};\n", ty.name()));
            fields.push(ty);
        }
        self.records.push(fields);
        text + "};\n"
    }

    fn function(&mut self) -> String {
        let outer = self.variables.len();
        let mut params = Vec::new();
        let mut head = Vec::new();
        for _ in 0..self.below(4) {
            let way = self.pick(&[Way::In, Way::In, Way::Out, Way::Inout]);
            let ty = self.value_type();
            let name = self.new_name('p');
            let word = match way {
                Way::In => "",
                Way::Out => "out ",
                Way::Inout => "inout ",
            };
            head.push(format!("{word}{} {name}", ty.name()));
            params.push((way, ty, name));
        }
        let mut text = String::new();
        // An `out` parameter is written before it is read.
        for (way, ty, name) in &params {
            if *way == Way::Out {
                let value = self.value(*ty, 1);
                text.push_str(&format!("{name} = {value};\n"));
            }
        }
        for (_, ty, name) in &params {
            self.declare(name, *ty, true);
        }
        let returns = (!self.one_in(4)).then(|| self.value_type());
        self.returns = returns;
        self.loops = 1;
        text.push_str(&self.statements(2));
        self.loops = 0;
        if let Some(ty) = returns {
            let value = self.value(ty, 2);
            text.push_str(&format!("return {value};\n"));
        }
        self.returns = None;
        self.variables.truncate(outer);
        let name = self.new_name('f');
        let word = returns.map_or("void".to_string(), Type::name);
        self.functions.push(Function {
            name: name.clone(),
            params: params.iter().map(|(way, ty, _)| (*way, *ty)).collect(),
            returns,
            size: text.len() + std::mem::take(&mut self.called),
        });
        format!("{word} {name}({}) {{\n{text}}}\n", head.join(", "))
    }

    /// `type name = value;`
    fn declaration(&mut self, letter: char) -> String {
        let ty = self.value_type();
        let value = self.value(ty, if letter == 'g' { 0 } else { 3 });
        let name = self.new_name(letter);
        self.declare(&name, ty, true);
        format!("{} {name} = {value};\n", ty.name())
    }

    /// Statements between braces.
    fn block(&mut self, depth: usize) -> String {
        let outer = self.variables.len();
        let text = self.statements(depth);
        self.variables.truncate(outer);
        format!("{{\n{text}}}\n")
    }

    fn statements(&mut self, depth: usize) -> String {
        let count = self.below(4) + 1;
        (0..count).map(|_| self.statement(depth)).collect()
    }

    fn statement(&mut self, depth: usize) -> String {
        match self.below(16) {
            0..=3 => self.declaration('v'),
            4..=7 => self.assignment(),
            8 => self.step().map_or(String::new(), |s| format!("{s};\n")),
            9 if self.loops < 2 && !self.functions.is_empty() => {
                let at = self.below(self.functions.len());
                self.call_of(at, 2)
                    .map_or(String::new(), |c| format!("{c};\n"))
            }
            10 | 11 if depth > 0 => self.branch(depth - 1),
            12 | 13 if depth > 0 && self.loops < 2 => self.repeat(depth - 1),
            14 if depth > 0 => self.switch(depth - 1),
            15 => self.jump(),
            _ => self.assignment(),
        }
    }

    fn assignment(&mut self) -> String {
        let ty = self.value_type();
        let Some(place) = self.path(ty, true, 1) else {
            return String::new();
        };
        let is_integer = matches!(ty.kind, Kind::Int | Kind::Uint) && ty.is_plain();
        if is_integer && self.one_in(2) {
            let op = self.pick(&["+=", "-=", "*=", "&=", "|=", "^="]);
            let of = if self.one_in(3) {
                Type::scalar(ty.kind)
            } else {
                ty
            };
            return format!("{place} {op} {};\n", self.value(of, 2));
        }
        format!("{place} = {};\n", self.value(ty, 3))
    }

    fn branch(&mut self, depth: usize) -> String {
        let condition = self.value(Type::scalar(Kind::Bool), 2);
        let mut text = format!("if ({condition}) {}", self.block(depth));
        if self.one_in(2) {
            text.push_str(&format!("else {}", self.block(depth)));
        }
        text
    }

    /// A loop of a few iterations: `for`, `while` or `do`.
    fn repeat(&mut self, depth: usize) -> String {
        let count = match self.below(2) {
            0 => (self.below(6) + 1).to_string(),
            _ => format!("({} & 7)", self.value(Type::scalar(Kind::Int), 1)),
        };
        let name = self.new_name('i');
        let outer = self.variables.len();
        self.declare(&name, Type::scalar(Kind::Int), false);
        self.loops += 1;
        let before = std::mem::replace(&mut self.is_breakable, true);
        let body = self.block(depth);
        let more = self.value(Type::scalar(Kind::Bool), 1);
        self.is_breakable = before;
        self.loops -= 1;
        self.variables.truncate(outer);
        match self.below(4) {
            // Not `int i = 0, n = 6`: Chromium 156 ends such a loop early if a nested loop executes
            // `continue`.
            0 => format!(
                "{{ int n{name} = {count};\nfor (int {name} = 0; {name} < n{name}; {name}++) {body}}}\n"
            ),
            1 => format!("for (int {name} = {count}; {name} > 0 && {more}; {name} -= 2) {body}"),
            2 => format!("{{ int {name} = {count};\nwhile ({name}-- > 0) {body}}}\n"),
            _ => format!("{{ int {name} = {count};\ndo {body} while (--{name} > 0);\n}}\n"),
        }
    }

    fn switch(&mut self, depth: usize) -> String {
        let selector = self.value(Type::scalar(Kind::Int), 2);
        let before = std::mem::replace(&mut self.is_breakable, true);
        let mut text = format!("switch ({selector} & 3) {{\n");
        let default_at = self.below(6);
        for label in 0..self.below(4) + 1 {
            if label == default_at {
                text.push_str("default:\n");
            }
            text.push_str(&format!("case {label}:\n{}", self.block(depth)));
            if !self.one_in(4) {
                text.push_str("break;\n");
            }
        }
        self.is_breakable = before;
        text + "}\n"
    }

    fn jump(&mut self) -> String {
        let condition = self.value(Type::scalar(Kind::Bool), 1);
        let jump = match self.below(4) {
            0 | 1 if self.is_breakable => "break;".to_string(),
            2 if self.is_breakable && self.loops > usize::from(!self.is_main) => {
                "continue;".to_string()
            }
            3 if self.is_main && self.one_in(3) => "discard;".to_string(),
            _ if !self.is_main => match self.returns {
                Some(ty) => format!("return {};", self.value(ty, 1)),
                None => "return;".to_string(),
            },
            _ => return String::new(),
        };
        format!("if ({condition}) {jump}\n")
    }
}
