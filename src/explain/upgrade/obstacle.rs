//! What keeps a shader from being converted.

use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Span;

/// The extension of several outputs.
pub(super) const DRAW_BUFFERS: &str = "GL_EXT_draw_buffers";

/// Why a shader is not converted.
#[derive(Clone, Debug)]
pub struct UpgradeObstacle {
    /// Where it is.
    pub span: Span,
    /// What it is.
    pub kind: ObstacleKind,
}

/// What keeps a shader from being converted.
#[derive(Clone, Debug)]
pub enum ObstacleKind {
    /// Part of the code is in another file.
    Included,
    /// The code depends on `__VERSION__`.
    VersionTest,
    /// The code depends on whether an extension is available.
    ExtensionTest(String),
    /// `gl_FragColor` is written to all draw buffers.
    Broadcast,
    /// An index of `gl_FragData` is unknown.
    OutputIndex,
    /// It is not known whether the built-in function or the one of the shader is called.
    UnknownCall,
    /// An initial value that is not constant cannot be moved to `main`.
    InitialValue,
    /// The converted shader has this error.
    Error(Box<Diagnostic>),
}

impl UpgradeObstacle {
    pub(super) fn at(span: Span, kind: ObstacleKind) -> UpgradeObstacle {
        UpgradeObstacle { span, kind }
    }

    /// Code in another file.
    pub fn included(span: Span) -> UpgradeObstacle {
        UpgradeObstacle::at(span, ObstacleKind::Included)
    }
}
