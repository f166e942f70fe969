//! The symbols that names refer to.

use shaderlint_detect::embed::NameRole;
use shaderlint_semantic::builtins::BuiltinStorage;
use shaderlint_semantic::{
    BuiltinId, Direction, Field, Function, FunctionRef, Program, Stage, Storage, Type, Variable,
    VariableId,
};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::{DeclKind, Param};
use shaderlint_text::Span;

/// The symbol that a name refers to.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symbol {
    /// A variable or parameter.
    Variable(VariableId),
    /// A user-defined function.
    Function(FunctionRef),
    /// A struct or block, by index.
    Struct(u32),
    /// A member: index of its struct, and of the member.
    Field(u32, u32),
    /// A macro. Definitions of the same name in several groups are one macro.
    Macro(Name),
    /// A parameter of the macro with its name at this address, by index.
    MacroParameter(u32, u32),
    /// A built-in function.
    Builtin(BuiltinId),
}

/// Kinds of symbols.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum SymbolKind {
    /// A local variable.
    Local,
    /// A global variable.
    Global,
    /// A constant.
    Constant,
    /// A parameter of a function or macro.
    Parameter,
    /// A uniform.
    Uniform,
    /// An input of a stage.
    Input,
    /// An output of a stage.
    Output,
    /// A function.
    Function,
    /// A struct or block.
    Struct,
    /// A member.
    Field,
    /// A macro.
    Macro,
}

impl Symbol {
    /// The kind of the symbol.
    pub fn kind(self, program: &Program) -> SymbolKind {
        match self {
            Symbol::Variable(id) => program
                .variable(id)
                .map_or(SymbolKind::Local, variable_kind),
            Symbol::Function(_) | Symbol::Builtin(_) => SymbolKind::Function,
            Symbol::Struct(_) => SymbolKind::Struct,
            Symbol::Field(..) => SymbolKind::Field,
            Symbol::Macro(_) => SymbolKind::Macro,
            Symbol::MacroParameter(..) => SymbolKind::Parameter,
        }
    }

    /// The name of the symbol; empty for a parameter of a macro.
    pub fn name(self, program: &Program) -> &str {
        let name = match self {
            Symbol::Variable(id) => program.variable(id).map(|v| v.name),
            Symbol::Function(id) => program.function(id).map(|f| f.name),
            Symbol::Struct(id) => program.structs.get(id as usize).and_then(|s| s.name),
            Symbol::Field(..) => field(program, self).map(|f| f.name),
            Symbol::Macro(name) => Some(name),
            Symbol::MacroParameter(..) => None,
            Symbol::Builtin(id) => return id.name(),
        };
        name.map_or("", |name| program.names.text(name))
    }

    /// The type of the symbol, if it has one; of a function, the return type.
    pub fn ty(self, program: &Program) -> Option<Type> {
        match self {
            Symbol::Variable(id) => Some(program.variable(id)?.ty),
            Symbol::Function(id) => Some(program.function(id)?.returns),
            Symbol::Field(..) => Some(field(program, self)?.ty),
            Symbol::Struct(id) => Some(Type::structure(id)),
            Symbol::Macro(_) | Symbol::MacroParameter(..) | Symbol::Builtin(_) => None,
        }
    }

    /// The declaration as a line of GLSL.
    pub fn declaration(self, program: &Program) -> String {
        match self {
            Symbol::Variable(id) => program
                .variable(id)
                .map_or(String::new(), |v| variable_declaration(program, v)),
            Symbol::Function(id) => program
                .function(id)
                .map_or(String::new(), |f| function_declaration(program, f)),
            Symbol::Struct(id) => struct_declaration(program, id),
            Symbol::Field(id, _) => {
                let Some(field) = field(program, self) else {
                    return String::new();
                };
                let of = Symbol::Struct(id).name(program);
                format!(
                    "{} {of}.{}",
                    program.type_name(field.ty),
                    program.names.text(field.name)
                )
            }
            Symbol::Macro(name) => macro_declaration(program, name),
            Symbol::MacroParameter(..) => String::new(),
            Symbol::Builtin(id) => id.name().to_string(),
        }
    }
}

/// The member of a field symbol.
fn field(program: &Program, symbol: Symbol) -> Option<&Field> {
    let Symbol::Field(id, at) = symbol else {
        return None;
    };
    program.structs.get(id as usize)?.fields.get(at as usize)
}

fn variable_kind(variable: &Variable) -> SymbolKind {
    match variable.storage {
        Storage::Param(_) => SymbolKind::Parameter,
        _ if variable.is_const => SymbolKind::Constant,
        Storage::Local => SymbolKind::Local,
        Storage::Global => SymbolKind::Global,
        Storage::Uniform => SymbolKind::Uniform,
        Storage::Input => SymbolKind::Input,
        Storage::Output => SymbolKind::Output,
    }
}

/// A type and a name as a declaration: `float a[3]`.
pub fn typed(program: &Program, ty: Type, name: &str) -> String {
    let element = program.type_name(ty.element());
    match ty.array {
        _ if !ty.is_array() => format!("{element} {name}"),
        Type::UNSIZED => format!("{element} {name}[]"),
        size => format!("{element} {name}[{size}]"),
    }
}

fn variable_declaration(program: &Program, variable: &Variable) -> String {
    let name = program.names.text(variable.name);
    let typed = typed(program, variable.ty, name);
    let before = match variable.storage {
        Storage::Param(Direction::In) => "",
        Storage::Param(direction) => direction.name(),
        _ if variable.is_const => "const",
        Storage::Local | Storage::Global => "",
        Storage::Uniform => "uniform",
        Storage::Input => "in",
        Storage::Output => "out",
    };
    match before {
        "" => typed,
        before => format!("{before} {typed}"),
    }
}

/// The names of the parameters of a function, where it is declared.
pub fn parameter_names<'p>(program: &'p Program, function: &Function) -> Vec<&'p str> {
    let declared = function.definition.unwrap_or(function.declaration);
    let params = program.tree.function(declared).map(|d| d.params);
    let params: &[Param] = params.map_or(&[], |p| program.tree.params(p));
    let name = |p: &Param| p.ident.map_or("", |i| program.names.text(i.name));
    params.iter().map(name).collect()
}

/// The parameters of a function as declared.
pub fn parameters(program: &Program, function: &Function) -> Vec<String> {
    let names = parameter_names(program, function);
    let params = function.params.iter().enumerate();
    let param = params.map(|(i, param)| {
        let name = names.get(i).copied().unwrap_or("");
        let typed = typed(program, param.ty, name).trim_end().to_string();
        match param.direction {
            Direction::In => typed,
            direction => format!("{} {typed}", direction.name()),
        }
    });
    param.collect()
}

fn function_declaration(program: &Program, function: &Function) -> String {
    let returns = program.type_name(function.returns);
    let name = program.names.text(function.name);
    format!(
        "{returns} {name}({})",
        parameters(program, function).join(", ")
    )
}

fn struct_declaration(program: &Program, id: u32) -> String {
    /// Maximum number of members shown.
    const MOST: usize = 16;
    let Some(record) = program.structs.get(id as usize) else {
        return String::new();
    };
    let name = Symbol::Struct(id).name(program);
    let mut text = format!("struct {name} {{\n");
    for field in record.fields.iter().take(MOST) {
        let field = typed(program, field.ty, program.names.text(field.name));
        text.push_str(&format!("    {field};\n"));
    }
    if record.fields.len() > MOST {
        text.push_str("    // ...\n");
    }
    text + "};"
}

/// The `#define` of a macro.
fn macro_declaration(program: &Program, name: Name) -> String {
    let defined = program.tokens.macros.iter().rev().find(|m| m.name == name);
    let Some(defined) = defined else {
        return String::new();
    };
    let text = program.names.text(name);
    if defined.predefined {
        return format!("#define {text}");
    }
    let file = program.sources.file_at(defined.name_span.start);
    let line = file.and_then(|file| {
        let from = (defined.name_span.start - file.base) as usize;
        // A `#define` ends at a line break that does not follow a `\`.
        let rest = file.text.get(from..)?;
        let mut end = 0;
        for line in rest.split_inclusive('\n') {
            end += line.len();
            if !line.trim_end_matches(['\n', '\r']).ends_with('\\') {
                break;
            }
        }
        rest.get(..end)
    });
    format!("#define {}", line.unwrap_or(text).trim_end())
}

/// The declaration of a symbol in the text; the definition, if there is one.
pub fn declared_at(program: &Program, symbol: Symbol) -> Option<Span> {
    let token = match symbol {
        Symbol::Variable(id) => program.variable(id)?.token?,
        Symbol::Function(id) => {
            let function = program.function(id)?;
            let decl = function.definition.unwrap_or(function.declaration);
            program.tree.function(decl)?.ident.token
        }
        Symbol::Struct(id) => program.structs.get(id as usize)?.token,
        Symbol::Field(..) => field(program, symbol)?.token,
        Symbol::Macro(name) => {
            let all = program.tokens.macros.iter();
            let defined = all.rev().find(|m| m.name == name && !m.predefined)?;
            return Some(defined.name_span);
        }
        Symbol::MacroParameter(..) | Symbol::Builtin(_) => return None,
    };
    let start = program.token(token)?.spelled;
    Some(Span::new(start, start + symbol.name(program).len() as u32))
}

/// The declaration of a built-in variable.
pub fn builtin_variable(program: &Program, name: &str) -> Option<String> {
    let found = program.builtins().variable(name)?;
    let storage = match found.storage {
        BuiltinStorage::In => "in",
        BuiltinStorage::Out => "out",
        BuiltinStorage::Uniform => "uniform",
        BuiltinStorage::Const(_) => "const",
    };
    let ty = found.ty.map(|ty| typed(program, ty, name));
    Some(format!(
        "{storage} {}",
        ty.unwrap_or_else(|| format!("gl_DepthRangeParameters {name}"))
    ))
}

/// What scripts may use a symbol for.
pub fn role(program: &Program, symbol: Symbol) -> NameRole {
    let is_input = match symbol.kind(program) {
        SymbolKind::Uniform => true,
        SymbolKind::Input => program.stage == Stage::Vertex,
        // Uniform blocks are set by name, too.
        SymbolKind::Struct => is_block(program, symbol),
        _ => false,
    };
    match is_input {
        true => NameRole::Input,
        false => NameRole::Inner,
    }
}

fn is_block(program: &Program, symbol: Symbol) -> bool {
    let Symbol::Struct(id) = symbol else {
        return false;
    };
    let declared = program.structs.get(id as usize).map(|s| s.token);
    program.tree.decls.iter().any(|decl| match decl.kind {
        DeclKind::Block { members, .. } => {
            let own = program.tree.structure(members).and_then(|own| own.name);
            own.map(|name| name.token) == declared
        }
        _ => false,
    })
}
