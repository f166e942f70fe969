//! What a shader declares, read from the text that a script hands to its host.

use shaderlint_script::{KnownText, ScriptPlace};
use shaderlint_semantic::interface::{Interface, InterfaceVariable};
use shaderlint_semantic::{
    Base, BlockLayout, CheckedShader, Completeness, Dialect, Scalar, Stage, Storage, Type, Unit,
    check_shader, needs_300,
};
use shaderlint_syntax::{EXTENSIONS, Extensions, GlContext, Search, WebGl};
use shaderlint_text::{FileId, Role, Sources, Span};
use std::collections::HashSet;
use std::rc::Rc;
use std::sync::Arc;

/// Directives after which a text is not complete: something inserts other texts.
const INSERTING: &[&str] = &["#include", "#pragma", "#import", "#require"];

/// A uniform, attribute, varying or output.
#[derive(Clone, Debug)]
pub struct DeclaredInput {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// The type as it is written in GLSL.
    pub type_name: String,
    /// Whether the browser keeps it: reachable code reads it.
    pub is_active: bool,
    /// Value of `layout(location = ...)`.
    pub location: Option<i32>,
    /// Where its name is written.
    pub place: Option<ScriptPlace>,
}

impl DeclaredInput {
    /// Number of components of an element; `None` for samplers and structs.
    pub fn components(&self) -> Option<u32> {
        let element = Type {
            array: 0,
            ..self.ty
        };
        element
            .numeric()
            .map(|(_, columns, rows)| u32::from(columns) * u32::from(rows))
    }

    /// The type of a component.
    pub fn scalar(&self) -> Option<Scalar> {
        let element = Type {
            array: 0,
            ..self.ty
        };
        element.numeric().map(|(scalar, _, _)| scalar)
    }

    /// Number of columns and rows of a matrix.
    pub fn matrix(&self) -> Option<(u8, u8)> {
        let element = Type {
            array: 0,
            ..self.ty
        };
        let (_, columns, rows) = element.numeric()?;
        (columns > 1).then_some((columns, rows))
    }

    /// Whether it is a sampler.
    pub fn is_sampler(&self) -> bool {
        matches!(self.ty.base, Base::Sampler(_))
    }

    /// Whether it is a struct.
    pub fn is_struct(&self) -> bool {
        matches!(self.ty.base, Base::Struct(_) | Base::Block(_))
    }
}

/// What a shader declares.
#[derive(Debug)]
pub struct ShaderInterface {
    /// The text.
    pub text: Rc<KnownText>,
    /// Uniforms outside of blocks, and members of blocks without an instance name.
    pub uniforms: Vec<DeclaredInput>,
    /// Attributes of a vertex shader, varyings of a fragment shader.
    pub inputs: Vec<DeclaredInput>,
    /// Varyings of a vertex shader, outputs of a fragment shader.
    pub outputs: Vec<DeclaredInput>,
    /// The names of the members of uniform blocks without an instance name, and of other uniforms.
    members: Vec<String>,
    /// Uniform blocks: their names, layouts and places.
    blocks: Vec<(String, BlockLayout, Option<ScriptPlace>)>,
    /// All words, also those that no condition selects.
    words: HashSet<String>,
    /// Whether other texts are inserted, or parts are unknown.
    pub is_open: bool,
    /// Whether nothing is inserted except chunks of a library.
    pub includes_chunks_only: bool,
    /// What is compiled before the text.
    head: String,
    /// The text without the lines that include others.
    body: String,
}

impl ShaderInterface {
    /// Reads a shader that is compiled after some macros and, if it has no `#version`, other lines.
    pub fn of(
        text: &Rc<KnownText>,
        stage: Stage,
        (macros, lines_before): (&[(String, String, ScriptPlace)], &str),
    ) -> ShaderInterface {
        let code = text.content.as_str();
        let lines = || code.lines().map(str::trim_start);
        let inserts = |line: &str| {
            let directive = line.replacen("# ", "#", 1);
            INSERTING.iter().any(|d| directive.starts_with(d))
                && !directive.contains("STDGL")
                && !directive.contains("optimize")
                && !directive.contains("debug")
        };
        let mut found = ShaderInterface {
            text: text.clone(),
            uniforms: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            members: Vec::new(),
            blocks: Vec::new(),
            words: words(code),
            is_open: text.is_open || lines().any(inserts),
            includes_chunks_only: !text.is_open && lines().filter(|l| inserts(l)).all(is_chunk),
            head: String::new(),
            body: String::new(),
        };
        let is_versioned = lines().any(|line| line.starts_with("#version"));
        let body = without_includes(code);
        let mut head = String::new();
        if !is_versioned && needs_300(&body) {
            head.push_str("#version 300 es\n");
        }
        for (name, value, _) in macros {
            head.push_str(&format!("#define {name} {value}\n"));
        }
        head.push_str(lines_before);
        if is_versioned {
            head.clear();
        }
        (found.head, found.body) = (head, body);
        found.declare(stage);
        found
    }

    /// Adds the text, after what is compiled before it. The last file is the text.
    pub fn add(&self, sources: &mut Sources) -> Option<Vec<FileId>> {
        self.add_after(Role::Prelude, sources)
    }

    /// As [`ShaderInterface::add`]; of a prelude nothing is reported.
    pub fn add_after(&self, role: Role, sources: &mut Sources) -> Option<Vec<FileId>> {
        let mut files = Vec::new();
        if !self.head.is_empty() {
            files.push(sources.add("", None, role, self.head.as_str())?);
        }
        files.push(sources.add("shader", None, Role::User, self.body.as_str())?);
        Some(files)
    }

    /// Where a range of an added text is written.
    pub fn written(&self, base: u32, span: Span) -> Option<ScriptPlace> {
        let range = span.start.checked_sub(base)? as usize..span.end.checked_sub(base)? as usize;
        let is_inside = range.end <= self.text.content.len();
        is_inside.then(|| self.text.place(range))?
    }

    /// Reads what the text declares.
    fn declare(&mut self, stage: Stage) {
        let mut sources = Sources::new();
        let Some(files) = self.add(&mut sources) else {
            return;
        };
        let sources = Arc::new(sources);
        let checked = compile(&sources, &files, stage);
        let program = &checked.program;
        let file = files.last().and_then(|id| sources.file(*id));
        let base = file.map_or(0, |f| f.base);
        let interface = Interface::of(program);
        // A host may call another function.
        let mut functions = program.functions.iter();
        let has_main = functions.any(|f| program.names.text(f.name) == "main");
        let declared = |variable: &InterfaceVariable| {
            let span = program.token(variable.token)?.span;
            Some(DeclaredInput {
                name: program.names.text(variable.name).to_string(),
                ty: variable.ty,
                type_name: program.type_name(variable.ty),
                is_active: variable.is_active || !has_main && variable.is_used,
                location: variable.location,
                place: self.written(base, span),
            })
        };
        let all = |list: &[InterfaceVariable]| list.iter().filter_map(declared).collect();
        let (uniforms, inputs) = (all(&interface.uniforms), all(&interface.inputs));
        let outputs = all(&interface.outputs);
        let blocks = interface.blocks.iter().filter_map(|block| {
            let layout = BlockLayout::of(&interface, block)?;
            let span = program.token(block.token)?.span;
            let name = program.names.text(block.name).to_string();
            Some((name, layout, self.written(base, span)))
        });
        let blocks = blocks.collect();
        let variables = program.variables.iter();
        let members = variables.filter(|v| v.storage == Storage::Uniform);
        self.members = members
            .map(|v| program.names.text(v.name).to_string())
            .collect();
        self.blocks = blocks;
        (self.uniforms, self.inputs, self.outputs) = (uniforms, inputs, outputs);
    }

    /// A uniform.
    pub fn uniform(&self, name: &str) -> Option<&DeclaredInput> {
        self.uniforms.iter().find(|u| u.name == name)
    }

    /// The names of the uniform blocks.
    pub fn block_names(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().map(|(name, _, _)| name.as_str())
    }

    /// Whether a word appears in the text.
    pub fn mentions(&self, word: &str) -> bool {
        self.words.contains(word)
    }

    /// The last argument of the only `gl_FragColor = vec4(..., alpha)`, if it depends on something.
    pub fn alpha(&self) -> Option<(&str, Option<ScriptPlace>)> {
        let text = self.text.content.as_str();
        let mut all = text.match_indices("gl_FragColor");
        let (start, _) = all.next().filter(|_| all.next().is_none())?;
        let rest = text.get(start..)?;
        let statement = rest.get(..rest.find(';')?)?;
        let value = statement
            .strip_prefix("gl_FragColor")?
            .trim_start()
            .strip_prefix('=')?
            .trim();
        let arguments = value.strip_prefix("vec4(")?.strip_suffix(')')?;
        let mut depth = 0;
        let comma = arguments.rfind(|c: char| {
            depth += match c {
                ')' | ']' => 1,
                '(' | '[' => -1,
                _ => 0,
            };
            c == ',' && depth == 0
        })?;
        let alpha = arguments.get(comma + 1..)?.trim();
        let is_variable = !alpha.starts_with(|c: char| c.is_ascii_digit() || c == '.')
            && alpha.contains(|c: char| c.is_ascii_alphabetic());
        is_variable.then(|| (alpha, self.text.place(start..start + "gl_FragColor".len())))
    }

    /// Whether the text divides `gl_FragCoord` by a uniform.
    pub fn divides_coordinates(&self, name: &str) -> bool {
        let statements = self.text.content.split([';', '{', '}']);
        let divides = |statement: &str| {
            let after = statement.split_once("gl_FragCoord").map(|(_, after)| after);
            let divisor = after
                .and_then(|rest| rest.split_once('/'))
                .map(|(_, d)| d.trim_start());
            divisor.is_some_and(|divisor| {
                let end = divisor.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
                divisor.get(..end.unwrap_or(divisor.len())) == Some(name)
            })
        };
        statements.into_iter().any(divides)
    }
}

/// The context of a shader: the one in which its directives work.
fn context(sources: &Sources, files: &[FileId]) -> GlContext {
    let text = files.last().and_then(|id| sources.file(*id));
    if !text.is_some_and(|f| f.text.contains("#extension") && !f.text.contains("300 es")) {
        return GlContext::WEBGL2;
    }
    let mut enabled = Extensions::NONE;
    enabled.extend(EXTENSIONS.iter().map(|facts| facts.extension));
    GlContext {
        webgl: WebGl::One,
        enabled,
        ..GlContext::WEBGL2
    }
}

/// A shader whose host may declare other names.
pub fn unit<'u>(sources: &'u Arc<Sources>, files: &'u [FileId], stage: Stage) -> Unit<'u> {
    Unit {
        sources,
        files,
        stage,
        dialect: Dialect::WebGl,
        context: context(sources, files),
        infer_channels: false,
        completeness: Completeness::Chunk,
    }
}

/// Checks a shader, whose host may declare other names.
fn compile(sources: &Arc<Sources>, files: &[FileId], stage: Stage) -> CheckedShader {
    check_shader(&unit(sources, files, stage), &mut Search::for_text())
}

/// Whether a line includes a chunk of a library.
fn is_chunk(line: &str) -> bool {
    let rest = line.strip_prefix("#include").map(str::trim_start);
    rest.is_some_and(|rest| rest.starts_with('<'))
}

/// The text with blanks for the lines that include others, with the same offsets.
fn without_includes(code: &str) -> String {
    let mut result = String::with_capacity(code.len());
    for line in code.split_inclusive('\n') {
        match line.trim_start().starts_with("#include") {
            true => result.extend(line.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' })),
            false => result.push_str(line),
        }
    }
    result
}

/// The words of a text.
fn words(code: &str) -> HashSet<String> {
    let words = code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    words
        .filter(|word| !word.is_empty())
        .map(str::to_string)
        .collect()
}

/// The shaders of a program.
#[derive(Clone, Default)]
pub struct Stages {
    /// The vertex shader, if its text is known.
    pub vertex: Option<Rc<ShaderInterface>>,
    /// The fragment shader, if its text is known.
    pub fragment: Option<Rc<ShaderInterface>>,
}

impl Stages {
    /// Those whose text is known.
    pub fn all(&self) -> impl Iterator<Item = &ShaderInterface> {
        [&self.vertex, &self.fragment]
            .into_iter()
            .flatten()
            .map(Rc::as_ref)
    }

    /// Whether both are known completely.
    pub fn are_complete(&self) -> bool {
        self.vertex.is_some() && self.fragment.is_some() && self.all().all(|s| !s.is_open)
    }

    /// A uniform; one that is used if a stage uses it.
    pub fn uniform(&self, name: &str) -> Option<&DeclaredInput> {
        let found = || self.all().filter_map(|s| s.uniform(name));
        found().find(|u| u.is_active).or_else(|| found().next())
    }

    /// The layout of a block, and where it is declared.
    pub fn block(&self, name: &str) -> Option<(&BlockLayout, Option<ScriptPlace>)> {
        let mut all = self.all().flat_map(|s| &s.blocks);
        let (_, layout, place) = all.find(|(own, _, _)| own == name)?;
        Some((layout, *place))
    }

    /// The uniforms that the browser keeps, each once.
    pub fn active_uniforms(&self) -> Vec<&DeclaredInput> {
        let mut found: Vec<&DeclaredInput> = Vec::new();
        for uniform in self.all().flat_map(|s| &s.uniforms).filter(|u| u.is_active) {
            if !found.iter().any(|known| known.name == uniform.name) {
                found.push(uniform);
            }
        }
        found
    }

    /// Whether a word appears in a shader, in any place.
    pub fn mention(&self, word: &str) -> bool {
        self.all()
            .any(|s| s.mentions(word) || s.members.iter().any(|m| m == word))
    }
}
