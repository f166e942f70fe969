//! Writes to slices at indices that may be out of range: no layer below the command line panics.

/// Sets elements of a slice.
pub trait SetAt<T> {
    /// Sets the element at an index, if there is one.
    fn set_at(&mut self, index: usize, value: T);
}

impl<T> SetAt<T> for [T] {
    #[inline]
    fn set_at(&mut self, index: usize, value: T) {
        if let Some(slot) = self.get_mut(index) {
            *slot = value;
        }
    }
}
