//! The fixes that a report offers: those that work, and how many there are.

use super::look::look;
use crate::check_context::CheckContext;
use crate::findings::report::Report;
use crate::options::Options;
use shaderlint_diagnostic::{Applicability, Diagnostic, Severity};
use shaderlint_lint::{Settings, failing_fixes};
use shaderlint_project::Files;
use std::sync::Arc;

/// The number of findings that can be fixed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Offer {
    /// Findings with a safe fix. Applying them may reveal more.
    pub safe: usize,
    /// Findings with an unsafe fix.
    pub others: usize,
}

impl Offer {
    /// Counts the fixes in a report.
    pub fn of(report: &Report) -> Offer {
        let of = |applicability: Applicability| {
            let mendable = report.diagnostics.iter().filter(|d| {
                let fix = d.fix.as_ref();
                fix.is_some_and(|f| f.applicability == applicability) && report.can_apply(d)
            });
            mendable.count()
        };
        Offer {
            safe: of(Applicability::Safe),
            others: of(Applicability::Unsafe),
        }
    }
}

impl Report {
    /// Retracts the fixes of errors that fail when they are tried alone: their titles become help. `text` is
    /// the input of the report.
    pub fn retract_failing_fixes(
        &mut self,
        (name, text): (&str, &str),
        options: &Options,
        files: &dyn Files,
    ) {
        for number in self.failing_fixes((name, text), options, files, |_| true) {
            if let Some(found) = self.diagnostics.get_mut(number)
                && let Some(fix) = found.fix.take()
            {
                found.help.push(fix.title);
            }
        }
    }

    /// The numbers of the errors whose fix fails when it is tried alone, among those that `concerns`
    /// selects. `text` is the input of the report.
    pub fn failing_fixes(
        &self,
        (name, text): (&str, &str),
        options: &Options,
        files: &dyn Files,
        concerns: impl Fn(&Diagnostic) -> bool,
    ) -> Vec<usize> {
        let is_offered =
            |d: &Diagnostic| d.severity == Severity::Error && d.fix.is_some() && concerns(d);
        if !self.diagnostics.iter().any(is_offered) {
            return Vec::new();
        }
        let options = Options {
            settings: Arc::new(Settings::of_rules(&[])),
            ..options.clone()
        };
        let context = CheckContext::keeping(&options, files);
        let Some(seen) = look(name, text, context) else {
            return Vec::new();
        };
        let offsets = self.offsets();
        // The same error in a check of the front end alone.
        let number = |d: &Diagnostic| {
            let offset = d.span.start.saturating_sub(seen.span.start);
            let is_one = |(own, at): (&Diagnostic, &u32)| {
                *at == offset && own.rule == d.rule && own.message == d.message && is_offered(own)
            };
            self.diagnostics.iter().zip(&offsets).position(is_one)
        };
        let failing = failing_fixes(
            text,
            &seen,
            |d| number(d).is_some(),
            |text| look(name, text, context),
        );
        failing.into_iter().filter_map(number).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use shaderlint_project::NoFiles;

    /// The fixes and the help of the errors.
    fn offered(name: &str, text: &str) -> [Vec<String>; 2] {
        let options = Options::default();
        let mut report = check(name, text, &options, &NoFiles);
        report.retract_failing_fixes((name, text), &options, &NoFiles);
        let errors = report.diagnostics.iter();
        let errors = errors.filter(|d| d.severity == Severity::Error);
        let fixes = errors
            .clone()
            .filter_map(|d| Some(d.fix.as_ref()?.title.clone()));
        let help = errors.clone().flat_map(|d| d.help.clone());
        [fixes.collect(), help.collect()]
    }

    #[test]
    fn fixes_that_leave_an_error_become_help() {
        let code = |call: &str| {
            format!(
                "float wave(vec2 p) {{ return sin(p.x) * p.y; }}\n\
                 void mainImage(out vec4 c, in vec2 p) {{ c = vec4({call}); }}\n"
            )
        };
        let works = ["did you mean `wave`?".to_string()];
        let [fixes, help] = offered("a.glsl", &code("wawe(p)"));
        assert_eq!((fixes.as_slice(), help.len()), (&works[..], 0));
        let [fixes, help] = offered("a.glsl", &code("wawe(true)"));
        assert_eq!((fixes.len(), help.as_slice()), (0, &works[..]));
        let export = format!(
            r#"{{"renderpass":[{{"type":"image","code":{}}}]}}"#,
            serde_json::to_string(&code("wawe(true)")).unwrap()
        );
        let [fixes, help] = offered("a.json", &export);
        assert_eq!((fixes.len(), help.as_slice()), (0, &works[..]));
    }

    /// A fix that adds a line is tried with the line breaks of the text.
    #[test]
    fn fixes_are_verified_with_the_line_breaks_of_the_text() {
        let text = "#version 300 es\nprecision highp vec3;\nout vec4 c;\nuniform float k;\n\
                    void main() { c = vec4(k); }\n";
        let [fixes, _] = offered("a.frag", text);
        assert_eq!(fixes.len(), 2, "{fixes:?}");
        assert_eq!(offered("a.frag", &text.replace('\n', "\r\n"))[0], fixes);
    }
}
