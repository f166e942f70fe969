//! Between the corrections that the syntax allows, the one that means something: the shader is
//! checked with each of them, and the one that leaves the fewest errors is taken.

use super::checker::{Parsed, Problems};
use super::judge::judge;
use super::program::Program;
use super::unit::Unit;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_syntax::{Choice, Correction, Name, ParseOptions, Search, Token, parse_corrected};

/// Most times that one shader is checked for it.
const MAX_LOOKS: usize = 8;
/// Most tokens that are checked for it, what its checks try themselves not counted.
const MAX_TOKENS: usize = 100_000;

/// How a shader that cannot be read as it stands was corrected.
pub(super) struct Corrected {
    /// How it is written.
    pub options: ParseOptions,
    /// The corrections to choose from.
    pub choices: Vec<Choice>,
    /// Its tokens before any of them.
    pub original: Vec<Token>,
    /// Names whose declarations are gone.
    pub lost: Vec<Name>,
}

/// A shader, checked under some corrections.
pub(super) struct Recheck {
    pub program: Program,
    /// What the parser says.
    pub syntax: Vec<Diagnostic>,
    /// What the checker finds.
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

    /// How many errors there are.
    fn count(&self) -> usize {
        self.syntax.len() + self.problems.len()
    }
}

impl Corrected {
    /// Checks the shader, parsed with the first correction of each choice and with `syntax` wrong
    /// then, or with better ones. Returns all that is wrong with it, the syntax included.
    pub fn settle(
        &self,
        parsed: Parsed,
        syntax: Vec<Diagnostic>,
        unit: &Unit,
        search: &mut Search,
    ) -> Recheck {
        let (program, problems) = judge(parsed, unit, search);
        let mut found = Recheck::new(program, syntax, problems);
        let mistakes = self.choices.len();
        let size = self.original.len();
        let mut made = vec![Some(0); mistakes];
        let mut standing = found.count();
        let mut is_tried = false;
        search.within(MAX_TOKENS.min(MAX_LOOKS * size), |search| {
            for (i, choice) in self.choices.iter().enumerate() {
                let others = (1..choice.len()).map(Some).chain([None]);
                let best = search.fewest(
                    (standing, mistakes),
                    size,
                    others,
                    |search, other, below| {
                        is_tried = true;
                        set(&mut made, i, *other);
                        self.look(&mut found, &made, unit, below, search);
                        Some(found.count())
                    },
                );
                if let Some((_, fewer)) = best {
                    standing = fewer;
                }
                set(&mut made, i, best.map_or(Some(0), |(best, _)| best));
            }
        });
        if is_tried {
            self.look(&mut found, &made, unit, usize::MAX, search);
        }
        found
    }

    /// Reads and checks the shader again with other corrections, until so many errors are found.
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
        // Those of the syntax count too.
        parsed.enough = enough.saturating_sub(parse.diagnostics.len());
        parsed.tree = parse.tree;
        parsed.tree.lost.extend(&self.lost);
        let (program, problems) = judge(parsed, unit, search);
        *found = Recheck::new(program, parse.diagnostics, problems);
    }
}

fn set(made: &mut [Option<usize>], at: usize, to: Option<usize>) {
    if let Some(slot) = made.get_mut(at) {
        *slot = to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checker::MAX_ERRORS;
    use crate::dialect::Dialect;
    use crate::part::Wholeness;
    use crate::{Pass, Stage};
    use shaderlint_syntax::{Search, parse, preprocess};
    use shaderlint_text::{Role, Sources};
    use std::sync::Arc;

    /// How many errors a check finds that is made for a goal.
    fn count(code: &str, enough: usize) -> usize {
        let dialect = Dialect::ShaderToy(Pass::Image);
        let mut sources = Sources::new();
        let prelude = dialect.host().prelude([None; 4]);
        let files = [
            sources.add("prelude", None, Role::Prelude, prelude),
            sources.add("test", None, Role::User, code),
        ];
        let files: Vec<_> = files.into_iter().flatten().collect();
        let sources = Arc::new(sources);
        let unit = Unit {
            sources: &sources,
            files: &files,
            stage: Stage::Fragment,
            dialect,
            infer_channels: true,
            wholeness: Wholeness::Whole,
        };
        let mut read = preprocess(&sources, &files, true);
        let options = ParseOptions {
            version: read.version,
            is_fragment: true,
        };
        let search = &mut Search::for_text();
        let parse = parse(&sources, &mut read.tokens, &read.names, options, search);
        let parsed = Parsed {
            sources: Arc::clone(&sources),
            tokens: read.tokens,
            names: read.names,
            tree: parse.tree,
            version: read.version,
            has_errors: true,
            enough,
        };
        judge(parsed, &unit, search).1.len()
    }

    #[test]
    fn a_count_that_ends_early_tells_whether_there_are_fewer() {
        let heads = [
            "",
            // Their uses tell that they are a `vec2` each.
            "float v = p; v.x += 1.0; v.y += v.x; float w = p; w.x += 1.0; w.y += w.x;",
            // With a channel of three dimensions all but one are right.
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
