//! Shaders for the unit tests of the analyses.

use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use shaderlint_ir::{Module, lower};
use shaderlint_semantic::{
    CheckedShader, Completeness, Dialect, Pass, Program, Stage, Unit, check_shader, with_prelude,
};
use shaderlint_syntax::Search;

/// The cases of a table: lines `code => what is found`, without headings and comments.
pub(super) fn cases(table: &str) -> impl Iterator<Item = (&str, &str)> {
    let lines = table.lines();
    let lines = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| {
        let (code, found) = line.split_once(" =>").unwrap();
        (code, found.trim())
    })
}

/// A ShaderToy image pass with the analyses that others need.
pub(super) struct TestShader {
    pub program: Program,
    pub module: Module,
    pub calls: Calls,
    pub defs: ReachingDefinitions,
    ranges: Ranges,
}

impl TestShader {
    /// Checks the code and asserts that it has no errors.
    pub fn of(code: &str) -> TestShader {
        let shader = checked(code, Completeness::Complete);
        assert!(shader.is_valid(), "{:?}", shader.problems.all);
        TestShader::lowered(shader.program)
    }

    /// The analyses of a program.
    pub fn lowered(program: Program) -> TestShader {
        let module = lower(&program);
        let calls = Calls::of(&module);
        TestShader {
            defs: ReachingDefinitions::of(&program, &module, &calls),
            ranges: Ranges::default(),
            program,
            module,
            calls,
        }
    }

    pub fn query(&self) -> Query<'_> {
        Query {
            program: &self.program,
            module: &self.module,
            defs: &self.defs,
            ranges: &self.ranges,
        }
    }
}

/// Checks the code of a ShaderToy image pass.
pub(super) fn checked(code: &str, completeness: Completeness) -> CheckedShader {
    let dialect = Dialect::ShaderToy(Pass::Image);
    let (sources, files) = with_prelude(dialect, code);
    let unit = Unit {
        dialect,
        infer_channels: true,
        completeness,
        ..Unit::complete(&sources, &files, Stage::Fragment)
    };
    check_shader(&unit, &mut Search::for_text())
}
