//! A word list with an index that is computed at compile time.

/// Index of a constant word list. `SLOTS` is a power of two, and at least twice the number of
/// words.
#[derive(Debug)]
pub struct WordIndex<const SLOTS: usize> {
    words: &'static [&'static str],
    /// Open addressing: indices into the list plus one, 0 for an empty slot.
    slots: [u16; SLOTS],
}

impl<const SLOTS: usize> WordIndex<SLOTS> {
    /// Builds an index of distinct words.
    #[expect(
        clippy::indexing_slicing,
        reason = "evaluated at compile time, where a failure is a compile error"
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

    /// Index of a word in the list.
    #[expect(
        clippy::indexing_slicing,
        reason = "the slot is a remainder of the length, and stored indices are valid"
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

/// Fowler-Noll-Vo hash.
#[expect(clippy::indexing_slicing, reason = "the loop stops at the length")]
const fn hash(bytes: &[u8]) -> usize {
    let mut hash: u32 = 0x811c_9dc5;
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u32).wrapping_mul(0x0100_0193);
        i += 1;
    }
    hash as usize
}

#[expect(clippy::indexing_slicing, reason = "both have the same length")]
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
    fn an_index_finds_exactly_its_words() {
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
