//! Prints the IR in readable form: with the names of the source, one line per effect, and
//! operations that are used once nested in the expression that uses them.

use crate::form::{
    Access, Case, CaseLabel, Function, Lanes, Loop, Module, Op, OpId, OpKind, PlaceId, Provenance,
    Region, Root, Run, Step, Switch, Unary,
};

use rustc_hash::FxHashMap;
use shaderlint_semantic::{FunctionRef, Program, Type, Value, VariableId};
use shaderlint_syntax::ast::{List, TokenId};

/// The column of the comment with the source position.
const REMARK: usize = 64;
/// Maximum nesting of operations in one line.
const MAX_NESTED: u8 = 12;
/// Maximum number of scalars of a constant that are printed.
const MAX_SCALARS: usize = 16;

/// Prints the functions and variables of the user's source as IR.
pub fn print(program: &Program, module: &Module) -> String {
    let mut printer = Printer {
        program,
        module,
        uses: uses(module),
        nested: vec![false; module.ops.len()],
        names: FxHashMap::default(),
        line: None,
        out: String::new(),
    };
    printer.globals();
    let mut functions: Vec<_> = (0..).map(FunctionRef).zip(&module.functions).collect();
    functions.sort_by_key(|(_, function)| function.ops.first);
    for (id, function) in functions {
        let declared = program.function(id).and_then(|f| f.definition);
        let token = declared.and_then(|d| program.tree.function(d));
        if token.is_some_and(|f| printer.is_users(f.ident.token)) {
            printer.function(id, function);
        }
    }
    printer.out
}

/// By operation: the number of uses of its value.
fn uses(module: &Module) -> Vec<u32> {
    let mut uses = vec![0; module.ops.len()];
    let mut count = |op: OpId| {
        if let Some(slot) = uses.get_mut(op.0 as usize) {
            *slot += 1;
        }
    };
    for id in (0..module.ops.len() as u32).map(OpId) {
        module.each_operand(id, &mut count);
    }
    for step in &module.steps {
        used_by(module, step).into_iter().for_each(&mut count);
    }
    module
        .loops
        .iter()
        .filter_map(|l| l.condition)
        .for_each(count);
    uses
}

/// The value that a step uses before it runs.
fn used_by(module: &Module, step: &Step) -> Option<OpId> {
    match *step {
        Step::If { condition, .. } => Some(condition),
        Step::Switch(id) => module.switch(id).map(|s| s.selector),
        Step::Return(value, _) => value,
        _ => None,
    }
}

/// The text of a value, and whether a postfix (`.x`, `[i]`) or operator may follow it without
/// parentheses.
type Text = (String, BindingStrength);

#[derive(Clone, Copy, PartialEq)]
enum BindingStrength {
    Tight,
    Loose,
}

struct Printer<'a> {
    program: &'a Program,
    module: &'a Module,
    uses: Vec<u32>,
    /// By operation: whether it is nested in the line of its use.
    nested: Vec<bool>,
    /// The names of variables in the current function.
    names: FxHashMap<VariableId, String>,
    /// The source line of the last comment.
    line: Option<u32>,
    out: String,
}

impl Printer<'_> {
    fn is_users(&self, token: TokenId) -> bool {
        let token = self.program.token(token);
        token.is_some_and(|t| self.program.sources.is_user(t.span.start))
    }

    /// Writes a line, with its source position if that is on another line than the previous one.
    fn put(&mut self, depth: usize, text: &str, token: Option<TokenId>) {
        let from = self.out.len();
        (0..depth).for_each(|_| self.out.push_str("  "));
        self.out.push_str(text);
        let span = token.and_then(|t| self.program.token(t)).map(|t| t.span);
        if let Some(span) = span
            && let Some(file) = self.program.sources.file_at(span.start)
        {
            let position = file.position(span.start);
            if self.line != Some(position.line) {
                self.line = Some(position.line);
                let width = self.out.get(from..).map_or(0, |t| t.chars().count());
                (width..REMARK).for_each(|_| self.out.push(' '));
                let (line, column) = (position.line, position.column);
                self.out.push_str(&format!(" // {line}:{column}"));
            }
        }
        self.out.push('\n');
    }

    fn token(&self, origin: Provenance) -> Option<TokenId> {
        origin.extent(&self.program.tree).map(|e| e.first)
    }

    fn globals(&mut self) {
        for (i, declared) in self.program.variables.iter().enumerate() {
            let id = VariableId(i as u32);
            let Some(token) = declared.token.filter(|t| self.is_users(*t)) else {
                continue;
            };
            let Some(variable) = self.module.variable(id).copied() else {
                continue;
            };
            let word = match variable.root {
                _ if declared.is_const && declared.constant.is_known() => continue,
                Root::Global => "global",
                Root::Uniform => "uniform",
                Root::Input => "input",
                Root::Output => "output",
                _ => continue,
            };
            let (name, ty) = (self.variable(id), self.program.type_name(variable.ty));
            self.put(0, &format!("{word} {name}: {ty}"), Some(token));
        }
        if !self.module.steps(self.module.globals).is_empty() {
            self.put(0, "globals {", None);
            self.region(self.module.globals, 1, None);
            self.put(0, "}", None);
        }
    }

    fn function(&mut self, id: FunctionRef, function: &Function) {
        let Some(body) = function.body else { return };
        let program = self.program;
        let Some(declared) = program.function(id) else {
            return;
        };
        self.name_variables(id);
        let parameters = self.module.parameters(function).iter();
        let parameters: Vec<String> = parameters
            .zip(&declared.params)
            .map(|(&v, p)| {
                let (name, ty) = (self.variable(v), program.type_name(p.ty));
                match p.direction {
                    shaderlint_semantic::Direction::In => format!("{name}: {ty}"),
                    direction => format!("{} {name}: {ty}", direction.name()),
                }
            })
            .collect();
        let returns = match function.returns {
            ty if ty.is_void() => String::new(),
            ty => format!(" -> {}", program.type_name(ty)),
        };
        let definition = declared.definition.and_then(|d| program.tree.function(d));
        if !self.out.is_empty() {
            self.out.push('\n');
        }
        let name = program.names.text(declared.name);
        let head = format!("fn {name}({}){returns} {{", parameters.join(", "));
        self.put(0, &head, definition.map(|d| d.ident.token));
        let variables = self.module.variables.iter().enumerate();
        let own = variables.filter(|(_, v)| v.function == Some(id) && v.root == Root::Temporary);
        let own: Vec<VariableId> = own.map(|(i, _)| VariableId(i as u32)).collect();
        for v in own {
            let ty = self.module.variable(v).map_or(Type::ERROR, |v| v.ty);
            let line = format!("temporary {}: {}", self.variable(v), program.type_name(ty));
            self.put(1, &line, None);
        }
        self.region(body, 1, None);
        self.put(0, "}", None);
        self.names.clear();
    }

    /// Numbers variables that share a name.
    fn name_variables(&mut self, function: FunctionRef) {
        // A local that shadows a global needs a different name.
        let globals = self.program.variables.iter().zip(&self.module.variables);
        let globals = globals.filter(|(_, own)| own.function.is_none());
        let names = globals.map(|(declared, _)| self.program.names.text(declared.name));
        let mut taken: FxHashMap<&str, u32> = names.map(|name| (name, 1)).collect();
        let mut unnamed = 0;
        for (i, variable) in self.module.variables.iter().enumerate() {
            if variable.function != Some(function) {
                continue;
            }
            let declared = self.program.variables.get(i);
            let name = declared.map_or("", |v| self.program.names.text(v.name));
            let name = if name.is_empty() {
                unnamed += 1;
                format!("${unnamed}")
            } else {
                let count = taken.entry(name).or_insert(0);
                *count += 1;
                match *count {
                    1 => name.to_string(),
                    n => format!("{name}'{n}"),
                }
            };
            self.names.insert(VariableId(i as u32), name);
        }
    }

    fn variable(&self, id: VariableId) -> String {
        if let Some(name) = self.names.get(&id) {
            return name.clone();
        }
        let declared = self.program.variable(id);
        declared.map_or("?".into(), |v| self.program.names.text(v.name).to_string())
    }

    /// Writes the steps of a region; `last` is used after it.
    fn region(&mut self, region: Region, depth: usize, last: Option<OpId>) {
        let module = self.module;
        let steps = module.steps(region);
        for (i, step) in steps.iter().enumerate() {
            let token = |s| Some(self.program.tree.stmt(s).extent.first);
            match *step {
                Step::Run(run) => {
                    let used = match steps.get(i + 1) {
                        Some(next) => used_by(module, next),
                        None => last,
                    };
                    self.nest(run, used);
                    run.ops().for_each(|op| self.line(op, depth));
                }
                Step::If {
                    condition,
                    then,
                    otherwise,
                    origin,
                } => {
                    let is_inverted = module.steps(then).is_empty();
                    let head = match is_inverted {
                        true => format!("if !{} {{", self.tight(condition)),
                        false => format!("if {} {{", self.value(condition).0),
                    };
                    self.put(depth, &head, self.token(origin));
                    self.region(then, depth + 1, None);
                    if is_inverted {
                        self.region(otherwise, depth + 1, None);
                    } else if !module.steps(otherwise).is_empty() {
                        self.put(depth, "} else {", None);
                        self.region(otherwise, depth + 1, None);
                    }
                    self.put(depth, "}", None);
                }
                Step::Loop(id) => {
                    if let Some(found) = module.looped(id) {
                        self.looped(found, depth);
                    }
                }
                Step::Switch(id) => {
                    if let Some(found) = module.switch(id) {
                        self.switch(found, depth);
                    }
                }
                Step::Break(s) => self.put(depth, "break", token(s)),
                Step::Continue(s) => self.put(depth, "continue", token(s)),
                Step::Discard(s) => self.put(depth, "discard", token(s)),
                Step::Return(None, s) => self.put(depth, "return", token(s)),
                Step::Return(Some(value), s) => {
                    let line = format!("return {}", self.value(value).0);
                    self.put(depth, &line, token(s));
                }
            }
        }
    }

    fn looped(&mut self, found: &Loop, depth: usize) {
        let token = Some(self.program.tree.stmt(found.stmt).extent.first);
        // The condition is printed in the loop header if its region prints no lines.
        let (line, out) = (self.line, std::mem::take(&mut self.out));
        self.region(found.test, depth + 1, found.condition);
        let test = std::mem::replace(&mut self.out, out);
        if !test.is_empty() {
            self.line = line;
        }
        let condition = found
            .condition
            .map(|c| format!("while {}", self.value(c).0));
        let goes_on = condition.unwrap_or_default();
        let head = match (test.is_empty(), goes_on.is_empty()) {
            (true, false) if found.tests_first => format!("loop {goes_on} {{"),
            _ => "loop {".to_string(),
        };
        self.put(depth, &head, token);
        if found.tests_first && !test.is_empty() {
            self.out.push_str(&test);
            self.put(depth + 1, &goes_on, None);
        }
        self.region(found.body, depth + 1, None);
        if !self.module.steps(found.step).is_empty() {
            self.put(depth, "} step {", None);
            self.region(found.step, depth + 1, None);
        }
        if found.tests_first {
            return self.put(depth, "}", None);
        }
        if !test.is_empty() {
            self.put(depth, "} test {", None);
            self.out.push_str(&test);
        }
        self.put(depth, format!("}} {goes_on}").trim_end(), None);
    }

    fn switch(&mut self, found: &Switch, depth: usize) {
        let token = Some(self.program.tree.stmt(found.stmt).extent.first);
        let head = format!("switch {} {{", self.value(found.selector).0);
        self.put(depth, &head, token);
        let module = self.module;
        for case in module.cases(found) {
            let head = self.labels(case, module.ty(found.selector));
            self.put(depth, &format!("{head}:"), None);
            self.region(case.body, depth + 1, None);
        }
        self.put(depth, "}", None);
    }

    fn labels(&self, case: &Case, ty: Type) -> String {
        let labels = self.module.labels(case).iter().map(|label| match *label {
            CaseLabel::Value(bits) if ty == Type::UINT => format!("case {bits}u"),
            CaseLabel::Value(bits) => format!("case {}", bits as i32),
            CaseLabel::Default => "default".to_string(),
        });
        labels.collect::<Vec<_>>().join(", ")
    }

    /// Finds the operations of a run that can be nested in the line of their use: those without a
    /// side effect in between.
    fn nest(&mut self, run: Run, last: Option<OpId>) {
        let module = self.module;
        let mut depths = vec![0u8; run.len as usize];
        // The last operation with a side effect so far.
        let mut effect: Option<OpId> = None;
        for id in run.ops() {
            let mut depth = 0;
            module.each_operand(id, |o| {
                let own = o.0.checked_sub(run.first.0);
                let inner = own.and_then(|i| depths.get(i as usize)).copied();
                if let Some(inner) = inner
                    && self.is_single(o)
                    && inner < MAX_NESTED
                    && effect.is_none_or(|e| e <= o)
                {
                    self.set_nested(o);
                    depth = depth.max(inner + 1);
                }
            });
            if let Some(slot) = depths.get_mut((id.0 - run.first.0) as usize) {
                *slot = depth;
            }
            if matches!(module.op(id).kind, OpKind::Store(..) | OpKind::Call(..)) {
                effect = Some(id);
            }
        }
        if let Some(last) = last.filter(|o| run.contains(*o))
            && self.is_single(last)
            && effect.is_none_or(|e| e <= last)
        {
            self.set_nested(last);
        }
    }

    fn is_single(&self, op: OpId) -> bool {
        self.uses.get(op.0 as usize) == Some(&1)
    }

    fn set_nested(&mut self, op: OpId) {
        if let Some(slot) = self.nested.get_mut(op.0 as usize) {
            *slot = true;
        }
    }

    /// Writes the line of an operation, unless it is nested.
    fn line(&mut self, id: OpId, depth: usize) {
        let op = *self.module.op(id);
        let is_nested = self.nested.get(id.0 as usize).copied().unwrap_or(false);
        if is_nested || is_literal(&op) {
            return;
        }
        let origin = self.module.provenance(id);
        let text = match op.kind {
            OpKind::Store(place, value) => {
                let value = self.value(value).0;
                let to = self.place(place);
                match origin {
                    Provenance::Declaration(_) if self.is_local(place) => {
                        let ty = self.program.type_name(self.module.place(place).ty);
                        format!("local {to}: {ty} = {value}")
                    }
                    _ => format!("{to} = {value}"),
                }
            }
            _ => {
                let text = self.text(id, &op).0;
                let is_used = self.uses.get(id.0 as usize).is_some_and(|u| *u > 0);
                let ty = self.program.type_name(op.ty);
                match op.precision.name() {
                    _ if !is_used => text,
                    _ if op.ty.is_void() => format!("%{} = {text}", id.0),
                    "" | "highp" => format!("%{}: {ty} = {text}", id.0),
                    precision => format!("%{}: {precision} {ty} = {text}", id.0),
                }
            }
        };
        self.put(depth, &text, self.token(origin));
    }

    fn is_local(&self, place: PlaceId) -> bool {
        let variable = self.module.variable(self.module.place(place).variable);
        variable.is_some_and(|v| v.root == Root::Local)
    }

    /// A value as an operand.
    fn value(&self, id: OpId) -> Text {
        let op = self.module.op(id);
        if is_literal(op) || self.nested.get(id.0 as usize).copied().unwrap_or(false) {
            return self.text(id, op);
        }
        (format!("%{}", id.0), BindingStrength::Tight)
    }

    /// A value as an operand of a postfix or operator, in parentheses if necessary.
    fn tight(&self, id: OpId) -> String {
        match self.value(id) {
            (text, BindingStrength::Tight) => text,
            (text, BindingStrength::Loose) => format!("({text})"),
        }
    }

    fn values(&self, list: List) -> String {
        let values = self.module.operands(list).iter();
        let values: Vec<String> = values.map(|&v| self.value(v).0).collect();
        values.join(", ")
    }

    fn text(&self, id: OpId, op: &Op) -> Text {
        let loose = |text| (text, BindingStrength::Loose);
        let text = match op.kind {
            OpKind::Const(_) => self.constant(op.ty, self.module.constant(id)),
            OpKind::Undef => "undefined".to_string(),
            OpKind::Unknown => "unknown".to_string(),
            OpKind::Load(place) => self.place(place),
            OpKind::Store(..) => String::new(),
            OpKind::Unary(unary, a) => {
                let symbol = match unary {
                    Unary::Negate => "-",
                    Unary::Not => "!",
                    Unary::BitNot => "~",
                };
                return loose(format!("{symbol}{}", self.tight(a)));
            }
            OpKind::Binary(binary, a, b) => {
                let symbol = binary.symbol();
                return loose(format!("{} {symbol} {}", self.tight(a), self.tight(b)));
            }
            OpKind::MatrixProduct(a, b) => {
                format!("product({}, {})", self.value(a).0, self.value(b).0)
            }
            OpKind::Same {
                negated,
                left,
                right,
            } => {
                let symbol = if negated { "!=" } else { "==" };
                return loose(format!(
                    "{} {symbol} {}",
                    self.tight(left),
                    self.tight(right)
                ));
            }
            OpKind::Select {
                condition,
                then,
                otherwise,
            } => format!(
                "select({}, {}, {})",
                self.value(condition).0,
                self.value(then).0,
                self.value(otherwise).0
            ),
            OpKind::Convert(a) => format!("{}({})", self.program.type_name(op.ty), self.value(a).0),
            OpKind::Splat(a) => format!("splat({})", self.value(a).0),
            OpKind::Swizzle(a, lanes) => format!("{}.{}", self.tight(a), letters(lanes)),
            OpKind::Compose(list) => {
                format!("{}({})", self.program.type_name(op.ty), self.values(list))
            }
            OpKind::Extract(a, number) => {
                format!("{}{}", self.tight(a), self.part(self.module.ty(a), number))
            }
            OpKind::ExtractComputed { base, index } => {
                format!("{}[{}]", self.tight(base), self.value(index).0)
            }
            OpKind::Builtin(function, list) => {
                format!("{}({})", function.name(), self.values(list))
            }
            OpKind::Call(callee, list) => {
                let function = self.program.function(callee);
                let name = function.map_or("?", |f| self.program.names.text(f.name));
                format!("call {name}({})", self.values(list))
            }
            OpKind::Returned(call, number) => {
                format!("returned({}, {number})", self.value(call).0)
            }
        };
        (text, BindingStrength::Tight)
    }

    /// The text of a member or element access.
    fn part(&self, ty: Type, number: u32) -> String {
        let fields = self.program.struct_of(ty).filter(|_| !ty.is_array());
        match fields.and_then(|s| s.fields.get(number as usize)) {
            Some(field) => format!(".{}", self.program.names.text(field.name)),
            None => format!("[{number}]"),
        }
    }

    fn place(&self, id: PlaceId) -> String {
        let place = self.module.place(id);
        let mut text = self.variable(place.variable);
        let mut ty = self
            .module
            .variable(place.variable)
            .map_or(Type::ERROR, |v| v.ty);
        for access in self.module.path(place) {
            match *access {
                Access::Member(n) => {
                    text.push_str(&self.part(ty, n));
                    let fields = self.program.struct_of(ty).map(|s| &s.fields);
                    let field = fields.and_then(|f| f.get(n as usize));
                    ty = field.map_or(Type::ERROR, |f| f.ty);
                }
                Access::Element(n) => {
                    text.push_str(&format!("[{n}]"));
                    ty = ty.element();
                }
                Access::Computed(index) => {
                    text.push_str(&format!("[{}]", self.value(index).0));
                    ty = ty.element();
                }
                Access::Lanes(lanes) => text.push_str(&format!(".{}", letters(lanes))),
            }
        }
        text
    }

    fn constant(&self, ty: Type, values: &[Value]) -> String {
        let shown = values.iter().take(MAX_SCALARS).map(|v| match v {
            Value::Bool(v) => v.to_string(),
            Value::Int(v) => v.to_string(),
            Value::Uint(v) => format!("{v}u"),
            Value::Float(v) => format!("{v:?}"),
        });
        let mut shown: Vec<String> = shown.collect();
        if ty.is_scalar() {
            return shown.concat();
        }
        if values.len() > MAX_SCALARS {
            shown.push("...".into());
        }
        format!("{}({})", self.program.type_name(ty), shown.join(", "))
    }
}

/// Whether a value is printed at every use, without a number.
fn is_literal(op: &Op) -> bool {
    matches!(op.kind, OpKind::Const(_) | OpKind::Undef | OpKind::Unknown)
}

fn letters(lanes: Lanes) -> String {
    let letter = |n: &u8| "xyzw".chars().nth(*n as usize).unwrap_or('?');
    lanes.numbers().iter().map(letter).collect()
}
