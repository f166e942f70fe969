//! A checked pass in the languages of the other graphics interfaces: WGSL, SPIR-V, HLSL and MSL.
//!
//! [`lower`] is a fold over the regions of the middle form (`crate::ir`): its places are naga's
//! pointers, its operations naga's expressions, its control flow naga's statements. Samplers become
//! a texture and a way to sample it, and rows are turned, here alone. [`write`] has naga check the
//! outcome and write it. What naga has no words for is refused, with the place and the reason.
//!
//! The module that comes out has one entry point, `fragment_main`. All uniforms are members of one
//! struct at binding 0 of group 0; the sampler with number `n`, in the order of the text, is a
//! texture at binding `2n + 1` and a sampler at `2n + 2`.

mod body;
mod builtin;
mod call;
mod entry;
mod function;
mod global;
mod interface;
mod known;
mod lower;
mod matrix;
mod op;
mod place;
mod port;
mod region;
mod special;
mod stored;
mod texture;
mod types;
mod uniform;
mod write;

pub use interface::{BindSlot, Buffer, BufferMember, HostInterface, Port, Repeated, TexturePair};
pub use lower::{FirstRow, LowerOptions, Lowered, lower};
pub use write::{Output, TargetLanguage, write};

use super::{Composed, PassUnit, Project, Wrapper, credits};
use crate::diagnostic::Severity;
use crate::semantic::Pass;
use crate::text::Span;

/// A shader in another language.
#[derive(Clone, Debug)]
pub struct TranslatedShader {
    /// Its text, or its words in SPIR-V.
    pub text: Output,
    /// What a host must know of it.
    pub interface: HostInterface,
}

/// A pass in another language; `None` where it does not compile.
pub fn translate(
    project: &Project,
    composed: &Composed,
    unit: &PassUnit,
    language: TargetLanguage,
) -> Result<Option<TranslatedShader>, Refused> {
    let analysis = composed.analysis(unit);
    let is_error = |d: &crate::diagnostic::Diagnostic| d.severity == Severity::Error;
    if analysis.diagnostics.iter().any(is_error) {
        return Ok(None);
    }
    // What other passes read is found by the number of the row; only pictures are looked at.
    let origin = match (unit.kind, unit.wrapper) {
        (Pass::Image, _) | (_, Wrapper::Own) => FirstRow::Picture,
        _ => FirstRow::Row,
    };
    let options = LowerOptions {
        language,
        first_row: origin,
        vertex: None,
    };
    let lowered = lower(&analysis.program, options)?;
    let text = write(&lowered, &credits::lines(project))?;
    let interface = lowered.interface;
    Ok(Some(TranslatedShader { text, interface }))
}

/// Why a pass cannot be written in another language.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused {
    /// Where the reason stands; empty where it is the whole pass.
    pub span: Span,
    /// The reason.
    pub message: String,
}

impl Refused {
    fn new(span: Span, message: impl Into<String>) -> Refused {
        Refused {
            span,
            message: message.into(),
        }
    }
}

type Res<T> = Result<T, Refused>;
type Value = ::naga::Handle<::naga::Expression>;
