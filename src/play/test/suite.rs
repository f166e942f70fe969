//! The tests of a file with the values of their parameters.
//!
//! Values are GLSL expressions in comments. The shader is checked once more with a function for each
//! case, which declares the values as constants and calls the test: so they may be anything that
//! GLSL accepts, and mistakes in them are reported at their place.

use super::marks::{
    AnyMark, EachMark, Marked, Marks, TestProblem, TextureMark, marks, shared_textures,
};
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_engine::Analysis;
use shaderlint_explain::analyze;
use shaderlint_semantic::{Function, FunctionRef, Program, Scalar, Type, Unit};
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::{FileId, Role, Sources, Span};
use std::sync::Arc;

/// Maximum number of cases of a test, over all combinations of its values.
const MAX_CASES: usize = 1000;
/// Prefix of generated names.
const OWN: &str = "shaderlint_";

/// The tests of a file.
#[derive(Default)]
pub struct TestSuite {
    /// The shader with a function for each case, if a test has parameters.
    composed: Option<Analysis>,
    /// The tests in source order.
    pub tests: Vec<Test>,
    /// The textures of all tests.
    pub textures: Vec<TextureMark>,
    /// What is wrong with comments that belong to no test.
    pub problems: Vec<TestProblem>,
}

/// A test or a benchmark.
pub struct Test {
    /// Name of the function.
    pub name: String,
    /// Span of the name.
    pub at: Span,
    /// The function.
    pub function: FunctionRef,
    /// Whether it is a benchmark: `bench_*`.
    pub is_bench: bool,
    /// Why it is expected to fail.
    pub fails: Option<String>,
    /// Its textures.
    pub textures: Vec<TextureMark>,
    /// What is wrong with its comments or parameters; it cannot run then.
    pub problems: Vec<TestProblem>,
    /// Whether it has parameters without values, no comment about them and is not called: probably
    /// not meant to be a test outside of a file of tests.
    pub may_be_other: bool,
    /// The cases.
    pub cases: Vec<TestCase>,
}

/// A test with values.
#[derive(Clone)]
pub struct TestCase {
    /// The test.
    pub function: FunctionRef,
    /// The function that runs it: the test itself, or one that calls it with values.
    pub entry: FunctionRef,
    /// The parameters with fixed values, and the values as GLSL.
    pub values: Vec<(String, String)>,
    /// The parameters with random values.
    pub any: Vec<AnyParameter>,
}

/// A parameter that takes values of an interval.
#[derive(Clone, Debug)]
pub struct AnyParameter {
    /// Name of the parameter.
    pub name: String,
    /// Type of the parameter: a scalar or vector of numbers.
    pub ty: Type,
    /// Functions that return the lowest and the highest value.
    pub ends: [FunctionRef; 2],
    /// Span of the interval.
    pub at: Span,
}

/// A parameter of a test, with its values.
struct TestParameter {
    name: String,
    ty: Type,
    source: ValueSource,
}

enum ValueSource {
    Each(Vec<Marked>),
    Any(AnyMark),
}

/// A test before its cases are composed.
struct Draft {
    test: Test,
    parameters: Vec<TestParameter>,
}

impl TestSuite {
    /// The tests and benchmarks of a file.
    pub fn of(analysis: &Analysis, file: FileId) -> TestSuite {
        let program = &analysis.program;
        let Some(source) = program.sources.file(file) else {
            return TestSuite::default();
        };
        let mut drafts = Vec::new();
        let mut above = Vec::new();
        for (function, name_at, start) in functions(program, source.span()) {
            let offset = (start.saturating_sub(source.base)) as usize;
            let marks = marks(&source.text, source.base, offset);
            above.push(marks.start..offset);
            drafts.extend(draft(program, function, name_at, marks));
        }
        let is_of_test = |offset: usize| above.iter().any(|range| range.contains(&offset));
        let (textures, problems) = shared_textures(&source.text, source.base, is_of_test);
        drafts.sort_by_key(|draft| draft.test.at.start);
        let composed = compose(analysis, file, &mut drafts);
        TestSuite {
            composed,
            tests: drafts.into_iter().map(|draft| draft.test).collect(),
            textures,
            problems,
        }
    }

    /// The shader that contains the cases. `given` is that of the file.
    pub fn analysis<'a>(&'a self, given: &'a Analysis) -> &'a Analysis {
        self.composed.as_ref().unwrap_or(given)
    }
}

/// The functions of a file that are named like tests or benchmarks and have their types, with the
/// span of the name and the start of the definition.
fn functions(program: &Program, own: Span) -> Vec<(FunctionRef, Span, u32)> {
    let all = (0..).map(FunctionRef).zip(&program.functions);
    let tests = all.filter(|(_, f)| f.is_test(&program.names) || f.is_bench(&program.names));
    let found = tests.filter_map(|(id, function)| {
        let definition = program.tree.function(function.definition?)?;
        let span = program.token(definition.ident.token)?.span;
        let start = program.token(definition.extent.first)?.span.start;
        own.contains(span).then_some((id, span, start))
    });
    found.collect()
}

fn draft(program: &Program, id: FunctionRef, at: Span, marks: Marks) -> Option<Draft> {
    let function = program.function(id)?;
    let names = parameter_names(program, function);
    let has_values = !marks.each.is_empty() || !marks.any.is_empty();
    let is_called = || program.calls.iter().any(|call| call.callee == id);
    let may_be_other = !names.is_empty() && !has_values && marks.problems.is_empty();
    if may_be_other && is_called() {
        return None;
    }
    let mut problems = marks.problems;
    let mut parameters = Vec::new();
    check_names(&names, &marks.each, &marks.any, &mut problems);
    for (number, (name, parameter)) in names.iter().zip(&function.params).enumerate() {
        let each = marks.each.iter().find(|mark| match &mark.name {
            Some(own) => own.text == *name,
            None => number == 0 && names.len() == 1,
        });
        let any = marks.any.iter().find(|mark| mark.name.text == *name);
        let source = match (each, any) {
            (Some(each), _) => ValueSource::Each(each.values.clone()),
            (None, Some(any)) => ValueSource::Any(any.clone()),
            (None, None) => {
                if problems.is_empty() {
                    problems.push(without_values(at, name));
                }
                continue;
            }
        };
        if let ValueSource::Any(any) = &source
            && !is_random(parameter.ty)
        {
            let ty = program.type_name(parameter.ty);
            problems.push(TestProblem::new(
                any.name.at,
                format!("`{ty}` has no intervals; list its values with `// each:`"),
            ));
        }
        parameters.push(TestParameter {
            name: name.clone(),
            ty: parameter.ty,
            source,
        });
    }
    Some(Draft {
        test: Test {
            name: program.names.text(function.name).to_string(),
            at,
            function: id,
            is_bench: function.is_bench(&program.names),
            fails: marks.fails,
            textures: marks.textures,
            problems,
            may_be_other,
            cases: Vec::new(),
        },
        parameters,
    })
}

fn without_values(at: Span, name: &str) -> TestProblem {
    let message = match name {
        "" => "a parameter of a test needs a name".to_string(),
        name => format!(
            "parameter `{name}` has no values; write `// each: {name} = 0.0, 1.0` or \
             `// any: {name} in -10..10` directly above the test"
        ),
    };
    TestProblem { at, message }
}

/// Names of the parameters; empty for those without a name.
fn parameter_names(program: &Program, function: &Function) -> Vec<String> {
    let definition = function.definition.and_then(|id| program.tree.function(id));
    let params = definition.map_or(&[][..], |d| program.tree.params(d.params));
    let named = params.iter().filter(|_| !function.params.is_empty());
    let name = |ident: shaderlint_syntax::ast::Ident| program.names.text(ident.name).to_string();
    named.map(|p| p.ident.map_or(String::new(), name)).collect()
}

/// Reports comments about parameters that do not exist or have values already.
fn check_names(
    names: &[String],
    each: &[EachMark],
    any: &[AnyMark],
    problems: &mut Vec<TestProblem>,
) {
    let mut seen: Vec<&str> = Vec::new();
    let named = each.iter().filter_map(|mark| mark.name.as_ref());
    for name in named.chain(any.iter().map(|mark| &mark.name)) {
        let message = if !names.contains(&name.text) {
            format!("the test has no parameter `{}`", name.text)
        } else if seen.contains(&name.text.as_str()) {
            format!("parameter `{}` has values already", name.text)
        } else {
            seen.push(&name.text);
            continue;
        };
        problems.push(TestProblem::new(name.at, message));
    }
    let unnamed: Vec<&EachMark> = each.iter().filter(|mark| mark.name.is_none()).collect();
    for (number, mark) in unnamed.into_iter().enumerate() {
        let message = match names.len() {
            0 => "the test has no parameters".to_string(),
            1 if number == 0 && seen.is_empty() => continue,
            1 => "the parameter has values already".to_string(),
            _ => {
                "the test has several parameters; name the one that takes these values".to_string()
            }
        };
        problems.push(TestProblem::new(mark.at, message));
    }
}

/// Whether random values of a type exist.
const fn is_random(ty: Type) -> bool {
    match ty.numeric() {
        Some((Scalar::Bool, ..)) | None => false,
        Some((_, columns, _)) => columns == 1,
    }
}

/// A test whose cases are called from generated functions.
struct Composer<'a> {
    program: &'a Program,
    sources: Arc<Sources>,
    file: FileId,
    base: u32,
    files: Vec<FileId>,
    count: usize,
}

/// The names of generated functions, until the shader is checked.
struct DraftCase {
    entry: String,
    values: Vec<(String, String)>,
    any: Vec<(AnyMark, Type, String)>,
}

/// Adds the cases to tests. Returns the shader with the functions that run them, if there are any.
fn compose(analysis: &Analysis, file: FileId, drafts: &mut [Draft]) -> Option<Analysis> {
    let program: &Program = &analysis.program;
    for draft in drafts.iter_mut().filter(|d| d.parameters.is_empty()) {
        draft.test.cases.push(TestCase {
            function: draft.test.function,
            entry: draft.test.function,
            values: Vec::new(),
            any: Vec::new(),
        });
    }
    let is_ready =
        |draft: &&mut Draft| !draft.parameters.is_empty() && draft.test.problems.is_empty();
    let mut composer = Composer {
        program,
        sources: program.sources.clone(),
        file,
        base: program.sources.file(file)?.base,
        files: analysis.files().to_vec(),
        count: 0,
    };
    let mut all = Vec::new();
    for draft in drafts.iter_mut().filter(is_ready) {
        let cases = composer.cases(draft)?;
        all.push((draft, cases));
    }
    if composer.count == 0 {
        return None;
    }
    let checked = analyze(&Unit {
        sources: &composer.sources,
        files: &composer.files,
        stage: program.stage,
        dialect: program.dialect,
        context: program.context,
        infer_channels: program.dialect.is_shadertoy(),
        completeness: analysis.completeness,
    });
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let errors = checked.diagnostics.iter().filter(is_error);
    let mut errors: Vec<&Diagnostic> = errors.chain(&checked.open.unknown).collect();
    errors.sort_by_key(|d| d.span.start);
    errors.dedup_by_key(|d| d.span);
    let has_errors = checked.has_errors();
    let types = types_at(&checked.program);
    for (draft, cases) in all {
        draft.report(&checked.program, &errors, &types);
        if draft.test.problems.is_empty() {
            let test = draft.test.function;
            let made = cases
                .into_iter()
                .filter_map(|case| case.made(&checked.program, test));
            draft.test.cases = made.collect();
        }
    }
    let (host, files) = (analysis.host, composer.files);
    Some(Analysis::new(
        checked,
        has_errors,
        host,
        &files,
        Arc::default(),
    ))
}

impl Draft {
    /// Takes the errors in the values of the parameters.
    fn report(
        &mut self,
        program: &Program,
        errors: &[&Diagnostic],
        types: &FxHashMap<(u32, u32), Type>,
    ) {
        for parameter in &self.parameters {
            let values = match &parameter.source {
                ValueSource::Each(values) => values.iter().collect(),
                ValueSource::Any(any) => vec![&any.low, &any.high],
            };
            for value in values {
                let found = types.get(&(value.at.start, value.at.end)).copied();
                let expected = program.type_name(parameter.ty);
                let why = match errors.iter().find(|e| e.span.touches(value.at)) {
                    Some(error) => error.message.clone(),
                    None => match found.filter(|ty| !fits(*ty, parameter.ty, &value.text)) {
                        Some(ty) => {
                            let found = program.type_name(ty);
                            format!("expected `{expected}`, found `{found}`")
                        }
                        None => continue,
                    },
                };
                let (text, name) = (&value.text, &parameter.name);
                self.test.problems.push(TestProblem::new(
                    value.at,
                    format!("invalid value `{text}` of `{name}`: {why}"),
                ));
            }
        }
    }
}

/// Whether a value of a type can be that of a parameter.
fn fits(found: Type, parameter: Type, text: &str) -> bool {
    found == parameter || found.is_error() || is_converted(text, parameter)
}

/// The types of all expressions, by their spans.
fn types_at(program: &Program) -> FxHashMap<(u32, u32), Type> {
    let all = (0..program.tree.exprs.len() as u32).map(ExprId);
    let typed = all.map(|id| {
        let span = program.expr_span(id);
        ((span.start, span.end), program.ty(id))
    });
    typed.collect()
}

/// Whether a value is a number, which is converted, so that `0` is a float and a vector.
fn is_converted(text: &str, ty: Type) -> bool {
    let number = text.trim_start_matches(['-', '+']).trim_start();
    let is_number = number.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && number
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || c == '.');
    is_number
        && ty
            .numeric()
            .is_some_and(|(scalar, ..)| scalar != Scalar::Bool)
}

impl DraftCase {
    fn made(self, program: &Program, function: FunctionRef) -> Option<TestCase> {
        let by_name = |name: &str| {
            let name = program.names.get(name)?;
            let at = program.functions.iter().position(|f| f.name == name)?;
            Some(FunctionRef(at as u32))
        };
        let any = self.any.into_iter().map(|(mark, ty, ends)| {
            let [low, high] = ["low", "high"].map(|end| by_name(&format!("{ends}{end}")));
            Some(AnyParameter {
                name: mark.name.text,
                ty,
                ends: [low?, high?],
                at: mark.low.at.to(mark.high.at),
            })
        });
        Some(TestCase {
            function,
            entry: by_name(&self.entry)?,
            values: self.values,
            any: any.collect::<Option<Vec<_>>>()?,
        })
    }
}

impl Composer<'_> {
    /// Composes the functions of all cases of a test. `None` if the text is too large.
    fn cases(&mut self, draft: &mut Draft) -> Option<Vec<DraftCase>> {
        let counts = draft.parameters.iter().map(|p| match &p.source {
            ValueSource::Each(values) => values.len(),
            ValueSource::Any(_) => 1,
        });
        let count = counts.fold(1_usize, usize::saturating_mul);
        if count > MAX_CASES {
            let message =
                format!("the values have {count} combinations; at most {MAX_CASES} can run");
            let problem = TestProblem::new(draft.test.at, message);
            draft.test.problems.push(problem);
            return Some(Vec::new());
        }
        let mut any = Vec::new();
        for parameter in &draft.parameters {
            if let ValueSource::Any(mark) = &parameter.source {
                let ends = format!("{OWN}{}_", self.next());
                for (end, value) in [("low", &mark.low), ("high", &mark.high)] {
                    let ty = self.program.type_name(parameter.ty);
                    self.prelude(format!("\n{ty} {ends}{end}() {{\n"))?;
                    self.constant(&format!("{OWN}value"), parameter.ty, value)?;
                    self.prelude(format!("return {OWN}value;\n}}\n"))?;
                }
                any.push((mark.clone(), parameter.ty, ends));
            }
        }
        let mut cases = Vec::new();
        for number in 0..count {
            cases.push(self.case(draft, number, any.clone())?);
        }
        Some(cases)
    }

    fn next(&mut self) -> usize {
        self.count += 1;
        self.count
    }

    /// Composes the function of a combination; the last parameter varies fastest.
    fn case(
        &mut self,
        draft: &Draft,
        number: usize,
        any: Vec<(AnyMark, Type, String)>,
    ) -> Option<DraftCase> {
        let entry = format!("{OWN}case_{}", self.next());
        let mut rest = number;
        let mut values: Vec<(&TestParameter, Option<&Marked>)> = Vec::new();
        for parameter in draft.parameters.iter().rev() {
            let value = match &parameter.source {
                ValueSource::Each(all) => {
                    let value = all.get(rest % all.len().max(1));
                    rest /= all.len().max(1);
                    value
                }
                ValueSource::Any(_) => None,
            };
            values.push((parameter, value));
        }
        values.reverse();
        let program = self.program;
        let name = |ty: Type| program.type_name(ty);
        let given = values.iter().filter(|(_, value)| value.is_none());
        let given = given.map(|(p, _)| format!("{} {}", name(p.ty), p.name));
        let given = given.collect::<Vec<_>>().join(", ");
        let returns = program.function(draft.test.function)?.returns;
        self.prelude(format!("\n{} {entry}({given}) {{\n", name(returns)))?;
        let mut arguments = Vec::new();
        for (at, (parameter, value)) in values.iter().enumerate() {
            let Some(value) = value else {
                arguments.push(parameter.name.clone());
                continue;
            };
            let constant = format!("{OWN}value_{at}");
            self.constant(&constant, parameter.ty, value)?;
            arguments.push(constant);
        }
        let returned = if returns == Type::VOID { "" } else { "return " };
        let call = format!("{}({})", draft.test.name, arguments.join(", "));
        self.prelude(format!("{returned}{call};\n}}\n"))?;
        let values = values
            .into_iter()
            .filter_map(|(parameter, value)| Some((parameter.name.clone(), value?.text.clone())));
        Some(DraftCase {
            entry,
            values: values.collect(),
            any,
        })
    }

    /// Declares a constant with a value of a comment.
    fn constant(&mut self, name: &str, ty: Type, value: &Marked) -> Option<()> {
        let ty_name = self.program.type_name(ty);
        let (open, close) = match is_converted(&value.text, ty) {
            true => (format!("{ty_name}("), ")"),
            false => (String::new(), ""),
        };
        self.prelude(format!("const {ty_name} {name} = {open}"))?;
        let offset = value.at.start.checked_sub(self.base)? as usize;
        let piece =
            Arc::make_mut(&mut self.sources).embed(self.file, offset, value.text.as_str())?;
        self.files.push(piece);
        self.prelude(format!("{close};\n"))
    }

    fn prelude(&mut self, text: String) -> Option<()> {
        let piece = Arc::make_mut(&mut self.sources).add("", None, Role::Prelude, text)?;
        self.files.push(piece);
        Some(())
    }
}

/// Notes about functions that are named like tests but cannot be tests.
pub fn unusable_tests(analysis: &Analysis, file: FileId) -> Vec<(String, Span)> {
    let program = &analysis.program;
    let own = program.sources.file(file).map(|f| f.span());
    let named = program.functions.iter().filter(|f| {
        let is_called_so = program.names.text(f.name).starts_with("test_");
        is_called_so && !f.is_test(&program.names)
    });
    let found = named.filter_map(|function| {
        let definition = program.tree.function(function.definition?)?;
        let span = program.token(definition.ident.token)?.span;
        let name = program.names.text(function.name).to_string();
        own?.contains(span).then_some((name, span))
    });
    found.collect()
}
