//! Why a project cannot be run.

use shaderlint_exec::Refusal;
use std::fmt;

/// Why a project cannot be run.
#[derive(Clone, PartialEq, Debug)]
pub enum PlaybackProblem {
    /// A pass has compile errors.
    Errors {
        /// Title of the pass.
        pass: String,
    },
    /// A pass uses something that is not supported.
    Refused {
        /// Title of the pass.
        pass: String,
        /// The unsupported construct and its position.
        refusal: Refusal,
    },
    /// A pass draws with a vertex shader.
    Vertices {
        /// Title of the pass.
        pass: String,
    },
    /// The render targets are too large.
    TooLarge {
        /// Number of texels of all render targets.
        texels: u64,
        /// Maximum number of texels.
        most: u64,
    },
    /// A substitute cannot be drawn.
    StandIn {
        /// Name of the shader that draws it.
        generator: &'static str,
    },
}

impl fmt::Display for PlaybackProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlaybackProblem::Errors { pass } => write!(f, "{pass}: the shader has errors"),
            PlaybackProblem::Refused { pass, refusal } => {
                write!(f, "{pass}: unsupported: {}", refusal.what)
            }
            PlaybackProblem::Vertices { pass } => {
                write!(
                    f,
                    "{pass}: shaders that draw with a vertex shader are not supported"
                )
            }
            PlaybackProblem::TooLarge { texels, most } => write!(
                f,
                "the render targets have {texels} texels; the limit is {most}"
            ),
            PlaybackProblem::StandIn { generator } => {
                write!(f, "cannot draw the substitute `{generator}`")
            }
        }
    }
}
