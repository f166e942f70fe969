//! Bounded search over alternative interpretations of a text.
//!
//! The compiler often reports an error away from its cause: a bracket is missing earlier, either a
//! declaration or its initializer has the wrong type, a macro's definition is wrong rather than its
//! calls, or a host may complete a shader fragment in several ways. In these cases the alternatives
//! are parsed or checked, and the one with the fewest errors is chosen. All alternatives of a text
//! share one budget, which bounds the run time.

/// Total tokens that the alternatives of one text may parse and check.
const MAX_TOKENS: usize = 2_500_000;

/// Remaining budget of the search for one text; empty by default.
#[derive(Debug, Default)]
pub struct Search {
    /// Remaining tokens.
    left: usize,
}

impl Search {
    /// A search with the full budget for one text.
    pub fn for_text() -> Search {
        Search { left: MAX_TOKENS }
    }

    /// Whether the budget is exhausted.
    pub fn is_over(&self) -> bool {
        self.left == 0
    }

    /// Deducts this many tokens from the budget; false, without a deduction, if it is too small.
    pub fn pays(&mut self, tokens: usize) -> bool {
        let left = self.left.checked_sub(tokens);
        self.left = left.unwrap_or(self.left);
        left.is_some()
    }

    /// Ends the search by clearing the budget.
    pub fn give_up(&mut self) {
        self.left = 0;
    }

    /// Runs a search with at most this many tokens of the remaining budget.
    pub fn within<T>(&mut self, most: usize, work: impl FnOnce(&mut Search) -> T) -> T {
        let given = self.left.min(most);
        let mut part = Search { left: given };
        let result = work(&mut part);
        self.left -= given - part.left;
        result
    }

    /// The alternative with the fewest errors, if fewer than `standing`; the first of equals. Stops
    /// once there are at most `enough`. Each alternative costs `tokens`.
    ///
    /// `faults` counts the errors; it may stop counting at the number passed to it, and returns
    /// `None` for an alternative to reject.
    pub fn fewest<A>(
        &mut self,
        (standing, enough): (usize, usize),
        tokens: usize,
        alternatives: impl IntoIterator<Item = A>,
        mut faults: impl FnMut(&mut Search, &A, usize) -> Option<usize>,
    ) -> Option<(A, usize)> {
        let mut best = None;
        let mut fewest = standing;
        for alternative in alternatives {
            if fewest <= enough || !self.pays(tokens) {
                break;
            }
            match faults(self, &alternative, fewest) {
                Some(found) if found < fewest => {
                    fewest = found;
                    best = Some((alternative, found));
                }
                _ => {}
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(left: usize) -> Search {
        Search { left }
    }

    #[test]
    fn the_first_of_the_best_candidates_ends_the_search() {
        let mut tried = Vec::new();
        let found = search(100).fewest((5, 1), 10, [7, 3, 3, 1, 0], |_, &faults, _| {
            tried.push(faults);
            Some(faults)
        });
        assert_eq!(found, Some((1, 1)));
        assert_eq!(tried, [7, 3, 3, 1]);
        let none = search(100).fewest((5, 0), 10, [5, 9], |_, &faults, _| Some(faults));
        assert_eq!(none, None);
    }

    #[test]
    fn nested_searches_share_one_budget() {
        let mut all = search(100);
        let mut tried = 0;
        let count = |_: &mut Search, _: &i32, _| {
            tried += 1;
            None
        };
        all.within(35, |part| part.fewest((9, 0), 10, 0..9, count));
        assert_eq!((tried, all.left), (3, 70));
        // Work done for an alternative is deducted too.
        all.fewest((9, 0), 10, 0..2, |inner, _, _| {
            inner.pays(30);
            None
        });
        assert_eq!(all.left, 20);
        assert!(!all.pays(30));
    }
}
