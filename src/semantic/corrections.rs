//! Chooses between corrections that are all syntactically valid: the shader is checked with each,
//! and the one with the fewest errors is used.

use super::checker::ParsedShader;
use super::infer_channels::check_unit;
use super::problem::Problems;
use super::program::Program;
use super::unit::Unit;
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_syntax::{Choice, Correction, Name, ParseOptions, Search, Token, parse_corrected};
use shaderlint_text::{SetAt, Span};

/// Maximum number of checks of one shader.
const MAX_LOOKS: usize = 8;
/// Maximum number of tokens checked, not counting searches inside the checks.
const MAX_TOKENS: usize = 100_000;

/// A shader with syntax errors and its possible corrections.
pub(super) struct Corrected {
    /// Version and stage.
    pub options: ParseOptions,
    /// The corrections to choose from.
    pub choices: Vec<Choice>,
    /// The tokens before any correction.
    pub original: Vec<Token>,
    /// Names whose declarations were dropped.
    pub lost: Vec<Name>,
}

/// Result of checking a shader with some of the corrections.
pub(super) struct Recheck {
    pub program: Program,
    /// Errors from the parser.
    pub syntax: Vec<Diagnostic>,
    /// Errors from the checker.
    pub problems: Problems,
}

impl Recheck {
    pub fn new(program: Program, syntax: Vec<Diagnostic>, problems: Problems) -> Recheck {
        Recheck {
            program,
            syntax,
            problems,
        }
    }

    /// Total number of errors.
    fn count(&self) -> usize {
        self.syntax.len() + self.problems.len()
    }

    /// The tokens in the text that are errors however the code around them is parsed.
    fn faulty_words(&self) -> FxHashSet<Span> {
        let problems = self.problems.all.iter();
        let words = problems.filter_map(|p| self.program.faulty_word(p));
        words.map(|at| self.program.span(at)).collect()
    }
}

impl Corrected {
    /// Checks the shader, which was parsed with the first correction of each choice and the errors
    /// in `syntax`, and tries the alternatives. Returns the best result, including syntax errors.
    pub fn choose(
        &self,
        parsed: ParsedShader,
        syntax: Vec<Diagnostic>,
        unit: &Unit,
        search: &mut Search,
    ) -> Recheck {
        let (program, problems) = check_unit(parsed, unit, search);
        let mut found = Recheck::new(program, syntax, problems);
        let mistakes = self.choices.len();
        let size = self.original.len();
        let mut made = vec![Some(0); mistakes];
        let mut standing = found.count();
        let mut has_searched = false;
        let mut words = found.faulty_words();
        search.within(MAX_TOKENS.min(MAX_LOOKS * size), |search| {
            for (i, choice) in self.choices.iter().enumerate() {
                let others = (1..choice.len()).map(Some).chain([None]);
                let best = search.fewest(
                    (standing, mistakes),
                    size,
                    others,
                    |search, other, below| {
                        has_searched = true;
                        set(&mut made, i, *other);
                        self.look(&mut found, &made, unit, below, search);
                        let now = found.faulty_words();
                        // Code that does not parse is not checked: what is wrong in it still counts.
                        let hides = other.is_none()
                            && !choice.iter().any(Correction::moves_scopes)
                            && !choice.first().is_some_and(|c| parts_words(c, &words));
                        let hidden = match hides {
                            true => self.unnamed(&words, &now, unit),
                            false => 0,
                        };
                        let faults = found.count() + hidden;
                        if faults < below && other.is_some() {
                            words = now;
                        }
                        Some(faults)
                    },
                );
                if let Some((_, fewer)) = best {
                    standing = fewer;
                }
                set(&mut made, i, best.map_or(Some(0), |(best, _)| best));
            }
        });
        if has_searched {
            self.look(&mut found, &made, unit, usize::MAX, search);
        }
        found
    }

    /// Number of different faulty words that are none in another reading.
    fn unnamed(&self, words: &FxHashSet<Span>, now: &FxHashSet<Span>, unit: &Unit) -> usize {
        let texts = |words: &FxHashSet<Span>| -> FxHashSet<&str> {
            words.iter().map(|word| unit.sources.text(*word)).collect()
        };
        texts(words).difference(&texts(now)).count()
    }

    /// Parses and checks the shader with other corrections, stopping after `enough` errors.
    fn look(
        &self,
        found: &mut Recheck,
        made: &[Option<usize>],
        unit: &Unit,
        enough: usize,
        search: &mut Search,
    ) {
        let corrections: Vec<&Correction> = self
            .choices
            .iter()
            .zip(made)
            .filter_map(|(choice, made)| choice.get((*made)?))
            .collect();
        let mut parsed = found.program.take_parsed();
        parsed.tokens.tokens = self.original.clone();
        let parse = parse_corrected(
            &parsed.sources,
            &mut parsed.tokens,
            &parsed.names,
            self.options,
            &corrections,
        );
        // Syntax errors count too.
        parsed.enough = enough.saturating_sub(parse.diagnostics.len());
        parsed.tree = parse.tree;
        parsed.tree.lost.extend(&self.lost);
        let (program, problems) = check_unit(parsed, unit, search);
        *found = Recheck::new(program, parse.diagnostics, problems);
    }
}

/// Whether a correction inserts a token between two faulty words, or removes one beside a faulty word:
/// this is probably not code.
fn parts_words(correction: &Correction, words: &FxHashSet<Span>) -> bool {
    let gap = correction.diagnostic().span;
    let is_word = |at: u32| words.iter().any(|word| word.start == at || word.end == at);
    let (before, after) = (is_word(gap.start), is_word(gap.end));
    match correction.is_insertion() {
        true => !gap.is_empty() && before && after,
        false => correction.is_removal() && (before || after),
    }
}

fn set(made: &mut [Option<usize>], at: usize, to: Option<usize>) {
    made.set_at(at, to);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::MAX_ERRORS;
    use crate::{Dialect, Pass, Stage, with_prelude};
    use shaderlint_syntax::{GlContext, Search, parse, preprocess};
    use std::sync::Arc;

    /// Number of errors found by a check that may stop after `enough`.
    fn count(code: &str, enough: usize) -> usize {
        let dialect = Dialect::ShaderToy(Pass::Image);
        let (sources, files) = with_prelude(dialect, code);
        let unit = Unit {
            dialect,
            infer_channels: true,
            ..Unit::complete(&sources, &files, Stage::Fragment)
        };
        let mut read = preprocess(&sources, &files, true, GlContext::WEBGL2);
        let options = ParseOptions {
            version: read.version,
            is_fragment: true,
        };
        let search = &mut Search::for_text();
        let parse = parse(&sources, &mut read.tokens, &read.names, options, search);
        let parsed = ParsedShader {
            sources: Arc::clone(&sources),
            tokens: read.tokens,
            names: read.names,
            tree: parse.tree,
            version: read.version,
            context: GlContext::WEBGL2,
            has_errors: true,
            enough,
        };
        check_unit(parsed, &unit, search).1.len()
    }

    #[test]
    fn capped_error_counts_compare_like_full_counts() {
        let heads = [
            "",
            // Their uses show that both are a `vec2`.
            "float v = p; v.x += 1.0; v.y += v.x; float w = p; w.x += 1.0; w.y += w.x;",
            // With a 3D channel all but one lookup are valid.
            "c += texture(iChannel0, vec3(p, 0.0)); c += texture(iChannel0, p);
             c += textureLod(iChannel0, vec3(p, 1.0), 0.0); c += texture(iChannel0, vec3(p, 1.0));",
        ];
        let errors = ["", "c = 1;", "c.x = 1; int n = 2.5; d = 3.0;"];
        for head in heads {
            for first in errors {
                for last in errors {
                    let code = format!(
                        "void mainImage(out vec4 c, in vec2 p) {{ {first} {head} {last} }}"
                    );
                    let all = count(&code, MAX_ERRORS);
                    for below in 0..8 {
                        let found = count(&code, below);
                        assert_eq!(found.min(below), all.min(below), "{below} {code}");
                    }
                }
            }
        }
    }
}
