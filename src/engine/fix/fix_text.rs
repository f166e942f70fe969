//! Applies fixes to a text in rounds, checking it again after each.

use super::look::look;
use super::verify::equal;
use crate::check_context::CheckContext;
use crate::findings::report::Report;
use crate::options::Options;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_exec::Equality;
use shaderlint_lint::{Allow, Fixed, Look, Proof, Shown, fix};
use shaderlint_project::Files;
use shaderlint_semantic::{Dialect, Pass, Program};

/// Number of instructions that may run to compare images of a text.
const FUEL: u64 = 250_000_000;

/// Applies the fixes of a text, checking it again after each round. Safe fixes are verified by
/// comparing the images, as far as they can be drawn.
pub fn fix_text(
    name: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
    allow: Allow,
) -> Fixed {
    let context = CheckContext::keeping(options, files);
    let mut fuel = FUEL;
    let compare =
        |before: &Look, after: &Look| compare_images(&before.shaders, &after.shaders, &mut fuel);
    fix(text, allow, |text| look(name, text, context), compare)
}

/// Whether fixes keep the images of a text, as far as that can be verified.
fn compare_images(before: &[Shown], after: &[Shown], fuel: &mut u64) -> Proof {
    if before.len() != after.len() {
        return Proof::Unknown;
    }
    let is_pass = |shader: &Shown| shader.program.dialect != Dialect::ShaderToy(Pass::Common);
    let pairs = before.iter().zip(after);
    let pairs = pairs.filter(|(before, _)| is_pass(before));
    let all = pairs.map(|(before, after)| match before.is_drawn && after.is_drawn {
        _ if is_unchanged(&before.program, &after.program) => Proof::SameCode,
        true => compare_image(&before.program, &after.program, fuel),
        false => Proof::Unknown,
    });
    all.max().unwrap_or(Proof::Unknown)
}

/// Whether fixes keep the image of a shader.
fn compare_image(before: &Program, after: &Program, fuel: &mut u64) -> Proof {
    match equal(before, after, fuel) {
        Ok(Equality::Proved) => Proof::SameCode,
        Ok(Equality::SampledEqual { .. }) => Proof::SameBits,
        Ok(Equality::Differs { .. }) => Proof::Refuted,
        Ok(Equality::TooLong) | Err(_) => Proof::Unknown,
    }
}

/// Whether both programs have the same tokens.
fn is_unchanged(before: &Program, after: &Program) -> bool {
    let texts = |program: &Program| {
        let tokens = program.tokens.tokens.iter();
        tokens
            .map(|token| program.sources.text(token.span).to_string())
            .collect::<Vec<_>>()
    };
    texts(before) == texts(after)
}

impl Report {
    /// Marks findings whose fixes were not applied. `left` has their positions as in
    /// [`Fixed::left`], in the text of this report.
    pub fn leave_alone(&mut self, left: &[Diagnostic]) {
        let offsets = self.offsets();
        for (found, start) in self.diagnostics.iter_mut().zip(offsets) {
            let is_it = |l: &Diagnostic| (l.rule, l.span.start) == (found.rule, start);
            if !left.iter().any(is_it) {
                continue;
            }
            // The fix would change the image: it is mentioned, but not offered.
            if let Some(fix) = found.fix.take() {
                found.notes.push(format!(
                    "not fixed because the image would change: {}",
                    fix.title
                ));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::check_text;
    use shaderlint_diagnostic::{Fix, Origin, Severity};
    use shaderlint_project::NoFiles;
    use shaderlint_text::{Edit, Encoding, Role, Span};

    /// Adds safe fixes that replace one number with another.
    fn offer_fix(report: &mut Report, number: &str, other: &str) {
        let users = report.sources.files().iter();
        let users = users.filter(|file| file.role == Role::User);
        let places = users.flat_map(|file| {
            let found = file.text.match_indices(number);
            found.map(|(at, _)| file.base + at as u32)
        });
        for start in places.collect::<Vec<_>>() {
            let span = Span::new(start, start + number.len() as u32);
            let fix = Fix::safe(format!("write `{other}`"), vec![Edit::replace(span, other)]);
            let found = Diagnostic::new("number", Origin::Rule, Severity::Info, span, number);
            report.diagnostics.push(found.fix(fix));
        }
    }

    /// A report in which `0.5` has the wrong fix `0.6`, and `2.5` the right fix `25e-1`.
    fn check_report(name: &str, text: &str, options: &Options) -> Report {
        let context = CheckContext::keeping(options, &NoFiles);
        let mut report = check_text(name, text, Encoding::Utf8, context);
        report.diagnostics.clear();
        offer_fix(&mut report, "0.5", "0.6");
        offer_fix(&mut report, "2.5", "25e-1");
        report
    }

    /// The wrong fix is rejected with a note; the right one is applied.
    fn check(name: &str, text: &str, proof: Proof) {
        let options = Options::default();
        let mut fuel = FUEL;
        let fixed = fix(
            text,
            Allow::Safe,
            |text| check_report(name, text, &options).look(text),
            |before, after| compare_images(&before.shaders, &after.shaders, &mut fuel),
        );
        assert_eq!(fixed.text, text.replace("2.5", "25e-1"), "{name}");
        assert_eq!(fixed.proofs, [proof], "{name}");
        assert_eq!(fixed.left.len(), 1, "{name}");
        let mut report = check_report(name, &fixed.text, &options);
        report.leave_alone(&fixed.left);
        let left = report.diagnostics.iter().find(|d| d.message == "0.5");
        let left = left.unwrap_or_else(|| panic!("{name}"));
        let note = "not fixed because the image would change: write `0.6`";
        assert_eq!(
            (left.fix.is_none(), left.notes.as_slice()),
            (true, &[note.to_string()][..])
        );
    }

    #[test]
    fn fixes_that_change_the_image_are_not_applied() {
        let value = "max(0.5, fract(gl_FragCoord.x * 0.1)), 2.5, u, 1";
        let new = format!(
            "#version 300 es\nprecision highp float;\nuniform float u;\nout vec4 o;\n\
             void main() {{ o = vec4({value}); }}\n"
        );
        check("a.frag", &new, Proof::SameCode);
        let old = format!(
            "precision mediump float;\nuniform float u;\n\
             void main() {{ gl_FragColor = vec4({value}); }}\n"
        );
        check("a.frag", &old, Proof::SameCode);
        check(
            "a.js",
            &format!("const shader = `{new}`;\n"),
            Proof::SameCode,
        );
        let toy = "void mainImage(out vec4 c, in vec2 p) \
                   { c = vec4(max(0.5, fract(p.x * 0.1)), 2.5, iTime, 1); }\n";
        check("a.glsl", toy, Proof::SameCode);
        // Common code is drawn by each pass.
        let shared = "float f(float x) { return max(0.5, fract(x * 0.1)); }";
        let image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x), 2.5, iTime, 1); }";
        let sound = "vec2 mainSound(int n, float t) { return vec2(sin(t * f(t) * 2.5)); }";
        for (kind, code) in [("image", image), ("sound", sound)] {
            let export = format!(
                r#"{{"renderpass":[{{"type":"common","code":"{shared}"}},{{"type":"{kind}","code":"{code}"}}]}}"#
            );
            check("a.json", &export, Proof::SameCode);
        }
    }

    /// Fixes of fragments that cannot be drawn are applied unverified.
    #[test]
    fn fragments_that_cannot_be_drawn_are_fixed_unverified() {
        let part = "float f(float x) { return max(0.5, x); }\n";
        let options = Options::default();
        let mut fuel = FUEL;
        let fixed = fix(
            part,
            Allow::Safe,
            |text| check_report("a.glsl", text, &options).look(text),
            |before, after| compare_images(&before.shaders, &after.shaders, &mut fuel),
        );
        assert_eq!(fixed.text, part.replace("0.5", "0.6"));
        assert_eq!(fixed.proofs, [Proof::Unknown]);
    }
}
