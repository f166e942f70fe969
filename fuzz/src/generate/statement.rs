//! Statements.

use super::{Function, Scope, Use, Way, Writer};
use shaderlint::semantic::{Scalar, Type};

impl Writer {
    /// Statements between braces, in a new scope.
    fn block(&mut self, depth: u32) -> String {
        let inside = self.in_scope(|w| w.statements(depth));
        format!("{{\n{inside}}}\n")
    }

    /// A few statements in the current scope.
    pub(super) fn statements(&mut self, depth: u32) -> String {
        let count = self.below(4) + 1;
        (0..count).map(|_| self.statement(depth)).collect()
    }

    fn statement(&mut self, depth: u32) -> String {
        if self.mistake() {
            return self.misplaced();
        }
        let nests = depth > 0;
        match self.below(18) {
            0..=3 => self.local(),
            4..=7 => self.assignment_statement(),
            8 => self.expression_statement(),
            9 => self.call_statement(),
            10 | 11 if nests => self.if_statement(depth - 1),
            12 if nests => self.for_loop(depth - 1),
            13 if nests && self.is_300 => self.while_loop(depth - 1),
            14 if nests && self.is_300 => self.switch(depth - 1),
            15 if nests => self.block(depth - 1),
            16 => self.jump(),
            _ => self.odd_statement(),
        }
    }

    fn misplaced(&mut self) -> String {
        let odd = [
            "break;\n",
            "continue;\n",
            "discard;\n",
            "return;\n",
            "return 1.0;\n",
            "case 1:\n",
            "default:\n",
            "uniform float u0;\n",
            "void f0();\n",
            "int[] a0;\n",
            "in vec4 a0;\n",
            "struct { int; };\n",
            "else {}\n",
            "while (true) {}\n",
            "for (;;) {}\n",
            "if (1) {}\n",
            "gl_FragColor = vec4(1.0);\n",
            "gl_Position;\n",
            "precision highp bool;\n",
            "precision highp vec2;\n",
            "main();\n",
            "{\n",
            "}\n",
        ];
        self.pick(&odd).to_string()
    }

    /// Statements with no or little effect.
    fn odd_statement(&mut self) -> String {
        match self.below(7) {
            0 => ";\n".to_string(),
            1 => "precision mediump float;\n".to_string(),
            2 => "precision highp int;\n".to_string(),
            3 => self.record(),
            4 => "{}\n".to_string(),
            5 if self.is_300 => {
                self.unsure();
                "int;\n".to_string()
            }
            _ => "if (false) {}\n".to_string(),
        }
    }

    /// `type name = value, name = value;`
    fn local(&mut self) -> String {
        let is_const = self.one_in(4);
        let mut ty = self.value_type();
        if !self.is_300 && self.holds_array(ty) && (is_const || !ty.is_array()) {
            ty = self.numeric_type();
        }
        let has_value = is_const || (self.one_in(2) && (self.is_300 || !ty.is_array()));
        let head = format!(
            "{}{}",
            if is_const { "const " } else { "" },
            self.precision(ty)
        );
        let value = |w: &mut Writer| match (is_const, has_value) {
            (true, _) => format!(" = {}", w.constantly(|w| w.expression(ty, 2))),
            (_, true) => format!(" = {}", w.expression(ty, 3)),
            _ => String::new(),
        };
        let usage = if is_const { Use::Constant } else { Use::Free };
        let first = value(self);
        let name = self.new_name("v");
        let mut text = format!("{head}{}{first}", self.typed(ty, &name));
        self.declare(&name, ty, usage);
        if !ty.is_array() && self.one_in(6) {
            let second = value(self);
            let name = self.new_name("v");
            text.push_str(&format!(", {name}{second}"));
            self.declare(&name, ty, usage);
        }
        text + ";\n"
    }

    fn assignment_statement(&mut self) -> String {
        let Some(ty) = self.place_type() else {
            return ";\n".to_string();
        };
        if self.holds_sampler(ty) || (!self.is_300 && self.holds_array(ty)) {
            return ";\n".to_string();
        }
        match self.place(ty) {
            Some(place) => format!("{};\n", self.assign_to(&place, ty, 3)),
            None => ";\n".to_string(),
        }
    }

    fn expression_statement(&mut self) -> String {
        let ty = self.plain_type();
        format!("{};\n", self.expression(ty, 3))
    }

    fn call_statement(&mut self) -> String {
        let mut known: Vec<Function> = self.functions.clone();
        known.retain(|f| self.scope_of(&f.name) == Some(0));
        let at = self.below(known.len());
        let call = known.get(at).cloned().and_then(|f| self.call_of(&f, 2));
        call.map_or(";\n".to_string(), |c| format!("{c};\n"))
    }

    fn if_statement(&mut self, depth: u32) -> String {
        let condition = self.expression(Type::BOOL, 2);
        let mut text = format!("if ({condition}) {}", self.branch(depth));
        if self.one_in(3) {
            text.push_str(&format!("else {}", self.branch(depth)));
        }
        text
    }

    /// The body of a branch: a block, or one statement.
    fn branch(&mut self, depth: u32) -> String {
        match self.below(4) {
            0 => self.in_scope(|w| w.expression_statement()),
            1 => self.in_scope(|w| w.assignment_statement()),
            _ => self.block(depth),
        }
    }

    /// The body of a loop; a block shares the scope of the loop's header.
    fn body(&mut self, depth: u32) -> String {
        self.loops += 1;
        let text = match self.below(4) {
            0 => self.expression_statement(),
            _ => format!("{{\n{}}}\n", self.statements(depth)),
        };
        self.loops -= 1;
        text
    }

    fn for_loop(&mut self, depth: u32) -> String {
        if !self.is_300 {
            return self.old_loop(depth);
        }
        self.in_scope(|w| {
            let (init, condition) = match w.below(4) {
                0 => (w.expression_statement(), w.moving_condition()),
                1 => (w.local(), w.moving_condition()),
                _ => {
                    let from = w.expression(Type::INT, 1);
                    let name = w.new_name("i");
                    w.declare(&name, Type::INT, Use::Free);
                    let to = w.expression(Type::INT, 1);
                    (format!("int {name} = {from};\n"), format!("{name} < {to}"))
                }
            };
            let step = w.numeric_type();
            let step = w.expression(step, 2);
            let body = w.body(depth);
            format!("for ({init} {condition}; {step}) {body}")
        })
    }

    /// A condition that changes while the shader runs: a condition that is always true is rejected.
    fn moving_condition(&mut self) -> String {
        let Some(place) = self.place(Type::INT) else {
            return "false".to_string();
        };
        if self.one_in(6) {
            self.unsure();
            return self.expression(Type::BOOL, 2);
        }
        format!("{place} < {}", self.expression(Type::INT, 1))
    }

    fn while_loop(&mut self, depth: u32) -> String {
        if self.one_in(2) {
            let body = self.in_scope(|w| w.body(depth));
            let condition = self.expression(Type::BOOL, 2);
            return format!("do {body} while ({condition});\n");
        }
        let condition = self.moving_condition();
        let body = self.in_scope(|w| w.body(depth));
        format!("while ({condition}) {body}")
    }

    /// A loop in the form required by Appendix A of GLSL ES 1.00.
    fn old_loop(&mut self, depth: u32) -> String {
        let (ty, by) = [(Type::INT, "1"), (Type::FLOAT, "0.5")][self.below(2)];
        self.in_scope(|w| {
            let from = w.constantly(|w| w.expression(ty, 1));
            let name = w.new_name("i");
            w.declare(&name, ty, Use::Index);
            let to = w.constantly(|w| w.expression(ty, 1));
            let op = w.pick(&["<", ">", "<=", "!=", "=="]);
            let step = match w.below(4) {
                0 => format!("{name}++"),
                1 => format!("--{name}"),
                2 => format!("{name} -= {by}"),
                _ => format!("{name} += {by}"),
            };
            let type_name = w.type_name(ty);
            let body = w.body(depth);
            format!("for ({type_name} {name} = {from}; {name} {op} {to}; {step}) {body}")
        })
    }

    fn switch(&mut self, depth: u32) -> String {
        let scalar = [Scalar::Int, Scalar::Uint][self.below(2)];
        let selector = self.expression(Type::scalar(scalar), 2);
        self.scopes.push(Scope::default());
        self.switches += 1;
        let mut text = format!("switch ({selector}) {{\n");
        let count = self.below(4);
        let default_at = self.below(6);
        for i in 0..count {
            let label = self.label(i, scalar);
            text.push_str(if i == default_at {
                "default:\n"
            } else {
                &label
            });
            match self.below(5) {
                0 => {}
                1 => text.push_str("break;\n"),
                _ => text.push_str(&self.statements(depth)),
            }
        }
        if count > 0 && !self.mistake() {
            text.push_str(self.pick(&["break;\n", "return_\n", ";\n", "{}\n"]));
        }
        self.switches -= 1;
        self.scopes.pop();
        // `return` needs a value of the function's type.
        if text.contains("return_\n") {
            let jump = self.return_statement();
            text = text.replace("return_\n", &jump);
        }
        text + "}\n"
    }

    fn label(&mut self, at: usize, scalar: Scalar) -> String {
        if self.mistake() {
            let odd = ["case 0:", "case 1.0:", "case true:", "case v1:", "case 1u:"];
            return self.pick(&odd).to_string();
        }
        let suffix = if scalar == Scalar::Uint { "u" } else { "" };
        match self.below(3) {
            0 => format!("case {at}{suffix} + 10{suffix}:\n"),
            _ => format!("case {at}{suffix}:\n"),
        }
    }

    fn jump(&mut self) -> String {
        match self.below(4) {
            0 if self.loops > 0 || self.switches > 0 => "break;\n".to_string(),
            1 if self.loops > 0 => "continue;\n".to_string(),
            2 if self.is_fragment() => "discard;\n".to_string(),
            _ => self.return_statement(),
        }
    }

    fn return_statement(&mut self) -> String {
        let ty = self.returns;
        if ty.is_void() {
            return "return;\n".to_string();
        }
        format!("return {};\n", self.expression(ty, 2))
    }

    pub(super) fn function(&mut self) -> String {
        let returns = if self.one_in(3) {
            Type::VOID
        } else {
            self.plain_type()
        };
        let name = self.new_name("f");
        let mut params = Vec::new();
        let mut named = Vec::new();
        for _ in 0..self.below(4) {
            let (text, name, param) = self.parameter();
            named.push((text, name, param));
            params.push(param);
        }
        let precision = self.precision(returns);
        let head: Vec<&str> = named.iter().map(|n| n.0.as_str()).collect();
        let head = format!(
            "{precision}{} {name}({})",
            self.type_name(returns),
            head.join(", ")
        );
        let mut text = String::new();
        if self.one_in(6) {
            text.push_str(&format!("{head};\n"));
        }
        // A function is visible in its own body, but recursion is rejected: it is called only after
        // its definition.
        self.take_name(&name);
        self.returns = returns;
        let body = self.in_scope(|w| {
            for (_, name, (way, ty)) in &named {
                let usage = match way {
                    _ if w.holds_sampler(*ty) => Use::Read,
                    _ => Use::Free,
                };
                w.declare(name, *ty, usage);
            }
            let mut body = w.statements(3);
            if !returns.is_void() && !w.mistake() {
                body.push_str(&w.return_statement());
            }
            body
        });
        self.functions.push(Function {
            name,
            params,
            returns,
        });
        format!("{text}{head} {{\n{body}}}\n")
    }

    /// A parameter: its text, its name, and its qualifier and type.
    fn parameter(&mut self) -> (String, String, (Way, Type)) {
        self.names += 1;
        let name = format!("p{}", self.names);
        if self.one_in(8) {
            let ty = Type::sampler(self.sampler());
            let text = format!("{} {name}", self.type_name(ty));
            return (text, name, (Way::In, ty));
        }
        let ty = self.plain_type();
        let (word, way) = match self.below(6) {
            0 => ("out ", Way::Out),
            1 => ("inout ", Way::Inout),
            2 => ("in ", Way::In),
            _ => ("", Way::In),
        };
        let word = if self.mistake() {
            self.pick(&["uniform ", "const out ", "flat ", "in in ", "highp in "])
        } else {
            word
        };
        let precision = self.precision(ty);
        let text = format!("{word}{precision}{}", self.typed(ty, &name));
        (text, name, (way, ty))
    }
}
