//! Between the corrections that the syntax allows, the one that means something: the shader is
//! checked with each of them, and the one that leaves the fewest errors is taken.

use super::checker::{Goal, Parsed};
use super::program::Program;
use super::unit::{Unit, judge};
use crate::diagnostic::Diagnostic;
use crate::syntax::{Choice, Correction, Name, ParseOptions, Token, parse_corrected};

/// Most times that one shader is checked for it.
const MAX_LOOKS: usize = 8;
/// Most tokens that are checked for it.
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

impl Corrected {
    /// Checks the shader, parsed with the first correction of each choice and with `syntax` wrong
    /// then, or with better ones. Returns all that is wrong with it, the syntax included.
    pub fn settle(
        &self,
        parsed: Parsed,
        syntax: Vec<Diagnostic>,
        unit: &Unit,
    ) -> (Program, Vec<Diagnostic>) {
        let mut found = with_syntax(syntax, judge(parsed, unit));
        let mistakes = self.choices.len();
        let mut looks = MAX_LOOKS.min(MAX_TOKENS / self.original.len().max(1));
        let mut made = vec![Some(0); mistakes];
        let mut fewest = found.1.len();
        let mut is_tried = false;
        for (i, choice) in self.choices.iter().enumerate() {
            let mut best = Some(0);
            let others = (1..choice.len()).map(Some).chain([None]);
            for other in others {
                if fewest <= mistakes || looks == 0 {
                    break;
                }
                looks -= 1;
                is_tried = true;
                set(&mut made, i, other);
                found = self.look(found.0, &made, unit, Goal::CountBelow(fewest));
                if found.1.len() < fewest {
                    fewest = found.1.len();
                    best = other;
                }
            }
            set(&mut made, i, best);
        }
        match is_tried {
            true => self.look(found.0, &made, unit, Goal::Tell),
            false => found,
        }
    }

    /// Reads and checks the shader again with other corrections.
    fn look(
        &self,
        program: Program,
        made: &[Option<usize>],
        unit: &Unit,
        goal: Goal,
    ) -> (Program, Vec<Diagnostic>) {
        let corrections: Vec<&Correction> = self
            .choices
            .iter()
            .zip(made)
            .filter_map(|(choice, made)| choice.get((*made)?))
            .collect();
        let mut parsed = program.into_parsed();
        parsed.tokens.tokens = self.original.clone();
        let parse = parse_corrected(
            &parsed.sources,
            &mut parsed.tokens,
            &parsed.names,
            self.options,
            &corrections,
        );
        parsed.goal = match goal {
            Goal::Tell => goal,
            // Those of the syntax count too.
            Goal::CountBelow(most) => {
                Goal::CountBelow(most.saturating_sub(parse.diagnostics.len()))
            }
        };
        parsed.tree = parse.tree;
        parsed.tree.lost.extend(&self.lost);
        with_syntax(parse.diagnostics, judge(parsed, unit))
    }
}

fn set(made: &mut [Option<usize>], at: usize, to: Option<usize>) {
    if let Some(slot) = made.get_mut(at) {
        *slot = to;
    }
}

fn with_syntax(
    mut syntax: Vec<Diagnostic>,
    (program, problems): (Program, Vec<Diagnostic>),
) -> (Program, Vec<Diagnostic>) {
    syntax.extend(problems);
    (program, syntax)
}
