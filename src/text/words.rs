//! A list of words with an index that the compiler makes, so that a start costs nothing.

/// Finds words in a list that never changes. `SLOTS` is a power of two, at least twice the number
/// of words.
#[derive(Debug)]
pub struct WordIndex<const SLOTS: usize> {
    words: &'static [&'static str],
    /// Open addressing; places in the list plus one, 0 for an empty slot.
    slots: [u16; SLOTS],
}

impl<const SLOTS: usize> WordIndex<SLOTS> {
    /// An index of some words, of which no two are the same.
    #[expect(
        clippy::indexing_slicing,
        reason = "the compiler works it out, and would refuse"
    )]
    pub const fn new(words: &'static [&'static str]) -> Self {
        assert!(SLOTS.is_power_of_two() && words.len() * 2 <= SLOTS);
        let mut slots = [0; SLOTS];
        let mut i = 0;
        while i < words.len() {
            let mut slot = hash(words[i].as_bytes()) % SLOTS;
            while slots[slot] != 0 {
                slot = (slot + 1) % SLOTS;
            }
            i += 1;
            slots[slot] = i as u16;
        }
        WordIndex { words, slots }
    }

    /// Where a word stands in the list.
    #[expect(
        clippy::indexing_slicing,
        reason = "a remainder of the length is a place, and so is what the index holds"
    )]
    pub const fn find(&self, word: &str) -> Option<usize> {
        let word = word.as_bytes();
        let mut slot = hash(word) % SLOTS;
        while self.slots[slot] != 0 {
            let at = self.slots[slot] as usize - 1;
            if is_same(self.words[at].as_bytes(), word) {
                return Some(at);
            }
            slot = (slot + 1) % SLOTS;
        }
        None
    }
}

/// The hash of Fowler, Noll and Vo.
#[expect(clippy::indexing_slicing, reason = "the loop ends before the bytes")]
const fn hash(bytes: &[u8]) -> usize {
    let mut hash: u32 = 0x811c_9dc5;
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u32).wrapping_mul(0x0100_0193);
        i += 1;
    }
    hash as usize
}

#[expect(clippy::indexing_slicing, reason = "both are of one length")]
const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while a.len() == b.len() && i < a.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_found_and_no_other() {
        const WORDS: &[&str] = &["a", "ab", "b", "abc", ""];
        const INDEX: WordIndex<16> = WordIndex::new(WORDS);
        for (at, word) in WORDS.iter().enumerate() {
            assert_eq!(INDEX.find(word), Some(at));
        }
        for word in ["c", "ac", "abcd"] {
            assert_eq!(INDEX.find(word), None);
        }
    }
}
