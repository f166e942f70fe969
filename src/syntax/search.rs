//! The bounded search for what an author meant.
//!
//! Some mistakes do not stand where the compiler stumbles: a bracket is missing somewhere, either a
//! declaration or its value has the wrong type, a macro's definition is what its calls are refused for,
//! a host may take a part in several ways. There the alternatives are tried: the shader is read or
//! checked under each of them, and the one with the fewest faults holds. All that is tried for one text
//! is paid from one budget, so that an answer never takes long, however much is wrong.

/// Tokens that the alternatives of one text may read and check, all in all.
const MAX_TOKENS: usize = 2_500_000;

/// What may still be tried for a text; by default nothing.
#[derive(Debug, Default)]
pub struct Search {
    /// In tokens.
    left: usize,
}

impl Search {
    /// The search for one text.
    pub fn for_text() -> Search {
        Search { left: MAX_TOKENS }
    }

    /// Whether nothing more may be tried.
    pub fn is_over(&self) -> bool {
        self.left == 0
    }

    /// Whether so many tokens more can be read; then they are paid.
    pub fn pays(&mut self, tokens: usize) -> bool {
        let left = self.left.checked_sub(tokens);
        self.left = left.unwrap_or(self.left);
        left.is_some()
    }

    /// Ends the search: nothing more is tried.
    pub fn give_up(&mut self) {
        self.left = 0;
    }

    /// Searches with so many tokens at most, which are part of what is left.
    pub fn within<T>(&mut self, most: usize, work: impl FnOnce(&mut Search) -> T) -> T {
        let given = self.left.min(most);
        let mut part = Search { left: given };
        let result = work(&mut part);
        self.left -= given - part.left;
        result
    }

    /// The alternative under which the fewest faults are found, fewer than `standing`; of several the
    /// first, and no other is tried once there are no more than `enough`. Each costs `tokens`.
    ///
    /// `faults` tells how many there are; it may stop counting at the number that it is given, and says
    /// `None` of an alternative that is out of the question.
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
    fn the_first_of_the_best_holds_and_ends_the_search() {
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
    fn all_is_paid_from_one_budget() {
        let mut all = search(100);
        let mut tried = 0;
        let count = |_: &mut Search, _: &i32, _| {
            tried += 1;
            None
        };
        all.within(35, |part| part.fewest((9, 0), 10, 0..9, count));
        assert_eq!((tried, all.left), (3, 70));
        // What is tried for an alternative is paid too.
        all.fewest((9, 0), 10, 0..2, |inner, _, _| {
            inner.pays(30);
            None
        });
        assert_eq!(all.left, 20);
        assert!(!all.pays(30));
    }
}
