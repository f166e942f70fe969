//! Many short lists in one allocation.

use shaderlint_text::SetAt;

/// Lists by index. Shaders have thousands of functions and variables with few uses each, so
/// separate lists would cost more than their contents.
#[derive(Debug)]
pub struct Lists<T> {
    /// Start of each list in `entries`, and the end of the last one.
    starts: Vec<u32>,
    entries: Vec<T>,
}

impl<T> Default for Lists<T> {
    fn default() -> Lists<T> {
        Lists {
            starts: Vec::new(),
            entries: Vec::new(),
        }
    }
}

impl<T: Copy> Lists<T> {
    /// Creates `count` lists from entries tagged with their list. Order within a list is preserved;
    /// entries with a list out of range are dropped.
    pub fn of(count: usize, all: impl Iterator<Item = (u32, T)> + Clone) -> Lists<T> {
        let mut starts = vec![0; count + 1];
        let mut first = None;
        for (list, entry) in all.clone() {
            if let Some(after) = starts.get_mut(list as usize + 1) {
                *after += 1;
                first = Some(entry);
            }
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let Some(filler) = first else {
            return Lists::default();
        };
        let mut entries = vec![filler; total as usize];
        let mut next = starts.clone();
        for (list, entry) in all.filter(|(list, _)| (*list as usize) < count) {
            if let Some(at) = next.get_mut(list as usize) {
                entries.set_at(*at as usize, entry);
                *at += 1;
            }
        }
        Lists { starts, entries }
    }

    /// The list with this index; empty if there is none.
    pub fn get(&self, index: u32) -> &[T] {
        let start = self.starts.get(index as usize).copied().unwrap_or(0);
        let end = self.starts.get(index as usize + 1).copied().unwrap_or(0);
        let range = start as usize..end as usize;
        self.entries.get(range).unwrap_or(&[])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_keep_their_order_in_each_list() {
        let entries = [(2, 'a'), (0, 'b'), (2, 'c'), (7, 'd')];
        let lists = Lists::of(4, entries.into_iter());
        let found: Vec<&[char]> = (0..5).map(|i| lists.get(i)).collect();
        let none: &[char] = &[];
        assert_eq!(found, [&['b'][..], none, &['a', 'c'], none, none]);
        assert_eq!(Lists::<char>::of(3, [].into_iter()).get(1), none);
    }
}
