//! How much of a file ran.

use crate::play::FileCoverage;

/// How much of something ran.
#[derive(Clone, Copy, Default)]
pub struct Share {
    pub ran: usize,
    pub all: usize,
}

impl Share {
    pub fn of(counts: impl Iterator<Item = u64>) -> Share {
        counts.fold(Share::default(), |share, count| Share {
            ran: share.ran + usize::from(count > 0),
            all: share.all + 1,
        })
    }

    pub fn percent(self) -> f64 {
        match self.all {
            0 => 100.0,
            all => self.ran as f64 / all as f64 * 100.0,
        }
    }
}

/// Lines, branches and functions of a file.
pub fn shares(file: &FileCoverage) -> [Share; 3] {
    [
        Share::of(file.lines().into_values()),
        Share::of(file.branches.values().flatten().copied()),
        Share::of(file.functions.values().map(|f| file.calls(f))),
    ]
}
