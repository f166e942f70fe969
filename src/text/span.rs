//! Half-open ranges of bytes.

use serde::{Deserialize, Serialize};

/// A half-open range of bytes in the address space of one [`Sources`](super::Sources).
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug, Serialize, Deserialize,
)]
pub struct Span {
    /// Address of the first byte.
    pub start: u32,
    /// Address after the last byte; equal to `start` for a position between two characters.
    pub end: u32,
}

impl Span {
    /// The range `start..end`.
    pub const fn new(start: u32, end: u32) -> Span {
        Span { start, end }
    }

    /// The empty range at `offset`.
    pub const fn at(offset: u32) -> Span {
        Span {
            start: offset,
            end: offset,
        }
    }

    /// The smallest range that contains both.
    pub fn to(self, other: Span) -> Span {
        Span {
            start: self.start.min(other.start),
            end: self.end.max(other.end),
        }
    }

    /// The empty range at the start of this one.
    pub const fn before(self) -> Span {
        Span::at(self.start)
    }

    /// The empty range at the end of this one.
    pub const fn after(self) -> Span {
        Span::at(self.end)
    }

    /// Whether it contains no byte.
    pub const fn is_empty(self) -> bool {
        self.start >= self.end
    }

    /// Whether both overlap or are adjacent.
    pub const fn touches(self, other: Span) -> bool {
        self.start <= other.end && other.start <= self.end
    }

    /// Length in bytes.
    pub const fn len(self) -> u32 {
        self.end.saturating_sub(self.start)
    }

    /// Whether it contains `other`; ranges may share borders.
    pub const fn contains(self, other: Span) -> bool {
        self.start <= other.start && other.end <= self.end
    }
}
