//! Why a project is not run, and the words for it.

use shaderlint_exec::Refusal;
use std::fmt;

/// Why a project is not run.
#[derive(Clone, PartialEq, Debug)]
pub enum PlayProblem {
    /// A pass is refused by the browser, too.
    Errors {
        /// What it is called.
        pass: String,
    },
    /// Something in a pass cannot be run.
    Refused {
        /// What the pass is called.
        pass: String,
        /// What cannot be run, and where.
        refusal: Refusal,
    },
    /// A pass is a vertex shader that draws by itself.
    Vertices {
        /// What it is called.
        pass: String,
    },
    /// All that it draws into is larger than may be.
    TooLarge {
        /// How many texels that takes.
        texels: u64,
        /// How many there may be.
        most: u64,
    },
    /// A stand-in cannot be drawn.
    StandIn {
        /// What draws it.
        generator: &'static str,
    },
}

impl fmt::Display for PlayProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlayProblem::Errors { pass } => write!(f, "{pass}: the shader has errors"),
            PlayProblem::Refused { pass, refusal } => {
                write!(f, "{pass}: {} cannot be run", refusal.what)
            }
            PlayProblem::Vertices { pass } => {
                write!(f, "{pass}: a vertex shader cannot be run by itself")
            }
            PlayProblem::TooLarge { texels, most } => write!(
                f,
                "the passes draw into {texels} texels, and no more than {most} can be kept"
            ),
            PlayProblem::StandIn { generator } => {
                write!(f, "the stand-in `{generator}` cannot be drawn")
            }
        }
    }
}
