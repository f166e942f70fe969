//! Input of the analysis of one shader.

use super::builtins::Stage;
use super::dialect::Dialect;
use shaderlint_syntax::GlContext;
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// A shader to analyse.
pub struct Unit<'a> {
    /// All source files.
    pub sources: &'a Arc<Sources>,
    /// The files of the shader, in compilation order.
    pub files: &'a [FileId],
    /// Vertex or fragment.
    pub stage: Stage,
    /// Host that runs the shader.
    pub dialect: Dialect,
    /// The context that compiles it.
    pub context: GlContext,
    /// Whether the types of its channels are unknown and inferred from their uses.
    pub infer_channels: bool,
    /// How much of a shader the files contain.
    pub completeness: Completeness,
}

impl<'a> Unit<'a> {
    /// A complete shader for WebGL2 without a host.
    pub const fn complete(sources: &'a Arc<Sources>, files: &'a [FileId], stage: Stage) -> Self {
        Unit {
            sources,
            files,
            stage,
            dialect: Dialect::WebGl,
            context: GlContext::WEBGL2,
            infer_channels: false,
            completeness: Completeness::Complete,
        }
    }
}

/// How much of a shader a text contains.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Completeness {
    /// A complete shader.
    Complete,
    /// A shader fragment: other code may come before and after it.
    Chunk,
    /// A fragment that may be cut anywhere: other code may close its braces.
    Piece,
    /// A fragment with omissions inside.
    Excerpt,
}
