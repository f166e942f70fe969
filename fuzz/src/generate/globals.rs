//! Declarations outside functions.

use super::{Record, Use, Variable, Writer};
use shaderlint::semantic::{Base, Scalar, Type};

impl Writer {
    pub(super) fn program(&mut self) -> String {
        let mut text = String::new();
        if self.is_300 {
            text.push_str("#version 300 es\n");
        }
        text.push_str(self.extension());
        text.push_str(&self.default_precisions());
        text.push_str(&self.outputs());
        if !self.is_fragment() && self.one_in(8) {
            text.push_str("invariant gl_Position;\n");
        }
        for _ in 0..self.below(9) + 2 {
            let item = self.item();
            text.push_str(&item);
        }
        for _ in 0..self.below(4) {
            let function = self.function();
            text.push_str(&function);
            if self.one_in(5) {
                let item = self.item();
                text.push_str(&item);
            }
        }
        self.returns = Type::VOID;
        let name = if self.mistake() { "mian" } else { "main" };
        let body = self.in_scope(|w| w.statements(3) + &w.statements(3));
        text + &format!("void {name}() {{\n{body}}}\n")
    }

    fn extension(&mut self) -> &'static str {
        if self.mistake() {
            return self.pick(&[
                "#extension GL_OES_standard_derivatives : require\n",
                "#extension GL_EXT_frag_depth : enable\n",
                "#extension GL_FOO : require\n",
                "#extension all : enable\n",
            ]);
        }
        match self.below(12) {
            0 => "#extension GL_OES_standard_derivatives : disable\n",
            1 => "#extension all : warn\n",
            _ => "",
        }
    }

    fn default_precisions(&mut self) -> String {
        let mut text = String::new();
        if self.is_fragment() && !self.mistake() {
            text.push_str("precision highp float;\n");
        }
        if self.is_300 && !self.mistake() {
            for name in ["sampler3D", "sampler2DArray", "isampler2D", "usampler2D"] {
                text.push_str(&format!("precision mediump {name};\n"));
            }
            text.push_str("precision lowp sampler2DShadow;\n");
        }
        text
    }

    /// The outputs of the stage.
    fn outputs(&mut self) -> String {
        if !self.is_fragment() {
            self.declare("gl_Position", Type::vector(Scalar::Float, 4), Use::Free);
            return String::new();
        }
        if !self.is_300 {
            self.declare("gl_FragColor", Type::vector(Scalar::Float, 4), Use::Free);
            return String::new();
        }
        let count = self.below(3) + 1;
        let mut text = String::new();
        for at in 0..count {
            let scalar = [Scalar::Float, Scalar::Float, Scalar::Int, Scalar::Uint][self.below(4)];
            let ty = Type::vector(scalar, self.below(4) as u8 + 1);
            let name = self.new_name("o");
            let layout = match (self.mistake(), count) {
                (true, _) => format!("layout(location = {}) ", self.below(10)),
                (_, 1) if self.one_in(2) => String::new(),
                _ => format!("layout(location = {at}) "),
            };
            let precision = self.precision(ty);
            text.push_str(&format!(
                "{layout}out {precision}{};\n",
                self.typed(ty, &name)
            ));
            self.declare(&name, ty, Use::Free);
        }
        text
    }

    fn item(&mut self) -> String {
        match self.below(12) {
            0 | 1 => self.record(),
            2 | 3 => self.global(),
            4 => self.constant_global(),
            5 | 6 => self.uniform(),
            7 | 8 => self.sampler_uniform(),
            9 => self.varying(),
            10 if self.is_300 => self.interface_block(),
            11 if !self.is_fragment() && self.one_in(4) && self.mistake() => {
                "invariant gl_Position;\n".to_string()
            }
            _ if self.mistake() => self.odd_item(),
            _ => self.uniform(),
        }
    }

    fn odd_item(&mut self) -> String {
        let odd = [
            ";\n",
            "float;\n",
            "void x0;\n",
            "attribute vec4 x0;\n",
            "varying vec4 x0;\n",
            "layout(row_major) uniform;\n",
            "layout(std140) uniform vec4 x0;\n",
            "invariant x0;\n",
            "const float x0;\n",
            "uniform float x0 = 1.0;\n",
            "in float x0 = 1.0;\n",
            "sampler2D x0;\n",
            "float x0[];\n",
            "void x0() {} void x0() {}\n",
            "float x0(); int x0();\n",
            "precision highp bool;\n",
            "flat uniform int x0;\n",
            "centroid float x0;\n",
            "shared float x0;\n",
            "uniform struct { int m; } x0;\n",
            "struct x0 { struct y0 { int m; } z; };\n",
        ];
        self.pick(&odd).to_string()
    }

    /// A struct declaration.
    pub(super) fn record(&mut self) -> String {
        let mut fields: Vec<(String, Type)> = Vec::new();
        for _ in 0..self.below(3) + 1 {
            let ty = self.value_type();
            let deep = matches!(ty.base, Base::Struct(_));
            // Structs nest at most four deep.
            let ty = if deep && self.one_in(2) {
                Type::INT
            } else {
                ty
            };
            let name = if self.mistake() {
                "m0".to_string()
            } else {
                format!("m{}", fields.len())
            };
            fields.push((name, ty));
        }
        let deep = |w: &Writer, ty: Type| match ty.base {
            Base::Struct(id) => w
                .structs
                .get(id as usize)
                .is_some_and(|s| s.fields.iter().any(|f| matches!(f.1.base, Base::Struct(_)))),
            _ => false,
        };
        for field in &mut fields {
            if deep(self, field.1) {
                field.1 = Type::FLOAT;
            }
        }
        self.declare_record(fields)
    }

    fn declare_record(&mut self, fields: Vec<(String, Type)>) -> String {
        let mut lines = String::new();
        for (name, ty) in &fields {
            let precision = self.precision(*ty);
            lines.push_str(&format!("    {precision}{};\n", self.typed(*ty, name)));
        }
        let holds_sampler = fields.iter().any(|f| self.holds_sampler(f.1));
        let name = self.new_name("S");
        self.take_name(&name);
        let id = self.structs.len();
        self.structs.push(Record {
            name: name.clone(),
            fields,
        });
        if let Some(scope) = self.scopes.last_mut().filter(|_| !holds_sampler) {
            scope.structs.push(id);
        }
        format!("struct {name} {{\n{lines}}};\n")
    }

    fn global(&mut self) -> String {
        let ty = self.value_type();
        let takes_value = self.is_300 || !self.holds_array(ty);
        let value = if takes_value && self.one_in(2) {
            format!(" = {}", self.constantly(|w| w.expression(ty, 2)))
        } else {
            String::new()
        };
        let name = self.new_name("g");
        let precision = self.precision(ty);
        let text = format!("{precision}{}{value};\n", self.typed(ty, &name));
        self.declare(&name, ty, Use::Free);
        text
    }

    fn constant_global(&mut self) -> String {
        let ty = self.plain_type();
        let value = self.constantly(|w| w.expression(ty, 3));
        let name = self.new_name("c");
        let precision = self.precision(ty);
        let text = format!("const {precision}{} = {value};\n", self.typed(ty, &name));
        self.declare(&name, ty, Use::Constant);
        text
    }

    fn uniform(&mut self) -> String {
        let ty = self.value_type();
        let name = self.new_name("u");
        let precision = self.precision(ty);
        let word = if self.mistake() {
            self.pick(&[
                "const uniform",
                "flat uniform",
                "uniform uniform",
                "uniform in",
                "out",
            ])
        } else {
            "uniform"
        };
        let text = format!("{word} {precision}{};\n", self.typed(ty, &name));
        self.declare(&name, ty, Use::Read);
        text
    }

    fn sampler_uniform(&mut self) -> String {
        let sampler = self.sampler();
        let ty = Type::sampler(sampler);
        if self.one_in(6) {
            let other = self.numeric_type();
            let fields = vec![("m0".to_string(), ty), ("m1".to_string(), other)];
            let record = self.declare_record(fields);
            let id = self.structs.len() as u16 - 1;
            let ty = Type {
                base: Base::Struct(id),
                array: 0,
            };
            let name = self.new_name("u");
            let text = format!("{record}uniform {};\n", self.typed(ty, &name));
            self.declare(&name, ty, Use::Read);
            return text;
        }
        let ty = if self.one_in(4) { ty.array_of(2) } else { ty };
        let name = self.new_name("t");
        let precision = self.precision(ty);
        let text = format!("uniform {precision}{};\n", self.typed(ty, &name));
        self.declare(&name, ty, Use::Read);
        text
    }

    /// Varyings, or inputs of the vertex shader.
    fn varying(&mut self) -> String {
        let mut ty = self.numeric_type();
        let scalar = ty.scalar_kind().unwrap_or(Scalar::Float);
        let is_attribute = !self.is_fragment() && self.one_in(2);
        let plain = scalar == Scalar::Float || (self.is_300 && scalar != Scalar::Bool);
        if !plain && !self.mistake() {
            ty = Type::vector(Scalar::Float, 3);
        }
        let scalar = ty.scalar_kind().unwrap_or(Scalar::Float);
        let name = self.new_name("w");
        let word = match (self.is_300, is_attribute, self.is_fragment()) {
            (false, true, _) => "attribute",
            (false, false, _) => self.pick(&["varying", "varying", "invariant varying"]),
            (true, true, _) => self.pick(&["in", "layout(location = 3) in"]),
            (true, false, true) if scalar.is_integer() => "flat in",
            (true, false, true) => self.pick(&["in", "flat in", "centroid in", "smooth in"]),
            (true, false, false) if scalar.is_integer() => "flat out",
            (true, false, false) => self.pick(&[
                "out",
                "flat out",
                "centroid out",
                "invariant out",
                "smooth out",
            ]),
        };
        let word = if self.mistake() {
            self.pick(&[
                "in",
                "out",
                "flat",
                "flat in",
                "centroid",
                "layout(location = 1) out",
            ])
        } else {
            word
        };
        let can_be_array = !is_attribute && self.one_in(5);
        let ty = if can_be_array { ty.array_of(2) } else { ty };
        let precision = self.precision(ty);
        let text = format!("{word} {precision}{};\n", self.typed(ty, &name));
        let is_written = !self.is_fragment() && !is_attribute;
        self.declare(&name, ty, if is_written { Use::Free } else { Use::Read });
        text
    }

    fn interface_block(&mut self) -> String {
        let layout = self.pick(&["", "layout(std140) ", "layout(row_major) "]);
        let mut lines = String::new();
        let mut fields = Vec::new();
        for _ in 0..self.below(3) + 1 {
            let ty = self.value_type();
            let name = self.new_name("b");
            let layout = if ty.is_matrix() && self.one_in(2) {
                "layout(column_major) "
            } else {
                ""
            };
            let precision = self.precision(ty);
            lines.push_str(&format!(
                "    {layout}{precision}{};\n",
                self.typed(ty, &name)
            ));
            fields.push((name, ty));
        }
        let block = self.new_name("B");
        self.take_name(&block);
        let word = if self.mistake() {
            self.pick(&["in", "out", "const", ""])
        } else {
            "uniform"
        };
        let head = format!("{layout}{word} {block} {{\n{lines}}}");
        if self.one_in(2) {
            for (name, ty) in fields {
                self.declare(&name, ty, Use::Read);
            }
            return format!("{head};\n");
        }
        let name = self.new_name("n");
        self.take_name(&name);
        let (size, at) = if self.one_in(3) {
            ("[2]", "[1]")
        } else {
            ("", "")
        };
        // With an instance name, its members are accessed through it.
        for (field, ty) in fields {
            let name = format!("{name}{at}.{field}");
            let usage = Use::Read;
            if let Some(scope) = self.scopes.last_mut() {
                scope.variables.push(Variable { name, ty, usage });
            }
        }
        format!("{head} {name}{size};\n")
    }
}
